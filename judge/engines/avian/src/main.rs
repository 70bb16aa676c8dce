//! Computes the motions of the suite's cases with Avian: `avian-run DIR --setting default|fine`.
//!
//! The body has no colliders, and its velocities are in space axes. Mass, centre of mass and
//! inertia are f32 in Avian, even if the motion is f64. A held body is on a spherical joint to a
//! static body. `ConstantTorque` is set again before each step.

#[path = "../../rapier/src/case.rs"]
mod case;
#[path = "../../rapier/src/run.rs"]
mod run;

use avian3d::{math::*, prelude::*};
use bevy::{prelude::*, time::TimeUpdateStrategy};
use case::{Case, Row, apply, cross, matrix, principal, transposed};
use std::time::Duration;

#[cfg(feature = "f64")]
const SETTINGS: [run::Setting; 2] =
    [("default", "Avian 0.7.0, f64", 1.0 / 64.0), ("fine", "Avian 0.7.0, f64", 0.001)];
#[cfg(not(feature = "f64"))]
const SETTINGS: [run::Setting; 2] =
    [("default", "Avian 0.7.0, f32", 1.0 / 64.0), ("fine", "Avian 0.7.0, f32", 0.001)];

fn vector(v: [f64; 3]) -> Vector {
    Vector::new(v[0] as Scalar, v[1] as Scalar, v[2] as Scalar)
}

fn single(v: [f64; 3]) -> Vec3 {
    Vec3::new(v[0] as f32, v[1] as f32, v[2] as f32)
}

fn row(time: f64, world: &World, body: Entity) -> Option<Row> {
    let (q, w) = (world.get::<Rotation>(body)?.0, world.get::<AngularVelocity>(body)?.0);
    let attitude = [q.w as f64, q.x as f64, q.y as f64, q.z as f64];
    let omega_body = apply(transposed(matrix(attitude)), [w.x as f64, w.y as f64, w.z as f64]);
    Some(Row { time, attitude, omega_body })
}

fn motion(case: &Case, step: f64) -> Result<Vec<Row>, String> {
    let mut app = App::new();
    app.add_plugins((MinimalPlugins, TransformPlugin, PhysicsPlugins::default()))
        .insert_resource(Gravity(vector(case.gravity.unwrap_or_default())))
        .insert_resource(Time::<Fixed>::from_duration(Duration::from_secs_f64(step)))
        .insert_resource(TimeUpdateStrategy::ManualDuration(Duration::from_secs_f64(step)));
    app.finish();
    app.cleanup();
    let [w, x, y, z] = case.attitude.map(|c| c as Scalar);
    let r = matrix(case.attitude);
    let omega = apply(r, case.omega_body);
    let (moments, axes) = principal(case.inertia);
    let frame = Mat3::from_cols(single(axes[0]), single(axes[1]), single(axes[2]));
    let world = app.world_mut();
    let body = world
        .spawn((
            RigidBody::Dynamic,
            (Position(Vector::ZERO), Rotation(Quaternion::from_xyzw(x, y, z, w))),
            AngularVelocity(vector(omega)),
            LinearVelocity(vector(cross(omega, apply(r, case.center_of_mass)))),
            (Mass(case.mass as f32), NoAutoMass),
            (CenterOfMass(single(case.center_of_mass)), NoAutoCenterOfMass),
            AngularInertia::new_with_local_frame(single(moments), Quat::from_mat3(&frame).normalize()),
            NoAutoAngularInertia,
            ConstantTorque(Vector::ZERO),
            SleepingDisabled,
        ))
        .id();
    if case.gravity.is_some() {
        let fixed = world.spawn((RigidBody::Static, Position(Vector::ZERO))).id();
        world.spawn(SphericalJoint::new(fixed, body));
    }
    let missing = "a component of the body is missing";
    let (count, stride) = case.steps(step);
    let mut rows = vec![row(0.0, app.world(), body).ok_or(missing)?];
    let mut done = 0;
    while done < count {
        let now = row(done as f64 * step, app.world(), body).ok_or(missing)?;
        let torque = case.torque_space(now.time, now.attitude, now.omega_body);
        app.world_mut().get_mut::<ConstantTorque>(body).ok_or(missing)?.0 = vector(torque);
        app.update();
        // The first update takes no step.
        let steps = (app.world().resource::<Time<Fixed>>().elapsed_secs_f64() / step).round() as usize;
        if steps > done && steps % stride == 0 {
            rows.push(row(steps as f64 * step, app.world(), body).ok_or(missing)?);
        }
        done = steps;
    }
    Ok(rows)
}

fn main() -> std::result::Result<(), Box<dyn std::error::Error>> {
    run::run(&SETTINGS, |case, _, step| motion(case, step))
}
