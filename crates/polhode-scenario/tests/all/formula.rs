//! Parts with a density formula.

use std::f64::consts::PI;
use std::path::Path;

use polhode::body::Severity;
use polhode::prelude::*;
use polhode_scenario::read as scenario;
use polhode_source::FormatError;

fn parse(text: &str) -> Result<Scenario, FormatError> {
    scenario::parse(text, &Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/test.toml"))
}

fn read(text: &str) -> Scenario {
    parse(text).unwrap_or_else(|e| panic!("{e}\n{text}"))
}

const BOX: &str = "[[body.part]]\nshape = 'box'\nsize = ['0.3 m', '20 cm', '0.5 m']\n";

fn near(got: f64, want: f64, scale: f64) {
    assert!((got - want).abs() <= 4e-15 * scale, "{got} is not {want}");
}

/// ρ = ρ₀ (1 + g · r) over a box with edges a: M = ρ₀ V, c_i = g_i a_i²/12,
/// ⟨x_i x_j⟩ = δ_ij a_i²/12.
#[test]
fn a_density_may_grow_along_a_slanted_direction() {
    let (sides, slope) = ([0.3, 0.2, 0.5], [0.7, -1.1, 0.4]);
    let text = format!(
        "{BOX}density = '2700*(1 + 0.7*x - 1.1*y + 0.4*z)'\nposition = ['1.5 m', '-40 cm', '0.25 m']\n\
         rotate = {{ quaternion = [0.4, -0.7, 1.1, 0.3] }}\n"
    );
    let read = read(&text);
    let mass = 2700.0 * 0.3 * 0.2 * 0.5;
    let c: [f64; 3] = std::array::from_fn(|k| slope[k] * sides[k] * sides[k] / 12.0);
    let s = |i: usize, j: usize| if i == j { sides[i] * sides[i] / 12.0 } else { 0.0 } - c[i] * c[j];
    let trace = s(0, 0) + s(1, 1) + s(2, 2);
    let tensor = InertiaTensor::with_negative_products(
        [0, 1, 2].map(|k| mass * (trace - s(k, k))),
        [(0, 1), (0, 2), (1, 2)].map(|(i, j)| -mass * s(i, j)),
    );
    let alone = MassProperties::<Part>::new(mass, Position::from_array(c), tensor.unwrap()).unwrap();
    let turn = Rotation::from_quaternion([0.4, -0.7, 1.1, 0.3]).unwrap();
    let want = PlacedPart::new(alone, Position::new(1.5, -0.4, 0.25), turn).unwrap().in_body();
    near(read.body().mass(), want.mass(), mass);
    for k in 0..3 {
        let centers = [read.body(), &want].map(|body| body.center_of_mass().to_array()[k]);
        near(centers[0], centers[1], 1.0);
        for j in 0..3 {
            near(read.body().inertia().matrix()[k][j], want.inertia().matrix()[k][j], mass * trace);
        }
    }
    let finding = read.findings().iter().find(|finding| finding.code == "density.cubature").unwrap();
    assert_eq!((finding.severity, finding.place.as_deref()), (Severity::Info, Some("part \"box 1\"")));
    assert!(finding.message.contains("mass within") && finding.message.contains("kg"), "{}", finding.message);
}

/// ρ = ρ₀ (1 + k r²) in a cylinder: M = π ρ₀ L R² (1 + k R²/2),  I_zz = π ρ₀ L R⁴ (1/2 + k R²/3).
#[test]
fn a_density_may_grow_outward() {
    let text = "[[body.part]]\nshape = 'cylinder'\nradius = 0.4\nlength = 0.9\ndensity = '1300 * (1 + 5*(x^2 + y^2))'\n";
    let body = *read(text).body();
    let (r, l, k) = (0.4_f64, 0.9, 5.0);
    let mass = PI * 1300.0 * l * r * r * (1.0 + k * r * r / 2.0);
    near(body.mass(), mass, mass);
    let izz = PI * 1300.0 * l * r.powi(4) * (0.5 + k * r * r / 3.0);
    near(body.inertia().matrix()[2][2], izz, izz);
}

#[test]
fn a_mesh_may_have_one() {
    let mesh = "[[body.part]]\nshape = 'mesh'\nfile = 'bracket.stl'\nunit = 'mm'\n";
    let [formula, number] =
        ["'2700 + 0*x'", "2700"].map(|density| *read(&format!("{mesh}density = {density}\n")).body());
    near(formula.mass(), number.mass(), number.mass());
    // 2700 (1 + 10 x): the mass is that of the mean density, with x at the centroid.
    let body = *read(&format!("{mesh}density = '2700*(1 + 10*x)'\n")).body();
    let mass = number.mass() * (1.0 + 10.0 * number.center_of_mass().x);
    near(body.mass(), mass, mass);
}

#[test]
fn what_is_a_quantity_is_one() {
    let mass = |density: &str| read(&format!("{BOX}density = {density}\n")).body().mass();
    for density in ["2700", "'2700'", "'2.7 g/cm^3'", "'2700 kg/m^3'", "'2700 kg m^-3'", "'2.7*g/cm^3'"] {
        assert!(read(&format!("{BOX}density = {density}\n")).findings().is_empty(), "{density}");
        near(mass(density), 81.0, 81.0);
    }
    // Arithmetic without a variable is a formula, too.
    near(mass("'3*900'"), 81.0, 81.0);
    near(mass("'sqrt(2700^2)'"), 81.0, 81.0);
}

#[test]
fn a_step_needs_a_tolerance() {
    let step = "density = 'if(x + 0.3*y < 0.04, 900, 2700)'\n";
    let body = *read(&format!("{BOX}{step}density_tolerance = 1e-4\n")).body();
    // The plane x + 0.3 y = 0.04 cuts a prism with the mean width 0.15 + 0.04 in x.
    let mass = 0.2 * 0.5 * (900.0 * 0.19 + 2700.0 * 0.11);
    assert!((body.mass() / mass - 1.0).abs() < 1e-4, "{} is not {mass}", body.mass());
}

#[test]
fn what_is_neither_is_named() {
    let refused = |part: &str, message: &str, hint: &str| {
        let error = parse(part).unwrap_err();
        let advice = error.hint().unwrap_or_default().to_owned();
        assert!(error.to_string().contains(message) && advice.contains(hint), "{error}\n{advice}");
    };
    let density = |text: &str| format!("{BOX}density = '{text}'\n");
    refused(&density("2700*(1 + 0.1*u)"), "unknown variable u", "the variables are x, y, z");
    refused(&density("2700*(1 + 0.1*x"), "formula", "");
    refused(&density("sqr(2)"), "unknown function sqr", "did you mean sqrt?");
    refused(&density("1 - 20*x"), "density at", "");
    refused(&density("1/(x - x)"), "density at", "");
    // These are meant as quantities, not as formulas.
    refused(&density("2700 kg"), "\"kg\" is a mass where a density belongs", "");
    refused(&density("2.7 g/cm3m"), "cm3m", "");
    refused(&density("5 kg/m^2"), "is a mass per area where a density belongs", "");
    let thin = "[[body.part]]\nshape = 'disk'\nradius = 1\ndensity = '3*(1 + x)'\n";
    refused(thin, "one number for a thin shell,", "make it a box");
    refused(&format!("{BOX}density = '2700*(1 + x)'\nmass = 1\n"), "both given", "");
    refused(
        &format!("{BOX}mass = 1\ndensity_tolerance = 1e-6\n"),
        "left out unless the density is a formula",
        "",
    );
    refused(&format!("{BOX}density = '2700*(1 + x)'\ndensity_tolerance = 2\n"), "from 1e-14 to 0.1", "");
}
