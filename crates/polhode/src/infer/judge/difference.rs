//! Difference of two attitudes, to the full precision of their numbers.

use crate::math::double::Double;

/// Returns the rotation vector θ, along body axes, rad, from one attitude to another: R_b = R_a
/// exp(θ). The quaternions may have any length.
///
/// The small vector part of q* p is a difference of products near one, which are computed in
/// double-double arithmetic.
pub(super) fn rotation_vector(a: [f64; 4], b: [f64; 4]) -> [f64; 3] {
    let ([aw, ax, ay, az], [bw, bx, by, bz]) = (a, b);
    // q_a* q_b = (w, v).
    let w = aw * bw + ax * bx + ay * by + az * bz;
    let v = [
        sum_of_products([(aw, bx), (-ax, bw), (-ay, bz), (az, by)]),
        sum_of_products([(aw, by), (-ay, bw), (-az, bx), (ax, bz)]),
        sum_of_products([(aw, bz), (-az, bw), (-ax, by), (ay, bx)]),
    ];
    let sine = v[0].hypot(v[1]).hypot(v[2]);
    if sine == 0.0 {
        return [0.0; 3];
    }
    // θ = 2 atan(|v| / w) v / |v|; the lengths and signs of the quaternions cancel.
    let angle = 2.0 * libm::atan2(sine, w.abs());
    let factor = angle.copysign(angle * w) / sine;
    v.map(|c| c * factor)
}

fn sum_of_products(products: [(f64, f64); 4]) -> f64 {
    products.into_iter().fold(Double::default(), |sum, (a, b)| sum + Double::product(a, b)).value()
}

/// Returns the angle between two attitudes, rad, from 0 to π.
pub(super) fn angle_between(a: [f64; 4], b: [f64; 4]) -> f64 {
    length(rotation_vector(a, b))
}

pub(super) fn length([x, y, z]: [f64; 3]) -> f64 {
    x.hypot(y).hypot(z)
}

/// Returns v_body = R_space_bodyᵀ v_space, for a quaternion of any length.
pub(super) fn to_body([w, x, y, z]: [f64; 4], v: [f64; 3]) -> [f64; 3] {
    turned([w, -x, -y, -z], v)
}

/// Returns v_space = R_space_body v_body, for a quaternion of any length.
pub(super) fn to_space(q: [f64; 4], v: [f64; 3]) -> [f64; 3] {
    turned(q, v)
}

/// Returns R v = v + 2 u × (u × v + w v) / (w² + u²).
fn turned([w, x, y, z]: [f64; 4], v: [f64; 3]) -> [f64; 3] {
    let u = [x, y, z];
    let s = 2.0 / (w * w + x * x + y * y + z * z);
    let uv = cross(u, v);
    let inner = [uv[0] + w * v[0], uv[1] + w * v[1], uv[2] + w * v[2]];
    let outer = cross(u, inner);
    [v[0] + s * outer[0], v[1] + s * outer[1], v[2] + s * outer[2]]
}

fn cross([a, b, c]: [f64; 3], [x, y, z]: [f64; 3]) -> [f64; 3] {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}

/// Returns the product q p of quaternions (w, x, y, z).
pub(super) fn product([a, b, c, d]: [f64; 4], [w, x, y, z]: [f64; 4]) -> [f64; 4] {
    [
        a * w - b * x - c * y - d * z,
        a * x + b * w + c * z - d * y,
        a * y - b * z + c * w + d * x,
        a * z + b * y - c * x + d * w,
    ]
}

/// Returns the conjugate q*.
pub(super) fn conjugate([w, x, y, z]: [f64; 4]) -> [f64; 4] {
    [w, -x, -y, -z]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::frame::{Body, Space};
    use crate::math::rotation::Rotation;
    use crate::math::vector::Direction;

    /// The error of a small rotation of 1e-10 rad is only the rounding of the stored attitudes,
    /// about 1e-16 rad.
    #[test]
    fn a_small_turn_is_found_to_the_digits_that_the_numbers_hold() {
        let a = Rotation::<Space, Body>::from_quaternion([0.6, -0.3, 0.5, 0.2]).expect("no zero");
        let mut squares = 0.0;
        for k in 0..100 {
            let axis = Direction::<Body>::new(0.3 + 0.01 * f64::from(k), -0.5, 0.7);
            let turn = Rotation::<Body, Body>::from_axis_angle(axis, 1e-10).expect("an axis");
            let b = (a * turn).quaternion().map(|c| -3.0 * c);
            let theta = rotation_vector(a.quaternion(), b);
            let unit = axis.direction().expect("not zero").to_array();
            squares += (0..3).map(|i| (theta[i] - 1e-10 * unit[i]).powi(2)).sum::<f64>();
        }
        assert!((squares / 100.0).sqrt() < 3e-16, "{}", (squares / 100.0).sqrt());
    }

    #[test]
    fn a_large_turn_is_one_whole_turn_less_another() {
        let turn = |angle: f64| {
            Rotation::<Space, Body>::from_axis_angle(Direction::new(1.0, 2.0, -2.0), angle).expect("an axis")
        };
        let [x, y, z] = rotation_vector(turn(0.4).quaternion(), turn(0.4 + 5.0).quaternion());
        let expected = 5.0 - core::f64::consts::TAU;
        for (value, part) in [x, y, z].into_iter().zip([1.0, 2.0, -2.0]) {
            assert!((value - expected * part / 3.0).abs() < 1e-15);
        }
    }

    #[test]
    fn vectors_turn_as_the_rotation_says() {
        let r = Rotation::<Space, Body>::from_quaternion([0.6, -0.3, 0.5, 0.2]).expect("no zero");
        let (q, v) = (r.quaternion().map(|c| 1.7 * c), [0.3, -1.1, 0.4]);
        let expected = (r * Direction::<Body>::from_array(v)).to_array();
        let (there, back) = (to_space(q, v), to_body(q, expected));
        for i in 0..3 {
            assert!((there[i] - expected[i]).abs() < 1e-15 && (back[i] - v[i]).abs() < 1e-15);
        }
    }
}
