//! The pairs of `polhode identify`.

use crate::options::{Choice, Subcommand, every_pair_is_honoured_or_refused};

const MEASURED: &[&str] = &["measured"];

const fn choice(option: &'static str, arguments: &'static [&'static str]) -> Choice {
    Choice { option, arguments, inputs: MEASURED, needs: &[] }
}

static IDENTIFY: Subcommand = Subcommand {
    name: "identify",
    inputs: &[("measured", &["payload.toml"])],
    options: &[
        choice("--json", &["--json"]),
        choice("--markdown", &["--markdown"]),
        choice("--html", &["--html"]),
        choice("--body", &["--body"]),
        choice("--strict", &["--strict"]),
    ],
    independent: &[],
};

#[test]
fn pairs_of_identify() {
    every_pair_is_honoured_or_refused(&IDENTIFY);
}
