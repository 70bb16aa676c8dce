//! Binary STL straight to moments: the same answers as the ordinary reader, and the same refusals.

use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};

use polhode::body::shape::{Shape, Substance};
use polhode::body::{BodyError, MassProperties};
use polhode::math::Part;
use polhode_formats::FormatErrorKind;
use polhode_formats::mesh::stl::{StlError, StlPlace};
use polhode_formats::mesh::stl_quick::{QuickMoments, QuickOptions, parse, read};
use polhode_formats::mesh::{MeshContents, MeshFormat, MeshSolid};

type Triangle = [[f32; 3]; 3];

/// A wedge with unequal sides off the origin, its triangles divided so many times: closed.
fn wedge(levels: u32) -> Vec<Triangle> {
    let [o, x, y, z, w] =
        [[3.0, -2.0, 7.0], [5.5, -2.25, 7.5], [3.5, 1.0, 7.0], [3.25, -1.5, 8.5], [5.0, 0.5, 9.0]];
    let faces = [[o, y, x], [o, x, z], [o, z, y], [x, w, z], [w, y, z], [x, y, w]];
    let middle = |p: [f32; 3], q: [f32; 3]| [0, 1, 2].map(|k| 0.5 * (p[k] + q[k]));
    let divide = |mesh: Vec<Triangle>| -> Vec<Triangle> {
        let parts = |[a, b, c]: Triangle| {
            let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
            [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
        };
        mesh.into_iter().flat_map(parts).collect()
    };
    (0..levels).fold(faces.to_vec(), |mesh, _| divide(mesh))
}

fn file(triangles: &[Triangle]) -> Vec<u8> {
    let mut bytes = b"solid in name only".to_vec();
    bytes.resize(80, 0);
    bytes.extend((triangles.len() as u32).to_le_bytes());
    for triangle in triangles {
        bytes.extend([0xC3; 12]);
        bytes.extend(triangle.as_flattened().iter().flat_map(|c| c.to_le_bytes()));
        bytes.extend([0; 2]);
    }
    bytes
}

fn quick(bytes: &[u8]) -> Result<Option<QuickMoments>, Box<FormatErrorKind>> {
    parse(bytes, Path::new("part.stl"), &QuickOptions::default()).map_err(|e| Box::new(e.kind().clone()))
}

fn stored(name: &str, bytes: &[u8]) -> PathBuf {
    let path = std::env::temp_dir().join(format!("polhode-quick-{}-{name}.stl", std::process::id()));
    std::fs::write(&path, bytes).unwrap();
    path
}

#[test]
fn the_answer_is_that_of_the_ordinary_reader() {
    for (levels, unit) in [(0, 1.0), (3, 0.001), (6, 0.0254)] {
        let bytes = file(&wedge(levels));
        let quick = quick(&bytes).unwrap().unwrap();
        let path = Path::new("part.stl");
        let contents = MeshContents::parse(&bytes, path, MeshFormat::Stl).unwrap();
        let ordinary = MeshSolid::of(contents, path, MeshFormat::Stl, Some(unit)).unwrap();
        assert_eq!((quick.triangles as usize, quick.closed), (ordinary.triangles, Some(true)));
        assert!(!quick.inverted);
        let density = Substance::Density(1234.5);
        let (ours, theirs): (MassProperties<Part>, _) = (
            quick.solid(unit).unwrap().mass_properties(density).unwrap(),
            ordinary.parts[0].mesh.mass_properties(density).unwrap(),
        );
        assert!((ours.mass() / theirs.mass() - 1.0).abs() < 2e-15);
        assert!((quick.area * unit * unit / ordinary.parts[0].mesh.surface_area() - 1.0).abs() < 4e-15);
        assert!((ours.center_of_mass() - theirs.center_of_mass()).norm() < 4e-15 * 9.0 * unit);
        let (a, b) = (ours.inertia().matrix(), theirs.inertia().matrix());
        let half_trace = 0.5 * (b[0][0] + b[1][1] + b[2][2]);
        for (a, b) in a.as_flattened().iter().zip(b.as_flattened()) {
            assert!((a - b).abs() < 4e-15 * half_trace);
        }
        assert_eq!(quick.bounds, [[3.0, -2.25, 7.0], [5.5, 1.0, 9.0]]);
    }
}

#[test]
fn a_file_read_by_any_number_of_threads_gives_the_same_bits() {
    let bytes = file(&wedge(6));
    let path = stored("bits", &bytes);
    let expected = quick(&bytes).unwrap();
    for threads in [1, 2, 8] {
        let threads = NonZeroUsize::new(threads).unwrap();
        assert_eq!(read(&path, &QuickOptions { threads, verdict: true }).unwrap(), expected);
    }
    std::fs::remove_file(path).unwrap();
}

#[test]
fn an_inverted_mesh_is_turned_and_an_open_one_is_found_out() {
    let mesh = wedge(4);
    let whole = quick(&file(&mesh)).unwrap().unwrap();
    let inverted: Vec<Triangle> = mesh.iter().map(|&[a, b, c]| [a, c, b]).collect();
    let turned = quick(&file(&inverted)).unwrap().unwrap();
    assert!(turned.inverted && turned.closed == Some(true));
    assert!((turned.volume / whole.volume - 1.0).abs() < 1e-15);
    let open = quick(&file(&mesh[1..])).unwrap().unwrap();
    assert_eq!(open.closed, Some(false));
    let mut one_turned = mesh;
    one_turned[57].swap(1, 2);
    assert_eq!(quick(&file(&one_turned)).unwrap().unwrap().closed, Some(false));
}

#[test]
fn what_is_no_binary_stl_goes_to_the_ordinary_reader_or_is_refused() {
    let bytes = file(&wedge(2));
    let text =
        b"solid part\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop";
    assert_eq!(quick(text), Ok(None));
    assert_eq!(quick(b" solid"), Ok(None));
    assert_eq!(quick(b"PK"), Err(Box::new(FormatErrorKind::Stl(StlError::Unrecognized { length: 2 }))));
    assert_eq!(quick(&file(&[])), Err(Box::new(FormatErrorKind::Stl(StlError::NoTriangles))));
    let mut counted = bytes.clone();
    for declared in [95_u32, 97, 0, u32::MAX] {
        counted[80..84].copy_from_slice(&declared.to_le_bytes());
        let expected = StlError::WrongCount { declared, length: bytes.len() };
        assert_eq!(quick(&counted), Err(Box::new(FormatErrorKind::Stl(expected.clone()))));
        let path = stored(&format!("count-{declared}"), &counted);
        let error = read(&path, &QuickOptions::default()).unwrap_err();
        assert_eq!(error.kind(), &FormatErrorKind::Stl(expected));
        std::fs::remove_file(path).unwrap();
    }
    for length in [bytes.len() - 1, bytes.len() - 50, 84, 83] {
        assert!(matches!(quick(&bytes[..length]).map_err(|e| *e), Err(FormatErrorKind::Stl(_))), "{length}");
    }
    let missing = read(Path::new("no such.stl"), &QuickOptions::default()).unwrap_err();
    assert!(matches!(missing.kind(), FormatErrorKind::Io { .. }));
    assert_eq!(read(&std::env::temp_dir(), &QuickOptions::default()).unwrap(), None);
}

#[test]
fn a_vertex_that_is_not_finite_is_refused_with_its_place() {
    let mut mesh = wedge(3);
    mesh[123][2][1] = f32::NAN;
    mesh[200][0][0] = f32::INFINITY;
    let offset = 84 + 50 * 123 + 12 + 4 * 7;
    let at = StlPlace::Record { index: 123, offset };
    let expected = StlError::NotFinite { at, found: "NaN".to_owned() };
    assert_eq!(quick(&file(&mesh)), Err(Box::new(FormatErrorKind::Stl(expected))));
}

#[test]
fn a_flat_mesh_has_no_volume() {
    let flat = [[0.1, 0.2, 0.3], [1.7, 0.5, 0.9], [0.4, 2.3, 1.1_f32]];
    let [a, b, c] = flat;
    let error = quick(&file(&[[a, b, c], [a, c, b]])).unwrap_err();
    assert!(matches!(*error, FormatErrorKind::Body(BodyError::FlatMesh { .. })));
}
