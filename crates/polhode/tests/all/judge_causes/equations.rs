//! Mistakes in the equations of motion and in the quaternion.

use polhode::infer::judge::Cause;

use super::program::*;
use super::scene::*;

#[test]
fn no_gyroscopic_term() {
    let is_it = |cause: &Cause| *cause == Cause::NoGyroscopicTerm;
    require_named(&free(), &Equations { gyroscopic: 0.0, ..right() }.log(), 0.005, is_it);
    require_named(&driven(), &Equations { gyroscopic: 0.0, ..right_driven() }.log(), 0.005, is_it);
}

#[test]
fn omega_in_the_wrong_frame() {
    for (scenario, right) in [(free(), right()), (driven(), right_driven())] {
        let h = 0.005;
        let log = |turned: fn(Q, V) -> V| {
            run(start(), h, 10, 400, |t, q, w| {
                rk4(t, q, w, h, &|_, q, w| (turning(q, turned(q, w)), right.acceleration(q, w)))
            })
        };
        require_named(&scenario, &log(|q, w| to_body(unit(q), w)), h, |c| *c == Cause::OmegaBodyAsSpace);
        require_named(&scenario, &log(|q, w| to_space(unit(q), w)), h, |c| *c == Cause::OmegaSpaceAsBody);
    }
}

#[test]
fn quaternions_of_another_meaning() {
    let log = right().log();
    let with =
        |change: fn(Q) -> Q| -> Vec<(f64, Q, V)> { log.iter().map(|&(t, q, w)| (t, change(q), w)).collect() };
    require_named(&free(), &with(|[w, x, y, z]| [w, -x, -y, -z]), 0.005, |c| *c == Cause::ConjugateAttitude);
    require_named(&free(), &with(|[w, x, y, z]| [x, y, z, w]), 0.005, |c| *c == Cause::ScalarLast);
}
