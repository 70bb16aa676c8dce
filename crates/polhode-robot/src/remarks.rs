//! Notes of the reader for users of a model's bodies: as findings, or as an error if the numbers
//! are ambiguous.

use polhode::body::{Finding, Severity};

use crate::finding::Severity as NoteSeverity;
use crate::line_index::{FilePlace, Places};
use crate::link_error::LinkError;
use crate::model::{Note, RobotModel, Span};

/// Codes of notes that leave a link's numbers ambiguous.
const OPEN: [&str; 4] = ["inertia.asymmetric", "inertia.two_forms", "read.twice", "read.inertials"];

/// Returns the reader's notes about a link, or about all links (`None`).
///
/// ```
/// use polhode_robot::{read::{ReadOptions, read_text}, remarks::remarks};
/// let text = r#"<robot><link name="a"><inertial><mass value="2"/><mass value="3"/></inertial></link></robot>"#;
/// let model = read_text(text, "a.urdf".as_ref(), &ReadOptions::default())?;
/// assert!(remarks(&model, Some("a")).is_err());
/// # Ok::<(), polhode_source::FormatError>(())
/// ```
///
/// # Errors
/// [`LinkError`] if the file states a number twice with different values, or has two links of that
/// name.
pub fn remarks(model: &RobotModel, link: Option<&str>) -> Result<Vec<Finding>, LinkError> {
    let twice = model.links.iter().filter(|other| link == Some(other.name.text.as_str())).nth(1);
    if let Some(second) = twice {
        return Err(contradiction(&second.name.text, "another link has the same name", &second.name.span));
    }
    let about = |note: &&Note| note.subject.is_empty() || link.is_none_or(|link| link == note.subject);
    let places = Places::of(model);
    let mut remarks = Vec::new();
    for note in model.notes.iter().filter(about) {
        if OPEN.contains(&note.code) {
            return Err(contradiction(&note.subject, &note.message, &note.span));
        }
        let FilePlace { file, line, column, .. } = places.place(&note.span);
        let harmless = is_harmless(note);
        remarks.push(Finding {
            code: note.code,
            severity: if harmless { Severity::Info } else { Severity::Warning },
            message: note.message.clone(),
            place: Some(format!("{}:{line}:{column}", file.display())),
        });
    }
    Ok(remarks)
}

/// Returns true for notes that do not concern mass properties.
pub(crate) fn is_harmless(note: &Note) -> bool {
    note.severity == NoteSeverity::Note
        && matches!(note.code, "read.world" | "read.unknown" | "read.package" | "inertia.computed")
}

/// Returns the error of a model that states a body's numbers twice with different values.
fn contradiction(link: &str, message: &str, span: &Span) -> LinkError {
    let message = format!("the file has contradictory values for {link:?}: {message}");
    LinkError::new(message, "write each number once; `polhode check` lists all errors").at(span)
}
