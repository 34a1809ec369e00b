//! The facet-edge structure of Dobkin and Laszlo: a record for each face-edge pair, and who is next to it in its two rings.

use super::closed_complex::ClosedComplex;
use super::flag::{Flag, Flags};
use super::handle::{Handle, Space};
use crate::partition::Partition;
use std::collections::BTreeSet;
use thiserror::Error;

/// A complex and its dual as face-edge pairs: for each pair the next one in its ring of faces, in both spaces.
///
/// Four fields a record hold Fnext of the base version, of its Clock, and of the Sdual of both; the other versions and Enext
/// follow by the laws. Functions are written behind their arguments: Clock Fnext Clock = Fnext⁻¹ = Spin Fnext Spin,
/// Clock Enext Clock = Enext⁻¹, Spin Enext = Enext Spin, Sdual Fnext Sdual = Enext. In flags, the first map first:
/// Spin = σ₃, Clock = σ₀σ₃, Fnext is σ₂ and then σ₃, Enext is σ₀ and then σ₁.
///
/// Every sound structure is a closed complex whose edges and faces are cells. Its polyhedra are cones on closed surfaces, as the
/// neighbourhoods of its vertices are: both may be other surfaces than spheres.
#[doc(alias = "CX-17")]
#[doc(alias = "CX-29")]
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct FacetEdgeStructure {
    next: Vec<[Handle; 4]>,
}

/// What keeps records from being those of a complex.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Error)]
pub enum FacetEdgeDefect {
    /// Fnext names a pair that has no record.
    #[error("({0}) Fnext is a pair that does not exist")]
    OutOfRange(Handle),
    /// Fnext leads out of the space.
    #[error("({0}) Fnext is in the other space")]
    OtherSpace(Handle),
    /// Fnext Clock Fnext is not Clock: the next pair has another one before it.
    #[error("({0}) Fnext has another pair before it")]
    OneWay(Handle),
    /// The ring comes back to the handle with the other spin: a polyhedron lies between a side of a face and itself.
    #[error("the ring of ({0}) comes back with the other spin")]
    Folded(Handle),
    /// The ring comes back to the handle with its edge the other way: an edge glued to itself, tail to head; in the dual space
    /// a face glued to itself.
    #[error("the ring of ({0}) comes back with the edge turned")]
    Turned(Handle),
    /// σ₀ and σ₃ lead from the flag to the same one, so that it has no four versions.
    #[error("flag {} is the same from both ends of its edge and from both sides of its face", .0.0)]
    PairTurned(Flag),
}

impl FacetEdgeStructure {
    /// The structure with these fields: for each pair Fnext of its base, of base Clock, of base Sdual, of base Clock Sdual.
    ///
    /// # Errors
    /// All defects, iff there is one.
    pub fn new(next: Vec<[Handle; 4]>) -> Result<FacetEdgeStructure, Vec<FacetEdgeDefect>> {
        let structure = FacetEdgeStructure { next };
        let defects = structure.defects();
        if defects.is_empty() { Ok(structure) } else { Err(defects) }
    }

    /// The structure of a complex: pair i is topological tetrahedron i, its base the first flag of the tetrahedron.
    pub fn of(complex: &ClosedComplex) -> FacetEdgeStructure {
        FacetEdgeStructure::of_flags(complex.flags())
            .expect("no edge and no face of a closed complex is glued to itself")
    }

    /// The structure of these flags: a pair for each orbit of σ₀ and σ₃, in the order of their first flags, which are the bases.
    ///
    /// # Errors
    /// All defects, iff an edge is glued to itself, tail to head, or a face to itself.
    pub fn of_flags(flags: &Flags) -> Result<FacetEdgeStructure, Vec<FacetEdgeDefect>> {
        let (pair_of, pairs) = flags.orbits(&[0, 3]);
        let mut bases: Vec<Option<Flag>> = vec![None; pairs];
        for flag in flags.all() {
            bases[pair_of[flag.0 as usize] as usize].get_or_insert(flag);
        }
        let bases: Vec<Flag> = bases.into_iter().map(|base| base.expect("each orbit has a flag")).collect();
        let turned: Vec<FacetEdgeDefect> = bases
            .iter()
            .filter(|base| flags.sigma(0, **base) == flags.sigma(3, **base))
            .map(|base| FacetEdgeDefect::PairTurned(*base))
            .collect();
        if !turned.is_empty() {
            return Err(turned);
        }
        let handle = |flag: Flag| {
            let pair = pair_of[flag.0 as usize];
            let primal = &Handle::versions(pair)[..4];
            let of_base = |h: &&Handle| flag_of(flags, bases[pair as usize], **h) == flag;
            *primal.iter().find(of_base).expect("σ₀ and σ₃ lead to all flags of the orbit")
        };
        let fields = bases.iter().map(|base| {
            let clocked = flags.walk(*base, &[0, 3]);
            let fnext = |flag| handle(flags.walk(flag, &[2, 3]));
            let enext = |flag| handle(flags.walk(flag, &[0, 1])).sdual();
            [fnext(*base), fnext(clocked), enext(*base), enext(clocked)]
        });
        FacetEdgeStructure::new(fields.collect())
    }

    /// The flags: number 4i + 2c + r for pair i with the spin against its base iff c and the edge against it iff r.
    pub fn to_flags(&self) -> Flags {
        let number = |h: Handle| 4 * h.pair() + 2 * u32::from(h.is_counter()) + u32::from(h.is_reversed());
        let mut handles = self.handles(Space::Primal);
        handles.sort_by_key(|h| number(*h));
        let sigma = |map: &dyn Fn(Handle) -> Handle| handles.iter().map(|h| number(map(*h))).collect();
        let maps = [
            sigma(&|h| h.flip()),
            sigma(&|h| self.enext(h.flip())),
            sigma(&|h| self.fnext(h).spin()),
            sigma(&|h| h.spin()),
        ];
        Flags::new(maps).expect("the laws of the structure are those of flags")
    }

    /// How many face-edge pairs there are, t.
    #[doc(alias = "CX-16")]
    pub fn len(&self) -> usize {
        self.next.len()
    }

    /// Whether there is no pair.
    pub fn is_empty(&self) -> bool {
        self.next.is_empty()
    }

    /// Whether the pair of a handle has a record here.
    pub fn has(&self, a: Handle) -> bool {
        (a.pair() as usize) < self.len()
    }

    /// The four versions of each pair in one space.
    pub fn handles(&self, space: Space) -> Vec<Handle> {
        let first = match space {
            Space::Primal => 0,
            Space::Dual => 4,
        };
        (0..self.len() as u32).flat_map(|pair| Handle::versions(pair)[first..first + 4].to_vec()).collect()
    }

    /// Fnext: the same edge, directed the same way, with the next face around it, as the spin turns.
    #[doc(alias = "CX-18")]
    pub fn fnext(&self, a: Handle) -> Handle {
        match a.is_reversed() == a.is_counter() {
            true => self.next[a.pair() as usize][field(a)],
            // Spin Fnext Spin = Clock Fnext Clock.
            false => self.next[a.pair() as usize][field(a.flip())].flip(),
        }
    }

    /// Fnext⁻¹ = Clock Fnext Clock: the face before it.
    pub fn fprev(&self, a: Handle) -> Handle {
        self.fnext(a.clock()).clock()
    }

    /// Enext: the same face, turned the same way, with the next edge around it, which begins where this one ends.
    pub fn enext(&self, a: Handle) -> Handle {
        self.fnext(a.sdual()).sdual()
    }

    /// Enext⁻¹: the edge before it.
    pub fn eprev(&self, a: Handle) -> Handle {
        self.fprev(a.sdual()).sdual()
    }

    /// The ring F_a: a, a Fnext, a Fnext², … until a comes again.
    pub fn facet_ring(&self, a: Handle) -> Vec<Handle> {
        ring(a, |a| self.fnext(a))
    }

    /// The ring E_a: a, a Enext, a Enext², … until a comes again.
    pub fn edge_ring(&self, a: Handle) -> Vec<Handle> {
        ring(a, |a| self.enext(a))
    }

    /// How many different faces and edges are incident: pairs without multiplicity, at most t.
    #[doc(alias = "CX-39")]
    pub fn incidences(&self) -> usize {
        let [edges, faces] = [1, 2].map(|k| self.cells(k).0);
        edges.into_iter().zip(faces).collect::<BTreeSet<_>>().len()
    }

    /// V, E, F, P.
    #[doc(alias = "CX-40")]
    pub fn counts(&self) -> [usize; 4] {
        [0, 1, 2, 3].map(|k| self.cells(k).1)
    }

    /// The cell of dimension k ≤ 3 of each primal handle, in the order of [`FacetEdgeStructure::handles`], numbered by their first
    /// handles: vertex at the tail, edge, face, polyhedron that the spin turns into; and how many there are.
    pub fn cells(&self, k: usize) -> (Vec<u32>, usize) {
        let sigma: [&dyn Fn(Handle) -> Handle; 4] =
            [&|h| h.flip(), &|h| self.enext(h.flip()), &|h| self.fnext(h).spin(), &|h| h.spin()];
        let maps: Vec<_> = (0..4).filter(|i| *i != k).map(|i| sigma[i]).collect();
        self.orbits(&maps)
    }

    /// The orbits of primal handles under some maps.
    pub(crate) fn orbits(&self, maps: &[&dyn Fn(Handle) -> Handle]) -> (Vec<u32>, usize) {
        let handles = self.handles(Space::Primal);
        let mut parts = Partition::new(handles.len());
        for (i, h) in handles.iter().enumerate() {
            for map in maps {
                parts.join(i, self.index(map(*h)));
            }
        }
        let (mut numbers, mut count) = (vec![u32::MAX; handles.len()], 0);
        for i in 0..handles.len() {
            let first = parts.find(i);
            if first == i {
                numbers[i] = count;
                count += 1;
            }
            numbers[i] = numbers[first];
        }
        (numbers, count as usize)
    }

    /// The place of a primal handle among [`FacetEdgeStructure::handles`].
    pub fn index(&self, h: Handle) -> usize {
        let versions = Handle::versions(h.pair());
        4 * h.pair() as usize + versions.iter().position(|v| *v == h).expect("a version of its pair") % 4
    }

    /// The structure of the dual complex: what is primal here is dual there.
    #[doc(alias = "CX-42")]
    pub fn dual(&self) -> FacetEdgeStructure {
        let swapped = |[a, b, c, d]: [Handle; 4]| [c, d, a, b].map(Handle::in_other_space);
        FacetEdgeStructure { next: self.next.iter().copied().map(swapped).collect() }
    }

    /// What is wrong with the records. Empty iff Fnext of every handle leads to an existing one of its space, Fnext Clock Fnext is
    /// Clock, and no ring comes back to its pair in another version.
    pub fn defects(&self) -> Vec<FacetEdgeDefect> {
        let stored = || (0..self.len() as u32).flat_map(|pair| stored_versions(pair).to_vec());
        let mut defects = Vec::new();
        for a in stored() {
            match self.fnext(a) {
                b if !self.has(b) => defects.push(FacetEdgeDefect::OutOfRange(a)),
                b if b.space() != a.space() => defects.push(FacetEdgeDefect::OtherSpace(a)),
                _ => {}
            }
        }
        if !defects.is_empty() {
            return defects;
        }
        defects
            .extend(stored().filter(|a| self.fnext(self.fnext(*a).clock()) != a.clock()).map(FacetEdgeDefect::OneWay));
        if !defects.is_empty() {
            return defects;
        }
        // Which ring a handle is in, by pair and version.
        let place = |h: Handle| {
            8 * h.pair() as usize + Handle::versions(h.pair()).iter().position(|v| *v == h).expect("a version")
        };
        let mut ring_of = vec![usize::MAX; 8 * self.len()];
        for pair in 0..self.len() as u32 {
            for a in Handle::versions(pair) {
                if ring_of[place(a)] == usize::MAX {
                    self.facet_ring(a).into_iter().for_each(|h| ring_of[place(h)] = place(a));
                }
            }
        }
        for pair in 0..self.len() as u32 {
            for a in [Handle::base(pair), Handle::base(pair).sdual()] {
                let same = |b: Handle| ring_of[place(a)] == ring_of[place(b)];
                if same(a.spin()) {
                    defects.push(FacetEdgeDefect::Folded(a));
                }
                if same(a.clock()) || same(a.flip()) {
                    defects.push(FacetEdgeDefect::Turned(a));
                }
            }
        }
        defects
    }

    /// Writes b = a Fnext, in the field that has it, and that a is before b.
    pub(crate) fn link(&mut self, a: Handle, b: Handle) {
        for (a, b) in [(a, b), (b.clock(), a.clock())] {
            match a.is_reversed() == a.is_counter() {
                true => self.next[a.pair() as usize][field(a)] = b,
                false => self.next[a.pair() as usize][field(a.flip())] = b.flip(),
            }
        }
    }

    pub(crate) fn fields(&self) -> &[[Handle; 4]] {
        &self.next
    }

    pub(crate) fn fields_mut(&mut self) -> &mut Vec<[Handle; 4]> {
        &mut self.next
    }
}

/// The versions whose Fnext is stored, in the order of the fields.
fn stored_versions(pair: u32) -> [Handle; 4] {
    let base = Handle::base(pair);
    [base, base.clock(), base.sdual(), base.clock().sdual()]
}

/// The field of a version that has one.
fn field(a: Handle) -> usize {
    let space = match a.space() {
        Space::Primal => 0,
        Space::Dual => 2,
    };
    space + usize::from(a.is_reversed())
}

fn ring(a: Handle, next: impl Fn(Handle) -> Handle) -> Vec<Handle> {
    std::iter::successors(Some(a), |h| Some(next(*h)).filter(|h| *h != a)).collect()
}

/// The flag of a primal version of the pair whose base is this flag.
fn flag_of(flags: &Flags, base: Flag, h: Handle) -> Flag {
    let turned = if h.is_reversed() { flags.sigma(0, base) } else { base };
    if h.is_counter() { flags.sigma(3, turned) } else { turned }
}
