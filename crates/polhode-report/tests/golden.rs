//! The screens as a reader sees them, word for word.
//!
//! `POLHODE_GOLDEN=write cargo test -p polhode-report --test golden` writes them anew; read the difference.
#![allow(clippy::unwrap_used, reason = "a test that cannot go on should stop")]

mod common;

use std::path::Path;

use polhode::{Body, Position, Rotation, Scenario};
use polhode_report::{InertiaReport, MotionReport, SourceInfo, explain, pretty};

fn check(name: &str, got: &str) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden").join(name);
    if std::env::var_os("POLHODE_GOLDEN").is_some() {
        std::fs::write(&path, got).unwrap();
    }
    let want = std::fs::read_to_string(&path).unwrap_or_default();
    for (k, (got, want)) in got.lines().zip(want.lines()).enumerate() {
        assert_eq!(got, want, "{name}, line {}", k + 1);
    }
    assert_eq!(got.lines().count(), want.lines().count(), "{name}: lines are missing or new");
}

fn source(name: &str) -> SourceInfo {
    SourceInfo::new(name, "scenario")
}

fn inertia(scenario: &Scenario) -> InertiaReport {
    let words = format!("scenario, {} parts", scenario.parts.len());
    InertiaReport {
        show_axes: true,
        ..InertiaReport::of_scenario(source("body.toml").described(words), scenario)
    }
}

fn motion(scenario: &Scenario) -> (String, String) {
    let trajectory = scenario.simulate().unwrap().unwrap();
    let report = MotionReport::new(source("motion.toml"), scenario, &trajectory);
    (report.to_text(), pretty(&report.summary_json()))
}

#[test]
fn inertia_of_a_mesh() {
    let scenario = common::t_handle();
    let mut report = inertia(&scenario);
    report.source = SourceInfo::new("bracket.stl", "stl")
        .described("STL binary, 20,480 triangles, closed, consistently wound, 1 component")
        .with("triangles", 20_480);
    report.show_axes = false;
    check("inertia.txt", &report.to_text());
    report.about = Some(Position::<Body>::new(0.01, 0.0, -0.02));
    report.axes = Some(Rotation::about(polhode::Direction::new(0.0, 1.0, 1.0), 0.5).unwrap());
    report.show_axes = true;
    check("inertia_axes.txt", &report.to_text());
    check("inertia.json", &pretty(&report.to_json()));
    check("inertia_cube.txt", &inertia(&common::cube()).to_text());
}

#[test]
fn motions() {
    for (name, scenario) in [
        ("t_handle", common::t_handle()),
        ("symmetric_top", common::symmetric_top()),
        ("dumbbell", common::dumbbell()),
        ("pendulum", common::pendulum()),
        ("thruster", common::thruster()),
    ] {
        let (text, json) = motion(&scenario);
        check(&format!("motion_{name}.txt"), &text);
        if name == "symmetric_top" {
            check("motion_symmetric_top.json", &json);
        }
    }
}

#[test]
fn explanations() {
    for (name, scenario) in [
        ("t_handle", common::t_handle()),
        ("symmetric_top", common::symmetric_top()),
        ("dumbbell", common::dumbbell()),
        ("pendulum", common::pendulum()),
        ("cube", common::cube()),
        ("thruster", common::thruster()),
        ("gyroscope", common::gyroscope()),
        ("rod", common::rod()),
        ("point", common::point()),
    ] {
        let document = explain(&scenario).unwrap();
        check(&format!("explain_{name}.txt"), &document.to_text(100));
        if name == "dumbbell" {
            check("explain_dumbbell.md", &document.to_markdown());
        }
    }
}
