//! Completion at a position in the text of a scenario.
//!
//! Completions come from the reader itself. The line at the cursor is removed, or gets a
//! placeholder value. The requests of the reader at that place are the possible contents.

use std::ops::Range;

use polhode_source::toml::{Question, What};
use polhode_source::unit;

use super::TOP;

/// Completions at a position in a text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Completion {
    /// Bytes of the text that the chosen completion replaces.
    pub place: Range<usize>,
    /// Possible completions.
    pub suggested: Vec<Suggested>,
}

/// One possible completion.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Suggested {
    /// Text to insert.
    pub text: String,
    /// Description of the completion.
    pub detail: String,
}

/// Tables that may occur several times.
const SEVERAL: [&str; 4] = ["torque", "wheel", "event", "pointing"];

/// Placeholder: not a valid name, but a number, for which the reader requests a dimension before it
/// refuses it.
const NOTHING: &str = "0";

/// Returns the completions at byte `at` of a text. `ask` returns the reader's requests for a text,
/// or `None` if it is not TOML.
pub(crate) fn complete(
    text: &str,
    at: usize,
    ask: impl Fn(&str) -> Option<Vec<Question>>,
) -> Option<Completion> {
    let before = text.get(..at)?;
    let start = before.rfind('\n').map_or(0, |end| end + 1);
    let end = text[at..].find('\n').map_or(text.len(), |length| at + length);
    let line = Line { text, start, at, end };
    let written = &text[start..at];
    if written.contains('#') {
        return None;
    }
    match written.split_once('=') {
        None if written.trim_start().starts_with('[') => Some(line.headers()),
        None => line.keys(&ask(&line.with(""))?),
        Some((key, value)) => {
            let open = |bracket: char, closing: char| value.rfind(bracket) > value.rfind(closing);
            // Returns the requests for this line with another value.
            let asked = |instead: &str| {
                let other = format!("{key}= {instead}");
                let here = start..start + other.len();
                let mut asked = ask(&line.with(&other))?;
                asked.retain(|question| !question.span.is_empty() && here.contains(&question.span.start));
                Some(asked)
            };
            if open('{', '}') {
                line.inner_keys(&asked("{}")?, value)
            } else if open('[', ']') {
                let three = format!("[{NOTHING}, {NOTHING}, {NOTHING}]");
                line.values(&asked(&three)?, value.rfind(['[', ',']).map_or(0, |k| k + 1))
            } else {
                line.values(&asked(NOTHING)?, 0)
            }
        }
    }
}

/// Line at the cursor.
struct Line<'a> {
    text: &'a str,
    start: usize,
    at: usize,
    end: usize,
}

impl Line<'_> {
    /// Returns the text with this line replaced.
    fn with(&self, line: &str) -> String {
        format!("{}{line}{}", &self.text[..self.start], &self.text[self.end..])
    }

    fn headers(&self) -> Completion {
        let indent = self.text[self.start..self.at].find('[').unwrap_or_default();
        let header = |key: &&str| match *key {
            "title" => None,
            "body" => Some("[[body.part]]".to_owned()),
            key if SEVERAL.contains(&key) => Some(format!("[[{key}]]")),
            key => Some(format!("[{key}]")),
        };
        let suggested = |text| Suggested { text, detail: "a table".to_owned() };
        let suggested = TOP.iter().filter_map(header).map(suggested).collect();
        Completion { place: self.start + indent..self.end, suggested }
    }

    /// Completes keys of the last table whose header is before the line, without the keys that it
    /// has already.
    fn keys(&self, asked: &[Question]) -> Option<Completion> {
        let is_header = |span: &Range<usize>| {
            span.end <= self.start && (span.is_empty() || self.text[span.start..].starts_with('['))
        };
        let tables = asked.iter().filter_map(|question| match &question.what {
            What::Keys(name, keys) if is_header(&question.span) => Some((&question.span, name, keys)),
            _ => None,
        });
        // For a table requested twice, the later request has more information.
        let (table, name, keys) = tables.max_by_key(|(table, ..)| table.end)?;
        let is_top = table.is_empty();
        let is_header = |line: &str| line.trim_start().starts_with('[');
        // The line follows the header of a table that the reader has not reached.
        if self.text[table.end..self.start].lines().skip(usize::from(!is_top)).any(is_header) {
            return None;
        }
        let own = self.text[table.start..].lines().skip(usize::from(!is_top));
        let own = own.take_while(|line| !is_header(line)).filter_map(|line| line.split_once('='));
        let has: Vec<&str> = own.map(|(key, _)| key.trim()).collect();
        let suggested = keys
            .iter()
            .filter(|key| !has.contains(*key))
            .map(|key| Suggested { text: (*key).to_owned(), detail: name.clone() });
        Some(Completion { place: self.word()..self.at, suggested: suggested.collect() })
    }

    /// Completes keys of the inline table at the end of the line.
    fn inner_keys(&self, asked: &[Question], value: &str) -> Option<Completion> {
        // A value follows an equals sign.
        if value.rsplit(['{', ',']).next().is_some_and(|last| last.contains('=')) {
            return None;
        }
        let (name, keys) = asked.iter().rev().find_map(|question| match &question.what {
            What::Keys(name, keys) => Some((name, keys)),
            _ => None,
        })?;
        let suggested = keys.iter().map(|key| Suggested { text: (*key).to_owned(), detail: name.clone() });
        Some(Completion { place: self.word()..self.at, suggested: suggested.collect() })
    }

    /// Completes names or units in the value that starts at byte `from` after the equals sign.
    fn values(&self, asked: &[Question], from: usize) -> Option<Completion> {
        let equals = self.start + self.text[self.start..self.at].find('=')? + 1;
        let written = &self.text[equals + from..self.at];
        let place = equals + from + (written.len() - written.trim_start().len())..self.at;
        let quoted = |text: &str| format!("\"{text}\"");
        let suggested = asked.iter().rev().find_map(|question| match &question.what {
            What::Choice(names) => Some(
                names
                    .iter()
                    .map(|name| Suggested { text: quoted(name), detail: "a name".to_owned() })
                    .collect::<Vec<_>>(),
            ),
            What::Quantity(dimension) => {
                let number = unit::number_of(written.trim().trim_matches('"'));
                let (number, detail) = (number.unwrap_or_else(|| "1".to_owned()), dimension.to_string());
                let one = |unit: &&str| Suggested {
                    text: quoted(&format!("{number} {unit}")),
                    detail: detail.clone(),
                };
                let units = unit::units_of(*dimension);
                (!units.is_empty()).then(|| units.iter().map(one).collect())
            }
            What::Keys(..)
            | What::Number
            | What::Count
            | What::Text
            | What::Truth
            | What::Array(_)
            | What::PerhapsArray
            | What::Table
            | What::AnyKeys
            | What::Required(_) => None,
        })?;
        Some(Completion { place, suggested })
    }

    /// Returns the start of the word that ends at the cursor.
    fn word(&self) -> usize {
        let is_part = |c: char| c.is_ascii_alphanumeric() || c == '_';
        self.text[self.start..self.at].rfind(|c| !is_part(c)).map_or(self.start, |k| self.start + k + 1)
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use super::super::Draft;

    /// Returns the completions at the position of the bar in the text.
    fn at(text: &str) -> Vec<String> {
        let at = text.find('|').unwrap();
        let found = Draft::new("a.toml".as_ref(), []).complete(&text.replace('|', ""), at);
        found.into_iter().flat_map(|found| found.suggested).map(|one| one.text).collect()
    }

    const BALL: &str = "[[body.part]]\nshape = \"sphere\"\nradius = \"2 cm\"\nmass = \"3 kg\"\n";

    #[test]
    fn keys_are_those_that_the_reader_takes_there() {
        let keys =
            at("[[body.part]]\nshape = \"cylinder\"\nradius = \"2 cm\"\nle|\n[run]\nduration = \"1 s\"\n");
        assert!(keys.contains(&"length".to_owned()) && keys.contains(&"material".to_owned()), "{keys:?}");
        assert!(
            !keys.contains(&"radius".to_owned()) && !keys.contains(&"tube_radius".to_owned()),
            "{keys:?}"
        );
        let keys = at(&format!("{BALL}[run]\ndu|"));
        assert!(keys.contains(&"duration".to_owned()) && keys.contains(&"samples".to_owned()), "{keys:?}");
        assert!(at(&format!("{BALL}[start]\nspin = {{ b|")).contains(&"body".to_owned()));
        // Contents after an invalid table are unknown.
        assert_eq!(at("[[body.part]]\nshape = \"sphere\"\nradius = 3\n[run]\ndu|"), [""; 0]);
        let top = at("t|\n[[body.part]]\nshape = \"box\"\n");
        assert!(top.contains(&"title".to_owned()), "{top:?}");
    }

    #[test]
    fn values_are_names_or_have_units() {
        let models = at(&format!("{BALL}[[torque]]\nmodel = \"gr|\n"));
        assert!(models.contains(&"\"gravity_gradient\"".to_owned()), "{models:?}");
        let units = at("[[body.part]]\nshape = \"sphere\"\nradius = \"2.5|\nmass = \"3 kg\"\n");
        assert!(
            units.contains(&"\"2.5 mm\"".to_owned()) && units.contains(&"\"2.5 in\"".to_owned()),
            "{units:?}"
        );
        let units = at(&format!(
            "{BALL}[start]\nspin = {{ body = [\"1 rad/s\", 0, 0] }}\n[[torque]]\nmodel = \"constant\"\naxes = \"body\"\ntorque = [0, 3|\n"
        ));
        assert!(units.contains(&"\"3 N m\"".to_owned()), "{units:?}");
        let density = at("[[body.part]]\nshape = \"sphere\"\nradius = 1\ndensity = |\n");
        assert!(density.contains(&"\"1 kg/m^3\"".to_owned()), "{density:?}");
    }

    #[test]
    fn headers_are_the_tables_of_a_scenario() {
        let headers = at("[[body.part]]\nshape = \"sphere\"\nradius = 1\nmass = 1\n[|");
        for header in ["[[body.part]]", "[start]", "[[torque]]", "[run]"] {
            assert!(headers.contains(&header.to_owned()), "{headers:?}");
        }
        assert_eq!(at("# a comment = |"), [""; 0]);
        // Requests for other lines are ignored.
        assert_eq!(at(&format!("title = |\n{BALL}[run]\nduration = \"1 s\"\nsamples = 2\n")), [""; 0]);
        assert_eq!(at(&format!("title = {{ |\n{BALL}[start]\nspin = {{ body = [1, 2, 3] }}\n")), [""; 0]);
    }
}
