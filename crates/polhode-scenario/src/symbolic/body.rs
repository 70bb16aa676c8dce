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

/// Part of a body.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SymbolicPart {
    /// Name in messages.
    pub name: String,
    /// Mass m.
    pub mass: RationalFunction,
    /// Centre of mass, body axes.
    pub center: Vector,
    /// Inertia tensor about the centre of mass, along the axes of the part.
    pub own: Matrix,
    /// Rotation R from the axes of the part to those of the body, if it is not 1.
    pub rotation: Option<Matrix>,
    /// Particles of the part; empty for a shape.
    pub particles: Vec<SymbolicParticle>,
}

/// Particle of a body.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SymbolicParticle {
    /// Mass m.
    pub mass: RationalFunction,
    /// Position, body axes.
    pub position: Vector,
}

impl SymbolicPart {
    /// Creates a part from particles.
    pub fn of_particles(name: String, particles: Vec<SymbolicParticle>) -> Option<Self> {
        let (mass, center) = center(particles.iter().map(|p| (&p.mass, &p.position)))?;
        let tensors = particles.iter().map(|p| shift(&p.mass, &(&p.position - &center)));
        let own = tensors.fold(Matrix::zero(), |sum, tensor| sum + tensor);
        Some(Self { name, mass, center, own, rotation: None, particles })
    }

    /// Returns the tensor about the centre of mass, along body axes: R I Rᵀ.
    pub fn along_body_axes(&self) -> Matrix {
        match &self.rotation {
            Some(r) => r.times(&self.own).times(&r.transposed()),
            None => self.own.clone(),
        }
    }
}

impl SymbolicBody {
    /// Returns the mass and the centre of mass c = Σ m r / M.
    pub fn center(&self) -> Option<(RationalFunction, Vector)> {
        center(self.parts.iter().map(|part| (&part.mass, &part.center)))
    }

    /// Returns the inertia tensor about a point.
    pub fn tensor_about(&self, point: &Vector) -> Matrix {
        self.parts.iter().fold(Matrix::zero(), |sum, part| {
            sum + part.along_body_axes() + shift(&part.mass, &(&part.center - point))
        })
    }

    /// Returns all particles if the body consists of particles only.
    pub fn particles(&self) -> Option<Vec<&SymbolicParticle>> {
        let is_all = self.parts.iter().all(|part| !part.particles.is_empty());
        is_all.then(|| self.parts.iter().flat_map(|part| &part.particles).collect())
    }
}

/// Returns the shift of the parallel-axis theorem, m (d² δᵢⱼ − dᵢ dⱼ): the tensor of a particle at d.
pub(crate) fn shift(mass: &RationalFunction, d: &Vector) -> Matrix {
    (Matrix::identity().scaled(&d.dot(d)) - Matrix::outer(d, d)).scaled(mass)
}

fn center<'a>(
    masses: impl Iterator<Item = (&'a RationalFunction, &'a Vector)> + Clone,
) -> Option<(RationalFunction, Vector)> {
    let mass = masses.clone().fold(RationalFunction::zero(), |sum, (mass, _)| sum + mass);
    let moment = masses.fold(Vector::zero(), |sum, (mass, position)| sum + position.scaled(mass));
    Some((mass.clone(), moment.scaled(&RationalFunction::one().over(&mass)?)))
}
