//! Option pairs of the subcommands that compute motions.

use crate::options::{Choice, Subcommand, every_pair_is_honoured_or_refused};

const fn choice(
    option: &'static str,
    arguments: &'static [&'static str],
    inputs: &'static [&'static str],
    needs: &'static [&'static str],
) -> Choice {
    Choice { option, arguments, inputs, needs }
}

/// Inputs for runs; `long` ones have many samples and a cheap error estimate.
const RUNS: &[&str] = &["fresh", "ran before", "long", "long before"];
const OLD_FOLDER: &str = "a folder that is not there is written with and without it";

static SIMULATE: Subcommand = Subcommand {
    name: "simulate",
    inputs: &[
        ("fresh", &["body.toml"]),
        ("ran before", &["body.toml"]),
        ("long", &["body.toml"]),
        ("long before", &["body.toml"]),
    ],
    options: &[
        choice("--output", &["--output", "other"], RUNS, &[]),
        choice("--force", &["--force"], &["ran before", "long before"], &[]),
        choice("--table", &["--table", "csv"], RUNS, &[]),
        choice("--no-page", &["--no-page"], RUNS, &[]),
        choice("--open", &["--open"], RUNS, &[]),
        choice("--error", &["--error"], &["long", "long before"], &[]),
        choice("--at", &["--at", "0.01"], RUNS, &[]),
        choice("--verbose", &["--verbose"], RUNS, &[]),
        choice("--json", &["--json"], RUNS, &[]),
        choice("--plot", &["--plot", "omega=omega.svg"], RUNS, &[]),
    ],
    independent: &[
        ("--force", "--output", OLD_FOLDER),
        ("--json", "--open", "the browser is opened with and without it"),
        ("--json", "--verbose", "JSON has the details with and without it"),
    ],
};

/// Inputs: a scenario; ω without moments; moments without ω; unphysical moments; the same without
/// ω; a scenario with old results.
const SPINS: &[&str] = &["fresh", "spun before", "rate", "unphysical", "bare", "unphysical bare", "moments"];

static SPIN: Subcommand = Subcommand {
    name: "spin",
    inputs: &[
        ("fresh", &["body.toml"]),
        ("spun before", &["body.toml"]),
        ("rate", &["--omega", "0.3,0.5,0.9"]),
        ("moments", &["--moments", "3.0836,3.235,1"]),
        ("unphysical", &["--moments", "1,2,9", "--omega", "0.3,0.5,0.9"]),
        ("unphysical bare", &["--moments", "1,2,9"]),
        ("bare", &[]),
    ],
    options: &[
        choice("--moments", &["--moments", "3.0836,3.235,1"], &["rate", "bare"], &[]),
        choice("--inertia", &["--inertia", "3.0836,3.235,1,0.01,0.02,-0.01"], &["rate", "bare"], &[]),
        choice(
            "--omega",
            &["--omega", "0.4,0.2,1.1"],
            &["fresh", "bare", "moments", "unphysical bare", "spun before"],
            &[],
        ),
        choice("--attitude", &["--attitude", "0.8,0.1,-0.2,0.3"], SPINS, &["+--at"]),
        choice(
            "--allow-unphysical",
            &["--allow-unphysical"],
            &["unphysical", "unphysical bare", "moments"],
            &[],
        ),
        choice("--at", &["--at", "0.5 s, 1 s"], SPINS, &[]),
        choice("--at-file", &["--at-file", "times.txt"], SPINS, &[]),
        choice("--periods", &["--periods", "7.40 d, 5.38 d"], &["moments", "bare"], &["--convention"]),
        choice("--convention", &["--convention", "long"], &["moments", "bare"], &["--periods"]),
        choice("--verbose", &["--verbose"], SPINS, &[]),
        choice("--json", &["--json"], SPINS, &[]),
        choice("--duration", &["--duration", "2 s"], SPINS, &[]),
        choice("--samples", &["--samples", "21"], SPINS, &["--duration"]),
        choice("--every", &["--every", "0.3 s"], SPINS, &["--duration"]),
        choice("--table", &["--table", "csv"], SPINS, &["--duration"]),
        choice("--curves", &["--curves"], SPINS, &[]),
        choice("--chord-error", &["--chord-error", "1e-2"], SPINS, &["--curves"]),
        choice("--html", &["--html=page.html"], SPINS, &[]),
        choice("--no-page", &["--no-page"], SPINS, &["--duration"]),
        choice("--output", &["--output", "other"], SPINS, &[]),
        choice("--force", &["--force"], &["spun before"], &["--duration"]),
        choice("--plot", &["--plot", "omega=omega.svg"], SPINS, &[]),
    ],
    independent: &[
        ("--force", "--output", OLD_FOLDER),
        ("--force", "--moments", OLD_FOLDER),
        ("--force", "--inertia", OLD_FOLDER),
        ("--force", "--allow-unphysical", OLD_FOLDER),
        ("--moments", "--allow-unphysical", "moments that a body has need no leave"),
        ("--json", "--verbose", "JSON has the details with and without it"),
    ],
};

static STABILITY: Subcommand = Subcommand {
    name: "stability",
    inputs: &[("fresh", &["body.toml"])],
    options: &[
        choice("--verbose", &["--verbose"], &["fresh"], &[]),
        choice("--json", &["--json"], &["fresh"], &[]),
    ],
    independent: &[("--json", "--verbose", "JSON has the details with and without it")],
};

const GIVEN: &[&str] = &["given", "table there"];

static TORQUE: Subcommand = Subcommand {
    name: "torque",
    inputs: &[("given", &["slew.toml"]), ("table there", &["slew.toml"])],
    options: &[
        choice("--at", &["--at", "12.5 s"], GIVEN, &[]),
        choice("--point", &["--point", "0.5, 0.1, 0.2, 0.3"], GIVEN, &[]),
        choice("--table", &["--table", "parquet"], GIVEN, &[]),
        choice("--output", &["--output", "other.csv"], GIVEN, &[]),
        choice("--force", &["--force"], &["table there"], &["--table"]),
        choice("--verbose", &["--verbose"], GIVEN, &[]),
        choice("--json", &["--json"], GIVEN, &[]),
    ],
    independent: &[
        ("--force", "--output", OLD_FOLDER),
        ("--json", "--verbose", "JSON has the details with and without it"),
    ],
};

static EXPLAIN: Subcommand = Subcommand {
    name: "explain",
    inputs: &[("fresh", &["body.toml"]), ("none", &[])],
    options: &[
        choice("--derive", &["--derive", "cones"], &["none"], &[]),
        choice("--lagrangian", &["--lagrangian"], &["fresh"], &[]),
        choice("--hamiltonian", &["--hamiltonian"], &["fresh"], &[]),
        choice("--markdown", &["--markdown"], &["fresh"], &[]),
        choice("--html", &["--html"], &["fresh"], &[]),
        choice("--latex", &["--latex"], &["fresh"], &[]),
        choice("--json", &["--json"], &["fresh"], &[]),
        choice("--width", &["--width", "60"], &["fresh"], &[]),
    ],
    independent: &[("--derive", "*", "it prints a derivation in place of the solution of a scenario")],
};

static EXERCISE: Subcommand = Subcommand {
    name: "exercise",
    inputs: &[("topic", &["box-about-corner"]), ("graded", &["--answers", "mine.toml"])],
    options: &[
        choice("--seed", &["--seed", "7"], &["topic"], &[]),
        choice("--symbols", &["--symbols"], &["topic"], &[]),
        choice("--answers", &["--answers", "mine.toml"], &["topic"], &[]),
        choice("--solution", &["--solution"], &["topic", "graded"], &[]),
        choice("--markdown", &["--markdown"], &["topic", "graded"], &[]),
        choice("--html", &["--html"], &["topic", "graded"], &[]),
        choice("--latex", &["--latex"], &["topic", "graded"], &[]),
        choice("--json", &["--json"], &["topic", "graded"], &[]),
        choice("--width", &["--width", "60"], &["topic", "graded"], &[]),
    ],
    independent: &[
        ("--answers", "--seed", "the file states its seed; another one is refused"),
        ("--answers", "--symbols", "the file states whether it is in symbols; the contrary is refused"),
    ],
};

const PLANS: &[&str] = &["fresh", "swept before"];

static SWEEP: Subcommand = Subcommand {
    name: "sweep",
    inputs: &[("fresh", &["plan.toml"]), ("swept before", &["plan.toml"])],
    options: &[
        choice("--output", &["--output", "other"], PLANS, &[]),
        choice("--resume", &["--resume"], &["swept before"], &[]),
        choice("--force", &["--force"], &["swept before"], &[]),
        choice("--threads", &["--threads", "1"], PLANS, &[]),
        choice("--json", &["--json"], PLANS, &[]),
        choice("--html", &["--html"], PLANS, &[]),
        choice("--on", &["--on", "dask://local"], PLANS, &[]),
    ],
    independent: &[
        ("--resume", "--output", OLD_FOLDER),
        ("--force", "--output", OLD_FOLDER),
        ("--threads", "--output", "the files are the same for every number of threads"),
        ("--threads", "--resume", "the files are the same for every number of threads"),
        ("--threads", "--force", "the files are the same for every number of threads"),
        ("--threads", "--json", "the files are the same for every number of threads"),
        ("--threads", "--html", "the files are the same for every number of threads"),
    ],
};

#[test]
fn pairs_of_simulate() {
    every_pair_is_honoured_or_refused(&SIMULATE);
}

#[test]
fn pairs_of_spin() {
    every_pair_is_honoured_or_refused(&SPIN);
}

#[test]
fn pairs_of_stability() {
    every_pair_is_honoured_or_refused(&STABILITY);
}

#[test]
fn pairs_of_torque() {
    every_pair_is_honoured_or_refused(&TORQUE);
}

#[test]
fn pairs_of_explain() {
    every_pair_is_honoured_or_refused(&EXPLAIN);
}

#[test]
fn pairs_of_exercise() {
    every_pair_is_honoured_or_refused(&EXERCISE);
}

#[test]
fn pairs_of_sweep() {
    every_pair_is_honoured_or_refused(&SWEEP);
}
