//! Units: correct rounding, the official definitions, and every kind of error.

use polhode_source::unit::{Dimension, UnitError, parse};

/// Random generator of Knuth's MMIX; its high bits are good.
struct Random(u64);

impl Random {
    fn below(&mut self, n: u64) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((u128::from(self.0) * u128::from(n)) >> 64) as u64
    }
}

/// Returns true if `value` is a double nearest to above/below, computed in integers. Requires
/// `below` < 2^72.
fn is_nearest(value: f64, above: u128, below: u128) -> bool {
    let bits = value.to_bits();
    let (significand, exponent) = (bits & ((1 << 52) - 1) | 1 << 52, (bits >> 52) as i32 - 1075);
    // |significand · 2^exponent − above/below| ≤ 2^exponent / 2
    let (left, right) = (2 * u128::from(significand) * below, 2 * above);
    match u32::try_from(exponent) {
        Ok(shift) => (left << shift).abs_diff(right) <= below << shift,
        Err(_) => left.abs_diff(right << -exponent) <= below,
    }
}

/// π as a fraction with error 2.5e-27; different from the fraction in the library.
const PI: (u128, u128) = (8_958_937_768_937, 2_851_718_461_558);

const LBF: u128 = 44_482_216_152_605; // 1e-13 N

/// Unit, dimension, SI value as a fraction of integers, and true if it is multiplied by π.
///
/// SI Brochure, 9th ed. (2019), tables 4, 7, 8; NIST SP 811 (2008), appendix B.8: lb 0.453 592 37 kg
/// (footnote 22), lbf 4.448 221 615 260 5 N (footnote 23), slug lbf s²/ft, oz lb/16, foot 0.3048 m,
/// g₀ 9.806 65 m/s², all exact.
const DEFINITIONS: &[(&str, Dimension, u128, u128, bool)] = &[
    ("kg", Dimension::MASS, 1, 1, false),
    ("g", Dimension::MASS, 1, 1000, false),
    ("mg", Dimension::MASS, 1, 1_000_000, false),
    ("t", Dimension::MASS, 1000, 1, false),
    ("lb", Dimension::MASS, 45_359_237, 100_000_000, false),
    ("lbm", Dimension::MASS, 45_359_237, 100_000_000, false),
    ("oz", Dimension::MASS, 45_359_237, 1_600_000_000, false),
    ("slug", Dimension::MASS, LBF, 3_048_000_000_000, false),
    ("km", Dimension::LENGTH, 1000, 1, false),
    ("m", Dimension::LENGTH, 1, 1, false),
    ("dm", Dimension::LENGTH, 1, 10, false),
    ("cm", Dimension::LENGTH, 1, 100, false),
    ("mm", Dimension::LENGTH, 1, 1000, false),
    ("µm", Dimension::LENGTH, 1, 1_000_000, false),
    ("μm", Dimension::LENGTH, 1, 1_000_000, false),
    ("um", Dimension::LENGTH, 1, 1_000_000, false),
    ("in", Dimension::LENGTH, 254, 10_000, false),
    ("inch", Dimension::LENGTH, 3048, 120_000, false),
    ("ft", Dimension::LENGTH, 3048, 10_000, false),
    ("yd", Dimension::LENGTH, 3 * 3048, 10_000, false),
    ("mi", Dimension::LENGTH, 5280 * 3048, 10_000, false),
    ("cc", Dimension::VOLUME, 1, 1_000_000, false),
    ("au", Dimension::LENGTH, 149_597_870_700, 1, false),
    ("s", Dimension::TIME, 1, 1, false),
    ("ms", Dimension::TIME, 1, 1000, false),
    ("us", Dimension::TIME, 1, 1_000_000, false),
    ("µs", Dimension::TIME, 1, 1_000_000, false),
    ("ns", Dimension::TIME, 1, 1_000_000_000, false),
    ("min", Dimension::TIME, 60, 1, false),
    ("h", Dimension::TIME, 3600, 1, false),
    ("hr", Dimension::TIME, 3600, 1, false),
    ("d", Dimension::TIME, 86_400, 1, false),
    ("day", Dimension::TIME, 86_400, 1, false),
    ("rad", Dimension::ANGLE, 1, 1, false),
    ("mrad", Dimension::ANGLE, 1, 1000, false),
    ("µrad", Dimension::ANGLE, 1, 1_000_000, false),
    ("deg", Dimension::ANGLE, 1, 180, true),
    ("°", Dimension::ANGLE, 1, 180, true),
    ("arcmin", Dimension::ANGLE, 1, 180 * 60, true),
    ("arcsec", Dimension::ANGLE, 1, 180 * 3600, true),
    ("rev", Dimension::ANGLE, 2, 1, true),
    ("turn", Dimension::ANGLE, 2, 1, true),
    ("N", Dimension::FORCE, 1, 1, false),
    ("mN", Dimension::FORCE, 1, 1000, false),
    ("kN", Dimension::FORCE, 1000, 1, false),
    ("µN", Dimension::FORCE, 1, 1_000_000, false),
    ("lbf", Dimension::FORCE, LBF, 10_000_000_000_000, false),
    ("ozf", Dimension::FORCE, LBF, 160_000_000_000_000, false),
    ("kgf", Dimension::FORCE, 980_665, 100_000, false),
    ("lb g0", Dimension::FORCE, LBF, 10_000_000_000_000, false),
    ("J", Dimension::TORQUE, 1, 1, false),
    ("mJ", Dimension::TORQUE, 1, 1000, false),
    ("kJ", Dimension::TORQUE, 1000, 1, false),
    ("Nm", Dimension::TORQUE, 1, 1, false),
    ("kNm", Dimension::TORQUE, 1000, 1, false),
    ("mNm", Dimension::TORQUE, 1, 1000, false),
    ("Nmm", Dimension::TORQUE, 1, 1000, false),
    ("lbf ft", Dimension::TORQUE, LBF * 3048, 100_000_000_000_000_000, false),
    ("Nms", Dimension::ANGULAR_MOMENTUM, 1, 1, false),
    ("mNms", Dimension::ANGULAR_MOMENTUM, 1, 1000, false),
    ("N m s", Dimension::ANGULAR_MOMENTUM, 1, 1, false),
    ("kg m^2 rev/min", Dimension::ANGULAR_MOMENTUM, 2, 60, true),
    ("A", Dimension::CURRENT, 1, 1, false),
    ("mA", Dimension::CURRENT, 1, 1000, false),
    ("T", Dimension::MAGNETIC_FIELD, 1, 1, false),
    ("mT", Dimension::MAGNETIC_FIELD, 1, 1000, false),
    ("µT", Dimension::MAGNETIC_FIELD, 1, 1_000_000, false),
    ("uT", Dimension::MAGNETIC_FIELD, 1, 1_000_000, false),
    ("nT", Dimension::MAGNETIC_FIELD, 1, 1_000_000_000, false),
    ("G", Dimension::MAGNETIC_FIELD, 1, 10_000, false),
    ("N/(A m)", Dimension::MAGNETIC_FIELD, 1, 1, false),
    ("A cm^2", Dimension::MAGNETIC_MOMENT, 1, 10_000, false),
    ("N m/T", Dimension::MAGNETIC_MOMENT, 1, 1, false),
    ("km^3/s^2", Dimension::GRAVITATIONAL_PARAMETER, 1_000_000_000, 1, false),
    ("g0", Dimension::ACCELERATION, 980_665, 100_000, false),
    ("gee", Dimension::ACCELERATION, 980_665, 100_000, false),
    ("km/h/s", Dimension::ACCELERATION, 1000, 3600, false),
    ("km/h", Dimension::VELOCITY, 1000, 3600, false),
    ("rad/s", Dimension::ANGULAR_VELOCITY, 1, 1, false),
    ("1/min", Dimension::ANGULAR_VELOCITY, 1, 60, false),
    ("deg/h", Dimension::ANGULAR_VELOCITY, 1, 180 * 3600, true),
    ("rpm", Dimension::ANGULAR_VELOCITY, 2, 60, true),
    ("rev/min", Dimension::ANGULAR_VELOCITY, 2, 60, true),
    ("deg/s^2", Dimension::ANGULAR_ACCELERATION, 1, 180, true),
    ("1/s²", Dimension::ANGULAR_ACCELERATION, 1, 1, false),
    ("g/cm³", Dimension::DENSITY, 1000, 1, false),
    ("lb/in^3", Dimension::DENSITY, 45_359_237 * 10_000, 254 * 254 * 254, false),
    ("lb/ft^2", Dimension::AREA_DENSITY, 45_359_237, 3048 * 3048, false),
    ("g/m", Dimension::LINE_DENSITY, 1, 1000, false),
    ("slug ft^2", Dimension::INERTIA, LBF * 3048, 100_000_000_000_000_000, false),
    ("lbm in^2", Dimension::INERTIA, 45_359_237 * 254 * 254, 10_000_000_000_000_000, false),
    ("oz in^2", Dimension::INERTIA, 45_359_237 * 254 * 254, 160_000_000_000_000_000, false),
    ("g mm^2", Dimension::INERTIA, 1, 1_000_000_000, false),
];

#[test]
fn every_unit_is_its_definition_and_rounds_once() {
    let mut random = Random(7);
    for &(unit, dimension, above, below, pi) in DEFINITIONS {
        for _ in 0..300 {
            let (digits, places) = (1 + random.below(1 << 24), random.below(4));
            let exponent = random.below(2);
            let text = format!("{digits}e-{places} {unit}").replace("e-0", ["", "e+00"][exponent as usize]);
            let (mut n, mut d) = (u128::from(digits) * above, 10_u128.pow(places as u32) * below);
            if pi {
                (n, d) = (n * PI.0, d * PI.1);
            }
            assert!(d < 1 << 72, "the test itself overflows at {unit}");
            let value = parse(&text, dimension).unwrap();
            assert!(is_nearest(value, n, d), "{text} is {n}/{d}, not {value:e}");
        }
    }
}

#[test]
fn the_judge_of_roundings_tells_neighbours_apart() {
    for (value, above, below) in [(0.1_f64, 1, 10), (2e20 / 7.0, 200_000_000_000_000_000_000, 7), (3.0, 3, 1)]
    {
        assert!(is_nearest(value, above, below));
        assert!(!is_nearest(value.next_up(), above, below) && !is_nearest(value.next_down(), above, below));
    }
}

#[test]
fn round_numbers_stay_round() {
    let length = |text| parse(text, Dimension::LENGTH).unwrap();
    assert_eq!(length("3 in"), 0.0762);
    assert_eq!(length("25.4 mm"), 0.0254);
    assert_eq!(length("25.4mm"), 0.0254);
    assert_eq!(length("100 mm"), 0.1);
    assert_eq!(length("-7e-1 cm"), -0.007);
    assert_eq!(length(" +.5\u{a0}km "), 500.0);
    assert_eq!(parse("12 lbm", Dimension::MASS), Ok(5.44310844));
    assert_eq!(parse("90 deg", Dimension::ANGLE), Ok(std::f64::consts::FRAC_PI_2));
    assert_eq!(parse("-1 rev", Dimension::ANGLE), Ok(-std::f64::consts::TAU));
    assert_eq!(parse("90 km/h", Dimension::VELOCITY), Ok(25.0));
    assert_eq!(parse("1 g0", Dimension::ACCELERATION), Ok(9.80665));
    // One pound-force accelerates one slug by 1 ft/s².
    assert_eq!(parse("1 slug ft/s^2", Dimension::FORCE), parse("1 lbf", Dimension::FORCE));
    assert_eq!(parse("1 lbf s^2/ft", Dimension::MASS), parse("1 slug", Dimension::MASS));
}

#[test]
fn a_bare_number_is_what_the_standard_library_reads() {
    let mut random = Random(11);
    for _ in 0..20_000 {
        let digits = random.below(u64::MAX);
        let text = format!("{}.{digits}e{}", random.below(1000), random.below(660) as i64 - 340);
        let value: f64 = text.parse().unwrap();
        if value.is_finite() && value != 0.0 {
            assert_eq!(parse(&text, Dimension::TIME), Ok(value), "{text}");
            assert_eq!(parse(&format!("{text} s^2/s"), Dimension::TIME), Ok(value), "{text}");
        }
    }
    for text in ["0", "0.000", "-0", "0e99999999999999999999"] {
        assert_eq!(parse(text, Dimension::NONE), Ok(0.0), "{text}");
        assert_eq!(parse(&format!("{text} deg"), Dimension::ANGLE), Ok(0.0), "{text}");
    }
    let long = format!("0.{}1e700000", "0".repeat(699_999));
    assert_eq!(parse(&long, Dimension::NONE), Ok(1.0));
    let third = format!("0.{} deg/deg", "3".repeat(700_000));
    assert_eq!(parse(&third, Dimension::NONE), Ok(1.0 / 3.0));
}

#[test]
fn powers_are_exact_too() {
    // A turn is 360 deg, and 360^8 = 282 110 990 745 600 000 000.
    let angle = |text: &str| parse(text, Dimension::ANGLE).unwrap();
    assert_eq!(angle("3 turn^9/deg^8"), angle("8463329722368e8 turn"));
    assert_eq!(angle("2821109907456e8 deg^9/turn^8"), angle("1 deg"));
    assert_eq!(parse("0.7 rad^9/rev^9 rev^9/rad^9", Dimension::NONE), Ok(0.7));
    assert_eq!(parse("0.987654321987654300 rev^9/turn^9", Dimension::NONE), Ok(0.9876543219876543));
    assert_eq!(parse("0.7 lb^9/oz^9", Dimension::NONE), Ok(0.7 * 68_719_476_736.0)); // 16^9
}

#[test]
fn division_rounds_correctly_next_to_a_tie() {
    // (2^53 + 1) × 60 min⁻¹ is exactly halfway between two doubles in s⁻¹. The even one is correct;
    // the smallest additional digit decides otherwise.
    let per_minute = |text: &str| parse(&format!("{text} rad/min"), Dimension::ANGULAR_VELOCITY).unwrap();
    let tie = (9_007_199_254_740_993_u128 * 60).to_string();
    let zeros = "0".repeat(600);
    assert_eq!(per_minute(&tie), 9_007_199_254_740_992.0);
    assert_eq!(per_minute(&format!("{tie}.{zeros}1")), 9_007_199_254_740_994.0);
}

#[test]
fn the_same_unit_is_written_in_many_ways() {
    for text in [
        "3.7 kg m^2/s",
        "3.7 kg·m²/s",
        "3.7kg*m^2/s",
        "3.7 kg ⋅ m² s⁻¹",
        "3.7 kg m m/s",
        "3.7 kg/(s m^-2)",
        "3.7 (kg m^2)/s",
        "3.7 kg m²s^-1",
        "3.7 N m s",
        "3.7 Nm s",
        "3.7 Nms",
        "3.7 J s",
        "3.7 kg (m)^2 / s",
        "3.7 /s kg m^2",
        "3.7 1/s kg m^2",
        "3.7 kg m^2 rad/s",
        "3.7 kg (s/m²)⁻¹ m^0",
    ] {
        assert_eq!(parse(text, Dimension::ANGULAR_MOMENTUM), Ok(3.7), "{text}");
    }
    let pressure_rate = Dimension::new(1, -1, -1, 0);
    assert_eq!(parse("5 kg/m/s", pressure_rate), parse("5 kg/(m s)", pressure_rate));
    assert_eq!(parse("5 kg/m s", Dimension::new(1, -1, 1, 0)), Ok(5.0)); // left to right
}

#[test]
fn an_angle_counts_except_where_physics_drops_it() {
    use Dimension as D;
    for (text, dimension) in [
        ("2 1/s", D::ANGULAR_VELOCITY),
        ("2/s", D::ANGULAR_VELOCITY),
        ("2 1/s^2", D::ANGULAR_ACCELERATION),
        ("2 kg m^2 rad/s", D::ANGULAR_MOMENTUM),
        ("2 kg m^2 rad/s^2", D::TORQUE),
        ("2 kg m rad²/s²", D::FORCE),
    ] {
        assert_eq!(parse(text, dimension), Ok(2.0), "{text}");
    }
    for (text, expected, found) in [
        ("2 deg", D::NONE, D::ANGLE),
        ("2 deg", D::LENGTH, D::ANGLE),
        ("2 m/m", D::ANGLE, D::NONE),
        ("2 m rad/s", D::VELOCITY, D::new(0, 1, -1, 1)),
        ("2 kg rad", D::MASS, D::new(1, 0, 0, 1)),
        ("2 N m/rad", D::TORQUE, D::new(1, 2, -2, -1)),
        ("2 rad", D::ANGULAR_VELOCITY, D::ANGLE),
    ] {
        let unit = text[2..].to_owned();
        assert_eq!(parse(text, expected), Err(UnitError::WrongDimension { unit, found, expected }));
    }
}

#[test]
fn a_number_is_strict() {
    for text in [
        "",
        " ",
        "abc",
        "kg",
        "nan",
        "NaN",
        "inf",
        "-inf",
        "infinity",
        "--1",
        "+-1",
        "-",
        ".",
        "e5",
        ".e5",
        "1e",
        "1e+",
        "12eV",
        "1_000",
        "0x10",
        "1.2.3",
        "1..2",
        "1 00 kg",
        "0 100 kg",
        "5 5",
        "１２ kg",
        "1２",
        "5²",
        "0,5",
        "−−3 m",
        "1.,",
        "(5 m)",
        "½ m",
        "1 2/s",
    ] {
        assert_eq!(parse(text, Dimension::MASS), Err(UnitError::NotANumber { text: text.trim().to_owned() }));
    }
    let hint = |text| parse(text, Dimension::MASS).unwrap_err().hint().unwrap();
    assert!(hint("0,5 kg").starts_with("write 0.5: the decimal sign is a point"));
    assert!(hint("1,234 kg").starts_with("write 1.234 or 1234: the decimal sign is a point"));
    assert!(hint("twelve").starts_with("write a decimal number"));
    assert!(hint("1,2,3").starts_with("write a decimal number"));
}

#[test]
fn a_value_fits_into_a_double() {
    let lost = |text: &str| parse(text, Dimension::LENGTH).unwrap_err();
    for text in ["1e400", "-1e400 m", "1e308 km", "9e99999999999999999999", "1e307 au"] {
        assert_eq!(lost(text), UnitError::NotFinite { text: text.to_owned() });
    }
    for text in ["1e-400", "-1e-323 mm", "9e-99999999999999999999 m"] {
        assert_eq!(lost(text), UnitError::Underflow { text: text.to_owned() });
    }
    assert_eq!(parse("1e310 mm", Dimension::LENGTH), Ok(1e307));
    assert_eq!(parse("1e-324 km", Dimension::LENGTH), Ok(1e-321));
}

#[test]
fn a_misspelt_unit_is_told_the_right_one() {
    for (unit, meant) in [
        ("MM", Some("mm")),
        ("Kg", Some("kg")),
        ("lbs", Some("lb")),
        ("sec", Some("s")),
        ("Degrees", Some("deg")),
        ("slgu", Some("slug")),
        ("inc", Some("in")),
        ("m2", Some("m^2")),
        ("kg3", Some("kg^3")),
        ("nm", Some("Nm")),
        ("5", None),
        ("x", None),
        ("parsec", None),
        ("Pa", None),
    ] {
        let error = parse(&format!("4 m {unit}"), Dimension::LENGTH).unwrap_err();
        let suggestion = meant.map(str::to_owned);
        assert_eq!(error, UnitError::UnknownUnit { unit: unit.to_owned(), suggestion });
        assert_eq!(error.hint(), meant.map(|m| format!("did you mean {m}?")));
        assert_eq!(error.to_string(), format!("unknown unit \"{unit}\""));
    }
}

#[test]
fn a_malformed_unit_is_told_the_rule() {
    for (unit, rule) in [
        ("m/", "a factor is missing"),
        ("m *", "a factor is missing"),
        ("(m/)", "a factor is missing"),
        ("m//s", "names joined"),
        ("m ** 2", "names joined"),
        ("m^2^2", "names joined"),
        ("^2", "names joined"),
        ("()", "names joined"),
        ("lbf-ft", "names joined"),
        ("m,", "names joined"),
        ("/", "names joined"),
        ("m^", "is an integer"),
        ("m^x", "is an integer"),
        ("m^1.5", "names joined"),
        ("m^--2", "is an integer"),
        ("m²⁻", "is an integer"),
        ("m^300", "is an integer"),
        ("m^10", "-9 to 9"),
        ("(m^5)^2", "-9 to 9"),
        ("m^-128", "-9 to 9"),
        ("((m))", "cannot be nested"),
        ("(m", "unclosed parenthesis"),
        ("m)", "unmatched closing"),
        ("m s m s m s m s", "seven factors"),
    ] {
        let error = parse(&format!("4 {unit}"), Dimension::LENGTH).unwrap_err();
        let UnitError::Malformed { unit: whole, rule: told } = &error else { panic!("{unit}: {error:?}") };
        assert_eq!(whole, unit);
        assert!(told.contains(rule), "{unit}: {told}");
    }
}

#[test]
fn a_wrong_dimension_is_told_what_to_write() {
    use Dimension as D;
    let message = |text, expected| {
        let error = parse(text, expected).unwrap_err();
        (error.to_string(), error.hint().unwrap())
    };
    for (text, expected, sentence, hint) in [
        ("3 m", D::MASS, "\"m\" is a length where a mass belongs", "write a mass, such as \"12 kg\""),
        ("3 g", D::ACCELERATION, "a mass where an acc", "g is the gram; for standard gravity write g0"),
        (
            "3 lb",
            D::FORCE,
            "\"lb\" is a mass where a force",
            "lb, oz and kg are units of mass; units of force",
        ),
        ("3 lb ft", D::TORQUE, "a quantity in kg m where a torque", "lb, oz and kg are units of"),
        ("3 s", D::VELOCITY, "a time where a velocity", "write a velocity, such as \"3.5 m/s\""),
        ("3 Hz", D::ANGULAR_VELOCITY, "unknown unit \"Hz\"", "write rev/s or rad/s"),
        ("3 kg/s", D::DENSITY, "in kg s^-1 where a density", "write a density, such as \"2700 kg/m^3\""),
    ] {
        let (told, told_hint) = message(text, expected);
        assert!(told.contains(sentence), "{told}");
        assert!(told_hint.starts_with(hint), "{told_hint}");
    }
    let odd = parse("3 m", Dimension::new(2, 0, -3, 1)).unwrap_err();
    assert_eq!(odd.to_string(), "\"m\" is a length where a quantity in kg^2 s^-3 rad belongs");
    assert_eq!(odd.hint(), None);
}

#[test]
fn every_example_in_a_hint_can_be_written() {
    use Dimension as D;
    let all = [
        D::NONE,
        D::MASS,
        D::LENGTH,
        D::TIME,
        D::ANGLE,
        D::VELOCITY,
        D::ACCELERATION,
        D::ANGULAR_VELOCITY,
        D::ANGULAR_ACCELERATION,
        D::DENSITY,
        D::AREA_DENSITY,
        D::LINE_DENSITY,
        D::INERTIA,
        D::ANGULAR_MOMENTUM,
        D::TORQUE,
        D::FORCE,
        D::GRAVITATIONAL_PARAMETER,
        D::CURRENT,
        D::MAGNETIC_FIELD,
        D::MAGNETIC_MOMENT,
    ];
    for expected in all {
        let hint = parse("1 kg^2", expected).unwrap_err().hint().unwrap();
        let example = hint.split('"').nth(1).unwrap();
        assert!(parse(example, expected).is_ok_and(|value| value > 0.0), "{hint}");
        for other in all.into_iter().filter(|&other| other != expected && expected != D::NONE) {
            let angle_dropped = parse(example, other).is_ok();
            assert!(!angle_dropped || example == "0.5", "{example} passed for {other}");
        }
    }
}

#[test]
fn long_text_makes_a_short_message() {
    let error = parse(&"9\u{1b}[31m".repeat(10_000), Dimension::MASS).unwrap_err();
    assert!(error.to_string().len() < 400 && !error.to_string().contains('\u{1b}'));
}

#[test]
fn no_text_panics() {
    let pieces = [
        "1", "-", "+", ".", "e", "E9", "9999", "0", " ", "m", "kg", "deg", "/", "*", "·", "(", ")", "^", "²",
        "⁻¹", "-9", "°", "µ", "μm", "１", "½", ",", "_", "−", "\u{0}", "\u{301}", "slug", "rpm", "8",
    ];
    let mut random = Random(3);
    let mut read = 0;
    for _ in 0..50_000 {
        let count = 1 + random.below(9);
        let tail: String = (0..count).map(|_| pieces[random.below(pieces.len() as u64) as usize]).collect();
        for text in [format!("3{tail}"), tail] {
            match parse(&text, Dimension::LENGTH) {
                Ok(value) => {
                    read += 1;
                    assert!(value.is_finite(), "{text}");
                }
                Err(error) => assert!(!error.to_string().is_empty() && error.hint() != Some(String::new())),
            }
        }
    }
    assert!(read > 500, "{read}");
}
