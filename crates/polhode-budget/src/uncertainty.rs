//! Uncertainty of the numbers of a row.

use polhode::infer::covariance::{NotCovariance, columns};

use crate::tank::UncertainLiquid;

/// Errors of the numbers of a row, with mean zero.
///
/// Errors of the part are those of one copy.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Uncertainty {
    /// Errors of the part's mass properties as given.
    pub part: PartUncertainty,
    /// Errors of the frame's origin along the parent's axes, covariance in m². All descendants move
    /// with the frame.
    pub position: Spread<3>,
    /// Errors of the frame's rotation vector about its origin, along the parent's axes, covariance
    /// in rad².
    pub rotation: Spread<3>,
}

/// Errors of a part's mass properties.
#[derive(Clone, Debug, PartialEq)]
pub enum PartUncertainty {
    /// Separate errors of mass, centre of mass and tensor.
    Separate {
        /// Standard deviation of the mass, kg.
        mass: f64,
        /// True if the tensor scales with the mass, in addition to its own errors. This applies if
        /// the form is known and the density is not.
        tensor_follows_mass: bool,
        /// Errors of the centre of mass, covariance in m².
        center: Spread<3>,
        /// Errors of Ixx, Iyy, Izz, Ixy, Ixz, Iyz as given, covariance in kg²·m⁴. They have the
        /// reference point and the sign convention of the given tensor.
        tensor: Spread<6>,
    },
    /// Joint covariance of mass, centre of mass x, y, z, and Ixx, Iyy, Izz, Ixy, Ixz, Iyz.
    Joint(Box<[[f64; 10]; 10]>),
    /// Errors of amount and density, for a part that is the liquid in a tank.
    Liquid(Box<UncertainLiquid>),
}

impl Default for PartUncertainty {
    fn default() -> Self {
        Self::of_mass(0.0)
    }
}

impl PartUncertainty {
    /// Returns the uncertainty of a part of known form, from the standard deviation of its mass,
    /// kg.
    pub fn of_mass(sd: f64) -> Self {
        Self::Separate { mass: sd, tensor_follows_mass: true, center: Spread::Exact, tensor: Spread::Exact }
    }
}

/// Errors of N numbers.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Spread<const N: usize> {
    /// Exact numbers without errors.
    #[default]
    Exact,
    /// Independent errors with these standard deviations.
    Deviations([f64; N]),
    /// Errors with this covariance.
    Covariance(Box<[[f64; N]; N]>),
}

/// Number of a row that an error belongs to. An error of a joint covariance belongs to the first
/// number that it changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ErrorKind {
    /// Mass of the part, and its tensor if that scales with the mass.
    Mass,
    /// Centre of mass of the part.
    Center,
    /// Inertia tensor of the part.
    Tensor,
    /// Position of the row's frame.
    Position,
    /// Rotation of the row's frame.
    Rotation,
    /// Density of a liquid.
    Density,
}

/// Count of uncertain numbers of a row: mass, centre, tensor, position, rotation, density of a
/// liquid.
pub(crate) const NUMBERS: usize = 17;
const DENSITY: usize = 16;

/// Independent error of a row: the change of each number per unit of a standard normal variable. It
/// is a column of the Cholesky factor of the covariance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Factor {
    /// Index of the column: the first number that it changes.
    pub(crate) number: usize,
    pub(crate) error: RowError,
}

/// Errors of the numbers of a row. Errors of the tensor are those of its elements, about the given
/// point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct RowError {
    pub(crate) mass: f64,
    pub(crate) center: [f64; 3],
    pub(crate) tensor: [f64; 6],
    pub(crate) position: [f64; 3],
    pub(crate) rotation: [f64; 3],
    /// Relative error of the density.
    pub(crate) density: f64,
}

/// Zero errors, of exact numbers.
pub(crate) const NONE: RowError = RowError {
    mass: 0.0,
    center: [0.0; 3],
    tensor: [0.0; 6],
    position: [0.0; 3],
    rotation: [0.0; 3],
    density: 0.0,
};

/// Reason why an uncertainty is not valid.
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

    /// Returns true if the error belongs to the row's frame, not to its part.
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
    /// Returns the errors as independent factors. `sign` converts products of inertia to tensor
    /// elements.
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

/// Checks a standard deviation. Returns `None` if it is zero.
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
