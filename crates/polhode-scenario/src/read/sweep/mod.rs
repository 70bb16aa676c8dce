//! `[sweep]`: number of members, sampling, and varied quantities.

mod correlated;
mod distribution;
mod law;
mod question;

use polhode::body::{Finding, Severity};
use polhode::motion::Scenario;
use polhode_source::toml::reader::{Table, Value};
use polhode_source::toml::source::Source;
use polhode_source::toml::tree::Entries;
use polhode_source::{FormatError, Place};

use super::target::{Catalogue, Target};

pub use distribution::Distribution;
pub use law::{Dispersion, Law, Spread};
pub use question::Question;

/// Sampling method.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sampling {
    /// Every combination of the given values.
    Grid,
    /// Independent draws.
    MonteCarlo,
    /// Latin hypercube: one draw in each stratum of every variable, with as many strata as members.
    LatinHypercube,
    /// Owen-scrambled Sobol points.
    Sobol,
}

/// Contents of a plan's `[sweep]`.
#[derive(Clone, Debug)]
pub struct Sweep {
    /// Number of members, at least one.
    pub members: u64,
    /// Sampling method.
    pub sampling: Sampling,
    /// Seed of the random numbers.
    pub seed: u64,
    /// Number of independent point sets that form the members of a Latin hypercube or Sobol
    /// sequence; else 1.
    pub replicates: u64,
    /// Questions about the outcomes.
    pub questions: Vec<Question>,
    /// Varied quantities in the order of the file; no number occurs twice.
    pub vary: Vec<Vary>,
    /// True if the samples of every member are stored.
    pub trajectories: bool,
}

/// Varied quantity with its law.
#[derive(Clone, Debug)]
pub struct Vary {
    /// Quantity that varies.
    pub target: Target,
    /// Law of variation.
    pub law: Law,
    /// Place of the key in the plan.
    pub place: Place,
}

impl Vary {
    /// Returns the number of independent random numbers of the law.
    pub fn coordinates(&self) -> usize {
        self.law.coordinates(self.target.columns().len())
    }
}

/// Largest number of dimensions in the table of Sobol's sequence.
pub const SOBOL_DIMENSIONS: usize = 64;

/// Largest number of members; more are probably a mistake.
const MOST_MEMBERS: u64 = 1_000_000_000_000;

/// Largest number of listed values, all lists together: 80 MB.
const MOST_LISTED: usize = 10_000_000;

/// Largest number of Sobol points, which have 32 binary digits.
const MOST_SOBOL: u64 = 1 << 32;

/// Returns a finding that the scenario of a plan is shown as written.
pub(crate) fn nominal(members: u64) -> Finding {
    let message = format!(
        "this is a sweep plan with {members} members: only the scenario as written is used here; polhode sweep runs the members"
    );
    Finding { code: "sweep.nominal", severity: Severity::Info, message, place: None }
}

/// Reads `[sweep]`.
pub(crate) fn sweep(source: Source<'_>, entries: &Entries, nominal: &Scenario) -> Result<Sweep, FormatError> {
    let root = Table::root(source, entries);
    let table = root
        .require("sweep", "[sweep], and under it members = 1000 and sampling = \"monte carlo\"")?
        .table()?;
    table.allow(&["members", "sampling", "seed", "replicates", "trajectories", "vary", "questions"])?;
    let sampling = match table.require("sampling", "sampling = \"monte carlo\"")?.choice(&SAMPLINGS)? {
        "grid" => Sampling::Grid,
        "monte carlo" => Sampling::MonteCarlo,
        "latin hypercube" => Sampling::LatinHypercube,
        _ => Sampling::Sobol,
    };
    let example =
        "[[sweep.vary]], and under it key = \"start.spin.body[0]\" and uniform = { from = 0, to = 1 }";
    let list = table.require("vary", example)?;
    let catalogue = Catalogue { entries, nominal };
    let mut listed = 0;
    let mut vary = Vec::new();
    for table in list.tables("sweep.vary")? {
        let (one, key) = self::vary(&table.called("[[sweep.vary]]".to_owned()), &catalogue, sampling)?;
        listed += one.law.listed();
        if listed > MOST_LISTED {
            let rule = format!("such that the plan lists up to {MOST_LISTED} values in all");
            let hint = "all lists are held in memory: draw from uniform = { from, to } instead";
            return Err(key.invalid(rule).with_hint(hint));
        }
        vary.push((one, key));
    }
    if vary.is_empty() {
        return Err(table.missing("vary", example));
    }
    let mut coordinates = 0;
    for (k, (one, key)) in vary.iter().enumerate() {
        coordinates += one.coordinates();
        if sampling == Sampling::Sobol && coordinates > SOBOL_DIMENSIONS {
            let rule = format!("among the first {SOBOL_DIMENSIONS} numbers that are drawn for a member");
            let hint = "a vector draws up to 3, a rotation 3, a tensor 9, a body up to 16, what is correlated one for each number: take \"latin hypercube\"";
            return Err(key.invalid(rule).with_hint(hint));
        }
        for (other, _) in vary.iter().take(k) {
            let line = other.place.line;
            if other.target.overlaps(&one.target) {
                let rule = format!("a number that does not already vary by line {line}");
                return Err(key.invalid(rule).with_hint("a number varies once: leave one of them out"));
            }
            let named = |name: &str| other.target.columns().iter().any(|column| column.name == name);
            if let Some(twice) = one.target.columns().iter().find(|column| named(&column.name)) {
                let rule = format!("of another name: line {line} has the column {} already", twice.name);
                return Err(key
                    .invalid(rule)
                    .with_hint("a column's name has letters, digits and underscores"));
            }
        }
    }
    let vary: Vec<Vary> = vary.into_iter().map(|(vary, _)| vary).collect();
    let seed = table.get("seed");
    if let (Sampling::Grid, Some(seed)) = (sampling, &seed) {
        return Err(seed.invalid("left out").with_hint("a grid is not random"));
    }
    let seed = seed.map_or(Ok(0), |seed| seed.count())?;
    let trajectories = table.get("trajectories").map_or(Ok(false), |value| value.boolean())?;
    let members = members(&table, sampling, &vary, &list)?;
    let replicates = replicates(&table, sampling, members)?;
    let questions = question::questions(&table)?;
    Ok(Sweep { members, sampling, seed, replicates, questions, vary, trajectories })
}

/// Largest number of point sets; more do not improve the error estimate.
const MOST_REPLICATES: u64 = 1000;

/// Reads `replicates = 16`, for a Latin hypercube or Sobol points.
fn replicates(table: &Table<'_>, sampling: Sampling, members: u64) -> Result<u64, FormatError> {
    let Some(value) = table.get("replicates") else { return Ok(1) };
    let hint = match sampling {
        Sampling::LatinHypercube | Sampling::Sobol => {
            let count = value.count()?;
            if (2..=MOST_REPLICATES).contains(&count) && members.is_multiple_of(count) && members / count > 1
            {
                return Ok(count);
            }
            let rule =
                format!("2 … {MOST_REPLICATES}, and a divisor of the {members} members, at least 2 of each");
            let fitting = (2..=16).rev().find(|count| members.is_multiple_of(*count) && members > *count);
            let hint = match fitting {
                Some(16) => {
                    "16 replicates determine the error to about 20 %: write replicates = 16".to_owned()
                }
                Some(count) => format!("write replicates = {count}, or a multiple of 16 as members"),
                None => "write a multiple of 16 as members".to_owned(),
            };
            return Err(value.invalid(rule).with_hint(hint));
        }
        Sampling::Grid => "a grid is not a random sample",
        Sampling::MonteCarlo => "the error of independent members is estimated without replicates",
    };
    Err(value.invalid("left out here").with_hint(hint))
}

const SAMPLINGS: [&str; 4] = ["monte carlo", "latin hypercube", "sobol", "grid"];

fn members(
    table: &Table<'_>,
    sampling: Sampling,
    vary: &[Vary],
    list: &Value<'_>,
) -> Result<u64, FormatError> {
    let given = table.get("members");
    if sampling == Sampling::Grid {
        if let Some(value) = given {
            let hint = "the size of a grid is the number of combinations of its values";
            return Err(value.invalid("left out of a grid").with_hint(hint));
        }
        let count = |vary: &Vary| match &vary.law {
            Law::Number(Distribution::List(values)) => values.len() as u64,
            _ => 1,
        };
        let product = vary.iter().try_fold(1_u64, |product, vary| product.checked_mul(count(vary)));
        return product.filter(|product| *product <= MOST_MEMBERS).ok_or_else(|| {
            let counts: Vec<String> = vary.iter().map(|vary| count(vary).to_string()).collect();
            list.error(polhode_source::FormatErrorKind::Value {
                key: "sweep.vary".to_owned(),
                value: counts.join(" × "),
                rule: format!("at most {MOST_MEMBERS} combinations"),
            })
            .with_hint("take fewer values of each, or another sampling")
        });
    }
    let Some(value) = given else { return Err(table.missing("members", "members = 1000")) };
    let members = value.count()?;
    let (most, hint) = match sampling {
        Sampling::Sobol => (MOST_SOBOL, "Sobol's points repeat beyond"),
        _ => (MOST_MEMBERS, "start with 1000"),
    };
    if members == 0 {
        return Err(value.invalid("at least 1").with_hint("write members = 1000"));
    }
    if members > most {
        return Err(value.invalid(format!("at most {most}")).with_hint(hint));
    }
    Ok(members)
}

/// Reads one `[[sweep.vary]]`; returns it with the value of its key.
fn vary<'a>(
    table: &Table<'a>,
    catalogue: &Catalogue<'_>,
    sampling: Sampling,
) -> Result<(Vary, Value<'a>), FormatError> {
    let key = table.require("key", "key = \"start.spin.body[0]\"")?;
    let (target, law) = law::law(table, &key, catalogue, sampling)?;
    Ok((Vary { target, law, place: key.place() }, key))
}
