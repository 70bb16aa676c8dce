//! Sparklines: a curve in one line of text.

use polhode::body::PrincipalFrame;
use polhode::math::Body;

/// Default width of a sparkline, columns.
pub const COLUMNS: usize = 72;

/// Returns the width of a sparkline on a terminal, columns. Its name and end time take the
/// remaining columns.
pub fn fitting(terminal: usize) -> usize {
    const BESIDE: usize = 17 + 14;
    const LEAST: usize = 8;
    // A longer line is no longer legible as a picture.
    const MOST: usize = 160;
    terminal.saturating_sub(BESIDE).clamp(LEAST, MOST)
}

/// Sparkline of the component of ω along the principal axis that varies most.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Sparkline {
    /// Number of the principal axis: 1, 2 or 3.
    pub axis: usize,
    /// Characters of eight heights, from the least to the greatest value.
    pub line: String,
    /// Number of values shown, from the first on; more turning points would not be visible.
    pub values: usize,
}

impl Sparkline {
    /// Creates the sparkline of ω along the principal axes at equally spaced times; `None` if it
    /// varies only by rounding.
    pub fn of_omega(omega: &[[f64; 3]], columns: usize) -> Option<Self> {
        let component = |k: usize| omega.iter().filter_map(move |w| w.get(k).copied());
        let span = |k: usize| {
            component(k).fold(f64::NEG_INFINITY, f64::max) - component(k).fold(f64::INFINITY, f64::min)
        };
        let most = (0..3).fold(0, |best, k| if span(k) > span(best) { k } else { best });
        let values: Vec<f64> = component(most).collect();
        let shown = values.get(..resolved(&values, columns / 4))?;
        let speed = omega.first().map_or(0.0, |[x, y, z]| x.hypot(*y).hypot(*z));
        let line = sparkline(shown, columns).filter(|_| span(most) > 1e-9 * speed)?;
        Some(Self { axis: most + 1, line, values: shown.len() })
    }
}

impl Sparkline {
    /// Returns the name of the component: `ωz (axis 2)` if the principal axis is the z axis of the
    /// body, `−ωz (axis 2)` if it is opposite, else `ω along axis 2`.
    pub fn label(&self, principal: &PrincipalFrame<Body>) -> String {
        let direction = principal.axis(self.axis - 1).to_array();
        let along = ["x", "y", "z"].into_iter().zip(direction).find(|(_, c)| c.abs() > ALIGNED);
        match along {
            Some((name, c)) if c > 0.0 => format!("ω{name} (axis {})", self.axis),
            Some((name, _)) => format!("−ω{name} (axis {})", self.axis),
            None => format!("ω along axis {}", self.axis),
        }
    }
}

/// Smallest cosine at which two axes count as parallel: within 1e-6 rad.
const ALIGNED: f64 = 1.0 - 5e-13;

/// Returns the number of values, from the first on, with at most `turns` turning points.
fn resolved(values: &[f64], turns: usize) -> usize {
    let is_turn = |w: &&[f64]| matches!(w, [a, b, c] if (b - a) * (c - b) < 0.0);
    let mut turning = values.windows(3).enumerate().filter(|(_, w)| is_turn(w));
    turning.nth(turns).map_or(values.len(), |(k, _)| k + 1)
}

/// Draws a curve in eight heights from its least to its greatest value; `None` for a constant.
fn sparkline(values: &[f64], columns: usize) -> Option<String> {
    const HEIGHTS: [char; 8] = ['▁', '▂', '▃', '▄', '▅', '▆', '▇', '█'];
    let (least, greatest) =
        values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), &x| (a.min(x), b.max(x)));
    let span = greatest - least;
    if values.len() < 2 || !span.is_finite() || span <= 1e-9 * greatest.abs().max(least.abs()) {
        return None;
    }
    let columns = columns.min(values.len());
    let at = |k: usize| values.get(k * (values.len() - 1) / (columns - 1).max(1)).copied();
    let height = |x: f64| HEIGHTS.get((((x - least) / span * 8.0) as usize).min(7)).copied();
    Some((0..columns).filter_map(|k| at(k).and_then(height)).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn eight_heights_from_least_to_greatest() {
        assert_eq!(sparkline(&[1.0, 1.0], 10), None);
        assert_eq!(sparkline(&[0.0, 1.0, 2.0, 3.0], 4).as_deref(), Some("▁▃▆█"));
        assert_eq!(sparkline(&[3.0, f64::NAN, 1.0], 3).map(|line| line.chars().count()), Some(3));
    }

    #[test]
    fn the_component_that_varies_most_is_shown_as_far_as_it_is_seen() {
        // Ten periods of component 3 in 1000 values; at least 2 columns per turning point.
        let omega: Vec<[f64; 3]> = (0..1000)
            .map(|k| 2.0 * std::f64::consts::PI * 0.01 * f64::from(k))
            .map(|a| [0.3 + 0.1 * a.sin(), -2.0, 0.7 * a.cos()])
            .collect();
        let wide = Sparkline::of_omega(&omega, 160).unwrap();
        assert_eq!((wide.axis, wide.values, wide.line.chars().count()), (3, 1000, 160));
        let narrow = Sparkline::of_omega(&omega, 20).unwrap();
        assert_eq!(narrow.line.chars().count(), 20);
        assert!((250..350).contains(&narrow.values), "{}", narrow.values);
        assert_eq!(Sparkline::of_omega(&[[1.0, 2.0, 3.0]; 9], 20), None);
        assert_eq!(Sparkline::of_omega(&[], 20), None);
    }

    #[test]
    fn a_line_fits_its_terminal() {
        assert_eq!([0, 40, 80, 100, 1000].map(fitting), [8, 9, 49, 69, 160]);
    }
}
