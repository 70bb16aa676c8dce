//! Wavefront OBJ: vertices, faces of any number of corners, groups.
//!
//! One statement a line: `v x y z`, `f a b c …` with indices from 1, or from −1 backwards, each perhaps with those of a
//! texture and a normal behind slashes. The faces under one `o` and one `g` are a part; a name that comes again goes on
//! with its part. What dresses a surface is skipped; lines and points are counted; curved surfaces are refused, for
//! their shape is not in the vertices.

use std::collections::HashMap;
use std::ops::Range;

use polhode::{Finding, Severity};

use crate::content::{ContentError, ContentErrorKind, ContentPlace};

use super::MeshContents;
use super::number;
use super::parts;
use super::polygon::Polygons;
use super::scan::Scan;

/// Reads the bytes of an OBJ file.
///
/// Coordinates are the doubles nearest to what is written. A polygon of n corners becomes n − 2 triangles.
///
/// ```
/// use polhode_formats::mesh::obj::read;
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
/// assert_eq!(sides.mesh.vertices()[1], [1.7, 0.0, -2.5e-3]);
///
/// let error = read(b"v 0 0 0\nf 1 2 3").unwrap_err();
/// assert_eq!(error.kind.to_string(), "vertex 2 does not exist: there are 1");
/// # Ok::<(), polhode_formats::ContentError>(())
/// ```
///
/// # Errors
/// A statement that is none or is cut short, a coordinate that is not finite, a face with fewer than three corners or with
/// a vertex that is not there yet, curved surfaces, and a file without a face. The place is a span of bytes.
pub fn read(bytes: &[u8]) -> Result<MeshContents, ContentError> {
    let mut reader = Reader::new(bytes);
    while !reader.scan.is_done() {
        reader.statement()?;
    }
    reader.contents()
}

struct Reader<'a> {
    scan: Scan<'a>,
    vertices: Vec<[f64; 3]>,
    triangles: Vec<[u32; 3]>,
    groups: Groups<'a>,
    polygons: Polygons,
    /// The corners of the face that is being read.
    corners: Vec<u32>,
    lines: usize,
    points: usize,
}

impl<'a> Reader<'a> {
    fn new(bytes: &'a [u8]) -> Self {
        Self {
            scan: Scan::new(bytes),
            vertices: Vec::new(),
            triangles: Vec::new(),
            groups: Groups::default(),
            polygons: Polygons::default(),
            corners: Vec::new(),
            lines: 0,
            points: 0,
        }
    }

    /// One statement, or an empty line.
    #[inline]
    fn statement(&mut self) -> Result<(), ContentError> {
        if self.scan.at_line_end() {
            self.scan.skip_line();
            return Ok(());
        }
        let start = self.scan;
        match self.scan.word() {
            b"v" => self.vertex(),
            b"f" | b"fo" => self.face(),
            word => self.other(word, &start),
        }
    }

    /// `v x y z`, then perhaps a weight, a colour, or both.
    #[inline]
    fn vertex(&mut self) -> Result<(), ContentError> {
        let mut vertex = [0.0; 3];
        for coordinate in &mut vertex {
            self.scan.skip_blanks();
            *coordinate = self.scan.float("coordinate")?;
        }
        for _ in 0..5 {
            if self.scan.at_line_end() {
                break;
            }
            self.scan.float("weight or colour")?;
        }
        self.vertices.push(vertex);
        self.end_line()
    }

    /// `f a b c …`.
    #[inline]
    fn face(&mut self) -> Result<(), ContentError> {
        self.corners.clear();
        while !self.scan.at_line_end() {
            let corner = self.corner()?;
            self.corners.push(corner);
        }
        match *self.corners.as_slice() {
            [a, b, c] => self.triangles.push([a, b, c]),
            [] | [_] | [_, _] => return Err(self.scan.expected("a third corner of the face")),
            _ => self.polygons.split(&self.vertices, &self.corners, &mut self.triangles),
        }
        self.end_line()
    }

    /// `v`, `v/vt`, `v/vt/vn` or `v//vn`, of which the first counts.
    #[inline]
    fn corner(&mut self) -> Result<u32, ContentError> {
        let start = self.scan;
        let wrong = || start.expected("the index of a vertex");
        let (written, end) = number::integer(start.bytes, start.at).ok_or_else(wrong)?;
        self.scan.at = end;
        for _ in 0..2 {
            if self.scan.peek() == b'/' {
                self.scan.at += 1;
                if let Some((_, end)) = number::integer(start.bytes, self.scan.at) {
                    self.scan.at = end;
                }
            }
        }
        if self.scan.peek() > b' ' && self.scan.peek() != b'\\' {
            return Err(wrong());
        }
        let count = self.vertices.len();
        let from_zero = if written < 0 { written + count as i64 } else { written - 1 };
        parts::index(from_zero, count).ok_or_else(|| self.no_vertex(&start, written))
    }

    #[cold]
    fn no_vertex(&self, at: &Scan, written: i64) -> ContentError {
        let error = at.error(ContentErrorKind::Index {
            what: "vertex".to_owned(),
            index: written,
            count: self.vertices.len(),
        });
        match written {
            0 => error.hint("indices start at 1"),
            1.. => error.hint("a face comes behind its vertices"),
            _ => error.hint("-1 is the vertex before the face, and so on back to the first"),
        }
    }

    /// Any statement but a vertex and a face.
    fn other(&mut self, word: &[u8], start: &Scan) -> Result<(), ContentError> {
        match word {
            b"o" | b"g" => {
                self.groups.end(self.triangles.len());
                self.scan.skip_blanks();
                let name = self.scan.line();
                let name = name.split(|b| *b == b'#').next().unwrap_or_default().trim_ascii();
                if word == b"o" {
                    (self.groups.object, self.groups.group) = (name, &[]);
                } else {
                    self.groups.group = name;
                }
                return Ok(());
            }
            b"l" => self.lines += 1,
            b"p" => self.points += 1,
            _ if SKIPPED.contains(&word) => {}
            _ if REFUSED.contains(&word) => {
                let what = format!("{:?} of OBJ: curved surfaces and included files", start.found());
                return Err(start
                    .error(ContentErrorKind::Unsupported { what })
                    .hint("export the body as a mesh of triangles, in one file"));
            }
            _ => {
                return Err(start
                    .expected("a statement of OBJ")
                    .hint("a vertex is v x y z, a face f 1 2 3, a comment starts with #"));
            }
        }
        self.scan.skip_line();
        Ok(())
    }

    /// Nothing but the end of the line.
    #[inline]
    fn end_line(&mut self) -> Result<(), ContentError> {
        if !self.scan.at_line_end() {
            return Err(self.scan.expected("the end of the line"));
        }
        self.scan.skip_line();
        Ok(())
    }

    fn contents(mut self) -> Result<MeshContents, ContentError> {
        self.groups.end(self.triangles.len());
        if self.triangles.is_empty() {
            let what = if self.vertices.is_empty() { "vertices and no faces" } else { "faces" }.to_owned();
            return Err(ContentError::new(ContentErrorKind::Missing { what }, ContentPlace::Whole)
                .hint("export the body as a mesh, with its faces"));
        }
        let mut findings = Vec::new();
        if self.lines + self.points > 0 {
            let message =
                format!("{} lines and {} points bound no solid and were left out", self.lines, self.points);
            findings.push(Finding {
                code: "mesh.not_a_surface",
                severity: Severity::Info,
                message,
                place: None,
            });
        }
        findings.extend(self.polygons.finding());
        let parts = parts::of_shared(self.vertices, self.groups.parts(self.triangles))?;
        Ok(MeshContents { encoding: "text", name: String::new(), unit: None, parts, findings })
    }
}

/// What says nothing about the shape.
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

/// Free-form curves and surfaces, the older forms of them, and what another file or program says.
const REFUSED: [&[u8]; 21] = [
    b"cstype", b"deg", b"bmat", b"step", b"curv", b"curv2", b"surf", b"parm", b"trim", b"hole", b"scrv",
    b"sp", b"con", b"bsp", b"bzp", b"cdc", b"cdp", b"res", b"call", b"csh", b"lib",
];

/// The names in force, and which triangles were made under which.
#[derive(Default)]
struct Groups<'a> {
    object: &'a [u8],
    group: &'a [u8],
    /// Numbers of the parts, in the order of their first triangles.
    numbers: HashMap<(&'a [u8], &'a [u8]), usize>,
    names: Vec<(&'a [u8], &'a [u8])>,
    runs: Vec<(usize, Range<usize>)>,
    /// The first triangle under the names in force.
    start: usize,
}

impl Groups<'_> {
    /// Names change, and there are so many triangles.
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
