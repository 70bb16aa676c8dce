//! Gradients of moments, rotations and tilts compared with differences, and cases without a
//! derivative.

use polhode::body::{InertiaTensor, MassProperties, MassPropertiesGradient};
use polhode::math::{Body, Direction, Position};
use polhode_budget::{
    Basis, Estimate, GivenPart, GivenTensor, PartUncertainty, PartsList, Row, Spread, Uncertainty,
};

use crate::lists::{case, list};

fn estimate() -> Estimate<Body> {
    list(&case("nested")).budget().unwrap().estimate(Basis::Basic).unwrap()
}

/// Returns the estimate with one element of the tensor changed by h.
fn moved(of: &Estimate<Body>, element: usize, h: f64) -> Estimate<Body> {
    let mut rows = of.properties.inertia().matrix();
    let (i, j) = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)][element];
    rows[i][j] += h;
    rows[j][i] = rows[i][j];
    let inertia = InertiaTensor::from_matrix(rows).unwrap();
    let properties =
        MassProperties::new(of.properties.mass(), of.properties.center_of_mass(), inertia).unwrap();
    Estimate { properties, covariance: of.covariance }
}

/// Returns the derivatives with respect to the six elements, by differences of fourth order.
fn slopes(of: &Estimate<Body>, number: impl Fn(&Estimate<Body>) -> f64) -> [f64; 6] {
    let h = 1e-4 * of.properties.principal().moments()[0];
    core::array::from_fn(|element| {
        let at = |steps: f64| number(&moved(of, element, steps * h));
        (8.0 * (at(1.0) - at(-1.0)) - (at(2.0) - at(-2.0))) / (12.0 * h)
    })
}

fn close(gradient: &MassPropertiesGradient<Body>, slopes: [f64; 6]) {
    let size = slopes.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    for (got, want) in gradient.by_inertia.iter().zip(slopes) {
        assert!((got - want).abs() < 1e-8 * size, "{gradient:?} {slopes:?}");
    }
}

#[test]
fn gradients_are_those_of_differences() {
    let whole = estimate();
    let principal = whole.principal();
    let n = Direction::new(0.3, -0.5, 0.7);
    for k in 0..3 {
        close(&principal.moment_gradient(k), slopes(&whole, |e| e.properties.principal().moments()[k]));
        // a rotation about axis k takes axis i towards axis j
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        let towards = principal.frame.axis(j);
        close(
            &principal.turn_gradient(k).unwrap(),
            slopes(&whole, |e| e.properties.principal().axis(i).dot(towards)),
        );
        let tilt = principal.tilt(&whole, k, n).unwrap();
        let angle = |e: &Estimate<Body>| {
            let angle = e.properties.principal().axis(k).angle_to(n);
            angle.min(core::f64::consts::PI - angle)
        };
        assert!((tilt.angle - angle(&whole)).abs() < 1e-14);
        close(&tilt.gradient.unwrap(), slopes(&whole, angle));
        assert!(tilt.sd.unwrap() <= tilt.axis_sd);
        let from_itself = principal.tilt(&whole, k, principal.frame.axis(k)).unwrap();
        assert!(from_itself.angle < 1e-15 && from_itself.axis_sd == tilt.axis_sd);
        assert_eq!(principal.tilt(&whole, k, Direction::ZERO), None);
    }
}

#[test]
fn covariances_are_those_of_the_gradients() {
    let whole = estimate();
    let principal = whole.principal();
    for k in 0..3 {
        let sd = whole.sd_of(&principal.moment_gradient(k));
        assert!((principal.moment_covariance[k][k].sqrt() / sd - 1.0).abs() < 1e-12);
        let turn = whole.sd_of(&principal.turn_gradient(k).unwrap());
        assert!((principal.turn_sd[k] / turn - 1.0).abs() < 1e-12);
    }
    // i1 + i2 + i3 = Ixx + Iyy + Izz
    let sum: f64 = principal.moment_covariance.iter().flatten().sum();
    let trace: f64 = (4..7).map(|i| (4..7).map(|j| whole.covariance[i][j]).sum::<f64>()).sum();
    assert!((sum / trace - 1.0).abs() < 1e-12);
}

#[test]
fn equal_moments_leave_axes_that_are_not_known() {
    let tensor = GivenTensor { moments: [2.0, 2.0, 3.0], ..GivenTensor::ZERO };
    let sd = |sd: f64| PartUncertainty::Separate {
        mass: 0.0,
        tensor_follows_mass: true,
        center: Spread::Exact,
        tensor: Spread::Deviations([sd; 6]),
    };
    let whole = |part| {
        let row = Row::part(
            "wheel",
            GivenPart { mass: 4.0, center_of_mass: Position::ZERO, tensor: tensor.clone() },
        );
        let row = Row { uncertainty: Uncertainty { part, ..Uncertainty::default() }, ..row };
        PartsList { rows: vec![row], ..PartsList::default() }
            .budget()
            .unwrap()
            .estimate(Basis::Basic)
            .unwrap()
    };
    let uncertain = whole(sd(0.01));
    let principal = uncertain.principal();
    assert_eq!(principal.turn_sd[2], f64::INFINITY);
    assert!((principal.turn_sd[0] - 0.01).abs() < 1e-15 && (principal.turn_sd[1] - 0.01).abs() < 1e-15);
    assert_eq!(principal.turn_gradient(2), None);
    // the axis of symmetry is determined; the axes perpendicular to it are not
    let z = principal.tilt(&uncertain, 2, Direction::new(0.0, 0.6, 0.8)).unwrap();
    assert!((z.sd.unwrap() - 0.01).abs() < 1e-15 && (z.axis_sd - 0.01).abs() < 1e-15);
    let x = principal.tilt(&uncertain, 0, Direction::new(0.0, 0.6, 0.8)).unwrap();
    assert_eq!((x.sd, x.axis_sd, x.gradient), (None, f64::INFINITY, None));
    assert_eq!(whole(sd(0.0)).principal().turn_sd, [0.0; 3]);
}
