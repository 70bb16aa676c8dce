//! Rattlebacks: bodies that prefer one sense of turning.

use super::vertex::VertexSpin;

/// A body that rolls on a point below its centre of mass and whose principal axes are not those of its surface: spin in one sense makes one of its two swings grow and the
/// other die away, and in the other sense the other way round.
///
/// With the swings u_k of a body at rest, m g G u = ϖ² M u, the symmetric part of what is proportional to the spin in [`VertexSpin`] changes their
/// rates of growth by
///
/// σ_k = ½ m h Ω (u · J G′ u)/(u · M u) + O(Ω³),
///
/// of both signs, as tr J G′ = 0: the swing that grows is the pitching (ϖ smaller or greater) in one sense and the rolling in the other. Above a threshold of |Ω| both die
/// away in the stable sense.
///
/// Source: A. Garcia, M. Hubbard, Proc. R. Soc. A 418 (1988) 165; Y. Kondo, H. Nakanishi, Phys. Rev. E 95 (2017) 062207, whose two regimes these are; derived here as above.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Rattleback {
    /// 1 if spin against the clock, seen from above, is the stable sense, else −1.
    pub stable_sense: f64,
    /// The spin beyond which the stable sense is stable, rad/s; `None` if no spin is.
    pub threshold: Option<f64>,
    /// The spin up to which it is stable then, rad/s; `None` if there is no bound.
    pub until: Option<f64>,
    /// The swings at rest, the slower one first; empty of a body that falls over.
    pub modes: Vec<RattleMode>,
}

/// A swing of a rattleback.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct RattleMode {
    /// ϖ, rad/s
    pub frequency: f64,
    /// σ/Ω at small spin: a pure number.
    pub growth_per_spin: f64,
}

impl VertexSpin {
    /// What makes its two senses of turning different, if it rolls and its axes are not those of the surface.
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
    // det (g G − λ M) = 0
    let (a, b, c) = (m * o - n * n, m * s + o * p - 2.0 * n * q, p * s - q * q);
    let root = (b * b - 4.0 * a * c).max(0.0).sqrt();
    let greater = (b + root) / (2.0 * a);
    if !(c > 0.0 && b > 0.0) {
        return Vec::new();
    }
    let [across, along] = spin.uneven();
    let mode = |lambda: f64| {
        // u is across the longer row of G − λ M.
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
