//! Vectors and matrices: the identities of the lecture notes, in symbols.

use polhode_algebra::{Matrix, RationalFunction, Vector};

use crate::common::{Random, value, variables};

fn vector(components: [&str; 3]) -> Vector {
    Vector(components.map(value))
}

fn random_matrix(random: &mut Random) -> Matrix {
    let names = variables(["x", "y", "sin(alpha)"]);
    let elements: Vec<RationalFunction> = (0..9).map(|_| random.polynomial(&names, 2).into()).collect();
    Matrix::from_elements(|i, j| elements[3 * i + j].clone())
}

/// Inertia tensor of a particle: m (r² 1 − r r).
fn inertia(mass: &RationalFunction, r: &Vector) -> Matrix {
    (Matrix::identity().scaled(&r.dot(r)) - Matrix::outer(r, r)).scaled(mass)
}

#[test]
fn vector_identities_of_the_notes() {
    let (a, b) = (vector(["u", "v", "w"]), vector(["x", "y", "z"]));
    let c = vector(["omega_1", "omega_2", "omega_3"]);
    // A × (B × A) = A² B − A (A · B)
    assert_eq!(a.cross(&b.cross(&a)), b.scaled(&a.dot(&a)) - a.scaled(&a.dot(&b)));
    // (A × B)² = A² B² − (A · B)²
    let product = a.cross(&b);
    assert_eq!(product.dot(&product), a.dot(&a) * b.dot(&b) - a.dot(&b) * a.dot(&b));
    assert_eq!(a.cross(&b).dot(&c), a.dot(&b.cross(&c)));
    assert_eq!(a.cross(&b), -b.cross(&a));
    assert_eq!(a.cross(&b.cross(&c)) + b.cross(&c.cross(&a)) + c.cross(&a.cross(&b)), Vector::zero());
    let axes = [0, 1, 2].map(Vector::unit);
    assert_eq!(axes[0].cross(&axes[1]), axes[2]);
}

#[test]
fn angular_momentum_is_the_tensor_times_omega() {
    let omega = vector(["omega_1", "omega_2", "omega_3"]);
    let particles = [("m_1", ["x", "y", "z"]), ("m_2", ["u", "v", "w"]), ("M", ["a", "-b", "h/2"])];
    let (mut tensor, mut momentum) = (Matrix::zero(), Vector::zero());
    let mut energy = RationalFunction::zero();
    for (mass, r) in particles {
        let (mass, r) = (value(mass), vector(r));
        let velocity = omega.cross(&r);
        tensor = tensor + inertia(&mass, &r);
        momentum = momentum + r.cross(&velocity).scaled(&mass);
        energy = energy + velocity.dot(&velocity) * &mass;
    }
    assert!(tensor.is_symmetric());
    assert_eq!(momentum, tensor.times_vector(&omega));
    // 2 T = ω · L
    assert_eq!(energy, omega.dot(&momentum));
}

#[test]
fn parallel_axes() {
    let (mass, other) = (value("m_1"), value("m_2"));
    let (r, s) = (vector(["x", "y", "z"]), vector(["u", "v", "w"]));
    let total = &mass + &other;
    let center = (r.scaled(&mass) + s.scaled(&other)).map(|c| c.over(&total).unwrap());
    let about = |point: &Vector| inertia(&mass, &(&r - point)) + inertia(&other, &(&s - point));
    // I about the origin = I about the centre of mass + M (R² 1 − R R)
    assert_eq!(about(&Vector::zero()), about(&center) + inertia(&total, &center));
    assert_ne!(about(&Vector::zero()), about(&center));
}

#[test]
fn matrices_by_their_definitions() {
    let mut random = Random(31);
    for _ in 0..4 {
        let [a, b] = [0; 2].map(|_| random_matrix(&mut random));
        let v = vector(["x", "1", "cos(alpha)"]);
        assert_eq!((&a * &b).times_vector(&v), a.times_vector(&b.times_vector(&v)));
        assert_eq!((&a * &b).transposed(), b.transposed() * a.transposed());
        assert_eq!((&a * &b).determinant(), a.determinant() * b.determinant());
        assert_eq!((&a * &b).trace(), (&b * &a).trace());
        // Leibniz: the sum over all permutations.
        let e = |i: usize, j: usize, k: usize| &a.0[0][i] * &a.0[1][j] * &a.0[2][k];
        let leibniz = e(0, 1, 2) + e(1, 2, 0) + e(2, 0, 1) - e(0, 2, 1) - e(1, 0, 2) - e(2, 1, 0);
        assert_eq!(a.determinant(), leibniz);
        // det(λ − A), and Cayley–Hamilton.
        let lambda = value("lambda");
        let polynomial = a.characteristic_polynomial();
        let shifted = Matrix::identity().scaled(&lambda) - &a;
        assert_eq!(polynomial.at(&lambda), shifted.determinant());
        let powers = [Matrix::identity(), a.clone(), &a * &a, &a * &a * &a];
        let terms = powers.iter().zip(polynomial.coefficients()).map(|(power, c)| power.scaled(c));
        assert_eq!(terms.fold(Matrix::zero(), |sum, term| sum + term), Matrix::zero());
    }
}

#[test]
fn inverses() {
    let rows = [["a", "x", "0"], ["x", "b", "1"], ["2", "1/y", "cos(alpha)"]];
    let matrix = Matrix(rows.map(|row| row.map(value)));
    let inverse = matrix.inverse().unwrap();
    assert_eq!(&matrix * &inverse, Matrix::identity());
    assert_eq!(inverse * &matrix, Matrix::identity());
    let r = vector(["x", "y", "z"]);
    assert_eq!(Matrix::outer(&r, &r).inverse(), None);
}

#[test]
fn rotations_keep_the_invariants() {
    let rows = [["cos(alpha)", "-sin(alpha)", "0"], ["sin(alpha)", "cos(alpha)", "0"], ["0", "0", "1"]];
    let turn = Matrix(rows.map(|row| row.map(value)));
    assert_eq!(&turn * turn.transposed(), Matrix::identity());
    assert_eq!(turn.determinant(), RationalFunction::one());
    let tensor = inertia(&value("M"), &vector(["x", "y", "z"]));
    let turned = &turn * &tensor * turn.transposed();
    assert_eq!(turned.characteristic_polynomial(), tensor.characteristic_polynomial());
}

#[test]
fn primitive_vectors_and_common_factors() {
    for (given, expected) in [
        (["1/3", "1/3", "1/3"], ["1", "1", "1"]),
        (["0", "-2*x", "4*x*y"], ["0", "1", "-2*y"]),
        (["a/b", "a/h", "0"], ["h", "b", "0"]),
        (["-1/2", "3/4", "5"], ["2", "-3", "-20"]),
        (["0", "0", "0"], ["0", "0", "0"]),
    ] {
        assert_eq!(vector(given).primitive(), vector(expected));
    }
    let matrix = Matrix::from_elements(|i, j| value(if i == j { "2/3*M*b^2" } else { "-M*b^2/4" }));
    let (factor, rest) = matrix.factored();
    assert_eq!((factor.clone(), rest.0[0][1].clone()), (value("M*b^2"), value("-1/4")));
    assert_eq!(rest.scaled(&factor), matrix);
    assert_eq!(Matrix::zero().factored(), (RationalFunction::one(), Matrix::zero()));
}
