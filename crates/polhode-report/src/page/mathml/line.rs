//! A line of working as MathML: `L1 = 0.5·0 + 2e-3·(-1) = -0.002 kg·m²/s`.
//!
//! Single letters are symbols, with the digits after them as a subscript and ², ³ as a power; numbers keep their groups and
//! get ×10ⁿ for e; words and units are upright. Nothing is refused: what is no mathematics is text.

use super::{element, number, space};

/// Letters that a combining mark may stand on, and what follows is a mark.
const MARKS: std::ops::RangeInclusive<char> = '\u{300}'..='\u{36f}';

pub(super) fn to_mathml(text: &str) -> String {
    let mut out = String::new();
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let (shown, used) = token(rest, first);
        out.push_str(&shown);
        // Every token takes a character at least.
        rest = rest.get(used.max(first.len_utf8())..).unwrap_or_default();
    }
    out
}

/// The first piece of a line, and how many bytes it takes.
fn token(rest: &str, first: char) -> (String, usize) {
    let length = |keep: &dyn Fn(char) -> bool| rest.find(|c| !keep(c)).unwrap_or(rest.len());
    if first.is_ascii_digit() {
        let end = end_of_number(rest);
        return (number(&rest[..end]), end);
    }
    if first == ' ' || first == '\u{a0}' {
        let end = length(&|c| c == ' ' || c == '\u{a0}');
        // One space is spelling; more set things apart.
        let wide = if rest[..end].chars().count() > 1 { space(1.5) } else { String::new() };
        return (wide, end);
    }
    if first.is_alphabetic() {
        let end = length(&|c| c.is_alphabetic() || MARKS.contains(&c));
        let letters = &rest[..end];
        if letters.chars().filter(|c| !MARKS.contains(c)).count() == 1 && !is_unit_before(rest, end) {
            return symbol(rest, end);
        }
        return words(rest);
    }
    let shown = match first {
        '-' => element("mo", "−"),
        '(' | ')' | '[' | ']' | '{' | '}' | '|' => format!("<mo stretchy=\"false\">{first}</mo>"),
        _ => element("mo", &first.to_string()),
    };
    (shown, first.len_utf8())
}

/// `5.438 13e-5`: a group of digits follows a no-break space.
fn end_of_number(text: &str) -> usize {
    let bytes = text.as_bytes();
    let digit = |k: usize| bytes.get(k).is_some_and(u8::is_ascii_digit);
    let mut k = 0;
    loop {
        match bytes.get(k) {
            Some(b'0'..=b'9') => k += 1,
            Some(b'.') if digit(k + 1) => k += 1,
            Some(b'e') if digit(k + 1) => k += 1,
            Some(b'e') if bytes.get(k + 1) == Some(&b'-') && digit(k + 2) => k += 2,
            Some(0xC2) if bytes.get(k + 1) == Some(&0xA0) && digit(k + 2) => k += 2,
            _ => return k,
        }
    }
}

/// True for `m/s`, `m²`, `N·m`, `J` at the end of a line: a letter that goes on as a unit does.
fn is_unit_before(rest: &str, end: usize) -> bool {
    const UNITS: [&str; 8] = ["m/s", "m²", "N·m", "s²", "m³", "J/", "N,", "m,"];
    let after = rest[end..].trim_end();
    UNITS.iter().any(|unit| rest.starts_with(unit)) || after.is_empty() && "mNJsW".contains(&rest[..end])
}

/// One letter with its subscript and its power.
fn symbol(rest: &str, end: usize) -> (String, usize) {
    let mut used = end;
    let letter = element("mi", &rest[..end]);
    let tail = &rest[end..];
    let digits = tail.find(|c: char| !c.is_ascii_digit()).unwrap_or(tail.len());
    let below = match tail.strip_prefix('_') {
        Some(word) => {
            let length = word.find(|c: char| !c.is_alphanumeric()).unwrap_or(word.len());
            used += 1 + length;
            Some(element("mtext", &word[..length]))
        }
        None if digits > 0 => {
            used += digits;
            Some(element("mn", &tail[..digits]))
        }
        None => None,
    };
    let power = rest[used..].chars().next().and_then(|c| match c {
        '²' => Some("2"),
        '³' => Some("3"),
        _ => None,
    });
    used += if power.is_some() { '²'.len_utf8() } else { 0 };
    let shown = match (below, power.map(|p| element("mn", p))) {
        (None, None) => letter,
        (Some(b), None) => format!("<msub>{letter}{b}</msub>"),
        (None, Some(p)) => format!("<msup>{letter}{p}</msup>"),
        (Some(b), Some(p)) => format!("<msubsup>{letter}{b}{p}</msubsup>"),
    };
    (shown, used)
}

/// Words and units up to something that is neither.
fn words(rest: &str) -> (String, usize) {
    let spelled = |c: char| c.is_alphabetic() || MARKS.contains(&c) || "·²³/⁻¹_'’".contains(c);
    let end = rest.find(|c| !spelled(c)).unwrap_or(rest.len());
    let digits = rest[end..].find(|c: char| !c.is_ascii_digit()).unwrap_or(rest.len() - end);
    let end = end + digits;
    let before = if end == rest.len() { "" } else { "\u{a0}" };
    (element("mtext", &format!("\u{a0}{}{before}", &rest[..end])), end)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn symbols_numbers_and_units() {
        assert_eq!(
            to_mathml("L1 = 2.5e-3·(-4) kg·m²/s"),
            "<msub><mi>L</mi><mn>1</mn></msub><mo>=</mo><mrow><mn>2.5</mn><mo>×</mo><msup><mn>10</mn><mn>−3</mn></msup></mrow>\
             <mo>·</mo><mo stretchy=\"false\">(</mo><mo>−</mo><mn>4</mn><mo stretchy=\"false\">)</mo><mtext>\u{a0}kg·m²/s</mtext>"
        );
        assert_eq!(to_mathml("T_rot"), "<msub><mi>T</mi><mtext>rot</mtext></msub>");
        assert_eq!(
            to_mathml("ω\u{307}2²"),
            "<msubsup><mi>ω\u{307}</mi><mn>2</mn><mn>2</mn></msubsup>"
        );
        assert_eq!(to_mathml("5.438\u{a0}13 J"), "<mn>5.438\u{a0}13</mn><mtext>\u{a0}J</mtext>");
    }

    #[test]
    fn nothing_in_a_line_is_markup() {
        let shown = to_mathml("<script>alert('x')</script> & \"y\"");
        assert!(!shown.contains("<script") && !shown.contains("</script"), "{shown}");
        assert!(shown.contains("&lt;") && shown.contains("&amp;"), "{shown}");
    }

    #[test]
    fn every_line_ends() {
        for line in ["", "e", "1e", "1.", "é1_", "²", "\u{307}", "a\u{a0}", "½ ω · L → ∞", "{I}⁻¹"] {
            let _ = to_mathml(line);
        }
    }
}
