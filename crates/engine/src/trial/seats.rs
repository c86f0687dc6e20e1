//! What stands on what while objects move: each object with its seat, and each seat with its riders.

/// Who stands on whom, by index of the object. It changes only when a trial is kept.
pub(super) struct Seats {
    /// By object: what it stands on, if that is not a floor.
    on: Vec<Option<usize>>,
    /// By object: what stands on it, in order.
    riders: Vec<Vec<usize>>,
}

impl Seats {
    /// So many objects, all of them on a floor.
    pub(super) fn new(objects: usize) -> Self {
        Self { on: vec![None; objects], riders: vec![Vec::new(); objects] }
    }

    /// What stands on an object, in order.
    pub(super) fn riders(&self, i: usize) -> &[usize] {
        &self.riders[i]
    }

    /// An object stands on another from now on, or on a floor.
    pub(super) fn sit(&mut self, i: usize, seat: Option<usize>) {
        let old = std::mem::replace(&mut self.on[i], seat);
        if old == seat {
            return;
        }
        if let Some(old) = old {
            self.riders[old].retain(|k| *k != i);
        }
        if let Some(new) = seat {
            let at = self.riders[new].partition_point(|k| *k < i);
            self.riders[new].insert(at, i);
        }
    }
}
