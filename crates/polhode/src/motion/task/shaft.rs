//! A shaft: a body that turns about a line fixed in it and in space, held by two bearings.
//!
//! All is seen along body axes, which turn with the shaft: there the unbalance stands still. The line goes through the point
//! P along n, the bearings are at P + z₁ n and P + z₂ n. A bearing holds across the line; along it one of them has to hold
//! too, and which one is not asked: that force is the thrust. With r = c − P from P to the centre of mass:
//!
//! ```text
//! M a = F₁ + F₂ + M g,  a = α n × r + Ω² n × (n × r)
//! I_P α n + Ω² n × I_P n = n × (z₁ F₁ + z₂ F₂) + r × M g + N n
//! ```
//!
//! The part of the second along n gives the driving torque N, the part across it, crossed with n, the moment z₁ F₁ + z₂ F₂.
//!
//! Unbalance has two parts. Static: M e, e the centre of mass from the line; it shows at rest, where the heavy side sinks.
//! Of the couple: ∫ z ρ dm = −(I n)⊥, ρ from the line; it shows in turning only. The shaft is balanced where both vanish, and
//! then the line is a principal axis through the centre of mass.

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

/// A body on a shaft with two bearings.
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

/// What holds and drives a shaft at one time, along body axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reactions {
    /// The force of each bearing on the shaft, across the line, N.
    pub bearings: [Force<Body>; 2],
    /// The force along the line that one of them has to hold, along n, N.
    pub thrust: f64,
    /// The torque about n that drives it, N·m.
    pub torque: f64,
}

/// How the mass lies about the line of a shaft (the words of ISO 21940-2).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unbalance {
    /// Balanced: the line is a principal axis through the centre of mass.
    None,
    /// The line is parallel to a principal axis: the centre of mass is off it, and nothing else.
    Static,
    /// The centre of mass is on the line, which is no principal axis.
    Couple,
    /// Both: the usual case.
    Dynamic,
}

impl Unbalance {
    /// The name in reports and JSON.
    pub const fn name(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Static => "static",
            Self::Couple => "couple",
            Self::Dynamic => "dynamic",
        }
    }
}

/// A mass to be added for balance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CorrectionMass {
    /// The plane across the line that it is in: its distance from the shaft's point along n, m.
    pub plane: f64,
    /// Its distance from the line, m.
    pub radius: f64,
    /// Its mass, kg; zero where the plane needs none.
    pub mass: f64,
    /// Its angle about n, right-handed, from [`Shaft::zero_mark`], rad, in (−π, π]; zero where the mass is.
    pub angle: f64,
    /// Where it goes, body axes, m.
    pub position: Position<Body>,
}

/// Unbalance below this part of what the body's size could make is rounding.
const ROUNDING: f64 = 1e-13;

impl Shaft {
    /// A body on a line through `point` along `axis`, with bearings at two distances from the point along the axis, m.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) for an axis without direction, or bearings at one place or nowhere.
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

    /// What turns.
    pub const fn body(&self) -> &MassProperties<Body> {
        &self.body
    }

    /// The unit vector n along the line, body axes.
    pub const fn axis(&self) -> Direction<Body> {
        self.axis
    }

    /// The point P on the line, body axes, m.
    pub const fn point(&self) -> Position<Body> {
        self.point
    }

    /// Where the bearings are: distances from P along n, m.
    pub const fn bearings(&self) -> [f64; 2] {
        self.bearings
    }

    /// The moment of inertia about the line, kg·m².
    pub fn moment(&self) -> f64 {
        self.body.inertia_about(self.point).about_axis(self.axis)
    }

    /// The static unbalance M e, kg·m: e leads from the line to the centre of mass.
    pub fn static_unbalance(&self) -> Position<Body> {
        self.across(self.arm()) * self.body.mass()
    }

    /// The unbalance of the couple about a plane at `z` along the line, ∫ (z′ − z) ρ dm, kg·m²: its turning asks for the moment
    /// Ω² of that size.
    pub fn couple_unbalance(&self, z: f64) -> Position<Body> {
        // About the plane of the centre of mass the couple is of the body's own products of inertia.
        let own = self.body.inertia().symmetric().apply(self.axis.to_array());
        let own = -self.across(Position::from_array(own));
        own + self.static_unbalance() * (self.axis.dot(self.arm()) - z)
    }

    /// What is unbalanced, but for rounding.
    pub fn unbalance(&self) -> Unbalance {
        let center = self.axis.dot(self.arm());
        let (mass, greatest) = (self.body.mass(), self.body.inertia().about_axis(self.axis));
        let spread = self.body.inertia().symmetric().max_abs().max(greatest);
        // What the place of the centre of mass, and the tensor, are known to.
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

    /// What the bearings and the drive have to do at the rate Ω, rad/s, and the acceleration α, rad/s², under the gravity g,
    /// along body axes at that moment, m/s².
    pub fn reactions(&self, rate: f64, acceleration: f64, gravity: Acceleration<Body>) -> Reactions {
        let (n, r, mass) = (self.axis, self.arm(), self.body.mass());
        let omega: AngularVelocity<Body> = (n * rate).as_quantity();
        let alpha: AngularAcceleration<Body> = (n * acceleration).as_quantity();
        // S = F₁ + F₂ + the thrust = M (a − g)
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

    /// The direction across the line from which angles of correction masses count: the body's x axis as far as it is across the
    /// line, or its y axis where x is nearly along it.
    pub fn zero_mark(&self) -> Direction<Body> {
        let x = Direction::new(1.0, 0.0, 0.0);
        let mark = if self.axis.x.abs() < 0.9 { x } else { Direction::new(0.0, 1.0, 0.0) };
        (mark - self.axis * self.axis.dot(mark)).direction().unwrap_or(mark)
    }

    /// The mass that balances the shaft statically, in a plane at `plane` along the line, m, at `radius` from it, m.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) for a plane that is not finite or a radius that is not positive.
    pub fn balance_in_plane(&self, plane: f64, radius: f64) -> Result<CorrectionMass, MotionError> {
        self.correction(plane, radius, -self.static_unbalance())
    }

    /// The masses that balance the shaft, one in each of two planes, m along the line, at these radii, m.
    ///
    /// With U_A + U_B = −M e and z_A U_A + z_B U_B = −∫ z ρ dm: U_B is minus the couple about plane A over the distance of the
    /// planes, U_A the same with the planes exchanged.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) for planes at one place or not finite, or a radius that is not positive.
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

    /// The shaft with masses added.
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

    /// From P to the centre of mass.
    fn arm(&self) -> Position<Body> {
        self.body.center_of_mass() - self.point
    }

    /// The part across the line.
    fn across(&self, v: Position<Body>) -> Position<Body> {
        v - (self.axis * self.axis.dot(v)).as_quantity()
    }

    /// The mass whose unbalance m ρ is `wanted`.
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
            // Half a turn is π, not −π: + 0 takes the sign of a zero.
            angle: libm::atan2(self.axis.cross(mark).dot(towards) + 0.0, mark.dot(towards)),
            position: on_axis + (towards * radius).as_quantity(),
        })
    }
}
