//! Assembly of the derivatives, and conversion to body axes and SI units.

use crate::motion::model::state::State;
use crate::motion::model::state_derivatives::StateDerivatives;
use crate::motion::solve::free::labelled::Labelled;

use super::functions::TimeFunctions;
use super::inertia::ByInertia;
use super::momentum::{MomentumFlow, PAIRS, cross};

/// Derivatives of θ and ω (rows, body axes), in units of the elements.
///
/// Columns: ω(0) along body axes, and the elements 11, 22, 33, 12, 13, 23 of the inertia tensor
/// along the labelled axes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Columns {
    pub(super) by_omega: [[f64; 3]; 6],
    pub(super) by_tensor: [[f64; 6]; 6],
}

/// Maps from the labelled axes to the body axes, and from the units of the elements to SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ToBody {
    /// Labelled axes in body axes, one per column.
    pub(super) axes: [[f64; 3]; 3],
    /// `axes` with columns multiplied by 1/i1, 1/i2, 1/i3: map from L along the labelled axes to ω
    /// in body axes.
    to_omega: [[f64; 3]; 3],
    /// Map from ω in body axes to L along the labelled axes.
    to_momentum: [[f64; 3]; 3],
    /// L(0), body axes.
    momentum: [f64; 3],
    /// Derivatives of the elements 11, 22, 33, 12, 13, 23 along the labelled axes with respect to
    /// xx, yy, zz, xy, xz, yz along the body axes, in units of the elements.
    tensor: [[f64; 6]; 6],
    /// rad/s per unit of the elements' rates, and its inverse.
    rad_s: [f64; 2],
}

impl ToBody {
    pub(super) fn of(flow: &MomentumFlow, labelled: &Labelled, kg_m2: f64, rad_s: f64) -> Self {
        let a = labelled.axes;
        let axes = [0, 1, 2].map(|x| a.map(|axis| axis[x]));
        let tensor = PAIRS.map(|[j, k]| {
            PAIRS.map(|[x, y]| {
                let both = a[j][x] * a[k][y];
                (if x == y { both } else { both + a[j][y] * a[k][x] }) / kg_m2
            })
        });
        Self {
            axes,
            to_omega: axes.map(|row| [0, 1, 2].map(|k| row[k] * flow.inverse[k])),
            to_momentum: [0, 1, 2].map(|k| a[k].map(|x| x / flow.inverse[k])),
            momentum: axes.map(|row| dot(&row, &flow.start)),
            tensor,
            rad_s: [rad_s, 1.0 / rad_s],
        }
    }

    /// Returns the components of a body vector along the labelled axes.
    #[inline(always)]
    pub(super) fn along(&self, v: [f64; 3]) -> [f64; 3] {
        let [x, y, z] = &self.axes;
        let along = |k: usize| x[k] * v[0] + y[k] * v[1] + z[k] * v[2];
        [along(0), along(1), along(2)]
    }

    /// Returns the derivatives at L = `l`. `back`, B, is the rotation from the start to the present
    /// body axes. M is ∂L(t)/∂L(0).
    ///
    /// L is constant in space, so θ × L = B δL(0) − δL(t) for θ(0) = 0. Further, L·θ = t ω·δL(0) +
    /// ∫ δH dt with δH = −½ ω·δI ω. Hence
    ///
    /// L² θ = L (L·θ) + L × (B δL(0) − δL(t)),  δω = I⁻¹ (δL − δI ω)
    #[inline(always)]
    pub(super) fn columns(
        &self,
        flow: &MomentumFlow,
        l: &[f64; 3],
        back: &[[f64; 3]; 3],
        f: &TimeFunctions,
    ) -> Columns {
        let by_start = flow.derivative(l, f);
        let ByInertia { action, momentum } = flow.by_inertia(l, &by_start, f);
        let over = flow.over[0];
        let along = [l[0] * over, l[1] * over, l[2] * over];
        let inverse = flow.inverse;
        let before = [inverse[0] * flow.start[0], inverse[1] * flow.start[1], inverse[2] * flow.start[2]];
        let now = [inverse[0] * l[0], inverse[1] * l[1], inverse[2] * l[2]];
        // B − M
        let lag = [
            [back[0][0] - by_start[0][0], back[0][1] - by_start[0][1], back[0][2] - by_start[0][2]],
            [back[1][0] - by_start[1][0], back[1][1] - by_start[1][1], back[1][2] - by_start[1][2]],
            [back[2][0] - by_start[2][0], back[2][1] - by_start[2][1], back[2][2] - by_start[2][2]],
        ];
        let rows = RowsOf {
            to_body: self,
            by_start: &by_start,
            lag,
            along,
            before,
            now,
            action,
            momentum,
            time: f.time,
        };
        let [x, y, z] = &self.axes;
        let (t1, t2, t3) = (rows.turn(x), rows.turn(y), rows.turn(z));
        let [x, y, z] = &self.to_omega;
        let (w1, w2, w3) = (rows.rate(x), rows.rate(y), rows.rate(z));
        Columns {
            by_omega: [t1.0, t2.0, t3.0, w1.0, w2.0, w3.0],
            by_tensor: [t1.1, t2.1, t3.1, w1.1, w2.1, w3.1],
        }
    }

    /// Returns the derivatives at a state in SI units. `turn` is the attitude at the start,
    /// relative to that of the state.
    #[inline(always)]
    pub(super) fn in_si(&self, columns: &Columns, turn: &[[f64; 3]; 3], state: State) -> StateDerivatives {
        let (w, t, [rad_s, second]) = (&columns.by_omega, &columns.by_tensor, self.rad_s);
        let start = |turn: &[f64; 3], w: &[f64; 3], unit: f64| {
            [turn[0], turn[1], turn[2], unit * w[0], unit * w[1], unit * w[2]]
        };
        let none = &[0.0; 3];
        let tensor = |row: &[f64; 6], unit: f64| {
            let m = &self.tensor;
            six(|k| {
                let diagonal = row[0] * m[0][k] + row[1] * m[1][k] + row[2] * m[2][k];
                unit * (diagonal + (row[3] * m[3][k] + row[4] * m[4][k] + row[5] * m[5][k]))
            })
        };
        StateDerivatives {
            state,
            by_start: [
                start(&turn[0], &w[0], second),
                start(&turn[1], &w[1], second),
                start(&turn[2], &w[2], second),
                start(none, &w[3], 1.0),
                start(none, &w[4], 1.0),
                start(none, &w[5], 1.0),
            ],
            by_inertia: [
                tensor(&t[0], 1.0),
                tensor(&t[1], 1.0),
                tensor(&t[2], 1.0),
                tensor(&t[3], rad_s),
                tensor(&t[4], rad_s),
                tensor(&t[5], rad_s),
            ],
        }
    }
}

/// Inputs of the rows along body axes. Its methods are not closures: closures are not always
/// inlined, and are then not compiled for wide vectors.
struct RowsOf<'a> {
    to_body: &'a ToBody,
    by_start: &'a [[f64; 3]; 3],
    /// B − M
    lag: [[f64; 3]; 3],
    /// L/L²
    along: [f64; 3],
    /// ω at the start, labelled axes.
    before: [f64; 3],
    /// ω now, labelled axes.
    now: [f64; 3],
    action: [f64; 6],
    momentum: [[f64; 6]; 3],
    time: f64,
}

impl RowsOf<'_> {
    /// Returns the row of θ along a body axis, from its components along L and perpendicular to it.
    #[inline(always)]
    fn turn(&self, axis: &[f64; 3]) -> ([f64; 3], [f64; 6]) {
        let (across, along) = (cross(axis, &self.along), dot(axis, &self.along));
        let turn = product(&across, &self.lag);
        let share = product(&turn, &self.to_body.to_momentum);
        let (lever, change) = (levers(&turn, &self.before), product6(&across, &self.momentum));
        let of_omega = |k: usize| along * (self.time * self.to_body.momentum[k]) + share[k];
        let of_tensor = |p: usize| along * self.action[p] + (lever[p] - change[p]);
        (three(of_omega), six(of_tensor))
    }

    /// Returns the row of ω along a body axis.
    #[inline(always)]
    fn rate(&self, to_omega: &[f64; 3]) -> ([f64; 3], [f64; 6]) {
        let rate = product(to_omega, self.by_start);
        let (lever, change) = (levers(&rate, &self.before), product6(to_omega, &self.momentum));
        let now = levers(to_omega, &self.now);
        (product(&rate, &self.to_body.to_momentum), six(|p| (lever[p] + change[p]) - now[p]))
    }
}

// `from_fn` and `map` of arrays are not used here: they are inlined only with link-time
// optimisation (LTO).

#[inline(always)]
fn three(f: impl Fn(usize) -> f64) -> [f64; 3] {
    [f(0), f(1), f(2)]
}

#[inline(always)]
fn six(f: impl Fn(usize) -> f64) -> [f64; 6] {
    [f(0), f(1), f(2), f(3), f(4), f(5)]
}

#[inline(always)]
pub(super) fn dot(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Returns a row times a matrix.
#[inline(always)]
fn product(row: &[f64; 3], m: &[[f64; 3]; 3]) -> [f64; 3] {
    three(|k| row[0] * m[0][k] + row[1] * m[1][k] + row[2] * m[2][k])
}

#[inline(always)]
fn product6(row: &[f64; 3], m: &[[f64; 6]; 3]) -> [f64; 6] {
    six(|k| row[0] * m[0][k] + row[1] * m[1][k] + row[2] * m[2][k])
}

/// Returns a row times δI ω, for unit changes of the six elements of the inertia tensor.
#[inline(always)]
pub(super) fn levers(row: &[f64; 3], omega: &[f64; 3]) -> [f64; 6] {
    let ([a, b, c], [x, y, z]) = (*row, *omega);
    [a * x, b * y, c * z, a * y + b * x, a * z + c * x, b * z + c * y]
}
