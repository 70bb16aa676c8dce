//! Zeros of a continuous function.

/// Returns the zero of `f` between `a` and `b`, where `f` has the values `fa` and `fb` of opposite
/// sign, to the rounding of the argument.
///
/// The method is interpolate–truncate–project: regula falsi whose estimate is moved toward the
/// midpoint. It needs at most one evaluation more than bisection, and few evaluations for a smooth
/// function.
///
/// Source: I. F. D. Oliveira, R. H. C. Takahashi, ACM Trans. Math. Softw. 47 (2020) 5, algorithm 1,
/// with κ₂ = 2 and n₀ = 1.
pub(crate) fn root(
    mut f: impl FnMut(f64) -> f64,
    [mut a, mut b]: [f64; 2],
    [mut fa, mut fb]: [f64; 2],
) -> f64 {
    if fa == 0.0 {
        return a;
    }
    if fb == 0.0 {
        return b;
    }
    // Two neighbouring f64 numbers at the larger end of the bracket.
    let resolution = f64::EPSILON * a.abs().max(b.abs());
    let first = b - a;
    let most = libm::log2(first / resolution).ceil().max(0.0) + 1.0;
    let mut radius = 0.5 * resolution * libm::exp2(most);
    while b - a > resolution {
        let middle = a + 0.5 * (b - a);
        // Interpolates by regula falsi.
        let secant = (b * fa - a * fb) / (fa - fb);
        let secant = if secant > a && secant < b { secant } else { middle };
        // Truncates: moves the estimate toward the midpoint.
        let toward = (middle - secant).signum();
        let shift = 0.2 * (b - a) * (b - a) / first;
        let moved = if shift <= (middle - secant).abs() { secant + toward * shift } else { middle };
        // Projects the estimate into the minmax interval.
        let room = (radius - 0.5 * (b - a)).max(0.0);
        let x = if (moved - middle).abs() <= room { moved } else { middle - toward * room };
        if !(x > a && x < b) {
            break;
        }
        let fx = f(x);
        if fx == 0.0 {
            return x;
        }
        if (fx > 0.0) == (fa > 0.0) {
            (a, fa) = (x, fx);
        } else {
            (b, fb) = (x, fx);
        }
        radius *= 0.5;
    }
    if fa.abs() < fb.abs() { a } else { b }
}

/// Returns a place between `a` and `b` at which `f`, positive at both ends, is not positive. It
/// searches for the minimum by golden section; `None` if the minimum is positive.
pub(crate) fn dip(mut f: impl FnMut(f64) -> f64, [mut a, mut b]: [f64; 2]) -> Option<f64> {
    /// Constant 2 − the golden ratio.
    const SECTION: f64 = 0.381_966_011_250_105_1;
    /// Number of steps, which reduce the bracket to about 1e-9; a minimum is flat, so f is known to
    /// rounding there.
    const MOST: usize = 44;
    let (mut x, mut y) = (a + SECTION * (b - a), b - SECTION * (b - a));
    let (mut fx, mut fy) = (f(x), f(y));
    for _ in 0..MOST {
        if fx <= 0.0 {
            return Some(x);
        }
        if fy <= 0.0 {
            return Some(y);
        }
        if fx < fy {
            (b, y, fy) = (y, x, fx);
            x = a + SECTION * (b - a);
            fx = f(x);
        } else {
            (a, x, fx) = (x, y, fy);
            y = b - SECTION * (b - a);
            fy = f(y);
        }
    }
    None
}

/// Returns the first zero within h at which a positive function becomes negative, found from a few
/// samples. A function that is not positive at the start must become positive first.
pub(crate) fn vanishing(f: impl Fn(f64) -> f64, h: f64) -> Option<f64> {
    /// Number of intervals between the samples.
    const LOOKS: usize = 8;
    let looks: [[f64; 2]; LOOKS + 1] = core::array::from_fn(|k| {
        let t = h * k as f64 / LOOKS as f64;
        [t, f(t)]
    });
    for (k, pair) in looks.windows(2).enumerate() {
        let &[[from, before], [to, now]] = pair else { continue };
        if !(before > 0.0) {
            continue;
        }
        if now < 0.0 {
            return Some(root(&f, [from, to], [before, now]));
        }
        // The function may be negative between two samples where it is not, if it has a minimum
        // near one of them.
        if let Some(&[end, next]) = looks.get(k + 2)
            && now < before
            && now < next
            && now < 0.25 * before.max(next)
            && let Some(there) = dip(&f, [from, end])
        {
            return Some(root(&f, [from, there], [before, f(there)]));
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_zero_is_found_to_rounding_in_a_handful_of_evaluations() {
        type Case = (fn(f64) -> f64, [f64; 2], f64, u32);
        let functions: [Case; 4] = [
            (|x| x * x - 2.0, [0.3, 2.9], core::f64::consts::SQRT_2, 14),
            (|x| x.exp() - 7.0, [-3.0, 8.0], 1.945_910_149_055_313_3, 16),
            (|x| 1234.5 - x, [17.0, 5001.0], 1234.5, 14),
            // As flat as a triple zero: bisection.
            (|x| (x - 0.7).powi(3), [0.1, 1.9], 0.7, 56),
        ];
        for (f, bracket, zero, most) in functions {
            let mut count = 0;
            let counted = |x| {
                count += 1;
                f(x)
            };
            let found = root(counted, bracket, bracket.map(f));
            assert!((found - zero).abs() <= 2.0 * f64::EPSILON * zero.abs(), "{found} {zero}");
            assert!(count <= most, "{count} evaluations of {zero}");
        }
    }

    #[test]
    fn a_bracket_ends_at_its_ends() {
        assert_eq!(root(|x| x, [0.0, 1.0], [0.0, 1.0]), 0.0);
        assert_eq!(root(|x| x - 1.0, [0.0, 1.0], [-1.0, 0.0]), 1.0);
        let above = 1.0 + f64::EPSILON;
        assert_eq!(root(|_| f64::NAN, [1.0, above], [-1.0, 3.0]), 1.0);
    }

    #[test]
    fn a_dip_is_found_if_there_is_one() {
        let valley = |depth: f64| move |x: f64| (x - 0.3).powi(2) - depth;
        let place = dip(valley(1e-12), [-1.0, 2.0]).unwrap();
        assert!((place - 0.3).abs() <= 1e-6);
        assert!(dip(valley(-1e-12), [-1.0, 2.0]).is_none());
    }
}
