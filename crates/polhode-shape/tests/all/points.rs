//! Point clouds: one separator in a file, and no column that numbers the points.

use polhode_shape::mesh::points::read;
use polhode_source::{ContentError, ContentErrorKind};

fn points(text: &str) -> Vec<[f64; 3]> {
    read(text.as_bytes()).unwrap().parts[0].mesh.coordinates().to_vec()
}

fn refused(text: &str) -> ContentError {
    read(text.as_bytes()).unwrap_err()
}

const POINTS: [[f64; 3]; 4] = [[0.5, -0.25, 0.75], [1.5, 2.25, 0.5], [1e-3, 3.0, 1.5], [2.5, 0.75, 4.0]];

fn written(between: &str, more: &str) -> String {
    let line = |[x, y, z]: [f64; 3]| format!("{x}{between}{y}{between}{z}{more}\n");
    POINTS.map(line).concat()
}

#[test]
fn each_separator_is_read_and_further_columns_are_named() {
    for between in [" ", "\t", "   ", ",", ", ", ";", " ; "] {
        assert_eq!(points(&written(between, "")), POINTS, "{between:?}");
        let contents = read(written(between, &format!("{between}7")).as_bytes()).unwrap();
        assert_eq!(contents.findings[0].code, "mesh.unread_columns");
    }
    assert_eq!(points(&format!("\u{feff}# scan\n\n{}// end", written(",", ","))), POINTS);
}

#[test]
fn a_comma_beside_another_separator_may_be_a_decimal_comma() {
    for between in [" ", "\t", ";", "; "] {
        let text = written(between, "").replace('.', ",");
        let error = refused(&text);
        assert!(matches!(error.kind, ContentErrorKind::Unclear { .. }), "{error}");
        assert!(error.to_string().contains("is this comma a decimal comma?"), "{error}");
    }
    let mixed = refused("0 0;0\n");
    assert!(mixed.to_string().contains("one kind of separator"), "{mixed}");
    let other = refused("0 0 0\n1,2,3\n");
    assert!(other.to_string().contains("expected blanks between the numbers"), "{other}");
}

#[test]
fn a_column_that_counts_the_points_is_no_coordinate() {
    for first in [0, 1] {
        let numbered = |count: usize, more: &str| -> String {
            let line = |(k, [x, y, z]): (usize, &[f64; 3])| format!("{},{x},{y},{z}{more}\n", k + first);
            POINTS[..count].iter().enumerate().map(line).collect()
        };
        for more in ["", ",9,9"] {
            let error = refused(&numbered(4, more));
            assert!(
                error.to_string().contains("is the first column the index of the point, or x?"),
                "{error}"
            );
        }
    }
    // Points along x in three columns, and a file with colours whose x is not a counter.
    assert_eq!(points("1 0 0\n2 0 0\n3 1 0\n4 0 1\n").len(), 4);
    assert_eq!(points("1 0 0 9\n2 0 0 9\n4 1 0 9\n3 0 1 9\n").len(), 4);
}
