//! Scenario in symbols: its body and start as exact formulas of the `[symbols]` of its file.
//!
//! | file | holds |
//! |---|---|
//! | `scenario` | [`Exact`], [`Symbolic`]: the symbols with their values, body, ω, gravity, pendulum |
//! | `body` | [`SymbolicBody`]: parts with mass, centre and tensor; their sums and shifts |
//! | `moments` | [`Moments`]: volume, centroid and second moments of each shape |
//! | `rotation` | exact sines and cosines, rotation matrices |
//! | `gap` | [`Gap`]: what has no exact formula, and why |

mod body;
mod gap;
mod moments;
mod rotation;
mod scenario;

pub(crate) use body::shift;
pub use body::{OwnTensor, SymbolicBody, SymbolicPart, SymbolicParticle};
pub use gap::Gap;
pub use moments::Moments;
pub use rotation::{about_axis, sine_and_cosine, unit};
pub use scenario::{Exact, Known, Symbolic, SymbolicPendulum};
