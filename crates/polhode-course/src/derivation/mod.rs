//! Derivations of the results of the lecture notes.
//!
//! A derivation is a list of steps. Each formula is stated once, in a [notation], and its tree is
//! printed as text and as LaTeX. A formula that is an identity is also evaluated, with generic
//! components, under the definitions of the steps before it ([`Derivation::sides`]).

mod notation;
mod scope;
mod step;
mod topic;
mod value;

use std::fmt;
use std::str::FromStr;

use polhode_document::{Document, Section};
use polhode_source::nearest;

pub use scope::EvaluationError;
pub use step::{Ground, Step};
pub use value::Value;

use scope::Scope;

/// Derivation of a result of the lecture notes.
#[derive(Debug, PartialEq, Eq)]
pub struct Derivation {
    /// Name for the command line, such as `euler-equations`.
    pub name: &'static str,
    /// Title, such as `Euler's equations`.
    pub title: &'static str,
    steps: &'static [Step],
}

/// Name that no derivation has.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownDerivation {
    /// Name that was given.
    pub name: String,
}

/// Returns all derivations in the order of the lecture notes.
pub const fn all() -> &'static [Derivation] {
    topic::ALL
}

/// Returns the derivation with a name.
pub fn find(name: &str) -> Option<&'static Derivation> {
    all().iter().find(|derivation| derivation.name == name)
}

/// Returns a document with the names and titles of all derivations.
pub fn list() -> Document {
    let mut section = Section::new(0, "Topics");
    let row = |derivation: &Derivation| vec![derivation.name.to_owned(), derivation.title.to_owned()];
    section.table(&["topic", "derivation"], all().iter().map(row).collect());
    section.say(
        "Every equation of a derivation is checked by exact algebra, with three particles and generic \
         components, unless it is a definition, a hypothesis, a law, a theorem or a limit.",
    );
    document("Derivations of the lecture notes", Vec::new(), vec![section])
}

impl Derivation {
    /// Returns the steps in order.
    pub const fn steps(&self) -> &'static [Step] {
        self.steps
    }

    /// Returns the derivation as a document; its answer is the result.
    pub fn document(&self) -> Document {
        let (mut answer, mut sections) = (Vec::new(), Vec::new());
        for step in self.steps {
            if let Step::Part(title) = step {
                sections.push(Section::new(sections.len() as u8 + 1, title));
            }
            let Some(section) = sections.last_mut() else { continue };
            match step {
                Step::Part(_) | Step::Setting(_) => {}
                Step::Remark(text) => section.say(text),
                Step::Formula { text, notation, ground } => {
                    section.say(text);
                    let Some(formula) = notation::read(notation) else { continue };
                    section.formula(&formula.to_text(), &formula.to_latex());
                    if *ground == Ground::Result {
                        answer.extend(formula.to_text().lines().map(|line| line.trim().to_owned()));
                    }
                }
            }
        }
        document(self.title, answer, sections)
    }

    /// Returns true if all equations of a formula hold under the definitions of the first steps,
    /// with generic components; `steps` is the number of these steps.
    ///
    /// # Errors
    /// [`EvaluationError`] if the text is not a formula, or not an equation with a value.
    pub fn holds(&self, notation: &str, steps: usize) -> Result<bool, EvaluationError> {
        let (sides, scope) = self.evaluated(notation, steps)?;
        Ok(sides.into_iter().all(|sides| scope.are_equal(sides)))
    }

    /// Returns both sides of each equation of a formula under the definitions of the first steps.
    ///
    /// # Errors
    /// [`EvaluationError`] if the text is not a formula, or not an equation with a value.
    pub fn sides(&self, notation: &str, steps: usize) -> Result<Vec<[Value; 2]>, EvaluationError> {
        Ok(self.evaluated(notation, steps)?.0)
    }

    fn evaluated(&self, notation: &str, steps: usize) -> Result<(Vec<[Value; 2]>, Scope), EvaluationError> {
        let read =
            |text: &str| notation::read(text).ok_or_else(|| EvaluationError::Notation(text.to_owned()));
        let mut scope = Scope::default();
        for step in self.steps.iter().take(steps) {
            match step {
                Step::Setting(notation) => scope.define(&read(notation)?),
                Step::Formula { notation, ground, .. } if ground.defines() => scope.define(&read(notation)?),
                _ => {}
            }
        }
        let sides = scope.sides(&read(notation)?)?;
        Ok((sides, scope))
    }
}

fn document(title: &str, answer: Vec<String>, sections: Vec<Section>) -> Document {
    Document { title: title.to_owned(), verdict: None, answer, sections, findings: Vec::new() }
}

impl FromStr for &'static Derivation {
    type Err = UnknownDerivation;

    fn from_str(name: &str) -> Result<Self, UnknownDerivation> {
        find(name).ok_or_else(|| UnknownDerivation { name: name.to_owned() })
    }
}

impl fmt::Display for UnknownDerivation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let names = || all().iter().map(|derivation| derivation.name);
        let contains =
            |name: &&str| name.split('-').any(|word| !self.name.is_empty() && self.name.contains(word));
        let mut near: Vec<&str> = nearest(&self.name, names()).into_iter().collect();
        if near.is_empty() {
            near = names().filter(contains).collect();
        }
        write!(f, "unknown derivation `{}`; ", self.name.escape_debug())?;
        match near[..] {
            [] => write!(f, "the derivations are {}", names().collect::<Vec<_>>().join(", ")),
            _ => write!(f, "did you mean `{}`?", near.join("` or `")),
        }
    }
}

impl std::error::Error for UnknownDerivation {}
