//! Measures the shapes of a model and checks its rules. Also reports the reader's notes and the
//! shapes that could not be measured.

use crate::check::{LinkGeometry, check_for};
use crate::finding::{Finding, Severity};
use crate::geometry::Shapes;
use crate::model::{GeometryShape, Link, Note, RobotModel, Role, Span};
use crate::program::Program;
use crate::rule::rule;
use crate::trace::trace;

/// Result of an inspection.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Inspection {
    /// Measured geometry of each link, in the order of the model's links.
    pub geometry: Vec<LinkGeometry>,
    /// Findings, in file order.
    pub findings: Vec<Finding>,
}

impl Inspection {
    /// Returns the inspection without proposals of nearest possible tensors.
    #[must_use]
    pub fn without_nearest(mut self) -> Self {
        self.findings.iter_mut().for_each(|finding| finding.nearest = None);
        self
    }
}

/// Measures and checks a model. `shapes` caches the meshes for the next model.
///
/// ```
/// use polhode_robot::{geometry::Shapes, inspect::inspect, read::{ReadOptions, read_text}};
/// let text = r#"<robot><link name="a"><inertial><mass value="1.7"/>
///     <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="3"/></inertial></link></robot>"#;
/// let model = read_text(text, "a.urdf".as_ref(), &ReadOptions::default())?;
/// let found = inspect(&model, &Shapes::default());
/// assert_eq!(found.findings[0].code, "inertia.triangle");
/// # Ok::<(), polhode_source::FormatError>(())
/// ```
pub fn inspect(model: &RobotModel, shapes: &Shapes<'_>) -> Inspection {
    inspect_for(model, shapes, &[])
}

/// Measures and checks a model as [`inspect`] does. A rejection by one of these programs is an
/// error instead of a note.
pub fn inspect_for(model: &RobotModel, shapes: &Shapes<'_>, programs: &[Program]) -> Inspection {
    let geometry: Vec<_> = model.links.iter().map(|link| LinkGeometry::of(link, shapes)).collect();
    let mut findings = check_for(model, &geometry, programs);
    for (link, geometry) in model.links.iter().zip(&geometry) {
        findings.append(&mut unmeasured_shapes(link, geometry, shapes));
    }
    findings.extend(model.notes.iter().map(of_note));
    if cfg!(feature = "languages") {
        trace(model, &mut findings);
    }
    findings.sort_by_key(|finding| finding.span.start);
    Inspection { geometry, findings }
}

/// Reports the shapes of a link that could not be measured. A plane has no volume and is not
/// reported.
fn unmeasured_shapes(link: &Link, geometry: &LinkGeometry, shapes: &Shapes<'_>) -> Vec<Finding> {
    let has = |role: &Role| link.geometry.iter().any(|geometry| geometry.role == *role);
    let roles = [Role::Visual, Role::Collision];
    let read_twice = geometry.is_turned_by_some;
    if !read_twice && geometry.volumes.len() == roles.iter().filter(|role| has(role)).count() {
        return Vec::new();
    }
    let flat = |span: &Span| {
        link.geometry.iter().any(|g| g.span == *span && matches!(g.shape, GeometryShape::Other(_)))
    };
    let left_out = roles.into_iter().flat_map(|role| shapes.link(link, role).left_out);
    left_out.filter(|(span, _)| !flat(span)).map(|(span, why)| unmeasured(link, &span, &why)).collect()
}

fn unmeasured(link: &Link, span: &Span, why: &str) -> Finding {
    note(
        "geometry.unreadable",
        &link.name.text,
        span,
        why,
        "a shape that cannot be measured is not compared with the inertia",
    )
}

/// Codes of notes that state a fact and do not report skipped content.
const STATED: [&str; 3] = ["read.package", "read.animated", "inertia.computed"];

fn of_note(note: &Note) -> Finding {
    let own = rule(note.code).filter(|rule| STATED.contains(&rule.code));
    let rule = match (note.severity, own) {
        (_, Some(rule)) => rule.title,
        (Severity::Note, None) => "content that is not read is not checked",
        _ => "a file states each value once, in elements and attributes that programs read",
    };
    let found = self::note(note.code, &note.subject, &note.span, &note.message, rule);
    Finding { severity: note.severity, ..found }
}

fn note(code: &'static str, subject: &str, span: &Span, message: &str, rule: &str) -> Finding {
    Finding::new(code, Severity::Note, subject, span.clone(), message, rule)
}
