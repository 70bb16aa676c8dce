//! Mass properties of a link in its own frame, or the reason why it has none.
//!
//! A link states a mass m, a frame of its inertial (centre c, attitude R_link_inertial), and a
//! tensor J about c along the axes of that frame. In the link's frame:
//!
//! I_link = R J Rᵀ, about c
//!
//! Rounding to few digits can violate i1 + i2 ≥ i3, typically for a plate. Such a tensor is
//! replaced by the nearest physical one, and [`LinkBody::rounding`] states the violation. A larger
//! violation is an error.

use polhode::body::{BodyError, InertiaTensor, MassProperties};
use polhode::math::{Part, Position, Principal, Rotation};

use crate::link_error::LinkError;
use crate::model::{ComputedMass, Inertial, Link, ModelFormat, Number, Slot, Tensor};
use crate::moments::Moments;
use crate::placement::Placement;
use crate::pose::transposed;

/// Hint for links without an inertial whose language assumes one.
const WRITE: &str = "add an <inertial> to the link";

/// Upper bounds on the violation attributed to rounding, relative to i3: for typed digits, and for
/// single precision whatever the number of digits. The checks ([`mod@crate::check`]) use the same
/// bounds.
const TYPED: f64 = 0.05;
const SINGLE_PRECISION: f64 = 1e-6;

/// Mass properties of a link.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinkBody {
    /// Mass properties in the link's frame.
    pub properties: MassProperties<Part>,
    /// Violation of the triangle inequality, i3 − i1 − i2, or of positivity, −i1, kg·m². It is due
    /// to the rounding of the digits, and zero for most links.
    pub rounding: f64,
}

/// Mass properties of a link, or none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LinkMass {
    /// Mass properties of a rigid body.
    Body(LinkBody),
    /// Frame: the link states no mass properties, or all of them are zero.
    None,
}

/// Returns the mass properties of a link in its own frame.
///
/// # Errors
/// [`LinkError`] if a number cannot be used, or the mass properties are unphysical.
pub fn link_mass(format: ModelFormat, link: &Link) -> Result<LinkMass, LinkError> {
    match (&link.computed, &link.inertial) {
        (Some(Ok(computed)), _) => of_computed(computed, link),
        (Some(Err(why)), _) => {
            let message = format!("its mass cannot be computed: {why}");
            Err(LinkError::new(message, WRITE).at(&link.span))
        }
        (None, None) => assumed(format, link),
        (None, Some(inertial)) => of_inertial(format, inertial),
    }
}

fn of_computed(computed: &ComputedMass, link: &Link) -> Result<LinkMass, LinkError> {
    let ComputedMass { mass, center, tensor: [xx, yy, zz, xy, xz, yz] } = *computed;
    if mass == 0.0 {
        return Ok(LinkMass::None);
    }
    let body = possible([xx, yy, zz], [xy, xz, yz], 0.0).and_then(|(tensor, rounding)| {
        let properties = MassProperties::<Part>::new(mass, Position::from_array(center), tensor)?;
        Ok(LinkMass::Body(LinkBody { properties, rounding }))
    });
    body.map_err(|error| LinkError::impossible(&error, &link.span))
}

/// Treats a link without mass properties as a frame, unless the language assumes some.
fn assumed(format: ModelFormat, link: &Link) -> Result<LinkMass, LinkError> {
    let rule = match format {
        _ if link.from_geometry => "its mass has to be computed from its geometry and densities",
        ModelFormat::Sdf => "SDFormat then assumes 1 kg and 1 kg·m² about each axis",
        ModelFormat::Urdf | ModelFormat::Mjcf | ModelFormat::Usd | ModelFormat::Osim => {
            return Ok(LinkMass::None);
        }
    };
    Err(LinkError::new(format!("it has no inertial: {rule}"), WRITE).at(&link.span))
}

fn of_inertial(format: ModelFormat, inertial: &Inertial) -> Result<LinkMass, LinkError> {
    let impossible = |error| LinkError::impossible(&error, &inertial.span);
    let mass = number("mass", &inertial.mass)?;
    if let Some(Number { text, span, .. }) = inertial.pose.unreadable.first() {
        let message = format!("its inertial frame has {text:?}, which is not a finite number");
        return Err(LinkError::of_number(message, span));
    }
    let (moments, products, printed) = elements(format, &inertial.tensor)?;
    if mass == 0.0 && moments.iter().chain(&products).all(|&element| element == 0.0) {
        return Ok(LinkMass::None);
    }
    let (tensor, rounding) = possible(moments, products, printed).map_err(impossible)?;
    let Placement { position, rotation } = Placement::of(&inertial.pose).map_err(impossible)?;
    let properties = MassProperties::<Part>::new(mass, Position::ZERO, tensor)
        .and_then(|body| body.placed(position, rotation))
        .map_err(impossible)?;
    Ok(LinkMass::Body(LinkBody { properties, rounding }))
}

/// Returns the moments, the products (elements of the tensor), and the rounding error of the
/// digits, kg·m².
pub(crate) fn elements(format: ModelFormat, tensor: &Tensor) -> Result<([f64; 3], [f64; 3], f64), LinkError> {
    match tensor {
        Tensor::Missing(span) => Err(LinkError::of_number("it has no inertia tensor", span)),
        Tensor::Diagonal(slots) => {
            let [a, b, c] = &**slots;
            let moments = [number("diaginertia", a)?, number("diaginertia", b)?, number("diaginertia", c)?];
            Ok((moments, [0.0; 3], half_units(&slots[..])))
        }
        Tensor::Six(slots) => {
            let [xx, yy, zz, xy, xz, yz] = &**slots;
            let moments = [number("ixx", xx)?, number("iyy", yy)?, number("izz", zz)?];
            // The default of a product in SDFormat is zero.
            let product = |what: &str, slot: &Slot| match slot {
                Slot::Missing { .. } if format == ModelFormat::Sdf => Ok(0.0),
                _ => number(what, slot),
            };
            let products = [product("ixy", xy)?, product("ixz", xz)?, product("iyz", yz)?];
            Ok((moments, products, half_units(&slots[..])))
        }
    }
}

fn number(what: &str, slot: &Slot) -> Result<f64, LinkError> {
    slot.finite().ok_or_else(|| {
        let message = match slot {
            Slot::Missing { name, .. } => format!("it has no {name}"),
            Slot::Given(number) => format!("its {what} is {:?}, which is not a finite number", number.text),
        };
        LinkError::of_number(message, &slot.span())
    })
}

/// Returns the sum of half units of the last digits: a bound on the change of i3 − i1 − i2 by
/// rounding.
fn half_units(slots: &[Slot]) -> f64 {
    let unit = |slot: &Slot| match slot {
        Slot::Given(number) => last_digit(&number.text),
        Slot::Missing { .. } => 0.0,
    };
    slots.iter().map(|slot| 0.5 * unit(slot)).sum()
}

/// Returns the unit of the last digit: 1e-6 for `"1.641e-3"`. Zero for an integer, which may be
/// exact.
fn last_digit(text: &str) -> f64 {
    let (mantissa, power) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let Some((_, decimals)) = mantissa.split_once('.') else { return 0.0 };
    let power =
        power.parse::<i32>().unwrap_or(0).saturating_sub(i32::try_from(decimals.len()).unwrap_or(i32::MAX));
    format!("1e{power}").parse().unwrap_or(0.0)
}

/// Returns the tensor and its violation, or the nearest physical tensor if rounding explains it.
fn possible(
    moments: [f64; 3],
    products: [f64; 3],
    printed: f64,
) -> Result<(InertiaTensor<Part>, f64), BodyError> {
    let error = match InertiaTensor::<Part>::with_negative_products(moments, products) {
        Ok(tensor) => return Ok((tensor, 0.0)),
        Err(error @ BodyError::Parameter { .. }) => return Err(error),
        Err(error) => error,
    };
    let ([xx, yy, zz], [xy, xz, yz]) = (moments, products);
    let Moments { values, axes } = Moments::of(&[xx, yy, zz, xy, xz, yz]);
    let [i1, _, greatest] = values;
    let [j1, j2, j3] = values.map(|i| i.max(0.0));
    let excess = (j3 - j2 - j1).max(0.0);
    let lacks = excess.max(-i1);
    if !(lacks <= f64::max(SINGLE_PRECISION * greatest, printed.min(TYPED * greatest))) {
        return Err(error);
    }
    // Smallest change that makes the tensor physical: negative moments become zero, and each moment
    // takes a third of the excess.
    let third = excess / 3.0;
    let on_edge = InertiaTensor::diagonal([j1 + third, j2 + third, j3 - third])?;
    let principal = Rotation::<Part, Principal>::from_matrix(transposed(&axes)).map_err(|_| error)?;
    Ok((on_edge.in_frame(principal), lacks))
}
