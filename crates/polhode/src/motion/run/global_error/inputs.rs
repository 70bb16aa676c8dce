//! Perturbed inputs of a motion.

use crate::math::rotation::Rotation;
use crate::math::symmetric3::Symmetric3;
use crate::math::vector::Vector;
use crate::motion::model::mass_history::MassHistory;
use crate::motion::model::rotor::Rotor;
use crate::motion::model::state::State;
use crate::motion::run::rotor_problem::RotorProblem;
use crate::motion::solve::propagate::noise::Random;

/// Half a unit in the last place, relative to the number.
const HALF_BIT: f64 = 0.5 * f64::EPSILON;

/// Body and start with perturbed numbers: each is changed by a multiple of its rounding error, with
/// random sign.
///
/// Each number changes in proportion to itself, so that zero stays zero. Equal second moments stay
/// equal, because a body is symmetric by construction and not by chance.
#[derive(Clone, Debug)]
pub(super) struct Inputs {
    pub(super) rotor: Rotor,
    pub(super) history: Option<MassHistory>,
    pub(super) start: State,
}

impl Inputs {
    pub(super) fn of(problem: &RotorProblem<'_>, changes: (u64, f64)) -> Self {
        let mut change = Change::new(changes);
        let RotorProblem { rotor, history, start, .. } = *problem;
        let stretch = change.stretch(rotor.inertia().symmetric());
        let inertia = stretched(rotor.inertia().symmetric(), stretch);
        let history = history.map(|history| history.stretched(stretch));
        let lever = Vector::from_array(change.each(rotor.lever().to_array()));
        let start = change.start(start);
        Self { rotor: rotor.with_inertia(inertia, lever).unwrap_or_else(|| rotor.clone()), history, start }
    }
}

/// Generator of perturbations: a multiple of the rounding error, with random sign.
#[derive(Clone, Debug)]
pub(super) struct Change {
    random: Random,
    delta: f64,
}

impl Change {
    pub(super) const fn new((seed, amplitude): (u64, f64)) -> Self {
        Self { random: Random::new(seed), delta: amplitude * HALF_BIT }
    }

    fn factor(&mut self) -> f64 {
        if self.random.next() < 0.0 { 1.0 - self.delta } else { 1.0 + self.delta }
    }

    pub(super) fn each<const N: usize>(&mut self, numbers: [f64; N]) -> [f64; N] {
        numbers.map(|x| x * self.factor())
    }

    pub(super) fn start(&mut self, start: State) -> State {
        let quaternion = self.each(start.attitude.quaternion());
        let omega = Vector::from_array(self.each(start.omega.to_array()));
        // A nearly unit quaternion can always be normalised.
        State { attitude: Rotation::from_quaternion(quaternion).unwrap_or(start.attitude), omega, ..start }
    }

    /// Returns the inertia tensor of the second moments D S D, D = diag(d). S = ½ tr(I) 1 − I stays
    /// positive semi-definite, so the body stays physical.
    pub(super) fn inertia(&mut self, i: &Symmetric3) -> Symmetric3 {
        let stretch = self.stretch(i);
        stretched(i, stretch)
    }

    /// Returns the stretch factors d.
    fn stretch(&mut self, i: &Symmetric3) -> [f64; 3] {
        let [a, b, c] = self.each([1.0; 3]);
        let half = 0.5 * (i.xx + i.yy + i.zz);
        let [sx, sy, sz] = [half - i.xx, half - i.yy, half - i.zz];
        let near = |p: f64, q: f64| (p - q).abs() <= 1e-12 * half;
        let b = if near(sx, sy) { a } else { b };
        let c = if near(sx, sz) {
            a
        } else if near(sy, sz) {
            b
        } else {
            c
        };
        [a, b, c]
    }
}

/// Returns the inertia tensor of the second moments D S D.
fn stretched(i: &Symmetric3, [a, b, c]: [f64; 3]) -> Symmetric3 {
    let half = 0.5 * (i.xx + i.yy + i.zz);
    Symmetric3 {
        xx: a * a * (half - i.xx),
        yy: b * b * (half - i.yy),
        zz: c * c * (half - i.zz),
        xy: -a * b * i.xy,
        xz: -a * c * i.xz,
        yz: -b * c * i.yz,
    }
    .inertia_of_second_moments()
}
