//! Outcomes of members, compared with the motions themselves.

use polhode::motion::{ErrorEffort, FreeMotion, Trajectory};
use polhode_source::files::Disk;
use polhode_sweep::{Batch, BatchError, Column, Plan, Values, inputs, simulate, trajectories};

const BODY: &str = r#"
title = "a tumbling box"
[[body.part]]
shape = "tensor"
mass = "3.2 kg"
center_of_mass = ["0.1 m", "-40 mm", "0.07 m"]
inertia = [[1.1, 0.13, -0.21], [0.13, 1.7, 0.08], [-0.21, 0.08, 2.3]]
[start]
attitude = { axis = [1, -2, 3], angle = "50 deg" }
spin = { body = ["0.3 rad/s", "-1.2 rad/s", "40 deg/s"] }
"#;

const FREE: &str = r#"
[run]
duration = "37 s"
samples = 11
[sweep]
members = 60
sampling = "monte carlo"
seed = 11
trajectories = true
[[sweep.vary]]
key = "start.spin.body[0]"
uniform = { from = -2, to = 2 }
[[sweep.vary]]
key = "start.spin.body[2]"
normal = { mean = "0.2 rad/s", sd = "1 rad/s" }
"#;

/// Sections with a torque, events and pointings.
const DRIVEN: &str = r#"
[run]
duration = "6 s"
samples = 25
[[torque]]
model = "constant"
axes = "body"
torque = ["0.4 N m", "-0.7 N m", "1.1 N m"]
[[event]]
name = "Fast enough!"
measure = "omega_body_z"
value = "2 rad/s"
direction = "rising"
then = "stop"
[[event]]
name = "one second"
measure = "time"
value = "1 s"
[sweep]
members = 20
sampling = "latin hypercube"
seed = 3
[[sweep.vary]]
key = "start.spin.body[2]"
uniform = { from = -6, to = 1 }
"#;

fn plan(rest: &str) -> Plan {
    Plan::parse(&Disk, format!("{BODY}{rest}"), "plan.toml".as_ref())
        .unwrap_or_else(|error| panic!("{error}"))
}

fn all(plan: &Plan) -> Batch {
    simulate(plan, &inputs(plan, 0..plan.members())).unwrap()
}

fn numbers(batch: &Batch, name: &str) -> Vec<Option<f64>> {
    match &batch.column(name).unwrap().values {
        Values::Perhaps(values) => values.clone(),
        Values::Numbers(values) => values.iter().copied().map(Some).collect(),
        other => panic!("{name}: {other:?}"),
    }
}

fn texts(batch: &Batch, name: &str) -> Vec<Option<String>> {
    match &batch.column(name).unwrap().values {
        Values::Text(values) => values.clone(),
        other => panic!("{name}: {other:?}"),
    }
}

fn close(a: f64, b: f64, relative: f64) -> bool {
    (a - b).abs() <= relative * a.abs().max(b.abs())
}

#[test]
fn a_free_member_is_its_motion() {
    let plan = plan(FREE);
    let rows = all(&plan);
    let number = |name: &str, k: usize| numbers(&rows, name)[k].unwrap();
    let mut regimes = std::collections::BTreeSet::new();
    for k in 0..60 {
        let scenario = plan.scenario(&plan.values(k as u64)).unwrap();
        let rotor = scenario.rotor();
        let motion = FreeMotion::of(rotor, scenario.start()).unwrap();
        let trajectory = scenario.simulate().unwrap().unwrap();
        let last = trajectory.samples().last().unwrap();
        // The end of the motion, bit for bit.
        let [w, x, y, z] = last.state.attitude.canonical_quaternion();
        for (name, value) in [
            ("end_time_s", 37.0),
            ("end_attitude_w", w),
            ("end_attitude_x", x),
            ("end_attitude_y", y),
            ("end_attitude_z", z),
            ("end_omega_body_x_rad_s", last.state.omega.x),
            ("end_omega_body_y_rad_s", last.state.omega.y),
            ("end_omega_body_z_rad_s", last.state.omega.z),
            ("end_kinetic_energy_j", last.kinetic_energy),
            ("end_momentum_kg_m2_s", last.momentum.norm()),
            ("period_s", motion.period().unwrap()),
            ("flip_interval_s", 0.5 * motion.period().unwrap()),
            ("mass_kg", 3.2),
            ("moment_3_kg_m2", rotor.principal().moments()[2]),
        ] {
            assert_eq!(number(name, k), value, "{name} of {k}");
        }
        regimes.insert(texts(&rows, "regime")[k].clone().unwrap());
        assert_eq!(texts(&rows, "regime")[k].as_deref(), Some(motion.regime().name()));
        assert_eq!(texts(&rows, "end_regime")[k], texts(&rows, "regime")[k]);
        assert!(number("momentum_drift", k) < 2e-14 && number("energy_drift", k) < 2e-14);
        let [attitude, omega] = ["error_attitude_rad", "error_omega"].map(|name| number(name, k));
        assert!(attitude > 1e-16 && attitude < 1e-14 && omega > 1e-16 && omega < 1e-14);

        // Closed-form extrema, compared with 1000 samples per period.
        let times: Vec<f64> = (0..=1000).map(|j| motion.period().unwrap() * f64::from(j) / 1000.0).collect();
        let dense = Trajectory::of_motion(motion, &times).unwrap();
        let look = |of: &dyn Fn(&polhode::motion::Sample) -> f64| {
            let values = || dense.samples().iter().map(of);
            [values().fold(f64::INFINITY, f64::min), values().fold(0.0, f64::max)]
        };
        let angle = |axis: usize| {
            let axis = rotor.principal().axis(axis);
            move |s: &polhode::motion::Sample| {
                let momentum = s.state.attitude.inverse() * s.momentum;
                (axis.dot(momentum) / momentum.norm()).clamp(-1.0, 1.0).acos()
            }
        };
        for (names, [least, largest]) in [
            (["least_omega_rad_s", "largest_omega_rad_s"], look(&|s| s.state.omega.norm())),
            (["least_angle_to_axis_1_rad", "largest_angle_to_axis_1_rad"], look(&angle(0))),
            (["least_angle_to_axis_3_rad", "largest_angle_to_axis_3_rad"], look(&angle(2))),
        ] {
            // The error of sampled extrema is of second order in the step.
            let [a, b] = names.map(|name| number(name, k));
            assert!(a <= least + 1e-7 && close(a, least, 1e-4), "{} of {k}: {a} {least}", names[0]);
            assert!(b >= largest - 1e-7 && close(b, largest, 1e-4), "{} of {k}: {b} {largest}", names[1]);
        }
    }
    assert_eq!(regimes.len(), 2, "{regimes:?}");
    for none in ["steps_accepted", "largest_torque_n_m"] {
        assert!(numbers(&rows, none).iter().all(Option::is_none), "{none}");
    }
}

#[test]
fn a_driven_member_has_events_steps_and_an_end() {
    let plan = plan(DRIVEN);
    let rows = all(&plan);
    let (status, first) = (texts(&rows, "status"), numbers(&rows, "event_fast_enough_first_s"));
    let seconds = numbers(&rows, "event_one_second_first_s");
    let (count, end) = (numbers(&rows, "event_one_second_count"), numbers(&rows, "end_time_s"));
    for k in 0..20 {
        let scenario = plan.scenario(&plan.values(k as u64)).unwrap();
        let trajectory = scenario.simulate_with_error(ErrorEffort::Cheap, &mut |_| true).unwrap().unwrap();
        let error = trajectory.error().unwrap().end();
        assert_eq!(numbers(&rows, "error_attitude_rad")[k], Some(error.attitude));
        assert_eq!(numbers(&rows, "error_omega")[k], Some(error.omega));
        assert!(error.attitude > 1e-16 && error.attitude < 1e-11 && error.omega < 1e-11, "{error:?}");
        let stop = trajectory.events().iter().find(|crossing| crossing.event == 0);
        assert_eq!(first[k], stop.map(|crossing| crossing.state.time));
        match stop {
            Some(crossing) => {
                assert_eq!(status[k].as_deref(), Some("stopped: Fast enough!"));
                assert_eq!(end[k], Some(crossing.state.time));
                let z = numbers(&rows, "end_omega_body_z_rad_s")[k].unwrap();
                assert!((z - 2.0).abs() < 1e-11, "{z}");
            }
            None => {
                assert_eq!(status[k].as_deref(), Some("complete"));
                assert_eq!(end[k], Some(6.0));
            }
        }
        let reached = end[k].unwrap() >= 1.0;
        assert_eq!(count[k], Some(if reached { 1.0 } else { 0.0 }));
        assert!(seconds[k].is_none_or(|t| (t - 1.0).abs() < 1e-14) && seconds[k].is_some() == reached);
        assert!(numbers(&rows, "steps_accepted")[k].unwrap() >= 1.0);
        assert!(numbers(&rows, "energy_drift")[k].unwrap() < 1e-11);
        let torque = (0.4_f64 * 0.4 + 0.7 * 0.7 + 1.1 * 1.1).sqrt();
        assert!(close(numbers(&rows, "largest_torque_n_m")[k].unwrap(), torque, 1e-15));
        assert_eq!(numbers(&rows, "period_s")[k], None);
        assert!(texts(&rows, "regime")[k].is_some() && texts(&rows, "end_regime")[k].is_some());
    }
    assert!(status.contains(&Some("complete".to_owned())) && first.iter().any(Option::is_some));
}

#[test]
fn a_row_knows_no_other() {
    for rest in [FREE, DRIVEN] {
        let plan = plan(rest);
        let whole = all(&plan);
        // Some members in another order, one of them twice.
        let chosen = [17_usize, 3, 11, 3, 0];
        let given = inputs(&plan, 0..plan.members());
        let pick = |batch: &Batch| {
            let column = |column: &Column| Column {
                values: match &column.values {
                    Values::Whole(v) => Values::Whole(chosen.map(|k| v[k]).to_vec()),
                    Values::Numbers(v) => Values::Numbers(chosen.map(|k| v[k]).to_vec()),
                    Values::Perhaps(v) => Values::Perhaps(chosen.map(|k| v[k]).to_vec()),
                    Values::Text(v) => Values::Text(chosen.map(|k| v[k].clone()).to_vec()),
                },
                ..column.clone()
            };
            Batch::new(batch.columns().iter().map(column).collect()).unwrap()
        };
        assert_eq!(simulate(&plan, &pick(&given)).unwrap(), pick(&whole));
        // Reordered and additional columns change nothing.
        let mut columns = given.columns().to_vec();
        columns.reverse();
        columns.push(Column { name: "note".to_owned(), ..columns[0].clone() });
        assert_eq!(simulate(&plan, &Batch::new(columns).unwrap()).unwrap(), whole);
    }
}

#[test]
fn rows_that_are_no_inputs_are_refused() {
    let plan = plan(FREE);
    let given = inputs(&plan, 0..3);
    let without = |name: &str| {
        let columns = given.columns().iter().filter(|column| column.name != name).cloned().collect();
        simulate(&plan, &Batch::new(columns).unwrap())
    };
    for name in ["member", "start_spin_body_x_rad_s"] {
        assert_eq!(without(name), Err(BatchError::Missing { column: name.to_owned() }));
    }
    let mut columns = given.columns().to_vec();
    columns[1].values = Values::Perhaps(vec![None; 3]);
    let error = simulate(&plan, &Batch::new(columns).unwrap()).unwrap_err();
    assert!(
        matches!(error, BatchError::Kind { ref column, .. } if *column == given.columns()[1].name),
        "{error}"
    );
}

#[test]
fn what_is_no_motion_is_a_row_that_says_so() {
    let plan = plan(FREE);
    let given = inputs(&plan, 0..3);
    let good = simulate(&plan, &given).unwrap();
    let mut columns = given.columns().to_vec();
    let Values::Numbers(values) = &mut columns[1].values else { panic!() };
    values[1] = f64::NAN;
    let rows = simulate(&plan, &Batch::new(columns).unwrap()).unwrap();
    assert_eq!(texts(&rows, "status")[1].as_deref(), Some("failed"));
    let cause = texts(&rows, "cause")[1].clone().unwrap();
    assert!(!cause.is_empty() && !cause.contains("plan.toml"), "{cause}");
    assert_eq!(numbers(&rows, "end_time_s")[1], None);
    for k in [0, 2] {
        assert_eq!(numbers(&rows, "end_omega_body_x_rad_s")[k], numbers(&good, "end_omega_body_x_rad_s")[k]);
        assert_eq!(texts(&rows, "cause")[k], None);
    }
}

#[test]
fn trajectories_are_the_samples_of_the_motions() {
    for rest in [FREE, DRIVEN] {
        let plan = plan(rest);
        let table = trajectories(&plan, &inputs(&plan, 5..9)).unwrap();
        let Values::Whole(members) = &table.column("member").unwrap().values else { panic!() };
        let mut row = 0;
        for member in 5..9 {
            let trajectory = plan.scenario(&plan.values(member)).unwrap().simulate().unwrap().unwrap();
            for sample in trajectory.samples() {
                assert_eq!(members[row], member);
                assert_eq!(numbers(&table, "time_s")[row], Some(sample.state.time));
                assert_eq!(numbers(&table, "attitude_y")[row], Some(sample.state.attitude.quaternion()[2]));
                assert_eq!(numbers(&table, "omega_body_z_rad_s")[row], Some(sample.state.omega.z));
                row += 1;
            }
        }
        assert_eq!(table.rows(), row);
    }
}
