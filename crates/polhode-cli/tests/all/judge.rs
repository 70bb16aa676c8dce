//! `polhode judge`: runs of other programs, with planted errors and from stored logs.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use polhode_judge::suite::CASES;
use serde_json::Value;

use crate::common::{Scratch, entries, example, json, number, numbers, refused, stdout};
use crate::options::options_of;

pub(crate) const SCENARIO: &str = "title = \"Tumbling\"\n[[body.part]]\nshape = \"tensor\"\nmass = 2.3\n\
    inertia = [[3.1, 0.4, -0.3], [0.4, 4.2, 0.2], [-0.3, 0.2, 5.3]]\n\
    [start]\nattitude = { quaternion = [0.6, -0.3, 0.5, 0.2] }\nspin = { body = [0.5, -1.3, 0.7] }\n\
    [run]\nduration = 8\nsamples = 401\n";

/// Returns the exact motion as rows of time, quaternion and ω, body axes.
pub(crate) fn exact(scratch: &Scratch) -> Vec<Vec<f64>> {
    scratch.write("tumbling.toml", SCENARIO);
    stdout(&scratch.run(&["simulate", "tumbling.toml", "-o", "exact", "--table", "csv", "--no-page"]));
    let text = fs::read_to_string(scratch.0.join("exact/trajectory.csv")).unwrap();
    text.lines().skip(1).map(|line| line.split(',').take(8).map(|x| x.parse().unwrap()).collect()).collect()
}

pub(crate) fn table(head: &str, rows: &[Vec<f64>]) -> String {
    let mut text = format!("{head}\n");
    for row in rows {
        let cells: Vec<String> = row.iter().map(|x| format!("{x:?}")).collect();
        writeln!(text, "{}", cells.join(",")).unwrap();
    }
    text
}

/// Returns the output of a run with a detected mistake, or an error above the limit.
pub(crate) fn blamed(output: &std::process::Output) -> String {
    assert_eq!(output.status.code(), Some(1), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout.clone()).unwrap()
}

pub(crate) fn only_run(report: &Value) -> &Value {
    let [run] = &report["runs"].as_array().unwrap()[..] else { panic!("one run") };
    run
}

#[test]
fn a_table_of_simulate_is_a_run_without_error() {
    let scratch = Scratch::new("judge-own");
    exact(&scratch);
    let report =
        json(&scratch.run(&["judge", "tumbling.toml", "exact/trajectory.csv", "--json", "--limit", "1e-14"]));
    let run = only_run(&report);
    assert_eq!(run["reading"]["found"]["quaternion"], "wxyz");
    assert_eq!((&run["reading"]["omega_axes"], &run["step_is_said"]), (&"body".into(), &false.into()));
    assert!(number(&run["error"]["attitude_largest_rad"]) < 1e-15);
    assert!(number(&run["error"]["rates"]["omega_relative"]) < 1e-15);
    let text = stdout(&scratch.run(&["judge", "tumbling.toml", "exact/trajectory.csv"]));
    assert!(text.contains("→ Correct: no error above"), "{text}");
}

/// Order, sense, axes and time origin are not stated, and are all detected; a wrong dynamic law is
/// identified.
#[test]
fn what_is_not_said_is_found() {
    let scratch = Scratch::new("judge-found");
    let rows = exact(&scratch);
    // Quaternions x, y, z, w from space to body, from t = 100 s, in text that names its scenario.
    let written: Vec<Vec<f64>> = rows.iter().map(|r| vec![r[0] + 100.0, -r[2], -r[3], -r[4], r[1]]).collect();
    let head =
        "# scenario = \"tumbling.toml\"\n# engine = \"planted\"\n# step = 2 ms\n# stop = 8\nt,q0,q1,q2,q3";
    scratch.write("run.csv", &table(head, &written));
    let report = json(&scratch.run(&["judge", "run.csv", "--json"]));
    let run = only_run(&report);
    assert_eq!((&run["engine"], number(&run["step_s"])), (&"planted".into(), 0.002));
    assert_eq!(run["not_read"][0], "# stop");
    let found = &run["reading"]["found"];
    assert_eq!((&found["quaternion"], &found["sense"]), (&"xyzw".into(), &"space_to_body".into()));
    assert_eq!((number(&found["time_origin_s"]), &found["axes"]), (100.0, &"(x, y, z)".into()));
    assert!(number(&run["error"]["attitude_largest_rad"]) < 1e-12);
    let tried = run["reading"]["tried"].as_array().unwrap();
    assert!(tried.len() >= 8 && number(&tried[1]["attitude_rad"]) > 0.01, "{tried:?}");

    // Without ω × I ω the body rotates about one fixed axis.
    let omega = [0.5_f64, -1.3, 0.7];
    let rate = omega.iter().map(|w| w * w).sum::<f64>().sqrt();
    let turned = |r: &Vec<f64>| {
        let (half, q) = (0.5 * rate * r[0], &rows[0][1..5]);
        let p = [
            half.cos(),
            omega[0] / rate * half.sin(),
            omega[1] / rate * half.sin(),
            omega[2] / rate * half.sin(),
        ];
        vec![
            r[0],
            q[0] * p[0] - q[1] * p[1] - q[2] * p[2] - q[3] * p[3],
            q[0] * p[1] + q[1] * p[0] + q[2] * p[3] - q[3] * p[2],
            q[0] * p[2] + q[2] * p[0] + q[3] * p[1] - q[1] * p[3],
            q[0] * p[3] + q[3] * p[0] + q[1] * p[2] - q[2] * p[1],
        ]
    };
    let wrong: Vec<Vec<f64>> = rows.iter().map(turned).collect();
    scratch.write("wrong.csv", &table("t,qw,qx,qy,qz", &wrong));
    let output = scratch.run(&["judge", "tumbling.toml", "wrong.csv", "--limit", "0.6 deg"]);
    assert_eq!(output.status.code(), Some(1));
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(text.contains("Most likely cause: the gyroscopic term ω × I ω is missing"), "{text}");
    let page = blamed(&scratch.run(&["judge", "tumbling.toml", "wrong.csv", "--html"]));
    assert!(page.contains("<svg") && page.contains("Attitude error"));
    assert!(
        blamed(&scratch.run(&["judge", "tumbling.toml", "wrong.csv", "--markdown"]))
            .contains("| component |")
    );
}

#[test]
fn runs_of_several_steps_have_an_order() {
    let scratch = Scratch::new("judge-order");
    let rows = exact(&scratch);
    // An error proportional to the square of the step: the clock is fast by a factor 1 + O(h²).
    let mut arguments = vec!["judge".to_owned(), "tumbling.toml".to_owned(), "--json".to_owned()];
    for step in [0.04, 0.02, 0.01] {
        scratch.write(
            "late.toml",
            &SCENARIO.replace("duration = 8", &format!("duration = {:?}", 8.0 * (1.0 + step * step))),
        );
        stdout(&scratch.run(&[
            "simulate",
            "late.toml",
            "-o",
            "late",
            "--table",
            "csv",
            "--no-page",
            "--force",
        ]));
        let text = fs::read_to_string(scratch.0.join("late/trajectory.csv")).unwrap();
        let late = text.lines().skip(1).zip(&rows).map(|(line, row)| {
            let cells: Vec<f64> = line.split(',').take(5).map(|x| x.parse().unwrap()).collect();
            [&[row[0]][..], &cells[1..]].concat()
        });
        let name = format!("h{step}.csv");
        scratch.write(&name, &table(&format!("# step = {step}\nt,qw,qx,qy,qz"), &late.collect::<Vec<_>>()));
        arguments.push(name);
    }
    let output = scratch.run(&arguments.iter().map(String::as_str).collect::<Vec<_>>());
    assert_eq!(output.status.code(), Some(1), "errors above the default limit");
    let report: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    for order in numbers(&report["order_of_accuracy"]["orders"]) {
        assert!((order - 2.0).abs() < 0.05, "{order}");
    }
    for run in report["runs"].as_array().unwrap() {
        let parts = run["split"]["parts"].as_array().unwrap();
        let rate = parts.iter().find(|part| part["part"] == "rate").unwrap();
        let step = number(&run["step_s"]);
        assert!((numbers(&rate["value"])[0] / (step * step) - 1.0).abs() < 0.01, "{rate}");
    }
}

/// Stored logs of engines: each mistake is identified.
#[test]
fn the_stored_runs_are_judged() {
    let scratch = Scratch::new("judge-stored");
    for (name, status, causes, least, most) in [
        ("mujoco-rk4", 0, &["RK4", "to 1e-8 rad"][..], 1e-14, 1e-6),
        ("pybullet-default", 1, &["semi-implicit Euler"], 1e-3, 3.2),
        ("rapier-default", 1, &[""], 1e-4, 3.2),
    ] {
        let path = example(&format!("judge/{name}.csv"));
        let output = scratch.run(&["judge", &path]);
        assert_eq!(output.status.code(), Some(status), "{name}");
        let text = String::from_utf8(output.stdout).unwrap();
        assert!(causes.iter().any(|cause| text.contains(cause)), "{text}");
        let report: Value = serde_json::from_slice(&scratch.run(&["judge", &path, "--json"]).stdout).unwrap();
        let error = number(&only_run(&report)["error"]["attitude_largest_rad"]);
        assert!((least..most).contains(&error), "{name}: {error}");
    }
}

/// Clocks with any origin and unit, under the column names of polhode: the meaning is detected and
/// reported.
#[test]
fn clocks_and_units_that_the_columns_do_not_say_are_found() {
    let scratch = Scratch::new("judge-clocks");
    let rows = exact(&scratch);
    let head = "time_s,attitude_w,attitude_x,attitude_y,attitude_z,omega_body_x_rad_s,omega_body_y_rad_s,omega_body_z_rad_s";
    let judged = |name: &str, change: &dyn Fn(&[f64]) -> Vec<f64>| {
        let text = rows.iter().map(|row| {
            let row = change(row);
            let others: Vec<String> = row[1..].iter().map(|x| format!("{x:?}")).collect();
            format!("{:.6},{}\n", row[0], others.join(","))
        });
        scratch.write(name, &format!("{head}\n{}", text.collect::<String>()));
        let started = std::time::Instant::now();
        let output = scratch.run(&["judge", "tumbling.toml", name, "--json"]);
        assert_eq!(output.status.code(), Some(0), "{name}: {}", String::from_utf8_lossy(&output.stderr));
        assert!(started.elapsed().as_secs() < 20, "{name}");
        let report: Value = serde_json::from_slice(&output.stdout).unwrap();
        let run = only_run(&report).clone();
        let error = &run["error"];
        let latest = number(&run["last_s"]) + number(&run["reading"]["found"]["time_origin_s"]).abs();
        let most = 1e-6 + 1e-15 * latest;
        assert!(number(&error["attitude_largest_rad"]) < most, "{name}: {error}");
        assert!(number(&error["rates"]["omega_relative"]) < most, "{name}: {error}");
        let text = stdout(&scratch.run(&["judge", "tumbling.toml", name]));
        assert!(text.contains("→ Interpreted as "), "{text}");
        // Its lines are wrapped.
        (run["reading"].clone(), text.split_whitespace().collect::<Vec<_>>().join(" "))
    };
    let later = |by: f64| move |row: &[f64]| [&[row[0] + by][..], &row[1..]].concat();
    for origin in [1.7e9, 10.0, 1000.0] {
        let (reading, text) = judged("origin.csv", &later(origin));
        assert_eq!(number(&reading["found"]["time_origin_s"]), origin);
        assert!(text.contains(&format!("times from {origin} s")), "{text}");
        // The same result as with the option.
        let said = format!("{origin}");
        let declared =
            json(&scratch.run(&["judge", "tumbling.toml", "origin.csv", "--json", "--time-origin", &said]));
        assert_eq!(only_run(&declared)["reading"]["found"], reading["found"]);
    }
    let (reading, text) = judged("ms.csv", &|row| [&[1e3 * row[0]][..], &row[1..]].concat());
    assert_eq!(number(&reading["found"]["time_factor"]), 1e-3);
    assert!(text.contains("times × 0.001 (such as ms for s)"), "{text}");
    let (reading, _) = judged("epoch-ms.csv", &|row| [&[1.7e12 + 1e3 * row[0]][..], &row[1..]].concat());
    assert_eq!(
        (number(&reading["found"]["time_factor"]), number(&reading["found"]["time_origin_s"])),
        (1e-3, 1.7e12)
    );
    let degrees = |row: &[f64]| [&row[..5], &[5, 6, 7].map(|k| row[k].to_degrees())[..]].concat();
    let (reading, text) = judged("degrees.csv", &degrees);
    assert!((number(&reading["omega_factor"]).to_degrees() - 1.0).abs() < 1e-15);
    assert!(text.contains("such as deg/s for rad/s"), "{text}");
    let (reading, text) =
        judged("exchanged.csv", &|row| [&row[..5], &[-row[6], row[5], row[7]][..]].concat());
    assert_eq!(reading["omega_components"], "(−y, x, z)");
    assert!(text.contains("components (−y, x, z)"), "{text}");
    // Scalar last and space to body, contrary to the column names.
    let last = |row: &[f64]| vec![row[0], -row[2], -row[3], -row[4], row[1], row[5], row[6], row[7]];
    let (reading, text) = judged("last.csv", &last);
    assert_eq!((&reading["found"]["quaternion"], &reading["against_names"]), (&"xyzw".into(), &true.into()));
    assert!(text.contains("contrary to its column names"), "{text}");
    // A log that begins some time after the start, by another clock.
    let text: String = rows[77..]
        .iter()
        .map(|r| {
            let cells: Vec<String> = r[1..].iter().map(|x| format!("{x:?}")).collect();
            format!("{:?},{}\n", r[0] + 321.5, cells.join(","))
        })
        .collect();
    scratch.write("later.csv", &format!("{head}\n{text}"));
    let run = json(&scratch.run(&["judge", "tumbling.toml", "later.csv", "--json"]));
    let run = only_run(&run);
    assert!((number(&run["reading"]["found"]["time_origin_s"]) - 321.5).abs() < 1e-9, "{run}");
    assert!(number(&run["error"]["attitude_largest_rad"]) < 1e-9);
}

/// A log is data: it can name files in its own folder only, and contents of other files are never
/// printed.
#[test]
fn a_log_opens_nothing_outside_its_folder() {
    let scratch = Scratch::new("judge-confined");
    let rows = exact(&scratch);
    fs::create_dir_all(scratch.0.join("logs/inner")).unwrap();
    for name in ["secret", "secret.stl"] {
        fs::write(scratch.0.join(name), "password = swordfish\n").unwrap();
    }
    fs::rename(scratch.0.join("tumbling.toml"), scratch.0.join("logs/inner/tumbling.toml")).unwrap();
    scratch.write("outside.toml", SCENARIO);
    let body: Vec<Vec<f64>> = rows.iter().map(|r| r[..5].to_vec()).collect();
    let log = |scenario: &str| {
        scratch.write(
            "logs/run.csv",
            &table(&format!("# scenario = \"{scenario}\"\ntime_s,qw,qx,qy,qz"), &body),
        );
    };
    let absolute = scratch.0.join("secret").display().to_string();
    let address = format!("file://{absolute}");
    for named in [
        absolute.as_str(),
        "../secret",
        "../outside.toml",
        "inner/../../secret",
        address.as_str(),
        "/etc/hostname",
    ] {
        log(named);
        let error = refused(&scratch.run(&["judge", "logs/run.csv"]), 2);
        assert!(!error.contains("swordfish"), "{error}");
        assert!(error.contains("is not opened: ") && error.contains("run.csv"), "{named}: {error}");
    }
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink(scratch.0.join("secret"), scratch.0.join("logs/link.toml")).unwrap();
        log("link.toml");
        assert!(refused(&scratch.run(&["judge", "logs/run.csv"]), 2).contains("lies outside"));
    }
    log("inner/tumbling.toml");
    stdout(&scratch.run(&["judge", "logs/run.csv"]));
    log("../outside.toml");
    let error = refused(&scratch.run(&["judge", "logs/run.csv"]), 2);
    assert!(error.contains("--root DIR"), "{error}");
    stdout(&scratch.run(&["judge", "logs/run.csv", "--root", "."]));
    // The same holds for the scenario that it names.
    let named = SCENARIO.replace(
        "shape = \"tensor\"\nmass = 2.3\n",
        "shape = \"mesh\"\nfile = \"../secret.stl\"\nmass = 2.3\n",
    );
    let named = named.lines().filter(|line| !line.starts_with("inertia")).collect::<Vec<_>>().join("\n");
    scratch.write("logs/mesh.toml", &named);
    log("mesh.toml");
    let error = refused(&scratch.run(&["judge", "logs/run.csv"]), 2);
    assert!(error.contains("in the folder of the data file") && !error.contains("swordfish"), "{error}");
}

#[test]
fn a_run_of_another_scenario_is_refused() {
    let scratch = Scratch::new("judge-other");
    let rows: Vec<Vec<f64>> = exact(&scratch).iter().map(|r| r[..5].to_vec()).collect();
    scratch.write("other.toml", &SCENARIO.replace("2.3", "2.4"));
    scratch.write("copy.toml", SCENARIO);
    let log = |head: &str| scratch.write("run.csv", &table(&format!("{head}t,qw,qx,qy,qz"), &rows));
    log("# scenario = \"tumbling.toml\"\n");
    let error = refused(&scratch.run(&["judge", "other.toml", "run.csv"]), 2);
    assert!(
        error.contains("the log names the scenario \"tumbling.toml\", but other.toml was given"),
        "{error}"
    );
    // The same scenario, and a copy with the same text.
    for scenario in ["tumbling.toml", "copy.toml"] {
        stdout(&scratch.run(&["judge", scenario, "run.csv"]));
    }
    log("# scenario = \"tumbling.toml\"\n# scenario = \"other.toml\"\n");
    let error = refused(&scratch.run(&["judge", "run.csv"]), 2);
    assert!(error.contains("run.csv:2:1") && error.contains("given once"), "{error}");
    let lines: String =
        rows.iter().map(|r| format!("{{\"t\": {:?}, \"q\": {:?}}}\n", r[0], &r[1..])).collect();
    scratch.write("run.jsonl", &lines);
    stdout(&scratch.run(&["judge", "tumbling.toml", "run.jsonl"]));
    scratch.write("run.jsonl", &lines.replacen("{\"t\": 0.02", "{\"t\": 0.01, \"t\": 0.02", 1));
    let error = refused(&scratch.run(&["judge", "tumbling.toml", "run.jsonl"]), 2);
    assert!(error.contains("duplicate key") && error.contains("run.jsonl:2:"), "{error}");
}

#[test]
fn the_suite_is_passed_by_its_own_answers_and_by_nothing_else() {
    let scratch = Scratch::new("judge-suite");
    let said = stdout(&scratch.run(&["judge", "--write-suite", "suite"]));
    assert!(said.starts_with("wrote suite: 30 cases"), "{said}");
    let suite: Value =
        serde_json::from_str(&fs::read_to_string(scratch.0.join("suite/suite.json")).unwrap()).unwrap();
    let cases = suite["cases"].as_array().unwrap();
    assert_eq!((cases.len(), entries(&scratch.0.join("suite/exact")).len()), (CASES.len(), CASES.len()));
    for case in cases {
        assert!(!case["what"].as_str().unwrap().is_empty() && number(&case["rows"]) > 100.0);
        // Nothing is missing: every torque has its numbers.
        for torque in case["torque"].as_array().unwrap() {
            assert!(torque.as_object().unwrap().values().all(|value| !value.is_null()), "{torque}");
        }
        assert!(numbers(&case["omega_body_rad_s"]).iter().all(|c| c.is_finite()), "{}", case["name"]);
    }
    let case = |name: &str| cases.iter().find(|case| case["name"] == name).unwrap();
    let kinds = |name: &str| -> Vec<&str> {
        case(name)["torque"]
            .as_array()
            .unwrap()
            .iter()
            .map(|torque| torque["kind"].as_str().unwrap())
            .collect()
    };
    assert_eq!((kinds("free-flips"), kinds("gyrostat-motor")), (vec![], vec!["wheel"]));
    assert_eq!((kinds("top-slow"), kinds("damping")), (vec!["gravity"], vec!["damping"]));
    assert_eq!(case("torque-of-time")["torque"][0]["torque_n_m"][0], "0.6*sin(2*t)");
    // µ = 1000, r = 10: one orbit in 2π s.
    assert_eq!(number(&case("gravity-gradient")["torque"][0]["rate_rad_s"]), 1.0);
    let diagonal = |name: &str| numbers(&case(name)["inertia_kg_m2"][0])[0];
    assert_eq!((diagonal("damping"), number(&case("damping")["mass_kg"])), (0.82512, 1.9));
    refused(&scratch.run(&["judge", "--write-suite", "suite"]), 2);

    fs::create_dir(scratch.0.join("runs")).unwrap();
    assert!(refused(&scratch.run(&["judge", "--suite", "runs"]), 2).contains("no run of any case"));
    for case in CASES {
        let name = format!("{}.csv", case.name);
        fs::copy(scratch.0.join("suite/exact").join(&name), scratch.0.join("runs").join(&name)).unwrap();
    }
    let card = json(&scratch.run(&["judge", "--suite", "runs", "--json", "--limit", "1e-12"]));
    assert_eq!((number(&card["passed"]), number(&card["failed"])), (30.0, 0.0));

    // One wrong run, one missing run, and one unreadable run.
    let turned = fs::read_to_string(scratch.0.join("runs/needle.csv")).unwrap();
    fs::write(scratch.0.join("runs/free-flips.csv"), turned).unwrap();
    fs::remove_file(scratch.0.join("runs/plate.csv")).unwrap();
    scratch.write("runs/not-run.txt", "plate: it has no plates\n");
    let spun = fs::read_to_string(scratch.0.join("runs/fast-spin.csv")).unwrap();
    let half: Vec<&str> = spun.lines().take(spun.lines().count() / 2).collect();
    scratch.write("runs/fast-spin.csv", &(half.join("\n") + "\n"));
    scratch.write("runs/huge.csv", "t,qw,qx,qy,qz\n0,1,0,0,0\n1,0,0,0,0\n");
    let output = scratch.run(&["judge", "--suite", "runs", "--json"]);
    assert_eq!(output.status.code(), Some(1));
    let card: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!((number(&card["failed"]), number(&card["not_run"])), (3.0, 1.0));
    let case =
        |name: &str| card["cases"].as_array().unwrap().iter().find(|case| case["case"] == name).unwrap();
    assert_eq!(
        (&case("plate")["grade"], &case("plate")["why_not"]),
        (&"not_run".into(), &"it has no plates".into())
    );
    assert!(case("huge")["why_not"].as_str().unwrap().contains("zero"), "{}", case("huge"));
    assert_eq!(case("free-flips")["grade"], "failed");
    assert!(
        case("fast-spin")["why_not"].as_str().unwrap().contains("it ends after"),
        "{}",
        case("fast-spin")
    );

    scratch.write("runs/not-run.txt", "plates: it has none\n");
    assert!(refused(&scratch.run(&["judge", "--suite", "runs"]), 2).contains("not-run.txt:1:1"));
    fs::remove_file(scratch.0.join("runs/not-run.txt")).unwrap();
    scratch.write("runs/needel.csv", "t\n");
    assert!(refused(&scratch.run(&["judge", "--suite", "runs"]), 2).contains("did you mean needle?"));
    fs::rename(scratch.0.join("runs/needel.csv"), scratch.0.join("runs/needle@fast.csv")).unwrap();
    assert!(refused(&scratch.run(&["judge", "--suite", "runs"]), 2).contains("has an invalid step"));
}

#[test]
fn what_cannot_be_judged_is_refused() {
    let scratch = Scratch::new("judge-refused");
    let rows = exact(&scratch);
    let judged = |arguments: &[&str]| refused(&scratch.run(&[&["judge"], arguments].concat()), 2);
    assert!(judged(&["tumbling.toml"]).contains("no log to judge was given"));
    scratch.write(
        "good.csv",
        &table("t,qw,qx,qy,qz", &rows.iter().map(|r| r[..5].to_vec()).collect::<Vec<_>>()),
    );
    assert!(judged(&["good.csv"]).contains("does not name its scenario"));
    assert!(judged(&["tumbling.toml", "tumbling.toml", "good.csv"]).contains("a second scenario"));
    assert!(
        judged(&["tumbling.toml", "good.csv", "good.csv", "--step", "1 ms"])
            .contains("--step applies to one run")
    );
    for (name, text, said) in [
        ("short.csv", "t,qw,qx,qy,qz\n0,1,0,0,0\n", "at least 2 rows"),
        ("back.csv", "t,qw,qx,qy,qz\n0,1,0,0,0\n1,1,0,0,0\n0.5,1,0,0,0\n", "must be later"),
        ("zero.csv", "t,qw,qx,qy,qz\n0,1,0,0,0\n1,0,0,0,0\n", "zero"),
    ] {
        scratch.write(name, text);
        let error = judged(&["tumbling.toml", name]);
        assert!(error.contains(said) && error.contains(name), "{error}");
    }
    // A run of another body with another start.
    scratch.write(
        "other.csv",
        &table(
            "t,q0,q1,q2,q3",
            &(0..50)
                .map(|k| {
                    let angle = f64::from(k) * f64::from(k) * 0.37;
                    vec![f64::from(k) * 0.02, angle.cos(), 0.6 * angle.sin(), 0.0, 0.8 * angle.sin()]
                })
                .collect::<Vec<_>>(),
        ),
    );
    let error = judged(&["tumbling.toml", "other.csv"]);
    assert!(
        error.contains("no interpretation of the run's attitudes") && error.contains("--sense"),
        "{error}"
    );
    // Before the scenario's start, as the run says.
    assert!(
        judged(&["tumbling.toml", "good.csv", "--time-origin", "1"]).contains("before the scenario's start")
    );
    // A prescribed motion.
    assert!(judged(&[&example("slew.toml"), "good.csv"]).contains("prescribes its motion"));
    assert!(judged(&["tumbling.toml", "good.csv", "--axes", "x,z,y"]).contains("right-handed"));
    assert!(Path::new(&scratch.0).exists());
}

/// Every option of `--help` changes the result, also together with an output format, or is refused
/// where it has no effect.
#[test]
fn every_option_is_honoured_or_refused() {
    let scratch = Scratch::new("judge-options");
    let rows = exact(&scratch);
    // Axes (x, z, −y) and times from 100 s in two columns, neither stated in the log.
    let written =
        rows.iter().map(|r| vec![r[0] + 100.0, r[0] + 100.0, r[1], r[2], -r[4], r[3], r[5], -r[7], r[6]]);
    scratch.write("run.csv", &table("t,tick,q0,q1,q2,q3,wx,wy,wz", &written.collect::<Vec<_>>()));
    let files = ["judge", "tumbling.toml", "run.csv"];
    let given: [&[&str]; 11] = [
        &["--columns", "time = tick, omega = wx wy wz"],
        &["--quaternion", "wxyz"],
        &["--sense", "body-to-space"],
        &["--omega", "space"],
        &["--axes", "x,-z,y"],
        &["--time-origin", "100 s"],
        &["--step", "2 ms"],
        &["--limit", "1e-18"],
        &["--json"],
        &["--markdown"],
        &["--html"],
    ];
    let told = |options: &[&str]| {
        let output = scratch.run(&[&files, options].concat());
        (
            output.status.code(),
            String::from_utf8(output.stdout).unwrap(),
            String::from_utf8(output.stderr).unwrap(),
        )
    };
    let plain = told(&[]);
    assert_eq!(plain.0, Some(0), "{}", plain.2);
    let axes = plain.1.lines().find(|line| line.contains("Interpreted as quaternions")).unwrap().to_owned();
    assert!(axes.contains("w, x, y, z of body to space, axes (x, −z, y), times from 100 s"), "{axes}");
    for (k, option) in given.iter().enumerate() {
        let alone = told(option);
        assert!(alone.0 != Some(2) && (alone.0, &alone.1) != (plain.0, &plain.1), "{option:?}: {alone:?}");
        for other in &given[k + 1..] {
            let both = told(&[*option, *other].concat());
            if both.0 == Some(2) {
                assert!(
                    both.2.contains(option[0]) && both.2.contains(other[0]),
                    "{option:?} {other:?}: {}",
                    both.2
                );
                continue;
            }
            if other[0] == "--limit" && alone.0 == Some(1) {
                continue; // above the default limit already
            }
            let other_alone = told(other);
            let is_new = |of: &(Option<i32>, String, String)| (of.0, &of.1) != (both.0, &both.1);
            assert!(is_new(&alone) && is_new(&other_alone), "{option:?} {other:?}");
        }
        let beside = [&["judge", "--write-suite", "suite"], *option].concat();
        assert!(refused(&scratch.run(&beside), 2).contains("--write-suite"), "{option:?}");
    }
    let beside = scratch.run(&[&files[..], &["--suite", "runs"]].concat());
    assert!(refused(&beside, 2).contains("--suite"));
    // `judge_without_scenario` tests the options that replace the scenario.
    let others = ["--root", "--suite", "--write-suite", "--moments", "--start-omega", "--against"];
    let listed: Vec<&str> = given.iter().map(|option| option[0]).chain(others).collect();
    assert_eq!(options_of("judge"), listed.into_iter().map(str::to_owned).collect());
}
