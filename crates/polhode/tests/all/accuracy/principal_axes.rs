//! Principal moments and axes of random tensors: reconstruction of the tensor, and reproducibility.

use polhode::prelude::*;

use crate::accuracy::exact::Pair;
use crate::accuracy::random::Random;

/// Bound on the errors of R diag Rᵀ, relative to the largest element of the tensor, and of R Rᵀ.
pub(crate) const PROMISED: f64 = 1e-15;

/// Number of tensors in each group.
pub(crate) const TENSORS: usize = 250_000;

/// Group of tensors: its name, and the mean squares of the body's points along its principal axes,
/// ∫x² dm etc.
pub(crate) type Group = (&'static str, fn(&mut Random) -> [f64; 3]);

pub(crate) const GROUPS: [Group; 4] = [
    ("generic", |random| std::array::from_fn(|_| random.between(0.01, 1.0))),
    ("moments equal to 1e-16 … 1e-14", |random| {
        let a = random.between(0.01, 1.0);
        let gap = |random: &mut Random| 1.0 + decade(random, -16.0, -14.0);
        // two moments nearly equal, or all three
        let c = if random.next() < 0.7 { random.between(0.01, 1.0) } else { a * gap(random) };
        [a, a * gap(random), c]
    }),
    ("moments spread over 16 decades", |random| {
        [1.0, decade(random, -16.0, 0.0), decade(random, -16.0, 0.0)]
    }),
    ("triaxial, near a flat plate", |random| {
        [random.between(0.1, 1.0), random.between(0.1, 1.0), decade(random, -16.0, -3.0)]
    }),
];

fn decade(random: &mut Random, low: f64, high: f64) -> f64 {
    libm::exp10(random.between(low, high))
}

/// Largest errors of a group.
#[derive(Clone, Copy, Default)]
pub(crate) struct Worst {
    /// Error of R diag Rᵀ, relative to the largest element of the tensor.
    pub(crate) rebuilt: f64,
    /// Error of R Rᵀ.
    pub(crate) orthonormal: f64,
}

/// Returns a tensor of the group, rotated at random and rounded.
fn tensor(squares: fn(&mut Random) -> [f64; 3], random: &mut Random) -> InertiaTensor<Body> {
    let [a, b, c] = squares(random);
    let q = loop {
        let q: [f64; 4] = std::array::from_fn(|_| random.between(-1.0, 1.0));
        if (0.01..1.0).contains(&q.iter().map(|c| c * c).sum::<f64>()) {
            break q;
        }
    };
    let r = Rotation::<Body, Principal>::from_quaternion(q).unwrap().matrix();
    let moments = [b + c, a + c, a + b];
    let element = |i: usize, j: usize| (0..3).map(|k| r[i][k] * moments[k] * r[j][k]).sum();
    InertiaTensor::with_negative_products(
        [element(0, 0), element(1, 1), element(2, 2)],
        [element(0, 1), element(0, 2), element(1, 2)],
    )
    .unwrap()
}

/// Returns the errors of one result, whose numbers are taken as exact. All products are computed to
/// 32 digits.
fn errors(tensor: &InertiaTensor<Body>, frame: &PrincipalFrame<Body>) -> Worst {
    let axes = frame.axes().map(|axis| axis.to_array().map(Pair::of));
    let moments = frame.moments().map(Pair::of);
    let given = tensor.matrix();
    let scale = given.iter().flatten().fold(0.0, |most: f64, e| most.max(e.abs()));
    let mut worst = Worst::default();
    for (i, j) in [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)] {
        // `(R diag Rᵀ)_ij = Σ_k i_k a_k,i a_k,j`
        let rebuilt =
            (0..3).fold(Pair::of(-given[i][j]), |sum, k| sum + moments[k] * axes[k][i] * axes[k][j]);
        let unit = if i == j { 1.0 } else { 0.0 };
        let dot = (0..3).fold(Pair::of(-unit), |sum, k| sum + axes[i][k] * axes[j][k]);
        worst.rebuilt = worst.rebuilt.max(rebuilt.value().abs() / scale);
        worst.orthonormal = worst.orthonormal.max(dot.value().abs());
    }
    let [a, b, c] = frame.axes();
    assert!(a.cross(b).dot(c) > 0.0, "left-handed: {frame:?}");
    worst
}

/// Returns a hash of all bits of a result.
fn bits(frame: &PrincipalFrame<Body>) -> u64 {
    let axes = frame.axes().map(Vector::to_array);
    let words = frame.moments().into_iter().chain(axes.into_iter().flatten()).map(f64::to_bits);
    words.fold(0, |mixed: u64, word| (mixed.rotate_left(9) ^ word).wrapping_mul(0x9e37_79b9_7f4a_7c15))
}

pub(crate) fn measured() -> [Worst; GROUPS.len()] {
    let mut seed = 1;
    GROUPS.map(|(name, squares)| {
        seed += 1;
        let mut random = Random(seed);
        let tensors: Vec<_> = (0..TENSORS).map(|_| tensor(squares, &mut random)).collect();
        let mut worst = Worst::default();
        let mut once = Vec::with_capacity(TENSORS);
        for tensor in &tensors {
            let frame = PrincipalFrame::of(tensor);
            let Worst { rebuilt, orthonormal } = errors(tensor, &frame);
            worst.rebuilt = worst.rebuilt.max(rebuilt);
            worst.orthonormal = worst.orthonormal.max(orthonormal);
            once.push(bits(&frame));
        }
        // repeated, on three threads
        let again = |part: &[InertiaTensor<Body>]| {
            part.iter().map(|t| bits(&PrincipalFrame::of(t))).collect::<Vec<_>>()
        };
        let again: Vec<u64> = std::thread::scope(|scope| {
            let parts: Vec<_> =
                tensors.chunks(TENSORS / 3 + 1).map(|part| scope.spawn(move || again(part))).collect();
            parts.into_iter().flat_map(|part| part.join().unwrap()).collect()
        });
        assert!(once == again, "{name}: not the same bits again");
        worst
    })
}
