//! Points, vectors, matrices and determinants over any ring.
