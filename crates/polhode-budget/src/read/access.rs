//! The files that a parts list may open.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use polhode_source::Confinement;

use super::plan::Plan;

/// The files that a parts list may open: it is data, and opens none outside its folder and the roots.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Access<'a> {
    /// True if it may open none at all: its source is not trusted.
    is_alone: bool,
    roots: &'a [PathBuf],
}

impl<'a> Access<'a> {
    /// No other file.
    pub(crate) const ALONE: Self = Self { is_alone: true, roots: &[] };

    /// Files in the list's own folder, and in these.
    pub(crate) const fn within(roots: &'a [PathBuf]) -> Self {
        Self { is_alone: false, roots }
    }

    /// The only files that may be named; `None` where the folder decides.
    pub(crate) fn files(self) -> Option<&'static BTreeSet<PathBuf>> {
        static NOTHING: BTreeSet<PathBuf> = BTreeSet::new();
        self.is_alone.then_some(&NOTHING)
    }

    /// The folders of the files that a parts list may name.
    pub(crate) fn folders(self, list: &Path) -> Confinement {
        Confinement::of(list, self.roots)
    }

    /// A plan under which parts have this access.
    pub(crate) fn plan(self, plan: Plan) -> Plan {
        Plan { is_alone: self.is_alone, roots: self.roots.to_vec(), ..plan }
    }
}
