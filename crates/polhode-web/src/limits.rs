//! Limits of a session and of a computation.
//!
//! The engine has no clock: its caller applies the limits of time, by a [`Watch`](crate::Watch).

use std::time::Duration;

/// Maximum number of documents in a session. Each keeps the files that it has read.
pub const DOCUMENTS: usize = 100;

/// Maximum number of edits in a request.
pub const EDITS: usize = 64;

/// Maximum number of samples of a motion that the page shows.
pub const SAMPLES: usize = 2_001;

/// Time limit for a motion. Longer computations need `polhode simulate`.
pub const MOTION: Duration = Duration::from_secs(20);

/// Time limit for the inspection of a mesh, or of all meshes of a robot. Unfinished checks are
/// reported as undecided.
pub const INSPECTION: Duration = Duration::from_secs(20);
