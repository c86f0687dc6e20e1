//! One-to-one pairing with the greatest sum of weights: the Hungarian method, with potentials, in O(rows² · columns).

/// The partner of each row; pairs of weight 0 or less are none. `weights[row][column]`, all rows equally long.
pub fn pair(weights: &[Vec<i64>]) -> Vec<Option<usize>> {
    let (rows, columns) = (weights.len(), weights.first().map_or(0, Vec::len));
    let n = rows.max(columns);
    // Least cost; columns that are missing weigh nothing, so that each row gets one. Index 0 stands for "none".
    let cost = |row: usize, column: usize| -> i64 {
        weights.get(row - 1).and_then(|r| r.get(column - 1)).map_or(0, |w| -(*w).max(0))
    };
    let (mut u, mut v) = (vec![0_i64; rows + 1], vec![0_i64; n + 1]);
    let (mut partner, mut way) = (vec![0_usize; n + 1], vec![0_usize; n + 1]);
    for row in 1..=rows {
        partner[0] = row;
        let mut column = 0;
        let mut least = vec![i64::MAX; n + 1];
        let mut seen = vec![false; n + 1];
        while partner[column] != 0 {
            seen[column] = true;
            let from = partner[column];
            let (mut step, mut next) = (i64::MAX, 0);
            for j in (1..=n).filter(|j| !seen[*j]) {
                let reduced = cost(from, j) - u[from] - v[j];
                if reduced < least[j] {
                    (least[j], way[j]) = (reduced, column);
                }
                if least[j] < step {
                    (step, next) = (least[j], j);
                }
            }
            for j in 0..=n {
                if seen[j] {
                    u[partner[j]] += step;
                    v[j] -= step;
                } else if j > 0 {
                    least[j] -= step;
                }
            }
            column = next;
        }
        while column != 0 {
            partner[column] = partner[way[column]];
            column = way[column];
        }
    }
    let mut out = vec![None; rows];
    for column in 1..=columns {
        let row = partner[column];
        if (1..=rows).contains(&row) && weights[row - 1][column - 1] > 0 {
            out[row - 1] = Some(column - 1);
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pairs() {
        assert_eq!(pair(&[]), []);
        assert_eq!(pair(&[vec![], vec![]]), [None, None]);
        assert_eq!(pair(&[vec![0, 3]]), [Some(1)]);
        // The greedy choice (9) would leave the second row without one.
        assert_eq!(pair(&[vec![9, 8], vec![7, 0]]), [Some(1), Some(0)]);
        assert_eq!(pair(&[vec![1], vec![2], vec![0]]), [None, Some(0), None]);
    }

    #[test]
    fn as_good_as_trying_all() {
        let mut state = 7_u64;
        let mut draw = || {
            state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            ((state >> 33) % 6) as i64
        };
        for _ in 0..200 {
            let weights: Vec<Vec<i64>> = (0..4).map(|_| (0..5).map(|_| draw()).collect()).collect();
            let found = pair(&weights);
            let sum: i64 = found.iter().enumerate().filter_map(|(r, c)| c.map(|c| weights[r][c])).sum();
            assert_eq!(sum, best(&weights, 0, 0), "{weights:?}");
        }
    }

    fn best(weights: &[Vec<i64>], row: usize, used: u32) -> i64 {
        if row == weights.len() {
            return 0;
        }
        let free = (0..weights[row].len()).filter(|c| used & (1 << c) == 0);
        free.map(|c| weights[row][c] + best(weights, row + 1, used | 1 << c))
            .chain([best(weights, row + 1, used)])
            .max()
            .unwrap_or(0)
    }
}
