//! Which objects may be where something comes to be: square cells over the floor, each with the objects whose upright boxes
//! meet it. What is outside of all rooms is in the cells at their edge.

use super::{Field, Span, TOUCHING};

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
    /// All of them, where there is one cell only.
    row: Option<Row>,
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
        let size = extent.map(|far| (far / cell).ceil() as usize);
        let row = (objects < MANY).then(|| Row::new(objects));
        let cells = vec![Vec::new(); size[0] * size[1]];
        Self { from: field.min, cell, size, cells, row, at: vec![None; objects], found: vec![0; objects], now: 0 }
    }

    /// Nothing is anywhere.
    pub fn clear(&mut self) {
        self.cells.iter_mut().for_each(Vec::clear);
        self.at.fill(None);
        if let Some(row) = &mut self.row {
            row.clear();
        }
    }

    /// The box of an object is elsewhere in a trial. Only where there is one cell does it count from now on.
    pub fn follow(&mut self, i: usize, span: &Span) {
        if let Some(row) = &mut self.row {
            row.follow(i, span);
        }
    }

    /// An object is there now.
    pub fn set(&mut self, i: usize, span: &Span) {
        if let Some(row) = &mut self.row {
            return row.set(i, span);
        }
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
        if let Some(row) = &mut self.row {
            return row.around(span, boxes, out);
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

    /// Objects that may be over a point of the floor, as far as they have not moved in a trial; `None`: all may be, as there are
    /// few.
    pub fn at(&self, [x, z]: [f64; 2]) -> Option<&[usize]> {
        if self.row.is_some() {
            return None;
        }
        let [[column, _], [line, _]] = self.range(&Span { min: [x, 0.0, z], max: [x, 0.0, z] });
        self.cells.get(line * self.size[0] + column).map(Vec::as_slice)
    }

    fn range(&self, span: &Span) -> [[usize; 2]; 2] {
        let cell = |k: usize, at: f64| (((at - self.from[k]) / self.cell).max(0.0) as usize).min(self.size[k] - 1);
        [(0, 0), (1, 2)].map(|(k, axis)| [cell(k, span.min[axis]), cell(k, span.max[axis])])
    }
}

/// Few objects, all of which are looked at: the sides of their boxes in rows of numbers, so that several are held against
/// another box at once.
struct Row {
    /// Who is there, in the order in which they came.
    ids: Vec<usize>,
    /// By object: where it stands in that order; `usize::MAX`: it is not there.
    at: Vec<usize>,
    /// The least x and z, by that order.
    low: [Vec<f64>; 2],
    /// The greatest, a touch less.
    high: [Vec<f64>; 2],
    /// Whether each met the last box, seen from above.
    met: Vec<u8>,
}

impl Row {
    fn new(objects: usize) -> Self {
        let (low, high) = Default::default();
        Self { ids: Vec::new(), at: vec![usize::MAX; objects], low, high, met: Vec::new() }
    }

    fn clear(&mut self) {
        self.ids.clear();
        self.at.fill(usize::MAX);
        self.low.iter_mut().chain(&mut self.high).for_each(Vec::clear);
    }

    fn follow(&mut self, i: usize, span: &Span) {
        let at = self.at[i];
        if at != usize::MAX {
            for (k, axis) in [(0, 0), (1, 2)] {
                self.low[k][at] = span.min[axis];
                self.high[k][at] = span.max[axis] - TOUCHING;
            }
        }
    }

    fn set(&mut self, i: usize, span: &Span) {
        let is_there = span.min[0] <= span.max[0];
        let at = self.at[i];
        if is_there && at == usize::MAX {
            self.at[i] = self.ids.len();
            self.ids.push(i);
            self.low.iter_mut().chain(&mut self.high).for_each(|side| side.push(0.0));
        } else if !is_there && at != usize::MAX {
            self.ids.remove(at);
            self.at[i] = usize::MAX;
            self.ids[at..].iter().for_each(|&k| self.at[k] -= 1);
            self.low.iter_mut().chain(&mut self.high).for_each(|side| {
                side.remove(at);
            });
        }
        self.follow(i, span);
    }

    fn around(&mut self, span: &Span, boxes: &[Span], out: &mut Vec<usize>) -> usize {
        let Self { ids, low: [left, near], high: [right, far], met, .. } = self;
        let (least, most) = (span.min, span.max.map(|side| side - TOUCHING));
        met.resize(ids.len(), 0);
        let sides = left.iter().zip(right.iter()).zip(near.iter().zip(far.iter()));
        for (met, ((left, right), (near, far))) in met.iter_mut().zip(sides) {
            *met = u8::from((least[0] < *right) & (*left < most[0]) & (least[2] < *far) & (*near < most[2]));
        }
        for (met, ids) in met.chunks(8).zip(ids.chunks(8)) {
            if met.iter().fold(0, |any, met| any | met) != 0 {
                let found = met.iter().zip(ids).filter(|(met, _)| **met != 0).map(|(_, i)| *i);
                out.extend(found.filter(|&i| span.meets(&boxes[i])));
            }
        }
        ids.len()
    }
}

fn within([row, _]: [usize; 2], [x, z]: [[usize; 2]; 2]) -> impl Iterator<Item = usize> {
    (z[0]..=z[1]).flat_map(move |z| (x[0]..=x[1]).map(move |x| z * row + x))
}

#[cfg(test)]
mod tests {
    use super::{Field, MANY, Near, Span};

    #[test]
    fn what_is_over_a_point_is_found_in_its_cell() {
        let mut near = Near::new(Some(Field { min: [-3.0, 1.0], max: [9.0, 5.0] }), MANY);
        let boxes: Vec<Span> = (0..MANY)
            .map(|i| {
                let [x, z] = [-4.0 + 0.17 * i as f64, 0.5 + 0.6 * (i % 9) as f64];
                Span { min: [x, 0.0, z], max: [x + 0.9, 1.0, z + 0.4] }
            })
            .collect();
        boxes.iter().enumerate().for_each(|(i, span)| near.set(i, span));
        for span in &boxes {
            for [x, z] in [[span.min[0], span.max[2]], [span.max[0], span.min[2]]] {
                let over =
                    |span: &&Span| (span.min[0]..=span.max[0]).contains(&x) && (span.min[2]..=span.max[2]).contains(&z);
                let found = near.at([x, z]).unwrap_or_default();
                let missing = boxes.iter().enumerate().find(|(i, span)| over(span) && !found.contains(i));
                assert!(missing.is_none(), "over {x}, {z}: {missing:?} is not among {found:?}");
            }
        }
    }
}
