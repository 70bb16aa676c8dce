//! Which triangles hang together by their edges, and which of them are the wrong way round.

use super::edges::{Edges, start_of};
use super::weld::{NONE, is_proper};

/// Components of a mesh, numbered by their first triangles.
#[derive(Debug)]
pub(crate) struct Patches {
    /// The component of each triangle; [`NONE`] for one with two equal corners.
    pub(crate) component: Vec<u32>,
    /// True if the triangle is wound against most of its component.
    pub(crate) against: Vec<bool>,
    pub(crate) components: Vec<Patch>,
}

/// What is known of a component from its edges alone.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Patch {
    pub(crate) triangles: usize,
    /// Edges with one triangle, or with an odd number of them.
    pub(crate) open: usize,
    /// Edges that are run along more often one way than the other.
    pub(crate) unbalanced: usize,
    /// Edges with more than two triangles.
    pub(crate) crowded: usize,
    /// It can be wound consistently, which it may not be.
    pub(crate) orientable: bool,
    /// Triangles against most of the others; 0 if it is not clear which these are.
    pub(crate) against: usize,
}

impl Patches {
    pub(crate) fn of(corners: &[[u32; 3]], edges: &Edges) -> Self {
        let mut sheets = Sheets::of(corners, edges);
        let mut joined: Vec<u32> = (0..sheets.sheets.len() as u32).collect();
        for edge in &edges.crowded {
            for &half in &edge[1..] {
                join(&mut joined, sheets.label[edge[0] as usize / 3], sheets.label[half as usize / 3]);
            }
        }
        // Roots come before those that they are the root of.
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
        for (label, against) in sheets.label.iter_mut().zip(&mut sheets.against) {
            if *label != NONE {
                let sheet = &sheets.sheets[*label as usize];
                *against ^= 2 * sheet.against > sheet.triangles;
                *label = number[*label as usize];
            }
        }
        let mut all = Self { component: sheets.label, against: sheets.against, components };
        all.judge(corners, edges);
        all
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

/// Is the edge run along as often one way as the other?
pub(crate) fn is_balanced(corners: &[[u32; 3]], edge: &[u32]) -> bool {
    let start = start_of(corners, edge[0]);
    2 * edge.iter().filter(|&&half| start_of(corners, half) == start).count() == edge.len()
}

/// Triangles that hang together by edges with two triangles: if it can be wound consistently at all, then in two ways only.
struct Sheets {
    /// The sheet of each triangle.
    label: Vec<u32>,
    /// True if a triangle is wound against the first of its sheet.
    against: Vec<bool>,
    sheets: Vec<Sheet>,
}

struct Sheet {
    triangles: usize,
    against: usize,
    orientable: bool,
}

impl Sheets {
    fn of(corners: &[[u32; 3]], edges: &Edges) -> Self {
        let mut all =
            Self { label: vec![NONE; corners.len()], against: vec![false; corners.len()], sheets: vec![] };
        let mut waiting = Vec::new();
        for first in 0..corners.len() {
            if all.label[first] != NONE || !is_proper(&corners[first]) {
                continue;
            }
            let number = all.sheets.len() as u32;
            let mut sheet = Sheet { triangles: 0, against: 0, orientable: true };
            all.label[first] = number;
            waiting.push(first);
            while let Some(t) = waiting.pop() {
                sheet.triangles += 1;
                sheet.against += usize::from(all.against[t]);
                for half in 3 * t as u32..3 * t as u32 + 3 {
                    let twin = edges.twin(half);
                    if twin == NONE {
                        continue;
                    }
                    let other = twin as usize / 3;
                    let against = all.against[t] ^ (start_of(corners, half) == start_of(corners, twin));
                    if all.label[other] == NONE {
                        all.label[other] = number;
                        all.against[other] = against;
                        waiting.push(other);
                    } else if all.against[other] != against {
                        sheet.orientable = false;
                    }
                }
            }
            all.sheets.push(sheet);
        }
        all
    }
}

/// Of the tree that a number is in; numbers point down to their root, which is the least.
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
