//! Series of the functions of a graph.

use super::*;
use crate::body::{InertiaTensor, MassProperties};
use crate::math::Position;
use crate::math::formula::{Binary, Formula, Instruction, Unary};
use crate::math::lanes::Lanes;
use crate::math::machine::Plain;
use crate::motion::model::torque::{FormulaTorque, TorqueModel};
use crate::motion::solve::propagate::taylor::all_zero;
use crate::motion::solve::propagate::taylor::row::TERMS;
use crate::motion::solve::propagate::taylor::row::Vectors;
use crate::motion::solve::propagate::taylor::sums::{OneBody, SeveralBodies};

const T: Instruction = Instruction::Variable(0);

/// Returns the coefficients of a formula of t about the time of each lane.
fn series<M: SeriesSums>(s: M, formula: &Formula, times: M::N) -> Scalars<M::N> {
    let zero = Formula::constant(0.0);
    let model = FormulaTorque::Body([formula.clone(), zero.clone(), zero]);
    let model = TorqueModel::Formula(Box::new(model));
    // The principal axes are the body axes.
    let inertia = InertiaTensor::diagonal([1.0, 2.0, 2.5]).unwrap();
    let rotor = Rotor::free(&MassProperties::new(1.0, Position::ZERO, inertia).unwrap());
    let graph = Graph::of([&model], &rotor);
    let zero = times.like(0.0);
    let mut tape = Tape::of(zero, &graph);
    (0..M::N::LANES).for_each(|lane| tape.set(lane, &graph, &rotor));
    let none = Row::splat(zero);
    let attitude = Row([zero.like(1.0), zero, zero, zero]);
    tape.start(&StepStart { time: times, attitude, omega: none, omega_low: none });
    let (omega, motion) = (Vectors::all(zero), all_zero(zero));
    let known = Known { s, omega: &omega, turning: &omega, motion: &motion };
    let mut series = Scalars::all(zero);
    for n in 0..TERMS {
        series[n] = tape.coefficient(n, &known).0[0];
    }
    series
}

/// Returns the series for a single body.
fn series_of_one(formula: &Formula, time: f64) -> Scalars {
    series(OneBody(Plain::<f64>::new()), formula, time)
}

/// Returns 0.3 + 0.2 t − 0.1 t².
fn quadratic() -> Vec<Instruction> {
    use Binary::{Add, Multiply, Subtract};
    let [b, c] = [0.2, 0.1].map(Instruction::Constant);
    let mut of_t = vec![Instruction::Constant(0.3), b, T, Instruction::Binary(Multiply)];
    of_t.extend([Instruction::Binary(Add), c, T, Instruction::Unary(Unary::Power(2))]);
    of_t.extend([Instruction::Binary(Multiply), Instruction::Binary(Subtract)]);
    of_t
}

#[test]
fn every_function_has_the_series_of_its_values() {
    use Unary::{Acos, Asin, Atan, Cos, Cosh, Exp, Expm1, Log, Log1p, Negate, Power, Sin, Sinh};
    use Unary::{Sqrt, Tan, Tanh};
    let mut formulas = Vec::new();
    for unary in [
        Negate,
        Sqrt,
        Exp,
        Log,
        Sin,
        Cos,
        Tan,
        Asin,
        Acos,
        Atan,
        Sinh,
        Cosh,
        Tanh,
        Log1p,
        Expm1,
        Power(3),
        Power(-2),
        Power(0),
    ] {
        let of_t = quadratic().into_iter().chain([Instruction::Unary(unary)]);
        formulas.push((format!("{unary:?}"), Formula::new(of_t).unwrap()));
    }
    use Binary::{Add, Atan2, Divide, Hypot, Multiply, Subtract};
    for binary in [Add, Subtract, Multiply, Divide, Binary::Power, Atan2, Hypot] {
        // of 0.3 + 0.2 t − 0.1 t² and its cosine, in both orders
        let (of_t, cosine) = (quadratic(), Instruction::Unary(Cos));
        let ahead = of_t.iter().chain(&of_t).copied().chain([cosine, Instruction::Binary(binary)]);
        formulas.push((format!("{binary:?}"), Formula::new(ahead).unwrap()));
        let back = of_t.iter().copied().chain([cosine]).chain(of_t.iter().copied());
        formulas
            .push((format!("{binary:?}"), Formula::new(back.chain([Instruction::Binary(binary)])).unwrap()));
    }
    // a constant power that is not a whole number
    let power = [Instruction::Constant(-1.7), Instruction::Binary(Binary::Power)];
    formulas.push(("t^-1.7".to_owned(), Formula::new(quadratic().into_iter().chain(power)).unwrap()));
    for (name, formula) in formulas {
        let starts = [0.4, -0.7, 0.0, -0.2];
        let together = series(SeveralBodies(Plain::<Lanes<4>>::new()), &formula, Lanes(starts));
        for (lane, start) in starts.into_iter().enumerate() {
            let coefficients = series_of_one(&formula, start);
            let same = |(one, all): (&f64, &Lanes<4>)| one.to_bits() == all.lane(lane).to_bits();
            assert!(coefficients.iter().zip(together.iter()).all(same), "{name}");
            for h in [-0.02, 0.015, 0.03] {
                let got = coefficients.iter().rev().fold(0.0, |sum, c| sum * h + c);
                let want = formula.evaluate(&[start + h]);
                assert!((got - want).abs() < 2e-15 * want.abs().max(1.0), "{name}: {got} {want}");
            }
        }
    }
}

#[test]
fn what_has_no_series_is_no_number() {
    let of = |instructions: &[Instruction]| {
        series_of_one(&Formula::new(instructions.iter().copied()).unwrap(), 0.0)
    };
    let root = of(&[T, Instruction::Unary(Unary::Sqrt)]);
    assert!(root[0] == 0.0 && root[1].is_nan());
    let distance = of(&[T, T, Instruction::Binary(Binary::Hypot)]);
    assert!(distance[1].is_nan());
    assert!(of(&[T, Instruction::Unary(Unary::Log)])[1..].iter().all(|c| !c.is_finite()));
    assert!(of(&[T, Instruction::Unary(Unary::Abs)])[0].is_nan());
    // the square root of a value that stays zero is zero
    let zero = [T, T, Instruction::Binary(Binary::Subtract), Instruction::Unary(Unary::Sqrt)];
    assert!(of(&zero).iter().all(|c| *c == 0.0));
    // a whole power may pass through zero
    let cube = of(&[T, Instruction::Unary(Unary::Power(3))]);
    assert_eq!(cube[..5], [0.0, 0.0, 0.0, 1.0, 0.0]);
}
