//! Table of all rules of the checks, `rule/rules.txt`: requirement, reason, remedy and example.
//!
//! The output of `polhode check --explain`, the rules in SARIF and `book/rules.md` are generated
//! from it. Tests compare the table with the checks: every reported code is in the table, and every
//! example breaks its rule until it is corrected.

use std::fmt::Write as _;
use std::sync::LazyLock;

use polhode_document::layout::{WIDTH, wrap};

use crate::finding::Severity;

/// Rule for models.
#[derive(Debug)]
pub struct Rule {
    /// Stable code: `"inertia.triangle"`.
    pub code: &'static str,
    /// Usual severity. A finding may have a lower one if the model or its language justifies it.
    pub severity: Severity,
    /// Requirement, one line.
    pub title: &'static str,
    /// Consequence of breaking the rule.
    pub why: &'static str,
    /// Instruction for correcting the model.
    pub mend: &'static str,
    /// Example that breaks the rule, with its correction; `None` if the rule is not about a model.
    pub example: Option<Example>,
}

/// Example of a broken rule: a model with a wrong part and the right part.
#[derive(Debug)]
pub struct Example {
    /// Text before the part, in the model or inside its `<robot>`.
    before: &'static str,
    wrong: &'static str,
    right: &'static str,
    /// Text after the part.
    after: &'static str,
}

impl Example {
    /// Parses a model with `[-wrong part-]{+right part+}`. Without `{+…+}` the right part is empty.
    fn read(text: &'static str) -> Option<Self> {
        let (before, rest) = text.split_once("[-")?;
        let (wrong, rest) = rest.split_once("-]")?;
        let (right, after) = match rest.strip_prefix("{+") {
            Some(rest) => rest.split_once("+}")?,
            None => ("", rest),
        };
        Some(Self { before, wrong, right, after })
    }

    /// Returns the model with this part inserted.
    fn with(&self, part: &str) -> String {
        [self.before, part, self.after].concat()
    }

    /// Returns the model that breaks the rule, and the corrected model.
    pub fn models(&self) -> [String; 2] {
        [self.wrong, self.right].map(|part| {
            let model = self.with(part);
            let is_whole = ["<sdf", "<mujoco", "<robot", "#usda"].iter().any(|root| model.starts_with(root));
            if is_whole { model } else { format!("<robot name=\"r\">\n{model}\n</robot>") }
        })
    }
}

/// Table. A build of URDF only has the codes, severities and titles, which its reports contain.
#[cfg(feature = "languages")]
const TABLE: &str = include_str!("rule/rules.txt");
#[cfg(not(feature = "languages"))]
const TABLE: &str = match str::from_utf8(&TITLES) {
    Ok(table) => table,
    Err(_) => "",
};

/// Table with blanks after the title of each rule.
#[cfg(any(test, not(feature = "languages")))]
static TITLES: [u8; include_bytes!("rule/rules.txt").len()] = titles(*include_bytes!("rule/rules.txt"));

/// Overwrites all lines but headings and titles with blanks, which a compressed module has for
/// nothing.
#[cfg(any(test, not(feature = "languages")))]
const fn titles<const N: usize>(mut table: [u8; N]) -> [u8; N] {
    /// Number of lines that a section keeps.
    const KEPT: usize = 2;
    let (mut at, mut line) = (0, KEPT);
    while at + 2 < N {
        let is_start = at == 0 || table[at - 1] == b'\n';
        if is_start && table[at] == b'#' && table[at + 1] == b'#' && table[at + 2] == b' ' {
            line = 0;
        }
        if table[at] == b'\n' {
            line += 1;
        } else if line >= KEPT {
            table[at] = b' ';
        }
        at += 1;
    }
    table
}

static RULES: LazyLock<Vec<Rule>> =
    LazyLock::new(|| TABLE.split("\n## ").skip(1).filter_map(Rule::read).collect());

/// Returns the rules in the order of the table: numbers, masses, tensors, geometry, tree, reading,
/// allowances.
pub fn rules() -> impl Iterator<Item = &'static Rule> {
    RULES.iter()
}

/// Returns the rule with this code.
pub fn rule(code: &str) -> Option<&'static Rule> {
    rules().find(|rule| rule.code == code)
}

impl Rule {
    /// Parses a section of the table.
    fn read(section: &'static str) -> Option<Self> {
        let mut lines = section.splitn(5, '\n');
        let (code, severity) = lines.next()?.split_once(' ')?;
        let severity = Severity::named(severity)?;
        let (title, why, mend, rest) = (lines.next()?, lines.next()?, lines.next()?, lines.next()?);
        let example = Example::read(rest.strip_suffix('\n').unwrap_or(rest));
        Some(Self { code, severity, title, why, mend, example })
    }

    /// Returns the rule as text for the terminal.
    pub fn to_text(&self) -> String {
        let mut text = format!("{}   {}\n", self.code, self.severity.name());
        for (label, sentence) in [("", self.title), ("why: ", self.why), ("fix: ", self.mend)] {
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

    /// Returns the section of `book/rules.md` for this rule.
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

/// Returns a sentence with a capital letter and a full stop.
fn sentence(line: &str) -> String {
    let mut letters = line.chars();
    let first = letters.next().map(|c| c.to_uppercase().to_string()).unwrap_or_default();
    // Element names such as ixy keep their lower-case letters.
    let first = if line.starts_with("ixy") { "ixy".chars().take(1).collect() } else { first };
    format!("{first}{}.", letters.as_str())
}

/// Returns the list of rules, one line each.
pub fn list() -> String {
    let longest = rules().map(|rule| rule.code.len()).max().unwrap_or(0);
    let line = |rule: &Rule| format!("{:longest$}  {:10}  {}\n", rule.code, rule.severity.name(), rule.title);
    rules().map(line).collect()
}

/// Returns the whole of `book/rules.md`.
pub fn page() -> String {
    let mut page = "# Rules of `polhode check`\n\n\
         Every finding has a code. This page states the rule for each code, the reason and the fix; `polhode check --explain CODE` \
         prints the same. The severity is that of most findings of the rule. [Robot models](check.md) explains the severities.\n"
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

    #[test]
    fn the_table_of_titles_has_all_codes_severities_and_titles() {
        let titles = str::from_utf8(&TITLES).unwrap_or_default();
        let of = |rule: &Rule| (rule.code, rule.severity, rule.title);
        let short: Vec<Rule> = titles.split("\n## ").skip(1).filter_map(Rule::read).collect();
        assert_eq!(short.iter().map(of).collect::<Vec<_>>(), rules().map(of).collect::<Vec<_>>());
        assert!(short.iter().all(|rule| rule.why.trim().is_empty() && rule.example.is_none()));
        assert!(titles.split_whitespace().count() < TABLE.split_whitespace().count() / 2);
    }
}
