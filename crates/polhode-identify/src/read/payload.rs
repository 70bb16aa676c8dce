//! Table `[payload]`: wrenches and motion of a force–torque sensor.

use polhode::infer::judge::AttitudeSense;
use polhode::math::Acceleration;
use polhode_source::FormatError;
use polhode_source::toml::reader::{Table, Value};
use polhode_source::unit::Dimension;

use super::at;
use super::gravity::Gravity;
use super::read_log::ReadLog;
use super::wrench_log;
use crate::payload::{EdgeKind, MotionNoise, PayloadLog, WrenchNoise, WrenchSense};

/// Payload measurement, ready to be identified.
#[derive(Clone, Debug, PartialEq)]
pub struct PayloadPlan {
    /// Rows, noise and options.
    pub log: PayloadLog,
    /// Origin of the rows.
    pub source: ReadLog,
}

const KEYS: [&str; 10] =
    ["log", "columns", "units", "wrench", "gravity", "attitude", "bias", "noise", "motion_noise", "kind"];

/// Reads the table `[payload]`.
pub(crate) fn plan(table: &Table<'_>) -> Result<PayloadPlan, FormatError> {
    table.allow(&KEYS)?;
    let sense = match table
        .require("wrench", "wrench = \"on sensor\" if the force at rest points down, \"on payload\" if up")?
        .choice(&["on payload", "on sensor"])?
    {
        "on payload" => WrenchSense::OnPayload,
        _ => WrenchSense::OnSensor,
    };
    let value = table.require("log", "log = \"payload.csv\"")?;
    let read = wrench_log::read(
        &value,
        table.get("columns").map(|columns| columns.table()).transpose()?,
        table.get("units").map(|units| units.table()).transpose()?,
        &gravity(table)?,
    )?;
    let mut log = PayloadLog::new(read.rows, sense).map_err(|error| at(&value, &error))?;
    if table.get("bias").map_or(Ok(false), |bias| bias.boolean())? {
        log = log.with_bias();
    }
    if let Some(noise) = table.get("noise") {
        log = log.with_noise(wrench_noise(&noise)?).map_err(|error| at(&noise, &error))?;
    }
    if let Some(noise) = table.get("motion_noise") {
        log = log.with_motion_noise(motion_noise(&noise)?).map_err(|error| at(&noise, &error))?;
    }
    if let Some(kind) = table.get("kind") {
        log = log.with_kind(match kind.choice(&["plate", "rod"])? {
            "plate" => EdgeKind::Lamina,
            _ => EdgeKind::Rod,
        });
    }
    Ok(PayloadPlan { log, source: read.source })
}

/// Returns the source of gravity: columns, or the entry `gravity` along axes of space with
/// attitudes.
fn gravity<'a>(table: &Table<'a>) -> Result<Gravity<'a>, FormatError> {
    let Some(value) = table.get("gravity") else {
        return match table.get("attitude") {
            Some(attitude) => Err(attitude
                .invalid("omitted, or used together with gravity")
                .with_hint("write gravity = [0, 0, \"-9.80665 m/s^2\"], along space axes")),
            None => Ok(Gravity::Logged),
        };
    };
    let told = Acceleration::from_array(value.quantities(Dimension::ACCELERATION)?);
    if told == Acceleration::ZERO {
        return match table.get("attitude") {
            Some(attitude) => Err(attitude.invalid("omitted if gravity is zero")),
            None => Ok(Gravity::None),
        };
    }
    let example = "attitude = \"body-to-space\", if the log's quaternions transform vectors from sensor axes to space axes";
    let sense = match table.require("attitude", example)?.choice(&["body-to-space", "space-to-body"])? {
        "body-to-space" => AttitudeSense::BodyToSpace,
        _ => AttitudeSense::SpaceToBody,
    };
    Ok(Gravity::Turned { value: Box::new(value), told, sense })
}

/// Reads `noise = { force = "0.05 N", torque = "2e-3 N m" }`, or `{ covariance = […] }` with six
/// rows of fx, fy, fz, tx, ty, tz in N and N·m.
fn wrench_noise(value: &Value<'_>) -> Result<WrenchNoise, FormatError> {
    let table = value.table()?;
    table.allow(&["force", "torque", "covariance"])?;
    let rule = "noise is either the standard deviations of force and torque, or a covariance";
    for key in ["force", "torque"] {
        table.at_most_one(&[key, "covariance"], rule)?;
    }
    if let Some(covariance) = table.get("covariance") {
        let mut matrix = [[0.0; 6]; 6];
        for (row, given) in matrix.iter_mut().zip(covariance.fixed::<6>("rows of six numbers")?) {
            for (element, number) in row.iter_mut().zip(given.fixed::<6>("numbers, in N and N m")?) {
                *element = number.number()?;
            }
        }
        return Ok(WrenchNoise::Covariance(matrix));
    }
    let force = table.require("force", "force = \"0.05 N\"")?;
    let torque = table.require("torque", "torque = \"2e-3 N m\"")?;
    let above_zero = |value: Value<'_>, dimension| match value.quantity(dimension)? {
        sd if sd > 0.0 => Ok(sd),
        _ => Err(value
            .invalid("positive")
            .with_hint("it is a standard deviation; remove noise to estimate it from the log")),
    };
    Ok(WrenchNoise::Deviations {
        force: above_zero(force, Dimension::FORCE)?,
        torque: above_zero(torque, Dimension::TORQUE)?,
    })
}

/// Reads
/// `motion_noise = { omega = "0.01 rad/s", alpha = "0.2 rad/s^2", acceleration = "0.05 m/s^2" }`.
fn motion_noise(value: &Value<'_>) -> Result<MotionNoise, FormatError> {
    let table = value.table()?;
    table.allow(&["omega", "alpha", "acceleration"])?;
    let deviation = |key, dimension| match table.get(key) {
        None => Ok(0.0),
        Some(value) => match value.quantity(dimension)? {
            sd if sd >= 0.0 => Ok(sd),
            _ => Err(value.invalid("zero or positive").with_hint("it is a standard deviation")),
        },
    };
    let noise = MotionNoise {
        omega: deviation("omega", Dimension::ANGULAR_VELOCITY)?,
        alpha: deviation("alpha", Dimension::ANGULAR_ACCELERATION)?,
        acceleration: deviation("acceleration", Dimension::ACCELERATION)?,
    };
    if [noise.omega, noise.alpha, noise.acceleration] == [0.0; 3] {
        let error = value.invalid(
            "a table with at least one standard deviation above zero, of omega, alpha or acceleration",
        );
        return Err(error.with_hint("remove motion_noise if the motion has no noise"));
    }
    Ok(noise)
}
