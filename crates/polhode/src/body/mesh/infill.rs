//! Region of a solid behind the walls and the solid layers of a print.

use super::ClosedMesh;
use super::moment_bound::MomentBound;
use super::offset_cell::{Cell, Facet, Moments};
use super::roof::{MISSING, Roofs, Side, may_cover};
use super::threads::Threads;
use super::tree::Tree;
use super::weld::Welded;
use super::work::GoesOn;
use crate::body::error::{BodyError, positive};
use crate::body::inertia::InertiaTensor;
use crate::body::mass_properties::MassProperties;
use crate::body::shape::{Shape, Substance};
use crate::math::frame::Part;
use crate::math::vector::Position;

/// Solid outside of a print, as thicknesses in m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PrintShell {
    /// Thickness of the walls, along the whole surface.
    pub walls: f64,
    /// Thickness of the solid layers under what faces up, along z; 0 for none.
    pub top: f64,
    /// Thickness of the solid layers over what faces down, along z; 0 for none.
    pub bottom: f64,
}

/// Infill of a printed solid: all of its points whose distance from the surface exceeds the
/// thickness of the walls, and whose distance from it along z exceeds that of the solid layers.
/// [`ClosedMesh::infill`] computes it.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct MeshInfill {
    /// Volume of the infill, m³.
    pub volume: f64,
    /// Error bounds of its moments about the solid's centroid, m³, m⁴ and m⁵.
    pub bound: MomentBound,
    moments: Moments,
}

/// Largest number of cells that are computed.
const MOST_CELLS: f64 = 3e7;

/// Number of first cells along each axis.
const FIRST: usize = 8;

impl ClosedMesh {
    /// Returns the infill behind walls and solid layers. The error bound of its volume is at most
    /// `tolerance` of it, or a millionth of the solid's volume. The computation ends early if
    /// `goes_on` returns false; the result is then meaningless.
    ///
    /// The solid is divided into cubes. A cube is skipped if it is outside, or if a triangle is
    /// nearer than the walls from all of its points, or if it is in the solid layers. It counts as
    /// a whole if neither is true of any of its points. Others are divided until their radius r is
    /// small, and then bounded by planes.
    ///
    /// Let p be the point of a triangle T that is nearest to the centre c, n the direction from p
    /// to c, and d the thickness of the walls. As T is convex, the distance of x from T is at least
    /// n · (x − p), and at most |x − p|. So the infill in the cube contains all x with n · (x − p) >
    /// d for each T, and lies within n · (x − p) > √(d² − r²), or n · (x − p) > d if the cube
    /// projects into T.
    /// Layers of the thickness t under the heights p(x, y) of the surface are bounded in the same
    /// way: the infill contains z < p − t for the plane of each triangle above, and lies within the
    /// same for the highest plane, if the triangles cover the cube. The mean of both polyhedra
    /// counts, and half of their difference is the bound.
    ///
    /// ```
    /// use polhode::body::mesh::{ClosedMesh, ConvexHull, PrintShell};
    /// let corners = (0..8).map(|k| [k & 1, k >> 1 & 1, k >> 2].map(|c| 0.3 + 2.0 * f64::from(c)));
    /// let cube = ClosedMesh::of(&ConvexHull::of(&corners.collect::<Vec<_>>())?)?;
    /// let shell = PrintShell { walls: 0.25, top: 0.5, bottom: 0.0 };
    /// let infill = cube.infill(&shell, 1e-3, &|| true)?;
    /// assert!((infill.volume - 1.5 * 1.5 * (2.0 - 0.25 - 0.5)).abs() <= infill.bound.measure);
    /// # Ok::<(), polhode::body::BodyError>(())
    /// ```
    ///
    /// # Errors
    /// [`BodyError::Parameter`] for walls or a tolerance that are not positive and finite, layers
    /// that are negative or infinite, or walls that need too many cells;
    /// [`BodyError::OverlappingMesh`] if the surface goes through itself.
    pub fn infill(
        &self,
        shell: &PrintShell,
        tolerance: f64,
        goes_on: &(dyn Fn() -> bool + Sync),
    ) -> Result<MeshInfill, BodyError> {
        let PrintShell { walls, top, bottom } = *shell;
        positive("the thickness of the walls", walls)?;
        for (what, value) in
            [("the thickness of the top layers", top), ("the thickness of the bottom layers", bottom)]
        {
            if !(value >= 0.0 && value.is_finite()) {
                return Err(BodyError::Parameter { what, value, rule: "finite and not negative" });
            }
        }
        positive("the tolerance of the infill", tolerance)?;
        if let Some(pair) = self.diagnosis().self_overlaps.first {
            let pairs = self.diagnosis().self_overlaps.count;
            return Err(BodyError::OverlappingMesh { pairs, triangles: pair.triangles, point: pair.point });
        }
        let search = Search::of(self, *shell);
        let enough = |volume: f64| (tolerance * volume).max(1e-6 * self.volume());
        // Walls thicker than the solid leave no infill, whatever the size of the cells.
        let mut radius = 0.4 * walls.min(search.half * 0.25);
        loop {
            if search.cells(radius) > MOST_CELLS {
                let rule = "large enough for 30 million cells: use thicker walls or a larger tolerance";
                let (what, value) = ("the thickness of the walls", walls);
                return Err(BodyError::Parameter { what, value, rule });
            }
            let (moments, bound) = search.run(radius, goes_on);
            let wanted = enough(moments.volume);
            if bound.measure <= wanted || !goes_on() {
                return Ok(MeshInfill { volume: moments.volume, bound, moments });
            }
            // The bound falls with the square of the radius.
            radius *= (0.9 * (wanted / bound.measure).sqrt()).clamp(0.1, 0.7);
        }
    }
}

impl MeshInfill {
    /// Returns the mass properties of a solid with this infill, whose density is `fraction` of the
    /// walls' density. Also returns the bounds of its uncertain moments about its centre of mass,
    /// kg, kg m and kg m². A mass is that of walls and infill together; a density is that of the
    /// walls.
    ///
    /// # Errors
    /// [`BodyError`] for a substance or a fraction that is not physical.
    pub fn mass_properties(
        &self,
        solid: &ClosedMesh,
        substance: Substance,
        fraction: f64,
    ) -> Result<(MassProperties<Part>, MomentBound), BodyError> {
        if !(0.0..=1.0).contains(&fraction) {
            let (what, rule) = ("the infill", "from 0 to 1");
            return Err(BodyError::Parameter { what, value: fraction, rule });
        }
        let missing = 1.0 - fraction;
        let whole = solid.mass_properties(substance)?;
        if missing == 0.0 || self.volume == 0.0 && self.bound.measure == 0.0 {
            return Ok((whole, MomentBound::default()));
        }
        let spread = solid.spread();
        let Moments { volume: infill, first, second } = self.moments;
        let filled = solid.volume() - missing * infill;
        let density = match substance {
            Substance::Mass(mass) => mass / filled,
            _ => whole.mass() / solid.volume(),
        };
        let mass = density * filled;
        let offset: [f64; 3] = first.map(|f| -missing * f / filled);
        let covariance = spread.covariance;
        let own = [
            [covariance.xx, covariance.xy, covariance.xz],
            [covariance.xy, covariance.yy, covariance.yz],
            [covariance.xz, covariance.yz, covariance.zz],
        ];
        // Second moments about the centre of mass, per density.
        let moment = |i: usize, j: usize| {
            solid.volume() * own[i][j] - missing * second[i][j] - filled * offset[i] * offset[j]
        };
        let trace = moment(0, 0) + moment(1, 1) + moment(2, 2);
        let tensor = core::array::from_fn(|i| {
            core::array::from_fn(|j| density * (if i == j { trace - moment(i, i) } else { -moment(i, j) }))
        });
        let centroid = spread.centroid().to_array();
        let center = Position::from_array(core::array::from_fn(|k| centroid[k] + offset[k]));
        let properties = MassProperties::new(mass, center, InertiaTensor::from_matrix(tensor)?)?;
        Ok((properties, self.bound.about(offset) * (missing * density)))
    }
}

/// Triangles that may matter to a cell.
#[derive(Clone, Copy)]
struct Candidates<'t> {
    /// All that are not farther from it than the walls' thickness.
    near: &'t [u32],
    /// All that may be above or below it within the thickness of the layers.
    over: &'t [u32],
}

/// Triangles of a solid, with coordinates from its centroid.
struct Search {
    facets: Vec<Facet>,
    welded: Welded,
    tree: Tree,
    centroid: [f64; 3],
    /// Centre and half width of the cube around the solid.
    middle: [f64; 3],
    half: f64,
    area: f64,
    /// Bound of what may be missing where triangles cover a cell.
    missing: MomentBound,
    shell: PrintShell,
    threads: Threads,
}

impl Search {
    fn of(solid: &ClosedMesh, shell: PrintShell) -> Self {
        let surface = solid.surface();
        let threads = Threads::of_machine();
        let centroid = solid.spread().centroid().to_array();
        let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for p in surface.coordinates() {
            low = core::array::from_fn(|k| low[k].min(p[k] - centroid[k]));
            high = core::array::from_fn(|k| high[k].max(p[k] - centroid[k]));
        }
        let local = |p: [f64; 3]| core::array::from_fn(|k| p[k] - centroid[k]);
        let welded = Welded::of(surface, threads);
        // The margin keeps the surface off the sides of the cube.
        let half = 0.5 * 1.01 * (0..3).map(|k| high[k] - low[k]).fold(0.0, f64::max);
        let has_layers = shell.top > 0.0 || shell.bottom > 0.0;
        let missing = if has_layers { MISSING * solid.volume() } else { 0.0 };
        Self {
            facets: surface.corners().map(|corners| Facet(corners.map(local))).collect(),
            tree: Tree::of(&welded, |_| true, threads),
            welded,
            centroid,
            middle: core::array::from_fn(|k| 0.5 * (low[k] + high[k])),
            half,
            area: solid.surface_area(),
            missing: MomentBound::within(missing, 4.0 * half),
            shell,
            threads,
        }
    }

    /// Returns an estimate of the number of cells of this radius at the boundary of the infill.
    fn cells(&self, radius: f64) -> f64 {
        self.area / (radius * radius)
    }

    /// Returns the moments of the infill and their bounds, with cells of at most this radius.
    fn run(&self, radius: f64, goes_on: &GoesOn<'_>) -> (Moments, MomentBound) {
        let all: Vec<u32> = (0..self.facets.len() as u32).collect();
        let half = self.half / FIRST as f64;
        let parts = self.threads.map(FIRST * FIRST * FIRST, |k| {
            let index = [k % FIRST, k / FIRST % FIRST, k / FIRST / FIRST];
            let center =
                core::array::from_fn(|i| self.middle[i] - self.half + half * (2 * index[i] + 1) as f64);
            let mut sums = (Moments::default(), MomentBound::default());
            let all = Candidates { near: &all, over: &all };
            self.visit(Cell { center, half }, all, false, radius, goes_on, &mut sums);
            sums
        });
        parts
            .into_iter()
            .fold((Moments::default(), self.missing), |all, part| (all.0 + part.0, all.1 + part.1))
    }

    /// Adds the infill in a cell; `is_inside` is true if the cell is known to lie inside the solid.
    fn visit(
        &self,
        cell: Cell,
        Candidates { near, over }: Candidates<'_>,
        mut is_inside: bool,
        smallest: f64,
        goes_on: &GoesOn<'_>,
        sums: &mut (Moments, MomentBound),
    ) {
        // Coordinates are rounded to far less.
        let rounding = 1e-12 * self.half;
        let radius = cell.radius() + rounding;
        let PrintShell { walls, top, bottom } = self.shell;
        let mut relevant = Vec::new();
        let mut closest = f64::INFINITY;
        for &t in near {
            let nearest = self.facets[t as usize].nearest(cell.center);
            if nearest.distance <= walls - radius {
                return;
            }
            closest = closest.min(nearest.distance);
            if nearest.distance <= walls + radius {
                relevant.push((t, nearest));
            }
        }
        if !is_inside && closest > radius {
            if self.winding(cell.center) <= 0 {
                return;
            }
            is_inside = true;
        }
        let facet = |t: u32| self.facets[t as usize];
        let has_layers = top > 0.0 || bottom > 0.0;
        let over: Vec<u32> = over
            .iter()
            .copied()
            .filter(|t| has_layers && may_cover(&cell, &facet(*t), [top, bottom]))
            .collect();
        let mut layers = Vec::new();
        if is_inside {
            for (side, thickness) in [(Side::Above, top), (Side::Below, bottom)] {
                let roofs = Roofs::of(&cell, side, thickness, over.iter().map(|t| facet(*t)));
                if roofs.contain_cell() {
                    return;
                }
                if !roofs.are_far() {
                    layers.push(roofs);
                }
            }
        }
        if is_inside && relevant.is_empty() && layers.is_empty() {
            sums.0 = sums.0 + cell.moments();
        } else if is_inside && radius <= smallest {
            let facets: Vec<_> = relevant.iter().map(|(t, nearest)| (facet(*t), *nearest)).collect();
            let mut limits = [Vec::new(), Vec::new()];
            for roofs in &layers {
                let (certain, possible) = roofs.limits(rounding);
                limits[0].extend(certain);
                limits[1].extend(possible);
            }
            let (moments, bound) = cell.beyond(&facets, limits, walls, rounding);
            *sums = (sums.0 + moments, sums.1 + bound);
        } else if goes_on() {
            let near: Vec<u32> = relevant.iter().map(|(t, _)| *t).collect();
            for part in cell.parts() {
                let all = Candidates { near: &near, over: &over };
                self.visit(part, all, is_inside, smallest, goes_on, sums);
            }
        }
    }

    /// Returns the winding number of the surface about a point that is not on it.
    fn winding(&self, point: [f64; 3]) -> i32 {
        let scaled = core::array::from_fn(|k| (point[k] + self.centroid[k]) / self.welded.unit);
        super::inside::winding(&self.welded, &self.tree, scaled)
    }
}
