//! Content that readers once misread or ignored, found by reading public model files.

use polhode_robot::check::check;
use polhode_robot::finding::{Finding, Severity};
use polhode_robot::geometry::Shapes;
use polhode_robot::inspect::inspect;
use polhode_robot::lump::Lumping;
use polhode_robot::model::{RobotModel, Role};
use polhode_robot::read::{ReadOptions, read_model, read_text};
use polhode_source::files::Memory;

use crate::common::{Folder, read, refused, require_says};

fn found(text: &str) -> Vec<Finding> {
    inspect(&read(text), &Shapes::default()).findings
}

fn told<'f>(findings: &'f [Finding], code: &str) -> Vec<&'f str> {
    findings.iter().filter(|finding| finding.code == code).map(|finding| finding.message.as_str()).collect()
}

fn codes(findings: &[Finding]) -> Vec<&str> {
    findings.iter().filter(|finding| finding.severity > Severity::Note).map(|finding| finding.code).collect()
}

const INERTIA: &str = r#"<inertia ixx="0.031" iyy="0.042" izz="0.053" ixy="0.001" ixz="0.002" iyz="0.003"/>"#;

#[test]
fn angles_in_degrees_are_told_with_their_radians() {
    let link = |rpy: &str| {
        format!(
            "<robot name=\"r\"><link name=\"a\"><inertial><origin xyz=\"0.1 0 0.2\" rpy=\"{rpy}\"/><mass value=\"1.7\"/>{INERTIA}</inertial>\
             </link></robot>"
        )
    };
    let findings = found(&link("0 -45 90"));
    assert_eq!(codes(&findings), ["pose.degrees"]);
    let message = told(&findings, "pose.degrees")[0];
    assert!(
        message.contains("0 -45 90") && message.contains("0 -0.7853981633974483 1.5707963267948966"),
        "{message}"
    );
    for wrong in ["0 0 22.5", "0 -10 0", "1.57 0 90", "0 7 90"] {
        assert_eq!(codes(&found(&link(wrong))), ["pose.degrees"], "{wrong}");
    }
    for right in
        ["0 0 1.5707963", "0 -6.25 3", "0 0 0", "12.5664 0 0", "0 7 0", "3.14159 6.2832 7.0", "0 5 -2.5"]
    {
        assert_eq!(codes(&found(&link(right))), Vec::<&str>::new(), "{right}");
    }
    let joint = link("0 0 0").replace(
        "</robot>",
        "<link name=\"b\"/><joint name=\"j\" type=\"fixed\"><origin rpy=\"0 0 180\"/><parent link=\"a\"/><child link=\"b\"/></joint></robot>",
    );
    let findings = found(&joint);
    assert_eq!((codes(&findings), findings[0].subject.as_str()), (vec!["pose.degrees"], "j"));
    // An SDF attribute states if the angles are degrees.
    let sdf = |attribute: &str| {
        format!(
            "<sdf version=\"1.9\"><model name=\"m\"><link name=\"a\"><pose{attribute}>1 2 3 90 0 0</pose><inertial><mass>1.7</mass>\
             <inertia><ixx>0.031</ixx><iyy>0.042</iyy><izz>0.053</izz></inertia></inertial></link></model></sdf>"
        )
    };
    assert_eq!(codes(&found(&sdf(""))), ["pose.degrees"]);
    assert_eq!(codes(&found(&sdf(" degrees=\"true\""))), Vec::<&str>::new());
}

#[test]
fn a_number_too_many_is_counted_in_words() {
    let text = "<robot name=\"r\"><link name=\"a\"/><link name=\"b\"/><joint name=\"j\" type=\"fixed\"><origin rpy=\"0 1.57 0 0\"/>\
                <parent link=\"a\"/><child link=\"b\"/></joint></robot>";
    assert!(told(&found(text), "number.malformed")[0].contains("wrong count of numbers: 4"));
}

#[test]
fn srdf_is_no_urdf() {
    let text =
        "<robot name=\"r\"><group name=\"arm\"><chain base_link=\"a\" tip_link=\"b\"/></group></robot>";
    assert!(refused(text).message().contains("SRDF"));
}

#[test]
fn moments_of_less_than_an_atom_are_zero() {
    let text = "<robot name=\"r\"><link name=\"a\"><inertial><mass value=\"1.3\"/>\
                <inertia ixx=\"0\" iyy=\"0\" izz=\"0\" ixy=\"0\" ixz=\"2.40741e-35\" iyz=\"0\"/></inertial></link></robot>";
    let findings = found(text);
    assert_eq!(codes(&findings), ["inertia.zero"]);
    assert!(findings[0].message.contains("zero within rounding"), "{}", findings[0].message);
    // For a nanogram this tensor is not zero.
    let small = text.replace("1.3", "1e-12").replace("2.40741e-35", "2.40741e-19");
    assert_eq!(codes(&found(&small)), ["inertia.negative"]);
}

#[test]
fn what_others_include_is_read_once() {
    let text = r#"<mujocoinclude><worldbody><body name="a"><joint name="j"/><geom size="0.1"/></body></worldbody></mujocoinclude>"#;
    let model = read(text);
    assert_eq!((model.links.len(), model.joints.len()), (1, 1));
    assert_eq!(read(&text.replace("<worldbody>", "").replace("</worldbody>", "")).links.len(), 1);
}

#[test]
fn a_body_whose_include_is_not_there_may_have_mass() {
    let body = |inner: &str| {
        format!("<mujoco><worldbody><body name=\"a\">{inner}<joint/></body></worldbody></mujoco>")
    };
    let code =
        |inner: &str| codes(&found(&body(inner))).iter().map(|code| (*code).to_owned()).collect::<Vec<_>>();
    assert_eq!(code(""), ["mass.missing"]);
    assert!(code("<include file=\"none.xml\"/>").is_empty());
    assert!(code("<body><include file=\"none.xml\"/></body>").is_empty());
}

fn masses_are_known(model: &RobotModel) -> bool {
    model.links.iter().all(|link| !matches!(link.computed, Some(Err(_))))
}

// As accepted and rejected by MuJoCo 4.0.0.
#[test]
fn settings_that_mujoco_refuses_are_told_and_masses_are_not_known() {
    let model = |compiler: &str, geom: &str| {
        format!(
            "<mujoco><compiler {compiler}/><default><default class=\"soft\"/></default><worldbody><body name=\"a\"><joint/>\
             <geom {geom}/></body></worldbody></mujoco>"
        )
    };
    for right in [
        "settotalmass=\"3\" angle=\"radian\" inertiagrouprange=\"0 2\" balanceinertia=\"true\" inertiafromgeom=\"auto\" eulerseq=\"XYZ\"",
        "boundmass=\"1e-3\" boundinertia=\"\"",
    ] {
        let text = model(right, "size=\"0.1\" class=\"soft\"");
        assert!(masses_are_known(&read(&text)), "{right}");
        assert!(codes(&found(&text)).is_empty(), "{right}");
    }
    for (wrong, said) in [
        ("settotalmass=\"3 kg\"", "a number"),
        ("boundmass=\"small\"", "a number"),
        ("boundinertia=\"1 2\"", "a number"),
        ("inertiagrouprange=\"0\"", "two numbers"),
        ("balanceinertia=\"yes\"", "false or true"),
        ("inertiafromgeom=\"never\"", "false or true or auto"),
        ("angle=\"radians\"", "degree or radian"),
        ("eulerseq=\"xy\"", "three of"),
    ] {
        let text = model(wrong, "size=\"0.1\"");
        let name = wrong.split('=').next().unwrap();
        let findings = found(&text);
        let message = told(&findings, "read.compiler")[0];
        assert!(message.starts_with(name) && message.contains(said), "{message}");
        assert!(!masses_are_known(&read(&text)), "{wrong}");
    }
    for wrong in
        ["size=\"0.1\" class=\"hard\"", "type=\"capsule\" size=\"0.1\" fromto=\"0 0 0 0 0 1\" pos=\"1 0 0\""]
    {
        let text = model("", wrong);
        let findings = found(&text);
        assert_eq!(codes(&findings), ["read.unknown"], "{wrong}");
        assert!(findings.iter().any(|finding| finding.message.contains("MuJoCo refuses the file")));
        assert!(!masses_are_known(&read(&text)), "{wrong}");
    }
    let zero = model("", "type=\"capsule\" size=\"0.1\" fromto=\"0 0 0 0 0 1\" pos=\"0 0 0\"");
    assert!(masses_are_known(&read(&zero)) && codes(&found(&zero)).is_empty());
    // The class may be in the file that could not be read.
    let blind = model("", "size=\"0.1\" class=\"hard\"")
        .replace("<worldbody>", "<include file=\"none.xml\"/><worldbody>");
    assert!(codes(&found(&blind)).is_empty());
}

#[test]
fn an_opensim_body_says_each_number_once() {
    let model = |body: &str| {
        format!(
            "<OpenSimDocument Version=\"40000\"><Model name=\"leg\"><BodySet><objects><Body name=\"thigh\">{body}</Body></objects></BodySet>\
             </Model></OpenSimDocument>"
        )
    };
    let right =
        "<mass>9.3</mass><mass_center>0 -0.17 0</mass_center><inertia>0.1339 0.0351 0.1412 0 0 0</inertia>";
    assert!(codes(&found(&model(right))).is_empty());
    for (from, to, code) in [
        ("</mass>", "</mass><mass>8</mass>", "read.twice"),
        ("</inertia>", "</inertia><inertia>1 1 1 0 0 0</inertia>", "read.twice"),
        ("0 0 0</inertia>", "0 0 0 0.5</inertia>", "read.numbers"),
        ("9.3<", "9.3 9.4<", "read.numbers"),
    ] {
        let findings = found(&model(&right.replace(from, to)));
        assert!(codes(&findings).contains(&code), "{to}: {findings:#?}");
    }
}

#[test]
fn a_joint_of_an_unread_frame_is_left_out_with_a_note() {
    let text = r#"<OpenSimDocument Version="40000"><Model name="m"><BodySet><objects>
      <Body name="a"><mass>1</mass><mass_center>0 0 0</mass_center><inertia>1 1 1 0 0 0</inertia></Body></objects></BodySet>
      <JointSet><objects><FreeJoint name="j"><socket_parent_frame>/ground</socket_parent_frame><socket_child_frame>/marked</socket_child_frame>
      </FreeJoint></objects></JointSet>
      <ComponentSet><objects><StationDefinedFrame name="marked"/></objects></ComponentSet></Model></OpenSimDocument>"#;
    let model = read(text);
    assert!(model.joints.is_empty());
    assert_eq!((model.notes[0].code, model.notes[0].subject.as_str()), ("read.left_out", "j"));
    assert!(check(&model, &[]).iter().all(|finding| finding.code != "tree.unknown_link"));
}

#[test]
fn lists_of_usd_are_edited() {
    let model = |schemas: &str| {
        read(&format!(
            "#usda 1.0\n(metersPerUnit = 1)\ndef Xform \"a\" (\n{schemas}\n)\n{{\n float physics:mass = 2\n def Xform \"b\" {{ float physics:mass = 3 }}\n}}"
        ))
    };
    // A body by its schema, with b inside; otherwise each prim with a mass is a body.
    for both in [
        "prepend apiSchemas = [\"PhysicsMassAPI\"]\nappend apiSchemas = [\"PhysicsRigidBodyAPI\"]",
        "prepend apiSchemas = [\"PhysicsRigidBodyAPI\"]\nprepend apiSchemas = [\"PhysicsMassAPI\"]",
        "delete apiSchemas = [\"PhysicsRigidBodyAPI\"]\nprepend apiSchemas = [\"PhysicsRigidBodyAPI\"]",
        "prepend apiSchemas = [\"PhysicsRigidBodyAPI\"]\nreorder apiSchemas = [\"PhysicsMassAPI\", \"PhysicsRigidBodyAPI\"]",
    ] {
        let text = model(both);
        assert_eq!(text.links.len(), 1, "{both}");
        assert!(!text.links[0].is_static);
    }
    let inner = |schemas: &str| {
        let text = format!("#usda 1.0\n(metersPerUnit = 1)\ndef Xform \"a\" ({schemas}) {{}}");
        read(&text).links.len()
    };
    assert_eq!(inner("prepend apiSchemas = [\"PhysicsRigidBodyAPI\"]"), 1);
    assert_eq!(inner("delete apiSchemas = [\"PhysicsRigidBodyAPI\"]"), 0);
    assert_eq!(inner("reorder apiSchemas = [\"PhysicsRigidBodyAPI\"]"), 0);
    assert_eq!(
        inner("prepend apiSchemas = [\"PhysicsMassAPI\"]\nappend apiSchemas = [\"PhysicsRigidBodyAPI\"]"),
        1
    );
}

#[test]
fn names_that_would_fill_any_memory_are_refused() {
    let long = "n".repeat(1 << 17);
    let usd = format!("#usda 1.0\ndef Xform \"{long}\" {{\n{}}}\n", "def Xform \"a\" {}\n".repeat(400));
    assert!(refused(&usd).message().contains("in total"), "{}", refused(&usd).message());
    // The same with names of a length in proportion to the text.
    assert!(read(&usd.replace(&long, "n")).links.is_empty());
    for inner in ["<joint/>", "<body name=\"b\"/>"] {
        let mjcf = format!(
            "<mujoco><worldbody><body name=\"{long}\"><geom size=\"1\"/>{}</body></worldbody></mujoco>",
            inner.repeat(600)
        );
        assert!(refused(&mjcf).message().contains("in total"), "{inner}");
    }
}

#[test]
fn shapes_of_a_model_that_is_included_often_are_counted() {
    let shapes = "<visual><geometry><box><size>1 2 3</size></box></geometry></visual>".repeat(2000);
    let part =
        format!("<sdf version=\"1.9\"><model name=\"part\"><link name=\"a\">{shapes}</link></model></sdf>");
    let include = "<include><uri>part.sdf</uri></include>";
    let world = |count: usize| {
        format!("<sdf version=\"1.9\"><world name=\"w\">{}</world></sdf>", include.repeat(count))
    };
    let (few, many) = (world(3), world(200));
    let folder = Folder::of("sdf-shapes", &[("part.sdf", &part), ("few.sdf", &few), ("many.sdf", &many)]);
    let read = |file: &str| read_model(&folder.path(file), &ReadOptions::default());
    assert_eq!(read("few.sdf").unwrap().links.len(), 3);
    assert!(read("many.sdf").unwrap_err().message().contains("more than 300000 elements"));
}

#[test]
fn a_model_in_memory_finds_its_meshes_there() {
    let mesh = "OFF\n4 4 0\n0 0 0\n0.3 0 0\n0 0.4 0\n0 0 0.5\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
    let urdf = "<robot name=\"r\"><link name=\"a\"><collision><geometry>\
                <mesh filename=\"package://arm/meshes/a.off\"/></geometry></collision></link></robot>";
    let memory = Memory::from([
        ("arm/package.xml", "<package><name>arm</name></package>"),
        ("arm/urdf/arm.urdf", urdf),
        ("arm/meshes/a.off", mesh),
    ]);
    let options = ReadOptions { files: &memory, ..ReadOptions::default() };
    let model = read_model("arm/urdf/arm.urdf".as_ref(), &options).unwrap();
    let shapes = Shapes::default().from_files(&memory);
    let volume = shapes.link(&model.links[0], Role::Collision).volume.unwrap().volume;
    assert!((volume - 0.3 * 0.4 * 0.5 / 6.0).abs() < 1e-17, "{volume}");
}

#[test]
fn a_model_in_a_folder_finds_the_same_files_in_memory_as_on_disk() {
    let mesh = |height: &str| {
        format!("OFF\n4 4 0\n0 0 0\n0.3 0 0\n0 0.4 0\n0 0 {height}\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n")
    };
    let (low, high) = (mesh("0.5"), mesh("0.7"));
    let urdf = "<robot name=\"r\"><link name=\"a\"><collision><geometry><mesh filename=\"meshes/a.off\"/></geometry></collision></link></robot>";
    let sdf = "<sdf version=\"1.9\"><model name=\"m\"><link name=\"a\"><collision name=\"c\"><geometry><mesh><uri>meshes/a.off</uri></mesh>\
               </geometry></collision></link></model></sdf>";
    // The folder of the meshes has the name of the model's own.
    let mjcf = "<mujoco><compiler meshdir=\"p\"/><asset><mesh name=\"m\" file=\"b.off\"/></asset><worldbody><include file=\"inc.xml\"/></worldbody></mujoco>";
    let included = "<mujoco><body name=\"a\"><geom type=\"mesh\" mesh=\"m\"/></body></mujoco>";
    let files = [
        ("p/a.urdf", urdf),
        ("p/a.sdf", sdf),
        ("p/a.xml", mjcf),
        ("p/inc.xml", included),
        ("p/meshes/a.off", &low),
        ("p/p/b.off", &high),
    ];
    let (folder, memory) = (Folder::of("same-in-memory", &files), Memory::from(files));
    for (file, height) in [("p/a.urdf", 0.5), ("p/a.sdf", 0.5), ("p/a.xml", 0.7)] {
        let on_disk = read_model(&folder.path(file), &ReadOptions::default()).unwrap();
        let options = ReadOptions { files: &memory, ..ReadOptions::default() };
        let in_memory = read_model(file.as_ref(), &options).unwrap();
        let shapes = [Shapes::default(), Shapes::default().from_files(&memory)];
        for (model, shapes) in [on_disk, in_memory].into_iter().zip(shapes) {
            assert!(model.notes.is_empty(), "{file}: {:?}", model.notes);
            let link = model.links.iter().find(|link| link.name.text == "a").unwrap();
            let volume = shapes.link(link, Role::Collision).volume.unwrap().volume;
            assert!((volume - 0.02 * height).abs() < 1e-17, "{file}: {volume}");
        }
    }
}

#[test]
#[cfg(unix)]
fn no_link_leads_out_of_a_confined_folder() {
    use std::os::unix::fs::symlink;
    let folder = Folder::of(
        "confined-links",
        &[
            ("outside/package.xml", "<package><name>secret</name></package>"),
            ("outside/model.config", "<model><sdf version=\"1.9\">model.sdf</sdf></model>"),
            ("outside/model.sdf", "<sdf version=\"1.9\"><model name=\"m\"><link name=\"l\"/></model></sdf>"),
            ("inside/part.stl", "solid"),
            (
                "inside/linked/model.sdf",
                "<sdf version=\"1.9\"><model name=\"m\"><link name=\"own\"/></model></sdf>",
            ),
            (
                "inside/deep/wheel.sdf",
                "<sdf version=\"1.9\"><model name=\"m\"><link name=\"rim\"/></model></sdf>",
            ),
        ],
    );
    symlink(folder.path("outside/package.xml"), folder.path("inside/package.xml")).unwrap();
    symlink(folder.path("outside/model.config"), folder.path("inside/linked/model.config")).unwrap();
    let options =
        ReadOptions { roots: vec![folder.path("inside")], confined: true, ..ReadOptions::default() };
    let model = |text: &str, file: &str| read_text(text, &folder.path(file), &options).unwrap();
    let urdf = "<robot><link name=\"a\"><visual><geometry><mesh filename=\"package://secret/part.stl\"/></geometry></visual></link></robot>";
    let shape = format!("{:?}", model(urdf, "inside/a.urdf").links[0].geometry[0].shape);
    assert!(shape.contains("Err("), "the name in the linked package.xml is not the folder's: {shape}");
    let world = |uri: &str| {
        format!("<sdf version=\"1.9\"><world name=\"w\"><include><uri>{uri}</uri></include></world></sdf>")
    };
    let linked = model(&world("linked"), "inside/w.sdf");
    assert!(linked.links.is_empty() && linked.notes[0].code == "read.include", "{linked:#?}");
    // Names are relative to the file that contains them, and stay inside.
    assert_eq!(model(&world("deep/wheel.sdf"), "inside/w.sdf").links.len(), 1);
    assert_eq!(model(&world("../deep/wheel.sdf"), "inside/linked/w.sdf").links.len(), 1);
    for outside in ["../outside", "../outside/model.sdf", "deep/../../outside/model.sdf"] {
        assert!(model(&world(outside), "inside/w.sdf").links.is_empty(), "{outside}");
    }
}

#[test]
fn a_models_own_package_goes_before_others_of_its_name() {
    let package = "<package><name>arm</name></package>";
    let folder = Folder::of(
        "own-package",
        &[
            ("old/arm/package.xml", package),
            ("old/arm/part.stl", "solid old"),
            ("new/arm/package.xml", package),
            ("new/arm/part.stl", "solid new"),
        ],
    );
    let text = "<robot><link name=\"a\"><visual><geometry><mesh filename=\"package://arm/part.stl\"/></geometry></visual></link></robot>";
    let options = ReadOptions { roots: vec![folder.path("old")], confined: false, ..ReadOptions::default() };
    let model = read_text(text, &folder.path("new/arm/arm.urdf"), &options).unwrap();
    let shape = format!("{:?}", model.links[0].geometry[0].shape);
    assert!(shape.contains("new/arm/part.stl") || shape.contains("new\\\\arm"), "{shape}");
}

#[test]
fn moments_of_one_digit_are_no_other_unit() {
    let link = |tensor: &str| {
        format!(
            "<robot name=\"r\"><link name=\"a\"><collision><geometry><box size=\"0.1 0.08 0.12\"/></geometry></collision><inertial>\
             <mass value=\"0.1\"/><inertia {tensor} ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link></robot>"
        )
    };
    let findings = found(&link("ixx=\"1\" iyy=\"1\" izz=\"0\""));
    assert_eq!(codes(&findings), ["gyration.too_large"]);
    assert!(findings[0].message.ends_with("a placeholder?"), "{}", findings[0].message);
    assert_eq!(codes(&found(&link("ixx=\"1.3\" iyy=\"1.1\" izz=\"0.9\""))), ["inertia.unit"]);
}

#[test]
fn a_kind_of_joint_that_is_none_is_told_and_refused() {
    let model = |kind: &str| {
        let inertial = format!("<inertial><mass value=\"1.7\"/>{INERTIA}</inertial>");
        format!(
            "<robot name=\"r\"><link name=\"a\">{inertial}</link><link name=\"b\">{inertial}</link>\
             <joint name=\"j\"{kind}><parent link=\"a\"/><child link=\"b\"/><axis xyz=\"0 0 1\"/></joint></robot>"
        )
    };
    for wrong in [" type=\"Revolute\"", ""] {
        let findings = found(&model(wrong));
        assert_eq!((codes(&findings), findings[0].subject.as_str()), (vec!["read.unknown"], "j"), "{wrong}");
        let refused = crate::mimic::error(&crate::common::read(&model(wrong)), Lumping::All, &[]);
        require_says(&refused, "the position of the child of joint \"j\" is unknown");
    }
    assert_eq!(codes(&found(&model(" type=\"planar\""))), Vec::<&str>::new());
    let inertia = "<inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia>";
    let sdf = |kind: &str| {
        let link =
            |name: &str| format!("<link name='{name}'><inertial><mass>1</mass>{inertia}</inertial></link>");
        let joint = format!("<joint name='j' type='{kind}'><parent>a</parent><child>b</child></joint>");
        format!("<sdf version='1.9'><model name='m'>{}{}{joint}</model></sdf>", link("a"), link("b"))
    };
    let mjcf = |kind: &str| {
        format!(
            "<mujoco><worldbody><body name='a'><joint name='j' type='{kind}'/><geom size='0.1'/></body></worldbody></mujoco>"
        )
    };
    for (wrong, right) in [(sdf("Revolute"), sdf("ball")), (mjcf("hnge"), mjcf("ball"))] {
        let refused = crate::mimic::error(&crate::common::read(&wrong), Lumping::All, &[]);
        require_says(&refused, "the position of the child of joint \"j\" is unknown");
        crate::mimic::one(&crate::common::read(&right), Lumping::All, &[]);
    }
}

#[test]
fn attributes_that_mujoco_refuses_are_told_with_what_was_meant() {
    let model = |compiler: &str, geom: &str| {
        format!(
            "<mujoco><compiler {compiler}/><worldbody><body name='arm'><joint/><geom size='0.1' {geom}/></body></worldbody></mujoco>"
        )
    };
    for (text, subject, meant) in [
        (model("", "densty='30'"), "arm", "density"),
        (model("settotalMass='3'", ""), "", "settotalmass"),
        (model("", "").replace("<joint/>", "<joint axs='0 0 1'/>"), "arm", "axis"),
    ] {
        let findings = found(&text);
        assert_eq!(codes(&findings), ["read.unknown"], "{text}");
        assert_eq!(findings[0].subject, subject);
        let message = &findings[0].message;
        assert!(message.contains(&format!("did you mean {meant}?")), "{message}");
        let wrong = message.split('=').next().unwrap();
        assert_eq!(codes(&found(&text.replace(wrong, meant))), [""; 0], "{message}");
    }
    assert_eq!(
        codes(&found(
            &model("angle='radian'", "density='30' class='c' rgba='1 0 0 1'").replace(" class='c'", "")
        )),
        Vec::<&str>::new()
    );
    // A value that MuJoCo accepts, but that is not read here, is not reported as rejected.
    let findings = found(&model("settotalmass='0x10'", ""));
    assert!(findings.iter().any(|finding| finding.message.contains("hexadecimal")));
}

#[test]
fn a_tensor_written_as_a_matrix_is_told_with_its_six_names() {
    let rows = "0.031 0.004 -0.003 0.004 0.042 0.002 -0.003 0.002 0.053";
    let six = r#"write ixx="0.031" ixy="0.004" ixz="-0.003" iyy="0.042" iyz="0.002" izz="0.053""#;
    let urdf = |inertia: &str| {
        format!(
            "<robot name=\"r\"><link name=\"a\"><inertial><mass value=\"1.7\"/>{inertia}</inertial></link></robot>"
        )
    };
    for inertia in [
        format!("<inertia>{rows}</inertia>"),
        format!("<inertia matrix=\"{rows}\"/>"),
        format!("<inertia value=\"{rows}\"/>"),
    ] {
        let findings = found(&urdf(&inertia));
        let [message] = told(&findings, "read.unknown")[..] else { panic!("{findings:?}") };
        assert!(message.starts_with("a tensor of 9 numbers") && message.contains(six), "{message}");
    }
    // For a matrix that is not symmetric, or only an upper triangle, the message lists the names
    // without values.
    for text in
        [rows.replace("-0.003 0.002 0.053", "0.003 0.002 0.053"), "0.031 0 0 0.042 0 0.053".to_owned()]
    {
        let findings = found(&urdf(&format!("<inertia>{text}</inertia>")));
        let [message] = told(&findings, "read.unknown")[..] else { panic!("{findings:?}") };
        assert!(
            message.ends_with("programs read the six attributes ixx, ixy, ixz, iyy, iyz, izz"),
            "{message}"
        );
    }
    let sdf = format!(
        "<sdf version=\"1.9\"><model name=\"m\"><link name=\"a\"><inertial><mass>1.7</mass><inertia>{rows}</inertia></inertial></link></model></sdf>"
    );
    assert!(told(&found(&sdf), "read.unknown")[0].contains("write <ixx>0.031</ixx> <ixy>0.004</ixy>"));
    let mjcf = format!(
        "<mujoco><worldbody><body name=\"a\"><inertial pos=\"0 0 0\" mass=\"1.7\" fullinertia=\"{rows}\"/></body></worldbody></mujoco>"
    );
    assert!(told(&found(&mjcf), "read.numbers")[0].contains("the six are xx yy zz xy xz yz"));
    assert_eq!(told(&found(&urdf(INERTIA)), "read.unknown"), Vec::<&str>::new());
}

#[test]
fn a_second_element_of_a_joint_or_shape_is_told() {
    let urdf = |shape: &str, joint: &str| {
        format!(
            "<robot name=\"r\"><link name=\"a\"/><link name=\"b\"><inertial><mass value=\"1.7\"/>{INERTIA}</inertial><visual>{shape}</visual></link>\
             <joint name=\"j\" type=\"continuous\"><parent link=\"a\"/><child link=\"b\"/>{joint}</joint></robot>"
        )
    };
    let sphere = "<geometry><sphere radius=\"0.3\"/></geometry>";
    let axis = "<axis xyz=\"0 0 1\"/>";
    let twice = |shape: &str, joint: &str| told(&found(&urdf(shape, joint)), "read.twice").len();
    assert_eq!(twice(sphere, axis), 0);
    for joint in ["<origin xyz=\"0 0 1\"/>", axis, "<mimic joint=\"k\"/>", "<limit lower=\"0\" upper=\"1\"/>"]
    {
        assert_eq!(twice(sphere, &joint.repeat(2)), 1, "{joint}");
    }
    for shape in [
        sphere.repeat(2),
        "<geometry><sphere radius=\"0.3\"/><box size=\"1 1 1\"/></geometry>".to_owned(),
        format!("{sphere}<origin xyz=\"0 0 1\"/><origin xyz=\"0 0 2\"/>"),
    ] {
        assert_eq!(twice(&shape, axis), 1, "{shape}");
    }
    let sdf = "<sdf version=\"1.9\"><model name=\"m\"><link name=\"a\"><inertial><mass>1</mass></inertial></link><link name=\"b\">\
        <inertial><mass>1</mass></inertial></link><joint name=\"j\" type=\"revolute\"><parent>a</parent><child>b</child><child>a</child>\
        <pose>0 0 1 0 0 0</pose><pose>0 0 2 0 0 0</pose></joint></model></sdf>";
    assert_eq!(told(&found(sdf), "read.twice").len(), 2);
}
