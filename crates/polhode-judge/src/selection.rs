//! Choice among interpretations of a log by their residuals.

/// Largest residual of an interpretation that fits, relative to the rotation angle.
///
/// Even under a wrong law of motion, rows follow from each other up to second order in the rotation
/// angle. A wrong interpretation has an error as large as the angle itself.
pub(crate) const FITS: f64 = 0.3;
/// Largest residual (relative) of an interpretation that replaces the named ones: a wrong one may
/// fit roughly.
pub(crate) const REPLACES: f64 = 0.03;
/// Ratio of residuals above which the smaller one decides.
const CLEARLY: f64 = 10.0;
/// Residual due to rounding, rad.
const SAME: f64 = 1e-12;

/// Interpretation with its residual.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tried<T> {
    pub(crate) of: T,
    /// RMS of the angle that the interpretation leaves unexplained, rad.
    pub(crate) angle: f64,
    /// This angle relative to the rotation angle.
    pub(crate) relative: f64,
}

impl<T> Tried<T> {
    pub(crate) fn fits(&self, most: f64) -> bool {
        self.relative <= most
    }

    /// Returns true if the residual is not clearly larger than that of another interpretation.
    pub(crate) fn is_near(&self, best: &Self) -> bool {
        self.angle <= CLEARLY * best.angle.max(SAME)
    }
}

/// Interpretations that do not determine the meaning of a log, best first.
#[derive(Clone, Debug)]
pub(crate) enum Undecided<T> {
    /// No interpretation fits the log.
    Unlike(Vec<Tried<T>>),
    /// Several interpretations fit about equally well, and have different results.
    Ambiguous(Vec<Tried<T>>),
}

/// Returns the interpretation with the smallest residual.
///
/// `named` are those by the names of the columns. They come first, unless none of them fits, or
/// another one fits much better. Others need a small residual in both cases.
///
/// # Errors
/// [`Undecided`] if none fits, or if others that are not `is_same` fit about equally well.
pub(crate) fn chosen<T: Copy>(
    named: Vec<Tried<T>>,
    all: Vec<Tried<T>>,
    is_same: impl Fn(&T, &T) -> bool,
) -> Result<T, Undecided<T>> {
    let sorted = |mut tried: Vec<Tried<T>>| {
        tried.sort_by(|a, b| a.angle.total_cmp(&b.angle));
        tried
    };
    let (named, all) = (sorted(named), sorted(all));
    let is_replaced = |by_name: &Tried<T>| {
        !by_name.fits(FITS) || all.first().is_some_and(|best| best.fits(REPLACES) && !by_name.is_near(best))
    };
    let (group, most) = if named.first().is_none_or(is_replaced) { (all, REPLACES) } else { (named, FITS) };
    let Some(best) = group.first().copied().filter(|best| best.fits(most)) else {
        return Err(Undecided::Unlike(group));
    };
    let is_rival = |one: &Tried<T>| one.fits(most) && one.is_near(&best);
    let fitting: Vec<Tried<T>> = group.into_iter().filter(is_rival).collect();
    let is_one = fitting.iter().all(|other| is_same(&other.of, &best.of));
    if is_one { Ok(best.of) } else { Err(Undecided::Ambiguous(fitting)) }
}
