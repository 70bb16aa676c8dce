//! `[start]`: attitude, spin and velocity at t = 0.

use polhode::math::{AngularMomentum, AngularVelocity, Attitude, Body, Orbital, Rotation, Space, Velocity};
use polhode::motion::{Orbit, Rotor, State};
use polhode_source::toml::reader::{Table, Value};
use polhode_source::toml::rotation;
use polhode_source::unit::Dimension;
use polhode_source::{FormatError, FormatErrorKind};

/// Start of a motion.
pub(crate) struct Start<'a> {
    pub state: State,
    pub velocity: Option<Velocity<Space>>,
    /// Values that a prescribed motion does not accept.
    pub spin: Option<Value<'a>>,
    pub attitude: Option<Value<'a>>,
}

/// Reads `[start]`; by default the body is at rest with its axes along the space axes.
///
/// If `relative_to = "orbit"`, the attitude and the spin are relative to the local vertical and
/// horizontal axes.
pub(crate) fn start<'a>(
    root: &Table<'a>,
    rotor: &Rotor,
    orbit: Option<&Orbit>,
) -> Result<Start<'a>, FormatError> {
    let mut start = Start {
        state: State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::ZERO },
        velocity: None,
        spin: None,
        attitude: None,
    };
    let Some(table) = root.get("start") else { return Ok(start) };
    let table = table.table()?;
    table.allow(&["spin", "attitude", "velocity", "relative_to"])?;
    (start.spin, start.attitude) = (table.get("spin"), table.get("attitude"));
    match table.get("relative_to") {
        Some(value) if value.choice(&["space", "orbit"])? == "orbit" => {
            let orbit = orbit.ok_or_else(|| {
                let hint = "write [orbit] on a line of its own, and under it altitude = \"500 km\"";
                value.invalid("\"space\", since there is no [orbit]").with_hint(hint)
            })?;
            if let Some(given) = start.spin.or(start.attitude).filter(|_| root.get("prescribed").is_some()) {
                let hint = "a prescribed motion has its own start: leave out relative_to";
                return Err(given.invalid("left out with [prescribed]").with_hint(hint));
            }
            start.state = on_orbit(&start, orbit)?;
        }
        _ => {
            if let Some(value) = &start.attitude {
                start.state.attitude = rotation(value)?;
            }
            if let Some(value) = &start.spin {
                start.state.omega = spin(value, start.state.attitude, rotor)?;
            }
        }
    }
    if let Some(value) = table.get("velocity") {
        if orbit.is_some() {
            let rule = "left out, since [orbit] defines the motion of the centre of mass";
            return Err(value.invalid(rule).with_hint("write position and velocity under [orbit]"));
        }
        start.velocity = Some(Velocity::from_array(value.quantities(Dimension::VELOCITY)?));
        if rotor.is_pivoted() {
            let rule = "left out, since a point of the body is held at a pivot";
            return Err(value.invalid(rule).with_hint("a body with a pivot only rotates: give its spin"));
        }
    }
    Ok(start)
}

/// Returns attitude and ω of a start given relative to the rotating orbital axes.
fn on_orbit(start: &Start<'_>, orbit: &Orbit) -> Result<State, FormatError> {
    let mut relative = Rotation::<Orbital, Body>::identity();
    if let Some(value) = &start.attitude {
        relative = rotation(value)?;
    }
    let attitude = orbit.local_axes(0.0) * relative;
    let mut omega = attitude.inverse() * orbit.angular_velocity(0.0);
    if let Some(value) = &start.spin {
        let table = value.table()?;
        table.allow(&["body"])?;
        let given = table.require("body", "{ body = [\"0 rad/s\", \"0 rad/s\", \"0.1 rad/s\"] }")?;
        omega += AngularVelocity::from_array(given.quantities(Dimension::ANGULAR_VELOCITY)?);
    }
    Ok(State { time: 0.0, attitude, omega })
}

/// Reads `{ body = [3] }`, `{ space = [3] }` or `{ momentum = [3] }`: ω along body or space axes,
/// or L along space axes.
fn spin(value: &Value<'_>, attitude: Attitude, rotor: &Rotor) -> Result<AngularVelocity<Body>, FormatError> {
    let table = value.table()?;
    table.allow(&["body", "space", "momentum"])?;
    let Some(given) = table.at_most_one(&["body", "space", "momentum"], "give the spin in one way only")?
    else {
        return Err(table.missing("body", "{ body = [\"0 rad/s\", \"0 rad/s\", \"12 rad/s\"] }"));
    };
    Ok(match given.key() {
        "body" => AngularVelocity::from_array(given.quantities(Dimension::ANGULAR_VELOCITY)?),
        "space" => {
            let omega = AngularVelocity::<Space>::from_array(given.quantities(Dimension::ANGULAR_VELOCITY)?);
            attitude.inverse() * omega
        }
        _ => {
            let momentum =
                AngularMomentum::<Space>::from_array(given.quantities(Dimension::ANGULAR_MOMENTUM)?);
            of_momentum(&given, attitude.inverse() * momentum - rotor.wheel_momentum(0.0), rotor)?
        }
    })
}

/// Returns ω = Σ n_k (n_k · (L − h)) / i_k, summed over the principal axes about the pivot or
/// centre of mass.
///
/// L must vanish along an axis without inertia, and ω is set to zero there.
fn of_momentum(
    given: &Value<'_>,
    momentum: AngularMomentum<Body>,
    rotor: &Rotor,
) -> Result<AngularVelocity<Body>, FormatError> {
    /// Relative size of a component below which it is a rounding error.
    const ROUNDING: f64 = 1e-12;
    let mut omega = AngularVelocity::ZERO;
    let moments = rotor.principal().moments();
    if moments[2] == 0.0 && momentum.norm() > 0.0 {
        return Err(given
            .invalid("zero: the body has no inertia about any axis")
            .with_hint("give the spin instead: { body = [...] }"));
    }
    for (k, &moment) in moments.iter().enumerate() {
        let axis = rotor.principal().axis(k);
        let component = axis.dot(momentum);
        if moment > ROUNDING * moments[2] {
            omega += AngularVelocity::from_array((axis * (component / moment)).to_array());
        } else if component.abs() > ROUNDING * momentum.norm() {
            let [x, y, z] = axis.to_array();
            let rule = format!("across the axis ({x}, {y}, {z}) of the body, about which it has no inertia");
            return Err(given.invalid(rule).with_hint("give the spin instead: { body = [...] }"));
        }
    }
    if omega.is_finite() {
        return Ok(omega);
    }
    let error =
        polhode::body::BodyError::Parameter { what: "the spin", value: omega.max_abs(), rule: "finite" };
    Err(given.error(FormatErrorKind::Body(error)))
}
