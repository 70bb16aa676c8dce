//! Reduced equations of a body on level ground, without the position and the rotation about the
//! vertical, on which they do not depend.
//!
//! The remaining variables are n, the upward vertical along the axes of the body's surface, and ω.
//! With viscous sliding friction the velocity v of the centre of mass is added. Without friction,
//! the horizontal velocity is constant and has no effect.
//!
//! These variables are constant in a steady motion, or turn about the axis of a symmetric body at a
//! rate σ. With x = (n, ω, v), ẋ = f(x) and the axis e,
//!
//! f(x) + σ e × x = 0, δẋ = f′(x) δx + σ e × δx.
//!
//! f′ is exact: f is evaluated over dual numbers.

use super::arrangement::Contact;
use super::dual::Dual;
use super::equations::{AXES, OMEGA, PLACE, Pivot, Regime, VELOCITY};
use super::ground::GroundShape;
use super::law::Grip;
use super::model::{Model, SurfaceForm};
use super::surface::SurfaceShape;
use crate::body::mass_properties::MassProperties;
use crate::math::algebra::{Components, Field};
use crate::math::frame::{Body, Part};
use crate::math::rotation::Rotation;
use crate::math::vector::Direction;
use crate::motion::error::MotionError;
use crate::motion::model::require;

/// Tangential force at the contact for a perturbation of a steady motion without slip.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Footing {
    /// Constraint force: the body rolls.
    Rolling,
    /// No force.
    Frictionless,
    /// Force opposite and proportional to the slip.
    Viscous,
}

impl Footing {
    /// Returns the name in JSON: `rolling`, `frictionless` or `viscous`.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Rolling => "rolling",
            Self::Frictionless => "frictionless",
            Self::Viscous => "viscous",
        }
    }
}

/// Body on level ground, with its equations in n, ω and v.
#[derive(Clone, Debug)]
pub(crate) struct Reduced {
    model: Model,
    footing: Footing,
    /// Unit vector along the axis of a symmetric body.
    axis: Option<[f64; 3]>,
}

/// n, ω and v along the axes of the surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Reading {
    pub(crate) normal: [f64; 3],
    pub(crate) omega: [f64; 3],
}

/// Relative threshold below which a violation of symmetry is rounding.
const SYMMETRIC: f64 = 1e-9;

/// Maximum number of variables: two of n, three of ω, two of v.
pub(crate) const MOST: usize = 7;

impl Reduced {
    /// Creates the reduced equations.
    ///
    /// # Errors
    /// [`MotionError::NoSteadyMotion`] if the ground is curved, turning or inclined, if there is
    /// rolling or pivoting resistance, or for a lying cylinder.
    pub(crate) fn new(body: &MassProperties<Body>, contact: &Contact) -> Result<Self, MotionError> {
        let refused = |why| Err(MotionError::NoSteadyMotion { why });
        let model = Model::of(body, &contact.surface, &contact.ground, &contact.law, contact.gravity, 0.0);
        let [x, y, down] = model.gravity;
        let resistance = contact.law.resistance();
        if *contact.ground.shape() != GroundShape::Plane {
            return refused(
                "the ground is curved, and the steady motions of bodies on level ground are known here",
            );
        }
        if contact.ground.turning() != 0.0 {
            return refused(
                "the ground turns, and the steady motions of bodies on ground at rest are known here",
            );
        }
        if down >= 0.0 {
            return refused("gravity does not press the body onto the ground");
        }
        if x.hypot(y) > SYMMETRIC * down.abs() {
            return refused(
                "the ground is not level, and the steady motions of bodies on level ground are known here",
            );
        }
        if resistance.rolling != 0.0 || resistance.pivoting != 0.0 {
            return refused(
                "torques resist rolling or pivoting: every motion slows down, and none is steady",
            );
        }
        match contact.surface.shape() {
            SurfaceShape::Cylinder { .. } => {
                return refused("a cylinder that lies keeps its axis level: nothing departs from its motion");
            }
            SurfaceShape::Rim { thickness, .. } if *thickness > 0.0 => {
                return refused(
                    "a thick disk upright stands on both of its rims: say thickness zero for a thin one",
                );
            }
            _ => {}
        }
        let friction = contact.law.friction();
        let footing = match contact.law.grip() {
            Grip::NoSlip => Footing::Rolling,
            Grip::Friction(_) if friction.sticking > 0.0 => Footing::Rolling,
            Grip::Friction(_) if friction.viscous > 0.0 => Footing::Viscous,
            Grip::Friction(_) => Footing::Frictionless,
        };
        for row in model.inverse_inertia {
            for element in row {
                require::finite("the inverse of the tensor of inertia", element)?;
            }
        }
        let axis = symmetry_axis(&model);
        Ok(Self { model, footing, axis })
    }

    pub(crate) const fn footing(&self) -> Footing {
        self.footing
    }

    pub(crate) const fn axis(&self) -> Option<[f64; 3]> {
        self.axis
    }

    pub(crate) const fn mass(&self) -> f64 {
        self.model.mass
    }

    /// Returns g, m/s².
    pub(crate) fn gravity(&self) -> f64 {
        -self.model.gravity[2]
    }

    /// Returns the vector from the centre of mass to the centre of the surface.
    pub(crate) const fn offset(&self) -> [f64; 3] {
        self.model.offset
    }

    /// Returns the radius if the surface is a sphere.
    pub(crate) fn sphere(&self) -> Option<f64> {
        match self.model.surface {
            SurfaceForm::Rim { radius: 0.0, tube, .. } => Some(tube),
            _ => None,
        }
    }

    /// True unless a disk lies on its face, where it touches along its rim.
    pub(crate) const fn touches_in_a_point(&self) -> bool {
        !matches!(self.model.surface, SurfaceForm::Rim { radius, .. } if radius != 0.0)
    }

    /// Returns the rotation of the surface axes in the body.
    pub(crate) const fn in_body(&self) -> Rotation<Body, Part> {
        self.model.in_body
    }

    /// Returns I v.
    pub(crate) fn image(&self, v: [f64; 3]) -> [f64; 3] {
        self.model.inertia.map(|row| dot(row, v))
    }

    /// Returns the vector from the centre of mass to the point of contact.
    pub(crate) fn arm(&self, normal: [f64; 3]) -> [f64; 3] {
        let Components(r) = self.model.surface.point(1.0, Components(normal));
        core::array::from_fn(|k| r[k] + self.model.offset[k])
    }

    /// Returns −r′ along two tangents: the radii of curvature of the surface at the contact.
    pub(crate) fn radii(&self, normal: [f64; 3], tangents: [[f64; 3]; 2]) -> [[f64; 2]; 2] {
        let columns = tangents.map(|t| {
            let n = core::array::from_fn(|k| Dual::new(normal[k], t[k]));
            self.model.surface.point(Dual::ONE, Components(n)).0.map(|x| -x.slope)
        });
        core::array::from_fn(|i| core::array::from_fn(|j| dot(tangents[i], columns[j])))
    }

    /// Returns n and ω of an attitude.
    pub(crate) fn reading(&self, up: Direction<Body>, omega: [f64; 3]) -> Reading {
        let omega = self.model.in_body.inverse() * Direction::<Body>::from_array(omega);
        Reading { normal: (self.model.in_body.inverse() * up).to_array(), omega: omega.to_array() }
    }

    /// Returns the rate σ at which n turns about the body's axis in a steady motion. It is zero for
    /// a body without an axis, and if n is along it.
    pub(crate) fn turning(&self, at: &Reading) -> f64 {
        let Some(e) = self.axis else { return 0.0 };
        // n × ω + σ e × n = 0
        let (moved, along) = (cross(at.normal, at.omega), cross(e, at.normal));
        let square = dot(along, along);
        if square < SYMMETRIC { 0.0 } else { -dot(moved, along) / square }
    }

    /// Returns the norm of f(x) + σ e × x relative to the square of the rate; zero for a steady
    /// motion.
    pub(crate) fn unsteadiness(&self, at: &Reading) -> f64 {
        let rates = self.rates(1.0, at.normal, at.omega, self.velocity(at));
        let turning = self.turned(at);
        let (rate, v) = (self.rate(at), self.velocity(at));
        let [n, w, v] = [(rates[0], at.normal), (rates[1], at.omega), (rates[2], v)].map(|(rate, x)| {
            let turned = cross(turning, x);
            let left: [f64; 3] = core::array::from_fn(|k| rate[k] + turned[k]);
            dot(left, left).sqrt()
        });
        let v = if self.footing == Footing::Viscous { v } else { 0.0 };
        let size = dot(self.arm(at.normal), self.arm(at.normal)).sqrt();
        (n / rate).max(w / (rate * rate)).max(v / (size * rate * rate))
    }

    /// Returns the rate of the motion: |ω|, or √(g/r).
    pub(crate) fn rate(&self, at: &Reading) -> f64 {
        let arm = self.arm(at.normal);
        dot(at.omega, at.omega).sqrt().max((self.gravity() / dot(arm, arm).sqrt()).sqrt())
    }

    /// Returns the matrix of the linearised equations in (two of n, ω, two of v), and the number of
    /// variables. Units are the rate, the arm, and one over the rate for time.
    pub(crate) fn linearised(&self, at: &Reading) -> ([[f64; MOST]; MOST], usize) {
        let count = if self.footing == Footing::Viscous { MOST } else { 5 };
        let rate = self.rate(at);
        let size = dot(self.arm(at.normal), self.arm(at.normal)).sqrt();
        let scales = [1.0, 1.0, rate, rate, rate, rate * size, rate * size];
        let columns: [[f64; MOST]; MOST] = core::array::from_fn(|k| match k < count {
            true => self.slope(at, core::array::from_fn(|i| if i == k { scales[i] } else { 0.0 })),
            false => [0.0; MOST],
        });
        let element = |i: usize, j: usize| columns[j][i] / (scales[i] * rate);
        (core::array::from_fn(|i| core::array::from_fn(|j| element(i, j))), count)
    }

    /// Returns the rates of the variables of `linearised` for a change of them.
    fn slope(&self, at: &Reading, [p, q, x, y, z, a, b]: [f64; MOST]) -> [f64; MOST] {
        let [s, t] = tangents(at.normal, self.axis);
        let in_ground = |a: f64, b: f64| core::array::from_fn(|k| a * s[k] + b * t[k]);
        let joined = |x: [f64; 3], dx: [f64; 3]| core::array::from_fn(|k| Dual::new(x[k], dx[k]));
        let (n, omega) = (joined(at.normal, in_ground(p, q)), joined(at.omega, [x, y, z]));
        let v = self.touching(n, omega, joined(self.velocity(at), in_ground(a, b)));
        let rates = self.rates(Dual::ONE, n, omega, v);
        let turning = self.turned(at);
        let [dn, [x, y, z], dv] = [(rates[0], n), (rates[1], omega), (rates[2], v)].map(|(rates, x)| {
            let turned = cross(turning, x.map(|x| x.slope));
            core::array::from_fn::<f64, 3, _>(|k| rates[k].slope + turned[k])
        });
        [dot(s, dn), dot(t, dn), x, y, z, dot(s, dv), dot(t, dv)]
    }

    /// Returns the rates of n, ω and v.
    fn rates<S: Field>(&self, one: S, n: [S; 3], omega: [S; 3], v: [S; 3]) -> [[S; 3]; 3] {
        let regime = if self.footing == Footing::Rolling { Regime::Rolling } else { Regime::Sliding };
        let mut y = vec![one.times(0.0); Model::count(regime)];
        // Gravity is along the third axis of the ground, and the first axis is not used.
        y[AXES + 3..OMEGA].copy_from_slice(&n);
        y[OMEGA..PLACE].copy_from_slice(&omega);
        if regime == Regime::Sliding {
            y[VELOCITY..VELOCITY + 3].copy_from_slice(&v);
        }
        let (rates, _) = self.model.rates(one, &y, regime, Pivot::Turning(0.0));
        let vector = |first: usize| core::array::from_fn(|k| rates[first + k]);
        let v = if regime == Regime::Sliding { vector(VELOCITY) } else { [one.times(0.0); 3] };
        [vector(AXES + 3), vector(OMEGA), v]
    }

    /// Returns v without slip.
    fn velocity(&self, at: &Reading) -> [f64; 3] {
        cross(self.arm(at.normal), at.omega)
    }

    /// Returns v with the component along n that keeps the body on the ground.
    fn touching(&self, n: [Dual; 3], w: [Dual; 3], v: [Dual; 3]) -> [Dual; 3] {
        let (n, w, v) = (Components(n), Components(w), Components(v));
        let arm =
            self.model.surface.point(Dual::ONE, n) + Components(self.model.offset.map(|x| Dual::new(x, 0.0)));
        let leaving = n.dot(v + w.cross(arm)) / n.dot(n);
        (v - n * leaving).0
    }

    /// Returns σ e.
    fn turned(&self, at: &Reading) -> [f64; 3] {
        let rate = self.turning(at);
        self.axis.map_or([0.0; 3], |e| e.map(|x| x * rate))
    }
}

/// Returns two unit vectors normal to n; the second is as close to the axis as possible.
pub(crate) fn tangents(n: [f64; 3], axis: Option<[f64; 3]>) -> [[f64; 3]; 2] {
    let unit = |k: usize| core::array::from_fn::<f64, 3, _>(|i| if i == k { 1.0 } else { 0.0 });
    let least =
        if n[0].abs() <= n[1].abs().min(n[2].abs()) { 0 } else { usize::from(n[1].abs() > n[2].abs()) + 1 };
    let across = axis.map(|e| cross(e, n)).filter(|t| dot(*t, *t) > SYMMETRIC);
    let first = across.unwrap_or_else(|| cross(unit(least), n));
    let length = dot(first, first).sqrt();
    let first = first.map(|x| x / length);
    [first, cross(n, first)]
}

impl Contact {
    /// Returns the axis about which the body and its surface are symmetric. For a ball whose centre
    /// of mass is not its centre, it points from the centre of mass to the centre.
    pub fn symmetry_axis(&self, body: &MassProperties<Body>) -> Option<Direction<Body>> {
        let model = Model::of(body, &self.surface, &self.ground, &self.law, self.gravity, 0.0);
        let axis = symmetry_axis(&model)?;
        Some(model.in_body * Direction::<Part>::from_array(axis))
    }
}

/// Returns the axis about which body and surface are symmetric.
fn symmetry_axis(model: &Model) -> Option<[f64; 3]> {
    let unit = |k: usize| core::array::from_fn::<f64, 3, _>(|i| if i == k { 1.0 } else { 0.0 });
    let length = dot(model.offset, model.offset).sqrt();
    let candidates: Vec<[f64; 3]> = match model.surface {
        SurfaceForm::Rim { radius: 0.0, tube, .. } if length > SYMMETRIC * tube => {
            vec![model.offset.map(|x| x / length)]
        }
        SurfaceForm::Rim { radius: 0.0, .. } => (0..3).map(unit).collect(),
        SurfaceForm::Rim { .. } => vec![unit(2)],
        SurfaceForm::Ellipsoid { squares } => {
            let same = |i: usize, j: usize| (squares[i] - squares[j]).abs() <= SYMMETRIC * squares[i];
            (0..3).filter(|&k| same((k + 1) % 3, (k + 2) % 3)).map(unit).collect()
        }
    };
    let size = model.inertia.iter().flatten().fold(0.0, |most: f64, x| most.max(x.abs()));
    candidates.into_iter().find(|&e| {
        let across = cross(model.offset, e);
        let [s, t] = tangents(e, None);
        let moment = |a: [f64; 3], b: [f64; 3]| dot(a, model.inertia.map(|row| dot(row, b)));
        let left = [moment(s, e), moment(t, e), moment(s, t), moment(s, s) - moment(t, t)];
        dot(across, across).sqrt() <= SYMMETRIC * length && left.iter().all(|x| x.abs() <= SYMMETRIC * size)
    })
}

pub(crate) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(crate) fn cross([a, b, c]: [f64; 3], [x, y, z]: [f64; 3]) -> [f64; 3] {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}
