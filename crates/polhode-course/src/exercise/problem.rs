//! Exercises of a topic.

use std::sync::Arc;

use super::prepared::{Given, Prepared, PreparedQuestion, Values};
use super::topic::TOPICS;

/// Exercises of one topic.
#[derive(Clone, Debug)]
pub struct Exercises(Arc<Prepared>);

/// Problem with its solution.
#[derive(Clone, Debug)]
pub struct Exercise {
    pub(super) prepared: Arc<Prepared>,
    pub(super) seed: u64,
    pub(super) is_symbolic: bool,
    /// Given quantities; empty for a problem in symbols.
    pub(super) data: Vec<Given>,
    /// Right and wrong values in the order of the questions.
    pub(super) values: Vec<Values>,
}

/// Returns the names of all topics.
pub fn topics() -> impl Iterator<Item = &'static str> {
    TOPICS.iter().map(|topic| topic.name)
}

impl Exercises {
    /// Returns the exercises of a topic; `None` for an unknown name.
    pub fn of(topic: &str) -> Option<Self> {
        let topic = TOPICS.iter().find(|other| other.name == topic)?;
        Prepared::new(topic).map(|prepared| Self(Arc::new(prepared)))
    }

    /// Returns the name of the topic.
    pub fn name(&self) -> &'static str {
        self.0.topic.name
    }

    /// Returns the title of the topic.
    pub fn title(&self) -> &'static str {
        self.0.topic.title
    }

    /// Returns true if the answers are formulas in the given symbols, so that [`Self::in_symbols`]
    /// has a problem.
    pub fn has_symbols(&self) -> bool {
        self.0.has_symbols()
    }

    /// Returns the problem of a seed, with numbers. It is the same on every machine and in every
    /// version.
    pub fn with_seed(&self, seed: u64) -> Option<Exercise> {
        let (data, values) = self.0.draw(seed)?;
        Some(Exercise { prepared: self.0.clone(), seed, is_symbolic: false, data, values })
    }

    /// Returns the problem in symbols; `None` if the answers are not formulas in the given symbols.
    pub fn in_symbols(&self, seed: u64) -> Option<Exercise> {
        let values = self.0.has_symbols().then(|| self.0.formulas())?;
        Some(Exercise { prepared: self.0.clone(), seed, is_symbolic: true, data: Vec::new(), values })
    }
}

impl Exercise {
    /// Returns the questions with their right and wrong values.
    pub(super) fn questions(&self) -> impl Iterator<Item = (&PreparedQuestion, &Values)> {
        self.prepared.questions.iter().zip(&self.values)
    }

    /// Returns the unit of a question as it is written in an answer file; empty for formulas.
    pub(super) fn unit_of(&self, question: &PreparedQuestion) -> &'static str {
        if self.is_symbolic { "" } else { question.question.unit }
    }

    /// Returns the template of the answer file.
    pub fn template(&self) -> String {
        let name = self.prepared.topic.name;
        let symbols = if self.is_symbolic { "symbols = true\n" } else { "" };
        let mut text = format!("topic = \"{name}\"\nseed = {}\n{symbols}\n[answers]\n", self.seed);
        for (question, _) in self.questions() {
            let unit = self.unit_of(question);
            let blank = if unit.is_empty() { "\"?\"".to_owned() } else { format!("\"? {unit}\"") };
            let row = format!("[{}]", [blank.as_str(); 3].join(", "));
            let value = match question.right.len() {
                1 => blank,
                3 => row,
                _ => format!("[\n{}]", format!("  {row},\n").repeat(3)),
            };
            text.push_str(&format!("{} = {value}\n", question.name(self.is_symbolic)));
        }
        text
    }
}
