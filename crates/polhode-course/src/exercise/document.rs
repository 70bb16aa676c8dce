//! Documents of an exercise: the problem, and its solution.

use polhode_algebra::{Accent, Formula, RationalFunction};
use polhode_document::number::{DIGITS, NO_BREAK, number};
use polhode_document::{Document, Section};
use polhode_source::unit::{Dimension, measured, unit_of};

use super::prepared::PreparedQuestion;
use super::problem::Exercise;
use super::topic::{Form, Step};
use super::value::Value;

/// Unit of all tensors.
const INERTIA: &str = "kg·m²";

impl Exercise {
    /// Returns the problem, with the template of its answer file.
    pub fn problem(&self) -> Document {
        let mut problem = Section::new(1, "Problem");
        problem.say(self.prepared.topic.text);
        if self.is_symbolic {
            problem.say("Find formulas in these symbols, written as follows:");
            let symbols = &self.prepared.symbols;
            let written = self.prepared.given_symbols().map(|symbol| {
                let (printed, name) = (symbols.notation(symbol).to_text(), symbols.name(symbol));
                if printed == name { printed } else { format!("{printed}: {name}") }
            });
            lines(&mut problem, written);
        } else {
            lines(&mut problem, self.given());
        }
        let mut find = Section::new(2, "Find");
        let rows = self.questions().map(|(question, _)| {
            let row = [question.name(self.is_symbolic), &question.meaning(self.is_symbolic), ""];
            let mut row = row.map(str::to_owned).to_vec();
            row[2] = match (printed_unit(question.question.unit), self.is_symbolic) {
                (_, true) => "a formula".to_owned(),
                (unit, false) if unit.is_empty() => "none".to_owned(),
                (unit, false) => unit,
            };
            row
        });
        find.table(&["Name", "Quantity", "Unit"], rows.collect());
        find.say(if self.is_symbolic {
            "Write products with *, powers with ^, sin(…) and cos(…), and pi for π. Every form of the right formula is accepted."
        } else {
            "Give three significant digits: the tolerance is 0.5 % of a number, or of the largest component. Other units of the same \
             dimension are accepted."
        });
        let mut file = Section::new(3, "Answer file");
        file.say("Replace each question mark, and grade the file with polhode exercise --answers FILE:");
        self.template().lines().filter(|line| !line.is_empty()).for_each(|line| file.line(line));
        let names: Vec<_> = self.questions().map(|(question, _)| question.name(self.is_symbolic)).collect();
        self.document("Exercise", vec![format!("Find {}", names.join(", "))], vec![problem, find, file])
    }

    /// Returns the solution.
    pub fn solution(&self) -> Document {
        let mut steps = Section::new(1, "Way to the solution");
        for step in &self.prepared.topic.steps {
            match step {
                Step::Say(text) => steps.say(text),
                Step::Show(name, text, unit) => self.show(&mut steps, name, text, unit),
            }
        }
        let converted: Vec<String> = self.converted().collect();
        if !converted.is_empty() {
            steps.say("In SI units:");
            lines(&mut steps, converted.into_iter());
        }
        let mut sections = vec![steps];
        for (question, (right, wrong)) in self.questions() {
            let number = sections.len() as u8 + 1;
            let name = question.name(self.is_symbolic);
            let mut section =
                Section::new(number, &format!("{name}: {}", question.meaning(self.is_symbolic)));
            self.formulas(&mut section, question);
            if let Value::Numbers(numbers) = right {
                result(&mut section, &self.letter(question), numbers, question);
            }
            for (value, why) in wrong {
                // Six formulas are not easier to compare than the reason.
                let is_long = self.is_symbolic && question.right.len() > 1;
                section.say(match is_long {
                    true => format!("A frequent mistake: {why}."),
                    false => format!("If you found {}: {why}.", self.shown(value, question)),
                });
            }
            sections.push(section);
        }
        let results = self.questions().map(|(question, (right, _))| {
            let name = question.name(self.is_symbolic);
            match self.is_symbolic && question.right.len() > 1 {
                true => format!("{name}: formulas of {} elements", question.right.len()),
                false => format!("{name} = {}", self.shown(right, question)),
            }
        });
        self.document("Solution", results.collect(), sections)
    }

    /// Returns the given quantities as lines.
    fn given(&self) -> impl Iterator<Item = String> {
        let stated = self.data.iter().filter(|given| !given.text.is_empty());
        stated.map(|given| match given.text.starts_with("cos") {
            true => given.text.clone(),
            false => {
                let (number, unit) = given.text.split_once(' ').unwrap_or((&given.text, ""));
                format!(
                    "{} = {}",
                    self.prepared.symbols.notation(given.symbol).to_text(),
                    quantity(number, unit)
                )
            }
        })
    }

    /// Returns the given quantities with other units in SI units.
    fn converted(&self) -> impl Iterator<Item = String> {
        self.data.iter().filter_map(|given| {
            let (_, dimension) = measured(&given.text).ok().filter(|(_, d)| *d != Dimension::NONE)?;
            let name = self.prepared.symbols.notation(given.symbol).to_text();
            let shown = quantity(&number(given.value, DIGITS), &dimension.unit().0);
            let is_other = printed_unit(unit_of(&given.text)) != dimension.unit().0;
            is_other.then(|| format!("{name} = {shown}"))
        })
    }

    fn document(&self, kind: &str, answer: Vec<String>, sections: Vec<Section>) -> Document {
        let topic = self.prepared.topic;
        let which = if self.is_symbolic { "in symbols".to_owned() } else { format!("seed {}", self.seed) };
        Document {
            title: format!("{kind}: {} ({}, {which})", topic.title, topic.name),
            verdict: None,
            answer,
            sections,
            findings: Vec::new(),
        }
    }

    /// Writes an intermediate result.
    fn show(&self, section: &mut Section, name: &str, text: &str, unit: &str) {
        let Ok(formula) = polhode_algebra::parse(text, &self.prepared.symbols) else { return };
        let typeset = Formula::named(name).equals(formula.to_formula(&self.prepared.symbols));
        section.formula(&typeset.to_text(), &typeset.to_latex());
        if let Some(value) = self.prepared.value(&formula, &self.data) {
            section.line(format!("{name} = {}", quantity(&number(value, DIGITS), unit)));
        }
    }

    /// Writes the right formulas, unless they contain hidden data.
    fn formulas(&self, section: &mut Section, question: &PreparedQuestion) {
        let given: Vec<_> = self.prepared.given_symbols().collect();
        let is_shown = |f: &RationalFunction| {
            f.symbols().all(|symbol| given.contains(&symbol) || self.prepared.symbols.name(symbol) == "π")
        };
        if question.question.form == Form::Axis || !question.right.iter().all(is_shown) {
            return;
        }
        let letter = self.letter(question);
        for (k, right) in question.right.iter().enumerate() {
            let left = match question.question.form {
                Form::Square(_) => letter.clone().squared(),
                Form::Tangent(_) => letter.clone().applied("tan"),
                Form::SquaredTangent(_) => {
                    letter.clone().applied("tan").grouped(polhode_algebra::Fence::Parentheses).squared()
                }
                Form::Plain | Form::Axis => self.component(&letter, question, k),
            };
            let formula = left.equals(right.to_formula(&self.prepared.symbols));
            section.formula(&formula.to_text(), &formula.to_latex());
        }
    }

    /// Returns the symbol of a question: ω̇ for `omega_dot`.
    fn letter(&self, question: &PreparedQuestion) -> Formula {
        let name = question.question.name;
        match name.strip_suffix("_dot") {
            Some(base) => Formula::named(base).accented(Accent::Dot),
            None => Formula::named(name),
        }
    }

    /// Returns the symbol of a component: along 1, 2, 3 in topics with principal moments.
    fn component(&self, letter: &Formula, question: &PreparedQuestion, k: usize) -> Formula {
        let index = match question.right.len() {
            1 => return letter.clone(),
            3 if self.prepared.symbols.find("I_1").is_some() => ["1", "2", "3"][k],
            3 => ["x", "y", "z"][k],
            _ => ["xx", "yy", "zz", "xy", "xz", "yz"][k],
        };
        letter.clone().index(Formula::Letter(index.to_owned(), polhode_algebra::Style::Italic))
    }

    /// Returns a value on one line.
    pub(super) fn shown(&self, value: &Value, question: &PreparedQuestion) -> String {
        let (values, unit) = match value {
            Value::Formulas(formulas) => {
                let text = |f: &RationalFunction| f.to_formula(&self.prepared.symbols).to_text();
                (formulas.iter().map(text).collect::<Vec<_>>(), "")
            }
            Value::Numbers(numbers) => {
                let text = |x: &f64| number(x / question.unit.0, DIGITS);
                (numbers.iter().map(text).collect(), question.question.unit)
            }
        };
        match &values[..] {
            [one] => quantity(one, unit),
            [_, _, _] => quantity(&format!("({})", values.join(", ")), unit),
            _ => {
                let elements = quantity(&format!("({})", values.join(", ")), unit);
                format!("{elements} [xx, yy, zz, xy, xz, yz]")
            }
        }
    }
}

/// Writes the right numbers.
fn result(section: &mut Section, letter: &Formula, numbers: &[f64], question: &PreparedQuestion) {
    let name = letter.to_text();
    let (factor, unit) = (question.unit.0, question.question.unit);
    match *numbers {
        [xx, yy, zz, xy, xz, yz] => {
            section.matrix(format!("{{{name}}}"), [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]], INERTIA);
        }
        [x] => section.line(format!("{name} = {}", quantity(&number(x / factor, DIGITS), unit))),
        _ => {
            let all: Vec<String> = numbers.iter().map(|x| number(x / factor, DIGITS)).collect();
            section.line(format!("{name} = {}", quantity(&format!("({})", all.join(", ")), unit)));
        }
    }
}

/// Writes items in lines of three.
fn lines(section: &mut Section, items: impl Iterator<Item = String>) {
    let items: Vec<String> = items.collect();
    items.chunks(3).for_each(|three| section.line(three.join(",  ")));
}

/// Returns a number with its unit.
fn quantity(number: &str, unit: &str) -> String {
    if unit.is_empty() { number.to_owned() } else { format!("{number}{NO_BREAK}{}", printed_unit(unit)) }
}

/// Returns a unit as documents print it: `kg·m²` for `kg m^2`.
fn printed_unit(unit: &str) -> String {
    [("^2", "²"), ("^3", "³"), ("^4", "⁴"), ("^6", "⁶"), (" ", "·")]
        .into_iter()
        .fold(unit.to_owned(), |text, (from, to)| text.replace(from, to))
}
