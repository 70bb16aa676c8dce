//! `polhode live`: the interactive page of a rigid body and its motion, with the files that it
//! shows, on this machine only.
//!
//! The page computes everything itself: it contains [`polhode_web::Engine`] as WebAssembly. The
//! server answers two requests: the page, and the [pack](page()) of the files. The page requests the
//! pack again and again, and shows files as they are now. [`page()`] writes both as one file.
//!
//! **Access.** The server listens only on the loopback address. Every path begins with a token of
//! 128 random bits. A request with a foreign `Host` or `Origin` is refused, to prevent DNS
//! rebinding by other sites. Headers and connections have limits of size, time and number. Nothing
//! is written to disk.
//!
//! ```no_run
//! use polhode_live::{Live, LiveOptions};
//! let live = Live::bind(&LiveOptions { files: vec!["examples/t-handle.toml".into()], ..LiveOptions::default() })?;
//! println!("{}", live.address());
//! live.run(); // until Ctrl-C
//! # Ok::<(), polhode_live::LiveError>(())
//! ```
#![forbid(unsafe_code)]

mod answer;
mod connections;
mod error;
mod gather;
mod guard;
mod head;
mod limits;
mod options;
mod pack;
mod page;
mod server;
mod source;
mod within;

pub use error::LiveError;
pub use options::LiveOptions;
pub use page::page;
pub use polhode_web::{LessonError, LessonInfo, lessons};
pub use server::Live;
