//! Reports of a parts list, for people and for programs.

mod ballast;
mod body;
mod case;
mod changing;
mod compared;
mod diff;
mod found;
pub(crate) mod history;
mod influence;
mod json;
mod limits;
mod masses;
mod numbers;
mod of_file;
mod parts;
mod principal;
mod side_by_side;
mod states;
mod table;
mod whole;
pub mod workbook;

use polhode::body::{Finding, Severity};
use polhode_document::layout::printable;
use polhode_document::number::{NO_BREAK, count, number, with_error};
use polhode_document::{Document, Level, Section, Verdict};

use crate::read::{Prescribed, Questions};
use crate::{
    Ballast, BallastError, Basis, Budget, BudgetError, Limit, LimitError, RowName, Sequence, SequenceError,
};
use ballast::OfCase;
use case::Case;
use changing::Changing;
use found::Found;

pub use diff::BudgetDiff;
pub use of_file::Scope;

/// Statements of a parts list outside its rows and its limits.
#[derive(Clone, Debug, Default)]
struct Statements {
    /// Requested number of draws.
    draws: Option<usize>,
    ballast: Option<Ballast>,
    prescribed: Option<Prescribed>,
}

/// Report of a mass budget, with one case for each configuration.
#[derive(Clone, Debug)]
pub struct BudgetReport {
    title: String,
    /// Descriptions of the sources, line by line.
    sources: Vec<String>,
    options: Questions,
    limits: Vec<Limit>,
    ballast: Option<Ballast>,
    /// Other statements of the list, for differences.
    stated: Statements,
    cases: Vec<Case>,
}

impl BudgetReport {
    /// Computes the report of each configuration, of which there must be at least one. Tests the
    /// limits with its draws, if there are any. `sources` describes the files that were read.
    ///
    /// Without a number of draws, nothing is drawn.
    ///
    /// # Errors
    /// Same as [`Budget::estimate`], [`Budget::draws`] and [`Budget::limits`]. Also an error if the
    /// point of [`Questions::about`] is so far away that the tensor about it is not finite.
    pub fn new(
        title: Option<&str>,
        sources: Vec<String>,
        configurations: Vec<(Option<String>, Budget)>,
        limits: Vec<Limit>,
        options: Questions,
    ) -> Result<Self, LimitError> {
        Self::watched(title, sources, configurations, limits, options, &mut |_| ())
    }

    /// Computes the report as [`BudgetReport::new`] does, and calls `reached` with the number of
    /// bodies of a configuration drawn so far.
    ///
    /// # Errors
    /// Same as [`BudgetReport::new`].
    pub fn watched(
        title: Option<&str>,
        sources: Vec<String>,
        configurations: Vec<(Option<String>, Budget)>,
        limits: Vec<Limit>,
        options: Questions,
        reached: &mut dyn FnMut(usize),
    ) -> Result<Self, LimitError> {
        let case = |(name, budget)| Case::new(name, budget, &limits, &options, reached);
        let cases: Vec<Case> = configurations.into_iter().map(case).collect::<Result<_, _>>()?;
        if cases.is_empty() {
            return Err(BudgetError::Empty.into());
        }
        for case in &cases {
            about_in_range(case, &options)?;
        }
        Ok(Self {
            title: title.unwrap_or("a parts list").to_owned(),
            sources,
            options,
            limits,
            ballast: None,
            stated: Statements::default(),
            cases,
        })
    }

    /// Default number of draws for short lists.
    pub const DRAWS: usize = 10_000;

    /// Returns the default number of draws: [`Self::DRAWS`], or fewer for long lists, so that they
    /// take about ten seconds. It is at least 200.
    pub fn affordable_draws(rows: usize) -> usize {
        /// Largest product of rows and draws.
        const ROWS: usize = 20_000_000;
        const LEAST: usize = 200;
        (ROWS / rows.max(1)).clamp(LEAST, Self::DRAWS)
    }

    /// Returns the report with ballast with which each configuration meets the limits.
    ///
    /// Limits that the search cannot treat are left out and named.
    ///
    /// # Errors
    /// Same as [`Budget::ballast`]. Also an error if the search can treat none of the limits.
    pub fn with_ballast(mut self, ballast: Ballast) -> Result<Self, BallastError> {
        for case in &mut self.cases {
            case.ballast = Some(Found::new(&case.budget, &ballast, &self.limits)?);
        }
        self.ballast = Some(ballast);
        Ok(self)
    }

    /// Adds other statements of the list. Nothing is computed from them, but differences include
    /// them.
    fn with_statements(mut self, statements: Statements) -> Self {
        for (name, dry, _) in statements.prescribed.iter().flat_map(Prescribed::dry) {
            let cases = self.cases.iter_mut().filter(|case| case.name.as_deref() == name);
            cases.for_each(|case| case.dry = Some(dry.clone()));
        }
        self.stated = statements;
        self
    }

    /// Adds a configuration as a function of the fill of its tanks. If `until` is given, also adds
    /// it over time, from t = 0 to `until`, s.
    ///
    /// # Errors
    /// Same as [`Sequence::rows`].
    pub fn with_sequence(
        mut self,
        configuration: Option<&str>,
        sequence: &Sequence<'_>,
        until: Option<f64>,
    ) -> Result<Self, SequenceError> {
        for case in self.cases.iter_mut().filter(|case| case.name.as_deref() == configuration) {
            case.changing = Some(Changing::new(configuration, sequence, until)?);
        }
        Ok(self)
    }

    /// Returns true if a limit is not met, or if an allowable mass is exceeded.
    pub fn is_beyond(&self) -> bool {
        let is_beyond = |case: &Case| {
            case.exceeded().next().is_some() || limits::broken(case, &self.limits).next().is_some()
        };
        self.cases.iter().any(is_beyond)
    }

    /// Returns the names of the configurations.
    pub fn names(&self) -> Vec<Option<String>> {
        self.cases.iter().map(|case| case.name.clone()).collect()
    }

    /// Iterates over the configurations. Each item has the ten numbers of each drawn body, in the
    /// order of [`NUMBERS`](crate::NUMBERS); it is empty without draws.
    pub fn draws(&self) -> impl Iterator<Item = Vec<[f64; 10]>> + '_ {
        let bodies = |case: &Case| match &case.drawn {
            Some(drawn) => drawn.draws.bodies.iter().map(numbers::ten).collect(),
            None => Vec::new(),
        };
        self.cases.iter().map(bodies)
    }

    /// Returns the report as a document: text, Markdown or HTML.
    pub fn to_document(&self) -> Document {
        let basis = self.options.basis;
        let mut sections = Vec::new();
        if self.cases.len() > 1 {
            sections.push(side_by_side::section(&self.cases, basis));
        }
        for case in &self.cases {
            let mut of_case: Vec<Section> = limits::section(case, &self.limits).into_iter().collect();
            of_case.extend(
                self.ballast.as_ref().and_then(|all| Some(OfCase::new(case, &self.limits)?.section(all))),
            );
            of_case.extend([
                masses::section(case),
                whole::section(case, &self.options),
                principal::section(case, &self.options),
            ]);
            of_case.extend(case.changing.iter().flat_map(Changing::sections));
            of_case.extend(influence::section(case));
            of_case.extend(compared::section(case));
            of_case.push(parts::section(case, basis));
            if let Some(name) = case.name.as_ref().filter(|_| self.cases.len() > 1) {
                for section in &mut of_case {
                    section.title = format!("{}: {}", printable(name), section.title);
                }
            }
            sections.extend(of_case);
        }
        if !self.sources.is_empty() {
            let mut read = Section::new(0, "Input and assumptions");
            self.sources.iter().for_each(|line| read.line(line));
            sections.push(read);
        }
        for (k, section) in sections.iter_mut().enumerate() {
            section.number = u8::try_from(k + 1).unwrap_or(u8::MAX);
        }
        let answer = self.cases.iter().flat_map(|case| self.answer(case)).collect();
        let findings = self.findings();
        let verdict = self.verdict(&findings);
        Document { title: self.title.clone(), verdict, answer, sections, findings }
    }

    /// Returns the verdict on limits and allowable masses; `None` without limits and warnings.
    fn verdict(&self, findings: &[Finding]) -> Option<Verdict> {
        let has_warning = findings.iter().any(|finding| finding.severity == Severity::Warning);
        let (level, reason) = match () {
            () if self.cases.iter().any(|case| limits::broken(case, &self.limits).next().is_some()) => {
                (Level::Failure, "Not all limits are met")
            }
            () if self.is_beyond() => (Level::Failure, "A mass is greater than allowed"),
            () if has_warning => (Level::Warning, "The result has a warning"),
            () if self.limits.is_empty() => return None,
            () => (Level::Ok, "All limits are met"),
        };
        Some(Verdict::new(level, reason))
    }

    fn answer(&self, case: &Case) -> Vec<String> {
        let basis = self.options.basis;
        let name = case.name.as_deref().filter(|_| self.cases.len() > 1);
        let center = whole::center_in_words(case, basis);
        let mut lines = if name.is_some() {
            let estimate = case.estimate(basis);
            let mass = with_error(estimate.properties.mass(), estimate.sd(0));
            vec![format!("{} mass {mass} kg", basis.name()), center]
        } else {
            let moments = principal::in_words(case, &case.principal(basis));
            [mass_in_words(case), center, moments].into_iter().chain(masses::margin_in_words(case)).collect()
        };
        lines.extend(limits::answer_in_words(case));
        lines.extend(OfCase::new(case, &self.limits).map(OfCase::in_words));
        lines.extend(case.changing.as_ref().and_then(Changing::in_words));
        match name {
            Some(name) => vec![format!("{}: {}", printable(name), lines.join("; "))],
            None => lines,
        }
    }

    fn findings(&self) -> Vec<Finding> {
        let named = |case: &Case| case.name.clone().filter(|_| self.cases.len() > 1);
        let mut all = Vec::new();
        for case in &self.cases {
            let mut say = |code: &'static str, severity, message| {
                all.push(Finding { code, severity, message, place: named(case) });
            };
            let exceeded: Vec<usize> = case.exceeded().collect();
            if let [first, ..] = exceeded[..] {
                let names = printable(case.budget.rows().name(first));
                let others = match exceeded.len() {
                    1 => String::new(),
                    n => format!(" and {} more", count(n as u64 - 1)),
                };
                let verb = if exceeded.len() == 1 { "is" } else { "are" };
                let message =
                    format!("{names}{others} {verb} heavier than allowed, including the growth allowance");
                say("budget.margin", Severity::Warning, message);
            }
            let broken: Vec<String> = limits::broken(case, &self.limits).map(printable).collect();
            if !broken.is_empty() {
                let are = if broken.len() == 1 { "this limit is" } else { "these limits are" };
                say("budget.limit", Severity::Warning, format!("{are} not met: {}", broken.join(", ")));
            }
            let (exact, parts) = case.exact_parts();
            if exact == parts {
                let message = "no part has an uncertainty: all values are assumed exact".to_owned();
                say("budget.exact", Severity::Info, message);
            } else if exact > 0 {
                let of = format!("{} of {}", count(exact as u64), count(parts as u64));
                let message = format!("{of} parts have no uncertainty and are assumed exact");
                say("budget.exact", Severity::Info, message);
            }
            if let Some(message) = principal::not_known(&case.principal(self.options.basis)) {
                say("budget.axes", Severity::Warning, message);
            }
            if let Some(message) = compared::difference_in_words(case) {
                say("budget.first-order", Severity::Info, message);
            }
        }
        all
    }
}

/// Refuses a point that is so far away that the tensor about it, or its variance, overflows.
fn about_in_range(case: &Case, options: &Questions) -> Result<(), BudgetError> {
    let Some(point) = options.about else { return Ok(()) };
    let asked = whole::asked(case.estimate(options.basis), options);
    let is_finite = |asked: whole::Asked| {
        asked.numbers.iter().chain(asked.covariance.as_flattened()).all(|x| x.is_finite())
    };
    if asked.is_none_or(is_finite) {
        return Ok(());
    }
    let row = case.budget.root();
    let name = case.budget.rows().name(row).to_owned();
    let what = "the largest coordinate of the requested reference point";
    let rule = "so small that mass times its square, and the variance of this product, do not overflow";
    Err(BudgetError::Value { row: RowName { row, name }, what, value: point.max_abs(), rule })
}

/// Returns words such as `Predicted mass 4.312 ± 0.041 kg: basic 4.010 ± 0.039 kg, and …`.
fn mass_in_words(case: &Case) -> String {
    let of = |basis| {
        let estimate = case.estimate(basis);
        format!("{} kg", with_error(estimate.properties.mass(), estimate.sd(0)))
    };
    let basic = of(Basis::Basic);
    if !case.grows() {
        return format!("Mass {basic}");
    }
    let whole = case.whole_statement();
    let allowance = whole.growth_allowance();
    format!(
        "Predicted mass {}: basic {basic}, plus a growth allowance of {} kg ({}{NO_BREAK}%)",
        of(Basis::Predicted),
        number(allowance, 4),
        number(100.0 * allowance / whole.basic, 3)
    )
}
