//! The derivative of a function that can only be evaluated.

/// f′(0) by central differences over h, h/2, h/4 …, extrapolated to h = 0; the best of the table is taken.
///
/// Source: Ridders, Adv. Eng. Softw. 4 (1982) 75.
pub(super) fn derivative(f: impl Fn(f64) -> [f64; 3], h: f64) -> [f64; 3] {
    let mut best = ([0.0; 3], f64::INFINITY);
    let mut previous: Vec<[f64; 3]> = Vec::new();
    for level in 0..LEVELS {
        let h = h / f64::from(1_u32 << level);
        let (after, before) = (f(h), f(-h));
        let mut row = vec![each(after, before, |a, b| (a - b) / (2.0 * h))];
        let mut power = 1.0;
        for (j, coarse) in previous.iter().enumerate() {
            power *= 4.0;
            // The error's term in h^(2j + 2) goes.
            let next = each(row[j], *coarse, |fine, coarse| fine + (fine - coarse) / (power - 1.0));
            let error = distance(next, row[j]).max(distance(next, *coarse));
            if error < best.1 {
                best = (next, error);
            }
            row.push(next);
        }
        let (Some(last), Some(before)) = (row.last(), previous.last()) else {
            best.0 = row[0];
            previous = row;
            continue;
        };
        // Rounding has taken over.
        if distance(*last, *before) > 2.0 * best.1 && level > 3 {
            break;
        }
        previous = row;
    }
    best.0
}

const LEVELS: u32 = 10;

fn each(a: [f64; 3], b: [f64; 3], f: impl Fn(f64, f64) -> f64) -> [f64; 3] {
    core::array::from_fn(|k| f(a[k], b[k]))
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    each(a, b, |a, b| (a - b).abs()).into_iter().fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn derivatives_have_eleven_digits() {
        let [a, b, c] = derivative(|x| [(1.3 + x).sin(), (0.7 * (x - 0.4)).exp(), 1.0 / (2.0 + x)], 0.1);
        assert!((a - 1.3_f64.cos()).abs() < 1e-12, "{a}");
        assert!((b - 0.7 * (-0.28_f64).exp()).abs() < 1e-12, "{b}");
        assert!((c + 0.25).abs() < 1e-12, "{c}");
        // |x| x has the derivative zero at 0, and no second one.
        let [d, ..] = derivative(|x| [x.abs() * x, 0.0, 0.0], 0.1);
        assert!(d.abs() < 1e-3, "{d}");
        assert_eq!(derivative(|x| [3.0 * x, 0.0, -x], 0.1)[1], 0.0);
    }
}
