//! Jacobi's elliptic functions, with the integrals that the derivatives need.

/// Jacobi's elliptic functions of u, and two integrals over u.
#[derive(Clone, Copy, Debug)]
pub(super) struct Elliptic {
    pub(super) sn: f64,
    pub(super) cn: f64,
    pub(super) dn: f64,
    /// ∫ sn² du
    pub(super) square: f64,
    /// ∫ sn²/dn² du
    pub(super) quotient: f64,
}
