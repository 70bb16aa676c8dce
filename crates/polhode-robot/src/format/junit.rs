//! JUnit XML for Jenkins, GitLab and Azure DevOps: one suite per file, one case per finding. The
//! output is valid by the schema of Jenkins' xUnit plugin, `junit-10.xsd`.

use std::fmt::Write as _;

use super::{Item, about};
use crate::checked::{Checked, FileChecked};
use crate::policy::Reason;

impl Checked {
    /// Returns the XML. Findings at or above the failing severity are failures; other findings are
    /// passing cases with their message. Allowed and known findings are skipped cases. A file
    /// without findings is one passing case.
    pub fn to_junit(&self) -> String {
        let suites: Vec<Suite> =
            self.files.iter().map(|file| self.suite(file)).chain(self.policy_suites()).collect();
        let sum = |of: fn(&Suite) -> usize| suites.iter().map(of).sum::<usize>();
        let mut text = format!(
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\">\n",
            self.command,
            sum(|suite| suite.tests),
            sum(|suite| suite.failures),
            sum(|suite| suite.errors)
        );
        for Suite { file, tests, failures, errors, skipped, cases } in &suites {
            let _ = write!(
                text,
                "  <testsuite name=\"{}\" tests=\"{tests}\" failures=\"{failures}\" errors=\"{errors}\" skipped=\"{skipped}\">\n{cases}  \
                 </testsuite>\n",
                escaped(file)
            );
        }
        text + "</testsuites>\n"
    }

    fn suite(&self, file: &FileChecked) -> Suite {
        let mut suite = Suite { file: file.name.clone(), ..Suite::default() };
        match file.unreadable() {
            Some((message, place)) => {
                suite.errors = 1;
                let place = place.map_or(String::new(), |[line, column]| format!(":{line}:{column}"));
                let inner = format!(
                    "<error type=\"unreadable\" message=\"{}\">{}{place}</error>",
                    escaped(&message),
                    escaped(&file.name)
                );
                suite.case("is read", &inner);
            }
            None => {
                for item in file.items() {
                    self.add(&mut suite, &item);
                }
                if suite.tests == 0 {
                    suite.case("nothing found", "");
                }
            }
        }
        suite
    }

    /// Returns a suite for each remark on the configuration and the baseline, and one for excluded
    /// content.
    fn policy_suites(&self) -> impl Iterator<Item = Suite> {
        let remarks = self.remarks().map(|item| {
            let mut suite = Suite { file: item.file.to_string(), ..Suite::default() };
            self.add(&mut suite, &item);
            suite
        });
        let mut left_out = Suite { file: "configuration".to_owned(), ..Suite::default() };
        for line in self.left_out() {
            left_out.skipped += 1;
            left_out.case(&line, &format!("<skipped message=\"{}\"/>", escaped(&line)));
        }
        remarks.chain(Some(left_out).filter(|suite| suite.tests > 0))
    }

    fn add(&self, suite: &mut Suite, item: &Item<'_>) {
        let Item { file, start: (line, column), code, severity, rule, id, .. } = item;
        let details = format!("{file}:{line}:{column}\n{}\nrule: {rule}\nid: {id}", about(item));
        let message = escaped(&about(item));
        let inner = match item.settled {
            Some(why) => {
                suite.skipped += 1;
                let why = match why {
                    Reason::Allowed(reason) => format!("allowed: {reason}"),
                    Reason::Known => "known: listed in the baseline".to_owned(),
                };
                format!("<skipped message=\"{}\"/>", escaped(&why))
            }
            None if *severity >= self.fail_on => {
                suite.failures += 1;
                format!("<failure type=\"{code}\" message=\"{message}\">{}</failure>", escaped(&details))
            }
            None => format!("<system-out>{}: {}</system-out>", severity.name(), escaped(&details)),
        };
        let subject = if item.subject.is_empty() { String::new() } else { format!(" {}", item.subject) };
        suite.case(&format!("{code}{subject} line {line}"), &inner);
    }
}

/// Test suite of one file.
#[derive(Default)]
struct Suite {
    file: String,
    tests: usize,
    failures: usize,
    errors: usize,
    skipped: usize,
    cases: String,
}

impl Suite {
    fn case(&mut self, name: &str, inner: &str) {
        self.tests += 1;
        let (file, name) = (escaped(&self.file), escaped(name));
        let _ = match inner {
            "" => writeln!(self.cases, "    <testcase classname=\"{file}\" name=\"{name}\"/>"),
            _ => {
                writeln!(self.cases, "    <testcase classname=\"{file}\" name=\"{name}\">{inner}</testcase>")
            }
        };
    }
}

/// Escapes text for XML, and replaces characters that XML cannot represent.
fn escaped(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            '\n' => escaped.push_str("&#10;"),
            '\t' => escaped.push_str("&#9;"),
            c if c.is_control() || "\u{fffe}\u{ffff}".contains(c) => escaped.push('\u{fffd}'),
            c => escaped.push(c),
        }
    }
    escaped
}
