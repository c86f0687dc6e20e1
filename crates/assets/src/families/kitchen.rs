//! Kitchens and laundries: appliances with doors that face +z, and sinks.

use super::moving::Hung;
use super::tables::handle;
use crate::ask::Ask;
use crate::block::{Block, block, pieces};
use crate::looks::{Finish, Stuff, shade, stuff};
use crate::mesh::{Mesh, Surface};
use crate::model::BuiltModel;
use scenelang_layout::Vec3;

/// Something turned about the depth axis of a box, front at +z: knobs, drums, burners on end.
pub(super) fn dial(mesh: &mut Mesh, b: Block, profile: &[(f64, f64)], s: &Surface) {
    mesh.stretch(b, |mesh| {
        mesh.place(Vec3::zeros(), [90.0, 0.0, 0.0], |mesh| {
            mesh.lathe(block(-1.0..1.0, 0.0..1.0, -1.0..1.0), profile, 24, s);
        });
    });
}

/// The hollow body of an appliance, and the face in front of it (`deep` thick) for doors and handles.
fn appliance(m: &mut BuiltModel, a: &Ask, main: &Surface) -> Block {
    let b = a.whole();
    let deep = 0.06_f64.min(0.14 * a.d);
    let plinth = 0.04_f64.min(0.05 * a.h);
    let wall = 0.03_f64.min(0.1 * a.w).min(0.1 * a.h).min(0.1 * a.d);
    m.shell(b.z(b.min.z..b.max.z - deep), wall, plinth, main);
    m.mesh
        .crisp(b.inset(0.02, 0.0, 0.0).y(0.0..plinth).z(b.min.z..b.max.z - 1.5 * deep), &stuff::DARK_PLASTIC.surface());
    b.inset(0.002, 0.0, 0.0).y(plinth..a.h).z(b.max.z - deep..b.max.z)
}

/// A door with an upright bar as its handle, hung on the other side; or with a level one, which folds down.
pub(super) fn hatch(m: &mut BuiltModel, b: Block, upright: bool, left: bool, s: &Surface, grip: &Surface) {
    let hung = match (upright, left) {
        (false, _) => Hung::Below,
        (true, true) => Hung::Right,
        (true, false) => Hung::Left,
    };
    m.leaf("door", b, hung);
    draw_hatch(m, b, upright, left, s, grip);
}

/// The same, drawn only.
fn draw_hatch(m: &mut BuiltModel, b: Block, upright: bool, left: bool, s: &Surface, grip: &Surface) {
    let (size, z) = (b.size(), b.min.z + 0.5 * b.size().z);
    m.mesh.rounded(b.z(b.min.z..z), 0.008, 2, s);
    let t = 0.016_f64.min(0.06 * size.x).min(0.06 * size.y);
    let bar = if upright {
        let x = if left { b.min.x + 2.0 * t } else { b.max.x - 3.0 * t };
        b.x(x..x + t).inset(0.0, 0.2 * size.y, 0.0)
    } else {
        b.y(b.max.y - 3.0 * t..b.max.y - 2.0 * t).inset(0.12 * size.x, 0.0, 0.0)
    };
    handle(m, bar.z(z + 0.4 * (b.max.z - z)..b.max.z), grip);
    let bs = bar.size();
    let stud = if upright { bar.inset(0.0, 0.45 * bs.y, 0.0) } else { bar.inset(0.45 * bs.x, 0.0, 0.0) };
    m.mesh.crisp(stud.z(z..b.max.z - 0.3 * (b.max.z - z)), grip);
}

/// Refrigerators: one door over another, or two side by side; shop ones have a glass door.
pub(super) fn fridge(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let main = a.main(Stuff(Finish::Metal, 0xd3d7da));
    let grip = stuff::STEEL.surface();
    let face = appliance(&mut m, a, &main);
    if a.says(&["glass", "display", "beverage", "drink", "shop"]) {
        let deep = face.size().z;
        m.leaf("door", face, Hung::Left);
        let door = face.inset(0.0, 0.03 * a.h, 0.0);
        super::openings::frame(
            &mut m,
            door.z(door.min.z..door.max.z - 0.4 * deep),
            0.06 * a.w,
            0.04 * a.h,
            0.1 * a.h,
            &stuff::DARK_PLASTIC.surface(),
        );
        m.mesh.crisp(
            door.inset(0.06 * a.w, 0.05 * a.h, 0.0).z(door.min.z..door.min.z + 0.1 * deep),
            &Stuff(Finish::Screen, 0xdfe8ec).surface(),
        );
        let mut dice = a.dice();
        for row in door.inset(0.08 * a.w, 0.1 * a.h, 0.0).split(1, 5, 0.0) {
            for item in row.split(0, 6, 0.0) {
                let s = Stuff(Finish::Plastic, *dice.pick(&[0xd8574a, 0xe8b84a, 0x4a8fc2, 0x6aa860])).surface();
                let item = item.inset(0.2 * item.size().x, 0.0, 0.0).y(item.min.y..item.min.y + 0.75 * item.size().y);
                m.mesh.crisp(item.z(face.min.z + 0.1 * deep..face.min.z + 0.4 * deep), &s);
            }
        }
        m.mesh.crisp(
            door.inset(0.06 * a.w, 0.05 * a.h, 0.0).z(door.max.z - 0.45 * deep..door.max.z - 0.4 * deep),
            &stuff::GLASS.surface(),
        );
        handle(
            &mut m,
            face.x(face.max.x - 0.05 * a.w..face.max.x - 0.02 * a.w)
                .y(0.4 * a.h..0.6 * a.h)
                .z(face.max.z - 0.4 * deep..face.max.z),
            &grip,
        );
    } else if a.w > 0.82 && a.h > 1.2 {
        for (i, door) in face.split(0, 2, 0.006).enumerate() {
            hatch(&mut m, door, true, i == 1, &main, &grip);
        }
    } else if a.h > 1.0 {
        let cut = face.min.y + 0.36 * face.size().y;
        let shelf = a.whole().inset(0.1 * a.w, 0.0, 0.1 * a.d);
        m.solid(shelf.y(cut - 0.02 * a.h..cut + 0.02 * a.h).z(shelf.min.z..face.min.z));
        hatch(&mut m, face.y(face.min.y..cut - 0.003), true, true, &main, &grip);
        hatch(&mut m, face.y(cut + 0.003..face.max.y), true, true, &main, &grip);
    } else {
        hatch(&mut m, face, true, true, &main, &grip);
    }
    m
}

/// What is lower is no oven (metres).
const HOB: f64 = 0.3;

/// A plate of dark glass with the marks of its rings, in a frame.
fn hob(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let edge = 0.012_f64.min(0.05 * a.w).min(0.05 * a.d);
    m.board(b.y(0.0..0.6 * a.h), &a.main(stuff::STEEL));
    let plate = b.inset(edge, 0.0, edge).y(0.6 * a.h..a.h);
    m.solid(plate);
    let glass = plate.y(0.6 * a.h..0.94 * a.h);
    m.mesh.board(glass, &stuff::DARK_PLASTIC.surface());
    for half in glass.inset(0.06 * a.w, 0.0, 0.08 * a.d).split(0, pieces(a.w, 0.3, 1, 4), 0.0) {
        for spot in half.split(2, 2, 0.0) {
            let (c, r) = (spot.center(), 0.4 * spot.size().x.min(spot.size().z));
            let ring = block(c.x - r..c.x + r, glass.max.y..a.h, c.z - r..c.z + r);
            m.mesh.lathe(ring, &[(1.0, 0.0), (1.0, 1.0), (0.86, 1.0), (0.86, 0.0)], 24, &stuff::GRAY_PLASTIC.surface());
        }
    }
    m
}

/// Cookers: hob on top, knobs, an oven door with a window.
pub(super) fn stove(a: &Ask) -> BuiltModel {
    if a.h < HOB {
        return hob(a);
    }
    let mut m = BuiltModel::default();
    let main = a.main(stuff::STEEL);
    let dark = stuff::DARK_PLASTIC.surface();
    let b = a.whole();
    let deep = 0.06_f64.min(0.14 * a.d);
    let top = a.h - 0.02_f64.min(0.06 * a.h);
    let hot = b.y(0.16 * a.h..top - 0.14 * a.h);
    // Around the oven: what carries the hob, what stands on the floor, two sides and a back.
    m.solid(b.y(hot.max.y..a.h));
    m.solid(b.y(0.0..hot.min.y));
    let wall = 0.04_f64.min(0.1 * a.w).min(0.1 * a.d);
    let body = hot.z(b.min.z..b.max.z - deep);
    for side in body.x(b.min.x..b.min.x + wall).both_sides() {
        m.board(side, &main);
    }
    m.board(body.inset(wall, 0.0, 0.0).z(b.min.z..b.min.z + wall), &main);
    m.mesh.board(b.y(hot.max.y..top).z(b.min.z..b.max.z - deep), &main);
    m.mesh.board(b.y(0.0..hot.min.y).z(b.min.z..b.max.z - deep), &main);
    m.mesh.board(b.y(top..a.h - 0.2 * (a.h - top)), &dark);
    for ring in b.inset(0.1 * a.w, 0.0, 0.1 * a.d).split(0, pieces(a.w, 0.3, 1, 4), 0.0) {
        for spot in ring.split(2, 2, 0.0) {
            let r = 0.4 * spot.size().x.min(spot.size().z);
            let c = spot.center();
            let at = |r: f64| block(c.x - r..c.x + r, top..a.h, c.z - r..c.z + r);
            m.mesh.lathe(
                at(r),
                &[(1.0, 0.6), (1.0, 1.0), (0.82, 1.0), (0.82, 0.6)],
                16,
                &stuff::GRAY_PLASTIC.surface(),
            );
            let cap = at(0.4 * r).y(top..a.h - 0.1 * (a.h - top));
            m.mesh.lathe(cap, &[(1.0, 0.0), (1.0, 1.0)], 16, &stuff::GRAY_PLASTIC.surface());
        }
    }
    let face = b.inset(0.002, 0.0, 0.0).z(b.max.z - deep..b.max.z);
    let panel = face.y(top - 0.13 * a.h..top);
    m.mesh.board(panel.z(face.min.z..face.max.z - 0.5 * deep), &main);
    for knob in panel.inset(0.08 * a.w, 0.0, 0.0).split(0, pieces(a.w, 0.13, 3, 8), 0.0) {
        let (c, r) = (knob.center(), 0.3 * knob.size().x.min(0.13 * a.h));
        dial(
            &mut m.mesh,
            block(c.x - r..c.x + r, c.y - r..c.y + r, face.max.z - 0.5 * deep..face.max.z - 0.1 * deep),
            &[(1.0, 0.0), (0.85, 1.0)],
            &dark,
        );
    }
    let door = face.y(0.16 * a.h..top - 0.14 * a.h);
    hatch(&mut m, door, false, false, &main, &stuff::STEEL.surface());
    let size = door.size();
    let window = door.inset(0.14 * size.x, 0.0, 0.0).y(door.min.y + 0.18 * size.y..door.min.y + 0.72 * size.y);
    m.mesh.board(window.z(door.min.z..door.min.z + 0.56 * deep), &dark);
    m.mesh.board(face.y(0.03 * a.h..0.15 * a.h).z(face.min.z..face.max.z - 0.5 * deep), &shade(&main, 0.92));
    m
}

/// Dishwashers (a plain door), washing machines and dryers (a round one).
pub(super) fn washer(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let main = a.main(stuff::WHITE);
    let face = appliance(&mut m, a, &main);
    let deep = face.size().z;
    let panel = face.y(face.max.y - 0.14 * a.h..face.max.y);
    m.mesh.board(panel.z(face.min.z..face.max.z - 0.5 * deep), &shade(&main, 0.88));
    m.mesh.crisp(
        panel.inset(0.36 * a.w, 0.045 * a.h, 0.0).z(face.max.z - 0.5 * deep..face.max.z - 0.4 * deep),
        &stuff::SCREEN.surface(),
    );
    m.solid(panel);
    let front = face.y(face.min.y..panel.min.y - 0.004 * a.h);
    if a.says(&["dishwasher", "dish"]) {
        hatch(&mut m, front, false, false, &main, &stuff::STEEL.surface());
        return m;
    }
    m.mesh.board(front.z(face.min.z..face.max.z - 0.5 * deep), &main);
    let c = front.center();
    let r = (0.34 * a.w).min(0.42 * front.size().y);
    let ring = block(c.x - r..c.x + r, c.y - r..c.y + r, face.max.z - 0.5 * deep..face.max.z);
    dial(&mut m.mesh, ring, &[(1.0, 0.0), (0.98, 0.8), (0.9, 1.0), (0.76, 1.0), (0.7, 0.3)], &stuff::STEEL.surface());
    let r = 0.72 * r;
    let glass = block(c.x - r..c.x + r, c.y - r..c.y + r, face.max.z - 0.45 * deep..face.max.z - 0.1 * deep);
    dial(&mut m.mesh, glass, &[(1.0, 0.0), (0.8, 0.7), (0.3, 1.0)], &Stuff(Finish::Screen, 0x27323b).surface());
    // The front around the porthole stays; the porthole opens.
    let plate = front.z(face.min.z..face.max.z - 0.5 * deep);
    for strip in [plate.y(plate.min.y..ring.min.y), plate.y(ring.max.y..plate.max.y)] {
        m.solid(strip);
    }
    for strip in [plate.x(plate.min.x..ring.min.x), plate.x(ring.max.x..plate.max.x)] {
        m.solid(strip.y(ring.min.y..ring.max.y));
    }
    m.leaf("door", ring, Hung::Left);
    m
}

/// Microwaves and small ovens: a window and, at the viewer's right (−x), a panel.
pub(super) fn microwave(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let main = a.main(stuff::STEEL);
    let dark = stuff::DARK_PLASTIC.surface();
    let b = a.whole();
    let deep = 0.06 * a.d;
    let wall = 0.02_f64.min(0.1 * a.w).min(0.1 * a.h).min(0.1 * a.d);
    m.shell(b.z(b.min.z..b.max.z - deep), wall, 0.0, &main);
    let face = b.inset(0.02 * a.w, 0.04 * a.h, 0.0).z(b.max.z - deep..b.max.z);
    let cut = face.min.x + 0.26 * face.size().x;
    let door = face.x(cut..face.max.x);
    m.mesh.board(door.z(face.min.z..face.max.z - 0.5 * deep), &main);
    m.mesh.board(door.inset(0.06 * a.w, 0.12 * a.h, 0.0).z(face.min.z..face.max.z - 0.3 * deep), &dark);
    m.leaf("door", door, Hung::Right);
    let panel = face.x(face.min.x..cut - 0.01 * a.w);
    // Behind the panel is what makes it work.
    m.solid(panel.z(b.min.z + wall..face.max.z - 0.5 * deep));
    m.mesh.board(panel.z(face.min.z..face.max.z - 0.5 * deep), &dark);
    let screen = panel.inset(0.03 * a.w, 0.0, 0.0).y(face.max.y - 0.2 * a.h..face.max.y - 0.06 * a.h);
    m.mesh.crisp(screen.z(face.min.z..face.max.z - 0.4 * deep), &Stuff(Finish::Glow, 0x64d2b0).surface());
    let grip = door.x(cut + 0.015 * a.w..cut + 0.035 * a.w).inset(0.0, 0.1 * a.h, 0.0);
    handle(&mut m, grip.z(face.max.z - 0.45 * deep..face.max.z), &stuff::STEEL.surface());
    m
}

/// A hood over a stove: a chimney on a flared canopy, back to the wall.
pub(super) fn hood(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let main = a.main(stuff::STEEL);
    let b = a.whole();
    let rim = 0.06_f64.min(0.15 * a.h);
    let cut = rim + 0.35 * (a.h - rim);
    m.board(b.y(0.0..rim), &main);
    let chimney = b.inset(0.34 * a.w, 0.0, 0.0).z(b.min.z..b.min.z + 0.5 * a.d);
    m.taper(b.y(rim..rim + 0.1 * a.h), chimney.y(rim + 0.1 * a.h..cut), &main);
    m.board(chimney.y(cut..a.h), &main);
    let lamp = b.inset(0.3 * a.w, 0.0, 0.4 * a.d).y(0.0..0.3 * rim);
    m.mesh.crisp(lamp, &stuff::WARM.surface());
    m
}

/// A spout that rises behind a basin and bends to the front; fills `b`.
pub(super) fn tap(m: &mut BuiltModel, b: Block, s: &Surface) {
    m.solid(b);
    let r = 0.36 * b.size().x.min(b.size().z);
    m.mesh.stretch(b, |mesh| {
        let at = |y: f64, z: f64| Vec3::new(0.0, y * b.size().y, b.min.z + z * b.size().z);
        mesh.tube(&[at(0.0, 0.2), at(0.7, 0.2), at(0.92, 0.35), at(0.92, 0.75), at(0.72, 0.95)], 0.7 * r, s);
        let foot = block(-r..r, 0.0..0.1 * b.size().y, b.min.z + 0.2 * b.size().z - r..b.min.z + 0.2 * b.size().z + r);
        mesh.drum(foot, s);
    });
}

/// Sinks: in a worktop over cupboards, or a ceramic basin on a pillar for washrooms. The box includes the tap; the rim is the
/// support surface.
pub(super) fn sink(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let rim = a.h - 0.2_f64.min(0.25 * a.h);
    m.surface = Some(rim);
    let chrome = stuff::CHROME.surface();
    let wash = a.says(&["bathroom", "wash", "washbasin", "basin", "pedestal", "hand", "lavatory", "ceramic"]);
    let main = a.main(if wash { stuff::CERAMIC } else { stuff::WHITE });
    let (bowl, worktop) =
        if wash { (stuff::CERAMIC.surface(), main.clone()) } else { (stuff::STEEL.surface(), a.second(stuff::STONE)) };
    let edge = (0.07_f64).min(0.16 * a.w).min(0.16 * a.d);
    let thick = if wash { 0.15 } else { 0.05 } * rim;
    let back = 0.13_f64.min(0.26 * a.d);
    let top = b.y(rim - thick..rim);
    let wide = if a.w > 1.1 && !wash { 0.25 * a.w } else { edge };
    let hole = b.x(b.min.x + wide..b.max.x - edge).z(b.min.z + back..b.max.z - edge);
    // Four strips of worktop around the bowl; the solid is whole, so that things can be put down.
    m.solid(top);
    for strip in [
        top.z(b.min.z..hole.min.z),
        top.z(hole.max.z..b.max.z),
        top.x(b.min.x..hole.min.x).z(hole.min.z..hole.max.z),
        top.x(hole.max.x..b.max.x).z(hole.min.z..hole.max.z),
    ] {
        m.mesh.crisp(strip, &worktop);
    }
    m.mesh.crisp(hole.y(rim - thick..rim - 0.8 * thick), &shade(&bowl, 0.9));
    let drain = 0.08 * hole.size().x.min(hole.size().z);
    let c = hole.center();
    let bowls = if a.says(&["double", "twin"]) { vec![-0.25, 0.25] } else { vec![0.0] };
    if bowls.len() > 1 {
        let between = 0.02_f64.min(0.1 * hole.size().x);
        m.mesh.crisp(hole.x(c.x - between..c.x + between).y(rim - 0.8 * thick..rim), &worktop);
    }
    for share in bowls {
        let x = c.x + share * hole.size().x;
        m.mesh.drum(
            block(x - drain..x + drain, rim - 0.8 * thick..rim - 0.74 * thick, c.z - drain..c.z + drain),
            &chrome,
        );
    }
    if wash {
        let column = block(-0.16 * a.w..0.16 * a.w, 0.0..rim - thick, b.min.z + 0.1 * a.d..b.min.z + 0.6 * a.d);
        m.solid_drum(column);
        m.mesh.lathe(column, &[(1.0, 0.0), (0.85, 0.08), (0.72, 0.5), (1.0, 1.0)], 24, &main);
    } else {
        let body = b.y(0.0..rim - thick).inset(0.005, 0.0, 0.0).z(b.min.z..b.max.z - 0.02 * a.d);
        m.solid(body);
        let deep = 0.035_f64.min(0.1 * a.d);
        m.mesh.crisp(
            body.inset(0.01, 0.0, 0.0).y(0.0..0.08 * rim).z(b.min.z..body.max.z - 2.0 * deep),
            &stuff::DARK_PLASTIC.surface(),
        );
        m.mesh.board(body.y(0.08 * rim..rim - thick).z(b.min.z..body.max.z - deep), &main);
        for (i, door) in body
            .y(0.085 * rim..rim - thick - 0.004)
            .z(body.max.z - deep..body.max.z)
            .split(0, pieces(a.w, 0.45, 1, 6), 0.005)
            .enumerate()
        {
            draw_hatch(&mut m, door, true, i % 2 == 1, &shade(&main, 1.1), &stuff::STEEL.surface());
        }
    }
    let half = 0.04_f64.min(0.1 * a.w);
    tap(
        &mut m,
        block(c.x - half..c.x + half, rim..a.h, b.min.z + 0.2 * back..b.min.z + 0.2 * back + 0.45 * a.d.min(0.4)),
        &chrome,
    );
    m
}

/// Coffee machines and the like: a body with a bay for the cup.
pub(super) fn coffee_machine(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::STEEL);
    let dark = stuff::DARK_PLASTIC.surface();
    m.solid(b);
    m.mesh.rounded(b.y(0.0..0.12 * a.h), 0.01, 2, &dark);
    m.mesh.rounded(b.y(0.12 * a.h..0.62 * a.h).z(b.min.z..b.min.z + 0.45 * a.d), 0.01, 2, &dark);
    m.mesh.rounded(b.y(0.62 * a.h..a.h).z(b.min.z..b.max.z - 0.04 * a.d), 0.02, 3, &main);
    let spouts = b.inset(0.36 * a.w, 0.0, 0.0).y(0.5 * a.h..0.62 * a.h).z(0.1 * a.d..0.26 * a.d);
    m.mesh.board(spouts, &dark);
    let grate = b.inset(0.1 * a.w, 0.0, 0.0).y(0.12 * a.h..0.135 * a.h).z(b.min.z + 0.5 * a.d..b.max.z - 0.04 * a.d);
    m.mesh.crisp(grate, &stuff::STEEL.surface());
    let screen = b.inset(0.25 * a.w, 0.0, 0.0).y(0.72 * a.h..0.9 * a.h).z(b.max.z - 0.04 * a.d..b.max.z - 0.02 * a.d);
    m.mesh.crisp(screen, &stuff::SCREEN.surface());
    m
}

/// Kettles and jugs.
pub(super) fn kettle(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::STEEL);
    let dark = stuff::DARK_PLASTIC.surface();
    let r = (0.38 * a.w).min(0.5 * a.d);
    m.solid(b);
    let body = block(-r..r, 0.0..0.88 * a.h, b.min.z..b.max.z).x(b.min.x + 0.14 * a.w..b.min.x + 0.14 * a.w + 2.0 * r);
    m.mesh.lathe(body, &[(1.0, 0.0), (1.0, 0.08), (0.94, 0.3), (0.7, 0.9), (0.5, 1.0)], 24, &main);
    let c = body.center();
    m.mesh.drum(block(c.x - 0.3 * r..c.x + 0.3 * r, 0.86 * a.h..a.h, -0.15 * a.d..0.15 * a.d), &dark);
    let spout = [(b.min.x, 0.8 * a.h), (c.x, 0.8 * a.h), (c.x, 0.55 * a.h)];
    m.mesh.extrude(2, &spout, -0.1 * a.d..0.1 * a.d, &main);
    let t = (0.04 * a.h).min(0.2 * a.d);
    let grip = [(0.5, 0.82), (0.95, 0.82), (1.0, 0.7), (0.9, 0.3), (0.55, 0.25)]
        .map(|(x, y)| Vec3::new(c.x + x * (b.max.x - c.x), y * a.h, 0.0));
    m.mesh.stretch(block(c.x + 0.4 * r..b.max.x, 0.2 * a.h..0.86 * a.h, -t..t), |mesh| mesh.tube(&grip, t, &dark));
    m
}

/// Toasters: two slots on top, a lever at the side.
pub(super) fn toaster(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(stuff::STEEL);
    let dark = stuff::DARK_PLASTIC.surface();
    m.solid(b);
    m.mesh.rounded(b.x(b.min.x..b.max.x - 0.05 * a.w).y(0.04 * a.h..0.99 * a.h), 0.04, 4, &main);
    m.mesh.board(b.x(b.min.x + 0.02 * a.w..b.max.x - 0.07 * a.w).inset(0.0, 0.0, 0.04 * a.d).y(0.0..0.06 * a.h), &dark);
    for slot in
        b.x(b.min.x + 0.12 * a.w..b.max.x - 0.17 * a.w).y(0.9 * a.h..a.h).inset(0.0, 0.0, 0.16 * a.d).split(2, 2, 1.0)
    {
        m.mesh.crisp(slot, &dark);
    }
    m.mesh.board(b.x(b.max.x - 0.06 * a.w..b.max.x).y(0.6 * a.h..0.68 * a.h).inset(0.0, 0.0, 0.38 * a.d), &dark);
    m
}

/// A brick oven for wood fires: a plinth, a dome with an arched mouth, a flue.
pub(super) fn pizza_oven(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let (brick, clay) = (Stuff(Finish::Stone, 0x9c5a3c).surface(), a.main(Stuff(Finish::Plaster, 0xd8c3a5)));
    let (slab, sill) = (0.5 * a.h, 0.56 * a.h);
    m.board(b.share(0.03..0.97, 0.0..1.0, 0.03..0.97).y(0.0..slab), &brick);
    m.board(b.y(slab..sill), &Stuff(Finish::Stone, 0x5f5a55).surface());
    m.surface = Some(sill);
    let niche = b.share(0.25..0.75, 0.0..1.0, 0.9..0.97).y(0.1 * a.h..0.38 * a.h);
    m.mesh.board(niche.z(b.min.z + 0.96 * a.d..b.min.z + 0.98 * a.d), &stuff::BLACK_STEEL.surface());
    let dome = b.share(0.02..0.98, 0.0..1.0, 0.02..0.9).y(sill..0.9 * a.h);
    m.solid_drum(dome);
    m.mesh.lathe(dome, &[(1.0, 0.0), (0.98, 0.25), (0.86, 0.55), (0.62, 0.8), (0.3, 0.95), (0.08, 1.0)], 28, &clay);
    let arch = b.share(0.28..0.72, 0.0..1.0, 0.7..0.985).y(sill..sill + 0.24 * a.h);
    m.board(arch, &brick);
    let mouth = arch.inset(0.06 * a.w, 0.0, 0.0).y(sill + 0.001..sill + 0.17 * a.h);
    m.mesh.board(mouth.z(b.min.z + 0.97 * a.d..b.min.z + 0.99 * a.d), &Stuff(Finish::Iron, 0x17120f).surface());
    let fire = mouth.inset(0.03 * a.w, 0.0, 0.0).y(mouth.min.y..mouth.min.y + 0.35 * mouth.size().y);
    m.mesh.board(fire.z(b.min.z + 0.97 * a.d..b.min.z + 0.995 * a.d), &Stuff(Finish::Glow, 0xff8a2a).surface());
    m.drum(b.share(0.42..0.58, 0.0..1.0, 0.55..0.71).y(0.8 * a.h..a.h), &stuff::BLACK_STEEL.surface());
    m
}

/// A bowl that is open at the top: coals, and a grate above them.
fn coals(m: &mut BuiltModel, b: Block, main: &Surface) {
    let size = b.size();
    let wall = 0.03 * size.min().min(1.0);
    let floor = b.y(b.min.y..b.min.y + wall);
    m.board(floor, main);
    let above = b.y(floor.max.y..b.max.y);
    for side in [above.x(b.min.x..b.min.x + wall), above.x(b.max.x - wall..b.max.x)] {
        m.board(side, main);
    }
    let inner = above.inset(wall, 0.0, 0.0);
    for face in [inner.z(b.min.z..b.min.z + wall), inner.z(b.max.z - wall..b.max.z)] {
        m.board(face, main);
    }
    let inner = inner.inset(0.0, 0.0, wall);
    let level = |share: f64| above.min.y + share * above.size().y;
    m.mesh.crisp(inner.y(above.min.y..level(0.4)), &Stuff(Finish::Paint, 0x1b1815).surface());
    for bar in inner.y(level(0.8)..level(0.88)).split(0, 8, 0.6 * size.x / 8.0) {
        m.mesh.crisp(bar, &stuff::STEEL.surface());
    }
}

/// A grill on a trolley: a bowl of coals under a lid, a shelf at each side.
pub(super) fn barbecue(a: &Ask) -> BuiltModel {
    let mut m = BuiltModel::default();
    let b = a.whole();
    let main = a.main(Stuff(Finish::Paint, 0x2b2d30));
    let (steel, wood) = (stuff::STEEL.surface(), a.second(stuff::OAK));
    let rim = 0.78 * a.h;
    m.surface = Some(rim);
    let stand = b.share(0.2..0.8, 0.0..1.0, 0.08..0.92);
    let leg = 0.035_f64.min(0.1 * a.d).min(0.1 * a.w);
    m.legs(stand.y(0.0..0.55 * a.h), leg, &stuff::BLACK_STEEL.surface());
    m.board(stand.y(0.16 * a.h..0.19 * a.h).inset(0.002, 0.0, 0.002), &wood);
    let body = b.share(0.18..0.82, 0.0..1.0, 0.0..1.0);
    coals(&mut m, body.y(0.55 * a.h..rim), &main);
    for side in b.share(0.0..0.18, 0.0..1.0, 0.1..0.9).both_sides() {
        m.board(side.y(rim - 0.04 * a.h..rim), &wood);
    }
    // The lid is lower at the front, and turns about the upper edge of its back.
    let lid = body.z(b.min.z..b.max.z - 0.04 * a.d);
    let foot = lid.y(rim..rim + 0.001);
    let head = lid.inset(0.04 * a.w, 0.0, 0.0).y(a.h - 0.001..a.h).z(lid.min.z..lid.max.z - 0.25 * a.d);
    let before = m.parts.len();
    m.taper(foot, head, &main);
    let grip = body.inset(0.1 * a.w, 0.0, 0.0).y(rim + 0.03 * a.h..rim + 0.06 * a.h);
    m.board(grip.z(b.max.z - 0.04 * a.d..b.max.z), &steel);
    let added = m.parts.len() - before;
    if added > 0 {
        m.lid_of("lid", lid.y(rim..a.h), added);
    }
    for knob in body.inset(0.08 * a.w, 0.0, 0.0).y(0.62 * a.h..0.68 * a.h).split(0, 3, 0.0) {
        let c = knob.center();
        let r = (0.025 * a.h).min(0.4 * knob.size().x);
        m.mesh.disc(2, block(c.x - r..c.x + r, c.y - r..c.y + r, b.max.z - 0.005 * a.d..b.max.z), &steel);
    }
    m
}
