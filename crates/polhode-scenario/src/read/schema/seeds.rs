//! Initial samples with combinations of keys that a search by single keys does not find.

const BALL: &str = "
[[body.part]]
shape = 'sphere'
radius = 1
mass = 1
position = [0, 0, 1]
[run]
duration = 1
";

/// Sweep with variable quantities.
const SWEEP: &str = "
[start]
spin = { body = [0, 0, 1] }
attitude = { axis = [0, 0, 1], angle = 1 }
velocity = [0, 0, 1]
[[torque]]
model = 'constant'
axes = 'body'
torque = [0, 0, 1]
[sweep]
members = 4
sampling = 'monte carlo'
";

/// Distributions of a number.
const LAWS: [&str; 8] = [
    "uniform = { from = 1, to = 2 }",
    "normal = { mean = 1, sd = 1, from = 0, to = 2 }",
    "log_normal = { median = 1, sigma = 1 }",
    "log_normal = { mean = 1, sd = 1 }",
    "log_uniform = { from = 1, to = 2 }",
    "triangular = { from = 1, mode = 1, to = 2 }",
    "list = [1, 2]",
    "grid = { from = 1, to = 2, count = 2 }",
];

/// Numbers and vectors of different dimensions.
const NUMBERS: [&str; 4] =
    ["run.duration", "start.attitude.angle", "start.spin.body[2]", "body.part[0].mass"];
const VECTORS: [&str; 4] = ["start.spin.body", "start.velocity", "body.part[0].position", "torque[0].torque"];

/// Identity matrix with as many rows as a tensor has independent elements.
const CORRELATION: &str = "[[1, 0, 0, 0, 0, 0], [0, 1, 0, 0, 0, 0], [0, 0, 1, 0, 0, 0], \
     [0, 0, 0, 1, 0, 0], [0, 0, 0, 0, 1, 0], [0, 0, 0, 0, 0, 1]]";

/// Returns the TOML of each sample; all elements of an array have the same keys.
pub(super) fn seeds() -> Vec<String> {
    let orbit = "[orbit]\naltitude = 5e5\n[start]\nrelative_to = 'orbit'\nspin = { body = [0, 0, 1] }\n";
    let magnet = "[[torque]]\nmodel = 'magnetic'\nmoment = [0, 0, 1]\ndipole = [0, 0, 1]\n";
    let mut seeds = vec![
        BALL.to_owned(),
        // A body with a pivot.
        format!("body.pivot = [0, 0, 1]\n{BALL}[[torque]]\nmodel = 'gravity'\n"),
        format!("{BALL}{orbit}{magnet}"),
        "[[body.part]]\nshape = 'sphere'\nradius = 1\ndensity = '1 + x'\ndensity_tolerance = 1e-6\n"
            .to_owned(),
        "[[body.part]]\nshape = 'tensor'\nmass = 1\ninertia = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]\n\
         products = 'negative_integral'\n"
            .to_owned(),
        format!(
            "[run]\nduration = 1\n{}{}[mass_history]\nburn = [{{ part = 'propellant', until = 1, left = 0.5 }}]\n\
             drop = [{{ part = 'case', time = 2 }}]\nexit = [{{ position = [0, 0, 1] }}]\n",
            ball("case"),
            ball("propellant"),
        ),
    ];
    for formula in ["t", "wx", "Lx", "T_rot"] {
        let event = format!("[[event]]\nmeasure = 'formula'\nformula = '{formula}'\nvalue = 1\n");
        seeds.push(format!("{BALL}{event}"));
    }
    let mut vary = |key: &str, law: &str| {
        seeds.push(format!("{BALL}{SWEEP}[[sweep.vary]]\nkey = {key}\n{law}\n"));
    };
    for law in LAWS {
        NUMBERS.iter().for_each(|key| vary(&format!("'{key}'"), law));
        let direction = format!("direction = 'uniform'\nmagnitude = {{ {law} }}");
        VECTORS.iter().for_each(|key| vary(&format!("'{key}'"), &direction));
    }
    vary("'start.attitude'", "random = 'uniform'");
    vary("'body'", "dispersion = 0.1");
    let covariance = "[[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]";
    vary(&format!("{NUMBERS:?}"), &format!("correlated = {{ covariance = {covariance} }}"));
    vary(
        &format!("{NUMBERS:?}"),
        &format!("correlated = {{ mean = [1, 1, 1, 1], covariance = {covariance} }}"),
    );
    let law = format!("sd = [1, 1, 1, 1, 1, 1], correlation = {CORRELATION}, impossible = 'failed'");
    vary("'body.inertia'", &format!("correlated = {{ {law} }}"));
    seeds
}

fn ball(name: &str) -> String {
    format!("[[body.part]]\nname = '{name}'\nshape = 'sphere'\nradius = 1\nmass = 1\n")
}
