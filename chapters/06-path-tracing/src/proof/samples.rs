//! No sample of any picture is NaN, infinite or negative.

use common::{
    Stream, Vec2, parallel,
    picture::{FilmPoint, Settings},
};

use crate::CHAPTER;

/// 10⁵ samples over all pictures; 10⁸ in the long run. A sample of a sheet of panels is at least one path.
#[test]
fn every_sample_is_a_number_and_not_negative() {
    let all: usize = if super::long_run() { 100_000_000 } else { 100_000 };
    let mut settings = Settings::default();
    for picture in CHAPTER.pictures {
        if let Some(triangles) = picture.knobs.iter().find(|knob| knob.name == "triangles") {
            settings.values.set(triangles, if super::long_run() { 50_000.0 } else { 3000.0 });
        }
        let render = (picture.make)(&settings).unwrap();
        #[expect(clippy::cast_precision_loss)]
        let size = Vec2::new(picture.size.width() as f32, picture.size.height() as f32);
        let share = if picture.samples > 1 { 10 } else { 100 };
        let bad: u64 = parallel::map(64, |chunk| {
            let mut bad = 0;
            for i in 0..all / share / 64 {
                let mut random = Stream::new(67, chunk as u64, i as u64);
                let position = size * Vec2::new(random.uniform(), random.uniform());
                let sample = render.sample(FilmPoint { position, size }, &mut random);
                bad += u64::from(!(sample.is_finite() && sample.min_element() >= 0.0));
            }
            bad
        })
        .into_iter()
        .sum();
        assert_eq!(bad, 0, "{}", picture.name);
    }
}
