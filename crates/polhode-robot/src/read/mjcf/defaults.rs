//! Default classes: an attribute that an element lacks is taken from its class, or from the
//! enclosing class.

use std::collections::HashMap;

use crate::read::xml::{Element, Written};

/// Defaults for one kind of element.
type Attributes<'a> = HashMap<&'a str, Written<'a>>;

/// Defaults of a class.
#[derive(Clone, Debug, Default)]
struct Class<'a> {
    geom: Attributes<'a>,
    joint: Attributes<'a>,
    mesh: Attributes<'a>,
    actuator: Attributes<'a>,
}

/// Element names of actuators, which share one default class.
const ACTUATORS: [&str; 10] = [
    "general",
    "motor",
    "position",
    "velocity",
    "intvelocity",
    "damper",
    "cylinder",
    "muscle",
    "adhesion",
    "dcmotor",
];

/// All classes by name, including their inherited attributes.
#[derive(Debug)]
pub(super) struct Classes<'a> {
    named: HashMap<&'a str, Class<'a>>,
}

/// Element with its class, from which attributes are taken.
#[derive(Clone, Debug)]
pub(super) struct Source<'s, 'a> {
    element: Element<'a>,
    class: Option<&'s Attributes<'a>>,
}

/// Class of elements without an explicit or inherited class.
const MAIN: &str = "main";

impl<'a> Classes<'a> {
    /// Reads the classes of all `<default>` elements of a file.
    pub(super) fn of(root: Element<'a>) -> Self {
        let mut named = HashMap::from([(MAIN, Class::default())]);
        let mut waiting: Vec<_> = root.named("default").map(|element| (element, MAIN, true)).collect();
        waiting.reverse();
        while let Some((element, around, is_outermost)) = waiting.pop() {
            let name = element.word("class").unwrap_or(around);
            let mut class =
                named.get(if name == around { name } else { around }).cloned().unwrap_or_default();
            for child in element.children() {
                let attributes = match child.name() {
                    "geom" => &mut class.geom,
                    "joint" => &mut class.joint,
                    "mesh" => &mut class.mesh,
                    name if ACTUATORS.contains(&name) => &mut class.actuator,
                    _ => continue,
                };
                for name in child.attribute_names() {
                    if let Some(written) = child.attribute(name) {
                        attributes.insert(name, written);
                    }
                }
            }
            if is_outermost {
                // The outermost class applies to everything, whatever its name.
                named.insert(MAIN, class.clone());
            }
            named.insert(name, class);
            waiting.extend(element.named("default").map(|inner| (inner, name, false)));
        }
        Self { named }
    }

    /// Returns a geom below elements whose `childclass` is `around`.
    pub(super) fn geom(&self, element: Element<'a>, around: Option<&str>) -> Source<'_, 'a> {
        Source { element, class: self.class(element, around).map(|class| &class.geom) }
    }

    /// Returns a joint below elements whose `childclass` is `around`.
    pub(super) fn joint(&self, element: Element<'a>, around: Option<&str>) -> Source<'_, 'a> {
        Source { element, class: self.class(element, around).map(|class| &class.joint) }
    }

    /// Returns a mesh asset.
    pub(super) fn mesh(&self, element: Element<'a>) -> Source<'_, 'a> {
        Source { element, class: self.class(element, None).map(|class| &class.mesh) }
    }

    /// Returns an actuator of any kind.
    pub(super) fn actuator(&self, element: Element<'a>) -> Source<'_, 'a> {
        Source { element, class: self.class(element, None).map(|class| &class.actuator) }
    }

    /// Returns the class that an element or its `childclass` names, if no such class exists.
    pub(super) fn unknown(&self, element: Element<'a>) -> Option<Written<'a>> {
        let named = ["class", "childclass"].into_iter().filter_map(|name| element.attribute(name));
        named.into_iter().find(|written| !self.named.contains_key(written.value))
    }

    fn class(&self, element: Element<'a>, around: Option<&str>) -> Option<&Class<'a>> {
        self.named.get(element.word("class").or(around).unwrap_or(MAIN))
    }
}

impl<'a> Source<'_, 'a> {
    /// Returns the element without a class.
    pub(super) fn of(element: Element<'a>) -> Self {
        Self { element, class: None }
    }

    /// Returns the text of an attribute, from the element or the class.
    pub(super) fn written(&self, name: &str) -> Option<Written<'a>> {
        self.element.attribute(name).or_else(|| self.class?.get(name).cloned())
    }

    /// Returns the numbers of an attribute. Numbers that the element does not give are taken from
    /// the class.
    pub(super) fn values(&self, name: &str) -> Vec<f64> {
        let class =
            self.class.and_then(|class| class.get(name)).map_or_else(Vec::new, |all| all.values().collect());
        let own = self.element.attribute(name).map_or_else(Vec::new, |all| all.values().collect());
        let rest = class.get(own.len()..).unwrap_or(&[]);
        own.iter().chain(rest).copied().collect()
    }

    /// Returns the number of an attribute; NaN if it cannot be read.
    pub(super) fn number(&self, name: &str) -> Option<f64> {
        self.written(name).map(|written| written.number().value.unwrap_or(f64::NAN))
    }

    /// Returns the word of an attribute.
    pub(super) fn word(&self, name: &str) -> Option<&'a str> {
        self.written(name).map(|written| written.value)
    }
}
