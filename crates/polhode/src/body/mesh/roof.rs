//! Surface above or below a cell: the solid layers at the top and bottom of a print.

use super::offset_cell::{Cell, Facet, Limit};

/// Side of a cell along z.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Side {
    Above,
    Below,
}

impl Side {
    /// Returns the sign of z on this side.
    const fn sign(self) -> f64 {
        match self {
            Self::Above => 1.0,
            Self::Below => -1.0,
        }
    }
}

/// Part of a triangle above a cell, from the centre of the cell; for [`Side::Below`] with −z for z.
#[derive(Debug)]
struct Roof {
    corners: Vec<[f64; 3]>,
    /// Area of its projection along z, m².
    area: f64,
    /// True if a line upward leaves the solid here.
    is_exit: bool,
    lowest: f64,
    highest: f64,
    /// Its plane: z = height + slope · (x, y).
    height: f64,
    slope: [f64; 2],
}

/// Surface above or below a cell that the surface does not enter, and the thickness of the solid
/// layers there.
#[derive(Debug)]
pub(super) struct Roofs {
    all: Vec<Roof>,
    side: Side,
    half: f64,
    thickness: f64,
    /// Greatest height at which all of the surface is here.
    most: f64,
}

/// Share of a projection that may be missing from a whole one, because of rounding.
pub(super) const MISSING: f64 = 1e-9;

/// Returns true if a triangle may be among the [`Roofs`] of a cell or of its parts.
pub(super) fn may_cover(cell: &Cell, Facet(corners): &Facet, [top, bottom]: [f64; 2]) -> bool {
    let range = |k: usize| {
        let along = corners.map(|p| p[k] - cell.center[k]);
        [along.into_iter().fold(f64::INFINITY, f64::min), along.into_iter().fold(f64::NEG_INFINITY, f64::max)]
    };
    let is_near = |k: usize, low: f64, high: f64| {
        let [least, most] = range(k);
        least <= high && most >= low
    };
    let margin = 5.0 * cell.half;
    (0..2).all(|k| is_near(k, -cell.half, cell.half)) && is_near(2, -bottom - margin, top + margin)
}

impl Roofs {
    /// Returns the surface on one side of a cell.
    pub(super) fn of(cell: &Cell, side: Side, thickness: f64, facets: impl Iterator<Item = Facet>) -> Self {
        // Beyond the thickness, too: whether they cover the cell is known from its neighbourhood.
        let most = thickness + 5.0 * cell.half;
        let roofs = facets.filter_map(|facet| Roof::of(cell, side, &facet));
        let all = roofs.filter(|roof| roof.lowest > 0.0 && roof.lowest <= most).collect();
        Self { all, side, half: cell.half, thickness, most }
    }

    /// Returns true if no point of the cell is as near to the surface as the thickness.
    pub(super) fn are_far(&self) -> bool {
        self.all.iter().all(|roof| roof.lowest - self.half >= self.thickness)
    }

    /// Returns true if all points of the cell are in the solid layers.
    pub(super) fn contain_cell(&self) -> bool {
        self.cover(|roof| roof.highest + self.half <= self.thickness)
    }

    /// Returns true if each vertical line through the cell meets one of these roofs.
    ///
    /// A line enters the solid between two places where it leaves it. If it enters it nowhere, the
    /// projections of the roofs do not overlap, and their areas can be added.
    fn cover(&self, is_one: impl Fn(&Roof) -> bool) -> bool {
        let whole = 4.0 * self.half * self.half * (1.0 - MISSING);
        let area = |roof: &Roof| if is_one(roof) { roof.area } else { 0.0 };
        self.all.iter().any(|roof| area(roof) >= whole)
            || self.all.iter().all(|roof| roof.is_exit) && self.all.iter().map(area).sum::<f64>() >= whole
    }

    /// Returns half-spaces whose intersection with the cell is certainly below the layers, and one
    /// that contains all of the cell that is.
    ///
    /// A point is below the layers if z < p − t, with the height p of the roof above it and the
    /// thickness t. The certain part is below the planes of all roofs. If the roofs cover the cell,
    /// none is higher than the plane of the largest one, moved up to the highest of their corners.
    pub(super) fn limits(&self, rounding: f64) -> (Vec<Limit>, Option<Limit>) {
        let certain = self.all.iter().map(|roof| self.limit(roof, self.thickness + rounding)).collect();
        let largest = self.all.iter().max_by(|a, b| a.area.total_cmp(&b.area));
        let possible = largest.filter(|_| self.cover(|roof| roof.highest <= self.most)).map(|largest| {
            let above = |p: &[f64; 3]| p[2] - largest.at(p[0], p[1]);
            let is_alone = largest.area >= 4.0 * self.half * self.half * (1.0 - MISSING);
            let corners = self.all.iter().flat_map(|roof| &roof.corners);
            let most = if is_alone { 0.0 } else { corners.map(above).fold(0.0, f64::max) };
            self.limit(largest, self.thickness - most - rounding)
        });
        (certain, possible)
    }

    /// Returns the half-space of all points that are at least `depth` below the plane of a roof.
    fn limit(&self, roof: &Roof, depth: f64) -> Limit {
        let [x, y] = roof.slope;
        let size = (x * x + y * y + 1.0).sqrt();
        let normal = [x / size, y / size, -self.side.sign() / size];
        Limit { normal, beyond: (depth - roof.height) / size }
    }
}

impl Roof {
    /// Returns the part of a triangle in the vertical column of a cell; `None` if its projection has
    /// no area there.
    fn of(cell: &Cell, side: Side, Facet(corners): &Facet) -> Option<Self> {
        let sign = side.sign();
        let local =
            |p: &[f64; 3]| [p[0] - cell.center[0], p[1] - cell.center[1], sign * (p[2] - cell.center[2])];
        let [a, b, c] = [local(&corners[0]), local(&corners[1]), local(&corners[2])];
        let [u, v]: [[f64; 3]; 2] = [b, c].map(|p| core::array::from_fn(|k| p[k] - a[k]));
        let up = u[0] * v[1] - u[1] * v[0];
        if up == 0.0 {
            return None;
        }
        let slope = [(u[2] * v[1] - u[1] * v[2]) / up, (u[0] * v[2] - u[2] * v[0]) / up];
        let mut part = vec![a, b, c];
        for (k, way) in [(0, 1.0), (0, -1.0), (1, 1.0), (1, -1.0)] {
            part = clipped(&part, |p| cell.half - way * p[k]);
        }
        let area = 0.5 * doubled_area(&part).abs();
        if !(area > 0.0) {
            return None;
        }
        let heights = || part.iter().map(|p| p[2]);
        Some(Self {
            area,
            is_exit: sign * up > 0.0,
            lowest: heights().fold(f64::INFINITY, f64::min),
            highest: heights().fold(f64::NEG_INFINITY, f64::max),
            height: a[2] - slope[0] * a[0] - slope[1] * a[1],
            slope,
            corners: part,
        })
    }

    /// Returns the height of its plane.
    fn at(&self, x: f64, y: f64) -> f64 {
        self.height + self.slope[0] * x + self.slope[1] * y
    }
}

/// Returns the part of a convex polygon where `depth` is not negative.
fn clipped(polygon: &[[f64; 3]], depth: impl Fn(&[f64; 3]) -> f64) -> Vec<[f64; 3]> {
    let mut part = Vec::with_capacity(polygon.len() + 1);
    for (k, p) in polygon.iter().enumerate() {
        let q = &polygon[(k + 1) % polygon.len()];
        let (inside, next) = (depth(p), depth(q));
        if inside >= 0.0 {
            part.push(*p);
        }
        if (inside > 0.0 && next < 0.0) || (inside < 0.0 && next > 0.0) {
            let t = inside / (inside - next);
            part.push(core::array::from_fn(|i| p[i] + t * (q[i] - p[i])));
        }
    }
    part
}

/// Returns Σ (x y' − x' y), twice the signed area of the projection.
fn doubled_area(polygon: &[[f64; 3]]) -> f64 {
    let next = polygon.iter().cycle().skip(1);
    polygon.iter().zip(next).map(|(p, q)| p[0] * q[1] - q[0] * p[1]).sum()
}
