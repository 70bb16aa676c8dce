//! Requests to `sweep`: the options of the command.
#![allow(rustdoc::broken_intra_doc_links, reason = "the help of the command shows brackets as they are")]

use std::num::NonZeroUsize;
use std::path::PathBuf;
use std::thread::available_parallelism;

use serde::{Deserialize, Serialize};

/// JSON schema of a [`Request`].
pub const REQUEST_SCHEMA: &str = include_str!("../schema/request.json");

/// Plan of many members, and the number of threads.
///
/// ```
/// use polhode_document::Report as _;
/// use polhode_source::files::Memory;
/// use polhode_sweep::{Request, run};
/// let plan = "[[body.part]]\nshape = \"box\"\nsize = [0.1, 0.2, 0.3]\nmass = 2\n\
///     [start]\nspin = { body = [0.1, 2, -0.3] }\n[run]\nduration = 60\n\
///     [sweep]\nsampling = \"grid\"\n[[sweep.vary]]\nkey = \"start.spin.body[1]\"\nlist = [1, 2, 3]\n";
/// let files = Memory::from([("plan.toml", plan)]);
/// let report = run(&Request { plan: "plan.toml".into(), ..Request::default() }, &files)?;
/// assert_eq!(report.to_json()["status"]["complete"]["count"], 3);
/// # Ok::<(), polhode_source::Failure>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields, rename_all = "kebab-case")]
#[cfg_attr(feature = "arguments", derive(clap::Args))]
pub struct Request {
    /// Plan: a TOML file with a [sweep] and a [run] section.
    pub plan: PathBuf,
    /// Number of threads [default: all processors].
    #[cfg_attr(feature = "arguments", arg(long, value_name = "N"))]
    pub threads: Option<NonZeroUsize>,
}

impl Request {
    /// Returns the number of threads: that of the machine, unless the user specifies one. Results
    /// do not depend on it.
    pub fn threads(&self) -> usize {
        self.threads.or_else(|| available_parallelism().ok()).map_or(1, NonZeroUsize::get)
    }
}
