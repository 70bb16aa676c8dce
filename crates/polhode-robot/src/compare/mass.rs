//! Mass properties as a file states them, which may be unphysical, in any frame.

use polhode::math::Body;

use crate::body::{self, LinkMass, link_mass};
use crate::link_error::LinkError;
use crate::model::{ComputedMass, Inertial, Link, ModelFormat, Pose};
use crate::moments::{Elements, difference, elements, matrix, norm, parallel_axes, trace};
use crate::placement::Placement;

/// Mass properties of a link or of several links.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Mass {
    /// Mass, kg; NaN if it cannot be read.
    pub(super) mass: f64,
    /// Centre of mass, m.
    pub(super) center: [f64; 3],
    /// Tensor about the centre of mass, kg·m².
    pub(super) tensor: Elements,
}

impl Mass {
    /// Returns the numbers of a link in its own frame; `None` for a frame without mass. Numbers that
    /// cannot be read are NaN.
    ///
    /// # Errors
    /// [`LinkError`] if the mass cannot be computed.
    pub(super) fn of(format: ModelFormat, link: &Link) -> Result<Option<Self>, LinkError> {
        match (&link.computed, &link.inertial) {
            (Some(Ok(ComputedMass { mass, .. })), _) if *mass == 0.0 => Ok(None),
            (Some(Ok(ComputedMass { mass, center, tensor })), _) => {
                Ok(Some(Self { mass: *mass, center: *center, tensor: *tensor }))
            }
            (None, Some(inertial)) => Ok(Self::of_inertial(format, inertial)),
            (Some(Err(_)), _) | (None, None) => Ok(match link_mass(format, link)? {
                LinkMass::None => None,
                LinkMass::Body(body) => Some(Self {
                    mass: body.properties.mass(),
                    center: body.properties.center_of_mass().to_array(),
                    tensor: elements(&body.properties.inertia().matrix()),
                }),
            }),
        }
    }

    /// Returns the numbers of an inertial; those that cannot be read are NaN.
    fn of_inertial(format: ModelFormat, inertial: &Inertial) -> Option<Self> {
        let mass = inertial.mass.finite().unwrap_or(f64::NAN);
        let written = match body::elements(format, &inertial.tensor) {
            Ok(([xx, yy, zz], [xy, xz, yz], _)) => [xx, yy, zz, xy, xz, yz],
            Err(_) => [f64::NAN; 6],
        };
        if mass == 0.0 && written == [0.0; 6] {
            return None;
        }
        let place = Placement::<Body, Body>::of(&inertial.pose);
        let Some(place) = place.ok().filter(|_| inertial.pose.unreadable.is_empty()) else {
            return Some(Self { mass, center: [f64::NAN; 3], tensor: [f64::NAN; 6] });
        };
        let frame = Pose::new(place.position.to_array(), place.rotation.quaternion());
        Some(Self { mass, center: [0.0; 3], tensor: written }.placed(&frame))
    }

    /// Returns the mass properties in the outer frame of a pose.
    pub(super) fn placed(&self, pose: &Pose) -> Self {
        // The identity keeps the digits of the file.
        if pose.position == [0.0; 3] && pose.rotation == Pose::IDENTITY.rotation {
            return *self;
        }
        let tensor = elements(&pose.turned_tensor(matrix(&self.tensor)));
        Self { mass: self.mass, center: pose.placed(self.center), tensor }
    }

    /// Returns the mass properties of several bodies in one frame; `None` without bodies, or if
    /// the masses are not positive.
    ///
    /// I = Σ (I_k + m_k (d_k² 1 − d_k d_kᵀ)),   d_k = c_k − c
    pub(super) fn sum(parts: &[Self]) -> Option<Self> {
        let total: f64 = parts.iter().map(|part| part.mass).sum();
        if !(total > 0.0 && parts.iter().all(|part| part.mass >= 0.0)) {
            return None;
        }
        let center = std::array::from_fn(|k| parts.iter().map(|p| p.mass / total * p.center[k]).sum());
        let mut tensor = [0.0; 6];
        for part in parts {
            let aside = parallel_axes(part.mass, vector(center, part.center));
            tensor = std::array::from_fn(|k| tensor[k] + part.tensor[k] + aside[k]);
        }
        Some(Self { mass: total, center, tensor })
    }

    /// Returns the agreement of mass, centre and tensor with other mass properties in the same
    /// frame.
    ///
    /// |Δm| ≤ τ m,   |Δc| ≤ τ max(|c|, k) with k² = tr I / 2m,   ‖ΔI‖ ≤ τ ‖I‖, each with the larger
    /// of the two values on the right.
    pub(super) fn agrees(&self, other: &Self, tolerance: f64) -> [bool; 3] {
        let scale = |of: fn(&Self) -> f64| tolerance * f64::max(of(self), of(other));
        [
            within((self.mass - other.mass).abs(), scale(|body| body.mass.abs())),
            within(length(vector(self.center, other.center)), scale(Self::reach)),
            within(norm(&difference(&self.tensor, &other.tensor)), scale(|body| norm(&body.tensor))),
        ]
    }

    /// Returns true for each of mass, centre and tensor that can be read.
    pub(super) fn readable(&self) -> [bool; 3] {
        let is_finite = |numbers: &[f64]| numbers.iter().all(|x| x.is_finite());
        [self.mass.is_finite(), is_finite(&self.center), is_finite(&self.tensor)]
    }

    /// Returns the larger of the centre's distance from the origin and the radius of gyration, m.
    pub(super) fn reach(&self) -> f64 {
        let gyration = (trace(&self.tensor).abs() / (2.0 * self.mass.abs())).sqrt();
        f64::max(length(self.center), if gyration.is_finite() { gyration } else { 0.0 })
    }
}

/// Returns true if a deviation is within a limit. An infinite limit, from an overflow, permits only
/// equal numbers.
pub(super) fn within(deviation: f64, limit: f64) -> bool {
    deviation == 0.0 || deviation <= limit && limit.is_finite()
}

/// Returns the vector from one point to another.
pub(super) fn vector(from: [f64; 3], to: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|k| to[k] - from[k])
}

/// Returns the length of a vector, without overflow.
pub(super) fn length([x, y, z]: [f64; 3]) -> f64 {
    libm::hypot(libm::hypot(x, y), z)
}
