//! Connected components of a mesh, and their roles.

use core::ops::Range;

use super::inside::{Nesting, Windings};
use super::patches::{Patch, Patches};
use super::threads::Threads;
use super::weld::Welded;
use super::work::Work;
use crate::math::sum::Sum;
use crate::math::symmetric3::power_of_two_near;

/// Triangles of a mesh that are connected through their edges.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct MeshComponent {
    /// First triangle of the component, from 1.
    pub first_triangle: usize,
    /// Number of triangles, without degenerate ones (two equal corners).
    pub triangles: usize,
    /// Enclosed volume, m³, negative if the component is mostly oriented inward; meaningless if it
    /// is not closed.
    pub volume: f64,
    /// Area of all triangles, m².
    pub area: f64,
    /// Lowest and highest coordinates of the bounding box, m.
    pub bounds: [[f64; 3]; 2],
    /// Role of the component, from its orientation and its nesting in others.
    pub role: ComponentRole,
    /// Number of other closed components that contain it.
    pub depth: usize,
    /// Smallest component that contains it, as an index into
    /// [`MeshDiagnosis::components`](crate::body::mesh::MeshDiagnosis::components).
    pub inside: Option<usize>,
    /// Number of triangles oriented against the majority; 0 without a clear majority.
    pub flipped: usize,
    /// First of these triangles, from 1.
    pub first_flipped: Option<usize>,
}

/// Role of a component of a mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ComponentRole {
    /// Open: the component has a boundary.
    Open,
    /// Unorientable: no consistent orientation exists; the component is one-sided, like a Klein
    /// bottle.
    Unorientable,
    /// Inconsistent: closed but not consistently oriented, without a clear minority of reversed
    /// triangles.
    Inconsistent,
    /// Flat: closed, but it encloses no volume.
    Flat,
    /// Solid: oriented outward, and in no other component or in a cavity.
    Solid,
    /// Cavity: oriented inward, inside a solid.
    Cavity,
    /// Inner solid: oriented outward inside a solid, so that its volume counts twice.
    InnerSolid,
    /// Inverted: oriented inward and inside no solid, so that its volume counts negative.
    Inverted,
}

impl ComponentRole {
    /// Returns true if the component has an inside and an outside.
    pub const fn is_closed(self) -> bool {
        !matches!(self, Self::Open | Self::Unorientable | Self::Inconsistent)
    }

    /// Returns the name of the role: `open`, `solid`, `cavity`, …
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

/// Properties of the components, computed one by one; roles assume that no component lies in
/// another.
#[derive(Default)]
pub(crate) struct Measured {
    pub(crate) components: Vec<MeshComponent>,
    /// Largest triangle of each component.
    largest: Vec<usize>,
    pub(crate) collinear: Vec<u32>,
}

impl Measured {
    pub(crate) fn of(welded: &Welded, patches: &Patches, threads: Threads) -> Self {
        let count = patches.components.len();
        // Each thread processes the triangles of its components.
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
            // `NONE` is out of range here, too.
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

    /// Determines the nesting of the components and updates their roles.
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

/// Search for bounding boxes that contain others: a component inside another has its box inside the
/// other's box.
struct BoxesWithin<'a> {
    components: &'a [MeshComponent],
    /// Axis along which the boxes overlap least.
    axis: usize,
    /// Components, ordered by the lower end of their boxes along the axis.
    order: Vec<usize>,
    /// Complete binary tree over `order`: the largest upper end of the boxes under a node.
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

/// Number of components in a piece of work.
const COMPONENTS: usize = 16;

/// Running sums over the triangles of a component, relative to its first corner, in the mesh's
/// unit.
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
    /// Adds a triangle. Returns true if it may have zero area.
    fn add(&mut self, t: usize, triangle: [[f64; 3]; 3], against: bool) -> bool {
        if self.triangles == 0 {
            (self.reference, self.low, self.high) = (triangle[0], triangle[0], triangle[0]);
            (self.first, self.largest) = (t, t);
        }
        self.triangles += 1;
        for p in triangle {
            // Coordinates are finite, so that comparisons suffice.
            for (k, c) in p.into_iter().enumerate() {
                self.low[k] = if c < self.low[k] { c } else { self.low[k] };
                self.high[k] = if c > self.high[k] { c } else { self.high[k] };
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
            // The bound exceeds the rounding noise of flat triangles: area times distance times ε.
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

/// Relative volume threshold: a component whose volume is below `FLAT` · area · size is flat to
/// within rounding.
pub(crate) const FLAT: f64 = 16.0 * f64::EPSILON;
