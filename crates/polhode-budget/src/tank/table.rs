//! Tank described by a table of the mass properties of its contents.

use polhode::body::MassProperties;
use polhode::math::Part;

use super::{Fill, Slice};
use crate::sequence_error::SequenceError;
use crate::tensor::{elements, plus, scaled, steiner};

/// Mass properties of the liquid in a tank at some masses.
///
/// Mass, first moments and second moments are linear between rows. Every body between two rows is a
/// mixture of two possible bodies, and therefore possible. Below the first row, the liquid is the
/// first row at a lower density. The interpolation error of a moment is ⅛ of its second derivative
/// times the square of the step in mass.
#[derive(Clone, Debug, PartialEq)]
pub struct LiquidTable {
    rows: Vec<MassProperties<Part>>,
    levels: Option<Vec<f64>>,
}

impl LiquidTable {
    /// Makes a table from mass properties with ascending masses. The levels of the liquid, m, are
    /// optional and must ascend too.
    ///
    /// # Errors
    /// [`SequenceError::Value`] if masses or levels do not ascend; [`SequenceError::EmptyTable`]
    /// without rows, or if the number of levels differs from that of rows.
    pub fn new(rows: Vec<MassProperties<Part>>, levels: Option<Vec<f64>>) -> Result<Self, SequenceError> {
        let rule = "greater than in the row before";
        let ascends = |what, values: &[f64]| {
            let wrong = values.windows(2).find(|pair| !(pair[1] > pair[0])).map(|pair| pair[1]);
            wrong.map_or(Ok(()), |value| Err(SequenceError::Value { what, value, rule }))
        };
        if rows.is_empty() || levels.as_ref().is_some_and(|levels| levels.len() != rows.len()) {
            return Err(SequenceError::EmptyTable);
        }
        ascends("the mass of a liquid", &rows.iter().map(MassProperties::mass).collect::<Vec<_>>())?;
        ascends("the level of a liquid", levels.as_deref().unwrap_or_default())?;
        Ok(Self { rows, levels })
    }

    /// Returns the mass properties of all rows.
    pub fn rows(&self) -> &[MassProperties<Part>] {
        &self.rows
    }

    /// Returns the level of the liquid in each row, m, if known.
    pub fn levels(&self) -> Option<&[f64]> {
        self.levels.as_deref()
    }

    pub(super) fn capacity(&self) -> f64 {
        self.rows.last().map_or(0.0, MassProperties::mass)
    }

    pub(super) fn at(&self, mass: f64) -> Option<Fill> {
        let after = self.rows.partition_point(|row| row.mass() < mass).min(self.rows.len() - 1);
        let to = self.rows.get(after)?;
        let from = after.checked_sub(1).and_then(|before| self.rows.get(before));
        let next = slope(from, to);
        let level = self.level(mass, after);
        if mass == 0.0 {
            return Some(Fill { properties: None, level, next });
        }
        // A mixture of both rows, with weights 1 − b and b.
        let properties = match from {
            None => scaled(to, mass / to.mass()).ok(),
            Some(from) => {
                let b = (mass - from.mass()) / (to.mass() - from.mass());
                let parts = [(from, 1.0 - b), (to, b)].into_iter().filter(|(_, weight)| *weight > 0.0);
                let parts: Option<Vec<_>> = parts.map(|(row, weight)| scaled(row, weight).ok()).collect();
                MassProperties::combined(&parts?).ok()
            }
        };
        properties.map(|properties| Fill { properties: Some(properties), level, next })
    }

    fn level(&self, mass: f64, after: usize) -> Option<f64> {
        let levels = self.levels.as_ref()?;
        let [m1, h1] = [self.rows.get(after)?.mass(), *levels.get(after)?];
        let [m0, h0] = match after.checked_sub(1) {
            Some(before) => [self.rows.get(before)?.mass(), *levels.get(before)?],
            None => return (mass == m1).then_some(h1),
        };
        Some(h0 + (h1 - h0) * (mass - m0) / (m1 - m0))
    }
}

/// Returns the difference of two rows per kilogram.
fn slope(from: Option<&MassProperties<Part>>, to: &MassProperties<Part>) -> Slice {
    let own = |body: &MassProperties<Part>| elements(body.inertia().matrix());
    let c1 = to.center_of_mass().to_array();
    let Some(from) = from else {
        return Slice { center: c1, tensor: own(to).map(|x| x / to.mass()) };
    };
    let c0 = from.center_of_mass().to_array();
    let [m0, m1] = [from.mass(), to.mass()];
    let more = m1 - m0;
    let center: [f64; 3] = core::array::from_fn(|k| (m1 * c1[k] - m0 * c0[k]) / more);
    let about = |body, m, c: [f64; 3]| {
        let d = core::array::from_fn(|k| c[k] - center[k]);
        plus(own(body), steiner(d, d), m)
    };
    let tensor = plus(about(to, m1, c1), about(from, m0, c0), -1.0).map(|x| x / more);
    Slice { center, tensor }
}
