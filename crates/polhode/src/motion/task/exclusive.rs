//! Parts of a scenario that exclude each other.

use super::scenario::Scenario;

impl Scenario {
    /// Pairs of parts that exclude each other, by their names in scenario files, with the reason.
    pub const EXCLUSIVE: [(&'static str, &'static str, &'static str); 31] = [
        ("contact", "orbit", "a body on the ground is on no orbit"),
        ("contact", "shaft", SHAFT),
        (
            "contact",
            "prescribed",
            "the torque that a prescribed motion needs is that of a body that is free or held at a point",
        ),
        (
            "contact",
            "torque",
            "the forces at the point of contact and gravity are all that acts on a body on the ground",
        ),
        ("contact", "pendulum", "a pendulum hangs, and touches no ground"),
        ("contact", "wheel", "what rolls is one rigid body"),
        ("contact", "mass_history", "what rolls is one rigid body, whose mass stays as it is"),
        ("gimbals", "contact", "a rotor hangs in its gimbals, and touches no ground"),
        ("gimbals", "orbit", "what carries the gimbals is their base, at rest or turning"),
        ("gimbals", "shaft", SHAFT),
        (
            "gimbals",
            "prescribed",
            "the torque that a prescribed motion needs is that of a body that is free or held at a point",
        ),
        (
            "gimbals",
            "torque",
            "gravity and what acts about the three axes are all that turns a rotor in gimbals",
        ),
        ("gimbals", "pendulum", "a pendulum hangs from one axis"),
        ("gimbals", "wheel", "the rotor is one rigid body"),
        ("gimbals", "mass_history", "the rotor is one rigid body, whose mass stays as it is"),
        (
            "gimbals",
            "event",
            "events are looked for in the motion of bodies that are free, held at a point or on the ground",
        ),
        ("orbit", "shaft", ORBIT),
        ("prescribed", "torque", "a prescribed motion is given, and the torque that it needs is the answer"),
        ("prescribed", "event", "a prescribed motion is given, and nothing on its way changes it"),
        ("prescribed", "pendulum", "a pendulum swings as gravity moves it"),
        ("prescribed", "wheel", "the torque that a prescribed motion needs is that of a body without wheels"),
        ("pendulum", "wheel", "a pendulum swings as a body without wheels"),
        ("shaft", "prescribed", SHAFT),
        ("shaft", "torque", SHAFT),
        ("shaft", "wheel", SHAFT),
        ("shaft", "event", SHAFT),
        ("shaft", "pendulum", SHAFT),
        ("mass_history", "shaft", SHAFT),
        (
            "mass_history",
            "prescribed",
            "the torque that a prescribed motion needs is that of a body that stays as it is",
        ),
        ("mass_history", "pendulum", "a pendulum swings as a body that stays as it is"),
        ("mass_history", "wheel", "what is left of a changing body beside its wheels is not known"),
    ];
}

const SHAFT: &str = "a shaft turns at its rate, and what drives and holds it is the answer";

const ORBIT: &str = "a body on an orbit falls freely: no weight is on its bearings";
