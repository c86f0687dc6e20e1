//! The two-sample energy test: whether two sets of points can come from one distribution, by how much further points are
//! from those of the other set than from those of their own (Székely and Rizzo 2004), against random partitions.

/// The chance that two samples of one distribution differ as much as these do: the part of `times` random partitions, fixed
/// by their number, with at least the same statistic.
pub fn distance_test(a: &[Vec<f64>], b: &[Vec<f64>], times: usize) -> f64 {
    let all: Vec<&Vec<f64>> = a.iter().chain(b).collect();
    let n = all.len();
    let apart = |p: &[f64], q: &[f64]| p.iter().zip(q).map(|(x, y)| (x - y) * (x - y)).sum::<f64>().sqrt();
    let distances: Vec<f32> = (0..n * n).map(|i| apart(all[i / n], all[i % n]) as f32).collect();
    let mut order: Vec<usize> = (0..n).collect();
    let first = statistic(&distances, &order, a.len());
    let mut state = 1u64;
    let mut as_far = 1;
    for _ in 0..times {
        for i in (1..n).rev() {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            order.swap(i, ((state >> 33) % (i as u64 + 1)) as usize);
        }
        as_far += usize::from(statistic(&distances, &order, a.len()) >= first);
    }
    as_far as f64 / (times + 1) as f64
}

fn statistic(distances: &[f32], order: &[usize], split: usize) -> f64 {
    let n = order.len();
    let (first, second) = order.split_at(split);
    let mean = |rows: &[usize], columns: &[usize]| {
        let sum: f64 = rows.iter().map(|i| columns.iter().map(|j| f64::from(distances[i * n + j])).sum::<f64>()).sum();
        sum / (rows.len() * columns.len()) as f64
    };
    2.0 * mean(first, second) - mean(first, first) - mean(second, second)
}

#[test]
fn it_tells_what_differs_from_what_does_not() {
    let points = |from: u64, shift: f64| -> Vec<Vec<f64>> {
        let unit = |i: u64| (i.wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 11) as f64 / (1u64 << 53) as f64;
        (from..from + 150).map(|i| vec![unit(i) + shift, unit(i + 100_000)]).collect()
    };
    assert!(distance_test(&points(0, 0.0), &points(5000, 0.0), 200) > 0.05);
    assert!(distance_test(&points(0, 0.0), &points(5000, 0.25), 200) < 0.01);
}
