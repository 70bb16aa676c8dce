//! Wavefront OBJ: vertices, faces of any number of corners, groups.
