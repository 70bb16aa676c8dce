//! Grades of answers, with the likeliest mistakes.

use core::f64::consts::PI;

use polhode_algebra::RationalFunction;
use polhode_source::unit::Dimension;

use super::answers::Answer;
use super::prepared::{PreparedQuestion, Values};
use super::problem::Exercise;
use super::topic::Form;
use super::value::{TOLERANCE, Value, largest};

/// Grade of an answer. Reasons do not contain the right value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Grade {
    /// Right value and unit.
    Right,
    /// Wrong value, and the mistake if it is recognized.
    Wrong(Option<String>),
    /// Unit of another dimension, or none.
    WrongUnit(String),
    /// No answer, or the question mark of the template.
    Missing,
}

impl Exercise {
    /// Grades the answers.
    pub(super) fn graded(&self, answers: &[Answer]) -> Vec<Grade> {
        let all = self.questions().zip(answers);
        all.map(|((question, values), answer)| self.grade(question, values, answer)).collect()
    }

    fn grade(&self, question: &PreparedQuestion, (right, wrong): &Values, answer: &Answer) -> Grade {
        let form = question.question.form;
        let value = match answer {
            Answer::Missing => return Grade::Missing,
            Answer::NoFormula => {
                return Grade::Wrong(Some(
                    "a formula in the symbols of the problem is required, not a quantity".to_owned(),
                ));
            }
            Answer::Formulas(formulas) => match six(formulas) {
                Some(formulas) => Value::Formulas(formulas),
                None => return asymmetric(),
            },
            Answer::Numbers(numbers) => {
                if let Some(reason) = wrong_unit(question, numbers) {
                    return Grade::WrongUnit(reason);
                }
                let values: Vec<f64> = numbers.iter().map(|(value, _)| *value).collect();
                match symmetric(&values) {
                    Some(values) => Value::Numbers(values),
                    None => return asymmetric(),
                }
            }
        };
        if right.is_met_by(&value, form) {
            return Grade::Right;
        }
        let known =
            wrong.iter().find(|(other, _)| other.is_met_by(&value, form)).map(|(_, why)| (*why).to_owned());
        Grade::Wrong(known.or_else(|| self.general(question, right, &value)))
    }

    /// Returns a mistake that can be made in any exercise.
    fn general(&self, question: &PreparedQuestion, right: &Value, answer: &Value) -> Option<String> {
        let form = question.question.form;
        let is = |factor: f64| right.scaled(factor).is_some_and(|value| value.is_met_by(answer, form));
        if form != Form::Axis {
            if is(-1.0) {
                return Some("the sign is reversed".to_owned());
            }
            if is(2.0) || is(0.5) {
                return Some("a factor 2 is missing or too much".to_owned());
            }
        }
        match (right, answer) {
            (Value::Numbers(right), Value::Numbers(answer)) => {
                let factor = (form != Form::Axis).then(|| conversion(question.unit.1, is)).flatten();
                factor.map(str::to_owned).or_else(|| components(right, answer, form))
            }
            (Value::Formulas(right), Value::Formulas(answer)) => self.symbols_of(right, answer),
            _ => None,
        }
    }

    /// Returns the mistake of a formula that lacks a symbol, or has one too much.
    fn symbols_of(&self, right: &[RationalFunction], answer: &[RationalFunction]) -> Option<String> {
        let name = |symbol| self.prepared.symbols.notation(symbol).to_text();
        let all = |formulas: &[RationalFunction]| {
            formulas.iter().flat_map(RationalFunction::symbols).collect::<Vec<_>>()
        };
        let (right, answer) = (all(right), all(answer));
        let absent = right.iter().find(|symbol| !answer.contains(symbol));
        let extra = answer.iter().find(|symbol| !right.contains(symbol));
        absent
            .map(|&s| {
                format!("{} does not occur: if a number was inserted for it, write the symbol", name(s))
            })
            .or_else(|| extra.map(|&s| format!("the result does not depend on {}", name(s))))
    }
}

fn asymmetric() -> Grade {
    Grade::Wrong(Some("the tensor is not symmetric: I_xy = I_yx".to_owned()))
}

/// Returns the elements xx, yy, zz, xy, xz, yz of nine elements by row; other lists are unchanged.
/// `None` if the elements are not symmetric.
fn six<T: Clone + PartialEq>(all: &[T]) -> Option<Vec<T>> {
    let [xx, xy, xz, yx, yy, yz, zx, zy, zz] = all else { return Some(all.to_vec()) };
    let is_symmetric = xy == yx && xz == zx && yz == zy;
    is_symmetric.then(|| [xx, yy, zz, xy, xz, yz].map(T::clone).to_vec())
}

/// Same as [`six`], within the tolerance.
fn symmetric(all: &[f64]) -> Option<Vec<f64>> {
    let &[xx, xy, xz, yx, yy, yz, zx, zy, zz] = all else { return Some(all.to_vec()) };
    let limit = TOLERANCE * largest(all);
    let is_symmetric = [(xy, yx), (xz, zx), (yz, zy)].iter().all(|(a, b)| (a - b).abs() <= limit);
    is_symmetric.then(|| vec![xx, yy, zz, xy, xz, yz])
}

/// Returns the reason why a unit is wrong.
fn wrong_unit(question: &PreparedQuestion, numbers: &[(f64, Dimension)]) -> Option<String> {
    let (unit, required) = (question.question.unit, question.unit.1);
    numbers.iter().find_map(|&(value, found)| {
        let fits = required.accepts(found) || found.accepts(required);
        match found == Dimension::NONE {
            _ if fits => None,
            // 0 has no unit.
            true if value == 0.0 => None,
            true => Some(format!("the unit is missing: write it after the number, such as {unit}")),
            false if required == Dimension::NONE => {
                Some(format!("the unit is of {found}, but the result is a plain number"))
            }
            false => Some(format!("the unit is of {found}, but the result is {required}")),
        }
    })
}

/// Returns the mistake of a conversion between units.
fn conversion(dimension: Dimension, is: impl Fn(f64) -> bool) -> Option<&'static str> {
    let either = |factor: f64| is(factor) || is(1.0 / factor);
    match dimension {
        Dimension::ANGLE if either(180.0 / PI) => Some("degrees and radians are mixed up"),
        Dimension::ANGULAR_VELOCITY if either(2.0 * PI) || either(30.0 / PI) || either(60.0) => {
            Some("rad/s, rpm and revolutions per second are mixed up")
        }
        Dimension::TIME if either(2.0 * PI) => Some("a factor 2π is missing or too much"),
        _ if (1..=9).any(|power| either(10.0_f64.powi(power))) => {
            Some("the power of ten is wrong: check the prefixes of the units")
        }
        _ => None,
    }
}

/// Returns the mistake in the components of a vector or tensor.
fn components(right: &[f64], answer: &[f64], form: Form) -> Option<String> {
    const NAMES: [&[&str]; 2] = [&["1st", "2nd", "3rd"], &["xx", "yy", "zz", "xy", "xz", "yz"]];
    if right.len() == 1 || form == Form::Axis {
        return None;
    }
    let names = NAMES[usize::from(right.len() == 6)];
    let limit = TOLERANCE * largest(right);
    let is_near = |a: f64, b: f64| (a - b).abs() <= limit;
    let pairs = || names.iter().zip(right).zip(answer);
    let list = |names: Vec<&str>| names.join(", ");
    let wrong: Vec<&str> =
        pairs().filter(|&((_, &a), &b)| !is_near(a, b)).map(|((name, _), _)| *name).collect();
    if pairs().all(|((_, &a), &b)| is_near(a.abs(), b.abs())) {
        return Some(format!("the sign is reversed in: {}", list(wrong)));
    }
    if right.len() == 3 && (1..3).any(|shift| (0..3).all(|k| is_near(right[k], answer[(k + shift) % 3]))) {
        return Some("the components belong to other axes: they are permuted".to_owned());
    }
    (wrong.len() < right.len()).then(|| format!("these elements are wrong: {}", list(wrong)))
}
