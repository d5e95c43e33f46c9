//! Multiblock structured quad meshes around circles from the medial axis (Guoy and Erickson).
