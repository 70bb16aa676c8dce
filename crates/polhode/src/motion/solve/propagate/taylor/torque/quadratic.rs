//! Sum of all torques that are linear or quadratic: N = c + A u + B ω + (g₁ u₂ u₃, g₂ u₃ u₁, g₃ u₁
//! u₂), u̇ = u × Ω + s.
//!
//! Constant torques, thrusters, gravity, magnets in uniform fields, linear drag, and the gravity
//! gradient of a circular orbit are of this kind. Most motions need no others, and u is expanded in
//! the same recurrence as the rotation.

use super::super::recurrence::EquationConstants;
use super::super::row::{Row, Vectors};
use super::super::sums::SeriesSums;
use super::tape::times;
use super::{StepStart, row};
use crate::math::number::Number;
use crate::motion::model::law::LawInput as _;
use crate::motion::model::orbit::Orbit;
use crate::motion::model::rotor::Rotor;
use crate::motion::model::torque::TorqueModel;
use crate::motion::model::torque::graph::{Graph, Operation};
use crate::motion::model::torque::polynomial::{JointVector, QuadraticTorque, Unknowns};
use crate::motion::solve::propagate::rounding::{ROUNDING, THIN};

/// Torques on a body, grouped by the method of their series.
#[derive(Clone, Debug)]
pub(in super::super) struct Decomposition {
    /// Sum of the linear and quadratic torques, if there are any.
    pub(in super::super) quadratic: Option<QuadraticTorque>,
    /// Vector u, if they contain one.
    pub(in super::super) joint: Option<Box<JointVector>>,
    /// Graph of the torques that depend on time alone.
    pub(in super::super) forcing: Option<Box<Graph>>,
    /// Graph of all other torques.
    pub(in super::super) graph: Option<Box<Graph>>,
}

/// Properties of the torques that bodies in one batch must share. They differ only in their
/// numbers.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(in super::super) struct TorqueKind {
    /// Linear or quadratic torques, if there are any: true if ω occurs in them.
    quadratic: Option<bool>,
    /// Vector u, if there is one: true if it is on a circular orbit.
    joint: Option<bool>,
    forcing: Vec<Operation>,
    operations: Vec<Operation>,
    orbits_are_circular: Vec<bool>,
    turns_are_canonical: Vec<bool>,
}

impl Decomposition {
    pub(in super::super) fn kind(&self) -> TorqueKind {
        let graph = self.graph.as_deref();
        let all = |operations: &Graph| operations.operations.clone();
        let circular = |graph: &Graph| graph.orbits.iter().map(Orbit::is_circular).collect();
        let canonical = |graph: &Graph| graph.turns.iter().map(|(_, is_canonical)| *is_canonical).collect();
        TorqueKind {
            quadratic: self.quadratic.as_ref().map(|torque| torque.has_omega),
            joint: self.joint.as_deref().map(|joint| matches!(joint, JointVector::Circular(_))),
            forcing: self.forcing.as_deref().map(all).unwrap_or_default(),
            operations: graph.map(all).unwrap_or_default(),
            orbits_are_circular: graph.map(circular).unwrap_or_default(),
            turns_are_canonical: graph.map(canonical).unwrap_or_default(),
        }
    }

    /// Decomposes the torques that act on a body, without schedules. With wheels or friction, u
    /// cannot be on an orbit.
    pub(in super::super) fn of<'t>(
        rotor: &Rotor,
        torques: impl Iterator<Item = &'t TorqueModel> + Clone,
        is_plain: bool,
    ) -> Self {
        let found = is_plain.then(|| Self::split(rotor, torques.clone(), true));
        let needs_all = |found: &Self| {
            matches!(found.joint.as_deref(), Some(JointVector::Circular(_))) && found.graph.is_some()
        };
        match found {
            Some(found) if !needs_all(&found) => found,
            _ => Self::split(rotor, torques, false),
        }
    }

    fn split<'t>(rotor: &Rotor, torques: impl Iterator<Item = &'t TorqueModel>, with_orbit: bool) -> Self {
        let unknowns = Unknowns::new(rotor, with_orbit);
        let (mut quadratic, mut others) = (None::<QuadraticTorque>, Vec::new());
        // Internal friction is not a torque on the body.
        for torque in torques.filter(|torque| torque.model().sink() == 0.0) {
            let had_joint = unknowns.has_joint();
            let found = QuadraticTorque::of(&torque.model().polynomial(&unknowns));
            match found.filter(|found| !unknowns.is_on_orbit() || found.of_joint == [[0.0; 3]; 3]) {
                Some(found) => {
                    let found = cleaned(found, rotor);
                    quadratic = Some(quadratic.map_or(found, |sum| sum.plus(&found)));
                }
                None => {
                    if !had_joint {
                        unknowns.forget_joint();
                    }
                    others.push(torque);
                }
            }
        }
        let mut decomposition = Self { quadratic, joint: None, forcing: None, graph: None };
        if !others.is_empty() {
            let separated = Graph::of(others, rotor).separated(|v| unknowns.may_be_joint(v));
            if let Some(u) = separated.joint {
                unknowns.in_space(u);
            }
            if let Some(linear) = separated.linear {
                let linear = cleaned(linear, rotor);
                decomposition.quadratic =
                    Some(decomposition.quadratic.map_or(linear, |sum| sum.plus(&linear)));
            }
            decomposition.forcing = separated.forcing.map(Box::new);
            decomposition.graph = separated.rest.map(|graph| Box::new(graph.packed()));
        }
        decomposition.joint = unknowns.into_joint().map(Box::new);
        decomposition
    }
}

/// Removes entries of c, A and B that are only rounding, about the axis of a needle. Divided by the
/// very small moment, they would make the needle spin.
fn cleaned(mut torque: QuadraticTorque, rotor: &Rotor) -> QuadraticTorque {
    let moments = rotor.principal().moments();
    if moments[0] >= THIN * moments[2] {
        return torque;
    }
    let mut constant = [torque.constant];
    for columns in [&mut constant[..], &mut torque.of_joint, &mut torque.of_omega] {
        let size = |k: usize| columns.iter().map(|column| column[k].abs()).fold(0.0, f64::max);
        let sizes = [size(0), size(1), size(2)];
        let largest = sizes.iter().copied().fold(0.0, f64::max);
        for k in 0..2 {
            if moments[k] < THIN * moments[2] && sizes[k] < ROUNDING * largest {
                columns.iter_mut().for_each(|column| column[k] = 0.0);
            }
        }
    }
    [torque.constant] = constant;
    torque
}

/// Coefficients of these torques, for each lane.
#[derive(Clone, Debug)]
pub(in super::super) struct Quadratic<N> {
    torque: Coefficients<N>,
    /// Coefficients of N/I.
    acceleration: Coefficients<N>,
    joint: Option<Joint<N>>,
    has_omega: bool,
}

/// Coefficients c, columns of A and of B, and g.
#[derive(Clone, Copy, Debug)]
struct Coefficients<N> {
    constant: Row<N>,
    of_joint: [Row<N>; 3],
    of_omega: [Row<N>; 3],
    products: Row<N>,
}

/// Vector u of each lane.
#[derive(Clone, Debug)]
enum Joint<N> {
    /// Vector fixed in space, space axes.
    Fixed(Row<N>),
    /// Orbit of each lane.
    Circular(Vec<Orbit>),
}

impl<N: Number> Quadratic<N> {
    /// Creates the coefficients for all bodies with such torques.
    pub(in super::super) fn of(zero: N, torque: &QuadraticTorque, joint: Option<&JointVector>) -> Self {
        let none = Row::splat(zero);
        let nothing =
            Coefficients { constant: none, of_joint: [none; 3], of_omega: [none; 3], products: none };
        Self {
            torque: nothing,
            acceleration: nothing,
            joint: joint.map(|joint| match joint {
                JointVector::Fixed(_) => Joint::Fixed(none),
                JointVector::Circular(orbit) => Joint::Circular(vec![orbit.clone(); N::LANES]),
            }),
            has_omega: torque.has_omega,
        }
    }

    /// Sets the torques of a lane's body. `inverses`: inverses of its moments. `terms`: constants
    /// of the recurrence that are set too.
    pub(in super::super) fn set(
        &mut self,
        lane: usize,
        torque: &QuadraticTorque,
        joint: Option<&JointVector>,
        inverses: Row,
        terms: Option<&mut EquationConstants<N>>,
    ) {
        let whole = |v: [f64; 3]| Row([v[0], v[1], v[2], 0.0]);
        let over = |v: [f64; 3]| inverses * whole(v);
        self.torque.put(lane, torque, whole);
        self.acceleration.put(lane, torque, over);
        let mut strength = 0.0;
        match (&mut self.joint, joint) {
            (Some(Joint::Fixed(place)), Some(JointVector::Fixed(v))) => place.put(lane, row(*v)),
            (Some(Joint::Circular(orbits)), Some(JointVector::Circular(orbit))) => {
                orbits[lane] = orbit.clone();
                strength = orbit.strength(orbit.periapsis());
            }
            _ => {}
        }
        let Some(terms) = terms else { return };
        terms.constant.put(lane, over(torque.constant));
        let columns = torque.of_joint.map(|column| over(column).0);
        for (diagonal, place) in terms.of_joint.iter_mut().enumerate() {
            let entry = |row: usize| columns[(row + diagonal) % 3][row];
            place.put(lane, Row([entry(0), entry(1), entry(2), 0.0]));
        }
        terms.has_omega = self.has_omega;
        for (place, column) in terms.of_omega.iter_mut().zip(torque.of_omega) {
            place.put(lane, over(column));
        }
        terms.strength.put(lane, strength);
        terms.products.put(lane, over(torque.products));
    }

    /// Returns true if u is on a circular orbit.
    pub(in super::super) fn is_on_orbit(&self) -> bool {
        matches!(self.joint, Some(Joint::Circular(_)))
    }

    /// Returns u at the start of a step, and its rate in space, principal axes.
    #[inline(always)]
    pub(in super::super) fn start(&self, at: &StepStart<N>) -> Option<[Row<N>; 2]> {
        match self.joint.as_ref()? {
            Joint::Fixed(v) => Some([at.resolved(*v), Row::splat(at.time.like(0.0))]),
            Joint::Circular(orbits) => {
                let (mut position, mut velocity) = (at.omega, at.omega);
                for (lane, orbit) in orbits.iter().enumerate() {
                    let [toward, rate] = orbit.around(at.time.lane(lane));
                    position.put(lane, row(toward));
                    velocity.put(lane, row(rate));
                }
                Some([at.resolved(position), at.resolved(velocity)])
            }
        }
    }

    /// Returns coefficient n of N from coefficient n of u and of ω. If u is on an orbit, all its
    /// coefficients up to n are needed.
    #[inline(always)]
    pub(in super::super) fn torque<M: SeriesSums<N = N>>(
        &self,
        s: M,
        n: usize,
        joint: &Vectors<N>,
        omega: Row<N>,
    ) -> Row<N> {
        let linear = self.coefficient(&self.torque, n, joint.rows.at(n), omega);
        if self.is_on_orbit() { linear + self.torque.products * s.others(joint, n) } else { linear }
    }

    /// Returns coefficient n of N/I, for u fixed in space.
    #[inline(always)]
    pub(in super::super) fn acceleration(&self, n: usize, joint: Row<N>, omega: Row<N>) -> Row<N> {
        self.coefficient(&self.acceleration, n, joint, omega)
    }

    #[inline(always)]
    fn coefficient(&self, of: &Coefficients<N>, n: usize, joint: Row<N>, omega: Row<N>) -> Row<N> {
        let mut sum = if n == 0 { of.constant } else { Row::splat(omega.0[0].like(0.0)) };
        if let Some(Joint::Fixed(_)) = self.joint {
            sum = sum + times(&of.of_joint, joint);
        }
        if self.has_omega {
            sum = sum + times(&of.of_omega, omega);
        }
        sum
    }
}

impl<N: Number> Coefficients<N> {
    fn put(&mut self, lane: usize, torque: &QuadraticTorque, row: impl Fn([f64; 3]) -> Row) {
        let QuadraticTorque { constant, of_joint, of_omega, products, .. } = torque;
        self.constant.put(lane, row(*constant));
        self.products.put(lane, row(*products));
        let columns = self.of_joint.iter_mut().zip(of_joint).chain(self.of_omega.iter_mut().zip(of_omega));
        columns.for_each(|(place, column)| place.put(lane, row(*column)));
    }
}
