//! What the words of a request leave open about where small things are: a mouse beside a keyboard is on the keyboard's desk,
//! a novel "on" a bookcase is in it, a wallet on the left of a desk lies on it. Read before sizes and statements are made.

use crate::brief::{Brief, Fact, FactKind, Group, Op, Rel};
use crate::read::lexicon::get;
use crate::text::sentence;
use scenelang_lang::library::usual_size;

/// What has shelves inside, so that what is "on" it is in it.
const SHELVED: [&str; 14] = [
    "bookshelf",
    "bookcase",
    "book shelf",
    "book case",
    "bookstand",
    "toy shelf",
    "shelf unit",
    "wall unit",
    "cubby",
    "cubbies",
    "display cabinet",
    "china cabinet",
    "display case",
    "organizer",
];
/// What things are in rather than on, unless they are said to be on top.
const HOLLOW: [&str; 14] = [
    "vase", "basket", "bucket", "jar", "cooler", "crate", "hamper", "bin", "pot", "cup", "glass", "sink", "bathtub",
    "tub",
];
/// Where things are on what they are usually in.
const ON_TOP: [&str; 4] = ["edge", "rim", "ledge", "lid"];
/// Basins have a rim that things stand on.
const BASINS: [&str; 4] = ["sink", "washbasin", "basin", "vanity"];
/// What nothing stands on: what is "on" it stands where it does.
const THIN: [&str; 5] = ["monitor", "screen", "tv", "television", "keyboard"];
/// No side of a thing that people stand something on is longer, if nothing is known of it (metres).
const SMALL: f64 = 0.45;
/// Things beside things beside things: so many in a chain.
const CHAIN: usize = 4;

/// "An island and a window over the sink": of several things only those are over another that can be, if there are any.
fn hang(brief: &mut Brief) {
    for k in 0..brief.facts.len() {
        if !matches!(brief.facts[k].what, FactKind::Rel(Rel::Above, _)) || brief.facts[k].of.len() < 2 {
            continue;
        }
        let hangs = |a: &usize| {
            let thing = &brief.things[*a];
            thing.opening() || matches!(thing.group, Group::Wall | Group::Ceiling | Group::Screen)
        };
        let stands =
            |a: &usize| matches!(brief.things[*a].group, Group::Floor | Group::Table | Group::Seat | Group::Bed);
        let over: Vec<usize> = brief.facts[k].of.iter().copied().filter(|a| !stands(a)).collect();
        if over.iter().any(hangs) {
            brief.facts[k].of = over;
        }
    }
}

/// "Near the door — sorry, not near it, far from it": what is taken back in the same breath is not said.
fn take_back(brief: &mut Brief) {
    const MENDS: [&str; 8] = ["sorry", "no", "actually", "rather", "correction", "oops", "wait", "mean"];
    let undoes = |new: &Fact, old: &Fact| {
        let is_near = matches!(old.what, FactKind::Rel(Rel::Near, _));
        match (&new.what, &old.what) {
            (FactKind::Rel(rel, to), FactKind::Rel(said, from)) if to == from => {
                new.not && rel == said || is_near && *rel == Rel::Far
            }
            (FactKind::Gap(Op::Least, _, to), FactKind::Rel(_, from)) => is_near && to == from,
            _ => false,
        }
    };
    let is_mended = |new: &Fact, old: &Fact| {
        let between = old.source.at().end..new.source.at().end;
        let words = brief.request.get(between).filter(|words| !words.contains(". ")).unwrap_or_default();
        words.split(|c: char| !c.is_alphanumeric()).any(|word| MENDS.contains(&word.to_lowercase().as_str()))
    };
    let facts = &brief.facts;
    let gone: Vec<bool> = (0..facts.len())
        .map(|k| {
            let old = &facts[k];
            let stands = !old.not && old.source.reason().is_none();
            stands && facts[k + 1..].iter().any(|new| new.of == old.of && undoes(new, old) && is_mended(new, old))
        })
        .collect();
    let mut gone = gone.into_iter();
    brief.facts.retain(|_| !gone.next().unwrap_or(false));
}

pub fn settle(brief: &mut Brief) {
    take_back(brief);
    for _ in 0..CHAIN {
        let small: Vec<usize> = (0..brief.things.len()).filter(|a| is_small(brief, *a)).collect();
        if small.is_empty() {
            break;
        }
        small.into_iter().for_each(|a| brief.things[a].group = Group::Top);
    }
    hang(brief);
    let mut added: Vec<(usize, Fact)> = Vec::new();
    for k in 0..brief.facts.len() {
        let fact = &brief.facts[k];
        let FactKind::Rel(rel, to) = &fact.what else { continue };
        let ([b], false) = (to.as_slice(), fact.not) else { continue };
        let words = sentence(&brief.request, &fact.source.at()).to_lowercase();
        let top = fact.of.iter().all(|a| brief.things[*a].group == Group::Top);
        let new = match rel {
            Rel::LeftOf | Rel::RightOf
                if top && has_top(brief, *b) && (on_side(&words) || carries_in(brief, *b, &fact.of, &words)) =>
            {
                added.push((k, Fact { what: FactKind::Rel(Rel::On, vec![*b]), ..fact.clone() }));
                if *rel == Rel::LeftOf { Rel::OnLeft } else { Rel::OnRight }
            }
            Rel::On if shelved(brief, *b) && !on_top(&words) && fact.of.iter().all(|a| shelvable(brief, *a)) => Rel::In,
            Rel::On if last(brief, *b, &THIN) && !on_top(&words) => {
                let Some(c) = carrier(brief, *b).filter(|c| !fact.of.contains(c)) else { continue };
                brief.facts[k].what = FactKind::Rel(Rel::On, vec![c]);
                continue;
            }
            // "a desk with a laptop on it and a lamp beside it"
            Rel::Beside if top && has_top(brief, *b) && carries_in(brief, *b, &fact.of, &words) => Rel::On,
            Rel::Centre => {
                added.push((k, Fact { what: FactKind::Rel(Rel::On, vec![*b]), ..fact.clone() }));
                continue;
            }
            _ => continue,
        };
        brief.facts[k].what = FactKind::Rel(new, vec![*b]);
    }
    for (k, fact) in added.into_iter().rev() {
        brief.facts.insert(k, fact);
    }
    for _ in 0..brief.things.len() {
        let Some((at, fact)) = (0..brief.facts.len()).find_map(|k| Some((k + 1, beside(brief, k)?))) else { break };
        brief.facts.insert(at, fact);
    }
}

/// Whether words say that things are on what they are usually in.
fn on_top(words: &str) -> bool {
    words.contains("on top") || words.split(|c: char| !c.is_alphanumeric()).any(|word| ON_TOP.contains(&word))
}

/// Whether things stand on it rather than beside it, where they are small.
fn has_top(brief: &Brief, b: usize) -> bool {
    brief.things[b].group == Group::Table || last(brief, b, &BASINS)
}

/// Whether a sentence says of another small thing than these that it is on a thing.
fn carries_in(brief: &Brief, b: usize, but: &[usize], words: &str) -> bool {
    brief.facts.iter().filter(|f| !f.not && !f.of.iter().any(|a| but.contains(a))).any(|f| {
        let on = matches!(&f.what, FactKind::Rel(Rel::On | Rel::Centre | Rel::OnLeft | Rel::OnRight, to) if to == &[b]);
        let small = || f.of.iter().all(|a| brief.things[*a].group == Group::Top);
        on && small() && sentence(&brief.request, &f.source.at()).to_lowercase() == words
    })
}

/// Whether words say that a thing lies on a side of another, rather than beside it.
fn on_side(words: &str) -> bool {
    words.contains("on the left") || words.contains("on the right")
}

/// Whether an item that no table of nouns knows is small: something carries it, or it is beside something small.
fn is_small(brief: &Brief, a: usize) -> bool {
    let item = &brief.things[a];
    let known = get().noun_ending(&item.words).is_some();
    let size = usual_size(&item.name());
    let large = size.is_some_and(|s| s.iter().any(|v| *v > SMALL)) || item.size.iter().flatten().any(|v| *v > SMALL);
    if item.group != Group::Floor || large || known && size.is_none() {
        return false;
    }
    let group = |b: &usize| brief.things[*b].group;
    let carries = |b: &usize| matches!(group(b), Group::Table | Group::Storage | Group::Bed | Group::Seat | Group::Top);
    // "a cup on the desk stands next to a gadget"
    let met = |f: &Fact| {
        !f.not
            && matches!(&f.what, FactKind::Rel(Rel::Beside | Rel::LeftOf | Rel::RightOf, to) if to.contains(&a))
            && f.of.iter().all(|b| group(b) == Group::Top && carrier(brief, *b).is_some())
    };
    if brief.facts.iter().any(met) {
        return true;
    }
    brief.facts.iter().filter(|f| !f.not && f.of.contains(&a)).any(|f| match &f.what {
        FactKind::Rel(Rel::On | Rel::In | Rel::Centre, to) => to.iter().all(carries),
        FactKind::Rel(Rel::Beside | Rel::Near | Rel::LeftOf | Rel::RightOf | Rel::InFrontOf | Rel::Behind, to) => {
            let carried = |b: &usize| brief.things[*b].is_small_plant() && carrier(brief, *b).is_some();
            to.iter().all(|b| group(b) == Group::Top || carried(b))
        }
        _ => false,
    })
}

/// Whether things are in it rather than on it.
fn shelved(brief: &Brief, b: usize) -> bool {
    last(brief, b, &SHELVED) || last(brief, b, &HOLLOW)
}

/// Whether the name of a thing ends in one of these.
fn last(brief: &Brief, b: usize, kinds: &[&str]) -> bool {
    let name = brief.things[b].name();
    kinds.iter().any(|kind| name.strip_suffix(kind).is_some_and(|rest| rest.is_empty() || rest.ends_with(' ')))
}

/// What a thing is said to be on; not a rug.
fn carrier(brief: &Brief, a: usize) -> Option<usize> {
    brief.facts.iter().filter(|f| !f.not && f.of.contains(&a)).find_map(|f| match &f.what {
        FactKind::Rel(Rel::On, on) => on.first().copied().filter(|c| brief.things[*c].group != Group::Flat),
        _ => None,
    })
}

/// Whether a thing can be in a shelf.
fn shelvable(brief: &Brief, a: usize) -> bool {
    let item = &brief.things[a];
    let lamp = item.words.last().is_some_and(|w| w == "lamp" || w == "light");
    !lamp && matches!(item.group, Group::Top | Group::Soft | Group::Wall | Group::Floor) && item.size[1].is_none()
}

/// Of a small thing beside another small thing, or that has one beside it: on what that is on.
fn beside(brief: &Brief, k: usize) -> Option<Fact> {
    let fact = &brief.facts[k];
    let FactKind::Rel(
        Rel::Beside | Rel::Near | Rel::LeftOf | Rel::RightOf | Rel::InFrontOf | Rel::Behind | Rel::Around,
        to,
    ) = &fact.what
    else {
        return None;
    };
    let placed = |a: &usize| {
        let says = |what: &FactKind| {
            matches!(
                what,
                FactKind::Rel(Rel::On | Rel::In | Rel::Under | Rel::Hang | Rel::Mounted, _) | FactKind::Place(..)
            )
        };
        brief.facts.iter().any(|f| !f.not && f.of.contains(a) && says(&f.what))
    };
    let group = |a: &usize| brief.things[*a].group;
    let small = |a: &usize| group(a) == Group::Top || brief.things[*a].is_small_plant();
    let free = |list: &[usize]| list.iter().all(|a| small(a) && !placed(a));
    let carried = |list: &[usize]| {
        let stands = |b: &&usize| matches!(group(b), Group::Top | Group::Screen) || brief.things[**b].is_small_plant();
        list.iter().filter(stands).find_map(|b| carrier(brief, *b))
    };
    let (of, on) = if fact.not {
        return None;
    } else if free(&fact.of) {
        (&fact.of, carried(to)?)
    } else if free(to) {
        (to, carried(&fact.of)?)
    } else {
        return None;
    };
    if of.contains(&on) {
        return None;
    }
    let what = FactKind::Rel(Rel::On, vec![on]);
    Some(Fact { soft: fact.soft, ..Fact::new(of.clone(), what, fact.source.clone()) })
}
