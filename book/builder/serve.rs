//! The book on this machine, built again and loaded again whenever something changes that it is made of.

use std::{
    fs,
    io::{self, BufRead, BufReader, Read, Write},
    net::{Ipv4Addr, TcpListener, TcpStream},
    path::{Path, PathBuf},
    sync::{Arc, Mutex, PoisonError},
    thread,
    time::Duration,
};

use crate::{build, html::decode, watch::fingerprint};

/// How often the sources are looked at.
const PAUSE: Duration = Duration::from_millis(400);
/// How long a browser may take to ask.
const PATIENCE: Duration = Duration::from_secs(5);
/// The longest request that is read.
const LONGEST: u64 = 16 * 1024;

/// What the pages are told: how often the book was built, and what was wrong the last time.
#[derive(Clone, Default)]
struct News {
    version: u64,
    problem: String,
}

/// A book that can be asked for.
#[derive(Clone)]
struct Book {
    out: PathBuf,
    news: Arc<Mutex<News>>,
}

/// Listen on a port of this machine; nobody else can connect.
///
/// # Errors
/// The system's, if the port is taken.
pub fn listen(port: u16) -> io::Result<TcpListener> {
    TcpListener::bind((Ipv4Addr::LOCALHOST, port))
}

/// Build and serve the book until the program is ended; `report` is told of every build: what was wrong, if anything.
pub fn serve(root: &Path, out: &Path, listener: TcpListener, report: impl Fn(Option<&str>)) {
    let book = Book { out: out.to_owned(), news: Arc::default() };
    let answering = book.clone();
    thread::spawn(move || {
        for stream in listener.incoming().flatten() {
            let book = answering.clone();
            // A browser that goes away in the middle of an answer is no trouble.
            thread::spawn(move || drop(book.answer(&stream)));
        }
    });
    let mut built = None;
    loop {
        let now = fingerprint(root);
        if built != Some(now) {
            built = Some(now);
            let problem = build(root, out).err().map(|error| error.to_string());
            report(problem.as_deref());
            let mut news = book.news.lock().unwrap_or_else(PoisonError::into_inner);
            news.version += u64::from(problem.is_none());
            news.problem = problem.unwrap_or_default();
        }
        thread::sleep(PAUSE);
    }
}

impl Book {
    /// Answer one request.
    fn answer(&self, mut stream: &TcpStream) -> io::Result<()> {
        stream.set_read_timeout(Some(PATIENCE))?;
        let mut head = String::new();
        let mut reader = BufReader::new(stream.take(LONGEST));
        reader.read_line(&mut head)?;
        // The rest of the request says nothing that matters, but must be read before the answer.
        let mut line = String::from("first");
        while !line.trim().is_empty() {
            line.clear();
            reader.read_line(&mut line)?;
        }
        let mut words = head.split_whitespace();
        let (status, kind, body) = match (words.next(), words.next()) {
            (Some("GET"), Some(address)) => self.find(address),
            _ => ("405 Method Not Allowed", "text/plain", b"only GET".to_vec()),
        };
        write!(
            stream,
            "HTTP/1.1 {status}\r\nContent-Type: {kind}\r\nContent-Length: {}\r\nCache-Control: no-store\r\n\
             Connection: close\r\n\r\n",
            body.len()
        )?;
        stream.write_all(&body)?;
        stream.flush()
    }

    /// Status, kind and content for an address.
    fn find(&self, address: &str) -> (&'static str, &'static str, Vec<u8>) {
        let news = self.news.lock().unwrap_or_else(PoisonError::into_inner).clone();
        let address = decode(address.split(['?', '#']).next().unwrap_or(""));
        if address == "/version" {
            let text = format!("{}\n{}", news.version, news.problem);
            return ("200 OK", "text/plain; charset=utf-8", text.into_bytes());
        }
        let Some(path) = self.path(&address) else { return ("404 Not Found", "text/plain", b"not found".to_vec()) };
        let (status, path) =
            if path.is_file() { ("200 OK", path) } else { ("404 Not Found", self.out.join("404.html")) };
        let kind = kind(&path);
        match fs::read(&path) {
            Ok(page) if kind.starts_with("text/html") => (status, kind, with_script(&page, news.version)),
            Ok(content) => (status, kind, content),
            Err(_) => ("404 Not Found", "text/html; charset=utf-8", with_script(b"<p>not built yet</p>", 0)),
        }
    }

    /// The file of an address; `None` if it would lie outside the book.
    fn path(&self, address: &str) -> Option<PathBuf> {
        let mut path = self.out.clone();
        for part in address.split('/').filter(|part| !part.is_empty()) {
            if part.starts_with('.') || part.contains(['\\', ':', '\0']) {
                return None;
            }
            path.push(part);
        }
        Some(if address.ends_with('/') { path.join("index.html") } else { path })
    }
}

/// A page with the script that loads it again when there is news.
fn with_script(page: &[u8], version: u64) -> Vec<u8> {
    let script = format!("<script>const served = \"{version}\";\n{}</script>\n", include_str!("reload.js"));
    [page, script.as_bytes()].concat()
}

/// What kind of content a file has.
fn kind(path: &Path) -> &'static str {
    match path.extension().and_then(|extension| extension.to_str()) {
        Some("html") => "text/html; charset=utf-8",
        Some("css") => "text/css; charset=utf-8",
        Some("js") => "text/javascript; charset=utf-8",
        Some("json") => "application/json",
        Some("png") => "image/png",
        Some("svg") => "image/svg+xml",
        Some("woff2") => "font/woff2",
        Some("wasm") => "application/wasm",
        Some("txt" | "md") => "text/plain; charset=utf-8",
        _ => "application/octet-stream",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn book(out: &Path) -> Book {
        Book { out: out.to_owned(), news: Arc::default() }
    }

    #[test]
    fn files_are_found_inside_the_book_only() {
        let folder = tempfile::tempdir().unwrap();
        fs::create_dir(folder.path().join("book")).unwrap();
        fs::write(folder.path().join("secret.txt"), "secret").unwrap();
        fs::write(folder.path().join("book/index.html"), "<p>hello").unwrap();
        let book = book(&folder.path().join("book"));
        let (status, kind, body) = book.find("/?x#y");
        assert_eq!((status, kind), ("200 OK", "text/html; charset=utf-8"));
        assert!(body.starts_with(b"<p>hello<script>"));
        for address in ["/../secret.txt", "/%2e%2e/secret.txt", "/..%2fsecret.txt", "/..\\secret.txt", "//etc/passwd"] {
            assert_eq!(book.find(address).0, "404 Not Found", "{address}");
        }
        assert_eq!(book.find("/version").2, b"0\n");
    }

    #[test]
    fn a_browser_gets_an_answer() {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("a.css"), "b {}").unwrap();
        let listener = listen(0).unwrap();
        let address = listener.local_addr().unwrap();
        let book = book(folder.path());
        let server = thread::spawn(move || book.answer(&listener.accept().unwrap().0));
        let mut stream = TcpStream::connect(address).unwrap();
        stream.write_all(b"GET /a.css HTTP/1.1\r\nHost: x\r\n\r\n").unwrap();
        let mut answer = String::new();
        stream.read_to_string(&mut answer).unwrap();
        server.join().unwrap().unwrap();
        assert!(answer.starts_with("HTTP/1.1 200 OK\r\n") && answer.ends_with("\r\n\r\nb {}"), "{answer}");
    }
}
