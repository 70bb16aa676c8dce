//! Grade card of a program: results of all cases of the suite.

use polhode::infer::judge::AccuracyOrder;
use polhode_document::layout::printable;
use polhode_document::number::{error, number};
use polhode_document::{Document, Level, Section, Verdict};
use serde_json::{Value, json};

use super::{JudgedRun, accuracy_order, graph, json, words};
use polhode_document::VERSION;

/// Grade card of a program: results of all cases of the suite.
#[derive(Clone, Debug)]
pub struct Card {
    /// Name of the graded folder.
    pub name: String,
    /// Cases in the suite's order.
    pub cases: Vec<CardCase>,
    /// Tolerance of a passed case: largest attitude error of its best run, rad, and largest error
    /// of ω relative to its largest value.
    pub limit: f64,
}

/// Result of one case of the suite.
#[derive(Clone, Debug)]
pub struct CardCase {
    /// Name of the case.
    pub name: String,
    /// Title of the scenario.
    pub title: String,
    /// Outcome of the runs.
    pub run: CardRun,
}

/// Outcome of a case.
#[derive(Clone, Debug)]
pub enum CardRun {
    /// Judged runs of the program, one per step.
    Judged(Vec<JudgedRun>),
    /// Reason why the case was not run.
    NotRun(String),
    /// Reason why a run cannot be read or judged.
    Unreadable(String),
}

/// Grade of a case.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Grade {
    Passed,
    Failed,
    NotRun,
}

impl Grade {
    const fn word(self) -> &'static str {
        match self {
            Self::Passed => "passed",
            Self::Failed => "failed",
            Self::NotRun => "not run",
        }
    }
}

impl CardCase {
    /// Returns the run with the smallest error, mostly that of the smallest step.
    fn best(&self) -> Option<&JudgedRun> {
        match &self.run {
            CardRun::Judged(runs) => runs.iter().min_by(|a, b| a.worst().total_cmp(&b.worst())),
            _ => None,
        }
    }

    fn grade(&self, limit: f64) -> Grade {
        match (&self.run, self.best()) {
            (CardRun::NotRun(_), _) => Grade::NotRun,
            (_, Some(run)) if run.worst() <= limit => Grade::Passed,
            _ => Grade::Failed,
        }
    }

    fn order(&self) -> Option<AccuracyOrder> {
        match &self.run {
            CardRun::Judged(runs) => accuracy_order(runs),
            _ => None,
        }
    }

    fn row(&self, limit: f64) -> Vec<String> {
        let grade = self.grade(limit).word().to_owned();
        let Some(run) = self.best() else {
            let why = match &self.run {
                CardRun::NotRun(why) | CardRun::Unreadable(why) => printable(why),
                CardRun::Judged(_) => String::new(),
            };
            let none = || "—".to_owned();
            return vec![self.name.clone(), grade, none(), none(), none(), none(), why];
        };
        let last_order = self.order().and_then(|order| order.orders.into_iter().flatten().last());
        let order = last_order.map_or_else(|| "—".to_owned(), |p| format!("{p:.2}"));
        let omega = run.omega_off().map_or_else(|| "—".to_owned(), error);
        let why = if run.is_exact() { "correct".to_owned() } else { words::why(run) };
        vec![self.name.clone(), grade, words::step(run), error(run.largest()), omega, order, why]
    }

    fn to_json(&self, limit: f64) -> Value {
        let grade = self.grade(limit).word().replace(' ', "_");
        let (runs, why) = match &self.run {
            CardRun::Judged(runs) => (runs.iter().map(json::run).collect(), Value::Null),
            CardRun::NotRun(why) | CardRun::Unreadable(why) => (json!([]), why.as_str().into()),
        };
        json!({
            "case": self.name,
            "title": self.title,
            "grade": grade,
            "attitude_largest_rad": self.best().map(JudgedRun::largest),
            "order_of_accuracy": self.order().map(|order| order.orders),
            "why_not": why,
            "runs": runs,
        })
    }
}

impl Card {
    /// Returns the number of cases with this grade.
    fn count(&self, grade: Grade) -> usize {
        self.cases.iter().filter(|case| case.grade(self.limit) == grade).count()
    }

    /// Returns true if a case was run and failed.
    pub fn has_failed(&self) -> bool {
        self.count(Grade::Failed) > 0
    }

    /// Returns true if any case was run.
    pub fn was_run(&self) -> bool {
        self.count(Grade::NotRun) < self.cases.len()
    }

    /// Returns the programs named in the runs.
    fn engines(&self) -> Vec<String> {
        let runs = self.cases.iter().filter_map(|case| match &case.run {
            CardRun::Judged(runs) => Some(runs),
            _ => None,
        });
        let mut engines: Vec<String> =
            runs.flatten().filter_map(|run| run.engine.as_deref()).map(printable).collect();
        engines.sort();
        engines.dedup();
        engines
    }

    /// Returns the card as JSON.
    pub fn to_json(&self) -> Value {
        json!({
            "polhode": VERSION,
            "suite": self.name,
            "engines": self.engines(),
            "limit_rad": self.limit,
            "passed": self.count(Grade::Passed),
            "failed": self.count(Grade::Failed),
            "not_run": self.count(Grade::NotRun),
            "cases": self.cases.iter().map(|case| case.to_json(self.limit)).collect::<Value>(),
        })
    }

    /// Returns the card as a document, which can be printed as text, Markdown or HTML.
    pub fn to_document(&self) -> Document {
        let [passed, failed, not_run] =
            [Grade::Passed, Grade::Failed, Grade::NotRun].map(|grade| self.count(grade));
        let limit = number(self.limit, 3);
        let mut answer = vec![format!(
            "{passed} of {} cases passed, {failed} failed, {not_run} not run. Limits: attitude error {limit} rad, relative error of ω {limit}.",
            self.cases.len()
        )];
        let engines = self.engines();
        if !engines.is_empty() {
            answer.push(format!("Run with {}.", engines.join("; ")));
        }
        let mut cases = Section::new(1, "Cases");
        let headers =
            ["case", "grade", "step", "largest error (rad)", "error of ω (relative)", "order", "reason"];
        cases.table(&headers, self.cases.iter().map(|case| case.row(self.limit)).collect());
        let mut errors = Section::new(2, "Errors against time");
        for case in &self.cases {
            let Some(run) = case.best() else { continue };
            errors.say(format!("{}. {}: {}.", case.name, case.title, words::how_far(run)));
            if let Some(graph) = graph::of_error(run) {
                errors.graph(graph);
            }
        }
        let sections = if errors.blocks.is_empty() { vec![cases] } else { vec![cases, errors] };
        let verdict = match (failed, not_run) {
            (0, 0) => Verdict::new(Level::Ok, "All cases passed"),
            (0, _) => Verdict::new(Level::Warning, format!("{not_run} cases were not run")),
            _ => Verdict::new(Level::Failure, format!("{failed} of {} cases failed", self.cases.len())),
        };
        Document {
            verdict: Some(verdict),
            title: format!("Grade card: {}", printable(&self.name)),
            answer,
            sections,
            findings: Vec::new(),
        }
    }
}
