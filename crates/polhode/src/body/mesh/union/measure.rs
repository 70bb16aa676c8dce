//! Measure of how well the pieces of a surface fit together.

use super::boundary::Boundary;
use crate::math::sum::Sum;

/// Volume of a surface that should be closed, and its closure defect.
#[derive(Clone, Copy, Debug)]
pub(super) struct Closure {
    pub(super) volume: f64,
    /// Bound of the volume error due to gaps and overlaps.
    pub(super) defect: f64,
}

impl Closure {
    /// Measures a boundary. A closed surface satisfies ∮ n dA = 0 and ∮ x nᵀ dA = V 1. Any
    /// deviation is a volume that is missing or counted twice, seen along one of the axes or across
    /// two.
    pub(super) fn of(boundary: &Boundary) -> Self {
        let (mut areas, mut moments) = ([Sum::default(); 3], [[Sum::default(); 3]; 3]);
        let mut reach = 0.0_f64;
        for corners in &boundary.corners {
            let [a, b, c] = corners.map(|v| boundary.points[v as usize]);
            let from = |p: [f64; 3]| [p[0] - a[0], p[1] - a[1], p[2] - a[2]];
            let (u, v) = (from(b), from(c));
            let area = [(1, 2), (2, 0), (0, 1)].map(|(i, j)| 0.5 * (u[i] * v[j] - u[j] * v[i]));
            for i in 0..3 {
                areas[i].add(area[i]);
                let middle = (a[i] + b[i] + c[i]) / 3.0;
                (0..3).for_each(|j| moments[i][j].add(middle * area[j]));
                reach = reach.max(middle.abs());
            }
        }
        let moments = moments.map(|row| row.map(Sum::value));
        let volume = (moments[0][0] + moments[1][1] + moments[2][2]) / 3.0;
        let open = areas.iter().map(|area| area.value().abs()).fold(0.0, f64::max);
        let off = |i: usize, j: usize| (moments[i][j] - if i == j { volume } else { 0.0 }).abs();
        let uneven =
            (0..3).flat_map(|i| (0..3).map(move |j| (i, j))).map(|(i, j)| off(i, j)).fold(0.0, f64::max);
        Self { volume, defect: uneven + open * reach }
    }
}
