//! Components connected through edges, and the triangles with the wrong orientation.

use core::ops::Range;

use super::edges::{Edges, start_of};
use super::threads::Threads;
use super::weld::{NONE, is_proper};

/// Components of a mesh, numbered by their first triangles.
#[derive(Debug, Default)]
pub(crate) struct Patches {
    /// Component of each triangle; [`NONE`] for one with two equal corners.
    pub(crate) component: Vec<u32>,
    /// True if the triangle is oriented against the majority of its component.
    pub(crate) against: Vec<bool>,
    pub(crate) components: Vec<Patch>,
    /// Surface of each triangle, connected through edges of two triangles; empty if each surface is
    /// a whole component.
    sheet: Vec<u32>,
}

/// Properties of a component that follow from its edges alone.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Patch {
    pub(crate) triangles: usize,
    /// Number of edges with one triangle, or with an odd number of them.
    pub(crate) open: usize,
    /// Number of edges that are not traversed equally often in both directions.
    pub(crate) unbalanced: usize,
    /// Number of edges with more than two triangles.
    pub(crate) crowded: usize,
    /// True if a consistent orientation exists; the component need not have it.
    pub(crate) orientable: bool,
    /// Number of triangles against the majority; 0 without a clear majority.
    pub(crate) against: usize,
}

impl Patches {
    pub(crate) fn of(corners: &[[u32; 3]], edges: &Edges, threads: Threads) -> Self {
        let mut sheets = Sheets::of(corners, edges, threads);
        let mut joined: Vec<u32> = (0..sheets.sheets.len() as u32).collect();
        for edge in &edges.crowded {
            for &half in &edge[1..] {
                join(&mut joined, sheets.label[edge[0] as usize / 3], sheets.label[half as usize / 3]);
            }
        }
        // Roots precede the nodes of their trees.
        let mut number = vec![NONE; joined.len()];
        let mut components: Vec<Patch> = Vec::new();
        for sheet in 0..joined.len() as u32 {
            let root = root(&mut joined, sheet) as usize;
            if number[root] == NONE {
                number[root] = components.len() as u32;
                components.push(Patch { orientable: true, ..Patch::default() });
            }
            number[sheet as usize] = number[root];
            let (patch, sheet) = (&mut components[number[root] as usize], &sheets.sheets[sheet as usize]);
            patch.triangles += sheet.triangles;
            patch.orientable &= sheet.orientable;
            patch.against = patch.against.max(sheet.against.min(sheet.triangles - sheet.against));
        }
        let sheet = if edges.crowded.is_empty() { vec![] } else { sheets.label.clone() };
        for (label, against) in sheets.label.iter_mut().zip(&mut sheets.against) {
            if *label != NONE {
                let sheet = &sheets.sheets[*label as usize];
                *against ^= 2 * sheet.against > sheet.triangles;
                *label = number[*label as usize];
            }
        }
        let mut all = Self { component: sheets.label, against: sheets.against, components, sheet };
        all.judge(corners, edges);
        all
    }

    /// Returns the index of the surface of a triangle, connected through edges of two triangles.
    pub(crate) fn surface(&self, t: usize) -> u32 {
        *self.sheet.get(t).unwrap_or(&self.component[t])
    }

    /// Returns true if the whole mesh is connected through edges of two triangles.
    pub(crate) fn is_one_surface(&self) -> bool {
        self.components.len() == 1 && self.sheet.is_empty()
    }

    fn judge(&mut self, corners: &[[u32; 3]], edges: &Edges) {
        let of = |half: u32| self.component[half as usize / 3] as usize;
        let components = &mut self.components;
        for &half in &edges.boundary {
            components[of(half)].open += 1;
        }
        for &half in &edges.inconsistent {
            components[of(half)].unbalanced += 1;
        }
        for edge in &edges.crowded {
            let patch = &mut components[of(edge[0])];
            patch.crowded += 1;
            patch.open += edge.len() % 2;
            patch.unbalanced += usize::from(edge.len() % 2 == 0 && !is_balanced(corners, edge));
        }
        for patch in components {
            let clear = patch.unbalanced > 0
                && patch.open == 0
                && patch.crowded == 0
                && patch.orientable
                && 2 * patch.against < patch.triangles;
            if !clear {
                patch.against = 0;
            }
        }
        for (t, &component) in self.component.iter().enumerate() {
            if component == NONE || self.components[component as usize].against == 0 {
                self.against[t] = false;
            }
        }
    }
}

/// Returns true if an edge is traversed equally often in both directions.
pub(crate) fn is_balanced(corners: &[[u32; 3]], edge: &[u32]) -> bool {
    let start = start_of(corners, edge[0]);
    2 * edge.iter().filter(|&&half| start_of(corners, half) == start).count() == edge.len()
}

/// Surfaces of triangles connected through edges of two triangles. A surface has at most two
/// consistent orientations.
struct Sheets {
    /// Sheet of each triangle.
    label: Vec<u32>,
    /// True if a triangle is oriented against the first triangle of its sheet.
    against: Vec<bool>,
    sheets: Vec<Sheet>,
}

struct Sheet {
    triangles: usize,
    against: usize,
    orientable: bool,
}

impl Sheets {
    fn of(corners: &[[u32; 3]], edges: &Edges, threads: Threads) -> Self {
        // Each piece of the mesh is processed alone, then the edges between pieces.
        let pieces = threads.map_pieces(corners.len(), PIECE, |piece| Winds::of(piece, corners, edges));
        let mut all = Winds { first: 0, up: Vec::with_capacity(corners.len()), torn: vec![], left: vec![] };
        for mut piece in pieces {
            all.up.append(&mut piece.up);
            all.torn.append(&mut piece.torn);
            all.left.append(&mut piece.left);
        }
        for half in core::mem::take(&mut all.left) {
            all.join(half, corners, edges);
        }
        let mut sheets =
            Self { label: vec![NONE; corners.len()], against: vec![false; corners.len()], sheets: vec![] };
        // Roots precede the nodes of their trees.
        for t in (0..corners.len()).filter(|&t| is_proper(&corners[t])) {
            let (root, against) = all.root(t as u32);
            if root as usize == t {
                sheets.label[t] = sheets.sheets.len() as u32;
                sheets.sheets.push(Sheet { triangles: 0, against: 0, orientable: true });
            }
            let label = sheets.label[root as usize];
            let sheet = &mut sheets.sheets[label as usize];
            sheet.triangles += 1;
            sheet.against += usize::from(against);
            (sheets.label[t], sheets.against[t]) = (label, against);
        }
        for t in all.torn {
            sheets.sheets[sheets.label[t as usize] as usize].orientable = false;
        }
        sheets
    }
}

/// Number of triangles in a piece of work.
const PIECE: usize = 1 << 16;

/// Union-find trees of connected triangles with their relative orientation; the root is the lowest
/// index.
struct Winds {
    /// Triangle with the local index 0.
    first: u32,
    /// Twice the next triangle on the path to the root, plus one if oriented against it.
    up: Vec<u64>,
    /// Triangles that would need both orientations.
    torn: Vec<u32>,
    /// Half-edges whose twins belong to later pieces.
    left: Vec<u32>,
}

impl Winds {
    fn of(piece: Range<usize>, corners: &[[u32; 3]], edges: &Edges) -> Self {
        let up = (0..piece.len() as u64).map(|t| 2 * t).collect();
        let mut winds = Self { first: piece.start as u32, up, torn: vec![], left: vec![] };
        for half in 3 * piece.start..3 * piece.end {
            let twin = edges.twin(half as u32);
            if twin == NONE || (twin as usize) < half {
            } else if twin as usize >= 3 * piece.end {
                winds.left.push(half as u32);
            } else {
                winds.join(half as u32, corners, edges);
            }
        }
        for up in &mut winds.up {
            *up += 2 * piece.start as u64;
        }
        winds
    }

    /// Returns the root of a triangle, and true if the triangle is oriented against it.
    fn root(&mut self, mut t: u32) -> (u32, bool) {
        let mut against = 0;
        loop {
            let up = self.up[t as usize];
            let next = (up / 2) as u32;
            if next == t {
                return (t, against == 1);
            }
            // Path halving.
            let after = self.up[next as usize] ^ up & 1;
            self.up[t as usize] = after;
            against ^= after & 1;
            t = (after / 2) as u32;
        }
    }

    fn join(&mut self, half: u32, corners: &[[u32; 3]], edges: &Edges) {
        let twin = edges.twin(half);
        let against = start_of(corners, half) == start_of(corners, twin);
        let (t, t_against) = self.root(half / 3 - self.first);
        let (u, u_against) = self.root(twin / 3 - self.first);
        let against = against ^ t_against ^ u_against;
        if t != u {
            self.up[t.max(u) as usize] = 2 * u64::from(t.min(u)) + u64::from(against);
        } else if against {
            self.torn.push(half / 3);
        }
    }
}

/// Returns the root of the tree that contains a number; each number points to a lower one, and the
/// root is the lowest.
pub(crate) fn root(parent: &mut [u32], mut number: u32) -> u32 {
    while parent[number as usize] != number {
        parent[number as usize] = parent[parent[number as usize] as usize];
        number = parent[number as usize];
    }
    number
}

pub(crate) fn join(parent: &mut [u32], a: u32, b: u32) {
    let (a, b) = (root(parent, a), root(parent, b));
    parent[a.max(b) as usize] = a.min(b);
}
