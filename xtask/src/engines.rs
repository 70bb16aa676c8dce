//! Page that compares physics engines by the test suite, generated from folders of their runs.

use std::fmt::Write as _;
use std::path::Path;
use std::process::Command;

use serde_json::Value;

use crate::process::{build_folder, cargo, run};
use crate::{Outcome, root};

/// Graded runs of one engine with one setting.
struct Graded {
    /// Name of the folder.
    setting: String,
    card: Value,
}

/// Grades the runs in every folder, and writes `book/judge-engines.md`.
pub(crate) fn grade(folders: &[&str]) -> Outcome {
    run(&mut cargo(&["build", "--release", "--quiet", "--locked", "--package", "polhode-cli"]))?;
    let built = build_folder()?.with_file_name("release");
    let polhode = built.join(format!("polhode{}", std::env::consts::EXE_SUFFIX));
    let graded =
        folders.iter().map(|folder| card(&polhode, Path::new(folder))).collect::<Result<Vec<_>, _>>()?;
    let page = root().join("book/judge-engines.md");
    std::fs::write(&page, text(&graded)).map_err(|error| format!("{}: {error}", page.display()))
}

fn card(polhode: &Path, folder: &Path) -> Result<Graded, String> {
    let setting = folder.file_name().unwrap_or_default().to_string_lossy().into_owned();
    println!("   {setting}");
    let out = Command::new(polhode).args(["judge", "--json", "--suite"]).arg(folder).output();
    let out = out.map_err(|error| format!("polhode judge in {setting}: {error}"))?;
    if out.status.code().is_none_or(|code| code >= 2) {
        return Err(format!("polhode judge in {setting}: {}", String::from_utf8_lossy(&out.stderr)));
    }
    let card = serde_json::from_slice(&out.stdout).map_err(|error| format!("{setting}: {error}"))?;
    Ok(Graded { setting, card })
}

/// Suffix of folders with runs at several step sizes.
const STEPS: &str = "-steps";

fn text(all: &[Graded]) -> String {
    let (stepped, graded): (Vec<&Graded>, Vec<&Graded>) =
        all.iter().partition(|graded| graded.setting.ends_with(STEPS));
    let mut page = "# Physics engines compared by the suite\n\n<!-- Written by `cargo xtask engines`. -->\n\n\
        The cases of the [suite](judge.md#the-suite) in physics engines, with default settings and with those that their documentation recommends for \
        accuracy ([notes](judge-engines-notes.md)). The programs are in `judge/engines`.\n\nThe error is the largest angle between the attitude of a row \
        and the exact one, rad. A case is passed up to 0.01 rad; failed ones are bold.\n\n\
        ## Settings\n\nFailed cases are counted by the first named cause:\n\n"
        .to_owned();
    let names = names(&graded);
    for (letter, name) in ('a'..).zip(&names) {
        let _ = writeln!(page, "- {letter}: {name}");
    }
    let _ = writeln!(page, "- ′: also{}\n- {NONE}: no cause found", FIRST_ORDER.trim_start_matches(','));
    page.push_str("\n| setting | engine | step (s) | passed | failed |\n|---|---|---|---|---|\n");
    for Graded { setting, card } in graded.iter().copied() {
        let engines: Vec<&str> =
            card["engines"].as_array().into_iter().flatten().filter_map(Value::as_str).collect();
        let causes: Vec<_> = causes(card)
            .into_iter()
            .map(|(cause, count)| {
                let (name, prime) = match cause.strip_suffix(FIRST_ORDER) {
                    Some(name) => (name, "′"),
                    None => (cause.as_str(), ""),
                };
                let letter = ('a'..).zip(&names).find(|(_, other)| *other == name);
                letter.map_or(format!("{name} {count}"), |(letter, _)| format!("{letter}{prime} {count}"))
            })
            .collect();
        let _ = writeln!(
            page,
            "| {setting} | {} | {} | {} | {} |",
            engines.join("; "),
            steps(card),
            card["passed"],
            causes.join(", ")
        );
    }
    let compared = compared(&graded);
    let heads: String = compared.iter().map(|graded| format!(" {} |", graded.setting)).collect();
    let _ = write!(
        page,
        "\n## Largest errors\n\nFor each engine, the first setting and the one that passes the most cases, if that is more.\n\n| case |{heads}\n|---|{}\n",
        "---|".repeat(compared.len())
    );
    for (k, case) in compared.first().map_or(&[][..], |first| cases(&first.card)).iter().enumerate() {
        let errors: String =
            compared.iter().map(|graded| format!(" {} |", shown(&cases(&graded.card)[k]))).collect();
        let _ = writeln!(page, "| {} |{errors}", word(&case["case"]));
    }
    page.push_str("\n## Order of accuracy\n\nBetween the two smallest of several steps: median of the cases, minimum and maximum.\n\n| setting | steps (s) | cases | order |\n|---|---|---|---|\n");
    for graded in &stepped {
        let orders = orders(graded);
        let Some(median) = orders.get(orders.len() / 2) else { continue };
        let (least, most) = (orders[0], orders[orders.len() - 1]);
        let setting = graded.setting.trim_end_matches(STEPS);
        let _ = writeln!(
            page,
            "| {setting} | {} | {} | {median:.2} ({least:.2} … {most:.2}) |",
            steps(&graded.card),
            orders.len()
        );
    }
    page.push_str("\n## Not run, or not to the end\n\n");
    let mut gaps: Vec<(Vec<&str>, Vec<&str>, &str)> = Vec::new();
    for graded in &graded {
        for (reason, cases) in not_run(graded) {
            match gaps.iter_mut().find(|gap| (&gap.1, gap.2) == (&cases, reason)) {
                Some((settings, ..)) => settings.push(graded.setting.as_str()),
                None => gaps.push((vec![graded.setting.as_str()], cases, reason)),
            }
        }
    }
    for (settings, cases, reason) in gaps {
        let _ = writeln!(page, "- {}: {}: {reason}", settings.join(", "), cases.join(", "));
    }
    page
}

/// Returns the causes in failed cases of all settings, in the order of their first occurrence,
/// without [`FIRST_ORDER`].
fn names(graded: &[&Graded]) -> Vec<String> {
    let mut names = Vec::new();
    for (cause, _) in graded.iter().flat_map(|graded| causes(&graded.card)) {
        let name = cause.strip_suffix(FIRST_ORDER).unwrap_or(&cause).to_owned();
        if name != NONE && !names.contains(&name) {
            names.push(name);
        }
    }
    names
}

/// Cause of a failed case of which no cause is named.
const NONE: &str = "none";

/// End of a cause with an attitude of first order.
const FIRST_ORDER: &str = ", attitude by q + ½ h q ω";

/// Returns the reasons of cases that did not run to the end, each with its cases, in their order.
fn not_run(graded: &Graded) -> Vec<(&str, Vec<&str>)> {
    let mut reasons: Vec<(&str, Vec<&str>)> = Vec::new();
    for case in cases(&graded.card).iter().filter(|case| !case["why_not"].is_null()) {
        let (reason, name) = (word(&case["why_not"]), word(&case["case"]));
        match reasons.iter_mut().find(|(other, _)| *other == reason) {
            Some((_, cases)) => cases.push(name),
            None => reasons.push((reason, vec![name])),
        }
    }
    reasons
}

fn cases(card: &Value) -> &[Value] {
    card["cases"].as_array().map_or(&[], Vec::as_slice)
}

/// Returns the first setting of each engine and the first of those that pass the most cases.
fn compared<'a>(graded: &[&'a Graded]) -> Vec<&'a Graded> {
    let engine = |one: &Graded| one.setting.split('-').next().map(str::to_owned);
    let is_compared = |one: &&&Graded| {
        let mut same = graded.iter().filter(|other| engine(other) == engine(one));
        let best = same.clone().rev().max_by_key(|other| other.card["passed"].as_u64());
        [same.next(), best].into_iter().flatten().any(|other| other.setting == one.setting)
    };
    graded.iter().filter(is_compared).copied().collect()
}

/// Formats an error: `2.1e-9`, **`0.83`** for a failed case, `—` without a run.
fn shown(case: &Value) -> String {
    let error = case["attitude_largest_rad"].as_f64();
    match (error, case["grade"].as_str()) {
        (Some(error), Some("passed")) => format!("{error:.1e}"),
        (Some(error), _) => format!("**{error:.1e}**"),
        (None, Some("failed")) => "**no run**".to_owned(),
        (None, _) => "—".to_owned(),
    }
}

/// Returns the orders of accuracy between the two smallest steps, ascending, of cases with several
/// steps.
fn orders(graded: &Graded) -> Vec<f64> {
    let last = |case: &Value| case["order_of_accuracy"].as_array()?.last()?.as_f64();
    let mut orders: Vec<f64> = cases(&graded.card).iter().filter_map(last).collect();
    orders.sort_by(f64::total_cmp);
    orders
}

/// Returns the smallest and the largest step of all runs, as text.
fn steps(card: &Value) -> String {
    let cases = card["cases"].as_array().into_iter().flatten();
    let runs = cases.flat_map(|case| case["runs"].as_array().into_iter().flatten());
    let said = runs.filter(|run| run["step_is_said"] == true).filter_map(|run| run["step_s"].as_f64());
    let mut steps: Vec<f64> = said.collect();
    steps.sort_by(f64::total_cmp);
    match (steps.first(), steps.last()) {
        (Some(least), Some(most)) if least == most => rounded(*least),
        (Some(least), Some(most)) => format!("{} … {}", rounded(*least), rounded(*most)),
        _ => "its own".to_owned(),
    }
}

/// Formats a step with six digits.
fn rounded(step: f64) -> String {
    format!("{step:.5e}").parse::<f64>().unwrap_or(step).to_string()
}

/// Returns the most likely causes in failed cases with their number, the most frequent first.
fn causes(card: &Value) -> Vec<(String, usize)> {
    let mut counts: Vec<(String, usize)> = Vec::new();
    for case in cases(card).iter().filter(|case| case["grade"] == "failed") {
        let tried =
            case["runs"].as_array().into_iter().flatten().flat_map(|run| run["causes"]["tried"].as_array());
        let named = tried.flatten().find(|cause| cause["named"] == true);
        // The step size is omitted, because it differs between cases.
        let text = named.map_or(NONE, |cause| cause["cause"].as_str().unwrap_or_default());
        let text = text.split(", h = ").next().unwrap_or(text);
        let method = text.strip_prefix("first-order integration (").and_then(|text| text.strip_suffix(')'));
        let name = method.unwrap_or(text).to_owned();
        match counts.iter_mut().find(|(other, _)| *other == name) {
            Some((_, count)) => *count += 1,
            None => counts.push((name, 1)),
        }
    }
    counts.sort_by(|a, b| b.1.cmp(&a.1).then_with(|| a.0.cmp(&b.0)));
    counts
}

fn word(value: &Value) -> &str {
    value.as_str().unwrap_or_default()
}
