//! Topic with its formulas read, from which exercises are made.

use polhode_algebra::{Angle, Kind, RationalFunction, Symbol, Symbols, Variable, parse};
use polhode_document::number::number;
use polhode_source::unit::{Dimension, measured, measured_apart};

use super::generator::Generator;
use super::topic::{Datum, Form, Origin, Question, Range, Topic, Wrong};
use super::value::{Value, distance, finished, largest};

/// Largest number of draws until one is instructive.
const MOST_DRAWS: usize = 2000;
/// Least difference of a wrong value from the right one, and least component of a vector, relative.
const CLEAR: f64 = 0.03;
/// Sizes of results in their units that are easy to read.
const READABLE: core::ops::Range<f64> = 1e-3..1e5;

/// Angles with rational sine and cosine: cosine, sine and their common denominator.
const TRIPLES: [[u8; 3]; 8] =
    [[3, 4, 5], [4, 3, 5], [5, 12, 13], [12, 5, 13], [8, 15, 17], [15, 8, 17], [20, 21, 29], [21, 20, 29]];

/// Topic with its formulas read.
#[derive(Debug)]
pub(super) struct Prepared {
    pub(super) topic: &'static Topic,
    pub(super) symbols: Symbols,
    /// Table of π and the given symbols, with the same places.
    pub(super) stated: Symbols,
    pi: Symbol,
    data: Vec<PreparedDatum>,
    rules: Vec<RationalFunction>,
    pub(super) questions: Vec<PreparedQuestion>,
}

#[derive(Debug)]
struct PreparedDatum {
    datum: &'static Datum,
    symbol: Symbol,
    formula: Option<RationalFunction>,
}

/// Question with its formulas read.
#[derive(Debug)]
pub(super) struct PreparedQuestion {
    pub(super) question: &'static Question,
    pub(super) right: Vec<RationalFunction>,
    wrong: Vec<(Change, &'static str)>,
    /// Size of its unit in SI, and its dimension.
    pub(super) unit: (f64, Dimension),
}

#[derive(Debug)]
enum Change {
    /// Formulas in place of the right ones.
    Formulas(Vec<RationalFunction>),
    /// Other values of symbols in the right formulas.
    Values(Vec<(Symbol, RationalFunction)>),
}

/// Given quantity with its value.
#[derive(Clone, Debug)]
pub(super) struct Given {
    pub(super) symbol: Symbol,
    /// Value, SI units.
    pub(super) value: f64,
    /// Value as the problem states it; empty if the problem does not.
    pub(super) text: String,
}

/// Right and wrong values of a question; wrong ones have their reasons.
pub(super) type Values = (Value, Vec<(Value, &'static str)>);

impl Prepared {
    /// Reads the formulas of a topic; `None` if one is not valid, which a test excludes.
    pub(super) fn new(topic: &'static Topic) -> Option<Self> {
        let mut symbols = Symbols::new();
        let pi = symbols.declare("π", Kind::Positive).ok()?;
        let data = || topic.data.iter();
        // The answers of students know the given symbols only, which come first.
        data().filter(|d| d.is_given).try_for_each(|d| symbols.declare(d.symbol, kind(d)).map(drop)).ok()?;
        let stated = symbols.clone();
        data().filter(|d| !d.is_given).try_for_each(|d| symbols.declare(d.symbol, kind(d)).map(drop)).ok()?;
        let read = |text: &&str| parse(text, &symbols).ok();
        let data = data().map(|datum| {
            let formula = match datum.origin {
                Origin::Formula(text) => Some(read(&text)?),
                _ => None,
            };
            Some(PreparedDatum { datum, symbol: symbols.find(datum.symbol)?, formula })
        });
        let data = data.collect::<Option<_>>()?;
        let rules = topic.rules.iter().map(read).collect::<Option<_>>()?;
        let questions = topic.questions.iter().map(|question| PreparedQuestion::new(question, &symbols));
        let questions = questions.collect::<Option<_>>()?;
        Some(Self { topic, symbols, stated, pi, data, rules, questions })
    }

    /// Returns the symbols that the problem states.
    pub(super) fn given_symbols(&self) -> impl Iterator<Item = Symbol> {
        self.data.iter().filter(|datum| datum.datum.is_given).map(|datum| datum.symbol)
    }

    /// Returns true if the topic can ask for formulas: the answers contain only what is given, and
    /// are more than one symbol.
    pub(super) fn has_symbols(&self) -> bool {
        let given: Vec<Symbol> = self.given_symbols().chain([self.pi]).collect();
        let is_asked = |f: &RationalFunction| {
            f.symbols().all(|symbol| given.contains(&symbol))
                && !given.iter().any(|&symbol| *f == RationalFunction::from(symbol))
        };
        self.questions.iter().flat_map(|question| &question.right).all(is_asked)
    }

    /// Draws the data of a seed; `None` if no draw is instructive, which a test excludes.
    pub(super) fn draw(&self, seed: u64) -> Option<(Vec<Given>, Vec<Values>)> {
        let mut generator = Generator::new(self.topic.name, seed);
        (0..MOST_DRAWS).find_map(|_| {
            let data = self.data_of(&mut generator)?;
            let is_allowed = |rule: &RationalFunction| self.value(rule, &data).is_some_and(|x| x > 0.0);
            if !self.rules.iter().all(is_allowed) {
                return None;
            }
            let values = self.questions.iter().map(|question| self.values(question, &data));
            let values = values.collect::<Option<Vec<_>>>()?;
            Some((data, values))
        })
    }

    /// Returns the right and wrong formulas of each question.
    pub(super) fn formulas(&self) -> Vec<Values> {
        let of = |question: &PreparedQuestion| {
            let wrong = question.wrong.iter().filter_map(|(change, reason)| {
                let formulas = match change {
                    Change::Formulas(formulas) => formulas.clone(),
                    // Units are converted in numbers only.
                    Change::Values(values) if self.converts(values) => return None,
                    Change::Values(values) => {
                        question.right.iter().map(|f| changed(f, values)).collect::<Option<_>>()?
                    }
                };
                (formulas != question.right).then_some((Value::Formulas(formulas), *reason))
            });
            (Value::Formulas(question.right.clone()), wrong.collect())
        };
        self.questions.iter().map(of).collect()
    }

    /// Returns true if values of symbols contain π, as in a conversion of units.
    fn converts(&self, values: &[(Symbol, RationalFunction)]) -> bool {
        values.iter().any(|(_, value)| value.symbols().any(|symbol| symbol == self.pi))
    }

    /// Returns the value of a formula, SI units.
    pub(super) fn value(&self, formula: &RationalFunction, data: &[Given]) -> Option<f64> {
        formula.evaluate(&|symbol| match symbol == self.pi {
            true => Some(core::f64::consts::PI),
            false => data.iter().find(|given| given.symbol == symbol).map(|given| given.value),
        })
    }

    /// Draws the data; `None` if two drawn sizes are equal.
    fn data_of(&self, generator: &mut Generator) -> Option<Vec<Given>> {
        let mut data: Vec<Given> = Vec::new();
        for PreparedDatum { datum, symbol, formula } in &self.data {
            let given = |value: f64, text: String| Given { symbol: *symbol, value, text };
            let quantity = |number: &str| {
                let text = format!("{number} {}", datum.unit);
                Some(given(measured(text.trim()).ok()?.0, text.trim().to_owned()))
            };
            data.push(match datum.origin {
                Origin::Drawn(range) if !datum.is_given => {
                    given(decimal(range, generator).parse().ok()?, String::new())
                }
                Origin::Drawn(range) => {
                    let drawn = quantity(&decimal(range, generator))?;
                    let size = |text: &str| text.trim_start_matches('-').to_owned();
                    data.iter().all(|other| size(&other.text) != size(&drawn.text)).then_some(drawn)?
                }
                Origin::Fixed(number) => quantity(number)?,
                Origin::Sign => given(if generator.below(2) == 0 { 1.0 } else { -1.0 }, String::new()),
                Origin::Triple => {
                    let [cosine, sine, r] = TRIPLES[generator.below(TRIPLES.len() as u64) as usize];
                    let name = self.symbols.notation(*symbol).to_text();
                    let text = format!("cos {name} = {cosine}/{r}, sin {name} = {sine}/{r}");
                    given(libm::atan2(f64::from(sine), f64::from(cosine)), text)
                }
                Origin::Formula(_) => {
                    let value = self.value(formula.as_ref()?, &data)?;
                    let shown = number(value / factor_of(datum.unit)?.0, 6);
                    given(value, format!("{shown} {}", datum.unit).trim().to_owned())
                }
            });
        }
        Some(data)
    }

    /// Returns the right and wrong numbers of a question; `None` if they are not instructive: zero,
    /// of an unusual size, or too close to each other.
    fn values(&self, prepared: &PreparedQuestion, data: &[Given]) -> Option<Values> {
        let form = prepared.question.form;
        let numbers = |formulas: &[RationalFunction], data: &[Given]| {
            let all = formulas.iter().map(|f| self.value(f, data).map(|x| finished(x, form)));
            all.collect::<Option<Vec<f64>>>().filter(|all| all.iter().all(|x| x.is_finite()))
        };
        let right = numbers(&prepared.right, data)?;
        let size = largest(&right);
        let is_clear = right.iter().all(|x| x.abs() >= CLEAR * size);
        if !is_clear || !READABLE.contains(&(size / prepared.unit.0)) {
            return None;
        }
        let mut wrong = Vec::new();
        for (change, reason) in &prepared.wrong {
            let value = match change {
                Change::Formulas(formulas) => numbers(formulas, data),
                Change::Values(values) => {
                    let mut other = data.to_vec();
                    for (symbol, formula) in values {
                        let value = self.value(formula, data)?;
                        other.iter_mut().filter(|g| g.symbol == *symbol).for_each(|g| g.value = value);
                    }
                    numbers(&prepared.right, &other)
                }
            };
            // A negative square has no root: nobody arrives at that value.
            let Some(value) = value else { continue };
            if distance(&right, &value, form) < CLEAR {
                return None;
            }
            wrong.push((Value::Numbers(value), *reason));
        }
        Some((Value::Numbers(right), wrong))
    }
}

impl PreparedQuestion {
    fn new(question: &'static Question, symbols: &Symbols) -> Option<Self> {
        let read = |text: &&str| parse(text, symbols).ok();
        let right: Vec<RationalFunction> = question.right.iter().map(read).collect::<Option<_>>()?;
        let change = |(wrong, reason): &(Wrong, &'static str)| {
            let change = match wrong {
                Wrong::Is(formulas) => Change::Formulas(formulas.iter().map(read).collect::<Option<_>>()?),
                Wrong::Times(factor) => {
                    let factor = read(factor)?;
                    Change::Formulas(right.iter().map(|f| f * &factor).collect())
                }
                Wrong::Products => {
                    let signed = |(k, f): (usize, &RationalFunction)| if k < 3 { f.clone() } else { -f };
                    Change::Formulas(right.iter().enumerate().map(signed).collect())
                }
                Wrong::With(values) => {
                    let values = values.iter().map(|(name, text)| Some((symbols.find(name)?, read(text)?)));
                    Change::Values(values.collect::<Option<_>>()?)
                }
            };
            Some((change, *reason))
        };
        let wrong = question.mistakes.iter().map(change).collect::<Option<_>>()?;
        Some(Self { question, right, wrong, unit: factor_of(question.unit)? })
    }

    /// Returns the name in the answer file.
    pub(super) fn name(&self, is_symbolic: bool) -> &'static str {
        match self.question.form {
            Form::Square(name) | Form::Tangent(name) | Form::SquaredTangent(name) if is_symbolic => name,
            _ => self.question.name,
        }
    }

    /// Returns the meaning of the answer.
    pub(super) fn meaning(&self, is_symbolic: bool) -> String {
        let of = match self.question.form {
            _ if !is_symbolic => "",
            Form::Square(_) => "square of the ",
            Form::Tangent(_) => "tangent of the ",
            Form::SquaredTangent(_) => "square of the tangent of the ",
            Form::Plain | Form::Axis => "",
        };
        format!("{of}{}", self.question.is)
    }
}

fn kind(datum: &Datum) -> Kind {
    match datum.origin {
        Origin::Drawn(Range { is_signed: true, .. }) | Origin::Sign => Kind::Constant,
        _ => Kind::Positive,
    }
}

/// Returns the size of a unit in SI, and its dimension.
fn factor_of(unit: &str) -> Option<(f64, Dimension)> {
    if unit.is_empty() { Some((1.0, Dimension::NONE)) } else { measured_apart("1", unit).ok() }
}

/// Draws a decimal that does not end with 0.
fn decimal(range: Range, generator: &mut Generator) -> String {
    let count = range.to - range.from + 1;
    let mut digits = range.from + generator.below(count);
    if digits.is_multiple_of(10) {
        digits += 1;
    }
    let scale = 10_u64.pow(range.decimals as u32);
    let sign = if range.is_signed && generator.below(2) == 0 { "-" } else { "" };
    match range.decimals {
        0 => format!("{sign}{digits}"),
        places => format!("{sign}{}.{:0places$}", digits / scale, digits % scale),
    }
}

/// Returns a formula with other values of some symbols; `None` if the sine of a value is not a
/// formula.
fn changed(formula: &RationalFunction, values: &[(Symbol, RationalFunction)]) -> Option<RationalFunction> {
    let of = |symbol: Symbol| values.iter().find(|(other, _)| *other == symbol).map(|(_, value)| value);
    formula.replaced(&|variable| match variable {
        Variable::Symbol(symbol) => Some(of(symbol).cloned().unwrap_or_else(|| symbol.into())),
        Variable::Sine(symbol) => of(symbol).map_or(Some(variable.into()), |v| Some(Angle::new(v)?.sine())),
        Variable::Cosine(symbol) => {
            of(symbol).map_or(Some(variable.into()), |v| Some(Angle::new(v)?.cosine()))
        }
        Variable::Root(_) => Some(variable.into()),
    })
}
