//! Setup: checks an initial value problem and computes the variables of its first phase.

use super::equations::{Pivot, Regime};
use super::ground::{GroundShape, GroundSide};
use super::law::Grip;
use super::model::{GroundForm, Model};
use super::problem::ContactProblem;
use super::start::StartVelocity;
use super::stepper::Stepper;
use super::surface::SurfaceShape;
use super::watch::Kind;
use crate::math::algebra::Components;
use crate::motion::error::MotionError;
use crate::motion::model::require;
use crate::motion::model::rotor::Rotor;

/// Creates the stepper at the start, before the check if friction can hold the body.
pub(super) fn started(of: &ContactProblem<'_>) -> Result<Stepper, MotionError> {
    let (body, contact, start) = (of.body, of.contact, &of.start);
    for (what, value) in [
        ("the start's time", start.state.time),
        ("the start's attitude", start.state.attitude.quaternion().iter().sum()),
        ("the start's angular velocity", start.state.omega.norm()),
        ("the point of contact", start.at.norm()),
        ("the acceleration of gravity", contact.gravity.norm()),
    ] {
        require::finite(what, value)?;
    }
    let [least, ..] = Rotor::free(body).principal().moments();
    require::that(
        "the least principal moment about the centre of mass",
        least,
        least > 0.0,
        "positive: of a needle that touches a surface the spin about its line is not known",
    )?;
    require_inside(of)?;
    require_fit(of)?;
    // The lower rim is that at z = −½ thickness if the normal has a positive component along z.
    let normal = contact.ground.normal_at(start.at).ok_or(MotionError::NoDirection {
        parameter: "the point of contact from the axis of the ground",
        length: start.at.norm(),
    })?;
    let tilt = (contact.surface.axes().inverse() * (start.state.attitude.inverse() * normal)).z;
    if let SurfaceShape::Rim { thickness, .. } = *contact.surface.shape() {
        let rule = "not zero: a thick disk whose axis lies along the ground stands on both of its rims";
        require::that("the tilt of the disk", tilt, thickness == 0.0 || tilt != 0.0, rule)?;
    }
    let side = if tilt > 0.0 { -1.0 } else { 1.0 };
    let model = Model::of(body, &contact.surface, &contact.ground, &contact.law, contact.gravity, side);
    let length = match *contact.surface.shape() {
        SurfaceShape::Cylinder { length, .. } => length,
        _ => None,
    };
    let [x, y, z] = model.offset;
    let size = contact.surface.size() + x.hypot(y).hypot(z);
    let mut stepper =
        Stepper::new(model, contact.law, length, [size, of.bound()], start.state.time).perturbed(of.noise);
    let (kind, variables) = variables(of, &stepper)?;
    stepper.enter(kind, variables);
    if let Some(at) = stepper.kinetics(stepper.variables()).filter(|_| stepper.model.rolling != 0.0) {
        let along = at.relative - at.normal.scaled(at.relative.dot(at.normal));
        let rate = along.dot(along).sqrt();
        let moves = rate > 1e-13 * stepper.rate(stepper.variables());
        let rule = "not zero where rolling friction acts: it has no direction there";
        require::that("the rate of rolling", rate, moves, rule)?;
    }
    let flat = stepper.kinetics(stepper.variables()).filter(|at| stepper.model.lies_flat(at));
    let rule = "below one: a disk that lies flat touches with all of its rim";
    require::that("the tilt of the disk", tilt.abs(), flat.is_none(), rule)?;
    Ok(stepper)
}

/// Checks that the centre of mass is inside the surface.
///
/// # Errors
/// A parameter's error if the centre of mass is outside the surface.
fn require_inside(of: &ContactProblem<'_>) -> Result<(), MotionError> {
    let (surface, center) = (&of.contact.surface, of.body.center_of_mass());
    let rule =
        "inside the surface: no body that a convex surface bounds has its centre of mass outside of it";
    let distance = (center - surface.center()).norm();
    require::that(
        "the distance of the centre of mass from the centre of the surface",
        distance,
        surface.contains(center),
        rule,
    )
}

/// Checks that a body inside a curved ground touches it at one point only.
///
/// # Errors
/// A parameter's error if the body may touch at more than one point.
fn require_fit(of: &ContactProblem<'_>) -> Result<(), MotionError> {
    let (GroundShape::Sphere { radius, side } | GroundShape::Cylinder { radius, side }) =
        *of.contact.ground.shape()
    else {
        return Ok(());
    };
    if side == GroundSide::Outside {
        return Ok(());
    }
    // By Blaschke's theorem, a convex body rolls freely inside a surface whose curvature is nowhere
    // larger than that of the body.
    let flattest = match *of.contact.surface.shape() {
        SurfaceShape::Sphere { radius } | SurfaceShape::Cylinder { radius, .. } => radius,
        SurfaceShape::Rim { radius, tube, .. } => radius + tube,
        SurfaceShape::Ellipsoid { semi_axes: [a, b, c] } => {
            let (longest, shortest) = (a.max(b).max(c), a.min(b).min(c));
            longest * longest / shortest
        }
    };
    let rule = "larger than each radius of curvature of the body: else it touches in more than one point";
    require::that("the radius of the ground", radius, flattest < radius, rule)
}

/// Returns the variables of a start, and its kind of contact.
///
/// # Errors
/// A parameter's error if the start violates the contact.
fn variables(of: &ContactProblem<'_>, stepper: &Stepper) -> Result<(Kind, Vec<f64>), MotionError> {
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
    let y_of_start = y.clone();
    if model.axis_inertia.is_some() {
        let Components([x, y, _]) = rolling.omega;
        let rule = "zero: a cylinder that lies turns about its own axis alone";
        let holds = x.hypot(y) <= 1e-9 * stepper.rate(&y_of_start);
        require::that("the angular velocity of a cylinder across its axis", x.hypot(y), holds, rule)?;
        let tilt = rolling.normal.0[2];
        let rule = "zero: its axis lies along the ground";
        require::that("the tilt of a lying cylinder", tilt, tilt.abs() <= 1e-9, rule)?;
        if let GroundForm::Cylinder { .. } = model.ground {
            let across = e3[2].abs() - 1.0;
            let rule = "zero: it touches along a line";
            require::that("the angle between two touching cylinders", across, across.abs() <= 1e-9, rule)?;
        }
        let rule = "a plane or a cylinder";
        let holds = !matches!(model.ground, GroundForm::Sphere { .. });
        require::that("the ground of a lying cylinder", f64::NAN, holds, rule)?;
        require_cylinder(of, stepper)?;
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

/// Checks that the axis of a lying cylinder keeps its direction.
///
/// # Errors
/// A parameter's error if it does not.
fn require_cylinder(of: &ContactProblem<'_>, stepper: &Stepper) -> Result<(), MotionError> {
    let model = &stepper.model;
    let [[_, _, xz], [_, _, yz], [_, _, zz]] = model.inertia;
    let product = xz.hypot(yz);
    let rule = "zero: a cylinder that lies turns about a principal axis";
    require::that(
        "the products of inertia with the axis of a cylinder",
        product,
        product <= 1e-9 * zz,
        rule,
    )?;
    let turning = of.contact.ground.turning();
    let rule = "zero: a cylinder that lies keeps the direction of its axis";
    require::that("the rate of the ground below a lying cylinder", turning, turning == 0.0, rule)?;
    let rule = "zero: a cylinder that lies does not pivot";
    require::that("the lever of pivoting friction", model.pivoting, model.pivoting == 0.0, rule)
}
