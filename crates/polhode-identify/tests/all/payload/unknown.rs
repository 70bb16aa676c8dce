//! Unobservable parameters are reported.

use polhode_identify::payload::{Payload, PayloadLog, WrenchNoise};

use super::wrist::{Carried, Course, noisy, rows};
use super::{FORCE, SENSE, TORQUE, close, found, log};

fn known(found: &Payload) -> Vec<&str> {
    let numbers = &found.about_origin.numbers;
    numbers.iter().filter(|number| number.sd.is_some()).map(|number| number.name.as_str()).collect()
}

#[test]
fn at_rest_only_mass_and_centre_are_known() {
    let carried = Carried::generic();
    let exact = rows(&carried, Course::Poses, 60, SENSE);
    let truth = carried.about_center();
    for measured in [exact.clone(), noisy(&exact, FORCE, TORQUE, 3)] {
        let found = found(&PayloadLog::new(measured, SENSE).unwrap().with_bias().with_noise(KNOWN).unwrap());
        assert_eq!(found.about_origin.unknown.len(), 6);
        assert!(found.body.is_none() && found.edge.is_none());
        assert_eq!(
            known(&found),
            [
                "mass", "moment x", "moment y", "moment z", "bias fx", "bias fy", "bias fz", "bias tx",
                "bias ty", "bias tz"
            ]
        );
        let mass = found.about_center.get("mass").unwrap();
        assert!((mass.value - truth[0]).abs() < 5.0 * mass.sd.unwrap());
        let z = found.about_center.get("center z").unwrap();
        assert!((z.value - truth[3]).abs() < 5.0 * z.sd.unwrap() && z.sd.unwrap() < 0.01);
        assert!(found.about_center.get("Ixy").unwrap().sd.is_none());
    }
}

const KNOWN: WrenchNoise = super::KNOWN;

#[test]
fn one_pose_with_bias_says_hardly_anything() {
    let exact = rows(&Carried::generic(), Course::Poses, 60, SENSE);
    let mut same = exact.clone();
    for (row, time) in same.iter_mut().zip(&exact) {
        *row = exact[7];
        row.time = time.time;
    }
    let found = found(&PayloadLog::new(same, SENSE).unwrap().with_bias().with_noise(KNOWN).unwrap());
    assert_eq!(found.about_origin.unknown.len(), 10);
    assert!(known(&found).is_empty() && found.body.is_none());
}

/// Rotation about the vertical z: τx, τy contain Ixz, Iyz and m c_x, m c_y; τz contains Izz.
#[test]
fn about_one_axis_three_elements_are_known() {
    let carried = Carried::generic();
    let exact = rows(&carried, Course::OneAxis, 100, SENSE);
    let truth = carried.about_origin();
    for measured in [exact.clone(), noisy(&exact, FORCE, TORQUE, 5)] {
        let found = found(&log(measured));
        assert_eq!(
            known(&found),
            [
                "mass",
                "moment x",
                "moment y",
                "Izz about the origin",
                "Ixz about the origin",
                "Iyz about the origin"
            ]
        );
        assert_eq!(found.about_origin.unknown.len(), 4);
        for (number, truth) in found.about_origin.numbers.iter().zip(truth) {
            if let Some(sd) = number.sd {
                assert!((number.value - truth).abs() < 5.0 * sd, "{number:?} {truth}");
            }
        }
        // About the centre of mass Izz is determined, because it requires only `c_x` and `c_y`.
        assert!(found.about_center.get("Izz").unwrap().sd.is_some());
        assert!(found.about_center.get("Ixz").unwrap().sd.is_none());
    }
}

#[test]
fn all_is_known_of_a_generic_motion() {
    let carried = Carried::generic();
    let found = found(&log(rows(&carried, Course::Generic(0.5), 100, SENSE)));
    assert!(found.about_origin.unknown.is_empty());
    close(&found, &carried.about_center(), 1e-11);
    let (i, j) = (4, 5);
    let r = found.about_center.correlation(i, j).unwrap();
    assert!(r.abs() < 1.0 && r != 0.0);
}
