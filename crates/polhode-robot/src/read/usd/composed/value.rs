//! Values of `openusd` as flat lists of numbers and words.

use std::sync::Arc;

use openusd::gf::f16;
use openusd::sdf;

use crate::model::{Number, Span};
use crate::read::usd::value::Value;

/// Returns a value at a position; without numbers and words if its type is another one, such as an
/// array of numbers.
pub(super) fn of_value(value: &sdf::Value, span: Span) -> Value {
    use sdf::Value as V;
    let single = |numbers: &[f32]| numbers.iter().map(ToString::to_string).collect::<Vec<_>>();
    let double = |numbers: &[f64]| numbers.iter().map(ToString::to_string).collect::<Vec<_>>();
    let numbers = match value {
        V::Bool(flag) => vec![u8::from(*flag).to_string()],
        V::Uchar(x) => vec![x.to_string()],
        V::Int(x) => vec![x.to_string()],
        V::Uint(x) => vec![x.to_string()],
        V::Int64(x) => vec![x.to_string()],
        V::Uint64(x) => vec![x.to_string()],
        V::Half(x) => single(&[x.to_f32()]),
        V::Float(x) => single(&[*x]),
        V::Double(x) => double(&[*x]),
        V::Vec2f(v) => single(&[v.x, v.y]),
        V::Vec2d(v) => double(&[v.x, v.y]),
        V::Vec3h(v) => single(&[v.x, v.y, v.z].map(f16::to_f32)),
        V::Vec3f(v) => single(&[v.x, v.y, v.z]),
        V::Vec3d(v) => double(&[v.x, v.y, v.z]),
        V::Vec3i(v) => [v.x, v.y, v.z].iter().map(ToString::to_string).collect(),
        V::Vec4f(v) => single(&[v.x, v.y, v.z, v.w]),
        V::Vec4d(v) => double(&[v.x, v.y, v.z, v.w]),
        V::Quath(q) => single(&[q.w, q.x, q.y, q.z].map(f16::to_f32)),
        V::Quatf(q) => single(&[q.w, q.x, q.y, q.z]),
        V::Quatd(q) => double(&[q.w, q.x, q.y, q.z]),
        V::Matrix3d(m) => double(&m.0),
        V::Matrix4d(m) => double(&m.0),
        // `mjc:inertia` and the like.
        V::FloatVec(list) if list.len() <= 16 => single(list),
        V::DoubleVec(list) if list.len() <= 16 => double(list),
        _ => Vec::new(),
    };
    let words = match value {
        V::String(text) => vec![text.clone()],
        V::Token(token) => vec![token.as_str().to_owned()],
        V::TokenVec(tokens) => tokens.iter().map(|token| token.as_str().to_owned()).collect(),
        V::AssetPath(path) => vec![format!("@{}@", path.authored_path)],
        _ => Vec::new(),
    };
    let number = |text: String| Number { span: span.clone(), value: text.to_lowercase().parse().ok(), text };
    Value { numbers: numbers.into_iter().map(number).collect(), words, span: span.clone(), array: None }
}

/// Returns the numbers of an array, in order: for single precision, the shortest decimals that
/// identify them. Empty if its type is another one.
pub(super) fn array_of(value: &sdf::Value) -> Arc<[f64]> {
    use sdf::Value as V;
    let single = |x: f32| x.to_string().parse().unwrap_or(f64::NAN);
    match value {
        V::IntVec(all) => all.iter().map(|&x| f64::from(x)).collect(),
        V::Vec3hVec(all) => all.iter().flat_map(|v| [v.x, v.y, v.z]).map(|x| single(x.to_f32())).collect(),
        V::Vec3fVec(all) => all.iter().flat_map(|v| [v.x, v.y, v.z]).map(single).collect(),
        V::Vec3dVec(all) => all.iter().flat_map(|v| [v.x, v.y, v.z]).collect(),
        _ => Arc::default(),
    }
}
