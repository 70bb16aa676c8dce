//! Unions of primitives compared with sums over a grid of points.

use std::fmt::Write as _;

use super::{of, written};
use crate::common::{Matrix, applied, matrix_about, times, transposed};

/// Shape with its placement.
struct Shape {
    kind: usize,
    size: [f64; 3],
    position: [f64; 3],
    angles: [f64; 3],
}

/// Random numbers from −1 to 1, the same in every run.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    fn shape(&mut self) -> Shape {
        Shape {
            kind: ((self.next() + 1.0) * 3.0) as usize,
            size: [0; 3].map(|_| 0.06 + 0.03 * self.next()),
            position: [0; 3].map(|_| 0.08 * self.next()),
            angles: [0; 3].map(|_| 3.0 * self.next()),
        }
    }
}

impl Shape {
    fn turn(&self) -> Matrix {
        let [roll, pitch, yaw] = self.angles;
        times(matrix_about(2, yaw), times(matrix_about(1, pitch), matrix_about(0, roll)))
    }

    /// Returns true if a point of the link is in the shape.
    fn holds(&self, back: Matrix, point: [f64; 3]) -> bool {
        let [a, b, c] = self.size;
        let [px, py, pz] = self.position;
        let d = [point[0] - px, point[1] - py, point[2] - pz];
        if d[0] * d[0] + d[1] * d[1] + d[2] * d[2] > (a + b + c) * (a + b + c) {
            return false;
        }
        let [x, y, z] = applied(back, d);
        let across = x.hypot(y);
        match self.kind {
            0 => x.abs() < a && y.abs() < b && z.abs() < c,
            1 => across < a && z.abs() < c,
            2 => across.hypot(z) < a,
            3 => across.hypot(z.abs() - z.abs().min(c)) < a,
            4 => (x / a).powi(2) + (y / b).powi(2) + (z / c).powi(2) < 1.0,
            _ => z.abs() < c && across < a * (0.5 - 0.5 * z / c),
        }
    }

    fn sdf(&self) -> String {
        let [a, b, c] = self.size;
        match self.kind {
            0 => format!("<box><size>{} {} {}</size></box>", 2.0 * a, 2.0 * b, 2.0 * c),
            1 => format!("<cylinder><radius>{a}</radius><length>{}</length></cylinder>", 2.0 * c),
            2 => format!("<sphere><radius>{a}</radius></sphere>"),
            3 => format!("<capsule><radius>{a}</radius><length>{}</length></capsule>", 2.0 * c),
            4 => format!("<ellipsoid><radii>{a} {b} {c}</radii></ellipsoid>"),
            _ => format!("<cone><radius>{a}</radius><length>{}</length></cone>", 2.0 * c),
        }
    }
}

/// Points along each edge of the grid, whose edges are 2 · `HALF` m.
const POINTS: u32 = 56;
const HALF: f64 = 0.28;

#[test]
fn unions_agree_with_a_grid_of_points() {
    let mut numbers = Numbers(11);
    let (mut overlaps, mut kinds) = (0, [0; 6]);
    for _ in 0..10 {
        let shapes = [0; 3].map(|_| numbers.shape());
        let mut sdf = "<sdf version=\"1.11\"><model name=\"m\"><link name=\"a\">".to_owned();
        for (k, shape) in shapes.iter().enumerate() {
            let [x, y, z] = shape.position;
            let [roll, pitch, yaw] = shape.angles;
            let geometry = shape.sdf();
            let _ = write!(
                sdf,
                "<collision name=\"c{k}\"><pose>{x} {y} {z} {roll} {pitch} {yaw}</pose><geometry>{geometry}</geometry></collision>"
            );
            kinds[shape.kind] += 1;
        }
        sdf += "</link></model></sdf>";
        let inertials = written("m.sdf", &sdf, &["a=1000 kg/m^3"]);
        let body = of(&inertials, "a");
        let backs = shapes.each_ref().map(|shape| transposed(shape.turn()));
        let cell = 2.0 * HALF / f64::from(POINTS);
        let middle = |k: u32| (f64::from(k) + 0.5) * cell - HALF;
        let (mut count, mut first, mut square, mut several) = (0.0, [0.0; 3], [0.0; 3], 0.0);
        for (i, j, k) in
            (0..POINTS).flat_map(|i| (0..POINTS).flat_map(move |j| (0..POINTS).map(move |k| (i, j, k))))
        {
            let point = [middle(i), middle(j), middle(k)];
            let holding = shapes.iter().zip(backs).filter(|(shape, back)| shape.holds(*back, point)).count();
            several += if holding > 1 { holding as f64 - 1.0 } else { 0.0 };
            if holding > 0 {
                count += 1.0;
                first = std::array::from_fn(|k| first[k] + point[k]);
                square = std::array::from_fn(|k| square[k] + point[k] * point[k]);
            }
        }
        overlaps += usize::from(several > 0.02 * count);
        let mass = 1000.0 * count * cell.powi(3);
        assert!(
            (body.properties.mass() / mass - 1.0).abs() < 0.01,
            "{} {mass}\n{sdf}",
            body.properties.mass()
        );
        let center = first.map(|sum| sum / count);
        for (own, sampled) in body.properties.center_of_mass().to_array().iter().zip(center) {
            assert!((own - sampled).abs() < 2e-3, "{own} {sampled}\n{sdf}");
        }
        let spread: [f64; 3] = std::array::from_fn(|k| mass * (square[k] / count - center[k] * center[k]));
        let tensor = body.properties.inertia().matrix();
        for k in 0..3 {
            let sampled = spread[(k + 1) % 3] + spread[(k + 2) % 3];
            assert!((tensor[k][k] / sampled - 1.0).abs() < 0.03, "{} {sampled}\n{sdf}", tensor[k][k]);
        }
        assert!(body.error < 3e-3, "{}", body.error);
    }
    assert!(overlaps >= 8 && kinds.iter().all(|count| *count > 1), "{overlaps} {kinds:?}");
}
