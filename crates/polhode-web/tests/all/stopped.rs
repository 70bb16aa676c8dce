//! Computations that nobody waits for end.

use std::time::{Duration, Instant};

use polhode_web::{RefusalKind, Watch};
use serde_json::json;

use crate::meshes::{Point, stl};
use crate::page::{Folder, Page};
use crate::session::motion;

/// Returns triangles from one point in all directions. All are close to each other at that point,
/// and none share an edge.
fn star(count: usize) -> Vec<[Point; 3]> {
    let mut state = 1_u64;
    let mut chance = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 40) as f32 / (1_u32 << 23) as f32 - 1.0
    };
    let mut ray = || {
        let toward: Point = std::array::from_fn(|_| chance());
        let beside = std::array::from_fn(|k| toward[k] + 1e-3 * chance());
        [[0.0; 3], toward, beside]
    };
    (0..count).map(|_| ray()).collect()
}

/// Answers until the client hangs up after a while.
fn answered_until_left<T>(what: &str, answer: impl Fn(&dyn Watch) -> T) -> T {
    let begun = Instant::now();
    let answer = answer(&|| begun.elapsed() < Duration::from_millis(50));
    let took = begun.elapsed();
    assert!(took < Duration::from_secs(2), "{what}: {took:?}");
    answer
}

#[test]
fn a_mesh_that_nobody_waits_for_is_left() {
    let folder = Folder::new("stopped");
    let star = stl(&star(60_000));
    let path = folder.file("later.stl", &stl(&[[[0.0; 3], [0.3, 0.2, 0.1], [0.1, 0.7, 0.2]]]));
    let page = Page::open(std::slice::from_ref(&path));
    page.drop_file(1, "star.stl", &star);
    let text = "[[body.part]]\nshape = \"mesh\"\nfile = \"star.stl\"\nunit = \"m\"\nmass = 1\n";
    page.drop_file(1, "star.toml", text.as_bytes());
    let scenario = page.open_dropped(1, "star.toml", &|| true).unwrap().id;
    let robot = "<robot name=\"r\"><link name=\"a\"><visual><geometry><mesh filename=\"star.stl\"/></geometry></visual></link></robot>";
    page.drop_file(1, "star.urdf", robot.as_bytes());
    let robot = page.open_dropped(1, "star.urdf", &|| true).unwrap().id;
    folder.file("later.stl", &star);
    let opened = answered_until_left("open", |watch| page.open_dropped(1, "star.stl", watch));
    assert_eq!(opened.unwrap_err().kind, RefusalKind::Ended);
    let mut moved = motion(text, &json!([]));
    moved["motion"]["document"] = scenario.into();
    for (what, message) in [("motion", moved), ("inspection", json!({ "document": { "id": 0 } }))] {
        let answer = answered_until_left(what, |watch| page.ask_watched(&message, watch));
        assert_eq!(answer["refusal"]["kind"], "ended", "{what}");
    }
    // The checks of a robot's meshes end undecided.
    let inspected = json!({ "document": { "id": robot } });
    let answer = answered_until_left("robot", |watch| page.ask_watched(&inspected, watch));
    assert_eq!(answer["kind"], "robot");
    // None of these results was kept.
    assert_eq!(page.documents().as_array().unwrap().len(), 3);
}
