//! Page data of a rotor in gimbals.

use polhode::body::shape::Cylinder;
use polhode::math::Part;
use polhode::motion::gimbal::{Axis, Base, Gimbal, Gimbals, Spring};
use polhode::prelude::*;

use crate::page::page_of;

/// Rotor in heavy gimbals on a rotating base; also for the check of the data format.
pub(crate) fn gyroscope() -> Scenario {
    let rotor = Cylinder::new(0.03, 0.02).unwrap();
    let part = crate::common::solid("rotor", "cylinder", &rotor, 0.4, [0.0, 0.0, 0.01], 0.0);
    let spring = Spring { stiffness: 0.02, rest: 0.1 };
    let axes = [
        Axis::free(0.3, 0.2).and_then(|axis| axis.damped(1e-4)?.sprung(spring)),
        Axis::free(0.4, -0.5),
        Axis::driven(0.0, 90.0),
    ];
    let [up, east] = [Direction::new(0.0, 0.0, 1.0), Direction::new(1.0, 0.0, 0.0)];
    let ring = Gimbal::balanced(&InertiaTensor::<Part>::diagonal([1e-4, 1e-4, 2e-4]).unwrap());
    let base = Base::turning(AngularVelocity::new(0.1, 0.0, 0.2)).unwrap();
    let gimbals =
        Gimbals::new(up, east, axes.map(Result::unwrap)).unwrap().with_mass(ring, ring).with_base(base);
    let gimbals = gimbals.with_gravity(Acceleration::new(0.0, 0.0, -9.81)).unwrap();
    let scenario = crate::common::scenario("A gyroscope", vec![part]).in_gimbals(gimbals).unwrap();
    scenario.sampled(crate::common::run(2.0, 201))
}

#[test]
fn a_page_says_what_holds_the_rotor() {
    let (data, trajectory) = page_of(&gyroscope());
    let groups = data["facts"].as_array().unwrap();
    let group = |title: &str| groups.iter().find(|group| group["title"] == title).unwrap();
    let rows = group("Gimbals")["rows"].as_array().unwrap();
    let of = |label: &str, key: &str| {
        let row = rows.iter().find(|row| row["label"] == label).unwrap();
        row[key].as_str().unwrap().to_owned()
    };
    assert_eq!(
        (of("ω of the base", "value"), of("ω of the base", "unit")),
        ("(0.1, 0, 0.2)".into(), "rad/s".into())
    );
    assert!(of("outer axis", "note").contains("a spring of 0.02 N·m/rad"), "{}", of("outer axis", "note"));
    assert!(of("rotor axis", "note").contains("driven at 90 rad/s"), "{}", of("rotor axis", "note"));
    let evidence = group("Evidence")["rows"].as_array().unwrap();
    assert!(evidence[0]["note"].as_str().unwrap().contains("T + U − works of the axes and the base"));
    assert!(trajectory.energy_drift() < 1e-13);
    let caption = data["scene"]["captions"].to_string();
    assert!(caption.contains("It hangs in two gimbals on a base that turns"), "{caption}");
}
