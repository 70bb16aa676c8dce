//! Tests with corners of many faces, needles and touching bricks: the result must equal that of all
//! pairs, with a number of steps proportional to the number of triangles.

use core::f64::consts::TAU;

use super::super::TriangleMesh;
use super::super::component::Measured;
use super::super::diagnosis::Analysis;
use super::super::sought::Sought;
use super::super::weld::NONE;
use super::*;
use crate::body::error::BodyError;

type Soup = Vec<[[f64; 3]; 3]>;

/// Maps a point to an oblique coordinate system.
fn slanted([x, y, z]: [f64; 3]) -> [f64; 3] {
    [0.36 * x + 0.48 * y - 0.8 * z + 0.1, -0.8 * x + 0.6 * y, 0.48 * x + 0.64 * y + 0.6 * z - 0.3]
}

/// Returns a surface of revolution: `profile` lists radius and height, with `n` points per ring.
fn turned(n: u32, profile: &[[f64; 2]], place: impl Fn([f64; 3]) -> [f64; 3]) -> Soup {
    let point = |[r, z]: [f64; 2], k: u32| {
        let (s, c) = (TAU * f64::from(k % n) / f64::from(n)).sin_cos();
        place(slanted([r * c, r * s, z]))
    };
    let rings = profile.windows(2).flat_map(|pair| (0..n).map(move |k| (pair[0], pair[1], k)));
    let halves = rings.flat_map(|(a, b, k)| {
        let [p, q, r, s] = [point(a, k), point(a, k + 1), point(b, k + 1), point(b, k)];
        [[p, q, r], [p, r, s]]
    });
    halves.filter(|[a, b, c]| a != b && b != c && c != a).collect()
}

/// Profile of a solid with a waist whose ends are corners of n triangles.
const SPINDLE: [[f64; 2]; 5] = [[0.0, 0.0], [1.0, 0.2], [0.5, 1.0], [0.8, 2.0], [0.0, 2.5]];

/// Returns n triangular prisms side by side, as long as the whole row is wide.
fn needles(n: u32) -> Soup {
    let sides = |k: u32| {
        let (x, d) = (f64::from(k) / f64::from(n), 0.3 / f64::from(n));
        let low = [[x, 0.0, 0.0], [x + d, 0.0, 0.0], [x, 0.0, d]];
        let high = low.map(|[x, _, z]| [x + 1.0, 1.1, z + 0.9]);
        let ends = [low, [high[0], high[2], high[1]]];
        let sides = [0, 1, 2].map(|i| (i, (i + 1) % 3));
        let sides = sides.map(|(i, j)| [[low[i], high[i], low[j]], [low[j], high[i], high[j]]]);
        ends.into_iter().chain(sides.into_iter().flatten())
    };
    (0..n).flat_map(sides).collect()
}

/// Returns a wall of bricks in courses, each above the joints of the course below.
fn wall(n: u32) -> Soup {
    let corner = |k: u32| [k >> 2 & 1, k >> 1 & 1, k & 1].map(f64::from);
    let squares = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]];
    let brick = |x: u32, y: u32, z: u32| {
        let low = [2 * x + z % 2, y, z].map(f64::from);
        let place = move |k: u32| {
            let [u, v, w] = corner(k);
            [low[0] + 2.0 * u, low[1] + v, low[2] + w]
        };
        squares.into_iter().flat_map(move |[a, b, c, d]| [[a, b, c], [a, c, d]]).map(move |t| t.map(place))
    };
    let places = (0..n).flat_map(|x| (0..n).flat_map(move |y| (0..n).map(move |z| (x, y, z))));
    places.flat_map(|(x, y, z)| brick(x, y, z)).collect()
}

/// Returns a generator of pseudo-random numbers from −0.5 to 0.5.
fn chance() -> impl FnMut() -> f64 {
    let mut state = 3_u64;
    move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / 9_007_199_254_740_992.0 - 0.5
    }
}

/// Returns the intersections found with axis-parallel boxes and with oriented boxes, and the number
/// of triangles in umbrellas.
fn both(soup: &Soup, threads: usize) -> ([Meetings; 2], usize) {
    let (mesh, threads) = (TriangleMesh::of_triangles(soup).unwrap(), Threads::of(threads));
    let welded = Welded::of(&mesh, threads);
    let edges = Edges::of(&welded.corners, welded.points.len(), threads);
    let patches = Patches::of(&welded.corners, &edges, threads);
    let collinear = Measured::of(&welded, &patches, threads).collinear;
    let wanted = |t: usize| patches.component[t] != NONE && collinear.binary_search(&(t as u32)).is_err();
    let (tree, work) = (Tree::of(&welded, wanted, threads), Work::of(u64::MAX, &|| true));
    let windings = Windings { welded: &welded, tree: &tree, patches: &patches, work: &work };
    let (sought, found) = (Sought::All, Meetings::default());
    let search = Search { windings: &windings, lowest: Some(0), sought, threads, found };
    let side_by_side = umbrellas(&welded, tree.order(), &patches.component);
    let side_by_side = side_by_side.iter().filter(|&&group| group != NONE).count();
    ([search.by_boxes(&tree, u64::MAX).unwrap(), search.by_oriented_boxes(&tree)], side_by_side)
}

#[test]
fn oriented_boxes_and_umbrellas_lose_no_pair() {
    let mut chance = chance();
    let mut found = [0; 3];
    for round in 0..24 {
        let n = 70 + 7 * round;
        let mut soup = turned(n, &SPINDLE, |p| p);
        if round % 2 == 1 {
            // A second solid intersects the first, or touches it at an end.
            let by = if round % 4 == 1 { [0.0, 0.0, 2.5] } else { [chance(), chance(), chance()] };
            let by: [f64; 3] = core::array::from_fn(|k| slanted(by)[k] - slanted([0.0; 3])[k]);
            soup.extend(turned(n, &SPINDLE, |p| core::array::from_fn(|k| p[k] + by[k])));
        }
        if round % 3 == 2 {
            // Folds: corners are displaced at random; equal corners are displaced together.
            let mut moved = std::collections::HashMap::new();
            for p in soup.iter_mut().flatten() {
                let by = moved.entry(p.map(f64::to_bits)).or_insert_with(|| {
                    let size = if chance() > 0.4 { 0.2 } else { 0.0 };
                    [size * chance(), size * chance(), size * chance()]
                });
                *p = core::array::from_fn(|k| p[k] + by[k]);
            }
        }
        let ([by_boxes, by_oriented], side_by_side) = both(&soup, 1);
        assert_eq!(by_boxes, by_oriented, "{round}");
        assert_eq!(both(&soup, 3).0[1], by_oriented);
        assert!(by_boxes.within.count.max(by_boxes.between.count) < COUNTED);
        found[0] += side_by_side;
        found[1] += by_boxes.within.count;
        found[2] += by_boxes.between.count;
        if round % 6 == 0 {
            assert_eq!((side_by_side, by_boxes), (2 * n as usize, Meetings::default()));
        }
    }
    assert!(found.iter().all(|&count| count > 100), "{found:?}");
    let mut crossed = needles(120);
    crossed.extend(needles(90).iter().map(|t| t.map(|[x, y, z]| [x + 0.01, 1.1 - y, z + 0.003])));
    let ([by_boxes, by_oriented], _) = both(&crossed, 2);
    assert!(by_boxes == by_oriented && by_boxes.between.count > 0, "{by_boxes:?}");
}

#[test]
fn steps_go_with_the_triangles() {
    let steps = |soup: &Soup| {
        let mesh = TriangleMesh::of_triangles(soup).unwrap();
        let work = Work::of(u64::MAX, &|| true);
        let diagnosis = Analysis::within(&work, &mesh, Sought::All, Threads::of(2)).diagnosis;
        assert!(diagnosis.overlaps.is_empty() && diagnosis.self_overlaps.is_empty(), "{diagnosis:?}");
        work.done() as f64 / soup.len() as f64
    };
    type Shape = (&'static str, fn(u32) -> Soup, u32, u32);
    let shapes: [Shape; 5] = [
        ("cone", |n| turned(n, &[[0.0, 0.0], [1.0, 0.0], [0.0, 3.0]], |p| p), 1500, 6000),
        ("spindle", |n| turned(n, &SPINDLE, |p| p), 1000, 4000),
        (
            "pipe",
            |n| turned(n, &[[1.0, 0.0], [1.0, 5.0], [0.8, 5.0], [0.8, 0.0], [1.0, 0.0]], |p| p),
            1000,
            4000,
        ),
        ("needles", needles, 1000, 4000),
        ("wall", wall, 6, 10),
    ];
    for (name, shape, few, many) in shapes {
        let [few, many] = [few, many].map(|n| steps(&shape(n)));
        assert!(
            many < 2.0 * few.max(100.0) && many < 0.5 * 2000.0,
            "{name}: {few} and {many} for each triangle"
        );
    }
    // Solids in a row, none of which can lie in another.
    let apart = |n: u32| {
        (0..n).flat_map(|k| {
            needles(1).into_iter().map(move |t| t.map(|[x, y, z]| [x, y, z + 2.0 * f64::from(k)]))
        })
    };
    assert!(steps(&apart(3000).collect()) < 100.0);
}

#[test]
fn what_takes_too_many_steps_is_undecided() {
    let mut soup = turned(300, &SPINDLE, |p| p);
    soup.extend(turned(300, &SPINDLE, |[x, y, z]| [x + 0.1, y, z]));
    let mesh = TriangleMesh::of_triangles(&soup).unwrap();
    for (steps, undecided) in [(100, true), (u64::MAX, false)] {
        let work = Work::of(steps, &|| true);
        let diagnosis = Analysis::within(&work, &mesh, Sought::All, Threads::of(2)).diagnosis;
        assert_eq!(
            (diagnosis.undecided, diagnosis.overlaps.is_empty()),
            (undecided.then_some(steps), undecided)
        );
        let error = diagnosis.errors().remove(0);
        assert_eq!(matches!(error, BodyError::OverlapsUndecided { steps: 100, .. }), undecided, "{error}");
        assert!(matches!(error, BodyError::OverlapsUndecided { .. } | BodyError::OverlappingMesh { .. }));
    }
}

#[test]
fn what_is_ended_is_undecided_and_keeps_what_was_found_before() {
    use std::sync::atomic::{AtomicU64, Ordering};
    let mut soup = turned(2000, &SPINDLE, |p| p);
    soup.extend(turned(2000, &SPINDLE, |[x, y, z]| [x + 0.1, y, z]));
    soup.pop();
    let mesh = TriangleMesh::of_triangles(&soup).unwrap();
    let all = Work::of(u64::MAX, &|| true);
    let whole = Analysis::within(&all, &mesh, Sought::All, Threads::of(2)).diagnosis;
    assert!(whole.undecided.is_none() && all.done() > 1 << 17, "{}", all.done());
    let asked = AtomicU64::new(0);
    let goes_on_until = |last: u64| {
        asked.store(0, Ordering::Relaxed);
        let goes_on = || asked.fetch_add(1, Ordering::Relaxed) < last;
        let work = Work::of(u64::MAX, &goes_on);
        Analysis::within(&work, &mesh, Sought::All, Threads::of(2)).diagnosis
    };
    assert_eq!(goes_on_until(u64::MAX), whole);
    let asked_in_all = asked.load(Ordering::Relaxed);
    assert!(asked_in_all > 10);
    for last in [0, 1, 2, asked_in_all / 2, asked_in_all - 1] {
        let ended = goes_on_until(last);
        assert!(ended.undecided.is_some_and(|steps| steps < all.done()), "{last}: {:?}", ended.undecided);
        assert_eq!((ended.boundary, ended.boundary_loops), (whole.boundary, whole.boundary_loops));
        let [first, second] = &ended.errors()[..] else { panic!("{:?}", ended.errors()) };
        assert!(matches!(first, BodyError::OpenMesh { edges: 3, .. }));
        assert!(matches!(second, BodyError::OverlapsUndecided { .. }));
    }
}
