//! Lists in general position compared with independent sums of many digits (fixtures/budget.py).

use polhode::body::{MassProperties, MassPropertiesGradient};
use polhode::math::{Body, Direction, Part, Position, Rotation};
use polhode_budget::{
    Basis, GivenPart, GivenTensor, NUMBERS, PartUncertainty, PartsList, Place, ProductSign, Row, Source,
    Spread, TensorPoint, Uncertainty,
};

use crate::lists::{cases, list, numbers};

const BASES: [(Basis, &str); 2] = [(Basis::Basic, "basic"), (Basis::Predicted, "predicted")];

fn ten(body: &MassProperties<Body>) -> [f64; 10] {
    let [x, y, z] = body.center_of_mass().to_array();
    let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = body.inertia().matrix();
    [body.mass(), x, y, z, xx, yy, zz, xy, xz, yz]
}

fn rows(value: &toml::Value) -> [[f64; 10]; 10] {
    let rows: Vec<_> = value.as_array().unwrap().iter().map(numbers::<10>).collect();
    rows.try_into().unwrap()
}

#[test]
fn mass_centre_tensor_and_moments() {
    for case in cases() {
        let budget = list(&case).budget().unwrap();
        for (basis, key) in BASES {
            let body = budget.mass_properties(basis).unwrap();
            let expected = numbers::<10>(&case[key]);
            // relative to the largest number of the same kind; centres 30 m away have their own
            // rounding error
            let largest = expected[4..].iter().fold(0.0, |most: f64, x| most.max(x.abs()));
            let scale = |k: usize| match k {
                0 => expected[0],
                1..4 => expected[1..4].iter().fold(1.0, |most: f64, x| most.max(x.abs())),
                _ => largest,
            };
            for (k, (got, want)) in ten(&body).into_iter().zip(expected).enumerate() {
                let error = (got - want).abs() / scale(k);
                assert!(error < 1e-12, "{} {key} {}: {got} {want}", case["name"], NUMBERS[k].0);
            }
            let moments = numbers::<3>(&case[&format!("{key}_moments")]);
            for (got, want) in body.principal().moments().into_iter().zip(moments) {
                assert!((got - want).abs() < 1e-12 * moments[2]);
            }
        }
    }
}

#[test]
fn the_full_covariance() {
    for case in cases() {
        let budget = list(&case).budget().unwrap();
        for (basis, key) in BASES {
            let estimate = budget.estimate(basis).unwrap();
            let expected = rows(&case[&format!("{key}_covariance")]);
            for i in 0..10 {
                for j in 0..10 {
                    let (got, want) = (estimate.covariance[i][j], expected[i][j]);
                    let size = (expected[i][i] * expected[j][j]).sqrt();
                    assert!(
                        (got - want).abs() < 1e-11 * size,
                        "{} {key} {i} {j}: {got} {want}",
                        case["name"]
                    );
                }
            }
        }
    }
}

#[test]
fn a_tensor_about_the_origin_of_another_frame() {
    let turn = |wxyz| Rotation::<Part, Part>::from_quaternion(wxyz).unwrap();
    let (a, b) = (turn([0.4, -0.7, 1.1, 0.3]), turn([-0.2, 0.9, 0.5, 1.3]));
    let frame = |name: &str, position: [f64; 3], rotation| Row {
        place: Place { position: Position::from_array(position), rotation },
        ..Row::frame(name)
    };
    let whole = |tensor| {
        let part = GivenPart { mass: 1.7, center_of_mass: Position::new(0.1, -0.05, 0.2), tensor };
        let rows = vec![
            frame("r", [0.0; 3], Rotation::identity()),
            frame("r/a", [0.5, -0.3, 0.8], a),
            Row { part: Some(part), ..frame("r/a/b", [-0.2, 0.6, 0.1], b) },
            frame("r/c", [1.1, 0.4, -0.7], turn([0.1, 0.2, 0.3, 0.4])),
        ];
        PartsList { rows, ..PartsList::default() }.budget().unwrap().mass_properties(Basis::Basic).unwrap()
    };
    let center = GivenTensor {
        moments: [0.31, 0.42, 0.53],
        products: [0.04, -0.03, 0.02],
        sign: ProductSign::NegativeIntegral,
        about: TensorPoint::CenterOfMass,
    };
    let expected = whole(center.clone());
    // J of the body about that origin, along the part's axes: Rᵀ J R
    let (j, r) = (expected.inertia_about(Position::new(1.1, 0.4, -0.7)).matrix(), (a * b).matrix());
    let element = |p: usize, q: usize| -> f64 {
        (0..3).map(|i| (0..3).map(|k| r[i][p] * j[i][k] * r[k][q]).sum::<f64>()).sum()
    };
    let elsewhere = GivenTensor {
        moments: [element(0, 0), element(1, 1), element(2, 2)],
        products: [-element(0, 1), -element(0, 2), -element(1, 2)],
        sign: ProductSign::PositiveIntegral,
        about: TensorPoint::OriginOf("r/c".to_owned()),
    };
    for (got, want) in ten(&whole(elsewhere)).into_iter().zip(ten(&expected)) {
        assert!((got - want).abs() < 1e-14, "{got} {want}");
    }
}

#[test]
fn a_joint_covariance_says_the_same_as_deviations() {
    for case in cases() {
        let whole = |list: PartsList| list.budget().unwrap().estimate(Basis::Basic).unwrap();
        let (mut separate, mut joint) = (list(&case), list(&case));
        for (row, other) in separate.rows.iter_mut().zip(&mut joint.rows) {
            let PartUncertainty::Separate { mass, tensor_follows_mass, center, tensor } =
                &mut row.uncertainty.part
            else {
                unreachable!()
            };
            *tensor_follows_mass = false;
            let (Spread::Deviations(center), Spread::Deviations(tensor)) = (center, tensor) else {
                unreachable!()
            };
            let sd: Vec<f64> = [*mass].iter().chain(&*center).chain(&*tensor).copied().collect();
            let square =
                core::array::from_fn(|i| core::array::from_fn(|j| if i == j { sd[i] * sd[i] } else { 0.0 }));
            other.uncertainty.part = PartUncertainty::Joint(Box::new(square));
        }
        let (one, other) = (whole(separate), whole(joint));
        for k in 0..10 {
            assert!((one.sd(k) / other.sd(k) - 1.0).abs() < 1e-12);
        }
    }
}

#[test]
fn other_points_and_axes() {
    for case in cases() {
        let budget = list(&case).budget().unwrap();
        let estimate = budget.estimate(Basis::Basic).unwrap();
        // All uncertain axes are rotated with the root, so the whole list is in other axes.
        let r = Rotation::<Part, Part>::from_quaternion([0.4, -0.7, 1.1, 0.3]).unwrap();
        let along = Rotation::<Body, Body>::from_quaternion(r.quaternion()).unwrap();
        let mut turned = list(&case);
        let root = &mut turned.rows[budget.root()];
        root.place.rotation = r * root.place.rotation;
        root.place.position = r * root.place.position;
        for spread in [&mut root.uncertainty.position, &mut root.uncertainty.rotation] {
            let Spread::Deviations(sd) = spread else { unreachable!() };
            let m = r.matrix();
            let square = |i: usize, j: usize| (0..3).map(|k| m[i][k] * sd[k] * sd[k] * m[j][k]).sum();
            *spread = Spread::Covariance(Box::new(core::array::from_fn(|i| {
                core::array::from_fn(|j| square(i, j))
            })));
        }
        // The Cholesky factors by which a group shares errors depend on the axes.
        root.group = None;
        let mut reference = list(&case);
        reference.rows[budget.root()].group = None;
        let reference = reference.budget().unwrap().estimate(Basis::Basic).unwrap().along(along);
        let turned = turned.budget().unwrap().estimate(Basis::Basic).unwrap();
        for i in 0..10 {
            for j in 0..10 {
                let size = reference.sd(i) * reference.sd(j);
                assert!((reference.covariance[i][j] - turned.covariance[i][j]).abs() < 1e-11 * size);
            }
        }
        // About a point: J, and its variance along an axis through the point, by the gradient of nᵀ
        // J n.
        let point = Position::new(0.7, -0.4, 1.3);
        let about = estimate.about_point(point);
        let n = Direction::<Body>::new(0.48, -0.6, 0.64);
        let d = estimate.properties.center_of_mass() - point;
        let mass = estimate.properties.mass();
        let (along, n) = (d.dot(n), n.to_array());
        let gradient = MassPropertiesGradient {
            by_mass: d.dot(d) - along * along,
            by_center_of_mass: Direction::from_array(core::array::from_fn(|k| {
                2.0 * mass * (d.to_array()[k] - along * n[k])
            })),
            by_inertia: by_axis(n),
        };
        let direct = estimate.sd_of(&gradient);
        let [xx, yy, zz, xy, xz, yz] = by_axis(n);
        let row = [0.0, 0.0, 0.0, 0.0, xx, yy, zz, xy, xz, yz];
        let variance: f64 =
            (0..10).map(|i| (0..10).map(|j| row[i] * about.covariance[i][j] * row[j]).sum::<f64>()).sum();
        assert!((variance.sqrt() / direct - 1.0).abs() < 1e-10, "{} {direct}", variance.sqrt());
    }
}

/// Returns the gradient of nᵀ J n with respect to xx, yy, zz, xy, xz, yz.
fn by_axis([x, y, z]: [f64; 3]) -> [f64; 6] {
    [x * x, y * y, z * z, 2.0 * x * y, 2.0 * x * z, 2.0 * y * z]
}

/// Returns the gradient of a coordinate of the centre of mass.
fn center(k: usize) -> MassPropertiesGradient<Body> {
    MassPropertiesGradient {
        by_mass: 0.0,
        by_center_of_mass: Direction::from_array(core::array::from_fn(|i| f64::from(u8::from(i == k)))),
        by_inertia: [0.0; 6],
    }
}

#[test]
fn sensitivities_come_to_the_variance() {
    for case in cases() {
        let budget = list(&case).budget().unwrap();
        let estimate = budget.estimate(Basis::Predicted).unwrap();
        let principal = estimate.principal();
        let gradients =
            [center(0), center(2), principal.moment_gradient(1), principal.turn_gradient(2).unwrap()];
        let all = budget.sensitivities(Basis::Predicted, &gradients, 1000).unwrap();
        let few = budget.sensitivities(Basis::Predicted, &gradients, 2).unwrap();
        for ((gradient, found), few) in gradients.iter().zip(&all).zip(few) {
            assert_eq!((found.others, found.rest), (0, 0.0));
            let found = &found.greatest;
            // If few contributions are requested, the others are a sum.
            assert_eq!(few.greatest, found[..2]);
            assert_eq!(few.others, found.len() - 2);
            let others: f64 = found[2..].iter().map(|one| one.variance).sum();
            assert!((few.rest - others).abs() < 1e-12 * found[0].variance);
            let sum: f64 = found.iter().map(|one| one.variance).sum();
            assert!((sum.sqrt() / estimate.sd_of(gradient) - 1.0).abs() < 1e-12);
            assert!(found.is_sorted_by(|a, b| a.variance >= b.variance));
            assert!(found.iter().any(|one| matches!(one.source, Source::Group(_))));
        }
    }
}

#[test]
fn without_the_row_that_matters_most_the_variance_is_less_by_its_part() {
    for case in cases() {
        let mut alone = list(&case);
        alone.rows.iter_mut().for_each(|row| row.group = None);
        let budget = alone.clone().budget().unwrap();
        let estimate = budget.estimate(Basis::Predicted).unwrap();
        let all = budget.sensitivities(Basis::Predicted, &[center(0)], 1000).unwrap().remove(0).greatest;
        let worst = all.iter().find(|one| matches!(one.source, Source::Row(_))).unwrap();
        let Source::Row(row) = worst.source else { unreachable!() };
        let of_row: f64 = all.iter().filter(|one| one.source == worst.source).map(|one| one.variance).sum();
        alone.rows[row].uncertainty = Uncertainty::default();
        let rest = alone.budget().unwrap().estimate(Basis::Predicted).unwrap();
        let difference = estimate.sd(1).powi(2) - rest.sd(1).powi(2);
        assert!((difference / of_row - 1.0).abs() < 1e-10);
    }
}
