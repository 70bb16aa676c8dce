//! Shapes of the body for display: its parts at their places, relative to the reference point.

use polhode::body::mesh::TriangleMesh;
use polhode::body::{BodyPart, Form, Particle, PlacedForm, PrincipalFrame};
use polhode::math::{Body, Direction, Part, Position};
use polhode_document::json::numbers;
use polhode_document::number::{count, number};
use serde_json::{Value, json};

use super::atoms;
use super::decimate::decimated;
use super::outline;
use super::packed::{f32s, u32s};
use super::placed::{THIN, at};
use super::surface;
use super::turning::{Turning, ellipsoid};

/// Largest number of displayed particles of a part; more would be illegible.
const MOST_BALLS: usize = 2_000;

/// Radius of the ball of the heaviest particle, relative to the smallest distance between
/// particles.
const BALL: f64 = 0.2;

const BALL_COLOR: &str = "#4477aa";

/// Remaining bytes for meshes, and notes on simplifications.
#[derive(Debug)]
pub(crate) struct Budget {
    bytes: usize,
    notes: Vec<String>,
}

impl Budget {
    pub(crate) const fn new(bytes: usize) -> Self {
        Self { bytes, notes: Vec::new() }
    }

    /// Returns the notes on simplified or omitted parts.
    pub(crate) fn notes(&self) -> &[String] {
        &self.notes
    }

    /// Returns the number of triangles of a part that are displayed, for `of` in the part and `all`
    /// in the body.
    fn share(&self, of: usize, all: usize) -> usize {
        /// Size of a triangle with its share of vertices, half a vertex, in base64.
        const TRIANGLE: usize = 24;
        let most = self.bytes / TRIANGLE;
        if all <= most { of } else { (most as f64 * (of as f64 / all as f64)) as usize }
    }
}

/// Returns the shapes of all parts.
///
/// If no shape is known, the result is the contact surface, if there is one.
pub(crate) fn json(turning: &Turning<'_>, budget: &mut Budget) -> Value {
    let triangles = turning.parts.iter().map(triangles).sum();
    if !surface::has_forms(turning.parts) {
        return turning.surface.iter().filter_map(|own| surface::shape(own, turning.point)).collect();
    }
    turning.parts.iter().filter_map(|part| shape(part, turning, triangles, budget)).collect()
}

/// Returns true if the body has a mesh, which a page may have to simplify.
pub(crate) fn has_triangles(turning: &Turning<'_>) -> bool {
    turning.parts.iter().any(|part| triangles(part) > 0)
}

fn triangles(part: &BodyPart) -> usize {
    match &part.form {
        Some(PlacedForm { form: Form::Mesh(mesh), .. }) => mesh.triangles().len(),
        _ => 0,
    }
}

/// Returns the shape of a part; `None` for a point, or if a number is too large.
fn shape(part: &BodyPart, turning: &Turning<'_>, triangles: usize, budget: &mut Budget) -> Option<Value> {
    held(match &part.form {
        Some(PlacedForm { form: Form::Molecule(symbols), .. }) => atoms::balls(part, symbols, turning.point)?,
        Some(placed) => {
            let of = self::triangles(part);
            let (shape, coarser) = of_form(placed, &part.name, turning.point, budget.share(of, triangles))?;
            if let Some(shown) = coarser {
                let [shown, of] = [shown, of].map(|n| count(n as u64));
                budget.notes.push(format!("{}: {shown} of {of} triangles, simplified", part.name));
            }
            shape
        }
        None if part.particles.is_empty() => of_moments(part, turning),
        None => balls(part, turning, budget)?,
    })
}

/// Returns the shape if all its numbers are finite.
fn held(shape: Value) -> Option<Value> {
    let numbers_hold = |value: &Value| value.as_f64().is_none_or(f64::is_finite);
    shape.as_object()?.values().all(numbers_hold).then_some(shape)
}

/// Returns a form at its place as a `Shape` of `viewer/src/data.ts`, with at most `most` triangles.
///
/// `None` for a molecule, or if a number is too large.
pub fn shape_of(placed: &PlacedForm, name: &str, most: usize) -> Option<Value> {
    held(of_form(placed, name, Position::ZERO, most)?.0)
}

/// Returns the shape of a form, relative to a point.
///
/// The second value is the number of displayed triangles of a simplified mesh; else `None`.
fn of_form(
    placed: &PlacedForm,
    name: &str,
    point: Position<Body>,
    most: usize,
) -> Option<(Value, Option<usize>)> {
    let mut coarser = None;
    let mut middle = Position::<Part>::ZERO;
    let own = match &placed.form {
        Form::Box { size } => json!({ "kind": "box", "size": numbers(size) }),
        Form::Plate { size: [a, b] } => {
            json!({ "kind": "box", "size": numbers(&[*a, *b, THIN * a.min(*b)]) })
        }
        Form::Ellipsoid { semi_axes } => json!({ "kind": "ellipsoid", "half": numbers(semi_axes) }),
        // The cavity is invisible from outside.
        Form::HollowSphere { radius, .. } => json!({ "kind": "ellipsoid", "half": numbers(&[*radius; 3]) }),
        Form::Cylinder { radius, inner_radius, length } => cylinder(*radius, *inner_radius, *length),
        Form::Rod { length } => cylinder(0.5 * THIN * length, 0.0, *length),
        Form::Disk { radius } => cylinder(*radius, 0.0, THIN * radius),
        Form::Cone { base_radius, top_radius, height }
        | Form::ConeShell { base_radius, top_radius, height, ends: true } => {
            middle = Position::new(0.0, 0.0, 0.5 * height);
            json!({ "kind": "cone", "bottom": base_radius, "top": top_radius, "height": height })
        }
        Form::Capsule { radius, length } => json!({ "kind": "capsule", "radius": radius, "height": length }),
        Form::Torus { ring_radius, tube_radius } => {
            json!({ "kind": "torus", "radius": ring_radius, "tube": tube_radius })
        }
        Form::ConeShell { base_radius, top_radius, height, ends: false } => {
            let wall = outline::cone_wall(*base_radius, *top_radius, *height);
            middle = Position::new(0.0, 0.0, 0.5 * height);
            triangles_json(&wall, middle, wall.triangles().len())?
        }
        Form::TriangularPrism { vertices, length } => {
            let prism = outline::prism(*vertices, *length);
            middle = Position::from_array(middle_of(&prism)?);
            triangles_json(&prism, middle, prism.triangles().len())?
        }
        Form::Mesh(mesh) => {
            middle = Position::from_array(middle_of(mesh)?);
            let fewer = (mesh.triangles().len() > most).then(|| decimated(mesh, most));
            coarser = fewer.as_ref().map(|fewer| fewer.triangles().len());
            triangles_json(fewer.as_ref().unwrap_or(mesh), middle, mesh.triangles().len())?
        }
        _ => return None,
    };
    let place = placed.position + placed.rotation * middle - point;
    Some((at(own, name, place.to_array(), placed.rotation.canonical_quaternion()), coarser))
}

fn cylinder(radius: f64, inner: f64, height: f64) -> Value {
    json!({ "kind": "cylinder", "radius": radius, "inner": inner, "height": height })
}

/// Returns a mesh relative to its middle, for the accuracy of f32; `of` is its full number of
/// triangles.
fn triangles_json(shown: &TriangleMesh, middle: Position<Part>, of: usize) -> Option<Value> {
    let vertices: Vec<f32> = shown
        .coordinates()
        .iter()
        .flat_map(|vertex| (Position::<Part>::from_array(*vertex) - middle).to_array())
        .map(|x| x as f32)
        .collect();
    let numbers_hold = vertices.iter().all(|x| x.is_finite()) && !shown.triangles().is_empty();
    numbers_hold.then(|| {
        json!({
            "kind": "mesh",
            "vertices": f32s(vertices),
            "triangles": u32s(shown.triangles().iter().flatten().copied()),
            "of": of,
        })
    })
}

/// Returns the centre of the bounding box of a mesh.
fn middle_of(mesh: &TriangleMesh) -> Option<[f64; 3]> {
    let mut corners = mesh.corners().flatten();
    let first = corners.next()?;
    let [low, high] = corners.fold([first; 2], |[low, high], p| {
        [std::array::from_fn(|k| low[k].min(p[k])), std::array::from_fn(|k| high[k].max(p[k]))]
    });
    Some(std::array::from_fn(|k| low[k] + 0.5 * (high[k] - low[k])))
}

/// Returns the uniform ellipsoid with the same mass and tensor.
fn of_moments(part: &BodyPart, turning: &Turning<'_>) -> Value {
    let principal = PrincipalFrame::of(part.properties.inertia());
    let half = ellipsoid(principal.moments(), part.properties.mass());
    let place = part.properties.center_of_mass() - turning.point;
    let own = json!({ "kind": "ellipsoid", "half": numbers(&half) });
    at(own, &part.name, place.to_array(), principal.rotation().canonical_quaternion())
}

/// Returns particles as balls with volumes proportional to their masses, connected by sticks of
/// minimal total length.
fn balls(part: &BodyPart, turning: &Turning<'_>, budget: &mut Budget) -> Option<Value> {
    let all = part.particles.len();
    let stride = all.div_ceil(MOST_BALLS).max(1);
    let shown: Vec<_> = part.particles.iter().step_by(stride).collect();
    if shown.len() < all {
        let [shown, all] = [shown.len(), all].map(|n| count(n as u64));
        budget.notes.push(format!("{}: {shown} of {all} particles", part.name));
    }
    let places: Vec<[f64; 3]> = shown.iter().map(|p| (p.position() - turning.point).to_array()).collect();
    let sticks = sticks(&places);
    let nearest = sticks.iter().map(|stick| stick.length).filter(|l| *l > 0.0).reduce(f64::min);
    let alone = || places.iter().map(|p| 0.3 * length(*p)).find(|l| *l > 0.0).unwrap_or(1.0);
    let largest = BALL * nearest.unwrap_or_else(alone);
    let heaviest = shown.iter().map(|p| p.mass()).fold(0.0, f64::max);
    let radius = |p: &&Particle<_>| (largest * (p.mass() / heaviest).cbrt().max(0.3)) as f32;
    let (centers, radii): (Vec<f32>, Vec<f32>) =
        (places.iter().flatten().map(|&x| x as f32).collect(), shown.iter().map(radius).collect());
    if !centers.iter().chain(&radii).all(|x| x.is_finite()) {
        return None;
    }
    let label =
        |p: &&Particle<_>| polhode_document::layout::plain_spaces(&format!("{} kg", number(p.mass(), 4)));
    let own = json!({
        "kind": "balls",
        "centers": f32s(centers),
        "radii": f32s(radii),
        "colors": vec![BALL_COLOR; shown.len()],
        "labels": shown.iter().map(label).collect::<Vec<_>>(),
        "sticks": sticks.iter().map(|stick| json!(stick.ends)).collect::<Value>(),
    });
    Some(at(own, &part.name, [0.0; 3], [1.0, 0.0, 0.0, 0.0]))
}

/// Stick between two places.
struct Stick {
    ends: [usize; 2],
    length: f64,
}

/// Returns the minimum spanning tree of all places, by Prim's algorithm.
fn sticks(places: &[[f64; 3]]) -> Vec<Stick> {
    // Places not yet in the tree, each with the shortest stick to it.
    let mut open: Vec<(usize, Stick)> = match places {
        [first, others @ ..] => others
            .iter()
            .enumerate()
            .map(|(k, p)| (k + 1, Stick { ends: [0, k + 1], length: distance(*first, *p) }))
            .collect(),
        [] => Vec::new(),
    };
    let mut sticks = Vec::with_capacity(open.len());
    while let Some(nearest) = (0..open.len()).min_by(|&a, &b| open[a].1.length.total_cmp(&open[b].1.length)) {
        let (joined, stick) = open.swap_remove(nearest);
        sticks.push(stick);
        for (k, best) in &mut open {
            let length = distance(places[joined], places[*k]);
            if length < best.length {
                *best = Stick { ends: [joined, *k], length };
            }
        }
    }
    sticks
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    length(std::array::from_fn(|k| a[k] - b[k]))
}

fn length(v: [f64; 3]) -> f64 {
    Direction::<Part>::from_array(v).norm()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_shortest_sticks_join_everything() {
        let places = [[0.0; 3], [5.0, 0.0, 0.0], [1.0, 0.0, 0.0], [5.0, 2.0, 0.0], [2.5, 0.0, 0.0]];
        let mut found: Vec<_> = sticks(&places).iter().map(|stick| stick.ends).collect();
        found.sort_unstable();
        assert_eq!(found, [[0, 2], [1, 3], [2, 4], [4, 1]]);
        assert!(sticks(&[]).is_empty() && sticks(&places[..1]).is_empty());
    }

    #[test]
    fn triangles_share_what_there_is() {
        let budget = Budget::new(24_000);
        assert_eq!(budget.share(300, 900), 300);
        assert_eq!(budget.share(3_000, 4_000), 750);
    }
}
