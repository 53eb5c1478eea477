//! What a panic means.

use super::{Diagnosis, Finding, paragraph};

/// The diagnosis for an answer that panics: with what was tried, and with the place and the words of the panic.
pub(super) fn diagnosis(tried: Option<String>, place: &str, words: &str) -> Diagnosis {
    const NAME: &str = "panicked";
    let got = format!("a panic at {place}: {words}");
    let advice = format!("Your code panicked, at the file and line above. {}", meaning(words));
    match tried {
        Some(tried) => Finding { tried, got, expected: "an answer without a panic".into(), advice }.named(NAME),
        None => Diagnosis::new(NAME, format!("There was {got}\n\n{}", paragraph("", &advice))),
    }
}

/// What a panic with these words means, and what helps.
fn meaning(words: &str) -> &'static str {
    // The longer beginning stands before the shorter one.
    const MEANINGS: [(&str, &str); 21] = [
        (
            "attempt to add with overflow",
            "The sum is greater than its type can say, or for negative numbers less. Numbers that come from far away do \
             that. Is there a way with smaller numbers, or with floating-point numbers?",
        ),
        (
            "attempt to subtract with overflow",
            "The difference is less than its type can say. Unsigned types such as u32 and usize end at zero: 2 − 3 is a \
             panic. For signed types the numbers were too far from zero.",
        ),
        (
            "attempt to multiply with overflow",
            "The product is greater than its type can say, or for negative numbers less. Is there a way with smaller \
             numbers, or with floating-point numbers?",
        ),
        (
            "attempt to negate with overflow",
            "The least number of a signed type has no counterpart above zero: i32 goes from −2147483648 to 2147483647.",
        ),
        ("attempt to shift", "A number was shifted by as many bits as it has, or by more."),
        (
            "attempt to divide by zero",
            "Whole numbers cannot be divided by zero. (Floating-point numbers can: the result is infinite or not a number.)",
        ),
        (
            "attempt to calculate the remainder with a divisor of zero",
            "Whole numbers have no remainder by zero. Is the divisor a number that was rounded down to zero?",
        ),
        (
            "attempt to",
            "A calculation with whole numbers has a result that its type cannot say. In this build that is a panic.",
        ),
        (
            "index out of bounds",
            "An array or a Vec was asked for a place that it does not have. The first place is 0, the last is the length \
             less one.",
        ),
        ("range ", "A part of a slice was asked for that reaches beyond its end, or ends before it begins."),
        ("slice index", "A part of a slice was asked for that reaches beyond its end, or ends before it begins."),
        (
            "called `Option::unwrap()` on a `None` value",
            "There was nothing to unwrap. What should your code answer when there is nothing? `if let Some(x)`, \
             `let … else` and `?` can tell.",
        ),
        (
            "called `Result::unwrap()` on an `Err` value",
            "There was an error instead of a value. What should your code do then? `match`, `if let` and `?` can tell.",
        ),
        ("not yet implemented", "A `todo!` is still to be filled in there."),
        ("not implemented", "An `unimplemented!` is still to be filled in there."),
        ("internal error: entered unreachable code", "An `unreachable!` was reached: one case more is possible."),
        ("assertion", "An `assert!` or one of its kin does not hold."),
        ("min > max, or either was NaN", "`clamp` needs bounds that are numbers, the lower one first."),
        (
            "RefCell already",
            "A `RefCell` was borrowed while another borrow of it was alive, and one of them is mutable.",
        ),
        // The same in the words of other versions of Rust.
        ("already ", "A `RefCell` was borrowed while another borrow of it was alive, and one of them is mutable."),
        ("capacity overflow", "A Vec or a String became larger than any memory. Is there a wrong length?"),
    ];
    const ELSE: &str = "A panic is the end where a program cannot go on: `unwrap` and `expect` where there is nothing, an index \
                        outside of an array, a whole number that its type cannot say (1 less than 0 in u32), a whole number \
                        divided by zero, and `todo!`.";
    let known = MEANINGS.iter().find(|(beginning, _)| words.starts_with(beginning));
    known.map_or(ELSE, |(_, meaning)| meaning)
}

#[cfg(test)]
mod tests {
    use std::{cell::RefCell, hint::black_box, panic};

    use super::*;

    #[test]
    fn what_was_tried_stands_before_the_panic() {
        let told = diagnosis(Some("a ray".into()), "cube.rs:3:4", "none");
        assert_eq!(told.name, "panicked");
        assert!(told.message.starts_with("Tried:    a ray\nGot:      a panic at cube.rs:3:4: none\n"), "{told}");
        let told = diagnosis(None, "cube.rs:3:4", "none");
        assert!(told.message.starts_with("There was a panic at cube.rs:3:4: none\n\nYour"), "{told}");
    }

    /// What the real panic says that `act` causes.
    fn words<T>(act: impl FnOnce() -> T + panic::UnwindSafe) -> String {
        let payload = panic::catch_unwind(act).err().unwrap();
        let text = payload.downcast_ref::<&str>().map(|text| (*text).to_owned());
        text.or_else(|| payload.downcast_ref::<String>().cloned()).unwrap()
    }

    #[test]
    fn each_kind_is_explained() {
        let none = || black_box(None::<u32>);
        let zero = || black_box(0_u32);
        let five = || black_box(5_usize);
        let said = [
            (words(move || black_box(1 / zero())), "divided by zero"),
            (words(move || black_box(1 % zero())), "no remainder"),
            (words(|| black_box(black_box(i32::MIN) / black_box(-1))), "its type cannot say"),
            (words(move || black_box([1, 2, 3][five()])), "the last is the length"),
            (words(move || black_box(&[1, 2, 3][five()..])), "part of a slice"),
            (words(move || none().unwrap()), "nothing to unwrap"),
            (words(|| "x".parse::<u32>().unwrap()), "error instead"),
            ("not yet implemented: later".into(), "`todo!`"),
            (words(|| unimplemented!("later")), "`unimplemented!`"),
            (words(|| unreachable!()), "`unreachable!`"),
            (words(|| assert_eq!(black_box(1), 2)), "`assert!`"),
            (words(|| black_box(1_f32).clamp(black_box(f32::NAN), 2.0)), "`clamp`"),
            (words(|| Vec::<u64>::with_capacity(black_box(usize::MAX))), "memory"),
            (
                words(|| {
                    let cell = RefCell::new(1);
                    let _one = cell.borrow_mut();
                    let _two = cell.borrow_mut();
                }),
                "RefCell",
            ),
            ("nothing known".into(), "`todo!`"),
        ];
        explained(said);
    }

    /// Each panic has a meaning with these words in it.
    fn explained(said: impl IntoIterator<Item = (String, &'static str)>) {
        for (words, expected) in said {
            assert!(meaning(&words).contains(expected), "{words}: {}", meaning(&words));
        }
    }

    /// Students write without `--release`. With it, sums wrap around and there is no panic to explain.
    #[test]
    #[cfg(debug_assertions)]
    fn each_kind_of_overflow_is_explained() {
        explained([
            (words(|| black_box(black_box(0_u32) - 1)), "end at zero"),
            (words(|| black_box(black_box(i64::MAX) + 1)), "sum"),
            (words(|| black_box(black_box(i64::MAX) * 2)), "product"),
            (words(|| black_box(-black_box(i32::MIN))), "counterpart"),
        ]);
    }
}
