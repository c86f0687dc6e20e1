//! What `check` says of each `allowCollide`: how far things are inside each other that may be, so that nobody has to trust a
//! permission that hides more than it was meant for.

use scenelang_lang::ast::Allow;
use scenelang_lang::program::{Allowance, ObjectId};
use scenelang_verify::report::model::{Overlap, Permission};
use scenelang_verify::rules::{collide, pairs_up_to};
use scenelang_verify::{Checked, Options, World};
use std::fmt::Write;

/// What measuring the pairs may cost, in gaps of two boxes.
const GAPS: usize = 2_000_000;
/// More permissions than these are not listed.
const MOST: usize = 20;

/// The program's permissions to collide and what each hides, measured in the layout.
pub fn measured(checked: &Checked) -> Vec<Permission> {
    let (Some(program), Some(layout)) = (&checked.program, &checked.layout) else { return Vec::new() };
    let allowed: Vec<_> = program.allow.stated.iter().filter(|a| a.rule == Allow::Collide).collect();
    if allowed.is_empty() {
        return Vec::new();
    }
    let options = Options { tolerances: checked.report.tolerances, eta: checked.report.eta, ..Options::default() };
    let world: World<f64> = World::new(program, layout, &options);
    let near = pairs_up_to(&world, 0.0, GAPS);
    let mut deep: Vec<((ObjectId, ObjectId), f64)> = Vec::new();
    for (a, b) in near.pairs {
        let Ok(truth) = collide::pair(&world, a, b) else { continue };
        let depth = options.tolerances.contact - truth.margin;
        if depth > options.tolerances.contact {
            deep.push(((a, b), depth));
        }
    }
    let name = |id: ObjectId| program.objects[id.0 as usize].name.to_string();
    let hidden_by = |allowance: &Allowance| {
        let [one, other] = match &allowance.arguments[..] {
            [all] => [all, all],
            [one, other, ..] => [one, other],
            [] => return None,
        };
        let lifts = |(a, b): &(ObjectId, ObjectId)| {
            one.contains(a) && other.contains(b) || one.contains(b) && other.contains(a)
        };
        let hidden: Vec<_> = deep.iter().filter(|(pair, _)| lifts(pair)).collect();
        let ((a, b), depth) = hidden.iter().copied().max_by(|(p, a), (q, b)| a.total_cmp(b).then(q.cmp(p)))?;
        Some(Overlap { objects: [name(*a), name(*b)], depth: *depth, others: hidden.len() - 1 })
    };
    let permission = |allowance: &&Allowance| {
        let text = scenelang_base::plain::line(&allowance.text).to_string();
        Permission { text, hides: hidden_by(allowance), complete: near.complete }
    };
    allowed.iter().map(permission).collect()
}

/// The lines of a report on permissions; empty where there are none.
pub fn listed(permissions: &[Permission]) -> String {
    if permissions.is_empty() {
        return String::new();
    }
    let mut out = String::from("Permissions to collide:\n");
    for Permission { text, hides, complete } in permissions.iter().take(MOST) {
        let says = match hides {
            None if *complete => "hides nothing".to_owned(),
            None => "there are too many objects in one place to determine what it hides".to_owned(),
            Some(Overlap { objects: [a, b], depth, others }) => {
                let more = match others {
                    0 => String::new(),
                    1 => ", and 1 pair that is not as deep".to_owned(),
                    n => format!(", and {n} pairs that are not as deep"),
                };
                format!("hides an overlap of {a} and {b} by {depth:.3} m{more}")
            }
        };
        let _ = writeln!(out, "  {text}: {says}");
    }
    if permissions.len() > MOST {
        let _ = writeln!(out, "  … and {} more", permissions.len() - MOST);
    }
    out
}
