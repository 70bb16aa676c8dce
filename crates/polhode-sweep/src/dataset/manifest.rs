//! Manifest `sweep.json`: the request and its division into parts.

use std::ops::Range;

use polhode_document::json::pretty;
use serde_json::{Value, json};

use crate::error::SweepError;
use crate::outcome::is_stepped;
use crate::plan::Plan;
use crate::sampling;

/// Description of the request, and its division into parts.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Manifest {
    digest: String,
    members: u64,
    sampling: &'static str,
    seed: Option<u64>,
    trajectories: bool,
    rows_per_part: u64,
}

impl Manifest {
    /// Returns the manifest of a plan.
    pub(crate) fn of(plan: &Plan) -> Result<Self, SweepError> {
        let nominal = plan.nominal();
        let samples = nominal.run().ok_or(SweepError::NoRun)?.times.len();
        let trajectories = plan.wants_trajectories();
        let rows_per_part =
            rows_per_part(plan.members(), is_stepped(nominal), if trajectories { samples } else { 1 });
        let sampling = sampling::name(plan.sampling());
        let (digest, members, seed) = (plan.digest(), plan.members(), plan.seed());
        Ok(Self { digest, members, sampling, seed, trajectories, rows_per_part })
    }

    pub(super) fn to_text(&self) -> String {
        pretty(&self.to_json()) + "\n"
    }

    fn to_json(&self) -> Value {
        json!({
            "polhode": env!("CARGO_PKG_VERSION"),
            "digest": self.digest,
            "members": self.members,
            "sampling": self.sampling,
            "seed": self.seed,
            "trajectories": self.trajectories,
            "rows_per_part": self.rows_per_part,
            "parts": self.parts(),
        })
    }

    /// Returns the difference to a manifest that was written and parsed; `None` if they are equal.
    pub(super) fn difference(&self, written: &Value) -> Option<String> {
        if *written == self.to_json() {
            return None;
        }
        let value = written;
        let version = value.get("polhode").and_then(Value::as_str).unwrap_or("another version");
        if version != env!("CARGO_PKG_VERSION") {
            return Some(format!(
                "it was written by polhode {version}, but this is polhode {}",
                env!("CARGO_PKG_VERSION")
            ));
        }
        let members = value.get("members").and_then(Value::as_u64).unwrap_or_default();
        if members != self.members {
            return Some(format!("it has {members} members, but this plan has {}", self.members));
        }
        Some("its plan.toml, or a file named in the plan, is different".to_owned())
    }

    /// Returns the number of parts.
    pub(crate) const fn parts(&self) -> u64 {
        self.members.div_ceil(self.rows_per_part)
    }

    /// Returns the members of a part; empty for a part beyond the last.
    pub(crate) fn rows(&self, part: u64) -> Range<u64> {
        let first = part.saturating_mul(self.rows_per_part).min(self.members);
        first..first.saturating_add(self.rows_per_part).min(self.members)
    }

    pub(super) const fn members(&self) -> u64 {
        self.members
    }

    pub(super) const fn trajectories(&self) -> bool {
        self.trajectories
    }

    /// Returns the metadata of a part's file.
    pub(super) fn part_metadata(&self, part: u64) -> Vec<(String, String)> {
        let seed = self.seed.map(|seed| ("polhode.seed".to_owned(), seed.to_string()));
        let own = [
            ("polhode.digest".to_owned(), self.digest.clone()),
            ("polhode.sampling".to_owned(), self.sampling.to_owned()),
        ];
        own.into_iter().chain(seed).chain([("polhode.part".to_owned(), part.to_string())]).collect()
    }
}

/// Returns the number of members per part. It depends on the plan alone, so that files do not
/// depend on the machine.
///
/// A part is the unit of work of a thread, and the loss if a sweep is killed. Parts are small
/// enough for both, and large enough to keep the number of files low. Closed-form motions take
/// microseconds, integrated ones milliseconds.
fn rows_per_part(members: u64, stepped: bool, samples: usize) -> u64 {
    /// Maximum number of samples in a part with trajectories, limited by memory.
    const MOST_SAMPLES: u64 = 1 << 20;
    /// Number of parts of an ordinary sweep.
    const PARTS: u64 = 64;
    let [least, most] = if stepped { [8, 4096] } else { [512, 1 << 16] };
    let even = members.div_ceil(PARTS).next_power_of_two().clamp(least, most);
    even.min(MOST_SAMPLES / (samples as u64).clamp(1, MOST_SAMPLES)).max(1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_are_neither_crumbs_nor_lumps() {
        assert_eq!(rows_per_part(1_000_000, false, 1), 16_384);
        assert_eq!(rows_per_part(1_000_000_000, false, 1), 65_536);
        assert_eq!(rows_per_part(100, false, 1), 512);
        assert_eq!(rows_per_part(1000, true, 1), 16);
        assert_eq!(rows_per_part(1, true, 1), 8);
        assert_eq!(rows_per_part(1_000_000, false, 1001), 1047);
        assert_eq!(rows_per_part(1_000_000, false, 3_000_000), 1);
    }

    #[test]
    fn every_member_is_in_one_part() {
        let manifest = Manifest {
            digest: String::new(),
            members: 1003,
            sampling: "grid",
            seed: None,
            trajectories: false,
            rows_per_part: 16,
        };
        let rows: Vec<u64> = (0..manifest.parts()).flat_map(|part| manifest.rows(part)).collect();
        assert!(rows.into_iter().eq(0..1003));
        assert_eq!(manifest.rows(1 << 60).count(), 0);
    }
}
