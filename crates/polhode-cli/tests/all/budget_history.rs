//! A parts list over time, as users of the command meet it.

use std::fs;

use polhode::math::{Attitude, Direction, Position};
use polhode::motion::{Exit, Outflow, Simulation, State};
use polhode_formats::budget;

use crate::common::{Scratch, example, json, number, refused, stdout};

#[test]
fn the_rocket_burns_and_drops_its_motor() {
    let scratch = Scratch::new("budget-over-time");
    let rocket = example("budget/sounding-rocket.xlsx");
    let text = stdout(&scratch.run(&["budget", &rocket, "--configuration", "lift-off", "--draws", "200"]));
    for said in ["Over time", "By how full the tanks are", "motor, fins dropped", "28.6 kg in \"propellant\""]
    {
        assert!(text.contains(said), "{said}: {text}");
    }
    let data = json(&scratch.run(&["budget", &rocket, "--json", "--draws", "200"]));
    let [lift_off, burnout] = [0, 1].map(|k| &data["configurations"][k]["changing"]);
    assert!(burnout["over_time"].is_null() && burnout["by_fill"].as_array().unwrap().is_empty());
    let file = budget::read(rocket.as_ref()).unwrap();
    let prescribed = file.prescribed.as_ref().unwrap();
    let sequence = prescribed.sequence(Some("lift-off"), file.questions.basis).unwrap();
    // Of a row in which the propellant burns, M, z and Izz with their rates.
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
    // The same motion, of a history with finer cubics and an exit that is written here.
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
    assert!(error.contains("is there already"), "{error}");
    stdout(&scratch.run(&["budget", &rocket, "--scenario", "rocket.toml", "--force"]));
    let error = refused(&scratch.run(&["budget", &rocket, "--scenario", "rocket.csv"]), 2);
    assert!(error.contains("a scenario is a TOML file"), "{error}");
    let error = refused(&scratch.run(&["budget", &example("budget/cubesat.csv"), "--scenario", "a.toml"]), 2);
    assert!(error.contains("nothing happens in it over time"), "{error}");
    let list = "# [[tank]]\n# name = \"water\"\n# shape = \"sphere\"\n# radius = 0.2\n# density = 1000\n# settles = \"-z\"\n# fill = 0.5\n\
                # [sequence]\n# until = 9\n# [[burn]]\n# tank = \"water\"\n# until = 5\n# flow = 1\nname,mass,x,y,z\na,4,1,0,0\nb,4,-1,1,0\nc,4,0,-1,1\n";
    scratch.write("list.csv", list);
    let error = refused(&scratch.run(&["budget", "list.csv", "--scenario", "a.toml"]), 2);
    assert!(error.contains("[[exit]] with position") && !scratch.0.join("a.csv").exists(), "{error}");
    scratch.write("list.csv", &list.replace("# until = 9", "# until = 9\n# in_place = true"));
    let error = refused(&scratch.run(&["budget", "list.csv", "--scenario", "list.toml", "--force"]), 2);
    assert!(error.contains("list.csv is read, and would be overwritten"), "{error}");
    let error = refused(&scratch.run(&["budget", "list.csv", "--xlsx", "./list.csv", "--force"]), 2);
    assert!(error.contains("is read, and would be overwritten"), "{error}");
    stdout(&scratch.run(&["budget", "list.csv", "--scenario", "a.toml"]));
    stdout(&scratch.run(&["simulate", "a.toml", "--output", "run-a"]));
}
