//! Numerical derivative of a function that can only be evaluated.

/// Derivative f′(0) from differences, with error indicators.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Slope {
    value: [f64; 3],
    /// Difference between the last extrapolations.
    error: f64,
    /// Difference between the slopes on both sides of 0, after the last halving.
    corner: f64,
    /// Largest difference quotient for the largest h.
    pub(crate) largest: f64,
}

impl Slope {
    /// Returns f′(0) of a function that is known to be differentiable.
    pub(crate) const fn best(&self) -> [f64; 3] {
        self.value
    }

    /// Returns f′(0) if it exists: `None` if the extrapolations or the slopes on both sides differ,
    /// relative to `scale`, the magnitude to which rounding is relative.
    pub(crate) fn value(self, scale: f64) -> Option<[f64; 3]> {
        (self.error <= BAD * scale && self.corner <= CORNER * scale).then_some(self.value)
    }
}

/// Computes f′(0) by central differences over h, h/2, h/4 …, extrapolated to h = 0; the best value
/// of the table is returned.
///
/// Source: Ridders, Adv. Eng. Softw. 4 (1982) 75.
pub(crate) fn derivative(f: impl Fn(f64) -> [f64; 3], h: f64) -> Slope {
    let here = f(0.0);
    let mut best = ([0.0; 3], f64::INFINITY);
    let mut previous: Vec<[f64; 3]> = Vec::new();
    let (mut largest, mut corner) = (0.0, f64::INFINITY);
    for level in 0..LEVELS {
        let h = h / f64::from(1_u32 << level);
        let (after, before) = (f(h), f(-h));
        let mut row = vec![each(after, before, |a, b| (a - b) / (2.0 * h))];
        if !row[0].iter().all(|x| x.is_finite()) {
            previous.clear();
            continue;
        }
        // Difference of the slopes on both sides; it decreases with h where f is smooth.
        let [after, before] = [after, before].map(|there| each(there, here, |a, b| a - b));
        corner = size(each(after, before, |a, b| (a + b) / h));
        if previous.is_empty() {
            largest = size(row[0]).max(corner);
        }
        let mut power = 1.0;
        for (j, coarse) in previous.iter().enumerate() {
            power *= 4.0;
            // Removes the error term of order h^(2j + 2).
            let next = each(row[j], *coarse, |fine, coarse| fine + (fine - coarse) / (power - 1.0));
            let error = size(each(next, row[j], |a, b| a - b)).max(size(each(next, *coarse, |a, b| a - b)));
            if error < best.1 {
                best = (next, error);
            }
            row.push(next);
        }
        previous = row;
    }
    Slope { value: best.0, error: best.1, corner, largest }
}

const LEVELS: u32 = 20;

/// Largest error of a derivative, relative to its scale.
const BAD: f64 = 1e-5;

/// Largest difference of the slopes on both sides, relative to the same scale.
const CORNER: f64 = 1e-3;

fn each(a: [f64; 3], b: [f64; 3], f: impl Fn(f64, f64) -> f64) -> [f64; 3] {
    core::array::from_fn(|k| f(a[k], b[k]))
}

fn size(a: [f64; 3]) -> f64 {
    a.into_iter().fold(0.0, |most, x| f64::max(most, x.abs()))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn slope(f: impl Fn(f64) -> [f64; 3]) -> Option<[f64; 3]> {
        let slope = derivative(f, 0.1);
        slope.value(slope.largest + 1.0)
    }

    #[test]
    fn derivatives_have_eleven_digits() {
        let [a, b, c] = slope(|x| [(1.3 + x).sin(), (0.7 * (x - 0.4)).exp(), 1.0 / (2.0 + x)]).unwrap();
        assert!((a - 1.3_f64.cos()).abs() < 1e-12, "{a}");
        assert!((b - 0.7 * (-0.28_f64).exp()).abs() < 1e-12, "{b}");
        assert!((c + 0.25).abs() < 1e-12, "{c}");
        // |x| x has the derivative zero at 0, and no second derivative.
        let [d, ..] = slope(|x| [x.abs() * x, 0.0, 0.0]).unwrap();
        assert!(d.abs() < 1e-6, "{d}");
        assert_eq!(slope(|x| [3.0 * x, 0.0, -x]).unwrap()[1], 0.0);
        // Even functions, and one that is not defined at the largest h.
        let [e, f, g] = slope(|x| [1.0 - x.cos(), x * x, (0.04 + x).sqrt()]).unwrap();
        assert!(e.abs() < 1e-12 && f.abs() < 1e-12 && (g - 2.5).abs() < 1e-10, "{e} {f} {g}");
        assert_eq!(slope(|_| [0.0; 3]), Some([0.0; 3]));
        assert_eq!(slope(|_| [1.7, -2.3, 0.1]), Some([0.0; 3]));
    }

    #[test]
    fn corners_jumps_and_poles_have_none() {
        for f in [
            |x: f64| x.abs(),
            |x: f64| 2.0 * x + 0.3 * x.abs(),
            |x: f64| if x > 0.0 { 1.0 } else { 0.0 },
            |x: f64| if x == 0.0 { 0.0 } else { -x.signum() },
            |x: f64| x.abs().sqrt(),
            |x: f64| x.cbrt(),
        ] {
            assert_eq!(slope(|x| [f(x), 3.0 * x, 0.0]), None, "{}", f(0.2));
        }
    }
}
