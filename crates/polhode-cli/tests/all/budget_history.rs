//! Parts lists over time, tested through the command.

use std::fs;

use polhode::math::{Attitude, Direction, Position};
use polhode::motion::{Exit, Outflow, Simulation, State};
use polhode_budget::read as budget;

use crate::common::{Scratch, example, json, number, refused, stdout};

#[test]
fn the_rocket_burns_and_drops_its_motor() {
    let scratch = Scratch::new("budget-over-time");
    let rocket = example("budget/sounding-rocket.xlsx");
    let text = stdout(&scratch.run(&["budget", &rocket, "--configuration", "lift-off", "--draws", "200"]));
    for said in
        ["Over time", "Mass properties by fill level", "motor, fins dropped", "28.6 kg in \"propellant\""]
    {
        assert!(text.contains(said), "{said}: {text}");
    }
    let data = json(&scratch.run(&["budget", &rocket, "--json", "--draws", "200"]));
    let [lift_off, burnout] = [0, 1].map(|k| &data["configurations"][k]["changing"]);
    assert!(burnout["over_time"].is_null() && burnout["by_fill"].as_array().unwrap().is_empty());
    let file = budget::read(rocket.as_ref()).unwrap();
    let prescribed = file.prescribed.as_ref().unwrap();
    let sequence = prescribed.sequence(Some("lift-off"), file.questions.basis).unwrap();
    // M, z and Izz with their rates, for a row during the burn.
    let rows = lift_off["over_time"]["rows"].as_array().unwrap();
    let row = rows.iter().find(|row| number(&row["time"]) > 3.0).unwrap();
    let want = sequence.at(number(&row["time"])).unwrap();
    let body = want.properties;
    for (found, want) in [
        (&row["mass"], body.mass()),
        (&row["center_of_mass"][2], body.center_of_mass().z),
        (&row["inertia"][2][2], body.inertia().matrix()[2][2]),
        (&row["rates"]["mass"], -28.36 / 6.2),
        (&row["rates"]["center_of_mass"][2], want.rates.center_of_mass.z),
        (&row["rates"]["inertia"][0][0], want.rates.inertia[0]),
    ] {
        assert!((number(found) / want - 1.0).abs() < 1e-12, "{found} {want}");
    }
    let full = lift_off["by_fill"][0]["rows"].as_array().unwrap().last().unwrap();
    let at_first = sequence.at(0.0).unwrap().properties;
    assert!((number(&full["mass"]) / at_first.mass() - 1.0).abs() < 1e-12);
    let page = stdout(&scratch.run(&["budget", &rocket, "--html", "--draws", "200"]));
    assert!(page.contains("Mass over time") && page.matches("<svg").count() >= 6);
}

#[test]
fn the_scenario_moves_as_the_sequence_does() {
    let scratch = Scratch::new("budget-scenario");
    let rocket = example("budget/sounding-rocket.xlsx");
    stdout(&scratch.run(&["budget", &rocket, "--scenario", "rocket.toml"]));
    stdout(&scratch.run(&["simulate", "rocket.toml", "--output", "run"]));
    let summary: serde_json::Value =
        serde_json::from_str(&fs::read_to_string(scratch.0.join("run/summary.json")).unwrap()).unwrap();
    let file = budget::read(rocket.as_ref()).unwrap();
    let prescribed = file.prescribed.as_ref().unwrap();
    let sequence = prescribed.sequence(Some("lift-off"), file.questions.basis).unwrap();
    let over_time = prescribed.over_time.as_ref().unwrap();
    let left = sequence.at(20.0).unwrap().properties.mass();
    let found = number(&summary["mass_history"]["final"]["mass_kg"]);
    assert!((found / left - 1.0).abs() < 1e-12 && left < 25.0, "{found} {left}");
    // The same motion, computed from a history with finer cubics and an exit defined here.
    let exit = Exit {
        share: 1.0,
        position: Position::new(0.0, 0.0, 2.777),
        axis: Direction::new(0.0, 0.0, 1.0),
        radius: 0.061,
    };
    let history = sequence.history([0.0, 20.0], 64, Outflow::Exits(vec![exit])).unwrap();
    let rotor = history.rotor(0.0, None).unwrap();
    let start = State { time: 0.0, attitude: Attitude::identity(), omega: over_time.spin.unwrap() };
    let run = Simulation::new(&rotor, &[], start, &[20.0]).changing(Some(&history)).run().unwrap();
    let omega = run.samples().last().unwrap().state.omega.to_array();
    let apart = (0..3).map(|k| (number(&summary["final"]["omega_body"][k]) - omega[k]).abs());
    let apart = apart.fold(0.0, f64::max);
    assert!(apart < 1e-4 * start.omega.norm(), "{apart:e} {omega:?}");

    let error = refused(&scratch.run(&["budget", &rocket, "--scenario", "rocket.toml"]), 2);
    assert!(error.contains("already exists"), "{error}");
    stdout(&scratch.run(&["budget", &rocket, "--scenario", "rocket.toml", "--force"]));
    let error = refused(&scratch.run(&["budget", &rocket, "--scenario", "rocket.csv"]), 2);
    assert!(error.contains("a scenario is a TOML file"), "{error}");
    let error = refused(&scratch.run(&["budget", &example("budget/cubesat.csv"), "--scenario", "a.toml"]), 2);
    assert!(error.contains("the list has no sequence"), "{error}");
    let list = "# [[tank]]\n# name = \"water\"\n# shape = \"sphere\"\n# radius = 0.2\n# density = 1000\n# settles = \"-z\"\n# fill = 0.5\n\
                # [sequence]\n# until = 9\n# [[burn]]\n# tank = \"water\"\n# until = 5\n# flow = 1\nname,mass,x,y,z\na,4,1,0,0\nb,4,-1,1,0\nc,4,0,-1,1\n";
    scratch.write("list.csv", list);
    let error = refused(&scratch.run(&["budget", "list.csv", "--scenario", "a.toml"]), 2);
    assert!(error.contains("[[exit]] with position") && !scratch.0.join("a.csv").exists(), "{error}");
    scratch.write("list.csv", &list.replace("# until = 9", "# until = 9\n# in_place = true"));
    let error = refused(&scratch.run(&["budget", "list.csv", "--scenario", "list.toml", "--force"]), 2);
    assert!(error.contains("list.csv is an input file and would be overwritten"), "{error}");
    let error = refused(&scratch.run(&["budget", "list.csv", "--xlsx", "./list.csv", "--force"]), 2);
    assert!(error.contains("is an input file and would be overwritten"), "{error}");
    stdout(&scratch.run(&["budget", "list.csv", "--scenario", "a.toml"]));
    stdout(&scratch.run(&["simulate", "a.toml", "--output", "run-a"]));
}

/// Splits CSV into headings and rows.
fn table(text: &str) -> (Vec<String>, Vec<Vec<String>>) {
    let mut lines = text.lines().map(|line| line.split(',').map(str::to_owned).collect::<Vec<_>>());
    let headings = lines.next().unwrap();
    (headings, lines.collect())
}

#[test]
fn states_are_tables() {
    let scratch = Scratch::new("budget-states");
    let rocket = example("budget/sounding-rocket.xlsx");
    let file = budget::read(rocket.as_ref()).unwrap();
    let sequence =
        file.prescribed.as_ref().unwrap().sequence(Some("lift-off"), file.questions.basis).unwrap();
    let text = stdout(&scratch.run(&["budget", &rocket, "--csv=time"]));
    let (headings, rows) = table(&text);
    let cell = |row: &[String], name: &str| -> f64 {
        row[headings.iter().position(|heading| heading == name).unwrap()].parse().unwrap()
    };
    // Mass properties jump or have corners at 6.2 s, 12 s and 20 s; these rows are skipped.
    assert_eq!(rows.len(), 3 * 17);
    for row in rows.iter().filter(|row| ![6.2, 12.0, 20.0].contains(&cell(row, "time_s"))) {
        let want = sequence.at(cell(row, "time_s")).unwrap();
        assert_eq!(row[0], "lift-off");
        for (name, want) in [
            ("mass_kg", want.properties.mass()),
            ("center_z_m", want.properties.center_of_mass().z),
            ("inertia_yy_kg_m2", want.properties.inertia().matrix()[1][1]),
            ("mass_rate_kg_s", want.rates.mass),
            ("center_rate_z_m_s", want.rates.center_of_mass.z),
            ("inertia_rate_zz_kg_m2_s", want.rates.inertia[2]),
            ("liquid_kg propellant", want.liquid[0]),
        ] {
            assert!((cell(row, name) - want).abs() < 1e-12, "{name}: {row:?} {want}");
        }
    }
    // Except for the tank contents, the table equals that of --scenario, so a scenario may use it.
    stdout(&scratch.run(&["budget", &rocket, "--scenario", "rocket.toml"]));
    let beside = fs::read_to_string(scratch.0.join("rocket.csv")).unwrap();
    for (all, line) in text.lines().zip(beside.lines()) {
        assert_eq!(all.split(',').skip(1).take(21).collect::<Vec<_>>().join(","), line);
    }
    scratch.write("rocket.csv", &text);
    stdout(&scratch.run(&["simulate", "rocket.toml", "--output", "run"]));

    // Fill table with derivatives: between two rows the moments about the origin are linear in the
    // mass of the liquid, so differences give the slopes.
    let fill = stdout(&scratch.run(&["budget", &rocket, "--csv=fill"]));
    let (headings, rows) = table(&fill);
    let cell = |row: &[String], name: &str| -> f64 {
        row[headings.iter().position(|heading| heading == name).unwrap()].parse().unwrap()
    };
    assert_eq!(rows.len(), 21);
    // M, S and the tensor about the origin.
    let moments = |row: &[String]| {
        let [m, x, y, z, xx, zz] =
            ["mass_kg", "center_x_m", "center_y_m", "center_z_m", "inertia_xx_kg_m2", "inertia_zz_kg_m2"]
                .map(|name| cell(row, name));
        [m, m * x, m * y, m * z, xx + m * (y * y + z * z), zz + m * (x * x + y * y)]
    };
    let slopes = |from: &[String], to: &[String]| {
        let (from, to) = (moments(from), moments(to));
        [1, 2, 3, 4, 5].map(|k| (to[k] - from[k]) / (to[0] - from[0]))
    };
    let mut straight = 0;
    for three in rows.windows(3) {
        let [low, row, high] = [0, 1, 2].map(|k| &three[k]);
        let [before, after] = [slopes(low, row), slopes(row, high)];
        if before.iter().zip(after).any(|(a, b)| (a - b).abs() > 1e-9) {
            continue;
        }
        straight += 1;
        let [m, sx, sy, sz, ..] = moments(row);
        let [x, y, z] = [sx, sy, sz].map(|s| s / m);
        let [dx, dy, dz] = [before[0] - x, before[1] - y, before[2] - z].map(|d| d / m);
        for (name, want) in [
            ("center_x_m_per_kg", dx),
            ("center_z_m_per_kg", dz),
            ("inertia_xx_kg_m2_per_kg", before[3] - (y * y + z * z) - 2.0 * m * (y * dy + z * dz)),
            ("inertia_zz_kg_m2_per_kg", before[4] - (x * x + y * y) - 2.0 * m * (x * dx + y * dy)),
        ] {
            let found = cell(row, name);
            assert!(found != 0.0 && (found - want).abs() < 1e-11, "{name}: {found} {want}");
        }
    }
    assert!(straight >= 5, "{straight}");

    stdout(&scratch.run(&["budget", &rocket, "--xlsx", "out.xlsx"]));
    let error = refused(&scratch.run(&["budget", "out.xlsx"]), 2);
    assert!(error.contains("parts, whole, covariance, over time, by fill"), "{error}");
    stdout(&scratch.run(&["budget", &rocket, "--xlsx", "burnt.xlsx", "--configuration", "burnout"]));
    let error = refused(&scratch.run(&["budget", "burnt.xlsx"]), 2);
    assert!(error.contains("parts, whole, covariance"), "{error}");
    let list = example("budget/cubesat.csv");
    for (form, expected) in
        [("--csv=time", "the list has no sequence"), ("--csv=fill", "the list has no tank")]
    {
        let error = refused(&scratch.run(&["budget", &list, form]), 2);
        assert!(error.contains(expected), "{error}");
    }
    let rows = |form: &str| stdout(&scratch.run(&["budget", &list, form]));
    assert_eq!(rows("--csv"), rows("--csv=parts"));
}

/// If one of the two files cannot be written, neither is written.
#[test]
fn a_scenario_comes_with_its_table_or_not_at_all() {
    let scratch = Scratch::new("budget-pair");
    let rocket = example("budget/sounding-rocket.xlsx");
    fs::create_dir(scratch.0.join("rocket.toml")).unwrap();
    let names = || {
        let mut names: Vec<String> = fs::read_dir(&scratch.0)
            .unwrap()
            .map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned())
            .collect();
        names.sort();
        names
    };
    let asked = ["budget", &rocket, "--scenario", "rocket.toml", "--force"];
    let failed = || refused(&scratch.run(&asked), 2);
    assert!(failed().contains("rocket.toml"));
    assert_eq!(names(), ["rocket.toml"]);
    // Existing files are kept.
    scratch.write("rocket.csv", "mine");
    assert!(failed().contains("rocket.toml"));
    assert_eq!(names(), ["rocket.csv", "rocket.toml"]);
    assert_eq!(fs::read_to_string(scratch.0.join("rocket.csv")).unwrap(), "mine");
    fs::remove_dir(scratch.0.join("rocket.toml")).unwrap();
    stdout(&scratch.run(&asked));
    assert_eq!(names(), ["rocket.csv", "rocket.toml"]);
    assert!(fs::read_to_string(scratch.0.join("rocket.csv")).unwrap().starts_with("time_s,"));
}

/// The uncertainty of a tank's contents enters all results: largest errors, limits and draws.
#[test]
fn a_liquid_has_errors() {
    let scratch = Scratch::new("budget-liquid");
    let list = "# [[tank]]\n# name = \"water\"\n# shape = \"sphere\"\n# radius = 0.2\n# density = \"1000 kg/m^3 ± 1 %\"\n# settles = \"-z\"\n# fill = \"50 % ± 2 %\"\n\
                # [[limit]]\n# of = \"mass\"\n# most = 29\nname,mass,x,y,z\na,4 ± 0.1,1,0,0\nb,4,-1,1,0\nc,4,0,-1,1\n";
    scratch.write("list.csv", list);
    let data = json(&scratch.run(&["budget", "list.csv", "--json", "--draws", "4000"]));
    let one = &data["configurations"][0];
    let half = 1000.0 * 2.0 / 3.0 * std::f64::consts::PI * 0.008;
    let sd = (0.01 + (0.04 * half).powi(2) + (0.01 * half).powi(2)).sqrt();
    let text = serde_json::to_string(one).unwrap();
    assert!(text.contains("\"of\":\"density\""), "{text}");
    let shown = stdout(&scratch.run(&["budget", "list.csv", "--draws", "4000"]));
    for said in ["water, mass: 8", "its density ± 1 %", "± 0.67 kg in \"water\""] {
        assert!(shown.contains(said), "{said}: {shown}");
    }
    let file = budget::read(&scratch.0.join("list.csv")).unwrap();
    let estimate = file.configurations[0].budget.estimate(file.questions.basis).unwrap();
    assert!((estimate.sd(0) / sd - 1.0).abs() < 1e-12, "{} {sd}", estimate.sd(0));
    // The limit is 0.35 standard deviations above the mean.
    let probability = number(&one["limits"]["each"][0]["draws"]["probability"]);
    assert!((0.55..0.75).contains(&probability), "{probability}");
}

/// A hint does not suggest a change that is already in the file.
#[test]
fn a_history_that_is_none_has_a_hint_that_helps() {
    let scratch = Scratch::new("budget-history-hints");
    let tank = "# [[tank]]\n# name = \"gas\"\n# mass = 3\n# table = [{ mass = 1, center = [0.1, 0.2, 0] }, { mass = 3, center = [0.3, 0.1, 0] }]\n";
    let burn = "# [[burn]]\n# tank = \"gas\"\n# until = 9\n# flow = 0.1\n";
    let drop = "# [[drop]]\n# time = 10\n# rows = [\"d\"]\n";
    let rows = "name,mass [kg],x [mm],y [mm]\na,2,100,7\nb,1,-50,20\nd,1,5,120\n";
    for (place, parts, expected) in [
        ("", format!("{tank}{burn}{rows}"), "[[exit]] with position, or in_place = true"),
        ("# in_place = true\n", format!("{tank}{burn}{rows}"), "[[exit]] with position, without in_place"),
        ("", format!("{drop}{rows}"), "without inertia about some axis"),
    ] {
        scratch.write("list.csv", &format!("# [sequence]\n# until = 20\n{place}{parts}"));
        let error = refused(&scratch.run(&["budget", "list.csv", "--scenario", "out.toml"]), 2);
        assert!(error.contains(expected), "{expected}: {error}");
        assert_eq!(error.contains("[[exit]]"), expected.contains("[[exit]]"), "{error}");
    }
}

/// Each row names the configuration of the body at that time, and each tank row its own.
#[test]
fn rows_have_their_own_configurations() {
    let scratch = Scratch::new("budget-states-configurations");
    let change = |time: f64, to: &str| format!("# [[deploy]]\n# time = {time}\n# configuration = \"{to}\"\n");
    let changes = [(30.0, "b"), (10.0, "b"), (20.0, "a")].map(|(time, to)| change(time, to)).concat();
    let list = format!(
        "# configurations = [\"b\", \"a\"]\n# [sequence]\n# configuration = \"a\"\n# until = 40\n{changes}# [[drop]]\n# time = 35\n# rows = [\"lid\"]\n\
         # [[tank]]\n# name = \"fuel\"\n# shape = \"sphere\"\n# radius = \"10 cm\"\n# density = 900\n# settles = \"-z\"\n# mass = \"1 kg\"\n\
         name,configuration,mass [kg],x [mm],y [mm],z [mm]\nbus,,5,0,1,2\nbox,,2,9,-7,4\nlid,,0.5,1,7,40\narm,a,1,100,0,3\narm,b,1,200,0,3\n"
    );
    scratch.write("list.csv", &list);
    let (headings, rows) = table(&stdout(&scratch.run(&["budget", "list.csv", "--csv=time"])));
    let center = headings.iter().position(|name| name == "center_x_m").unwrap();
    let of = |row: &[String]| (row[0].clone(), row[1].parse::<f64>().unwrap(), row[center].clone());
    let all: Vec<(String, f64, String)> = rows.iter().map(|row| of(row)).collect();
    let mut stretches: Vec<(&str, f64)> = Vec::new();
    for (name, time, _) in &all {
        if stretches.last().is_none_or(|(last, _)| last != name) {
            stretches.push((name, *time));
        }
    }
    assert_eq!(stretches, [("a", 0.0), ("b", 10.0), ("a", 20.0), ("b", 30.0)]);
    // A configuration always has the same body, until something is dropped.
    let centers = |wanted: &str| {
        let some = all.iter().filter(|(name, time, _)| name == wanted && *time < 35.0);
        some.map(|(_, _, center)| center).collect::<std::collections::BTreeSet<_>>()
    };
    assert!(centers("a").len() == 1 && centers("b").len() == 1 && centers("a") != centers("b"));
    let (_, rows) = table(&stdout(&scratch.run(&["budget", "list.csv", "--csv=fill"])));
    let names: Vec<&str> = rows.iter().map(|row| row[0].as_str()).collect();
    assert_eq!(names, [["b"; 21], ["a"; 21]].concat());
    let report = json(&scratch.run(&["budget", "list.csv", "--json", "--draws", "0"]));
    let changing = &report["configurations"][1]["changing"]["over_time"];
    assert_eq!(changing["rows"].as_array().unwrap().last().unwrap()["configuration"], "b", "{report}");
    // A configuration that is not the initial one has no rows; the error names the initial one.
    let error = refused(&scratch.run(&["budget", "list.csv", "--csv=time", "--configuration", "b"]), 2);
    assert!(error.contains("the sequence begins in \"a\""), "{error}");
}
