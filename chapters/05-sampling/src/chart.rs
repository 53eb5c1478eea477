//! What an experiment has to show: lines over two axes, for a plot and for a table of all values.

/// Lines over two axes.
#[derive(Clone, Debug, PartialEq)]
pub struct Chart {
    /// What stands above it.
    pub title: String,
    /// The axis to the right.
    pub x: Axis,
    /// The axis upward.
    pub y: Axis,
    /// The lines.
    pub lines: Vec<Line>,
}

/// An axis of a chart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Axis {
    /// What is measured along it.
    pub name: &'static str,
    /// Whether equal steps are equal factors. Such an axis shows only what is above 0.
    pub is_logarithmic: bool,
}

/// A line of a chart.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// What it shows.
    pub name: String,
    /// Its points, `[x, y]`.
    pub points: Vec<[f64; 2]>,
    /// Lines of the same number have the same color.
    pub color: usize,
    /// Whether it is dashed.
    pub is_dashed: bool,
}

impl Chart {
    /// All values as comma-separated text: a line of names, then one line for each point.
    #[must_use]
    pub fn csv(&self) -> String {
        let mut text = format!("line,{},{}\n", self.x.name, self.y.name);
        for line in &self.lines {
            for [x, y] in &line.points {
                text += &format!("{},{x},{y}\n", line.name);
            }
        }
        text
    }

    /// The range of the values along an axis, 0 for x and 1 for y, which is never empty.
    #[must_use]
    pub fn range(&self, axis: usize) -> [f64; 2] {
        let is_logarithmic = if axis == 0 { self.x } else { self.y }.is_logarithmic;
        let values = self.lines.iter().flat_map(|line| &line.points).map(|point| point[axis.min(1)]);
        let shown = values.filter(|v| v.is_finite() && (!is_logarithmic || *v > 0.0));
        let [min, max] = shown.fold([f64::INFINITY, f64::NEG_INFINITY], |[min, max], v| [min.min(v), max.max(v)]);
        if min < max {
            [min, max]
        } else if min.is_finite() {
            // All the same: some room around it.
            if is_logarithmic { [min / 2.0, min * 2.0] } else { [min - 1.0, min + 1.0] }
        } else {
            [1.0, 10.0]
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chart(points: &[[f64; 2]], is_logarithmic: bool) -> Chart {
        let axis = |name| Axis { name, is_logarithmic };
        let line = Line { name: "a".into(), points: points.into(), color: 0, is_dashed: false };
        Chart { title: "t".into(), x: axis("count"), y: axis("error"), lines: vec![line] }
    }

    #[test]
    fn all_values_are_in_the_table() {
        assert_eq!(chart(&[[1.0, 0.5], [2.0, 1e-9]], true).csv(), "line,count,error\na,1,0.5\na,2,0.000000001\n");
    }

    #[test]
    fn ranges_are_never_empty() {
        let points = [[1.0, 0.5], [2.0, 0.0], [f64::NAN, 4.0], [5.0, f64::INFINITY]];
        assert_eq!([0, 1].map(|axis| chart(&points, true).range(axis)), [[1.0, 5.0], [0.5, 4.0]]);
        assert_eq!(chart(&points, false).range(1), [0.0, 4.0]);
        assert_eq!([chart(&[], true).range(0), chart(&[[2.0, 0.0]], true).range(1)], [[1.0, 10.0]; 2]);
        assert_eq!([true, false].map(|log| chart(&[[2.0, 0.0]], log).range(0)), [[1.0, 4.0], [1.0, 3.0]]);
    }
}
