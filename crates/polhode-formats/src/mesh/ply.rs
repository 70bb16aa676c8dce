//! PLY: the polygon file format of Stanford, ASCII and binary of both endians.
