//! How a state depends on its start and on the inertia tensor.

use super::state::State;

/// The derivatives of a state: rows θ1 θ2 θ3 ω1 ω2 ω3, where attitude = R exp(θ), θ a small rotation vector along body axes (rad),
/// ω along body axes (rad/s).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StateDerivatives {
    /// The state itself.
    pub state: State,
    /// By θ and ω of the start, along body axes: the state transition matrix Φ(t, t0). Columns θ1 θ2 θ3 ω1 ω2 ω3.
    pub by_start: [[f64; 6]; 6],
    /// By the elements of the inertia tensor, kg·m²: columns xx, yy, zz, xy, xz, yz. I_xy = I_yx is one number, an element of the tensor:
    /// minus the integral of xy.
    pub by_inertia: [[f64; 6]; 6],
}

impl StateDerivatives {
    /// The covariance of the state, to first order, from that of the start and that of the inertia tensor, which are independent of each
    /// other: Φ P Φᵀ + G Q Gᵀ, rows and columns in the order of the derivatives.
    #[must_use]
    pub fn covariance(&self, start: &[[f64; 6]; 6], inertia: &[[f64; 6]; 6]) -> [[f64; 6]; 6] {
        let (of_start, of_inertia) = (carried(&self.by_start, start), carried(&self.by_inertia, inertia));
        let mut sum = of_start;
        for (row, other) in sum.iter_mut().zip(of_inertia) {
            for (element, x) in row.iter_mut().zip(other) {
                *element += x;
            }
        }
        sum
    }

    /// Of a time at which nothing is known.
    #[cold]
    pub(crate) fn unknown(time: f64) -> Self {
        let none = [[f64::NAN; 6]; 6];
        Self { state: State::unknown(time), by_start: none, by_inertia: none }
    }
}

/// D C Dᵀ
fn carried(derivatives: &[[f64; 6]; 6], covariance: &[[f64; 6]; 6]) -> [[f64; 6]; 6] {
    let dot = |a: &[f64; 6], b: &[f64; 6]| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
    let half = derivatives.map(|row| [0, 1, 2, 3, 4, 5].map(|k| dot(&row, &covariance.map(|c| c[k]))));
    half.map(|row| derivatives.map(|other| dot(&row, &other)))
}
