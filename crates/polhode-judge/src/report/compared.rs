//! Report on runs compared with another log of the same motion.

use polhode::infer::judge::{Growth, RateErrors};
use polhode_document::layout::printable;
use polhode_document::number::{count, error, number};
use polhode_document::{Document, Level, Section, VERSION, Verdict};
use serde_json::{Value, json};

use super::{OMEGA_EXACT, capitalized, graph, json, spacing, words};
use crate::against::{Differences, Interpretation, Other};

/// Report on runs compared with another log of the same motion.
#[derive(Clone, Debug)]
pub struct Comparison {
    other: Other,
    runs: Vec<ComparedRun>,
}

/// Run compared with another log.
#[derive(Clone, Debug)]
pub(crate) struct ComparedRun {
    pub(crate) path: String,
    pub(crate) engine: Option<String>,
    /// Stated time step of the program, s.
    pub(crate) step: Option<f64>,
    pub(crate) ignored: Vec<String>,
    pub(crate) is_single_precision: bool,
    pub(crate) found: Differences,
}

impl ComparedRun {
    fn name(&self) -> String {
        printable(&self.path)
    }

    fn angles(&self) -> Vec<f64> {
        self.found.errors.angles()
    }

    /// Returns the largest angle between an attitude and that of the other log, rad.
    fn largest(&self) -> f64 {
        largest(&self.angles())
    }

    /// Returns the largest |δω|, relative to the largest |ω| of the other log.
    fn omega_off(&self) -> Option<f64> {
        self.found.errors.rates.as_ref().map(|rates| largest(&rates.omega))
    }

    fn worst(&self) -> f64 {
        self.largest().max(self.omega_off().unwrap_or(0.0))
    }

    fn is_same(&self) -> bool {
        self.largest() <= 3.0 * self.found.floor
            && self.omega_off().is_none_or(|off| off <= self.omega_floor())
    }

    /// Returns the relative difference of ω that rounding of ω and of time explains.
    fn omega_floor(&self) -> f64 {
        OMEGA_EXACT.max(3.0 * self.found.floor)
    }

    fn last(&self) -> f64 {
        self.angles().last().copied().unwrap_or(0.0)
    }

    /// Returns the differences of T and L; `None` without moments.
    fn rates_by_moments(&self) -> Option<&RateErrors> {
        self.found.errors.rates.as_ref().filter(|_| self.found.has_moments)
    }

    /// Returns the differences in words.
    fn how_far(&self) -> String {
        if self.is_same() {
            return format!("no difference above {} rad", error(self.found.floor));
        }
        let growth = match self.found.growth {
            Growth::Unknown => String::new(),
            growth => format!("; {growth}"),
        };
        let omega = self
            .omega_off()
            .map_or_else(String::new, |off| format!("; difference of ω at most {} (relative)", error(off)));
        let (last, largest) = (error(self.last()), error(self.largest()));
        format!("attitude difference {last} rad at the end, at most {largest} rad{growth}{omega}")
    }

    fn to_json(&self) -> Value {
        let Differences { motion, errors, split, growth, floor, .. } = &self.found;
        let step = self.step.or_else(|| spacing(&motion.times));
        let rates = errors.rates.as_ref().map(|rates| {
            let of_moments = self.rates_by_moments();
            json!({
                "omega_relative": largest(&rates.omega),
                "kinetic_energy_relative": of_moments.map(|rates| largest(&rates.kinetic_energy)),
                "momentum_relative": of_moments.map(|rates| largest(&rates.momentum)),
                "momentum_direction_rad": of_moments.map(|rates| largest(&rates.momentum_direction)),
            })
        });
        json!({
            "run": self.name(),
            "path": self.path,
            "engine": self.engine,
            "step_s": step,
            "step_is_said": self.step.is_some(),
            "rows": motion.times.len(),
            "first_s": motion.times.first(),
            "last_s": motion.times.last(),
            "not_read": self.ignored,
            "single_precision": self.is_single_precision,
            "reading": interpretation(&self.found.interpretation, self.found.is_against_names),
            "other_meaning": self.found.has_other_meaning,
            "error": {
                "attitude_last_rad": self.last(),
                "attitude_largest_rad": self.largest(),
                "rates": rates,
                "quaternion_length": errors.norm,
                "exact_to_rad": floor,
            },
            "growth": json::growth(*growth),
            "split": json::split(split),
        })
    }
}

fn interpretation(meaning: &Interpretation, is_against_names: bool) -> Value {
    json::interpretation(&meaning.reading, meaning.omega, is_against_names)
}

/// Returns the meaning of a log in words.
fn meaning(path: &str, Interpretation { reading, omega }: &Interpretation) -> String {
    let omega = omega.map_or_else(|| "no ω".to_owned(), |omega| omega.to_string());
    format!("{}: {}; {omega}", printable(path), words::reading(reading))
}

fn largest(of: &[f64]) -> f64 {
    of.iter().map(|e| e.abs()).fold(0.0, f64::max)
}

impl Comparison {
    pub(crate) fn new(other: Other, runs: Vec<ComparedRun>) -> Self {
        Self { other, runs }
    }

    /// Returns true if a difference exceeds the limit (attitude in rad, ω relative to its largest
    /// value), or if numbers have another meaning than the names of their columns state, or than
    /// the same columns have in the other log.
    pub fn is_beyond(&self, limit: f64) -> bool {
        self.runs.iter().any(|run| run.worst() > limit) || !self.contradictions().is_empty()
    }

    /// Returns the interpretations that contradict column names or each other.
    fn contradictions(&self) -> Vec<String> {
        let other = meaning(&self.other.path, &self.other.interpretation);
        let contrary = |meaning: &str| format!("Interpreted contrary to its column names: {meaning}");
        let mut found = Vec::new();
        for run in &self.runs {
            let meaning = meaning(&run.path, &run.found.interpretation);
            if run.found.is_against_names {
                found.push(contrary(&meaning));
            }
            if run.found.has_other_meaning {
                found.push(format!("The same columns have different meanings: {meaning}; {other}"));
            }
        }
        if self.other.is_against_names {
            found.push(contrary(&other));
        }
        found
    }

    /// Returns the report as JSON.
    pub fn to_json(&self) -> Value {
        json!({
            "polhode": VERSION,
            "against": {
                "path": self.other.path,
                "engine": self.other.engine,
                "rows": self.other.motion.times.len(),
                "not_read": self.other.ignored,
                "single_precision": self.other.is_single_precision,
                "reading": interpretation(&self.other.interpretation, self.other.is_against_names),
            },
            "runs": self.runs.iter().map(ComparedRun::to_json).collect::<Value>(),
        })
    }

    /// Returns the report as a document, which can be printed as text, Markdown or HTML.
    pub fn to_document(&self) -> Document {
        let contradictions = self.contradictions();
        let how_far = |run: &ComparedRun| match contradictions.is_empty() {
            true => run.how_far(),
            false => format!("{}, interpreted as follows", run.how_far()),
        };
        let named = |run: &ComparedRun| match self.runs.len() {
            1 => capitalized(how_far(run)),
            _ => format!("{}: {}", run.name(), how_far(run)),
        };
        let title = match &self.runs[..] {
            [run] => format!("{} compared with {}", run.name(), printable(&self.other.path)),
            _ => format!("Runs compared with {}", printable(&self.other.path)),
        };
        let answer = self.runs.iter().map(named).chain(contradictions.iter().cloned()).collect();
        let verdict = match () {
            () if !contradictions.is_empty() => (Level::Failure, "Columns have contradictory meanings"),
            () if self.runs.iter().all(ComparedRun::is_same) => (Level::Ok, "The motions are the same"),
            () => (Level::Warning, "The motions differ"),
        };
        Document {
            verdict: Some(Verdict::new(verdict.0, verdict.1)),
            title,
            answer,
            sections: vec![self.data(), self.differences(), self.parts()],
            findings: Vec::new(),
        }
    }

    fn data(&self) -> Section {
        let mut s = Section::new(1, "Data");
        let row = |path: &str, engine: Option<&str>, times: &[f64]| {
            let [first, last] =
                [times.first(), times.last()].map(|time| number(time.copied().unwrap_or(0.0), 6));
            let engine = engine.map_or_else(|| "not stated".to_owned(), printable);
            vec![printable(path), engine, count(times.len() as u64), format!("{first} … {last}")]
        };
        let runs = self.runs.iter().map(|run| row(&run.path, run.engine.as_deref(), &run.found.motion.times));
        let other = row(&self.other.path, self.other.engine.as_deref(), &self.other.motion.times);
        s.table(&["log", "program", "rows", "t (s)"], runs.chain([other]).collect());
        for run in &self.runs {
            say_log(&mut s, &run.path, &run.found.interpretation, &run.ignored, run.is_single_precision);
        }
        let Other { path, interpretation, ignored, is_single_precision, .. } = &self.other;
        say_log(&mut s, path, interpretation, ignored, *is_single_precision);
        s
    }

    fn differences(&self) -> Section {
        let mut s = Section::new(2, "Differences");
        let row = |run: &ComparedRun| {
            let shown = |off: Option<f64>| off.map_or_else(|| "—".to_owned(), error);
            let by_moments = run.rates_by_moments();
            vec![
                run.name(),
                error(run.last()),
                error(run.largest()),
                shown(run.omega_off()),
                shown(by_moments.map(|rates| largest(&rates.kinetic_energy))),
                shown(by_moments.map(|rates| largest(&rates.momentum))),
                shown(by_moments.map(|rates| largest(&rates.momentum_direction))),
                error(run.found.floor),
            ]
        };
        let headers =
            ["run", "attitude (end)", "attitude (max)", "ω", "T", "|L|", "direction of L", "rounding"];
        s.table(&headers, self.runs.iter().map(row).collect());
        s.say(
            "Attitude and direction of L in rad; ω, T and |L| relative to the largest of the other log, or of the run if the other log is at \
             rest; each the largest of all rows. The last column is the rotation that rounding of attitudes and times explains.",
        );
        if self.runs.iter().any(|run| run.found.errors.rates.is_none()) {
            s.say("ω is compared only if both logs have it.");
        } else if self.runs.iter().any(|run| !run.found.has_moments) {
            s.say("T and L require the principal moments: --moments A,B,C.");
        }
        for run in self.runs.iter().filter(|run| run.found.errors.norm > 1e-6) {
            let norm = error(run.found.errors.norm);
            s.say(format!("{}: the quaternion norm differs from 1 by up to {norm}.", run.name()));
        }
        let graph = |run: &ComparedRun| {
            let title = format!("Attitude difference: {}", run.name());
            let (up, level) = ("log₁₀ of the difference", "rounding of attitudes and times");
            graph::of_angles(title, &run.found.motion.times, &run.angles(), up, (run.found.floor, level))
        };
        self.runs.iter().filter_map(graph).for_each(|graph| s.graph(graph));
        s
    }

    fn parts(&self) -> Section {
        let mut s = Section::new(3, "Difference breakdown");
        for run in self.runs.iter().filter(|run| !run.is_same()) {
            words::breakdown(&mut s, "difference", &run.name(), &run.found.split);
        }
        if s.blocks.is_empty() {
            s.say("No difference is distinguishable from zero.");
        }
        s
    }
}

fn say_log(
    s: &mut Section,
    path: &str,
    interpretation: &Interpretation,
    ignored: &[String],
    is_single: bool,
) {
    let name = printable(path);
    s.say(format!("{}.", meaning(path, interpretation)));
    if !ignored.is_empty() {
        let names: Vec<String> = ignored.iter().map(|name| printable(name)).collect();
        s.say(format!("Ignored columns of {name}: {}.", names.join(", ")));
    }
    if is_single {
        s.say(format!("The numbers of {name} have single precision (6e-8 relative)."));
    }
}
