//! Shelves, and the books on them.

use common::{Vec3, color::srgb};
use ray_casting::{frame::Frame, material::Phong};

use super::{FAR, HALF_WIDTH};
use crate::scenes::{
    budget::{grid, number, ratio},
    builder::Builder,
    chance::Chance,
};

/// A wall of shelves. Its frame stands at the left end at the back; x runs along the shelves, z into the room.
pub(super) struct Shelf {
    pub(super) frame: Frame,
    pub(super) width: f32,
    /// Number of boards with books on them.
    pub(super) rows: u32,
    /// Number of compartments side by side.
    pub(super) bays: u32,
}

impl Shelf {
    /// Height of the whole.
    pub(super) const HEIGHT: f32 = 3.05;
    /// From the wall to the front.
    pub(super) const DEPTH: f32 = 0.34;
    /// Thickness of boards.
    pub(super) const BOARD: f32 = 0.035;
    /// Height of the base.
    const BASE: f32 = 0.12;

    /// Height of the upper side of a board.
    pub(super) fn board(&self, row: u32) -> f32 {
        Self::BASE + (Self::HEIGHT - Self::BASE) * ratio(row, self.rows)
    }

    /// Boards, sides and a crowning ledge.
    pub(super) fn wood(&self, builder: &mut Builder) {
        for row in 0..=self.rows {
            let y = self.board(row);
            builder.cuboid(&self.frame, Vec3::new(0.0, y - Self::BOARD, 0.0), Vec3::new(self.width, y, Self::DEPTH));
        }
        for bay in 0..=self.bays {
            let x = self.width * ratio(bay, self.bays);
            let half = Self::BOARD * 0.7;
            let high = Self::HEIGHT - Self::BOARD - 0.001;
            builder.cuboid(
                &self.frame,
                Vec3::new(x - half, 0.0, 0.001),
                Vec3::new(x + half, high, Self::DEPTH + 0.012),
            );
        }
        let (low, high) = (Vec3::new(-0.05, Self::HEIGHT, 0.0), Vec3::new(self.width + 0.05, Self::HEIGHT + 0.09, 0.4));
        builder.cuboid(&self.frame, low, high);
    }
}

/// The shelves of a room of so many triangles: along the right wall, and beside the far window.
pub(super) fn shelves(triangles: u32) -> Vec<Shelf> {
    let rows = number(triangles, 400, [0, 7]);
    let bays = |most| number(triangles, 600, [1, most]);
    let right = Frame::at(Vec3::new(HALF_WIDTH, 0.0, FAR + 0.4)).turned(Vec3::Y, -90.0);
    let mut shelves = vec![Shelf { frame: right, width: 11.4, rows, bays: bays(8) }];
    if triangles >= 3_000 {
        for x in [-3.9, 1.55] {
            shelves.push(Shelf { frame: Frame::at(Vec3::new(x, 0.0, FAR)), width: 2.05, rows, bays: bays(2) });
        }
    }
    shelves.retain(|shelf| shelf.rows > 0);
    shelves
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
    let mut chance = Chance::of("books", 0);
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
        let [from, to] = [bay, bay + 1].map(|bay| shelf.width * ratio(bay, shelf.bays)).map(|x| x - Shelf::BOARD * 0.7);
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
