//! The numbers of chapter 6.

#![expect(clippy::disallowed_methods, reason = "f64 has digits to spare: its last bits do not matter here")]

use std::{cell::Cell as Flag, ops::RangeInclusive, sync::Arc};

use common::{
    Rgb, Stream, Vec2, Vec3,
    color::luminance,
    film::{Film, Size},
    parallel,
    picture::{FilmPoint, Settings},
    renderer::{Plan, render},
    story::Untold,
};
use path_tracing::{
    CHAPTER,
    experiments::{
        coat, cornell_box,
        furnace::{self, Cell, Glow},
        honest,
        mistakes::{self, no_clamp},
        reference::{self, Comparison, Reference},
        slope,
    },
    importance::step,
    material::Material,
    method::Method,
    path_tracer::PathTracer,
    pictures::{courtyard, room, steps},
    probe::RayCounts,
    roulette::Chances,
};
use ray_casting::{hit::Hit, ray::Ray};
use sampling::{estimate::Estimate, sky_light::Choice, slope::log_log_slope};
use shadows::{offset::Offset, shadow_ray::is_in_shadow};
use space_partitioning::choice::Choice as Structure;

use super::{Numbers, figures, signed};

/// Samples of a row of the table of outsiders, and how many there are of the longest of them.
const COUNTS: [usize; 4] = [16, 64, 256, 1024];
const RUNS: u64 = 200;
/// Samples of the comparison with another program.
const REFERENCE_SAMPLES: u32 = 256;

/// A share in per cent with so many decimals.
fn percent(share: f64, decimals: usize) -> String {
    format!("{:.decimals$} %", 100.0 * share)
}

pub(super) fn measured() -> String {
    let mut numbers =
        Numbers::titled("Numbers in the text of chapter 6, made by tests/course/numbers/path_tracing.rs.");
    let room = View::new(room::tracer(Method::BEST, &Settings::default()).unwrap(), room_size());
    finding_the_lamp(&mut numbers);
    steps_compared(&mut numbers);
    red_wall(&mut numbers);
    bounces(&mut numbers, &room);
    errors(&mut numbers);
    outsiders(&mut numbers);
    furnaces(&mut numbers);
    references(&mut numbers);
    rays(&mut numbers, &room);
    numbers.0
}

/// A picture's rays: those through the centers of some pixels, evenly spread over the film.
struct View {
    tracer: PathTracer,
    rays: Vec<Ray>,
}

fn room_size() -> Size {
    CHAPTER.picture("room").unwrap().size
}

impl View {
    /// Every 12th pixel of each row and column.
    fn new(tracer: PathTracer, size: Size) -> Self {
        const STEP: usize = 12;
        let at = |i: u32| i as f32 + 0.5;
        let [width, height] = [size.width(), size.height()];
        let film = Vec2::new(width as f32, height as f32);
        let points = (0..height).step_by(STEP).flat_map(|y| (0..width).step_by(STEP).map(move |x| [x, y].map(at)));
        let ray = |point: [f32; 2]| tracer.camera.ray(FilmPoint { position: point.into(), size: film });
        let rays = points.map(ray).collect();
        Self { tracer, rays }
    }

    /// The room, seen by a method.
    fn of_room(method: Method) -> Self {
        Self::new(room::tracer(method, &Settings::default()).unwrap(), room_size())
    }

    /// The same view with only the rays that first hit something matte.
    fn matte(mut self) -> Self {
        let Self { tracer, rays } = &mut self;
        rays.retain(|ray| {
            tracer.world.intersect(ray).is_some_and(|(_, surface)| surface.material.diffuse != Rgb::ZERO)
        });
        self
    }

    /// The same view by another method. The lamp stays as it is.
    fn by(&self, method: Method) -> PathTracer {
        PathTracer { world: Arc::clone(&self.tracer.world), camera: self.tracer.camera, method }
    }

    /// An estimate for each ray.
    fn estimates(&self, samples: u64, seed: u64, one: impl Fn(Ray, &mut Stream) -> f64 + Sync) -> Vec<Estimate> {
        parallel::map(self.rays.len(), |i| {
            let mut estimate = Estimate::default();
            for sample in 0..samples {
                estimate.add(one(self.rays[i], &mut Stream::new(seed, i as u64, sample)));
            }
            estimate
        })
    }

    /// The mean brightness by a method.
    fn light(&self, method: Method, samples: u64) -> f64 {
        let tracer = self.by(method);
        mean(&self.estimates(samples, 71, |ray, random| luminance(tracer.trace(ray, random, &mut Untold)).into()))
    }

    /// The mean numbers of path rays and of shadow rays of a sample.
    fn ray_counts(&self, samples: u64) -> [f64; 2] {
        let counts = parallel::map(self.rays.len(), |i| {
            let mut counts = RayCounts::default();
            for sample in 0..samples {
                self.tracer.trace(self.rays[i], &mut Stream::new(72, i as u64, sample), &mut counts);
            }
            [counts.path_rays, counts.shadow_rays]
        });
        let all = samples as f64 * self.rays.len() as f64;
        [0, 1].map(|kind| counts.iter().map(|counts| counts[kind]).sum::<u64>() as f64 / all)
    }
}

/// The mean of means.
fn mean(estimates: &[Estimate]) -> f64 {
    estimates.iter().map(Estimate::mean).sum::<f64>() / estimates.len() as f64
}

/// One sample in the room with the glowing lamp: its brightness, and whether its path has met the lamp.
fn look_for_lamp(tracer: &PathTracer, ray: Ray, random: &mut Stream) -> (f64, bool) {
    let lamp = tracer.world.scene().objects.iter().find(|object| object.name == "lamp");
    let lamp = lamp.and_then(|object| object.material).unwrap().emission;
    let found = Flag::new(false);
    let next = |material: &Material, hit: &Hit, to_viewer: Vec3, random: &mut Stream, probe: &mut Untold| {
        found.set(found.get() || material.emission == lamp);
        step(&tracer.method, material, hit, to_viewer, random, probe)
    };
    let radiance = tracer.walk(ray, random, &mut Untold, next);
    (luminance(radiance).into(), found.get())
}

fn finding_the_lamp(numbers: &mut Numbers) {
    numbers.about("The share of plain walks that meet the glowing lamp of the room at one of 10 bounces.");
    let [plain, ..] = steps::methods();
    // Who goes one bounce further is asked for a step at the tenth, too.
    let further = *plain.bounces.end() + 1;
    let view = View::of_room(Method { bounces: 0..=further, ..plain }).matte();
    let found = view.estimates(64, 73, |ray, random| f64::from(look_for_lamp(&view.tracer, ray, random).1));
    numbers.pin("walks-that-find-the-lamp", percent(mean(&found), 1));
}

fn steps_compared(numbers: &mut Numbers) {
    numbers.about(
        "One sample of a pixel of the room that shows something matte: variance, path and shadow rays, and the\n\
         # product of both.",
    );
    let (mut variances, mut costs) = (Vec::new(), Vec::new());
    for (name, method) in ["walk", "direct", "important", "roulette"].into_iter().zip(steps::methods()) {
        // Rare bright paths make the first and the last uncertain.
        let samples = if matches!(name, "walk" | "roulette") { 128 } else { 32 };
        let view = View::of_room(method).matte();
        let brightness = |ray, random: &mut Stream| luminance(view.tracer.trace(ray, random, &mut Untold)).into();
        let pixels = view.estimates(samples, 74, brightness);
        let variance = pixels.iter().map(Estimate::variance).sum::<f64>() / pixels.len() as f64;
        let rays: f64 = view.ray_counts(8).into_iter().sum();
        numbers.pin(&format!("variance-{name}"), figures(variance));
        numbers.pin(&format!("rays-{name}"), figures(rays));
        numbers.pin(&format!("cost-{name}"), figures(variance * rays));
        variances.push(variance);
        costs.push(variance * rays);
    }
    numbers.pin("gain-of-asking", figures(variances[0] / variances[1]));
    numbers.pin("gain-of-all", figures(costs[0] / costs[3]));
}

fn red_wall(numbers: &mut Numbers) {
    numbers.about("The red wall of the room: the chance of a diffuse step, and its weight in red.");
    let tracer = room::tracer(Method::BEST, &Settings::default()).unwrap();
    let (_, wall) = tracer.world.intersect(&Ray::new(tracer.camera.eye(), -Vec3::X)).unwrap();
    assert_eq!(wall.name, "left wall");
    let albedo = wall.material.albedo();
    let chance = Chances::of(albedo, Rgb::ZERO).diffuse;
    numbers.pin("red-chance", figures(chance.into()));
    numbers.pin("red-weight", figures((albedo.x / chance).into()));
}

fn bounces(numbers: &mut Numbers, room: &View) {
    numbers.about("The light of the room by its number of bounces, without that of 0 bounces.");
    let most = Method::MOST_BOUNCES;
    let of = |bounces: RangeInclusive<u32>| {
        let roulette = *bounces.end() == most;
        room.light(Method { bounces, roulette, ..Method::BEST }, 32)
    };
    let light = [of(1..=1), of(2..=2), of(3..=3), of(4..=most)];
    let all: f64 = light.iter().sum();
    for (name, light) in ["1", "2", "3", "more"].into_iter().zip(light) {
        numbers.pin(&format!("share-{name}"), percent(light / all, 0));
    }
    numbers.pin("share-missed", percent(1.0 - light[0] / all, 0));
}

fn errors(numbers: &mut Numbers) {
    numbers.about("Half a furnace: the slope of the error over 1 to 4096 samples.");
    let slope = log_log_slope(&slope::measure(256).unwrap()).unwrap();
    numbers.pin("slope", signed(slope));
    numbers.about("The share of pixels of a ball under the sky that are within 3σ of the truth.");
    let pixels = honest::measure(1000).unwrap();
    numbers.pin("inside-three-sigma", percent(f64::from(pixels.inside) / f64::from(pixels.all), 1));
    numbers.about("The film's own error of the room; and how many samples make it 1 %.");
    let picture = CHAPTER.picture("room").unwrap();
    let room = (picture.make)(&Settings::default()).unwrap();
    let mut film = Film::new(picture.size.scaled_to(240));
    render(room.as_ref(), &mut film, &Plan { samples: picture.samples, seed: 0, threads: 0 }, &());
    let error = film.relative_error().unwrap();
    numbers.pin("room-samples", picture.samples);
    numbers.pin("room-error", percent(error, 0));
    numbers.pin("room-samples-for-one-percent", figures(f64::from(picture.samples) * (100.0 * error).powi(2)));
}

fn outsiders(numbers: &mut Numbers) {
    numbers.about(
        "Pixels of the room's floor that see the lamp: the share of means of M samples that are off by more than\n\
         # three of their own standard errors, with the lamp as a point and as a ball.",
    );
    let mut floor = View::of_room(Method::BEST);
    let View { tracer, rays } = &mut floor;
    let scene = tracer.world.scene();
    rays.retain(|ray| {
        tracer.world.intersect(ray).is_some_and(|(hit, surface)| {
            let light = scene.lights[0].illuminate(hit.position);
            surface.name == "floor" && !is_in_shadow(scene, &hit, &light, Offset::Following)
        })
    });
    // A few of them, from all over the floor.
    let few = rays.len() / 16;
    let rays: Vec<Ray> = rays.iter().copied().step_by(few).collect();
    let asked = |ray, random: &mut Stream| luminance(tracer.trace(ray, random, &mut Untold)).into();
    pin_outsiders(numbers, "asked", &rays, asked);
    let found = room::tracer(Method { direct: false, ..Method::BEST }, &Settings::default()).unwrap();
    pin_outsiders(numbers, "found", &rays, |ray, random| look_for_lamp(&found, ray, random).0);
    numbers.about("There with the lamp as a ball: how many paths meet it; how much brighter they are than the others.");
    let view = View { tracer: found, rays };
    let look = |is_found: bool| {
        let tracer = &view.tracer;
        mean(&view.estimates(10_000, 75, |ray, random| {
            let (brightness, found) = look_for_lamp(tracer, ray, random);
            if found == is_found { brightness } else { 0.0 }
        }))
    };
    let share = mean(&view.estimates(10_000, 75, |ray, random| f64::from(look_for_lamp(&view.tracer, ray, random).1)));
    let [with, without] = [look(true) / share, look(false) / (1.0 - share)];
    numbers.pin("floor-paths-that-find-the-lamp", percent(share, 2));
    numbers.pin("floor-times-brighter", figures(with / without));
}

/// Estimate each pixel again and again, and count the means that are off by more than 3σ.
fn pin_outsiders(numbers: &mut Numbers, name: &str, rays: &[Ray], one: impl Fn(Ray, &mut Stream) -> f64 + Sync) {
    const MOST: usize = COUNTS[COUNTS.len() - 1];
    let outside = parallel::map(rays.len(), |pixel| {
        // For each number of samples the estimates of all groups of so many, one after the other.
        let mut groups: [Vec<Estimate>; COUNTS.len()] = Default::default();
        let mut all = Estimate::default();
        for run in 0..RUNS {
            let mut random = Stream::new(76, pixel as u64, run);
            let samples: Vec<f64> = (0..MOST).map(|_| one(rays[pixel], &mut random)).collect();
            let estimate = |samples: &[f64]| {
                let mut estimate = Estimate::default();
                samples.iter().for_each(|sample| estimate.add(*sample));
                estimate
            };
            for (groups, count) in groups.iter_mut().zip(COUNTS) {
                groups.extend(samples.chunks(count).map(estimate));
            }
            all = all.merge(estimate(&samples));
        }
        // The truth is the mean of all of them.
        let is_outside = |estimate: &&Estimate| (estimate.mean() - all.mean()).abs() > estimate.three_sigma();
        groups.map(|groups| groups.iter().filter(is_outside).count() as f64 / groups.len() as f64)
    });
    for (i, count) in COUNTS.into_iter().enumerate() {
        let share = outside.iter().map(|shares| shares[i]).sum::<f64>() / rays.len() as f64;
        numbers.pin(&format!("outside-{name}-{count}"), percent(share, usize::from(share < 0.1)));
    }
}

fn furnaces(numbers: &mut Numbers) {
    numbers.about("The dark half of half a furnace: on paper, and measured with three standard errors.");
    for albedo in [0.5, 0.8] {
        let cell = Cell { albedo, choice: Choice::Uniform, roulette: true };
        numbers.pin(&format!("half-{:.0}", 100.0 * albedo), format!("{:.3}", cell.expected(Glow::Half)));
    }
    for cell in furnace::cells() {
        let estimate = furnace::measure(cell, Glow::Half, furnace::traced).unwrap();
        let directions = if cell.choice == Choice::Uniform { "uniform" } else { "cosine" };
        let roulette = if cell.roulette { "on" } else { "off" };
        let name = format!("half-{:.0}-{directions}-{roulette}", 100.0 * cell.albedo);
        numbers.pin(&name, format!("{:.3}", estimate.mean()));
        numbers.pin(&format!("{name}-3-sigma"), format!("{:.3}", estimate.three_sigma()));
    }
    numbers.about("What a furnace reads whose roulette survives with a probability above one.");
    let cell = Cell { albedo: 0.8, choice: Choice::Uniform, roulette: true };
    let wrong = furnace::measure(cell, Glow::Whole, mistakes::path(no_clamp)).unwrap();
    numbers.pin("no-clamp", figures(wrong.mean()));
    numbers.about("A ball with a clear coat: G for the index 1.5, and the greatest albedo that makes sense.");
    let g = coat::gathered(1.5);
    numbers.pin("coat-g", format!("{g:.3}"));
    numbers.pin("coat-limit", format!("{:.3}", 1.0 / g));
}

fn references(numbers: &mut Numbers) {
    numbers.about(
        "Differences from Mitsuba's pictures: of the mean, the worst channel; of blocks of 8×8 pixels, the median,\n\
         # also in standard errors of our own.",
    );
    numbers.pin("reference-samples", REFERENCE_SAMPLES);
    for (name, scene) in [("blocks", Reference::Boxes), ("gold", Reference::Gold)] {
        let film = reference::film(&scene.tracer().unwrap(), REFERENCE_SAMPLES);
        let comparison = Comparison::of(&film, scene);
        let [median, by_noise] = comparison.medians();
        numbers.pin(&format!("reference-{name}-mean"), percent(comparison.mean.max_element().into(), 2));
        numbers.pin(&format!("reference-{name}-median"), percent(median.into(), 1));
        numbers.pin(&format!("reference-{name}-by-noise"), format!("{by_noise:.2}"));
    }
}

fn rays(numbers: &mut Numbers, room: &View) {
    let size = CHAPTER.picture("courtyard").unwrap().size;
    let court = View::new(courtyard::tracer(&Settings::default()).unwrap(), size);
    numbers.about("Rays of a sample.");
    for (name, view) in [("room", room), ("court", &court)] {
        let [path, shadow] = view.ray_counts(8).map(figures);
        numbers.pin(&format!("{name}-path-rays"), path);
        numbers.pin(&format!("{name}-shadow-rays"), shadow);
    }
    numbers.about("The box of the references: its triangles, and how many of them a ray tests.");
    numbers.pin("box-triangles", cornell_box::mesh(true).mesh.triangles.len().to_string());
    numbers.pin("box-kd-tree-tests", figures(cornell_box::tests_per_ray(Structure::KdTree).unwrap()));
    numbers.pin("box-eight-at-once-tests", figures(cornell_box::tests_per_ray(Structure::EightAtOnce).unwrap()));
    numbers.about("The share of the light of the court that has more bounces than its picture.");
    let most = court.tracer.method.bounces.end() + 1;
    let missing = court.light(Method { bounces: most..=Method::MOST_BOUNCES, ..Method::BEST }, 32);
    numbers.pin("court-missing", percent(missing / court.light(Method::BEST, 32), 1));
}
