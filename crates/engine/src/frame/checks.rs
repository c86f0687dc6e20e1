//! Everything that can be violated, by one index: terms, pairs that may not overlap, objects that need room and rest.

use scenelang_lang::program::ObjectId;

/// Something that can be violated.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Check {
    /// A stated term: an index into `Frame::terms`.
    Term(usize),
    /// P-COLLIDE of two objects, smaller id first.
    Collide(ObjectId, ObjectId),
    /// P-BOUNDS of an object.
    Bounds(ObjectId),
    /// P-SUPPORT of an object.
    Support(ObjectId),
}

/// How checks are numbered: terms, then bounds, support, pairs.
#[derive(Clone, Copy, Debug)]
pub struct Numbering {
    terms: usize,
    objects: usize,
}

impl Numbering {
    /// For so many terms and objects.
    pub fn new(terms: usize, objects: usize) -> Self {
        Self { terms, objects }
    }
    /// How many checks there are.
    pub fn len(&self) -> usize {
        self.terms + 2 * self.objects + self.objects * self.objects.saturating_sub(1) / 2
    }
    /// Whether nothing can be violated.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
    /// The index of P-BOUNDS of an object.
    pub fn bounds(&self, id: ObjectId) -> usize {
        self.terms + id.0 as usize
    }
    /// The index of P-SUPPORT of an object.
    pub fn support(&self, id: ObjectId) -> usize {
        self.terms + self.objects + id.0 as usize
    }
    /// The index of P-COLLIDE of two objects.
    pub fn collide(&self, a: ObjectId, b: ObjectId) -> usize {
        let (low, high) = (a.min(b).0 as usize, a.max(b).0 as usize);
        self.terms + 2 * self.objects + high * (high - 1) / 2 + low
    }
    pub fn check(&self, index: usize) -> Check {
        let object = |i: usize| ObjectId(i as u32);
        let Some(rest) = index.checked_sub(self.terms) else { return Check::Term(index) };
        let Some(rest) = rest.checked_sub(self.objects) else { return Check::Bounds(object(rest)) };
        let Some(rest) = rest.checked_sub(self.objects) else { return Check::Support(object(rest)) };
        // The greatest `high` with high (high - 1) / 2 <= rest.
        let mut high = ((1.0 + (1.0 + 8.0 * rest as f64).sqrt()) / 2.0) as usize;
        while high * (high - 1) / 2 > rest {
            high -= 1;
        }
        while (high + 1) * high / 2 <= rest {
            high += 1;
        }
        Check::Collide(object(rest - high * (high - 1) / 2), object(high))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_and_checks_agree() {
        let numbering = Numbering::new(3, 7);
        assert_eq!(numbering.len(), 3 + 14 + 21);
        for index in 0..numbering.len() {
            let back = match numbering.check(index) {
                Check::Term(t) => t,
                Check::Collide(a, b) => {
                    assert!(a < b);
                    numbering.collide(b, a)
                }
                Check::Bounds(a) => numbering.bounds(a),
                Check::Support(a) => numbering.support(a),
            };
            assert_eq!(back, index);
        }
    }
}
