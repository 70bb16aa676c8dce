//! Symbols: named quantities, and formulas of them in place of quantities.

use std::path::Path;

use polhode::motion::Scenario;
use polhode_scenario::read::{self as scenario, Draft, Template};
use polhode_source::FormatError;
use polhode_source::files::Memory;

fn parse(text: &str) -> Result<Scenario, FormatError> {
    scenario::parse(text, Path::new("test.toml"))
}

/// Returns a body of two parts with these symbols.
fn named(symbols: &str) -> String {
    format!(
        "[symbols]\n{symbols}\n
         [[body.part]]\nshape = 'box'\nsize = ['b', '2*b', 'b/3 + 1 cm']\nmass = 'M/4 + 100 g'
         position = ['-b', 'b^2/L', '(L - b)/2']\nrotate = {{ axis = [1, 2, 3], angle = 'alpha/2' }}
         [[body.part]]\nshape = 'sphere'\nradius = 'sqrt(b*L)/9'\ndensity = 'M/(b*L^2)'
         [start]\nspin = {{ body = ['omega', 0, '-omega/3'] }}
         [run]\nduration = '2*pi/omega'\nsamples = 3\n"
    )
}

const SYMBOLS: &str = "M = '3 kg'\nb = '20 cm'\nL = 0.7\nalpha = '50 deg'\nomega = '1.7 rad/s'";

fn with_length(symbols: &str) -> String {
    named(&symbols.replace("L = 0.7", "L = '700 mm'"))
}

#[test]
fn a_formula_stands_in_place_of_a_quantity() {
    let read = parse(&with_length(SYMBOLS)).unwrap();
    let plain = parse(
        "[[body.part]]\nshape = 'box'\nsize = [0.2, 0.4, 0.0766666666666666667]\nmass = 0.85
         position = [-0.2, 0.0571428571428571428, 0.25]\nrotate = { axis = [1, 2, 3], angle = '25 deg' }
         [[body.part]]\nshape = 'sphere'\nradius = 0.0415739709641549053\ndensity = 30.6122448979591837
         [start]\nspin = { body = [1.7, 0, -0.566666666666666667] }
         [run]\nduration = 3.69599135716446270\nsamples = 3\n",
    )
    .unwrap();
    let near = |a: f64, b: f64| assert!((a - b).abs() <= 4e-15 * b.abs().max(1e-3), "{a} is not {b}");
    near(read.body().mass(), plain.body().mass());
    for k in 0..3 {
        near(read.body().center_of_mass().to_array()[k], plain.body().center_of_mass().to_array()[k]);
        near(read.start().omega.to_array()[k], plain.start().omega.to_array()[k]);
        for j in 0..3 {
            near(read.body().inertia().matrix()[k][j], plain.body().inertia().matrix()[k][j]);
        }
    }
    near(*read.run().unwrap().times.last().unwrap(), *plain.run().unwrap().times.last().unwrap());
}

#[test]
fn a_wrong_symbol_or_formula_is_refused_at_its_place() {
    let refused = |text: &str, message: &str, hint: &str| {
        let error = parse(text).unwrap_err();
        assert_eq!(error.to_string(), message);
        assert!(error.hint().unwrap_or_default().starts_with(hint), "{:?}", error.hint());
    };
    let ball = |symbols: &str, radius: &str| {
        format!("[symbols]\n{symbols}\n[[body.part]]\nshape = 'sphere'\nradius = '{radius}'\nmass = 'M'\n")
    };
    refused(&ball("M = '1 kg'", "size/2"), "test.toml:5:11: unknown variable size", "the variables are M");
    refused(
        &ball("M = '1 kg'\nside = '1 m'", "sidee/2"),
        "test.toml:6:11: unknown variable sidee",
        "did you mean side?",
    );
    refused(
        &ball("M = '1 kg'\nb = '1 m'", "b*b/2"),
        "test.toml:6:11: the value is a quantity in m^2, where a length belongs",
        "",
    );
    refused(
        &ball("M = '1 kg'\nb = '1 m'", "2 b"),
        "test.toml:6:13: expected an operator, ) or the end, found \"b\"",
        "a product is written with *",
    );
    refused(
        &ball("M = '1 kg'\nb = '-1 m'", "b/2"),
        "test.toml:6:10: radius = 'b/2' must be positive",
        "a size",
    );
    refused(
        &ball("M = '1 kg'\nb = '0 m'", "1 m^2/b"),
        "test.toml:6:11: 1 m^2/b is beyond the range of a double",
        "",
    );
    refused(
        &ball("M = '1 kg'\nb = '1 m'", "1 m"),
        "test.toml:3:5: symbols = '1 m' must be in a formula of the scenario, such as \"b/2\"",
        "use b in a formula, or remove it",
    );
    refused(
        &ball("M = '1 kg'\nm = '1 m'", "m/2"),
        "test.toml:3:5: a symbol = m must be no unit of its own dimension",
        "\"2 m\" would be unclear",
    );
    refused(
        &ball("M = '1 kg'\nsqrt = '1 m'", "1 m"),
        "test.toml:3:8: a symbol = sqrt must be no name that formulas already have",
        "rename",
    );
    refused(
        &ball("M = '1 kg'\n'2b' = '1 m'", "1 m"),
        "test.toml:3:8: a symbol = 2b must be a letter, then letters, digits and _",
        "rename",
    );
    refused(&ball("M = 'heavy'", "1 m"), "test.toml:2:5: \"heavy\" is not a number", "");
    // 150 m is hardly meant. A symbol without a unit gives no unit to a formula.
    let size = |b: &str| {
        format!(
            "[symbols]\nM = '1 kg'\nb = {b}\n[[body.part]]\nshape = 'box'\nsize = ['b/2', 0.7, '2*b']\nmass = 'M'\n"
        )
    };
    refused(
        &size("'30 cm'"),
        "test.toml:6:16: size = 0.7 must be given with its unit, like the other element \"b/2\"",
        "write its unit after the number",
    );
    refused(
        &size("0.3"),
        "test.toml:6:10: the value is a plain number, where a length belongs",
        "write the unit after",
    );
    // Without symbols, a formula is not a quantity.
    let error = parse("[[body.part]]\nshape = 'sphere'\nradius = 'b/2'\nmass = 1\n").unwrap_err();
    assert!(error.message().contains("not a number"), "{error}");
}

#[test]
fn a_symbol_named_as_a_unit_of_another_dimension_is_accepted() {
    let text = "[symbols]\nm = '3 kg'\ng = '9.8 m/s^2'\n[[body.part]]\nshape = 'sphere'\nradius = '2 m'\nmass = 'm/4'\n
                [body]\npivot = [0, 0, 1]\n[[torque]]\nmodel = 'gravity'\nacceleration = [0, '-g', 'g/2']\n";
    let read = parse(text).unwrap();
    assert_eq!(read.body().mass(), 0.75);
}

#[test]
fn all_formulas_follow_a_varied_symbol() {
    let plan = with_length(SYMBOLS)
        + "[sweep]\nmembers = 4\nsampling = 'monte carlo'\nvary = [{ key = 'symbols.b', uniform = { from = '10 cm', to = '30 cm' } }]\n";
    let template = Template::parse(&Memory::default(), plan, Path::new("plan.toml")).unwrap();
    let b = template.sweep().unwrap().vary[0].target.clone();
    assert_eq!(b.nominal(), [0.2]);
    for length in [0.13, 0.2, 0.29] {
        let member = template.scenario([(&b, &[length][..])]).unwrap();
        let written = parse(&with_length(&SYMBOLS.replace("20 cm", &format!("{length} m")))).unwrap();
        assert_eq!(member.body().inertia().matrix(), written.body().inertia().matrix());
        assert_eq!(member.body().center_of_mass().to_array(), written.body().center_of_mass().to_array());
    }
}

#[test]
fn another_key_may_vary_beside_formulas() {
    let plan = with_length(SYMBOLS)
        + "[sweep]\nmembers = 4\nsampling = 'monte carlo'\nvary = [{ key = 'body.part[1].position[0]', uniform = { from = '1 cm', to = '3 cm' } }]\n";
    let plan = plan.replace("radius = 'sqrt", "position = ['2 cm', 0, 0]\nradius = 'sqrt");
    let template = Template::parse(&Memory::default(), plan.clone(), Path::new("plan.toml")).unwrap();
    let key = template.sweep().unwrap().vary[0].target.clone();
    for x in [0.011, 0.02, 0.029] {
        let member = template.scenario([(&key, &[x][..])]).unwrap();
        let written = plan.replace("['2 cm', 0, 0]", &format!("['{x} m', 0, 0]"));
        let written = parse(written.split("[sweep]").next().unwrap()).unwrap();
        assert_eq!(member.body().inertia().matrix(), written.body().inertia().matrix());
    }
}

#[test]
fn an_edited_symbol_changes_unedited_formulas() {
    let mut draft = Draft::new(Path::new("test.toml"), []);
    for length in ["20 cm", "25 cm", "20 cm"] {
        let text = with_length(&SYMBOLS.replace("20 cm", length));
        let read = draft.read(&Memory::default(), text.clone()).unwrap();
        assert_eq!(read.scenario.body().inertia().matrix(), parse(&text).unwrap().body().inertia().matrix());
    }
    let keys: Vec<String> = draft.numbers().into_iter().map(|number| number.key).collect();
    assert!(
        keys.contains(&"symbols.b".to_owned()) && !keys.contains(&"body.part[0].size[0]".to_owned()),
        "{keys:?}"
    );
}

#[test]
fn a_plain_number_stands_beside_a_sine_but_not_beside_an_angle() {
    let text = |axis: &str, angles: &str| {
        format!(
            "[symbols]\nalpha = '30 deg'\n[[body.part]]\nshape = 'box'\nsize = [1, 2, 3]\nmass = 1\n\
             rotate = {{ {angles} }}\n[prescribed]\naxis = {axis}\nrate = 3\n"
        )
    };
    let angles = "roll_pitch_yaw = ['alpha', 0, '10 deg']";
    assert!(parse(&text("[0.25, 'sin(2*(alpha))/2', 'cos(alpha)']", angles)).is_ok());
    let error = parse(&text("[0.25, 'alpha*sin(alpha)', 1]", angles)).unwrap_err();
    assert!(error.to_string().contains("given with its unit"), "{error}");
    let error = parse(&text("[0, 0, 1]", "roll_pitch_yaw = ['alpha', 0.5, 0]")).unwrap_err();
    assert!(error.to_string().contains("given with its unit"), "{error}");
}
