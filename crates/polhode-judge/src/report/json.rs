//! Judgements as JSON.

use polhode::body::Finding;
use polhode::infer::judge::{
    AccuracyOrder, AttitudeSense, Cause, Growth, OmegaAxes, OmegaReading, QuaternionOrder, RateErrors,
    Reading, Readings, Split,
};
use polhode_document::VERSION;
use polhode_document::finding;
use polhode_document::json::numbers;
use serde_json::{Value, json};

use super::{JudgedRun, words};

/// Returns the report:
/// `{"polhode": …, "title": …, "runs": […], "order_of_accuracy": …, "findings": […]}`.
pub(crate) fn report(
    title: &str,
    runs: &[JudgedRun],
    order: Option<&AccuracyOrder>,
    findings: &[Finding],
) -> Value {
    json!({
        "polhode": VERSION,
        "title": title,
        "runs": runs.iter().map(run).collect::<Value>(),
        "order_of_accuracy": order.map(order_of_accuracy),
        "findings": finding::to_json(findings),
    })
}

/// Returns one run without its rows.
pub(crate) fn run(run: &JudgedRun) -> Value {
    let judgement = &run.judgement;
    let times = &judgement.motion.times;
    json!({
        "run": run.name,
        "path": run.path,
        "engine": run.engine,
        "step_s": run.step,
        "step_is_said": run.step_is_said,
        "rows": times.len(),
        "first_s": times.first(),
        "last_s": times.last(),
        "not_read": run.ignored,
        "single_precision": judgement.is_single_precision,
        "reading": readings(&judgement.readings),
        "error": {
            "attitude_last_rad": judgement.last_attitude_error(),
            "attitude_largest_rad": run.largest(),
            "rates": judgement.errors.rates.as_ref().map(rates),
            "quaternion_length": judgement.errors.norm,
            "exact_to_rad": judgement.floor(),
        },
        "growth": growth(judgement.growth),
        "split": split(&judgement.split),
        "causes": causes(run),
    })
}

fn readings(readings: &Readings) -> Value {
    let tried = |tried: &polhode::infer::judge::ReadingResidual| json!({ "reading": reading(&tried.reading), "attitude_rad": tried.attitude, "of_the_turn": tried.relative });
    json!({
        "found": reading(&readings.reading),
        "omega_axes": readings.omega_axes().map(frame),
        "omega_components": readings.omega.map(|omega| omega.components.to_string()),
        "omega_factor": readings.omega.map(|omega| omega.factor),
        "against_names": readings.is_against_names,
        "from_own_start": readings.from_own_start,
        "mistakes": readings.mistakes.iter().map(ToString::to_string).collect::<Value>(),
        "equivalent": readings.equivalent,
        "tried": readings.tried.iter().map(tried).collect::<Value>(),
    })
}

/// Returns the meaning of a log that was not compared with a motion.
pub(crate) fn interpretation(found: &Reading, omega: Option<OmegaReading>, is_against_names: bool) -> Value {
    json!({
        "found": reading(found),
        "omega_axes": omega.map(|omega| frame(omega.frame)),
        "against_names": is_against_names,
    })
}

const fn frame(axes: OmegaAxes) -> &'static str {
    match axes {
        OmegaAxes::Body => "body",
        OmegaAxes::Space => "space",
    }
}

fn reading(reading: &Reading) -> Value {
    json!({
        "quaternion": match reading.order { QuaternionOrder::ScalarFirst => "wxyz", QuaternionOrder::ScalarLast => "xyzw" },
        "sense": match reading.sense { AttitudeSense::BodyToSpace => "body_to_space", AttitudeSense::SpaceToBody => "space_to_body" },
        "axes": reading.axes.to_string(),
        "time_origin_s": reading.time_origin,
        "time_factor": reading.time_factor,
    })
}

fn rates(rates: &RateErrors) -> Value {
    let largest = |of: &[f64]| of.iter().map(|e| e.abs()).fold(0.0, f64::max);
    json!({
        "omega_relative": largest(&rates.omega),
        "kinetic_energy_relative": largest(&rates.kinetic_energy),
        "momentum_relative": largest(&rates.momentum),
        "momentum_direction_rad": largest(&rates.momentum_direction),
    })
}

pub(crate) fn growth(growth: Growth) -> Value {
    match growth {
        Growth::Unknown => Value::Null,
        Growth::Power { exponent } => json!({ "law": "power", "exponent": exponent }),
        Growth::Exponential { rate } => json!({ "law": "exponential", "rate_per_s": rate }),
    }
}

pub(crate) fn split(split: &Split) -> Value {
    let part = |part: &polhode::infer::judge::SplitPart| {
        let value = part.value.map(|value| numbers(&value[..part.kind.count()]));
        json!({
            "part": words::part_name(part.kind).replace(' ', "_"),
            "value": value,
            "unit": part.kind.unit(),
            "attitude_rad": part.attitude,
        })
    };
    json!({
        "until_s": split.until,
        "total_rad": split.total,
        "parts": split.parts.iter().map(part).collect::<Value>(),
        "noise_rad": split.noise,
        "rest_rad": split.rest,
    })
}

fn causes(run: &JudgedRun) -> Value {
    let tried = |tried: &polhode::infer::judge::TriedCause| {
        json!({
            "cause": tried.cause.to_string(),
            "id": id(&tried.cause),
            "is_mistake": tried.cause.is_mistake(),
            "named": tried.is_named,
            "residual_rad": tried.residual,
            "explained": tried.explained,
            "hint": tried.cause.hint(),
        })
    };
    json!({
        "not_tried_because": run.causes.untried.map(|why| why.to_string()),
        "span_s": numbers(&run.causes.span),
        "error_rad": run.causes.error,
        "tried": run.causes.tried.iter().map(tried).collect::<Value>(),
    })
}

/// Returns the identifier of a cause, such as `no_gyroscopic_term`, without its numbers.
fn id(cause: &Cause) -> String {
    let name = format!("{cause:?}");
    let mut id = String::new();
    for c in name.chars().take_while(char::is_ascii_alphanumeric) {
        if c.is_ascii_uppercase() && !id.is_empty() {
            id.push('_');
        }
        id.push(c.to_ascii_lowercase());
    }
    id
}

fn order_of_accuracy(order: &AccuracyOrder) -> Value {
    json!({
        "until_s": order.time,
        "steps_s": order.runs.iter().map(|run| run.0).collect::<Vec<_>>(),
        "errors_rad": order.runs.iter().map(|run| run.1).collect::<Vec<_>>(),
        "orders": order.orders,
    })
}
