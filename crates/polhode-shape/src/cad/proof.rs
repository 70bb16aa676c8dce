//! Proof of the sign of the products of inertia, from the report's own numbers.
//!
//! A report has products `P_ij` = −s ∫ `x_i x_j` dm with s = 1 or −1. It does not state s, or
//! states it in words that changed between versions. But its numbers depend on each other. About
//! the centre of mass and about the origin, with mass M and centre of mass c,
//!
//! `J_ij` = `I_ij` + M (c² `δ_ij` − `c_i c_j`),  `I_ij` = s `P_ij` for i ≠ j,
//!
//! and only one s satisfies this, if M `c_i c_j` exceeds the rounding. Without the second tensor,
//! principal axes `e_k` and moments `P_k` decide, I = Σ `P_k e_k e_kᵀ`, or the moments alone:
//! changing all three signs changes the sign of `I_xy I_xz I_yz`, and thus the eigenvalues.
//!
//! Every printed number is uncertain by half a unit of its last digit. A *residual* is the error of
//! an equation, in units of the largest sum of these uncertainties. It is at most 1 for the right
//! sign, if the printed numbers are correct. A sign is therefore also determined if it alone has a
//! residual of at most 1, even if the other exceeds 1 only slightly. Such a narrow proof does not
//! override the words of the report.

use polhode::body::{InertiaTensor, PrincipalFrame};
use polhode::math::Body;
use polhode_source::{ContentError, ContentErrorKind};

use super::ProductConvention;

/// Residual up to which an equation holds.
pub(crate) const FITS: f64 = 3.0;

/// Residual from which an equation fails.
pub(crate) const FAILS: f64 = 10.0;

/// Upper bound on the residual for numbers rounded to nearest.
const ROUNDED: f64 = 1.0;

/// Proof of the sign of the products of inertia.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SignProof {
    /// Evidence that determined the sign.
    pub by: SignSource,
    /// Sign convention of the report's products.
    pub convention: ProductConvention,
    /// Residual if the products are −∫xy dm, in units of the report's rounding; NaN if nothing was
    /// tested.
    pub residual_negative: f64,
    /// Residual if the products are +∫xy dm, in units of the report's rounding; NaN if nothing was
    /// tested.
    pub residual_positive: f64,
    /// Rounding relative to the effect of the sign; NaN if nothing was tested.
    pub rounding: f64,
}

/// Evidence for the sign of the products of inertia.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum SignSource {
    /// Tensors about two points, with the parallel-axis theorem.
    ParallelAxis,
    /// Principal axes and moments, which determine the tensor.
    PrincipalAxes,
    /// Principal moments, which are the eigenvalues of the tensor.
    PrincipalMoments,
    /// No evidence needed: all products are zero, and both signs give the same tensor.
    NoProducts,
    /// Statement of the report, such as "Using positive tensor notation".
    Stated,
    /// Option set by the caller.
    Told,
}

impl SignSource {
    /// Returns the evidence in words, to follow "by": `parallel axes`.
    pub const fn name(self) -> &'static str {
        match self {
            Self::ParallelAxis => "parallel axes",
            Self::PrincipalAxes => "the principal axes",
            Self::PrincipalMoments => "the principal moments",
            Self::NoProducts => "products that are all zero",
            Self::Stated => "the report's own words",
            Self::Told => "the option",
        }
    }
}

/// Printed number in SI units, and half a unit of its last digit.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Printed {
    pub value: f64,
    pub half: f64,
}

/// Tensor elements xx, yy, zz, xy, xz, yz.
pub(crate) type Tensor = [Printed; 6];

/// Row and column of the elements of a [`Tensor`].
pub(crate) const PLACES: [[usize; 2]; 6] = [[0, 0], [1, 1], [2, 2], [0, 1], [0, 2], [1, 2]];

/// Numbers of a report that depend on the sign.
pub(crate) struct Evidence {
    pub mass: Printed,
    pub center: [Printed; 3],
    pub central: Option<Tensor>,
    pub origin: Option<Tensor>,
    pub moments: Option<[Printed; 3]>,
    pub axes: Option<[Printed; 9]>,
    pub stated: Option<ProductConvention>,
    pub told: Option<ProductConvention>,
}

/// Determines the sign by the strongest available proof.
pub(crate) fn prove(evidence: &Evidence) -> Result<SignProof, ContentError> {
    let trials = [parallel_axes(evidence), principal_axes(evidence), principal_moments(evidence)];
    let (mut undecided, mut narrow) = (None, Vec::new());
    for trial in trials.into_iter().flatten() {
        let (negative, positive) = (trial.residual_negative, trial.residual_positive);
        let convention = if negative <= FITS && positive >= FAILS {
            Some(ProductConvention::Negative)
        } else if positive <= FITS && negative >= FAILS {
            Some(ProductConvention::Positive)
        } else {
            None
        };
        let neither = !(negative <= FITS || positive <= FITS);
        match (convention, evidence.told) {
            (Some(convention), Some(told)) if convention != told => return Err(contradicted(&trial, told)),
            (Some(convention), _) => return Ok(SignProof { convention, ..trial }),
            (None, None) if neither => return Err(refused(&trial)),
            (None, Some(told)) if neither => {
                return Ok(SignProof { by: SignSource::Told, convention: told, ..trial });
            }
            (None, _) => {
                undecided = undecided.or(Some(trial));
                narrow.extend(narrowly(&trial));
            }
        }
    }
    let nothing = SignProof {
        by: SignSource::Told,
        convention: ProductConvention::Negative,
        residual_negative: f64::NAN,
        residual_positive: f64::NAN,
        rounding: f64::NAN,
    };
    let rest = undecided.unwrap_or(nothing);
    let no_products = evidence.central.is_some_and(|i| i[3..].iter().all(|p| p.value == 0.0));
    if let Some(convention) = evidence.told {
        return Ok(SignProof { by: SignSource::Told, convention, ..rest });
    }
    if no_products {
        return Ok(SignProof { by: SignSource::NoProducts, ..rest });
    }
    let narrow = agreed(&narrow);
    if let Some(convention) = evidence.stated {
        return match narrow {
            Some(proof) if proof.convention != convention => Err(refused(&proof)),
            _ => Ok(SignProof { by: SignSource::Stated, convention, ..rest }),
        };
    }
    if let Some(proof) = narrow {
        return Ok(proof);
    }
    Err(undecided.as_ref().map_or_else(unproved, refused))
}

/// Returns a narrow proof if only one sign is within the rounding.
fn narrowly(trial: &SignProof) -> Option<SignProof> {
    let (negative, positive) = (trial.residual_negative, trial.residual_positive);
    let convention = match (negative <= ROUNDED, positive <= ROUNDED) {
        (true, false) => ProductConvention::Negative,
        (false, true) => ProductConvention::Positive,
        _ => return None,
    };
    Some(SignProof { convention, ..*trial })
}

/// Returns the clearest narrow proof, if all agree on the sign.
fn agreed(narrow: &[SignProof]) -> Option<SignProof> {
    let first = narrow.first()?;
    let clear = |proof: &SignProof| proof.residual_negative.max(proof.residual_positive);
    let clearest = narrow.iter().max_by(|a, b| clear(a).total_cmp(&clear(b)))?;
    narrow.iter().all(|proof| proof.convention == first.convention).then_some(*clearest)
}

fn refused(trial: &SignProof) -> ContentError {
    let SignProof { by, residual_negative: negative, residual_positive: positive, .. } = *trial;
    let hint = if negative > FITS && positive > FITS {
        "the report contradicts itself: check mass, centre and units, and that all of it is about one part in one \
         frame; --products negative or --products positive overrides this check"
    } else {
        "give --products negative or --products positive, or print more digits, or use an origin outside \
         the planes of symmetry of the body"
    };
    ContentErrorKind::ProductSign { by: by.name(), negative, positive }.of_whole().hint(hint)
}

fn unproved() -> ContentError {
    let question = "are the products of inertia −∫xy dm or +∫xy dm?";
    ContentErrorKind::unclear(question, "one tensor, and no principal moments")
        .of_whole()
        .hint("give --products negative or --products positive, or also paste the tensor about the origin")
}

fn contradicted(trial: &SignProof, told: ProductConvention) -> ContentError {
    let kind = ContentErrorKind::value(
        "the sign of the products of inertia given by --products",
        told.name().to_owned(),
        format!(
            "the sign proved by {}: residuals {:.2e} (negative) and {:.2e} (positive)",
            trial.by.name(),
            trial.residual_negative,
            trial.residual_positive
        ),
    );
    kind.of_whole().hint("delete --products")
}

/// Error of an equation, with its rounding bound.
type Deviation = Printed;

/// Returns the residuals of both signs from their deviations.
fn weigh(by: SignSource, negative: &[Deviation], positive: &[Deviation]) -> SignProof {
    let size = |d: &Deviation| d.value.abs() / d.half.max(f64::MIN_POSITIVE);
    // A NaN deviation counts as an infinite residual.
    let worst = |all: &[Deviation]| {
        all.iter().map(size).fold(0.0, |a: f64, b| if b.is_nan() { f64::INFINITY } else { a.max(b) })
    };
    let rounding = negative
        .iter()
        .zip(positive)
        .map(|(n, p)| n.half.max(p.half) / (n.value - p.value).abs())
        .fold(f64::INFINITY, f64::min);
    SignProof {
        by,
        convention: ProductConvention::Negative,
        residual_negative: worst(negative),
        residual_positive: worst(positive),
        rounding,
    }
}

/// Tests J − I − M (c² 1 − c cᵀ) under each sign.
fn parallel_axes(evidence: &Evidence) -> Option<SignProof> {
    let (central, origin) = (evidence.central?, evidence.origin?);
    let moved = steiner(evidence.mass, evidence.center);
    let [negative, positive] = BOTH
        .map(|convention| difference(signed(origin, convention), sum(signed(central, convention), moved)));
    Some(weigh(SignSource::ParallelAxis, &negative, &positive))
}

/// Tests I − Σ `P_k e_k e_kᵀ` under each sign.
fn principal_axes(evidence: &Evidence) -> Option<SignProof> {
    let (moments, axes) = (evidence.moments?, evidence.axes?);
    // Since Σ `e_k e_kᵀ` = 1 exactly, the mean moment does not need the axes and is not affected by
    // their rounding.
    let mean = moments.iter().map(|p| p.value).sum::<f64>() / 3.0;
    let rebuilt = PLACES.map(|[i, j]| {
        let mut element = Printed { value: if i == j { mean } else { 0.0 }, half: 0.0 };
        for (k, p) in moments.iter().enumerate() {
            let p = Printed { value: p.value - mean, half: p.half };
            let term = product(p, product(axes[3 * k + i], axes[3 * k + j]));
            element = Printed { value: element.value + term.value, half: element.half + term.half };
        }
        element
    });
    let [negative, positive] = candidates(evidence)?.map(|tensor| difference(tensor, rebuilt));
    Some(weigh(SignSource::PrincipalAxes, &negative, &positive))
}

/// Tests the eigenvalues of I minus the printed moments, under each sign.
fn principal_moments(evidence: &Evidence) -> Option<SignProof> {
    let mut moments = evidence.moments?;
    moments.sort_by(|a, b| a.value.total_cmp(&b.value));
    let deviations = candidates(evidence)?.map(|tensor| {
        // Weyl's inequality: no eigenvalue changes by more than the norm of the perturbation, which
        // is bounded by the row sums.
        let half = |k: usize| {
            let in_row = |[i, j]: &[usize; 2]| *i == k || *j == k;
            PLACES.iter().zip(&tensor).filter(|(place, _)| in_row(place)).map(|(_, p)| p.half).sum::<f64>()
        };
        let spread = half(0).max(half(1)).max(half(2));
        let eigenvalues = eigenvalues(&tensor)?;
        Some([0, 1, 2].map(|k| Printed {
            value: eigenvalues[k] - moments[k].value,
            half: spread + moments[k].half + rounding(&[eigenvalues[2]]),
        }))
    });
    let [Some(negative), Some(positive)] = deviations else { return None };
    Some(weigh(SignSource::PrincipalMoments, &negative, &positive))
}

/// Returns the eigenvalues in ascending order. A multiple of the unit tensor is added temporarily,
/// so that the tensor is physical also for the wrong sign.
fn eigenvalues(tensor: &Tensor) -> Option<[f64; 3]> {
    let [xx, yy, zz, xy, xz, yz] = tensor.map(|p| p.value);
    let shift = 4.0 * tensor.iter().fold(0.0, |most: f64, p| most.max(p.value.abs()));
    let moments = [xx + shift, yy + shift, zz + shift];
    let possible = InertiaTensor::<Body>::with_negative_products(moments, [xy, xz, yz]).ok()?;
    Some(PrincipalFrame::of(&possible).moments().map(|i| i - shift))
}

const BOTH: [ProductConvention; 2] = [ProductConvention::Negative, ProductConvention::Positive];

/// Returns the tensor about the centre of mass under each sign; converted from the origin if
/// necessary.
fn candidates(evidence: &Evidence) -> Option<[Tensor; 2]> {
    match (evidence.central, evidence.origin) {
        (Some(central), _) => Some(BOTH.map(|convention| signed(central, convention))),
        (None, Some(origin)) => {
            let moved = steiner(evidence.mass, evidence.center);
            Some(BOTH.map(|convention| difference(signed(origin, convention), moved)))
        }
        (None, None) => None,
    }
}

/// Returns the tensor with products −∫xy dm, from printed products of either convention.
fn signed(tensor: Tensor, convention: ProductConvention) -> Tensor {
    let mut tensor = tensor;
    if convention == ProductConvention::Positive {
        tensor[3..].iter_mut().for_each(|p| p.value = 0.0 - p.value);
    }
    tensor
}

/// Returns the parallel-axis term M (c² `δ_ij` − `c_i c_j`).
fn steiner(mass: Printed, c: [Printed; 3]) -> Tensor {
    PLACES.map(|[i, j]| {
        if i != j {
            let moved = product(mass, product(c[i], c[j]));
            return Printed { value: -moved.value, half: moved.half };
        }
        let [a, b] = [(i + 1) % 3, (i + 2) % 3].map(|k| product(mass, product(c[k], c[k])));
        Printed { value: a.value + b.value, half: a.half + b.half }
    })
}

/// Returns a b with its rounding bound: (|a| + δa)(|b| + δb) − |a b|.
fn product(a: Printed, b: Printed) -> Printed {
    let (x, y) = (a.value.abs(), b.value.abs());
    Printed { value: a.value * b.value, half: x * b.half + y * a.half + a.half * b.half }
}

fn sum(a: Tensor, b: Tensor) -> Tensor {
    std::array::from_fn(|k| Printed { value: a[k].value + b[k].value, half: a[k].half + b[k].half })
}

fn difference(a: Tensor, b: Tensor) -> Tensor {
    std::array::from_fn(|k| Printed {
        value: a[k].value - b[k].value,
        half: a[k].half + b[k].half + rounding(&[a[k].value, b[k].value]),
    })
}

/// Returns a bound on the rounding errors of this computation.
fn rounding(values: &[f64]) -> f64 {
    8.0 * f64::EPSILON * values.iter().map(|v| v.abs()).sum::<f64>()
}
