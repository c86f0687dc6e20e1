//! Toys.

use crate::ask::Ask;
use crate::looks::{Finish, Stuff, shade, stuff};
use crate::model::Model;

/// A bear that sits.
pub(super) fn teddy(a: &Ask) -> Model {
    let mut m = Model::default();
    let b = a.whole();
    let fur = a.main(Stuff(Finish::Fabric, 0xa5733f));
    let light = shade(&fur, 1.35);
    let dark = stuff::DARK_PLASTIC.surface();
    let body = b.share(0.16..0.84, 0.0..0.58, 0.1..0.82);
    let head = b.share(0.2..0.8, 0.5..0.94, 0.16..0.84);
    for part in [body, head] {
        m.solid(part);
        m.mesh.ball(part, &fur);
    }
    let pairs = [
        b.share(0.14..0.36, 0.82..1.0, 0.36..0.58),
        b.share(0.0..0.28, 0.26..0.52, 0.34..0.76),
        b.share(0.06..0.4, 0.0..0.24, 0.5..1.0),
    ];
    for part in pairs.into_iter().flat_map(|part| part.both_sides()) {
        m.solid(part);
        m.mesh.ball(part, &fur);
    }
    let tail = b.share(0.42..0.58, 0.06..0.2, 0.0..0.2);
    m.solid(tail);
    m.mesh.ball(tail, &fur);
    m.mesh.ball(b.share(0.3..0.7, 0.1..0.46, 0.6..0.86), &light);
    m.mesh.ball(b.share(0.36..0.64, 0.55..0.74, 0.68..0.92), &light);
    m.mesh.bead(b.share(0.45..0.55, 0.67..0.74, 0.84..0.94), &dark);
    for eye in b.share(0.34..0.41, 0.73..0.79, 0.72..0.8).both_sides() {
        m.mesh.bead(eye, &dark);
    }
    m
}
