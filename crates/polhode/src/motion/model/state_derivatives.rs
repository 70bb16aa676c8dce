//! How a state changes with its start, and with the inertia of the body.

use super::state::State;

/// The derivatives of a state: rows θ1 θ2 θ3 ω1 ω2 ω3, where attitude = R exp(θ), θ a small rotation vector along body axes (rad), ω along body axes (rad/s).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StateDerivatives {
    /// The state itself.
    pub state: State,
    /// By θ(0) (body axes at the start) and ω(0): the state transition matrix Φ(t, t₀); columns θ1 θ2 θ3 ω1 ω2 ω3.
    pub by_start: [[f64; 6]; 6],
    /// By the elements of the inertia tensor, kg·m²: columns xx, yy, zz, xy, xz, yz. I_xy = I_yx is one number, and it is the tensor's element,
    /// which is minus the integral.
    pub by_inertia: [[f64; 6]; 6],
}

impl StateDerivatives {
    /// The covariance of the state to first order, Φ C Φᵀ + S K Sᵀ, of C, that of the start, and K, that of the inertia; rows and columns as
    /// those of the derivatives.
    pub fn covariance(&self, start: &[[f64; 6]; 6], inertia: &[[f64; 6]; 6]) -> [[f64; 6]; 6] {
        let [of_start, of_inertia] =
            [(&self.by_start, start), (&self.by_inertia, inertia)].map(|(by, c)| congruent(by, c));
        core::array::from_fn(|i| core::array::from_fn(|j| of_start[i][j] + of_inertia[i][j]))
    }

    /// Of a time at which nothing is known.
    #[cold]
    pub(crate) fn unknown(time: f64) -> Self {
        let none = [[f64::NAN; 6]; 6];
        Self { state: State::unknown(time), by_start: none, by_inertia: none }
    }
}

/// A C Aᵀ
fn congruent(a: &[[f64; 6]; 6], c: &[[f64; 6]; 6]) -> [[f64; 6]; 6] {
    let dot = |x: &[f64; 6], y: &[f64; 6]| x.iter().zip(y).map(|(x, y)| x * y).sum::<f64>();
    // Rows of A C, of a symmetric C.
    let half = a.map(|row| c.map(|column| dot(&row, &column)));
    half.map(|row| a.map(|column| dot(&row, &column)))
}
