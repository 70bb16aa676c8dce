//! Execution of a request.

use polhode_source::files::Files;
use polhode_source::{Failure, nearest};

use super::answers::{defect, read};
use super::problem::{Exercises, topics};
use super::report::ExerciseReport;
use super::request::Request;

/// Lists the topics, makes an exercise, or grades the answers to one.
///
/// # Errors
/// [`Failure`] for an unknown topic, a topic without a problem in symbols if that is requested, and
/// an answer file that cannot be read, or belongs to another exercise.
pub fn run(request: &Request, files: &dyn Files) -> Result<ExerciseReport, Failure> {
    if let Some(topic) = request.topic.as_ref().filter(|topic| !topics().any(|known| known == **topic)) {
        let near = nearest(topic, topics()).map(|near| format!("did you mean {near}? "));
        let hint = format!("{}all topics are listed without this argument", near.unwrap_or_default());
        return Err(Failure::usage(format!("unknown topic {topic:?}"), hint));
    }
    if let Some(path) = &request.answers {
        let (exercise, answers) = read(request, path, files)?;
        let grades = exercise.graded(&answers);
        return Ok(ExerciseReport::Graded { exercise, grades, has_solution: request.solution.is_some() });
    }
    let Some(topic) = &request.topic else {
        let unused = [
            (request.seed.is_some(), "--seed"),
            (request.symbols, "--symbols"),
            (request.solution.is_some(), "--solution"),
        ];
        return match unused.iter().find(|(is_given, _)| *is_given) {
            Some((_, option)) => Err(Failure::usage(
                format!("{option} requires a topic"),
                "all topics are listed without options",
            )),
            None => topics()
                .map(|topic| Exercises::of(topic).ok_or_else(|| defect(topic)))
                .collect::<Result<_, _>>()
                .map(ExerciseReport::Topics),
        };
    };
    let exercises = Exercises::of(topic).ok_or_else(|| defect(topic))?;
    let seed = request.seed.unwrap_or(1);
    if request.symbols && !exercises.has_symbols() {
        return Err(Failure::usage(
            format!("the topic {topic} has no problem in symbols: its answers are numbers"),
            "leave out --symbols",
        ));
    }
    let exercise = if request.symbols { exercises.in_symbols(seed) } else { exercises.with_seed(seed) };
    let exercise = exercise.ok_or_else(|| defect(topic))?;
    Ok(ExerciseReport::Exercise { exercise, solution: request.solution })
}
