//! Plans: a scenario, and variables that differ between members.
//!
//! A member's values are a pure function of the plan and of the member's number. Uniform numbers
//! follow from the seed, the variable's key and the member's number ([`uniform`]). They are
//! converted by the inverse of a distribution function ([`distribution`]), or by methods for
//! directions, rotations and mass properties ([`draw`], [`second_moments`]).

mod digest;
mod distribution;
mod draw;
mod mix;
mod normal;
mod permutation;
mod question;
mod second_moments;
mod sobol;
mod uniform;

use std::path::Path;

use polhode::body::{Finding, Severity};
use polhode::motion::Scenario;
use polhode_scenario::read::{Distribution, Law, Template, Vary};
use polhode_source::FormatError;
use polhode_source::files::Files;

use crate::outcome::columns_of;

use draw::{Draw, MOST_COORDINATES};
use uniform::{Coordinate, Sets};

pub use polhode_scenario::read::{Sampling, TargetColumn as Variable};

pub(crate) use mix::mix;
pub(crate) use question::Condition;

/// Scenario with variables that differ between members.
///
/// ```
/// use polhode_source::files::Disk;
/// use polhode_sweep::Plan;
/// let text = r#"
/// [[body.part]]
/// shape = "tensor"
/// mass = "3 kg"
/// moments = ["1 kg m^2", "2 kg m^2", "2.5 kg m^2"]
///
/// [start]
/// spin = { body = [0.1, 2, -0.3] }
///
/// [sweep]
/// members = 1_000_000
/// sampling = "monte carlo"
/// seed = 7
///
/// [[sweep.vary]]
/// key = "start.spin.body[1]"
/// normal = { mean = "2 rad/s", sd = "10 deg/s" }
/// "#;
/// let plan = Plan::parse(&Disk, text.to_owned(), "spins.toml".as_ref())?;
/// let values = plan.values(123_456);
/// assert_eq!(plan.variables()[0].name, "start_spin_body_y_rad_s");
/// assert_eq!(plan.scenario(&values)?.start().omega.to_array(), [0.1, values[0], -0.3]);
/// # Ok::<(), polhode_source::FormatError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Plan {
    template: Template,
    members: u64,
    sampling: Sampling,
    seed: u64,
    replicates: u64,
    questions: Vec<Condition>,
    vary: Vec<(Vary, Draw)>,
    /// Uniform numbers of a member, in the order of the variables.
    coordinates: Vec<Coordinate>,
    variables: Vec<Variable>,
    trajectories: bool,
    digest: String,
}

/// Maximum number of members that are tested when a plan is read.
const TRIED: u64 = 64;

impl Plan {
    /// Reads a plan; the files that it names are relative to it.
    ///
    /// # Errors
    /// [`FormatError`] if it is not a scenario with a `[sweep]`, or if none of its members is a
    /// valid scenario.
    pub fn read(files: &dyn Files, path: &Path) -> Result<Self, FormatError> {
        Self::new(files, Template::read(files, path)?)
    }

    /// Reads a plan from its text; `path` is for messages, and for the files that the plan names.
    ///
    /// # Errors
    /// Same as [`Plan::read`].
    pub fn parse(files: &dyn Files, text: String, path: &Path) -> Result<Self, FormatError> {
        Self::new(files, Template::parse(files, text, path)?)
    }

    fn new(files: &dyn Files, template: Template) -> Result<Self, FormatError> {
        let sweep = template.sweep()?;
        let vary: Vec<_> = sweep.vary.into_iter().map(|vary| (Draw::new(&vary), vary)).collect();
        let mut coordinates = Vec::new();
        for (draw, vary) in &vary {
            for index in 0..draw.coordinates() {
                let (name, dimension) = (vary.target.key(), coordinates.len());
                let sets = Sets { count: sweep.replicates, size: sweep.members / sweep.replicates.max(1) };
                coordinates.push(Coordinate::new(sweep.sampling, sets, sweep.seed, name, index, dimension));
            }
        }
        let variables: Vec<Variable> =
            vary.iter().flat_map(|(_, vary)| vary.target.columns().iter().cloned()).collect();
        let digest = digest::digest(files, &template)?;
        let outcomes = columns_of(template.nominal(), &[]);
        let condition = |question| Condition::new(&template, question, &variables, &outcomes);
        let questions = sweep.questions.iter().map(condition).collect::<Result<_, _>>()?;
        let vary = vary.into_iter().map(|(draw, vary)| (vary, draw)).collect();
        let plan = Self {
            template,
            members: sweep.members,
            sampling: sweep.sampling,
            seed: sweep.seed,
            replicates: sweep.replicates,
            questions,
            vary,
            coordinates,
            variables,
            trajectories: sweep.trajectories,
            digest,
        };
        plan.tried().map(|_| plan)
    }

    /// Returns the text of the plan file.
    pub fn text(&self) -> &str {
        self.template.text()
    }

    /// Returns the nominal scenario, as written, without variation.
    pub const fn nominal(&self) -> &Scenario {
        self.template.nominal()
    }

    /// Returns true if trajectories of members are requested.
    pub const fn wants_trajectories(&self) -> bool {
        self.trajectories
    }

    /// Returns the number of members.
    pub const fn members(&self) -> u64 {
        self.members
    }

    /// Returns the sampling method.
    pub const fn sampling(&self) -> Sampling {
        self.sampling
    }

    /// Returns the seed of the random numbers; `None` for a grid.
    pub fn seed(&self) -> Option<u64> {
        (self.sampling != Sampling::Grid).then_some(self.seed)
    }

    /// Returns the number of independently drawn sets of points: 1, except for replicates of a
    /// Latin hypercube or of Sobol points.
    pub const fn replicates(&self) -> u64 {
        self.replicates
    }

    /// Returns the questions on the outcomes.
    pub(crate) fn questions(&self) -> &[Condition] {
        &self.questions
    }

    /// Returns the names of varied rotations, without `_w`, `_x`, `_y`, `_z`.
    pub(crate) fn rotations(&self) -> impl Iterator<Item = &str> {
        let rotations = self.vary.iter().filter(|(vary, _)| matches!(vary.law, Law::Rotation(_)));
        rotations.filter_map(|(vary, _)| vary.target.columns().first()?.name.strip_suffix("_w"))
    }

    /// Returns the varied quantities, one column each.
    pub fn variables(&self) -> &[Variable] {
        &self.variables
    }

    /// Returns the values of a member: one number per variable, SI units. They depend on the plan
    /// and the member's number only.
    pub fn values(&self, member: u64) -> Vec<f64> {
        let mut values = Vec::with_capacity(self.variables.len());
        if self.sampling == Sampling::Grid {
            self.combination(member, &mut values);
            return values;
        }
        let mut coordinates = self.coordinates.iter();
        for (_, draw) in &self.vary {
            let mut uniform = [0.0; MOST_COORDINATES];
            let count = draw.coordinates().min(MOST_COORDINATES);
            for (u, coordinate) in uniform.iter_mut().zip(coordinates.by_ref().take(count)) {
                *u = coordinate.uniform(member);
            }
            draw.put(uniform.get(..count).unwrap_or_default(), &mut values);
        }
        values
    }

    /// Appends the values of a grid member; the last variable changes fastest.
    fn combination(&self, member: u64, values: &mut Vec<f64>) {
        let mut rest = member;
        for (vary, _) in self.vary.iter().rev() {
            if let Law::Number(Distribution::List(list)) = &vary.law {
                let count = list.len().max(1) as u64;
                values.extend(list.get((rest % count) as usize));
                rest /= count;
            }
        }
        values.reverse();
    }

    /// Returns the scenario with these values of the variables.
    ///
    /// # Errors
    /// [`FormatError`] if the body or motion is invalid. Other members may still be valid.
    pub fn scenario(&self, values: &[f64]) -> Result<Scenario, FormatError> {
        let mut rest = values;
        let mut targets = Vec::with_capacity(self.vary.len());
        for (k, (vary, _)) in self.vary.iter().enumerate() {
            let columns = vary.target.columns().len();
            // Surplus values go to the last target, which rejects them.
            let is_last = k + 1 == self.vary.len();
            let (own, others) = rest.split_at(if is_last { rest.len() } else { columns.min(rest.len()) });
            targets.push((&vary.target, own));
            rest = others;
        }
        self.template.scenario(targets)
    }

    /// Returns the digest of everything that results depend on: the plan's text, the contents of
    /// the files that it names, and the program's version.
    pub fn digest(&self) -> String {
        self.digest.clone()
    }

    /// Returns findings about the nominal scenario, and about invalid members.
    pub fn findings(&self) -> Vec<Finding> {
        let mut findings = self.nominal().findings().to_vec();
        findings.extend(self.tried().ok().flatten());
        findings
    }

    /// Tests some members from the whole plan.
    fn tried(&self) -> Result<Option<Finding>, FormatError> {
        let count = self.members.min(TRIED);
        let number = |k: u64| (u128::from(k) * u128::from(self.members) / u128::from(count.max(1))) as u64;
        let failed: Vec<(u64, FormatError)> = (0..count)
            .map(number)
            .filter_map(|member| self.scenario(&self.values(member)).err().map(|error| (member, error)))
            .collect();
        let Some((member, error)) = failed.first() else { return Ok(None) };
        if failed.len() as u64 == self.members {
            return Err(error.clone());
        }
        let all = if failed.len() as u64 == count { " (all)" } else { "" };
        Ok(Some(Finding {
            code: "sweep.members",
            severity: Severity::Warning,
            message: format!(
                "{} of {count} tested members are invalid{all}; member {member}: {}",
                failed.len(),
                error.message()
            ),
            place: error.place().map(|place| format!("line {}", place.line)),
        }))
    }
}
