//! Errors in scenario files: torques, wheels, events.

use polhode_source::FormatErrorKind;

use super::{BALL, RUN, parse, refuses, refuses_alone};

#[test]
fn orbits_are_given_once_and_are_orbits() {
    let orbit = |text: &str| format!("orbit={text}\n{BALL}[[torque]]\nmodel='gravity_gradient'");
    assert!(parse(&orbit("{rate=0.001}")).is_ok());
    assert!(parse(&orbit("{position=[7e6,0,0],velocity=[0,'11 km/s','1 m/s'],mu='4e5 km^3/s^2'}")).is_ok());
    assert!(parse(&orbit("{semi_major_axis=7e6,true_anomaly=1}")).is_ok());
    refuses(
        &format!("{BALL}«[[torque]]»\nmodel='gravity_gradient'"),
        "the key orbit is missing in [[torque]] of model \"gravity_gradient\"",
        "write [orbit] on a line of its own, and under it altitude",
    );
    refuses(
        &orbit("«{}»"),
        "the key altitude is missing in orbit",
        "write altitude = \"500 km\", or radius, rate",
    );
    refuses(
        &orbit("{altitude=7e5,mu=«4e14»}"),
        "altitude and mu are both given: an altitude is relative to the Earth: for another body give the radius",
        "leave one of them out",
    );
    refuses(
        &orbit("{altitude=7e5,radial=[1,0,0],inclination=«1»}"),
        "radial and inclination are both given: give the orientation of the orbit either by directions or by angles",
        "leave one of them out",
    );
    refuses(
        &orbit("{radius=7e6,rate=«0.001»}"),
        "radius and rate are both given: an orbit is given once",
        "leave one of them out",
    );
    refuses(
        &orbit("{rate=0.001,inclination=«1»}"),
        "rate and inclination are both given: an orbit is given once",
        "leave one of them out",
    );
    refuses(
        &orbit("{semi_major_axis=7e6,mean_anomaly=1,true_anomaly=«1»}"),
        "mean_anomaly and true_anomaly are both given: both define the position on the orbit",
        "leave one of them out",
    );
    refuses(
        &orbit("«{position=[7e6,0,0]}»"),
        "the key velocity is missing in orbit",
        "write velocity = [0, \"7.6 km/s\", 0]",
    );
    refuses(
        &orbit("{radius=«'-7000 km'»}"),
        "radius = '-7000 km' must be positive",
        "radial and motion define",
    );
    refuses(&orbit("{mu=«0»,radius=7e6}"), "mu = 0 must be positive", "radial and motion define");
    refuses(
        &orbit("{mu=«'4e5 km^3'»,radius=7e6}"),
        "\"km^3\" is a volume where a gravitational parameter belongs",
        "write a gravitational parameter, such as \"398600.4418 km^3/s^2\"",
    );
    refuses(
        &orbit("«{radius=7e6,radial=[0,2,0]}»"),
        "the orbit's direction of motion = 0 must be at least 1e-9 rad off the radial direction",
        "",
    );
    refuses(
        &orbit("«{position=[7e6,0,0],velocity=[1,0,0]}»"),
        "the orbit's velocity = 0 must be at least 1e-9 rad off the line to the centre",
        "",
    );
    refuses(
        &orbit("«{semi_major_axis=7e6,eccentricity=1.5}»"),
        "the orbit's semi-major axis = 7000000 must be finite, positive for an ellipse and negative for a hyperbola",
        "",
    );
    refuses(
        &format!("{}\nmass=«'points'»", orbit("{radius=7e6}")),
        "mass = 'points' must be \"tensor\", since not every part of the body is particles",
        "the sum over points needs",
    );
    for (head, line) in [("[body]\npivot=[0,0,1]\n", 6), ("[[torque]]\nmodel='gravity'\npivot=[0,0,1]\n", 7)]
    {
        refuses(
            &format!("{BALL}{head}[[torque]]\nmodel=«'gravity_gradient'»\n[orbit]\nradius=7e6"),
            &format!(
                "model = 'gravity_gradient' must be left out, since line {line} holds the body at a pivot"
            ),
            "a body on an orbit is free",
        );
    }
}

#[test]
fn a_magnet_has_one_field() {
    let magnet = |text: &str| format!("{BALL}«[[torque]]»\nmodel='magnetic'\n{text}");
    refuses(
        &magnet("field=[0,0,1]"),
        "the key moment is missing in [[torque]] of model \"magnetic\"",
        "write moment = [0, 0, \"5 A m^2\"]",
    );
    refuses(
        &magnet("moment=[0,0,1]"),
        "the key field is missing in [[torque]] of model \"magnetic\"",
        "write field = [\"20 µT\"",
    );
    refuses(
        &magnet("moment=[0,0,1]\ndipole=[0,0,1]"),
        "the key orbit is missing in [[torque]] of model \"magnetic\"",
        "write [orbit] on a line of its own",
    );
    let magnet = |text: &str| magnet(text).replace("«[[torque]]»", "[[torque]]");
    refuses(
        &magnet("moment=[0,0,1]\nfield=[0,0,1]\ndipole=«[0,0,1]»"),
        "field and dipole are both given: give the field in one way only",
        "leave one of them out",
    );
    refuses(
        &magnet("moment=[0,0,1]\nfield=[0,0,«'3 A m^2'»]"),
        "\"A m^2\" is a magnetic moment where a magnetic field belongs",
        "write a magnetic field, such as \"30 µT\"",
    );
}

#[test]
fn times_of_torques_are_in_order() {
    let torque =
        |keys: &str| format!("{BALL}[[torque]]\nmodel='constant'\naxes='body'\ntorque=[1,0,0]\n{keys}");
    refuses(
        &torque("from='3 s'\nuntil=«'2 s'»"),
        "the time until which a torque acts = 2 must be after the time from which it acts",
        "",
    );
    refuses(
        &torque("from=1\npulses=«{width=1,period=2}»"),
        "from and pulses are both given: pulses alone define when the torque acts",
        "leave",
    );
    refuses(&torque("until=«'3 m'»"), "\"m\" is a length where a time belongs", "write a time");
    refuses(
        &torque("pulses={width=1,period=2,«gap»=1}"),
        "unknown key \"gap\" in pulses",
        "the known keys are first, width, period, count",
    );
    refuses(&torque("pulses=«{width=1}»"), "the key period is missing in pulses", "write period");
    refuses(&torque("pulses={width=«0»,period=2}"), "width = 0 must be positive", "time runs");
    refuses(
        &torque("pulses=«{width=3,period=2}»"),
        "the width of the pulses = 3 must be no more than their period",
        "",
    );
    refuses(
        &torque("pulses=«{width=1,period=2,count=0}»"),
        "the number of pulses = 0 must be at least 1",
        "",
    );
}

#[test]
fn drag_springs_and_thrusters_are_possible() {
    let torque = |model: &str, keys: &str| format!("{BALL}[[torque]]\nmodel='{model}'\n{keys}");
    refuses(
        &torque("drag", "law='linear'\ncoefficient=«'-1 N m s'»"),
        "the least eigenvalue of the drag's matrix = -1 must be not negative: drag never speeds a body up",
        "",
    );
    refuses(
        &torque("drag", "law='linear'\ncoefficient=«[[1,0.5,0],[0.25,1,0],[0,0,1]]»"),
        "an element of the drag's matrix = 0.5 must be equal to the element across the diagonal",
        "",
    );
    refuses(
        &torque("drag", "law='quadratic'\ncoefficient=«'1 N m s'»"),
        "\"N m s\" is an angular momentum where a torque per squared angular velocity belongs",
        "write a torque per squared angular velocity",
    );
    refuses(
        &torque("drag", "law=«'cubic'»\ncoefficient=1"),
        "law = 'cubic' must be one of linear, quadratic",
        "",
    );
    refuses(
        &torque("torsion", "stiffness=«'1 N m'»"),
        "\"N m\" is an energy or a torque where a torque per angle belongs",
        "write a torque per angle",
    );
    refuses(
        &torque("torsion", "stiffness=«'-1 N m/rad'»"),
        "the stiffness = -1 must be finite and not negative",
        "",
    );
    refuses(
        &torque("torsion", "stiffness=1\naxis=«[0,0,0]»"),
        "the length of the wire's axis = 0 must be a direction: finite and not zero",
        "",
    );
    refuses(
        &torque("thruster", "position=[1,0,0]\nforce=[0,«'1 m'»,0]"),
        "\"m\" is a length where a force belongs",
        "write a force",
    );
    refuses(
        &format!("{BALL}«[[torque]]»\nmodel='thruster'\nposition=[1,0,0]"),
        "the key force is missing in [[torque]] of model \"thruster\"",
        "write force",
    );
}

#[test]
fn coefficients_come_in_every_shape_and_unit() {
    let coefficient = |law: &str, text: &str| {
        let text = format!("{BALL}[[torque]]\nmodel='drag'\nlaw='{law}'\ncoefficient={text}");
        match parse(&text).unwrap().torques()[0] {
            polhode::motion::torque::TorqueModel::Drag(drag) => drag.matrix(),
            ref other => panic!("{other:?}"),
        }
    };
    let twice = [[2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 2.0]];
    for text in [
        "2",
        "'2 N m s'",
        "'2 N m s/rad'",
        "['2 N m s', '2000 mN m s', '2 N m s']",
        "[[2,0,0],[0,2,0],[0,0,2]]",
    ] {
        assert_eq!(coefficient("linear", text), twice, "{text}");
    }
    for text in ["2", "'2 N m s^2'", "'2 N m s^2/rad^2'", "'2 kg m^2'"] {
        assert_eq!(coefficient("quadratic", text), twice, "{text}");
    }
    assert!((coefficient("linear", "'1 N m s/deg'")[0][0] / 57.295_779_513 - 1.0).abs() < 1e-10);
}

#[test]
fn wheels_that_make_no_sense_are_refused() {
    let wheel = |keys: &str| format!("{BALL}{RUN}[[wheel]]\n{keys}");
    refuses(
        &wheel("axis=[0,0,1]\nmomentum=1\n«speeds»=2"),
        "unknown key \"speeds\" in [[wheel]]",
        "did you mean speed?",
    );
    refuses(
        &format!("{BALL}{RUN}«[[wheel]]»\naxis=[0,0,1]"),
        "the key momentum is missing in [[wheel]]",
        "write momentum = \"4 N m s\", or inertia and speed",
    );
    refuses_alone(
        &format!("{BALL}{RUN}«[[wheel]]»\naxis=[0,0,1]\nspeed='3000 rpm'"),
        "the key inertia is missing in [[wheel]]",
        "write inertia",
    );
    refuses(
        &wheel("axis=[0,0,1]\nmomentum=1\nspeed=«2»\ninertia=1"),
        "momentum and speed are both given: each of them alone defines the initial angular momentum of the wheel",
        "leave",
    );
    refuses(
        &wheel("axis=[0,0,1]\nmomentum=1\ninertia=«2»"),
        "inertia = 2 must be left out",
        "with momentum and without motor_torque it has no effect",
    );
    refuses(
        &wheel("axis=«[0,0,0]»\nmomentum=1"),
        "the length of the wheel's axis = 0 must be a direction: finite and not zero",
        "the z axis is [0, 0, 1]",
    );
    refuses(
        &wheel("axis=[0,0,1]\nmomentum=1\nfrom=«'2 s'»"),
        "from = '2 s' must be left out",
        "it limits the time of motor_torque;",
    );
    refuses(
        &wheel("axis=[0,0,1]\nspeed=1\ninertia=«'-1 kg m^2'»"),
        "inertia = '-1 kg m^2' must be positive",
        "it is the wheel's moment of inertia",
    );
    refuses(
        &wheel("axis=[0,0,1]\nspeed=1\ninertia=1e-6\nmotor_torque=1\nfrom=3\nuntil=«2»"),
        "until = 2 must be later than the start of the motor",
        "a run starts at 0",
    );
    // The ball has 0.4 · 0.5 kg · (20 mm)² = 8e-5 kg·m². A wheel in it cannot have more, whether it
    // rotates freely or is held.
    for motor in ["motor_torque=0", ""] {
        let keys = format!("axis=[0,0,1]\nspeed=1\ninertia='1e-4 kg m^2'\n{motor}");
        let error = parse(&wheel(&keys)).unwrap_err();
        assert!(
            error.message().contains("the wheel's moment of inertia")
                || error.message().contains("without its wheels")
        );
        assert!(error.hint().unwrap().starts_with("the inertia of [body] includes the locked wheels"));
        assert_eq!(error.place().unwrap().excerpt, "inertia='1e-4 kg m^2'");
    }
    for (table, other) in
        [("prescribed", "[prescribed]\naxis=[0,0,1]\nrate=1"), ("pendulum", "[pendulum]\naxis=[1,0,0]")]
    {
        let error = parse(&format!("{BALL}{other}\n[[wheel]]\naxis=[0,0,1]\nmomentum=1")).unwrap_err();
        assert!(
            matches!(error.kind(), FormatErrorKind::Conflict { keys, .. } if keys.contains(&table)),
            "{error}"
        );
    }
    refuses(
        &format!("{BALL}{RUN}[[torque]]\nmodel='energy_sink'\ncoefficient=«'-2 /(N m s)'»"),
        "the coefficient of an energy sink = -2 must be positive and finite",
        "it damps nutation in",
    );
    refuses(
        &format!("{BALL}{RUN}[[torque]]\nmodel='energy_sink'\ncoefficient=«'2 N m s'»"),
        "\"N m s\" is an angular momentum where a quantity in kg^-1 m^-2 s belongs",
        "",
    );
}

/// L = I ω + h at the start, for each form of wheel, held or driven by a motor.
#[test]
fn the_momentum_of_a_start_is_that_with_the_wheels() {
    let body =
        "[[body.part]]\nshape='tensor'\nmass=2\ninertia=[[3.1,-0.4,0.3],[-0.4,4.2,-0.2],[0.3,-0.2,5.3]]\n";
    let start = "[start]\nattitude={axis=[1,2,3],angle='40 deg'}\nspin={momentum=[0.7,-1.2,2.1]}\n";
    for (keys, speed) in [
        ("momentum=1.3", None),
        ("momentum=1.3\ninertia=0.3\nmotor_torque=0.2", None),
        ("inertia=0.3\nspeed=4.5", None),
        ("inertia=0.3\nspeed=4.5\nmotor_torque=0.2", Some(4.5)),
    ] {
        let scenario = parse(&format!("{body}{start}[[wheel]]\naxis=[0.6,-0.3,0.9]\n{keys}")).unwrap();
        let rotor = scenario.rotor();
        let [x, y, z] = rotor.angular_momentum_space(&scenario.start()).to_array();
        assert!((x - 0.7).hypot(y + 1.2).hypot(z - 2.1) < 2e-15, "{keys}: {x} {y} {z}");
        if let Some(speed) = speed {
            let wheel = scenario.wheels()[0];
            let relative = wheel.momentum() / 0.3 - wheel.axis().dot(scenario.start().omega);
            assert!((relative - speed).abs() < 1e-14, "{relative}");
        }
    }
}

#[test]
fn events_that_cannot_be_are_refused() {
    let torque = "[[torque]]\nname='jet'\nmodel='constant'\naxes='body'\ntorque=[1,0,0]\n";
    let event = |keys: &str| format!("{BALL}{torque}{RUN}[[event]]\n{keys}");
    assert!(parse(&event("measure='time'\nvalue=1\nthen={switch='jet',on=false}")).is_ok());
    assert!(parse(&event("measure='formula'\nformula='hypot(wx,wy)'\nvalue='3 rpm'")).is_ok());
    refuses(
        &event("measure=«'omega_z'»\nvalue=1"),
        "measure = 'omega_z' must be one of time, omega_body_x, omega_body_y, omega_body_z, omega_space_x, omega_space_y, \
         omega_space_z, omega, momentum, kinetic_energy, total_energy, angle, nutation, precession, spin, formula",
        "did you mean \"omega\"?",
    );
    refuses(
        &event("measure='omega'\nvalue=«'3 N m'»"),
        "\"N m\" is an energy or a torque where an angular velocity belongs",
        "write an angular velocity",
    );
    refuses(
        &event("measure='omega'\nvalue=«'3 J'»"),
        "\"J\" is an energy or a torque where an angular velocity belongs",
        "write an angular velocity",
    );
    assert!(parse(&event("measure='kinetic_energy'\nvalue='3 J'")).is_ok());
    refuses(
        &event("measure='kinetic_energy'\nvalue=«'3 kg'»"),
        "value = '3 kg' must be an energy",
        "write an energy, such as \"3 J\"",
    );
    refuses(
        &event("measure='formula'\nformula='hypot(wx,wy)'\nvalue=«'3 s'»"),
        "\"s\" is a time where an angular velocity belongs",
        "write an angular velocity",
    );
    refuses(
        &event("measure='formula'\nformula=«'wx + t'»\nvalue=1"),
        "formula = 'wx + t' must be a formula of the state (column 4: + of an angular velocity and a time: the dimensions differ)",
        "",
    );
    refuses(
        &event("measure='nutation'\nvalue=«'180 deg'»"),
        "value = '180 deg' must be above 0 and below 180 deg",
        "this angle reaches 0 and",
    );
    refuses(
        &event("measure='angle'\nbetween=«[{body=[0,0,1]},{body=[0,1,0]}]»\nvalue=1"),
        "between = [{body=[0,0,1]},{body=[0,1,0]}] must be a direction of the body, and one of space, \"nadir\", \
         \"velocity\", \"orbit_normal\", \"field\", \"omega\" or \"momentum\"",
        "write between = [{ body",
    );
    refuses(
        &event("measure='angle'\nbetween=[{body=«[0,0,0]»},\"omega\"]\nvalue=1"),
        "body = [0,0,0] must be a direction: not all zero",
        "the z axis is",
    );
    refuses(
        &event("measure='time'\nvalue=1\n«between»=['omega','momentum']"),
        "unknown key \"between\" in [[event]]",
        "the known keys are name, measure, value",
    );
    refuses(
        &event("measure='time'\nvalue=1\nthen={switch=«'jett'»,on=false}"),
        "switch = 'jett' must be the name of a torque",
        "did you mean \"jet\"?",
    );
    refuses_alone(
        &event("measure='time'\nvalue=1\nthen=«{switch='jet'}»"),
        "the key on is missing in then",
        "write { switch",
    );
    refuses(
        &event("measure='time'\nvalue=1\nthen=«'halt'»"),
        "then = 'halt' must be one of record, stop",
        "",
    );
    refuses(
        &format!("{BALL}{torque}[[torque]]\nname=«'jet'»\nmodel='constant'\naxes='body'\ntorque=[1,0,0]"),
        "name = 'jet' must be different from the names of other torques",
        "events switch torques by name: give each",
    );
    refuses(
        &format!("{BALL}[[torque]]\non=«false»\nmodel='constant'\naxes='body'\ntorque=[1,0,0]"),
        "on = false must be true for a torque without a name",
        "an event that switches the",
    );
    let off = parse(&format!("{BALL}{}{RUN}", torque.replace("name", "on=false\nname"))).unwrap();
    assert!(off.findings().iter().any(|finding| finding.code == "torque.off"));
    assert_eq!(off.switched_off(), [0]);
}

#[test]
fn a_torque_s_formula_is_answered_at_its_place() {
    let with = |components: &str| {
        format!("{BALL}[[torque]]\nmodel = 'formula'\naxes = 'body'\ntorque = [{components}]\n{RUN}")
    };
    assert!(parse(&with("0, '0.1 [N m]', '-2[N m s]*wx'")).is_ok());
    let message = "+ of a torque and a plain number: the dimensions differ";
    refuses(&with("0, '1[N m] «+» 2', 0"), message, "write the unit after the number, such as 0.1 N m");
    refuses(&with("0, 0, \"\"\"2[Nm]*«w1»\"\"\""), "unknown variable w1", "the variables are t, wx");
    let message = "the value is an angular velocity, where a torque belongs";
    refuses(&with("' «wx»', 0, 0"), message, "a factor is missing, such as 12[N m s]");
    refuses(&with("'2[«Nn»]*t', 0, 0"), "unknown unit \"Nn\"", "did you mean");
    let message = "sin needs a number without unit, not a time";
    refuses(
        &with("'1[N m]*«sin»(t)', 0, 0"),
        message,
        "divide by a quantity of the same dimension, such as 90[s]",
    );
    // In a string with escapes the place is the whole string.
    let message = "unknown variable qw²";
    refuses(&with("«\"1[N m]*qw\\u00b2\"», 0, 0"), message, "did you mean qw?");
    refuses(&with("0, «true», 0"), "torque must be a torque, not true or false", "write \"0.1 N m\"");
}

#[test]
fn directions_of_an_orbit_need_one() {
    let event = |between: &str| {
        format!("{RUN}[[event]]\nmeasure='angle'\nbetween=[{{body=[1,2,0]}},{between}]\nvalue='9 deg'\n")
    };
    refuses(
        &format!("{BALL}{}", event("«'nadir'»")),
        "between = 'nadir' must be used with an [orbit], which defines this direction",
        "write [orbit] on a line of its own",
    );
    refuses(
        &format!("{BALL}{}", event("«'field'»")),
        "between = 'field' must be left out, since no [[torque]] of model \"magnetic\" defines the field, or two fields differ",
        "give its direction as { space",
    );
    for name in ["nadir", "velocity", "orbit_normal"] {
        assert!(parse(&format!("{BALL}[orbit]\naltitude=5e5\n{}", event(&format!("'{name}'")))).is_ok());
    }
    let pointing = |text: &str| format!("{BALL}[orbit]\naltitude=5e5\n[[pointing]]\n{text}");
    refuses(
        &pointing("name='a b'\nbody=[0,0,1]\nto='nadir'").replace("'a b'", "«'a b'»"),
        "name = 'a b' must be letters of the Latin alphabet, digits and underscores",
        "it names a column",
    );
    refuses(
        &pointing("name='a'\nbody=«[0,0,0]»\nto='nadir'"),
        "body = [0,0,0] must be a direction: not all zero",
        "the z axis",
    );
    refuses(
        &pointing("name='a'\nbody=[0,0,1]\nto=«'nadr'»"),
        "to = 'nadr' must be one of nadir, velocity, orbit_normal, field",
        "did you mean \"nadir\"?",
    );
    refuses(
        &pointing("name='a'\nbody=[0,0,1]\nto=«[0,0,1]»"),
        "to = [0,0,1] must be \"nadir\", \"velocity\", \"orbit_normal\", \"field\", or { space = [3] }",
        "a direction that is fixed in space is written { space",
    );
    refuses(
        &pointing("name='a'\nbody=[0,0,1]\nto='nadir'\n[[pointing]]\nname=«'A'»\nbody=[0,0,1]\nto='nadir'"),
        "name = 'A' must be different from the names of other pointings",
        "give each pointing its own name",
    );
    for (wrong, message, hint) in [
        ("'0 deg'", "limit = '0 deg' must be between 0 and 180 degrees", ""),
        ("'-12 deg'", "limit = '-12 deg' must be between 0 and 180 degrees", ""),
        ("'180 deg'", "limit = '180 deg' must be between 0 and 180 degrees", ""),
        ("'12 m'", "\"m\" is a length where an angle belongs", "write an angle"),
        ("nan", "limit = nan must be finite", "write a finite number"),
    ] {
        refuses(&pointing(&format!("name='a'\nbody=[0,0,1]\nto='nadir'\nlimit=«{wrong}»")), message, hint);
    }
}

#[test]
fn starts_and_times_of_an_orbit_need_one() {
    refuses(
        &format!("{BALL}[start]\nrelative_to=«'orbit'»\n"),
        "relative_to = 'orbit' must be \"space\", since there is no [orbit]",
        "write [orbit] on a line of its own",
    );
    let orbit = "[orbit]\naltitude=5e5\n";
    refuses(
        &format!("{BALL}{orbit}[start]\nrelative_to='orbit'\nspin={{«space»=[0,0,1]}}\n"),
        "unknown key \"space\" in spin",
        "the known keys are body",
    );
    refuses(
        &format!("{BALL}{orbit}[start]\nvelocity=«[1,0,0]»\n"),
        "velocity = [1,0,0] must be left out, since [orbit] defines the motion of the centre of mass",
        "write position and velocity under [orbit]",
    );
    refuses(
        &format!("{BALL}[run]\nduration=«'3 orbits'»\n"),
        "duration = '3 orbits' must be a time, since there is no [orbit]",
        "write [orbit]",
    );
    refuses(
        &format!("{BALL}[orbit]\nposition=[7e6,0,0]\nvelocity=[0,12e3,0]\n[run]\nduration=«'3 orbits'»\n"),
        "duration = '3 orbits' must be a time: a parabolic or hyperbolic orbit has no period",
        "write duration",
    );
    refuses(
        &format!("{BALL}{orbit}[run]\nduration=«'-3 orbits'»\n"),
        "duration = '-3 orbits' must be positive",
        "time runs forward",
    );
    refuses(
        &format!("{BALL}{orbit}«[shaft]»\naxis=[0,0,1]\nbearings=[0,1]\nrate=1\n"),
        "orbit and shaft are both given: a body in orbit is in free fall: its weight does not load the bearings",
        "leave one of them out",
    );
}
