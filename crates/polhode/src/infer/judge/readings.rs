//! Determination of a log's reading from the known beginning of the motion.

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

/// Reading of a log, and the readings among which it was selected.
#[derive(Clone, Debug, PartialEq)]
pub struct Readings {
    /// Meaning of the times and attitudes.
    pub reading: Reading,
    /// Meaning of ω, if the log has any.
    pub omega: Option<OmegaReading>,
    /// All readings that were tried, best first.
    pub tried: Vec<ReadingResidual>,
    /// Number of readings, from the first, that give the same motion up to the last row; any of
    /// them may be the intended one.
    pub equivalent: usize,
    /// True if the motions were compared relative to the log's own first attitude, because no
    /// reading begins with that of the scenario.
    pub from_own_start: bool,
    /// True if the reading contradicts the names of the log's columns: order, sense, frame,
    /// components or a unit.
    pub is_against_names: bool,
    /// Mistakes of the program. The reading is the stated one, so that the errors include them.
    pub mistakes: Vec<LogMistake>,
}

impl Readings {
    /// Determines the meaning of a log's numbers: the declared meaning, and otherwise the one with
    /// which the log begins like the scenario.
    ///
    /// The following are tried until one fits:
    ///
    /// 1. the names of the columns, with the times as stated and counted from the scenario's start;
    /// 2. all orders and senses;
    /// 3. other units of time in which the log rotates as fast as the scenario at its first row;
    /// 4. other axes;
    /// 5. a first row some time after the scenario's start;
    /// 6. a first row that equals the scenario's start in one reading only: the program is wrong
    ///    from its first step;
    /// 7. the rotation since the first row, because the run may have a different start.
    ///
    /// The times are those stated in the log, unless it begins clearly better from the scenario's
    /// start. Readings that give the same motion up to the last row count as one. If the user
    /// declares order and sense and nothing fits, these are used.
    ///
    /// Two findings are [`Readings::mistakes`]. First, late rows: the stated times begin at the
    /// scenario's start but the rows begin later, or the rows are late by one to three rows.
    /// Second, mirrored components of ω.
    ///
    /// # Errors
    /// [`JudgeError::NoReading`], [`JudgeError::OtherRate`], [`JudgeError::NotSearched`],
    /// [`JudgeError::FarTimes`], [`JudgeError::Ambiguous`], [`JudgeError::AmbiguousOmega`] and
    /// [`JudgeError::NoOmega`] if the log does not determine the meaning and it is not declared;
    /// and the errors of [`super::Reference::of`].
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
        // Axes different from the scenario's are accepted only if the motion distinguishes them
        // from all others.
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

    /// Returns the frame of ω, if the log has ω.
    pub fn omega_axes(&self) -> Option<OmegaAxes> {
        self.omega.map(|omega| omega.frame)
    }

    /// Returns the motion of a log with this reading.
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
