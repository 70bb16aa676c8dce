//! Estimated parameters with their errors, as text and JSON.

use polhode::body::{Finding, Severity};
use polhode_document::number::{count, counted, number, with_error};
use polhode_document::{Level, Section, Verdict};
use serde_json::{Value, json};

use super::picture;
use crate::{Estimate, Number, PrincipalEstimate, ResidualTest, Undetermined};

/// Returns the verdict on an estimate: whether the residuals are noise, and whether the measurements
/// determine all numbers.
pub(crate) fn verdict<'a>(
    tests: impl IntoIterator<Item = &'a ResidualTest>,
    findings: &[Finding],
    estimate: &Estimate,
) -> Verdict {
    let (mut is_tested, mut has_failed) = (false, false);
    for test in tests {
        (is_tested, has_failed) = (true, has_failed || test.shows_model_error());
    }
    let warnings = findings.iter().filter(|finding| finding.severity != Severity::Info).count();
    let (level, reason) = match () {
        () if has_failed => (Level::Failure, "The model does not describe the measurements completely"),
        () if warnings > 0 => (Level::Warning, "Read the warnings before using the numbers"),
        () if estimate.numbers.iter().any(|number| number.sd.is_none()) => {
            (Level::Warning, "The measurements do not determine all numbers")
        }
        () if !is_tested => (Level::Warning, "No redundant measurement tests the model"),
        () => (Level::Ok, "The model describes the measurements: the residuals are noise"),
    };
    Verdict::new(level, reason)
}

pub(crate) fn cell(value: f64, sd: Option<f64>) -> String {
    sd.map_or_else(|| "unobservable".to_owned(), |sd| with_error(value, sd))
}

/// Returns the same text as [`cell`], or `not determined` for a value beyond its range.
pub(crate) fn bounded_cell(value: f64, sd: Option<f64>, undetermined: Option<Undetermined>) -> String {
    match undetermined {
        Some(Undetermined::BeyondRange { .. }) => "not determined".to_owned(),
        _ => cell(value, sd),
    }
}

/// Returns value and standard deviation of a number as text.
pub(crate) fn number_cell(number: &Number) -> String {
    bounded_cell(number.value, number.sd, number.undetermined())
}

/// Returns i1/i3 (`k` = 0) or i2/i3 (`k` = 1) as text.
pub(crate) fn ratio_cell(p: &PrincipalEstimate, k: usize) -> String {
    bounded_cell(p.ratios[k], p.ratio_sd[k], p.undetermined_ratio(k))
}

/// Adds a table with a row per number: name, value ± sd, unit.
pub(crate) fn table(section: &mut Section, numbers: &[Number]) {
    let row = |number: &Number| vec![number.name.clone(), number_cell(number), number.unit.to_owned()];
    section.table(&["parameter", "value ± 1σ", "unit"], numbers.iter().map(row).collect());
}

/// Adds the strongest correlations, and the unobservable directions.
pub(crate) fn relations(section: &mut Section, estimate: &Estimate) {
    const STRONG: f64 = 0.9;
    const MOST: usize = 8;
    let n = estimate.numbers.len();
    let mut pairs: Vec<(f64, usize, usize)> = (0..n)
        .flat_map(|i| (0..i).map(move |j| (j, i)))
        .filter_map(|(i, j)| Some((estimate.correlation(i, j)?, i, j)))
        .filter(|(r, ..)| r.abs() >= STRONG)
        .collect();
    pairs.sort_by(|a, b| b.0.abs().total_cmp(&a.0.abs()));
    let named = |k: usize| estimate.numbers[k].name.as_str();
    for (r, i, j) in pairs.iter().take(MOST) {
        section.line(format!("correlation of {} and {}: {}", named(*i), named(*j), number(*r, 3)));
    }
    if pairs.len() > MOST {
        section
            .say(format!("Not shown: {} with |r| ≥ 0.9.", counted(pairs.len() - MOST, "more correlation")));
    }
    picture::draw_correlations(section, estimate);
    let unobservable: Vec<&str> = (0..n).filter(|&k| estimate.numbers[k].sd.is_none()).map(named).collect();
    if !unobservable.is_empty() {
        section.say(format!("Unobservable: {}.", unobservable.join(", ")));
    }
    for direction in &estimate.unknown {
        let largest = direction.iter().fold(0.0_f64, |most, part| most.max(part.abs()));
        let parts: Vec<String> = (0..n)
            .filter(|&k| direction[k].abs() > 1e-3 * largest)
            .map(|k| format!("{} {}", number(direction[k] / largest, 3), named(k)))
            .collect();
        section.say(format!("Unobservable direction: {}.", parts.join(", ")));
    }
}

pub(crate) fn residuals(section: &mut Section, tests: &[ResidualTest]) {
    let row = |test: &ResidualTest| {
        vec![
            test.what.to_owned(),
            count(test.count as u64),
            number(test.noise, 3),
            number(test.reduced_chi_square, 4),
            test.lag_correlation.map_or_else(|| "—".to_owned(), |r| number(r, 3)),
        ]
    };
    let headers = ["quantity", "values", "noise (1σ)", "reduced χ²", "lag-1 autocorrelation"];
    section.table(&headers, tests.iter().map(row).collect());
    for test in tests {
        if test.is_too_large() {
            section.say(format!(
                "The residual of {} is {} times the noise: the model does not describe the motion completely.",
                test.what,
                number(test.reduced_chi_square.sqrt(), 3)
            ));
        }
        if test.is_correlated() {
            section.say(format!(
                "Successive residuals of {} are correlated, so they are not noise. All errors are multiplied by a factor to allow for it.",
                test.what
            ));
        }
    }
}

/// Returns a finding without a place in a file.
pub(crate) const fn finding(code: &'static str, severity: Severity, message: String) -> Finding {
    Finding { code, severity, message, place: None }
}

/// Numbers sections from 1, in order.
pub(crate) fn numbered(mut sections: Vec<Section>) -> Vec<Section> {
    sections.iter_mut().zip(1..).for_each(|(section, k)| section.number = k);
    sections
}

/// Returns findings on residuals that are larger than the noise, correlated, or smaller than the
/// specified noise.
pub(crate) fn model_findings(tests: &[ResidualTest]) -> Vec<Finding> {
    let widening = tests.iter().map(ResidualTest::widening).fold(1.0, f64::max);
    let odd = tests.iter().filter(|test| test.shows_model_error());
    odd.map(|test| {
        let message = format!(
            "the residuals of {} are not noise (reduced χ² = {}): the model is incomplete. All errors are multiplied by {}; they are valid only if the missing effect acts like noise",
            test.what,
            number(test.reduced_chi_square, 3),
            number(widening, 3)
        );
        finding("identify.model", Severity::Warning, message)
    })
    .chain(small_findings(tests))
    .collect()
}

/// Returns findings on residuals that are smaller than the specified noise.
pub(crate) fn small_findings<'a>(tests: impl IntoIterator<Item = &'a ResidualTest>) -> Vec<Finding> {
    let small = tests.into_iter().filter(|test| test.is_too_small());
    small
        .map(|test| {
            let message = format!(
                "the residuals of {} are only {} times the stated noise (reduced χ² = {}): if the stated noise is too large, the errors are too large too",
                test.what,
                number(test.reduced_chi_square.sqrt(), 2),
                number(test.reduced_chi_square, 2)
            );
            finding("identify.noise", Severity::Info, message)
        })
        .collect()
}

pub(crate) fn principal(section: &mut Section, p: &PrincipalEstimate, unit: Option<&str>) {
    if let Some(unit) = unit {
        let row = |k: usize| vec![format!("i{}", k + 1), cell(p.moments[k], p.moment_sd[k]), unit.to_owned()];
        section.table(&["principal moment", "value ± 1σ", "unit"], (0..3).map(row).collect());
    }
    section.line(format!("i1/i3 = {}", ratio_cell(p, 0)));
    section.line(format!("i2/i3 = {}", ratio_cell(p, 1)));
    if let Some(r) = p.ratio_correlation {
        section.line(format!("correlation of i1/i3 and i2/i3: {}", number(r, 3)));
    }
    let thickness = bounded_cell(p.thickness, p.thickness_sd, p.undetermined_thickness());
    section.line(format!("(i1 + i2 − i3)/i3 = {thickness} (0 for a lamina)"));
    let row = |k: usize| {
        let [x, y, z] = p.axes[k];
        let turn = match (p.turn_sd[k], p.undetermined_turn(k)) {
            (Some(sd), None) => number(sd.to_degrees(), 2),
            _ => "not determined".to_owned(),
        };
        vec![format!("axis {}", k + 1), number(x, 5), number(y, 5), number(z, 5), turn]
    };
    section.table(
        &["principal axis", "x", "y", "z", "rotation error about it (deg, 1σ)"],
        (0..3).map(row).collect(),
    );
    picture::draw_triangle(section, p);
}

pub(crate) fn to_json(estimate: &Estimate) -> Value {
    json!({
        "numbers": numbers_to_json(&estimate.numbers),
        "covariance": estimate.covariance,
        "correlation": picture::correlations_to_json(estimate),
        "unknown": estimate.unknown,
    })
}

/// Returns numbers as JSON.
///
/// Value and error of a number beyond its range are null. Each number that is not determined has a
/// reason.
pub(crate) fn numbers_to_json(numbers: &[Number]) -> Value {
    let each = |number: &Number| {
        let undetermined = number.undetermined();
        let mut one = json!({
            "name": number.name,
            "unit": number.unit,
            "value": in_range(Some(number.value), undetermined),
            "sd": in_range(number.sd, undetermined),
        });
        if let Some(why) = undetermined {
            one["reason"] = why.to_string().into();
        }
        one
    };
    numbers.iter().map(each).collect()
}

/// Returns the value, or `None` if it is beyond its range.
fn in_range(value: Option<f64>, undetermined: Option<Undetermined>) -> Option<f64> {
    value.filter(|_| !matches!(undetermined, Some(Undetermined::BeyondRange { .. })))
}

pub(crate) fn principal_to_json(p: &PrincipalEstimate) -> Value {
    let ratios = [0, 1].map(|k| p.undetermined_ratio(k));
    let turns = [0, 1, 2].map(|k| p.undetermined_turn(k));
    let thickness = p.undetermined_thickness();
    let names =
        ["i1/i3", "i2/i3", "thickness", "turn about axis 1", "turn about axis 2", "turn about axis 3"];
    let all = ratios.into_iter().chain([thickness]).chain(turns);
    let values = [0, 1].map(|k| in_range(Some(p.ratios[k]), ratios[k]));
    let ratio_sd = [0, 1].map(|k| in_range(p.ratio_sd[k], ratios[k]));
    let turn_sd = [0, 1, 2].map(|k| in_range(p.turn_sd[k], turns[k]));
    let reasons = names.into_iter().zip(all).filter_map(|(name, why)| Some((name, why?.to_string())));
    json!({
        "moments": p.moments,
        "moment_sd": p.moment_sd.map(|sd| sd.filter(|sd| sd.is_finite())),
        "moment_covariance": p.moment_covariance,
        "ratios": values,
        "ratio_sd": ratio_sd,
        "ratio_correlation": p.ratio_correlation,
        "thickness": in_range(Some(p.thickness), thickness),
        "thickness_sd": in_range(p.thickness_sd, thickness),
        "axes": p.axes,
        "turn_sd": turn_sd,
        "not_determined": reasons.collect::<std::collections::BTreeMap<_, _>>(),
        "triangle": picture::triangle_to_json(p),
    })
}

pub(crate) fn residuals_to_json(tests: &[ResidualTest]) -> Value {
    let each = |test: &ResidualTest| {
        json!({
            "what": test.what,
            "count": test.count,
            "degrees_of_freedom": test.degrees_of_freedom,
            "noise": test.noise,
            "noise_is_told": test.noise_is_told,
            "reduced_chi_square": test.reduced_chi_square,
            "lag_correlation": test.lag_correlation,
            "is_too_large": test.is_too_large(),
            "is_correlated": test.is_correlated(),
        })
    };
    tests.iter().map(each).collect()
}
