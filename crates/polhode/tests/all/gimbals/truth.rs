//! Motions compared with references of 36 digits, from three bodies in space with unknown torques
//! between them: `fixtures/gimbals.py`.

use polhode::body::InertiaAbout;
use polhode::math::{Acceleration, Direction, Part};
use polhode::motion::gimbal::{Axis, Base, Gimbal, GimbalState, Gimbals, Spring};
use polhode::prelude::*;
use toml::Table;

use super::run;
use crate::common::{attitude, cases, matrix, number, numbers, table};

#[test]
fn motions_are_those_of_another_formulation() {
    let table = table("gimbals");
    let all = cases(&table, "case");
    assert!(all.len() >= 9);
    for case in all {
        let worst = error_of(case);
        assert!(worst < 1e-13, "{}: {worst:.2e}", case["name"]);
    }
}

/// Returns the largest relative difference of the stored quantities.
fn error_of(case: &Table) -> f64 {
    let triple = |key: &str| numbers::<3>(&case[key]);
    let inertia = InertiaTensor::from_matrix(matrix(&case["inertia"])).unwrap();
    let center = Position::from_array(triple("center"));
    let rotor = MassProperties::new(number(&case["mass"]), center, inertia).unwrap();
    let holds: Vec<&str> =
        case["hold"].as_array().unwrap().iter().map(|hold| hold.as_str().unwrap()).collect();
    let axes = [0, 1, 2].map(|k| {
        let of = |key: &str| triple(key)[k];
        let axis = match holds[k] {
            "free" => Axis::free(of("angle"), of("rate")),
            "locked" => Axis::locked(of("angle")),
            _ => Axis::driven(of("angle"), of("rate")),
        };
        let spring = Spring { stiffness: of("stiffness"), rest: of("rest") };
        axis.and_then(|axis| axis.damped(of("damping"))?.sprung(spring)?.turned_by(of("torque"))).unwrap()
    });
    let [outer_axis, inner_axis] = ["outer_axis", "inner_axis"].map(|key| Direction::from_array(triple(key)));
    let gimbals = Gimbals::new(outer_axis, inner_axis, axes).unwrap();
    let (crossing, axis) =
        (Position::from_array(triple("crossing")), Direction::from_array(triple("rotor_axis")));
    let base = Base::turning(AngularVelocity::from_array(triple("base_rate"))).unwrap();
    let gimbals = gimbals
        .holding(crossing, axis)
        .and_then(|gimbals| gimbals.with_base(base).with_gravity(Acceleration::from_array(triple("gravity"))))
        .unwrap()
        .with_mass(gimbal(case, "outer"), gimbal(case, "inner"));
    let rows = cases(case, "row");
    let times: Vec<f64> = rows.iter().map(|row| number(&row["t"])).collect();
    let motion = run(&rotor, &gimbals, &times);
    assert_eq!(motion.samples().len(), rows.len(), "{:?}", motion.ending());
    assert!(motion.energy_drift() < 1e-13, "{}: {:.1e}", case["name"], motion.energy_drift());
    let compared = motion.samples().iter().zip(&rows);
    compared.map(|(sample, row)| error_of_sample(sample, row)).fold(0.0, worse)
}

/// Returns a gimbal with a tensor and a moment about the intersection of the axes. Its mass is a
/// power of two, and so large that any moment is close to the intersection.
fn gimbal(case: &Table, name: &str) -> Gimbal {
    let rows = matrix(&case[&format!("{name}_inertia")]);
    let center = numbers::<3>(&case[&format!("{name}_moment")]).map(|x| x / 64.0);
    if rows == [[0.0; 3]; 3] {
        return Gimbal::MASSLESS;
    }
    let about = InertiaAbout::from_matrix(Position::ZERO, rows).unwrap();
    let center = Position::<Part>::from_array(center);
    Gimbal::pendulous(&MassProperties::from_inertia_about(64.0, center, &about).unwrap())
}

/// Returns the difference of each number relative to the largest of its kind.
fn error_of_sample(sample: &GimbalState, row: &Table) -> f64 {
    let mut worst = attitude(&row["attitude"]).angle_to(sample.state.attitude);
    let mut compare = |got: [f64; 3], key: &str, least: f64| {
        let wanted = numbers::<3>(&row[key]);
        let size = wanted.iter().fold(least, |size, x| size.max(x.abs()));
        worst = got.iter().zip(wanted).map(|(got, want)| (got - want).abs() / size).fold(worst, worse);
    };
    compare(sample.angles, "angles", 1.0);
    compare(sample.rates, "rates", 1.0);
    compare(sample.holding, "holding", 0.1);
    compare(sample.state.omega.to_array(), "omega", 1.0);
    compare(sample.torque.to_array(), "torque", 0.1);
    compare(sample.momentum.to_array(), "momentum", 0.1);
    let energies = [
        (sample.kinetic_energy, "kinetic"),
        (sample.potential_energy, "potential"),
        (sample.damping_work, "damping_work"),
        (sample.motor_work, "motor_work"),
    ];
    let size = number(&row["kinetic"]).max(0.1);
    energies.iter().map(|(got, key)| (got - number(&row[*key])).abs() / size).fold(worst, worse)
}

fn worse(a: f64, b: f64) -> f64 {
    if b > a || b.is_nan() { b } else { a }
}
