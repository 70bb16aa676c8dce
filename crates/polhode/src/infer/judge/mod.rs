//! Judgement of a program's motion: a motion that another program logged ([`MotionLog`]) is
//! compared with that of a [`crate::motion::Scenario`].
//!
//! Conservation of energy and angular momentum proves little: without ω × I ω they are conserved to
//! full precision, but the attitude is wrong after a second. Therefore the attitude itself is
//! compared, row by row, with the exact one.

pub(crate) mod accuracy_order;
pub(crate) mod axes;
mod beginning;
pub(crate) mod cause;
pub(crate) mod declared;
mod difference;
pub(crate) mod error;
pub(crate) mod growth;
pub(crate) mod judgement;
pub(crate) mod log;
pub(crate) mod log_mistake;
pub(crate) mod motion;
mod omega;
pub(crate) mod omega_reading;
pub(crate) mod reading;
pub(crate) mod readings;
pub(crate) mod reference;
pub(crate) mod row_errors;
mod search;
mod shifted;
pub(crate) mod split;

pub use accuracy_order::{AccuracyOrder, StepErrors};
pub use axes::SignedAxes;
pub use cause::{Cause, Causes, Scheme, TriedCause, TriedStart, Turn, Untried, causes};
pub use declared::{AttitudeSense, DeclaredByName, DeclaredReading, OmegaAxes};
pub use error::JudgeError;
pub use growth::Growth;
pub use judgement::Judgement;
pub use log::{LogError, MotionLog, QuaternionOrder};
pub use log_mistake::LogMistake;
pub use motion::ReadMotion;
pub use omega_reading::{OmegaReading, OmegaResidual};
pub use reading::{Reading, ReadingResidual};
pub use readings::Readings;
pub use reference::Reference;
pub use row_errors::{RateErrors, RowErrors};
pub use split::{PartKind, Split, SplitPart};
