//! Formulas: values compared with plain Rust, every error with its column, and texts that would
//! overflow a recursive parser.

use polhode::body::density::{Cubature, DensityField, Solid, mass_properties_of_field};
use polhode::body::shape::BoxShape;
use polhode_source::expression::{
    Expression, ExpressionErrorKind, condition, formula_of_state, formula_of_state_in_si, formula_of_time,
    measured,
};
use polhode_source::unit::Dimension;

const XYZ: [&str; 3] = ["x", "y", "z"];

fn value(text: &str, point: [f64; 3]) -> f64 {
    Expression::parse(text, &XYZ).unwrap_or_else(|e| panic!("{text}: {e}")).evaluate(point)
}

#[test]
fn formulas_have_the_values_that_rust_gives_them() {
    let [x, y, z] = [0.7_f64, -1.3, 2.9];
    for (text, expected) in [
        ("2700", 2700.0),
        (" .5 + 1.5e-3*2E+1 ", 0.5 + 1.5e-3 * 2e1),
        ("x - y - z", x - y - z),
        ("x / y / z", x / y / z),
        ("x - y * z", x - y * z),
        ("(x - y) * z", (x - y) * z),
        ("2^3^2", 512.0),
        ("-x^2", -(x * x)),
        ("(-x)^2", x * x),
        ("2^-1", 0.5),
        ("2^-x^2", 2_f64.powf(-(x * x))),
        ("-2^-x*3", -(2_f64.powf(-x)) * 3.0),
        ("--x", x),
        ("x - -+-y", x - y),
        ("x*-y", x * -y),
        ("z^0.5", z.sqrt()),
        ("z^-3", 1.0 / (z * z * z)),
        ("z^5", z * z * z * z * z),
        ("0^0 + (x - x)^0", 2.0),
        ("2*pi", std::f64::consts::TAU),
        ("sqrt(z) + exp(x) + log(z)", z.sqrt() + x.exp() + z.ln()),
        ("sin(x) - cos(y)*tan(z)", x.sin() - y.cos() * z.tan()),
        ("asin(x) + acos(x) + atan(z)", x.asin() + x.acos() + z.atan()),
        ("atan2(y, x)", y.atan2(x)),
        ("hypot(x, y) + abs(y)", x.hypot(y) + y.abs()),
        ("min(x, y) - max(y, z)", y - z),
        ("pow(z, x)", z.powf(x)),
        ("sinh(x) + cosh(y)*tanh(z)", x.sinh() + y.cosh() * z.tanh()),
        ("log1p(x) - expm1(y)", x.ln_1p() - y.exp_m1()),
        ("floor(10*y) + mod(y, x)", (10.0 * y).floor() + (y - x * (y / x).floor())),
        ("clip(z, y, x) + clip(x, y, z)", 2.0 * x),
        ("pow(y, 3)", y * y * y),
        ("if(x < y, 3, 8)", 8.0),
        ("if(x > y, 3, 8)", 3.0),
        ("if(x + 1 >= y * z, x^2, y)", x * x),
        ("if(z <= 2.9, 1, 2)", 1.0),
        ("if(y < 0, 0, log(y))", 0.0),
        ("if(x < z, if(y > 0, 1, if(z > 3, 2, x - 4)), 5)", x - 4.0),
        ("(x < z) + 10*(z < x)", 1.0),
        ("3·x × y − z", 3.0 * x * y - z),
        ("((((x))))", x),
    ] {
        let got = value(text, [x, y, z]);
        assert!((got - expected).abs() <= 4e-16 * expected.abs(), "{text}: {got}, {expected}");
    }
    assert!(value("if(log(y), 1, 2)", [x, y, z]).is_nan());
    assert!(value("max(log(y), 1) + min(1, log(y))", [x, y, z]).is_nan());
    assert_eq!(value("1/(x - x)", [x, y, z]), f64::INFINITY);
}

#[test]
fn many_points_have_the_values_of_one() {
    let formula = "if(hypot(x, y) < 0.8, 1900 - 300*z^2, 7 + exp(-x*y))*sqrt(abs(z)) + atan2(y, x)";
    let expression = Expression::parse(formula, &XYZ).unwrap();
    let points: Vec<[f64; 3]> = (0..1003)
        .map(|k| {
            let t = f64::from(k);
            [(1.3 * t).sin(), (0.7 * t).cos(), (0.11 * t).sin()]
        })
        .collect();
    let mut values = vec![0.0; points.len()];
    expression.densities(&points, &mut values);
    for (point, value) in points.iter().zip(&values) {
        assert_eq!(value.to_bits(), expression.evaluate(*point).to_bits());
    }
    // Other names and another number of variables.
    let torque = Expression::parse("-k*omega_x + sin(t)", &["t", "omega_x", "k"]).unwrap();
    assert_eq!(torque.evaluate([0.0, 3.0, 0.25]), -0.75);
    assert_eq!(torque.text(), "-k*omega_x + sin(t)");
    assert!(torque.evaluate([0.0, 3.0]).is_nan());
}

#[test]
fn every_mistake_is_named_with_its_column() {
    for (text, message, hint) in [
        ("", "column 1: expected a number, a name or (, found the end of the formula", ""),
        ("  ", "column 3: expected a number, a name or (, found the end of the formula", ""),
        ("x +", "column 4: expected a number, a name or (, found the end of the formula", ""),
        ("x + * y", "column 5: expected a number, a name or (, found \"*\"", "x^2"),
        ("x ** 2", "column 4: expected a number, a name or (, found \"*\"", "x^2"),
        ("2x", "column 2: expected an operator, ) or the end, found \"x\"", "*"),
        ("(x + 1)(y)", "column 8: expected an operator, ) or the end, found \"(\"", "*"),
        ("x y", "column 3: expected an operator, ) or the end, found \"y\"", "*"),
        ("0,5 * x", "column 2: expected an operator, ) or the end, found \",\"", "point"),
        ("1.2.3", "column 4: expected an operator, ) or the end, found \".3\"", ""),
        (".", "column 1: expected a number, found \".\"", ""),
        ("1e400", "column 1: 1e400 is beyond the range of a double", ""),
        ("(x + 1", "column 7: expected an operator or ), found the end of the formula", ""),
        ("x + 1)", "column 6: expected an operator or the end, found \")\"", ""),
        ("()", "column 2: expected a number, a name or (, found \")\"", ""),
        ("3 + sine(x)", "column 5: unknown function sine", "sin"),
        ("3 + foo(x)", "column 5: unknown function foo", "sqrt, exp"),
        ("3 + x(y)", "column 5: unknown function x", "x*"),
        ("rho", "column 1: unknown variable rho", "x, y, z"),
        ("X + 1", "column 1: unknown variable X", "did you mean x?"),
        ("sin", "column 4: expected ( after a function, found the end of the formula", ""),
        ("sin x", "column 5: expected ( after a function, found \"x\"", ""),
        ("clip(x, 1)", "column 1: clip takes 3 arguments, not 2", ""),
        ("if(x > 0, 1)", "column 1: if takes 3 arguments, not 2", ""),
        ("2 + atan2(x)", "column 5: atan2 takes 2 arguments, not 1", ""),
        ("sqrt(x, y)", "column 1: sqrt takes 1 argument, not 2", ""),
        ("sqrt()", "column 6: expected a number, a name or (, found \")\"", ""),
        ("max(x,)", "column 7: expected a number, a name or (, found \")\"", ""),
        ("0 < x < 1", "column 7: the result of a comparison cannot be compared", "0 < x and x < 1"),
        ("if(x = 1, 2, 3)", "column 6: expected an operator, ) or the end, found \"=\"", "<="),
        ("x == 1", "column 3: expected an operator, ) or the end, found \"=\"", "<="),
        ("x > 0 && y > 0", "column 7: expected an operator, ) or the end, found \"&\"", "if("),
        ("Δ + µ", "column 1: unknown variable Δ", "x, y, z"),
        ("x + $", "column 5: expected a number, a name or (, found \"$\"", ""),
    ] {
        let error = Expression::parse(text, &XYZ).unwrap_err();
        assert_eq!(error.to_string(), message, "{text}");
        assert!(error.hint().unwrap_or_default().contains(hint), "{text}: {:?}", error.hint());
        assert!(!hint.is_empty() || error.hint().is_none_or(|h| !h.is_empty()), "{text}");
    }
    let none = Expression::parse("x", &[]).unwrap_err();
    assert!(matches!(none.kind, ExpressionErrorKind::UnknownVariable { ref known, .. } if known.is_empty()));
}

#[test]
fn deep_and_long_texts_cost_memory_in_proportion_and_no_stack() {
    const DEEP: usize = 300_000;
    let nested = format!("{}x{}", "(".repeat(DEEP), ")".repeat(DEEP));
    assert_eq!(value(&nested, [2.5, 0.0, 0.0]), 2.5);
    let sums = format!("{}x{}", "1+(".repeat(DEEP), ")".repeat(DEEP));
    assert_eq!(value(&sums, [2.5, 0.0, 0.0]), 2.5 + DEEP as f64);
    let roots = format!("{}x{}", "sqrt(".repeat(DEEP), ")".repeat(DEEP));
    assert_eq!(value(&roots, [1.0, 0.0, 0.0]), 1.0);
    assert_eq!(value(&format!("{}x", "-".repeat(DEEP + 1)), [2.5, 0.0, 0.0]), -2.5);
    assert_eq!(value(&format!("{}1", "1^".repeat(DEEP)), [0.0; 3]), 1.0);
    let open = Expression::parse(&"(".repeat(DEEP), &XYZ).unwrap_err();
    assert_eq!(open.column, DEEP + 1);
}

#[test]
fn no_text_panics() {
    let parts = [
        "x", "y", "7", "1e3", "(", ")", ",", "+", "-", "*", "/", "^", "<", ">=", "if(", "min(", "sqrt(",
        "pi", " ", ".", "é", "e", "=", "\u{202e}", ";", "z=",
    ];
    let mut state = 9_u64;
    let mut below = |n: usize| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((u128::from(state) * n as u128) >> 64) as usize
    };
    let (mut read, mut with_locals) = (0, 0);
    for _ in 0..100_000 {
        let text: String = (0..=below(9)).map(|_| parts[below(parts.len())]).collect();
        match Expression::parse(&text, &XYZ) {
            Ok(expression) => {
                read += 1;
                let _ = expression.evaluate([0.3, -0.4, 0.5]);
            }
            Err(error) => assert!(error.column <= text.chars().count() + 1 && !error.to_string().is_empty()),
        }
        let text = format!("x=0.3;y=t;{text}");
        match formula_of_state_in_si(&text) {
            Ok(formula) => {
                with_locals += 1;
                let _ = formula.evaluate(&[0.3]);
            }
            Err(error) => assert!(error.column <= text.chars().count() + 1 && !error.to_string().is_empty()),
        }
    }
    assert!(read > 1000 && with_locals > 1000, "{read} {with_locals}");
}

#[test]
fn a_formula_is_a_density() {
    let wood = Expression::parse("650*(1 + 0.3*x) - 200*y^2 + 80*x*z", &XYZ).unwrap();
    let beam = BoxShape::new([0.4, 0.2, 1.0]).unwrap();
    let body = mass_properties_of_field(Solid::Shape(&beam), &wood, Cubature::default()).unwrap();
    // ∫ = 650 V − 200 V b²/12
    let exact = 0.08 * (650.0 - 200.0 * 0.04 / 12.0);
    assert!((body.properties.mass() - exact).abs() <= body.error_estimate.mass);
    // M c_x = 650 · 0.3 V a²/12
    let moment = body.properties.mass() * body.properties.center_of_mass().x;
    assert!((moment - 0.08 * 195.0 * 0.16 / 12.0).abs() < 1e-14);
}

#[test]
fn units_make_si_and_dimensions_are_found() {
    for (text, value, dimension) in [
        ("30[deg/s]*2[s]", std::f64::consts::FRAC_PI_3, Dimension::NONE),
        ("-1.5e-1 [ mN m ]", -1.5e-4, Dimension::TORQUE),
        ("t/1[min]", 0.5, Dimension::NONE),
        ("2[kg m^2]*wx^2", 4.5, Dimension::TORQUE),
        ("sqrt(wx^2 + 4[rad^2/s^2])", 2.5, Dimension::ANGULAR_VELOCITY),
        ("(wx^2)^1.5", 3.375, Dimension::new(0, 0, -3, 0)),
        ("hypot(Lx, 0)*wx", 0.3, Dimension::TORQUE),
        ("if(t > 20[s], min(wx, 1[1/s]), 0)", 1.0, Dimension::ANGULAR_VELOCITY),
        ("max(0, -wx)", 0.0, Dimension::ANGULAR_VELOCITY),
        ("clip(wx, 0, 30[deg/s])", 30_f64.to_radians(), Dimension::ANGULAR_VELOCITY),
        ("mod(t, 8[s])", 6.0, Dimension::TIME),
        ("floor(t/8[s])", 3.0, Dimension::NONE),
        ("atan2(wx, wx)*4", std::f64::consts::PI, Dimension::NONE),
        ("wx/t", 0.05, Dimension::ANGULAR_ACCELERATION),
        ("0*wx + 0", 0.0, Dimension::NONE),
        ("2^(t/10[s]) + pow(2, wx*2[s])", 16.0, Dimension::NONE),
    ] {
        let variables = [
            ("t", Dimension::TIME),
            ("wx", Dimension::ANGULAR_VELOCITY),
            ("Lx", Dimension::ANGULAR_MOMENTUM),
        ];
        let (formula, found) = measured(text, &variables, None).unwrap_or_else(|e| panic!("{text}: {e}"));
        let got = formula.evaluate(&[30.0, 1.5, 0.2]);
        assert!((got - value).abs() <= 4e-16 * value.abs(), "{text}: {got}");
        assert_eq!(found, dimension, "{text}");
    }
    assert!(formula_of_time("30[deg]*sin(t/2[s])", Dimension::ANGLE).is_ok());
    assert!(formula_of_time("wx", Dimension::ANGULAR_VELOCITY).is_err());
}

#[test]
fn every_wrong_dimension_is_named_with_its_column() {
    for (text, message, hint) in [
        ("wx + t", "column 4: + of an angular velocity and a time: the dimensions differ", ""),
        (
            "1 - 2*wx",
            "column 3: - of a plain number and an angular velocity: the dimensions differ",
            "such as 30 deg/s",
        ),
        ("t < 3", "column 3: < of a time and a plain number: the dimensions differ", "such as 90 s"),
        ("min(t, wx)", "column 1: min of a time and an angular velocity: the dimensions differ", ""),
        ("if(t, 1, 2)", "column 1: if needs a number without unit, not a time", "a comparison"),
        ("if(t < 1[s], 1, t)", "column 1: if of a plain number and a time: the dimensions differ", "90 s"),
        ("2 + exp(-t)", "column 5: exp needs a number without unit, not a time", "divide by"),
        ("2^t", "column 2: ^ needs a number without unit, not a time", "divide by"),
        ("t^qw", "column 2: ^ needs a number without unit, not a time", "divide by"),
        (
            "sqrt(wx)",
            "column 1: sqrt of an angular velocity has no integer powers of kg, m and s",
            "divide by",
        ),
        ("  Lx", "column 3: the value is an angular momentum, where a torque belongs", "such as 30[deg/s]"),
        ("qw", "column 1: the value is a plain number, where a torque belongs", "such as 0.1 N m"),
        ("1[N mm", "column 7: expected ] after a unit, found the end of the formula", ""),
        ("1[ ]", "column 4: expected a unit, found \"]\"", ""),
        ("1[Nmn]", "column 3: unknown unit \"Nmn\"", ""),
        ("wx[N m s]", "column 3: expected an operator, ) or the end, found \"[\"", "after a number"),
    ] {
        let error = formula_of_state(text, Some(Dimension::TORQUE)).unwrap_err();
        assert_eq!(error.to_string(), message, "{text}");
        assert!(error.hint().unwrap_or_default().contains(hint), "{text}: {:?}", error.hint());
    }
    for text in [
        "theta > 30",
        "0.3 < acos(r33)",
        "-2 >= psi",
        "theta < 30 and 1 > 0",
        "theta - 30 > 0",
        "0 < max(abs(phi), 5)",
        "2*theta/3 > 0.1",
        "0.5*(theta - 30) > 0",
    ] {
        let error = formula_of_state(text, None).unwrap_err();
        assert!(matches!(error.kind, ExpressionErrorKind::BareAngle { .. }), "{text}: {error}");
        assert!(error.hint().unwrap().contains(" deg or "), "{text}");
    }
    for text in [
        "theta > 0",
        "theta > pi",
        "theta > 30 deg",
        "0.5[rad] < phi",
        "theta/2 > 5 deg",
        "theta - 30 deg > 0",
        "theta < pi/2",
        "theta - psi < 0",
        "r33 > 0.5",
        "sin(theta - 0.5) > 0.1",
    ] {
        assert!(formula_of_state(text, None).is_ok(), "{text}");
    }
    let long = formula_of_state(&"1+".repeat(3000), None).unwrap_err();
    assert_eq!((long.kind, long.column), (ExpressionErrorKind::TooLong { most: 4096 }, 4097));
    // Densities do not accept units.
    assert!(Expression::parse("2700[kg/m^3]", &XYZ).is_err());
}

#[test]
fn units_stand_without_brackets_too() {
    let variables = [("t", Dimension::TIME), ("wx", Dimension::ANGULAR_VELOCITY), ("mass", Dimension::MASS)];
    for (plain, bracketed) in [
        ("0.2 N m*wx", "0.2[N m]*wx"),
        ("90 deg/s/wx", "90[deg/s]/wx"),
        ("3 h/t", "3[h]/t"),
        ("1.5e-3 kg m^2*wx - 2 kg m²/s", "1.5e-3[kg m^2]*wx - 2[kg m²/s]"),
        ("4 s^-1 + wx", "4[s^-1] + wx"),
        ("2kg + mass", "2[kg] + mass"),
        ("if(t > 1 min and t < 2 h, 1 N, 2 kN)", "if(t > 1[min] and t < 2[h], 1[N], 2[kN])"),
    ] {
        let values = [plain, bracketed].map(|text| {
            let (formula, dimension) =
                measured(text, &variables, None).unwrap_or_else(|error| panic!("{text}: {error}"));
            (formula.evaluate(&[70.0, 0.3, 5.0]).to_bits(), dimension)
        });
        assert_eq!(values[0], values[1], "{plain}");
    }
    // A variable is not a unit; a word that is neither gives the usual message.
    let error = measured("2 t", &variables, None).unwrap_err();
    assert_eq!(error.to_string(), "column 3: expected an operator, ) or the end, found \"t\"");
    let error = measured("2 kg foo", &variables, None).unwrap_err();
    assert!(matches!(error.kind, ExpressionErrorKind::Unit(_)), "{error}");
    assert!(measured("2 foo", &variables, None).unwrap_err().hint().unwrap().contains("*foo"));
}

#[test]
fn and_binds_more_than_or_and_less_than_comparisons() {
    let truth = |x: f64, y: f64, z: f64| {
        Expression::parse("x > 0 or y > 0 and z > 0", &XYZ).unwrap().evaluate([x, y, z])
    };
    for (x, y, z) in [(1, 0, 0), (0, 1, 0), (0, 0, 1), (0, 1, 1), (1, 0, 1), (0, 0, 0), (1, 1, 1), (1, 1, 0)]
    {
        let want = f64::from(u8::from(x > 0 || (y > 0 && z > 0)));
        assert_eq!(truth(f64::from(x), f64::from(y), f64::from(z)), want, "{x} {y} {z}");
    }
    let grouped = Expression::parse("(x > 0 or y > 0) and z > 0", &XYZ).unwrap();
    assert_eq!(grouped.evaluate([1.0, 0.0, 0.0]), 0.0);
    assert!(grouped.formula().is_condition() && grouped.formula().rough_function().is_some());
    let variables = [("t", Dimension::TIME)];
    assert_eq!(condition("t > 1 s and t < 3 s", &variables).unwrap().evaluate(&[2.0]), 1.0);
    assert!(matches!(condition("t", &variables).unwrap_err().kind, ExpressionErrorKind::NoCondition));
    assert!(condition("t and 1 < 2", &variables).is_err());
}

#[test]
fn only_generated_formulas_have_local_values() {
    let mut state = [0.0; polhode::motion::StateVariables::COUNT];
    [state[0], state[1]] = [0.7, -1.3];
    let text = "size = wx^2 ; ratio=size/(1 + size); if(ratio > 0.9, 0, size*ratio) - t*ratio";
    let formula = formula_of_state_in_si(text).unwrap();
    let (size, ratio) = (1.3 * 1.3, 1.3 * 1.3 / (1.0 + 1.3 * 1.3));
    assert!((formula.evaluate(&state) - (size * ratio - 0.7 * ratio)).abs() < 1e-15);
    for (text, message) in [
        ("wx = 2; wx", "column 1: expected a new name, found \"wx\""),
        ("a = 2; a = 3; a", "column 8: expected a new name, found \"a\""),
        ("sin = 2; 1", "column 1: expected a new name, found \"sin\""),
        ("a = 2", "column 6: expected ; after a local value, found the end of the formula"),
        ("a = 2;", "column 7: expected a number, a name or (, found the end of the formula"),
        ("a = (2; a", "column 7: expected an operator or ), found \";\""),
        ("t; wx", "column 2: expected an operator or the end, found \";\""),
        ("a = b; b = 2; a", "column 5: unknown variable b"),
    ] {
        let error = formula_of_state_in_si(text).unwrap_err();
        assert_eq!(error.to_string(), message, "{text}");
    }
    assert!(formula_of_state("a = 2 N m; a", None).is_err());
}

#[test]
fn the_book_lists_every_function() {
    let page = concat!(env!("CARGO_MANIFEST_DIR"), "/../../book/scenario-torque-formulas.md");
    let page = std::fs::read_to_string(page).unwrap();
    let (_, listed) = page.split_once("A formula has numbers").unwrap();
    let (listed, _) = listed.split_once("and these variables").unwrap();
    let hint = Expression::parse("foo(x)", &XYZ).unwrap_err().hint().unwrap();
    let names = hint.trim_start_matches("the functions are ").split(';').next().unwrap();
    let words: Vec<&str> = listed.split(|c: char| !c.is_ascii_alphanumeric()).collect();
    for name in names.split(", ") {
        assert!(words.contains(&name), "{name}");
    }
}
