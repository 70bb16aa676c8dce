//! Outcomes of calls.

use polhode_document::Report;
use polhode_document::layout::printable_lines;
use polhode_source::Failure;
use serde_json::{Value, json};

/// Largest size of a text with its report, bytes. A larger one would fill the context of a model.
const LARGEST: usize = 1_000_000;

/// Outcome of a call: what the command prints, its JSON and its exit status.
#[derive(Debug)]
pub(crate) struct Outcome {
    text: String,
    report: Option<Value>,
    /// Exit status of the command for the same request.
    status: u8,
}

impl Outcome {
    /// Creates the outcome of a report; failures are those of some of its files.
    pub(crate) fn of<'a>(
        report: &dyn Report,
        mut text: String,
        failures: impl Iterator<Item = &'a Failure>,
    ) -> Self {
        let mut statuses = vec![u8::from(report.has_failed())];
        for failure in failures {
            text += if text.is_empty() { "" } else { "\n" };
            text += &failure.to_string();
            statuses.push(status(failure));
        }
        // From the best to the worst.
        let worst = [0, 1, 3, 2].into_iter().rfind(|status| statuses.contains(status));
        Self { text, report: Some(report.to_json()), status: worst.unwrap_or_default() }
    }

    /// Returns the result of the call.
    pub(crate) fn to_result(&self) -> Value {
        let report = self.report.as_ref().map(Value::to_string).unwrap_or_default();
        let size = self.text.len() + report.len();
        if size > LARGEST {
            return Self::from(Failure::usage(
                format!("the result has {size} bytes; a tool returns at most {LARGEST}"),
                "ask for fewer files or states, or run the command, which writes results of any size",
            ))
            .to_result();
        }
        let mut result = json!({
            "content": [{ "type": "text", "text": printable_lines(&self.text) }],
            "isError": self.status >= 2,
        });
        if let Some(report) = &self.report {
            result["structuredContent"] = json!({ "exit_status": self.status, "report": report });
        }
        result
    }
}

impl From<Failure> for Outcome {
    fn from(failure: Failure) -> Self {
        Self { text: failure.to_string(), report: None, status: status(&failure) }
    }
}

fn status(failure: &Failure) -> u8 {
    if failure.is_numerical() { 3 } else { 2 }
}

#[cfg(test)]
mod tests {
    use polhode::motion::MotionError;
    use polhode_document::Document;

    use super::*;

    /// Report with a text of this length.
    struct Long(usize);

    impl Report for Long {
        fn to_json(&self) -> Value {
            "a".repeat(self.0).into()
        }

        fn to_document(&self) -> Document {
            Document::of_text("", "")
        }

        fn has_failed(&self) -> bool {
            true
        }
    }

    #[test]
    fn a_result_that_is_too_large_is_refused() {
        let of = |length: usize| Outcome::of(&Long(length), "text".to_owned(), [].iter()).to_result();
        // The text, and the quotation marks of the report.
        let most = LARGEST - 4 - 2;
        assert_eq!(of(most)["structuredContent"]["exit_status"], 1);
        let refused = of(most + 1);
        assert_eq!((&refused["isError"], refused.get("structuredContent")), (&true.into(), None));
        let text = refused["content"][0]["text"].as_str().unwrap_or_default();
        assert!(text.starts_with("error: the result has 1000001 bytes") && text.contains("hint: "), "{text}");
    }

    #[test]
    fn of_several_failures_the_worst_counts() {
        let numerical = Failure::of_motion("a.toml".as_ref(), MotionError::NotFinite { time: 1.0 });
        let both = [Failure::usage("no", "hint"), numerical];
        let [usage, numerical] = &both;
        let status =
            |failures: &[&Failure]| Outcome::of(&Long(1), String::new(), failures.iter().copied()).status;
        assert_eq!((status(&[]), status(&[numerical]), status(&[usage, numerical])), (1, 3, 2));
    }
}
