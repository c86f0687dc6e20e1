//! What `check` tells people of each `allowCollide`.

use scenelang_verify::report::model::{Overlap, Permission};
use std::fmt::Write;

/// More permissions than these are not listed.
const MOST: usize = 20;

/// The lines of a report on permissions; empty where there are none.
pub fn listed(permissions: &[Permission]) -> String {
    if permissions.is_empty() {
        return String::new();
    }
    let mut out = String::from("Permissions to collide:\n");
    for Permission { text, hides, complete } in permissions.iter().take(MOST) {
        let says = match hides {
            None if *complete => "hides nothing".to_owned(),
            None => "there are too many objects in one place to determine which overlaps it allows".to_owned(),
            Some(Overlap { objects: [a, b], depth, others }) => {
                let more = match others {
                    0 => String::new(),
                    1 => ", and 1 more pair with a smaller overlap".to_owned(),
                    n => format!(", and {n} more pairs with smaller overlaps"),
                };
                format!("allows {a} and {b} to overlap by {depth:.3} m{more}")
            }
        };
        let _ = writeln!(out, "  {text}: {says}");
    }
    if permissions.len() > MOST {
        let _ = writeln!(out, "  … and {} more", permissions.len() - MOST);
    }
    out
}
