//! Which of the places that are free is the better one: beds with the head at a closed wall, sofas across from where there is
//! room for a screen, cupboards side by side in corners, little near the door.

use super::floor::{Block, Floor, Pose, Shape};
use super::plan::Plan;
use super::seek::{self, Wall};
use super::stand;

/// What is known of a thing that gets a place.
pub struct Choice<'a> {
    pub noun: &'a str,
    pub size: [f64; 3],
    pub windows: &'a [Wall],
    /// What it looks at, if there is such a thing: its place.
    pub looks_at: Option<Pose>,
    /// Whether it must look at it straight.
    pub strictly: bool,
    /// The part of the room that is for those who work behind a counter.
    pub staffed: Option<Staff>,
    /// What it stands or hangs near: its place.
    pub near: Option<Pose>,
    /// The cost of each metre from there.
    pub pull: f64,
    /// Where the beds of the room are, above whose heads no screen hangs.
    pub beds: &'a [Pose],
    /// Whether such rooms have a screen across from the sofa.
    pub watched: bool,
    /// Whether one eats in the room, too: the sofa leaves the middle.
    pub dines: bool,
    /// Whether all look to the back of the room, where nobody reads for pleasure.
    pub taught: bool,
    /// Whether it is a part of the room for itself, away from the middle: where a team meets beside its desks.
    pub parted: bool,
    /// The part of a shop beyond its tills, where nothing is for sale.
    pub exit: Option<Block>,
    /// On which side of the middle the corner is that is asked for (signs of x and z; 0: on either side).
    pub side: [f64; 2],
}

/// The part of a room for those who work behind a counter.
#[derive(Clone, Copy, Debug)]
pub enum Staff {
    /// All that is farther to the back of the room than this z.
    Beyond(f64),
    /// Around and behind the place of one who works at a desk that visitors come to.
    Around(Block),
}

/// The cost of each metre between a thing and what it stands near, and between it and the window that it is said to be at.
pub const PULL: [f64; 2] = [0.8, 3.0];
/// Things beside each other of one kind are this far apart at least, where there is a choice (metres).
const TOGETHER: f64 = 0.35;
/// From the door to the middle of a counter, and of a stand for one person (metres).
const SERVED: [f64; 2] = [2.6, 1.3];
/// From a counter in mid-room to the wall that it looks at (metres).
const BEFORE_SERVED: f64 = 2.4;
/// What stands on its own has at least so much beside it, where there is a choice (metres).
const ALONE: f64 = 0.3;
/// A gap beside a cupboard that is too narrow for anybody and looks like a mistake, and what it costs.
const DEAD_GAP: [f64; 2] = [0.05, 0.45];
const GAPING: f64 = 0.3;
/// A screen is over the head of a bed whose middle is no farther from it along the wall, and into the room (metres).
const BESIDE_BED: f64 = 1.2;
const LONG_BED: f64 = 1.8;
/// A seating group of a lobby has at least so much around it, where there is a choice (metres).
const APART_FROM_OTHERS: f64 = 1.4;
/// In mid-room it is so much farther from there (metres).
const FREE: f64 = 3.8;
/// What is parked along a wall is so far from it (metres).
const ALONG_WALL: f64 = 0.05;
const WINDOW_SEAT: &str = "window seat";
/// What belongs at a window costs so much more elsewhere.
const AWAY_FROM_WINDOW: f64 = 6.0;
/// A cistern before a window costs so much.
const BEFORE_WINDOW: f64 = 0.8;
/// An easy chair at the side of a classroom where the board is costs so much.
const AT_BOARD: f64 = 1.5;
/// More room around what stands free is no better (metres).
const AROUND: f64 = 1.4;
/// What each metre from a corner costs what is a part of the room for itself.
const PARTED: f64 = 0.15;
/// What stands in the middle of a wall.
const CENTRED: [&str; 3] = ["sideboard", "credenza", "fireplace"];
/// Beyond the foot of a bed, and beside it, a wardrobe and who opens it take so much (metres).
const BEYOND_FOOT: f64 = 1.4;
const FOR_WARDROBE: f64 = 1.9;
/// Beds that lie along a wall.
const ALONG: [&str; 5] = ["bunk bed", "single bed", "loft bed", "kids bed", "daybed"];
/// A stand with a screen, across from a sofa, and what a place for a sofa without one costs.
const SCREEN: [f64; 3] = [1.4, 1.1, 0.4];
const NO_SCREEN: f64 = 1.2;
/// What hangs beside the door, where everybody finds it.
const BY_DOOR: [&str; 5] = ["fire extinguisher", "first aid kit", "fire blanket", "hand sanitizer", "coat hook"];
/// So much is free between furniture and where a door swings (metres), and what a metre less costs.
const ELBOW_ROOM: f64 = 0.25;
const HARD_BY: f64 = 1.6;
/// What hangs above the door.
pub(super) const OVER_DOOR: &str = "exit sign";
/// What stands beside the door.
const LEFT_AT_DOOR: [&str; 8] = [
    "shopping cart",
    "basket stack",
    "bin",
    "coat rack",
    "coat stand",
    "umbrella stand",
    "shoe rack",
    "shopping basket",
];
/// What one takes at the door of a shop.
const TAKEN_AT_DOOR: [&str; 3] = ["shopping cart", "basket stack", "shopping basket"];
/// So far beside the door's middle (metres).
const BESIDE_DOOR: f64 = 1.3;

/// Beside a desk at which visitors are received one walks to the chair behind it, which has so much to the wall; and it is
/// so far from the door at least (metres).
const BESIDE_DESK: f64 = 0.75;
const BEHIND_CHAIR: [f64; 2] = [0.35, 0.6];
const FROM_DOOR: f64 = 3.0;

impl<'a> Choice<'a> {
    /// Of a thing in a room that is being furnished, near nothing and looking at nothing.
    pub fn of(plan: &Plan, noun: &'a str, size: [f64; 3], windows: &'a [Wall]) -> Self {
        Self {
            noun,
            size: stand::moving(noun, size),
            windows,
            looks_at: None,
            strictly: false,
            staffed: super::spots::staffed(plan),
            near: None,
            pull: PULL[0],
            beds: &[],
            watched: super::inventory::is_watched_room(plan),
            dines: plan.dines(),
            taught: plan.is_taught(),
            parted: plan.is_parted(noun),
            exit: plan.exit,
            side: [0.0; 2],
        }
    }

    fn is(&self, nouns: &[&str]) -> bool {
        let ends =
            |noun: &&str| self.noun.strip_suffix(noun).is_some_and(|rest| rest.is_empty() || rest.ends_with(' '));
        nouns.iter().any(ends)
    }

    /// Whether it is for guests and would stand where only those who work there are: beside or behind the counter; or is for
    /// sale and would stand beyond the tills.
    pub(super) fn is_misplaced(&self, pose: &Pose) -> bool {
        let own = || Block::of(&Pose { y: 0.0, ..*pose }, self.size);
        let is_sold = || stand::group(self.noun) != crate::brief::Group::Wall && !self.is(&LEFT_AT_DOOR);
        if self.exit.is_some_and(|exit| own().meets(&exit)) && is_sold() {
            return true;
        }
        self.staffed.is_some_and(|staff| match staff {
            Staff::Beyond(z) => own().high[2] > z + 0.1,
            Staff::Around(block) => own().meets(&block),
        }) && stand::for_guests(self.noun)
    }

    /// Whether one of several that stand in a row would be misplaced.
    fn is_row_misplaced(&self, shape: &Shape, pose: &Pose) -> bool {
        let first = shape.pieces.first().map(|piece| piece.thing);
        let own = shape.pieces.iter().filter(|piece| Some(piece.thing) == first);
        own.into_iter().any(|piece| self.is_misplaced(&pose.then(&piece.at)))
    }

    /// How far it is from what it stands near.
    fn to_near(&self, pose: &Pose) -> f64 {
        self.near.map_or(0.0, |near| (near.x - pose.x).hypot(near.z - pose.z))
    }

    /// What a place at a wall costs; `None`: it is no good at all.
    fn at_wall(&self, floor: &Floor, shape: &Shape, pose: &Pose, before: &[Pose]) -> Option<f64> {
        let wall = Wall::behind(pose)?;
        let length = wall.length(floor.size);
        let along = match wall {
            Wall::Back | Wall::Front => pose.x,
            Wall::Left | Wall::Right => pose.z,
        };
        let mut cost = match wall {
            Wall::Back => 0.0,
            Wall::Left | Wall::Right => 0.25,
            Wall::Front => 0.7,
        };
        if let Some(seen) = self.looks_at {
            let forward = |p: &Pose| (p.yaw.to_radians().sin(), p.yaw.to_radians().cos());
            let ((fx, fz), (dx, dz)) = (forward(pose), (seen.x - pose.x, seen.z - pose.z));
            let aside = (dx * fz - dz * fx).abs();
            let opposite = (pose.yaw - seen.yaw).rem_euclid(360.0) == 180.0;
            if self.strictly && !(opposite && aside <= 0.28) || dx * fx + dz * fz < 0.8 {
                return None;
            }
            cost = aside + if opposite { 0.0 } else { 0.6 };
        }
        if self.is_row_misplaced(shape, pose) {
            return None;
        }
        // Nobody reads beside the blackboard.
        cost += if self.taught && pose.z > 0.0 && stand::is_easy(self.noun) { AT_BOARD } else { 0.0 };
        if matches!(self.staffed, Some(Staff::Beyond(_)))
            && wall == Wall::Back
            && stand::group(self.noun) != crate::brief::Group::Storage
        {
            cost += 1.0;
        }
        cost += self.to_near(pose) * self.pull;
        let lit = self.windows.contains(&wall);
        if lit && self.is(&["toilet"]) {
            cost += BEFORE_WINDOW;
        }
        if (self.noun.starts_with(stand::AT_WINDOW) || self.is(&[WINDOW_SEAT])) && !lit {
            cost += AWAY_FROM_WINDOW;
        }
        if self.is(&["bed"]) {
            // A narrow one lies along a wall, and its free side is its right one.
            let narrow = self.size[0] < 1.15 && before.is_empty() && self.is(&ALONG);
            let to = |side: f64| side * along + length / 2.0 - self.size[0] / 2.0;
            // The other corner, where a window is in the way of this one.
            let to_corner = to(1.0).min(to(-1.0) + 0.3);
            cost += if narrow { to_corner.min(3.0) * 1.5 } else { along.abs() / length * 0.6 };
            cost += if lit { 0.7 } else { 0.0 };
            // Where no wardrobe has room beyond its foot, one has beside it.
            let beside = length / 2.0 + along.abs() - self.size[0] / 2.0;
            let is_shallow = wall.depth(floor.size) < self.size[2] + BEYOND_FOOT;
            cost += if is_shallow && before.is_empty() && beside < FOR_WARDROBE { 0.5 } else { 0.0 };
        } else if self.is(&["sofa", "couch"]) {
            // Across from it there is room for a screen, and no window behind that.
            let dazzled = self.windows.contains(&wall.across());
            let aside = along.abs() / length * if self.dines { -1.0 } else { 0.5 };
            cost += aside + if dazzled { 0.8 } else { 0.0 };
            let there = wall.across().place(floor.size, 0.0, SCREEN[2] / 2.0 + seek::BEHIND);
            let there = match wall {
                Wall::Back | Wall::Front => Pose { x: pose.x, ..there },
                Wall::Left | Wall::Right => Pose { z: pose.z, ..there },
            };
            let deep = wall.depth(floor.size);
            if self.watched {
                cost += if self.looks_at.is_none() && !floor.has_room(&there, SCREEN) { NO_SCREEN } else { 0.0 };
                cost += (3.6 - deep).max(0.0) + (deep - 4.6).max(0.0) * 0.6;
            } else {
                // Groups of guests keep to themselves.
                cost += 2.0 * (APART_FROM_OTHERS - floor.room_around(shape, pose)).max(0.0);
            }
        } else if self.is(&CENTRED) && before.is_empty() && self.near.is_none() {
            // With a picture above it, it is the middle of its wall.
            cost += along.abs() / length * 0.5;
        } else if self.looks_at.is_none() {
            let to_end = length / 2.0 - along.abs() - seek::reach(shape)[0].max(seek::reach(shape)[1]);
            cost += to_end.max(0.0).min(floor.room_around(shape, pose)).min(2.0) * 0.2;
        }
        if !stand::lines_up(self.noun) && before.is_empty() {
            cost += (ALONE - floor.room_around(shape, pose)).max(0.0) * 3.0;
        }
        if stand::lines_up(self.noun) && self.near.is_none() {
            let gaps = floor.stretch(pose, self.size);
            cost += gaps.iter().filter(|gap| (DEAD_GAP[0]..DEAD_GAP[1]).contains(*gap)).count() as f64 * GAPING;
        }
        // Several of a kind stand at one wall, evenly.
        if let Some(last) = before.last() {
            cost += if last.yaw == pose.yaw { -1.2 } else { 0.0 };
            let apart = (last.x - pose.x).hypot(last.z - pose.z) - self.size[0];
            let aim = if stand::lines_up(self.noun) { 0.0 } else { TOGETHER };
            cost += (apart - aim).abs().min(2.0) * 0.25;
        }
        let by_door = if self.is(&LEFT_AT_DOOR) { 0.2 } else { 0.7 };
        cost += if self.is(&TAKEN_AT_DOOR) { floor.away_from_door(pose) * 0.3 } else { 0.0 };
        Some(cost + (1.6 - floor.away_from_door(pose)).max(0.0) * by_door + self.at_frame(floor, shape, pose))
    }

    /// What it costs that a group is hard by a door, though not in its way.
    fn at_frame(&self, floor: &Floor, shape: &Shape, pose: &Pose) -> f64 {
        if self.is(&LEFT_AT_DOOR) || self.is(&TAKEN_AT_DOOR) {
            return 0.0;
        }
        let standing = shape.pieces.iter().filter(|piece| piece.at.y < 0.3 && piece.size[1] > 0.3);
        let gaps = standing.map(|piece| floor.off_swing(&Block::of(&pose.then(&piece.at), piece.size)));
        (ELBOW_ROOM - gaps.fold(f64::INFINITY, f64::min)).max(0.0) * HARD_BY
    }

    /// The best place at a wall.
    pub fn wall(&self, floor: &Floor, shape: &Shape, before: &[Pose]) -> Option<Pose> {
        let mut places = seek::at_walls(floor.size, shape, self.size[2] + 2.0 * floor.edge);
        if stand::lines_up(self.noun) {
            places.extend(seek::beside_others(floor, shape, self.size, &places));
        }
        seek::best(floor, shape, places.into_iter(), &|pose| self.at_wall(floor, shape, pose, before))
    }

    /// The best place along a wall, its right side to the room.
    pub fn along_wall(&self, floor: &Floor, shape: &Shape, before: &[Pose]) -> Option<Pose> {
        let [width, _, depth] = self.size;
        let ends = |wall: Wall| {
            let half = (wall.length(floor.size) - depth) / 2.0 - ALONG_WALL;
            [-half, 0.0, half].map(|along| (wall, along))
        };
        let places = Wall::ALL.into_iter().flat_map(ends);
        let places = places.map(|(wall, along)| {
            let at = wall.place(floor.size, along, width / 2.0 + ALONG_WALL);
            Pose { yaw: (at.yaw + 90.0).rem_euclid(360.0), ..at }
        });
        let cost = |pose: &Pose| {
            let near = before.iter().filter(|other| other.yaw == pose.yaw).count() as f64;
            Some((2.0 - floor.away_from_door(pose)).max(0.0) * 0.7 - 0.5 * near)
        };
        seek::best(floor, shape, places, &cost).or_else(|| self.wall(floor, shape, before))
    }

    /// The best place at a wall for a group whose left or right end is at the next wall.
    pub fn in_corner(&self, floor: &Floor, shape: &Shape, before: &[Pose]) -> Option<Pose> {
        let [left, right, ..] = seek::reach(shape);
        let ends = |wall: Wall| {
            let half = wall.length(floor.size) / 2.0;
            [left + seek::BEHIND - half, half - right - seek::BEHIND].map(|along| (wall, along))
        };
        let places = Wall::ALL.into_iter().flat_map(ends);
        let places = places.map(|(wall, along)| wall.place(floor.size, along, self.size[2] / 2.0 + seek::BEHIND));
        seek::best(floor, shape, places, &|pose| self.at_wall(floor, shape, pose, before))
    }

    /// The best place on a wall, its lower edge at a height; `on`: at this wall only.
    pub fn hung(&self, floor: &Floor, shape: &Shape, before: &[Pose], y: f64) -> Option<Pose> {
        let places = seek::on_walls(floor.size, shape, self.size[2], y).into_iter();
        let is_over = |pose: &Pose, bed: &Pose| {
            let [dx, dz] = [(bed.x - pose.x).abs(), (bed.z - pose.z).abs()];
            let along = if matches!(Wall::behind(pose), Some(Wall::Back | Wall::Front)) { dx } else { dz };
            bed.yaw == pose.yaw && dx.max(dz) < LONG_BED && along < BESIDE_BED
        };
        let cost = |pose: &Pose| {
            let wall = Wall::behind(pose)?;
            if self.is(&["tv"]) && self.beds.iter().any(|bed| is_over(pose, bed)) {
                return None;
            }
            // In the middle of what is free of the wall, with some of it free at both sides.
            let [left, right] = floor.stretch(pose, self.size);
            let mut cost = (left - right).abs().min(2.0) * 0.15
                + (0.7 - left.min(right)).max(0.0) * 0.6
                + match wall {
                    Wall::Back => 0.0,
                    Wall::Left | Wall::Right => 0.1,
                    Wall::Front => 0.8,
                };
            if let Some(seen) = self.looks_at {
                let forward = (seen.yaw.to_radians().sin(), seen.yaw.to_radians().cos());
                let (dx, dz) = (pose.x - seen.x, pose.z - seen.z);
                let ahead = dx * forward.0 + dz * forward.1;
                cost += (dx * forward.1 - dz * forward.0).abs() * 0.5 + if ahead > 0.8 { 0.0 } else { 3.0 };
                // A screen is watched from the front.
                let turn = pose.yaw.to_radians();
                let front = -(dx * turn.sin() + dz * turn.cos()) / dx.hypot(dz).max(0.1);
                cost += 1.0 - front;
            }
            cost += self.to_near(pose) * 0.8;
            if self.is(&[OVER_DOOR]) {
                // Where the door swings, and not on the next wall beside it.
                return Some(floor.off_swing(&Block::of(pose, self.size)) + 0.1 * floor.away_from_door(pose));
            }
            if self.is(&BY_DOOR) {
                cost += (floor.away_from_door(pose) - BESIDE_DOOR).abs().min(6.0) * 0.4;
            }
            if self.is_misplaced(pose) {
                cost += 2.0;
            }
            // Mirrors of a studio make one wall.
            let is_mirror = self.is(&["gym mirror"]);
            if let Some(last) = before.last().filter(|_| is_mirror) {
                cost += ((last.x - pose.x).hypot(last.z - pose.z) - self.size[0]).abs() * 3.0;
            }
            let apart = if is_mirror { 2.0 } else { 0.5 };
            cost += before.iter().filter(|other| other.yaw != pose.yaw).count() as f64 * apart;
            Some(cost)
        };
        seek::best(floor, shape, places, &cost)
    }

    /// The best place for a counter or a desk at which visitors are served: near the door and turned to it, rather before a
    /// wall than in mid-room.
    pub fn service(&self, floor: &Floor, shape: &Shape, behind: f64) -> Option<Pose> {
        let served = SERVED[usize::from(self.size[0] < 1.0)];
        let walls = seek::at_walls(floor.size, shape, self.size[2] + 2.0 * behind).into_iter();
        let free = seek::on_floor(floor.size, self.size, &[180.0, 90.0, 270.0]).into_iter();
        let places = walls.map(|pose| (pose, 0.0)).chain(free.map(|pose| (pose, FREE)));
        let cost = |pose: &Pose, free: f64| {
            let away = floor.away_from_door(pose);
            let ahead = floor.door_ahead(pose);
            // Who comes in stands before it, not beside it or behind.
            if ahead < 0.9 {
                return None;
            }
            let lit = Wall::behind(pose).is_some_and(|wall| free == 0.0 && self.windows.contains(&wall));
            // Who serves has the room before the eyes, and not a wall.
            let wall = if free > 0.0 { (BEFORE_SERVED - floor.wall_ahead(pose)).max(0.0) } else { 0.0 };
            Some((away - served).abs() + free + wall + if lit { 0.5 } else { 0.0 })
        };
        let mut best: Option<(f64, Pose)> = None;
        for (pose, free) in places {
            let Some(cost) = cost(&pose, free) else { continue };
            let better = best.is_none_or(|(least, _)| cost < least);
            if better && floor.fits(shape, &pose) && floor.leaves_ways(shape, &pose) {
                best = Some((cost, pose));
            }
        }
        best.map(|(_, pose)| pose)
    }

    /// The best place for a desk across from which visitors sit: who works there has a wall behind and the door before the eyes.
    pub fn received_at(&self, floor: &Floor, shape: &Shape) -> Option<Pose> {
        let [.., chair] = seek::reach(shape);
        let places = Wall::ALL.into_iter().flat_map(|wall| {
            let half = (wall.length(floor.size) - self.size[0]) / 2.0 - BESIDE_DESK;
            let steps = (half.max(0.0) / 0.1).floor() as i32;
            let along = (-steps..=steps).map(|i| f64::from(i) * 0.1);
            along
                .flat_map(move |along| BEHIND_CHAIR.map(|behind| (wall, wall.place(floor.size, along, chair + behind))))
        });
        let cost = |wall: Wall, at: &Pose| {
            let to_middle = if matches!(wall, Wall::Back | Wall::Front) { at.x.abs() } else { at.z.abs() };
            let unseen = if floor.door_ahead(at) < 1.0 { 3.0 } else { 0.0 };
            let lit = if self.windows.contains(&wall) { 0.4 } else { 0.0 };
            let near = (FROM_DOOR - floor.away_from_door(at)).max(0.0);
            unseen + lit + near + to_middle * 0.2 + self.to_near(at) * 0.8
        };
        let turned = |at: &Pose| Pose { yaw: (at.yaw + 180.0).rem_euclid(360.0), ..*at };
        seek::best(floor, shape, places.map(|(_, at)| turned(&at)), &|pose| {
            let at = turned(pose);
            Some(cost(Wall::behind(&at)?, &at))
        })
    }

    /// The best corner.
    pub fn corner(&self, floor: &Floor, shape: &Shape, before: &[Pose]) -> Option<Pose> {
        let places = seek::in_corners(floor.size, shape, self.size, floor.edge).into_iter();
        let cost = |pose: &Pose| {
            if self.is_misplaced(pose) || self.side[0] * pose.x < 0.0 || self.side[1] * pose.z < 0.0 {
                return None;
            }
            let guest = matches!(self.staffed, Some(Staff::Beyond(_))) && stand::for_guests(self.noun);
            let at_door = self.is(&LEFT_AT_DOOR);
            let front = if pose.z < 0.0 && !guest && !at_door { 0.5 } else { 0.0 };
            // Who sits in a corner has the light of a window.
            let lit = self.windows.iter().any(|wall| match wall {
                Wall::Back => pose.z > 0.0,
                Wall::Front => pose.z < 0.0,
                Wall::Left => pose.x < 0.0,
                Wall::Right => pose.x > 0.0,
            });
            let front = front + if self.taught && pose.z > 0.0 && stand::is_easy(self.noun) { AT_BOARD } else { 0.0 };
            let near = before.iter().filter(|other| (other.x - pose.x).hypot(other.z - pose.z) < 2.0).count();
            // Behind a door nothing is seen but what one leaves there.
            let door = match self.is(&TAKEN_AT_DOOR) {
                true => floor.away_from_door(pose) * 0.1 + if pose.z > 0.0 { 1.0 } else { 0.0 },
                false => (2.0 - floor.away_from_door(pose)).max(0.0) * if at_door { 0.2 } else { 0.9 },
            };
            let crowded = self.at_frame(floor, shape, pose);
            Some(front + if lit { -0.3 } else { 0.0 } + near as f64 + door + self.to_near(pose) * 0.8 + crowded)
        };
        seek::best(floor, shape, places, &cost)
    }

    /// The best place on the floor: room around it, in line with others of its kind, rather in the middle.
    pub fn floor(&self, floor: &Floor, shape: &Shape, before: &[Pose], yaws: &[f64]) -> Option<Pose> {
        let places = seek::on_floor(floor.size, self.size, yaws).into_iter();
        let cost = |pose: &Pose| {
            if self.is_misplaced(pose) {
                return None;
            }
            let around = floor.room_around(shape, pose).min(AROUND);
            let [w, _, d] = floor.size;
            let off = pose.x.abs() + pose.z.abs();
            let off = if self.parted { PARTED * ((w + d) / 2.0 - off) } else { 0.06 * off };
            // A mat is lain on: not where one stands before something else.
            let trodden = self.size[1] < 0.05 && floor.keeps_free(&Block::of(pose, self.size));
            let lined = before.iter().any(|o| (o.x - pose.x).abs() < 0.02 || (o.z - pose.z).abs() < 0.02);
            let cost = -around + off + if before.is_empty() || lined { 0.0 } else { 0.5 };
            // Behind those who look to the board.
            let behind = if self.taught && self.size[1] < 0.05 { pose.z + d / 2.0 } else { 0.0 };
            let crowded = self.at_frame(floor, shape, pose);
            Some(cost + behind + if trodden { 1.5 } else { 0.0 } + self.to_near(pose) * 0.8 + crowded)
        };
        seek::best(floor, shape, places, &cost)
    }
}

impl Choice<'_> {
    /// As near to the middle of the room as there is a place.
    pub fn middle(&self, floor: &Floor, shape: &Shape, yaws: &[f64]) -> Option<Pose> {
        const STEP: f64 = 0.1;
        let steps = (-20..=20).flat_map(|i| (-20..=20).map(move |k| (f64::from(i) * STEP, f64::from(k) * STEP)));
        let places = steps.flat_map(|(x, z)| yaws.iter().map(move |yaw| Pose { x, y: 0.0, z, yaw: *yaw }));
        seek::best(floor, shape, places, &|pose| Some(pose.x.abs() + pose.z.abs()))
    }
}

/// Whether something that goes with a thing stands before its front, so that its front is not free.
pub fn front_taken(noun: &str) -> bool {
    use super::groups::{Where, of};
    let stands = |noun: &str| Plan::size(noun)[1] > 0.05;
    of(noun, "")
        .iter()
        .any(|part| matches!(part.at, Where::Front(..) | Where::Row(..) | Where::Around(..)) && stands(part.noun))
}

/// What a thing is before which something is to be seen: where one sits or lies.
pub fn seats(noun: &str) -> bool {
    noun.ends_with("sofa") || noun.ends_with("bed") || stand::group(noun) == crate::brief::Group::Bed
}
