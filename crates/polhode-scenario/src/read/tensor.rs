//! Part given by its mass and inertia tensor.

use polhode::body::{BodyError, InertiaAbout, InertiaTensor, MassProperties};
use polhode::math::{Part, Position};
use polhode_source::toml::reader::{Table, Value, each};
use polhode_source::unit::Dimension;
use polhode_source::{FormatError, FormatErrorKind};

/// Keys of a tensor.
pub(crate) const KEYS: [&str; 6] = ["mass", "center_of_mass", "inertia", "moments", "products", "about"];

/// Reads mass properties from `mass`, `center_of_mass`, and `inertia` (a matrix) or `moments`
/// (along the part's axes), `about` the centre of mass or another point of the part.
pub(crate) fn mass_properties(table: &Table<'_>) -> Result<MassProperties<Part>, FormatError> {
    let mass_value = table.require("mass", "mass = \"12 kg\"")?;
    let mass = mass_value.positive(Dimension::MASS)?;
    let center = match table.get("center_of_mass") {
        Some(center) => Position::from_array(center.quantities(Dimension::LENGTH)?),
        None => Position::ZERO,
    };
    let (given, matrix) = matrix(table)?;
    let tensor = match about(table)? {
        None => matrix.tensor(InertiaTensor::from_matrix)?,
        Some(point) => {
            let about = matrix.tensor(|rows| InertiaAbout::from_matrix(point, rows))?;
            return MassProperties::from_inertia_about(mass, center, &about).map_err(|e| given.body(e));
        }
    };
    MassProperties::new(mass, center, tensor).map_err(|e| mass_value.body(e))
}

/// Reads the tensor alone, about the centre of mass.
pub(crate) fn tensor(table: &Table<'_>) -> Result<InertiaTensor<Part>, FormatError> {
    matrix(table)?.1.tensor(InertiaTensor::from_matrix)
}

/// Reads `inertia` or `moments`.
fn matrix<'a>(table: &Table<'a>) -> Result<(Value<'a>, Matrix<'a>), FormatError> {
    let given = table.at_most_one(&["inertia", "moments"], "each of them alone defines the tensor")?;
    let Some(given) = given else {
        return Err(
            table.missing("inertia", "moments = [\"1 kg m^2\", \"2 kg m^2\", \"2.5 kg m^2\"], or a matrix")
        );
    };
    if given.key() == "moments" {
        table.at_most_one(&["moments", "products"], "with principal moments the products are zero")?;
    }
    Ok((given, Matrix::read(table, &given)?))
}

/// Reads the reference point of the tensor, if it is not the centre of mass.
fn about(table: &Table<'_>) -> Result<Option<Position<Part>>, FormatError> {
    match table.get("about") {
        None => Ok(None),
        Some(point) if point.is_array() => {
            Ok(Some(Position::from_array(point.quantities(Dimension::LENGTH)?)))
        }
        Some(name) => name.choice(&["center_of_mass"]).map(|_| None).map_err(|e| {
            e.with_hint("write about = \"center_of_mass\", or a point: about = [\"10 mm\", 0, 0]")
        }),
    }
}

/// Matrix that should be a tensor, with the places of its elements.
struct Matrix<'a> {
    given: Value<'a>,
    /// Place of each element; `None` for moments.
    places: Option<[[Value<'a>; 3]; 3]>,
    /// Elements; off-diagonals are −∫xy dm.
    rows: [[f64; 3]; 3],
    /// Sign of the file's off-diagonals relative to −∫xy dm.
    sign: f64,
}

impl<'a> Matrix<'a> {
    fn read(table: &Table<'a>, given: &Value<'a>) -> Result<Self, FormatError> {
        if given.key() == "moments" {
            let [x, y, z] = given.quantities(Dimension::INERTIA)?;
            let rows = [[x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, z]];
            return Ok(Self { given: *given, places: None, rows, sign: 1.0 });
        }
        let sign = match table.get("products") {
            Some(name)
                if name.choice(&["negative_integral", "positive_integral"])? == "positive_integral" =>
            {
                -1.0
            }
            _ => 1.0,
        };
        let places = given.rows::<3, 3>()?;
        let mut rows = [[0.0; 3]; 3];
        for (i, (row, values)) in rows.iter_mut().zip(places).enumerate() {
            *row = each(values, |value| value.quantity(Dimension::INERTIA))?;
            for (j, element) in row.iter_mut().enumerate() {
                if i != j && sign < 0.0 {
                    *element = 0.0 - *element;
                }
            }
        }
        Ok(Self { given: *given, places: Some(places), rows, sign })
    }

    /// Builds a tensor; errors refer to the element in the file, with the signs of the file.
    fn tensor<T>(&self, build: impl Fn([[f64; 3]; 3]) -> Result<T, BodyError>) -> Result<T, FormatError> {
        build(self.rows).map_err(|error| match (error, &self.places) {
            (BodyError::NotSymmetric { element: [i, j], value, mirrored }, Some(places)) => {
                let (value, mirrored) = (self.sign * value, self.sign * mirrored);
                let kind =
                    FormatErrorKind::Body(BodyError::NotSymmetric { element: [i, j], value, mirrored });
                places.get(i - 1).and_then(|row| row.get(j - 1)).unwrap_or(&self.given).error(kind)
            }
            (error, _) => self.given.body(error),
        })
    }
}
