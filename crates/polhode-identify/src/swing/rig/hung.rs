//! Body on wires: equations of motion, equilibrium, and the small twist about it.

use nalgebra::{DMatrix, DVector};

use super::super::dual::{Dual, Gradient};
use super::super::number::Numbers;
use super::wires::Wires;
use super::{Equations, Load, Oscillator, Rest};
use crate::decomposition::{Svd, cholesky, lu, svd, symmetric_eigen};
use crate::error::IdentifyError;

/// Body on wires, with u = (p, e, λ): position of the centre of mass, quaternion from rig axes to
/// space, and tension divided by length of each wire.
pub(super) struct Hung {
    wires: usize,
    quantities: Vec<Gradient>,
    /// Unit vector between the lower ends of two wires if roll about it is neutral; the roll is
    /// then locked.
    held: Option<[f64; 3]>,
    rest: Rest,
}

/// Threshold below which the centre of mass lies on the line of two lower ends, relative to the
/// wires' length.
const ON_LINE: f64 = 1e-9;

/// Layout of the quantities: mass, weight, tensor about the centre, stiffness; then for each wire
/// its top, its bottom relative to the centre, its length.
const WIRES: usize = 9;
const OF_WIRE: usize = 7;
/// Number of components of p and e.
const PLACE: usize = 7;
/// Number of variables: u, the rates of e, and the accelerations of p and e, for three wires.
const STATE: usize = PLACE + 3 + 4 + 7;
const ALL: usize = STATE + WIRES + 3 * OF_WIRE;

/// Lower bound on the cosine of half the rotation between equilibrium and the described attitude:
/// cos ½·30°.
const AS_DESCRIBED: f64 = 0.966;

/// Allowance for an error of the centre's height on two wires: largest negative squared rate,
/// relative to that of the twist.
const NEARLY_FREE: f64 = 0.1;

/// Lower bound on the share of the twist in a mode's kinetic energy.
const TWIST: f64 = 0.6;

impl Hung {
    pub(super) fn new(wires: &Wires, numbers: &Numbers, load: &Load) -> Result<Self, IdentifyError> {
        let mut quantities = vec![load.mass.mass.clone(), load.weight.clone()];
        quantities.extend(load.mass.inertia.iter().cloned());
        quantities.push(numbers.linear(&wires.stiffness));
        for wire in &wires.wires {
            quantities.extend(numbers.point(&wire.top));
            let bottom = numbers.point(&wire.bottom);
            quantities.extend([0, 1, 2].map(|k| bottom[k].minus(&load.mass.center[k])));
            let length = numbers.linear(&wire.length);
            IdentifyError::above_zero("the length of a wire", length.value)?;
            quantities.push(length);
        }
        let rest = Rest { u: Vec::new(), mode: Vec::new(), rate: 0.0 };
        let mut this = Self { wires: wires.wires.len(), quantities, held: None, rest };
        this.held = this.neutral_roll()?;
        let u = this.at_rest()?;
        this.rest = this.small_twist(u)?;
        Ok(this)
    }

    fn wire(&self, k: usize) -> [f64; OF_WIRE] {
        core::array::from_fn(|j| self.quantities[WIRES + OF_WIRE * k + j].value)
    }

    /// Returns the axis of a neutral roll: a rotation about the wires' attachment without restoring
    /// torque.
    fn neutral_roll(&self) -> Result<Option<[f64; 3]>, IdentifyError> {
        let bottom = |k: usize| {
            let [_, _, _, x, y, z, _] = self.wire(k);
            nalgebra::Vector3::new(x, y, z)
        };
        let length = self.wire(0)[OF_WIRE - 1];
        if self.wires == 1 {
            let distance = bottom(0).norm();
            IdentifyError::require(
                "the distance of the centre of mass from the attachment of the wire",
                distance,
                distance > ON_LINE * length,
                "above zero",
            )?;
        }
        if self.wires != 2 {
            return Ok(None);
        }
        let along = bottom(1) - bottom(0);
        IdentifyError::above_zero("the distance between two wires", along.norm())?;
        let n = along / along.norm();
        let is_neutral = n.cross(&bottom(0)).norm() <= ON_LINE * length;
        Ok(is_neutral.then(|| n.into()))
    }

    /// Returns the equilibrium, by Newton's method from the described attitude.
    fn at_rest(&self) -> Result<Vec<f64>, IdentifyError> {
        let n = self.width();
        let mut u = vec![0.0; n];
        u[3] = 1.0;
        let share = 1.0 / self.wires as f64;
        for k in 0..self.wires {
            let [ax, ay, az, dx, dy, dz, length] = self.wire(k);
            let out = [ax - dx, ay - dy];
            let drop =
                (length * length - out[0] * out[0] - out[1] * out[1]).max(0.01 * length * length).sqrt();
            let place = [out[0], out[1], az - dz - drop];
            (0..3).for_each(|j| u[j] += share * place[j]);
            u[PLACE + k] = share * self.quantities[1].value / drop;
        }
        let still = vec![0.0; n];
        for _ in 0..60 {
            let equations = self.equations(&u, &still, &still, false);
            let matrix = lu("a derivative of the rig's equations at rest", equations.by_u)?;
            let Some(step) = matrix.solve(&DVector::from_vec(equations.value)) else { break };
            // Limit the step: positions are of the order of lengths, quaternions of the order of 1.
            let far = (0..PLACE).fold(0.0, |most: f64, k| most.max(step[k].abs()));
            if !far.is_finite() {
                break;
            }
            let held = (0.3 / far).min(1.0);
            u.iter_mut().zip(step.iter()).for_each(|(u, step)| *u -= held * step);
            if far < 1e-13 {
                self.check(&u)?;
                IdentifyError::require(
                    "the cosine of half the angle between the rig at rest and the described rig",
                    u[3],
                    u[3] >= AS_DESCRIBED,
                    "at least 0.966",
                )?;
                return Ok(u);
            }
        }
        Err(IdentifyError::NoConvergence { steps: 60 })
    }

    /// Returns the mode of small oscillation about equilibrium with the largest share of twist.
    fn small_twist(&self, u: Vec<f64>) -> Result<Rest, IdentifyError> {
        let n = self.width();
        let still = vec![0.0; n];
        let equations = self.equations(&u, &still, &still, false);
        let turn = quaternion_of_turns(&u);
        let moved = |by: &DMatrix<f64>| {
            let mut columns = DMatrix::zeros(n, 6);
            columns.columns_mut(0, 3).copy_from(&by.columns(0, 3));
            columns.columns_mut(3, 3).copy_from(&(by.columns(3, 4) * &turn));
            columns
        };
        let (stiffness, mass) = (moved(&equations.by_u), moved(&equations.by_acceleration));
        // Directions in which no wire changes its length, without a locked roll.
        let mut square = DMatrix::zeros(6, 6);
        square.rows_mut(0, self.wires).copy_from(&stiffness.rows(PLACE, self.wires));
        if let Some(n) = self.held {
            (0..3).for_each(|k| square[(self.wires, 3 + k)] = n[k]);
        }
        let Svd { values, v_t: vectors, .. } = svd("a derivative of the wires' lengths", square)?;
        let mut order: Vec<usize> = (0..6).collect();
        order.sort_by(|&a, &b| values[a].total_cmp(&values[b]));
        let free = 6 - self.wires - usize::from(self.held.is_some());
        let basis = DMatrix::from_fn(6, free, |i, j| vectors[(order[j], i)]);
        let reduced = |full: &DMatrix<f64>| {
            let small = basis.transpose() * full.rows(0, 6) * &basis;
            (&small + small.transpose()) * 0.5
        };
        let (stiffness, mass) = (reduced(&stiffness), reduced(&mass));
        let not_finite = IdentifyError::NotFinite { quantity: "the inverse of the rig's mass matrix" };
        let factor = cholesky("the rig's mass matrix", mass)?.ok_or_else(|| not_finite.clone())?.l();
        let inverse = factor.solve_lower_triangular(&DMatrix::identity(free, free)).ok_or(not_finite)?;
        let stiffness = &inverse * stiffness * inverse.transpose();
        let modes = symmetric_eigen("the rig's stiffness matrix", stiffness)?;
        let shapes = &basis * inverse.transpose() * modes.eigenvectors;
        // Share of the twist in shapes of unit kinetic energy.
        let about_axis = self.quantities[4].value;
        let share = |k: usize| about_axis * shapes[(5, k)] * shapes[(5, k)];
        let best = (0..free).max_by(|&a, &b| share(a).total_cmp(&share(b))).unwrap_or(0);
        IdentifyError::require(
            "the share of twist in the mode closest to a twist",
            share(best),
            share(best) >= TWIST,
            "at least 0.6; otherwise the mode is as much a sway",
        )?;
        let square = modes.eigenvalues[best];
        IdentifyError::above_zero("the squared frequency of small twists", square)?;
        // Two wires let a body roll about the line of their lower ends, almost freely if its centre
        // is close to the line.
        let least = modes.eigenvalues.min() / square;
        IdentifyError::require(
            "the squared frequency of another small motion, relative to that of the twist,",
            least,
            least >= if self.wires == 2 { -NEARLY_FREE } else { -1e-9 },
            "zero or more: in the described position the body would turn over, because its centre of mass is too high for these wires",
        )?;
        let mut mode = vec![0.0; n];
        (0..3).for_each(|k| mode[k] = shapes[(k, best)]);
        let turned = &turn * shapes.view((3, best), (3, 1));
        (0..4).for_each(|k| mode[3 + k] = turned[(k, 0)]);
        let (_, slope) = self.angle(&u);
        let angle: f64 = slope.iter().zip(&mode).map(|(a, b)| a * b).sum();
        mode.iter_mut().for_each(|x| *x /= angle);
        Ok(Rest { u, mode, rate: square.sqrt() })
    }
}

/// Returns ∂e/∂φ for a rotation φ about axes of the rig: ½ e (0, φ).
fn quaternion_of_turns(u: &[f64]) -> DMatrix<f64> {
    let [w, x, y, z] = [u[3], u[4], u[5], u[6]].map(|e| 0.5 * e);
    DMatrix::from_row_slice(4, 3, &[-x, -y, -z, w, -z, y, z, w, -x, -y, x, w])
}

type Triple<const N: usize> = [Dual<N>; 3];

fn cross<const N: usize>(a: &Triple<N>, b: &Triple<N>) -> Triple<N> {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn dot<const N: usize>(a: &Triple<N>, b: &Triple<N>) -> Dual<N> {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Returns twice the vector part of e* f.
fn twice_vector<const N: usize>(e: &[Dual<N>; 4], f: &[Dual<N>; 4]) -> Triple<N> {
    let v = [e[1], e[2], e[3]];
    let g = [f[1], f[2], f[3]];
    let across = cross(&v, &g);
    [0, 1, 2].map(|k| (e[0] * g[k] - f[0] * v[k] - across[k]).scaled(2.0))
}

fn rotation<const N: usize>([w, x, y, z]: &[Dual<N>; 4]) -> [Triple<N>; 3] {
    let (w, x, y, z) = (*w, *x, *y, *z);
    let two = |a: Dual<N>| a.scaled(2.0);
    [
        [w * w + x * x - y * y - z * z, two(x * y - w * z), two(x * z + w * y)],
        [two(x * y + w * z), w * w - x * x + y * y - z * z, two(y * z - w * x)],
        [two(x * z - w * y), two(y * z + w * x), w * w - x * x - y * y + z * z],
    ]
}

/// Returns the residuals of all equations: translation, rotation, |e| = 1, wire lengths.
fn residuals<const N: usize>(
    u: &[Dual<N>],
    rate: &[Dual<N>; 4],
    acceleration: &[Dual<N>; 7],
    q: &[Dual<N>],
    held: Option<[f64; 3]>,
) -> Vec<Dual<N>> {
    let [ax, ay, az, rest @ ..] = acceleration;
    let e = [u[3], u[4], u[5], u[6]];
    let r = rotation(&e);
    let back = |v: &Triple<N>| [0, 1, 2].map(|k| r[0][k] * v[0] + r[1][k] * v[1] + r[2][k] * v[2]);
    let mut force = [q[0] * *ax, q[0] * *ay, q[0] * *az + q[1]];
    // Torque of the twist in space: −κ θ ∇θ.
    let [w, x, y, z] = e;
    let over = (w * w + z * z).reciprocal();
    let twist = q[8] * z.atan2(w).scaled(2.0);
    let torque = [twist * (w * y + x * z) * over, twist * (y * z - w * x) * over, twist];
    let mut turn = back(&torque);
    let omega = twice_vector(&e, rate);
    let omega_rate = twice_vector(&e, rest);
    let inertia = |v: &Triple<N>| {
        [
            q[2] * v[0] + q[5] * v[1] + q[6] * v[2],
            q[5] * v[0] + q[3] * v[1] + q[7] * v[2],
            q[6] * v[0] + q[7] * v[1] + q[4] * v[2],
        ]
    };
    let (gyroscopic, inertial) = (cross(&omega, &inertia(&omega)), inertia(&omega_rate));
    (0..3).for_each(|k| turn[k] = turn[k] + inertial[k] + gyroscopic[k]);
    let mut lengths = Vec::with_capacity(3);
    for (wire, &tension) in q[WIRES..].chunks_exact(OF_WIRE).zip(&u[PLACE..]) {
        let d = [wire[3], wire[4], wire[5]];
        let reach = [0, 1, 2].map(|k| u[k] + dot(&r[k], &d) - wire[k]);
        lengths.push((dot(&reach, &reach) - wire[6] * wire[6]).scaled(0.5));
        let pull = reach.map(|c| c * tension);
        let moment = cross(&d, &back(&pull));
        (0..3).for_each(|k| {
            force[k] = force[k] + pull[k];
            turn[k] = turn[k] + moment[k];
        });
    }
    // A constraint torque locks the roll, so its equation is replaced by zero roll.
    if let Some(n) = held {
        let along = |v: &Triple<N>| v[0].scaled(n[0]) + v[1].scaled(n[1]) + v[2].scaled(n[2]);
        let change = q[1] * w * along(&[x, y, z]) - along(&turn);
        (0..3).for_each(|k| turn[k] = turn[k] + change.scaled(n[k]));
    }
    let unit = (w * w + x * x + y * y + z * z - Dual::constant(1.0)).scaled(0.5);
    let mut all = Vec::with_capacity(PLACE + 3);
    all.extend(force);
    all.extend(turn);
    all.push(unit);
    all.extend(lengths);
    all
}

impl Hung {
    fn differentiated<const N: usize>(&self, u: &[f64], rate: &[f64], acceleration: &[f64]) -> Equations {
        let n = self.width();
        let at = |values: &[f64], first: usize| -> Vec<Dual<N>> {
            values.iter().enumerate().map(|(k, &value)| Dual::variable(value, first + k)).collect()
        };
        let [rates, accelerations, quantities] = [n, n + 4, n + 4 + PLACE];
        let e_rate = core::array::from_fn(|k| Dual::variable(rate[3 + k], rates + k));
        let second = core::array::from_fn(|k| Dual::variable(acceleration[k], accelerations + k));
        let q: Vec<f64> = self.quantities.iter().map(|q| q.value).collect();
        let all = residuals(&at(u, 0), &e_rate, &second, &at(&q, quantities), self.held);
        let count = if N > STATE { q.len() } else { 0 };
        let block = |first: usize, columns: usize| {
            DMatrix::from_fn(all.len(), columns, |i, j| all[i].by.get(first + j).copied().unwrap_or(0.0))
        };
        let mut by_rate = DMatrix::zeros(n, n);
        by_rate.columns_mut(3, 4).copy_from(&block(rates, 4));
        let mut by_acceleration = DMatrix::zeros(n, n);
        by_acceleration.columns_mut(0, PLACE).copy_from(&block(accelerations, PLACE));
        Equations {
            value: all.iter().map(|dual| dual.value).collect(),
            by_u: block(0, n),
            by_rate,
            by_acceleration,
            by_quantities: block(quantities, count),
        }
    }
}

impl Oscillator for Hung {
    fn width(&self) -> usize {
        PLACE + self.wires
    }

    fn quantities(&self) -> &[Gradient] {
        &self.quantities
    }

    fn equations(&self, u: &[f64], rate: &[f64], acceleration: &[f64], by_quantities: bool) -> Equations {
        if by_quantities {
            self.differentiated::<ALL>(u, rate, acceleration)
        } else {
            self.differentiated::<STATE>(u, rate, acceleration)
        }
    }

    fn angle(&self, u: &[f64]) -> (f64, Vec<f64>) {
        let (w, z) = (u[3], u[6]);
        let mut slope = vec![0.0; self.width()];
        let square = w * w + z * z;
        slope[3] = -2.0 * z / square;
        slope[6] = 2.0 * w / square;
        (2.0 * libm::atan2(z, w), slope)
    }

    fn check(&self, u: &[f64]) -> Result<(), IdentifyError> {
        for k in 0..self.wires {
            let tension = u[PLACE + k] * self.wire(k)[OF_WIRE - 1];
            IdentifyError::require(
                "the tension of a wire",
                tension,
                tension > 0.0,
                "above zero; a slack wire carries no load",
            )?;
        }
        Ok(())
    }

    fn rest(&self) -> &Rest {
        &self.rest
    }
}
