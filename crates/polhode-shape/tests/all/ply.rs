//! PLY: encodings, types and elements, and broken files.

use polhode_shape::mesh::ply::read;
use polhode_source::{ContentErrorKind as Kind, ContentPlace};

const VERTICES: [[f32; 3]; 6] = [
    [0.1, -2.5, 3.25],
    [1.75, 0.3, 0.1],
    [-6.5, 4.2, 0.9],
    [0.6, -2.3, 6.75],
    [2.25, 0.5, 3.6],
    [-6.0, 4.4, 4.4],
];

const FACES: [&[u32]; 5] = [&[0, 2, 1], &[3, 4, 5], &[0, 1, 4, 3], &[1, 2, 5, 4], &[2, 0, 3, 5]];

const TRIANGLES: [[u32; 3]; 8] =
    [[0, 2, 1], [3, 4, 5], [0, 1, 4], [0, 4, 3], [1, 2, 5], [1, 5, 4], [2, 0, 3], [2, 3, 5]];

const ASCII: &str = "ply
format ascii 1.0
comment a slanted prism
obj_info by hand
element vertex 6
property float x
property float y
property float z
element face 5
property list uchar int vertex_indices
end_header
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

/// Writer for values of any type, in either byte order.
struct Writer {
    bytes: Vec<u8>,
    is_big: bool,
}

impl Writer {
    fn new(header: &str, is_big: bool) -> Self {
        let format = if is_big { "binary_big_endian" } else { "binary_little_endian" };
        Self { bytes: header.replace("FORMAT", format).into_bytes(), is_big }
    }

    fn put<const N: usize>(&mut self, little: [u8; N]) {
        let mut bytes = little;
        if self.is_big {
            bytes.reverse();
        }
        self.bytes.extend(bytes);
    }

    fn value(&mut self, kind: &str, value: f64) {
        match kind {
            "char" | "int8" => self.put((value as i8).to_le_bytes()),
            "uchar" | "uint8" => self.put((value as u8).to_le_bytes()),
            "short" | "int16" => self.put((value as i16).to_le_bytes()),
            "ushort" | "uint16" => self.put((value as u16).to_le_bytes()),
            "int" | "int32" => self.put((value as i32).to_le_bytes()),
            "uint" | "uint32" => self.put((value as u32).to_le_bytes()),
            "float" | "float32" => self.put((value as f32).to_le_bytes()),
            "double" | "float64" => self.put(value.to_le_bytes()),
            _ => panic!("{kind}"),
        }
    }
}

/// Returns the prism in binary: single precision, with the given types for the corners of its
/// faces.
fn binary(is_big: bool, length: &str, index: &str) -> Vec<u8> {
    let header = format!(
        "ply\nformat FORMAT 1.0\nelement vertex 6\nproperty float32 x\nproperty float y\nproperty float z\n\
         element face 5\nproperty list {length} {index} vertex_indices\nend_header\n"
    );
    let mut writer = Writer::new(&header, is_big);
    for coordinate in VERTICES.as_flattened() {
        writer.value("float", f64::from(*coordinate));
    }
    for face in FACES {
        writer.value(length, face.len() as f64);
        face.iter().for_each(|corner| writer.value(index, f64::from(*corner)));
    }
    writer.bytes
}

/// Returns the error for a text, and the bytes at its place.
fn error(text: &str) -> (Kind, &str) {
    let error = read(text.as_bytes()).unwrap_err();
    match error.place {
        ContentPlace::Text(span) => (error.kind, &text[span]),
        ContentPlace::Whole => (error.kind, "whole"),
        place => panic!("{place:?}"),
    }
}

fn count(what: &str, declared: u64, present: u64) -> Kind {
    Kind::Count { what: what.to_owned(), declared, present }
}

#[test]
fn ascii_is_read_in_double_precision() {
    let contents = read(ASCII.as_bytes()).unwrap();
    let [part] = contents.parts.as_slice() else { panic!("{contents:?}") };
    assert_eq!((contents.encoding, contents.unit, contents.findings.len()), ("ascii", None, 0));
    assert_eq!(part.mesh.coordinates()[..3], [[0.1, -2.5, 3.25], [1.75, 0.3, 0.1], [-6.5, 4.2, 0.9]]);
    assert_eq!(part.mesh.triangles(), TRIANGLES);
    for other in [
        ASCII.replace('\n', "\r\n"),
        ASCII.replace('\n', "\r"),
        ASCII.replace("end_header\n", "end_header\n\n \n").replace("\n3", "  3"),
        ASCII.replace("int vertex_indices", "uint32 vertex_index"),
        ASCII.replace("comment a", "comment   end_header\ncomment"),
        ASCII.trim_end().to_owned(),
    ] {
        assert_eq!(read(other.as_bytes()).as_ref(), Ok(&contents), "{other}");
    }
}

#[test]
fn binary_is_read_exactly_in_both_orders_and_all_types() {
    let vertices = VERTICES.map(|v| v.map(f64::from));
    for (is_big, encoding) in [(false, "binary, little-endian"), (true, "binary, big-endian")] {
        for length in ["char", "uchar", "short", "ushort", "int", "uint", "int8", "uint16"] {
            for index in ["int8", "uint8", "int16", "uint16", "int32", "uint32", "char", "ushort"] {
                let contents = read(&binary(is_big, length, index)).unwrap();
                assert_eq!(contents.encoding, encoding);
                assert_eq!(contents.parts[0].mesh.coordinates(), vertices);
                assert_eq!(contents.parts[0].mesh.triangles(), TRIANGLES);
            }
        }
    }
}

/// Header with many features, faces before the vertices, and strips after them.
const RICH: &str = "ply\r\nformat FORMAT 1.0\r\nelement material 2\r\nproperty uchar red\r\n\
    property list ushort float64 shine\r\nelement nothing 18446744073709551615\r\n\
    element face 2\r\nproperty list uchar float uv\r\nproperty list uchar short vertex_indices\r\nproperty int flags\r\n\
    element vertex 5\r\nproperty short z\r\nproperty double nx\r\nproperty char y\r\nproperty list char int links\r\n\
    property double x\r\nelement edge 1\r\nproperty int a\r\nproperty int b\r\n\
    element tristrips 1\r\nproperty list int int vertex_indices\r\nend_header\r\n";

/// Types and values in the order of the header; the type is empty for those of the last line.
const RICH_VALUES: [(&str, &[f64]); 36] = [
    ("uchar", &[200.0]),
    ("ushort", &[2.0]),
    ("double", &[0.25, f64::NAN]),
    ("uchar", &[10.0]),
    ("ushort", &[0.0]),
    ("uchar", &[2.0]),
    ("float", &[0.5, 0.75]),
    ("uchar", &[3.0]),
    ("short", &[0.0, 2.0, 1.0]),
    ("int", &[-7.0]),
    ("uchar", &[0.0]),
    ("uchar", &[4.0]),
    ("short", &[0.0, 1.0, 4.0, 3.0]),
    ("int", &[9.0]),
    ("short", &[300.0]),
    ("double", &[f64::INFINITY]),
    ("char", &[-5.0]),
    ("char", &[1.0]),
    ("int", &[77.0]),
    ("double", &[0.1]),
    ("short", &[-20.0]),
    ("double", &[1.0]),
    ("char", &[17.0, 0.0]),
    ("double", &[0.7]),
    ("short", &[4.0]),
    ("double", &[1.0]),
    ("char", &[3.0, 0.0]),
    ("double", &[-1.3]),
    ("short", &[8.0]),
    ("double", &[1.0]),
    ("char", &[6.0, 0.0]),
    ("double", &[2.9]),
    ("short", &[1.0]),
    ("double", &[1.0]),
    ("char", &[-2.0, 0.0]),
    ("double", &[5.5]),
];

#[test]
fn elements_come_in_any_order_and_most_are_passed_over() {
    let strip = [10.0, 0.0, 1.0, 2.0, 3.0, 3.0, 4.0, -1.0, 4.0, 2.0, 1.0];
    let mut files = Vec::new();
    for is_big in [false, true] {
        let mut writer = Writer::new(RICH, is_big);
        for (kind, values) in RICH_VALUES {
            values.iter().for_each(|value| writer.value(kind, *value));
        }
        [1.0, 2.0].iter().chain(&strip).for_each(|value| writer.value("int", *value));
        files.push(writer.bytes);
    }
    let mut text = RICH.replace("FORMAT", "ascii");
    for (_, values) in RICH_VALUES {
        values.iter().for_each(|value| text += &format!("{value}\r\n"));
    }
    [1.0, 2.0].iter().chain(&strip).for_each(|value| text += &format!("{value} "));
    files.push(text.into_bytes());
    for file in files {
        let contents = read(&file).unwrap();
        let mesh = &contents.parts[0].mesh;
        assert_eq!(
            mesh.coordinates(),
            [[0.1, -5.0, 300.0], [0.7, 17.0, -20.0], [-1.3, 3.0, 4.0], [2.9, 6.0, 8.0], [5.5, -2.0, 1.0]]
        );
        // The quadrilateral is not convex.
        let faces = [[0, 2, 1], [1, 4, 3], [3, 0, 1]];
        let strips = [[0, 1, 2], [2, 1, 3], [4, 2, 1]];
        assert_eq!(mesh.triangles(), [faces, strips].concat());
        assert_eq!(contents.findings[0].code, "mesh.not_a_surface");
        assert_eq!(contents.findings[0].message, "edges (1) enclose no volume and were ignored");
    }
}

#[test]
fn headers_are_checked() {
    let expected =
        |what: &str, found: &str| Kind::Expected { what: what.to_owned(), found: found.to_owned() };
    for (right, wrong, kind, found) in [
        ("ply\n", "PLY\n", expected("\"ply\"", "PLY"), "PLY"),
        (
            "ascii 1.0",
            "text 1.0",
            expected("ascii, binary_little_endian or binary_big_endian", "text"),
            "text",
        ),
        ("ascii 1.0", "ascii 2.0", expected("the version 1.0", "2.0"), "2.0"),
        ("vertex 6", "vertex six", expected("the count of the element", "six"), "six"),
        ("vertex 6", "vertex -6", expected("the count of the element", "-6"), "-6"),
        ("vertex 6", "vertex", expected("the count of the element", ""), ""),
        (
            "float x",
            "real x",
            expected("char, uchar, short, ushort, int, uint, float, double or list", "real"),
            "real",
        ),
        (
            "list uchar int",
            "list float int",
            expected("an integer type for the length of a list", "float"),
            "float",
        ),
        (
            "obj_info",
            "info",
            expected("format, comment, obj_info, element, property or end_header", "info"),
            "info",
        ),
        (
            "float y",
            "float x",
            Kind::Value { what: "the property".into(), value: "x".into(), rule: "declared once".into() },
            "x",
        ),
        ("float y", "float w", Kind::Missing { what: "property y of the element vertex".into() }, "6"),
        (
            "vertex_indices",
            "corners",
            Kind::Missing { what: "property vertex_indices of the element face".into() },
            "5",
        ),
        ("element vertex 6", "element point 6", Kind::Missing { what: "element vertex".into() }, "whole"),
        (
            "float z",
            "list int float z",
            Kind::Value {
                what: "property z of the element vertex".into(),
                value: "a list of floating-point type".into(),
                rule: "a number".into(),
            },
            "z",
        ),
        (
            "uchar int vertex_indices",
            "uchar float vertex_indices",
            Kind::Value {
                what: "property vertex_indices of the element face".into(),
                value: "a list of floating-point type".into(),
                rule: "a list of integers".into(),
            },
            "vertex_indices",
        ),
    ] {
        let text = ASCII.replace(right, wrong);
        // A missing count is reported at the end of its line.
        let (got, at) = error(&text);
        match got {
            Kind::Expected { what, .. } if found.is_empty() => {
                assert!(matches!(kind, Kind::Expected { what: w, .. } if w == what));
            }
            got => assert_eq!((got, at), (kind, found), "{wrong}"),
        }
    }
    assert!(
        matches!(error("ply\nproperty float x\n").0, Kind::Expected { what, .. } if what == "an element before its properties")
    );
    assert!(
        matches!(error("ply\nelement vertex 6\n").0, Kind::Expected { what, .. } if what == "end_header")
    );
    assert!(matches!(error("ply\nend_header\n").0, Kind::Missing { what } if what.starts_with("format")));
}

#[test]
fn counts_are_not_believed() {
    // A list that trusted these counts would exhaust the memory.
    let vast = "18446744073709551615";
    let all = ASCII.replace("vertex 6", &format!("vertex {vast}"));
    assert_eq!(error(&all).0, count("vertices", u64::MAX, 6 + (4 + 4 + 5 + 5 + 5) / 3));
    assert_eq!(error(&ASCII.replace("face 5", &format!("face {vast}"))), (count("faces", u64::MAX, 5), ""));
    assert_eq!(
        error(&ASCII.replace("\n4 2 0 3 5", "\n4000000000 2 0 3 5")),
        (count("corners", 4_000_000_000, 4), "")
    );
    let text = ASCII.replace("\n4 2 0 3 5", "\n-4 2 0 3 5");
    let (what, value, rule) = ("the length of a list".into(), "-4".into(), "0 or more".into());
    assert_eq!(error(&text), (Kind::Value { what, value, rule }, "-4"));
    let text = ASCII.replace("\n4 2 0 3 5", "\n2 2 0");
    let (what, value, rule) = ("the number of a face's corners".into(), "2".into(), "3 or more".into());
    assert_eq!(error(&text), (Kind::Value { what, value, rule }, "2"));
    let text = ASCII.replace("face 5", "face 4");
    assert_eq!(error(&text), (count("bytes after the last element", 0, 9), "4"));

    for is_big in [false, true] {
        let mut bytes = binary(is_big, "uint", "uint");
        let last = bytes.len() - 20;
        bytes[last..last + 4].fill(0xff);
        let error = read(&bytes).unwrap_err();
        assert_eq!(error.kind, count("corners", u64::from(u32::MAX), 4));
        assert_eq!(error.place, ContentPlace::Byte { offset: bytes.len() as u64, what: "face 4".to_owned() });
        bytes.truncate(last);
        bytes.push(7);
        assert_eq!(read(&bytes).unwrap_err().kind, count("faces", 5, 4));
    }
    let mut bytes = binary(false, "uchar", "int");
    bytes.extend([1, 2, 3]);
    assert_eq!(read(&bytes).unwrap_err().kind, count("bytes after the last element", 0, 3));
    // An unused list of 2^31 − 1 doubles.
    let header = "ply\nformat FORMAT 1.0\nelement vertex 9\nproperty double x\nproperty double y\n\
                  property list int double w\nproperty double z\nend_header\n";
    let mut writer = Writer::new(header, true);
    writer.value("double", 1.5);
    writer.value("double", 2.5);
    writer.value("int", f64::from(i32::MAX));
    let error = read(&writer.bytes).unwrap_err();
    assert_eq!(error.kind, count("vertices", 9, 0));
    assert!(matches!(error.place, ContentPlace::Byte { what, .. } if what == "vertex 0"));
}

#[test]
fn vertices_exist_and_are_finite() {
    let index = |index: i64| Kind::Index { what: "vertex".to_owned(), index, count: 6 };
    assert_eq!(error(&ASCII.replace("1 2 5 4", "1 2 6 4")), (index(6), "6"));
    assert_eq!(error(&ASCII.replace("1 2 5 4", "1 -1 5 4")), (index(-1), "-1"));
    assert_eq!(
        error(&ASCII.replace("0.5 3.6", "0.5 nan")),
        (Kind::NotFinite { what: "the coordinate".into(), found: "nan".into() }, "nan")
    );
    assert!(matches!(error(&ASCII.replace("0.5 3.6", "0.5 3,6")), (Kind::Expected { .. }, "3,6")));
    assert!(matches!(error(&ASCII.replace("1 2 5 4", "1 2 5. 4")), (Kind::Expected { .. }, "5.")));

    for is_big in [false, true] {
        let bytes = binary(is_big, "uchar", "int");
        // Vertices, two triangles, three quadrilaterals.
        let start = bytes.len() - 72 - 2 * 13 - 3 * 17;
        for (value, found) in [(f32::NAN, "NaN"), (f32::NEG_INFINITY, "-inf")] {
            let mut bytes = bytes.clone();
            let word = if is_big { value.to_be_bytes() } else { value.to_le_bytes() };
            bytes[start + 28..start + 32].copy_from_slice(&word);
            let error = read(&bytes).unwrap_err();
            assert_eq!(error.kind, Kind::NotFinite { what: "the coordinate y".into(), found: found.into() });
            assert_eq!(
                error.place,
                ContentPlace::Byte { offset: start as u64 + 28, what: "vertex 2".to_owned() }
            );
        }
        let mut bytes = bytes.clone();
        let at = start + 72 + 13 + 1;
        bytes[at..at + 4].copy_from_slice(&if is_big {
            1000_i32.to_be_bytes()
        } else {
            1000_i32.to_le_bytes()
        });
        let error = read(&bytes).unwrap_err();
        assert_eq!(error.kind, index(1000));
        assert_eq!(error.place, ContentPlace::Byte { offset: at as u64, what: "face 1".to_owned() });
    }
}

#[test]
fn no_bytes_make_it_panic() {
    let rich = {
        let mut writer = Writer::new(RICH, false);
        for (kind, values) in RICH_VALUES {
            values.iter().for_each(|value| writer.value(kind, *value));
        }
        [1.0, 2.0, 3.0, 0.0, 1.0, 2.0].iter().for_each(|value| writer.value("int", *value));
        writer.bytes
    };
    for bytes in [ASCII.as_bytes().to_vec(), binary(true, "int", "short"), rich] {
        assert!(read(&bytes).is_ok());
        for end in 0..bytes.trim_ascii_end().len() {
            let error = match read(&bytes[..end]) {
                // A text without its last digit would be another number.
                Ok(_) => panic!("{end}"),
                Err(error) => error,
            };
            assert!(!error.to_string().is_empty());
        }
        for at in 0..bytes.len() {
            // Flip each bit, and all bits.
            for flip in [1, 2, 4, 8, 16, 32, 64, 128, 255] {
                let mut bytes = bytes.clone();
                bytes[at] ^= flip;
                match read(&bytes) {
                    Ok(contents) => assert!(!contents.parts.is_empty()),
                    Err(error) => assert!(!error.to_string().is_empty()),
                }
            }
        }
    }
}

#[test]
fn a_cloud_of_points_is_no_solid() {
    let cloud = "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n\
                 element face 0\nproperty list uchar int corners\nend_header\n0.5 1 2\n";
    let error = read(cloud.as_bytes()).unwrap_err();
    assert_eq!((error.kind, error.place), (Kind::Missing { what: "faces".to_owned() }, ContentPlace::Whole));
}

/// A header line that would exhaust the memory is refused before it is parsed.
#[test]
fn a_line_of_the_header_has_a_limit() {
    let comment = |length: usize| ASCII.replace("a slanted prism", &"x".repeat(length));
    assert!(read(comment((1 << 16) - "comment ".len()).as_bytes()).is_ok());
    let error = read(comment(1 << 16).as_bytes()).unwrap_err();
    assert_eq!(error.kind.to_string(), "polhode does not read a line of the header of more than 65536 bytes");
    assert_eq!(error.place, ContentPlace::Text(21..22));
    let mut first = vec![b' '; 1 << 26];
    first[..3].copy_from_slice(b"ply");
    assert!(read(&first).is_err());
}
