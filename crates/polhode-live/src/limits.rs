//! Limits of requests, and of the files of a session.

use std::time::Duration;

pub(crate) use polhode_web::limits::{INSPECTION, MOTION};

/// Maximum size of a file, bytes.
pub(crate) const FILE: u64 = 256 << 20;

/// Maximum size of all files, bytes.
pub(crate) const FILES: u64 = 1 << 30;

/// Maximum number of files.
pub(crate) const FILE_COUNT: usize = 4_000;

/// Maximum number of simultaneous connections. A browser opens at most six for a tab.
pub(crate) const CONNECTIONS: usize = 64;

/// Maximum size of the head of a request, bytes. Browsers send the cookies of all servers of this
/// machine.
pub(crate) const HEAD: usize = 64 << 10;

/// Maximum number of headers.
pub(crate) const HEADERS: usize = 100;

/// Time limit for the head of a request.
pub(crate) const HEAD_TIME: Duration = Duration::from_secs(10);

/// Time limit in which a client must take some bytes of an answer.
pub(crate) const WRITE_TIME: Duration = Duration::from_secs(30);

/// Time in which a client closes its connection after an answer. Bytes that arrive meanwhile are
/// discarded.
pub(crate) const CLOSE_TIME: Duration = Duration::from_millis(500);

/// Time in which a program that saves a file by renaming another one completes this.
pub(crate) const RENAME_TIME: Duration = Duration::from_millis(100);
