//! `[[wheel]]`: wheels in the body.

use polhode::math::{AngularVelocity, Body, Direction};
use polhode::motion::torque::Schedule;
use polhode::motion::{MotionError, Motor, Rotor, Wheel};
use polhode_source::FormatError;
use polhode_source::toml::reader::{Table, Value};
use polhode_source::unit::Dimension;

/// Wheel as defined in its table. Its speed relative to space is known only with the angular
/// velocity of the body.
pub(crate) struct WheelTable<'a> {
    pub name: Option<String>,
    axis: Direction<Body>,
    given: Given,
    motor: Motor,
    /// Value to which an error about the size of the wheel refers.
    value: Value<'a>,
}

#[derive(Clone, Copy, Debug)]
enum Given {
    /// Angular momentum: relative to the body if the speed is held, else relative to space.
    Momentum(f64),
    /// Inertia J and speed Ω relative to the body.
    Speed(f64, f64),
}

/// Reads all wheels.
pub(crate) fn wheels<'a>(root: &Table<'a>) -> Result<Vec<WheelTable<'a>>, FormatError> {
    let Some(list) = root.get("wheel") else { return Ok(Vec::new()) };
    list.tables("wheel")?.iter().map(wheel).collect()
}

/// Reads `name`; `axis`; `momentum`, or `inertia` and `speed`; `motor_torque`, which requires
/// `inertia`; `from` and `until`.
fn wheel<'a>(table: &Table<'a>) -> Result<WheelTable<'a>, FormatError> {
    table.allow(&["name", "axis", "momentum", "inertia", "speed", "motor_torque", "from", "until"])?;
    let axis = table.require("axis", "axis = [0, 0, 1]")?;
    let direction = Direction::from_array(axis.numbers()?);
    let rule = "each of them alone defines the initial angular momentum of the wheel";
    let Some(start) = table.at_most_one(&["momentum", "speed"], rule)? else {
        return Err(match table.get("inertia") {
            Some(_) => table.missing("speed", "speed = \"600 rpm\""),
            None => table.missing("momentum", "momentum = \"4 N m s\", or inertia and speed"),
        });
    };
    let is_speed = start.key() == "speed";
    let motor_torque = table.get("motor_torque");
    if !is_speed
        && motor_torque.is_none()
        && let Some(value) = table.get("inertia")
    {
        let hint = "with momentum and without motor_torque it has no effect";
        return Err(value.invalid("left out").with_hint(hint));
    }
    // Without speed or motor torque the inertia is not needed, and errors refer to the axis.
    let (mut inertia, mut value) = (0.0, axis);
    if is_speed || motor_torque.is_some() {
        value = table.require("inertia", "inertia = \"0.02 kg m^2\", about the wheel's axis")?;
        inertia = positive_inertia(&value)?;
    }
    let given = if is_speed {
        Given::Speed(inertia, start.quantity(Dimension::ANGULAR_VELOCITY)?)
    } else {
        Given::Momentum(start.quantity(Dimension::ANGULAR_MOMENTUM)?)
    };
    let motor = motor(table, motor_torque, inertia)?;
    // Errors in the axis or the sizes are reported at their places.
    Wheel::new(direction, 0.0, motor).map_err(|error| {
        axis.motion(error).with_hint("the z axis is [0, 0, 1]; its length does not matter")
    })?;
    let name = table.get("name").map(|name| name.string().map(str::to_owned)).transpose()?;
    let wheel = WheelTable { name, axis: direction, given, motor, value };
    wheel.locked().map_err(|error| start.motion(error))?;
    Ok(wheel)
}

fn positive_inertia(value: &Value<'_>) -> Result<f64, FormatError> {
    let inertia = value.quantity(Dimension::INERTIA)?;
    if inertia > 0.0 {
        return Ok(inertia);
    }
    Err(value.invalid("positive").with_hint("it is the wheel's moment of inertia about its own axis"))
}

/// Reads the motor; without `motor_torque` the speed is held.
fn motor(table: &Table<'_>, torque: Option<Value<'_>>, inertia: f64) -> Result<Motor, FormatError> {
    let times = ["from", "until"].map(|key| table.get(key));
    let Some(torque) = torque else {
        let Some(value) = times.iter().flatten().next() else { return Ok(Motor::HeldSpeed) };
        let hint = "it limits the time of motor_torque; without motor_torque the wheel's speed is constant";
        return Err(value.invalid("left out").with_hint(hint));
    };
    let size = torque.quantity(Dimension::TORQUE)?;
    let time = |value: &Value<'_>| value.quantity(Dimension::TIME);
    let [from, until] = times;
    let first = from.as_ref().map_or(Ok(f64::NEG_INFINITY), time)?;
    let last = until.as_ref().map_or(Ok(f64::INFINITY), time)?;
    if let Some(value) = until.filter(|_| !(last > first.max(0.0))) {
        let hint = "a run starts at 0; the motor works from `from` (default: 0) until `until`";
        return Err(value.invalid("later than the start of the motor").with_hint(hint));
    }
    let always = from.is_none() && until.is_none();
    let window = || Schedule::window(first, last).map_err(|error| torque.motion(error));
    let schedule = (!always).then(window).transpose()?;
    Ok(Motor::Torque { inertia, torque: size, schedule })
}

impl WheelTable<'_> {
    /// Returns the wheel for L = I ω + h at the start. A wheel given by its speed counts as held,
    /// with its inertia included in the body.
    fn locked(&self) -> Result<Wheel, MotionError> {
        match self.given {
            Given::Momentum(momentum) => Wheel::new(self.axis, momentum, self.motor),
            Given::Speed(inertia, speed) => Wheel::new(self.axis, inertia * speed, Motor::HeldSpeed),
        }
    }

    fn turning(&self, omega: AngularVelocity<Body>) -> Result<Wheel, MotionError> {
        match self.given {
            Given::Speed(_, speed) if self.motor != Motor::HeldSpeed => {
                Wheel::turning(self.axis, speed, self.motor, omega)
            }
            _ => self.locked(),
        }
    }
}

/// Returns the body with its wheels at the start, for which L = I ω + h determines ω.
pub(crate) fn locked(rotor: &Rotor, wheels: &[WheelTable<'_>]) -> Result<Rotor, FormatError> {
    fitted(rotor, wheels, WheelTable::locked).map(|(rotor, _)| rotor)
}

/// Returns the wheels in a body with initial angular velocity ω.
pub(crate) fn turning(
    rotor: &Rotor,
    wheels: &[WheelTable<'_>],
    omega: AngularVelocity<Body>,
) -> Result<Vec<Wheel>, FormatError> {
    fitted(rotor, wheels, |wheel| wheel.turning(omega)).map(|(_, wheels)| wheels)
}

/// Adds the wheels one by one, so that an error refers to the wheel that causes it.
fn fitted<'a>(
    rotor: &Rotor,
    tables: &[WheelTable<'a>],
    wheel: impl Fn(&WheelTable<'a>) -> Result<Wheel, MotionError>,
) -> Result<(Rotor, Vec<Wheel>), FormatError> {
    let (mut wheels, mut with) = (Vec::new(), rotor.clone());
    for table in tables {
        let refuse =
            |error| table.value.motion(error).with_hint("the inertia of [body] includes the locked wheels");
        wheels.push(wheel(table).map_err(refuse)?);
        // The inertia of a held wheel is part of the body's. Treating the wheel as free checks
        // that its inertia does not exceed that of the body.
        if let (Given::Speed(inertia, _), Motor::HeldSpeed) = (table.given, table.motor) {
            let free = Motor::Torque { inertia, torque: 0.0, schedule: None };
            let part = Wheel::new(table.axis, 0.0, free).map_err(refuse)?;
            rotor.clone().with_wheels(&[part]).map_err(refuse)?;
        }
        with = rotor.clone().with_wheels(&wheels).map_err(refuse)?;
    }
    Ok((with, wheels))
}
