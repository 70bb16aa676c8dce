//! Mass, centre of mass and inertia tensor: all mass data that rigid-body motion depends on.

use core::fmt;

use super::error::{BodyError, finite, positive};
use super::inertia::{InertiaAbout, InertiaTensor};
use super::principal::PrincipalFrame;
use crate::math::display::Shown;
use crate::math::frame::{Body, Frame};
use crate::math::rotation::Rotation;
use crate::math::sum::Sum;
use crate::math::symmetric3::Symmetric3;
use crate::math::vector::Position;

/// Mass, centre of mass and inertia tensor about it, along the axes of `F`.
///
/// ```
/// use polhode::body::{InertiaTensor, MassProperties};
/// use polhode::math::{Body, Position};
/// // Schaub & Junkins: a tensor about the centre of mass, moved to another point by parallel axes
/// let inertia = InertiaTensor::<Body>::with_negative_products([10.0, 5.0, 8.0], [1.0, -1.0, 1.0])?;
/// let body = MassProperties::new(12.5, Position::new(-0.5, 0.5, 0.25), inertia)?;
/// let about_origin = body.inertia_about(Position::ZERO).matrix();
/// assert!((about_origin[0][0] - (10.0 + 12.5 * (0.25 + 0.0625))).abs() < 1e-14);
/// assert!((about_origin[0][1] - (1.0 + 12.5 * 0.25)).abs() < 1e-14);
/// # Ok::<(), polhode::body::BodyError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MassProperties<F: Frame> {
    mass: f64,
    center_of_mass: Position<F>,
    inertia: InertiaTensor<F>,
}

/// Mass, centre of mass and inertia tensor, with units.
impl<F: Frame> fmt::Display for MassProperties<F> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("mass ")?;
        Shown(self.mass).fmt(f)?;
        f.write_str(" kg, centre of mass ")?;
        self.center_of_mass.fmt(f)?;
        f.write_str(", inertia tensor ")?;
        self.inertia.fmt(f)
    }
}

impl<F: Frame> MassProperties<F> {
    /// Returns a body with the given mass, kg, and inertia tensor about its centre of mass.
    ///
    /// # Errors
    /// [`BodyError::Parameter`] if the mass is not positive or a number is not finite.
    pub fn new(mass: f64, center_of_mass: Position<F>, inertia: InertiaTensor<F>) -> Result<Self, BodyError> {
        positive("the mass", mass)?;
        finite("the centre of mass", center_of_mass.to_array())?;
        Ok(Self { mass, center_of_mass, inertia })
    }

    /// Returns a body whose tensor is known about another point, by the inverse of the
    /// parallel-axis theorem:
    ///
    /// I_ij = J_ij − M (a² δ_ij − a_i a_j), a from the point to the centre of mass
    ///
    /// If the difference is impossible by no more than its rounding (a plate far from the point),
    /// it is corrected to the nearest possible tensor.
    ///
    /// # Errors
    /// [`BodyError::Parameter`] if the mass is not positive or a number is not finite;
    /// [`BodyError::ImpossibleAtCenter`] if the difference is not a physical inertia tensor.
    pub fn from_inertia_about(
        mass: f64,
        center_of_mass: Position<F>,
        about: &InertiaAbout<F>,
    ) -> Result<Self, BodyError> {
        positive("the mass", mass)?;
        let lever = center_of_mass - about.point();
        let whole = about.symmetric();
        let rest = *whole - steiner(mass, lever);
        let inertia = InertiaTensor::from_difference(rest, whole.max_abs()).map_err(|error| match error {
            BodyError::NegativeMoment { moments } | BodyError::TriangleInequality { moments } => {
                let about = whole.eigen().values;
                BodyError::ImpossibleAtCenter { mass, lever: lever.to_array(), about, moments }
            }
            error => error,
        })?;
        Self::new(mass, center_of_mass, inertia)
    }

    /// Returns a body from its mass, centre of mass, and second moments about it per unit mass,
    /// ∫ x xᵀ dm / M.
    pub(crate) fn from_covariance(
        mass: f64,
        center_of_mass: Position<F>,
        covariance: &Symmetric3,
    ) -> Result<Self, BodyError> {
        let inertia = (*covariance * mass).inertia_of_second_moments();
        Self::new(mass, center_of_mass, InertiaTensor::from_symmetric(inertia)?)
    }

    /// Combines several bodies that are rigidly joined.
    ///
    /// M = Σ m_k,  M c = Σ m_k c_k,  I = Σ [I_k + m_k (d_k² 1 − d_k d_kᵀ)],  d_k = c_k − c.
    /// The sums are taken about a local reference, so that a position far from the origin costs no
    /// digits.
    ///
    /// # Errors
    /// [`BodyError::Empty`] if `parts` is empty; [`BodyError::Parameter`] if a sum is not finite.
    pub fn combined(parts: &[Self]) -> Result<Self, BodyError> {
        let centers: Vec<_> = parts.iter().map(|part| (part.mass, part.center_of_mass)).collect();
        let Center { mass, reference, rest } =
            Center::of(&centers).ok_or(BodyError::Empty { what: "parts" })?;
        let mut inertia = [Sum::default(); 6];
        for part in parts {
            let d = (part.center_of_mass - reference) - rest;
            let about_center = *part.inertia.symmetric() + steiner(part.mass, d);
            for (sum, element) in inertia.iter_mut().zip(about_center.elements()) {
                sum.add(element);
            }
        }
        let [xx, yy, zz, xy, xz, yz] = inertia.map(Sum::value);
        let inertia = InertiaTensor::from_symmetric(Symmetric3 { xx, yy, zz, xy, xz, yz })?;
        Self::new(mass, reference + rest, inertia)
    }

    /// Returns the mass, kg.
    pub const fn mass(&self) -> f64 {
        self.mass
    }

    /// Returns the centre of mass relative to the frame's origin, m.
    pub const fn center_of_mass(&self) -> Position<F> {
        self.center_of_mass
    }

    /// Returns the inertia tensor about the centre of mass, kg·m².
    pub const fn inertia(&self) -> &InertiaTensor<F> {
        &self.inertia
    }

    /// Returns the inertia tensor about any finite point, by Steiner's parallel-axis theorem:
    ///
    /// J_ij = I_ij + M (a² δ_ij − a_i a_j), a from the point to the centre of mass
    ///
    /// Source: Steiner's theorem, as in any text on mechanics; tested against Schaub's worked
    /// example.
    pub fn inertia_about(&self, point: Position<F>) -> InertiaAbout<F> {
        let steiner = steiner(self.mass, self.center_of_mass - point);
        InertiaAbout::moved(point, *self.inertia.symmetric() + steiner)
    }

    /// Returns the same body along the axes of `A`, with the same origin.
    pub fn in_frame<A: Frame>(&self, r: Rotation<A, F>) -> MassProperties<A> {
        self.moved(Position::ZERO, r)
    }

    /// Returns the same numbers as mass properties of a body, for a part that is the whole body and
    /// has the body's axes.
    ///
    /// ```
    /// use polhode::body::{InertiaTensor, MassProperties};
    /// use polhode::math::{Part, Position};
    /// use polhode::motion::Rotor;
    /// let inertia = InertiaTensor::<Part>::diagonal([1.0, 2.0, 2.5])?;
    /// let part = MassProperties::new(3.0, Position::new(0.1, 0.2, -0.3), inertia)?;
    /// assert_eq!(Rotor::free(&part.into_body()).principal().moments(), [1.0, 2.0, 2.5]);
    /// # Ok::<(), polhode::body::BodyError>(())
    /// ```
    pub fn into_body(self) -> MassProperties<Body> {
        self.in_frame(Rotation::identity())
    }

    /// Returns the body in a frame `A` in which this frame's origin is at `position`, m, and its
    /// axes are rotated by `r`.
    ///
    /// # Errors
    /// [`BodyError::Parameter`] if the position is not finite.
    pub fn placed<A: Frame>(
        &self,
        position: Position<A>,
        r: Rotation<A, F>,
    ) -> Result<MassProperties<A>, BodyError> {
        finite("the position", position.to_array())?;
        Ok(self.moved(position, r))
    }

    pub(super) fn moved<A: Frame>(&self, position: Position<A>, r: Rotation<A, F>) -> MassProperties<A> {
        // The identity rotation is the usual case; skipping it avoids rounding.
        let inertia =
            if r == Rotation::identity() { self.inertia.as_frame() } else { self.inertia.in_frame(r) };
        MassProperties { mass: self.mass, center_of_mass: position + r * self.center_of_mass, inertia }
    }

    /// Returns the principal moments and axes about the centre of mass.
    pub fn principal(&self) -> PrincipalFrame<F> {
        PrincipalFrame::of(&self.inertia)
    }

    /// Returns the radii of gyration about the three principal axes, √(i_k / M), m.
    pub fn gyration_radii(&self) -> [f64; 3] {
        self.principal().moments().map(|i| (i / self.mass).sqrt())
    }
}

/// Total mass and centre of mass of points, computed about a local reference to avoid loss of
/// digits.
pub(super) struct Center<F> {
    pub(super) mass: f64,
    /// Point near the centre of mass, m.
    pub(super) reference: Position<F>,
    /// Vector from the reference to the centre of mass, m; it holds the digits lost in rounding the
    /// reference.
    pub(super) rest: Position<F>,
}

impl<F: Frame> Center<F> {
    /// Computes the centre of masses at points; `None` if `points` is empty.
    pub(super) fn of(points: &[(f64, Position<F>)]) -> Option<Self> {
        let (_, first) = *points.first()?;
        let mut mass = Sum::default();
        for (m, _) in points {
            mass.add(*m);
        }
        let mass = mass.value();
        let from = |reference: Position<F>| {
            let mut moment = [Sum::default(); 3];
            for (m, p) in points {
                for (sum, d) in moment.iter_mut().zip((*p - reference).to_array()) {
                    sum.add(m * d);
                }
            }
            Position::from_array(moment.map(|s| s.value() / mass))
        };
        // The first point may be light and far away, so the sum is repeated about the centre found
        // first.
        let reference = first + from(first);
        Some(Self { mass, reference, rest: from(reference) })
    }
}

/// Returns M (a² 1 − a aᵀ), computed without cancellation.
fn steiner<F: Frame>(mass: f64, a: Position<F>) -> Symmetric3 {
    (Symmetric3::outer(a.to_array()) * mass).inertia_of_second_moments()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::frame::{Body, Part};

    /// Test body with distinct moments, non-zero products, mass ≠ 1, centre of mass off the origin,
    /// mixed signs.
    fn generic() -> MassProperties<Body> {
        let inertia = InertiaTensor::with_negative_products([3.1, 4.2, 5.3], [0.4, -0.3, 0.2]).unwrap();
        MassProperties::new(2.3, Position::new(0.11, -0.07, 0.23), inertia).unwrap()
    }

    #[test]
    fn parallel_axes_there_and_back() {
        let body = generic();
        let about = body.inertia_about(Position::new(-1.0, 0.4, 0.7));
        let again = MassProperties::from_inertia_about(body.mass(), body.center_of_mass(), &about).unwrap();
        let difference = *again.inertia().symmetric() - *body.inertia().symmetric();
        assert!(difference.max_abs() < 5e-15);
    }

    #[test]
    fn plates_and_rods_come_back_from_far_points() {
        use crate::body::shape::{Plate, Rod, Shape, Substance};
        let plate = Plate::new([0.7, 1.3]).unwrap().mass_properties(Substance::Mass(2.3)).unwrap();
        let rod = Rod::new(1.0).unwrap().mass_properties(Substance::Mass(0.6)).unwrap();
        for body in [plate, rod] {
            for distance in [1.0, 30.0, 100.0, 1e3, 1e4] {
                let point = Position::new(distance, -0.7 * distance, 0.3 * distance);
                let about = body.inertia_about(point);
                let again =
                    MassProperties::from_inertia_about(body.mass(), body.center_of_mass(), &about).unwrap();
                let difference = *again.inertia().symmetric() - *body.inertia().symmetric();
                assert!(difference.max_abs() < 4e-16 * about.symmetric().max_abs());
                // The result can be used like any other part.
                assert!(MassProperties::combined(&[again, body]).is_ok());
            }
        }
    }

    #[test]
    fn the_order_of_parts_does_not_matter() {
        let light = generic().placed(Position::new(1e9, 0.0, 0.0), Rotation::identity()).unwrap();
        let light =
            MassProperties::new(1e-30, light.center_of_mass(), InertiaTensor::diagonal([0.0; 3]).unwrap())
                .unwrap();
        let other = generic().placed(Position::new(0.5, -0.25, 1.0), Rotation::identity()).unwrap();
        let forward = MassProperties::combined(&[light, generic(), other]).unwrap();
        let backward = MassProperties::combined(&[other, generic(), light]).unwrap();
        let difference = *forward.inertia().symmetric() - *backward.inertia().symmetric();
        assert!(difference.max_abs() < 1e-15);
    }

    #[test]
    fn a_tensor_too_small_for_its_point_is_refused() {
        let point = Position::<Body>::new(0.1, -0.2, 0.3);
        let rows = [[1.1, 0.1, 0.0], [0.1, 1.2, -0.2], [0.0, -0.2, 1.3]];
        let about = InertiaAbout::from_matrix(point, rows).unwrap();
        // 2 kg at d = (1, 0.5, −0.4) m contribute 0.82, 2.32 and 2.5 kg·m² about the axes through
        // the point.
        let far = MassProperties::from_inertia_about(2.0, Position::new(1.1, 0.3, -0.1), &about);
        let Err(BodyError::ImpossibleAtCenter { mass, lever, about: [j1, .., j3], moments: [i1, i2, i3] }) =
            far
        else {
            unreachable!("{far:?}")
        };
        assert_eq!(mass, 2.0);
        assert!(lever.iter().zip([1.0, 0.5, -0.4]).all(|(d, want)| (d - want).abs() < 1e-15));
        assert!(j1 > 0.9 && j3 < 1.5);
        // Traces: tr I = tr J − 2 M d².
        assert!((i1 + i2 + i3 - (3.6 - 4.0 * 1.41)).abs() < 1e-14 && i1 < 0.0);
    }

    #[test]
    fn the_principal_frame_turns_with_the_body() {
        let body = generic();
        let r = Rotation::<Part, Body>::from_quaternion([0.4, -0.7, 1.1, 0.3]).unwrap();
        let turned = body.in_frame(r);
        for (a, b) in body.principal().moments().iter().zip(turned.principal().moments()) {
            assert!((a / b - 1.0).abs() < 2e-15);
        }
        let axis = r * body.principal().axis(2);
        assert!(axis.dot(turned.principal().axis(2)).abs() > 1.0 - 1e-15);
        assert!((turned.center_of_mass() - r * body.center_of_mass()).norm() < 1e-16);
    }

    #[test]
    fn joining_parts_far_from_the_origin_loses_nothing() {
        let far = Position::<Body>::new(1e6, -2e6, 4e6);
        let pair = |origin: Position<Body>| {
            let at = |d: [f64; 3]| {
                generic().placed(origin + Position::from_array(d), Rotation::identity()).unwrap()
            };
            // Offsets that the far coordinates represent exactly.
            MassProperties::combined(&[at([0.0; 3]), at([0.5, -0.25, 1.0]), at([2.0, 0.125, -0.5])]).unwrap()
        };
        let near = MassProperties::combined(&[pair(Position::ZERO)]).unwrap();
        let difference = *pair(far).inertia().symmetric() - *near.inertia().symmetric();
        // The parts' own centres 0.11, −0.07, 0.23 are rounded at 4e6 m: by 5e-10 m.
        assert!(difference.max_abs() < 5e-9);
    }
}
