//! Final state of a tumbling body under internal friction.

use crate::math::frame::Body;
use crate::math::vector::Direction;
use crate::motion::solve::free::FreeMotion;

/// Spin of least energy for a given angular momentum: about the axis of largest moment.
///
/// A body that bends, sloshes or contains a damper dissipates kinetic energy while it tumbles, but
/// nothing inside it can change L. For given L, the energy T = ½ Σ Lⱼ²/iⱼ is smallest if L is along
/// the axis of largest moment i3: T_min = L²/2i3. There no part is accelerated relative to the
/// body, and the dissipation ends. Therefore undisturbed asteroids spin about their shortest axis,
/// and Explorer 1, spun about its longest axis, entered a *flat spin*. The mass properties alone
/// determine the remaining energy loss. The time that it takes depends on the interior and is not
/// computed here.
///
/// T/T_min is between 1 and i3/i1. It is i3/i2 on the separatrix, which a body in long-axis mode
/// must cross.
///
/// If the largest moment belongs to more than one axis, the final state is not unique. For a
/// prolate body or a rod it is any axis perpendicular to the symmetry axis, and `axis` is one of
/// them ([`crate::body::PrincipalFrame`] defines which). A body with three equal moments keeps its
/// spin and loses no energy.
///
/// # Accuracy
/// The relative error of each value is a few ε. The energy that remains to be lost has full
/// relative precision even if it is very small, because T − L²/2i3 = ½ Σ iⱼ ωⱼ² (i3 − iⱼ)/i3. For
/// nearly equal moments that are not given along the body's own axes, it has the precision of their
/// difference.
///
/// ```
/// use polhode::prelude::*;
/// use polhode::observe::LeastEnergySpin;
/// let omega = AngularVelocity::new(5.0, 0.0, 1e-9); // thrown about the long axis
/// let start = State { time: 0.0, attitude: Attitude::identity(), omega };
/// let motion = FreeMotion::of_moments([1.0, 2.0, 2.5], start)?;
/// let end = LeastEnergySpin::of(&motion).ok_or("at rest")?;
/// assert!((end.rate - 2.0).abs() < 1e-15 && (end.energy_ratio - 2.5).abs() < 1e-15);
/// assert!((end.energy_lost - 7.5).abs() < 1e-14); // 12.5 J − 5 J
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Source
/// Landau & Lifshitz, Mechanics, §37, for T at given L; Bracewell & Garriott, Nature 182 (1958)
/// 760, for satellites.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LeastEnergySpin {
    /// Axis of largest moment, body axes. The final spin may be along it or against it.
    pub axis: Direction<Body>,
    /// Final spin rate |L|/i3, rad/s.
    pub rate: f64,
    /// Least kinetic energy T_min = L²/2i3, J.
    pub kinetic_energy: f64,
    /// Energy to be dissipated, T − T_min ≥ 0, J.
    pub energy_lost: f64,
    /// Energy ratio T/T_min, 1 … i3/i1; called E/E0 in the asteroid literature.
    pub energy_ratio: f64,
}

impl LeastEnergySpin {
    /// Returns the final spin of a motion under dissipation; `None` at rest.
    pub fn of(motion: &FreeMotion) -> Option<Self> {
        let (moments, amplitudes) = (motion.labelled_moments(), motion.amplitudes());
        let momentum = motion.momentum().norm();
        let greatest = moments.iter().copied().fold(0.0, f64::max);
        let rate = momentum / greatest;
        let kinetic_energy = 0.5 * momentum * rate;
        // Every motion passes through ω = (a1, 0, a3).
        let lost = |k: usize| {
            let (i, w) = (moments[k], amplitudes[k]);
            0.5 * (i * w) * w * ((greatest - i) / greatest)
        };
        let energy_lost = lost(0) + lost(2);
        (kinetic_energy > 0.0).then(|| Self {
            axis: motion.principal().axis(2),
            rate,
            kinetic_energy,
            energy_lost,
            energy_ratio: 1.0 + energy_lost / kinetic_energy,
        })
    }
}
