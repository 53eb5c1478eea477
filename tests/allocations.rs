//! No ray takes memory from the heap: the allocations of every picture of every chapter are counted while it is rendered.
//!
//! A program of its own, because the counter stands in for the allocator of the whole program.

#![allow(clippy::unwrap_used, reason = "in a test, helpers may fail too")]

use common::{
    Rgb, Stream, Vec2,
    film::{Film, Size},
    picture::{FilmPoint, Picture, Settings},
    renderer::{Plan, fill_tile},
    story::{Story, Told, Untold},
};

/// How often the heap was asked for memory while `run` ran in this thread.
fn allocations(run: impl FnOnce()) -> u64 {
    allocation_counter::measure(run).count_total
}

/// Of a small film.
const SIZE: Size = Size::of::<48, 32>();
/// Points of the film per picture, evenly spread.
const POINTS: [u16; 2] = [32, 18];

/// Every point once, with all the rays that its color needs.
fn points() -> impl Iterator<Item = FilmPoint> {
    let [columns, rows] = POINTS;
    let size = Vec2::new(columns.into(), rows.into());
    let at = move |i: u16| Vec2::new(f32::from(i % columns) + 0.5, f32::from(i / columns) + 0.5);
    (0..columns * rows).map(move |i| FilmPoint { position: at(i), size })
}

#[test]
fn no_ray_of_any_picture_takes_memory_from_the_heap() {
    let mut pictures = 0;
    for chapter in course::CHAPTERS {
        for Picture { name, make, .. } in chapter.pictures {
            let picture = make(&Settings::default()).unwrap();
            let mut sum = Rgb::ZERO;
            let count = allocations(|| {
                for (i, point) in (0..).zip(points()) {
                    sum += picture.sample(point, &mut Stream::new(1, i, 0));
                }
            });
            assert_eq!(count, 0, "{}/{name}: allocations of {} points", chapter.name, points().count());
            // Something was rendered indeed.
            assert!(sum.is_finite() && sum.max_element() > 0.0, "{}/{name}: {sum}", chapter.name);
            pictures += 1;
        }
    }
    assert!(pictures > 18);
}

/// A film keeps sums, not samples: many take as much memory as one.
#[test]
fn memory_does_not_grow_with_the_samples() {
    let path_tracing = course::CHAPTERS.iter().find(|chapter| chapter.name == "path-tracing").unwrap();
    let room = (path_tracing.picture("room").unwrap().make)(&Settings::default()).unwrap();
    let most_bytes = |samples| {
        let plan = Plan { samples, seed: 1, threads: 1 };
        let render = || {
            let mut film = Film::new(SIZE);
            film.tiles_mut().iter_mut().for_each(|tile| fill_tile(room.as_ref(), tile, SIZE, &plan, samples));
        };
        allocation_counter::measure(render).bytes_max
    };
    let one = most_bytes(1);
    assert!(one >= u64::from(SIZE.width() * SIZE.height()) * 12, "{one}");
    assert_eq!(most_bytes(64), one);
}

/// The counter counts: telling the story needs memory, and not telling it needs none.
#[test]
fn a_story_takes_memory_only_when_somebody_listens() {
    fn tell(story: &mut impl Story) {
        story.enter(|| format!("one {}", 1));
        story.tell(|| format!("two {}", 2));
        story.leave();
    }
    assert_eq!(allocations(|| tell(&mut Untold)), 0);
    assert!(allocations(|| tell(&mut Told::default())) >= 2);
    let chapter = course::CHAPTERS[0];
    let picture = (chapter.pictures[0].make)(&Settings::default()).unwrap();
    let point = points().nth(300).unwrap();
    let told = allocations(|| {
        picture.explain(point, &mut Stream::new(1, 0, 0), &mut Told::default());
    });
    assert!(told > 2, "{told}");
}
