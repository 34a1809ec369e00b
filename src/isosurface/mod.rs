//! Isosurfaces of sampled functions: multilinear interpolation and the marching algorithms.
