//! Cubic cells, and the part of a cell that is farther from triangles than a distance.

use core::ops::Add;

use super::Triangle;
use super::moment_bound::MomentBound;

/// Volume and moments of a region about the origin.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Moments {
    pub(super) volume: f64,
    pub(super) first: [f64; 3],
    pub(super) second: [[f64; 3]; 3],
}

impl Add for Moments {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            volume: self.volume + other.volume,
            first: core::array::from_fn(|i| self.first[i] + other.first[i]),
            second: core::array::from_fn(|i| {
                core::array::from_fn(|j| self.second[i][j] + other.second[i][j])
            }),
        }
    }
}

impl Moments {
    fn scaled(self, factor: f64) -> Self {
        Self {
            volume: self.volume * factor,
            first: self.first.map(|x| x * factor),
            second: self.second.map(|row| row.map(|x| x * factor)),
        }
    }

    /// Returns the same moments of a region moved by a vector.
    fn moved(self, by: [f64; 3]) -> Self {
        let Self { volume, first, second } = self;
        Self {
            volume,
            first: core::array::from_fn(|i| first[i] + volume * by[i]),
            second: core::array::from_fn(|i| {
                core::array::from_fn(|j| {
                    second[i][j] + first[i] * by[j] + first[j] * by[i] + volume * by[i] * by[j]
                })
            }),
        }
    }

    fn of_tetrahedron(corners: &[[f64; 3]; 4]) -> Self {
        let [a, b, c, d] = corners;
        let [u, v, w]: [[f64; 3]; 3] = [b, c, d].map(|p| core::array::from_fn(|k| p[k] - a[k]));
        let across = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
        let volume = (across[0] * w[0] + across[1] * w[1] + across[2] * w[2]).abs() / 6.0;
        let sum: [f64; 3] = core::array::from_fn(|k| a[k] + b[k] + c[k] + d[k]);
        let product =
            |i: usize, j: usize| a[i] * a[j] + b[i] * b[j] + c[i] * c[j] + d[i] * d[j] + sum[i] * sum[j];
        Self {
            volume,
            first: sum.map(|s| volume * s / 4.0),
            second: core::array::from_fn(|i| core::array::from_fn(|j| volume / 20.0 * product(i, j))),
        }
    }
}

/// Triangle by its corners.
#[derive(Clone, Copy, Debug)]
pub(super) struct Facet(pub(super) Triangle);

/// Point of a triangle that is nearest to another point.
#[derive(Clone, Copy, Debug)]
pub(super) struct Nearest {
    pub(super) point: [f64; 3],
    pub(super) distance: f64,
}

impl Facet {
    pub(super) fn nearest(&self, p: [f64; 3]) -> Nearest {
        let [a, b, c] = self.0;
        let candidates = [on_segment(a, b, p), on_segment(b, c, p), on_segment(c, a, p)];
        let inside = self.foot(p).filter(|(_, depth)| *depth >= 0.0).map(|(foot, _)| foot);
        let near = |point: [f64; 3]| Nearest { point, distance: length(minus(p, point)) };
        let edges = candidates.into_iter().map(near);
        let all = inside.map(near).into_iter().chain(edges);
        all.reduce(|best, next| if next.distance < best.distance { next } else { best })
            .unwrap_or(Nearest { point: a, distance: length(minus(p, a)) })
    }

    /// Returns the foot of the perpendicular from a point to the plane, and its distance from the
    /// nearest line through an edge, negative outside the triangle; `None` without an area.
    fn foot(&self, p: [f64; 3]) -> Option<([f64; 3], f64)> {
        let [a, b, c] = self.0;
        let normal = cross(minus(b, a), minus(c, a));
        let size = length(normal);
        if !(size > 0.0) {
            return None;
        }
        let unit = normal.map(|x| x / size);
        let height = dot(unit, minus(p, a));
        let foot = core::array::from_fn(|k| p[k] - height * unit[k]);
        let depth = |from: [f64; 3], to: [f64; 3]| {
            let edge = minus(to, from);
            dot(cross(unit, edge), minus(foot, from)) / length(edge)
        };
        Some((foot, depth(a, b).min(depth(b, c)).min(depth(c, a))))
    }
}

fn on_segment(a: [f64; 3], b: [f64; 3], p: [f64; 3]) -> [f64; 3] {
    let edge = minus(b, a);
    let squared = dot(edge, edge);
    let t = if squared > 0.0 { (dot(edge, minus(p, a)) / squared).clamp(0.0, 1.0) } else { 0.0 };
    core::array::from_fn(|k| a[k] + t * edge[k])
}

/// Cube by its centre and half its width.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cell {
    pub(super) center: [f64; 3],
    pub(super) half: f64,
}

/// Half-space: all x with normal · (x − centre of the cell) > beyond.
#[derive(Clone, Copy, Debug)]
pub(super) struct Limit {
    pub(super) normal: [f64; 3],
    pub(super) beyond: f64,
}

impl Cell {
    /// Returns the largest distance of its points from the centre.
    pub(super) fn radius(&self) -> f64 {
        self.half * 3.0_f64.sqrt()
    }

    pub(super) fn parts(&self) -> [Self; 8] {
        let half = 0.5 * self.half;
        core::array::from_fn(|k| {
            let sign = |i: usize| if k >> i & 1 == 1 { half } else { -half };
            Self { center: core::array::from_fn(|i| self.center[i] + sign(i)), half }
        })
    }

    pub(super) fn moments(&self) -> Moments {
        let volume = (2.0 * self.half).powi(3);
        let own = volume * self.half * self.half / 3.0;
        let second = core::array::from_fn(|i| core::array::from_fn(|j| if i == j { own } else { 0.0 }));
        Moments { volume, first: [0.0; 3], second }.moved(self.center)
    }

    /// Returns the moments of the part of the cell that is farther than `distance` from all of the
    /// triangles, and within other limits, and their bounds. The part within `certain` belongs to
    /// the region, and all of the region is within `possible`.
    pub(super) fn beyond(
        &self,
        facets: &[(Facet, Nearest)],
        [certain, possible]: [Vec<Limit>; 2],
        distance: f64,
        rounding: f64,
    ) -> (Moments, MomentBound) {
        let radius = self.radius() + rounding;
        let least = (distance * distance - radius * radius).max(0.0).sqrt();
        let (mut certain, mut possible) = (certain, possible);
        for (facet, nearest) in facets {
            let away = minus(self.center, nearest.point);
            let normal = away.map(|x| x / nearest.distance);
            let is_beside = facet.foot(self.center).is_some_and(|(_, depth)| depth > radius);
            let inner = distance + rounding - nearest.distance;
            let outer = if is_beside { distance } else { least } - rounding - nearest.distance;
            certain.push(Limit { normal, beyond: inner });
            possible.push(Limit { normal, beyond: outer });
        }
        let [inner, outer] = [certain, possible].map(|mut limits| {
            limits.retain(|limit| limit.beyond > -self.support(limit.normal));
            // The strictest first.
            limits.sort_by(|a, b| b.beyond.total_cmp(&a.beyond));
            limits.dedup_by(|a, b| a.normal == b.normal);
            self.within(&limits)
        });
        let unsure = 0.5 * (outer.volume - inner.volume).max(0.0);
        let reach: [f64; 3] = self.center.map(|c| c.abs() + self.half);
        let bound = MomentBound {
            measure: unsure,
            first: reach.map(|x| unsure * x),
            second: core::array::from_fn(|i| core::array::from_fn(|j| unsure * reach[i] * reach[j])),
        };
        ((inner + outer).scaled(0.5).moved(self.center), bound)
    }

    /// Returns the largest normal · (x − centre) of its points.
    fn support(&self, normal: [f64; 3]) -> f64 {
        self.half * normal.iter().map(|x| x.abs()).sum::<f64>()
    }

    /// Returns the moments of the part of the cell within half-spaces, about the cell's centre.
    fn within(&self, limits: &[Limit]) -> Moments {
        let corner =
            |k: usize| core::array::from_fn(|i| if k >> i & 1 == 1 { self.half } else { -self.half });
        // Six tetrahedra along a diagonal.
        let mut all: Vec<[[f64; 3]; 4]> =
            [[1, 3], [3, 2], [2, 6], [6, 4], [4, 5], [5, 1]].map(|[a, b]| [0, a, b, 7].map(corner)).to_vec();
        let mut next = Vec::new();
        for limit in limits {
            for tetrahedron in all.drain(..) {
                cut(&tetrahedron, limit, &mut next);
            }
            core::mem::swap(&mut all, &mut next);
        }
        all.iter().map(Moments::of_tetrahedron).fold(Moments::default(), Moments::add)
    }
}

/// Adds the part of a tetrahedron within a half-space, as tetrahedra.
fn cut(tetrahedron: &[[f64; 3]; 4], limit: &Limit, parts: &mut Vec<[[f64; 3]; 4]>) {
    let mut corners: Vec<([f64; 3], f64)> =
        tetrahedron.iter().map(|p| (*p, dot(limit.normal, *p) - limit.beyond)).collect();
    corners.sort_by(|a, b| b.1.total_cmp(&a.1));
    let inside = corners.iter().filter(|corner| corner.1 > 0.0).count();
    let between = |i: usize, j: usize| {
        let (p, q) = (corners[i], corners[j]);
        let t = p.1 / (p.1 - q.1);
        core::array::from_fn(|k| p.0[k] + t * (q.0[k] - p.0[k]))
    };
    let [a, b, c, d] = [corners[0].0, corners[1].0, corners[2].0, corners[3].0];
    // A prism with the triangles (u, v, w) and (x, y, z).
    let mut prism = |[u, v, w]: Triangle, [x, y, z]: Triangle| {
        parts.extend([[u, v, w, x], [v, w, x, y], [w, x, y, z]]);
    };
    match inside {
        0 => {}
        1 => parts.push([a, between(0, 1), between(0, 2), between(0, 3)]),
        2 => prism([a, between(0, 2), between(0, 3)], [b, between(1, 2), between(1, 3)]),
        3 => prism([a, b, c], [between(0, 3), between(1, 3), between(2, 3)]),
        _ => parts.push([a, b, c, d]),
    }
}

fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    core::array::from_fn(|k| a[k] - b[k])
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn length(a: [f64; 3]) -> f64 {
    dot(a, a).sqrt()
}
