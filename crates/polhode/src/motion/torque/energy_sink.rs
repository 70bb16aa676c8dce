//! Energy lost inside a body: L is kept, T is not.

/// Dissipation inside the body, whose angular momentum it cannot change.
///
/// With L = I ω, the box of the body turns at Ω = ω + α L × ω, so that in body axes L̇ = L × Ω: L stays where it is in space, and
/// Ṫ = −α |L × ω|² until the body spins about its axis of greatest inertia.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EnergySink {
    /// α, 1/(N·m·s).
    pub coefficient: f64,
}
