//! Model file of a 3MF package: its objects and its build items.

use std::borrow::Cow;
use std::collections::HashMap;
use std::rc::Rc;

use polhode::body::Severity;
use polhode_source::package::xml::{Token, Xml};
use polhode_source::{ContentError, ContentErrorKind};
use quick_xml::events::BytesStart;
use quick_xml::events::attributes::Attribute;

use crate::mesh::affine::Affine;
use crate::mesh::notes::Notes;

const CORE: &str = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02";
const PRODUCTION: &str = "http://schemas.microsoft.com/3dmanufacturing/production/2015/06";
/// Extensions that do not affect the shape.
const LOOKS: [&str; 2] = [
    "http://schemas.microsoft.com/3dmanufacturing/material/2015/02",
    "http://schemas.microsoft.com/3dmanufacturing/trianglesets/2021/07",
];

/// Contents of a model file.
#[derive(Debug)]
pub(crate) struct Model {
    /// Unit of length: its name, and its value in metres.
    pub unit: (&'static str, f64),
    pub title: String,
    pub objects: HashMap<u32, Object>,
    pub items: Vec<Use>,
}

#[derive(Debug)]
pub(crate) struct Object {
    /// Name of the object, otherwise its part number.
    pub name: String,
    /// Type: `model`, `support`, `other` or another.
    pub kind: String,
    pub contents: Contents,
    pub line: usize,
}

#[derive(Debug)]
pub(crate) enum Contents {
    Nothing,
    Mesh { vertices: Vec<[f64; 3]>, triangles: Vec<[u32; 3]> },
    Components(Rc<[Use]>),
}

/// Placed object: a build item, or a component of another object.
#[derive(Clone, Debug)]
pub(crate) struct Use {
    /// Model file of the object, if it is in a different one.
    pub path: Option<String>,
    pub object: u32,
    pub transform: Affine,
    pub part_number: String,
    pub line: usize,
}

impl Model {
    /// Reads a model file to its end.
    pub(crate) fn read(mut xml: Xml<'_, '_>, notes: &mut Notes) -> Result<Self, ContentError> {
        let mut buffer = Vec::new();
        let mut model = None;
        loop {
            match xml.next(&mut buffer)? {
                Token::Start(element) => {
                    let is_model = is_core(&xml, &element, "model");
                    if !is_model || model.is_some() {
                        let (what, found) = ("one model element of 3MF", element.name().0.to_owned());
                        return Err(xml.error(ContentErrorKind::expected(what, found)));
                    }
                    model = Some(Self::element(&mut xml, &element, notes)?);
                }
                Token::Eof => return model.ok_or_else(|| xml.missing("model element")),
                Token::Text(_) | Token::End | Token::Other => {}
            }
        }
    }

    fn element(
        xml: &mut Xml<'_, '_>,
        element: &BytesStart<'_>,
        notes: &mut Notes,
    ) -> Result<Self, ContentError> {
        let (mut unit, mut required) = (None, None);
        for attribute in xml.attributes(element) {
            let attribute = attribute?;
            match attribute.key.0 {
                "unit" => once(xml, &mut unit, &attribute)?,
                "requiredextensions" => once(xml, &mut required, &attribute)?,
                _ => {}
            }
        }
        let unit = metres(xml, unit.as_deref().unwrap_or("millimeter"))?;
        for prefix in required.as_deref().unwrap_or_default().split_ascii_whitespace() {
            let namespace = xml.prefixed(prefix);
            if namespace != PRODUCTION && namespace != CORE && !LOOKS.contains(&namespace) {
                let what = format!("models that need the extension {prefix} ({namespace})");
                let error = xml.error(ContentErrorKind::unsupported(what));
                return Err(error.hint("export the model as plain triangle meshes"));
            }
        }
        let mut model = Self { unit, title: String::new(), objects: HashMap::new(), items: Vec::new() };
        let mut buffer = Vec::new();
        loop {
            match xml.next(&mut buffer)? {
                Token::Start(child) => match core_name(xml, &child) {
                    "metadata" => model.metadata(xml, &child)?,
                    "resources" => model.resources(xml, notes)?,
                    "build" => uses(xml, "item", &mut model.items)?,
                    _ => xml.skip()?,
                },
                Token::End => return Ok(model),
                Token::Text(_) | Token::Other | Token::Eof => {}
            }
        }
    }

    /// Reads the title of the file.
    fn metadata(&mut self, xml: &mut Xml<'_, '_>, element: &BytesStart<'_>) -> Result<(), ContentError> {
        let mut name = None;
        for attribute in xml.attributes(element) {
            let attribute = attribute?;
            if attribute.key.0 == "name" {
                once(xml, &mut name, &attribute)?;
            }
        }
        if name.as_deref() != Some("Title") {
            return xml.skip();
        }
        let mut buffer = Vec::new();
        loop {
            match xml.next(&mut buffer)? {
                Token::Text(text) => self.title.push_str(&text),
                Token::Start(_) => xml.skip()?,
                Token::End => return Ok(()),
                Token::Other | Token::Eof => {}
            }
        }
    }

    fn resources(&mut self, xml: &mut Xml<'_, '_>, notes: &mut Notes) -> Result<(), ContentError> {
        let mut buffer = Vec::new();
        loop {
            match xml.next(&mut buffer)? {
                Token::Start(child) if is_core(xml, &child, "object") => {
                    let (id, object) = Object::read(xml, &child, notes)?;
                    if let Some(other) = self.objects.get(&id) {
                        let rule = format!("unique: the object on line {} has the same id", other.line);
                        return Err(xml.refused("id", &id.to_string(), &rule));
                    }
                    self.objects.insert(id, object);
                }
                Token::Start(_) => xml.skip()?,
                Token::End => return Ok(()),
                Token::Text(_) | Token::Other | Token::Eof => {}
            }
        }
    }
}

impl Object {
    fn read(
        xml: &mut Xml<'_, '_>,
        element: &BytesStart<'_>,
        notes: &mut Notes,
    ) -> Result<(u32, Self), ContentError> {
        let (mut id, mut name, mut number, mut kind) = (None, None, None, None);
        for attribute in xml.attributes(element) {
            let attribute = attribute?;
            match attribute.key.0 {
                "id" => once(xml, &mut id, &attribute)?,
                "name" => once(xml, &mut name, &attribute)?,
                "partnumber" => once(xml, &mut number, &attribute)?,
                "type" => once(xml, &mut kind, &attribute)?,
                _ => {}
            }
        }
        let line = xml.line();
        let id = whole(xml, "id", &id.ok_or_else(|| xml.missing("id of the object"))?)?;
        let name = name.filter(|name| !name.is_empty()).or(number).unwrap_or_default();
        let kind = kind.unwrap_or_else(|| "model".to_owned());
        let mut object = Self { name, kind, contents: Contents::Nothing, line };
        let mut buffer = Vec::new();
        loop {
            match xml.next(&mut buffer)? {
                Token::Start(child) => {
                    let what = core_name(xml, &child);
                    let is_shape = matches!(what, "mesh" | "components");
                    if is_shape && !matches!(object.contents, Contents::Nothing) {
                        return Err(xml.refused("the object", what, "one mesh, or one list of components"));
                    }
                    match what {
                        "mesh" => object.contents = mesh(xml, notes)?,
                        "components" => {
                            let mut components = Vec::new();
                            uses(xml, "component", &mut components)?;
                            object.contents = Contents::Components(components.into());
                        }
                        _ => unread(xml, &child, notes)?,
                    }
                }
                Token::End => return Ok((id, object)),
                Token::Text(_) | Token::Other | Token::Eof => {}
            }
        }
    }
}

fn mesh(xml: &mut Xml<'_, '_>, notes: &mut Notes) -> Result<Contents, ContentError> {
    let (mut vertices, mut triangles) = (Vec::new(), Vec::new());
    let mut buffer = Vec::new();
    loop {
        match xml.next(&mut buffer)? {
            Token::Start(child) => match core_name(xml, &child) {
                "vertices" => each(xml, "vertex", |xml, element| {
                    vertices.push(vertex(xml, element)?);
                    Ok(())
                })?,
                "triangles" => each(xml, "triangle", |xml, element| {
                    triangles.push(triangle(xml, element, vertices.len())?);
                    Ok(())
                })?,
                _ => unread(xml, &child, notes)?,
            },
            Token::End => return Ok(Contents::Mesh { vertices, triangles }),
            Token::Text(_) | Token::Other | Token::Eof => {}
        }
    }
}

/// Reads the children with one name, up to the end of their parent.
fn each(
    xml: &mut Xml<'_, '_>,
    name: &str,
    mut read: impl FnMut(&Xml<'_, '_>, &BytesStart<'_>) -> Result<(), ContentError>,
) -> Result<(), ContentError> {
    let mut buffer = Vec::new();
    loop {
        match xml.next(&mut buffer)? {
            Token::Start(child) => {
                if is_core(xml, &child, name) {
                    read(xml, &child)?;
                }
                xml.skip()?;
            }
            Token::End => return Ok(()),
            Token::Text(_) | Token::Other | Token::Eof => {}
        }
    }
}

fn vertex(xml: &Xml<'_, '_>, element: &BytesStart<'_>) -> Result<[f64; 3], ContentError> {
    let mut vertex = [None; 3];
    for attribute in xml.attributes(element) {
        let attribute = attribute?;
        let k = match attribute.key.0 {
            "x" => 0,
            "y" => 1,
            "z" => 2,
            _ => continue,
        };
        let value = number(xml, attribute.key.0, &xml.value(&attribute)?)?;
        if vertex[k].replace(value).is_some() {
            return Err(xml.refused("the vertex", attribute.key.0, "given once"));
        }
    }
    match vertex {
        [Some(x), Some(y), Some(z)] => Ok([x, y, z]),
        _ => Err(xml.missing("x, y or z of the vertex")),
    }
}

fn triangle(xml: &Xml<'_, '_>, element: &BytesStart<'_>, vertices: usize) -> Result<[u32; 3], ContentError> {
    let mut triangle = [None; 3];
    for attribute in xml.attributes(element) {
        let attribute = attribute?;
        let k = match attribute.key.0 {
            "v1" => 0,
            "v2" => 1,
            "v3" => 2,
            _ => continue,
        };
        let index = whole(xml, attribute.key.0, &xml.value(&attribute)?)?;
        if index as usize >= vertices {
            let (what, index) = ("vertex", i64::from(index));
            return Err(xml.error(ContentErrorKind::index(what, index, vertices)));
        }
        if triangle[k].replace(index).is_some() {
            return Err(xml.refused("the triangle", attribute.key.0, "given once"));
        }
    }
    match triangle {
        [Some(a), Some(b), Some(c)] => Ok([a, b, c]),
        _ => Err(xml.missing("v1, v2 or v3 of the triangle")),
    }
}

/// Reads build items or components.
fn uses(xml: &mut Xml<'_, '_>, name: &str, list: &mut Vec<Use>) -> Result<(), ContentError> {
    each(xml, name, |xml, element| {
        let (mut object, mut path, mut transform, mut number) = (None, None, None, None);
        for attribute in xml.attributes(element) {
            let attribute = attribute?;
            match attribute.key.0 {
                "objectid" => once(xml, &mut object, &attribute)?,
                "transform" => once(xml, &mut transform, &attribute)?,
                "partnumber" => once(xml, &mut number, &attribute)?,
                _ if attribute.key.local_name().into_inner() == "path"
                    && xml.namespace_of(&attribute) == PRODUCTION =>
                {
                    once(xml, &mut path, &attribute)?;
                }
                _ => {}
            }
        }
        let object = whole(xml, "objectid", &object.ok_or_else(|| xml.missing("objectid"))?)?;
        let transform = transform.map_or(Ok(Affine::IDENTITY), |text| affine(xml, &text))?;
        list.push(Use { path, object, transform, part_number: number.unwrap_or_default(), line: xml.line() });
        Ok(())
    })
}

/// Parses twelve numbers, row by row, which act on row vectors: (x' y' z') = (x y z 1) M.
fn affine(xml: &Xml<'_, '_>, text: &str) -> Result<Affine, ContentError> {
    let mut m = [[0.0; 3]; 4];
    let mut words = text.split_ascii_whitespace();
    for slot in m.as_flattened_mut() {
        let word = words.next().ok_or_else(|| xml.refused("transform", text, "twelve numbers"))?;
        *slot = number(xml, "transform", word)?;
    }
    if words.next().is_some() {
        return Err(xml.refused("transform", text, "twelve numbers"));
    }
    let [a, b, c, origin] = m;
    Ok(Affine { columns: [a, b, c], origin })
}

/// Skips an unsupported element. An element of an extension may change the shape, so it is a
/// finding.
fn unread(xml: &mut Xml<'_, '_>, element: &BytesStart<'_>, notes: &mut Notes) -> Result<(), ContentError> {
    const SENTENCE: [&str; 2] = [
        "an element of an unsupported extension was ignored; it may change the shape",
        "elements of unsupported extensions were ignored; they may change the shape",
    ];
    let namespace = xml.namespace(element);
    if namespace != CORE && namespace != PRODUCTION && !LOOKS.contains(&namespace) {
        let place = || format!("{}: {}", xml.place(), element.name().0);
        notes.add("mesh.extension_ignored", Severity::Warning, SENTENCE, place);
    }
    xml.skip()
}

fn is_core(xml: &Xml<'_, '_>, element: &BytesStart<'_>, name: &str) -> bool {
    core_name(xml, element) == name
}

/// Returns the name of an element of the 3MF core; empty for other elements.
fn core_name<'e>(xml: &Xml<'_, '_>, element: &'e BytesStart<'_>) -> &'e str {
    if xml.namespace(element) == CORE { element.local_name().into_inner() } else { "" }
}

/// Stores the text of an attribute; an error if it is repeated.
fn once(xml: &Xml<'_, '_>, slot: &mut Option<String>, attribute: &Attribute<'_>) -> Result<(), ContentError> {
    let value: Cow<'_, str> = xml.value(attribute)?;
    match slot.replace(value.into_owned()) {
        None => Ok(()),
        Some(_) => Err(xml.refused("the attribute", attribute.key.0, "given once")),
    }
}

fn number(xml: &Xml<'_, '_>, what: &str, text: &str) -> Result<f64, ContentError> {
    match text.trim_ascii().parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(value),
        Ok(_) => Err(xml.error(ContentErrorKind::not_finite(what, text))),
        Err(_) => Err(xml.refused(what, &format!("{text:?}"), "a number")),
    }
}

fn whole(xml: &Xml<'_, '_>, what: &str, text: &str) -> Result<u32, ContentError> {
    let value = text.trim_ascii().parse();
    value.map_err(|_| xml.refused(what, &format!("{text:?}"), "a whole number from 0, below 2³²"))
}

/// Returns a 3MF unit of length by name.
fn metres(xml: &Xml<'_, '_>, name: &str) -> Result<(&'static str, f64), ContentError> {
    const UNITS: [(&str, f64); 6] = [
        ("micron", 1e-6),
        ("millimeter", 1e-3),
        ("centimeter", 1e-2),
        ("inch", 0.0254),
        ("foot", 0.3048),
        ("meter", 1.0),
    ];
    let unit = UNITS.iter().find(|(known, _)| *known == name).copied();
    unit.ok_or_else(|| xml.refused("unit", name, "micron, millimeter, centimeter, inch, foot or meter"))
}
