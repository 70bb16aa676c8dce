//! Mass properties that change with time, as they are prescribed: what burns, drains, is thrown off or unfolds.
//!
//! With I about the centre of mass C of what is in the body at the time, along body axes,
//!
//! d(I ω)/dt + ω × I ω = N − Σ µₖ [ρₖ × (ω × ρₖ) + Gₖ ω]
//!
//! where mass leaves through exit k at the rate µₖ, at ρₖ from C. The last sum is the jet damping: what leaves takes angular momentum with it. Gₖ is what the
//! width of the exit adds, ¼ a² (1 + n nᵀ) for a disc of radius a across n. About a pivot, I and ρₖ are from there.
//!
//! # Derivation
//! H is the angular momentum about C of what is in a volume that is fixed in the body. About a point of space where C happens to be,
//! dH/dt + ċ_s × P = N − Σ µₖ ρₖ × vₖ, with ċ_s the velocity of C in space, P the momentum in the volume and vₖ the velocity of what leaves. By continuity
//! P = M ċ_s + Σ µₖ ρₖ, so that dH/dt = N − Σ µₖ ρₖ × (vₖ − ċ_s), and vₖ − ċ_s = ω × ρₖ + uₖ − ċ, with uₖ relative to the body and ċ the velocity of C in it.
//! H = I ω + h, with h the angular momentum of the flow relative to the body.
//!
//! # Assumptions
//! - The mass flow is prescribed, and so is the thrust: −Σ µₖ ρₖ × (uₖ − ċ) is a torque like any other, to be given as one.
//! - h = 0: the flow inside neither whirls nor goes round C. It is so if the gas runs along a line through C, or symmetrically about one.
//! - What has not left turns with the body: no slosh.
//!
//! # Jumps
//! Two rows of one time are a jump. If mass goes (a stage that is dropped), each part keeps the ω that it has: there is no torque between them. If the mass is the
//! same (an arm that unfolds at once), the angular momentum is kept, and ω is not.
//!
//! # Sources
//! Thomson, Introduction to Space Dynamics (1961), §7.8 (jet damping); Eke, Wang, J. Appl. Mech. 62 (1995) 1031 and Eke, Mao, Mech. Res. Commun. 29 (2002)
//! 189 (control volumes fixed in a body; cylinders that burn). The term ċ is left out there, as C moves along the axis of the exit.

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

/// Mass properties at a time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MassRow {
    /// s
    pub time: f64,
    /// What the body is then.
    pub body: MassProperties<Body>,
    /// How fast it changes, if that is known.
    pub rates: Option<MassRates>,
}

impl MassRow {
    /// What its numbers are called in tables, with their units: the tensor about the centre of mass; which sign products have is said beside a table.
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

    /// What its rates are called.
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

/// How fast mass properties change, along body axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MassRates {
    /// Ṁ, kg/s.
    pub mass: f64,
    /// ċ, m/s.
    pub center_of_mass: Velocity<Body>,
    /// İ about the centre of mass, which moves: xx, yy, zz, xy, xz, yz, kg·m²/s.
    pub inertia: [f64; 6],
}

/// The mass properties of a body as a function of time.
///
/// From row to row, mass, first moments and second moments about a point are straight, or cubic with the slopes that the rows have where both have them: so every
/// body on the way is a mixture of possible ones, and possible. Before the first row and after the last the body stays as it is there. Where straight lines stand
/// for a smooth curve, they are off by ⅛ of its second derivative times the square of the step, cubics by 1/384 of its fourth times the fourth power.
///
/// ```
/// use polhode::prelude::*;
/// use polhode::motion::{Exit, MassHistory, MassRow, Outflow};
/// // A cylinder of radius a that burns evenly from 3 kg to 1 kg in 10 s and leaves through all of its end keeps its spin: Iz = ½ M a²,
/// // d(Iz ω)/dt = −½ µ a² ω.
/// let cylinder = |time: f64| {
///     let m = 3.0 - 0.2 * time;
///     let inertia = InertiaTensor::diagonal([m * 0.85, m * 0.85, m * 0.02])?;
///     Ok::<_, polhode::body::BodyError>(MassRow { time, body: MassProperties::new(m, Position::ZERO, inertia)?, rates: None })
/// };
/// let exit = Exit { share: 1.0, position: Position::new(0.0, 0.0, -1.5), axis: Direction::new(0.0, 0.0, 1.0), radius: 0.2 };
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
    /// First and second moments are about this point, so that a place far from the origin costs no digits.
    reference: Position<Body>,
    /// In the order of time; the first from the beginning of time on.
    pieces: Vec<MassPiece>,
    outflow: Outflow,
    /// A ball of one kg·m² in the place of the body: its acceleration is the torque on it.
    ball: Rotor,
}

/// The moments from a time until the next piece.
#[derive(Clone, Debug, PartialEq)]
struct MassPiece {
    start: f64,
    epoch: f64,
    moments: Polynomial,
    /// Does mass leave? What the rounding of two rows leaves is none.
    loses_mass: bool,
    /// What happens at its start, if not everything is continuous there.
    jump: Option<Jump>,
}

impl MassPiece {
    fn is_moving(&self) -> bool {
        self.moments.0.iter().skip(1).any(|term| term.0.iter().any(|x| *x != 0.0))
    }
}

/// What happens at once.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Jump {
    /// Mass goes: ω is kept.
    Separation,
    /// Mass moves: I ω is kept.
    Internal,
}

/// Differences of mass below this part of it are rounding.
const SAME_MASS: f64 = 1e-12;

/// A least moment below this part of the greatest is that of a rod.
const THIN: f64 = 1e-12;

impl MassHistory {
    /// A body that is so at these times, of which mass leaves so. Two rows of one time are a jump.
    ///
    /// # Errors
    /// [`MotionError::MassHistory`] with the time of the row that is wrong: no rows, times that descend, more than two of one time, a rod, mass that comes, or that
    /// leaves though nothing says how, what leaves being no possible body, a cubic with impossible bodies on the way. As [`Outflow::Exits`] says of exits.
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
                return Err(wrong(after.time, "has a row that is earlier than the one before it"));
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

    /// How mass leaves.
    pub const fn outflow(&self) -> &Outflow {
        &self.outflow
    }

    /// The times at which something becomes different, s.
    pub fn times(&self) -> impl Iterator<Item = f64> + '_ {
        self.pieces.iter().skip(1).map(|piece| piece.start)
    }

    /// From when until when something changes, s, in the order of time: at one time, if it jumps.
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

    /// Does something change after one time and before another?
    pub fn changes_between(&self, from: f64, to: f64) -> bool {
        self.changes().any(|[begin, end]| begin < to && from < end)
    }

    /// What the body is just after a time, and how fast it changes.
    ///
    /// # Errors
    /// [`MotionError::MassHistory`] of a time that is not a number.
    pub fn at(&self, time: f64) -> Result<(MassProperties<Body>, MassRates), MotionError> {
        let piece = self.piece(time);
        let (moments, rates) = (piece.moments.at(time - piece.epoch), piece.moments.rate(time - piece.epoch));
        let body = moments.properties(self.reference);
        let body = body.map_err(|_| wrong(time, "is not known"))?;
        Ok((body, rates.rates(&moments)))
    }

    /// The body as it is just after a time, with the point that it turns about: its centre of mass then, or the pivot.
    ///
    /// # Errors
    /// As [`MassHistory::at`].
    pub fn rotor(&self, time: f64, pivot: Option<Position<Body>>) -> Result<Rotor, MotionError> {
        let (body, _) = self.at(time)?;
        Ok(pivot.map_or_else(|| Rotor::free(&body), |pivot| Rotor::pivoted(&body, pivot)))
    }

    /// |h|, kg·m²/s: what the flow just after a time has of angular momentum in the body if it runs straight to the exits from where mass goes, in the mean. The
    /// motion leaves it out, so that it should be small beside I ω.
    ///
    /// # Errors
    /// As [`MassHistory::at`].
    pub fn flow_momentum(&self, time: f64, pivot: Option<Position<Body>>) -> Result<f64, MotionError> {
        let (body, rates) = self.at(time)?;
        let Outflow::Exits(exits) = &self.outflow else { return Ok(0.0) };
        if !self.piece(time).loses_mass {
            return Ok(0.0);
        }
        // Mass that goes at b to an exit at ρ has μ b × ρ on its way, and (M c)˙ = −μ b.
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

    /// The same with all lengths along each axis, from a point inside, so many times as long.
    pub(crate) fn stretched(&self, by: [f64; 3]) -> Self {
        let piece = |piece: &MassPiece| MassPiece { moments: piece.moments.stretched(by), ..piece.clone() };
        Self {
            pieces: self.pieces.iter().map(piece).collect(),
            outflow: self.outflow.stretched(self.reference, by),
            ..self.clone()
        }
    }

    /// The ball that turns in place of the body.
    pub(crate) const fn ball(&self) -> &Rotor {
        &self.ball
    }

    /// Which piece is just after a time.
    fn place(&self, time: f64) -> usize {
        self.pieces.partition_point(|piece| piece.start <= time).saturating_sub(1)
    }

    fn piece(&self, time: f64) -> &MassPiece {
        // There is a first one, which begins before everything.
        &self.pieces[self.place(time)]
    }

    /// The first time after this one at which something becomes different; infinite if nothing does.
    pub(crate) fn next_change(&self, time: f64) -> f64 {
        self.pieces.get(self.place(time) + 1).map_or(f64::INFINITY, |piece| piece.start)
    }

    /// True if at this time mass moves at once within the body, so that I ω is kept and ω is not.
    pub(crate) fn keeps_momentum(&self, time: f64) -> bool {
        let piece = self.piece(time);
        piece.start == time && piece.jump == Some(Jump::Internal)
    }
}

impl MassRates {
    /// Of mass, first moments and second moments about a point.
    fn moments(&self, body: &MassProperties<Body>, reference: Position<Body>) -> Moments {
        let d = (body.center_of_mass() - reference).to_array();
        Moments::of_rates(body.mass(), d, self)
    }
}

/// # Errors
/// [`MotionError::MassHistory`] of what is not finite, and of a rod.
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

/// # Errors
/// [`MotionError::MassHistory`] if mass comes, or if what goes is no body.
fn jump_between(time: f64, from: Moments, to: Moments) -> Result<Option<Jump>, MotionError> {
    if from == to {
        return Ok(None);
    }
    let lost = from.minus(&to);
    if lost.mass().abs() <= SAME_MASS * from.mass() {
        return Ok(Some(Jump::Internal));
    }
    if lost.mass() < 0.0 {
        return Err(wrong(time, "gains mass, of which the motion is not known"));
    }
    if !lost.is_part_of(&from) {
        return Err(wrong(time, "loses what is no possible body"));
    }
    Ok(Some(Jump::Separation))
}

const fn wrong(time: f64, why: &'static str) -> MotionError {
    MotionError::MassHistory { time, why }
}
