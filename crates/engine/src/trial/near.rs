//! Which objects may be where something comes to be: square cells over the floor, each with the objects whose upright boxes
//! meet it. What is outside of all rooms is in the cells at their edge.

use super::{Field, Span};

/// The side of a cell is between these (metres).
const CELL: [f64; 2] = [0.5, 4.0];
/// Fewer objects than these are in one cell: to go through all of them is faster.
const MANY: usize = 80;
/// Objects by where they are.
pub struct Near {
    from: [f64; 2],
    cell: f64,
    size: [usize; 2],
    cells: Vec<Vec<usize>>,
    /// By object: the first and the last of its cells, along x and z; `None`: it is nowhere.
    at: Vec<Option<[[usize; 2]; 2]>>,
    /// By object: when it was last found.
    found: Vec<u32>,
    now: u32,
}

impl Near {
    /// For so many objects, none of which is anywhere yet.
    pub fn new(field: Option<Field>, objects: usize) -> Self {
        let field = field.unwrap_or(Field { min: [0.0; 2], max: [1.0; 2] });
        let extent = [0, 1].map(|k| (field.max[k] - field.min[k]).clamp(CELL[0], 1e4));
        let cell = (extent[0] * extent[1] / objects.max(1) as f64).sqrt().clamp(CELL[0], CELL[1]);
        let size = if objects < MANY { [1; 2] } else { extent.map(|far| (far / cell).ceil() as usize) };
        let cells = vec![Vec::new(); size[0] * size[1]];
        Self { from: field.min, cell, size, cells, at: vec![None; objects], found: vec![0; objects], now: 0 }
    }

    /// Nothing is anywhere.
    pub fn clear(&mut self) {
        self.cells.iter_mut().for_each(Vec::clear);
        self.at.fill(None);
    }

    /// An object is there now.
    pub fn set(&mut self, i: usize, span: &Span) {
        let new = (span.min[0] <= span.max[0]).then(|| self.range(span));
        let old = std::mem::replace(&mut self.at[i], new);
        if old == new {
            return;
        }
        let size = self.size;
        for c in old.into_iter().flat_map(|range| within(size, range)) {
            self.cells[c].retain(|k| *k != i);
        }
        for c in new.into_iter().flat_map(|range| within(size, range)) {
            self.cells[c].push(i);
        }
    }

    /// Objects whose box, of these, meets another, into `out`, each once. How many were looked at.
    pub fn around(&mut self, span: &Span, boxes: &[Span], out: &mut Vec<usize>) -> usize {
        out.clear();
        if span.min[0] > span.max[0] {
            return 0;
        }
        if let [all] = &self.cells[..] {
            // Without a branch for each: whether a box is met is hard to foresee.
            out.resize(all.len(), 0);
            let mut count = 0;
            for &i in all {
                out[count] = i;
                count += usize::from(span.meets(&boxes[i]));
            }
            out.truncate(count);
            return all.len();
        }
        self.now = self.now.wrapping_add(1);
        let mut looked = 0;
        for c in within(self.size, self.range(span)) {
            looked += self.cells[c].len();
            for &i in &self.cells[c] {
                if span.meets(&boxes[i]) && std::mem::replace(&mut self.found[i], self.now) != self.now {
                    out.push(i);
                }
            }
        }
        looked
    }

    fn range(&self, span: &Span) -> [[usize; 2]; 2] {
        let cell = |k: usize, at: f64| (((at - self.from[k]) / self.cell).max(0.0) as usize).min(self.size[k] - 1);
        [(0, 0), (1, 2)].map(|(k, axis)| [cell(k, span.min[axis]), cell(k, span.max[axis])])
    }
}

fn within([row, _]: [usize; 2], [x, z]: [[usize; 2]; 2]) -> impl Iterator<Item = usize> {
    (z[0]..=z[1]).flat_map(move |z| (x[0]..=x[1]).map(move |x| z * row + x))
}
