//! Boundary of the region that a mesh encloses, for parts that intersect arbitrarily.

use super::super::component::Measured;
use super::super::inside::Windings;
use super::super::patches::{join, root};
use super::super::threads::Threads;
use super::super::tree::Tree;
use super::super::weld::{NONE, Welded};
use super::super::work::Work;
use super::contact::met;
use super::face::{Counts, Face, Line};
use super::region::{LEVELS, Piece, Region, rise_below, side_of};
use super::weighted::Weighted;

/// Triangles with outward normals, in the mesh's unit relative to a reference point.
#[derive(Debug, Default)]
pub(super) struct Boundary {
    pub(super) points: Vec<[f64; 3]>,
    pub(super) corners: Vec<[u32; 3]>,
}

impl Boundary {
    fn add(&mut self, polygon: &[[f64; 3]], is_turned: bool) {
        let first = self.points.len() as u32;
        self.points.extend_from_slice(polygon);
        for k in 2..polygon.len() as u32 {
            let [a, b, c] = [first, first + k - 1, first + k];
            self.corners.push(if is_turned { [a, c, b] } else { [a, b, c] });
        }
    }

    fn append(&mut self, other: &Self) {
        let first = self.points.len() as u32;
        self.points.extend_from_slice(&other.points);
        self.corners.extend(other.corners.iter().map(|corners| corners.map(|v| v + first)));
    }
}

/// Boundaries of the regions whose winding number is at least each of [`LEVELS`].
#[derive(Debug)]
pub(super) struct Boundaries {
    pub(super) levels: [Boundary; LEVELS.len()],
    /// Reference point of the coordinates, in the mesh's unit.
    pub(super) reference: [f64; 3],
}

impl Boundaries {
    /// Computes the boundaries; `None` if no work is left.
    pub(super) fn of(mesh: &Weighted, work: &Work<'_>, threads: Threads) -> Option<Self> {
        let Weighted { welded, patches, .. } = mesh;
        let collinear = Measured::of(welded, patches, threads).collinear;
        let has_area = |t: usize| collinear.binary_search(&(t as u32)).is_err();
        let tree = Tree::of(welded, has_area, threads);
        let met = met(mesh, &tree, &collinear, work, threads);
        // Triangles without area close the surface, so they are needed where triangles are cut.
        let with_all = if collinear.is_empty() { None } else { Some(Tree::of(welded, |_| true, threads)) };
        let tree = with_all.as_ref().unwrap_or(&tree);
        let (reference, size) = middle(welded);
        let arrangement =
            Arrangement { mesh, windings: Windings { welded, tree, patches, work }, reference, size };
        let mut levels = arrangement.whole(&met, has_area, threads)?;
        let cut: Vec<u32> =
            (0..).zip(&met).filter(|&(t, met)| *met && has_area(t as usize)).map(|(t, _)| t).collect();
        let parts = threads.map_pieces(cut.len(), FACES, |faces| {
            let mut levels = Levels::default();
            cut[faces].iter().try_for_each(|&t| arrangement.cut(t as usize, &mut levels)).map(|()| levels)
        });
        for part in parts {
            levels.iter_mut().zip(&part?).for_each(|(all, part)| all.append(part));
        }
        (!work.is_spent()).then_some(Self { levels, reference })
    }
}

type Levels = [Boundary; LEVELS.len()];

/// Number of faces in a piece of work.
const FACES: usize = 1 << 6;

/// Cost of a piece of a face, in visits of a ray; it limits the number of pieces.
const PIECE: u64 = 256;

/// Cost of intersecting one triangle with another, in visits of a ray.
const SECTION: u64 = 4;

struct Arrangement<'a> {
    mesh: &'a Weighted,
    windings: Windings<'a>,
    reference: [f64; 3],
    size: f64,
}

impl Arrangement<'_> {
    /// Adds the triangles that no other triangle intersects. Those connected through edges of two
    /// triangles have the same winding numbers on their sides.
    fn whole(&self, met: &[bool], has_area: impl Fn(usize) -> bool, threads: Threads) -> Option<Levels> {
        let Weighted { welded, times, edges, .. } = self.mesh;
        let is_whole = |t: usize| !met[t] && has_area(t);
        let mut parent: Vec<u32> = (0..welded.corners.len() as u32).collect();
        for half in 0..3 * welded.corners.len() as u32 {
            let twin = edges.twin(half);
            if twin != NONE && half < twin && is_whole(half as usize / 3) && is_whole(twin as usize / 3) {
                join(&mut parent, half / 3, twin / 3);
            }
        }
        let roots: Vec<u32> = (0..welded.corners.len() as u32)
            .filter(|&t| is_whole(t as usize) && parent[t as usize] == t)
            .collect();
        let beside = threads.map_pieces(roots.len(), FACES, |some| {
            roots[some].iter().map(|&t| self.windings.beside(t as usize, |u| times[u])).collect::<Vec<_>>()
        });
        let mut of_root = vec![[0; 2]; welded.corners.len()];
        for (&t, beside) in roots.iter().zip(beside.into_iter().flatten()) {
            of_root[t as usize] = beside?;
        }
        if self.windings.work.is_spent() {
            return None;
        }
        let points: Vec<_> = welded.points.iter().map(|p| from(*p, self.reference)).collect();
        let mut levels = LEVELS.map(|_| Boundary { points: points.clone(), corners: vec![] });
        for t in (0..welded.corners.len()).filter(|&t| is_whole(t)) {
            let [above, below] = of_root[root(&mut parent, t as u32) as usize];
            let [a, b, c] = welded.corners[t];
            for (boundary, &level) in levels.iter_mut().zip(&LEVELS) {
                match side_of(level, [above, below, 0]) {
                    0 => {}
                    1 => boundary.corners.push([a, b, c]),
                    _ => boundary.corners.push([a, c, b]),
                }
            }
        }
        Some(levels)
    }

    /// Adds the pieces of a triangle that others intersect.
    fn cut(&self, t: usize, levels: &mut Levels) -> Option<()> {
        let (Weighted { welded, times, .. }, Windings { tree, work, .. }) = (self.mesh, &self.windings);
        let corners = welded.triangle(t);
        let Some(face) = Face::of(corners) else { return Some(()) };
        let mut lines: Vec<Line> = Vec::new();
        let mut steps = 0;
        tree.near(welded, &corners, |u| {
            let u = u as usize;
            steps += SECTION;
            if u != t {
                face.cut(welded, u, times[u], u < t, &mut lines);
            }
        });
        if !work.take(steps) {
            return None;
        }
        let region = Region::of(&face, &lines, work)?;
        let at = region.middle();
        let counts = self.at_lower_edge(t, &face, at, &mut lines);
        region.pieces(at, counts, work, |piece| self.add(&face, &piece, levels))
    }

    /// Returns the counts just above a face's lower edge, summed from far below.
    fn at_lower_edge(&self, t: usize, face: &Face, x: f64, lines: &mut Vec<Line>) -> Counts {
        let (Weighted { welded, times, .. }, Windings { tree, work, .. }) = (self.mesh, &self.windings);
        let [at, outside] = face.below([x, face.end[1] * (x / face.end[0])], BEYOND * self.size);
        lines.clear();
        let mut visits = 0;
        tree.between(welded, at, outside, |u| {
            visits += 1;
            let u = u as usize;
            if u != t {
                face.cut(welded, u, times[u], u < t, lines);
            }
            true
        });
        work.take(visits);
        lines.iter().fold([0; 3], |sum, &line| {
            let rise = rise_below(face, line, x);
            [sum[0] + rise[0], sum[1] + rise[1], sum[2] + rise[2]]
        })
    }

    fn add(&self, face: &Face, piece: &Piece, levels: &mut Levels) {
        let [a, b, c, d] = piece.corners;
        if a == d && b == c || a[0] == b[0] || !self.windings.work.take(PIECE) {
            return;
        }
        let corners = [a, b, c, d].map(|p| face.point(p, self.reference));
        levels[piece.level].add(&corners, piece.side != face.turns);
    }
}

/// Distance beyond which a point is outside the mesh, in units of its size.
const BEYOND: f64 = 1.0625;

fn from(p: [f64; 3], reference: [f64; 3]) -> [f64; 3] {
    core::array::from_fn(|k| p[k] - reference[k])
}

/// Returns the centre of the bounding box of all points, with few digits so that little is rounded
/// relative to it, and its longest side.
fn middle(welded: &Welded) -> ([f64; 3], f64) {
    let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    for p in &welded.points {
        low = core::array::from_fn(|k| low[k].min(p[k]));
        high = core::array::from_fn(|k| high[k].max(p[k]));
    }
    let size = (0..3).map(|k| high[k] - low[k]).fold(0.0, f64::max);
    let grid = crate::math::symmetric3::power_of_two_near(size) / 1024.0;
    let reference = core::array::from_fn(|k| ((0.5 * (low[k] + high[k])) / grid).round_ties_even() * grid);
    (reference, size)
}
