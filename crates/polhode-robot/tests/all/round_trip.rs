//! Round trip: models written by polhode are read back with the same mass, centre and tensor.

use std::path::Path;

use polhode::body::{InertiaTensor, MassProperties};
use polhode::math::{Body, Frame, Part, Position, Rotation};
use polhode_robot::body::{LinkMass, link_mass};
use polhode_robot::read::{ReadOptions, read_text};
use polhode_shape::export;
use polhode_shape::{ExportBody, ExportFormat};

const FORMATS: [ExportFormat; 4] =
    [ExportFormat::Urdf, ExportFormat::Sdf, ExportFormat::Mjcf, ExportFormat::MjcfPrincipal];

/// Returns the only link of a model.
fn body_of(text: &str, file: &str) -> MassProperties<Part> {
    let model = read_text(text, Path::new(file), &ReadOptions::default()).unwrap();
    let [link] = model.links.as_slice() else { panic!("{} links", model.links.len()) };
    let LinkMass::Body(body) = link_mass(model.format, link).unwrap() else { panic!("no mass in {text}") };
    assert_eq!(body.rounding, 0.0);
    body.properties
}

/// Returns generic bodies: different moments, all products, every combination of their signs, from
/// grains to ships.
fn bodies() -> Vec<MassProperties<Body>> {
    let shapes = [
        ([3.1, 4.2, 5.3], [0.4, -0.3, 0.2]),
        ([0.268_209, 0.359_486, 0.225_659], [0.011_284, 0.063_569_7, -0.001_066_85]),
        ([7.9, 2.3, 8.1], [-1.9, 0.8, 1.1]),
        ([2.0, 2.3, 1.1], [-0.3, -0.45, -0.27]),
    ];
    let scales = [1e-18, 3.3e-9, 1.7e-4, 1.0, 6.1e5, 2.9e12];
    let turns = [[0.3, -0.7, 0.2, 0.61], [1.0, 0.0, 0.0, 0.0], [-0.1, 0.2, 0.9, -0.4]];
    let mut bodies = Vec::new();
    for (moments, products) in shapes {
        for scale in scales {
            for turn in turns {
                let tensor = InertiaTensor::<Body>::with_negative_products(
                    moments.map(|x| x * scale),
                    products.map(|x| x * scale),
                );
                let turned = tensor.unwrap().in_frame(Rotation::from_quaternion(turn).unwrap());
                let centre = [0.113, -0.071, 0.234].map(|x: f64| x * scale.cbrt());
                bodies.push(MassProperties::new(2.3 * scale, Position::from_array(centre), turned).unwrap());
            }
        }
    }
    bodies
}

/// Returns the largest difference of elements, relative to half the trace, which does not depend on
/// the axes.
fn apart<A: Frame, B: Frame>(a: &InertiaTensor<A>, b: &InertiaTensor<B>) -> f64 {
    let (a, b) = (a.matrix(), b.matrix());
    let difference = a.as_flattened().iter().zip(b.as_flattened()).map(|(x, y)| (x - y).abs());
    difference.fold(0.0, f64::max) / (0.5 * (a[0][0] + a[1][1] + a[2][2]))
}

#[test]
fn every_language_gives_back_mass_centre_and_tensor() {
    for body in bodies() {
        for format in FORMATS {
            let text = export(format, &[ExportBody::new("part", body)]).unwrap();
            let again = body_of(&text, &format!("part.{}", format.extension()));
            assert_eq!(again.mass(), body.mass(), "{text}");
            assert_eq!(again.center_of_mass().to_array(), body.center_of_mass().to_array(), "{text}");
            let apart = apart(again.inertia(), body.inertia());
            // If the tensor itself is written, it is preserved exactly. Rotation to principal axes
            // and back causes a few rounding errors.
            let most = if format == ExportFormat::MjcfPrincipal { 1e-15 } else { 0.0 };
            assert!(apart <= most, "{apart:e}\n{text}");
        }
    }
}

/// Components x, y, z, row by row.
type Matrix = [[f64; 3]; 3];

fn times(a: &Matrix, b: &Matrix) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| (0..3).map(|k| a[i][k] * b[k][j]).sum()))
}

fn transposed(a: &Matrix) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| a[j][i]))
}

/// Returns the rotation about the fixed axes x, then y, then z: R_z(yaw) R_y(pitch) R_x(roll), as
/// in URDF and SDF.
fn roll_pitch_yaw([roll, pitch, yaw]: [f64; 3]) -> Matrix {
    let ((sr, cr), (sp, cp), (sy, cy)) = (roll.sin_cos(), pitch.sin_cos(), yaw.sin_cos());
    let x = [[1.0, 0.0, 0.0], [0.0, cr, -sr], [0.0, sr, cr]];
    let y = [[cp, 0.0, sp], [0.0, 1.0, 0.0], [-sp, 0.0, cp]];
    let z = [[cy, -sy, 0.0], [sy, cy, 0.0], [0.0, 0.0, 1.0]];
    times(&z, &times(&y, &x))
}

#[test]
fn an_inertial_frame_that_is_turned_turns_the_tensor() {
    let angles = [0.31, -1.17, 2.43];
    let r = roll_pitch_yaw(angles);
    let [a, b, c] = angles;
    let (ixx, iyy, izz, ixy, ixz, iyz) = (0.031, 0.042, 0.053, 0.004, -0.003, 0.002);
    let written = [[ixx, ixy, ixz], [ixy, iyy, iyz], [ixz, iyz, izz]];
    let want = times(&times(&r, &written), &transposed(&r));
    // The w of this matrix is not small: Shepperd's first case.
    let w = 0.5 * (1.0 + r[0][0] + r[1][1] + r[2][2]).sqrt();
    let [x, y, z] = [r[2][1] - r[1][2], r[0][2] - r[2][0], r[1][0] - r[0][1]].map(|d| d / (4.0 * w));
    let urdf = format!(
        r#"<robot name="r"><link name="a"><inertial><origin xyz="0.1 -0.2 0.3" rpy="{a} {b} {c}"/><mass value="1.7"/>
        <inertia ixx="{ixx}" ixy="{ixy}" ixz="{ixz}" iyy="{iyy}" iyz="{iyz}" izz="{izz}"/></inertial></link></robot>"#
    );
    let sdf = format!(
        "<sdf version='1.7'><model name='m'><link name='a'><inertial><pose>0.1 -0.2 0.3 {a} {b} {c}</pose><mass>1.7</mass>
        <inertia><ixx>{ixx}</ixx><ixy>{ixy}</ixy><ixz>{ixz}</ixz><iyy>{iyy}</iyy><iyz>{iyz}</iyz><izz>{izz}</izz></inertia>
        </inertial></link></model></sdf>"
    );
    let mjcf = format!(
        r#"<mujoco><worldbody><body name="a"><inertial pos="0.1 -0.2 0.3" quat="{w} {x} {y} {z}" mass="1.7"
        diaginertia="{ixx} {iyy} {izz}"/></body></worldbody></mujoco>"#
    );
    let diagonal = [[ixx, 0.0, 0.0], [0.0, iyy, 0.0], [0.0, 0.0, izz]];
    let principal = times(&times(&r, &diagonal), &transposed(&r));
    for (text, file, want) in [(urdf, "a.urdf", want), (sdf, "a.sdf", want), (mjcf, "a.xml", principal)] {
        let body = body_of(&text, file);
        assert_eq!(body.center_of_mass().to_array(), [0.1, -0.2, 0.3]);
        let want = InertiaTensor::<Body>::from_matrix(want).unwrap();
        let apart = apart(body.inertia(), &want);
        assert!(apart < 2e-15, "{file}: {apart:e}");
        // The inverse rotation gives a different tensor.
        let conjugate =
            body.inertia().in_frame::<Part>(Rotation::from_quaternion([w, -2.0 * x, y, z]).unwrap());
        assert!(self::apart(&conjugate, &want) > 1e-2);
    }
}
