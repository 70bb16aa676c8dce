//! Errors of the server of the page.

use std::error::Error;
use std::fmt;
use std::io;
use std::net::SocketAddr;

use polhode_web::LessonError;

/// Error of the server of the page.
#[derive(Debug)]
#[non_exhaustive]
pub enum LiveError {
    /// A file cannot be shown.
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
    /// The folder for dropped files cannot be made.
    Folder {
        /// Error of the system.
        error: io::Error,
    },
    /// The system provides no random numbers for the token.
    Random,
    /// The server cannot start.
    Start {
        /// Error of the system.
        error: io::Error,
    },
}

impl LiveError {
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
            Self::Folder { .. } => Some("set TMPDIR to a writable folder for temporary files"),
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
            Self::Folder { error } => write!(f, "cannot create a folder for dropped files: {error}"),
            Self::Random => f.write_str("the system provides no random numbers for the token"),
            Self::Start { error } => write!(f, "cannot start the server: {error}"),
        }
    }
}

impl Error for LiveError {}
