//! Symmetric 3 × 3 matrices by their elements xx, yy, zz, xy, xz, yz.

/// Elements xx, yy, zz, xy, xz, yz of a symmetric matrix.
pub(crate) type Six = [f64; 6];

/// Names of the elements, in order.
pub(crate) const ELEMENTS: [&str; 6] = ["xx", "yy", "zz", "xy", "xz", "yz"];

/// Row and column of each element.
pub(crate) const PLACES: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];

/// Returns the full matrix, row by row.
pub(crate) const fn matrix([xx, yy, zz, xy, xz, yz]: Six) -> [[f64; 3]; 3] {
    [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]
}

/// Returns Σ valueₖ vₖ vₖᵀ.
pub(crate) fn of_eigen(values: [f64; 3], vectors: [[f64; 3]; 3]) -> Six {
    PLACES.map(|(i, j)| (0..3).map(|k| values[k] * vectors[k][i] * vectors[k][j]).sum())
}

/// Returns the coefficients of the elements of A in uᵀ A v.
pub(crate) fn between(u: [f64; 3], v: [f64; 3]) -> Six {
    let off = |i: usize, j: usize| u[i] * v[j] + u[j] * v[i];
    [u[0] * v[0], u[1] * v[1], u[2] * v[2], off(0, 1), off(0, 2), off(1, 2)]
}

/// Returns the second moments G = ½ tr(I) 1 − I of a tensor I.
pub(crate) fn moments_of(i: Six) -> Six {
    let half = 0.5 * (i[0] + i[1] + i[2]);
    [half - i[0], half - i[1], half - i[2], -i[3], -i[4], -i[5]]
}

/// Returns the tensor I = tr(G) 1 − G of second moments G.
pub(crate) fn tensor_of(g: Six) -> Six {
    [g[1] + g[2], g[0] + g[2], g[0] + g[1], -g[3], -g[4], -g[5]]
}
