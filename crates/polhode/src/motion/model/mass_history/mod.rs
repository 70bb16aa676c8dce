//! Mass properties that change with time as prescribed: burning, draining, separation, deployment.
//!
//! Let I be the inertia about the centre of mass C of the mass in the body at the time, along body
//! axes. Then
//!
//! d(I ω)/dt + ω × I ω = N − Σ µₖ [ρₖ × (ω × ρₖ) + Gₖ ω]
//!
//! where mass leaves through exit k at the rate µₖ, at position ρₖ from C. The sum is the jet
//! damping: the leaving mass carries angular momentum away. Gₖ is the contribution of the width of
//! the exit, ¼ a² (1 + n nᵀ) for a disc of radius a with normal n. For a pivoted body, I and ρₖ are
//! relative to the pivot.
//!
//! # Derivation
//! H is the angular momentum about C of the mass in a volume that is fixed in the body. About the
//! point of space at which C is at that instant, dH/dt + `ċ_s` × P = N − Σ µₖ ρₖ × vₖ. Here `ċ_s`
//! is the velocity of C in space, P the momentum in the volume, and vₖ the velocity of the leaving
//! mass. By continuity P = M `ċ_s` + Σ µₖ ρₖ, so that dH/dt = N − Σ µₖ ρₖ × (vₖ − `ċ_s`). Further,
//! vₖ − `ċ_s` = ω × ρₖ + uₖ − ċ, with uₖ relative to the body and ċ the velocity of C in the body.
//! Finally H = I ω + h, with h the angular momentum of the flow relative to the body.
//!
//! # Assumptions
//! - The mass flow and the thrust are prescribed: −Σ µₖ ρₖ × (uₖ − ċ) is supplied as an external
//!   torque.
//! - h = 0: the flow inside neither swirls nor circulates around C. This holds if the gas flows
//!   along a line through C, or symmetrically about one.
//! - Mass that has not left rotates with the body; slosh is neglected.
//!
//! # Jumps
//! Two rows of the same time are a jump. If mass leaves (separation of a stage), each part keeps
//! its ω: no torque acts between them. If the mass is the same (sudden deployment of an arm),
//! the angular momentum is conserved and ω changes.
//!
//! # Sources
//! Thomson, Introduction to Space Dynamics (1961), §7.8 (jet damping). Eke, Wang, J. Appl. Mech. 62
//! (1995) 1031, and Eke, Mao, Mech. Res. Commun. 29 (2002) 189 (control volumes fixed in a body;
//! burning cylinders). These sources omit the term ċ, as C moves along the axis of the exit there.

pub(crate) mod changing_body;
mod instant;
mod moments;
mod outflow;

use crate::body::inertia::InertiaTensor;
use crate::body::mass_properties::MassProperties;
use crate::math::frame::Body;
use crate::math::vector::{Direction, Position, Velocity};
use crate::motion::error::MotionError;
use crate::motion::model::rotor::Rotor;

use moments::{Moments, Polynomial};
pub use outflow::{Exit, Outflow};

/// Row of a mass history: mass properties at a time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MassRow {
    /// Time, s.
    pub time: f64,
    /// Mass properties at that time.
    pub body: MassProperties<Body>,
    /// Rates of change, if known.
    pub rates: Option<MassRates>,
}

impl MassRow {
    /// Column names in tables, with units. The tensor is about the centre of mass; the sign
    /// convention of the products of inertia is stated next to the table.
    pub const COLUMNS: [&'static str; 11] = [
        "time_s",
        "mass_kg",
        "center_x_m",
        "center_y_m",
        "center_z_m",
        "inertia_xx_kg_m2",
        "inertia_yy_kg_m2",
        "inertia_zz_kg_m2",
        "inertia_xy_kg_m2",
        "inertia_xz_kg_m2",
        "inertia_yz_kg_m2",
    ];

    /// Column names of the rates in tables.
    pub const RATE_COLUMNS: [&'static str; 10] = [
        "mass_rate_kg_s",
        "center_rate_x_m_s",
        "center_rate_y_m_s",
        "center_rate_z_m_s",
        "inertia_rate_xx_kg_m2_s",
        "inertia_rate_yy_kg_m2_s",
        "inertia_rate_zz_kg_m2_s",
        "inertia_rate_xy_kg_m2_s",
        "inertia_rate_xz_kg_m2_s",
        "inertia_rate_yz_kg_m2_s",
    ];
}

/// Rates of change of mass properties, along body axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MassRates {
    /// Rate of change of the mass Ṁ, kg/s.
    pub mass: f64,
    /// Velocity ċ of the centre of mass in the body, m/s.
    pub center_of_mass: Velocity<Body>,
    /// İ about the moving centre of mass: xx, yy, zz, xy, xz, yz, kg·m²/s.
    pub inertia: [f64; 6],
}

/// Mass properties of a body as a function of time.
///
/// The mass, the first moments and the second moments about a fixed point are interpolated between
/// rows. The interpolation is linear, or cubic where both rows have rates. Every intermediate body
/// is then a convex combination of physical bodies and therefore physical. Before the first row and
/// after the last the body is constant.
///
/// Linear interpolation of a smooth curve has an error of 1/8 of its second derivative times the
/// square of the step. Cubic interpolation has 1/384 of its fourth derivative times the fourth
/// power of the step.
///
/// ```
/// use polhode::prelude::*;
/// use polhode::motion::{Exit, MassHistory, MassRow, Outflow};
/// // A cylinder of radius a that burns evenly from 3 kg to 1 kg in 10 s and leaves through all of
/// // its end keeps its spin: Iz = ½ M a², d(Iz ω)/dt = −½ µ a² ω.
/// let cylinder = |time: f64| {
///     let m = 3.0 - 0.2 * time;
///     let inertia = InertiaTensor::diagonal([m * 0.85, m * 0.85, m * 0.02])?;
///     let body = MassProperties::new(m, Position::ZERO, inertia)?;
///     Ok::<_, polhode::body::BodyError>(MassRow { time, body, rates: None })
/// };
/// let (position, axis) = (Position::new(0.0, 0.0, -1.5), Direction::new(0.0, 0.0, 1.0));
/// let exit = Exit { share: 1.0, position, axis, radius: 0.2 };
/// let history = MassHistory::new(&[cylinder(0.0)?, cylinder(10.0)?], Outflow::Exits(vec![exit]))?;
/// let rotor = history.rotor(0.0, None)?;
/// let start = State { time: 0.0, attitude: Attitude::identity(), omega: AngularVelocity::new(0.1, 0.0, 2.0) };
/// let motion = Simulation::new(&rotor, &[], start, &[10.0]).changing(Some(&history)).run()?;
/// let omega = motion.samples()[0].state.omega;
/// assert!((omega.z - 2.0).abs() < 1e-13 && omega.x.hypot(omega.y) < 0.1 * (1.0_f64 / 3.0).powf(1.6));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct MassHistory {
    /// Point to which first and second moments refer. It is near the mass, so that a body far from
    /// the origin loses no accuracy.
    reference: Position<Body>,
    /// Pieces in order of time. The first is valid from −∞.
    pieces: Vec<MassPiece>,
    outflow: Outflow,
    /// Sphere of 1 kg·m² in place of the body: its angular acceleration equals the torque on it.
    ball: Rotor,
}

/// Moments from a time until the next piece.
#[derive(Clone, Debug, PartialEq)]
struct MassPiece {
    start: f64,
    epoch: f64,
    moments: Polynomial,
    /// True if mass leaves. A loss within the rounding of the two rows does not count.
    loses_mass: bool,
    /// Discontinuity at the start of the piece, if there is one.
    jump: Option<Jump>,
}

impl MassPiece {
    fn is_moving(&self) -> bool {
        self.moments.0.iter().skip(1).any(|term| term.0.iter().any(|x| *x != 0.0))
    }
}

/// Kind of discontinuity.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Jump {
    /// Mass leaves: ω is conserved.
    Separation,
    /// Mass moves inside: I ω is conserved.
    Internal,
}

/// Threshold below which a relative difference of mass is rounding.
const SAME_MASS: f64 = 1e-12;

/// Ratio of smallest to largest principal moment below which the body is a rod.
const THIN: f64 = 1e-12;

impl MassHistory {
    /// Creates a mass history from rows and an outflow. Two rows of the same time are a jump.
    ///
    /// # Errors
    /// [`MotionError::MassHistory`] with the time of the wrong row: no rows, descending times, more
    /// than two rows of one time, a rod, or an increase of mass. Also if mass leaves without a
    /// stated outflow, if the leaving mass is not a physical body, or if a cubic has unphysical
    /// bodies between rows. Errors of exits are those of [`Outflow::Exits`].
    pub fn new(rows: &[MassRow], outflow: Outflow) -> Result<Self, MotionError> {
        outflow.require_possible()?;
        let (Some(first), Some(last)) = (rows.first(), rows.last()) else {
            return Err(wrong(0.0, "has no rows"));
        };
        let reference = first.body.center_of_mass();
        let of = |row: &MassRow| Moments::of(&row.body, reference);
        let constant = |row: &MassRow, start: f64| MassPiece {
            start,
            epoch: row.time,
            moments: Polynomial::constant(of(row)),
            loses_mass: false,
            jump: None,
        };
        for row in rows {
            require_row(row)?;
        }
        let mut pieces = vec![constant(first, f64::NEG_INFINITY)];
        let (mut is_second, mut jump) = (false, None);
        for pair in rows.windows(2) {
            let [before, after] = pair else { continue };
            let (from, to) = (of(before), of(after));
            if !(after.time >= before.time) {
                return Err(wrong(after.time, "has a row that is earlier than the previous row"));
            }
            if after.time == before.time {
                if is_second {
                    return Err(wrong(after.time, "has more than two rows"));
                }
                (is_second, jump) = (true, jump_between(after.time, from, to)?);
                continue;
            }
            is_second = false;
            let span = after.time - before.time;
            let slopes = before
                .rates
                .zip(after.rates)
                .map(|(a, b)| [a.moments(&before.body, reference), b.moments(&after.body, reference)]);
            let moments = Polynomial::between([from, to], slopes, span);
            outflow.require_piece(before.time, &moments.bernstein(span), reference)?;
            let loses_mass = from.mass() - to.mass() > SAME_MASS * from.mass();
            let [start, epoch] = [before.time; 2];
            pieces.push(MassPiece { start, epoch, moments, loses_mass, jump: jump.take() });
        }
        pieces.push(MassPiece { jump, ..constant(last, last.time) });
        let ball = InertiaTensor::diagonal([1.0; 3])
            .and_then(|inertia| MassProperties::new(1.0, Position::ZERO, inertia))
            .map_err(|_| MotionError::NotSpinnable)?;
        Ok(Self { reference, pieces, outflow, ball: Rotor::free(&ball) })
    }

    /// Returns the way in which mass leaves.
    pub const fn outflow(&self) -> &Outflow {
        &self.outflow
    }

    /// Returns the times at which a new piece begins, s.
    pub fn times(&self) -> impl Iterator<Item = f64> + '_ {
        self.pieces.iter().skip(1).map(|piece| piece.start)
    }

    /// Returns the intervals [begin, end] of all changes, s, in order of time. A jump has
    /// begin = end.
    pub fn changes(&self) -> impl Iterator<Item = [f64; 2]> + '_ {
        self.pieces
            .windows(2)
            .flat_map(|pair| {
                let [before, after] = pair else { return [None; 2] };
                let jump = after.jump.map(|_| [after.start; 2]);
                [before.is_moving().then_some([before.start, after.start]), jump]
            })
            .flatten()
    }

    /// Returns true if something changes strictly between two times.
    pub fn changes_between(&self, from: f64, to: f64) -> bool {
        self.changes().any(|[begin, end]| begin < to && from < end)
    }

    /// Returns the mass properties just after a time, and their rates.
    ///
    /// # Errors
    /// [`MotionError::MassHistory`] if the time is NaN.
    pub fn at(&self, time: f64) -> Result<(MassProperties<Body>, MassRates), MotionError> {
        let piece = self.piece(time);
        let (moments, rates) = (piece.moments.at(time - piece.epoch), piece.moments.rate(time - piece.epoch));
        let body = moments.properties(self.reference);
        let body = body.map_err(|_| wrong(time, "is not known"))?;
        Ok((body, rates.rates(&moments)))
    }

    /// Returns the rotor just after a time. It turns about `pivot`, or about its centre of mass at
    /// that time.
    ///
    /// # Errors
    /// The errors of [`MassHistory::at`].
    pub fn rotor(&self, time: f64, pivot: Option<Position<Body>>) -> Result<Rotor, MotionError> {
        let (body, _) = self.at(time)?;
        Ok(pivot.map_or_else(|| Rotor::free(&body), |pivot| Rotor::pivoted(&body, pivot)))
    }

    /// Returns an estimate of |h|, kg·m²/s, the angular momentum of the internal flow relative to
    /// the body, just after a time.
    ///
    /// The estimate assumes that mass flows straight from the mean place of depletion to the exits.
    /// The equations of motion neglect h, so it should be small compared with I ω.
    ///
    /// # Errors
    /// The errors of [`MassHistory::at`].
    pub fn flow_momentum(&self, time: f64, pivot: Option<Position<Body>>) -> Result<f64, MotionError> {
        let (body, rates) = self.at(time)?;
        let Outflow::Exits(exits) = &self.outflow else { return Ok(0.0) };
        if !self.piece(time).loses_mass {
            return Ok(0.0);
        }
        // Mass flowing from b to an exit at ρ has the angular momentum µ b × ρ, and (M c)˙ = −μ b.
        let center = body.center_of_mass();
        let point = pivot.unwrap_or(center);
        let [d, velocity] = [(center - point).to_array(), rates.center_of_mass.to_array()];
        let first = core::array::from_fn(|k| rates.mass * d[k] + body.mass() * velocity[k]);
        let first = Direction::<Body>::from_array(first);
        let momentum = exits.iter().fold(Direction::<Body>::ZERO, |sum, exit| {
            let arm: Direction<Body> = (exit.position - point).as_quantity();
            sum + arm.cross(first) * exit.share
        });
        Ok(momentum.norm())
    }

    /// Scales all lengths along each axis by a factor, relative to the reference point.
    pub(crate) fn stretched(&self, by: [f64; 3]) -> Self {
        let piece = |piece: &MassPiece| MassPiece { moments: piece.moments.stretched(by), ..piece.clone() };
        Self {
            pieces: self.pieces.iter().map(piece).collect(),
            outflow: self.outflow.stretched(self.reference, by),
            ..self.clone()
        }
    }

    /// Returns the sphere that replaces the body.
    pub(crate) const fn ball(&self) -> &Rotor {
        &self.ball
    }

    /// Returns the index of the piece just after a time.
    fn place(&self, time: f64) -> usize {
        self.pieces.partition_point(|piece| piece.start <= time).saturating_sub(1)
    }

    fn piece(&self, time: f64) -> &MassPiece {
        // The first piece begins at −∞, so there is always one.
        &self.pieces[self.place(time)]
    }

    /// Returns the first breakpoint after `time`; infinite if there is none.
    pub(crate) fn next_change(&self, time: f64) -> f64 {
        self.pieces.get(self.place(time) + 1).map_or(f64::INFINITY, |piece| piece.start)
    }

    /// True if mass moves suddenly inside the body at this time, so that I ω is conserved and ω is
    /// not.
    pub(crate) fn keeps_momentum(&self, time: f64) -> bool {
        let piece = self.piece(time);
        piece.start == time && piece.jump == Some(Jump::Internal)
    }
}

impl MassRates {
    /// Returns the rates of mass, first moments and second moments about a point.
    fn moments(&self, body: &MassProperties<Body>, reference: Position<Body>) -> Moments {
        let d = (body.center_of_mass() - reference).to_array();
        Moments::of_rates(body.mass(), d, self)
    }
}

/// Checks one row.
///
/// # Errors
/// [`MotionError::MassHistory`] for a number that is not finite, and for a rod.
fn require_row(row: &MassRow) -> Result<(), MotionError> {
    let [least, _, greatest] = row.body.principal().moments();
    let finite = row.rates.is_none_or(|rates| {
        let of_inertia: f64 = rates.inertia.iter().sum();
        (rates.mass + of_inertia + rates.center_of_mass.norm()).is_finite()
    });
    if !row.time.is_finite() || !finite {
        return Err(wrong(row.time, "has a row with a number that is not finite"));
    }
    if !(least > THIN * greatest) {
        return Err(wrong(row.time, "has a body without inertia about some axis"));
    }
    Ok(())
}

/// Classifies the jump between two sets of moments.
///
/// # Errors
/// [`MotionError::MassHistory`] if the mass increases, or if the leaving part is not a physical
/// body.
fn jump_between(time: f64, from: Moments, to: Moments) -> Result<Option<Jump>, MotionError> {
    if from == to {
        return Ok(None);
    }
    let lost = from.minus(&to);
    if lost.mass().abs() <= SAME_MASS * from.mass() {
        return Ok(Some(Jump::Internal));
    }
    if lost.mass() < 0.0 {
        return Err(wrong(time, "gains mass with unknown motion"));
    }
    if !lost.is_part_of(&from) {
        return Err(wrong(time, "loses mass that is not a physical body"));
    }
    Ok(Some(Jump::Separation))
}

const fn wrong(time: f64, why: &'static str) -> MotionError {
    MotionError::MassHistory { time, why }
}
