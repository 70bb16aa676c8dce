//! Rattlebacks: bodies that prefer one sense of rotation.

use super::vertex::VertexSpin;

/// Body that rolls on a point below its centre of mass and whose principal axes are not those of
/// its surface. Spin in one sense makes one of its two oscillation modes grow and the other decay;
/// spin in the opposite sense does the reverse.
///
/// The modes `u_k` of the body without spin satisfy m g G u = ϖ² M u. The symmetric part of the
/// terms proportional to the spin in [`VertexSpin`] changes the growth rates by
///
/// σ_k = ½ m h Ω (u · J G′ u)/(u · M u) + O(Ω³),
///
/// with opposite signs, because tr J G′ = 0. In one sense the pitching mode grows (one of the two
/// frequencies ϖ), in the other sense the rolling mode. Above a threshold of |Ω| both decay in the
/// stable sense.
///
/// Source: A. Garcia, M. Hubbard, Proc. R. Soc. A 418 (1988) 165; Y. Kondo, H. Nakanishi, Phys.
/// Rev. E 95 (2017) 062207, which defines the two regimes; derived here as above.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Rattleback {
    /// Stable sense: 1 if counter-clockwise spin, seen from above, is stable, else −1.
    pub stable_sense: f64,
    /// Spin above which the stable sense is stable, rad/s; `None` if no spin is stable.
    pub threshold: Option<f64>,
    /// Upper bound of the stable spins, rad/s; `None` if unbounded.
    pub until: Option<f64>,
    /// Oscillation modes without spin, the slower one first; empty for a body that falls over.
    pub modes: Vec<RattleMode>,
}

/// Oscillation mode of a rattleback.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct RattleMode {
    /// Frequency ϖ, rad/s.
    pub frequency: f64,
    /// Growth rate per spin σ/Ω at small spin, dimensionless.
    pub growth_per_spin: f64,
}

impl VertexSpin {
    /// Returns the rattleback properties, if the body rolls and its principal axes are not those of
    /// the surface.
    pub fn rattleback(&self) -> Option<Rattleback> {
        (self.chirality() != 0.0).then(|| Rattleback::of(self))
    }
}

impl Rattleback {
    fn of(spin: &VertexSpin) -> Self {
        let stable_sense = if spin.chirality() > 0.0 { -1.0 } else { 1.0 };
        let intervals = spin.stable_spins().map_or_else(Vec::new, |stable| stable.intervals);
        let outermost = if stable_sense > 0.0 { intervals.last() } else { intervals.first() };
        let threshold = outermost.map(|[from, to]| from.abs().min(to.abs()));
        let until = outermost.map(|[from, to]| from.abs().max(to.abs())).filter(|until| until.is_finite());
        let mut modes = modes(spin);
        modes.sort_by(|a, b| a.frequency.total_cmp(&b.frequency));
        Self { stable_sense, threshold, until, modes }
    }
}

fn modes(spin: &VertexSpin) -> Vec<RattleMode> {
    let ([[m, n], [_, o]], [[p, q], [_, s]]) = (spin.inertia(), spin.lever());
    // Solves det (g G − λ M) = 0.
    let (a, b, c) = (m * o - n * n, m * s + o * p - 2.0 * n * q, p * s - q * q);
    let root = (b * b - 4.0 * a * c).max(0.0).sqrt();
    let greater = (b + root) / (2.0 * a);
    if !(c > 0.0 && b > 0.0) {
        return Vec::new();
    }
    let [across, along] = spin.uneven();
    let mode = |lambda: f64| {
        // u is perpendicular to the longer row of G − λ M.
        let rows = [[p - lambda * m, q - lambda * n], [q - lambda * n, s - lambda * o]];
        let length = |[x, y]: [f64; 2]| x.hypot(y);
        let [x, y] = if length(rows[0]) > length(rows[1]) { rows[0] } else { rows[1] };
        let u = [-y, x];
        let moved = m * u[0] * u[0] + 2.0 * n * u[0] * u[1] + o * u[1] * u[1];
        let twisted = along * (u[1] * u[1] - u[0] * u[0]) + 2.0 * across * u[0] * u[1];
        RattleMode {
            frequency: (lambda * spin.mass * spin.gravity).sqrt(),
            growth_per_spin: 0.5 * spin.mass * spin.height * twisted / moved,
        }
    };
    vec![mode(greater), mode(c / (a * greater))]
}
