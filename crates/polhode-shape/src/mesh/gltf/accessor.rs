//! Accessors: typed data in buffer views.

use polhode_source::package::unfolding::Budget;
use polhode_source::{ContentError, ContentErrorKind, ContentPlace};

use super::buffer::{Buffers, View};
use super::json::Json;

/// Type of a component.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Component {
    I8,
    U8,
    I16,
    U16,
    U32,
    F32,
}

impl Component {
    fn of(json: &Json<'_>) -> Result<Self, ContentError> {
        Ok(match json.whole()? {
            5120 => Self::I8,
            5121 => Self::U8,
            5122 => Self::I16,
            5123 => Self::U16,
            5125 => Self::U32,
            5126 => Self::F32,
            _ => return Err(json.refused("componentType", "5120, 5121, 5122, 5123, 5125 or 5126")),
        })
    }

    fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::U32 | Self::F32 => 4,
        }
    }

    /// Decodes a number from the bytes of one component.
    fn value(self, bytes: &[u8]) -> f64 {
        match (self, bytes) {
            (Self::I8, &[a]) => f64::from(a as i8),
            (Self::U8, &[a]) => f64::from(a),
            (Self::I16, &[a, b]) => f64::from(i16::from_le_bytes([a, b])),
            (Self::U16, &[a, b]) => f64::from(u16::from_le_bytes([a, b])),
            (Self::U32, &[a, b, c, d]) => f64::from(u32::from_le_bytes([a, b, c, d])),
            (Self::F32, &[a, b, c, d]) => f64::from(f32::from_le_bytes([a, b, c, d])),
            _ => f64::NAN,
        }
    }

    /// Returns the integer that represents 1 in normalized numbers.
    fn one(self) -> f64 {
        match self {
            Self::I8 => f64::from(i8::MAX),
            Self::U8 => f64::from(u8::MAX),
            Self::I16 => f64::from(i16::MAX),
            Self::U16 => f64::from(u16::MAX),
            Self::U32 => f64::from(u32::MAX),
            Self::F32 => 1.0,
        }
    }
}

/// Elements with N components each, stored in a view.
struct Elements<'a, const N: usize> {
    view: View<'a>,
    offset: usize,
    stride: usize,
    count: usize,
    component: Component,
}

impl<'a, const N: usize> Elements<'a, N> {
    /// Returns the elements of a view, starting at `byteOffset` of `from`.
    fn new(
        from: &Json<'a>,
        component: Component,
        count: u64,
        buffers: &mut Buffers<'a>,
    ) -> Result<Self, ContentError> {
        let view = buffers.view(&from.need("bufferView")?)?;
        let offset = from.whole_or("byteOffset", 0)?;
        let size = (N * component.size()) as u64;
        let stride = view.stride.unwrap_or(size);
        if stride < size {
            let (what, value) = ("byteStride", stride.to_string());
            let rule = format!("at least the {size} bytes of an element");
            return Err(from.error(ContentErrorKind::value(what, value, rule)));
        }
        // The last element must end within the view: offset + stride (count − 1) + size ≤ length.
        let length = view.bytes().len() as u64;
        let present = match length.checked_sub(offset).and_then(|rest| rest.checked_sub(size)) {
            Some(rest) => rest / stride + 1,
            None => 0,
        };
        if count > present {
            return Err(from.error(ContentErrorKind::count("elements", count, present)));
        }
        Ok(Self { view, offset: offset as usize, stride: stride as usize, count: count as usize, component })
    }

    fn iter(&self) -> impl Iterator<Item = [f64; N]> + '_ {
        let bytes = self.view.bytes().get(self.offset..).unwrap_or_default();
        let (size, component) = (self.component.size(), self.component);
        bytes.chunks(self.stride.max(1)).take(self.count).map(move |element| {
            let mut values = [0.0; N];
            for (value, bytes) in values.iter_mut().zip(element.chunks(size)) {
                *value = component.value(bytes);
            }
            values
        })
    }
}

/// Reads vectors of N finite numbers. They may be integers of up to 16 bits, normalized if the file
/// says so.
pub(crate) fn vectors<'a, const N: usize>(
    json: &Json<'a>,
    buffers: &mut Buffers<'a>,
    budget: &mut Budget,
) -> Result<Vec<[f64; N]>, ContentError> {
    let (mut values, component) = elements::<N>(json, buffers, budget)?;
    if component == Component::U32 {
        return Err(json.need("componentType")?.refused("componentType", "of 8 or 16 bits, or a float"));
    }
    if json.flag("normalized")? {
        // f = c / (2ⁿ − 1), signed max(c / (2ⁿ⁻¹ − 1), −1)
        let one = component.one();
        values.iter_mut().flatten().for_each(|value| *value = (*value / one).max(-1.0));
    }
    if let Some(k) = values.iter().position(|element| element.iter().any(|x| !x.is_finite())) {
        let kind = ContentErrorKind::not_finite("the vector", format!("{:?}", values[k]));
        return Err(ContentError::new(kind, element(json, k)));
    }
    Ok(values)
}

/// Reads vertex indices, each below `vertices`.
pub(crate) fn indices<'a>(
    json: &Json<'a>,
    vertices: usize,
    buffers: &mut Buffers<'a>,
    budget: &mut Budget,
) -> Result<Vec<u32>, ContentError> {
    let (values, component) = elements::<1>(json, buffers, budget)?;
    if !matches!(component, Component::U8 | Component::U16 | Component::U32) {
        return Err(json.need("componentType")?.refused("componentType", "unsigned for indices"));
    }
    if let Some(k) = values.iter().position(|[index]| *index >= vertices as f64) {
        let kind = ContentErrorKind::index("vertex", values[k][0] as i64, vertices);
        return Err(ContentError::new(kind, element(json, k)));
    }
    // f64 represents every u32 exactly.
    Ok(values.into_iter().map(|[index]| index as u32).collect())
}

/// Returns the elements of an accessor. Elements without data are zero; sparse values replace
/// elements.
fn elements<'a, const N: usize>(
    json: &Json<'a>,
    buffers: &mut Buffers<'a>,
    budget: &mut Budget,
) -> Result<(Vec<[f64; N]>, Component), ContentError> {
    let expected = match N {
        1 => "SCALAR",
        3 => "VEC3",
        _ => "VEC4",
    };
    let kind = json.need("type")?;
    if kind.text()? != expected {
        return Err(kind.refused("type", &format!("{expected} here")));
    }
    let component = Component::of(&json.need("componentType")?)?;
    let count = json.need("count")?.whole()?;
    let spend = |budget: &mut Budget| {
        budget.spend(usize::try_from(count).unwrap_or(usize::MAX), 8 * N, || json.place().to_owned())
    };
    let mut values: Vec<[f64; N]> = match json.get("bufferView") {
        Some(_) => {
            let present = Elements::new(json, component, count, buffers)?;
            spend(budget)?;
            present.iter().collect()
        }
        None => {
            spend(budget)?;
            vec![[0.0; N]; usize::try_from(count).unwrap_or(usize::MAX)]
        }
    };
    let count_all = values.len();
    if let Some(sparse) = json.get("sparse") {
        let count = sparse.need("count")?.whole()?;
        let (at, with) = (sparse.need("indices")?, sparse.need("values")?);
        let places = Elements::<1>::new(&at, Component::of(&at.need("componentType")?)?, count, buffers)?;
        let replacements = Elements::<N>::new(&with, component, count, buffers)?;
        for ([place], replacement) in places.iter().zip(replacements.iter()) {
            // NaN and −1 become 0 as a usize.
            let slot = (place >= 0.0).then_some(place as usize).and_then(|k| values.get_mut(k));
            *slot.ok_or_else(|| {
                let (what, index) = ("element", place as i64);
                at.error(ContentErrorKind::index(what, index, count_all))
            })? = replacement;
        }
    }
    Ok((values, component))
}

fn element(json: &Json<'_>, k: usize) -> ContentPlace {
    ContentPlace::Within(format!("{}, element {k}", json.place()))
}
