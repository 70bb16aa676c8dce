//! Meshes of Gmsh as MuJoCo reads them: versions 4.1 and 2.2, as text or in binary, one block of nodes and one of elements.
//!
//! Source: gmsh.info, the MSH file format; MuJoCo 3.12, `mjCFlexcomp::LoadGMSH`.

use std::str::FromStr;

use super::Lattice;

/// The points and elements of a file.
pub(super) fn read(bytes: &[u8]) -> Result<Lattice, String> {
    let start = section(bytes, b"$MeshFormat", b"$EndMeshFormat").unwrap_or_default();
    let mut head = Words { rest: bytes.get(start.0..start.1).unwrap_or_default() };
    let (version, binary) = (head.word::<f64>()?, head.word::<i64>()?);
    if !bytes.starts_with(b"$MeshFormat") {
        return Err("it does not begin with $MeshFormat".to_owned());
    }
    let part = |first: &[u8], last: &[u8]| {
        let (start, end) = section(bytes, first, last)?;
        bytes.get(start..end)
    };
    let nodes = part(b"$Nodes", b"$EndNodes").ok_or("it has no $Nodes")?;
    let elements = part(b"$Elements", b"$EndElements").ok_or("it has no $Elements")?;
    match ((100.0 * version).round() as i64, binary) {
        (410, 0) => blocks(&mut Words { rest: nodes }, &mut Words { rest: elements }),
        (410, _) => blocks(&mut Bytes { rest: nodes }, &mut Bytes { rest: elements }),
        (220, 0) => lists(nodes, elements),
        (220, _) => binary_lists(nodes, elements),
        _ => Err(format!("Gmsh's format {version} is not 4.1 or 2.2")),
    }
}

/// Where the text between two marks starts and ends; one byte after the first is the end of its line.
fn section(bytes: &[u8], first: &[u8], last: &[u8]) -> Option<(usize, usize)> {
    let find = |mark: &[u8]| bytes.windows(mark.len()).position(|window| window == mark);
    let (start, end) = (find(first)? + first.len() + 1, find(last)?);
    (start <= end).then_some((start, end))
}

/// Numbers in the order in which a file has them.
trait Numbers {
    fn size(&mut self) -> Result<usize, String>;
    fn small(&mut self) -> Result<usize, String>;
    fn real(&mut self) -> Result<f64, String>;
}

/// As text.
struct Words<'t> {
    rest: &'t [u8],
}

/// In binary, the least byte first.
struct Bytes<'t> {
    rest: &'t [u8],
}

const SHORT: &str = "it ends before its numbers do";

impl Words<'_> {
    fn word<T: FromStr>(&mut self) -> Result<T, String> {
        let rest = self.rest.trim_ascii_start();
        let end = rest.iter().position(u8::is_ascii_whitespace).unwrap_or(rest.len());
        let (word, rest) = rest.split_at_checked(end).ok_or(SHORT)?;
        self.rest = rest;
        let word = str::from_utf8(word).map_err(|error| error.to_string())?;
        if word.is_empty() {
            return Err(SHORT.to_owned());
        }
        word.parse().map_err(|_| format!("{word:?} is no number that belongs there"))
    }
}

impl Numbers for Words<'_> {
    fn size(&mut self) -> Result<usize, String> {
        self.word()
    }

    fn small(&mut self) -> Result<usize, String> {
        self.word()
    }

    fn real(&mut self) -> Result<f64, String> {
        self.word()
    }
}

impl Bytes<'_> {
    fn take<const N: usize>(&mut self) -> Result<[u8; N], String> {
        let (first, rest) = self.rest.split_first_chunk::<N>().ok_or(SHORT)?;
        self.rest = rest;
        Ok(*first)
    }
}

impl Numbers for Bytes<'_> {
    fn size(&mut self) -> Result<usize, String> {
        usize::try_from(u64::from_le_bytes(self.take()?)).map_err(|error| error.to_string())
    }

    fn small(&mut self) -> Result<usize, String> {
        usize::try_from(i32::from_le_bytes(self.take()?)).map_err(|error| error.to_string())
    }

    fn real(&mut self) -> Result<f64, String> {
        Ok(f64::from_le_bytes(self.take()?))
    }
}

/// The first line of a section and the numbers after it.
fn head(numbers: &mut impl Numbers, what: &str) -> Result<[usize; 4], String> {
    let (blocks, count, first, _) = (numbers.size()?, numbers.size()?, numbers.size()?, numbers.size()?);
    let (dim, _, kind) = (numbers.small()?, numbers.small()?, numbers.small()?);
    let in_block = numbers.size()?;
    if blocks != 1 || in_block != count {
        return Err(format!("its {what} are not in one block, and MuJoCo refuses the file"));
    }
    Ok([count, first, dim, kind])
}

/// Version 4.1.
fn blocks(nodes: &mut impl Numbers, elements: &mut impl Numbers) -> Result<Lattice, String> {
    let [count, first, dim, _] = head(nodes, "nodes")?;
    if !(1..=3).contains(&dim) {
        return Err("its nodes have no dimension, and MuJoCo refuses the file".to_owned());
    }
    for number in 0..count {
        if Some(nodes.size()?) != first.checked_add(number) {
            return Err("its nodes are not in order, and MuJoCo refuses the file".to_owned());
        }
    }
    let mut points = Vec::new();
    for _ in 0..count {
        points.push([nodes.real()?, nodes.real()?, nodes.real()?]);
    }
    let [count, _, own, kind] = head(elements, "elements")?;
    if own != dim || kind != [1, 2, 4][dim - 1] {
        return Err("its elements are not of its dimension, and MuJoCo refuses the file".to_owned());
    }
    let mut all = Vec::new();
    for _ in 0..count {
        elements.size()?;
        for _ in 0..=dim {
            let node = elements.size()?.checked_sub(first);
            all.push(node.ok_or("an element of it has a node that is not there")?);
        }
    }
    Ok(Lattice { dim, points, elements: Some(all) })
}

/// The dimension of the elements of version 2.2: triangles or tetrahedra.
fn dimension(kind: usize) -> Result<usize, String> {
    match kind {
        2 => Ok(2),
        4 => Ok(3),
        _ => Err("its elements are no triangles or tetrahedra, and MuJoCo refuses the file".to_owned()),
    }
}

/// A number of version 2.2, which counts from 1.
fn below(node: usize) -> Result<usize, String> {
    node.checked_sub(1).ok_or_else(|| "an element of it has a node that is not there".to_owned())
}

/// Version 2.2 as text.
fn lists(nodes: &[u8], elements: &[u8]) -> Result<Lattice, String> {
    let (mut nodes, mut elements) = (Words { rest: nodes }, Words { rest: elements });
    let mut points = Vec::new();
    for _ in 0..nodes.size()? {
        nodes.size()?;
        points.push([nodes.real()?, nodes.real()?, nodes.real()?]);
    }
    let mut all = Vec::new();
    let mut dim = None;
    for _ in 0..elements.size()? {
        let (_, kind, tags) = (elements.size()?, elements.size()?, elements.size()?);
        let own = dimension(kind)?;
        if *dim.get_or_insert(own) != own || !matches!(tags, 0 | 2) {
            return Err("its elements are of several kinds, or have not two tags each".to_owned());
        }
        for _ in 0..tags {
            elements.size()?;
        }
        for _ in 0..=own {
            all.push(below(elements.size()?)?);
        }
    }
    Ok(Lattice { dim: dim.ok_or("it has no elements")?, points, elements: Some(all) })
}

/// Version 2.2 in binary, with the counts as text. Elements have a head each (Gmsh), or one for all (fTetWild).
fn binary_lists(nodes: &[u8], elements: &[u8]) -> Result<Lattice, String> {
    let counted = |bytes: &'_ [u8]| {
        let end = bytes.iter().position(|byte| *byte == b'\n').ok_or(SHORT)?;
        let count: usize = Words { rest: bytes.get(..end).unwrap_or_default() }.word()?;
        Ok::<_, String>((count, end + 1))
    };
    let (count, start) = counted(nodes)?;
    let mut nodes = Bytes { rest: nodes.get(start..).unwrap_or_default() };
    let mut points = Vec::new();
    for _ in 0..count {
        nodes.small()?;
        points.push([nodes.real()?, nodes.real()?, nodes.real()?]);
    }
    let (count, start) = counted(elements)?;
    let mut elements = Bytes { rest: elements.get(start..).unwrap_or_default() };
    let mut all = Vec::new();
    let (mut kind, mut in_block, mut tags) = (elements.small()?, elements.small()?, elements.small()?);
    let dim = dimension(kind)?;
    for number in 0..count {
        if in_block == 0 && number > 0 {
            (kind, in_block, tags) = (elements.small()?, elements.small()?, elements.small()?);
        }
        if dimension(kind)? != dim || !matches!((tags, dim), (2, _) | (0, 3)) {
            return Err("its elements are of several kinds, or have not two tags each".to_owned());
        }
        in_block = in_block.saturating_sub(1);
        for _ in 0..=tags {
            elements.small()?;
        }
        for _ in 0..=dim {
            all.push(below(elements.small()?)?);
        }
    }
    Ok(Lattice { dim, points, elements: Some(all) })
}
