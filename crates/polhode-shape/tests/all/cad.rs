//! CAD reports: units, decimal marks, and the sign of the products proved from the report itself.

pub(crate) mod programs;

use polhode::body::{InertiaTensor, MassProperties};
use polhode::math::{Body, Position};
use polhode_shape::cad::{
    CadOptions, CadProduct, CadReport, DecimalMark, ProductConvention, SignSource, read,
};
use polhode_source::{ContentError, ContentErrorKind};

use programs::*;

/// Returns a body with three different moments, products of mixed signs, mass ≠ 1, and a centre
/// outside the coordinate planes.
fn generic() -> MassProperties<Body> {
    let tensor =
        InertiaTensor::with_negative_products([0.0273, 0.0419, 0.0351], [-0.0067, 0.0032, 0.0049]).unwrap();
    MassProperties::new(2.347, Position::new(0.0631, -0.1177, 0.0894), tensor).unwrap()
}

const GRAMS: Print = Print {
    sign: ProductConvention::Positive,
    words: ["grams", "millimeters"],
    units: [1e-3, 1e-3],
    number: two_decimals,
};

const BOTH: [ProductConvention; 2] = [ProductConvention::Negative, ProductConvention::Positive];

#[track_caller]
fn assert_close(report: &CadReport, body: &MassProperties<Body>, tolerance: f64) {
    let (found, want) = (&report.properties, body);
    assert!((found.mass() / want.mass() - 1.0).abs() < tolerance, "{} {}", found.mass(), want.mass());
    for (a, b) in found.center_of_mass().to_array().iter().zip(want.center_of_mass().to_array()) {
        assert!((a - b).abs() < tolerance * 0.1, "{a} {b}");
    }
    let (found, want) = (found.inertia().matrix(), want.inertia().matrix());
    for (a, b) in found.as_flattened().iter().zip(want.as_flattened()) {
        assert!((a - b).abs() < tolerance * 0.04, "{found:?} {want:?}");
    }
}

fn told(products: ProductConvention) -> CadOptions {
    CadOptions { products: Some(products), ..CadOptions::default() }
}

#[track_caller]
fn refused(text: &str) -> ContentError {
    read(text, &CadOptions::default()).unwrap_err()
}

#[test]
fn every_program_and_both_signs_are_proved_and_read() {
    let body = generic();
    let pound = 0.453_592_37;
    for sign in BOTH {
        let print = Print { sign, ..GRAMS };
        let pounds = Print { words: ["pounds", "inches"], units: [pound, 0.0254], ..print };
        let reports = [
            (solidworks(&body, print), CadProduct::SolidWorks, 1e-4),
            (solidworks(&body, Print { number: german, ..print }), CadProduct::SolidWorks, 1e-4),
            (
                solidworks(&body, Print { number: |v| format!("{v:.4}"), ..pounds }),
                CadProduct::SolidWorks,
                1e-3,
            ),
            (
                solidworks(
                    &body,
                    Print {
                        words: ["kilograms", "meters"],
                        units: [1.0, 1.0],
                        number: eight_decimals_comma,
                        ..print
                    },
                ),
                CadProduct::SolidWorks,
                1e-6,
            ),
            (
                fusion(&body, Print { words: ["g", "mm"], number: fusion_number, ..print }),
                CadProduct::Fusion,
                1e-3,
            ),
            (
                fusion(&body, Print { words: ["lbmass", "in"], number: |v| format!("{v:.3}"), ..pounds }),
                CadProduct::Fusion,
                1e-3,
            ),
            (
                creo(&body, Print { words: ["GRAM", "MM"], number: |v| creo_number(v, 7), ..print }),
                CadProduct::Creo,
                1e-7,
            ),
            (
                creo(
                    &body,
                    Print {
                        words: ["POUND", "INCH"],
                        units: [pound, 0.0254],
                        number: |v| creo_number(v, 7),
                        sign,
                    },
                ),
                CadProduct::Creo,
                1e-7,
            ),
        ];
        for (text, product, tolerance) in reports {
            let report = read(&text, &CadOptions::default()).unwrap_or_else(|e| panic!("{e}\n{text}"));
            assert_eq!(report.product, product);
            assert_eq!(
                (report.proof.by, report.proof.convention),
                (SignSource::ParallelAxis, sign),
                "{text}"
            );
            let residuals = [report.proof.residual_negative, report.proof.residual_positive];
            let right = residuals[BOTH.iter().position(|s| *s == sign).unwrap()];
            assert!(right <= 1.0, "{residuals:?}");
            assert!(residuals.into_iter().fold(0.0, f64::max) > 100.0, "{residuals:?}");
            assert!(report.proof.rounding < 0.01 && report.findings.is_empty());
            assert_close(&report, &body, tolerance);
        }
    }
}

#[test]
fn scalars_and_units_are_read() {
    let report =
        read(&fusion(&generic(), Print { words: ["g", "mm"], ..GRAMS }), &CadOptions::default()).unwrap();
    assert_eq!(report.surface_area, Some(5876.196e-6));
    assert_eq!(report.volume, Some(293_375e-9));
    assert_eq!(report.density, Some(8000.0));
}

#[test]
fn without_the_origin_the_axes_or_the_moments_prove_it() {
    let body = generic();
    for sign in BOTH {
        let print = Print { sign, ..GRAMS };
        let whole = solidworks(&body, print);
        let central = &whole[..whole.rfind("Moments of inertia").unwrap()];
        assert!(matches!(refused(central).kind, ContentErrorKind::Unclear { .. }));
        let report = read(&(principal(&body, print) + central), &CadOptions::default()).unwrap();
        assert_eq!((report.proof.by, report.proof.convention), (SignSource::PrincipalAxes, sign));
        assert_close(&report, &body, 1e-4);

        let text = onshape(
            &body,
            Print { words: ["kg", "m"], units: [1.0, 1.0], number: |v| format!("{v:.6}"), ..print },
        );
        let report = read(&text, &CadOptions::default()).unwrap_or_else(|e| panic!("{e}\n{text}"));
        assert_eq!(report.product, CadProduct::Onshape);
        assert_eq!((report.proof.by, report.proof.convention), (SignSource::PrincipalMoments, sign));
        assert!(report.proof.residual_negative.max(report.proof.residual_positive) > 100.0);
        assert_close(&report, &body, 1e-4);
    }
}

#[test]
fn only_the_origin_is_enough_with_a_proof() {
    let body = generic();
    for sign in BOTH {
        let print = Print { sign, ..GRAMS };
        let whole = solidworks(&body, print);
        let [from, to] = [whole.find("Moments").unwrap(), whole.rfind("Moments").unwrap()];
        let text = format!("{}{}{}", &whole[..from], &whole[to..], principal(&body, print));
        let report = read(&text, &CadOptions::default()).unwrap();
        assert_eq!((report.proof.by, report.proof.convention), (SignSource::PrincipalAxes, sign));
        assert_eq!(report.findings[0].code, "cad.moved");
        assert_close(&report, &body, 1e-3);
    }
}

#[test]
fn where_nothing_proves_the_sign_it_is_asked() {
    let body = generic();
    let centered = MassProperties::new(body.mass(), Position::ZERO, *body.inertia()).unwrap();
    let on_axis =
        MassProperties::new(body.mass(), Position::new(0.0, -0.1177, 0.0), *body.inertia()).unwrap();
    for body in [centered, on_axis] {
        for sign in BOTH {
            let text = solidworks(&body, Print { sign, ..GRAMS });
            let error = refused(&text);
            let ContentErrorKind::ProductSign { by: "parallel axes", negative, positive } = error.kind else {
                panic!("{error}")
            };
            assert!(negative <= 1.0 && positive <= 1.0, "{negative} {positive}");
            assert!(error.hint.unwrap().contains("--products"));
            // The given sign is used, and so is the opposite one.
            let report = read(&text, &told(sign)).unwrap();
            assert_eq!((report.proof.by, report.proof.convention), (SignSource::Told, sign));
            assert_close(&report, &body, 1e-4);
        }
    }
}

#[test]
fn two_products_that_vanish_leave_the_eigenvalues_alike() {
    // The body is symmetric about the plane z = 0: I_xz = I_yz = 0, and the moments do not depend
    // on the sign of `I_xy`.
    let tensor =
        InertiaTensor::with_negative_products([0.0273, 0.0419, 0.0351], [-0.0067, 0.0, 0.0]).unwrap();
    let body = MassProperties::new(2.347, Position::ZERO, tensor).unwrap();
    let text = onshape(
        &body,
        Print { words: ["kg", "m"], units: [1.0, 1.0], number: |v| format!("{v:.6}"), ..GRAMS },
    );
    let error = refused(&text);
    let ContentErrorKind::ProductSign { by: "the principal moments", negative, positive } = error.kind else {
        panic!("{error}")
    };
    assert!(negative <= 1.0 && positive <= 1.0);
    // The axes depend on it.
    let whole = solidworks(&body, GRAMS) + &principal(&body, GRAMS);
    let report = read(&whole, &CadOptions::default()).unwrap();
    assert_eq!((report.proof.by, report.proof.convention), (SignSource::PrincipalAxes, GRAMS.sign));
    assert_close(&report, &body, 1e-4);
}

#[test]
fn without_products_there_is_no_sign_to_ask_for() {
    let tensor = InertiaTensor::diagonal([0.0273, 0.0419, 0.0351]).unwrap();
    let body = MassProperties::new(2.347, Position::new(0.0, -0.1177, 0.0), tensor).unwrap();
    let report = read(&solidworks(&body, GRAMS), &CadOptions::default()).unwrap();
    assert_eq!(report.proof.by, SignSource::NoProducts);
    assert_close(&report, &body, 1e-4);
}

#[test]
fn a_report_that_contradicts_itself_is_refused_with_both_residuals() {
    let body = generic();
    let heavier = MassProperties::new(2.4, body.center_of_mass(), *body.inertia()).unwrap();
    let text = solidworks(&body, GRAMS).replace("Mass = 2347.00", "Mass = 2400.00");
    assert_eq!(GRAMS.mass(&heavier), "2400.00");
    let error = refused(&text);
    let ContentErrorKind::ProductSign { negative, positive, .. } = error.kind else { panic!("{error}") };
    assert!(negative > 10.0 && positive > 10.0);
    assert!(
        error.to_string().contains("parallel axes") && error.hint.unwrap().contains("contradicts itself")
    );
    let report = read(&text, &told(ProductConvention::Positive)).unwrap();
    assert_eq!(report.findings[0].code, "cad.contradiction");

    // A single product with the wrong sign fits neither convention. On one side of the diagonal,
    // the matrix is not symmetric.
    let text = solidworks(&body, GRAMS);
    let [flipped, half] = [&["Ixz = ", "Izx = "][..], &["Ixz = "]].map(|labels| {
        labels.iter().fold(text.clone(), |text, label| text.replace(label, &format!("{label}-")))
    });
    assert!(matches!(refused(&flipped.replace("= --", "= ")).kind, ContentErrorKind::ProductSign { .. }));
    assert!(matches!(refused(&half).kind, ContentErrorKind::Value { .. }));
}

#[test]
fn what_rounding_makes_impossible_says_so() {
    // A plate: i1 + i2 = i3 exactly, and each moment is rounded separately.
    let tensor = InertiaTensor::diagonal([0.024, 0.034, 0.058]).unwrap();
    let body = MassProperties::new(2.347, Position::new(0.0, -0.1177, 0.0), tensor).unwrap();
    let print = Print { words: ["kilograms", "meters"], units: [1.0, 1.0], ..GRAMS };
    let error = refused(&solidworks(&body, print));
    assert!(matches!(error.kind, ContentErrorKind::Body(_)), "{error}");
    assert!(error.hint.unwrap().contains("print more digits"));
}

#[test]
fn a_volume_without_a_unit_is_left_out_with_a_finding() {
    let text = solidworks(&generic(), GRAMS);
    let report = read(&text.replace(" cubic millimeters", ""), &CadOptions::default()).unwrap();
    assert_eq!((report.volume, report.findings[0].code), (None, "cad.no-unit"));
    assert_eq!(read(&text, &CadOptions::default()).unwrap().volume, Some(3e-4));
}

#[test]
fn a_told_unit_is_positive() {
    let text = solidworks(&generic(), GRAMS);
    for unit in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(read(&text, &CadOptions { length_unit: Some(unit), ..CadOptions::default() }).is_err());
        assert!(read(&text, &CadOptions { mass_unit: Some(unit), ..CadOptions::default() }).is_err());
    }
}

#[test]
fn a_told_sign_does_not_overrule_a_proof() {
    let text = solidworks(&generic(), GRAMS);
    let error = read(&text, &told(ProductConvention::Negative)).unwrap_err();
    assert!(error.to_string().contains("proved by parallel axes"), "{error}");
    assert!(read(&text, &told(ProductConvention::Positive)).is_ok());
}

#[test]
fn the_words_of_the_report_count_where_nothing_proves_more() {
    let body = generic();
    let centered = MassProperties::new(body.mass(), Position::ZERO, *body.inertia()).unwrap();
    let worded = |text: &str, word: &str| {
        text.replace("system.\n", &format!("system. (Using {word} tensor notation.)\n"))
    };
    let text = worded(&solidworks(&centered, GRAMS), "positive");
    let report = read(&text, &CadOptions::default()).unwrap();
    assert_eq!((report.proof.by, report.proof.convention), (SignSource::Stated, ProductConvention::Positive));
    assert_close(&report, &centered, 1e-4);
    // A proof overrides the words of the report.
    let text = worded(&solidworks(&body, GRAMS), "negative");
    let report = read(&text, &CadOptions::default()).unwrap();
    assert_eq!(
        (report.proof.by, report.proof.convention),
        (SignSource::ParallelAxis, ProductConvention::Positive)
    );
    assert_eq!(report.findings[0].code, "cad.notation");
}

#[test]
fn an_open_decimal_mark_is_asked() {
    // Numbers with one to three digits and three decimals: 273.500 kg·m² or 273 500?
    let tensor =
        InertiaTensor::with_negative_products([273.5, 419.25, 351.125], [-67.25, 32.5, 49.75]).unwrap();
    let body = MassProperties::new(123.4, Position::new(1.5, -2.25, 3.125), tensor).unwrap();
    let number = |v| format!("{v:.3}");
    let print = Print { number, words: ["kilograms", "meters"], units: [1.0, 1.0], ..GRAMS };
    let text = solidworks(&body, print).replace("Volume = 0.000 cubic meters\n", "");
    // About the origin there are numbers above 1000, which determine the mark. Without them it is
    // ambiguous.
    assert_close(&read(&text, &CadOptions::default()).unwrap(), &body, 1e-12);
    let point = text[..text.rfind("Moments").unwrap()].to_owned();
    let comma = point.replace('.', ",").replace("system,", "system.");
    for (text, decimal) in [(point, DecimalMark::Point), (comma, DecimalMark::Comma)] {
        let error = refused(&text);
        let ContentErrorKind::Unclear { found, .. } = &error.kind else { panic!("{error}") };
        assert!(found.starts_with("123"), "{found}");
        assert!(error.hint.unwrap().contains("--decimal"));
        let options = CadOptions { decimal: Some(decimal), ..told(ProductConvention::Positive) };
        assert_close(&read(&text, &options).unwrap(), &body, 1e-12);
    }
}

#[test]
fn a_missing_unit_is_asked_and_told() {
    let body = generic();
    let text = solidworks(&body, GRAMS);
    let bare = text
        .replace(" grams\n", "\n")
        .replace("( grams *  square millimeters )", "")
        .replace("( millimeters )", "");
    let error = refused(&bare);
    assert!(
        matches!(&error.kind, ContentErrorKind::Unclear { question, .. } if question.contains("the mass"))
    );
    let options = CadOptions { mass_unit: Some(1e-3), ..CadOptions::default() };
    let error = read(&bare, &options).unwrap_err();
    assert!(error.hint.unwrap().contains("--unit"));
    let options = CadOptions { length_unit: Some(1e-3), ..options };
    assert_close(&read(&bare, &options).unwrap(), &body, 1e-4);
}

#[test]
fn a_truncated_paste_is_refused_wherever_it_ends() {
    let print = Print { words: ["GRAM", "MM"], number: |v| creo_number(v, 7), ..GRAMS };
    for text in [solidworks(&generic(), GRAMS), creo(&generic(), print)] {
        // After the last digit of the last required element, the report is complete.
        let last = ["Lzz", "Izz"].iter().filter_map(|l| text.rfind(l)).max().unwrap();
        for end in 0..=last {
            if let Ok(report) = read(&text[..end], &CadOptions::default()) {
                panic!("{report:?}\n{}", &text[..end])
            }
        }
    }
}

#[test]
fn two_reports_at_once_and_nonsense_are_refused() {
    let text = solidworks(&generic(), GRAMS);
    let error = refused(&format!("{text}\n{text}"));
    assert!(error.to_string().contains("given once"), "{error}");
    for nonsense in
        ["", "hello", "Mass = Mass = 3", "Ixx Ixy Ixz", "Center of mass:", "Mass = 1,2,3 kg", "\u{feff}"]
    {
        let _ = refused(nonsense);
    }
    assert!(matches!(
        refused(&text.replace("Mass = 2347.00", "Mass = 1e999")).kind,
        ContentErrorKind::Value { .. }
    ));
    assert!(matches!(
        refused(&text.replace("Mass = ", "Mass = -")).kind,
        ContentErrorKind::ProductSign { .. }
    ));
}

#[test]
fn comments_and_tables_around_a_report_do_no_harm() {
    let text = solidworks(&generic(), GRAMS);
    let commented: String = text.lines().map(|line| format!("#  {line}\r\n")).collect();
    let table: String = text.lines().map(|line| format!("|{} |\n", line.replace('\t', "| "))).collect();
    let options = CadOptions::default();
    for decorated in [commented, table] {
        assert_eq!(read(&decorated, &options).unwrap().properties, read(&text, &options).unwrap().properties);
    }
}

#[test]
fn a_tensor_about_the_centre_of_mass_needs_no_centre() {
    let body = generic();
    let print =
        Print { words: ["KILOGRAM", "MM"], units: [1.0, 1e-3], number: |v| creo_number(v, 7), sign: BOTH[0] };
    let whole = creo(&body, print);
    let block = |point: &str| {
        let from = whole.find(&format!("INERTIA {point}with")).unwrap();
        let end = whole[from + 1..].find("INERTIA at").map_or(whole.len(), |k| from + 1 + k);
        let mass = whole.lines().find(|line| line.starts_with("MASS")).unwrap();
        format!("{mass}\n\n{}", &whole[from..end])
    };
    let told = CadOptions { products: Some(BOTH[0]), ..CadOptions::default() };
    let report = read(&block("at CENTER OF GRAVITY "), &told).unwrap();
    assert_eq!(report.findings.iter().map(|f| f.code).collect::<Vec<_>>(), ["cad.no-center"]);
    for (found, want) in
        report.properties.inertia().matrix().iter().flatten().zip(body.inertia().matrix().iter().flatten())
    {
        assert!((found - want).abs() < 1e-6 * body.inertia().matrix()[0][0]);
    }
    // About the origin, the tensor requires the centre. A centre without numbers does not mean the
    // origin.
    let error = read(&block(""), &told).unwrap_err();
    assert!(error.to_string().contains("centre of mass"), "{error}");
    let named = format!("Center of mass: see drawing\n{}", block("at CENTER OF GRAVITY "));
    assert!(read(&named, &told).is_err());
}

#[test]
fn headings_of_other_languages_are_named() {
    let german = "Masse = 2347.00 Gramm\nVolumen = 1.0 Kubikmillimeter\nMassenschwerpunkt: ( Millimeter )\n\tX = 1.0\n\
                  Trägheitsmomente: ( Gramm * Quadratmillimeter )\nLxx = 1 Lxy = 0 Lxz = 0\n";
    let error = refused(german);
    assert!(error.to_string().contains("German headings"), "{error}");
    let hint = error.hint.unwrap();
    assert!(
        ["Mass", "Density", "Center of mass", "Moments of inertia"].iter().all(|word| hint.contains(word))
    );
    // A report with one translated line is still not readable.
    let half = german.replace("Masse", "Mass").replace("Gramm", "grams");
    assert!(refused(&half).to_string().contains("German"));
    for (text, language) in [
        ("质量 = 1.2 克\n重心: ( 毫米 )\n惯性张量", "Chinese"),
        ("Masse = 1.2 grammes\nCentre de gravité: ( millimètres )\nMoments d'inertie", "French"),
    ] {
        assert!(refused(text).to_string().contains(language));
    }
    // For an unknown language, the error lists the missing quantity.
    let hungarian = "T\u{f6}meg = 2 kg\nT\u{f6}megk\u{f6}z\u{e9}ppont\n";
    let error = read(hungarian, &CadOptions::default()).unwrap_err();
    assert_eq!(error.to_string(), "the file has no mass");
    assert!(
        error.hint.as_deref().unwrap().contains("in English; polhode reads the headings: Mass, Volume"),
        "{error}"
    );
}
