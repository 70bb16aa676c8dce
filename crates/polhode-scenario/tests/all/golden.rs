//! Complete text reports, compared word for word.
//!
//! `POLHODE_GOLDEN=write cargo test -p polhode-scenario --test all golden` writes them again;
//! review the difference.

use std::path::Path;

use polhode::body::{InertiaTensor, MassProperties, PrincipalFrame};
use polhode::math::{AngularVelocity, Attitude, Body, Position, Rotation};
use polhode::motion::{FreeMotion, Scenario, State};
use polhode::observe::{AxisConvention, TumblingPeriods};
use polhode_document::SourceInfo;
use polhode_document::json::pretty;
use polhode_scenario::report::{MotionReport, SpinReport, TumblerReport, explain};
use polhode_shape::export;
use polhode_shape::report::InertiaReport;
use polhode_shape::{ExportBody, ExportFormat};

/// Lines on rounding or the integrator's steps. They change with the core, and other tests bound
/// them.
const EVIDENCE: [&str; 16] = [
    "L in space  ",
    "T           ",
    "|L|         ",
    "T − work  ",
    "L − impulse  ",
    "T + U  ",
    "attitude error",
    "error of ω",
    "T constant to",
    "L constant in space to",
    "T - T(t0)",
    "L - L(t0)",
    "T + U constant",
    "estimated error",
    "cross ",
    "e · (ω × L)",
];

/// Returns the text without the numbers of the lines in `EVIDENCE`.
fn without_evidence(text: &str) -> String {
    let line = |line: &str| match EVIDENCE.iter().find(|head| line.trim_start().starts_with(**head)) {
        Some(head) => format!("{}{head} …\n", &line[..line.len() - line.trim_start().len()]),
        None => format!("{}\n", line.split(" (differs by").next().unwrap_or(line)),
    };
    text.lines().map(line).collect()
}

fn check(name: &str, got: &str) {
    let got = &without_evidence(got);
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/all/golden").join(name);
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
    let words = format!("scenario, {} parts", scenario.parts().len());
    InertiaReport::of_scenario(source("body.toml").described(words), scenario)
}

fn motion(scenario: &Scenario) -> String {
    let trajectory = scenario.simulate().unwrap().unwrap();
    MotionReport::new(source("motion.toml"), scenario, &trajectory).to_text()
}

#[test]
fn inertia_of_a_mesh() {
    let scenario = crate::common::t_handle();
    let mut report = inertia(&scenario);
    report.source = SourceInfo::new("bracket.stl", "stl")
        .described("STL binary, 20,480 triangles, closed, consistently wound, 1 component")
        .with("triangles", 20_480);
    check("inertia.txt", &report.to_text());
    report.about = Some(Position::<Body>::new(0.01, 0.0, -0.02));
    report.axes = Some(Rotation::from_axis_angle(polhode::math::Direction::new(0.0, 1.0, 1.0), 0.5).unwrap());
    check("inertia_axes.txt", &report.to_text());
    check("inertia.json", &pretty(&report.to_json()));
    check("inertia_cube.txt", &inertia(&crate::common::cube()).to_text());
}

#[test]
fn motions() {
    for (name, scenario) in [
        ("t_handle", crate::common::t_handle()),
        ("symmetric_top", crate::common::symmetric_top()),
        ("dumbbell", crate::common::dumbbell()),
        ("pendulum", crate::common::pendulum()),
        ("thruster", crate::common::thruster()),
        ("gyrostat", crate::common::gyrostat()),
    ] {
        check(&format!("motion_{name}.txt"), &motion(&scenario));
    }
}

#[test]
fn explanations() {
    for (name, scenario) in [
        ("t_handle", crate::common::t_handle()),
        ("symmetric_top", crate::common::symmetric_top()),
        ("dumbbell", crate::common::dumbbell()),
        ("pendulum", crate::common::pendulum()),
        ("cube", crate::common::cube()),
        ("thruster", crate::common::thruster()),
        ("gyroscope", crate::common::gyroscope()),
        ("rod", crate::common::rod()),
        ("point", crate::common::point()),
    ] {
        let document = explain(&scenario).unwrap();
        check(&format!("explain_{name}.txt"), &document.to_text(100));
        if name == "dumbbell" {
            check("explain_dumbbell.md", &document.to_markdown());
        }
    }
}

#[test]
fn spins() {
    let spin = |moments: [f64; 3], omega: [f64; 3]| {
        let omega = AngularVelocity::from_array(omega);
        let start = State { time: 0.0, attitude: Attitude::identity(), omega };
        SpinReport::new(None, FreeMotion::of_moments(moments, start).unwrap())
    };
    for (name, report) in [
        ("flips", spin([1.0, 2.0, 3.0], [0.01, 1.0, 0.01]).at(&[0.0]).unwrap()),
        ("equilibrium", spin([1.0, 2.0, 3.0], [0.0, 1.0, 0.0])),
        ("separatrix", spin([10.0, 13.0, 15.0], [1.0, 0.5, 1.0])),
        ("toutatis", spin([3.0836, 3.235, 1.0], [2.931e-6, 6.773e-6, -1.994e-5])),
        ("symmetric_top", spin([2.0, 1.5, 2.0], [0.3, -1.2, 0.4])),
        ("impossible", spin([8.0, 4.0, 0.4], [0.0, 0.0, 5.0])),
    ] {
        check(&format!("spin_{name}.txt"), &report.to_text());
    }
    let scenario = crate::common::t_handle();
    let thrown = FreeMotion::of(scenario.rotor(), scenario.start()).unwrap();
    let source = SourceInfo::new("t-handle.toml", "scenario").described("T-handle in free fall");
    let report = SpinReport::new(Some(source), thrown).found(scenario.findings().to_vec());
    check("spin_t_handle.txt", &report.to_text());

    let brick = PrincipalFrame::of(&InertiaTensor::diagonal([1.0, 2.0, 2.5]).unwrap());
    let periods = TumblingPeriods { precession: 2.0, rotation: 5.0 };
    let report = TumblerReport::new(None, brick, periods, AxisConvention::LongAxis).unwrap();
    check("spin_periods.txt", &report.to_text());
}

#[test]
fn exports() {
    let inertia = InertiaTensor::with_negative_products([3.1, 4.2, 5.3], [0.4, -0.3, 0.2]).unwrap();
    let bracket = MassProperties::new(2.3, Position::new(0.11, -0.07, 0.23), inertia).unwrap();
    let bracket =
        ExportBody { volume: Some(0.0009), density: Some(2555.5), ..ExportBody::new("bracket", bracket) };
    let handle = ExportBody::new("T-handle", *crate::common::t_handle().body());
    for &format in ExportFormat::ALL {
        let bodies = [bracket.clone(), handle.clone()];
        let one = [ExportFormat::Urdf, ExportFormat::JsbSim, ExportFormat::RocketPy, ExportFormat::Basilisk];
        let bodies = if one.contains(&format) { &bodies[..1] } else { &bodies[..] };
        let name = format!("export_{}.{}", format.name(), format.extension());
        check(&name, &export(format, bodies).unwrap());
    }
}
