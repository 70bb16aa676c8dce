//! Volume and moments of a region, which add and subtract.

use super::Solid;

/// Integrals over a region about a reference point: V = ∫dV, f = ∫x dV, S = ∫x xᵀ dV.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct RegionMoments {
    pub(super) volume: f64,
    first: [f64; 3],
    second: [[f64; 3]; 3],
}

impl RegionMoments {
    /// Returns the integrals of a solid: S = ½ tr(I) 1 − I + V d dᵀ, d = c − reference.
    pub(super) fn of(solid: &Solid, reference: [f64; 3]) -> Self {
        let d = [0, 1, 2].map(|k| solid.centroid[k] - reference[k]);
        let half = 0.5 * trace(&solid.tensor);
        let second = |i: usize, j: usize| {
            let own = if i == j { half } else { 0.0 } - solid.tensor[i][j];
            own + solid.volume * d[i] * d[j]
        };
        Self {
            volume: solid.volume,
            first: d.map(|c| solid.volume * c),
            second: [0, 1, 2].map(|i| [0, 1, 2].map(|j| second(i, j))),
        }
    }

    /// Returns the solid with these integrals.
    pub(super) fn solid(&self, reference: [f64; 3]) -> Solid {
        let d = self.first.map(|c| c / self.volume);
        let about = |i: usize, j: usize| self.second[i][j] - self.volume * d[i] * d[j];
        let sum = about(0, 0) + about(1, 1) + about(2, 2);
        let element = |i: usize, j: usize| if i == j { sum } else { 0.0 } - about(i, j);
        Solid {
            volume: self.volume,
            centroid: [0, 1, 2].map(|k| reference[k] + d[k]),
            tensor: [0, 1, 2].map(|i| [0, 1, 2].map(|j| element(i, j))),
        }
    }

    /// Returns this region and `factor` times another one.
    #[must_use]
    pub(super) fn plus(&self, factor: f64, other: &Self) -> Self {
        Self {
            volume: self.volume + factor * other.volume,
            first: [0, 1, 2].map(|k| self.first[k] + factor * other.first[k]),
            second: [0, 1, 2].map(|i| [0, 1, 2].map(|j| self.second[i][j] + factor * other.second[i][j])),
        }
    }

    /// Returns ∫|x|² dV.
    pub(super) fn spread(&self) -> f64 {
        trace(&self.second)
    }
}

fn trace(matrix: &[[f64; 3]; 3]) -> f64 {
    matrix[0][0] + matrix[1][1] + matrix[2][2]
}
