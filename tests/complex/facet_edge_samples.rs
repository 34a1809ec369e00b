//! Complexes on which facet-edge structures are tried.

use isoracle::complex::closed_complex::ClosedComplex;
use isoracle::complex::examples::{lens_space, paired, three_torus};
use isoracle::complex::facet_edge::FacetEdgeStructure;
use isoracle::complex::flag::Flag;
use isoracle::complex::handle::{Handle, Space};
use isoracle::complex::scheme::{FaceId, GluingScheme, Pairing, Polyhedron};
use isoracle::complex::triangulation::Triangulation;

/// The pairings of the faces of one polyhedron in twos, in all ways.
fn matchings(faces: &[usize]) -> Vec<Vec<[usize; 2]>> {
    let Some((first, rest)) = faces.split_first() else { return vec![Vec::new()] };
    let with = |i: usize| {
        let others: Vec<usize> = rest.iter().copied().filter(|f| *f != rest[i]).collect();
        matchings(&others).into_iter().map(move |pairs| [vec![[*first, rest[i]]], pairs].concat())
    };
    (0..rest.len()).flat_map(with).collect()
}

/// All gluings of one polyhedron whose faces have n sides, to itself.
fn gluings(polyhedron: &Polyhedron, n: i64) -> Vec<GluingScheme> {
    let faces: Vec<usize> = (0..polyhedron.faces.len()).collect();
    let maps: Vec<(i64, i64)> = (0..n).flat_map(|shift| [(shift, 1), (shift, -1)]).collect();
    let mut schemes = Vec::new();
    for pairs in matchings(&faces) {
        let mut chosen = vec![Vec::new()];
        for [a, b] in &pairs {
            let extended = |done: Vec<(usize, usize, i64, i64)>| {
                let with = |(shift, dir): &(i64, i64)| [done.clone(), vec![(*a, *b, *shift, *dir)]].concat();
                maps.iter().map(with).collect::<Vec<_>>()
            };
            chosen = chosen.into_iter().flat_map(extended).collect();
        }
        schemes.extend(chosen.iter().map(|pairs| paired(polyhedron.clone(), pairs)));
    }
    schemes
}

/// The 108 gluings of one tetrahedron.
pub fn tetrahedron_gluings() -> Vec<GluingScheme> {
    gluings(&Polyhedron::tetrahedron(), 3)
}

/// The 7,680 gluings of the cube; without the long form every 13th.
pub fn cube_gluings() -> Vec<GluingScheme> {
    gluings(&Polyhedron::cube(), 4).into_iter().step_by(if crate::is_long() { 1 } else { 13 }).collect()
}

/// Polyhedra given by faces with the names of their vertices, each face glued to the one of the same names.
fn by_names(polyhedra: &[Vec<Vec<u32>>]) -> GluingScheme {
    let mut pairings = Vec::new();
    let faces: Vec<(FaceId, &Vec<u32>)> = (0..)
        .zip(polyhedra)
        .flat_map(|(polyhedron, faces)| (0..).zip(faces).map(move |(face, f)| (FaceId { polyhedron, face }, f)))
        .collect();
    let sorted = |names: &[u32]| {
        let mut names = names.to_vec();
        names.sort();
        names
    };
    for (i, (a, names)) in faces.iter().enumerate() {
        let other = faces[i + 1..].iter().find(|(_, others)| sorted(others) == sorted(names));
        if let Some((b, others)) = other {
            let place = |name: u32| others.iter().position(|other| *other == name).expect("a common vertex") as i64;
            let shift = place(names[0]);
            let dir = if place(names[1]) == (shift + 1) % names.len() as i64 { 1 } else { -1 };
            pairings.push(Pairing { a: *a, b: *b, shift, dir });
        }
    }
    GluingScheme { polyhedra: polyhedra.iter().map(|faces| Polyhedron::of_vertex_cycles(faces)).collect(), pairings }
}

/// The boundary of the simplex of dimension 4: five tetrahedra.
pub fn simplex_boundary() -> GluingScheme {
    let tetrahedron = |i: u32| {
        let [a, b, c, d] = [1, 2, 3, 4].map(|k| (i + k) % 5);
        vec![vec![b, c, d], vec![a, d, c], vec![a, b, d], vec![a, c, b]]
    };
    by_names(&(0..5).map(tetrahedron).collect::<Vec<_>>())
}

/// The dual of the lens space L(n, 0): n balls with two faces of one side each, in a ring.
pub fn ring_of_lenses(n: usize) -> GluingScheme {
    let face = |polyhedron, face| FaceId { polyhedron, face };
    let pairing = |i: usize| Pairing { a: face(i, 0), b: face((i + 1) % n, 1), shift: 0, dir: -1 };
    GluingScheme { polyhedra: vec![Polyhedron::lens(1); n], pairings: (0..n).map(pairing).collect() }
}

/// A complex with two components: the 3-torus and L(3, 1).
pub fn torus_beside_lens() -> GluingScheme {
    let (mut scheme, lens) = (three_torus(), lens_space(3, 1));
    scheme.polyhedra.extend(lens.polyhedra);
    scheme.pairings.extend(lens.pairings.into_iter().map(|mut pairing| {
        (pairing.a.polyhedron, pairing.b.polyhedron) = (1, 1);
        pairing
    }));
    scheme
}

/// A cube whose bottom is glued to its top with a mirror, its sides by translations: not orientable.
pub fn mirrored_torus() -> GluingScheme {
    let mut scheme = three_torus();
    (scheme.pairings[0].shift, scheme.pairings[0].dir) = (0, 1);
    scheme
}

/// Named complexes.
pub fn examples() -> Vec<(String, ClosedComplex)> {
    let mut schemes = vec![
        ("3-torus".to_owned(), three_torus()),
        ("mirrored torus".to_owned(), mirrored_torus()),
        ("simplex".to_owned(), simplex_boundary()),
        ("torus and lens".to_owned(), torus_beside_lens()),
    ];
    let lenses = [(1, 0), (2, 0), (2, 1), (3, 0), (3, 1), (4, 2), (5, 2), (7, 3)];
    schemes.extend(lenses.map(|(p, q)| (format!("L({p}, {q})"), lens_space(p, q))));
    schemes.extend([1, 2, 3].map(|n| (format!("ring of {n}"), ring_of_lenses(n))));
    let complex = |scheme| ClosedComplex::new(scheme).expect("a closed complex");
    schemes.into_iter().map(|(name, scheme)| (name, complex(scheme))).collect()
}

/// The complexes among these schemes.
pub fn closed(schemes: Vec<GluingScheme>) -> Vec<ClosedComplex> {
    schemes.into_iter().filter_map(|scheme| ClosedComplex::new(scheme).ok()).collect()
}

/// A triangulation as a scheme of tetrahedra.
pub fn scheme_of(triangulation: &Triangulation) -> GluingScheme {
    let faces = [[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]];
    let mut pairings = Vec::new();
    for (tetrahedron, gluings) in triangulation.gluings().iter().enumerate() {
        for (face, gluing) in gluings.iter().enumerate() {
            let other = gluing.corners.image(face);
            let place = |i: usize| {
                let image = gluing.corners.image(faces[face][i]);
                faces[other].iter().position(|corner| *corner == image).expect("a corner of the triangle") as i64
            };
            let dir = if (place(0) + 1) % 3 == place(1) { 1 } else { -1 };
            let [a, b] = [(tetrahedron, face), (gluing.tetrahedron as usize, other)]
                .map(|(polyhedron, face)| FaceId { polyhedron, face });
            if a < b {
                pairings.push(Pairing { a, b, shift: place(0), dir });
            }
        }
    }
    GluingScheme { polyhedra: vec![Polyhedron::tetrahedron(); triangulation.len()], pairings }
}

/// The primal handle of each flag of a complex, from the first flags of its tetrahedra.
pub fn handles_of_flags(complex: &ClosedComplex) -> Vec<Handle> {
    let flags = complex.flags();
    let mut handles = vec![None; flags.len()];
    for (pair, base) in (0..).zip(complex.tetrahedron_flags()) {
        let a = Handle::base(pair);
        let versions = [(&[][..], a), (&[0], a.clock().spin()), (&[3], a.spin()), (&[0, 3], a.clock())];
        versions.iter().for_each(|(maps, h)| handles[flags.walk(base, maps).0 as usize] = Some(*h));
    }
    handles.into_iter().map(|h| h.expect("each flag is in a tetrahedron")).collect()
}

/// The flag of each primal handle of a structure, as [`FacetEdgeStructure::to_flags`] numbers them.
pub fn flag_of(h: Handle) -> Flag {
    Flag(4 * h.pair() + 2 * u32::from(h.is_counter()) + u32::from(h.is_reversed()))
}

/// Every handle of a structure.
pub fn all_handles(structure: &FacetEdgeStructure) -> Vec<Handle> {
    [structure.handles(Space::Primal), structure.handles(Space::Dual)].concat()
}

/// The laws of the traversal functions at every handle, and no defect.
pub fn assert_laws(structure: &FacetEdgeStructure) {
    assert_eq!(structure.defects(), []);
    let (enext, fnext) = (|h| structure.enext(h), |h| structure.fnext(h));
    for a in all_handles(structure) {
        assert_eq!([a.spin().spin(), a.clock().clock(), a.sdual().sdual()], [a; 3]);
        assert_eq!(a.spin().clock(), a.clock().spin());
        assert_eq!(a.clock().sdual(), a.sdual().clock());
        assert_eq!(a.sdual().spin().sdual(), a.clock().spin());
        assert_eq!(enext(enext(a).clock()).clock(), a, "Enext Clock Enext Clock = 1");
        assert_eq!(fnext(fnext(a).clock()).clock(), a, "Fnext Clock Fnext Clock = 1");
        assert_eq!(fnext(fnext(a).spin()).spin(), a, "Fnext Spin Fnext Spin = 1");
        assert_eq!(enext(a).spin(), enext(a.spin()), "Enext Spin = Spin Enext");
        assert_eq!(enext(a.sdual()).sdual(), fnext(a), "Sdual Enext Sdual = Fnext");
        assert_eq!([structure.fprev(fnext(a)), structure.eprev(enext(a))], [a; 2]);
        assert_eq!([structure.fnext(a).space(), structure.enext(a).space()], [a.space(); 2]);
    }
}
