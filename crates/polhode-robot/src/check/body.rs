//! Link with readable mass properties, in its own frame.

use super::link_geometry::LinkGeometry;
use super::material::is_plausible;
use super::print::Print;
use crate::geometry::Volume;
use crate::model::{Inertial, Link, ModelFormat, Number, Slot, Span};
use crate::moments::{Elements, Moments, elements, norm, rotated, scaled};
use crate::pose::{rotation_matrix, transposed};

/// Names of the tensor elements, in the order of [`Elements`].
pub(super) const NAMES: [&str; 6] = ["ixx", "iyy", "izz", "ixy", "ixz", "iyz"];

/// Returns true if a solid has a positive finite volume and a nonzero finite tensor.
fn is_comparable(solid: &Volume) -> bool {
    let size = norm(&elements(&solid.tensor_per_density));
    solid.volume > 0.0 && solid.volume.is_finite() && size > 0.0 && size.is_finite()
}

/// Mass properties of a link, with its geometry. All numbers except the mass are finite.
#[derive(Debug)]
pub(super) struct Body<'m> {
    pub(super) link: &'m Link,
    pub(super) inertial: &'m Inertial,
    pub(super) geometry: &'m LinkGeometry,
    /// Mass, kg. It may be zero or negative, and is NaN if it is missing.
    pub(super) mass: f64,
    /// Centre of mass in the link's frame, m.
    pub(super) centre: [f64; 3],
    /// Rotation R_link_inertial.
    pub(super) rotation: [[f64; 3]; 3],
    /// Tensor as written, in the inertial's axes, kg·m².
    pub(super) written: Elements,
    /// Rounding error bound of each element, kg·m².
    pub(super) rounding: Elements,
    /// True if the file was printed with a fixed number of decimals, so that small numbers may have
    /// large relative errors.
    pub(super) is_cut: bool,
    /// Tensor about the centre of mass, link axes, kg·m².
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
                // SDF's default for a product is zero.
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

    /// Returns the numbers of the tensor with their index; three if it is diagonal.
    pub(super) fn numbers(&self) -> impl Iterator<Item = (usize, &'m Number)> {
        self.inertial.tensor.slots().into_iter().flatten().enumerate().filter_map(|(k, slot)| match slot {
            Slot::Given(number) => Some((k, number)),
            Slot::Missing { .. } => None,
        })
    }

    /// Returns the position of element k, or of the inertial if the element is missing.
    pub(super) fn place(&self, k: usize) -> Span {
        self.numbers().find(|(j, _)| *j == k).map_or(self.inertial.span.clone(), |(_, n)| n.span.clone())
    }

    /// Returns the position of the first number of the tensor.
    pub(super) fn tensor_place(&self) -> Span {
        self.numbers()
            .map(|(_, n)| n.span.clone())
            .min_by_key(|s| s.start)
            .unwrap_or(self.inertial.span.clone())
    }

    /// Returns the radius of gyration about the axis of the largest moment, √(i3/m), m.
    pub(super) fn gyration(&self) -> f64 {
        (self.moments.values[2].max(0.0) / self.mass).sqrt()
    }

    /// Returns the distance from the centre of mass to the farthest corner of the geometry's
    /// bounds, m; `None` if some shapes cannot be measured. It is an upper bound on the radius of
    /// gyration of a body within these bounds.
    pub(super) fn reach(&self) -> Option<f64> {
        let [low, high] = self.geometry.bounds.filter(|_| !self.geometry.is_incomplete)?;
        let mut square = 0.0;
        for k in 0..3 {
            square += f64::max((low[k] - self.centre[k]).abs(), (high[k] - self.centre[k]).abs()).powi(2);
        }
        Some(square.sqrt()).filter(|r| r.is_finite() && *r > 0.0)
    }

    /// Returns the tensor of a uniform solid with this mass, kg, about its centroid, link axes.
    pub(super) fn implied(&self, solid: &Volume, mass: f64) -> Elements {
        scaled(&elements(&solid.tensor_per_density), mass / solid.volume)
    }

    /// Returns the solids that a tensor can be compared with.
    pub(super) fn solids(&self) -> impl Iterator<Item = &'m Volume> + use<'m> {
        let geometry: &'m LinkGeometry = self.geometry;
        geometry.volumes.iter().filter(|solid| is_comparable(solid))
    }

    /// Returns the solids with all sizes multiplied by a factor.
    pub(super) fn rescaled(&self, factor: f64) -> impl Iterator<Item = &'m Volume> + use<'m> {
        let geometry: &'m LinkGeometry = self.geometry;
        let of_factor = geometry.rescaled.iter().filter(move |rescaled| rescaled.factor == factor);
        of_factor.flat_map(|rescaled| &rescaled.volumes).filter(|solid| is_comparable(solid))
    }

    /// Returns true if one of the solids has a plausible density, or if there are none.
    pub(super) fn has_plausible_density(&self) -> bool {
        let mut solids = self.solids().peekable();
        solids.peek().is_none() || solids.any(|s| is_plausible(s.kind, self.mass / s.volume))
    }

    /// Rotates a tensor from the link's axes to the inertial's axes.
    pub(super) fn in_inertial_axes(&self, tensor: &Elements) -> Elements {
        rotated(tensor, &transposed(&self.rotation))
    }
}
