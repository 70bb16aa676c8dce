//! Step 1: the axes.

use polhode::math::Attitude;
use polhode_document::Section;

use super::working::{Working, v};

pub(crate) fn section(w: &Working<'_>) -> Section {
    let mut s = Section::new(1, "Choose the axes");
    s.say(
        "Body axes x, y, z: fixed in the body, so that {I} is constant; they turn with it at ω. Their directions are those of the input file. Step 3 finds the principal axes 1, 2, 3, from the least moment to the greatest; along them Euler's equations are simplest.",
    );
    match w.scenario.pivot() {
        Some(pivot) => {
            s.say(
                "Origin: the pivot, which is held fixed in space, so V = 0 and the force at the pivot has no torque about it. Inertia, L, T and N below are about the pivot.",
            );
            s.line(format!("pivot          p = {} m", v(pivot.to_array())));
            s.line(format!("to the centre  l = c - p = {} m", v(w.rotor.lever().to_array())));
        }
        None => {
            s.say(
                "Origin: the centre of mass. The body is not held, so the motion of the centre of mass and the rotation about it are independent (step 2 shows why). Inertia, L, T and N below are about the centre of mass.",
            );
            s.line(format!("origin  c = {} m", v(w.body().center_of_mass().to_array())));
        }
    }
    if w.start.attitude == Attitude::identity() {
        s.say("At t0 the body axes are parallel to the space axes: R(t0) = 1.");
    } else {
        s.say("At t0 the attitude is R(t0), with the body axes x, y, z in space axes as columns: a_space = R\u{a0}a_body.");
        s.matrix("R(t0)", w.start.attitude.matrix(), "");
    }
    s
}
