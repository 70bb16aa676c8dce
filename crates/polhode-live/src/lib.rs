//! `polhode live`: a page on which a rigid body and its motion can be changed, served on this machine's own address.
//!
//! The scenario's text is the only state. A change of the page, a knob or a throw, is an edit of the text; the answer has the new text,
//! the motion, and what can be turned in it. The server keeps the files that were opened or dropped, and no motion.
//!
//! **Closed to others.** It listens on the loopback address alone. Every path begins with a token of 128 random bits; a request whose `Host` or
//! `Origin` is another's is refused, as a page of another site would have it through DNS rebinding. A text may name the files that it was opened
//! with, or that were dropped beside it, and no others. Headers, bodies, connections and computations have limits of size and time; an integration,
//! or the diagnosis of a mesh, that nobody waits for any more is stopped. The page loads nothing from elsewhere, which its content security policy holds it to.
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
mod documents;
mod dropped;
mod edit;
mod error;
mod guard;
mod inspect;
mod kind;
mod knob;
mod lesson;
mod limits;
mod mesh;
mod motion;
mod opened;
mod part_names;
mod protocol;
mod route;
mod rows;
mod server;
mod session;
mod turns;
mod utf16;
mod watch;

pub use error::LiveError;
pub use knob::knobs;
pub use lesson::{LessonError, lessons};
pub use protocol::{Knob, LessonInfo};
pub use server::{Live, LiveOptions};
