//! Bodies and initial states in command-line notation.

use std::str::FromStr;

use polhode::body::InertiaTensor;
use polhode::math::{Attitude, Body, Space};
use polhode::observe::TumblingPeriods;
use polhode_source::given::{numbers, positive, rotation};
use polhode_source::unit::Dimension;

/// Principal moments of inertia about body axes x, y and z, kg·m².
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moments(pub [f64; 3]);

/// Inertia tensor about the centre of mass along body axes, off-diagonal −∫xy dm, kg·m².
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tensor(pub InertiaTensor<Body>);

/// Angular velocity ω along body axes, rad/s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Omega(pub [f64; 3]);

/// Attitude, body to space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quaternion(pub Attitude);

/// Periods of precession and rotation of a tumbling body, s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Periods(pub TumblingPeriods);

impl FromStr for Moments {
    type Err = String;

    /// Reads `1, 2, 3` or `(1, 2, 3) kg m^2`.
    fn from_str(text: &str) -> Result<Self, String> {
        let moments = numbers(text, "a,b,c", Dimension::INERTIA)?;
        let mut sorted = moments;
        sorted.sort_by(f64::total_cmp);
        let [least, second, third] = sorted;
        if !(least >= 0.0) {
            return Err(format!("{least} is negative, and a moment of inertia is a sum of squares"));
        }
        if second == 0.0 {
            return Err("a body with two moments of 0 is a point".to_owned());
        }
        if least == 0.0 && second != third {
            return Err("only a rod has a moment of 0, and its other two are equal".to_owned());
        }
        Ok(Self(moments))
    }
}

impl FromStr for Tensor {
    type Err = String;

    /// Reads `xx, yy, zz, xy, xz, yz`.
    fn from_str(text: &str) -> Result<Self, String> {
        let [xx, yy, zz, xy, xz, yz] = numbers(text, "xx,yy,zz,xy,xz,yz", Dimension::INERTIA)?;
        InertiaTensor::with_negative_products([xx, yy, zz], [xy, xz, yz])
            .map(Self)
            .map_err(|error| error.to_string())
    }
}

impl FromStr for Omega {
    type Err = String;

    /// Reads `0.1, 0, 3` or `(0, 0, 30) deg/s`.
    fn from_str(text: &str) -> Result<Self, String> {
        numbers(text, "x,y,z", Dimension::ANGULAR_VELOCITY).map(Self)
    }
}

impl FromStr for Quaternion {
    type Err = String;

    /// Reads `w, x, y, z`.
    fn from_str(text: &str) -> Result<Self, String> {
        rotation::<Space, Body>(text).map(Self)
    }
}

impl FromStr for Periods {
    type Err = String;

    /// Reads `P_phi, P_psi`.
    fn from_str(text: &str) -> Result<Self, String> {
        let [precession, rotation] = numbers(text, "P_phi,P_psi", Dimension::TIME)?;
        Ok(Self(TumblingPeriods { precession: positive(precession)?, rotation: positive(rotation)? }))
    }
}
