//! Inertia tensor of a row, its reference point, and the sign of its products.

use polhode::body::{BodyError, InertiaAbout, InertiaTensor, MassProperties};
use polhode::math::{Part, Position};
use polhode_source::unit;
use polhode_source::unit::Dimension;
use polhode_source::{ContentError, ContentErrorKind};
use polhode_source::{FormatError, FormatErrorKind};

use super::cell::{Cell, Content};
use super::cells::{Cells, Given};
use super::key::{ABOUT, KEYS, MASS, PRODUCTS};
use super::part::{CENTER, MOMENTS, PRODUCTS as ELEMENTS};
use super::plan::point_named;
use super::rows::Rows;
use crate::{GivenTensor, ProductSign, TensorPoint};

impl<'s, 'a> Rows<'s, 'a> {
    /// Reads the tensor of a part with this mass and centre of mass; `None` if no column gives one.
    pub(crate) fn tensor(
        &mut self,
        cells: &Cells<'_, 'a>,
        mass: f64,
        center: [f64; 3],
    ) -> Result<Option<GivenTensor>, FormatError> {
        let moments = self.reader.all_or_none(cells, MOMENTS)?;
        let products = self.reader.all_or_none(cells, ELEMENTS)?;
        let (Some(moments), Some(first)) = (moments, cells.any(MOMENTS)) else {
            if let Some(cell) = cells.any(ELEMENTS.into_iter().chain(MOMENTS)) {
                return Err(self.reader.invalid(cell, "given with Ixx, Iyy and Izz"));
            }
            return Ok(None);
        };
        let value = |given: Option<Given<'_, '_>>| given.map_or(0.0, |given| given.value);
        if let Some(missing) = MOMENTS.iter().find(|key| self.reader.columns.places[**key].is_none()) {
            let rule = format!("given with a column {}", KEYS[*missing].name);
            return Err(self.reader.invalid(first, rule));
        }
        self.taken.without_products += usize::from(products.is_none());
        let moments = moments.map(value);
        let products = products.map_or([0.0; 3], |products| products.map(value));
        let about = self.about(cells, first, center)?;
        let sign = self.sign(cells, mass, center, moments, products, &about)?;
        Ok(Some(GivenTensor { moments, products, sign, about }))
    }

    /// Returns the reference point of a tensor.
    fn about(
        &mut self,
        cells: &Cells<'_, 'a>,
        tensor: &Cell<'a>,
        center: [f64; 3],
    ) -> Result<TensorPoint, FormatError> {
        match (cells.cell(ABOUT), &self.plan.about) {
            (Some(cell), _) => self.named_point(cell),
            (None, Some(about)) => Ok(about.clone()),
            // Both choices are the same point.
            (None, None) if center == [0.0; 3] => Ok(TensorPoint::CenterOfMass),
            (None, None) => {
                let question = "is the tensor about the part's centre of mass or about another point?";
                let hint = format!(
                    "write {}, or about = \"origin\"; or add a column about",
                    self.reader.sheet.as_key("about = \"center\"")
                );
                Err(self.unclear(tensor, question).with_hint(hint))
            }
        }
    }

    /// Reads `center`, `origin`, the name of a frame, or three lengths: `10 mm, 0, 0`.
    fn named_point(&self, cell: &Cell<'a>) -> Result<TensorPoint, FormatError> {
        let label = self.reader.label_of(cell)?;
        let inside = label.trim_matches(['[', ']', '(', ')']);
        let begins = ['-', '+', '.', '\u{2212}'];
        let is_point = inside.starts_with(begins) || inside.starts_with(|c: char| c.is_ascii_digit());
        let comma = self.reader.sheet.decimal_comma && cell.content == Content::Text;
        let marks: &[char] = if comma { &[';'] } else { &[',', ';'] };
        let pieces: Vec<&str> = inside.split(marks).map(str::trim).collect();
        if !is_point || pieces.len() != 3 {
            return Ok(point_named(&label));
        }
        let pointed: Vec<String> = pieces
            .iter()
            .map(|piece| if comma { piece.replace(',', ".") } else { (*piece).to_owned() })
            .collect();
        let pieces: Vec<&str> = pointed.iter().map(String::as_str).collect();
        if unit::bare_beside_units(pieces.iter().copied()).is_some() {
            return Err(self.reader.invalid(cell, "three lengths, each with its unit"));
        }
        let mut point = [0.0; 3];
        for (slot, piece) in point.iter_mut().zip(pieces) {
            let read = unit::parse(piece, Dimension::LENGTH);
            *slot = read.map_err(|error| self.reader.sheet.error(cell, FormatErrorKind::Unit(error)))?;
        }
        Ok(TensorPoint::At(Position::from_array(point)))
    }

    /// Returns the sign convention of the products of a row: that of the row, that of the file, or
    /// the only one that makes a possible body.
    fn sign(
        &mut self,
        cells: &Cells<'_, 'a>,
        mass: f64,
        center: [f64; 3],
        moments: [f64; 3],
        products: [f64; 3],
        about: &TensorPoint,
    ) -> Result<ProductSign, FormatError> {
        if let Some(cell) = cells.cell(PRODUCTS) {
            let names = ProductSign::NAMED.map(|(name, _)| name);
            let text = self.reader.whole(cell)?;
            let sign = ProductSign::NAMED.iter().find(|(name, _)| *name == text).map(|(_, sign)| *sign);
            return sign.ok_or_else(|| {
                let error = self.reader.invalid(cell, format!("one of {}", names.join(", ")));
                let hint = "a positive integral is +∫xy dm; the element of the tensor is −∫xy dm";
                error.with_hint(hint).suggesting(text, names)
            });
        }
        let Some(cell) = ELEMENTS.iter().find_map(|key| cells.cell(*key)).filter(|_| products != [0.0; 3])
        else {
            return Ok(ProductSign::NegativeIntegral);
        };
        if let Some(sign) = self.plan.products {
            return Ok(sign);
        }
        let rounding = self.rounding(cells, mass, center, about)?;
        let is_possible = |sign: f64, added: f64| {
            let [xx, yy, zz] = moments.map(|moment| moment + added);
            let [xy, xz, yz] = products.map(|product| sign * product);
            possible(mass, center, [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]], about)
        };
        let answers = |added| (is_possible(1.0, added), is_possible(-1.0, added));
        match (answers(0.0), answers(rounding)) {
            ((Some(Ok(())), _), (_, Some(Err(_)))) => {
                self.taken.proved_elements += 1;
                Ok(ProductSign::NegativeIntegral)
            }
            ((_, Some(Ok(()))), (Some(Err(_)), _)) => {
                self.taken.proved_integrals += 1;
                Ok(ProductSign::PositiveIntegral)
            }
            ((Some(Err(_)), Some(Err(error))), _) => {
                let error = self.reader.sheet.error(cell, FormatErrorKind::Body(error));
                Err(error.with_hint("the tensor is unphysical with either sign of the products: check its reference point and its unit"))
            }
            _ => {
                let question = "are the products of inertia elements of the tensor, −∫xy dm, or positive integrals, +∫xy dm?";
                let hint = format!(
                    "write {}, or products = \"positive integrals\"; or add a column products: both give a physical body",
                    self.reader.sheet.as_key("products = \"tensor elements\"")
                );
                Err(self.unclear(cell, question).with_hint(hint))
            }
        }
    }

    /// Returns the largest amount by which rounding may reduce the moments. With it added, a
    /// possible body stays possible, however its numbers were rounded.
    fn rounding(
        &self,
        cells: &Cells<'_, 'a>,
        mass: f64,
        center: [f64; 3],
        about: &TensorPoint,
    ) -> Result<f64, FormatError> {
        let largest = |keys: &[usize]| -> Result<f64, FormatError> {
            let cells = keys.iter().filter_map(|key| cells.cell(*key));
            let halves: Vec<f64> =
                cells.map(|cell| self.reader.half_digit(cell)).collect::<Result<_, _>>()?;
            Ok(halves.into_iter().fold(0.0, f64::max))
        };
        let of_elements = largest(&MOMENTS)?.max(largest(&ELEMENTS)?);
        let TensorPoint::At(point) = about else { return Ok(6.0 * of_elements) };
        let arm = (Position::<Part>::from_array(center) - *point).norm();
        let of_center = largest(&CENTER)?;
        Ok(6.0 * of_elements
            + 2.0 * largest(&[MASS])? * arm * arm
            + 8.0 * mass * (arm + of_center) * of_center)
    }

    fn unclear(&self, cell: &Cell<'a>, question: &str) -> FormatError {
        let heading = self.reader.heading(cell);
        let found = format!("{heading} = {}", polhode_source::text::cut(&cell.text));
        let kind = ContentErrorKind::Unclear { question: question.to_owned(), found };
        self.reader.sheet.error(cell, ContentError::of_file(kind).into())
    }
}

/// Checks that a body with this tensor is possible. Returns `None` if the reference point is not
/// known here.
fn possible(
    mass: f64,
    center: [f64; 3],
    rows: [[f64; 3]; 3],
    about: &TensorPoint,
) -> Option<Result<(), BodyError>> {
    let center: Position<Part> = Position::from_array(center);
    let properties = match about {
        TensorPoint::OriginOf(_) => return None,
        TensorPoint::CenterOfMass => {
            InertiaTensor::from_matrix(rows).and_then(|tensor| MassProperties::new(mass, center, tensor))
        }
        TensorPoint::At(point) => InertiaAbout::from_matrix(*point, rows)
            .and_then(|about| MassProperties::from_inertia_about(mass, center, &about)),
    };
    Some(properties.map(|_| ()))
}
