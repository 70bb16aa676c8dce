//! Parts of a mesh file that share vertices.

use polhode::body::mesh::TriangleMesh;
use polhode_source::{ContentError, ContentErrorKind};

use super::MeshPart;

/// Returns parts from names and triangles, each with the vertices that it uses, in file order.
///
/// # Errors
/// None, if all indices exist and all vertices are finite.
pub(crate) fn of_shared(
    vertices: Vec<[f64; 3]>,
    parts: Vec<(String, Vec<[u32; 3]>)>,
) -> Result<Vec<MeshPart>, ContentError> {
    let mut slots = vec![UNSEEN; vertices.len()];
    if let [(_, triangles)] = parts.as_slice()
        && mark(triangles, &mut slots).len() == vertices.len()
    {
        let mut parts = parts;
        let Some((name, triangles)) = parts.pop() else { return Ok(Vec::new()) };
        return Ok(vec![MeshPart { name, mesh: mesh(vertices, triangles)? }]);
    }
    slots.fill(UNSEEN);
    let compact = |(name, mut triangles): (String, Vec<[u32; 3]>)| {
        let mut used = mark(&triangles, &mut slots);
        used.sort_unstable();
        for (new, &old) in (0..).zip(&used) {
            slots[old as usize] = new;
        }
        triangles.iter_mut().flatten().for_each(|index| *index = slots[*index as usize]);
        used.iter().for_each(|&old| slots[old as usize] = UNSEEN);
        let vertices = used.iter().map(|&old| vertices[old as usize]).collect();
        Ok(MeshPart { name, mesh: mesh(vertices, triangles)? })
    };
    parts.into_iter().map(compact).collect()
}

/// Mark of an unused vertex. It is not an index, since a mesh has fewer vertices.
const UNSEEN: u32 = u32::MAX;

/// Returns the vertices that the triangles use, each once.
fn mark(triangles: &[[u32; 3]], slots: &mut [u32]) -> Vec<u32> {
    let mut used = Vec::new();
    for &index in triangles.as_flattened() {
        if let Some(slot) = slots.get_mut(index as usize)
            && *slot == UNSEEN
        {
            *slot = 0;
            used.push(index);
        }
    }
    used
}

fn mesh(vertices: Vec<[f64; 3]>, triangles: Vec<[u32; 3]>) -> Result<TriangleMesh, ContentError> {
    TriangleMesh::new(vertices, triangles).map_err(|error| {
        let (what, value) = ("the mesh", error.to_string());
        ContentErrorKind::value(what, value, "between finite vertices").of_whole()
    })
}

/// Converts a vertex index to the type of meshes; `None` if a file with `count` vertices does not
/// have it.
#[inline]
pub(crate) fn index(index: i64, count: usize) -> Option<u32> {
    let index = u32::try_from(index).ok()?;
    ((index as usize) < count && index != UNSEEN).then_some(index)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_part_has_the_vertices_that_it_uses_in_the_order_of_the_file() {
        let vertices: Vec<[f64; 3]> = (0..7).map(|k| [f64::from(k), 0.3, -1.7]).collect();
        let parts = vec![("a".to_owned(), vec![[5, 1, 3], [1, 5, 6]]), ("b".to_owned(), vec![[3, 2, 1]])];
        let parts = of_shared(vertices.clone(), parts).unwrap();
        let xs = |k: usize| parts[k].mesh.coordinates().iter().map(|v| v[0]).collect::<Vec<_>>();
        assert_eq!((xs(0), xs(1)), (vec![1.0, 3.0, 5.0, 6.0], vec![1.0, 2.0, 3.0]));
        assert_eq!(parts[0].mesh.triangles(), [[2, 0, 1], [0, 2, 3]]);
        assert_eq!(parts[1].mesh.triangles(), [[2, 1, 0]]);

        let all = of_shared(vertices.clone(), vec![(String::new(), vec![[6, 5, 4], [3, 2, 1], [0, 1, 2]])])
            .unwrap();
        assert_eq!(all[0].mesh.coordinates(), vertices);
        let few = of_shared(vertices, vec![(String::new(), vec![[6, 0, 4]])]).unwrap();
        assert_eq!(few[0].mesh.triangles(), [[2, 0, 1]]);
    }

    #[test]
    fn indices_exist() {
        assert_eq!([-1, 0, 6, 7, i64::MAX].map(|i| index(i, 7)), [None, Some(0), Some(6), None, None]);
    }
}
