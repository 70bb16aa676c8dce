//! Paths of prims.

/// Returns an absolute path. A relative path starts at the prim that states it.
pub(super) fn absolute(path: &str, prim: &str) -> String {
    if path.starts_with('/') {
        return path.to_owned();
    }
    let mut names: Vec<&str> = prim.split('/').filter(|name| !name.is_empty()).collect();
    for name in path.split('/') {
        match name {
            ".." => drop(names.pop()),
            "." | "" => {}
            name => names.push(name),
        }
    }
    format!("/{}", names.join("/"))
}
