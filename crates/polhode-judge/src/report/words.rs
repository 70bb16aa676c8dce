//! Sentences on one run.

use polhode::infer::judge::{
    AttitudeSense, Growth, PartKind, Reading, SignedAxes, Split, SplitPart, Untried,
};
use polhode_document::Section;
use polhode_document::layout::printable;
use polhode_document::number::{error, number, vector};

use super::JudgedRun;

/// Returns the error in words, such as
/// `attitude error 2.1e-9 rad at the end, at most 3.2e-9 rad; grows as t^1.00`.
pub(crate) fn how_far(run: &JudgedRun) -> String {
    let judgement = &run.judgement;
    if run.is_exact() {
        let floor = error(judgement.floor());
        return format!("correct: no error above {floor} rad, the accuracy of the exact motion");
    }
    let (last, largest) = (judgement.last_attitude_error(), run.largest());
    let omega = match run.omega_off() {
        Some(off) if off > run.omega_floor() => format!("; ω error at most {} (relative)", error(off)),
        _ => String::new(),
    };
    if run.is_attitude_exact() {
        return format!("attitude correct to {} rad{omega}", error(judgement.floor()));
    }
    let growth = match judgement.growth {
        Growth::Unknown => String::new(),
        growth => format!("; {growth}"),
    };
    format!("attitude error {} rad at the end, at most {} rad{growth}{omega}", error(last), error(largest))
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
    let own = if readings.from_own_start { ", relative to its own first row" } else { "" };
    let names = if readings.is_against_names { ", contrary to its column names" } else { "" };
    Some(format!("interpreted as {}{omega}{own}{names}", reading(&readings.reading)))
}

/// Returns the meaning of times and attitudes in words. The origin of the times has six digits, or
/// is rounded to 1 µs if this is finer.
pub(crate) fn reading(reading: &Reading) -> String {
    let origin = reading.time_origin;
    let rounded = match origin.abs() {
        ..1.0 => number(origin, 6).parse().unwrap_or(origin),
        ..1e9 => (1e6 * origin).round() / 1e6,
        _ => origin,
    };
    Reading { time_origin: rounded, ..*reading }.to_string()
}

/// Returns the cause in words, such as
/// `most likely cause: the gyroscopic term ω × I ω is missing (explains 99.9 % of the error)`.
pub(crate) fn why(run: &JudgedRun) -> String {
    let causes = &run.causes;
    let mistakes: Vec<String> = run.judgement.readings.mistakes.iter().map(ToString::to_string).collect();
    if !mistakes.is_empty() {
        return format!("mistake in the log: {}", mistakes.join("; "));
    }
    match causes.untried {
        Some(Untried::Exact) if run.largest() > LATE => {
            return format!(
                "no causes tested: correct to 1e-8 rad until {} s, with larger errors later",
                number(causes.span[1], 6)
            );
        }
        Some(why) => return format!("no causes tested: {why}"),
        None => {}
    }
    match causes.likeliest() {
        Some(tried) if tried.cause.is_mistake() => {
            format!(
                "most likely cause: {} (explains {} of the error)",
                printable(&tried.cause.to_string()),
                share(tried.explained)
            )
        }
        Some(tried) if tried.explained <= 0.0 => {
            format!(
                "not a mistake, according to the size of the error: {}",
                printable(&tried.cause.to_string())
            )
        }
        Some(tried) => format!(
            "not a mistake: {} (explains {} of the error)",
            printable(&tried.cause.to_string()),
            share(tried.explained)
        ),
        None => format!("cause unknown: none of the {} tested causes explains the error", causes.tried.len()),
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

/// Adds the components of an error, or of a difference, to a section.
pub(crate) fn breakdown(s: &mut Section, what: &str, name: &str, split: &Split) {
    s.say(format!(
        "{name}: {what} until {} s, {} rad (root mean square). The squares of the components add up to its square:",
        number(split.until, 4),
        error(split.total)
    ));
    let of_total = |part: f64| share(part / split.total.max(f64::MIN_POSITIVE));
    let mut rows: Vec<Vec<String>> = (split.parts.iter())
        .map(|one| {
            let worth = one.value.map_or_else(|| "—".to_owned(), |_| of_total(one.attitude));
            vec![part_title(one.kind).to_owned(), worth, part(one)]
        })
        .collect();
    rows.push(vec![
        "noise".to_owned(),
        of_total(split.noise),
        format!("random, {} rad from row to row", error(split.noise)),
    ]);
    let rest = (split.rest.powi(2) - split.noise.powi(2)).max(0.0).sqrt();
    rows.push(vec!["remainder".to_owned(), of_total(rest), "none of the above".to_owned()]);
    s.table(&["component", &format!("share of the {what}"), "value"], rows);
}

/// Returns the value of a part in words, such as `rotation too fast by 1.2e-7 (relative)`.
pub(crate) fn part(part: &SplitPart) -> String {
    let Some(value) = part.value else {
        return "not significant, or not separable".to_owned();
    };
    match part.kind {
        PartKind::Start => format!("rotated in space by {} rad", vector(value, 3)),
        PartKind::BodyAxes => format!("rotated in the body by {} rad", vector(value, 3)),
        PartKind::Clock if value[0] < 0.0 => format!("{} s late", number(-value[0], 3)),
        PartKind::Clock => format!("{} s early", number(value[0], 3)),
        PartKind::Rate if value[0] < 0.0 => {
            format!("rotation too slow by {} (relative)", number(-value[0], 3))
        }
        PartKind::Rate => format!("rotation too fast by {} (relative)", number(value[0], 3)),
        PartKind::Drift => format!("rotation in space at {} rad/s", vector(value, 3)),
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

/// Returns the title of a part in tables.
pub(crate) const fn part_title(kind: PartKind) -> &'static str {
    match kind {
        PartKind::Start => "start attitude offset",
        PartKind::BodyAxes => "body axes offset",
        PartKind::Clock => "clock error",
        PartKind::Rate => "rate error",
        PartKind::Drift => "drift",
    }
}

/// Returns the step in words: `0.002 s`, or `0.01 s (row spacing)`.
pub(crate) fn step(run: &JudgedRun) -> String {
    match (run.step, run.step_is_said) {
        (Some(step), true) => format!("{} s", number(step, 6)),
        (Some(step), false) => format!("{} s (row spacing)", number(step, 6)),
        (None, _) => "not uniform".to_owned(),
    }
}
