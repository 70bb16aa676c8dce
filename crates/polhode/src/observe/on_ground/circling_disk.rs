//! Disks, hoops and coins that move in circles at a constant tilt.

use super::{ROUNDING_OF_SIZE, UprightWheel, level, moments};
use crate::body::mass_properties::MassProperties;
use crate::math::frame::Body;
use crate::math::vector::Direction;
use crate::motion::contact::{Contact, Footing, SurfaceShape};

/// Symmetric body that rolls on its rim at a constant tilt. Its axis e, with an upward component,
/// has the angle θ from the vertical n: a disk lies flat at θ = 0 and is upright at 90°.
///
/// The unit vector p points downhill in the plane of the rim from its centre. The arm to the
/// contact is r = r_p p + r_e e, with r_p = R + τ sin θ and r_e = d − τ cos θ. Here τ is the tube
/// radius, and d is the position of the rim's circle on the axis relative to the centre of mass.
/// With q = e × p, the body's rate s about e, and the rate Ω of e about the vertical:
///
/// ω = −Ω sin θ p + s e,  L = −A Ω sin θ p + C s e,  v = r × ω = V q,  V = −(r_p s + r_e Ω sin θ).
///
/// Because θ is constant, L̇ = Ω n × L and v̇ = Ω n × v. The balance L̇ = r × m (v̇ − g) has one
/// component, along q:
///
/// Ω² sin θ (A cos θ − m r_e H) − Ω s (C sin θ + m r_p H) = m g D,
///
/// Here H = r_p sin θ − r_e cos θ is the height of the centre of mass, and D = r_p cos θ + r_e sin
/// θ is its horizontal distance from the contact. The point of contact moves on a circle of radius
/// V/Ω + D. If the centre of mass is at rest, V = 0, a thin disk has s = 0 and
///
/// Ω² sin θ = m g R/A,  T + U = 3/2 m g R sin θ,
///
/// which is Euler's disk. Rolling friction with the lever µᵣ dissipates the power µᵣ m g |ω_t| = µᵣ
/// m g Ω sin θ cos θ. A thin disk at a small tilt then has Ω = Ω₀ T/(T − t) and lies flat after
/// T = 3 R/(µᵣ Ω₀).
///
/// Source: E. J. Routh, Dynamics of a System of Rigid Bodies, Advanced Part (1905), art. 241; A. J.
/// McDonald, K. T. McDonald, arXiv:physics/0008227 (2000), for sharp rims without thickness; the
/// last two formulas like those of H. K. Moffatt, Nature 404 (2000) 833, for air drag; with τ and
/// d, and for rolling friction, derived here as above.
///
/// ```
/// use polhode::observe::CirclingDisk;
/// let (mass, radius) = (0.4, 0.075);
/// let across = 0.25 * mass * radius * radius;
/// let disk = CirclingDisk { mass, gravity: 9.80665, across, along: 2.0 * across, radius, tube: 0.0, offset: 0.0 };
/// // Euler's disk: Ω² sin θ = 4 g/R, and no rate about its axis.
/// let rate = disk.rate_at_rest(0.1).ok_or("thin")?;
/// assert!((rate * rate * 0.1_f64.sin() - 4.0 * 9.80665 / radius).abs() < 1e-10);
/// assert!(disk.rates(0.1, 0.0).iter().any(|omega| (omega - rate).abs() < 1e-12 * rate));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CirclingDisk {
    /// Mass m, kg.
    pub mass: f64,
    /// Gravitational acceleration g, m/s².
    pub gravity: f64,
    /// Moment of inertia A perpendicular to the axis, kg·m².
    pub across: f64,
    /// Moment of inertia C about the axis, kg·m².
    pub along: f64,
    /// Radius R of the rim's circle, m.
    pub radius: f64,
    /// Tube radius τ, m; zero for a sharp edge.
    pub tube: f64,
    /// Axial position d of the rim's circle relative to the centre of mass, m; −½ h for a disk of
    /// thickness h.
    pub offset: f64,
}

impl CirclingDisk {
    /// Returns the disk that a symmetric body with a rim is on level ground, and its axis e; `up`
    /// is the vertical, body axes.
    pub fn of(
        body: &MassProperties<Body>,
        contact: &Contact,
        up: Direction<Body>,
    ) -> Option<(Self, Direction<Body>)> {
        let SurfaceShape::Rim { radius, tube, thickness } = *contact.surface.shape() else { return None };
        let (gravity, axis) = (level(contact)?, contact.symmetry_axis(body)?);
        let axis = if axis.dot(up) < 0.0 { -axis } else { axis };
        let [across, along] = moments(body, axis);
        let middle = axis.dot(contact.surface.center() - body.center_of_mass());
        // The lower one of two rims.
        let offset = middle - 0.5 * thickness;
        Some((Self { mass: body.mass(), gravity, across, along, radius, tube, offset }, axis))
    }

    /// Returns the same body upright, if its centre of mass is in the plane of the rim; a thick
    /// disk would stand on both of its rims.
    pub fn upright(&self, footing: Footing) -> Option<UprightWheel> {
        (self.offset.abs() <= ROUNDING_OF_SIZE * self.radius).then_some(UprightWheel {
            mass: self.mass,
            gravity: self.gravity,
            across: self.across,
            along: self.along,
            height: self.radius + self.tube,
            profile: self.tube,
            footing,
        })
    }

    /// Returns the components `r_p` and `r_e` of the arm, m.
    fn arm(&self, tilt: f64) -> [f64; 2] {
        [self.radius + self.tube * libm::sin(tilt), self.offset - self.tube * libm::cos(tilt)]
    }

    /// Returns H, the height of the centre of mass, m.
    pub fn height(&self, tilt: f64) -> f64 {
        let [down, along] = self.arm(tilt);
        down * libm::sin(tilt) - along * libm::cos(tilt)
    }

    /// Returns D, the horizontal distance of the centre of mass from the contact, m.
    pub fn reach(&self, tilt: f64) -> f64 {
        let [down, along] = self.arm(tilt);
        down * libm::cos(tilt) + along * libm::sin(tilt)
    }

    /// Returns V, the velocity of the centre of mass along q, m/s.
    pub fn velocity(&self, tilt: f64, spin: f64, rate: f64) -> f64 {
        let [down, along] = self.arm(tilt);
        -(down * spin + along * rate * libm::sin(tilt))
    }

    /// Returns the coefficients of the steady motion: of Ω², of −Ω s, and m g D.
    pub fn balance(&self, tilt: f64) -> [f64; 3] {
        let (sine, [down, along], height) = (libm::sin(tilt), self.arm(tilt), self.height(tilt));
        [
            sine * (self.across * libm::cos(tilt) - self.mass * along * height),
            self.along * sine + self.mass * down * height,
            self.mass * self.gravity * self.reach(tilt),
        ]
    }

    /// Returns the rates Ω of steady motion for the rate s about its axis, the slower one first;
    /// empty if s is too small for this tilt.
    pub fn rates(&self, tilt: f64, spin: f64) -> Vec<f64> {
        let [square, linear, weight] = self.balance(tilt);
        let linear = -linear * spin;
        let discriminant = linear * linear + 4.0 * square * weight;
        if discriminant < 0.0 {
            return Vec::new();
        }
        // For a Ω² + b Ω − w = 0: the root that does not cancel, and the other one by their
        // product.
        let sum = -0.5 * (linear + discriminant.sqrt().copysign(linear));
        let mut rates: Vec<f64> =
            [sum / square, -weight / sum].into_iter().filter(|rate| rate.is_finite()).collect();
        rates.sort_by(|a, b| a.abs().total_cmp(&b.abs()));
        rates
    }

    /// Returns the radius of the circle on which the point of contact moves, m; negative if the
    /// contact is on the other side of the axis than D.
    pub fn circle_radius(&self, tilt: f64, spin: f64, rate: f64) -> f64 {
        self.velocity(tilt, spin, rate) / rate + self.reach(tilt)
    }

    /// Returns the rate s about the axis at which the centre of mass is at rest, rad/s.
    pub fn spin_at_rest(&self, tilt: f64, rate: f64) -> f64 {
        let [down, along] = self.arm(tilt);
        -along * rate * libm::sin(tilt) / down
    }

    /// Returns the rate Ω of Euler's disk, whose centre of mass is at rest, rad/s; `None` if there
    /// is none.
    pub fn rate_at_rest(&self, tilt: f64) -> Option<f64> {
        let [square, linear, weight] = self.balance(tilt);
        let held = square - linear * self.spin_at_rest(tilt, 1.0);
        Some((weight / held).sqrt()).filter(|rate| rate.is_finite() && *rate > 0.0)
    }

    /// Returns T + U, J; U is zero if the centre of mass is at ground level.
    pub fn energy(&self, tilt: f64, spin: f64, rate: f64) -> f64 {
        let (v, across) = (self.velocity(tilt, spin, rate), rate * libm::sin(tilt));
        0.5 * (self.mass * v * v + self.across * across * across + self.along * spin * spin)
            + self.mass * self.gravity * self.height(tilt)
    }

    /// Returns the time after which Euler's disk with the rate Ω and a small tilt lies flat, for
    /// rolling friction with the lever µᵣ: 3 R/(µᵣ Ω), s.
    pub fn settling_time(&self, rate: f64, lever: f64) -> f64 {
        3.0 * self.radius / (lever * rate.abs())
    }
}
