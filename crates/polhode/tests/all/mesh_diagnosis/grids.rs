//! Boxes, L-shapes and combs on a small integer grid, two or three together: cell counts determine
//! if they overlap.
//!
//! Every mesh is built in two ways. With unit squares, all contacts are along common edges and
//! corners. With as few triangles as possible, edges lie within faces and corners within edges.

use std::collections::HashMap;

use polhode::body::BodyError;
use polhode::body::mesh::{ClosedMesh, MeshDiagnosis, Triangle, TriangleMesh};

type Cell = [i32; 3];

/// Number of cells along each axis.
const SIZE: i32 = 5;

/// Pseudorandom integers below `n` (Knuth's MMIX generator).
struct Random(u64);

impl Random {
    fn below(&mut self, n: i32) -> i32 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) % n as u64) as i32
    }

    /// Returns an interval of at least `least` within `low` … `high`.
    fn stretch(&mut self, low: i32, high: i32, least: i32) -> [i32; 2] {
        let length = least + self.below(high - low - least + 1);
        let begin = low + self.below(high - low - length + 1);
        [begin, begin + length]
    }
}

/// Prism over a rectilinear polygon, counter-clockwise, along `axis`; wound inward if it is a
/// cavity.
#[derive(Clone, Debug)]
struct Prism {
    axis: usize,
    polygon: Vec<[i32; 2]>,
    along: [i32; 2],
    cavity: bool,
}

impl Prism {
    fn random(random: &mut Random) -> Self {
        let ([x, y], along) = ([0, 1].map(|_| random.stretch(0, SIZE, 1)), random.stretch(0, SIZE, 1));
        let rectangle = vec![[x[0], y[0]], [x[1], y[0]], [x[1], y[1]], [x[0], y[1]]];
        let (wide, high) = (x[1] - x[0], y[1] - y[0]);
        let polygon = match random.below(4) {
            0 if wide > 1 && high > 1 => {
                let (u, v) = (x[0] + 1 + random.below(wide - 1), y[0] + 1 + random.below(high - 1));
                vec![[x[0], y[0]], [x[1], y[0]], [x[1], v], [u, v], [u, y[1]], [x[0], y[1]]]
            }
            1 if wide > 2 && high > 1 => {
                // teeth of width one, upward
                let base = y[0] + 1 + random.below(high - 1);
                let mut polygon = vec![[x[0], y[0]], [x[1], y[0]]];
                let mut u = x[1];
                while u - x[0] > 2 {
                    polygon.extend([[u, y[1]], [u - 1, y[1]], [u - 1, base], [u - 2, base]]);
                    u -= 2;
                }
                polygon.extend([[u, y[1]], [x[0], y[1]]]);
                polygon
            }
            _ => rectangle,
        };
        Self { axis: random.below(3) as usize, polygon, along, cavity: random.below(6) == 0 }
    }

    /// Returns a cavity in a prism, if one of the trials lies in it.
    fn in_prism(prism: &Self, random: &mut Random) -> Option<Self> {
        let mut tried = (0..20).map(|_| Self { cavity: true, ..Self::random(random) });
        tried.find(|cavity| cavity.is_in(prism) && !prism.is_in(cavity))
    }

    fn is_in(&self, other: &Self) -> bool {
        cells().all(|cell| !self.holds(cell) || other.holds(cell))
    }

    /// True if each of the two has cells of its own and there are common cells. Then their surfaces
    /// cross.
    fn crosses(&self, other: &Self) -> bool {
        cells().any(|cell| self.holds(cell) && other.holds(cell)) && !self.is_in(other) && !other.is_in(self)
    }

    /// Returns the coordinates along the axes from those across and along the prism.
    fn place(&self, [u, v]: [i32; 2], w: i32) -> Cell {
        let mut p = [0; 3];
        (p[self.axis], p[(self.axis + 1) % 3], p[(self.axis + 2) % 3]) = (w, u, v);
        p
    }

    /// True if the cell is in the prism.
    fn holds(&self, cell: Cell) -> bool {
        let [u, v, w] = [1, 2, 0].map(|k| cell[(self.axis + k) % 3]);
        let edges = self.polygon.iter().zip(self.polygon.iter().cycle().skip(1));
        let right =
            edges.filter(|(a, b)| a[0] == b[0] && a[0] > u && (a[1].min(b[1])..a[1].max(b[1])).contains(&v));
        (self.along[0]..self.along[1]).contains(&w) && right.count() % 2 == 1
    }

    fn winding(&self, cell: Cell) -> i32 {
        i32::from(self.holds(cell)) * if self.cavity { -1 } else { 1 }
    }

    /// Adds a planar quadrilateral as two triangles.
    fn square(&self, mut corners: [Cell; 4], random: &mut Random, triangles: &mut Vec<[Cell; 3]>) {
        corners.rotate_left(random.below(2) as usize);
        let [a, b, c, d] = corners;
        self.add([a, b, c], triangles);
        self.add([a, c, d], triangles);
    }

    fn add(&self, [a, b, c]: [Cell; 3], triangles: &mut Vec<[Cell; 3]>) {
        triangles.push(if self.cavity { [a, c, b] } else { [a, b, c] });
    }

    /// Returns the surface as unit squares.
    fn fine(&self, random: &mut Random) -> Vec<[Cell; 3]> {
        let mut triangles = Vec::new();
        for cell in cells().filter(|&cell| self.holds(cell)) {
            for axis in 0..3 {
                for up in [0, 1] {
                    let mut beside = cell;
                    beside[axis] += 2 * up - 1;
                    if self.holds(beside) {
                        continue;
                    }
                    let corner = |i: i32, j: i32| {
                        let mut p = cell;
                        p[axis] += up;
                        p[(axis + 1) % 3] += i;
                        p[(axis + 2) % 3] += j;
                        p
                    };
                    let mut square = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)];
                    if up == 0 {
                        square.reverse();
                    }
                    self.square(square, random, &mut triangles);
                }
            }
        }
        triangles
    }

    /// Returns the surface with its own corners only.
    fn coarse(&self, random: &mut Random) -> Vec<[Cell; 3]> {
        let (mut triangles, n) = (Vec::new(), self.polygon.len());
        let [low, high] = self.along;
        for k in 0..n {
            let (p, q) = (self.polygon[k], self.polygon[(k + 1) % n]);
            let square = [self.place(p, low), self.place(q, low), self.place(q, high), self.place(p, high)];
            self.square(square, random, &mut triangles);
        }
        // The caps, by ear clipping.
        let mut rest = self.polygon.clone();
        while rest.len() > 2 {
            let n = rest.len();
            let turn = |a: [i32; 2], b: [i32; 2], c: [i32; 2]| {
                (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
            };
            let is_ear = |k: usize| {
                let [a, b, c] = [0, 1, 2].map(|i| rest[(k + i) % n]);
                let within = |p: &[i32; 2]| {
                    ![a, b, c].contains(p)
                        && turn(a, b, *p) >= 0
                        && turn(b, c, *p) >= 0
                        && turn(c, a, *p) >= 0
                };
                turn(a, b, c) > 0 && !rest.iter().any(within)
            };
            let first = random.below(n as i32) as usize;
            let k = (first..first + n).find(|&k| is_ear(k % n)).unwrap() % n;
            let [a, b, c] = [0, 1, 2].map(|i| rest[(k + i) % n]);
            self.add([self.place(a, high), self.place(b, high), self.place(c, high)], &mut triangles);
            self.add([self.place(a, low), self.place(c, low), self.place(b, low)], &mut triangles);
            rest.remove((k + 1) % n);
        }
        triangles
    }
}

fn cells() -> impl Iterator<Item = Cell> {
    (0..SIZE).flat_map(|x| (0..SIZE).flat_map(move |y| (0..SIZE).map(move |z| [x, y, z])))
}

/// Results of the cell counts of some prisms.
#[derive(Debug, Default)]
struct Counted {
    /// Lowest and highest winding number; at infinity it is 0.
    lowest: i32,
    highest: i32,
    volume: i32,
    /// True if two of them cross, or share a unit square with the same orientation. Such a mesh is
    /// refused even if a third one compensates for it.
    doubled: bool,
}

impl Counted {
    fn of(prisms: &[Prism]) -> Self {
        let mut counted = Self::default();
        for cell in cells() {
            let winding = prisms.iter().map(|prism| prism.winding(cell)).sum();
            counted.lowest = counted.lowest.min(winding);
            counted.highest = counted.highest.max(winding);
            counted.volume += winding;
        }
        counted.doubled = prisms.iter().enumerate().any(|(k, p)| prisms[..k].iter().any(|q| p.crosses(q)));
        let reach = (-1..SIZE).flat_map(|x| (-1..SIZE).flat_map(move |y| (-1..SIZE).map(move |z| [x, y, z])));
        counted.doubled |= reach.into_iter().any(|cell| {
            (0..3).any(|axis| {
                let mut next = cell;
                next[axis] += 1;
                let steps = prisms.iter().map(|prism| prism.winding(next) - prism.winding(cell));
                let steps: Vec<_> = steps.collect();
                [1, -1].iter().any(|way| steps.iter().filter(|&step| step == way).count() > 1)
            })
        });
        counted
    }

    fn is_sound(&self) -> bool {
        self.volume != 0 && (self.lowest == 0 && self.highest <= 1 || self.lowest >= -1 && self.highest == 0)
    }
}

/// Returns a mesh of the triangles, with shared vertices or with three per triangle; slanted, or
/// along the axes.
fn mesh(triangles: &[[Cell; 3]], merged: bool, slanted: bool) -> TriangleMesh {
    let place = |p: Cell| {
        let [x, y, z] = p.map(f64::from);
        // (2, −2, 1; 1, 2, 2; −2, −1, 2): three times a rotation, exact for small integers
        let turned = [2.0 * x - 2.0 * y + z + 5.0, x + 2.0 * y + 2.0 * z - 7.0, -2.0 * x - y + 2.0 * z + 0.5];
        if slanted { turned } else { [x, y, z] }
    };
    if !merged {
        let triangles: Vec<Triangle> = triangles.iter().map(|t| t.map(place)).collect();
        return TriangleMesh::of_triangles(&triangles).unwrap();
    }
    let (mut numbers, mut vertices) = (HashMap::new(), Vec::new());
    let mut number = |p: Cell| {
        *numbers.entry(p).or_insert_with(|| {
            vertices.push(place(p));
            vertices.len() as u32 - 1
        })
    };
    let indices = triangles.iter().map(|t| t.map(&mut number)).collect();
    TriangleMesh::new(vertices, indices).unwrap()
}

#[test]
fn what_overlaps_along_common_edges_is_refused_and_what_touches_is_not() {
    judge(2_500, true);
}

#[test]
fn what_overlaps_with_corners_in_edges_is_refused_and_what_touches_is_not() {
    judge(2_500, false);
}

/// Compares the diagnosis of random meshes with the cell counts, all by unit squares or all by
/// their own corners.
fn judge(rounds: u32, fine: bool) {
    let mut random = Random(if fine { 20 } else { 21 });
    // Numbers of meshes that were sound, touched each other, and were not sound.
    let [mut sound, mut touching, mut unsound] = [0; 3];
    for round in 0..rounds {
        let mut prisms: Vec<Prism> = (0..2 + random.below(2)).map(|_| Prism::random(&mut random)).collect();
        if random.below(3) == 0 {
            let last = prisms.len() - 1;
            prisms[last] = Prism::in_prism(&prisms[0], &mut random).unwrap_or(prisms[last].clone());
        }
        let counted = Counted::of(&prisms);
        let [merged, slanted] = [0, 1].map(|_| random.below(2) == 0);
        let parts = prisms.iter().map(|p| if fine { p.fine(&mut random) } else { p.coarse(&mut random) });
        let triangles: Vec<_> = parts.collect::<Vec<_>>().concat();
        let mesh = mesh(&triangles, merged, slanted);
        let solid = ClosedMesh::with_threads(&mesh, 1);
        let say = || format!("round {round}: {counted:?} {solid:?} {prisms:?}");
        match &solid {
            Ok(solid) => {
                assert!(counted.is_sound(), "{}", say());
                let volume = solid.volume() / if slanted { 27.0 } else { 1.0 };
                assert!((volume - f64::from(counted.volume.abs())).abs() < 1e-12 * volume, "{}", say());
                assert!(solid.findings().iter().all(|finding| finding.code != "mesh.overlap"), "{}", say());
                sound += 1;
                let diagnosis = solid.diagnosis();
                touching += usize::from(diagnosis.back_to_back.count + diagnosis.contacts.count > 0);
            }
            Err(error) => {
                assert!(!counted.is_sound() || counted.doubled, "{}", say());
                let named = matches!(
                    error,
                    BodyError::OverlappingMesh { .. }
                        | BodyError::DuplicateTriangle { .. }
                        | BodyError::NestedSolid { .. }
                        | BodyError::InvertedPart { .. }
                        | BodyError::FlatMesh { .. }
                );
                assert!(named, "{}", say());
                unsound += 1;
            }
        }
        if round % 100 == 0 {
            assert_eq!(MeshDiagnosis::with_threads(&mesh, 8), MeshDiagnosis::with_threads(&mesh, 1));
        }
    }
    assert!(sound > 250 && touching > 75 && unsound > 250, "{sound} {touching} {unsound}");
}
