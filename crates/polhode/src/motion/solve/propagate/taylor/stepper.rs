//! Adaptive Taylor integrator of one body.

use std::rc::Rc;

use super::base::ExpansionPoint;
use super::row::{Row, smaller};
use super::sums::OneBody;
use super::variations::Variations;
use super::{Acting, Expansion, Increment, decomposed};
use crate::math::frame::{Body, Principal, Space};
use crate::math::machine::{Machine, Work, in_vectors};
use crate::math::rotation::{Attitude, Rotation};
use crate::math::sum::two_sum;
use crate::math::vector::{AngularMomentum, AngularVelocity, Direction, Vector};
use crate::motion::error::MotionError;
use crate::motion::model::state::State;
use crate::motion::model::torque::TorqueModel;
use crate::motion::model::torque::parameter::ParameterKind;
use crate::motion::solve::propagate::balanced::Balanced;
use crate::motion::solve::propagate::half_turn::Cosine;
use crate::motion::solve::propagate::noise::Noise;
use crate::motion::solve::propagate::piece::Piece;
use crate::motion::solve::propagate::step_statistics::StepStatistics;

/// Adaptive Taylor steps for the motion of one body.
///
/// The series about the start of a step is kept until the next step and serves as dense output.
/// Each sum carries its rounding error.
#[derive(Debug)]
pub(in crate::motion::solve::propagate) struct Taylor<'a> {
    piece: Rc<Piece<'a>>,
    expansion: Box<Expansion>,
    /// Rotation from principal to body axes.
    to_body: Rotation<Body, Principal>,
    /// Start and end of the last step. They alternate between the two elements, so that the start
    /// of a step need not be copied.
    pack: [ExpansionPoint; 2],
    /// Index of the present point in `pack`.
    now: usize,
    /// True if the series start at the present point, so that a last step does not exist.
    is_expanded: bool,
    /// Work and impulse at the start of the last step and now, if requested.
    evidence: Option<[Balances; 2]>,
    /// Derivatives of the motion, if requested.
    variations: Option<Box<Variations<'a>>>,
    h: f64,
    omega_scale: f64,
    /// |ω| now, rad/s.
    rate: f64,
    statistics: StepStatistics,
}

/// ∫ N · ω dt and ∫ N dt. Each sum carries its rounding error.
#[derive(Clone, Copy, Debug, Default)]
struct Balances {
    work: [f64; 2],
    impulse: [[f64; 2]; 3],
}

impl<'a> Taylor<'a> {
    /// `acting`: the decomposition of the torques, if it is known.
    pub(in crate::motion::solve::propagate) fn new(
        piece: Rc<Piece<'a>>,
        acting: Option<&Acting>,
        start: State,
        tolerance: f64,
        with_evidence: bool,
    ) -> Result<Self, MotionError> {
        let own;
        let torques = match acting {
            Some(acting) => &acting.decomposition,
            None => {
                own = decomposed(&piece);
                &own
            }
        };
        let to_body = piece.rotor.principal().rotation();
        let head = ExpansionPoint::new(&start, to_body);
        let mut taylor = Self {
            expansion: Expansion::of_one(&piece, torques, tolerance, with_evidence),
            // For a body at rest, the scale of ω is the rate that the torque causes.
            omega_scale: start.omega.norm().max(torque_rate(&piece)),
            piece,
            to_body,
            pack: [head; 2],
            now: 0,
            is_expanded: false,
            evidence: with_evidence.then(Default::default),
            variations: None,
            h: 0.0,
            rate: head.rate(),
            statistics: StepStatistics::default(),
        };
        taylor.expand()?;
        Ok(taylor)
    }

    /// Continues with other acting torques.
    ///
    /// # Errors
    /// Those of [`Taylor::new`].
    pub(in crate::motion::solve::propagate) fn change(
        &mut self,
        piece: Rc<Piece<'a>>,
    ) -> Result<(), MotionError> {
        self.omega_scale = self.omega_scale.max(torque_rate(&piece));
        let torques = decomposed(&piece);
        self.expansion.act(&piece, &torques);
        self.expansion.set(0, &piece, &torques);
        if let Some(variations) = &mut self.variations {
            variations.change(&piece, self.pack[self.now].time);
        }
        self.piece = piece;
        self.expand()
    }

    /// Enables derivatives of the motion from now on, with respect to its state now, the inertia
    /// and these parameters.
    pub(in crate::motion::solve::propagate) fn differentiate(
        &mut self,
        parameters: Vec<(&'a TorqueModel, ParameterKind)>,
    ) {
        let (time, order) = (self.head().time, self.expansion.order);
        self.variations = Some(Box::new(Variations::new(&self.piece, time, order, parameters)));
    }

    /// Returns the derivatives at a time within the last step. Each column contains the derivatives
    /// of θ and ω, body axes, with respect to one quantity.
    pub(in crate::motion::solve::propagate) fn derivatives_at(&self, time: f64) -> Vec<[f64; 6]> {
        self.variations.as_ref().map(|variations| variations.at(time)).unwrap_or_default()
    }

    /// Adds the effect of a shifted switching time to the present derivatives; see
    /// [`Variations::jump`].
    pub(in crate::motion::solve::propagate) fn jump(&mut self, times: &[f64], by: [Direction<Body>; 2]) {
        if let Some(variations) = &mut self.variations {
            variations.jump(times, by);
        }
    }

    /// Returns Ω and ω̇ at a time within the last step, from what acts in it, body axes.
    pub(in crate::motion::solve::propagate) fn rates_at(&self, time: f64) -> [Direction<Body>; 2] {
        let (base, expansion) = (self.base(), &self.expansion);
        let h = time - base.time;
        let slope = (1..=expansion.order)
            .rev()
            .fold(Row::ZERO, |sum, n| expansion.omega_at(n) * Row::splat(n as f64) + sum * Row::splat(h));
        let omega = base.plus(&expansion.after(h), time).omega();
        // Ω = ω + α L × ω
        let of: Direction<Principal> = omega.as_quantity();
        let momentum: Direction<Principal> = self.piece.angular_momentum(time, omega).as_quantity();
        let bending: Direction<Principal> = momentum.cross(of) * self.piece.sink;
        let [x, y, z, _] = slope.0;
        [of + bending, Direction::new(x, y, z)].map(|v| self.to_body * v)
    }

    /// Takes one step forward, not beyond `until`.
    ///
    /// # Errors
    /// Those of [`crate::motion::solve::propagate::stepper::Stepper::step`].
    pub(in crate::motion::solve::propagate) fn step(&mut self, until: f64) -> Result<(), MotionError> {
        let expands = !self.is_expanded;
        if expands {
            self.begin();
        }
        let Self { expansion, pack: [first, second], now, h, omega_scale, .. } = self;
        let (base, head) = if *now == 0 { (&*first, second) } else { (&*second, first) };
        let time = base.time;
        let landing = in_vectors(Leap { expansion, base, head, expands, h: *h, scale: *omega_scale, until });
        if expands {
            self.is_expanded = true;
            self.statistics.evaluations += self.expansion.order as u64;
            self.require_balance()?;
        }
        self.h = landing.allowed;
        if landing.h.is_nan() {
            return Err(MotionError::NotFinite { time });
        }
        if !(time + landing.h > time) {
            return Err(MotionError::StepTooSmall { time, step: landing.h });
        }
        if landing.not_finite != 0.0 {
            return Err(MotionError::NotFinite { time });
        }
        self.now = 1 - self.now;
        self.is_expanded = false;
        if let Some([base, head]) = &mut self.evidence {
            *head = base.plus(&landing.more, self.pack[self.now].rotation());
        }
        self.omega_scale = self.omega_scale.max(landing.rate);
        self.rate = landing.rate;
        self.statistics.accepted += 1;
        if let Some(variations) = &mut self.variations {
            let base = &self.pack[1 - self.now];
            if !variations.expand(&self.expansion, &base.start(), &self.piece) {
                return Err(MotionError::NoMotionDerivatives { why: "a torque has none there", time });
            }
        }
        Ok(())
    }

    /// Returns to a time within the last step.
    pub(in crate::motion::solve::propagate) fn cut(&mut self, time: f64) {
        if time != self.head().time {
            let more = self.expansion.after(time - self.base().time);
            let head = self.base().plus(&more, time);
            self.rate = head.rate();
            if let Some([base, there]) = &mut self.evidence {
                *there = base.plus(&more, head.rotation());
            }
            self.pack[self.now] = head;
        }
    }

    /// Multiplies the length of all later steps.
    pub(in crate::motion::solve::propagate) fn stretch(&mut self, factor: f64) {
        self.expansion.reach += libm::log2(factor);
        self.h = self.expansion.step(self.omega_scale);
    }

    /// Perturbs the state at the end of the last step.
    pub(in crate::motion::solve::propagate) fn perturb(&mut self, noise: &mut Noise) {
        let (base, head) = (self.base(), self.head());
        let (before, after) = (base.omega().to_array(), head.omega().to_array());
        let [x, y, z] = noise.turn(head.time - base.time, before, after);
        let [p, q, r] = noise.rate(before, after);
        // 1 + ½ δ is the rotation by a small δ.
        let turn = Row([0.0, 0.5 * x, 0.5 * y, 0.5 * z]);
        let more = Increment { omega: Row([p, q, r, 0.0]), turn, impulse: [0.0; 3], work: 0.0 };
        self.pack[self.now] = head.plus(&more, head.time);
    }

    /// Adds a jump to ω, body axes.
    pub(in crate::motion::solve::propagate) fn kick(&mut self, more: AngularVelocity<Body>) {
        let [x, y, z] = (self.to_body.inverse() * more).to_array();
        let (omega, turn) = (Row([x, y, z, 0.0]), Row::ZERO);
        let head = self.head();
        self.pack[self.now] = head.plus(&Increment { omega, turn, impulse: [0.0; 3], work: 0.0 }, head.time);
        self.rate = self.head().rate();
    }

    /// Returns the point about which the series are.
    fn base(&self) -> &ExpansionPoint {
        &self.pack[if self.is_expanded { self.now } else { 1 - self.now }]
    }

    fn head(&self) -> &ExpansionPoint {
        &self.pack[self.now]
    }

    /// Expands the series about the present point.
    ///
    /// # Errors
    /// [`MotionError::TorqueWithoutInertia`] if nothing would balance the torque.
    fn expand(&mut self) -> Result<(), MotionError> {
        self.begin();
        self.is_expanded = true;
        self.expansion.expand_about(&self.head().start());
        self.require_balance()?;
        self.h = self.expansion.step(self.omega_scale);
        self.statistics.evaluations += self.expansion.order as u64;
        Ok(())
    }

    /// Begins a step at the end of the last one.
    fn begin(&mut self) {
        if let Some([base, head]) = &mut self.evidence {
            *base = *head;
        }
        let time = self.head().time;
        self.expansion.start_wheels(0, time, &self.piece);
    }

    fn require_balance(&self) -> Result<(), MotionError> {
        match self.expansion.unbalanced(0) {
            Some(torque) => Err(MotionError::TorqueWithoutInertia { torque, time: self.head().time }),
            None => Ok(()),
        }
    }

    /// Returns |ω|, rad/s.
    pub(in crate::motion::solve::propagate) fn rate(&self) -> f64 {
        self.rate
    }

    pub(in crate::motion::solve::propagate) fn time(&self) -> f64 {
        self.head().time
    }

    /// Returns the step that the tolerance allows, s. After a step, it is that of the last step
    /// until the next one.
    pub(in crate::motion::solve::propagate) fn next_step(&self) -> f64 {
        self.h
    }

    pub(in crate::motion::solve::propagate) fn statistics(&self) -> StepStatistics {
        self.statistics
    }

    pub(in crate::motion::solve::propagate) fn now(&self) -> Balanced {
        self.balanced(self.head(), self.evidence.map(|[_, head]| head))
    }

    /// Returns the state at a time within the last step.
    pub(in crate::motion::solve::propagate) fn at(&self, time: f64) -> Balanced {
        let more = self.expansion.after(time - self.base().time);
        let there = self.base().plus(&more, time);
        let evidence = self.evidence.map(|[base, _]| base.plus(&more, there.rotation()));
        self.balanced(&there, evidence)
    }

    /// Returns the scalar part of the rotation from a rest attitude, as a function of the time
    /// since the start of the last step.
    pub(in crate::motion::solve::propagate) fn cosine<'b>(&self, rest: Attitude) -> Cosine<'b> {
        self.expansion.cosine(0, rest, (self.base().rotation(), self.to_body))
    }

    fn balanced(&self, base: &ExpansionPoint, evidence: Option<Balances>) -> Balanced {
        let state = base.state(self.to_body);
        let Balances { work, impulse } = evidence.unwrap_or_default();
        Balanced { state, work: work[0], impulse: Vector::from_array(impulse.map(|[high, _]| high)) }
    }
}

/// Computation of a step of one body: the series, unless known, and the state at the end.
struct Leap<'a> {
    expansion: &'a mut Expansion,
    base: &'a ExpansionPoint,
    head: &'a mut ExpansionPoint,
    expands: bool,
    /// Step that the tolerance allows, if the series are known.
    h: f64,
    scale: f64,
    until: f64,
}

/// Result of a step.
struct Landing {
    /// Step that the tolerance allows.
    allowed: f64,
    h: f64,
    more: Increment,
    /// Zero if the result is finite, NaN otherwise.
    not_finite: f64,
    /// |ω|
    rate: f64,
}

impl Work for Leap<'_> {
    type Output = Landing;

    #[inline(always)]
    fn run<S: Machine>(self, s: S) -> Landing {
        let Self { expansion, base, head, expands, h, scale, until } = self;
        let allowed = if expands {
            expansion.start(&base.start());
            expansion.expand(OneBody(s));
            expansion.step(scale)
        } else {
            h
        };
        let (time, rest) = (base.time, until - base.time);
        let wanted = smaller(allowed, expansion.reach());
        let (h, end) = if wanted >= rest { (rest, until) } else { (wanted, time + wanted) };
        // The rounding of the time belongs to the step. Without it, this error dominated for a free
        // body after 100 s at 1e-15.
        let more = expansion.at(OneBody(s), end - time);
        *head = base.plus(&more, end);
        Landing { allowed, h, more, not_finite: head.not_finite(), rate: head.rate() }
    }
}

/// Returns √(N/I), rad/s, where I is the greatest moment.
pub(super) fn torque_rate(piece: &Piece<'_>) -> f64 {
    (piece.largest_torque / piece.rotor.principal().moments()[2]).sqrt()
}

impl Balances {
    fn plus(&self, more: &Increment, at_end: Rotation<Space, Principal>) -> Self {
        let impulse: AngularMomentum<Space> = at_end * AngularMomentum::from_array(more.impulse);
        let impulse = impulse.to_array();
        Self {
            work: carried(self.work, more.work),
            impulse: core::array::from_fn(|k| carried(self.impulse[k], impulse[k])),
        }
    }
}

fn carried([high, low]: [f64; 2], more: f64) -> [f64; 2] {
    let (high, low) = two_sum(high, more + low);
    [high, low]
}
