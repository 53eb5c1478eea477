//! Who knows whom: names and arrows between them.

use std::collections::BTreeSet;

/// Things with names, of which some know others.
#[derive(Debug, Default, PartialEq, Eq)]
pub(crate) struct Graph {
    /// The names.
    pub(crate) names: Vec<String>,
    /// Index of the one who knows, index of the one who is known.
    pub(crate) arrows: BTreeSet<(usize, usize)>,
}

impl Graph {
    /// Whom a thing knows.
    pub(crate) fn known_by(&self, from: usize) -> impl Iterator<Item = usize> {
        self.arrows.range((from, 0)..=(from, usize::MAX)).map(|(_, to)| *to)
    }

    /// Things that know each other in a circle, the first of them again at the end.
    pub(crate) fn circle(&self) -> Option<Vec<&str>> {
        // Whoever knows nobody who is left is in no circle.
        let mut left: BTreeSet<_> = (0..self.names.len()).collect();
        while let Some(free) = left.iter().copied().find(|&thing| !self.known_by(thing).any(|to| left.contains(&to))) {
            left.remove(&free);
        }
        // Whoever is left knows someone who is left, so the walk comes back.
        let mut walk = vec![*left.first()?];
        loop {
            let next = self.known_by(*walk.last()?).find(|to| left.contains(to))?;
            if let Some(start) = walk.iter().position(|&thing| thing == next) {
                walk.push(next);
                return Some(walk[start..].iter().map(|&thing| self.names[thing].as_str()).collect());
            }
            walk.push(next);
        }
    }

    /// The layer of each thing: 0 if it knows nobody, otherwise one above the highest that it knows.
    ///
    /// In a graph without circles.
    pub(crate) fn layers(&self) -> Vec<usize> {
        let mut layers = vec![0; self.names.len()];
        // A layer is final after as many rounds as its number.
        for _ in &self.names {
            for &(from, to) in &self.arrows {
                layers[from] = layers[from].max(layers[to] + 1).min(self.names.len());
            }
        }
        layers
    }

    /// Whether an arrow follows from others: the one who is known can be reached another way.
    pub(crate) fn is_implied(&self, (from, to): (usize, usize)) -> bool {
        let mut open: Vec<_> = self.known_by(from).filter(|&next| next != to).collect();
        let mut seen = BTreeSet::new();
        while let Some(next) = open.pop() {
            if next == to {
                return true;
            }
            if seen.insert(next) {
                open.extend(self.known_by(next));
            }
        }
        false
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn graph(names: &str, arrows: &[&str]) -> Graph {
        let index = |c: char| names.find(c).unwrap();
        let arrow = |text: &&str| (index(text.chars().next().unwrap()), index(text.chars().last().unwrap()));
        Graph { names: names.chars().map(String::from).collect(), arrows: arrows.iter().map(arrow).collect() }
    }

    #[test]
    fn layers_are_longest_ways_down() {
        let graph = graph("abcd", &["a→b", "b→c", "a→c", "d→c"]);
        assert_eq!(graph.layers(), [2, 1, 0, 1]);
        assert_eq!(graph.circle(), None);
        assert!(graph.is_implied((0, 2)));
        assert!(!graph.is_implied((0, 1)) && !graph.is_implied((3, 2)));
    }

    #[test]
    fn circles_are_found() {
        let circle = graph("abcd", &["a→b", "b→c", "c→b", "c→d"]);
        assert_eq!(circle.circle(), Some(vec!["b", "c", "b"]));
        assert_eq!(graph("a", &["a→a"]).circle(), Some(vec!["a", "a"]));
    }
}
