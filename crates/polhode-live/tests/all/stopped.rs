//! Computations that no client waits for end, and others take their turn.

use std::io::Write as _;
use std::net::{SocketAddr, TcpStream};
use std::time::{Duration, Instant};

use serde_json::json;

use crate::client::{Folder, Page};
use crate::inspect::{Point, stl};

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

/// Returns the time that a third request waits after two others with the same request hung up.
fn left_by_two(page: &Page, request: &str) -> Duration {
    let address = SocketAddr::from(([127, 0, 0, 1], page.port));
    let asked = [(); 2].map(|()| {
        let mut stream = TcpStream::connect(address).unwrap();
        stream.write_all(request.as_bytes()).unwrap();
        stream
    });
    std::thread::sleep(Duration::from_millis(600));
    drop(asked);
    let begun = Instant::now();
    assert_eq!(page.get("lesson/nothing").status, 404);
    begun.elapsed()
}

#[test]
fn a_mesh_that_nobody_waits_for_is_left() {
    let folder = Folder::new("stopped");
    let star = stl(&star(60_000));
    let path = folder.file("later.stl", &stl(&[[[0.0; 3], [0.3, 0.2, 0.1], [0.1, 0.7, 0.2]]]));
    let page = Page::open(std::slice::from_ref(&path));
    let post = |what: &str, body: &str| {
        format!("{}Content-Length: {}\r\n\r\n{body}", page.head("POST", what), body.len())
    };
    assert_eq!(page.drop_file(1, "star.stl", &star).status, 200);
    let text = "[[body.part]]\nshape = \"mesh\"\nfile = \"star.stl\"\nunit = \"m\"\nmass = 1\n";
    assert_eq!(page.drop_file(1, "star.toml", text.as_bytes()).status, 200);
    let id = page.open_dropped(1, "star.toml").json()["id"].clone();
    let motion = json!({
        "document": id, "text": text, "edits": [], "error": false, "working": false, "body": null,
    });
    let robot = "<robot name=\"r\"><link name=\"a\"><visual><geometry><mesh filename=\"star.stl\"/></geometry></visual></link></robot>";
    assert_eq!(page.drop_file(1, "star.urdf", robot.as_bytes()).status, 200);
    let robot = page.open_dropped(1, "star.urdf").json()["id"].clone();
    folder.file("later.stl", &star);
    for (what, request) in [
        ("open", post("open", "{\"set\":1,\"name\":\"star.stl\"}")),
        ("motion", post("motion", &motion.to_string())),
        ("inspection", format!("{}\r\n", page.head("GET", "document/0"))),
        ("robot", format!("{}\r\n", page.head("GET", &format!("document/{robot}")))),
    ] {
        let left = left_by_two(&page, &request);
        assert!(left < Duration::from_secs(2), "{what}: {left:?}");
    }
    // None of these results was kept.
    assert_eq!(page.get("documents").json()["documents"].as_array().unwrap().len(), 3);
}
