//! `polhode mcp`: each tool gives the result of its command, and reads only files of its folder.

use std::io::{BufRead as _, BufReader, Lines, Write as _};
use std::process::{Child, ChildStdin, ChildStdout, Stdio};
use std::time::{Duration, Instant};

use serde_json::{Value, json};

use crate::common::{Scratch, example};
use crate::schema::misfit;

/// Client of a running server.
struct Client {
    child: Child,
    input: Option<ChildStdin>,
    output: Lines<BufReader<ChildStdout>>,
    sent: u64,
}

impl Client {
    fn start(scratch: &Scratch, arguments: &[&str]) -> Self {
        let mut command = scratch.command(&[&["mcp"], arguments].concat());
        let mut child =
            command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        let output = BufReader::new(child.stdout.take().unwrap()).lines();
        let mut client = Self { input: child.stdin.take(), child, output, sent: 0 };
        let info = json!({ "name": "test", "version": "1" });
        let asked = json!({ "protocolVersion": "2025-11-25", "capabilities": {}, "clientInfo": info });
        let begun = client.ask("initialize", &asked);
        assert_eq!(begun["result"]["serverInfo"]["name"], "polhode");
        client.send(&json!({ "jsonrpc": "2.0", "method": "notifications/initialized" }));
        client
    }

    fn send(&mut self, message: &Value) {
        writeln!(self.input.as_ref().unwrap(), "{message}").unwrap();
    }

    /// Sends a request and returns its id.
    fn request(&mut self, method: &str, params: &Value) -> u64 {
        self.sent += 1;
        let id = self.sent;
        self.send(&json!({ "jsonrpc": "2.0", "id": id, "method": method, "params": params }));
        id
    }

    /// Returns the next message; every line of the output is one.
    fn receive(&mut self) -> Value {
        let message: Value = serde_json::from_str(&self.output.next().unwrap().unwrap()).unwrap();
        assert_eq!(message["jsonrpc"], "2.0");
        message
    }

    fn ask(&mut self, method: &str, params: &Value) -> Value {
        let id = self.request(method, params);
        let answer = self.receive();
        assert_eq!(answer["id"], id);
        answer
    }

    fn start_call(&mut self, tool: &str, arguments: &Value) -> u64 {
        self.request("tools/call", &json!({ "name": tool, "arguments": arguments }))
    }

    /// Calls a tool, and returns its text and structured result.
    fn call(&mut self, tool: &str, arguments: &Value) -> (String, Value) {
        let answer = self.ask("tools/call", &json!({ "name": tool, "arguments": arguments }));
        let result = &answer["result"];
        let text = result["content"][0]["text"].as_str().unwrap_or_else(|| panic!("{answer}"));
        let structured = &result["structuredContent"];
        let is_error = structured.is_null() || structured["exit_status"].as_u64().unwrap() >= 2;
        assert_eq!(result["isError"], is_error, "{text}");
        (text.to_owned(), structured.clone())
    }

    /// Returns the text of a call that must fail.
    fn refused(&mut self, tool: &str, arguments: &Value) -> String {
        let (text, structured) = self.call(tool, arguments);
        assert!(structured.is_null() || structured["exit_status"] == 2, "{text}");
        assert!(text.starts_with("error: ") && text.contains("\nhint: "), "{text}");
        text
    }

    /// Ends the input; the server ends with success, and has printed no message.
    fn end(mut self) {
        self.input = None;
        assert_eq!(self.output.next().map(Result::unwrap), None);
        let output = self.child.wait_with_output().unwrap();
        let printed = String::from_utf8(output.stderr).unwrap();
        assert_eq!((output.status.code(), printed.as_str()), (Some(0), ""));
    }
}

/// Copies examples into a folder.
fn with_examples(scratch: &Scratch, names: &[&str]) {
    for name in names {
        std::fs::copy(example(name), scratch.0.join(name.rsplit('/').next().unwrap())).unwrap();
    }
}

#[test]
fn each_tool_has_the_result_of_its_command() {
    let scratch = Scratch::new("mcp-same");
    let examples = [
        "bracket.stl",
        "meshes/bracket.ply",
        "robots/gripper.urdf",
        "robots/bad-arm.urdf",
        "heavy-top.toml",
        "judge/pybullet-default.csv",
        "judge/tumbling.toml",
    ];
    with_examples(&scratch, &examples);
    let mut client = Client::start(&scratch, &[]);
    let listed = client.ask("tools/list", &json!({}));
    let schema = |tool: &str| {
        let tools = listed["result"]["tools"].as_array().unwrap();
        tools.iter().find(|listed| listed["name"] == tool).unwrap()["outputSchema"].to_string()
    };
    for (tool, arguments, options) in [
        (
            "inertia",
            json!({ "files": ["bracket.stl"], "unit": "mm", "mass": "85 g", "about": "(3,-2,12) mm", "along": "0.9,0.1,-0.3,0.2" }),
            &["bracket.stl", "--unit=mm", "--mass=85 g", "--about=(3,-2,12) mm", "--along=0.9,0.1,-0.3,0.2"]
                [..],
        ),
        (
            "inertia",
            json!({ "files": ["gripper.urdf"], "subtree": "palm", "joint": ["left_knuckle=20 deg"] }),
            &["gripper.urdf", "--subtree=palm", "--joint=left_knuckle=20 deg"],
        ),
        (
            "inertia",
            json!({ "files": ["bracket.stl", "bracket.ply"], "unit": "mm", "mass": 0.085 }),
            &["bracket.stl", "bracket.ply", "--unit=mm", "--mass=0.085"],
        ),
        ("check", json!({ "files": ["bad-arm.urdf"], "for": ["mujoco"] }), &["bad-arm.urdf", "--for=mujoco"]),
        ("check", json!({ "files": ["."], "fail-on": "impossible" }), &[".", "--fail-on=impossible"]),
        (
            "simulate",
            json!({ "file": "heavy-top.toml", "at": ["0.3 s", "0.1:0.2:0.05"] }),
            &["heavy-top.toml", "--at=0.3 s", "--at=0.1:0.2:0.05", "--output=out", "--no-page"],
        ),
        (
            "judge",
            json!({ "files": ["tumbling.toml", "pybullet-default.csv"] }),
            &["tumbling.toml", "pybullet-default.csv"],
        ),
        ("explain", json!({ "file": "heavy-top.toml" }), &["heavy-top.toml"]),
    ] {
        let (text, structured) = client.call(tool, &arguments);
        assert_eq!(misfit(&schema(tool), &structured), None, "{tool} {arguments}");
        let printed = scratch.run(&[&[tool], options].concat());
        let output = String::from_utf8(printed.stdout).unwrap();
        let is_same = if tool == "simulate" { output.starts_with(&text) } else { output == text };
        assert!(is_same, "{tool} {arguments}:\n{text}\n{output}");
        assert_eq!(structured["exit_status"].as_i64(), printed.status.code().map(i64::from), "{tool}");
        let form: Value =
            serde_json::from_slice(&scratch.run(&[&[tool], options, &["--json"]].concat()).stdout).unwrap();
        assert_eq!(structured["report"], form, "{tool} {arguments}");
    }
    client.end();
    let same = scratch.entries();
    assert_eq!(same.len(), examples.len() + 1, "only the command has written: {same:?}");
}

#[test]
fn fixes_are_shown_as_a_diff() {
    let scratch = Scratch::new("mcp-fix");
    with_examples(&scratch, &["robots/bad-arm.urdf"]);
    let mut client = Client::start(&scratch, &[]);
    let (text, structured) = client.call("check", &json!({ "files": ["bad-arm.urdf"], "fix": true }));
    let diff = String::from_utf8(scratch.run(&["check", "bad-arm.urdf", "--fix"]).stdout).unwrap();
    assert!(text.starts_with(&diff) && diff.contains("+      <inertia"), "{text}");
    assert_eq!(structured["exit_status"], 1);
    client.end();
}

#[test]
fn states_are_spread_over_the_run() {
    let scratch = Scratch::new("mcp-samples");
    with_examples(&scratch, &["heavy-top.toml"]);
    let mut client = Client::start(&scratch, &[]);
    let (_, few) = client.call("simulate", &json!({ "file": "heavy-top.toml", "samples": 4 }));
    let at = few["report"]["at"].as_array().unwrap();
    let times: Vec<f64> = at.iter().map(|state| state["time_s"].as_f64().unwrap()).collect();
    let end = few["report"]["final"]["time_s"].as_f64().unwrap();
    assert_eq!(times, [0.0, end * (1.0 / 3.0), end * (2.0 / 3.0), end]);
    assert_eq!(at[3]["attitude_wxyz"], few["report"]["final"]["attitude_wxyz"]);
    for (samples, rule) in [
        (json!(1), "samples = 1: it must be from 2 to 200"),
        (json!(-3), "samples = -3: it must be from 2 to 200"),
        (json!(201), "samples = 201: it must be from 2 to 200"),
        (json!(2.5), "samples = 2.5: invalid type"),
    ] {
        let text = client.refused("simulate", &json!({ "file": "heavy-top.toml", "samples": samples }));
        assert!(text.contains(rule), "{text}");
    }
    let many = json!({ "file": "heavy-top.toml", "samples": 150, "at": ["0:1:0.02"] });
    let text = client.refused("simulate", &many);
    assert!(text.contains("ask for 201 states; a call returns at most 200"), "{text}");
    client.end();
}

#[test]
fn an_invalid_input_is_told_to_the_model() {
    let scratch = Scratch::new("mcp-refused");
    with_examples(&scratch, &["heavy-top.toml", "robots/gripper.urdf", "bracket.stl"]);
    scratch.write("bad.toml", "[[body.part]]\nshape = 'box'\nsize = [0.1, -0.2, 0.3]\nmass = 2\n");
    scratch.write("still.toml", "[[body.part]]\nshape = 'box'\nsize = [0.1, 0.2, 0.3]\nmass = 2\n");
    scratch.write("run.csv", "time,qw,qx,qy,qz\n0,1,0,0,0\n0.1,nan,0,0,0\n");
    let mut client = Client::start(&scratch, &[]);
    for (tool, arguments, parts) in [
        ("inertia", json!({}), &["no body is given"][..]),
        (
            "inertia",
            json!({ "box": "1 m, 2 m, 3 m", "mass": "2 kgg" }),
            &["mass = \"2 kgg\"", "did you mean kg?"],
        ),
        (
            "inertia",
            json!({ "box": "1 m, 2 m, 3 m", "mas": 2 }),
            &["no argument \"mas\"", "did you mean mass?"],
        ),
        (
            "inertia",
            json!({ "files": "bracket.stl" }),
            &["files = \"bracket.stl\"", "hint: files: Scenarios"],
        ),
        (
            "inertia",
            json!({ "files": ["bracket.stl"], "write-mesh": "a.stl" }),
            &["no argument \"write-mesh\""],
        ),
        (
            "inertia",
            json!({ "files": ["gripper.urdf"], "link": "palm", "lump": "all" }),
            &["link and lump contradict each other"],
        ),
        ("check", json!({}), &["the argument files of check is missing"]),
        ("check", json!({ "files": [] }), &["the argument files of check is missing"]),
        (
            "check",
            json!({ "files": ["gripper.urdf"], "for": ["bullet"] }),
            &["for = [\"bullet\"]", "`mujoco`"],
        ),
        ("simulate", json!({}), &["the argument file of simulate is missing"]),
        ("simulate", json!({ "file": "still.toml" }), &["has no [run] section"]),
        ("simulate", json!({ "file": "bad.toml" }), &["--> bad.toml:3:", "-0.2"]),
        ("simulate", json!({ "file": "heavy-top.toml", "at": [1e9] }), &["outside of the run"]),
        ("judge", json!({}), &["no log to judge was given"]),
        ("judge", json!({ "files": ["run.csv"], "moments": "1,2,3" }), &["--> run.csv:3:"]),
        ("explain", json!({ "file": "bad.toml" }), &["--> bad.toml:3:"]),
        ("explain", json!({ "file": "none.toml" }), &["none.toml", "the file does not exist"]),
        ("explain", json!({ "file": "a.toml", "contents": { "a.toml": 3 } }), &["contents[\"a.toml\"] = 3"]),
        ("explain", json!({ "file": "a", "contents": { "a": "", "./a": "" } }), &["is given twice"]),
        ("explain", json!({ "file": "heavy-top.toml", "contents": {} }), &["the file does not exist"]),
    ] {
        let text = client.refused(tool, &arguments);
        parts.iter().for_each(|part| assert!(text.contains(part), "{tool} {arguments}: {text}"));
    }
    // The other files have their results.
    let files = json!({ "files": ["none.stl", "bracket.stl"], "unit": "mm", "mass": 1 });
    let (text, structured) = client.call("inertia", &files);
    assert!(text.contains("principal") && text.contains("error: cannot read \"none.stl\""), "{text}");
    assert_eq!(structured["exit_status"], 2);
    assert_eq!(structured["report"].as_array().unwrap().len(), 2);
    client.end();
}

#[test]
fn a_tool_reads_only_files_of_the_folder() {
    let scratch = Scratch::new("mcp-root");
    let inside = scratch.0.join("inside");
    std::fs::create_dir(&inside).unwrap();
    let part = "shape = 'box'\nsize = [0.1, 0.2, 0.3]\nmass = 2\n";
    scratch.write("outside.toml", &format!("[[body.part]]\n{part}"));
    scratch.write("inside/inside.toml", &format!("[[body.part]]\n{part}"));
    std::fs::copy(example("bracket.stl"), scratch.0.join("bracket.stl")).unwrap();
    let mesh = "[[body.part]]\nshape = 'mesh'\nfile = '../bracket.stl'\nunit = 'mm'\nmass = 0.085\n";
    scratch.write("inside/names.toml", mesh);
    let inertia =
        "<inertial><mass value='1.7'/><inertia ixx='2' ixy='0' ixz='0' iyy='3' iyz='0' izz='4'/></inertial>";
    let shape = "<collision><geometry><mesh filename='../bracket.stl'/></geometry></collision>";
    let robot = format!("<robot name='r'><link name='arm'>{inertia}{shape}</link></robot>");
    scratch.write("inside/arm.urdf", &robot);
    scratch
        .write("inside/run.csv", "time,qw,qx,qy,qz\n0,1,0,0,0\n0.1,0.9998,0.02,0,0\n0.2,0.9992,0.04,0,0\n");
    let mut client = Client::start(&scratch, &["--root", "inside"]);
    let absolute = inside.canonicalize().unwrap().join("inside.toml");
    for path in ["inside.toml", "./../inside/inside.toml", absolute.to_str().unwrap()] {
        let (text, structured) = client.call("inertia", &json!({ "files": [path] }));
        assert_eq!(structured["report"]["mass"], 2.0, "{text}");
    }
    let outside = scratch.0.canonicalize().unwrap().join("outside.toml");
    let mut paths = vec!["../outside.toml", "x/../../none.toml", outside.to_str().unwrap(), "/etc/none.toml"];
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink("../outside.toml", inside.join("link.toml")).unwrap();
        paths.push("link.toml");
    }
    for path in paths {
        let (text, _) = client.call("inertia", &json!({ "files": ["inside.toml", path] }));
        assert!(text.contains("lies outside the folders that may be read; --root DIR"), "{path}: {text}");
        for (tool, key) in [("explain", "file"), ("check", "config"), ("judge", "against")] {
            let arguments = json!({ key: path, "files": ["run.csv"] });
            let arguments = if tool == "explain" { json!({ key: path }) } else { arguments };
            let (text, _) = client.call(tool, &arguments);
            assert!(
                text.starts_with("error: ") && text.contains("lies outside the folders"),
                "{tool} {path}: {text}"
            );
        }
    }
    let text = client.refused("explain", &json!({ "file": "names.toml" }));
    assert!(text.contains("must be a file in the folder of the data file"), "{text}");
    let (text, _) = client.call("check", &json!({ "files": ["arm.urdf"] }));
    assert!(text.contains("../bracket.stl") && text.contains("outside"), "{text}");
    client.end();
    let refused = scratch.run(&["mcp", "--root", "none"]);
    assert!(crate::common::refused(&refused, 2).contains("hint: a root must be a folder"));
}

/// Scenario that takes many minutes.
const LONG: &str = "[[body.part]]\nshape = 'box'\nsize = [0.1, 0.2, 0.3]\nmass = 2\n\
    [start]\nspin = { body = [0.1, 3, 0.2] }\n\
    [[torque]]\nmodel = 'constant'\naxes = 'body'\ntorque = [1e-9, 2e-9, 0]\n[run]\nduration = 4e7\nsamples = 3\n";

#[test]
fn calls_run_side_by_side_and_a_cancelled_one_stops() {
    let scratch = Scratch::new("mcp-cancel");
    let mut client = Client::start(&scratch, &[]);
    let long = json!({ "file": "long.toml", "contents": { "long.toml": LONG } });
    let short = json!({ "box": "20 cm, 10 cm, 6 cm", "mass": 2.5 });
    let slow = client.start_call("simulate", &long);
    let quick = client.start_call("inertia", &short);
    assert_eq!(client.receive()["id"], quick);
    let others: Vec<u64> = (1..16).map(|_| client.start_call("simulate", &long)).collect();
    let refused = client.ask("tools/call", &json!({ "name": "inertia", "arguments": short }));
    assert_eq!(refused["error"]["message"], "16 calls are running: wait for one");
    for id in [slow].iter().chain(&others) {
        let params = json!({ "requestId": id, "reason": "a test" });
        client.send(&json!({ "jsonrpc": "2.0", "method": "notifications/cancelled", "params": params }));
    }
    // Cancelled calls make room, and are not answered.
    while client.ask("tools/call", &json!({ "name": "inertia", "arguments": short })).get("error").is_some() {
    }
    client.end();
}

#[test]
fn the_end_of_the_input_ends_the_process() {
    let scratch = Scratch::new("mcp-end");
    let mut client = Client::start(&scratch, &[]);
    client.start_call("simulate", &json!({ "file": "long.toml", "contents": { "long.toml": LONG } }));
    let start = Instant::now();
    client.end();
    assert!(start.elapsed() < Duration::from_secs(60));
}
