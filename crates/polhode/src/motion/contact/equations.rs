//! The equations of a rigid body that touches a surface, stated once over numbers of which only the operations are known.
//!
//! All vectors are along the axes of the body's surface, which turn with the body, and a dot is the rate of their components: n the normal of the ground where
//! it is touched, towards the body; r from the centre of mass to the point of contact, a function of n, as the surface is convex; v the velocity of the
//! centre of mass; w that of the ground at the contact. The slip is u = v + ω × r − w. With s the velocity at which the point of contact moves over space, and K
//! the curvature of the ground,
//!
//! ṅ = n × ω − K s,  ṙ = r′ṅ,  s = u + w + ṙ,
//!
//! so that (1 + r′K) s = u + w + r′(n × ω). With F the force at the contact and τ the torque of rolling and pivoting friction,
//!
//! m (v̇ + ω × v) = F + m g,  I ω̇ + ω × I ω = r × F + τ.
//!
//! Rolling: u = 0 is v = w − ω × r, which gives F = m (k − ω̇ × r), k = Ω × s − ω × (ω × r + ṙ) − g, Ω the rate at which the ground turns, and with it
//! (I + m (r² 1 − r rᵀ)) ω̇ = −ω × I ω + m r × k + τ.
//!
//! Sliding: F = N (n − µ u/|u|) − c u, and N follows from (v + ω × r) · n = 0 for all time.
//!
//! Source: the laws of Newton and Euler, with the constraint put in; the same equations of what rolls on a plane or a sphere are in A. V. Borisov, I. S. Mamaev, Regul.
//! Chaotic Dyn. 7 (2002) 177, the kinematics of a contact in D. J. Montana, Int. J. Robot. Res. 7 (1988) 17. Held against another formulation:
//! `fixtures/contact.toml`.

use super::model::{GroundForm, Model, SurfaceForm};
use crate::math::algebra::{Components, Field};

/// How the body moves on the ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Regime {
    /// Its point of contact has the velocity of the ground.
    Rolling,
    /// It slips.
    Sliding,
}

/// What pivoting friction does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Pivot {
    /// The body turns about the normal in this sense, and is resisted.
    Turning(f64),
    /// It does not, as friction holds it.
    Held,
}

/// The variables: e₁ and e₃, the first and the third axis of the ground along those of the body; ω; the place of the contact; of what slides also v; and the work
/// of friction and of the ground.
pub(super) const AXES: usize = 0;
pub(super) const OMEGA: usize = 6;
pub(super) const PLACE: usize = 9;
pub(super) const VELOCITY: usize = 12;

/// What is read off the variables.
#[derive(Clone, Copy, Debug)]
pub(super) struct Kinetics<S> {
    /// The three axes of the ground, along those of the surface.
    pub(super) axes: [Components<S>; 3],
    pub(super) normal: Components<S>,
    pub(super) omega: Components<S>,
    /// From the centre of mass to the contact.
    pub(super) arm: Components<S>,
    /// v
    pub(super) velocity: Components<S>,
    /// ω of the body relative to the ground.
    pub(super) relative: Components<S>,
    /// u
    pub(super) slip: Components<S>,
    /// s
    pub(super) trace: Components<S>,
    /// The determinant of 1 + r′K: 1 on a plane, zero where body and ground fit.
    pub(super) fit: S,
    /// w
    pub(super) carried: Components<S>,
    /// N
    pub(super) normal_force: S,
    /// F − N n
    pub(super) tangential: Components<S>,
    /// τ
    pub(super) resistance: Components<S>,
    /// τₚ, of what is held.
    pub(super) holding: S,
    /// What the normal force is divided by, 1 for a point: of what slides it must be positive.
    pub(super) inertance: S,
    pub(super) omega_rate: Components<S>,
    velocity_rate: Components<S>,
}

impl Model {
    /// How many variables there are.
    pub(super) const fn count(regime: Regime) -> usize {
        match regime {
            Regime::Rolling => VELOCITY + 2,
            Regime::Sliding => VELOCITY + 5,
        }
    }

    /// The rates of the variables, and what is read off them.
    pub(super) fn rates<S: Field>(
        &self,
        one: S,
        y: &[S],
        regime: Regime,
        pivot: Pivot,
    ) -> (Vec<S>, Kinetics<S>) {
        let at = self.kinetics(one, y, regime, pivot);
        let Kinetics { axes: [e1, e2, e3], omega, trace, .. } = at;
        // ė = e × ω of what is fixed in space
        let mut rates: Vec<S> =
            [e1.cross(omega), e3.cross(omega), at.omega_rate].iter().flat_map(|v| v.0).collect();
        let in_space = [e1.dot(trace), e2.dot(trace), e3.dot(trace)];
        let [a, b, c] = in_space;
        let zero = one.times(0.0);
        rates.extend(match self.ground {
            GroundForm::Plane => [a, b, zero],
            // x = −ρ n
            GroundForm::Sphere { radius } => in_space.map(|x| x.times(-1.0 / radius)),
            GroundForm::Cylinder { radius } => [a.times(-1.0 / radius), b.times(-1.0 / radius), c],
        });
        if regime == Regime::Sliding {
            rates.extend(at.velocity_rate.0);
        }
        let force = at.tangential;
        let friction = force.dot(at.slip) + at.resistance.dot(at.relative);
        let ground = force.dot(at.carried) + at.resistance.dot(omega - at.relative);
        rates.extend([friction, ground]);
        (rates, at)
    }

    /// Reads the contact off the variables.
    pub(super) fn kinetics<S: Field>(&self, one: S, y: &[S], regime: Regime, pivot: Pivot) -> Kinetics<S> {
        let vector = |k: usize| Components([y[k], y[k + 1], y[k + 2]]);
        let constant = |v: [f64; 3]| Components(v.map(|x| one.times(x)));
        let (e1, e3, omega) = (vector(AXES), vector(AXES + 3), vector(OMEGA));
        let e2 = e3.cross(e1);
        let in_body = |[a, b, c]: [S; 3]| e1 * a + e2 * b + e3 * c;
        let fixed = |[a, b, c]: [f64; 3]| e1.scaled(a) + e2.scaled(b) + e3.scaled(c);

        let Components(place) = vector(PLACE);
        let (n, position) = self.ground.normal_and_position(one, place);
        let n = in_body(n);
        let form = self.surface.at(one, n);
        let r = constant(self.offset) + form.from_center;
        let turning = fixed(self.turning);
        let carried = turning.cross(in_body(position));
        let gravity = fixed(self.gravity);
        let across = n.cross(omega);
        let velocity = match regime {
            Regime::Rolling => carried - omega.cross(r),
            Regime::Sliding => vector(VELOCITY),
        };
        let slip = match regime {
            Regime::Rolling => constant([0.0; 3]),
            Regime::Sliding => velocity + omega.cross(r) - carried,
        };

        // (1 + r′K) s = u + w + r′(n × ω)
        let moved = slip + carried;
        let wanted = moved + form.change(across);
        let (trace, fit) = match self.ground {
            GroundForm::Plane => (wanted, one),
            GroundForm::Sphere { .. } | GroundForm::Cylinder { .. } => {
                let column = |k: usize| {
                    let e = constant([0, 1, 2].map(|i| if i == k { 1.0 } else { 0.0 }));
                    e + form.change(self.ground.curved(e, e3))
                };
                solved([column(0), column(1), column(2)], wanted)
            }
        };
        let tilting = -self.ground.curved(trace, e3);
        let arm_rate = trace - moved;

        // The torque of rolling and pivoting friction is N (−µᵣ ω_t/|ω_t| − µₚ ω_n/|ω_n|), and that which holds the body τₚ n.
        let relative = omega - turning;
        let mut resisting = constant([0.0; 3]);
        if let (true, Pivot::Turning(sense)) = (self.pivoting != 0.0, pivot) {
            resisting = resisting - n.scaled(self.pivoting * sense);
        }
        if self.rolling != 0.0 {
            let along = relative - n * relative.dot(n);
            resisting = resisting - along * (one.times(self.rolling) / along.dot(along).root());
        }

        let image = |rows: &[[f64; 3]; 3], v: Components<S>| {
            let Components([x, y, z]) = v;
            Components(rows.map(|[a, b, c]| x.times(a) + y.times(b) + z.times(c)))
        };
        let gyroscopic = -omega.cross(image(&self.inertia, omega));
        let turned = omega.cross(omega.cross(r) + arm_rate);
        let mass = self.mass;
        // ω̇ = a + N b + τₚ c, and N = (N₀ − m n · (ω̇ × r)): of what rolls with the inertia about the contact, of what slides with that about the centre.
        let (k, viscous, mut direction) = match regime {
            Regime::Rolling => {
                (turning.cross(trace) - turned - gravity, constant([0.0; 3]), constant([0.0; 3]))
            }
            Regime::Sliding => {
                // What the velocity of the point of contact would be changed by, without a force and a torque.
                let viscous = slip.scaled(-self.viscous);
                (-(turned + gravity + viscous.scaled(1.0 / mass)), viscous, n)
            }
        };
        if regime == Regime::Sliding && self.kinetic != 0.0 {
            direction = direction - slip * (one.times(self.kinetic) / slip.dot(slip).root());
        }
        let solve: &dyn Fn(Components<S>) -> Components<S> = match regime {
            Regime::Rolling => {
                let about_contact = self.inertia_about_contact(one, r);
                &move |b| self.along_axis(one, &about_contact, b)
            }
            Regime::Sliding => &|b: Components<S>| match self.axis_inertia {
                Some(about) => Components([one.times(0.0), one.times(0.0), b.0[2].times(1.0 / about)]),
                None => image(&self.inverse_inertia, b),
            },
        };
        let (free, by_normal) = match regime {
            Regime::Rolling => (solve(gyroscopic + r.cross(k).scaled(mass)), solve(resisting)),
            Regime::Sliding => (solve(gyroscopic + r.cross(viscous)), solve(r.cross(direction) + resisting)),
        };
        let inertance = one + n.dot(by_normal.cross(r)).times(mass);
        let without = n.dot(k - free.cross(r))
            - if regime == Regime::Sliding { moved.dot(tilting) } else { one.times(0.0) };
        let mut normal_force = without.times(mass) / inertance;
        let mut omega_rate = free + by_normal * normal_force;
        let mut holding = one.times(0.0);
        if pivot == Pivot::Held {
            // (ω − Ω) · n stays zero.
            let by_torque = solve(n);
            let normal_by_torque = -(n.dot(by_torque.cross(r)).times(mass) / inertance);
            let by_torque = by_torque + by_normal * normal_by_torque;
            holding = -(n.dot(omega_rate) + relative.dot(tilting)) / n.dot(by_torque);
            normal_force = normal_force + normal_by_torque * holding;
            omega_rate = omega_rate + by_torque * holding;
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

    /// I + m (r² 1 − r rᵀ)
    fn inertia_about_contact<S: Field>(&self, one: S, r: Components<S>) -> Symmetric<S> {
        let (square, Components(arm)) = (r.dot(r), r);
        let element = |i: usize, j: usize| {
            let steiner = if i == j { square - arm[i] * arm[j] } else { -(arm[i] * arm[j]) };
            steiner.times(self.mass) + one.times(self.inertia[i][j])
        };
        Symmetric {
            diagonal: [element(0, 0), element(1, 1), element(2, 2)],
            beside: [element(1, 2), element(0, 2), element(0, 1)],
        }
    }

    /// J⁻¹ b; of a body whose axis keeps its direction, z (z · b)/(z · J z).
    fn along_axis<S: Field>(&self, one: S, j: &Symmetric<S>, b: Components<S>) -> Components<S> {
        match self.axis_inertia {
            Some(_) => {
                let zero = one.times(0.0);
                Components([zero, zero, b.0[2] / j.diagonal[2]])
            }
            None => j.solved(b),
        }
    }
}

impl Kinetics<f64> {
    /// The variables of a body that slips so, from those of one that rolls.
    pub(super) fn sliding(&self, rolling: &[f64], slip: Components<f64>) -> Vec<f64> {
        let mut variables = rolling[..VELOCITY].to_vec();
        variables.extend((self.carried - self.omega.cross(self.arm) + slip).0);
        variables.extend_from_slice(&rolling[rolling.len() - 2..]);
        variables
    }

    /// u̇ in space, along the axes of the surface.
    pub(super) fn slip_rate(&self, model: &Model) -> Components<f64> {
        let [e1, e2, e3] = self.axes;
        let turning = e1.scaled(model.turning[0]) + e2.scaled(model.turning[1]) + e3.scaled(model.turning[2]);
        let moved = self.slip + self.carried;
        let arm_rate = self.trace - moved;
        self.velocity_rate
            + self.omega.cross(self.velocity)
            + self.omega_rate.cross(self.arm)
            + self.omega.cross(self.omega.cross(self.arm) + arm_rate)
            - turning.cross(self.trace)
    }
}

impl GroundForm {
    /// The normal and the point of contact, along the axes of the ground.
    fn normal_and_position<S: Field>(self, one: S, [a, b, c]: [S; 3]) -> ([S; 3], [S; 3]) {
        let zero = one.times(0.0);
        match self {
            Self::Plane => ([zero, zero, one], [a, b, zero]),
            Self::Sphere { radius } => ([a, b, c], [a, b, c].map(|x| x.times(-radius))),
            Self::Cylinder { radius } => ([a, b, zero], [a.times(-radius), b.times(-radius), c]),
        }
    }

    /// K t; `axis` is the third of the ground.
    fn curved<S: Field>(self, t: Components<S>, axis: Components<S>) -> Components<S> {
        match self {
            Self::Plane => t.scaled(0.0),
            Self::Sphere { radius } => t.scaled(1.0 / radius),
            Self::Cylinder { radius } => (t - axis * axis.dot(t)).scaled(1.0 / radius),
        }
    }
}

/// The point of a convex surface whose outer normal is −n, from its centre, and how it changes with n.
struct SurfacePoint<S> {
    from_center: Components<S>,
    change: Change<S>,
}

/// r′, a symmetric operator.
enum Change<S> {
    /// r′t = −ρ t − R/s h (h · t), with the unit vector h along the rim and s = |n × z|.
    Rim { tube: f64, along: Option<(Components<S>, S)> },
    /// r′t = −A t/d + A n (A n · t)/d³, d² = n · A n.
    Ellipsoid { squares: [f64; 3], image: Components<S>, inverse: S },
}

impl<S: Field> SurfacePoint<S> {
    fn change(&self, t: Components<S>) -> Components<S> {
        match &self.change {
            Change::Rim { tube, along } => {
                let round = t.scaled(-tube);
                along.map_or(round, |(h, radius)| round - h * (h.dot(t) * radius))
            }
            Change::Ellipsoid { squares, image, inverse } => {
                let [a, b, c] = *squares;
                let Components([x, y, z]) = t;
                let own = Components([x.times(a), y.times(b), z.times(c)]);
                (*image * (image.dot(t) * *inverse * *inverse) - own) * *inverse
            }
        }
    }
}

impl SurfaceForm {
    /// The point whose outer normal is −n, from the centre.
    pub(super) fn point<S: Field>(&self, one: S, n: Components<S>) -> Components<S> {
        self.at(one, n).from_center
    }

    fn at<S: Field>(&self, one: S, n: Components<S>) -> SurfacePoint<S> {
        let Components([x, y, z]) = n;
        match *self {
            Self::Rim { radius, tube, height } => {
                let mut from_center = n.scaled(-tube);
                let zero = one.times(0.0);
                let along = (radius != 0.0).then(|| {
                    let inverse = one / (x * x + y * y).root();
                    let (c, s) = (x * inverse, y * inverse);
                    from_center =
                        from_center - Components([c.times(radius), s.times(radius), one.times(-height)]);
                    (Components([-s, c, zero]), inverse.times(radius))
                });
                SurfacePoint { from_center, change: Change::Rim { tube, along } }
            }
            Self::Ellipsoid { squares } => {
                let [a, b, c] = squares;
                let image = Components([x.times(a), y.times(b), z.times(c)]);
                let inverse = one / n.dot(image).root();
                let from_center = -(image * inverse);
                SurfacePoint { from_center, change: Change::Ellipsoid { squares, image, inverse } }
            }
        }
    }
}

/// A symmetric matrix: its diagonal, and what is beside it, each opposite to its row.
struct Symmetric<S> {
    diagonal: [S; 3],
    beside: [S; 3],
}

impl<S: Field> Symmetric<S> {
    /// By cofactors.
    fn solved(&self, b: Components<S>) -> Components<S> {
        let ([xx, yy, zz], [yz, xz, xy]) = (self.diagonal, self.beside);
        let rows = [
            Components([yy * zz - yz * yz, xz * yz - xy * zz, xy * yz - xz * yy]),
            Components([xz * yz - xy * zz, xx * zz - xz * xz, xy * xz - xx * yz]),
            Components([xy * yz - xz * yy, xy * xz - xx * yz, xx * yy - xy * xy]),
        ];
        let determinant = Components([xx, xy, xz]).dot(rows[0]);
        Components(rows.map(|row| row.dot(b) / determinant))
    }
}

/// x with x₁ a + x₂ b + x₃ c = d, by Cramer's rule; and the determinant.
fn solved<S: Field>([a, b, c]: [Components<S>; 3], d: Components<S>) -> (Components<S>, S) {
    let (bc, ca, ab) = (b.cross(c), c.cross(a), a.cross(b));
    let determinant = a.dot(bc);
    (Components([d.dot(bc), d.dot(ca), d.dot(ab)].map(|x| x / determinant)), determinant)
}
