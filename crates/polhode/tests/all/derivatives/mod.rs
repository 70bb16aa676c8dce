//! Derivatives of motions, compared with differences of whole runs, with the differential
//! equations, and with general properties.

mod events;
mod laws;
mod models;

use polhode::motion::torque::TorqueParameter;
use polhode::motion::{StateDerivatives, TrajectoryDerivatives};
use polhode::prelude::*;

/// Tensor elements xx, yy, zz, xy, xz, yz about the centre of mass; the tensor about the point of
/// rotation is larger.
const ELEMENTS: [f64; 6] = [3.1, 4.2, 5.3, 0.4, -0.3, 0.2];

/// Problem to run: a body by its tensor about the centre of mass, its torques, and the start.
#[derive(Clone)]
struct Problem {
    elements: [f64; 6],
    pivot: Option<Position<Body>>,
    wheels: Vec<Wheel>,
    torques: Vec<TorqueModel>,
    switched_off: Vec<usize>,
    events: Vec<Event>,
    start: State,
}

impl Problem {
    fn free(torques: Vec<TorqueModel>) -> Self {
        let attitude = Attitude::from_quaternion([0.4, -0.7, 1.1, 0.3]).unwrap();
        let start = State { time: 0.3, attitude, omega: AngularVelocity::new(0.7, -1.1, 0.4) };
        let (wheels, switched_off, events) = (Vec::new(), Vec::new(), Vec::new());
        Self { elements: ELEMENTS, pivot: None, wheels, torques, switched_off, events, start }
    }

    fn pivoted(torques: Vec<TorqueModel>) -> Self {
        Self { pivot: Some(Position::new(-0.4, 0.9, 0.2)), ..Self::free(torques) }
    }

    fn rotor(&self) -> Rotor {
        let [xx, yy, zz, xy, xz, yz] = self.elements;
        let inertia = InertiaTensor::from_matrix([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]).unwrap();
        let body = MassProperties::new(2.3, Position::new(0.11, -0.07, 0.23), inertia).unwrap();
        let rotor = self.pivot.map_or_else(|| Rotor::free(&body), |pivot| Rotor::pivoted(&body, pivot));
        rotor.with_wheels(&self.wheels).unwrap()
    }

    fn states(&self, times: &[f64]) -> Vec<State> {
        let rotor = self.rotor();
        let simulation = self.simulation(&rotor, times).method(Method::Taylor).tolerance(1e-15);
        simulation.run().unwrap().samples().iter().map(|sample| sample.state).collect()
    }

    fn simulation<'a>(&'a self, rotor: &'a Rotor, times: &'a [f64]) -> Simulation<'a> {
        Simulation::new(rotor, &self.torques, self.start, times)
            .events(&self.events)
            .switched_off(&self.switched_off)
    }

    fn derivatives(&self, parameters: &[TorqueParameter], times: &[f64]) -> TrajectoryDerivatives {
        self.simulation(&self.rotor(), times).run_with_derivatives(parameters).unwrap()
    }

    /// Changes one of the twelve numbers of the start and the tensor: θ, ω, elements.
    fn changed(&self, column: usize, by: f64) -> Self {
        let mut other = self.clone();
        let axis = core::array::from_fn(|k| if k == column % 3 { by } else { 0.0 });
        match column {
            0..3 => other.start.attitude = turned(self.start.attitude, axis),
            3..6 => other.start.omega += AngularVelocity::from_array(axis),
            _ => other.elements[column - 6] += by,
        }
        other
    }
}

/// Returns R exp(θ).
fn turned(attitude: Attitude, theta: [f64; 3]) -> Attitude {
    let angle = theta.iter().map(|x| x * x).sum::<f64>().sqrt();
    let half = if angle == 0.0 { 0.5 } else { (0.5 * angle).sin() / angle };
    let [x, y, z] = theta.map(|x| half * x);
    attitude * Rotation::<Body, Body>::from_quaternion([(0.5 * angle).cos(), x, y, z]).unwrap()
}

fn cross([a, b, c]: [f64; 3], [x, y, z]: [f64; 3]) -> [f64; 3] {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}

/// Returns the difference of two states: θ and ω.
fn between(from: &State, to: &State) -> [f64; 6] {
    let [w, x, y, z] = (from.attitude.inverse() * to.attitude).canonical_quaternion();
    let sine = (x * x + y * y + z * z).sqrt();
    let scale = if sine == 0.0 { 2.0 } else { 2.0 * sine.atan2(w) / sine };
    let [a, b, c] = (to.omega - from.omega).to_array();
    [scale * x, scale * y, scale * z, a, b, c]
}

/// Computes f′(0) by central differences over h, h/2, h/4 …, extrapolated; the best value of the
/// table (Ridders).
fn derivative(f: impl Fn(f64) -> Vec<f64>, h: f64) -> Vec<f64> {
    let mut best: Option<(Vec<f64>, f64)> = None;
    let mut previous: Vec<Vec<f64>> = Vec::new();
    for level in 0..6 {
        let h = h / f64::from(1 << level);
        let (after, before) = (f(h), f(-h));
        let mut row = vec![after.iter().zip(&before).map(|(a, b)| (a - b) / (2.0 * h)).collect::<Vec<_>>()];
        let mut power = 1.0;
        for (j, coarse) in previous.iter().enumerate() {
            power *= 4.0;
            let next: Vec<f64> = row[j]
                .iter()
                .zip(coarse)
                .map(|(fine, coarse)| fine + (fine - coarse) / (power - 1.0))
                .collect();
            let error = |a: &[f64]| a.iter().zip(&next).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            let error = error(&row[j]).max(error(coarse));
            if best.as_ref().is_none_or(|(_, least)| error < *least) {
                best = Some((next.clone(), error));
            }
            row.push(next);
        }
        previous = row;
    }
    best.unwrap().0
}

/// Returns the columns of a state's derivatives with respect to the start and the inertia.
fn columns(derivatives: &StateDerivatives) -> Vec<[f64; 6]> {
    let of = |matrix: &[[f64; 6]; 6], k: usize| matrix.map(|row| row[k]);
    let start = (0..6).map(|k| of(&derivatives.by_start, k));
    start.chain((0..6).map(|k| of(&derivatives.by_inertia, k))).collect()
}

/// Returns max |a − b|, relative to the largest of |b| and 1.
fn difference(a: &[f64], b: &[f64]) -> f64 {
    let scale = b.iter().fold(1.0, |most: f64, x| most.max(x.abs()));
    assert_eq!(a.len(), b.len());
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) / scale
}

/// Computes all columns with respect to the start and the inertia by differences of whole runs.
fn differenced(problem: &Problem, times: &[f64]) -> Vec<Vec<f64>> {
    let here = problem.states(times);
    let of = |other: &Problem| -> Vec<f64> {
        here.iter().zip(other.states(times)).flat_map(|(from, to)| between(from, &to)).collect()
    };
    (0..12).map(|column| derivative(|h| of(&problem.changed(column, h)), 0.02)).collect()
}

/// Checks that the derivatives of a problem agree with differences; returns the largest deviation.
fn check(name: &str, problem: &Problem, times: &[f64], tolerance: f64) {
    let motion = problem.derivatives(&[], times);
    assert_eq!(motion.states.len(), times.len(), "{name}: {:?}", motion.ending);
    for (column, want) in differenced(problem, times).iter().enumerate() {
        let got: Vec<f64> =
            motion.states.iter().flat_map(|derivatives| columns(derivatives)[column]).collect();
        let error = difference(&got, want);
        assert!(error < tolerance, "{name}, column {column}: {error:e}\n{got:?}\n{want:?}");
    }
}
