//! 3MF: one solid in every representation, and broken files.

use std::io::{Cursor, Write};

use polhode::body::Severity;
use polhode::body::mesh::ClosedMesh;
use polhode_shape::mesh::MeshContents;
use polhode_shape::mesh::threemf::read;
use polhode_source::ContentError;
use zip::write::{SimpleFileOptions, ZipWriter};

/// Irregular octahedron: the points 0 to 3 form a ring, 4 is above it and 5 below.
const POINTS: [[i8; 3]; 6] =
    [[90, 3, -7], [4, 70, -9], [-80, 5, 11], [-6, -60, 13], [8, -2, 50], [10, 12, -40]];
/// Faces, counter-clockwise as seen from outside.
const FACES: [[u8; 3]; 8] =
    [[4, 0, 1], [4, 1, 2], [4, 2, 3], [4, 3, 0], [5, 1, 0], [5, 2, 1], [5, 3, 2], [5, 0, 3]];
const PRODUCTION: &str = "http://schemas.microsoft.com/3dmanufacturing/production/2015/06";
const MODEL: &str = "3D/3dmodel.model";
/// Transformation: scaled by 1/32, x → y → z → x, then displaced.
const PLACED: &str = "0 0.03125 0 0 0 0.03125 0.03125 0 0 0.5 -3 7.25";

type Corners = Vec<[[f64; 3]; 3]>;

/// Returns the solid as placed by [`PLACED`].
fn expected() -> Corners {
    let placed = |k: u8| {
        let [x, y, z] = POINTS[usize::from(k)].map(|c| f64::from(c) / 32.0);
        [z + 0.5, x - 3.0, y + 7.25]
    };
    FACES.map(|face| face.map(placed)).to_vec()
}

fn corners(contents: &MeshContents) -> Corners {
    contents.parts.iter().flat_map(|part| part.mesh.corners()).collect()
}

fn mesh() -> String {
    let vertex = |[x, y, z]: [i8; 3]| format!("<vertex x=\"{x}\" y='{y}.0' z=\" {z}e0 \"/>\n");
    let triangle = |[a, b, c]: [u8; 3]| format!("<triangle v1=\"{a}\" v2=\"{b}\" v3=\"{c}\" pid=\"9\"/>\n");
    let (vertices, triangles) = (POINTS.map(vertex).concat(), FACES.map(triangle).concat());
    format!("<mesh>\n<vertices>\n{vertices}</vertices>\n<triangles>\n{triangles}</triangles>\n</mesh>")
}

fn model(attributes: &str, resources: &str, build: &str) -> String {
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model {attributes} xmlns:p=\"{PRODUCTION}\" \
         xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">\n<metadata name=\"Title\">nuts &amp; \
         bolts</metadata>\n<resources>\n{resources}\n</resources>\n<build>{build}</build>\n</model>\n"
    )
}

fn plain() -> String {
    let object = format!("<object id=\"3\" name=\"stone\" type=\"model\">{}</object>", mesh());
    model("unit=\"millimeter\"", &object, &format!("<item objectid=\"3\" transform=\"{PLACED}\"/>"))
}

/// Returns a compressed package.
fn package(entries: &[(&str, &str)]) -> Vec<u8> {
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    for (name, text) in entries {
        zip.start_file(*name, SimpleFileOptions::default()).unwrap();
        zip.write_all(text.as_bytes()).unwrap();
    }
    zip.finish().unwrap().into_inner()
}

fn read_model(model: &str) -> Result<MeshContents, ContentError> {
    read(&package(&[(MODEL, model)]))
}

/// Returns a package of uncompressed entries. The caller defines the offset of each local header.
fn stored(entries: &[(&str, &[u8])], offset: impl Fn(usize, usize) -> usize) -> Vec<u8> {
    let (mut bytes, mut directory) = (Vec::new(), Vec::new());
    for (k, (name, data)) in entries.iter().enumerate() {
        let at = (offset(k, bytes.len()) as u32).to_le_bytes();
        let (size, length) = ((data.len() as u32).to_le_bytes(), (name.len() as u16).to_le_bytes());
        let crc = crc32(data).to_le_bytes();
        // Version, flags, method, time, date; checksum and sizes; lengths of name and extra field.
        let common =
            [&[20, 0, 0, 0, 0, 0, 0, 0, 33, 0], crc.as_slice(), &size, &size, &length, &[0; 2]].concat();
        bytes.extend([b"PK\x03\x04", common.as_slice(), name.as_bytes(), data].concat());
        directory.extend([b"PK\x01\x02\x14\0", common.as_slice(), &[0; 10], &at, name.as_bytes()].concat());
    }
    let (count, start) = ((entries.len() as u16).to_le_bytes(), (bytes.len() as u32).to_le_bytes());
    let size = (directory.len() as u32).to_le_bytes();
    let end = [b"PK\x05\x06\0\0\0\0", count.as_slice(), &count, &size, &start, &[0; 2]].concat();
    [bytes, directory, end].concat()
}

fn crc32(bytes: &[u8]) -> u32 {
    let step = |crc: u32, _| if crc & 1 == 1 { crc >> 1 ^ 0xedb8_8320 } else { crc >> 1 };
    !bytes.iter().fold(!0, |crc, &b| (0..8).fold(crc ^ u32::from(b), step))
}

#[test]
fn the_plain_solid() {
    let contents = read_model(&plain()).unwrap();
    assert_eq!((contents.encoding, contents.unit), ("zip", Some(1e-3)));
    assert_eq!((contents.name.as_str(), contents.parts[0].name.as_str()), ("nuts & bolts", "stone"));
    assert_eq!((contents.parts.len(), contents.findings.len()), (1, 0));
    assert_eq!(corners(&contents), expected());
    assert!(!ClosedMesh::from_triangles(corners(&contents)).unwrap().inverted());
    let by_hand = stored(&[("/3D/3dModel.model", plain().as_bytes())], |_, offset| offset);
    assert_eq!(read(&by_hand).unwrap(), contents);
}

#[test]
fn prefixes_and_foreign_elements() {
    let text = plain();
    let renamed = text.replace(" xmlns=", " xmlns:c=");
    let body = renamed.split_once('\n').unwrap().1;
    let prefixed = body.replace('<', "<c:").replace("<c:/", "</c:");
    assert_eq!(read_model(&prefixed).unwrap().parts, read_model(&text).unwrap().parts);
    let looks = text.replace("<resources>", "<resources><!-- <object/> --><m:colorgroup xmlns:m=\"http://schemas.microsoft.com/3dmanufacturing/material/2015/02\" id=\"3\"><m:color/></m:colorgroup><basematerials id=\"5\"/>");
    assert_eq!(read_model(&looks).unwrap(), read_model(&text).unwrap());
    // A vertex of another namespace is ignored.
    let other = text.replace("<vertices>", "<vertices><vertex xmlns=\"urn:x\" x=\"1\"/>");
    assert_eq!(read_model(&other).unwrap().parts, read_model(&text).unwrap().parts);
    let beams = text.replace(
        "</triangles>",
        "</triangles><b:beamlattice xmlns:b=\"urn:beams\"><b:beam/></b:beamlattice>",
    );
    let contents = read_model(&beams).unwrap();
    assert_eq!(
        (contents.findings[0].code, contents.findings[0].severity),
        ("mesh.extension_ignored", Severity::Warning)
    );
    assert_eq!(contents.findings[0].place.as_deref(), Some("3D/3dmodel.model, line 23: b:beamlattice"));
}

#[test]
fn units_of_length() {
    let units = [
        ("micron", 1e-6),
        ("millimeter", 1e-3),
        ("centimeter", 1e-2),
        ("inch", 0.0254),
        ("foot", 0.3048),
        ("meter", 1.0),
    ];
    for (name, metres) in units {
        let contents = read_model(&plain().replace("\"millimeter\"", &format!("\"{name}\""))).unwrap();
        assert_eq!((contents.unit, corners(&contents)), (Some(metres), expected()));
    }
    assert_eq!(read_model(&plain().replace("unit=\"millimeter\"", "")).unwrap().unit, Some(1e-3));
    let error = read_model(&plain().replace("\"millimeter\"", "\"mm\"")).unwrap_err();
    assert!(
        error.to_string().ends_with("unit = mm must be micron, millimeter, centimeter, inch, foot or meter")
    );
}

/// Placed twice through components, each with half of the displacement, and once directly.
#[test]
fn components_are_placed_by_all_that_is_above_them() {
    let resources = format!(
        "<object id=\"1\">{}</object>
         <object id=\"2\"><components><component objectid=\"1\" transform=\"0 1 0 0 0 1 1 0 0 16 -96 232\"/></components></object>
         <object id=\"5\" name=\"pair\"><components>
           <component objectid=\"2\" transform=\"0.0625 0 0 0 0.0625 0 0 0 0.0625 0 0 0\"/>
           <component objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 100 200 400\"/>
         </components></object>",
        mesh()
    );
    let build = "<item objectid=\"5\" transform=\"0.5 0 0 0 0.5 0 0 0 0.5 0 0 0\"/><item objectid=\"1\" partnumber=\"P-7\"/>";
    let contents = read_model(&model("", &resources, build)).unwrap();
    let names: Vec<_> = contents.parts.iter().map(|part| part.name.as_str()).collect();
    assert_eq!(names, ["pair", "pair", "P-7"]);
    assert_eq!(contents.parts[0].mesh.corners().collect::<Corners>(), expected());
    let [x, y, z] = POINTS[2].map(f64::from);
    assert_eq!(
        contents.parts[1].mesh.coordinates()[2],
        [0.5 * (x + 100.0), 0.5 * (y + 200.0), 0.5 * (z + 400.0)]
    );
    assert_eq!(contents.parts[2].mesh.coordinates()[2], [x, y, z]);
}

#[test]
fn objects_in_other_files_of_the_package() {
    let part = model("", &format!("<object id=\"3\" name=\"stone\">{}</object>", mesh()), "");
    let root = model(
        "requiredextensions=\"p\"",
        "<object id=\"3\"><components><component objectid=\"3\" p:path=\"/3D/Objects/stone.model\"/></components></object>",
        &format!("<item objectid=\"3\" transform=\"{PLACED}\"/>"),
    );
    let relations = "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">\
        <Relationship Target=\"/thumb.png\" Id=\"a\" Type=\"thumbnail\"/>\
        <Relationship Target=\"/Main/root.model\" Id=\"b\" Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>";
    let entries = [("_rels/.rels", relations), ("Main/root.model", &root), ("3D/Objects/stone.model", &part)];
    let contents = read(&package(&entries)).unwrap();
    assert_eq!((corners(&contents), contents.parts[0].name.as_str()), (expected(), "stone"));

    let error = read(&package(&entries[..2])).unwrap_err().to_string();
    assert_eq!(
        error,
        "Main/root.model, line 5: path = /3D/Objects/stone.model must be a model file of the package"
    );
    let inches = part.replace("<model ", "<model unit=\"inch\" ");
    let error = read(&package(&[entries[0], entries[1], (entries[2].0, &inches)])).unwrap_err().to_string();
    assert_eq!(error, "3D/Objects/stone.model: unit = inch must be millimeter, the unit of Main/root.model");
    // A cycle through two files.
    let back = model(
        "",
        "<object id=\"3\"><components><component objectid=\"3\" p:path=\"/Main/root.model\"/></components></object>",
        "",
    );
    let error = read(&package(&[entries[0], entries[1], (entries[2].0, &back)])).unwrap_err().to_string();
    assert_eq!(
        error,
        "3D/Objects/stone.model, line 5: the component = object 3 must be acyclic: it contains itself"
    );
    assert_eq!(
        read(&package(&entries[..1])).unwrap_err().to_string(),
        "the file has no part Main/root.model"
    );
}

#[test]
fn what_is_no_solid_is_left_out() {
    let object = |id: u32, kind: &str| format!("<object id=\"{id}\" type=\"{kind}\">{}</object>", mesh());
    let resources =
        [object(1, "support"), object(2, "model"), object(3, "surface"), object(4, "other")].concat();
    let items: String = (1..=4).map(|id| format!("<item objectid=\"{id}\"/>")).collect();
    let contents = read_model(&model("", &resources, &items)).unwrap();
    assert_eq!((contents.parts.len(), contents.findings.len()), (1, 1));
    assert_eq!(
        (contents.findings[0].code, contents.findings[0].severity),
        ("mesh.not_a_solid", Severity::Info)
    );
    assert!(contents.findings[0].message.starts_with("3 objects are not part of the solid"));
    let error = read_model(&model("", &object(1, "other"), "<item objectid=\"1\"/>")).unwrap_err();
    assert_eq!(error.to_string(), "the file has no triangles in its build");
}

#[test]
fn a_mirror_keeps_the_outside_outside() {
    for transform in ["-1 0 0 0 2 0 0 0 3 1 2 3", "0 1 0 1 0 0 0 0 1 0 0 0"] {
        let text = plain().replace(PLACED, transform);
        let solid = ClosedMesh::from_triangles(corners(&read_model(&text).unwrap())).unwrap();
        assert!(!solid.inverted());
    }
}

#[test]
fn a_model_that_contradicts_itself() {
    let cases = [
        ("id=\"3\"", "id=\"4\"", "26: objectid = 3 must be the id of an object in 3D/3dmodel.model"),
        (
            "</resources>",
            "<object id=\"3\"/></resources>",
            "25: id = 3 must be unique: the object on line 5 has the same id",
        ),
        ("id=\"3\" name", "name", "5: the file has no id of the object"),
        ("v3=\"3\"", "v3=\"6\"", "17: vertex 6 does not exist: there are 6"),
        ("v3=\"3\"", "v3=\"-1\"", "17: v3 = \"-1\" must be a whole number from 0, below 2³²"),
        ("v3=\"3\"", "", "17: the file has no v1, v2 or v3 of the triangle"),
        ("v3=\"3\"", "v1=\"3\"", "17: the triangle = v1 must be given once"),
        ("x=\"4\"", "x=\"nan\"", "8: x nan is not finite"),
        ("x=\"4\"", "x=\"1e400\"", "8: x 1e400 is not finite"),
        ("x=\"4\"", "x=\"0,5\"", "8: x = \"0,5\" must be a number"),
        ("x=\"4\"", "", "8: the file has no x, y or z of the vertex"),
        ("x=\"4\"", "x=\"4\" x=\"4\"", "8: the vertex = x must be given once"),
        (
            "7.25\"",
            "7.25 1\"",
            "26: transform = 0 0.03125 0 0 0 0.03125 0.03125 0 0 0.5 -3 7.25 1 must be twelve numbers",
        ),
        ("7.25\"", "inf\"", "26: transform inf is not finite"),
        (
            "7.25\"",
            "\"",
            "26: transform = 0 0.03125 0 0 0 0.03125 0.03125 0 0 0.5 -3  must be twelve numbers",
        ),
        ("<mesh>", "<components/><mesh>", "5: the object = mesh must be one mesh, or one list of components"),
        (
            "unit=\"millimeter\"",
            "requiredextensions=\"p b\" xmlns:b=\"urn:beams\"",
            "2: polhode does not read models that need the extension b (urn:beams)",
        ),
        (
            "unit=\"millimeter\"",
            "requiredextensions=\"b\"",
            "2: polhode does not read models that need the extension b ()",
        ),
        (
            "<model",
            "<!DOCTYPE model [<!ENTITY a \"b\">]>\n<model",
            "2: polhode does not read XML with a document type declaration, which packages must not have",
        ),
        ("core/2015/02", "core/2013/01", "2: expected one model element of 3MF, found \"model\""),
        ("</build>\n</model>", "</build>\n", "28: expected the end of an element, found the end of the file"),
    ];
    for (from, to, message) in cases {
        let error = read_model(&plain().replacen(from, to, 1)).unwrap_err().to_string();
        assert_eq!(error, format!("3D/3dmodel.model, line {message}"), "{from} {to}");
    }
    for (from, to) in [
        ("</mesh>", "</mess>"),
        ("<mesh>", "<mesh"),
        ("name=\"stone\"", "name=\"&stone;\""),
        ("name=\"stone\"", "name=stone"),
    ] {
        let error = read_model(&plain().replacen(from, to, 1)).unwrap_err().to_string();
        assert!(
            error.starts_with("3D/3dmodel.model, line ") && error.contains("must be well-formed"),
            "{error}"
        );
    }
    let utf16: Vec<u8> =
        plain().replace("UTF-8", "UTF-16").encode_utf16().flat_map(u16::to_le_bytes).collect();
    assert!(read(&stored(&[(MODEL, &[b"\xff\xfe", utf16.as_slice()].concat())], |_, at| at)).is_err());
    let latin = plain()
        .replace("stone", "st\u{1}ne")
        .into_bytes()
        .iter()
        .map(|&b| if b == 1 { 0xf6 } else { b })
        .collect::<Vec<_>>();
    let error = read(&stored(&[(MODEL, &latin)], |_, at| at)).unwrap_err().to_string();
    assert!(error.contains("must be UTF-8"), "{error}");
}

#[test]
fn archives_that_are_broken() {
    let error = |bytes: &[u8]| read(bytes).unwrap_err().to_string();
    assert_eq!(error(b""), "byte 0: expected the \"PK\" of a ZIP archive, found the end of the file");
    assert_eq!(error(b"solid x"), "byte 0: expected the \"PK\" of a ZIP archive, found \"solid x\"");
    assert_eq!(error(&package(&[("a.txt", "a")])), "the file has no part 3D/3dmodel.model");
    let text = plain();
    for name in ["../3dmodel.model", "3D/../../x", "//x", "/../x", "a\\b", "C:x", "..", "a/.."] {
        let bytes = stored(&[(MODEL, text.as_bytes()), (name, b"x")], |_, at| at);
        assert_eq!(
            error(&bytes),
            format!(
                "entry 1 of the archive: the name of an entry = {name} must be a path inside the archive"
            )
        );
    }
    let twice = stored(&[(MODEL, text.as_bytes()), ("3d/3DMODEL.model", b"x")], |_, at| at);
    assert_eq!(
        error(&twice),
        "entry 1 of the archive: the name of an entry = 3d/3DMODEL.model must be there once"
    );
    let shared = "the archive = entries with the same name or overlapping bytes must be entries of their own";
    let overlapping = stored(&[(MODEL, text.as_bytes()), ("3D/copy.model", text.as_bytes())], |_, _| 0);
    assert_eq!(error(&overlapping), shared);
    let twice = stored(&[(MODEL, text.as_bytes()), (MODEL, text.as_bytes())], |_, at| at);
    assert_eq!(error(&twice), shared);
    let mut damaged = stored(&[(MODEL, text.as_bytes())], |_, at| at);
    let at = damaged.windows(9).position(|w| w == b"</model>\n").unwrap();
    damaged[at + 8] = b' ';
    assert!(error(&damaged).contains("the entry = "), "{}", error(&damaged));
}

/// The reader uses the directory at the end of an archive; other programs use the local headers.
#[test]
fn both_descriptions_of_an_entry_say_the_same() {
    let text = plain();
    let whole = stored(&[(MODEL, text.as_bytes()), ("a.txt", b"abc")], |_, at| at);
    assert!(read(&whole).is_ok());
    for (at, what) in [(8, "method"), (14, "check sum"), (18, "packed size"), (22, "size"), (31, "name")] {
        let mut bytes = whole.clone();
        bytes[at] ^= 4;
        let error = read(&bytes).unwrap_err();
        assert!(error.to_string().contains(&format!("the {what} in the entry's local header = ")), "{error}");
        assert!(
            error.to_string().contains("that of the archive's directory") && error.hint.is_some(),
            "{error}"
        );
    }
    // As written by programs that do not know the size in advance: zeros here, and the sizes after
    // the data.
    let mut later = whole;
    later[6] |= 8;
    later[14..26].fill(0);
    let directory = later.windows(4).position(|w| w == b"PK\x01\x02").unwrap();
    later[directory + 8] |= 8;
    assert!(read(&later).is_ok(), "{:?}", read(&later));
    // Both places declare fewer bytes than the entry contains.
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    zip.start_file(MODEL, SimpleFileOptions::default()).unwrap();
    zip.write_all(text.as_bytes()).unwrap();
    let mut bytes = zip.finish().unwrap().into_inner();
    let directory = bytes.windows(4).position(|w| w == b"PK\x01\x02").unwrap();
    let declared = (text.len() as u32 - 20).to_le_bytes();
    bytes[22..26].copy_from_slice(&declared);
    bytes[directory + 24..directory + 28].copy_from_slice(&declared);
    let error = read(&bytes).unwrap_err();
    assert!(error.to_string().contains("the entry = "), "{error}");
}

/// 80 MiB of blanks in 80 kB, and a tree of components with 10¹² leaves.
#[test]
fn a_file_that_unfolds_too_far_is_refused() {
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    zip.start_file(MODEL, SimpleFileOptions::default()).unwrap();
    zip.write_all(plain().as_bytes()).unwrap();
    for _ in 0..80 {
        zip.write_all(&vec![b' '; 1 << 20]).unwrap();
    }
    let error = read(&zip.finish().unwrap().into_inner()).unwrap_err();
    assert!(error.to_string().contains("expands to more than 64 MiB"), "{error}");

    for leaf in [mesh(), "<components/>".to_owned(), String::new()] {
        let mut resources = format!("<object id=\"0\">{leaf}</object>");
        for id in 1..=12 {
            let ten = format!("<component objectid=\"{}\"/>", id - 1).repeat(10);
            resources += &format!("<object id=\"{id}\"><components>{ten}</components></object>");
        }
        let error = read_model(&model("", &resources, "<item objectid=\"12\"/>")).unwrap_err();
        assert!(error.to_string().contains("expands to more than 256 MiB"), "{error}");
    }
    // A long chain is accepted.
    let mut resources = format!("<object id=\"0\">{}</object>", mesh());
    for id in 1..=20_000 {
        resources += &format!(
            "<object id=\"{id}\"><components><component objectid=\"{}\"/></components></object>",
            id - 1
        );
    }
    let contents = read_model(&model("", &resources, "<item objectid=\"20000\"/>")).unwrap();
    assert_eq!(contents.parts.len(), 1);
    // Deep nesting is accepted, too.
    let deep = "<x>".repeat(70_000);
    assert!(read_model(&model("", &deep, "")).is_err());
}

/// Files truncated at any byte, or with any byte changed, give a result or an error. Memory use is
/// limited by their size.
#[test]
fn no_bytes_do_harm() {
    let files = [package(&[(MODEL, &plain())]), stored(&[(MODEL, plain().as_bytes())], |_, at| at)];
    for file in &files {
        for length in 0..file.len() {
            assert!(read(&file[..length]).is_err());
        }
        for k in 0..file.len() {
            for mask in [0x01, 0x04, 0x10, 0x80, 0xff] {
                let mut bytes = file.clone();
                bytes[k] ^= mask;
                if let Ok(contents) = read(&bytes) {
                    // The checksum detected the change, or it is not in the text.
                    assert_eq!(corners(&contents), expected());
                }
            }
        }
    }
    // Without a checksum to detect it.
    let text = plain().into_bytes();
    let mut answers = 0;
    for k in 0..text.len() {
        for mask in [0x01, 0x04, 0x10, 0x80] {
            let mut text = text.clone();
            text[k] ^= mask;
            if let Ok(contents) = read(&stored(&[(MODEL, &text)], |_, at| at)) {
                answers += 1;
                assert!(contents.parts.iter().all(|part| part.mesh.coordinates().len() < 8));
            }
        }
    }
    assert!(answers > 100);
}
