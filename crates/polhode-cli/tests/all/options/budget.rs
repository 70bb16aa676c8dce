//! Option pairs of `polhode budget`.

use crate::options::{Choice, Subcommand, every_pair_is_honoured_or_refused};

const BOTH: &[&str] = &["budget", "budget again"];
const FIRST: &[&str] = &["budget"];
const OVER_TIME: &[&str] = &["budget over time"];
const ALL: &[&str] = &["budget", "budget again", "budget over time"];
const AGAIN: &[&str] = &["budget again"];

const fn choice(
    option: &'static str,
    arguments: &'static [&'static str],
    inputs: &'static [&'static str],
) -> Choice {
    Choice { option, arguments, inputs, needs: &[] }
}

static BUDGET: Subcommand = Subcommand {
    name: "budget",
    inputs: &[
        ("budget", &["cubesat.csv"]),
        ("budget again", &["cubesat.csv"]),
        ("budget over time", &["sounding-rocket.xlsx"]),
    ],
    options: &[
        choice("--root", &["--root", "."], ALL),
        choice("--basis", &["--basis", "basic"], ALL),
        choice("--about", &["--about", "0,0,1 cm"], BOTH),
        choice("--along", &["--along", "1,0.1,0,0"], BOTH),
        choice("--draws", &["--draws", "20"], BOTH),
        choice("--seed", &["--seed", "7"], BOTH),
        choice("--configuration", &["--configuration", "stowed"], BOTH),
        choice("--diff", &["--diff", "before.csv"], BOTH),
        choice("--json", &["--json"], BOTH),
        choice("--markdown", &["--markdown"], BOTH),
        choice("--html", &["--html"], BOTH),
        choice("--csv", &["--csv"], BOTH),
        choice("--xlsx", &["--xlsx", "out.xlsx"], FIRST),
        Choice { needs: &["+--configuration"], ..choice("--body", &["--body"], BOTH) },
        Choice { needs: &["+--configuration"], ..choice("--sweep", &["--sweep", "plan.toml"], FIRST) },
        choice("--scenario", &["--scenario", "out.toml"], OVER_TIME),
        Choice { needs: &["--xlsx"], ..choice("--force", &["--force"], AGAIN) },
        choice("--strict", &["--strict"], BOTH),
    ],
    independent: &[(
        "--root",
        "*",
        "it allows files elsewhere, and these lists name none; budget::confined has some",
    )],
};

#[test]
fn pairs_of_budget() {
    every_pair_is_honoured_or_refused(&BUDGET);
}
