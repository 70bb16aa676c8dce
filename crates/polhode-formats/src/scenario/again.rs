//! Reading a scenario again, with some of its numbers changed.
//!
//! The first reading leaves behind what it found: every number with its dimension and its place, every rotation, every part of
//! the body, and what it took from other files. Later readings take numbers that have changed from elsewhere, leave parts in which
//! nothing has changed as they are, and open no file.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::ops::Range;
use std::path::PathBuf;
use std::sync::Arc;

use polhode::body::mesh::ClosedMesh;
use polhode::body::{BodyPart, Finding, MassProperties};
use polhode::math::Body;

use super::motion_table::Rows;
use crate::molecule::Molecule;
use crate::unit::Dimension;

/// Which reading of a text it is.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Reading<'a> {
    /// The only one.
    Once,
    /// The first of many.
    First(&'a RefCell<Found>),
    /// One of many.
    Again(&'a Found, &'a Changes),
}

/// What the first reading of a scenario found. Places are the first bytes of values in the text.
#[derive(Clone, Debug, Default)]
pub(crate) struct Found {
    pub(crate) numbers: BTreeMap<usize, Number>,
    /// Quaternions (w, x, y, z).
    pub(crate) rotations: BTreeMap<usize, [f64; 4]>,
    /// Without their looks, which no motion depends on.
    pub(crate) parts: Vec<(BodyPart, Vec<Finding>)>,
    /// All parts together.
    pub(crate) body: Option<MassProperties<Body>>,
    /// By the place of the value that names the file.
    pub(crate) meshes: BTreeMap<usize, (Arc<ClosedMesh>, Vec<Finding>)>,
    pub(crate) molecules: BTreeMap<usize, Arc<Molecule>>,
    pub(crate) rows: BTreeMap<usize, Arc<Rows>>,
    /// All files that were read.
    pub(crate) files: Vec<PathBuf>,
}

/// A number as it was read.
#[derive(Clone, Debug)]
pub(crate) struct Number {
    pub(crate) span: Range<usize>,
    /// SI.
    pub(crate) value: f64,
    pub(crate) dimension: Dimension,
}

/// What differs in a later reading.
#[derive(Clone, Debug, Default)]
pub(crate) struct Changes {
    /// Where numbers stand, and what they are instead, SI.
    pub(crate) numbers: Vec<(Range<usize>, f64)>,
    /// Where rotations stand, and their quaternions (w, x, y, z) instead.
    pub(crate) rotations: Vec<(usize, [f64; 4])>,
    /// Parts of the body, from 0, in which something differs.
    pub(crate) parts: Vec<usize>,
    /// Parts of the body, from 0, and their mass properties instead.
    pub(crate) part_properties: Vec<(usize, MassProperties<Body>)>,
    /// The whole body's mass properties instead.
    pub(crate) body: Option<MassProperties<Body>>,
}

impl<'a> Reading<'a> {
    /// The number that stands at `place` now, if it is known without reading it.
    pub(crate) fn number(self, place: usize, dimension: Dimension) -> Option<f64> {
        let Self::Again(found, changes) = self else { return None };
        let changed = changes.numbers.iter().find(|(span, _)| span.start == place);
        // What is tried in one dimension after the other is read anew in all but the last.
        let written = || found.numbers.get(&place).filter(|number| number.dimension == dimension);
        changed.map(|(_, value)| *value).or_else(|| written().map(|number| number.value))
    }

    /// The rotation that stands at `place` now.
    pub(crate) fn rotation(self, place: usize) -> Option<[f64; 4]> {
        let changes = self.changes()?;
        changes.rotations.iter().find(|(at, _)| *at == place).map(|(_, quaternion)| *quaternion)
    }

    /// What differs from the first reading.
    pub(crate) fn changes(self) -> Option<&'a Changes> {
        match self {
            Self::Again(_, changes) => Some(changes),
            _ => None,
        }
    }

    /// What the first reading found; only a later one knows.
    pub(crate) fn found(self) -> Option<&'a Found> {
        match self {
            Self::Again(found, _) => Some(found),
            _ => None,
        }
    }

    /// Leaves something for later readings.
    pub(crate) fn leave<R>(self, note: impl FnOnce(&mut Found) -> R) {
        if let Self::First(found) = self
            && let Ok(mut found) = found.try_borrow_mut()
        {
            note(&mut found);
        }
    }

    /// What an earlier reading kept, or is made now and kept for later ones.
    pub(crate) fn kept<T, E>(
        self,
        place: usize,
        shelf: impl Fn(&Found) -> &BTreeMap<usize, T>,
        shelf_mut: impl Fn(&mut Found) -> &mut BTreeMap<usize, T>,
        make: impl FnOnce() -> Result<T, E>,
    ) -> Result<T, E>
    where
        T: Clone,
    {
        if let Some(kept) = self.found().and_then(|found| shelf(found).get(&place)) {
            return Ok(kept.clone());
        }
        let made = make()?;
        self.leave(|found| shelf_mut(found).insert(place, made.clone()));
        Ok(made)
    }
}
