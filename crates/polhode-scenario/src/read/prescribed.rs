//! `[prescribed]` motion.

use polhode::body::{Finding, Severity};
use polhode::math::formula::Formula;
use polhode::math::{Attitude, Direction};
use polhode::motion::{MotionError, Prescribed, RateAxes, Run};
use polhode_source::FormatError;
use polhode_source::expression::formula_of_time;
use polhode_source::toml::reader::{Table, Value};
use polhode_source::unit::Dimension;

use super::motion_table;
use super::rows::Rows;
use super::start::Start;

/// Keys that select the form of the motion.
const FORMS: [&str; 6] = ["axis", "euler313", "angles", "quaternion", "omega", "table"];

/// Reads `[prescribed]`: exactly one of [`FORMS`], with its own keys. A motion that is integrated
/// or read from a table must cover the whole run.
pub(crate) fn prescribed(
    root: &Table<'_>,
    start: &Start<'_>,
    run: Option<&Run>,
    findings: &mut Vec<Finding>,
) -> Result<Option<Prescribed>, FormatError> {
    let Some(value) = root.get("prescribed") else { return Ok(None) };
    let table = value.table()?;
    let own = [&FORMS[..], &["rate", "acceleration", "rates", "columns"]].concat();
    table.allow(&own)?;
    let Some(form) = table.at_most_one(&FORMS, "give the motion in one way only")? else {
        return Err(table.missing("axis", "axis = [0, 0, 1] and rate = \"3 rad/s\""));
    };
    if let Some(spin) = &start.spin {
        return Err(spin
            .invalid("left out, since the prescribed motion has its own")
            .with_hint("leave out spin"));
    }
    belongs(&table, form.key())?;
    let end = run.and_then(|run| run.times.last().copied()).unwrap_or_default();
    let motion = match form.key() {
        "axis" => fixed_axis(&table, &form, start.state.attitude)?,
        "euler313" => {
            no_attitude(start, "the Euler angles of the prescribed motion are the attitude")?;
            euler_rates(&table, &form)?
        }
        "angles" => {
            no_attitude(start, "the Euler angles of the prescribed motion are the attitude")?;
            Prescribed::EulerAngles(formulas(&form, Dimension::ANGLE, findings)?)
        }
        "quaternion" => {
            no_attitude(start, "the quaternion of the prescribed motion is the attitude")?;
            Prescribed::Quaternion(formulas(&form, Dimension::NONE, findings)?)
        }
        "omega" => omega(&form, start.state.attitude, end, findings)?,
        _ => tabled(&table, &form, start, findings)?,
    };
    covers(&motion, &form, end)?;
    // A value that is not finite at the start is an error in the formula.
    let first = motion.span().map_or(0.0, |[first, _]| first.max(0.0));
    motion.at(first).map_err(|error| refused(&form, error))?;
    Ok(Some(motion))
}

/// Refuses the keys of other forms.
fn belongs(table: &Table<'_>, form: &'static str) -> Result<(), FormatError> {
    let (others, rule): (&[&'static str], _) = match form {
        "axis" => (&["rates", "columns"], "rates belong to euler313"),
        "euler313" => (&["rate", "acceleration", "columns"], "Euler angles change by their rates"),
        "table" => (&["rate", "acceleration", "rates"], "the table is the motion"),
        _ => (&["rate", "acceleration", "rates", "columns"], "the formulas are the motion"),
    };
    for other in others {
        table.at_most_one(&[form, other], rule)?;
    }
    Ok(())
}

fn no_attitude(start: &Start<'_>, since: &str) -> Result<(), FormatError> {
    match &start.attitude {
        Some(attitude) => {
            Err(attitude.invalid(format!("left out, since {since}")).with_hint("leave out attitude"))
        }
        None => Ok(()),
    }
}

fn fixed_axis(table: &Table<'_>, form: &Value<'_>, attitude: Attitude) -> Result<Prescribed, FormatError> {
    let rate = table.require("rate", "rate = \"3 rad/s\"")?.quantity(Dimension::ANGULAR_VELOCITY)?;
    let acceleration = table.get("acceleration");
    let acceleration = acceleration.map_or(Ok(0.0), |a| a.quantity(Dimension::ANGULAR_ACCELERATION))?;
    let axis = Direction::from_array(form.numbers()?);
    Prescribed::fixed_axis(attitude, axis, rate, acceleration)
        .map_err(|e| form.motion(e).with_hint("the z axis is [0, 0, 1]; its length does not matter"))
}

fn euler_rates(table: &Table<'_>, form: &Value<'_>) -> Result<Prescribed, FormatError> {
    let rates = table.require("rates", "rates = [\"2 rad/s\", 0, \"30 rad/s\"]")?;
    let rates = rates.quantities(Dimension::ANGULAR_VELOCITY)?;
    Prescribed::euler_rates(form.quantities(Dimension::ANGLE)?, rates).map_err(|e| form.motion(e))
}

/// Reads `omega = { body = [three formulas] }`, or `space`.
fn omega(
    form: &Value<'_>,
    attitude: Attitude,
    end: f64,
    findings: &mut Vec<Finding>,
) -> Result<Prescribed, FormatError> {
    let table = form.table()?;
    table.allow(&["body", "space"])?;
    let Some(given) = table.at_most_one(&["body", "space"], "give ω in one way only")? else {
        return Err(table.missing("body", "omega = { body = [\"0\", \"0\", \"2[rad/s^2]*t\"] }"));
    };
    let axes = if given.key() == "body" { RateAxes::Body } else { RateAxes::Space };
    let given_as = formulas(&given, Dimension::ANGULAR_VELOCITY, findings)?;
    let motion = Prescribed::omega(attitude, axes, given_as, end);
    let motion = motion.map_err(|error| refused(&given, error))?;
    findings.extend(integrated(&motion));
    Ok(motion)
}

/// Reads `table = "motion.csv"`, and the selected columns.
fn tabled(
    table: &Table<'_>,
    form: &Value<'_>,
    start: &Start<'_>,
    findings: &mut Vec<Finding>,
) -> Result<Prescribed, FormatError> {
    let columns = table.get("columns").map(|value| value.choice(&motion_table::COLUMNS)).transpose()?;
    let rows = motion_table::read(form, columns)?;
    let (motion, uncertainty) = match &*rows {
        Rows::Attitude { times, attitudes } => {
            no_attitude(start, "the attitudes of the table are the motion")?;
            Prescribed::attitude_table(times, attitudes)
        }
        Rows::Omega { axes, times, omega } => {
            Prescribed::omega_table(start.state.attitude, *axes, times, omega)
        }
    }
    .map_err(|error| form.motion(error))?;
    findings.push(motion_table::finding(&uncertainty));
    findings.extend(integrated(&motion));
    Ok(motion)
}

/// Reads N formulas of t with values of this dimension; a number in SI counts as a formula.
fn formulas<const N: usize>(
    value: &Value<'_>,
    dimension: Dimension,
    findings: &mut Vec<Finding>,
) -> Result<[Formula; N], FormatError> {
    let mut formulas = std::array::from_fn(|_| Formula::constant(0.0));
    for (formula, element) in formulas.iter_mut().zip(value.fixed::<N>("formulas of t")?) {
        *formula = match element.string() {
            Ok(text) => formula_of_time(text, dimension).map_err(|error| element.formula(error))?,
            Err(_) => Formula::constant(element.quantity(dimension)?),
        };
        if let Some(function) = formula.rough_function() {
            findings.push(Finding {
                code: "prescribed.corner",
                severity: Severity::Info,
                message: format!(
                    "{function} in a formula of the motion: ω jumps or has a corner there, and no sample shows the torque at that time"
                ),
                place: None,
            });
        }
    }
    Ok(formulas)
}

/// Refuses a motion that ends before the run.
fn covers(motion: &Prescribed, form: &Value<'_>, end: f64) -> Result<(), FormatError> {
    match motion.span() {
        Some([first, last]) if end > 0.0 && (first > 0.0 || last < end) => {
            let rule = format!("as long as the run, 0 to {end} s: it is from {first} to {last} s");
            Err(form.invalid(rule).with_hint("shorten the duration of [run], or extend the table"))
        }
        _ => Ok(()),
    }
}

fn refused(form: &Value<'_>, error: MotionError) -> FormatError {
    let not_finite = matches!(error, MotionError::NotFinite { .. });
    let error = form.motion(error);
    if not_finite {
        error.with_hint(
            "its formulas, or their derivatives, are not finite there: look for roots and quotients",
        )
    } else {
        error
    }
}

/// Returns a finding on the accuracy of an attitude integrated from ω.
fn integrated(motion: &Prescribed) -> Option<Finding> {
    let Prescribed::Turning(turning) = motion else { return None };
    let error = turning.attitude_error();
    (error > 0.0).then(|| Finding {
        code: "prescribed.integrated",
        severity: Severity::Info,
        message: format!("the attitude was integrated from ω: within {error:.0e} rad at the end"),
        place: None,
    })
}
