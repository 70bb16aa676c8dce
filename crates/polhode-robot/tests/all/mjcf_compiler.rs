//! Masses computed by MuJoCo's compiler. Expected values are those of MuJoCo 3.17.0: `body_mass`,
//! `body_ipos`, and `body_inertia` rotated by `body_iquat`.

use std::path::Path;

use polhode_robot::body::{LinkMass, link_mass};
use polhode_robot::check::check;
use polhode_robot::finding::Repair;
use polhode_robot::line_index::Places;
use polhode_robot::model::{RobotModel, Tensor};
use polhode_robot::read::{ReadOptions, read_model};
use polhode_robot::repair::{LeftReason, repaired};
use polhode_robot::report::CheckReport;

use crate::common::Folder;

/// A wedge, and a second object that MuJoCo does not read.
const WEDGE: &str = "v 0 0 0\n\
v 0.3 0 0\n\
v 0.3 0.2 0\n\
v 0 0.2 0\n\
v 0 0 0.11\n\
v 0 0.2 0.07\n\
v 0.5 0.5 0.5\n\
v 0.6 0.5 0.5\n\
v 0.5 0.7 0.5\n\
v 0.5 0.5 0.9\n\
o one\n\
f 1 4 3 2\n\
f 1 2 5\n\
f 4 6 3\n\
f 1 5 6 4\n\
f 2 3 6 5\n\
o two\n\
f 7 9 8\n\
f 7 8 10\n\
f 8 9 10\n\
f 9 7 10\n\
";

/// Asserts bodies by rows of name, mass, centre, and xx, yy, zz, xy, xz, yz. MuJoCo's principal
/// axes are accurate to about 1e-7.
#[track_caller]
pub(crate) fn assert_rows(model: &RobotModel, rows: &str) {
    for row in rows.lines() {
        let (name, numbers) = row.split_once(": ").unwrap();
        let numbers: Vec<f64> = numbers.split(' ').map(|number| number.parse().unwrap()).collect();
        let [mass, cx, cy, cz, tensor @ ..] = numbers.as_slice() else { panic!("{row}") };
        let link =
            model.links.iter().find(|link| link.name.text == name).unwrap_or_else(|| panic!("no {name}"));
        let LinkMass::Body(body) =
            link_mass(model.format, link).unwrap_or_else(|error| panic!("{name}: {error}"))
        else {
            panic!("{name} has no mass")
        };
        let body = body.properties;
        let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = body.inertia().matrix();
        let largest = tensor.iter().fold(0.0_f64, |max, c| max.max(c.abs()));
        let apart = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!((body.mass() / mass - 1.0).abs() < 1e-6, "{name}: {} kg, not {mass}", body.mass());
        let off = apart(&[xx, yy, zz, xy, xz, yz], tensor);
        assert!(
            tensor.len() == 6 && off < 1e-6 * largest,
            "{name}: {:?}, not {tensor:?}",
            body.inertia().matrix()
        );
        let off = apart(&body.center_of_mass().to_array(), &[*cx, *cy, *cz]);
        assert!(off < 1e-6 * (largest / mass).sqrt(), "{name}: {:?}, not {row}", body.center_of_mass());
    }
}

fn read(path: &Path) -> RobotModel {
    read_model(path, &ReadOptions::default()).unwrap()
}
const GEOMS: &str = r#"<mujoco><compiler meshdir="assets" inertiagrouprange="0 3"/>
<default><default class="steel"><geom density="7800" type="cylinder"/></default></default>
<asset><mesh name="w" file="wedge.obj"/>
  <mesh name="turned" file="wedge.obj" inertia="exact" scale="1 -2 0.7" refpos="0.01 0.02 0.03" refquat="1 0.2 -0.1 0.3"/>
  <mesh name="hull" file="wedge.obj" inertia="convex"/><mesh name="skin" file="wedge.obj" inertia="shell"/>
  <mesh name="points" vertex="0 0 0  1 0 0  0 1.5 0  0 0 2  0.2 0.3 0.1"/>
  <mesh name="faces" vertex="0 0 0  1 0 0  0 1.5 0  0 0 2" face="0 2 1 0 1 3 1 2 3 2 0 3" inertia="exact"/>
  <hfield name="h" nrow="3" ncol="3" size="0.4 0.3 0.2 0.1"/></asset>
<worldbody>
<body name="primitives" pos="1 2 3" euler="10 20 30" childclass="steel">
  <geom type="box" size="0.1 0.2 0.3" pos="0.1 -0.2 0.3" euler="11 -22 33" mass="2"/>
  <geom fromto="0.1 0.2 0.3 -0.4 0.1 0.6" size="0.05"/>
  <frame pos="0.2 0.1 0" axisangle="1 2 3 40"><geom type="capsule" size="0.04 0.1" density="500"/>
    <geom class="main" type="ellipsoid" size="0.1 0.15 0.07" zaxis="1 2 3"/></frame>
  <geom type="sphere" size="0.1" group="4" mass="1"/><geom type="sphere" size="0.12" mass="0"/></body>
<body name="shell sphere"><geom type="sphere" size="0.13" pos="0.1 0.2 0.3" euler="20 30 40" shellinertia="true" density="3"/></body>
<body name="shell box"><geom type="box" size="0.1 0.2 0.3" pos="0.1 0.2 0.3" euler="20 30 40" shellinertia="true" density="3"/></body>
<body name="shell cylinder"><geom type="cylinder" size="0.07 0.2" pos="0.1 0.2 0.3" euler="20 30 40" shellinertia="true" density="3"/></body>
<body name="shell capsule"><geom type="capsule" size="0.07 0.21" pos="0.1 0.2 0.3" euler="20 30 40" shellinertia="true" density="3"/></body>
<body name="shell ellipsoid"><geom type="ellipsoid" size="0.1 0.2 0.33" pos="0.1 0.2 0.3" euler="20 30 40" shellinertia="true" density="3"/></body>
<body name="fitted sphere"><geom type="sphere" mesh="w" pos="0.1 0.2 0.3" euler="20 30 40" fitscale="1.1"/></body>
<body name="fitted box"><geom type="box" mesh="turned" pos="0.1 0.2 0.3" euler="20 30 40" fitscale="1.1"/></body>
<body name="fitted cylinder"><geom type="cylinder" mesh="hull" pos="0.1 0.2 0.3" euler="20 30 40" fitscale="1.1"/></body>
<body name="fitted capsule"><geom type="capsule" mesh="w" pos="0.1 0.2 0.3" euler="20 30 40" fitscale="1.1"/></body>
<body name="fitted ellipsoid"><geom type="ellipsoid" mesh="points" pos="0.1 0.2 0.3" euler="20 30 40" fitscale="1.1"/></body>
<body name="mesh w"><geom type="mesh" mesh="w" pos="0.1 0.2 0.3" euler="20 30 40"/></body>
<body name="mesh turned"><geom type="mesh" mesh="turned" pos="0.1 0.2 0.3" euler="20 30 40"/></body>
<body name="mesh hull"><geom type="mesh" mesh="hull" pos="0.1 0.2 0.3" euler="20 30 40"/></body>
<body name="mesh skin"><geom type="mesh" mesh="skin" pos="0.1 0.2 0.3" euler="20 30 40"/></body>
<body name="mesh points"><geom type="mesh" mesh="points" pos="0.1 0.2 0.3" euler="20 30 40"/></body>
<body name="mesh faces"><geom type="mesh" mesh="faces" pos="0.1 0.2 0.3" euler="20 30 40"/></body>
<body name="given"><geom type="mesh" mesh="w" mass="3" pos="0.1 0.2 0.3"/><geom size="0.1" mass="1"/></body>
<body name="field"><geom type="hfield" hfield="h" pos="0.1 0.2 0.3" mass="2"/></body>
</worldbody></mujoco>"#;

#[test]
fn geoms_have_masses_by_type_mesh_and_fit() {
    let folder = Folder::of(
        "geoms_have_masses_by_type_mesh_and_fit",
        &[("geoms.xml", GEOMS), ("assets/wedge.obj", WEDGE)],
    );
    let model = read(&folder.path("geoms.xml"));
    assert_eq!(model.links.len(), 19);
    let rows = "\
primitives: 43.2774558 -0.0977274253 0.128008266 0.390714708 1.58662848 2.68004291 1.74373666 0.0766765979 1.19301396 -0.0599635281\n\
shell sphere: 0.63711499 0.1 0.2 0.3 0.00717816222 0.00717816222 0.00717816222 0 0 0\n\
shell box: 2.64 0.1 0.2 0.3 0.12884425 0.141146868 0.0916088815 0.0254926183 -0.0251552194 0.00921347617\n\
shell cylinder: 0.62015039 0.1 0.2 0.3 0.00980654037 0.0113197511 0.00596196551 0.0013810914 -0.00379451744 0.00224785796\n\
shell capsule: 0.738902592 0.1 0.2 0.3 0.0165568059 0.0194208995 0.0092800784 0.00261402785 -0.0071819825 0.00425457961\n\
shell ellipsoid: 1.59973322 0.1 0.2 0.3 0.0524244399 0.0580667702 0.0359057576 0.0103590546 -0.0120689134 0.0050721454\n\
fitted sphere: 3.40236039 0.127274064 0.317907782 0.362530324 0.0118477198 0.0118477198 0.0118477198 0 0 0\n\
fitted box: 5.79782777 0.166017806 0.276629841 0.25683432 0.107443798 0.0659949906 0.094122438 0.0220705999 0.0305825505 -0.0333988288\n\
fitted cylinder: 58.4419329 0.291748801 0.520115539 0.686982205 4.16870135 3.89116499 1.9610377 -0.681926461 -1.24111396 -1.51911022\n\
fitted capsule: 4.88009156 0.127274064 0.317907782 0.362530324 0.0336742914 0.0225390986 0.0404662709 -0.013050241 0.00397045885 0.00601060492\n\
fitted ellipsoid: 485.841728 0.307102087 0.464378139 0.883384886 61.2273149 70.3480244 60.2167557 19.1830536 -6.08361399 16.0499806\n\
mesh w: 2.50000014 0.127274064 0.317907782 0.362530324 0.0145049944 0.0107765045 0.0181437059 -0.00221008865 0.00402190422 3.17720606e-05\n\
mesh turned: 3.50000019 0.166017806 0.276629841 0.25683432 0.0536041903 0.0329251953 0.0469581043 0.0110111207 0.0152577709 -0.0166628247\n\
mesh hull: 53.2500007 0.291748801 0.520115539 0.686982205 3.26483414 2.97420718 1.60438222 -0.482716125 -0.941176247 -1.1002499\n\
mesh skin: 168.317388 0.143060133 0.342681881 0.357180633 1.55932066 1.10363927 1.95289553 -0.363608025 0.391572376 0.0792855137\n\
mesh points: 500 0.307102087 0.464378139 0.883384886 86.7928171 99.7218845 85.3602984 27.1929492 -8.62383069 22.7516597\n\
mesh faces: 500 0.307102087 0.464378139 0.883384886 86.7928171 99.7218845 85.3602984 27.1929492 -8.62383069 22.7516597\n\
given: 4 0.147000003 0.219000001 0.2472 0.161008241 0.130216242 0.121360003 -0.0430680029 -0.0461364008 -0.0714288001\n\
field: 2 0.1 0.2 0.3 0.0666666667 0.113333333 0.166666667 0 0 0";
    assert_rows(&model, rows);
}
const BOUNDS: &str = r#"<mujoco><compiler meshdir="assets" fitaabb="true"/><asset><mesh name="w" file="wedge.obj"/></asset><worldbody>
<body name="bounds sphere"><geom type="sphere" mesh="w" pos="0.1 0.2 0.3" euler="20 30 40"/></body>
<body name="bounds box"><geom type="box" mesh="w" pos="0.1 0.2 0.3" euler="20 30 40"/></body>
<body name="bounds cylinder"><geom type="cylinder" mesh="w" pos="0.1 0.2 0.3" euler="20 30 40"/></body>
<body name="bounds ellipsoid"><geom type="ellipsoid" mesh="w" pos="0.1 0.2 0.3" euler="20 30 40"/></body>
</worldbody></mujoco>"#;

#[test]
fn primitives_are_fitted_to_bounds() {
    let folder =
        Folder::of("primitives_are_fitted_to_bounds", &[("bounds.xml", BOUNDS), ("assets/wedge.obj", WEDGE)]);
    let model = read(&folder.path("bounds.xml"));
    assert_eq!(model.links.len(), 4);
    let rows = "\
bounds sphere: 535.669893 0.326279318 0.522037493 0.80688588 54.3871517 54.3871517 54.3871517 0 0 0\n\
bounds box: 360.447619 0.326279318 0.522037493 0.80688588 35.0507194 41.6729427 27.8247839 2.71747705 -8.6492559 1.05144478\n\
bounds cylinder: 439.542192 0.326279318 0.522037493 0.80688588 43.804967 49.9847959 40.0355423 7.24264568 -2.20353223 -3.33577608\n\
bounds ellipsoid: 188.729932 0.326279318 0.522037493 0.80688588 11.0115083 13.0919411 8.74141366 0.853720593 -2.71724388 0.33032112";
    assert_rows(&model, rows);
}
const COPIES: &str = r#"<mujoco><compiler settotalmass="20" eulerseq="zyX"/><worldbody>
<body name="r"><geom size="0.1"/><replicate count="11" offset="0.3 0.1 0.05" euler="5 10 15" sep="_">
  <body name="c" pos="0.1 0.2 0.3"><geom type="box" size="0.1 0.2 0.3"/>
    <replicate count="2" offset="0 0.2 0" euler="0 0 30"><geom type="box" size="0.01 0.03 0.02" pos="0.1 0 0"/>
      <body name="d" euler="10 0 0"><geom type="capsule" size="0.1 0.2"/></body></replicate></body>
  <geom type="box" size="0.02 0.03 0.05" pos="0.1 0.2 0"/></replicate></body></worldbody></mujoco>"#;

#[test]
fn copies_are_moved_turned_and_numbered() {
    let folder = Folder::of("copies_are_moved_turned_and_numbered", &[("copies.xml", COPIES)]);
    let model = read(&folder.path("copies.xml"));
    assert_eq!(model.links.len(), 34);
    let rows = "\
r: 0.150996193 0.423753664 0.368950443 0.216455674 0.07286886 0.0814756731 0.106340739 -0.0513449957 -0.0328317741 -0.0329130776\n\
c_00: 1.06348455 0.000199600798 0.000199600798 0 0.0460356779 0.0354003105 0.0177536241 -2.11848668e-05 0 -7.65971922e-08\n\
d0_00: 0.370485169 0 0 0 0.00986416764 0.00986416764 0.00175980455 0 0 0\n\
d1_07: 0.370485169 0 0 0 0.00986416764 0.00986416764 0.00175980455 0 0 0\n\
c_10: 1.06348455 0.000199600798 0.000199600798 0 0.0460356779 0.0354003105 0.0177536241 -2.11848668e-05 0 -7.65971922e-08";
    assert_rows(&model, rows);
}
const CHANGED: &str = r#"<mujoco><compiler boundmass="0.5" boundinertia="0.02" balanceinertia="true" inertiafromgeom="true"/><worldbody>
<body name="empty" pos="1 2 3"/>
<body name="even"><inertial mass="3" pos="0.1 0.2 0.3" quat="1 2 3 4" diaginertia="0.1 0.2 0.4"/><geom size="0.1" mass="0"/></body>
<body name="full"><inertial mass="0.3" pos="0.1 0.2 0.3" fullinertia="0.1 0.2 0.25 0.001 0.02 0.03"/></body>
<body name="thin"><inertial mass="3" pos="0.1 0.2 0.3" diaginertia="0.1 0.2 0.4"/><geom type="box" size="0.01 0.8 0.3" euler="10 20 30"/></body>
<frame pos="1 0 0" euler="30 0 0"><body name="framed" pos="0 1 0"><frame pos="0 0 1" euler="20 30 40"><frame pos="0.1 0 0" euler="1 20 3">
  <inertial mass="3" pos="0.1 0.2 0.3" euler="3 30 4" diaginertia="0.1 0.2 0.25"/></frame></frame></body></frame></worldbody></mujoco>
<mujoco model="second"><worldbody><body name="never"/></worldbody></mujoco>"#;

#[test]
fn bounds_and_balance_change_what_is_written() {
    let folder = Folder::of("bounds_and_balance_change_what_is_written", &[("changed.xml", CHANGED)]);
    let model = read(&folder.path("changed.xml"));
    assert_eq!(model.links.len(), 5);
    let rows = "\
empty: 0.5 1 2 3 0.02 0.02 0.02 0 0 0\n\
even: 3 0.1 0.2 0.3 0.233333333 0.233333333 0.233333333 0 0 0\n\
full: 0.5 0.1 0.2 0.3 0.1 0.2 0.25 0.001 0.02 0.03\n\
thin: 19.2 0 0 0 3.70062219 1.88160822 3.76304959 1.6160515 0.431315746 -0.987838358\n\
framed: 3 0.205941399 0.257488416 1.2803747 0.235632939 0.144571976 0.169795085 0.0182668776 0.014262281 0.0555495635";
    assert_rows(&model, rows);
    let second = &model.notes[0];
    assert_eq!((second.code, &model.text[second.span.start..][..7]), ("read.left_out", "<mujoco"));
}
const KID: &str = r#"<mujoco model="kid"><compiler angle="radian" boundmass="2"/><default><geom density="300"/></default><worldbody>
<geom size="0.2"/><frame pos="0 0 1" euler="0.3 0 0"><body name="k" pos="0.1 0 0" euler="0.5 0 0">
  <geom type="box" size="0.1 0.2 0.3" euler="0.1 0.2 0.3"/><body name="kk" pos="1 0 0"><geom size="0.3"/></body></body></frame>
<body name="solo"><geom size="0.01"/></body></worldbody></mujoco>"#;
const PARENT: &str = r#"<mujoco><asset><model file="kid.xml"/><model name="again" file="kid.xml"/></asset><worldbody>
<body name="p"><geom size="0.1"/><attach model="kid" body="k" prefix="a_"/>
  <frame pos="1 2 3" euler="0 0 30"><attach model="again" prefix="b_"/></frame></body>
<replicate count="2" offset="1 0 0"><attach model="kid" body="k" prefix="c_"/></replicate></worldbody></mujoco>"#;

#[test]
fn models_are_attached_with_their_own_settings() {
    let folder = Folder::of(
        "models_are_attached_with_their_own_settings",
        &[("parent.xml", PARENT), ("kid.xml", KID)],
    );
    let model = read(&folder.path("parent.xml"));
    assert_eq!(model.links.len(), 10);
    let rows = "\
p: 14.2418867 0.705882353 1.41176471 2.11764706 38.6159148 29.7455356 14.9615701 -5.91358617 -8.87037926 -17.7407585\n\
a_k: 14.4 0 0 0 0.596764237 0.4918092 0.255426563 0.046864748 -0.0679806433 0.0157175403\n\
a_kk: 33.9292007 0 0 0 1.22145122 1.22145122 1.22145122 0 0 0\n\
b_k: 14.4 0 0 0 0.596764237 0.4918092 0.255426563 0.046864748 -0.0679806433 0.0157175403\n\
b_kk: 33.9292007 0 0 0 1.22145122 1.22145122 1.22145122 0 0 0\n\
b_solo: 2 0 0 0 5.02654825e-08 5.02654825e-08 5.02654825e-08 0 0 0\n\
c_k0: 14.4 0 0 0 0.596764237 0.4918092 0.255426563 0.046864748 -0.0679806433 0.0157175403\n\
c_kk0: 33.9292007 0 0 0 1.22145122 1.22145122 1.22145122 0 0 0\n\
c_k1: 14.4 0 0 0 0.596764237 0.4918092 0.255426563 0.046864748 -0.0679806433 0.0157175403\n\
c_kk1: 33.9292007 0 0 0 1.22145122 1.22145122 1.22145122 0 0 0";
    assert_rows(&model, rows);
}
const OUTER: &str = r#"<mujoco><include file="settings.xml"/><worldbody><body name="o"><include file="body.xml"/><geom size="0.1"/><joint name="last" type="slide"/></body></worldbody></mujoco>"#;
const SETTINGS: &str = r#"<mujocoinclude><include file="sub/inner.xml"/><default><geom density="100"/></default></mujocoinclude>"#;
const INNER: &str = r#"<x><include file="classes.xml"/><compiler angle="radian"/></x>"#;
const CLASSES: &str = r#"<x><default class="main"><default class="q"><geom type="box" size="0.1 0.2 0.4"/></default></default></x>"#;
const BODY: &str = r#"<x><joint name="first" axis="1 0 0"/><body name="inner" euler="0 0.5 0"><geom class="q" pos="1 0 0" euler="0.3 0 0"/></body></x>"#;

#[test]
fn included_files_stand_in_place() {
    let folder = Folder::of(
        "included_files_stand_in_place",
        &[
            ("outer.xml", OUTER),
            ("settings.xml", SETTINGS),
            ("sub/inner.xml", INNER),
            ("sub/classes.xml", CLASSES),
            ("body.xml", BODY),
        ],
    );
    let model = read(&folder.path("outer.xml"));
    assert_eq!(model.links.len(), 2);
    let rows = "\
o: 0.41887902 0 0 0 0.00167551608 0.00167551608 0.00167551608 0 0 0\n\
inner: 64 1 0 0 4.26666667 3.40309625 1.29023708 0 0 0.722742366";
    assert_rows(&model, rows);
    let joints: Vec<_> = model.joints.iter().map(|joint| joint.name.text.as_str()).collect();
    assert_eq!(joints, ["first", "inner (fixed)", "last"]);
    // A position in an included file is reported with that file.
    let place = Places::of(&model).place(&model.links[1].name.span);
    assert_eq!((place.file.file_name().unwrap(), place.is_included), ("body.xml".as_ref(), true));
    assert_eq!((place.line, place.column), (1, 1 + BODY.find("inner").unwrap()));
}

#[test]
fn what_stands_in_an_included_file_is_found_there_and_not_repaired() {
    let part =
        "<x>\n<body name='b'><inertial pos='0 0 0' mass='2' diaginertia='0.1034 0.1127 0.3152'/></body></x>";
    let own = "<mujoco><worldbody><body name='a'><inertial pos='0 0 0' mass='2' diaginertia='0.1034 0.1127 0.3152'/><include file='part.xml'/></body></worldbody></mujoco>";
    let folder = Folder::of("included", &[("own.xml", own), ("part.xml", part)]);
    let model = read(&folder.path("own.xml"));
    let mut findings = check(&model, &[]);
    let places = Places::of(&model);
    let found: Vec<_> = findings.iter().map(|f| (f.code, f.subject.as_str())).collect();
    assert_eq!(found, [("inertia.triangle", "a"), ("inertia.triangle", "b")]);
    let place = places.place(&findings[1].span);
    assert_eq!((place.file.file_name().unwrap(), place.line), ("part.xml".as_ref(), 2));
    let moment = |k: usize| {
        let Some(Tensor::Diagonal(slots)) = model.links[k].inertial.as_ref().map(|i| i.tensor.clone()) else {
            panic!("three")
        };
        slots[2].span()
    };
    for (k, finding) in findings.iter_mut().enumerate() {
        let edits = vec![(moment(k), "0.19".to_owned())];
        finding.repair = Some(Repair { description: String::new(), edits });
    }
    let done = repaired(&model, &findings);
    assert_eq!(done.text, own.replace("0.3152", "0.19"));
    assert_eq!((done.applied, done.left[0].finding, done.left[0].why), (vec![0], 1, LeftReason::Included));
    let judged = polhode_robot::policy::Policy::default().judge(|_| "robot.xml".to_owned(), &model, findings);
    let report = CheckReport::new(model.clone(), vec![], judged);
    let json = report.to_json();
    assert!(json["findings"][0].get("file").is_none());
    let file = folder.path("part.xml").display().to_string();
    assert_eq!(json["findings"][1]["file"], file);
    assert!(report.to_text().contains(&format!("{file}:2:")));
}

#[test]
fn an_include_is_refused_the_second_time_and_noted_where_it_is_not_there() {
    let twice = "<mujoco><include file='part.xml'/><include file='./part.xml'/></mujoco>";
    let gone = "<mujoco><include file='gone.xml'/><worldbody><body name='b'><geom size='1'/></body></worldbody></mujoco>";
    let round = "<mujoco><include file='round.xml'/></mujoco>";
    let broken = "<mujoco>\n<include file='bad.xml'/></mujoco>";
    let folder = Folder::of(
        "includes",
        &[
            ("twice.xml", twice),
            ("part.xml", "<x><option/></x>"),
            ("gone.xml.xml", gone),
            ("round.xml", round),
            ("broken.xml", broken),
            ("bad.xml", "<x>\n\n<y></x>"),
        ],
    );
    let refused =
        |file: &str| read_model(&folder.path(file), &ReadOptions::default()).unwrap_err().to_string();
    assert!(refused("twice.xml").contains("a second time"), "{}", refused("twice.xml"));
    assert!(refused("round.xml").contains("a second time"));
    assert!(refused("broken.xml").contains("bad.xml"), "{}", refused("broken.xml"));
    let model = read(&folder.path("gone.xml.xml"));
    assert_eq!(model.notes[0].code, "read.include");
    assert!(link_mass(model.format, &model.links[0]).unwrap_err().to_string().contains("<include>"));
}

#[test]
fn copies_without_number_are_refused() {
    let many = "<mujoco><worldbody><replicate count='1000000000'><body/></replicate></worldbody></mujoco>"
        .to_owned();
    let nested = format!(
        "<mujoco><worldbody>{}<body/>{}</worldbody></mujoco>",
        "<replicate count='9'>".repeat(40),
        "</replicate>".repeat(40)
    );
    for text in [many, nested] {
        let error = crate::common::refused(&text).to_string();
        assert!(error.contains("300000 elements"), "{error}");
    }
}

#[test]
fn a_frame_that_cannot_be_read_gives_no_mass() {
    let body = |frame: &str| {
        let text = format!(
            "<mujoco><worldbody><body name=\"b\"><frame {frame}><geom type=\"sphere\" size=\".1\"/></frame>\
             <geom type=\"box\" size=\".1 .2 .3\"/></body></worldbody></mujoco>"
        );
        let folder = Folder::of("frames", &[("frames.xml", &text)]);
        let model = read_model(&folder.path("frames.xml"), &ReadOptions::default()).unwrap();
        matches!(link_mass(model.format, &model.links[0]), Ok(LinkMass::Body(_)))
    };
    assert!(body("pos=\"0 0.5 0\""));
    assert!(!body("pos=\"0 0,5 0\"") && !body("euler=\"90 0,0 0\""));
}
