//! Solids of links: which geometry is used, and regions that belong to several shapes.

use std::fs;
use std::path::Path;

use polhode_document::Report as _;
use polhode_robot::inertials::{Inertials, Origin, write_inertials};
use polhode_robot::model::Role;
use polhode_source::files::Memory;

use super::robot::wedge;
use super::{of, request, why_not};

fn urdf(geometry: &str) -> String {
    format!("<robot name=\"r\"><link name=\"a\">{geometry}</link></robot>")
}

fn shape(role: &str, xyz: &str, shape: &str) -> String {
    format!("<{role}><origin xyz=\"{xyz}\"/><geometry>{shape}</geometry></{role}>")
}

/// Writes the inertial of a link at 1000 kg/m³, from this geometry.
fn write(geometry: &[String], origin: Option<Origin>) -> Inertials {
    let open = wedge().replace("f 2 3 4\n", "");
    // Two tetrahedra that overlap, each closed, as parts of one file.
    let second = wedge()
        .replace("v 0.1 ", "v 0.3 ")
        .replace("f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n", "f 5 7 6\nf 5 6 8\nf 5 8 7\nf 6 7 8\n");
    let twice = format!("g one\n{}g two\n{second}", wedge());
    // A cavity as a part of its own, with inward normals.
    let hollow = twice.replace("f 5 7 6\nf 5 6 8\nf 5 8 7\nf 6 7 8", "f 5 6 7\nf 5 8 6\nf 5 7 8\nf 6 8 7");
    let mut files = Memory::from([
        ("r.urdf", &urdf(&geometry.concat())),
        ("wedge.obj", &wedge()),
        ("open.obj", &open),
        ("twice.obj", &twice),
        ("hollow.obj", &hollow),
    ]);
    let bracket = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/meshes/bracket.glb");
    files.insert("bracket.glb", fs::read(bracket).unwrap());
    let mut request = request("r.urdf", &[]);
    request.substance.density = Some("1000 kg/m^3".parse().unwrap());
    request.options.geometry = origin;
    write_inertials(&request, &files).unwrap()
}

#[track_caller]
fn near(a: f64, b: f64, tolerance: f64) {
    assert!((a - b).abs() <= tolerance * b.abs(), "{a} {b}");
}

#[test]
fn the_more_detailed_solid_is_used() {
    let mesh = |role| shape(role, "0 0 0", "<mesh filename=\"wedge.obj\" scale=\"0.1 0.1 0.1\"/>");
    let cube = |role| shape(role, "0 0 0", "<box size=\"0.1 0.1 0.1\"/>");
    let open = |role| shape(role, "0 0 0", "<mesh filename=\"open.obj\" scale=\"0.1 0.1 0.1\"/>");
    for (geometry, role, reason) in [
        (
            vec![mesh("visual"), cube("collision")],
            Role::Visual,
            "(4 triangles, closed); collision is coarser, with ",
        ),
        (
            vec![cube("visual"), mesh("collision")],
            Role::Collision,
            "(4 triangles, closed); visual is coarser, with ",
        ),
        (vec![cube("visual"), cube("collision")], Role::Visual, "1 shape; collision is the same solid"),
        (
            vec![cube("visual"), cube("collision"), shape("collision", "1 0 0", "<sphere radius=\"0.1\"/>")],
            Role::Collision,
            "2 shapes; visual is coarser",
        ),
        (vec![open("visual"), cube("collision")], Role::Collision, "1 shape; visual: \"open.obj\": "),
        (vec![cube("collision")], Role::Collision, "1 shape; no visual"),
    ] {
        let inertials = write(&geometry, None);
        let written = of(&inertials, "a");
        assert_eq!(written.role, role, "{}", written.reason);
        assert!(written.reason.contains(reason), "{}", written.reason);
    }
    let inertials = write(&[mesh("visual"), cube("collision")], Some(Origin::Collision));
    near(of(&inertials, "a").properties.mass(), 1.0, 1e-14);
    assert_eq!(of(&inertials, "a").reason, "1 shape; as requested");
    // The open mesh is not replaced by its hull.
    let inertials = write(&[open("visual")], None);
    assert!(why_not(&inertials, "a").starts_with("no usable solid: visual: \"open.obj\": "));
    assert!(inertials.has_failed());
    let inertials = write(&[shape("visual", "0 0 0", "<mesh filename=\"missing.obj\"/>")], None);
    assert!(why_not(&inertials, "a").contains("does not exist"), "{}", why_not(&inertials, "a"));
    let inertials = write(&[shape("visual", "0 0 0", "<mesh filename=\"bracket.glb\"/>")], None);
    assert!(
        why_not(&inertials, "a").contains("programs disagree on its up axis"),
        "{}",
        why_not(&inertials, "a")
    );
    let inertials = write(&[shape("visual", "0 0 nan", "<box size=\"1 1 1\"/>")], None);
    assert!(why_not(&inertials, "a").contains("its pose has \"nan\""), "{}", why_not(&inertials, "a"));
}

/// Two boxes, 0.2 × 0.1 × 0.1 and 0.1 × 0.1 × 0.3 m, that share 0.1 × 0.05 × 0.1 m.
#[test]
fn boxes_that_overlap_count_once() {
    let boxes = [
        shape("visual", "0 0 0", "<box size=\"0.2 0.1 0.1\"/>"),
        shape("visual", "0 0.05 0", "<box size=\"0.1 0.1 0.3\"/>"),
    ];
    let inertials = write(&boxes, None);
    let written = of(&inertials, "a");
    // Box by its middle, its edges, and its sign.
    let parts = [
        ([0.0, 0.0, 0.0], [0.2, 0.1, 0.1], 1.0),
        ([0.0, 0.05, 0.0], [0.1, 0.1, 0.3], 1.0),
        ([0.0, 0.025, 0.0], [0.1, 0.05, 0.1], -1.0),
    ];
    let volume = |size: [f64; 3], sign: f64| sign * size.iter().product::<f64>();
    let mass: f64 = 1000.0 * parts.iter().map(|(_, size, sign)| volume(*size, *sign)).sum::<f64>();
    let y = 1000.0 * parts.iter().map(|(at, size, sign)| volume(*size, *sign) * at[1]).sum::<f64>() / mass;
    let ixx = 1000.0
        * parts
            .iter()
            .map(|(at, [_, b, c], sign)| {
                volume(parts.iter().find(|part| part.0 == *at).unwrap().1, *sign)
                    * ((b * b + c * c) / 12.0 + (at[1] - y).powi(2))
            })
            .sum::<f64>();
    near(written.properties.mass(), mass, 1e-13);
    near(written.properties.center_of_mass().to_array()[1], y, 1e-12);
    near(written.properties.inertia().matrix()[0][0], ixx, 1e-12);
    assert!(written.reason.contains("overlaps of 11\u{a0}% counted once"), "{}", written.reason);
    assert!(!inertials.has_failed(), "{}", inertials.to_text(None));
    // The same box twice is one box, and boxes that touch have no overlap.
    let inertials = write(&[boxes[0].clone(), boxes[0].clone()], None);
    near(of(&inertials, "a").properties.mass(), 2.0, 1e-13);
    let inertials = write(
        &[
            boxes[0].clone(),
            shape("visual", "0.15 0 0", "<cylinder radius=\"0.05\" length=\"0.1\"/>"),
            shape("visual", "-0.2 0 0", "<box size=\"0.2 0.1 0.1\"/>"),
        ],
        None,
    );
    let written = of(&inertials, "a");
    near(written.properties.mass(), 4.0 + 1000.0 * std::f64::consts::PI * 0.00025, 1e-14);
    assert!(written.error < 1e-11 && !written.reason.contains("counted once"), "{written:?}");
}

/// Two balls of radius r at a distance d share a lens: V = π (4 r + d) (2 r − d)² / 12.
#[test]
fn round_shapes_that_overlap_have_an_error() {
    let (r, d) = (0.1_f64, 0.12_f64);
    let ball = |x: f64| shape("collision", &format!("{x} 0.02 0"), &format!("<sphere radius=\"{r}\"/>"));
    let inertials = write(&[ball(0.0), ball(d)], None);
    let written = of(&inertials, "a");
    let pi = std::f64::consts::PI;
    let lens = pi * (4.0 * r + d) * (2.0 * r - d).powi(2) / 12.0;
    let mass = 1000.0 * (8.0 / 3.0 * pi * r.powi(3) - lens);
    assert!(written.error > 1e-6 && written.error < 5e-3, "{}", written.error);
    near(written.properties.mass(), mass, written.error);
    near(written.properties.mass(), mass, 1e-3);
    // Two caps: each has ∫x² dV about the plane between them by the profile π (r² − (x + d/2)²).
    let cap = |power: i32| {
        let steps = 200_000;
        let width = (r - 0.5 * d) / f64::from(steps);
        (0..steps)
            .map(|k| (f64::from(k) + 0.5) * width)
            .map(|x| pi * (r * r - (x + 0.5 * d).powi(2)) * x.powi(power) * width)
            .sum::<f64>()
    };
    near(2.0 * cap(0), lens, 1e-9);
    let disc = |x: f64| {
        let s = r * r - (x + 0.5 * d).powi(2);
        0.25 * pi * s * s
    };
    let across: f64 = {
        let steps = 200_000;
        let width = (r - 0.5 * d) / f64::from(steps);
        (0..steps).map(|k| disc((f64::from(k) + 0.5) * width) * width).sum()
    };
    // About the axis of both balls, and about y through the middle.
    let one = 4.0 / 3.0 * pi * r.powi(3);
    let axial = 1000.0 * (2.0 * 0.4 * one * r * r - 4.0 * across);
    let lateral = 1000.0 * (2.0 * one * (0.4 * r * r + 0.25 * d * d) - 2.0 * (cap(2) + across));
    let tensor = written.properties.inertia().matrix();
    near(tensor[0][0], axial, written.error);
    near(tensor[1][1], lateral, written.error);
    near(written.properties.center_of_mass().to_array()[0], 0.5 * d, 1e-3);
    // Its numbers have no more digits than the error leaves.
    let digits = inertials
        .text()
        .split_once("izz=\"")
        .unwrap()
        .1
        .split_once('"')
        .unwrap()
        .0
        .trim_start_matches(['0', '.'])
        .len();
    assert!(digits <= 5, "{}", inertials.text());
    assert!(inertials.to_text(None).contains("error "), "{}", inertials.to_text(None));
    assert!(!inertials.has_failed());
}

#[test]
fn parts_of_a_mesh_that_overlap_count_once() {
    let mesh =
        |name: &str| shape("visual", "0 0 0", &format!("<mesh filename=\"{name}\" scale=\"0.1 0.1 0.1\"/>"));
    let (one, twice) = (write(&[mesh("wedge.obj")], None), write(&[mesh("twice.obj")], None));
    let [one, twice] = [&one, &twice].map(|inertials| of(inertials, "a").properties.mass());
    assert!(twice > 1.01 * one && twice < 1.9 * one, "{one} {twice}");
    let why = write(&[mesh("hollow.obj")], None);
    assert!(why_not(&why, "a").contains("wound inward"), "{}", why_not(&why, "a"));
    // The same mesh twice, and mirrored.
    let inertials = write(&[mesh("wedge.obj"), mesh("wedge.obj")], None);
    near(of(&inertials, "a").properties.mass(), one, 1e-12);
    let mirrored = shape("visual", "0 0 0", "<mesh filename=\"wedge.obj\" scale=\"-0.1 0.1 0.1\"/>");
    let inertials = write(&[mirrored.clone(), mirrored], None);
    near(of(&inertials, "a").properties.mass(), one, 1e-12);
}
