//! Elliptic functions compared with references of 40 digits.

use polhode::math::elliptic::EllipticParameter;

use crate::common::{cases, number, table};

/// Comparison of a function with the double nearest to the exact value.
#[derive(Clone, Copy, Default)]
pub(crate) struct Function {
    pub(crate) values: usize,
    pub(crate) nearest: usize,
    pub(crate) ulps: f64,
}

pub(crate) const FUNCTIONS: [&str; 7] =
    ["K, E", "Π(n)", "F(φ), E(φ)", "Π(n; φ)", "sn, cn, dn", "am", "sn, cn, dn, am at m = 1"];

pub(crate) fn measured() -> [Function; FUNCTIONS.len()] {
    let table = table("elliptic");
    let list = |value: &toml::Value| -> Vec<f64> { value.as_array().unwrap().iter().map(number).collect() };
    let characteristics = list(&table["characteristics"]);
    let mut functions = [Function::default(); FUNCTIONS.len()];
    let mut compare = |k: usize, got: f64, want: f64| {
        let ulp = want.abs().next_up() - want.abs();
        let ulps = if got == want { 0.0 } else { ((got - want) / ulp).abs() };
        assert!(ulps.is_finite(), "{}: {got} for {want}", FUNCTIONS[k]);
        functions[k].values += 1;
        functions[k].nearest += usize::from(got == want);
        functions[k].ulps = functions[k].ulps.max(ulps);
    };
    for case in cases(&table, "parameter") {
        let p = match case["given"].as_str().unwrap() {
            "m" => EllipticParameter::new(number(&case["m"])),
            _ => EllipticParameter::from_complement(number(&case["m1"])),
        };
        let p = p.unwrap();
        compare(0, p.e(), number(&case["e"]));
        if let Some(k) = case.get("k") {
            compare(0, p.k(), number(k));
        }
        if let Some(pi) = case.get("pi") {
            for (&n, want) in characteristics.iter().zip(list(pi)) {
                compare(1, p.pi(n).unwrap(), want);
            }
        }
        for row in cases(case, "incomplete") {
            let phi = number(&row["phi"]);
            compare(2, p.incomplete_e(phi), number(&row["e"]));
            if let Some(f) = row.get("f") {
                compare(2, p.incomplete_f(phi), number(f));
            }
            if let Some(pi) = row.get("pi") {
                for (&n, want) in characteristics.iter().zip(list(pi)) {
                    compare(3, p.incomplete_pi(n, phi).unwrap(), want);
                }
            }
        }
        for row in cases(case, "jacobi") {
            let at = p.jacobi(number(&row["u"]));
            let (three, am) = if p.complement() == 0.0 { (6, 6) } else { (4, 5) };
            for (key, got) in [("sn", at.sn), ("cn", at.cn), ("dn", at.dn)] {
                compare(three, got, number(&row[key]));
            }
            compare(am, at.am, number(&row["am"]));
        }
    }
    functions
}
