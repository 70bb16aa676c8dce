//! What happens to a body over time: tanks that drain, parts that are dropped, arms that unfold.
//!
//! Everything is prescribed: at every time the body is the rows that are there and the liquid that is left. Mass properties and their rates are exact at every time, as
//! what leaves a tank next is the slice at the surface of its liquid. Errors are those of the parts list, and of what is in its tanks at first ([`Budget::estimate`]).

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

/// What is to happen to a body.
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
    /// The body without liquid, at the start.
    pub budget: &'a Budget,
    /// With or without growth.
    pub basis: Basis,
    /// The tanks, and what is in them before the first burn, kg.
    pub tanks: Vec<(Tank, f64)>,
    /// What leaves them.
    pub burns: Vec<Burn>,
    /// What happens at once.
    pub changes: Vec<Change<'a>>,
}

/// A flow out of a tank, steady for a time; a flow that changes is several of them.
#[derive(Clone, Debug, PartialEq)]
pub struct Burn {
    /// Of which tank.
    pub tank: String,
    /// s
    pub from: f64,
    /// s
    pub until: f64,
    /// kg/s
    pub flow: f64,
}

/// What happens at once.
#[derive(Clone, Debug, PartialEq)]
pub enum Change<'a> {
    /// Rows go, with all that stands in them and what is in their tanks: each part keeps its own ω.
    Drop {
        /// When, s.
        time: f64,
        /// By their names.
        rows: Vec<String>,
    },
    /// The body takes another form of the same mass, as its arms unfold: angular momentum is kept.
    Become {
        /// When, s.
        time: f64,
        /// What that form is called.
        name: String,
        /// Its parts from then on; rows that have gone before do not come back.
        budget: &'a Budget,
    },
}

impl Change<'_> {
    /// When, s.
    pub const fn time(&self) -> f64 {
        match self {
            Self::Drop { time, .. } | Self::Become { time, .. } => *time,
        }
    }
}

/// The body at a time.
#[derive(Clone, Debug, PartialEq)]
pub struct SequenceRow {
    /// s
    pub time: f64,
    /// How many changes have happened.
    pub changes: usize,
    /// All that is there.
    pub properties: MassProperties<Body>,
    /// How fast that changes.
    pub rates: MassRates,
    /// What is in each tank, kg; nothing of one that has gone.
    pub liquid: Vec<f64>,
}

impl<'a> Sequence<'a> {
    /// A body with so much in its tanks, to which nothing happens.
    pub fn of(budget: &'a Budget, basis: Basis, tanks: impl IntoIterator<Item = (Tank, f64)>) -> Self {
        Self { budget, basis, tanks: tanks.into_iter().collect(), burns: Vec::new(), changes: Vec::new() }
    }

    /// The body just after a time.
    ///
    /// # Errors
    /// [`SequenceError`] that names what cannot be.
    pub fn at(&self, time: f64) -> Result<SequenceRow, SequenceError> {
        Timeline::of(self)?.after(time)
    }

    /// The body at both ends of each stretch in which nothing begins or ends, and at so many places between them: at a corner or a jump there are two rows of one time.
    ///
    /// # Errors
    /// As [`Sequence::at`].
    pub fn rows(&self, span: [f64; 2], pieces: usize) -> Result<Vec<SequenceRow>, SequenceError> {
        Timeline::of(self)?.rows(span, pieces)
    }

    /// What a simulation takes: cubics with these rates between such rows.
    ///
    /// # Errors
    /// As [`Sequence::at`]; [`SequenceError::Motion`] as [`MassHistory::new`].
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

    /// The body by how full its tanks are, all alike, without regard to time: rates are those of one more part of a full tank each.
    ///
    /// # Errors
    /// As [`Sequence::at`].
    pub fn by_fill(&self, fractions: &[f64]) -> Result<Vec<SequenceRow>, SequenceError> {
        let timeline = Timeline::of(self)?;
        fractions.iter().map(|&fraction| timeline.filled(fraction)).collect()
    }
}
