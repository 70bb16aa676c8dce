use polhode::*;
use std::time::Instant;
fn main() {
    // B: heavy top
    let inertia = InertiaTensor::diagonal([0.75, 0.75, 0.5]).unwrap();
    // about pivot 1,1,0.5: m l^2 = 0.25, m g l = 1
    let body = MassProperties::new(1.0, Position::new(0.0,0.0,0.5), inertia).unwrap();
    let rotor = Rotor::pivoted(&body, Position::ZERO);
    let g = TorqueModel::Gravity(UniformGravity{acceleration: Acceleration::new(0.0,0.0,-2.0)});
    let c = (30f64).to_radians();
    let start = State{time:0.0, attitude: Attitude::from_quaternion([c.cos(), c.sin(),0.0,0.0]).unwrap(), omega: AngularVelocity::new(0.0,0.0,5.0)};
    for (name, method) in [("taylor", Method::Taylor), ("dop853", Method::Dop853)] {
        for tol in [1e-6,1e-9,1e-12, 1e-13,1e-14,1e-15] {
            let mut best = f64::INFINITY; let mut last=None;
            for _ in 0..30 { let t=Instant::now(); let m = Trajectory::compute(&rotor, &[g], start, &[100.0], method, tol); best=best.min(t.elapsed().as_secs_f64()); last=Some(m); }
            match last.unwrap() { Ok(m)=>{ let s=&m.samples()[0]; let Solution::Integrated{statistics,..}=m.solution() else {panic!()};
               println!("{name} {tol:e} {:.3} ms  steps {} {:.3} us/step q {:?} drift {:e}", best*1e3, statistics.accepted, best*1e6/statistics.accepted as f64, s.state.attitude.quaternion(), (s.kinetic_energy+s.potential_energy.unwrap())/(m.start().kinetic_energy+m.start().potential_energy.unwrap())-1.0);}
              Err(e)=>println!("{name} {tol:e} {e:?}") }
        }
    }
}
