//! The report as JSON.

use polhode::motion::{ParticleForce, Required};
use polhode_document::VERSION;
use polhode_document::finding;
use polhode_document::json::{numbers, vector};
use serde_json::{Value, json};

use super::RequiredReport;

pub(crate) fn of(report: &RequiredReport) -> Value {
    let (first, last) = (report.first(), report.last());
    let [rms_body, rms_space] = report.rms();
    json!({
        "polhode": VERSION,
        "title": report.scenario.title(),
        "source": report.source.to_json(),
        "turns_about": {
            "what": if report.scenario.pivot().is_some() { "pivot" } else { "center_of_mass" },
            "point": vector(report.rotor().point()),
        },
        "samples": report.samples.len(),
        "start": state(report, first),
        "largest": state(report, report.largest()),
        "largest_power": { "time_s": report.most_power().state.time, "power_w": report.most_power().power },
        "rms_torque_body_n_m": numbers(&rms_body),
        "rms_torque_space_n_m": numbers(&rms_space),
        "work_j": last.work_since(first),
        "impulse_space_n_m_s": vector(last.impulse_since(first)),
        "at": report.at.iter().map(|s| state(report, s)).collect::<Value>(),
        "shaft": report.shaft.as_ref().map(super::ShaftReport::to_json),
        "findings": finding::to_json(report.scenario.findings()),
    })
}

fn state(report: &RequiredReport, s: &Required) -> Value {
    let force = |particle| {
        let f: ParticleForce = s.force_on(particle, report.rotor());
        json!({
            "mass": particle.mass(),
            "position": vector(particle.position()),
            "force_body_n": vector(f.force),
            "along_body_n": vector(f.along),
            "across_body_n": vector(f.across),
            "torque_body_n_m": vector(f.torque),
        })
    };
    json!({
        "time_s": s.state.time,
        "attitude_wxyz": numbers(&s.state.attitude.canonical_quaternion()),
        "omega_body": vector(s.state.omega),
        "acceleration_body": vector(s.acceleration),
        "torque_body_n_m": vector(s.torque),
        "torque_space_n_m": vector(s.torque_space()),
        "power_w": s.power,
        "work_j": s.work_since(&report.start),
        "impulse_space_n_m_s": vector(s.impulse_since(&report.start)),
        "particle_forces": report.points.iter().map(force).collect::<Value>(),
    })
}
