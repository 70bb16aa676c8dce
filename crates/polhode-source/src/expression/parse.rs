//! Compiler from text to instructions by Dijkstra's shunting-yard algorithm: two stacks, no
//! recursion. Memory is proportional to the length of the text, also for deeply nested formulas.

use std::f64::consts::PI;

use polhode::math::formula::{Binary, Formula, Instruction, Unary};

use super::dimensions::{Measured, Step, measure};
use super::function::{FUNCTIONS, Function};
use super::{ExpressionError, ExpressionErrorKind, is_reserved};
use crate::suggestion::nearest;
use crate::unit::{self, Dimension};

/// Entry of the operator stack.
#[derive(Clone, Copy)]
enum Waiting {
    /// Operator with its precedence.
    Operator { op: Instruction, binds: u8, column: usize },
    /// Open parenthesis; for a function call, with the function and the number of commas so far.
    Open { column: usize, function: Option<(Function, usize)> },
}

const OR: u8 = 1;
const AND: u8 = 2;
const COMPARISON: u8 = 3;
const SUM: u8 = 4;
const PRODUCT: u8 = 5;
const SIGN: u8 = 6;
const POWER: u8 = 7;

/// Largest number of characters of a formula in a scenario, whose dimensions are checked.
const LONGEST: usize = 4096;

/// Compiles a formula with all numbers in SI units.
pub(crate) fn compile(text: &str, variables: &[&str]) -> Result<Formula, ExpressionError> {
    Parser::new(text, variables, false).read().map(|(formula, _)| formula)
}

/// Compiles a formula with all numbers in SI units, after definitions of local values:
/// `a = x + y; b = a^2; a*b`.
pub(crate) fn compile_with_locals(text: &str, variables: &[&str]) -> Result<Formula, ExpressionError> {
    let parser = Parser::new(text, variables, false);
    Parser { locals: Some(Vec::new()), ..parser }.read().map(|(formula, _)| formula)
}

/// Compiles a formula and checks its dimensions; returns it with the dimension of its value.
pub(crate) fn compile_measured(
    text: &str,
    variables: &[(&str, Dimension)],
    expected: Option<Dimension>,
) -> Result<(Formula, Dimension), ExpressionError> {
    require_length(text, LONGEST)?;
    let names: Vec<&str> = variables.iter().map(|&(name, _)| name).collect();
    let dimensions: Vec<Dimension> = variables.iter().map(|(_, d)| *d).collect();
    let mut parser = Parser::new(text, &names, true);
    let (formula, steps) = parser.read()?;
    let value = measure(&steps, &dimensions)?;
    match (value, expected) {
        (Measured::Zero, expected) => Ok((formula, expected.unwrap_or(Dimension::NONE))),
        (Measured::As(found), None) => Ok((formula, found.with_angle())),
        (Measured::As(found), Some(expected)) if found == expected.without_angle() => Ok((formula, expected)),
        (Measured::As(found), Some(expected)) => {
            let kind = ExpressionErrorKind::Value { found: found.with_angle(), expected };
            Err(ExpressionError { kind, column: parser.start() })
        }
    }
}

/// # Errors
/// [`ExpressionError`] for a text of more than `most` characters.
pub(crate) fn require_length(text: &str, most: usize) -> Result<(), ExpressionError> {
    match text.chars().nth(most) {
        Some(_) => Err(ExpressionError { kind: ExpressionErrorKind::TooLong { most }, column: most + 1 }),
        None => Ok(()),
    }
}

struct Parser<'a> {
    rest: Vec<char>,
    /// Number of characters already read.
    at: usize,
    variables: &'a [&'a str],
    /// True if numbers may have units.
    units: bool,
    /// Names of the local values so far; `None` if there may be none.
    locals: Option<Vec<String>>,
    steps: Vec<Step>,
    waiting: Vec<Waiting>,
}

impl<'a> Parser<'a> {
    fn new(text: &str, variables: &'a [&'a str], units: bool) -> Self {
        let (steps, waiting) = (Vec::new(), Vec::new());
        Self { rest: text.chars().collect(), at: 0, variables, units, locals: None, steps, waiting }
    }

    /// Parses the whole text; returns the formula, and its instructions with their columns.
    fn read(&mut self) -> Result<(Formula, Vec<Step>), ExpressionError> {
        while let Some(name) = self.definition()? {
            self.formula()?;
            if self.peek().is_none() {
                return Err(self.expected("; after a local value"));
            }
            self.at += 1;
            self.locals.get_or_insert_default().push(name);
        }
        self.formula()?;
        if self.peek().is_some() {
            return Err(self.expected("an operator or the end"));
        }
        for _ in 0..self.locals.as_ref().map_or(0, Vec::len) {
            self.push(Instruction::EndLocal, 1);
        }
        let steps = core::mem::take(&mut self.steps);
        let formula = Formula::new(steps.iter().map(|step| step.instruction));
        formula.map(|formula| (formula, steps)).map_err(|_| self.expected("a formula"))
    }

    /// Moves to the start of the text and returns its column.
    fn start(&mut self) -> usize {
        self.at = 0;
        self.column()
    }

    fn push(&mut self, instruction: Instruction, column: usize) {
        self.steps.push(Step { instruction, column, dimension: Dimension::NONE });
    }

    /// Parses the name of a local value and `=`, if they are next.
    fn definition(&mut self) -> Result<Option<String>, ExpressionError> {
        if self.locals.is_none() {
            return Ok(None);
        }
        let (start, column) = (self.at, self.column());
        let name = self.word();
        self.at += name.chars().count();
        if name.is_empty() || self.peek() != Some('=') {
            self.at = start;
            return Ok(None);
        }
        self.at += 1;
        let is_known = self.locals.iter().flatten().any(|local| *local == name)
            || self.variables.contains(&name.as_str())
            || is_reserved(&name);
        if is_known || name.starts_with(|c: char| c.is_ascii_digit()) {
            let kind = ExpressionErrorKind::Expected { what: "a new name", found: name };
            return Err(ExpressionError { kind, column });
        }
        Ok(Some(name))
    }

    /// Parses operand, operator, operand, …, operand.
    fn formula(&mut self) -> Result<(), ExpressionError> {
        loop {
            self.operand()?;
            while !self.operator()? {
                let next = self.peek();
                if self.waiting.is_empty() && (next.is_none() || self.locals.is_some() && next == Some(';')) {
                    return Ok(());
                }
            }
        }
    }

    /// Parses signs, then a number, a variable, or the start of a function call or parenthesis.
    fn operand(&mut self) -> Result<(), ExpressionError> {
        loop {
            let column = self.column();
            match self.peek() {
                Some('-' | '−') => {
                    self.at += 1;
                    let op = Instruction::Unary(Unary::Negate);
                    self.waiting.push(Waiting::Operator { op, binds: SIGN, column });
                }
                Some('+') => self.at += 1,
                Some('(') => {
                    self.at += 1;
                    self.waiting.push(Waiting::Open { column, function: None });
                }
                Some(c) if c.is_ascii_digit() || c == '.' => return self.number(),
                Some(c) if c.is_alphabetic() || c == '_' => {
                    if self.name()? {
                        return Ok(());
                    }
                }
                _ => return Err(self.expected("a number, a name or (")),
            }
        }
    }

    /// Parses the token after an operand; returns true if another operand must follow.
    fn operator(&mut self) -> Result<bool, ExpressionError> {
        let column = self.column();
        let binary = |op, binds| Some((Instruction::Binary(op), binds));
        let or_equal = self.rest.get(self.at + 1) == Some(&'=');
        let orders = |strict, loose| binary(if or_equal { loose } else { strict }, COMPARISON);
        let operator = match self.peek() {
            Some('+') => binary(Binary::Add, SUM),
            Some('-' | '−') => binary(Binary::Subtract, SUM),
            Some('*' | '·' | '×') => binary(Binary::Multiply, PRODUCT),
            Some('/') => binary(Binary::Divide, PRODUCT),
            Some('^') => binary(Binary::Power, POWER),
            Some('<') => orders(Binary::Less, Binary::LessOrEqual),
            Some('>') => orders(Binary::Greater, Binary::GreaterOrEqual),
            Some(')') => return self.close(),
            Some(',') => return self.comma(),
            None => return self.end(),
            Some(';') if self.locals.is_some() => return self.end(),
            Some(_) => match self.word().as_str() {
                "and" => binary(Binary::And, AND),
                "or" => binary(Binary::Or, OR),
                _ => None,
            },
        };
        let Some((op, binds)) = operator else { return Err(self.expected("an operator, ) or the end")) };
        self.at += match binds {
            AND => "and".len(),
            OR => "or".len(),
            _ => 1,
        };
        if binds == COMPARISON && or_equal {
            self.at += 1;
        }
        // Operators associate to the left. `^` associates to the right: it does not unwind another
        // `^`.
        let chained = self.unwind(if binds == POWER { POWER + 1 } else { binds });
        if binds == COMPARISON && chained {
            return Err(ExpressionError { kind: ExpressionErrorKind::ChainedComparison, column });
        }
        self.waiting.push(Waiting::Operator { op, binds, column });
        Ok(true)
    }

    /// Emits the waiting operators of at least this precedence; returns true if one is a
    /// comparison.
    fn unwind(&mut self, least: u8) -> bool {
        let mut compared = false;
        while let Some(&Waiting::Operator { op, binds, column }) = self.waiting.last()
            && binds >= least
        {
            self.push(op, column);
            self.waiting.pop();
            compared |= binds == COMPARISON;
        }
        compared
    }

    fn close(&mut self) -> Result<bool, ExpressionError> {
        self.unwind(0);
        let Some(Waiting::Open { column, function }) = self.waiting.pop() else {
            return Err(self.expected("an operator or the end"));
        };
        self.at += 1;
        if let Some((function, commas)) = function {
            let (takes, given) = (function.takes(), commas + 1);
            if takes != given {
                let kind = ExpressionErrorKind::Arguments { function: function.name, takes, given };
                return Err(ExpressionError { kind, column });
            }
            self.push(function.op, column);
        }
        Ok(false)
    }

    fn comma(&mut self) -> Result<bool, ExpressionError> {
        self.unwind(0);
        match self.waiting.last_mut() {
            Some(Waiting::Open { function: Some((_, commas)), .. }) => *commas += 1,
            _ => return Err(self.expected("an operator, ) or the end")),
        }
        self.at += 1;
        Ok(true)
    }

    fn end(&mut self) -> Result<bool, ExpressionError> {
        self.unwind(0);
        if self.waiting.is_empty() { Ok(false) } else { Err(self.expected("an operator or )")) }
    }

    fn number(&mut self) -> Result<(), ExpressionError> {
        let (column, start) = (self.column(), self.at);
        self.digits();
        if self.rest.get(self.at) == Some(&'.') {
            self.at += 1;
            self.digits();
        }
        if let Some('e' | 'E') = self.rest.get(self.at) {
            let sign = usize::from(matches!(self.rest.get(self.at + 1), Some('+' | '-')));
            if self.rest.get(self.at + 1 + sign).is_some_and(char::is_ascii_digit) {
                self.at += 1 + sign;
                self.digits();
            }
        }
        let found: String = self.rest[start..self.at].iter().collect();
        match found.parse::<f64>() {
            Ok(value) if value.is_finite() => {
                if self.units && self.peek() == Some('[') {
                    return self.unit(&found, column);
                }
                if self.units && self.bare_unit(&found, column)? {
                    return Ok(());
                }
                self.push(Instruction::Constant(value), column);
                Ok(())
            }
            Ok(_) => Err(ExpressionError { kind: ExpressionErrorKind::Number { found }, column }),
            Err(_) => {
                let kind = ExpressionErrorKind::Expected { what: "a number", found };
                Err(ExpressionError { kind, column })
            }
        }
    }

    /// Parses a unit in brackets after a number, such as `[N m]`.
    fn unit(&mut self, number: &str, column: usize) -> Result<(), ExpressionError> {
        self.at += 1;
        let unit_column = self.column();
        let length = self.rest[self.at..].iter().position(|&c| c == ']');
        let Some(length) = length else {
            self.at = self.rest.len();
            return Err(self.expected("] after a unit"));
        };
        let unit: String = self.rest[self.at..self.at + length].iter().collect();
        if unit.trim().is_empty() {
            return Err(self.expected("a unit"));
        }
        self.at += length + 1;
        let (value, dimension) = unit::measured_apart(number, &unit)
            .map_err(|e| ExpressionError { kind: ExpressionErrorKind::Unit(e), column: unit_column })?;
        self.steps.push(Step { instruction: Instruction::Constant(value), column, dimension });
        Ok(())
    }

    /// Parses a unit directly after a number, such as `N m`, up to the first word that is not a
    /// unit. Returns false if there is none.
    fn bare_unit(&mut self, number: &str, column: usize) -> Result<bool, ExpressionError> {
        self.peek();
        let start = self.at;
        let mut end = start;
        loop {
            let word = self.word();
            let is_unit = word.chars().all(|c| c.is_alphabetic() || c == '°' || c == '%')
                && !["and", "or", "if", "pi"].contains(&word.as_str())
                && !self.variables.contains(&word.as_str())
                && self.rest.get(self.at + word.chars().count()) != Some(&'(');
            if word.is_empty() || !is_unit {
                break;
            }
            self.at += word.chars().count();
            if self.rest.get(self.at) == Some(&'^') {
                let sign = usize::from(self.rest.get(self.at + 1) == Some(&'-'));
                if self.rest.get(self.at + 1 + sign).is_some_and(char::is_ascii_digit) {
                    self.at += 1 + sign;
                    self.digits();
                }
            }
            while self.rest.get(self.at).is_some_and(|c| "⁻¹²³⁴".contains(*c)) {
                self.at += 1;
            }
            end = self.at;
            // A further factor follows a space, a point or a slash.
            if let Some('/' | '·') = self.peek() {
                self.at += 1;
                self.peek();
            }
        }
        self.at = end;
        let unit: String = self.rest[start..end].iter().collect();
        if unit.is_empty()
            || unit::measured_apart("1", unit.split([' ', '/', '·', '^']).next().unwrap_or("")).is_err()
        {
            self.at = start;
            return Ok(false);
        }
        let (value, dimension) = unit::measured_apart(number, &unit)
            .map_err(|e| ExpressionError { kind: ExpressionErrorKind::Unit(e), column: start + 1 })?;
        self.steps.push(Step { instruction: Instruction::Constant(value), column, dimension });
        Ok(true)
    }

    /// Returns the letters, digits and underscores at the current place; empty if there are none.
    fn word(&self) -> String {
        let is_letter = |c: &&char| c.is_alphanumeric() && !"¹²³⁴".contains(**c) || "_°%".contains(**c);
        self.rest[self.at..].iter().take_while(is_letter).collect()
    }

    fn digits(&mut self) {
        while self.rest.get(self.at).is_some_and(char::is_ascii_digit) {
            self.at += 1;
        }
    }

    /// Parses a variable, a constant, or a function with its parenthesis; returns true for an
    /// operand.
    fn name(&mut self) -> Result<bool, ExpressionError> {
        let (column, start) = (self.column(), self.at);
        while self.rest.get(self.at).is_some_and(|&c| c.is_alphanumeric() || c == '_') {
            self.at += 1;
        }
        let name: String = self.rest[start..self.at].iter().collect();
        if self.peek() == Some('(') {
            let Some(&function) = FUNCTIONS.iter().find(|f| f.name == name) else {
                let suggestion = nearest(&name, FUNCTIONS.map(|f| f.name));
                let kind = ExpressionErrorKind::UnknownFunction { name, suggestion };
                return Err(ExpressionError { kind, column });
            };
            self.at += 1;
            self.waiting.push(Waiting::Open { column, function: Some((function, 0)) });
            return Ok(false);
        }
        if let Some(k) = self.variables.iter().position(|v| *v == name) {
            self.push(Instruction::Variable(k), column);
        } else if let Some(k) = self.locals.iter().flatten().position(|local| *local == name) {
            self.push(Instruction::Local(k), column);
        } else if name == "pi" {
            self.push(Instruction::Constant(PI), column);
        } else if FUNCTIONS.iter().any(|f| f.name == name) {
            return Err(self.expected("( after a function"));
        } else {
            let known: Vec<String> = self.variables.iter().map(|&v| v.to_owned()).collect();
            // A name of one letter is one edit away from every other, so it gets no suggestion.
            let near = |v: &&str| v.chars().count() > 1 || v.eq_ignore_ascii_case(&name);
            let suggestion = nearest(&name, self.variables.iter().copied().filter(near)).map(str::to_owned);
            let kind = ExpressionErrorKind::UnknownVariable { name, suggestion, known };
            return Err(ExpressionError { kind, column });
        }
        Ok(true)
    }

    /// Skips white space and returns the next character, if there is one.
    fn peek(&mut self) -> Option<char> {
        while self.rest.get(self.at).is_some_and(|c| c.is_whitespace()) {
            self.at += 1;
        }
        self.rest.get(self.at).copied()
    }

    /// Returns the column of the next character, from 1.
    fn column(&mut self) -> usize {
        self.peek();
        self.at + 1
    }

    fn expected(&mut self, what: &'static str) -> ExpressionError {
        let column = self.column();
        let is_word = |c: &char| c.is_alphanumeric() || matches!(c, '_' | '.');
        let rest = &self.rest[self.at..];
        let word: String = rest.iter().copied().take_while(is_word).collect();
        let found =
            if word.is_empty() { rest.first().map(char::to_string).unwrap_or_default() } else { word };
        ExpressionError { kind: ExpressionErrorKind::Expected { what, found }, column }
    }
}
