//! The same slab in three languages, with its shape: from the text to the finding.

use crate::check_common::{SLAB, only, read, repaired};
use polhode_robot::check::{LinkGeometry, check};
use polhode_robot::finding::{Finding, Severity};
use polhode_robot::geometry::Shapes;

fn all(text: &str) -> Vec<Finding> {
    let model = read(text);
    let shapes = Shapes::default();
    let geometry: Vec<_> = model.links.iter().map(|link| LinkGeometry::of(link, &shapes)).collect();
    assert!(geometry.iter().any(|g| !g.volumes.is_empty()), "the slab is measured");
    check(&model, &geometry)
}

fn words(numbers: &[f64]) -> String {
    numbers.iter().map(f64::to_string).collect::<Vec<_>>().join(" ")
}

/// Returns the quaternion (w, x, y, z) of Rz(yaw) Ry(pitch) Rx(roll).
fn quaternion([roll, pitch, yaw]: [f64; 3]) -> [f64; 4] {
    let ((sr, cr), (sp, cp), (sy, cy)) =
        ((roll / 2.0).sin_cos(), (pitch / 2.0).sin_cos(), (yaw / 2.0).sin_cos());
    [
        cr * cp * cy + sr * sp * sy,
        sr * cp * cy - cr * sp * sy,
        cr * sp * cy + sr * cp * sy,
        cr * cp * sy - sr * sp * cy,
    ]
}

fn urdf([xx, yy, zz, xy, xz, yz]: [f64; 6]) -> String {
    format!(
        r#"<robot name="r"><link name="slab"><inertial>
  <origin xyz="{}" rpy="{}"/><mass value="{}"/>
  <inertia ixx="{xx}" ixy="{xy}" ixz="{xz}" iyy="{yy}" iyz="{yz}" izz="{zz}"/></inertial>
  <visual><origin xyz="{}" rpy="{}"/><geometry><box size="{}"/></geometry></visual></link></robot>"#,
        words(&SLAB.centre),
        words(&SLAB.frame),
        SLAB.mass,
        words(&SLAB.centre),
        words(&SLAB.attitude),
        words(&SLAB.edges)
    )
}

fn sdf([xx, yy, zz, xy, xz, yz]: [f64; 6]) -> String {
    format!(
        "<sdf version=\"1.9\"><model name=\"m\"><link name=\"slab\"><inertial><pose>{} {}</pose><mass>{}</mass>
<inertia><ixx>{xx}</ixx><ixy>{xy}</ixy><ixz>{xz}</ixz><iyy>{yy}</iyy><iyz>{yz}</iyz><izz>{zz}</izz></inertia></inertial>
<collision name=\"c\"><pose>{} {}</pose><geometry><box><size>{}</size></box></geometry></collision></link></model></sdf>",
        words(&SLAB.centre),
        words(&SLAB.frame),
        SLAB.mass,
        words(&SLAB.centre),
        words(&SLAB.attitude),
        words(&SLAB.edges)
    )
}

/// Returns the slab with principal moments, in the order of the edges.
fn mjcf(quat: [f64; 4]) -> String {
    let [a, b, c] = SLAB.edges.map(|x| x * x * SLAB.mass / 12.0);
    format!(
        r#"<mujoco><worldbody><body name="slab"><freejoint/>
<inertial pos="{}" quat="{}" mass="{}" diaginertia="{}"/>
<geom type="box" pos="{}" quat="{}" size="{}"/></body></worldbody></mujoco>"#,
        words(&SLAB.centre),
        words(&quat),
        SLAB.mass,
        words(&[b + c, a + c, a + b]),
        words(&SLAB.centre),
        words(&quaternion(SLAB.attitude)),
        words(&SLAB.edges.map(|x| x / 2.0))
    )
}

#[test]
fn right_ones_are_no_finding() {
    assert_eq!(all(&urdf(SLAB.tensor())), []);
    assert_eq!(all(&sdf(SLAB.tensor())), []);
    assert_eq!(all(&mjcf(quaternion(SLAB.attitude))), []);
}

#[test]
fn signs_of_products() {
    for write in [urdf, sdf] {
        let mut tensor = SLAB.tensor();
        tensor[3..].iter_mut().for_each(|x| *x = -*x);
        let text = write(tensor);
        let findings = all(&text);
        let found = only(&findings, "inertia.sign");
        assert_eq!((found.severity, findings.len()), (Severity::Suspect, 1));
        assert_eq!(repaired(&text, found), write(SLAB.tensor()));
    }
}

#[test]
fn attitudes_conjugated_and_in_another_order() {
    let [w, x, y, z] = quaternion(SLAB.attitude);
    let findings = all(&mjcf([w, -x, -y, -z]));
    assert!(only(&findings, "inertia.conjugate").message.contains("frame inverted"));
    let findings = all(&mjcf([x, y, z, w]));
    assert!(only(&findings, "inertia.conjugate").message.contains("x y z w"));
    assert_eq!(findings.len(), 1);
}

#[test]
fn a_full_inertia_in_the_order_of_rows() {
    // Link axes: the inertial frame is not rotated.
    let slab = crate::check_common::Slab { frame: [0.0; 3], ..SLAB };
    let [xx, yy, zz, xy, xz, yz] = slab.tensor();
    let right = words(&[xx, yy, zz, xy, xz, yz]);
    let one = |six: &str| {
        mjcf(quaternion(SLAB.attitude))
            .replace(&format!("quat=\"{}\" mass", words(&quaternion(SLAB.attitude))), "mass")
            .replacen("diaginertia=\"", &format!("fullinertia=\"{six}\" user=\""), 1)
    };
    assert_eq!(all(&one(&right)), []);
    let text = one(&words(&[xx, xy, xz, yy, yz, zz]));
    let findings = all(&text);
    let found = only(&findings, "inertia.order");
    assert!(found.message.contains("row-major"), "{}", found.message);
    assert_eq!(repaired(&text, found), one(&right));
    assert!(findings.iter().any(|f| f.severity == Severity::Impossible));
}
