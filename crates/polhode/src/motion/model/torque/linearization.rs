//! The equations of motion, differentiated: what a small change of the state, of the inertia or of a parameter does to the rates.
//!
//! With L = I ω + h and friction inside, Ω = ω + α L × ω, the axes of the body turn at Ω, and
//!
//! I ω̇ = L × Ω + N − ḣ
//!
//! Ω and L × Ω + N are recorded as a law is (`variation.rs`), so that nothing of a torque is stated here again.

use super::TorqueModel;
use super::graph::Graph;
use super::law::LawInput;
use super::parameter::ParameterKind;
use super::recorder::{Recorder, VectorNode};
use super::variation::{Along, Variation};
use super::varied::VariedVector;
use crate::math::algebra::VectorAlgebra;
use crate::motion::model::rotor::Rotor;

/// A graph of the derivatives of Ω and of L × Ω + N, principal axes.
#[derive(Clone, Debug)]
pub(in crate::motion) struct Linearization {
    pub(in crate::motion) graph: Graph,
    /// By a turn about each principal axis, and by ω along each.
    pub(in crate::motion) by_state: [Slope; 6],
    /// By the elements of the inertia tensor, body axes.
    pub(in crate::motion) by_inertia: [Slope; 6],
    /// By the parameters.
    pub(in crate::motion) by_parameters: Vec<Slope>,
}

/// Derivatives by their places among the vectors of the graph; `None` where they are zero.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::motion) struct Slope {
    /// Of Ω. Without friction Ω is ω, and it is not here.
    pub(in crate::motion) turning: Option<usize>,
    /// Of L × Ω + N.
    pub(in crate::motion) torque: Option<usize>,
}

/// A parameter of one of the torques that act; `None` of one that does not act now.
pub(in crate::motion) type ActingParameter<'t> = Option<(&'t TorqueModel, ParameterKind)>;

impl Linearization {
    /// Of what acts on a body, without schedules.
    pub(in crate::motion) fn of(
        rotor: &Rotor,
        torques: &[&TorqueModel],
        parameters: &[ActingParameter<'_>],
    ) -> Self {
        let sink: f64 = torques.iter().map(|torque| torque.sink()).sum();
        let record = |recorder: &Recorder<'_>| {
            let by = |along: Along| {
                let at = Variation { recorder, along };
                let [turning, gyroscopic] = rigid(&at, sink);
                let torque = torques.iter().filter(|torque| torque.sink() == 0.0);
                let torque = torque.fold(gyroscopic, |sum, torque| sum + torque.model().variation(&at));
                slope(sink, [turning, torque])
            };
            let state = |k: usize| if k < 3 { Along::Turn(k) } else { Along::Omega(k - 3) };
            let by_parameter = |parameter: &ActingParameter<'_>| {
                let Some((torque, kind)) = parameter else { return Slope::default() };
                match kind {
                    ParameterKind::OfLaw(which) if torque.sink() > 0.0 => {
                        slope(sink, rigid(&Variation { recorder, along: Along::Parameter(*which) }, sink))
                    }
                    ParameterKind::OfLaw(which) => {
                        let at = Variation { recorder, along: Along::Parameter(*which) };
                        place(torque.model().variation(&at).slope)
                    }
                    ParameterKind::Factor => place(Some(torque.model().record(recorder))),
                }
            };
            (
                core::array::from_fn(|k| by(state(k))),
                core::array::from_fn(|k| by(Along::Inertia(k))),
                parameters.iter().map(by_parameter).collect(),
            )
        };
        let (graph, (by_state, by_inertia, by_parameters)) = Graph::recorded(rotor, record);
        Self { graph, by_state, by_inertia, by_parameters }
    }
}

/// Ω and L × Ω. α is its only parameter.
fn rigid<I: LawInput>(at: &I, sink: f64) -> [I::Vector; 2] {
    let omega = at.omega();
    let carrier = at.inertia(omega);
    let momentum = if at.rotor().wheels().is_empty() { carrier } else { carrier + at.wheel_momentum() };
    let turning = if sink == 0.0 { omega } else { omega + momentum.cross(omega) * at.parameter(0, sink) };
    [turning, momentum.cross(turning)]
}

fn slope(sink: f64, [turning, torque]: [VariedVector<'_>; 2]) -> Slope {
    let of = |v: VariedVector<'_>| v.slope.map(|slope| slope.place);
    Slope { turning: if sink == 0.0 { None } else { of(turning) }, torque: of(torque) }
}

/// Of what is a torque only.
fn place(torque: Option<VectorNode<'_>>) -> Slope {
    Slope { turning: None, torque: torque.map(|torque| torque.place) }
}
