//! Files for which a plausible fix was wrong: only the fix that all evidence confirms is applied.

use std::convert::Infallible;

use polhode_robot::finding::{Finding, Severity};
use polhode_robot::geometry::Shapes;
use polhode_robot::inspect::inspect;
use polhode_robot::model::{RobotModel, Tensor};
use polhode_robot::read::{ReadOptions, read_model, read_text};
use polhode_robot::repair::proved;

use crate::check_common::{number, only};
use crate::common::Folder;

fn found(model: &RobotModel) -> Vec<Finding> {
    inspect(model, &Shapes::default()).findings
}

/// Returns the findings of a model in a folder, its fixed text, and the findings of that text.
fn fixed(folder: &Folder, file: &str) -> (Vec<Finding>, String, Vec<Finding>) {
    let path = folder.path(file);
    let model = read_model(&path, &ReadOptions::default()).unwrap();
    let findings = found(&model);
    let check = |text: &str| {
        let model = read_text(text, &path, &ReadOptions::default()).unwrap();
        Ok::<_, Infallible>(found(&model))
    };
    let (repaired, remaining) = proved(&model, &findings, check).unwrap();
    (findings, repaired.text, remaining)
}

fn suspects(findings: &[Finding]) -> Vec<(&str, &'static str)> {
    let suspects = findings.iter().filter(|f| f.severity > Severity::Note);
    suspects.map(|f| (f.subject.as_str(), f.code)).collect()
}

/// Returns a robot with one moving link and a shape.
fn one(inertial: &str, shape: &str) -> String {
    format!(
        "<robot name=\"r\"><link name=\"root\"/><link name=\"a\"><inertial>{inertial}</inertial><collision><geometry>{shape}\
         </geometry></collision></link><joint name=\"j\" type=\"continuous\"><parent link=\"root\"/><child link=\"a\"/>\
         <axis xyz=\"0 0 1\"/></joint></robot>"
    )
}

fn of_one(mass: &str, [xx, yy, zz]: [&str; 3], shape: &str) -> (Vec<Finding>, String, Vec<Finding>) {
    let inertial = format!(
        "<origin xyz=\"0 0 0\"/><mass value=\"{mass}\"/>\
         <inertia ixx=\"{xx}\" ixy=\"0\" ixz=\"0\" iyy=\"{yy}\" iyz=\"0\" izz=\"{zz}\"/>"
    );
    let folder = Folder::of(&format!("fix-{mass}-{zz}"), &[("r.urdf", &one(&inertial, shape))]);
    fixed(&folder, "r.urdf")
}

/// Returns the moments of the second link of a text.
fn moments(text: &str) -> [f64; 3] {
    let model = read_text(text, "r.urdf".as_ref(), &ReadOptions::default()).unwrap();
    let Tensor::Six(slots) = &model.links[1].inertial.as_ref().unwrap().tensor else { panic!("six numbers") };
    [0, 1, 2].map(|k| slots[k].finite().unwrap())
}

fn assert_moments(text: &str, right: [f64; 3]) {
    for (moment, right) in moments(text).iter().zip(right) {
        assert!((moment / right - 1.0).abs() < 1e-6, "{moment} {right}\n{text}");
    }
}

/// Returns a closed box as ASCII STL.
fn stl([x, y, z]: [f64; 3]) -> String {
    let corner = |k: usize| {
        [
            if k & 1 == 0 { -x / 2.0 } else { x / 2.0 },
            if k & 2 == 0 { -y / 2.0 } else { y / 2.0 },
            if k & 4 == 0 { 0.0 } else { z },
        ]
    };
    let faces = [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];
    let mut text = "solid box\n".to_owned();
    for [a, b, c, d] in faces {
        for triangle in [[a, b, c], [a, c, d]] {
            let vertices: String =
                triangle.map(corner).iter().map(|[x, y, z]| format!("vertex {x} {y} {z}\n")).collect();
            text.push_str(&format!("facet normal 0 0 0\nouter loop\n{vertices}endloop\nendfacet\n"));
        }
    }
    text + "endsolid box\n"
}

/// Returns the results for a forearm of 1.2 kg, 60 mm × 40 mm × 250 mm, with a moment and a shape.
fn forearm(ixx: &str, shape: &str, folder: &str) -> (Vec<Finding>, String, Vec<Finding>) {
    let inertial = format!(
        "<origin xyz=\"0 0 0.125\"/><mass value=\"1.2\"/>\
         <inertia ixx=\"{ixx}\" iyy=\"0.00661\" izz=\"0.00052\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/>"
    );
    let files = [("r.urdf", one(&inertial, shape)), ("fore.stl", stl([60.0, 40.0, 250.0]))];
    let files = files.each_ref().map(|(name, text)| (*name, text.as_str()));
    fixed(&Folder::of(folder, &files), "r.urdf")
}

#[test]
fn geometry_in_millimetres_gets_a_scale_and_the_tensor_stays() {
    for (shape, right, folder) in [
        (
            "<mesh filename=\"fore.stl\"/>",
            "<mesh filename=\"fore.stl\" scale=\"0.001 0.001 0.001\"/>",
            "fix-mesh-in-mm",
        ),
        (
            "<mesh filename='fore.stl' scale='1 -1 1.0'/>",
            "<mesh filename='fore.stl' scale='0.001 -0.001 0.0010'/>",
            "fix-mirrored-mesh-in-mm",
        ),
        ("<box size=\"60 40 250\"/>", "<box size=\"0.060 0.040 0.250\"/>", "fix-box-in-mm"),
    ] {
        let (findings, text, remaining) = forearm("0.00641", shape, folder);
        assert_eq!(suspects(&findings), [("a", "density.implausible")], "{findings:#?}");
        let density = only(&findings, "density.implausible");
        assert!((number(density, "density") - 2e-6).abs() < 1e-10);
        assert!(density.message.contains("its sizes are in mm: then 2000 kg/m³"), "{}", density.message);
        assert!(text.contains(right) && text.contains("ixx=\"0.00641\""), "{text}");
        assert_eq!(suspects(&remaining), [], "{remaining:#?}");
    }
    // A box in inches, and a box in centimetres.
    for (size, right) in [("2.36220472 1.57480315 9.84251969", 0.06), ("6 4 25", 0.06)] {
        let folder = format!("fix-box-{}", &size[..1]);
        let (_, text, remaining) = forearm("0.00641", &format!("<box size=\"{size}\"/>"), &folder);
        let model = read_text(&text, "r.urdf".as_ref(), &ReadOptions::default()).unwrap();
        let polhode_robot::model::GeometryShape::Box([x, ..]) = model.links[1].geometry[0].shape else {
            panic!("a box")
        };
        assert!((x - right).abs() < 1e-8, "{text}");
        assert_eq!(suspects(&remaining), []);
    }
}

#[test]
fn a_missing_scale_and_a_slip_of_the_tensor_are_two_findings() {
    let (findings, text, remaining) =
        forearm("6.41", "<mesh filename=\"fore.stl\"/>", "fix-mesh-in-mm-and-triangle");
    let both = suspects(&findings);
    assert!(
        both.contains(&("a", "inertia.triangle")) && both.contains(&("a", "density.implausible")),
        "{both:?}"
    );
    let triangle = only(&findings, "inertia.triangle").repair.as_ref().unwrap();
    assert_eq!(triangle.description, "ixx 6.41 → 0.00641");
    assert!(text.contains("ixx=\"0.00641\"") && text.contains("scale=\"0.001 0.001 0.001\""), "{text}");
    assert_eq!(suspects(&remaining), []);
}

#[test]
fn geometry_in_millimetres_of_a_tensor_about_the_origin() {
    // The moment is 0.0158 about the centre; the parallel-axis term 2 kg · (0.15 m)² is added.
    let inertial = "<origin xyz=\"0 0 0.15\"/><mass value=\"2.0\"/>\
                    <inertia ixx=\"0.0608\" iyy=\"0.0608\" izz=\"0.0016\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/>";
    let text = one(inertial, "<cylinder radius=\"40\" length=\"300\"/>");
    let (findings, text, remaining) = fixed(&Folder::of("fix-two-slips", &[("r.urdf", &text)]), "r.urdf");
    assert_eq!(suspects(&findings).len(), 2, "{findings:#?}");
    assert!(text.contains("radius=\"0.040\" length=\"0.300\""), "{text}");
    assert_moments(&text, [0.0158, 0.0158, 0.0016]);
    // The remaining finding has another cause: the shape is at the link's origin, and the centre of
    // mass at its end.
    assert!(suspects(&remaining).iter().all(|(_, code)| *code == "mass.center_outside"), "{remaining:#?}");
}

#[test]
fn the_formula_of_a_slender_rod_on_a_disc() {
    let (findings, text, remaining) =
        of_one("0.5", ["3.75e-05", "3.75e-05", "0.000625"], "<cylinder radius=\"0.05\" length=\"0.03\"/>");
    assert_eq!(suspects(&findings), [("a", "inertia.triangle")]);
    let message = &only(&findings, "inertia.triangle").message;
    assert!(message.contains("ixx and iyy: the formula of a slender rod"), "{message}");
    // The moment is ¼ m r² + ¹⁄₁₂ m l²; izz is already right.
    assert_moments(&text, [3.5e-4, 3.5e-4, 6.25e-4]);
    assert_eq!(suspects(&remaining), []);
}

#[test]
fn two_moments_a_tenth_of_what_they_should_be() {
    let (findings, text, remaining) = of_one(
        "1.9532975",
        ["0.00314963095", "0.00212705296", "0.0126183438"],
        "<box size=\"0.0857281 0.264898 0.351177\"/>",
    );
    assert_eq!(suspects(&findings), [("a", "inertia.triangle")]);
    assert_moments(&text, [0.03149630946, 0.02127052956, 0.01261834377]);
    assert!(text.contains("izz=\"0.0126183438\""), "{text}");
    assert_eq!(suspects(&remaining), []);
}

#[test]
fn a_wrong_pair_of_lengths_is_found_below_a_factor_of_three() {
    let (findings, text, remaining) = of_one("12", ["0.17", "0.37", "0.37"], "<box size=\"0.6 0.4 0.1\"/>");
    assert_eq!(suspects(&findings), [("a", "inertia.geometry")]);
    let message = &only(&findings, "inertia.geometry").message;
    assert!(message.contains("izz: the formula of another axis"), "{message}");
    assert_moments(&text, [0.17, 0.37, 0.52]);
    assert_eq!(suspects(&remaining), []);
}

#[test]
fn a_mass_left_out() {
    let (findings, text, remaining) =
        of_one("6", ["0.0149333333", "0.0149333333", "0.0192"], "<cylinder radius=\"0.08\" length=\"0.4\"/>");
    assert_eq!(suspects(&findings), [("a", "inertia.geometry")]);
    let message = &only(&findings, "inertia.geometry").message;
    assert!(message.contains("ixx and iyy: the factor m (mass) is missing"), "{message}");
    assert_moments(&text, [0.0896, 0.0896, 0.0192]);
    assert_eq!(suspects(&remaining), []);
}

#[test]
fn a_centre_of_mass_beyond_the_end_of_the_link() {
    let inertial = "<origin xyz=\"0 0 0.16\"/><mass value=\"0.6\"/>\
                    <inertia ixx=\"0.001\" ixy=\"0\" ixz=\"0\" iyy=\"0.001\" iyz=\"0\" izz=\"0.0003\"/>";
    let text = one(inertial, "<cylinder radius=\"0.03\" length=\"0.2\"/>");
    let (findings, unchanged, _) = fixed(&Folder::of("fix-centre-outside", &[("r.urdf", &text)]), "r.urdf");
    let outside = only(&findings, "mass.center_outside");
    assert!((number(outside, "distance") - 0.06).abs() < 1e-12);
    assert!(outside.message.contains("60 mm outside the convex hull"), "{}", outside.message);
    assert_eq!((outside.severity, text), (Severity::Suspect, unchanged));
}

#[test]
fn a_light_cube_of_600_times_its_moments_is_no_padding() {
    let text = "<mujoco><worldbody><body name=\"cube1cm\"><freejoint/><inertial pos=\"0 0 0\" mass=\"0.1\" \
                diaginertia=\"0.001 0.001 0.001\"/><geom type=\"box\" size=\".005 .005 .005\"/></body></worldbody></mujoco>";
    let (findings, ..) = fixed(&Folder::of("fix-cube", &[("r.xml", text)]), "r.xml");
    let found = only(&findings, "gyration.too_large");
    assert_eq!(found.severity, Severity::Suspect);
    assert!(found.message.contains("1.67e-6 kg·m²"), "{}", found.message);
}

#[test]
fn moments_far_from_the_geometry_are_suspect_whatever_the_reason() {
    // A box of 6 kg: 0.065, 0.05, 0.025 kg·m².
    let of = |factor: f64| {
        let six = [0.065, 0.05, 0.025].map(|x| format!("{:.7}", factor * x));
        let (findings, ..) = of_one("6", six.each_ref().map(String::as_str), "<box size=\"0.1 0.2 0.3\"/>");
        findings
    };
    for factor in [1.0 / 15.0, 0.3, 3.1] {
        let all = of(factor);
        let found = only(&all, "inertia.geometry");
        assert_eq!(found.severity, Severity::Suspect);
        assert!((number(found, "ratio_yy") / factor - 1.0).abs() < 1e-3);
        assert_eq!(found.repair, None);
    }
    for factor in [0.4, 0.9, 1.3, 5.0 / 3.0, 2.9] {
        assert_eq!(suspects(&of(factor)), [], "{factor}");
    }
    // All elements are a tenth: either the tensor is wrong, or the mass is ten times too large. A
    // fix is therefore not offered.
    let all = of(0.1);
    let found = only(&all, "inertia.geometry");
    assert!(found.message.contains("all elements are 10 times too small"), "{}", found.message);
    assert!(found.message.contains("or the mass is 10 times too large"), "{}", found.message);
    assert_eq!(found.repair, None);
}

#[test]
fn a_simplified_collision_box_accuses_nobody() {
    // The right tensor of the drawn cylinder; the box around it has a different one.
    let inertial = "<origin xyz=\"0 0 0\"/><mass value=\"0.4\"/>\
                    <inertia ixx=\"0.000406667\" ixy=\"0\" ixz=\"0\" iyy=\"0.000406667\" iyz=\"0\" izz=\"0.00008\"/>";
    let cylinder = "<cylinder radius=\"0.02\" length=\"0.1\"/>";
    let both = one(inertial, "<box size=\"0.2 0.2 0.3\"/>")
        .replace("<collision>", &format!("<visual><geometry>{cylinder}</geometry></visual><collision>"));
    let (findings, ..) = fixed(&Folder::of("fix-crude-box", &[("r.urdf", &both)]), "r.urdf");
    assert_eq!(suspects(&findings), [], "{findings:#?}");
}

#[test]
fn a_mass_in_grams_or_tonnes_is_fixed_by_density_and_tensor() {
    for (mass, right) in [("6000", "6.000"), ("0.006", "6")] {
        let (findings, text, remaining) =
            of_one(mass, ["0.065", "0.05", "0.025"], "<box size=\"0.1 0.2 0.3\"/>");
        // The tensor is right, although it does not agree with the mass as written.
        assert_eq!(suspects(&findings), [("a", "density.implausible")], "{findings:#?}");
        assert!(text.contains(&format!("mass value=\"{right}\"")), "{text}");
        assert_eq!(suspects(&remaining), []);
    }
}

/// Returns the moments of a uniform box about its centre.
fn of_box(mass: f64, [a, b, c]: [f64; 3]) -> [f64; 3] {
    [b * b + c * c, a * a + c * c, a * a + b * b].map(|x| mass * x / 12.0)
}

/// A CAD program that interprets 1.1 g/cm³ as 1.1 kg/m³ prints a consistent mass and tensor.
#[test]
fn a_mass_and_a_tensor_that_agree_have_no_slip_each() {
    let edges = [0.1, 0.2, 0.3];
    for (mass, hint) in [
        (
            "0.0066",
            "the tensor agrees with this mass, so both may have been computed with a density in g/cm³",
        ),
        ("48000", "both may have been computed with a wrong density"),
    ] {
        let moments = of_box(mass.parse().unwrap(), edges).map(|x| format!("{x:.9e}"));
        let (findings, text, _) =
            of_one(mass, moments.each_ref().map(String::as_str), "<box size=\"0.1 0.2 0.3\"/>");
        assert_eq!(suspects(&findings), [("a", "density.implausible")], "{findings:#?}");
        let density = only(&findings, "density.implausible");
        assert!(density.repair.is_none() && density.message.contains(hint), "{density:#?}");
        assert!(text.contains(&format!("value=\"{mass}\"")), "{text}");
    }
}

#[test]
fn a_placeholder_confirms_no_scale() {
    // A ball of 2 m with a template tensor: inches and a factor of 100 would fit by chance.
    let (findings, _, _) = of_one("1", ["0.1"; 3], "<sphere radius=\"2\"/>");
    assert!(findings.iter().all(|f| f.repair.is_none()), "{findings:#?}");
}

#[test]
fn a_mass_of_about_a_kilogram_is_not_left_out() {
    let moments = of_box(1.0, [0.1, 0.2, 0.3]).map(|x| format!("{x:.9}"));
    let (findings, _, _) =
        of_one("1.01", moments.each_ref().map(String::as_str), "<box size=\"0.1 0.2 0.3\"/>");
    assert_eq!(suspects(&findings), []);
}

#[test]
fn a_small_product_tells_nothing_where_all_elements_are_as_far_off() {
    // The box is rotated by γ = 0.01 about z: ixy = (Ixx − Iyy) sin 2γ / 2. It is written with the
    // opposite sign.
    let [xx, yy, zz] = of_box(1.3, [0.1, 0.2, 0.3]);
    let product = 0.5 * (xx - yy) * 0.02_f64.sin();
    let shape = "<box size=\"0.1 0.2 0.3\"/>";
    let of = |factor: f64| {
        let inertial = format!(
            "<origin xyz=\"0 0 0\"/><mass value=\"1.3\"/><inertia ixx=\"{:.9}\" ixy=\"{:.9}\" ixz=\"0\" iyy=\"{:.9}\" iyz=\"0\" izz=\"{:.9}\"/>",
            xx * factor,
            -product,
            yy * factor,
            zz * factor
        );
        let text = one(&inertial, shape).replace("<collision>", "<collision><origin rpy=\"0 0 0.01\"/>");
        found(&read_text(&text, "r.urdf".as_ref(), &ReadOptions::default()).unwrap())
    };
    assert_eq!(suspects(&of(1.016)), []);
    assert_eq!(suspects(&of(1.0)), [("a", "inertia.sign")]);
}

#[test]
fn geometry_around_a_compact_body_accuses_no_small_moments() {
    let suspect = || vec![("a", "inertia.geometry")];
    // Densities of 400 and 2,000 kg/m³; then moments that are not all small, and moments below
    // those of a steel ball.
    for (mass, ratios, expected) in [
        (2.4, [0.23, 0.27, 0.25], vec![]),
        (12.0, [0.23, 0.27, 0.25], suspect()),
        (2.4, [0.18, 0.22, 0.8], suspect()),
        (2.4, [0.023, 0.027, 0.025], suspect()),
    ] {
        let uniform = of_box(mass, [0.1, 0.2, 0.3]);
        let moments = [0, 1, 2].map(|k| format!("{:.9}", ratios[k] * uniform[k]));
        let (findings, _, _) =
            of_one(&mass.to_string(), moments.each_ref().map(String::as_str), "<box size=\"0.1 0.2 0.3\"/>");
        assert_eq!(suspects(&findings), expected, "{findings:#?}");
    }
    // Rounding counts: 1.6e-7 may be 1.65e-7, and a third of ⅖ · 0.01 · 0.011² is 1.61e-7.
    for (moment, expected) in [("1.6e-7", vec![]), ("1.5e-7", suspect())] {
        let (findings, _, _) = of_one("0.01", [moment; 3], "<sphere radius=\"0.011\"/>");
        assert_eq!(suspects(&findings), expected, "{findings:#?}");
    }
}

#[test]
fn a_scale_is_written_if_all_shapes_need_it() {
    let seen = "</collision><visual><geometry><box size=\"100 200 300\"/></geometry></visual><collision>";
    for (touched, is_written) in [
        ("<box size=\"100 200 300\"/>", true),
        ("<sphere radius=\"0.001\"/>", false),
        ("<mesh filename=\"nowhere.stl\"/>", false),
    ] {
        let inertial = "<origin xyz=\"0 0 0\"/><mass value=\"12\"/>\
             <inertia ixx=\"0.13\" ixy=\"0\" ixz=\"0\" iyy=\"0.1\" iyz=\"0\" izz=\"0.05\"/>";
        let text = one(inertial, touched).replacen("<collision>", &format!("<collision>{seen}"), 1);
        let text = text.replacen("<collision></collision>", "", 1);
        let findings = found(&read_text(&text, "r.urdf".as_ref(), &ReadOptions::default()).unwrap());
        let density = only(&findings, "density.implausible");
        assert_eq!(density.repair.is_some(), is_written, "{touched}: {density:#?}");
    }
}
