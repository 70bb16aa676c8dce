//! The protocol: versions, and messages that are not valid.

use polhode_source::files::Memory;
use serde_json::{Value, json};

use crate::{answers, ask, stated};

/// Returns the handshake with a version.
fn handshake(version: &str) -> Vec<u8> {
    let params = json!({ "protocolVersion": version, "capabilities": {}, "clientInfo": { "name": "test", "version": "1" } });
    json!({ "jsonrpc": "2.0", "id": 7, "method": "initialize", "params": params }).to_string().into_bytes()
}

#[test]
fn the_handshake_agrees_on_a_version() {
    for (requested, agreed) in [
        ("2024-11-05", "2024-11-05"),
        // This version requires batches, which are not supported.
        ("2025-03-26", "2024-11-05"),
        ("2025-06-18", "2025-06-18"),
        ("2025-11-25", "2025-11-25"),
        ("2026-07-28", "2025-11-25"),
        ("2031-01-01", "2025-11-25"),
        ("1.0", "2025-11-25"),
    ] {
        let begun = br#"{"jsonrpc": "2.0", "method": "notifications/initialized"}"#;
        let list = br#"{"jsonrpc": "2.0", "id": 8, "method": "tools/list"}"#;
        let [first, listed] =
            answers(&[&handshake(requested), begun, list], Memory::default()).try_into().unwrap();
        assert_eq!(first["result"]["protocolVersion"], agreed, "{requested}");
        assert_eq!(first["result"]["capabilities"], json!({ "tools": {} }));
        assert_eq!(listed["result"]["tools"].as_array().unwrap().len(), 5);
        // These keys are of a later version.
        assert_eq!(listed["result"].as_object().unwrap().len(), 1, "{listed}");
    }
}

#[test]
fn requests_that_state_their_version_need_no_handshake() {
    let found = ask("server/discover", json!({}), Memory::default());
    assert_eq!((&found["id"], &found["jsonrpc"]), (&json!("a-1"), &json!("2.0")));
    let found = &found["result"];
    assert_eq!(found["supportedVersions"], json!(["2026-07-28"]));
    assert_eq!(found["_meta"]["io.modelcontextprotocol/serverInfo"]["name"], "polhode");
    assert_eq!((&found["resultType"], &found["cacheScope"]), (&json!("complete"), &json!("public")));
    let listed = &ask("tools/list", json!({}), Memory::default())["result"];
    assert_eq!((&listed["ttlMs"], &listed["resultType"]), (&found["ttlMs"], &found["resultType"]));
    // Methods of the older versions.
    for method in ["initialize", "ping", "logging/setLevel"] {
        assert_eq!(ask(method, json!({}), Memory::default())["error"]["code"], -32601, "{method}");
    }
}

#[test]
fn a_request_states_a_known_version() {
    let of = |meta: Value| {
        let params = json!({ "_meta": meta });
        let line = json!({ "jsonrpc": "2.0", "id": 3, "method": "tools/list", "params": params }).to_string();
        answers(&[line.as_bytes()], Memory::default()).remove(0)["error"].clone()
    };
    let (version, capabilities) =
        ("io.modelcontextprotocol/protocolVersion", "io.modelcontextprotocol/clientCapabilities");
    for meta in [json!({}), json!({ capabilities: {} }), json!({ version: "2026-07-28" })] {
        assert_eq!(of(meta.clone())["code"], -32602, "{meta}");
    }
    for requested in [json!("2027-01-01"), json!("2025-11-25"), json!(2026)] {
        let error = of(json!({ version: requested, capabilities: {} }));
        assert_eq!(error["code"], -32022);
        assert_eq!(error["data"], json!({ "supported": ["2026-07-28"], "requested": requested }));
    }
}

#[test]
fn invalid_messages_have_their_errors() {
    let call = |arguments: &str| {
        let of = |meta: &str| {
            format!(
                r#"{{"jsonrpc": "2.0", "id": 5, "method": "tools/call", "params": {{{meta}, {arguments}}}}}"#
            )
        };
        of(
            r#""_meta": {"io.modelcontextprotocol/protocolVersion": "2026-07-28", "io.modelcontextprotocol/clientCapabilities": {}}"#,
        )
    };
    for (line, code, id) in [
        ("{", -32700, json!(null)),
        ("nonsense", -32700, json!(null)),
        (r#"{"jsonrpc": "2.0", "id": 5, "method": "ping", "id": 6}"#, -32600, json!(6)),
        (r#"[{"jsonrpc": "2.0", "id": 5, "method": "ping"}]"#, -32600, json!(null)),
        (r#"{"id": 5, "method": "ping"}"#, -32600, json!(5)),
        (r#"{"jsonrpc": "1.0", "id": 5, "method": "ping"}"#, -32600, json!(5)),
        (r#"{"jsonrpc": "2.0", "id": null, "method": "ping"}"#, -32600, json!(null)),
        (r#"{"jsonrpc": "2.0", "id": 5.5, "method": "ping"}"#, -32600, json!(null)),
        (r#"{"jsonrpc": "2.0", "id": 5}"#, -32600, json!(5)),
        (r#"{"jsonrpc": "2.0", "id": 5, "method": 3}"#, -32600, json!(5)),
        (r#"{"jsonrpc": "2.0", "id": 5, "method": "ping", "params": [1]}"#, -32600, json!(5)),
        (r#"{"jsonrpc": "2.0", "id": 5, "method": "initialize", "params": {}}"#, -32602, json!(5)),
        (&call(r#""name": "spin""#), -32602, json!(5)),
        (&call(r#""arguments": {}"#), -32602, json!(5)),
        (&call(r#""name": "check", "arguments": [1]"#), -32602, json!(5)),
        (&call(r#""name": "check", "arguments": {"files": [], "files": ["a"]}"#), -32600, json!(5)),
    ] {
        let [answer] = answers(&[line.as_bytes()], Memory::default()).try_into().unwrap();
        assert_eq!((&answer["error"]["code"], &answer["id"]), (&json!(code), &id), "{line}: {answer}");
        assert!(!answer["error"]["message"].as_str().unwrap().is_empty());
    }
    let not_utf8 = answers(&[b"{\"jsonrpc\": \"2.0\", \"id\": 5, \"method\": \"\xff\"}"], Memory::default());
    assert_eq!(not_utf8[0]["error"]["code"], -32700);
    let paged = ask("tools/list", json!({ "cursor": "2" }), Memory::default());
    assert_eq!(paged["error"]["code"], -32602);
    let spin = ask("tools/call", json!({ "name": "spin" }), Memory::default());
    let message = "unknown tool \"spin\"; the tools are inertia, check, simulate, judge, explain";
    assert_eq!(spin["error"]["message"], message);
}

#[test]
fn notifications_and_answers_are_not_answered() {
    let lines: [&[u8]; 6] = [
        b"",
        b" \r",
        br#"{"jsonrpc": "2.0", "method": "notifications/cancelled", "params": {"requestId": 99}}"#,
        br#"{"jsonrpc": "2.0", "method": "notifications/unknown"}"#,
        br#"{"jsonrpc": "2.0", "id": 1, "result": {}}"#,
        br#"{"jsonrpc": "2.0", "id": "p", "method": "ping"}"#,
    ];
    let expected = json!({ "jsonrpc": "2.0", "id": "p", "result": {} });
    assert_eq!(answers(&lines, Memory::default()), [expected]);
}

#[test]
fn an_id_is_used_once_at_a_time() {
    let call = |id: Value| {
        let mut call: Value = serde_json::from_slice(&stated(
            "tools/call",
            json!({ "name": "inertia", "arguments": { "rod": "2 m", "mass": "3 kg" } }),
        ))
        .unwrap();
        call["id"] = id;
        call.to_string().into_bytes()
    };
    // A number and a text are two ids.
    let lines = [call(json!(1)), call(json!("1")), call(json!(2))];
    let lines: Vec<&[u8]> = lines.iter().map(Vec::as_slice).collect();
    let mut ids: Vec<String> =
        answers(&lines, Memory::default()).iter().map(|answer| answer["id"].to_string()).collect();
    ids.sort();
    assert_eq!(ids, ["\"1\"", "1", "2"]);
}
