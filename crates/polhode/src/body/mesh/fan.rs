//! Triangles around one edge, in angular order.

use core::cmp::Ordering;

use super::edges::{end_of, opposite, start_of};
use super::patches::Patches;
use super::predicate::{across, facing, side, turn};
use super::weld::Welded;

/// Returns two triangles of an edge of more than two triangles whose bodies overlap there, if no
/// other triangles pass through the edge. This is so if the winding numbers around the edge differ
/// by more than one. The pair with the lowest indices is returned; `None` if there is none, or if
/// one of the triangles has no area.
///
/// Along a circle around the edge, the winding number falls by one where a triangle is crossed in
/// the direction of its normal, and rises by one where it is crossed against it. Coincident
/// triangles are one step: bodies that touch there have nothing in between.
pub(crate) fn overlapping(welded: &Welded, patches: &Patches, edge: &[u32]) -> Option<[u32; 2]> {
    let corners = &welded.corners;
    let start = start_of(corners, edge[0]);
    let fan = Fan([start, end_of(corners, edge[0])].map(|v| welded.points[v as usize]));
    let mut wings: Vec<Wing> = Vec::with_capacity(edge.len());
    for &half in edge {
        let tip = welded.points[opposite(corners, half) as usize];
        let first = wings.first().map_or(tip, |wing| wing.angle.tip);
        let triangle = half / 3;
        let forward = (start_of(corners, half) == start) != patches.against[triangle as usize];
        // A triangle without area has no angle; the order around its edge is undefined.
        let angle = fan.angle(first, tip)?;
        wings.push(Wing { triangle, angle, step: if forward { -1 } else { 1 } });
    }
    wings.sort_by(|a, b| fan.order(&a.angle, &b.angle));
    let steps: Vec<&[Wing]> = wings.chunk_by(|a, b| fan.order(&a.angle, &b.angle).is_eq()).collect();
    let height = |wings: &[Wing]| wings.iter().map(|wing| wing.step).sum::<i32>();
    let (mut winding, mut lowest, mut highest) = (0, 0, 0);
    for wings in &steps {
        winding += height(wings);
        (lowest, highest) = (lowest.min(winding), highest.max(winding));
    }
    if winding != 0 || highest - lowest <= 1 {
        return None;
    }
    // Two consecutive steps up, or down, belong to two bodies.
    let in_step = |wings: &[Wing]| {
        let step = height(wings).signum();
        wings.iter().filter(move |wing| wing.step == step).map(|wing| wing.triangle).collect::<Vec<_>>()
    };
    let moving: Vec<_> =
        steps.iter().map(|wings| (height(wings), in_step(wings))).filter(|s| s.0 != 0).collect();
    let next = moving.iter().cycle().skip(1);
    let after = moving.iter().zip(next).filter(|(a, b)| a.0.signum() == b.0.signum() && moving.len() > 1);
    let pairs = after.filter_map(|(a, b)| Some([*a.1.iter().min()?, *b.1.iter().min()?]));
    let within = moving.iter().filter(|step| step.1.len() > 1).map(|step| [step.1[0], step.1[1]]);
    pairs.chain(within).map(|[t, u]| [t.min(u), t.max(u)]).min()
}

/// Triangle at the edge.
struct Wing {
    triangle: u32,
    angle: Angle,
    /// Change of the winding number at the triangle.
    step: i32,
}

/// Angular position of the half-plane from the edge to a point, counted from the first point.
pub(crate) struct Angle {
    tip: [f64; 3],
    quarter: Quarter,
}

#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Quarter {
    Along,
    Left,
    Opposite,
    Right,
}

/// Line through two points, about which half-planes are ordered.
pub(crate) struct Fan(pub(crate) [[f64; 3]; 2]);

impl Fan {
    /// Returns the angular position of `tip`, counted from `first`; `None` if a point is on the
    /// line.
    pub(crate) fn angle(&self, first: [f64; 3], tip: [f64; 3]) -> Option<Angle> {
        Some(Angle { tip, quarter: self.quarter(first, tip)? })
    }

    fn quarter(&self, first: [f64; 3], tip: [f64; 3]) -> Option<Quarter> {
        let [a, b] = self.0;
        let (axis, of_first) = facing([a, b, first])?;
        let height = side([a, b, first], tip);
        let of_tip = turn(across(axis, a), across(axis, b), across(axis, tip));
        match height {
            0.0 if of_tip == 0.0 => None,
            0.0 if (of_tip > 0.0) == (of_first > 0.0) => Some(Quarter::Along),
            0.0 => Some(Quarter::Opposite),
            _ => Some(if height > 0.0 { Quarter::Left } else { Quarter::Right }),
        }
    }

    /// Compares two angular positions that are counted from the same first point.
    pub(crate) fn order(&self, p: &Angle, q: &Angle) -> Ordering {
        let [a, b] = self.0;
        let turned = || match side([a, b, p.tip], q.tip) {
            0.0 => Ordering::Equal,
            height if height > 0.0 => Ordering::Less,
            _ => Ordering::Greater,
        };
        p.quarter.cmp(&q.quarter).then_with(|| match p.quarter {
            Quarter::Left | Quarter::Right => turned(),
            _ => Ordering::Equal,
        })
    }
}
