//! The best plan that is found: from several orders of the rooms, each made better by swapping two rooms or moving one, as
//! long as that helps. The work is counted, and nothing is left to chance.

use super::cost::cost;
use super::rows::{Cell, Order, Rect, place};

/// How deep the first row is tried (metres).
const TRIED: [f64; 10] = [1.9, 2.2, 2.6, 3.0, 3.4, 3.8, 4.2, 4.6, 5.2, 6.0];
/// So many plans are looked at.
const PLANS: usize = 200_000;
/// So many orders are begun with.
const BEGUN: usize = 72;
/// At the end of the hub stand at most so many rooms.
const END: usize = 2;

/// A plan and what is wrong with it.
#[derive(Clone, Debug)]
pub struct FoundPlan {
    /// Where each room is.
    pub rects: Vec<Rect>,
    /// How bad it is.
    pub cost: f64,
}

/// Looks for a plan.
pub fn search(cells: &[Cell], hub: usize, links: &[(usize, usize)]) -> Option<FoundPlan> {
    let rooms: Vec<usize> = (0..cells.len()).filter(|room| *room != hub).collect();
    let mut looked_at = 0;
    let mut best: Option<FoundPlan> = None;
    for start in 0..BEGUN {
        let mut order = begin(&rooms, cells, start);
        let mut found = judge(cells, hub, &order, links, &mut looked_at);
        loop {
            let mut better: Option<(Order, FoundPlan)> = None;
            for next in neighbours(&order) {
                let Some(now) = judge(cells, hub, &next, links, &mut looked_at) else { continue };
                let known = better.as_ref().map(|(_, f)| f.cost).or(found.as_ref().map(|f| f.cost));
                if known.is_none_or(|known| now.cost < known - 1e-9) {
                    better = Some((next, now));
                }
            }
            let Some((next, now)) = better else { break };
            (order, found) = (next, Some(now));
            if looked_at > PLANS {
                break;
            }
        }
        if let Some(now) = found
            && best.as_ref().is_none_or(|best| now.cost < best.cost - 1e-9)
        {
            best = Some(now);
        }
        if looked_at > PLANS {
            break;
        }
    }
    best
}

/// The best plan of an order.
fn judge(
    cells: &[Cell],
    hub: usize,
    order: &Order,
    links: &[(usize, usize)],
    looked_at: &mut usize,
) -> Option<FoundPlan> {
    let mut best: Option<FoundPlan> = None;
    for depth in TRIED {
        *looked_at += 1;
        let Some(rects) = place(cells, hub, order, depth) else { continue };
        let cost = cost(cells, &rects, hub, links);
        if best.as_ref().is_none_or(|best| cost < best.cost - 1e-9) {
            best = Some(FoundPlan { rects, cost });
        }
    }
    best
}

/// An order to begin with: the rooms dealt to the rows, each time in another order. A room that another leads to stands
/// beside that.
fn begin(rooms: &[usize], cells: &[Cell], start: usize) -> Order {
    let mut left: Vec<usize> = rooms.iter().copied().filter(|room| cells[*room].own.is_none()).collect();
    let mut seed = (start as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    for i in (1..left.len()).rev() {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        left.swap(i, (seed >> 33) as usize % (i + 1));
    }
    if start == 0 {
        left.sort_by(|a, b| cells[*b].area[0].total_cmp(&cells[*a].area[0]).then(a.cmp(b)));
    }
    let mut order = Order::default();
    let free = |room: usize| cells[room].fixed.is_none();
    for (k, room) in left.into_iter().enumerate() {
        let to = if start % 3 == 2 && order.rows[2].is_empty() && free(room) { 2 } else { k % 2 };
        let own: Vec<usize> = rooms.iter().copied().filter(|other| cells[*other].own == Some(room)).collect();
        let to = if to == 2 && !own.is_empty() { k % 2 } else { to };
        order.rows[to].push(room);
        order.rows[to].extend(own);
    }
    // What only the hub leads to.
    let placed = |order: &Order, room: usize| order.rows.iter().any(|row| row.contains(&room));
    for room in rooms {
        if !placed(&order, *room) {
            order.rows[0].push(*room);
        }
    }
    order
}

/// The orders that differ in two rooms that change places, or in the place of one.
fn neighbours(order: &Order) -> Vec<Order> {
    let places: Vec<(usize, usize)> =
        (0..3).flat_map(|row| (0..order.rows[row].len()).map(move |at| (row, at))).collect();
    let mut out = Vec::new();
    for (k, a) in places.iter().enumerate() {
        for b in &places[k + 1..] {
            let mut next = order.clone();
            next.rows[a.0][a.1] = order.rows[b.0][b.1];
            next.rows[b.0][b.1] = order.rows[a.0][a.1];
            out.push(next);
        }
        let mut without = order.clone();
        let room = without.rows[a.0].remove(a.1);
        for row in 0..3 {
            if row == 2 && without.rows[2].len() >= END {
                continue;
            }
            for at in 0..=without.rows[row].len() {
                if (row, at) != *a {
                    let mut next = without.clone();
                    next.rows[row].insert(at, room);
                    out.push(next);
                }
            }
        }
    }
    out
}
