//! Range of values.

/// Returns the least and the greatest finite value; zeros if there is none.
pub fn range(values: impl Iterator<Item = f64>) -> [f64; 2] {
    let finite = values.filter(|x| x.is_finite());
    let [least, greatest] =
        finite.fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], x| [least.min(x), most.max(x)]);
    if least <= greatest { [least, greatest] } else { [0.0, 0.0] }
}
