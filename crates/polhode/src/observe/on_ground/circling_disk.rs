//! Disks, hoops and coins that run in circles at a constant tilt.

use super::{ROUNDING_OF_SIZE, UprightWheel, level, moments};
use crate::body::mass_properties::MassProperties;
use crate::math::frame::Body;
use crate::math::vector::Direction;
use crate::motion::contact::{Contact, Footing, SurfaceShape};

/// A symmetric body that rolls on its rim, with its axis e, which has a component upward, at θ from the vertical n: a disk lies flat at θ = 0 and stands upright at 90°.
///
/// Along p, which leads downhill in the plane of the rim from its middle, and e, the arm to the contact is r = r_p p + r_e e, r_p = R + τ sin θ, r_e = d − τ cos θ, τ the tube's radius and d
/// the place of the rim's circle on the axis, seen from the centre of mass. With q = e × p, the body's rate s about e, and e going round the vertical at Ω,
///
/// ω = −Ω sin θ p + s e,  L = −A Ω sin θ p + C s e,  v = r × ω = V q,  V = −(r_p s + r_e Ω sin θ).
///
/// As θ stays, L̇ = Ω n × L, and v̇ = Ω n × v; L̇ = r × m (v̇ − g) has one component, along q:
///
/// Ω² sin θ (A cos θ − m r_e H) − Ω s (C sin θ + m r_p H) = m g D,
///
/// with H = r_p sin θ − r_e cos θ the height of the centre of mass, and D = r_p cos θ + r_e sin θ its distance from the contact along the ground. The point of contact runs on a circle of
/// the radius V/Ω + D. Where the centre of mass is at rest, V = 0, a thin disk has s = 0 and
///
/// Ω² sin θ = m g R/A,  T + U = 3/2 m g R sin θ,
///
/// which is Euler's disk. With the lever µᵣ of rolling friction it loses µᵣ m g |ω_t| = µᵣ m g Ω sin θ cos θ, so that a thin one at a small tilt has Ω = Ω₀ T/(T − t) and lies flat after T = 3 R/(µᵣ Ω₀).
///
/// Source: E. J. Routh, Dynamics of a System of Rigid Bodies, Advanced Part (1905), art. 241; A. J. McDonald, K. T. McDonald, arXiv:physics/0008227 (2000), for sharp rims without thickness; the last two formulas as H. K. Moffatt,
/// Nature 404 (2000) 833, has them for the air; with τ and d, and for rolling friction, derived here as above.
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
    /// m, kg
    pub mass: f64,
    /// g, m/s²
    pub gravity: f64,
    /// A, kg·m²
    pub across: f64,
    /// C, kg·m²
    pub along: f64,
    /// R, m
    pub radius: f64,
    /// τ, m; zero of a sharp edge.
    pub tube: f64,
    /// d, m; −½ h of a disk that is h thick.
    pub offset: f64,
}

impl CirclingDisk {
    /// The disk that a symmetric body with a rim is on level ground, and its axis e, if `up` is the vertical in the body.
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
        // Of two rims the lower one.
        let offset = middle - 0.5 * thickness;
        Some((Self { mass: body.mass(), gravity, across, along, radius, tube, offset }, axis))
    }

    /// The same upright, if its centre of mass is in the middle of the rim: of a thick disk that would stand on both of its rims.
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

    /// r_p and r_e.
    fn arm(&self, tilt: f64) -> [f64; 2] {
        [self.radius + self.tube * libm::sin(tilt), self.offset - self.tube * libm::cos(tilt)]
    }

    /// H, the height of the centre of mass, m.
    pub fn height(&self, tilt: f64) -> f64 {
        let [down, along] = self.arm(tilt);
        down * libm::sin(tilt) - along * libm::cos(tilt)
    }

    /// D, the distance of the centre of mass from the contact along the ground, m.
    pub fn reach(&self, tilt: f64) -> f64 {
        let [down, along] = self.arm(tilt);
        down * libm::cos(tilt) + along * libm::sin(tilt)
    }

    /// V, the velocity of the centre of mass along q, m/s.
    pub fn velocity(&self, tilt: f64, spin: f64, rate: f64) -> f64 {
        let [down, along] = self.arm(tilt);
        -(down * spin + along * rate * libm::sin(tilt))
    }

    /// The factors of the steady motion: of Ω², of −Ω s, and m g D.
    pub fn balance(&self, tilt: f64) -> [f64; 3] {
        let (sine, [down, along], height) = (libm::sin(tilt), self.arm(tilt), self.height(tilt));
        [
            sine * (self.across * libm::cos(tilt) - self.mass * along * height),
            self.along * sine + self.mass * down * height,
            self.mass * self.gravity * self.reach(tilt),
        ]
    }

    /// The rates Ω at which it runs steadily with the rate s about its axis, the slower one first; none if it is too slow for this tilt.
    pub fn rates(&self, tilt: f64, spin: f64) -> Vec<f64> {
        let [square, linear, weight] = self.balance(tilt);
        let linear = -linear * spin;
        let discriminant = linear * linear + 4.0 * square * weight;
        if discriminant < 0.0 {
            return Vec::new();
        }
        // Of a Ω² + b Ω − w = 0 the root that does not cancel, and the other one by their product.
        let sum = -0.5 * (linear + discriminant.sqrt().copysign(linear));
        let mut rates: Vec<f64> =
            [sum / square, -weight / sum].into_iter().filter(|rate| rate.is_finite()).collect();
        rates.sort_by(|a, b| a.abs().total_cmp(&b.abs()));
        rates
    }

    /// The radius of the circle on which the point of contact runs, m: negative where it is on the other side of the axis than D.
    pub fn circle_radius(&self, tilt: f64, spin: f64, rate: f64) -> f64 {
        self.velocity(tilt, spin, rate) / rate + self.reach(tilt)
    }

    /// The rate s about the axis with which the centre of mass is at rest, rad/s.
    pub fn spin_at_rest(&self, tilt: f64, rate: f64) -> f64 {
        let [down, along] = self.arm(tilt);
        -along * rate * libm::sin(tilt) / down
    }

    /// The rate Ω at which it runs with its centre of mass at rest, rad/s: Euler's disk. `None` where no rate does.
    pub fn rate_at_rest(&self, tilt: f64) -> Option<f64> {
        let [square, linear, weight] = self.balance(tilt);
        let held = square - linear * self.spin_at_rest(tilt, 1.0);
        Some((weight / held).sqrt()).filter(|rate| rate.is_finite() && *rate > 0.0)
    }

    /// T + U, J: U zero where the centre of mass would be on the ground.
    pub fn energy(&self, tilt: f64, spin: f64, rate: f64) -> f64 {
        let (v, across) = (self.velocity(tilt, spin, rate), rate * libm::sin(tilt));
        0.5 * (self.mass * v * v + self.across * across * across + self.along * spin * spin)
            + self.mass * self.gravity * self.height(tilt)
    }

    /// The time after which Euler's disk lies flat that goes round at Ω with a small tilt, by rolling friction of the lever µᵣ: 3 R/(µᵣ Ω), s.
    pub fn settling_time(&self, rate: f64, lever: f64) -> f64 {
        3.0 * self.radius / (lever * rate.abs())
    }
}
