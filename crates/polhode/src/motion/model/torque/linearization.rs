//! Linearised equations of motion: derivatives of the rates with respect to the state, the inertia
//! and the parameters.
//!
//! The angular momentum is L = I ω + h. The axes of the body turn at Ω = ω + α L × ω, where α is
//! the coefficient of an energy sink, and
//!
//! I ω̇ = L × Ω + N − ḣ
//!
//! Ω and L × Ω + N are recorded like a law (`variation.rs`), so that no torque is stated twice.

use super::TorqueModel;
use super::graph::Graph;
use super::parameter::ParameterKind;
use super::recorder::Recorder;
use super::variation::{Along, Variation};
use super::varied::VariedVector;
use crate::math::algebra::VectorAlgebra;
use crate::motion::model::law::LawInput;
use crate::motion::model::rotor::Rotor;

/// Graph of the derivatives of Ω and of L × Ω + N, principal axes. Without a sink it has only the
/// derivatives of N. Then Ω = ω, and those of L × ω follow directly from ω, which is faster.
#[derive(Clone, Debug)]
pub(in crate::motion) struct Linearization {
    pub(in crate::motion) graph: Graph,
    /// Derivatives with respect to a rotation about each principal axis, and to ω along each.
    pub(in crate::motion) by_state: [Slope; 6],
    /// Derivatives with respect to the elements of the inertia tensor, body axes.
    pub(in crate::motion) by_inertia: [Slope; 6],
    /// Derivatives with respect to the parameters.
    pub(in crate::motion) by_parameters: Vec<Slope>,
}

/// Derivatives, given by their places among the vectors of the graph. `None` means zero or absent.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::motion) struct Slope {
    /// Derivative of Ω.
    pub(in crate::motion) turning: Option<usize>,
    /// Derivative of L × Ω + N.
    pub(in crate::motion) torque: Option<usize>,
}

/// Parameter of a torque that acts; `None` for a torque that does not act at present.
pub(in crate::motion) type ActingParameter<'t> = Option<(&'t TorqueModel, ParameterKind)>;

impl Linearization {
    /// Linearises the torques that act on a body, without schedules.
    pub(in crate::motion) fn of(
        rotor: &Rotor,
        torques: &[&TorqueModel],
        parameters: &[ActingParameter<'_>],
    ) -> Self {
        let sink: f64 = torques.iter().map(|torque| torque.sink()).sum();
        let record = |recorder: &Recorder<'_>| {
            // No graph is empty.
            recorder.omega();
            let at = |along: Along| Variation { recorder, along };
            let by = |along: Along| {
                let outside = torques.iter().filter(|torque| torque.sink() == 0.0);
                let torque = outside.map(|torque| torque.model().variation(&at(along))).reduce(|a, b| a + b);
                if sink == 0.0 {
                    return Slope { turning: None, torque: torque.and_then(place) };
                }
                let [turning, gyroscopic] = rigid(&at(along), sink);
                let torque = torque.map_or(gyroscopic, |torque| gyroscopic + torque);
                Slope { turning: place(turning), torque: place(torque) }
            };
            let by_parameter = |parameter: &ActingParameter<'_>| match *parameter {
                None => Slope::default(),
                Some((torque, ParameterKind::OfLaw(which))) if torque.sink() > 0.0 => {
                    let [turning, torque] = rigid(&at(Along::Parameter(which)), sink).map(place);
                    Slope { turning, torque }
                }
                Some((torque, ParameterKind::OfLaw(which))) => {
                    let torque = place(torque.model().variation(&at(Along::Parameter(which))));
                    Slope { turning: None, torque }
                }
                Some((torque, ParameterKind::Factor)) => {
                    Slope { turning: None, torque: Some(torque.model().record(recorder).place) }
                }
            };
            (
                core::array::from_fn(|k| by(if k < 3 { Along::Turn(k) } else { Along::Omega(k - 3) })),
                core::array::from_fn(|k| by(Along::Inertia(k))),
                parameters.iter().map(by_parameter).collect(),
            )
        };
        let (graph, (by_state, by_inertia, by_parameters)) = Graph::recorded(rotor, record);
        Self { graph, by_state, by_inertia, by_parameters }.condensed()
    }

    /// Reduces the number of operations.
    fn condensed(mut self) -> Self {
        let slopes = self.by_state.iter_mut().chain(&mut self.by_inertia).chain(&mut self.by_parameters);
        let mut places: Vec<_> =
            slopes.flat_map(|slope| [&mut slope.turning, &mut slope.torque]).flatten().collect();
        // Include the vector that is always present.
        let kept: Vec<_> =
            core::iter::once(self.graph.torque).chain(places.iter().map(|place| **place)).collect();
        let (graph, kept) = self.graph.condensed(&kept);
        places.iter_mut().zip(&kept[1..]).for_each(|(place, new)| **place = *new);
        self.graph = Graph { torque: kept[0], ..graph };
        self
    }
}

/// Returns Ω and L × Ω. α is the only parameter.
fn rigid<I: LawInput>(at: &I, sink: f64) -> [I::Vector; 2] {
    let omega = at.omega();
    let carrier = at.inertia(omega);
    let momentum = if at.rotor().wheels().is_empty() { carrier } else { carrier + at.wheel_momentum() };
    let turning = omega + momentum.cross(omega) * at.parameter(0, sink);
    [turning, momentum.cross(turning)]
}

/// Returns the place of a derivative.
fn place(v: VariedVector<'_>) -> Option<usize> {
    v.slope.map(|slope| slope.place)
}
