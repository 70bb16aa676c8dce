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
            "is the boundary of a sheet, not of a hole: the patch would be at least as large as the sheet",
            "are boundaries of sheets, not of holes: the patches would be at least as large as the sheets",
        ),
        (
            left.loose_edges,
            "open edge",
            "belongs to no single loop",
            "belong to no single loop, for example because holes share a vertex",
        ),
    ];
    let said = reasons.into_iter().filter(|reason| reason.0 > 0);
    let said = said.map(|(count, noun, is, are)| {
        format!("{} {}", counted(count, noun), if count == 1 { is } else { are })
    });
    let said: Vec<_> = said.collect();
    (!said.is_empty()).then(|| said.join(", "))
}
