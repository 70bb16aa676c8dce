//! Orbits about a point mass: the position of a centre of mass as a function of time.
//!
//! The orbit is a circle, or a Kepler ellipse, parabola or hyperbola, in closed form. It does not
//! depend on the rotation of the body. `math/kepler.rs` solves Kepler's equation for every
//! eccentricity. On an ellipse, time is counted from the nearest passage of the periapsis. The mean
//! motion n is a double-double; many revolutions therefore do not reduce the accuracy.

use super::orbital_elements::{Anomaly, OrbitalElements};
use crate::math::double::Double;
use crate::math::frame::{Orbital, Space};
use crate::math::kepler::{Conic, OrbitalPoint};
use crate::math::rotation::Rotation;
use crate::math::vector::{AngularVelocity, Direction, Position, Vector, Velocity, quantity::Number};
use crate::motion::error::MotionError;
use crate::motion::model::require;

/// Gravitational parameter GM of the Earth, m³/s², with the atmosphere: IERS Conventions (2010),
/// table 1.1.
pub const MU_EARTH: f64 = 3.986_004_418e14;

/// An orbit about a point mass at the origin of space: r̈ = −µ r/r³.
///
/// A position is accurate to a few ε of the distance, and along the path to a few ε n t₁, with t₁
/// the time to the nearest periapsis. This is independent of the number of revolutions.
///
/// The orbit takes the numbers that define it as exact. If it is defined by a state, n depends on
/// six rounded numbers. After N revolutions, input rounding limits the accuracy to about 20 N ε
/// rad.
///
/// ```
/// use polhode::math::{Position, Velocity};
/// use polhode::motion::{MU_EARTH, Orbit};
/// let (position, velocity) = (Position::new(-4.3e6, 1.0e6, 5.1e6), Velocity::new(110.0, -7530.0, 1480.0));
/// let orbit = Orbit::through(MU_EARTH, position, velocity, 0.0)?;
/// let period = orbit.period().ok_or("it is closed")?;
/// assert!((period / 60.0 - 92.0).abs() < 1.0);
/// assert!((orbit.position(1e6 * period) - position).norm() < 1e-1); // 1e6 periods themselves are rounded to 1 µs
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Orbit {
    mu: f64,
    conic: Conic,
    /// Periapsis distance q, m.
    periapsis: f64,
    /// Unit of time √(q³/µ), s.
    unit: f64,
    clock: Clock,
    /// Unit vectors to the periapsis, and along the velocity there.
    axes: [Direction<Space>; 2],
}

/// Relation between time and position on the orbit.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Clock {
    /// Ellipse: mean anomaly at the epoch (s), and mean motion n, rad/s.
    Closed { epoch: f64, anomaly: f64, rate: Double },
    /// Parabola or hyperbola: time since the periapsis at the epoch (s), in units of √(q³/µ).
    Open { epoch: f64, since: f64 },
}

impl Orbit {
    /// Creates a circular orbit of a radius (m). At t = 0 the body is in the direction `radial`. It
    /// moves towards the side of `motion`; only the part of `motion` normal to `radial` counts.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) if µ or the radius is not positive, or
    /// the directions do not span a plane.
    pub fn circular(
        mu: f64,
        radius: f64,
        radial: Direction<Space>,
        motion: Direction<Space>,
    ) -> Result<Self, MotionError> {
        require::positive("the orbit's µ", mu)?;
        require::positive("the orbit's radius", radius)?;
        Self::circle(mu, radius, mean_motion(mu, Double::from(1.0) / Double::from(radius)), radial, motion)
    }

    /// Creates a circular orbit with an angular rate (rad/s). The radius follows from n² r³ = µ.
    /// Otherwise like [`Orbit::circular`].
    ///
    /// # Errors
    /// The errors of [`Orbit::circular`].
    pub fn circular_at_rate(
        mu: f64,
        rate: f64,
        radial: Direction<Space>,
        motion: Direction<Space>,
    ) -> Result<Self, MotionError> {
        require::positive("the orbit's µ", mu)?;
        require::positive("the orbit's rate", rate)?;
        Self::circle(mu, libm::cbrt(mu / rate / rate), Double::from(rate), radial, motion)
    }

    fn circle(
        mu: f64,
        radius: f64,
        rate: Double,
        radial: Direction<Space>,
        motion: Direction<Space>,
    ) -> Result<Self, MotionError> {
        let toward = require::direction("the length of the radial direction", radial)?;
        let motion = require::direction("the length of the direction of motion", motion)?;
        let normal = toward.cross(motion);
        let rule = "at least 1e-9 rad off the radial direction";
        require::that("the orbit's direction of motion", normal.norm(), normal.norm() > LEAST_ANGLE, rule)?;
        let clock = Clock::Closed { epoch: 0.0, anomaly: 0.0, rate };
        Self::new(mu, Conic { e: 0.0, beta: 1.0 }, radius, clock, (toward, normal))
    }

    /// Creates the orbit through a position with a velocity at a time, s: an ellipse, a parabola or
    /// a hyperbola.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) if µ is not positive, if a number is not
    /// finite, or if the velocity is parallel to the position. A straight fall has no orbital
    /// plane.
    pub fn through(
        mu: f64,
        position: Position<Space>,
        velocity: Velocity<Space>,
        time: f64,
    ) -> Result<Self, MotionError> {
        require::positive("the orbit's µ", mu)?;
        let r = position.norm();
        require::positive("the orbit's distance", r)?;
        require::that("the orbit's speed", velocity.norm(), velocity.is_finite(), "finite")?;
        require::that("the orbit's epoch", time, time.is_finite(), "finite")?;
        // In units of r and √(µ/r): h = u × w, e = w × h − u, p = h²
        let u = require::direction("the orbit's distance", position)?;
        let w: Direction<Space> = velocity.as_quantity::<Number>() * (r / mu).sqrt();
        let h = u.cross(w);
        let across = h.norm() / w.norm().max(f64::MIN_POSITIVE);
        require::that(
            "the orbit's velocity",
            across,
            across > LEAST_ANGLE,
            "at least 1e-9 rad off the line to the centre",
        )?;
        let normal = require::direction("the orbit's angular momentum", h)?;
        let eccentricity = w.cross(h) - u;
        let in_plane = eccentricity - normal * normal.dot(eccentricity);
        let (e, toward) = match in_plane.direction() {
            Some(toward) if in_plane.norm() > CIRCLE => (in_plane.norm(), toward),
            _ => (0.0, u),
        };
        // q = p/(1 + e), 1 − e = q/a. 1/a is a double-double, so that n is positive where 1 − e is.
        let inverse = inverse_semi_major_axis(mu, position, velocity);
        let alpha = (inverse * Double::from(r)).value();
        require::that("the orbit's r/a", alpha, alpha.is_finite(), "finite")?;
        let q = h.dot(h) / (1.0 + e);
        let conic = if e == 0.0 { Conic { e, beta: 1.0 } } else { Conic { e, beta: alpha * q } };
        let (x, y) = (u.dot(toward), u.dot(normal.cross(toward)));
        let s = if conic.beta > 0.0 {
            conic.anomaly_towards(if x > 0.0 { y / (1.0 + x) } else { (1.0 - x) / y })
        } else {
            // r · v = e S c₁(β S²): sinh √−β S
            let (moment, k) = (u.dot(w) / (e * q.sqrt()), (-conic.beta).sqrt());
            if k == 0.0 { moment } else { libm::asinh(k * moment) / k }
        };
        let rate = mean_motion(mu, inverse);
        let clock = Clock::new(conic, conic.time(s), rate, time);
        Self::new(mu, conic, q * r, clock, (toward, normal))
    }

    /// Creates the orbit with classical elements at t = 0.
    ///
    /// # Errors
    /// A parameter's error ([`MotionError::is_parameter`]) if µ is not positive, e is negative or
    /// 1, a has the wrong sign, or an angle is not finite. Also if the true anomaly is beyond the
    /// asymptotes of a hyperbola.
    pub fn of_elements(mu: f64, elements: &OrbitalElements) -> Result<Self, MotionError> {
        let &OrbitalElements { semi_major_axis: a, eccentricity: e, inclination, node, periapsis, anomaly } =
            elements;
        require::positive("the orbit's µ", mu)?;
        let is_conic = e >= 0.0 && e.is_finite() && e != 1.0;
        require::that(
            "the orbit's eccentricity",
            e,
            is_conic,
            "zero or more, finite, and not 1: give a parabola by position and velocity",
        )?;
        let rule = "finite, positive for an ellipse and negative for a hyperbola";
        require::that("the orbit's semi-major axis", a, a.is_finite() && a * (1.0 - e) > 0.0, rule)?;
        for (what, angle) in [
            ("the orbit's inclination", inclination),
            ("the orbit's node", node),
            ("the orbit's argument of periapsis", periapsis),
        ] {
            require::that(what, angle, angle.is_finite(), "finite")?;
        }
        let conic = Conic { e, beta: 1.0 - e };
        let time = match anomaly {
            Anomaly::Mean(m) => m / (conic.beta.abs() * conic.beta.abs().sqrt()),
            Anomaly::True(nu) => conic.time(conic.anomaly_towards(libm::tan(0.5 * nu))),
        };
        let rule = "finite, and between the asymptotes of a hyperbola";
        let (Anomaly::Mean(given) | Anomaly::True(given)) = anomaly;
        require::that("the orbit's anomaly", given, time.is_finite(), rule)?;
        let rate = mean_motion(mu, Double::from(1.0) / Double::from(a));
        // R₃(Ω) R₁(i) R₃(ω)
        let plane = Rotation::<Space, Space>::from_euler313([node, inclination, periapsis])
            .map_err(|_| MotionError::NonFiniteParameter { parameter: "the orbit's node", value: node })?;
        let axis = |x, y, z| plane * Direction::new(x, y, z);
        let clock = Clock::new(conic, time, rate, 0.0);
        Self::new(mu, conic, a * conic.beta, clock, (axis(1.0, 0.0, 0.0), axis(0.0, 0.0, 1.0)))
    }

    /// Creates an orbit from valid parts. The last argument is the direction of the periapsis and
    /// the normal.
    fn new(
        mu: f64,
        conic: Conic,
        periapsis: f64,
        clock: Clock,
        (toward, normal): (Direction<Space>, Direction<Space>),
    ) -> Result<Self, MotionError> {
        let unit = (periapsis / mu * periapsis).sqrt() * periapsis.sqrt();
        require::positive("the orbit's least distance", periapsis)?;
        require::positive("the orbit's unit of time", unit)?;
        if let Clock::Closed { rate, .. } = clock {
            require::positive("the orbit's mean motion", rate.value())?;
        }
        let ahead = require::direction("the orbit's angular momentum", normal.cross(toward))?;
        Ok(Self { mu, conic, periapsis, unit, clock, axes: [toward, ahead] })
    }

    /// Returns the position at a time (s), relative to the point mass, space axes, m.
    pub fn position(&self, time: f64) -> Position<Space> {
        let [x, y] = self.place(time).position;
        self.in_space([x, y]) * self.periapsis
    }

    /// Returns the velocity at a time (s), space axes, m/s.
    pub fn velocity(&self, time: f64) -> Velocity<Space> {
        self.in_space(self.place(time).velocity) * (self.periapsis / self.unit)
    }

    /// Returns `R_space_orbital` at a time (s): the rotation from axes along the local vertical and
    /// horizontal to space axes.
    ///
    /// z = −r̂ (nadir), y = −r × v/|r × v|, x = y × z.
    pub fn local_axes(&self, time: f64) -> Rotation<Space, Orbital> {
        let [toward, ahead] = self.axes;
        let [x, y] = self.place(time).position;
        let nadir = self.in_space::<Number>([x, y]) * (-1.0 / libm::hypot(x, y));
        let y = ahead.cross(toward);
        Rotation::from_axes([y.cross(nadir), y, nadir])
    }

    /// Returns the angular velocity of the orbital axes at a time (s), r × v/r², space axes, rad/s.
    pub fn angular_velocity(&self, time: f64) -> AngularVelocity<Space> {
        let (r, v) = self.position_and_velocity(time);
        let (r, v): (Direction<Space>, Direction<Space>) = (r.as_quantity(), v.as_quantity());
        let unit = r / r.norm();
        (unit.cross(v) / r.norm()).as_quantity()
    }

    /// Returns position and velocity. This costs no more than one of them.
    pub(crate) fn position_and_velocity(&self, time: f64) -> (Position<Space>, Velocity<Space>) {
        let OrbitalPoint { position, velocity } = self.place(time);
        (self.in_space(position) * self.periapsis, self.in_space(velocity) * (self.periapsis / self.unit))
    }

    /// Returns the unit vector to the body on a circular orbit, and its rate, rad/s.
    #[inline]
    pub(crate) fn around(&self, time: f64) -> [Direction<Space>; 2] {
        let OrbitalPoint { position, velocity } = self.place(time);
        [self.in_space(position), self.in_space(velocity) * (1.0 / self.unit)]
    }

    /// Returns the gravitational parameter µ, m³/s².
    pub const fn mu(&self) -> f64 {
        self.mu
    }

    /// Returns the eccentricity e.
    pub const fn eccentricity(&self) -> f64 {
        self.conic.e
    }

    /// Returns the periapsis distance from the point mass, m: the radius if the orbit is a circle.
    pub const fn periapsis(&self) -> f64 {
        self.periapsis
    }

    /// Returns the mean motion n, rad/s; `None` if the orbit is not closed.
    pub fn mean_motion(&self) -> Option<f64> {
        match self.clock {
            Clock::Closed { rate, .. } => Some(rate.value()),
            Clock::Open { .. } => None,
        }
    }

    /// Returns the period, s; `None` if the orbit is not closed.
    pub fn period(&self) -> Option<f64> {
        match self.clock {
            Clock::Closed { rate, .. } => Some((Double::TAU / rate).value()),
            Clock::Open { .. } => None,
        }
    }

    /// True if it is a circle.
    pub(crate) fn is_circular(&self) -> bool {
        self.conic.e == 0.0
    }

    /// Returns µ/r³ at a distance r on the orbit. On a circle it returns n², which may be an input.
    pub(crate) fn strength(&self, distance: f64) -> f64 {
        match self.mean_motion() {
            Some(rate) if self.is_circular() => rate * rate,
            _ => self.mu / distance / distance / distance,
        }
    }

    fn place(&self, time: f64) -> OrbitalPoint {
        self.conic.at(match self.clock {
            Clock::Open { epoch, since } => since + (time - epoch) / self.unit,
            Clock::Closed { epoch, anomaly, rate } => {
                // M = M₀ + n (t − t₀), reduced modulo 2π
                let m = rate * Double::sum(time, -epoch) + Double::from(anomaly);
                let m = m - Double::TAU * Double::from((m.high / Double::TAU.high).round());
                if self.is_circular() {
                    m.value()
                } else {
                    m.value() / (self.conic.beta * self.conic.beta.sqrt())
                }
            }
        })
    }

    fn in_space<Q>(&self, [x, y]: [f64; 2]) -> Vector<Q, Space> {
        let [toward, ahead] = self.axes;
        (toward * x + ahead * y).as_quantity()
    }
}

impl Clock {
    fn new(conic: Conic, since: f64, rate: Double, epoch: f64) -> Self {
        if conic.beta > 0.0 {
            let anomaly = since * (conic.beta * conic.beta.sqrt());
            Self::Closed { epoch, anomaly, rate }
        } else {
            Self::Open { epoch, since }
        }
    }
}

/// Eccentricity below which the orbit is a circle to within rounding.
const CIRCLE: f64 = 4.0 * f64::EPSILON;

/// Angle, rad, below which two directions do not span a plane.
const LEAST_ANGLE: f64 = 1e-9;

/// Returns n = √(µ/a³) from 1/a. Meaningless if 1/a is not positive.
fn mean_motion(mu: f64, inverse: Double) -> Double {
    (Double::from(mu) * inverse).sqrt() * inverse
}

/// Returns 1/a = 2/r − v²/µ.
fn inverse_semi_major_axis(mu: f64, position: Position<Space>, velocity: Velocity<Space>) -> Double {
    let squared = |v: [f64; 3]| v.iter().fold(Double::default(), |sum, &x| sum + Double::product(x, x));
    let r = squared(position.to_array()).sqrt();
    Double::from(2.0) / r - squared(velocity.to_array()) / Double::from(mu)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn elements(a: f64, e: f64, anomaly: Anomaly) -> Orbit {
        let elements = OrbitalElements {
            semi_major_axis: a,
            eccentricity: e,
            inclination: 0.9,
            node: 2.1,
            periapsis: -0.7,
            anomaly,
        };
        Orbit::of_elements(MU_EARTH, &elements).unwrap()
    }

    #[test]
    fn an_orbit_through_its_own_state_is_the_same() {
        for (a, e) in
            [(7e6, 0.0), (7e6, 1e-12), (8e6, 0.03), (2.6e7, 0.74), (1e9, 0.992), (-9e6, 1.8), (-1e5, 70.0)]
        {
            let orbit = elements(a, e, Anomaly::Mean(0.4));
            for epoch in [-900.0, 0.0, 2500.0] {
                let (position, velocity) = orbit.position_and_velocity(epoch);
                let again = Orbit::through(MU_EARTH, position, velocity, epoch).unwrap();
                assert!(
                    (again.eccentricity() - e).abs() < 2e-14 * (1.0 + e) / (1.0 - e).abs().min(1.0),
                    "{again:?}"
                );
                for time in [-1500.0, 100.0, 4000.0] {
                    let (r, v) = (orbit.position(time), orbit.velocity(time));
                    let far = 1.0 + r.norm() / orbit.periapsis();
                    assert!(
                        (again.position(time) - r).norm() < 1e-13 * far * r.norm(),
                        "{a} {e} {epoch} {time}"
                    );
                    assert!(
                        (again.velocity(time) - v).norm() < 1e-13 * far * velocity.norm(),
                        "{a} {e} {epoch} {time}"
                    );
                }
            }
        }
    }

    #[test]
    fn both_anomalies_are_where_they_say() {
        for (a, e) in [(7e6, 0.0), (2.6e7, 0.74), (-9e6, 1.8)] {
            let r = elements(a, e, Anomaly::True(1.1)).position(0.0);
            // r = a (1 − e²)/(1 + e cos ν), at ω + ν from the node, which is at Ω in the xy plane
            let (sin, cos) = libm::sincos(1.1 - 0.7);
            let (s, c) = libm::sincos(2.1);
            let (si, ci) = libm::sincos(0.9);
            let want = Position::new(c * cos - s * sin * ci, s * cos + c * sin * ci, sin * si);
            let want = want * (a * (1.0 - e * e) / (1.0 + e * libm::cos(1.1)));
            assert!((r - want).norm() < 4e-15 * want.norm(), "{r:?} {want:?}");
        }
        // M = E − e sin E at E = 2: x = a (cos E − e) along the periapsis direction
        let orbit = elements(2.6e7, 0.74, Anomaly::Mean(2.0 - 0.74 * libm::sin(2.0)));
        let toward = elements(2.6e7, 0.74, Anomaly::True(0.0)).position(0.0).direction().unwrap();
        let x = toward.dot(orbit.position(0.0)) / 2.6e7;
        assert!((x - (libm::cos(2.0) - 0.74)).abs() < 1e-15);
    }

    #[test]
    fn a_circle_goes_round_at_its_rate() {
        let (radial, motion) = (Direction::new(0.3, -1.2, 0.7), Direction::new(1.0, 0.4, 2.0));
        let orbit = Orbit::circular_at_rate(MU_EARTH, 1.1e-3, radial, motion).unwrap();
        let radius = orbit.periapsis();
        assert!((1.1e-3 * 1.1e-3 * radius.powi(3) / MU_EARTH - 1.0).abs() < 1e-15);
        let same = Orbit::circular(MU_EARTH, radius, radial * 3.0, motion + radial * 0.8).unwrap();
        let (u, time) = (radial.direction().unwrap(), 1234.5);
        let q = u.cross(motion).cross(u).direction().unwrap();
        let (sin, cos) = libm::sincos(1.1e-3 * time);
        let want: Position<Space> = (u * cos + q * sin).as_quantity() * radius;
        assert!((orbit.position(time) - want).norm() < 1e-15 * radius);
        assert!((same.position(time) - want).norm() < 2e-15 * radius);
        assert!((orbit.velocity(time).norm() / (1.1e-3 * radius) - 1.0).abs() < 1e-15);
    }

    #[test]
    fn a_million_revolutions_cost_no_digits() {
        // a = 1 and µ = 1: n = 1 exactly, and t = 2π N + τ as a double-double, of which an f64 has
        // the high word.
        let orbit = Orbit::of_elements(
            1.0,
            &OrbitalElements {
                semi_major_axis: 1.0,
                eccentricity: 0.3,
                inclination: 0.4,
                node: 1.0,
                periapsis: 2.0,
                anomaly: Anomaly::Mean(0.2),
            },
        )
        .unwrap();
        for turns in [1.0, 1e3, 1e6] {
            let time = turns * core::f64::consts::TAU + 0.7;
            let rest = (Double::from(time) - Double::TAU * Double::from(turns)).value();
            assert!((orbit.position(time) - orbit.position(rest)).norm() < 4e-15, "{turns}");
        }
    }

    #[test]
    fn a_parabola_is_an_orbit() {
        // v² = 2µ/r: q = 1, √2 at the nearest point
        let orbit =
            Orbit::through(2.0, Position::new(1.0, 0.0, 0.0), Velocity::new(0.0, 2.0, 0.0), 3.0).unwrap();
        assert_eq!(orbit.period(), None);
        // Barker: t √(µ/2q³) = D + D³/3, x = q (1 − D²), y = 2 q D
        let d = 1.7_f64;
        let r = orbit.position(3.0 + d + d * d * d / 3.0);
        assert!((r - Position::new(1.0 - d * d, 2.0 * d, 0.0)).norm() < 4e-15, "{r:?}");
        // Rounding makes it an ellipse or a hyperbola of arbitrary period.
        for speed in [2.0_f64.next_up(), 2.0_f64.next_down()] {
            let near = Orbit::through(2.0, Position::new(1.0, 0.0, 0.0), Velocity::new(0.0, speed, 0.0), 3.0)
                .unwrap();
            assert!((near.position(10.0) - orbit.position(10.0)).norm() < 1e-13);
        }
    }

    #[test]
    fn what_is_no_orbit_is_refused() {
        let (x, y) = (Direction::new(1.0, 0.0, 0.0), Direction::new(0.0, 1.0, 0.0));
        for (mu, radius, radial, motion) in [
            (0.0, 7e6, x, y),
            (f64::NAN, 7e6, x, y),
            (MU_EARTH, -7e6, x, y),
            (MU_EARTH, f64::INFINITY, x, y),
            (MU_EARTH, 7e6, x, x * -2.0),
            (MU_EARTH, 7e6, Direction::ZERO, y),
        ] {
            assert!(Orbit::circular(mu, radius, radial, motion).is_err());
        }
        let (r, v) = (Position::new(7e6, 0.0, 0.0), Velocity::new(0.0, 7e3, 0.0));
        assert!(Orbit::through(MU_EARTH, r, v, 0.0).is_ok());
        for (r, v) in [
            (Position::ZERO, v),
            (r, Velocity::ZERO),
            (r, Velocity::new(-3e3, 0.0, 0.0)),
            (r, Velocity::new(f64::INFINITY, 1.0, 0.0)),
            (Position::new(1e200, 0.0, 0.0), Velocity::new(0.0, 1e200, 0.0)),
        ] {
            assert!(Orbit::through(MU_EARTH, r, v, 0.0).is_err(), "{r:?} {v:?}");
        }
        let good = OrbitalElements {
            semi_major_axis: -7e6,
            eccentricity: 2.0,
            inclination: 0.0,
            node: 0.0,
            periapsis: 0.0,
            anomaly: Anomaly::True(2.0),
        };
        assert!(Orbit::of_elements(MU_EARTH, &good).is_ok());
        for bad in [
            OrbitalElements { anomaly: Anomaly::True(2.2), ..good }, // beyond cos ν = −1/e
            OrbitalElements { semi_major_axis: 7e6, ..good },
            OrbitalElements { eccentricity: 1.0, ..good },
            OrbitalElements { eccentricity: -0.1, ..good },
            OrbitalElements { node: f64::NAN, ..good },
        ] {
            assert!(Orbit::of_elements(MU_EARTH, &bad).is_err(), "{bad:?}");
        }
    }
}
