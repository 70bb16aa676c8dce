//! Principal moments and axes with their errors.

use polhode::body::{MassPropertiesGradient, PrincipalFrame};
use polhode::infer::covariance::mirrored;
use polhode::math::{Direction, Frame};

use crate::estimate::Estimate;

/// Principal moments and axes, with their errors and derivatives.
///
/// First order in δI gives δiₖ = aₖ·δI aₖ. With (i, j, k) cyclic, it also gives the rotation of all
/// axes about aₖ by θₖ = aⱼ·δI aᵢ/(iᵢ − iⱼ). If errors are not small compared with the difference
/// of two moments, first order is not valid for the rotation about the third axis. In this case,
/// use [`Draws`](crate::Draws).
#[derive(Clone, Debug, PartialEq)]
pub struct PrincipalUncertainty<F: Frame> {
    /// Principal moments in ascending order, with their axes.
    pub frame: PrincipalFrame<F>,
    /// Covariance of the moments, kg²·m⁴.
    pub moment_covariance: [[f64; 3]; 3],
    /// Standard deviation of the rotation of all axes about each axis, rad. It is infinite if the
    /// other two moments are equal, unless the tensor is exact.
    pub turn_sd: [f64; 3],
}

/// Validity limit of first order. It applies to the standard deviation of the difference of two
/// moments, relative to that difference, and to the rotation of their axes, rad.
const NEAR: f64 = 0.3;

/// Angle between a principal axis, in either sense, and a direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tilt<F> {
    /// Angle from 0 to π/2 rad.
    pub angle: f64,
    /// Standard deviation of the angle, rad. It is valid if the angle is several times
    /// [`Tilt::axis_sd`]. `None` at the angle 0, where the derivative does not exist, and if
    /// moments are equal.
    pub sd: Option<f64>,
    /// Standard deviation of the axis in its most uncertain direction, rad.
    pub axis_sd: f64,
    /// Gradient of the angle with respect to the tensor, if it exists.
    pub gradient: Option<MassPropertiesGradient<F>>,
}

impl<F: Frame> Estimate<F> {
    /// Returns the principal moments and axes with their errors.
    pub fn principal(&self) -> PrincipalUncertainty<F> {
        let frame = self.properties.principal();
        let gradients = [0, 1, 2].map(|k| moment_gradient(&frame, k));
        let moment_covariance = gradients.map(|a| gradients.map(|b| self.covariance_of(&a, &b)));
        let turn_sd = [0, 1, 2].map(|k| {
            let (numerator, apart) = turn(&frame, k);
            quotient(self.sd_of(&numerator), apart.abs())
        });
        PrincipalUncertainty { frame, moment_covariance: mirrored(&moment_covariance), turn_sd }
    }
}

impl<F: Frame> PrincipalUncertainty<F> {
    /// Returns the gradient of a moment, 0 to 2, with respect to the tensor.
    pub fn moment_gradient(&self, k: usize) -> MassPropertiesGradient<F> {
        moment_gradient(&self.frame, k % 3)
    }

    /// Returns true if first order is valid for the error of a moment, 0 to 2. It is not valid if
    /// another moment is so near that errors can make them equal.
    pub fn is_first_order(&self, k: usize) -> bool {
        (0..3).filter(|other| *other != k % 3).all(|other| self.are_apart(k % 3, other))
    }

    fn are_apart(&self, i: usize, j: usize) -> bool {
        const ROUNDING: f64 = 1e-14;
        let (moments, c) = (self.frame.moments(), &self.moment_covariance);
        let variance = c[i][i] + c[j][j] - 2.0 * c[i][j];
        let sd = if variance > ROUNDING * (c[i][i] + c[j][j]) { variance.sqrt() } else { 0.0 };
        let turn = self.turn_sd[3 - i - j];
        sd <= NEAR * (moments[i] - moments[j]).abs() && turn <= NEAR
    }

    /// Returns the gradient of the rotation about an axis, 0 to 2. Returns `None` if the other two
    /// moments are equal.
    pub fn turn_gradient(&self, k: usize) -> Option<MassPropertiesGradient<F>> {
        let (numerator, apart) = turn(&self.frame, k % 3);
        (apart != 0.0).then(|| scaled(&numerator, 1.0 / apart))
    }

    /// Returns the tilt of an axis, 0 to 2, from a direction; `None` if the direction is zero or
    /// not finite.
    pub fn tilt(&self, estimate: &Estimate<F>, axis: usize, from: Direction<F>) -> Option<Tilt<F>> {
        from.direction().map(|n| self.tilt_from(estimate, axis, n))
    }

    /// Returns the tilt from a unit vector.
    pub(crate) fn tilt_from(&self, estimate: &Estimate<F>, axis: usize, n: Direction<F>) -> Tilt<F> {
        let k = axis % 3;
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        let [a, u, v] = [k, i, j].map(|k| self.frame.axis(k));
        let (n, along) = if n.dot(a) < 0.0 { (-n, -n.dot(a)) } else { (n, n.dot(a)) };
        let across = n.dot(u).hypot(n.dot(v));
        let angle = across.atan2(along);
        let (Some(about_u), Some(about_v)) = (self.turn_gradient(i), self.turn_gradient(j)) else {
            let axis_sd = self.turn_sd[i].max(self.turn_sd[j]);
            return Tilt { angle, sd: None, axis_sd, gradient: None };
        };
        // δa = θᵢ u × a + θⱼ v × a = θⱼ u − θᵢ v
        let covariance = |a, b| estimate.covariance_of(a, b);
        let (uu, vv, uv) =
            (covariance(&about_u, &about_u), covariance(&about_v, &about_v), covariance(&about_u, &about_v));
        let axis_sd = (0.5 * (uu + vv) + (0.5 * (uu - vv)).hypot(uv)).max(0.0).sqrt();
        // dα = −n·δa/sin α
        let gradient = (across > 0.0)
            .then(|| sum(&scaled(&about_v, -n.dot(u) / across), &scaled(&about_u, n.dot(v) / across)));
        Tilt { angle, sd: gradient.map(|gradient| estimate.sd_of(&gradient)), axis_sd, gradient }
    }
}

fn quotient(sd: f64, apart: f64) -> f64 {
    if sd == 0.0 { 0.0 } else { sd / apart }
}

pub(crate) fn moment_gradient<F: Frame>(frame: &PrincipalFrame<F>, k: usize) -> MassPropertiesGradient<F> {
    element(frame.axis(k), frame.axis(k))
}

/// Returns aⱼ·δI aᵢ as a gradient, and the difference iᵢ − iⱼ.
fn turn<F: Frame>(frame: &PrincipalFrame<F>, k: usize) -> (MassPropertiesGradient<F>, f64) {
    let (i, j) = ((k + 1) % 3, (k + 2) % 3);
    (element(frame.axis(i), frame.axis(j)), frame.moments()[i] - frame.moments()[j])
}

/// Returns uᵀ δI v as a gradient.
pub(crate) fn element<F: Frame>(u: Direction<F>, v: Direction<F>) -> MassPropertiesGradient<F> {
    let (u, v) = (u.to_array(), v.to_array());
    let off = |i: usize, j: usize| u[i] * v[j] + u[j] * v[i];
    MassPropertiesGradient {
        by_mass: 0.0,
        by_center_of_mass: Direction::ZERO,
        by_inertia: [u[0] * v[0], u[1] * v[1], u[2] * v[2], off(0, 1), off(0, 2), off(1, 2)],
    }
}

pub(crate) fn scaled<F: Frame>(
    gradient: &MassPropertiesGradient<F>,
    factor: f64,
) -> MassPropertiesGradient<F> {
    MassPropertiesGradient {
        by_mass: gradient.by_mass * factor,
        by_center_of_mass: gradient.by_center_of_mass * factor,
        by_inertia: gradient.by_inertia.map(|x| x * factor),
    }
}

pub(crate) fn sum<F: Frame>(
    a: &MassPropertiesGradient<F>,
    b: &MassPropertiesGradient<F>,
) -> MassPropertiesGradient<F> {
    MassPropertiesGradient {
        by_mass: a.by_mass + b.by_mass,
        by_center_of_mass: a.by_center_of_mass + b.by_center_of_mass,
        by_inertia: core::array::from_fn(|k| a.by_inertia[k] + b.by_inertia[k]),
    }
}
