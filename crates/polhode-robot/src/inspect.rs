//! A model with its shapes measured and its rules checked: all that is found in it, with what its reader noticed and the shapes that
//! could not be measured.
//!
//! A shape that is missing proves nothing: a link of which one mesh cannot be read has no bounds to compare with, and the set that the
//! mesh belongs to has no volume. The other set, what is touched or what is seen, still has its own.

use crate::check::{LinkGeometry, MadeOf, Shape, check};
use crate::finding::{Finding, Severity};
use crate::geometry::{LinkVolume, Shapes, Volume, VolumeKind};
use crate::model::{GeometryShape, Link, Note, RobotModel, Role, Span};

/// What is found in a model.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Inspection {
    /// What each link looks like, in the order of the model's links.
    pub geometry: Vec<LinkGeometry>,
    /// What is wrong, in the order of the file.
    pub findings: Vec<Finding>,
}

/// Measures and checks a model. `shapes` keeps the meshes that it has read, for the next model that has them.
///
/// ```
/// use polhode_robot::{geometry::Shapes, inspect::inspect, read::{ReadOptions, read_text}};
/// let text = r#"<robot><link name="a"><inertial><mass value="1.7"/>
///     <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="3"/></inertial></link></robot>"#;
/// let model = read_text(text, "a.urdf".as_ref(), &ReadOptions::default())?;
/// let found = inspect(&model, &mut Shapes::default());
/// assert_eq!(found.findings[0].code, "inertia.triangle");
/// # Ok::<(), polhode_formats::FormatError>(())
/// ```
pub fn inspect(model: &RobotModel, shapes: &mut Shapes) -> Inspection {
    let mut unread = Vec::new();
    let geometry: Vec<_> = model.links.iter().map(|link| of_link(link, shapes, &mut unread)).collect();
    let mut findings = check(model, &geometry);
    findings.append(&mut unread);
    findings.extend(model.notes.iter().map(of_note));
    findings.sort_by_key(|finding| finding.span.start);
    Inspection { geometry, findings }
}

/// What a link looks like; shapes that could not be measured are findings.
fn of_link(link: &Link, shapes: &mut Shapes, unread: &mut Vec<Finding>) -> LinkGeometry {
    let sets = [Role::Collision, Role::Visual].map(|role| shapes.link(link, role));
    for (span, why) in sets.iter().flat_map(|set| &set.left_out) {
        // A plane has no volume, and is none the worse for it.
        if !link.geometry.iter().any(|g| g.span == *span && matches!(g.shape, GeometryShape::Other(_))) {
            unread.push(unmeasured(link, span, why));
        }
    }
    let whole = |set: &&LinkVolume| set.left_out.is_empty();
    let volumes = || sets.iter().filter(whole).filter_map(|set| set.volume.as_ref());
    let bounds = volumes().map(|volume| volume.bounds).reduce(around);
    LinkGeometry {
        shapes: volumes().map(shape).collect(),
        bounds: bounds.filter(|_| sets.iter().all(|set| set.left_out.is_empty())),
    }
}

fn shape(volume: &Volume) -> Shape {
    let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = volume.tensor_per_density;
    let made_of = match volume.kind {
        VolumeKind::Closed => MadeOf::Meshes,
        // A hull is a body drawn with a coarse brush.
        VolumeKind::Primitives | VolumeKind::Hull => MadeOf::Primitives,
    };
    Shape { volume: volume.volume, centroid: volume.centroid, tensor: [xx, yy, zz, xy, xz, yz], made_of }
}

/// The box around two.
fn around([a, b]: [[f64; 3]; 2], [c, d]: [[f64; 3]; 2]) -> [[f64; 3]; 2] {
    let each = |p: [f64; 3], q: [f64; 3], of: fn(f64, f64) -> f64| {
        let ([px, py, pz], [qx, qy, qz]) = (p, q);
        [of(px, qx), of(py, qy), of(pz, qz)]
    };
    [each(a, c, f64::min), each(b, d, f64::max)]
}

fn unmeasured(link: &Link, span: &Span, why: &str) -> Finding {
    note(
        "geometry.unreadable",
        &link.name.text,
        span,
        why,
        "what cannot be measured is not compared with the inertia",
    )
}

fn of_note(note: &Note) -> Finding {
    self::note(note.code, &note.subject, &note.span, &note.message, "what is not read is not checked")
}

fn note(code: &'static str, subject: &str, span: &Span, message: &str, rule: &str) -> Finding {
    Finding {
        code,
        severity: Severity::Note,
        subject: subject.to_owned(),
        span: span.clone(),
        message: message.to_owned(),
        rule: rule.to_owned(),
        numbers: Vec::new(),
        repair: None,
    }
}
