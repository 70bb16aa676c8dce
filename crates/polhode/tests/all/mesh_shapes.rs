//! Every primitive compared with its own fine mesh, thin ones with sheets, and assemblies with the
//! union of placed meshes.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use polhode::body::mesh::{ConvexHull, MeshShell, Triangle};
use polhode::body::shape::{
    BoxShell, Capsule, Cone, ConeShell, CylinderShell, Disk, Ellipsoid, Plate, SphereShell, Tetrahedron,
    Torus, TriangularPlate, TriangularPrism,
};
use polhode::prelude::*;

/// Pseudorandom numbers (Knuth's MMIX generator).
struct Random(u64);

impl Random {
    fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        low + (high - low) * (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// Returns the surface of revolution of a profile (r, z), from the bottom up, with n steps around
/// the axis.
fn revolved(profile: &[[f64; 2]], n: u32) -> Vec<Triangle> {
    let point = |[r, z]: [f64; 2], j: u32| {
        let angle = f64::from(j % n) * TAU / f64::from(n);
        [r * angle.cos() + 0.0, r * angle.sin() + 0.0, z]
    };
    let strip = |pair: &[[f64; 2]]| {
        let (lower, upper) = (pair[0], pair[1]);
        (0..n)
            .flat_map(|j| {
                let [a, b, c, d] =
                    [point(lower, j), point(lower, j + 1), point(upper, j + 1), point(upper, j)];
                [[a, b, c], [a, c, d]]
            })
            .collect::<Vec<_>>()
    };
    profile.windows(2).flat_map(strip).collect()
}

/// Returns n steps along a circle about (r, z); points close to the axis are placed exactly on it.
fn arc([r, z]: [f64; 2], radius: f64, [from, to]: [f64; 2], n: u32) -> Vec<[f64; 2]> {
    let on_axis = |r: f64| if r.abs() < 1e-12 { 0.0 } else { r };
    let angle = |k: u32| from + (to - from) * f64::from(k) / f64::from(n);
    (0..=n).map(|k| [on_axis(r + radius * angle(k).cos()), z + radius * angle(k).sin()]).collect()
}

type Mesher = Box<dyn Fn(u32) -> Vec<Triangle>>;

/// Returns the convex mesh of a few corners.
fn hull(points: Vec<[f64; 3]>) -> Mesher {
    Box::new(move |_| ConvexHull::of(&points).unwrap().corners().collect())
}

fn corners_of_a_box(size: [f64; 3]) -> Vec<[f64; 3]> {
    (0..8).map(|k| [0, 1, 2].map(|i| if k >> i & 1 == 0 { -0.5 * size[i] } else { 0.5 * size[i] })).collect()
}

/// Returns every solid, with random sizes.
fn solids(random: &mut Random) -> Vec<(Box<dyn Shape>, Mesher)> {
    let [a, b, c] = [0; 3].map(|_| random.between(0.3, 2.0));
    let sphere = |n: u32| revolved(&arc([0.0; 2], 1.0, [-FRAC_PI_2, FRAC_PI_2], n / 2), n);
    let ellipsoid =
        move |n: u32| sphere(n).into_iter().map(|t| t.map(|[x, y, z]| [a * x, b * y, c * z])).collect();
    let can = move |n: u32| revolved(&[[0.0, -0.5 * b], [a, -0.5 * b], [a, 0.5 * b], [0.0, 0.5 * b]], n);
    let pill = move |n: u32| {
        let mut profile = arc([0.0, -0.5 * b], a, [-FRAC_PI_2, 0.0], n / 4);
        profile.extend(arc([0.0, 0.5 * b], a, [0.0, FRAC_PI_2], n / 4));
        revolved(&profile, n)
    };
    let cone = move |n: u32| revolved(&[[0.0, 0.0], [a, 0.0], [b, c], [0.0, c]], n);
    let tip = move |n: u32| revolved(&[[0.0, 0.0], [a, 0.0], [0.0, c]], n);
    let ring = move |n: u32| {
        let mut profile = arc([a + b, 0.0], a, [-PI, PI], n);
        profile[n as usize] = profile[0];
        revolved(&profile, n)
    };
    let wall = random.between(0.05, 0.95);
    let pipe = move |n: u32| {
        let (r, h) = (a * wall, 0.5 * b);
        revolved(&[[r, -h], [a, -h], [a, h], [r, h], [r, -h]], n)
    };
    // A cavity is a surface that is wound inward.
    let bubble = move |n: u32| -> Vec<Triangle> {
        let outer = sphere(n).into_iter().map(move |t| t.map(|p| p.map(|x| a * x)));
        let inner = sphere(n).into_iter().map(move |[p, q, r]| [p, r, q].map(|p| p.map(|x| wall * a * x)));
        outer.chain(inner).collect()
    };
    let base = [0; 3].map(|_| [0; 2].map(|_| random.between(-1.0, 1.0)));
    let prism = base.iter().flat_map(|&[x, y]| [[x, y, -0.5 * c], [x, y, 0.5 * c]]).collect();
    let tetrahedron = [0; 4].map(|_| [0; 3].map(|_| random.between(-1.0, 1.0)));
    vec![
        (
            Box::new(Sphere::new(a).unwrap()),
            Box::new(move |n| sphere(n).iter().map(|t| t.map(|p| p.map(|x| a * x))).collect()),
        ),
        (Box::new(Ellipsoid::new([a, b, c]).unwrap()), Box::new(ellipsoid)),
        (Box::new(Cylinder::new(a, b).unwrap()), Box::new(can)),
        (Box::new(Cylinder::hollow(a, a * wall, b).unwrap()), Box::new(pipe)),
        (Box::new(Sphere::hollow(a, a * wall).unwrap()), Box::new(bubble)),
        (Box::new(TriangularPrism::new(base, c).unwrap()), hull(prism)),
        (Box::new(Capsule::new(a, b).unwrap()), Box::new(pill)),
        (Box::new(Cone::new(a, b, c).unwrap()), Box::new(cone)),
        (Box::new(Cone::new(a, 0.0, c).unwrap()), Box::new(tip)),
        (Box::new(Torus::new(a + b, a).unwrap()), Box::new(ring)),
        (Box::new(BoxShape::new([a, b, c]).unwrap()), hull(corners_of_a_box([a, b, c]))),
        (Box::new(Tetrahedron::new(tetrahedron).unwrap()), hull(tetrahedron.to_vec())),
    ]
}

/// Returns every thin surface, with random sizes.
fn surfaces(random: &mut Random) -> Vec<(Box<dyn Shape>, Mesher)> {
    let [a, b, c] = [0; 3].map(|_| random.between(0.3, 2.0));
    let sphere = move |n: u32| revolved(&arc([0.0; 2], a, [-FRAC_PI_2, FRAC_PI_2], n / 2), n);
    let can = move |n: u32| revolved(&[[0.0, -0.5 * b], [a, -0.5 * b], [a, 0.5 * b], [0.0, 0.5 * b]], n);
    let tube = move |n: u32| revolved(&[[a, -0.5 * b], [a, 0.5 * b]], n);
    let wall = move |n: u32| revolved(&[[a, 0.0], [b, c]], n);
    let lampshade = move |n: u32| revolved(&[[0.0, 0.0], [a, 0.0], [b, c], [0.0, c]], n);
    let corners = [0; 3].map(|_| [0; 2].map(|_| random.between(-1.0, 1.0)));
    let triangle = move |_| vec![corners.map(|[x, y]| [x, y, 0.0])];
    let plate = move |_| {
        let [p, q, r, s] = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]
            .map(|[x, y]| [0.5 * a * x, 0.5 * b * y, 0.0]);
        vec![[p, q, r], [p, r, s]]
    };
    vec![
        (Box::new(SphereShell::new(a).unwrap()), Box::new(sphere)),
        (Box::new(CylinderShell::new(a, b, true).unwrap()), Box::new(can)),
        (Box::new(CylinderShell::new(a, b, false).unwrap()), Box::new(tube)),
        (Box::new(Disk::new(a).unwrap()), Box::new(move |n| revolved(&[[0.0, 0.0], [a, 0.0]], n))),
        (Box::new(ConeShell::new(a, b, c, false).unwrap()), Box::new(wall)),
        (Box::new(ConeShell::new(a, b, c, true).unwrap()), Box::new(lampshade)),
        (Box::new(TriangularPlate::new(corners).unwrap()), Box::new(triangle)),
        (Box::new(Plate::new([a, b]).unwrap()), Box::new(plate)),
        (Box::new(BoxShell::new([a, b, c]).unwrap()), hull(corners_of_a_box([a, b, c]))),
    ]
}

/// Returns area, centre and tensor at unit mass.
fn numbers(shape: &dyn Shape) -> Vec<f64> {
    let body = shape.mass_properties(Substance::Mass(1.0)).unwrap();
    let center = body.center_of_mass().to_array();
    let tensor = body.inertia().matrix();
    [&[shape.surface_area()], &center[..], tensor.as_flattened()].concat()
}

/// Checks that meshes of n and 2n steps extrapolate to the shape, as their errors fall by a factor
/// of four.
fn assert_limit(shape: &dyn Shape, mesh: impl Fn(u32) -> Vec<f64>) {
    let (exact, coarse, fine) = (numbers(shape), mesh(64), mesh(128));
    for ((want, coarse), fine) in exact.into_iter().zip(coarse).zip(fine) {
        let extrapolated = (4.0 * fine - coarse) / 3.0;
        assert!(
            (extrapolated - want).abs() < 3e-5 * want.abs().max(1.0),
            "{shape:?}: {extrapolated}, not {want}"
        );
        assert!((fine - want).abs() < 1e-2 * want.abs().max(1.0), "{shape:?}: {fine}, not {want}");
    }
}

#[test]
fn every_solid_is_the_limit_of_its_meshes() {
    let mut random = Random(1);
    for _case in 0..3 {
        for (shape, triangles) in solids(&mut random) {
            assert_limit(&*shape, |n| {
                let mesh = ClosedMesh::from_triangles(triangles(n)).unwrap();
                let usual = |code: &str| matches!(code, "mesh.degenerate" | "mesh.cavity");
                assert!(mesh.findings().iter().all(|f| usual(f.code)), "{:?}", mesh.findings());
                numbers(&mesh)
            });
            let volume = |n| ClosedMesh::from_triangles(triangles(n)).unwrap().volume();
            let want = shape.spread().extent().volume().unwrap();
            assert!(((4.0 * volume(96) - volume(48)) / 3.0 / want - 1.0).abs() < 1e-5, "{shape:?}");
        }
    }
}

#[test]
fn every_thin_surface_is_the_limit_of_its_sheets() {
    let mut random = Random(2);
    for _case in 0..5 {
        for (shape, triangles) in surfaces(&mut random) {
            assert_limit(&*shape, |n| {
                let sheet =
                    MeshShell::new(&TriangleMesh::of_triangles(&triangles(n)).unwrap(), 1e-9).unwrap();
                numbers(&sheet)
            });
        }
    }
}

#[test]
fn a_thick_sheet_is_a_brick_wherever_it_lies() {
    let (size, thickness) = ([1.7, 0.9], 0.3);
    let brick = BoxShape::new([size[0], size[1], thickness]).unwrap();
    let turn = Rotation::from_axis_angle(Direction::new(0.3, -0.5, 0.8), 1.1).unwrap();
    let offset = Position::new(1e3, -2e3, 5e2);
    let place = |x: f64, y: f64| {
        (turn * Position::new(0.5 * size[0] * x, 0.5 * size[1] * y, 0.0) + offset).to_array()
    };
    let [p, q, r, s] = [place(-1.0, -1.0), place(1.0, -1.0), place(1.0, 1.0), place(-1.0, 1.0)];
    let sheet =
        MeshShell::new(&TriangleMesh::of_triangles(&[[p, q, r], [p, s, r]]).unwrap(), thickness).unwrap();
    let sheet = sheet.mass_properties(Substance::Density(2.5)).unwrap();
    let brick = brick.mass_properties(Substance::Density(2.5)).unwrap();
    let placed: PlacedPart = PlacedPart::new(brick, offset, turn).unwrap();
    let want = placed.in_body();
    assert!((sheet.mass() / want.mass() - 1.0).abs() < 1e-12);
    for (got, want) in
        sheet.inertia().matrix().as_flattened().iter().zip(want.inertia().matrix().as_flattened())
    {
        assert!((got - want).abs() < 1e-12, "{got} {want}"); // corners rounded at 2000
    }
    let mesh = TriangleMesh::of_triangles(&[[p, q, r]]).unwrap();
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(MeshShell::new(&mesh, bad), Err(BodyError::Parameter { .. })));
    }
    let nothing = TriangleMesh::of_triangles(&[[p, p, q]]).unwrap();
    assert!(matches!(MeshShell::new(&nothing, 1.0), Err(BodyError::Empty { .. })));
    assert!(matches!(MeshShell::new(&TriangleMesh::default(), 1.0), Err(BodyError::Empty { .. })));
}

#[test]
fn an_assembly_is_the_union_of_its_placed_meshes() {
    let mut random = Random(3);
    for _case in 0..5 {
        let (mut parts, mut union) = (Vec::new(), Vec::new());
        for (k, (_, triangles)) in solids(&mut random).into_iter().enumerate() {
            let triangles = triangles(24);
            let axis = Direction::new(random.between(-1.0, 1.0), random.between(-1.0, 1.0), 0.4);
            let turn = Rotation::from_axis_angle(axis, random.between(-3.0, 3.0)).unwrap();
            // apart from each other: nothing is wider than 12
            let place = Position::new(13.0 * k as f64, random.between(-9.0, 9.0), random.between(-9.0, 9.0));
            let part = ClosedMesh::from_triangles(triangles.clone()).unwrap();
            let part = part.mass_properties(Substance::Density(700.0)).unwrap();
            parts.push(PlacedPart::new(part, place, turn).unwrap());
            let point = |p: [f64; 3]| (turn * Position::from_array(p) + place).to_array();
            union.extend(triangles.into_iter().map(|t| t.map(point)));
        }
        let want = assemble(&parts).unwrap();
        let mesh = ClosedMesh::from_triangles(union).unwrap();
        let got = mesh.mass_properties(Substance::Density(700.0)).unwrap();
        assert!((got.mass() / want.mass() - 1.0).abs() < 1e-13);
        let (a, b) = (got.center_of_mass().to_array(), want.center_of_mass().to_array());
        assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-12));
        let (a, b) = (got.inertia().matrix(), want.inertia().matrix());
        let scale = 0.5 * (0..3).map(|k| b[k][k]).sum::<f64>();
        assert!(a.as_flattened().iter().zip(b.as_flattened()).all(|(a, b)| (a - b).abs() < 1e-14 * scale));
    }
}
