//! Splitting schemes: sequences of kicks and free flows that form a step.

/// Order of a splitting method: half the step reduces the error by the factor 2 to this power.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum SplittingOrder {
    /// Half a kick, a free flow, half a kick; one torque evaluation per step.
    Two,
    /// Six free flows and six torque evaluations per step.
    #[default]
    Four,
    /// Eleven free flows and eleven torque evaluations per step.
    Six,
}

impl SplittingOrder {
    /// All orders, ascending.
    pub const ALL: [Self; 3] = [Self::Two, Self::Four, Self::Six];

    /// Returns the order as a number: 2, 4 or 6.
    pub const fn number(self) -> u8 {
        match self {
            Self::Two => 2,
            Self::Four => 4,
            Self::Six => 6,
        }
    }
}

/// Kicks b and free flows a of one step, as fractions of the step: b₁ a₁ b₂ a₂ … a₂ b₂ a₁ b₁. The
/// sequence is symmetric.
#[derive(Clone, Debug)]
pub(super) struct Scheme {
    /// First kick, b₁.
    pub(super) first: f64,
    /// Following stages: a₁ and b₂, a₂ and b₃, …
    pub(super) stages: Vec<Stage>,
}

/// Free flow and the kick after it, as fractions of the step.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stage {
    pub(super) flow: f64,
    pub(super) kick: f64,
    /// Time of the kick, as a fraction of the step.
    pub(super) at: f64,
}

impl Scheme {
    /// Returns the scheme of an order.
    ///
    /// Kicks depend only on attitude and time, and the free flow is linear in L where it rotates
    /// the body. The order conditions are therefore those of Runge–Kutta–Nyström methods. They are
    /// fewer than for two arbitrary flows.
    ///
    /// Source: orders 4 and 6 are SRKN₆ᵇ and SRKN₁₁ᵇ of S. Blanes, P. C. Moan, J. Comput. Appl.
    /// Math. 142 (2002) 313. `tests/all/splitting.rs` proves their orders.
    pub(super) fn of(order: SplittingOrder) -> Self {
        match order {
            SplittingOrder::Two => Self::symmetric(&[0.5], &[1.0], Middle::Flow),
            SplittingOrder::Four => {
                let b = [0.082_984_406_417_405_2, 0.396_309_801_498_368, -0.039_056_304_922_348_6];
                let a = [0.245_298_957_184_271, 0.604_872_665_711_080];
                let a3 = 0.5 - (a[0] + a[1]);
                let b4 = 1.0 - 2.0 * (b[0] + b[1] + b[2]);
                Self::symmetric(&[b[0], b[1], b[2], b4], &[a[0], a[1], a3], Middle::Kick)
            }
            SplittingOrder::Six => {
                let b = [
                    0.041_464_998_518_262_4,
                    0.198_128_671_918_067,
                    -0.040_006_192_104_153_3,
                    0.075_253_984_301_580_7,
                    -0.011_511_387_420_687_9,
                ];
                let a = [
                    0.123_229_775_946_271,
                    0.290_553_797_799_558,
                    -0.127_049_212_625_417,
                    -0.246_331_761_062_075,
                    0.357_208_872_795_928,
                ];
                let b6 = 0.5 - b.iter().sum::<f64>();
                let a6 = 1.0 - 2.0 * a.iter().sum::<f64>();
                Self::symmetric(
                    &[b[0], b[1], b[2], b[3], b[4], b6],
                    &[a[0], a[1], a[2], a[3], a[4], a6],
                    Middle::Flow,
                )
            }
        }
    }

    /// Completes a step from its first half, which includes the middle element.
    fn symmetric(kicks: &[f64], flows: &[f64], middle: Middle) -> Self {
        let (kept_kicks, kept_flows) = match middle {
            Middle::Kick => (kicks.len().saturating_sub(1), flows.len()),
            Middle::Flow => (kicks.len(), flows.len().saturating_sub(1)),
        };
        let whole_kicks = kicks.iter().chain(kicks[..kept_kicks].iter().rev());
        let whole_flows = flows.iter().chain(flows[..kept_flows].iter().rev());
        let mut at = 0.0;
        let stages = whole_flows.zip(whole_kicks.skip(1)).map(|(&flow, &kick)| {
            at += flow;
            Stage { flow, kick, at }
        });
        Self { first: kicks.first().copied().unwrap_or(0.0), stages: stages.collect() }
    }
}

/// Middle element of a symmetric step.
#[derive(Clone, Copy, Debug)]
enum Middle {
    Kick,
    Flow,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_step_is_one_step_and_symmetric() {
        for (order, count) in [(SplittingOrder::Two, 1), (SplittingOrder::Four, 6), (SplittingOrder::Six, 11)]
        {
            let Scheme { first, stages } = Scheme::of(order);
            let kicks: Vec<f64> = [first].into_iter().chain(stages.iter().map(|s| s.kick)).collect();
            let flows: Vec<f64> = stages.iter().map(|s| s.flow).collect();
            assert_eq!(flows.len(), count, "{order:?}");
            for (what, parts) in [("kicks", &kicks), ("flows", &flows)] {
                assert!((parts.iter().sum::<f64>() - 1.0).abs() < 1e-15, "{order:?}: {what}");
                assert!(parts.iter().eq(parts.iter().rev()), "{order:?}: {what}");
            }
            assert!((stages[count - 1].at - 1.0).abs() < 1e-15);
        }
    }
}
