//! 3MF: the 3D Manufacturing Format, XML in a ZIP archive.
