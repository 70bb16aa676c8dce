//! Payloads.

mod statistics;
mod wrist;

use polhode_identify::payload::{PayloadLog, WrenchNoise, WrenchSense, identify_payload};

use statistics::{Statistics, bound};
use wrist::{Carried, Course, noisy, rows};

const SENSE: WrenchSense = WrenchSense::OnPayload;
const FORCE: f64 = 0.1;
const TORQUE: f64 = 0.01;
const KNOWN: WrenchNoise = WrenchNoise::Deviations { force: FORCE, torque: TORQUE };

#[test]
fn probe() {
    let draws = std::env::var("DRAWS").map_or(100, |d| d.parse().unwrap());
    for (name, carried) in [("generic", Carried::generic()), ("plate", Carried::plate()), ("rod", Carried::rod())] {
        for noise in [KNOWN, WrenchNoise::Unknown] {
            let exact = rows(&carried, Course::Generic(1.0), 150, SENSE);
            let truth = carried.about_center();
            let limit = bound(&exact, FORCE, TORQUE, true, &truth);
            let mut all16 = truth.to_vec();
            all16.extend([0.0; 6]);
            let mut statistics = Statistics::new(16);
            let mut edge = Statistics::new(16);
            let mut interior = Statistics::new(16);
            let (mut impossible, mut large) = (0, 0);
            let t = std::time::Instant::now();
            for seed in 0..draws {
                let log = PayloadLog::new(noisy(&exact, FORCE, TORQUE, seed), SENSE)
                    .unwrap().with_bias().with_noise(noise).unwrap();
                let found = identify_payload(&log).unwrap();
                assert!(found.body.is_some());
                statistics.add(&found.about_center, &all16);
                if let Some(e) = &found.edge {
                    edge.add(e.along.as_ref().unwrap(), &all16);
                } else { interior.add(&found.about_center, &all16); }
                impossible += usize::from(!found.unconstrained.is_possible);
                large += usize::from(found.tests.iter().any(|t| t.widening() > 1.0));
            }
            println!("{name} {noise:?}: {:?}\n bias {} draws {:?} said {:?} nees {} | impossible {impossible} large {large} edges {} nees {} bias {} interior nees {}", t.elapsed(),
                statistics.bias(), statistics.of_draws(&limit), statistics.of_said(&limit), statistics.normalised(), edge.draws(), edge.normalised(), edge.bias(), interior.normalised());
            println!(" sd/size {:?}", (0..10).map(|k| limit[k] / truth[4].abs()).collect::<Vec<_>>());
        }
    }
}
