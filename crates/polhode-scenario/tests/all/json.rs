//! JSON for other programs: keys, their order, and bit-identical numbers.

use polhode::body::{Finding, Severity};
use polhode::motion::{FreeMotion, Run, SplittingOrder};
use polhode::prelude::*;
use polhode_document::SourceInfo;
use polhode_document::json::pretty;
use polhode_scenario::report::{MotionReport, RequiredReport, SpinReport, StabilityReport, explain};
use polhode_scenario::request::explain as worked;
use polhode_scenario::request::{simulate, spin, stability, torque};
use polhode_shape::report::InertiaReport;
use serde_json::Value;

use crate::fit::require_fits;

fn keys(value: &Value) -> Vec<&str> {
    value.as_object().unwrap().keys().map(String::as_str).collect()
}

fn floats(value: &Value) -> Vec<f64> {
    match value {
        Value::Array(items) => items.iter().flat_map(floats).collect(),
        other => vec![other.as_f64().unwrap()],
    }
}

fn bits(values: &[f64]) -> Vec<u64> {
    values.iter().map(|x| x.to_bits()).collect()
}

fn generic() -> MassProperties<Body> {
    let inertia = InertiaTensor::with_negative_products([3.1, 4.2, 5.3], [0.4, -0.3, 0.2]).unwrap();
    MassProperties::new(2.3, Position::new(0.11, -0.07, 0.23), inertia).unwrap()
}

#[test]
fn the_keys_of_inertia_are_the_contract() {
    let mut report = InertiaReport::new(SourceInfo::new("a.stl", "stl").with("triangles", 12), generic());
    report.volume = Some(0.5);
    let json = report.to_json();
    let contract = [
        "polhode",
        "source",
        "mass",
        "volume",
        "surface_area",
        "density",
        "center_of_mass",
        "inertia",
        "principal",
        "gyration_radii",
        "findings",
    ];
    assert_eq!(keys(&json), contract);
    assert_eq!(keys(&json["source"]), ["path", "format", "triangles"]);
    assert_eq!(keys(&json["inertia"]), ["about", "axes", "products", "tensor"]);
    assert_eq!(keys(&json["principal"]), ["moments", "axes", "quaternion_wxyz", "symmetry"]);
    assert_eq!(json["inertia"]["about"], "center_of_mass");
    assert_eq!(json["inertia"]["axes"], "body");
    assert_eq!(json["inertia"]["products"], "negative_integral");
    assert_eq!(json["principal"]["symmetry"], "asymmetric");
    assert_eq!(json["volume"], 0.5);
    assert!(json["surface_area"].is_null() && json["density"].is_null());
    assert_eq!(json["findings"], Value::Array(Vec::new()));

    report.about = Some(Position::new(0.3, -0.2, 0.1));
    report.axes = Some(Rotation::from_axis_angle(Direction::new(1.0, 2.0, -1.0), 0.8).unwrap());
    report.findings.push(Finding {
        code: "mesh.open",
        severity: Severity::Error,
        message: "open".to_owned(),
        place: None,
    });
    let json = report.to_json();
    let more = [&contract[..10], &["inertia_about", "inertia_in_axes"], &contract[10..]].concat();
    assert_eq!(keys(&json), more);
    assert_eq!(keys(&json["inertia_about"])[..2], ["point", "tensor"]);
    assert_eq!(keys(&json["findings"][0]), ["code", "severity", "message", "where"]);
    assert!(json["findings"][0]["where"].is_null());
}

#[test]
fn numbers_read_back_bit_for_bit() {
    let body = generic();
    let mut report = InertiaReport::new(SourceInfo::new("a.toml", "scenario"), body);
    let (point, turn) = (
        Position::new(0.3, -0.2, 0.1),
        Rotation::from_axis_angle(Direction::new(1.0, 2.0, -1.0), 0.8).unwrap(),
    );
    (report.about, report.axes) = (Some(point), Some(turn));
    for text in [report.to_json().to_string(), pretty(&report.to_json())] {
        let json: Value = serde_json::from_str(&text).unwrap();
        let same = |value: &Value, want: &[f64]| assert_eq!(bits(&floats(value)), bits(want));
        same(&json["mass"], &[2.3]);
        same(&json["center_of_mass"], &[0.11, -0.07, 0.23]);
        same(&json["inertia"]["tensor"], body.inertia().matrix().as_flattened());
        let principal = body.principal();
        same(&json["principal"]["moments"], &principal.moments());
        same(&json["principal"]["axes"], principal.axes().map(Vector::to_array).as_flattened());
        same(&json["principal"]["quaternion_wxyz"], &principal.rotation().canonical_quaternion());
        same(&json["gyration_radii"], &body.gyration_radii());
        same(&json["inertia_about"]["tensor"], body.inertia_about(point).matrix().as_flattened());
        let along: InertiaTensor<Part> = body.inertia().in_frame(turn.inverse());
        same(&json["inertia_in_axes"]["tensor"], along.matrix().as_flattened());
    }
}

#[test]
fn other_axes_are_the_columns_of_the_rotation() {
    // `R_body_axes` maps the new axis k to body components, and nᵀ I n is independent of the axes.
    let body = generic();
    let turn = Rotation::<Body, Part>::from_axis_angle(Direction::new(1.0, 2.0, -1.0), 0.8).unwrap();
    let report =
        InertiaReport { axes: Some(turn), ..InertiaReport::new(SourceInfo::new("a.toml", "scenario"), body) };
    let tensor = floats(&report.to_json()["inertia_in_axes"]["tensor"]);
    let y = turn * Direction::<Part>::new(0.0, 1.0, 0.0);
    assert!((body.inertia().about_axis(y) - tensor[4]).abs() < 1e-14);
}

#[test]
fn the_summary_has_the_same_keys_for_every_motion() {
    let schema: Value = serde_json::from_str(&simulate::REPORT_SCHEMA).unwrap();
    let [contract, motion] =
        ["/properties", "/properties/motion/properties"].map(|place| keys(schema.pointer(place).unwrap()));
    for scenario in crate::common::all().into_iter().chain([crate::common::gyrostat()]) {
        let Some(trajectory) = scenario.simulate().transpose().unwrap() else { continue };
        let report = MotionReport::new(SourceInfo::new("a.toml", "scenario"), &scenario, &trajectory);
        let json = report.summary_json();
        assert_eq!(keys(&json), contract);
        assert_eq!(keys(&json["motion"]), motion);
        let again: Value = serde_json::from_str(&pretty(&json)).unwrap();
        assert_eq!(again, json);
    }
}

/// Reports on motions of every kind, and of extreme sizes, conform to their schemas.
#[test]
fn reports_fit() {
    for scenario in crate::common::all().into_iter().chain([crate::common::gyrostat()]) {
        let source = || SourceInfo::new("a.toml", "scenario");
        if scenario.run().is_some() {
            require_fits(&simulate::REPORT_SCHEMA, &summary(&scenario));
        }
        if scenario.prescribed().is_some() {
            let particle = Particle::new(0.5, Position::new(1.0, 2.0, 3.0)).unwrap();
            let report = RequiredReport::new(source(), &scenario, &[0.0], &[particle]).unwrap();
            require_fits(&torque::REPORT_SCHEMA, &report.to_json());
        }
        if let Ok(motion) = FreeMotion::of(&Rotor::free(scenario.body()), scenario.start()) {
            let report = SpinReport::new(Some(source().with("title", "A").with("parts", 1)), motion);
            require_fits(&spin::REPORT_SCHEMA, &report.at(&[0.0, 1.0]).unwrap().to_json());
        }
        let report = StabilityReport::of_scenario(source(), &scenario);
        require_fits(&stability::REPORT_SCHEMA, &report.to_json());
        require_fits(&worked::REPORT_SCHEMA, &explain(&scenario).unwrap().to_json());
    }
}

fn summary(scenario: &Scenario) -> Value {
    let trajectory = scenario.simulate().unwrap().unwrap();
    MotionReport::new(SourceInfo::new("a.toml", "scenario"), scenario, &trajectory).summary_json()
}

#[test]
fn a_symmetric_top_tells_its_cones() {
    let scenario = crate::common::symmetric_top();
    let json = summary(&scenario);
    // Cylinder: I_e = m r²/2, I_t = m (3 r² + h²)/12.
    let (axial, transverse) = (0.5 * 4.0 * 0.09, 4.0 * (0.27 + 0.01) / 12.0);
    let top = &json["motion"]["symmetric_top"];
    let near = |value: &Value, want: f64| {
        assert!((value.as_f64().unwrap() / want - 1.0).abs() < 1e-14, "{value} {want}");
    };
    near(&top["axial_moment"], axial);
    near(&top["body_rate_rad_s"], (axial - transverse) / transverse * 2.0);
    near(&top["body_cone_half_angle_rad"], (0.5_f64 / 2.0).atan());
    near(&top["nutation_rad"], (transverse * 0.5 / (axial * 2.0)).atan());
    let l = ((transverse * 0.5).powi(2) + (axial * 2.0).powi(2)).sqrt();
    near(&json["motion"]["momentum_kg_m2_s"], l);
    near(&json["motion"]["precession_period_s"], std::f64::consts::TAU * transverse / l);
    assert!(top["coplanarity"].as_f64().unwrap() < 1e-14);
    assert_eq!(json["run"]["method_used"], "exact");
}

#[test]
fn a_prescribed_motion_tells_torque_and_forces() {
    let [m1, m2, b, omega, alpha] = crate::common::DUMBBELL;
    let json = summary(&crate::common::dumbbell());
    let expected = -(m1 + m2) * b * b * omega * omega * alpha.sin() * alpha.cos();
    let torque = floats(&json["required"]["torque_body_n_m"]);
    assert!((torque[0] - expected).abs() < 1e-14 && torque[1].abs() + torque[2].abs() < 1e-14);
    let forces = json["required"]["particle_forces"].as_array().unwrap();
    for (force, (m, sign)) in forces.iter().zip([(m1, 1.0), (m2, -1.0)]) {
        let across = floats(&force["across_body_n"]);
        let along = floats(&force["along_body_n"]);
        let scale = m * b * omega * omega * alpha.sin();
        assert!((across[1] - sign * scale * alpha.cos()).abs() < 1e-14);
        assert!((along[2] + sign * scale * alpha.sin()).abs() < 1e-14);
    }
    assert!(json["motion"]["regime"].is_null() && json["drift"].is_null());
}

#[test]
fn a_driven_motion_balances_its_energy() {
    let json = summary(&crate::common::thruster());
    assert!(json["motion"]["regime"].is_null());
    assert_eq!(json["motion"]["regime_at_start"], "long_axis"); // L²/2T = 3.64 < i2 = 4.32
    let energy = |key: &str| json["energy"][key].as_f64().unwrap();
    assert!((energy("kinetic_end_j") - energy("kinetic_start_j") - energy("work_j")).abs() < 1e-11);
    assert!(json["run"]["steps"]["accepted"].as_u64().unwrap() > 5);
    assert_eq!(json["torques"][0]["model"], "constant");
    assert!(json["drift"]["kinetic_energy"].is_null());
    let pendulum = summary(&crate::common::pendulum());
    assert_eq!(pendulum["torques"][0]["model"], "gravity");
    assert_eq!(pendulum["pendulum"]["swing"], "oscillation");
    assert!(pendulum["drift"]["total_energy"].as_f64().unwrap() < 1e-10);
}

#[test]
fn wheels_tell_their_ends_and_splitting_its_step() {
    let mut scenario = crate::common::gyrostat();
    let [inertia, torque, from] = crate::common::MOTOR;
    let json = summary(&scenario);
    let [held, turned] = [&json["wheels"][0], &json["wheels"][1]];
    let near = |value: &Value, want: f64| assert!((value.as_f64().unwrap() - want).abs() < 1e-12, "{value}");
    near(&held["momentum_kg_m2_s"], 1.3);
    near(&held["final_momentum_kg_m2_s"], 1.3);
    assert!(held["speed_rad_s"].is_null() && held["final_speed_rad_s"].is_null());
    near(&turned["speed_rad_s"], 12.0);
    let h = turned["momentum_kg_m2_s"].as_f64().unwrap() + torque * (6.0 - from);
    near(&turned["final_momentum_kg_m2_s"], h);
    // h = J (a·ω + Ω)
    let [axis, omega] = [&turned["axis_body"], &json["final"]["omega_body"]].map(floats);
    let along: f64 = axis.iter().zip(&omega).map(|(a, w)| a * w).sum();
    near(&turned["final_speed_rad_s"], h / inertia - along);
    assert!(json["run"]["splitting"].is_null());

    scenario = scenario.with_wheels(&[]).unwrap();
    let method = Method::Splitting { order: SplittingOrder::Four, step: 0.025 };
    scenario = scenario.sampled(Run::evenly(1.0, 3, method, 1e-9));
    let run = &summary(&scenario)["run"];
    assert_eq!((&run["splitting"]["order"], &run["splitting"]["step_s"]), (&4.into(), &0.025.into()));
    assert!(run["tolerance"].is_null());
}

#[test]
fn a_permanent_rotation_has_a_rotation_period_only() {
    let mut scenario = crate::common::tensor("Spin", [3.1, 4.2, 5.3], [0.0; 3], [0.0, 0.0, 2.0]);
    scenario = scenario.sampled(crate::common::run(1.0, 3));
    let json = summary(&scenario);
    assert_eq!(json["motion"]["regime"], "permanent");
    assert_eq!(json["motion"]["rotation_period_s"], std::f64::consts::PI);
    assert!(json["motion"]["period_s"].is_null() && json["motion"]["precession_period_s"].is_null());
}

#[test]
fn an_explanation_as_json_keeps_its_numbers() {
    let json = explain(&crate::common::cube()).unwrap().to_json();
    assert_eq!(keys(&json), ["polhode", "title", "answer", "sections", "findings"]);
    let numbers: Vec<_> =
        json["sections"].as_array().unwrap().iter().map(|s| s["number"].as_u64().unwrap()).collect();
    assert_eq!(numbers, [0, 1, 2, 3, 4, 5, 6]);
    let matrix =
        json["sections"][3]["blocks"].as_array().unwrap().iter().find(|b| b["kind"] == "matrix").unwrap();
    let (mass, width) = (2.0, 3.0);
    let want = [2.0 / 3.0, -0.25, -0.25, -0.25, 2.0 / 3.0, -0.25, -0.25, -0.25, 2.0 / 3.0];
    for (got, want) in floats(&matrix["rows"]).iter().zip(want) {
        assert!((got - mass * width * width * want).abs() < 1e-14);
    }
}
