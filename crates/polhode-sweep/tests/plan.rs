//! Plans: what is read, what members are, and what is refused.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may")]

use polhode_sweep::{Plan, Sampling};

const SCENARIO: &str = r#"
title = "a tumbling box"

[[body.part]]
name = "bus"
shape = "tensor"
mass = "3.2 kg"
center_of_mass = [0.1, "-40 mm", 0.07]
inertia = [[1.1, 0.13, -0.21], [0.13, 1.7, 0.08], [-0.21, 0.08, 2.3]]

[start]
attitude = { axis = [1, -2, 3], angle = "50 deg" }
spin = { body = ["0.3 rad/s", -1.2, "40 deg/s"] }

[run]
duration = "20 s"
samples = 11
"#;

fn plan(sweep: &str) -> Plan {
    Plan::parse(format!("{SCENARIO}{sweep}"), "plan.toml".as_ref()).unwrap_or_else(|error| panic!("{error}"))
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
uniform = { from = "30 deg/s", to = 1 }
[[sweep.vary]]
key = "run.duration"
uniform = { from = 10, to = "1 min" }
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
        assert_eq!(scenario.start.omega.to_array(), [values[0], -1.2, values[1]]);
        assert_eq!(scenario.run.unwrap().times.last(), Some(&values[2]));
        assert_eq!(scenario.body.center_of_mass().to_array(), [0.1, values[3], 0.07]);
    }
    assert_ne!(plan.values(3), plan.values(4));
    assert_eq!(plan.digest().len(), 64);
}
