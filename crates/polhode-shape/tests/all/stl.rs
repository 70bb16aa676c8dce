//! STL: both encodings, their distinction, and broken files.

use polhode_shape::mesh::stl::{Stl, StlError, StlKind, StlPlace, read};

const WEDGE: [[[f32; 3]; 3]; 3] = [
    [[0.1, 2.5, -3.25], [1.75, 0.3, 1e-7], [-6.5, 4.2, 0.9]],
    [[7.5, -0.2, 3e8], [2.25, 1.1, -5.0], [0.7, 0.01, 8.5]],
    [[-1.5, 9.75, 0.6], [3.3, -7.2, 4.4], [5.5, 6.6, -0.125]],
];

const TEXT: &str = "solid wedge of cheese
  facet normal 0 0 1
    outer loop
      vertex 0.1 2.5 -3.25
      vertex 1.75 .3 1e-7
      vertex -6.5 +4.2 9E-1
    endloop
  endfacet
  facet normal nan nan nan
    outer loop
      vertex 7.5 -0.2 3e8
      vertex 2.25 1.1 -5
      vertex 0.7 0.01 8.5
    endloop
  endfacet
endsolid wedge of cheese
";

fn to_binary(header: &str, triangles: &[[[f32; 3]; 3]]) -> Vec<u8> {
    let mut bytes = header.as_bytes().to_vec();
    bytes.resize(80, 0);
    bytes.extend((triangles.len() as u32).to_le_bytes());
    for (i, triangle) in triangles.iter().enumerate() {
        bytes.extend([f32::NAN.to_le_bytes(); 3].as_flattened()); // the normal, which is not read
        bytes.extend(triangle.as_flattened().iter().flat_map(|c| c.to_le_bytes()));
        bytes.extend((i as u16 + 77).to_le_bytes());
    }
    bytes
}

fn read_text(text: &str) -> Result<Stl, StlError> {
    read(text.as_bytes())
}

fn syntax(line: usize, column: usize, expected: &'static str, found: &str) -> StlError {
    StlError::Syntax { at: StlPlace::Text { line, column }, expected, found: found.to_owned() }
}

#[test]
fn binary_is_read_as_it_was_written() {
    for header in ["wedge", "solid wedge"] {
        let stl = read(&to_binary(header, &WEDGE)).unwrap();
        let triangles = WEDGE.map(|t| t.map(|v| v.map(f64::from))).to_vec();
        assert_eq!(stl, Stl { kind: StlKind::Binary, name: header.to_owned(), solids: 1, triangles });
    }
}

#[test]
fn ascii_is_read_in_double_precision() {
    let stl = read(TEXT.as_bytes()).unwrap();
    assert_eq!((stl.kind, stl.solids, stl.name.as_str()), (StlKind::Ascii, 1, "wedge of cheese"));
    assert_eq!(
        stl.triangles,
        [
            [[0.1, 2.5, -3.25], [1.75, 0.3, 1e-7], [-6.5, 4.2, 0.9]],
            [[7.5, -0.2, 3e8], [2.25, 1.1, -5.0], [0.7, 0.01, 8.5]],
        ]
    );
    assert_ne!(stl.triangles[0][0][0], f64::from(0.1_f32));
}

#[test]
fn ascii_is_read_in_any_layout() {
    let expected = read(TEXT.as_bytes()).unwrap().triangles;
    let first_line_break = TEXT.find('\n').unwrap();
    let one_line = TEXT[first_line_break + 1..TEXT.find("endsolid").unwrap()].replace('\n', "\t");
    for text in [
        TEXT.replace('\n', "\r\n"),
        TEXT.replace('\n', "\r"),
        TEXT.to_uppercase(),
        TEXT.replace(' ', "\t"),
        TEXT.replace("wedge of cheese", ""),
        TEXT.replace("endsolid", "end solid").replace("endloop", "end loop").replace("endfacet", "End Facet"),
        format!(" \r\n\t{TEXT}\n\n  "),
        format!("\u{feff}{TEXT}"),
        format!("solid\n{one_line} endsolid"),
        TEXT.trim_end().to_owned(),
    ] {
        assert_eq!(read(text.as_bytes()).unwrap().triangles, expected, "{text}");
    }
}

#[test]
fn solids_are_joined_and_the_first_names_them() {
    let stl = read(format!("solid\nendsolid\n{TEXT}{TEXT}").as_bytes()).unwrap();
    assert_eq!((stl.solids, stl.triangles.len(), stl.name.as_str()), (3, 4, ""));
    assert_eq!(stl.triangles[..2], stl.triangles[2..]);
}

#[test]
fn a_name_need_not_be_utf8() {
    let bytes = [b"solid K\xe4se\n", &TEXT.as_bytes()[TEXT.find('\n').unwrap()..]].concat();
    assert_eq!(read(&bytes).unwrap().name, "K\u{fffd}se");
    let mut bytes = to_binary("", &WEDGE);
    bytes[..5].copy_from_slice(b"K\xe4se ");
    assert_eq!(read(&bytes).unwrap().name, "K\u{fffd}se");
}

#[test]
fn a_binary_count_must_fit_the_bytes() {
    let whole = to_binary("solid wedge", &WEDGE);
    for (length, present, left) in [(84, 0, 0), (133, 0, 49), (184, 2, 0), (233, 2, 49)] {
        let error = read(&whole[..length]).unwrap_err();
        assert_eq!(error, StlError::WrongCount { declared: 3, length });
        let told = format!("declares 3 triangles, but {present} complete ones and {left} bytes follow");
        assert!(error.to_string().contains(&told), "{error}");
        assert!(error.hint().unwrap().contains("truncated"));
    }
    let error = read(&[&whole[..], b"x"].concat()).unwrap_err();
    assert_eq!(error, StlError::WrongCount { declared: 3, length: 235 });
    assert!(error.hint().unwrap().contains("after the last triangle"));

    let mut huge = whole.clone();
    huge[80..84].fill(0xff);
    assert_eq!(read(&huge), Err(StlError::WrongCount { declared: u32::MAX, length: 234 }));
}

#[test]
fn bytes_that_are_no_stl_are_refused() {
    for bytes in [&b""[..], b" \n ", b"ply\nformat ascii 1.0\n", b"solidus", &[0; 83]] {
        assert_eq!(read(bytes), Err(StlError::Unrecognized { length: bytes.len() }));
    }
}

#[test]
fn a_mesh_has_a_triangle() {
    assert_eq!(read(&to_binary("nothing", &[])), Err(StlError::NoTriangles));
    assert_eq!(read_text("solid nothing\nendsolid nothing\n"), Err(StlError::NoTriangles));
}

#[test]
fn a_syntax_error_tells_its_place() {
    let facet = &TEXT[TEXT.find("  facet").unwrap()..TEXT.find("  facet normal nan").unwrap()];
    for (text, error) in [
        ("solid".to_owned(), syntax(1, 6, "facet or endsolid", "")),
        (format!("solid a\n{facet}\n"), syntax(8, 11, "facet or endsolid", "")),
        (TEXT.replacen("1.75", "1,75", 1), syntax(5, 14, "a number", "1,75")),
        (TEXT.replacen("1.75 ", "", 1), syntax(6, 7, "a number", "vertex")),
        (TEXT.replacen("1.75", "1.75 0", 1), syntax(5, 24, "vertex", "1e-7")),
        (TEXT.replacen("1.75", "１.75", 1), syntax(5, 14, "a number", "１.75")),
        (TEXT.replacen("outer", "other", 1), syntax(3, 5, "outer", "other")),
        (TEXT.replacen("normal", "", 1), syntax(2, 10, "normal", "0")),
        (TEXT.replacen("loop", "lop", 1), syntax(3, 11, "loop", "lop")),
        (TEXT.replacen("endloop", "vertex 1 2 3", 1), syntax(7, 5, "endloop", "vertex")),
        (TEXT.replacen("endfacet", "end\tsolid", 1), syntax(8, 3, "endfacet", "end")),
        (TEXT.replacen("endsolid", "color", 1), syntax(16, 1, "facet or endsolid", "color")),
        (TEXT.replace("\n", "\r\n").replacen("8.5", "8.5.", 1), syntax(13, 23, "a number", "8.5.")),
        (TEXT.replace("\n", "\r").replacen("8.5", "8.5.", 1), syntax(13, 23, "a number", "8.5.")),
        (format!("{TEXT}\n v 1 2 3"), syntax(18, 2, "solid", "v")),
        (TEXT.replacen("8.5", &"8".repeat(999_999).replacen('8', "x", 1), 1), {
            syntax(13, 23, "a number", &format!("x{}", "8".repeat(39)))
        }),
    ] {
        assert_eq!(read_text(&text), Err(error));
    }
    let hint = |from, to| read_text(&TEXT.replacen(from, to, 1)).unwrap_err().hint().unwrap();
    assert!(hint("1.75", "1,75").contains("point"));
    assert!(hint("endloop", "VERTEX 1 2 3").contains("triangulate"));
    let cut = &TEXT[..TEXT.find(" -3.25").unwrap()];
    assert!(read_text(cut).unwrap_err().hint().unwrap().contains("truncated"));
    assert_eq!(
        read_text(&TEXT.replacen("outer", "other", 1)).unwrap_err().to_string(),
        "line 3, column 5: expected outer, found \"other\""
    );
}

#[test]
fn a_coordinate_is_finite() {
    for found in ["nan", "-inf", "1e400"] {
        let error = read_text(&TEXT.replacen("0.01", found, 1)).unwrap_err();
        let at = StlPlace::Text { line: 13, column: 18 };
        assert_eq!(error, StlError::NotFinite { at, found: found.to_owned() });
    }
    for (value, found) in [(f32::NAN, "NaN"), (f32::NEG_INFINITY, "-inf")] {
        let mut wedge = WEDGE;
        wedge[1][2][1] = value;
        let error = read(&to_binary("wedge", &wedge)).unwrap_err();
        let at = StlPlace::Record { index: 1, offset: 84 + 50 + 12 + 28 };
        assert_eq!(error, StlError::NotFinite { at, found: found.to_owned() });
        assert!(error.to_string().starts_with("triangle 1 (counted from 0), byte 174: the coordinate"));
    }
}

#[test]
fn no_truncation_and_no_flipped_byte_panics() {
    let mut state = 5_u64;
    let mut below = |n: usize| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((u128::from(state) * n as u128) >> 64) as usize
    };
    for whole in [to_binary("wedge", &WEDGE), TEXT.as_bytes().to_vec()] {
        assert!((0..whole.len() - 30).all(|length| read(&whole[..length]).is_err()));
        let mut read_on = 0;
        for _ in 0..30_000 {
            let mut bytes = whole.clone();
            for _ in 0..=below(3) {
                let at = below(bytes.len());
                bytes[at] = below(256) as u8;
            }
            bytes.truncate(whole.len() - below(2) * below(whole.len()));
            match read(&bytes) {
                Ok(stl) => {
                    read_on += 1;
                    assert!(stl.triangles.as_flattened().as_flattened().iter().all(|c| c.is_finite()));
                }
                Err(error) => assert!(!error.to_string().is_empty() && error.hint() != Some("")),
            }
        }
        assert!(read_on > 500, "{read_on}");
    }
}
