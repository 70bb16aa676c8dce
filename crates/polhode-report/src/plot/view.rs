//! A unit sphere seen from far away.

use polhode::math::{Direction, Frame};
use polhode_document::figure::sheet::Point;

/// From where a sphere is seen, and where its picture is.
pub(super) struct View<F: Frame> {
    pub(super) center: Point,
    /// Of the picture, px.
    pub(super) radius: f64,
    right: Direction<F>,
    up: Direction<F>,
    toward: Direction<F>,
}

impl<F: Frame> View<F> {
    /// From the side of `viewer`, with `up` upward: neither is zero, and they are not along one line.
    pub(super) fn new(center: Point, radius: f64, viewer: Direction<F>, up: Direction<F>) -> Self {
        let toward = viewer.direction().unwrap_or(viewer);
        let right = up.cross(toward).direction().unwrap_or(up);
        Self { center, radius, right, up: toward.cross(right), toward }
    }

    pub(super) fn at(&self, v: Direction<F>) -> Point {
        let [x, y] = self.center;
        [x + self.radius * v.dot(self.right), y - self.radius * v.dot(self.up)]
    }

    pub(super) fn is_near(&self, v: Direction<F>) -> bool {
        v.dot(self.toward) >= 0.0
    }

    /// The parts of a curve on the near or the far side.
    pub(super) fn side(&self, near: bool, curve: &[Direction<F>]) -> Vec<Vec<Point>> {
        let parts = curve.chunk_by(|a, b| self.is_near(*a) == self.is_near(*b));
        let wanted = parts.filter(|part| part.first().is_some_and(|v| self.is_near(*v) == near));
        wanted.map(|part| part.iter().map(|v| self.at(*v)).collect()).collect()
    }
}
