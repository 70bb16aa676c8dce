//! Slips that explain a difference, and mass that moved between links.

use polhode_document::Report as _;

use super::robots::{Robot, Solid, robot, sum};
use super::{between, codes, compared, messages};

/// Requires that a slip in a URDF or MJCF is explained by words.
fn require_explained(slip: impl Fn(&mut Robot), code: &str, words: &str) {
    for language in ["urdf", "xml"] {
        let mut slipped = robot();
        slip(&mut slipped);
        let comparison = between((&robot(), language), (&slipped, language));
        assert_eq!(codes(&comparison), [(code, "fore")], "{}", comparison.to_text(None));
        assert!(messages(&comparison)[0].contains(words), "{:?}", messages(&comparison));
    }
}

#[test]
fn a_slip_that_explains_a_difference_is_named() {
    require_explained(|r| r.solid("fore").mass *= 1e3, "compare.mass", "the mass in b.");
    require_explained(|r| r.solid("fore").mass /= 1e3, "compare.mass", "the mass in a.");
    let scale = |factor: f64| {
        move |r: &mut Robot| r.solid("fore").center = r.solid("fore").center.map(|c| factor * c)
    };
    require_explained(scale(1e3), "compare.center", " is in mm");
    require_explained(|r| r.solid("fore").center[0] *= -1.0, "compare.center", "x with the opposite sign");
    require_explained(|r| r.solid("fore").center.swap(1, 2), "compare.center", "y and z swapped");
    let tensor = |change: fn(&mut [[f64; 3]; 3])| move |r: &mut Robot| change(&mut r.solid("fore").tensor);
    require_explained(tensor(|t| *t = t.map(|row| row.map(|c| 1e9 * c))), "compare.tensor", " is in g·mm²");
    require_explained(
        tensor(|t| *t = t.map(|row| row.map(|c| 1.5 * c))),
        "compare.tensor",
        "all elements 1.5 times as large",
    );
    require_explained(
        tensor(|t| {
            for (i, j) in [(0, 1), (0, 2), (1, 2)] {
                (t[i][j], t[j][i]) = (-t[i][j], -t[j][i]);
            }
        }),
        "compare.tensor",
        "ixy, ixz and iyz with the opposite sign",
    );
    require_explained(
        tensor(|t| {
            let (xz, yz) = (t[0][2], t[1][2]);
            (t[0][2], t[2][0], t[1][2], t[2][1]) = (yz, yz, xz, xz);
        }),
        "compare.tensor",
        "iyz and ixz swapped",
    );
    // I_origin = I_c + m (c² 1 − c cᵀ)
    let about_origin = |r: &mut Robot| {
        let fore = r.solid("fore");
        let (m, c) = (fore.mass, fore.center);
        let square: f64 = c.iter().map(|x| x * x).sum();
        for (i, row) in fore.tensor.iter_mut().enumerate() {
            for (j, element) in row.iter_mut().enumerate() {
                *element += m * (if i == j { square } else { 0.0 } - c[i] * c[j]);
            }
        }
    };
    require_explained(about_origin, "compare.tensor", " is about the link's origin");
}

#[test]
fn what_two_slips_explain_is_not_explained() {
    // A diagonal tensor with two equal moments: swapped axes and swapped moments are the same.
    let arm = |values: &str| {
        format!(
            r#"<robot name="r"><link name="fore"><inertial><mass value="2"/><inertia {values}/></inertial></link></robot>"#
        )
    };
    let one = arm(r#"ixx="0.02" iyy="0.03" izz="0.04" ixy="0" ixz="0" iyz="0""#);
    let other = arm(r#"ixx="0.03" iyy="0.02" izz="0.04" ixy="0" ixz="0" iyz="0""#);
    let comparison = compared(["urdf", &one], ["urdf", &other], "1e-6");
    let message = messages(&comparison)[0];
    assert_eq!(
        message,
        "ixx 0.03 kg·m², in a.urdf 0.02 kg·m²; iyy 0.02 kg·m², in a.urdf 0.03 kg·m²: the tensor differs by 0.263 (relative)"
    );
}

#[test]
fn swapped_links_name_each_other() {
    let mut slipped = robot();
    let (one, other) = (*slipped.solid("fore"), *slipped.solid("finger"));
    (*slipped.solid("fore"), *slipped.solid("finger")) = (other, one);
    let comparison = between((&robot(), "sdf"), (&slipped, "xml"));
    assert_eq!(codes(&comparison), [("compare.link", "fore"), ("compare.link", "finger")]);
    assert_eq!(messages(&comparison)[0], "mass, centre and tensor are those of \"finger\" in a.sdf");
}

#[test]
fn mass_moved_between_links_is_told_from_mass_that_is_lost() {
    // 0.1 kg of the hand goes to the forearm, as a point at the hand's centre.
    let mut moved = robot();
    let hand = *moved.solid("hand");
    let place = moved.part("hand").pose;
    let fore = *moved.solid("fore");
    let at = place.point(hand.center);
    let mut lighter = moved.clone();
    lighter.solid("hand").mass -= 0.1;
    *moved.solid("fore") = sum(&[fore, Solid { mass: 0.1, center: at, tensor: [[0.0; 3]; 3] }]);
    moved.solid("hand").mass -= 0.1;
    let comparison = between((&robot(), "urdf"), (&moved, "xml"));
    assert!(
        codes(&comparison).iter().all(|(_, link)| ["fore", "hand"].contains(link)),
        "{:?}",
        codes(&comparison)
    );
    assert!(
        messages(&comparison)
            .iter()
            .all(|m| m.ends_with("; the sum of its rigid group agrees: moved between links"))
    );
    let comparison = between((&robot(), "urdf"), (&lighter, "xml"));
    assert_eq!(codes(&comparison), [("compare.mass", "hand")]);
    assert!(!messages(&comparison)[0].contains("agrees"));
    // From the finger to the rail, across the knuckle.
    let mut moved = robot();
    let (finger, rail, place) = (*moved.solid("finger"), *moved.solid("rail"), moved.part("finger").pose);
    let point = Solid { mass: 0.1, center: place.point(finger.center), tensor: [[0.0; 3]; 3] };
    *moved.solid("rail") = sum(&[rail, point]);
    moved.solid("finger").mass -= 0.1;
    let comparison = between((&robot(), "sdf"), (&moved, "usda"));
    let ending = "; the sum of the subtree below joint \"/robot/slide\" agrees: moved between links";
    assert!(
        messages(&comparison).iter().all(|message| message.ends_with(ending)),
        "{:?}",
        messages(&comparison)
    );
}

#[test]
fn mass_moved_across_a_joint_with_another_zero_is_told() {
    let plain = robot();
    let mut moved = plain.rezeroed("upper", 0.7);
    let upper = *moved.solid("upper");
    // At the zero of the first model.
    let at = plain.0[1].pose.point(upper.center);
    moved.solid("upper").mass -= 0.1;
    let base = *moved.solid("base");
    *moved.solid("base") = sum(&[base, Solid { mass: 0.1, center: at, tensor: [[0.0; 3]; 3] }]);
    for language in ["urdf", "xml"] {
        let comparison = between((&plain, "sdf"), (&moved, language));
        assert!(codes(&comparison).contains(&("compare.mass", "upper")), "{}", comparison.to_text(None));
        let ending = "; the sum of all links agrees: moved between links";
        assert!(messages(&comparison).iter().all(|m| m.ends_with(ending)), "{:?}", messages(&comparison));
    }
}
