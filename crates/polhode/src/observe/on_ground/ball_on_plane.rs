//! Balls that slide and roll on a plane.

use super::even_ball;
use crate::body::mass_properties::MassProperties;
use crate::math::frame::{Body, Space};
use crate::math::vector::{Acceleration, Direction, Position, Velocity};
use crate::motion::contact::{Contact, Friction, GroundShape};

/// A ball on a plane with its centre of mass in its middle and three equal moments I; or what rolls about an axis that keeps its direction, as a cylinder does, with its
/// moment about that.
///
/// With n the normal, a the radius, r = −a n, and F along the plane, m v̇ = F + m g_t and I ω̇ = −a n × F. Let k = I/(m a²) and the share σ = k/(1 + k): 2/7 of a
/// homogeneous ball.
///
/// **Rolling**, v = Ω n × x + a ω × n on a plane that turns at Ω, the derivative of this with both equations is
///
/// v̇ = σ Ω n × v + (1 − σ) g_t,
///
/// a straight line on a plane at rest, for which friction is σ m g_t; a circle at the rate σ Ω on one that turns, which drifts across a slope.
///
/// **Sliding** on a plane at rest, the slip u = v − a ω × n has u̇ = g_t + F/(σ m), and with F = −µ N û
///
/// u̇ = g_t − κ û,  κ = µ g_n/σ,
///
/// so that d(κ |u| + g_t · u)/dt = −(κ² − g_t²): where κ > g_t the slip ends, in whatever direction it began, at
///
/// T = (κ |u₀| + g_t · u₀)/(κ² − g_t²),  v(T) = v₀ − σ u₀ + (1 − σ) g_t T.
///
/// On level ground that is T = |u₀|/κ, and viscous friction F = −(µ N/|u| + c) u leaves the direction: T = ln(1 + λ |u₀|/κ)/λ, λ = c/(σ m).
///
/// Source: L. Euler, Mém. Acad. Berlin 14 (1758) 284, and G. Coriolis, Théorie mathématique des effets du jeu de billard (1835), on level ground; J. A. Weckesser, Am. J. Phys. 65 (1997)
/// 736, on turntables; on a slope derived here as above.
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
    /// m, kg
    pub mass: f64,
    /// a, m
    pub radius: f64,
    /// I, kg·m²
    pub moment: f64,
    /// g, m/s²
    pub gravity: Acceleration<Space>,
    /// n, towards the ball.
    pub normal: Direction<Space>,
    /// Ω, the rate at which the plane turns about n, rad/s.
    pub turning: f64,
}

/// When slip ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SlipEnd {
    /// After this time, s.
    At(f64),
    /// Not in finite time.
    Never,
    /// No closed form is known here: the plane turns, or viscous friction acts on a slope.
    Unknown,
}

/// Along the slope but for rounding.
const ALONG: f64 = 1e-12;

impl BallOnPlane {
    /// The ball that a body on the ground is: a sphere about the centre of mass with three equal moments, on a plane.
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

    /// σ = I/(I + m a²)
    pub fn share(&self) -> f64 {
        self.moment / (self.moment + self.mass * self.radius * self.radius)
    }

    /// g_n, the part of g that presses the ball to the plane, m/s².
    pub fn pressing(&self) -> f64 {
        -self.gravity.dot(self.normal)
    }

    /// g_t, the part of g along the plane; zero where it is rounding.
    pub fn downhill(&self) -> Acceleration<Space> {
        let along = self.gravity + (self.normal * self.pressing()).as_quantity();
        if along.norm() <= ALONG * self.gravity.norm() { Acceleration::ZERO } else { along }
    }

    /// v̇ of what rolls on a plane at rest.
    pub fn rolling_acceleration(&self) -> Acceleration<Space> {
        self.downhill() * (1.0 - self.share())
    }

    /// The least coefficient of friction with which it rolls on a plane at rest: σ tan α.
    pub fn friction_to_roll(&self) -> f64 {
        self.share() * self.downhill().norm() / self.pressing()
    }

    /// σ Ω, at which it circles on a plane that turns, rad/s.
    pub fn circle_rate(&self) -> f64 {
        self.share() * self.turning
    }

    /// The velocity at which the middle of that circle moves: across the slope of a plane that turns.
    pub fn drift(&self) -> Velocity<Space> {
        let downhill: Direction<Space> = self.downhill().as_quantity();
        let across = self.normal.cross(downhill);
        (across * ((1.0 - self.share()) / self.circle_rate())).as_quantity()
    }

    /// The middle of the circle on which something at `place` with this velocity runs.
    pub fn circle_center(&self, place: Position<Space>, velocity: Velocity<Space>) -> Position<Space> {
        let circling: Direction<Space> = (velocity - self.drift()).as_quantity();
        let across = self.normal.cross(circling);
        place + (across * (1.0 / self.circle_rate())).as_quantity()
    }

    /// κ = µ g_n/σ, at which slip becomes less on a level plane, m/s².
    pub fn slip_deceleration(&self, friction: &Friction) -> f64 {
        friction.kinetic * self.pressing() / self.share()
    }

    /// How long it slips that slips at u, without torques that resist rolling.
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
            // Straight uphill the slip stops at the turning point.
            _ if speed > 0.0 && (downhill.dot(slip) / (steep * speed) + 1.0).abs() <= ALONG => {
                ends(speed / (kappa + steep))
            }
            _ => SlipEnd::Never,
        }
    }

    /// λ = c/(σ m), 1/s
    pub fn slip_decay(&self, friction: &Friction) -> f64 {
        friction.viscous / (self.share() * self.mass)
    }

    /// The velocity of the centre when a slip u has ended after a time.
    pub fn rolls_off(&self, velocity: Velocity<Space>, slip: Velocity<Space>, time: f64) -> Velocity<Space> {
        let gained = self.rolling_acceleration() * time;
        velocity - slip * self.share() + gained.as_quantity()
    }

    /// How far the centre has come when a slip u has ended after a time, on a level plane at rest.
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
        // ∫ (|u₀| − |u|) dt
        let lost = if rate == 0.0 {
            0.5 * kappa * time * time
        } else {
            speed * time - (speed - kappa * time) / rate
        };
        (velocity * time - slip * (self.share() * lost / speed)).as_quantity()
    }
}
