//! Balls that slide and roll on a plane.

use super::even_ball;
use crate::body::mass_properties::MassProperties;
use crate::math::frame::{Body, Space};
use crate::math::vector::{Acceleration, Direction, Position, Velocity};
use crate::motion::contact::{Contact, Friction, GroundShape};

/// Ball on a plane with its centre of mass at its centre and three equal moments I. It also
/// describes a body that rolls about an axis of fixed direction, such as a cylinder, with its
/// moment about that axis.
///
/// Let n be the normal, a the radius, r = −a n, and F the force along the plane. The equations of
/// motion are m v̇ = F + m `g_t` and I ω̇ = −a n × F. Let k = I/(m a²) and σ = k/(1 + k), which is
/// 2/7 for a homogeneous ball.
///
/// **Rolling**: on a plane that rotates at Ω, v = Ω n × x + a ω × n. Its time derivative with both
/// equations gives
///
/// v̇ = σ Ω n × v + (1 − σ) g_t.
///
/// This is uniform acceleration on a plane at rest, with the friction force σ m g_t. On a rotating
/// plane it is a circle at the rate σ Ω, which drifts across the slope.
///
/// **Sliding** on a plane at rest: the slip u = v − a ω × n has u̇ = g_t + F/(σ m), and with
/// F = −µ N û
///
/// u̇ = g_t − κ û,  κ = µ g_n/σ,
///
/// so that d(κ |u| + g_t · u)/dt = −(κ² − g_t²). If κ > g_t the slip ends, for any initial
/// direction, at
///
/// T = (κ |u₀| + g_t · u₀)/(κ² − g_t²),  v(T) = v₀ − σ u₀ + (1 − σ) g_t T.
///
/// The time on level ground is T = |u₀|/κ. Viscous friction F = −(µ N/|u| + c) u keeps the
/// direction of u, and then T = ln(1 + λ |u₀|/κ)/λ, λ = c/(σ m).
///
/// Source: L. Euler, Mém. Acad. Berlin 14 (1758) 284, and G. Coriolis, Théorie mathématique des
/// effets du jeu de billard (1835), on level ground; J. A. Weckesser, Am. J. Phys. 65 (1997) 736,
/// on turntables; on a slope derived here as above.
///
/// ```
/// use polhode::motion::contact::Friction;
/// use polhode::observe::{BallOnPlane, SlipEnd};
/// use polhode::prelude::*;
/// let ball = BallOnPlane {
///     mass: 0.17,
///     radius: 0.028,
///     moment: 0.4 * 0.17 * 0.028 * 0.028,
///     gravity: Acceleration::new(0.0, 0.0, -9.80665),
///     normal: Direction::new(0.0, 0.0, 1.0),
///     turning: 0.0,
/// };
/// let (thrown, felt) = (Velocity::new(2.0, 0.0, 0.0), Friction { sticking: 0.2, kinetic: 0.2, viscous: 0.0 });
/// // T = 2 v/(7 µ g), and 5/7 of the velocity is left.
/// let SlipEnd::At(time) = ball.slip_end(thrown, &felt) else { return Err("it grips".into()) };
/// assert!((time - 4.0 / (7.0 * 0.2 * 9.80665)).abs() < 1e-15);
/// assert!((ball.rolls_off(thrown, thrown, time).x - 10.0 / 7.0).abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BallOnPlane {
    /// Mass m, kg.
    pub mass: f64,
    /// Radius a, m.
    pub radius: f64,
    /// Moment of inertia I, kg·m².
    pub moment: f64,
    /// Gravitational acceleration g, space axes, m/s².
    pub gravity: Acceleration<Space>,
    /// Normal n of the plane, toward the ball, space axes.
    pub normal: Direction<Space>,
    /// Rotation rate Ω of the plane about n, rad/s.
    pub turning: f64,
}

/// End of slip.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SlipEnd {
    /// Slip ends after this time, s.
    At(f64),
    /// Slip does not end in finite time.
    Never,
    /// No closed form is known: the plane rotates, or viscous friction acts on a slope.
    Unknown,
}

/// Relative tolerance for a vector to be along the slope.
const ALONG: f64 = 1e-12;

impl BallOnPlane {
    /// Returns the ball that a body on the ground is: a sphere centred at the centre of mass with
    /// three equal moments, on a plane. `None` for other bodies.
    pub fn of(body: &MassProperties<Body>, contact: &Contact) -> Option<Self> {
        let (radius, moment) = even_ball(body, contact)?;
        let is_plane = matches!(contact.ground.shape(), GroundShape::Plane);
        is_plane.then(|| Self {
            mass: body.mass(),
            radius,
            moment,
            gravity: contact.gravity,
            normal: contact.ground.axis(),
            turning: contact.ground.turning(),
        })
    }

    /// Returns σ = I/(I + m a²).
    pub fn share(&self) -> f64 {
        self.moment / (self.moment + self.mass * self.radius * self.radius)
    }

    /// Returns g_n, the component of g that presses the ball to the plane, m/s².
    pub fn pressing(&self) -> f64 {
        -self.gravity.dot(self.normal)
    }

    /// Returns g_t, the component of g along the plane, m/s²; zero if it is only rounding.
    pub fn downhill(&self) -> Acceleration<Space> {
        let along = self.gravity + (self.normal * self.pressing()).as_quantity();
        if along.norm() <= ALONG * self.gravity.norm() { Acceleration::ZERO } else { along }
    }

    /// Returns the acceleration v̇ of rolling on a plane at rest, m/s².
    pub fn rolling_acceleration(&self) -> Acceleration<Space> {
        self.downhill() * (1.0 - self.share())
    }

    /// Returns the smallest coefficient of friction for rolling on a plane at rest: σ tan α.
    pub fn friction_to_roll(&self) -> f64 {
        self.share() * self.downhill().norm() / self.pressing()
    }

    /// Returns σ Ω, the rate of circling on a rotating plane, rad/s.
    pub fn circle_rate(&self) -> f64 {
        self.share() * self.turning
    }

    /// Returns the drift velocity of the centre of that circle, across the slope of a rotating
    /// plane, m/s.
    pub fn drift(&self) -> Velocity<Space> {
        let downhill: Direction<Space> = self.downhill().as_quantity();
        let across = self.normal.cross(downhill);
        (across * ((1.0 - self.share()) / self.circle_rate())).as_quantity()
    }

    /// Returns the centre of the circle for a ball at `place` with this velocity, m.
    pub fn circle_center(&self, place: Position<Space>, velocity: Velocity<Space>) -> Position<Space> {
        let circling: Direction<Space> = (velocity - self.drift()).as_quantity();
        let across = self.normal.cross(circling);
        place + (across * (1.0 / self.circle_rate())).as_quantity()
    }

    /// Returns κ = µ g_n/σ, the deceleration of slip on a level plane, m/s².
    pub fn slip_deceleration(&self, friction: &Friction) -> f64 {
        friction.kinetic * self.pressing() / self.share()
    }

    /// Returns the duration of slip for an initial slip u, without rolling resistance.
    pub fn slip_end(&self, slip: Velocity<Space>, friction: &Friction) -> SlipEnd {
        let (kappa, downhill, speed) = (self.slip_deceleration(friction), self.downhill(), slip.norm());
        let steep = downhill.norm();
        let ends = |time: f64| if time.is_finite() { SlipEnd::At(time) } else { SlipEnd::Never };
        match (self.turning != 0.0, friction.viscous != 0.0, steep > 0.0) {
            (true, ..) | (_, true, true) => SlipEnd::Unknown,
            (_, true, _) => {
                let rate = self.slip_decay(friction);
                ends(libm::log1p(rate * speed / kappa) / rate)
            }
            (_, false, false) => ends(speed / kappa),
            _ if kappa > steep => {
                ends((kappa * speed + downhill.dot(slip)) / (kappa * kappa - steep * steep))
            }
            // Straight uphill, the slip ends at the turning point.
            _ if speed > 0.0 && (downhill.dot(slip) / (steep * speed) + 1.0).abs() <= ALONG => {
                ends(speed / (kappa + steep))
            }
            _ => SlipEnd::Never,
        }
    }

    /// Returns λ = c/(σ m), 1/s.
    pub fn slip_decay(&self, friction: &Friction) -> f64 {
        friction.viscous / (self.share() * self.mass)
    }

    /// Returns the velocity of the centre when an initial slip u has ended after `time`, m/s.
    pub fn rolls_off(&self, velocity: Velocity<Space>, slip: Velocity<Space>, time: f64) -> Velocity<Space> {
        let gained = self.rolling_acceleration() * time;
        velocity - slip * self.share() + gained.as_quantity()
    }

    /// Returns the displacement of the centre when an initial slip u has ended after `time`, on a
    /// level plane at rest, m.
    pub fn displacement(
        &self,
        velocity: Velocity<Space>,
        slip: Velocity<Space>,
        friction: &Friction,
        time: f64,
    ) -> Position<Space> {
        let (kappa, rate, speed) = (self.slip_deceleration(friction), self.slip_decay(friction), slip.norm());
        if speed == 0.0 {
            return (velocity * time).as_quantity();
        }
        // ∫ (|u₀| − |u|) dt.
        let lost = if rate == 0.0 {
            0.5 * kappa * time * time
        } else {
            speed * time - (speed - kappa * time) / rate
        };
        (velocity * time - slip * (self.share() * lost / speed)).as_quantity()
    }
}
