//! The query: one ray's search among primitives, and what it has found so far.

use std::marker::PhantomData;

use common::Interval;
use ray_casting::ray::Ray;

use crate::{
    primitives::Primitives,
    probe::Probe,
    triangles::{Numbered, Triangles},
};

// ANCHOR: question
/// What a ray asks.
pub trait Question {
    /// Whether any hit will do, so that the first one found ends the search.
    const ANY_HIT: bool;
}

/// What is hit first?
#[derive(Clone, Copy, Debug)]
pub struct Nearest;

impl Question for Nearest {
    const ANY_HIT: bool = false;
}

/// Is anything hit at all?
#[derive(Clone, Copy, Debug)]
pub struct Any;

impl Question for Any {
    const ANY_HIT: bool = true;
}
// ANCHOR_END: question

// ANCHOR: query
/// A ray's search, whatever the structure: a structure only decides which primitives are tested, and in which order.
pub struct Query<'q, P: Primitives, Q, N> {
    primitives: &'q P,
    view: P::View,
    /// Where hits count. It ends just behind the nearest hit so far.
    range: Interval,
    found: Option<Found>,
    probe: &'q mut N,
    question: PhantomData<Q>,
}

/// A hit of a primitive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Found {
    /// Number of the primitive.
    pub number: u32,
    /// Ray parameter.
    pub t: f32,
}

impl<'q, P: Primitives, Q: Question, N: Probe> Query<'q, P, Q, N> {
    /// Nothing found yet.
    #[inline]
    pub fn new(primitives: &'q P, ray: &Ray, range: Interval, probe: &'q mut N) -> Self {
        Self { primitives, view: primitives.view(ray), range, found: None, probe, question: PhantomData }
    }

    /// Where hits count: what lies behind the nearest hit so far does not.
    #[inline]
    pub fn range(&self) -> Interval {
        self.range
    }

    /// The ray as the primitives see it.
    #[inline]
    pub(crate) fn view(&self) -> &P::View {
        &self.view
    }

    /// Note that the ray visits a cell.
    #[inline]
    pub fn visit(&mut self, cell: u32) {
        self.probe.visit(cell);
    }

    /// Test the primitives of a list. Returns whether the search is over.
    #[inline(always)]
    pub fn test(&mut self, list: &[P::Entry]) -> bool {
        for entry in list {
            let number = self.primitives.number(entry);
            self.probe.test(number);
            if let Some(t) = self.primitives.intersect(entry, &self.view, self.range)
                && self.note(number, t)
            {
                return true;
            }
        }
        false
    }

    /// Note a hit inside the range. Returns whether the search is over.
    #[inline(always)]
    fn note(&mut self, number: u32, t: f32) -> bool {
        self.probe.hit(number);
        // Of several hits at the same t the lowest number wins: so the order of the tests does not matter.
        if self.found.is_none_or(|nearest| t < nearest.t || number < nearest.number) {
            self.found = Some(Found { number, t });
            self.range = self.range.up_to(t.next_up());
        }
        Q::ANY_HIT
    }

    /// What was found.
    #[inline]
    pub fn found(&self) -> Option<Found> {
        self.found
    }
}
// ANCHOR_END: query

impl<Q: Question, N: Probe> Query<'_, Triangles, Q, N> {
    /// Test a triangle that is hit most likely. Returns whether the search is over.
    #[inline(always)]
    pub(crate) fn test_likely(&mut self, numbered: &Numbered) -> bool {
        let number = self.primitives.number(numbered);
        self.probe.test(number);
        let hit = numbered.triangle().hit_by_exact_weights(&self.view, self.range);
        hit.is_some_and(|hit| self.note(number, hit.t))
    }
}
