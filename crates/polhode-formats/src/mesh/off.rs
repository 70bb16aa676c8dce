//! OFF: the Object File Format of Geomview.
