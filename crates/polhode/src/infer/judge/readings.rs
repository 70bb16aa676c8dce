//! The reading of a log, found by the motion that it has to begin with.

use super::axes::SignedAxes;
use super::beginning::CLEARLY;
use super::declared::{DeclaredReading, OmegaAxes};
use super::error::JudgeError;
use super::log::MotionLog;
use super::log_mistake::LogMistake;
use super::motion::ReadMotion;
use super::omega::omega_reading;
use super::omega_reading::OmegaReading;
use super::reading::{Reading, ReadingResidual};
use super::reference::require_judged;
use super::search::{FITS, SAME, Search, is_same_motion};
use crate::motion::task::scenario::Scenario;

/// A log's reading, and those that it was found among.
#[derive(Clone, Debug, PartialEq)]
pub struct Readings {
    /// Meaning of the times and attitudes.
    pub reading: Reading,
    /// Meaning of ω, if the log has any.
    pub omega: Option<OmegaReading>,
    /// All readings that were tried, best first.
    pub tried: Vec<ReadingResidual>,
    /// Number of them, from the first, that give the same motion to the last row: any of them may be meant.
    pub equivalent: usize,
    /// Whether the readings were compared from the log's own first attitude on, as none begins with that of the scenario.
    pub from_own_start: bool,
    /// True if the reading contradicts the names of the log's columns: order, sense, frame, components or a unit.
    pub is_against_names: bool,
    /// Mistakes of the program. The reading is the stated one, so that they are in the errors.
    pub mistakes: Vec<LogMistake>,
}

impl Readings {
    /// Finds what the numbers of a log mean: what is declared, and of the rest what begins as the scenario does.
    ///
    /// These are tried until one fits:
    ///
    /// 1. the names of the columns, with the times as they are and from the scenario's start;
    /// 2. all orders and senses;
    /// 3. other units of time in which the log turns as fast as the scenario at its first row;
    /// 4. other axes;
    /// 5. a first row some time after the scenario's start;
    /// 6. a first row that is the scenario's start in one reading alone: the program is wrong from its first step on;
    /// 7. the turn since the first row, as the run may start elsewhere.
    ///
    /// The times are those that the log says, unless it begins clearly better from the scenario's
    /// start. Readings that give the same motion to the last row are one. If the user declares
    /// order and sense and nothing fits, they are believed.
    ///
    /// Two findings are [`Readings::mistakes`]. The rows are late: they are stated from the
    /// scenario's start on and begin later, or are late by one to three rows. The components of ω
    /// are mirrored.
    ///
    /// # Errors
    /// [`JudgeError::NoReading`], [`JudgeError::OtherRate`], [`JudgeError::NotSearched`],
    /// [`JudgeError::FarTimes`], [`JudgeError::Ambiguous`], [`JudgeError::AmbiguousOmega`] and
    /// [`JudgeError::NoOmega`] where the log does not tell, and was not declared; as
    /// [`super::Reference::of`].
    pub fn of(log: &MotionLog, scenario: &Scenario, declared: &DeclaredReading) -> Result<Self, JudgeError> {
        require_judged(scenario)?;
        let search = Search::new(log, scenario, declared)?;
        let found = search.found()?;
        let mut tried = found.tried;
        let [best, ..] = tried[..] else { return Err(JudgeError::NoReading { tried }) };
        let near = |other: &&ReadingResidual| other.attitude <= CLEARLY * best.attitude.max(SAME);
        let fitting = if best.relative <= FITS { tried.iter().take_while(near).count() } else { 1 };
        let is_same = |other: &&ReadingResidual| is_same_motion(log, &best.reading, &other.reading);
        let mut equivalent = tried.iter().take(fitting).filter(is_same).count();
        // Axes that are not the scenario's are found only where the motion tells them from all others.
        let is_told = best.reading.axes == search.plain_axes() || equivalent == 1;
        if equivalent < fitting || !is_told {
            return Err(JudgeError::Ambiguous { tried, fitting });
        }
        let beginning = found.beginnings.iter().find(|beginning| beginning.clock.is_of(&best.reading));
        let mut omega = match (log.omega(), beginning) {
            (Some(omega), Some(beginning)) => {
                Some(omega_reading(log, omega, scenario, declared, &best.reading, beginning)?)
            }
            _ => None,
        };
        let is_against_names = contradicts_names(declared, &best.reading, omega);
        let (mut reading, mut mistakes) = (best.reading, Vec::new());
        if found.is_shifted
            && let Some(shift) = search.late_by(&reading)
        {
            mistakes.push(LogMistake::LateRows { shift });
            reading.time_origin = 0.0;
            if let Some(stated) = search.residual_as_stated(reading) {
                tried.insert(0, stated);
            }
            equivalent = 1;
        }
        if let Some(omega) = &mut omega
            && !omega.has_axes(reading.sense)
        {
            mistakes.push(LogMistake::OmegaComponents { components: omega.components });
            omega.components = SignedAxes::SAME;
        }
        let from_own_start = found.from_own_start;
        Ok(Self { reading, omega, tried, equivalent, from_own_start, is_against_names, mistakes })
    }

    /// Frame of ω, if the log has any.
    pub fn omega_axes(&self) -> Option<OmegaAxes> {
        self.omega.map(|omega| omega.frame)
    }

    /// A log's motion.
    pub fn read(&self, log: &MotionLog) -> ReadMotion {
        self.reading.read(log, self.omega)
    }
}

fn contradicts_names(declared: &DeclaredReading, reading: &Reading, omega: Option<OmegaReading>) -> bool {
    let by_name = declared.by_name;
    let is_other_omega = |omega: OmegaReading| {
        declared.omega_axes.is_some_and(|frame| frame != omega.frame)
            || omega.components != SignedAxes::SAME
            || by_name.omega_unit && omega.factor != 1.0
    };
    declared.order.is_some_and(|order| order != reading.order)
        || declared.sense.is_some_and(|sense| sense != reading.sense)
        || by_name.time_unit && reading.time_factor != 1.0
        || omega.is_some_and(is_other_omega)
}
