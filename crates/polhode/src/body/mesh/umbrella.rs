//! Umbrellas: triangles side by side around one corner.
//!
//! A fan of n triangles around a corner has n² / 2 pairs whose boxes all intersect there. Seen
//! along a line through the corner, each triangle spans an angle about the line. If no two of these
//! angles overlap, and those that touch do so at a common corner of both triangles, then the
//! triangles have only corners and edges in common: each lies in its own wedge.

use super::fan::{Angle, Fan};
use super::predicate::side;
use super::weld::{NONE, Welded};
use crate::body::triangle_mesh::normal;

/// Minimum number of triangles at a corner for which the umbrella test is used.
const MANY: u32 = 64;

/// Returns for each triangle of the mesh the first triangle of its umbrella, or [`NONE`]. Triangles
/// of one umbrella have only corners and edges in common.
pub(crate) fn umbrellas(welded: &Welded, triangles: &[u32], component: &[u32]) -> Vec<u32> {
    let mut count = vec![0_u32; welded.points.len()];
    triangles.iter().flat_map(|&t| welded.corners[t as usize]).for_each(|v| count[v as usize] += 1);
    let about = |t: u32| welded.corners[t as usize].into_iter().max_by_key(|&v| count[v as usize]);
    let about =
        |&t: &u32| about(t).filter(|&v| count[v as usize] >= MANY).map(|v| (v, component[t as usize], t));
    let mut members: Vec<_> = triangles.iter().filter_map(about).collect();
    members.sort_unstable();
    let mut umbrella = vec![NONE; welded.corners.len()];
    let same = |a: &(u32, u32, u32), b: &(u32, u32, u32)| (a.0, a.1) == (b.0, b.1);
    for members in members.chunk_by(same).filter(|members| members.len() >= MANY as usize) {
        if are_side_by_side(welded, members[0].0, members.iter().map(|member| member.2 as usize)) {
            members.iter().for_each(|member| umbrella[member.2 as usize] = members[0].2);
        }
    }
    umbrella
}

/// Angle that a triangle spans about the line, from one of its corners to another.
struct Rib {
    from: u32,
    to: u32,
    angle: Angle,
}

/// Returns true if the triangles at a corner lie in separate wedges about a line through it along
/// their mean normal.
fn are_side_by_side(welded: &Welded, hub: u32, triangles: impl Iterator<Item = usize> + Clone) -> bool {
    let place = |v: u32| welded.points[v as usize];
    let mut mean = [0.0; 3];
    for t in triangles.clone() {
        let n = normal(welded.triangle(t));
        let length = n.iter().map(|c| c * c).sum::<f64>().sqrt();
        if length > 0.0 {
            mean = core::array::from_fn(|k| mean[k] + n[k] / length);
        }
    }
    let length = mean.iter().map(|c| c * c).sum::<f64>().sqrt();
    if !(length > 0.0) {
        return false;
    }
    let tip = place(hub);
    let line = [core::array::from_fn(|k| tip[k] - mean[k] / length), tip];
    let fan = Fan(line);
    let mut first = None;
    let ribs = triangles.map(|t| {
        let corners = welded.corners[t];
        let k = corners.iter().position(|&v| v == hub)?;
        let (a, b) = (corners[(k + 1) % 3], corners[(k + 2) % 3]);
        let turned = side([line[0], tip, place(a)], place(b));
        let (from, to) = if turned > 0.0 { (a, b) } else { (b, a) };
        let first = *first.get_or_insert(place(from));
        (turned != 0.0).then_some(())?;
        Some(Rib { from, to, angle: fan.angle(first, place(from))? })
    });
    let Some(mut ribs) = ribs.collect::<Option<Vec<_>>>() else { return false };
    ribs.sort_by(|a, b| fan.order(&a.angle, &b.angle));
    // The next angle starts where this one ends, or later: not inside it, and on a bounding
    // half-plane only at the common corner.
    let next = ribs.iter().cycle().skip(1);
    ribs.iter().zip(next).all(|(this, next)| {
        let from = |v: u32| side([line[0], tip, place(v)], place(next.from));
        this.to == next.from || from(this.from) < 0.0 || from(this.to) > 0.0
    })
}
