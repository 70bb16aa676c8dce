//! Many bodies. `cargo bench -p polhode --bench ensemble`.
use polhode::*;
use std::hint::black_box;
use std::num::NonZero;
use std::time::Instant;

fn least(items: usize, mut work: impl FnMut()) -> f64 {
    let mut least = f64::INFINITY;
    let begin = Instant::now();
    while begin.elapsed().as_secs_f64() < 0.5 {
        let start = Instant::now();
        work();
        least = least.min(start.elapsed().as_secs_f64());
    }
    least / items as f64 * 1e9
}
fn main() -> Result<(), Box<dyn std::error::Error>> {
    let inertia = InertiaTensor::with_negative_products([3.1, 4.2, 5.3], [0.4, -0.3, 0.2])?;
    let body = MassProperties::new(2.3, Position::new(0.11, -0.07, 0.23), inertia)?;
    let start = |k: usize| State {
        time: 0.0,
        attitude: Attitude::identity(),
        omega: AngularVelocity::new(0.3 + 1e-4 * k as f64, 0.5, 0.9),
    };
    let g = TorqueModel::Gravity(UniformGravity::STANDARD);
    let drag = TorqueModel::Drag(Drag::new(
        DragLaw::Quadratic,
        [[0.1, 0.0, 0.0], [0.0, 0.1, 0.0], [0.0, 0.0, 0.2]],
    )?);
    for (name, torques) in [
        ("free", vec![]),
        ("const", vec![TorqueModel::Constant(ConstantTorque::Body(Torque::new(0.1, 0.2, 0.3)))]),
        ("gravity", vec![g]),
        ("drag", vec![drag]),
    ] {
        let rotor =
            if name == "gravity" { Rotor::pivoted(&body, Position::ZERO) } else { Rotor::free(&body) };
        let members = (0..1024)
            .map(|k| Member { rotor: rotor.clone(), torques: torques.clone(), start: start(k) })
            .collect();
        let all = Ensemble::new(members)?;
        let mut states = vec![start(0); 1024];
        for threads in [1, 2] {
            let ns = least(1024 * 1000, || {
                black_box(
                    all.fill(
                        &[10.0],
                        Advance::RungeKutta4 { step: 0.01 },
                        NonZero::new(threads).unwrap(),
                        &mut states,
                        &mut |_| true,
                    )
                    .ok(),
                );
            });
            println!("{name} {threads}\t{:.1} M/s", 1e3 / ns);
        }
    }
    Ok(())
}
