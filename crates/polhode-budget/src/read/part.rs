//! Mass properties in a row.

use polhode::math::Position;
use polhode_source::FormatError;

use super::cells::{Cells, Given, MOST_DEVIATION};
use super::key::{
    CAD, DENSITY, ENDS, FILE, FILL, IXX, IXY, IXZ, IYY, IYZ, IZZ, MASS, MATERIAL, MESH, SCENARIO, SHAPE,
    SIZES, UNION, UNIT, WELD, X, Y, Z,
};
use super::place::spread;
use super::rows::Rows;
use crate::{GivenPart, GivenTensor, PartUncertainty};

pub(crate) const MOMENTS: [usize; 3] = [IXX, IYY, IZZ];
pub(crate) const PRODUCTS: [usize; 3] = [IXY, IXZ, IYZ];
pub(crate) const CENTER: [usize; 3] = [X, Y, Z];

/// Columns that describe the form of a part. Each excludes the others.
const FORMS: [usize; 5] = [SHAPE, MESH, CAD, SCENARIO, FILE];

/// Returns the columns of parts with a shape.
fn of_shapes() -> impl Iterator<Item = usize> {
    SIZES.into_iter().chain([ENDS, DENSITY, MATERIAL])
}

/// Columns of meshes.
const OF_MESHES: [usize; 4] = [UNIT, WELD, FILL, UNION];

impl<'s, 'a> Rows<'s, 'a> {
    /// Reads the part of a row, with its errors; `None` for a frame.
    pub(crate) fn part(
        &mut self,
        cells: &Cells<'_, 'a>,
    ) -> Result<Option<(GivenPart, PartUncertainty)>, FormatError> {
        let mut forms = FORMS.iter().filter_map(|key| cells.cell(*key));
        let form = forms.next();
        if let Some(second) = forms.next() {
            return Err(self.reader.invalid(second, "left out, because another column defines the part"));
        }
        let mass = self.reader.number(cells, MASS)?;
        let part = match (form, mass) {
            (Some(_), _) => {
                self.without(
                    cells,
                    MOMENTS.into_iter().chain(PRODUCTS),
                    "left out, because the shape of the part gives it",
                )?;
                GivenPart::of(&self.formed(cells, mass)?)
            }
            (None, Some(mass)) => {
                let rule = "left out of a part without a shape, a mesh or a file";
                self.without(cells, of_shapes().chain(OF_MESHES), rule)?;
                self.columns_of(cells, mass.value)?
            }
            (None, None) => {
                let rule = "left out of a row without mass, or given with it";
                let all = [MASS].into_iter().chain(CENTER).chain(MOMENTS).chain(PRODUCTS);
                let cell = cells.any(all.chain(of_shapes()).chain(OF_MESHES));
                return cell.map_or(Ok(None), |cell| Err(self.reader.invalid(cell, rule)));
            }
        };
        let uncertainty = self.uncertainty(cells, &part, mass)?;
        Ok(Some((part, uncertainty)))
    }

    /// Refuses the first cell in these columns.
    fn without(
        &self,
        cells: &Cells<'_, 'a>,
        keys: impl IntoIterator<Item = usize>,
        rule: &str,
    ) -> Result<(), FormatError> {
        match keys.into_iter().find_map(|key| cells.cell(key)) {
            Some(cell) => Err(self.reader.invalid(cell, rule)),
            None => Ok(()),
        }
    }

    /// Reads a part from columns of mass, centre and tensor.
    fn columns_of(&mut self, cells: &Cells<'_, 'a>, mass: f64) -> Result<GivenPart, FormatError> {
        let values = self.reader.all_or_none(cells, CENTER)?;
        let center = values.map_or([0.0; 3], |all| all.map(|given| given.map_or(0.0, |given| given.value)));
        let tensor = self.tensor(cells, mass, center)?;
        self.taken.points += usize::from(tensor.is_none());
        let tensor = tensor.unwrap_or(GivenTensor::ZERO);
        Ok(GivenPart { mass, center_of_mass: Position::from_array(center), tensor })
    }

    /// Reads the errors of mass, centre and tensor.
    fn uncertainty<'c>(
        &mut self,
        cells: &Cells<'c, 'a>,
        part: &GivenPart,
        mass: Option<Given<'c, 'a>>,
    ) -> Result<PartUncertainty, FormatError> {
        let mut sd = 0.0;
        if let Some(deviation) = self.reader.deviation(cells, MASS, mass)? {
            sd = deviation.of(part.mass, &self.reader)?;
            deviation.within(sd, MOST_DEVIATION * part.mass, &self.reader)?;
        }
        let density = self.reader.given_density(cells)?;
        if let Some(deviation) = self.reader.deviation(cells, DENSITY, density)? {
            let density = density.map_or(0.0, |given| given.value);
            if sd > 0.0 {
                return Err(self
                    .reader
                    .invalid(deviation.cell, "left out, because the mass already has an error"));
            }
            let sd_of_density = deviation.of(density, &self.reader)?;
            if !(density > 0.0) && sd_of_density > 0.0 {
                return Err(self.reader.invalid(deviation.cell, "given with the density itself"));
            }
            sd = if sd_of_density > 0.0 { part.mass * (sd_of_density / density) } else { 0.0 };
        }
        let (_, center) = self.reader.triple(cells, CENTER, Some(part.center_of_mass.to_array()))?;
        let mut tensor = [0.0; 6];
        let [[xx, yy, zz], [xy, xz, yz]] = [part.tensor.moments, part.tensor.products];
        for ((slot, key), value) in
            tensor.iter_mut().zip(MOMENTS.into_iter().chain(PRODUCTS)).zip([xx, yy, zz, xy, xz, yz])
        {
            let given = self.reader.number(cells, key)?;
            if let Some(deviation) = self.reader.deviation(cells, key, given)? {
                *slot = deviation.of(value, &self.reader)?;
            }
        }
        let own_errors = tensor != [0.0; 6];
        self.taken.following += usize::from(!own_errors && sd > 0.0 && part.tensor != GivenTensor::ZERO);
        Ok(PartUncertainty::Separate {
            mass: sd,
            tensor_follows_mass: !own_errors,
            center,
            tensor: spread(tensor),
        })
    }
}
