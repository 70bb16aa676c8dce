//! Configuration of a project: `polhode.toml`.

use std::collections::BTreeMap;
use std::ops::Range;
use std::path::Path;

use polhode_source::FormatError;
use polhode_source::nearest;
use polhode_source::{ContentError, ContentErrorKind};
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::date::Date;
use super::glob::{Glob, name_matches};
use crate::finding::Severity;
use crate::line_index::LineIndex;
use crate::rule::{rule, rules};

/// Configuration of a project; empty by default.
#[derive(Clone, Debug, Default)]
pub struct Config {
    /// Path of the file, for messages.
    pub file: String,
    /// Lowest severity that makes the check fail.
    pub fail_on: Option<Severity>,
    /// Files that are not checked.
    pub exclude: Vec<Glob>,
    /// Severity overrides by rule; `None` switches a rule off.
    severities: BTreeMap<&'static str, Option<Severity>>,
    /// Permitted findings: rule, file, link and the reason.
    pub allowances: Vec<Allowance>,
}

/// Allowance of findings.
#[derive(Clone, Debug)]
pub struct Allowance {
    /// Code of the rule.
    pub rule: &'static str,
    /// Pattern of the files.
    pub file: Glob,
    /// Pattern of the links or joints; `None` for all.
    pub link: Option<String>,
    /// Reason, in the user's words.
    pub reason: String,
    /// Expiry date: the allowance ends at the start of this day.
    pub expires: Option<Date>,
    /// Line and column in the configuration, from 1.
    pub place: (usize, usize),
}

impl Allowance {
    /// Returns true if it allows findings of a rule about a link or joint, or about the model if
    /// `subject` is empty.
    fn allows(&self, files: &[&str], code: &str, subject: &str) -> bool {
        self.rule == code
            && self.link.as_ref().is_none_or(|glob| name_matches(glob, subject))
            && files.iter().any(|file| self.file.matches(file))
    }
}

impl Config {
    /// Parses a configuration; `path` is for messages.
    ///
    /// # Errors
    /// [`FormatError`] with its place, for invalid TOML, unknown keys or rules, or an allowance
    /// without a reason.
    pub fn read(path: &Path, text: &str) -> Result<Self, FormatError> {
        read(text)
            .map(|config| Self { file: path.to_string_lossy().into_owned(), ..config })
            .map_err(|error| FormatError::of_content(path, text.as_bytes(), error))
    }

    /// Returns the severity override of a rule, if there is one; `Some(None)` means off.
    pub(super) fn severity_of(&self, code: &str) -> Option<Option<Severity>> {
        self.severities.get(code).copied()
    }

    /// Returns the index of the first unexpired allowance for a rule and a link in one of these
    /// files.
    pub(super) fn allowance(&self, files: &[&str], code: &str, subject: &str, today: Date) -> Option<usize> {
        self.allowances.iter().position(|allowance| {
            allowance.expires.is_none_or(|day| today < day) && allowance.allows(files, code, subject)
        })
    }
}

fn read(text: &str) -> Result<Config, ContentError> {
    let document = DeTable::parse(text).map_err(|error| {
        let span = error.span().unwrap_or(0..0);
        expected(
            &format!("TOML ({})", error.message().replace('\n', " ")),
            text.get(span.clone()).unwrap_or(""),
            span,
        )
        .hint("write key = value, [table] or [[table]], with text in quotes")
    })?;
    let mut config = Config::default();
    let top = Table { entries: document.get_ref(), name: "polhode.toml", span: 0..0 };
    top.allow(&["check"])?;
    let Some(check) = top.get("check") else { return Ok(config) };
    let check = check.table("[check]")?;
    check.allow(&["fail_on", "exclude", "rules", "allow"])?;
    config.fail_on = check.get("fail_on").map(|value| value.severity(false)).transpose()?.flatten();
    if let Some(exclude) = check.get("exclude") {
        config.exclude =
            exclude.list("a list of globs")?.iter().map(Value::glob).collect::<Result<_, _>>()?;
    }
    if let Some(severities) = check.get("rules") {
        let severities = severities.table("[check.rules]")?;
        for (key, value) in severities.each() {
            config.severities.insert(known_rule(key.get_ref(), key.span())?, value.severity(true)?);
        }
    }
    let lines = LineIndex::new(text);
    if let Some(allowances) = check.get("allow") {
        for value in allowances.list("[[check.allow]]")? {
            let table = value.table("[[check.allow]]")?;
            config.allowances.push(allowance(&table, lines.place(table.span.start))?);
        }
    }
    Ok(config)
}

fn allowance(table: &Table<'_>, place: (usize, usize)) -> Result<Allowance, ContentError> {
    table.allow(&["rule", "file", "link", "reason", "expires"])?;
    let code = table.require("rule", "rule = \"inertia.triangle\"")?;
    let reason = table.require("reason", "reason = \"why this finding is accepted\"")?;
    if reason.text("a reason in words")?.trim().is_empty() {
        return Err(expected("a reason in words", "an empty text", reason.span()));
    }
    Ok(Allowance {
        rule: known_rule(code.text("a rule")?, code.span())?,
        file: table.require("file", "file = \"robots/**/*.urdf\"")?.glob()?,
        link: table
            .get("link")
            .map(|link| link.text("a link's name, or a glob").map(str::to_owned))
            .transpose()?,
        reason: reason.text("a reason in words")?.trim().to_owned(),
        expires: table.get("expires").map(|day| day.date()).transpose()?,
        place,
    })
}

fn known_rule(code: &str, span: Range<usize>) -> Result<&'static str, ContentError> {
    rule(code).map(|rule| rule.code).ok_or_else(|| {
        let meant = nearest(code, rules().map(|rule| rule.code));
        let meant = meant.map_or(String::new(), |meant| format!("did you mean {meant}? "));
        expected("a rule", code, span).hint(format!("{meant}polhode check --explain lists all rules"))
    })
}

fn expected(what: &str, found: &str, span: Range<usize>) -> ContentError {
    ContentErrorKind::expected(what, found).at(span)
}

/// TOML table with its name for messages and its position.
struct Table<'a> {
    entries: &'a DeTable<'a>,
    name: &'static str,
    span: Range<usize>,
}

/// Value with its position.
#[derive(Clone, Copy)]
struct Value<'a>(&'a Spanned<DeValue<'a>>);

impl<'a> Table<'a> {
    /// Returns an error for the first key that is not in this list.
    fn allow(&self, known: &[&str]) -> Result<(), ContentError> {
        let unknown =
            self.entries.iter().map(|(key, _)| key).filter(|key| !known.contains(&key.get_ref().as_ref()));
        let Some(key) = unknown.min_by_key(|key| key.span().start) else { return Ok(()) };
        let meant = nearest(key.get_ref(), known.iter().copied());
        let meant = meant.map_or(String::new(), |meant| format!("did you mean {meant}? "));
        let error = expected(&format!("a key of {}", self.name), key.get_ref(), key.span());
        Err(error.hint(format!("{meant}known keys: {}", known.join(", "))))
    }

    fn get(&self, key: &str) -> Option<Value<'a>> {
        self.entries.get(key).map(Value)
    }

    fn require(&self, key: &str, example: &str) -> Result<Value<'a>, ContentError> {
        self.get(key).ok_or_else(|| {
            let kind = ContentErrorKind::missing(format!("{key} in {}", self.name));
            kind.at(self.span.clone()).hint(format!("write {example}"))
        })
    }

    fn each(&self) -> impl Iterator<Item = (&'a Spanned<toml::de::DeString<'a>>, Value<'a>)> {
        self.entries.iter().map(|(key, value)| (key, Value(value)))
    }
}

impl<'a> Value<'a> {
    fn span(&self) -> Range<usize> {
        self.0.span()
    }

    fn wrong(&self, what: &str) -> ContentError {
        let found = match self.0.get_ref() {
            DeValue::String(text) => text.to_string(),
            DeValue::Integer(number) => number.as_str().to_owned(),
            DeValue::Float(number) => number.as_str().to_owned(),
            DeValue::Boolean(truth) => truth.to_string(),
            DeValue::Datetime(date) => date.to_string(),
            DeValue::Array(_) => "a list".to_owned(),
            DeValue::Table(_) => "a table".to_owned(),
        };
        expected(what, &found, self.span())
    }

    fn table(&self, name: &'static str) -> Result<Table<'a>, ContentError> {
        match self.0.get_ref() {
            DeValue::Table(entries) => Ok(Table { entries, name, span: self.span() }),
            _ => Err(self.wrong(name)),
        }
    }

    fn list(&self, what: &str) -> Result<Vec<Self>, ContentError> {
        match self.0.get_ref() {
            DeValue::Array(elements) => Ok(elements.iter().map(Value).collect()),
            _ => Err(self.wrong(what)),
        }
    }

    fn text(&self, what: &str) -> Result<&'a str, ContentError> {
        match self.0.get_ref() {
            DeValue::String(text) => Ok(text),
            _ => Err(self.wrong(what)),
        }
    }

    fn glob(&self) -> Result<Glob, ContentError> {
        let what = "a glob of files";
        Glob::new(self.text(what)?).ok_or_else(|| {
            self.wrong(what).hint("globs contain *, ?, and ** between slashes: robots/**/*.urdf")
        })
    }

    fn date(&self) -> Result<Date, ContentError> {
        match self.0.get_ref() {
            DeValue::Datetime(given) if given.time.is_none() => given
                .date
                .map(|date| Date::new(date.year, date.month, date.day))
                .ok_or_else(|| self.wrong("a date")),
            _ => Err(self.wrong("a date").hint("write expires = 2027-01-31, without quotes")),
        }
    }

    /// Parses a severity; `None` for off.
    fn severity(&self, may_be_off: bool) -> Result<Option<Severity>, ContentError> {
        let names = Severity::ALL.into_iter().map(Severity::name);
        let names: Vec<&str> = names.chain(may_be_off.then_some("off")).collect();
        let what = format!("one of {}", names.join(", "));
        let word = self.text(&what)?;
        if may_be_off && word == "off" {
            return Ok(None);
        }
        match Severity::named(word) {
            Some(severity) => Ok(Some(severity)),
            None => {
                let error = self.wrong(&what);
                Err(match nearest(word, names) {
                    Some(meant) => error.hint(format!("did you mean {meant}?")),
                    None => error,
                })
            }
        }
    }
}
