//! Which cells of a floor are reached from some of them, a row of cells at a time: a plan asks for it very often.

/// So many cells are in a word.
const WORD: usize = 64;

/// Cells in rows, each there or not.
#[derive(Clone, Debug, PartialEq)]
pub struct Cells {
    columns: usize,
    rows: usize,
    /// Words in a row.
    words: usize,
    bits: Vec<u64>,
}

impl Cells {
    /// All of them there.
    pub fn all(columns: usize, rows: usize) -> Self {
        let mut cells = Self::none(columns, rows);
        for j in 0..rows {
            for (k, word) in cells.bits[j * cells.words..][..cells.words].iter_mut().enumerate() {
                *word = below(columns - k * WORD);
            }
        }
        cells
    }

    /// None of them there.
    fn none(columns: usize, rows: usize) -> Self {
        let words = columns.div_ceil(WORD);
        Self { columns, rows, words, bits: vec![0; words * rows] }
    }

    /// Whether a cell is there.
    pub fn has(&self, i: usize, j: usize) -> bool {
        i < self.columns && j < self.rows && self.bits[j * self.words + i / WORD] >> (i % WORD) & 1 == 1
    }

    /// Adds a cell.
    fn add(&mut self, i: usize, j: usize) {
        self.bits[j * self.words + i / WORD] |= 1 << (i % WORD);
    }

    /// Takes those of a row away that are in a range of columns.
    pub fn take(&mut self, j: usize, from: usize, to: usize) {
        for k in from / WORD..to.div_ceil(WORD).min(self.words) {
            let first = k * WORD;
            let within = below(to.saturating_sub(first)) & !below(from.saturating_sub(first));
            self.bits[j * self.words + k] &= !within;
        }
    }

    /// Those that are reached from some cells by steps to the sides.
    pub fn reached(&self, from: impl IntoIterator<Item = (usize, usize)>) -> Self {
        let mut seen = Self::none(self.columns, self.rows);
        from.into_iter().filter(|(i, j)| self.has(*i, *j)).for_each(|(i, j)| seen.add(i, j));
        for j in 0..self.rows {
            self.along(&mut seen, j);
        }
        let mut changed = true;
        while changed {
            changed = false;
            for j in 1..self.rows {
                changed |= self.across(&mut seen, j - 1, j);
            }
            for j in (1..self.rows).rev() {
                changed |= self.across(&mut seen, j, j - 1);
            }
        }
        seen
    }

    /// Steps from a row to one beside it, and along that; whether any was new.
    fn across(&self, seen: &mut Self, from: usize, to: usize) -> bool {
        let mut new = false;
        for k in 0..self.words {
            let open = self.bits[to * self.words + k];
            let met = seen.bits[from * self.words + k] & open;
            let own = &mut seen.bits[to * self.words + k];
            new |= met & !*own != 0;
            *own |= met;
        }
        if new {
            self.along(seen, to);
        }
        new
    }

    /// Steps along a row.
    fn along(&self, seen: &mut Self, j: usize) {
        let row = j * self.words;
        let mut spread_in = |k: usize, entered: u64| {
            let open = self.bits[row + k];
            seen.bits[row + k] = spread(open, seen.bits[row + k] | entered & open);
            seen.bits[row + k]
        };
        let mut last = 0;
        for k in 0..self.words {
            last = spread_in(k, last >> (WORD - 1));
        }
        last = 0;
        for k in (0..self.words).rev() {
            last = spread_in(k, (last & 1) << (WORD - 1));
        }
    }
}

/// A word of which the first so many cells are there.
fn below(n: usize) -> u64 {
    if n >= WORD { u64::MAX } else { (1 << n) - 1 }
}

/// What of the open cells of a word is reached from some of them.
fn spread(open: u64, seen: u64) -> u64 {
    let (mut up, mut down, mut through, mut back) = (seen, seen, open, open);
    for step in [1, 2, 4, 8, 16, 32] {
        up |= through & (up << step);
        through &= through << step;
        down |= back & (down >> step);
        back &= back >> step;
    }
    up | down
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The same, a cell at a time.
    fn one_by_one(cells: &Cells, from: &[(usize, usize)]) -> Cells {
        let mut seen = Cells::none(cells.columns, cells.rows);
        let mut open: Vec<(usize, usize)> = from.to_vec();
        while let Some((i, j)) = open.pop() {
            if cells.has(i, j) && !seen.has(i, j) {
                seen.add(i, j);
                open.extend([(i + 1, j), (i.wrapping_sub(1), j), (i, j + 1), (i, j.wrapping_sub(1))]);
            }
        }
        seen
    }

    #[test]
    fn rows_of_cells_are_reached_as_cells_are_one_by_one() {
        let mut state = 7_u64;
        let mut draw = |n: usize| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) as usize % n
        };
        for (columns, rows) in [(0, 0), (1, 1), (40, 30), (63, 9), (64, 20), (65, 20), (130, 40), (200, 3)] {
            for bars in [0, 5, 20, 60, 200] {
                let mut cells = Cells::all(columns, rows);
                for _ in 0..bars.min(columns * rows) {
                    let (j, from) = (draw(rows), draw(columns));
                    cells.take(j, from, (from + draw(columns + 1)).min(columns));
                }
                let from: Vec<(usize, usize)> =
                    (0..3).filter(|_| columns * rows > 0).map(|_| (draw(columns), draw(rows))).collect();
                assert_eq!(cells.reached(from.clone()), one_by_one(&cells, &from), "{columns} x {rows}, {bars} bars");
            }
        }
    }
}
