//! Common data of the steps, computed once.

use std::borrow::Cow;
use std::f64::consts::TAU;

use polhode::body::{Finding, MassProperties, Particle};
use polhode::math::{
    AngularAcceleration, AngularVelocity, Body, Direction, Position, Space, Torque, Velocity,
};
use polhode::motion::channel::CONTACT;
use polhode::motion::contact::{ContactStart, ContactState};
use polhode::motion::torque::TorqueModel;
use polhode::motion::{
    Ending, ErrorEffort, GlobalError, Mechanism, MotionError, MovingParticle, Pendulum, Required, Rotor,
    Scenario, Simulation, State, StateError, Swing, Trajectory, rigid_velocity,
};
use polhode_document::number::{alike, number, tidy_beside};

use super::rows::Rows;
use crate::report::free_facts::FreeFacts;
use crate::report::motion;
use crate::symbolic::Exact;

/// Initial state, and the computed motion if there is one.
pub(crate) struct Working<'a> {
    pub scenario: &'a Scenario,
    pub rotor: &'a Rotor,
    pub start: State,
    /// Torque at t0, N·m, body axes; for a prescribed motion the required torque.
    pub torque: Torque<Body>,
    /// Angular acceleration dω/dt at t0, body axes.
    pub acceleration: AngularAcceleration<Body>,
    /// Torque required for a prescribed motion; `None` for other motions.
    pub needed: Option<Required>,
    pub pendulum: Option<Pendulum>,
    /// Free motion from the same initial state.
    pub at_start: Option<FreeFacts>,
    /// Contact at t0 of a body on the ground.
    pub contact: Option<ContactState>,
    /// Computed motion; `None` without a run.
    pub trajectory: Option<Cow<'a, Trajectory>>,
    /// Exact formulas of the file.
    pub exact: &'a Exact,
    /// Rows of the table in step 5; empty without a run, or on the ground.
    pub rows: Rows,
}

impl<'a> Working<'a> {
    /// Returns the findings about the scenario, and about its motion if that is known.
    pub(crate) fn findings(&self) -> Vec<Finding> {
        match self.trajectory.as_deref() {
            Some(trajectory) => motion::findings(self.scenario, trajectory),
            None => self.scenario.findings().to_vec(),
        }
    }

    pub(crate) fn of(scenario: &'a Scenario) -> Result<Self, MotionError> {
        if matches!(scenario.mechanism(), Mechanism::Gimbals(_)) {
            return Self::with(scenario, None);
        }
        let trajectory = match scenario.simulate_with_error(ErrorEffort::Auto, &mut |_| true) {
            // A point mass has no rotation to compute, but the other steps apply.
            None | Some(Err(MotionError::NotSpinnable)) => None,
            Some(result) => Some(Cow::Owned(result?)),
        };
        // A motion that fails gives no solution here; callers that have its trajectory use
        // `explain_motion`. For a body on the ground the formulas are shown anyway.
        if scenario.ground().is_none()
            && let Some(Ending::Failed { cause, .. }) = trajectory.as_deref().map(Trajectory::ending)
        {
            return Err(cause.clone());
        }
        Self::with(scenario, trajectory)
    }

    /// Returns the working of a scenario whose motion is known.
    ///
    /// It does the same as [`Working::of`] otherwise.
    pub(crate) fn with(
        scenario: &'a Scenario,
        trajectory: Option<Cow<'a, Trajectory>>,
    ) -> Result<Self, MotionError> {
        if scenario.history().is_some() {
            let (time, why) = (
                scenario.start().time,
                "has no worked solution: worked solutions need constant mass properties",
            );
            return Err(MotionError::MassHistory { time, why });
        }
        if matches!(scenario.mechanism(), Mechanism::Gimbals(_)) {
            let why = "worked solutions cover bodies that are free or held at a point";
            return Err(MotionError::InGimbals { why });
        }
        let rotor = scenario.rotor();
        let pendulum = scenario.pendulum().transpose()?;
        let needed = scenario
            .prescribed()
            .map(|motion| Required::of_motion(rotor, motion, scenario.start().time))
            .transpose()?;
        let start = needed.map_or(scenario.start(), |needed| needed.state);
        let contact = touching(scenario, trajectory.as_deref())?;
        let given = || acting(scenario).fold(Torque::ZERO, |sum, model| sum + model.torque(rotor, &start));
        let torque = needed.map_or_else(given, |needed| needed.torque);
        let torque = contact.map_or(torque, |contact| contact.torque);
        let acceleration =
            needed.map_or_else(|| rotor.acceleration(start.omega, torque), |needed| needed.acceleration);
        let at_start = FreeFacts::from_start(rotor, start);
        let rows = match trajectory.as_deref().filter(|_| scenario.ground().is_none()) {
            Some(trajectory) => {
                Rows::of(scenario, trajectory, period(scenario, pendulum.as_ref(), at_start.as_ref()))?
            }
            None => Rows::default(),
        };
        Ok(Self {
            scenario,
            rotor,
            start,
            torque,
            acceleration,
            needed,
            pendulum,
            at_start,
            contact,
            trajectory,
            exact: &Exact::None,
            rows,
        })
    }

    pub(crate) fn title(&self) -> String {
        self.scenario.title().map_or_else(|| "A rigid body".to_owned(), str::to_owned)
    }

    pub(crate) const fn body(&self) -> &MassProperties<Body> {
        self.scenario.body()
    }

    /// Returns the reference point: the pivot, or the centre of mass.
    pub(crate) fn point(&self) -> Position<Body> {
        self.scenario.pivot().unwrap_or(self.body().center_of_mass())
    }

    pub(crate) const fn point_name(&self) -> &'static str {
        if self.scenario.pivot().is_some() { "the pivot" } else { "the centre of mass" }
    }

    /// Returns true if no torque acts, no wheel spins, and the motion is not prescribed.
    pub(crate) fn is_free(&self) -> bool {
        self.scenario.is_free()
    }

    /// Returns true if there is internal friction, so that the axes rotate at Ω instead of ω.
    pub(crate) fn has_sink(&self) -> bool {
        self.scenario.torques().iter().any(|torque| matches!(torque, TorqueModel::EnergySink(_)))
    }

    pub(crate) fn is_turning(&self) -> bool {
        self.start.omega.norm() > 0.0
    }

    /// Returns the velocity of the centre of mass at t0, m/s.
    pub(crate) fn center_velocity(&self) -> Velocity<Space> {
        if self.scenario.pivot().is_some() {
            self.start.attitude * self.start.omega.cross(self.rotor.lever())
        } else {
            self.scenario.velocity()
        }
    }

    /// Returns particles with the body's motion at t0; positions are relative to its centre of
    /// mass, space axes.
    ///
    /// These are the body's own particles if it consists of particles. Otherwise there is one for
    /// each part, at the part's centre of mass.
    pub(crate) fn moving_particles(&self) -> Vec<MovingParticle<Space>> {
        let at_parts =
            || self.scenario.parts().iter().map(|p| (p.properties.mass(), p.properties.center_of_mass()));
        let places: Vec<(f64, Position<Body>)> = if self.scenario.is_all_particles() {
            self.scenario.particles().iter().map(|p| (p.mass(), p.position())).collect()
        } else {
            at_parts().collect()
        };
        let attitude = self.start.attitude;
        let omega = attitude * self.start.omega;
        let velocity = self.center_velocity();
        let moving = |(mass, place): (f64, Position<Body>)| {
            let r = attitude * (place - self.body().center_of_mass());
            let particle = Particle::new(mass, r).ok()?;
            Some(MovingParticle { particle, velocity: rigid_velocity(velocity, omega, r) })
        };
        places.into_iter().filter_map(moving).collect()
    }

    /// Returns the estimated error at the end of the run: ω relative, attitude in rad; zero without
    /// an estimate.
    pub(crate) fn error(&self) -> StateError {
        let end = self.trajectory.as_deref().and_then(Trajectory::error).map(GlobalError::end);
        end.unwrap_or(StateError { attitude: 0.0, omega: 0.0 })
    }
}

/// Returns true if the body leaves the axis in a run, which holds the pivot only.
pub(crate) fn leaves(scenario: &Scenario, axis: Direction<Body>) -> bool {
    let axial = scenario.rotor().angular_momentum(AngularVelocity::from_array(axis.to_array()));
    let omega = scenario.start().omega;
    axial.angle_to(axis) > 1e-9 || omega.cross(axis).norm() > 1e-9 * omega.norm()
}

/// Returns the period of ω in the body, s, for a free motion or a pendulum under gravity alone.
fn period(scenario: &Scenario, pendulum: Option<&Pendulum>, at_start: Option<&FreeFacts>) -> Option<f64> {
    if scenario.is_free() {
        let free = at_start?;
        return match &free.top {
            Some((top, _)) => Some(TAU / top.body_rate().abs()).filter(|period| period.is_finite()),
            None => free.motion.period(),
        };
    }
    let axis = scenario.suspension()?.axis.direction()?;
    let is_gravity_alone = matches!(scenario.torques(), [TorqueModel::Gravity(_)]);
    let pendulum = pendulum.filter(|_| is_gravity_alone && !leaves(scenario, axis))?;
    match pendulum.swing(pendulum.angle(), axis.dot(scenario.start().omega)) {
        Swing::Oscillation { period, .. } | Swing::Revolution { period } => Some(period),
        Swing::Rest | Swing::Separatrix => None,
    }
}

/// Returns the contact of a body on the ground at t0.
fn touching(
    scenario: &Scenario,
    trajectory: Option<&Trajectory>,
) -> Result<Option<ContactState>, MotionError> {
    let Some(ground) = scenario.ground() else { return Ok(None) };
    if let Some(contact) = trajectory.and_then(|trajectory| trajectory.channel(CONTACT)) {
        return Ok(Some(contact.start()));
    }
    let start = ContactStart { state: scenario.start(), at: ground.at, velocity: ground.velocity };
    let motion = Simulation::on_ground(scenario.body(), &ground.contact, start, &[]).run()?;
    Ok(motion.channel(CONTACT).map(|contact| contact.start()))
}

/// Significant digits of a worked solution.
pub(crate) const DIGITS: usize = 6;

/// Formats a number with [`DIGITS`] significant digits.
pub(crate) fn n(x: f64) -> String {
    number(x, DIGITS)
}

/// Formats a number as a factor, with parentheses if it is negative.
pub(crate) fn factor(x: f64) -> String {
    if x < 0.0 { format!("({})", n(x)) } else { n(x) }
}

/// Formats a vector; components that are rounding errors are 0.
pub(crate) fn v(values: [f64; 3]) -> String {
    let scale = values.iter().fold(0.0, |max, x| f64::max(max, x.abs()));
    polhode_document::number::vector(tidy_beside(values, scale), DIGITS)
}

/// Formats a vector without rounding small components to 0.
pub(crate) fn exactly(values: [f64; 3]) -> String {
    polhode_document::number::vector(values, DIGITS)
}

/// Formats rows of numbers; the numbers of a column have the same format.
pub(crate) fn cells(rows: &[Vec<f64>]) -> Vec<Vec<String>> {
    let count = rows.first().map_or(0, Vec::len);
    let columns: Vec<Vec<String>> =
        (0..count).map(|k| alike(&rows.iter().map(|row| row[k]).collect::<Vec<_>>(), DIGITS)).collect();
    (0..rows.len()).map(|r| columns.iter().map(|column| column[r].clone()).collect()).collect()
}

/// Returns the torques that are switched on at the start.
pub(crate) fn acting(scenario: &Scenario) -> impl Iterator<Item = &TorqueModel> {
    let all = scenario.torques().iter().enumerate();
    all.filter(|(k, _)| !scenario.switched_off().contains(k)).map(|(_, torque)| torque)
}
