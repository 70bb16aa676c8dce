//! Amplified rounding: perturbations that comparison runs add to the state after each step.

/// Random numbers with mean 0 and variance 1, from a seed; identical on every machine.
#[derive(Clone, Debug)]
pub(crate) struct Random(u64);

impl Random {
    pub(crate) const fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// Returns a number, uniform between −√3 and √3.
    pub(crate) fn next(&mut self) -> f64 {
        // SplitMix64: G. L. Steele, D. Lea, C. H. Flood, OOPSLA 2014.
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        let unit = ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64;
        12_f64.sqrt() * (unit - 0.5)
    }
}

/// Perturbation of a run, for measuring the effect of rounding.
#[derive(Clone, Copy, Debug)]
pub(crate) struct StepNoise {
    pub(crate) seed: u64,
    /// Perturbation of each variable after a step, relative to the rounding of that step.
    pub(crate) amplitude: f64,
    /// Factor of the step length.
    pub(crate) stretch: f64,
}

/// Generator of perturbations: rounding of a step, times an amplitude.
///
/// Each component is perturbed in proportion to its own size. A component that is exactly zero
/// because of a symmetry therefore stays zero in the perturbed run.
#[derive(Clone, Debug)]
pub(crate) struct Noise {
    random: Random,
    amplitude: f64,
}

impl Noise {
    pub(crate) const fn new(seed: u64, amplitude: f64) -> Self {
        Self { random: Random::new(seed), amplitude }
    }

    /// Returns the perturbation, a rotation vector, of a rotation by h ω, where ω is the mean of
    /// the values before and after a step.
    pub(super) fn turn(&mut self, h: f64, before: [f64; 3], after: [f64; 3]) -> [f64; 3] {
        let h = 0.5 * h * f64::EPSILON * self.amplitude;
        core::array::from_fn(|k| h * (before[k].abs() + after[k].abs()) * self.random.next())
    }

    /// Returns the perturbation of ω, or of L, after a step, component by component.
    pub(super) fn rate(&mut self, before: [f64; 3], after: [f64; 3]) -> [f64; 3] {
        let scale = 0.5 * f64::EPSILON * self.amplitude;
        core::array::from_fn(|k| scale * (before[k].abs() + after[k].abs()) * self.random.next())
    }
}
