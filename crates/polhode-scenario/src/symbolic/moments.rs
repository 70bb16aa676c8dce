//! Uniform shapes in symbols: measure, centroid and second moments.

use polhode_algebra::{Matrix, Rational, RationalFunction, Vector};

/// Distribution of the mass of a uniform shape, along its own axes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Moments {
    /// Volume, area or length; `None` where it is not a rational function.
    pub measure: Option<RationalFunction>,
    /// Centroid c, from the origin of the shape.
    pub centroid: Vector,
    /// Second moments ∫ (x − c)ᵢ (x − c)ⱼ dm / m.
    pub second: Matrix,
}

type Value = RationalFunction;

/// Returns n/d.
fn fraction(n: i64, d: i64) -> Value {
    Rational::new(n, d).map_or_else(Value::zero, Value::from)
}

/// Returns a sum of products k a b.
fn squares(terms: &[(i64, &Value, &Value)]) -> Value {
    terms.iter().fold(Value::zero(), |sum, (k, a, b)| sum + Value::from(*k) * (*a * *b))
}

fn over(a: &Value, b: &Value) -> Value {
    a.over(b).unwrap_or_else(Value::zero)
}

impl Moments {
    /// Creates the moments of a shape whose centroid is its origin.
    fn centered(measure: Value, [x, y, z]: [Value; 3]) -> Self {
        let diagonal = [x, y, z];
        let second = Matrix::from_elements(|i, j| if i == j { diagonal[i].clone() } else { Value::zero() });
        Self { measure: Some(measure), centroid: Vector::zero(), second }
    }

    /// Returns the moments of a box of edges a, b, c: ∫ x² dm = m a²/12.
    pub fn of_box(edges: &[Value; 3]) -> Self {
        let [a, b, c] = edges;
        Self::centered(a * b * c, edges.each_ref().map(|edge| edge * edge * fraction(1, 12)))
    }

    /// Returns the moments of the six faces of a box: with S = ab + bc + ca, ∫ x² dm =
    /// m a² [(ab + ca)/12 + bc/4]/S.
    pub fn of_box_shell(edges: &[Value; 3]) -> Self {
        let [a, b, c] = edges;
        let half = squares(&[(1, a, b), (1, b, c), (1, c, a)]);
        let along = |a: &Value, b: &Value, c: &Value| {
            over(&(a * a * (squares(&[(1, a, b), (1, c, a), (3, b, c)]) * fraction(1, 12))), &half)
        };
        Self::centered(&half * Value::from(2), [along(a, b, c), along(b, c, a), along(c, a, b)])
    }

    /// Returns the moments of a thin plate of edges a, b across z: ∫ x² dm = m a²/12.
    pub fn of_plate([a, b]: &[Value; 2]) -> Self {
        let second = [a, b].map(|edge| edge * edge * fraction(1, 12));
        let [x, y] = second;
        Self::centered(a * b, [x, y, Value::zero()])
    }

    /// Returns the moments of a ball of radius R with a hollow of radius r:
    /// ∫ x² dm = (m/5) (R⁵ − r⁵)/(R³ − r³).
    pub fn of_ball(outer: &Value, inner: &Value, pi: &Value) -> Self {
        let difference = |n| power(outer, n) - power(inner, n);
        let square = over(&difference(5), &difference(3)) * fraction(1, 5);
        Self::centered(fraction(4, 3) * pi * difference(3), [square.clone(), square.clone(), square])
    }

    /// Returns the moments of a sphere's surface: ∫ x² dm = m r²/3.
    pub fn of_sphere_shell(r: &Value, pi: &Value) -> Self {
        let square = r * r * fraction(1, 3);
        Self::centered(Value::from(4) * pi * r * r, [square.clone(), square.clone(), square])
    }

    /// Returns the moments of an ellipsoid with semi-axes a, b, c: ∫ x² dm = m a²/5.
    pub fn of_ellipsoid(semi_axes: &[Value; 3], pi: &Value) -> Self {
        let [a, b, c] = semi_axes;
        let volume = fraction(4, 3) * pi * a * b * c;
        Self::centered(volume, semi_axes.each_ref().map(|a| a * a * fraction(1, 5)))
    }

    /// Returns the moments of a cylinder of radius R and length l along z with a bore of radius r:
    /// ∫ x² dm = m (R² + r²)/4, ∫ z² dm = m l²/12.
    pub fn of_cylinder(outer: &Value, inner: &Value, l: &Value, pi: &Value) -> Self {
        let across = squares(&[(1, outer, outer), (1, inner, inner)]) * fraction(1, 4);
        let volume = pi * l * squares(&[(1, outer, outer), (-1, inner, inner)]);
        Self::centered(volume, [across.clone(), across, l * l * fraction(1, 12)])
    }

    /// Returns the moments of a tube's wall: ∫ x² dm = m r²/2, ∫ z² dm = m l²/12.
    pub fn of_tube(r: &Value, l: &Value, pi: &Value) -> Self {
        let across = r * r * fraction(1, 2);
        Self::centered(Value::from(2) * pi * r * l, [across.clone(), across, l * l * fraction(1, 12)])
    }

    /// Returns the moments of a tube's wall with two disks as ends.
    pub fn of_closed_tube(r: &Value, l: &Value, pi: &Value) -> Self {
        let end = |z: Value| Self::of_disk(r, pi).moved(&Vector([Value::zero(), Value::zero(), z]));
        Self::combined(&[Self::of_tube(r, l, pi), end(l * fraction(1, 2)), end(l * fraction(-1, 2))])
    }

    /// Returns the moments of a thin disk across z: ∫ x² dm = m r²/4.
    pub fn of_disk(r: &Value, pi: &Value) -> Self {
        let across = r * r * fraction(1, 4);
        Self::centered(pi * r * r, [across.clone(), across, Value::zero()])
    }

    /// Returns the moments of a thin rod along z: ∫ z² dm = m l²/12.
    pub fn of_rod(l: &Value) -> Self {
        Self::centered(l.clone(), [Value::zero(), Value::zero(), l * l * fraction(1, 12)])
    }

    /// Returns the moments of a cone from radius a at z = 0 to b at z = h. With q = a² + ab + b²:
    /// V = πhq/3, z̄ = h (a² + 2ab + 3b²)/4q, ∫ z² dm = m h² (a² + 3ab + 6b²)/10q,
    /// ∫ x² dm = (3m/20) (a⁴ + a³b + a²b² + ab³ + b⁴)/q.
    pub fn of_cone(a: &Value, b: &Value, h: &Value, pi: &Value) -> Self {
        let form = |k: [i64; 3]| squares(&[(k[0], a, a), (k[1], a, b), (k[2], b, b)]);
        let q = form([1, 1, 1]);
        let fourth = (0..=4).fold(Value::zero(), |sum, n| sum + power(a, 4 - n) * power(b, n));
        let height = over(&(h * form([1, 2, 3])), &(Value::from(4) * &q));
        let across = over(&(Value::from(3) * fourth), &(Value::from(20) * &q));
        let along = over(&(h * h * form([1, 3, 6])), &(Value::from(10) * &q)) - &height * &height;
        let volume = fraction(1, 3) * pi * h * q;
        Self::centered(volume, [across.clone(), across, along]).moved(&Vector([
            Value::zero(),
            Value::zero(),
            height,
        ]))
    }

    /// Returns the moments of a cone's wall from radius a at z = 0 to b at z = h:
    /// z̄ = h (a + 2b)/3(a + b), ∫ x² dm = m (a² + b²)/4,
    /// ∫ (z − z̄)² dm = m h² (a² + 4ab + b²)/18(a + b)².
    pub fn of_cone_shell(a: &Value, b: &Value, h: &Value) -> Self {
        let sum = a + b;
        let height = over(&(h * (a + b * Value::from(2))), &(Value::from(3) * &sum));
        let across = squares(&[(1, a, a), (1, b, b)]) * fraction(1, 4);
        let form = squares(&[(1, a, a), (4, a, b), (1, b, b)]);
        let along = over(&(h * h * form), &(Value::from(18) * &sum * &sum));
        let wall = Self::centered(Value::one(), [across.clone(), across, along]);
        // The area has the root of h² + (a − b)².
        Self { measure: None, ..wall.moved(&Vector([Value::zero(), Value::zero(), height])) }
    }

    /// Returns the moments of a cylinder between two half balls, whose centroids are 3r/8 beyond its
    /// ends, with ∫ x² dm = m r²/5 and ∫ (z − z̄)² dm = 19 m r²/320.
    pub fn of_capsule(r: &Value, l: &Value, pi: &Value) -> Self {
        let [across, along] = [fraction(1, 5), fraction(19, 320)].map(|k| r * r * k);
        let half_ball = Self::centered(fraction(2, 3) * pi * power(r, 3), [across.clone(), across, along]);
        let height = l * fraction(1, 2) + r * fraction(3, 8);
        let end = |z: Value| half_ball.clone().moved(&Vector([Value::zero(), Value::zero(), z]));
        Self::combined(&[Self::of_cylinder(r, &Value::zero(), l, pi), end(height.clone()), end(-height)])
    }

    /// Returns the moments of a torus about z, with the ring radius R and the tube radius a:
    /// ∫ x² dm = m (R²/2 + 3a²/8), ∫ z² dm = m a²/4.
    pub fn of_torus(ring: &Value, tube: &Value, pi: &Value) -> Self {
        let across = squares(&[(4, ring, ring), (3, tube, tube)]) * fraction(1, 8);
        let volume = Value::from(2) * pi * pi * ring * tube * tube;
        Self::centered(volume, [across.clone(), across, tube * tube * fraction(1, 4)])
    }

    /// Returns the moments of a triangle of a length along z, 0 for a plate:
    /// Sᵢⱼ = (m/12) Σ (p − c)ᵢ (p − c)ⱼ over its corners.
    pub fn of_triangle(corners: &[[Value; 2]; 3], length: &Value) -> Self {
        let corners = corners.each_ref().map(|[x, y]| Vector([x.clone(), y.clone(), Value::zero()]));
        let mut moments = Self::of_corners(&corners, &fraction(1, 12));
        moments.second.0[2][2] = length * length * fraction(1, 12);
        moments
    }

    /// Returns the moments of a tetrahedron: Sᵢⱼ = (m/20) Σ (p − c)ᵢ (p − c)ⱼ over its corners.
    pub fn of_tetrahedron(corners: &[Vector; 4]) -> Self {
        Self::of_corners(corners, &fraction(1, 20))
    }

    /// Returns the moments of a simplex, from the share of the mass at each corner. The measure is
    /// the magnitude of a determinant, whose sign is unknown.
    fn of_corners(corners: &[Vector], share: &Value) -> Self {
        let count = i64::try_from(corners.len()).unwrap_or(1);
        let sum = corners.iter().fold(Vector::zero(), |sum, corner| sum.plus(corner));
        let centroid = sum.scaled(&fraction(1, count));
        let second = corners.iter().fold(Matrix::zero(), |sum, corner| {
            let d = corner - &centroid;
            sum + Matrix::outer(&d, &d).scaled(share)
        });
        Self { measure: None, centroid, second }
    }

    /// Returns the moments of the shape moved by d.
    #[must_use]
    fn moved(self, d: &Vector) -> Self {
        Self { centroid: self.centroid + d, ..self }
    }

    /// Returns the moments of several shapes of the same density.
    fn combined(shapes: &[Self]) -> Self {
        let measures: Vec<Value> = shapes.iter().filter_map(|shape| shape.measure.clone()).collect();
        let measure = measures.iter().fold(Value::zero(), |sum, measure| sum + measure);
        let shares: Vec<Value> = measures.iter().map(|part| over(part, &measure)).collect();
        let all = || shapes.iter().zip(&shares);
        let centroid = all().fold(Vector::zero(), |sum, (shape, share)| sum + shape.centroid.scaled(share));
        let second = all().fold(Matrix::zero(), |sum, (shape, share)| {
            let d = &shape.centroid - &centroid;
            sum + (&shape.second + &Matrix::outer(&d, &d)).scaled(share)
        });
        Self { measure: Some(measure), centroid, second }
    }

    /// Returns the inertia tensor about the centroid of a mass m: Iᵢⱼ = m (δᵢⱼ Σ Sₖₖ − Sᵢⱼ).
    pub fn tensor(&self, mass: &Value) -> Matrix {
        (Matrix::identity().scaled(&self.second.trace()) - &self.second).scaled(mass)
    }
}

fn power(value: &Value, exponent: i32) -> Value {
    value.pow(exponent).unwrap_or_else(Value::zero)
}
