use polhode::*;
use std::hint::black_box;
fn main() {
    let o = [0.3, 0.5, 0.9];
    let b: Vec<_> = (0..64)
        .map(|k| {
            FreeMotion::of_moments(
                [1.0, 2.0, 3.0],
                State {
                    time: 0.0,
                    attitude: Attitude::identity(),
                    omega: AngularVelocity::from_array(o.map(|w| w * (1.0 + 1e-4 * k as f64))),
                },
            )
            .unwrap()
        })
        .collect();
    let all = FreeMotions::of(&b);
    let mut s = all.at(1.0);
    for k in 0..2000000 {
        all.fill(black_box(k as f64), black_box(&mut s));
    }
}
