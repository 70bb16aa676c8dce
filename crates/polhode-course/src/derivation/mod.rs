//! Derivations of the results of the lecture notes.
//!
//! A derivation is a list of steps in `derivations.txt`. Each formula is stated there once, in a
//! [notation], and its tree is printed as text and as LaTeX. The tests evaluate the same tree.

pub mod notation;
mod step;

use std::fmt;
use std::slice;
use std::str::FromStr;
use std::sync::LazyLock;

use polhode_algebra::Formula;
use polhode_document::{Document, Section};
use polhode_source::nearest;

pub use step::{Ground, Step};

static ALL: LazyLock<Vec<Derivation>> = LazyLock::new(|| read(include_str!("derivations.txt")));

/// Derivation of a result of the lecture notes.
#[derive(Debug, PartialEq, Eq)]
pub struct Derivation {
    /// Name for the command line, such as `euler-equations`.
    pub name: &'static str,
    /// Title, such as `Euler's equations`.
    pub title: &'static str,
    steps: Vec<Step>,
}

/// Name that no derivation has.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownDerivation {
    /// Name that was given.
    pub name: String,
}

/// Returns all derivations in the order of the lecture notes.
pub fn all() -> &'static [Derivation] {
    &ALL
}

/// Returns the derivation with a name.
pub fn find(name: &str) -> Option<&'static Derivation> {
    all().iter().find(|derivation| derivation.name == name)
}

/// Returns a document with the names and titles of all derivations.
pub fn list() -> Document {
    let mut section = Section::new(1, "Topics");
    let row = |derivation: &Derivation| vec![derivation.name.to_owned(), derivation.title.to_owned()];
    section.table(&["topic", "derivation"], all().iter().map(row).collect());
    section.say(
        "Every equation that is an identity is checked by exact algebra, with three particles and generic \
         components. The others are definitions, hypotheses, laws, theorems and limits.",
    );
    document("Derivations of the lecture notes", Vec::new(), vec![section])
}

impl Derivation {
    /// Returns the steps in order.
    pub fn steps(&self) -> &[Step] {
        &self.steps
    }

    /// Returns the derivation as a document; the answer is its results.
    pub fn document(&self) -> Document {
        let (mut answer, mut sections) = (Vec::new(), Vec::new());
        for step in &self.steps {
            if let Step::Part(title) = step {
                sections.push(Section::new(sections.len() as u8 + 1, title));
            }
            let Some(section) = sections.last_mut() else { continue };
            if let Step::Remark(text) | Step::Formula { text, .. } = step {
                section.say(text.replace('\n', " "));
            }
            let Some(formula) = step.formula() else { continue };
            let [text, latex] = written(&formula);
            section.formula(&text, &latex);
            if matches!(step, Step::Formula { is_result: true, .. }) {
                answer.extend(text.lines().map(|line| line.trim().to_owned()));
            }
        }
        document(self.title, answer, sections)
    }
}

/// Reads derivations: `# name: title`, then the paragraphs of the steps.
fn read(text: &'static str) -> Vec<Derivation> {
    let mut all: Vec<Derivation> = Vec::new();
    for paragraph in text.split("\n\n").map(str::trim_end) {
        if let Some((name, title)) = paragraph.strip_prefix("# ").and_then(|head| head.split_once(": ")) {
            all.push(Derivation { name, title, steps: Vec::new() });
        } else if let Some(derivation) = all.last_mut() {
            derivation.steps.push(Step::read(paragraph));
        }
    }
    all
}

/// Returns a formula as text and as LaTeX, with wide space between the equations of a list.
fn written(formula: &Formula) -> [String; 2] {
    let equations =
        if let Formula::List(equations) = formula { &equations[..] } else { slice::from_ref(formula) };
    let joined = |write: fn(&Formula) -> String, separator| {
        equations.iter().map(write).collect::<Vec<_>>().join(separator)
    };
    [joined(Formula::to_text, ",   "), joined(Formula::to_latex, r", \qquad ")]
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

impl UnknownDerivation {
    /// Returns the name that was probably meant, or the names that have a word in common with this one.
    pub fn suggestions(&self) -> Vec<&'static str> {
        let names = all().iter().map(|derivation| derivation.name);
        if let Some(name) = nearest(&self.name, names.clone()) {
            return vec![name];
        }
        let is_alike =
            |a: &str| self.name.split(['-', '_', ' ']).any(|b| b.len() > 3 && nearest(b, [a]).is_some());
        names.filter(|name| name.split('-').any(is_alike)).collect()
    }
}

impl fmt::Display for UnknownDerivation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "unknown derivation `{}`; ", self.name.escape_debug())?;
        match &self.suggestions()[..] {
            [] => {
                let names: Vec<&str> = all().iter().map(|derivation| derivation.name).collect();
                write!(f, "the derivations are {}", names.join(", "))
            }
            near => write!(f, "did you mean `{}`?", near.join("` or `")),
        }
    }
}

impl std::error::Error for UnknownDerivation {}
