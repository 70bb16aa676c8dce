//! Meshes whose holes are closed within bounds, and welds of T-junctions.

use crate::common::{Scratch, json, number, refused, stdout};

/// Sides and bottom of a block with corners at x, whose top is missing and not planar; OBJ, mm.
/// Vertex numbers start after `after` others.
fn block(name: &str, x: f64, after: usize) -> String {
    let mut text = String::new();
    for [a, b, c] in CORNERS {
        text += &format!("v {} {b} {c}\n", x + a);
    }
    text += &format!("g {name}\n");
    for corners in SIDES {
        text += &face(corners, after);
    }
    text
}

const CORNERS: [[f64; 3]; 8] = [
    [0.0, 2.0, -1.0],
    [20.0, 2.0, -1.0],
    [20.0, 32.0, -1.0],
    [0.0, 32.0, -1.0],
    [0.0, 2.0, 11.0],
    [20.0, 2.0, 13.0],
    [20.0, 32.0, 12.0],
    [0.0, 32.0, 15.0],
];

const SIDES: [[usize; 3]; 10] = [
    [1, 3, 2],
    [1, 4, 3],
    [1, 2, 6],
    [1, 6, 5],
    [2, 3, 7],
    [2, 7, 6],
    [3, 4, 8],
    [3, 8, 7],
    [4, 1, 5],
    [4, 5, 8],
];

/// The two possible tops without further vertices.
const TOPS: [[[usize; 3]; 2]; 2] = [[[5, 6, 7], [5, 7, 8]], [[5, 6, 8], [6, 7, 8]]];

fn face(corners: [usize; 3], after: usize) -> String {
    let [a, b, c] = corners.map(|v| v + after);
    format!("f {a} {b} {c}\n")
}

fn flat(value: &serde_json::Value) -> Vec<f64> {
    match value {
        serde_json::Value::Array(all) => all.iter().flat_map(flat).collect(),
        other => vec![number(other)],
    }
}

#[test]
fn both_possible_surfaces_are_within_the_bounds_of_every_substance() {
    let scratch = Scratch::new("close");
    scratch.write("open.obj", &format!("{}{}", block("left", 3.0, 0), block("right", 40.0, 8)));
    let mut largest = 0.0_f64;
    let substances: [&[&str]; 4] = [
        &["--density", "2.7 g/cm^3"],
        &["--mass", "85 g"],
        &["--part", "left=steel", "--part", "right=20 g"],
        &["--part", "right=oak", "--mass", "85 g"],
    ];
    for substance in substances {
        let flags = [&["inertia", "open.obj", "--unit", "mm", "--json"], substance].concat();
        let found = json(&scratch.run(&[flags.as_slice(), &["--close-within", "10%"]].concat()));
        let bounds = &found["bounds"];
        assert_eq!(found["source"]["close_within"]["holes"], 2);
        assert_eq!(found["source"]["close_within"]["triangles"], 4);
        assert_eq!(found["source"]["volume_bound_m3"], bounds["volume"]);
        let share = number(&bounds["volume"]) / number(&found["volume"]);
        assert!((share / number(&bounds["volume_share"]) - 1.0).abs() < 1e-12 && share > 0.01);
        assert_eq!(number(&bounds["mass"]) == 0.0, substance == ["--mass", "85 g"]);
        for (k, left) in TOPS.iter().enumerate() {
            for (m, right) in TOPS.iter().enumerate() {
                let tops: String = left.iter().map(|top| face(*top, 0)).collect();
                let name = format!("true-{k}-{m}.obj");
                let right: String = right.iter().map(|top| face(*top, 8)).collect();
                scratch.write(
                    &name,
                    &format!("{}{tops}{}{right}", block("left", 3.0, 0), block("right", 40.0, 8)),
                );
                let flags = [&["inertia", name.as_str(), "--unit", "mm", "--json"], substance].concat();
                let truth = json(&scratch.run(&flags));
                let pairs = [
                    ("/volume", "/volume"),
                    ("/mass", "/mass"),
                    ("/center_of_mass", "/center_of_mass"),
                    ("/inertia/tensor", "/inertia"),
                ];
                for (value, bound) in pairs {
                    let [a, b] = [&found, &truth].map(|body| flat(body.pointer(value).unwrap()));
                    let bounds = flat(bounds.pointer(bound).unwrap());
                    for ((a, b), bound) in a.iter().zip(&b).zip(&bounds) {
                        let off = (a - b).abs();
                        assert!(off <= bound + 1e-15 * a.abs(), "{substance:?} {value}: {off:e} {bound:e}");
                        if *bound > 0.0 {
                            largest = largest.max(off / bound);
                        }
                    }
                }
                let [a, b] = [&found, &truth].map(|body| flat(&body["principal"]["moments"]));
                let bound = number(&bounds["principal_moments"]);
                assert!(a.iter().zip(&b).all(|(a, b)| (a - b).abs() <= bound), "{a:?} {b:?} {bound}");
            }
        }
    }
    // The other top of both blocks reaches the bound of the volume.
    assert!(largest > 0.99, "{largest}");
}

#[test]
fn the_report_states_bounds_and_the_note_names_the_largest_hole() {
    let scratch = Scratch::new("close-report");
    scratch.write("open.obj", &block("only", 3.0, 0));
    let flags = ["inertia", "open.obj", "--unit", "mm", "--density", "2.7 g/cm^3"];
    let refusal = refused(&scratch.run(&flags), 2);
    assert!(refusal.contains("with --close-within 6.3% closes its holes"), "{refusal}");
    let report = stdout(&scratch.run(&[flags.as_slice(), &["--close-within", "0.07"]].concat()));
    for line in [
        "error bounds     if the missing surfaces lie within the convex hulls of their holes\n",
        "closed within bounds: 1 hole, the largest 3.61e-2 m across at (1.300e-2, 1.700e-2, 1.275e-2) m; if the",
        "volume           ± 0.51 cm³ (6.3 %)\n",
        "mass             ± 1.4 g\n",
    ] {
        assert!(report.replace("\n  ", " ").contains(line) || report.contains(line), "{line}\n{report}");
    }
    let refusal = refused(&scratch.run(&[flags.as_slice(), &["--close-within", "6%"]].concat()), 2);
    for part in [
        "the holes leave 6.3% of the volume uncertain, more than 6%: 1 hole, the largest 3.61e-2 m across at (1.300e-2, 1.700e-2, 1.275e-2) m",
        "use --close-within 6.3%, or close the largest hole",
    ] {
        assert!(refusal.contains(part), "{part}\n{refusal}");
    }
    for wrong in ["5", "0", "-1%", "51%", "wide", ""] {
        refused(&scratch.run(&[flags.as_slice(), &[&format!("--close-within={wrong}")]].concat()), 2);
    }
    // A closed mesh has no holes.
    let top: String = TOPS[0].iter().map(|top| face(*top, 0)).collect();
    scratch.write("closed.obj", &format!("{}{top}", block("only", 3.0, 0)));
    let closed =
        ["inertia", "closed.obj", "--unit", "mm", "--density", "1", "--json", "--close-within", "1%"];
    let closed = json(&scratch.run(&closed));
    assert!(closed["bounds"].is_null() && closed["source"]["close_within"].is_null());
    assert!(closed["findings"].to_string().contains("nothing was closed: the mesh has no open edges"));
}

#[test]
fn bounds_of_a_weld_are_included_and_the_closed_mesh_is_written() {
    let scratch = Scratch::new("close-weld");
    // One corner of the bottom is torn by 1e-4 mm.
    let torn = block("only", 3.0, 0).replacen("g only\n", "v 3.0001 2 -1\ng only\n", 1);
    scratch.write("torn.obj", &torn.replace("f 1 3 2\n", "f 9 3 2\n"));
    let flags = ["inertia", "torn.obj", "--unit", "mm", "--density", "1", "--json", "--weld", "1 um"];
    let closed = [flags.as_slice(), &["--close-within", "7%", "--write-mesh", "whole.obj"]].concat();
    let closed = json(&scratch.run(&closed));
    let source = &closed["source"];
    let parts = [&source["weld"]["volume_bound_m3"], &source["close_within"]["volume_bound_m3"]].map(number);
    assert!(
        parts[0] > 0.0 && (number(&closed["bounds"]["volume"]) / (parts[0] + parts[1]) - 1.0).abs() < 1e-12
    );
    let again = json(&scratch.run(&["inertia", "whole.obj", "--unit", "mm", "--density", "1", "--json"]));
    assert!((number(&again["volume"]) / number(&closed["volume"]) - 1.0).abs() < 1e-12);
    assert_eq!(again["source"]["triangles"], 12);
}

#[test]
fn a_weld_reports_t_junctions() {
    let scratch = Scratch::new("junctions");
    let top: String = TOPS[0].iter().map(|top| face(*top, 0)).collect();
    let whole = format!("{}{top}", block("only", 3.0, 0));
    scratch.write("whole.obj", &whole);
    // The edge from 5 to 7 has a vertex on one side only, near its middle and 0.5 µm off it.
    let split =
        whole.replacen("g only\n", "v 13 17 11.5005\ng only\n", 1).replace("f 5 6 7\n", "f 5 6 9\nf 9 6 7\n");
    scratch.write("split.obj", &split);
    let flags = ["--unit", "mm", "--density", "1", "--json"];
    refused(&scratch.run(&["inertia", "split.obj"]), 2);
    let welded =
        json(&scratch.run(&[&["inertia", "split.obj", "--weld", "1 um"], flags.as_slice()].concat()));
    let whole = json(&scratch.run(&[&["inertia", "whole.obj"], flags.as_slice()].concat()));
    let weld = &welded["source"]["weld"];
    assert_eq!((&weld["t_junctions"], &weld["vertices"]), (&1.into(), &0.into()));
    let off = number(&weld["largest_offset_m"]);
    assert!(off > 4e-7 && off <= 5e-7, "{off}");
    let change = (number(&welded["volume"]) - number(&whole["volume"])).abs();
    assert!(change > 0.0 && change <= number(&weld["volume_bound_m3"]), "{change}");
    let said = welded["findings"][0]["message"].as_str().unwrap();
    assert!(
        said.starts_with("weld: 1 T-junction was welded, at most 5.00e-7 m from their edges; the volume"),
        "{said}"
    );
}
