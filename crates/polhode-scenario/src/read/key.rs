//! Keys of varied values: `body.part[0].size[2]`, `torque["wind"].from`, `start.spin.body`.

use polhode_source::nearest;
use polhode_source::toml::tree::{Entries, Kind, Node, Step, Way};

/// Value identified by a key.
pub(crate) struct Spot<'a> {
    pub node: &'a Node,
    /// Path to the value.
    pub way: Way,
    /// Words of the key, for the name of a column.
    pub words: Vec<String>,
    /// Part of the body, from 0, to which the value belongs.
    pub part: Option<usize>,
}

/// Error for a key without a value: the rule that it breaks, and a hint.
pub(crate) type Nowhere = (String, Option<String>);

impl<'a> Spot<'a> {
    /// Finds the value of a key in the file.
    pub(crate) fn at(entries: &'a Entries, key: &str) -> Result<Self, Nowhere> {
        let mut rest = key;
        let mut spot: Option<Self> = None;
        while !rest.is_empty() {
            let done = &key[..key.len() - rest.len()];
            if let Some(inside) = rest.strip_prefix('[') {
                let from =
                    spot.ok_or_else(|| ("a key that starts with the name of a table".to_owned(), None))?;
                let (index, after) = inside
                    .split_once(']')
                    .ok_or_else(|| (format!("a key; the bracket after {done} is not closed"), None))?;
                spot = Some(element(from, done, index, after)?);
                rest = after;
                continue;
            }
            let table = match &spot {
                None => Some(entries),
                Some(Self { node: Node { kind: Kind::Table(entries), .. }, .. }) => Some(entries),
                Some(_) => None,
            };
            let named = if done.is_empty() { Some(rest) } else { rest.strip_prefix('.') };
            let named =
                named.ok_or_else(|| (format!("a key: write a dot or a bracket after {done}"), None))?;
            let (word, after) = named.split_at(named.find(['.', '[']).unwrap_or(named.len()));
            let entry =
                table.and_then(|table| table.get(word)).ok_or_else(|| no_key(table, done, word, after))?;
            let (mut way, mut words, part) =
                spot.map_or_else(Default::default, |spot| (spot.way, spot.words, spot.part));
            way.push(Step::Key(word.into()));
            words.push(word.to_owned());
            spot = Some(Self { node: &entry.node, way, words, part });
            rest = after;
        }
        spot.ok_or_else(|| {
            ("a key of the scenario".to_owned(), Some("write key = \"start.spin.body[0]\"".to_owned()))
        })
    }
}

/// Returns the error for a missing `word` in the table identified by the key before it.
fn no_key(table: Option<&Entries>, done: &str, word: &str, after: &str) -> Nowhere {
    let (here, dot) = if done.is_empty() { ("the scenario", "") } else { (done, ".") };
    let keys: Vec<&str> =
        table.into_iter().flatten().map(|(key, _)| key.as_ref()).filter(|key| *key != "sweep").collect();
    let hint = match nearest(word, keys.iter().copied()) {
        Some(near) => Some(format!("did you mean \"{done}{dot}{near}{after}\"?")),
        None if keys.is_empty() => None,
        None => Some(format!(
            "the keys of {here} are {}; a varying number must be written in the file",
            keys.join(", ")
        )),
    };
    (format!("a key of the scenario; {here} has no key \"{word}\""), hint)
}

/// Returns an element of an array by its index, from 0, or by its `name`.
fn element<'a>(from: Spot<'a>, done: &str, index: &str, after: &str) -> Result<Spot<'a>, Nowhere> {
    let Kind::List(elements) = &from.node.kind else {
        return Err((format!("a key of the scenario; {done} is not an array"), None));
    };
    let name_of = |node: &'a std::sync::Arc<Node>| match &node.kind {
        Kind::Table(entries) => match &entries.get("name")?.node.kind {
            Kind::Text(name) => Some(name.as_str()),
            _ => None,
        },
        _ => None,
    };
    let quoted = index.trim().strip_prefix(['"', '\'']).and_then(|name| name.strip_suffix(['"', '\'']));
    let k = match quoted {
        Some(name) => {
            let names = || elements.iter().filter_map(name_of);
            elements.iter().position(|node| name_of(node) == Some(name)).ok_or_else(|| {
                let hint = match nearest(name, names()) {
                    Some(near) => format!("did you mean '{done}[\"{near}\"]{after}'?"),
                    None => format!("write \"{done}[0]{after}\", or give one of them name = \"{name}\""),
                };
                (format!("a key of the scenario; no {done} is named \"{name}\""), Some(hint))
            })?
        }
        None => index.trim().parse::<usize>().ok().filter(|k| *k < elements.len()).ok_or_else(|| {
            let hint = format!("{done} has {} elements, from {done}[0]", elements.len());
            (format!("a key of the scenario; {done}[{index}] does not exist"), Some(hint))
        })?,
    };
    let node = elements.get(k).map_or(from.node, |node| node);
    let Spot { mut way, mut words, part, .. } = from;
    way.push(Step::Element(k));
    let is_part = words == ["body", "part"];
    let axis = match (elements.len(), &node.kind) {
        (3, _) => ["x", "y", "z"].get(k),
        (4, Kind::List(_)) => None,
        (4, _) => ["w", "x", "y", "z"].get(k),
        _ => None,
    };
    match (&node.kind, axis) {
        (Kind::Table(_), _) | (_, None) => words.push(quoted.map_or_else(|| k.to_string(), str::to_owned)),
        // Element xy of a matrix.
        (_, Some(axis)) if words.last().is_some_and(|last| ["x", "y", "z"].contains(&last.as_str())) => {
            words.last_mut().into_iter().for_each(|last| last.push_str(axis));
        }
        (_, Some(axis)) => words.push((*axis).to_owned()),
    }
    Ok(Spot { node, way, words, part: if is_part { Some(k) } else { part } })
}

/// Returns the key of the transposed off-diagonal element of a tensor, which is the same number.
pub(crate) fn mirrored(key: &str) -> Option<String> {
    let (rest, j) = key.strip_suffix(']')?.rsplit_once('[')?;
    let (matrix, i) = rest.strip_suffix(']')?.rsplit_once('[')?;
    (matrix.ends_with(".inertia") && i != j).then(|| format!("{matrix}[{j}][{i}]"))
}
