//! Wavefront OBJ: vertices, faces with any number of corners, groups.
//!
//! Each line is one statement: `v x y z`, or `f a b c …` with indices from 1, or from −1 backwards.
//! Indices of a texture and a normal may follow each after slashes. The faces under one `o` and one
//! `g` form a part; a repeated name continues its part. Materials and other attributes are skipped;
//! lines and points are counted. Curved surfaces are refused, because the vertices do not determine
//! their shape.

use std::collections::HashMap;
use std::ops::Range;

use polhode_source::{ContentError, ContentErrorKind};

use super::MeshContents;
use super::parts;
use super::points;
use super::polygon::Polygons;
use super::scan::{Scan, integer};
use crate::finding::info;

/// Reads the bytes of an OBJ file.
///
/// Coordinates are the doubles nearest to the text. A polygon with n corners becomes n − 2
/// triangles.
///
/// ```
/// use polhode_shape::mesh::obj::read;
///
/// let text = b"# a tetrahedron
/// v 0.1 0.2 0
/// v 1.7 0 -2.5e-3
/// v 0.3 1.1 0.4
/// v 0.5 0.6 1.9
/// g base
/// f 1 3 2
/// g sides
/// f 1/1 2/2 -1/3
/// f 2//1 3//2 4//3
/// f 3 1 4";
/// let contents = read(text)?;
/// let [base, sides] = contents.parts.as_slice() else { panic!() };
/// assert_eq!((base.name.as_str(), base.mesh.triangles()), ("base", [[0, 2, 1]].as_slice()));
/// assert_eq!((sides.name.as_str(), sides.mesh.triangles().len()), ("sides", 3));
/// assert_eq!(sides.mesh.coordinates()[1], [1.7, 0.0, -2.5e-3]);
///
/// let error = read(b"v 0 0 0\nf 1 2 3").unwrap_err();
/// assert_eq!(error.kind.to_string(), "vertex 2 does not exist: there are 1");
/// # Ok::<(), polhode_source::ContentError>(())
/// ```
///
/// # Errors
/// An unknown or incomplete statement, a coordinate that is not finite, a face with fewer than
/// three corners or with an undefined vertex, a curved surface, and a file without a face. The
/// place is a span of bytes.
pub fn read(bytes: &[u8]) -> Result<MeshContents, ContentError> {
    points::with_faces(read_or_cloud(bytes)?)
}

/// Reads the bytes of a file that may have no faces. Then the vertices form a part without
/// triangles.
pub fn read_or_cloud(bytes: &[u8]) -> Result<MeshContents, ContentError> {
    let mut reader = Reader::default();
    let mut scan = Scan::new(bytes);
    while !scan.is_done() {
        if scan.at_line_end() {
            scan.skip_line();
            continue;
        }
        let start = scan.at;
        match scan.word() {
            b"v" => reader.vertex(&mut scan)?,
            b"f" => reader.face(&mut scan)?,
            word => scan = reader.other(word, scan.moved(start), scan)?,
        }
    }
    reader.contents()
}

/// State of the reader. The scan is a separate variable, so that it stays in processor registers.
#[derive(Default)]
struct Reader<'a> {
    vertices: Vec<[f64; 3]>,
    triangles: Vec<[u32; 3]>,
    groups: Groups<'a>,
    polygons: Polygons,
    /// Corners of the current face.
    corners: Vec<u32>,
    lines: usize,
    points: usize,
}

impl<'a> Reader<'a> {
    /// Reads `v x y z`, followed by an optional weight, colour, or both.
    #[inline(always)]
    fn vertex(&mut self, scan: &mut Scan) -> Result<(), ContentError> {
        let mut next = || {
            scan.skip_blanks();
            scan.float("coordinate")
        };
        let vertex = [next()?, next()?, next()?];
        if !scan.at_line_end() {
            *scan = weight_and_colour(*scan)?;
        }
        self.vertices.push(vertex);
        scan.skip_line();
        Ok(())
    }

    /// Reads `f a b c …`.
    #[inline(always)]
    fn face(&mut self, scan: &mut Scan) -> Result<(), ContentError> {
        if let Some((triangle, end)) = plain_triangle(scan, self.vertices.len()) {
            self.triangles.push(triangle);
            scan.at = end;
            return Ok(());
        }
        self.corners.clear();
        while !scan.at_line_end() {
            let corner = self.corner(scan)?;
            self.corners.push(corner);
        }
        match *self.corners.as_slice() {
            [a, b, c] => self.triangles.push([a, b, c]),
            [] | [_] | [_, _] => return Err(scan.expected("a third corner of the face")),
            _ => self.polygons.split(&self.vertices, &self.corners, &mut self.triangles),
        }
        scan.skip_line();
        Ok(())
    }

    /// Reads `v`, `v/vt`, `v/vt/vn` or `v//vn`, and uses only the vertex.
    #[inline(always)]
    fn corner(&self, scan: &mut Scan) -> Result<u32, ContentError> {
        let start = scan.at;
        let Some((written, mut end)) = integer(scan.bytes, start) else {
            return Err(no_index(*scan, start));
        };
        for _ in 0..2 {
            if scan.bytes.get(end) == Some(&b'/') {
                end += 1;
                end = integer(scan.bytes, end).map_or(end, |(_, end)| end);
            }
        }
        if !scan.pass(end) {
            return Err(no_index(*scan, start));
        }
        let count = self.vertices.len();
        let from_zero = if written < 0 { written + count as i64 } else { written - 1 };
        parts::index(from_zero, count).ok_or_else(|| no_vertex(scan.moved(start), written, count))
    }

    /// Reads any statement except a vertex and a face.
    fn other(&mut self, word: &[u8], start: Scan<'a>, mut scan: Scan<'a>) -> Result<Scan<'a>, ContentError> {
        match word {
            b"o" | b"g" => {
                self.groups.end(self.triangles.len());
                scan.skip_blanks();
                let name = scan.line();
                let name = name.split(|b| *b == b'#').next().unwrap_or_default().trim_ascii();
                if word == b"o" {
                    (self.groups.object, self.groups.group) = (name, &[]);
                } else {
                    self.groups.group = name;
                }
                return Ok(scan);
            }
            b"l" => self.lines += 1,
            b"p" => self.points += 1,
            _ if SKIPPED.contains(&word) => {}
            _ if REFUSED.contains(&word) => {
                let what = format!("{:?} of OBJ: curved surfaces and included files", start.found());
                return Err(start
                    .error(ContentErrorKind::unsupported(what))
                    .hint("export the body as a mesh of triangles, in one file"));
            }
            _ => {
                return Err(start
                    .expected("a statement of OBJ")
                    .hint("a vertex is v x y z, a face f 1 2 3, a comment starts with #"));
            }
        }
        scan.skip_line();
        Ok(scan)
    }

    fn contents(mut self) -> Result<MeshContents, ContentError> {
        self.groups.end(self.triangles.len());
        if self.vertices.is_empty() {
            return Err(ContentErrorKind::missing("vertices and no faces")
                .of_whole()
                .hint("export the body as a mesh, with its faces"));
        }
        if self.triangles.is_empty() {
            return Ok(MeshContents { encoding: "text", ..points::cloud(self.vertices)? });
        }
        let mut findings = Vec::new();
        if self.lines + self.points > 0 {
            let message = format!(
                "lines ({}) and points ({}) enclose no volume and were ignored",
                self.lines, self.points
            );
            findings.push(info("mesh.not_a_surface", message));
        }
        findings.extend(self.polygons.finding());
        let parts = parts::of_shared(self.vertices, self.groups.parts(self.triangles))?;
        Ok(MeshContents { encoding: "text", name: String::new(), unit: None, parts, findings })
    }
}

/// Parses ` a b c` and a line end, with one blank before each number: the form of most files.
/// Returns the indices and the offset after the line; `None` for any other form.
#[inline(always)]
fn plain_triangle(scan: &Scan, count: usize) -> Option<([u32; 3], usize)> {
    let (mut at, mut triangle) = (scan.at, [0; 3]);
    for corner in &mut triangle {
        let (written, end) = integer(scan.bytes, at + 1)?;
        if scan.bytes.get(at) != Some(&b' ') {
            return None;
        }
        (*corner, at) = (parts::index(written - 1, count)?, end);
    }
    scan.is_line_end(at).then_some((triangle, at + 1))
}

/// Skips the numbers after x, y, z.
fn weight_and_colour(mut scan: Scan) -> Result<Scan, ContentError> {
    for _ in 0..5 {
        if !scan.at_line_end() {
            scan.float("weight or colour")?;
        }
    }
    if scan.at_line_end() { Ok(scan) } else { Err(scan.expected("the end of the line")) }
}

#[cold]
fn no_index(scan: Scan, at: usize) -> ContentError {
    scan.moved(at).expected("the index of a vertex")
}

#[cold]
fn no_vertex(at: Scan, written: i64, count: usize) -> ContentError {
    let error = at.error(ContentErrorKind::index("vertex", written, count));
    match written {
        0 => error.hint("indices start at 1"),
        1.. => error.hint("a face must come after its vertices"),
        _ => error.hint("-1 is the last vertex before the face, -2 the one before it"),
    }
}

/// Statements that do not affect the shape.
const SKIPPED: [&[u8]; 18] = [
    b"vn",
    b"vt",
    b"vp",
    b"s",
    b"usemtl",
    b"mtllib",
    b"usemap",
    b"maplib",
    b"mg",
    b"bevel",
    b"lod",
    b"c_interp",
    b"d_interp",
    b"shadow_obj",
    b"trace_obj",
    b"ctech",
    b"stech",
    b"end",
];

/// Statements of free-form curves and surfaces, including obsolete ones, and references to other
/// files and programs.
const REFUSED: [&[u8]; 21] = [
    b"cstype", b"deg", b"bmat", b"step", b"curv", b"curv2", b"surf", b"parm", b"trim", b"hole", b"scrv",
    b"sp", b"con", b"bsp", b"bzp", b"cdc", b"cdp", b"res", b"call", b"csh", b"lib",
];

/// Current names, and the triangles under each pair of names.
#[derive(Default)]
struct Groups<'a> {
    object: &'a [u8],
    group: &'a [u8],
    /// Index of each part, in the order of their first triangles.
    numbers: HashMap<(&'a [u8], &'a [u8]), usize>,
    names: Vec<(&'a [u8], &'a [u8])>,
    runs: Vec<(usize, Range<usize>)>,
    /// First triangle under the current names.
    start: usize,
}

impl Groups<'_> {
    /// Ends the current run at this number of triangles, before the names change.
    fn end(&mut self, triangles: usize) {
        let run = self.start..triangles;
        if !run.is_empty() {
            let names = (self.object, self.group);
            let number = *self.numbers.entry(names).or_insert(self.names.len());
            if number == self.names.len() {
                self.names.push(names);
            }
            self.runs.push((number, run));
        }
        self.start = triangles;
    }

    fn parts(self, triangles: Vec<[u32; 3]>) -> Vec<(String, Vec<[u32; 3]>)> {
        let name = |&(object, group): &(&[u8], &[u8])| {
            let words = match (object, group) {
                (object, []) => vec![object],
                ([], group) => vec![group],
                (object, group) if object == group => vec![group],
                (object, group) => vec![object, group],
            };
            words.into_iter().map(String::from_utf8_lossy).collect::<Vec<_>>().join("/")
        };
        if let [names] = self.names.as_slice() {
            return vec![(name(names), triangles)];
        }
        let mut parts: Vec<_> = self.names.iter().map(|names| (name(names), Vec::new())).collect();
        for (number, run) in self.runs {
            parts[number].1.extend_from_slice(&triangles[run]);
        }
        parts
    }
}
