//! Polylines: cut into dashes, and with rounded corners.

use glam::Vec2;

use crate::float;

/// The dashes of a line: `[dash, gap]`, over and over, along its length. A dash may go around corners.
pub(super) fn dashed(points: &[Vec2], [dash, gap]: [f32; 2]) -> Vec<Vec<Vec2>> {
    /// More than this and they would be a gray line.
    const MOST: f32 = 1e4;

    // Without a length to go on, it is one whole line.
    let length: f32 = points.windows(2).map(|ends| ends[0].distance(ends[1])).sum();
    let goes_on = dash > 0.0 && gap > 0.0 && length < MOST * (dash + gap);
    let (Some(&first), true) = (points.first(), goes_on) else { return vec![points.to_vec()] };
    let mut dashes = vec![vec![first]];
    let (mut is_dash, mut left) = (true, dash);
    for ends in points.windows(2) {
        let (from, to) = (ends[0], ends[1]);
        let length = from.distance(to);
        let mut done = 0.0;
        // Each change between dash and gap on this piece.
        while left < length - done {
            done += left;
            let place = from.lerp(to, done / length);
            if is_dash {
                dashes.last_mut().into_iter().for_each(|d| d.push(place));
            } else {
                dashes.push(vec![place]);
            }
            is_dash = !is_dash;
            left = if is_dash { dash } else { gap };
        }
        left -= length - done;
        if is_dash {
            dashes.last_mut().into_iter().for_each(|d| d.push(to));
        }
    }
    dashes.iter_mut().for_each(Vec::dedup);
    dashes
}

/// A corner of a line, sharp or round.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Corner {
    pub(super) place: Vec2,
    pub(super) is_round: bool,
}

/// The line with its round corners made of quarters of ellipses: as large as the edges allow, but at most `max` long,
/// and not much longer than wide.
pub(super) fn rounded(corners: &[Corner], max: f32) -> Vec<Vec2> {
    /// How much longer than wide a quarter may be.
    const SLENDER: f32 = 1.4;
    /// Straight pieces to a quarter.
    const PIECES: u8 = 7;

    // How much of the edge toward a neighbor belongs to a corner: all of it, or half if the neighbor is round too.
    let reach = |corner: &Corner, neighbor: &Corner| {
        (corner.place.distance(neighbor.place) * if neighbor.is_round { 0.5 } else { 1.0 }).min(max)
    };
    let mut points = Vec::new();
    for (i, corner) in corners.iter().enumerate() {
        let before = i.checked_sub(1).and_then(|i| corners.get(i));
        let (Some(before), Some(after), true) = (before, corners.get(i + 1), corner.is_round) else {
            points.push(corner.place);
            continue;
        };
        let (a, b) = (reach(corner, before), reach(corner, after));
        let (a, b) = (a.min(b * SLENDER), b.min(a * SLENDER));
        let way = |to: &Corner, length: f32| (to.place - corner.place).normalize_or_zero() * length;
        let (back, forth) = (way(before, a), way(after, b));
        for k in 0..=PIECES {
            let angle = f32::from(k) / f32::from(PIECES) * std::f32::consts::FRAC_PI_2;
            points.push(corner.place + back * (1.0 - float::sin(angle)) + forth * (1.0 - float::cos(angle)));
        }
    }
    points
}

#[cfg(test)]
mod tests {
    use super::*;

    fn v(x: f32, y: f32) -> Vec2 {
        Vec2::new(x, y)
    }

    #[test]
    fn dashes_go_around_corners() {
        let line = [v(0.0, 0.0), v(5.0, 0.0), v(5.0, 5.0)];
        let expected = [
            vec![v(0.0, 0.0), v(2.0, 0.0)],
            vec![v(3.0, 0.0), v(5.0, 0.0)],
            vec![v(5.0, 1.0), v(5.0, 3.0)],
            vec![v(5.0, 4.0), v(5.0, 5.0)],
        ];
        assert_eq!(dashed(&line, [2.0, 1.0]), expected);
        assert_eq!(dashed(&line, [4.0, 2.0])[0].len(), 2);
        assert_eq!(dashed(&line, [6.0, 2.0])[0], [v(0.0, 0.0), v(5.0, 0.0), v(5.0, 1.0)]);
    }

    #[test]
    fn dashes_that_lead_nowhere_are_whole_lines() {
        let line = [v(0.0, 0.0), v(5.0, 0.0)];
        assert_eq!(dashed(&line, [0.0, 0.0]), [line.to_vec()]);
        assert_eq!(dashed(&line, [1.0, f32::NAN]), [line.to_vec()]);
        assert_eq!(dashed(&[], [1.0, 1.0]), [vec![]]);
        assert_eq!(dashed(&line, [1e-9, 1e-9]), [line.to_vec()]);
        assert_eq!(dashed(&[line[0]; 3], [1.0, 1.0]), [vec![line[0]]]);
    }

    #[test]
    fn a_round_corner_is_a_quarter_of_a_circle() {
        let corner = |x, y, is_round| Corner { place: v(x, y), is_round };
        let line = rounded(&[corner(0.0, 0.0, false), corner(3.0, 0.0, true), corner(3.0, 9.0, false)], 3.0);
        assert_eq!((line[0], line[line.len() - 1]), (v(0.0, 0.0), v(3.0, 9.0)));
        for point in &line[1..line.len() - 1] {
            assert!((point.distance(v(0.0, 3.0)) - 3.0).abs() < 1e-5, "{point}");
        }
    }
}
