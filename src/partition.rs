//! Disjoint sets: which things have been found connected.

/// A partition of 0 … n−1, refined by nothing and coarsened by [`Partition::join`].
#[derive(Clone, Debug)]
pub struct Partition {
    parent: Vec<u32>,
}

impl Partition {
    /// n sets of one element each.
    pub fn new(n: usize) -> Partition {
        Partition { parent: (0..u32::try_from(n).expect("fewer than 2³² elements")).collect() }
    }

    /// The representative of the set that holds i.
    pub fn find(&mut self, i: usize) -> usize {
        let mut i = i as u32;
        while self.parent[i as usize] != i {
            let up = self.parent[self.parent[i as usize] as usize];
            self.parent[i as usize] = up;
            i = up;
        }
        i as usize
    }

    /// Unites the sets of i and j; true if they were different ones. The smaller representative stays.
    pub fn join(&mut self, i: usize, j: usize) -> bool {
        let (i, j) = (self.find(i), self.find(j));
        self.parent[i.max(j)] = i.min(j) as u32;
        i != j
    }

    /// The number of each element's set, sets numbered by their first elements, and how many sets there are.
    pub fn numbered(&mut self) -> (Vec<u32>, usize) {
        let (mut numbers, mut count) = (vec![u32::MAX; self.parent.len()], 0);
        for i in 0..numbers.len() {
            let first = self.find(i);
            if numbers[first] == u32::MAX {
                numbers[first] = count;
                count += 1;
            }
            numbers[i] = numbers[first];
        }
        (numbers, count as usize)
    }
}
