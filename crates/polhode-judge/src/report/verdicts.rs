//! Report on one scenario and its runs by other programs.

use polhode::body::Finding;
use polhode::infer::judge::AccuracyOrder;
use polhode::motion::Scenario;
use polhode_document::layout::printable;
use polhode_document::number::{count, counted, error, number};
use polhode_document::{Document, Level, Section, Verdict};
use serde_json::Value;

use super::{JudgedRun, accuracy_order, capitalized, graph, json, words};

/// Report on one scenario and its judged runs by other programs.
#[derive(Clone, Debug)]
pub struct JudgeReport {
    title: String,
    runs: Vec<JudgedRun>,
    order: Option<AccuracyOrder>,
    findings: Vec<Finding>,
}

/// Maximum number of interpretations and of causes shown per run, best first.
const SHOWN: usize = 8;

impl JudgeReport {
    /// Creates the report of a scenario and its runs. Runs with different steps give the order of
    /// accuracy.
    pub fn new(scenario: &Scenario, runs: Vec<JudgedRun>) -> Self {
        let order = accuracy_order(&runs);
        let title = scenario.title().unwrap_or("scenario").to_owned();
        Self { title, runs, order, findings: scenario.findings().to_vec() }
    }

    /// Returns the largest [`JudgedRun::worst`] of all runs.
    pub fn worst(&self) -> f64 {
        self.runs.iter().map(JudgedRun::worst).fold(0.0, f64::max)
    }

    /// Returns true if a mistake was found, or an error exceeds the limit: attitude in rad, ω
    /// relative to its largest value.
    pub fn is_beyond(&self, limit: f64) -> bool {
        self.worst() > limit || self.runs.iter().any(JudgedRun::has_mistake)
    }

    /// Returns the report as JSON.
    pub fn to_json(&self) -> Value {
        json::report(&self.title, &self.runs, self.order.as_ref(), &self.findings)
    }

    /// Returns the report as a document, which can be printed as text, Markdown or HTML.
    pub fn to_document(&self) -> Document {
        let named = |run: &JudgedRun, what: String| match self.runs.len() {
            1 => capitalized(what),
            _ => format!("{}: {what}", printable(&run.name)),
        };
        let answer = self.runs.iter().flat_map(|run| {
            let far = named(run, words::how_far(run));
            let why = (!run.is_exact()).then(|| named(run, words::why(run)));
            let read = words::read_as(run).map(|read| named(run, read));
            std::iter::once(far).chain(why).chain(read)
        });
        let mut sections = vec![self.runs(), self.readings(), self.errors(), self.parts()];
        sections.extend(self.causes());
        sections.extend(self.order.as_ref().map(order));
        for (k, section) in sections.iter_mut().enumerate() {
            section.number = u8::try_from(k + 1).unwrap_or(u8::MAX);
        }
        let title = match &self.runs[..] {
            [run] => format!("{}: {}", self.title, run.name),
            _ => self.title.clone(),
        };
        let (verdict, answer) = (Some(self.verdict()), answer.collect());
        Document { title, verdict, answer, sections, findings: self.findings.clone() }
    }

    fn verdict(&self) -> Verdict {
        let (level, reason) = match () {
            () if self.runs.iter().any(JudgedRun::has_mistake) => (Level::Failure, "A mistake was found"),
            () if self.runs.iter().all(JudgedRun::is_exact) => (Level::Ok, "The motion is correct"),
            () if self.runs.iter().all(JudgedRun::is_explained) => (Level::Ok, "No mistake was found"),
            () => (Level::Warning, "The cause of an error is unknown"),
        };
        Verdict::new(level, reason)
    }

    fn runs(&self) -> Section {
        let mut s = Section::new(1, "Data");
        let row = |run: &JudgedRun| {
            let times = &run.judgement.motion.times;
            let (first, last) = (times.first().copied().unwrap_or(0.0), times.last().copied().unwrap_or(0.0));
            vec![
                printable(&run.name),
                run.engine.as_deref().map_or_else(|| "not stated".to_owned(), printable),
                count(times.len() as u64),
                format!("{} … {}", number(first, 6), number(last, 6)),
                words::step(run),
            ]
        };
        s.table(&["run", "program", "rows", "t (s)", "step"], self.runs.iter().map(row).collect());
        for run in self.runs.iter().filter(|run| !run.ignored.is_empty()) {
            let names: Vec<String> = run.ignored.iter().map(|name| printable(name)).collect();
            s.say(format!("Ignored columns of {}: {}.", run.name, names.join(", ")));
        }
        for run in self.runs.iter().filter(|run| run.judgement.is_single_precision) {
            s.say(format!("The numbers of {} have single precision (6e-8 relative).", run.name));
        }
        s
    }

    fn readings(&self) -> Section {
        let mut s = Section::new(2, "Interpretation of the columns");
        for run in &self.runs {
            let readings = &run.judgement.readings;
            let omega = readings.omega.map_or_else(|| "no ω".to_owned(), |omega| omega.to_string());
            s.say(format!("{}: {}; {omega}.", run.name, words::reading(&readings.reading)));
            if readings.from_own_start {
                s.say("No interpretation begins with the scenario's attitude, so the rotation since the first row is compared.");
            }
            if readings.equivalent > 1 {
                s.say(format!(
                    "The first {} interpretations give the same motion up to the last row.",
                    readings.equivalent
                ));
            }
            let row = |tried: &polhode::infer::judge::ReadingResidual| {
                vec![words::reading(&tried.reading), error(tried.attitude), number(tried.relative, 3)]
            };
            let headers = ["interpretation", "error at the beginning (rad)", "relative to the rotation"];
            s.table(&headers, readings.tried.iter().take(SHOWN).map(row).collect());
            if let Some(more) = readings.tried.len().checked_sub(SHOWN + 1) {
                s.say(format!(
                    "Not shown: {} with larger errors.",
                    counted(more + 1, "other interpretation")
                ));
            }
        }
        s
    }

    fn errors(&self) -> Section {
        let mut s = Section::new(3, "Errors");
        let row = |run: &JudgedRun| {
            let (judgement, errors) = (&run.judgement, &run.judgement.errors);
            let largest = |of: &[f64]| error(of.iter().map(|e| e.abs()).fold(0.0, f64::max));
            let rates = errors.rates.as_ref();
            let rate = |of: &dyn Fn(&polhode::infer::judge::RateErrors) -> String| {
                rates.map_or_else(|| "—".to_owned(), of)
            };
            vec![
                printable(&run.name),
                error(judgement.last_attitude_error()),
                error(run.largest()),
                rate(&|rates| largest(&rates.omega)),
                rate(&|rates| largest(&rates.kinetic_energy)),
                rate(&|rates| largest(&rates.momentum)),
                rate(&|rates| largest(&rates.momentum_direction)),
                error(judgement.floor()),
            ]
        };
        let headers =
            ["run", "attitude (end)", "attitude (max)", "ω", "T", "|L|", "direction of L", "reference"];
        s.table(&headers, self.runs.iter().map(row).collect());
        s.say(
            "Attitude and direction of L in rad; ω, T and |L| relative to the largest of the exact motion; each the largest of all rows. The \
             last column is the estimated error of the exact attitude.",
        );
        for run in &self.runs {
            if run.judgement.errors.norm > 1e-6 {
                let norm = error(run.judgement.errors.norm);
                s.say(format!("{}: the quaternion norm differs from 1 by up to {norm}.", run.name));
            }
        }
        self.runs.iter().filter_map(graph::of_error).for_each(|graph| s.graph(graph));
        s
    }

    fn parts(&self) -> Section {
        let mut s = Section::new(4, "Error breakdown");
        for run in self.runs.iter().filter(|run| !run.is_exact()) {
            words::breakdown(&mut s, "error", &run.name, &run.judgement.split);
        }
        if s.blocks.is_empty() {
            s.say("No error is distinguishable from zero.");
        }
        s
    }

    /// Returns a section on the causes that were tested; `None` without any.
    fn causes(&self) -> Option<Section> {
        let mut s = Section::new(5, "Most likely causes");
        for run in self.runs.iter().filter(|run| !run.causes.tried.is_empty()) {
            let causes = &run.causes;
            let [from, to] = causes.span.map(|time| number(time, 4));
            s.say(format!("{}, from {from} to {to} s; {}.", run.name, words::why(run)));
            let row = |tried: &polhode::infer::judge::TriedCause| {
                let named = if tried.is_named { "likely" } else { "not likely" };
                let explained = words::share(tried.explained.max(0.0));
                vec![printable(&tried.cause.to_string()), error(tried.residual), explained, named.to_owned()]
            };
            let headers = ["tested cause", "residual (rad)", "explains", "verdict"];
            s.table(&headers, causes.tried.iter().take(SHOWN).map(row).collect());
            for tried in causes.named().take(2) {
                s.say(tried.cause.hint());
            }
        }
        (!s.blocks.is_empty()).then_some(s)
    }
}

fn order(order: &AccuracyOrder) -> Section {
    let mut s = Section::new(6, "Order of accuracy");
    let until = number(order.time, 4);
    s.say(format!("Largest error until {until} s, while the errors of all runs are below 0.5 rad:"));
    let row = |(k, (step, off)): (usize, &(f64, f64))| {
        let found = k.checked_sub(1).and_then(|k| order.orders[k]);
        vec![number(*step, 6), error(*off), found.map_or_else(|| "—".to_owned(), |p| format!("{p:.2}"))]
    };
    s.table(&["step (s)", "error (rad)", "order"], order.runs.iter().enumerate().map(row).collect());
    s
}
