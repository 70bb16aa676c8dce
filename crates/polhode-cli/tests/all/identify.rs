//! `polhode identify`: examples compared with the data used to generate their logs
//! (fixtures/identify_*.py).

use std::fs;

use polhode::math::symmetric_eigen;
use serde_json::Value;

use crate::common::{Scratch, example, json, number, numbers, refused, stdout};

/// Largest accepted deviation, in standard deviations.
const FAR: f64 = 4.0;

fn found(report: &Value, name: &str) -> [f64; 2] {
    let all = report["estimate"]["numbers"].as_array().unwrap();
    let one = all.iter().find(|number| number["name"] == name).unwrap_or_else(|| panic!("{name}"));
    [number(&one["value"]), number(&one["sd"])]
}

#[test]
fn the_tool_at_the_wrist_is_what_was_carried() {
    let scratch = Scratch::new("identify-payload");
    let plan = example("identify/payload.toml");
    let report = json(&scratch.run(&["identify", &plan, "--json"]));
    let truth = [
        ("mass", 1.85),
        ("center x", 0.021),
        ("center y", -0.034),
        ("center z", 0.087),
        ("Ixx", 0.0094),
        ("Iyy", 0.0061),
        ("Izz", 0.0078),
        ("Ixy", -0.0011),
        ("Ixz", 0.0007),
        ("Iyz", 0.0014),
        ("bias fx", 0.8),
        ("bias fy", -0.45),
        ("bias fz", 1.3),
        ("bias tx", 0.021),
        ("bias ty", -0.034),
        ("bias tz", 0.012),
    ];
    for (name, value) in truth {
        let [got, sd] = found(&report, name);
        assert!((got - value).abs() < FAR * sd, "{name}: {got} ± {sd} is not {value}");
        assert!(sd < 0.03 * value.abs(), "{name}: {sd}");
    }
    let (moments, _) = symmetric_eigen([0.0094, 0.0061, 0.0078, -0.0011, 0.0007, 0.0014]);
    let (got, sd) = (numbers(&report["principal"]["moments"]), numbers(&report["principal"]["moment_sd"]));
    for k in 0..3 {
        assert!((got[k] - moments[k]).abs() < FAR * sd[k], "{got:?} ± {sd:?} is not {moments:?}");
    }
    assert_eq!(report["rows"], 400);
    assert_eq!(report["unconstrained"]["is_possible"], true);
    assert!(report["edge"].is_null() && report["findings"].as_array().unwrap().is_empty());
    for test in report["residuals"].as_array().unwrap() {
        assert!((number(&test["reduced_chi_square"]) - 1.0).abs() < 0.2, "{test}");
    }
    assert_eq!(scratch.run(&["identify", &plan, "--strict"]).status.code(), Some(0));

    let text = stdout(&scratch.run(&["identify", &plan]));
    assert!(text.contains("→ Mass 1.85011 ± 0.00031 kg\n"), "{text}");
    assert!(text.contains("payload.csv: temperature."), "{text}");
    let page = stdout(&scratch.run(&["identify", &plan, "--html"]));
    assert!(page.starts_with("<!") && page.contains("A tool at the wrist"));
    assert!(stdout(&scratch.run(&["identify", &plan, "--markdown"])).starts_with("# A tool at the wrist\n"));
}

#[test]
fn the_body_that_is_printed_is_the_one_that_was_found() {
    let scratch = Scratch::new("identify-body");
    let plan = example("identify/payload.toml");
    let report = json(&scratch.run(&["identify", &plan, "--json"]));
    let body = stdout(&scratch.run(&["identify", &plan, "--body"]));
    scratch.write("body.toml", &body);
    let scenario = polhode_scenario::read::read(&scratch.0.join("body.toml")).unwrap();
    let read = scenario.body();
    assert!((read.mass() / number(&report["body"]["mass"]) - 1.0).abs() < 1e-15);
    for (got, want) in read.center_of_mass().to_array().iter().zip(numbers(&report["body"]["center_of_mass"]))
    {
        assert!((got - want).abs() < 1e-16);
    }
    for (row, want) in read.inertia().matrix().iter().zip(report["body"]["inertia"].as_array().unwrap()) {
        for (got, want) in row.iter().zip(numbers(want)) {
            assert!((got - want).abs() < 1e-17, "{got} is not {want}");
        }
    }
}

#[test]
fn the_racket_has_the_ratios_that_it_was_thrown_with() {
    let scratch = Scratch::new("identify-racket");
    let plan = example("identify/racket-like.toml");
    let report = json(&scratch.run(&["identify", &plan, "--json"]));
    let (moments, _) = symmetric_eigen([0.01540, 0.00152, 0.01655, 0.00042, -0.00018, 0.00030]);
    let (got, sd) = (numbers(&report["principal"]["ratios"]), numbers(&report["principal"]["ratio_sd"]));
    for k in 0..2 {
        let truth = moments[k] / moments[2];
        assert!((got[k] - truth).abs() < FAR * sd[k], "{got:?} ± {sd:?} is not {truth}");
        assert!(sd[k] < 0.02, "{sd:?}");
    }
    assert_eq!(report["scale_is_known"], false);
    assert_eq!(report["flights"].as_array().unwrap().len(), 4);
    assert!(stdout(&scratch.run(&["identify", &plan])).contains("determines only the ratios of the moments"));
    let error = refused(&scratch.run(&["identify", &plan, "--body"]), 2);
    assert!(error.contains("--body") && error.contains("only the ratios of the moments"), "{error}");
}

/// Writes the example with other keys.
fn altered(scratch: &Scratch, keys: &str) {
    fs::copy(example("identify/payload.csv"), scratch.0.join("payload.csv")).unwrap();
    scratch.write("plan.toml", &format!("[payload]\nlog = \"payload.csv\"\n{keys}"));
}

fn codes(report: &Value) -> Vec<&str> {
    report["findings"].as_array().unwrap().iter().map(|f| f["code"].as_str().unwrap()).collect()
}

#[test]
fn a_wrench_on_the_wrong_side_is_said() {
    let scratch = Scratch::new("identify-side");
    altered(&scratch, "wrench = \"on payload\"\nbias = true\n");
    let output = scratch.run(&["identify", "plan.toml", "--json"]);
    let report = json(&output);
    for code in ["identify.mass", "identify.impossible", "identify.model"] {
        assert!(codes(&report).contains(&code), "{report}");
    }
    assert_eq!(report["unconstrained"]["is_possible"], false);
    assert_eq!(scratch.run(&["identify", "plan.toml", "--strict"]).status.code(), Some(1));
    let text = stdout(&scratch.run(&["identify", "plan.toml"]));
    assert!(text.contains("the estimated mass is negative"), "{text}");
}

/// Generates the log of particles carried through the motion of the example, with noise.
fn carried(particles: &[(f64, [f64; 3])]) -> String {
    let example = fs::read_to_string(example("identify/payload.csv")).unwrap();
    let cross = |a: [f64; 3], b: [f64; 3]| {
        [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    };
    let mut state = 0.431_f64;
    let mut noise = |sd: f64| {
        let sum = (0..12).fold(-6.0, |sum, _| {
            state = (state * 1997.0 + 0.3127).fract();
            sum + state
        });
        sd * sum
    };
    let mut log = example.lines().nth(1).unwrap().to_owned();
    for line in example.lines().skip(2) {
        let row: Vec<f64> = line.split(',').map(|x| x.parse().unwrap()).collect();
        let three = |first: usize| [row[first], row[first + 1], row[first + 2]];
        let [omega, alpha, a, g] = [1, 4, 7, 10].map(three);
        let mut wrench = [0.0; 6];
        for (m, r) in particles {
            let (turned, drawn) = (cross(alpha, *r), cross(omega, cross(omega, *r)));
            let force: [f64; 3] = std::array::from_fn(|k| m * (a[k] - g[k] + turned[k] + drawn[k]));
            let torque = cross(*r, force);
            (0..3).for_each(|k| {
                wrench[k] -= force[k];
                wrench[3 + k] -= torque[k];
            });
        }
        let motion: Vec<String> = row[..13].iter().map(f64::to_string).collect();
        let read =
            [0, 1, 2, 3, 4, 5].map(|k| (wrench[k] + noise(if k < 3 { 0.05 } else { 0.002 })).to_string());
        log += &format!("\n{},{},20", motion.join(","), read.join(","));
    }
    log
}

/// Thin payloads: the report states the boundary of physical bodies, or the kind, and the printed
/// body can be read.
#[test]
fn plates_and_rods_are_at_the_edge() {
    let scratch = Scratch::new("identify-edge");
    let along = |u: f64, v: f64| {
        let (a, b) = ([0.6, 0.64, -0.48], [0.8, -0.48, 0.36]);
        std::array::from_fn(|k| [0.03, -0.02, 0.11][k] + u * a[k] + v * b[k])
    };
    let rod = [(0.7, along(-0.11, 0.0)), (0.9, along(0.05, 0.0)), (0.4, along(0.13, 0.0))];
    let plate = [
        (0.5, along(0.12, 0.03)),
        (0.4, along(-0.09, 0.07)),
        (0.6, along(0.02, -0.13)),
        (0.3, along(-0.14, -0.06)),
    ];
    for (kind, particles, mass, thin) in [("rod", &rod[..], 2.0, 2), ("plate", &plate[..], 1.8, 1)] {
        scratch.write("log.csv", &carried(particles));
        let keys = "[payload]\nlog = \"log.csv\"\nwrench = \"on sensor\"\nnoise = { force = \"0.05 N\", torque = \"2 mN m\" }\n";
        scratch.write("plan.toml", keys);
        let free = json(&scratch.run(&["identify", "plan.toml", "--json"]));
        scratch.write("kind.toml", &format!("{keys}kind = \"{kind}\"\n"));
        let told = json(&scratch.run(&["identify", "kind.toml", "--json"]));
        for report in [&free, &told] {
            let [got, sd] = found(report, "mass");
            assert!((got - mass).abs() < FAR * sd, "{kind}: {got} ± {sd}");
        }
        assert!(told["edge"].is_null() && codes(&told).is_empty(), "{kind}: {told}");
        // The smallest second moment of a payload of known kind is zero.
        let p = numbers(&told["principal"]["moments"]);
        assert!((p[0] + p[1] - p[2]).abs() < 1e-9 * p[2], "{kind}: {p:?}");
        assert_eq!(free["unconstrained"]["is_possible"], false, "{kind}");
        assert_eq!(free["edge"]["kind"], kind);
        assert_eq!(codes(&free), ["identify.edge"], "{kind}: {free}");
        for direction in free["edge"]["thin"].as_array().unwrap() {
            let [at_most, sd] = ["at_most", "sd"].map(|key| number(&direction[key]));
            assert!(sd > 0.0 && at_most >= 1.6 * sd, "{direction}");
        }
        assert_eq!(free["edge"]["thin"].as_array().unwrap().len(), thin);
        let text = stdout(&scratch.run(&["identify", "plan.toml"]));
        assert!(text.contains(&format!("to estimate it as such, write kind = \"{kind}\"")), "{text}");
        for plan in ["plan.toml", "kind.toml"] {
            scratch.write("body.toml", &stdout(&scratch.run(&["identify", plan, "--body"])));
            let body = polhode_scenario::read::read(&scratch.0.join("body.toml"));
            assert!((body.unwrap().body().mass() - mass).abs() < 0.01, "{kind} {plan}");
        }
    }
}

#[test]
fn what_is_no_rod_is_said() {
    let scratch = Scratch::new("identify-rod");
    altered(&scratch, "wrench = \"on sensor\"\nbias = true\nkind = \"rod\"\n");
    let report = json(&scratch.run(&["identify", "plan.toml", "--json"]));
    assert!(codes(&report).contains(&"identify.kind"), "{report}");
}

/// A wrist at rest determines the mass and the part of the centre perpendicular to gravity, but no
/// moments.
#[test]
fn what_a_wrist_at_rest_does_not_show_has_no_error() {
    let scratch = Scratch::new("identify-rest");
    let header = "t [s],wx [rad/s],wy [rad/s],wz [rad/s],alpha_x [rad/s^2],alpha_y [rad/s^2],alpha_z [rad/s^2],\
                  ax [m/s^2],ay [m/s^2],az [m/s^2],gx [m/s^2],gy [m/s^2],gz [m/s^2],\
                  fx [N],fy [N],fz [N],tx [N m],ty [N m],tz [N m]\n";
    // 2 kg at (0.03, -0.02, 0.1) m.
    let row = |k: usize| format!("{k},0,0,0,0,0,0,0,0,0,0,0,-9.81,0,0,-19.62,0.3924,0.5886,0\n");
    scratch.write("rest.csv", &(header.to_owned() + &(0..30).map(row).collect::<String>()));
    scratch.write(
        "plan.toml",
        "[payload]\nlog = \"rest.csv\"\nwrench = \"on sensor\"\nnoise = { force = \"0.1 N\", torque = \"10 mN m\" }\n",
    );
    let report = json(&scratch.run(&["identify", "plan.toml", "--json"]));
    let all = report["estimate"]["numbers"].as_array().unwrap();
    let sd = |name: &str| &all.iter().find(|n| n["name"] == name).unwrap()["sd"];
    let [mass, mass_sd] = found(&report, "mass");
    assert!((mass - 2.0).abs() < 1e-6 && mass_sd > 0.0, "{mass} ± {mass_sd}");
    let [x, y] = ["center x", "center y"].map(|name| found(&report, name)[0]);
    assert!((x - 0.03).abs() < 1e-6 && (y + 0.02).abs() < 1e-6, "{x} {y}");
    for unknown in ["center z", "Ixx", "Iyy", "Izz", "Ixy", "Ixz", "Iyz"] {
        assert!(sd(unknown).is_null(), "{unknown}: {}", sd(unknown));
    }
    assert!(report["body"].is_null() && codes(&report).contains(&"identify.unknown"), "{report}");
    let error = refused(&scratch.run(&["identify", "plan.toml", "--body"]), 2);
    assert!(error.contains("the motion does not determine it completely"), "{error}");
    assert!(stdout(&scratch.run(&["identify", "plan.toml"])).contains("Unobservable direction: "));
}

#[test]
fn plans_and_logs_that_say_nothing_are_refused() {
    let scratch = Scratch::new("identify-refused");
    altered(&scratch, "bias = true\n");
    let error = refused(&scratch.run(&["identify", "plan.toml"]), 2);
    assert!(error.contains("plan.toml:1:1") && error.contains("wrench = \"on sensor\""), "{error}");
    let log = fs::read_to_string(scratch.0.join("payload.csv")).unwrap();
    let short: Vec<&str> = log.lines().take(4).collect();
    scratch.write("payload.csv", &short.join("\n"));
    scratch.write("plan.toml", "[payload]\nlog = \"payload.csv\"\nwrench = \"on sensor\"\nbias = true\n");
    let error = refused(&scratch.run(&["identify", "plan.toml"]), 2);
    assert!(error.contains("too few rows: 2; at least 13 are needed"), "{error}");
    refused(&scratch.run(&["identify", "none.toml"]), 2);
}

#[test]
fn one_flight_with_an_added_body_is_refused() {
    let scratch = Scratch::new("identify-one-added");
    fs::copy(example("identify/racket-like.csv"), scratch.0.join("racket-like.csv")).unwrap();
    let plan = "[tumble]\nlog = \"racket-like.csv\"\n[[tumble.flight]]\nfrom = \"8.3 s\"\nto = \"9.2 s\"\n\
                added = { moments = [\"1e-3 kg m^2\", \"1e-3 kg m^2\", \"1.5e-3 kg m^2\"] }\n";
    scratch.write("plan.toml", plan);
    let error = refused(&scratch.run(&["identify", "plan.toml"]), 2);
    assert!(error.contains("one flight with an added body determines only the ratios"), "{error}");
    assert!(error.contains("remove `added`"), "{error}");
}

#[test]
fn a_wrench_that_is_all_zero_is_refused() {
    let scratch = Scratch::new("identify-zero");
    altered(&scratch, "wrench = \"on sensor\"\n");
    let log = fs::read_to_string(scratch.0.join("payload.csv")).unwrap();
    let header = log.lines().find(|line| line.contains("time")).unwrap();
    let forces: Vec<usize> =
        header.split(',').enumerate().filter(|(_, name)| name.starts_with("force")).map(|(k, _)| k).collect();
    assert_eq!(forces.len(), 3, "{header}");
    let silent = |line: &str| {
        let cells = line.split(',').enumerate();
        cells.map(|(k, cell)| if forces.contains(&k) { "0" } else { cell }).collect::<Vec<_>>().join(",")
    };
    let is_row = |line: &str| line.starts_with(|c: char| c.is_ascii_digit() || c == '-');
    let rows = log.lines().map(|line| if is_row(line) { silent(line) } else { line.to_owned() });
    scratch.write("payload.csv", &rows.collect::<Vec<_>>().join("\n"));
    let error = refused(&scratch.run(&["identify", "plan.toml"]), 2);
    assert!(error.contains("every force in the log is zero"), "{error}");
}

#[test]
fn a_log_of_a_gyro_needs_no_plan() {
    let scratch = Scratch::new("identify-log");
    let log = example("identify/racket-like.csv");
    let by_log = json(&scratch.run(&["identify", &log, "--json"]));
    let by_plan = json(&scratch.run(&["identify", &example("identify/racket-like.toml"), "--json"]));
    assert_eq!(by_log["principal"], by_plan["principal"]);
    assert_eq!(codes(&by_log), codes(&by_plan));
}

#[test]
fn what_is_wrong_with_a_gyro_log_is_named() {
    type Change<'a> = &'a dyn Fn(usize, &[f64]) -> Option<Vec<f64>>;
    let scratch = Scratch::new("identify-flaws");
    let log = fs::read_to_string(example("identify/racket-like.csv")).unwrap();
    let mut lines =
        log.lines().skip(2).map(|line| line.split(',').map(|x| x.parse::<f64>().unwrap()).collect());
    let rows: Vec<Vec<f64>> = lines.by_ref().collect();
    let write = |name: &str, change: Change<'_>| {
        let mut text = String::from("time_s,gyro_x,gyro_y,gyro_z\n");
        for (k, row) in rows.iter().enumerate() {
            if let Some(row) = change(k, row) {
                text += &format!("{},{},{},{}\n", row[0], row[1], row[2], row[3]);
            }
        }
        scratch.write(name, &text);
    };
    // Saturation below the largest rates of the flight.
    let limit = 7.7_f64;
    let clip = |row: &[f64]| {
        let held = |(k, x): (usize, &f64)| if k == 0 { *x } else { x.clamp(-limit, limit) };
        row.iter().enumerate().map(held).collect::<Vec<f64>>()
    };
    write("clipped.csv", &|_, row| Some(clip(row)));
    let report = json(&scratch.run(&["identify", "clipped.csv", "--json"]));
    assert!(codes(&report).contains(&"identify.saturated"), "{:?}", codes(&report));
    let text = stdout(&scratch.run(&["identify", "clipped.csv"]));
    assert!(text.contains("is saturated at") && text.contains("were not used"), "{text}");
    let (moments, _) = symmetric_eigen([0.01540, 0.00152, 0.01655, 0.00042, -0.00018, 0.00030]);
    let (got, sd) = (numbers(&report["principal"]["ratios"]), numbers(&report["principal"]["ratio_sd"]));
    for k in 0..2 {
        let truth = moments[k] / moments[2];
        assert!((got[k] - truth).abs() < FAR * sd[k], "{got:?} ± {sd:?} is not {truth}");
    }
    // A log that ends in mid-flight, and a flight with a gap; both are reported.
    write("short.csv", &|k, row| (k < 880).then(|| row.to_vec()));
    let text = stdout(&scratch.run(&["identify", "short.csv"]));
    assert!(text.contains("The log ends during a flight: flight 4"), "{text}");
    write("holed.csv", &|k, row| (!(120..150).contains(&k)).then(|| row.to_vec()));
    scratch.write("holed.toml", "[tumble]\nlog = \"holed.csv\"\n[[tumble.flight]]\nfrom = 0.82\nto = 1.87\n[[tumble.flight]]\nfrom = 3.2\nto = 4.1\n");
    let report = json(&scratch.run(&["identify", "holed.toml", "--json"]));
    assert!(codes(&report).contains(&"identify.gap"), "{:?}", codes(&report));
    // A catch at the end of a stated flight.
    scratch.write("caught.toml", &format!("[tumble]\nlog = \"{}\"\n[[tumble.flight]]\nfrom = 0.82\nto = 2.2\n[[tumble.flight]]\nfrom = 3.2\nto = 4.1\n", example("identify/racket-like.csv")));
    let report = json(&scratch.run(&["identify", "caught.toml", "--json"]));
    assert!(codes(&report).contains(&"identify.hand"), "{:?}", codes(&report));
}
