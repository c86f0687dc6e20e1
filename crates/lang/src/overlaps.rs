//! Pairs of objects that may overlap, kept as the sets that a program names: `allowCollide(objects, objects)` of 20,000
//! objects are 200 million pairs.
//!
//! Small products are pairs, looked up by search. Of a large one its two sides are kept. Objects that are on the same sides
//! of the same products form a class, so what holds of many pairs is asked once for two classes.

use crate::program::ObjectId;
use rustc_hash::FxHashMap;
use std::collections::BTreeSet;

/// A product of two sets with no more pairs than this is kept as pairs.
const SMALL: usize = 256;

/// Pairs of objects that may overlap.
#[derive(Clone, Debug, Default)]
pub struct Overlaps {
    /// Smaller id first, sorted, each once.
    pairs: Vec<(ObjectId, ObjectId)>,
    /// The sides of the large products, each sorted.
    products: BTreeSet<[Vec<ObjectId>; 2]>,
    classes: Vec<Class>,
    class_of: FxHashMap<ObjectId, usize>,
}

/// Objects that are on the same sides of the same products.
#[derive(Clone, Debug)]
struct Class {
    /// Twice the number of a product, and one more for its second side; sorted.
    sides: Vec<usize>,
    members: Vec<ObjectId>,
}

impl Class {
    /// Whether one side of a product is here and the other there.
    fn meets(&self, other: &Self) -> bool {
        self.sides.iter().any(|side| other.sides.binary_search(&(side ^ 1)).is_ok())
    }
}

impl Overlaps {
    /// Adds each pair of one of `a` with another one of `b`; [`Overlaps::finish`] comes after the last.
    pub(crate) fn add(&mut self, a: &[ObjectId], b: &[ObjectId]) {
        if a.len().saturating_mul(b.len()) <= SMALL {
            for &x in a {
                self.pairs.extend(b.iter().filter(|y| **y != x).map(|&y| (x.min(y), x.max(y))));
            }
            return;
        }
        let mut sides = [a.to_vec(), b.to_vec()];
        sides.iter_mut().for_each(|side| {
            side.sort_unstable();
            side.dedup();
        });
        sides.sort_unstable();
        self.products.insert(sides);
    }

    /// Orders what was added, so that it can be asked.
    pub(crate) fn finish(&mut self) {
        self.pairs.sort_unstable();
        self.pairs.dedup();
        let mut sides_of: FxHashMap<ObjectId, Vec<usize>> = FxHashMap::default();
        for (number, sides) in self.products.iter().enumerate() {
            for (side, objects) in sides.iter().enumerate() {
                for object in objects {
                    sides_of.entry(*object).or_default().push(2 * number + side);
                }
            }
        }
        let mut objects: Vec<(Vec<usize>, ObjectId)> =
            sides_of.into_iter().map(|(object, sides)| (sides, object)).collect();
        objects.sort_unstable();
        for (sides, object) in objects {
            if self.classes.last().is_none_or(|class| class.sides != sides) {
                self.classes.push(Class { sides, members: Vec::new() });
            }
            self.class_of.insert(object, self.classes.len() - 1);
            if let Some(class) = self.classes.last_mut() {
                class.members.push(object);
            }
        }
    }

    /// Whether two objects may overlap.
    pub fn contains(&self, a: ObjectId, b: ObjectId) -> bool {
        a != b && (self.pairs.binary_search(&(a.min(b), a.max(b))).is_ok() || self.in_products(a, b))
    }

    fn in_products(&self, a: ObjectId, b: ObjectId) -> bool {
        match (self.class_of.get(&a), self.class_of.get(&b)) {
            (Some(&a), Some(&b)) => self.classes[a].meets(&self.classes[b]),
            _ => false,
        }
    }

    /// Whether nothing may overlap.
    pub fn is_empty(&self) -> bool {
        self.pairs.is_empty() && self.products.is_empty()
    }

    /// Objects that may overlap others, sorted.
    pub fn objects(&self) -> Vec<ObjectId> {
        let mut out: Vec<ObjectId> = self.pairs.iter().flat_map(|(a, b)| [*a, *b]).collect();
        out.extend(self.class_of.keys());
        out.sort_unstable();
        out.dedup();
        out
    }

    /// How many pairs there are of objects that pass.
    pub fn count(&self, passes: impl Fn(ObjectId) -> bool) -> usize {
        let few = self.pairs.iter().filter(|(a, b)| passes(*a) && passes(*b) && !self.in_products(*a, *b)).count();
        let sizes: Vec<usize> =
            self.classes.iter().map(|class| class.members.iter().filter(|o| passes(**o)).count()).collect();
        let mut many = 0;
        for (i, class) in self.classes.iter().enumerate() {
            if class.meets(class) {
                many += sizes[i] * sizes[i].saturating_sub(1) / 2;
            }
            let others = (i + 1..self.classes.len()).filter(|&k| class.meets(&self.classes[k]));
            many += others.map(|k| sizes[i] * sizes[k]).sum::<usize>();
        }
        few + many
    }

    /// All pairs, smaller id first, each once: as many as there are.
    pub fn iter(&self) -> impl Iterator<Item = (ObjectId, ObjectId)> + '_ {
        let objects = self.objects();
        let n = objects.len();
        (0..n)
            .flat_map(move |i| (i + 1..n).map(move |k| (i, k)))
            .map(move |(i, k)| (objects[i], objects[k]))
            .filter(|(a, b)| self.contains(*a, *b))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ids(range: std::ops::Range<u32>) -> Vec<ObjectId> {
        range.map(ObjectId).collect()
    }

    fn made(products: &[[std::ops::Range<u32>; 2]]) -> Overlaps {
        let mut out = Overlaps::default();
        for [a, b] in products {
            out.add(&ids(a.clone()), &ids(b.clone()));
        }
        out.finish();
        out
    }

    #[test]
    fn they_are_the_pairs_of_the_products() {
        let cases: [&[[std::ops::Range<u32>; 2]]; 6] = [
            &[],
            &[[0..2, 1..4]],
            &[[0..40, 0..40]],
            &[[0..30, 20..60], [50..60, 0..60]],
            &[[0..100, 0..3], [0..2, 0..2], [90..100, 90..100]],
            &[[0..20, 40..60], [20..40, 0..20], [0..60, 59..60]],
        ];
        for products in cases {
            let overlaps = made(products);
            let mut expected = BTreeSet::new();
            for [a, b] in products {
                for (x, y) in a.clone().flat_map(|x| b.clone().map(move |y| (x, y))).filter(|(x, y)| x != y) {
                    expected.insert((ObjectId(x.min(y)), ObjectId(x.max(y))));
                }
            }
            assert_eq!(
                overlaps.iter().collect::<Vec<_>>(),
                expected.iter().copied().collect::<Vec<_>>(),
                "{products:?}"
            );
            for passes in [|_: ObjectId| true, |o: ObjectId| !o.0.is_multiple_of(3)] {
                let those = expected.iter().filter(|(a, b)| passes(*a) && passes(*b)).count();
                assert_eq!(overlaps.count(passes), those, "{products:?}");
            }
            assert_eq!(overlaps.is_empty(), expected.is_empty());
        }
    }

    #[test]
    fn many_objects_are_few_classes() {
        let overlaps = made(&[[0..20_000, 0..20_000], [0..10_000, 5_000..20_000], [0..20_000, 0..20_000]]);
        assert_eq!((overlaps.products.len(), overlaps.classes.len(), overlaps.pairs.len()), (2, 3, 0));
        assert_eq!(overlaps.count(|_| true), 20_000 * 19_999 / 2);
    }
}
