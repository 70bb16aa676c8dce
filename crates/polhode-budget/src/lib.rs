//! Mass properties of a whole body from its parts list, with growth allowance and uncertainty.
//!
//! A [`PartsList`] has one [`Row`] for each part. The frame of a row is given in the frame of its
//! parent row. A list whose rows make one physically possible body becomes a [`Budget`]:
//!
//! ```
//! use polhode::math::Position;
//! use polhode_budget::{
//!     Basis, GivenPart, Growth, GrowthTable, PartUncertainty, PartsList, Place, Row, Uncertainty,
//! };
//! let at = |x, y, z| Position::new(x, y, z);
//! let battery = Row {
//!     place: Place { position: at(0.1, 0.0, 0.02), ..Place::default() },
//!     uncertainty: Uncertainty { part: PartUncertainty::of_mass(0.05), ..Uncertainty::default() },
//!     growth: Growth::Code("C".to_owned()),
//!     ..Row::part("bus/battery", GivenPart::point(2.0, Position::ZERO))
//! };
//! let list = PartsList {
//!     rows: vec![Row::frame("bus"), battery, Row::part("bus/frame", GivenPart::point(3.0, at(0.0, 0.01, 0.0)))],
//!     growth: GrowthTable::new([("C".to_owned(), 0.1)])?,
//!     ..PartsList::default()
//! };
//! let budget = list.budget()?;
//! let mass = budget.mass_statements()?[0];
//! assert_eq!((mass.basic, mass.predicted), (5.0, 5.2));
//! let whole = budget.estimate(Basis::Basic)?;
//! assert!((whole.properties.center_of_mass().x - 0.04).abs() < 1e-15);
//! // ∂x/∂m = (0.1 − 0.04)/5
//! assert!((whole.sd(1) - 0.05 * 0.012).abs() < 1e-15);
//! # Ok::<(), polhode_budget::BudgetError>(())
//! ```
//!
//! [`run`] answers a [`Request`]: it reads the files and makes a report of all these results:
//!
//! | result | function or type |
//! |---|---|
//! | basic, predicted and allowable mass | [`Budget::mass_statements`] |
//! | mass, centre and tensor with covariance | [`Budget::estimate`], [`Estimate`] |
//! | principal moments and axes | [`Estimate::principal`], [`PrincipalUncertainty`] |
//! | contributions of single errors to the variance | [`Budget::sensitivities`] |
//! | deviations from first order, by random draws | [`Budget::draws`], [`Draws::compare`] |
//! | random bodies from an estimate | [`Correlated`](polhode::infer::correlated::Correlated) |
//! | mass properties over time, or as a function of the tank fill | [`Sequence`], [`Tank`] |
//! | limits: margin and probability that they are met | [`Budget::limits`], [`Limit`], [`Answer`] |
//! | light ballast that meets limits, with a lower bound | [`Budget::ballast`], [`FoundBallast`] |

mod ballast;
mod budget;
mod changes;
mod comparison;
mod draw;
mod draws;
mod error;
mod errors;
mod estimate;
mod group;
mod growth;
mod limit;
mod list;
mod principal;
pub mod read;
pub mod report;
mod request;
mod row;
mod rows;
mod run;
mod sensitivity;
mod sequence;
mod sequence_error;
mod subtrees;
mod tank;
mod tank_row;
mod tensor;
mod tree;
mod uncertainty;

pub use ballast::{
    Ballast, BallastAnswer, BallastError, BallastPlace, FoundBallast, NoBallast, Piece, Round, Site,
};
pub use budget::Budget;
pub use comparison::{ComparedNumber, Comparison};

pub use draws::{Draws, MOST_DRAWN_ROWS};
pub use error::{BudgetError, RowName};
pub use estimate::{Estimate, EstimateAbout, NUMBERS};
pub use group::Group;
pub use growth::{Basis, Growth, GrowthTable, MassStatement};
pub use limit::{
    About, AllMet, Answer, Evidence, Limit, LimitAnswers, LimitError, Margin, Measure, PrincipalAxis, Share,
    Trial, Undefined,
};
pub use list::PartsList;
pub use principal::{PrincipalUncertainty, Tilt};
pub use request::{MadeFile, Output, Request};
pub use row::{CopyErrors, GivenPart, Place, Quantity, Row, Subtotal};
pub use rows::Rows;
pub use run::{Budgeted, run, run_watched};
pub use sensitivity::{Sensitivities, Sensitivity, Source};
pub use sequence::{Burn, Change, Sequence, SequenceRow};
pub use sequence_error::SequenceError;
pub use subtrees::Subtrees;
pub use tank::{
    Down, Fill, Liquid, LiquidErrors, LiquidTable, Measured, Slice, Tank, TankShape, UncertainLiquid, Vessel,
};
pub use tensor::{GivenTensor, ProductSign, TensorPoint};
pub use uncertainty::{ErrorKind, PartUncertainty, Spread, Uncertainty};

/// JSON schema of a [`Request`].
pub const REQUEST_SCHEMA: &str = include_str!("../schema/request.json");

/// JSON schema of a report: [`Report::to_json`](polhode_document::Report::to_json) of [`Budgeted`].
pub const REPORT_SCHEMA: &str = include_str!("../schema/report.json");
