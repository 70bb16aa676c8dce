//! Winding numbers of a mesh about places next to a vertex, computed exactly.
//!
//! Straight lines connect all places infinitesimally near a vertex p to a point q outside the mesh.
//! The winding number at a place is the sum over the triangles that its line crosses: +1 where the
//! line crosses in the direction of the normal, −1 where it crosses against it. A triangle that
//! does not contain p is crossed by all these lines or by none, and is counted once. A triangle
//! that contains p is tested for each place. The point q must not be in the plane of any of the
//! latter, nor behind an edge or a corner of the others; otherwise another q is used.

use std::collections::HashMap;

use super::inside::{Germ, Windings, first_sign};
use super::predicate::{across, facing, side, turn};

/// Neighbourhood of a vertex.
struct Neighborhood {
    outside: [f64; 3],
    /// Contribution to the winding number from the triangles that do not contain the vertex.
    far: i32,
    near: Vec<Near>,
}

/// Triangle that contains the vertex.
struct Near {
    triangle: u32,
    /// Signs of the vertex as [`seen`] through the triangle.
    sees: [f64; 3],
    /// True if the triangle's normal, with the majority orientation of its component, points to the
    /// side of the outside point.
    along: bool,
}

/// Neighbourhoods of vertices, computed on demand and cached.
pub(crate) struct Neighborhoods<'a> {
    windings: &'a Windings<'a>,
    lowest: i32,
    known: HashMap<u32, Option<Neighborhood>>,
    sound: HashMap<[u32; 3], bool>,
}

impl<'a> Neighborhoods<'a> {
    /// Prepares the test for a mesh whose winding number should be `lowest` or `lowest` + 1
    /// everywhere.
    pub(crate) fn of(windings: &'a Windings<'a>, lowest: i32) -> Self {
        Self { windings, lowest, known: HashMap::new(), sound: HashMap::new() }
    }

    /// Returns true if the winding numbers on both sides of `triangle`, at `vertex`, are valid on
    /// both sides of the direction toward another vertex, as far as they lie in the triangle. Also
    /// true if no side lies in it, if the triangle has no area, or if no work is left.
    pub(crate) fn is_sound(&mut self, triangle: u32, vertex: u32, toward: u32) -> bool {
        let windings = self.windings;
        if windings.work.is_spent() {
            return true;
        }
        let key = [triangle, vertex, toward];
        if let Some(&is_sound) = self.sound.get(&key) {
            return is_sound;
        }
        let neighborhood = self.known.entry(vertex).or_insert_with(|| {
            let found =
                (0..OUTSIDE).find_map(|k| Neighborhood::of(windings, vertex, windings.tree.outside(k)));
            if found.is_none() {
                windings.work.take_all();
            }
            found
        });
        let Some(neighborhood) = neighborhood else { return true };
        let [at, toward] = [vertex, toward].map(|v| windings.welded.points[v as usize]);
        let is_sound = windings.welded.triangle(triangle as usize).into_iter().all(|beside| {
            let sides = neighborhood.beside(windings, triangle, &[at, toward, beside]);
            sides.is_none_or(|sides| sides.iter().all(|&w| w == self.lowest || w == self.lowest + 1))
        });
        self.sound.insert(key, is_sound);
        is_sound
    }
}

/// Number of outside points that are tried.
const OUTSIDE: u32 = 64;

impl Neighborhood {
    /// Returns `None` if it is not certain whether the line from the vertex to the outside point
    /// crosses a triangle.
    fn of(windings: &Windings<'_>, vertex: u32, outside: [f64; 3]) -> Option<Self> {
        let (welded, point) = (windings.welded, windings.welded.points[vertex as usize]);
        let (mut far, mut near, mut visits) = (0, Vec::new(), 0);
        let is_clear = windings.tree.between(welded, point, outside, |t| {
            visits += 1;
            let triangle = welded.triangle(t as usize);
            let [of_point, of_outside] = [point, outside].map(|p| side(triangle, p));
            if welded.corners[t as usize].contains(&vertex) || of_point == 0.0 && is_on(triangle, point) {
                let along = (of_outside > 0.0) != windings.patches.against[t as usize];
                near.push(Near { triangle: t, sees: seen(triangle, outside, point), along });
                return of_outside != 0.0;
            }
            if of_point == 0.0 || of_outside == 0.0 || (of_point > 0.0) == (of_outside > 0.0) {
                return of_point != 0.0 || of_outside != 0.0;
            }
            let sees = seen(triangle, outside, point);
            let (left, right) = (sees.iter().any(|&s| s > 0.0), sees.iter().any(|&s| s < 0.0));
            if left && right {
                return true;
            }
            let leaves = (of_outside > 0.0) != windings.patches.against[t as usize];
            far += if leaves { 1 } else { -1 };
            sees.iter().all(|&s| s != 0.0)
        });
        windings.work.take(visits);
        is_clear.then_some(Self { outside, far, near })
    }

    /// Returns the winding numbers just behind and just in front of a triangle, with each component
    /// in its majority orientation.
    fn beside(&self, windings: &Windings<'_>, triangle: u32, germ: &Germ) -> Option<[i32; 2]> {
        let welded = windings.welded;
        facing(*germ)?;
        windings.work.take(self.near.len() as u64);
        let [_, places @ ..] = germ;
        let (mut ahead, mut coplanar, mut own) = (self.far, 0, None);
        for near in &self.near {
            let corners = welded.triangle(near.triangle as usize);
            let sees = core::array::from_fn(|k| match near.sees[k] {
                0.0 => first_side([corners[k], corners[(k + 1) % 3], self.outside], places),
                sees => sees,
            });
            if !is_through(sees) {
                continue;
            }
            // The vertex itself is in the triangle's plane.
            let height = first_side(corners, places);
            let normal_is_along = near.along != windings.patches.against[near.triangle as usize];
            if height == 0.0 || (height < 0.0) == normal_is_along {
                let count = if height == 0.0 { &mut coplanar } else { &mut ahead };
                *count += if near.along { 1 } else { -1 };
            }
            if near.triangle == triangle {
                own = Some(near.along);
            }
        }
        Some(if own? { [ahead + coplanar, ahead] } else { [ahead, ahead + coplanar] })
    }
}

/// Returns the side of a plane through three points on which the first of the places lies that is
/// not in the plane.
fn first_side(plane: [[f64; 3]; 3], places: &[[f64; 3]]) -> f64 {
    first_sign(places.iter().map(|p| if plane.contains(p) { 0.0 } else { side(plane, *p) }))
}

/// Returns true if all three values are positive or all are negative.
fn is_through(sides: [f64; 3]) -> bool {
    sides.iter().all(|&s| s > 0.0) || sides.iter().all(|&s| s < 0.0)
}

/// Returns the sides of a point relative to the planes through each edge and the eye. All have the
/// same sign if the line from the point to the eye, or its extension, passes through the triangle.
fn seen([a, b, c]: [[f64; 3]; 3], eye: [f64; 3], point: [f64; 3]) -> [f64; 3] {
    [[a, b], [b, c], [c, a]].map(|[a, b]| first_side([a, b, eye], &[point]))
}

/// Returns true if a point of a triangle's plane is in the triangle or on its edge.
fn is_on(triangle: [[f64; 3]; 3], point: [f64; 3]) -> bool {
    let Some((axis, _)) = facing(triangle) else { return false };
    let ([a, b, c], p) = (triangle.map(|q| across(axis, q)), across(axis, point));
    let turns = [turn(a, b, p), turn(b, c, p), turn(c, a, p)];
    !(turns.iter().any(|&s| s > 0.0) && turns.iter().any(|&s| s < 0.0))
}
