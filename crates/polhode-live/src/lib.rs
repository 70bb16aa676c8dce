//! `polhode live`: an interactive page for a rigid body and its motion, served on this machine
//! only.
//!
//! The text of the scenario is the only state. Each change on the page, such as a knob or a throw,
//! is an edit of the text. The answer contains the new text, the motion, and the knobs:
//! [`polhode_web::Engine`] computes it. The server keeps the files that were opened or dropped, but
//! no motions.
//!
//! **Access.** The server listens only on the loopback address. Every path begins with a token of
//! 128 random bits. A request with a foreign `Host` or `Origin` is refused, to prevent DNS
//! rebinding by other sites. A text may refer only to files that it was opened with or that were
//! dropped with it. Headers, bodies, connections and computations have limits of size and time. An
//! integration or the diagnosis of a mesh stops when nobody waits for it. The content security
//! policy ensures that the page loads nothing from elsewhere.
//!
//! ```no_run
//! use polhode_live::{Live, LiveOptions};
//! let live = Live::bind(&LiveOptions { files: vec!["examples/t-handle.toml".into()], ..LiveOptions::default() })?;
//! println!("{}", live.address());
//! live.run()?; // until Ctrl-C
//! # Ok::<(), polhode_live::LiveError>(())
//! ```
#![forbid(unsafe_code)]

mod answer;
mod asset;
mod connections;
mod dropped;
mod error;
mod guard;
mod limits;
mod route;
mod server;
mod session;
mod turns;
mod watch;

pub use error::LiveError;
pub use polhode_web::{LessonError, LessonInfo, lessons};
pub use server::{Live, LiveOptions};
