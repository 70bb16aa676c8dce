//! Generated meshes and attached frames. Expected values are those of MuJoCo 4.0.0: `body_mass`,
//! `body_ipos`, and `body_inertia` rotated by `body_iquat`.

use polhode_robot::body::link_mass;
use polhode_robot::geometry::{Shapes, VolumeKind};
use polhode_robot::read::{ReadOptions, read_model};

use crate::common::{Folder, assert_close, assert_near, read};
use crate::mjcf_compiler::assert_rows;

const BUILTIN: &str = r#"<mujoco><default><mesh scale="0.5 0.7 1.1"/><default class="solid"><geom type="mesh" pos="0.1 0.2 0.3" euler="20 30 40" density="300"/></default></default><asset>
<mesh name="ball" builtin="sphere" params="2" refpos="0.1 0.2 -0.1" refquat="1 0.2 0.1 -0.3"/><mesh name="ico" builtin="sphere" params="0.9" inertia="exact"/>
<mesh name="dome" builtin="hemisphere" params="3" inertia="convex"/><mesh name="cap" builtin="hemisphere" params="0" inertia="shell"/>
<mesh name="stump" builtin="cone" params="7 0.4"/><mesh name="spike" builtin="cone" params="5 0" inertia="shell"/>
<mesh name="pillow" builtin="supersphere" params="11 0.7 1.4"/><mesh name="ring" builtin="supertorus" params="9 0.3 1.2 0.6" inertia="exact"/>
<mesh name="slice" builtin="wedge" params="5 7 60 45 0.3"/><mesh name="sheet" builtin="plate" params="5 7" inertia="exact"/></asset><worldbody>
<body name="ball" childclass="solid"><geom mesh="ball"/></body><body name="ico" childclass="solid"><geom mesh="ico" mass="2"/></body>
<body name="dome" childclass="solid"><geom mesh="dome"/></body><body name="cap" childclass="solid"><geom mesh="cap"/></body>
<body name="stump" childclass="solid"><geom mesh="stump"/></body><body name="spike" childclass="solid"><geom mesh="spike"/></body>
<body name="pillow" childclass="solid"><geom mesh="pillow"/></body><body name="ring" childclass="solid"><geom mesh="ring"/></body>
<body name="slice" childclass="solid"><geom mesh="slice"/></body><body name="sheet" childclass="solid"><geom mesh="sheet" contype="0" conaffinity="0"/></body>
<body name="fitted" childclass="solid"><geom type="ellipsoid" mesh="ring"/></body></worldbody></mujoco>"#;

#[test]
fn builtin_meshes_are_measured() {
    let model = read(BUILTIN);
    assert_eq!(model.links.len(), 11);
    let rows = "\
ball: 467.433658 0.257042082 0.0646053847 0.37714305 126.605257 139.476238 90.2626192 20.4360045 -28.8063197 13.5997623\n\
ico: 2 0.1 0.2 0.3 0.401060008 0.441832691 0.285933835 0.064737155 -0.0912526319 0.0430813143\n\
dome: 220.575396 0.299433359 0.0818564229 0.62459681 31.1964471 31.3493062 29.1537001 4.08676123 1.19257037 -2.28059233\n\
cap: 815.346182 0.236114127 0.1193665 0.521538721 111.21407 113.679747 99.533489 15.1728638 -1.02381725 -4.54682832\n\
stump: 328.69759 -0.0480769178 0.28772022 0.0589906879 104.197706 119.495687 63.5133531 18.2979595 -36.6301758 19.9705695\n\
spike: 1448.21555 -0.146115541 0.346522368 -0.101359921 455.792963 510.66979 306.632191 72.9134701 -128.640857 67.1762033\n\
pillow: 387.506358 0.100559837 0.200620266 0.299881793 87.769867 95.2043716 65.9772307 13.714115 -15.8765288 6.64210048\n\
ring: 187.15851 0.0982034417 0.198009518 0.300379335 54.4944279 49.2588471 63.5092661 5.45020037 17.2123452 -14.275603\n\
slice: 41.6702795 -0.307920282 0.441650452 -0.363929159 2.10520991 1.96877347 2.32300772 0.182886236 0.464856038 -0.397970751\n\
sheet: 288.000007 -0.45 0.525817946 -0.595177449 32.4502684 28.7650653 38.6246711 4.24410085 12.278189 -10.3073571\n\
fitted: 199.36996 0.0982034417 0.198009518 0.300379335 34.8300013 31.4836906 40.5918165 3.48348433 11.001235 -9.12422223";
    assert_rows(&model, rows);
}

/// MuJoCo puts the largest moment of such a mesh about x, and its centre at the geom's origin,
/// independently of the mesh.
const FIELDS: &str = r#"<mujoco><extension><plugin plugin="mujoco.sdf.torus"><instance name="torus"><config key="radius1" value="0.3"/><config key="radius2" value="0.12"/></instance></plugin>
<plugin plugin="mujoco.sdf.bowl"><instance name="bowl"><config key="thickness" value="0.05"/><config key="height" value="0.3"/></instance></plugin>
<plugin plugin="mujoco.sdf.gear"><instance name="gear"><config key="alpha" value="0.1"/><config key="diameter" value="1.7"/><config key="teeth" value="13"/>
  <config key="thickness" value="0.4"/><config key="innerdiameter" value="0.6"/></instance></plugin>
<plugin plugin="mujoco.sdf.nut"/><plugin plugin="mujoco.sdf.bolt"/></extension><asset>
<mesh name="torus" refpos="0.1 0.2 -0.1" refquat="1 0.2 0.1 -0.3"><plugin instance="torus"/></mesh>
<mesh name="bowl" inertia="exact"><plugin instance="bowl"/></mesh><mesh name="gear" inertia="shell"><plugin instance="gear"/></mesh>
<mesh name="nut"><plugin plugin="mujoco.sdf.nut"><config key="radius" value="0.24"/></plugin></mesh><mesh name="bolt"><plugin plugin="mujoco.sdf.bolt"/></mesh>
<mesh name="tet" vertex="0 0 0  1 0 0  0 1.5 0  0 0 2" face="0 2 1 0 1 3 1 2 3 2 0 3"/></asset>
<default><geom type="sdf" pos="0.1 0.2 0.3" euler="20 30 40" density="300"/></default><worldbody>
<body name="torus"><geom mesh="torus"><plugin instance="torus"/></geom></body><body name="bowl"><geom mesh="bowl"><plugin instance="bowl"/></geom></body>
<body name="gear"><geom type="mesh" mesh="gear" mass="2"/></body><body name="nut"><geom type="mesh" mesh="nut"/></body><body name="bolt"><geom type="mesh" mesh="bolt"/></body>
<body name="tet"><geom mesh="tet"/></body></worldbody></mujoco>"#;

#[test]
fn meshes_of_signed_distances_are_measured() {
    let model = read(FIELDS);
    assert_eq!(model.links.len(), 6);
    let rows = "\
torus: 33.5558087 0.1 0.2 0.3 2.04987264 2.17739107 1.51445125 0.620863742 -0.118358792 -0.131065236\n\
bowl: 251.981108 0.1 0.2 0.3 156.056206 161.67343 132.475395 27.3381108 -5.21818097 -5.76639653\n\
gear: 2 0.1 0.2 0.3 0.784892261 0.832508299 0.584982623 0.231787266 -0.0442143304 -0.0489109216\n\
nut: 135.906297 0.1 0.2 0.3 14.2668301 14.9304547 11.481271 3.22903224 -0.616768454 -0.680790693\n\
bolt: 171.87779 0.1 0.2 0.3 20.727733 21.0074126 20.0164057 0.257056341 -0.700605917 0.414320221\n\
tet: 150 0.307102087 0.464378139 0.883384886 26.0378451 29.9165654 25.6080895 8.15788475 -2.58714921 6.82549791";
    assert_rows(&model, rows);
}

const FRAMES: &str = r#"<mujoco><asset><model name="m" file="kid2.xml"/></asset><worldbody>
<body name="p" pos="1 1 1" euler="10 20 30"><geom size="0.1"/><attach model="m" frame="F" prefix="x_"/>
  <frame pos="1 2 3" euler="40 0 0"><attach model="m" frame="H" prefix="y_"/></frame></body>
<replicate count="2" offset="1 0 0"><attach model="m" frame="G" prefix="z_"/></replicate>
<frame name="own" pos="1 1 1"><body name="a" pos="1 2 3"><geom type="box" size="0.1 0.2 0.3"/></body></frame>
<frame pos="0 0 5"><attach frame="own" prefix="s_"/></frame></worldbody></mujoco>"#;
const KID: &str = r#"<mujoco><compiler angle="radian"/><default><geom density="300"/><default class="c"><geom density="700" type="box" size="0.1 0.2 0.3"/></default></default>
<worldbody><geom size="0.2"/><frame name="F" pos="1 2 3" euler="0.1 0.2 0.3" childclass="c"><geom pos="0.1 0 0"/>
   <body name="k1" pos="0.1 0.2 0.3"><geom/><joint name="j" type="slide"/></body>
   <frame name="G" pos="0 0 1" euler="0 0.4 0"><body name="k2" pos="0.5 0 0"><geom type="sphere" size="0.1"/><body name="k3"><geom/></body></body></frame></frame>
 <body name="b" pos="3 3 3"><geom size="0.3"/><frame name="H" pos="0 1 0" euler="0.3 0 0"><geom size="0.1" pos="1 1 1"/><body name="k4" pos="1 0 0"><geom size="0.1"/></body></frame></body>
</worldbody></mujoco>"#;

#[test]
fn frames_are_attached_with_all_that_stands_in_them() {
    let folder = Folder::of("frames_are_attached", &[("frames.xml", FRAMES), ("kid2.xml", KID)]);
    let model = read_model(&folder.path("frames.xml"), &ReadOptions::default()).unwrap();
    assert_eq!(model.links.len(), 11);
    let rows = "\
p: 39.0454273 1.00547548 1.82741889 2.72962448 57.3208887 46.9150683 22.2563212 -8.99101628 -15.2775096 -24.4469897\n\
x_k1: 33.6 0 0 0 1.456 1.12 0.56 0 0 0\n\
x_k2: 2.93215314 0 0 0 0.0117286126 0.0117286126 0.0117286126 0 0 0\n\
x_k3: 33.6 0 0 0 1.456 1.12 0.56 0 0 0\n\
y_k4: 1.25663706 0 0 0 0.00502654825 0.00502654825 0.00502654825 0 0 0\n\
z_k20: 2.93215314 0 0 0 0.0117286126 0.0117286126 0.0117286126 0 0 0\n\
z_k30: 33.6 0 0 0 1.456 1.12 0.56 0 0 0\n\
z_k21: 2.93215314 0 0 0 0.0117286126 0.0117286126 0.0117286126 0 0 0\n\
z_k31: 33.6 0 0 0 1.456 1.12 0.56 0 0 0\n\
a: 48 0 0 0 2.08 1.6 0.8 0 0 0\n\
s_a: 48 0 0 0 2.08 1.6 0.8 0 0 0";
    assert_rows(&model, rows);
}

#[test]
fn what_is_attached_stands_before_it() {
    let body = "<body name='a'><geom size='1'/></body>";
    let cases = [
        (format!("<attach body='a' prefix='x'/>{body}"), "has to be complete"),
        (
            "<body name='a'><geom size='1'/><attach body='a' prefix='x'/></body>".to_owned(),
            "has to be complete",
        ),
        (format!("{body}<attach body='a' frame='a' prefix='x'/>"), "a body and a frame"),
        (format!("{body}<attach frame='a' prefix='x'/>"), "no such frame"),
        (format!("{body}<attach prefix='x'/>"), "names no body"),
        (format!("{body}<attach model='m' prefix='x'/>"), "is not in <asset>"),
    ];
    for (bodies, said) in cases {
        let model = read(&format!("<mujoco><worldbody>{bodies}</worldbody></mujoco>"));
        assert_eq!(model.links.len(), 1, "{bodies}");
        assert!(model.notes[0].message.contains(said), "{bodies}: {:?}", model.notes);
    }
}

#[test]
fn models_that_attach_each_other_are_refused() {
    let attach = |other: &str| {
        format!(
            "<mujoco><asset><model name='o' file='{other}.xml'/></asset><worldbody><body><attach model='o' prefix='x'/></body></worldbody></mujoco>"
        )
    };
    let folder = Folder::of("models_in_a_circle", &[("a.xml", &attach("b")), ("b.xml", &attach("a"))]);
    let error = read_model(&folder.path("a.xml"), &ReadOptions::default()).unwrap_err().to_string();
    assert!(error.contains("300000 elements") || error.contains("names that are too long"), "{error}");
}

#[test]
fn meshes_that_mujoco_refuses_or_others_make_have_no_mass() {
    let mass = |mesh: &str| {
        let model = read(&format!(
            "<mujoco><extension><plugin plugin='mujoco.sdf.torus'><instance name='t'><config key='radius1' value='0,3'/></instance></plugin>\
             </extension><asset><mesh name='m' {mesh}</asset><worldbody><body name='b'><geom type='mesh' mesh='m'/></body></worldbody></mujoco>"
        ));
        link_mass(model.format, &model.links[0]).map(drop).map_err(|error| error.to_string())
    };
    assert_eq!(mass("builtin='sphere' params='4'/>"), Ok(()));
    for refused in [
        "builtin='sphere' params='5'/>",
        "builtin='sphere' params='1 2'/>",
        "builtin='prism' params='1'/>",
        "builtin='hemisphere' params='-1'/>",
        "builtin='supersphere' params='2 1 1'/>",
        "builtin='supertorus' params='9 1.5 1 1'/>",
        "builtin='wedge' params='5 5 181 45 0'/>",
        "builtin='plate' params='0 3'/>",
        "builtin='cone' params='nan 1'/>",
        "builtin='sphere'/>",
    ] {
        let why = mass(refused).unwrap_err();
        assert!(why.contains("params that MuJoCo refuses"), "{refused}: {why}");
    }
    for (mesh, said) in [
        ("builtin='supersphere' params='900 1 1'/>", "more than 200000 vertices"),
        ("><plugin plugin='my.own'/></mesh>", "\"my.own\""),
        ("><plugin instance='gone'/></mesh>", "no instance \"gone\""),
        ("><plugin instance='t'/></mesh>", "radius1=\"0,3\""),
        (
            "><plugin plugin='mujoco.sdf.nut'><config key='thread' value='1'/></plugin></mesh>",
            "\"thread\" is not a key",
        ),
        (
            "><plugin plugin='mujoco.sdf.torus'><config key='radius2' value='-1'/></plugin></mesh>",
            "no bounding box",
        ),
        ("scale='1 1 2'><plugin plugin='mujoco.sdf.torus'/></mesh>", "has a scale"),
    ] {
        let why = mass(mesh).unwrap_err();
        assert!(why.contains(said), "{mesh}: {why}");
    }
}

#[test]
fn meshes_without_number_are_refused() {
    let meshes: String =
        (0..4).map(|k| format!("<mesh name='m{k}' builtin='supertorus' params='440 0.5 1 1'/>")).collect();
    let geoms: String = (0..4).map(|k| format!("<geom type='mesh' mesh='m{k}'/>")).collect();
    let model = read(&format!(
        "<mujoco><asset>{meshes}</asset><worldbody><body name='b'>{geoms}</body></worldbody></mujoco>"
    ));
    let why = link_mass(model.format, &model.links[0]).unwrap_err().to_string();
    assert!(why.contains("5000000 points"), "{why}");
}

const VERTICES: [&str; 4] = ["0.1 -0.2 0.05", "1.3 0.2 -0.1", "0.2 1.1 0.3", "0.4 0.3 0.9"];

/// The same mesh as a file and written in the model, in the frame and at the scale of the asset.
#[test]
fn a_mesh_in_the_model_has_the_shape_of_its_file() {
    let mut obj: String = VERTICES.iter().map(|vertex| format!("v {vertex}\n")).collect();
    obj += "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
    let more = r#"refpos="0.1 0.2 -0.1" refquat="1 0.2 0.1 -0.3" scale="0.7 0.7 0.7""#;
    let mirror = r#"refpos="0.1 0.2 -0.1" scale="0.7 -0.4 1.1""#;
    let text = |more: &str| {
        let vertex = VERTICES.join("  ");
        let geom = |mesh: &str| {
            format!(
                r#"<body name="{mesh}"><geom type="mesh" mesh="{mesh}" pos="1 2 3" euler="10 20 30"/></body>"#
            )
        };
        let bodies = ["file", "faces", "hull"].map(geom).concat();
        format!(
            r#"<mujoco><asset><mesh name="file" file="tet.obj" {more}/><mesh name="faces" vertex="{vertex}" face="0 2 1 0 1 3 0 3 2 1 2 3" {more}/>
            <mesh name="hull" vertex="{vertex} 0.5 0.35 0.3" {more}/><mesh name="wrong" vertex="{vertex}" face="0 2 4" {more}/></asset>
            <worldbody>{bodies}<body name="wrong"><geom type="mesh" mesh="wrong"/></body></worldbody></mujoco>"#
        )
    };
    let folder =
        Folder::of("inline", &[("one.xml", &text(more)), ("two.xml", &text(mirror)), ("tet.obj", &obj)]);
    for file in ["one.xml", "two.xml"] {
        let model = read_model(&folder.path(file), &ReadOptions::default()).unwrap();
        let shapes = Shapes::default();
        let [file, faces, hull] = [0, 1, 2].map(|k| shapes.geometry(&model.links[k].geometry[0]).unwrap());
        for other in [faces, hull] {
            assert_eq!(other.kind, VolumeKind::Closed);
            assert!((other.volume / file.volume - 1.0).abs() < 1e-14);
            assert_close(other.centroid, file.centroid, 1e-14);
            assert_near(&other.tensor_per_density, &file.tensor_per_density, 1e-15);
        }
        let error = shapes.geometry(&model.links[3].geometry[0]).unwrap_err();
        assert_eq!(
            error,
            "\"wrong\": its vertex or face has a wrong number, or an index that does not exist"
        );
    }
}
