//! OFF, the Object File Format of Geomview.
//!
//! The file contains `OFF`, the numbers of vertices, faces and edges, then a line for each vertex
//! (`x y z`) and each face (`n a b c …`, from 0). The prefixes `ST`, `C` and `N` of `OFF` mean that
//! texture, colour or normal follow the coordinates. A face may have a colour, too. The number of
//! edges is not used.

use polhode_source::{ContentError, ContentErrorKind};

use super::MeshContents;
use super::parts;
use super::polygon::Polygons;
use super::scan::Scan;

/// Reads the bytes of an OFF file.
///
/// Coordinates are the doubles nearest to the text. A polygon with n corners becomes n − 2
/// triangles.
///
/// ```
/// use polhode_shape::mesh::off::read;
///
/// let text = b"OFF
/// 4 4 6
/// 0.1 0.2 0
/// 1.7 0 -2.5e-3
/// 0.3 1.1 0.4
/// 0.5 0.6 1.9
/// 3 0 2 1
/// 3 0 1 3
/// 3 1 2 3
/// 3 2 0 3
/// ";
/// let contents = read(text)?;
/// assert_eq!(contents.parts[0].mesh.coordinates()[1], [1.7, 0.0, -2.5e-3]);
/// assert_eq!(contents.parts[0].mesh.triangles()[3], [2, 0, 3]);
///
/// let error = read(&text[..text.len() - 8]).unwrap_err();
/// assert_eq!(error.kind.to_string(), "4 faces are declared, but the file has 3");
/// # Ok::<(), polhode_source::ContentError>(())
/// ```
///
/// # Errors
/// Bytes that do not start like OFF, its binary form or a form with other dimensions, counts that
/// do not agree with the file, a coordinate that is not finite, a face with fewer than three
/// corners, and an index without a vertex. The place is a span of bytes.
pub fn read(bytes: &[u8]) -> Result<MeshContents, ContentError> {
    let mut scan = Scan::new(bytes);
    scan.skip_empty_lines();
    scan.skip_blanks();
    keyword(&mut scan)?;

    let mut counts = [0; 3];
    for (count, what) in counts.iter_mut().zip(["vertices", "faces", "edges"]) {
        scan.skip_empty_lines();
        scan.skip_blanks();
        let start = scan;
        let read = scan.integer(&format!("the number of {what}"))?;
        *count = u64::try_from(read).map_err(|_| {
            let (what, value) = (format!("the number of {what}"), read.to_string());
            start.error(ContentErrorKind::value(what, value, "0 or more"))
        })?;
    }
    let [declared_vertices, declared_faces, _] = counts;
    end_line(&mut scan)?;

    let mut vertices = Vec::new();
    for present in 0..declared_vertices {
        row(&mut scan, "vertices", declared_vertices, present)?;
        vertices.push(vertex(&mut scan)?);
    }
    let (mut triangles, mut corners, mut polygons) = (Vec::new(), Vec::new(), Polygons::default());
    for present in 0..declared_faces {
        row(&mut scan, "faces", declared_faces, present)?;
        face(&mut scan, vertices.len(), &mut corners)?;
        polygons.split(&vertices, &corners, &mut triangles);
    }
    scan.skip_empty_lines();
    if !scan.is_done() {
        return Err(left_over(scan, declared_faces));
    }
    if triangles.is_empty() {
        return Err(ContentErrorKind::missing("faces")
            .of_whole()
            .hint("a point cloud encloses no volume: export a mesh"));
    }
    let findings = polygons.finding().into_iter().collect();
    let parts = parts::of_shared(vertices, vec![(String::new(), triangles)])?;
    Ok(MeshContents { encoding: "text", name: String::new(), unit: None, parts, findings })
}

/// Reads `[ST][C][N]OFF`, and refuses related formats. Some programs write the counts without a
/// blank after it.
fn keyword(scan: &mut Scan) -> Result<(), ContentError> {
    let start = *scan;
    let word = scan.word();
    let length = word.windows(3).position(|three| three == b"OFF").unwrap_or(word.len());
    let (prefix, behind) = word.split_at(length);
    let unsupported = |what: &str| {
        Err(start
            .error(ContentErrorKind::unsupported(what))
            .hint("export the mesh as OFF of three dimensions, in text"))
    };
    let dimensions = prefix.strip_prefix(b"ST").unwrap_or(prefix);
    let dimensions = dimensions.strip_prefix(b"C").unwrap_or(dimensions);
    let dimensions = dimensions.strip_prefix(b"N").unwrap_or(dimensions);
    match (dimensions, behind) {
        (b"4", [_, ..]) => return unsupported("4OFF, whose vertices have four coordinates"),
        (b"n", [_, ..]) => return unsupported("nOFF, whose vertices have any number of coordinates"),
        (b"4n", [_, ..]) => return unsupported("4nOFF, whose vertices have any number of coordinates"),
        (b"", [_, _, _]) => {}
        (b"", [_, _, _, digits @ ..]) if digits.iter().all(u8::is_ascii_digit) => {
            scan.at -= digits.len();
            return Ok(());
        }
        _ => return Err(start.expected("\"OFF\"").hint("an OFF file starts with OFF, COFF, NOFF or STOFF")),
    }
    scan.skip_blanks();
    if { *scan }.word() == b"BINARY" {
        return unsupported("binary OFF");
    }
    Ok(())
}

/// Moves to the next line with content.
fn row(scan: &mut Scan, what: &str, declared: u64, present: u64) -> Result<(), ContentError> {
    scan.skip_empty_lines();
    if scan.is_done() {
        let error = ContentErrorKind::count(what, declared, present).at(scan.bytes.len()..scan.bytes.len());
        return Err(error.hint("the file is truncated, or its counts are wrong"));
    }
    Ok(())
}

/// Reads `x y z`, followed by an optional normal, colour and texture.
fn vertex(scan: &mut Scan) -> Result<[f64; 3], ContentError> {
    let mut vertex = [0.0; 3];
    for coordinate in &mut vertex {
        scan.skip_blanks();
        *coordinate = scan.float("coordinate")?;
    }
    while !scan.at_line_end() {
        scan.float("normal, colour or texture")?;
    }
    scan.skip_line();
    Ok(vertex)
}

/// Reads `n a b c …`, followed by an optional colour.
fn face(scan: &mut Scan, vertices: usize, corners: &mut Vec<u32>) -> Result<(), ContentError> {
    corners.clear();
    scan.skip_blanks();
    let start = *scan;
    let count = scan.integer("the number of the face's corners")?;
    if count < 3 {
        let (what, value) = ("the number of a face's corners", count.to_string());
        return Err(start.error(ContentErrorKind::value(what, value, "3 or more")));
    }
    for _ in 0..count {
        scan.skip_blanks();
        let start = *scan;
        let index = scan.integer("the index of a vertex")?;
        corners.push(parts::index(index, vertices).ok_or_else(|| {
            start.error(ContentErrorKind::index("vertex", index, vertices)).hint("indices start at 0")
        })?);
    }
    while !scan.at_line_end() {
        scan.float("colour")?;
    }
    scan.skip_line();
    Ok(())
}

/// Returns the error for lines after the last face.
fn left_over(mut scan: Scan, declared: u64) -> ContentError {
    let (start, mut present) = (scan, declared);
    while !scan.is_done() {
        scan.skip_line();
        scan.skip_empty_lines();
        present += 1;
    }
    let kind = ContentErrorKind::count("faces", declared, present);
    start.error(kind).hint("the counts at the start of the file are too small")
}

fn end_line(scan: &mut Scan) -> Result<(), ContentError> {
    if !scan.at_line_end() {
        return Err(scan.expected("the end of the line"));
    }
    scan.skip_line();
    Ok(())
}
