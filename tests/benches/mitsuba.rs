//! The path tracer beside Mitsuba 3, in one run on the same box: `cargo bench -p tests --bench mitsuba`.
//!
//! Mitsuba is optional: `pip install mitsuba numpy`, and if Python has another name than `python3`, say it by the
//! environment variable `PYTHON`. Without it the course is measured alone. Compare numbers of one run only.

use std::{
    env,
    io::{BufRead as _, BufReader, Lines, Write as _},
    process::{Child, ChildStdin, ChildStdout, Command, Stdio},
    time::Instant,
};

use common::{
    Rgb, Vec3,
    film::{Film, Size},
    parallel,
    renderer::{Plan, render},
};
use path_tracing::{
    experiments::cornell_box::{self, AIM, EYE, FIELD_OF_VIEW, LAMP},
    method::Method,
};

/// Everybody renders this.
const SIZE: Size = Size::of::<256, 256>();
const SAMPLES: u32 = 64;
/// Mitsuba calls it a depth of 8: the light of the lamp, reflected up to seven times.
const BOUNCES: u32 = 7;
/// Each program's turn comes so often, one after the other; the median counts.
const ROUNDS: usize = 5;

/// One rendering: how long it took, in seconds, and the mean of the picture.
#[derive(Clone, Copy)]
struct Run {
    seconds: f64,
    mean: Rgb,
}

/// A Python program that renders whenever it is asked.
struct Mitsuba {
    child: Child,
    asked: ChildStdin,
    answers: Lines<BufReader<ChildStdout>>,
}

impl Mitsuba {
    /// Start it in one of its variants, and let it build the scene.
    fn start(variant: &str) -> Option<Self> {
        let python = env::var("PYTHON").unwrap_or_else(|_| "python3".into());
        let script = concat!(env!("CARGO_MANIFEST_DIR"), "/benches/render_box.py");
        let mut command = Command::new(python);
        command.args([script, variant]).stdin(Stdio::piped()).stdout(Stdio::piped());
        let mut child = command.spawn().ok()?;
        let (mut asked, answers) = (child.stdin.take()?, BufReader::new(child.stdout.take()?).lines());
        let mut mitsuba = writeln!(asked, "{}", scene()).ok().map(|()| Self { child, asked, answers })?;
        // Its first picture takes longer: it compiles.
        mitsuba.render(true)?;
        Some(mitsuba)
    }

    /// Render once, with its roulette or without one.
    fn render(&mut self, roulette: bool) -> Option<Run> {
        writeln!(self.asked, "{}", u8::from(roulette)).ok()?;
        let line = self.answers.next()?.ok()?;
        let mut numbers = line.split(' ').map_while(|word| word.parse::<f64>().ok());
        let seconds = numbers.next()?;
        #[expect(clippy::cast_possible_truncation, reason = "a color")]
        let [r, g, b] = [numbers.next()?, numbers.next()?, numbers.next()?].map(|x| x as f32);
        Some(Run { seconds, mean: Rgb::new(r, g, b) })
    }
}

impl Drop for Mitsuba {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// The box as JSON: numbers, and nothing that would have to be escaped.
fn scene() -> String {
    let builder = cornell_box::mesh(true);
    let triangles = &builder.mesh.triangles;
    let ends = builder.parts.iter().skip(1).map(|part| part.first as usize).chain([triangles.len()]);
    let parts: Vec<_> = (builder.parts.iter().zip(ends))
        .map(|(part, end)| {
            let albedo = (part.material.diffuse * std::f32::consts::PI).to_array();
            format!(r#"{{"albedo": {albedo:?}, "triangles": {:?}}}"#, &triangles[part.first as usize..end])
        })
        .collect();
    let positions: Vec<_> = builder.mesh.positions.iter().map(Vec3::to_array).collect();
    format!(
        r#"{{"eye": {:?}, "aim": {:?}, "field_of_view": {FIELD_OF_VIEW:?}, "lamp": {:?}, "intensity": {:?}, "width": {}, "height": {}, "samples": {SAMPLES}, "depth": {}, "positions": {positions:?}, "parts": [{}]}}"#,
        EYE.to_array(),
        AIM.to_array(),
        LAMP.position.to_array(),
        LAMP.intensity.to_array(),
        SIZE.width(),
        SIZE.height(),
        BOUNCES + 1,
        parts.join(", ")
    )
}

/// Our own rendering on so many threads.
fn render_here(roulette: bool, threads: usize) -> Option<Run> {
    let tracer = cornell_box::tracer(true, Method { roulette, bounces: 0..=BOUNCES, ..Method::BEST }).ok()?;
    let mut film = Film::new(SIZE);
    let start = Instant::now();
    render(&tracer, &mut film, &Plan { samples: SAMPLES, seed: 0, threads }, &());
    let seconds = start.elapsed().as_secs_f64();
    let pixels = film.linear();
    #[expect(clippy::cast_precision_loss, reason = "65,536 pixels")]
    let mean = pixels.iter().sum::<Rgb>() / pixels.len() as f32;
    Some(Run { seconds, mean })
}

/// The median of all rounds.
fn median(runs: &[Run]) -> f64 {
    let mut seconds: Vec<_> = runs.iter().map(|run| run.seconds).collect();
    seconds.sort_by(f64::total_cmp);
    seconds[seconds.len() / 2]
}

/// Measure everybody with roulette or without, and print a table.
fn compare(roulette: bool, others: &mut [(&str, Mitsuba)]) -> Option<()> {
    let names = ["the course", "the course, one thread"].into_iter().chain(others.iter().map(|(name, _)| *name));
    let mut table: Vec<_> = names.map(|name| (name, Vec::new())).collect();
    for _ in 0..ROUNDS {
        table[0].1.push(render_here(roulette, 0)?);
        table[1].1.push(render_here(roulette, 1)?);
        for ((_, mitsuba), (_, runs)) in others.iter_mut().zip(&mut table[2..]) {
            runs.push(mitsuba.render(roulette)?);
        }
    }
    println!("\n{}", if roulette { "Each with its own roulette" } else { "Without roulette" });
    let paths = f64::from(SIZE.width() * SIZE.height() * SAMPLES) / 1e6;
    let ours = median(&table[0].1);
    for (name, runs) in &table {
        let seconds = median(runs);
        let [rate, ratio, mean] = [paths / seconds, seconds / ours, f64::from(runs[0].mean.y)];
        println!("{name:24} {seconds:6.2} s  {rate:6.3} million paths/s  {ratio:5.2} times our time  mean {mean:.4}");
    }
    Some(())
}

fn main() {
    println!(
        "The box, {}x{} pixels, {SAMPLES} samples, at most {BOUNCES} bounces, {} threads, medians of {ROUNDS} rounds",
        SIZE.width(),
        SIZE.height(),
        parallel::threads()
    );
    let variants = ["scalar_rgb", "llvm_ad_rgb"];
    let mut others: Vec<_> = variants.into_iter().filter_map(|name| Some((name, Mitsuba::start(name)?))).collect();
    if others.len() < variants.len() {
        println!(
            "Mitsuba 3 is missing, or a variant of it: `pip install mitsuba numpy`, and PYTHON=... if it is elsewhere."
        );
    }
    for roulette in [true, false] {
        if compare(roulette, &mut others).is_none() {
            println!("A rendering was not answered.");
        }
    }
}
