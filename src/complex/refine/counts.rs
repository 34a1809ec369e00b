//! How many vertices, edges, triangles and tetrahedra a refinement has: as they are, and as 000 prints them.

/// V_k, E_k, F_k, T_k of the refinement of order k of a closed 3-complex with V + P vertices and polyhedra, t face-edge pairs and that χ,
/// which is 0 for a manifold:
///
/// V_k = k(V + P) − (k − 1)χ + t(k³ − k)/6, E_k = V_k − χ + tk³, F_k = 2tk³, T_k = tk³.
///
/// Domain: no edge glued to itself, tail to head.
#[doc(alias = "CX-55")]
#[doc(alias = "CX-57")]
#[doc(alias = "CX-58")]
pub fn counts(vertices_and_polyhedra: u64, pairs: u64, chi: i64, order: u64) -> [i128; 4] {
    let [x, t, chi, k] = [vertices_and_polyhedra.into(), pairs.into(), i128::from(chi), i128::from(order)];
    let vertices = k * x - (k - 1) * chi + t * ((k * k * k - k) / 6);
    let tetrahedra = t * k * k * k;
    [vertices, vertices - chi + tetrahedra, 2 * tetrahedra, tetrahedra]
}

/// What 000, section 5.3, prints: t(k³ + k² + 1) edges, 2tk³ triangles, tk³ tetrahedra, in this order. The first is wrong in general (CX-58).
#[doc(alias = "CX-58")]
pub fn printed_counts(pairs: u64, order: u64) -> [u128; 3] {
    let [t, k] = [pairs, order].map(u128::from);
    [t * (k.pow(3) + k.pow(2) + 1), 2 * t * k.pow(3), t * k.pow(3)]
}

/// Whether the printed number of edges is right for a manifold with V + P vertices and polyhedra and t face-edge pairs: V + P is 2t for
/// k ≤ 3, 7t/4 for k = 4, 6t/5 for k = 5, t/3 for k = 6; never for k ≥ 7.
#[doc(alias = "CX-59")]
pub fn printed_edges_hold(vertices_and_polyhedra: u64, pairs: u64, order: u64) -> bool {
    let [x, t] = [vertices_and_polyhedra, pairs].map(u128::from);
    match order {
        0 => false,
        1..=3 => x == 2 * t,
        4 => 4 * x == 7 * t,
        5 => 5 * x == 6 * t,
        6 => 3 * x == t,
        7.. => false,
    }
}

/// The greatest number V + P of vertices and polyhedra that a connected closed 3-manifold of t face-edge pairs has: t + 1, but 4 for
/// t = 2 (CX-60).
#[doc(alias = "CX-60")]
pub fn most_vertices_and_polyhedra(pairs: u64) -> u64 {
    match pairs {
        2 => 4,
        t => t + 1,
    }
}
