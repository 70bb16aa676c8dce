//! Equations of motion of a rigid body in contact with a surface, over a generic number type.
//!
//! All vectors are along the axes of the body's surface, which turn with the body. A dot is the
//! rate of their components. The symbols are:
//!
//! - n: normal of the ground at the contact, towards the body;
//! - r: vector from the centre of mass to the point of contact, a function of n, as the surface is
//!   convex;
//! - v: velocity of the centre of mass;
//! - w: velocity of the ground at the contact;
//! - u = v + ω × r − w: slip;
//! - s: velocity at which the point of contact moves in space;
//! - K: curvature of the ground.
//!
//! Kinematics:
//!
//! ṅ = n × ω − K s,  ṙ = r′ṅ,  s = u + w + ṙ,
//!
//! hence (1 + r′K) s = u + w + r′(n × ω). With the contact force F and the torque τ of rolling and
//! pivoting friction,
//!
//! m (v̇ + ω × v) = F + m g,  I ω̇ + ω × I ω = r × F + τ.
//!
//! Rolling: u = 0 gives v = w − ω × r, and F = m (k − ω × (ω × r) − ω̇ × r). Here
//! k = Ω × s − ω × ṙ − g, with Ω the angular velocity of the ground. As
//! r × (ω × (ω × r)) = ω × (r × (ω × r)), these are Euler's equations about the point of contact,
//!
//! J ω̇ = −ω × J ω + m r × k + τ,  J = I + m (r² 1 − r rᵀ).
//!
//! Sliding: F = N (n − µ u/|u|) − c u. N follows from the constraint (v + ω × r) · n = 0 at all
//! times.
//!
//! Sources: the equations are those of Newton and Euler with the constraint inserted. A. V.
//! Borisov, I. S. Mamaev, Regul. Chaotic Dyn. 7 (2002) 177, has them for rolling on a plane or a
//! sphere. D. J. Montana, Int. J. Robot. Res. 7 (1988) 17, has the kinematics of contact.
//! `fixtures/contact.toml` compares them with an independent formulation.

use super::model::{GroundForm, Model};
use crate::math::algebra::{Components, Field};

/// Mode of contact, which selects the equations.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Regime {
    /// The point of contact has the velocity of the ground.
    Rolling,
    /// The point of contact slips.
    Sliding,
}

/// State of pivoting friction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Pivot {
    /// The body turns about the normal with this sign, against friction.
    Turning(f64),
    /// Friction prevents turning about the normal.
    Held,
}

/// Indices of the variables: e₁ and e₃ (first and third axis of the ground, along the axes of the
/// body's surface); ω; place of the contact; v if sliding; work of friction and of the ground.
pub(super) const AXES: usize = 0;
pub(super) const OMEGA: usize = 6;
pub(super) const PLACE: usize = 9;
pub(super) const VELOCITY: usize = 12;

/// Kinematic and dynamic quantities computed from the variables.
#[derive(Clone, Copy, Debug)]
pub(super) struct Kinetics<S> {
    /// Three axes of the ground, along those of the surface.
    pub(super) axes: [Components<S>; 3],
    pub(super) normal: Components<S>,
    pub(super) omega: Components<S>,
    /// Vector r from the centre of mass to the contact.
    pub(super) arm: Components<S>,
    /// Velocity v of the centre of mass.
    pub(super) velocity: Components<S>,
    /// Angular velocity of the body relative to the ground.
    pub(super) relative: Components<S>,
    /// Slip u.
    pub(super) slip: Components<S>,
    /// Velocity s of the point of contact in space.
    pub(super) trace: Components<S>,
    /// Determinant of 1 + r′K: 1 on a plane, and zero if the curvatures of body and ground agree.
    pub(super) fit: S,
    /// Velocity w of the ground at the contact.
    pub(super) carried: Components<S>,
    /// Normal force N.
    pub(super) normal_force: S,
    /// Tangential force F − N n.
    pub(super) tangential: Components<S>,
    /// Torque τ of rolling and pivoting friction.
    pub(super) resistance: Components<S>,
    /// Torque τₚ of pivoting friction if it holds the body.
    pub(super) holding: S,
    /// Divisor of the normal force; 1 for a point mass. It must be positive while the body slides.
    pub(super) inertance: S,
    pub(super) omega_rate: Components<S>,
    pub(super) velocity_rate: Components<S>,
}

impl Model {
    /// Returns the number of variables.
    pub(super) const fn count(regime: Regime) -> usize {
        match regime {
            Regime::Rolling => VELOCITY + 2,
            Regime::Sliding => VELOCITY + 5,
        }
    }

    /// True if the rates depend on the place of the contact.
    pub(super) fn depends_on_place(&self) -> bool {
        self.ground != GroundForm::Plane || self.turns()
    }

    fn turns(&self) -> bool {
        self.turning != 0.0
    }

    fn resists(&self) -> bool {
        self.rolling != 0.0 || self.pivoting != 0.0
    }

    /// Returns the rates of the variables, and the quantities computed from them.
    pub(super) fn rates<S: Field>(
        &self,
        one: S,
        y: &[S],
        regime: Regime,
        pivot: Pivot,
    ) -> (Vec<S>, Kinetics<S>) {
        let at = self.kinetics(one, y, regime, pivot);
        let mut rates = axes_rates(y).concat();
        rates.extend(at.omega_rate.0);
        rates.extend(self.place_rate(one, &at));
        if regime == Regime::Sliding {
            rates.extend(at.velocity_rate.0);
        }
        rates.extend(at.powers());
        (rates, at)
    }

    /// Returns the rates of the place of the contact.
    #[inline(always)]
    pub(super) fn place_rate<S: Field>(&self, one: S, at: &Kinetics<S>) -> [S; 3] {
        let [e1, e2, e3] = at.axes;
        let [a, b, c] = [e1.dot(at.trace), e2.dot(at.trace), e3.dot(at.trace)];
        match self.ground {
            GroundForm::Plane => [a, b, one.times(0.0)],
            // x = −ρ n
            GroundForm::Sphere { radius } => Components([a, b, c]).scaled(-1.0 / radius).0,
            GroundForm::Cylinder { radius } => [a.times(-1.0 / radius), b.times(-1.0 / radius), c],
        }
    }

    /// Computes the quantities of the contact from the variables.
    pub(super) fn kinetics<S: Field>(&self, one: S, y: &[S], regime: Regime, pivot: Pivot) -> Kinetics<S> {
        self.kinetics_of::<S, false>(one, y, regime, pivot)
    }

    /// True if the body rolls on a plane at rest, without resistance.
    pub(super) fn is_plain(&self, regime: Regime) -> bool {
        regime == Regime::Rolling && self.ground == GroundForm::Plane && !self.turns() && !self.resists()
    }

    /// Computes [`Model::kinetics`]. `PLAIN` tells the compiler that the case is
    /// [plain](Model::is_plain).
    #[inline(always)]
    pub(super) fn kinetics_of<S: Field, const PLAIN: bool>(
        &self,
        one: S,
        y: &[S],
        regime: Regime,
        pivot: Pivot,
    ) -> Kinetics<S> {
        let (ground, regime) =
            if PLAIN { (GroundForm::Plane, Regime::Rolling) } else { (self.ground, regime) };
        let (turns, resists) = (!PLAIN && self.turns(), !PLAIN && self.resists());
        let vector = |k: usize| Components([y[k], y[k + 1], y[k + 2]]);
        let constant = |[x, y, z]: [f64; 3]| Components([one.times(x), one.times(y), one.times(z)]);
        let (e1, e3, omega) = (vector(AXES), vector(AXES + 3), vector(OMEGA));
        let e2 = e3.cross(e1);
        let in_body = |[a, b, c]: [S; 3]| e1 * a + e2 * b + e3 * c;

        let Components(place) = vector(PLACE);
        let (n, position) = ground.normal_and_position(one, place);
        let n = if ground == GroundForm::Plane { e3 } else { in_body(n) };
        let form = self.surface.at(one, n);
        let r = constant(self.offset) + form.from_center;
        let zero = constant([0.0; 3]);
        let turning = if turns { e3.scaled(self.turning) } else { zero };
        let carried = if turns { turning.cross(in_body(position)) } else { zero };
        let [gx, gy, gz] = self.gravity;
        let mut gravity = e3.scaled(gz);
        if gx != 0.0 || gy != 0.0 {
            gravity = e1.scaled(gx) + e2.scaled(gy) + gravity;
        }
        let across = n.cross(omega);
        let velocity = match regime {
            Regime::Rolling => carried - omega.cross(r),
            Regime::Sliding => vector(VELOCITY),
        };
        let slip = match regime {
            Regime::Rolling => zero,
            Regime::Sliding => velocity + omega.cross(r) - carried,
        };

        // (1 + r′K) s = u + w + r′(n × ω)
        let moved = slip + carried;
        let (trace, arm_rate, fit) = match ground {
            GroundForm::Plane => {
                let arm_rate = form.change(across);
                (moved + arm_rate, arm_rate, one)
            }
            GroundForm::Sphere { .. } | GroundForm::Cylinder { .. } => {
                let column = |e: [f64; 3]| {
                    let e = constant(e);
                    e + form.change(ground.curved(e, e3))
                };
                let columns = [column([1.0, 0.0, 0.0]), column([0.0, 1.0, 0.0]), column([0.0, 0.0, 1.0])];
                let (trace, fit) = solved(columns, moved + form.change(across));
                (trace, trace - moved, fit)
            }
        };
        let tilting = -ground.curved(trace, e3);

        // The torque of rolling and pivoting friction is N (−µᵣ ω_t/|ω_t| − µₚ ω_n/|ω_n|); the
        // torque that holds the body is τₚ n.
        let relative = omega - turning;
        let mut resisting = zero;
        if let (true, Pivot::Turning(sense)) = (resists && self.pivoting != 0.0, pivot) {
            resisting = resisting - n.scaled(self.pivoting * sense);
        }
        if resists && self.rolling != 0.0 {
            let along = relative - n * relative.dot(n);
            resisting = resisting - along * (one.times(self.rolling) / along.dot(along).root());
        }

        let mass = self.mass;
        let centripetal = omega.cross(omega.cross(r));
        // ω̇ = a + N b + τₚ c and N = N₀ − m n · (ω̇ × r). The inertia is about the contact if
        // rolling, and about the centre of mass if sliding.
        let (inertia, k, viscous, free) = match regime {
            Regime::Rolling => {
                let mut k = -(omega.cross(arm_rate) + gravity);
                if turns {
                    k = k + turning.cross(trace);
                }
                let about_contact = self.inertia_about_contact(one, r);
                let gyroscopic = about_contact.image(omega).cross(omega);
                let inertia = Inverse::of(one, about_contact, self.axis_inertia.is_some());
                let free = inertia.of_vector(gyroscopic + r.cross(k).scaled(mass));
                (inertia, k - centripetal, zero, free)
            }
            Regime::Sliding => {
                let viscous = slip.scaled(-self.viscous);
                // Acceleration of the point of contact without contact force and torque, with the
                // opposite sign.
                let k = -(centripetal + omega.cross(arm_rate) + gravity + viscous.scaled(1.0 / mass));
                let gyroscopic = omega.image(&self.inertia).cross(omega);
                let inertia = Inverse::known(one, self);
                let free = inertia.of_vector(gyroscopic + r.cross(viscous));
                (inertia, k, viscous, free)
            }
        };
        let mut direction = if regime == Regime::Sliding { n } else { zero };
        if regime == Regime::Sliding && self.kinetic != 0.0 {
            direction = direction - slip * (one.times(self.kinetic) / slip.dot(slip).root());
        }
        let (mut omega_rate, mut inertance, mut holding) = (free, one, one.times(0.0));
        let mut normal_force = n.dot(k - free.cross(r)).times(mass);
        // Rolling without resistance does not depend on N.
        if regime == Regime::Sliding || resists {
            let by_normal = inertia.of_vector(r.cross(direction) + resisting);
            inertance = one + n.dot(by_normal.cross(r)).times(mass);
            if regime == Regime::Sliding {
                normal_force = normal_force - moved.dot(tilting).times(mass);
            }
            normal_force = normal_force / inertance;
            omega_rate = free + by_normal * normal_force;
            if pivot == Pivot::Held {
                // (ω − Ω) · n remains zero.
                let by_torque = inertia.of_vector(n);
                let normal_by_torque = -(n.dot(by_torque.cross(r)).times(mass) / inertance);
                let by_torque = by_torque + by_normal * normal_by_torque;
                holding = -(n.dot(omega_rate) + relative.dot(tilting)) / n.dot(by_torque);
                normal_force = normal_force + normal_by_torque * holding;
                omega_rate = omega_rate + by_torque * holding;
            }
        }
        let force = match regime {
            Regime::Rolling => (k - omega_rate.cross(r)).scaled(mass),
            Regime::Sliding => direction * normal_force + viscous,
        };
        let velocity_rate = force.scaled(1.0 / self.mass) + gravity - omega.cross(velocity);
        Kinetics {
            axes: [e1, e2, e3],
            normal: n,
            omega,
            arm: r,
            velocity,
            relative,
            slip,
            trace,
            fit,
            carried,
            normal_force,
            tangential: force - n * normal_force,
            resistance: resisting * normal_force + n * holding,
            holding,
            inertance,
            omega_rate,
            velocity_rate,
        }
    }

    /// Returns I + m (r² 1 − r rᵀ).
    #[inline(always)]
    fn inertia_about_contact<S: Field>(&self, one: S, r: Components<S>) -> Symmetric<S> {
        let (square, Components([x, y, z])) = (r.dot(r), r);
        let element =
            |[i, j]: [usize; 2], steiner: S| one.times(self.inertia[i][j]).plus_multiple(steiner, self.mass);
        Symmetric {
            diagonal: [
                element([0, 0], square - x * x),
                element([1, 1], square - y * y),
                element([2, 2], square - z * z),
            ],
            beside: [element([1, 2], -(y * z)), element([0, 2], -(x * z)), element([0, 1], -(x * y))],
        }
    }
}

/// Returns ė₁ and ė₃: ė = e × ω for vectors fixed in space.
#[inline(always)]
pub(super) fn axes_rates<S: Field>(y: &[S]) -> [[S; 3]; 2] {
    let vector = |k: usize| Components([y[k], y[k + 1], y[k + 2]]);
    [vector(AXES).cross(vector(OMEGA)).0, vector(AXES + 3).cross(vector(OMEGA)).0]
}

impl<S: Field> Kinetics<S> {
    /// Returns the power of friction and the power of the ground.
    #[inline(always)]
    pub(super) fn powers(&self) -> [S; 2] {
        let (force, torque) = (self.tangential, self.resistance);
        [
            force.dot(self.slip) + torque.dot(self.relative),
            force.dot(self.carried) + torque.dot(self.omega - self.relative),
        ]
    }
}

impl Kinetics<f64> {
    /// Converts the variables of rolling to those of sliding with this slip.
    pub(super) fn sliding(&self, rolling: &[f64], slip: Components<f64>) -> Vec<f64> {
        let mut variables = rolling[..VELOCITY].to_vec();
        variables.extend((self.carried - self.omega.cross(self.arm) + slip).0);
        variables.extend_from_slice(&rolling[rolling.len() - 2..]);
        variables
    }

    /// Returns u̇ in space, along the axes of the surface.
    pub(super) fn slip_rate(&self, model: &Model) -> Components<f64> {
        let [_, _, e3] = self.axes;
        let turning = e3.scaled(model.turning);
        let moved = self.slip + self.carried;
        let arm_rate = self.trace - moved;
        self.velocity_rate
            + self.omega.cross(self.velocity)
            + self.omega_rate.cross(self.arm)
            + self.omega.cross(self.omega.cross(self.arm) + arm_rate)
            - turning.cross(self.trace)
    }
}

/// Symmetric matrix: its diagonal, and its off-diagonal elements yz, xz, xy, each opposite to the
/// diagonal element of the same index.
#[derive(Clone, Copy)]
struct Symmetric<S> {
    diagonal: [S; 3],
    beside: [S; 3],
}

impl<S: Field> Symmetric<S> {
    #[inline(always)]
    fn image(&self, v: Components<S>) -> Components<S> {
        let ([xx, yy, zz], [yz, xz, xy]) = (self.diagonal, self.beside);
        let row = |row: [S; 3]| S::sum_of_products(row, v.0);
        Components([row([xx, xy, xz]), row([xy, yy, yz]), row([xz, yz, zz])])
    }
}

/// Inverse J⁻¹ as a factor and rows. For a body whose axis z keeps its direction it is
/// z zᵀ/(z · J z).
struct Inverse<S> {
    factor: S,
    rows: [Components<S>; 3],
}

impl<S: Field> Inverse<S> {
    /// Inverts by cofactors.
    #[inline(always)]
    fn of(one: S, j: Symmetric<S>, is_about_axis: bool) -> Self {
        let ([xx, yy, zz], [yz, xz, xy]) = (j.diagonal, j.beside);
        if is_about_axis {
            let zero = one.times(0.0);
            let none = Components([zero; 3]);
            return Self { factor: one / zz, rows: [none, none, Components([zero, zero, one])] };
        }
        let minor = S::difference_of_products;
        let [a, b, c] = [minor([yy, zz], [yz, yz]), minor([xz, yz], [xy, zz]), minor([xy, yz], [xz, yy])];
        let [d, e, f] = [minor([xx, zz], [xz, xz]), minor([xy, xz], [xx, yz]), minor([xx, yy], [xy, xy])];
        let factor = one / S::sum_of_products([xx, xy, xz], [a, b, c]);
        Self { factor, rows: [Components([a, b, c]), Components([b, d, e]), Components([c, e, f])] }
    }

    /// Returns the inverse of the inertia about the centre of mass.
    #[inline(always)]
    fn known(one: S, model: &Model) -> Self {
        let rows = match model.axis_inertia {
            Some(about) => [[0.0; 3], [0.0; 3], [0.0, 0.0, 1.0 / about]],
            None => model.inverse_inertia,
        };
        let row = |[a, b, c]: [f64; 3]| Components([one.times(a), one.times(b), one.times(c)]);
        Self { factor: one, rows: [row(rows[0]), row(rows[1]), row(rows[2])] }
    }

    #[inline(always)]
    fn of_vector(&self, b: Components<S>) -> Components<S> {
        let [x, y, z] = self.rows;
        Components([x.dot(b), y.dot(b), z.dot(b)]) * self.factor
    }
}

/// Solves x₁ a + x₂ b + x₃ c = d by Cramer's rule; also returns the determinant.
#[inline(always)]
fn solved<S: Field>([a, b, c]: [Components<S>; 3], d: Components<S>) -> (Components<S>, S) {
    let (bc, ca, ab) = (b.cross(c), c.cross(a), a.cross(b));
    let determinant = a.dot(bc);
    (Components([d.dot(bc) / determinant, d.dot(ca) / determinant, d.dot(ab) / determinant]), determinant)
}
