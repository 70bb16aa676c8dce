//! Values as text, and as types of other crates.

#![allow(clippy::unwrap_used, reason = "in a test that is a failure")]

use polhode::body::{BodyError, InertiaTensor, MassProperties};
use polhode::math::{Attitude, Body, Direction, Position, Velocity};
use polhode::motion::State;

fn tensor() -> InertiaTensor<Body> {
    InertiaTensor::with_negative_products([2.5, 3.25, 4.125], [0.3, -0.2, 0.1]).unwrap()
}

fn attitude() -> Attitude {
    Attitude::from_axis_angle(Direction::new(0.3, -0.5, 0.7), 1.1).unwrap()
}

fn body() -> MassProperties<Body> {
    MassProperties::new(1.75, Position::new(0.1, -0.2, 0.3), tensor()).unwrap()
}

#[test]
fn values_are_shown_with_their_units() {
    assert_eq!(
        body().to_string(),
        "mass 1.75 kg, centre of mass (0.1, -0.2, 0.3) m, inertia tensor \
         [(2.5, 0.3, -0.2), (0.3, 3.25, 0.1), (-0.2, 0.1, 4.125)] kg·m²"
    );
    let about = format!("{:.3}", body().inertia_about(Position::ZERO));
    assert!(
        about.starts_with("[(2.728, 0.335, -0.253), ")
            && about.ends_with(" kg·m² about (0.000, 0.000, 0.000) m"),
        "{about}"
    );
    let small = InertiaTensor::<Body>::diagonal([2e-47, 3e-47, 4e-47]).unwrap();
    assert!(small.to_string().starts_with("[(2e-47, 0, 0), "));
    assert!(
        format!("{:.2}", body().principal()).starts_with("moments (2.37, 3.35, 4.15) kg·m², axes ("),
        "{:.2}",
        body().principal()
    );
}

#[test]
fn components_are_found_by_their_numbers() {
    let v: Velocity<Body> = [1.0, -2.0, 3.0].into();
    assert_eq!([v[0], v[1], v[2]], [1.0, -2.0, 3.0]);
    let (tensor, rows) = (tensor(), tensor().matrix());
    for (i, j) in (0..9).map(|k| (k / 3, k % 3)) {
        assert_eq!(tensor[(i, j)], rows[i][j]);
        assert_eq!(
            body().inertia_about(Position::ZERO)[(i, j)],
            body().inertia_about(Position::ZERO).matrix()[i][j]
        );
    }
}

/// Round trip, and refusal of impossible values: each crate has its own types and the same
/// conversions.
macro_rules! there_and_back {
    ($name:ident, $vector:ty, $quaternion:ty, $matrix:ty, $components:expr, $turned:expr) => {
        #[test]
        fn $name() {
            let (v, q) = (Velocity::<Body>::new(0.1, -0.2, 0.3), attitude());
            let theirs: $vector = v.into();
            let components: fn(&$vector) -> [f64; 3] = $components;
            assert_eq!(components(&theirs), v.to_array());
            assert_eq!(Velocity::<Body>::from(theirs), v);
            let rotation: $quaternion = q.into();
            let turned: fn(&$quaternion, &$vector) -> Option<[f64; 3]> = $turned;
            if let Some(turned) = turned(&rotation, &theirs) {
                let ours = (q * v).to_array();
                assert!((0..3).all(|k| (turned[k] - ours[k]).abs() < 1e-15), "{turned:?} {ours:?}");
            }
            assert!(Attitude::try_from(rotation).unwrap().angle_to(q) < 1e-15);
            let matrix: $matrix = tensor().into();
            assert_eq!(InertiaTensor::<Body>::try_from(matrix), Ok(tensor()));
        }
    };
}

there_and_back!(
    mint,
    mint::Vector3<f64>,
    mint::Quaternion<f64>,
    mint::RowMatrix3<f64>,
    |v| [v.x, v.y, v.z],
    |_, _| None
);
there_and_back!(
    nalgebra,
    nalgebra::Vector3<f64>,
    nalgebra::UnitQuaternion<f64>,
    nalgebra::Matrix3<f64>,
    |v| [v[0], v[1], v[2]],
    |q, v| Some((q * v).into())
);
there_and_back!(glam, glam::DVec3, glam::DQuat, glam::DMat3, |v| [v.x, v.y, v.z], |q, v| Some(
    (*q * *v).into()
));

#[test]
fn no_impossible_value_comes_from_another_crate() {
    let flat = nalgebra::Matrix3::from_diagonal(&[1.0, 1.0, 3.0].into());
    assert!(InertiaTensor::<Body>::try_from(flat).is_err());
    let oblique = glam::DMat3::from_cols_array_2d(&[[2.0, 0.1, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 2.0]]);
    assert!(matches!(InertiaTensor::<Body>::try_from(oblique), Err(BodyError::NotSymmetric { .. })));
    assert!(Attitude::try_from(glam::DQuat::from_xyzw(0.0, 0.0, 0.0, 0.0)).is_err());
    assert!(Attitude::try_from(mint::Quaternion { s: f64::NAN, v: [0.0; 3].into() }).is_err());
}

#[derive(Debug, PartialEq, serde::Serialize, serde::Deserialize)]
struct Everything {
    body: MassProperties<Body>,
    state: State,
}

#[test]
fn what_is_written_is_read_again() {
    let state = State { time: 0.7, attitude: attitude(), omega: [0.1, 0.2, -0.3].into() };
    let everything = Everything { body: body(), state };
    let text = toml::to_string(&everything).unwrap();
    assert!(text.contains("center_of_mass = [0.1, -0.2, 0.3]"), "{text}");
    assert_eq!(toml::from_str::<Everything>(&text).unwrap(), everything);
    for (good, bad, why) in [
        ("mass = 1.75", "mass = -1.75", "the mass"),
        ("[[2.5, ", "[[9.5, ", "impossible"),
        ("mass = 1.75", "mass = 1.75\ncolour = 1", "colour"),
    ] {
        assert!(text.contains(good), "{text}");
        let refused = toml::from_str::<Everything>(&text.replace(good, bad)).unwrap_err().to_string();
        assert!(refused.contains(why), "{refused}");
    }
}
