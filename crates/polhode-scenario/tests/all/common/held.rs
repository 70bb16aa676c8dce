//! Motion with the state of the contact or gimbals at each sample.

use core::ops::Deref;

use polhode::motion::{Channel, Trajectory};

/// Motion with the state of the contact or gimbals at each sample.
pub struct Held<T> {
    motion: Trajectory,
    start: T,
    samples: Vec<T>,
}

impl<T: Copy> Held<T> {
    pub fn of(motion: Trajectory, channel: Channel<T>) -> Self {
        let states = motion.channel(channel).unwrap();
        let (start, samples) = (states.start(), states.iter().collect());
        Self { motion, start, samples }
    }

    pub fn start(&self) -> &T {
        &self.start
    }

    pub fn samples(&self) -> &[T] {
        &self.samples
    }
}

impl<T> Deref for Held<T> {
    type Target = Trajectory;

    fn deref(&self) -> &Trajectory {
        &self.motion
    }
}
