//! Choice between the visual and the collision geometry of a link, with its reason.

use polhode_document::layout::printable;
use polhode_document::number::number;
use polhode_source::text::counted;

use super::request::Origin;
use crate::geometry::{LinkSolid, Shapes};
use crate::model::{Link, Role, Span};

/// Relative difference below which two solids are the same.
const SAME: f64 = 1e-9;

/// Solid of a link, and the reason for its choice.
pub(super) struct Chosen {
    pub(super) solid: LinkSolid,
    pub(super) role: Role,
    /// Reason, to follow the name of the role: `1 shape (320 triangles, closed); no collision`.
    pub(super) reason: String,
}

/// Reason why a link has no usable solid.
pub(super) enum Unusable {
    /// The link has no shapes, or none with the requested role.
    NoGeometry,
    /// No role bounds a solid.
    NoSolid(String),
}

/// Result of measuring one role.
enum Measured {
    None,
    Solid(LinkSolid),
    Faulty(Vec<(Span, String)>),
}

/// Chooses the solid of a link: the requested role, or the more detailed of those that bound a
/// solid. The visual geometry is preferred if both are equally detailed.
pub(super) fn choose(link: &Link, shapes: &Shapes<'_>, request: Option<Origin>) -> Result<Chosen, Unusable> {
    let measure = |role: Role| {
        if !link.geometry.iter().any(|geometry| geometry.role == role) {
            return Measured::None;
        }
        match shapes.solid(link, role) {
            Ok(solid) => Measured::Solid(solid),
            Err(faults) => Measured::Faulty(faults),
        }
    };
    let chosen = |solid, role, reason| Ok(Chosen { solid, role, reason });
    if let Some(origin) = request {
        let role = role_of(origin);
        return match measure(role) {
            Measured::None => Err(Unusable::NoGeometry),
            Measured::Faulty(faults) => Err(Unusable::NoSolid(in_words(role, &faults))),
            Measured::Solid(solid) => {
                let reason = format!("{}; as requested", described(&solid));
                chosen(solid, role, reason)
            }
        };
    }
    match (measure(Role::Visual), measure(Role::Collision)) {
        (Measured::None, Measured::None) => Err(Unusable::NoGeometry),
        (Measured::Solid(visual), Measured::Solid(collision)) => {
            let [detail, other] = [&visual, &collision].map(detail);
            let (solid, rest, role) = if other > detail {
                (collision, visual, Role::Collision)
            } else {
                (visual, collision, Role::Visual)
            };
            let reason = format!("{}; {}", described(&solid), compared(&rest, &solid, other_of(role)));
            chosen(solid, role, reason)
        }
        (Measured::Solid(solid), rest) => {
            let reason = format!("{}; {}", described(&solid), unused(Role::Collision, &rest));
            chosen(solid, Role::Visual, reason)
        }
        (rest, Measured::Solid(solid)) => {
            let reason = format!("{}; {}", described(&solid), unused(Role::Visual, &rest));
            chosen(solid, Role::Collision, reason)
        }
        (visual, collision) => {
            let faults = [(Role::Visual, visual), (Role::Collision, collision)];
            let faults = faults.into_iter().filter_map(|(role, measured)| match measured {
                Measured::Faulty(faults) => Some(in_words(role, &faults)),
                _ => None,
            });
            Err(Unusable::NoSolid(faults.collect::<Vec<_>>().join("; ")))
        }
    }
}

const fn role_of(origin: Origin) -> Role {
    match origin {
        Origin::Visual => Role::Visual,
        Origin::Collision => Role::Collision,
    }
}

const fn other_of(role: Role) -> Role {
    match role {
        Role::Visual => Role::Collision,
        Role::Collision => Role::Visual,
    }
}

/// Returns the name of a role.
pub(super) const fn name(role: Role) -> &'static str {
    match role {
        Role::Visual => "visual",
        Role::Collision => "collision",
    }
}

/// Returns the detail of a solid: triangles of meshes first, then the number of shapes.
fn detail(solid: &LinkSolid) -> (usize, usize) {
    (solid.triangles, shapes(solid))
}

fn shapes(solid: &LinkSolid) -> usize {
    let mut all: Vec<usize> = solid.pieces.iter().flat_map(|piece| piece.shapes.iter().copied()).collect();
    all.sort_unstable();
    all.dedup();
    all.len()
}

/// Returns a solid in words: `2 shapes (1280 triangles, closed), overlaps of 3.2 % counted once`.
fn described(solid: &LinkSolid) -> String {
    let mut words = counted(shapes(solid), "shape");
    if solid.triangles > 0 {
        words += &format!(" ({}, closed)", counted(solid.triangles, "triangle"));
    }
    if solid.shared > 0.0 {
        let percent = number(100.0 * solid.shared / solid.volume(), 2);
        words += &format!(", overlaps of {percent}\u{a0}% counted once");
    }
    words
}

/// Compares the unused solid with the used one.
fn compared(rest: &LinkSolid, solid: &LinkSolid, role: Role) -> String {
    let (Some(a), Some(b)) = (rest.whole(), solid.whole()) else { return String::new() };
    let ratio = a.volume / b.volume;
    let size = b.extent.max(f64::MIN_POSITIVE);
    let is_same =
        (ratio - 1.0).abs() < SAME && (0..3).all(|k| (a.centroid[k] - b.centroid[k]).abs() < SAME * size);
    if is_same {
        return format!("{} is the same solid", name(role));
    }
    let detail = match detail(rest).cmp(&detail(solid)) {
        std::cmp::Ordering::Equal => "as detailed",
        _ => "coarser",
    };
    format!("{} is {detail}, with {} times its volume", name(role), number(ratio, 3))
}

fn unused(role: Role, rest: &Measured) -> String {
    match rest {
        Measured::Faulty(faults) => in_words(role, faults),
        _ => format!("no {}", name(role)),
    }
}

/// Returns the first fault of a role, and the number of others.
fn in_words(role: Role, faults: &[(Span, String)]) -> String {
    let first = faults.first().map_or("no solid", |(_, why)| why.as_str());
    let more = match faults.len() {
        0 | 1 => String::new(),
        count => format!(" (and {} more)", count - 1),
    };
    format!("{}: {}{more}", name(role), printable(first))
}
