//! USD with several layers: content that is not read is reported, and damage is refused.

use std::path::Path;

use polhode_robot::body::{LinkMass, link_mass};
use polhode_robot::check::check;
use polhode_robot::finding::Severity;
use polhode_robot::geometry::Shapes;
use polhode_robot::inspect::inspect;
use polhode_robot::model::{Note, RobotModel};
use polhode_robot::read::{ReadOptions, read_model};
use polhode_source::FormatError;
use polhode_source::files::Memory;

use crate::usd_stages::folder;

const BODY: &str = "float physics:mass = 2.5\n    point3f physics:centerOfMass = (0.1, -0.3, 0.2)\n    \
    float3 physics:diagonalInertia = (0.5, 0.7, 0.9)\n    quatf physics:principalAxes = (0.8, 0.2, -0.4, 0.4)\n";
const SCHEMAS: &str = "prepend apiSchemas = [\"PhysicsRigidBodyAPI\", \"PhysicsMassAPI\"]";

/// Returns a layer with a head and prims.
fn layer(head: &str, prims: &str) -> String {
    format!("#usda 1.0\n(\n    metersPerUnit = 1\n    {head}\n)\n{prims}\n")
}

fn part() -> String {
    layer("defaultPrim = \"part\"", &format!("def Xform \"part\" ({SCHEMAS})\n{{\n    {BODY}}}"))
}

fn read(files: &[(&str, &[u8])]) -> Result<RobotModel, FormatError> {
    let mut memory = Memory::default();
    for (path, bytes) in files {
        memory.insert(path, bytes.to_vec());
    }
    read_model(Path::new(files[0].0), &ReadOptions { files: &memory, ..ReadOptions::default() })
}

fn texts(files: &[(&str, &str)]) -> Result<RobotModel, FormatError> {
    read(&files.iter().map(|(path, text)| (*path, text.as_bytes())).collect::<Vec<_>>())
}

fn masses(model: &RobotModel) -> Vec<(&str, f64)> {
    let mass = |link| match link_mass(model.format, link) {
        Ok(LinkMass::Body(body)) => body.properties.mass(),
        _ => 0.0,
    };
    model.links.iter().map(|link| (link.name.text.as_str(), mass(link))).collect()
}

fn noted<'m>(model: &'m RobotModel, code: &str) -> &'m Note {
    model.notes.iter().find(|note| note.code == code).unwrap_or_else(|| panic!("{:?}", model.notes))
}

#[test]
fn a_value_has_its_place_in_its_layer() {
    let root = layer(
        "",
        "def \"arm\" (references = @parts/part.usda@)\n{\n    float physics:mass = 3.25\n}\n\
         def \"hand\" (payload = @parts/part.usda@)\n{\n}",
    );
    let model = texts(&[("robot/robot.usda", &root), ("robot/parts/part.usda", &part())]).unwrap();
    assert_eq!(masses(&model), [("/arm", 3.25), ("/hand", 2.5)]);
    let [own, other] = [0, 1].map(|k| model.links[k].inertial.as_ref().unwrap().mass.span());
    assert_eq!((&model.text[own.clone()], model.is_included(&own)), ("3.25", false));
    assert!(model.is_included(&other));
    let part = &model.included[0];
    assert_eq!(&part.text[other.start - part.start..other.end - part.start], "2.5");
    assert!(part.path.ends_with("parts/part.usda"), "{:?}", part.path);
}

#[test]
fn what_is_missing_is_reported() {
    let root = layer("", "def \"arm\" (references = @gone.usda@)\n{\n}");
    let model = texts(&[("robot.usda", &root)]).unwrap();
    let note = noted(&model, "read.include");
    assert_eq!((note.subject.as_str(), &root[note.span.clone()]), ("/arm", "gone.usda"));
    assert!(note.message.contains("@gone.usda@ is not read"), "{}", note.message);
    for (name, said) in [("other.obj", "not a USD layer"), ("https://a/b.usd", "not opened")] {
        let root = root.replace("gone.usda", name);
        let model = texts(&[("robot.usda", &root), ("other.obj", "v 0 0 0")]).unwrap();
        let note = noted(&model, "read.include");
        assert!(note.message.contains(said), "{}", note.message);
    }
    let root = layer("subLayers = [@gone.usda@]", "def \"arm\"\n{\n}");
    let model = texts(&[("robot.usda", &root)]).unwrap();
    assert_eq!(&root[noted(&model, "read.include").span.clone()], "[@gone.usda@]");
    // The prim, and the default prim, of a layer.
    for (part, target) in [(part(), "</none>"), (layer("", "def \"part\" {\n}"), "")] {
        let root = layer("", &format!("def \"arm\" (references = @part.usda@{target})\n{{\n}}"));
        let model = texts(&[("robot.usda", &root), ("part.usda", &part)]).unwrap();
        assert_eq!(noted(&model, "read.include").severity, Severity::Suspect);
    }
}

#[test]
fn variants_are_selected() {
    let root = |selection: &str| {
        layer(
            "",
            &format!(
                "def Xform \"arm\" (\n    {SCHEMAS}\n    {selection}\n    prepend variantSets = \"load\"\n)\n{{\n    {}\
                 variantSet \"load\" = {{\n        \"full\" {{\n            float physics:mass = 4.5\n        }}\n        \
                 \"v1.0\" {{\n            float physics:mass = 1.5\n            def Cube \"c\" {{\n            }}\n        }}\n    }}\n}}",
                BODY.replace("float physics:mass = 2.5", "")
            ),
        )
    };
    for (selected, mass, shapes) in [("full", 4.5, 0), ("v1.0", 1.5, 1)] {
        let text = root(&format!("variants = {{\n        string load = \"{selected}\"\n    }}"));
        let model = texts(&[("robot.usda", &text)]).unwrap();
        assert_eq!(masses(&model), [("/arm", mass)]);
        let span = model.links[0].inertial.as_ref().unwrap().mass.span();
        assert_eq!(text[span].parse(), Ok(mass));
        assert_eq!(model.links[0].geometry.len(), shapes);
        assert_eq!(model.notes, []);
    }
    let text = root("variants = {\n        string load = \"none\"\n    }");
    let model = texts(&[("robot.usda", &text)]).unwrap();
    let note = noted(&model, "read.left_out");
    assert_eq!((note.severity, masses(&model)), (Severity::Suspect, vec![("/arm", 0.0)]));
    assert!(note.message.contains("\"load\" has no variant \"none\""), "{}", note.message);
    let text = root("");
    let model = texts(&[("robot.usda", &text)]).unwrap();
    let note = noted(&model, "read.left_out");
    assert!(note.message.contains("no variant of \"load\" is selected"), "{}", note.message);
}

#[test]
fn a_unit_of_another_layer_does_not_count() {
    let part = part().replace("metersPerUnit = 1", "metersPerUnit = 0.01\n    kilogramsPerUnit = 1");
    let root = layer("", "def \"arm\" (references = @part.usda@)\n{\n}");
    let model = texts(&[("robot.usda", &root), ("part.usda", &part)]).unwrap();
    let note = noted(&model, "read.unit");
    assert!(note.severity == Severity::Suspect && model.is_included(&note.span), "{note:?}");
    assert!(note.message.contains("metersPerUnit is 0.01 here and 1 in the root layer"), "{}", note.message);
}

#[test]
fn inactive_and_undefined_prims_do_not_exist() {
    let prims = format!(
        "def \"a\" (active = false\n references = @part.usda@)\n{{\n}}\nover \"b\" ({SCHEMAS})\n{{\n    {BODY}}}\n\
         class \"c\" ({SCHEMAS})\n{{\n    {BODY}}}\ndef \"d\" (inherits = </c>)\n{{\n}}"
    );
    let model = texts(&[("robot.usda", &layer("", &prims)), ("part.usda", &part())]).unwrap();
    assert_eq!(masses(&model), [("/d", 2.5)]);
}

#[test]
fn value_clips_are_reported() {
    let clips = "clips = {\n        dictionary default = {\n            asset[] assetPaths = [@clip.usda@]\n            \
        string primPath = \"/a\"\n            double2[] active = [(0, 0)]\n        }\n    }";
    let text = layer("", &format!("def Xform \"a\" (\n    {clips}\n    {SCHEMAS}\n)\n{{\n    {BODY}}}"));
    let model = texts(&[("robot.usda", &text)]).unwrap();
    let note = noted(&model, "read.animated");
    assert_eq!((note.subject.as_str(), masses(&model)), ("/a", vec![("/a", 2.5)]));
}

#[test]
fn instances_are_bodies_that_are_not_edited() {
    let wrong = part().replace("(0.5, 0.7, 0.9)", "(0.5, 0.7, 9)");
    let prims = "def \"left\" (\n    instanceable = true\n    references = @part.usda@\n)\n{\n}\n\
        def \"right\" (\n    instanceable = true\n    references = @part.usda@\n)\n{\n}";
    let model = texts(&[("robot.usda", &layer("", prims)), ("part.usda", &wrong)]).unwrap();
    let names: Vec<_> = model.links.iter().map(|link| link.name.text.as_str()).collect();
    assert_eq!((names.as_slice(), model.is_editable), (["/left", "/right"].as_slice(), false));
    let found = check(&model, &[]);
    assert!(!found.is_empty() && found.iter().all(|finding| finding.repair.is_none()));
}

#[test]
fn joints_of_instances_hold_their_own_bodies() {
    let body = |name: &str| format!("def Xform \"{name}\" ({SCHEMAS})\n{{\n    {BODY}}}\n");
    let joint = "def PhysicsRevoluteJoint \"elbow\"\n{\n    rel physics:body0 = </part/upper>\n    rel physics:body1 = </part/lower>\n}\n";
    let part = format!("def Xform \"part\"\n{{\n{}{}{joint}}}\n", body("upper"), body("lower"));
    let part = layer("defaultPrim = \"part\"", &part);
    let arm = |name: &str| {
        format!("def \"{name}\" (\n    instanceable = true\n    references = @part.usda@\n)\n{{\n}}\n")
    };
    let root = layer("", &(arm("left") + &arm("right")));
    let model = texts(&[("robot.usda", &root), ("part.usda", &part)]).unwrap();
    let ends: Vec<_> = model
        .joints
        .iter()
        .map(|joint| (joint.parent.as_ref().unwrap().text.as_str(), joint.child.text.as_str()))
        .collect();
    assert_eq!(ends, [("/left/upper", "/left/lower"), ("/right/upper", "/right/lower")]);
}

#[test]
fn circles_are_refused() {
    let refer =
        |name: &str| layer("defaultPrim = \"a\"", &format!("def \"a\" (references = @{name}@)\n{{\n}}"));
    let own = layer("", "def \"a\" (references = </b>)\n{\n}\ndef \"b\" (inherits = </a>)\n{\n}");
    let under = |name: &str| layer(&format!("subLayers = [@{name}@]"), "");
    for files in [
        vec![("r.usda", refer("s.usda")), ("s.usda", refer("r.usda"))],
        vec![("r.usda", refer("r.usda"))],
        vec![("r.usda", own)],
        vec![("r.usda", under("s.usda")), ("s.usda", under("r.usda"))],
    ] {
        let files: Vec<_> = files.iter().map(|(path, text)| (*path, text.as_str())).collect();
        let error = texts(&files).unwrap_err();
        assert!(error.to_string().contains("circle"), "{error}");
    }
    // Prims that contain themselves.
    let grows = layer("", "def \"a\" {\n    def \"b\" (references = </a>)\n{\n}\n}");
    assert!(texts(&[("r.usda", &grows)]).is_err());
}

#[test]
fn an_error_in_a_layer_has_its_place() {
    let root = layer("", "def \"arm\" (references = @part.usda@)\n{\n}");
    for (right, wrong) in [("= 2.5", "= 2.5kg"), ("Xform", "Xform Xform {")] {
        let part = part();
        assert!(part.contains(right));
        let part = part.replace(right, wrong);
        let error = texts(&[("robot.usda", &root), ("part.usda", &part)]).expect_err(wrong);
        assert!(error.path().ends_with("part.usda"), "{error}");
        let line = part.lines().position(|line| line.contains(wrong)).unwrap() + 1;
        let place = error.place().unwrap_or_else(|| panic!("{error}")).line;
        assert!(place == line || place == line + 1, "{error}: {place}, not {line}");
    }
}

#[test]
fn nesting_is_limited() {
    let deep = |open: &str, count: usize, close: &str| {
        layer(
            "",
            &format!("def \"a\" (references = </b>)\n{{\n}}\n{}{}", open.repeat(count), close.repeat(count)),
        )
    };
    let prims = deep("def \"b\" {\n", 400, "}\n");
    assert!(texts(&[("r.usda", &prims)]).is_ok());
    for (open, close) in [("def \"b\" {\n", "}\n"), ("dictionary d = {\n", "}\n")] {
        let text = deep(open, 5000, close);
        let error = texts(&[("r.usda", &text)]).unwrap_err();
        assert!(error.to_string().contains("nested deeper"), "{error}");
    }
}

#[test]
fn a_binary_layer_cannot_be_edited_and_names_itself() {
    let file = folder().join("inherit/robot.usdc");
    let model = read_model(&file, &ReadOptions::default()).unwrap();
    assert!(!model.is_editable && model.text.is_empty() && !model.links.is_empty());
    assert_eq!(model.path, file);
}

fn bytes(file: &str) -> Vec<u8> {
    std::fs::read(folder().join(file)).unwrap()
}

#[test]
fn damaged_files_are_refused() {
    let (layer, package) = (bytes("inherit/robot.usdc"), bytes("package.usdz"));
    for (name, whole) in [("r.usdc", &layer), ("r.usdz", &package)] {
        assert!(read(&[(name, whole)]).is_ok());
        for length in [8, 20, 88, whole.len() / 2, whole.len() - 1] {
            assert!(read(&[(name, &whole[..length])]).is_err(), "{name} {length}");
        }
    }
    // Sizes of 2⁶⁰ and 2³⁰, at each multiple of eight bytes: an error or another stage.
    for size in [1_u64 << 60, 1 << 30] {
        for at in (16..layer.len() - 8).step_by(8) {
            let mut wrong = layer.clone();
            wrong[at..at + 8].copy_from_slice(&size.to_le_bytes());
            let _ = read(&[("r.usdc", &wrong)]);
        }
    }
    let error = read(&[("r.usdc", b"PXR-USDC\0\x01\0\0\0\0\0\0\0\0")]).unwrap_err();
    assert!(error.to_string().contains("version 0.1.0"), "{error}");
    let error =
        read(&[("r.usda", b"#usda 1.0\n(\n subLayers = [@s.usd@]\n)\n"), ("s.usd", b"#usda 1.0\n\xff")]);
    let error = error.unwrap_err();
    assert!(error.to_string().contains("not UTF-8"), "{error}");
}

/// Mutates a file by the given draws; the result is a model or an error, and the process continues.
#[test]
fn mutated_files_do_not_end_the_process() {
    let count = std::env::var("POLHODE_USD_DRAWS").ok().and_then(|count| count.parse().ok()).unwrap_or(40);
    let mut state = 0x9e37_79b9_7f4a_7c15_u64;
    let mut draw = |most: usize| {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        usize::try_from(state >> 33).unwrap() % most
    };
    let files = ["inherit/robot.usdc", "local/robot.usdc", "package.usdz"].map(bytes);
    for k in 0..count {
        let mut file = files[k % 3].clone();
        for _ in 0..=draw(4) {
            let at = draw(file.len());
            file[at] = [0, 1, 0x7f, 0xff, u8::try_from(draw(256)).unwrap()][draw(5)];
        }
        let name = if k % 3 == 2 { "r.usdz" } else { "r.usdc" };
        let _ = read(&[(name, &file)]);
    }
}

/// `openusd` 0.6 recurses without end for this, which no thread survives.
#[test]
fn a_prim_that_inherits_twice_is_refused() {
    let inner = |kind: &str, arcs: &str| {
        format!(
            "def \"a\"\n{{\n    def \"r\"\n    {{\n        def \"y\"\n        {{\n        }}\n    }}\n}}\n\
             def \"b\" ({kind} = </a>)\n{{\n    over \"r\" ({arcs})\n    {{\n    }}\n}}"
        )
    };
    for arcs in ["inherits = </a/r>", "prepend specializes = [</other>, </a/r>]"] {
        let error = texts(&[("robot.usda", &layer("", &inner("inherits", arcs)))]).unwrap_err();
        let (said, hint) = (error.to_string(), error.hint().unwrap_or_default());
        assert!(said.contains("</b/r>, which inherits </a/r> itself and by </b>"), "{said}");
        assert!(hint.contains("</b> brings the same"), "{hint}");
    }
    texts(&[("robot.usda", &layer("", &inner("inherits", "inherits = </a/r/y>")))]).unwrap();
}

#[test]
fn a_schema_that_a_layer_deletes_and_adds_is_applied() {
    let body = |edits: &str| format!("over \"part\" ({edits})\n{{\n}}");
    let both = "delete apiSchemas = [\"PhysicsMassAPI\", \"PhysicsRigidBodyAPI\"]\n\
                prepend apiSchemas = [\"PhysicsMassAPI\", \"PhysicsRigidBodyAPI\"]";
    for (edits, applied) in [
        (both, true),
        ("delete apiSchemas = [\"PhysicsMassAPI\", \"PhysicsRigidBodyAPI\"]", false),
        ("apiSchemas = []", false),
        ("append apiSchemas = [\"PhysicsCollisionAPI\"]", true),
    ] {
        let root = layer("subLayers = [@part.usda@]", &body(edits));
        let model = texts(&[("robot.usda", &root), ("part.usda", &part())]).unwrap();
        let ignored = model.notes.iter().any(|note| note.message.contains("PhysicsMassAPI is not applied"));
        assert_eq!(ignored, !applied, "{edits}: {:?}", model.notes);
    }
}

/// The layer that is not read may apply its schemas.
#[test]
fn an_over_of_a_prim_that_is_not_read_is_not_accused() {
    let prims = "def \"bottle\" (references = @gone.usda@)\n{\n    over \"entity\"\n    {\n        float physics:mass = 0.5\n    }\n}";
    let model = texts(&[("robot.usda", &layer("", prims))]).unwrap();
    assert!(model.notes.iter().all(|note| note.severity == Severity::Note), "{:?}", model.notes);
    let class = "class \"Api\"\n{\n    uniform int mjc:compiler:inertiaGroupRange:max = 5\n}";
    assert_eq!(texts(&[("robot.usda", &layer("", class))]).unwrap().notes, []);
}

/// The shapes that are read may be a small part of the body.
#[test]
fn shapes_beside_content_that_is_not_read_prove_nothing() {
    let prims = |more: &str| {
        format!(
            "def Xform \"base\" ({SCHEMAS})\n{{\n    {BODY}    def Sphere \"site\"\n    {{\n        double radius = 0.005\n    }}\n{more}}}"
        )
    };
    let codes = |more: &str| {
        let model = texts(&[("robot.usda", &layer("", &prims(more)))]).unwrap();
        inspect(&model, &Shapes::default()).findings.iter().map(|finding| finding.code).collect::<Vec<_>>()
    };
    assert!(codes("").contains(&"density.implausible"));
    let found = codes("    def \"visuals\" (references = @gone.usda@)\n    {\n    }\n");
    assert_eq!(found, ["read.include"]);
}

#[test]
fn a_pointer_of_git_lfs_is_named() {
    let pointer = "version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 12345\n";
    let error = texts(&[("robot.usda", pointer)]).unwrap_err();
    assert!(error.to_string().contains("Git LFS pointer, not the file itself: run git lfs pull"), "{error}");
    let root = layer("", "def \"arm\" (references = @mesh.usd@)\n{\n}");
    let model = texts(&[("robot.usda", &root), ("mesh.usd", pointer)]).unwrap();
    let note = noted(&model, "read.include");
    assert!(note.message.contains("git lfs pull"), "{}", note.message);
}

#[test]
fn a_scale_that_resolves_units_makes_them_a_note() {
    let other = part().replace("metersPerUnit = 1", "metersPerUnit = 0.01");
    let arm = |ops: &str| layer("", &format!("def Xform \"arm\" (references = @part.usda@)\n{{\n{ops}}}"));
    let severity = |ops: &str| {
        let model = texts(&[("robot.usda", &arm(ops)), ("part.usda", &other)]).unwrap();
        noted(&model, "read.unit").severity
    };
    assert_eq!(severity(""), Severity::Suspect);
    let scale = "double3 xformOp:scale:unitsResolve = (0.01, 0.01, 0.01)\nuniform token[] xformOpOrder = [\"xformOp:scale:unitsResolve\"]\n";
    assert_eq!(severity(scale), Severity::Note);
}
