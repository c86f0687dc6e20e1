//! What hairdressers and jewellers have: places to style hair, a trolley, a counter of glass with trays of jewels.

use super::tables::drawers;
use crate::ask::Ask;
use crate::block::{Block, block, pieces};
use crate::looks::{Finish, Stuff, shade, stuff};
use crate::mesh::Surface;
use crate::model::BuiltModel;

/// A console with drawers at which hair is styled; a high one has a mirror with lamps.
pub(super) fn styling_station(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::WALNUT);
    let (black, chrome) = (stuff::BLACK_STEEL.surface(), stuff::CHROME.surface());
    let mirrored = a.h > 1.3;
    let shelf = if mirrored { (0.44 * a.h).min(0.85) } else { a.h };
    let thick = 0.04_f64.min(0.1 * shelf);
    m.board(b.y(shelf - thick..shelf), &shade(&main, 1.15));
    let deep = 0.03_f64.min(0.1 * a.d);
    let chest = b.share(0.14..0.86, 0.0..1.0, 0.0..0.94).y(0.6 * shelf..shelf - thick);
    m.solid(chest);
    m.mesh.board(chest.z(chest.min.z..chest.max.z - deep), &main);
    for half in chest.split(0, 2, 0.006) {
        drawers(&mut m, half.inset(0.003, 0.003, 0.0), 1, deep, &shade(&main, 1.1), &chrome);
    }
    // A bar for the feet of who sits there, between two sides.
    let side = b.x(b.min.x..b.min.x + 0.05 * a.w).y(0.0..shelf - thick).z(b.min.z..b.max.z - 0.12 * a.d);
    for one in side.both_sides() {
        m.board(one, &main);
    }
    m.board(b.share(0.05..0.95, 0.0..1.0, 0.6..0.7).y(0.14 * shelf..0.19 * shelf), &chrome);
    dryer(&mut m, b.share(0.86..0.95, 0.0..1.0, 0.62..0.86).y(0.62 * shelf..shelf - thick), &black);
    if !mirrored {
        return m;
    }
    m.surface = Some(shelf);
    let panel = b.y(shelf..a.h).z(b.min.z..b.min.z + 0.1 * a.d);
    m.solid(panel);
    m.mesh.board(panel.z(panel.min.z..panel.min.z + 0.06 * a.d), &black);
    let glass = panel.share(0.1..0.9, 0.05..0.95, 0.6..0.8);
    m.mesh.crisp(glass, &stuff::MIRROR.surface());
    let bulb = |x: f64, y: f64| panel.share(x..x + 0.05, y..y + 0.04, 0.6..1.0);
    for k in 0..7 {
        let y = 0.08 + 0.135 * f64::from(k);
        for x in [0.025, 0.925] {
            m.mesh.rounded(bulb(x, y), 0.02, 1, &stuff::WARM.surface());
        }
    }
    for (x, high, color) in [(0.14, 0.2, 0x7a4fa0), (0.2, 0.16, 0xd8a24a), (0.26, 0.18, 0x3f8f8a)] {
        let bottle = b.share(x..x + 0.045, 0.0..1.0, 0.4..0.52).y(shelf..shelf + high * (a.h - shelf));
        m.solid_drum(bottle);
        m.mesh.lathe(
            bottle,
            &[(1.0, 0.0), (1.0, 0.6), (0.4, 0.72), (0.4, 1.0)],
            12,
            &Stuff(Finish::Plastic, color).surface(),
        );
    }
    m
}

/// A hair dryer that hangs in its holder, nozzle down.
fn dryer(m: &mut BuiltModel, b: Block, s: &Surface) {
    m.solid(b);
    m.mesh.board(b.share(0.2..0.8, 0.0..0.7, 0.2..0.6), s);
    m.mesh.board(b.share(0.0..1.0, 0.6..1.0, 0.0..1.0), &shade(s, 1.6));
}

/// A slim trolley of hairdressers: trays that show what is in them, brushes and a dryer on top.
pub(super) fn salon_trolley(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::DARK_PLASTIC);
    let steel = stuff::CHROME.surface();
    let wheel = 0.06_f64.min(0.1 * a.h);
    let place = b.share(0.02..0.14, 0.0..1.0, 0.04..0.18).y(0.0..wheel);
    for w in place.four_corners() {
        m.board(w, &stuff::RUBBER.surface());
    }
    let top = 0.84 * a.h;
    m.surface = Some(top);
    m.board(b.share(0.0..1.0, 0.0..1.0, 0.02..0.98).y(wheel..1.5 * wheel), &main);
    for post in b.share(0.0..0.08, 0.0..1.0, 0.3..0.7).y(1.5 * wheel..top - 0.03 * a.h).both_sides() {
        m.board(post, &steel);
    }
    let trays = b.share(0.08..0.92, 0.0..1.0, 0.02..1.0).y(1.5 * wheel..top - 0.05 * a.h);
    let colors = [0xd94f8a, 0x3fa7a0, 0xf0b93a, 0x7a5fb5];
    for (k, tray) in trays.split(1, pieces(trays.size().y, 0.15, 2, 5), 0.0).enumerate() {
        let body = tray.share(0.0..1.0, 0.3..0.85, 0.0..1.0);
        m.solid(body);
        m.mesh.crisp(body.share(0.0..1.0, 0.0..0.6, 0.0..1.0), &shade(&main, 1.5));
        for (i, thing) in body.share(0.06..0.94, 0.6..1.0, 0.2..0.9).split(0, 4, 0.02).enumerate() {
            m.mesh.crisp(
                thing.share(0.0..1.0, 0.0..1.0, 0.1..0.8),
                &Stuff(Finish::Plastic, colors[(i + k) % 4]).surface(),
            );
        }
    }
    let lid = b.y(top - 0.03 * a.h..top);
    m.board(lid, &main);
    // A cup of brushes and combs, and a dryer.
    let cup = b.share(0.12..0.34, 0.0..1.0, 0.12..0.36).y(top..0.9 * a.h);
    m.drum(cup, &steel);
    for (k, color) in [0xd94f8a, 0x26282b, 0xf0b93a].into_iter().enumerate() {
        let x = 0.14 + 0.07 * k as f64;
        let z = 0.16 + 0.05 * (k % 2) as f64;
        let stick = b.share(x..x + 0.05, 0.0..1.0, z..z + 0.07).y(0.9 * a.h..a.h);
        m.board(stick, &Stuff(Finish::Plastic, color).surface());
    }
    let dryer = b.share(0.5..0.9, 0.0..1.0, 0.5..0.72).y(top..top + 0.07 * a.h);
    m.rounded(dryer, 0.02, &Stuff(Finish::Plastic, 0xb23a4a).surface());
    m.board(b.share(0.56..0.66, 0.0..1.0, 0.72..0.94).y(top..top + 0.045 * a.h), &stuff::DARK_PLASTIC.surface());
    m
}

const JEWELS: &[Stuff] = &[
    Stuff(Finish::Brass, 0xe0b54a),
    Stuff(Finish::Chrome, 0xe6ebee),
    Stuff(Finish::Glow, 0xd83a4a),
    Stuff(Finish::Glow, 0x3f7fd8),
    Stuff(Finish::Glow, 0x3fae6a),
];

/// A counter whose upper part is of glass, with rings, chains and busts on velvet.
pub(super) fn jewelry_case(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::WALNUT);
    let (brass, glass) = (stuff::BRASS.surface(), stuff::GLASS.surface());
    let velvet = Stuff(Finish::Velvet, 0x1f2c4f).surface();
    let base = 0.58 * a.h;
    m.board(b.share(0.02..0.98, 0.0..1.0, 0.03..0.95).y(0.0..0.1 * base), &stuff::DARK_PLASTIC.surface());
    m.solid(b.y(0.1 * base..base));
    m.mesh.board(b.y(0.1 * base..base).z(b.min.z..b.max.z - 0.02 * a.d), &shade(&main, 0.85));
    for panel in b.y(0.14 * base..0.96 * base).z(b.max.z - 0.02 * a.d..b.max.z).split(0, pieces(a.w, 0.5, 1, 6), 0.02) {
        m.mesh.crisp(panel, &main);
    }
    let hall = b.y(base..a.h);
    let t = 0.012_f64.min(0.04 * a.w).min(0.06 * a.d).min(0.06 * a.h);
    // Edges of brass and panes between them.
    for post in hall.x(b.min.x..b.min.x + t).z(b.min.z..b.min.z + t).four_corners() {
        m.mesh.crisp(post.y(base..a.h - t), &brass);
    }
    let rim = hall.y(a.h - t..a.h);
    m.solid(rim);
    for side in rim.x(b.min.x..b.min.x + t).both_sides() {
        m.mesh.crisp(side, &brass);
    }
    for end in [rim.z(b.min.z..b.min.z + t), rim.z(b.max.z - t..b.max.z)] {
        m.mesh.crisp(end.inset(t, 0.0, 0.0), &brass);
    }
    m.mesh.crisp(rim.inset(t, 0.0, t).share(0.0..1.0, 0.3..0.8, 0.0..1.0), &glass);
    let pane = |c: Block| c.y(base..a.h - t);
    m.solid(pane(hall.z(b.max.z - t..b.max.z)));
    m.mesh.crisp(pane(hall.z(b.max.z - 0.7 * t..b.max.z - 0.3 * t)).inset(t, 0.0, 0.0), &glass);
    for side in hall.x(b.min.x..b.min.x + t).both_sides() {
        m.solid(pane(side));
        m.mesh.crisp(pane(side).inset(0.3 * t, 0.0, t), &glass);
    }
    trays(&mut m, hall.inset(2.0 * t, 0.0, 2.0 * t).y(base..a.h - 2.0 * t), &velvet, a.dice());
    m
}

/// Trays of velvet in two rows, the one at the back raised and with busts.
fn trays(m: &mut BuiltModel, hall: Block, velvet: &Surface, mut dice: crate::words::Dice) {
    let cols = pieces(hall.size().x, 0.36, 1, 5);
    let low = hall.share(0.0..1.0, 0.0..0.12, 0.4..1.0);
    m.solid(low);
    for tray in low.split(0, cols, 0.03) {
        m.mesh.crisp(tray.share(0.0..1.0, 0.0..0.7, 0.0..1.0), velvet);
        let field = tray.share(0.08..0.92, 0.7..1.0, 0.12..0.9);
        for (row, line) in field.split(2, 3, 0.0).enumerate() {
            for (k, spot) in line.split(0, pieces(line.size().x, 0.07, 2, 5), 0.0).enumerate() {
                let jewel = JEWELS[(row + k * 2 + (dice.unit() * 2.0) as usize) % JEWELS.len()].surface();
                m.mesh.crisp(spot.share(0.25..0.75, 0.0..1.6, 0.25..0.75), &jewel);
            }
        }
    }
    let back = hall.share(0.0..1.0, 0.0..0.3, 0.0..0.34);
    m.solid(back.y(hall.min.y..hall.min.y + 0.8 * hall.size().y));
    m.mesh.crisp(back, velvet);
    for (k, place) in back.split(0, 2 * cols, 0.02).enumerate() {
        let c = place.center();
        let half = 0.3 * place.size().x.min(place.size().z);
        let bust = block(c.x - half..c.x + half, back.max.y..hall.min.y + 0.8 * hall.size().y, c.z - half..c.z + half);
        m.mesh.lathe(
            bust,
            &[(0.6, 0.0), (0.95, 0.35), (1.0, 0.5), (0.4, 0.72), (0.36, 1.0)],
            8,
            &stuff::LINEN.surface(),
        );
        let chain = bust.share(0.0..1.0, 0.54..0.6, 0.0..1.0);
        m.mesh.lathe(chain, &[(1.0, 0.0), (0.8, 1.0)], 8, &JEWELS[k % 2].surface());
    }
}
