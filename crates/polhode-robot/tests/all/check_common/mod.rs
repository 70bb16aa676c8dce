//! Helpers for the tests of the checks: a body with a known tensor, written as URDF, with or
//! without an error.

#![allow(dead_code, reason = "each test uses what it needs")]

use std::path::Path;

use polhode_robot::check::{LinkGeometry, check};
use polhode_robot::finding::{Finding, Severity};
use polhode_robot::geometry::{Volume, VolumeKind};
use polhode_robot::model::RobotModel;
use polhode_robot::read::{ReadOptions, read_text};

pub(crate) type Matrix = [[f64; 3]; 3];

pub(crate) fn read(text: &str) -> RobotModel {
    read_text(text, Path::new("robot.urdf"), &ReadOptions::default()).unwrap()
}

/// Returns the findings of a text without geometry.
pub(crate) fn findings(text: &str) -> Vec<Finding> {
    check(&read(text), &[])
}

/// Returns the findings of a text whose first link has this geometry.
pub(crate) fn findings_with(text: &str, geometry: LinkGeometry) -> Vec<Finding> {
    check(&read(text), &[geometry])
}

/// Returns the only finding with this code.
pub(crate) fn only<'f>(findings: &'f [Finding], code: &str) -> &'f Finding {
    let found: Vec<_> = findings.iter().filter(|f| f.code == code).collect();
    assert_eq!(found.len(), 1, "{code}: {findings:#?}");
    found[0]
}

pub(crate) fn number(finding: &Finding, name: &str) -> f64 {
    finding.numbers.iter().find(|(n, _)| *n == name).unwrap_or_else(|| panic!("{name}: {finding:?}")).1
}

/// Returns true if all findings are notes.
pub(crate) fn is_clean(findings: &[Finding]) -> bool {
    findings.iter().all(|f| f.severity == Severity::Note)
}

/// Returns the text with a finding's repair applied.
pub(crate) fn repaired(text: &str, finding: &Finding) -> String {
    let repair = finding.repair.as_ref().unwrap_or_else(|| panic!("no repair: {finding:#?}"));
    let mut edits = repair.edits.clone();
    edits.sort_by_key(|(span, _)| std::cmp::Reverse(span.start));
    let mut text = text.to_owned();
    for (span, new) in edits {
        text.replace_range(span, &new);
    }
    text
}

/// Returns Rz(yaw) Ry(pitch) Rx(roll), as in URDF.
pub(crate) fn turn([roll, pitch, yaw]: [f64; 3]) -> Matrix {
    let (sr, cr) = roll.sin_cos();
    let (sp, cp) = pitch.sin_cos();
    let (sy, cy) = yaw.sin_cos();
    let rx = [[1.0, 0.0, 0.0], [0.0, cr, -sr], [0.0, sr, cr]];
    let ry = [[cp, 0.0, sp], [0.0, 1.0, 0.0], [-sp, 0.0, cp]];
    let rz = [[cy, -sy, 0.0], [sy, cy, 0.0], [0.0, 0.0, 1.0]];
    times(&times(&rz, &ry), &rx)
}

pub(crate) fn times(a: &Matrix, b: &Matrix) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| (0..3).map(|k| a[i][k] * b[k][j]).sum()))
}

pub(crate) fn transposed(a: &Matrix) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| a[j][i]))
}

/// Returns R I Rᵀ.
pub(crate) fn conjugated(i: &Matrix, r: &Matrix) -> Matrix {
    times(&times(r, i), &transposed(r))
}

/// Returns the elements xx, yy, zz, xy, xz, yz.
pub(crate) fn six(i: &Matrix) -> [f64; 6] {
    [i[0][0], i[1][1], i[2][2], i[0][1], i[0][2], i[1][2]]
}

/// Uniform slab, rotated and displaced in its link: three different moments, all products, and a
/// rotated inertial frame.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Slab {
    pub(crate) mass: f64,
    pub(crate) edges: [f64; 3],
    /// Roll, pitch and yaw of the slab in the link, rad.
    pub(crate) attitude: [f64; 3],
    pub(crate) centre: [f64; 3],
    /// Roll, pitch and yaw of the inertial's frame, rad.
    pub(crate) frame: [f64; 3],
}

pub(crate) const SLAB: Slab = Slab {
    mass: 1.37,
    edges: [0.11, 0.19, 0.31],
    attitude: [0.4, -0.7, 1.1],
    centre: [0.06, -0.11, 0.08],
    frame: [0.3, -0.5, 0.8],
};

impl Slab {
    /// Returns the tensor per kilogram about the centre, link axes.
    fn per_mass(&self) -> Matrix {
        let [a, b, c] = self.edges.map(|x| x * x / 12.0);
        conjugated(&[[b + c, 0.0, 0.0], [0.0, a + c, 0.0], [0.0, 0.0, a + b]], &turn(self.attitude))
    }

    /// Returns the tensor about the centre in the inertial's axes, as in a correct file.
    pub(crate) fn tensor(&self) -> [f64; 6] {
        let inertial = conjugated(&self.per_mass(), &transposed(&turn(self.frame)));
        six(&inertial).map(|x| x * self.mass)
    }

    /// Returns the geometry of a closed mesh of the slab.
    pub(crate) fn geometry(&self) -> LinkGeometry {
        let [a, b, c] = self.edges;
        let volume = a * b * c;
        let half = 0.5 * (a * a + b * b + c * c).sqrt();
        let bounds = [self.centre.map(|x| x - half), self.centre.map(|x| x + half)];
        solid(volume, self.centre, self.per_mass(), bounds, VolumeKind::Closed)
    }

    /// Returns a robot with one link and these six numbers.
    pub(crate) fn robot(&self, tensor: [f64; 6]) -> String {
        let texts = tensor.map(|x| format!("{x:.7e}"));
        self.robot_of(&texts.each_ref().map(String::as_str))
    }

    pub(crate) fn robot_of(&self, [xx, yy, zz, xy, xz, yz]: &[&str; 6]) -> String {
        let ([x, y, z], [r, p, w]) = (self.centre, self.frame);
        format!(
            r#"<robot name="r"><link name="slab"><inertial>
  <origin xyz="{x} {y} {z}" rpy="{r} {p} {w}"/><mass value="{}"/>
  <inertia ixx="{xx}" ixy="{xy}" ixz="{xz}" iyy="{yy}" iyz="{yz}" izz="{zz}"/>
</inertial></link></robot>"#,
            self.mass
        )
    }
}

/// Returns a link with these mass properties, centred at its own origin.
pub(crate) fn link(name: &str, mass: &str, [xx, yy, zz, xy, xz, yz]: [&str; 6]) -> String {
    format!(
        r#"<link name="{name}"><inertial><mass value="{mass}"/>
<inertia ixx="{xx}" ixy="{xy}" ixz="{xz}" iyy="{yy}" iyz="{yz}" izz="{zz}"/></inertial></link>
"#
    )
}

pub(crate) fn robot(parts: &str) -> String {
    format!("<?xml version=\"1.0\"?>\n<robot name=\"r\">\n{parts}</robot>\n")
}

/// Returns a geometry with cubic bounds around a point, without volume.
pub(crate) fn bounds(centre: [f64; 3], half: f64) -> LinkGeometry {
    let bounds = Some([centre.map(|x| x - half), centre.map(|x| x + half)]);
    LinkGeometry { bounds, ..LinkGeometry::default() }
}

/// Returns a solid with this tensor per kilogram.
pub(crate) fn solid(
    volume: f64,
    centroid: [f64; 3],
    per_mass: Matrix,
    bounds: [[f64; 3]; 2],
    kind: VolumeKind,
) -> LinkGeometry {
    let tensor_per_density = per_mass.map(|row| row.map(|x| x * volume));
    let extent = bounds.iter().flatten().map(|x| x * x).sum::<f64>().sqrt();
    let solid = Volume { volume, centroid, tensor_per_density, extent, bounds, kind };
    LinkGeometry { volumes: vec![solid], bounds: Some(bounds), ..LinkGeometry::default() }
}

/// Returns a box with these edges at the link's origin.
pub(crate) fn block([a, b, c]: [f64; 3], kind: VolumeKind) -> LinkGeometry {
    let (x, y, z) = (a * a / 12.0, b * b / 12.0, c * c / 12.0);
    let per_mass = [[y + z, 0.0, 0.0], [0.0, x + z, 0.0], [0.0, 0.0, x + y]];
    let half = [a / 2.0, b / 2.0, c / 2.0];
    solid(a * b * c, [0.0; 3], per_mass, [half.map(|x| -x), half], kind)
}
