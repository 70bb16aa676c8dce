//! Bodies that overlap: made by arithmetic alone, the same ones every time.

use std::f64::consts::TAU;

use polhode::body::mesh::TriangleMesh;

/// Pseudo-random numbers.
pub(super) struct Random(pub(super) u64);

impl Random {
    /// In (−1, 1).
    pub(super) fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    pub(super) fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * 0.5 * (self.next() + 1.0)
    }

    pub(super) fn point(&mut self, size: f64) -> [f64; 3] {
        [0; 3].map(|_| size * self.next())
    }

    fn below(&mut self, n: usize) -> usize {
        (self.within(0.0, n as f64) as usize).min(n - 1)
    }
}

/// A body's surface.
#[derive(Clone, Debug)]
pub(super) struct Body {
    pub(super) points: Vec<[f64; 3]>,
    pub(super) triangles: Vec<[u32; 3]>,
}

impl Body {
    pub(super) fn moved(mut self, place: impl Fn([f64; 3]) -> [f64; 3]) -> Self {
        self.points.iter_mut().for_each(|p| *p = place(*p));
        self
    }

    pub(super) fn inward(mut self) -> Self {
        self.triangles.iter_mut().for_each(|t| t.swap(1, 2));
        self
    }

    pub(super) fn with(mut self, other: &Self) -> Self {
        let first = self.points.len() as u32;
        self.points.extend_from_slice(&other.points);
        self.triangles.extend(other.triangles.iter().map(|t| t.map(|v| v + first)));
        self
    }
}

pub(super) fn mesh(bodies: &[Body]) -> TriangleMesh {
    let all = bodies.iter().skip(1).fold(bodies[0].clone(), Body::with);
    TriangleMesh::new(all.points, all.triangles).unwrap()
}

pub(super) fn brick(low: [f64; 3], high: [f64; 3]) -> Body {
    let corner = |k: usize| [0, 1, 2].map(|i| if k >> i & 1 == 0 { low[i] } else { high[i] });
    let squares = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let halves = squares.into_iter().flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]]);
    Body { points: (0..8).map(corner).collect(), triangles: halves.collect() }
}

pub(super) fn tetrahedron(size: f64) -> Body {
    let points = [[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]];
    let triangles = vec![[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]];
    Body { points: points.map(|p| p.map(|c| c * size)).to_vec(), triangles }
}

/// An icosahedron whose triangles were divided into four so often, on the unit sphere.
pub(super) fn sphere(divisions: u32) -> Body {
    let golden = 0.5 * (1.0 + 5.0_f64.sqrt());
    let mut points: Vec<[f64; 3]> = Vec::new();
    for (a, b) in [(1.0, golden), (-1.0, golden), (1.0, -golden), (-1.0, -golden)] {
        points.extend([[0.0, a, b], [a, b, 0.0], [b, 0.0, a]]);
    }
    let near = |i: usize, j: usize| (0..3).map(|k| (points[i][k] - points[j][k]).powi(2)).sum::<f64>() < 4.1;
    let mut triangles = Vec::new();
    for i in 0..12 {
        for j in i + 1..12 {
            for k in j + 1..12 {
                if near(i, j) && near(j, k) && near(i, k) {
                    let [a, b, c] = [points[i], points[j], points[k]];
                    let out = a[0] * (b[1] * c[2] - b[2] * c[1])
                        + a[1] * (b[2] * c[0] - b[0] * c[2])
                        + a[2] * (b[0] * c[1] - b[1] * c[0]);
                    triangles.push(if out > 0.0 { [i, j, k] } else { [i, k, j] }.map(|v| v as u32));
                }
            }
        }
    }
    let unit = |p: [f64; 3]| p.map(|c| c / p.iter().map(|c| c * c).sum::<f64>().sqrt());
    points = points.into_iter().map(unit).collect();
    for _ in 0..divisions {
        let mut middles = std::collections::HashMap::new();
        let mut middle = |a: u32, b: u32| {
            *middles.entry([a.min(b), a.max(b)]).or_insert_with(|| {
                let [p, q] = [a, b].map(|v| points[v as usize]);
                points.push(unit([0, 1, 2].map(|k| p[k] + q[k])));
                points.len() as u32 - 1
            })
        };
        let quarters = triangles.iter().flat_map(|&[a, b, c]: &[u32; 3]| {
            let [d, e, f] = [middle(a, b), middle(b, c), middle(c, a)];
            [[a, d, f], [d, b, e], [f, e, c], [d, e, f]]
        });
        triangles = quarters.collect();
    }
    Body { points, triangles }
}

pub(super) fn torus(around: u32, along: u32, radius: f64) -> Body {
    let point = |k: u32| {
        let [u, v] =
            [(k / along, around), (k % along, along)].map(|(i, n)| TAU * f64::from(i) / f64::from(n));
        let r = 1.0 + radius * v.cos();
        [r * u.cos(), r * u.sin(), radius * v.sin()]
    };
    let number = |i: u32, k: u32| i % around * along + k % along;
    let squares = (0..around).flat_map(|i| (0..along).map(move |k| (i, k)));
    let halves = squares.flat_map(|(i, k)| {
        let [a, b, c, d] = [number(i, k), number(i + 1, k), number(i + 1, k + 1), number(i, k + 1)];
        [[a, b, c], [a, c, d]]
    });
    Body { points: (0..around * along).map(point).collect(), triangles: halves.collect() }
}

/// A prism over an L of arms 2 and 3 long and 1 wide.
pub(super) fn angle(height: f64) -> Body {
    let outline = [[0.0, 0.0], [3.0, 0.0], [3.0, 1.0], [1.0, 1.0], [1.0, 2.0], [0.0, 2.0]];
    let level = |z: f64| outline.map(|[x, y]| [x, y, z]);
    let points = [level(0.0), level(height)].concat();
    let top = [[0, 1, 3], [1, 2, 3], [0, 3, 5], [3, 4, 5]];
    let mut triangles: Vec<[u32; 3]> = top.iter().map(|t| t.map(|v| v + 6)).collect();
    triangles.extend(top.iter().map(|&[a, b, c]| [a, c, b]));
    triangles.extend((0..6).flat_map(|k| {
        let (a, b) = (k, (k + 1) % 6);
        [[a, b, b + 6], [a, b + 6, a + 6]]
    }));
    Body { points, triangles }
}

/// A rotation about some axis by some angle.
pub(super) fn turned(random: &mut Random) -> impl Fn([f64; 3]) -> [f64; 3] + use<> {
    let q: [f64; 4] = [0; 4].map(|_| random.next());
    let norm = q.iter().map(|c| c * c).sum::<f64>().sqrt();
    let [w, x, y, z] = q.map(|c| c / norm);
    let rows = [
        [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
        [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
        [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)],
    ];
    move |p| rows.map(|row| row[0] * p[0] + row[1] * p[1] + row[2] * p[2])
}

pub(super) struct Case {
    pub(super) name: String,
    pub(super) bodies: Vec<Body>,
}

/// A kind of case, and what makes one.
type Kind = (&'static str, fn(&mut Random) -> Vec<Body>);

const KINDS: [Kind; 13] = [
    ("bricks", bricks),
    ("turned bricks", turned_bricks),
    ("spheres", spheres),
    ("rings", rings),
    ("tetrahedra", tetrahedra),
    ("angles", angles),
    ("mixed", mixed),
    ("on a grid", on_a_grid),
    ("on a turned grid", on_a_turned_grid),
    ("repeated", repeated),
    ("nested", nested),
    ("hollow", hollow),
    ("shifted a little", shifted_a_little),
];

/// Nine of each kind: at three sizes, each about the origin, a little and far off it.
pub(super) fn cases() -> Vec<Case> {
    let mut cases = Vec::new();
    for (seed, (kind, make)) in (1..).zip(KINDS) {
        for variant in 0..9 {
            let mut random = Random(100 * seed + variant);
            let scale = [1.0, 1e-3, 1e3][variant as usize / 3];
            let offset = [0.0, 1.0, 30.0][variant as usize % 3];
            let by = random.point(1.0).map(|c| c * offset);
            let place = |p: [f64; 3]| [0, 1, 2].map(|k| scale * (p[k] + by[k]));
            let bodies = make(&mut random).into_iter().map(|body| body.moved(place));
            cases.push(Case { name: format!("{kind} {}", variant + 1), bodies: bodies.collect() });
        }
    }
    cases
}

fn some(random: &mut Random, make: impl Fn(&mut Random) -> Body) -> Vec<Body> {
    (0..2 + random.below(7)).map(|_| make(random)).collect()
}

fn anywhere(body: Body, reach: f64, random: &mut Random) -> Body {
    let (turn, by) = (turned(random), random.point(reach));
    body.moved(turn).moved(|p| [0, 1, 2].map(|k| p[k] + by[k]))
}

fn any_brick(random: &mut Random) -> Body {
    let (middle, half) = (random.point(1.0), [0; 3].map(|_| random.within(0.2, 1.1)));
    brick([0, 1, 2].map(|k| middle[k] - half[k]), [0, 1, 2].map(|k| middle[k] + half[k]))
}

fn bricks(random: &mut Random) -> Vec<Body> {
    some(random, any_brick)
}

fn turned_bricks(random: &mut Random) -> Vec<Body> {
    some(random, |random| anywhere(any_brick(random), 0.3, random))
}

fn spheres(random: &mut Random) -> Vec<Body> {
    some(random, |random| {
        let radius = random.within(0.4, 1.2);
        anywhere(sphere(1).moved(|p| p.map(|c| radius * c)), 0.8, random)
    })
}

fn rings(random: &mut Random) -> Vec<Body> {
    some(random, |random| {
        let radius = random.within(0.15, 0.5);
        anywhere(torus(12, 7, radius), 0.8, random)
    })
}

fn tetrahedra(random: &mut Random) -> Vec<Body> {
    some(random, |random| {
        let size = random.within(0.3, 1.2);
        anywhere(tetrahedron(size), 0.6, random)
    })
}

fn angles(random: &mut Random) -> Vec<Body> {
    some(random, |random| {
        let height = random.within(0.3, 1.5);
        anywhere(angle(height), 1.2, random)
    })
}

fn mixed(random: &mut Random) -> Vec<Body> {
    some(random, |random| match random.below(5) {
        0 => anywhere(any_brick(random), 0.5, random),
        1 => anywhere(sphere(1), 0.7, random),
        2 => anywhere(torus(11, 6, 0.4), 0.7, random),
        3 => anywhere(tetrahedron(0.8), 0.7, random),
        _ => anywhere(angle(0.7), 0.7, random),
    })
}

/// Faces in one plane, edges on faces and edges, corners on all of them.
fn on_a_grid(random: &mut Random) -> Vec<Body> {
    some(random, |random| {
        let low = [0; 3].map(|_| random.below(4) as f64);
        let high = low.map(|c| c + 1.0 + random.below(3) as f64);
        match random.below(4) {
            0 => angle(1.0 + random.below(2) as f64).moved(|p| [0, 1, 2].map(|k| p[k] + low[k])),
            1 => tetrahedron(1.0).moved(|p| [0, 1, 2].map(|k| p[k] + high[k])),
            _ => brick(low, high),
        }
    })
}

/// The same, but for the rounding of every coordinate.
fn on_a_turned_grid(random: &mut Random) -> Vec<Body> {
    let turn = turned(random);
    on_a_grid(random).into_iter().map(|body| body.moved(&turn)).collect()
}

fn repeated(random: &mut Random) -> Vec<Body> {
    let mut bodies = mixed(random);
    bodies.truncate(4);
    let again = (0..1 + random.below(3)).map(|_| bodies[random.below(bodies.len())].clone());
    let again: Vec<_> = again.collect();
    bodies.extend(again);
    bodies
}

fn nested(random: &mut Random) -> Vec<Body> {
    let outer = anywhere(sphere(1), 0.1, random);
    let inner =
        [0.6, 0.3].map(|size| anywhere(torus(9, 6, 0.4).moved(|p| p.map(|c| 0.5 * size * c)), 0.1, random));
    let mut bodies = vec![outer];
    bodies.extend(inner);
    bodies.push(anywhere(any_brick(random), 0.5, random));
    bodies
}

/// A cavity, into which another body reaches.
fn hollow(random: &mut Random) -> Vec<Body> {
    let turn = turned(random);
    let cavity = anywhere(sphere(1), 0.05, random).moved(|p| p.map(|c| 0.7 * c)).inward();
    let shell = brick([-1.0, -1.1, -0.9], [1.2, 1.0, 1.1]).with(&cavity).moved(turn);
    let mut bodies = vec![shell];
    bodies.extend((0..1 + random.below(3)).map(|_| {
        let size = random.within(0.2, 0.7);
        anywhere(tetrahedron(size), 0.9, random)
    }));
    bodies
}

/// Nearly the same surfaces, everywhere.
fn shifted_a_little(random: &mut Random) -> Vec<Body> {
    let body = anywhere(sphere(1), 0.3, random);
    let by = [1e-2, 1e-3, 1e-4][random.below(3)];
    let by = random.point(by);
    let other = body.clone().moved(|p| [0, 1, 2].map(|k| p[k] + by[k]));
    vec![body, other, anywhere(any_brick(random), 0.5, random)]
}
