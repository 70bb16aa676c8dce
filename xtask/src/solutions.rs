//! Rendering of all worked solutions by other programs.
//!
//! pandoc must read the Markdown and the LaTeX without warnings. MathJax, used by GitHub and
//! Jupyter, must typeset each formula.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::examples::has_no_solution;
use crate::process::{empty_folder, output, polhode, run_beside};
use crate::{Outcome, files, root, short};

/// Checks the solutions; requires the packages installed for the viewer's tests.
pub(crate) fn check(pandoc: &Path) -> Outcome {
    let folder = empty_folder("solutions")?;
    write(&folder)?;
    let [markdown, latex] = [files(&folder, "md")?, files(&folder, "tex")?];
    let quiet = |from: &str, to: &[&str], inputs: &[PathBuf]| {
        let mut command = Command::new(pandoc);
        command.args(["--fail-if-warnings", "--from", from]).args(to).args(inputs);
        output(&mut command).map(drop)
    };
    // The first dialect is that of GitHub, the second that of pandoc.
    quiet("gfm+tex_math_dollars", &["--to", "html", "--mathml"], &markdown)?;
    quiet("markdown", &["--to", "latex"], &markdown)?;
    for article in &latex {
        quiet("latex", &["--to", "html", "--mathml"], std::slice::from_ref(article))?;
    }
    println!("   pandoc: {} solutions as Markdown and as LaTeX", markdown.len());
    run_beside(Command::new("node").arg(root().join("viewer/test/mathjax.mjs")).args(&markdown))
}

/// Writes the solution of each example as Markdown and as LaTeX.
fn write(folder: &Path) -> Outcome {
    let polhode = polhode()?;
    let is_scenario = |path: &PathBuf| !short(path).starts_with("examples/identify");
    for (k, scenario) in files(&root().join("examples"), "toml")?.into_iter().filter(is_scenario).enumerate()
    {
        if has_no_solution(&scenario)? {
            continue;
        }
        for (option, extension) in [("--markdown", "md"), ("--latex", "tex")] {
            let text = output(Command::new(&polhode).arg("explain").arg(&scenario).arg(option))?;
            let file = folder.join(format!("{k:02}.{extension}"));
            std::fs::write(&file, text).map_err(|error| format!("{}: {error}", file.display()))?;
        }
    }
    Ok(())
}
