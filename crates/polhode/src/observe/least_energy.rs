//! Where internal friction brings a tumbling body to rest in itself.

use crate::math::frame::Body;
use crate::math::vector::Direction;
use crate::motion::solve::free::FreeMotion;

/// The spin of least energy for the angular momentum that a body has: about the axis of greatest moment.
///
/// A body that bends, sloshes or carries a damper turns kinetic energy into heat while it tumbles, but nothing inside it can
/// change L. At given L the energy T = ½ Σ Lⱼ²/iⱼ is least where all of L is along the axis of greatest moment i3: T_min =
/// L²/2i3. There no part is accelerated in the body any more and the loss ends. So undisturbed asteroids spin about
/// their shortest axis, and Explorer 1, spun about its longest, went into a *flat spin*. Only the body's shape
/// decides how far a tumbler is from this end; how long it takes is a matter of its inside, and not known here.
///
/// T/T_min lies between 1 and i3/i1, and is i3/i2 on the separatrix, which a body in long-axis mode has to cross.
///
/// Where the greatest moment is not one axis's alone the end is not unique either: of a prolate body or a rod
/// it is some axis across the symmetry axis, and `axis` is one of them ([`crate::body::PrincipalFrame`] says which); a body with three
/// equal moments keeps its spin and loses nothing.
///
/// # Accuracy
/// A few ε of each value: what is left to lose has its own digits, however little it is, as T − L²/2i3 =
/// ½ Σ iⱼ ωⱼ² (i3 − iⱼ)/i3. Of moments that differ by little, which are not given along the body's own axes, it has the digits
/// of their difference.
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
/// Landau & Lifshitz, Mechanics, §37, for T at given L; Bracewell & Garriott, Nature 182 (1958) 760, for satellites.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LeastEnergySpin {
    /// The axis of greatest moment, in the body. The spin may end along it or against it.
    pub axis: Direction<Body>,
    /// |L|/i3, rad/s.
    pub rate: f64,
    /// T_min = L²/2i3, J.
    pub kinetic_energy: f64,
    /// T − T_min ≥ 0, J: what turns into heat.
    pub energy_lost: f64,
    /// T/T_min, 1 … i3/i1: E/E0 of those who observe tumblers.
    pub energy_ratio: f64,
}

impl LeastEnergySpin {
    /// The spin at the end of a motion's dissipation; `None` at rest.
    pub fn of(motion: &FreeMotion) -> Option<Self> {
        let (moments, amplitudes) = (motion.labelled_moments(), motion.amplitudes());
        let momentum = motion.momentum().norm();
        let greatest = moments.iter().copied().fold(0.0, f64::max);
        let rate = momentum / greatest;
        let kinetic_energy = 0.5 * momentum * rate;
        // ω = (a1, 0, a3) is a point of every motion's path.
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
