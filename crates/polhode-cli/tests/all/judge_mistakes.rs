//! `polhode judge`: mistakes that resemble another convention, and logs that cannot be judged.

use std::fs;

use serde_json::Value;

use crate::common::{Scratch, number, refused, stdout};
use crate::judge::{SCENARIO, blamed, exact, only_run, table};

const HEAD: &str = "t,qw,qx,qy,qz,wx,wy,wz";
const OWN: &str = "time_s,attitude_w,attitude_x,attitude_y,attitude_z,omega_body_x_rad_s,omega_body_y_rad_s,omega_body_z_rad_s";

/// Returns text without line breaks.
fn unwrapped(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

fn reading(scratch: &Scratch, log: &str) -> Value {
    let output = scratch.run(&["judge", "tumbling.toml", log, "--json"]);
    let report: Value = serde_json::from_slice(&output.stdout).unwrap();
    only_run(&report)["reading"].clone()
}

/// The program uses deg/s as rad/s. Its motion is correct but 57.3 times too slow; it is not a log
/// in minutes.
#[test]
fn a_program_that_is_given_degrees_is_refused() {
    let scratch = Scratch::new("judge-degrees");
    let slow = [0.5_f64, -1.3, 0.7].map(f64::to_radians);
    let slow = SCENARIO.replace("[0.5, -1.3, 0.7]", &format!("{slow:?}"));
    for (duration, rows) in [("1.5", 76), ("8", 401)] {
        let text = slow.replace("duration = 8", &format!("duration = {duration}"));
        scratch.write("slow.toml", &text.replace("samples = 401", &format!("samples = {rows}")));
        let simulate = ["simulate", "slow.toml", "-o", "slow", "--table", "csv", "--no-page", "--force"];
        stdout(&scratch.run(&simulate));
        scratch.write("tumbling.toml", SCENARIO);
        let table = fs::read_to_string(scratch.0.join("slow/trajectory.csv")).unwrap();
        let lines = |count: usize| {
            let line = |line: &str| line.split(',').take(count).collect::<Vec<_>>().join(",") + "\n";
            table.lines().skip(1).map(line).collect::<String>()
        };
        for (head, count) in [(OWN, 8), (HEAD, 8), ("t,qw,qx,qy,qz", 5)] {
            scratch.write("degrees.csv", &format!("{head}\n{}", lines(count)));
            let error = refused(&scratch.run(&["judge", "tumbling.toml", "degrees.csv"]), 2);
            assert!(error.contains("the run rotates 0.017"), "{error}");
            assert!(error.contains("deg/s for rad/s"), "{error}");
        }
    }
}

/// Rows are stated to begin at the scenario's start, but begin later. The shift is identified for
/// any row spacing.
#[test]
fn rows_that_are_late_are_named() {
    let scratch = Scratch::new("judge-late");
    let rows = exact(&scratch);
    let every: Vec<Vec<f64>> = rows.iter().step_by(4).cloned().collect();
    for (rows, late) in [(&rows, 1), (&rows, 10), (&every, 1), (&every, 30)] {
        let late_rows = |count: usize| -> Vec<Vec<f64>> {
            let pairs = rows.iter().zip(&rows[late..]);
            pairs.map(|(stated, row)| [&stated[..1], &row[1..count]].concat()).collect()
        };
        for (head, count) in [(OWN, 8), ("t,qw,qx,qy,qz", 5)] {
            scratch.write("late.csv", &table(head, &late_rows(count)));
            let text = unwrapped(&blamed(&scratch.run(&["judge", "tumbling.toml", "late.csv"])));
            let shift = rows[late][0] - rows[0][0];
            let expected = format!("each row has the motion of {shift:.6} s after its stated time");
            assert!(text.contains(&expected), "{text}");
        }
    }
}

#[test]
fn a_mirrored_omega_is_named() {
    let scratch = Scratch::new("judge-mirrored");
    let rows = exact(&scratch);
    let signs = |signs: [f64; 3]| -> Vec<Vec<f64>> {
        let row = |r: &Vec<f64>| [&r[..5], &[0, 1, 2].map(|k| signs[k] * r[5 + k])].concat();
        rows.iter().map(row).collect()
    };
    for (components, expected) in [([-1.0, -1.0, -1.0], "(−x, −y, −z)"), ([1.0, -1.0, 1.0], "(x, −y, z)")]
    {
        for head in [HEAD, OWN] {
            scratch.write("run.csv", &table(head, &signs(components)));
            let text =
                unwrapped(&blamed(&scratch.run(&["judge", "tumbling.toml", "run.csv", "--limit", "10"])));
            assert!(text.contains(&format!("ω has the components {expected}")), "{text}");
            let reading = reading(&scratch, "run.csv");
            assert_eq!(reading["against_names"], true);
            assert_eq!(reading["mistakes"].as_array().unwrap().len(), 1);
        }
    }
    // Axes rotated by π about y are still right-handed.
    scratch.write("run.csv", &table(HEAD, &signs([-1.0, 1.0, -1.0])));
    stdout(&scratch.run(&["judge", "tumbling.toml", "run.csv"]));
    assert_eq!(reading(&scratch, "run.csv")["omega_components"], "(−x, y, −z)");
    // An ω too large by a fifth fits only one reading, which is judged.
    scratch.write("run.csv", &table(HEAD, &signs([1.2, 1.2, 1.2])));
    let text = unwrapped(&blamed(&scratch.run(&["judge", "tumbling.toml", "run.csv"])));
    assert!(text.contains("ω error at most 0.2"), "{text}");
}

/// Names that state a unit or order are contradicted by numbers in another one; names without a
/// statement are not.
#[test]
fn names_that_the_numbers_contradict_are_reported() {
    let scratch = Scratch::new("judge-names");
    let rows = exact(&scratch);
    let own = |change: &dyn Fn(&[f64]) -> Vec<f64>| rows.iter().map(|row| change(row)).collect::<Vec<_>>();
    let degrees = own(&|r| [&r[..5], &[r[5].to_degrees(), r[6].to_degrees(), r[7].to_degrees()]].concat());
    let milliseconds = own(&|r| [&[1e3 * r[0]], &r[1..]].concat());
    let swapped = rows.clone();
    for (head, rows, is_against) in [
        (OWN, &degrees, true),
        (HEAD, &degrees, false),
        (OWN, &milliseconds, true),
        (HEAD, &milliseconds, false),
        ("t,qx,qy,qz,qw,wx,wy,wz", &swapped, true),
        (HEAD, &swapped, false),
    ] {
        scratch.write("run.csv", &table(head, rows));
        stdout(&scratch.run(&["judge", "tumbling.toml", "run.csv"]));
        assert_eq!(reading(&scratch, "run.csv")["against_names"], is_against, "{head}");
    }
    // Numbers in the order w, x, y, z under the names x, y, z, w.
    scratch.write("run.csv", &table("t,qx,qy,qz,qw,wx,wy,wz", &swapped));
    let reading = reading(&scratch, "run.csv");
    assert_eq!(reading["found"]["quaternion"], "wxyz");
    assert!(number(&reading["tried"][0]["attitude_rad"]) < 1e-12, "{reading}");
}

/// A log that names a scenario which may not be opened counts as a run of another one, unless it is
/// the given path.
#[test]
fn a_scenario_that_cannot_be_compared_is_another_one() {
    let scratch = Scratch::new("judge-elsewhere");
    let rows: Vec<Vec<f64>> = exact(&scratch).iter().map(|r| r[..5].to_vec()).collect();
    for folder in ["one", "two"] {
        fs::create_dir(scratch.0.join(folder)).unwrap();
        scratch.write(&format!("{folder}/tumbling.toml"), SCENARIO);
    }
    let log = |scenario: &str| {
        let head = format!("# scenario = \"{scenario}\"\nt,qw,qx,qy,qz");
        scratch.write("one/run.csv", &table(&head, &rows));
    };
    let given =
        |scenario: &str, more: &[&str]| scratch.run(&[&["judge", scenario, "one/run.csv"], more].concat());
    for (named, hint) in
        [("../two/tumbling.toml", "--root DIR"), ("missing/tumbling.toml", "correct the line")]
    {
        log(named);
        let error = refused(&given("one/tumbling.toml", &[]), 2);
        assert!(
            error.contains(&format!("the log names the scenario {named:?}")) && error.contains(hint),
            "{error}"
        );
    }
    log("../two/tumbling.toml");
    stdout(&given("two/tumbling.toml", &[]));
    stdout(&given("one/tumbling.toml", &["--root", "two"]));
    scratch.write("two/tumbling.toml", &SCENARIO.replace("3.1", "3.2"));
    let error = refused(&given("one/tumbling.toml", &["--root", "two"]), 2);
    assert!(error.contains("the log names the scenario \"../two/tumbling.toml\""), "{error}");
    log("tumbling.toml");
    stdout(&given("one/tumbling.toml", &[]));
    // Invalid roots.
    for root in ["nowhere", "tumbling.toml"] {
        let error = refused(&given("one/tumbling.toml", &["--root", root]), 2);
        assert!(error.contains(root) && error.contains("a root must be a folder:"), "{error}");
    }
}

/// Opening a pipe may block forever. Files named by a log or its scenario must be regular files.
#[cfg(unix)]
#[test]
fn a_pipe_that_a_log_names_is_not_opened() {
    let scratch = Scratch::new("judge-pipe");
    let rows: Vec<Vec<f64>> = exact(&scratch).iter().map(|r| r[..5].to_vec()).collect();
    for name in ["pipe.toml", "pipe.stl"] {
        let made = std::process::Command::new("mkfifo").arg(scratch.0.join(name)).status().unwrap();
        assert!(made.success());
    }
    let mesh = SCENARIO.replace(
        "shape = \"tensor\"\nmass = 2.3\ninertia = [[3.1, 0.4, -0.3], [0.4, 4.2, 0.2], [-0.3, 0.2, 5.3]]\n",
        "shape = \"mesh\"\nfile = \"pipe.stl\"\nmass = 2.3\n",
    );
    assert!(mesh.contains("pipe.stl"));
    scratch.write("mesh.toml", &mesh);
    for (named, arguments) in [
        ("pipe.toml", &["judge", "run.csv"][..]),
        ("pipe.toml", &["judge", "tumbling.toml", "run.csv"]),
        ("mesh.toml", &["judge", "run.csv"]),
    ] {
        scratch.write("run.csv", &table(&format!("# scenario = \"{named}\"\nt,qw,qx,qy,qz"), &rows));
        let error = refused(&scratch.run(arguments), 2);
        assert!(error.contains("regular file"), "{named}: {error}");
    }
}
