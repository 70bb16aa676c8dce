//! `polhode judge` without a scenario file: `--moments` and `--against`.

use std::fs;

use crate::common::{Scratch, refused, stdout};
use crate::judge::blamed;

/// A table of `spin` is right by the same moments, and wrong by others.
#[test]
fn a_log_is_judged_by_the_moments_of_its_body() {
    let scratch = Scratch::new("judge-moments");
    let spin =
        ["spin", "--moments", "1.3,2.9,2.1", "--omega", "0.7,-0.4,1.1", "--attitude", "0.6,-0.3,0.5,0.2"];
    stdout(
        &scratch.run(
            &[&spin[..], &["--duration", "8", "--samples", "401", "--table", "csv", "-o", "run"]].concat(),
        ),
    );
    let text = stdout(&scratch.run(&["judge", "run/trajectory.csv", "--moments", "1.3,2.9,2.1"]));
    assert!(text.starts_with("Free body, moments 1.3, 2.9, 2.1 kg·m²: trajectory.csv"), "{text}");
    assert!(text.contains("→ Correct: no error above"), "{text}");
    // Only the ratios of the moments matter.
    stdout(&scratch.run(&[
        "judge",
        "run/trajectory.csv",
        "--moments",
        "(13, 29, 21) kg cm^2",
        "--limit",
        "1e-12",
    ]));
    let text = blamed(&scratch.run(&["judge", "run/trajectory.csv", "--moments", "1.3,2.1,2.9"]));
    assert!(text.contains("→ Attitude error"), "{text}");

    let table = fs::read_to_string(scratch.0.join("run/trajectory.csv")).unwrap();
    let attitudes: String = table
        .lines()
        .map(|line| {
            let cells: Vec<&str> = line.split(',').take(5).collect();
            format!("{}\n", cells.join(","))
        })
        .collect();
    scratch.write("attitudes.csv", &attitudes);
    let message = refused(&scratch.run(&["judge", "attitudes.csv", "--moments", "1.3,2.9,2.1"]), 2);
    assert!(message.contains("has no angular velocity") && message.contains("--start-omega"), "{message}");
    let start = ["--start-omega", "0.7,-0.4,1.1", "--limit", "1e-12"];
    stdout(&scratch.run(&[&["judge", "attitudes.csv", "--moments", "1.3,2.9,2.1"][..], &start].concat()));
    let suite = ["judge", "--write-suite", "suite", "--moments", "1,2,3"];
    assert!(refused(&scratch.run(&suite), 2).contains("--write-suite"));
    let message = refused(&scratch.run(&["judge", "run/trajectory.csv", "--moments", "1,2"]), 2);
    assert!(message.contains("expected 3 numbers"), "{message}");
}

/// The difference from another log is that of the first rows.
#[test]
fn a_log_is_compared_with_another() {
    let scratch = Scratch::new("judge-against");
    let table = |name: &str, attitude: &str| {
        let spin = ["spin", "--moments", "1.3,2.9,2.1", "--omega", "0.7,-0.4,1.1", "--attitude", attitude];
        stdout(&scratch.run(
            &[&spin[..], &["--duration", "8", "--samples", "401", "--table", "csv", "-o", name]].concat(),
        ));
    };
    table("old", "1,0,0,0");
    // 0.02 rad about z: a right limit passes, a smaller one does not.
    table("new", "0.999950000416665,0,0,0.00999983333416666");
    let text = stdout(&scratch.run(&[
        "judge",
        "new/trajectory.csv",
        "--against",
        "old/trajectory.csv",
        "--limit",
        "0.021",
    ]));
    assert!(
        text.contains("→ Attitude difference 0.02 rad at the end, at most 0.02 rad; does not grow"),
        "{text}"
    );
    assert!(text.contains("rotated in space by (") && text.contains("--moments A,B,C"), "{text}");
    let page = blamed(&scratch.run(&[
        "judge",
        "new/trajectory.csv",
        "--against",
        "old/trajectory.csv",
        "--moments",
        "1.3,2.9,2.1",
        "--html",
    ]));
    assert!(page.contains("<svg") && page.contains("direction of L"));
    let text = stdout(&scratch.run(&["judge", "old/trajectory.csv", "--against", "old/trajectory.csv"]));
    assert!(text.contains("→ No difference above 3.6e-15 rad"), "{text}");
    let message = refused(&scratch.run(&["judge", "old/trajectory.csv", "--against", "missing.csv"]), 2);
    assert!(message.contains("missing.csv"), "{message}");
}
