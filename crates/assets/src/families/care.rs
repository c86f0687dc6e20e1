//! What people lie back in: chairs of dentists, tattooists and beauticians, and loungers in the sun.

use crate::ask::Ask;
use crate::looks::{Finish, Stuff, stuff};
use crate::model::Model;

/// A padded seat on a column, with a rest for the legs, a back and a head rest. The feet are at +z.
pub(super) fn treatment_chair(a: &Ask) -> Model {
    let mut m = Model::default();
    let b = a.whole();
    let pad = a.main(Stuff(Finish::Leather, 0x3f6f78));
    let (steel, dark) = (stuff::STEEL.surface(), stuff::DARK_PLASTIC.surface());
    m.board(b.share(0.2..0.8, 0.0..0.06, 0.22..0.78), &dark);
    m.board(b.share(0.38..0.62, 0.06..0.38, 0.4..0.6), &steel);
    m.cushion(b.share(0.12..0.88, 0.38..0.5, 0.26..0.7), &pad);
    m.cushion(b.share(0.16..0.84, 0.32..0.44, 0.68..1.0), &pad);
    // The back rises from the seat towards the head.
    for (i, (from, to)) in [(0.2, 0.34), (0.12, 0.26), (0.05, 0.19)].into_iter().enumerate() {
        let low = 0.46 + 0.14 * i as f64;
        m.cushion(b.share(0.14..0.86, low..low + 0.17, from..to), &pad);
    }
    m.cushion(b.share(0.3..0.7, 0.86..1.0, 0.0..0.13), &pad);
    for arm in b.share(0.0..0.14, 0.58..0.63, 0.3..0.62).both_sides() {
        m.board(arm, &dark);
        m.board(arm.share(0.0..1.0, 0.0..1.0, 0.1..0.25).y(0.42 * a.h..arm.min.y), &steel);
    }
    m.surface = Some(0.5 * a.h);
    m
}

/// A low frame with slats and a raised back at -z.
pub(super) fn lounger(a: &Ask) -> Model {
    let mut m = Model::default();
    let b = a.whole();
    let wood = a.main(stuff::OAK);
    let cloth = a.second(stuff::LINEN);
    let flat = 0.42;
    for side in b.share(0.0..0.1, flat - 0.1..flat, 0.0..1.0).both_sides() {
        m.board(side, &wood);
    }
    for (x, z) in [(0.0, 0.06), (0.9, 0.06), (0.0, 0.86), (0.9, 0.86)] {
        m.board(b.share(x..x + 0.1, 0.0..flat - 0.1, z..z + 0.06), &wood);
    }
    m.cushion(b.share(0.1..0.9, flat - 0.04..flat + 0.12, 0.34..1.0), &cloth);
    for i in 0..4 {
        let (low, far) = (flat + 0.11 * f64::from(i), 0.36 - 0.1 * f64::from(i));
        m.cushion(b.share(0.1..0.9, low..low + 0.25, far - 0.06..far), &cloth);
    }
    m.surface = Some((flat + 0.12) * a.h);
    m
}
