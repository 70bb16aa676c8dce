//! Boxes that lie as their triangles do.
//!
//! The boxes along the axes of slanted needles all meet, though the needles are far apart. These have the principal axes of their triangles'
//! corners (S. Gottschalk, M. C. Lin, D. Manocha, OBBTree, SIGGRAPH 1996, 171). They cost more, and are made where those along the axes
//! do not tell enough apart.

use core::ops::{ControlFlow, Range};

use super::inside::centroid;
use super::weld::{NONE, Welded};
use super::work::Work;
use crate::math::symmetric3::Symmetric3;

/// A box with axes of its own.
struct OrientedBox {
    center: [f64; 3],
    axes: [[f64; 3]; 3],
    /// Half its lengths along its axes, ascending but for rounding.
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

    /// Is there certainly a plane between them? It is enough to look along the axes of both, and across one of each.
    fn is_apart(&self, other: &Self) -> bool {
        let between: [f64; 3] = core::array::from_fn(|k| other.center[k] - self.center[k]);
        let reach =
            |b: &Self, along: [f64; 3]| (0..3).map(|k| b.half[k] * dot(b.axes[k], along).abs()).sum::<f64>();
        let apart = |along| dot(between, along).abs() > reach(self, along) + reach(other, along) + MARGIN;
        let crossed = || self.axes.into_iter().flat_map(|a| other.axes.into_iter().map(move |b| cross(a, b)));
        self.axes.into_iter().chain(other.axes).any(apart) || crossed().any(apart)
    }
}

/// More than the rounding of boxes about coordinates between −2 and 2.
const MARGIN: f64 = 1e-13;

fn dot([a, b, c]: [f64; 3], [x, y, z]: [f64; 3]) -> f64 {
    a * x + b * y + c * z
}

fn cross([a, b, c]: [f64; 3], [x, y, z]: [f64; 3]) -> [f64; 3] {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}

/// A binary tree over triangles; its root is the first node.
pub(crate) struct OrientedTree<'a> {
    welded: &'a Welded,
    /// Triangles that are known to lie side by side have the same number here, others [`NONE`].
    group: &'a [u32],
    order: Vec<u32>,
    nodes: Vec<TreeNode>,
}

struct TreeNode {
    bounds: OrientedBox,
    /// In the tree's order.
    triangles: Range<u32>,
    /// None for a leaf.
    children: Option<[u32; 2]>,
    /// The group of all its triangles, or [`NONE`].
    group: u32,
}

/// Two nodes whose triangles are to be compared, or twice the same.
pub(crate) type Task = [u32; 2];

/// Triangles to a leaf, at most.
const LEAF: usize = 4;

/// What comparing two boxes costs, in visits of a ray.
const BOXES: u64 = 4;

impl<'a> OrientedTree<'a> {
    pub(crate) fn of(welded: &'a Welded, triangles: &[u32], group: &'a [u32]) -> Self {
        let mut tree = Self { welded, group, order: triangles.to_vec(), nodes: vec![] };
        if !tree.order.is_empty() {
            tree.divide(0..triangles.len());
        }
        tree
    }

    /// Makes the node of some triangles, and what is below it: halves by the median along its longest axis, groups as if they were in one
    /// place until they are alone.
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
                // SeparateSeries the group that the median is in.
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

    /// Some tasks, which together compare every two triangles, but those of one group.
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

    /// Adds what a task comes down to; false for one between leaves.
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

    /// Calls `pair` for the triangles of a task whose boxes meet, until it breaks or there is no work left.
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

    /// Do the boxes of two triangles along the axes meet?
    fn may_meet(&self, t: u32, u: u32) -> bool {
        let [a, b] = [t, u].map(|t| self.welded.triangle(t as usize));
        let beyond = |a: &[[f64; 3]; 3], b: &[[f64; 3]; 3], k: usize| {
            a[0][k].min(a[1][k]).min(a[2][k]) > b[0][k].max(b[1][k]).max(b[2][k])
        };
        !(0..3).any(|k| beyond(&a, &b, k) || beyond(&b, &a, k))
    }
}

/// How often tasks are divided before they are given to threads.
const ROUNDS: usize = 10;
