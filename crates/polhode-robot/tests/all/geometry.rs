//! Volumes and moments of shapes, compared with independent computations.

use std::fs;
use std::path::PathBuf;

use crate::common::{Matrix, applied, assert_close, assert_near, matrix_about_axis, plus, times, transposed};
use polhode_robot::check::LinkGeometry;
use polhode_robot::geometry::{MeshReading, Shapes, Volume, VolumeKind, mesh_files};
use polhode_robot::model::{Geometry, GeometryShape, Link, Name, Pose, Role};
use polhode_robot::read::{ReadOptions, read_text};
use polhode_source::files::Disk;

/// Returns a pose about a generic axis, and the same as position and matrix.
fn generic(k: usize) -> (Pose, [f64; 3], Matrix) {
    let axes = [[0.3, -0.5, 0.8], [-0.7, 0.2, 0.4]];
    let places = [[0.7, -1.1, 0.4], [-0.6, 0.3, 0.9]];
    let angle = [2.1_f64, -0.8][k];
    let norm = axes[k].iter().map(|c| c * c).sum::<f64>().sqrt();
    let (s, c) = (0.5 * angle).sin_cos();
    let [x, y, z] = axes[k].map(|c| s * c / norm);
    (Pose::new(places[k], [c, x, y, z]), places[k], matrix_about_axis(axes[k], angle))
}

fn geometry(shape: GeometryShape, pose: Pose) -> Geometry {
    Geometry { span: 0..0, role: Role::Collision, pose, shape }
}

fn link(geometry: Vec<Geometry>) -> Link {
    Link {
        name: Name { text: "link".to_owned(), span: 0..0 },
        span: 0..0,
        inertial: None,
        geometry,
        pose: Pose::IDENTITY,
        is_static: false,
        from_geometry: false,
        computed: None,
    }
}

fn one(shape: GeometryShape, pose: Pose) -> Volume {
    Shapes::default().geometry(&geometry(shape, pose)).unwrap()
}

/// Returns R diag Rᵀ.
fn turned(r: Matrix, [a, b, c]: [f64; 3]) -> Matrix {
    times(r, times([[a, 0.0, 0.0], [0.0, b, 0.0], [0.0, 0.0, c]], transposed(r)))
}

#[test]
fn primitives_have_their_textbook_moments_in_the_axes_of_the_link() {
    let (pose, place, r) = generic(0);
    let pi = std::f64::consts::PI;
    let (a, b, c) = (0.3_f64, 0.5_f64, 0.8_f64);
    let box_volume = a * b * c;
    let cylinder = pi * a * a * c;
    let ball = 4.0 / 3.0 * pi * a * a * a;
    let ellipsoid = 4.0 / 3.0 * pi * a * b * c;
    // A capsule is a cylinder and two half balls, each with its centroid 3/8 r beyond the end.
    let side =
        cylinder * (3.0 * a * a + c * c) / 12.0 + ball * (0.4 * a * a + c * c / 4.0 + 3.0 * a * c / 8.0);
    let cases = [
        (
            GeometryShape::Box([a, b, c]),
            box_volume,
            [b * b + c * c, a * a + c * c, a * a + b * b].map(|s| box_volume * s / 12.0),
        ),
        (GeometryShape::Sphere(a), ball, [0.4 * ball * a * a; 3]),
        (
            GeometryShape::Cylinder { radius: a, length: c },
            cylinder,
            [3.0 * a * a + c * c, 3.0 * a * a + c * c, 6.0 * a * a].map(|s| cylinder * s / 12.0),
        ),
        (
            GeometryShape::Capsule { radius: a, length: c },
            cylinder + ball,
            [side, side, cylinder * a * a / 2.0 + 0.4 * ball * a * a],
        ),
        (
            GeometryShape::Ellipsoid([a, b, c]),
            ellipsoid,
            [b * b + c * c, a * a + c * c, a * a + b * b].map(|s| ellipsoid * s / 5.0),
        ),
    ];
    for (shape, volume, moments) in cases {
        let got = one(shape.clone(), pose.clone());
        assert!((got.volume - volume).abs() <= 4e-16 * volume.max(1.0), "{shape:?}");
        assert_eq!(got.centroid, place);
        assert_near(&got.tensor_per_density, &turned(r, moments), 1e-15);
        assert_eq!(got.kind, VolumeKind::Primitives);
    }
}

#[test]
fn bounds_hold_every_point_and_are_touched() {
    let (pose, place, r) = generic(1);
    let (a, b, c) = (0.3_f64, 0.5_f64, 0.8_f64);
    // Points of each surface by two angles; the corners of a box.
    let ring = |n: usize| (0..n).map(move |k| std::f64::consts::TAU * k as f64 / n as f64);
    let sphere: Vec<[f64; 3]> = ring(720)
        .flat_map(|u| ring(720).map(move |v| [u.cos() * v.cos(), u.sin() * v.cos(), v.sin()]))
        .collect();
    let with = |f: &dyn Fn([f64; 3]) -> [f64; 3]| sphere.iter().map(|p| f(*p)).collect::<Vec<_>>();
    let rim = |z: f64| ring(4000).map(move |u| [a * u.cos(), a * u.sin(), z]);
    let corners = (0..8).map(|k| [k & 1, k >> 1 & 1, k >> 2].map(|bit| f64::from(bit) - 0.5));
    let cases = [
        (GeometryShape::Box([a, b, c]), corners.map(|[x, y, z]| [a * x, b * y, c * z]).collect()),
        (GeometryShape::Cylinder { radius: a, length: c }, rim(-0.5 * c).chain(rim(0.5 * c)).collect()),
        (
            GeometryShape::Capsule { radius: a, length: c },
            with(&|[x, y, z]| [a * x, a * y, a * z + 0.5 * c * z.signum()]),
        ),
        (GeometryShape::Ellipsoid([a, b, c]), with(&|[x, y, z]| [a * x, b * y, c * z])),
    ];
    for (shape, points) in cases {
        let got = one(shape.clone(), pose.clone());
        let points: Vec<_> = points.iter().map(|p| plus(place, applied(r, *p))).collect();
        let farthest = points.iter().map(|p| p.iter().map(|c| c * c).sum::<f64>().sqrt()).fold(0.0, f64::max);
        let slack = if matches!(shape, GeometryShape::Ellipsoid(_)) { 0.5 } else { 1e-4 };
        assert!(
            got.extent >= farthest - 1e-15 && got.extent <= farthest + slack,
            "{shape:?} {} {farthest}",
            got.extent
        );
        for k in 0..3 {
            let low = points.iter().map(|p| p[k]).fold(f64::INFINITY, f64::min);
            let high = points.iter().map(|p| p[k]).fold(f64::NEG_INFINITY, f64::max);
            let [got_low, got_high] = got.bounds.map(|bound| bound[k]);
            assert!(got_low <= low + 1e-15 && got_low >= low - 1e-4, "{shape:?} {k}: {got_low} {low}");
            assert!(got_high >= high - 1e-15 && got_high <= high + 1e-4, "{shape:?} {k}: {got_high} {high}");
        }
    }
}

const TETRAHEDRON: [[f64; 3]; 4] = [[0.1, -0.2, 0.3], [1.4, 0.2, -0.1], [-0.3, 1.1, 0.5], [0.2, 0.4, 1.7]];

/// Returns an ASCII STL of some faces of a tetrahedron.
fn stl(faces: &[[usize; 3]]) -> String {
    let corner =
        |k: usize| format!("vertex {} {} {}\n", TETRAHEDRON[k][0], TETRAHEDRON[k][1], TETRAHEDRON[k][2]);
    let facet = |face: &[usize; 3]| {
        format!("facet normal 0 0 0\nouter loop\n{}endloop\nendfacet\n", face.map(corner).concat())
    };
    format!("solid t\n{}endsolid t\n", faces.iter().map(facet).collect::<String>())
}

const FACES: [[usize; 3]; 4] = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];

fn mesh_file(name: &str, faces: &[[usize; 3]]) -> PathBuf {
    let path = std::env::temp_dir().join(format!("polhode-robot-{name}-{}.stl", std::process::id()));
    fs::write(&path, stl(faces)).unwrap();
    path
}

fn mesh(path: &std::path::Path, scale: [f64; 3]) -> GeometryShape {
    GeometryShape::Mesh {
        uri: Name { text: "t.stl".to_owned(), span: 0..0 },
        path: Ok(path.to_owned()),
        scale,
    }
}

/// Returns volume, centroid and tensor of a tetrahedron from its corners: C = V/20 (Σ d dᵀ) about
/// the centroid, d = p_k − c.
fn tetrahedron(corners: [[f64; 3]; 4]) -> (f64, [f64; 3], Matrix) {
    let [p, q, r, s] = corners;
    let edge = |b: [f64; 3]| [b[0] - p[0], b[1] - p[1], b[2] - p[2]];
    let [u, v, w] = [edge(q), edge(r), edge(s)];
    let cross = [v[1] * w[2] - v[2] * w[1], v[2] * w[0] - v[0] * w[2], v[0] * w[1] - v[1] * w[0]];
    let volume = ((0..3).map(|k| u[k] * cross[k]).sum::<f64>() / 6.0).abs();
    let centroid: [f64; 3] = std::array::from_fn(|k| corners.iter().map(|c| c[k]).sum::<f64>() / 4.0);
    let moment = |i: usize, j: usize| {
        volume / 20.0 * corners.iter().map(|c| (c[i] - centroid[i]) * (c[j] - centroid[j])).sum::<f64>()
    };
    let trace = moment(0, 0) + moment(1, 1) + moment(2, 2);
    let tensor =
        std::array::from_fn(|i| std::array::from_fn(|j| if i == j { trace } else { 0.0 } - moment(i, j)));
    (volume, centroid, tensor)
}

#[test]
fn a_scaled_and_mirrored_mesh_is_that_of_the_scaled_corners() {
    let closed = mesh_file("closed", &FACES);
    let open = mesh_file("open", &FACES[..3]);
    let (pose, place, r) = generic(0);
    let shapes = Shapes::default();
    for scale in [[1.0; 3], [0.5, 2.0, 1.5], [-0.5, 2.0, 1.5], [-0.1, -0.2, -0.3]] {
        let corners = TETRAHEDRON.map(|p| plus(place, applied(r, [0, 1, 2].map(|k| scale[k] * p[k]))));
        let (volume, centroid, tensor) = tetrahedron(corners);
        for (path, kind) in [(&closed, VolumeKind::Closed), (&open, VolumeKind::Hull)] {
            let got = shapes.geometry(&geometry(mesh(path, scale), pose.clone())).unwrap();
            assert!((got.volume / volume - 1.0).abs() < 2e-15, "{scale:?}");
            assert_close(got.centroid, centroid, 1e-15);
            assert_near(&got.tensor_per_density, &tensor, 2e-15);
            assert_eq!(got.kind, kind);
            for k in 0..3 {
                let low = corners.iter().map(|c| c[k]).fold(f64::INFINITY, f64::min);
                assert!((got.bounds[0][k] - low).abs() < 1e-15);
            }
        }
    }
    // Products of a mirrored part: two change sign.
    let product = |scale| one(mesh(&closed, scale), Pose::IDENTITY).tensor_per_density;
    let (plain, mirrored) = (product([1.0; 3]), product([1.0, -1.0, 1.0]));
    assert_near(
        &mirrored,
        &std::array::from_fn(|i| {
            std::array::from_fn(|j| if (i == 1) == (j == 1) { plain[i][j] } else { -plain[i][j] })
        }),
        1e-16,
    );
    assert!(plain[0][1].abs() > 1e-3 && plain[1][2].abs() > 1e-3);

    for bad in [[0.0, 1.0, 1.0], [f64::NAN, 1.0, 1.0]] {
        assert!(
            shapes.geometry(&geometry(mesh(&closed, bad), Pose::IDENTITY)).unwrap_err().contains("scale")
        );
    }
    let flat = mesh_file("flat", &FACES[..1]);
    assert!(shapes.geometry(&geometry(mesh(&flat, [1.0; 3]), Pose::IDENTITY)).is_err());
    for path in [closed, open, flat] {
        fs::remove_file(path).unwrap();
    }
}

#[test]
fn a_collada_mesh_is_placed_by_its_nodes_in_its_unit() {
    let positions = TETRAHEDRON.as_flattened().iter().map(ToString::to_string).collect::<Vec<_>>().join(" ");
    // A vertex and a normal for each corner; one face as a triangle, the others as polygons.
    let corners =
        |faces: &[[usize; 3]]| faces.iter().flatten().map(|k| format!("{k} 7 ")).collect::<String>();
    let inputs =
        "<input semantic='NORMAL' source='#n' offset='1'/><input semantic='VERTEX' source='#v' offset='0'/>";
    let text = format!(
        "<?xml version='1.0'?><COLLADA xmlns='http://www.collada.org/2005/11/COLLADASchema' version='1.4.1'>
        <asset><unit name='half' meter='0.5'/><up_axis>Y_UP</up_axis></asset>
        <library_geometries><geometry id='g'><mesh>
          <source id='s'><float_array id='f' count='12'>{positions}</float_array>
            <technique_common><accessor source='#f' count='4' stride='3'/></technique_common></source>
          <vertices id='v'><input semantic='POSITION' source='#s'/></vertices>
          <triangles count='1'>{inputs}<p>{}</p></triangles>
          <polylist count='3'>{inputs}<vcount>3 3 3</vcount><p>{}</p></polylist>
        </mesh></geometry></library_geometries>
        <library_visual_scenes><visual_scene id='scene'><node><translate>1 2 3</translate>
          <node><rotate>0.3 -0.5 0.8 50</rotate><scale>1 -2 1.5</scale><instance_geometry url='#g'/></node>
        </node></visual_scene></library_visual_scenes>
        <scene><instance_visual_scene url='#scene'/></scene></COLLADA>",
        corners(&FACES[..1]),
        corners(&FACES[1..])
    );
    let path = std::env::temp_dir().join(format!("polhode-robot-collada-{}.dae", std::process::id()));
    let r = matrix_about_axis([0.3, -0.5, 0.8], 50_f64.to_radians());
    let placed =
        |p: [f64; 3]| plus([1.0, 2.0, 3.0], applied(r, [p[0], -2.0 * p[1], 1.5 * p[2]])).map(|c| 0.5 * c);
    let (volume, centroid, tensor) = tetrahedron(TETRAHEDRON.map(placed));
    fs::write(&path, &text).unwrap();
    let got = one(mesh(&path, [1.0; 3]), Pose::IDENTITY);
    assert_eq!(got.kind, VolumeKind::Closed);
    assert!((got.volume / volume - 1.0).abs() < 4e-15);
    assert_close(got.centroid, centroid, 1e-15);
    assert_near(&got.tensor_per_density, &tensor, 2e-15);

    let says = |text: &str| {
        fs::write(&path, text).unwrap();
        Shapes::default().geometry(&geometry(mesh(&path, [1.0; 3]), Pose::IDENTITY)).unwrap_err()
    };
    assert!(says(&text.replace("url='#g'", "url='#h'")).contains("geometry"));
    let unit = says(&text.replace("name='half' meter='0.5'", "name='millimeter' meter='1'"));
    assert!(
        unit.contains("meter of the unit \"millimeter\"") && unit.contains("write meter=\"0.001\""),
        "{unit}"
    );
    // A node of a library, and additional lines: the same solid.
    let inner =
        "<node><rotate>0.3 -0.5 0.8 50</rotate><scale>1 -2 1.5</scale><instance_geometry url='#g'/></node>";
    let lines = "<geometry id='l'><mesh><lines count='1'><input semantic='VERTEX' source='#v' offset='0'/><p>0 1</p></lines></mesh></geometry>";
    let library = format!(
        "<library_nodes>{}</library_nodes><library_visual_scenes>",
        inner.replacen("<node>", "<node id='n'>", 1)
    );
    let instanced = text
        .replace(inner, "<instance_node url='#n'/><instance_geometry url='#l'/>")
        .replace("</library_geometries>", &format!("{lines}</library_geometries>"))
        .replace("<library_visual_scenes>", &library);
    assert!(instanced.contains("url='#n'"));
    fs::write(&path, &instanced).unwrap();
    assert_eq!(one(mesh(&path, [1.0; 3]), Pose::IDENTITY), got);
    fs::remove_file(path).unwrap();
}

#[test]
fn shapes_of_a_link_are_one_body() {
    let (p, q) = (generic(0), generic(1));
    let box_pose = p.0.clone();
    // A box as two parts, cut across x.
    let (a, b, c) = (0.6, 0.5, 0.8);
    let half = |sign: f64| {
        // The parts are [−0.3, 0.1] and [0.1, 0.3].
        let (width, middle) = if sign > 0.0 { (0.2, 0.2) } else { (0.4, -0.1) };
        let inner = Pose::new([middle, 0.0, 0.0], [1.0, 0.0, 0.0, 0.0]);
        geometry(GeometryShape::Box([width, b, c]), box_pose.then(&inner))
    };
    let whole = one(GeometryShape::Box([a, b, c]), box_pose.clone());
    let mut seen = geometry(GeometryShape::Sphere(9.0), q.0);
    seen.role = Role::Visual;
    let plane = geometry(GeometryShape::Other("plane".to_owned()), Pose::IDENTITY);
    let set = Shapes::default().link(&link(vec![half(1.0), seen, half(-1.0), plane]), Role::Collision);
    let got = set.volume.unwrap();
    assert!((got.volume - whole.volume).abs() < 1e-16);
    assert_close(got.centroid, whole.centroid, 1e-15);
    assert_near(&got.tensor_per_density, &whole.tensor_per_density, 1e-16);
    assert_close(got.bounds[0], whole.bounds[0], 1e-15);
    assert_close(got.bounds[1], whole.bounds[1], 1e-15);
    assert_eq!(set.left_out.len(), 1);
    assert_eq!(Shapes::default().link(&link(Vec::new()), Role::Visual).volume, None);
}

#[test]
fn a_gltf_mesh_has_y_up_and_stands_on_z_in_a_robot() {
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    let scale = [0.7, 1.3, 2.1];
    let (pose, ..) = generic(0);
    let placed = |path: &str| geometry(mesh(&root.join(path), scale), pose.clone());
    let glb = placed("meshes/bracket.glb");
    // The same triangles in a format without an up axis, in mm: R (x, y, z) = (x, −z, y), then the
    // scale.
    let plain = one(mesh(&root.join("bracket.stl"), [1e-3; 3]), Pose::IDENTITY);
    let r = [[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]];
    let shapes = Shapes::default();
    let unscaled = geometry(mesh(&root.join("meshes/bracket.glb"), [1.0; 3]), Pose::IDENTITY);
    let up = shapes.geometry(&unscaled).unwrap();
    assert_close(up.centroid, applied(r, plain.centroid), 1e-15);
    assert_near(&up.tensor_per_density, &times(times(r, plain.tensor_per_density), transposed(r)), 1e-18);
    let factor = scale.iter().product::<f64>();
    let whole = shapes.geometry(&glb).unwrap();
    assert!((whole.volume / (factor * plain.volume) - 1.0).abs() < 1e-12);
    let [x, y, z] = applied(r, plain.centroid);
    assert_close(whole.centroid, pose_of(0, [scale[0] * x, scale[1] * y, scale[2] * z]), 1e-14);
    // The other convention does not rotate it.
    let link = link(vec![unscaled]);
    assert!(shapes.is_turned_by_some(&link, Role::Collision));
    let other = shapes.link_as(&link, Role::Collision, MeshReading::Other).volume.unwrap();
    assert_near(&other.tensor_per_density, &plain.tensor_per_density, 1e-18);
    let both = LinkGeometry::of(&link, &shapes);
    assert!(both.is_turned_by_some && both.volumes.len() == 2);
    assert!(!shapes.is_turned_by_some(&self::link(vec![placed("bracket.stl")]), Role::Collision));
}

/// Transforms a point from the frame of `generic(k)` to the outer frame.
fn pose_of(k: usize, point: [f64; 3]) -> [f64; 3] {
    let (_, place, r) = generic(k);
    plus(place, applied(r, point))
}

#[test]
fn copies_of_a_mesh_measure_alike_and_others_of_its_size_do_not() {
    let closed = mesh_file("copied", &FACES);
    let [first, second, third] = [("copy-1", "stl"), ("copy-2", "STL"), ("copy-3", "stl")]
        .map(|(name, ending)| closed.with_file_name(format!("{name}-{}.{ending}", std::process::id())));
    let bytes = std::fs::read(&closed).unwrap();
    std::fs::write(&first, &bytes).unwrap();
    std::fs::write(&second, &bytes).unwrap();
    // A change of one bit in a coordinate.
    let mut others = bytes.clone();
    let at = others.len() - 12;
    others[at] = others[at].wrapping_add(1);
    std::fs::write(&third, &others).unwrap();
    let shapes = Shapes::default();
    let of = |path: &_| shapes.geometry(&geometry(mesh(path, [1.0; 3]), Pose::IDENTITY));
    let found = of(&first).unwrap();
    assert_eq!(of(&second), Ok(found.clone()));
    assert_ne!(of(&third), Ok(found));
    [first, second, third].iter().for_each(|path| std::fs::remove_file(path).unwrap());
}

#[test]
fn mesh_files_come_once_and_the_largest_first() {
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    let [large, small, none] = ["bracket.stl", "meshes/bracket.glb", "none.stl"].map(|path| root.join(path));
    let size = |path| fs::metadata(path).unwrap().len();
    assert!(size(&large) > size(&small));
    let robot = |meshes: &[&PathBuf]| {
        let mut model = read_text("<robot name='r'/>", "r.urdf".as_ref(), &ReadOptions::default()).unwrap();
        let meshes = meshes.iter().map(|path| geometry(mesh(path, [1.0; 3]), Pose::IDENTITY));
        model.links =
            vec![link(vec![geometry(GeometryShape::Sphere(0.3), Pose::IDENTITY)]), link(meshes.collect())];
        model
    };
    let models = [robot(&[&none, &small]), robot(&[&small, &large, &small])];
    assert_eq!(mesh_files(&Disk, models.iter()), [large, small, none]);
}
