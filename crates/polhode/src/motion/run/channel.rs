//! Channels: named quantities of the samples of a trajectory.

use core::fmt;

use super::sample::Sample;
use crate::math::frame::Body;
use crate::math::vector::Torque;
use crate::motion::contact::ContactState;
use crate::motion::gimbal::GimbalState;
use crate::motion::model::energy::Energy;
use crate::motion::model::state::State;

/// State of the ground contact or of the gimbals, at one sample.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::motion) enum Reading {
    Contact(ContactState),
    Gimbals(GimbalState),
}

impl Reading {
    /// Returns time, attitude and ω.
    pub(super) const fn state(&self) -> State {
        match self {
            Self::Contact(contact) => contact.state,
            Self::Gimbals(gimbals) => gimbals.state,
        }
    }

    /// Returns the torque on the body, about the reference point of its rotor, body axes, N·m.
    pub(super) const fn torque(&self) -> Torque<Body> {
        match self {
            Self::Contact(contact) => contact.torque,
            Self::Gimbals(gimbals) => gimbals.torque,
        }
    }

    /// Replaces the state by an equal one whose quaternion may have the other sign.
    pub(super) const fn put_state(&mut self, state: State) {
        match self {
            Self::Contact(contact) => contact.state = state,
            Self::Gimbals(gimbals) => gimbals.state = state,
        }
    }
}

/// Sample, with the state of the contact or of the gimbals if there is one.
#[derive(Clone, Copy, Debug)]
pub(in crate::motion) struct Row<'a> {
    pub(in crate::motion) sample: &'a Sample,
    pub(in crate::motion) reading: Option<&'a Reading>,
}

impl<'a> Row<'a> {
    pub(in crate::motion) const fn contact(self) -> Option<&'a ContactState> {
        match self.reading {
            Some(Reading::Contact(state)) => Some(state),
            _ => None,
        }
    }

    pub(in crate::motion) const fn gimbals(self) -> Option<&'a GimbalState> {
        match self.reading {
            Some(Reading::Gimbals(state)) => Some(state),
            _ => None,
        }
    }

    /// Returns energy and work of the system.
    pub(in crate::motion) fn energy(self) -> Energy {
        match (self.reading, self.sample) {
            (Some(Reading::Contact(state)), _) => state.energy(),
            (Some(Reading::Gimbals(state)), _) => state.energy(),
            (None, &Sample { kinetic_energy, potential_energy, work, .. }) => {
                Energy { kinetic: kinetic_energy, potential: potential_energy, work }
            }
        }
    }

    /// Returns the energy minus the works that account for its change, J, and the sum of the
    /// absolute values of all terms. For a rotor, the work of torques includes that of torques with
    /// a potential.
    pub(in crate::motion) fn balance(self) -> [f64; 2] {
        match (self.reading, self.sample) {
            (Some(Reading::Contact(state)), _) => [state.balance(), state.size_of_balance()],
            (Some(Reading::Gimbals(state)), _) => [state.balance(), state.size_of_balance()],
            (None, &Sample { kinetic_energy, work, .. }) => {
                [kinetic_energy - work, kinetic_energy.abs() + work.abs()]
            }
        }
    }
}

/// Named quantity of the samples of a trajectory, available for some systems only.
///
/// [`polhode::motion::channel`](crate::motion::channel) lists the channels. A scalar channel is one
/// column of a table.
///
/// ```
/// use polhode::motion::channel;
/// use polhode::motion::contact::{BodySurface, Contact, ContactStart, SurfaceShape};
/// use polhode::prelude::*;
/// // A ball that rolls on level ground, which carries its weight.
/// let ball = MassProperties::new(2.0, Position::ZERO, InertiaTensor::diagonal([0.008; 3])?)?;
/// let surface = BodySurface::new(SurfaceShape::Sphere { radius: 0.1 }, Position::ZERO, Rotation::identity())?;
/// let omega = AngularVelocity::new(0.0, 3.0, 0.0);
/// let start = ContactStart::rolling(State { time: 0.0, attitude: Attitude::identity(), omega });
/// let motion = Simulation::on_ground(&ball, &Contact::rolling(surface), start, &[2.0]).run()?;
/// let force = motion.channel(channel::NORMAL_FORCE).ok_or("it touches the ground")?;
/// assert_eq!((channel::NORMAL_FORCE.name(), channel::NORMAL_FORCE.unit()), ("normal_force_n", "N"));
/// assert!((force.start() - 2.0 * 9.80665).abs() < 1e-13);
/// assert!(motion.channel(channel::AXIS_ANGLES).is_none()); // a rotor in gimbals has these
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Channel<T> {
    name: &'static str,
    unit: &'static str,
    description: &'static str,
    of: fn(Row<'_>) -> Option<T>,
}

impl<T> Clone for Channel<T> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<T> Copy for Channel<T> {}

impl<T> fmt::Debug for Channel<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Channel").field(&self.name).finish()
    }
}

impl<T> Channel<T> {
    pub(in crate::motion) const fn new(
        name: &'static str,
        unit: &'static str,
        description: &'static str,
        of: fn(Row<'_>) -> Option<T>,
    ) -> Self {
        Self { name, unit, description, of }
    }

    /// Returns the name; for a scalar it has the unit as suffix.
    pub const fn name(&self) -> &'static str {
        self.name
    }

    /// Returns the unit in SI symbols: `1` for a pure number, empty for a record of several
    /// quantities.
    pub const fn unit(&self) -> &'static str {
        self.unit
    }

    /// Returns a short description.
    pub const fn description(&self) -> &'static str {
        self.description
    }

    pub(in crate::motion) fn read(&self, row: Row<'_>) -> Option<T> {
        (self.of)(row)
    }
}

/// Values of a channel at the start of a trajectory, and at each of its samples.
#[derive(Clone, Copy, Debug)]
pub struct Series<'a, T> {
    start: T,
    channel: Channel<T>,
    samples: &'a [Sample],
    readings: &'a [Reading],
}

impl<'a, T: Copy> Series<'a, T> {
    /// Returns the series of a channel; `None` if the system does not have it.
    pub(super) fn of(
        channel: Channel<T>,
        start: Row<'_>,
        samples: &'a [Sample],
        readings: &'a [Reading],
    ) -> Option<Self> {
        Some(Self { start: channel.read(start)?, channel, samples, readings })
    }

    /// Returns the value at the start, which need not be a sample.
    pub const fn start(&self) -> T {
        self.start
    }

    /// Returns the value at a sample, counted from 0.
    pub fn get(&self, sample: usize) -> Option<T> {
        let row = Row { sample: self.samples.get(sample)?, reading: self.readings.get(sample) };
        self.channel.read(row)
    }

    /// Returns the value at the first sample.
    pub fn first(&self) -> Option<T> {
        self.get(0)
    }

    /// Returns the value at the last sample.
    pub fn last(&self) -> Option<T> {
        self.get(self.samples.len().checked_sub(1)?)
    }

    /// Returns the values at all samples, in their order.
    pub fn iter(self) -> impl Iterator<Item = T> + 'a
    where
        T: 'a,
    {
        (0..self.samples.len()).filter_map(move |sample| self.get(sample))
    }
}
