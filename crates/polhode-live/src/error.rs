//! Why the page cannot be served.

use std::error::Error;
use std::fmt;
use std::io;
use std::net::SocketAddr;

/// Why the page cannot be served.
#[derive(Debug)]
#[non_exhaustive]
pub enum LiveError {
    /// A file cannot be shown.
    File {
        /// Which, and why.
        message: String,
        /// What to do about it, where there is something to say.
        hint: Option<String>,
    },
    /// The address cannot be listened on.
    Address {
        /// Which.
        address: SocketAddr,
        /// Why.
        error: io::Error,
    },
    /// The folder for what is dropped cannot be made.
    Folder {
        /// Why.
        error: io::Error,
    },
    /// The system gives no random numbers for the token.
    Random,
    /// The server cannot start.
    Start {
        /// Why.
        error: io::Error,
    },
}

impl LiveError {
    /// What to do about it, where there is something to say.
    pub fn hint(&self) -> Option<&str> {
        match self {
            Self::File { hint, .. } => hint.as_deref(),
            Self::Address { error, .. } if error.kind() == io::ErrorKind::AddrInUse => {
                Some("another program has this port: leave out --port, and a free one is taken")
            }
            Self::Address { error, .. } if error.kind() == io::ErrorKind::PermissionDenied => {
                Some("ports below 1024 are the system's: leave out --port")
            }
            Self::Folder { .. } => Some("TMPDIR names the folder for temporary files"),
            _ => None,
        }
    }
}

impl fmt::Display for LiveError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::File { message, .. } => f.write_str(message),
            Self::Address { address, error } => write!(f, "cannot listen on {address}: {error}"),
            Self::Folder { error } => write!(f, "cannot make a folder for dropped files: {error}"),
            Self::Random => f.write_str("the system gives no random numbers for the token"),
            Self::Start { error } => write!(f, "cannot start the server: {error}"),
        }
    }
}

impl Error for LiveError {}
