//! Wrong mailboxes.

use std::{
    cell::RefCell,
    collections::HashSet,
    sync::{Mutex, PoisonError},
};

use common::{Interval, Vec3, exercise::Verdict};
use ray_casting::{aabb::Aabb, hit::Hit, ray::Ray};
use space_partitioning::primitives::Primitives;

use crate::{
    checks::{logged::Logged, mailboxing::check},
    name,
};

type Entry = <Logged as Primitives>::Entry;
type View = <Logged as Primitives>::View;

/// Primitives with notes: in each view of the kind `V`, and in the wrapper itself.
struct Mailboxed<V> {
    logged: Logged,
    shared: Mutex<Vec<u32>>,
    view: fn(&Self),
    intersect: fn(&Self, &Test<'_>, &RefCell<V>) -> Option<f32>,
}

/// What is asked of a primitive.
struct Test<'t> {
    logged: &'t Logged,
    entry: &'t Entry,
    view: &'t View,
    range: Interval,
    number: u32,
}

impl Test<'_> {
    fn answer(&self) -> Option<f32> {
        self.logged.intersect(self.entry, self.view, self.range)
    }
}

impl<V: Default> Primitives for Mailboxed<V> {
    type View = (View, RefCell<V>);
    type Entry = Entry;

    fn count(&self) -> u32 {
        self.logged.count()
    }

    fn aabb(&self, number: u32) -> Aabb {
        self.logged.aabb(number)
    }

    fn clipped(&self, number: u32, cell: &Aabb) -> Option<Aabb> {
        self.logged.clipped(number, cell)
    }

    fn octants(&self, number: u32, cell: &Aabb, middle: Vec3) -> [Option<Aabb>; 8] {
        self.logged.octants(number, cell, middle)
    }

    fn entry(&self, number: u32) -> Entry {
        self.logged.entry(number)
    }

    fn number(&self, entry: &Entry) -> u32 {
        self.logged.number(entry)
    }

    fn view(&self, ray: &Ray) -> Self::View {
        (self.view)(self);
        (self.logged.view(ray), RefCell::default())
    }

    fn intersect(&self, entry: &Entry, (view, notes): &Self::View, range: Interval) -> Option<f32> {
        let number = self.number(entry);
        (self.intersect)(self, &Test { logged: &self.logged, entry, view, range, number }, notes)
    }

    fn hit(&self, number: u32, ray: &Ray, t: f32) -> Option<Hit> {
        self.logged.hit(number, ray, t)
    }
}

type Intersect<V> = fn(&Mailboxed<V>, &Test<'_>, &RefCell<V>) -> Option<f32>;

/// The verdict on notes in the view.
fn verdict<V: Default>(intersect: Intersect<V>) -> Verdict {
    check(|logged| Mailboxed::<V> { logged, shared: Mutex::default(), view: |_| (), intersect })
}

fn diagnosis<V: Default>(intersect: Intersect<V>) -> &'static str {
    name(verdict(intersect))
}

type Set = HashSet<u32>;

#[test]
fn right_ones_are_accepted() {
    let by_set: Intersect<Set> =
        |_, test, notes| notes.borrow_mut().insert(test.number).then(|| test.answer()).flatten();
    assert_eq!(verdict(by_set), Ok(()));
    let by_list: Intersect<Vec<u32>> = |_, test, notes| {
        if notes.borrow().contains(&test.number) {
            return None;
        }
        notes.borrow_mut().push(test.number);
        test.answer()
    };
    assert_eq!(verdict(by_list), Ok(()));
}

#[test]
fn nothing_is_not_started() {
    assert_eq!(diagnosis::<()>(|_, test, _| test.answer()), "not-started");
}

#[test]
fn wrong_notes() {
    let other_way: Intersect<Set> =
        |_, test, notes| if notes.borrow_mut().insert(test.number) { None } else { test.answer() };
    assert_eq!(diagnosis(other_way), "never-tested");
    assert_eq!(diagnosis::<()>(|_, _, _| None), "never-tested");
    let only_hits: Intersect<Set> = |_, test, notes| {
        let is_noted = notes.borrow().contains(&test.number);
        let t = if is_noted { None } else { test.answer() };
        if t.is_some() {
            notes.borrow_mut().insert(test.number);
        }
        t
    };
    assert_eq!(diagnosis(only_hits), "misses-again");
    let only_misses: Intersect<Set> = |_, test, notes| {
        let is_noted = notes.borrow().contains(&test.number);
        let t = if is_noted { None } else { test.answer() };
        if t.is_none() {
            notes.borrow_mut().insert(test.number);
        }
        t
    };
    assert_eq!(diagnosis(only_misses), "hits-again");
    let only_the_last: Intersect<Option<u32>> = |_, test, notes| {
        let last = notes.borrow_mut().replace(test.number);
        if last == Some(test.number) { None } else { test.answer() }
    };
    assert_eq!(diagnosis(only_the_last), "forgetful");
    // Room for eight.
    let few: Intersect<Vec<u32>> = |_, test, notes| {
        let mut notes = notes.borrow_mut();
        if notes.contains(&test.number) {
            return None;
        }
        notes.insert(0, test.number);
        notes.truncate(8);
        test.answer()
    };
    assert_eq!(diagnosis(few), "forgetful");
    // A part of the number only.
    let bits: Intersect<u64> = |_, test, notes| {
        let bit = 1 << (test.number % 64);
        let is_noted = *notes.borrow() & bit != 0;
        *notes.borrow_mut() |= bit;
        if is_noted { None } else { test.answer() }
    };
    assert_eq!(diagnosis(bits), "lost-test");
}

#[test]
fn a_table_of_zeros_has_a_note_about_primitive_zero() {
    let table: Intersect<[u32; 32]> = |_, test, notes| {
        let mut notes = notes.borrow_mut();
        let note = &mut notes[test.number as usize % 32];
        let is_noted = *note == test.number;
        *note = test.number;
        if is_noted { None } else { test.answer() }
    };
    let told = verdict(table).unwrap_err();
    assert_eq!(told.name, "old-notes");
    assert!(told.message.replace('\n', " ").contains("starts with 0"), "{told}");
}

#[test]
fn notes_in_the_wrong_place() {
    let shared: Intersect<()> = |mailboxed, test, _| {
        let mut notes = mailboxed.shared.lock().unwrap_or_else(PoisonError::into_inner);
        if notes.contains(&test.number) {
            return None;
        }
        notes.push(test.number);
        test.answer()
    };
    assert_eq!(diagnosis(shared), "old-notes");
    // The same, but wiped out for every new ray.
    let verdict = check(|logged| Mailboxed {
        logged,
        shared: Mutex::default(),
        view: |mailboxed| mailboxed.shared.lock().unwrap_or_else(PoisonError::into_inner).clear(),
        intersect: shared,
    });
    assert_eq!(name(verdict), "shared-notes");
    // Beside the view, in the thread.
    thread_local! {
        static NOTES: RefCell<Set> = RefCell::default();
    }
    let of_the_thread: Intersect<()> =
        |_, test, _| NOTES.with_borrow_mut(|notes| notes.insert(test.number)).then(|| test.answer()).flatten();
    assert_eq!(diagnosis(of_the_thread), "old-notes");
}

#[test]
fn wrong_answers_handed_on() {
    let everywhere: Intersect<Set> = |_, test, notes| {
        let is_new = notes.borrow_mut().insert(test.number);
        is_new.then(|| Test { range: Interval::POSITIVE, ..*test }.answer()).flatten()
    };
    assert_eq!(diagnosis(everywhere), "wrong-answer");
    // What was hit before is hit again.
    let remembered: Intersect<Vec<(u32, Option<f32>)>> = |_, test, notes| {
        if let Some((_, t)) = notes.borrow().iter().find(|(number, _)| *number == test.number) {
            return *t;
        }
        let t = test.answer();
        notes.borrow_mut().push((test.number, t));
        t
    };
    assert_eq!(diagnosis(remembered), "hits-again");
}
