//! Cupboards, chests, shelves and racks, open or with doors; fronts face +z.

use super::moving::{Hung, MOST};
use super::tables::{drawers, handle};
use crate::ask::Ask;
use crate::block::{Block, block, pieces};
use crate::looks::{Finish, Stuff, shade, stuff};
use crate::mesh::{Mesh, Surface};
use crate::model::BuiltModel;

/// Doors in columns over a face that looks to +z, which open; handles at the meeting edges.
fn doors(m: &mut BuiltModel, face: Block, columns: usize, deep: f64, front: &Surface, grip: &Surface) {
    let tall = face.size().y > 1.1;
    let opens = m.joints.len() + columns <= MOST;
    if !opens {
        m.solid(face.z(face.max.z - deep..face.max.z));
    }
    for (i, door) in face.z(face.max.z - deep..face.max.z - 0.45 * deep).split(0, columns, 0.005).enumerate() {
        let door = door.inset(0.002, 0.004, 0.0);
        m.mesh.board(door, front);
        let size = door.size();
        let left = if columns == 1 { true } else { i % 2 == 1 };
        let whole = door.z(face.max.z - deep..face.max.z);
        if opens {
            m.leaf("door", whole, if left { Hung::Right } else { Hung::Left });
        }
        let thin = 0.012_f64.min(0.08 * size.x);
        let at = if left { door.min.x + 1.5 * thin } else { door.max.x - 2.5 * thin };
        let (lo, hi) = if tall { (0.42, 0.42 + (0.3 / size.y).min(0.2)) } else { (0.6, 0.86) };
        handle(
            m,
            block(at..at + thin, door.min.y + lo * size.y..door.min.y + hi * size.y, door.max.z..face.max.z),
            grip,
        );
    }
}

/// Rows of drawers, of so many in all, in a face that fills the front of a hollow body as deep as the object.
fn pulled(m: &mut BuiltModel, face: Block, (rows, all): (usize, usize), deep: f64, [front, grip]: [&Surface; 2]) {
    drawers(m, face, rows, deep, front, grip);
    let fronts = face.z(face.max.z - deep..face.max.z);
    if all > MOST {
        m.solid(fronts);
        return;
    }
    for f in fronts.split(1, rows, 0.006) {
        m.drawer(f, face.min.z + 0.1 * face.size().z, all, front);
    }
}

/// The casing of a cupboard: carcass with a plinth, or on legs; returns the face that the fronts fill, `deep` thick.
fn casing(m: &mut BuiltModel, a: &Ask, main: &Surface, legs: Option<&Surface>) -> (Block, f64) {
    let b = a.whole();
    let deep = 0.045_f64.min(0.12 * a.d);
    let raise = if legs.is_some() { 0.14_f64.min(0.22 * a.h) } else { 0.06_f64.min(0.08 * a.h) };
    let body = b.y(raise..a.h);
    let wall = 0.02_f64.min(0.05 * a.w).min(0.1 * a.h).min(0.1 * a.d);
    match legs {
        Some(s) => {
            m.legs(b.y(0.0..raise).inset(0.03, 0.0, 0.03), 0.045, s);
            m.shell(body.z(b.min.z..b.max.z - deep), wall, 0.0, main);
        }
        None => {
            m.shell(b.z(b.min.z..b.max.z - deep), wall, raise, main);
            m.mesh.crisp(b.inset(0.012, 0.0, 0.0).y(0.0..raise).z(b.min.z..b.max.z - 1.6 * deep), &shade(main, 0.6));
        }
    }
    m.mesh.board(body.y(a.h - wall..a.h).z(b.max.z - 1.5 * deep..b.max.z - 0.3 * deep), main);
    (body.inset(0.3 * wall, 0.0, 0.0).y(raise + 0.2 * wall..a.h - 1.15 * wall), deep)
}

/// Cupboards: doors; low wide ones stand on legs.
pub(super) fn cabinet(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let main = a.main(stuff::OAK);
    let legs = a.second(stuff::BLACK_STEEL);
    let low = a.h < 1.0 && a.w > 0.7 && !a.says(&["kitchen", "base", "wall", "filing", "storage"]);
    let (face, deep) = casing(&mut m, a, &main, low.then_some(&legs));
    let grip = if low { stuff::BRASS } else { stuff::STEEL }.surface();
    if a.says(&["china", "curio", "hutch"]) && a.h > 1.2 {
        // Cups and plates behind glass, and doors below.
        let cut = face.min.y + 0.4 * face.size().y;
        doors(&mut m, face.y(face.min.y..cut - 0.01), pieces(a.w, 0.48, 1, 8), deep, &shade(&main, 1.1), &grip);
        let upper = face.y(cut..face.max.y);
        m.solid(upper.z(face.max.z - deep..face.max.z));
        let (shade_of, china) = (shade(&main, 0.6), stuff::CERAMIC.surface());
        m.mesh.crisp(upper.z(face.max.z - deep..face.max.z - 0.9 * deep), &shade_of);
        for row in upper.split(1, 3, 0.03) {
            for dish in row.share(0.04..0.96, 0.0..0.55, 0.0..1.0).split(0, pieces(a.w, 0.16, 2, 10), 0.02) {
                m.mesh.crisp(dish.z(face.max.z - 0.9 * deep..face.max.z - 0.6 * deep), &china);
            }
        }
        for post in upper.split(0, pieces(a.w, 0.48, 1, 8), 0.0) {
            for edge in [post.share(0.0..0.06, 0.0..1.0, 0.0..1.0), post.share(0.94..1.0, 0.0..1.0, 0.0..1.0)] {
                m.mesh.crisp(edge.z(face.max.z - 0.55 * deep..face.max.z - 0.4 * deep), &main);
            }
            let pull = post.share(0.46..0.5, 0.1..0.2, 0.0..1.0);
            m.mesh.crisp(pull.z(face.max.z - 0.4 * deep..face.max.z), &grip);
        }
        for rail in [upper.share(0.0..1.0, 0.0..0.05, 0.0..1.0), upper.share(0.0..1.0, 0.95..1.0, 0.0..1.0)] {
            m.mesh.crisp(rail.z(face.max.z - 0.55 * deep..face.max.z - 0.4 * deep), &main);
        }
    } else if a.says(&["glass", "display", "vitrine"]) || a.made_of(&[Finish::Glass]) {
        doors(&mut m, face, pieces(a.w, 0.45, 1, 6), deep, &stuff::GLASS.surface(), &grip);
    } else {
        doors(&mut m, face, pieces(a.w, 0.48, 1, 8), deep, &shade(&main, 1.1), &grip);
    }
    m
}

/// Tall doors, and drawers below where there is room.
pub(super) fn wardrobe(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let main = a.main(stuff::OAK);
    let grip = stuff::BLACK_STEEL.surface();
    let (face, deep) = casing(&mut m, a, &main, None);
    let front = shade(&main, 1.1);
    let columns = pieces(a.w, 0.5, 1, 8);
    if face.size().y > 1.3 && columns > 1 {
        let cut = face.min.y + 0.14 * face.size().y;
        doors(&mut m, face.y(cut..face.max.y), columns, deep, &front, &grip);
        let below = columns.div_ceil(2);
        for f in face.y(face.min.y..cut).split(0, below, 0.005) {
            pulled(&mut m, f.y(face.min.y..cut - 0.005), (1, below + columns / 4), deep, [&front, &grip]);
        }
    } else {
        doors(&mut m, face, columns, deep, &front, &grip);
    }
    m
}

/// Chests of drawers, bedside tables (on legs), filing cabinets.
pub(super) fn chest(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let office = a.says(&["file", "filing", "office"]);
    let tools = a.says(&["tool"]);
    let main = a.main(match () {
        () if tools => stuff::RED,
        () if office => stuff::GRAY,
        () => stuff::OAK,
    });
    let office = office || tools;
    let legs = a.legs(&main);
    let on_legs = !office && a.h < 1.1;
    let (face, deep) = casing(&mut m, a, &main, on_legs.then_some(&legs));
    let grip = if office { stuff::BLACK_STEEL } else { stuff::BRASS }.surface();
    let each = if office { 0.32 } else { 0.21 };
    let (columns, rows) = (pieces(a.w, 0.8, 1, 3), pieces(face.size().y, each, 1, 8));
    for f in face.split(0, columns, 0.006) {
        pulled(&mut m, f, (rows, columns * rows), deep, [&shade(&main, 1.1), &grip]);
    }
    m
}

/// Steel lockers with vents.
pub(super) fn locker(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let main = a.main(Stuff(Finish::Paint, 0x6f8aa3));
    let (face, deep) = casing(&mut m, a, &main, None);
    let front = shade(&main, 1.08);
    let dark = shade(&main, 0.55);
    let columns = pieces(a.w, 0.33, 1, 12);
    let rows = if a.h > 1.2 && a.says(&["double", "small", "two"]) { 2 } else { 1 };
    for part in face.split(1, rows, 0.006) {
        doors(&mut m, part, columns, deep, &front, &stuff::STEEL.surface());
        for door in part.split(0, columns, 0.005) {
            let size = door.size();
            for k in 0..4 {
                let y = door.max.y - (0.08 + 0.025 * f64::from(k)) * size.y;
                let slot = door.inset(0.28 * size.x, 0.0, 0.0).y(y - 0.008 * size.y..y);
                m.mesh.crisp(slot.z(face.max.z - 0.5 * deep..face.max.z - 0.4 * deep), &dark);
            }
        }
    }
    m
}

/// A low unit for a television: doors left and right, an open shelf between.
pub(super) fn tv_stand(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let main = a.main(stuff::WALNUT);
    let legs = a.second(stuff::BLACK_STEEL);
    let (face, deep) = casing(&mut m, a, &main, Some(&legs));
    let grip = legs.clone();
    let third = face.size().x / 3.0;
    let left = face.x(face.min.x..face.min.x + third);
    for side in left.both_sides() {
        doors(&mut m, side, 1, deep, &shade(&main, 1.12), &grip);
    }
    let middle = face.x(-0.5 * third + 0.01..0.5 * third - 0.01);
    m.solid(middle.z(face.min.z..face.max.z - 0.45 * deep));
    let dark = shade(&main, 0.45);
    m.mesh.crisp(middle.z(face.max.z - deep..face.max.z - 0.9 * deep), &dark);
    let y = middle.center().y;
    let t = 0.03 * face.size().y;
    m.mesh.board(middle.y(y - t..y + t).z(face.max.z - deep..face.max.z - 0.45 * deep), &main);
    m
}

/// The colours of books and binders.
const BOOKS: [u32; 9] = [0x8c3b33, 0x2f4b66, 0xd9cdb4, 0x4f6b52, 0xc79a4a, 0x3a3d44, 0xa9b7bd, 0x7a5470, 0xe8e4da];

/// Books side by side on a board: a run from the left edge of `space`, a box for touch and single books to see.
fn book_run(m: &mut BuiltModel, space: Block, dice: &mut crate::words::Dice) {
    let size = space.size();
    let mut x = space.min.x;
    let high = 0.82 * size.y;
    let mut drawn = 0;
    while x < space.max.x - 0.01 && drawn < 40 {
        let thick = dice.between(0.02, 0.05).max(size.x / 30.0).min(space.max.x - x);
        let y = space.min.y + dice.between(0.8, 1.0) * high;
        let z = space.min.z + dice.between(0.75, 0.92) * size.z;
        let s = Stuff(Finish::Paper, *dice.pick(&BOOKS)).surface();
        m.mesh.crisp(block(x..x + 0.96 * thick, space.min.y..y, space.min.z + 0.1 * size.z..z), &s);
        x += thick;
        drawn += 1;
    }
    m.solid(
        space
            .x(space.min.x..x.min(space.max.x))
            .y(space.min.y..space.min.y + high)
            .z(space.min.z..space.min.z + 0.92 * size.z),
    );
}

/// Boards between two sides: the free spaces from the bottom up. Boards are parts.
fn shelves(m: &mut BuiltModel, inner: Block, n: usize, thick: f64, s: &Surface) -> Vec<Block> {
    let step = (inner.size().y - thick) / n as f64;
    let mut spaces = Vec::new();
    for i in 0..=n {
        let y = inner.min.y + step * i as f64;
        m.board(inner.y(y..y + thick), s);
        if i < n {
            spaces.push(inner.y(y + thick..y + step));
        }
    }
    spaces
}

/// A bookcase with a back, boards and some books; room is left on every shelf.
pub(super) fn bookshelf(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let mut dice = a.dice();
    let b = a.whole();
    let main = a.main(stuff::OAK);
    let t = 0.025_f64.min(0.08 * a.w).min(0.08 * a.h);
    let back = 0.01_f64.min(0.1 * a.d);
    for side in b.x(b.min.x..b.min.x + t).both_sides() {
        m.board(side, &main);
    }
    m.board(b.x(b.min.x + t..b.max.x - t).z(b.min.z..b.min.z + back), &shade(&main, 0.86));
    let inner = b.x(b.min.x + t..b.max.x - t).z(b.min.z + back..b.max.z - 0.005 * a.d);
    let rows = pieces(a.h, 0.36, 1, 6);
    let spaces = shelves(&mut m, inner, rows, t, &main);
    if !a.says(&["empty"]) && a.w > 0.15 && a.h / rows as f64 > 0.12 {
        for (i, space) in spaces.iter().enumerate() {
            let share = if i + 1 == rows { 0.45 } else { dice.between(0.5, 0.85) };
            let length = space.size().x;
            let run = if i % 2 == 0 {
                space.x(space.min.x..space.min.x + share * length)
            } else {
                space.x(space.max.x - share * length..space.max.x)
            };
            book_run(&mut m, run, &mut dice);
        }
    }
    m
}

/// Open shelves between frames, empty for what is put on them.
pub(super) fn open_shelf(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::OAK);
    if a.h < 0.4 && a.h < a.w {
        // On a wall: one board on brackets.
        let t = 0.03_f64.min(0.6 * a.h);
        m.board(b.y(a.h - t..a.h), &main);
        let bracket = b.x(b.min.x + 0.15 * a.w..b.min.x + 0.15 * a.w + 0.02_f64.min(0.1 * a.w));
        for s in bracket.both_sides() {
            let (low, z) = (a.h - t, b.min.z);
            m.extrude(0, &[(0.0, z), (low, z), (low, z + 0.8 * a.d)], s.min.x..s.max.x, &a.second(stuff::BLACK_STEEL));
        }
        return m;
    }
    let legs = a.second(stuff::BLACK_STEEL);
    let t = 0.025_f64.min(0.08 * a.w).min(0.08 * a.d);
    for post in b.x(b.min.x..b.min.x + t).z(b.min.z..b.min.z + t).four_corners() {
        m.board(post.y(0.0..a.h), &legs);
    }
    let thick = 0.025_f64.min(0.06 * a.h);
    let rows = pieces(a.h, 0.42, 1, 6);
    shelves(
        &mut m,
        b.x(b.min.x + 0.3 * t..b.max.x - 0.3 * t).z(b.min.z + 0.3 * t..b.max.z - 0.3 * t).y(0.06 * a.h..a.h),
        rows,
        thick,
        &main,
    );
    m
}

/// Square compartments full of records on edge; some are turned to the front.
pub(super) fn record_shelf(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let mut dice = a.dice();
    let b = a.whole();
    let main = a.main(stuff::OAK);
    let t = 0.025_f64.min(0.06 * a.w).min(0.06 * a.h);
    let back = 0.01_f64.min(0.1 * a.d);
    let (columns, rows) = (pieces(a.w, 0.42, 1, 4), pieces(a.h, 0.42, 1, 5));
    for side in b.x(b.min.x..b.min.x + t).both_sides() {
        m.board(side, &main);
    }
    let inner = b.inset(t, 0.0, 0.0);
    m.board(inner.z(b.min.z..b.min.z + back), &shade(&main, 0.8));
    for (row, space) in shelves(&mut m, inner.z(b.min.z + back..b.max.z), rows, t, &main).into_iter().enumerate() {
        m.solid(space.share(0.0..1.0, 0.0..0.9, 0.0..0.92));
        for (column, cell) in space.split(0, columns, t).enumerate() {
            if column > 0 {
                m.mesh.crisp(cell.x(cell.min.x - t..cell.min.x), &main);
            }
            let full = cell.share(0.02..0.98, 0.0..0.9, 0.06..0.9);
            let out = (row + 2 * column) % 3 == 1;
            let run = if out { full.z(full.min.z..full.max.z - 0.12 * a.d) } else { full };
            let sleeves = pieces(run.size().x, 0.022, 4, 96 / (columns * rows).max(4));
            for sleeve in run.split(0, sleeves, 0.002) {
                let look = Stuff(Finish::Paper, *dice.pick(&SLEEVES)).surface();
                m.mesh.crisp(sleeve.share(0.0..1.0, 0.0..0.96 + 0.04 * dice.unit(), 0.0..1.0), &look);
            }
            if out {
                cover(&mut m.mesh, full.z(full.max.z - 0.08 * a.d..full.max.z - 0.06 * a.d), *dice.pick(&SLEEVES));
            }
        }
    }
    m
}

/// The colours of records' sleeves.
const SLEEVES: [u32; 8] = [0x2f5d7c, 0xb9422f, 0xd9a441, 0x3c6b4f, 0x222629, 0xe6dfd2, 0x7b4a75, 0xd97b4f];

/// A sleeve seen from the front, and the record that peeps out of it.
fn cover(mesh: &mut Mesh, b: Block, color: u32) {
    let (size, deep) = (b.size(), b.size().z);
    let r = 0.4 * size.x.min(size.y);
    let c = b.center();
    mesh.crisp(b.share(0.06..0.94, 0.0..0.95, 0.0..0.6), &Stuff(Finish::Paper, color).surface());
    let disc = block(c.x - r..c.x + r, c.y - r..c.y + r, b.min.z + 0.6 * deep..b.min.z + 0.9 * deep);
    mesh.disc(2, disc, &stuff::RUBBER.surface());
    let label = block(c.x - 0.35 * r..c.x + 0.35 * r, c.y - 0.35 * r..c.y + 0.35 * r, disc.max.z..b.max.z);
    mesh.disc(2, label, &stuff::RED.surface());
}

/// Heavy racks: uprights, beams, boards, and cartons on some of them.
pub(super) fn rack(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let mut dice = a.dice();
    let b = a.whole();
    let posts = a.main(Stuff(Finish::Paint, 0x2f5d8f));
    let beams = a.second(Stuff(Finish::Paint, 0xe07b2e));
    let t = 0.06_f64.min(0.08 * a.w).min(0.1 * a.d);
    for post in b.x(b.min.x..b.min.x + t).z(b.min.z..b.min.z + t).four_corners() {
        m.board(post, &posts);
    }
    let pallets = a.says(&["pallet"]);
    let rows = pieces(a.h, if pallets { 1.25 } else { 0.6 }, 1, 4);
    let beam = 0.07_f64.min(0.1 * a.h);
    let step = (a.h - beam) / rows as f64;
    let inner = b.inset(0.3 * t, 0.0, 0.3 * t);
    for i in 0..=rows {
        let y = if i == 0 { 0.25 * beam } else { step * i as f64 };
        m.solid(inner.y(y..y + beam));
        m.mesh.board(inner.inset(0.0, 0.0, 0.15 * t).y(y + 0.55 * beam..y + 0.95 * beam), &stuff::BIRCH.surface());
        for f in inner.y(y..y + beam).z(inner.min.z..inner.min.z + 0.5 * t).four_corners().into_iter().step_by(2) {
            m.mesh.board(f, &beams);
        }
        if i == rows || a.says(&["empty"]) {
            continue;
        }
        if pallets {
            let free = inner.inset(t, 0.0, 0.05 * a.d).y(y + beam..y + step - 0.05 * step);
            for place in free.split(0, pieces(free.size().x, 1.25, 1, 4), 0.12) {
                let full = dice.between(0.4, 0.95);
                if dice.unit() < 0.85 {
                    loaded_pallet(&mut m, place, full, *dice.pick(&[0xbd9462, 0xb08655, 0xc9a577]));
                }
            }
            continue;
        }
        // Cartons of three sizes, never more than the shelf holds.
        let high = dice.between(0.45, 0.75) * (step - beam);
        let side = dice.unit() < 0.5;
        let from = if side { inner.min.x + t } else { -0.1 * a.w };
        let load = block(
            from..from + 0.48 * a.w,
            y + beam..y + beam + high,
            inner.min.z + 0.12 * a.d..inner.max.z - 0.1 * a.d,
        );
        m.solid(load);
        for c in load.split(0, pieces(0.48 * a.w, 0.42, 1, 4), 0.01) {
            carton(&mut m, c, &Stuff(Finish::Paper, *dice.pick(&[0xbd9462, 0xb08655, 0xc9a577])).surface());
        }
    }
    m
}

/// A closed carton with tape.
pub(super) fn carton(m: &mut BuiltModel, b: Block, s: &Surface) {
    let size = b.size();
    let tape = shade(s, 1.5);
    let lip = 0.002_f64.min(0.02 * size.min());
    m.mesh.board(b.inset(0.0, 0.0, lip).y(b.min.y..b.max.y - lip), s);
    let half = 0.08 * size.x;
    m.mesh.crisp(
        block(b.center().x - half..b.center().x + half, b.min.y + 0.7 * size.y..b.max.y, b.min.z..b.max.z),
        &tape,
    );
}

/// A shelf for a shop: a spine, a base, and boards with goods on both sides.
pub(super) fn gondola(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let mut dice = a.dice();
    let b = a.whole();
    let main = a.main(stuff::WHITE);
    let base = 0.14_f64.min(0.2 * a.h);
    let spine = 0.04_f64.min(0.15 * a.d);
    m.board(b.y(0.0..base), &shade(&main, 0.75));
    m.board(b.y(base..a.h).z(-spine / 2.0..spine / 2.0), &main);
    let rows = pieces(a.h - base, 0.4, 1, 4);
    let step = (a.h - base) / rows as f64;
    let thick = 0.03_f64.min(0.2 * step);
    for i in 0..rows {
        let y = base + step * i as f64;
        for (z0, z1) in [(b.min.z + 0.06 * a.d, -spine / 2.0), (spine / 2.0, b.max.z - 0.06 * a.d)] {
            if i > 0 {
                m.board(b.y(y - thick..y).z(z0..z1), &main);
            }
            let goods = b.inset(0.02, 0.0, 0.0).y(y..y + 0.62 * step).z(z0 + 0.03 * a.d..z1 - 0.03 * a.d);
            m.solid(goods);
            for g in goods.split(0, pieces(a.w, 0.16, 1, 24), 0.012) {
                let high = dice.between(0.7, 1.0);
                let s = Stuff(Finish::Paper, *dice.pick(&[0xd8574a, 0xe8b84a, 0x4a8fc2, 0x6aa860, 0xf0ede4, 0x8a5fa8]))
                    .surface();
                m.mesh.crisp(g.y(g.min.y..g.min.y + high * g.size().y), &s);
            }
        }
    }
    m
}

/// Units of blinking machines behind a dark frame.
pub(super) fn server_rack(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let mut dice = a.dice();
    let b = a.whole();
    let main = a.main(stuff::BLACK_STEEL);
    let deep = 0.03_f64.min(0.1 * a.d);
    m.solid(b);
    let wall = 0.05_f64.min(0.1 * a.w);
    m.mesh.board(b.z(b.min.z..b.max.z - deep), &main);
    for side in b.x(b.min.x..b.min.x + wall).z(b.max.z - deep..b.max.z).both_sides() {
        m.mesh.board(side, &main);
    }
    let face = b.inset(wall, 0.04 * a.h, 0.0).z(b.max.z - deep..b.max.z);
    for unit in face.split(1, pieces(a.h, 0.09, 2, 24), 0.01) {
        m.mesh.crisp(unit.z(face.min.z..face.max.z - 0.4 * deep), &stuff::GRAY_PLASTIC.surface());
        let size = unit.size();
        let lamp = unit.inset(0.0, 0.36 * size.y, 0.0).z(face.max.z - 0.4 * deep..face.max.z - 0.3 * deep);
        for k in 0..3 {
            let x = unit.min.x + (0.06 + 0.06 * f64::from(k)) * size.x;
            let s = Stuff(Finish::Glow, *dice.pick(&[0x3fd47a, 0x3fd47a, 0x4aa8ff, 0xffb347])).surface();
            m.mesh.crisp(lamp.x(x..x + 0.03 * size.x), &s);
        }
    }
    m
}

/// Glass on a base, with shelves.
pub(super) fn display_case(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::WHITE);
    let base = if a.h > 1.3 { 0.18 * a.h } else { 0.35 * a.h };
    let t = 0.02_f64.min(0.05 * a.w);
    m.board(b.y(0.0..base), &main);
    let glass = b.y(base..a.h - t.min(0.05 * a.h)).inset(0.003, 0.0, 0.003);
    m.board(b.y(glass.max.y..a.h), &main);
    // Panes on three sides; the fourth has doors, in pairs where there are several.
    let pane = 0.012_f64.min(0.1 * a.w).min(0.1 * a.d);
    for side in glass.x(glass.min.x..glass.min.x + pane).z(glass.min.z..glass.max.z - pane).both_sides() {
        m.solid(side);
    }
    m.solid(glass.inset(pane, 0.0, 0.0).z(glass.min.z..glass.min.z + pane));
    let front = glass.z(glass.max.z - pane..glass.max.z);
    m.mesh.crisp(glass.z(glass.min.z..front.min.z), &stuff::GLASS.surface());
    for (i, door) in front.split(0, pieces(front.size().x, 0.5, 1, MOST), 0.004).enumerate() {
        m.leaf("door", door, if i % 2 == 0 { Hung::Left } else { Hung::Right });
        m.mesh.crisp(door, &stuff::GLASS.surface());
    }
    let rows = pieces(glass.size().y, 0.4, 1, 5);
    let baked = a.says(&["bakery", "pastry", "cake", "food", "bread", "pie"]);
    let goods = if baked { BAKED } else { EXHIBITS };
    let mut dice = a.dice();
    for (row, shelf) in glass.inset(0.02, 0.0, 0.02).split(1, rows, 0.0).enumerate() {
        let board = if row == 0 { shelf.min.y } else { shelf.min.y + 0.5 * t };
        if row > 0 {
            let shelf = shelf.y(shelf.min.y..board);
            m.solid(shelf);
            m.mesh.crisp(shelf, &stuff::STEEL.surface());
        }
        // One solid for all that stands on a shelf.
        let highest = 0.14_f64.min(0.5 * shelf.size().y);
        m.solid(shelf.inset(0.02, 0.0, 0.3 * shelf.size().z).y(board..board + highest));
        for (at, place) in shelf.split(0, pieces(shelf.size().x, 0.22, 2, 6), 0.0).enumerate() {
            let size = place.size();
            let high = highest * (0.6 + 0.4 * dice.unit());
            let thing = place.inset(0.26 * size.x, 0.0, 0.3 * size.z).y(board..board + high);
            let look = dice.pick(goods).surface();
            if baked {
                m.mesh.rounded(thing, 0.3 * high.min(thing.size().x).min(thing.size().z), 1, &look);
            } else {
                exhibit(&mut m.mesh, thing, row + at, &look);
            }
        }
    }
    m
}

/// What is shown in a case, as colours tell.
const BAKED: &[Stuff] =
    &[Stuff(Finish::Ceramic, 0xb9783a), Stuff(Finish::Ceramic, 0xd8a25a), Stuff(Finish::Ceramic, 0x7a4a2b)];
const EXHIBITS: &[Stuff] = &[
    Stuff(Finish::Ceramic, 0xe8e4da),
    Stuff(Finish::Ceramic, 0x2f6f8f),
    Stuff(Finish::Ceramic, 0xc2603a),
    Stuff(Finish::Brass, 0xd8a83f),
    Stuff(Finish::Ceramic, 0x4f7d5a),
];

/// A vase, a ball on a foot, or a bowl.
fn exhibit(mesh: &mut Mesh, b: Block, which: usize, look: &Surface) {
    const SHAPES: [&[(f64, f64)]; 3] = [
        &[(0.5, 0.0), (1.0, 0.35), (0.35, 0.78), (0.6, 1.0)],
        &[(0.6, 0.0), (0.3, 0.2), (1.0, 0.6), (0.5, 1.0)],
        &[(0.4, 0.0), (0.4, 0.3), (1.0, 0.7), (0.8, 0.7)],
    ];
    mesh.lathe(b, SHAPES[which % 3], 8, look);
}

/// A pole with hooks on a round foot.
pub(super) fn coat_rack(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::WALNUT);
    let (x, z) = (a.w / 2.0, a.d / 2.0);
    let foot = 0.04_f64.min(0.1 * a.h);
    m.lathe(b.y(0.0..foot), &[(0.96, 0.0), (1.0, 0.4), (0.92, 0.7), (0.2, 1.0)], &main);
    let r = 0.025_f64.min(0.2 * x).min(0.2 * z);
    m.drum(block(-r..r, foot..0.98 * a.h, -r..r), &main);
    let crown = b.y(0.8 * a.h..a.h).inset(0.2 * x, 0.0, 0.2 * z);
    m.solid_drum(crown);
    m.mesh.stretch(crown, |mesh| {
        for k in 0..6 {
            let (sin, cos) = (std::f64::consts::TAU * f64::from(k) / 6.0).sin_cos();
            let at = |r: f64, y: f64| scenelang_layout::Vec3::new(cos * r, y, sin * r);
            mesh.tube(&[at(0.05, 0.0), at(0.6, 0.25), at(0.9, 0.8), at(1.0, 1.0)], 0.06, &main);
        }
    });
    m
}

/// A rail between two stands, clothes on it.
pub(super) fn clothes_rack(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let mut dice = a.dice();
    let b = a.whole();
    let main = a.main(stuff::BLACK_STEEL);
    let t = 0.03_f64.min(0.08 * a.w).min(0.3 * a.d);
    for side in b.x(b.min.x..b.min.x + t).both_sides() {
        m.board(side.y(0.0..t.min(0.1 * a.h)), &main);
        m.board(side.y(t.min(0.1 * a.h)..a.h - t.min(0.1 * a.h)).z(-t / 2.0..t / 2.0), &main);
    }
    m.board(b.y(a.h - t.min(0.1 * a.h)..a.h).z(-t / 2.0..t / 2.0), &main);
    if a.says(&["empty"]) {
        return m;
    }
    let clothes = block(-0.36 * a.w..0.36 * a.w, 0.34 * a.h..a.h - 1.5 * t.min(0.1 * a.h), -0.42 * a.d..0.42 * a.d);
    m.solid(clothes);
    for c in clothes.split(0, pieces(a.w, 0.09, 2, 24), 0.02) {
        let s =
            Stuff(Finish::Fabric, *dice.pick(&[0x33435c, 0xb9b1a2, 0x7d3f3f, 0x566b57, 0xd8cfc0, 0x2c2d31])).surface();
        let low = c.min.y + dice.between(0.0, 0.35) * c.size().y;
        let shoulder = c.inset(0.0, 0.0, 0.12 * a.d).y(c.max.y - 0.06 * a.h..c.max.y);
        m.mesh.taper(c.y(low..c.max.y), shoulder, &s);
    }
    m
}

/// A pallet with cartons on it that fill so much of the height.
fn loaded_pallet(m: &mut BuiltModel, place: Block, full: f64, paper: u32) {
    let size = place.size();
    let wood = 0.14_f64.min(0.3 * size.y);
    m.solid(place.y(place.min.y..place.min.y + wood));
    let deck = place.y(place.min.y + 0.75 * wood..place.min.y + wood);
    m.mesh.board(deck, &stuff::BIRCH.surface());
    for skid in place.y(place.min.y..place.min.y + 0.75 * wood).split(0, 3, 0.3 * size.x) {
        m.mesh.board(skid, &stuff::BIRCH.surface());
    }
    let load = place.inset(0.02 * size.x, 0.0, 0.03 * size.z);
    let load = load.y(place.min.y + wood..place.min.y + wood + full * (size.y - wood));
    m.solid(load);
    let surface = Stuff(Finish::Paper, paper).surface();
    for layer in load.split(1, pieces(load.size().y, 0.4, 1, 3), 0.006) {
        for c in layer.split(0, pieces(size.x, 0.45, 1, 4), 0.006) {
            carton(m, c, &surface);
        }
    }
}
