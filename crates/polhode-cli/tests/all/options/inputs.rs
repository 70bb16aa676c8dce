//! Small input files of every kind, chosen so that each option has an effect.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use std::process::Command;

use crate::common::Scratch;

/// An L-shaped prism and a tetrahedron as two groups.
fn two_parts() -> String {
    let corners = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, 2.5], [0.0, 2.5]];
    let mut text = String::new();
    for z in [0.25, 0.75] {
        for [x, y] in corners {
            writeln!(text, "v {x} {y} {z}").unwrap();
        }
    }
    text += "g rod\n";
    for k in 1..5 {
        writeln!(text, "f 1 {} {}\nf 7 {} {}", k + 2, k + 1, k + 7, k + 8).unwrap();
    }
    for k in 1..=6 {
        let next = k % 6 + 1;
        writeln!(text, "f {k} {next} {}\nf {k} {} {}", next + 6, next + 6, k + 6).unwrap();
    }
    text + "v 10 0 0\nv 12 0 0\nv 10 3 0\nv 10 0 1\ng grip\nf 13 15 14\nf 13 14 16\nf 13 16 15\nf 14 15 16\n"
}

/// A tetrahedron as binary STL.
fn stl() -> Vec<u8> {
    let v = [[0.5_f32, 0.0, 0.0], [2.0, 0.25, 0.0], [0.0, 3.0, 0.0], [0.0, 0.0, 1.0]];
    let mut bytes = vec![b' '; 80];
    bytes.extend(4_u32.to_le_bytes());
    for face in [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]] {
        bytes.extend([0; 12]);
        bytes.extend(face.iter().flat_map(|k| v[*k]).flat_map(f32::to_le_bytes));
        bytes.extend([0; 2]);
    }
    bytes
}

/// Two by three by two voxels.
fn npy() -> Vec<u8> {
    let header = format!("{:<117}\n", "{'descr': '|u1', 'fortran_order': False, 'shape': (2, 3, 2), }");
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    bytes.extend((header.len() as u16).to_le_bytes());
    bytes.extend(header.as_bytes());
    bytes.extend([1, 2, 0, 4, 5, 0, 7, 8, 9, 1, 0, 3]);
    bytes
}

/// Answers to an exercise, with the sign of the products reversed.
const ANSWERS: &str = "topic = 'box-about-corner'
seed = 7
[answers]
I = [
  ['0.11447 kg m^2', '0.11951 kg m^2', '0.07548 kg m^2'],
  ['0.11951 kg m^2', '0.34295 kg m^2', '0.03876 kg m^2'],
  ['0.07548 kg m^2', '0.03876 kg m^2', '0.39213 kg m^2'],
]
";

const BODY: &str = r#"
[[body.part]]
name = "brick"
shape = "box"
size = ["200 mm", "100 mm", "60 mm"]
mass = "2.16 kg"
rotate = { axis = [1, 2, 3], angle = "20 deg" }
position = ["10 mm", "-20 mm", "30 mm"]
[start]
spin = { body = [0.3, 2.0, 0.1] }
"#;
const RUN: &str = "[run]\nduration = \"2 s\"\nsamples = 11\n";
const LONG_RUN: &str = "[run]\nduration = \"2 s\"\nsamples = 10001\nmethod = \"taylor\"\n";
const SWEEP: &str = "[sweep]\nmembers = 3\nsampling = \"monte carlo\"\n[[sweep.vary]]\nkey = \"start.spin.body[0]\"\nuniform = { from = 0.1, to = 0.5 }\n";
const CAD: &str = "Mass = 2.500\nCenter of mass:\n X = 1.103 Y = -2.204 Z = 1.311\nMoments of inertia:
Taken at the center of mass and aligned with the output coordinate system.
 Lxx = 273.500 Lxy = -67.250 Lxz = 32.500\n Lyx = -67.250 Lyy = 419.250 Lyz = 49.750\n Lzx = 32.500 Lzy = 49.750 Lzz = 351.125\n";

fn link(name: &str, mass: &str, center: &str, inertia: &str, geometry: &str) -> String {
    format!(
        "<link name=\"{name}\"><inertial><origin xyz=\"{center}\"/><mass value=\"{mass}\"/><inertia {inertia}/></inertial>
<collision><geometry>{geometry}</geometry></collision></link>\n"
    )
}

/// Model with a link that matches its mesh in packages/, and a link whose mesh does not exist.
/// Configuration that allows one of the two notes.
const ALLOWED: &str = "[[check.allow]]\nrule = \"geometry.unreadable\"\nfile = \"model.urdf\"\nlink = \"lost\"\nreason = \"lost\"\n";

/// Baseline with the other note.
const KNOWN: &str = r#"{ "polhode_baseline": 1, "findings": [
    { "file": "model.urdf", "rule": "geometry.unreadable", "link": "found", "id": "461d305787371008" }
] }"#;

fn noted() -> String {
    let tetrahedron =
        "ixx=\"1290.9375\" ixy=\"275.625\" ixz=\"112.5\" iyy=\"618.75\" iyz=\"146.25\" izz=\"1639.6875\"";
    let other = "ixx=\"0.015\" ixy=\"0.001\" ixz=\"0\" iyy=\"0.02028\" iyz=\"0\" izz=\"0.02928\"";
    let mesh = |name| format!("<mesh filename=\"package://{name}/shape.stl\"/>");
    let joint = "<joint name=\"j\" type=\"fixed\"><parent link=\"found\"/><child link=\"lost\"/></joint>\n";
    // A massless link between two joints, which MuJoCo refuses.
    let turn = |name: &str, parent: &str, child: &str| {
        format!(
            "<joint name=\"{name}\" type=\"continuous\"><parent link=\"{parent}\"/><child link=\"{child}\"/><axis xyz=\"0 0 1\"/></joint>\n"
        )
    };
    link("found", "3600", "0.625 0.8125 0.25", tetrahedron, &mesh("found"))
        + &link("lost", "3.6", "0 0 0.05", other, &mesh("lost"))
        + joint
        + "<link name=\"cross\"/>\n"
        + &link("tip", "3.6", "0 0 0", other, "<box size=\"0.24 0.20 0.10\"/>")
        + &turn("pitch", "lost", "cross")
        + &turn("yaw", "cross", "tip")
}

/// Writes the files of an input.
pub(crate) fn write(scratch: &Scratch, input: &str) {
    // Inertias in g mm².
    let grams = "ixx=\"15000000\" ixy=\"0\" ixz=\"0\" iyy=\"20280000\" iyz=\"0\" izz=\"29280000\"";
    let joint = "<joint name=\"k\" type=\"fixed\"><parent link=\"base\"/><child link=\"found\"/></joint>\n";
    let words: Vec<&str> = input.split(' ').collect();
    match input {
        _ if ["parts", "unnamed", "torn", "holed", "again"].contains(&words[0]) => {
            let mut text = two_parts();
            if words.contains(&"torn") {
                text = text.replace("f 13 14 16\n", "v 10.000001 0 0\nf 17 14 16\n");
            }
            if words.contains(&"holed") {
                text = text.replace("f 14 15 16\n", "");
            }
            if words.contains(&"again") {
                scratch.write("out.obj", "an older one");
            }
            if words.contains(&"overlapping") {
                text = text.replace("v 10", "v 0").replace("v 12", "v 2");
            }
            scratch.write("two.obj", &text);
            scratch.write("two.dat", &text);
        }
        "stl" => fs::write(scratch.0.join("one.stl"), stl()).unwrap(),
        "points" => scratch.write("points.csv", "x,y,z\n1,2,3\n4,-5,6\n-7,8,1.5\n2,0.5,-3\n"),
        "particles" => scratch.write("particles.csv", "m,x,y,z\n1,1,2,3\n2,4,-5,6\n3,-7,8,1.5\n4,2,0.5,-3\n"),
        "cad" => scratch.write("report.txt", CAD),
        "molecule" => scratch.write(
            "water.xyz",
            "3\nwater\nO 0 0 0.120823\nH 0 0.761688 -0.483292\nH 0 -0.761688 -0.483292\n",
        ),
        "grid" => fs::write(scratch.0.join("grid.npy"), npy()).unwrap(),
        "budget" | "budget again" => {
            scratch.write("cubesat.csv", crate::budget::CUBESAT);
            scratch.write("before.csv", &crate::budget::before());
            if words.contains(&"again") {
                scratch.write("out.xlsx", "an older one");
            }
        }
        "budget over time" => {
            let rocket = crate::common::example("budget/sounding-rocket.xlsx");
            fs::copy(rocket, scratch.0.join("sounding-rocket.xlsx")).unwrap();
        }
        "inertials" => {
            let link = |name: &str, inertial: &str| {
                let role = |role: &str, size: &str| {
                    format!("<{role}><geometry><box size=\"{size}\"/></geometry></{role}>")
                };
                let shapes = role("visual", "0.3 0.06 0.05") + &role("collision", "0.3 0.07 0.06");
                format!(
                    "<link name=\"{name}\"><inertial><mass value=\"0.9\"/>{inertial}</inertial>{shapes}</link>"
                )
            };
            let tensor =
                "<inertia ixx=\"0.0007\" ixy=\"0\" ixz=\"0\" iyy=\"0.007\" iyz=\"0\" izz=\"0.0072\"/>";
            let joint =
                "<joint name=\"j\" type=\"fixed\"><parent link=\"base\"/><child link=\"rod\"/></joint>";
            let links = link("base", tensor) + &link("rod", "");
            scratch.write("arm.urdf", &format!("<robot name=\"r\">{links}{joint}</robot>"));
        }
        "robot" => {
            fs::copy(crate::common::example("robots/arm.urdf"), scratch.0.join("arm.urdf")).unwrap();
        }
        "noted" | "flawed" | "flawed again" | "broken" => {
            fs::create_dir_all(scratch.0.join("packages/found")).unwrap();
            fs::write(scratch.0.join("packages/found/shape.stl"), stl()).unwrap();
            let flaw = link("base", "3.6", "0 0 0", grams, "<box size=\"0.24 0.20 0.10\"/>") + joint;
            let flaw = match input {
                "noted" => String::new(),
                // i1 + i2 < i3, in any axes.
                "broken" => flaw.replace("izz=\"29280000\"", "izz=\"49280000\""),
                _ => flaw,
            };
            scratch.write("model.urdf", &format!("<robot name=\"r\">{flaw}{}</robot>", noted()));
            scratch.write("rules.toml", ALLOWED);
            scratch.write("known.json", KNOWN);
            if input == "flawed again" {
                scratch.write("fixed.urdf", "an older one");
            }
        }
        "two models" | "two models again" => {
            let link = |name: &str, mass: &str| {
                format!(
                    "<link name='{name}'><inertial><pose>0.1 0.2 0.3 0 0 0</pose><mass>{mass}</mass><inertia><ixx>0.2</ixx>\
                     <iyy>0.3</iyy><izz>0.4</izz></inertia></inertial></link>"
                )
            };
            let model = |base: &str, mass: &str| {
                format!(
                    "<sdf version='1.9'><model name='m'>{}{}<joint name='j' type='revolute'><parent>{base}</parent><child>arm</child>\
                     <axis><xyz>0 0.6 0.8</xyz></axis></joint><include><uri>model://tip</uri></include></model></sdf>",
                    link(base, mass),
                    link("arm", "1")
                )
            };
            fs::create_dir_all(scratch.0.join("packages/tip")).unwrap();
            let tip = format!("<sdf version='1.9'><model name='tip'>{}</model></sdf>", link("end", "0.5"));
            fs::write(scratch.0.join("packages/tip/model.sdf"), tip).unwrap();
            let config = "<model><name>tip</name><sdf version='1.9'>model.sdf</sdf></model>";
            fs::write(scratch.0.join("packages/tip/model.config"), config).unwrap();
            scratch.write("one.sdf", &model("base", "2"));
            scratch.write("two.sdf", &model("foot", "2.001"));
            scratch.write("names.toml", "[links]\nbase = \"foot\"\n");
            if input == "two models again" {
                scratch.write("results", "an older one");
            }
        }
        "table there" => {
            fs::copy(crate::common::example("slew.toml"), scratch.0.join("slew.toml")).unwrap();
            scratch.write("slew-torque.csv", "older");
            scratch.write("slew-torque.parquet", "older");
        }
        "measured" => {
            let log = fs::read_to_string(crate::common::example("identify/payload.csv")).unwrap();
            let rows: Vec<&str> = log.lines().take(62).collect();
            scratch.write("payload.csv", &rows.join("\n"));
            // A tenth of the actual noise, so that the residuals are too large.
            let noise = "noise = { force = \"5 mN\", torque = \"0.2 mN m\" }\n";
            let keys = "log = \"payload.csv\"\nwrench = \"on sensor\"\nbias = true\n";
            scratch.write("payload.toml", &format!("[payload]\n{keys}{noise}"));
        }
        "thrown" => {
            // Air drag, and a systematic error.
            let log = fs::read_to_string(crate::common::example("identify/racket-like.csv")).unwrap();
            let mut text = String::from("time_s,gyro_x,gyro_y,gyro_z\n");
            for line in log.lines().skip(2).step_by(3) {
                let row: Vec<f64> = line.split(',').map(|x| x.parse().unwrap()).collect();
                let (slower, wrong) = ((-0.08 * (row[0] % 2.45)).exp(), 0.05 * (60.0 * row[0]).sin());
                text += &format!(
                    "{},{},{},{}\n",
                    row[0],
                    slower * row[1] + wrong,
                    slower * row[2],
                    slower * row[3]
                );
            }
            scratch.write("gyro.csv", &text);
        }
        "hung" | "shape" | "bare shape" => {}
        "symbols" => {
            fs::copy(crate::common::example("notes/11-03-cube.toml"), scratch.0.join("cube.toml")).unwrap();
        }
        "given" => {
            fs::copy(crate::common::example("slew.toml"), scratch.0.join("slew.toml")).unwrap();
        }
        "topic" | "graded" => scratch.write("mine.toml", ANSWERS),
        "long" | "long before" => scratch.write("body.toml", &format!("{BODY}{LONG_RUN}")),
        _ => {
            scratch.write("body.toml", &format!("{BODY}{RUN}"));
            scratch.write("plan.toml", &format!("{BODY}{RUN}{SWEEP}"));
            scratch.write("times.txt", "0.25\n0.5\n");
        }
    }
    // Results of an earlier run.
    let earlier: &[&str] = match input {
        // Results of another scenario, because those of the same one are replaced anyway.
        "ran before" | "long before" => {
            fs::copy(scratch.0.join("body.toml"), scratch.0.join("earlier.toml")).unwrap();
            &["simulate", "earlier.toml", "-o", "body"]
        }
        "spun before" => &["spin", "body.toml", "--duration", "1 s"],
        "swept before" => &["sweep", "plan.toml"],
        _ => return,
    };
    assert_eq!(scratch.run(earlier).status.code(), Some(0));
}

/// Adds a `python3` to the PATH that prints its arguments.
pub(crate) fn with_python(mut command: Command, scratch: &Scratch) -> Command {
    let folder = scratch.0.join("bin");
    fs::create_dir_all(&folder).unwrap();
    let script = folder.join("python3");
    fs::write(&script, "#!/bin/sh\n[ \"$1\" = -c ] || echo \"$@\"\n").unwrap();
    executable(&script);
    let path = std::env::var("PATH").unwrap_or_default();
    command.env("PATH", format!("{}:{path}", folder.display()));
    command
}

#[cfg(unix)]
fn executable(script: &Path) {
    use std::os::unix::fs::PermissionsExt as _;
    fs::set_permissions(script, fs::Permissions::from_mode(0o755)).unwrap();
}

#[cfg(not(unix))]
fn executable(_: &Path) {}
