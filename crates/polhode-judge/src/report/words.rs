//! Sentences on one run.

use polhode::infer::judge::{AttitudeSense, Growth, PartKind, Reading, SignedAxes, SplitPart, Untried};
use polhode_document::layout::printable;
use polhode_document::number::{error, number, vector};

use super::JudgedRun;

/// Returns the error in words, such as
/// `2.1e-9 rad off at the end, 3.2e-9 rad at most; grows as t^1.00`.
pub(crate) fn how_far(run: &JudgedRun) -> String {
    let judgement = &run.judgement;
    if run.is_exact() {
        let floor = error(judgement.floor());
        return format!("right: no error beyond {floor} rad, to which the exact motion is known");
    }
    let (last, largest) = (judgement.last_attitude_error(), run.largest());
    let omega = match run.omega_off() {
        Some(off) if off > run.omega_floor() => format!("; ω is off by up to {} of its largest", error(off)),
        _ => String::new(),
    };
    if run.is_attitude_exact() {
        return format!("the attitude is right to {} rad{omega}", error(judgement.floor()));
    }
    let growth = match judgement.growth {
        Growth::Unknown => String::new(),
        growth => format!("; {growth}"),
    };
    format!("{} rad off at the end, {} rad at most{growth}{omega}", error(last), error(largest))
}

/// Threshold below which an error needs no cause, rad.
const LATE: f64 = 1e-7;

/// Returns the interpretation of the run, unless it is the default. It reveals mistakes that look
/// like another convention.
pub(crate) fn read_as(run: &JudgedRun) -> Option<String> {
    let readings = &run.judgement.readings;
    let Reading { sense, axes, time_origin, time_factor, .. } = readings.reading;
    let is_plain = sense == AttitudeSense::BodyToSpace
        && axes == SignedAxes::SAME
        && time_origin == 0.0
        && time_factor == 1.0
        && readings.omega.is_none_or(|omega| omega.is_plain())
        && !readings.is_against_names;
    if is_plain && !readings.from_own_start {
        return None;
    }
    let omega = readings.omega.filter(|omega| !omega.is_plain() || readings.is_against_names);
    let omega = omega.map_or_else(String::new, |omega| format!(", {omega}"));
    let own = if readings.from_own_start { ", from its own first row" } else { "" };
    let names = if readings.is_against_names { ", against the names of its columns" } else { "" };
    Some(format!("read as {}{omega}{own}{names}", readings.reading))
}

/// Returns the cause in words, such as `ω × I ω is left out: explains 99.9 % of the error`.
pub(crate) fn why(run: &JudgedRun) -> String {
    let causes = &run.causes;
    let mistakes: Vec<String> = run.judgement.readings.mistakes.iter().map(ToString::to_string).collect();
    if !mistakes.is_empty() {
        return format!("mistake of the program: {}", mistakes.join("; "));
    }
    match causes.untried {
        Some(Untried::Exact) if run.largest() > LATE => {
            return format!(
                "no cause was looked for: it is right to 1e-8 rad until {} s, and off by more later",
                number(causes.span[1], 6)
            );
        }
        Some(why) => return format!("no cause was looked for: {why}"),
        None => {}
    }
    match causes.likeliest() {
        Some(tried) if tried.cause.is_mistake() => {
            format!(
                "likeliest cause: {} (explains {})",
                printable(&tried.cause.to_string()),
                share(tried.explained)
            )
        }
        Some(tried) if tried.explained <= 0.0 => {
            format!("no mistake, by the size of the error: {}", printable(&tried.cause.to_string()))
        }
        Some(tried) => format!(
            "no mistake: {} (explains {})",
            printable(&tried.cause.to_string()),
            share(tried.explained)
        ),
        None => format!("none of {} causes that were tried explains it", causes.tried.len()),
    }
}

/// Returns a share such as `99.7 %`, never rounded up to 100 %.
pub(crate) fn share(part: f64) -> String {
    let percent = 100.0 * part;
    if percent > 99.9 && percent < 100.0 {
        "more than 99.9 %".to_owned()
    } else {
        format!("{} %", number(percent, 3))
    }
}

/// Returns a part of the error in words, such as `it turns too fast, by 1.2e-7 of ω`.
pub(crate) fn part(part: &SplitPart) -> String {
    let Some(value) = part.value else { return "none, or it looks like larger parts".to_owned() };
    match part.kind {
        PartKind::Start => format!("it starts turned by {} rad in space", vector(value, 3)),
        PartKind::BodyAxes => format!("its axes in the body are turned by {} rad", vector(value, 3)),
        PartKind::Clock if value[0] < 0.0 => format!("it is {} s late", number(-value[0], 3)),
        PartKind::Clock => format!("it is {} s early", number(value[0], 3)),
        PartKind::Rate if value[0] < 0.0 => format!("it turns too slowly, by {} of ω", number(-value[0], 3)),
        PartKind::Rate => format!("it turns too fast, by {} of ω", number(value[0], 3)),
        PartKind::Drift => format!("it turns away at {} rad/s in space", vector(value, 3)),
    }
}

/// Returns the name of a part, such as `start`.
pub(crate) const fn part_name(kind: PartKind) -> &'static str {
    match kind {
        PartKind::Start => "start",
        PartKind::BodyAxes => "body axes",
        PartKind::Clock => "clock",
        PartKind::Rate => "rate",
        PartKind::Drift => "drift",
    }
}

/// Returns the step in words: `0.002 s`, or `0.01 s (of the rows)`.
pub(crate) fn step(run: &JudgedRun) -> String {
    match (run.step, run.step_is_said) {
        (Some(step), true) => format!("{} s", number(step, 6)),
        (Some(step), false) => format!("{} s (of the rows)", number(step, 6)),
        (None, _) => "not even".to_owned(),
    }
}
