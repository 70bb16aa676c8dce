//! Products of quaternions and vectors with the unit vectors e₁, e₂, e₃.
//!
//! Both recurrences, for one body and for several, take the indices and signs of the factors from
//! these tables.

use super::row::Row;
use crate::math::number::Number;

/// Image of four numbers: number i is the number at `from[i]` times `signs[i]`.
#[derive(Clone, Copy)]
pub(super) struct UnitProduct {
    pub(super) from: [usize; 4],
    pub(super) signs: [f64; 4],
}

/// q ∘ eᵢ for q = (w, x, y, z): (−x, w, z, −y), (−y, −z, w, x), (−z, y, −x, w).
pub(super) const TURN: [UnitProduct; 3] = [
    UnitProduct { from: [1, 0, 3, 2], signs: [-1.0, 1.0, 1.0, -1.0] },
    UnitProduct { from: [2, 3, 0, 1], signs: [-1.0, -1.0, 1.0, 1.0] },
    UnitProduct { from: [3, 2, 1, 0], signs: [-1.0, 1.0, -1.0, 1.0] },
];

/// v × eᵢ for v = (v1, v2, v3, 0): (0, v3, −v2, 0), (−v3, 0, v1, 0), (v2, −v1, 0, 0).
pub(super) const CROSS: [UnitProduct; 3] = [
    UnitProduct { from: [0, 2, 1, 3], signs: [0.0, 1.0, -1.0, 0.0] },
    UnitProduct { from: [2, 1, 0, 3], signs: [-1.0, 0.0, 1.0, 0.0] },
    UnitProduct { from: [1, 0, 2, 3], signs: [1.0, -1.0, 0.0, 0.0] },
];

/// Component of ω̇ that contains the product with Ωᵢ: ω3 Ω1 for ω̇2, ω1 Ω2 for ω̇3, ω2 Ω3 for ω̇1.
/// [`CROSS`] gives the index of the other factor.
pub(super) const EULER: [[f64; 4]; 3] = [[0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [1.0, 0.0, 0.0, 0.0]];

impl UnitProduct {
    /// Returns number i of the image, or `None` if it is always zero.
    #[inline(always)]
    pub(super) fn number<N: Number>(&self, of: Row<N>, i: usize) -> Option<N> {
        let number = of.0[self.from[i]];
        match self.signs[i] {
            0.0 => None,
            sign if sign < 0.0 => Some(-number),
            _ => Some(number),
        }
    }

    /// Adds the image times a number.
    #[inline(always)]
    pub(super) fn plus<N: Number>(&self, sum: Row<N>, of: Row<N>, by: N) -> Row<N> {
        Row([
            self.plus_number(sum, of, by, 0),
            self.plus_number(sum, of, by, 1),
            self.plus_number(sum, of, by, 2),
            self.plus_number(sum, of, by, 3),
        ])
    }

    #[inline(always)]
    fn plus_number<N: Number>(&self, sum: Row<N>, of: Row<N>, by: N, i: usize) -> N {
        match self.number(of, i) {
            Some(number) => number.mul_add(by, sum.0[i]),
            None => sum.0[i],
        }
    }
}

/// Adds Σᵢ Ωᵢ (v · eᵢ) for one of the two products, one component of Ω after the other.
#[inline(always)]
pub(super) fn plus_product<N: Number>(
    products: &[UnitProduct; 3],
    sum: Row<N>,
    of: Row<N>,
    turning: Row<N>,
) -> Row<N> {
    let [first, second, third] = products;
    let [o1, o2, o3, _] = turning.0;
    third.plus(second.plus(first.plus(sum, of, o1), of, o2), of, o3)
}

/// Returns the indices of the image of a pair of rows, where each row has its own product.
pub(super) const fn places(first: UnitProduct, second: UnitProduct) -> [usize; 8] {
    let ([a, b, c, d], [e, f, g, h]) = (first.from, second.from);
    [a, b, c, d, 4 + e, 4 + f, 4 + g, 4 + h]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Checks the tables against the definitions of the Hamilton product and the vector product.
    #[test]
    fn images_are_products_with_unit_vectors() {
        let [w, x, y, z] = [0.3, -1.7, 2.9, 0.6];
        for axis in 0..3 {
            let mut e = [0.0; 3];
            e[axis] = 1.0;
            let turned = [
                -x * e[0] - y * e[1] - z * e[2],
                w * e[0] + y * e[2] - z * e[1],
                w * e[1] + z * e[0] - x * e[2],
                w * e[2] + x * e[1] - y * e[0],
            ];
            let crossed = [y * e[2] - z * e[1], z * e[0] - x * e[2], x * e[1] - y * e[0], 0.0];
            let image = |product: &UnitProduct, of| product.plus(Row::ZERO, Row(of), 1.0).0;
            assert_eq!(image(&TURN[axis], [w, x, y, z]), turned);
            assert_eq!(image(&CROSS[axis], [x, y, z, 0.0]), crossed);
        }
    }
}
