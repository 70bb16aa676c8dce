//! Hostile files: excessive memory or time, access to other files, and wrong positions.

use std::fs;
use std::path::{Path, PathBuf};

use polhode_robot::geometry::Shapes;
use polhode_robot::inspect::inspect;
use polhode_robot::model::{GeometryShape, Link, Role, Slot, Tensor};
use polhode_robot::read::{ReadOptions, format_of, read_model, read_text};
use polhode_source::ContentErrorKind;
use polhode_source::FormatErrorKind;

use crate::common::{read, refused};

#[test]
fn document_types_are_refused_where_they_stand() {
    let laughs = "<!DOCTYPE robot [<!ENTITY a 'ha'><!ENTITY b '&a;&a;&a;&a;'>]><robot name='&b;'/>";
    for text in [laughs, "<!DOCTYPE robot SYSTEM 'file:///etc/passwd'><robot/>", "<!DOCTYPE robot><robot/>"] {
        let text = format!("<?xml version='1.0'?>\r\n  {text}");
        let error = refused(&text);
        assert!(
            matches!(error.kind(), FormatErrorKind::Content(e) if matches!(e.kind, ContentErrorKind::Unsupported { .. }))
        );
        let place = error.place().unwrap();
        assert_eq!((place.line, place.column), (2, 3), "{error}");
        assert!(error.hint().unwrap().contains("DOCTYPE"));
    }
    assert!(refused("<robot name='&b;'/>").to_string().contains("unknown entity"));
}

#[test]
fn depth_costs_no_stack_and_no_memory_beyond_the_text() {
    let deep = |open: &str, close: &str, n: usize| format!("{}{}", open.repeat(n), close.repeat(n));
    let n = 100_000;
    let urdf = format!("<robot>{}</robot>", deep("<link name='a'>", "</link>", n));
    assert_eq!(read(&urdf).links.len(), 1);
    let mjcf = format!("<mujoco><worldbody>{}</worldbody></mujoco>", deep("<body>", "</body>", n));
    assert_eq!(read(&mjcf).links.len(), n);
    let mjcf = format!("<mujoco>{}</mujoco>", deep("<default class='a'><geom size='1'/>", "</default>", n));
    assert_eq!(read(&mjcf).links.len(), 0);
    // Each link name contains the names of all enclosing models, so the total grows with the square
    // of the text.
    let sdf = format!("<sdf>{}</sdf>", deep("<model name='m'><link name='a'/>", "</model>", n));
    assert!(refused(&sdf).to_string().contains("nested so deep"));
    let unclosed = "<robot><link>".repeat(n);
    assert!(refused(&unclosed).to_string().contains("the end of the root element"));
}

#[test]
fn many_attributes_and_namespaces_cost_no_time_that_grows_with_their_square() {
    let attributes: String = (0..300_000).map(|k| format!(" a{k}='1'")).collect();
    let error = refused(&format!("<robot>\n<link{attributes}/></robot>"));
    assert_eq!((error.place().unwrap().line, error.place().unwrap().column), (2, 1));
    let nested: String = (0..60_000).map(|k| format!("<a xmlns:n{k}='u{k}'>")).collect();
    let text = format!("<robot>{nested}{}<link name='l'/></robot>", "</a>".repeat(60_000));
    assert_eq!(read(&text).links.len(), 1);
    let words = "1 ".repeat(500_000);
    let text = format!("<robot><link name='l'><inertial><origin xyz='{words}'/></inertial></link></robot>");
    assert_eq!(read(&text).links[0].inertial.as_ref().unwrap().pose.unreadable.len(), 1);
}

#[test]
fn frames_that_name_each_other_cost_no_time_that_grows_with_their_square() {
    let pairs: String = (0..30_000)
        .map(|k| format!("<frame name='a{k}' attached_to='b{k}'/><frame name='b{k}' attached_to='a{k}'/>"))
        .collect();
    let chain: String =
        (0..60_000).map(|k| format!("<frame name='c{}' attached_to='c{k}'/>", k + 1)).collect();
    let text = format!("<sdf><model name='m'>{pairs}{chain}<link name='c0'/></model></sdf>");
    let model = read(&text);
    assert_eq!(model.notes.len(), 30_000);
    assert_eq!(model.links.len(), 1);
}

#[test]
fn places_are_those_of_the_text_with_marks_breaks_and_entities() {
    let text = "\u{feff}<?xml version=\"1.0\" encoding=\"UTF-8\"?>\r\n<robot name='ß'>\r\n<link name='a&#x62;&amp;c'><inertial>\r\n\
        <origin rpy='\t0.1\r\n0.2 x ' xyz='&#49;.5 2 &gt;'/>\r\n<mass   value \n =  '&#49;.5'/><inertia ixx=' 1e-3\t' iyy=\"2\"/></inertial></link></robot>";
    let model = read(text);
    let link = &model.links[0];
    assert_eq!((link.name.text.as_str(), &text[link.name.span.clone()]), ("ab&c", "a&#x62;&amp;c"));
    let inertial = link.inertial.as_ref().unwrap();
    assert_eq!((inertial.mass.finite(), &text[inertial.mass.span()]), (Some(1.5), "&#49;.5"));
    assert_eq!(inertial.pose.position, [1.5, 2.0, 0.0]);
    let bad: Vec<_> =
        inertial.pose.unreadable.iter().map(|n| (n.text.as_str(), &text[n.span.clone()])).collect();
    assert_eq!(bad, [(">", "&#49;.5 2 &gt;"), ("x", "x")]);
    let Tensor::Six(six) = &inertial.tensor else { panic!("six") };
    assert_eq!((&text[six[0].span()], &text[six[1].span()]), ("1e-3", "2"));
    // The parser's own positions are wrong after 255 blanks.
    let wide = format!("<robot><link name{}=\"arm\"/></robot>", " ".repeat(1000));
    assert_eq!(&wide[read(&wide).links[0].name.span.clone()], "arm");
}

#[test]
fn what_is_no_xml_says_where() {
    let cases = [
        ("<robot>\n <link></lnk></robot>", 2, 8, "</link>"),
        ("<robot>\n <link name=arm/></robot>", 2, 13, "well-formed XML"),
        ("<robot><link name='a' name='b'/></robot>", 1, 23, "already defined"),
        ("", 1, 1, "root"),
        ("   just words", 1, 4, "XML"),
        ("<robot/><robot/>", 1, 9, "XML"),
        ("<robot>\n<!-- <link/>", 2, 1, "-->"),
    ];
    for (text, line, column, words) in cases {
        let error = refused(text);
        let place = error.place().unwrap();
        assert_eq!((place.line, place.column), (line, column), "{text:?}: {error}");
        assert!(error.to_string().contains(words), "{text:?}: {error}");
    }
    assert_eq!(format_of("<!-- "), None);
}

#[test]
fn what_other_readers_take_is_taken() {
    let text = "\n<?xml version='1.0'?><!-- -- a -- b -- -->\n<robot><link name='a'/><body:empty/><gazebo sensor:kind='x'/></robot>";
    assert_eq!(read(text).links.len(), 1);
}

#[test]
fn places_beyond_the_largest_double_are_noted() {
    let body = "<body pos='1e308 -1e308 1e308' euler='10 20 30'>".repeat(3);
    let model = read(&format!("<mujoco><worldbody>{body}{}</worldbody></mujoco>", "</body>".repeat(3)));
    assert!(model.links.iter().all(|link| link.pose.position.iter().all(|c| c.is_finite())));
    assert!(!model.notes.is_empty() && model.notes.iter().all(|note| note.code == "read.pose"));
}

/// Temporary folder, deleted at the end of the test.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(format!("polhode-robot-{name}-{}", std::process::id()));
        let _ = fs::remove_dir_all(&path);
        fs::create_dir_all(&path).unwrap();
        Self(fs::canonicalize(path).unwrap())
    }

    fn write(&self, path: &str, text: &str) -> PathBuf {
        let path = self.0.join(path);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(&path, text).unwrap();
        path
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// Returns the path of a model's mesh.
fn found(model: &Path, uri: &str, roots: &[&Path]) -> Result<PathBuf, String> {
    let text = format!(
        "<robot><link name='a'><collision><geometry><mesh filename='{uri}'/></geometry></collision></link></robot>"
    );
    fs::write(model, text).unwrap();
    let options = ReadOptions {
        roots: roots.iter().map(|root| root.to_path_buf()).collect(),
        ..ReadOptions::default()
    };
    let model = read_model(model, &options).unwrap();
    match &model.links[0].geometry[0].shape {
        GeometryShape::Mesh { path, .. } => path.clone(),
        other => panic!("{other:?}"),
    }
}

#[test]
fn meshes_are_found_under_the_roots_only() {
    let folder = Folder::new("roots");
    let ws = folder.0.clone();
    let package = ws.join("ws/arm-main");
    let model = folder.write("ws/arm-main/urdf/arm.urdf", "");
    folder.write("ws/arm-main/package.xml", "<package><name>arm</name></package>");
    let mesh = folder.write("ws/arm-main/meshes/a.stl", "");
    let beside = folder.write("ws/arm-main/urdf/b.stl", "");
    let other = folder.write("ws/hand/meshes/c.stl", "");
    let secret = folder.write("secret.stl", "");

    assert_eq!(found(&model, "b.stl", &[]), Ok(beside.clone()));
    assert_eq!(found(&model, "file://b.stl", &[]), Ok(beside.clone()));
    assert_eq!(found(&model, &format!("file://{}", beside.display()), &[]), Ok(beside.clone()));
    assert_eq!(found(&model, "../meshes/./a.stl", &[]), Ok(mesh.clone()));
    for uri in [
        "package://arm/meshes/a.stl",
        "package://arm-main/meshes/a.stl",
        "package://arm/urdf/../meshes/a.stl",
    ] {
        assert_eq!(found(&model, uri, &[]), Ok(mesh.clone()), "{uri}");
    }
    assert!(found(&model, "package://hand/meshes/c.stl", &[]).unwrap_err().contains("--root"));
    assert_eq!(found(&model, "package://hand/meshes/c.stl", &[&ws.join("ws")]), Ok(other.clone()));
    assert_eq!(found(&model, "model://hand/meshes/c.stl", &[&ws.join("ws/hand")]), Ok(other));

    let absolute = secret.display().to_string();
    let outside = [
        "../../../secret.stl",
        "package://arm/../../secret.stl",
        "package://../../secret.stl",
        "file:///etc/passwd",
        &absolute,
    ];
    for uri in outside {
        assert!(found(&model, uri, &[]).unwrap_err().contains("outside"), "{uri}");
    }
    assert!(found(&model, "https://example.org/a.stl", &[]).unwrap_err().contains("https://"));
    assert!(found(&model, "meshes", &[]).unwrap_err().contains("does not exist"));
    assert!(found(&model, "", &[]).is_err());

    #[cfg(unix)]
    {
        std::os::unix::fs::symlink(&secret, package.join("meshes/out.stl")).unwrap();
        std::os::unix::fs::symlink(&ws, package.join("meshes/up")).unwrap();
        std::os::unix::fs::symlink(&mesh, package.join("meshes/in.stl")).unwrap();
        for uri in ["../meshes/out.stl", "package://arm/meshes/out.stl", "../meshes/up/secret.stl"] {
            assert!(found(&model, uri, &[]).unwrap_err().contains("outside"), "{uri}");
        }
        assert_eq!(found(&model, "../meshes/in.stl", &[]), Ok(mesh));
    }
}

#[test]
fn a_mesh_that_cannot_be_read_is_said_and_no_error() {
    let folder = Folder::new("bad-mesh");
    let model = folder.write("arm.urdf", "");
    folder.write("bad.stl", "no mesh at all");
    folder.write("seen.dae", "<COLLADA/>");
    let text = "<robot><link name='a'>\
        <collision><geometry><mesh filename='bad.stl'/></geometry></collision>\
        <collision><geometry><mesh filename='seen.blend'/></geometry></collision>\
        <collision><geometry><box size='1 -2 3'/></geometry></collision>\
        <collision><geometry><plane/></geometry></collision></link></robot>";
    fs::write(&model, text).unwrap();
    folder.write("seen.blend", "");
    let model = read_model(&model, &ReadOptions::default()).unwrap();
    let set = Shapes::default().link(&model.links[0], Role::Collision);
    assert_eq!((set.volume, set.left_out.len()), (None, 4));
    assert!(set.left_out[1].1.contains(".blend"), "{:?}", set.left_out);
}

#[test]
fn text_that_is_not_utf8_says_its_byte() {
    let folder = Folder::new("latin");
    let path = folder.0.join("a.urdf");
    fs::write(&path, b"<robot>\n<link name='\xe9'/></robot>").unwrap();
    let error = read_model(&path, &ReadOptions::default()).unwrap_err();
    assert!(matches!(error.kind(), FormatErrorKind::NotUtf8 { byte: 0xe9 }));
    assert_eq!(error.place().unwrap().line, 2);
    assert!(matches!(
        read_model(&folder.0.join("none.urdf"), &ReadOptions::default()).unwrap_err().kind(),
        FormatErrorKind::Io { .. }
    ));
}

const SAMPLES: [&str; 6] = [
    "\u{feff}<?xml version='1.0'?><robot name='ß'><!-- é --><link name='a'><inertial><origin xyz='1 2e-3 -3' rpy='0.1 &#50; 0'/>\
     <mass value='1.5'/><inertia ixx='1' iyy='2' izz='2.5' ixy='0' ixz='0' iyz='0'/></inertial><visual><geometry><mesh filename='package://a/b.stl' \
     scale='1 -1 1'/></geometry></visual></link><joint name='j' type='fixed'><parent link='a'/><child link='b'/><axis xyz='0 0 1'/></joint></robot>",
    "<sdf version='1.9'><world name='w'><model name='m'><static>true</static><pose degrees='true'>1 2 3 4 5 6</pose><link name='a'><pose \
     relative_to='f'>1 2 3 0.1 0.2 0.3</pose><inertial><mass>1.5</mass><inertia><ixx>0.1</ixx></inertia></inertial><collision name='c'><geometry><box>\
     <size>1 2 3</size></box></geometry></collision></link><frame name='f' attached_to='n::b'/><model name='n'><link name='b'/></model><joint name='j' \
     type='ball'><parent>a</parent><child>n::b</child><axis><xyz expressed_in='f'>0 0 1</xyz></axis></joint></model></world></sdf>",
    "<mujoco model='m'><compiler angle='radian' eulerseq='XYZ' meshdir='a'/><default><geom type='box' size='1 2 3'/><default class='c'><joint axis='1 0 0'/>\
     </default></default><asset><mesh file='b.obj'/></asset><worldbody><body childclass='c' euler='0.1 0.2 0.3'><inertial pos='0 0 0' quat='1 2 3 4' mass='2' \
     fullinertia='1 2 3 0.1 0.2 0.3'/><freejoint/><frame zaxis='1 0 0'><geom mesh='b' type='mesh'/><body xyaxes='1 0 0 0 1 0'><joint/></body></frame></body></worldbody></mujoco>",
    "<mujoco><compiler boundmass='0.1' balanceinertia='true' settotalmass='3'/><asset><mesh name='m' vertex='0 0 0 1 0 0 0 2 0 0 0 3' scale='1 -1 2' \
     refpos='1 0 0' inertia='exact'/></asset><worldbody><replicate count='3' offset='1 0 0' euler='0 0 9'><body name='a'><geom mesh='m' type='mesh'/><geom mesh='m' \
     type='capsule' fitscale='2'/><geom type='ellipsoid' size='1 2 3' shellinertia='true'/></body></replicate><attach body='a' prefix='b_'/></worldbody></mujoco>",
    "#usda 1.0\n( metersPerUnit = 0.01 )\ndef Xform \"r\" ( apiSchemas = [\"PhysicsRigidBodyAPI\"] )\n{\nfloat physics:mass = 2.5 # é\n\
     point3f physics:centerOfMass = (1, 2e-3, -3)\nfloat3 physics:diagonalInertia = (1, 2, 2.5)\nquatf physics:principalAxes = (1, 2, 3, 4)\n\
     matrix4d xformOp:transform = ( (0, 1, 0, 0), (-1, 0, 0, 0), (0, 0, 1, 0), (4, 5, 6, 1) )\nuniform token[] xformOpOrder = [\"!invert!xformOp:transform\"]\n\
     def Capsule \"c\" { token axis = \"X\" }\ndef PhysicsRevoluteJoint \"j\" { rel physics:body1 = </r>\nquatf physics:localRot0 = (1, 1, 0, 0)\n}\n}\n",
    "<OpenSimDocument Version='40000'><Model name='m'><BodySet><objects><Body name='a'><mass>1.5</mass><mass_center>1 2e-3 &#50;</mass_center><inertia>1 2 2.5 0 0 0</inertia>\
     </Body></objects></BodySet><JointSet><objects><PinJoint name='j'><socket_parent_frame>f</socket_parent_frame><socket_child_frame>/bodyset/a</socket_child_frame><frames>\
     <PhysicalOffsetFrame name='f'><socket_parent>ground</socket_parent><translation>1 2 3</translation></PhysicalOffsetFrame></frames></PinJoint></objects></JointSet></Model></OpenSimDocument>",
];

#[test]
fn broken_texts_are_read_or_refused_and_every_place_is_in_them() {
    let mut state = 7_u64;
    let mut random = |below: usize| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as usize % below
    };
    let pieces = [
        "<",
        ">",
        "'",
        "\"",
        "&",
        "/",
        "::",
        "]]>",
        "<!--",
        "-->",
        "<![CDATA[",
        "1e999",
        "nan",
        "é",
        " ",
        "=",
        "<a>",
        "main",
        "world",
    ];
    let mut read_ones = 0;
    for round in 0..12_000 {
        let mut text = SAMPLES[round % SAMPLES.len()].to_owned();
        for _ in 0..=random(3) {
            let (from, to) = (random(text.len() + 1), random(12));
            let from = text.floor_char_boundary(from);
            let to = text.ceil_char_boundary((from + to).min(text.len()));
            let piece = pieces[random(pieces.len())].to_owned();
            let moved = text[from..to].to_owned();
            match random(3) {
                0 => text.replace_range(from..to, &piece),
                1 => text.replace_range(from..to, ""),
                _ => text.insert_str(text.floor_char_boundary(random(text.len() + 1)), &moved),
            }
        }
        let Ok(model) = read_text(&text, "nowhere/model.xml".as_ref(), &ReadOptions::default()) else {
            continue;
        };
        read_ones += 1;
        let _ = inspect(&model, &Shapes::default());
        let slots =
            |link: &Link| match link.inertial.as_ref().map(|inertial| (&inertial.mass, &inertial.tensor)) {
                Some((mass, Tensor::Six(six))) => six.iter().chain([mass]).map(Slot::span).collect(),
                Some((mass, Tensor::Diagonal(three))) => three.iter().chain([mass]).map(Slot::span).collect(),
                Some((mass, Tensor::Missing(span))) => vec![span.clone(), mass.span()],
                None => Vec::new(),
            };
        let links = model.links.iter().flat_map(|link| {
            let bad = link.pose.unreadable.iter().map(|number| number.span.clone());
            let shapes = link.geometry.iter().map(|geometry| geometry.span.clone());
            slots(link)
                .into_iter()
                .chain(bad)
                .chain(shapes)
                .chain([link.span.clone(), link.name.span.clone()])
        });
        let joints = model
            .joints
            .iter()
            .flat_map(|joint| [joint.span.clone(), joint.name.span.clone(), joint.child.span.clone()]);
        for span in links.chain(joints).chain(model.notes.iter().map(|note| note.span.clone())) {
            assert!(text.get(span.clone()).is_some(), "{span:?} of {text}");
        }
        for link in &model.links {
            let norm: f64 = link.pose.rotation.iter().map(|c| c * c).sum();
            assert!(
                (norm - 1.0).abs() < 1e-14 && link.pose.position.iter().all(|c| c.is_finite()),
                "{:?}",
                link.pose
            );
        }
    }
    assert!(read_ones > 1500, "{read_ones}");
}

#[test]
fn a_confined_model_has_its_roots_and_no_others() {
    let folder = std::env::temp_dir().join(format!("polhode-confined-{}", std::process::id()));
    let inner = folder.join("inner");
    fs::create_dir_all(&inner).unwrap();
    for file in [folder.join("package.xml"), folder.join("outer.stl"), inner.join("own.stl")] {
        fs::write(file, "solid").unwrap();
    }
    let found = |uri: &str, confined: bool| {
        let text = format!(
            "<robot><link name=\"a\"><visual><geometry><mesh filename=\"{uri}\"/></geometry></visual></link></robot>"
        );
        let options = ReadOptions { roots: vec![inner.clone()], confined, ..ReadOptions::default() };
        let model = read_text(&text, &inner.join("arm.urdf"), &options).unwrap();
        match &model.links[0].geometry[0].shape {
            GeometryShape::Mesh { path, .. } => path.is_ok(),
            _ => unreachable!(),
        }
    };
    // The enclosing folder is a package. It counts unless the model is confined.
    assert!(found("../outer.stl", false) && !found("../outer.stl", true));
    assert!(found("own.stl", true));
    fs::remove_dir_all(&folder).unwrap();
}
