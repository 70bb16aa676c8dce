//! Changes of a body over time: draining tanks, dropped parts, unfolding arms.
//!
//! All changes are prescribed. At any time, the body consists of the rows that are present and the
//! liquid that remains. Mass properties and their rates are exact at any time, because the next
//! liquid to leave a tank is the slice at its surface. Errors are those of the parts list and of
//! the initial contents of the tanks ([`Budget::estimate`]).

mod loaded;
mod timeline;

use polhode::body::MassProperties;
use polhode::math::Body;
use polhode::motion::{MassHistory, MassRates, MassRow, Outflow};

use crate::budget::Budget;
use crate::growth::Basis;
use crate::sequence_error::SequenceError;
use crate::tank::Tank;
use timeline::Timeline;

/// Prescribed changes of a body over time.
///
/// ```
/// use polhode::math::{Direction, Position};
/// use polhode::motion::{Exit, Outflow};
/// use polhode_budget::{
///     Basis, Burn, Down, GivenPart, Liquid, PartsList, Row, Sequence, Tank, TankShape, Vessel,
/// };
/// let at = |x, y, z| Position::new(x, y, z);
/// let parts = [("bus/a", at(0.4, 0.0, 0.2)), ("bus/b", at(-0.4, 0.1, 0.2)), ("bus/c", at(0.0, 0.3, -0.5))];
/// let mut rows = vec![Row::frame("bus")];
/// rows.extend(parts.map(|(name, place)| Row::part(name, GivenPart::point(10.0, place))));
/// let budget = PartsList { rows, ..PartsList::default() }.budget()?;
/// let vessel = Vessel::new(TankShape::Ellipsoid([0.25; 3]), 1000.0, Down::MinusZ)?;
/// let tank = Tank { name: "water".to_owned(), frame: "bus".to_owned(), liquid: Liquid::Vessel(Box::new(vessel)) };
/// let burn = Burn { tank: "water".to_owned(), from: 10.0, until: 60.0, flow: 0.5 };
/// let sequence = Sequence { burns: vec![burn], ..Sequence::of(&budget, Basis::Basic, [(tank, 40.0)]) };
/// let now = sequence.at(20.0)?;
/// assert!((now.properties.mass() - 65.0).abs() < 1e-12 && (now.rates.mass + 0.5).abs() < 1e-15);
/// let position = Position::new(0.0, 0.0, -0.6);
/// let exit = Exit { share: 1.0, position, axis: Direction::new(0.0, 0.0, 1.0), radius: 0.05 };
/// let history = sequence.history([0.0, 100.0], 16, Outflow::Exits(vec![exit]))?; // what `simulate` takes
/// let (body, _) = history.at(20.0)?;
/// assert!((body.center_of_mass() - now.properties.center_of_mass()).norm() < 1e-8);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Sequence<'a> {
    /// Body without liquid, at the start.
    pub budget: &'a Budget,
    /// Mass basis: without or with growth.
    pub basis: Basis,
    /// Tanks, and the mass of liquid in each before the first burn, kg.
    pub tanks: Vec<(Tank, f64)>,
    /// Flows out of the tanks.
    pub burns: Vec<Burn>,
    /// Instantaneous changes of the body.
    pub changes: Vec<Change<'a>>,
}

/// Constant flow out of a tank over a time interval. A variable flow is a series of burns.
#[derive(Clone, Debug, PartialEq)]
pub struct Burn {
    /// Name of the tank.
    pub tank: String,
    /// Start time, s.
    pub from: f64,
    /// End time, s.
    pub until: f64,
    /// Mass flow, kg/s.
    pub flow: f64,
}

/// Instantaneous change of a body.
#[derive(Clone, Debug, PartialEq)]
pub enum Change<'a> {
    /// Removal of rows with their descendants and the liquid in their tanks. Each part keeps its
    /// own ω.
    Drop {
        /// Time of the removal, s.
        time: f64,
        /// Names of the rows.
        rows: Vec<String>,
    },
    /// Change to another form of the same mass, for example by unfolding arms. Angular momentum is
    /// conserved.
    Become {
        /// Time of the change, s.
        time: f64,
        /// Name of the new form.
        name: String,
        /// Parts from then on. Rows that were removed before stay removed.
        budget: &'a Budget,
    },
}

impl Change<'_> {
    /// Returns the time of the change, s.
    pub const fn time(&self) -> f64 {
        match self {
            Self::Drop { time, .. } | Self::Become { time, .. } => *time,
        }
    }
}

/// State of the body at one time.
#[derive(Clone, Debug, PartialEq)]
pub struct SequenceRow {
    /// Time of the state, s.
    pub time: f64,
    /// Number of changes that have happened.
    pub changes: usize,
    /// Mass properties of everything that is present.
    pub properties: MassProperties<Body>,
    /// Rates of change of the mass properties.
    pub rates: MassRates,
    /// Mass of the liquid in each tank, kg; 0 for a removed tank.
    pub liquid: Vec<f64>,
}

impl<'a> Sequence<'a> {
    /// Returns a sequence without changes, of a body with these masses in its tanks, kg.
    pub fn of(budget: &'a Budget, basis: Basis, tanks: impl IntoIterator<Item = (Tank, f64)>) -> Self {
        Self { budget, basis, tanks: tanks.into_iter().collect(), burns: Vec::new(), changes: Vec::new() }
    }

    /// Returns the state of the body just after a time, s.
    ///
    /// # Errors
    /// [`SequenceError`] that names the invalid item.
    pub fn at(&self, time: f64) -> Result<SequenceRow, SequenceError> {
        Timeline::of(self)?.after(time)
    }

    /// Returns states of the body over a time span, s. Each interval without events is divided into
    /// `pieces` equal parts. A corner or a jump has two rows with the same time: one before and one
    /// after it.
    ///
    /// # Errors
    /// Same as [`Sequence::at`].
    pub fn rows(&self, span: [f64; 2], pieces: usize) -> Result<Vec<SequenceRow>, SequenceError> {
        Timeline::of(self)?.rows(span, pieces)
    }

    /// Returns the input of a simulation: cubics between such rows, with these rates.
    ///
    /// # Errors
    /// Same as [`Sequence::at`]; [`SequenceError::Motion`] for errors of [`MassHistory::new`].
    pub fn history(
        &self,
        span: [f64; 2],
        pieces: usize,
        outflow: Outflow,
    ) -> Result<MassHistory, SequenceError> {
        let rows = self.rows(span, pieces)?.into_iter().map(|row| MassRow {
            time: row.time,
            body: row.properties,
            rates: Some(row.rates),
        });
        MassHistory::new(&rows.collect::<Vec<_>>(), outflow).map_err(SequenceError::Motion)
    }

    /// Returns the body as a function of the fill fraction, which is the same for all tanks,
    /// without regard to time. Rates are derivatives with respect to the fraction.
    ///
    /// # Errors
    /// Same as [`Sequence::at`].
    pub fn by_fill(&self, fractions: &[f64]) -> Result<Vec<SequenceRow>, SequenceError> {
        let timeline = Timeline::of(self)?;
        fractions.iter().map(|&fraction| timeline.filled(fraction)).collect()
    }
}
