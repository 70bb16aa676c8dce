//! Free motion in nanoseconds: one state, many states, the set-up. `cargo bench -p polhode --bench free_motion`

use std::hint::black_box;
use std::time::Instant;

use polhode::*;

/// The least time of many runs, ns per item.
fn best(items: usize, mut work: impl FnMut()) -> f64 {
    let mut least = f64::INFINITY;
    for _ in 0..2000 {
        let start = Instant::now();
        work();
        least = least.min(start.elapsed().as_secs_f64());
    }
    least / items as f64 * 1e9
}

fn main() {
    let start = |w: [f64; 3]| State {
        time: 0.0,
        attitude: Attitude::identity(),
        omega: AngularVelocity::from_array(w),
    };
    for (name, moments, omega) in [
        ("generic", [1.0, 2.0, 3.0], [0.3, 0.5, 0.9]),
        ("long axis", [1.0, 2.0, 3.0], [1.0, 0.2, 0.1]),
        ("near the separatrix", [1.0, 2.0, 3.0], [1e-6, 1.0, 1e-6]),
        ("symmetric", [1.0, 1.0, 2.0], [0.3, 0.5, 0.9]),
    ] {
        let motion = FreeMotion::of_moments(moments, start(omega)).expect("is a motion");
        let times: Vec<f64> = (0..1024).map(|k| f64::from(k) * 0.977 + 0.1).collect();
        let mut states = motion.at_times(&times);
        let one = best(times.len(), || {
            for (&t, s) in times.iter().zip(&mut states) {
                *s = motion.at(black_box(t));
            }
        });
        black_box(&states);
        let many = best(times.len(), || motion.fill(black_box(&times), black_box(&mut states)));
        let setup = best(100, || {
            for _ in 0..100 {
                black_box(FreeMotion::of_moments(black_box(moments), start(black_box(omega))).ok());
            }
        });
        println!("{name:20} one {one:6.1} ns   many {many:6.1} ns   set-up {setup:7.0} ns");
    }
}
