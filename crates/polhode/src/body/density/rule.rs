//! Product rules on the unit cube, each with an embedded rule that estimates its error from the
//! same samples.

/// Rule on [0, 1] with an embedded rule of lower degree: every second node belongs to the Gauss
/// rule, all nodes to the Kronrod rule.
///
/// The difference of the two, the *null rule*, vanishes for every function that the Gauss rule
/// integrates exactly. Otherwise it gives the error of the Gauss rule, which is much larger than
/// that of the Kronrod rule.
#[derive(Debug)]
pub(super) struct Line {
    pub(super) nodes: Vec<LineNode>,
}

/// Node of a rule on [0, 1].
#[derive(Clone, Copy, Debug)]
pub(super) struct LineNode {
    pub(super) at: f64,
    /// Weight in the Kronrod rule.
    pub(super) weight: f64,
    /// Weight in the null rule: the Kronrod weight minus the Gauss weight.
    pub(super) null: f64,
}

/// Product rule on the cube: one rule along each edge. Its error is the sum of their errors.
#[derive(Debug)]
pub(super) struct CubatureRule(pub(super) [Line; 3]);

impl CubatureRule {
    /// Returns the rule with 15 nodes along each edge.
    pub(super) fn fine() -> Self {
        Self([Line::kronrod_15(), Line::kronrod_15(), Line::kronrod_15()])
    }

    /// Returns the rule for thin cones: 15 nodes outward and 7 along the other two edges.
    pub(super) fn slender() -> Self {
        Self([Line::kronrod_15(), Line::kronrod_7(), Line::kronrod_7()])
    }

    /// Returns the number of samples.
    pub(super) fn samples(&self) -> usize {
        self.0.iter().map(|line| line.nodes.len()).product()
    }
}

impl Line {
    /// Returns the rule of degree 23, whose embedded rule has degree 13.
    ///
    /// Source: Piessens, de Doncker, Überhuber & Kahaner, QUADPACK (1983), `qk15`.
    fn kronrod_15() -> Self {
        const NODES: [f64; 8] = [
            0.991_455_371_120_812_6,
            0.949_107_912_342_758_5,
            0.864_864_423_359_769_1,
            0.741_531_185_599_394_5,
            0.586_087_235_467_691_1,
            0.405_845_151_377_397_2,
            0.207_784_955_007_898_48,
            0.0,
        ];
        const KRONROD: [f64; 8] = [
            0.022_935_322_010_529_224,
            0.063_092_092_629_978_56,
            0.104_790_010_322_250_19,
            0.140_653_259_715_525_92,
            0.169_004_726_639_267_9,
            0.190_350_578_064_785_42,
            0.204_432_940_075_298_89,
            0.209_482_141_084_727_82,
        ];
        const GAUSS: [f64; 4] = [
            0.129_484_966_168_869_7,
            0.279_705_391_489_276_64,
            0.381_830_050_505_118_9,
            0.417_959_183_673_469_4,
        ];
        Self::symmetric(&NODES, &KRONROD, &GAUSS)
    }

    /// Returns the rule of degree 11, whose embedded rule has degree 5.
    ///
    /// Computed to 40 digits. The nodes that are not Gauss nodes are the zeros of the Stieltjes
    /// polynomial x⁴ − 10/9 x² + 155/891. The weights integrate x², x⁴ and x⁶ exactly.
    fn kronrod_7() -> Self {
        const NODES: [f64; 4] =
            [0.960_491_268_708_020_3, 0.774_596_669_241_483_4, 0.434_243_749_346_802_54, 0.0];
        const KRONROD: [f64; 4] = [
            0.104_656_226_026_467_26,
            0.268_488_089_868_333_45,
            0.401_397_414_775_962_25,
            0.450_916_538_658_474_15,
        ];
        const GAUSS: [f64; 2] = [5.0 / 9.0, 8.0 / 9.0];
        Self::symmetric(&NODES, &KRONROD, &GAUSS)
    }

    /// Maps nodes and weights from [−1, 1], listed from the end to the middle, to [0, 1]. The
    /// second, fourth, … nodes are Gauss nodes.
    fn symmetric(nodes: &[f64], kronrod: &[f64], gauss: &[f64]) -> Self {
        let last = 2 * nodes.len() - 2;
        let node = |i: usize| {
            let k = i.min(last - i);
            let at = if i == k { 0.5 - 0.5 * nodes[k] } else { 0.5 + 0.5 * nodes[k] };
            let gauss = if k % 2 == 1 { gauss[k / 2] } else { 0.0 };
            LineNode { at, weight: 0.5 * kronrod[k], null: 0.5 * (kronrod[k] - gauss) }
        };
        Self { nodes: (0..=last).map(node).collect() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_integrates_every_power_of_its_degree_and_its_null_rule_none_of_gauss() {
        for (line, degree, of_gauss) in [(Line::kronrod_15(), 23, 13), (Line::kronrod_7(), 11, 5)] {
            // Integrates on [−1, 1], where odd powers vanish; about the middle, so that high powers
            // are not lost to rounding.
            let sum = |n: i32, weight: fn(&LineNode) -> f64| {
                line.nodes.iter().map(|node| weight(node) * (2.0 * node.at - 1.0).powi(n)).sum::<f64>()
            };
            for n in 0..=degree + 1 {
                let exact = if n % 2 == 0 { 1.0 / f64::from(n + 1) } else { 0.0 };
                let error = (sum(n, |node| node.weight) - exact).abs();
                assert_eq!(error < 3e-16, n <= degree, "{n} of {degree}: {error}");
                let null = sum(n, |node| node.null).abs();
                assert_eq!(null < 3e-16, n <= of_gauss || n % 2 == 1, "{n} of {of_gauss}: {null}");
            }
        }
        assert_eq!((CubatureRule::fine().samples(), CubatureRule::slender().samples()), (3375, 735));
    }
}
