//! What stands in supermarkets: freezers that show what is in them, checkouts with a belt, baskets to carry.

use super::moving::{Hung, MOST};
use super::tables::handle;
use crate::ask::Ask;
use crate::block::{Block, block, pieces};
use crate::looks::{Finish, Stuff, shade, stuff};
use crate::mesh::Surface;
use crate::model::BuiltModel;
use crate::words::Dice;
use scenelang_layout::Vec3;

/// Packages of frozen and other food, by their colours.
const PACKAGES: &[u32] = &[0xd8433a, 0xf0b93a, 0x2f7fc2, 0x4f9d4a, 0xf3efe4, 0x8a5fa8, 0xe8832e];

fn package(dice: &mut Dice) -> Surface {
    Stuff(Finish::Paper, *dice.pick(PACKAGES)).surface()
}

/// Chests for what is frozen: in shops open to the eye under sliding panes, elsewhere with a lid.
pub(super) fn chest_freezer(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::WHITE);
    let (dark, steel) = (stuff::DARK_PLASTIC.surface(), stuff::STEEL.surface());
    m.board(b.share(0.015..0.985, 0.0..0.09, 0.02..0.98), &dark);
    if !a.says(&["island", "glass", "display", "ice", "shop", "supermarket"]) && a.w < 1.7 {
        m.board(b.share(0.01..0.99, 0.09..0.86, 0.01..0.97), &main);
        m.rounded(b.share(0.0..1.0, 0.865..1.0, 0.0..0.98), 0.03, &main);
        m.board(b.share(0.38..0.62, 0.8..0.9, 0.98..1.0), &steel);
        for k in 0..5 {
            let at = 0.12 + 0.03 * f64::from(k);
            m.mesh.crisp(b.share(0.68..0.94, at..at + 0.012, 0.97..0.976), &shade(&main, 0.5));
        }
        m.board(b.share(0.1..0.16, 0.7..0.74, 0.97..0.975), &Stuff(Finish::Glow, 0x3fb8e8).surface());
        return m;
    }
    m.board(b.share(0.0..1.0, 0.09..0.5, 0.0..1.0), &main);
    // A bumper for carts and a band that says cold.
    let blue = a.second(Stuff(Finish::Paint, 0x2a6fb5));
    let (rim, tall) = (0.06_f64.min(0.08 * a.w).min(0.08 * a.d), 0.5 * a.h..0.93 * a.h);
    for side in b.x(b.min.x..b.min.x + rim).y(tall.clone()).both_sides() {
        m.board(side, &main);
    }
    let inner = b.inset(rim, 0.0, 0.0).y(tall);
    for wall in [inner.z(b.min.z..b.min.z + rim), inner.z(b.max.z - rim..b.max.z)] {
        m.board(wall, &main);
    }
    let skin = 0.06 * rim;
    m.mesh.crisp(b.share(0.0..1.0, 0.3..0.44, 0.0..1.0).z(b.max.z - skin..b.max.z), &blue);
    let well = inner.z(b.min.z + rim..b.max.z - rim);
    goods(&mut m, well.y(0.5 * a.h..0.86 * a.h), &mut a.dice());
    panes(&mut m, b, rim, well);
    m
}

/// Packages that lie in compartments of a chest, some higher than others.
fn goods(m: &mut BuiltModel, well: Block, dice: &mut Dice) {
    m.solid(well);
    let bays = pieces(well.size().x, 0.45, 2, 6);
    let wire = stuff::WHITE.surface();
    m.mesh.crisp(well.share(0.0..1.0, 0.0..0.3, 0.0..1.0), &wire);
    for (bay, place) in well.split(0, bays, 0.03).enumerate() {
        if bay > 0 {
            m.mesh.crisp(place.x(place.min.x - 0.012..place.min.x - 0.004).y(well.min.y..well.max.y), &wire);
        }
        for half in place.split(2, 2, 0.02) {
            let (kind, accent) = (package(dice), package(dice));
            let rows = pieces(half.size().z, 0.13, 2, 4);
            for (row, one) in half.split(2, rows, 0.012).enumerate() {
                for (at, one) in one.split(0, 2, 0.015).enumerate() {
                    let top = well.min.y + (0.62 + 0.38 * dice.unit()) * well.size().y;
                    m.mesh.crisp(one.y(well.min.y..top), if (row + at) % 3 == 2 { &accent } else { &kind });
                    let size = one.size();
                    let label = one.inset(0.2 * size.x, 0.0, 0.25 * size.z).y(top..top + 0.02 * well.size().y);
                    m.mesh.crisp(label, &stuff::PAPER.surface());
                }
            }
        }
    }
}

/// Two panes that slide over each other on a metal frame.
fn panes(m: &mut BuiltModel, b: Block, rim: f64, well: Block) {
    let (steel, high) = (stuff::STEEL.surface(), b.max.y);
    let frame = b.y(0.93 * high..high);
    let t = 0.7 * rim;
    for side in frame.x(b.min.x..b.min.x + t).both_sides() {
        m.mesh.crisp(side, &steel);
    }
    for end in [frame.z(b.min.z..b.min.z + t), frame.z(b.max.z - t..b.max.z)] {
        m.mesh.crisp(end.inset(t, 0.0, 0.0), &steel);
    }
    m.solid(frame);
    let lid = frame.inset(t, 0.0, t);
    let half = 0.52 * lid.size().x;
    let (left, right) = (lid.x(lid.min.x..lid.min.x + half), lid.x(lid.max.x - half..lid.max.x));
    for (pane, low, grip) in [(left, 0.35, left.max.x), (right, 0.62, right.min.x)] {
        let pane = pane.share(0.0..1.0, low..low + 0.14, 0.0..1.0);
        m.mesh.crisp(pane, &stuff::GLASS.surface());
        let edge = 0.012_f64.min(0.1 * half);
        let bar = pane.x(grip - edge..grip + edge).y(pane.min.y..pane.max.y + 0.1 * frame.size().y);
        m.mesh.crisp(bar.z(well.min.z..well.max.z), &stuff::DARK_PLASTIC.surface());
    }
}

/// Upright cases for what is cold, in shops: shelves of goods behind glass doors under a lit head, or without doors.
pub(super) fn display_freezer(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(Stuff(Finish::Paint, 0xe9ebec));
    let dark = stuff::DARK_PLASTIC.surface();
    let open = a.says(&["open", "multideck", "dairy", "refrigerated"]) && !a.says(&["door", "freezer"]);
    let (foot, head) = (0.09 * a.h, 0.86 * a.h);
    let deep = 0.05_f64.min(0.1 * a.d);
    let wall = 0.05_f64.min(0.06 * a.w).min(0.1 * a.d).min(0.05 * a.h);
    m.mesh.crisp(b.share(0.01..0.99, 0.0..1.0, 0.02..0.97).y(0.0..foot), &dark);
    let inner = m.shell(b.y(0.0..head).z(b.min.z..b.max.z - deep), wall, foot, &main);
    // The head juts out over the doors and says what is behind them.
    let skin = 0.006_f64.min(0.04 * a.d);
    let board = b.y(head..a.h);
    m.solid(board);
    let sign = Stuff(Finish::Paint, if open { 0x3d8a4e } else { 0x1f5fa8 }).surface();
    m.mesh.board(board.z(b.min.z..b.max.z - skin), &sign);
    emblem(&mut m, board.z(b.max.z - skin..b.max.z), open);
    let back = inner.z(inner.min.z..inner.min.z + 0.02 * a.d);
    m.mesh.crisp(back, &Stuff(Finish::Screen, 0xeef4f6).surface());
    let rows = pieces(inner.size().y, 0.38, 2, 5);
    let mut dice = a.dice();
    for (row, bay) in inner.z(back.max.z..inner.max.z - 0.12 * a.d).split(1, rows, 0.0).enumerate() {
        if row > 0 {
            m.mesh.crisp(bay.share(0.0..1.0, 0.0..0.06, 0.0..1.0), &stuff::STEEL.surface());
        }
        let stock = bay.share(0.01..0.99, 0.06..0.78, 0.0..1.0);
        m.solid(stock);
        for block_of in stock.split(0, pieces(stock.size().x, 0.36, 1, 5), 0.02) {
            let kind = package(&mut dice);
            for one in block_of.split(0, pieces(block_of.size().x, 0.12, 1, 3), 0.012) {
                let high = one.share(0.0..1.0, 0.0..0.75 + 0.25 * dice.unit(), 0.0..1.0);
                m.mesh.crisp(high, &kind);
                let label = high.share(0.15..0.85, 0.35..0.65, 1.0..1.0).z(high.max.z..high.max.z + 0.004 * a.d);
                m.mesh.crisp(label, &stuff::PAPER.surface());
            }
        }
    }
    let front = b.y(foot..head).z(b.max.z - deep..b.max.z);
    if open {
        m.board(front.y(foot..foot + 0.12 * a.h), &main);
    } else {
        glass_doors(&mut m, front, deep);
    }
    m
}

/// Doors of glass in black frames, side by side.
fn glass_doors(m: &mut BuiltModel, front: Block, deep: f64) {
    let (black, steel) = (stuff::BLACK_STEEL.surface(), stuff::STEEL.surface());
    let count = pieces(front.size().x, 0.68, 1, MOST);
    for (i, whole) in front.split(0, count, 0.006).enumerate() {
        let left = i % 2 == 0;
        m.leaf("door", whole, if left { Hung::Left } else { Hung::Right });
        let door = whole.z(whole.min.z..whole.max.z - 0.4 * deep);
        let t = 0.045_f64.min(0.12 * door.size().x).min(0.05 * door.size().y);
        for side in [door.x(door.min.x..door.min.x + t), door.x(door.max.x - t..door.max.x)] {
            m.mesh.crisp(side, &black);
        }
        let between = door.x(door.min.x + t..door.max.x - t);
        for rail in [between.y(door.min.y..door.min.y + t), between.y(door.max.y - t..door.max.y)] {
            m.mesh.crisp(rail, &black);
        }
        m.mesh.crisp(between.inset(0.0, t, 0.3 * door.size().z), &stuff::GLASS.surface());
        let at = if left { door.max.x - 0.75 * t } else { door.min.x + 0.25 * t };
        let grip = door.share(0.0..1.0, 0.38..0.62, 0.0..1.0).x(at..at + 0.5 * t);
        handle(m, grip.z(door.max.z..front.max.z), &steel);
    }
}

/// What a head says: a white star of six points stands for what is frozen, a bar for what is only cold.
fn emblem(m: &mut BuiltModel, b: Block, open: bool) {
    let (size, white) = (b.size(), Stuff(Finish::Glow, 0xf4fbff).surface());
    if open {
        m.mesh.crisp(b.share(0.2..0.8, 0.35..0.65, 0.0..1.0), &white);
        return;
    }
    let r = 0.4 * size.y.min(size.x);
    let c = b.center();
    for turn in [0.0, 60.0, 120.0] {
        m.mesh.place(Vec3::new(c.x, c.y, b.min.z), [0.0, 0.0, turn], |mesh| {
            mesh.crisp(block(-0.1 * r..0.1 * r, -r..r, 0.0..size.z), &white);
        });
    }
}

/// A checkout: a belt for what is bought at the left of who serves, a scanner, a till on a neck, and a place to pack.
pub(super) fn checkout_lane(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(Stuff(Finish::Paint, 0xd9dcde));
    let (dark, steel) = (stuff::RUBBER.surface(), stuff::STEEL.surface());
    let top = if a.h > 1.05 { 0.87_f64.min(0.7 * a.h) } else { 0.86 * a.h };
    m.surface = Some(top);
    m.board(b.share(0.02..0.98, 0.0..1.0, 0.04..0.94).y(0.0..0.1 * top), &stuff::DARK_PLASTIC.surface());
    let body = b.y(0.1 * top..0.94 * top);
    m.board(body.share(0.0..1.0, 0.0..1.0, 0.0..0.96), &main);
    // A stripe, and a rail that keeps carts off.
    let stripe = body.share(0.0..1.0, 0.62..0.8, 0.96..0.965);
    m.mesh.crisp(stripe, &a.second(stuff::RED));
    m.board(body.share(0.0..1.0, 0.2..0.28, 0.96..1.0), &steel);
    let deck = b.y(0.94 * top..top);
    m.solid(deck);
    for edge in [deck.share(0.0..1.0, 0.0..1.0, 0.0..0.14), deck.share(0.0..1.0, 0.0..1.0, 0.88..1.0)] {
        m.mesh.crisp(edge, &steel);
    }
    let lane = deck.share(0.0..1.0, 0.0..1.0, 0.14..0.88);
    // Seen from the front the goods come from the left.
    m.mesh.crisp(lane.share(0.46..1.0, 0.0..0.8, 0.0..1.0), &dark);
    for k in 0..6 {
        let at = 0.5 + 0.085 * f64::from(k);
        m.mesh.crisp(lane.share(at..at + 0.006, 0.8..0.86, 0.0..1.0), &shade(&dark, 1.6));
    }
    m.mesh.crisp(lane.share(0.34..0.46, 0.0..1.0, 0.0..1.0), &steel);
    m.mesh.crisp(lane.share(0.36..0.44, 1.0..1.1, 0.25..0.75), &Stuff(Finish::Screen, 0x16222c).surface());
    m.mesh.crisp(lane.share(0.395..0.405, 1.1..1.16, 0.3..0.7), &Stuff(Finish::Glow, 0xff3b30).surface());
    m.mesh.crisp(lane.share(0.0..0.34, 0.0..0.9, 0.0..1.0), &shade(&main, 1.3));
    let above = b.y(top..a.h);
    belt_goods(&mut m, above);
    checkout_till(&mut m, above);
    m
}

/// A divider and a few purchases on the belt.
fn belt_goods(m: &mut BuiltModel, above: Block) {
    let bar = above.share(0.66..0.69, 0.0..0.1, 0.2..0.84);
    m.board(bar, &Stuff(Finish::Plastic, 0xf2c230).surface());
    let things = [(0.74, 0.36, 0.45, 0x2f7fc2), (0.82, 0.6, 0.3, 0xd8433a), (0.88, 0.3, 0.62, 0xf3efe4)];
    for (x, z, high, color) in things {
        let thing = above.share(x..x + 0.05, 0.0..high, z..z + 0.16);
        m.board(thing, &Stuff(Finish::Paper, color).surface());
    }
    let fruit = above.share(0.72..0.77, 0.0..0.24, 0.62..0.76);
    m.solid(fruit);
    m.mesh.bead(fruit, &Stuff(Finish::Ceramic, 0x6fa13c).surface());
}

/// A screen on a neck, turned to who serves, with the drawer and a second, small display for who pays.
fn checkout_till(m: &mut BuiltModel, above: Block) {
    let dark = stuff::DARK_PLASTIC.surface();
    m.board(above.share(0.36..0.4, 0.0..0.42, 0.04..0.1), &dark);
    let screen = above.share(0.29..0.47, 0.42..1.0, 0.05..0.1);
    m.board(screen, &dark);
    let lit = Stuff(Finish::Screen, 0x3d6f95).surface();
    m.mesh.crisp(
        screen.share(0.06..0.94, 0.08..0.92, 0.0..1.0).z(above.min.z + 0.044 * above.size().z..screen.min.z),
        &lit,
    );
    m.mesh.crisp(screen.share(0.08..0.92, 0.3..0.9, 1.0..1.06), &lit);
    let pad = above.share(0.24..0.28, 0.0..0.3, 0.86..0.94);
    m.board(pad, &dark);
    m.mesh.crisp(pad.share(0.1..0.9, 0.5..0.9, 1.0..1.08), &Stuff(Finish::Screen, 0x9fd0b0).surface());
}

/// A basket of plastic to carry, or a stack of them: sides that widen, holes, two handles.
pub(super) fn shopping_basket(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(Stuff(Finish::Plastic, 0xc8332c));
    let high = 0.26_f64.min(0.72 * a.h);
    let count = if a.says(&["stack"]) || a.h > 0.45 { pieces(a.h - high, 0.075, 2, 10) } else { 1 };
    let handle_room = if count == 1 { 0.3 * a.h } else { 0.12 * a.h };
    let lift = if count == 1 { 0.0 } else { (a.h - handle_room - high) / (count - 1) as f64 };
    let each = if count == 1 { a.h - handle_room } else { high };
    m.solid(b.y(0.0..a.h - handle_room));
    for k in 0..count {
        let from = lift * k as f64;
        basket_shell(&mut m, b.y(from..from + each), &main, k + 1 == count);
    }
    let t = 0.02_f64.min(0.1 * a.w).min(0.1 * a.d);
    let low = a.h - handle_room;
    let grip = stuff::DARK_PLASTIC.surface();
    for z in [-0.12 * a.d, 0.12 * a.d] {
        let bow = b.z(z - t / 2.0..z + t / 2.0).y(low..a.h);
        for post in bow.x(b.min.x + 0.04 * a.w..b.min.x + 0.04 * a.w + t).both_sides() {
            m.board(post, &grip);
        }
        m.board(bow.inset(0.04 * a.w, 0.0, 0.0).y(a.h - t.min(0.5 * handle_room)..a.h), &grip);
    }
    m
}

/// Four sides with rows of holes and a rim; of a stack only the uppermost is open to the eye.
fn basket_shell(m: &mut BuiltModel, b: Block, main: &Surface, open: bool) {
    let size = b.size();
    let t = 0.04;
    let floor = b.share(0.09..0.91, 0.0..0.05, 0.09..0.91);
    m.mesh.crisp(floor, &shade(main, 0.7));
    let rim = b.share(0.0..1.0, 0.9..1.0, 0.0..1.0);
    for side in rim.share(0.0..t, 0.0..1.0, 0.0..1.0).both_sides() {
        m.mesh.crisp(side, main);
    }
    for end in [rim.share(t..1.0 - t, 0.0..1.0, 0.0..t), rim.share(t..1.0 - t, 0.0..1.0, 1.0 - t..1.0)] {
        m.mesh.crisp(end, main);
    }
    if !open {
        // Of those below little more than the rims is seen.
        m.mesh.taper(
            b.share(0.1..0.9, 0.0..0.1, 0.1..0.9),
            b.share(0.03..0.97, 0.8..0.9, 0.03..0.97),
            &shade(main, 0.9),
        );
        return;
    }
    let slats = |along: f64| pieces(along, 0.05, 3, 8);
    let wall = |lean: f64, from: f64, to: f64, x: bool| -> (Block, Block) {
        let (low, up) = (0.09 + lean, 0.02 + lean);
        if x {
            (b.share(from..to, 0.0..0.05, low..low + 0.02), b.share(from..to, 0.85..0.92, up..up + 0.02))
        } else {
            (b.share(low..low + 0.02, 0.0..0.05, from..to), b.share(up..up + 0.02, 0.85..0.92, from..to))
        }
    };
    for (along, x) in [(size.x, true), (size.z, false)] {
        let n = slats(along);
        for k in 0..n {
            let from = 0.1 + 0.8 * k as f64 / n as f64;
            let (foot, head) = wall(0.0, from, from + 0.5 / n as f64, x);
            m.mesh.taper(foot, head, main);
            let mirror = |c: Block| if x { c.z(-c.max.z..-c.min.z) } else { c.x(-c.max.x..-c.min.x) };
            m.mesh.taper(mirror(foot), mirror(head), main);
        }
    }
    for y in [0.4, 0.66] {
        let band = b.share(0.045..0.955, y..y + 0.07, 0.045..0.955);
        for side in band.share(0.0..0.02, 0.0..1.0, 0.0..1.0).both_sides() {
            m.mesh.crisp(side, main);
        }
        for end in [band.share(0.0..1.0, 0.0..1.0, 0.0..0.02), band.share(0.0..1.0, 0.0..1.0, 0.98..1.0)] {
            m.mesh.crisp(end, main);
        }
    }
}

/// Ham, cheese, sausages and fish, by their colours.
const FRESH: &[u32] = &[0xd98c8c, 0xf2d27a, 0xa6443a, 0xe8b7a0, 0xf4ead2, 0xc96f4a, 0x8fa35c];

/// A chilled counter with its goods behind glass: the guests are at its front, who serves at its back.
pub(super) fn deli_counter(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::WHITE);
    let (steel, glass) = (stuff::STEEL.surface(), stuff::GLASS.surface());
    m.board(b.share(0.01..0.99, 0.0..0.08, 0.03..0.94), &stuff::DARK_PLASTIC.surface());
    m.board(b.share(0.0..1.0, 0.08..0.5, 0.0..0.98), &main);
    let band = b.share(0.0..1.0, 0.14..0.44, 0.98..1.0);
    m.solid(band);
    for panel in band.split(0, pieces(a.w, 0.6, 1, 8), 0.015) {
        m.mesh.crisp(panel, &a.second(Stuff(Finish::Wood, 0xa9713f)));
    }
    // The top on which goods are handed over, and what carries it at the back.
    m.board(b.share(0.0..1.0, 0.95..1.0, 0.0..1.0), &steel);
    m.board(b.share(0.0..1.0, 0.5..0.95, 0.0..0.06), &main);
    let hall = b.share(0.0..1.0, 0.5..0.95, 0.06..0.98);
    m.solid(hall);
    let pane = 0.012_f64.min(0.02 * a.d).min(0.02 * a.w);
    m.mesh.crisp(hall.z(hall.max.z - pane..hall.max.z), &glass);
    for side in hall.x(hall.min.x..hall.min.x + pane).z(hall.min.z..hall.max.z - pane).both_sides() {
        m.mesh.crisp(side, &glass);
    }
    // Two rows of trays, the one at the back higher.
    let inner = hall.inset(2.0 * pane, 0.0, 0.0);
    let mut dice = a.dice();
    for (row, rise) in
        [(inner.share(0.0..1.0, 0.0..1.0, 0.05..0.48), 0.3), (inner.share(0.0..1.0, 0.0..1.0, 0.52..0.92), 0.1)]
    {
        for tray in row.split(0, pieces(a.w, 0.34, 2, 9), 0.03) {
            m.mesh.crisp(tray.share(0.0..1.0, 0.0..rise, 0.0..1.0), &steel);
            let food = Stuff(Finish::Paper, *dice.pick(FRESH)).surface();
            for piece in tray.share(0.06..0.94, rise..rise + 0.3, 0.08..0.92).split(0, 3, 0.02) {
                m.mesh.crisp(piece, &food);
            }
        }
    }
    m
}
