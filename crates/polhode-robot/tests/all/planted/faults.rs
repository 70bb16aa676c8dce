//! Typical faults in each language's conventions. Each is planted alone, next to a correct body,
//! and must be found.

use std::collections::BTreeMap;

use polhode_robot::finding::Severity;

use super::inspected;
use super::language::Language;
use super::solid::{Solid, Spec, inverse};
use crate::check_common::{Matrix, turn};

/// Planted fault: the code of its finding, the language, and the whole model.
struct Fault {
    code: &'static str,
    language: Language,
    what: &'static str,
    text: String,
}

fn slab() -> Solid {
    Solid::uniform(1.37, [0.11, 0.19, 0.31], [0.06, -0.11, 0.08], turn([0.4, -0.7, 1.1]))
}

/// Returns the correct second body.
fn other() -> Solid {
    Solid::uniform(2.9, [0.23, 0.12, 0.17], [-0.03, 0.05, 0.02], turn([-0.9, 0.3, 0.5]))
}

/// Returns a spec with this tensor in link axes, in the form of the language.
fn with_tensor(language: Language, tensor: Matrix) -> Spec {
    let mut spec = language.spec(&Solid { tensor, ..slab() }, "arm");
    if language == Language::Usd {
        // Axes in which the language writes it.
        spec = Solid { tensor, ..slab() }.framed("arm", &slab().attitude);
    }
    spec
}

fn scaled(m: Matrix, factor: f64) -> Matrix {
    m.map(|row| row.map(|x| factor * x))
}

fn with_products_turned(m: Matrix) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| if i == j { m[i][j] } else { -m[i][j] }))
}

/// Returns faults in the numbers of one link.
fn of_numbers(language: Language) -> Vec<(&'static str, &'static str, Spec)> {
    let right = language.spec(&slab(), "arm");
    let is_usd = language == Language::Usd;
    let has_geometry = language != Language::Osim;
    let with = |change: &dyn Fn(&mut Spec)| {
        let mut spec = right.clone();
        change(&mut spec);
        spec
    };
    let diagonal =
        |six: [&str; 3]| with(&|spec| spec.six = [six[0], six[1], six[2], "0", "0", "0"].map(str::to_owned));
    let comma = if is_usd { "1.37kg" } else { "1,37" };
    let mut faults = vec![
        ("number.malformed", "a mass that is not a number", with(&|spec| spec.mass = comma.to_owned())),
        ("number.malformed", "a moment with a unit", with(&|spec| spec.six[1] = "0.0171kg".to_owned())),
        ("number.not_finite", "a moment that is nan", with(&|spec| spec.six[2] = "nan".to_owned())),
        ("number.not_finite", "a mass beyond any", with(&|spec| spec.mass = "1e999".to_owned())),
        ("mass.not_positive", "a negative mass", with(&|spec| spec.mass = "-1.37".to_owned())),
        ("inertia.triangle", "i1 + i2 < i3", diagonal(["0.0113", "0.0127", "0.0311"])),
        ("inertia.triangle", "a moment with the power of another", diagonal(["0.0113", "0.0127", "12.1"])),
        ("inertia.negative", "a negative moment", diagonal(["0.0113", "-0.0127", "0.0131"])),
    ];
    if !is_usd {
        faults.push(("inertia.zero", "all moments zero", diagonal(["0", "0", "0"])));
    }
    if !has_geometry {
        return faults;
    }
    let tensor = slab().tensor;
    faults.extend([
        ("inertia.unit", "g·mm²", with_tensor(language, scaled(tensor, 1e9))),
        ("inertia.unit", "kg·mm²", with_tensor(language, scaled(tensor, 1e6))),
        ("inertia.placeholder", "1 kg·m² about each axis", diagonal(["1", "1", "1"])),
        ("gyration.too_large", "moments of a larger body", with_tensor(language, scaled(tensor, 31.7))),
    ]);
    if language != Language::Usd {
        faults.push((
            "inertia.about_origin",
            "about the origin",
            with_tensor(language, slab().about_origin()),
        ));
    }
    if matches!(language, Language::Mjcf) {
        let full = slab().full("arm");
        let signs = Solid { tensor: with_products_turned(tensor), ..slab() }.full("arm");
        let [xx, yy, zz, xy, xz, yz] = full.six.clone();
        faults.push(("inertia.sign", "+∫xy dm", signs));
        faults.push(("inertia.order", "rows", Spec { six: [xx, xy, xz, yy, yz, zz], ..full }));
    } else if language != Language::Usd {
        let [xx, yy, zz, xy, xz, yz] = right.six.clone();
        let turned = |text: &String| text.strip_prefix('-').map_or(format!("-{text}"), str::to_owned);
        let six = [xx.clone(), yy.clone(), zz.clone(), turned(&xy), turned(&xz), turned(&yz)];
        faults.push(("inertia.sign", "+∫xy dm", Spec { six, ..right.clone() }));
        faults.push(("inertia.order", "rows", Spec { six: [xx, xy, xz, yy, yz, zz], ..right.clone() }));
    }
    // Inverse attitude of the inertial; in languages with quaternions also x y z w.
    let own = match language {
        Language::Mjcf | Language::Usd => slab().principal("arm"),
        _ => right,
    };
    faults.push((
        "inertia.conjugate",
        "the inverse attitude",
        Spec { frame: inverse(&own.frame), ..own.clone() },
    ));
    if matches!(language, Language::Mjcf | Language::Usd) {
        let [w, x, y, z] = super::solid::quaternion(&own.frame);
        // Read as (w, x, y, z).
        let frame = polhode_robot::model::Pose {
            position: [0.0; 3],
            rotation: [x, y, z, w],
            unreadable: Vec::new(),
            span: None,
        };
        faults.push(("inertia.conjugate", "x y z w", Spec { frame: frame.matrix(), ..own }));
    }
    faults
}

/// Returns faults of two links.
fn of_pairs(language: Language) -> Vec<(&'static str, &'static str, Vec<Spec>)> {
    let twice = vec![language.spec(&slab(), "arm"), language.spec(&other(), "arm")];
    let mut pairs = vec![("tree.duplicate_link", "one name for two", twice)];
    if language != Language::Usd {
        // The right link is positioned and shaped as the mirrored left one, but has the left one's
        // tensor.
        let left = slab();
        let mirrored = |[x, y, z]: [f64; 3]| [x, -y, z];
        let attitude = [0, 1, 2].map(|i| {
            [0, 1, 2].map(|j| if (i == 1) == (j == 1) { left.attitude[i][j] } else { -left.attitude[i][j] })
        });
        let right =
            Solid { place: mirrored(left.place), center: mirrored(left.center), attitude, ..left.clone() };
        let copied = vec![left.full("l_hip"), right.full("r_hip")];
        pairs.push(("inertia.mirrored_pair", "a copy in the place of a mirror", copied));
    }
    pairs
}

/// Returns faults of the text, each as a replacement.
fn of_text(language: Language) -> Vec<(&'static str, &'static str, String)> {
    let right = language.model(&[language.spec(&slab(), "arm"), language.spec(&other(), "leg")]);
    let edited = |from: &str, to: &str| {
        assert!(right.contains(from), "{language:?}: {from}\n{right}");
        right.replacen(from, to, 1)
    };
    let without = |start: &str, end: &str| {
        let from = right.find(start).unwrap_or_else(|| panic!("{start}"));
        let inner = from + start.len();
        let to = inner + right[inner..].find(end).unwrap() + end.len();
        format!("{}{}", &right[..from], &right[to..])
    };
    // Removes the last number after a word.
    let one_less = |start: &str, end: char| {
        let from = right.find(start).unwrap_or_else(|| panic!("{start}"));
        let to = from + start.len() + right[from + start.len()..].find(end).unwrap();
        let last = right[..to].rfind(' ').unwrap();
        format!("{}{}", right[..last].trim_end_matches(','), &right[to..])
    };
    match language {
        Language::Urdf | Language::UrdfOfMeshes => {
            let mut faults = vec![
                ("number.missing", "no izz", without(" izz=\"", "\"")),
                ("inertia.missing", "no tensor", without("<inertia ", "/>")),
                ("mass.missing", "no mass", without("<mass ", "/>")),
                ("inertia.asymmetric", "iyx is another", edited(" ixy=", " iyx=\"0.77\" ixy=")),
                ("read.unknown", "a mass with a unit", edited("<mass ", "<mass unit=\"g\" ")),
                ("read.twice", "two masses", edited("<mass ", "<mass value=\"3\"/><mass ")),
                (
                    "read.inertials",
                    "two inertials",
                    edited("<inertial>", "<inertial><mass value=\"3\"/></inertial><inertial>"),
                ),
                (
                    "tree.two_roots",
                    "a link that hangs on none",
                    without("<joint name=\"to_leg\"", "</joint>"),
                ),
                (
                    "tree.unknown_link",
                    "a parent that is not there",
                    edited("parent link=\"base\"", "parent link=\"bass\""),
                ),
                ("tree.cycle", "a link on itself", edited("parent link=\"base\"", "parent link=\"arm\"")),
                ("tree.duplicate_joint", "two joints of a name", edited("to_leg", "to_arm")),
                ("joint.axis", "an axis without direction", edited("0 0 1\"/></joint>", "0 0 0\"/></joint>")),
                ("mass.massless_collision", "no inertial", without("<inertial>", "</inertial>")),
                (
                    "tree.two_parents",
                    "two joints to one link",
                    edited("child link=\"leg\"", "child link=\"arm\""),
                ),
                (
                    "tree.no_root",
                    "the base hangs on the arm",
                    edited(
                        "</robot>",
                        "<joint name=\"j\" type=\"fixed\"><parent link=\"arm\"/><child link=\"base\"/></joint></robot>",
                    ),
                ),
                ("tree.empty", "a robot of nothing", "<robot name=\"r\"/>".to_owned()),
                (
                    "tree.shared_name",
                    "a joint with the name of a link",
                    edited("name=\"to_arm\"", "name=\"arm\""),
                ),
            ];
            faults.push(if language == Language::Urdf {
                (
                    "density.implausible",
                    "a box in mm",
                    edited("box size=\"0.11 0.19 0.31\"", "box size=\"110 190 310\""),
                )
            } else {
                (
                    "density.implausible",
                    "a mesh in mm without its scale",
                    edited("scale=\"0.11 0.19 0.31\"", "scale=\"110 190 310\""),
                )
            });
            faults
        }
        Language::Sdf => vec![
            ("number.missing", "no izz, which is 1 then", without("<izz>", "</izz>")),
            ("inertia.missing", "no tensor, which is 1 then", without("<inertia>", "</inertia>")),
            ("mass.missing", "no inertial, which is 1 kg then", without("<inertial>", "</inertial>")),
            (
                "read.unknown",
                "a pose in another's frame",
                edited("<pose degrees=\"true\">", "<pose relative_to=\"leg\" degrees=\"true\">"),
            ),
            (
                "read.inertials",
                "two inertials",
                edited("<inertial>", "<inertial><mass>3</mass></inertial><inertial>"),
            ),
            ("read.twice", "two masses", edited("<mass>", "<mass>3</mass><mass>")),
            (
                "tree.unknown_link",
                "a child that is not there",
                edited(
                    "</model>",
                    "<joint name=\"j\" type=\"fixed\"><parent>arm</parent><child>foot</child></joint></model>",
                ),
            ),
            (
                "joint.axis",
                "an axis of no numbers",
                edited(
                    "</model>",
                    "<joint name=\"j\" type=\"revolute\"><parent>arm</parent><child>leg</child><axis><xyz>0 0 x</xyz></axis></joint></model>",
                ),
            ),
            (
                "tree.shared_name",
                "a joint with the name of a link",
                edited(
                    "</model>",
                    "<joint name=\"arm\" type=\"fixed\"><parent>arm</parent><child>leg</child></joint></model>",
                ),
            ),
            ("density.implausible", "a box in mm", edited("<size>0.11 0.19 0.31", "<size>110 190 310")),
        ],
        Language::Mjcf => vec![
            (
                "mass.missing",
                "no inertial, and masses are not taken from geoms",
                without("<inertial ", "/>").replace("\"auto\"", "\"false\""),
            ),
            (
                "mass.missing",
                "a joint without mass",
                edited("</worldbody>", "<body name=\"b\"><joint/></body></worldbody>"),
            ),
            (
                "inertia.two_forms",
                "fullinertia with a quaternion",
                edited(" fullinertia=", " quat=\"1 2 3 4\" fullinertia="),
            ),
            (
                "inertia.two_forms",
                "fullinertia with diaginertia",
                edited(" fullinertia=", " diaginertia=\"1 1 1\" fullinertia="),
            ),
            (
                "read.inertials",
                "two inertials",
                edited("<inertial ", "<inertial pos=\"0 0 0\" mass=\"1\" diaginertia=\"1 1 1\"/><inertial "),
            ),
            ("number.missing", "five numbers", one_less("fullinertia=\"", '"')),
            (
                "joint.axis",
                "an axis without direction",
                edited("<freejoint name=\"to_arm\"/>", "<joint axis=\"0 0 0\"/>"),
            ),
            (
                "density.implausible",
                "a box by whole edges, in mm",
                edited("size=\"0.055 0.095 0.155\"", "size=\"110 190 310\""),
            ),
            ("tree.duplicate_joint", "two joints of a name", edited("to_leg", "to_arm")),
        ],
        Language::Usd => vec![
            (
                "density.implausible",
                "metres declared as centimetres",
                edited("metersPerUnit = 1\n", "metersPerUnit = 0.01\n"),
            ),
            (
                "density.implausible",
                "kilograms declared as grams",
                edited("metersPerUnit = 1\n", "metersPerUnit = 1\n    kilogramsPerUnit = 0.001\n"),
            ),
            ("number.missing", "two moments", one_less("diagonalInertia = (", ')')),
            (
                "number.malformed",
                "three numbers of a quaternion",
                edited("principalAxes = (", "principalAxes = (1, 0, 0)\nquatf unused = ("),
            ),
            (
                "tree.unknown_link",
                "a body that is not there",
                edited(
                    "def Xform \"leg\"",
                    "def PhysicsFixedJoint \"j\" { rel physics:body0 = </r/arm>\n rel physics:body1 = </r/foot>\n }\ndef Xform \"leg\"",
                ),
            ),
        ],
        Language::Osim => vec![
            ("number.missing", "five numbers", one_less("<inertia>", '<')),
            ("inertia.missing", "no tensor", without("<inertia>", "</inertia>")),
            ("mass.missing", "no mass", without("<mass>", "</mass>")),
            ("tree.unknown_link", "a child that is not there", edited("/bodyset/leg", "/bodyset/foot")),
            (
                "tree.two_parents",
                "two joints to one body",
                edited(
                    "</objects></JointSet>",
                    "<WeldJoint name=\"w\"><socket_parent_frame>/bodyset/arm</socket_parent_frame><socket_child_frame>/bodyset/leg</socket_child_frame></WeldJoint></objects></JointSet>",
                ),
            ),
            (
                "tree.cycle",
                "a body on itself",
                edited("<socket_parent_frame>/ground<", "<socket_parent_frame>/bodyset/arm<"),
            ),
            ("tree.duplicate_joint", "two joints of a name", edited("to_leg", "to_arm")),
            ("number.malformed", "a centre in words", edited("<mass_center>0.06", "<mass_center>0,06")),
        ],
    }
}

fn all() -> Vec<Fault> {
    let mut faults = Vec::new();
    for language in Language::ALL {
        let leg = language.spec(&other(), "leg");
        for (code, what, spec) in of_numbers(language) {
            faults.push(Fault { code, language, what, text: language.model(&[spec, leg.clone()]) });
        }
        for (code, what, specs) in of_pairs(language) {
            faults.push(Fault { code, language, what, text: language.model(&specs) });
        }
        for (code, what, text) in of_text(language) {
            faults.push(Fault { code, language, what, text });
        }
    }
    faults
}

#[test]
fn every_planted_fault_is_found() {
    let (mut codes, mut languages) = (BTreeMap::new(), BTreeMap::new());
    let mut missed = Vec::new();
    for language in Language::ALL {
        let text = language.model(&[language.spec(&slab(), "arm"), language.spec(&other(), "leg")]);
        let findings = inspected(language, &text, &format!("right-{language:?}")).1.findings;
        assert!(findings.iter().all(|f| f.severity == Severity::Note), "{language:?}: {findings:#?}");
    }
    for (k, Fault { code, language, what, text }) in all().into_iter().enumerate() {
        let findings = inspected(language, &text, &format!("fault-{k}")).1.findings;
        let lets_pass = code == "tree.shared_name" && language != Language::Sdf;
        let is_found = findings.iter().any(|f| f.code == code && (f.severity > Severity::Note || lets_pass));
        if !is_found {
            let instead: Vec<_> = findings.iter().map(|f| (f.code, f.severity, &f.message)).collect();
            missed.push(format!("{language:?} {code}, {what}: {instead:#?}"));
        }
        *codes.entry(code).or_insert(0) += 1;
        *languages.entry(format!("{language:?}")).or_insert(0) += 1;
    }
    assert!(missed.is_empty(), "{} missed\n{}", missed.len(), missed.join("\n"));
    assert!(languages.len() == 6 && languages.values().all(|&count| count >= 10), "{languages:?}");
    assert!(codes.values().all(|&count| count >= 2), "{codes:?}");
}
