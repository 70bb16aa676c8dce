//! Values that the reader accepts at a place of a scenario file, collected from its requests.

use std::collections::{BTreeMap, BTreeSet};

use polhode_source::toml::What;
use polhode_source::unit::Dimension;

use super::answer::Answer;
use super::sample::{Sample, Step};

/// Type without parameters.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Plain {
    Text,
    Truth,
    Count,
    Number,
}

/// Values that the reader accepts at a place.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Accepted {
    pub plain: BTreeSet<Plain>,
    /// Dimensions of a quantity, in the order in which they were found.
    pub dimensions: Vec<Dimension>,
    /// Names, one of which a string must be.
    pub names: Vec<&'static str>,
    /// Lengths of an array; `None` for any.
    pub lengths: BTreeSet<Option<usize>>,
    /// Accepted elements of an array.
    pub element: Option<Box<Self>>,
    /// Accepted tables, by name and keys.
    pub forms: Vec<Form>,
    /// Accepted values of a table with user-defined keys.
    pub any_key: Option<Box<Self>>,
}

/// Table with its keys.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Form {
    /// Name of the table in messages.
    pub name: String,
    pub keys: Vec<(&'static str, Accepted)>,
    /// Keys that the reader required in at least one sample.
    required: BTreeSet<&'static str>,
    /// Keys common to all samples that were read to the end; `None` if there were none.
    common: Option<BTreeSet<String>>,
    /// Keys common to all samples.
    written: Option<BTreeSet<String>>,
    /// Names that were used for keys with a choice of names.
    pub chosen: BTreeMap<&'static str, BTreeSet<String>>,
}

impl Accepted {
    /// True if no request was found.
    pub(super) fn is_empty(&self) -> bool {
        *self == Self::default()
    }

    /// Adds the requests for a value of a sample at a path, and for all values in it.
    pub(super) fn add(&mut self, value: &Sample, way: &mut Vec<Step>, answer: &Answer) {
        for what in answer.at(way) {
            match what {
                What::Text => drop(self.plain.insert(Plain::Text)),
                What::Truth => drop(self.plain.insert(Plain::Truth)),
                What::Count => drop(self.plain.insert(Plain::Count)),
                What::Number => drop(self.plain.insert(Plain::Number)),
                What::Quantity(dimension) if self.dimensions.contains(dimension) => {}
                What::Quantity(dimension) => self.dimensions.push(*dimension),
                What::Choice(names) => {
                    let new: Vec<_> = names.iter().filter(|name| !self.names.contains(name)).collect();
                    self.names.extend(new);
                }
                What::Array(length) => drop(self.lengths.insert(*length)),
                What::AnyKeys => drop(self.any_key.get_or_insert_default()),
                What::Table | What::PerhapsArray | What::Keys(..) | What::Required(_) => {}
            }
        }
        match value {
            Sample::Plain(_) => {}
            // Elements belong to the reader only if it requested an array.
            Sample::List(_) if self.lengths.is_empty() => {}
            Sample::List(elements) => {
                let inner = self.element.get_or_insert_default();
                way.push(Step::Each);
                elements.iter().for_each(|element| inner.add(element, way, answer));
                way.pop();
            }
            Sample::Table(entries) => self.add_table(entries, way, answer),
        }
    }

    fn add_table(&mut self, entries: &BTreeMap<String, Sample>, way: &mut Vec<Step>, answer: &Answer) {
        if answer.refused_table() == Some(way) {
            return;
        }
        let whats = answer.at(way);
        if let Some(form) = answer.keys(way).and_then(|(name, keys)| self.form(name, keys)) {
            form.required.extend(whats.iter().filter_map(required));
            let written: BTreeSet<String> = entries.keys().cloned().collect();
            form.written = both(form.written.take(), Some(&written));
            // An error inside the table may hide another missing key.
            if answer.refusal.as_ref().is_none_or(|refusal| !refusal.way.starts_with(way)) {
                form.common = both(form.common.take(), Some(&written));
            }
            for (key, inner) in &mut form.keys {
                let Some(value) = entries.get(*key) else { continue };
                way.push(Step::Key((*key).to_owned()));
                inner.add(value, way, answer);
                let name = if let Sample::Plain(text) = value { text.trim_matches(['"', '\'']) } else { "" };
                if inner.names.contains(&name) {
                    form.chosen.entry(key).or_default().insert(name.to_owned());
                }
                way.pop();
            }
        } else if let Some(any) = &mut self.any_key {
            for (key, value) in entries {
                way.push(Step::Key(key.clone()));
                any.add(value, way, answer);
                way.pop();
            }
        }
    }

    /// Returns the table with this name and these keys, adding it if it is new.
    fn form(&mut self, name: &str, keys: &[&'static str]) -> Option<&mut Form> {
        let is_it =
            |form: &Form| form.name == name && form.keys.iter().map(|(key, _)| *key).eq(keys.iter().copied());
        if !self.forms.iter().any(is_it) {
            self.forms.push(Form {
                name: name.to_owned(),
                keys: keys.iter().map(|key| (*key, Self::default())).collect(),
                required: BTreeSet::new(),
                common: None,
                written: None,
                chosen: BTreeMap::new(),
            });
        }
        self.forms.iter_mut().find(|form| is_it(form))
    }

    /// Adds missing information from a place that accepts the same values.
    fn fill(&mut self, from: &Self) {
        if self.is_empty() {
            self.clone_from(from);
            return;
        }
        if let (Some(element), Some(other)) = (&mut self.element, &from.element) {
            element.fill(other);
        }
        for form in &mut self.forms {
            let Some(other) = from.forms.iter().find(|other| other.is_like(form)) else { continue };
            form.required.extend(&other.required);
            form.common = both(form.common.take(), other.common.as_ref());
            form.written = both(form.written.take(), other.written.as_ref());
            for ((_, inner), (_, other)) in form.keys.iter_mut().zip(&other.keys) {
                inner.fill(other);
            }
        }
    }

    /// Completes tables with several forms: a key not reached in one form is the same as in
    /// another.
    pub(super) fn complete(&mut self) {
        let known = self.forms.clone();
        for form in &mut self.forms {
            for (key, inner) in &mut form.keys {
                let others = known.iter().flat_map(|other| &other.keys);
                others.filter(|(other, _)| other == key).for_each(|(_, other)| inner.fill(other));
            }
        }
        self.element.iter_mut().for_each(|element| element.complete());
        self.any_key.iter_mut().for_each(|any| any.complete());
        self.forms.iter_mut().flat_map(|form| &mut form.keys).for_each(|(_, inner)| inner.complete());
    }

    /// Collects the places without information.
    #[cfg(test)]
    pub(super) fn unknown(&self, place: &str, found: &mut Vec<String>) {
        if self.is_empty() {
            found.push(place.to_owned());
        }
        self.element.iter().for_each(|element| element.unknown(&format!("{place}[]"), found));
        for form in &self.forms {
            for (key, inner) in &form.keys {
                inner.unknown(&format!("{place} <{}>.{key}", form.name), found);
            }
        }
    }
}

fn required(what: &What) -> Option<&'static str> {
    if let What::Required(key) = what { Some(key) } else { None }
}

/// Returns the intersection of two sets; an unknown set is ignored.
fn both(one: Option<BTreeSet<String>>, other: Option<&BTreeSet<String>>) -> Option<BTreeSet<String>> {
    match (one, other) {
        (Some(one), Some(other)) => Some(&one & other),
        (one, other) => one.or_else(|| other.cloned()),
    }
}

impl Form {
    fn is_like(&self, other: &Self) -> bool {
        self.name == other.name && self.keys.iter().zip(&other.keys).all(|((a, _), (b, _))| a == b)
    }

    /// True if the table must have the key.
    pub(super) fn requires(&self, key: &str) -> bool {
        let had = self.common.as_ref().or(self.written.as_ref());
        self.required.contains(key) && had.is_some_and(|had| had.contains(key))
    }
}
