//! Interface of a system ẏ = f(y) for collocation.

use crate::math::algebra::Field;

/// Largest number of variables.
pub(in crate::motion) const ROOM: usize = 17;
/// Largest number of further functions.
pub(in crate::motion) const OUTPUTS: usize = 8;

/// Indices of variables whose rates are computed together, in groups of three; `None` if the system
/// does not have the variable.
pub(in crate::motion) type Places<const N: usize> = [Option<usize>; N];

/// Variables of a system, grouped by the cost of their rates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::motion) struct Variables {
    pub(in crate::motion) count: usize,
    /// Variables whose rates need few products: the axes of a body, whose rate follows from ω.
    pub(in crate::motion) kinematic: Places<6>,
    /// Variables whose rates need the full equations.
    pub(in crate::motion) dynamic: Places<9>,
    /// Variables on which no rate depends.
    pub(in crate::motion) quadratures: Places<5>,
    /// Number of further functions.
    pub(in crate::motion) outputs: usize,
}

/// Autonomous system over a generic number type. Values returned for variables that the system does
/// not have are ignored.
pub(in crate::motion) trait System {
    fn variables(&self) -> Variables;

    /// Returns the rates of the kinematic variables.
    fn kinematic<S: Field>(&self, y: &[S; ROOM]) -> [S; 6];

    /// Returns the rates of the dynamic variables.
    fn dynamic<S: Field>(&self, one: S, y: &[S; ROOM]) -> [S; 9];

    /// Returns the rates of the quadratures, and the further functions of the variables.
    fn quadratures<S: Field>(&self, one: S, y: &[S; ROOM]) -> ([S; 5], [S; OUTPUTS]);
}
