//! Graded triangle meshes of planar domains steered by bubbles (Luo).
