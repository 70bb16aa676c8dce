//! Quantities of a body that can be limited, and their gradients.

use polhode::body::{MassProperties, MassPropertiesGradient};
use polhode::math::{Body, Direction, Position};

use super::axis::{PrincipalAxis, chosen, determined, determined_spin, is_free, spin_moments, unit};
use super::undefined::Undefined;
use crate::estimate::Estimate;
use crate::principal::{element, moment_gradient, scaled, sum};
use crate::tensor::{ProductSign, elements};

/// Quantity of a body that can be limited.
///
/// Directions may have any length except 0.
#[derive(Clone, Debug, PartialEq)]
pub enum Measure {
    /// Mass of the body, kg.
    Mass,
    /// Coordinate of the centre of mass along a direction, from a point, m.
    Center {
        /// Direction of the coordinate.
        along: Direction<Body>,
        /// Origin of the coordinate, m.
        from: Position<Body>,
    },
    /// Distance of the centre of mass from a point, m.
    CenterFromPoint(Position<Body>),
    /// Distance of the centre of mass from a line, m.
    CenterFromLine {
        /// Point of the line, m.
        point: Position<Body>,
        /// Direction of the line.
        along: Direction<Body>,
    },
    /// Static unbalance about a line, kg·m: mass times the distance of the centre of mass from the
    /// line.
    StaticUnbalance {
        /// Point of the line, m.
        point: Position<Body>,
        /// Direction of the line.
        along: Direction<Body>,
    },
    /// Couple unbalance about a line, kg·m²: |∫ z ρ dm|, with z along the line from the point, and
    /// ρ the vector from the line.
    CoupleUnbalance {
        /// Point of the line in the reference plane of the couple, m. It may be any point if the
        /// static unbalance is 0.
        point: Position<Body>,
        /// Direction of the line.
        along: Direction<Body>,
    },
    /// Moment of inertia about an axis through a point, kg·m².
    Moment {
        /// Direction of the axis.
        axis: Direction<Body>,
        /// Point on the axis.
        about: About,
    },
    /// Product of inertia, kg·m².
    Product {
        /// Two perpendicular directions.
        axes: [Direction<Body>; 2],
        /// Sign convention of the product.
        sign: ProductSign,
        /// Reference point of the product.
        about: About,
    },
    /// Principal moment, kg·m²: 0 is the least, 2 the greatest.
    PrincipalMoment(usize),
    /// Ratio of the first of two principal moments to the second.
    PrincipalRatio([usize; 2]),
    /// Angle between a principal axis, in either sense, and a direction, 0 to π/2 rad.
    Tilt {
        /// Choice of the principal axis.
        axis: PrincipalAxis,
        /// Direction that the angle is measured from.
        from: Direction<Body>,
    },
    /// Ratio of the moment of the principal axis nearest to a direction to the greater of the other
    /// two moments.
    ///
    /// Above 1, a spin about the axis is stable even with internal energy dissipation: it is the
    /// axis of greatest moment.
    SpinRatio(Direction<Body>),
    /// (i − a)(i − b)/(a b), with the moment i of the principal axis nearest to a direction and the
    /// other two moments a and b. It is the squared ratio of the nutation rate to the spin rate.
    ///
    /// Above 0, a spin about the axis is stable without energy dissipation: i is the greatest or
    /// the least moment.
    SpinStability(Direction<Body>),
}

/// Reference point of a moment or product of inertia.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum About {
    /// Centre of mass of the body.
    CenterOfMass,
    /// Point that is fixed in the body, m.
    Point(Position<Body>),
}

/// Largest cosine of the angle of perpendicular axes.
const PERPENDICULAR: f64 = 1e-9;

type Gradient = MassPropertiesGradient<Body>;

impl Measure {
    /// Returns the unit; empty for ratios.
    pub const fn unit(&self) -> &'static str {
        match self {
            Self::Mass => "kg",
            Self::Center { .. } | Self::CenterFromPoint(_) | Self::CenterFromLine { .. } => "m",
            Self::StaticUnbalance { .. } => "kg·m",
            Self::CoupleUnbalance { .. }
            | Self::Moment { .. }
            | Self::Product { .. }
            | Self::PrincipalMoment(_) => "kg·m²",
            Self::Tilt { .. } => "rad",
            Self::PrincipalRatio(_) | Self::SpinRatio(_) | Self::SpinStability(_) => "",
        }
    }

    pub(super) fn check(&self) -> Result<(), (&'static str, f64, &'static str)> {
        let fixed = |about: &About| match about {
            About::CenterOfMass => None,
            About::Point(at) => Some(*at),
        };
        let (directions, point, axes) = match self {
            Self::Mass => (vec![], None, vec![]),
            Self::CenterFromPoint(point) => (vec![], Some(*point), vec![]),
            Self::Center { along, from: point }
            | Self::CenterFromLine { point, along }
            | Self::StaticUnbalance { point, along }
            | Self::CoupleUnbalance { point, along } => (vec![*along], Some(*point), vec![]),
            Self::Moment { axis, about } => (vec![*axis], fixed(about), vec![]),
            Self::Product { axes, about, .. } => (axes.to_vec(), fixed(about), vec![]),
            Self::PrincipalMoment(k) => (vec![], None, vec![*k]),
            Self::PrincipalRatio(both) => (vec![], None, both.to_vec()),
            Self::Tilt { axis: PrincipalAxis::Number(k), from } => (vec![*from], None, vec![*k]),
            Self::Tilt { axis: PrincipalAxis::Nearest, from: axis }
            | Self::SpinRatio(axis)
            | Self::SpinStability(axis) => (vec![*axis], None, vec![]),
        };
        if let Some(u) = directions.iter().find(|u| u.direction().is_none()) {
            return Err(("the length of a direction", u.norm(), "finite and not zero"));
        }
        if let Some(x) = point.and_then(|at| at.to_array().into_iter().find(|x| !x.is_finite())) {
            return Err(("the point", x, "finite"));
        }
        if let Some(k) = axes.iter().find(|k| **k >= 3) {
            return Err(("the number of a principal axis", *k as f64, "0, 1 or 2"));
        }
        match directions[..] {
            [u, v] if unit(u).dot(unit(v)).abs() > PERPENDICULAR => {
                Err(("the cosine of the angle of the axes", unit(u).dot(unit(v)), "0"))
            }
            _ => Ok(()),
        }
    }

    /// Returns the value for a body.
    ///
    /// # Errors
    /// [`Undefined`] if the value does not exist.
    pub fn value(&self, body: &MassProperties<Body>) -> Result<f64, Undefined> {
        let center = body.center_of_mass();
        Ok(match self {
            Self::Mass => body.mass(),
            Self::Center { along, from } => unit(*along).dot(center - *from),
            Self::CenterFromPoint(point) => (center - *point).norm(),
            Self::CenterFromLine { point, along } => across(center - *point, *along).norm(),
            Self::StaticUnbalance { point, along } => body.mass() * across(center - *point, *along).norm(),
            Self::CoupleUnbalance { point, along } => {
                let [x, y] = couple(body, *point, *along);
                x.hypot(y)
            }
            Self::Moment { axis, about } => tensor_element(body, *axis, *axis, *about),
            Self::Product { axes: [u, v], sign, about } => {
                sign.factor() * tensor_element(body, *u, *v, *about)
            }
            Self::PrincipalMoment(k) => body.principal().moments()[k % 3],
            Self::PrincipalRatio([i, j]) => {
                let moments = body.principal().moments();
                quotient(moments[i % 3], moments[j % 3])?
            }
            Self::Tilt { axis, from } => {
                let frame = body.principal();
                let (k, n) = (chosen(&frame, *axis, *from).0, unit(*from));
                if is_free(frame.symmetry(), k) {
                    return Err(Undefined::EqualMoments);
                }
                let angle = frame.axis(k).angle_to(n);
                angle.min(core::f64::consts::PI - angle)
            }
            Self::SpinRatio(axis) => {
                let [i, a, b] = spin_moments(&body.principal(), *axis).0;
                quotient(i, a.max(b))?
            }
            Self::SpinStability(axis) => {
                let [i, a, b] = spin_moments(&body.principal(), *axis).0;
                quotient(i - a, a)? * quotient(i - b, b)?
            }
        })
    }

    /// Returns the gradient with respect to the mass properties of an estimate.
    ///
    /// # Errors
    /// [`Undefined`] if the derivative does not exist.
    pub fn gradient(&self, estimate: &Estimate<Body>) -> Result<Gradient, Undefined> {
        self.value(&estimate.properties)?;
        let (body, center) = (&estimate.properties, estimate.properties.center_of_mass());
        let of_center = |by: Position<Body>| {
            let by = by.direction().ok_or(Undefined::Corner)?;
            Ok(Gradient { by_center_of_mass: by, ..NONE })
        };
        match self {
            Self::Mass => Ok(Gradient { by_mass: 1.0, ..NONE }),
            Self::Center { along, .. } => Ok(Gradient { by_center_of_mass: unit(*along), ..NONE }),
            Self::CenterFromPoint(point) => of_center(center - *point),
            Self::CenterFromLine { point, along } => of_center(across(center - *point, *along)),
            Self::StaticUnbalance { point, along } => {
                let out = across(center - *point, *along);
                let by = of_center(out)?;
                Ok(Gradient { by_mass: out.norm(), ..scaled(&by, body.mass()) })
            }
            Self::CoupleUnbalance { point, along } => {
                let [x, y] = couple(body, *point, *along);
                let size = x.hypot(y);
                if size == 0.0 {
                    return Err(Undefined::Corner);
                }
                let [u, v] =
                    across_axes(*along).map(|u| element_gradient(body, *along, u, About::Point(*point)));
                Ok(sum(&scaled(&u, -x / size), &scaled(&v, -y / size)))
            }
            Self::Moment { axis, about } => Ok(element_gradient(body, *axis, *axis, *about)),
            Self::Product { axes: [u, v], sign, about } => {
                Ok(scaled(&element_gradient(body, *u, *v, *about), sign.factor()))
            }
            Self::PrincipalMoment(k) => {
                let frame = body.principal();
                determined(&frame, k % 3).map(|()| moment_gradient(&frame, k % 3))
            }
            Self::PrincipalRatio([i, j]) => {
                let (frame, [i, j]) = (body.principal(), [i % 3, j % 3]);
                if i == j {
                    return Ok(NONE);
                }
                determined(&frame, i)?;
                determined(&frame, j)?;
                let (above, below) = (frame.moments()[i], frame.moments()[j]);
                let [above_by, below_by] = [i, j].map(|k| moment_gradient(&frame, k));
                Ok(sum(&scaled(&above_by, 1.0 / below), &scaled(&below_by, -above / (below * below))))
            }
            Self::Tilt { axis, from } => {
                let principal = estimate.principal();
                let (k, tie) = chosen(&principal.frame, *axis, *from);
                if tie {
                    return Err(Undefined::Corner);
                }
                let tilt = principal.tilt(estimate, k, *from).ok_or(Undefined::Corner)?;
                tilt.gradient.ok_or(Undefined::Corner)
            }
            Self::SpinRatio(axis) => {
                let frame = body.principal();
                let ([i, a, b], k) = determined_spin(&frame, *axis)?;
                if a == b {
                    return Err(Undefined::EqualMoments);
                }
                let (most, other) = if a > b { (a, (k + 1) % 3) } else { (b, (k + 2) % 3) };
                let [above_by, below_by] = [k, other].map(|k| moment_gradient(&frame, k));
                Ok(sum(&scaled(&above_by, 1.0 / most), &scaled(&below_by, -i / (most * most))))
            }
            Self::SpinStability(axis) => {
                // This also holds for a = b. Both enter symmetrically, and the sum of their
                // derivatives does not depend on the choice of their axes.
                let frame = body.principal();
                let ([i, a, b], k) = determined_spin(&frame, *axis)?;
                let by =
                    [(2.0 * i - a - b) / (a * b), -(i - b) * i / (a * a * b), -(i - a) * i / (a * b * b)];
                let terms = [0, 1, 2].map(|n| scaled(&moment_gradient(&frame, (k + n) % 3), by[n]));
                Ok(sum(&sum(&terms[0], &terms[1]), &terms[2]))
            }
        }
    }
}

const NONE: Gradient = Gradient { by_mass: 0.0, by_center_of_mass: Direction::ZERO, by_inertia: [0.0; 6] };

fn across(d: Position<Body>, along: Direction<Body>) -> Position<Body> {
    let n = unit(along);
    d - Position::from_array((n * n.dot(d)).to_array())
}

/// Returns two unit vectors that are perpendicular to a line and to each other.
pub(crate) fn across_axes(along: Direction<Body>) -> [Direction<Body>; 2] {
    let n = unit(along);
    let other = if n.x.abs() < 0.6 { Direction::new(1.0, 0.0, 0.0) } else { Direction::new(0.0, 1.0, 0.0) };
    let u = unit(n.cross(other));
    [u, n.cross(u)]
}

/// Returns the components of ∫ z ρ dm along [`across_axes`].
fn couple(body: &MassProperties<Body>, point: Position<Body>, along: Direction<Body>) -> [f64; 2] {
    across_axes(along).map(|u| -tensor_element(body, along, u, About::Point(point)))
}

fn quotient(above: f64, below: f64) -> Result<f64, Undefined> {
    if below == 0.0 { Err(Undefined::ZeroMoment) } else { Ok(above / below) }
}

/// Returns d² u·v − (u·d)(v·d): the contribution of a unit mass at d to uᵀ J v.
fn of_point([x, y, z]: [f64; 3], u: Direction<Body>, v: Direction<Body>) -> f64 {
    let d = Direction::new(x, y, z);
    d.dot(d) * u.dot(v) - u.dot(d) * v.dot(d)
}

fn lever(body: &MassProperties<Body>, about: About) -> [f64; 3] {
    match about {
        About::CenterOfMass => [0.0; 3],
        About::Point(point) => (body.center_of_mass() - point).to_array(),
    }
}

/// Returns uᵀ J v, with J = I + M (d² 1 − d dᵀ) and d from the point to the centre of mass.
fn tensor_element(body: &MassProperties<Body>, u: Direction<Body>, v: Direction<Body>, about: About) -> f64 {
    let (u, v) = (unit(u), unit(v));
    let by = element(u, v).by_inertia;
    let own = by.iter().zip(elements(body.inertia().matrix())).map(|(g, x)| g * x).sum::<f64>();
    own + body.mass() * of_point(lever(body, about), u, v)
}

fn element_gradient(
    body: &MassProperties<Body>,
    u: Direction<Body>,
    v: Direction<Body>,
    about: About,
) -> Gradient {
    let (u, v) = (unit(u), unit(v));
    let d = lever(body, about);
    let at = Direction::from_array(d);
    let by_center = at * (2.0 * u.dot(v)) - u * v.dot(at) - v * u.dot(at);
    Gradient { by_mass: of_point(d, u, v), by_center_of_mass: by_center * body.mass(), ..element(u, v) }
}
