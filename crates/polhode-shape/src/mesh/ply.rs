//! PLY, the Stanford polygon file format: ASCII and binary of both endiannesses.
//!
//! A text header declares elements and their properties; their values follow in that order. The
//! reader uses `x`, `y`, `z` of the element `vertex`, and the lists `vertex_indices` (or
//! `vertex_index`) of `face` and `tristrips`; everything else is skipped. Counts are not trusted:
//! lists grow with the values that are present.

mod header;
mod values;

use polhode_source::{ContentError, ContentErrorKind, ContentPlace};

use super::MeshContents;
use super::parts;
use super::points;
use super::polygon::Polygons;
use crate::finding::info;
use header::{Element, Encoding, Header, Property, Scalar};
use values::{Ascii, Binary, Stop, Values};

/// Reads the bytes of a PLY file.
///
/// Coordinates are doubles: the ones nearest to the text in an ASCII file, and exact in a binary
/// file. A polygon with n corners becomes n − 2 triangles.
///
/// ```
/// use polhode_shape::mesh::ply::read;
///
/// let text = b"ply
/// format ascii 1.0
/// element vertex 4
/// property float x
/// property float y
/// property float z
/// element face 4
/// property list uchar int vertex_indices
/// end_header
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
/// assert_eq!(contents.encoding, "ascii");
/// assert_eq!(contents.parts[0].mesh.coordinates()[1], [1.7, 0.0, -2.5e-3]);
///
/// let error = read(&text[..text.len() - 10]).unwrap_err();
/// assert_eq!(error.kind.to_string(), "3 corners are declared, but the file has 2");
/// # Ok::<(), polhode_source::ContentError>(())
/// ```
///
/// # Errors
/// A malformed header or one without vertices or faces, counts that do not agree with the file, a
/// coordinate that is not finite, a face with fewer than three corners, and an index without a
/// vertex.
pub fn read(bytes: &[u8]) -> Result<MeshContents, ContentError> {
    points::with_faces(read_or_cloud(bytes)?)
}

/// Reads the bytes of a file that may have no faces. Then the vertices form a part without
/// triangles.
pub fn read_or_cloud(bytes: &[u8]) -> Result<MeshContents, ContentError> {
    let header = header::read(bytes)?;
    match header.encoding {
        Encoding::Ascii => elements(&header, Ascii::new(bytes, header.end)),
        Encoding::LittleEndian => elements(&header, Binary::<false>::new(bytes, header.end)),
        Encoding::BigEndian => elements(&header, Binary::<true>::new(bytes, header.end)),
    }
}

/// Reads all elements in order.
fn elements(header: &Header, mut values: impl Values) -> Result<MeshContents, ContentError> {
    let mut surface = Surface::default();
    let mut findings = Vec::new();
    // Faces that precede the vertices are skipped, and read after the vertices.
    let (mut waiting, mut has_vertices) = (Vec::new(), false);
    for element in &header.elements {
        match element.name.as_str() {
            "vertex" => {
                surface.read_vertices(element, &mut values)?;
                for (element, mut values) in waiting.drain(..) {
                    surface.read_faces(element, &mut values)?;
                }
                has_vertices = true;
            }
            "face" | "tristrips" if has_vertices => surface.read_faces(element, &mut values)?,
            name => {
                if matches!(name, "face" | "tristrips") {
                    waiting.push((element, values));
                } else if name == "edge" && element.count > 0 {
                    let message = format!("edges ({}) enclose no volume and were ignored", element.count);
                    findings.push(info("mesh.not_a_surface", message));
                }
                pass_over(element, &mut values)?;
            }
        }
    }
    let missing = |what: &str| ContentErrorKind::missing(what).of_whole();
    if !has_vertices {
        return Err(missing("element vertex"));
    }
    if values.rest() > 0 {
        let (what, declared) = ("bytes after the last element", 0);
        let kind = ContentErrorKind::count(what, declared, values.rest() as u64);
        // Place of the first unexpected value.
        let _ = values.skip(Scalar::U8, 1);
        return Err(ContentError::new(kind, values.last(String::new()).1)
            .hint("a count in the header is too small, or the file is damaged"));
    }
    let encoding = header.encoding.name();
    if surface.triangles.is_empty() {
        let cloud = points::cloud(surface.vertices)?;
        return Ok(MeshContents { encoding, findings, ..cloud });
    }
    findings.extend(surface.polygons.finding());
    let parts = parts::of_shared(surface.vertices, vec![(String::new(), surface.triangles)])?;
    Ok(MeshContents { encoding, name: String::new(), unit: None, parts, findings })
}

/// Vertices and triangles read so far.
#[derive(Default)]
struct Surface {
    vertices: Vec<[f64; 3]>,
    triangles: Vec<[u32; 3]>,
    polygons: Polygons,
    /// Corners of the current face.
    corners: Vec<u32>,
}

impl Surface {
    fn read_vertices(&mut self, element: &Element, values: &mut impl Values) -> Result<(), ContentError> {
        let mut axes = vec![None; element.properties.len()];
        for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
            match element.property(name) {
                Some((place, property)) if property.length.is_none() => axes[place] = Some(axis),
                found => return Err(no_property(element, found, &format!("property {name}"), "a number")),
            }
        }
        for row in 0..element.count {
            let mut vertex = [0.0; 3];
            for (property, axis) in element.properties.iter().zip(&axes) {
                match axis {
                    Some(axis) => {
                        let value = values.number(property.scalar);
                        vertex[*axis] = value.map_err(|stop| stop.or(|| ended(element, row, values)))?;
                        if !vertex[*axis].is_finite() {
                            let (found, place) = values.last(format!("vertex {row}"));
                            let what = format!("the coordinate {}", property.name);
                            return Err(ContentError::new(ContentErrorKind::not_finite(what, found), place));
                        }
                    }
                    None => pass_over_one(property, values)
                        .map_err(|stop| stop.or(|| ended(element, row, values)))?,
                }
            }
            self.vertices.push(vertex);
        }
        Ok(())
    }

    /// Reads polygons or triangle strips.
    fn read_faces(&mut self, element: &Element, values: &mut impl Values) -> Result<(), ContentError> {
        let found = element.property("vertex_indices").or_else(|| element.property("vertex_index"));
        let place = match found {
            Some((place, property)) if property.length.is_some() && property.scalar.is_integer() => place,
            _ if element.count == 0 => return Ok(()),
            _ => return Err(no_property(element, found, "property vertex_indices", "a list of integers")),
        };
        for row in 0..element.count {
            for (k, property) in element.properties.iter().enumerate() {
                if k != place {
                    pass_over_one(property, values)
                        .map_err(|stop| stop.or(|| ended(element, row, values)))?;
                } else if element.name == "face" {
                    self.face(element, row, property, values)?;
                } else {
                    self.strips(element, row, property, values)?;
                }
            }
        }
        Ok(())
    }

    /// Reads the corners of a polygon.
    #[inline]
    fn face(
        &mut self,
        element: &Element,
        row: u64,
        list: &Property,
        values: &mut impl Values,
    ) -> Result<(), ContentError> {
        let count = length(list, values).map_err(|stop| stop.or(|| ended(element, row, values)))?;
        if count < 3 {
            let (value, place) = values.last(format!("face {row}"));
            let (what, rule) = ("the number of a face's corners", "3 or more");
            return Err(ContentError::new(ContentErrorKind::value(what, value, rule), place));
        }
        self.corners.clear();
        for k in 0..count {
            let index = item(element, row, list, [count, k], values)?;
            self.corners.push(self.vertex(index).ok_or_else(|| self.no_vertex(element, row, index, values))?);
        }
        match *self.corners.as_slice() {
            [a, b, c] => self.triangles.push([a, b, c]),
            _ => self.polygons.split(&self.vertices, &self.corners, &mut self.triangles),
        }
        Ok(())
    }

    /// Reads triangle strips with −1 between them. Each corner forms a triangle with the two before
    /// it; every second triangle is reversed. Degenerate triangles with equal corners are skipped.
    fn strips(
        &mut self,
        element: &Element,
        row: u64,
        list: &Property,
        values: &mut impl Values,
    ) -> Result<(), ContentError> {
        let count = length(list, values).map_err(|stop| stop.or(|| ended(element, row, values)))?;
        let (mut before, mut corners) = ([0; 2], 0_usize);
        for k in 0..count {
            let index = item(element, row, list, [count, k], values)?;
            if index == -1 {
                corners = 0;
                continue;
            }
            let c = self.vertex(index).ok_or_else(|| self.no_vertex(element, row, index, values))?;
            let [a, b] = before;
            if corners >= 2 && a != b && b != c && c != a {
                self.triangles.push(if corners % 2 == 0 { [a, b, c] } else { [b, a, c] });
            }
            (before, corners) = ([b, c], corners + 1);
        }
        Ok(())
    }

    #[inline]
    fn vertex(&self, index: i64) -> Option<u32> {
        parts::index(index, self.vertices.len())
    }

    #[cold]
    fn no_vertex(&self, element: &Element, row: u64, index: i64, values: &impl Values) -> ContentError {
        let (_, place) = values.last(format!("{} {row}", element.name));
        let kind = ContentErrorKind::index("vertex", index, self.vertices.len());
        ContentError::new(kind, place).hint("indices start at 0")
    }
}

/// Skips all values of an element.
fn pass_over(element: &Element, values: &mut impl Values) -> Result<(), ContentError> {
    if element.properties.is_empty() {
        return Ok(());
    }
    for row in 0..element.count {
        for property in &element.properties {
            pass_over_one(property, values).map_err(|stop| stop.or(|| ended(element, row, values)))?;
        }
    }
    Ok(())
}

fn pass_over_one(property: &Property, values: &mut impl Values) -> Result<(), Stop> {
    let count = if property.length.is_some() { length(property, values)? } else { 1 };
    values.skip(property.scalar, count)
}

/// Reads the length of a list.
#[inline]
fn length(list: &Property, values: &mut impl Values) -> Result<u64, Stop> {
    let length = values.integer(list.length.unwrap_or(list.scalar))?;
    u64::try_from(length).map_err(|_| {
        let (value, place) = values.last(format!("the list {}", list.name));
        let (what, rule) = ("the length of a list", "0 or more");
        Stop::Wrong(ContentError::new(ContentErrorKind::value(what, value, rule), place))
    })
}

/// Reads index k of `count` in a list.
#[inline]
fn item(
    element: &Element,
    row: u64,
    list: &Property,
    [count, k]: [u64; 2],
    values: &mut impl Values,
) -> Result<i64, ContentError> {
    values.integer(list.scalar).map_err(|stop| {
        let place = || values.last(format!("{} {row}", element.name)).1;
        stop.or(|| values::short("corners".to_owned(), count, k, place()))
    })
}

/// Returns the error for a file that ends within an element.
#[cold]
fn ended(element: &Element, row: u64, values: &impl Values) -> ContentError {
    let (_, place) = values.last(format!("{} {row}", element.name));
    values::short(element.plural(), element.count, row, place)
}

/// Returns the error for a property that is missing or has the wrong type.
fn no_property(element: &Element, found: Option<(usize, &Property)>, what: &str, rule: &str) -> ContentError {
    let name = &element.name;
    match found {
        None => ContentErrorKind::missing(format!("{what} of the element {name}")).at(element.span.clone()),
        Some((_, property)) => {
            let value = if property.length.is_some() { "a list" } else { "a number" };
            let integer = if property.scalar.is_integer() { "integer" } else { "floating-point" };
            let value = format!("{value} of {integer} type");
            let (what, rule) = (format!("{what} of the element {name}"), rule);
            let place = ContentPlace::Text(property.span.clone());
            ContentError::new(ContentErrorKind::value(what, value, rule), place)
        }
    }
}
