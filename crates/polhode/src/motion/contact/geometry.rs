//! Geometry of the surfaces of body and ground: the point of contact as a function of the normal,
//! and its derivative.

use super::model::{GroundForm, SurfaceForm};
use crate::math::algebra::{Components, Field};

impl GroundForm {
    /// Returns the normal and the point of contact, along the axes of the ground.
    #[inline(always)]
    pub(super) fn normal_and_position<S: Field>(self, one: S, [a, b, c]: [S; 3]) -> ([S; 3], [S; 3]) {
        let zero = one.times(0.0);
        match self {
            Self::Plane => ([zero, zero, one], [a, b, zero]),
            Self::Sphere { radius } => ([a, b, c], Components([a, b, c]).scaled(-radius).0),
            Self::Cylinder { radius } => ([a, b, zero], [a.times(-radius), b.times(-radius), c]),
        }
    }

    /// Returns K t; `axis` is the third axis of the ground.
    #[inline(always)]
    pub(super) fn curved<S: Field>(self, t: Components<S>, axis: Components<S>) -> Components<S> {
        match self {
            Self::Plane => t.scaled(0.0),
            Self::Sphere { radius } => t.scaled(1.0 / radius),
            Self::Cylinder { radius } => (t - axis * axis.dot(t)).scaled(1.0 / radius),
        }
    }
}

/// Point of a convex surface with outer normal −n, relative to its centre, and data for its
/// derivative with respect to n.
pub(super) struct SurfacePoint<S> {
    pub(super) from_center: Components<S>,
    form: SurfaceForm,
    /// A n for an ellipsoid; the unit vector along the rim for a rim.
    along: Components<S>,
    /// 1/d for an ellipsoid, with d² = n · A n; R/|n × z| for a rim.
    scale: S,
}

impl<S: Field> SurfacePoint<S> {
    /// Returns r′t, where r′ is a symmetric operator. Rim with tube radius ρ:
    /// −ρ t − R/|n × z| h (h · t). Ellipsoid: −A t/d + A n (A n · t)/d³.
    #[inline(always)]
    pub(super) fn change(&self, t: Components<S>) -> Components<S> {
        let (along, scale) = (self.along, self.scale);
        match self.form {
            SurfaceForm::Rim { radius: 0.0, tube, .. } => t.scaled(-tube),
            SurfaceForm::Rim { tube, .. } => t.scaled(-tube) - along * (along.dot(t) * scale),
            SurfaceForm::Ellipsoid { squares: [a, b, c] } => {
                let Components([x, y, z]) = t;
                let Components([p, q, r]) = along * (along.dot(t) * scale * scale);
                Components([p.plus_multiple(x, -a), q.plus_multiple(y, -b), r.plus_multiple(z, -c)]) * scale
            }
        }
    }
}

impl SurfaceForm {
    /// Returns the point with outer normal −n, relative to the centre.
    pub(super) fn point<S: Field>(&self, one: S, n: Components<S>) -> Components<S> {
        self.at(one, n).from_center
    }

    #[inline(always)]
    pub(super) fn at<S: Field>(self, one: S, n: Components<S>) -> SurfacePoint<S> {
        let (Components([x, y, z]), zero) = (n, one.times(0.0));
        match self {
            Self::Rim { radius: 0.0, tube, .. } => {
                SurfacePoint { from_center: n.scaled(-tube), form: self, along: n, scale: zero }
            }
            Self::Rim { radius, tube, height } => {
                let inverse = one / (x * x + y * y).root();
                let (c, s) = (x * inverse, y * inverse);
                let edge = Components([c.times(radius), s.times(radius), one.times(-height)]);
                SurfacePoint {
                    from_center: n.scaled(-tube) - edge,
                    form: self,
                    along: Components([-s, c, zero]),
                    scale: inverse.times(radius),
                }
            }
            Self::Ellipsoid { squares: [a, b, c] } => {
                let image = Components([x.times(a), y.times(b), z.times(c)]);
                let inverse = one / n.dot(image).root();
                SurfacePoint { from_center: -(image * inverse), form: self, along: image, scale: inverse }
            }
        }
    }
}
