//! Context of one MJCF model: settings, defaults and assets. An attached model has its own context.

use std::collections::HashMap;
use std::path::PathBuf;

use crate::model::Note;
use crate::read::uri::Roots;
use crate::read::xml::Element;

use super::compiler::Settings;
use super::defaults::Classes;
use super::mesh::Asset;

/// Settings, defaults and assets of a model.
pub(super) struct Context<'a> {
    pub(super) root: Element<'a>,
    pub(super) settings: Settings<'a>,
    pub(super) classes: Classes<'a>,
    pub(super) meshes: HashMap<String, Asset>,
    /// Half edges of the boxes of height fields, by name.
    pub(super) height_fields: HashMap<&'a str, [f64; 3]>,
    /// Models that it may attach, by name: indices of their contexts. Filled when all contexts are
    /// known.
    pub(super) models: HashMap<&'a str, usize>,
}

/// Returns the contexts of a root and of all models that may be attached.
pub(super) fn all<'a>(
    root: Element<'a>,
    folders: &[PathBuf],
    roots: &Roots<'_>,
    notes: &mut Vec<Note>,
) -> Vec<Context<'a>> {
    let mut contexts: Vec<Context<'a>> = Vec::new();
    let mut waiting = vec![root];
    let mut numbers = HashMap::from([(root.tree(), 0)]);
    while let Some(&root) = waiting.get(contexts.len()) {
        let mut context = Context::of(root, folders, roots, notes);
        for (name, model) in context.attachable() {
            let number = *numbers.entry(model.tree()).or_insert_with(|| {
                waiting.push(model);
                waiting.len() - 1
            });
            context.models.insert(name, number);
        }
        contexts.push(context);
    }
    contexts
}

impl<'a> Context<'a> {
    /// Reads the context of a model. Paths are relative to the folders of the files.
    pub(super) fn of(
        root: Element<'a>,
        folders: &[PathBuf],
        roots: &Roots<'_>,
        notes: &mut Vec<Note>,
    ) -> Self {
        super::attributes::unknown(root, notes);
        let settings = Settings::of(root, notes);
        let classes = Classes::of(root);
        let mut context = Self {
            root,
            settings,
            classes,
            meshes: HashMap::new(),
            height_fields: HashMap::new(),
            models: HashMap::new(),
        };
        let folder = folders.get(root.tree()).cloned().unwrap_or_default();
        for asset in root.named("asset").flat_map(Element::children) {
            match asset.name() {
                "mesh" => {
                    let source = context.classes.mesh(asset);
                    let (name, mesh) = Asset::of(asset, root, &source, &context.settings, &folder, roots);
                    context.meshes.insert(name, mesh);
                }
                "hfield" => {
                    let size = asset.attribute("size").and_then(|size| size.array());
                    if let (Some(name), Some([x, y, top, bottom])) = (asset.word("name"), size) {
                        context.height_fields.insert(name, [x, y, 0.25 * top + 0.5 * bottom]);
                    }
                }
                _ => {}
            }
        }
        context
    }

    /// Returns the models among the assets, by name.
    fn attachable(&self) -> Vec<(&'a str, Element<'a>)> {
        let assets = self.root.named("asset").flat_map(Element::children);
        let model = |asset: Element<'a>| {
            let model = asset.linked().filter(|_| asset.name() == "model")?;
            Some((asset.word("name").or(model.word("model"))?, model))
        };
        assets.filter_map(model).collect()
    }
}
