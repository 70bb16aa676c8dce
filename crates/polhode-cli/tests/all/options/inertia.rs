//! Option pairs of `polhode inertia`, `polhode check` and `polhode compare`.

use crate::options::{Choice, Subcommand, every_pair_is_honoured_or_refused};

const fn choice(
    option: &'static str,
    arguments: &'static [&'static str],
    inputs: &'static [&'static str],
    needs: &'static [&'static str],
) -> Choice {
    Choice { option, arguments, inputs, needs }
}

const ANY: &[&str] = &[
    "parts",
    "stl",
    "points",
    "particles",
    "cad",
    "molecule",
    "robot",
    "grid",
    "unnamed",
    "torn",
    "holed",
    "again",
    "parts overlapping",
    "shape",
    "symbols",
];
const MESHES: &[&str] = &[
    "parts",
    "stl",
    "unnamed",
    "torn",
    "holed",
    "again",
    "torn again",
    "holed again",
    "torn unnamed",
    "holed unnamed",
    "parts overlapping",
];
/// Inputs for the options of the substance; a shape has no other.
const SUBSTANCES: &[&str] = &[
    "parts",
    "stl",
    "unnamed",
    "torn",
    "holed",
    "again",
    "torn again",
    "holed again",
    "torn unnamed",
    "holed unnamed",
    "parts overlapping",
    "bare shape",
    "inertials",
];
/// Inputs for shapes: with a mass, and without a substance.
const SHAPES: &[&str] = &["shape", "bare shape"];
const NAMED: &[&str] = &[
    "parts",
    "unnamed",
    "torn",
    "holed",
    "again",
    "torn again",
    "holed again",
    "torn unnamed",
    "holed unnamed",
    "inertials",
];

static INERTIA: Subcommand = Subcommand {
    name: "inertia",
    inputs: &[
        ("parts", &["two.obj"]),
        ("unnamed", &["two.dat"]),
        ("torn", &["two.obj"]),
        ("holed", &["two.obj"]),
        ("torn holed", &["two.obj"]),
        ("again", &["two.obj"]),
        ("torn again", &["two.obj"]),
        ("holed again", &["two.obj"]),
        ("torn unnamed", &["two.dat"]),
        ("holed unnamed", &["two.dat"]),
        ("again unnamed", &["two.dat"]),
        ("parts overlapping", &["two.obj"]),
        ("torn overlapping", &["two.obj"]),
        ("holed overlapping", &["two.obj"]),
        ("unnamed overlapping", &["two.dat"]),
        ("stl", &["one.stl"]),
        ("points", &["points.csv"]),
        ("particles", &["particles.csv"]),
        ("cad", &["report.txt"]),
        ("molecule", &["water.xyz"]),
        ("robot", &["arm.urdf"]),
        ("inertials", &["arm.urdf"]),
        ("grid", &["grid.npy"]),
        ("shape", &["--mass", "85 g"]),
        ("bare shape", &[]),
        ("symbols", &["cube.toml"]),
    ],
    options: &[
        choice("--box", &["--box", "20 cm, 10 cm, 6 cm"], SHAPES, &[]),
        choice("--sphere", &["--sphere", "7 cm"], SHAPES, &[]),
        choice("--ellipsoid", &["--ellipsoid", "(12, 8, 5) cm"], SHAPES, &[]),
        choice("--cylinder", &["--cylinder", "2 cm, 5 cm"], SHAPES, &[]),
        choice("--capsule", &["--capsule", "2 cm, 5 cm"], SHAPES, &[]),
        choice("--cone", &["--cone", "3 cm, 10 cm"], SHAPES, &[]),
        choice("--torus", &["--torus", "5 cm, 2 cm"], SHAPES, &[]),
        choice("--rod", &["--rod", "30 cm"], SHAPES, &[]),
        choice("--disk", &["--disk", "9 cm"], SHAPES, &[]),
        choice("--density", &["--density", "2.7 g/cm^3"], SUBSTANCES, &[]),
        choice("--mass", &["--mass", "85 g"], SUBSTANCES, &[]),
        choice("--material", &["--material", "steel"], SUBSTANCES, &[]),
        choice("--part", &["--part", "rod=oak"], NAMED, &[]),
        choice("--hull", &["--hull"], MESHES, &[]),
        choice(
            "--shell",
            &["--shell", "2 mm"],
            &["parts", "stl", "unnamed", "torn", "holed", "torn unnamed", "holed unnamed"],
            &[],
        ),
        choice("--field", &["--field", "2700 + 300*hypot(x, y)"], MESHES, &[]),
        choice("--tolerance", &["--tolerance", "1e-3"], MESHES, &["--field"]),
        choice(
            "--weld",
            &["--weld", "1e-6"],
            &["torn", "torn holed", "torn again", "torn unnamed", "torn overlapping"],
            &[],
        ),
        choice(
            "--fill",
            &["--fill", "0.99"],
            &["holed", "torn holed", "holed again", "holed unnamed", "holed overlapping"],
            &[],
        ),
        choice(
            "--close-within",
            &["--close-within", "5%"],
            &["holed", "torn holed", "holed again", "holed unnamed"],
            &[],
        ),
        choice("--walls", &["--walls", "0.1 m"], MESHES, &["--infill"]),
        choice("--top-layers", &["--top-layers", "0.1 m"], MESHES, &["--walls", "--infill"]),
        choice("--bottom-layers", &["--bottom-layers", "0.2 m"], MESHES, &["--walls", "--infill"]),
        choice("--infill", &["--infill", "15%"], MESHES, &["--walls"]),
        choice(
            "--union",
            &["--union"],
            &["parts overlapping", "torn overlapping", "holed overlapping", "unnamed overlapping"],
            &[],
        ),
        choice(
            "--write-mesh",
            &["--write-mesh", "out.obj"],
            &["parts", "stl", "unnamed", "torn", "holed", "again"],
            &[],
        ),
        choice(
            "--force",
            &["--force"],
            &["again", "torn again", "holed again", "again unnamed"],
            &["--write-mesh"],
        ),
        choice("--write-inertials", &["--write-inertials", "new.urdf"], &["inertials", "robot"], &[]),
        choice("--only", &["--only", "missing"], &["inertials"], &["--write-inertials"]),
        choice("--geometry", &["--geometry", "collision"], &["inertials"], &["--write-inertials"]),
        choice("--unit", &["--unit", "mm"], MESHES, &[]),
        choice("--mass-unit", &["--mass-unit", "g"], &["particles", "cad"], &["--unit"]),
        choice("--isotopes", &["--isotopes", "average"], &["molecule"], &[]),
        choice("--products", &["--products", "positive"], &["cad"], &["--unit", "--mass-unit", "--decimal"]),
        choice("--decimal", &["--decimal", "comma"], &["cad"], &["--unit", "--mass-unit", "--products"]),
        choice("--link", &["--link", "forearm"], &["robot"], &[]),
        choice("--lump", &["--lump", "all"], &["robot"], &[]),
        choice("--subtree", &["--subtree", "upper_arm"], &["robot"], &[]),
        choice("--skip-invalid", &["--skip-invalid"], &["robot"], &["+--lump"]),
        choice("--table", &["--table"], &["robot"], &[]),
        choice("--joint", &["--joint", "elbow=30 deg"], &["robot"], &["--lump"]),
        choice("--spacing", &["--spacing", "1 mm, 2 mm, 3 mm"], &["grid"], &[]),
        choice("--origin", &["--origin", "5 mm, 0, 7 mm"], &["grid"], &["--spacing"]),
        choice("--per-value", &["--per-value", "2 g/cm^3"], &["grid"], &["--spacing"]),
        choice(
            "--format",
            &["--format", "obj"],
            &["unnamed", "torn unnamed", "holed unnamed", "again unnamed", "unnamed overlapping"],
            &[],
        ),
        choice("--symbols", &["--symbols"], &["symbols"], &[]),
        choice("--about", &["--about", "5 mm, 0, 8 mm"], ANY, &[]),
        choice("--along", &["--along", "0.9,0.1,-0.2,0.3"], ANY, &[]),
        choice("--xacro", &["--xacro"], &["robot"], &[]),
        choice("--xacro-arg", &["--xacro-arg", "side:=left"], &["robot"], &["--xacro"]),
        choice("--json", &["--json"], ANY, &[]),
        choice("--csv", &["--csv"], ANY, &[]),
        choice("--as", &["--as", "mjcf"], ANY, &[]),
    ],
    independent: &[
        ("--xacro", "*", "tried in xacro.rs: the text is replaced before all else"),
        ("--xacro-arg", "*", "tried in xacro.rs: the text is replaced before all else"),
        ("--skip-invalid", "*", "tried in robot.rs: it changes only lumps of a robot with an invalid link"),
        ("--mass", "--mass-unit", "refused: the mass is shared by points that have none of their own"),
        ("--only", "--link", "tried on different models; both choose links"),
        ("--only", "--table", "tried on different models; the table is of the new model"),
        ("--only", "--json", "tried on different models; the list of links is the same"),
        ("--geometry", "--link", "tried on different models"),
        ("--geometry", "--table", "tried on different models; the table is of the new model"),
        ("--geometry", "--json", "tried on different models; the list of links is the same"),
    ],
};

const MODELS: &[&str] = &["noted", "flawed", "flawed again", "broken"];

static CHECK: Subcommand = Subcommand {
    name: "check",
    inputs: &[
        ("noted", &["model.urdf"]),
        ("flawed", &["model.urdf"]),
        ("flawed again", &["model.urdf"]),
        ("broken", &["model.urdf"]),
        ("unnamed rules", &[]),
    ],
    options: &[
        choice("--root", &["--root", "packages"], MODELS, &[]),
        choice("--for", &["--for", "mujoco"], MODELS, &[]),
        choice("--xacro", &["--xacro"], MODELS, &[]),
        choice("--xacro-arg", &["--xacro-arg", "side:=left"], MODELS, &["--xacro"]),
        choice("--nearest", &["--nearest"], &["broken"], &[]),
        choice("--json", &["--json"], MODELS, &[]),
        choice("--table", &["--table"], MODELS, &[]),
        choice("--html", &["--html"], MODELS, &[]),
        choice("--format", &["--format", "github"], MODELS, &[]),
        choice("--output", &["--output", "results"], MODELS, &[]),
        choice("--strict", &["--strict"], MODELS, &[]),
        choice("--fail-on", &["--fail-on", "note"], MODELS, &[]),
        choice("--config", &["--config", "rules.toml"], MODELS, &[]),
        choice("--baseline", &["--baseline", "known.json"], MODELS, &[]),
        choice("--write-baseline", &["--write-baseline", "found.json"], MODELS, &[]),
        choice("--fix", &["--fix", "fixed.urdf"], &["flawed", "broken"], &[]),
        choice("--force", &["--force"], &["flawed again"], &["--fix"]),
        choice("--explain", &["--explain", "inertia.unit"], &["unnamed rules"], &[]),
    ],
    independent: &[
        ("--xacro", "*", "tried in xacro.rs: the text is replaced before all else"),
        ("--xacro-arg", "*", "tried in xacro.rs: the text is replaced before all else"),
        ("--for", "--strict", "an error of --for fails in any case"),
        ("--for", "--fail-on", "an error of --for fails in any case"),
        ("--strict", "--write-baseline", "what is written is known, whatever it is"),
        ("--fail-on", "--write-baseline", "what is written is known, whatever it is"),
        ("--nearest", "--strict", "an impossible tensor fails in any case"),
        ("--nearest", "--fail-on", "an impossible tensor fails in any case"),
        ("--nearest", "--force", "tried on different models"),
        ("--force", "--html", "refused: --fix, with which --force is tried here, has no such form"),
        ("--force", "--format", "refused: --fix, with which --force is tried here, has no such form"),
    ],
};

#[test]
fn pairs_of_inertia() {
    every_pair_is_honoured_or_refused(&INERTIA);
}

#[test]
fn pairs_of_check() {
    every_pair_is_honoured_or_refused(&CHECK);
}

const TWO: &[&str] = &["two models", "two models again"];

static COMPARE: Subcommand = Subcommand {
    name: "compare",
    inputs: &[("two models", &["one.sdf", "two.sdf"]), ("two models again", &["one.sdf", "two.sdf"])],
    options: &[
        choice("--tolerance", &["--tolerance", "1e-2"], TWO, &[]),
        choice("--map", &["--map", "names.toml"], TWO, &[]),
        choice("--root", &["--root", "packages"], TWO, &[]),
        choice("--xacro", &["--xacro"], TWO, &[]),
        choice("--xacro-arg", &["--xacro-arg", "side:=left"], TWO, &["--xacro"]),
        choice("--format", &["--format", "github"], TWO, &[]),
        choice("--json", &["--json"], TWO, &[]),
        choice("--output", &["--output", "results"], &["two models"], &[]),
        choice("--force", &["--force"], &["two models again"], &["--output"]),
    ],
    independent: &[
        ("--xacro", "*", "tried in xacro.rs: the text is replaced before all else"),
        ("--xacro-arg", "*", "tried in xacro.rs: the text is replaced before all else"),
    ],
};

#[test]
fn pairs_of_compare() {
    every_pair_is_honoured_or_refused(&COMPARE);
}
