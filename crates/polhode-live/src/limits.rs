//! Limits of a request and of its computation; those of the engine are in `polhode_web::limits`.

use std::time::Duration;

pub(crate) use polhode_web::limits::{INSPECTION, MOTION};

/// Maximum size of a JSON request (a scenario and its edits), bytes.
pub(crate) const JSON: usize = 4 << 20;

/// Maximum size of a dropped file, bytes.
pub(crate) const FILE: usize = 256 << 20;

/// Maximum size of all files dropped in a session, bytes.
pub(crate) const FILES: usize = 1 << 30;

/// Maximum number of files dropped in a session.
pub(crate) const FILE_COUNT: usize = 4_000;

/// Maximum number of simultaneous connections. A browser opens at most six for a tab.
pub(crate) const CONNECTIONS: usize = 64;

/// Maximum number of simultaneous heavy computations.
pub(crate) const HEAVY: usize = 2;

/// Maximum number of waiting heavy computations. Further ones are refused.
pub(crate) const WAITING: usize = 16;

/// Maximum number of simultaneous light computations, in addition to the heavy ones.
pub(crate) const LIGHT: usize = 2;

/// Time limit of a motion among the light computations. A longer one is computed again among the
/// heavy ones.
pub(crate) const FIRST_TRY: Duration = Duration::from_millis(100);

/// Time limit of that first try including its body. Reading a body, such as a formula of its
/// density, does not check the time.
pub(crate) const OVERRUN: Duration = Duration::from_millis(500);

/// Time limit for the headers of a request.
pub(crate) const HEADERS: Duration = Duration::from_secs(10);

/// Time limit for the body of a request.
pub(crate) const BODY: Duration = Duration::from_secs(60);

/// Time limit for an answer. A computation that cannot be stopped continues, but its result is
/// dropped.
pub(crate) const ANSWER: Duration = Duration::from_secs(40);
