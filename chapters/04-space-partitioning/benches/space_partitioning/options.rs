//! The options of the benchmark.

use clap::{Arg, ArgAction, Command, builder::PossibleValuesParser, value_parser};
use space_partitioning::scenes;

/// What is measured.
pub(crate) struct Options {
    /// Name of the scene's generator.
    pub(crate) scene: String,
    /// About how many triangles it has.
    pub(crate) triangles: u32,
    /// How many rays of a kind are traced.
    pub(crate) rays: u32,
    /// How often.
    pub(crate) rounds: u32,
}

impl Options {
    pub(crate) fn parse() -> Result<Self, clap::Error> {
        let number = |name: &'static str, most: i64, help: &'static str| {
            Arg::new(name).long(name).value_name("N").value_parser(value_parser!(u32).range(1..=most)).help(help)
        };
        let matches = Command::new("cargo bench -p space-partitioning --")
            .about(
                "Compares the structures of chapter 4 with each other, with the crates obvhs and bvh, and with Embree.",
            )
            .arg(
                Arg::new("scene")
                    .long("scene")
                    .value_name("NAME")
                    .value_parser(PossibleValuesParser::new(scenes::NAMES))
                    .help("Which scene [default: interior]"),
            )
            .arg(number("triangles", 20_000_000, "About how many triangles [default: 1000000]"))
            .arg(number("rays", 10_000_000, "How many rays [default: 300000]"))
            .arg(number("rounds", 100, "How often all rays are traced [default: 7]"))
            .arg(Arg::new("bench").long("bench").action(ArgAction::SetTrue).hide(true))
            .try_get_matches()?;
        // Cargo says --bench. Where it does not, as in `cargo test --all-targets`, the benchmark is only tried out.
        let is_bench = matches.get_flag("bench");
        let number = |name: &str, usual: u32, tried: u32| {
            matches.get_one(name).copied().unwrap_or(if is_bench { usual } else { tried })
        };
        Ok(Self {
            scene: matches.get_one::<String>("scene").cloned().unwrap_or_else(|| "interior".into()),
            triangles: number("triangles", 1_000_000, 1_000),
            rays: number("rays", 300_000, 1_000),
            rounds: number("rounds", 7, 1),
        })
    }
}
