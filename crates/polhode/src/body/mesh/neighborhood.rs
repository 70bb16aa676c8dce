//! How often a mesh winds about what is next to a vertex, exactly.
//!
//! Whatever is infinitely near to a vertex p is joined by straight lines to a point q outside. The winding number there is what they meet:
//! +1 for each triangle that the line leaves, as its normal points along it, −1 for each that it enters. Triangles that p is not on are
//! met by all these lines or by none, and are counted once; those that it is on, for each place anew. The point q is in the plane of none
//! of these, and behind no edge or corner of the others; or another one is taken.

use std::collections::HashMap;

use super::inside::{Germ, Windings, first_sign};
use super::predicate::{across, facing, side, turn};

/// Of a vertex.
struct Neighborhood {
    outside: [f64; 3],
    /// The winding number from the triangles that the vertex is not on.
    far: i32,
    near: Vec<Near>,
}

/// A triangle that the vertex is on.
struct Near {
    triangle: u32,
    /// How the vertex is [`seen`] through it.
    sees: [f64; 3],
    /// Its normal, wound as most of its component is, points to the side where the point outside is.
    along: bool,
}

/// What is next to vertices, as far as it was asked.
pub(crate) struct Neighborhoods<'a> {
    windings: &'a Windings<'a>,
    lowest: i32,
    known: HashMap<u32, Option<Neighborhood>>,
    sound: HashMap<[u32; 3], bool>,
}

impl<'a> Neighborhoods<'a> {
    /// Of a mesh that is to wind about everything `lowest` times or once more.
    pub(crate) fn of(windings: &'a Windings<'a>, lowest: i32) -> Self {
        Self { windings, lowest, known: HashMap::new(), sound: HashMap::new() }
    }

    /// Does it do so on both sides of a triangle, next to a vertex on it, on the sides of the way toward another vertex that lie in it? Also
    /// if none does, or the triangle has no area; and if there is no work left.
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

/// Points outside that are tried.
const OUTSIDE: u32 = 64;

impl Neighborhood {
    /// `None` if a triangle is not clearly met or missed on the way from the vertex to the point outside.
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

    /// How often the mesh winds about what is just behind and just before a triangle, each component wound as most of it is.
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
            // The vertex itself is in its plane.
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

/// The side of the plane of three points on which the first of some places is that is not in it.
fn first_side(plane: [[f64; 3]; 3], places: &[[f64; 3]]) -> f64 {
    first_sign(places.iter().map(|p| if plane.contains(p) { 0.0 } else { side(plane, *p) }))
}

/// Are all three positive, or all negative?
fn is_through(sides: [f64; 3]) -> bool {
    sides.iter().all(|&s| s > 0.0) || sides.iter().all(|&s| s < 0.0)
}

/// On which sides of the planes through its edges and the eye a point is: on the same ones of all if the line from it to the eye goes
/// through the triangle, or would if it were longer.
fn seen([a, b, c]: [[f64; 3]; 3], eye: [f64; 3], point: [f64; 3]) -> [f64; 3] {
    [[a, b], [b, c], [c, a]].map(|[a, b]| first_side([a, b, eye], &[point]))
}

/// Is a point of a triangle's plane in the triangle or on its edge?
fn is_on(triangle: [[f64; 3]; 3], point: [f64; 3]) -> bool {
    let Some((axis, _)) = facing(triangle) else { return false };
    let ([a, b, c], p) = (triangle.map(|q| across(axis, q)), across(axis, point));
    let turns = [turn(a, b, p), turn(b, c, p), turn(c, a, p)];
    !(turns.iter().any(|&s| s > 0.0) && turns.iter().any(|&s| s < 0.0))
}
