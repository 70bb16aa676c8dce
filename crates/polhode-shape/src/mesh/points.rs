//! Point clouds: meshes without triangles, used for their convex hull.
//!
//! Each line of a file is one point, `x y z`. Separators are blanks and tabs, or commas, or
//! semicolons, the same in all lines. `#` and `//` start a comment. A comma together with another
//! separator may be a decimal comma, and is refused. A first column that numbers the points, before
//! three others, is also refused. Further columns, such as colours, intensities or normals, are not
//! read, and reported in a finding.

use polhode::body::mesh::TriangleMesh;
use polhode_source::{ContentError, ContentErrorKind, ContentPlace};

use super::{MeshContents, MeshPart};
use crate::finding::info;

/// Returns points as a part without triangles.
///
/// # Errors
/// [`ContentError`] without points, or for more points than indices.
pub fn cloud(points: Vec<[f64; 3]>) -> Result<MeshContents, ContentError> {
    if points.is_empty() {
        let kind = ContentErrorKind::missing("points");
        return Err(kind.of_whole().hint("export the point cloud again: the file is empty"));
    }
    let mesh = TriangleMesh::new(points, Vec::new())
        .map_err(|error| ContentErrorKind::Body(Box::new(error)).of_whole())?;
    let parts = vec![MeshPart { name: String::new(), mesh }];
    Ok(MeshContents { encoding: "text", name: String::new(), unit: None, parts, findings: Vec::new() })
}

/// Returns the contents if they have faces.
///
/// # Errors
/// [`ContentErrorKind::Missing`] if there are only points.
pub fn with_faces(contents: MeshContents) -> Result<MeshContents, ContentError> {
    if contents.parts.is_empty() || contents.triangles() > 0 {
        return Ok(contents);
    }
    let kind = ContentErrorKind::missing("faces");
    let hint = "a point cloud encloses no volume: export a mesh, or use the convex hull by --hull";
    Err(kind.of_whole().hint(hint))
}

/// Separator between the numbers of a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Separator {
    Blank,
    Comma,
    Semicolon,
}

impl Separator {
    const fn name(self) -> &'static str {
        match self {
            Self::Blank => "blanks",
            Self::Comma => "commas",
            Self::Semicolon => "semicolons",
        }
    }

    /// Returns the separator of a line; `None` if it has several.
    fn of(line: &str) -> Option<Self> {
        let separator = match (line.contains(','), line.contains(';')) {
            (false, false) => return Some(Self::Blank),
            (true, false) => Self::Comma,
            (false, true) => Self::Semicolon,
            (true, true) => return None,
        };
        let is_mixed = separator.fields(line).any(|field| field.contains(char::is_whitespace));
        (!is_mixed).then_some(separator)
    }

    fn fields(self, line: &str) -> impl Iterator<Item = &str> {
        let is_between = move |c: char| match self {
            Self::Blank => c.is_whitespace(),
            Self::Comma => c == ',',
            Self::Semicolon => c == ';',
        };
        line.split(is_between).map(str::trim).filter(move |field| self != Self::Blank || !field.is_empty())
    }
}

/// Reads lines of the form `x y z`.
///
/// ```
/// use polhode_shape::mesh::points::read;
/// let contents = read(b"# a scan\n0, 0, 0, 7\n1.5,0,0,12\n0,2e-1,0,9\n0,0,-3,7\n")?;
/// assert_eq!(contents.parts[0].mesh.coordinates()[2], [0.0, 0.2, 0.0]);
/// assert!(contents.findings[0].message.contains("after the third"));
/// let error = read(b"0 0 0\nC 1 2 3\n").unwrap_err();
/// assert_eq!(error.kind.to_string(), "expected the three coordinates of a point, found \"C\"");
/// assert!(read(b"0,5 0,25 0,75\n").unwrap_err().kind.to_string().contains("decimal comma?"));
/// # Ok::<(), polhode_source::ContentError>(())
/// ```
///
/// # Errors
/// [`ContentError`] with its place for a line that does not start with three finite numbers; for
/// mixed separators; for a first column that numbers the points.
pub fn read(bytes: &[u8]) -> Result<MeshContents, ContentError> {
    let text = str::from_utf8(bytes).map_err(|error| {
        let (what, found) = ("text", "");
        let place = ContentPlace::Text(error.valid_up_to()..error.valid_up_to());
        ContentError::new(ContentErrorKind::expected(what, found), place)
    })?;
    let (mut points, mut more, mut start) = (Vec::new(), 0_usize, 0);
    let mut separator = None;
    for line in text.split_inclusive('\n') {
        let content = line.split("//").next().unwrap_or_default();
        let content = content.split('#').next().unwrap_or_default();
        let content = content.trim_start_matches('\u{feff}').trim();
        let place = || ContentPlace::Text(start..start + line.trim_end().len());
        if !content.is_empty() {
            let own = Separator::of(content).ok_or_else(|| mixed(content, place()))?;
            let first = *separator.get_or_insert(own);
            if own != first {
                let what = format!("{} between the numbers, as on the first line", first.name());
                let kind = ContentErrorKind::expected(what, content);
                return Err(ContentError::new(kind, place()).hint(ONE_KIND));
            }
            let mut fields = own.fields(content);
            let mut point = [0.0; 3];
            for coordinate in &mut point {
                *coordinate = coordinate_of(fields.next()).map_err(|kind| {
                    ContentError::new(kind, place())
                        .hint("a file of points has lines of x y z; a molecule is read without --hull")
                })?;
            }
            more += usize::from(fields.any(|field| !field.is_empty()));
            points.push(point);
        }
        start += line.len();
    }
    if more == points.len() {
        require_coordinates(&points)?;
    }
    let mut contents = cloud(points)?;
    if more > 0 {
        let message =
            format!("columns after the third, on {more} lines, are not coordinates and were not read");
        contents.findings.push(info("mesh.unread_columns", message));
    }
    Ok(contents)
}

const ONE_KIND: &str =
    "write decimal points, and separate the numbers only by spaces, only by commas, or only by semicolons";

/// Returns the error for a line with several separators.
fn mixed(line: &str, place: ContentPlace) -> ContentError {
    let found = line.to_owned();
    let kind = if line.contains(',') {
        ContentErrorKind::unclear("is this comma a decimal comma?", found)
    } else {
        ContentErrorKind::expected("one kind of separator between the numbers", found)
    };
    ContentError::new(kind, place).hint(ONE_KIND)
}

/// Refuses a first column 1, 2, 3, … or 0, 1, 2, … before three others: it numbers the points.
fn require_coordinates(points: &[[f64; 3]]) -> Result<(), ContentError> {
    let counts_from = |first: f64| points.iter().enumerate().all(|(k, [x, ..])| *x == first + k as f64);
    if points.len() < 2 || !counts_from(0.0) && !counts_from(1.0) {
        return Ok(());
    }
    let question = "is the first column the index of the point, or x?";
    let found = format!("{}, {}, … in the first of four columns or more", points[0][0], points[1][0]);
    Err(ContentErrorKind::unclear(question, found)
        .of_whole()
        .hint("delete the index column; if the first column is x, delete the columns after the third"))
}

/// Parses a finite number.
fn coordinate_of(word: Option<&str>) -> Result<f64, ContentErrorKind> {
    let number = word.and_then(|word| word.parse::<f64>().ok()).filter(|number| number.is_finite());
    number.ok_or_else(|| {
        ContentErrorKind::expected("the three coordinates of a point", word.unwrap_or_default())
    })
}
