//! Names of parts. Every line counts, but two equal lines are refused.

use std::collections::{HashMap, HashSet};
use std::ops::Range;

use polhode::body::Finding;
use polhode_source::text::{cut, escaped};
use polhode_source::{ContentError, ContentPlace};

use super::fields::text_of;
use super::value;
use crate::finding::info;

/// Positions of each name so far.
#[derive(Default)]
pub(crate) struct Names {
    places: HashMap<String, HashSet<[u64; 3]>>,
}

impl Names {
    /// Adds a part. A second part with the same name and position is refused.
    pub(crate) fn add(
        &mut self,
        bytes: &[u8],
        name: &Range<usize>,
        place: [f64; 3],
    ) -> Result<(), ContentError> {
        if name.is_empty() {
            return Ok(());
        }
        let places = self.places.entry(text_of(bytes, name)).or_default();
        // Adding 0 turns −0 into 0.
        if !places.insert(place.map(|c| (c + 0.0).to_bits())) {
            let rule = "on one line only: another part of this name is at the same position".to_owned();
            let error = value("the part", text_of(bytes, name), rule, ContentPlace::Text(name.clone()));
            return Err(error.hint("delete one of the two lines, or give the parts different names"));
        }
        Ok(())
    }

    /// Returns a finding if names occur in several lines.
    pub(crate) fn finding(&self) -> Option<Finding> {
        let repeated = self.places.iter().filter(|(_, places)| places.len() > 1);
        let mut repeated: Vec<_> = repeated.map(|(name, places)| (name, places.len())).collect();
        repeated.sort();
        let (name, lines) = repeated.first()?;
        let others = match repeated.len() - 1 {
            0 => String::new(),
            1 => ", and so does 1 other name".to_owned(),
            more => format!(", and so do {more} other names"),
        };
        let message = format!(
            "{:?} is on {lines} lines{others}: each line counts as a separate part",
            cut(&escaped(name))
        );
        Some(info("particles.repeated-names", message))
    }
}
