//! Estimated error of a motion, compared with its true error: `book/error.md`.
//!
//! `POLHODE_GOLDEN=write cargo test -p polhode-scenario --test all motion_errors` writes the page
//! again; review the difference.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::Path;

use polhode::motion::{ErrorEffort, Solution};

use super::Case;

/// The page with placeholders for its numbers.
const PAGE: &str = include_str!("error.md");

/// Ratios of estimate to true error, for the states of several motions.
#[derive(Default)]
struct Ratios {
    motions: usize,
    /// Number of motions with a state whose estimate is below half of its error.
    low: usize,
    attitude: Vec<f64>,
    omega: Vec<f64>,
}

impl Ratios {
    fn add(&mut self, case: &Case, states: &[[f64; 2]]) {
        self.motions += 1;
        self.low += usize::from(states.iter().flatten().any(|ratio| *ratio < 0.5));
        assert!(states.iter().flatten().all(|ratio| *ratio > 0.0), "{}: {states:?}", case.name);
        self.attitude.extend(states.iter().map(|[attitude, _]| attitude));
        self.omega.extend(states.iter().map(|[_, omega]| omega));
    }

    fn row(&mut self, name: &str) -> String {
        let [attitude, omega] = [&mut self.attitude, &mut self.omega].map(|ratios| {
            let [least, middle, most] = [0.0, 0.5, 0.9].map(|p| quantile(ratios, p));
            format!("{}, {}, {}", down(least), down(middle), down(most))
        });
        format!("| {name} | {} | {attitude} | {omega} |\n", self.motions)
    }
}

/// Returns the ratios by kind of motion, by method, and for all.
fn measured(cases: &[Case], effort: ErrorEffort) -> [BTreeMap<String, Ratios>; 3] {
    let mut all: [BTreeMap<String, Ratios>; 3] = Default::default();
    for case in cases {
        let trajectory = case.scenario.simulate_with_error(effort, &mut |_| true).unwrap();
        let trajectory = trajectory.unwrap_or_else(|error| panic!("{}: {error}", case.name));
        let error = trajectory.error().unwrap();
        let of = |time: f64| {
            let at = trajectory.samples().iter().position(|sample| sample.state.time == time).unwrap();
            error.computation()[at]
        };
        // An error below 1e-17 counts as zero, and so does its estimate.
        let ratio = |estimate: f64, off: f64| estimate / off.max(1e-17);
        let states: Vec<[f64; 2]> = (case.off(&trajectory).iter().zip(&case.truth))
            .map(|(off, truth)| {
                let estimate = of(truth.time);
                [ratio(estimate.attitude, off.attitude), ratio(estimate.omega, off.omega)]
            })
            .collect();
        let method = match trajectory.solution() {
            Solution::ClosedForm(_) => "closed forms".to_owned(),
            other => format!("`{}`", other.name()),
        };
        let names = [case.kind.replace('_', " "), method, "all".to_owned()];
        for (map, name) in all.iter_mut().zip(names) {
            map.entry(name).or_default().add(case, &states);
        }
    }
    all
}

fn quantile(ratios: &mut [f64], p: f64) -> f64 {
    ratios.sort_by(f64::total_cmp);
    ratios[((ratios.len() - 1) as f64 * p) as usize]
}

/// Formats two digits, rounded down, so that no ratio looks better than it is.
fn down(x: f64) -> String {
    let unit = 10_f64.powf(x.log10().floor() - 1.0);
    let x = (x / unit + 1e-9).floor() * unit;
    if x < 100.0 {
        format!("{x:.*}", (1.0 - x.log10().floor()).max(0.0) as usize)
    } else {
        format!("{x:.1e}")
    }
}

#[test]
fn no_estimate_is_below_half_of_the_error() {
    let cases = Case::all();
    let mut page = PAGE.replace("{motions}", &cases.len().to_string());
    for (effort, place) in [(ErrorEffort::Thorough, "thorough"), (ErrorEffort::Cheap, "cheap")] {
        let [mut kinds, mut methods, mut all] = measured(&cases, effort);
        let total = all.get_mut("all").unwrap();
        let middle = [quantile(&mut total.attitude, 0.5), quantile(&mut total.omega, 0.5)];
        if place == "cheap" {
            // The page has cheap estimates by method only.
            kinds.clear();
        }
        let mut rows = String::new();
        for (name, ratios) in kinds.iter_mut().chain(&mut methods).chain(&mut all) {
            rows += &ratios.row(name);
        }
        let low = all["all"].low;
        assert!(low == 0, "{effort:?}: {low} motions are worse than they say\n{rows}");
        let most = if effort == ErrorEffort::Thorough { 7.0 } else { 11.0 };
        assert!(middle.iter().all(|ratio| *ratio <= most), "{effort:?}: {middle:?}\n{rows}");
        page = page.replace(&format!("{{{place}}}"), rows.trim_end());
    }
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../book/error.md");
    if std::env::var_os("POLHODE_GOLDEN").is_some() {
        std::fs::write(&path, &page).unwrap();
    }
    let book = std::fs::read_to_string(&path).unwrap_or_default().replace("\r\n", "\n");
    let mut difference = String::new();
    for (ours, theirs) in page.lines().zip(book.lines()).filter(|(a, b)| a != b) {
        writeln!(difference, "- {theirs}\n+ {ours}").unwrap();
    }
    assert!(page == book, "book/error.md is not what is measured:\n{difference}");
}
