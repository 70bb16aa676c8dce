//! Search tree of the reflex corners of a polygon, to find those inside a triangle.

use super::turn;

/// Points in a tree of bounding boxes, split along the longer side down to a few points.
#[derive(Debug, Default)]
pub(crate) struct Dents {
    /// Points in tree order; each subtree is a contiguous range.
    order: Vec<u32>,
    /// Position of each point in the order.
    place: Vec<u32>,
    /// Boxes of the tree; box k contains the boxes 2 k + 1 and 2 k + 2.
    boxes: Vec<Box>,
    waiting: Vec<Range>,
}

#[derive(Clone, Copy, Debug)]
struct Box {
    low: [f64; 2],
    high: [f64; 2],
    /// Number of points that are not removed.
    count: u32,
}

/// Range of the order, with the index of its box.
#[derive(Clone, Copy, Debug)]
struct Range {
    node: u32,
    from: u32,
    to: u32,
}

/// Maximum number of points in a leaf.
const FEW: u32 = 8;

const NONE: u32 = u32::MAX;

impl Range {
    fn halves(self) -> Option<[Self; 2]> {
        let Self { node, from, to } = self;
        let middle = from + (to - from) / 2;
        let halves =
            [Self { node: 2 * node + 1, from, to: middle }, Self { node: 2 * node + 2, from: middle, to }];
        (to - from > FEW).then_some(halves)
    }

    fn of(self, order: &[u32]) -> &[u32] {
        order.get(self.from as usize..self.to as usize).unwrap_or_default()
    }
}

impl Dents {
    pub(crate) fn start(&mut self, points: &[[f64; 2]], dents: impl Iterator<Item = u32>) {
        let Self { order, place, boxes, waiting } = self;
        order.clear();
        order.extend(dents);
        boxes.clear();
        waiting.clear();
        waiting.push(Range { node: 0, from: 0, to: order.len() as u32 });
        while let Some(range) = waiting.pop() {
            let inside = &mut order[range.from as usize..range.to as usize];
            let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
            for &k in &*inside {
                for (i, &c) in points[k as usize].iter().enumerate() {
                    (low[i], high[i]) = (low[i].min(c), high[i].max(c));
                }
            }
            let node = range.node as usize;
            if boxes.len() <= node {
                boxes.resize(node + 1, Box { low, high, count: 0 });
            }
            boxes[node] = Box { low, high, count: range.to - range.from };
            if let Some(halves) = range.halves() {
                let axis = usize::from(high[1] - low[1] > high[0] - low[0]);
                let by = |&i: &u32, &j: &u32| points[i as usize][axis].total_cmp(&points[j as usize][axis]);
                inside.select_nth_unstable_by((halves[1].from - range.from) as usize, by);
                waiting.extend(halves);
            }
        }
        place.clear();
        place.resize(points.len(), NONE);
        for (at, &k) in (0..).zip(&*order) {
            place[k as usize] = at;
        }
    }

    /// Removes a point; returns true if it was present.
    pub(crate) fn remove(&mut self, k: u32) -> bool {
        let at = std::mem::replace(&mut self.place[k as usize], NONE);
        if at == NONE {
            return false;
        }
        let mut range = Range { node: 0, from: 0, to: self.order.len() as u32 };
        loop {
            self.boxes[range.node as usize].count -= 1;
            let Some([first, second]) = range.halves() else { return true };
            range = if at < first.to { first } else { second };
        }
    }

    /// Returns a point in or on the edge of a triangle that turns left. A point that coincides with
    /// the first corner is ignored: there the polygon touches itself, for example along the cut to
    /// a hole.
    ///
    /// `steps` is reduced by the number of visited boxes and points.
    pub(crate) fn inside(&mut self, points: &[[f64; 2]], corners: [u32; 3], steps: &mut u64) -> Option<u32> {
        let triangle @ [a, b, c] = corners.map(|k| points[k as usize]);
        let edges = [[a, b], [b, c], [c, a]];
        let low: [f64; 2] = std::array::from_fn(|i| a[i].min(b[i]).min(c[i]));
        let high: [f64; 2] = std::array::from_fn(|i| a[i].max(b[i]).max(c[i]));
        let Self { order, place, boxes, waiting } = self;
        waiting.clear();
        waiting.push(Range { node: 0, from: 0, to: order.len() as u32 });
        while let Some(range) = waiting.pop() {
            *steps = steps.saturating_sub(1);
            let around = &boxes[range.node as usize];
            let apart = (0..2).any(|i| around.low[i] > high[i] || around.high[i] < low[i]);
            if around.count == 0 || apart || edges.iter().any(|&edge| around.is_right_of(edge)) {
                continue;
            }
            if let Some(halves) = range.halves() {
                waiting.extend(halves);
                continue;
            }
            for &k in range.of(order) {
                *steps = steps.saturating_sub(1);
                let p = points[k as usize];
                let is_there = place[k as usize] != NONE && !corners.contains(&k) && p != triangle[0];
                if is_there && edges.iter().all(|&[from, to]| turn(from, to, p) >= 0.0) {
                    return Some(k);
                }
            }
        }
        None
    }
}

impl Box {
    /// Returns true if the whole box is to the right of a line. It suffices to test the leftmost
    /// corner.
    fn is_right_of(&self, [from, to]: [[f64; 2]; 2]) -> bool {
        let x = if to[1] < from[1] { self.high[0] } else { self.low[0] };
        let y = if to[0] > from[0] { self.high[1] } else { self.low[1] };
        turn(from, to, [x, y]) < 0.0
    }
}
