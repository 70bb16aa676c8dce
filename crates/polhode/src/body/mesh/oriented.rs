//! Oriented bounding boxes of triangles.
//!
//! The axis-parallel boxes of oblique needles all intersect, even if the needles are far apart.
//! Oriented boxes have the principal axes of their triangles' corners (S. Gottschalk, M. C. Lin, D.
//! Manocha, OBBTree, SIGGRAPH 1996, 171). They cost more and are used where axis-parallel boxes
//! separate too few triangles.

use core::ops::{ControlFlow, Range};

use super::inside::centroid;
use super::weld::{NONE, Welded};
use super::work::Work;
use crate::math::symmetric3::Symmetric3;

/// Bounding box with its own axes.
struct OrientedBox {
    center: [f64; 3],
    axes: [[f64; 3]; 3],
    /// Half the side lengths along the axes, ascending except for rounding.
    half: [f64; 3],
}

impl OrientedBox {
    fn about(points: impl Iterator<Item = [f64; 3]> + Clone) -> Self {
        let count = points.clone().count().max(1) as f64;
        let sum = points.clone().fold([0.0; 3], |sum, p| core::array::from_fn(|k| sum[k] + p[k]));
        let mean = sum.map(|c| c / count);
        let from_mean = |p: [f64; 3]| core::array::from_fn(|k| p[k] - mean[k]);
        let second = points.clone().map(|p| Symmetric3::outer(from_mean(p)));
        let zero = Symmetric3::diagonal([0.0; 3]);
        let axes = second.fold(zero, |sum, outer| sum + outer).eigen().vectors;
        let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for p in points {
            let along = axes.map(|axis| dot(axis, from_mean(p)));
            low = core::array::from_fn(|k| low[k].min(along[k]));
            high = core::array::from_fn(|k| high[k].max(along[k]));
        }
        let middle: [f64; 3] = core::array::from_fn(|k| 0.5 * (low[k] + high[k]));
        let center = core::array::from_fn(|i| mean[i] + (0..3).map(|k| middle[k] * axes[k][i]).sum::<f64>());
        Self { center, axes, half: core::array::from_fn(|k| 0.5 * (high[k] - low[k])) }
    }

    /// Returns true if a plane certainly separates the boxes. It is sufficient to test the axes of
    /// both boxes and the cross products of one axis of each.
    fn is_apart(&self, other: &Self) -> bool {
        let between: [f64; 3] = core::array::from_fn(|k| other.center[k] - self.center[k]);
        let reach =
            |b: &Self, along: [f64; 3]| (0..3).map(|k| b.half[k] * dot(b.axes[k], along).abs()).sum::<f64>();
        let apart = |along| dot(between, along).abs() > reach(self, along) + reach(other, along) + MARGIN;
        let crossed = || self.axes.into_iter().flat_map(|a| other.axes.into_iter().map(move |b| cross(a, b)));
        self.axes.into_iter().chain(other.axes).any(apart) || crossed().any(apart)
    }
}

/// Margin larger than the rounding of boxes for coordinates between −2 and 2.
const MARGIN: f64 = 1e-13;

fn dot([a, b, c]: [f64; 3], [x, y, z]: [f64; 3]) -> f64 {
    a * x + b * y + c * z
}

fn cross([a, b, c]: [f64; 3], [x, y, z]: [f64; 3]) -> [f64; 3] {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}

/// Binary tree over triangles; its root is the first node.
pub(crate) struct OrientedTree<'a> {
    welded: &'a Welded,
    /// Group of each triangle, or [`NONE`]: triangles of one group are known not to intersect each
    /// other.
    group: &'a [u32],
    order: Vec<u32>,
    nodes: Vec<TreeNode>,
}

struct TreeNode {
    bounds: OrientedBox,
    /// Range of its triangles in the tree's order.
    triangles: Range<u32>,
    /// Children of the node; `None` for a leaf.
    children: Option<[u32; 2]>,
    /// Common group of all its triangles, or [`NONE`].
    group: u32,
}

/// Two nodes whose triangles are to be compared; the two may be the same node.
pub(crate) type Task = [u32; 2];

/// Maximum number of triangles per leaf.
const LEAF: usize = 4;

/// Cost of comparing two boxes, in visits of a ray.
const BOXES: u64 = 4;

impl<'a> OrientedTree<'a> {
    pub(crate) fn of(welded: &'a Welded, triangles: &[u32], group: &'a [u32]) -> Self {
        let mut tree = Self { welded, group, order: triangles.to_vec(), nodes: vec![] };
        if !tree.order.is_empty() {
            tree.divide(0..triangles.len());
        }
        tree
    }

    /// Creates the node of some triangles and its descendants. The triangles are divided at the
    /// median along the longest axis. A group counts as one point until it is alone in a node.
    fn divide(&mut self, own: Range<usize>) -> u32 {
        let welded = self.welded;
        let triangles = &mut self.order[own.clone()];
        let bounds = OrientedBox::about(triangles.iter().flat_map(|&t| welded.triangle(t as usize)));
        let group_of = |t: u32| self.group[t as usize];
        let first = group_of(triangles[0]);
        let is_one = triangles.iter().all(|&t| group_of(t) == first);
        let number = self.nodes.len() as u32;
        let mut half = triangles.len() / 2;
        if triangles.len() > LEAF {
            let longest = bounds.axes[2];
            let key = |&t: &u32| {
                let group = group_of(t);
                let place = if is_one || group == NONE { t } else { group };
                (dot(longest, centroid(welded.triangle(place as usize))), group, t)
            };
            let mut keys: Vec<_> = triangles.iter().map(key).collect();
            keys.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then((a.1, a.2).cmp(&(b.1, b.2))));
            triangles.iter_mut().zip(&keys).for_each(|(t, key)| *t = key.2);
            let split = keys[half].1;
            if !is_one && split != NONE {
                // Moves the split so that the group of the median is not divided.
                let begin = keys.partition_point(|key| (key.0, key.1) < (keys[half].0, split));
                let length = keys[begin..].iter().take_while(|key| key.1 == split).count();
                half = if begin > 0 { begin } else { length };
            }
        }
        let range = own.start as u32..own.end as u32;
        self.nodes.push(TreeNode {
            bounds,
            triangles: range,
            children: None,
            group: if is_one { first } else { NONE },
        });
        if own.len() > LEAF {
            let middle = own.start + half;
            let children = [self.divide(own.start..middle), self.divide(middle..own.end)];
            self.nodes[number as usize].children = Some(children);
        }
        number
    }

    /// Returns tasks that together compare all pairs of triangles, except those of one group.
    pub(crate) fn tasks(&self) -> Vec<Task> {
        let mut tasks = if self.nodes.is_empty() { vec![] } else { vec![[0, 0]] };
        for _ in 0..ROUNDS {
            let mut next = Vec::with_capacity(3 * tasks.len());
            tasks.iter().for_each(|&task| {
                if !self.split(task, &mut next) {
                    next.push(task);
                }
            });
            tasks = next;
        }
        tasks
    }

    /// Adds the subtasks of a task; returns false for a task between leaves.
    fn split(&self, [n, m]: Task, tasks: &mut Vec<Task>) -> bool {
        let [a, b] = [n, m].map(|k| &self.nodes[k as usize]);
        if a.group != NONE && a.group == b.group {
            return true;
        }
        if n == m {
            let Some([k, l]) = a.children else { return false };
            tasks.extend([[k, k], [l, l], [k, l]]);
            return true;
        }
        if a.bounds.is_apart(&b.bounds) {
            return true;
        }
        match (a.children, b.children) {
            (None, None) => return false,
            (Some([k, l]), None) => tasks.extend([[k, m], [l, m]]),
            (None, Some([k, l])) => tasks.extend([[n, k], [n, l]]),
            (Some([k, l]), Some(_)) if a.bounds.half[2] > b.bounds.half[2] => tasks.extend([[k, m], [l, m]]),
            (_, Some([k, l])) => tasks.extend([[n, k], [n, l]]),
        }
        true
    }

    /// Calls `pair` for the triangles of a task whose boxes intersect, until it breaks or no work
    /// is left.
    pub(crate) fn pairs(
        &self,
        task: Task,
        work: &Work<'_>,
        mut pair: impl FnMut(u32, u32) -> ControlFlow<()>,
    ) {
        let mut waiting = vec![task];
        while let Some(task) = waiting.pop() {
            if !work.take(BOXES) {
                return;
            }
            if self.split(task, &mut waiting) {
                continue;
            }
            let [a, b] = task.map(|k| self.nodes[k as usize].triangles.clone());
            for i in a {
                for j in b.clone().filter(|&j| task[0] != task[1] || i < j) {
                    let [t, u] = [i, j].map(|k| self.order[k as usize]);
                    if self.may_meet(t, u) && pair(t, u).is_break() {
                        return;
                    }
                }
            }
        }
    }

    /// Returns true if the axis-parallel boxes of two triangles intersect.
    fn may_meet(&self, t: u32, u: u32) -> bool {
        let [a, b] = [t, u].map(|t| self.welded.triangle(t as usize));
        let beyond = |a: &[[f64; 3]; 3], b: &[[f64; 3]; 3], k: usize| {
            a[0][k].min(a[1][k]).min(a[2][k]) > b[0][k].max(b[1][k]).max(b[2][k])
        };
        !(0..3).any(|k| beyond(&a, &b, k) || beyond(&b, &a, k))
    }
}

/// Number of times that tasks are divided before they are distributed to threads.
const ROUNDS: usize = 10;
