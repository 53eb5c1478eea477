//! The builder: takes triangles, quads, boxes and tubes, and makes a mesh with parts of them.
