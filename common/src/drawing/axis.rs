//! An axis of a plot: where values lie on it, and its ticks.

use crate::float;

/// An axis with ticks, and a thin line at each of them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axis {
    /// What is measured.
    pub name: &'static str,
    /// What follows a number at a tick, like `°`.
    pub unit: &'static str,
    /// Least and greatest value; on a logarithmic scale both are greater than 0.
    pub range: [f32; 2],
    /// How values are spread over it.
    pub scale: Scale,
}

/// How values are spread over an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Scale {
    /// Equal differences are equally long. Ticks are at every multiple of a step.
    Linear {
        /// From one tick to the next.
        step: f32,
    },
    /// Equal ratios are equally long. Ticks are at the powers of ten.
    Logarithmic,
}

impl Axis {
    /// The values at the ticks.
    pub(super) fn ticks(&self) -> Vec<f32> {
        /// More than this and they would be a gray area.
        const MOST: u8 = 50;
        /// The powers of ten that an `f32` can be, nearly.
        const POWERS: std::ops::RangeInclusive<i8> = -37..=38;
        let [min, max] = self.range;
        match self.scale {
            Scale::Linear { step } => {
                let first = (min / step).ceil();
                let ticks = (0..MOST).map(|i| (first + f32::from(i)) * step);
                ticks.take_while(|tick| *tick <= max + step * 1e-3).collect()
            }
            Scale::Logarithmic => {
                let is_on = |tick: &f32| (min * (1.0 - 1e-3)..=max * (1.0 + 1e-3)).contains(tick);
                POWERS.map(power_of_ten).filter(is_on).collect()
            }
        }
    }

    /// Where a value lies between the ends of the axis, from 0 to 1.
    #[must_use]
    pub fn share(&self, value: f32) -> f32 {
        match self.scale {
            Scale::Linear { .. } => (value - self.range[0]) / (self.range[1] - self.range[0]),
            Scale::Logarithmic => {
                let [value, all] = [value, self.range[1]].map(|value| float::ln(value / self.range[0]));
                value / all
            }
        }
    }

    /// The value halfway between the ends.
    pub(super) fn middle(&self) -> f32 {
        let [min, max] = self.range;
        match self.scale {
            Scale::Linear { .. } => (min + max) / 2.0,
            Scale::Logarithmic => min.sqrt() * max.sqrt(),
        }
    }

    /// A value in figures.
    pub(super) fn label(&self, tick: f32) -> String {
        let unit = self.unit;
        if self.scale == Scale::Logarithmic {
            return format!("{}{unit}", power(tick));
        }
        // Computed with rounding errors: at most four decimals are meant.
        let rounded = (tick * 1e4).round() / 1e4;
        let sign = if rounded < 0.0 { "−" } else { "" };
        format!("{sign}{}{unit}", rounded.abs())
    }
}

/// Ten to the power of a whole number.
fn power_of_ten(exponent: i8) -> f32 {
    // A number in figures is read to the last bit.
    format!("1e{exponent}").parse().unwrap_or(f32::INFINITY)
}

/// A power of ten in figures: `0.1`, `1` and `10` as they are, others with an exponent, like `10⁻³`.
fn power(value: f32) -> String {
    if (0.05..50.0).contains(&value) {
        return format!("{value}");
    }
    // Scientific notation knows the exponent.
    let scientific = format!("{value:e}");
    let exponent = scientific.split('e').nth(1).unwrap_or_default();
    let raised = |c| match c {
        '-' => '⁻',
        _ => "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().nth(c.to_digit(10).unwrap_or(0) as usize).unwrap_or(c),
    };
    format!("10{}", exponent.chars().map(raised).collect::<String>())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn linear(unit: &'static str, range: [f32; 2], step: f32) -> Axis {
        Axis { name: "", unit, range, scale: Scale::Linear { step } }
    }

    fn logarithmic(unit: &'static str, range: [f32; 2]) -> Axis {
        Axis { name: "", unit, range, scale: Scale::Logarithmic }
    }

    fn labels(axis: Axis) -> String {
        axis.ticks().into_iter().map(|tick| axis.label(tick)).collect::<Vec<_>>().join(" ")
    }

    #[test]
    fn ticks_are_round_numbers() {
        assert_eq!(labels(linear("", [-1.0, 1.0], 0.5)), "−1 −0.5 0 0.5 1");
        assert_eq!(labels(linear("°", [0.0, 90.0], 30.0)), "0° 30° 60° 90°");
        assert_eq!(labels(linear("", [0.05, 0.35], 0.1)), "0.1 0.2 0.3");
        // No step, no ticks for ever.
        assert!(linear("", [0.0, 1.0], 0.0).ticks().len() <= 50);
    }

    #[test]
    fn logarithmic_ticks_are_powers_of_ten() {
        assert_eq!(labels(logarithmic("", [1e-3, 1e3])), "10⁻³ 10⁻² 0.1 1 10 10² 10³");
        assert_eq!(labels(logarithmic(" s", [2e-8, 1e-6])), "10⁻⁷ s 10⁻⁶ s");
        assert_eq!(labels(logarithmic("", [5e9, 2e12])), "10¹⁰ 10¹¹ 10¹²");
        assert_eq!(logarithmic("", [f32::MIN_POSITIVE, f32::MAX]).ticks().len(), 76);
        // Nothing can be drawn, and nothing is.
        assert_eq!(labels(logarithmic("", [-1.0, -0.5])), "");
        assert_eq!(labels(logarithmic("", [f32::NAN, 1.0])), "");
    }

    #[test]
    fn equal_ratios_are_equally_long() {
        let axis = logarithmic("", [100.0, 1e7]);
        assert_eq!((axis.share(100.0), axis.share(1e7)), (0.0, 1.0));
        for (i, value) in (0_u8..).zip([1e2, 1e3, 1e4, 1e5, 1e6, 1e7]) {
            assert!((axis.share(value) - f32::from(i) / 5.0).abs() < 1e-6, "{value}");
        }
        assert!((axis.share(10.0) + 0.2).abs() < 1e-6);
        assert!((axis.share(axis.middle()) - 0.5).abs() < 1e-6);
    }
}
