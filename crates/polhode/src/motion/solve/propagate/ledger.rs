//! Work and angular impulse on a body with changing mass properties: quadrature along its motion,
//! and jumps.

use super::balanced::Balanced;
use super::piece::Piece;
use crate::math::frame::Space;
use crate::math::sum::two_sum;
use crate::math::vector::AngularMomentum;
use crate::motion::model::rotor::Rotor;
use crate::motion::model::state::State;

/// Work and impulse since the start, at both ends of the last step. Each sum carries its rounding
/// error in a second word.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Ledger {
    from: [[f64; 2]; 4],
    now: [[f64; 2]; 4],
}

/// Positive Gauss–Legendre nodes on (−1, 1), and their weights; the negative nodes follow by
/// symmetry. (DLMF 3.5.v)
///
/// Order 16 suffices: a step is shorter than the radius of convergence and turns the body by a few
/// radians at most.
const NODES: [[f64; 2]; 4] = [
    [0.183_434_642_495_649_8, 0.362_683_783_378_362],
    [0.525_532_409_916_329, 0.313_706_645_877_887_3],
    [0.796_666_477_413_626_7, 0.222_381_034_453_374_48],
    [0.960_289_856_497_536_3, 0.101_228_536_290_376_26],
];

impl Ledger {
    /// Begins a step.
    pub(super) fn begin(&mut self) {
        self.from = self.now;
    }

    /// Ends the last step at a time, or shortens it to that time.
    pub(super) fn reach(&mut self, piece: &Piece<'_>, span: [f64; 2], at: &dyn Fn(f64) -> State) {
        self.now = self.from;
        add(&mut self.now, Self::between(piece, span, at));
    }

    /// Adds the jump of energy and angular momentum between two states.
    pub(super) fn jump(&mut self, rotors: [&Rotor; 2], states: [&State; 2]) {
        let [before, after] = [0, 1].map(|k| {
            let momentum = rotors[k].angular_momentum_space(states[k]).to_array();
            let energy = rotors[k].kinetic_energy(states[k].omega);
            [energy, momentum[0], momentum[1], momentum[2]]
        });
        add(&mut self.now, core::array::from_fn(|k| after[k] - before[k]));
    }

    /// Returns the state now, with work and impulse.
    pub(super) fn now(&self, state: State) -> Balanced {
        balanced(state, &self.now)
    }

    /// Returns the state at the start of the last step, with work and impulse.
    pub(super) fn from(&self, state: State) -> Balanced {
        balanced(state, &self.from)
    }

    /// Returns a state within the last step, with work and impulse.
    pub(super) fn at(
        &self,
        piece: &Piece<'_>,
        from: f64,
        state: State,
        at: &dyn Fn(f64) -> State,
    ) -> Balanced {
        let mut there = self.from;
        add(&mut there, Self::between(piece, [from, state.time], at));
        balanced(state, &there)
    }

    fn between(piece: &Piece<'_>, [from, to]: [f64; 2], at: &dyn Fn(f64) -> State) -> [f64; 4] {
        let Some((body, _)) = &piece.changing else { return [0.0; 4] };
        let (half, middle) = (0.5 * (to - from), 0.5 * (to + from));
        let mut sum = [0.0; 4];
        for [node, weight] in NODES {
            for side in [-half, half] {
                let (power, torque) = body.evidence(piece.rotor, &at(middle + node * side));
                let [x, y, z] = torque.to_array();
                sum.iter_mut().zip([power, x, y, z]).for_each(|(sum, rate)| *sum += weight * half * rate);
            }
        }
        sum
    }
}

fn add(to: &mut [[f64; 2]; 4], more: [f64; 4]) {
    for ([high, low], more) in to.iter_mut().zip(more) {
        (*high, *low) = two_sum(*high, more + *low);
    }
}

fn balanced(state: State, &[[work, _], [x, _], [y, _], [z, _]]: &[[f64; 2]; 4]) -> Balanced {
    Balanced { state, work, impulse: AngularMomentum::<Space>::new(x, y, z) }
}
