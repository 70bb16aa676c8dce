//! What one request, one session and one computation may take.

use std::time::Duration;

/// Bytes of a request that is JSON: a scenario and its edits.
pub(crate) const JSON: usize = 4 << 20;

/// Bytes of a file that is dropped.
pub(crate) const FILE: usize = 256 << 20;

/// Bytes of all files that are dropped in a session.
pub(crate) const FILES: usize = 1 << 30;

/// Documents of a session: each keeps what it has read.
pub(crate) const DOCUMENTS: usize = 100;

/// How many files those may be.
pub(crate) const FILE_COUNT: usize = 4_000;

/// Edits of one request.
pub(crate) const EDITS: usize = 64;

/// Connections at the same time; a browser opens at most six for a tab.
pub(crate) const CONNECTIONS: usize = 64;

/// Heavy computations at the same time.
pub(crate) const HEAVY: usize = 2;

/// Heavy computations that wait; more are refused.
pub(crate) const WAITING: usize = 16;

/// Light computations at the same time, besides the heavy ones.
pub(crate) const LIGHT: usize = 2;

/// Time limit of a motion among the light computations; one that takes longer is computed again among the heavy ones.
pub(crate) const FIRST_TRY: Duration = Duration::from_millis(100);

/// Time limit of that first try with its body: what reads a body, as a formula of its density,
/// does not look at the clock.
pub(crate) const OVERRUN: Duration = Duration::from_millis(500);

/// For the headers of a request to come.
pub(crate) const HEADERS: Duration = Duration::from_secs(10);

/// For its body.
pub(crate) const BODY: Duration = Duration::from_secs(60);

/// For a motion: who wants more takes `polhode simulate`.
pub(crate) const MOTION: Duration = Duration::from_secs(20);

/// For an answer: what cannot be stopped goes on, but nobody waits for it.
pub(crate) const ANSWER: Duration = Duration::from_secs(40);

/// For what is wrong with a mesh, or with all meshes of a robot: what would take longer is undecided.
pub(crate) const INSPECTION: Duration = Duration::from_secs(20);

/// Samples of a motion: the page shows no more.
pub(crate) const SAMPLES: usize = 2_001;
