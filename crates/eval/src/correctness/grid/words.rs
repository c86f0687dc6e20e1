//! What the floor solver has words for: each object is at the edge or in the middle, and beside that in relations to objects
//! that are placed before it.

use crate::dataset::{DatasetScene, Object, Relation};

/// What is asked of an object; targets are indices of objects before it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Constraint {
    Edge,
    Middle,
    Near(usize),
    Far(usize),
    LeftOf(usize),
    RightOf(usize),
    InFrontOf(usize),
    SideOf(usize),
    FaceTo(usize),
    CenterAligned(usize),
}

impl Constraint {
    /// The published weight of its kind.
    pub fn weight(self) -> f64 {
        match self {
            Self::Edge | Self::Middle => 1.0,
            Self::Near(_) | Self::Far(_) => 1.8,
            _ => 0.5,
        }
    }
}

/// The objects on the floor of a room by their names, in the order in which they are placed, with what is asked of each.
pub(crate) fn constraints(scene: &DatasetScene, room: &str) -> (Vec<String>, Vec<Vec<Constraint>>) {
    let (mut names, mut all): (Vec<String>, Vec<Vec<Constraint>>) = (Vec::new(), Vec::new());
    let mut first: Vec<(&str, usize, u32)> = Vec::new();
    for object in scene.objects.iter().filter(|object| object.room == room) {
        let own: Vec<&Relation> = scene.relations.iter().filter(|r| r.subject == object.name).collect();
        if own.iter().any(|r| matches!(r.relation.as_str(), "on" | "hung" | "ceiling" | "over")) {
            continue;
        }
        first.push((&object.name, names.len(), object.count));
        for nth in 0..object.count {
            let target = |name: &str| {
                let (_, at, count) = first.iter().find(|(known, ..)| *known == name)?;
                Some(at + (nth % count) as usize)
            };
            let before = (nth > 0).then(|| names.len() - 1);
            all.push(of(&own, before, target));
            names.push(instance(object, nth));
        }
    }
    (names, all)
}

/// One of the things that an object stands for.
pub(crate) fn instance(object: &Object, nth: u32) -> String {
    if object.count == 1 { object.name.clone() } else { format!("{}[{nth}]", object.name) }
}

/// `before` is the one before it of its own kind.
fn of(own: &[&Relation], before: Option<usize>, target: impl Fn(&str) -> Option<usize>) -> Vec<Constraint> {
    let is_edge = own.iter().any(|r| matches!(r.relation.as_str(), "wall" | "corner"));
    let mut out = vec![if is_edge { Constraint::Edge } else { Constraint::Middle }];
    for relation in own {
        let word = relation.relation.as_str();
        if let ("row" | "apart", Some(before)) = (word, before) {
            out.push(if word == "row" { Constraint::CenterAligned(before) } else { Constraint::Far(before) });
        }
        let Some(at) = target(&relation.object) else { continue };
        match word {
            "at" | "around" => out.extend([Constraint::Near(at), Constraint::FaceTo(at)]),
            "near" | "close" => out.push(Constraint::Near(at)),
            "beside" => out.extend([Constraint::SideOf(at), Constraint::Near(at)]),
            // As published, this word brings the alignment with it.
            "before" => out.extend([Constraint::InFrontOf(at), Constraint::CenterAligned(at), Constraint::Near(at)]),
            "far" => out.push(Constraint::Far(at)),
            "facing" => out.push(Constraint::FaceTo(at)),
            "left" => out.push(Constraint::LeftOf(at)),
            "right" => out.push(Constraint::RightOf(at)),
            _ => {}
        }
    }
    out
}
