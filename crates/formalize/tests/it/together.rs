//! What belongs together stands together and looks at its focus, in the places that a room is planned with.

use scenelang_formalize::draft::{Draft, OpeningKind};
use scenelang_formalize::{Options, read};

/// Where something is: middle of its base, turn, size.
#[derive(Clone, Copy)]
struct Place {
    at: [f64; 3],
    yaw: f64,
    size: [f64; 3],
}

impl Place {
    fn front(&self) -> [f64; 2] {
        let (sin, cos) = self.yaw.to_radians().sin_cos();
        [sin, cos]
    }

    /// Where a point is, seen from it: to its right and to its front.
    fn see(&self, x: f64, z: f64) -> [f64; 2] {
        let ([sin, cos], dx, dz) = (self.front(), x - self.at[0], z - self.at[2]);
        [dx * cos - dz * sin, dx * sin + dz * cos]
    }

    /// How far a point is from its outline, seen from above.
    fn gap(&self, x: f64, z: f64) -> f64 {
        let [across, along] = self.see(x, z);
        let out = |v: f64, size: f64| (v.abs() - size / 2.0).max(0.0);
        out(across, self.size[0]).hypot(out(along, self.size[2]))
    }
}

/// The places of all things whose category ends in these words.
fn all(draft: &Draft, noun: &str) -> Vec<Place> {
    let is = |category: &str| {
        let category = category.replace('_', " ");
        category == noun || category.ends_with(&format!(" {noun}"))
    };
    let mut out = Vec::new();
    for thing in draft.things.iter().filter(|thing| is(&thing.category)) {
        let element = |i: usize| match thing.count {
            1 => thing.name.clone(),
            _ => format!("{}[{i}]", thing.name),
        };
        for [x, y, z, yaw] in (0..thing.count).filter_map(|i| draft.place_of(&element(i))) {
            out.push(Place { at: [x, y, z], yaw, size: thing.size.unwrap_or_default() });
        }
    }
    out
}

fn doors(draft: &Draft) -> Vec<Place> {
    let doors = draft.openings.iter().filter(|o| o.kind == OpeningKind::Door);
    let placed = doors.filter_map(|o| Some((draft.place_of(&o.name)?, o.size)));
    placed.map(|([x, y, z, yaw], size)| Place { at: [x, y, z], yaw, size }).collect()
}

fn faces(a: &Place, b: &Place) -> bool {
    let [across, ahead] = a.see(b.at[0], b.at[2]);
    ahead > 0.0 && across.abs() <= b.size[0].max(b.size[2]) / 2.0 + 0.5 * ahead
}

fn walled(draft: &Draft, it: &Place) -> bool {
    let [sin, cos] = it.front();
    let back = [it.at[0] - sin * it.size[2] / 2.0, it.at[2] - cos * it.size[2] / 2.0];
    let [w, _, d] = draft.rooms[0].size;
    (w / 2.0 - back[0].abs()).min(d / 2.0 - back[1].abs()) < 0.06
}

/// Whether a claim holds of a draft.
fn holds(draft: &Draft, claim: &str) -> bool {
    let words: Vec<&str> = claim.split(' ').collect();
    let split = |word: &str| claim.split_once(&format!(" {word} "));
    if let Some(most) = claim.strip_prefix("floor ") {
        let [w, _, d] = draft.rooms[0].size;
        return w * d <= most.parse().unwrap_or(0.0);
    }
    if let (Ok(n), noun) = (words[0].parse::<usize>(), words[1..].join(" ")) {
        let is = |category: &str| category.replace('_', " ") == noun;
        return draft.things.iter().filter(|t| is(&t.category)).map(|t| t.count).sum::<usize>() == n;
    }
    if let Some((a, b)) = split("over") {
        let above = all(draft, a);
        let over = |b: &Place| above.iter().any(|a| a.at[1] > 0.7 && b.gap(a.at[0], a.at[2]) < 0.15);
        let below = all(draft, b);
        return !below.is_empty() && below.iter().all(over);
    }
    if let Some((a, "door")) = split("faces") {
        let (own, doors) = (all(draft, a), doors(draft));
        return !own.is_empty() && own.iter().all(|a| doors.iter().any(|door| a.see(door.at[0], door.at[2])[1] > 0.0));
    }
    if let Some((a, b)) = split("faces") {
        let (own, other) = (all(draft, a), all(draft, b));
        // What stands on its stand looks as that does.
        let own = if own.is_empty() { all(draft, &format!("{a} stand")) } else { own };
        let other = if other.is_empty() { all(draft, &format!("{b} stand")) } else { other };
        return !own.is_empty() && own.iter().all(|a| other.iter().any(|b| faces(a, b)));
    }
    if let Some((a, b)) = split("between") {
        let (own, pair) = (all(draft, a), all(draft, b));
        let [first, second] = &pair[..] else { return false };
        let amid = |it: &Place| {
            let [to, other] = [first, second].map(|bed| bed.see(it.at[0], it.at[2])[0]);
            to * other < 0.0 && to.abs() + other.abs() < 4.0
        };
        return own.iter().any(amid);
    }
    if let Some((a, b)) = split("around") {
        let (own, inner) = (all(draft, a), all(draft, b));
        return !inner.is_empty()
            && inner.iter().all(|b| own.iter().any(|a| a.size[2] > b.size[2] && a.gap(b.at[0], b.at[2]) <= 0.0));
    }
    if let Some((a, far)) = split("by door") {
        let far = far.parse().unwrap_or(0.0);
        let doors = doors(draft);
        return all(draft, a).iter().any(|a| doors.iter().any(|door| a.gap(door.at[0], door.at[2]) <= far));
    }
    if let Some(noun) = claim.strip_suffix(" alike") {
        let own = all(draft, noun);
        return own.len() > 1 && own.iter().all(|it| it.yaw == own[0].yaw);
    }
    if let Some(noun) = claim.strip_suffix(" walled") {
        let own = all(draft, noun);
        return !own.is_empty() && own.iter().all(|it| walled(draft, it));
    }
    panic!("no claim: {claim}");
}

#[test]
fn what_belongs_together_stands_together() {
    let mut wrong = Vec::new();
    for line in include_str!("together.txt").lines().filter(|line| !line.starts_with('#')) {
        let mut parts = line.split(" | ");
        let request = parts.next().unwrap_or_default();
        let draft = read(request, &Options::default()).draft;
        wrong.extend(parts.filter(|claim| !holds(&draft, claim)).map(|claim| format!("{request} {claim}")));
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}
