//! Events, and the limits of springs and wires, as reported by the command.

use std::f64::consts::PI;

use serde_json::Value;

use crate::common::{Scratch, json, number, stdout};

/// A cylinder on a wire, started fast enough to twist the wire a little beyond half a turn.
const WIRE: &str = r#"[[body.part]]
shape = "tensor"
mass = 1
moments = [1, 1, 0.5]
[start]
spin = { body = [0, 0, 3.15] }
[[torque]]
model = "torsion"
stiffness = 0.5
axis = [0, 0, 1]
[run]
duration = 10
samples = 11
"#;

/// A tumbling body on a spring, under a constant torque.
const SPRING: &str = r#"[[body.part]]
shape="tensor"
mass=1.8549970505634648
center_of_mass=[0.0, -0.0, -0.0]
inertia=[[11.739019321086168, -1.286137211842817, -0.9521130093999195], [-1.286137211842817, 11.421143836389128, 0.8309433334734971], [-0.9521130093999195, 0.8309433334734971, 10.612673296126152]]
[[body.part]]
shape="cylinder"
mass=1.6631381118568465
position=[-0.9683515968944402, -0.6335508627973844, 0.4425166637142123]
rotate={quaternion=[-0.20110762902295024, 0.8710172993355157, -0.3850108531039294, -0.2294585557333099]}
radius=1.592004091475711
length=2.3868287807700557
[start]
attitude={quaternion=[0.8805656093666382, -0.10676595214187971, 0.20537565467652802, -0.4135529948267652]}
spin={body=[1.1736407899817958, 1.4528636162139368, -0.3953360748654875]}
[[torque]]
model="torsion"
stiffness=20.03223627022482
rest={quaternion=[0.04032909350741065, -0.03281606093671906, 0.6518315235471083, 0.7565793648201911]}
[[torque]]
model="constant"
axes="space"
torque=[0.10873343707624103, -0.05836602351954996, -1.357480742948537]
[run]
duration=14.13039423996876
samples=11
"#;

/// |ω| passes a value at which a torque is switched off, and passes it again 0.096 s later.
const SWITCH: &str = r#"[[body.part]]
shape="tensor"
mass=2.776815078198507
center_of_mass=[-0.1426738106335378, 0.11854695122020685, 0.043597213911579794]
inertia=[[0.4148345925530225, -0.018816033463176028, 0.0012170849620350948], [-0.018816033463176028, 0.4157720148293257, -0.015032223411045305], [0.0012170849620350948, -0.015032223411045305, 0.43014832533775377]]
[[body.part]]
shape="tensor"
mass=2.1301267447642713
center_of_mass=[-0.10631170970655547, -0.15286048180583403, 0.09555054459677559]
inertia=[[0.17794822296147156, -0.038454292829154614, 0.03183527801072166], [-0.038454292829154614, 0.2008178226785843, -0.04744246757880075], [0.03183527801072166, -0.04744246757880075, 0.17513722672013704]]
[[body.part]]
shape="tensor"
mass=0.5646276688302359
center_of_mass=[-0.00952286658294163, -0.055472539458437914, 0.1296434842376511]
inertia=[[0.07929867419082857, -0.003749102994130335, 0.0024401244834801996], [-0.003749102994130335, 0.08571584213404326, -7.606018101484493e-05], [0.0024401244834801996, -7.606018101484493e-05, 0.08623154946251252]]
[start]
attitude={quaternion=[0.5981631598610908, -0.6850443710057548, 0.007597066474924863, -0.4157611435900432]}
spin={body=[0.5429805302035187, 0.23443990954173471, -0.21690202639830466]}
[[torque]]
name="tq"
model="magnetic"
moment=[1.1371589184362394, 0.05216637206908881, 0.3223009352773842]
field=[-0.058722228673646265, 0.0057849280297637305, 0.006431441788008505]
[[event]]
measure="time"
value=2.377172013609328
[[event]]
measure="omega"
value=0.7460382732361684
then={switch="tq",on=false}
[[event]]
measure="angle"
value=1.0875159126394418
between=[{body=[-0.2806088277085701, -0.7309409780379075, 0.18264375640856598]},{space=[-1.7297559322110474, 0.7882316108797196, 0.41170475976465887]}]
[run]
duration=7.79168214581595
samples=11
method="METHOD"
"#;

/// Runs a scenario that ends at half a turn; returns the time, s.
#[track_caller]
fn half_turn(scratch: &Scratch, text: &str) -> f64 {
    scratch.write("twisted.toml", text);
    let output = scratch.run(&["simulate", "twisted.toml", "--table", "csv", "--json", "--force"]);
    let error = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(3), "{error}");
    assert!(error.contains("twisted by half a turn") && error.contains("hint: "), "{error}");
    let summary: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(summary["complete"], false);
    assert_eq!(summary["end"]["reason"], "failure");
    let time = number(&summary["end"]["time_s"]);
    let table = std::fs::read_to_string(scratch.0.join("twisted/trajectory.csv")).unwrap();
    let times: Vec<f64> =
        table.lines().skip(1).map(|line| line.split(',').next().unwrap().parse().unwrap()).collect();
    // Earlier samples, and the half turn itself.
    let (last, before) = times.split_last().unwrap();
    assert_eq!(*last, time);
    assert!(before.len() > 1 && before.iter().all(|t| *t < time), "{times:?}");
    assert!(std::fs::read_to_string(scratch.0.join("twisted/report.html")).unwrap().contains("incomplete"));
    time
}

#[test]
fn half_a_turn_of_a_wire_or_spring_ends_a_run_at_one_time_at_all_tolerances() {
    let scratch = Scratch::new("half-turn");
    // ψ = 3.15 sin t.
    let wire = (std::f64::consts::PI / 3.15).asin();
    let spring = half_turn(&scratch, &(SPRING.to_owned() + "tolerance = 1e-15\n"));
    for tolerance in ["1e-15", "1e-13", "1e-11", "1e-9", "1e-7", "1e-5"] {
        let size: f64 = tolerance.parse().unwrap();
        for method in ["auto", "dop853"] {
            let run = format!("tolerance = {tolerance}\nmethod = \"{method}\"\n");
            // dψ/dt is 0.23 rad/s at half a turn.
            let time = half_turn(&scratch, &(WIRE.to_owned() + &run));
            assert!((time - wire).abs() < 100.0 * size + 1e-12, "{run}: {time} {wire}");
            let time = half_turn(&scratch, &(SPRING.to_owned() + &run));
            assert!((time - spring).abs() < 1000.0 * size + 1e-12, "{run}: {time} {spring}");
        }
    }
}

#[test]
fn an_event_that_stops_before_half_a_turn_completes_the_run() {
    let scratch = Scratch::new("before-half-turn");
    let stop = "[[event]]\nmeasure = \"omega_body_z\"\nvalue = 0.3\nthen = \"stop\"\n";
    // ω = 3.15 cos t.
    let wanted = (0.3_f64 / 3.15).acos();
    for tolerance in ["1e-15", "1e-9", "1e-5"] {
        scratch.write("stopped.toml", &format!("{WIRE}tolerance = {tolerance}\n{stop}"));
        let summary = json(&scratch.run(&["simulate", "stopped.toml", "--json", "--force"]));
        assert_eq!(
            (&summary["complete"], &summary["end"]["reason"]),
            (&Value::from(true), &Value::from("event"))
        );
        let time = number(&summary["end"]["time_s"]);
        assert!((time - wanted).abs() < 100.0 * tolerance.parse::<f64>().unwrap() + 1e-12, "{time} {wanted}");
    }
}

#[test]
fn a_value_at_which_a_torque_is_switched_off_is_passed_again() {
    let scratch = Scratch::new("passed-again");
    for method in ["auto", "dop853"] {
        scratch.write("switch.toml", &SWITCH.replace("METHOD", method));
        let summary = json(&scratch.run(&["simulate", "switch.toml", "--json", "--force"]));
        let events = summary["events"].as_array().unwrap();
        let event = events.iter().find(|event| event["name"] == "event 2").unwrap();
        let passages: Vec<f64> =
            event["happened"].as_array().unwrap().iter().map(|it| number(&it["time_s"])).collect();
        assert_eq!(passages.len(), 2, "{summary}");
        assert!((passages[0] - 2.3424).abs() < 5e-5 && (passages[1] - 2.4381).abs() < 5e-5, "{passages:?}");
    }
}

#[test]
fn switching_on_and_off_at_one_value_is_a_failure_that_says_what_to_do() {
    let scratch = Scratch::new("chatter");
    scratch.write(
        "relay.toml",
        r#"[[body.part]]
shape = "tensor"
mass = 1
moments = [2, 3.5, 5]
[[torque]]
name = "motor"
model = "constant"
axes = "body"
torque = [0, 0, 2.3]
[[torque]]
model = "drag"
law = "linear"
coefficient = 0.7
[[event]]
measure = "omega_body_z"
value = 1.1
direction = "rising"
then = { switch = "motor", on = false }
[[event]]
measure = "omega_body_z"
value = 1.1
direction = "falling"
then = { switch = "motor", on = true }
[run]
duration = 20
samples = 21
"#,
    );
    let output = scratch.run(&["simulate", "relay.toml"]);
    let error = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(3), "{error}");
    assert!(error.contains("endlessly") && error.contains("dead band"), "{error}");
}

/// A body that spins about its axis of symmetry z points b to d with cos θ = A + B cos(ω t + φ),
/// A = b_z d_z, B = |b_xy| |d_xy|. So cos θ ≥ cos λ for a share of acos((cos λ − A)/B)/π.
#[test]
fn the_share_of_time_within_a_limit_is_that_of_the_closed_form() {
    let scratch = Scratch::new("pointing-limit");
    // Three turns.
    let duration = 6.0 * PI / 1.7;
    let scenario = "title = 'a scanner'\n\
        [[body.part]]\nshape = 'box'\nsize = ['0.3 m', '0.3 m', '0.1 m']\nmass = '2.5 kg'\n\
        [start]\nspin = { body = [0, 0, '1.7 rad/s'] }\n\
        [[pointing]]\nname = 'antenna'\nbody = [0.6, 0, 0.8]\nto = { space = [0.2, -0.5, 0.7] }\nlimit = '40 deg'\n\
        [[pointing]]\nname = 'panel'\nbody = [0, 1, 0]\nto = { space = [1, 0, 0] }\n\
        [run]\nsamples = 30001\n";
    scratch.write("scanner.toml", &format!("{scenario}duration = {duration}\n"));
    let text = stdout(&scratch.run(&["simulate", "scanner.toml"]));
    let length = (0.04_f64 + 0.25 + 0.49).sqrt();
    let (a, b) = (0.8 * 0.7 / length, 0.6 * 0.29_f64.sqrt() / length);
    let want = ((40_f64.to_radians().cos() - a) / b).acos() / PI;
    let percent = format!("within 40° for {:.2} % of the time", 100.0 * want);
    let answer = text.split("\n\n").next().unwrap().split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(answer.contains(&percent), "{percent}: {text}");
    let file = std::fs::read_to_string(scratch.0.join("scanner/summary.json")).unwrap();
    let summary: Value = serde_json::from_str(&file).unwrap();
    let [antenna, panel] = [&summary["pointings"][0], &summary["pointings"][1]];
    assert!((number(&antenna["share_within"]) - want).abs() < 1e-6, "{antenna}");
    assert!((number(&antenna["limit_rad"]) - 40_f64.to_radians()).abs() < 1e-15);
    assert!(panel["share_within"].is_null() && panel["limit_rad"].is_null(), "{panel}");
}
