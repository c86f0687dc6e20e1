//! What was added is taken out again where it is in the way: first what was added last, with all that is fixed to it.

use crate::draft::{Draft, OpeningKind, ThingOrigin};
use crate::names::words;
use std::collections::BTreeSet;

impl Draft {
    /// Of each group of names that are in each other's way, takes out the one that was added last, and what is fixed to
    /// it. Whether there was any: what the request asks for stays.
    pub fn leave_out(&mut self, groups: &[Vec<String>]) -> bool {
        let mut gone: BTreeSet<String> = BTreeSet::new();
        for group in groups {
            if group.iter().any(|name| gone.contains(name)) {
                continue;
            }
            // Seats for the people that the request names are as good as asked for.
            let added = |i: &usize| matches!(&self.things[*i].source, ThingOrigin::Inferred(why) if !why.ends_with("people sit there"));
            let named = |i: &usize| group.contains(&self.things[*i].name);
            let last = (0..self.things.len()).rev().filter(added).find(named);
            let window = || {
                self.openings.iter().find(|o| {
                    o.kind == OpeningKind::Window
                        && matches!(o.source, ThingOrigin::Inferred(_))
                        && group.contains(&o.name)
                })
            };
            if let Some(last) = last {
                gone.insert(self.things[last].name.clone());
            } else if let Some(window) = window() {
                gone.insert(window.name.clone());
            }
        }
        self.take_out(gone)
    }

    /// Whether there is anything that was added and may go.
    pub fn has_additions(&self) -> bool {
        self.things.iter().any(|t| matches!(t.source, ThingOrigin::Inferred(_)) && !t.category.ends_with("light"))
    }

    /// Takes out all that was added to rooms, but for doors and lights.
    pub fn leave_out_all(&mut self) -> bool {
        let added = self.things.iter().filter(|t| matches!(t.source, ThingOrigin::Inferred(_)));
        let gone = added.filter(|t| !t.category.ends_with("light")).map(|t| t.name.clone()).collect();
        self.take_out(gone)
    }

    fn take_out(&mut self, mut gone: BTreeSet<String>) -> bool {
        if gone.is_empty() {
            return false;
        }
        // What is fixed to something that goes, goes too.
        loop {
            let places = |text: &str| text.contains(".pos = ") || text.contains("onFloor(");
            let fixed = self.statements.iter().filter(|s| places(&s.text)).filter_map(|s| {
                let names = words(&s.text);
                let added = |name: &str| {
                    self.things.iter().any(|t| t.name == name && matches!(t.source, ThingOrigin::Inferred(_)))
                        || self.openings.iter().any(|o| o.name == name && matches!(o.source, ThingOrigin::Inferred(_)))
                };
                let own = names.iter().find(|name| added(name))?;
                (!gone.contains(*own) && names.iter().any(|name| gone.contains(*name))).then(|| (*own).to_owned())
            });
            let more: Vec<String> = fixed.collect();
            if more.is_empty() {
                break;
            }
            gone.extend(more);
        }
        for thing in self.things.iter().filter(|thing| gone.contains(&thing.name)) {
            match self.left_out.iter_mut().find(|(category, _)| *category == thing.category) {
                Some((_, count)) => *count += thing.count,
                None => self.left_out.push((thing.category.clone(), thing.count)),
            }
        }
        self.statements.retain(|s| !words(&s.text).iter().any(|name| gone.contains(*name)));
        self.things.retain(|t| !gone.contains(&t.name));
        self.openings.retain(|o| !gone.contains(&o.name));
        true
    }
}
