//! `Mesh` prims of USD, compared with the signed tetrahedra of their placed polygons.

use std::path::Path;
use std::sync::Arc;

use polhode::body::mesh::ClosedMesh;
use polhode_robot::finding::Severity;
use polhode_robot::geometry::{Shapes, Volume, VolumeKind};
use polhode_robot::inertials::{InertialsRequest, Outcome, write_inertials};
use polhode_robot::inspect::inspect;
use polhode_robot::model::{Geometry, GeometryShape, InlineMesh, RobotModel, Role};
use polhode_robot::read::{ReadOptions, read_model};
use polhode_shape::mesh::obj;
use polhode_source::files::Memory;

use crate::common::{
    Folder, Matrix, applied, assert_close, assert_near, matrix_about, matrix_about_axis, plus, read, times,
    transposed,
};

/// Outline of an L, counter-clockwise, cm. The prism on it has six corners in each of two faces.
const OUTLINE: [[f64; 2]; 6] =
    [[-3.1, -2.2], [4.2, -2.4], [4.5, -0.7], [-1.2, -0.4], [-1.0, 3.6], [-3.3, 3.9]];

fn corners() -> Vec<[f64; 3]> {
    let low = OUTLINE.iter().map(|[x, y]| [*x, *y, 0.3]);
    low.chain(OUTLINE.iter().map(|[x, y]| [x + 0.4, y - 0.3, 2.9])).collect()
}

/// Returns the polygons of the prism, counter-clockwise seen from outside.
fn faces() -> Vec<Vec<usize>> {
    let sides = (0..6).map(|k| vec![k, (k + 1) % 6, 6 + (k + 1) % 6, 6 + k]);
    [vec![5, 4, 3, 2, 1, 0], vec![6, 7, 8, 9, 10, 11]].into_iter().chain(sides).collect()
}

fn list<T: ToString>(all: impl IntoIterator<Item = T>) -> String {
    all.into_iter().map(|one| one.to_string()).collect::<Vec<_>>().join(", ")
}

/// Returns the lines of a mesh, and more lines.
fn arrays(points: &[[f64; 3]], faces: &[Vec<usize>], more: &str) -> String {
    format!(
        "int[] faceVertexCounts = [{}]\nint[] faceVertexIndices = [{}]\npoint3f[] points = [{}]\n{more}\n",
        list(faces.iter().map(Vec::len)),
        list(faces.concat()),
        list(points.iter().map(|p| format!("({})", list(*p))))
    )
}

/// Returns the lines of the prism.
fn prism(more: &str) -> String {
    arrays(&corners(), &faces(), more)
}

/// Returns the text of a body in centimetres with lines of its own, around a prim.
fn layer(body: &str, inner: &str) -> String {
    format!(
        "#usda 1.0\n(\n    metersPerUnit = 0.01\n)\ndef Xform \"r\"\n{{\n    def Xform \"a\" (\n        prepend apiSchemas = [\"PhysicsRigidBodyAPI\", \"PhysicsMassAPI\"]\n    )\n    {{\n        \
         float physics:mass = 0.17\n{body}\n{inner}\n    }}\n}}\n"
    )
}

fn mesh(lines: &str) -> String {
    format!("def Mesh \"m\"\n{{\n{lines}}}\n")
}

fn collider(lines: &str, approximation: &str) -> String {
    format!(
        "def Mesh \"m\" (\n    prepend apiSchemas = [\"PhysicsCollisionAPI\", \"PhysicsMeshCollisionAPI\"]\n)\n{{\nuniform token physics:approximation = \"{approximation}\"\n{lines}}}\n"
    )
}

fn only(model: &RobotModel) -> &Geometry {
    let [geometry] = model.links[0].geometry.as_slice() else {
        panic!("{:?}", model.links[0].geometry.len())
    };
    geometry
}

fn measured(text: &str) -> Result<Volume, String> {
    Shapes::default().geometry(only(&read(text)))
}

fn inline(geometry: &Geometry) -> Arc<InlineMesh> {
    match &geometry.shape {
        GeometryShape::Inline { mesh: Ok(mesh), .. } => Arc::clone(mesh),
        other => panic!("{other:?}"),
    }
}

/// Volume, centre, and tensor about the centre.
type Moments = (f64, [f64; 3], Matrix);

/// Sums the tetrahedra of fans to the origin: ∫x xᵀ dV = V/20 (s sᵀ + Σ p pᵀ), s = a + b + c.
fn summed(points: &[[f64; 3]], faces: &[Vec<usize>]) -> Moments {
    let (mut volume, mut first, mut second) = (0.0, [0.0; 3], [[0.0; 3]; 3]);
    for face in faces {
        for k in 1..face.len() - 1 {
            let [a, b, c] = [face[0], face[k], face[k + 1]].map(|k| points[k]);
            let cross = [b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2], b[0] * c[1] - b[1] * c[0]];
            let own = (0..3).map(|k| a[k] * cross[k]).sum::<f64>() / 6.0;
            let s = plus(a, plus(b, c));
            volume += own;
            first = plus(first, s.map(|x| 0.25 * own * x));
            for i in 0..3 {
                for j in 0..3 {
                    second[i][j] += own / 20.0 * (s[i] * s[j] + a[i] * a[j] + b[i] * b[j] + c[i] * c[j]);
                }
            }
        }
    }
    let center = first.map(|x| x / volume);
    for (i, row) in second.iter_mut().enumerate() {
        (0..3).for_each(|j| row[j] -= volume * center[i] * center[j]);
    }
    let trace: f64 = (0..3).map(|k| second[k][k]).sum();
    let one = |i, j| if i == j { trace } else { 0.0 };
    let sign = volume.signum();
    let tensor = std::array::from_fn(|i| std::array::from_fn(|j| sign * (one(i, j) - second[i][j])));
    (volume.abs(), center, tensor)
}

#[track_caller]
fn require(volume: &Volume, (size, center, tensor): Moments, tolerance: f64) {
    assert!((volume.volume / size - 1.0).abs() < tolerance, "{} {size}", volume.volume);
    assert_close(volume.centroid, center, tolerance);
    let scale = (0..3).map(|k| tensor[k][k]).fold(0.0, f64::max);
    let of = |m: &Matrix| m.map(|row| row.map(|x| x / scale));
    assert_near(&of(&volume.tensor_per_density), &of(&tensor), tolerance);
}

/// Returns the prism, in m, in the body's frame, by a function from the points of the prim.
fn placed(place: impl Fn([f64; 3]) -> [f64; 3]) -> Moments {
    let points: Vec<_> = corners().into_iter().map(|p| place(p).map(|c| 0.01 * c)).collect();
    summed(&points, &faces())
}

#[test]
fn transforms_are_exact() {
    let order = |names: &str| format!("uniform token[] xformOpOrder = [{names}]\n");
    let turn = times(
        times(matrix_about(0, 15_f64.to_radians()), matrix_about(1, (-70_f64).to_radians())),
        matrix_about(2, 33_f64.to_radians()),
    );
    let scaled = |[x, y, z]: [f64; 3]| [[x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, z]];
    let shear = [[1.1, 0.5, -0.2], [0.2, 0.9, 0.4], [-0.3, 0.1, 1.4]];
    let matrix = "matrix4d xformOp:transform = ((1.1, 0.2, -0.3, 0), (0.5, 0.9, 0.1, 0), (-0.2, 0.4, 1.4, 0), (-25, 14, -8, 1))\n";
    let turned = "float3 xformOp:rotateZYX = (15, -70, 33)\ndouble3 xformOp:translate = (3.3, -1.1, 6)\n";
    let both = "\"xformOp:translate\", \"xformOp:rotateZYX\", \"xformOp:scale\"";
    let scale = |x: &str| format!("{turned}double3 xformOp:scale = ({x})\n{}", order(both));
    let sheared = matrix.to_owned() + &order("\"xformOp:transform\"");
    let unsheared =
        "matrix4d xformOp:transform = ((-1.1, 0.2, -0.3, 0), (0.5, 0.9, 0.1, 0), (-0.2, 0.4, 1.4, 0), (-25, 14, -8, 1))\n"
            .to_owned()
            + &order("\"xformOp:transform\"");
    let mut mirror_and_shear = shear;
    (0..3).for_each(|k| mirror_and_shear[k][0] = [-1.1, 0.2, -0.3][k]);
    for (lines, linear, shift) in [
        (String::new(), scaled([1.0; 3]), [0.0; 3]),
        (scale("1.3, 1.3, 1.3"), times(turn, scaled([1.3; 3])), [3.3, -1.1, 6.0]),
        (scale("1.3, 0.8, 2.1"), times(turn, scaled([1.3, 0.8, 2.1])), [3.3, -1.1, 6.0]),
        (scale("-1.3, 0.8, 2.1"), times(turn, scaled([-1.3, 0.8, 2.1])), [3.3, -1.1, 6.0]),
        (scale("-1.3, -0.8, -2.1"), times(turn, scaled([-1.3, -0.8, -2.1])), [3.3, -1.1, 6.0]),
        (sheared, shear, [-25.0, 14.0, -8.0]),
        (unsheared, mirror_and_shear, [-25.0, 14.0, -8.0]),
    ] {
        let own = |p| plus(applied(linear, p), shift);
        let volume = measured(&layer("", &mesh(&prism(&lines)))).unwrap();
        assert_eq!(volume.kind, VolumeKind::Closed, "{lines}");
        require(&volume, placed(own), 1e-12);
        // A scaled frame between the body and the mesh shears it. The body is turned in the stage.
        let between = format!(
            "def Xform \"f\"\n{{\ndouble3 xformOp:scale = (0.7, 1.9, -1.2)\n{}{}}}\n",
            order("\"xformOp:scale\""),
            mesh(&prism(&lines))
        );
        let body = "quatd xformOp:orient = (0.8, 0.2, -0.4, 0.4)\ndouble3 xformOp:translate = (5, -2, 9)\n"
            .to_owned()
            + &order("\"xformOp:translate\", \"xformOp:orient\"");
        let volume = measured(&layer(&body, &between)).unwrap();
        require(&volume, placed(|p| applied(scaled([0.7, 1.9, -1.2]), own(p))), 1e-12);
        // Scales of the body apply to the mesh, in the body's axes.
        let text = layer(
            &format!("quatd xformOp:orient = (0.8, 0.2, -0.4, 0.4)\n{}", order("\"xformOp:orient\"")),
            &mesh(&prism(&lines)),
        );
        let text = text.replace(
            "def Xform \"r\"\n{",
            &format!(
                "def Xform \"r\"\n{{\ndouble3 xformOp:scale = (2, 2, 2)\n{}",
                order("\"xformOp:scale\"")
            ),
        );
        require(&measured(&text).unwrap(), placed(|p| own(p).map(|c| 2.0 * c)), 1e-12);
    }
    let r = matrix_about_axis([0.2, -0.4, 0.4], 2.0 * 0.8_f64.acos());
    assert_near(&times(r, transposed(r)), &scaled([1.0; 3]), 1e-15);
}

#[test]
fn left_handed_faces_are_turned_and_holes_are_left_out() {
    let turned: Vec<Vec<usize>> = faces().into_iter().map(|face| face.into_iter().rev().collect()).collect();
    let signed = |faces: &[Vec<usize>], more: &str| -> f64 {
        let model = read(&layer("", &mesh(&arrays(&corners(), faces, more))));
        let mesh = inline(only(&model));
        let volume = |[a, b, c]: [[f64; 3]; 3]| {
            a[0] * (b[1] * c[2] - b[2] * c[1])
                + a[1] * (b[2] * c[0] - b[0] * c[2])
                + a[2] * (b[0] * c[1] - b[1] * c[0])
        };
        mesh.surface().corners().map(volume).sum()
    };
    let left = "uniform token orientation = \"leftHanded\"";
    let expected = 6e6 * placed(|p| p).0;
    for (faces, more, sign) in [(faces(), "", 1.0), (turned.clone(), "", -1.0), (turned, left, 1.0)] {
        assert!((signed(&faces, more) / expected - sign).abs() < 1e-13, "{more}");
    }
    // A face in the interior is a hole.
    let mut more = faces();
    more.insert(3, vec![0, 4, 9]);
    let kind = |holes: &str| measured(&layer("", &mesh(&arrays(&corners(), &more, holes)))).unwrap();
    assert_eq!(kind("").kind, VolumeKind::Hull);
    let solid = kind("int[] holeIndices = [3]");
    assert_eq!(solid.kind, VolumeKind::Closed);
    require(&solid, placed(|p| p), 1e-12);
}

#[test]
fn polygons_that_are_not_plane_are_split_as_in_obj() {
    let mut points = corners();
    points.iter_mut().zip([0.11, -0.07, 0.13, 0.02, -0.05, 0.08, -0.12]).for_each(|(p, off)| p[2] += off);
    let mut text: String = points.iter().map(|[x, y, z]| format!("v {x} {y} {z}\n")).collect();
    for face in faces() {
        text += &format!("f {}\n", list(face.iter().map(|k| k + 1)).replace(',', ""));
    }
    let contents = obj::read(text.as_bytes()).unwrap().as_one().unwrap();
    let expected = 1e-6 * ClosedMesh::of(&contents.parts[0].mesh).unwrap().volume();
    let volume = measured(&layer("", &mesh(&arrays(&points, &faces(), "")))).unwrap();
    assert_eq!(volume.kind, VolumeKind::Closed);
    assert!((volume.volume / expected - 1.0).abs() < 1e-12);
}

#[test]
fn wrong_arrays_have_a_reason() {
    let right = prism("");
    let counts = "[6, 6, 4, 4, 4, 4, 4, 4]";
    for (from, to, said) in [
        (
            counts,
            "[6, 6, 4, 4, 4, 4, 4]",
            "faceVertexCounts add up to 32, but faceVertexIndices has 36 numbers",
        ),
        (counts, "[6, 6, 4, 4, 4, 4, 4, 4e18]", "faceVertexCounts add up to"),
        (counts, "[6, 6, 4, 4, 4, 4, 6, 2]", "faceVertexCounts[7] = 2: a face has at least 3 corners"),
        (counts, "[6, 6, 4, -4, 4, 4, 4, 4]", "faceVertexCounts[3] = -4"),
        ("[5, 4, 3", "[5, 12, 3", "faceVertexIndices[1] = 12: indices start at 0, and there are 12 points"),
        ("[5, 4, 3", "[5, -1, 3", "faceVertexIndices[1] = -1"),
        ("[5, 4, 3", "[5, 1.5, 3", "faceVertexIndices[1] = 1.5"),
        ("(4.2, -2.4, 0.3)", "(4.2, -2.4)", "points has 35 numbers, which are not triples"),
        (
            "(4.2, -2.4, 0.3)",
            "(4.2, nan, 0.3)",
            "points[1] = [4.2, NaN, 0.3]: coordinates are finite numbers",
        ),
        ("(4.2, -2.4, 0.3)", "(4.2, 1e999, 0.3)", "points[1] = [4.2, inf, 0.3]"),
        ("(4.2, -2.4, 0.3)", "(4.2, 1e2e3, 0.3)", "points[1] = [4.2, NaN, 0.3]"),
        ("point3f[] points =", "point3f[] other =", "it has no points"),
        ("point3f[] points =", "point3f[] points.timeSamples = { 0: ", "points.timeSamples is not read"),
        ("int[] faceVertexCounts", "int[] holeIndices = [8]\nint[] faceVertexCounts", "holeIndices[0] = 8"),
        (
            "int[] faceVertexCounts",
            "int[] holeIndices = [0, 1, 2, 3, 4, 5, 6, 7]\nint[] faceVertexCounts",
            "no faces",
        ),
        ("int[] faceVertexCounts", "uniform token orientation = \"up\"\nint[] faceVertexCounts", "\"up\""),
    ] {
        assert!(right.contains(from), "{from}");
        let mut lines = right.replacen(from, to, 1);
        if to.ends_with("{ 0: ") {
            lines = lines.trim_end().to_owned() + " }\n";
        }
        let model = read(&layer("", &mesh(&lines)));
        let error = Shapes::default().geometry(only(&model)).unwrap_err();
        assert!(error.starts_with("\"/r/a/m\": ") && error.contains(said), "{said}: {error}");
        let findings = inspect(&model, &Shapes::default()).findings;
        let found = findings.iter().find(|finding| finding.code == "geometry.unreadable").unwrap();
        assert!(found.message.contains(said) && found.severity == Severity::Note, "{}", found.message);
    }
    // Comments do not matter.
    let lines = right.replacen("(4.2, -2.4, 0.3)", "# corner 1\n(4.2, -2.4, 0.3)", 1);
    require(&measured(&layer("", &mesh(&lines))).unwrap(), placed(|p| p), 1e-12);
    // Long arrays of other attributes are skipped.
    let more = format!(
        "normal3f[] normals = [{}] (\n    interpolation = \"faceVarying\"\n)\n",
        "(0, 0, 1), ".repeat(999) + "(0, 0, 1)"
    );
    require(&measured(&layer("", &mesh(&prism(&more)))).unwrap(), placed(|p| p), 1e-12);
}

#[test]
fn an_open_mesh_is_measured_by_its_hull_and_writes_no_inertial() {
    let open: Vec<_> = faces().into_iter().skip(1).collect();
    let text = layer("", &mesh(&arrays(&corners(), &open, "")));
    let volume = measured(&text).unwrap();
    assert_eq!(volume.kind, VolumeKind::Hull);
    require(&volume, hull(), 1e-12);
    assert_eq!(measured(&layer("", &mesh(&prism("")))).unwrap().bounds, volume.bounds);
    let request = InertialsRequest { file: "r.usda".into(), ..InertialsRequest::default() };
    let inertials = write_inertials(&request, &Memory::from([("r.usda", &*text)])).unwrap();
    assert!(matches!(&inertials.links[0].outcome, Outcome::NotWritten { why, .. } if why.contains("/r/a/m")));
}

/// Returns the convex hull of the prism, which has no notch.
fn hull() -> Moments {
    let points: Vec<_> = corners().into_iter().map(|p| p.map(|c| 0.01 * c)).collect();
    let ring = [0, 1, 2, 4, 5];
    let sides = (0..5).map(|k| {
        let [a, b] = [ring[k], ring[(k + 1) % 5]];
        vec![a, b, 6 + b, 6 + a]
    });
    let ends = [ring.iter().rev().copied().collect(), ring.iter().map(|k| 6 + k).collect()];
    summed(&points, &ends.into_iter().chain(sides).collect::<Vec<_>>())
}

#[test]
fn colliders_have_the_shape_of_their_approximation() {
    for approximation in ["none", "convexDecomposition", "meshSimplification", "sdf"] {
        let model = read(&layer("", &collider(&prism(""), approximation)));
        assert_eq!(only(&model).role, Role::Collision);
        require(&Shapes::default().geometry(only(&model)).unwrap(), placed(|p| p), 1e-12);
    }
    let convex = layer("", &collider(&prism(""), "convexHull"));
    let volume = measured(&convex).unwrap();
    assert_eq!(volume.kind, VolumeKind::Hull);
    require(&volume, hull(), 1e-12);
    let solid = Shapes::default().solid(&read(&convex).links[0], Role::Collision).unwrap();
    assert!((solid.volume() / hull().0 - 1.0).abs() < 1e-12);
    // Without the schema, programs ignore the approximation.
    let model = read(&convex.replace(", \"PhysicsMeshCollisionAPI\"", ""));
    require(&Shapes::default().geometry(only(&model)).unwrap(), placed(|p| p), 1e-12);
    for fitted in ["boundingCube", "boundingSphere"] {
        let error = measured(&layer("", &collider(&prism(""), fitted))).unwrap_err();
        assert!(error.contains(&format!("physics:approximation = {fitted} is not measured")), "{error}");
    }
    // The mass of a collider is unknown, as before.
    let model = read(&layer("", &collider(&prism(""), "none")).replace("float physics:mass = 0.17", ""));
    let why = model.links[0].computed.clone().unwrap().unwrap_err();
    assert!(why.contains("/r/a/m: a physics engine computes the mass of a mesh"), "{why}");
}

#[test]
fn guides_are_not_geometry_unless_they_are_colliders() {
    let in_scope = |inner: &str, purpose: &str| {
        layer("", &format!("def Scope \"s\"\n{{\nuniform token purpose = \"{purpose}\"\n{inner}}}\n"))
    };
    let count = |text: &str| read(text).links[0].geometry.len();
    assert_eq!(count(&in_scope(&mesh(&prism("")), "guide")), 0);
    assert_eq!(count(&in_scope(&mesh(&prism("uniform token purpose = \"render\"")), "guide")), 1);
    assert_eq!(count(&in_scope(&mesh(&prism("")), "proxy")), 1);
    assert_eq!(count(&in_scope(&collider(&prism(""), "none"), "guide")), 1);
}

#[test]
fn subdivision_is_noted_once() {
    let smooth = "uniform token subdivisionScheme = \"catmullClark\"";
    let two = mesh(&prism(smooth)) + &mesh(&prism(smooth)).replace("\"m\"", "\"n\"");
    let model = read(&layer("", &two));
    let notes: Vec<_> = model.notes.iter().filter(|note| note.code == "read.left_out").collect();
    let [note] = notes.as_slice() else { panic!("{notes:?}") };
    let said = "subdivisionScheme = catmullClark of /r/a/m (and of 1 more) is not applied: the polygons are measured";
    assert_eq!((note.severity, note.message.as_str()), (Severity::Note, said));
    assert_eq!(&model.text[note.span.clone()], "catmullClark");
    for plain in ["", "uniform token subdivisionScheme = \"none\""] {
        assert!(read(&layer("", &mesh(&prism(plain)))).notes.is_empty());
    }
}

#[test]
fn a_tensor_is_compared_with_its_mesh() {
    let (volume, [x, y, z], tensor) = placed(|p| p);
    let moments = (0..3).map(|k| tensor[k][k] * 0.17 / volume * 1e4).collect::<Vec<_>>();
    let body = |factor: f64| {
        format!(
            "point3f physics:centerOfMass = ({}, {}, {})\nfloat3 physics:diagonalInertia = ({})",
            100.0 * x,
            100.0 * y,
            100.0 * z,
            list(moments.iter().map(|moment| factor * moment))
        )
    };
    let codes = |factor: f64| -> Vec<&str> {
        let model = read(&layer(&body(factor), &mesh(&prism(""))));
        let found = inspect(&model, &Shapes::default());
        assert_eq!(found.geometry[0].boxes.len(), 1, "for the pictures");
        found.findings.iter().filter(|f| f.severity > Severity::Note).map(|f| f.code).collect()
    };
    assert_eq!(codes(1.0), Vec::<&str>::new());
    assert_eq!(codes(3.7), ["inertia.geometry"]);
}

/// A part in another text layer, which two bodies reference: read as arrays, and shared.
#[test]
fn a_referenced_mesh_is_shared() {
    let part =
        format!("#usda 1.0\n(\n    defaultPrim = \"p\"\n)\ndef Xform \"p\"\n{{\n{}}}\n", mesh(&prism("")));
    let part_of = |name: &str| {
        format!("def \"{name}\" (\n    instanceable = true\n    references = @part.usda@\n)\n{{\n}}\n")
    };
    let text = layer("", &(part_of("one") + &part_of("two")));
    let folder = Folder::of("usd-part", &[("r.usda", &text), ("part.usda", &part)]);
    let model = read_model(&folder.path("r.usda"), &ReadOptions::default()).unwrap();
    let [one, two] = model.links[0].geometry.as_slice() else { panic!("{:?}", model.notes) };
    assert!(Arc::ptr_eq(&inline(one), &inline(two)));
    require(&Shapes::default().geometry(two).unwrap(), placed(|p| p), 1e-12);
}

/// Compares a binary layer with the numbers of `tests/usd/meshes.py`. Its instances share a mesh.
#[test]
fn a_binary_layer_agrees_with_usd_core_and_trimesh() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/usd/meshes.usdc");
    let model = read_model(&file, &ReadOptions::default()).unwrap();
    let shapes = Shapes::default();
    for (name, volume, center, [xx, yy, zz, xy, xz, yz]) in [
        (
            "/robot/base",
            0.0001890962834297226,
            [-0.08360780081096636, 0.03747173697734026, 0.031607548837438354],
            [
                1.9267092836739253e-06,
                3.7422820353047132e-06,
                4.032682281654579e-06,
                1.7140239778744688e-06,
                -1.455508861262895e-06,
                8.291104060656272e-07,
            ],
        ),
        (
            "/robot/arm",
            5.7863002423783144e-05,
            [0.0017763051262807215, -0.0005389054432413468, -0.38399999940857565],
            [
                2.111472809176814e-08,
                3.077778455173489e-08,
                4.537328062594306e-08,
                1.2510565630946502e-08,
                -5.014792801029591e-10,
                3.761094932332272e-10,
            ],
        ),
    ] {
        let link = model.links.iter().find(|link| link.name.text == name).unwrap();
        let found = shapes.link(link, Role::Visual);
        assert!(found.left_out.is_empty(), "{:?}", found.left_out);
        let found = found.volume.unwrap();
        assert_eq!(found.kind, VolumeKind::Closed);
        // Single precision of the points, and of rotations.
        require(&found, (volume, center, [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]), 2e-7);
    }
    let all: Vec<_> = model.links.iter().flat_map(|link| &link.geometry).map(inline).collect();
    let [mirrored, skew, plain] = all.as_slice() else { panic!("three") };
    assert!(Arc::ptr_eq(mirrored, plain) && !Arc::ptr_eq(mirrored, skew));
}
