//! All rules of the checks, in one table, `rule/rules.txt`: what each requires, why, how to comply, and an example.
//!
//! `polhode check --explain`, the rules of SARIF and `book/rules.md` are made of it. A test holds it against the codes that are told:
//! each is in the table, and each example breaks its rule until it is mended.

use std::fmt::Write as _;
use std::sync::LazyLock;

use polhode_document::layout::{WIDTH, wrap};

use crate::finding::Severity;

/// What is asked of a model.
#[derive(Debug)]
pub struct Rule {
    /// Its stable name: `"inertia.triangle"`.
    pub code: &'static str,
    /// How bad it usually is; a finding may be less, where the model or its language excuse it.
    pub severity: Severity,
    /// What it asks, in a line.
    pub title: &'static str,
    /// What goes wrong otherwise.
    pub why: &'static str,
    /// What to do about it.
    pub mend: &'static str,
    /// A model that breaks it, and the same without; `None` if it is not about a model.
    pub example: Option<Example>,
}

/// A model that breaks a rule: what is wrong in it, and what is right in its place.
#[derive(Debug)]
pub struct Example {
    /// Beginning of the model, or of the contents of its `<robot>`.
    before: &'static str,
    wrong: &'static str,
    right: &'static str,
    /// End of the model.
    after: &'static str,
}

impl Example {
    /// Reads a model with `[-what is wrong-]{+what is right+}`; nothing is in its place where that is left out.
    fn read(text: &'static str) -> Option<Self> {
        let (before, rest) = text.split_once("[-")?;
        let (wrong, rest) = rest.split_once("-]")?;
        let (right, after) = match rest.strip_prefix("{+") {
            Some(rest) => rest.split_once("+}")?,
            None => ("", rest),
        };
        Some(Self { before, wrong, right, after })
    }

    /// Returns the text with a part in its place.
    fn with(&self, part: &str) -> String {
        [self.before, part, self.after].concat()
    }

    /// The model that breaks the rule, and the one that does not.
    pub fn models(&self) -> [String; 2] {
        [self.wrong, self.right].map(|part| {
            let model = self.with(part);
            let is_whole = ["<sdf", "<mujoco", "<robot", "#usda"].iter().any(|root| model.starts_with(root));
            if is_whole { model } else { format!("<robot name=\"r\">\n{model}\n</robot>") }
        })
    }
}

const TABLE: &str = include_str!("rule/rules.txt");

static RULES: LazyLock<Vec<Rule>> =
    LazyLock::new(|| TABLE.split("\n## ").skip(1).filter_map(Rule::read).collect());

/// The rules, by subject: numbers, masses, tensors, geometry, the tree, what was read, what was allowed.
pub fn rules() -> impl Iterator<Item = &'static Rule> {
    RULES.iter()
}

/// The rule of this name.
pub fn rule(code: &str) -> Option<&'static Rule> {
    rules().find(|rule| rule.code == code)
}

impl Rule {
    /// Reads a section of the table.
    fn read(section: &'static str) -> Option<Self> {
        let mut lines = section.splitn(5, '\n');
        let (code, severity) = lines.next()?.split_once(' ')?;
        let severity = Severity::named(severity)?;
        let (title, why, mend, rest) = (lines.next()?, lines.next()?, lines.next()?, lines.next()?);
        let example = Example::read(rest.strip_suffix('\n').unwrap_or(rest));
        Some(Self { code, severity, title, why, mend, example })
    }

    /// Lines for people.
    pub fn to_text(&self) -> String {
        let mut text = format!("{}   {}\n", self.code, self.severity.name());
        for (label, sentence) in [("", self.title), ("why: ", self.why), ("mend: ", self.mend)] {
            text.push('\n');
            let hang = format!("  {}", " ".repeat(label.len()));
            for (k, line) in wrap(sentence, &hang, WIDTH).iter().enumerate() {
                let line = line.strip_prefix(&hang).unwrap_or(line);
                let start = if k == 0 { format!("  {label}") } else { hang.clone() };
                text.push_str(&format!("{start}{line}\n"));
            }
        }
        if let Some(example) = &self.example {
            text.push_str("\n  example:\n");
            for line in example.with(example.wrong).lines() {
                let _ = writeln!(text, "    {line}");
            }
            for (label, part) in [("wrong", example.wrong), ("right", example.right)] {
                let part = part.trim().replace('\n', &format!("\n{:11}", ""));
                let _ = writeln!(text, "  {label}:   {}", if part.is_empty() { "(nothing)" } else { &part });
            }
        }
        text
    }

    /// Its section of `book/rules.md`.
    pub fn to_markdown(&self) -> String {
        let mut text = format!(
            "## {}\n\n*{}.* {}\n\n{}\n\n{}\n",
            self.code,
            self.severity.name(),
            sentence(self.title),
            self.why,
            self.mend
        );
        if let Some(example) = &self.example {
            let [model, mended] = example.models();
            let _ = write!(text, "\n```xml\n{model}\n```\n\n");
            let changed: Vec<&str> =
                mended.lines().filter(|line| !model.lines().any(|old| old == *line)).collect();
            let _ = if changed.is_empty() {
                let old = example.wrong.trim();
                writeln!(text, "Right without `{}`.", old.lines().next().unwrap_or(old))
            } else {
                write!(text, "Right:\n\n```xml\n{}\n```\n", changed.join("\n"))
            };
        }
        text
    }
}

/// With a capital and a full stop.
fn sentence(line: &str) -> String {
    let mut letters = line.chars();
    let first = letters.next().map(|c| c.to_uppercase().to_string()).unwrap_or_default();
    // The names of elements keep their letters.
    let first = if line.starts_with("ixy") { "ixy".chars().take(1).collect() } else { first };
    format!("{first}{}.", letters.as_str())
}

/// One line a rule.
pub fn list() -> String {
    let longest = rules().map(|rule| rule.code.len()).max().unwrap_or(0);
    let line = |rule: &Rule| format!("{:longest$}  {:10}  {}\n", rule.code, rule.severity.name(), rule.title);
    rules().map(line).collect()
}

/// All of `book/rules.md`.
pub fn page() -> String {
    let mut page = "# The rules of `polhode check`\n\n\
         Every finding has a code; here is what each asks, why, and how to mend it. `polhode check --explain CODE` prints the same. The \
         severity is that of most findings of the rule; [robot models](check.md) says what severities do.\n"
        .to_owned();
    for rule in rules() {
        page.push('\n');
        page.push_str(&rule.to_markdown());
    }
    page
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn each_rule_is_said_once_and_whole() {
        let examples = rules().filter(|rule| rule.example.is_some()).count();
        let codes: BTreeSet<&str> = rules().map(|rule| rule.code).collect();
        assert_eq!(codes.len(), rules().count());
        assert_eq!((codes.len(), TABLE.matches("[-").count()), (TABLE.matches("\n## ").count(), examples));
        for rule in rules() {
            assert!(!rule.title.is_empty() && !rule.title.ends_with('.'), "{}", rule.code);
            assert!(rule.why.ends_with('.') && rule.mend.ends_with('.'), "{}", rule.code);
            assert!(rule.to_text().lines().all(|line| line.chars().count() <= 120), "{}", rule.to_text());
        }
    }
}
