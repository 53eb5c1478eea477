//! Checks exercise 3.1, a checkerboard.

use common::{
    Vec3,
    exercise::{Diagnosis, Finding, Verdict, dice::Dice, trying},
};
use ray_casting::{
    hit::{Hit, Side},
    ray::Ray,
};
use shadows::offset::Offset;

use super::words;

/// What the student writes.
#[derive(Clone, Copy)]
pub(crate) struct Answer {
    /// Whether the cube around a point is dark, by the width of a cube.
    pub(crate) is_dark: fn(Vec3, f32) -> bool,
    /// The same for a hit.
    pub(crate) is_dark_at: fn(&Hit, f32) -> bool,
}

/// A likely mistake: its name, what it answers, and what to say about it.
struct Rival<'a, Q> {
    name: &'static str,
    answer: &'a dyn Fn(&Q) -> bool,
    advice: &'static str,
}

/// A point in a block whose cubes have this width.
#[derive(Clone, Copy)]
struct Question {
    point: Vec3,
    size: f32,
}

impl Question {
    fn is_dark(&self) -> bool {
        is_dark(self.point, self.size)
    }

    fn words(&self) -> String {
        let cube = (self.point.as_dvec3() / f64::from(self.size)).floor();
        let (point, size) = (words::triple(self.point), self.size);
        format!("`is_dark` of the point {point} with size {size}, which lies in the cube {}", words::rounded(cube))
    }
}

/// The right answer.
fn is_dark(point: Vec3, size: f32) -> bool {
    let cube = (point.as_dvec3() / f64::from(size)).floor();
    cube.element_sum().rem_euclid(2.0) == 1.0
}

/// Accept a checkerboard, or name what is wrong with it.
pub(crate) fn check(answer: Answer) -> Verdict {
    let mut dice = Dice::new(31);
    let near: Vec<_> = (0..200).map(|_| question(&mut dice, [0.0, 6.0], 1.0)).collect();
    let surfaces: Vec<_> = (0..400).map(|_| surface(&mut dice)).collect();
    let ask = |q: &Question| trying(|| q.words(), || (answer.is_dark)(q.point, q.size));
    let ask_surface = |s: &Surface| trying(|| s.words(), || (answer.is_dark_at)(&s.hit, s.size));
    if !near.iter().any(ask) {
        return Err(Diagnosis::not_started("All your cubes are light: `is_dark` returns `false` for every point."));
    }
    pattern(&near, &ask)?;
    let negative: Vec<_> = (0..200).map(|_| question(&mut dice, [-6.0, 0.0], 1.0)).collect();
    below_zero(&negative, &ask)?;
    let scaled: Vec<_> = (0..600)
        .map(|_| {
            let size = dice.choice([0.25, 0.5, 2.0, 3.0, 10.0]);
            question(&mut dice, [-6.0, 6.0], size)
        })
        .collect();
    sizes(&scaled, &ask)?;
    let distant: Vec<_> = (0..300).map(|i| far_question(&mut dice, [200.0, 40_000.0, 1e6][i / 100])).collect();
    far(&distant, &ask)?;
    if !surfaces.iter().any(ask_surface) {
        let message = "`is_dark` is right. Now for `is_dark_at`, which returns `false` for every hit.";
        return Err(Diagnosis::new("surface-not-started", message));
    }
    on_surfaces(&surfaces, &ask_surface)?;
    let slanted: Vec<_> = (0..400).map(|_| slanted_surface(&mut dice)).collect();
    near_borders(&slanted, &ask_surface)
}

/// A point at least a tenth of a cube's width away from every border, its cube numbers in a range.
fn question(dice: &mut Dice, [min, max]: [f32; 2], size: f32) -> Question {
    let point = Vec3::from_array([(); 3].map(|()| inner(dice, min, max)));
    Question { point: point * size, size }
}

/// A point in the middle of a cube about so many cubes away from the origin, in all three directions.
fn far_question(dice: &mut Dice, cubes: f32) -> Question {
    let size = dice.choice([0.5, 1.0, 2.0]);
    let mut coordinate = || dice.choice([-1.0, 1.0]) * (cubes - dice.number(0.0, 9.0).floor() - 0.5) * size;
    let point = Vec3::new(coordinate(), coordinate(), coordinate());
    Question { point, size }
}

/// A coordinate in widths of a cube, at least a tenth away from every border.
fn inner(dice: &mut Dice, min: f32, max: f32) -> f32 {
    loop {
        let x = dice.number(min, max);
        if (0.1..=0.9).contains(&(x - x.floor())) && (min..=max).contains(&x) {
            return x;
        }
    }
}

/// Go through the questions. The first wrong answer ends the check, with the name of the rival that answers all of them
/// like the student, or with the general name.
fn judge<Q>(
    questions: &[Q],
    [ask, right]: [&dyn Fn(&Q) -> bool; 2],
    words: &dyn Fn(&Q) -> String,
    rivals: &[Rival<'_, Q>],
    general: (&'static str, &str),
) -> Verdict {
    let Some(wrong) = questions.iter().find(|q| ask(q) != right(q)) else { return Ok(()) };
    let rival = rivals.iter().find(|rival| questions.iter().all(|q| ask(q) == (rival.answer)(q)));
    let (name, advice) = rival.map_or(general, |rival| (rival.name, rival.advice));
    let told = |is_dark| if is_dark { "dark" } else { "light" };
    Err(Finding {
        tried: words(wrong),
        got: told(ask(wrong)).into(),
        expected: told(right(wrong)).into(),
        advice: advice.into(),
    }
    .named(name))
}

fn judge_points(
    questions: &[Question],
    ask: &dyn Fn(&Question) -> bool,
    rivals: &[Rival<'_, Question>],
    general: (&'static str, &str),
) -> Verdict {
    judge(questions, [ask, &Question::is_dark], &Question::words, rivals, general)
}

/// Cubes of width 1 at positive coordinates.
fn pattern(questions: &[Question], ask: &dyn Fn(&Question) -> bool) -> Verdict {
    let odd = |x: f32| x.rem_euclid(2.0) >= 1.0;
    let odds = |q: &Question| q.point.to_array().map(odd);
    let count = |q: &Question| odds(q).into_iter().filter(|odd| *odd).count();
    let without = |q: &Question, axis: usize| odds(q)[axis] != q.is_dark();
    let columns: &str =
        "One of the three directions does not count: along it the color never changes. Add up all three.";
    let rivals = [
        Rival {
            name: "colors-swapped",
            answer: &|q: &Question| !q.is_dark(),
            advice: "Your pattern is right, but light and dark are swapped: dark is where the sum is odd.",
        },
        Rival { name: "direction-forgotten", answer: &|q: &Question| without(q, 0), advice: columns },
        Rival { name: "direction-forgotten", answer: &|q: &Question| without(q, 1), advice: columns },
        Rival { name: "direction-forgotten", answer: &|q: &Question| without(q, 2), advice: columns },
        Rival {
            name: "not-alternating",
            answer: &|q: &Question| count(q) > 0,
            advice: "A cube is dark here as soon as one of its numbers is odd, so that dark cubes touch. Add the three \
                     numbers up, and ask once whether the sum is odd.",
        },
        Rival {
            name: "not-alternating",
            answer: &|q: &Question| count(q) == 3,
            advice: "A cube is dark here only if all its numbers are odd, which leaves dark cubes alone among light ones. \
                     Add the three numbers up, and ask once whether the sum is odd.",
        },
        Rival {
            name: "rounded",
            answer: &|q: &Question| is_dark(q.point + 0.5, q.size),
            advice: "Your cubes are shifted by half their width: the number of a cube comes from `floor`, not from \
                     `round`.",
        },
        Rival {
            name: "sum-before-floor",
            answer: &|q: &Question| odd(q.point.element_sum()),
            advice: "These are slanted layers, not cubes: the coordinates were added first and rounded down afterward. \
                     Round down each of the three, then add.",
        },
    ];
    let general = ("wrong-pattern", "Work this point out on paper: three whole numbers, and whether their sum is odd.");
    judge_points(questions, ask, &rivals, general)
}

/// Cubes of width 1 at negative coordinates.
fn below_zero(questions: &[Question], ask: &dyn Fn(&Question) -> bool) -> Verdict {
    let truncated = |q: &Question| q.point.trunc().element_sum().rem_euclid(2.0) == 1.0;
    let rivals = [
        Rival {
            name: "remainder-negative",
            answer: &|_: &Question| false,
            advice: "All cubes at negative coordinates are light. Does your code take `%` there? It keeps the sign: −3 % 2 is \
                     −1, not 1, and `rem_euclid` gives 1. Or does it make unsigned numbers of them? `as u32` turns all that \
                     is negative into 0.",
        },
        Rival {
            name: "truncated",
            answer: &truncated,
            advice: "A number was cut off toward zero instead of rounded down: `as i32` turns −0.5 into 0, so that the \
                     cubes around zero are twice as wide. Call `floor` first. (The absolute value has the same effect.)",
        },
    ];
    let general = (
        "negative-coordinates",
        "At positive coordinates your cubes are right, but not here. What becomes of a negative number, by `as` for \
         instance, or by `%`?",
    );
    judge_points(questions, ask, &rivals, general)
}

/// Cubes of other widths.
fn sizes(questions: &[Question], ask: &dyn Fn(&Question) -> bool) -> Verdict {
    let rivals = [
        Rival {
            name: "size-ignored",
            answer: &|q: &Question| is_dark(q.point, 1.0),
            advice: "All cubes are one unit wide, whatever the `size`. Divide the point by it.",
        },
        Rival {
            name: "size-multiplied",
            answer: &|q: &Question| is_dark(q.point * q.size, 1.0),
            advice: "The greater the `size`, the smaller your cubes: divide by it instead of multiplying.",
        },
    ];
    let general = ("wrong-size", "With size 1 your cubes are right, but not with this one. Where does `size` come in?");
    judge_points(questions, ask, &rivals, general)
}

/// Cubes far away from the origin.
fn far(questions: &[Question], ask: &dyn Fn(&Question) -> bool) -> Verdict {
    let general = (
        "far-away",
        "Around the origin your cubes are right, but not so far away. Is a number forced into a type that is too small for \
         it, like `i8` or `i16`, or is the point kept within bounds?",
    );
    judge_points(questions, ask, &[], general)
}

/// A hit on a surface in the border between two layers of cubes.
struct Surface {
    hit: Hit,
    size: f32,
}

impl Surface {
    fn at(&self, normal: Vec3, shift: f32) -> bool {
        is_dark(self.hit.position - normal * shift, self.size)
    }

    fn words(&self) -> String {
        format!("`is_dark_at` of {}, with size {}", words::hit(&self.hit), self.size)
    }
}

/// A hit from either side on one of the planes through the origin at right angles to an axis, up to rounding.
fn surface(dice: &mut Dice) -> Surface {
    let size = dice.choice([0.001, 1.0, 1000.0]);
    let axis = dice.choice([Vec3::X, Vec3::Y, Vec3::Z]);
    let along = Vec3::from_array([(); 3].map(|()| inner(dice, -3.0, 3.0))) * (Vec3::ONE - axis);
    let position = (along + axis * dice.choice([-1e-5, 0.0, 1e-5])) * size;
    let normal = axis * dice.choice([-1.0, 1.0]);
    // A smooth mesh near its outline: it is shaded with a normal that lies almost in the surface.
    let bent = (dice.direction().reject_from(normal).normalize_or(normal) + normal * 0.005).normalize();
    let shading = dice.choice([normal, normal, bent]);
    let hit = Hit { position, ..Hit::new(&Ray::new(position + normal * size, -normal * size), 1.0, normal) };
    let side = dice.choice([Side::Outside, Side::Inside]);
    Surface { hit: Hit { side, ..hit.shaded_with(shading) }, size }
}

/// How far behind the surface of [`slanted_surface`] there is a border, in widths of a cube.
const DEPTHS: [f32; 3] = [0.0006, 0.0016, 0.005];

/// A hit on a slanted surface. A thousandth of `size` behind it is beyond a near border, or not yet.
fn slanted_surface(dice: &mut Dice) -> Surface {
    let size = dice.choice([0.01, 1.0, 1000.0]);
    let axis = dice.choice([0, 1, 2]);
    let normal = loop {
        let normal = dice.direction().normalize();
        if (0.3..0.9).contains(&normal[axis].abs()) {
            break normal;
        }
    };
    let mut position = Vec3::from_array([(); 3].map(|()| inner(dice, -3.0, 3.0)));
    position[axis] = dice.choice([-1.0, 0.0, 1.0, 2.0]) + normal[axis] * dice.choice(DEPTHS);
    let position = position * size;
    let hit = Hit { position, ..Hit::new(&Ray::new(position + normal * size, -normal * size), 1.0, normal) };
    Surface { hit, size }
}

/// Slanted surfaces near borders: it matters how far behind them is asked.
fn near_borders(surfaces: &[Surface], ask: &dyn Fn(&Surface) -> bool) -> Verdict {
    let shifted = |share: f32| move |s: &Surface| s.at(s.hit.geometric_normal, share * s.size);
    let right = shifted(1e-3);
    let far = [2e-3, 5e-3, 1e-2, 2e-2, 5e-2, 0.1, 0.2, 0.25, 0.5, 0.9].map(shifted);
    let near = [5e-4, 2e-4, 1e-4, 1e-5, 1e-6].map(shifted);
    let too_far = |answer| Rival {
        name: "too-far-behind",
        answer,
        advice: "You ask too far behind the surface: there the next cube begins. A thousandth of `size` is asked for.",
    };
    let too_near = |answer| Rival {
        name: "not-far-enough",
        answer,
        advice: "You ask behind the surface, but not as far as a thousandth of `size`.",
    };
    let by_axes = |s: &Surface| s.at(s.hit.geometric_normal.signum(), s.size / 1000.0);
    let rivals: Vec<_> = [Rival {
        name: "not-along-the-normal",
        answer: &by_axes,
        advice: "Your point is a thousandth of `size` away in each of the three directions, whatever the normal's length \
                 along them. Multiply the normal itself, not only its signs.",
    }]
    .into_iter()
    .chain(far.iter().map(|answer| too_far(answer as &dyn Fn(&Surface) -> bool)))
    .chain(near.iter().map(|answer| too_near(answer as &dyn Fn(&Surface) -> bool)))
    .collect();
    let general = (
        "wrong-depth",
        "This surface is slanted, and just behind it is a border. Ask neither more nor less than a thousandth of `size` \
         behind it, straight against `geometric_normal`.",
    );
    judge(surfaces, [ask, &right], &Surface::words, &rivals, general)
}

fn on_surfaces(surfaces: &[Surface], ask: &dyn Fn(&Surface) -> bool) -> Verdict {
    let right = |s: &Surface| s.at(s.hit.geometric_normal, s.size / 1000.0);
    let fixed = |shift: f32| move |s: &Surface| s.at(s.hit.geometric_normal, shift);
    let fixed_advice = "Your shift is the same for all sizes. In tiny cubes it leads into the next one, in huge cubes it is \
                        less than rounding. Multiply it by `size`.";
    let shifts = [fixed(1e-2), fixed(1e-3), fixed(1e-4), fixed(1e-5), fixed(1e-6)];
    let [a, b, c, d, e] = &shifts;
    let fixed = |answer| Rival { name: "fixed-shift", answer, advice: fixed_advice };
    let outward =
        |s: &Surface| if s.hit.side == Side::Inside { -s.hit.geometric_normal } else { s.hit.geometric_normal };
    let rivals = [
        Rival {
            name: "on-the-border",
            answer: &|s: &Surface| s.at(Vec3::ZERO, 0.0),
            advice: "This surface lies in the border between two layers of cubes, and rounding decides which of them you \
                     see. Ask a thousandth of `size` behind the surface.",
        },
        Rival {
            name: "before-the-surface",
            answer: &|s: &Surface| s.at(s.hit.geometric_normal, -s.size / 1000.0),
            advice: "You ask before the surface, in what was carved away. `geometric_normal` faces the ray: go against it.",
        },
        Rival {
            name: "side-twice",
            answer: &|s: &Surface| s.at(outward(s), s.size / 1000.0),
            advice: "From Side::Inside you ask before the surface. `geometric_normal` faces the ray already, whichever side \
                     was hit: there is no need to look at the side.",
        },
        Rival {
            name: "shading-normal",
            answer: &|s: &Surface| s.at(s.hit.shading_normal, s.size / 1000.0),
            advice: "The shading normal only says how bright a smooth mesh is. Where behind a surface is, the geometric \
                     normal says.",
        },
        Rival {
            name: "one-direction",
            answer: &|s: &Surface| s.at(Vec3::Y * s.hit.geometric_normal.y.signum(), s.size / 1000.0),
            advice: "Walls have borders as well as floors. Go against the normal, not down.",
        },
        Rival {
            name: "one-direction",
            answer: &|s: &Surface| s.at(Vec3::Y, s.size / 1000.0),
            advice: "Walls and ceilings have borders as well as floors. Go against the normal, not down.",
        },
        Rival {
            name: "divided-by-size",
            answer: &|s: &Surface| s.at(s.hit.geometric_normal, 0.001 / s.size),
            advice: "The greater the cubes, the shorter is your way behind the surface. Multiply by `size` instead of \
                     dividing by it.",
        },
        Rival {
            name: "offset-of-a-ray",
            answer: &|s: &Surface| is_dark(Offset::Following.origin(&s.hit, -s.hit.geometric_normal), s.size),
            advice: "The offset of a ray is as small as rounding allows, and that is too little here: a thousandth of a \
                     cube is asked for.",
        },
        fixed(a),
        fixed(b),
        fixed(c),
        fixed(d),
        fixed(e),
    ];
    let general = (
        "wrong-surface",
        "`is_dark` is right, but asked at the wrong place: ask it at `position` less `geometric_normal` times a thousandth \
         of `size`.",
    );
    judge(surfaces, [ask, &right], &Surface::words, &rivals, general)
}
