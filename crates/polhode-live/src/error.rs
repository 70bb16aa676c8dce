//! Errors of the server of the page.

use std::error::Error;
use std::fmt;
use std::io;
use std::net::SocketAddr;
use std::path::Path;

use polhode_source::shown;
use polhode_web::{LessonError, Refusal};

use crate::limits;

/// Error of the server of the page.
#[derive(Debug)]
#[non_exhaustive]
pub enum LiveError {
    /// A file cannot be shown, or there are too many.
    File {
        /// Name of the file and reason.
        message: String,
        /// Advice for a fix, if there is any.
        hint: Option<String>,
    },
    /// A lesson is invalid.
    Lesson(LessonError),
    /// The server cannot listen on the address.
    Address {
        /// Requested address.
        address: SocketAddr,
        /// Error of the system.
        error: io::Error,
    },
    /// The system provides no random numbers for the token.
    Random,
}

impl LiveError {
    pub(crate) fn unreadable(path: &Path, why: &str) -> Self {
        Self::File { message: format!("{} cannot be read: {why}", shown(path)), hint: None }
    }

    pub(crate) fn too_large(path: &Path) -> Self {
        Self::limit(path, &format!("a file has at most {} MiB", limits::FILE >> 20))
    }

    pub(crate) fn limit(path: &Path, rule: &str) -> Self {
        Self::File { message: format!("{} exceeds a limit: {rule}", shown(path)), hint: None }
    }

    pub(crate) fn refused(Refusal { message, hint, .. }: Refusal) -> Self {
        Self::File { message, hint }
    }

    /// Returns advice for a fix, if there is any.
    pub fn hint(&self) -> Option<&str> {
        match self {
            Self::File { hint, .. } | Self::Lesson(LessonError { hint, .. }) => hint.as_deref(),
            Self::Address { error, .. } if error.kind() == io::ErrorKind::AddrInUse => {
                Some("another program uses this port: omit --port to use a free one")
            }
            Self::Address { error, .. } if error.kind() == io::ErrorKind::PermissionDenied => {
                Some("ports below 1024 need administrator rights: omit --port to use a free one")
            }
            _ => None,
        }
    }
}

impl fmt::Display for LiveError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::File { message, .. } => f.write_str(message),
            Self::Lesson(error) => error.fmt(f),
            Self::Address { address, error } => write!(f, "cannot listen on {address}: {error}"),
            Self::Random => f.write_str("the system provides no random numbers for the token"),
        }
    }
}

impl Error for LiveError {}
