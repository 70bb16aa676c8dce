//! Page of an audit.

use std::fmt::Write as _;

use super::Audited;
use super::count::{Counts, NO_BODY};

/// Names of the languages.
const LANGUAGES: [(&str, &str); 5] =
    [("urdf", "URDF"), ("sdf", "SDF"), ("mjcf", "MJCF"), ("usd", "USD"), ("osim", "OpenSim")];

/// Returns the page; it is reproducible except for run time and memory.
pub(super) fn text(audited: &[Audited]) -> String {
    let mut all = Counts::default();
    audited.iter().for_each(|one| all.join(&one.counts));
    let mut text = introduction(audited, &all);
    by_repository(&mut text, audited, &all);
    by_rule(&mut text, &all);
    refused(&mut text, &all);
    how(&mut text, audited);
    text
}

fn introduction(audited: &[Audited], all: &Counts) -> String {
    let read = all.files_read();
    let largest = audited.iter().max_by_key(|one| one.counts.files_read());
    let parts = match all.parts {
        0 => String::new(),
        parts => format!(", and {} more files that they include", count(parts)),
    };
    let mut text = format!(
        "# Findings in public robot models\n\nWritten by `cargo xtask corpus`; run it again rather than believe this page. What `polhode check` finds in {} public \
         repositories, each at the commit that is named below. No model is kept here.\n\n",
        audited.len()
    );
    let _ = writeln!(
        text,
        "{} different models were read{parts}, with {} links and {} inertials. **{} of {} files that say a mass have \
         one that no body has, {}**: a tensor, or a mass. {} files have an impossible finding of any kind, {} a suspect one.",
        count(read),
        count(all.links),
        count(all.inertials),
        count(all.impossible_bodies),
        count(all.weighed),
        percent(all.impossible_bodies, all.weighed),
        count(all.files[0]),
        count(all.files[1]),
    );
    if let Some(largest) = largest.filter(|_| audited.len() > 1) {
        let (bodies, weighed) =
            (all.impossible_bodies - largest.counts.impossible_bodies, all.weighed - largest.counts.weighed);
        let _ = writeln!(
            text,
            "Without the repository of most files, {}, it is {} of {}, {}.",
            largest.repository.name,
            count(bodies),
            count(weighed),
            percent(bodies, weighed),
        );
    }
    let rules: Vec<String> = NO_BODY.into_iter().map(linked).collect();
    let _ = writeln!(
        text,
        "\nA file says a mass if an inertial stands in it. It has one that no body has if one of these rules finds it impossible: {}. A mass or tensor that \
         is left out, or is no number, is not counted there, nor what is wrong with the tree. Links, inertials and findings are those of the file in \
         which they stand, once, however many models include it; where these disagree the worst counts.",
        rules.join(", ")
    );
    text
}

/// Returns a rule with a link to its explanation.
fn linked(code: &str) -> String {
    format!("[{code}](rules.md#{})", code.replace('.', ""))
}

fn by_repository(text: &mut String, audited: &[Audited], all: &Counts) {
    text.push_str(
        "\n## By repository\n\nModels that were read by language, files that were refused, and findings: a finding may name several links. A file \
         with the same bytes as one in a row above, or in the same row, is a copy and not counted, and neither is one in a folder of tests, where \
         models are wrong on purpose.\n\n| repository | commit | date | URDF | SDF | MJCF | USD | OpenSim | refused | copies | in tests | links | \
         inertials | files with impossible | impossible | suspect | notes |\n|---|---|---|",
    );
    text.push_str(&"--:|".repeat(14));
    text.push('\n');
    for Audited { repository, counts, .. } in audited {
        let name = &repository.name;
        let commit: String = repository.commit.chars().take(9).collect();
        let _ = write!(
            text,
            "| [{name}](https://github.com/{name}) | [{commit}](https://github.com/{name}/tree/{}) | {} |",
            repository.commit, repository.date
        );
        row(text, counts);
    }
    text.push_str("| **all** | | |");
    row(text, all);
}

fn row(text: &mut String, counts: &Counts) {
    let languages = LANGUAGES.iter().map(|(key, _)| counts.read.get(*key).copied().unwrap_or(0));
    let rest = [
        counts.refused.values().sum(),
        counts.copies,
        counts.tests,
        counts.links,
        counts.inertials,
        counts.files[0],
        counts.findings(0),
        counts.findings(1),
        counts.findings(2),
    ];
    for number in languages.chain(rest) {
        let _ = write!(text, " {} |", if number == 0 { String::new() } else { count(number) });
    }
    text.push('\n');
}

fn by_rule(text: &mut String, all: &Counts) {
    text.push_str(
        "\n## By rule\n\n| rule | impossible | suspect | notes | files | repositories |\n|---|--:|--:|--:|--:|--:|\n",
    );
    let mut rules: Vec<_> = all.rules.iter().collect();
    rules.sort_by(|(code, counts), (other, others)| {
        others.findings.cmp(&counts.findings).then_with(|| code.cmp(other))
    });
    for (code, counts) in rules {
        let _ = write!(text, "| {} |", linked(code));
        for number in counts.findings.into_iter().chain([counts.files, counts.repositories]) {
            let _ = write!(text, " {} |", if number == 0 { String::new() } else { count(number) });
        }
        text.push('\n');
    }
}

fn refused(text: &mut String, all: &Counts) {
    if all.refused.is_empty() {
        return;
    }
    text.push_str("\n## Refused\n\n| why | files |\n|---|--:|\n");
    let mut reasons: Vec<_> = all.refused.iter().collect();
    reasons.sort_by(|(reason, files), (other, others)| others.cmp(files).then_with(|| reason.cmp(other)));
    for (reason, files) in reasons {
        let _ = writeln!(text, "| {} | {} |", reason.replace('|', "\\|"), count(*files));
    }
}

fn how(text: &mut String, audited: &[Audited]) {
    let seconds: f64 = audited.iter().map(|one| one.cost.seconds).sum();
    let memory = audited.iter().map(|one| one.cost.memory).max().unwrap_or(0);
    let cost = if memory > 0 {
        format!(" All together took {seconds:.0} s of a processor, and {memory} MiB of memory at most.")
    } else {
        String::new()
    };
    let absent: usize = audited.iter().map(|one| one.repository.absent).sum();
    let _ = write!(
        text,
        "\n## How\n\n```console\n$ cargo xtask corpus FOLDER…\n```\n\nEach folder is a work tree of a repository, at any commit; its name is that of \
         `origin`, or OWNER/NAME at the end of its path. In it `polhode check . --json` runs, with the folders around all packages \
         (`package.xml`, `model.config`) as `--root`.{cost}\n\n\
         What these numbers are not:\n\n- A sample of all robots: the repositories are those that are well known and could be had.\n- A verdict on \
         programs: some simulators take a tensor that no body has, and go on.\n- Complete. The work trees were snapshots that lack large files: {} of \
         the commits' files were not there, nor symbolic links. What a mesh would have said of a link that lacks it is not in the numbers \
         ([geometry.unreadable](rules.md#geometryunreadable)), and neither is what files elsewhere say \
         ([read.include](rules.md#readinclude)).\n- Of macros: `.xacro` files are no models before they are expanded, and were not.\n",
        count(absent)
    );
}

/// Formats a number with digit groups: `12,345`.
fn count(number: usize) -> String {
    let digits = number.to_string();
    let mut grouped = String::new();
    for (k, digit) in digits.chars().enumerate() {
        if k > 0 && (digits.len() - k).is_multiple_of(3) {
            grouped.push(',');
        }
        grouped.push(digit);
    }
    grouped
}

/// Formats a fraction as a percentage with two digits.
fn percent(part: usize, whole: usize) -> String {
    let percent = 100.0 * part as f64 / whole.max(1) as f64;
    if percent < 10.0 { format!("{percent:.1} %") } else { format!("{percent:.0} %") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_for_people() {
        assert_eq!([0, 999, 1000, 1_234_567].map(count), ["0", "999", "1,000", "1,234,567"]);
        assert_eq!([percent(1, 3), percent(1, 30), percent(0, 0)], ["33 %", "3.3 %", "0.0 %"]);
    }
}
