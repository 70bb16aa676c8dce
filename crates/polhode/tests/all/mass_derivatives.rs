//! Derivatives of mass properties compared with differences, and their general properties.

use polhode::body::mesh::MeshDerivatives;
use polhode::body::shape::Ellipsoid;
use polhode::body::{
    AssemblyDerivatives, MassPropertiesDerivative, MassPropertiesGradient, ParticleDerivatives,
};
use polhode::motion::FreeMotionDerivatives;
use polhode::motion::torque::TorqueParameter;
use polhode::prelude::*;

/// Returns mass, centre of mass, and the tensor elements xx, yy, zz, xy, xz, yz.
fn numbers<F: polhode::math::Frame>(body: &MassProperties<F>) -> [f64; 10] {
    let [x, y, z] = body.center_of_mass().to_array();
    let [[xx, xy, xz], [_, yy, yz], [.., zz]] = body.inertia().matrix();
    [body.mass(), x, y, z, xx, yy, zz, xy, xz, yz]
}

fn changes<F>(by: &MassPropertiesDerivative<F>) -> [f64; 10] {
    let ([x, y, z], [xx, yy, zz, xy, xz, yz]) = (by.center_of_mass.to_array(), by.inertia);
    [by.mass, x, y, z, xx, yy, zz, xy, xz, yz]
}

/// Computes f′(0) by sixth-order differences.
fn difference<const N: usize>(h: f64, f: impl Fn(f64) -> [f64; N]) -> [f64; N] {
    let central = |k: f64| {
        let (a, b) = (f(k * h), f(-k * h));
        std::array::from_fn::<f64, N, _>(|i| (a[i] - b[i]) / (2.0 * k * h))
    };
    let [a, b, c] = [1.0, 2.0, 3.0].map(central);
    std::array::from_fn(|i| 1.5 * a[i] - 0.6 * b[i] + 0.1 * c[i])
}

/// Checks that all |a − b| are within a tolerance, relative to the largest number of their kind:
/// mass, centre, tensor.
#[track_caller]
fn assert_near(a: [f64; 10], b: [f64; 10], tolerance: f64, what: &str) {
    for (kind, range) in [("mass", 0..1), ("centre", 1..4), ("tensor", 4..10)] {
        let size = b[range.clone()].iter().fold(0.0, |max: f64, x| max.max(x.abs()));
        for k in range {
            let error = (a[k] - b[k]).abs();
            assert!(error <= tolerance * size.max(1.0), "{what}, {kind} {k}: {} is not {}", a[k], b[k]);
        }
    }
}

/// Returns a solid of 128 triangles with concave parts, off the origin and not aligned with the
/// axes.
fn lump(offset: [f64; 3]) -> TriangleMesh {
    let mut triangles: Vec<[[f64; 3]; 3]> = Vec::new();
    for octant in 0..8 {
        let sign = |bit: usize| if octant >> bit & 1 == 0 { 1.0 } else { -1.0 };
        let [x, y, z] = [[sign(0), 0.0, 0.0], [0.0, sign(1), 0.0], [0.0, 0.0, sign(2)]];
        let mut faces = vec![if sign(0) * sign(1) * sign(2) > 0.0 { [x, y, z] } else { [x, z, y] }];
        for _division in 0..2 {
            let middle = |p: [f64; 3], q: [f64; 3]| std::array::from_fn(|k| 0.5 * (p[k] + q[k]));
            let divide = |[a, b, c]: [[f64; 3]; 3]| {
                let (p, q, r) = (middle(a, b), middle(b, c), middle(c, a));
                [[a, p, r], [p, b, q], [r, q, c], [p, q, r]]
            };
            faces = faces.into_iter().flat_map(divide).collect();
        }
        triangles.extend(faces);
    }
    // On a grid of 2⁻¹⁰, so that integer offsets are exact.
    let moved = |[x, y, z]: [f64; 3]| {
        let r = 1.0 + 0.2 * (5.0 * x).sin() * (3.0 * y + 1.0).cos() + 0.1 * (4.0 * z).sin();
        let warped = [1.3 * r * x + 0.2 * y, 0.8 * r * y + 0.1 * z, 0.6 * r * z - 0.1 * x];
        std::array::from_fn(|k| (warped[k] * 1024.0).round() / 1024.0 + offset[k])
    };
    let triangles: Vec<_> = triangles.into_iter().map(|t| t.map(moved)).collect();
    TriangleMesh::of_triangles(&triangles).unwrap()
}

/// Returns the surface with one coordinate of a vertex moved.
fn moved(solid: &ClosedMesh, vertex: usize, axis: usize, by: f64) -> ClosedMesh {
    let mut points = solid.surface().coordinates().to_vec();
    points[vertex][axis] += by;
    ClosedMesh::of(&TriangleMesh::new(points, solid.surface().triangles().to_vec()).unwrap()).unwrap()
}

const SUBSTANCES: [Substance; 2] = [Substance::Density(1.7), Substance::Mass(2.9)];

#[test]
fn vertices_as_differences() {
    let solid = ClosedMesh::of(&lump([0.5, -0.25, 0.75])).unwrap();
    for substance in SUBSTANCES {
        let by_vertices = MeshDerivatives::of(&solid, substance).unwrap().by_vertices();
        for (vertex, axis) in [(0, 0), (7, 1), (19, 2), (40, 0), (53, 1), (65, 2)] {
            let differences = difference(2e-3, |h| {
                numbers(&moved(&solid, vertex, axis, h).mass_properties(substance).unwrap())
            });
            let by = changes(&by_vertices[vertex][axis]);
            assert_near(by, differences, 1e-10, &format!("{substance:?}, vertex {vertex}, axis {axis}"));
        }
    }
}

#[test]
fn vertices_moved_together() {
    let solid = ClosedMesh::of(&lump([0.5, -0.25, 0.75])).unwrap();
    for substance in SUBSTANCES {
        let derivatives = MeshDerivatives::of(&solid, substance).unwrap();
        let by_vertices = derivatives.by_vertices();
        let body = derivatives.properties();
        let none = MassPropertiesDerivative::by_mass(body) * 0.0;
        let along = |velocity: &dyn Fn([f64; 3]) -> [f64; 3]| {
            let each = solid.surface().coordinates().iter().zip(&by_vertices).map(|(&point, by)| {
                let [x, y, z] = velocity(point);
                by[0] * x + by[1] * y + by[2] * z
            });
            changes(&each.fold(none, |sum, by| sum + by))
        };
        // Translation along an axis, and rotation about an axis.
        let cross = |[a, b, c]: [f64; 3], [x, y, z]: [f64; 3]| [b * z - c * y, c * x - a * z, a * y - b * x];
        let point = Position::new(0.3, 0.1, -0.2);
        let moves = MassPropertiesDerivative::<Part>::by_translation();
        let turns = MassPropertiesDerivative::by_rotation(body, point);
        for (k, axis) in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].into_iter().enumerate() {
            assert_near(along(&|_| axis), changes(&moves[k]), 1e-13, "translation");
            let turn = |p: [f64; 3]| cross(axis, std::array::from_fn(|k| p[k] - point.to_array()[k]));
            assert_near(along(&turn), changes(&turns[k]), 1e-13, "rotation");
        }
        // Homogeneity: in lengths, the mass has degree 3, the centre 1, and the tensor 5; at
        // constant mass 0, 1, 2.
        let [mass, x, y, z, inertia @ ..] = numbers(body);
        let (of_mass, of_tensor) =
            if matches!(substance, Substance::Mass(_)) { (0.0, 2.0) } else { (3.0, 5.0) };
        let [xx, yy, zz, xy, xz, yz] = inertia.map(|i| of_tensor * i);
        assert_near(along(&|p| p), [of_mass * mass, x, y, z, xx, yy, zz, xy, xz, yz], 1e-13, "scale");
    }
}

#[test]
fn a_gradient_is_of_all_vertices_at_once() {
    let solid = ClosedMesh::of(&lump([0.5, -0.25, 0.75])).unwrap();
    let derivatives = MeshDerivatives::of(&solid, SUBSTANCES[0]).unwrap();
    let of_number = MassPropertiesGradient {
        by_mass: 0.3,
        by_center_of_mass: Direction::new(-0.7, 1.1, 0.4),
        by_inertia: [0.9, -0.2, 0.5, 1.3, -0.6, 0.8],
    };
    let gradient = derivatives.gradient(&of_number);
    for (by, all) in gradient.as_flattened().iter().zip(derivatives.by_vertices().as_flattened()) {
        assert!((by - of_number.derivative_along(all)).abs() < 1e-14);
    }
}

#[test]
fn far_from_the_origin_nothing_is_lost() {
    let near = ClosedMesh::of(&lump([0.0; 3])).unwrap();
    let far = ClosedMesh::of(&lump([3e8, -1e9, 2e9])).unwrap();
    let [near, far] = [&near, &far].map(|solid| {
        let derivatives = MeshDerivatives::of(solid, Substance::Density(1.7)).unwrap();
        derivatives.by_vertices().into_iter().flatten().map(|by| changes(&by)).collect::<Vec<_>>()
    });
    for (near, far) in near.iter().zip(&far) {
        assert_near(*far, *near, 1e-14, "far");
    }
}

#[test]
fn vertices_are_found_by_their_place() {
    let mesh = lump([0.5, -0.25, 0.75]);
    let solid = ClosedMesh::of(&mesh).unwrap();
    let numbers = solid.vertex_numbers(mesh.coordinates());
    for (point, number) in mesh.coordinates().iter().zip(numbers) {
        assert_eq!(solid.surface().coordinates()[number.unwrap() as usize], *point);
    }
    assert_eq!(solid.vertex_numbers(&[[0.5, -0.25, 0.75]]), [None]);
}

/// Parts of a body: each off its own origin, rotated, of another density; one is thin and one a
/// mesh.
#[derive(Clone)]
struct Built {
    densities: [f64; 3],
    positions: [[f64; 3]; 3],
    turns: [[f64; 3]; 3],
}

impl Built {
    fn generic() -> Self {
        Self {
            densities: [2.3, 0.9, 1.4],
            positions: [[0.2, -0.4, 0.1], [1.1, 0.3, -0.6], [-0.8, 0.7, 0.5]],
            turns: [[0.4, -0.3, 0.9], [-1.1, 0.2, 0.5], [0.1, 2.0, -0.7]],
        }
    }

    fn shapes() -> [Box<dyn Shape>; 3] {
        let mesh = ClosedMesh::of(&lump([0.25, 0.5, -0.125])).unwrap();
        [Box::new(Ellipsoid::new([0.5, 0.9, 1.2]).unwrap()), Box::new(Rod::new(1.7).unwrap()), Box::new(mesh)]
    }

    /// Returns the parts; `turned` is applied before the rotation of the part.
    fn parts(&self, turned: [[f64; 3]; 3]) -> Vec<PlacedPart> {
        let part = |k: usize| {
            let density = self.densities[k];
            let substance =
                if k == 1 { Substance::LineDensity(density) } else { Substance::Density(density) };
            let properties = Self::shapes()[k].mass_properties(substance).unwrap();
            let rotation: Rotation<Body, Part> = Rotation::exp(Direction::from_array(self.turns[k])).unwrap();
            let more: Rotation<Body, Body> = Rotation::exp(Direction::from_array(turned[k])).unwrap();
            // The part's own centre of mass is off its origin.
            let properties =
                properties.placed(Position::new(0.3, -0.2, 0.1), Rotation::<Part, Part>::identity());
            PlacedPart::new(properties.unwrap(), Position::from_array(self.positions[k]), more * rotation)
                .unwrap()
        };
        (0..3).map(part).collect()
    }

    fn body(&self) -> MassProperties<Body> {
        assemble(&self.parts([[0.0; 3]; 3])).unwrap()
    }
}

#[test]
fn parts_as_differences() {
    let built = Built::generic();
    let derivatives = AssemblyDerivatives::of(&built.parts([[0.0; 3]; 3])).unwrap();
    assert_eq!(derivatives.properties, built.body());
    for (k, part) in derivatives.parts.iter().enumerate() {
        let extent = Built::shapes()[k].spread().extent();
        let by_density = difference(1e-2, |h| {
            let mut built = built.clone();
            built.densities[k] += h;
            numbers(&built.body())
        });
        assert_near(changes(&part.by_density(extent)), by_density, 1e-11, "density");
        let by_mass = changes(&(part.by_mass() * extent.measure()));
        assert_near(by_mass, by_density, 1e-11, "mass");
        let in_body = built.parts([[0.0; 3]; 3])[k].in_body();
        let of_whole =
            MassPropertiesDerivative::by_mass(&in_body).of_whole(&in_body, &derivatives.properties);
        assert_near(changes(&of_whole), changes(&part.by_mass()), 1e-15, "of the whole");
        for axis in 0..3 {
            let by_position = difference(1e-2, |h| {
                let mut built = built.clone();
                built.positions[k][axis] += h;
                numbers(&built.body())
            });
            assert_near(changes(&part.by_position()[axis]), by_position, 1e-11, "position");
            let by_rotation = difference(1e-2, |h| {
                let mut turned = [[0.0; 3]; 3];
                turned[k][axis] = h;
                numbers(&assemble(&built.parts(turned)).unwrap())
            });
            assert_near(changes(&part.by_rotation()[axis]), by_rotation, 1e-10, "rotation");
        }
    }
}

#[test]
fn particles_as_differences() {
    let masses = [1.3, 0.4, 2.2, 0.9];
    let places = [[0.3, -1.1, 0.2], [0.7, 0.5, -0.9], [-0.6, 0.1, 1.4], [0.2, 0.8, 0.5]];
    let particles = |masses: [f64; 4], places: [[f64; 3]; 4]| -> Vec<Particle<Body>> {
        masses
            .into_iter()
            .zip(places)
            .map(|(m, p)| Particle::new(m, Position::from_array(p)).unwrap())
            .collect()
    };
    let of = |masses, places| numbers(&mass_properties_of_particles(&particles(masses, places)).unwrap());
    for (k, by) in ParticleDerivatives::of(&particles(masses, places)).unwrap().iter().enumerate() {
        let by_mass = difference(1e-2, |h| {
            let mut masses = masses;
            masses[k] += h;
            of(masses, places)
        });
        assert_near(changes(&by.by_mass), by_mass, 1e-11, "mass");
        for axis in 0..3 {
            let by_place = difference(1e-2, |h| {
                let mut places = places;
                places[k][axis] += h;
                of(masses, places)
            });
            assert_near(changes(&by.by_position[axis]), by_place, 1e-11, "place");
        }
    }
    assert!(ParticleDerivatives::<Body>::of(&[]).is_err());
}

fn start() -> State {
    let attitude = Attitude::from_quaternion([0.6, -0.3, 0.5, 0.55]).unwrap();
    State { time: 0.0, attitude, omega: AngularVelocity::new(0.7, -0.4, 1.1) }
}

/// Returns the difference from a state: θ along body axes, and ω.
fn from(state: &State, other: &State) -> [f64; 6] {
    let [a, b, c] = (state.attitude.inverse() * other.attitude).log().to_array();
    let [x, y, z] = other.omega.to_array();
    [a, b, c, x, y, z]
}

#[track_caller]
fn assert_same_change(by: [f64; 6], differences: [f64; 6], what: &str) {
    let size = differences.iter().fold(0.0, |max: f64, x| max.max(x.abs()));
    for (by, difference) in by.iter().zip(differences) {
        assert!((by - difference).abs() < 1e-9 * size, "{what}: {by} is not {difference}");
    }
}

#[test]
fn a_free_motion_by_parts_and_vertices() {
    let built = Built::generic();
    let at =
        |body: &MassProperties<Body>| FreeMotionDerivatives::of(&Rotor::free(body), start()).unwrap().at(5.0);
    let after = at(&built.body());
    let gradients = after.by_mass_properties(&Rotor::free(&built.body()));
    let derivatives = AssemblyDerivatives::of(&built.parts([[0.0; 3]; 3])).unwrap();
    let motion = |h: f64, change: &dyn Fn(&mut Built, f64)| {
        let mut built = built.clone();
        change(&mut built, h);
        from(&after.state, &at(&built.body()).state)
    };
    let extent = Built::shapes()[0].spread().extent();
    let by_density = difference(1e-2, |h| motion(h, &|built, h| built.densities[0] += h));
    let column = derivatives.parts[0].by_density(extent);
    assert_same_change(gradients.map(|row| row.derivative_along(&column)), by_density, "density");
    let by_position = difference(1e-2, |h| motion(h, &|built, h| built.positions[1][2] += h));
    let column = derivatives.parts[1].by_position()[2];
    assert_same_change(gradients.map(|row| row.derivative_along(&column)), by_position, "position");

    // The mesh among the parts, by one of its vertices.
    let solid = ClosedMesh::of(&lump([0.25, 0.5, -0.125])).unwrap();
    let of_mesh = MeshDerivatives::of(&solid, Substance::Density(built.densities[2])).unwrap();
    let (vertex, axis) = (19, 1);
    let by_vertex = difference(4e-3, |h| {
        let mut parts = built.parts([[0.0; 3]; 3]);
        let mesh =
            moved(&solid, vertex, axis, h).mass_properties(Substance::Density(built.densities[2])).unwrap();
        let mesh = mesh.placed(Position::new(0.3, -0.2, 0.1), Rotation::<Part, Part>::identity()).unwrap();
        let rotation = Rotation::exp(Direction::from_array(built.turns[2])).unwrap();
        parts[2] = PlacedPart::new(mesh, Position::from_array(built.positions[2]), rotation).unwrap();
        from(&after.state, &at(&assemble(&parts).unwrap()).state)
    });
    let by = gradients.map(|row| of_mesh.gradient(&derivatives.parts[2].gradient(&row))[vertex][axis]);
    assert_same_change(by, by_vertex, "vertex");
}

/// A top depends on all three: the tensor about the pivot, the lever, and the mass.
#[test]
fn a_top_by_the_mass_of_a_part() {
    let built = Built::generic();
    let torques = [TorqueModel::Gravity(UniformGravity { acceleration: Acceleration::new(0.3, -0.2, -2.0) })];
    let pivot = Position::new(0.4, -0.3, 0.2);
    let parameters =
        ["x", "y", "z", "lever.x", "lever.y", "lever.z"].map(|name| TorqueParameter { torque: 0, name });
    let at = |body: &MassProperties<Body>| {
        let rotor = Rotor::pivoted(body, pivot);
        let simulation = Simulation::new(&rotor, &torques, start(), &[3.0]).tolerance(1e-15);
        simulation.run_with_derivatives(&parameters).unwrap()
    };
    let body = built.body();
    let motion = at(&body);
    let after = &motion.states[0];
    let part = AssemblyDerivatives::of(&built.parts([[0.0; 3]; 3])).unwrap().parts[0];
    let extent = Built::shapes()[0].spread().extent();
    let change = part.by_density(extent) + part.by_position()[1] * 0.7;
    let TorqueModel::Gravity(gravity) = &torques[0] else { unreachable!() };
    // A body heavier by δM has the weight of one in a field stronger by g δM/M.
    let heavier = (gravity.acceleration * (change.mass / body.mass())).to_array();
    let lever = change.center_of_mass.to_array();
    let by_parameters = &motion.by_parameters[0];
    let gradients = after.by_mass_properties(&Rotor::pivoted(&body, pivot));
    let by: [f64; 6] = std::array::from_fn(|row| {
        let of_weight =
            (0..3).map(|k| by_parameters[k][row] * heavier[k] + by_parameters[3 + k][row] * lever[k]);
        gradients[row].derivative_along(&change) + of_weight.sum::<f64>()
    });
    let differences = difference(5e-3, |h| {
        let mut built = built.clone();
        built.densities[0] += h;
        built.positions[0][1] += 0.7 * h;
        from(&after.state, &at(&built.body()).states[0].state)
    });
    assert_same_change(by, differences, "density and place");
}
