//! Questions of a plan, sets of points, and variables that change together.

use polhode_source::files::Disk;
use polhode_sweep::{Plan, inputs, simulate};

const BODY: &str = r#"
[[body.part]]
name = "a"
shape = "box"
size = ["0.1 m", "0.2 m", "0.3 m"]
mass = "2 kg"
[[body.part]]
name = "b"
shape = "sphere"
radius = "0.1 m"
mass = "2 kg"
position = [0, 0, 1]
[start]
spin = { body = [0.1, 2, -0.3] }
[run]
duration = "10 s"
samples = 11
"#;

fn plan(sweep: &str) -> Result<Plan, polhode_source::FormatError> {
    Plan::parse(&Disk, format!("{BODY}{sweep}"), "plan.toml".as_ref())
}

#[track_caller]
fn refuses(sweep: &str, message: &str, hint: &str) {
    let error = plan(sweep).map(|_| sweep.to_owned()).unwrap_err();
    assert!(error.message().contains(message), "{error}");
    assert!(error.place().is_some(), "{error}");
    assert!(error.hint().unwrap_or_default().contains(hint), "{:?}", error.hint());
}

const VARY: &str = "\n[[sweep.vary]]\nkey = 'start.spin.body[0]'\nuniform = { from = 0, to = 1 }\n";

#[test]
fn several_keys_are_one_number() {
    let both = "[sweep]\nmembers = 8\nsampling = 'monte carlo'\n[[sweep.vary]]\n\
                key = ['body.part[0].mass', 'body.part[\"b\"].mass']\nuniform = { from = 1, to = 3 }\n";
    let plan = plan(both).unwrap();
    assert_eq!(plan.variables().len(), 1);
    assert!(plan.variables()[0].description.contains("body.part[0].mass, and body.part"));
    for member in 0..8 {
        let values = plan.values(member);
        assert_eq!(plan.scenario(&values).unwrap().body().mass(), 2.0 * values[0]);
    }
}

#[test]
fn numbers_that_cannot_be_one_are_refused() {
    let with = |keys: &str| {
        format!(
            "[sweep]\nmembers = 8\nsampling = 'monte carlo'\n[[sweep.vary]]\nkey = {keys}\nuniform = {{ from = 1, to = 3 }}\n"
        )
    };
    refuses(
        &with("['body.part[0].mass', 'start.spin.body[1]']"),
        "a mass, as body.part[0].mass is",
        "numbers that vary",
    );
    refuses(
        &with("['start.spin.body[0]', 'start.spin.body[1]']"),
        "equal to start.spin.body[0]",
        "same written value",
    );
    refuses(&with("['body.part[0].mass', 'body.part[0].mass']"), "different from", "leave it out");
    refuses(&with("['body.part[0].mass']"), "one key, or an array", "write key");
    let rotations = "[sweep]\nmembers = 8\nsampling = 'monte carlo'\n[[sweep.vary]]\nkey = ['body', 'body.part[0]']\ndispersion = '10 %'\n";
    refuses(rotations, "one key", "its own key");
    // Each part is dispersed already.
    let twice = with("['body.part[0].mass', 'body.part[1].mass']")
        + "[[sweep.vary]]\nkey = 'body.part[1]'\ndispersion = '10 %'\n";
    refuses(&twice, "a number that does not already vary", "varies once");
}

#[test]
fn sets_are_drawn_each_for_itself_and_the_first_is_that_without_others() {
    for sampling in ["latin hypercube", "sobol"] {
        let alone = plan(&format!("[sweep]\nmembers = 16\nsampling = '{sampling}'\nseed = 3{VARY}")).unwrap();
        let four =
            plan(&format!("[sweep]\nmembers = 64\nsampling = '{sampling}'\nseed = 3\nreplicates = 4{VARY}"))
                .unwrap();
        assert_eq!((alone.replicates(), four.replicates()), (1, 4));
        let of = |plan: &Plan, from: u64| (from..from + 16).map(|k| plan.values(k)[0]).collect::<Vec<_>>();
        assert_eq!(of(&alone, 0), of(&four, 0), "{sampling}");
        for set in 0..4 {
            // One number in each of sixteen layers.
            let mut layers: Vec<u64> = of(&four, 16 * set).iter().map(|u| (16.0 * u) as u64).collect();
            assert!(set == 0 || of(&four, 16 * set) != of(&four, 0));
            layers.sort_unstable();
            assert_eq!(layers, (0..16).collect::<Vec<_>>(), "{sampling} {set}");
        }
    }
}

#[test]
fn what_is_no_set_of_points_is_refused() {
    let with = |sampling: &str, replicates: &str| {
        format!("[sweep]\nmembers = 64\nsampling = '{sampling}'\nreplicates = {replicates}{VARY}")
    };
    refuses(&with("monte carlo", "4"), "left out here", "independent");
    refuses(&with("sobol", "3"), "a divisor of the 64 members", "replicates = 16");
    refuses(&with("sobol", "1"), "2 … 1000", "replicates = 16");
    refuses(&with("latin hypercube", "64"), "at least 2 of each", "replicates = 16");
}

#[test]
fn questions_are_conditions_on_columns() {
    let with = |condition: &str| {
        format!(
            "[sweep]\nmembers = 64\nsampling = 'monte carlo'\n[sweep.questions]\nasked = \"{condition}\"{VARY}"
        )
    };
    for good in [
        "largest_angle_to_axis_3_rad > 90 deg",
        "start_spin_body_x_rad_s < 20 deg/s and period_s > 0.1 min",
        "end_kinetic_energy_j > 1 J or mass_kg < 3 kg",
    ] {
        let plan = plan(&with(good)).unwrap_or_else(|error| panic!("{good}: {error}"));
        assert_eq!(simulate(&plan, &inputs(&plan, 0..4)).unwrap().rows(), 4);
    }
    refuses(&with("largest_angle_to_axis_3_rad > 90"), "compares an angle with 90", "90 deg or 90 rad");
    refuses(&with("period_s"), "where a condition belongs", "a comparison");
    refuses(&with("period_s > 3 kg"), "of a time and a mass", "");
    refuses(&with("periods > 3 s"), "unknown variable periods", "period_s");
    refuses(&with("status > 3"), "unknown variable status", "");
    refuses(
        &format!("[sweep]\nmembers = 64\nsampling = 'monte carlo'\nquestions = 3{VARY}"),
        "questions",
        "",
    );
}
