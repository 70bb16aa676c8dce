//! Formulas as users write them: `M*b^2/6`, `sqrt(3)/2*b`, `-a + 3/4*b`.
//!
//! ```text
//! sum     = product { ("+" | "-") product }
//! product = factor { ("*" | "/") factor }
//! factor  = ("+" | "-") factor | power
//! power   = operand [ "^" ["-"] digits ]
//! operand = number | symbol | function "(" sum ")" | "(" sum ")"
//! ```

use crate::angle::Angle;
use crate::nearest::nearest;
use crate::parse_error::{ParseError, ParseErrorKind};
use crate::rational::Rational;
use crate::rational_function::RationalFunction;
use crate::symbols::Symbols;

/// Largest number of characters.
const LONGEST: usize = 1000;
/// Largest number of nested parentheses and signs.
const DEEPEST: usize = 50;
/// Largest absolute value of an exponent.
const LARGEST_EXPONENT: i32 = 12;
/// Largest number of terms of a numerator or denominator.
const MOST_TERMS: usize = 200;
/// Largest number of terms of a dividend, times those of a divisor with sines and roots and of its
/// conjugates.
const MOST_CONJUGATE_TERMS: usize = 5000;
/// Largest degree of a numerator or denominator.
const LARGEST_DEGREE: u32 = 40;

/// Returns the value of a formula in declared symbols.
///
/// ```
/// use polhode_algebra::{Kind, Symbols, parse};
/// let mut symbols = Symbols::new();
/// symbols.declare("b", Kind::Positive)?;
/// assert_eq!(parse("b/2 + b/3", &symbols)?, parse("5/6*b", &symbols)?);
/// let error = parse("b/2 + B", &symbols).unwrap_err();
/// assert_eq!((error.to_string().as_str(), error.column), ("column 7: unknown symbol `B`", 7));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`ParseError`], with the column.
pub fn parse(text: &str, symbols: &Symbols) -> Result<RationalFunction, ParseError> {
    let mut parser = Parser { text: text.chars().collect(), at: 0, depth: 0, symbols };
    if parser.text.len() > LONGEST {
        return Err(too_large("1000 characters", LONGEST));
    }
    let value = parser.sum()?;
    match parser.peek() {
        None => Ok(value),
        Some(_) => Err(parser.expected("an operator or the end of the formula")),
    }
}

struct Parser<'a> {
    text: Vec<char>,
    /// Number of characters already read.
    at: usize,
    /// Number of open parentheses and signs.
    depth: usize,
    symbols: &'a Symbols,
}

type Parsed = Result<RationalFunction, ParseError>;

impl Parser<'_> {
    fn sum(&mut self) -> Parsed {
        let mut sum = self.product()?;
        loop {
            let start = self.at;
            let term = match self.peek() {
                Some('+') => self.after(Self::product)?,
                Some('-' | '−') => -self.after(Self::product)?,
                _ => return Ok(sum),
            };
            sum = within_limits(sum.plus(&term), start)?;
        }
    }

    fn product(&mut self) -> Parsed {
        let mut product = self.factor()?;
        loop {
            let sign = self.peek();
            let start = self.at;
            product = match sign {
                Some('*' | '·') => product.times(&self.after(Self::factor)?),
                Some('/') => {
                    let divisor = self.after(Self::factor)?;
                    quotient(&product, &divisor, start + 1)?
                }
                _ => return Ok(product),
            };
            product = within_limits(product, start)?;
        }
    }

    fn factor(&mut self) -> Parsed {
        match self.peek() {
            Some('-' | '−') => Ok(-self.nested(Self::factor)?),
            Some('+') => self.nested(Self::factor),
            _ => self.power(),
        }
    }

    fn power(&mut self) -> Parsed {
        let base = self.operand()?;
        if self.peek() != Some('^') {
            return Ok(base);
        }
        self.at += 1;
        let _ = self.peek();
        let start = self.at;
        let sign = usize::from(matches!(self.text.get(start), Some('-' | '−')));
        let is_part = |c: &&char| c.is_alphanumeric() || matches!(c, '.' | '_');
        let length = self.text[start + sign..].iter().take_while(is_part).count();
        self.at = start + sign + length;
        let found: String = self.text[start..self.at].iter().collect();
        let exponent = found.replace('−', "-").parse::<i32>();
        let Some(exponent) = exponent.ok().filter(|e| e.abs() <= LARGEST_EXPONENT) else {
            let found = if length == 0 { self.text[start..].iter().take(1).collect() } else { found };
            return Err(error(ParseErrorKind::Exponent { found }, start));
        };
        let power = (0..exponent.abs())
            .try_fold(RationalFunction::one(), |power, _| within_limits(power.times(&base), start))?;
        if exponent < 0 { quotient(&RationalFunction::one(), &power, start) } else { Ok(power) }
    }

    fn operand(&mut self) -> Parsed {
        match self.peek() {
            Some('(') => self.parenthesis(),
            Some(c) if c.is_ascii_digit() || c == '.' => self.number(),
            Some(c) if c.is_alphabetic() => self.name(),
            _ => Err(self.expected("a number, a symbol or (")),
        }
    }

    fn parenthesis(&mut self) -> Parsed {
        let value = self.nested(Self::sum)?;
        match self.peek() {
            Some(')') => {
                self.at += 1;
                Ok(value)
            }
            _ => Err(self.expected("an operator or )")),
        }
    }

    fn number(&mut self) -> Parsed {
        let start = self.at;
        let digits =
            |at: usize| self.text[at..].iter().take_while(|c| c.is_ascii_digit() || **c == '.').count();
        let mut end = start + digits(start);
        if matches!(self.text.get(end), Some('e' | 'E')) {
            let sign = usize::from(matches!(self.text.get(end + 1), Some('+' | '-')));
            let exponent = digits((end + 1 + sign).min(self.text.len()));
            if exponent > 0 {
                end += 1 + sign + exponent;
            }
        }
        self.at = end;
        let text: String = self.text[start..end].iter().collect();
        let number = text.parse::<Rational>();
        number.map(Into::into).map_err(|kind| error(ParseErrorKind::Number(kind), start))
    }

    fn name(&mut self) -> Parsed {
        let start = self.at;
        let is_part = |c: &&char| c.is_alphanumeric() || **c == '_';
        self.at += self.text[start..].iter().take_while(is_part).count();
        let name: String = self.text[start..self.at].iter().collect();
        if let Some(symbol) = self.symbols.find(&name) {
            return Ok(symbol.into());
        }
        if self.peek() != Some('(') {
            let known: Vec<String> = self.symbols.names().map(str::to_owned).collect();
            let suggestion = nearest(&name, self.symbols.names()).map(str::to_owned);
            return Err(error(ParseErrorKind::UnknownSymbol { name, suggestion, known }, start));
        }
        let place = self.at;
        let argument = match name.as_str() {
            "sqrt" | "sin" | "cos" => self.parenthesis()?,
            _ => return Err(error(ParseErrorKind::UnknownFunction { name }, start)),
        };
        if name == "sqrt" {
            let number = argument.as_constant();
            let root = number.and_then(|number| RationalFunction::square_root_of(&number));
            return root.ok_or_else(|| error(ParseErrorKind::SquareRoot, place));
        }
        let angle = Angle::new(&argument).ok_or_else(|| error(ParseErrorKind::Angle, place))?;
        within_limits(if name == "sin" { angle.sine() } else { angle.cosine() }, place)
    }

    /// Reads a part after the present character, which is one level deeper.
    fn nested(&mut self, part: impl Fn(&mut Self) -> Parsed) -> Parsed {
        if self.depth == DEEPEST {
            return Err(too_large("50 nested parentheses and signs", self.at));
        }
        self.depth += 1;
        let value = self.after(part)?;
        self.depth -= 1;
        Ok(value)
    }

    fn after(&mut self, part: impl Fn(&mut Self) -> Parsed) -> Parsed {
        self.at += 1;
        part(self)
    }

    /// Returns the next character that is not a space.
    fn peek(&mut self) -> Option<char> {
        while self.text.get(self.at).is_some_and(|c| c.is_whitespace()) {
            self.at += 1;
        }
        self.text.get(self.at).copied()
    }

    fn expected(&self, what: &'static str) -> ParseError {
        let rest = &self.text[self.at.min(self.text.len())..];
        let word = rest.iter().take_while(|c| c.is_alphanumeric()).count().clamp(1, 20);
        error(ParseErrorKind::Expected { what, found: rest.iter().take(word).collect() }, self.at)
    }
}

/// Returns the error at a place, which counts from 0.
const fn error(kind: ParseErrorKind, place: usize) -> ParseError {
    ParseError { kind, column: place + 1 }
}

const fn too_large(limit: &'static str, place: usize) -> ParseError {
    error(ParseErrorKind::TooLarge { limit }, place)
}

fn quotient(dividend: &RationalFunction, divisor: &RationalFunction, place: usize) -> Parsed {
    // Each sine and root squares the number of terms, by the conjugate of the denominator.
    let roots = divisor.numerator().variables().into_iter().filter(|v| v.is_algebraic()).count() as u32;
    let conjugates = divisor.numerator().term_count().checked_pow(2u32.saturating_pow(roots));
    let terms = dividend.numerator().term_count() * divisor.denominator().term_count();
    if roots > 0 && conjugates.is_none_or(|count| count > 1000 || count * terms > MOST_CONJUGATE_TERMS) {
        return Err(too_large("5000 terms during a division by sines and roots", place));
    }
    dividend.over(divisor).ok_or_else(|| error(ParseErrorKind::DivisionByZero, place))
}

/// Bounds time and memory: gcds of larger polynomials take long.
fn within_limits(value: RationalFunction, place: usize) -> Parsed {
    for part in [value.numerator(), value.denominator()] {
        if part.term_count() > MOST_TERMS {
            return Err(too_large("200 terms", place));
        }
        if part.degree() > LARGEST_DEGREE {
            return Err(too_large("a degree of 40", place));
        }
    }
    Ok(value)
}
