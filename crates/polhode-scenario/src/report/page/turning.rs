//! Rotating body with its reference point.

use polhode::body::{BodyPart, PrincipalFrame};
use polhode::math::{Body, Direction, Position};
use polhode::motion::contact::BodySurface;
use polhode_document::json::finite;

use super::PageSubject;

/// Rotating body, with its pivot or centre of mass as the reference point.
#[derive(Debug)]
pub(crate) struct Turning<'a> {
    /// Mass, kg; `None` if only the moments are known.
    pub mass: Option<f64>,
    /// Principal moments and axes about the reference point.
    pub principal: PrincipalFrame<Body>,
    pub tensor: [[f64; 3]; 3],
    pub is_pivoted: bool,
    /// Vector from the reference point to the centre of mass, m.
    pub lever: Position<Body>,
    /// Reference point, m.
    pub point: Position<Body>,
    /// Contact surface, if the body is on the ground.
    pub surface: Option<&'a BodySurface>,
    pub parts: &'a [BodyPart],
    /// Principal moments and axes about the centre of mass.
    pub central: PrincipalFrame<Body>,
    /// True if the body changes with time, so that the values are those at the start.
    pub is_changing: bool,
}

impl<'a> Turning<'a> {
    pub(crate) fn of(subject: &PageSubject<'a>) -> Self {
        match *subject {
            PageSubject::Scenario(scenario) => {
                let (rotor, body) = (scenario.rotor(), scenario.body());
                Self {
                    mass: Some(rotor.mass()),
                    principal: *rotor.principal(),
                    tensor: rotor.inertia().matrix(),
                    is_pivoted: rotor.is_pivoted(),
                    lever: rotor.lever(),
                    point: scenario.pivot().unwrap_or(body.center_of_mass()),
                    surface: scenario.ground().map(|ground| &ground.contact.surface),
                    parts: scenario.parts(),
                    central: PrincipalFrame::of(body.inertia()),
                    is_changing: scenario.history().is_some(),
                }
            }
            PageSubject::Moments(principal) => Self {
                mass: None,
                principal: *principal,
                tensor: tensor(principal),
                is_pivoted: false,
                lever: Position::ZERO,
                point: Position::ZERO,
                surface: None,
                parts: &[],
                central: *principal,
                is_changing: false,
            },
        }
    }

    pub(crate) const fn about(&self) -> &'static str {
        if self.is_pivoted { "pivot" } else { "centre of mass" }
    }
}

/// Returns the semi-axes of the uniform ellipsoid with this mass and these moments, i1 = m (b² +
/// c²) / 5, …
///
/// Unphysical moments give a semi-axis of 0.
pub(crate) fn ellipsoid([i1, i2, i3]: [f64; 3], mass: f64) -> [f64; 3] {
    let semi_axis = |others: f64, own: f64| finite((2.5 / mass * (others - own).max(0.0)).sqrt());
    [semi_axis(i2 + i3, i1), semi_axis(i1 + i3, i2), semi_axis(i1 + i2, i3)]
}

/// Returns the edges of the uniform box with this mass and these moments, i1 = m (b² + c²) / 12, …
///
/// `None` if no box has these moments, or an edge is outside the range of f64.
pub fn equivalent_box([i1, i2, i3]: [f64; 3], mass: f64) -> Option<[f64; 3]> {
    // Rounding error; the thickness of a plate may be slightly negative.
    let rounding = 1e-12 * i3;
    let square = |others: f64, own: f64| {
        let excess = others - own;
        let excess = if excess.abs() <= rounding { 0.0 } else { excess };
        6.0 * excess / mass
    };
    let squares = [square(i2 + i3, i1), square(i1 + i3, i2), square(i1 + i2, i3)];
    squares.iter().all(|square| *square >= 0.0 && square.is_finite()).then(|| squares.map(f64::sqrt))
}

/// Returns the inertia tensor Σ i e eᵀ from its moments i and axes e.
fn tensor(principal: &PrincipalFrame<Body>) -> [[f64; 3]; 3] {
    let axes = principal.axes().map(Direction::to_array);
    let moments = principal.moments();
    std::array::from_fn(|i| {
        std::array::from_fn(|j| moments.iter().zip(&axes).map(|(moment, e)| moment * e[i] * e[j]).sum())
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_box_has_the_moments() {
        // The two-point Gauss rule, ±½a/√3 on each axis, integrates x² + y² exactly over a uniform
        // box.
        let ([a, b, c], mass) = ([0.31, 0.53, 0.74_f64], 2.3);
        let signs = |k: u32| [k & 1, k >> 1 & 1, k >> 2 & 1].map(|bit| 2.0 * f64::from(bit) - 1.0);
        let point = |k: u32| -> [f64; 3] {
            std::array::from_fn(|i| signs(k)[i] * 0.5 * [a, b, c][i] / 3.0_f64.sqrt())
        };
        let moment = |i: usize, j: usize| {
            (0..8).map(|k| mass / 8.0 * (point(k)[i].powi(2) + point(k)[j].powi(2))).sum::<f64>()
        };
        let moments = [moment(0, 1), moment(0, 2), moment(1, 2)];
        let edges = equivalent_box(moments, mass).unwrap();
        for (found, edge) in edges.iter().zip([c, b, a]) {
            assert!((found - edge).abs() < 1e-14, "{edges:?}");
        }
        assert_eq!(equivalent_box([1.0, 2.0, 3.0], 1.0), Some([24.0_f64.sqrt(), 12.0_f64.sqrt(), 0.0]));
        assert_eq!(equivalent_box([1.0, 1.0, 2.5], 1.0), None);
    }

    #[test]
    fn the_ellipsoid_has_the_moments() {
        let [a, b, c] = [0.3, 0.5, 0.7_f64];
        let moments = [b * b + c * c, a * a + c * c, a * a + b * b].map(|sum| 2.3 / 5.0 * sum);
        let semi_axes = ellipsoid([moments[2], moments[1], moments[0]], 2.3);
        for (found, wanted) in semi_axes.into_iter().zip([c, b, a]) {
            assert!((found - wanted).abs() < 1e-15, "{found} {wanted}");
        }
        assert_eq!(ellipsoid([1.0, 2.0, 5.0], 1.0)[2], 0.0);
    }
}
