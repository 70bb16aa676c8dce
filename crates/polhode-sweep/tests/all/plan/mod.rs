//! Plans: reading, values of members, and refused input.

mod correlated;
mod mistakes;
mod statistics;

use polhode_source::files::Disk;
use polhode_sweep::{Plan, Sampling};

const SCENARIO: &str = r#"
title = "a tumbling box"

[[body.part]]
name = "bus"
shape = "tensor"
mass = "3.2 kg"
center_of_mass = ["0.1 m", "-40 mm", "0.07 m"]
inertia = [[1.1, 0.13, -0.21], [0.13, 1.7, 0.08], [-0.21, 0.08, 2.3]]

[start]
attitude = { axis = [1, -2, 3], angle = "50 deg" }
spin = { body = ["0.3 rad/s", "-1.2 rad/s", "40 deg/s"] }

[run]
duration = "20 s"
samples = 11
"#;

fn plan(sweep: &str) -> Plan {
    Plan::parse(&Disk, format!("{SCENARIO}{sweep}"), "plan.toml".as_ref())
        .unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn a_monte_carlo_plan_varies_what_it_says() {
    let plan = plan(
        r#"
[sweep]
members = 1000
sampling = "monte carlo"
seed = 7
[[sweep.vary]]
key = "start.spin.body[0]"
normal = { mean = "0.3 rad/s", sd = "0.05 rad/s" }
[[sweep.vary]]
key = "start.spin.body[2]"
uniform = { from = "30 deg/s", to = "1 rad/s" }
[[sweep.vary]]
key = "run.duration"
uniform = { from = "10 s", to = "1 min" }
[[sweep.vary]]
key = 'body.part["bus"].center_of_mass[1]'
relative = "10 %"
"#,
    );
    assert_eq!((plan.members(), plan.sampling()), (1000, Sampling::MonteCarlo));
    let names: Vec<_> = plan.variables().iter().map(|variable| variable.name.as_str()).collect();
    let expected = [
        "start_spin_body_x_rad_s",
        "start_spin_body_z_rad_s",
        "run_duration_s",
        "body_part_bus_center_of_mass_y_m",
    ];
    assert_eq!(names, expected);
    for member in [0, 1, 17, 999] {
        let values = plan.values(member);
        let scenario = plan.scenario(&values).unwrap();
        assert_eq!(scenario.start().omega.to_array(), [values[0], -1.2, values[1]]);
        assert_eq!(scenario.run().unwrap().times.last(), Some(&values[2]));
        assert_eq!(scenario.body().center_of_mass().to_array(), [0.1, values[3], 0.07]);
    }
    assert_ne!(plan.values(3), plan.values(4));
    assert_eq!(plan.digest().len(), 64);
}

/// Returns a plan with this sampling and these variables.
fn vary(members: u64, sampling: &str, seed: u64, vary: &str) -> Plan {
    let members =
        if sampling == "grid" { String::new() } else { format!("members = {members}\nseed = {seed}") };
    plan(&format!("[sweep]\n{members}\nsampling = \"{sampling}\"\n{vary}"))
}

const SPIN: &str = "[[sweep.vary]]\nkey = \"start.spin.body[0]\"\nuniform = { from = 0, to = 1 }\n";
const DURATION: &str = "[[sweep.vary]]\nkey = \"run.duration\"\nuniform = { from = 1, to = 2 }\n";

#[test]
fn a_variable_has_draws_of_its_own_and_a_seed_has_others() {
    for sampling in ["monte carlo", "latin hypercube"] {
        let one = vary(1000, sampling, 3, SPIN);
        let two = vary(1000, sampling, 3, &format!("{DURATION}{SPIN}"));
        let other = vary(1000, sampling, 4, SPIN);
        for member in 0..1000 {
            assert_eq!(one.values(member)[0], two.values(member)[1]);
            assert_ne!(one.values(member), other.values(member));
        }
    }
    // A random number depends on the member's number, not on the number of members.
    let (few, many) = (vary(10, "monte carlo", 3, SPIN), vary(1_000_000_000, "monte carlo", 3, SPIN));
    assert!((0..10).all(|member| few.values(member) == many.values(member)));
}

/// Draws never change. Those of the first sampling agree with a short Python implementation of
/// SHA-256 and Philox4×32-10.
#[test]
fn draws_are_the_same_for_ever() {
    let drawn = ["monte carlo", "latin hypercube", "sobol"]
        .map(|sampling| vary(1000, sampling, 42, &format!("{SPIN}{DURATION}")).values(123));
    assert_eq!(
        drawn,
        [
            [0.3202246426201577, 1.3873050493560966],
            [0.5163202246426208, 1.6113873050493548],
            [0.4515224856604413, 1.7967247735679392]
        ]
    );
}

#[test]
fn a_grid_is_every_combination_and_the_last_variable_changes_first() {
    let plan = vary(
        0,
        "grid",
        0,
        r#"
[[sweep.vary]]
key = "body.part[0].mass"
list = ["2 kg", "5.5 kg"]
[[sweep.vary]]
key = "start.spin.body[1]"
grid = { from = "-1 rad/s", to = "2 rad/s", count = 4 }
[[sweep.vary]]
key = "run.duration"
grid = { from = 1, to = 100, count = 3, spacing = "log" }
"#,
    );
    assert_eq!((plan.members(), plan.sampling()), (24, Sampling::Grid));
    let mut members = (0..24).map(|member| plan.values(member));
    for mass in [2.0, 5.5] {
        for spin in [-1.0, 0.0, 1.0, 2.0] {
            for duration in [1.0, 10.0, 100.0] {
                assert_eq!(members.next().unwrap(), [mass, spin, duration]);
            }
        }
    }
    assert_eq!(plan.scenario(&plan.values(23)).unwrap().body().mass(), 5.5);
}

#[test]
fn vectors_rotations_and_mass_properties_are_what_their_columns_say() {
    let plan = vary(
        1000,
        "sobol",
        5,
        r#"
[[sweep.vary]]
key = "start.attitude"
random = "uniform"
[[sweep.vary]]
key = "start.spin.body"
direction = "uniform"
magnitude = { log_normal = { median = "2 rad/s", sigma = 0.5 } }
[[sweep.vary]]
key = "body"
dispersion = { mass = "2 %", center_of_mass = "5 mm", inertia = "10 %" }
"#,
    );
    let names: Vec<_> = plan.variables().iter().map(|variable| variable.name.as_str()).collect();
    let expected = "start_attitude_w start_attitude_x start_attitude_y start_attitude_z start_spin_body_x_rad_s \
                    start_spin_body_y_rad_s start_spin_body_z_rad_s body_mass_kg body_center_of_mass_x_m \
                    body_center_of_mass_y_m body_center_of_mass_z_m body_inertia_xx_kg_m2 body_inertia_yy_kg_m2 \
                    body_inertia_zz_kg_m2 body_inertia_xy_kg_m2 body_inertia_xz_kg_m2 body_inertia_yz_kg_m2";
    assert_eq!(names, expected.split_whitespace().collect::<Vec<_>>());
    assert_eq!(plan.variables()[11].unit, "kg·m²");
    for member in 0..1000 {
        let values = plan.values(member);
        let scenario = plan.scenario(&values).unwrap();
        let quaternion = scenario.start().attitude.quaternion();
        assert!(values[0] >= 0.0 && quaternion.iter().zip(&values).all(|(a, b)| (a - b).abs() < 1e-15));
        assert_eq!(scenario.start().omega.to_array(), values[4..7]);
        let body = scenario.body();
        assert_eq!(
            (body.mass(), body.center_of_mass().to_array()),
            (values[7], [values[8], values[9], values[10]])
        );
        let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = body.inertia().matrix();
        assert_eq!([xx, yy, zz, xy, xz, yz], values[11..]);
    }
}

#[test]
fn a_part_is_dispersed_beside_others_and_its_tensor_alone_leaves_the_rest() {
    let scenario = format!("{SCENARIO}[[body.part]]\nshape = 'box'\nsize = [1, 2, 3]\nmass = '7 kg'\n");
    let sweep = r#"
[sweep]
members = 100
sampling = "latin hypercube"
[[sweep.vary]]
key = 'body.part["bus"].inertia'
dispersion = "20 %"
[[sweep.vary]]
key = "body.part[1].mass"
relative = 0.1
"#;
    let plan = Plan::parse(&Disk, format!("{scenario}{sweep}"), "plan.toml".as_ref()).unwrap();
    assert_eq!(plan.variables()[0].name, "body_part_bus_inertia_xx_kg_m2");
    assert_eq!(plan.variables()[6].name, "body_part_1_mass_kg");
    for member in 0..100 {
        let values = plan.values(member);
        let scenario = plan.scenario(&values).unwrap();
        let [bus, plate] = scenario.parts() else { panic!("two parts") };
        assert_eq!((bus.properties.mass(), bus.properties.inertia().matrix()[1][2]), (3.2, values[5]));
        assert_eq!(plate.properties.mass(), values[6]);
        assert!((scenario.body().mass() - (3.2 + values[6])).abs() < 1e-14);
    }
}

#[test]
fn the_first_members_spin_depends_on_their_own_attitude_and_body() {
    // L is given in space: ω follows from the member's own attitude and tensor.
    let scenario =
        SCENARIO.replace(r#"body = ["0.3 rad/s", "-1.2 rad/s", "40 deg/s"]"#, "momentum = [0.7, -0.4, 2.1]");
    let sweep = r#"
[sweep]
members = 50
sampling = "monte carlo"
[[sweep.vary]]
key = "start.attitude"
random = { sd = "30 deg" }
[[sweep.vary]]
key = "body.inertia"
dispersion = "30 %"
"#;
    let plan = Plan::parse(&Disk, format!("{scenario}{sweep}"), "plan.toml".as_ref()).unwrap();
    for member in 0..50 {
        let scenario = plan.scenario(&plan.values(member)).unwrap();
        let l = scenario.start().attitude * (*scenario.body().inertia() * scenario.start().omega);
        for (l, expected) in l.to_array().into_iter().zip([0.7, -0.4, 2.1]) {
            assert!((l - expected).abs() < 1e-14, "{l}");
        }
    }
}

#[test]
fn it_does_not_matter_how_tables_are_written() {
    let sweep = r#"
[sweep]
members = 20
sampling = "sobol"
[[sweep.vary]]
key = "start.attitude"
random = "uniform"
[[sweep.vary]]
key = "start.spin.body[0]"
uniform = { from = 0, to = 1 }
[[sweep.vary]]
key = "body.part[0].inertia[0][2]"
uniform = { from = -0.3, to = 0.3 }
"#;
    let dotted = SCENARIO
        .replace(
            "attitude = { axis = [1, -2, 3], angle = \"50 deg\" }",
            "attitude.axis = [1, -2, 3]\nattitude.angle = \"50 deg\"",
        )
        .replace("spin = { body = [", "spin.body = [")
        .replace("\"40 deg/s\"] }", "\"40 deg/s\"]");
    let headed = SCENARIO.replace("attitude = { axis = [1, -2, 3], angle = \"50 deg\" }\n", "")
        + "[start.attitude]\nquaternion = [1, 0, 0, 0]\n";
    let scenarios = [SCENARIO, &dotted, &headed].map(|scenario| {
        let plan = Plan::parse(&Disk, format!("{scenario}{sweep}"), "plan.toml".as_ref())
            .unwrap_or_else(|e| panic!("{e}"));
        let scenario = |member| plan.scenario(&plan.values(member)).unwrap();
        (0..20).map(scenario).collect::<Vec<_>>()
    });
    assert!(scenarios[0] == scenarios[1] && scenarios[0] == scenarios[2]);
    let products = scenarios[0].iter().map(|scenario| scenario.body().inertia().matrix());
    assert!(products.into_iter().all(|matrix| matrix[0][2] == matrix[2][0] && matrix[0][2] != -0.21));
}

#[test]
fn the_digest_names_everything_that_results_depend_on() {
    let folder = std::env::temp_dir().join(format!("polhode-plan-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let (mesh, path) = (folder.join("tetrahedron.off"), folder.join("plan.toml"));
    let off = "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";
    std::fs::write(&mesh, off).unwrap();
    let text = "[[body.part]]\nshape = 'mesh'\nfile = 'tetrahedron.off'\ndensity = 3\n[sweep]\nmembers = 3\n\
                sampling = 'sobol'\n[[sweep.vary]]\nkey = 'body.part[0].density'\nuniform = { from = 2, to = 4 }\n";
    std::fs::write(&path, text).unwrap();
    let plan = Plan::read(&Disk, &path).unwrap();
    assert_eq!(plan.digest(), Plan::read(&Disk, &path).unwrap().digest());
    // Members do not read files again.
    std::fs::write(&mesh, "OFF\n").unwrap();
    let heavy = plan.scenario(&[6.0]).unwrap();
    assert!((heavy.body().mass() - 1.0).abs() < 1e-15);
    std::fs::write(&mesh, off.replace("0 0 1", "0 0 2")).unwrap();
    let other_file = Plan::read(&Disk, &path).unwrap().digest();
    std::fs::write(&path, text.replace("to = 4", "to = 5")).unwrap();
    let other_text = Plan::read(&Disk, &path).unwrap().digest();
    assert!(plan.digest() != other_file && other_file != other_text);
    std::fs::remove_dir_all(&folder).unwrap();
}

#[test]
fn columns_from_outside_are_checked() {
    let plan = vary(
        10,
        "monte carlo",
        0,
        &format!("{SPIN}[[sweep.vary]]\nkey = 'body.inertia'\ndispersion = 0.1\n"),
    );
    let good = plan.values(3);
    assert!(plan.scenario(&good).is_ok());
    let mut impossible = good.clone();
    impossible[3] = 9.0;
    let message = |values: &[f64]| plan.scenario(values).unwrap_err().to_string();
    assert!(message(&impossible).contains("triangle inequality") || message(&impossible).contains("i1 + i2"));
    let mut nan = good.clone();
    nan[2] = f64::NAN;
    assert_eq!(message(&nan), "plan.toml:26:7: body_inertia_yy_kg_m2 = NaN must be finite");
    assert!(message(&good[..3]).ends_with("must be 6 numbers"));
    assert!(message(&[&good[..], &[1.0]].concat()).ends_with("must be 6 numbers"));
    assert!(message(&[]).ends_with("must be 1 numbers"));
}
