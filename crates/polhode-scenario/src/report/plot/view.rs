//! View of a unit sphere from far away.

use polhode::math::{Direction, Frame};
use polhode_document::figure::sheet::Point;

/// View of a unit sphere: viewing direction, and position of the picture.
pub(crate) struct View<F: Frame> {
    pub center: Point,
    /// Radius of the picture, px.
    pub radius: f64,
    right: Direction<F>,
    up: Direction<F>,
    toward: Direction<F>,
}

impl<F: Frame> View<F> {
    /// Returns the view from the direction `viewer`, with `up` upward; these must be nonzero and
    /// not parallel.
    pub(crate) fn new(center: Point, radius: f64, viewer: Direction<F>, up: Direction<F>) -> Self {
        let toward = viewer.direction().unwrap_or(viewer);
        let right = up.cross(toward).direction().unwrap_or(up);
        Self { center, radius, right, up: toward.cross(right), toward }
    }

    pub(crate) fn at(&self, v: Direction<F>) -> Point {
        let [x, y] = self.center;
        [x + self.radius * v.dot(self.right), y - self.radius * v.dot(self.up)]
    }

    pub(crate) fn is_near(&self, v: Direction<F>) -> bool {
        v.dot(self.toward) >= 0.0
    }

    /// Returns the parts of a curve on the near side or on the far side.
    pub(crate) fn side(&self, near: bool, curve: &[Direction<F>]) -> Vec<Vec<Point>> {
        let parts = curve.chunk_by(|a, b| self.is_near(*a) == self.is_near(*b));
        let wanted = parts.filter(|part| part.first().is_some_and(|v| self.is_near(*v) == near));
        wanted.map(|part| part.iter().map(|v| self.at(*v)).collect()).collect()
    }
}
