//! Triangles about one corner, side by side.
//!
//! A cap of n triangles about its middle has n² / 2 pairs of them, whose boxes all meet there. Seen along a line through the corner, each
//! triangle spans an angle about the line. Where no two of these angles overlap, and those that touch do so at a corner that both
//! triangles have, the triangles have nothing but corners and edges in common: each lies in a wedge of its own.

use super::fan::{Angle, Fan};
use super::predicate::side;
use super::weld::{NONE, Welded};
use crate::body::triangle_mesh::normal;

/// Triangles of a corner from which on they are looked at together.
const MANY: u32 = 64;

/// For each triangle of the mesh, the first of those beside which it lies about a corner, or [`NONE`]. Those with the same first one have
/// nothing in common but corners and edges.
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

/// A triangle's angle about the line, from one of its corners to the other.
struct Rib {
    from: u32,
    to: u32,
    angle: Angle,
}

/// Do the triangles about a corner have wedges of their own, about a line through it along their mean normal?
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
    // The next one begins where this one ends, or behind: not between its corners, and on the half-plane of one only at that corner.
    let next = ribs.iter().cycle().skip(1);
    ribs.iter().zip(next).all(|(this, next)| {
        let from = |v: u32| side([line[0], tip, place(v)], place(next.from));
        this.to == next.from || from(this.from) < 0.0 || from(this.to) > 0.0
    })
}
