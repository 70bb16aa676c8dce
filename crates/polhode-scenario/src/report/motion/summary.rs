//! `summary.json`.

use polhode::motion::channel::ENERGY;
use polhode::motion::torque::TorqueModel;
use polhode::motion::{
    Mechanism, Method, ParticleForce, Pendulum, Sample, Scenario, Solution, State, Swing, Trajectory, Wheel,
};
use polhode::observe::Drift;
use polhode_document::finding;
use polhode_document::json::{numbers, vector};
use polhode_shape::report::block;
use polhode_shape::report::block::Geometry;
use serde_json::{Map, Value, json};

use super::MotionReport;
use super::facts::{Facts, Needed, Top};
use crate::report::free_facts::FreeFacts;
use crate::report::torque::Description;
use crate::report::{
    VERSION, contact, event, gimbals, global_error, heavy_top, history, orbit, symmetric_top,
};

pub(crate) fn of(report: &MotionReport<'_>) -> Value {
    let (scenario, samples) = (report.scenario, report.trajectory.samples());
    let facts = Facts::of(scenario, report.trajectory);
    let mut object = Map::new();
    object.insert("polhode".to_owned(), VERSION.into());
    object.insert("title".to_owned(), scenario.title().into());
    object.insert("source".to_owned(), report.source.to_json());
    let geometry = Geometry::of_parts(scenario.parts(), scenario.body().mass());
    block::insert(&mut object, scenario.body(), geometry);
    let mut put = |key: &str, value: Value| object.insert(key.to_owned(), value);
    put("complete", report.trajectory.ending().is_complete().into());
    put("end", event::ending_json(report.trajectory, scenario));
    put("turns_about", turns_about(scenario, &facts));
    put("orbit", orbit::to_json(scenario));
    put("start", state(&facts, &facts.start, scenario));
    put("run", run(report));
    put("motion", motion(&facts, scenario));
    put("energy", energy(report.trajectory));
    put("drift", facts.drift.map_or(Value::Null, |drift| drift_json(&drift, facts.is_free)));
    put("error", global_error::to_json(report.trajectory));
    put("required", facts.needed.as_ref().map_or(Value::Null, needed));
    put("pendulum", facts.hanging.as_ref().map_or(Value::Null, pendulum));
    put("heavy_top", heavy_top::of(scenario, facts.start).as_ref().map_or(Value::Null, heavy_top::to_json));
    put("final", samples.last().map_or(Value::Null, |sample| sample_json(scenario, sample)));
    put("pointings", orbit::pointings(scenario, samples));
    put("at", report.at.iter().map(|sample| sample_json(scenario, sample)).collect());
    put("torques", torques(scenario));
    put("wheels", wheels(report));
    let end = samples.last().map_or(scenario.start().time, |sample| sample.state.time);
    put("mass_history", scenario.history().map_or(Value::Null, |history| history::to_json(history, end)));
    put("contact", contact::to_json(scenario, report.trajectory));
    put("gimbals", gimbals::to_json(scenario, report.trajectory));
    put("events", event::json(report.trajectory, scenario));
    put("findings", finding::to_json(&report.findings()));
    Value::Object(object)
}

/// The point that L, T, N and the tensor of the motion are about.
fn turns_about(scenario: &Scenario, facts: &Facts<'_>) -> Value {
    let point = facts.rotor.point();
    json!({
        "what": if scenario.pivot().is_some() { "pivot" } else { "center_of_mass" },
        "point": vector(point),
        "tensor": polhode_document::json::matrix(facts.rotor.inertia().matrix()),
        "principal": block::principal(facts.rotor.principal()),
    })
}

fn state(facts: &Facts<'_>, state: &State, scenario: &Scenario) -> Value {
    json!({
        "time_s": state.time,
        "attitude_wxyz": numbers(&state.attitude.canonical_quaternion()),
        "attitude": orbit::attitude(scenario, state),
        "omega_body": vector(state.omega),
        "omega_space": vector(state.omega_space()),
        "momentum_space": vector(facts.rotor.angular_momentum_space(state)),
        "velocity_space": vector(scenario.velocity()),
    })
}

fn run(report: &MotionReport<'_>) -> Value {
    let samples = report.trajectory.samples();
    let duration = match (samples.first(), samples.last()) {
        (Some(first), Some(last)) => last.state.time - first.state.time,
        _ => 0.0,
    };
    let solution = report.trajectory.solution();
    let steps = solution.statistics().map(|statistics| {
        json!({
            "accepted": statistics.accepted,
            "rejected": statistics.rejected,
            "evaluations": statistics.evaluations,
        })
    });
    json!({
        "method": report.scenario.run().map(|run| run.method).map(Method::name),
        "method_used": solution.name(),
        "method_reason": report.trajectory.reason().to_string(),
        "tolerance": solution.tolerance(),
        "splitting": splitting(solution),
        "samples": samples.len(),
        "duration_s": duration,
        "steps": steps,
    })
}

/// Of splitting its order and its step, which are to it what a tolerance is to others.
fn splitting(solution: &Solution) -> Value {
    match solution {
        Solution::Splitting { order, step, .. } => json!({ "order": order.number(), "step_s": step }),
        _ => Value::Null,
    }
}

/// The kind of a free motion; for any other the same keys, `null` where only a free motion has them.
fn motion(facts: &Facts<'_>, scenario: &Scenario) -> Value {
    let free = facts.free();
    let omega = facts.start.omega;
    let momentum = facts.rotor.angular_momentum_space(&facts.start);
    let of_free = |number: fn(&FreeFacts) -> Option<f64>| free.and_then(number);
    let name = |facts: &FreeFacts| facts.regime.regime.name();
    let has_regime =
        facts.needed.is_none() && facts.rotor.wheels().is_empty() && scenario.mechanism() == Mechanism::Rotor;
    json!({
        "regime": free.map(name),
        "regime_at_start": facts.at_start.as_ref().filter(|_| has_regime).map(name),
        "period_s": of_free(|free| free.regime.period),
        "precession_period_s": of_free(|free| free.periods.precession),
        "rotation_period_s": of_free(|free| free.periods.rotation),
        "flip_interval_s": of_free(|free| free.regime.flip_interval),
        "growth_rate_per_s": of_free(|free| free.regime.growth_rate),
        "kinetic_energy_j": facts.rotor.kinetic_energy(omega),
        "momentum_kg_m2_s": momentum.norm(),
        "momentum_space_kg_m2_s": vector(momentum),
        "symmetric_top": facts.top.as_ref().map(symmetric_top),
    })
}

fn symmetric_top(top: &Top) -> Value {
    let mut object = symmetric_top::to_json(&top.motion, &top.cones);
    object.insert("coplanarity".to_owned(), top.coplanarity.into());
    Value::Object(object)
}

/// Of a body on the ground with that of its centre of mass, and the work of friction and of the ground; of a rotor in gimbals with them.
fn energy(trajectory: &Trajectory) -> Value {
    let energy = trajectory.channel(ENERGY);
    let (first, last) = (energy.and_then(|energy| energy.first()), energy.and_then(|energy| energy.last()));
    json!({
        "kinetic_start_j": first.map(|e| e.kinetic),
        "kinetic_end_j": last.map(|e| e.kinetic),
        "potential_start_j": first.and_then(|e| e.potential),
        "potential_end_j": last.and_then(|e| e.potential),
        "work_j": last.map(|e| e.work),
    })
}

/// The last two say something about the error of a free motion only.
fn drift_json(drift: &Drift, free: bool) -> Value {
    json!({
        "work_energy": drift.work_energy,
        "momentum": drift.momentum,
        "total_energy": drift.total_energy,
        "kinetic_energy": free.then_some(drift.kinetic_energy),
        "momentum_magnitude": free.then_some(drift.momentum_magnitude),
    })
}

fn needed(needed: &Needed) -> Value {
    let largest =
        needed.largest.map(|s| json!({ "time_s": s.state.time, "torque_body_n_m": vector(s.torque) }));
    json!({
        "torque_body_n_m": vector(needed.at_start.torque),
        "torque_space_n_m": vector(needed.at_start.state.attitude * needed.at_start.torque),
        "power_w": needed.at_start.power,
        "largest_torque": largest,
        "particle_forces": needed.forces.iter().map(force).collect::<Value>(),
    })
}

fn force(f: &ParticleForce) -> Value {
    json!({
        "force_body_n": vector(f.force),
        "along_body_n": vector(f.along),
        "across_body_n": vector(f.across),
        "torque_body_n_m": vector(f.torque),
    })
}

fn pendulum((pendulum, swing): &(Pendulum, Swing)) -> Value {
    let (kind, amplitude, period) = match *swing {
        Swing::Rest => ("rest", Some(0.0), None),
        Swing::Oscillation { amplitude, period } => ("oscillation", Some(amplitude), Some(period)),
        Swing::Separatrix => ("separatrix", None, None),
        Swing::Revolution { period } => ("revolution", None, Some(period)),
    };
    json!({
        "moment": pendulum.moment(),
        "arm_m": pendulum.arm(),
        "gravity_m_s2": pendulum.gravity(),
        "angle_rad": pendulum.angle(),
        "small_frequency_rad_s": pendulum.small_frequency(),
        "small_period_s": pendulum.period(0.0),
        "swing": kind,
        "amplitude_rad": amplitude,
        "period_s": period,
    })
}

fn sample_json(scenario: &Scenario, sample: &Sample) -> Value {
    json!({
        "time_s": sample.state.time,
        "attitude_wxyz": numbers(&sample.state.attitude.canonical_quaternion()),
        "attitude": orbit::attitude(scenario, &sample.state),
        "omega_body": vector(sample.state.omega),
        "omega_space": vector(sample.state.omega_space()),
        "momentum_space": vector(sample.momentum),
        "torque_body": vector(sample.torque),
    })
}

/// Each wheel, with its momentum and its speed at the start and at the end.
fn wheels(report: &MotionReport<'_>) -> Value {
    let start = report.trajectory.start().state;
    let end = report.trajectory.samples().last().map(|sample| sample.state);
    let one = |(k, wheel): (usize, &Wheel)| {
        let mut object = Description::of_wheel(wheel).json();
        object.insert("name".to_owned(), report.scenario.wheel_name(k).into());
        let mut put = |key: &str, value: Option<f64>| object.insert(key.to_owned(), value.into());
        put("speed_rad_s", wheel.speed_at(start.time, start.omega));
        put("final_momentum_kg_m2_s", end.map(|end| wheel.momentum_at(end.time)));
        put("final_speed_rad_s", end.and_then(|end| wheel.speed_at(end.time, end.omega)));
        Value::Object(object)
    };
    report.scenario.wheels().iter().enumerate().map(one).collect()
}

/// Each torque, with its name, and whether it is on at the start.
fn torques(scenario: &Scenario) -> Value {
    let one = |(k, model): (usize, &TorqueModel)| {
        let mut object = Description::of(model).json();
        object.insert("name".to_owned(), scenario.torque_names().get(k).cloned().flatten().into());
        object.insert("on".to_owned(), (!scenario.switched_off().contains(&k)).into());
        Value::Object(object)
    };
    scenario.torques().iter().enumerate().map(one).collect()
}
