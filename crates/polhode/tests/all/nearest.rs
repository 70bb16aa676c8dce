//! Nearest possible tensors, compared with a search over symmetric matrices.

use polhode::body::{InertiaTensor, nearest_possible};
use polhode::math::{Body, symmetric_eigen};

use crate::common::scenario::{M, Random, matrix, turned};

/// Returns V diag(`values`) Vᵀ for a random rotation V.
fn along_random_axes(random: &mut Random, values: [f64; 3]) -> M {
    let diagonal = core::array::from_fn(|i| core::array::from_fn(|j| if i == j { values[i] } else { 0.0 }));
    turned(&matrix(random.quaternion()), diagonal)
}

fn eigen(m: &M) -> ([f64; 3], [[f64; 3]; 3]) {
    symmetric_eigen([m[0][0], m[1][1], m[2][2], m[0][1], m[0][2], m[1][2]])
}

fn is_possible(m: &M) -> bool {
    InertiaTensor::<Body>::from_matrix(*m).is_ok()
}

fn norm(m: &M) -> f64 {
    m.iter().flatten().map(|x| x * x).sum::<f64>().sqrt()
}

fn minus(a: &M, b: &M) -> M {
    core::array::from_fn(|i| core::array::from_fn(|j| a[i][j] - b[i][j]))
}

/// Returns f(A), by its eigenvalues.
fn function(a: &M, f: fn(f64) -> f64) -> M {
    let (values, axes) = eigen(a);
    let element = |i: usize, j: usize| (0..3).map(|k| axes[k][i] * f(values[k]) * axes[k][j]).sum();
    core::array::from_fn(|i| core::array::from_fn(|j| element(i, j)))
}

fn frobenius(a: &M, b: &M) -> f64 {
    norm(&minus(a, b))
}

/// Returns ‖log(A^(−1/2) B A^(−1/2))‖, the definition; infinite if B is singular.
fn affine_invariant(a: &M, b: &M) -> f64 {
    let root = function(a, |x| 1.0 / x.sqrt());
    let product = turned(&root, *b); // the root is symmetric
    let (values, _) = eigen(&product);
    if values[0] > 0.0 { values.iter().map(|x| x.ln().powi(2)).sum::<f64>().sqrt() } else { f64::INFINITY }
}

fn log_euclidean(a: &M, b: &M) -> f64 {
    frobenius(&function(a, f64::ln), &function(b, f64::ln))
}

/// Requires that no possible tensor is nearer to `given` than `nearest`, by random symmetric
/// changes from 1e-4 to 1 of its size, and by random tensors anywhere.
fn nothing_is_nearer(random: &mut Random, given: &M, nearest: &M, metric: fn(&M, &M) -> f64) {
    let distance = metric(given, nearest);
    let (mut tried, size) = (0, norm(nearest).max(0.3 * norm(given)));
    for k in 0..8_000 {
        let other = if k % 4 == 0 {
            let moments = [0; 3].map(|_| 2.0 * norm(given) * random.between(-9.0, 0.0).exp());
            along_random_axes(random, moments)
        } else {
            let scale = size * random.between(-9.0, 0.0).exp();
            let [a, b, c] = random.vector(scale);
            let [d, e, f] = random.vector(scale);
            minus(nearest, &[[a, d, e], [d, b, f], [e, f, c]])
        };
        if is_possible(&other) {
            tried += 1;
            let theirs = metric(given, &other);
            assert!(theirs >= distance * (1.0 - 1e-12), "{given:?}: {other:?} at {theirs} < {distance}");
        }
    }
    assert!(tried > 100, "{tried}");
}

/// Moments with i1 + i2 < i3, some of them so different that F has three zeros.
const POSITIVE: [[f64; 3]; 6] = [
    [0.7, 1.1, 2.3],
    [0.031, 1.9, 2.2],
    [0.013, 0.017, 4.7],
    [0.000_13, 0.000_19, 6.1],
    [0.002, 0.9, 7.3],
    [1.3, 1.4, 2.700_1],
];

#[test]
fn no_possible_tensor_is_nearer_in_the_frobenius_norm() {
    let mut random = Random::new(71);
    let negative = [[-0.4, 1.3, 2.9], [-0.4, 1.3, 1.5], [-2.9, -1.3, 3.1], [-1.7, 1.2, 1.25]];
    for moments in POSITIVE.into_iter().chain(negative) {
        let given = along_random_axes(&mut random, moments);
        let nearest = nearest_possible(given).unwrap().frobenius;
        let tensor = nearest.tensor.matrix();
        assert!((frobenius(&given, &tensor) / nearest.distance - 1.0).abs() < 1e-10, "{nearest:?}");
        nothing_is_nearer(&mut random, &given, &tensor, frobenius);
    }
}

#[test]
fn no_possible_tensor_is_nearer_in_the_affine_invariant_metric() {
    let mut random = Random::new(72);
    for moments in POSITIVE {
        let given = along_random_axes(&mut random, moments);
        let nearest = nearest_possible(given).unwrap().affine_invariant.unwrap();
        let tensor = nearest.tensor.matrix();
        for metric in [affine_invariant, log_euclidean] {
            // A moment of 2e-5 of the largest has 1e-11 of its digits.
            assert!((metric(&given, &tensor) / nearest.distance - 1.0).abs() < 1e-9, "{nearest:?}");
            nothing_is_nearer(&mut random, &given, &tensor, metric);
        }
    }
}

#[test]
fn the_moments_are_the_best_of_a_grid() {
    // All pairs of factors e^a, e^b for the first two moments; the third is then as large as it may be.
    for moments in POSITIVE.into_iter().chain([[0.01, 0.01, 7.0], [1.0, 1.0, 3.0]]) {
        let [x, y, z] = moments.map(f64::ln);
        let diagonal = [[moments[0], 0.0, 0.0], [0.0, moments[1], 0.0], [0.0, 0.0, moments[2]]];
        let distance = nearest_possible(diagonal).unwrap().affine_invariant.unwrap().distance;
        let mut least = f64::INFINITY;
        for i in 0..=400 {
            for j in 0..=400 {
                let [a, b] = [i, j].map(|k| f64::from(k) * (z - x) / 400.0);
                let c = z - z.min(((x + a).exp() + (y + b).exp()).ln());
                least = least.min((a * a + b * b + c * c).sqrt());
            }
        }
        // The nearest point of the grid is at most half a step off in each direction; the distance
        // has no first-order change.
        assert!(least >= distance * (1.0 - 1e-12), "{moments:?}: {least} < {distance}");
        assert!(least <= distance + 0.01 * (z - x).max(0.01), "{moments:?}: {least} > {distance}");
    }
}

#[test]
fn the_conditions_of_karush_kuhn_and_tucker_hold() {
    let mut random = Random::new(73);
    for moments in POSITIVE {
        let given = along_random_axes(&mut random, moments);
        let nearest = nearest_possible(given).unwrap();
        // Frobenius: the change is a positive multiple of (1, 1, −1).
        let (to, _) = eigen(&nearest.frobenius.tensor.matrix());
        let change: [f64; 3] = core::array::from_fn(|k| to[k] - moments[k]);
        let third = (moments[2] - moments[0] - moments[1]) / 3.0;
        if moments[0] + third <= moments[1] + third && moments[1] + third <= to[2] {
            for (k, sign) in [1.0, 1.0, -1.0].into_iter().enumerate() {
                assert!((change[k] - sign * third).abs() < 1e-14 * moments[2], "{moments:?} {change:?}");
            }
        }
        // Affine-invariant: the change of the logarithms is a positive multiple of (p, q, −1).
        let (to, _) = eigen(&nearest.affine_invariant.unwrap().tensor.matrix());
        assert!((to[0] + to[1] - to[2]).abs() < 1e-14 * to[2]);
        let [a, b, c] = core::array::from_fn(|k| (to[k] / moments[k]).ln());
        assert!(c < 0.0);
        for (change, share) in [(a, to[0] / to[2]), (b, to[1] / to[2])] {
            assert!((change + c * share).abs() < 1e-9, "{moments:?}: {change} {c} {share}");
        }
    }
}

#[test]
fn a_possible_tensor_is_its_own_nearest() {
    let given = [[3.1, 0.4, -0.3], [0.4, 4.2, 0.2], [-0.3, 0.2, 5.3]];
    let nearest = nearest_possible(given).unwrap();
    assert_eq!(nearest.frobenius.tensor.matrix(), given);
    assert_eq!(nearest.affine_invariant, Some(nearest.frobenius));
    assert_eq!(nearest.frobenius.distance, 0.0);
}

#[test]
fn moments_that_are_not_positive_have_no_affine_invariant_neighbour() {
    let mut random = Random::new(74);
    let given = along_random_axes(&mut random, [-0.2, 1.3, 2.9]);
    assert_eq!(nearest_possible(given).unwrap().affine_invariant, None);
    // All negative: the nearest tensor is that of a point.
    let given = along_random_axes(&mut random, [-0.2, -1.3, -2.9]);
    let nearest = nearest_possible(given).unwrap();
    assert!(norm(&nearest.frobenius.tensor.matrix()) == 0.0 && nearest.affine_invariant.is_none());
    // A rod: i1 = 0, i2 = i3 = the mean.
    let nearest = nearest_possible([[-1.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 2.5]]).unwrap();
    assert_eq!(nearest.frobenius.tensor.matrix(), [[0.0; 3], [0.0, 2.25, 0.0], [0.0, 0.0, 2.25]]);
}

#[test]
fn scale_does_not_matter() {
    let mut random = Random::new(75);
    let given = along_random_axes(&mut random, [0.031, 1.9, 2.2]);
    let one = nearest_possible(given).unwrap();
    for power in [-1010, -500, 500, 1000] {
        let factor = 2.0_f64.powi(power);
        let scaled = nearest_possible(given.map(|row| row.map(|x| x * factor))).unwrap();
        assert_eq!(scaled.frobenius.distance, factor * one.frobenius.distance);
        let [ours, theirs] = [one, scaled].map(|n| n.affine_invariant.unwrap());
        assert_eq!(theirs.distance, ours.distance);
        assert_eq!(theirs.tensor.matrix(), ours.tensor.matrix().map(|row| row.map(|x| x * factor)));
    }
}

#[test]
fn matrices_that_are_no_tensor_are_refused() {
    let skew = [[3.0, 0.1, 0.2], [0.1, 4.0, 0.3], [-0.2, 0.3, 9.0]];
    assert!(nearest_possible(skew).unwrap_err().to_string().contains("symmetric"));
    let nan = [[f64::NAN, 0.0, 0.0], [0.0, 4.0, 0.3], [0.0, 0.3, 9.0]];
    assert!(nearest_possible(nan).unwrap_err().to_string().contains("Ixx"));
}
