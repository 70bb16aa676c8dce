//! Exercises: problems, grades of answers, and solutions.

use std::path::Path;

use polhode_course::exercise::{Request, Solution, run};
use polhode_document::Report;
use polhode_scenario::report::page_blocks;
use polhode_source::Failure;
use polhode_source::files::Memory;
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

use crate::protocol::TextError;
use crate::refusal::{Refusal, RefusalKind};

/// Path of the answers in memory.
const FILE: &str = "answers.toml";

/// Heading of the answers in their file.
const HEADING: &str = "[answers]\n";

/// Request for an exercise.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct ExerciseRequest {
    /// Name of the topic, such as `box-about-corner`.
    pub topic: String,
    /// Seed of the numbers.
    pub seed: u64,
    /// True for the problem in symbols.
    pub symbols: bool,
    /// Answers to be graded, in the form of [`ExerciseAnswer::template`].
    pub answers: Option<String>,
    /// True to return the solution.
    pub solution: bool,
}

/// Exercise, with the grades of its answers and its solution if they are requested.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ExerciseAnswer {
    /// Problem as blocks of the page, the title first.
    pub problem: Value,
    /// Lines of the answer file after `[answers]`, with question marks.
    pub template: String,
    /// Name, grade and reason of each answer; null without answers, or if they have an error.
    pub grades: Value,
    /// Errors in the text of the answers.
    pub errors: Vec<TextError>,
    /// Solution as blocks of the page.
    pub solution: Option<Value>,
}

/// Returns the list of topics.
pub(crate) fn topics() -> Result<Value, Refusal> {
    let report = run(&Request::default(), &Memory::default()).map_err(|failure| refused(&failure))?;
    Ok(json!({ "topics": report.to_json()["topics"].take() }))
}

/// Makes an exercise, and grades answers to it.
pub(crate) fn answer(request: &ExerciseRequest) -> Result<ExerciseAnswer, Refusal> {
    let ExerciseRequest { topic, seed, symbols, answers, solution } = request;
    let asked =
        Request { topic: Some(topic.clone()), seed: Some(*seed), symbols: *symbols, ..Request::default() };
    let made = |request: &Request| run(request, &Memory::default()).map_err(|failure| refused(&failure));
    let exercise = made(&asked)?;
    let mut problem = exercise.to_document();
    problem.answer.clear();
    // The page has a field instead of the last section, the answer file.
    problem.sections.pop();
    let data = exercise.to_json();
    let file = data["answer_file"].as_str().unwrap_or_default();
    let (head, template) = file.split_once(HEADING).unwrap_or(("", file));
    let (mut grades, mut errors) = (Value::Null, Vec::new());
    if let Some(answers) = answers {
        let head = format!("{head}{HEADING}");
        match graded(&asked, &format!("{head}{answers}")) {
            Ok(found) => grades = found,
            Err(error) => errors.push(after(&head, error)),
        }
    }
    let solution = match solution {
        true => {
            Some(page_blocks(&made(&Request { solution: Some(Solution::Alone), ..asked })?.to_document()))
        }
        false => None,
    };
    Ok(ExerciseAnswer {
        problem: page_blocks(&problem),
        template: template.to_owned(),
        grades,
        errors,
        solution,
    })
}

/// Grades the text of an answer file.
fn graded(asked: &Request, text: &str) -> Result<Value, TextError> {
    let request = Request { answers: Some(FILE.into()), ..asked.clone() };
    let report = run(&request, &Memory::from([(FILE, text)]))
        .map_err(|failure| TextError::of_failure(&failure, Path::new(FILE), Some(text)))?;
    Ok(report.to_json()["grades"].take())
}

/// Moves an error to its place in the text after `head`, which is ASCII.
fn after(head: &str, error: TextError) -> TextError {
    let lines = head.matches('\n').count();
    let moved = |place: Option<usize>, by: usize| place.and_then(|place| place.checked_sub(by));
    TextError {
        from: moved(error.from, head.len()),
        to: moved(error.to, head.len()),
        line: moved(error.line, lines),
        ..error
    }
}

/// Returns the refusal of an exercise that does not exist. Advice is for the command.
fn refused(failure: &Failure) -> Refusal {
    Refusal::new(RefusalKind::NotFound, failure.message())
}
