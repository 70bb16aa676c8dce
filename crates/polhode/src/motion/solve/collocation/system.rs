//! What is asked of a system ẏ = f(y).

use crate::math::algebra::Field;

/// The most variables.
pub(in crate::motion) const ROOM: usize = 17;
/// The most further functions.
pub(in crate::motion) const OUTPUTS: usize = 8;

/// Where the variables are whose rates come together, by threes, and nothing where such a system has none.
pub(in crate::motion) type Places<const N: usize> = [Option<usize>; N];

/// The variables of a system, by what their rates take.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::motion) struct Variables {
    pub(in crate::motion) count: usize,
    /// Few products: the axes of a body, of which ω is the rate.
    pub(in crate::motion) kinematic: Places<6>,
    /// All of the equations.
    pub(in crate::motion) dynamic: Places<9>,
    /// Those on which no rate depends.
    pub(in crate::motion) quadratures: Places<5>,
    /// How many further functions there are.
    pub(in crate::motion) outputs: usize,
}

/// An autonomous system, over numbers of which only the operations are known. What is returned where it has no variable does not matter.
pub(in crate::motion) trait System {
    fn variables(&self) -> Variables;

    /// The rates of the kinematic variables.
    fn kinematic<S: Field>(&self, y: &[S; ROOM]) -> [S; 6];

    /// The rates of the dynamic variables.
    fn dynamic<S: Field>(&self, one: S, y: &[S; ROOM]) -> [S; 9];

    /// The rates of the quadratures, and further functions of the variables.
    fn quadratures<S: Field>(&self, one: S, y: &[S; ROOM]) -> ([S; 5], [S; OUTPUTS]);
}
