//! Validation of lessons: the scenario must move at every step, and must have everything that the
//! steps name.

use std::io;
use std::ops::Range;
use std::path::{Path, PathBuf};

use polhode_scenario::read::Draft;
use polhode_scenario::report::explain_motion;
use polhode_source::FormatError;
use polhode_source::files::Files;
use toml::Spanned;

use super::LessonStep;
use super::error::LessonError;
use super::file::{File, Question, Step};
use crate::edit::edited;
use crate::motion::computed;
use crate::protocol::{self, Edit};
use crate::watch::Watch;

/// A lesson that can be shown.
#[derive(Debug)]
pub(super) struct Checked {
    pub(super) title: String,
    pub(super) summary: String,
    /// Path of the scenario, or the path that it would have.
    pub(super) path: PathBuf,
    pub(super) draft: Draft,
    pub(super) scenario: String,
    pub(super) steps: Vec<LessonStep>,
}

/// Text and path of a lesson, for error messages, and the conditions under which it is read.
#[derive(Clone, Copy)]
struct Source<'a> {
    path: &'a Path,
    text: &'a str,
    files: &'a dyn Files,
    watch: &'a dyn Watch,
}

/// A scenario and its place.
struct Scenario {
    path: PathBuf,
    text: String,
    /// Span of the key's value in the lesson, and the first byte of the text if the value is the
    /// text itself.
    span: Range<usize>,
    begins: Option<usize>,
}

/// Names in a scenario to which a step may refer.
struct Named {
    knobs: Vec<String>,
    headings: Vec<String>,
}

impl Checked {
    /// Reads a lesson. `is_file` is true for a file of its own, which may refer to files in its
    /// folder.
    pub(super) fn read(
        path: &Path,
        text: &str,
        is_file: bool,
        files: &dyn Files,
        watch: &dyn Watch,
    ) -> Result<Self, LessonError> {
        let source = Source { path, text, files, watch };
        let file = File::read(path, text)?;
        for said in [&file.title, &file.summary] {
            source.said(said)?;
        }
        let scenario = source.scenario(&file)?;
        let draft = match is_file {
            true => Draft::trusting(&scenario.path, &scenario.text),
            false => Draft::new(&scenario.path, []),
        };
        let own =
            source.moving(&draft, &scenario.text).map_err(|error| source.of_scenario(&scenario, &error))?;
        if file.steps.is_empty() {
            return Err(LessonError::whole(path, "a lesson has at least one [[step]]"));
        }
        let steps = file.steps.iter().map(|step| source.step(step, &scenario.text, &draft, &own));
        let steps = steps.collect::<Result<_, _>>()?;
        let (title, summary) = (file.title.into_inner(), file.summary.into_inner());
        Ok(Self { title, summary, path: scenario.path, draft, scenario: scenario.text, steps })
    }
}

impl Source<'_> {
    fn at(&self, span: &Range<usize>, message: impl Into<String>) -> LessonError {
        LessonError::at(self.path, self.text, span, message)
    }

    /// Returns a text that is not empty.
    fn said(&self, text: &Spanned<String>) -> Result<String, LessonError> {
        match text.as_ref().trim() {
            "" => Err(self.at(&text.span(), "this text is empty")),
            words => Ok(words.to_owned()),
        }
    }

    fn scenario(&self, file: &File) -> Result<Scenario, LessonError> {
        const RULE: &str = "a lesson has either `scenario`, the path of a file, or `scenario_text`";
        match (&file.scenario, &file.scenario_text) {
            (Some(name), None) => {
                let path = self.path.parent().unwrap_or(Path::new("")).join(name.as_ref());
                let text = self.files.open(&path).and_then(io::read_to_string).map_err(|error| {
                    self.at(&name.span(), format!("{:?} cannot be read: {error}", path.display().to_string()))
                        .hint("write the path of a scenario file relative to the lesson's folder")
                })?;
                Ok(Scenario { path, text, span: name.span(), begins: None })
            }
            (None, Some(written)) => {
                let (span, text) = (written.span(), written.as_ref().clone());
                // The text begins after ''' and the end of that line.
                let quotes = self
                    .text
                    .get(span.clone())
                    .map_or(0, |raw| raw.len() - raw.trim_start_matches(['\'', '"']).len());
                let line_end = |at: &usize| self.text[..*at].ends_with('\n') || *at == span.start + quotes;
                let begins = (0..3).map(|skip| span.start + quotes + skip);
                let mut begins = begins.filter(|at| self.text.is_char_boundary(*at)).filter(line_end);
                let begins = begins.rfind(|at| self.text[*at..].starts_with(&text));
                Ok(Scenario { path: self.path.to_owned(), text, span, begins })
            }
            (Some(_), Some(both)) => Err(self.at(&both.span(), RULE)),
            (None, None) => Err(LessonError::whole(self.path, RULE)
                .hint("scenario = \"top.toml\", or scenario_text = '''…''' with the scenario in it")),
        }
    }

    /// Makes an error of the scenario, in its own file or at its place in the lesson.
    fn of_scenario(&self, scenario: &Scenario, error: &Unmoved) -> LessonError {
        let Unmoved { message, hint, place } = error;
        let message = format!("the scenario: {message}");
        let error = match (place, scenario.begins) {
            (Some(place), Some(begins)) if scenario.path == self.path => {
                self.at(&(begins + place.start..begins + place.end), message)
            }
            (Some(place), _) if scenario.path != self.path => {
                LessonError::at(&scenario.path, &scenario.text, place, message)
            }
            _ => self.at(&scenario.span, message),
        };
        LessonError { hint: hint.clone(), ..error }
    }

    fn step(
        &self,
        step: &Spanned<Step>,
        scenario: &str,
        draft: &Draft,
        own: &Named,
    ) -> Result<LessonStep, LessonError> {
        let written = step.as_ref();
        let mut text = scenario.to_owned();
        for set in &written.set {
            let raw = self.text.get(set.as_ref().value.span()).unwrap_or_default();
            let edit = Edit::Set { set: set.as_ref().key.clone(), value: Some(raw.to_owned()) };
            let mut reader = draft.clone();
            text = edited(&text, &[edit], |text| reader.read(self.files, text.to_owned()).ok()).map_err(|error| {
                self.at(&set.span(), format!("the value cannot be set: {error}"))
                    .hint("key = \"body.part[0].size[2]\", value = \"4 mm\": write the value as in a scenario, on one line")
            })?;
        }
        let changed;
        let named = match written.set.last() {
            None => own,
            Some(last) => {
                changed = self.moving(draft, &text).map_err(|Unmoved { message, hint, .. }| LessonError {
                    hint,
                    ..self.at(&last.span(), format!("the scenario with the values of this step: {message}"))
                })?;
                &changed
            }
        };
        for knob in &written.knobs {
            if !named.knobs.contains(knob.as_ref()) {
                return Err(self
                    .at(&knob.span(), format!("the scenario has no number {:?}", knob.as_ref()))
                    .hint(format!("one of {}", named.knobs.join(", "))));
            }
        }
        if let Some(working) = &written.working {
            let begins = |heading: &String| heading.starts_with(working.as_ref().as_str());
            if working.as_ref().is_empty() || !named.headings.iter().any(begins) {
                return Err(self
                    .at(
                        &working.span(),
                        format!("no heading of the worked solution begins with {:?}", working.as_ref()),
                    )
                    .hint(format!("known headings: {}", named.headings.join("; "))));
            }
        }
        Ok(LessonStep {
            text: self.said(&written.text)?,
            question: written.question.as_ref().map(|question| self.question(question)).transpose()?,
            knobs: written.knobs.iter().map(|knob| knob.as_ref().clone()).collect(),
            scenario: text,
            working: written.working.as_ref().map(|working| working.as_ref().clone()),
        })
    }

    fn question(&self, question: &Question) -> Result<protocol::Question, LessonError> {
        let answers = question.answers.as_ref();
        if !(2..=5).contains(&answers.len()) {
            let rule = format!("a question has 2 to 5 answers, not {}", answers.len());
            return Err(self.at(&question.answers.span(), rule));
        }
        let right = *question.right.as_ref();
        if !(1..=answers.len()).contains(&right) {
            let rule = format!("the right answer must be from 1 to {}, not {right}", answers.len());
            return Err(self.at(&question.right.span(), rule).hint("answers are counted from 1"));
        }
        Ok(protocol::Question {
            text: self.said(&question.text)?,
            answers: answers.iter().map(|answer| self.said(answer)).collect::<Result<_, _>>()?,
            right: right - 1,
            why: self.said(&question.why)?,
        })
    }

    /// Computes a motion, and lists the names to which steps may refer.
    fn moving(&self, draft: &Draft, text: &str) -> Result<Named, Unmoved> {
        let mut draft = draft.clone();
        let unread = |error: FormatError| {
            let own = error.path() == draft.path();
            Unmoved {
                message: if own { error.message() } else { error.to_string() },
                hint: error.hint(),
                place: error.place().filter(|_| own).map(|place| place.span.clone()),
            }
        };
        let mut reader = draft.clone();
        let file = reader.read(self.files, text.to_owned()).map_err(unread)?;
        draft = reader;
        self.watch.restart();
        let trajectory = computed(&file, false, self.watch).map_err(|error| Unmoved {
            message: error.message,
            hint: error.hint,
            place: None,
        })?;
        let solution = explain_motion(&file.scenario, &trajectory, &file.exact())
            .map_err(|error| Unmoved { message: error.to_string(), hint: None, place: None })?;
        let headings =
            solution.sections.iter().map(|section| format!("{}. {}", section.number, section.title));
        let knobs = draft.numbers().into_iter().map(|number| number.key);
        Ok(Named { knobs: knobs.collect(), headings: headings.collect() })
    }
}

/// Reason why a scenario has no motion; the place is in its text.
struct Unmoved {
    message: String,
    hint: Option<String>,
    place: Option<Range<usize>>,
}
