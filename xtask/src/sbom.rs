//! Software bill of materials: what is inside the command and the page, as CycloneDX 1.5.
//!
//! npm lists the packages of the page; cargo those of the command and of the modules.

use std::collections::BTreeMap;

use serde_json::{Value, json};

use crate::dependencies::tree;
use crate::process::output;
use crate::viewer::npm;
use crate::{read, root};

/// Returns the bill of materials for a platform.
pub(crate) fn bill(triple: &str) -> Result<String, String> {
    let listed =
        output(&mut npm(&["sbom", "--package-lock-only", "--omit", "dev", "--sbom-format", "cyclonedx"]))?;
    let mut bill: Value = serde_json::from_str(&listed).map_err(|error| format!("npm sbom: {error}"))?;
    let version = env!("CARGO_PKG_VERSION");
    bill["metadata"] = json!({ "component": {
        "type": "application", "name": "polhode", "version": version, "purl": format!("pkg:cargo/polhode-cli@{version}"),
        "licenses": [{ "expression": "MIT OR Apache-2.0" }],
    }});
    let fields = bill.as_object_mut().ok_or("npm sbom: no object")?;
    // It would be another one in each release of the same commit.
    fields.remove("serialNumber");
    // The packages of npm depend on the page, which is not a component.
    fields.remove("dependencies");
    let components =
        fields.get_mut("components").and_then(Value::as_array_mut).ok_or("npm sbom: no components")?;
    components.extend(crates(triple)?);
    let text = serde_json::to_string_pretty(&bill).map_err(|error| error.to_string())?;
    Ok(text + "\n")
}

/// Returns the crates that are linked into the command and into the modules.
fn crates(triple: &str) -> Result<Vec<Value>, String> {
    let mut linked = BTreeMap::new();
    for of in [
        &["--package", "polhode-cli", "--target", triple][..],
        &["--package", "polhode-wasm", "--features", "full", "--target", "wasm32-unknown-unknown"],
    ] {
        linked.extend(tree(&[of, &["--edges", "normal"]].concat())?);
    }
    let lock = read(&root().join("Cargo.lock"))?;
    let checksums = checksums(&lock);
    let component = |(package, licence): (&String, &String)| {
        let mut words = package.split(' ');
        let (name, version) = (words.next()?, words.next()?.strip_prefix('v')?);
        let mut component = json!({
            "type": "library", "name": name, "version": version, "purl": format!("pkg:cargo/{name}@{version}"),
            "bom-ref": format!("pkg:cargo/{name}@{version}"),
            // Cargo still accepts a slash for OR.
            "licenses": [{ "expression": licence.replace('/', " OR ").replace("  ", " ") }],
        });
        if let Some(sum) = checksums.get(&(name, version)) {
            component["hashes"] = json!([{ "alg": "SHA-256", "content": sum }]);
        }
        Some(component)
    };
    Ok(linked.iter().filter_map(component).collect())
}

/// Returns the checksums of Cargo.lock by name and version.
fn checksums(lock: &str) -> BTreeMap<(&str, &str), &str> {
    let entry = |section| {
        let field = |name: &str| str::split_once(section, &format!("\n{name} = \""))?.1.split('"').next();
        Some(((field("name")?, field("version")?), field("checksum")?))
    };
    lock.split("[[package]]").filter_map(entry).collect()
}

#[cfg(test)]
mod tests {
    use super::checksums;

    #[test]
    fn checksums_are_by_name_and_version() {
        let lock = "[[package]]\nname = \"a\"\nversion = \"1.0.0\"\nchecksum = \"ff\"\n\n[[package]]\nname = \"b\"\nversion = \"2.0.0\"\n";
        assert_eq!(checksums(lock).into_iter().collect::<Vec<_>>(), [(("a", "1.0.0"), "ff")]);
    }
}
