//! Is this program's motion right? A motion as another program logged it ([`MotionLog`]), against the motion of a [`crate::motion::Scenario`].
//!
//! Energy and angular momentum that are kept prove little: without ω × I ω they are kept to the last digit, and the attitude is wrong after
//! a second. So the attitude itself is compared, row by row, with the exact one.

pub mod cause;
pub(crate) mod log;
pub(crate) mod motion;

pub use log::{LogError, MotionLog, QuaternionOrder};
pub use motion::ReadMotion;
