//! Collocation: polynomials that satisfy the equations at the nodes of Gauss, of steps that are as long as a polynomial allows.
//!
//! Beside Taylor's series it evaluates the equations alone, at eight nodes of a step at once: where they are smooth and a graph of products is long, it is faster.

mod matrices;
mod nodes;
mod step;
mod system;

pub(in crate::motion) use nodes::{Nodes, monomials};
pub(in crate::motion) use step::{Collocation, StepWork, Wanted};
pub(in crate::motion) use system::{OUTPUTS, ROOM, System, Variables};
