//! A link as a body: its mass properties in the link's own frame, or why it has none.
//!
//! A link says mass m, a frame of its inertial in its own (centre c, attitude R_link_inertial), and a tensor J about c along that
//! frame's axes. In the link's frame:
//!
//! I_link = R J Rᵀ, about c
//!
//! Numbers with few digits can miss i1 + i2 ≥ i3 by their rounding, as those of a plate do. Such a tensor becomes the nearest
//! possible one, and [`LinkBody::rounding`] says by how much; anything beyond is an error.

use polhode::body::{BodyError, InertiaTensor, MassProperties};
use polhode::math::{Part, Position, Principal, Rotation};

use crate::link_error::LinkError;
use crate::model::{ComputedMass, Inertial, Link, ModelFormat, Number, Slot, Tensor};
use crate::moments::Moments;
use crate::placement::Placement;
use crate::pose::transposed;

/// Advice for links whose language makes something of a missing inertial.
const WRITE: &str = "write its inertial";

/// What rounding may have done to a tensor, as parts of i3: the digits that it is written with do no more than this, and single
/// precision does so much however many digits are written. The checks ([`mod@crate::check`]) draw the line in the same place.
const TYPED: f64 = 0.05;
const SINGLE_PRECISION: f64 = 1e-6;

/// A link's mass properties.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinkBody {
    /// In the link's frame.
    pub properties: MassProperties<Part>,
    /// What the tensor lacked to be possible, i3 − i1 − i2 or −i1, in kg·m²: the rounding of its digits. Zero for most.
    pub rounding: f64,
}

/// What a link is, as far as its mass is concerned.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LinkMass {
    /// A body.
    Body(LinkBody),
    /// A frame: it says nothing of its mass, or that all of it is zero.
    None,
}

/// The mass properties of a link, in its own frame.
///
/// # Errors
/// [`LinkError`] if a number cannot be used, or these are unphysical.
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

/// A link that says nothing of its mass is a frame, but for what languages make of it.
fn assumed(format: ModelFormat, link: &Link) -> Result<LinkMass, LinkError> {
    let rule = match format {
        _ if link.from_geometry => "its mass is to be computed from its geometry and densities",
        ModelFormat::Sdf => "SDFormat then gives it 1 kg and 1 kg·m² about each axis",
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
        let message = format!("its inertial frame is {text:?}, no finite number");
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

/// Moments, products (elements of the tensor), and how far the digits leave the moments open.
fn elements(format: ModelFormat, tensor: &Tensor) -> Result<([f64; 3], [f64; 3], f64), LinkError> {
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
            // SDFormat's default of a product is zero.
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
            Slot::Given(number) => format!("its {what} is {:?}, no finite number", number.text),
        };
        LinkError::of_number(message, &slot.span())
    })
}

/// The sum of half units of the last digits: how far i3 − i1 − i2 can be moved by rounding each element.
fn half_units(slots: &[Slot]) -> f64 {
    let unit = |slot: &Slot| match slot {
        Slot::Given(number) => last_digit(&number.text),
        Slot::Missing { .. } => 0.0,
    };
    slots.iter().map(|slot| 0.5 * unit(slot)).sum()
}

/// What one more in the last digit is worth: 1e-6 of `"1.641e-3"`; of a whole number nothing, as it may be exact.
fn last_digit(text: &str) -> f64 {
    let (mantissa, power) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let Some((_, decimals)) = mantissa.split_once('.') else { return 0.0 };
    let power =
        power.parse::<i32>().unwrap_or(0).saturating_sub(i32::try_from(decimals.len()).unwrap_or(i32::MAX));
    format!("1e{power}").parse().unwrap_or(0.0)
}

/// The tensor, or the nearest possible one if only rounding parts them, and what it lacked.
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
    // The least change that makes it possible: nothing negative, and a third of the excess to each moment.
    let third = excess / 3.0;
    let on_edge = InertiaTensor::diagonal([j1 + third, j2 + third, j3 - third])?;
    let principal = Rotation::<Part, Principal>::from_matrix(transposed(&axes)).map_err(|_| error)?;
    Ok((on_edge.in_frame(principal), lacks))
}
