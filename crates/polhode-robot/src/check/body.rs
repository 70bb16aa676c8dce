//! A link whose mass and tensor can be read, seen in its own frame.

use super::link_geometry::LinkGeometry;
use super::material::is_plausible;
use super::print::Print;
use crate::geometry::Volume;
use crate::model::{Inertial, Link, ModelFormat, Number, Slot, Span};
use crate::moments::{Elements, Moments, elements, norm, rotated, scaled};
use crate::pose::{rotation_matrix, transposed};

/// The names of a tensor's elements, in the order of [`Elements`].
pub(super) const NAMES: [&str; 6] = ["ixx", "iyy", "izz", "ixy", "ixz", "iyz"];

/// True if a solid has a volume and a tensor.
fn is_comparable(solid: &Volume) -> bool {
    let size = norm(&elements(&solid.tensor_per_density));
    solid.volume > 0.0 && solid.volume.is_finite() && size > 0.0 && size.is_finite()
}

/// Mass, centre and tensor of a link, all but the mass finite, and what its geometry says.
#[derive(Debug)]
pub(super) struct Body<'m> {
    pub(super) link: &'m Link,
    pub(super) inertial: &'m Inertial,
    pub(super) geometry: &'m LinkGeometry,
    /// kg; it may be negative or zero, and is NaN if it is not there.
    pub(super) mass: f64,
    /// In the link's frame, m.
    pub(super) centre: [f64; 3],
    /// R_link_inertial
    pub(super) rotation: [[f64; 3]; 3],
    /// As written, along the inertial's axes.
    pub(super) written: Elements,
    /// How far rounding may have moved each element.
    pub(super) rounding: Elements,
    /// True if the print is known to have cut small numbers short, so that rounding may be large beside them.
    pub(super) is_cut: bool,
    /// About the centre of mass, along the link's axes.
    pub(super) tensor: Elements,
    pub(super) moments: Moments,
}

impl<'m> Body<'m> {
    pub(super) fn of(
        format: ModelFormat,
        link: &'m Link,
        geometry: &'m LinkGeometry,
        print: Print,
    ) -> Option<Self> {
        let inertial = link.inertial.as_ref()?;
        let mass = inertial.mass.finite().unwrap_or(f64::NAN);
        let mut written = [0.0; 6];
        for (k, slot) in inertial.tensor.slots()?.enumerate() {
            written[k] = match slot {
                // Products that SDF is not told are zero.
                Slot::Missing { .. } if k >= 3 && format == ModelFormat::Sdf => 0.0,
                slot => slot.finite()?,
            };
        }
        let rotation = rotation_matrix(inertial.pose.rotation);
        let (rounding, is_cut) = print.rounding(&inertial.tensor, &written);
        Some(Self {
            link,
            inertial,
            geometry,
            mass,
            centre: inertial.pose.position,
            rotation,
            written,
            rounding,
            is_cut,
            tensor: rotated(&written, &rotation),
            moments: Moments::of(&written),
        })
    }

    /// The numbers of the tensor; three if it is diagonal.
    pub(super) fn numbers(&self) -> impl Iterator<Item = (usize, &'m Number)> {
        self.inertial.tensor.slots().into_iter().flatten().enumerate().filter_map(|(k, slot)| match slot {
            Slot::Given(number) => Some((k, number)),
            Slot::Missing { .. } => None,
        })
    }

    /// Where element k is written; the inertial if it is not.
    pub(super) fn place(&self, k: usize) -> Span {
        self.numbers().find(|(j, _)| *j == k).map_or(self.inertial.span.clone(), |(_, n)| n.span.clone())
    }

    /// Where the tensor begins.
    pub(super) fn tensor_place(&self) -> Span {
        self.numbers()
            .map(|(_, n)| n.span.clone())
            .min_by_key(|s| s.start)
            .unwrap_or(self.inertial.span.clone())
    }

    /// The radius of gyration about the greatest axis, √(i3/m), m.
    pub(super) fn gyration(&self) -> f64 {
        (self.moments.values[2].max(0.0) / self.mass).sqrt()
    }

    /// From the centre of mass to the farthest corner of the geometry's bounds, m: no radius of gyration of a body
    /// within them is longer.
    pub(super) fn reach(&self) -> Option<f64> {
        let [low, high] = self.geometry.bounds?;
        let mut square = 0.0;
        for k in 0..3 {
            square += f64::max((low[k] - self.centre[k]).abs(), (high[k] - self.centre[k]).abs()).powi(2);
        }
        Some(square.sqrt()).filter(|r| r.is_finite() && *r > 0.0)
    }

    /// The tensor along the link's axes that a solid has with a mass, kg, about its centroid.
    pub(super) fn implied(&self, solid: &Volume, mass: f64) -> Elements {
        scaled(&elements(&solid.tensor_per_density), mass / solid.volume)
    }

    /// The solids that a tensor can be compared with.
    pub(super) fn solids(&self) -> impl Iterator<Item = &'m Volume> + use<'m> {
        let geometry: &'m LinkGeometry = self.geometry;
        geometry.volumes.iter().filter(|solid| is_comparable(solid))
    }

    /// The solids with the sizes of all shapes times a factor.
    pub(super) fn rescaled(&self, factor: f64) -> impl Iterator<Item = &'m Volume> + use<'m> {
        let geometry: &'m LinkGeometry = self.geometry;
        let of_factor = geometry.rescaled.iter().filter(move |rescaled| rescaled.factor == factor);
        of_factor.flat_map(|rescaled| &rescaled.volumes).filter(|solid| is_comparable(solid))
    }

    /// True if one of the solids has a density that a material may have, or if there are none.
    pub(super) fn has_plausible_density(&self) -> bool {
        let mut solids = self.solids().peekable();
        solids.peek().is_none() || solids.any(|s| is_plausible(s.kind, self.mass / s.volume))
    }

    /// A tensor along the link's axes, along the inertial's.
    pub(super) fn in_inertial_axes(&self, tensor: &Elements) -> Elements {
        rotated(tensor, &transposed(&self.rotation))
    }
}
