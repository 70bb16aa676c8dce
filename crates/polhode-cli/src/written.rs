//! Output formats of worked solutions and exercises.

use clap::Args;
use polhode_document::Report;
use polhode_document::json::pretty;

use crate::failure::Failure;
use crate::stdout::print;

/// Output format of a text with formulas; the default is plain text.
#[derive(Clone, Copy, Debug, Args)]
pub(crate) struct Written {
    /// Print Markdown with typeset formulas, for GitHub, Jupyter and pandoc.
    #[arg(long, group = "form")]
    markdown: bool,
    /// Print a self-contained HTML page with typeset formulas and graphs.
    #[arg(long, group = "form")]
    html: bool,
    /// Print a LaTeX article.
    #[arg(long, group = "form")]
    latex: bool,
    /// Print JSON: sections, formulas and tables as data.
    #[arg(long, group = "form")]
    json: bool,
    /// Line width of the text, characters.
    #[arg(long, value_name = "N", default_value_t = 100, conflicts_with = "form", value_parser = clap::value_parser!(u16).range(40..=400))]
    width: u16,
}

impl Written {
    /// Prints a report.
    ///
    /// # Errors
    /// [`Failure::Findings`] if the report has findings.
    pub(crate) fn print(self, report: &dyn Report) -> Result<(), Failure> {
        let text = if self.json {
            pretty(&report.to_json()) + "\n"
        } else if self.markdown {
            report.to_document().to_markdown()
        } else if self.html {
            report.to_document().to_html()
        } else if self.latex {
            report.to_document().to_latex()
        } else {
            report.to_text(Some(usize::from(self.width)))
        };
        print(&text)?;
        if report.has_failed() { Err(Failure::Findings) } else { Ok(()) }
    }
}
