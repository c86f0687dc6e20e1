//! Which objects come near each other, as far as that may be asked: in a layout of strangers all may be in one place.

use crate::number::Number;
use crate::world::{Body, World};
use rustc_hash::FxHashMap;
use scenelang_lang::program::ObjectId;
use scenelang_layout::{Aabb, broad};
use std::ops::ControlFlow;

/// Finding the pairs compares no more than so many upright boxes (about a nanosecond each).
const COMPARED: usize = 1_000_000_000;
/// What looking for everything above and below objects may cost, in looks at one object.
const LOOKS: usize = 2_000_000;
/// So many comparisons of upright boxes cost as much as a look.
const CHEAP: usize = 16;

/// Pairs of objects whose upright boxes are at most `distance` apart, smaller id first, sorted.
pub fn pairs_within<N: Number>(world: &World<N>, distance: f64) -> Vec<(ObjectId, ObjectId)> {
    let (ids, boxes): (Vec<ObjectId>, Vec<Aabb>) = world.bodies().map(|(id, body)| (id, body.aabb())).unzip();
    let pairs = broad::pairs_within(&boxes, distance).into_iter();
    pairs.map(|(i, j)| (ids[i as usize], ids[j as usize])).collect()
}

/// Pairs that are near each other, or the first of them.
#[derive(Debug)]
pub struct Near {
    /// Smaller id first, sorted.
    pub pairs: Vec<(ObjectId, ObjectId)>,
    /// Whether these are all.
    pub complete: bool,
}

/// The same pairs as [`pairs_within`], as far as measuring the gaps of them costs no more than `most`: 1 for two boxes,
/// more for solids of many corners.
pub fn pairs_up_to<N: Number>(world: &World<N>, distance: f64, most: usize) -> Near {
    let (ids, boxes): (Vec<ObjectId>, Vec<Aabb>) = world.bodies().map(|(id, body)| (id, body.aabb())).unzip();
    let weights: Vec<usize> = world.bodies().map(|(_, body)| weight(body)).collect();
    let (mut pairs, mut left) = (Vec::new(), most);
    let complete = broad::visit_within(&boxes, distance, COMPARED, |i, j| {
        let (i, j) = (i as usize, j as usize);
        match left.checked_sub(weights[i] * weights[j]) {
            Some(rest) => left = rest,
            None => return ControlFlow::Break(()),
        }
        pairs.push((ids[i], ids[j]));
        ControlFlow::Continue(())
    });
    pairs.sort_unstable();
    Near { pairs, complete }
}

/// What a body counts in the gaps it has: 1 for a box.
fn weight(body: &Body) -> usize {
    const BOX: usize = 8;
    match body.parts() {
        Some(parts) => parts.iter().map(|part| part.vertices().len()).sum::<usize>().div_ceil(BOX).max(1),
        None => 1,
    }
}

/// What stands over or under objects, at any height; it answers until it has had enough.
#[derive(Debug)]
pub struct Columns {
    /// By where they begin along x.
    sorted: Vec<(f64, ObjectId, Aabb)>,
    places: FxHashMap<ObjectId, usize>,
    /// The greatest extent along x (metres).
    widest: f64,
    looks: usize,
}

impl Columns {
    /// Of the objects in an instance.
    pub fn new<N: Number>(world: &World<N>) -> Self {
        let mut sorted: Vec<(f64, ObjectId, Aabb)> =
            world.bodies().map(|(id, body)| (body.aabb(), id)).map(|(around, id)| (around.min.x, id, around)).collect();
        sorted.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let widest = sorted.iter().map(|(.., b)| b.max.x - b.min.x).fold(0.0, f64::max);
        let places = sorted.iter().enumerate().map(|(place, (_, id, _))| (*id, place)).collect();
        Self { sorted, places, widest, looks: LOOKS }
    }

    /// All other objects that are over or under one, by id; `None`: too much has been asked already.
    pub fn of(&mut self, id: ObjectId) -> Option<Vec<ObjectId>> {
        let Some(place) = self.places.get(&id) else { return Some(Vec::new()) };
        let own = self.sorted[*place].2;
        let first = self.sorted.partition_point(|(x, ..)| *x < own.min.x - self.widest);
        let reaching = self.sorted[first..].iter().take_while(|(x, ..)| *x <= own.max.x);
        let mut compared = 0;
        let mut found: Vec<ObjectId> = reaching
            .inspect(|_| compared += 1)
            .filter(|(_, other, b)| {
                *other != id && own.min.x <= b.max.x && b.min.z <= own.max.z && own.min.z <= b.max.z
            })
            .map(|(_, other, _)| *other)
            .collect();
        self.looks = self.looks.checked_sub(1 + found.len() + compared / CHEAP)?;
        found.sort_unstable();
        Some(found)
    }
}
