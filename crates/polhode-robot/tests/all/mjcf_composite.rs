//! Cables of `<composite>`. The numbers are those of MuJoCo 3.17.0: `body_mass`, `body_ipos`, `body_inertia` turned by `body_iquat`, and
//! the places and x axes of bodies at rest. Version 4 has no `<composite>`.

use polhode_robot::check::check;
use polhode_robot::model::JointKind;

use crate::common::{assert_close, read, refused};
use crate::mjcf_compiler::assert_rows;

const CABLES: &str = r#"<mujoco><compiler boundmass="0.001"/><worldbody>
<body name="b" pos="1 2 3" euler="10 20 30"><geom size="0.1"/><frame pos="1 0 0" euler="0 30 0">
  <composite type="cable" prefix="coil" curve="cos(s) sin(s) s" count="6 1 1" size="1.3 0.2 1.5" offset="0.1 0.2 0.3" quat="0.8 0.6 0 0" initial="none">
    <geom type="capsule" size="0.02" density="700"/><joint kind="main" damping="1"/></composite></frame></body>
<composite type="cable" prefix="tape" curve="s cos(s) sin(s)" count="7 1 1" size="1.3 0.2 1.5" initial="free"><geom type="box" size="9 0.01 0.02" mass="0.3"/></composite>
<composite type="cable" vertex="0 0 0  0.3 0 0  0.3 0.4 0  0.3 0.4 0.5  0.1 0.2 0.9" offset="1 1 1"><geom type="cylinder" size="0.02"/></composite>
<composite type="cable" prefix="back" vertex="0 0 0  -0.3 0.1 0.05  -0.6 0.2 0.1  -0.7 0.5 0.1"><geom type="cylinder" size="0.02"/></composite>
</worldbody></mujoco>"#;

#[test]
fn cables_are_chains_of_bodies() {
    let model = read(CABLES);
    assert_eq!(model.links.len(), 19);
    let rows = "\
coilB_first: 0.302427313 0.15856953 0 0 5.95471736e-05 0.00301542841 0.00301542841 0 0 0\n\
coilB_3: 0.302427287 0.158569516 0 0 5.95471685e-05 0.00301542765 0.00301542765 0 0 0\n\
coilB_last: 0.30242736 0.158569557 0 0 5.95471829e-05 0.00301542979 0.00301542979 0 0 0\n\
tapeB_first: 0.3 0.132642286 0 0 5e-05 0.00179939761 0.00176939761 0 0 0\n\
tapeB_2: 0.3 0.132642274 0 0 5e-05 0.00179939728 0.00176939728 0 0 0\n\
tapeB_last: 0.3 0.13264225 0 0 5e-05 0.00179939664 0.00176939664 0 0 0\n\
B_first: 0.376991133 0.150000006 0 0 7.53982267e-05 0.00286513284 0.00286513284 0 0 0\n\
B_2: 0.628318531 0.25 0 0 0.000125663706 0.0131528012 0.0131528012 0 0 0\n\
B_last: 0.615623905 0.244948969 0 0 0.000123124781 0.0123740399 0.0123740399 0 0 0\n\
backB_1: 0.402320176 0.160078112 0 0 8.04640352e-05 0.00347671711 0.00347671711 0 0 0\n\
backB_last: 0.397383531 0.158113883 0 0 7.94767061e-05 0.00335126777 0.00335126777 0 0 0";
    assert_rows(&model, rows);
    let places = [
        ("coilB_first", [2.09088533, 2.91342379, 2.87654384], [0.669677767, -0.579967388, 0.463863685]),
        ("coilB_3", [2.42156864, 2.13193251, 3.0872674], [0.271662262, -0.769654543, -0.577781533]),
        ("coilB_last", [2.50772334, 1.88784502, 2.90403033], [0.662240574, -0.428480409, -0.614688507]),
        ("tapeB_first", [0.0, 0.200000003, 0.0], [0.816733016, -0.220814349, 0.533093054]),
        ("tapeB_2", [0.433333337, 0.0, 0.200000003], [0.816732978, -0.533093103, -0.22081437]),
        ("tapeB_last", [1.08333337, -0.141421363, -0.141421363], [0.816732903, 0.533093201, -0.22081441]),
        ("B_first", [1.0, 1.0, 1.0], [1.0, 0.0, 0.0]),
        ("B_2", [1.3, 1.4, 1.0], [0.0, 0.0, 1.0]),
        ("B_last", [1.3, 1.4, 1.5], [-0.408248336, -0.408248306, 0.816496551]),
        ("backB_1", [-0.3, 0.1, 0.05], [-0.937042574, 0.312347517, 0.156173758]),
        ("backB_last", [-0.6, 0.2, 0.1], [-0.316227653, 0.948683336, 0.0]),
    ];
    for (name, place, x) in places {
        let link = model.links.iter().find(|link| link.name.text == name).unwrap();
        assert_close(link.pose.position, place, 1e-7);
        assert_close(link.pose.turned([1.0, 0.0, 0.0]), x, 2e-7);
    }
    let joint =
        |name: &str| model.joints.iter().find(|joint| joint.name.text == name).map(|joint| joint.kind);
    let kinds = ["tapeJ_first", "J_first", "J_1", "tapeJ_last"].map(joint);
    let ball = Some(JointKind::Other);
    assert_eq!(kinds, [Some(JointKind::Free), ball, ball, ball]);
    assert_eq!(joint("coilJ_first"), None);
    assert_eq!(model.notes.iter().filter(|note| note.message.contains("version 4 refuses")).count(), 4);
    assert!(check(&model, &[]).iter().all(|finding| finding.code == "read.unknown"));
}

#[test]
fn what_is_no_cable_is_refused_by_name() {
    let geom = "<geom type='capsule' size='0.1'/>";
    let cases = [
        (format!("<composite type='cloth' count='5 5 1'>{geom}</composite>"), "cables alone"),
        (
            format!("<composite type='cable' curve='s' count='5 1 1' spacing='1'>{geom}</composite>"),
            "spacing=…",
        ),
        (format!("<composite type='cable' curve='t' count='5 1 1'>{geom}</composite>"), "curve=\"t\""),
        (format!("<composite type='cable' curve='s' count='3 1 1'>{geom}</composite>"), "three edges"),
        (
            format!("<composite type='cable' curve='s' size='0' count='5 1 1'>{geom}</composite>"),
            "at one place",
        ),
        (
            format!("<composite type='cable' curve='s' count='5.5 1 1'>{geom}</composite>"),
            "count is not whole",
        ),
        (format!("<composite type='cable' vertex='0 0 0 1 0 0 2 0'>{geom}</composite>"), "three numbers"),
        (
            format!(
                "<replicate count='2'><composite type='cable' curve='s' count='5 1 1'>{geom}</composite></replicate>"
            ),
            "copied",
        ),
        ("<composite type='cable' curve='s' count='5 1 1'/>".to_owned(), "no geom"),
        (
            "<composite type='cable' curve='s' count='5 1 1'><geom size='1'/></composite>".to_owned(),
            "a sphere",
        ),
    ];
    for (element, said) in cases {
        let model = read(&format!("<mujoco><worldbody>{element}</worldbody></mujoco>"));
        let note = model.notes.iter().find(|note| note.code == "read.left_out");
        assert!(note.is_some_and(|note| note.message.contains(said)), "{element}: {:?}", model.notes);
        assert!(model.links.is_empty());
    }
    let long = format!(
        "<mujoco><worldbody><composite type='cable' curve='s' count='900000000 1 1'>{geom}</composite></worldbody></mujoco>"
    );
    assert!(refused(&long).to_string().contains("300000 elements"));
}
