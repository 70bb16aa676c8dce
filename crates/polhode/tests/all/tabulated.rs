//! Torques from tables, by both integrators, compared with windows, and with a formula that is the
//! same polynomial.

use polhode::motion::torque::{Interpolation, Schedule, Scheduled, Tabulated, TimePolynomial, TorqueAxes};
use polhode::motion::{Ensemble, Member};
use polhode::prelude::*;
use std::num::NonZero;

const METHODS: [Method; 2] = [Method::Taylor, Method::Dop853];

fn rotor() -> Rotor {
    let inertia = InertiaTensor::with_negative_products([3.1, 4.2, 5.3], [0.4, -0.3, 0.2]).unwrap();
    Rotor::free(&MassProperties::new(2.3, Position::new(0.11, -0.07, 0.23), inertia).unwrap())
}

fn start() -> State {
    let attitude = Attitude::from_quaternion([0.4, -0.7, 1.1, 0.3]).unwrap();
    State { time: 0.0, attitude, omega: AngularVelocity::new(0.9, -1.3, 0.6) }
}

fn table(axes: TorqueAxes, kind: Interpolation, times: &[f64], rows: &[[f64; 3]]) -> TorqueModel {
    TorqueModel::Tabulated(Box::new(Tabulated::new(axes, kind, times, rows).unwrap()))
}

fn times() -> Vec<f64> {
    (0..=60).map(|k| 0.1 * f64::from(k)).collect()
}

#[track_caller]
fn agree(torques: &[TorqueModel], others: &[TorqueModel], tolerance: f64) {
    let rotor = rotor();
    for method in METHODS {
        let [one, other] = [torques, others]
            .map(|all| Trajectory::compute(&rotor, all, start(), &times(), method, 1e-14).unwrap());
        for (a, b) in one.samples().iter().zip(other.samples()) {
            let angle = a.state.attitude.angle_to(b.state.attitude);
            let omega = (a.state.omega - b.state.omega).norm();
            assert!(
                angle <= tolerance && omega <= tolerance,
                "{method:?} {}: {angle:e} {omega:e}",
                a.state.time
            );
        }
        let drift = Drift::of(&one).unwrap();
        assert!(drift.work_energy <= tolerance && drift.momentum <= tolerance, "{drift:?}");
    }
}

const TIMES: [f64; 5] = [0.0, 0.7, 2.2, 3.1, 5.3];
const ROWS: [[f64; 3]; 5] =
    [[0.3, -0.2, 0.5], [-0.4, 0.1, 0.2], [0.6, 0.7, -0.3], [0.0, -0.5, 0.4], [1.0, 1.0, 1.0]];

#[test]
fn steps_are_constant_torques_in_windows() {
    for axes in [TorqueAxes::Body, TorqueAxes::Space] {
        let windows: Vec<_> = (0..4)
            .map(|k| {
                let torque = TorqueModel::Constant(match axes {
                    TorqueAxes::Body => ConstantTorque::Body(Torque::from_array(ROWS[k])),
                    TorqueAxes::Space => ConstantTorque::Space(Torque::from_array(ROWS[k])),
                });
                let schedule = Schedule::window(TIMES[k], TIMES[k + 1]).unwrap();
                TorqueModel::Scheduled(Box::new(Scheduled { torque, schedule }))
            })
            .collect();
        agree(&[table(axes, Interpolation::Steps, &TIMES, &ROWS)], &windows, 1e-13);
    }
}

#[test]
fn a_spline_of_a_cubic_is_that_cubic_while_it_acts() {
    let coefficients = vec![[0.3, -0.2, 0.5], [0.1, 0.4, -0.3], [-0.2, 0.05, 0.07], [0.03, -0.04, 0.02]];
    let cubic = TimePolynomial { axes: TorqueAxes::Space, epoch: 1.5, coefficients };
    let nodes = [-1.0, 0.4, 1.1, 3.2, 4.0, 5.5];
    let rows = nodes.map(|time| cubic.components(time));
    let spline = table(TorqueAxes::Space, Interpolation::Spline, &nodes, &rows);
    let torque = TorqueModel::Polynomial(cubic);
    let schedule = Schedule::window(-1.0, 5.5).unwrap();
    agree(&[spline], &[TorqueModel::Scheduled(Box::new(Scheduled { torque, schedule }))], 1e-12);
}

#[test]
fn a_linear_table_has_its_impulse() {
    has_its_impulse(start(), &TIMES, &ROWS);
}

/// The scale of ω at rest follows from the later torques of the table: the present torque is zero,
/// and so is ω.
#[test]
fn a_linear_table_that_rises_from_zero_moves_a_body_at_rest() {
    let rest = State { omega: AngularVelocity::ZERO, ..start() };
    let (times, rows) = ([0.0, 1.3, 2.2, 3.1, 5.3], [[0.0; 3], [0.0; 3], ROWS[0], ROWS[2], ROWS[1]]);
    has_its_impulse(rest, &times, &rows);
    has_its_impulse(rest, &times[1..], &rows[1..]);
    let torque = table(TorqueAxes::Space, Interpolation::Linear, &times, &rows);
    let member = || Member::new(rotor(), vec![torque.clone()], rest);
    let ensemble = Ensemble::new((0..9).map(|_| member()).collect()).unwrap();
    let ends = ensemble.at(&[6.0], Method::Taylor, 1e-14, NonZero::<usize>::MIN).unwrap();
    assert!(ends.failures.is_empty(), "{:?}", ends.failures);
    assert!(ends.states.iter().all(|end| (impulse_error(rest, end, &times, &rows)) < 1e-13));
}

#[track_caller]
fn has_its_impulse(start: State, times: &[f64], rows: &[[f64; 3]]) {
    let torque = table(TorqueAxes::Space, Interpolation::Linear, times, rows);
    for method in METHODS {
        let torques = std::slice::from_ref(&torque);
        let motion = Trajectory::compute(&rotor(), torques, start, &[0.0, 6.0], method, 1e-14).unwrap();
        let error = impulse_error(start, &motion.samples()[1].state, times, rows);
        assert!(error < 1e-13, "{method:?}: {error:e}");
    }
}

/// Returns the difference between the change of L and ∫ N dt, by the trapezoidal rule along space
/// axes.
fn impulse_error(start: State, end: &State, times: &[f64], rows: &[[f64; 3]]) -> f64 {
    let mut impulse = [0.0; 3];
    for (t, n) in times.windows(2).zip(rows.windows(2)) {
        (0..3).for_each(|k| impulse[k] += 0.5 * (n[0][k] + n[1][k]) * (t[1] - t[0]));
    }
    let [first, last] = [&start, end].map(|state| rotor().angular_momentum_space(state));
    (last - first - AngularMomentum::from_array(impulse)).norm()
}

#[test]
fn a_table_within_a_window_and_in_ensembles_is_the_same() {
    let torque = table(TorqueAxes::Body, Interpolation::Linear, &TIMES, &ROWS);
    let schedule = Schedule::window(1.0, 4.0).unwrap();
    let windowed = TorqueModel::Scheduled(Box::new(Scheduled { torque, schedule }));
    let cut = [1.0, 2.2, 3.1, 4.0];
    let along = |t: f64| -> [f64; 3] {
        let k = TIMES.partition_point(|time| *time <= t).clamp(1, 4) - 1;
        let part = (t - TIMES[k]) / (TIMES[k + 1] - TIMES[k]);
        std::array::from_fn(|j| ROWS[k][j] + part * (ROWS[k + 1][j] - ROWS[k][j]))
    };
    let rows = cut.map(along);
    agree(
        std::slice::from_ref(&windowed),
        &[table(TorqueAxes::Body, Interpolation::Linear, &cut, &rows)],
        1e-13,
    );
    let rotor = rotor();
    let torques = [windowed];
    let one = Trajectory::compute(&rotor, &torques, start(), &times(), Method::Taylor, 1e-13).unwrap();
    let member = || Member::new(rotor.clone(), torques.to_vec(), start());
    let ensemble = Ensemble::new((0..9).map(|_| member()).collect()).unwrap();
    let ends = ensemble.at(&[6.0], Method::Taylor, 1e-13, NonZero::<usize>::MIN).unwrap();
    let last = one.samples().last().unwrap().state;
    assert!(ends.failures.is_empty());
    assert!(ends.states.iter().all(|end| end.attitude.angle_to(last.attitude) < 1e-12));
}
