use polhode::*;
use std::hint::black_box;
fn main() {
    let start = State {
        time: 0.0,
        attitude: Attitude::identity(),
        omega: AngularVelocity::from_array([0.3, 0.5, 0.9]),
    };
    let m = FreeMotion::of_moments([1.0, 2.0, 3.0], start).unwrap();
    let times: Vec<f64> = (0..1024).map(|k| k as f64 * 0.977 + 0.1).collect();
    let mut s = m.at_times(&times);
    for _ in 0..200000 {
        m.fill(black_box(&times), black_box(&mut s));
    }
}
