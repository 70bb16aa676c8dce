//! Steady motions: states at rest in a frame that rotates uniformly or not at all.

use crate::math::eigenvalues::Matrix;
use crate::math::frame::{Body, Space};
use crate::math::rotation::Rotation;
use crate::math::symmetric3::Symmetric3;
use crate::math::vector::{AngularMomentum, AngularVelocity, Direction, Torque};
use crate::motion::error::MotionError;
use crate::motion::model::require;
use crate::motion::model::rotor::Rotor;
use crate::motion::model::state::State;
use crate::motion::model::torque::{TorqueModel, total_torque};

/// Steady motion, with the rotor and the torques.
pub(super) struct Steady<'a> {
    rotor: &'a Rotor,
    torques: &'a [TorqueModel],
    state: State,
    /// Sum of the energy-sink coefficients, Σ α.
    sink: f64,
    /// Magnitude of the torques, N·m.
    scale: f64,
}

/// Largest unbalanced torque, relative to the magnitude of the torques.
const BALANCED: f64 = 1e-8;

/// Largest change of a derivative along the motion, relative to the largest derivative.
const LASTING: f64 = 1e-7;

/// Maximum number of Newton steps; about five are sufficient where it converges.
const MOST_STEPS: usize = 60;

impl<'a> Steady<'a> {
    pub(super) fn new(
        rotor: &'a Rotor,
        torques: &'a [TorqueModel],
        state: State,
    ) -> Result<Self, MotionError> {
        let steady = Self::unchecked(rotor, torques, state)?;
        steady.require_balance(&state)?;
        let time = steady.period() / 7.0;
        for count in [1.0, 2.0, 3.0] {
            steady.require_balance(&steady.later(count * time))?;
        }
        Ok(steady)
    }

    fn unchecked(rotor: &'a Rotor, torques: &'a [TorqueModel], state: State) -> Result<Self, MotionError> {
        let [least, _, greatest] = rotor.principal().moments();
        let rule = "above zero: the spin of a rod about its own line is undetermined";
        require::that("the least moment of inertia", least, least > 0.0, rule)?;
        let motor = rotor.motor_torque(state.time).norm();
        if motor > 0.0 {
            return Err(MotionError::NotSteady { torque: motor, scale: motor });
        }
        let spin = state.omega.norm();
        let gyroscopic = (greatest * spin + rotor.wheel_momentum(state.time).norm()) * spin;
        let scale = torques.iter().map(|torque| torque.scale(rotor, &state)).sum::<f64>();
        let scale = scale.max(total_torque(torques, rotor, &state).norm()) + gyroscopic;
        if !scale.is_finite() {
            return Err(MotionError::NotFinite { time: state.time });
        }
        Ok(Self { rotor, torques, state, sink: torques.iter().map(TorqueModel::sink).sum(), scale })
    }

    pub(super) const fn state(&self) -> State {
        self.state
    }

    /// Returns L = I ω + h with the present wheel momentum; a motor that changes it later ends the
    /// steady motion.
    fn momentum(&self, state: &State) -> AngularMomentum<Body> {
        self.rotor.angular_momentum(state.omega) + self.rotor.wheel_momentum(self.state.time)
    }

    /// Returns L × ω + N, N·m, which is zero in a steady motion.
    fn rest(&self, state: &State) -> Torque<Body> {
        self.momentum(state).cross(state.omega) + total_torque(self.torques, self.rotor, state)
    }

    fn require_balance(&self, state: &State) -> Result<(), MotionError> {
        let bending = self.momentum(state).cross(state.omega).norm();
        let torque = self.rest(state).norm();
        // With internal friction, the motion is steady only if ω is along L.
        let torque = if self.sink > 0.0 { torque.max(bending) } else { torque };
        if torque.is_nan() {
            return Err(MotionError::NotFinite { time: state.time });
        }
        if torque <= BALANCED * self.scale {
            Ok(())
        } else {
            Err(MotionError::NotSteady { torque, scale: self.scale })
        }
    }

    /// Returns a characteristic rate of the motion, rad/s: |ω| or √(N/I), whichever is larger.
    fn rate(&self) -> f64 {
        let [.., greatest] = self.rotor.principal().moments();
        let rate = self.state.omega.norm().max((self.scale / greatest).sqrt());
        if rate > 0.0 { rate } else { 1.0 }
    }

    fn period(&self) -> f64 {
        core::f64::consts::TAU / self.rate()
    }

    /// Returns the steady motion at a later time.
    fn later(&self, time: f64) -> State {
        let turn: Direction<Space> = (self.state.omega_space() * time).as_quantity();
        let attitude = Rotation::<Space, Space>::from_rotation_vector(turn) * self.state.attitude;
        State { time: self.state.time + time, attitude, ..self.state }
    }

    /// Returns ∂N/∂θ and ∂N/∂ω by columns.
    fn derivatives(&self, at: &State) -> Result<[[Torque<Body>; 3]; 2], MotionError> {
        let mut sum = [[Torque::ZERO; 3]; 2];
        for torque in self.torques {
            let jacobian = torque.jacobian(self.rotor, at)?;
            for (sum, part) in sum.iter_mut().zip([jacobian.by_attitude, jacobian.by_omega]) {
                sum.iter_mut().zip(part).for_each(|(sum, part)| *sum += part);
            }
        }
        Ok(sum)
    }

    /// Returns the derivative of L × ω + N with respect to a rotation about each axis, with ω
    /// constant in space: δω = ω × δθ.
    fn slopes(&self, at: &State) -> Result<[Torque<Body>; 3], MotionError> {
        let [by_angle, by_rate] = self.derivatives(at)?;
        Ok([0, 1, 2].map(|k| {
            let more: AngularVelocity<Body> = at.omega.cross(unit(k));
            let bending = self.rotor.angular_momentum(more).cross(at.omega) + self.momentum(at).cross(more);
            let [x, y, z] = more.to_array();
            bending + by_angle[k] + by_rate[0] * x + by_rate[1] * y + by_rate[2] * z
        }))
    }

    /// Returns the matrix of the linear equations for (δθ, δω/w) in the time unit 1/w, and w, 1/s;
    /// `None` if the matrix is zero.
    pub(super) fn linearised(&self) -> Result<Option<(Matrix<6>, f64)>, MotionError> {
        let not_finite = MotionError::NotFinite { time: self.state.time };
        let [by_angle, by_rate] = self.derivatives(&self.state)?;
        let later = self.derivatives(&self.later(self.period() / 7.0))?;
        let largest = by_angle.iter().fold(0.0, |max: f64, x| max.max(x.max_abs()));
        let change = by_angle.iter().zip(&later[0]).map(|(a, b)| (*a - *b).max_abs()).fold(0.0, f64::max);
        if change > LASTING * largest.max(self.scale) {
            return Err(MotionError::NotSteady { torque: change, scale: largest.max(self.scale) });
        }
        let (omega, momentum) = (self.state.omega, self.momentum(&self.state));
        // Columns for a unit of δθ or δω along each axis.
        let mut columns = [[0.0; 6]; 6];
        for k in 0..3 {
            let turn = unit(k);
            columns[k] = joined((-omega.cross(turn)).to_array(), self.over_inertia(by_angle[k]));
            let more: AngularVelocity<Body> = turn.as_quantity();
            // δ(L × ω), the rotation rate Ω = ω + α L × ω, and L × Ω.
            let bending = self.rotor.angular_momentum(more).cross(omega) + momentum.cross(more);
            let slip: AngularVelocity<Body> = (bending * self.sink).as_quantity();
            let torque = bending + momentum.cross(slip) + by_rate[k];
            columns[k + 3] = joined((more + slip).to_array(), self.over_inertia(torque));
        }
        let block = |i: usize, j: usize| {
            let part = columns[j..j + 3].iter().flat_map(|column| &column[i..i + 3]);
            part.fold(0.0, |max: f64, x| max.max(x.abs()))
        };
        let w = block(0, 0).max(block(3, 3)).max(block(3, 0).sqrt());
        if !w.is_finite() {
            return Err(not_finite);
        }
        if w == 0.0 {
            return Ok(None);
        }
        let scaled = |i: usize, j: usize| match (i < 3, j < 3) {
            (true, true) | (false, false) => columns[j][i] / w,
            (true, false) => columns[j][i],
            (false, true) => columns[j][i] / w / w,
        };
        Ok(Some((core::array::from_fn(|i| core::array::from_fn(|j| scaled(i, j))), w)))
    }

    /// Returns I⁻¹ N, rad/s².
    fn over_inertia(&self, torque: Torque<Body>) -> [f64; 3] {
        self.rotor.acceleration(AngularVelocity::ZERO, torque).to_array()
    }

    /// Finds the steady motion that Newton's method reaches from a state, with ω constant in space.
    ///
    /// Rotations that have no effect, such as those about the vertical, are excluded: each step is
    /// the shortest solution.
    pub(super) fn near(
        rotor: &'a Rotor,
        torques: &'a [TorqueModel],
        start: State,
    ) -> Result<State, MotionError> {
        let steady = Self::unchecked(rotor, torques, start)?;
        let in_space = start.omega_space();
        let turned = |state: &State, turn: Direction<Body>| {
            let attitude = state.attitude * Rotation::<Body, Body>::from_rotation_vector(turn);
            State { attitude, omega: attitude.inverse() * in_space, ..*state }
        };
        let mut state = start;
        let mut rest = steady.rest(&state);
        for _ in 0..MOST_STEPS {
            if !(rest.norm() > f64::EPSILON * steady.scale) {
                break;
            }
            let full = shortest_solution(steady.slopes(&state)?.map(Torque::to_array), (-rest).to_array());
            // Steps are limited to half a radian, and halved while they give no improvement.
            let mut step = full * (0.5 / full.norm().max(0.5));
            let mut better = None;
            for _ in 0..12 {
                let there = turned(&state, step);
                let left = steady.rest(&there);
                if left.norm() < rest.norm() {
                    better = Some((there, left));
                    break;
                }
                step = step * 0.5;
            }
            let Some(better) = better else { break };
            (state, rest) = better;
        }
        Self::new(rotor, torques, state).map(|steady| steady.state)
    }
}

fn unit(k: usize) -> Direction<Body> {
    Direction::from_array(core::array::from_fn(|i| if i == k { 1.0 } else { 0.0 }))
}

fn joined([a, b, c]: [f64; 3], [d, e, f]: [f64; 3]) -> [f64; 6] {
    [a, b, c, d, e, f]
}

/// Returns the shortest x that minimises |J x − b|, with J given by columns: x = Σ v (v · Jᵀb)/λ
/// over the eigenvectors v of JᵀJ whose eigenvalue λ is not rounding.
fn shortest_solution(columns: [[f64; 3]; 3], b: [f64; 3]) -> Direction<Body> {
    let dot = |a: &[f64; 3], b: &[f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let [x, y, z] = &columns;
    let squared = Symmetric3 {
        xx: dot(x, x),
        yy: dot(y, y),
        zz: dot(z, z),
        xy: dot(x, y),
        xz: dot(x, z),
        yz: dot(y, z),
    };
    let eigen = squared.eigen();
    let right = columns.map(|column| dot(&column, &b));
    let parts =
        eigen.values.iter().zip(&eigen.vectors).filter(|(value, _)| **value > 1e-12 * eigen.values[2]);
    parts.fold(Direction::ZERO, |sum, (value, v)| sum + Direction::from_array(*v) * (dot(v, &right) / value))
}
