//! Plane sections of tanks, perpendicular to the direction in which the liquid settles.

/// Area of a section and its first and second moments, along the two axes that follow its normal in
/// cyclic order.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Section {
    pub(super) area: f64,
    pub(super) first: [f64; 2],
    /// Second moments. All shapes here are symmetric about one of the two axes, so there is no
    /// product.
    pub(super) second: [f64; 2],
}

impl Section {
    pub(super) fn rectangle([a, b]: [f64; 2]) -> Self {
        let area = a * b;
        Self { area, first: [0.0; 2], second: [area * a * a / 12.0, area * b * b / 12.0] }
    }

    pub(super) fn ellipse([a, b]: [f64; 2]) -> Self {
        let area = core::f64::consts::PI * a * b;
        Self { area, first: [0.0; 2], second: [0.25 * area * a * a, 0.25 * area * b * b] }
    }

    /// Returns a rectangle with half ellipses at its ends. It has the half width w along the first
    /// axis and a length along the second; the half ellipses have these heights.
    pub(super) fn stadium(w: f64, length: f64, [below, above]: [f64; 2]) -> Self {
        let mut sum = Self::rectangle([2.0 * w, length]);
        let half = 0.5 * length;
        for (sign, height) in [(-1.0, below), (1.0, above)] {
            let area = 0.5 * core::f64::consts::PI * w * height;
            let center = 4.0 * height / (3.0 * core::f64::consts::PI);
            sum.area += area;
            sum.first[1] += sign * area * (half + center);
            sum.second[0] += 0.25 * area * w * w;
            sum.second[1] += area * (half * half + 2.0 * half * center + 0.25 * height * height);
        }
        sum
    }

    /// Returns the section with its two axes exchanged.
    pub(super) const fn swapped(self) -> Self {
        let ([a, b], [c, d]) = (self.first, self.second);
        Self { area: self.area, first: [b, a], second: [d, c] }
    }
}
