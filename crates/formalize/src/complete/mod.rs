//! What a request leaves open is added to its brief: what rooms of a kind have, doors, seats for people, and what small
//! things stand on. All that is added says why.

pub(crate) mod defaults;
mod home;
mod settle;

use crate::brief::Brief;

/// How much is added.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Extent {
    /// Rooms that a home has, furniture that such rooms have, and doors.
    Usual,
    /// Nothing but what the plan needs: doors between rooms, without which nobody gets from one to the other.
    Literal,
}

pub fn complete(mut brief: Brief, extent: Extent) -> Brief {
    defaults::counted(&mut brief);
    match extent {
        Extent::Usual => {
            let scale = home::complete(&mut brief);
            crate::furnish::refine(&mut brief);
            crate::furnish::measure(&mut brief);
            home::scale(&mut brief, scale);
            defaults::seats(&mut brief);
            defaults::fence(&mut brief);
        }
        Extent::Literal => {
            crate::furnish::in_rows(&mut brief);
            home::fold(&mut brief);
        }
    }
    settle::settle(&mut brief);
    brief
}
