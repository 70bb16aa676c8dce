//! Option pairs of `polhode identify`.

use crate::options::{Choice, Subcommand, every_pair_is_honoured_or_refused};

const MEASURED: &[&str] = &["measured"];
const THROWN: &[&str] = &["thrown"];
const HUNG: &[&str] = &["hung"];
const TESTED: &[&str] = &["measured", "thrown"];
const PLANNED: &[&str] = &["thrown", "hung"];
const ANY: &[&str] = &["measured", "thrown", "hung"];

/// Options required for a test on two wires.
const BIFILAR: &[&str] =
    &["--bifilar", "--mass", "--distance", "--length", "--swings", "--time", "--amplitude"];

/// Options for quantities that a throw does not determine.
const SIZE: &[&str] = &["--greatest-moment", "0.0166 kg m^2", "--mass", "350 g"];

const fn choice(
    option: &'static str,
    arguments: &'static [&'static str],
    inputs: &'static [&'static str],
) -> Choice {
    Choice { option, arguments, inputs, needs: &[] }
}

const fn of_swings(option: &'static str, arguments: &'static [&'static str]) -> Choice {
    Choice { option, arguments, inputs: HUNG, needs: BIFILAR }
}

static IDENTIFY: Subcommand = Subcommand {
    name: "identify",
    inputs: &[("measured", &["payload.toml"]), ("thrown", &["gyro.csv"]), ("hung", &[])],
    options: &[
        choice("--json", &["--json"], ANY),
        choice("--markdown", &["--markdown"], ANY),
        choice("--html", &["--html"], ANY),
        choice("--body", &["--body"], MEASURED),
        Choice { needs: &["--body"], ..choice("--greatest-moment", SIZE, THROWN) },
        choice("--strict", &["--strict"], TESTED),
        choice("--columns", &["--columns", "omega = gyro_y gyro_z gyro_x"], THROWN),
        choice("--whole", &["--whole"], THROWN),
        choice("--drag", &["--drag", "linear"], THROWN),
        choice("--print-plan", &["--print-plan"], PLANNED),
        of_swings("--bifilar", &["--bifilar"]),
        of_swings("--mass", &["--mass", "1.7 kg ± 1 g"]),
        of_swings("--distance", &["--distance", "30 cm"]),
        of_swings("--length", &["--length", "2 m"]),
        of_swings("--swings", &["--swings", "20"]),
        of_swings("--time", &["--time", "32.8 s +- 0.1 s"]),
        of_swings("--amplitude", &["--amplitude", "9 deg +- 1 deg"]),
        of_swings("--gravity", &["--gravity", "9.81 m/s^2"]),
        choice("--trifilar", &["--trifilar"], HUNG),
        choice("--pendulum", &["--pendulum"], HUNG),
    ],
    independent: &[
        ("--whole", "*", "the log of the others has four flights, and is refused as one"),
        ("--trifilar", "*", "it stands in the place of --bifilar"),
        ("--pendulum", "*", "it stands in the place of --bifilar"),
    ],
};

#[test]
fn pairs_of_identify() {
    every_pair_is_honoured_or_refused(&IDENTIFY);
}
