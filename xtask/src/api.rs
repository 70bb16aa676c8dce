//! Public API of the core crate, extracted from its documentation and compared with
//! `crates/polhode/api.txt`.

use std::path::{Path, PathBuf};

use crate::process::{FEATURES, cargo, empty_folder, run};
use crate::{Outcome, files, read, root, short};

/// Compares the public API with the file.
pub(crate) fn check() -> Outcome {
    check_in(&document()?)
}

/// Compares the public API in existing documentation with the file.
pub(crate) fn check_in(documentation: &Path) -> Outcome {
    let (path, now) = (root().join(FILE), api(documentation)?);
    let then = read(&path)?.replace("\r\n", "\n");
    if now == then {
        println!("   {FILE}: {} lines", now.lines().count());
        return Ok(());
    }
    let of = |text: &str, other: &str, mark: &str| {
        let lines: Vec<&str> = other.lines().collect();
        let only = text.lines().filter(|line| !lines.contains(line));
        only.take(20).map(|line| format!("\n  {mark} {line}")).collect::<String>()
    };
    let changed = [of(&then, &now, "-"), of(&now, &then, "+")].concat();
    Err(format!("the public names have changed; `cargo xtask api --write` if that is meant:{changed}"))
}

/// Writes the file.
pub(crate) fn write() -> Outcome {
    let path = root().join(FILE);
    std::fs::write(&path, api(&document()?)?).map_err(|error| format!("{}: {error}", short(&path)))
}

const FILE: &str = "crates/polhode/api.txt";

/// Builds the documentation of the core crate in an empty folder, because rustdoc keeps pages of
/// removed items.
fn document() -> Result<PathBuf, String> {
    let target = empty_folder("api")?;
    let doc = ["doc", "--quiet", "--package", "polhode", "--lib", "--no-deps", "--locked", "--features"];
    run(cargo(&doc).arg(FEATURES).env("CARGO_TARGET_DIR", &target))?;
    Ok(target.join("doc"))
}

/// Returns each public item with its declaration, methods and traits.
fn api(documentation: &Path) -> Result<String, String> {
    let folder = documentation.join("polhode");
    let mut items = Vec::new();
    for page in files(&folder, "html")? {
        let inside = page.strip_prefix(&folder).map_err(|error| error.to_string())?;
        if let Some(name) = name_of(inside) {
            items.push((name, item(&read(&page)?)));
        }
    }
    items.sort();
    Ok(items.iter().map(|(name, lines)| format!("{name}\n{lines}\n")).collect())
}

/// Returns the path of an item from that of its page: `motion::State` for
/// `motion/struct.State.html`.
///
/// `None` for pages of modules and of the prelude.
fn name_of(page: &Path) -> Option<String> {
    let folders = page.parent()?.iter().map(|name| name.to_string_lossy().into_owned());
    let (_, name) = page.file_stem()?.to_str()?.split_once('.')?;
    let path: Vec<String> = folders.chain([name.to_owned()]).collect();
    (path[0] != "prelude").then(|| path.join("::"))
}

/// Returns the declaration of an item, the signatures of its methods, and the traits that it
/// implements.
fn item(page: &str) -> String {
    let declared = between(page, "<pre class=\"rust item-decl\"><code>", "</code></pre>").unwrap_or_default();
    let declared = without(declared, "<summary class=\"hideme\">", "</summary>");
    let mut lines: Vec<String> = text_of(&declared).lines().map(|line| format!("    {line}")).collect();
    // Implementations that every type has are omitted.
    let own = page.split("id=\"synthetic-implementations\"").next().unwrap_or_default();
    let own = own.split("id=\"implementors\"").next().unwrap_or_default();
    let (methods, traits) = own.split_once("id=\"trait-implementations\"").unwrap_or((own, ""));
    for (text, tag) in [(methods, "h4"), (traits, "h3")] {
        let mut rest = text;
        while let Some((_, after)) = rest.split_once(&format!("<{tag} class=\"code-header\">")) {
            let (header, after) = after.split_once(&format!("</{tag}>")).unwrap_or((after, ""));
            lines.push(format!("    {}", text_of(header).split_whitespace().collect::<Vec<_>>().join(" ")));
            rest = after;
        }
    }
    lines.iter().map(|line| format!("{}\n", line.trim_end())).collect()
}

fn between<'a>(text: &'a str, start: &str, end: &str) -> Option<&'a str> {
    Some(text.split_once(start)?.1.split_once(end)?.0)
}

/// Returns the text without all parts from `start` to `end`, inclusive.
fn without(text: &str, start: &str, end: &str) -> String {
    let mut parts = text.split(start);
    let first = parts.next().unwrap_or_default();
    let rest = parts.map(|part| part.split_once(end).map_or(part, |(_, after)| after));
    [first].into_iter().chain(rest).collect()
}

/// Returns HTML without its tags.
fn text_of(html: &str) -> String {
    let mut text = String::new();
    let mut is_tag = false;
    for c in html.chars() {
        match c {
            '<' => is_tag = true,
            '>' => is_tag = false,
            _ if !is_tag => text.push(c),
            _ => {}
        }
    }
    let named =
        [("&lt;", "<"), ("&gt;", ">"), ("&#39;", "'"), ("&quot;", "\""), ("&amp;", "&"), ("\u{a0}", " ")];
    named.iter().fold(text, |text, (name, c)| text.replace(name, c))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_page_is_its_declaration_methods_and_traits() {
        let page = "<pre class=\"rust item-decl\"><code>pub struct <a>A</a>&lt;T&gt;<summary class=\"hideme\"><span>Show</span></summary>;</code></pre>\
            <h4 class=\"code-header\">pub fn <a>of</a>(x: <a>f64</a>) -&gt; Self</h4>\
            <h2 id=\"trait-implementations\"></h2><h3 class=\"code-header\">impl <a>Debug</a> for A</h3>\
            <h4 class=\"code-header\">fn fmt(&amp;self)</h4>\
            <h2 id=\"synthetic-implementations\"></h2><h3 class=\"code-header\">impl Send for A</h3>";
        assert_eq!(item(page), "    pub struct A<T>;\n    pub fn of(x: f64) -> Self\n    impl Debug for A\n");
        assert_eq!(name_of(Path::new("motion/struct.State.html")).unwrap(), "motion::State");
        assert_eq!(name_of(Path::new("prelude/struct.State.html")), None);
        assert_eq!(name_of(Path::new("motion/index.html")), None);
    }
}
