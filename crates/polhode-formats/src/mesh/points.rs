//! Clouds of points: meshes without triangles, for their convex hull.
//!
//! A file of points has one in a line, `x y z`, with blanks, tabs, commas or semicolons between the numbers; `#` and `//` start a comment.
//! Columns behind the third are colours, intensities or normals, and are not read; a finding says so.

use polhode::body::mesh::TriangleMesh;
use polhode::body::{Finding, Severity};

use super::{MeshContents, MeshPart};
use crate::content::{ContentError, ContentErrorKind, ContentPlace};

/// Points as a part without triangles.
///
/// # Errors
/// [`ContentError`] without a point, or for more points than can be numbered.
pub(super) fn cloud(points: Vec<[f64; 3]>) -> Result<MeshContents, ContentError> {
    if points.is_empty() {
        let kind = ContentErrorKind::Missing { what: "points".to_owned() };
        return Err(ContentError::new(kind, ContentPlace::Whole).hint("export the cloud again: it is empty"));
    }
    let mesh = TriangleMesh::new(points, Vec::new()).map_err(|error| {
        let kind = ContentErrorKind::Body(Box::new(error));
        ContentError::new(kind, ContentPlace::Whole)
    })?;
    let parts = vec![MeshPart { name: String::new(), mesh }];
    Ok(MeshContents { encoding: "text", name: String::new(), unit: None, parts, findings: Vec::new() })
}

/// The contents, if they have faces.
///
/// # Errors
/// [`ContentErrorKind::Missing`] of points alone.
pub(super) fn with_faces(contents: MeshContents) -> Result<MeshContents, ContentError> {
    if contents.parts.is_empty() || contents.triangles() > 0 {
        return Ok(contents);
    }
    let kind = ContentErrorKind::Missing { what: "faces".to_owned() };
    let hint = "a cloud of points bounds no solid: export a mesh, or take the convex hull by --hull";
    Err(ContentError::new(kind, ContentPlace::Whole).hint(hint))
}

/// Reads lines of `x y z`.
///
/// ```
/// use polhode_formats::mesh::points::read;
/// let contents = read(b"# a scan\n0 0 0\n1.5,0,0 ; 12\n0\t2e-1\t0\n0 0 -3\n")?;
/// assert_eq!(contents.parts[0].mesh.coordinates()[2], [0.0, 0.2, 0.0]);
/// assert!(contents.findings[0].message.contains("behind the third"));
/// let error = read(b"0 0 0\nC 1 2 3\n").unwrap_err();
/// assert_eq!(error.kind.to_string(), "expected the three coordinates of a point, found \"C\"");
/// # Ok::<(), polhode_formats::ContentError>(())
/// ```
///
/// # Errors
/// [`ContentError`] for a line that does not start with three finite numbers, with its place.
pub fn read(bytes: &[u8]) -> Result<MeshContents, ContentError> {
    let text = str::from_utf8(bytes).map_err(|error| {
        let (what, found) = ("text".to_owned(), String::new());
        let place = ContentPlace::Text(error.valid_up_to()..error.valid_up_to());
        ContentError::new(ContentErrorKind::Expected { what, found }, place)
    })?;
    let (mut points, mut more, mut start) = (Vec::new(), 0_usize, 0);
    for line in text.split_inclusive('\n') {
        let content = line.split("//").next().unwrap_or_default();
        let content = content.split('#').next().unwrap_or_default();
        let content = content.trim_start_matches('\u{feff}');
        let mut words =
            content.split(|c: char| c.is_whitespace() || c == ',' || c == ';').filter(|w| !w.is_empty());
        if let Some(first) = words.next() {
            let all = [Some(first), words.next(), words.next()];
            let place = || ContentPlace::Text(start..start + line.trim_end().len());
            let mut point = [0.0; 3];
            for (coordinate, word) in point.iter_mut().zip(all) {
                *coordinate = coordinate_of(word).map_err(|kind| {
                    ContentError::new(kind, place())
                        .hint("a file of points has lines of x y z; a molecule is read without --hull")
                })?;
            }
            points.push(point);
        }
        more += usize::from(words.next().is_some());
        start += line.len();
    }
    let mut contents = cloud(points)?;
    if more > 0 {
        let message =
            format!("columns behind the third, of {more} lines, are not coordinates and were not read");
        let (code, severity) = ("mesh.not_a_surface", Severity::Info);
        contents.findings.push(Finding { code, severity, message, place: None });
    }
    Ok(contents)
}

/// A finite number.
fn coordinate_of(word: Option<&str>) -> Result<f64, ContentErrorKind> {
    let number = word.and_then(|word| word.parse::<f64>().ok()).filter(|number| number.is_finite());
    number.ok_or_else(|| {
        let (what, found) = ("the three coordinates of a point", word.unwrap_or_default());
        ContentErrorKind::Expected { what: what.to_owned(), found: found.to_owned() }
    })
}
