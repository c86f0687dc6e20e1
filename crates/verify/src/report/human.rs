//! The report for people: each finding and each violation with the places it speaks of, then one line that sums up.

use super::compact::goes_with;
use super::exit_code;
use super::model::{Design, RowKind, Summary, Tally};
use super::words::Words;
use crate::check::{Checked, Judged, measure_in_words};
use ariadne::{Color, Config, IndexType, Label, Report, ReportKind, Source};
use scenelang_base::{Diagnostic, FileId, Severity, SourceMap, Span, plain};
use scenelang_lang::program::Unit;
use std::borrow::Cow;
use std::fmt::Write;
use std::path::Path;

/// So many violations are shown in full.
const MOST: usize = 50;
/// A line longer than this is not shown, only named.
const LONGEST_LINE: usize = 400;

/// How to write for people.
#[derive(Clone, Copy, Debug, Default)]
pub struct Human {
    /// With colours, for a terminal.
    pub color: bool,
    /// A line for each constraint that holds, too.
    pub all: bool,
}

/// The whole report: diagnostics, violations, preferences that are not met, summary.
pub fn human(checked: &Checked, Human { color, all }: Human) -> String {
    let Checked { sources, verdict, report, .. } = checked;
    let mut out = diagnostics(&verdict.diagnostics, sources, color);
    if all {
        holding(report, &mut out);
    }
    let failing: Vec<&Judged> = verdict.rows.iter().filter(|row| row.satisfied == Some(false)).collect();
    let layout = Path::new(&report.file).file_name().map_or(Cow::Borrowed("the layout"), |name| name.to_string_lossy());
    let mut cache = Files::new(sources);
    let words = Words::new(checked);
    let (advice, failing): (Vec<&Judged>, Vec<&Judged>) = failing.into_iter().partition(|row| row.guideline.is_some());
    for row in failing.iter().filter(|row| !words.is_said(row)).take(MOST) {
        violation(row, &layout, &words, &mut cache, color, &mut out);
    }
    if failing.len() > MOST {
        let (more, them) = (failing.len() - MOST + report.unlisted.failing, report.unlisted.failing > 0);
        let them = if them { format!("the first {}", failing.len()) } else { "them all".to_owned() };
        line(&mut out, format_args!("… and {more} more that fail; `--format json` lists {them}\n"));
    }
    guidelines(&advice, &mut out);
    line(&mut out, format_args!("{}: {}", plain::line(&report.file), summary(report)));
    judged_with(report, &mut out);
    out
}

/// The guidelines that do not hold: their text is that of the library, which need not be shown.
fn guidelines(rows: &[&Judged], out: &mut String) {
    if rows.is_empty() {
        return;
    }
    line(out, format_args!("Guidelines that do not hold:"));
    for row in rows.iter().take(MOST) {
        let margin = row.margin.map_or(String::new(), |(margin, unit)| {
            let metres = if unit == Unit::Metre { " m" } else { "" };
            format!(", margin {}{metres}", measure_in_words(margin, unit))
        });
        let weight = row.weight.unwrap_or(1.0);
        line(out, format_args!("  {} (weight {weight}{margin})", plain::line(&row.measured)));
    }
    if rows.len() > MOST {
        line(out, format_args!("  … and {} more; `--format json` lists them all", rows.len() - MOST));
    }
    line(out, format_args!(""));
}

/// The settings that make the verdict another than the usual one.
pub(super) fn judged_with(report: &super::Report, out: &mut String) {
    if let Some(with) = &report.judged_with {
        line(out, format_args!("{}", with.in_words()));
    }
}

/// A line for each row that does not fail.
pub(super) fn holding(report: &super::Report, out: &mut String) {
    if let Some(more) = report.unlisted.holding_in_words() {
        line(out, format_args!("{more}"));
    }
    for row in report.constraints.iter().filter(|row| row.satisfied != Some(false)) {
        let verdict = if row.satisfied.is_some() { "holds" } else { "cannot be checked" };
        let margin = match (row.margin, row.unit.as_deref()) {
            (Some(margin), Some(unit)) => format!(", margin {margin:.4} {unit}"),
            _ => String::new(),
        };
        line(out, format_args!("{}: {} {verdict}{margin}", plain::line(&row.id), plain::line(&row.text)));
    }
}

/// Diagnostics, each with the text it speaks of.
pub fn diagnostics(diagnostics: &[Diagnostic], sources: &SourceMap, color: bool) -> String {
    let mut out = String::new();
    let mut cache = Files::new(sources);
    for diagnostic in diagnostics {
        let hints = diagnostic.fixes.iter().map(|fix| fix.title.clone()).collect();
        let kind = match diagnostic.severity {
            Severity::Error => Look::Error,
            Severity::Warning => Look::Warning,
        };
        let finding = Finding {
            look: kind,
            code: diagnostic.code.as_str(),
            message: &diagnostic.message,
            primary: diagnostic.primary.as_ref().map(|l| (l.place, l.message.clone())),
            related: diagnostic.related.iter().map(|l| (l.place, l.message.clone())).collect(),
            notes: diagnostic.notes.clone(),
            hints,
        };
        finding.write(&mut cache, color, &mut out);
    }
    out
}

fn violation(row: &Judged, layout: &str, words: &Words<'_>, cache: &mut Files<'_>, color: bool, out: &mut String) {
    let fails = if row.kind == RowKind::Prefer { "not met" } else { "fails" };
    let label = match row.margin.filter(|(_, unit)| goes_with(*unit, &row.measured)) {
        Some((margin, unit)) => {
            let metres = if unit == Unit::Metre { " m" } else { "" };
            format!("{fails} in {layout}: margin {}{metres}", measure_in_words(margin, unit))
        }
        None => format!("{fails} in {layout}"),
    };
    let stated = row.kind.rule().is_none();
    let mut notes: Vec<String> = row.requirements.iter().map(|r| format!("required by \"{r}\"")).collect();
    if let Some(rule) = row.kind.rule() {
        notes.push(format!("this is the physical rule {rule}, which applies to every program"));
    }
    if words.says_rule(row) {
        notes.push("the physical rule P-COLLIDE also forbids this overlap".to_owned());
    }
    let mut hints = Vec::new();
    words.explain(row, &mut notes, &mut hints);
    // A measure of support begins with "it".
    let whose = row.text.strip_suffix(" is supported").filter(|_| row.kind == RowKind::Support);
    let supported = whose.map(|whose| format!("{whose} is not supported: {}", row.measured));
    let unmeasured = if stated { format!("`{}` does not hold", row.text) } else { row.text.clone() };
    let headline = if row.measured.is_empty() { &unmeasured } else { supported.as_ref().unwrap_or(&row.measured) };
    let mut related: Vec<(Span, String)> = row.related.iter().map(|l| (l.place, l.message.clone())).collect();
    let primary = if stated {
        (row.place, label)
    } else {
        // The rule has no text; its objects have.
        let own = related.iter().position(|(place, _)| *place == row.place);
        let at = own.map_or(String::new(), |i| related.remove(i).1);
        (row.place, at)
    };
    let finding = Finding {
        look: if row.kind == RowKind::Prefer { Look::Advice } else { Look::Error },
        code: row.code.as_str(),
        message: headline,
        primary: Some(primary),
        related,
        notes,
        hints,
    };
    finding.write(cache, color, out);
}

/// What holds of what there is, and what else was found.
pub(super) fn summary(report: &super::Report) -> String {
    let Summary { assertions, mut preferences, physical, pins } = report.summary;
    if let Some(design) = &report.design {
        preferences.total = preferences.total.saturating_sub(design.guidelines.total);
        preferences.satisfied = preferences.satisfied.saturating_sub(design.guidelines.satisfied);
    }
    let of =
        |tally: Tally, what: &str| (tally.total > 0).then(|| format!("{} of {} {what}", tally.satisfied, tally.total));
    let parts = [
        of(assertions, "assertions"),
        of(pins, "assignments"),
        of(preferences, "preferences"),
        of(physical, "physical rules"),
    ];
    let parts: Vec<String> = parts.into_iter().flatten().collect();
    let mut text = if parts.is_empty() { String::new() } else { format!("{} hold", parts.join(", ")) };
    if let Some(Design { figure, guidelines: Tally { total, satisfied } }) = report.design {
        let comma = if text.is_empty() { "" } else { ", " };
        // Only a room that keeps to all of them has 1.00.
        let shown = if satisfied < total { figure.min(0.99) } else { figure };
        text.push_str(&format!("{comma}design {shown:.2} ({satisfied} of {total} guidelines hold)"));
    }
    let unchecked = report.constraints.iter().filter(|row| row.satisfied.is_none()).count();
    if unchecked > 0 {
        text.push_str(&format!(", {unchecked} could not be checked"));
    }
    let errors = report.diagnostics.iter().filter(|d| d.severity == "error").count();
    let warnings = report.diagnostics.len() - errors;
    for (count, what) in [(errors, "error"), (warnings, "warning")] {
        if count > 0 {
            let comma = if text.is_empty() { "" } else { ", " };
            let plural = if count > 1 { "s" } else { "" };
            text.push_str(&format!("{comma}{count} {what}{plural}"));
        }
    }
    if text.is_empty() {
        text.push_str(if exit_code(report) == 0 { "no problems found" } else { "it fails" });
    }
    text
}

/// How a finding looks.
#[derive(Clone, Copy)]
enum Look {
    Error,
    Warning,
    Advice,
}

struct Finding<'a> {
    look: Look,
    code: &'a str,
    message: &'a str,
    primary: Option<(Span, String)>,
    related: Vec<(Span, String)>,
    notes: Vec<String>,
    hints: Vec<String>,
}

type Id = (FileId, std::ops::Range<usize>);

impl Finding<'_> {
    fn write(&self, files: &mut Files<'_>, color: bool, out: &mut String) {
        let (word, kind, paint) = match self.look {
            Look::Error => ("Error", ReportKind::Error, Color::Red),
            Look::Warning => ("Warning", ReportKind::Warning, Color::Yellow),
            Look::Advice => ("Advice", ReportKind::Advice, Color::Cyan),
        };
        let clean = |texts: &[String]| texts.iter().map(|text| plain::line(text).into_owned()).collect::<Vec<_>>();
        let headline = plain::line(self.message);
        let shown = self.primary.as_ref().filter(|(place, _)| files.can_show(*place));
        let Some((place, message)) = shown else {
            self.write_plainly(word, files, out);
            return;
        };
        let related = self.related.iter().filter(|(place, _)| files.can_show(*place));
        let mut labels: Vec<(&Span, &str, Color)> =
            related.map(|(place, message)| (place, message.as_str(), Color::Blue)).collect();
        // A place whose parts speak for themselves need not be pointed at, too.
        let parts =
            |(at, ..): &(&Span, &str, Color)| at.file == place.file && place.range.cover(at.range) == place.range;
        if !message.is_empty() || !labels.iter().any(parts) {
            labels.push((place, message, paint));
        }
        // In the order of the text, the file of the finding first: then each file is shown once.
        labels.sort_by_key(|(at, ..)| (at.file != place.file, at.file, at.range));
        let labels = labels.into_iter().map(|(at, message, color)| label(files.id(at), message, color));
        let mut report = Report::build(kind, files.id(place))
            .with_config(Config::default().with_index_type(IndexType::Byte).with_color(color))
            .with_code(self.code)
            .with_message(headline)
            .with_labels(labels);
        report.with_notes(clean(&self.notes));
        report.with_helps(clean(&self.hints));
        let mut bytes = Vec::new();
        match report.finish().write(&mut *files, &mut bytes) {
            Ok(()) => {
                // Blanks at the ends of lines are of no use to anyone.
                for text in String::from_utf8_lossy(&bytes).lines() {
                    line(out, format_args!("{}", text.trim_end()));
                }
            }
            Err(_) => self.write_plainly(word, files, out),
        }
    }

    /// Without the text: there is none, or its line is too long to be read.
    fn write_plainly(&self, word: &str, files: &Files<'_>, out: &mut String) {
        let place = self.primary.as_ref().map_or(String::new(), |(place, _)| {
            let start = files.sources.lines(*place).0;
            format!("{}:{}:{}: ", plain::line(files.sources.get(place.file).name()), start.line, start.column)
        });
        line(out, format_args!("[{}] {word}: {place}{}", self.code, plain::line(self.message)));
        for note in self.notes.iter().chain(&self.hints) {
            line(out, format_args!("  {}", plain::line(note)));
        }
    }
}

fn label(id: Id, message: &str, color: Color) -> Label<Id> {
    // Without a message it would not be underlined.
    Label::new(id).with_color(color).with_message(if message.is_empty() { "here".into() } else { plain::line(message) })
}

fn line(out: &mut String, text: std::fmt::Arguments<'_>) {
    let _infallible = writeln!(out, "{}", plain::no_command(&text.to_string()));
}

/// The source files as ariadne reads them.
struct Files<'a> {
    sources: &'a SourceMap,
    read: Vec<(FileId, Source<Cow<'a, str>>)>,
}

impl<'a> Files<'a> {
    fn new(sources: &'a SourceMap) -> Self {
        Self { sources, read: Vec::new() }
    }
    /// A place as ariadne takes it: whole characters, without the end of the line.
    fn id(&self, place: &Span) -> Id {
        let text = self.sources.get(place.file).text();
        let range = place.range.bytes();
        let boundary = |mut at: usize| {
            at = at.min(text.len());
            while !text.is_char_boundary(at) {
                at -= 1;
            }
            at
        };
        let start = boundary(range.start);
        let shown = text[start..boundary(range.end).max(start)].trim_end();
        (place.file, start..start + shown.len())
    }
    /// Whether the lines of a place are short enough to be shown.
    fn can_show(&self, place: Span) -> bool {
        let text = self.sources.get(place.file).text().as_bytes();
        let range = place.range.bytes();
        let is_break = |b: &u8| matches!(b, b'\n' | b'\r');
        let (Some(before), Some(after)) = (text.get(..range.start), text.get(range.start..)) else { return false };
        let first = before.iter().rev().take(LONGEST_LINE).take_while(|b| !is_break(b)).count()
            + after.iter().take(LONGEST_LINE).take_while(|b| !is_break(b)).count();
        first < LONGEST_LINE
    }
}

impl<'a> ariadne::Cache<FileId> for Files<'a> {
    type Storage = Cow<'a, str>;
    fn fetch(&mut self, id: &FileId) -> Result<&Source<Cow<'a, str>>, impl std::fmt::Debug> {
        let index = self.read.iter().position(|(file, _)| file == id).unwrap_or_else(|| {
            self.read.push((*id, Source::from(plain::excerpt(self.sources.get(*id).text()))));
            self.read.len() - 1
        });
        Ok::<_, std::convert::Infallible>(&self.read[index].1)
    }
    fn display<'b>(&self, id: &'b FileId) -> Option<impl std::fmt::Display + 'b> {
        Some(plain::line(self.sources.get(*id).name()).into_owned())
    }
}
