//! Text report of a checked model: the verdict and the effect of `--fix`, the counts, then each
//! finding with its place, rule and fix.
//!
//! The marks are ✗ impossible, ! suspect, · note. No information depends on colour.

use std::fmt::Write as _;

use polhode_document::layout::{WIDTH, plain_spaces, printable, wrap};
use polhode_source::text::counted;

use crate::finding::{Finding, Proposal, Severity};
use crate::line_index::{FilePlace, Places};
use crate::policy::{Judged, Reason, Settled};
use crate::repair::Left;
use crate::report::{CheckReport, Counts, Fixed, Prospect, format_name};

/// Indentation of the lines below the first line of a finding.
const INDENT: &str = "    ";

impl CheckReport {
    /// Returns the report in lines of at most 100 columns.
    pub fn to_text(&self) -> String {
        let mut text = self.heading();
        let places = Places::of(&self.model);
        let subjects = || self.findings().iter().map(|f| subject(f).chars().count());
        let longest = subjects().filter(|&width| width <= 24).max().unwrap_or(0);
        for (k, finding) in self.findings().iter().enumerate() {
            let FilePlace { file, line, column, .. } = places.place(&finding.span);
            let file = printable(&file.to_string_lossy());
            let subject = subject(finding);
            let start = if k == 0 { "\n" } else { "" };
            let _ = writeln!(
                text,
                "{start}{} {subject:longest$}   {file}:{line}:{column}   [{}]",
                mark(finding.severity),
                finding.code
            );
            paragraph(&mut text, "", &finding.message);
            paragraph(&mut text, "rule: ", &finding.rule);
            if let Some(repair) = &finding.repair {
                paragraph(&mut text, "fix: ", &repair.description);
            }
            for (label, line) in finding.nearest.iter().flat_map(Proposal::lines) {
                paragraph(&mut text, "", &format!("{label}{line}"));
            }
        }
        self.write_settled(&mut text, &places);
        if let Some(fixed) = &self.fixed {
            self.write_fixed(&mut text, fixed);
        }
        plain_spaces(&text)
    }

    fn heading(&self) -> String {
        let (links, inertials) = (self.model.links.len(), self.inertials());
        let row = |of: &str, Counts { impossible, suspect, note }: Counts| {
            format!("{of:<10} IMPOSSIBLE {impossible}   SUSPECT {suspect}   NOTE {note}")
        };
        let by_link = self.link_counts();
        let nearest = if self.findings().iter().any(|finding| finding.nearest.is_some()) {
            "nearest possible tensors: for the same mass and centre of mass; a fix, a measured or a computed tensor is better\n"
        } else {
            ""
        };
        format!(
            "{}   {}, {}, {}\n\
             {}\n\
             {}tensors about the centre of mass, along the inertial frame's axes, off-diagonal = -∫xy dm\n\
             {nearest}{}\n{}   OK {} of {links}\n",
            printable(&self.model.path.to_string_lossy()),
            format_name(self.model.format),
            counted(links, "link"),
            counted(inertials, "inertial"),
            self.verdict(),
            self.advice(),
            row("findings", self.counts()),
            row("links", by_link),
            links.saturating_sub(by_link.sum()),
        )
    }

    /// Writes the allowed findings with their reasons, and the numbers of known findings and of
    /// findings of disabled rules.
    fn write_settled(&self, text: &mut String, places: &Places<'_>) {
        let Judged { settled, off, .. } = &self.judged;
        if settled.is_empty() && *off == 0 {
            return;
        }
        text.push('\n');
        for Settled { finding, why, .. } in settled {
            let Reason::Allowed(reason) = why else { continue };
            let FilePlace { file, line, column, .. } = places.place(&finding.span);
            let file = printable(&file.to_string_lossy());
            let (subject, code) = (subject(finding), finding.code);
            let _ =
                writeln!(text, "allowed: {subject} {file}:{line}:{column} [{code}]: {}", printable(reason));
        }
        let known = settled.iter().filter(|settled| settled.why == Reason::Known).count();
        if known > 0 {
            let _ = writeln!(text, "known: {}, listed in the baseline", counted(known, "finding"));
        }
        if *off > 0 {
            let _ = writeln!(text, "off: {} of disabled rules", counted(*off, "finding"));
        }
    }

    /// Returns the answer to "Is the model right?", one line.
    fn verdict(&self) -> String {
        let Counts { impossible, suspect, note } = self.counts();
        let links = counted(self.model.links.len(), "link");
        let settled = self.judged.settled.len() + self.judged.off;
        match (impossible, suspect) {
            (0, 0) if settled > 0 => {
                format!(
                    "No open finding: {} allowed, known or of disabled rules.",
                    counted(settled, "finding")
                )
            }
            (0, 0) if note > 0 => format!("No error: {}; {}.", self.soundness(), counted(note, "note")),
            (0, 0) => format!("No finding: {}.", self.soundness()),
            (_, 0) => format!("Not right: {} in {links}.", counted(impossible, "impossible finding")),
            (0, _) => format!("Not right: {} in {links}.", counted(suspect, "suspect finding")),
            _ => format!(
                "Not right: {impossible} impossible and {} in {links}.",
                counted(suspect, "suspect finding")
            ),
        }
    }

    /// Returns the meaning of a check without findings.
    fn soundness(&self) -> String {
        let inertials = self.inertials();
        if inertials == 0 {
            return "the model has no inertial".to_owned();
        }
        let measured = self.model.links.iter().zip(&self.geometry);
        let compared = measured
            .filter(|(link, _)| link.inertial.is_some())
            .filter(|(_, geometry)| !geometry.volumes.is_empty() && !geometry.is_incomplete)
            .count();
        let is_incomplete = self.geometry.iter().any(|geometry| geometry.is_incomplete);
        let are = if inertials == 1 { "is" } else { "are" };
        let possible = format!("{} {are} physically possible", counted(inertials, "inertial"));
        match (compared, inertials) {
            (0, _) if is_incomplete => {
                format!("{possible}; no geometry can be measured as a whole, so nothing was compared")
            }
            (0, _) => format!("{possible}; without geometry, nothing was compared"),
            (1, 1) => format!("{possible} and agrees with its geometry"),
            (1, _) => format!("{possible}; 1 has geometry and agrees with it"),
            _ if compared == inertials => format!("{possible} and agree with their geometry"),
            _ => format!("{possible}; {compared} have geometry and agree with it"),
        }
    }

    /// Returns the effect of `--fix` as a line, if there are findings above note and no fix was
    /// requested; empty otherwise.
    fn advice(&self) -> String {
        if self.fixed.is_some() {
            return String::new();
        }
        let Prospect { changes, remaining } = self.prospect();
        let values = counted(changes, "value");
        if changes > 0 && self.model.expansion.is_some() {
            return format!(
                "--fix prints the correction of {values} in the expanded text; edit the macros.\n"
            );
        }
        match (changes, remaining) {
            (0, 0) => String::new(),
            (0, _) => format!("No automatic fix is certain: {} a manual fix.\n", needs(remaining)),
            (_, 0) => format!("--fix OUT corrects {values}; then no finding remains.\n"),
            _ => format!("--fix OUT corrects {values}; then {} a manual fix.\n", needs(remaining)),
        }
    }

    /// Returns the known repairs that were not applied, one line each.
    pub fn not_repaired(&self) -> String {
        let mut text = String::new();
        for Left { finding, why } in self.fixed.iter().flat_map(|fixed| &fixed.repaired.left) {
            if let Some(finding) = self.findings().get(*finding) {
                let words = format!("{} [{}]: {}", subject(finding), finding.code, why.in_words());
                paragraph(&mut text, "not fixed: ", &words);
            }
        }
        text
    }

    fn write_fixed(&self, text: &mut String, fixed: &Fixed) {
        let Fixed { out, repaired, remaining, .. } = fixed;
        text.push('\n');
        text.push_str(&self.not_repaired());
        let Some(out) = out else { return };
        let rest = remaining.iter().filter(|f| f.severity > Severity::Note).count();
        let (out, changes) = (printable(out), counted(repaired.changes, "value"));
        let _ = match rest {
            0 if repaired.changes == 0 => writeln!(text, "wrote {out}: nothing to fix"),
            0 => writeln!(text, "wrote {out}: {changes} corrected; no finding remains"),
            _ => writeln!(text, "wrote {out}: {changes} corrected; {} a manual fix", needs(rest)),
        };
    }
}

pub(crate) const fn mark(severity: Severity) -> char {
    match severity {
        Severity::Impossible => '✗',
        Severity::Suspect => '!',
        Severity::Note => '·',
    }
}

/// Returns the name of the link, or "the model".
pub(crate) fn subject(finding: &Finding) -> String {
    if finding.subject.is_empty() { "the model".to_owned() } else { printable(&finding.subject) }
}

pub(crate) fn paragraph(text: &mut String, label: &str, sentence: &str) {
    if sentence.is_empty() {
        return;
    }
    let hang = format!("{INDENT}{}", " ".repeat(label.len()));
    for (k, line) in wrap(&printable(sentence), &hang, WIDTH).iter().enumerate() {
        match line.strip_prefix(&hang) {
            Some(line) if k == 0 => text.push_str(&format!("{INDENT}{label}{line}\n")),
            _ => text.push_str(&format!("{line}\n")),
        }
    }
}

/// Returns a count with its verb: `1 finding needs`, `2 findings need`
fn needs(count: usize) -> String {
    format!("{} {}", counted(count, "finding"), if count == 1 { "needs" } else { "need" })
}
