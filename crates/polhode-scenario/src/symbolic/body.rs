//! Body in symbols: its parts, and the sums over them.

use polhode_algebra::{Matrix, RationalFunction, Vector};

/// Body as the sum of its parts, along body axes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SymbolicBody {
    /// Parts in the order of the file.
    pub parts: Vec<SymbolicPart>,
    /// Fixed point of the body, if it has one.
    pub pivot: Option<Vector>,
}

/// Part of a body: a shape, as a particle at its centre of mass with a tensor of its own, or
/// particles.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SymbolicPart {
    /// Name in messages.
    pub name: String,
    /// Particles of the part.
    pub particles: Vec<SymbolicParticle>,
    /// Tensor of a shape about its centre of mass; `None` for particles.
    pub own: Option<OwnTensor>,
}

/// Particle of a body.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SymbolicParticle {
    /// Mass of the particle.
    pub mass: RationalFunction,
    /// Position, body axes.
    pub position: Vector,
}

/// Inertia tensor of a shape about its centre of mass.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OwnTensor {
    /// Tensor along the axes of the shape.
    pub tensor: Matrix,
    /// Rotation R from the axes of the shape to those of the body, if it is not 1.
    pub rotation: Option<Matrix>,
}

impl OwnTensor {
    /// Returns the tensor along body axes: R I Rᵀ.
    pub fn along_body_axes(&self) -> Matrix {
        match &self.rotation {
            Some(r) => r.times(&self.tensor).times(&r.transposed()),
            None => self.tensor.clone(),
        }
    }
}

impl SymbolicBody {
    /// Returns all particles, also those in place of shapes.
    fn all(&self) -> impl Iterator<Item = &SymbolicParticle> {
        self.parts.iter().flat_map(|part| &part.particles)
    }

    /// Returns all particles if the body consists of particles only.
    pub fn particles(&self) -> Option<Vec<&SymbolicParticle>> {
        self.parts.iter().all(|part| part.own.is_none()).then(|| self.all().collect())
    }

    /// Returns the mass M and the centre of mass c = Σ m r / M; `None` without mass.
    pub fn center(&self) -> Option<(RationalFunction, Vector)> {
        let mass = self.all().fold(RationalFunction::zero(), |sum, p| sum + &p.mass);
        let moment = self.all().fold(Vector::zero(), |sum, p| sum + p.position.scaled(&p.mass));
        let center = moment.scaled(&RationalFunction::one().over(&mass)?);
        Some((mass, center))
    }

    /// Returns the inertia tensor about a point.
    pub fn tensor_about(&self, point: &Vector) -> Matrix {
        let own = self.parts.iter().filter_map(|part| part.own.as_ref());
        let own = own.fold(Matrix::zero(), |sum, own| sum + own.along_body_axes());
        self.all().fold(own, |sum, p| sum + shift(&p.mass, &(&p.position - point)))
    }

    /// Returns an upper estimate of the number of terms in an element of the tensor about the centre
    /// of mass, M Σ m r² − (Σ m r)²; 0 for a single shape or particle, whose tensor is its own.
    pub fn central_terms(&self) -> usize {
        if self.all().count() < 2 {
            return 0;
        }
        let terms = |value: &RationalFunction| {
            if value.is_zero() {
                0
            } else {
                value.numerator().term_count() * value.denominator().term_count()
            }
        };
        let sum = |of: &dyn Fn(&SymbolicParticle) -> usize| self.all().map(of).sum::<usize>();
        let first = |k: usize| sum(&|p| terms(&p.mass) * terms(&p.position.0[k]));
        let second = |k: usize| sum(&|p| terms(&p.mass) * terms(&p.position.0[k]).pow(2));
        let largest = |of: &dyn Fn(usize) -> usize| (0..3).map(of).max().unwrap_or_default();
        let own = self.parts.iter().filter_map(|part| part.own.as_ref());
        let own: usize =
            own.map(|own| own.tensor.0.iter().flatten().map(terms).max().unwrap_or_default()).sum();
        sum(&|p| terms(&p.mass)) * (2 * largest(&second) + own) + largest(&first).pow(2)
    }
}

/// Returns the shift of the parallel-axis theorem, m (d² δᵢⱼ − dᵢ dⱼ): the tensor of a particle at d.
pub(crate) fn shift(mass: &RationalFunction, d: &Vector) -> Matrix {
    (Matrix::identity().scaled(&d.dot(d)) - Matrix::outer(d, d)).scaled(mass)
}
