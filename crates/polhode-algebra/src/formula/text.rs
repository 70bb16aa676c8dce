//! Writer of formulas as Unicode text.
//!
//! Quotients are written a/b, also those of numbers: 2/3 next to 11/12 in one matrix reads better
//! than ⅔ next to 11/12, can be searched for, and is read back by [`crate::parse`]. Matrices, cases
//! and rows take several lines.

use super::block::{Align, Block};
use super::letter::{subscript, superscript};
use super::level::Quotients;
use super::writer::{Table, Writer, write};
use super::{Accent, Fence, Formula, Large, Relation, Style};

struct Text;

impl Formula {
    /// Returns the formula as Unicode text of one or several lines: `−1/4 M b²`.
    pub fn to_text(&self) -> String {
        write::<Text>(self).into_text()
    }
}

impl Writer for Text {
    type Piece = Block;

    const QUOTIENTS: Quotients = Quotients::Linear;

    fn number(digits: &str) -> Block {
        Block::line(digits)
    }

    fn letter(text: &str, _: Style) -> Block {
        Block::line(text)
    }

    fn words(text: &str) -> Block {
        Block::line(text)
    }

    fn prefix(sign: &str) -> Block {
        Block::line(sign)
    }

    fn infix(sign: &str) -> Block {
        Block::line(if sign == "," { ", ".to_owned() } else { format!(" {sign} ") })
    }

    fn juxtaposed(_: bool, _: bool) -> Block {
        Block::line(" ")
    }

    fn application(is_bare: bool, is_operator: bool) -> Block {
        Block::line(if is_bare || is_operator { " " } else { "" })
    }

    fn relation(sign: Relation, is_first: bool) -> Block {
        Block::line(format!("{}{} ", if is_first { "" } else { " " }, sign.sign()))
    }

    fn row(pieces: Vec<Block>) -> Block {
        Block::row(pieces)
    }

    fn fraction(above: Block, below: Block) -> Block {
        Block::row([above, Block::line("/"), below])
    }

    fn scripts(base: Block, index: Option<&Formula>, exponent: Option<&Formula>) -> Block {
        let index = index.map_or_else(String::new, |index| subscript(&index.to_text()));
        let exponent = exponent.map_or_else(String::new, |exponent| superscript(&exponent.to_text()));
        Block::row([base, Block::line(index + &exponent)])
    }

    fn root(value: &Formula) -> Block {
        let inside = write::<Self>(value);
        let is_single = matches!(
            value,
            Formula::Number(_) | Formula::Letter(..) | Formula::Subscript(..) | Formula::Accent(..)
        );
        let inside = if is_single { inside } else { inside.fenced(Fence::Parentheses) };
        Block::row([Block::line("√"), inside])
    }

    /// Puts the mark above the first letter: it follows that letter in Unicode.
    fn accent(accent: Accent, base: &Formula) -> Block {
        let mark = match accent {
            Accent::Dot => '\u{307}',
            Accent::DoubleDot => '\u{308}',
            Accent::TripleDot => '\u{20db}',
            Accent::Hat => '\u{302}',
            Accent::Bar => '\u{304}',
        };
        let text = base.to_text();
        // Unicode has these as one character each.
        if let (Accent::Hat, Some(letter)) = (accent, text.chars().next())
            && let Some((_, joined)) = [('y', 'ŷ'), ('z', 'ẑ')].into_iter().find(|(base, _)| *base == letter)
        {
            return Block::line(format!("{joined}{}", &text[1..]));
        }
        let letter = text.chars().next().map_or(0, char::len_utf8);
        Block::line(format!("{}{mark}{}", &text[..letter], &text[letter..]))
    }

    fn limits(operator: Large, below: Option<&Formula>, above: Option<&Formula>) -> Block {
        let sign = match operator {
            Large::Sum => "Σ",
            Large::Integral => "∫",
        };
        Block::row([Self::scripts(Block::line(sign), below, above), Block::line(" ")])
    }

    fn fenced(fence: Fence, inside: Block, _: bool) -> Block {
        inside.fenced(fence)
    }

    fn table(table: Table, mut rows: Vec<Vec<Block>>) -> Block {
        match table {
            Table::Matrix { fence, is_numeric } => {
                let align = if is_numeric { Align::Right } else { Align::Center };
                let grid = Block::grid(rows, |_| align, "  ");
                Block::row([Block::line(" "), grid, Block::line(" ")]).fenced(fence)
            }
            Table::Cases => {
                rows.iter_mut().for_each(|row| row.insert(1, Block::line("if")));
                Block::grid(rows, |_| Align::Left, " ").braced()
            }
            Table::Rows => Block::grid(rows, |k| if k == 0 { Align::Right } else { Align::Left }, " "),
        }
    }
}
