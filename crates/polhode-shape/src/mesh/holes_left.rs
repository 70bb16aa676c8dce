//! Reasons why holes of a mesh file were not filled.

use polhode::body::mesh::HolesLeft;
use polhode_source::text::counted;

/// Returns the reasons in words; `None` if all holes were filled.
pub(crate) fn why(left: HolesLeft) -> Option<String> {
    let reasons = [
        (left.larger, "hole", "is larger", "are larger"),
        (left.many_edged, "hole", "has more than 256 edges", "have more than 256 edges"),
        (
            left.sheets,
            "loop",
            "is the rim of a sheet, not of a hole: what closes it would be no smaller than the sheet",
            "are rims of sheets, not of holes: what closes them would be no smaller than the sheets",
        ),
        (
            left.loose_edges,
            "open edge",
            "is part of no loop by itself",
            "are part of no loop by itself, as where holes meet in a vertex",
        ),
    ];
    let said = reasons.into_iter().filter(|reason| reason.0 > 0);
    let said = said.map(|(count, noun, is, are)| {
        format!("{} {}", counted(count, noun), if count == 1 { is } else { are })
    });
    let said: Vec<_> = said.collect();
    (!said.is_empty()).then(|| said.join(", "))
}
