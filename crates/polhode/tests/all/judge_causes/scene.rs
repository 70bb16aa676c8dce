//! The body, its scenarios, the equations of the program, and the checks of causes.

use polhode::infer::judge::ReadMotion;
use polhode::infer::judge::{Cause, Causes, causes};
use polhode::prelude::*;

use super::program::*;

pub(super) const MASS: f64 = 2.3;
pub(super) const CENTER: V = [0.31, -0.17, 0.23];
pub(super) const MOMENTS: V = [1.3, 2.1, 2.9];
pub(super) const PRODUCTS: V = [0.25, -0.35, 0.15];

pub(super) fn tensor(moments: V, products: V) -> M {
    let ([a, b, c], [d, e, f]) = (moments, products);
    [[a, d, e], [d, b, f], [e, f, c]]
}

pub(super) fn body() -> MassProperties<Body> {
    let inertia = InertiaTensor::with_negative_products(MOMENTS, PRODUCTS).unwrap();
    MassProperties::new(MASS, Position::from_array(CENTER), inertia).unwrap()
}

pub(super) fn start() -> (Q, V) {
    (unit([0.4, -0.7, 1.1, 0.3]), [0.7, -1.1, 1.6])
}

pub(super) fn free() -> Scenario {
    let (q, w) = start();
    let attitude = Attitude::from_quaternion(q).unwrap();
    Scenario::new(body())
        .starting(State { time: 0.0, attitude, omega: AngularVelocity::from_array(w) })
        .unwrap()
}

pub(super) const BODY_TORQUE: V = [0.6, -0.45, 0.35];
pub(super) const SPACE_TORQUE: V = [-0.5, 0.4, 0.7];

/// Returns a scenario under one torque along body axes and one along space axes.
pub(super) fn driven() -> Scenario {
    let body = TorqueModel::Constant(ConstantTorque::Body(Torque::from_array(BODY_TORQUE)));
    let space = TorqueModel::Constant(ConstantTorque::Space(Torque::from_array(SPACE_TORQUE)));
    free().with_torques([body, space]).unwrap()
}

/// Returns the causes found in a log, with or without ω.
pub(super) fn found(scenario: &Scenario, log: &[(f64, Q, V)], with_omega: bool, step: Option<f64>) -> Causes {
    let times: Vec<f64> = log.iter().map(|row| row.0).collect();
    let exact =
        Simulation::new(scenario.rotor(), scenario.torques(), scenario.start(), &times).states().unwrap();
    let omega = log.iter().map(|row| AngularVelocity::from_array(row.2)).collect();
    let motion = ReadMotion {
        times,
        attitude: log.iter().map(|row| row.1).collect(),
        omega: with_omega.then_some(omega),
    };
    causes(scenario, &motion, &exact, step)
}

/// Checks the first cause found, with and without ω, and with and without the step size.
pub(super) fn require_named(
    scenario: &Scenario,
    log: &[(f64, Q, V)],
    step: f64,
    is_it: impl Fn(&Cause) -> bool,
) {
    for (with_omega, step) in [(true, Some(step)), (true, None), (false, Some(step)), (false, None)] {
        let found = found(scenario, log, with_omega, step);
        let first = found.likeliest().map(|tried| tried.cause.clone());
        let all: String = found
            .tried
            .iter()
            .take(6)
            .map(|t| format!("\n {:.2e} {:.2e} {}", t.residual, t.error, t.cause))
            .collect();
        assert!(first.as_ref().is_some_and(&is_it), "ω {with_omega}, step {step:?}: {first:?}{all}");
    }
}

pub(super) fn require_not_accused(scenario: &Scenario, log: &[(f64, Q, V)], step: f64) {
    for (with_omega, step) in [(true, Some(step)), (true, None), (false, Some(step)), (false, None)] {
        let found = found(scenario, log, with_omega, step);
        let accused: Vec<String> = found
            .named()
            .filter(|tried| tried.cause.is_mistake())
            .map(|t| format!("{} {:.2e} of {:.2e}", t.cause, t.residual, t.error))
            .collect();
        assert!(accused.is_empty(), "ω {with_omega}, step {step:?}: {accused:?}");
    }
}

/// Equations of the program: tensor, torque in body axes, and the mistakes.
#[derive(Clone, Copy)]
pub(super) struct Equations {
    pub(super) tensor: M,
    pub(super) gyroscopic: f64,
    pub(super) torque: fn(Q) -> V,
    pub(super) damping: f64,
}

pub(super) fn no_torque(_: Q) -> V {
    [0.0; 3]
}

pub(super) fn right_torque(q: Q) -> V {
    add(BODY_TORQUE, to_body(q, SPACE_TORQUE), 1.0)
}

pub(super) const RIGHT: Equations =
    Equations { tensor: [[0.0; 3]; 3], gyroscopic: 1.0, torque: no_torque, damping: 0.0 };

impl Equations {
    pub(super) fn acceleration(&self, q: Q, w: V) -> V {
        let gyroscopic = cross(times(&self.tensor, w), w).map(|c| c * self.gyroscopic);
        let force = add(gyroscopic, (self.torque)(unit(q)), 1.0);
        add(times(&inverse(&self.tensor), force), w, -self.damping)
    }

    /// Returns 400 rows at 0.05 s, with steps of negligible error.
    pub(super) fn log(&self) -> Vec<(f64, Q, V)> {
        let h = 0.005;
        run(start(), h, 10, 400, |t, q, w| {
            rk4(t, q, w, h, &|_, q, w| (turning(q, w), self.acceleration(q, w)))
        })
    }
}

pub(super) fn right() -> Equations {
    Equations { tensor: tensor(MOMENTS, PRODUCTS), ..RIGHT }
}

pub(super) fn right_driven() -> Equations {
    Equations { torque: right_torque, ..right() }
}
