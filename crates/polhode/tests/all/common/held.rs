//! A motion with the state of the mechanism at each sample.

use core::ops::Deref;

use polhode::motion::{Channel, Trajectory};

/// A motion with the state of the mechanism that supports the body at each sample.
pub(crate) struct Held<T> {
    motion: Trajectory,
    start: T,
    samples: Vec<T>,
}

impl<T: Copy> Held<T> {
    pub(crate) fn of(motion: Trajectory, channel: Channel<T>) -> Self {
        let states = motion.channel(channel).unwrap();
        let (start, samples) = (states.start(), states.iter().collect());
        Self { motion, start, samples }
    }

    pub(crate) fn start(&self) -> &T {
        &self.start
    }

    pub(crate) fn samples(&self) -> &[T] {
        &self.samples
    }
}

impl<T> Deref for Held<T> {
    type Target = Trajectory;

    fn deref(&self) -> &Trajectory {
        &self.motion
    }
}
