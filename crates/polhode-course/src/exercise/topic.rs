//! Topics as data: files in `topics/`, read line by line.
//!
//! ```text
//! ## rolling-ball: Ball that rolls down an incline
//! Problem in words, on one line.
//! use tensor                                data and rules of a block in blocks.txt
//! given beta = 11..39 deg                   random decimal that does not end with 0; ±11..39: of either sign
//! given g = 9.81 m/s^2                      constant
//! given I_3 = (p + q) in kg m^2             formula in the other data
//! given phi = triple                        random angle with rational sine and cosine
//! hidden p = 0.21..0.89                     the same in SI units, for formulas of other data only
//! hidden s = sign                           ±1
//! rule l/2 - d                              formula that is positive for a possible and instructive body
//! say Law in words.                         step of the solution
//! show S = (I_xx + I_yy) in kg m^2          intermediate result
//! ask v [m/s] square v_squared: meaning     quantity to be found, its unit, and its form
//!   = 10/7*g*s*sin(beta)                    right formula; three components or six elements: … | … | …
//!   is 10/7*g*s*cos(beta): reason           mistake: other formulas
//!   times 7/5: reason                       mistake: a factor
//!   with l = 2*l, d = 0: reason             mistake: other values of some symbols
//!   products: reason                        mistake: other sign of the products of inertia
//! ```
//!
//! Answers and mistakes are formulas in the symbols of the data, so that one statement gives the
//! problem in numbers, the problem in symbols, the solution of both, and the wrong values.

use std::sync::LazyLock;

/// Topics in the order of Thornton & Marion, *Classical Dynamics of Particles and Systems*, chapter
/// 11.
const FILES: [&str; 8] = [
    include_str!("topics/tensor.txt"),
    include_str!("topics/shift.txt"),
    include_str!("topics/body.txt"),
    include_str!("topics/principal.txt"),
    include_str!("topics/energy.txt"),
    include_str!("topics/pendulum.txt"),
    include_str!("topics/euler.txt"),
    include_str!("topics/top.txt"),
];

/// Lines that several topics have.
const BLOCKS: &str = include_str!("topics/blocks.txt");

/// All topics; a test requires that none is left out because of a line that is not valid.
pub(super) static TOPICS: LazyLock<Vec<Topic>> =
    LazyLock::new(|| FILES.into_iter().flat_map(sections).filter_map(Topic::read).collect());

/// Topic of exercises.
#[derive(Debug)]
pub(super) struct Topic {
    /// Name in commands and answer files.
    pub(super) name: &'static str,
    pub(super) title: &'static str,
    /// Problem in words, with the symbols of the data.
    pub(super) text: &'static str,
    pub(super) data: Vec<Datum>,
    pub(super) rules: Vec<&'static str>,
    pub(super) steps: Vec<Step>,
    pub(super) questions: Vec<Question>,
}

/// Quantity of a problem.
#[derive(Debug)]
pub(super) struct Datum {
    /// Symbol in formulas.
    pub(super) symbol: &'static str,
    /// Unit in which it is given.
    pub(super) unit: &'static str,
    /// False if only formulas of other data contain it.
    pub(super) is_given: bool,
    pub(super) origin: Origin,
}

/// Source of a value.
#[derive(Clone, Copy, Debug)]
pub(super) enum Origin {
    Drawn(Range),
    Sign,
    Triple,
    Formula(&'static str),
    Fixed(&'static str),
}

/// Integers from `from` to `to`, divided by a power of ten.
#[derive(Clone, Copy, Debug)]
pub(super) struct Range {
    pub(super) from: u64,
    pub(super) to: u64,
    /// Number of decimals.
    pub(super) decimals: usize,
    /// True if either sign may be drawn.
    pub(super) is_signed: bool,
}

/// Step of a solution.
#[derive(Debug)]
pub(super) enum Step {
    /// Law in words and symbols.
    Say(&'static str),
    /// Intermediate result: name, formula, SI unit.
    Show(&'static str, &'static str, &'static str),
}

/// Quantity to be found.
#[derive(Debug)]
pub(super) struct Question {
    /// Name in the answer file.
    pub(super) name: &'static str,
    /// Meaning of the quantity in words.
    pub(super) is: &'static str,
    /// Unit in the solution and in the template of the answer file.
    pub(super) unit: &'static str,
    pub(super) form: Form,
    /// Formula of a number; formulas of the three components of a vector; or of the elements xx, yy,
    /// zz, xy, xz, yz of a tensor.
    pub(super) right: Vec<&'static str>,
    /// Likeliest mistakes, and what a student who makes one should read.
    pub(super) mistakes: Vec<(Wrong, &'static str)>,
}

/// Relation of a quantity to its formulas. In symbols, the formula itself is the question: its name
/// in the answer file is stated here.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Form {
    /// The quantity itself.
    Plain,
    /// Square of the quantity.
    Square(&'static str),
    /// Tangent of the quantity, an angle from 0 to 90°.
    Tangent(&'static str),
    /// Square of the tangent.
    SquaredTangent(&'static str),
    /// Vector along an axis, of any length and either sign.
    Axis,
}

/// Formula of a mistake.
#[derive(Debug)]
pub(super) enum Wrong {
    Is(Vec<&'static str>),
    Times(&'static str),
    With(Vec<(&'static str, &'static str)>),
    Products,
}

/// Returns the texts after each `## `.
fn sections(file: &'static str) -> impl Iterator<Item = &'static str> {
    file.strip_prefix("## ").into_iter().flat_map(|file| file.split("\n## "))
}

/// Returns the lines of a block after its heading.
fn block(name: &str) -> Option<&'static str> {
    let mut blocks = sections(BLOCKS).filter_map(|block| block.split_once('\n'));
    blocks
        .find(|(head, _)| head.split_once(": ").is_some_and(|(other, _)| other == name))
        .map(|(_, lines)| lines)
}

impl Topic {
    fn read(section: &'static str) -> Option<Self> {
        let (head, rest) = section.split_once('\n')?;
        let ((name, title), (text, rest)) = (head.split_once(": ")?, rest.split_once('\n')?);
        let (data, rules, steps, questions) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        let mut topic = Self { name, title, text, data, rules, steps, questions };
        for line in rest.lines() {
            match line.strip_prefix("use ") {
                Some(name) => block(name)?.lines().try_for_each(|line| topic.add(line))?,
                None => topic.add(line)?,
            }
        }
        Some(topic)
    }

    /// Adds a line; `None` if it is not valid.
    fn add(&mut self, line: &'static str) -> Option<()> {
        let line = line.trim_start();
        let (word, rest) = line.split_once(' ').unwrap_or((line, ""));
        match word {
            "" => {}
            "given" | "hidden" => self.data.push(Datum::read(rest, word == "given")?),
            "rule" => self.rules.push(rest),
            "say" => self.steps.push(Step::Say(rest)),
            "show" => {
                let (name, value) = rest.split_once(" = ")?;
                let (formula, unit) = formula(value)?;
                self.steps.push(Step::Show(name, formula, unit));
            }
            "ask" => self.questions.push(Question::read(rest)?),
            "=" => self.questions.last_mut()?.right = rest.split(" | ").collect(),
            _ => {
                let (wrong, reason) = line.split_once(": ")?;
                self.questions.last_mut()?.mistakes.push((Wrong::read(wrong)?, reason));
            }
        }
        Some(())
    }
}

/// Returns formula and unit of `(p + q) in kg m^2`.
fn formula(value: &'static str) -> Option<(&'static str, &'static str)> {
    value.strip_prefix('(')?.rsplit_once(") in ")
}

impl Datum {
    fn read(text: &'static str, is_given: bool) -> Option<Self> {
        let (symbol, value) = text.split_once(" = ")?;
        let (number, unit) = value.split_once(' ').unwrap_or((value, ""));
        let (origin, unit) = match value {
            "sign" => (Origin::Sign, ""),
            "triple" => (Origin::Triple, ""),
            _ if value.starts_with('(') => {
                formula(value).map(|(formula, unit)| (Origin::Formula(formula), unit))?
            }
            _ if number.contains("..") => (Origin::Drawn(Range::read(number)?), unit),
            _ => (Origin::Fixed(number), unit),
        };
        Some(Self { symbol, unit, is_given, origin })
    }
}

impl Range {
    fn read(text: &str) -> Option<Self> {
        let (text, is_signed) = text.strip_prefix('±').map_or((text, false), |text| (text, true));
        let (from, to) = text.split_once("..")?;
        let decimals = from.split_once('.').map_or(0, |(_, decimals)| decimals.len());
        let [from, to] = [from, to].map(|number| number.replace('.', "").parse().ok());
        Some(Self { from: from?, to: to?, decimals, is_signed })
    }
}

impl Question {
    fn read(text: &'static str) -> Option<Self> {
        let (head, is) = text.split_once(": ")?;
        let (name, rest) = head.split_once(" [")?;
        let (unit, form) = rest.split_once(']')?;
        let form = match form.trim_start().split_once(' ') {
            None if form.is_empty() => Form::Plain,
            None if form == " axis" => Form::Axis,
            Some(("square", name)) => Form::Square(name),
            Some(("tangent", name)) => Form::Tangent(name),
            Some(("squared-tangent", name)) => Form::SquaredTangent(name),
            _ => return None,
        };
        Some(Self { name, is, unit, form, right: Vec::new(), mistakes: Vec::new() })
    }
}

impl Wrong {
    fn read(text: &'static str) -> Option<Self> {
        match text.split_once(' ').unwrap_or((text, "")) {
            ("products", "") => Some(Self::Products),
            ("is", formulas) => Some(Self::Is(formulas.split(" | ").collect())),
            ("times", factor) => Some(Self::Times(factor)),
            ("with", values) => {
                values.split(", ").map(|value| value.split_once(" = ")).collect::<Option<_>>().map(Self::With)
            }
            _ => None,
        }
    }
}
