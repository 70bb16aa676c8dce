//! Page of an audit.

use std::fmt::Write as _;

use super::Audited;
use super::count::{Counts, NO_BODY, RuleCounts};

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
        "# Findings in public robot models\n\nWritten by `cargo xtask corpus`: `polhode check` in {} public repositories.\n\n",
        audited.len()
    );
    let _ = writeln!(
        text,
        "{} models{parts} have {} links and {} inertials. **{} of {} files with an inertial have \
         an unphysical mass or tensor, {}**. {} files have an impossible finding of any kind, {} a suspect one.",
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
            "Without the largest repository, {}: {} of {}, {}.",
            largest.repository.name,
            count(bodies),
            count(weighed),
            percent(bodies, weighed),
        );
    }
    let rules: Vec<String> = NO_BODY.into_iter().map(linked).collect();
    let _ = writeln!(
        text,
        "\nUnphysical are impossible findings of {}; missing or invalid numbers and errors of the tree do not count.",
        rules.join(", ")
    );
    text
}

/// Returns a rule with a link to its explanation.
fn linked(code: &str) -> String {
    format!("[{code}](rules.md#{})", code.replace('.', ""))
}

fn by_repository(text: &mut String, audited: &[Audited], all: &Counts) {
    let languages =
        LANGUAGES.map(|(key, name)| format!("{} {name}", count(all.read.get(key).copied().unwrap_or(0))));
    let _ = write!(
        text,
        "\n## By repository\n\nModels: {}; refused: {}. Not counted are {} copies with the same bytes, and {} files in folders of tests. The link has \
         the commit.\n\n| repository | models | inertials | files with impossible | impossible | suspect |\n|---|{}\n",
        languages.join(", "),
        refused(all),
        count(all.copies),
        count(all.tests),
        "--:|".repeat(5)
    );
    let (impossible, others): (Vec<_>, Vec<_>) = audited.iter().partition(|one| one.counts.findings(0) > 0);
    let link = |Audited { repository, .. }: &&Audited| {
        let name = &repository.name;
        format!("[{name}](https://github.com/{name}/tree/{})", repository.commit)
    };
    for one in &impossible {
        let _ = write!(text, "| {} |", link(one));
        row(text, &one.counts);
    }
    text.push_str("| **all** |");
    row(text, all);
    let others: Vec<_> = others.iter().map(link).collect();
    if !others.is_empty() {
        let _ = writeln!(text, "\nWithout impossible findings: {}.", others.join(", "));
    }
}

fn row(text: &mut String, counts: &Counts) {
    let numbers =
        [counts.files_read(), counts.inertials, counts.files[0], counts.findings(0), counts.findings(1)];
    for number in numbers {
        let _ = write!(text, " {} |", if number == 0 { String::new() } else { count(number) });
    }
    text.push('\n');
}

fn by_rule(text: &mut String, all: &Counts) {
    text.push_str("\n## By rule\n\nFiles and repositories include those with notes only.\n\n| rule | impossible | suspect | files | repositories |\n|---|--:|--:|--:|--:|\n");
    let is_shown = |counts: &RuleCounts| counts.findings[..2] != [0, 0];
    let mut rules: Vec<_> = all.rules.iter().filter(|(_, counts)| is_shown(counts)).collect();
    rules.sort_by(|(code, counts), (other, others)| {
        others.findings.cmp(&counts.findings).then_with(|| code.cmp(other))
    });
    for (code, counts) in rules {
        let _ = write!(text, "| {} |", linked(code));
        for number in [counts.findings[0], counts.findings[1], counts.files, counts.repositories] {
            let _ = write!(text, " {} |", if number == 0 { String::new() } else { count(number) });
        }
        text.push('\n');
    }
}

/// Returns the reasons of refusals with their numbers of files.
fn refused(all: &Counts) -> String {
    let mut reasons: Vec<_> = all.refused.iter().collect();
    reasons.sort_by(|(reason, files), (other, others)| others.cmp(files).then_with(|| reason.cmp(other)));
    if reasons.is_empty() {
        return "none".to_owned();
    }
    let reasons = reasons.into_iter().map(|(reason, files)| format!("{} {reason}", count(*files)));
    reasons.collect::<Vec<_>>().join(", ")
}

fn how(text: &mut String, audited: &[Audited]) {
    let seconds: f64 = audited.iter().map(|one| one.cost.seconds).sum();
    let memory = audited.iter().map(|one| one.cost.memory).max().unwrap_or(0);
    let cost = if memory > 0 {
        format!(" All took {seconds:.0} s of processor time, at most {memory} MiB.")
    } else {
        String::new()
    };
    let absent: usize = audited.iter().map(|one| one.repository.absent).sum();
    let _ = write!(
        text,
        "\n## Method\n\n`cargo xtask corpus FOLDER…` runs `polhode check . --json` in each work tree, named by `origin` or by OWNER/NAME at the end of its path, \
         with the folders around all packages (`package.xml`, `model.config`) as `--root`.{cost}\n\n\
         - The repositories are well known ones, not a sample of all robots.\n- Some simulators accept unphysical tensors.\n- The work trees were snapshots without large files: {} of the commits' files \
         and the symbolic links were missing. Meshes ([geometry.unreadable](rules.md#geometryunreadable)) and files elsewhere \
         ([read.include](rules.md#readinclude)) are not in the numbers.\n- `.xacro` files were not expanded.\n",
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
