//! glTF 2.0: JSON with buffers beside it, or all of it in one binary GLB.
