//! Embree 3, by a driver in C++ beside this benchmark, which is compiled where Embree is installed.

use std::{
    fs::File,
    io::{self, BufRead as _, BufReader, BufWriter, Write as _},
    path::Path,
    process::{Child, ChildStdin, ChildStdout, Command, Stdio},
};

use tempfile::TempDir;

use super::{Failure, Given, Rival};

pub(super) struct Embree {
    /// Where the driver and its files are.
    folder: TempDir,
    driver: Child,
    /// Closed before the driver is waited for.
    questions: Option<ChildStdin>,
    replies: BufReader<ChildStdout>,
    bytes: Option<usize>,
}

impl Embree {
    pub(super) fn new(given: &Given) -> Result<Self, Failure> {
        if !Path::new("/usr/include/embree3/rtcore.h").exists()
            || Command::new("g++").arg("--version").output().is_err()
        {
            return Err("not installed: apt-get install libembree-dev g++".into());
        }
        Self::start(given).map_err(|error| error.to_string())
    }

    /// Compile the driver, write the triangles and the rays, and let it read them.
    fn start(given: &Given) -> io::Result<Self> {
        let folder = TempDir::new()?;
        let path = |name: &str| folder.path().join(name);
        let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("benches/embree.cpp");
        let mut compiler = Command::new("g++");
        compiler.args(["-std=c++17", "-O2", "-o"]).args([path("driver"), source]).arg("-lembree3");
        if !compiler.status()?.success() {
            return Err(io::Error::other("its driver cannot be compiled"));
        }
        write(given, File::create(path("given"))?)?;
        let mut driver = Command::new(path("driver"));
        let mut driver =
            driver.args([path("given"), path("answers")]).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn()?;
        let questions = driver.stdin.take();
        let replies = driver.stdout.take().ok_or_else(|| io::Error::other("its driver is mute"))?;
        Ok(Self { folder, driver, questions, replies: BufReader::new(replies), bytes: None })
    }

    /// Let the driver do something. Returns seconds and the bytes in use.
    fn ask(&mut self, word: &str) -> Result<(f64, usize), Failure> {
        let failure = || format!("Embree's driver does not answer '{word}'");
        let questions = self.questions.as_mut().ok_or_else(failure)?;
        writeln!(questions, "{word}").and_then(|()| questions.flush()).map_err(|_| failure())?;
        let mut line = String::new();
        self.replies.read_line(&mut line).map_err(|_| failure())?;
        let mut numbers = line.split_whitespace();
        let seconds = numbers.next().and_then(|n| n.parse().ok()).ok_or_else(failure)?;
        Ok((seconds, numbers.nth(1).and_then(|n| n.parse().ok()).unwrap_or_default()))
    }
}

/// The file that the driver reads: counts, triangles, rays.
fn write(given: &Given, file: File) -> io::Result<()> {
    let mut file = BufWriter::new(file);
    for count in [given.mesh.len(), given.rays.len()] {
        file.write_all(&u32::try_from(count).map_err(io::Error::other)?.to_le_bytes())?;
    }
    let corners = given.mesh.triangles().flat_map(|triangle| triangle.corners);
    let rays = given.rays.iter().flat_map(|cast| [cast.ray.origin, cast.ray.direction]);
    for number in corners.chain(rays).flat_map(|vector| vector.to_array()) {
        file.write_all(&number.to_le_bytes())?;
    }
    file.flush()
}

impl Rival for Embree {
    fn name(&self) -> &'static str {
        "Embree"
    }

    fn build(&mut self) -> Result<f64, Failure> {
        let (seconds, bytes) = self.ask("build")?;
        self.bytes = Some(bytes);
        Ok(seconds)
    }

    fn bytes(&self) -> Option<usize> {
        self.bytes
    }

    fn trace(&mut self) -> Result<f64, Failure> {
        Ok(self.ask("trace")?.0)
    }

    fn answers(&mut self) -> Result<Vec<f32>, Failure> {
        self.ask("write")?;
        let bytes = std::fs::read(self.folder.path().join("answers")).map_err(|error| error.to_string())?;
        Ok(bytes.as_chunks().0.iter().map(|number| f32::from_le_bytes(*number)).collect())
    }
}

impl Drop for Embree {
    fn drop(&mut self) {
        // Its input ends, and so does it.
        self.questions = None;
        let _ = self.driver.wait();
    }
}
