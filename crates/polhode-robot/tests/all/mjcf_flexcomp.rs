//! Bodies that `<flexcomp>` makes. The numbers are those of MuJoCo 4.0.0: `body_mass`, `body_inertia` and the place of the body at rest.

use std::fs;

use polhode_formats::ContentErrorKind;
use polhode_formats::FormatErrorKind;
use polhode_robot::body::{LinkMass, link_mass};
use polhode_robot::check::check;
use polhode_robot::model::{JointKind, RobotModel};
use polhode_robot::read::{ReadOptions, read_model};

use crate::common::{Folder, assert_close, read, refused};

/// Each row is a body: its name, mass, one of its equal moments, and its place in the world.
#[track_caller]
fn assert_places(model: &RobotModel, rows: &str) {
    for row in rows.lines() {
        let (name, numbers) = row.split_once(": ").unwrap();
        let numbers: Vec<f64> = numbers.split(' ').map(|number| number.parse().unwrap()).collect();
        let &[mass, moment, x, y, z] = numbers.as_slice() else { panic!("{row}") };
        let link =
            model.links.iter().find(|link| link.name.text == name).unwrap_or_else(|| panic!("no {name}"));
        let Ok(LinkMass::Body(body)) = link_mass(model.format, link) else { panic!("{name} has no mass") };
        let body = body.properties;
        assert!((body.mass() / mass - 1.0).abs() < 1e-8, "{name}: {} kg, not {mass}", body.mass());
        assert_close(body.principal().moments(), [moment; 3], 1e-8 * moment);
        assert_close(body.center_of_mass().to_array(), [0.0; 3], 0.0);
        assert_close(link.pose.position, [x, y, z], 2e-7);
    }
}

fn names<'m>(model: &'m RobotModel, start: &str) -> Vec<&'m str> {
    model.links.iter().filter_map(|link| link.name.text.strip_prefix(start)).collect()
}

/// Copies of a body with a flexcomp, and a model that is attached with one.
const FLEX: &str = r#"<mujoco><compiler eulerseq="zyX" boundmass="0.002"/><asset><model name="kid" file="kid.xml"/></asset><worldbody>
<body name="b" pos="0.3 -0.2 0.5" euler="20 -30 40"><geom size="0.1" mass="3"/>
  <frame pos="1 2 3" euler="10 20 30">
    <flexcomp name="grid" type="grid" dim="3" count="4 3 2" spacing="0.1 0.2 0.3" mass="1.7" inertiabox="0.03" pos="0.11 -0.07 0.23" euler="15 25 -35">
      <edge equality="true"/><pin id="0 3"/><pin range="5 6"/><pin grid="3 0 1"/><pin gridrange="1 1 0 2 2 1"/></flexcomp></frame>
  <flexcomp name="line" dim="1" count="4 1 1" spacing="0.1 0.2 0.3" zaxis="1 2 3"><edge equality="true"/></flexcomp>
  <flexcomp name="circle" type="circle" dim="1" count="7 1 1" spacing="0.1 0.2 0.3" mass="0.7" pos="0.1 0 0"><edge equality="true"/></flexcomp>
  <flexcomp name="tray" type="box" dim="2" count="4 3 5" spacing="0.1 0.2 0.3" axisangle="1 2 3 40"><edge equality="true"/></flexcomp>
  <flexcomp name="can" type="cylinder" dim="3" count="4 3 5" spacing="0.1 0.2 0.3" quat="0.5 0.5 -0.5 0.5"><edge equality="true"/></flexcomp>
  <flexcomp name="egg" type="ellipsoid" dim="3" dof="radial" count="3 4 5" spacing="0.1 0.2 0.3" xyaxes="1 2 0 0 1 1"><edge equality="true"/></flexcomp>
  <flexcomp name="disc" type="disc" dim="3" dof="2d" count="5 4 1" spacing="0.1 0.2 0.3" pos="1 0 1"><edge equality="true"/></flexcomp>
  <flexcomp name="still" type="square" count="3 3 1" rigid="true"/>
  <flexcomp name="four" type="direct" dim="3" scale="1.1 1.2 1.3" point="0 0 0  0.5 0.5 0.5  1 0 0  0 1 0  0 0 1.5  1 1 1" element="0 2 3 4  2 3 4 5" mass="0.01">
    <edge equality="true"/><pin id="3 1"/></flexcomp></body>
<replicate count="2" offset="1 0 0" euler="0 0 30" sep="-"><body name="twin" pos="0 1 0"><geom size="0.1"/>
  <flexcomp name="pair" dim="1" count="2 1 1" spacing="0.5 0.1 0.1" mass="0.3"><edge equality="true"/></flexcomp></body></replicate>
<attach model="kid" prefix="k_"/></worldbody></mujoco>"#;
const KID: &str = r#"<mujoco><worldbody><frame pos="0 0 4"><flexcomp name="rope" dim="1" count="3 1 1" mass="0.6" pos="0 1 0"><edge equality="true"/></flexcomp></frame></worldbody></mujoco>"#;

#[test]
fn particles_are_made_where_points_are_not_pinned() {
    let folder = Folder::of("particles_are_made", &[("flex.xml", FLEX), ("kid.xml", KID)]);
    let model = read_model(&folder.path("flex.xml"), &ReadOptions::default()).unwrap();
    assert_eq!(model.links.len(), 216);
    assert_eq!(names(&model, "grid_"), ["1", "2", "4", "7", "12", "13", "18", "20", "21", "22", "23"]);
    assert_eq!(names(&model, "four_"), ["0", "1", "3", "4"]);
    assert_eq!((names(&model, "egg_").len(), names(&model, "still").len()), (54, 0));
    let rows = "\
grid_1: 0.0708333333 4.25e-05 -0.814624827 -1.39951527 4.11771154\n\
grid_4: 0.0708333333 4.25e-05 -1.08116312 -1.0363994 3.90067654\n\
grid_23: 0.0708333333 4.25e-05 -0.903657634 -0.932215139 4.27167174\n\
line_0: 0.25 4.16666667e-06 0.159866192 -0.205395054 0.446770221\n\
line_3: 0.25 4.16666667e-06 0.440133808 -0.194604946 0.553229779\n\
circle_0: 0.116666667 1.94444444e-06 0.462759536 -0.218898574 0.614682942\n\
circle_5: 0.116666667 1.94444444e-06 0.451689465 -0.27651445 0.5337023\n\
tray_0: 0.0192307692 3.20512821e-07 0.424334566 0.061308491 -0.0820298859\n\
tray_11: 0.0192307692 3.20512821e-07 0.278527345 0.401376123 0.254265014\n\
tray_12: 0.0192307692 3.20512821e-07 0.398619089 -0.154362663 0.124911332\n\
tray_15: 0.0192307692 3.20512821e-07 0.321472655 -0.801376123 0.745734986\n\
tray_43: 0.0192307692 3.20512821e-07 0.175665434 -0.461308491 1.08202989\n\
tray_51: 0.0192307692 3.20512821e-07 0.33664624 -0.552909701 1.00656865\n\
can_0: 0.0181818182 3.03030303e-07 0.3 -0.2 0.5\n\
can_1: 0.0181818182 3.03030303e-07 0.259711013 0.291483076 0.884800186\n\
can_20: 0.0181818182 3.03030303e-07 0.48171977 -0.666291372 0.165260876\n\
can_54: 0.0181818182 3.03030303e-07 0.332129096 -0.51910465 0.401816787\n\
egg_1: 0.0181818182 3.03030303e-07 0.22112422 0.0710374718 0.228613498\n\
egg_29: 0.0181818182 3.03030303e-07 0.536552996 -0.0614521266 0.378151048\n\
egg_54: 0.0181818182 3.03030303e-07 0.394830336 -0.355618094 0.718189236\n\
disc_0: 0.05 8.33333333e-07 0.642478563 -1.03292502 1.56258915\n\
disc_6: 0.05 8.33333333e-07 0.625187191 -0.965558008 1.63160945\n\
disc_19: 0.05 8.33333333e-07 0.645424178 -0.931404148 1.69122186\n\
four_0: 0.002 3.33333333e-08 0.3 -0.2 0.5\n\
four_1: 0.002 3.33333333e-08 1.19517745 -0.303942158 1.13075618\n\
four_3: 0.002 3.33333333e-08 -0.616200305 -1.54095984 1.57930705\n\
four_4: 0.002 3.33333333e-08 0.173953074 -0.334099814 2.57512154\n\
pair_0-0: 0.15 2.5e-06 -0.25 1 0\n\
pair_1-1: 0.15 2.5e-06 1.25 0.866025404 0.5\n\
k_rope_0: 0.2 3.33333333e-06 -0.02 1 4\n\
k_rope_2: 0.2 3.33333333e-06 0.02 1 4";
    assert_places(&model, rows);
    let moves = |child: &str| {
        let joints = model.joints.iter().filter(|joint| joint.child.text == child);
        joints.map(|joint| (joint.kind, joint.axis)).collect::<Vec<_>>()
    };
    let [x, y, z] =
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|axis| (JointKind::Prismatic, axis));
    assert_eq!((moves("grid_4"), moves("disc_6")), (vec![x, y, z], vec![x, y]));
    assert_eq!(moves("egg_29").len(), 1);
    let findings = check(&model, &[]);
    assert!(findings.is_empty(), "{findings:?}");
}

/// A vertex twice, and one that no face has.
const WEDGE: &str = "\
v 0 0 0\n\
v 0.3 0 0\n\
v 0.3 0.2 0\n\
v 0 0.2 0\n\
v 0 0 0.11\n\
v 0 0.2 0.07\n\
v 0.3 0.2 0\n\
v 0.9 0.9 0.9\n\
f 1 4 3 2\n\
f 1 2 5\n\
f 4 6 3\n\
f 1 5 6 4\n\
f 2 7 6 5\n";
const LINES: &str = "v 0 0 0\nv 0.1 0 0\nv 0.9 0.9 0.9\nv 0.1 0.2 0\nv 0.1 0.2 0.3\nl 1 2 4\nl 4 5\n";
const MESHES: &str = r#"<mujoco><compiler meshdir="assets"/><asset><mesh name="w" file="wedge.obj" scale="1 -2 0.7" refpos="0.01 0.02 0.03" refquat="1 0.2 -0.1 0.3"/>
  <mesh name="dome" builtin="hemisphere" params="1"/></asset><worldbody>
<flexcomp name="skin" type="mesh" dim="2" file="wedge.obj" mass="0.6" scale="2 3 1" pos="1 0 0"><edge equality="true"/></flexcomp>
<flexcomp name="solid" type="mesh" dim="3" file="wedge.obj" mass="0.7" origin="0.1 0.1 0.02"><edge equality="true"/></flexcomp>
<flexcomp name="turned" type="mesh" dim="2" mesh="w" mass="0.6"><edge equality="true"/></flexcomp>
<flexcomp name="made" type="mesh" dim="3" origin="0 0 0.2" mesh="dome" mass="0.6"><edge equality="true"/></flexcomp>
<flexcomp name="ice" type="mesh" dim="2" file="drop.stl" mass="0.6"><edge equality="true"/></flexcomp>
<flexcomp name="edges" type="mesh" dim="1" file="lines.obj" mass="0.6" radius="0.001"><edge equality="true"/></flexcomp></worldbody></mujoco>"#;

/// A tetrahedron as binary STL.
fn drop() -> Vec<u8> {
    let vertices: [[f32; 3]; 4] = [[0.0; 3], [0.5, 0.0, 0.0], [0.0, 0.4, 0.0], [0.1, 0.1, 0.3]];
    let mut bytes = vec![0; 80];
    bytes.extend(4_u32.to_le_bytes());
    for corners in [[2, 1, 0], [0, 1, 3], [1, 2, 3], [2, 0, 3]] {
        bytes.extend([0; 12]);
        bytes.extend(corners.iter().flat_map(|&k| vertices[k]).flat_map(f32::to_le_bytes));
        bytes.extend([0; 2]);
    }
    bytes
}

#[test]
fn particles_stand_at_the_vertices_of_meshes() {
    let folder = Folder::of(
        "particles_of_meshes",
        &[("meshes.xml", MESHES), ("assets/wedge.obj", WEDGE), ("assets/lines.obj", LINES)],
    );
    fs::write(folder.path("assets/drop.stl"), drop()).unwrap();
    let model = read_model(&folder.path("meshes.xml"), &ReadOptions::default()).unwrap();
    let counts =
        ["skin_", "solid_", "turned_", "made_", "ice_", "edges_"].map(|start| names(&model, start).len());
    assert_eq!((counts, model.links.len()), ([6, 7, 7, 15, 4, 4], 43));
    let rows = "\
skin_1: 0.1 1.66666667e-06 1.60000002 0 0\n\
skin_2: 0.1 1.66666667e-06 1.60000002 0.600000009 0\n\
skin_5: 0.1 1.66666667e-06 1 0.600000009 0.0700000003\n\
solid_0: 0.1 1.66666667e-06 0.1 0.1 0.02\n\
solid_3: 0.1 1.66666667e-06 0.300000012 0.200000003 0\n\
solid_6: 0.1 1.66666667e-06 0 0.200000003 0.0700000003\n\
turned_1: 0.0857142857 1.42857143e-06 0.220877204 0.374385978 -0.0277543871\n\
turned_6: 0.0857142857 1.42857143e-06 0.319122817 0.0656140409 -0.084245615\n\
made_0: 0.04 6.66666667e-07 0 0 0.2\n\
made_9: 0.04 6.66666667e-07 -0.707106769 0.707106769 -2.2154768e-09\n\
ice_0: 0.15 2.5e-06 0 0.400000006 0\n\
ice_3: 0.15 2.5e-06 0.100000001 0.100000001 0.300000012\n\
edges_0: 0.15 2.5e-06 0 0 0\n\
edges_2: 0.15 2.5e-06 0.100000001 0.200000003 0\n\
edges_3: 0.15 2.5e-06 0.100000001 0.200000003 0.300000012";
    assert_places(&model, rows);
}

/// Five nodes and two tetrahedra that leave out the third, as MuJoCo reads them in each of Gmsh's forms.
fn gmsh() -> [(&'static str, Vec<u8>); 4] {
    let nodes = [
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.5, 0.5, 0.5],
        [0.0, 1.5, 0.0],
        [0.0, 0.0, 2.0],
        [1.0, 1.0, 1.0],
    ];
    let elements = [[1, 2, 4, 5], [2, 4, 5, 6]];
    let words = |numbers: &[f64]| numbers.iter().map(f64::to_string).collect::<Vec<_>>().join(" ");
    let file = |version: &str, nodes: &[u8], elements: &[u8]| {
        let head = format!("$MeshFormat\n{version} 8\n$EndMeshFormat\n$Nodes\n");
        let parts = [head.as_bytes(), nodes, b"\n$EndNodes\n$Elements\n", elements, b"\n$EndElements\n"];
        parts.concat()
    };
    let listed = |first: String, lines: Vec<String>| format!("{first}\n{}", lines.join("\n")).into_bytes();
    let numbered = (1..).zip(nodes).map(|(k, node)| format!("{k} {}", words(&node))).collect();
    let tagged = (1..)
        .zip(elements)
        .map(|(k, e)| format!("{k} 4 2 0 1 {} {} {} {}", e[0], e[1], e[2], e[3]))
        .collect();
    let lists = file("2.2 0", &listed("6".to_owned(), numbered), &listed("2".to_owned(), tagged));
    let tags = (1..=6).map(|k: i32| k.to_string());
    let block = tags.chain(nodes.iter().map(|node| words(node))).collect();
    let rows = (1..).zip(elements).map(|(k, e)| format!("{k} {} {} {} {}", e[0], e[1], e[2], e[3])).collect();
    let blocks = file(
        "4.1 0",
        &listed("1 6 1 6\n3 1 0 6".to_owned(), block),
        &listed("1 2 1 2\n3 1 4 2".to_owned(), rows),
    );
    let reals = |node: &[f64; 3]| node.iter().flat_map(|c| c.to_le_bytes()).collect::<Vec<u8>>();
    let small = |numbers: &[i32]| numbers.iter().flat_map(|n| n.to_le_bytes()).collect::<Vec<u8>>();
    let large = |numbers: &[u64]| numbers.iter().flat_map(|n| n.to_le_bytes()).collect::<Vec<u8>>();
    let head = |count: u64, kind: i32| {
        [large(&[1, count, 1, count]), small(&[3, 1, kind]), large(&[count])].concat()
    };
    let binary_nodes =
        [head(6, 0), large(&[1, 2, 3, 4, 5, 6]), nodes.iter().flat_map(reals).collect()].concat();
    let binary_elements = (1..).zip(elements).flat_map(|(k, e)| large(&[k, e[0], e[1], e[2], e[3]]));
    let binary_blocks = file("4.1 1", &binary_nodes, &[head(2, 4), binary_elements.collect()].concat());
    let counted = |count: &str, rest: Vec<u8>| [count.as_bytes(), b"\n", &rest].concat();
    let binary_nodes = (1..).zip(&nodes).flat_map(|(k, node)| [small(&[k]), reals(node)].concat()).collect();
    let binary_elements = (1..).zip(elements).flat_map(|(k, e)| {
        let e = e.map(|n| n as i32);
        small(&[4, 1, 2, k, 0, 1, e[0], e[1], e[2], e[3]])
    });
    let binary_lists = file("2.2 1", &counted("6", binary_nodes), &counted("2", binary_elements.collect()));
    [("lists", lists), ("blocks", blocks), ("binary-blocks", binary_blocks), ("binary-lists", binary_lists)]
}

#[test]
fn particles_stand_at_the_nodes_of_gmsh() {
    let folder = Folder::of("particles_of_gmsh", &[("folder", "")]);
    for (name, bytes) in gmsh() {
        fs::write(folder.path("nodes.msh"), &bytes).unwrap();
        let text = "<mujoco><worldbody><flexcomp name='g' type='gmsh' file='nodes.msh' scale='1 2 1' mass='3' pos='1 0 0'>\
            <pin id='3'/><edge equality='true'/></flexcomp></worldbody></mujoco>";
        fs::write(folder.path("gmsh.xml"), text).unwrap();
        let model = read_model(&folder.path("gmsh.xml"), &ReadOptions::default()).unwrap();
        assert_eq!(names(&model, "g_"), ["0", "1", "3", "4"], "{name}: {:?}", model.notes);
        // MuJoCo 4.0.0
        assert_places(
            &model,
            "g_0: 0.6 1e-05 1 0 0\ng_1: 0.6 1e-05 2 0 0\ng_3: 0.6 1e-05 1 0 2\ng_4: 0.6 1e-05 2 2 1",
        );
        for cut in [20, 45, bytes.len() / 2, bytes.len() - 30] {
            fs::write(folder.path("nodes.msh"), &bytes[..cut]).unwrap();
            let model = read_model(&folder.path("gmsh.xml"), &ReadOptions::default()).unwrap();
            assert_eq!((model.links.len(), model.notes[0].code), (0, "read.left_out"), "{name} {cut}");
        }
    }
}

#[test]
fn what_is_not_understood_is_refused_by_name() {
    let cases = [
        ("<body><geom size='1'/><flexcomp name='f' dim='1' count='3 1 1'/></body>", "has no name"),
        ("<replicate count='2'><flexcomp name='f' dim='1' count='3 1 1'/></replicate>", "has no name"),
        ("<flexcomp dim='1' count='3 1 1'/>", "it has no name"),
        ("<flexcomp name='f' dim='1' count='3 1 1' weight='2'/>", "weight=… is no attribute"),
        ("<flexcomp name='f' dim='1' count='3 1 1'><skin/></flexcomp>", "<skin> in it"),
        ("<flexcomp name='f' dim='1' count='3 1 1'><pin ids='1'/></flexcomp>", "ids=…"),
        ("<flexcomp name='f' dim='1' count='3 1 1'><pin id='3'/></flexcomp>", "out of range"),
        ("<flexcomp name='f' dim='1' count='3 1 1'><pin id='1.5'/></flexcomp>", "no index"),
        ("<flexcomp name='f' count='3 3 1'><pin grid='1 3'/></flexcomp>", "out of range"),
        ("<flexcomp name='f' count='3 3 1'><pin gridrange='0 0 1'/></flexcomp>", "too few numbers"),
        ("<flexcomp name='f' type='disc' count='3 3 1'><pin grid='1 1'/></flexcomp>", "grid pins"),
        ("<flexcomp name='f' count='3 3 2'/>", "does not fit"),
        ("<flexcomp name='f' dim='1' count='3 1'/>", "count=\"3 1\""),
        ("<flexcomp name='f' dim='4' count='3 1 1'/>", "dim is not"),
        ("<flexcomp name='f' dim='1' count='3 1 1' mass='0'/>", "mass or inertiabox"),
        ("<flexcomp name='f' dim='1' count='3 1 1' mass='nan'/>", "mass=\"nan\""),
        ("<flexcomp name='f' dim='1' count='3 1 1' radius='0.05'/>", "spacing is less"),
        ("<flexcomp name='f' dim='1' count='3 1 1'><contact margin='0.05'/></flexcomp>", "spacing is less"),
        ("<flexcomp name='f' dim='1' count='3 1 1' quat='1 1 0 0'/>", "quat"),
        ("<flexcomp name='f' dim='1' count='3 1 1' pos='0 0,5 0'/>", "a number that is none"),
        ("<flexcomp name='f' dim='1' count='3 1 1' dof='cubic'/>", "dof=\"cubic\""),
        ("<flexcomp name='f' dim='3' count='3 3 3' dof='trilinear'/>", "dof=\"trilinear\""),
        ("<flexcomp name='f' type='rope'/>", "\"rope\""),
        ("<flexcomp name='f' type='direct' dim='1' point='0 0 0 1 0 0' element='0 2'/>", "not there"),
        ("<flexcomp name='f' type='direct' dim='2' point='0 0 0 1 0 0' element='0 1'/>", "dim + 1"),
        ("<flexcomp name='f' type='direct' dim='1' point='0 0 0 1 0 0'/>", "no elements"),
        ("<flexcomp name='f' type='mesh' file='gone.obj'/>", "gone.obj"),
        ("<flexcomp name='f' type='mesh' mesh='gone'/>", "no mesh \"gone\""),
        ("<flexcomp name='f' type='gmsh'/>", "names no file"),
    ];
    for (element, said) in cases {
        let model = read(&format!("<mujoco><worldbody>{element}</worldbody></mujoco>"));
        let note = model.notes.iter().find(|note| note.code == "read.left_out");
        let message = note.map_or("", |note| &note.message);
        assert!(message.contains(said), "{element}: {:?}", model.notes);
        assert!(model.links.iter().all(|link| link.name.text.starts_with("body ")));
    }
}

#[test]
fn masses_that_need_all_bodies_are_refused_where_some_are_missing() {
    let model = |flex: &str| {
        read(&format!(
            "<mujoco><compiler settotalmass='9'/><worldbody><body name='b'><geom size='1'/></body>{flex}</worldbody></mujoco>"
        ))
    };
    let whole = model("<flexcomp name='f' dim='1' count='3 1 1'/>");
    let sum: f64 = whole
        .links
        .iter()
        .map(|link| match link_mass(whole.format, link) {
            Ok(LinkMass::Body(body)) => body.properties.mass(),
            other => panic!("{other:?}"),
        })
        .sum();
    assert!((sum - 9.0).abs() < 1e-12);
    let part = model("<flexcomp name='f' dim='1' count='3 1 1' more=''/>");
    assert!(
        link_mass(part.format, &part.links[0]).unwrap_err().to_string().contains("<flexcomp> is not read")
    );
}

#[test]
fn particles_without_number_are_refused() {
    for (kind, count) in
        [("grid", "900000000 900000000 900000000"), ("box", "3 3 900000"), ("circle", "400000 1 1")]
    {
        let dim = if kind == "circle" { 1 } else { 3 };
        let text = format!(
            "<mujoco><worldbody><flexcomp name='f' type='{kind}' dim='{dim}' count='{count}'/></worldbody></mujoco>"
        );
        let error = refused(&text);
        assert!(error.to_string().contains("300000 elements"), "{error}");
        assert!(
            matches!(error.kind(), FormatErrorKind::Content(e) if matches!(e.kind, ContentErrorKind::Unsupported { .. }))
        );
    }
}

#[test]
fn what_copies_read_again_is_counted() {
    let points = "0.125 0.25 0.5 ".repeat(40_000);
    let body = format!(
        "<body name='b'><flexcomp name='f' type='direct' dim='1' rigid='true' point='{points}' element='0 1'/></body>"
    );
    let copies = |count: usize| {
        format!("<mujoco><worldbody><replicate count='{count}'>{body}</replicate></worldbody></mujoco>")
    };
    assert_eq!(read(&copies(10)).links.len(), 10);
    assert!(refused(&copies(1000)).to_string().contains("300000 elements"));
}
