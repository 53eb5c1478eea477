//! What stands in the room: a table with chairs, books, lamps, curtains, plants.

use common::{Vec2, Vec3, color::srgb, float};
use ray_casting::{frame::Frame, material::Phong};

use super::{FAR, HALF_WIDTH, HEIGHT, LAMPS, NEAR, room::Shelf, wood};
use crate::scenes::{
    budget::{grid, number, ratio, share},
    builder::Builder,
    chance::Chance,
    foliage::{Cloud, leaf_length},
    furniture::{LEAST_CHAIR, chair_shares},
};

/// Height of the table's top.
const TABLE: f32 = 0.76;
/// Half the table's width.
const TABLE_HALF: f32 = 0.72;
/// z of its ends.
const TABLE_ENDS: [f32; 2] = [-3.0, -9.8];

/// Brass, polished.
fn brass() -> Phong {
    Phong::of(srgb(196, 150, 70), 1.2, 60.0)
}

/// Curtains on both sides of each window to the sun.
pub(super) fn curtains(builder: &mut Builder, triangles: u32) {
    const FEWEST: u32 = 40;
    builder.part("curtains", Phong::of(srgb(158, 62, 44), 0.0, 1.0));
    let windows = number(triangles, 2 * FEWEST, [0, 4]);
    let length = (NEAR - FAR) / 4.0;
    for i in (0..windows).map(|i| 3 - i) {
        let z = NEAR - length * (ratio(i, 1) + 0.5);
        for side in [-1.0, 1.0] {
            let frame = Frame::at(Vec3::new(-HALF_WIDTH + 0.12, 0.0, z + side * 1.05)).turned(Vec3::Y, 90.0);
            let [low, high] = [Vec2::new(-0.26, 0.05), Vec2::new(0.26, 3.3)];
            let mut chance = Chance::of(12, 2 * i + u32::from(side > 0.0));
            builder.drapery(&frame, low, high, 4.5, triangles / (2 * windows), &mut chance);
        }
    }
}

/// A book in its place on a shelf.
struct Book {
    frame: Frame,
    size: Vec3,
    color: usize,
}

/// Books on all shelves, in the colors of old bindings.
pub(super) fn books(builder: &mut Builder, shelves: &[Shelf], triangles: u32) {
    const FEWEST: u32 = 10;
    const NARROWEST: f32 = 0.036;
    let colors = [
        ("red books", srgb(140, 44, 40)),
        ("brown books", srgb(122, 78, 48)),
        ("green books", srgb(48, 84, 66)),
        ("blue books", srgb(44, 70, 104)),
        ("ochre books", srgb(192, 144, 66)),
        ("pale books", srgb(208, 192, 160)),
    ];
    let length: f32 = shelves.iter().map(|shelf| shelf.width * ratio(shelf.rows, 1)).sum();
    let width = (length / ratio(number(triangles, FEWEST, [1, u32::MAX]), 1)).max(NARROWEST);
    let mut books = vec![];
    let mut chance = Chance::of(13, 0);
    for shelf in shelves {
        for row in 0..shelf.rows {
            put_on_board(shelf, row, width, colors.len(), &mut chance, &mut books);
        }
    }
    let each = (triangles / u32::try_from(books.len()).unwrap_or(u32::MAX).max(1)).max(FEWEST);
    let steps = grid(each - 8, 0.25, [1, 1]);
    let steps = if each < 24 { [((each - 8) / 2).max(1), 1] } else { steps };
    for (color, (name, albedo)) in colors.into_iter().enumerate() {
        builder.part(name, Phong::of(albedo, 0.1, 20.0));
        for book in books.iter().filter(|book| book.color == color) {
            builder.book(&book.frame, book.size, steps);
        }
    }
}

/// Fill one board with books about so wide.
fn put_on_board(shelf: &Shelf, row: u32, width: f32, colors: usize, chance: &mut Chance, books: &mut Vec<Book>) {
    let room = shelf.board(1) - shelf.board(0) - Shelf::BOARD;
    for bay in 0..shelf.bays {
        let [from, to] =
            [bay, bay + 1].map(|bay| shelf.width * ratio(bay, shelf.bays)).map(|x| x - Shelf::BOARD * 0.7);
        let mut x = from + 2.0 * Shelf::BOARD * 0.7;
        // Works in several volumes look alike.
        let (mut volumes, mut color, mut height) = (0, 0, 0.0);
        while x < to - 0.02 {
            if volumes == 0 {
                volumes = 1 + chance.index(7);
                color = chance.index(colors);
                height = room * chance.between(0.62, 0.9);
            }
            volumes -= 1;
            let wide = (width * chance.between(0.75, 1.25)).min(to - x);
            let size = Vec3::new(wide * 0.97, height, 0.2);
            let at = Vec3::new(x + wide / 2.0, shelf.board(row), 0.27 + chance.around(0.012));
            // The shelf's frame, moved along.
            let base = shelf.frame.point_to_world(at);
            let turned = shelf.frame.vector_to_world(Vec3::Z).x < -0.5;
            let frame = Frame::at(base).turned(Vec3::Y, if turned { -90.0 } else { 0.0 });
            // Now and then nothing stands there.
            if !chance.happens(0.05) {
                books.push(Book { frame, size, color });
            }
            x += wide;
        }
    }
}

/// The table: a top with round edges, a frame and turned legs.
pub(super) fn table(builder: &mut Builder, triangles: u32) {
    builder.part("table", wood(srgb(128, 76, 42)));
    let [near, far] = TABLE_ENDS;
    let here = Frame::at(Vec3::ZERO);
    let (middle, half) = (
        Vec3::new(0.0, TABLE - 0.03, (near + far) / 2.0),
        Vec3::new(TABLE_HALF, 0.03, (near - far) / 2.0),
    );
    let top = grid(share(triangles, 0.3), 1.0, [4, 3]);
    if top[1] < 16 {
        builder.cuboid(&here, middle - half, middle + half);
    } else {
        builder.cushion(&here, middle, half, top, 40.0);
    }
    if triangles >= 40 {
        builder.block([-0.58, TABLE - 0.15, far + 0.25], [0.58, TABLE - 0.061, near - 0.25]);
    }
    let rows = number(triangles, 80, [2, 4]);
    for i in 0..rows {
        let z = near - 0.35 + (far - near + 0.7) * ratio(i, rows - 1);
        for x in [-0.5, 0.5] {
            builder.table_leg(&Frame::at(Vec3::new(x, 0.0, z)), TABLE - 0.06, 0.06, share(triangles, 0.6) / (2 * rows));
        }
    }
}

/// Open books, piles of books, bowls, and reading lamps with green shades.
pub(super) fn on_the_table(builder: &mut Builder, triangles: u32) {
    const FEWEST: u32 = 40;
    let places = number(triangles, FEWEST, [0, 14]);
    let place = |i: u32, x: f32| {
        let mut chance = Chance::of(14, i);
        let [near, far] = TABLE_ENDS;
        let z = near - 0.55 + (far - near + 1.0) * ratio(i / 2, places.div_ceil(2));
        let side = if i % 2 == 0 { 1.0 } else { -1.0 };
        let frame = Frame::at(Vec3::new(side * x, TABLE + 0.001, z + chance.around(0.12)));
        (frame.turned(Vec3::Y, side * 90.0 + chance.around(16.0)), chance)
    };
    let each = triangles / places.max(1);
    builder.part("open books", Phong::of(srgb(236, 226, 204), 0.0, 1.0));
    for i in 0..places {
        builder.open_book(&place(i, 0.42).0, number(share(each, 0.15), 4, [2, 400]));
    }
    // Piles lie beside every third open book.
    let piles = [("red covers", srgb(134, 40, 38)), ("green covers", srgb(50, 88, 70)), ("ochre covers", srgb(190, 140, 60))];
    for (level, (name, color)) in piles.into_iter().enumerate().take(if each < 2 * FEWEST { 0 } else { 3 }) {
        builder.part(name, Phong::of(color, 0.1, 20.0));
        for i in (0..places).step_by(3) {
            let (frame, mut chance) = place(i, 0.12);
            let height = 0.045 * ratio(u32::try_from(level).unwrap_or(0), 1);
            let at = frame.point_to_world(Vec3::new(0.1, height, 0.0));
            let frame = Frame::at(at).turned(Vec3::Y, 60.0 + chance.around(60.0) + height * 900.0);
            builder.cuboid(&frame, Vec3::new(-0.1, 0.0, -0.14), Vec3::new(0.1, 0.043, 0.14));
        }
    }
    let sides = number(share(each, 0.25), 14, [3, 500]);
    builder.part("bowls", Phong::of(srgb(60, 110, 130), 0.6, 80.0));
    for i in (1..places).step_by(4) {
        builder.cup(&place(i, 0.1).0, 0.13, 0.09, sides);
    }
    reading_lamps(builder, share(triangles, 0.4));
}

/// Reading lamps along the middle of the table.
fn reading_lamps(builder: &mut Builder, triangles: u32) {
    const FEWEST: u32 = 60;
    let lamps = number(triangles, FEWEST, [0, 3]);
    let each = triangles / lamps.max(1);
    let feet: Vec<Vec3> = (0..lamps).map(|i| Vec3::new(0.0, TABLE, -4.9 - 2.1 * ratio(i, 1))).collect();
    builder.part("stands of reading lamps", brass());
    let sides = number(share(each, 0.4), 12, [4, 600]);
    for &foot in &feet {
        let profile = [[0.1, 0.0], [0.1, 0.015], [0.02, 0.04], [0.012, 0.1], [0.018, 0.2], [0.01, 0.22], [0.01, 0.4]];
        builder.turned(&Frame::at(foot), &profile.map(Vec2::from), sides);
    }
    builder.part("green shades", Phong::of(srgb(22, 112, 74), 0.8, 60.0));
    let [around, along] = grid(share(each, 0.45), 2.0, [4, 1]);
    for &foot in &feet {
        // Half a pipe, its opening below.
        builder.surface(along, around, |u, v| {
            let angle = std::f32::consts::PI * v;
            let (x, y) = (0.085 * float::cos(angle), 0.38 + 0.075 * float::sin(angle));
            foot + Vec3::new(x, y, 0.17 * (1.0 - 2.0 * u))
        });
    }
}

/// Chairs at both sides of the table.
pub(super) fn chairs(builder: &mut Builder, triangles: u32) {
    let pairs = number(triangles, 2 * LEAST_CHAIR, [1, 7]);
    let seats = if triangles < LEAST_CHAIR { 1 } else { 2 * pairs };
    let [near, far] = TABLE_ENDS;
    let mut frames = vec![];
    for i in 0..pairs {
        let z = near + (far - near) * (ratio(i, pairs) + 0.5 / ratio(pairs, 1));
        for side in [-1.0, 1.0] {
            let mut chance = Chance::of(15, 2 * i + u32::from(side > 0.0));
            // Somebody pushed some of them back.
            let x = side * (TABLE_HALF + 0.12 + chance.between(0.0, 1.0) * chance.between(0.0, 0.55));
            frames.push(Frame::at(Vec3::new(x, 0.0, z)).turned(Vec3::Y, -side * 90.0 + chance.around(14.0)));
        }
    }
    frames.truncate(usize::try_from(seats).unwrap_or(usize::MAX));
    let [wooden, padded] = chair_shares(triangles / seats);
    builder.part("chairs", wood(srgb(112, 66, 38)));
    for frame in &frames {
        builder.chair_wood(frame, wooden);
    }
    builder.part("cushions", Phong::of(srgb(52, 98, 82), 0.18, 12.0));
    for frame in &frames {
        builder.chair_cushions(frame, padded);
    }
}

/// Lamps over the table: white inside, brass outside.
pub(super) fn lamps(builder: &mut Builder, triangles: u32) {
    const WIDE: f32 = 0.34;
    const HIGH: f32 = 0.24;
    const THIN: f32 = 0.008;
    let hung = number(triangles, 18, [0, 3]);
    let [sides, steps] = grid(triangles / (2 * hung.max(1)), 3.0, [4, 1]);
    let steps = steps.max(2);
    let dome = |t: f32, wide: f32| {
        let angle = std::f32::consts::FRAC_PI_2 * t;
        Vec2::new((wide * float::cos(angle)).max(0.025), HIGH * float::sin(angle))
    };
    let lamps = || LAMPS.into_iter().zip(0..hung).map(|(lamp, _)| lamp);
    builder.part("lamps inside", Phong::of(srgb(250, 244, 230), 0.0, 1.0));
    for lamp in lamps() {
        let profile: Vec<Vec2> = (0..=steps).rev().map(|i| dome(ratio(i, steps), WIDE - THIN)).collect();
        builder.turned(&Frame::at(lamp), &profile, sides);
    }
    builder.part("lamps", brass());
    for lamp in lamps() {
        let profile: Vec<Vec2> = (0..=steps).map(|i| dome(ratio(i, steps), WIDE)).collect();
        builder.turned(&Frame::at(lamp), &profile, sides);
        builder.bar(lamp + Vec3::Y * HIGH, lamp.with_y(HEIGHT), 0.012, 6.min(sides));
    }
}

/// A globe on a stand beside the shelves.
pub(super) fn globe(builder: &mut Builder, triangles: u32) {
    let place = Vec3::new(2.55, 0.0, -3.4);
    builder.part("globe", Phong::of(srgb(70, 122, 150), 0.5, 50.0));
    let steps = grid(share(triangles, 0.6), 2.0, [4, 3]);
    if triangles < 200 {
        return;
    }
    builder.ball(steps, |p| place + Vec3::Y * 1.05 + p * 0.26);
    builder.part("stand of the globe", brass());
    let [around, sides] = grid(share(triangles, 0.25), 3.0, [8, 3]);
    let ring: Vec<Vec3> = (0..=around)
        .map(|i| std::f32::consts::TAU * ratio(i, around))
        .map(|a| place + Vec3::Y * 1.05 + Vec3::new(float::cos(a), float::sin(a), 0.25 * float::cos(a)) * 0.3)
        .collect();
    builder.tube(&ring, sides, |_| 0.014);
    let profile = [[0.24, 0.0], [0.24, 0.03], [0.05, 0.07], [0.03, 0.3], [0.05, 0.45], [0.02, 0.5], [0.02, 0.78]];
    builder.turned(&Frame::at(place), &profile.map(Vec2::from), number(share(triangles, 0.15), 12, [4, 500]));
}

/// Plants in pots whose leaves bring the room to its size.
pub(super) fn plants(builder: &mut Builder, triangles: u32) {
    let places = [Vec3::new(-1.75, 0.0, FAR + 0.75), Vec3::new(-3.35, 0.0, -2.2), Vec3::new(1.8, 0.0, FAR + 0.8)];
    let left = triangles.saturating_sub(builder.count());
    let plants = number(left, 100, [0, 3]);
    let places = || places.into_iter().zip(0..plants).map(|(place, _)| place);
    let sides = number(left / 10, 14 * plants.max(1), [5, 96]);
    builder.part("pots", Phong::of(srgb(178, 96, 62), 0.0, 1.0));
    for place in places() {
        builder.pot(&Frame::at(place), 0.27, 0.42, sides);
    }
    builder.part("stems", wood(srgb(104, 82, 58)));
    let mut clouds = vec![];
    for (place, i) in places().zip(0..) {
        let mut chance = Chance::of(16, i);
        for stem in 0..5 {
            let reach = Vec3::new(chance.around(0.42), chance.between(1.05, 1.75), chance.around(0.36));
            let bend = Vec3::new(chance.around(0.1), 0.0, chance.around(0.1));
            let line = [0.0_f32, 0.35, 0.7, 1.0].map(|t| place + Vec3::Y * 0.36 + (reach * t + bend * (t * (1.0 - t) * 4.0)));
            if left >= 400 || stem == 0 {
                builder.tube(&line, sides.min(12), |_| 0.016);
            }
            clouds.push(Cloud { center: line[3], half: Vec3::new(0.3, 0.34, 0.3) });
            clouds.push(Cloud { center: line[2], half: Vec3::new(0.22, 0.24, 0.22) });
        }
    }
    let left = triangles.saturating_sub(builder.count());
    let fine = left > 20_000;
    let leaves = left / if fine { 4 } else { 2 };
    let length = leaf_length(5.2, leaves / plants.max(1)).clamp(0.01, 0.22);
    let shares = [leaves / 2, leaves - leaves / 2];
    for (shade, (name, color)) in [("leaves", srgb(72, 122, 52)), ("dark leaves", srgb(44, 92, 44))].into_iter().enumerate() {
        builder.part(name, Phong::of(color, 0.12, 18.0));
        if !clouds.is_empty() {
            builder.leaves(&clouds, shares[shade], length, fine, &mut Chance::of(17 + u64::from(shade > 0), 0));
        }
    }
}
