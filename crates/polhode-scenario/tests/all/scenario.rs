//! Scenario files: results of reading.

use std::path::Path;

use polhode::body::Severity;
use polhode::body::shape::{
    BoxShell, Capsule, Cone, ConeShell, CylinderShell, Disk, Ellipsoid, Plate, SphereShell, Tetrahedron,
    Torus, TriangularPlate, TriangularPrism,
};
use polhode::motion::{Run, SplittingOrder};
use polhode::prelude::*;
use polhode_scenario::read as scenario;

const BALL: &str = "[[body.part]]\nshape = 'sphere'\nradius = '20 mm'\nmass = '0.5 kg'\n";
const RUN: &str = "[run]\nduration = '1 s'\n";

fn body(text: &str) -> Scenario {
    scenario::parse(text, Path::new("test.toml")).unwrap_or_else(|e| panic!("{e}\n{text}"))
}

#[test]
fn a_shape_is_what_its_table_says() {
    let expected: [(&str, Box<dyn Shape>); 22] = [
        ("shape='box'\nsize=['30 mm','0.02 m','1 cm']", Box::new(BoxShape::new([0.03, 0.02, 0.01]).unwrap())),
        ("shape='sphere'\nradius='2 cm'", Box::new(Sphere::new(0.02).unwrap())),
        ("shape='ellipsoid'\nsemi_axes=[3,2,1]", Box::new(Ellipsoid::new([3.0, 2.0, 1.0]).unwrap())),
        ("shape='cylinder'\nradius=2\nlength=3", Box::new(Cylinder::new(2.0, 3.0).unwrap())),
        ("shape='capsule'\nradius=2\nlength=3", Box::new(Capsule::new(2.0, 3.0).unwrap())),
        ("shape='cone'\nradius=2\nheight=3", Box::new(Cone::new(2.0, 0.0, 3.0).unwrap())),
        ("shape='cone'\nradius=2\ntop_radius=1\nheight=3", Box::new(Cone::new(2.0, 1.0, 3.0).unwrap())),
        ("shape='torus'\nring_radius=2\ntube_radius=0.5", Box::new(Torus::new(2.0, 0.5).unwrap())),
        (
            "shape='tetrahedron'\nvertices=[[0,0,0],[2,0,0],[0,3,0],[0,0,1]]",
            Box::new(
                Tetrahedron::new([[0.0; 3], [2.0, 0.0, 0.0], [0.0, 3.0, 0.0], [0.0, 0.0, 1.0]]).unwrap(),
            ),
        ),
        (
            "shape='sphere'\nradius='2 cm'\ninner_radius='15 mm'",
            Box::new(Sphere::hollow(0.02, 0.015).unwrap()),
        ),
        ("shape='sphere'\nradius=2\ninner_radius=0", Box::new(Sphere::new(2.0).unwrap())),
        (
            "shape='cylinder'\nradius=2\nlength=3\ninner_radius=1.9",
            Box::new(Cylinder::hollow(2.0, 1.9, 3.0).unwrap()),
        ),
        (
            "shape='triangular_prism'\nvertices=[[0,0.01],[2,0],[0,3]]\nlength=4",
            Box::new(TriangularPrism::new([[0.0, 0.01], [2.0, 0.0], [0.0, 3.0]], 4.0).unwrap()),
        ),
        (
            "shape='triangular_plate'\nvertices=[[0,0.01],[2,0],[0,3]]",
            Box::new(TriangularPlate::new([[0.0, 0.01], [2.0, 0.0], [0.0, 3.0]]).unwrap()),
        ),
        (
            "shape='cone_shell'\nradius=0\nheight=3\ntop_radius=1",
            Box::new(ConeShell::new(0.0, 1.0, 3.0, false).unwrap()),
        ),
        (
            "shape='cone_shell'\nradius=2\nheight=3\ntop_radius=1\nends=true",
            Box::new(ConeShell::new(2.0, 1.0, 3.0, true).unwrap()),
        ),
        ("shape='rod'\nlength=3", Box::new(Rod::new(3.0).unwrap())),
        ("shape='disk'\nradius=3", Box::new(Disk::new(3.0).unwrap())),
        ("shape='plate'\nsize=[3,2]", Box::new(Plate::new([3.0, 2.0]).unwrap())),
        ("shape='sphere_shell'\nradius=3", Box::new(SphereShell::new(3.0).unwrap())),
        ("shape='box_shell'\nsize=[3,2,1]", Box::new(BoxShell::new([3.0, 2.0, 1.0]).unwrap())),
        (
            "shape='cylinder_shell'\nradius=2\nlength=3\nends=true",
            Box::new(CylinderShell::new(2.0, 3.0, true).unwrap()),
        ),
    ];
    for (text, shape) in expected {
        let read = body(&format!("[[body.part]]\n{text}\nmass = '250 g'"));
        let wanted = shape.mass_properties(Substance::Mass(0.25)).unwrap();
        assert_eq!(read.body().inertia().matrix(), wanted.inertia().matrix(), "{text}");
        assert_eq!(read.body().center_of_mass().to_array(), wanted.center_of_mass().to_array(), "{text}");
        let part = &read.parts()[0];
        assert_eq!(part.extent, Some(shape.spread().extent()));
        assert_eq!(part.surface_area.is_none(), part.kind == "rod");
        assert_eq!(part.name, format!("{} 1", part.kind));
    }
}

/// A rotated and moved hollow sphere with a wedge equals the assembly of the core's shapes.
#[test]
fn hollow_parts_are_placed_as_others() {
    let read = body(
        "[[body.part]]\nshape = 'sphere'\nradius = '40 mm'\ninner_radius = '31 mm'\ndensity = '1240 kg/m^3'\nposition = ['0.1 m', 0, '-20 mm']\n\
         [[body.part]]\nshape = 'triangular_prism'\nvertices = [['10 mm', 0], ['90 mm', '5 mm'], ['20 mm', '60 mm']]\nlength = '25 mm'\nmass = '0.37 kg'\n\
         position = [0, '0.2 m', '3 cm']\nrotate = { axis = [1, 2, 3], angle = '40 deg' }\n",
    );
    let ball = Sphere::hollow(0.04, 0.031).unwrap().mass_properties(Substance::Density(1240.0)).unwrap();
    let wedge = TriangularPrism::new([[0.01, 0.0], [0.09, 0.005], [0.02, 0.06]], 0.025).unwrap();
    let wedge = wedge.mass_properties(Substance::Mass(0.37)).unwrap();
    let turn = Rotation::from_axis_angle(Direction::new(1.0, 2.0, 3.0), 40_f64.to_radians()).unwrap();
    let parts = [
        PlacedPart::new(ball, Position::new(0.1, 0.0, -0.02), Rotation::identity()).unwrap(),
        PlacedPart::new(wedge, Position::new(0.0, 0.2, 0.03), turn).unwrap(),
    ];
    let want = polhode::body::assemble(&parts).unwrap();
    let got = read.body();
    assert!((got.mass() / want.mass() - 1.0).abs() < 1e-15);
    assert!((got.center_of_mass() - want.center_of_mass()).norm() < 1e-16);
    for (got, want) in
        got.inertia().matrix().as_flattened().iter().zip(want.inertia().matrix().as_flattened())
    {
        assert!((got - want).abs() < 1e-17, "{got} {want}");
    }
}

#[test]
fn a_substance_is_a_mass_a_density_or_a_material() {
    let mass = |text: &str| body(&format!("[[body.part]]\n{text}")).body().mass();
    let close = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 1e-15, "{a} {b}");
    close(mass("shape='box'\nsize=[2,1,0.5]\ndensity='2.7 g/cm^3'"), 2700.0);
    close(mass("shape='box'\nsize=[2,1,0.5]\nmaterial='Stainless Steel'"), 8000.0);
    close(mass("shape='plate'\nsize=[2,1]\ndensity='3 kg/m^2'"), 6.0);
    close(mass("shape='plate'\nsize=[2,1]\ndensity='3 g/cm^3'\nthickness='2 mm'"), 12.0);
    close(mass("shape='plate'\nsize=[2,1]\nmaterial='copper'\nthickness='2 mm'"), 35.84);
    close(mass("shape='rod'\nlength=2\ndensity='3 g/mm'"), 6.0);
}

#[test]
fn a_part_stands_where_it_is_put() {
    let turns = [
        "{ axis = [0, 0, 2], angle = '90 deg' }",
        "{ quaternion = [1, 0, 0, 1] }",
        "{ euler313 = ['30 deg', 0, '60 deg'] }",
        "{ matrix = [[0, -1, 0], [1, 0, 0], [0, 0, 1]] }",
    ];
    for turn in turns {
        let read = body(&format!(
            "[[body.part]]\nshape='cone'\nname='tip'\nradius=1\nheight=4\nmass=1\nposition=[1,2,3]\n\
             [[body.part]]\nshape='particles'\nrotate={turn}\nposition=[1,0,0]\n\
             particles=[{{mass='2 kg',position=['1 m',0,'50 cm']}}]"
        ));
        let particle = read.particles()[0];
        assert!((particle.position() - Position::new(1.0, 1.0, 0.5)).norm() < 1e-15, "{turn}");
        assert_eq!((particle.mass(), read.parts()[0].name.as_str()), (2.0, "tip"));
        let center = (Position::new(1.0, 2.0, 4.0) + Position::new(1.0, 1.0, 0.5) * 2.0) / 3.0;
        assert!((read.body().center_of_mass() - center).norm() < 1e-15);
        assert!(!read.is_all_particles());
    }
}

#[test]
fn a_tensor_keeps_its_convention_and_its_point() {
    let read = |text: &str| *body(&format!("[[body.part]]\nshape='tensor'\nmass='2.3 kg'\n{text}")).body();
    let center = "center_of_mass=[0.11,-0.07,0.23]\n";
    let negative = "inertia=[[3.1,0.4,-0.3],[0.4,4.2,0.2],[-0.3,0.2,5.3]]\n";
    let wanted = [[3.1, 0.4, -0.3], [0.4, 4.2, 0.2], [-0.3, 0.2, 5.3]];
    assert_eq!(read(&format!("{center}{negative}")).inertia().matrix(), wanted);
    let positive = "products='positive_integral'\ninertia=[[3.1,-0.4,0.3],[-0.4,4.2,-0.2],[0.3,-0.2,5.3]]\n";
    assert_eq!(read(positive).inertia().matrix(), wanted);
    let moved = read(&format!("{center}{negative}about=['1 m','-40 cm','0.7 m']"));
    let again = moved.inertia_about(Position::new(1.0, -0.4, 0.7)).matrix();
    for (a, b) in again.iter().flatten().zip(wanted.iter().flatten()) {
        assert!((a - b).abs() < 5e-15);
    }
    assert_eq!(
        read("moments=['1 kg m^2','2 kg m^2','2.5 kg m^2']\nabout='center_of_mass'").inertia().matrix()[2][2],
        2.5
    );
}

#[test]
fn a_start_is_a_spin_or_a_momentum() {
    let tensor =
        "[[body.part]]\nshape='tensor'\nmass=2\ninertia=[[3.1,0.4,-0.3],[0.4,4.2,0.2],[-0.3,0.2,5.3]]\n";
    let attitude = "[start]\nattitude={quaternion=[0.4,-0.7,1.1,0.3]}\nvelocity=['36 km/h',0,0]\n";
    let read = |spin: &str| body(&format!("{tensor}{attitude}spin={spin}"));
    let body_spin = read("{body=['30 deg/s','-0.2 rad/s','0.7 rad/s']}");
    assert_eq!(body_spin.start().omega.to_array(), [std::f64::consts::FRAC_PI_6, -0.2, 0.7]);
    assert_eq!(body_spin.velocity().to_array(), [10.0, 0.0, 0.0]);
    let space = read("{space=[0.1,-0.2,0.7]}");
    assert!((space.start().omega_space() - AngularVelocity::new(0.1, -0.2, 0.7)).norm() < 1e-15);
    let momentum = read("{momentum=['1 N m s','-2 N m s','3 N m s']}");
    let l = momentum.rotor().angular_momentum_space(&momentum.start());
    assert!((l - AngularMomentum::new(1.0, -2.0, 3.0)).norm() < 4e-15);
    // With a pivot, L is about the pivot.
    let held = body(&format!("{tensor}[body]\npivot=[0.5,0,0]\n[start]\nspin={{momentum=[1,-2,3]}}"));
    assert!((held.rotor().angular_momentum_space(&held.start()) - l).norm() < 8e-15);
    // A rod may have any momentum normal to it.
    let rod = body("[[body.part]]\nshape='rod'\nlength=2\nmass=3\n[start]\nspin={momentum=[2,-1,0]}");
    assert!((rod.start().omega - AngularVelocity::new(2.0, -1.0, 0.0)).norm() < 1e-15);
}

#[test]
fn torques_pivots_and_prescribed_motions_are_read() {
    let gravity = "[[torque]]\nmodel='gravity'\n";
    let top = body(&format!("{BALL}{gravity}pivot=[0,0,'-1 m']"));
    assert_eq!(top.pivot().map(Position::to_array), Some([0.0, 0.0, -1.0]));
    assert_eq!(top.torques(), [TorqueModel::Gravity(UniformGravity::STANDARD)]);
    let held = body(&format!("{BALL}[body]\npivot=[0,0,-1]\n{gravity}acceleration=[0,'-1.62 m/s^2',0]"));
    assert_eq!(held.pivot(), top.pivot());
    let constant = "[[torque]]\nmodel='constant'\naxes='body'\ntorque=[0,0,'3 mN m']\n";
    let pushed = body(&format!("{BALL}{constant}{}", constant.replace("body", "space")));
    let n = ConstantTorque::Body(Torque::new(0.0, 0.0, 0.003));
    assert_eq!(pushed.torques()[0], TorqueModel::Constant(n));
    assert_eq!((pushed.torques().len(), pushed.pivot()), (2, None));

    let turn = body(&format!(
        "{BALL}[start]\nattitude={{axis=[1,0,0],angle=1}}\n[prescribed]\naxis=[0,0,2]\nrate='3 rad/s'\nacceleration=-0.5"
    ));
    assert_eq!(turn.start().omega.to_array(), [0.0, 0.0, 3.0]);
    assert!((turn.start().attitude.angle() - 1.0).abs() < 1e-15);
    let coin = body(&format!("{BALL}[prescribed]\neuler313=[0,'90 deg',0]\nrates=['2 rad/s',0,'5 rad/s']"));
    assert!((coin.start().omega - AngularVelocity::new(0.0, 2.0, 5.0)).norm() < 1e-15);
}

#[test]
fn a_run_samples_evenly_or_at_intervals() {
    let run = |text: &str| body(&format!("{BALL}[run]\n{text}")).run().unwrap().clone();
    let even = run("duration='2 min'\nsamples=5\nmethod='dop853'\ntolerance=1e-9");
    assert_eq!(
        even,
        Run { times: vec![0.0, 30.0, 60.0, 90.0, 120.0], method: Method::Dop853, tolerance: 1e-9 }
    );
    assert_eq!(run("duration=1\nevery='250 ms'\nmethod='exact'").times, [0.0, 0.25, 0.5, 0.75, 1.0]);
    assert_eq!(run("duration=1\nevery=0.4").times, [0.0, 0.4, 0.8, 1.0]);
    assert_eq!(run("duration='0.3 s'\nevery='0.1 s'").times.len(), 4);
    let split = |order, step| Method::Splitting { order, step };
    let steps = run("duration=1\nmethod='splitting'\nstep='5 ms'");
    assert_eq!(steps.method, split(SplittingOrder::Four, 0.005));
    let steps = run("duration=1\nmethod='splitting'\norder=6\nstep=0.25");
    assert_eq!(steps.method, split(SplittingOrder::Six, 0.25));
    let plain = run("duration=1");
    assert_eq!((plain.times.len(), plain.method, plain.tolerance), (1001, Method::Auto, 1e-13));
}

#[test]
fn findings_say_what_was_noticed() {
    let codes = |text: &str| body(text).findings().iter().map(|f| f.code).collect::<Vec<_>>();
    assert_eq!(codes(BALL), [""; 0]);
    assert_eq!(codes("[[body.part]]\nshape='rod'\nlength=1\nmass=1"), ["body.rod"]);
    assert_eq!(
        codes("[[body.part]]\nshape='particles'\nparticles=[{mass=1,position=[0,0,1]}]"),
        ["body.point"]
    );
    assert_eq!(
        codes(&format!("{BALL}[[torque]]\nmodel='gravity'\npivot=[0,0,0]\n{RUN}")),
        ["gravity.balanced"]
    );
    assert_eq!(codes(&format!("{BALL}{RUN}")), ["start.rest"]);
    let spun = |rate: &str| format!("{BALL}[start]\nspin={{body=[0,{rate},{rate}]}}\n{RUN}");
    assert_eq!(codes(&spun("-2e-300")), ["start.underflow"]);
    assert_eq!(codes(&spun("-2e-150")), [""; 0]);
    // Its spin is normal to the pendulum's axis.
    let off = "[start]\nspin={body=[0,1,0]}\n[[torque]]\nmodel='gravity'\npivot=[0,0,1]\n[pendulum]\naxis=[1,0,0]\n";
    assert_eq!(codes(&format!("{BALL}{off}{RUN}")), ["pendulum.axis"]);
    // A height in place of a radius is reported, but another centre may be small.
    let orbit = |orbit: &str| format!("orbit={{{orbit}}}\n{BALL}[[torque]]\nmodel='gravity_gradient'\n{RUN}");
    assert_eq!(codes(&orbit("radius='500 km'")), ["orbit.underground"]);
    assert_eq!(codes(&orbit("semi_major_axis='8000 km',eccentricity=0.3")), ["orbit.underground"]);
    assert_eq!(codes(&orbit("radius='6878 km'")), [""; 0]);
    assert_eq!(
        codes(&orbit("altitude=5e5").replace("[[torque]]\nmodel='gravity_gradient'\n", "")),
        ["start.rest", "orbit.idle"]
    );
    assert_eq!(codes(&orbit("radius='500 km',mu='4.9e12 m^3/s^2'")), [""; 0]);
    let field = "[[torque]]\nmodel='magnetic'\nmoment=[0,0,1]\ndipole=[0,0,-7.8e22]\nfrom=3\n";
    assert_eq!(codes(&format!("{BALL}[orbit]\nradius='400 km'\n{field}{RUN}")), ["orbit.underground"]);
}

#[test]
fn an_amplitude_is_that_of_the_run() {
    let text = |start: &str, amplitude: &str| {
        format!(
            "{BALL}position=[0,0,-1]\n[start]\n{start}\n[[torque]]\nmodel='gravity'\npivot=[0,0,0]\n\
             [pendulum]\naxis=[1,0,0]\namplitude='{amplitude}'\n"
        )
    };
    let tilted = "attitude={axis=[1,0,0],angle='10 deg'}";
    let found = |start: &str, amplitude: &str| {
        let findings = body(&format!("{}{RUN}", text(start, amplitude))).findings().to_vec();
        assert!(findings.iter().all(|f| f.code == "pendulum.amplitude" && f.severity == Severity::Warning));
        findings.first().map(|f| f.message.clone())
    };
    assert_eq!(found(tilted, "10 deg"), None);
    assert_eq!(found("attitude={axis=[1,0,0],angle='-10 deg'}", "10.000001 deg"), None);
    let said =
        |run: &str| Some(format!("the amplitude of the pendulum is given as 20 deg, but the run {run}"));
    assert_eq!(found(tilted, "20 deg"), said("swings by 10 deg"));
    assert_eq!(found("spin={body=[100,0,0]}", "20 deg"), said("goes over the top"));
    assert_eq!(found("", "20 deg"), said("hangs at rest"));
    // A rate at the bottom also determines an amplitude.
    let pendulum = body(&text("", "20 deg")).pendulum().unwrap().unwrap();
    let rate = 2.0 * pendulum.small_frequency() * 10_f64.to_radians().sin();
    assert_eq!(found(&format!("spin={{body=[{rate},0,0]}}"), "20 deg"), None);
    // Without a run the two cannot contradict each other.
    assert_eq!(body(&text(tilted, "20 deg")).findings(), []);
}
