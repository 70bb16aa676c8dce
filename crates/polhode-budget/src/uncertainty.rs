//! How well the numbers of a row are known.

use polhode::infer::covariance::{NotCovariance, columns};

use crate::tank::UncertainLiquid;

/// Errors of the numbers of a row, with mean zero.
///
/// Those of its part are of one copy.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Uncertainty {
    /// Of the part's mass properties, as they are given.
    pub part: PartUncertainty,
    /// Of the frame's origin, along the parent's axes, m². All that stands in the frame moves with it.
    pub position: Spread<3>,
    /// Of the frame's rotation vector about its origin, along the parent's axes, rad².
    pub rotation: Spread<3>,
}

/// Errors of a part's mass properties.
#[derive(Clone, Debug, PartialEq)]
pub enum PartUncertainty {
    /// Mass, centre and tensor each for itself.
    Separate {
        /// Standard deviation of the mass, kg.
        mass: f64,
        /// Whether the tensor goes with the mass, besides its own errors: as where the form is known and the density is not.
        tensor_follows_mass: bool,
        /// Of the centre of mass, m².
        center: Spread<3>,
        /// Of Ixx, Iyy, Izz, Ixy, Ixz, Iyz as given, about the point and with the sign that they are given for, kg²·m⁴.
        tensor: Spread<6>,
    },
    /// One covariance of mass, centre of mass x, y, z and these six.
    Joint(Box<[[f64; 10]; 10]>),
    /// The part is what is in a tank: of its amount, and of its density.
    Liquid(Box<UncertainLiquid>),
}

impl Default for PartUncertainty {
    fn default() -> Self {
        Self::of_mass(0.0)
    }
}

impl PartUncertainty {
    /// The standard deviation of the mass, kg, of a part whose form is known.
    pub fn of_mass(sd: f64) -> Self {
        Self::Separate { mass: sd, tensor_follows_mass: true, center: Spread::Exact, tensor: Spread::Exact }
    }
}

/// Errors of N numbers.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Spread<const N: usize> {
    /// None.
    #[default]
    Exact,
    /// Independent, with these standard deviations.
    Deviations([f64; N]),
    /// Of this covariance.
    Covariance(Box<[[f64; N]; N]>),
}

/// Of which number of a row an error is; where several have one covariance, of the first of those that it moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ErrorKind {
    /// The part's mass, with its tensor where that follows it.
    Mass,
    /// Its centre of mass.
    Center,
    /// Its inertia tensor.
    Tensor,
    /// Where its frame is.
    Position,
    /// How its frame is turned.
    Rotation,
    /// The density of a liquid.
    Density,
}

/// How many numbers a row has: mass, centre, tensor, position, rotation, density of a liquid.
pub(crate) const NUMBERS: usize = 17;
const DENSITY: usize = 16;

/// An error of a row: so much of each number for a standard normal variable, a column of the covariance's Cholesky factor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Factor {
    /// Which column: the number that it begins with.
    pub(crate) number: usize,
    pub(crate) error: RowError,
}

/// Errors of the numbers of a row; the tensor's elements are those of the tensor itself, about the point that it is given for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct RowError {
    pub(crate) mass: f64,
    pub(crate) center: [f64; 3],
    pub(crate) tensor: [f64; 6],
    pub(crate) position: [f64; 3],
    pub(crate) rotation: [f64; 3],
    /// As a part of the density.
    pub(crate) density: f64,
}

/// Errors of numbers that are exact.
pub(crate) const NONE: RowError = RowError {
    mass: 0.0,
    center: [0.0; 3],
    tensor: [0.0; 6],
    position: [0.0; 3],
    rotation: [0.0; 3],
    density: 0.0,
};

/// Why an uncertainty is none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum NotUncertainty {
    Deviation { what: &'static str, value: f64 },
    Covariance { what: &'static str, element: [usize; 2] },
}

impl Factor {
    pub(crate) const fn kind(&self) -> ErrorKind {
        ErrorKind::of(self.number)
    }
}

impl ErrorKind {
    /// All kinds in their order, with their names.
    pub(crate) const NAMED: [(&str, Self); 6] = [
        ("mass", Self::Mass),
        ("center", Self::Center),
        ("tensor", Self::Tensor),
        ("position", Self::Position),
        ("rotation", Self::Rotation),
        ("density", Self::Density),
    ];

    pub(crate) const fn name(self) -> &'static str {
        Self::NAMED[self as usize].0
    }

    pub(crate) const fn of(number: usize) -> Self {
        match number {
            0 => Self::Mass,
            1..4 => Self::Center,
            4..10 => Self::Tensor,
            10..13 => Self::Position,
            13..DENSITY => Self::Rotation,
            _ => Self::Density,
        }
    }

    /// Whether it is of the row's frame, and not of its part.
    pub(crate) const fn is_of_frame(self) -> bool {
        matches!(self, Self::Position | Self::Rotation)
    }
}

impl RowError {
    pub(crate) fn add(&mut self, other: &Self, factor: f64) {
        let add = |a: &mut [f64], b: &[f64]| a.iter_mut().zip(b).for_each(|(a, b)| *a += factor * b);
        self.mass += factor * other.mass;
        self.density += factor * other.density;
        add(&mut self.center, &other.center);
        add(&mut self.tensor, &other.tensor);
        add(&mut self.position, &other.position);
        add(&mut self.rotation, &other.rotation);
    }
}

impl Uncertainty {
    /// The errors as independent ones, where products have this sign.
    pub(crate) fn factors(&self, sign: f64) -> Result<Vec<Factor>, NotUncertainty> {
        let mut all = Vec::with_capacity(NUMBERS);
        let mut put = |number, error| all.push(Factor { number, error });
        let tensor = |[xx, yy, zz, xy, xz, yz]: [f64; 6]| [xx, yy, zz, sign * xy, sign * xz, sign * yz];
        match &self.part {
            PartUncertainty::Separate { mass, center, tensor: spread, .. } => {
                if let Some(mass) = deviation("the mass", *mass)? {
                    put(0, RowError { mass, ..NONE });
                }
                center.factors("the centre of mass", |k, center| put(1 + k, RowError { center, ..NONE }))?;
                spread.factors("the inertia tensor", |k, elements| {
                    put(4 + k, RowError { tensor: tensor(elements), ..NONE });
                })?;
            }
            PartUncertainty::Joint(covariance) => {
                let what = "mass, centre and tensor";
                for (number, column) in columns(covariance).map_err(|error| no_covariance(what, error))? {
                    let [mass, x, y, z, elements @ ..] = column;
                    let (center, tensor) = ([x, y, z], tensor(elements));
                    put(number, RowError { mass, center, tensor, ..NONE });
                }
            }
            PartUncertainty::Liquid(liquid) => {
                if let Some(mass) = deviation("the amount of the liquid", liquid.errors.amount)? {
                    put(0, RowError { mass, ..NONE });
                }
                if let Some(density) = deviation("the density of the liquid", liquid.errors.density)? {
                    put(DENSITY, RowError { density, ..NONE });
                }
            }
        }
        self.position.factors("the position", |k, position| put(10 + k, RowError { position, ..NONE }))?;
        self.rotation.factors("the rotation", |k, rotation| put(13 + k, RowError { rotation, ..NONE }))?;
        Ok(all)
    }
}

impl<const N: usize> Spread<N> {
    fn factors(
        &self,
        what: &'static str,
        mut each: impl FnMut(usize, [f64; N]),
    ) -> Result<(), NotUncertainty> {
        match self {
            Self::Exact => {}
            Self::Deviations(sd) => {
                for (k, &value) in sd.iter().enumerate() {
                    if let Some(value) = deviation(what, value)? {
                        let mut column = [0.0; N];
                        column[k] = value;
                        each(k, column);
                    }
                }
            }
            Self::Covariance(covariance) => {
                columns(covariance)
                    .map_err(|error| no_covariance(what, error))?
                    .into_iter()
                    .for_each(|(k, column)| each(k, column));
            }
        }
        Ok(())
    }
}

/// A standard deviation, unless it is zero.
fn deviation(what: &'static str, value: f64) -> Result<Option<f64>, NotUncertainty> {
    match value {
        0.0 => Ok(None),
        value if value > 0.0 && value.is_finite() => Ok(Some(value)),
        value => Err(NotUncertainty::Deviation { what, value }),
    }
}

const fn no_covariance(what: &'static str, error: NotCovariance) -> NotUncertainty {
    NotUncertainty::Covariance { what, element: error.element }
}
