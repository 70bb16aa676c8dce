//! Random mass properties that are always physically consistent.
//!
//! A tensor is physically consistent if and only if its second moments
//! Σ = ∫ x xᵀ dm = ½ tr(I) 1 − I have no negative eigenvalue. Let S be a root of Σ (S Sᵀ = Σ), and
//! E a matrix of independent normal numbers with standard deviation s. Then
//!
//! Σ' = S (1 + E) (1 + E)ᵀ Sᵀ / y,  y = 1 + n s²  (1)
//!
//! has none either, for every E. Since E[(1 + E)(1 + E)ᵀ] = y 1, its mean is Σ. The diagonal
//! elements of (1 + E)(1 + E)ᵀ have the variance 4 s² + 2 n s⁴. So the second moment along every
//! axis has the relative standard deviation
//!
//! d = √(4 s² + 2 n s⁴) / y,  hence  y = 1 / √(1 − n d²/2)  (2)
//!
//! E is isotropic (Q E Qᵀ has the same distribution), so a rotated body has the rotated
//! distribution. n is 3, or 4 if mass and centre of mass are dispersed together with the tensor. In
//! that case (1) applies to the pseudo-inertia about the centre of mass, J = ∫ (x, 1)(x, 1)ᵀ dm,
//! whose last row contains the first moments and the mass.

use polhode::body::{MassProperties, PrincipalFrame};
use polhode::math::Body;
use polhode_scenario::read::Dispersion;

use super::normal;

/// Row or column of E.
type Row<const N: usize> = [f64; N];

/// Mass, centre of mass, and tensor about it: xx, yy, zz, xy, xz, yz.
pub(crate) struct Drawn {
    pub(crate) mass: f64,
    pub(crate) center: [f64; 3],
    pub(crate) tensor: [f64; 6],
}

/// Root of the second moments of a body, with its mass and centre.
#[derive(Clone, Debug)]
pub(crate) struct Root {
    /// Symmetric root of Σ.
    root: [[f64; 3]; 3],
    mass: f64,
    center: [f64; 3],
}

impl Root {
    /// Computes the root for a body.
    pub(crate) fn of(body: &MassProperties<Body>) -> Self {
        let principal = PrincipalFrame::of(body.inertia());
        let moments = principal.moments();
        let half_trace = 0.5 * (moments[0] + moments[1] + moments[2]);
        // `S = Σ_k √σ_k n_k n_kᵀ`; negative σ from rounding are set to zero.
        let mut root = [[0.0; 3]; 3];
        for (k, moment) in moments.into_iter().enumerate() {
            let (n, size) = (principal.axis(k).to_array(), (half_trace - moment).max(0.0).sqrt());
            for (row, a) in root.iter_mut().zip(n) {
                for (element, b) in row.iter_mut().zip(n) {
                    *element += size * a * b;
                }
            }
        }
        Self { root, mass: body.mass(), center: body.center_of_mass().to_array() }
    }

    /// Draws a body from uniform numbers, whose count is
    /// [`Vary::coordinates`](polhode_scenario::read::Vary::coordinates).
    pub(crate) fn draw(&self, dispersion: Dispersion, uniform: &[f64]) -> Drawn {
        match (dispersion, uniform.len()) {
            (Dispersion::Together(d), 16) => self.together(d, uniform),
            (Dispersion::Together(d), _) => {
                Drawn { mass: self.mass, center: self.center, tensor: self.tensor(d, uniform) }
            }
            (Dispersion::Apart { mass, center_of_mass, inertia }, _) => {
                let mut z = uniform.iter().map(|u| normal::quantile(*u));
                let mut next = || z.next().unwrap_or_default();
                // ln m' is normal, and the mean of m' is m: σ² = ln(1 + d²), median m/√(1 + d²).
                let square = mass * mass;
                let factor = libm::exp(libm::log1p(square).sqrt() * next()) / (1.0 + square).sqrt();
                let center = self.center.map(|c| c + center_of_mass * next());
                let tensor = self.tensor(inertia, uniform.get(4..).unwrap_or_default());
                Drawn { mass: self.mass * if mass > 0.0 { factor } else { 1.0 }, center, tensor }
            }
        }
    }

    /// Draws a tensor by (1).
    fn tensor(&self, d: f64, uniform: &[f64]) -> [f64; 6] {
        let (spread, y) = spread::<3>(d, uniform);
        inertia(&product(&self.root, &spread), y)
    }

    /// Draws mass, first moments and second moments by (1).
    fn together(&self, d: f64, uniform: &[f64]) -> Drawn {
        let (spread, y) = spread::<4>(d, uniform);
        let [a, b, c, last] = spread;
        // P (1 + E) with P = diag(S, √m): the last row contains the mass, the others the second
        // moments.
        let last = last.map(|element| self.mass.sqrt() * element);
        let rows = product(&self.root, &[a, b, c]);
        let square = dot(&last, &last);
        // h = Σ_k P_ik P_4k, m' = |P_4|². About the new centre of mass, components along P_4 are
        // removed.
        let along = rows.map(|row| dot(&row, &last) / square);
        let mut across = rows;
        for (row, share) in across.iter_mut().zip(along) {
            for (element, other) in row.iter_mut().zip(last) {
                *element -= share * other;
            }
        }
        let mut center = self.center;
        center.iter_mut().zip(along).for_each(|(c, share)| *c += share);
        Drawn { mass: square / y, center, tensor: inertia(&across, y) }
    }
}

/// Returns 1 + E, and y from (2).
fn spread<const N: usize>(d: f64, uniform: &[f64]) -> ([Row<N>; N], f64) {
    let n = N as f64;
    let y = 1.0 / (1.0 - 0.5 * n * d * d).sqrt();
    let s = ((y - 1.0) / n).sqrt();
    let mut spread = [[0.0; N]; N];
    let mut numbers = uniform.iter();
    for (i, row) in spread.iter_mut().enumerate() {
        for (j, element) in row.iter_mut().enumerate() {
            let z = numbers.next().map_or(0.0, |u| normal::quantile(*u));
            *element = s * z + if i == j { 1.0 } else { 0.0 };
        }
    }
    (spread, y)
}

/// Returns S M for a symmetric S and three rows M.
fn product<const N: usize>(s: &[[f64; 3]; 3], m: &[Row<N>; 3]) -> [Row<N>; 3] {
    s.map(|[a, b, c]| {
        let mut row = [0.0; N];
        for (k, element) in row.iter_mut().enumerate() {
            *element = a * m[0][k] + b * m[1][k] + c * m[2][k];
        }
        row
    })
}

/// Returns I = tr(Σ) 1 − Σ with Σ = B Bᵀ / y: xx, yy, zz, xy, xz, yz.
fn inertia<const N: usize>(b: &[Row<N>; 3], y: f64) -> [f64; 6] {
    let sigma = |i: usize, j: usize| dot(&b[i], &b[j]) / y;
    let [xx, yy, zz] = [sigma(0, 0), sigma(1, 1), sigma(2, 2)];
    [yy + zz, xx + zz, xx + yy, 0.0 - sigma(0, 1), 0.0 - sigma(0, 2), 0.0 - sigma(1, 2)]
}

fn dot<const N: usize>(a: &Row<N>, b: &Row<N>) -> f64 {
    a.iter().zip(b).fold(0.0, |sum, (a, b)| sum + a * b)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use polhode::body::{BodyError, InertiaTensor};
    use polhode::math::{Direction, Position, Rotation};
    use polhode_scenario::read::Sampling;

    use super::super::uniform::{Coordinate, Sets};
    use super::*;

    const DRAWS: u64 = 100_000;

    fn body(moments: [f64; 3]) -> MassProperties<Body> {
        let tensor = InertiaTensor::diagonal(moments).unwrap();
        MassProperties::new(3.2, Position::new(0.3, -0.2, 0.7), tensor).unwrap()
    }

    /// Returns a rotation about a generic axis.
    fn turn() -> Rotation<Body, Body> {
        Rotation::from_axis_angle(Direction::new(0.3, -0.8, 0.5), 1.1).unwrap()
    }

    /// Returns draws of a body.
    fn draws(
        body: &MassProperties<Body>,
        dispersion: Dispersion,
        count: usize,
        seed: u64,
    ) -> impl Iterator<Item = Drawn> {
        let root = Root::of(body);
        let coordinate =
            |k| Coordinate::new(Sampling::MonteCarlo, Sets { count: 1, size: DRAWS }, seed, "body", k, k);
        let coordinates: Vec<_> = (0..count).map(coordinate).collect();
        (0..DRAWS).map(move |member| {
            let uniform: Vec<f64> = coordinates.iter().map(|c| c.uniform(member)).collect();
            root.draw(dispersion, &uniform)
        })
    }

    fn tensor([xx, yy, zz, xy, xz, yz]: [f64; 6]) -> Result<InertiaTensor<Body>, BodyError> {
        InertiaTensor::with_negative_products([xx, yy, zz], [xy, xz, yz])
    }

    /// Returns mean and standard deviation.
    fn moments(values: &[f64]) -> (f64, f64) {
        let n = values.len() as f64;
        let mean = values.iter().sum::<f64>() / n;
        (mean, (values.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / (n - 1.0)).sqrt())
    }

    /// Flat satellite: i1 + i2 − i3 is half of its standard deviation if each moment is drawn with
    /// 10 %.
    const FLAT: [f64; 3] = [1.0, 1.9, 2.7265];

    #[test]
    fn a_flat_satellite_stays_possible_where_elements_drawn_for_themselves_do_not() {
        let satellite = body(FLAT);
        let impossible = |drawn: &Drawn| tensor(drawn.tensor).is_err();
        let together = draws(&satellite, Dispersion::Together(0.1), 9, 1).filter(impossible).count();
        assert_eq!(together, 0);

        let coordinate =
            |k| Coordinate::new(Sampling::MonteCarlo, Sets { count: 1, size: DRAWS }, 1, "elements", k, k);
        let coordinates: Vec<_> = (0..3).map(coordinate).collect();
        let apart = (0..DRAWS)
            .filter(|member| {
                let moment =
                    |k: usize| FLAT[k] * (1.0 + 0.1 * normal::quantile(coordinates[k].uniform(*member)));
                InertiaTensor::<Body>::diagonal([moment(0), moment(1), moment(2)]).is_err()
            })
            .count();
        // Φ(−½) = 30.85 %; the standard deviation of the count is 0.15 %.
        let share = apart as f64 / DRAWS as f64;
        assert!((share - 0.3085).abs() < 0.006, "{share}");
    }

    #[test]
    fn plates_and_rods_stay_possible_however_they_are_turned() {
        for moments in [[1.0, 1.9, 2.9], [0.0, 1.7, 1.7], [1e-9, 1.7, 1.7 + 1e-9], [0.0; 3], [1.0; 3]] {
            let plate = body(moments);
            for (body, d) in [(plate, 0.1), (plate.in_frame(turn()), 0.1), (plate.in_frame(turn()), 0.5)] {
                for (count, dispersion) in [(9, Dispersion::Together(d)), (16, Dispersion::Together(d))] {
                    for drawn in draws(&body, dispersion, count, 2).take(10_000) {
                        let made = tensor(drawn.tensor).and_then(|tensor| {
                            MassProperties::new(drawn.mass, Position::from_array(drawn.center), tensor)
                        });
                        assert!(made.is_ok(), "{moments:?}: {made:?}");
                    }
                }
            }
        }
    }

    /// Returns the second moments of a tensor along axes that are the columns of a rotation.
    fn along(drawn: [f64; 6], axes: Rotation<Body, Body>) -> [[f64; 3]; 3] {
        let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = tensor(drawn).unwrap().in_frame(axes).matrix();
        let half = 0.5 * (xx + yy + zz);
        [[half - xx, -xy, -xz], [-xy, half - yy, -yz], [-xz, -yz, half - zz]]
    }

    #[test]
    fn the_mean_is_the_body_and_the_spread_is_what_is_said() {
        const SIGMA: [f64; 3] = [0.4, 1.1, 2.3];
        let moments_of = [SIGMA[1] + SIGMA[2], SIGMA[0] + SIGMA[2], SIGMA[0] + SIGMA[1]];
        let principal = body(moments_of);
        for (k, (d, turned)) in [(0.1, false), (0.4, false), (0.1, true), (0.4, true)].into_iter().enumerate()
        {
            let (body, back) = if turned {
                (principal.in_frame(turn()), turn().inverse())
            } else {
                (principal, Rotation::identity())
            };
            let sigma: Vec<_> = draws(&body, Dispersion::Together(d), 9, k as u64)
                .map(|drawn| along(drawn.tensor, back))
                .collect();
            let root = (DRAWS as f64).sqrt();
            // Off-diagonal elements by (1): Var A_ij = (2 s² + 3 s⁴)/y², 3 s² = y − 1.
            let y = 1.0 / (1.0 - 1.5 * d * d).sqrt();
            let s2 = (y - 1.0) / 3.0;
            let across = (2.0 * s2 + 3.0 * s2 * s2).sqrt() / y;
            for i in 0..3 {
                for j in i..3 {
                    let element: Vec<f64> = sigma.iter().map(|sigma| sigma[i][j]).collect();
                    let (mean, sd) = moments(&element);
                    let size = (SIGMA[i] * SIGMA[j]).sqrt();
                    let (expected, spread) = if i == j { (size, d) } else { (0.0, across) };
                    assert!((mean - expected).abs() < 4.0 * sd / root, "{d}: mean {mean} of {i}{j}");
                    // The relative error of a standard deviation is about 0.8/√(2n).
                    assert!((sd / size - spread).abs() < 0.012 * spread, "{d}: {} of {i}{j}", sd / size);
                }
            }
        }
    }

    #[test]
    fn mass_and_centre_of_mass_are_dispersed_with_the_tensor() {
        const SIGMA: [f64; 3] = [0.4, 1.1, 2.3];
        let body = body([SIGMA[1] + SIGMA[2], SIGMA[0] + SIGMA[2], SIGMA[0] + SIGMA[1]]);
        let (m, d) = (body.mass(), 0.05);
        let drawn: Vec<_> = draws(&body, Dispersion::Together(d), 16, 5).collect();
        let root = (DRAWS as f64).sqrt();
        let (mean, sd) = moments(&drawn.iter().map(|drawn| drawn.mass).collect::<Vec<_>>());
        assert!((mean - m).abs() < 4.0 * sd / root && (sd / m - d).abs() < 0.012 * d, "{mean}, {sd}");
        // To first order the centre of mass moves by (E_i4 + E_4i) k_i with k_i = √(σ_i/m) and
        // s = d/2.
        let center = body.center_of_mass().to_array();
        for k in 0..3 {
            let (mean, sd) = moments(&drawn.iter().map(|drawn| drawn.center[k]).collect::<Vec<_>>());
            let expected = d * (SIGMA[k] / m).sqrt() / 2.0_f64.sqrt();
            assert!(
                (mean - center[k]).abs() < 4.0 * sd / root && (sd / expected - 1.0).abs() < 0.015,
                "{sd}"
            );
            // The second moment about the nominal centre of mass has the stated mean and deviation.
            let second: Vec<f64> = drawn
                .iter()
                .map(|drawn| {
                    let offset = drawn.center[k] - center[k];
                    along(drawn.tensor, Rotation::identity())[k][k] + drawn.mass * offset * offset
                })
                .collect();
            let (mean, sd) = moments(&second);
            assert!((mean - SIGMA[k]).abs() < 4.0 * sd / root, "{mean}");
            assert!((sd / SIGMA[k] - d).abs() < 0.012 * d, "{sd}");
        }
    }

    #[test]
    fn mass_place_and_tensor_are_dispersed_each_for_itself() {
        let body = body([1.5, 2.7, 3.4]).in_frame(turn());
        let dispersion = Dispersion::Apart { mass: 0.2, center_of_mass: 0.004, inertia: 0.0 };
        let drawn: Vec<_> = draws(&body, dispersion, 13, 6).collect();
        let root = (DRAWS as f64).sqrt();
        let (mean, sd) = moments(&drawn.iter().map(|drawn| drawn.mass).collect::<Vec<_>>());
        assert!((mean - body.mass()).abs() < 4.0 * sd / root && (sd / body.mass() - 0.2).abs() < 0.004);
        assert!(drawn.iter().all(|drawn| drawn.mass > 0.0));
        for (k, c) in body.center_of_mass().to_array().into_iter().enumerate() {
            let (mean, sd) = moments(&drawn.iter().map(|drawn| drawn.center[k]).collect::<Vec<_>>());
            assert!((mean - c).abs() < 4.0 * sd / root && (sd / 0.004 - 1.0).abs() < 0.012);
        }
        // The tensor equals the body's, except for the rounding of its root.
        let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = body.inertia().matrix();
        for (value, expected) in drawn[17].tensor.into_iter().zip([xx, yy, zz, xy, xz, yz]) {
            assert!((value - expected).abs() < 1e-14 * 3.4);
        }
    }
}
