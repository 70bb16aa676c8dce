//! `polhode spin` from the user's side: its output, files and failures.

use std::fmt::Write as _;
use std::fs;
use std::io::Write as _;
use std::process::{Output, Stdio};

use polhode::math::{AngularVelocity, Attitude};
use polhode::motion::{FreeMotion, State};
use serde_json::Value;

use crate::common::{Scratch, entries, example, json, number, numbers, stdout};

/// Returns the error of a run that must fail because of its input.
fn refused(output: &Output) -> String {
    crate::common::refused(output, 2)
}

fn spin(scratch: &Scratch, arguments: &[&str]) -> Output {
    scratch.run(&[&["spin"], arguments].concat())
}

/// Returns the same motion from the library.
fn motion(moments: [f64; 3], omega: [f64; 3]) -> FreeMotion {
    let omega = AngularVelocity::from_array(omega);
    FreeMotion::of_moments(moments, State { time: 0.0, attitude: Attitude::identity(), omega }).unwrap()
}

const PLATE: [&str; 4] = ["--moments", "1,2,3", "--omega", "0.01,1,0.01"];

fn plate(more: &[&'static str]) -> Vec<&'static str> {
    [&PLATE, more].concat()
}

#[test]
fn the_published_figures_of_the_flipping_plate() {
    let scratch = Scratch::new("spin-plate");
    let text = stdout(&spin(&scratch, &PLATE));
    for figure in [
        "physical (1 + 2 = 3: a flat plate)",
        "short-axis mode: L circles axis 3",
        "Flips every 19.55 s: ω starts 0.81° from the unstable intermediate axis",
        "growth rate         0.57735 /s",
        "period of ω         39.1057 s",
        "flips every         19.5529 s",
    ] {
        assert!(text.contains(figure), "{figure} is missing in\n{text}");
    }
    assert!(!text.contains("axis 1 round L") && !text.contains("geometric part"), "{text}");
    let more = stdout(&spin(&scratch, &plate(&["-v"])));
    assert!(more.contains("axis 1 about L      6.63802 s") && more.contains("geometric part"), "{more}");
    for (omega, period) in [
        ("0.01,1,0.01", 39.105_734_197_268_72),
        ("1e-3,1,1e-3", 55.061_681_107_466_37),
        ("1e-6,1,1e-6", 102.920_061_678_615_2),
    ] {
        let all = json(&spin(&scratch, &["--moments", "1,2,3", "--omega", omega, "--json"]));
        assert!((number(&all["motion"]["period_s"]) / period - 1.0).abs() < 1e-15);
    }
    assert!(scratch.entries().is_empty(), "nothing is written");
}

#[test]
fn the_unstable_equilibrium_does_not_flip() {
    let scratch = Scratch::new("spin-equilibrium");
    let arguments = ["--moments", "1,2,3", "--omega", "0,1,0"];
    let text = stdout(&spin(&scratch, &arguments));
    assert!(
        text.contains("axis of intermediate moment (unstable), one turn in 6.283 s.\n")
            && text.contains("growth rate         0.57735 /s"),
        "{text}"
    );
    assert!(!text.to_lowercase().contains("flip"), "{text}");
    let all = json(&spin(&scratch, &[&arguments[..], &["--json", "--at", "1e6"]].concat()));
    let motion = &all["motion"];
    assert_eq!(motion["regime"], "permanent");
    assert_eq!(motion["permanent_axis"], "intermediate");
    assert!(motion["flip_interval_s"].is_null() && motion["period_s"].is_null());
    assert!((number(&motion["growth_rate_per_s"]) - 1.0 / 3.0_f64.sqrt()).abs() < 1e-15);
    assert_eq!(numbers(&motion["states"][0]["omega_body"]), [0.0, 1.0, 0.0]);
}

/// A tensor on the command line gives the same states as in a scenario, and a page.
#[test]
fn a_tensor_is_given_by_its_elements() {
    let scratch = Scratch::new("spin-tensor");
    scratch.write(
        "body.toml",
        "[[body.part]]\nshape = \"tensor\"\nmass = \"2.3 kg\"\n\
         inertia = [[3.1, 0.4, -0.3], [0.4, 4.2, 0.2], [-0.3, 0.2, 5.3]]\n\
         [start]\nspin = { body = [0.1, 2.0, -0.3] }\n",
    );
    let given = ["--inertia", "3.1,4.2,5.3,0.4,-0.3,0.2", "--omega", "0.1,2,-0.3", "--at", "0:2:0.5,1e6"];
    let tensor = json(&spin(&scratch, &[&given[..], &["--json", "--html=page.html"]].concat()));
    let scenario = json(&spin(&scratch, &["body.toml", "--at", "0:2:0.5,1e6", "--json"]));
    assert_eq!(tensor["motion"], scenario["motion"]);
    assert_eq!(tensor["motion"]["states"].as_array().unwrap().len(), 6);
    assert!(std::fs::read_to_string(scratch.0.join("page.html")).unwrap().contains("<canvas"));
    let late = stdout(&spin(&scratch, &["body.toml", "--at", "1e9", "--html=late.html"]));
    assert!(late.contains("the page shows 0 to ") && late.contains(" s, not t = 1000000000 s"), "{late}");
    for (wrong, says) in [
        (&["--inertia", "1,2,9,0,0,0", "--omega", "1,2,3"][..], "9"),
        (&["--inertia", "1,2,2.5,0.1,0.2", "--omega", "1,2,3"], "6 numbers"),
        (&["--inertia", "1,2,2.5,0.1,0.2,0.1"], "--omega is missing"),
        (
            &["--inertia", "1,2,2.5,0.1,0.2,0.1", "--moments", "1,2,2.5", "--omega", "1,2,3"],
            "cannot be used with",
        ),
        (
            &["--inertia", "1,2,2.5,0.1,0.2,0.1", "--allow-unphysical", "--omega", "1,2,3"],
            "cannot be used with",
        ),
    ] {
        let text = refused(&spin(&scratch, wrong));
        assert!(text.contains(says), "{text}");
    }
}

#[test]
fn states_read_back_bit_for_bit() {
    let scratch = Scratch::new("spin-bits");
    let times = [0.0, 1.0, -2.5, 1e9, -3e15, 0.1];
    let library = motion([2.0, 3.0, 1.5], [0.3, -0.2, 1.7]);
    let arguments =
        ["--moments", "2,3,1.5", "--omega", "0.3,-0.2,1.7", "--at", "0,1,-2.5", "--at", "1e9,-3e15,0.1"];
    let all = json(&spin(&scratch, &[&arguments[..], &["--json"]].concat()));
    let states = all["motion"]["states"].as_array().unwrap();
    let text = stdout(&spin(&scratch, &arguments));
    let table = |head: &str| -> Vec<Vec<f64>> {
        let lines = text.lines().skip_while(|line| !line.starts_with(head)).skip(1);
        let rows = lines.take_while(|line| line.starts_with("    "));
        rows.map(|row| row.split_whitespace().map(|cell| cell.parse().unwrap()).collect()).collect()
    };
    let (omegas, attitudes) = (table("t in s, ω"), table("t in s, attitude"));
    assert_eq!([states.len(), omegas.len(), attitudes.len()], [6; 3]);
    let mut before: Option<Vec<f64>> = None;
    for (k, time) in times.into_iter().enumerate() {
        let state = library.at(time);
        let q = state.attitude.quaternion();
        let omega = state.omega.to_array().map(f64::to_bits);
        let bits = |numbers: &[f64]| numbers.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
        assert_eq!(number(&states[k]["time_s"]), time);
        assert_eq!(bits(&numbers(&states[k]["omega_body"])), omega);
        assert_eq!(bits(&omegas[k][1..]), omega);
        // q and −q are the same attitude.
        let printed = numbers(&states[k]["attitude_wxyz"]);
        assert_eq!(attitudes[k][1..], printed);
        assert!(printed == q || printed == q.map(|c| -c), "{printed:?} {q:?}");
        match before {
            None => assert!(printed[0] >= 0.0),
            Some(before) => assert!(printed.iter().zip(&before).map(|(a, b)| a * b).sum::<f64>() >= 0.0),
        }
        before = Some(printed);
    }
}

#[test]
fn a_start_takes_units_and_an_attitude() {
    let scratch = Scratch::new("spin-units");
    let of = |arguments: &[&str]| json(&spin(&scratch, &[arguments, &["--json"]].concat()));
    let si = of(&["--moments", "1,2,2.5", "--omega", "0.5,0,1", "--at", "7200"]);
    let other = of(&[
        "--moments",
        "(1, 2, 2.5) kg m^2",
        "--omega",
        "0.5 rad/s, 0, 1 rad/s",
        "--attitude",
        "3,0,0,0",
        "--at",
        "2 h",
    ]);
    assert_eq!(si, other);
    let turned = of(&["--moments", "1,2,2.5", "--omega", "0,0,1", "--attitude", "-1,0,0,-1", "--at", "0"]);
    let half = 0.5_f64.sqrt();
    let start = numbers(&turned["motion"]["states"][0]["attitude_wxyz"]);
    assert!((start[0] - half).abs() < 1e-15 && (start[3] - half).abs() < 1e-15, "{start:?}");
}

#[test]
fn thousands_of_times_from_a_file_or_a_pipe() {
    let scratch = Scratch::new("spin-times");
    let mut list = String::from("# nights\n\n");
    for k in 0..3000 {
        writeln!(list, "{}{}", f64::from(k - 1500) * 0.37, if k % 7 == 0 { "  # a Sunday" } else { "" })
            .unwrap();
    }
    scratch.write("times.txt", &(list.clone() + "\n86400\n"));
    let from_file = json(&spin(&scratch, &plate(&["--at-file", "times.txt", "--json"])));
    let states = from_file["motion"]["states"].as_array().unwrap();
    assert_eq!(states.len(), 3001);
    assert_eq!(number(&states[3000]["time_s"]), 86_400.0);
    let library = motion([1.0, 2.0, 3.0], [0.01, 1.0, 0.01]);
    for (k, state) in states[..3000].iter().enumerate() {
        let time = (k as f64 - 1500.0) * 0.37;
        assert_eq!(numbers(&state["omega_body"]), library.at(time).omega.to_array());
    }

    let mut piped = scratch.command(&[&["spin"], &plate(&["--at-file", "-", "--json"])[..]].concat());
    let mut child =
        piped.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    child.stdin.take().unwrap().write_all(list.as_bytes()).unwrap();
    let from_pipe = json(&child.wait_with_output().unwrap());
    assert_eq!(from_pipe["motion"]["states"].as_array().unwrap()[..], states[..3000]);
}

#[test]
fn a_scenario_spins_about_its_centre_of_mass() {
    let scratch = Scratch::new("spin-scenario");
    let file = example("t-handle.toml");
    let text = stdout(&spin(&scratch, &[&file]));
    assert!(text.contains("T-handle in free fall\nFlips every 3.828 s"), "{text}");
    let all = json(&spin(&scratch, &[&file, "--json"]));
    assert_eq!(all["source"]["format"], "scenario");
    let faster = json(&spin(&scratch, &[&file, "--omega", "(0, 0, 12) rad/s", "--json"]));
    assert_eq!(numbers(&faster["start"]["omega_body"]), [0.0, 0.0, 12.0]);
    // `simulate` gives the same values.
    let simulated = &json(&scratch.run(&["simulate", &file, "--json"]))["motion"];
    for key in [
        "regime",
        "period_s",
        "precession_period_s",
        "rotation_period_s",
        "flip_interval_s",
        "growth_rate_per_s",
        "symmetric_top",
    ] {
        assert_eq!(all["motion"][key], simulated[key], "{key}");
    }
    assert!(number(&simulated["precession_period_s"]) > 0.0);
    for driven in ["heavy-top.toml", "thruster.toml", "notes/11-10-dumbbell.toml"] {
        let text = refused(&spin(&scratch, &[&example(driven)]));
        assert!(text.contains("not a free motion") && text.contains("polhode simulate"), "{text}");
    }
}

#[test]
fn moments_of_no_body_are_refused_or_allowed() {
    let scratch = Scratch::new("spin-unphysical");
    let arguments = ["--moments", "8,4,0.4", "--omega", "0.1,0.2,5", "--at", "3"];
    let text = refused(&spin(&scratch, &arguments));
    for says in ["0.4 + 4 = 4.4", "less than 8", "by 3.6", "--allow-unphysical"] {
        assert!(text.contains(says), "{says}: {text}");
    }
    let allowed = [&arguments[..], &["--allow-unphysical"]].concat();
    assert!(stdout(&spin(&scratch, &allowed)).contains("unphysical (0.4 + 4 = 4.4 < 8"));
    let all = json(&spin(&scratch, &[&allowed[..], &["--json"]].concat()));
    assert_eq!(all["possible"], false);
    let library = motion([8.0, 4.0, 0.4], [0.1, 0.2, 5.0]).at(3.0).omega;
    assert_eq!(numbers(&all["motion"]["states"][0]["omega_body"]), library.to_array());
    // Rounded moments of a plate are accepted as a plate.
    assert!(
        stdout(&spin(&scratch, &["--moments", "0.1,0.2,0.3", "--omega", "1,2,3"])).contains("a flat plate")
    );
    // A rod is physical; no flag makes these moments acceptable.
    assert!(
        stdout(&spin(&scratch, &["--moments", "0,1,1", "--omega", "1,2,3"])).contains("physical (a rod)")
    );
    for moments in ["0,1,2", "0,0,1", "0,0,0", "1,-2,3", "-1,-1,-1", "1,2,nan", "inf,1,1"] {
        refused(&spin(&scratch, &["--moments", moments, "--omega", "1,2,3", "--allow-unphysical"]));
    }
}

#[test]
fn a_time_beyond_reach_is_refused_by_its_name() {
    let scratch = Scratch::new("spin-far");
    let arguments = ["--moments", "1.37,2.09,2.91", "--omega", "0.3,-0.5,0.9"];
    for times in ["1e28", "1e40", "1,1e300,2", "-1e40"] {
        let times = format!("--at={times}");
        let text = refused(&spin(&scratch, &[&arguments[..], &[&times]].concat()));
        assert!(text.contains("known up to 2.") && text.contains("e25 s"), "{text}");
    }
    // The longest times with a known state have the digits of the library.
    let all = json(&spin(&scratch, &[&arguments[..], &["--json", "--at", "1e22"]].concat()));
    let library = motion([1.37, 2.09, 2.91], [0.3, -0.5, 0.9]).at(1e22).omega;
    assert_eq!(numbers(&all["motion"]["states"][0]["omega_body"]), library.to_array());
    let body = "[[body.part]]\nshape = 'tensor'\nmass = 1\nmoments = [1.37, 2.09, 2.91]\n[start]\n\
                spin = { body = [0.3, -0.5, 0.9] }\n[run]\nduration = '1e30 s'\nsamples = 3\n";
    scratch.write("long.toml", body);
    let text = refused(&scratch.run(&["simulate", "long.toml", "-o", "out"]));
    assert!(text.contains("5e29 s") && text.contains("e25 s"), "{text}");
    assert_eq!(scratch.entries(), ["long.toml"]);
}

#[test]
fn bad_input_says_what_is_wrong() {
    let scratch = Scratch::new("spin-bad");
    scratch.write("times.txt", "0\n1.5\n\n 3 kg # late\n");
    scratch.write("empty.txt", "# nothing yet\n");
    let moments = ["--moments", "1,2,3"];
    for (arguments, says) in [
        (vec![], "--moments"),
        (vec!["--omega", "1,2,3"], "--moments"),
        (vec!["--moments", "1,2", "--omega", "1,2,3"], "3 numbers"),
        (vec!["--moments", "1,2,3,4", "--omega", "1,2,3"], "not 4"),
        (vec!["--moments", "1,2 m,3", "--omega", "1,2,3"], "a moment of inertia"),
        (vec!["--moments", "1,2,3"], "--omega is missing"),
        (vec!["body.toml", "--moments", "1,2,3"], "cannot be used with"),
        (vec!["nowhere.toml"], "the file does not exist"),
        (vec!["nowhere.toml", "--allow-unphysical"], "cannot be used with"),
    ] {
        let text = refused(&spin(&scratch, &arguments));
        assert!(text.contains(says), "{arguments:?}: {text}");
    }
    for (arguments, says) in [
        (vec!["--omega", "1,2"], "3 numbers"),
        (vec!["--omega", ""], "not 0"),
        (vec!["--omega", "1,,3"], "not a number"),
        (vec!["--omega", "1,2,nan"], "not a number"),
        (vec!["--omega", "1,2,inf"], "not a number"),
        (vec!["--omega", "1,2,1e999"], "larger than any double"),
        (vec!["--omega", "1,2,3 deg"], "an angular velocity"),
        (vec!["--omega", "1,2,3 deg/s"], "\"1\" has none"),
        (vec!["--omega", "1e200,1,1"], "beyond the range"),
        (vec!["--omega", "1e-200,0,0"], "beyond the range"),
        (vec!["--omega", "1,2,3", "--attitude", "0,0,0,0"], "zero"),
        (vec!["--omega", "1,2,3", "--attitude", "1,0,0"], "4 numbers"),
        (vec!["--omega", "1,2,3", "--at", "1,soon"], "\"soon\""),
        (vec!["--omega", "1,2,3", "--at", "nan"], "not a number"),
        (vec!["--omega", "1,2,3", "--at", "3 kg"], "a time"),
        (vec!["--omega", "1,2,3", "--at", "1,2,3 d"], "\"1\" has none"),
        (vec!["--omega", "1,2,3", "--at-file", "nowhere.txt"], "nowhere.txt"),
        (vec!["--omega", "1,2,3", "--at-file", "times.txt"], "times.txt:4:2"),
        (vec!["--omega", "1,2,3", "--at-file", "empty.txt"], "an empty one"),
        (vec!["--omega", "1,2,3", "--duration", "-1"], "positive"),
        (vec!["--omega", "1,2,3", "--samples", "5"], "--duration"),
        (vec!["--omega", "1,2,3", "--duration", "1", "--samples", "1"], "2.."),
        (
            vec!["--omega", "1,2,3", "--duration", "1", "--samples", "5", "--every", "1"],
            "cannot be used with",
        ),
        (vec!["--omega", "1,2,3", "--duration", "1", "--every", "1e-9"], "rows"),
        (vec!["--omega", "1,2,3", "--table", "csv"], "--duration"),
        (vec!["--omega", "1,2,3", "--chord-error", "0.1"], "--curves"),
        (vec!["--omega", "1,2,3", "--curves", "--chord-error", "0"], "1e-10"),
        (vec!["--omega", "1,2,3", "--periods", "5,6", "--convention", "long"], "cannot be used with"),
        (vec!["--periods", "5,6"], "--convention"),
        (vec!["--periods", "-5,6", "--convention", "long"], "positive"),
        (vec!["--periods", "5,0", "--convention", "long"], "positive"),
        (vec!["--periods", "5 m,1 m", "--convention", "long"], "a time"),
        (vec!["--periods", "100,1", "--convention", "short"], "no spin of this body"),
    ] {
        let text = refused(&spin(&scratch, &[&moments[..], &arguments].concat()));
        assert!(text.contains(says), "{arguments:?}: {text}");
    }
    assert_eq!(scratch.entries(), ["empty.txt", "times.txt"]);
}

fn keys(value: &Value) -> Vec<&str> {
    value.as_object().unwrap().keys().map(String::as_str).collect()
}

#[test]
fn the_keys_are_the_same_for_every_motion() {
    let scratch = Scratch::new("spin-keys");
    let of = |moments: &str, omega: &str| {
        json(&spin(&scratch, &["--moments", moments, "--omega", omega, "--json", "--at", "1"]))
    };
    let first = of("1,2,3", "0.3,1,0.5");
    for (moments, omega, regime) in [
        ("1,2,3", "0.3,1,0.5", "short_axis"),
        ("1,2,3", "1,1,0.1", "long_axis"),
        ("10,13,15", "1,0.5,1", "separatrix"),
        ("1,2,3", "0,1,0", "permanent"),
        ("1,2,3", "0,0,1", "permanent"),
        ("1,1,2", "1,0,2", "symmetric"),
        ("1,2,2", "1,0,2", "symmetric"),
        ("0,1,1", "1,0,2", "symmetric"),
        ("2,2,2", "1,0,2", "permanent"),
        ("1,2,3", "0,0,0", "at_rest"),
        ("1e-46,2e-46,2.5e-46", "1e12,2e12,-1e11", "long_axis"),
    ] {
        let all = of(moments, omega);
        assert_eq!(keys(&all), keys(&first));
        assert_eq!(keys(&all["motion"]), keys(&first["motion"]));
        assert_eq!(all["motion"]["regime"], regime, "{moments} {omega}");
        assert!(all["motion"]["states"][0]["attitude_wxyz"].as_array().unwrap().iter().all(Value::is_number));
        let text = stdout(&spin(&scratch, &["--moments", moments, "--omega", omega]));
        assert!(!text.contains("NaN") && !text.contains("inf") && !text.contains('—'), "{text}");
        assert!(text.lines().all(|line| line.chars().count() <= 100), "{text}");
    }
    assert_eq!(
        keys(&first["motion"])[..10],
        [
            "regime",
            "permanent_axis",
            "period_s",
            "precession_period_s",
            "rotation_period_s",
            "flip_interval_s",
            "growth_rate_per_s",
            "kinetic_energy_j",
            "momentum_kg_m2_s",
            "momentum_space_kg_m2_s"
        ]
    );
}

#[test]
fn periods_of_toutatis_and_back() {
    let scratch = Scratch::new("spin-toutatis");
    let moments = ["--moments", "3.0836,3.235,1"];
    let omega = ["--omega", "(14.51, 33.529, -98.709) deg/d"];
    let forward = json(&spin(&scratch, &[&moments[..], &omega, &["--json"]].concat()));
    let motion = &forward["motion"];
    assert_eq!(motion["regime"], "long_axis");
    let [precession, rotation] =
        ["precession_period_s", "rotation_period_s"].map(|key| number(&motion[key]) / 86_400.0);
    assert!(
        (rotation - 5.3685).abs() < 5e-5 && (precession - 7.4117).abs() < 5e-5,
        "{rotation} {precession}"
    );
    assert_eq!(motion["periods"]["long_axis"]["precession_period_s"], motion["precession_period_s"]);

    for (convention, key) in [("long", "long_axis"), ("short", "short_axis")] {
        let of = &motion["periods"][key];
        let periods = format!("{}, {}", of["precession_period_s"], of["rotation_period_s"]);
        let arguments = [&moments[..], &["--periods", &periods, "--convention", convention]].concat();
        let back = json(&spin(&scratch, &[&arguments[..], &["--json"]].concat()));
        let spins = back["spins"].as_array().unwrap();
        let found = spins.iter().find(|spin| spin["regime"] == "long_axis").unwrap();
        let near = |a: &Value, b: &Value| (number(a) / number(b) - 1.0).abs() < 1e-12;
        assert!(near(&found["energy_ratio"], &motion["least_energy_spin"]["energy_ratio"]), "{found}");
        assert!(near(&found["momentum_kg_m2_s"], &motion["momentum_kg_m2_s"]), "{found}");
        // ω is along body axes, with the long axis z, and reproduces these periods.
        let again = joined(&numbers(&found["omega_body"]));
        let again = json(&spin(&scratch, &[&moments[..], &["--omega", &again, "--json"]].concat()));
        assert!(near(&again["motion"]["precession_period_s"], &motion["precession_period_s"]));
        assert!(near(&again["motion"]["rotation_period_s"], &motion["rotation_period_s"]));
        let text = stdout(&spin(&scratch, &arguments));
        assert!(
            text.contains("long-axis mode") && text.contains("T / least T         1.93044, E/E0"),
            "{text}"
        );
    }
}

fn joined(numbers: &[f64]) -> String {
    numbers.iter().map(f64::to_string).collect::<Vec<_>>().join(",")
}

#[test]
fn a_folder_is_written_whole_or_not_at_all() {
    let scratch = Scratch::new("spin-folder");
    let write = plate(&["--duration", "40", "--samples", "11", "--table", "csv", "--table", "parquet"]);
    let text = stdout(&spin(&scratch, &write));
    assert!(
        text.ends_with("wrote spin/: summary.json, trajectory.csv, trajectory.parquet, report.html\n"),
        "{text}"
    );
    assert_eq!(
        entries(&scratch.0.join("spin")),
        ["report.html", "summary.json", "trajectory.csv", "trajectory.parquet"]
    );
    let summary = fs::read_to_string(scratch.0.join("spin/summary.json")).unwrap();
    assert_eq!(summary, stdout(&spin(&scratch, &plate(&["--json"]))));
    let table = fs::read_to_string(scratch.0.join("spin/trajectory.csv")).unwrap();
    let rows: Vec<Vec<&str>> = table.lines().map(|line| line.split(',').collect()).collect();
    assert_eq!(rows.len(), 12);
    assert_eq!(
        rows[0][..6],
        "time_s,attitude_w,attitude_x,attitude_y,attitude_z,omega_body_x_rad_s"
            .split(',')
            .collect::<Vec<_>>()
    );
    let library = motion([1.0, 2.0, 3.0], [0.01, 1.0, 0.01]).at(4.0);
    assert_eq!([rows[2][0], rows[2][5]].map(|cell| cell.parse::<f64>().unwrap()), [4.0, library.omega.x]);

    assert!(refused(&spin(&scratch, &write)).contains("spin already exists"));
    stdout(&spin(&scratch, &plate(&["--duration", "1", "--every", "0.5", "--force", "--no-page"])));
    assert_eq!(entries(&scratch.0.join("spin")), ["summary.json", "trajectory.parquet"]);
    stdout(&spin(&scratch, &plate(&["-o", "only"])));
    assert_eq!(entries(&scratch.0.join("only")), ["report.html", "summary.json"]);
    // For bad input, an unsuitable place, or another program's folder, nothing is written.
    fs::create_dir(scratch.0.join("photos")).unwrap();
    scratch.write("photos/cat.jpg", "a cat");
    refused(&spin(&scratch, &plate(&["-o", "photos", "--force"])));
    refused(&spin(&scratch, &plate(&["-o", "new", "--at", "x"])));
    refused(&spin(&scratch, &plate(&["-o", "new", "--at-file", "nowhere"])));
    refused(&spin(&scratch, &plate(&["-o", "photos/cat.jpg/new"])));
    assert_eq!(scratch.entries(), ["only", "photos", "spin"]);
    assert_eq!(entries(&scratch.0.join("photos")), ["cat.jpg"]);
}

#[test]
fn curves_are_written_beside_the_summary() {
    let scratch = Scratch::new("spin-curves");
    let text = stdout(&spin(&scratch, &plate(&["--curves", "-o", "curves"])));
    assert!(
        text.contains("polhode.csv, momentum.csv, herpolhode.csv, body_cone.csv, space_cone.csv"),
        "{text}"
    );
    let folder = scratch.0.join("curves");
    let read = |name: &str, head: &str| -> Vec<Vec<f64>> {
        let text = fs::read_to_string(folder.join(name)).unwrap();
        let (first, rest) = text.split_once('\n').unwrap();
        assert_eq!(first, head);
        rest.lines().map(|line| line.split(',').map(|cell| cell.parse().unwrap()).collect()).collect()
    };
    let omega_body = "time_s,omega_body_x_rad_s,omega_body_y_rad_s,omega_body_z_rad_s";
    let library = motion([1.0, 2.0, 3.0], [0.01, 1.0, 0.01]);
    for (name, periods) in [("polhode.csv", 1.0), ("body_cone.csv", 3.0)] {
        let rows = read(name, omega_body);
        assert!(rows.len() > 20);
        for row in &rows {
            let omega = library.at(row[0]).omega;
            assert!((omega - AngularVelocity::new(row[1], row[2], row[3])).norm() < 1e-13);
        }
        let last = rows.last().unwrap()[0];
        assert!((last / (periods * library.period().unwrap()) - 1.0).abs() < 1e-14);
    }
    let momentum = read(
        "momentum.csv",
        "time_s,momentum_body_x_kg_m2_s,momentum_body_y_kg_m2_s,momentum_body_z_kg_m2_s",
    );
    let l = library.momentum().norm();
    assert!(momentum.iter().all(|row| (row[1].hypot(row[2]).hypot(row[3]) / l - 1.0).abs() < 1e-13));
    let space = read("space_cone.csv", "time_s,omega_space_x_rad_s,omega_space_y_rad_s,omega_space_z_rad_s");
    let herpolhode = read(
        "herpolhode.csv",
        "time_s,across_space_x_rad_s,across_space_y_rad_s,across_space_z_rad_s,plane_1_rad_s,plane_2_rad_s",
    );
    assert!(space.len() > 100 && herpolhode.len() > 100);
    let summary: Value =
        serde_json::from_str(&fs::read_to_string(folder.join("summary.json")).unwrap()).unwrap();
    let [least, greatest] = ["least_radius_rad_s", "greatest_radius_rad_s"]
        .map(|key| number(&summary["motion"]["herpolhode"][key]));
    for row in &herpolhode {
        let radius = row[4].hypot(row[5]);
        assert!((radius - row[1].hypot(row[2]).hypot(row[3])).abs() < 1e-14);
        assert!(radius > least - 1e-14 && radius < greatest + 1e-14, "{least} {radius} {greatest}");
    }
    // Finer curves have more points; a shorter duration gives fewer points in space.
    let many = stdout(&spin(
        &scratch,
        &plate(&["--curves", "--chord-error", "1e-5", "--duration", "4", "-o", "fine"]),
    ));
    assert!(many.contains("trajectory.parquet, polhode.csv"), "{many}");
    let fine = fs::read_to_string(scratch.0.join("fine/polhode.csv")).unwrap().lines().count();
    assert!(fine > 2 * read("polhode.csv", omega_body).len());
    let text = refused(&spin(&scratch, &plate(&["--curves", "--chord-error", "1e-10", "--duration", "1e9"])));
    assert!(text.contains("points") && text.contains("--chord-error"), "{text}");
    assert_eq!(scratch.entries(), ["curves", "fine"]);
}

#[test]
fn it_explains_itself() {
    let help = stdout(&spin(&Scratch::new("spin-help"), &["--help"]));
    for says in ["Examples:", "--json", "--verbose", "--at-file", "--convention", "(0, 0, 30) deg/s"] {
        assert!(help.contains(says), "{says}");
    }
}
