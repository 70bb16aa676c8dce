//! Rows in packed form: a row takes memory only for the data that it has.

use std::collections::BTreeMap;

use polhode::math::{Part, Position, Rotation};

use crate::growth::{Growth, GrowthTable};
use crate::row::{CopyErrors, GivenPart, Place, Quantity, Row, Subtotal};
use crate::tank::UncertainLiquid;
use crate::tensor::{GivenTensor, ProductSign, TensorPoint};
use crate::uncertainty::{PartUncertainty, Spread, Uncertainty};

/// Rows of a parts list in packed form.
///
/// A [`Row`] takes about 600 bytes. A packed row takes 32 bytes, its texts, and 8 bytes for each of
/// its numbers.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Rows {
    records: Vec<Record>,
    /// Texts of each row: the name, then those of [`TEXTS`] in that order. Each follows its length.
    texts: Vec<u8>,
    /// Numbers of each row in the order of [`SIZES`].
    numbers: Vec<f64>,
    /// Rotations that are not the identity.
    rotations: Vec<Rotation<Part, Part>>,
    /// Liquids of uncertain amount or density, by row index.
    liquids: BTreeMap<usize, UncertainLiquid>,
    /// Index of the row that is the parent of all rows that do not name one.
    enclosing: Option<usize>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Record {
    /// Start indices of the row's data in the arrays of [`Rows`].
    text: usize,
    number: usize,
    rotation: usize,
    count: u32,
    /// Bit set of the data that the row has.
    has: u32,
}

// Bits for groups of numbers. `SIZES` has the count of numbers for each bit.
const POSITION: u32 = 1;
const PART: u32 = 1 << 1;
const TENSOR: u32 = 1 << 2;
const ABOUT_POINT: u32 = 1 << 3;
const MASS_SD: u32 = 1 << 4;
const CENTER_SD: u32 = 1 << 5;
const CENTER_COVARIANCE: u32 = 1 << 6;
const TENSOR_SD: u32 = 1 << 7;
const TENSOR_COVARIANCE: u32 = 1 << 8;
const JOINT: u32 = 1 << 9;
const POSITION_SD: u32 = 1 << 10;
const POSITION_COVARIANCE: u32 = 1 << 11;
const ROTATION_SD: u32 = 1 << 12;
const ROTATION_COVARIANCE: u32 = 1 << 13;
const FRACTION: u32 = 1 << 14;
const SUBTOTAL: u32 = 1 << 15;
const ALLOWABLE: u32 = 1 << 16;
/// Count of numbers for each of the bits above.
const SIZES: [usize; 17] = [3, 4, 6, 3, 1, 3, 9, 6, 36, 100, 3, 9, 3, 9, 1, 2, 1];

// Bits for texts.
const PARENT: u32 = 1 << 17;
const GROUP: u32 = 1 << 18;
const CODE: u32 = 1 << 19;
const ABOUT_FRAME: u32 = 1 << 20;
/// Order of the texts after the name, which every row has.
const TEXTS: [u32; 4] = [PARENT, GROUP, CODE, ABOUT_FRAME];

const ROTATED: u32 = 1 << 21;
const INDEPENDENT: u32 = 1 << 22;
const INTEGRALS: u32 = 1 << 23;
/// Bit of rows whose tensor does not scale with the mass.
const APART: u32 = 1 << 24;
const LIQUID: u32 = 1 << 25;

impl Rows {
    /// Returns the number of rows.
    pub const fn len(&self) -> usize {
        self.records.len()
    }

    /// Returns true if the list has no rows.
    pub const fn is_empty(&self) -> bool {
        self.records.is_empty()
    }

    /// Appends a row at the end.
    pub fn push(&mut self, row: Row) {
        let Row { name, parent, quantity, place, part, uncertainty, group, growth, subtotal, allowable } =
            row;
        let (text, number) = (self.texts.len(), self.numbers.len());
        let mut has = 0;
        self.text(&name);
        let code = match &growth {
            Growth::Code(code) => Some(code),
            Growth::None | Growth::Fraction(_) => None,
        };
        let about = part.as_ref().map(|part| &part.tensor.about);
        let frame = about.and_then(|about| match about {
            TensorPoint::OriginOf(frame) => Some(frame),
            TensorPoint::CenterOfMass | TensorPoint::At(_) => None,
        });
        for (bit, text) in TEXTS.into_iter().zip([parent.as_ref(), group.as_ref(), code, frame]) {
            if let Some(text) = text {
                has |= bit;
                self.text(text);
            }
        }
        let mut put = |bit: u32, values: &[f64]| {
            has |= bit;
            self.numbers.extend_from_slice(values);
        };
        // Only +0.0 counts as zero, so −0.0 is stored.
        let is_zero = |values: &[f64]| values.iter().all(|value| value.to_bits() == 0);
        let position = place.position.to_array();
        if !is_zero(&position) {
            put(POSITION, &position);
        }
        if let Some(GivenPart { mass, center_of_mass, tensor }) = &part {
            let [x, y, z] = center_of_mass.to_array();
            put(PART, &[*mass, x, y, z]);
            let elements = [tensor.moments, tensor.products].concat();
            if !is_zero(&elements) {
                put(TENSOR, &elements);
            }
            if let TensorPoint::At(point) = tensor.about {
                put(ABOUT_POINT, &point.to_array());
            }
            if tensor.sign == ProductSign::PositiveIntegral {
                put(INTEGRALS, &[]);
            }
        }
        match uncertainty.part {
            PartUncertainty::Separate { mass, tensor_follows_mass, center, tensor } => {
                if !is_zero(&[mass]) {
                    put(MASS_SD, &[mass]);
                }
                if !tensor_follows_mass {
                    put(APART, &[]);
                }
                spread(&mut put, [CENTER_SD, CENTER_COVARIANCE], &center);
                spread(&mut put, [TENSOR_SD, TENSOR_COVARIANCE], &tensor);
            }
            PartUncertainty::Joint(covariance) => put(JOINT, covariance.as_flattened()),
            PartUncertainty::Liquid(liquid) => {
                put(LIQUID, &[]);
                self.liquids.insert(self.records.len(), *liquid);
            }
        }
        spread(&mut put, [POSITION_SD, POSITION_COVARIANCE], &uncertainty.position);
        spread(&mut put, [ROTATION_SD, ROTATION_COVARIANCE], &uncertainty.rotation);
        if let Growth::Fraction(fraction) = growth {
            put(FRACTION, &[fraction]);
        }
        if let Some(Subtotal { mass, tolerance }) = subtotal {
            put(SUBTOTAL, &[mass, tolerance]);
        }
        if let Some(allowable) = allowable {
            put(ALLOWABLE, &[allowable]);
        }
        if quantity.errors == CopyErrors::Independent {
            put(INDEPENDENT, &[]);
        }
        let rotation = self.rotations.len();
        if place.rotation != Rotation::identity() {
            has |= ROTATED;
            self.rotations.push(place.rotation);
        }
        self.records.push(Record { text, number, rotation, count: quantity.count, has });
    }

    /// Appends a row that becomes the parent of all rows without a stated parent.
    pub fn enclose(&mut self, frame: Row) {
        self.enclosing = Some(self.len());
        self.push(frame);
    }

    /// Unpacks a row. Beyond the last row, returns an empty frame without a name.
    pub fn get(&self, row: usize) -> Row {
        Row {
            name: self.name(row).to_owned(),
            parent: self.text_of(row, PARENT).or_else(|| self.enclosing_of(row)).map(str::to_owned),
            quantity: self.quantity(row),
            place: self.place(row),
            part: self.part(row),
            uncertainty: self.uncertainty(row),
            group: self.group(row).map(str::to_owned),
            growth: match (self.text_of(row, CODE), self.numbers_of(row, FRACTION)) {
                (Some(code), _) => Growth::Code(code.to_owned()),
                (None, Some([fraction])) => Growth::Fraction(fraction),
                (None, None) => Growth::None,
            },
            subtotal: self.subtotal(row),
            allowable: self.allowable(row),
        }
    }

    /// Iterates over all rows in their order.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = Row> + '_ {
        (0..self.len()).map(|row| self.get(row))
    }

    /// Returns the name of a row, empty beyond the last row.
    pub fn name(&self, row: usize) -> &str {
        let start = self.records.get(row).map_or(self.texts.len(), |record| record.text);
        self.text_at(start).0
    }

    /// Returns the index of the first row with this name.
    pub fn position(&self, name: &str) -> Option<usize> {
        (0..self.len()).find(|&row| self.name(row) == name)
    }

    /// Returns the name of a row's parent, or `None` for the root.
    pub(crate) fn frame_of(&self, row: usize) -> Option<&str> {
        let path = || self.name(row).rsplit_once('/').map(|(path, _)| path);
        self.text_of(row, PARENT).or_else(path).or_else(|| self.enclosing_of(row))
    }

    fn enclosing_of(&self, row: usize) -> Option<&str> {
        let enclosing = self.enclosing.filter(|enclosing| *enclosing != row)?;
        (!self.name(row).contains('/')).then(|| self.name(enclosing))
    }

    /// Returns the number of copies of a row.
    pub fn quantity(&self, row: usize) -> Quantity {
        let Some(record) = self.records.get(row) else { return Quantity::ONE };
        let is_independent = record.has & INDEPENDENT != 0;
        let errors = if is_independent { CopyErrors::Independent } else { CopyErrors::Alike };
        Quantity { count: record.count, errors }
    }

    /// Returns the place of a row's frame in its parent's frame.
    pub fn place(&self, row: usize) -> Place {
        let position = self.numbers_of(row, POSITION).map_or(Position::ZERO, Position::from_array);
        let record = self.records.get(row).filter(|record| record.has & ROTATED != 0);
        let rotation = record.and_then(|record| self.rotations.get(record.rotation));
        Place { position, rotation: rotation.copied().unwrap_or_else(Rotation::identity) }
    }

    /// Returns the part of a row as given.
    pub fn part(&self, row: usize) -> Option<GivenPart> {
        let [mass, x, y, z] = self.numbers_of(row, PART)?;
        let [xx, yy, zz, xy, xz, yz] = self.numbers_of(row, TENSOR).unwrap_or_default();
        let about = match (self.numbers_of(row, ABOUT_POINT), self.text_of(row, ABOUT_FRAME)) {
            (Some(point), _) => TensorPoint::At(Position::from_array(point)),
            (None, Some(frame)) => TensorPoint::OriginOf(frame.to_owned()),
            (None, None) => TensorPoint::CenterOfMass,
        };
        let tensor =
            GivenTensor { moments: [xx, yy, zz], products: [xy, xz, yz], sign: self.sign(row), about };
        Some(GivenPart { mass, center_of_mass: Position::new(x, y, z), tensor })
    }

    /// Returns the mass of one copy of a row's part as given, kg.
    pub fn mass(&self, row: usize) -> Option<f64> {
        self.numbers_of(row, PART).map(|[mass, ..]: [f64; 4]| mass)
    }

    /// Returns true if a row has a part.
    pub fn has_part(&self, row: usize) -> bool {
        self.has(row, PART)
    }

    /// Returns the name of the row whose origin a row's tensor is about.
    pub fn tensor_frame(&self, row: usize) -> Option<&str> {
        self.text_of(row, ABOUT_FRAME)
    }

    /// Returns the sign convention of a row's products of inertia.
    pub(crate) fn sign(&self, row: usize) -> ProductSign {
        if self.has(row, INTEGRALS) { ProductSign::PositiveIntegral } else { ProductSign::NegativeIntegral }
    }

    /// Returns the errors of a row.
    pub fn uncertainty(&self, row: usize) -> Uncertainty {
        let part = match (self.numbers_of::<100>(row, JOINT), self.liquid(row)) {
            (Some(joint), _) => PartUncertainty::Joint(Box::new(matrix(joint))),
            (None, Some(liquid)) => PartUncertainty::Liquid(Box::new(liquid.clone())),
            (None, None) => PartUncertainty::Separate {
                mass: self.numbers_of(row, MASS_SD).map_or(0.0, |[sd]| sd),
                tensor_follows_mass: !self.has(row, APART),
                center: self.spread_of::<3, 9>(row, [CENTER_SD, CENTER_COVARIANCE]),
                tensor: self.spread_of::<6, 36>(row, [TENSOR_SD, TENSOR_COVARIANCE]),
            },
        };
        Uncertainty {
            part,
            position: self.spread_of::<3, 9>(row, [POSITION_SD, POSITION_COVARIANCE]),
            rotation: self.spread_of::<3, 9>(row, [ROTATION_SD, ROTATION_COVARIANCE]),
        }
    }

    /// Returns true if all numbers of a row are exact.
    pub fn is_exact(&self, row: usize) -> bool {
        // All bits from `MASS_SD` to `ROTATION_COVARIANCE`.
        const ERRORS: u32 = (FRACTION - MASS_SD) | APART | LIQUID;
        !self.has(row, ERRORS)
    }

    /// Returns the liquid of which a row's part consists, with its errors.
    pub(crate) fn liquid(&self, row: usize) -> Option<&UncertainLiquid> {
        self.liquids.get(&row).filter(|_| self.has(row, LIQUID))
    }

    /// Returns true if a row's tensor scales with its mass.
    pub(crate) fn tensor_follows_mass(&self, row: usize) -> bool {
        !self.has(row, APART | JOINT | LIQUID)
    }

    /// Returns the name of a row's group.
    pub fn group(&self, row: usize) -> Option<&str> {
        self.text_of(row, GROUP)
    }

    /// Returns true if a row states a growth allowance.
    pub fn grows(&self, row: usize) -> bool {
        self.has(row, CODE | FRACTION)
    }

    /// Returns the growth allowance of a row as a fraction. If the table lacks the row's maturity
    /// code, that code is the error.
    pub(crate) fn allowance(&self, row: usize, table: &GrowthTable) -> Result<f64, &str> {
        if let Some([fraction]) = self.numbers_of(row, FRACTION) {
            return Ok(fraction);
        }
        self.text_of(row, CODE).map_or(Ok(0.0), |code| table.get(code).ok_or(code))
    }

    /// Returns the mass that the list states for a row with its descendants.
    pub fn subtotal(&self, row: usize) -> Option<Subtotal> {
        self.numbers_of(row, SUBTOTAL).map(|[mass, tolerance]| Subtotal { mass, tolerance })
    }

    /// Returns the allowable mass of a row with its descendants, kg.
    pub fn allowable(&self, row: usize) -> Option<f64> {
        self.numbers_of(row, ALLOWABLE).map(|[allowable]| allowable)
    }

    fn has(&self, row: usize, bits: u32) -> bool {
        self.records.get(row).is_some_and(|record| record.has & bits != 0)
    }

    fn numbers_of<const N: usize>(&self, row: usize, bit: u32) -> Option<[f64; N]> {
        let record = self.records.get(row).filter(|record| record.has & bit != 0)?;
        let mut before = record.has & (bit - 1);
        let mut start = record.number;
        while before != 0 {
            start += SIZES[before.trailing_zeros() as usize];
            before &= before - 1;
        }
        self.numbers.get(start..)?.first_chunk().copied()
    }

    fn spread_of<const N: usize, const M: usize>(&self, row: usize, [sd, full]: [u32; 2]) -> Spread<N> {
        if let Some(deviations) = self.numbers_of(row, sd) {
            return Spread::Deviations(deviations);
        }
        let covariance = self.numbers_of::<M>(row, full);
        covariance.map_or(Spread::Exact, |covariance| Spread::Covariance(Box::new(matrix(covariance))))
    }

    fn text(&mut self, text: &str) {
        // The length in LEB128 encoding.
        let mut length = text.len();
        while length >= 0x80 {
            self.texts.push(length as u8 | 0x80);
            length >>= 7;
        }
        self.texts.push(length as u8);
        self.texts.extend_from_slice(text.as_bytes());
    }

    /// Returns a text and the start of the next one.
    fn text_at(&self, mut at: usize) -> (&str, usize) {
        let (mut length, mut shift) = (0, 0);
        while let Some(&byte) = self.texts.get(at) {
            at += 1;
            length |= usize::from(byte & 0x7f) << shift;
            shift += 7;
            if byte < 0x80 {
                break;
            }
        }
        let bytes = self.texts.get(at..at + length).unwrap_or_default();
        (str::from_utf8(bytes).unwrap_or_default(), at + length)
    }

    fn text_of(&self, row: usize, bit: u32) -> Option<&str> {
        let record = self.records.get(row).filter(|record| record.has & bit != 0)?;
        let mut at = self.text_at(record.text).1;
        for before in TEXTS.into_iter().take_while(|before| *before != bit) {
            if record.has & before != 0 {
                at = self.text_at(at).1;
            }
        }
        Some(self.text_at(at).0)
    }
}

impl FromIterator<Row> for Rows {
    fn from_iter<T: IntoIterator<Item = Row>>(rows: T) -> Self {
        let mut all = Self::default();
        rows.into_iter().for_each(|row| all.push(row));
        all
    }
}

fn spread<const N: usize>(put: &mut impl FnMut(u32, &[f64]), [sd, full]: [u32; 2], spread: &Spread<N>) {
    match spread {
        Spread::Exact => {}
        Spread::Deviations(deviations) => put(sd, deviations),
        Spread::Covariance(covariance) => put(full, covariance.as_flattened()),
    }
}

/// Returns the N × N matrix of these elements, in row-major order.
fn matrix<const N: usize, const M: usize>(elements: [f64; M]) -> [[f64; N]; N] {
    core::array::from_fn(|i| core::array::from_fn(|j| elements[N * i + j]))
}
