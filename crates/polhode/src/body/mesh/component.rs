//! The parts of a mesh that hang together, and what each is.

use core::ops::Range;

use super::inside::{Nesting, Windings};
use super::patches::{Patch, Patches};
use super::threads::Threads;
use super::weld::Welded;
use super::work::Work;
use crate::math::sum::Sum;
use crate::math::symmetric3::power_of_two_near;

/// Triangles of a mesh that hang together by their edges.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct MeshComponent {
    /// Its first triangle, from 1.
    pub first_triangle: usize,
    /// Its triangles, without those that have two equal corners.
    pub triangles: usize,
    /// Enclosed volume, m³, negative if most of it is wound inward; of one that is not closed, a number without a meaning.
    pub volume: f64,
    /// Area, m².
    pub area: f64,
    /// The lowest and the highest coordinates, m.
    pub bounds: [[f64; 3]; 2],
    /// How it lies among the others, and so what it is.
    pub role: ComponentRole,
    /// How many other closed components it lies in.
    pub depth: usize,
    /// The smallest of these, by its place in [`MeshDiagnosis::components`](crate::body::mesh::MeshDiagnosis::components).
    pub inside: Option<usize>,
    /// Triangles that are wound against most of the others, if that is clear.
    pub flipped: usize,
    /// The first of these, from 1.
    pub first_flipped: Option<usize>,
}

/// What a part of a mesh is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ComponentRole {
    /// It has a boundary.
    Open,
    /// It can not be wound consistently: one-sided, as Klein's bottle.
    Unorientable,
    /// It is closed, but not wound consistently, and not clearly so that a few triangles are the wrong way round.
    Inconsistent,
    /// It is closed, but encloses nothing.
    Flat,
    /// A solid: wound outward, and within no other or in a cavity.
    Solid,
    /// A cavity: wound inward, within a solid.
    Cavity,
    /// Wound outward within a solid: what it encloses counts twice.
    InnerSolid,
    /// Wound inward, and within no solid: it counts negative.
    Inverted,
}

impl ComponentRole {
    /// Has it an inside and an outside?
    pub const fn is_closed(self) -> bool {
        !matches!(self, Self::Open | Self::Unorientable | Self::Inconsistent)
    }

    /// `open`, `solid`, `cavity`, …
    pub const fn name(self) -> &'static str {
        match self {
            Self::Open => "open",
            Self::Unorientable => "unorientable",
            Self::Inconsistent => "inconsistently wound",
            Self::Flat => "flat",
            Self::Solid => "solid",
            Self::Cavity => "cavity",
            Self::InnerSolid => "solid in a solid",
            Self::Inverted => "inverted",
        }
    }
}

/// What can be said of components one by one; their roles as if none lay in another.
#[derive(Default)]
pub(crate) struct Measured {
    pub(crate) components: Vec<MeshComponent>,
    /// The largest triangle of each.
    largest: Vec<usize>,
    pub(crate) collinear: Vec<u32>,
}

impl Measured {
    pub(crate) fn of(welded: &Welded, patches: &Patches, threads: Threads) -> Self {
        let count = patches.components.len();
        // Each thread has the triangles of its components.
        let parts = threads.map_pieces(count, count.div_ceil(threads.count()).max(1), |components| {
            Self::some(welded, patches, components)
        });
        let mut parts = parts.into_iter();
        let mut all = parts.next().unwrap_or_default();
        for part in parts {
            all.components.extend(part.components);
            all.largest.extend(part.largest);
            all.collinear.extend(part.collinear);
        }
        all.collinear.sort_unstable();
        all
    }

    fn some(welded: &Welded, patches: &Patches, components: Range<usize>) -> Self {
        let mut sums: Vec<VolumeSums> = components.clone().map(|_| VolumeSums::default()).collect();
        let mut collinear = Vec::new();
        for (t, &component) in patches.component.iter().enumerate() {
            // Also of `NONE`, which is beyond all.
            let Some(sums) = sums.get_mut((component as usize).wrapping_sub(components.start)) else {
                continue;
            };
            let flat = sums.add(t, welded.triangle(t), patches.against[t]);
            if flat && super::predicate::facing(welded.triangle(t)).is_none() {
                collinear.push(t as u32);
            }
        }
        let of_each = sums.iter().zip(&patches.components[components]);
        Self {
            components: of_each.map(|(sums, patch)| sums.component(patch, welded.unit)).collect(),
            largest: sums.iter().map(|sums| sums.largest).collect(),
            collinear,
        }
    }

    /// Gives the components their places among each other.
    pub(crate) fn nest(&mut self, windings: &Windings<'_>, threads: Threads) {
        let solid = |role| matches!(role, ComponentRole::Solid | ComponentRole::Inverted);
        let components = &self.components;
        let volume = |k: usize| solid(components[k].role).then_some(components[k].volume);
        let solids: Vec<usize> = (0..components.len()).filter(|&k| solid(components[k].role)).collect();
        if solids.len() < 2 {
            return;
        }
        let within = BoxesWithin::of(components, &solids);
        let nestings = threads.map_pieces(solids.len(), COMPONENTS, |piece| {
            let nesting = |&k: &usize| {
                let may_be = within.is_in_another(k, windings.work);
                if may_be { windings.nesting(self.largest[k], volume) } else { Nesting::default() }
            };
            solids[piece].iter().map(nesting).collect::<Vec<_>>()
        });
        for (k, nesting) in solids.into_iter().zip(nestings.into_iter().flatten()) {
            let component = &mut self.components[k];
            (component.depth, component.inside) = (nesting.depth, nesting.inside);
            component.role = match (component.role, nesting.depth % 2 == 1) {
                (ComponentRole::Solid, true) => ComponentRole::InnerSolid,
                (ComponentRole::Inverted, true) => ComponentRole::Cavity,
                (role, _) => role,
            };
        }
    }
}

/// Which boxes of some components lie in others of them: what lies in another has its box in that one's.
struct BoxesWithin<'a> {
    components: &'a [MeshComponent],
    /// The axis along which they overlap least.
    axis: usize,
    /// By where they begin along it.
    order: Vec<usize>,
    /// A complete binary tree over the order: the farthest that a box of a node reaches.
    farthest: Vec<f64>,
}

impl<'a> BoxesWithin<'a> {
    fn of(components: &'a [MeshComponent], some: &[usize]) -> Self {
        let spread = |axis: usize| {
            let ends = some.iter().map(|&k| [0, 1].map(|end| components[k].bounds[end][axis]));
            let none = (f64::INFINITY, f64::NEG_INFINITY, 0.0);
            let add = |(low, high, sum): (f64, f64, f64), [from, to]: [f64; 2]| {
                (low.min(from), high.max(to), sum + (to - from))
            };
            let (low, high, sum) = ends.fold(none, add);
            (high - low) / sum
        };
        let axis = (0..3).max_by(|&i, &j| spread(i).total_cmp(&spread(j))).unwrap_or(0);
        let [low, high] = [0, 1].map(|end| move |k: usize| components[k].bounds[end][axis]);
        let mut order = some.to_vec();
        order.sort_by(|&i, &j| low(i).total_cmp(&low(j)));
        let leaves = order.len().next_power_of_two();
        let mut farthest = vec![f64::NEG_INFINITY; 2 * leaves];
        farthest[leaves..].iter_mut().zip(&order).for_each(|(node, &k)| *node = high(k));
        for node in (1..leaves).rev() {
            farthest[node] = farthest[2 * node].max(farthest[2 * node + 1]);
        }
        Self { components, axis, order, farthest }
    }

    fn is_in_another(&self, k: usize, work: &Work<'_>) -> bool {
        let [low, high] = self.components[k].bounds;
        let around = |j: usize| {
            let bounds = &self.components[j].bounds;
            j != k && (0..3).all(|i| bounds[0][i] <= low[i] && high[i] <= bounds[1][i])
        };
        let begin_before =
            self.order.partition_point(|&j| self.components[j].bounds[0][self.axis] <= low[self.axis]);
        let leaves = self.farthest.len() / 2;
        let (mut waiting, mut steps) = (vec![(1, leaves)], 0);
        let found = loop {
            let Some((node, covered)) = waiting.pop() else { break false };
            if work.is_spent() {
                break false;
            }
            steps += 1;
            let first = node * covered - leaves;
            if first >= begin_before || self.farthest[node] < high[self.axis] {
                continue;
            }
            if covered > 1 {
                waiting.extend([(2 * node, covered / 2), (2 * node + 1, covered / 2)]);
            } else if around(self.order[first]) {
                break true;
            }
        };
        work.take(steps);
        found
    }
}

/// Components in a piece of work.
const COMPONENTS: usize = 16;

/// Sums over a component as its triangles come by, from its first corner, in the mesh's units.
#[derive(Default)]
struct VolumeSums {
    reference: [f64; 3],
    first: usize,
    triangles: usize,
    six_volume: Sum,
    area: Sum,
    low: [f64; 3],
    high: [f64; 3],
    largest: usize,
    largest_area: f64,
    flipped: usize,
    first_flipped: usize,
}

impl VolumeSums {
    /// True if the triangle may have no area.
    fn add(&mut self, t: usize, triangle: [[f64; 3]; 3], against: bool) -> bool {
        if self.triangles == 0 {
            (self.reference, self.low, self.high) = (triangle[0], triangle[0], triangle[0]);
            (self.first, self.largest) = (t, t);
        }
        self.triangles += 1;
        for p in triangle {
            for (k, c) in p.into_iter().enumerate() {
                self.low[k] = self.low[k].min(c);
                self.high[k] = self.high[k].max(c);
            }
        }
        if against {
            if self.flipped == 0 {
                self.first_flipped = t;
            }
            self.flipped += 1;
        }
        // 6 V = Σ (a − r) · (b − a) × (c − a)
        let [a, b, c] = triangle;
        let from = |p: [f64; 3], q: [f64; 3]| [p[0] - q[0], p[1] - q[1], p[2] - q[2]];
        let (u, v, w) = (from(b, a), from(c, a), from(a, self.reference));
        let n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
        let d = w[0] * n[0] + w[1] * n[1] + w[2] * n[2];
        self.six_volume.add(if against { -d } else { d });
        let area = 0.5 * (n[0] * n[0] + n[1] * n[1] + n[2] * n[2]).sqrt();
        self.area.add(area);
        if area > self.largest_area {
            (self.largest, self.largest_area) = (t, area);
        }
        let longest = u.iter().chain(&v).fold(0.0_f64, |max, c| max.max(c.abs()));
        area <= 1e-14 * longest * longest
    }

    fn component(&self, patch: &Patch, unit: f64) -> MeshComponent {
        let size = (0..3).map(|k| self.high[k] - self.low[k]).fold(0.0, f64::max);
        let (six_volume, area) = (self.six_volume.value(), self.area.value());
        let role = match patch {
            Patch { open: 1.., .. } => ComponentRole::Open,
            Patch { orientable: false, .. } => ComponentRole::Unorientable,
            Patch { unbalanced: 1.., against: 0, .. } => ComponentRole::Inconsistent,
            // No noise of flat triangles is larger: each one's area times its distance, rounded.
            _ if six_volume.abs() <= FLAT * area * power_of_two_near(size) => ComponentRole::Flat,
            _ if six_volume < 0.0 => ComponentRole::Inverted,
            _ => ComponentRole::Solid,
        };
        let place = |p: [f64; 3]| p.map(|c| c * unit);
        MeshComponent {
            first_triangle: self.first + 1,
            triangles: self.triangles,
            volume: six_volume / 6.0 * unit * unit * unit,
            area: area * unit * unit,
            bounds: [place(self.low), place(self.high)],
            role,
            depth: 0,
            inside: None,
            flipped: self.flipped,
            first_flipped: (self.flipped > 0).then_some(self.first_flipped + 1),
        }
    }
}

/// A volume of this part of a flat component's area times its size is all rounding.
pub(crate) const FLAT: f64 = 16.0 * f64::EPSILON;
