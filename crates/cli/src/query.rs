//! `scenelang query`: what is known of an object, or of all of them.

use crate::args::{Beside, Query as Args, SummaryFormat};
use crate::check::judge;
use crate::room::layout_of;
use crate::solve::color_err;
use crate::table::Table;
use crate::targets::{JudgeTarget, find};
use crate::{FAILED, GOOD, out};
use scenelang_base::door::{Door, Named};
use scenelang_base::{Diagnostic, codes, plain};
use scenelang_verify::query::{Object, On, Opens, Pose, Query, QueryRow, RestsOn, query};
use scenelang_verify::report::model::RowKind;
use scenelang_verify::{Checked, Detail, Explain, exit_code, report};

/// Answers; 0 if it is known, 2 if the scene cannot be judged or has no such object.
pub fn run(args: &Args) -> u8 {
    let target = match target(args) {
        Ok(target) => target,
        Err(message) => return fail(&message),
    };
    let named = Named::new([args.scene.as_path()]);
    let door = Door::of(target.path()).named(&named);
    let detail = Detail { all: true, explain: Explain::First(0), ..Detail::default() };
    let checked = judge(&target, &args.judging, &Beside::default(), detail, false, &door, &door);
    eprint!("{}", said(&checked));
    let found = match query(&checked, args.object.as_deref()) {
        Ok(Some(found)) => found,
        Ok(None) => return FAILED,
        Err(message) => return fail(&message),
    };
    match args.format {
        SummaryFormat::Human => out::show(&human(&found, args.object.is_some())),
        SummaryFormat::Json => match serde_json::to_string(&found) {
            Ok(text) => println!("{text}"),
            Err(e) => return fail(&e.to_string()),
        },
    }
    if exit_code(&checked.report) == FAILED { FAILED } else { GOOD }
}

/// The layout beside a program, else what was named.
fn target(args: &Args) -> Result<JudgeTarget, String> {
    let beside = layout_of(&args.scene);
    let path = if beside.is_file() { beside } else { args.scene.clone() };
    match find(std::slice::from_ref(&path)).as_slice() {
        [one @ (JudgeTarget::File(_) | JudgeTarget::Carrier(..))] if one.path() == path => Ok(one.clone()),
        _ => Err(format!(
            "{} is a folder; query takes a program, a layout, a GLB or USD file or the folder of a Unity project",
            path.display()
        )),
    }
}

fn fail(message: &str) -> u8 {
    eprintln!("error: {message}");
    FAILED
}

/// Why something cannot be judged, and what was changed in a scene since it was exported.
fn said(checked: &Checked) -> String {
    let is_said = |d: &&Diagnostic| d.is_error() || d.code == codes::W0504;
    let found: Vec<Diagnostic> = checked.verdict.diagnostics.iter().filter(is_said).cloned().collect();
    report::diagnostics(&found, &checked.sources, color_err())
}

fn human(found: &Query, in_full: bool) -> String {
    let mut out = if in_full {
        found.objects.iter().map(|object| block(object, found.judged)).collect::<Vec<_>>().join("\n")
    } else {
        table(found)
    };
    if !found.judged {
        out += &format!("{} has no layout beside it, so nothing was checked\n", found.file);
    }
    if let Some(with) = &found.judged_with {
        out += &format!("{}\n", with.in_words());
    }
    out
}

fn table(found: &Query) -> String {
    let mut table = Table::new(&["object", "category", "at", "turned", "holds", "fails", "unmet", "not checked"]);
    for object in &found.objects {
        let counts = object.constraints;
        let [at, turned] = match &object.pose {
            Some(Pose { pos, rot, .. }) => [triple(pos), rotation(rot)],
            None => ["–".to_owned(), "–".to_owned()],
        };
        let [holds, fails, unmet, unjudged] =
            [counts.holds, counts.fails, counts.unmet, counts.unjudged].map(|n| n.to_string());
        table.row([
            object.name.clone(),
            plain::line(&object.category).into_owned(),
            at,
            turned,
            holds,
            fails,
            unmet,
            unjudged,
        ]);
    }
    table.render()
}

/// All that is known of an object, a line for each thing.
fn block(object: &Object, judged: bool) -> String {
    let mut out = object.name.clone();
    if !object.category.is_empty() {
        out += &format!(", category \"{}\"", plain::line(&object.category));
    }
    let at = &object.declared;
    out += &format!("\n  declared at {}:{}:{}: {}\n", at.span.file, at.span.start[0], at.span.start[1], at.text);
    for requirement in &object.requirements {
        out += &format!("  required by \"{requirement}\"\n");
    }
    if let Some(Pose { pos, rot, size }) = &object.pose {
        out += &format!(
            "  position ({}), rotation {}, size {} m\n",
            triple(pos),
            rotation(rot),
            size.map(metres).join(" × ")
        );
    } else if judged {
        out += "  is not in the layout\n";
    }
    let Some(details) = &object.details else { return out };
    if let Some(rests_on) = &details.rests_on {
        out += &format!("  {}\n", resting(rests_on));
    }
    details.joints.iter().for_each(|joint| out += &format!("  {}\n", opening(joint)));
    details.constraints.iter().for_each(|row| out += &line(row, judged));
    out
}

fn resting(RestsOn { on, name, gap }: &RestsOn) -> String {
    let name = name.as_ref().map(|name| format!("`{name}`"));
    let of = |what: &str| name.as_ref().map_or_else(|| format!("the {what}"), |name| format!("the {what} of {name}"));
    let object = || name.clone().unwrap_or_default();
    match on {
        On::Floor => format!("rests on {}", of("floor")),
        On::Object => format!("rests on {}", object()),
        On::Wall => format!("is held by {}", of("wall")),
        On::Ceiling => format!("is held by {}", of("ceiling")),
        On::Inside => format!("is in {}", object()),
        On::Nothing => {
            let far = gap.unwrap_or_default();
            let below = name.unwrap_or_else(|| "the floor".to_owned());
            let way = if far < 0.0 { "below the top of" } else { "above" };
            format!("rests on nothing: it is {} m {way} {below}", metres(far.abs()))
        }
    }
}

fn opening(joint: &Opens) -> String {
    let Opens { name, motion, limits: [from, to], useful } = joint;
    let amount = |value: f64| if motion == "hinge" { format!("{value:.0}°") } else { format!("{} m", metres(value)) };
    let verb = if motion == "hinge" { "turns" } else { "slides" };
    let useful = useful.map_or_else(String::new, |useful| format!("; must open to at least {}", amount(useful)));
    format!("opens: `{name}` {verb} from {} to {}{useful}", amount(*from), amount(*to))
}

/// A constraint: verdict, place, text and margin; what was measured where it fails; what it was stated for.
fn line(row: &QueryRow, judged: bool) -> String {
    let verdict = match (row.satisfied, row.kind) {
        (Some(true), _) => "holds",
        (Some(false), RowKind::Prefer) => "is not met",
        (Some(false), _) => "FAILS",
        (None, _) if judged => "cannot be checked",
        (None, _) => "is stated",
    };
    let text = row.text.split_whitespace().collect::<Vec<_>>().join(" ");
    let margin = match (row.margin, row.unit.as_deref()) {
        (Some(margin), Some("deg")) => format!("  [{margin:+.1}°]"),
        (Some(margin), _) => format!("  [{margin:+.3} m]"),
        (None, _) => String::new(),
    };
    let mut out = format!("  {verdict}  {}  {text}{margin}\n", row.id);
    if row.satisfied == Some(false) && !row.message.is_empty() {
        out += &format!("    {}\n", row.message);
    }
    row.requirements.iter().for_each(|text| out += &format!("    for \"{text}\"\n"));
    out
}

/// Without a minus before nothing.
fn metres(value: f64) -> String {
    let text = format!("{value:.3}");
    if text == "-0.000" { "0.000".to_owned() } else { text }
}

fn triple(values: &[f64; 3]) -> String {
    values.map(metres).join(", ")
}

/// Furniture stands upright, so that one angle says it.
fn rotation([x, y, z]: &[f64; 3]) -> String {
    let degrees = |value: f64| {
        let text = format!("{value:.1}");
        if text == "-0.0" { "0.0°".to_owned() } else { format!("{text}°") }
    };
    if *x == 0.0 && *z == 0.0 { degrees(*y) } else { [*x, *y, *z].map(degrees).join(", ") }
}
