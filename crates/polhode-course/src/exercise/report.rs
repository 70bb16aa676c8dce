//! Result of a request.

use polhode_document::{Document, Level, Report, Section, VERSION, Verdict};
use serde_json::{Value as Json, json};

use super::grade::Grade;
use super::problem::{Exercise, Exercises};
use super::request::Solution;
use super::value::Value;

/// JSON schema of the data of an [`ExerciseReport`].
pub const REPORT_SCHEMA: &str = include_str!("../../schema/exercise-report.json");

/// Result of a [`Request`](super::Request).
#[derive(Clone, Debug)]
pub enum ExerciseReport {
    /// Topics in the order of the chapter.
    Topics(Vec<Exercises>),
    /// Exercise, and the place of its solution if that is requested.
    Exercise {
        /// Problem with its solution.
        exercise: Exercise,
        /// Place of the solution.
        solution: Option<Solution>,
    },
    /// Grades of the answers to an exercise.
    Graded {
        /// Problem with its solution.
        exercise: Exercise,
        /// Grades in the order of the questions.
        grades: Vec<Grade>,
        /// True if the solution is requested.
        has_solution: bool,
    },
}

impl Report for ExerciseReport {
    fn to_json(&self) -> Json {
        match self {
            Self::Topics(topics) => {
                let topic = |t: &Exercises| json!({ "topic": t.name(), "title": t.title(), "symbols": t.has_symbols() });
                json!({ "polhode": VERSION, "topics": topics.iter().map(topic).collect::<Json>() })
            }
            Self::Exercise { exercise, solution } => exercise_json(exercise, solution.is_some(), None),
            Self::Graded { exercise, grades, has_solution } => {
                exercise_json(exercise, *has_solution, Some(grades))
            }
        }
    }

    fn to_document(&self) -> Document {
        match self {
            Self::Topics(topics) => listed(topics),
            Self::Exercise { exercise, solution: None } => exercise.problem(),
            Self::Exercise { exercise, solution: Some(Solution::Alone) } => exercise.solution(),
            Self::Exercise { exercise, solution: Some(Solution::After) } => {
                followed(exercise.problem(), exercise.solution())
            }
            Self::Graded { exercise, grades, has_solution } => {
                let card = card(exercise, grades);
                if *has_solution { followed(card, exercise.solution()) } else { card }
            }
        }
    }

    fn has_failed(&self) -> bool {
        matches!(self, Self::Graded { grades, .. } if grades.iter().any(|grade| *grade != Grade::Right))
    }
}

fn listed(topics: &[Exercises]) -> Document {
    let mut section = Section::new(1, "Topics");
    let rows = topics.iter().map(|topic| {
        let symbols = if topic.has_symbols() { "numbers, symbols" } else { "numbers" };
        [topic.name(), topic.title(), symbols].map(str::to_owned).to_vec()
    });
    section.table(&["Topic", "Title", "Problems in"], rows.collect());
    Document {
        title: "Exercises on rigid bodies".to_owned(),
        verdict: None,
        answer: vec![format!("{} topics: polhode exercise TOPIC --seed N", topics.len())],
        sections: vec![section],
        findings: Vec::new(),
    }
}

/// Returns a document with the sections of another one at its end.
fn followed(mut first: Document, second: Document) -> Document {
    let count = first.sections.len() as u8;
    first.sections.extend(second.sections.into_iter().map(|mut section| {
        section.number += count;
        section
    }));
    first
}

/// Returns the document of the grades.
fn card(exercise: &Exercise, grades: &[Grade]) -> Document {
    let right = grades.iter().filter(|grade| **grade == Grade::Right).count();
    let line = match (right, grades.len()) {
        (1, 1) => "The answer is right".to_owned(),
        (all, count) if all == count => format!("All {count} answers are right"),
        (right, count) => {
            format!("{right} of {count} answers {} right", if right == 1 { "is" } else { "are" })
        }
    };
    let level = if right == grades.len() { Level::Ok } else { Level::Failure };
    let mut section = Section::new(1, "Grades");
    let rows = exercise.questions().zip(grades).map(|((question, _), grade)| {
        let [word, reason] = words(grade);
        vec![question.name(exercise.is_symbolic).to_owned(), word.to_owned(), reason.to_owned()]
    });
    section.table(&["Answer", "Grade", "Reason"], rows.collect());
    let topic = exercise.prepared.topic;
    Document {
        title: format!("Grades: {} ({}, seed {})", topic.title, topic.name, exercise.seed),
        verdict: Some(Verdict::new(level, line.clone())),
        answer: vec![line],
        sections: vec![section],
        findings: Vec::new(),
    }
}

/// Returns a grade and its reason in words.
fn words(grade: &Grade) -> [&str; 2] {
    match grade {
        Grade::Right => ["right", ""],
        Grade::Wrong(reason) => {
            ["wrong", reason.as_deref().unwrap_or("no frequent mistake gives this value")]
        }
        Grade::WrongUnit(reason) => ["wrong unit", reason],
        Grade::Missing => ["missing", ""],
    }
}

fn exercise_json(exercise: &Exercise, has_solution: bool, grades: Option<&Vec<Grade>>) -> Json {
    let symbols = &exercise.prepared.symbols;
    let data = exercise.data.iter().filter(|given| !given.text.is_empty()).map(
        |given| json!({ "symbol": symbols.name(given.symbol), "text": given.text, "value": given.value }),
    );
    let questions = exercise.questions().map(|(question, _)| {
        let kind = match (exercise.is_symbolic, question.right.len()) {
            (true, _) => "formula",
            (_, 1) => "number",
            (_, 3) => "vector",
            _ => "matrix",
        };
        json!({
            "name": question.name(exercise.is_symbolic),
            "is": question.meaning(exercise.is_symbolic),
            "kind": kind,
            "unit": exercise.unit_of(question),
        })
    });
    let solution = exercise.questions().map(|(question, (right, wrong))| {
        let value = |value: &Value| match value {
            Value::Numbers(numbers) => json!(numbers),
            Value::Formulas(formulas) => {
                formulas.iter().map(|f| Json::from(f.to_formula(symbols).to_text())).collect()
            }
        };
        json!({
            "name": question.name(exercise.is_symbolic),
            "value": value(right),
            "text": exercise.shown(right, question),
            "mistakes": wrong.iter().map(|(wrong, why)| json!({ "value": value(wrong), "reason": why })).collect::<Json>(),
        })
    });
    let graded = grades.map(|grades| {
        let grade = |(question, grade): (&super::prepared::PreparedQuestion, &Grade)| {
            let [word, reason] = words(grade);
            json!({ "name": question.name(exercise.is_symbolic), "grade": word, "reason": reason })
        };
        exercise.questions().map(|(question, _)| question).zip(grades).map(grade).collect::<Json>()
    });
    json!({
        "polhode": VERSION,
        "topic": exercise.prepared.topic.name,
        "title": exercise.prepared.topic.title,
        "seed": exercise.seed,
        "symbols": exercise.is_symbolic,
        "problem": exercise.prepared.topic.text,
        "data": data.collect::<Json>(),
        "questions": questions.collect::<Json>(),
        "answer_file": exercise.template(),
        "solution": has_solution.then(|| solution.collect::<Json>()),
        "grades": graded,
    })
}
