//! Sums of manifolds: beside one another, or joined through a hole in each.

use super::manifold::Manifold3;
use super::scheme::{FaceId, GluingScheme, Pairing, SignedEdge};

/// The two schemes beside one another; the polyhedra of the second get the next numbers.
pub fn disjoint_union(a: &GluingScheme, b: &GluingScheme) -> GluingScheme {
    let moved = |id: FaceId| FaceId { polyhedron: id.polyhedron + a.polyhedra.len(), ..id };
    let others = b.pairings.iter().map(|p| Pairing { a: moved(p.a), b: moved(p.b), ..*p });
    GluingScheme {
        polyhedra: [&a.polyhedra[..], &b.polyhedra].concat(),
        pairings: a.pairings.iter().copied().chain(others).collect(),
    }
}

/// M # N: a ball is taken out of each, and the spheres around the holes are glued (CX-12).
///
/// Each becomes a loop in the face of its first pairing, at a corner, and the disc in the loop is slit open: the two sides of the
/// slit are the sphere. Each is glued to one of the other manifold: V = V_M + V_N − 1, E = E_M + E_N + 1, F = F_M + F_N + 2,
/// P = P_M + P_N. Where both are orientable, the polyhedra of the two faces `a` keep their orientations, all faces seen from
/// outside; M # N and M # (−N) may differ. Of a manifold in several components the one with that face takes part.
#[doc(alias = "CX-12")]
pub fn connected_sum(m: &Manifold3, n: &Manifold3) -> GluingScheme {
    let [(slit_m, [a, b], dir_m), (slit_n, monogons_n, dir_n)] = [m, n].map(|manifold| slit(manifold.scheme()));
    let offset = m.scheme().polyhedra.len();
    let [c, d] = monogons_n.map(|id| FaceId { polyhedron: id.polyhedron + offset, ..id });
    let mut sum = disjoint_union(&slit_m, &slit_n);
    // c to d would have dir_n: a in its place keeps the orientation that c has.
    sum.pairings.push(Pairing { a, b: d, shift: 0, dir: dir_n });
    sum.pairings.push(Pairing { a: c, b, shift: 0, dir: dir_m });
    sum
}

/// The scheme with a loop at corner 0 of the first pairing's face, in both of its polygons, and the two monogons in these
/// loops, which are not paired: glued with `dir`, the last, they would be the manifold again.
fn slit(scheme: &GluingScheme) -> (GluingScheme, [FaceId; 2], i64) {
    let mut scheme = scheme.clone();
    let Pairing { a, b, shift, dir } = scheme.pairings[0];
    let n = scheme.polyhedra[a.polyhedron].faces[a.face].len();
    let corner = shift.rem_euclid(n as i64) as usize;
    let monogons = [(a, 0), (b, corner)].map(|(id, corner)| {
        let polyhedron = &mut scheme.polyhedra[id.polyhedron];
        let face = &mut polyhedron.faces[id.face];
        // The walk begins at the corner, and the loop stands last.
        face.rotate_left(corner);
        let first = face[0];
        let edge = SignedEdge(polyhedron.edges.len() as i32 + 1);
        face.push(edge);
        let [tail, head] = polyhedron.edges[first.index().expect("an edge")];
        let vertex = if first.is_forward() { tail } else { head };
        polyhedron.edges.push([vertex, vertex]);
        polyhedron.faces.push(vec![SignedEdge(-edge.0)]);
        FaceId { polyhedron: id.polyhedron, face: polyhedron.faces.len() - 1 }
    });
    // Corner 0 goes to corner 0 along the walk; against it, to the loop's end.
    scheme.pairings[0] = Pairing { a, b, shift: if dir == 1 { 0 } else { n as i64 }, dir };
    (scheme, monogons, dir)
}
