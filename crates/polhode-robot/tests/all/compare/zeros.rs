//! Zeros of joints, axes, and the limits of the tolerance.

use polhode_document::Report as _;

use super::robots::{Frame, Robot, robot};
use super::{between, codes, compared, messages, notes};

#[test]
fn an_axis_that_moves_without_its_link_is_a_joint_difference() {
    for (language, other) in [("xml", "urdf"), ("sdf", "usda"), ("usda", "xml")] {
        let mut slipped = robot();
        slipped.part("fore").joint.as_mut().unwrap().anchor = [1e-3, 0.0, 0.0];
        let comparison = between((&robot(), other), (&slipped, language));
        assert_eq!(codes(&comparison), [("compare.joint", "elbow")], "{}", comparison.to_text(None));
        // The distance of a point 1 mm along x from an axis with x component 0.6 is 0.8 mm.
        assert!(messages(&comparison)[0].contains(": 0.8 mm apart"), "{:?}", messages(&comparison));
        let mut slipped = robot();
        slipped.part("rail").joint.as_mut().unwrap().axis = [-0.48, 0.64, 0.6];
        let comparison = between((&robot(), other), (&slipped, language));
        assert_eq!(codes(&comparison), [("compare.joint", "slide")], "{}", comparison.to_text(None));
        // cos φ = 0.48² + 2 · 0.6 · 0.64
        assert!(messages(&comparison)[0].contains(": 3.242° apart"), "{:?}", messages(&comparison));
    }
}

/// Returns the robot whose finger has its centre of mass on the axis of the knuckle.
fn on_axis() -> Robot {
    let mut robot = robot();
    robot.solid("finger").center = [0.0, 0.08, 0.06];
    robot
}

#[test]
fn a_tensor_alone_determines_no_zero() {
    // Half a turn about the axis of a link with its centre on the axis, and about z the wrong sign
    // of two products: only the tensor changes.
    let mut turned = on_axis();
    let axis = turned.part("finger").joint.as_ref().unwrap().axis;
    for angle in [std::f64::consts::PI, 0.9] {
        turned.solid("finger").tensor = {
            let r = crate::common::matrix_about_axis(axis, angle);
            let t = on_axis().solid("finger").tensor;
            let transposed = std::array::from_fn(|i| std::array::from_fn(|j| r[j][i]));
            crate::common::times(crate::common::times(r, t), transposed)
        };
        for language in ["urdf", "usda"] {
            let comparison = between((&on_axis(), "sdf"), (&turned, language));
            assert_eq!(codes(&comparison), [("compare.tensor", "finger")], "{}", comparison.to_text(None));
            assert!(notes(&comparison).is_empty(), "{:?}", notes(&comparison));
        }
    }
}

#[test]
fn geometry_determines_a_zero_that_the_centre_does_not() {
    let shape = |text: String| {
        let visual = "<visual><origin xyz=\"0.02 0.05 -0.01\" rpy=\"0.1 0.2 0.3\"/><geometry><box size=\"0.1 0.2 0.3\"/></geometry></visual>";
        text.replace("<link name=\"finger\">", &format!("<link name=\"finger\">{visual}"))
    };
    let (plain, moved) = (on_axis().written("urdf"), on_axis().rezeroed("finger", 0.35).written("urdf"));
    let comparison = compared(["urdf", &shape(plain.clone())], ["urdf", &shape(moved.clone())], "1e-12");
    // The frame of the link moved with everything in it: only the zero differs.
    assert_eq!(codes(&comparison), [], "{}", comparison.to_text(None));
    assert_eq!(notes(&comparison), [("compare.zero", "its zero differs: 0 in a.urdf is -0.35 rad here")]);
    // Without geometry, the tensor differs.
    assert_eq!(codes(&compared(["urdf", &plain], ["urdf", &moved], "1e-12")), [("compare.tensor", "finger")]);
}

#[test]
fn rounded_numbers_agree_within_their_digits() {
    let rounded = |robot: &Robot, language: &str| robot.rounded(6).written(language);
    let zeros = robot().rezeroed("upper", 0.7).rezeroed("fore", -1.3);
    for (a, b) in [("urdf", "sdf"), ("sdf", "xml"), ("urdf", "urdf")] {
        for other in [robot(), robot().reframed(b), zeros.reframed(b)] {
            let (one, other) = (rounded(&robot(), a), rounded(&other, b));
            let comparison = compared([a, &one], [b, &other], "1e-4");
            assert_eq!(codes(&comparison), [], "{a} {b}\n{}", comparison.to_text(None));
        }
        let same = compared([a, &rounded(&robot(), a)], [b, &rounded(&robot(), b)], "1e-5");
        assert_eq!(codes(&same), [], "{a} {b}\n{}", same.to_text(None));
    }
}

#[test]
fn the_tolerance_is_a_sharp_limit_of_each_quantity() {
    let is_equal = |slip: &dyn Fn(&mut Robot)| {
        let mut slipped = robot();
        slip(&mut slipped);
        compared(["urdf", &robot().written("urdf")], ["urdf", &slipped.written("urdf")], "1e-4").is_equal()
    };
    let fore = *robot().solid("fore");
    let distance = fore.center.iter().map(|c| c * c).sum::<f64>().sqrt();
    let gyration = ((0..3).map(|k| fore.tensor[k][k]).sum::<f64>() / (2.0 * fore.mass)).sqrt();
    let norm = fore.tensor.iter().flatten().map(|x| x * x).sum::<f64>().sqrt();
    let reach = distance.max(gyration);
    for (part, is_within) in [(0.99e-4, true), (1.01e-4, false)] {
        assert_eq!(is_equal(&|r| r.solid("fore").mass /= 1.0 - part), is_within);
        let shift = |of: f64| move |r: &mut Robot| r.solid("fore").center[2] += part * of;
        assert_eq!(is_equal(&shift(reach)), is_within, "{distance} {gyration}");
        let tensor = |r: &mut Robot| {
            for (i, j) in [(0, 2), (2, 0)] {
                r.solid("fore").tensor[i][j] += part * norm / 2f64.sqrt();
            }
        };
        assert_eq!(is_equal(&tensor), is_within);
        // A turn of the axis about a perpendicular line.
        let turned = |r: &mut Robot| {
            let joint = r.part("fore").joint.as_mut().unwrap();
            let across = [0.64, -0.6, 0.0].map(|c: f64| c / 0.64_f64.hypot(0.6));
            joint.axis = [0, 1, 2].map(|k| part.cos() * joint.axis[k] + part.sin() * across[k]);
        };
        assert_eq!(is_equal(&turned), is_within);
    }
    // The farthest point of the robot, along its links, is between 0.7 m and 1.2 m away.
    for (shift, is_within) in [(0.7e-4, true), (1.2e-4, false)] {
        let across = [0.64, -0.6, 0.0].map(|c: f64| shift * c / 0.64_f64.hypot(0.6));
        let moved = |r: &mut Robot| {
            r.part("fore").pose = r.part("fore").pose.then(&Frame { p: across, ..Frame::IDENTITY });
        };
        assert_eq!(is_equal(&moved), is_within);
    }
}

#[test]
fn the_axis_below_determines_the_zero_of_a_joint_without_mass() {
    let mut bare = robot();
    bare.part("upper").solid = None;
    let moved = bare.rezeroed("upper", 0.7);
    for language in ["urdf", "xml"] {
        for other in [moved.clone(), moved.reframed(language)] {
            let comparison = between((&bare, "xml"), (&other, language));
            assert_eq!(codes(&comparison), [], "{}", comparison.to_text(None));
            let [(code, message)] = notes(&comparison)[..] else { panic!("{:?}", notes(&comparison)) };
            assert_eq!((code, message), ("compare.zero", "its zero differs: 0 in a.xml is -0.7 rad here"));
        }
    }
}

#[test]
fn rounding_does_not_accumulate_along_a_chain_of_equal_frames() {
    let mut chain = robot();
    chain.0.truncate(2);
    for k in 2..60 {
        let mut next = chain.0[1].clone();
        next.name = format!("link{k}");
        next.joint.as_mut().unwrap().name = format!("joint{k}");
        next.parent = Some(k - 1);
        chain.0.push(next);
    }
    // Each of 60 poses is turned by half the tolerance, in the same sense.
    let mut rounded = chain.clone();
    for part in &mut rounded.0 {
        part.pose = part.pose.then(&Frame::new([0.0; 3], [0.0, 0.0, 5e-7]));
    }
    let comparison = compared(["urdf", &chain.written("urdf")], ["xml", &rounded.written("xml")], "1e-6");
    assert_eq!(codes(&comparison), [], "{}", comparison.to_text(None));
}
