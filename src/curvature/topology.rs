//! Closed surfaces as triangulations: the text's three families, χ, orientations, and what is kept by a homeomorphism.

use crate::linear::Vector;
use crate::mesh::classify::ClosedSurface;
use crate::mesh::connected_sum::{connected_sum, with_tube};
use crate::mesh::examples::surfaces::{icosahedron, projective_plane};
use crate::mesh::simplicial::{Simplex, SimplicialComplex};
use crate::number::{Integer, Rational};
use std::collections::BTreeMap;
use thiserror::Error;

/// The families of the text's theorem 3.31. CU-236.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[doc(alias = "CU-236")]
pub enum Family {
    /// The sphere.
    Sphere,
    /// The sphere with so many handles.
    Handles(usize),
    /// The sphere with so many discs replaced by Möbius bands.
    Bands(usize),
}

impl Family {
    /// χ = 2; 2 − 2g; 2 − g (002, definition 3.32). CU-237.
    #[doc(alias = "CU-237")]
    pub fn euler_characteristic(self) -> i64 {
        match self {
            Family::Sphere => 2,
            Family::Handles(g) => 2 - 2 * g as i64,
            Family::Bands(g) => 2 - g as i64,
        }
    }

    /// The surface: with g = 0 all three are the sphere.
    pub fn surface(self) -> ClosedSurface {
        match self {
            Family::Sphere | Family::Handles(0) | Family::Bands(0) => ClosedSurface::Orientable { genus: 0 },
            Family::Handles(genus) => ClosedSurface::Orientable { genus },
            Family::Bands(crosscaps) => ClosedSurface::NonOrientable { crosscaps },
        }
    }

    /// "As superfícies nas duas primeiras famílias são orientáveis […] e no último item temos que as superfícies são
    /// não orientáveis": what the text says of whether it is orientable. It is wrong for Bands(0). CU-236.
    pub fn is_orientable_printed(self) -> bool {
        match self {
            Family::Sphere | Family::Handles(_) => true,
            Family::Bands(_) => false,
        }
    }

    /// The text's construction as connected sums: g times a disc is replaced by a torus less a disc, or by a projective
    /// plane less a disc, which is a Möbius band; on the icosahedron. CU-235.
    #[doc(alias = "CU-235")]
    #[doc(alias = "CU-233")]
    pub fn triangulation(self) -> SimplicialComplex {
        let (part, times) = match self {
            Family::Sphere => return icosahedron(),
            Family::Handles(g) => (SimplicialComplex::torus(), g),
            Family::Bands(g) => (projective_plane(), g),
        };
        let at = |complex: &SimplicialComplex| -> [u32; 3] {
            let triangle = complex.of_dimension(2).next().expect("a surface has triangles");
            triangle.vertices().try_into().expect("a triangle has three corners")
        };
        (0..times).fold(icosahedron(), |sum, _| {
            connected_sum(&sum, at(&sum), &part, at(&part)).expect("closed surfaces, each with that triangle")
        })
    }
}

/// A sphere with handles as the text makes it: for each, two disjoint discs are taken out, and a tube is glued to
/// their borders so that an orientation of the sphere goes on along it (002, example 3.28). `mirrored` handles are
/// glued the other way; one of them makes the surface one-sided. CU-234.
///
/// # Errors
/// Iff the triangles of the subdivided icosahedron do not suffice for so many.
#[doc(alias = "CU-234")]
pub fn sphere_with_tubes(handles: usize, mirrored: usize) -> Result<SimplicialComplex, NoRoom> {
    let sphere = barycentric_subdivision(&icosahedron());
    let triangles = oriented(&sphere).expect("a surface").expect("a sphere is orientable");
    // Triangles far from one another: none of them has an edge to another.
    let mut far: Vec<[u32; 3]> = Vec::new();
    for triangle in triangles {
        let joined = |a: u32, b: u32| a == b || Simplex::new(&[a, b]).is_ok_and(|edge| sphere.contains(&edge));
        if far.iter().flatten().all(|a| triangle.iter().all(|b| !joined(*a, *b))) {
            far.push(triangle);
        }
    }
    let (wanted, room) = (handles.saturating_add(mirrored), far.len() / 2);
    if wanted > room {
        return Err(NoRoom { wanted, room });
    }
    Ok(far.chunks_exact(2).take(wanted).enumerate().fold(sphere, |surface, (n, pair)| {
        let [a, b, c] = pair[1];
        // The border of what is left runs the other way around each hole, and the tube takes one border to the other.
        let to = if n < handles { [a, c, b] } else { [a, b, c] };
        with_tube(&surface, pair[0], to).expect("the triangles are there and have no edges between them")
    }))
}

/// The triangulated sphere has no room for so many handles.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("{wanted} handles, and room for {room}")]
pub struct NoRoom {
    /// How many were asked for.
    pub wanted: usize,
    /// How many there is room for.
    pub room: usize,
}

/// Why triangles have no directions to choose.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum OrientationError {
    /// An edge of more than two triangles: they are no surface.
    #[error("the edge from {} to {} has {triangles} triangles, more than two", .edge[0], .edge[1])]
    Edge {
        /// Its ends.
        edge: [u32; 2],
        /// How many triangles it has.
        triangles: usize,
    },
    /// There are too many triangles to try all directions.
    #[error("{0} triangles are more than 20")]
    TooMany(usize),
}

/// A triangle of the list, and whether it runs along the edge from the smaller vertex to the larger.
type Places = BTreeMap<[u32; 2], Vec<(usize, bool)>>;

fn triangles(complex: &SimplicialComplex) -> Vec<[u32; 3]> {
    complex.of_dimension(2).map(|t| t.vertices().try_into().expect("a triangle has three corners")).collect()
}

/// The directed sides.
fn sides([a, b, c]: [u32; 3]) -> [[u32; 2]; 3] {
    [[a, b], [b, c], [c, a]]
}

/// Where each edge stands.
fn places(triangles: &[[u32; 3]]) -> Result<Places, OrientationError> {
    let mut places = Places::new();
    for (i, triangle) in triangles.iter().enumerate() {
        for [a, b] in sides(*triangle) {
            places.entry([a.min(b), a.max(b)]).or_default().push((i, a < b));
        }
    }
    match places.iter().find(|(_, at)| at.len() > 2) {
        Some((edge, at)) => Err(OrientationError::Edge { edge: *edge, triangles: at.len() }),
        None => Ok(places),
    }
}

/// The triangles of a surface, each inner edge run along both ways: an orientation, found by passing from triangle to
/// triangle; `None` iff there is none. CU-226.
///
/// # Errors
/// `Edge` iff an edge has more than two triangles.
#[doc(alias = "CU-226")]
#[doc(alias = "CU-228")]
pub fn oriented(surface: &SimplicialComplex) -> Result<Option<Vec<[u32; 3]>>, OrientationError> {
    let triangles = triangles(surface);
    let places = places(&triangles)?;
    let mut found: Vec<Option<[u32; 3]>> = vec![None; triangles.len()];
    for root in 0..triangles.len() {
        if found[root].is_some() {
            continue;
        }
        found[root] = Some(triangles[root]);
        let mut pending = vec![root];
        while let Some(i) = pending.pop() {
            for [a, b] in sides(found[i].expect("what is pending was found")) {
                for (j, _) in places[&[a.min(b), a.max(b)]].iter().copied().filter(|(j, _)| *j != i) {
                    let [x, y, z] = triangles[j];
                    let wanted = if sides([x, y, z]).contains(&[b, a]) { [x, y, z] } else { [x, z, y] };
                    match found[j] {
                        None => {
                            found[j] = Some(wanted);
                            pending.push(j);
                        }
                        Some(other) if sides(other).contains(&[b, a]) => {}
                        Some(_) => return Ok(None),
                    }
                }
            }
        }
    }
    Ok(found.into_iter().collect())
}

/// How many choices of a direction for each triangle run along every inner edge both ways, by trying all: 2 to the
/// number of components for an orientable surface, 0 for another. CU-226.
///
/// # Errors
/// `Edge` as for [`oriented`], else `TooMany` iff there are more than 20 triangles.
pub fn orientation_count(surface: &SimplicialComplex) -> Result<u32, OrientationError> {
    let triangles = triangles(surface);
    let places = places(&triangles)?;
    if triangles.len() > 20 {
        return Err(OrientationError::TooMany(triangles.len()));
    }
    // Two triangles at an edge have to run along it both ways: one equation in their directions each.
    let equations: Vec<[(usize, bool); 2]> = places.into_values().filter_map(|at| at.try_into().ok()).collect();
    let fits =
        |turned: u32| equations.iter().all(|[(i, a), (j, b)]| (turned >> i & 1 == 1) ^ a != (turned >> j & 1 == 1) ^ b);
    Ok((0..1_u32 << triangles.len()).map(|turned| u32::from(fits(turned))).sum())
}

/// The barycentric subdivision: a vertex for each simplex, numbered in order, a simplex for each chain of faces. It is
/// homeomorphic to the complex. CU-237.
pub fn barycentric_subdivision(complex: &SimplicialComplex) -> SimplicialComplex {
    let number: BTreeMap<&Simplex, u32> = complex.simplices().zip(0..).collect();
    let chains = complex.maximal().into_iter().flat_map(|simplex| {
        let mut chains = vec![vec![simplex.clone()]];
        for k in (0..simplex.dimension()).rev() {
            let longer = |chain: &Vec<Simplex>| {
                let last = chain.last().expect("a chain begins with the simplex").clone();
                last.faces(k).into_iter().map(|face| [&chain[..], &[face]].concat()).collect::<Vec<_>>()
            };
            chains = chains.iter().flat_map(longer).collect();
        }
        chains
    });
    let simplices = chains.map(|chain| {
        let vertices: Vec<u32> = chain.iter().map(|simplex| number[simplex]).collect();
        Simplex::new(&vertices).expect("at most as many as the simplex has, and different")
    });
    SimplicialComplex::new(simplices.collect::<Vec<_>>())
}

/// n points of the curve (t, t², t³, t⁴), t = 1, …, n, any five of them affinely independent. CU-232.
#[doc(alias = "CU-232")]
pub fn moment_curve(n: u32) -> Vec<Vector<Rational, 4>> {
    let power = |t: u32, n: u32| Rational::from(Integer::from(Integer::u_pow_u(t, n)));
    (1..=n).map(|t| Vector(std::array::from_fn(|i| power(t, i as u32 + 1)))).collect()
}
