//! Reader of answer files.

use std::path::Path;

use polhode_algebra::{ParseError, RationalFunction, Symbols, parse};
use polhode_source::files::Files;
use polhode_source::toml::reader::{Table, Value as Entry};
use polhode_source::toml::source::Source;
use polhode_source::toml::{document, text_of};
use polhode_source::unit::{self, Dimension};
use polhode_source::{Failure, FormatError, FormatErrorKind};

use super::problem::{Exercise, Exercises, topics};
use super::request::Request;

/// Answer of a student.
#[derive(Clone, Debug)]
pub(super) enum Answer {
    /// No answer, or a question mark of the template.
    Missing,
    /// Numbers in SI units with their dimensions: one, three, or nine by row.
    Numbers(Vec<(f64, Dimension)>),
    /// Formulas in the given symbols.
    Formulas(Vec<RationalFunction>),
    /// Quantity with a unit in place of a formula.
    NoFormula,
}

/// Reads an answer file, and returns the exercise that it names with the answer to each question.
pub(super) fn read(
    request: &Request,
    path: &Path,
    files: &dyn Files,
) -> Result<(Exercise, Vec<Answer>), Failure> {
    let text = text_of(files, path)?;
    let source = Source::new(files, path, &text);
    let entries = document(source)?;
    let file = Table::root(source, &entries);
    file.allow(&["topic", "seed", "symbols", "answers"])?;
    let exercise = exercise_of(request, &file)?;
    let table = file.require("answers", "[answers]")?.table()?;
    let names: Vec<&'static str> =
        exercise.questions().map(|(question, _)| question.name(exercise.is_symbolic)).collect();
    table.allow(&names)?;
    let answer = |(name, (question, _)): (&&'static str, _)| -> Result<Answer, FormatError> {
        let question: &super::prepared::PreparedQuestion = question;
        let Some(entry) = table.get(name) else { return Ok(Answer::Missing) };
        let elements = match question.right.len() {
            1 => vec![entry],
            3 => entry.fixed::<3>("components")?.to_vec(),
            _ => entry.rows::<3, 3>()?.concat(),
        };
        read_elements(&elements, &exercise)
    };
    let answers = names.iter().zip(exercise.questions()).map(answer).collect::<Result<_, _>>()?;
    Ok((exercise, answers))
}

/// Returns the exercise that the file names, which must be the requested one.
fn exercise_of(request: &Request, file: &Table<'_>) -> Result<Exercise, Failure> {
    let names: Vec<&'static str> = topics().collect();
    let topic = file.require("topic", "topic = \"box-about-corner\"")?;
    let name = topic.choice(&names)?;
    if let Some(asked) = request.topic.as_ref().filter(|asked| *asked != name) {
        return Err(topic.invalid(format!("\"{asked}\", the requested topic")).into());
    }
    let seed = file.require("seed", "seed = 1")?;
    let number = seed.count()?;
    if let Some(asked) = request.seed.filter(|asked| *asked != number) {
        return Err(seed.invalid(format!("{asked}, the requested seed")).into());
    }
    let symbols = file.get("symbols");
    let is_symbolic = symbols.map_or(Ok(false), |value| value.boolean())?;
    if request.symbols && !is_symbolic {
        let hint = Some("leave out --symbols, or answer the template of the problem in symbols".to_owned());
        let message =
            "the file answers the problem in numbers, and the problem in symbols is requested".to_owned();
        return Err(file.error(FormatErrorKind::Subject { message, hint }).into());
    }
    let exercises = Exercises::of(name).ok_or_else(|| defect(name))?;
    match (symbols, is_symbolic) {
        (Some(value), true) if !exercises.has_symbols() => {
            Err(value.invalid("false: this topic has no problem in symbols").into())
        }
        (_, true) => exercises.in_symbols(number).ok_or_else(|| defect(name)),
        (_, false) => exercises.with_seed(number).ok_or_else(|| defect(name)),
    }
}

/// Returns the failure of a topic whose formulas are not valid, which tests exclude.
pub(super) fn defect(topic: &str) -> Failure {
    Failure::usage(
        format!("the topic {topic} has no exercise for this seed"),
        "report this defect, and try another seed",
    )
}

fn read_elements(elements: &[Entry<'_>], exercise: &Exercise) -> Result<Answer, FormatError> {
    let is_blank = |entry: &Entry<'_>| entry.string().is_ok_and(|text| text.trim_start().starts_with('?'));
    if elements.iter().any(is_blank) {
        return Ok(Answer::Missing);
    }
    if !exercise.is_symbolic {
        return elements.iter().map(Entry::any_quantity).collect::<Result<_, _>>().map(Answer::Numbers);
    }
    let mut formulas = Vec::new();
    for entry in elements {
        let text = entry.string()?;
        if unit::measured(text).is_ok_and(|(_, dimension)| dimension != Dimension::NONE) {
            return Ok(Answer::NoFormula);
        }
        formulas.push(formula(entry, text, &exercise.prepared.stated)?);
    }
    Ok(Answer::Formulas(formulas))
}

/// Reads a formula; an error is at its place in the text.
fn formula(entry: &Entry<'_>, text: &str, symbols: &Symbols) -> Result<RationalFunction, FormatError> {
    parse(&with_pi(text), symbols).map_err(|error| {
        let kind = FormatErrorKind::Subject { message: error.kind.to_string(), hint: error.hint() };
        let source = entry.source();
        let (mut span, raw) = (entry.span(), source.text.get(entry.span()).unwrap_or_default());
        if let Some(start) = raw.find(text).filter(|_| !text.is_empty()) {
            let at = offset(text, &error);
            span = span.start + start + at..span.start + start + text.len();
        }
        source.error(span, kind)
    })
}

/// Returns the byte at which an error is.
fn offset(text: &str, error: &ParseError) -> usize {
    text.char_indices().nth(error.column.saturating_sub(1)).map_or(text.len(), |(at, _)| at)
}

/// Returns a formula with π for the word `pi`, with the same number of characters.
fn with_pi(text: &str) -> String {
    let is_part = |c: char| c.is_alphanumeric() || c == '_';
    let letters: Vec<char> = text.chars().collect();
    let mut out = letters.clone();
    for k in 0..letters.len().saturating_sub(1) {
        let is_word = letters[k..k + 2] == ['p', 'i']
            && !k.checked_sub(1).is_some_and(|before| is_part(letters[before]))
            && !letters.get(k + 2).is_some_and(|&after| is_part(after));
        if is_word {
            (out[k], out[k + 1]) = (' ', 'π');
        }
    }
    out.into_iter().collect()
}
