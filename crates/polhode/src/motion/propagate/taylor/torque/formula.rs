//! The series of a torque that formulas give: one row of coefficients for each value that occurs in them.

mod graph;

use super::super::row::{Row, TERMS};
use super::super::scalar::Scalars;
use crate::math::frame::{Principal, Space};
use crate::math::rotation::Rotation;
use crate::math::vector::{Torque, Vector};
use crate::motion::propagate::chart::{ROUNDING, THIN};
use crate::motion::rotor::Rotor;
use crate::motion::torque::FormulaTorque;
use graph::{Graph, Input, Node, Place};

/// The series of a torque that formulas give.
///
/// All that the motion gives is linear in ω (principal axes) or in the turn since the start of the step: rows of matrices.
#[derive(Clone, Debug)]
pub(in super::super) struct FormulaSeries {
    nodes: Vec<Node>,
    rows: Vec<Scalars>,
    /// Where the three components are, body axes.
    components: [Place; 3],
    rotor: Rotor,
    /// R_body_principal: ω in body axes from principal ones.
    omega: [[f64; 3]; 3],
    /// R_body_principal diag(i1, i2, i3): I ω.
    carrier: [[f64; 3]; 3],
    /// The attitude's quaternion from the turn.
    attitude: [[f64; 4]; 4],
    time: f64,
    /// Σ h a, and its rate, body axes.
    wheels: [[f64; 3]; 2],
    /// Which principal axes are those of a needle.
    thin: [bool; 3],
}

impl FormulaSeries {
    pub(super) fn of(model: &FormulaTorque, rotor: &Rotor) -> Self {
        let mut graph = Graph::default();
        let in_space = matches!(model, FormulaTorque::Space(_));
        let components = graph.components(model.components(), in_space);
        let (omega, moments) = (rotor.principal().rotation().matrix(), rotor.principal().moments());
        Self {
            rows: vec![[0.0; TERMS]; graph.nodes.len()],
            nodes: graph.nodes,
            components,
            rotor: rotor.clone(),
            omega,
            carrier: omega.map(|row| [0, 1, 2].map(|k| row[k] * moments[k])),
            attitude: [[0.0; 4]; 4],
            time: 0.0,
            wheels: [[0.0; 3]; 2],
            thin: moments.map(|moment| moment < THIN * moments[2]),
        }
    }

    pub(super) fn start(&mut self, time: f64, attitude: Rotation<Space, Principal>) {
        self.time = time;
        // q = (q at the start) ∘ turn ∘ (principal ← body), one column for each component of the turn
        let before = attitude.quaternion();
        let after = self.rotor.principal().rotation().inverse().quaternion();
        for column in 0..4 {
            let mut unit = [0.0; 4];
            unit[column] = 1.0;
            let image = quaternion_product(quaternion_product(before, unit), after);
            self.attitude.iter_mut().zip(image).for_each(|(row, value)| row[column] = value);
        }
        let (momentum, rate) = (self.rotor.wheel_momentum(time), self.rotor.motor_torque(time));
        self.wheels = [momentum.to_array(), rate.to_array()];
    }

    /// Coefficient n of N, of those of ω and of the turn.
    #[inline(never)]
    pub(super) fn coefficient(&mut self, n: usize, omega: Row, turn: Row) -> Row {
        for place in 0..self.nodes.len() {
            let value = match self.nodes[place] {
                Node::Input(input) => self.input(input, n, omega, turn),
                node if n == 0 => node.start(&self.rows),
                node => node.coefficient(place, &self.rows, n),
            };
            self.rows[place][n] = value;
        }
        let body = self.components.map(|place| self.rows[place][n]);
        self.along_principal(body)
    }

    /// Coefficient n of what the motion gives.
    #[inline(always)]
    fn input(&self, input: Input, n: usize, omega: Row, turn: Row) -> f64 {
        let linear = |row: [f64; 3]| {
            let [x, y, z, _] = omega.0;
            row[0] * x + row[1] * y + row[2] * z
        };
        match input {
            Input::Time => match n {
                0 => self.time,
                1 => 1.0,
                _ => 0.0,
            },
            Input::Omega(k) => linear(self.omega[k]),
            Input::Carrier(k) => linear(self.carrier[k]),
            Input::Wheels(k) => self.wheels.get(n).map_or(0.0, |h| h[k]),
            Input::Attitude(k) => {
                let ([w, x, y, z], row) = (turn.0, self.attitude[k]);
                row[0] * w + row[1] * x + (row[2] * y + row[3] * z)
            }
        }
    }

    /// Along principal axes, without what is only rounding along the axis of a needle.
    #[inline(always)]
    fn along_principal(&self, [a, b, c]: [f64; 3]) -> Row {
        let r = &self.omega;
        let component = |k: usize| r[0][k] * a + r[1][k] * b + r[2][k] * c;
        let torque: Torque<Principal> = Vector::new(component(0), component(1), component(2));
        let least = ROUNDING * (a.abs() + b.abs() + c.abs());
        let clean = |n: f64, k: usize| if self.thin[k] && n.abs() < least { 0.0 } else { n };
        Row([clean(torque.x, 0), clean(torque.y, 1), torque.z, 0.0])
    }
}

/// a ∘ b, Hamilton's.
fn quaternion_product([a, b, c, d]: [f64; 4], [w, x, y, z]: [f64; 4]) -> [f64; 4] {
    [
        a * w - b * x - c * y - d * z,
        a * x + b * w + c * z - d * y,
        a * y - b * z + c * w + d * x,
        a * z + b * y - c * x + d * w,
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::formula::{Binary, Formula, Instruction, Unary};
    use crate::{InertiaTensor, MassProperties, Position};

    const T: Instruction = Instruction::Variable(0);

    fn rotor() -> Rotor {
        let inertia = InertiaTensor::with_negative_products([3.1, 4.2, 5.3], [0.4, -0.3, 0.2]).unwrap();
        Rotor::free(&MassProperties::new(2.3, Position::new(0.11, -0.07, 0.23), inertia).unwrap())
    }

    /// Coefficients of a formula of t about a time.
    fn series(formula: &Formula, time: f64) -> Scalars {
        let zero = Formula::constant(0.0);
        let model = FormulaTorque::Body([formula.clone(), zero.clone(), zero]);
        let mut series = FormulaSeries::of(&model, &rotor());
        series.start(time, Rotation::identity());
        for n in 0..TERMS {
            series.coefficient(n, Row::ZERO, Row::ZERO);
        }
        series.rows[series.components[0]]
    }

    /// 0.3 + 0.2 t − 0.1 t²
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
        use Unary::{Acos, Asin, Atan, Cos, Exp, Log, Negate, Power, Sin, Sqrt, Tan};
        let mut formulas = Vec::new();
        for unary in [Negate, Sqrt, Exp, Log, Sin, Cos, Tan, Asin, Acos, Atan, Power(3), Power(-2), Power(0)]
        {
            let of_t = quadratic().into_iter().chain([Instruction::Unary(unary)]);
            formulas.push((format!("{unary:?}"), Formula::new(of_t).unwrap()));
        }
        use Binary::{Add, Atan2, Divide, Hypot, Multiply, Subtract};
        for binary in [Add, Subtract, Multiply, Divide, Binary::Power, Atan2, Hypot] {
            // of 0.3 + 0.2 t − 0.1 t² and its cosine, and the other way round
            let (of_t, cosine) = (quadratic(), Instruction::Unary(Cos));
            let ahead = of_t.iter().chain(&of_t).copied().chain([cosine, Instruction::Binary(binary)]);
            formulas.push((format!("{binary:?}"), Formula::new(ahead).unwrap()));
            let back = of_t.iter().copied().chain([cosine]).chain(of_t.iter().copied());
            formulas.push((
                format!("{binary:?}"),
                Formula::new(back.chain([Instruction::Binary(binary)])).unwrap(),
            ));
        }
        // a constant power that is not whole
        let power = [Instruction::Constant(-1.7), Instruction::Binary(Binary::Power)];
        formulas.push(("t^-1.7".to_owned(), Formula::new(quadratic().into_iter().chain(power)).unwrap()));
        for (name, formula) in formulas {
            for start in [0.4, -0.7] {
                let coefficients = series(&formula, start);
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
        let of =
            |instructions: &[Instruction]| series(&Formula::new(instructions.iter().copied()).unwrap(), 0.0);
        let root = of(&[T, Instruction::Unary(Unary::Sqrt)]);
        assert!(root[0] == 0.0 && root[1].is_nan());
        let distance = of(&[T, T, Instruction::Binary(Binary::Hypot)]);
        assert!(distance[1].is_nan());
        assert!(of(&[T, Instruction::Unary(Unary::Log)])[1..].iter().all(|c| !c.is_finite()));
        assert!(of(&[T, Instruction::Unary(Unary::Abs)])[0].is_nan());
        // but what stays zero has a root that does
        let zero = [T, T, Instruction::Binary(Binary::Subtract), Instruction::Unary(Unary::Sqrt)];
        assert_eq!(of(&zero), [0.0; TERMS]);
        // and a whole power may pass through zero
        let cube = of(&[T, Instruction::Unary(Unary::Power(3))]);
        assert_eq!(cube[..5], [0.0, 0.0, 0.0, 1.0, 0.0]);
    }
}
