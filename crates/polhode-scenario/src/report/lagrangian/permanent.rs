//! Permanent rotations of a free asymmetric body, and small deviations from them.

use polhode_algebra::{Formula, Kind, RationalFunction, Symbol, Univariate};
use polhode_document::Section;

use super::system::{System, at_angle};
use super::write::put;

/// Writes the permanent rotations about axes 2 and 1 of a free body, and small deviations from them.
pub(super) fn permanent(
    system: &System,
    [_, theta, psi]: [Symbol; 3],
    moments: &[RationalFunction; 3],
    s: &mut Section,
) -> Option<()> {
    let h = system.hamiltonian()?;
    let [p_phi, p_theta, p_psi] = [0, 1, 2].map(|k| system.coordinates[k].momentum);
    let variables = [theta, psi, p_theta, p_psi];
    s.say("A rotation about a principal axis at the constant rate ω is steady. With the polar axis along it θ = 90°, and ψ = 0 for axis 2, ψ = 90° for axis 1. Small deviations of θ, ψ, p_θ and p_ψ follow the linearized canonical equations at p_φ = I ω. They grow or oscillate as exp(λ t), with:");
    let mut symbols = system.symbols.clone();
    let omega = RationalFunction::from(symbols.declare("omega", Kind::Constant).ok()?);
    for (axis, angle) in [(1, [0, 1]), (0, [1, 0])] {
        let steady = |f: &RationalFunction| {
            let f = at_angle(&at_angle(f, theta, [1, 0])?, psi, angle)?;
            let f = f
                .substituted(p_theta, &RationalFunction::zero())?
                .substituted(p_psi, &RationalFunction::zero())?;
            f.substituted(p_phi, &moments[axis].times(&omega))
        };
        // d/dt (θ, ψ, p_θ, p_ψ) = J ∇H
        let mut matrix = Vec::new();
        for row in [p_theta, p_psi, theta, psi] {
            let sign =
                if row == theta || row == psi { -RationalFunction::one() } else { RationalFunction::one() };
            let slope = h.function.derivative(row) * sign;
            if !steady(&slope)?.is_zero() {
                return None;
            }
            matrix.push(variables.iter().map(|&v| steady(&slope.derivative(v))).collect::<Option<Vec<_>>>()?);
        }
        let squares = Univariate::new(even_characteristic(&matrix)?).roots().rational;
        let square =
            |root: &RationalFunction| Formula::named("lambda").squared().equals(root.to_formula(&symbols));
        s.say(format!("About axis {}:", axis + 1));
        put(s, &Formula::List(squares.iter().map(|(root, _)| square(root)).collect()));
    }
    s.say("λ² = −ω² only means that L is not along the polar axis. The other one is negative for the axes of the least and the greatest moment, whose rotations are stable. It is positive for the intermediate axis: that rotation is unstable.");
    Some(())
}

/// Returns c₀, c₁ and 1 of the characteristic polynomial c₀ + c₁ λ² + λ⁴ of a matrix of order 4, by
/// the method of Faddeev and LeVerrier; `None` if it has odd powers of λ.
fn even_characteristic(matrix: &[Vec<RationalFunction>]) -> Option<Vec<RationalFunction>> {
    let zero = RationalFunction::zero;
    let product = |a: &[Vec<RationalFunction>], b: &[Vec<RationalFunction>]| -> Vec<Vec<RationalFunction>> {
        let element = |i: usize, j: usize| (0..4).fold(zero(), |sum, k| sum + &a[i][k] * &b[k][j]);
        (0..4).map(|i| (0..4).map(|j| element(i, j)).collect()).collect()
    };
    let mut coefficients = vec![RationalFunction::one()];
    let mut power: Vec<Vec<_>> =
        (0..4).map(|i| (0..4).map(|j| RationalFunction::from(i64::from(i == j))).collect()).collect();
    for k in 1..=4_i64 {
        power = product(matrix, &power);
        let trace = (0..4).fold(zero(), |sum, i| sum + &power[i][i]);
        let c = -trace.over(&RationalFunction::from(k))?;
        for (i, row) in power.iter_mut().enumerate() {
            row[i] = &row[i] + &c;
        }
        coefficients.push(c);
    }
    let [first, odd, second, third, last] = <[_; 5]>::try_from(coefficients).ok()?;
    (odd.is_zero() && third.is_zero()).then(|| vec![last, second, first])
}
