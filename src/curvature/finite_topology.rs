//! Topologies on finite sets: open sets, splittings, connected sets, continuous maps. Here countable families are
//! finite ones.

use std::collections::BTreeSet;
use thiserror::Error;

/// A set of points 0 … 15, as bits.
pub type Points = u16;

/// A finite topological space (X, τ), X = {0, …, n − 1}.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct FiniteSpace {
    points: u32,
    open: BTreeSet<Points>,
}

/// Why a family of sets is no topology.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum TopologyError {
    /// There are more than [`FiniteSpace::MOST_POINTS`].
    #[error("{0} points are more than {most}", most = FiniteSpace::MOST_POINTS)]
    TooMany(u32),
    /// A set has a point that is not in X.
    #[error("the set {0:#b} has a point outside")]
    Outside(Points),
    /// ∅ or X is missing.
    #[error("the set {0:#b} is missing: the empty set and the whole one are open")]
    Missing(Points),
    /// The union of two of the sets is missing.
    #[error("the union of {0:#b} and {1:#b} is missing")]
    Union(Points, Points),
    /// The intersection of two of the sets is missing.
    #[error("the intersection of {0:#b} and {1:#b} is missing")]
    Intersection(Points, Points),
}

impl FiniteSpace {
    /// As many points as a [`Points`] has bits.
    pub const MOST_POINTS: u32 = Points::BITS;

    /// The space with these open sets. Unions and intersections of two suffice, as all families are finite.
    ///
    /// # Errors
    /// Iff there are too many points, a set has another point, or an axiom fails; the first that does.
    pub fn new(points: u32, open: impl IntoIterator<Item = Points>) -> Result<FiniteSpace, TopologyError> {
        if points > FiniteSpace::MOST_POINTS {
            return Err(TopologyError::TooMany(points));
        }
        let open: BTreeSet<Points> = open.into_iter().collect();
        let all = whole(points);
        if let Some(set) = open.iter().find(|set| **set & !all != 0) {
            return Err(TopologyError::Outside(*set));
        }
        if let Some(set) = [0, all].into_iter().find(|set| !open.contains(set)) {
            return Err(TopologyError::Missing(set));
        }
        for (a, b) in open.iter().flat_map(|a| open.iter().map(move |b| (*a, *b))) {
            if !open.contains(&(a | b)) {
                return Err(TopologyError::Union(a, b));
            }
            if !open.contains(&(a & b)) {
                return Err(TopologyError::Intersection(a, b));
            }
        }
        Ok(FiniteSpace { points, open })
    }

    /// How many points it has.
    pub fn points(&self) -> u32 {
        self.points
    }

    /// X.
    pub fn whole(&self) -> Points {
        whole(self.points)
    }

    /// τ.
    pub fn open(&self) -> &BTreeSet<Points> {
        &self.open
    }

    /// Every decomposition X = A ∪ B with A ∩ B = ∅ and A, B open in X, for a subset X of the space: A = U ∩ X with an
    /// open U. CU-222. The trivial ones, with A or B empty, are among them; (A, B) and (B, A) are two.
    #[doc(alias = "CU-222")]
    pub fn splittings(&self, subset: Points) -> Vec<[Points; 2]> {
        let open: BTreeSet<Points> = self.open.iter().map(|u| u & subset).collect();
        open.iter().filter(|a| open.contains(&(subset & !**a))).map(|a| [*a, subset & !a]).collect()
    }

    /// Whether a subset has no splitting but trivial ones; so ∅ is connected. CU-223.
    #[doc(alias = "CU-223")]
    pub fn is_connected(&self, subset: Points) -> bool {
        self.splittings(subset).iter().all(|[a, b]| *a == 0 || *b == 0)
    }

    /// The union of all connected sets between {x} and the subset: ∅ iff x is not in the subset. CU-224.
    #[doc(alias = "CU-224")]
    pub fn component(&self, x: u32, subset: Points) -> Points {
        let has_x = |set: Points| x < Points::BITS && set >> x & 1 == 1;
        subsets(subset).filter(|set| has_x(*set) && self.is_connected(*set)).fold(0, |union, set| union | set)
    }

    /// Whether a map, by the images of the points, is continuous: the preimage of every open set of the *target* is
    /// open. CU-230.
    ///
    /// # Panics
    /// Iff the map has not one image, a point of the target, for each point.
    #[doc(alias = "CU-230")]
    pub fn is_continuous(&self, map: &[u32], target: &FiniteSpace) -> bool {
        assert!(map.len() == self.points as usize && map.iter().all(|y| *y < target.points), "a map into the target");
        target.open.iter().all(|u| self.open.contains(&preimage(map, *u)))
    }

    /// The same as the text prints it, with the open sets U of the *domain*, whose numbers are read as points of the
    /// target. CU-230.
    ///
    /// # Panics
    /// Iff the map has not one image for each point.
    pub fn is_continuous_printed(&self, map: &[u32]) -> bool {
        assert!(map.len() == self.points as usize, "an image for each point");
        self.open.iter().all(|u| self.open.contains(&preimage(map, *u)))
    }

    /// Whether a map is a homeomorphism: bijective, continuous, its inverse continuous. CU-219.
    ///
    /// # Panics
    /// As [`FiniteSpace::is_continuous`].
    #[doc(alias = "CU-219")]
    pub fn is_homeomorphism(&self, map: &[u32], target: &FiniteSpace) -> bool {
        let inverse: Option<Vec<u32>> = (0..target.points)
            .map(|y| map.iter().position(|image| *image == y).and_then(|x| u32::try_from(x).ok()))
            .collect();
        self.points == target.points
            && self.is_continuous(map, target)
            && inverse.is_some_and(|inverse| target.is_continuous(&inverse, self))
    }
}

/// {0, …, n − 1}.
fn whole(points: u32) -> Points {
    (0..points).fold(0, |set, x| set | 1 << x)
}

/// Every subset of a set.
pub fn subsets(of: Points) -> impl Iterator<Item = Points> {
    (0..=of).filter(move |set| set & !of == 0)
}

fn preimage(map: &[u32], of: Points) -> Points {
    (0..).zip(map).filter(|(_, y)| **y < Points::BITS && of >> **y & 1 == 1).fold(0, |set, (x, _)| set | 1 << x)
}
