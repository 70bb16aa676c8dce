//! Nodes: the forest, and the transformation of each node.

use polhode::body::Severity;
use polhode_source::package::unfolding::Budget;
use polhode_source::{ContentError, ContentErrorKind};

use super::accessor;
use super::buffer::Buffers;
use super::json::Json;
use crate::mesh::affine::Affine;
use crate::mesh::notes::Notes;

/// Nodes of a document. Each has at most one parent, and none is its own ancestor.
pub(crate) struct Forest<'a> {
    pub nodes: Vec<Node<'a>>,
}

/// Node with the indices of its children.
pub(crate) struct Node<'a> {
    pub json: Json<'a>,
    pub children: Vec<usize>,
    parent: Option<usize>,
}

impl<'a> Forest<'a> {
    pub(crate) fn of(root: &Json<'a>) -> Result<Self, ContentError> {
        let nodes = root.list("nodes")?.map(|json| Node { json, children: Vec::new(), parent: None });
        let mut nodes: Vec<_> = nodes.collect();
        for k in 0..nodes.len() {
            for child in nodes[k].json.clone().list("children")? {
                let (index, _) = child.referred(root, "nodes", "node")?;
                if let Some(other) = nodes[index].parent.replace(k) {
                    let rule = format!("the child of only one node: it is also a child of nodes[{other}]");
                    return Err(child.refused("the child", &rule));
                }
                nodes[k].children.push(index);
            }
        }
        let forest = Self { nodes };
        forest.require_roots()?;
        Ok(forest)
    }

    /// Checks for cycles. Since each node has one parent, a node that no root reaches is in a
    /// cycle.
    fn require_roots(&self) -> Result<(), ContentError> {
        let mut reached = vec![false; self.nodes.len()];
        let mut stack = self.roots();
        while let Some(k) = stack.pop() {
            reached[k] = true;
            stack.extend(&self.nodes[k].children);
        }
        match reached.iter().position(|reached| !reached) {
            None => Ok(()),
            Some(k) => {
                let (what, value) = ("the node", k.to_string());
                let rule = "part of a tree: it is its own ancestor, or below such a node";
                Err(self.nodes[k].json.error(ContentErrorKind::value(what, value, rule)))
            }
        }
    }

    fn roots(&self) -> Vec<usize> {
        (0..self.nodes.len()).filter(|&k| self.nodes[k].parent.is_none()).collect()
    }

    /// Returns the name and the roots of the scene to read: the default scene, otherwise the first
    /// one, otherwise all nodes.
    pub(crate) fn scene(&self, root: &Json<'a>) -> Result<(String, Vec<usize>), ContentError> {
        let scene = match root.get("scene") {
            Some(index) => Some(index.referred(root, "scenes", "scene")?.1),
            None => root.list("scenes")?.next(),
        };
        let Some(scene) = scene else { return Ok((String::new(), self.roots())) };
        let mut taken = vec![false; self.nodes.len()];
        let mut roots = Vec::new();
        for node in scene.list("nodes")? {
            let (index, _) = node.referred(root, "nodes", "node")?;
            if self.nodes[index].parent.is_some() || std::mem::replace(&mut taken[index], true) {
                return Err(node.refused("the node", "a root, and named once"));
            }
            roots.push(index);
        }
        Ok((scene.text_or_empty("name")?.to_owned(), roots))
    }
}

/// Returns the transformation of a node relative to its parent.
pub(crate) fn transform(node: &Json<'_>, notes: &mut Notes) -> Result<Affine, ContentError> {
    let parts = [node.get("translation"), node.get("rotation"), node.get("scale")];
    let Some(matrix) = node.get("matrix") else {
        let [translation, rotation, scale] = parts;
        let translation = translation.map_or(Ok([0.0; 3]), |json| json.numbers())?;
        let scale = scale.map_or(Ok([1.0; 3]), |json| json.numbers())?;
        let rotation = rotation.map_or(Ok([0.0, 0.0, 0.0, 1.0]), |json| {
            let rotation = json.numbers()?;
            unit(rotation, || json.place().to_owned(), Some(notes))
                .ok_or_else(|| json.refused("rotation", "a quaternion of length 1"))
        })?;
        return Ok(Affine::of_parts(translation, rotation, scale));
    };
    if let Some(part) = parts.iter().flatten().next() {
        return Err(part.refused("this", "absent if there is a matrix"));
    }
    // Sixteen numbers, column by column; the last row is (0, 0, 0, 1).
    let m: [f64; 16] = matrix.numbers()?;
    if [m[3], m[7], m[11], m[15]] != [0.0, 0.0, 0.0, 1.0] {
        return Err(matrix.refused("matrix", "affine: 0, 0, 0 and 1 at the ends of its columns"));
    }
    Ok(Affine {
        columns: [[m[0], m[1], m[2]], [m[4], m[5], m[6]], [m[8], m[9], m[10]]],
        origin: [m[12], m[13], m[14]],
    })
}

/// Returns the placements of a node's mesh: its own, or those of `EXT_mesh_gpu_instancing` in its
/// frame.
pub(crate) fn instances<'a>(
    node: &Json<'a>,
    map: Affine,
    root: &Json<'a>,
    buffers: &mut Buffers<'a>,
    budget: &mut Budget,
) -> Result<Vec<Affine>, ContentError> {
    let Some(instancing) = node.get("extensions").and_then(|e| e.get("EXT_mesh_gpu_instancing")) else {
        return Ok(vec![map]);
    };
    let attributes = instancing.need("attributes")?;
    let [translations, scales] = ["TRANSLATION", "SCALE"].map(|name| {
        attributes.get(name).map(|index| {
            accessor::vectors::<3>(&index.referred(root, "accessors", "accessor")?.1, buffers, budget)
        })
    });
    let (translations, scales) = (translations.transpose()?, scales.transpose()?);
    let rotations = attributes.get("ROTATION").map(|index| {
        accessor::vectors::<4>(&index.referred(root, "accessors", "accessor")?.1, buffers, budget)
    });
    let rotations = rotations.transpose()?;
    let counts = [
        translations.as_ref().map(Vec::len),
        scales.as_ref().map(Vec::len),
        rotations.as_ref().map(Vec::len),
    ];
    let count = counts.into_iter().flatten().max().unwrap_or(0);
    if let Some(fewer) = counts.into_iter().flatten().find(|&other| other != count) {
        let (declared, present) = (count as u64, fewer as u64);
        return Err(attributes.error(ContentErrorKind::count("instances", declared, present)));
    }
    budget.spend(count, size_of::<Affine>(), || instancing.place().to_owned())?;
    let instance = |k: usize| {
        let translation = translations.as_ref().map_or([0.0; 3], |all| all[k]);
        let scale = scales.as_ref().map_or([1.0; 3], |all| all[k]);
        let rotation = rotations.as_ref().map_or([0.0, 0.0, 0.0, 1.0], |all| all[k]);
        let rotation = unit(rotation, String::new, None).ok_or_else(|| {
            let (what, value) = (format!("the rotation of instance {k}"), format!("{rotation:?}"));
            attributes.error(ContentErrorKind::value(what, value, "a quaternion of length 1"))
        })?;
        Ok(map.after(&Affine::of_parts(translation, rotation, scale)))
    };
    (0..count).map(instance).collect()
}

/// Normalizes a quaternion that the file has rounded. Returns `None` if it is far from unit length.
fn unit(q: [f64; 4], place: impl FnOnce() -> String, notes: Option<&mut Notes>) -> Option<[f64; 4]> {
    const SENTENCE: [&str; 2] = [
        "a rotation was not of unit length and was normalized",
        "rotations were not of unit length and were normalized",
    ];
    let square: f64 = q.iter().map(|x| x * x).sum();
    let off = (square - 1.0).abs();
    if !(off < 0.1) {
        return None;
    }
    // Rounding to single precision leaves an error of 1e-7.
    if let Some(notes) = notes.filter(|_| off > 1e-5) {
        notes.add("mesh.rotation_normalised", Severity::Info, SENTENCE, place);
    }
    let norm = square.sqrt();
    Some(if norm == 1.0 { q } else { q.map(|x| x / norm) })
}
