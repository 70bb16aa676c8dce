//! Evidence for the numbers: conserved quantities, estimated errors, steps.

use polhode::motion::{Method, Solution};
use polhode_document::fact::{Fact, Quantity};
use polhode_document::number::{count, number};
use serde_json::json;

use super::Known;
use crate::report::balance::energy_balance;

/// Returns the facts with the keys of `drift` and `error`.
pub(super) fn facts(known: &Known<'_>) -> Vec<Fact> {
    let balance = energy_balance(known.trajectory);
    let energy = Quantity::Error(known.trajectory.energy_drift(), "");
    let note = format!("{}; relative, worst sample", balance.unwrap_or_default());
    let mut facts = vec![Fact::shown("energy balance", energy).note(note).shown_if(balance.is_some())];
    facts.extend(drift(known, balance.is_none()));
    facts.extend(error(known));
    facts
}

/// Returns the relative changes of conserved quantities. T and |L| are evidence for a free motion
/// only.
fn drift(known: &Known<'_>, is_shown: bool) -> Vec<Fact> {
    let Some(drift) = known.drift else { return Vec::new() };
    let note = match known.trajectory.solution() {
        Solution::ClosedForm(_) => "relative, worst sample: rounding",
        _ => "relative, worst sample",
    };
    let is_free = known.is_free;
    let fact = |key: &str, label: &str, value: Option<f64>, is_for_people: bool| {
        Fact::new(format!("drift.{key}"), label, value.map(|x| Quantity::Error(x, "")))
            .note(note)
            .shown_if(is_shown && is_for_people)
    };
    let free = |value: f64| is_free.then_some(value);
    vec![
        fact("work_energy", "T − work", Some(drift.work_energy), !is_free),
        fact("momentum", if is_free { "L in space" } else { "L − impulse" }, Some(drift.momentum), true),
        fact("total_energy", "T + U", drift.total_energy, true),
        fact("kinetic_energy", "T", free(drift.kinetic_energy), true),
        fact("momentum_magnitude", "|L|", free(drift.momentum_magnitude), true),
    ]
}

/// Returns the estimated error at the end, and the effect of input rounding on the end.
fn error(known: &Known<'_>) -> Vec<Fact> {
    let Some(estimate) = known.trajectory.error() else { return Vec::new() };
    let [end, inputs] = [estimate.end(), estimate.inputs_end()];
    let (effort, at_most) = match estimate.is_thorough() {
        true => ("thorough", ""),
        false => ("cheap", ", at most"),
    };
    vec![
        Fact::new("error.attitude_rad", "attitude error", Quantity::Error(end.attitude, "rad"))
            .note("estimate, at the end"),
        Fact::new("error.omega", "error of ω", Quantity::Error(end.omega, ""))
            .note("relative, estimate, at the end"),
        Fact::data("error.effort", Quantity::Word(effort, String::new())),
        Fact::new("error.inputs.attitude_rad", "input rounding", Quantity::Error(inputs.attitude, "rad"))
            .note(format!("its effect on the attitude at the end{at_most}"))
            .detail(),
        Fact::new("error.inputs.omega", "", Quantity::Error(inputs.omega, ""))
            .note(format!("relative effect on ω at the end{at_most}"))
            .detail(),
    ]
}

/// Returns the facts with the keys of `run`: the method and its steps.
pub(super) fn solver(known: &Known<'_>) -> Vec<Fact> {
    let solution = known.trajectory.solution();
    let method = known.scenario.and_then(|scenario| scenario.run()).map(|run| run.method);
    let duration = known.ends().map_or(0.0, |[first, last]| last.state.time - first.state.time);
    let splitting = match solution {
        Solution::Splitting { order, step, .. } => Some(Quantity::Data(
            json!({ "order": order.number(), "step_s": step }),
            format!("order {}, steps of {} s", order.number(), number(*step, 3)),
        )),
        _ => None,
    };
    let tolerance = solution.tolerance().map(|tolerance| Quantity::Error(tolerance, ""));
    let mut facts = vec![
        Fact::data("run.method", method.map(|method| Quantity::Word(Method::name(method), String::new()))),
        Fact::data("run.method_used", Quantity::Word(solution.name(), String::new())),
        Fact::new("run.method_reason", "method", known.trajectory.reason().to_string()),
        Fact::new("run.tolerance", "tolerance", tolerance).note("of a step"),
        Fact::new("run.splitting", "splitting", splitting),
        Fact::data("run.samples", Quantity::Count(known.trajectory.samples().len() as u64)),
        Fact::data("run.duration_s", Quantity::Duration(duration)),
        Fact::data("run.steps", None),
    ];
    if let Some(steps) = solution.statistics() {
        let note = format!("{} rejected, {} evaluations", count(steps.rejected), count(steps.evaluations));
        facts.extend([
            Fact::new("run.steps.accepted", "steps", Quantity::Count(steps.accepted)).note(note),
            Fact::data("run.steps.rejected", Quantity::Count(steps.rejected)),
            Fact::data("run.steps.evaluations", Quantity::Count(steps.evaluations)),
        ]);
    }
    facts.into_iter().map(Fact::detail).collect()
}
