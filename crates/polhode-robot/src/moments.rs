//! Tensors that may be unphysical: elements, eigenvalues, and changes of axes and reference point.
//!
//! [`polhode::body::InertiaTensor`] refuses an unphysical tensor. This module decomposes a tensor
//! as the file states it; the checks judge it later.

use crate::pose::cross;

/// Elements xx, yy, zz, xy, xz, yz of a symmetric matrix. For an inertia tensor in kg·m², xy = −∫xy
/// dm.
pub type Elements = [f64; 6];

/// Row and column of each element.
pub(crate) const PLACES: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];

/// Eigenvalues and eigenvectors of a symmetric matrix. For a physical inertia tensor they are the
/// principal moments and axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moments {
    /// Eigenvalues i1 ≤ i2 ≤ i3. For an unphysical tensor some may be negative.
    pub values: [f64; 3],
    /// Unit eigenvectors; `axes[k]` belongs to `values[k]`. They are right-handed, and the largest
    /// component of each of the first two is positive.
    pub axes: [[f64; 3]; 3],
}

impl Moments {
    /// Returns moments and axes, accurate to a few ε of the largest moment. The elements must be
    /// finite.
    ///
    /// ```
    /// use polhode_robot::moments::Moments;
    ///
    /// let moments = Moments::of(&[0.268209, 0.359486, 0.225659, 0.011284, 0.0635697, -0.00106685]);
    /// assert!((moments.values[0] - 0.179588555).abs() < 1e-9);
    /// ```
    pub fn of(elements: &Elements) -> Self {
        let largest = elements.iter().fold(0.0, |max, x| f64::max(max, x.abs()));
        if !(largest > 0.0 && largest.is_finite()) {
            return Self { values: [0.0; 3], axes: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]] };
        }
        let (values, vectors) = polhode::math::symmetric_eigen(*elements);
        let [first, second, _] = vectors.map(positive);
        Self { values, axes: [first, second, cross(first, second)] }
    }

    /// Returns i1 + i2 − i3; negative for an unphysical tensor.
    pub fn triangle(&self) -> f64 {
        let [i1, i2, i3] = self.values;
        i1 + i2 - i3
    }

    /// Returns true if a body can have these moments within a tolerance of `slack`, kg·m².
    pub fn are_possible(&self, slack: f64) -> bool {
        self.values[0] >= -slack && self.triangle() >= -slack
    }

    /// Returns the edges, m, of the uniform box of this mass with these moments, along the
    /// principal axes. Returns `None` if none exists.
    ///
    /// edge₁² = 6 (i2 + i3 − i1) / m, and cyclically.
    pub fn equivalent_box(&self, mass: f64) -> Option<[f64; 3]> {
        let [i1, i2, i3] = self.values;
        let squares = [i2 + i3 - i1, i1 + i3 - i2, i1 + i2 - i3].map(|x| 6.0 * x / mass);
        squares.iter().all(|&x| x >= 0.0 && x.is_finite()).then(|| squares.map(f64::sqrt))
    }
}

/// Returns v or −v, such that the largest component is positive.
fn positive(v: [f64; 3]) -> [f64; 3] {
    let largest = v.iter().fold(0.0_f64, |max, &x| if x.abs() > max.abs() { x } else { max });
    if largest < 0.0 { v.map(|x| -x) } else { v }
}

/// Returns the 3×3 matrix of six elements.
pub(crate) fn matrix(&[xx, yy, zz, xy, xz, yz]: &Elements) -> [[f64; 3]; 3] {
    [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]
}

/// Returns the six elements of a symmetric matrix.
pub(crate) fn elements(m: &[[f64; 3]; 3]) -> Elements {
    PLACES.map(|(i, j)| m[i][j])
}

/// Returns the Frobenius norm √Σ I_ij² over all nine elements.
pub(crate) fn norm(&[xx, yy, zz, xy, xz, yz]: &Elements) -> f64 {
    (xx * xx + yy * yy + zz * zz + 2.0 * (xy * xy + xz * xz + yz * yz)).sqrt()
}

pub(crate) fn trace(elements: &Elements) -> f64 {
    elements[0] + elements[1] + elements[2]
}

pub(crate) fn scaled(elements: &Elements, factor: f64) -> Elements {
    elements.map(|x| x * factor)
}

pub(crate) fn difference(a: &Elements, b: &Elements) -> Elements {
    std::array::from_fn(|k| a[k] - b[k])
}

/// Returns R I Rᵀ.
pub(crate) fn rotated(elements: &Elements, r: &[[f64; 3]; 3]) -> Elements {
    let i = matrix(elements);
    PLACES.map(|(a, b)| {
        let mut sum = 0.0;
        for j in 0..3 {
            for k in 0..3 {
                sum += r[a][j] * i[j][k] * r[b][k];
            }
        }
        sum
    })
}

/// Returns m (c² 1 − c cᵀ): the parallel-axis term of a mass whose centre is at c from the
/// reference point.
pub(crate) fn parallel_axes(mass: f64, [x, y, z]: [f64; 3]) -> Elements {
    [y * y + z * z, x * x + z * z, x * x + y * y, -x * y, -x * z, -y * z].map(|e| mass * e)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pose::{rotation_matrix, transposed};

    fn rebuilt(moments: &Moments) -> Elements {
        // The columns of R are the axes.
        let [a, b, c] = moments.values;
        rotated(&[a, b, c, 0.0, 0.0, 0.0], &transposed(&moments.axes))
    }

    #[test]
    fn a_published_tensor_comes_apart_and_together_again() {
        let elements = [0.268209, 0.359486, 0.225659, 0.011284, 0.0635697, -0.00106685];
        let moments = Moments::of(&elements);
        for (value, printed) in moments.values.iter().zip([0.179588555, 0.31243485, 0.361330595]) {
            assert!((value - printed).abs() < 6e-9, "{value} {printed}");
        }
        let back = rebuilt(&moments);
        assert!(norm(&difference(&back, &elements)) < 1e-15, "{back:?}");
    }

    #[test]
    fn its_quaternion_rebuilds_it_and_the_conjugate_does_not() {
        let elements = [0.268209, 0.359486, 0.225659, 0.011284, 0.0635697, -0.00106685];
        let moments = Moments::of(&elements);
        let columns = transposed(&moments.axes);
        let rotation =
            polhode::math::Rotation::<polhode::math::Body, polhode::math::Principal>::from_matrix(columns)
                .unwrap();
        let [w, x, y, z] = rotation.canonical_quaternion();
        let [a, b, c] = moments.values;
        let along = [a, b, c, 0.0, 0.0, 0.0];
        let right = rotated(&along, &rotation_matrix([w, x, y, z]));
        let wrong = rotated(&along, &rotation_matrix([w, -x, -y, -z]));
        assert!(norm(&difference(&right, &elements)) < 1e-15);
        assert!(norm(&difference(&wrong, &elements)) > 0.1 * norm(&elements));
    }

    #[test]
    fn impossible_tensors_come_apart_too() {
        let elements = [-3.0, 2.0, 0.5, 4.0, -1.5, 0.7];
        let moments = Moments::of(&elements);
        assert!(moments.values[0] < 0.0 && moments.triangle() < 0.0);
        assert!(norm(&difference(&rebuilt(&moments), &elements)) < 1e-14);
        assert!((trace(&elements) - moments.values.iter().sum::<f64>()).abs() < 1e-14);
        assert!(!moments.are_possible(0.0));
    }

    #[test]
    fn the_box_of_a_box() {
        // Box with edges 0.2, 0.3, 0.5 m and mass 1.7 kg: i = m (b² + c²) / 12.
        let (m, [a, b, c]) = (1.7, [0.2_f64, 0.3, 0.5]);
        let moments = [b * b + c * c, a * a + c * c, a * a + b * b].map(|x| m * x / 12.0);
        let tensor = [moments[0], moments[1], moments[2], 0.0, 0.0, 0.0];
        let edges = Moments::of(&tensor).equivalent_box(m).unwrap();
        // The smallest moment is about the longest edge.
        for (edge, expected) in edges.iter().zip([c, b, a]) {
            assert!((edge - expected).abs() < 1e-14, "{edges:?}");
        }
        assert_eq!(Moments::of(&[1.0, 1.0, 3.0, 0.0, 0.0, 0.0]).equivalent_box(1.0), None);
    }

    #[test]
    fn axes_are_right_handed_and_unit() {
        let moments = Moments::of(&[1.3, 0.4, 2.2, -0.3, 0.21, 0.17]);
        let [a, b, c] = moments.axes;
        assert_eq!(cross(a, b), c);
        for axis in moments.axes {
            assert!((axis.iter().map(|x| x * x).sum::<f64>() - 1.0).abs() < 1e-14);
        }
    }
}
