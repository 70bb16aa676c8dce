//! OBJ: statements, groups, and broken files.

use polhode_shape::mesh::MeshContents;
use polhode_shape::mesh::obj::read;
use polhode_source::{ContentError, ContentErrorKind as Kind, ContentPlace};

/// Slanted prism: two triangles and three quadrilaterals, one of them with negative indices.
const PRISM: &str = "# a prism
mtllib prism.mtl
v 0.1 -2.5 3.25
v 1.75 .3 1e-1
v -6.5 +4.2 9E-1
vt 0.5 0.5
vn 0 0 1
v 0.6 -2.3 6.75
v 2.25 0.5 3.6
v -6. 4.4 4.4
usemtl red
s off
f 1 3 2
f 4/1 5/1 6/1
f 1//1 2//1 5//1 4//1
f 2/1/1 3/1/1 6/1/1 5/1/1
f -4 -6 -3 -1
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

fn expected(what: &str, found: &str) -> Kind {
    Kind::Expected { what: what.to_owned(), found: found.to_owned() }
}

fn index(index: i64, count: usize) -> Kind {
    Kind::Index { what: "vertex".to_owned(), index, count }
}

#[test]
fn every_form_of_a_face_is_read() {
    let contents = text(PRISM).unwrap();
    let [part] = contents.parts.as_slice() else { panic!("{contents:?}") };
    assert_eq!((contents.encoding, contents.unit, part.name.as_str()), ("text", None, ""));
    assert_eq!(part.mesh.coordinates(), VERTICES);
    assert_eq!(part.mesh.triangles(), TRIANGLES);
    assert!(contents.findings.is_empty());
}

#[test]
fn any_layout_will_do() {
    let plain = text(PRISM).unwrap();
    for other in [
        PRISM.replace('\n', "\r\n"),
        PRISM.replace('\n', "\r"),
        PRISM.replace('\n', " \t\n\n"),
        PRISM.replace('\n', " # f 1 2 9\n"),
        PRISM.replace(' ', "\t  "),
        PRISM.replace("# a prism", "").replace(' ', " \\\n "),
        PRISM.replace("# a prism", "").replace(' ', " \\\r\n"),
        format!("\u{feff}{PRISM}"),
        PRISM.replace("\nf ", "\n  f "),
        PRISM
            .replace(".75\n", ".75 1\n")
            .replace("3.25\n", "3.25 0.2 0.4 0.9\n")
            .replace("4.4\n", "4.4 1 0 0 1\n"),
        PRISM.trim_end().to_owned(),
        PRISM.replace("# a prism", "# C:\\meshes\\"),
    ] {
        assert_eq!(text(&other).as_ref(), Ok(&plain), "{other}");
    }
}

#[test]
fn groups_are_parts_with_their_own_vertices() {
    let body = "v 0 0 0.5\nv 1 0.1 0\nv 0.2 1 0\nv 0.3 0.4 1\nv 7 7.5 7\nv 6 5 4.5\n";
    let contents = text(&format!(
        "{body}f 1 2 3\no left wing\nf 6 5 4\ng  spar and skin # not here\nf 2 5 3\ng\nf 1 5 6\ng spar and skin\nf 4 5 3\n\
         o empty\ng\no left wing\nf 1 2 5\no tail\ng tail\nf 1 4 6"
    ))
    .unwrap();
    let parts: Vec<_> =
        contents.parts.iter().map(|p| (p.name.as_str(), p.mesh.triangles().to_vec())).collect();
    assert_eq!(
        parts,
        [
            ("", vec![[0, 1, 2]]),
            ("left wing", vec![[4, 3, 2], [0, 3, 4], [0, 1, 3]]),
            ("left wing/spar and skin", vec![[0, 3, 1], [2, 3, 1]]),
            ("tail", vec![[0, 1, 2]]),
        ]
    );
    let spar = contents.parts[2].mesh.coordinates();
    assert_eq!(spar, [[1.0, 0.1, 0.0], [0.2, 1.0, 0.0], [0.3, 0.4, 1.0], [7.0, 7.5, 7.0]]);
}

#[test]
fn lines_and_points_are_counted() {
    let contents = text(&format!("{PRISM}l 1 2 3\np 1\nl 2 \\\n 4\n")).unwrap();
    let [finding] = contents.findings.as_slice() else { panic!("{:?}", contents.findings) };
    assert_eq!(finding.code, "mesh.not_a_surface");
    assert_eq!(finding.message, "lines (2) and points (1) enclose no volume and were ignored");
}

#[test]
fn dented_faces_keep_their_shape() {
    // An L with six corners: a fan from its first corner would leave the polygon.
    let l = "v 0.2 0 1\nv 0 2 1.5\nv 1 2 2\nv 1 1 1.75\nv 3 1 3\nv 3.2 0 2.5\n";
    let contents = text(&format!("{l}f 6 5 4 3 2 1\n")).unwrap();
    let mesh = &contents.parts[0].mesh;
    let areas: Vec<f64> = mesh
        .corners()
        .map(|[a, b, c]| (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]))
        .collect();
    assert_eq!(areas.len(), 4);
    assert!(areas.iter().all(|area| *area > 0.0), "{areas:?}");
    assert!(contents.findings.is_empty());

    let bow = text("v 0 0 0\nv 2 0 0\nv 1 1 0\nv 1 0.5 0\nv 0 0 0\nv 0.5 0 0\nf 1 2 1 2 1 2\n").unwrap();
    assert_eq!(bow.findings[0].code, "mesh.crossed_polygons");
}

#[test]
fn indices_exist_when_they_are_used() {
    let v = "v 0 0 0.5\nv 1 0.1 0\nv 0.2 1 0\n";
    assert_eq!(error(&format!("{v}f 1 2 4\nv 1 1 1")), (index(4, 3), "4"));
    assert_eq!(error(&format!("{v}f 1/7 -4/2 3\n")), (index(-4, 3), "-4/2"));
    assert_eq!(error(&format!("{v}f 0 1 2")), (index(0, 3), "0"));
    assert_eq!(error("f 1 2 3\n"), (index(1, 0), "1"));
    let vast = 99_999_999_999_999_999_999_u128;
    assert_eq!(error(&format!("{v}f 1 2 {vast}")), (index(i64::MAX, 3), "99999999999999999999"));
    assert_eq!(error(&format!("{v}f 1 2 -{vast}")), (index(-i64::MAX, 3), "-99999999999999999999"));
    assert_eq!(error(&format!("{v}f 1 2 4294967297")), (index(4_294_967_297, 3), "4294967297"));
    assert!(text(&format!("{v}f -1 -2 -3")).is_ok());
}

#[test]
fn every_mistake_has_a_place_and_words() {
    let v = "v 0 0 0.5\nv 1 0.1 0\nv 0.2 1 0\n";
    for (text, kind, found) in [
        ("v 1 2\n", expected("a number", "the end of the line"), ""),
        ("v 1 2", expected("a number", ""), ""),
        ("v 1 2,5 3", expected("a number", "2,5"), "2,5"),
        ("v 1 2 3 red", expected("a number", "red"), "red"),
        ("v 1 2 3 1 1 1 1 1 1\n", expected("the end of the line", "1"), "1"),
        ("v 1 0x10 3", expected("a number", "0x10"), "0x10"),
        ("vertex 1 2 3", expected("a statement of OBJ", "vertex"), "vertex"),
        ("ply\nformat", expected("a statement of OBJ", "ply"), "ply"),
        ("F 1 2 3", expected("a statement of OBJ", "F"), "F"),
    ] {
        assert_eq!(error(text), (kind, found), "{text}");
    }
    let face = |f: &str| {
        let text = format!("{v}{f}");
        let (kind, found) = error(&text);
        (kind, found.to_owned())
    };
    let index = "the index of a vertex";
    for (f, what, found) in [
        ("f 1 2\nf 1 2 3", "a third corner of the face", "the end of the line"),
        ("f\n#", "a third corner of the face", "the end of the line"),
        ("f 1 2 x", index, "x"),
        ("f 1 2 3/1/1/1", index, "3/1/1/1"),
        ("f 1 2 3.0", index, "3.0"),
        ("f 1 2 /3", index, "/3"),
        ("f 1 2 3/x", index, "3/x"),
    ] {
        assert_eq!(face(f).0, expected(what, found), "{f}");
    }
    for (written, found) in [("nan", "nan"), ("-inf", "-inf"), ("1e999", "1e999"), ("Infinity", "Infinity")] {
        let kind = Kind::NotFinite { what: "the coordinate".to_owned(), found: found.to_owned() };
        assert_eq!(error(&format!("v 1 {written} 3\nf 1 1 1")).0, kind);
    }
    let hint = |text: &str| read(text.as_bytes()).unwrap_err().hint.unwrap();
    assert_eq!(hint("v 1,5 2 3"), "use a decimal point");
    assert_eq!(hint("v 1 2 3\nf 1 2 3"), "a face must come after its vertices");
}

#[test]
fn curved_surfaces_are_refused_by_name() {
    for word in ["cstype", "curv", "curv2", "surf", "parm", "bzp", "call"] {
        let text = format!("{PRISM}{word} bspline\n");
        let (kind, found) = error(&text);
        assert!(matches!(&kind, Kind::Unsupported { what } if what.contains(word)), "{kind:?}");
        assert_eq!(found, word);
    }
}

#[test]
fn nothing_to_read_is_said() {
    for (nothing, what) in
        [("", "vertices and no faces"), ("# v 1 2 3", "vertices and no faces"), ("v 1 2 3\nl 1 1\n", "faces")]
    {
        let error = text(nothing).unwrap_err();
        assert_eq!((error.kind, error.place), (Kind::Missing { what: what.to_owned() }, ContentPlace::Whole));
    }
}

#[test]
fn no_bytes_make_it_panic() {
    let bytes = PRISM.as_bytes();
    for end in 0..bytes.len() {
        // A file truncated at a line end may be complete; one truncated in the first vertices is
        // not.
        let cut = read(&bytes[..end]);
        assert!(end > PRISM.find("f 1 3 2").unwrap() || cut.is_err(), "{end}");
    }
    for at in 0..bytes.len() {
        for flip in 1..=255 {
            let mut bytes = bytes.to_vec();
            bytes[at] ^= flip;
            match read(&bytes) {
                Ok(contents) => assert!(!contents.parts.is_empty()),
                Err(error) => assert!(!error.to_string().is_empty()),
            }
        }
    }
}

#[test]
fn a_vast_dented_face_is_split_without_overlaps() {
    // A comb with 10000 teeth: every second corner is reflex.
    let n = 20_000;
    let mut text = String::from("v -3 0 0.5\nv 20003 -0.25 0.5\n");
    for k in (0..n).rev() {
        text += &format!("v {k} {} 0.5\n", if k % 2 == 0 { 9.5 } else { 1.5 });
    }
    text += "f";
    for k in 1..=n + 2 {
        text += &format!(" {k}");
    }
    let contents = read(text.as_bytes()).unwrap();
    assert_eq!(contents.parts[0].mesh.triangles().len(), n);
    assert!(contents.findings.is_empty(), "{:?}", contents.findings);
}

#[test]
fn an_index_of_twenty_digits_is_not_told_as_another_number() {
    let corner = "v 0 0 0\nv 2 0 0\nv 0 3 0\nv 0 0 5\nf 1 3 2\nf 1 2 4\nf 1 4 3\n";
    for index in ["12345678901234567890", "-12345678901234567890", "18446744073709551620"] {
        let text = format!("{corner}f 2 3 {index}\n");
        let error = read(text.as_bytes()).unwrap_err();
        let ContentPlace::Text(span) = error.place.clone() else { panic!("{error}") };
        assert!(!error.to_string().contains("9223372036854775807"), "{error}");
        assert_eq!(&text[span], index, "{error}");
    }
    let zeros = format!("{corner}f 2 3 00000000000000000000004\n");
    assert!(read(zeros.as_bytes()).is_ok());
}
