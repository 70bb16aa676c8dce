//! Heading of a figure: title, names of the curves, and remarks.

use super::axes::Area;
use super::font;
use super::sheet::{Anchor, Colour, LARGE, Mark, Pen, SMALL, Sheet, Text};

/// Distance between lines of text, px.
const LINE: f64 = 17.0;
/// Length of the line sample in front of a name, px.
const SAMPLE: f64 = 24.0;
const GAP: f64 = 6.0;
const SPACE: f64 = 18.0;

/// Entry of a legend.
#[derive(Clone, Debug, PartialEq)]
pub struct Key {
    sample: Option<(Pen, bool)>,
    name: String,
}

impl Key {
    /// Creates an entry with a line sample.
    pub fn line(pen: Pen, name: impl Into<String>) -> Self {
        Self { sample: Some((pen, false)), name: name.into() }
    }

    /// Creates an entry with a dot.
    pub fn dot(pen: Pen, name: impl Into<String>) -> Self {
        Self { sample: Some((pen, true)), name: name.into() }
    }

    /// Creates a remark, printed below the names of the curves. It is broken at spaces, but not
    /// inside numbers.
    pub fn words(text: impl Into<String>) -> Self {
        Self { sample: None, name: text.into() }
    }
}

/// Writes the title of a figure, its subject at the right, and the keys below; returns the height
/// used, px.
pub fn heading(sheet: &mut Sheet, area: Area, title: &str, subject: &str, keys: &[Key]) -> f64 {
    let base = area.top + LARGE;
    let title_text = font::fitted(title, LARGE, area.width());
    let used = font::width(&title_text, LARGE);
    let text = Text::small([area.left, base], Anchor::Start, Colour::BLACK, &title_text);
    sheet.marks.push(Mark::Text(Text { size: LARGE, ..text }));
    let room = area.width() - used - 2.0 * SPACE;
    if room > 60.0 && !subject.is_empty() {
        let subject = font::fitted(subject, SMALL, room);
        sheet.text([area.right, base], Anchor::End, Colour::FAINT, &subject);
    }
    if keys.is_empty() {
        return LARGE + GAP;
    }
    let (mut x, mut y) = (area.left, base + 1.3 * LINE);
    let (curves, words): (Vec<&Key>, Vec<&Key>) = keys.iter().partition(|key| key.sample.is_some());
    for key in curves {
        let name = font::fitted(&key.name, SMALL, area.width() - SAMPLE - GAP);
        let width = SAMPLE + GAP + font::width(&name, SMALL);
        if x > area.left && x + width > area.right {
            (x, y) = (area.left, y + LINE);
        }
        let line = y - 0.36 * SMALL;
        match key.sample {
            Some((pen, true)) => sheet.dots(vec![[x + 0.5 * SAMPLE, line]], pen),
            Some((pen, false)) => sheet.line(vec![[x, line], [x + SAMPLE, line]], pen),
            None => {}
        }
        sheet.text([x + SAMPLE + GAP, y], Anchor::Start, Colour::TEXT, &name);
        x += width + SPACE;
    }
    if x > area.left && !words.is_empty() {
        (x, y) = (area.left, y + LINE);
    }
    for key in words {
        let width = font::width(&key.name, SMALL);
        if x > area.left && x + width > area.right {
            (x, y) = (area.left, y + LINE);
        }
        let lines = broken(&key.name, area.width());
        for (k, line) in lines.iter().enumerate() {
            y += if k > 0 { LINE } else { 0.0 };
            sheet.text([x, y], Anchor::Start, Colour::TEXT, line);
        }
        // A remark of several lines ends its row.
        x += if lines.len() > 1 { area.width() } else { width } + SPACE;
    }
    y - area.top + GAP + 5.0
}

/// Breaks a text into lines of at most `room` px; a single wider word is shortened.
fn broken(text: &str, room: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split(' ') {
        match lines.last_mut() {
            Some(line) if font::width(&format!("{line} {word}"), SMALL) <= room => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(font::fitted(word, SMALL, room)),
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_broken_at_spaces_and_numbers_are_not() {
        let text = "T + U = 3.73784\u{a0}J, constant to 6.8×10⁻¹⁷";
        let lines = broken(text, 130.0);
        assert_eq!(lines, ["T + U = 3.73784\u{a0}J,", "constant to 6.8×10⁻¹⁷"]);
        assert_eq!(broken(text, 1000.0), [text]);
    }

    #[test]
    fn what_is_said_stands_below_the_names() {
        let mut sheet = Sheet::new(500.0, 200.0, String::new());
        let area = Area { left: 10.0, top: 10.0, right: 400.0, bottom: 190.0 };
        let pen = Pen::axis(0);
        let keys = [Key::words("a = 1"), Key::line(pen, "b"), Key::line(pen, "c")];
        let used = heading(&mut sheet, area, "title", "", &keys);
        let at = |name: &str| {
            let mut texts = sheet.marks.iter().filter_map(|mark| match mark {
                Mark::Text(text) => Some(text),
                _ => None,
            });
            texts.find(|text| text.content == name).unwrap().at
        };
        assert!(at("b")[1] == at("c")[1] && at("a = 1")[1] == at("b")[1] + LINE);
        assert!(at("a = 1")[0] == area.left && area.top + used > at("a = 1")[1]);
    }
}
