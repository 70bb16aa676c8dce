//! Where a motion on the ground starts.

use super::equations::{Pivot, Regime};
use super::law::Grip;
use super::model::GroundForm;
use super::phase::Kind;
use super::simulation::ContactSimulation;
use super::stepper::Stepper;
use crate::math::algebra::Components;
use crate::math::frame::Space;
use crate::math::vector::{Position, Velocity};
use crate::motion::error::MotionError;
use crate::motion::model::require;
use crate::motion::model::state::State;

/// How the centre of mass moves at the start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum StartVelocity {
    /// As it must, so that the body rolls.
    Rolling,
    /// With this velocity, of which only what lies in the ground counts: the rest follows from the contact.
    Along(Velocity<Space>),
}

/// Where a motion on the ground starts: attitude and ω, the point of the ground that is touched, and how the centre of mass moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactStart {
    /// Time, attitude and ω.
    pub state: State,
    /// The point of the ground that is touched.
    pub at: Position<Space>,
    /// The velocity of the centre of mass.
    pub velocity: StartVelocity,
}

impl ContactStart {
    /// Rolling, from the origin of a plane.
    pub const fn rolling(state: State) -> Self {
        Self { state, at: Position::ZERO, velocity: StartVelocity::Rolling }
    }
}

/// The variables of a start, and whether the body slides.
///
/// # Errors
/// A parameter's error where the start violates the contact.
pub(super) fn variables(
    of: &ContactSimulation<'_>,
    stepper: &Stepper,
) -> Result<(Kind, Vec<f64>), MotionError> {
    let (model, start) = (&stepper.model, &of.start);
    let size = stepper.size();
    let height = of.contact.ground.height_of(start.at);
    let rule = "zero: above the ground the body hovers, below it penetrates";
    let touches = height.abs() <= 1e-9 * (size + start.at.norm());
    require::that("the height of the point of contact above the ground", height, touches, rule)?;
    let ground_surface = (model.in_space.inverse() * start.state.attitude * model.in_body).matrix();
    let [e1, _, e3] = ground_surface;
    let omega = model.in_body.inverse() * start.state.omega;
    let place = model.ground.place((model.in_space.inverse() * start.at).to_array());
    let mut y: Vec<f64> = e1.into_iter().chain(e3).chain(omega.to_array()).chain(place).collect();
    y.extend([0.0; 2]);
    let rolling = model.kinetics(1.0, &y, Regime::Rolling, Pivot::Turning(0.0));
    if model.axis_inertia.is_some() {
        let Components([x, y, _]) = rolling.omega;
        let rule = "zero: a cylinder that lies turns about its own axis alone";
        let holds =
            x.hypot(y) <= 1e-9 * stepper.rate(&[[0.0; 6].to_vec(), omega.to_array().to_vec()].concat());
        require::that("the angular velocity of a cylinder across its axis", x.hypot(y), holds, rule)?;
        let tilt = rolling.normal.0[2];
        let rule = "zero: its axis lies along the ground";
        require::that("the tilt of a cylinder that lies", tilt, tilt.abs() <= 1e-9, rule)?;
        if let GroundForm::Cylinder { .. } = model.ground {
            let across = e3[2].abs() - 1.0;
            let rule = "zero: it touches along a line";
            require::that("the angle between two cylinders that touch", across, across.abs() <= 1e-9, rule)?;
        }
        let rule = "a plane or a cylinder";
        let holds = !matches!(model.ground, GroundForm::Sphere { .. });
        require::that("the ground of a cylinder that lies", f64::NAN, holds, rule)?;
    }
    let rolls = (Kind::Touching(Regime::Rolling, Pivot::Turning(0.0)), y.clone());
    let slides = |slip| (Kind::Touching(Regime::Sliding, Pivot::Turning(0.0)), rolling.sliding(&y, slip));
    let law = &of.contact.law;
    let never_sticks =
        *law.grip() != Grip::NoSlip && law.friction().kinetic == 0.0 && law.friction().sticking == 0.0;
    let speed = stepper.speed(&y);
    let StartVelocity::Along(velocity) = start.velocity else {
        return Ok(if never_sticks { slides(Components([0.0; 3])) } else { rolls });
    };
    require::finite("the velocity of the centre of mass", velocity.norm())?;
    let given =
        Components((model.in_body.inverse() * (start.state.attitude.inverse() * velocity)).to_array());
    let needed = rolling.carried - rolling.omega.cross(rolling.arm);
    let n = rolling.normal;
    let (along, across) = (given.dot(n), needed.dot(n));
    let size = speed + velocity.norm();
    let rule = "zero, or what the contact makes it: else the body leaves the ground, or enters it";
    let holds = along.abs() <= 1e-9 * size || (along - across).abs() <= 1e-9 * size;
    require::that("the velocity of the centre of mass along the normal", along, holds, rule)?;
    let slip = (given - n.scaled(along)) - (needed - n.scaled(across));
    let fast = slip.dot(slip).sqrt();
    if *law.grip() == Grip::NoSlip {
        let rule = "zero: the point of contact of what rolls has the velocity of the ground";
        require::that("the slip at the start", fast, fast <= 1e-9 * size, rule)?;
        return Ok(rolls);
    }
    Ok(if !never_sticks && fast <= 1e-13 * size { rolls } else { slides(slip) })
}
