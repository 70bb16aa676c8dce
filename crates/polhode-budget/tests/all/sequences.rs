//! Changes of a body over time.

use polhode::math::{AngularVelocity, Attitude, Direction, Position, Rotation};
use polhode::motion::{Exit, Outflow, Simulation, State};
use polhode::observe::Drift;
use polhode_budget::{
    Basis, Budget, Burn, Change, CopyErrors, Down, GivenPart, GivenTensor, Liquid, PartsList, Place,
    ProductSign, Quantity, Row, Sequence, SequenceError, SequenceRow, Tank, TankShape, TensorPoint, Vessel,
};

fn part(mass: f64, at: [f64; 3]) -> GivenPart {
    let tensor = GivenTensor {
        moments: [0.3 * mass, 0.35 * mass, 0.2 * mass],
        products: [0.01 * mass, -0.02 * mass, 0.03 * mass],
        sign: ProductSign::NegativeIntegral,
        about: TensorPoint::CenterOfMass,
    };
    GivenPart { mass, center_of_mass: Position::from_array(at), tensor }
}

fn turned(angle: f64) -> Place {
    let rotation = Rotation::from_axis_angle(Direction::new(0.3, -0.5, 0.8), angle).unwrap();
    Place { position: Position::new(0.1, -0.2, 0.4), rotation }
}

fn budget(arm: f64) -> Budget {
    let rows = vec![
        Row::frame("craft"),
        Row::part("craft/bus", part(20.0, [0.05, -0.1, 0.3])),
        Row { place: turned(0.7), ..Row::frame("craft/tank") },
        Row { place: turned(arm), ..Row::part("craft/arm", part(3.0, [0.9, 0.2, -0.1])) },
        Row { place: turned(-0.4), ..Row::part("craft/booster", part(6.0, [-0.4, 0.3, -0.7])) },
        Row { place: turned(0.2), ..Row::frame("craft/booster/tank") },
        Row {
            quantity: Quantity { count: 4, errors: CopyErrors::Alike },
            ..Row::part("craft/ballast", part(0.25, [0.2, 0.2, 0.2]))
        },
    ];
    PartsList { rows, ..PartsList::default() }.budget().unwrap()
}

fn tank(name: &str, frame: &str, shape: TankShape, down: Down) -> Tank {
    let vessel = Vessel::new(shape, 900.0, down).unwrap();
    Tank { name: name.into(), frame: frame.into(), liquid: Liquid::Vessel(Box::new(vessel)) }
}

fn burn(tank: &str, from: f64, until: f64, flow: f64) -> Burn {
    Burn { tank: tank.into(), from, until, flow }
}

fn drop(time: f64, row: &str) -> Change<'static> {
    Change::Drop { time, rows: vec![row.into()] }
}

fn tanks() -> [(Tank, f64); 2] {
    let fuel = TankShape::Cylinder { radius: 0.15, length: 0.3, ends: [0.15, 0.1] };
    [
        (tank("fuel", "craft/tank", fuel, Down::PlusX), 12.0),
        (tank("booster", "craft/booster/tank", TankShape::Box([0.2, 0.3, 0.4]), Down::MinusZ), 20.0),
    ]
}

/// Returns M, c and the tensor about c.
fn numbers(row: &SequenceRow) -> [f64; 10] {
    let [x, y, z] = row.properties.center_of_mass().to_array();
    let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = row.properties.inertia().matrix();
    [row.properties.mass(), x, y, z, xx, yy, zz, xy, xz, yz]
}

fn rates(row: &SequenceRow) -> [f64; 10] {
    let ([x, y, z], [xx, yy, zz, xy, xz, yz]) = (row.rates.center_of_mass.to_array(), row.rates.inertia);
    [row.rates.mass, x, y, z, xx, yy, zz, xy, xz, yz]
}

fn sequence<'a>(first: &'a Budget, unfolded: &'a Budget) -> Sequence<'a> {
    Sequence {
        burns: vec![
            burn("booster", 2.0, 10.0, 2.5),
            burn("fuel", 5.0, 30.0, 0.3),
            burn("fuel", 20.0, 25.0, 0.2),
        ],
        changes: vec![
            Change::Become { time: 14.0, name: "unfolded".to_owned(), budget: unfolded },
            drop(12.0, "craft/booster"),
            drop(16.0, "craft/ballast"),
        ],
        ..Sequence::of(first, Basis::Basic, tanks())
    }
}

#[test]
fn the_mass_is_what_has_not_gone() {
    let [first, unfolded] = [0.1, 1.3].map(budget);
    let sequence = sequence(&first, &unfolded);
    let mass = |time: f64| sequence.at(time).unwrap().properties.mass();
    for (time, want) in [
        (0.0, 62.0),
        (6.0, 62.0 - 10.0 - 0.3),
        (11.9, 62.0 - 20.0 - 0.3 * 6.9),
        (12.0, 62.0 - 20.0 - 6.0 - 2.1),
        (15.0, 62.0 - 26.0 - 3.0),
        (16.0, 62.0 - 26.0 - 3.3 - 1.0),
        (40.0, 62.0 - 26.0 - 1.0 - 7.5 - 1.0),
    ] {
        assert!((mass(time) - want).abs() < 1e-12, "{time}: {} {want}", mass(time));
    }
    // The unfolded body differs, though its mass is the same.
    let [before, after] = [13.9, 14.1].map(|time| sequence.at(time).unwrap().properties.center_of_mass());
    assert!((before - after).norm() > 0.01);
    // Nested rows with rotated tanks: the whole is the sum.
    let dry = first.mass_properties(Basis::Basic).unwrap();
    let empty = Sequence::of(&first, Basis::Basic, tanks().map(|(tank, _)| (tank, 0.0))).at(0.0).unwrap();
    assert!((empty.properties.center_of_mass() - dry.center_of_mass()).norm() < 1e-15);
}

#[test]
fn rates_are_derivatives() {
    let [first, unfolded] = [0.1, 1.3].map(budget);
    let sequence = sequence(&first, &unfolded);
    for time in [3.0, 7.5, 13.0, 22.0, 28.0] {
        let h = 1e-4;
        let [before, after] = [time - h, time + h].map(|time| numbers(&sequence.at(time).unwrap()));
        let found = rates(&sequence.at(time).unwrap());
        for k in 0..10 {
            let difference = (after[k] - before[k]) / (2.0 * h);
            assert!((found[k] - difference).abs() < 1e-8, "{time} {k}: {} {difference}", found[k]);
        }
    }
    // Derivatives with respect to the fill of the tanks.
    let by_fill = sequence.by_fill(&[0.499, 0.5, 0.501]).unwrap();
    for k in 0..10 {
        let difference = (numbers(&by_fill[2])[k] - numbers(&by_fill[0])[k]) / 0.002;
        assert!((rates(&by_fill[1])[k] - difference).abs() < 1e-4, "{k}");
    }
}

#[test]
fn rows_come_in_pairs_at_corners() {
    let [first, unfolded] = [0.1, 1.3].map(budget);
    let rows = sequence(&first, &unfolded).rows([0.0, 40.0], 3).unwrap();
    let times: Vec<f64> = rows.iter().map(|row| row.time).collect();
    // Corners at 0 2 5 10 12 14 16 20 25 30 40 s.
    assert_eq!((rows.len(), times[0], times[39]), (40, 0.0, 40.0));
    let at_ten: Vec<&SequenceRow> = rows.iter().filter(|row| row.time == 10.0).collect();
    assert_eq!(at_ten.len(), 2);
    assert!((at_ten[0].rates.mass + 2.8).abs() < 1e-15 && (at_ten[1].rates.mass + 0.3).abs() < 1e-15);
    assert_eq!(at_ten[0].liquid[1], at_ten[1].liquid[1]);
}

#[test]
fn a_history_is_the_sequence_and_moves() {
    let [first, unfolded] = [0.1, 1.3].map(budget);
    let sequence = sequence(&first, &unfolded);
    let position = Position::new(0.0, 0.1, -1.0);
    let exit = Exit { share: 1.0, position, axis: Direction::new(0.0, 0.0, 1.0), radius: 0.1 };
    let history = |pieces| sequence.history([0.0, 40.0], pieces, Outflow::Exits(vec![exit])).unwrap();
    let error = |pieces: usize| {
        let history = history(pieces);
        let apart = |time: f64| {
            let (body, want) = (history.at(time).unwrap().0, sequence.at(time).unwrap().properties);
            (body.center_of_mass() - want.center_of_mass()).norm()
        };
        [3.3, 8.7, 21.7, 27.3].map(apart).into_iter().fold(0.0, f64::max)
    };
    let [coarse, fine] = [4, 16].map(error);
    assert!(coarse < 1e-5 && fine < coarse / 100.0, "{coarse:e} {fine:e}");
    let history = history(8);
    let rotor = history.rotor(0.0, None).unwrap();
    let omega = AngularVelocity::new(0.2, -0.4, 1.1);
    let start = State { time: 0.0, attitude: Attitude::identity(), omega };
    let times = [10.0, 12.0, 12.1, 14.0, 14.0001, 40.0];
    let motion = Simulation::new(&rotor, &[], start, &times).changing(Some(&history)).run().unwrap();
    let drift = Drift::of(&motion).unwrap();
    assert!(drift.work_energy < 1e-12 && drift.momentum < 1e-12, "{drift:?}");
    // A dropped part changes L but not ω; an unfolding arm changes ω but not L.
    let s = motion.samples();
    let jump = |k: usize| {
        let (a, b) = (s[k], s[k + 1]);
        [(a.state.omega - b.state.omega).norm(), (a.momentum - b.momentum).norm() / a.momentum.norm()]
    };
    assert!(jump(1)[1] > 0.1 && jump(3)[0] > 0.01 && jump(3)[1] < 1e-4, "{:?} {:?}", jump(1), jump(3));
}

#[test]
fn what_cannot_happen_is_refused() {
    let [first, heavier] = [budget(0.1), budget(0.1)];
    let base = || Sequence::of(&first, Basis::Basic, tanks());
    let at = |sequence: &Sequence<'_>, time: f64| sequence.at(time).unwrap_err();
    let with = |burns, changes| Sequence { burns, changes, ..base() };
    assert!(matches!(
        at(&with(vec![burn("fuel", 0.0, 50.0, 0.3)], vec![]), 45.0),
        SequenceError::Fill { time: 45.0, .. }
    ));
    assert!(matches!(
        at(&with(vec![burn("air", 0.0, 1.0, 0.3)], vec![]), 0.0),
        SequenceError::MissingTank { .. }
    ));
    assert!(matches!(at(&with(vec![burn("fuel", 1.0, 1.0, 0.3)], vec![]), 0.0), SequenceError::Value { .. }));
    assert!(matches!(
        at(&with(vec![burn("fuel", 0.0, 1.0, -0.3)], vec![]), 0.0),
        SequenceError::Value { .. }
    ));
    assert!(matches!(at(&with(vec![], vec![drop(1.0, "craft/leg")]), 0.0), SequenceError::MissingRow { .. }));
    let twice = vec![drop(1.0, "craft/booster"), drop(2.0, "craft/booster/tank")];
    assert!(matches!(at(&with(vec![], twice), 0.0), SequenceError::Gone { .. }));
    let together = vec![drop(1.0, "craft/booster"), drop(1.0, "craft/arm")];
    assert!(matches!(at(&with(vec![], together), 0.0), SequenceError::Simultaneous { .. }));
    // A removed tank does not drain.
    let late = with(vec![burn("booster", 0.0, 3.0, 0.1)], vec![drop(1.0, "craft/booster")]);
    assert!(late.at(0.5).is_ok() && matches!(at(&late, 2.0), SequenceError::Gone { .. }));
    assert!(matches!(at(&with(vec![], vec![drop(1.0, "craft")]), 1.0), SequenceError::Nothing { .. }));
    let change = Change::Become { time: 2.0, name: "heavier".to_owned(), budget: &heavier };
    assert!(with(vec![], vec![change.clone()]).at(3.0).is_ok());
    let mut list = heavier.list().clone();
    list.rows[1].part = Some(part(21.0, [0.0; 3]));
    let heavier = list.budget().unwrap();
    let change = Change::Become { time: 2.0, name: "heavier".to_owned(), budget: &heavier };
    assert!(matches!(at(&with(vec![], vec![change]), 0.0), SequenceError::MassChanges { .. }));
    let in_copies = tank("extra", "craft/ballast", TankShape::Box([0.1; 3]), Down::MinusZ);
    let copies = Sequence::of(&first, Basis::Basic, [(in_copies, 0.1)]);
    assert!(matches!(at(&copies, 0.0), SequenceError::Copies { .. }));
    let twins = Sequence { tanks: tanks().into_iter().chain(tanks()).collect(), ..base() };
    assert!(matches!(at(&twins, 0.0), SequenceError::DuplicateTank { .. }));
}
