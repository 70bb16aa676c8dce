//! Computes the motions of the suite's cases with Rapier:
//! `rapier-run DIR --setting default|f64|fine`.
//!
//! The body has no colliders. Its angular velocity is in space axes, and its linear velocity is
//! that of its centre of mass. A held body is on a spherical joint to a fixed one: an impulse
//! joint, or with `fine` a multibody joint without its default damping. A torque acts until it is
//! reset. `MassProperties::with_inertia_matrix` is not used, because it gives a different tensor if
//! two moments are equal.

mod case;
mod run;

const SETTINGS: [run::Setting; 3] = [
    ("default", "Rapier 0.36.1, f32", 1.0 / 60.0),
    ("f64", "Rapier 0.36.1, f64", 1.0 / 60.0),
    ("fine", "Rapier 0.36.1, f64, multibody joints", 0.001),
];

/// Defines a module for Rapier in one precision.
macro_rules! engine {
    ($name:ident, $rapier:ident, $real:ty) => {
        mod $name {
            use crate::case::{Case, Row, apply, cross, matrix, principal, transposed};
            use $rapier::prelude::*;

            fn vector(v: [f64; 3]) -> Vector {
                Vector::new(v[0] as $real, v[1] as $real, v[2] as $real)
            }

            fn array(v: Vector) -> [f64; 3] {
                [v.x.into(), v.y.into(), v.z.into()]
            }

            fn row(time: f64, body: &RigidBody) -> Row {
                let q = body.rotation();
                let attitude = [q.w.into(), q.x.into(), q.y.into(), q.z.into()];
                Row { time, attitude, omega_body: apply(transposed(matrix(attitude)), array(body.angvel())) }
            }

            pub fn run(case: &Case, reduced: bool, step: f64) -> Result<Vec<Row>, String> {
                let mut world = PhysicsWorld::default();
                world.gravity = vector(case.gravity.unwrap_or_default());
                world.integration_parameters.dt = step as $real;
                let (moments, axes) = principal(case.inertia);
                let axes = Matrix::from_cols(vector(axes[0]), vector(axes[1]), vector(axes[2]));
                let [w, x, y, z] = case.attitude.map(|c| c as $real);
                let rotation = Rotation::from_xyzw(x, y, z, w);
                let r = matrix(case.attitude);
                let omega = apply(r, case.omega_body);
                let handle = world.insert_body(
                    RigidBodyBuilder::dynamic()
                        .pose(Pose::from_parts(Vector::ZERO, rotation))
                        .angvel(vector(omega))
                        .linvel(vector(cross(omega, apply(r, case.center_of_mass))))
                        .additional_mass_properties(MassProperties::with_principal_inertia_frame(
                            vector(case.center_of_mass),
                            case.mass as $real,
                            vector(moments),
                            Rotation::from_mat3(&axes).normalize(),
                        ))
                        .can_sleep(false),
                );
                if case.gravity.is_some() {
                    let fixed = world.insert_body(RigidBodyBuilder::fixed());
                    let joint =
                        SphericalJointBuilder::new().local_frame1(Pose::from_parts(Vector::ZERO, rotation));
                    if reduced {
                        // The joint's coordinates begin at zero, and its velocity is in the axes of
                        // the first frame.
                        world.insert_multibody_joint(fixed, handle, joint);
                        let link = world.multibody_joints.rigid_body_link(handle).map(|link| link.multibody);
                        if let Some(multibody) =
                            link.and_then(|link| world.multibody_joints.get_multibody_mut(link))
                        {
                            multibody.damping_mut().fill(0.0);
                            let mut velocity = multibody.generalized_velocity_mut();
                            let first = velocity.len() - 3;
                            (0..3).for_each(|i| velocity[first + i] = case.omega_body[i] as $real);
                        }
                    } else {
                        world.insert_impulse_joint(fixed, handle, joint);
                    }
                }
                let (count, stride) = case.steps(step);
                let mut rows = vec![row(0.0, &world.bodies[handle])];
                for n in 1..=count {
                    let body = &mut world.bodies[handle];
                    let now = row((n - 1) as f64 * step, body);
                    body.reset_torques(false);
                    body.add_torque(vector(case.torque_space(now.time, now.attitude, now.omega_body)), true);
                    world.step();
                    if n % stride == 0 {
                        rows.push(row(n as f64 * step, &world.bodies[handle]));
                    }
                }
                Ok(rows)
            }
        }
    };
}

engine!(single, rapier3d, f32);
engine!(double, rapier3d_f64, f64);

fn main() -> Result<(), Box<dyn std::error::Error>> {
    run::run(&SETTINGS, |case, setting, step| match setting {
        "default" => single::run(case, false, step),
        _ => double::run(case, setting == "fine", step),
    })
}
