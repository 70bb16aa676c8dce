//! Geometries: positions and faces.

use polhode_source::xml::Element;
use polhode_source::{ContentError, ContentErrorKind};

use super::library::Library;
use super::value::{count, declared, expected, finite, missing, start, unsupported, whole};
use crate::mesh::parts::index;
use crate::mesh::polygon::Polygons;

/// Mesh as in the file, before it is placed.
#[derive(Debug, Default)]
pub(crate) struct Surface {
    pub vertices: Vec<[f64; 3]>,
    /// Triangles; empty if the geometry has only lines.
    pub triangles: Vec<[u32; 3]>,
}

/// Connection of the corners in a `<p>`.
#[derive(Clone, Copy)]
enum Joining<'a> {
    Triangles,
    /// Polygons with the numbers of corners in this list.
    List(&'a str),
    Polygon,
    Strip,
    Fan,
}

impl Surface {
    pub(crate) fn of<'a>(
        geometry: Element<'a>,
        library: &Library<'a>,
        polygons: &mut Polygons,
    ) -> Result<Self, ContentError> {
        let mesh = geometry.child("mesh").ok_or_else(|| missing("mesh", geometry))?;
        let (mut surface, mut has_lines) = (None, false);
        for faces in mesh.children() {
            let joining = match faces.name() {
                "triangles" => Joining::Triangles,
                "polylist" => Joining::List(faces.child_text("vcount").map_or("", |counts| counts.value)),
                "polygons" => Joining::Polygon,
                "tristrips" => Joining::Strip,
                "trifans" => Joining::Fan,
                "lines" | "linestrips" => {
                    has_lines = true;
                    continue;
                }
                _ => continue, // sources
            };
            let corners = Corners::of(faces)?;
            let vertices = library.named(corners.input, "source", "vertices")?;
            // All faces of a mesh share the same vertices.
            let (known, surface) = match &mut surface {
                Some((known, surface)) => (*known, surface),
                none => {
                    let vertices_of = Self { vertices: positions(vertices, library)?, triangles: Vec::new() };
                    let (_, surface) = none.insert((vertices.span().start, vertices_of));
                    (vertices.span().start, surface)
                }
            };
            if known != vertices.span().start {
                return Err(unsupported(faces, " with other vertices than those of the faces before it"));
            }
            surface.join(faces, &corners, joining, polygons)?;
        }
        match surface {
            Some((_, surface)) => Ok(surface),
            None if has_lines => Ok(Self::default()),
            None => Err(missing("triangles", geometry)),
        }
    }

    fn join(
        &mut self,
        faces: Element<'_>,
        corners: &Corners<'_>,
        joining: Joining<'_>,
        polygons: &mut Polygons,
    ) -> Result<(), ContentError> {
        let Self { vertices, triangles } = self;
        let short = |list| missing("corner of the last face", list);
        let mut present = 0;
        let mut sizes =
            if let Joining::List(counts) = joining { counts } else { "" }.split_ascii_whitespace();
        for child in faces.children() {
            let list = match child.name() {
                "p" => child,
                "ph" => return Err(unsupported(child, ", polygons with holes")),
                _ => continue,
            };
            let corners = corners.read(list, vertices.len())?;
            match joining {
                Joining::Triangles => {
                    let (all, []) = corners.as_chunks::<3>() else { return Err(short(list)) };
                    triangles.extend_from_slice(all);
                    present += all.len();
                }
                Joining::List(_) => {
                    let mut rest = corners.as_slice();
                    while !rest.is_empty() {
                        let size = sizes.next().ok_or_else(|| short(list))?;
                        let Some(size) = size.parse().ok().filter(|size| *size > 0) else {
                            return Err(no_size(faces, present));
                        };
                        let (face, later) = rest.split_at_checked(size).ok_or_else(|| short(list))?;
                        polygons.split(vertices, face, triangles);
                        rest = later;
                        present += 1;
                    }
                }
                Joining::Polygon => {
                    polygons.split(vertices, &corners, triangles);
                    present += 1;
                }
                Joining::Strip | Joining::Fan => {
                    if corners.len() < 3 {
                        return Err(short(list));
                    }
                    triangles.extend((0..corners.len() - 2).map(|i| {
                        let order = match joining {
                            // Every second triangle of a strip has the opposite winding.
                            Joining::Strip => [i, i + 1 + i % 2, i + 2 - i % 2],
                            _ => [0, i + 1, i + 2],
                        };
                        order.map(|k| corners[k])
                    }));
                    present += 1;
                }
            }
        }
        let unused = sizes.count();
        if unused > 0 {
            return Err(count(faces, "faces of <vcount>", present + unused, present));
        }
        declared(faces, "faces", present)
    }
}

/// Returns the error for an invalid number in `<vcount>`.
fn no_size(faces: Element<'_>, face: usize) -> ContentError {
    let number = faces.child_text("vcount").and_then(|counts| counts.numbers().nth(face));
    match number {
        Some(number) => expected("the count of a face's corners", &number.text, number.span),
        None => missing("vcount", faces),
    }
}

/// Layout of the vertex indices in a `<p>`.
struct Corners<'a> {
    input: Element<'a>,
    offset: usize,
    stride: usize,
}

impl<'a> Corners<'a> {
    fn of(faces: Element<'a>) -> Result<Self, ContentError> {
        let (mut vertex, mut last) = (None, 0);
        for input in faces.named("input") {
            let offset = whole(input, "offset", 0)?;
            last = last.max(offset);
            if input.word("semantic") == Some("VERTEX") {
                vertex = vertex.or(Some((input, offset)));
            }
        }
        let (input, offset) = vertex.ok_or_else(|| missing("input of vertices", faces))?;
        Ok(Self { input, offset, stride: last.saturating_add(1) })
    }

    fn read(&self, list: Element<'_>, vertices: usize) -> Result<Vec<u32>, ContentError> {
        let Some(written) = list.text() else { return Ok(Vec::new()) };
        let words = || written.value.split_ascii_whitespace();
        let numbers = words().count();
        if !numbers.is_multiple_of(self.stride) {
            let (what, value) = ("the count of the indices", numbers.to_string());
            let rule = format!("a multiple of {}, as the inputs have it", self.stride);
            return Err(ContentError::new(ContentErrorKind::value(what, value, rule), start(list)));
        }
        let all = words().skip(self.offset).step_by(self.stride);
        let corner = |word: &str| word.parse().ok().and_then(|corner| index(corner, vertices));
        let corners: Vec<u32> = all.clone().map_while(corner).collect();
        if corners.len() * self.stride == numbers {
            return Ok(corners);
        }
        let wrong = written.numbers().nth(self.offset + corners.len() * self.stride);
        let Some(wrong) = wrong else { return Err(missing("vertex of that number", list)) };
        match wrong.text.parse() {
            Ok(index) => Err(ContentErrorKind::index("vertex", index, vertices).at(wrong.span)),
            Err(_) => Err(expected("the number of a vertex", &wrong.text, wrong.span)),
        }
    }
}

/// Returns the positions of `<vertices>` from their source.
fn positions<'a>(vertices: Element<'a>, library: &Library<'a>) -> Result<Vec<[f64; 3]>, ContentError> {
    let position = vertices.named("input").find(|input| input.word("semantic") == Some("POSITION"));
    let position = position.ok_or_else(|| missing("positions", vertices))?;
    let source = library.named(position, "source", "source")?;
    let accessor = source.child("technique_common").and_then(|technique| technique.child("accessor"));
    let array = match accessor {
        Some(accessor) if accessor.word("source").is_some() => {
            library.named(accessor, "source", "float_array")?
        }
        _ => source.child("float_array").ok_or_else(|| missing("float_array", source))?,
    };
    let values = finite(&array.text().ok_or_else(|| missing("numbers", array))?)?;
    declared(array, "numbers of <float_array>", values.len())?;
    let of = |name: &str, default| accessor.map_or(Ok(default), |accessor| whole(accessor, name, default));
    let (stride, offset) = (of("stride", 3)?, of("offset", 0)?);
    let columns = accessor.map_or(Ok([0, 1, 2]), columns)?;
    if stride <= columns[2] {
        return Err(missing("three coordinates", source));
    }
    let values = values.get(offset..).unwrap_or_default();
    let coordinates = |point: &[f64]| {
        let [x, y, z] = columns.map(|column| point.get(column).copied());
        Some([x?, y?, z?])
    };
    let mut points: Vec<[f64; 3]> = values.chunks(stride).filter_map(coordinates).collect();
    if let Some(accessor) = accessor {
        let wanted = whole(accessor, "count", points.len())?;
        if wanted > points.len() {
            return Err(count(accessor, "points", wanted, points.len()));
        }
        points.truncate(wanted);
    }
    Ok(points)
}

/// Returns the columns of the coordinates in the source. Parameters without a name are skipped.
fn columns(accessor: Element<'_>) -> Result<[usize; 3], ContentError> {
    let names = || accessor.named("param").map(|param| param.word("name").unwrap_or(""));
    if names().next().is_none() {
        return Ok([0, 1, 2]);
    }
    let mut named = names().enumerate().filter(|(_, name)| !name.is_empty());
    let mut column = |axis: &str| {
        named.next().filter(|(_, name)| name.eq_ignore_ascii_case(axis)).map(|(column, _)| column)
    };
    match (column("X"), column("Y"), column("Z")) {
        (Some(x), Some(y), Some(z)) => Ok([x, y, z]),
        _ => Err(unsupported(accessor, " whose first parameters are not X, Y and Z")),
    }
}
