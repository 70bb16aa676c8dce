//! Diagnosis of meshes: each fault with its count and place, and the nesting of parts.

#[path = "mesh_diagnosis/grids.rs"]
mod grids;

use polhode::body::BodyError;
use polhode::body::mesh::{ClosedMesh, ComponentRole, MeshDiagnosis, Triangle, TriangleMesh};
use polhode::body::shape::{Shape, Substance};

type Point = [f64; 3];

/// Returns a box between two corners, its faces divided into n × n squares, counter-clockwise as
/// seen from outside.
fn cuboid(low: Point, high: Point, n: u32) -> Vec<Triangle> {
    let mut triangles = Vec::new();
    for axis in 0..3 {
        for (end, turned) in [(high, false), (low, true)] {
            let point = |i: u32, j: u32| {
                let mut p = end;
                for (k, step) in [((axis + 1) % 3, i), ((axis + 2) % 3, j)] {
                    let part = f64::from(step) / f64::from(n);
                    p[k] = low[k] + part * (high[k] - low[k]);
                }
                p
            };
            for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (i, j))) {
                let [a, b, c, d] = [point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)];
                let squares = [[a, b, c], [a, c, d]];
                triangles.extend(squares.map(|[a, b, c]| if turned { [a, c, b] } else { [a, b, c] }));
            }
        }
    }
    triangles
}

fn inward(triangles: Vec<Triangle>) -> Vec<Triangle> {
    triangles.into_iter().map(|[a, b, c]| [a, c, b]).collect()
}

fn mesh(parts: &[Vec<Triangle>]) -> TriangleMesh {
    TriangleMesh::of_triangles(&parts.concat()).unwrap()
}

/// Checks that remarks do not affect the verdict: the same volume, or the same error.
fn is_judged_alike_without_remarks(mesh: &TriangleMesh) {
    let judged = [ClosedMesh::with_threads(mesh, 1), ClosedMesh::without_remarks(mesh, 1, &|| true)];
    let [all, brief] = judged.map(|judged| judged.map(|solid| (solid.volume(), solid.inverted())));
    assert_eq!(all, brief);
}

/// Checks that a mesh whose intersections are not searched has the same bits, orientation and
/// findings as otherwise, or the same error, except for intersections.
fn is_measured_alike_unchecked(mesh: &TriangleMesh) {
    let substance = Substance::Density(1.7);
    let of_search = ["mesh.overlap", "mesh.touching", "mesh.unchecked"];
    let measured = |solid: ClosedMesh| {
        let body = solid.mass_properties(substance).unwrap();
        let others = solid.findings().iter().filter(|finding| !of_search.contains(&finding.code));
        let numbers = [body.center_of_mass().to_array()].into_iter().chain(body.inertia().matrix());
        let bits: Vec<u64> =
            numbers.flatten().chain([body.mass(), solid.surface_area()]).map(f64::to_bits).collect();
        (bits, solid.inverted(), others.cloned().collect::<Vec<_>>())
    };
    let unchecked = ClosedMesh::unchecked(mesh, &|| true).map_err(|flaws| flaws.first);
    if let Ok(solid) = &unchecked {
        assert_eq!(solid.findings().last().map(|finding| finding.code), Some("mesh.unchecked"));
        assert!(solid.diagnosis().unsearched);
    }
    match ClosedMesh::of(mesh) {
        Err(BodyError::OverlappingMesh { .. }) => {}
        checked => assert_eq!(unchecked.map(measured), checked.map(measured)),
    }
}

fn diagnosis(parts: &[Vec<Triangle>]) -> MeshDiagnosis {
    is_judged_alike_without_remarks(&mesh(parts));
    is_measured_alike_unchecked(&mesh(parts));
    let mesh = mesh(parts);
    let diagnosis = MeshDiagnosis::of(&mesh);
    for threads in [1, 2, 8] {
        assert_eq!(MeshDiagnosis::with_threads(&mesh, threads), diagnosis);
    }
    diagnosis
}

fn roles(diagnosis: &MeshDiagnosis) -> Vec<ComponentRole> {
    diagnosis.components.iter().map(|component| component.role).collect()
}

/// Moves the parts to a slanted position by a rational rotation and a shift, so that planes are not
/// parallel to the axes.
fn slanted(parts: &[Vec<Triangle>]) -> Vec<Vec<Triangle>> {
    let turn = |[x, y, z]: Point| {
        // (2, −2, 1; 1, 2, 2; −2, −1, 2): three times a rotation, exact for small integers
        [2.0 * x - 2.0 * y + z + 5.0, x + 2.0 * y + 2.0 * z - 7.0, -2.0 * x - y + 2.0 * z + 0.5]
    };
    parts.iter().map(|part| part.iter().map(|t| t.map(turn)).collect()).collect()
}

/// Runs the check for the parts as given and slanted.
fn both_ways(parts: &[Vec<Triangle>], check: impl Fn(&MeshDiagnosis, Result<ClosedMesh, BodyError>)) {
    for parts in [parts.to_vec(), slanted(parts)] {
        check(&diagnosis(&parts), ClosedMesh::of(&mesh(&parts)));
    }
}

#[test]
fn a_sound_box_has_no_faults() {
    for n in [1, 2, 5] {
        both_ways(&[cuboid([0.0, 1.0, -2.0], [2.0, 4.0, 3.0], n)], |diagnosis, solid| {
            let n = n as usize;
            assert_eq!((diagnosis.triangles, diagnosis.vertices), (12 * n * n, 6 * n * n + 2));
            let MeshDiagnosis { boundary, inconsistent, non_manifold, duplicates, .. } = diagnosis;
            assert!(boundary.is_empty() && inconsistent.is_empty() && non_manifold.is_empty());
            assert!(duplicates.is_empty() && diagnosis.overlaps.is_empty(), "{diagnosis:?}");
            assert!(diagnosis.self_overlaps.is_empty() && diagnosis.contacts.is_empty(), "{diagnosis:?}");
            assert_eq!(roles(diagnosis), [ComponentRole::Solid]);
            assert!(solid.unwrap().findings().is_empty());
        });
    }
}

#[test]
fn holes_are_counted_by_their_loops() {
    let mut punctured = cuboid([0.0; 3], [3.0; 3], 3);
    // two squares in the middle of two faces
    let is_middle = |t: &Triangle| {
        let [x, y, z]: Point = [0, 1, 2].map(|k| t.iter().map(|p| p[k]).sum::<f64>() / 3.0);
        (z == 3.0 || z == 0.0) && (x - 1.5).abs() < 0.5 && (y - 1.5).abs() < 0.5
    };
    punctured.retain(|t| !is_middle(t));
    both_ways(&[punctured], |diagnosis, solid| {
        assert_eq!((diagnosis.boundary.count, diagnosis.boundary_loops), (8, 2));
        assert_eq!(roles(diagnosis), [ComponentRole::Open]);
        assert!(matches!(solid, Err(BodyError::OpenMesh { edges: 8, loops: 2, .. })));
    });
}

#[test]
fn shells_in_shells_are_cavities_and_solids_by_turns() {
    let shell = |r: f64| cuboid([-r, -r - 0.25, -r], [r, r, r + 0.5], 2);
    let onion = [inward(shell(3.0)), shell(2.0), shell(4.0), inward(shell(1.0))];
    both_ways(&onion, |diagnosis, solid| {
        use ComponentRole::{Cavity, Solid};
        assert_eq!(roles(diagnosis), [Cavity, Solid, Solid, Cavity]);
        let nests: Vec<_> = diagnosis.components.iter().map(|c| (c.depth, c.inside)).collect();
        assert_eq!(nests, [(1, Some(2)), (2, Some(0)), (0, None), (3, Some(1))]);
        let solid = solid.unwrap();
        let volume: f64 = diagnosis.components.iter().map(|c| c.volume).sum();
        assert!((solid.volume() - volume).abs() < 1e-12 * volume);
        let codes: Vec<_> = solid.findings().iter().map(|f| f.code).collect();
        assert_eq!(codes, ["mesh.cavity", "mesh.components"]);
    });
    let turned = onion.map(inward);
    both_ways(&turned, |_, solid| assert!(solid.unwrap().inverted()));
}

#[test]
fn a_solid_in_a_solid_is_refused_and_so_is_an_inward_one_outside() {
    let outer = cuboid([0.0; 3], [4.0, 5.0, 6.0], 1);
    let inner = cuboid([1.0; 3], [2.0; 3], 1);
    both_ways(&[outer.clone(), inner], |diagnosis, solid| {
        assert_eq!(roles(diagnosis), [ComponentRole::Solid, ComponentRole::InnerSolid]);
        assert!(matches!(solid, Err(BodyError::NestedSolid { parts: 1, triangle: 13, .. })), "{solid:?}");
    });
    let beside = inward(cuboid([7.0; 3], [8.0; 3], 1));
    both_ways(&[outer, beside], |diagnosis, solid| {
        assert_eq!(roles(diagnosis), [ComponentRole::Solid, ComponentRole::Inverted]);
        assert!(matches!(solid, Err(BodyError::InvertedPart { parts: 1, triangle: 13, .. })), "{solid:?}");
    });
}

#[test]
fn solids_that_overlap_are_refused_in_every_position() {
    let a = || cuboid([0.0; 3], [2.0; 3], 1);
    let overlapping = [
        ("generic", cuboid([0.75, 0.875, 1.125], [3.125, 3.25, 3.75], 1)),
        ("edges through diagonals", cuboid([1.0; 3], [3.0; 3], 1)),
        ("flush sides", cuboid([1.0, 0.0, 0.0], [3.0, 2.0, 2.0], 1)),
        ("through and through", cuboid([0.5, 0.5, -1.0], [1.5, 1.5, 3.0], 1)),
        ("common corners of a grid", cuboid([1.0; 3], [3.0; 3], 2)),
        ("flush inside", cuboid([0.0, 0.5, 0.5], [1.0, 1.5, 1.5], 1)),
    ];
    for (what, b) in overlapping {
        both_ways(&[a(), b], |diagnosis, solid| {
            assert!(!diagnosis.overlaps.is_empty(), "{what}");
            let refused = matches!(solid, Err(BodyError::OverlappingMesh { triangles: [t, u], .. }) if t <= 12 && u > 12);
            assert!(refused, "{what}: {solid:?}");
        });
    }
    // an octahedron with its equator in a face: no edge crosses a triangle
    let [c, r] = [[1.0, 1.0, 2.0], [0.5, 0.0, 0.0]];
    let at = |k: usize, s: f64| {
        let mut p: Point = c;
        p[k] += s * r[0];
        p
    };
    let octahedron: Vec<Triangle> = (0..8)
        .map(|k| {
            let sign = |bit: i32| if k & bit == 0 { 1.0 } else { -1.0 };
            let [x, y, z] = [at(0, sign(1)), at(1, sign(2)), at(2, sign(4))];
            if sign(1) * sign(2) * sign(4) > 0.0 { [x, y, z] } else { [x, z, y] }
        })
        .collect();
    both_ways(&[a(), octahedron], |diagnosis, _| assert!(!diagnosis.overlaps.is_empty()));
}

#[test]
fn solids_that_touch_are_one_body() {
    let a = || cuboid([0.0; 3], [2.0; 3], 1);
    let touching = [
        ("face on face", cuboid([2.0, 0.5, 0.5], [3.0, 1.5, 1.5], 1)),
        ("the same face", cuboid([2.0, 0.0, 0.0], [3.0, 2.0, 2.0], 1)),
        ("edge on face", cuboid([2.0, 2.0, 0.0], [3.0, 3.0, 2.0], 1)),
        ("corner on corner", cuboid([2.0; 3], [3.0; 3], 1)),
        ("corner on edge", cuboid([2.0, 2.0, 1.0], [3.0, 3.0, 3.0], 1)),
        ("a grid on a face", cuboid([2.0, -1.0, -1.0], [3.0, 3.0, 3.0], 4)),
    ];
    for (what, b) in touching {
        both_ways(&[a(), b.clone()], |diagnosis, solid| {
            assert!(
                diagnosis.overlaps.is_empty() && diagnosis.self_overlaps.is_empty(),
                "{what}: {diagnosis:?}"
            );
            let [whole, one, other] = [
                solid.unwrap(),
                ClosedMesh::from_triangles(a()).unwrap(),
                ClosedMesh::from_triangles(b.clone()).unwrap(),
            ];
            let scale = whole.volume() / (one.volume() + other.volume());
            assert!((scale - 1.0).abs() < 1e-14 || (scale - 27.0).abs() < 1e-12, "{what}: {scale}");
        });
    }
    // a cavity that touches the wall from inside
    let cavity = inward(cuboid([0.0, 0.5, 0.5], [1.0, 1.5, 1.5], 1));
    both_ways(&[a(), cavity], |diagnosis, solid| {
        assert_eq!(roles(diagnosis), [ComponentRole::Solid, ComponentRole::Cavity]);
        assert!(solid.is_ok() && !diagnosis.contacts.is_empty());
    });
}

#[test]
fn one_part_that_goes_through_itself_is_a_warning() {
    // a prism over a pentagram: its centre has winding number two
    let star = |k: u32, z: f64| {
        let angle = f64::from(2 * k) * std::f64::consts::TAU / 5.0;
        [angle.cos(), angle.sin(), z]
    };
    let mut triangles = Vec::new();
    for k in 0..5 {
        let [a, b, c, d] = [star(k, 0.0), star(k + 1, 0.0), star(k + 1, 1.0), star(k, 1.0)];
        let snap = |p: Point| p.map(|x| (x * 1e6).round() / 1e6);
        let [a, b, c, d] = [a, b, c, d].map(snap);
        triangles.extend([[a, b, c], [a, c, d], [[0.0; 3], b, a], [[0.0, 0.0, 1.0], d, c]]);
    }
    let diagnosis = diagnosis(std::slice::from_ref(&triangles));
    assert!(!diagnosis.self_overlaps.is_empty() && diagnosis.overlaps.is_empty());
    let solid = ClosedMesh::from_triangles(triangles).unwrap();
    assert_eq!(solid.findings()[0].code, "mesh.overlap");
}

#[test]
fn what_is_there_twice_or_flat_is_counted_with_its_place() {
    let mut parts = cuboid([0.0; 3], [2.0, 3.0, 4.0], 1);
    let [a, b, c] = parts[5];
    parts.extend([[b, c, a], [a, a, b], [c, b, a]]);
    let middle = [0, 1, 2].map(|k| 0.5 * (a[k] + b[k]));
    parts.push([a, middle, b]);
    let diagnosis = diagnosis(&[parts]);
    assert_eq!((diagnosis.duplicates.count, diagnosis.back_to_back.count), (1, 1));
    assert_eq!(diagnosis.duplicates.first.unwrap().triangles, [6, 13]);
    assert_eq!((diagnosis.degenerate.count, diagnosis.degenerate.first.unwrap().triangle), (1, 14));
    assert_eq!((diagnosis.collinear.count, diagnosis.collinear.first.unwrap().triangle), (1, 16));
    assert!(!diagnosis.non_manifold.is_empty() && !diagnosis.boundary.is_empty());
}

#[test]
fn empty_and_hopeless_meshes_are_told_apart() {
    assert_eq!(diagnosis(&[]), MeshDiagnosis::default());
    let [a, b, c] = [[0.0, 1.0, 2.0], [3.0, 1.0, 1.0], [0.5, 4.0, 2.5]];
    let flat = diagnosis(&[vec![[a, b, c], [a, c, b]]]);
    assert_eq!(roles(&flat), [ComponentRole::Flat]);
    let point = diagnosis(&[vec![[a; 3]; 7]]);
    assert_eq!((point.degenerate.count, point.vertices, point.components.len()), (7, 1, 0));
}

/// Returns the items in another order.
fn shuffled<T>(mut items: Vec<T>) -> Vec<T> {
    let mut state = 11_u64;
    for k in (1..items.len()).rev() {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        items.swap(k, (state >> 33) as usize % (k + 1));
    }
    items
}

#[test]
fn many_triangles_are_the_parts_that_they_make_in_any_order() {
    let mut parts =
        [cuboid([0.0, 1.0, -2.0], [2.0, 4.0, 3.0], 80), cuboid([3.0, 1.0, -2.0], [4.0, 2.0, 3.0], 30)];
    parts[0].iter_mut().step_by(9001).for_each(|t| t.swap(0, 1));
    for triangles in [parts.concat(), shuffled(parts.concat())] {
        let diagnosis = diagnosis(&slanted(&[triangles]));
        let mut found: Vec<_> =
            diagnosis.components.iter().map(|c| (c.triangles, c.flipped, c.role)).collect();
        found.sort_by_key(|part| part.0);
        assert_eq!(found, [(10_800, 0, ComponentRole::Solid), (76_800, 9, ComponentRole::Solid)]);
        assert_eq!((diagnosis.inconsistent.count, diagnosis.boundary.count), (27, 0));
        assert!(diagnosis.overlaps.is_empty() && diagnosis.self_overlaps.is_empty());
    }
}

#[test]
fn a_large_surface_with_one_side_is_found_in_any_order() {
    // Figure-eight immersion of the Klein bottle: a figure eight that makes half a turn along its
    // way round.
    let (n, m) = (300_u32, 120_u32);
    let point = |k: u32| {
        let [u, v] =
            [(k / m, n), (k % m, m)].map(|(k, n)| std::f64::consts::TAU * f64::from(k) / f64::from(n));
        let (x, z) = (v.sin(), (2.0 * v).sin());
        let distance = 3.0 + (0.5 * u).cos() * x - (0.5 * u).sin() * z;
        [distance * u.cos(), distance * u.sin(), (0.5 * u).sin() * x + (0.5 * u).cos() * z]
    };
    let number = |i: u32, j: u32| if i == n { (m - j % m) % m } else { i * m + j % m };
    let squares = (0..n * m).map(|k| (k / m, k % m));
    let triangles = squares.flat_map(|(i, j)| {
        let [a, b, c, d] = [number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)];
        [[a, b, c], [a, c, d]]
    });
    let triangles: Vec<_> = triangles.collect();
    for triangles in [triangles.clone(), shuffled(triangles)] {
        let bottle = TriangleMesh::new((0..n * m).map(point).collect(), triangles).unwrap();
        let diagnosis = MeshDiagnosis::of(&bottle);
        assert_eq!(roles(&diagnosis), [ComponentRole::Unorientable]);
        assert_eq!(diagnosis.boundary.count, 0);
        assert_eq!(MeshDiagnosis::with_threads(&bottle, 1), MeshDiagnosis::with_threads(&bottle, 8));
    }
}

/// Returns a surface about an oblique axis, given by two angles, of 2 n m triangles.
fn torus(n: u32, m: u32, at: impl Fn(f64, f64) -> Point) -> Vec<Triangle> {
    let angle = |k: u32, n: u32| std::f64::consts::TAU * f64::from(k % n) / f64::from(n);
    let point = |i: u32, j: u32| {
        let [x, y, z] = at(angle(i, n), angle(j, m));
        [0.36 * x + 0.48 * y - 0.8 * z, -0.8 * x + 0.6 * y + 0.1, 0.48 * x + 0.64 * y + 0.6 * z]
    };
    let squares = (0..n * m).map(|k| (k / m, k % m));
    let halves = squares.flat_map(|(i, j)| {
        let [a, b, c, d] = [point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)];
        [[a, b, c], [a, c, d]]
    });
    halves.collect()
}

#[test]
fn meshes_of_every_kind_are_measured_alike_with_and_without_search_and_threads() {
    let tube = |radius: f64, size: f64| {
        move |u: f64, v: f64| {
            let r = radius * (1.0 + 0.1 * (2.0 * u + v).sin());
            [(1.0 + r * v.cos()) * u.cos(), (1.1 + r * v.cos()) * u.sin(), r * v.sin()].map(|c| c * size)
        }
    };
    let ring = || torus(19, 11, tube(0.4, 1.0));
    let mut open = ring();
    open.remove(123);
    let mut turned = ring();
    turned.iter_mut().step_by(50).for_each(|t| t.swap(0, 1));
    let mut doubled = ring();
    doubled.extend(ring());
    // A corner on an edge of the neighbouring triangle, which has no corner there.
    let mut split = ring();
    let [a, b, c] = split.remove(7);
    let middle = [0, 1, 2].map(|k| 0.5 * (a[k] + b[k]));
    split.extend([[a, middle, c], [middle, b, c]]);
    // A ring around a ring, in a ring, in a cavity.
    let nested = [ring(), inward(torus(17, 9, tube(0.3, 1.0))), torus(15, 7, tube(0.15, 1.0))];
    let open_error = |edges: usize| move |solid: &Result<ClosedMesh, BodyError>| matches!(solid, Err(BodyError::OpenMesh { edges: found, .. }) if *found == edges);
    type Verdict = Box<dyn Fn(&Result<ClosedMesh, BodyError>) -> bool>;
    let has = |code: &'static str| -> Verdict {
        Box::new(move |solid| solid.as_ref().is_ok_and(|s| s.findings().iter().any(|f| f.code == code)))
    };
    let cases: [(&str, Vec<Vec<Triangle>>, Verdict); 9] = [
        ("closed", vec![ring()], Box::new(|solid| solid.as_ref().is_ok_and(|s| s.findings().is_empty()))),
        ("open", vec![open], Box::new(open_error(3))),
        ("self-intersecting", vec![torus(19, 11, tube(1.2, 1.0))], has("mesh.overlap")),
        ("inverted", vec![inward(ring())], has("mesh.inverted")),
        ("some turned", vec![turned], has("mesh.flipped")),
        ("doubled", vec![doubled], Box::new(|s| matches!(s, Err(BodyError::DuplicateTriangle { .. })))),
        ("T-junction", vec![split], Box::new(open_error(3))),
        ("nested", nested.to_vec(), has("mesh.cavity")),
        (
            "crossing",
            vec![ring(), torus(13, 8, tube(0.3, 0.9))],
            Box::new(|s| matches!(s, Err(BodyError::OverlappingMesh { .. }))),
        ),
    ];
    for (what, parts, is_expected) in cases {
        diagnosis(&parts);
        let solid = ClosedMesh::of(&mesh(&parts));
        assert!(is_expected(&solid), "{what}: {solid:?}");
    }
}
