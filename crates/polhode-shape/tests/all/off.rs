//! OFF: headers, counts, and broken files; and one solid in three formats.

use polhode_shape::mesh::off::read;
use polhode_shape::mesh::{MeshContents, obj, ply};
use polhode_source::{ContentError, ContentErrorKind as Kind, ContentPlace};

/// Slanted prism: two triangles and three quadrilaterals.
const PRISM: &str = "OFF
6 5 9
0.1 -2.5 3.25
1.75 .3 1e-1
-6.5 +4.2 9E-1
0.6 -2.3 6.75
2.25 0.5 3.6
-6. 4.4 4.4
3 0 2 1
3 3 4 5
4 0 1 4 3
4 1 2 5 4
4 2 0 3 5
";

const VERTICES: [[f64; 3]; 6] = [
    [0.1, -2.5, 3.25],
    [1.75, 0.3, 0.1],
    [-6.5, 4.2, 0.9],
    [0.6, -2.3, 6.75],
    [2.25, 0.5, 3.6],
    [-6.0, 4.4, 4.4],
];

const TRIANGLES: [[u32; 3]; 8] =
    [[0, 2, 1], [3, 4, 5], [0, 1, 4], [0, 4, 3], [1, 2, 5], [1, 5, 4], [2, 0, 3], [2, 3, 5]];

fn text(text: &str) -> Result<MeshContents, ContentError> {
    read(text.as_bytes())
}

/// Returns the error for a text, and the bytes at its place.
fn error(text: &str) -> (Kind, &str) {
    let error = read(text.as_bytes()).unwrap_err();
    match error.place {
        ContentPlace::Text(span) => (error.kind, &text[span]),
        place => panic!("{place:?}"),
    }
}

#[test]
fn vertices_and_faces_are_read() {
    let contents = text(PRISM).unwrap();
    let [part] = contents.parts.as_slice() else { panic!("{contents:?}") };
    assert_eq!((part.mesh.coordinates(), part.mesh.triangles()), (VERTICES.as_slice(), TRIANGLES.as_slice()));
    assert!(contents.findings.is_empty() && contents.unit.is_none());
}

#[test]
fn any_layout_will_do() {
    let plain = text(PRISM).unwrap();
    for other in [
        PRISM.replace("OFF\n6", "OFF 6"),
        PRISM.replace("OFF\n6", "OFF6"),
        PRISM.replace("OFF\n6", "# made by hand\n\nOFF # text\n# counts:\n 6"),
        PRISM.replace("6 5 9", "6\n5 # faces\n0"),
        PRISM.replace('\n', "\r\n"),
        PRISM.replace('\n', "\r"),
        PRISM.replace('\n', " # 3 0 1 2\n\n"),
        PRISM.replace(' ', " \t"),
        PRISM.replace("3 4 5\n", "3 4 5 255 0 128\n").replace("0 3 5\n", "0 3 5 0.2 0.4 0.6 1\n"),
        PRISM.replace("OFF", "COFF").replace("4.4\n", "4.4 255 128 0 255\n"),
        PRISM.replace("OFF", "NOFF").replace("4.4\n", "4.4 0.6 0 0.8\n"),
        PRISM.replace("OFF", "STCNOFF").replace("4.4\n", "4.4 0.6 0 0.8 1 1 0 1 0.5 0.5\n"),
        format!("\u{feff}{}", PRISM.trim_end()),
    ] {
        assert_eq!(text(&other).as_ref(), Ok(&plain), "{other}");
    }
}

#[test]
fn other_forms_are_refused_by_name() {
    for (keyword, what) in [
        ("4OFF", "4OFF, whose vertices have four coordinates"),
        ("STC4OFF", "4OFF, whose vertices have four coordinates"),
        ("nOFF", "nOFF, whose vertices have any number of coordinates"),
        ("4nOFF", "4nOFF, whose vertices have any number of coordinates"),
    ] {
        let text = PRISM.replace("OFF", keyword);
        assert_eq!(error(&text), (Kind::Unsupported { what: what.to_owned() }, keyword));
    }
    for binary in ["OFF BINARY\n\0\0\0\u{4}", "CNOFF  BINARY\n"] {
        assert_eq!(error(binary).0, Kind::Unsupported { what: "binary OFF".to_owned() });
    }
    for other in ["", "ply\n", "6 5 9\n0 0 0", "OFFX\n1 1 1", "XOFF\n", "off\n", "ofF"] {
        assert!(matches!(error(other).0, Kind::Expected { what, .. } if what == "\"OFF\""), "{other}");
    }
}

#[test]
fn counts_are_met() {
    let count =
        |what: &str, declared: u64, present: u64| Kind::Count { what: what.to_owned(), declared, present };
    assert_eq!(error(&PRISM.replace("6 5 9", "6 6 9")), (count("faces", 6, 5), ""));
    assert_eq!(error(&PRISM.replace("6 5 9", "6 4 9")), (count("faces", 4, 5), "4"));
    assert_eq!(error(&PRISM.replace("6 5 9", "6 3 9")).0, count("faces", 3, 5));
    assert_eq!(error(&PRISM.replace("6 5 9", "12 1 9")).0, count("vertices", 12, 11));
    let vast = PRISM.replace("6 5 9", "9223372036854775807 4294967295 0");
    assert_eq!(error(&vast).0, count("vertices", i64::MAX as u64, 11));
    assert_eq!(error(&PRISM.replace("6 5 9", "6 99999999999 9")).0, count("faces", 99_999_999_999, 5));
    let (kind, found) = (
        Kind::Value { what: "the number of faces".into(), value: "-5".into(), rule: "0 or more".into() },
        "-5",
    );
    assert_eq!(error(&PRISM.replace("6 5 9", "6 -5 9")), (kind, found));
    assert!(
        matches!(error(&PRISM.replace("6 5 9", "6 5 9 1")).0, Kind::Expected { what, .. } if what == "the end of the line")
    );
    assert_eq!(text("OFF 0 0 0").unwrap_err().kind, Kind::Missing { what: "faces".to_owned() });
    assert_eq!(text("OFF 1 0 0\n1 2 3").unwrap_err().kind, Kind::Missing { what: "faces".to_owned() });
}

#[test]
fn every_mistake_has_a_place_and_words() {
    let expected =
        |what: &str, found: &str| Kind::Expected { what: what.to_owned(), found: found.to_owned() };
    let index = |index: i64| Kind::Index { what: "vertex".to_owned(), index, count: 6 };
    let corners = |value: &str| {
        let (what, rule) = ("the number of a face's corners".to_owned(), "3 or more".to_owned());
        Kind::Value { what, value: value.to_owned(), rule }
    };
    for (right, wrong, kind, found) in [
        ("0.6 -2.3", "0,6 -2,3", expected("a number", "0,6"), "0,6"),
        ("0.5 3.6", "0.5", expected("a number", "the end of the line"), ""),
        ("3.6", "nan", Kind::NotFinite { what: "the coordinate".into(), found: "nan".into() }, "nan"),
        ("3.6", "1e309", Kind::NotFinite { what: "the coordinate".into(), found: "1e309".into() }, "1e309"),
        ("4 0 1 4 3", "4 0 1 4 6", index(6), "6"),
        ("4 0 1 4 3", "4 0 1 -1 3", index(-1), "-1"),
        ("4 0 1 4 3", "5 0 1 4 3", expected("the index of a vertex", "the end of the line"), ""),
        ("4 0 1 4 3", "4 0 1 4 3.5", expected("the index of a vertex", "3.5"), "3.5"),
        ("4 0 1 4 3", "2 0 1", corners("2"), "2"),
        ("4 0 1 4 3", "-4 0 1", corners("-4"), "-4"),
        ("3 0 2 1", "999999999999999999 0 2 1", expected("the index of a vertex", "the end of the line"), ""),
        ("3 3 4 5", "3 3 4 5 red", expected("a number", "red"), "red"),
    ] {
        assert_eq!(error(&PRISM.replace(right, wrong)), (kind, found), "{wrong}");
    }
}

#[test]
fn no_bytes_make_it_panic() {
    let bytes = PRISM.as_bytes();
    for end in 0..bytes.len() - 2 {
        assert!(read(&bytes[..end]).is_err(), "{end}");
    }
    for at in 0..bytes.len() {
        for flip in 1..=255 {
            let mut bytes = bytes.to_vec();
            bytes[at] ^= flip;
            match read(&bytes) {
                Ok(contents) => assert!(!contents.parts.is_empty()),
                Err(error) => {
                    assert!(!error.to_string().is_empty() && error.place != ContentPlace::Whole, "{error}");
                }
            }
        }
    }
}

#[test]
fn one_solid_in_three_formats_has_the_same_bits() {
    // A tetrahedron whose coordinates need all 17 digits.
    let vertices = [
        [0.1 + 0.2, -1.0 / 3.0, 2e-5 / 7.0],
        [1e3 / 7.0, 5.0 / 11.0, -std::f64::consts::PI],
        [-2.0 / 3.0, 123.456_789 / 0.7, 1e-3 / 3.0],
        [0.7, -0.123_456_789_012_345_67, 97.0 / 1.3],
    ];
    let faces = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];
    let lines: Vec<_> = vertices.iter().map(|[x, y, z]| format!("{x} {y:e} {z:.16e}\n")).collect();
    let indices: String = faces.iter().map(|[a, b, c]| format!("3 {a} {b} {c}\n")).collect();

    let from_one: String =
        faces.iter().map(|f| format!("f {} {} {}\n", f[0] + 1, f[1] + 1, f[2] + 1)).collect();
    let obj_text: String = lines.iter().map(|line| format!("v {line}")).collect();
    let obj = obj::read((obj_text + &from_one).as_bytes()).unwrap();
    let off = text(&format!("OFF 4 4 6\n{}{indices}", lines.concat())).unwrap();
    let header = |format: &str| {
        format!(
            "ply\nformat {format} 1.0\nelement vertex 4\nproperty double x\nproperty double y\nproperty double z\n\
             element face 4\nproperty list uchar uint vertex_index\nend_header\n"
        )
    };
    let ascii = ply::read((header("ascii") + &lines.concat() + &indices).as_bytes()).unwrap();
    let (mut little, mut big) =
        (header("binary_little_endian").into_bytes(), header("binary_big_endian").into_bytes());
    for coordinate in vertices.as_flattened() {
        little.extend(coordinate.to_le_bytes());
        big.extend(coordinate.to_be_bytes());
    }
    for face in faces {
        little.push(3);
        little.extend(face.iter().flat_map(|index: &u32| index.to_le_bytes()));
        big.push(3);
        big.extend(face.iter().flat_map(|index| index.to_be_bytes()));
    }
    let bits = |vertices: &[[f64; 3]]| vertices.iter().map(|v| v.map(f64::to_bits)).collect::<Vec<_>>();
    for contents in [obj, off, ascii, ply::read(&little).unwrap(), ply::read(&big).unwrap()] {
        let mesh = &contents.parts[0].mesh;
        assert_eq!(bits(mesh.coordinates()), bits(&vertices), "{}", contents.encoding);
        assert_eq!(mesh.triangles(), faces);
    }
}
