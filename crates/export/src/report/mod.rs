//! The report as one page that needs nothing else: what was asked for, what holds and by how much, plan and picture, and what
//! the objects are. No script, and nothing is loaded from elsewhere.
//!
//! The page is well-formed as XML too, so that any tool can read it. When it was made and how long that took is not in it: the
//! same scene gives the same bytes.

mod html;
mod tables;

use crate::picture::{self, Picture};
use crate::{ExportError, Exporter, OutFile, Scene, plan};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use html::{clean, escaped};
use serde_json::Value;
use std::fmt::Write;

/// `report.html`.
#[derive(Clone, Copy, Debug)]
pub struct Report;

const STYLE: &str = include_str!("../../web/report.css");
/// Width and height of the picture, pixels.
const PICTURE: [usize; 2] = [960, 600];

impl Exporter for Report {
    fn name(&self) -> &'static str {
        "report"
    }
    fn files(&self, scene: &Scene) -> Result<Vec<OutFile>, ExportError> {
        let png = picture::png(scene, Picture { size: PICTURE, ..Picture::default() })?;
        Ok(vec![OutFile::new("report.html", page(scene, &png))])
    }
}

/// The page, with the picture as PNG.
fn page(scene: &Scene, png: &[u8]) -> String {
    let title = escaped(&scene.name);
    let mut out = format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n<title>{title}</title>\n\
         <style>{STYLE}</style>\n</head>\n<body>\n<main>\n<h1>{title}</h1>\n"
    );
    verdict(&mut out, scene);
    request(&mut out, scene);
    let [width, height] = PICTURE;
    let _ = write!(
        out,
        "<h2>Picture</h2>\n<img class=\"sheet\" width=\"{width}\" height=\"{height}\" alt=\"The scene in perspective\" \
         src=\"data:image/png;base64,{}\"/>\n<h2>Plan</h2>\n<div class=\"sheet\">{}</div>\n",
        STANDARD.encode(png),
        clean(&plan::svg(scene)),
    );
    tables::constraints(&mut out, scene);
    tables::findings(&mut out, scene);
    tables::objects(&mut out, scene);
    made(&mut out, scene);
    out.push_str("</main>\n</body>\n</html>\n");
    out
}

/// Whether all holds, how many constraints of each kind do, and how well the room keeps to the guidelines.
fn verdict(out: &mut String, scene: &Scene) {
    let report = &scene.report;
    let (class, said) = match report["ok"].as_bool() {
        Some(true) => ("holds", "All hard constraints hold."),
        _ => ("fails", "Not all hard constraints hold."),
    };
    let _ = writeln!(out, "<p class=\"{class}\">{said}</p>");
    let kinds = [
        ("assertions", "assertions"),
        ("pins", "assignments"),
        ("preferences", "preferences"),
        ("physical", "physical rules"),
    ];
    let counted = |counts: &Value| Some((counts["satisfied"].as_u64()?, counts["total"].as_u64().filter(|n| *n > 0)?));
    let of = |(key, name): (&str, &str)| {
        let (satisfied, total) = counted(&report["summary"][key])?;
        Some(format!("{satisfied} of {total} {name} hold"))
    };
    let parts: Vec<String> = kinds.into_iter().filter_map(of).collect();
    if !parts.is_empty() {
        let _ = writeln!(out, "<p>{}.</p>", parts.join(", "));
    }
    let design = &report["design"];
    if let (Some(figure), Some((satisfied, total))) = (design["figure"].as_f64(), counted(&design["guidelines"])) {
        // Only a room that keeps to all of them has 1.00.
        let shown = if satisfied < total { figure.min(0.99) } else { figure };
        let _ = writeln!(out, "<p>Design: <b>{shown:.2}</b> ({satisfied} of {total} guidelines hold).</p>");
    }
}

/// What was asked for: the quoted lines of the comment at the beginning of the program, else the comment.
fn request(out: &mut String, scene: &Scene) {
    let lines = scene.main_text().lines().map(str::trim);
    let lines: Vec<&str> = lines.map_while(|line| line.strip_prefix("//")).map(str::trim).collect();
    let quoted: Vec<&str> = lines.iter().filter_map(|line| line.strip_prefix('>')).map(str::trim).collect();
    let own = |line: &&str| !line.is_empty() && !line.starts_with("Written by scenelang");
    let (heading, said) =
        if quoted.is_empty() { ("About", lines.into_iter().filter(own).collect()) } else { ("Request", quoted) };
    if !said.is_empty() {
        let _ = writeln!(out, "<h2>{heading}</h2>\n<blockquote>{}</blockquote>", escaped(&said.join("\n")));
    }
}

/// What it was made with.
fn made(out: &mut String, scene: &Scene) {
    let report = &scene.report;
    let layout: Value = serde_json::from_str(&scene.layout_text).unwrap_or_default();
    let mut rows = vec![("scenelang", env!("CARGO_PKG_VERSION").to_owned())];
    let text = |value: &Value| match value {
        Value::Null => None,
        Value::String(text) => Some(text.clone()),
        other => Some(other.to_string()),
    };
    let tolerances = report["tolerances"]
        .as_object()
        .map(|all| all.iter().map(|(name, value)| format!("{name} {value}")).collect::<Vec<_>>().join(", "));
    let said = [
        ("seed", text(&layout["seed"])),
        ("format of the layout", text(&layout["format"])),
        ("format of the report", text(&report["format"])),
        ("thickness of walls (m)", text(&report["eta"])),
        ("tolerances (m, degrees)", tolerances),
        ("settings", text(&report["judged_with"]["file"])),
    ];
    rows.extend(said.into_iter().filter_map(|(name, value)| Some((name, value?))));
    out.push_str("<h2>Versions</h2>\n<table>\n<tbody>\n");
    for (name, value) in rows {
        let _ = writeln!(out, "<tr><th scope=\"row\">{name}</th><td>{}</td></tr>", escaped(&value));
    }
    out.push_str("</tbody>\n</table>\n");
}
