//! Taylor's method: the motion of a step as a power series in time, from the equations of motion.
//!
//! The equations contain only products, so coefficient n + 1 of every unknown follows from the
//! coefficients up to n. Let q be the rotation since the start of the step. In principal axes
//!
//! i1 ω̇1 = (i2 − i3) ω2 ω3 + N1 …,  q̇ = ½ q ∘ ω,  K̇ = N + K × ω,  Ẇ = N · ω
//!
//! K is the angular impulse ∫ N dt in the rotating axes, and W the work; they are used as checks.
//! The same series is the dense output. With wheels of angular momentum h and with internal
//! friction, L = I ω + h. The axes then rotate at Ω = ω + α L × ω, and I ω̇ = L × Ω + N − ḣ.

mod acting;
mod base;
mod batch;
mod body_resolved;
mod cosine;
mod function;
pub(in crate::motion) mod length;
mod many;
mod one;
mod pair;
mod recurrence;
mod row;
mod scalar;
mod stepper;
mod sums;
mod torque;
mod unit_product;
mod variations;

pub(in crate::motion) use acting::Acting;
pub(in crate::motion) use batch::{BatchBody, advance};
pub(super) use stepper::Taylor;

use body_resolved::BodyResolved;
use length::{order, reach, remainder};
use pair::Pair;
use recurrence::{
    ATTITUDE, Coefficient, EquationConstants, GENERAL, Layout, Motion, Recurrence, WITH_FIXED_VECTOR,
    WITH_ORBIT,
};
use row::{Row, Series, TERMS, Vectors};
use sums::{OneBody, SeriesSums};
use torque::{Componentwise, Decomposition, Forcing, Known, Quadratic, StepStart, Tape, row};

use super::piece::Piece;
use crate::math::machine::{Machine, Work, in_vectors};
use crate::math::number::Number;
use crate::motion::model::torque::polynomial::JointVector;

/// Series of all unknowns over one step: of one body, or of one body per lane.
#[derive(Clone, Debug)]
struct Expansion<N = f64> {
    moments: Row<N>,
    /// 1/i; zero for an axis without inertia.
    inverses: Row<N>,
    /// True if there is an axis without inertia.
    is_thin: bool,
    /// Quantities that are expanded together: see [`recurrence`].
    layout: Layout,
    terms: EquationConstants<N>,
    motion: Box<Motion<N>>,
    /// Low word of ω at the start of the step.
    low: Row<N>,
    /// Torques that are linear or quadratic in ω and in a vector u; u is expanded together with the
    /// rotation.
    quadratic: Option<Box<Quadratic<N>>>,
    /// Torques that depend on time alone.
    forcing: Option<Box<Forcing<N>>>,
    /// Torques that are one function of all components of ω.
    componentwise: Option<Box<Componentwise<N>>>,
    /// All other torques, as a graph.
    tape: Option<Box<Tape<N>>>,
    /// Wheels and internal friction, if there are any.
    inside: Option<Box<Internal<N>>>,
    /// Series needed in addition to the recurrence, if there are any.
    beside: Option<Box<SeparateSeries<N>>>,
    evidence: Option<Box<Evidence<N>>>,
    order: usize,
    /// log₂ of the step length divided by the radius of convergence.
    reach: f64,
}

/// Separate series of ω, of u and of the torque, for torques that are not part of the recurrence.
#[derive(Clone, Debug)]
struct SeparateSeries<N> {
    omega: Vectors<N>,
    joint: Vectors<N>,
    torque: Series<N>,
}

impl<N: Number> SeparateSeries<N> {
    fn all(zero: N) -> Box<Self> {
        Box::new(Self { omega: Vectors::all(zero), joint: Vectors::all(zero), torque: Series::all(zero) })
    }
}

/// Angular impulse in the rotating axes, and work, component by component.
#[derive(Clone, Debug)]
struct Evidence<N> {
    impulse: BodyResolved<N>,
    work: Series<N>,
}

/// Series for wheels and internal friction.
#[derive(Clone, Debug)]
struct Internal<N> {
    /// h at the start of the step, and ḣ.
    wheels: [Row<N>; 2],
    /// Σ α of the energy sinks.
    sink: N,
    /// L = I ω + h.
    momentum: Series<N>,
    /// L × ω.
    bending: Series<N>,
    /// Angular velocity Ω of the axes.
    turning: Vectors<N>,
    /// −ḣ · ω − α |L × ω|², component by component.
    power: Series<N>,
}

/// Change of the motion from the start of the step to a time.
#[derive(Clone, Copy, Debug)]
struct Increment<N = f64> {
    /// Change of ω, principal axes.
    omega: Row<N>,
    /// Rotation minus the identity: (w − 1, x, y, z).
    turn: Row<N>,
    /// ∫ N dt since the start of the step, along the principal axes at its end.
    impulse: [N; 3],
    work: N,
}

impl<N: Number> Expansion<N> {
    /// Creates the series for bodies with torques of this kind. [`Expansion::set`] must follow for
    /// each lane.
    fn of(zero: N, piece: &Piece<'_>, torques: &Decomposition, tolerance: f64, evidence: bool) -> Box<Self> {
        let order = order(tolerance);
        let none = Row::splat(zero);
        let evidence = evidence
            .then(|| Box::new(Evidence { impulse: BodyResolved::all(zero), work: Series::all(zero) }));
        let mut expansion = Box::new(Self {
            moments: none,
            inverses: none,
            is_thin: false,
            layout: ATTITUDE,
            terms: EquationConstants::none(zero),
            motion: all_zero(zero),
            low: none,
            quadratic: None,
            forcing: None,
            componentwise: None,
            tape: None,
            inside: None,
            beside: None,
            evidence,
            order,
            reach: reach(order, remainder(tolerance)),
        });
        expansion.act(piece, torques);
        expansion
    }

    /// Allocates the series for the kinds of torques that act from now on.
    fn act(&mut self, piece: &Piece<'_>, torques: &Decomposition) {
        let zero = self.zero();
        let Decomposition { quadratic, joint, forcing, graph } = torques;
        self.quadratic =
            quadratic.as_ref().map(|torque| Box::new(Quadratic::of(zero, torque, joint.as_deref())));
        self.forcing = forcing.as_ref().map(|graph| Box::new(Forcing::of(zero, graph)));
        let is_plain = is_plain(piece);
        let graph = graph.as_deref();
        let componentwise = graph.filter(|_| is_plain).and_then(|graph| Componentwise::of(zero, graph));
        self.componentwise = componentwise.map(Box::new);
        self.tape =
            graph.filter(|_| self.componentwise.is_none()).map(|graph| Box::new(Tape::of(zero, graph)));
        self.layout = match joint.as_deref() {
            _ if !is_plain => GENERAL,
            None => ATTITUDE,
            Some(JointVector::Fixed(_)) => WITH_FIXED_VECTOR,
            Some(JointVector::Circular(_)) => WITH_ORBIT,
        };
        // Discards the series of torques that have ended.
        let has_beside =
            self.layout == GENERAL || self.tape.is_some() || self.evidence.is_some() || self.is_thin;
        self.beside = has_beside.then(|| SeparateSeries::all(zero));
        self.terms = EquationConstants::none(zero);
        if let Some(evidence) = &mut self.evidence {
            evidence.impulse = BodyResolved::all(zero);
        }
        self.inside = (!is_plain).then(|| {
            Box::new(Internal {
                wheels: [Row::splat(zero); 2],
                sink: zero,
                momentum: Series::all(zero),
                bending: Series::all(zero),
                turning: Vectors::all(zero),
                power: Series::all(zero),
            })
        });
    }

    /// Sets the body of a lane, and what acts on it from now on.
    fn set(&mut self, lane: usize, piece: &Piece<'_>, torques: &Decomposition) {
        let [i1, i2, i3] = piece.rotor.principal().moments();
        let over = |numerator: f64, i: f64| if i == 0.0 { 0.0 } else { numerator / i };
        let inverses = Row([over(1.0, i1), over(1.0, i2), over(1.0, i3), 0.0]);
        self.moments.put(lane, Row([i1, i2, i3, 0.0]));
        self.inverses.put(lane, inverses);
        if i1 == 0.0 {
            self.is_thin = true;
            self.beside.get_or_insert_with(|| SeparateSeries::all(self.moments.0[0].like(0.0)));
        }
        // With wheels and friction, [`Internal`] computes ω̇.
        if self.inside.is_none() {
            let ratios = Row([over(i2 - i3, i1), over(i3 - i1, i2), over(i1 - i2, i3), 0.0]);
            self.terms.ratios.put(lane, ratios);
        }
        let Decomposition { quadratic, joint, forcing, graph } = torques;
        if let (Some(series), Some(torque)) = (&mut self.quadratic, quadratic) {
            let terms = (self.layout != GENERAL).then_some(&mut self.terms);
            series.set(lane, torque, joint.as_deref(), inverses, terms);
        }
        if let (Some(series), Some(graph)) = (&mut self.forcing, forcing) {
            series.set(lane, graph, piece.rotor);
        }
        if let (Some(tape), Some(graph)) = (&mut self.tape, graph) {
            tape.set(lane, graph, piece.rotor);
        }
        if let (Some(torque), Some(graph)) = (&mut self.componentwise, graph) {
            torque.set(lane, graph, piece.rotor, inverses);
        }
        if let Some(inside) = &mut self.inside {
            inside.sink.put(lane, piece.sink);
        }
    }

    fn zero(&self) -> N {
        self.moments.0[0].like(0.0)
    }

    /// Returns the torque about an axis without inertia, if it is not zero. Only a rod has such an
    /// axis, and it is principal axis 1.
    fn unbalanced(&self, lane: usize) -> Option<f64> {
        let torque = self.beside.as_ref()?.torque[0].0[0].lane(lane);
        let inverse = self.inverses.0[0].lane(lane);
        (inverse == 0.0 && torque != 0.0).then_some(torque)
    }

    /// Returns true if no torque contributes work or impulse.
    fn is_free(&self) -> bool {
        self.quadratic.is_none()
            && self.forcing.is_none()
            && self.componentwise.is_none()
            && self.tape.is_none()
            && self.inside.is_none()
    }

    /// Starts a step.
    #[inline(always)]
    fn start(&mut self, at: &StepStart<N>) {
        if let Some(forcing) = &mut self.forcing {
            forcing.start(at);
        }
        if let Some(tape) = &mut self.tape {
            tape.start(at);
        }
        let [one, zero] = [1.0, 0.0].map(|x| at.time.like(x));
        let none = Row::splat(zero);
        let [u, v] = self.quadratic.as_ref().and_then(|torques| torques.start(at)).unwrap_or([none; 2]);
        let turn = Row([one, zero, zero, zero]);
        let pairs = match self.layout {
            ATTITUDE => [Pair::new(turn, at.omega.pure()); 2],
            WITH_ORBIT => [Pair::new(turn, v), Pair::new(at.omega, u)],
            _ => [Pair::new(turn, u), Pair::new(at.omega, at.omega.cycled())],
        };
        self.motion[0].set::<GENERAL>(pairs);
        // Wheels and friction use only the high word of ω.
        self.low = if self.inside.is_some() { none } else { at.omega_low };
    }

    /// Sets the angular momentum of the wheels at the start of a step of a lane.
    fn start_wheels(&mut self, lane: usize, time: f64, piece: &Piece<'_>) {
        if let Some(inside) = &mut self.inside {
            let wheels = [row(piece.wheel_momentum(time)), row(piece.motor_torque())];
            for (place, wheels) in inside.wheels.iter_mut().zip(wheels) {
                place.put(lane, wheels);
            }
            if let Some(tape) = &mut self.tape {
                tape.start_wheels(lane, wheels);
            }
        }
    }

    /// Expands the motion about the start of the step.
    #[inline(always)]
    fn expand<M: Recurrence<N = N>>(&mut self, s: M) {
        if let Some(forcing) = &mut self.forcing {
            let (motion, order) = (&*self.motion, self.order);
            s.apart(
                #[inline(always)]
                |s| forcing.expand(s, motion, order),
            );
        }
        match self.layout {
            ATTITUDE => self.expand_motion::<M, ATTITUDE>(s),
            WITH_FIXED_VECTOR => self.expand_motion::<M, WITH_FIXED_VECTOR>(s),
            WITH_ORBIT => self.expand_motion::<M, WITH_ORBIT>(s),
            _ => self.expand_motion::<M, GENERAL>(s),
        }
        if self.evidence.is_some() && !self.is_free() {
            s.apart(
                #[inline(always)]
                |s| self.account(s),
            );
        }
    }

    /// Expands the motion, in one of the layouts.
    #[inline(always)]
    fn expand_motion<M: Recurrence<N = N>, const LAYOUT: Layout>(&mut self, s: M) {
        let none = Row::splat(self.zero());
        let has_others = LAYOUT == GENERAL || self.tape.is_some();
        let mut more = self.more::<M, LAYOUT>(s, 0).unwrap_or(none);
        let (omega, mut terms, with_linear) = (self.omega_at(0), &self.terms, &mut None);
        if let Some(torque) = &mut self.componentwise {
            let (constant, columns) = torque.start(omega);
            more = more + constant;
            let [a, b, c] = self.terms.of_omega;
            let of_omega = [a + columns[0], b + columns[1], c + columns[2]];
            terms = with_linear.insert(EquationConstants { of_omega, has_omega: true, ..self.terms });
        }
        let jacobian = s.jacobian::<LAYOUT>(&self.motion, terms);
        let mut newest = s.first::<LAYOUT>(&jacobian, &self.motion, terms, [self.low, more]);
        let (mut previous, mut rest) = (newest, self.componentwise.is_some().then_some(none));
        for n in 1..self.order {
            if has_others {
                self.extend_torques(s, n - 1);
                let [x, y] = newest;
                self.motion[n].set::<LAYOUT>([s.unpack(x), s.unpack(y)]);
            }
            let mut more = self.more::<M, LAYOUT>(s, n);
            if let Some(rest) = rest {
                more = Some(more.map_or(rest, |more| more + rest));
            }
            let next = s.next::<LAYOUT>(&jacobian, &mut self.motion, n, [previous, newest], more);
            (previous, newest) = (newest, next);
            if rest.is_some() {
                rest = self.extend_componentwise(s, n);
            }
        }
        let [x, y] = newest;
        self.motion[self.order].set::<LAYOUT>([s.unpack(x), s.unpack(y)]);
        if self.is_thin && LAYOUT != GENERAL {
            self.find_torque(s, 0);
        }
    }

    /// Computes coefficient n of a componentwise torque; see [`Componentwise::extend`].
    #[inline(always)]
    fn extend_componentwise<M: Recurrence<N = N>>(&mut self, s: M, n: usize) -> Option<Row<N>> {
        let omega = self.omega_at(n);
        let torque = self.componentwise.as_mut()?;
        Some(s.apart(
            #[inline(always)]
            |_| torque.extend(n, omega),
        ))
    }

    /// Computes coefficient n of the terms of ω̇ that are not in the recurrence, if there are any.
    #[inline(always)]
    fn more<M: Recurrence<N = N>, const LAYOUT: Layout>(&mut self, s: M, n: usize) -> Option<Row<N>> {
        if LAYOUT == GENERAL || self.tape.is_some() {
            return Some(self.other_acceleration(s, n));
        }
        forced(self.forcing.as_deref(), self.inverses, n)
    }

    /// Computes coefficient n of these terms, with a graph, wheels or friction.
    #[inline(always)]
    fn other_acceleration<M: Recurrence<N = N>>(&mut self, s: M, n: usize) -> Row<N> {
        let (none, omega, u) = (Row::splat(self.zero()), self.omega_at(n), self.motion[n].x.second());
        let Some(SeparateSeries { omega: series, torque: place, joint }) = self.beside.as_deref_mut() else {
            return none;
        };
        series.set(n, omega);
        let (mut rate, mut linear) = (none, none);
        if let (Some(quadratic), GENERAL) = (&self.quadratic, self.layout) {
            joint.set(n, u);
            rate = quadratic.acceleration(n, u, omega);
            linear = quadratic.torque(s, n, joint, omega);
        }
        let turning = if let Some(inside) = &mut self.inside {
            rate = rate + inside.extend(s, n, self.moments, self.inverses, series);
            &inside.turning
        } else {
            &*series
        };
        if self.layout == GENERAL {
            self.motion[n].turning = Pair::new(turning.rows.at(n), none);
        }
        let known = Known { s, omega: series, turning, motion: &self.motion };
        let mut torque = self.tape.as_mut().map_or(none, |tape| {
            known.apart(
                #[inline(always)]
                |known| tape.coefficient(n, known),
            )
        });
        if let Some(forcing) = &self.forcing {
            torque = torque + forcing.at(n);
        }
        place.set(n, torque + linear);
        rate + self.inverses * torque
    }

    /// Computes the additional series that torques need for coefficient n + 1.
    #[inline(always)]
    fn extend_torques<M: Recurrence<N = N>>(&mut self, s: M, n: usize) {
        let (Some(SeparateSeries { omega, .. }), Some(tape)) = (self.beside.as_deref(), &mut self.tape)
        else {
            return;
        };
        let turning = self.inside.as_ref().map_or(omega, |inside| &inside.turning);
        let known = Known { s, omega, turning, motion: &self.motion };
        known.apart(
            #[inline(always)]
            |known| tape.extend(n, known),
        );
    }

    #[inline(always)]
    fn omega_at(&self, n: usize) -> Row<N> {
        if self.layout == ATTITUDE { self.motion[n].x.second().imaginary() } else { self.motion[n].y.first() }
    }

    /// Computes coefficient n of ω and of the torque, without wheels and friction.
    #[inline(always)]
    fn find_torque<M: Recurrence<N = N>>(&mut self, s: M, n: usize) {
        let (omega, Coefficient { x, y, .. }) = (self.omega_at(n), self.motion[n]);
        let Some(SeparateSeries { omega: series, torque, joint }) = self.beside.as_deref_mut() else {
            return;
        };
        series.set(n, omega);
        joint.set(n, if self.layout == WITH_ORBIT { y.second() } else { x.second() });
        let known = self.quadratic.as_ref().map(|quadratic| quadratic.torque(s, n, joint, omega));
        let others = self.tape.as_ref().map(|tape| tape.torque_at(n));
        let others = others.or_else(|| self.componentwise.as_ref().map(|torque| torque.at(n)));
        let forced = self.forcing.as_ref().map(|forcing| forcing.at(n));
        if let Some(sum) = known.into_iter().chain(others).chain(forced).reduce(|a, b| a + b) {
            torque.set(n, sum);
        }
    }

    /// Computes the series of impulse and work.
    #[inline(always)]
    fn account<M: Recurrence<N = N>>(&mut self, s: M) {
        let none = Row::splat(self.zero());
        for n in 0..self.order {
            if self.layout != GENERAL {
                self.find_torque(s, n);
            }
            let Some(SeparateSeries { omega, torque, .. }) = self.beside.as_deref() else { return };
            let (turning, power) = match &self.inside {
                Some(inside) => (&inside.turning, inside.power.at(n)),
                None => (omega, none),
            };
            let Some(Evidence { impulse, work }) = self.evidence.as_deref_mut() else { return };
            impulse.extend(s, n, &turning.rows, torque.at(n));
            let power = power + s.product(torque, &omega.rows, n);
            work.set(n + 1, power.over(n + 1));
        }
    }

    /// Returns the longest step for which the series are valid. Their last terms alone do not show
    /// this limit.
    #[inline(always)]
    fn reach(&self) -> N {
        let endless = self.zero().like(f64::INFINITY);
        self.tape.as_ref().map_or(endless, |tape| tape.reach(endless))
    }

    /// Returns the change of the motion from the start of the step to the time h.
    #[inline(always)]
    fn at<M: SeriesSums<N = N>>(&self, s: M, h: N) -> Increment<N> {
        let (p, zero) = (self.order, self.zero());
        let x = s.pair_increment(&self.motion, |c| &c.x, p, h);
        let omega = if self.layout == ATTITUDE {
            x.second().imaginary()
        } else {
            s.pair_increment(&self.motion, |c| &c.y, p, h).first()
        };
        let mut sum = Increment { omega: omega.vector(), turn: x.first(), impulse: [zero; 3], work: zero };
        if let (Some(evidence), false) = (&self.evidence, self.is_free()) {
            let [a, b, c, _] = s.increment(evidence.impulse.series(), p, h).0;
            let [x, y, z, w] = s.increment(&evidence.work, p, h).0;
            sum.impulse = [a, b, c];
            sum.work = (x + y) + (z + w);
        }
        sum
    }
}

/// Returns coefficient n of f(t)/I, if there is such a torque.
#[inline(always)]
fn forced<N: Number>(forcing: Option<&Forcing<N>>, inverses: Row<N>, n: usize) -> Option<Row<N>> {
    forcing.map(
        #[inline(always)]
        |forcing| inverses * forcing.at(n),
    )
}

/// Returns true without wheels and friction.
fn is_plain(piece: &Piece<'_>) -> bool {
    piece.rotor.wheels().is_empty() && piece.sink == 0.0
}

fn decomposed(piece: &Piece<'_>) -> Decomposition {
    Decomposition::of(piece.rotor, piece.acting(), is_plain(piece))
}

/// Allocates zeros on the heap. A copy of some kilobytes would take a noticeable part of a short
/// run.
fn all_zero<N: Number>(zero: N) -> Box<Motion<N>> {
    let motion = vec![Coefficient::all(zero); TERMS].into_boxed_slice();
    motion.try_into().unwrap_or_else(|_| Box::new([Coefficient::all(zero); TERMS]))
}

/// Expansion of a single body.
struct Expand<'a>(&'a mut Expansion);

impl Work for Expand<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Machine>(self, s: S) {
        self.0.expand(OneBody(s));
    }
}

/// Evaluation of all series of a single body at one time.
struct Sum<'a> {
    expansion: &'a Expansion,
    h: f64,
}

impl Work for Sum<'_> {
    type Output = Increment;

    #[inline(always)]
    fn run<S: Machine>(self, s: S) -> Increment {
        self.expansion.at(OneBody(s), self.h)
    }
}

impl Expansion {
    fn of_one(piece: &Piece<'_>, torques: &Decomposition, tolerance: f64, evidence: bool) -> Box<Self> {
        let mut expansion = Self::of(0.0, piece, torques, tolerance, evidence);
        expansion.set(0, piece, torques);
        expansion
    }

    fn expand_about(&mut self, start: &StepStart) {
        self.start(start);
        in_vectors(Expand(self));
    }

    fn after(&self, h: f64) -> Increment {
        in_vectors(Sum { expansion: self, h })
    }
}

impl<N: Number> Internal<N> {
    /// Returns coefficient n of (L × Ω − ḣ)/I, and computes those of Ω and of the power.
    #[inline(always)]
    fn extend<M: SeriesSums<N = N>>(
        &mut self,
        s: M,
        n: usize,
        moments: Row<N>,
        inverses: Row<N>,
        omega: &Vectors<N>,
    ) -> Row<N> {
        let none = Row::splat(self.sink.like(0.0));
        let [h, rate] = self.wheels;
        let wheels = match n {
            0 => h,
            1 => rate,
            _ => none,
        };
        self.momentum.set(n, (moments * omega.rows.at(n) + wheels).vector());
        let bending = s.cross(&self.momentum, &omega.rows, n);
        self.bending.set(n, bending);
        self.turning.set(n, omega.rows.at(n) + Row::splat(self.sink) * bending);
        let reaction = if n == 0 { rate } else { none };
        let torque = s.cross(&self.momentum, &self.turning.rows, n) - reaction;
        let loss = s.product(&self.bending, &self.bending, n) * Row::splat(self.sink);
        self.power.set(n, none - rate * omega.rows.at(n) - loss);
        inverses * torque
    }
}
