//! The triangle of moments compared with its definition.

use polhode::body::{MOMENT_TRIANGLE, place_in_moment_triangle, ratio_region};

#[test]
fn rods_are_corners_and_laminae_edges() {
    let near = |a: [f64; 2], b: [f64; 2]| assert!((0..2).all(|k| (a[k] - b[k]).abs() < 1e-15), "{a:?} {b:?}");
    near(place_in_moment_triangle([0.0, 2.0, 2.0]), MOMENT_TRIANGLE[0]);
    near(place_in_moment_triangle([3.0, 0.0, 3.0]), MOMENT_TRIANGLE[1]);
    near(place_in_moment_triangle([3.0, 3.0, 0.0]), MOMENT_TRIANGLE[2]);
    near(place_in_moment_triangle([4.0, 4.0, 4.0]), [0.5, MOMENT_TRIANGLE[2][1] / 3.0]);
    // i1 + i2 = i3: a mass of g1 : g2 = 3 : 2 between the first two corners
    near(place_in_moment_triangle([2.0, 3.0, 5.0]), [0.4, 0.0]);
}

#[test]
fn the_outline_is_where_the_square_of_the_error_is_the_quantile() {
    let (ratios, sd, r) = ([0.6, 0.8], [0.01, 0.02], 0.6);
    for probability in [0.68, 0.95] {
        for point in ratio_region(ratios, sd, r, probability).unwrap() {
            let [a, b] = [0, 1].map(|k| (point[k] - ratios[k]) / sd[k]);
            let square = (a * a - 2.0 * r * a * b + b * b) / (1.0 - r * r);
            // χ² of two degrees of freedom: 1 − exp(−½ x)
            assert!((1.0 - (-0.5 * square).exp() - probability).abs() < 1e-12, "{square}");
        }
    }
}

#[test]
fn no_impossible_body_is_inside() {
    // a thin plate, and a body close to a rod
    for (ratios, sd) in [([0.301, 0.702], [0.01, 0.02]), ([0.02, 0.985], [0.03, 0.03])] {
        let region = ratio_region(ratios, sd, -0.2, 0.95).unwrap();
        assert!(region.len() > 20);
        let edge = region.iter().filter(|[a, b]| (a + b - 1.0).abs() < 1e-12).count();
        assert!(edge >= 2, "{region:?}");
        for [a, b] in region {
            assert!(a + b >= 1.0 - 1e-12 && a + 1.0 >= b - 1e-12 && b + 1.0 >= a - 1e-12);
            let [x, y] = place_in_moment_triangle([a, b, 1.0]);
            assert!(y > -1e-12 && y <= 3.0_f64.sqrt() * x.min(1.0 - x) + 1e-12, "{x} {y}");
        }
    }
}

#[test]
fn exact_ratios_have_no_region() {
    assert_eq!(ratio_region([0.0, 1.0], [0.0, 0.0], 0.0, 0.95), None);
}
