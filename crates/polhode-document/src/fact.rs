//! Facts about a result: one list from which text, JSON and page rows are generated.

use serde_json::{Map, Value, json};

use crate::layout::{columns, labelled_from, plain_spaces};
use crate::number::{
    DIGITS, count, error, has_digits, number, quaternion, tidy, tidy_beside, typeset, vector, vector_within,
    within,
};
use crate::si_prefix::fitting;
use crate::unit;

/// Column at which a value starts on the screen.
const COLUMN: usize = 22;

/// Largest useful attitude error, rad; beyond it no digit of the attitude is correct.
pub const LARGEST_ATTITUDE_ERROR: f64 = 0.1;

/// Text for a value whose error is as large as the value.
pub const NO_RIGHT_DIGIT: &str = "no digit is right (estimate)";

/// Facts about one subject.
#[derive(Clone, Debug)]
pub struct Facts {
    /// Title in text and pages.
    title: String,
    /// Facts in the order of the text; new keys of the JSON come in this order too.
    facts: Vec<Fact>,
}

/// One result, with its key, label and value.
///
/// ```
/// use polhode_document::fact::{Fact, Facts, Quantity, object};
/// let period = Fact::new("motion.period_s", "period of ω", Quantity::Duration(7.655)).note("in the body");
/// let growth = Fact::new("motion.growth_rate_per_s", "growth rate", None);
/// let facts = [Facts::new("Motion", vec![period, growth])];
/// assert_eq!(facts[0].to_text(false), "Motion\n  period of ω         7.655 s, in the body\n");
/// let json = serde_json::json!({ "motion": { "period_s": 7.655, "growth_rate_per_s": null } });
/// assert_eq!(object(&["motion"], &facts), *json.as_object().unwrap());
/// ```
#[derive(Clone, Debug)]
pub struct Fact {
    /// Path in the JSON, keys separated by dots; empty for a fact that is not in the JSON.
    key: String,
    /// Label in text and pages; empty for a fact that is only in the JSON.
    label: String,
    value: Quantity,
    /// Estimated error of the value, in its SI unit; text ends at the first uncertain digit.
    error: f64,
    /// Size of the terms of the value: parts that are rounding of it are shown as 0.
    scale: f64,
    digits: usize,
    note: String,
    is_detail: bool,
}

/// Value of a fact: in SI units in the JSON, with a suitable prefix in text.
#[derive(Clone, Debug)]
pub enum Quantity {
    /// Not applicable: `null` in the JSON, no line in text.
    None,
    /// Number with its unit.
    Number(f64, &'static str),
    /// Three numbers with their unit.
    Vector([f64; 3], &'static str),
    /// Unit quaternion w, x, y, z; its error is that of the attitude, rad.
    Attitude([f64; 4]),
    /// Least and greatest value with their unit.
    Range([f64; 2], &'static str),
    /// Estimate of an error, with its unit.
    Error(f64, &'static str),
    /// Time or duration, s.
    Duration(f64),
    /// Angular velocity, rad/s.
    Rate(f64),
    /// Angle, rad; in degrees in text.
    Angle(f64),
    /// Least and greatest angle, rad.
    Angles([f64; 2]),
    /// Energy or work, J.
    Energy(f64),
    /// Integer count of items.
    Count(u64),
    /// Word in the JSON, and its form in text.
    Word(&'static str, String),
    /// Text in both the JSON and the text.
    Text(String),
    /// Structured part of the JSON, and its text.
    Data(Value, String),
    /// List of objects in the JSON; a table for people, of those that have a title.
    Table(Vec<Facts>),
}

impl From<Option<Self>> for Quantity {
    fn from(value: Option<Self>) -> Self {
        value.unwrap_or(Self::None)
    }
}

impl From<Value> for Quantity {
    fn from(json: Value) -> Self {
        Self::Data(json, String::new())
    }
}

impl From<String> for Quantity {
    fn from(text: String) -> Self {
        Self::Text(text)
    }
}

impl Fact {
    /// Creates a fact for text and JSON.
    pub fn new(key: impl Into<String>, label: impl Into<String>, value: impl Into<Quantity>) -> Self {
        let (key, label, value) = (key.into(), label.into(), value.into());
        Self {
            key,
            label,
            value,
            error: 0.0,
            scale: 0.0,
            digits: DIGITS,
            note: String::new(),
            is_detail: false,
        }
    }

    /// Creates a fact for the JSON only.
    pub fn data(key: impl Into<String>, value: impl Into<Quantity>) -> Self {
        Self::new(key, "", value)
    }

    /// Creates a fact for text only.
    pub fn shown(label: impl Into<String>, value: impl Into<Quantity>) -> Self {
        Self::new("", label, value)
    }

    /// Sets the remark after the value.
    #[must_use]
    pub fn note(self, note: impl Into<String>) -> Self {
        Self { note: note.into(), ..self }
    }

    /// Sets the estimated error of the value, in its SI unit.
    #[must_use]
    pub fn within(self, error: f64) -> Self {
        Self { error, ..self }
    }

    /// States in text that no digit of the value is right.
    #[must_use]
    pub fn without_digits(self) -> Self {
        self.within(f64::INFINITY)
    }

    /// Sets the size of the terms that the value is computed from, in its SI unit; text shows rounding
    /// of this size as 0.
    #[must_use]
    pub fn with_term_size(self, scale: f64) -> Self {
        Self { scale, ..self }
    }

    /// Sets the largest number of significant digits in text.
    #[must_use]
    pub fn digits(self, digits: usize) -> Self {
        Self { digits, ..self }
    }

    /// Leaves the fact out of the short text.
    #[must_use]
    pub fn detail(self) -> Self {
        Self { is_detail: true, ..self }
    }

    /// Omits the fact from text unless a condition holds; the JSON keeps it.
    #[must_use]
    pub fn shown_if(self, condition: bool) -> Self {
        Self { label: if condition { self.label } else { String::new() }, ..self }
    }

    /// Leaves the fact out of the JSON.
    #[must_use]
    pub fn without_key(self) -> Self {
        Self { key: String::new(), ..self }
    }

    fn is_shown(&self) -> bool {
        !self.label.is_empty() && !matches!(self.value, Quantity::None)
    }

    /// Returns the row of a page: `label`, `value`, `unit` and `note`.
    fn row(&self) -> Value {
        let (value, unit) = self.value.in_unit(self.error, self.scale, self.digits);
        json!({ "label": self.label, "value": typeset(&value), "unit": unit, "note": typeset(&self.note) })
    }

    /// Returns the line of a text, or its lines if the value is a table.
    fn line(&self, details: bool) -> String {
        match &self.value {
            Quantity::Table(rows) => table(&self.label, rows, details),
            _ => labelled_from(COLUMN, &format!("  {}", self.label), &self.in_words()),
        }
    }

    /// Returns the value with its unit and note.
    fn in_words(&self) -> String {
        let (value, unit) = self.value.in_unit(self.error, self.scale, self.digits);
        let unit = if unit.is_empty() || unit == "°" { unit } else { format!("\u{a0}{unit}") };
        let note = if self.note.is_empty() { String::new() } else { format!(", {}", self.note) };
        format!("{value}{unit}{note}")
    }
}

impl Facts {
    /// Creates a section with its title for people.
    pub fn new(title: impl Into<String>, facts: Vec<Fact>) -> Self {
        Self { title: title.into(), facts }
    }

    /// Returns the title and a line for each fact, with details only if requested. Empty without
    /// facts.
    pub fn to_text(&self, details: bool) -> String {
        let lines: String = self.shown(details).map(|fact| fact.line(details)).collect();
        if lines.is_empty() { lines } else { plain_spaces(&format!("{}\n{lines}", self.title)) }
    }

    fn shown(&self, details: bool) -> impl Iterator<Item = &Fact> {
        self.facts.iter().filter(move |fact| fact.is_shown() && (details || !fact.is_detail))
    }

    /// Returns the `title` and the `rows` of a page; `None` if no fact has a label.
    pub fn to_rows(&self) -> Option<Value> {
        let is_line = |fact: &&Fact| !matches!(fact.value, Quantity::Table(_));
        let rows: Vec<Value> = self.shown(true).filter(is_line).map(Fact::row).collect();
        (!rows.is_empty()).then(|| json!({ "title": self.title, "rows": rows }))
    }
}

fn table(label: &str, rows: &[Facts], details: bool) -> String {
    let rows: Vec<&Facts> = rows.iter().filter(|row| !row.title.is_empty()).collect();
    let mut labels: Vec<&str> = Vec::new();
    for row in &rows {
        let mut at = 0;
        for fact in row.facts.iter().filter(|fact| !fact.label.is_empty()) {
            let found = labels.iter().position(|label| *label == fact.label);
            if found.is_none() {
                labels.insert(at, &fact.label);
            }
            at = found.unwrap_or(at) + 1;
        }
    }
    labels.retain(|label| rows.iter().any(|row| row.shown(details).any(|fact| fact.label == *label)));
    let line = |row: &&Facts| {
        let cell = |label: &&str| {
            let fact = row.shown(details).find(|fact| fact.label == *label);
            fact.map_or_else(String::new, |fact| plain_spaces(&fact.in_words()))
        };
        [row.title.clone()].into_iter().chain(labels.iter().map(cell)).collect()
    };
    let head = [label].iter().chain(&labels).map(|&label| label.to_owned()).collect();
    let lines: Vec<Vec<String>> =
        if rows.is_empty() { Vec::new() } else { [head].into_iter().chain(rows.iter().map(line)).collect() };
    columns(&lines).iter().map(|line| format!("  {line}\n")).collect()
}

/// Returns the facts as a JSON object with these top-level keys in this order; a missing fact is
/// `null`.
pub fn object(keys: &[&str], facts: &[Facts]) -> Map<String, Value> {
    let mut object: Map<String, Value> = keys.iter().map(|key| ((*key).to_owned(), Value::Null)).collect();
    for fact in facts.iter().flat_map(|facts| &facts.facts).filter(|fact| !fact.key.is_empty()) {
        put(&mut object, &fact.key, fact.value.json());
    }
    object
}

fn put(object: &mut Map<String, Value>, path: &str, value: Value) {
    let Some((key, rest)) = path.split_once('.') else {
        object.insert(path.to_owned(), value);
        return;
    };
    let inner = object.entry(key).or_insert(Value::Null);
    if inner.is_null() {
        *inner = Value::Object(Map::new());
    }
    if let Value::Object(inner) = inner {
        put(inner, rest, value);
    }
}

impl Quantity {
    fn json(&self) -> Value {
        match self {
            Self::None => Value::Null,
            Self::Number(x, _)
            | Self::Error(x, _)
            | Self::Duration(x)
            | Self::Rate(x)
            | Self::Angle(x)
            | Self::Energy(x) => (*x).into(),
            Self::Vector(v, _) => v.as_slice().into(),
            Self::Attitude(q) => q.as_slice().into(),
            Self::Range(ends, _) | Self::Angles(ends) => ends.as_slice().into(),
            Self::Count(n) => (*n).into(),
            Self::Word(word, _) => (*word).into(),
            Self::Text(text) => text.as_str().into(),
            Self::Data(json, _) => json.clone(),
            Self::Table(rows) => {
                rows.iter().map(|row| Value::Object(object(&[], std::slice::from_ref(row)))).collect()
            }
        }
    }

    /// Returns the magnitude with which the error is compared; infinite if the value has no error.
    fn size(&self) -> f64 {
        match self {
            Self::Number(x, _) | Self::Duration(x) | Self::Rate(x) | Self::Angle(x) | Self::Energy(x) => {
                x.abs()
            }
            Self::Vector(v, _) => v.iter().map(|x| x * x).sum::<f64>().sqrt(),
            Self::Attitude(_) => LARGEST_ATTITUDE_ERROR,
            Self::None
            | Self::Range(..)
            | Self::Error(..)
            | Self::Angles(_)
            | Self::Count(_)
            | Self::Word(..)
            | Self::Text(_)
            | Self::Data(..)
            | Self::Table(_) => f64::INFINITY,
        }
    }

    fn in_unit(&self, sigma: f64, scale: f64, digits: usize) -> (String, String) {
        let exact = |x: f64| tidy_beside([x, 0.0, 0.0], 10.0 * scale)[0];
        match self {
            _ if !has_digits(self.size(), sigma) => (NO_RIGHT_DIGIT.to_owned(), String::new()),
            Self::None | Self::Table(_) => (String::new(), String::new()),
            Self::Number(x, "kg") => split(&unit::mass(*x)),
            Self::Number(x, "m") => split(&unit::length(*x)),
            Self::Number(x, "m³") => split(&unit::volume(*x)),
            Self::Number(x, unit) => (within(exact(*x), sigma, digits), (*unit).to_owned()),
            Self::Vector(m, "m") => split(&unit::place_within(tidy(*m), sigma)),
            Self::Vector(v, unit) => vector_in(tidy_beside(tidy(*v), scale), sigma, digits, unit),
            Self::Attitude(q) => (quaternion(*q, sigma, digits), String::new()),
            Self::Range(ends, unit) => {
                let (prefix, size) = prefix(ends[1], unit);
                (range(ends.map(|x| x / size)), format!("{prefix}{unit}"))
            }
            Self::Error(x, unit) => (error(*x), (*unit).to_owned()),
            Self::Duration(s) if unit::longer(*s).is_some() => (unit::duration(*s, digits), String::new()),
            Self::Duration(s) => prefixed(*s, sigma, digits, "s"),
            Self::Rate(x) => {
                let (value, unit) = prefixed(*x, sigma, digits, "rad/s");
                let degrees = within(x.to_degrees(), sigma.to_degrees(), 6);
                (value, format!("{unit} ({degrees} deg/s)"))
            }
            Self::Angle(rad) => (within(rad.to_degrees(), sigma.to_degrees(), digits), "°".to_owned()),
            Self::Angles(ends) => (range(ends.map(f64::to_degrees)), "°".to_owned()),
            Self::Energy(x) => prefixed(exact(*x), sigma, digits, "J"),
            Self::Count(n) => (count(*n), String::new()),
            Self::Word(_, text) | Self::Text(text) | Self::Data(_, text) => (text.clone(), String::new()),
        }
    }
}

fn split(shown: &str) -> (String, String) {
    let (value, unit) = shown.rsplit_once(' ').unwrap_or((shown, ""));
    (value.to_owned(), unit.to_owned())
}

/// Returns the SI prefix for a value of this size, and its factor.
fn prefix(size: f64, unit: &str) -> (&'static str, f64) {
    fitting(size.abs(), unit).unwrap_or(("", 1.0))
}

fn prefixed(x: f64, sigma: f64, digits: usize, unit: &str) -> (String, String) {
    let (prefix, size) = prefix(x, unit);
    (within(x / size, sigma / size, digits), format!("{prefix}{unit}"))
}

/// Formats three numbers in one unit. Moments of inertia get a power of ten in front if they are
/// small or large.
fn vector_in(v: [f64; 3], sigma: f64, digits: usize, unit: &str) -> (String, String) {
    let largest = v.iter().fold(0.0, |most, x| f64::max(most, x.abs()));
    if unit != "kg·m²" {
        let (prefix, size) = prefix(largest, unit);
        return (vector_within(v.map(|x| x / size), sigma / size, digits), format!("{prefix}{unit}"));
    }
    let exponent = if largest > 0.0 && largest.is_finite() { largest.log10().floor() } else { 0.0 };
    let power = 10_f64.powf(exponent);
    if (-2.0..=4.0).contains(&exponent) || !power.is_normal() {
        return (vector(v, digits), unit.to_owned());
    }
    let factor = typeset(&format!("1e{exponent}"));
    (vector(v.map(|x| x / power), digits), format!("{} {unit}", factor.trim_start_matches('1')))
}

/// Formats a range as `10.2665 … 10.5486`, or one number if the ends agree.
fn range(ends: [f64; 2]) -> String {
    let [least, most] = ends.map(|x| number(x, 6));
    if least == most { least } else { format!("{least} … {most}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn text(value: Quantity, error: f64) -> String {
        let facts = Facts::new("", vec![Fact::shown("x", value).within(error)]);
        facts.to_text(false).trim_start_matches(['\n', ' ', 'x']).trim_end().to_owned()
    }

    #[test]
    fn units_have_a_size_that_people_read() {
        use Quantity::{Angle, Angles, Duration, Energy, Number, Range, Rate, Vector};
        for (value, shown) in [
            (Energy(1.945_152e-7), "0.194515 µJ"),
            (Energy(0.002_337_246), "2.33725 mJ"),
            (Energy(6.214_474e-22), "6.21447e-22 J"),
            (Energy(0.0), "0 J"),
            (Rate(1.109_695e-3), "1.10969 mrad/s (0.0635808 deg/s)"),
            (Rate(8e12), "8e12 rad/s (4.58366e14 deg/s)"),
            (Vector([3.14e-5, -0.001_103, 0.0], "rad/s"), "(0.0314, -1.103, 0) mrad/s"),
            (Range([1.026_65e-5, 1.054_86e-5], "rad/s"), "10.2665 … 10.5486 µrad/s"),
            (Range([0.4, 0.4], "rad/s"), "0.4 rad/s"),
            (Duration(5.634_747e-12), "5.63475 ps"),
            (Duration(463_841.0), "463841 s (5.36853 d)"),
            (Duration(9_000.0), "9000 s"),
            (Vector([4.5e-4, 0.0, -1.26e-5], "kg·m²"), "(4.5, 0, -0.126) ×10⁻⁴ kg·m²"),
            (Vector([0.34, 0.31, 0.026], "kg·m²"), "(0.34, 0.31, 0.026) kg·m²"),
            (Vector([0.0; 3], "kg·m²"), "(0, 0, 0) kg·m²"),
            (Number(2.563_54e-5, "m³"), "25.6354 cm³"),
            (Angle(std::f64::consts::FRAC_PI_6), "30°"),
            (Angles([0.0, std::f64::consts::FRAC_PI_2]), "0 … 90°"),
        ] {
            assert_eq!(text(value, 0.0), shown);
        }
    }

    #[test]
    fn digits_end_where_the_error_begins() {
        assert_eq!(text(Quantity::Number(1.234_567, "N"), 0.001), "1.235 N");
        assert_eq!(text(Quantity::Rate(1.5), 0.01), "1.5 rad/s (85.9 deg/s)");
        assert_eq!(text(Quantity::Vector([0.012_345_6, 0.0, -0.02], "m"), 1e-5), "(12.35, 0, -20) mm");
        let place = Fact::shown("x", Quantity::Text("30° → 31°".to_owned())).without_digits();
        assert!(Facts::new("", vec![place]).to_text(false).contains(NO_RIGHT_DIGIT));
    }

    #[test]
    fn rounding_is_zero() {
        let torque = Fact::new("n", "N", Quantity::Vector([1e-15, 0.0, -1e-14], "N·m")).with_term_size(2.0);
        let facts = [Facts::new("", vec![torque])];
        assert_eq!(facts[0].to_text(false), "\n  N                   (0, 0, 0) N·m\n");
        assert_eq!(object(&[], &facts)["n"], json!([1e-15, 0.0, -1e-14]));
    }

    #[test]
    fn details_are_for_pages_and_long_texts() {
        let steps = Fact::new("run.steps", "steps", Quantity::Count(2001)).detail();
        let facts = Facts::new("Solver", vec![steps, Fact::data("run.method", Quantity::None)]);
        assert_eq!(facts.to_text(false), "");
        assert_eq!(facts.to_text(true), "Solver\n  steps               2,001\n");
        let rows = json!([{ "label": "steps", "value": "2,001", "unit": "", "note": "" }]);
        assert_eq!(facts.to_rows(), Some(json!({ "title": "Solver", "rows": rows })));
        let wanted = json!({ "at": null, "run": { "steps": 2001, "method": null } });
        assert_eq!(Value::Object(object(&["at", "run"], &[facts])), wanted);
    }

    #[test]
    fn tables_have_the_rows_with_titles() {
        let row = |title: &str, rate: f64, growth: Option<f64>| {
            let growth = growth.map(|rate| Quantity::Number(rate, "/s"));
            let facts = vec![
                Fact::new("spin", "spin", Quantity::Number(rate, "rad/s")),
                Fact::new("growth", "growth rate", growth),
            ];
            Facts::new(title, facts)
        };
        let rows = vec![row("1", 12_345.5, None), row("", 3.0, None), row("2", 2.0, Some(0.5))];
        let facts = Facts::new("Spins", vec![Fact::new("all", "axis", Quantity::Table(rows))]);
        let wanted = "Spins\n  axis  spin           growth rate\n  1     12345.5 rad/s\n  2     2 rad/s        0.5 /s\n";
        assert_eq!(facts.to_text(false), wanted);
        let wanted = json!([12_345.5, 3.0, 2.0]).as_array().unwrap().clone();
        let json = object(&[], &[facts]);
        let spins: Vec<Value> =
            json["all"].as_array().unwrap().iter().map(|row| row["spin"].clone()).collect();
        assert_eq!(spins, wanted);
    }
}
