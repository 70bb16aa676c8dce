//! Report of a sweep: statistics, figures and the plan.

use polhode::body::{Finding, Severity};
use polhode_document::number::count;
use polhode_document::{Document, Level, Report, Section, Verdict};
use serde_json::Value;

use crate::figures::SweepFigures;
use crate::plan::Plan;
use crate::report::{SweepSample, SweepSummary};

/// Result of a [`Request`](crate::Request).
#[derive(Clone, Debug, PartialEq)]
pub struct Swept {
    /// Statistics over the members.
    pub summary: SweepSummary,
    /// Some of the members, for figures.
    pub sample: SweepSample,
    /// Findings about the plan.
    pub findings: Vec<Finding>,
    /// Text of the plan.
    pub plan: String,
}

/// Explanation of the two figures of each question.
const QUESTIONS: &str = "Figures of each question: sampled members over the most decisive input; and the share with its 95 % confidence interval, for an increasing number of members.";

impl Swept {
    pub(crate) fn new(summary: SweepSummary, sample: SweepSample, plan: &Plan) -> Self {
        Self { summary, sample, findings: plan.findings(), plan: plan.text().to_owned() }
    }

    /// Returns the figures.
    pub const fn figures(&self) -> SweepFigures<'_> {
        SweepFigures::new(&self.summary, &self.sample)
    }

    /// Returns the verdict: whether all members have a motion. The answers have no verdict.
    fn verdict(&self) -> Verdict {
        let failed = self.summary.statuses.iter().filter(|status| status.name == "failed");
        let failed: u64 = failed.map(|status| status.count).sum();
        let members = count(self.summary.members);
        match failed {
            0 if self.findings.iter().any(|finding| finding.severity != Severity::Info) => {
                Verdict::new(Level::Warning, "Read the warnings about the plan")
            }
            0 => Verdict::new(Level::Ok, format!("All {members} members have a motion")),
            _ => Verdict::new(Level::Warning, format!("{} of {members} members failed", count(failed))),
        }
    }
}

impl Report for Swept {
    fn to_json(&self) -> Value {
        self.summary.to_json()
    }

    fn to_document(&self) -> Document {
        let mut document = self.summary.to_document(self.findings.clone());
        document.verdict = Some(self.verdict());
        let figures = self.figures();
        for section in &mut document.sections {
            let (note, pictures) = match section.title.as_str() {
                "Questions" => {
                    section.say(QUESTIONS);
                    let pictures = figures.each_question();
                    for (question, pictures) in self.summary.questions.iter().zip(pictures.chunks(2)) {
                        section.say(format!("{}:", question.name));
                        pictures.iter().for_each(|picture| section.picture(picture.clone()));
                    }
                    continue;
                }
                "Outcomes" => figures.each_histogram(),
                "Errors and correlations" => figures.each_pair(),
                _ => continue,
            };
            if !pictures.is_empty() {
                section.say(note);
                pictures.into_iter().for_each(|picture| section.picture(picture));
            }
        }
        let mut plan = Section::new(document.sections.len() as u8 + 1, "Plan");
        self.plan.lines().for_each(|line| plan.line(line));
        document.sections.push(plan);
        document
    }
}
