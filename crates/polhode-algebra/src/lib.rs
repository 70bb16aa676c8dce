#![doc = include_str!("../README.md")]
#![forbid(unsafe_code)]

mod angle;
mod calculus;
mod evaluate;
mod formula;
mod gcd;
mod heuristic_gcd;
mod integer;
mod lifting;
mod matrix;
mod monomial;
mod nearest;
mod operators;
mod parse;
mod parse_error;
mod polynomial;
mod printed;
mod rational;
mod rational_function;
mod roots;
mod source;
mod square_free;
mod square_root;
mod symbol;
mod symbols;
mod typeset;
mod univariate;
mod vector;

pub use angle::Angle;
pub use formula::{Accent, Fence, Formula, Large, Operator, Relation, Style};
pub use gcd::{content_in, gcd, gcd_of, lcm};
pub use matrix::Matrix;
pub use monomial::Monomial;
pub use parse::parse;
pub use parse_error::{ParseError, ParseErrorKind};
pub use polynomial::Polynomial;
pub use rational::{Rational, RationalError};
pub use rational_function::RationalFunction;
pub use roots::{RemainingRoots, RootPair, Roots};
pub use square_free::{Factors, factors};
pub use square_root::SquareRoot;
pub use symbol::{Symbol, Variable};
pub use symbols::{Kind, SymbolError, Symbols};
pub use univariate::Univariate;
pub use vector::Vector;
