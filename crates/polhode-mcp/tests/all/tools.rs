//! The tools: definitions, examples, and files among the arguments.

use polhode_robot::LinkChoice;
use polhode_source::files::Memory;
use serde_json::{Value, json};

use crate::ask;
use crate::schema::misfit;

fn tools() -> Vec<Value> {
    let listed = ask("tools/list", json!({}), Memory::default());
    listed["result"]["tools"].as_array().unwrap().clone()
}

fn call(tool: &Value, arguments: &Value, files: Memory) -> Value {
    ask("tools/call", json!({ "name": tool, "arguments": arguments }), files)["result"].clone()
}

/// Returns files of examples by the names that descriptions use.
fn files() -> Memory {
    let examples = concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples");
    let mut files = Memory::default();
    for (name, path) in [
        ("bracket.stl", "bracket.stl"),
        ("robot.urdf", "robots/bad-arm.urdf"),
        ("run.csv", "judge/mujoco-rk4.csv"),
        ("tumbling.toml", "judge/tumbling.toml"),
        ("box.toml", "t-handle.toml"),
    ] {
        files.insert(name, std::fs::read(format!("{examples}/{path}")).unwrap());
    }
    files
}

#[test]
fn the_example_of_each_description_runs() {
    for tool in tools() {
        let description = tool["description"].as_str().unwrap();
        let (_, example) = description.split_once("Example: ").unwrap();
        let arguments: Value = serde_json::from_str(example).unwrap();
        assert_eq!(misfit(&tool["inputSchema"].to_string(), &arguments), None);
        let result = call(&tool["name"], &arguments, files());
        assert_eq!(result["isError"], false, "{result}");
        let structured = &result["structuredContent"];
        assert_eq!(misfit(&tool["outputSchema"].to_string(), structured), None, "{example}");
        assert!(result["content"][0]["text"].as_str().unwrap().len() > 200);
    }
}

#[test]
fn tools_are_read_only_and_their_arguments_are_portable() {
    for tool in tools() {
        let annotations = &tool["annotations"];
        assert_eq!(
            (&annotations["readOnlyHint"], &annotations["openWorldHint"]),
            (&json!(true), &json!(false))
        );
        let input = &tool["inputSchema"];
        assert_eq!((&input["type"], &tool["outputSchema"]["type"]), (&json!("object"), &json!("object")));
        let text = input.to_string();
        // The inspector of the protocol warns of lists of types.
        assert!(!text.contains("\"type\":[") && !text.contains("null]"), "{text}");
        for key in ["write-mesh", "today"] {
            assert!(input["properties"].get(key).is_none(), "{key}");
        }
    }
}

#[test]
fn the_choice_of_links_has_the_keys_of_its_schema() {
    let schema: Value = serde_json::from_str(polhode_robot::LINK_CHOICE_SCHEMA).unwrap();
    let keys = |value: &Value| {
        let mut keys: Vec<String> = value.as_object().unwrap().keys().cloned().collect();
        keys.sort();
        keys
    };
    let mut choice = serde_json::to_value(LinkChoice::default()).unwrap();
    choice.as_object_mut().unwrap().remove("table");
    assert_eq!(keys(&choice), keys(&schema["properties"]));
}

#[test]
fn texts_among_the_arguments_replace_all_files() {
    let part = |mass: f64| format!("[[body.part]]\nshape = 'box'\nsize = [0.1, 0.2, 0.3]\nmass = {mass}\n");
    let files = Memory::from([("a.toml", part(2.0)), ("b.toml", part(3.0))]);
    let mass = |arguments: Value| {
        let result = call(&json!("inertia"), &arguments, files.clone());
        result["structuredContent"]["report"]["mass"].clone()
    };
    assert_eq!(mass(json!({ "files": ["a.toml"] })), 2.0);
    assert_eq!(mass(json!({ "files": ["a.toml"], "contents": null })), 2.0);
    assert_eq!(mass(json!({ "files": ["a.toml"], "contents": { "a.toml": part(5.5) } })), 5.5);
    let other = json!({ "files": ["b.toml"], "contents": { "a.toml": part(5.5) } });
    let result = call(&json!("inertia"), &other, files.clone());
    assert_eq!(result["isError"], true);
    assert!(result["content"][0]["text"].as_str().unwrap().contains("the file does not exist"));
}
