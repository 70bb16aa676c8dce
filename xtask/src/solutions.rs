//! Rendering of all documents with formulas by other programs.
//!
//! pandoc must read the Markdown and the LaTeX without warnings. MathJax, used by GitHub and
//! Jupyter, must typeset each formula. LaTeX must typeset each article, where it is installed.

use std::path::{Path, PathBuf};
use std::process::Command;

use serde_json::Value as Json;

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
    println!("   pandoc: {} documents as Markdown and as LaTeX", markdown.len());
    if Command::new("pdflatex").arg("--version").output().is_ok_and(|found| found.status.success()) {
        for article in &latex {
            let mut command = Command::new("pdflatex");
            command.args(["-interaction=nonstopmode", "-halt-on-error", "-output-directory"]);
            output(command.arg(&folder).arg(article)).map(drop)?;
        }
        println!("   pdflatex: {} articles", latex.len());
    }
    run_beside(Command::new("node").arg(root().join("viewer/test/mathjax.mjs")).args(&markdown))
}

/// Writes all documents with formulas as Markdown and as LaTeX: the solution of each example, the
/// derivations, and an exercise of each topic with its solution.
fn write(folder: &Path) -> Outcome {
    let polhode = polhode()?;
    let is_scenario = |path: &PathBuf| !short(path).starts_with("examples/identify");
    let mut count = 0;
    let mut document = |arguments: &[&str]| -> Outcome {
        for (option, extension) in [("--markdown", "md"), ("--latex", "tex")] {
            let text = output(Command::new(&polhode).args(arguments).arg(option))?;
            let file = folder.join(format!("{count:03}.{extension}"));
            std::fs::write(&file, text).map_err(|error| format!("{}: {error}", file.display()))?;
        }
        count += 1;
        Ok(())
    };
    for scenario in files(&root().join("examples"), "toml")?.into_iter().filter(is_scenario) {
        if !has_no_solution(&scenario)? {
            document(&["explain", &scenario.to_string_lossy()])?;
        }
    }
    let listed = |arguments: &[&str]| -> Result<Json, String> {
        let text = output(Command::new(&polhode).args(arguments).arg("--json"))?;
        serde_json::from_str(&text).map_err(|error| format!("{arguments:?}: {error}"))
    };
    let derivations = listed(&["explain", "--derive"])?;
    for row in derivations["sections"][0]["blocks"][0]["rows"].as_array().into_iter().flatten() {
        document(&["explain", "--derive", row[0].as_str().unwrap_or_default()])?;
    }
    let exercises = listed(&["exercise"])?;
    for topic in exercises["topics"].as_array().into_iter().flatten() {
        let name = topic["topic"].as_str().unwrap_or_default();
        document(&["exercise", name, "--solution=after"])?;
        if topic["symbols"] == true {
            document(&["exercise", name, "--symbols", "--solution=after"])?;
        }
    }
    Ok(())
}
