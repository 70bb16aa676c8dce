//! Equilibria relative to a circular orbit.
//!
//! A body that keeps its face to the Earth rotates at ω = n along the orbit normal, where n is that
//! of the orbit, not of the start. Newton's method therefore searches for an attitude only. If the
//! gravity gradient on the inertia tensor is the only torque, the principal axes are along the
//! orbital axes. For three distinct moments there are 24 such attitudes, 6 of which differ by more
//! than half turns about these axes.

use super::SmallOscillations;
use crate::math::frame::{Body, Principal, Space};
use crate::math::rotation::Rotation;
use crate::math::vector::{AngularVelocity, Direction};
use crate::motion::error::MotionError;
use crate::motion::model::orbit::Orbit;
use crate::motion::model::rotor::Rotor;
use crate::motion::model::state::State;
use crate::motion::model::torque::TorqueModel;

/// Steady motion of a body on a circular orbit: at rest relative to the radius, the flight
/// direction and the orbit normal.
///
/// ```
/// use polhode::prelude::*;
/// use polhode::motion::{MU_EARTH, Orbit};
/// use polhode::motion::torque::{Attracted, GravityGradient};
/// use polhode::observe::OrbitalEquilibrium;
/// let inertia = InertiaTensor::diagonal([5.1, 6.2, 1.7])?;
/// let body = Rotor::free(&MassProperties::new(7.0, Position::ZERO, inertia)?);
/// let orbit = Orbit::circular(MU_EARTH, 6878e3, Direction::new(1.0, 0.0, 0.0), Direction::new(0.0, 1.0, 0.0))?;
/// let gravity = [TorqueModel::GravityGradient(Box::new(GravityGradient { orbit, attracted: Attracted::Tensor }))];
/// // It starts askew, at rest in space.
/// let start = State { time: 0.0, attitude: Attitude::from_euler313([1.9, 1.3, 0.1])?, omega: AngularVelocity::ZERO };
/// let all = OrbitalEquilibrium::all(&body, &gravity, start)?.ok_or("no orbit")?;
/// assert_eq!(all.len(), 24);
/// // The nearest has its long axis, that of moment 1.7, along the radius.
/// assert!(all[0].up.z.abs() > 1.0 - 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct OrbitalEquilibrium {
    /// Attitude and ω at the start's time.
    pub state: State,
    /// Direction away from the central body, body axes.
    pub up: Direction<Body>,
    /// Direction of flight, body axes.
    pub ahead: Direction<Body>,
    /// Orbit normal, up × ahead, body axes.
    pub normal: Direction<Body>,
    /// Principal axes nearest to these three directions, from 0, each with true if it points along
    /// the direction.
    pub axes: [(usize, bool); 3],
    /// Angle between the principal axes and these directions, rad; zero if the gravity gradient on
    /// the tensor is the only torque.
    pub tilt: f64,
}

/// Attitudes that differ by less than this count as the same, rad.
const SAME: f64 = 1e-6;

impl OrbitalEquilibrium {
    /// Finds all equilibria that Newton's method reaches from the 24 attitudes with principal axes
    /// along the orbital axes, and from the start's attitude; the nearest to the start's attitude
    /// first. `None` if no gravity gradient on a circular orbit acts.
    ///
    /// These are all equilibria if the moments are distinct and no other torque acts. If there is a
    /// continuous circle of them, as for a body with two equal moments, those along the principal
    /// axes represent it.
    ///
    /// # Errors
    /// [`MotionError::NotSteady`] if there is none, for example if another torque is not constant
    /// relative to the orbit; otherwise the errors of [`SmallOscillations::about_equilibrium`].
    pub fn all(
        rotor: &Rotor,
        torques: &[TorqueModel],
        start: State,
    ) -> Result<Option<Vec<Self>>, MotionError> {
        let Some(frame) = OrbitFrame::of(torques, start.time) else { return Ok(None) };
        let principal: Rotation<Principal, Body> = rotor.principal().rotation().inverse();
        let seeds = arrangements().map(|axes: Rotation<Space, Principal>| frame.axes * (axes * principal));
        let (mut found, mut last): (Vec<Self>, _) = (Vec::new(), None);
        for attitude in seeds.chain([start.attitude]) {
            let omega = attitude.inverse() * frame.omega;
            match SmallOscillations::equilibrium_near(rotor, torques, State { attitude, omega, ..start }) {
                Ok(state) if found.iter().all(|f| f.state.attitude.angle_to(state.attitude) > SAME) => {
                    found.push(Self::of(rotor, &frame, state));
                }
                Ok(_) => {}
                Err(error) => last = Some(error),
            }
        }
        found.sort_by(|a, b| {
            let away = |e: &Self| (e.state.attitude.angle_to(start.attitude) / SAME).round();
            away(a).total_cmp(&away(b))
        });
        match last {
            Some(error) if found.is_empty() => Err(error),
            _ => Ok(Some(found)),
        }
    }

    fn of(rotor: &Rotor, frame: &OrbitFrame, state: State) -> Self {
        let orbit = |x: f64, y: f64, z: f64| {
            state.attitude.inverse() * (frame.axes * Direction::<Space>::new(x, y, z))
        };
        let [up, ahead, normal] = [orbit(1.0, 0.0, 0.0), orbit(0.0, 1.0, 0.0), orbit(0.0, 0.0, 1.0)];
        let along = |k: usize, d: Direction<Body>| rotor.principal().axis(k).dot(d);
        let nearest = |d: Direction<Body>| {
            let k = (0..3).max_by(|&i, &j| along(i, d).abs().total_cmp(&along(j, d).abs())).unwrap_or(0);
            (k, along(k, d) > 0.0)
        };
        let axes = [up, ahead, normal].map(nearest);
        let tilts = [up, ahead, normal].into_iter().zip(axes).map(|(d, (k, is_along))| {
            let axis = rotor.principal().axis(k);
            d.angle_to(if is_along { axis } else { -axis })
        });
        Self { state, up, ahead, normal, axes, tilt: tilts.fold(0.0, f64::max) }
    }
}

/// Orbital axes at one time, and their rotation rate.
struct OrbitFrame {
    /// Rotation from x, y, z to the radius, the flight direction and the normal.
    axes: Rotation<Space, Space>,
    /// Angular velocity n along the normal, rad/s.
    omega: AngularVelocity<Space>,
}

impl OrbitFrame {
    fn of(torques: &[TorqueModel], time: f64) -> Option<Self> {
        let orbit: &Orbit = torques.iter().find_map(|torque| match torque.acting(time) {
            Some(TorqueModel::GravityGradient(gradient)) if gradient.orbit.is_circular() => {
                Some(&gradient.orbit)
            }
            _ => None,
        })?;
        let up: Direction<Space> = orbit.position(time).direction()?;
        let velocity: Direction<Space> = orbit.velocity(time).as_quantity();
        let normal = up.cross(velocity).direction()?;
        let axes = Rotation::from_axes([up, normal.cross(up), normal]);
        Some(Self { axes, omega: normal.as_quantity() * orbit.mean_motion()? })
    }
}

/// Returns the 24 rotations R that map the principal axes to the radius, flight and normal
/// directions with any signs and order.
fn arrangements() -> impl Iterator<Item = Rotation<Space, Principal>> {
    let unit = |k: usize, sign: f64| {
        Direction::<Space>::from_array(core::array::from_fn(|i| if i == k { sign } else { 0.0 }))
    };
    let signs = [[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]];
    let first = (0..3).flat_map(|k| [(k, (k + 1) % 3), (k, (k + 2) % 3)]);
    first.flat_map(move |(i, j)| {
        signs.map(|[a, b]| {
            let (x, y) = (unit(i, a), unit(j, b));
            Rotation::from_axes([x, y, x.cross(y)])
        })
    })
}
