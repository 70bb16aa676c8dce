//! Draws of possible bodies compared with first order, and cases in which they differ.

use polhode::math::{Direction, Position};
use polhode_budget::{
    Basis, CopyErrors, GivenPart, GivenTensor, NUMBERS, PartUncertainty, PartsList, Quantity, Row, Spread,
    Uncertainty,
};

use crate::lists::{cases, list};

/// Returns the list with all errors multiplied by a factor.
fn less(mut list: PartsList, by: f64) -> PartsList {
    fn times<const N: usize>(spread: &mut Spread<N>, by: f64) {
        let Spread::Deviations(sd) = spread else { unreachable!() };
        sd.iter_mut().for_each(|sd| *sd *= by);
    }
    for row in &mut list.rows {
        let PartUncertainty::Separate { mass, center, tensor, .. } = &mut row.uncertainty.part else {
            unreachable!()
        };
        *mass *= by;
        times(center, by);
        times(tensor, by);
        times(&mut row.uncertainty.position, by);
        times(&mut row.uncertainty.rotation, by);
    }
    list
}

#[test]
fn small_errors_are_those_of_first_order() {
    for case in cases() {
        let budget = less(list(&case), 0.01).budget().unwrap();
        for basis in [Basis::Basic, Basis::Predicted] {
            let estimate = budget.estimate(basis).unwrap();
            let comparison = budget.draws(basis, 271, 4000).unwrap().compare(&estimate);
            assert_eq!(comparison.moved, 0);
            for number in &comparison.numbers {
                assert!(!number.differs(), "{} {number:?}", case["name"]);
                assert!((number.sd / number.first_order_sd - 1.0).abs() < 0.06, "{number:?}");
            }
            // all correlations agree too: their standard error is (1 − r²)/√n
            for i in 0..10 {
                for j in 0..i {
                    let r = |c: &[[f64; 10]; 10]| c[i][j] / (c[i][i] * c[j][j]).sqrt();
                    let (got, want) = (r(&comparison.covariance), r(&estimate.covariance));
                    assert!(
                        (got - want).abs() < 4.5 * (1.0 - want * want) / 4000_f64.sqrt(),
                        "{} {}, {}: {got} {want}",
                        case["name"],
                        NUMBERS[i].0,
                        NUMBERS[j].0
                    );
                }
            }
        }
    }
}

#[test]
fn a_draw_depends_on_its_number_and_the_seed_alone() {
    let budget = list(&cases()[1]).budget().unwrap();
    let some = budget.draws(Basis::Basic, 5, 10).unwrap();
    let more = budget.draws(Basis::Basic, 5, 25).unwrap();
    assert_eq!(some.bodies[..], more.bodies[..10]);
    assert_ne!(some.bodies, budget.draws(Basis::Basic, 6, 10).unwrap().bodies);
}

fn one(tensor: GivenTensor, part: PartUncertainty) -> PartsList {
    let row =
        Row::part("part", GivenPart { mass: 2.0, center_of_mass: Position::new(0.1, 0.2, 0.3), tensor });
    let row = Row { uncertainty: Uncertainty { part, ..Uncertainty::default() }, ..row };
    PartsList { rows: vec![row], ..PartsList::default() }
}

#[test]
fn what_is_exact_is_drawn_as_it_is() {
    let tensor = GivenTensor { moments: [1.0, 2.0, 2.5], ..GivenTensor::ZERO };
    let budget = one(tensor, PartUncertainty::of_mass(0.0)).budget().unwrap();
    let (estimate, draws) =
        (budget.estimate(Basis::Basic).unwrap(), budget.draws(Basis::Basic, 1, 10).unwrap());
    assert!(draws.bodies.iter().all(|body| *body == estimate.properties) && draws.moved == 0);
    assert!(draws.compare(&estimate).numbers.iter().all(|number| !number.differs() && number.sd == 0.0));
}

#[test]
fn plates_become_thicker_and_never_impossible() {
    let tensor = GivenTensor { moments: [1.0, 2.0, 3.0], ..GivenTensor::ZERO };
    let part = PartUncertainty::Separate {
        mass: 0.0,
        tensor_follows_mass: false,
        center: Spread::Exact,
        tensor: Spread::Deviations([0.02, 0.02, 0.02, 0.0, 0.0, 0.0]),
    };
    let budget = one(tensor, part).budget().unwrap();
    let estimate = budget.estimate(Basis::Basic).unwrap();
    let draws = budget.draws(Basis::Basic, 9, 20_000).unwrap();
    for body in &draws.bodies {
        let [i1, i2, i3] = body.principal().moments();
        assert!(i1 + i2 >= i3 * (1.0 - 1e-12));
    }
    // Half of the drawn tensors are impossible: g = ½ (Ixx + Iyy − Izz) is normal about 0.
    let share = draws.moved as f64 / 20_000.0;
    assert!((share - 0.5).abs() < 4.0 * 0.5 / 20_000_f64.sqrt(), "{share}");
    // E max(g, 0) = σ/√2π, and Ixx = `g_yy` + `g_zz`. The means of Ixx and Iyy are greater by that;
    // the mean of Izz is not.
    let sd = 0.5 * 3.0_f64.sqrt() * 0.02;
    let expected = sd / (2.0 * core::f64::consts::PI).sqrt();
    let numbers = draws.compare(&estimate).numbers;
    for number in &numbers[4..6] {
        assert!((number.bias() - expected).abs() < 4.0 * number.mean_error, "{number:?} {expected}");
        assert!(number.differs());
    }
    assert!(numbers[6].bias().abs() < 4.0 * numbers[6].mean_error);
}

#[test]
fn masses_stay_positive_with_the_mean_that_is_stated() {
    let tensor = GivenTensor { moments: [1.0, 2.0, 2.5], ..GivenTensor::ZERO };
    let budget = one(tensor, PartUncertainty::of_mass(1.2)).budget().unwrap();
    let estimate = budget.estimate(Basis::Basic).unwrap();
    let draws = budget.draws(Basis::Basic, 4, 20_000).unwrap();
    assert!(draws.bodies.iter().all(|body| body.mass() > 0.0));
    let numbers = draws.compare(&estimate).numbers;
    for k in [0, 4, 5, 6] {
        assert!(!numbers[k].differs(), "{:?}", numbers[k]);
    }
}

#[test]
fn copies_are_drawn_alike_or_each() {
    for (errors, factor) in [(CopyErrors::Alike, 9.0), (CopyErrors::Independent, 3.0)] {
        let mut list = one(GivenTensor::ZERO, PartUncertainty::of_mass(0.05));
        list.rows[0].quantity = Quantity { count: 9, errors };
        let budget = list.budget().unwrap();
        let estimate = budget.estimate(Basis::Basic).unwrap();
        assert!((estimate.sd(0) - 0.05 * factor).abs() < 1e-15);
        let mass = budget.draws(Basis::Basic, 8, 5000).unwrap().compare(&estimate).numbers[0];
        assert!(!mass.differs() && (mass.sd / (0.05 * factor) - 1.0).abs() < 0.05, "{mass:?}");
    }
}

#[test]
fn tilts_are_those_of_first_order_where_they_are_large() {
    let budget = less(list(&cases()[0]), 0.03).budget().unwrap();
    let estimate = budget.estimate(Basis::Basic).unwrap();
    let n = Direction::new(0.3, -0.5, 0.7);
    let tilt = estimate.principal().tilt(&estimate, 2, n).unwrap();
    let tilts = budget.draws(Basis::Basic, 77, 4000).unwrap().tilts(2, n).unwrap();
    let mean = tilts.iter().sum::<f64>() / 4000.0;
    let sd = (tilts.iter().map(|t| (t - mean) * (t - mean)).sum::<f64>() / 3999.0).sqrt();
    assert!((mean - tilt.angle).abs() < 4.0 * sd / 4000_f64.sqrt());
    assert!((sd / tilt.sd.unwrap() - 1.0).abs() < 0.05, "{sd} {tilt:?}");
}
