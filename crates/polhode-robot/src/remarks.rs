//! What a reader noticed, for whoever takes bodies from a model: remarks beside the numbers, or a reason not to take them.

use std::error::Error;
use std::fmt;

use polhode::body::{Finding, Severity};

use crate::finding::Severity as NoteSeverity;
use crate::line_index::{FilePlace, Places};
use crate::model::{Note, RobotModel, Span};

/// A model that says a body's numbers twice, and not the same.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Contradiction {
    /// The link or joint.
    pub link: String,
    /// What, in a line.
    pub message: String,
    /// Where in the model's text.
    pub span: Span,
}

impl Contradiction {
    /// What to do about it.
    pub const fn hint(&self) -> &'static str {
        "write each number once; polhode check lists all that is wrong"
    }
}

impl fmt::Display for Contradiction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the file contradicts itself about {:?}: {}", self.link, self.message)
    }
}

impl Error for Contradiction {}

/// Notes that leave a link's numbers open.
const OPEN: [&str; 4] = ["inertia.asymmetric", "inertia.two_forms", "read.twice", "read.inertials"];

/// What is worth knowing beside the numbers of a link, or of all links together (`None`).
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
/// [`Contradiction`] if the file says a number of it in two ways, or has two links of that name.
pub fn remarks(model: &RobotModel, link: Option<&str>) -> Result<Vec<Finding>, Contradiction> {
    let twice = model.links.iter().filter(|other| link == Some(other.name.text.as_str())).nth(1);
    if let Some(second) = twice {
        let message = "another link has the same name".to_owned();
        return Err(Contradiction {
            link: second.name.text.clone(),
            message,
            span: second.name.span.clone(),
        });
    }
    let about = |note: &&Note| note.subject.is_empty() || link.is_none_or(|link| link == note.subject);
    let places = Places::of(model);
    let mut remarks = Vec::new();
    for note in model.notes.iter().filter(about) {
        if OPEN.contains(&note.code) {
            let Note { subject, message, span, .. } = note.clone();
            return Err(Contradiction { link: subject, message, span });
        }
        let FilePlace { file, line, column, .. } = places.place(&note.span);
        let harmless = note.severity == NoteSeverity::Note
            && matches!(note.code, "read.world" | "read.unknown" | "read.package" | "inertia.computed");
        remarks.push(Finding {
            code: note.code,
            severity: if harmless { Severity::Info } else { Severity::Warning },
            message: note.message.clone(),
            place: Some(format!("{}:{line}:{column}", file.display())),
        });
    }
    Ok(remarks)
}
