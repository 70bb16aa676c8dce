//! Wrong torques, damping and limits.

use polhode::infer::judge::Cause;
use polhode::prelude::*;

use super::program::*;
use super::scene::*;

#[test]
fn wrong_torques() {
    fn reversed(q: Q) -> V {
        right_torque(q).map(|c| -c)
    }
    fn body_only(_: Q) -> V {
        BODY_TORQUE
    }
    fn body_as_space(q: Q) -> V {
        add(to_body(q, BODY_TORQUE), to_body(q, SPACE_TORQUE), 1.0)
    }
    fn larger(q: Q) -> V {
        right_torque(q).map(|c| 1.02 * c)
    }
    fn space_as_body(_: Q) -> V {
        SPACE_TORQUE
    }
    let log = |torque: fn(Q) -> V| Equations { torque, ..right() }.log();
    require_named(&driven(), &log(reversed), 0.005, |c| *c == Cause::TorqueReversed { torque: None });
    require_named(&driven(), &log(no_torque), 0.005, |c| *c == Cause::TorqueLeftOut { torque: None });
    require_named(&driven(), &log(body_only), 0.005, |c| {
        matches!(c, Cause::TorqueLeftOut { torque: Some(_) })
    });
    require_named(&driven(), &log(body_as_space), 0.005, |c| {
        matches!(c, Cause::TorqueBodyAsSpace { torque: Some(_) })
    });
    require_named(
        &driven(),
        &log(larger),
        0.005,
        |c| matches!(c, Cause::TorqueScaled { factor } if (factor - 1.02).abs() < 1e-6),
    );
    let space = TorqueModel::Constant(ConstantTorque::Space(Torque::from_array(SPACE_TORQUE)));
    let scenario = free().with_torques([space]).unwrap();
    require_named(&scenario, &log(space_as_body), 0.005, |c| *c == Cause::TorqueSpaceAsBody { torque: None });
}

#[test]
fn damping_and_limits() {
    for (scenario, right) in [(free(), right()), (driven(), right_driven())] {
        let log = Equations { damping: 0.05, ..right }.log();
        require_named(
            &scenario,
            &log,
            0.005,
            |c| matches!(c, Cause::Damping { rate } if (rate - 0.05).abs() < 1e-6),
        );
        let log = Equations { damping: 0.05, gyroscopic: 0.0, ..right }.log();
        require_named(
            &scenario,
            &log,
            0.005,
            |c| matches!(c, Cause::DampingWithoutGyroscopicTerm { rate } if (rate - 0.05).abs() < 1e-6),
        );
    }
    // A limit as in a game engine: at most 7 rad/s, for a body at 9 rad/s.
    let (q, w) = start();
    let w = w.map(|c| 4.5 * c);
    let scenario = free();
    let fast = State { omega: AngularVelocity::from_array(w), ..scenario.start() };
    let scenario = scenario.starting(fast).unwrap();
    let h = 0.001;
    let log = run((q, w), h, 20, 400, |t, q, w| {
        let cut = |w: V| if norm(w) > 7.0 { w.map(|c| c * 7.0 / norm(w)) } else { w };
        let (q, w) = rk4(t, q, cut(w), h, &|_, q, w| (turning(q, w), right().acceleration(q, w)));
        (q, cut(w))
    });
    require_named(
        &scenario,
        &log,
        h,
        |c| matches!(c, Cause::SpeedLimit { limit, gyroscopic: true } if (limit - 7.0).abs() < 1e-6),
    );
}

#[test]
fn gravity_the_wrong_way_and_wheels_left_out() {
    let top = free().held_at(Position::ZERO).unwrap();
    let top = top.with_torques([TorqueModel::Gravity(UniformGravity::STANDARD)]).unwrap();
    let [x, y, z] = CENTER;
    let r2 = x * x + y * y + z * z;
    let moved = |k: usize, l: usize| MASS * (if k == l { r2 } else { 0.0 } - CENTER[k] * CENTER[l]);
    let about = [0, 1, 2].map(|k| [0, 1, 2].map(|l| right().tensor[k][l] + moved(k, l)));
    fn upward(q: Q) -> V {
        cross(CENTER, to_body(q, [0.0, 0.0, 9.80665 * MASS]))
    }
    let log = Equations { tensor: about, torque: upward, ..right() }.log();
    require_named(&top, &log, 0.005, |c| *c == Cause::TorqueReversed { torque: None });

    let motor = polhode::motion::Motor::HeldSpeed;
    let wheel = Wheel::new(Direction::new(0.3, -0.9, 0.4), 0.7, motor).unwrap();
    let scenario = free().with_wheels(&[wheel]).unwrap();
    require_named(&scenario, &right().log(), 0.005, |c| *c == Cause::WheelsLeftOut);
}
