//! Errors compared with the truth, over many seeds.

use core::cell::OnceCell;

use nalgebra::{DMatrix, DVector};
use polhode::math::{Direction, Position, Rotation};

use super::motions::TRUTH;
use crate::ResidualTest;
use crate::decomposition::lu;
use crate::swing::course::{self, Clock, Course, Decay};
use crate::swing::family::{Amplitudes, Family};
use crate::swing::number::Numbers;
use crate::swing::*;

/// Generator of normal deviates.
pub(super) struct Noise(u64, f64);

impl Noise {
    pub(super) fn new(seed: u64, sign: f64) -> Self {
        Self(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) ^ 0xD1B5_4A32_D192_ED03, sign)
    }

    fn uniform(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub(super) fn normal(&mut self) -> f64 {
        let (u, v) = (1.0 - self.uniform(), self.uniform());
        self.1 * (-2.0 * u.ln()).sqrt() * (core::f64::consts::TAU * v).cos()
    }
}

/// Body, fixture and rig of a test.
type Hung = (Option<Placement>, Option<Fixture>, Rig);

/// Plan without the measured values of its numbers.
pub(super) struct Setup {
    pub(super) names: Vec<(&'static str, f64, f64)>,
    pub(super) tests: fn(&[NumberId]) -> Vec<Hung>,
    pub(super) periods: f64,
    pub(super) decay: Decay,
    pub(super) time_sd: f64,
    pub(super) amplitude_sd: f64,
    pub(super) mass_sd: f64,
    pub(super) center_sd: f64,
    /// True end of each test, computed once for many plans.
    pub(super) ends: OnceCell<Vec<course::Point>>,
}

impl Setup {
    pub(super) fn truth(&self) -> Vec<f64> {
        TRUTH.iter().copied().chain(self.names.iter().map(|(_, value, _)| *value)).collect()
    }

    /// Returns a plan with noisy values; without noise, the truth with its standard deviations.
    pub(super) fn plan(&self, noise: &mut impl FnMut() -> f64) -> SwingPlan {
        let mut measured = |value: f64, sd: f64| {
            let error = if sd.is_finite() { sd * noise() } else { 0.0 };
            Measured::new(value + error, sd)
        };
        let mass = measured(TRUTH[0], self.mass_sd);
        let center = [1, 2, 3].map(|k| measured(TRUTH[k], self.center_sd));
        let mut plan = SwingPlan::new(mass, center);
        let ids: Vec<NumberId> = self
            .names
            .iter()
            .map(|(name, value, sd)| plan.number(*name, "m", measured(*value, *sd)))
            .collect();
        let unmeasured = Measurement::Counted(Counted::new(1.0, (1.0, 1.0), [1.0, 1.0], 1.0));
        let tests = (self.tests)(&ids).into_iter().enumerate().map(|(k, (body, fixture, rig))| {
            let (name, measurement) = (format!("test {k}"), unmeasured.clone());
            SwingTest { name, body, fixture, rig, air: Air::default(), measurement }
        });
        let tests: Vec<_> = tests.collect();
        let ends = self.ends.get_or_init(|| tests.iter().map(|test| self.end(test)).collect());
        for (mut test, last) in tests.into_iter().zip(ends) {
            let time = last.other + self.time_sd * noise();
            let first = self.decay.amplitude + self.amplitude_sd * noise();
            let fallen = last.amplitude + self.amplitude_sd * noise();
            test.measurement = Measurement::Counted(Counted::new(
                self.periods,
                (time, self.time_sd),
                [first, fallen],
                self.amplitude_sd,
            ));
            plan.add(test);
        }
        plan
    }

    fn end(&self, test: &SwingTest) -> course::Point {
        let values = self.truth();
        let places: Vec<_> = (0..values.len()).map(Some).collect();
        let oscillator = test.oscillator(&Numbers::new(&values, &places)).unwrap();
        let amplitudes = Amplitudes::up_to(1.1 * self.decay.amplitude);
        let (family, _) = Family::new(oscillator.as_ref(), &amplitudes, &[]).unwrap();
        let end = core::f64::consts::TAU * self.periods;
        Course::new(&family, self.decay, Clock::Phase, end).unwrap().at(end)
    }
}

/// Statistics over many seeds.
#[derive(Debug)]
pub(super) struct Outcome {
    pub(super) bias: f64,
    pub(super) spread: f64,
    pub(super) nees: f64,
    pub(super) sds: f64,
    /// Mean and standard deviation of [`ResidualTest::excess`].
    pub(super) excess: [f64; 2],
}

/// Returns the statistics: bias in standard deviations, root mean square error relative to the
/// bound, mean normalized squared error, and largest relative deviation of a standard deviation
/// from the bound.
pub(super) fn outcome(setup: &Setup, seeds: u64) -> Outcome {
    let truth = setup.truth();
    let bound = identify_swings(&setup.plan(&mut || 0.0)).unwrap();
    assert!(bound.estimate.unknown.is_empty(), "{:?}", bound.estimate);
    let found: Vec<usize> =
        (0..truth.len()).filter(|&k| bound.estimate.numbers[k].sd.unwrap() > 0.0).collect();
    let n = found.len();
    for &k in &found {
        let number = &bound.estimate.numbers[k];
        assert!((number.value - truth[k]).abs() < 1e-4 * number.sd.unwrap(), "{number:?} {}", truth[k]);
    }
    let mut sum = vec![0.0; n];
    let (mut squares, mut nees, mut sds) = (0.0, 0.0, 0.0_f64);
    let mut excess = Vec::new();
    let signs = (0..seeds).map(|seed| (seed, 1.0)).chain((0..PAIRS).map(|seed| (seed, -1.0)));
    for (seed, sign) in signs {
        let mut noise = Noise::new(seed, sign);
        let result = identify_swings(&setup.plan(&mut || noise.normal())).unwrap();
        assert_eq!(result.widening, 1.0, "{:?}", result.counted);
        let error = DVector::from_fn(n, |i, _| result.estimate.numbers[found[i]].value - truth[found[i]]);
        let covariance = DMatrix::from_fn(n, n, |i, j| result.estimate.covariance[found[i]][found[j]]);
        let bounds = found.iter().map(|&k| bound.estimate.numbers[k].sd.unwrap());
        let bounds = DVector::from_iterator(n, bounds);
        let relative = error.component_div(&bounds);
        if seed < PAIRS {
            (0..n).for_each(|i| sum[i] += relative[i]);
        }
        if sign > 0.0 {
            excess.extend(result.counted.as_ref().map(ResidualTest::excess));
            // Scaled, because kg·m² and m differ by orders of magnitude.
            let sd = DVector::from_fn(n, |i, _| covariance[(i, i)].sqrt());
            let scaled = DMatrix::from_fn(n, n, |i, j| covariance[(i, j)] / (sd[i] * sd[j]));
            let z = error.component_div(&sd);
            nees += z.dot(&lu("a test matrix", scaled).unwrap().solve(&z).unwrap()) / n as f64;
            squares += relative.norm_squared() / n as f64;
            sds = (0..n).fold(sds, |most, i| most.max((sd[i] / bounds[i] - 1.0).abs()));
        }
    }
    let count = seeds as f64;
    let mean = excess.iter().sum::<f64>() / count;
    let deviation = (excess.iter().map(|z| (z - mean).powi(2)).sum::<f64>() / count).sqrt();
    Outcome {
        excess: [mean, deviation],
        bias: sum.iter().fold(0.0, |most: f64, s| most.max((s / (2 * PAIRS) as f64).abs())),
        spread: (squares / count).sqrt(),
        nees: nees / count,
        sds,
    }
}

/// Number of seeds whose noise is also used with the opposite sign. The mean of both errors is
/// bias, not chance.
const PAIRS: u64 = 12;

/// Returns nine pendulums about generic axes, on an edge. One shared number determines the distance
/// of their pivots.
pub(super) fn pendulums() -> Setup {
    Setup {
        names: vec![("reach", 0.25, 2e-4), ("edge", 1.5e-3, 1e-4)],
        tests: |ids| {
            let axes = [
                [1.0, 0.1, 0.2],
                [0.1, 1.0, -0.2],
                [-0.15, 0.2, 1.0],
                [0.7, 0.7, 0.1],
                [0.1, 0.6, 0.8],
                [0.8, -0.1, 0.6],
                [0.7, -0.7, 0.2],
                [0.2, -0.7, 0.6],
                [-0.6, 0.1, 0.7],
            ];
            axes.into_iter()
                .enumerate()
                .map(|(k, axis)| {
                    let n = Direction::from_array(axis);
                    let unit = n.direction().unwrap();
                    let seed = [[0.3, 0.2, 1.0], [1.0, -0.3, 0.4], [0.2, 1.0, -0.5]][k % 3];
                    let across = unit.cross(Direction::from_array(seed)).direction().unwrap();
                    let point = Point::from([0.01, 0.0, -0.02]).shifted(ids[0], across.to_array());
                    (Some(Placement::AS_IT_IS), None, Rig::Axis(Axis::level(point, n).with_edge(ids[1])))
                })
                .collect()
        },
        periods: 60.0,
        decay: Decay { amplitude: 0.5, viscous: 1.5e-3, quadratic: 0.0 },
        time_sd: 0.01,
        amplitude_sd: 0.004,
        mass_sd: 2e-3,
        center_sd: 2e-4,
        ends: OnceCell::new(),
    }
}

/// Returns seven placements on a platform on three wires, and the platform alone.
pub(super) fn platform() -> Setup {
    Setup {
        names: vec![("radius", 0.2, 3e-4), ("length", 1.1, 5e-4), ("platform", 0.011, f64::INFINITY)],
        tests: |ids| {
            let rig = Rig::Wires(Wires::trifilar(ids[0], ids[0], ids[1]));
            let fixture = Fixture {
                mass: 0.9.into(),
                center: Point::default(),
                inertia: [0.006.into(), 0.006.into(), ids[2].into(), 0.0.into(), 0.0.into(), 0.0.into()],
            };
            let mut all = vec![(None, Some(fixture.clone()), rig.clone())];
            for axis in [
                [1.0, 0.1, 0.2],
                [0.1, 1.0, -0.2],
                [-0.15, 0.2, 1.0],
                [0.7, 0.7, 0.1],
                [0.1, 0.6, 0.8],
                [0.8, -0.1, 0.6],
                [0.7, -0.7, 0.2],
            ] {
                // Rotated so that this axis of the body is vertical.
                let n = Direction::<polhode::math::Space>::from_array(axis).direction().unwrap();
                let z = Direction::new(0.0, 0.0, 1.0);
                let rotation = Rotation::from_axis_angle(n.cross(z), n.angle_to(z)).unwrap();
                let placement = Placement { rotation, origin: Position::new(0.011, -0.007, 0.08) };
                all.push((Some(placement), Some(fixture.clone()), rig.clone()));
            }
            all
        },
        periods: 40.0,
        decay: Decay { amplitude: 0.2, viscous: 1e-3, quadratic: 0.0 },
        time_sd: 0.02,
        amplitude_sd: 0.004,
        mass_sd: 1e-3,
        center_sd: 3e-4,
        ends: OnceCell::new(),
    }
}

#[test]
fn errors_of_pendulums_are_what_they_are_said_to_be() {
    let outcome = outcome(&pendulums(), 80);
    assert!(outcome.bias < 0.15, "{outcome:?}");
    assert!((outcome.spread - 1.0).abs() < 0.1 && outcome.sds < 0.1, "{outcome:?}");
    assert!((outcome.nees - 1.0).abs() < 0.1, "{outcome:?}");
    let [mean, deviation] = outcome.excess;
    assert!(mean.abs() < 0.25 && (0.8..1.2).contains(&deviation), "{outcome:?}");
}

#[test]
fn errors_of_a_platform_are_what_they_are_said_to_be() {
    let outcome = outcome(&platform(), 60);
    assert!(outcome.bias < 0.15, "{outcome:?}");
    assert!((outcome.spread - 1.0).abs() < 0.1 && outcome.sds < 0.1, "{outcome:?}");
    assert!((outcome.nees - 1.0).abs() < 0.1, "{outcome:?}");
}
