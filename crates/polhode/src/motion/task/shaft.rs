//! Shafts: a body that turns about a line fixed in the body and in space, supported by two
//! bearings.
//!
//! All vectors are along body axes, in which the unbalance is constant. The line passes through the
//! point P along n, and the bearings are at P + z₁ n and P + z₂ n. Each bearing supports forces
//! normal to the line. One of them also supports the axial force, the thrust; which one does not
//! matter here. With r = c − P from P to the centre of mass:
//!
//! ```text
//! M a = F₁ + F₂ + M g,  a = α n × r + Ω² n × (n × r)
//! I_P α n + Ω² n × I_P n = n × (z₁ F₁ + z₂ F₂) + r × M g + N n
//! ```
//!
//! The component of the second equation along n gives the driving torque N. Its normal component,
//! crossed with n, gives the moment z₁ F₁ + z₂ F₂.
//!
//! Unbalance has two parts. The static unbalance is M e, with e the vector from the line to the
//! centre of mass; it is measurable at rest. The couple unbalance is ∫ z ρ dm = −(I n)⊥, with ρ the
//! vector from the line; it is measurable only in rotation. The shaft is balanced if both vanish.
//! Then the line is a principal axis through the centre of mass.

use crate::body::error::BodyError;
use crate::body::inertia::InertiaTensor;
use crate::body::mass_properties::MassProperties;
use crate::body::particles::Particle;
use crate::math::frame::Body;
use crate::math::vector::{
    Acceleration, AngularAcceleration, AngularVelocity, Direction, Force, Position, Torque, quantity,
};

use crate::motion::error::MotionError;
use crate::motion::model::kinematics::rigid_acceleration;
use crate::motion::model::require;

/// Body on a shaft with two bearings.
///
/// ```
/// use polhode::body::{InertiaTensor, MassProperties};
/// use polhode::math::{Acceleration, Direction, Position};
/// use polhode::motion::{Shaft, Unbalance};
/// // A disk of 12 kg, its centre 0.1 mm off a shaft along z, midway between the bearings, at 3000 rev/min.
/// let inertia = InertiaTensor::diagonal([0.05, 0.05, 0.09])?;
/// let disk = MassProperties::new(12.0, Position::new(1e-4, 0.0, 0.2), inertia)?;
/// let shaft = Shaft::new(disk, Position::ZERO, Direction::new(0.0, 0.0, 1.0), [0.0, 0.4])?;
/// let omega = 3000.0 * std::f64::consts::TAU / 60.0;
/// let held = shaft.reactions(omega, 0.0, Acceleration::ZERO);
/// // Each takes half of M e Ω², towards the line.
/// let each = -0.5 * 12.0 * 1e-4 * omega * omega;
/// assert!((held.bearings[0].x - each).abs() < 1e-12 && (held.bearings[1].x - each).abs() < 1e-12);
/// assert_eq!(shaft.unbalance(), Unbalance::Static);
/// // 20 g on the other side, 60 mm from the line in the plane of the disk, are as much: nothing is left.
/// let weight = shaft.balance_in_plane(0.2, 0.06)?;
/// assert!((weight.mass - 0.02).abs() < 1e-15 && (weight.position.x + 0.06).abs() < 1e-15);
/// assert_eq!(shaft.with(&[weight])?.unbalance(), Unbalance::None);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shaft {
    body: MassProperties<Body>,
    point: Position<Body>,
    axis: Direction<Body>,
    bearings: [f64; 2],
}

/// Reactions of the bearings and drive torque of a shaft at one time, body axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reactions {
    /// Force of each bearing on the shaft, normal to the line, N.
    pub bearings: [Force<Body>; 2],
    /// Axial force on the shaft along n, supported by one of the bearings, N.
    pub thrust: f64,
    /// Driving torque about n, N·m.
    pub torque: f64,
}

/// Kind of unbalance of a shaft (terms of ISO 21940-2).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unbalance {
    /// Balanced: the line is a principal axis through the centre of mass.
    None,
    /// Only the centre of mass is off the line; the line is parallel to a principal axis.
    Static,
    /// The centre of mass is on the line, but the line is not a principal axis.
    Couple,
    /// Both kinds, the usual case.
    Dynamic,
}

impl Unbalance {
    /// Returns the name in reports and JSON.
    pub const fn name(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Static => "static",
            Self::Couple => "couple",
            Self::Dynamic => "dynamic",
        }
    }
}

/// Mass to be added for balance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CorrectionMass {
    /// Position of its plane, normal to the line: distance from the shaft's point along n, m.
    pub plane: f64,
    /// Distance from the line, m.
    pub radius: f64,
    /// Mass to add, kg; zero if the plane needs none.
    pub mass: f64,
    /// Angle about n from [`Shaft::zero_mark`], right-handed, rad, in (−π, π]; zero if the mass is
    /// zero.
    pub angle: f64,
    /// Position of the mass, body axes, m.
    pub position: Position<Body>,
}

/// Threshold below which unbalance is rounding, relative to the largest that the size of the body
/// allows.
const ROUNDING: f64 = 1e-13;

impl Shaft {
    /// Creates a shaft: a body on a line through `point` along `axis`. `bearings` are the distances
    /// of the bearings from the point along the axis, m.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) if the axis is zero or not finite, or if
    /// the bearings coincide or are not finite.
    pub fn new(
        body: MassProperties<Body>,
        point: Position<Body>,
        axis: Direction<Body>,
        bearings: [f64; 2],
    ) -> Result<Self, MotionError> {
        let axis = require::direction("the length of the axis", axis)?;
        if !point.is_finite() {
            let (parameter, value) = ("the point on the axis", point.norm());
            return Err(MotionError::NonFiniteParameter { parameter, value });
        }
        let apart = bearings[1] - bearings[0];
        let rule = "finite and not zero: two bearings at one place hold no moment";
        let holds = apart != 0.0 && apart.is_finite();
        require::that("the distance between the bearings", apart, holds, rule)?;
        Ok(Self { body, point, axis, bearings })
    }

    /// Returns the rotating body.
    pub const fn body(&self) -> &MassProperties<Body> {
        &self.body
    }

    /// Returns the unit vector n along the line, body axes.
    pub const fn axis(&self) -> Direction<Body> {
        self.axis
    }

    /// Returns the point P on the line, body axes, m.
    pub const fn point(&self) -> Position<Body> {
        self.point
    }

    /// Returns the positions of the bearings: distances from P along n, m.
    pub const fn bearings(&self) -> [f64; 2] {
        self.bearings
    }

    /// Returns the moment of inertia about the line, kg·m².
    pub fn moment(&self) -> f64 {
        self.body.inertia_about(self.point).about_axis(self.axis)
    }

    /// Returns the static unbalance M e, body axes, kg·m; e is the vector from the line to the
    /// centre of mass.
    pub fn static_unbalance(&self) -> Position<Body> {
        self.across(self.arm()) * self.body.mass()
    }

    /// Returns the couple unbalance about a plane at `z` along the line, ∫ (z′ − z) ρ dm, body
    /// axes, kg·m². Its rotation requires a moment of magnitude Ω² times this.
    pub fn couple_unbalance(&self, z: f64) -> Position<Body> {
        // About the plane of the centre of mass, the couple follows from the products of inertia
        // about it.
        let own = self.body.inertia().symmetric().apply(self.axis.to_array());
        let own = -self.across(Position::from_array(own));
        own + self.static_unbalance() * (self.axis.dot(self.arm()) - z)
    }

    /// Returns the kind of unbalance, ignoring rounding.
    pub fn unbalance(&self) -> Unbalance {
        let center = self.axis.dot(self.arm());
        let (mass, greatest) = (self.body.mass(), self.body.inertia().about_axis(self.axis));
        let spread = self.body.inertia().symmetric().max_abs().max(greatest);
        // Scales of the accuracy of the centre of mass and of the tensor.
        let place = self.point.norm() + self.body.center_of_mass().norm() + (spread / mass).sqrt();
        let off = self.static_unbalance().norm() > ROUNDING * mass * place;
        let tilted = self.couple_unbalance(center).norm() > ROUNDING * spread;
        match (off, tilted) {
            (false, false) => Unbalance::None,
            (true, false) => Unbalance::Static,
            (false, true) => Unbalance::Couple,
            (true, true) => Unbalance::Dynamic,
        }
    }

    /// Returns the reactions of the bearings and the drive torque at the rate Ω, rad/s, and the
    /// acceleration α, rad/s². `gravity` is g along body axes at that time, m/s².
    pub fn reactions(&self, rate: f64, acceleration: f64, gravity: Acceleration<Body>) -> Reactions {
        let (n, r, mass) = (self.axis, self.arm(), self.body.mass());
        let omega: AngularVelocity<Body> = (n * rate).as_quantity();
        let alpha: AngularAcceleration<Body> = (n * acceleration).as_quantity();
        // S = F₁ + F₂ + thrust = M (a − g)
        let force: Force<Body> = ((rigid_acceleration(omega, alpha, r) - gravity) * mass).as_quantity();
        let weight: Force<Body> = (gravity * mass).as_quantity();
        // K = I_P α n + Ω² n × I_P n − r × M g
        let inertia = self.body.inertia_about(self.point);
        let momentum = inertia * omega;
        let moment: Torque<Body> = inertia * alpha + omega.cross(momentum) - r.cross(weight);
        // n × G = K⊥, so G = z₁ F₁ + z₂ F₂ = K × n
        let lever = moment.as_quantity::<quantity::Number>().cross(n);
        let [z1, z2] = self.bearings;
        let thrust = n.dot(force);
        let sum: Direction<Body> = force.as_quantity() - n * thrust;
        let second = (lever - sum * z1) / (z2 - z1);
        let first = (sum * z2 - lever) / (z2 - z1);
        Reactions { bearings: [first, second].map(Direction::as_quantity), thrust, torque: n.dot(moment) }
    }

    /// Returns the direction normal to the line from which angles of correction masses are
    /// measured. It is the normal component of the body's x axis, or of its y axis if x is nearly
    /// along the line.
    pub fn zero_mark(&self) -> Direction<Body> {
        let x = Direction::new(1.0, 0.0, 0.0);
        let mark = if self.axis.x.abs() < 0.9 { x } else { Direction::new(0.0, 1.0, 0.0) };
        (mark - self.axis * self.axis.dot(mark)).direction().unwrap_or(mark)
    }

    /// Returns the mass that balances the shaft statically, in a plane at `plane` along the line,
    /// m, at `radius` from the line, m.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) if the plane is not finite, or the
    /// radius is not positive.
    pub fn balance_in_plane(&self, plane: f64, radius: f64) -> Result<CorrectionMass, MotionError> {
        self.correction(plane, radius, -self.static_unbalance())
    }

    /// Returns the masses that balance the shaft, one in each of two planes (m along the line) at
    /// these radii, m.
    ///
    /// The conditions are `U_A` + `U_B` = −M e and `z_A` `U_A` + `z_B` `U_B` = −∫ z ρ dm. `U_B` is
    /// minus the couple about plane A divided by the distance of the planes. `U_A` is the same with
    /// the planes exchanged.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) if the planes coincide or are not
    /// finite, or if a radius is not positive.
    pub fn balance_in_planes(
        &self,
        planes: [f64; 2],
        radii: [f64; 2],
    ) -> Result<[CorrectionMass; 2], MotionError> {
        let [a, b] = planes;
        let apart = b - a;
        let rule = "finite and not zero: masses in one plane make no couple";
        let holds = apart != 0.0 && apart.is_finite();
        require::that("the distance between the planes", apart, holds, rule)?;
        Ok([
            self.correction(a, radii[0], self.couple_unbalance(b) / apart)?,
            self.correction(b, radii[1], self.couple_unbalance(a) / -apart)?,
        ])
    }

    /// Returns the shaft with masses added.
    ///
    /// # Errors
    /// [`BodyError`] if the sum is not finite.
    pub fn with(&self, masses: &[CorrectionMass]) -> Result<Self, BodyError> {
        let mut parts = vec![self.body];
        for added in masses.iter().filter(|added| added.mass > 0.0) {
            let particle = Particle::new(added.mass, added.position)?;
            let point = InertiaTensor::diagonal([0.0; 3])?;
            parts.push(MassProperties::new(particle.mass(), particle.position(), point)?);
        }
        Ok(Self { body: MassProperties::combined(&parts)?, ..*self })
    }

    /// Returns the vector from P to the centre of mass.
    fn arm(&self) -> Position<Body> {
        self.body.center_of_mass() - self.point
    }

    /// Returns the component normal to the line.
    fn across(&self, v: Position<Body>) -> Position<Body> {
        v - (self.axis * self.axis.dot(v)).as_quantity()
    }

    /// Returns the mass whose unbalance m ρ is `wanted`.
    fn correction(
        &self,
        plane: f64,
        radius: f64,
        wanted: Position<Body>,
    ) -> Result<CorrectionMass, MotionError> {
        require::finite("the plane", plane)?;
        require::positive("the radius", radius)?;
        let mark = self.zero_mark();
        let towards = wanted.direction().unwrap_or(mark);
        let on_axis = self.point + (self.axis * plane).as_quantity();
        Ok(CorrectionMass {
            plane,
            radius,
            mass: wanted.norm() / radius,
            // Half a turn is π, not −π: adding 0 changes −0 to 0.
            angle: libm::atan2(self.axis.cross(mark).dot(towards) + 0.0, mark.dot(towards)),
            position: on_axis + (towards * radius).as_quantity(),
        })
    }
}
