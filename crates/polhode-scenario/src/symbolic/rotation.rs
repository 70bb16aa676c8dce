//! Exact sines and cosines, and rotation matrices.

use polhode_algebra::{Angle, Matrix, Rational, RationalFunction, Symbol, Symbols, Vector};

type Value = RationalFunction;

/// Returns sine and cosine of an angle, rad: a multiple of π/12, and a sum of integer multiples of
/// symbols. `None` for other angles.
pub fn sine_and_cosine(angle: &Value, pi: Symbol) -> Option<[Value; 2]> {
    let fixed = angle.derivative(pi);
    let rest = angle - &(&fixed * Value::from(pi));
    let [sin, cos] = of_twelfths(&fixed.as_constant()?)?;
    if rest.is_zero() {
        return Some([sin, cos]);
    }
    // sin(α + β) and cos(α + β)
    let rest = Angle::new(&rest)?;
    let (s, c) = (rest.sine(), rest.cosine());
    Some([&sin * &c + &cos * &s, cos * c - sin * s])
}

/// Returns sine and cosine of a multiple of π; `None` if it is not one of π/12.
fn of_twelfths(multiple: &Rational) -> Option<[Value; 2]> {
    let twelfths = multiple * Rational::from(12);
    let turns = twelfths.is_integer().then(|| twelfths.to_f64())?;
    let k = (turns.abs() < 1e9).then(|| (turns as i64).rem_euclid(24))?;
    Some([sine(k)?, sine((k + 6) % 24)?])
}

/// Returns sin(kπ/12) for k from 0 to 23.
fn sine(k: i64) -> Option<Value> {
    let root = |n: i64| Value::square_root_of(&Rational::from(n));
    let part = |value: Value, d: i64| value.scaled(&Rational::new(1, d).unwrap_or_else(Rational::one));
    let positive = match k % 12 {
        0 => Value::zero(),
        1 | 11 => part(root(6)? - root(2)?, 4),
        2 | 10 => part(Value::one(), 2),
        3 | 9 => part(root(2)?, 2),
        4 | 8 => part(root(3)?, 2),
        5 | 7 => part(root(6)? + root(2)?, 4),
        _ => Value::one(),
    };
    Some(if k < 12 { positive } else { -positive })
}

/// Returns the rotation by an angle with this sine and cosine about an axis a of any length:
/// R = cos θ 1 + (1 − cos θ) n nᵀ + sin θ \[n\]×, n = a/|a|. `None` if |a| is not rational.
pub fn about_axis(axis: &Vector, [sin, cos]: &[Value; 2], symbols: &Symbols) -> Option<Matrix> {
    let n = unit(axis, symbols)?;
    let cross = Matrix([
        [Value::zero(), -&n.0[2], n.0[1].clone()],
        [n.0[2].clone(), Value::zero(), -&n.0[0]],
        [-&n.0[1], n.0[0].clone(), Value::zero()],
    ]);
    let along = Matrix::outer(&n, &n).scaled(&(Value::one() - cos));
    Some(Matrix::identity().scaled(cos) + along + cross.scaled(sin))
}

/// Returns the unit vector along a vector; `None` if its length is zero or not rational.
pub fn unit(vector: &Vector, symbols: &Symbols) -> Option<Vector> {
    let length = vector.dot(vector).square_root(symbols).as_rational_function()?;
    Some(vector.scaled(&Value::one().over(&length)?))
}
