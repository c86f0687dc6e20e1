//! A draft as the text of a program, the way a person would write it.
//!
//! Rooms first, then doors and windows, then each room with its things, what is asked of a thing behind it, and at its
//! end, together, what nobody asked for; last the words of the request that became no statement. Each declaration and
//! statement has before it, as `@req`, the words that it comes from, or the reason why it is there (`inferred: …`).
//!
//! Words without a statement stand before a predicate that nobody calls (`unmet1`): it asks for nothing, and can be
//! given a meaning. The text is as the formatter leaves it.

use crate::colors;
use crate::draft::{
    Demand, Draft, DraftRoom, DraftThing, Look, Narrowed, Opening, OpeningKind, Statement, ThingOrigin,
};
use crate::furnish::sill;
use crate::names::{mentions, words};
use crate::text::{folded, phrase, plain, quoted, wrapped};
use scenelang_lang::fmt::{FormatOptions, format};
use std::collections::BTreeMap;
use std::fmt::Write;

/// What the names of predicates begin with that stand for words without a statement.
pub const UNMET: &str = "unmet";

/// What begins a reason in the place of a sentence of the request.
pub const INFERRED: &str = "inferred: ";

/// How wide the request is written at the top, and how many lines of it.
const HEADER: (usize, usize) = (92, 12);

/// The text of a program: compiled, it has the rooms, openings, things and statements of the draft.
pub fn write(draft: &Draft) -> String {
    format(&unformatted(draft), &FormatOptions::default())
}

/// The same before the formatter has been over it, for those who compile it and show it to nobody.
pub(crate) fn unformatted(draft: &Draft) -> String {
    let mut writer = Writer { draft, out: String::new(), behind: behind(draft), unasked: Vec::new(), begun: false };
    writer.program();
    writer.out
}

/// Which statements stand behind which object: the last declared of those they name. `None`: they name none.
fn behind(draft: &Draft) -> BTreeMap<Option<&str>, Vec<usize>> {
    let openings = draft.openings.iter().map(|opening| opening.name.as_str());
    let things = rooms(draft).flat_map(|room| of_room(draft, room)).map(|thing| thing.name.as_str());
    let order: BTreeMap<&str, usize> = openings.chain(things).zip(0..).collect();
    let mut behind: BTreeMap<Option<&str>, Vec<usize>> = BTreeMap::new();
    for (at, statement) in draft.statements.iter().enumerate() {
        let objects = words(&statement.text).into_iter().filter_map(|word| order.get_key_value(word));
        let last = objects.max_by_key(|(_, order)| **order).map(|(name, _)| *name);
        behind.entry(last).or_default().push(at);
    }
    behind
}

/// The rooms in order; last what is in none.
fn rooms(draft: &Draft) -> impl Iterator<Item = Option<usize>> {
    (0..draft.rooms.len()).map(Some).chain([None])
}

/// The things of a room: what is asked for, then what is not.
fn of_room(draft: &Draft, room: Option<usize>) -> impl Iterator<Item = &DraftThing> {
    let own = move |thing: &&DraftThing| thing.room.filter(|at| *at < draft.rooms.len()) == room;
    let own = move |asked: bool| {
        draft.things.iter().filter(own).filter(move |t| matches!(t.source, ThingOrigin::Stated(_)) == asked)
    };
    own(true).chain(own(false))
}

struct Writer<'d> {
    draft: &'d Draft,
    out: String,
    behind: BTreeMap<Option<&'d str>, Vec<usize>>,
    /// Statements that nobody asked for and that are not written yet, each with its reason.
    unasked: Vec<(ThingOrigin, String)>,
    /// Whether the section has come to what nobody asked for.
    begun: bool,
}

impl Writer<'_> {
    fn program(&mut self) {
        self.header();
        if self.draft.guided {
            self.line("import \"std/guidelines.scene\";");
        }
        for room in &self.draft.rooms {
            self.room(room);
        }
        if !self.draft.openings.is_empty() {
            self.heading("Doors and windows");
            for opening in &self.draft.openings {
                self.opening(opening);
            }
            self.not_asked();
        }
        for room in rooms(self.draft) {
            let things: Vec<&DraftThing> = of_room(self.draft, room).collect();
            if things.is_empty() {
                continue;
            }
            let name = room.map(|at| &self.draft.rooms[at]).map(|room| match plain(&room.kind) {
                kind if kind.is_empty() => room.name.clone(),
                kind => kind,
            });
            self.heading(&capital(name.as_deref().unwrap_or("Elsewhere")));
            let asked = things.iter().take_while(|thing| matches!(thing.source, ThingOrigin::Stated(_))).count();
            for (at, thing) in things.into_iter().enumerate() {
                if at == asked {
                    self.begin_unasked();
                }
                self.thing(thing);
            }
            self.not_asked();
        }
        if self.behind.contains_key(&None) {
            self.heading("Everything");
            self.following(None);
            self.not_asked();
        }
        self.notes();
    }

    /// The request, as a comment.
    fn header(&mut self) {
        let (width, most) = HEADER;
        let text: String = self.draft.request.chars().take(width * (most + 1)).collect();
        let mut lines = wrapped(&plain(&text), width);
        if lines.is_empty() {
            return;
        }
        if lines.len() > most {
            lines.truncate(most);
            lines.push("…".into());
        }
        self.line("// From a request in plain words:");
        self.line("//");
        for line in lines {
            self.line(&format!("// > {line}"));
        }
        self.line("");
    }

    fn room(&mut self, room: &DraftRoom) {
        let DraftRoom { name, size: [w, h, d], at: [x, z], .. } = room;
        let kind = plain(&room.kind);
        self.line("");
        if !kind.is_empty() && crate::names::identifier(&kind, "") != *name {
            self.line(&format!("/// {}.", capital(kind.trim_end_matches('.'))));
        }
        self.requirement(&room.source);
        self.line(&format!("region {name};"));
        match room.outline.as_deref() {
            Some(outline) if outline.len() >= 3 => {
                let points: Vec<String> =
                    outline.iter().map(|[x, z]| format!("vec3({}, 0, {})", number(*x), number(*z))).collect();
                self.line(&format!("{name}.vertices <- polygon({});", points.join(", ")));
            }
            _ => self.line(&format!("{name}.pos <- vec3({}, 0, {});", number(*x), number(*z))),
        }
        self.line(&format!("{name}.scale <- vec3({}, {}, {});", number(*w), number(*h), number(*d)));
        let mut features = Vec::new();
        if self.draft.outdoor || self.draft.rooms.len() > 1 && crate::storey::is_outside(&room.kind) {
            features.push("outdoor".to_owned());
        }
        for (part, surface) in [("floor", &room.floor), ("wall", &room.walls)] {
            match surface.color.as_deref().map(|color| (color, colors::known(color))) {
                Some((_, Some(known))) => self.text(name, &format!("{part}Color"), &known),
                Some((color, None)) => {
                    self.text(name, &format!("{part}Color"), &colors::nearest(color).unwrap_or_default());
                    features.push(format!("{} {part}", folded(color)));
                }
                None => {}
            }
            if let Some(material) = &surface.material {
                self.text(name, &format!("{part}Material"), material);
            }
        }
        self.text(name, "features", &features.join(", "));
    }

    fn opening(&mut self, opening: &Opening) {
        let Opening { name, kind, category, rooms, size, look, source } = opening;
        let rooms: Vec<&DraftRoom> = rooms.iter().filter_map(|room| self.draft.rooms.get(*room)).take(2).collect();
        self.declaration(name, 1, source);
        let plain = if *kind == OpeningKind::Door { "door" } else { "window" };
        self.text(name, "category", category.as_deref().unwrap_or(plain));
        self.size(name, *size);
        self.look(name, look);
        let named = |what: &[&str]| {
            let mut about = self.draft.statements.iter().filter(|s| s.text.contains(name.as_str()));
            about.any(|s| mentions(&s.text, name) && what.iter().any(|w| mentions(&s.text, w)))
        };
        let (connected, cleared, raised) = (named(&["connects"]), named(&["clear"]), named(&["pos", "bottom", "top"]));
        if !connected && !rooms.is_empty() {
            let ends: Vec<&str> = rooms.iter().map(|room| room.name.as_str()).collect();
            self.statement(source, format!("assert connects({name}, {});", ends.join(", ")));
        }
        let ceiling = rooms.iter().map(|room| room.size[1]).fold(f64::INFINITY, f64::min);
        match kind {
            OpeningKind::Door => {
                let asked = [
                    (!raised).then(|| format!("{name}.pos.y = 0")),
                    (!cleared).then(|| {
                        let depth = number(clear_space(opening));
                        format!("clear({name}, front, {depth}) and clear({name}, behind, {depth})")
                    }),
                ];
                self.inferred("a door stands on the floor and opens freely", &asked);
            }
            OpeningKind::Window if !raised && ceiling.is_finite() => {
                let sill = sill(self.draft, opening);
                self.inferred("a window has a sill", &[Some(format!("{name}.pos.y = {}", number(sill)))]);
            }
            OpeningKind::Window => {}
        }
        self.following(Some(name));
    }

    /// One assertion of several conditions, as far as there are any.
    fn inferred(&mut self, reason: &str, conditions: &[Option<String>]) {
        let conditions: Vec<&str> = conditions.iter().flatten().map(String::as_str).collect();
        if !conditions.is_empty() {
            self.statement(&ThingOrigin::Inferred(reason.to_owned()), format!("assert {};", conditions.join(" and ")));
        }
    }

    /// A statement; one that nobody asked for waits for the end of its section.
    fn statement(&mut self, source: &ThingOrigin, line: String) {
        if matches!(source, ThingOrigin::Inferred(_)) {
            self.unasked.push((source.clone(), line));
            return;
        }
        self.line("");
        self.requirement(source);
        self.line(&line);
    }

    /// Says, once in a section, that nobody asked for what follows.
    fn begin_unasked(&mut self) {
        if !std::mem::replace(&mut self.begun, true) {
            self.line("");
            self.line("// Not asked for:");
        }
    }

    /// What nobody asked for, as far as it waits: statements for the same reason together.
    fn not_asked(&mut self) {
        let mut left = std::mem::take(&mut self.unasked);
        if !left.is_empty() {
            self.begin_unasked();
        }
        while let Some((reason, _)) = left.first().cloned() {
            self.line("");
            let (same, others): (Vec<_>, Vec<_>) = left.into_iter().partition(|(own, _)| *own == reason);
            for (source, line) in same {
                self.requirement(&source);
                self.line(&line);
            }
            left = others;
        }
    }

    fn thing(&mut self, thing: &DraftThing) {
        let DraftThing { name, category, count, room, size, source, .. } = thing;
        self.declaration(name, *count, source);
        self.text(name, "category", &category.replace('_', " "));
        if let Some(size) = size {
            self.size(name, *size);
        }
        self.look_of_each(thing);
        let room = room.and_then(|at| self.draft.rooms.get(at));
        if let Some(room) = room.filter(|room| !self.says_where(thing, room)) {
            let line = if *count > 1 {
                let one = self.free_name(&["each", "one", "element", "any"]);
                format!("assert forall {one} in {name}: inside({one}, {});", room.name)
            } else {
                format!("assert inside({name}, {});", room.name)
            };
            self.statement(source, line);
        }
        self.following(Some(name));
    }

    /// Whether some statement of the draft says already that the whole thing is in the room.
    fn says_where(&self, thing: &DraftThing, room: &DraftRoom) -> bool {
        const PLACES: [&str; 6] = ["inside", "onFloor", "againstWall", "inCorner", "wallMounted", "ceilingMounted"];
        // Most statements are of other things: that is seen without a look at their form.
        let names = |s: &&Statement| s.demand == Demand::Must && s.text.contains(thing.name.as_str());
        self.draft.statements.iter().filter(names).any(|statement| {
            let code: String = statement.text.split_whitespace().collect::<Vec<_>>().join(" ");
            if [" or ", "not ", " implies ", "exists ", "count("].iter().any(|open| code.contains(open)) {
                return false;
            }
            let subject = if thing.count > 1 {
                let all = code.strip_prefix("forall ").and_then(|rest| rest.split_once(" in "));
                match all.filter(|(_, domain)| domain.split(':').next() == Some(&thing.name)) {
                    Some((one, _)) => one.to_owned(),
                    None => return false,
                }
            } else {
                thing.name.clone()
            };
            PLACES.iter().any(|place| code.contains(&format!("{place}({subject}, {})", room.name)))
        })
    }

    /// The statements that stand behind an object, or those that name none.
    fn following(&mut self, name: Option<&str>) {
        for at in self.behind.get(&name).cloned().unwrap_or_default() {
            let draft = self.draft;
            let statement = &draft.statements[at];
            self.statement(&statement.source, statement.line());
        }
        let own = |n: &&Narrowed| Some(n.object.split('[').next().unwrap_or_default()) == name;
        for narrowed in self.draft.narrowed.iter().filter(own) {
            let reason = format!("it opens less far than would be useful: {}", narrowed.why(self.draft));
            self.statement(&ThingOrigin::Inferred(reason), narrowed.line());
        }
    }

    fn is_object(&self, word: &str) -> bool {
        let things = self.draft.things.iter().map(|t| &t.name);
        things.chain(self.draft.openings.iter().map(|o| &o.name)).any(|name| name == word)
    }

    fn notes(&mut self) {
        if self.draft.notes.is_empty() {
            return;
        }
        self.heading("These words of the request are not expressed by any statement");
        for (at, note) in self.draft.notes.iter().enumerate() {
            let name = self.free_name(&[&format!("{UNMET}{}", at + 1), &format!("{UNMET}_{}", at + 1)]);
            let words = self.draft.request.get(note.at.clone()).unwrap_or("");
            self.line("");
            for line in wrapped(&plain(&note.reason), HEADER.0) {
                self.line(&format!("// - {line}"));
            }
            let words: String = folded(words).chars().take(HEADER.0 * HEADER.1).collect();
            self.line(&format!("@req({})", quoted(&words)));
            self.line(&format!("predicate {name}() := true;"));
        }
    }

    /// The first of some names that the draft does not use.
    fn free_name(&self, names: &[&str]) -> String {
        let used = |name: &str| self.is_object(name) || self.draft.rooms.iter().any(|room| room.name == name);
        names.iter().find(|name| !used(name)).or(names.last()).map_or_else(String::new, |name| (*name).to_owned())
    }

    fn heading(&mut self, title: &str) {
        self.begun = false;
        self.line("");
        self.line(&format!("// ---- {title} ----"));
        self.line("");
    }

    fn declaration(&mut self, name: &str, count: usize, source: &ThingOrigin) {
        self.line("");
        self.requirement(source);
        self.line(&if count > 1 { format!("object {name}[{count}];") } else { format!("object {name};") });
    }

    /// The look of a thing; a property in which an element differs is given element by element, for it is assigned once.
    fn look_of_each(&mut self, thing: &DraftThing) {
        let own: Vec<_> =
            self.draft.looks.iter().filter(|own| own.of == thing.name && own.element < thing.count).cloned().collect();
        let differs = |property: &dyn Fn(&Look) -> bool| own.iter().any(|own| property(&own.look));
        let is = [
            differs(&|look| look.color.is_some()),
            differs(&|look| look.material.is_some()),
            differs(&|look| !look.features.is_empty()),
        ];
        let only = |look: &Look, [color, material, features]: [bool; 3]| Look {
            color: look.color.clone().filter(|_| color),
            material: look.material.clone().filter(|_| material),
            features: look.features.iter().filter(|_| features).cloned().collect(),
        };
        self.look(&thing.name, &only(&thing.look, is.map(|differs| !differs)));
        for element in (0..thing.count).filter(|_| is.contains(&true)) {
            let mut look = only(&thing.look, is);
            for own in own.iter().filter(|own| own.element == element).map(|own| &own.look) {
                look.color = own.color.clone().or(look.color);
                look.material = own.material.clone().or(look.material);
                look.features.extend(own.features.iter().cloned());
            }
            self.look(&format!("{}[{element}]", thing.name), &look);
        }
    }

    fn look(&mut self, name: &str, look: &Look) {
        let mut features: Vec<String> = Vec::new();
        match look.color.as_deref().map(|color| (color, colors::known(color))) {
            Some((_, Some(known))) => self.text(name, "color", &known),
            Some((color, None)) => {
                self.text(name, "color", &colors::nearest(color).unwrap_or_default());
                features.push(color.to_owned());
            }
            None => {}
        }
        self.text(name, "material", look.material.as_deref().unwrap_or(""));
        features.extend(look.features.iter().cloned());
        self.text(name, "features", &features.join(", "));
    }

    fn size(&mut self, name: &str, [w, h, d]: [f64; 3]) {
        self.line(&format!("{name}.dimensions <- vec3({}, {}, {});", number(w), number(h), number(d)));
    }

    /// A property that is a text, if there is something to say.
    fn text(&mut self, name: &str, property: &str, text: &str) {
        let text = folded(text);
        if !text.is_empty() {
            self.line(&format!("{name}.{property} <- {};", quoted(&text)));
        }
    }

    fn requirement(&mut self, source: &ThingOrigin) {
        let words = match source {
            ThingOrigin::Stated(at) => phrase(&self.draft.request, at),
            ThingOrigin::Inferred(reason) => format!("{INFERRED}{}", folded(reason)),
        };
        if !words.is_empty() {
            self.line(&format!("@req({})", quoted(&words)));
        }
    }

    fn line(&mut self, line: &str) {
        // A blank line at most between two others.
        if !(line.is_empty() && (self.out.is_empty() || self.out.ends_with("\n\n"))) {
            let _ = writeln!(self.out, "{line}");
        }
    }
}

/// A length in metres, to a tenth of a millimetre.
pub fn number(metres: f64) -> String {
    let rounded = (metres * 1e4).round() / 1e4;
    if !rounded.is_finite() || rounded == 0.0 { "0".into() } else { format!("{rounded}") }
}

fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

/// How far in front of a door and behind it nothing stands (metres): as far as it is wide, within reason.
pub(crate) fn clear_space(door: &Opening) -> f64 {
    door.size[0].clamp(0.7, 1.2)
}
