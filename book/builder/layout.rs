//! Where the things of a diagram stand: in layers, arrows downward, with few crossings (Sugiyama, Tagawa, Toda 1981).

use std::collections::{BTreeMap, BTreeSet};

use crate::graph::Graph;

/// Space between neighbors of a layer.
const GAP: f64 = 16.0;
/// Width of an arrow that passes through a layer.
const PASS: f64 = 2.0;
/// How often the order and the places are improved.
const ROUNDS: usize = 24;

/// A thing in its layer, or the place where an arrow passes through a layer.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Spot {
    /// Layer, 0 at the bottom.
    pub(crate) layer: usize,
    /// Middle from left to right.
    pub(crate) x: f64,
    /// Width.
    pub(crate) width: f64,
}

/// Where everything stands.
pub(crate) struct Layout {
    /// The things, in the order of the graph, and behind them the passes.
    pub(crate) spots: Vec<Spot>,
    /// For each arrow of the graph, in its order: the spots that it touches, from top to bottom.
    pub(crate) ways: Vec<Vec<usize>>,
    /// The whole width.
    pub(crate) width: f64,
    /// The number of layers.
    pub(crate) layers: usize,
    rows: Vec<Vec<usize>>,
    /// For each spot, the spots that it touches in the layer above and in the layer below.
    touches: Vec<[Vec<usize>; 2]>,
}

impl Layout {
    /// Lay out a graph without circles whose things have these widths.
    pub(crate) fn new(graph: &Graph, widths: &[f64]) -> Self {
        let of = graph.layers();
        let layers = of.iter().max().map_or(0, |top| top + 1);
        let mut spots: Vec<_> = of.iter().zip(widths).map(|(&layer, &width)| Spot { layer, x: 0.0, width }).collect();
        // Arrows to the same end share their passes, so that they join on their way.
        let mut passes = BTreeMap::new();
        let mut ways = Vec::new();
        for &(from, to) in &graph.arrows {
            let mut way = vec![from];
            for layer in (of[to] + 1..of[from]).rev() {
                way.push(*passes.entry((to, layer, graph.is_implied((from, to)))).or_insert_with(|| {
                    spots.push(Spot { layer, x: 0.0, width: PASS });
                    spots.len() - 1
                }));
            }
            way.push(to);
            ways.push(way);
        }
        let steps: BTreeSet<_> = ways.iter().flat_map(|way| way.windows(2).map(|step| (step[0], step[1]))).collect();
        let mut touches = vec![[Vec::new(), Vec::new()]; spots.len()];
        for (upper, lower) in steps {
            touches[upper][1].push(lower);
            touches[lower][0].push(upper);
        }
        let rows = (0..layers).map(|layer| (0..spots.len()).filter(|&s| spots[s].layer == layer).collect()).collect();
        let mut layout = Self { spots, ways, width: 0.0, layers, rows, touches };
        layout.order();
        layout.place();
        layout
    }

    /// Order each layer by the middle of its neighbors, from above and from below in turn; keep the best.
    fn order(&mut self) {
        let mut best = (self.crossings(), self.rows.clone());
        for round in 0..ROUNDS {
            let side = round % 2;
            let layers: Vec<_> = if side == 0 { (0..self.layers).rev().collect() } else { (0..self.layers).collect() };
            for layer in layers {
                let ranks = self.ranks();
                let middle = |spot: &usize| {
                    let near = &self.touches[*spot][side];
                    if near.is_empty() { ranks[spot] } else { mean(near.iter().map(|s| ranks[s])) }
                };
                let mut row = self.rows[layer].clone();
                row.sort_by(|a, b| middle(a).total_cmp(&middle(b)));
                self.rows[layer] = row;
            }
            let crossings = self.crossings();
            if crossings < best.0 {
                best = (crossings, self.rows.clone());
            }
        }
        self.rows = best.1;
    }

    /// The place of each spot in its row, from 0 to 1.
    fn ranks(&self) -> BTreeMap<usize, f64> {
        let rank = |(row, spot): (&Vec<usize>, usize)| (row[spot], (spot as f64 + 0.5) / row.len() as f64);
        self.rows.iter().flat_map(|row| (0..row.len()).map(move |spot| rank((row, spot)))).collect()
    }

    /// How many pairs of arrows cross between neighboring layers.
    fn crossings(&self) -> usize {
        let ranks = self.ranks();
        let between = |row: &Vec<usize>| {
            let lines: Vec<_> = row
                .iter()
                .flat_map(|&s| self.touches[s][1].iter().map(move |&t| (s, t)))
                .map(|(s, t)| (ranks[&s], ranks[&t]))
                .collect();
            let pairs = lines.iter().enumerate().flat_map(|(i, a)| lines[..i].iter().map(move |b| (a, b)));
            pairs.filter(|(a, b)| (a.0 - b.0) * (a.1 - b.1) < 0.0).count()
        };
        self.rows.iter().map(between).sum()
    }

    /// Move each spot towards the middle of its neighbors, as far as its row allows.
    fn place(&mut self) {
        for row in self.rows.clone() {
            self.settle(&row, &vec![0.0; row.len()]);
        }
        for round in 0..ROUNDS {
            for layer in 0..self.layers {
                let layer = if round % 2 == 0 { layer } else { self.layers - 1 - layer };
                let row = self.rows[layer].clone();
                let wish = |&spot: &usize| {
                    let near: Vec<_> = self.touches[spot].iter().flatten().map(|&s| self.spots[s].x).collect();
                    if near.is_empty() { self.spots[spot].x } else { mean(near.into_iter()) }
                };
                let wishes: Vec<_> = row.iter().map(wish).collect();
                self.settle(&row, &wishes);
            }
        }
        let left = self.spots.iter().map(|s| s.x - s.width / 2.0).fold(f64::INFINITY, f64::min);
        self.spots.iter_mut().for_each(|spot| spot.x -= left);
        self.width = self.spots.iter().map(|s| s.x + s.width / 2.0).fold(0.0, f64::max);
    }

    /// Give the spots of a row places that keep their order and their distance and are, by least squares, nearest to
    /// what they wish (pool adjacent violators).
    fn settle(&mut self, row: &[usize], wishes: &[f64]) {
        let mut start = 0.0;
        // Where each spot stands in the tightest row, and blocks of spots that push each other: their mean, how many.
        let mut tight = Vec::new();
        let mut blocks: Vec<(f64, usize)> = Vec::new();
        for (&spot, wish) in row.iter().zip(wishes) {
            let width = self.spots[spot].width;
            tight.push(start + width / 2.0);
            let mut block = (wish - start - width / 2.0, 1);
            while let Some(previous) = blocks.pop_if(|previous| previous.0 > block.0) {
                let count = previous.1 + block.1;
                block = ((previous.0 * previous.1 as f64 + block.0 * block.1 as f64) / count as f64, count);
            }
            blocks.push(block);
            start += width + GAP;
        }
        let shifts = blocks.iter().flat_map(|&(shift, count)| std::iter::repeat_n(shift, count));
        for ((&spot, tight), shift) in row.iter().zip(tight).zip(shifts) {
            self.spots[spot].x = tight + shift;
        }
    }
}

/// The mean of some numbers.
fn mean(numbers: impl ExactSizeIterator<Item = f64>) -> f64 {
    let count = numbers.len() as f64;
    numbers.sum::<f64>() / count
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_overlaps_and_crossings_that_need_not_be_are_not() {
        // Two chains whose order in the graph crosses them.
        let names = ["a", "b", "c", "d"].map(String::from).to_vec();
        let graph = Graph { names, arrows: [(0, 3), (1, 2)].into() };
        let layout = Layout::new(&graph, &[40.0, 80.0, 60.0, 20.0]);
        assert_eq!(layout.crossings(), 0);
        for row in &layout.rows {
            for pair in row.windows(2) {
                let [a, b] = [layout.spots[pair[0]], layout.spots[pair[1]]];
                assert!(b.x - a.x >= (a.width + b.width) / 2.0 + GAP - 1e-9, "{a:?} {b:?}");
            }
        }
    }

    #[test]
    fn long_arrows_pass_through_every_layer() {
        let names = ["a", "b", "c"].map(String::from).to_vec();
        let graph = Graph { names, arrows: [(0, 1), (1, 2), (0, 2)].into() };
        let layout = Layout::new(&graph, &[40.0; 3]);
        assert_eq!((layout.layers, layout.spots.len()), (3, 4));
        assert_eq!(layout.ways, [vec![0, 1], vec![0, 3, 2], vec![1, 2]]);
    }
}
