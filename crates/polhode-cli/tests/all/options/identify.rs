//! The pairs of `polhode identify`.

use crate::options::{Choice, Subcommand, every_pair_is_honoured_or_refused};

const MEASURED: &[&str] = &["measured"];

const fn choice(option: &'static str, arguments: &'static [&'static str]) -> Choice {
    Choice { option, arguments, inputs: MEASURED, needs: &[] }
}

/// What a tumble does not show.
const fn size(
    option: &'static str,
    arguments: &'static [&'static str],
    needs: &'static [&'static str],
) -> Choice {
    Choice { option, arguments, inputs: &["thrown"], needs }
}

static IDENTIFY: Subcommand = Subcommand {
    name: "identify",
    inputs: &[("measured", &["payload.toml"]), ("thrown", &["thrown.toml"])],
    options: &[
        choice("--json", &["--json"]),
        choice("--markdown", &["--markdown"]),
        choice("--html", &["--html"]),
        choice("--body", &["--body"]),
        Choice { inputs: &["measured", "thrown"], ..choice("--strict", &["--strict"]) },
        size("--mass", &["--mass", "350 g"], &["--body", "--greatest-moment"]),
        size("--greatest-moment", &["--greatest-moment", "0.0166 kg m^2"], &["--body", "--mass"]),
    ],
    independent: &[],
};

#[test]
fn pairs_of_identify() {
    every_pair_is_honoured_or_refused(&IDENTIFY);
}
