//! Gauss collocation: polynomials that satisfy the equations at the Gauss nodes, with steps as long
//! as the polynomials allow.
//!
//! The method evaluates only the equations, at eight nodes of a step simultaneously. It is faster
//! than the Taylor series if the motion is smooth and the graph of products is long.

mod matrices;
mod nodes;
mod step;
mod system;

pub(in crate::motion) use nodes::{Nodes, monomials};
pub(in crate::motion) use step::{Collocation, StepWork, Wanted};
pub(in crate::motion) use system::{OUTPUTS, ROOM, System, Variables};
