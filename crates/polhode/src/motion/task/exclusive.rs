//! Parts of a scenario that exclude each other.

use super::scenario::Scenario;

impl Scenario {
    /// Pairs of parts that exclude each other, by their names in scenario files, with the reason.
    pub const EXCLUSIVE: [(&'static str, &'static str, &'static str); 31] = [
        ("contact", "orbit", "a body on the ground is not in orbit"),
        ("contact", "shaft", SHAFT),
        (
            "contact",
            "prescribed",
            "the torque of a prescribed motion is computed for a body that is free or held at a point",
        ),
        ("contact", "torque", "only gravity and the contact force act on a body on the ground"),
        ("contact", "pendulum", "a pendulum hangs, and touches no ground"),
        ("contact", "wheel", "a rolling body is one rigid body"),
        ("contact", "mass_history", "a rolling body is one rigid body of constant mass"),
        ("gimbals", "contact", "a rotor hangs in its gimbals, and touches no ground"),
        ("gimbals", "orbit", "gimbals are carried by their base, at rest or rotating"),
        ("gimbals", "shaft", SHAFT),
        (
            "gimbals",
            "prescribed",
            "the torque of a prescribed motion is computed for a body that is free or held at a point",
        ),
        (
            "gimbals",
            "torque",
            "only gravity and torques about the three gimbal axes act on a rotor in gimbals",
        ),
        ("gimbals", "pendulum", "a pendulum hangs from one axis"),
        ("gimbals", "wheel", "the rotor is one rigid body"),
        ("gimbals", "mass_history", "the rotor is one rigid body of constant mass"),
        (
            "gimbals",
            "event",
            "events are available for bodies that are free, held at a point or on the ground",
        ),
        ("orbit", "shaft", ORBIT),
        ("prescribed", "torque", "the torque of a prescribed motion is computed, not given"),
        ("prescribed", "event", "events do not change a prescribed motion"),
        ("prescribed", "pendulum", "gravity alone moves a pendulum"),
        ("prescribed", "wheel", "the torque of a prescribed motion is computed for a body without wheels"),
        ("pendulum", "wheel", "a pendulum swings as a body without wheels"),
        ("shaft", "prescribed", SHAFT),
        ("shaft", "torque", SHAFT),
        ("shaft", "wheel", SHAFT),
        ("shaft", "event", SHAFT),
        ("shaft", "pendulum", SHAFT),
        ("mass_history", "shaft", SHAFT),
        ("mass_history", "prescribed", "the torque of a prescribed motion needs constant mass properties"),
        ("mass_history", "pendulum", "a pendulum needs constant mass properties"),
        ("mass_history", "wheel", "the mass properties of a changing body without its wheels are unknown"),
    ];
}

const SHAFT: &str = "a shaft rotates at its given rate, and its torque and reactions are computed";

const ORBIT: &str = "a body in orbit is in free fall: its weight does not load the bearings";
