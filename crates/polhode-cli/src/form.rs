//! Output formats of reports.

use clap::Args;
use polhode_document::Report;
use polhode_document::json::pretty;

use crate::failure::Failure;
use crate::stdout::{columns, print};

/// Output format of a report; the default is text.
#[derive(Clone, Copy, Debug, Default, Args)]
pub(crate) struct Form {
    /// Print JSON.
    #[arg(long, group = "form")]
    pub(crate) json: bool,
    /// Print Markdown.
    #[arg(long, group = "form")]
    pub(crate) markdown: bool,
    /// Print a self-contained HTML page with plots.
    #[arg(long, group = "form")]
    pub(crate) html: bool,
}

impl Form {
    /// Prints a report.
    ///
    /// # Errors
    /// [`Failure::Findings`] if the report has findings.
    pub(crate) fn print(self, report: &dyn Report) -> Result<(), Failure> {
        print(&self.text(report))?;
        if report.has_failed() { Err(Failure::Findings) } else { Ok(()) }
    }

    /// Returns the option that selects the format, if one is given.
    pub(crate) fn option(self) -> Option<&'static str> {
        let all = [("--json", self.json), ("--markdown", self.markdown), ("--html", self.html)];
        all.into_iter().find_map(|(option, is_given)| is_given.then_some(option))
    }

    /// Returns the report in the selected format.
    pub(crate) fn text(self, report: &dyn Report) -> String {
        if self.json {
            pretty(&report.to_json()) + "\n"
        } else if self.markdown {
            report.to_document().to_markdown()
        } else if self.html {
            report.to_document().to_html()
        } else {
            report.to_text(columns())
        }
    }
}
