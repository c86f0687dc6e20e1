//! The tables of the report: constraints by kind, findings about the files, objects.

use super::html::escaped;
use crate::Scene;
use serde_json::Value;
use std::fmt::Write;

/// Each kind of row, and the heading above it.
const KINDS: [(&str, &[&str]); 4] = [
    ("Requirements", &["assert"]),
    ("Preferences", &["prefer"]),
    ("Assignments", &["pin"]),
    ("Physical rules", &["collision", "bounds", "support", "open"]),
];

/// All rows of the report, each once, with verdict and margin.
pub(super) fn constraints(out: &mut String, scene: &Scene) {
    let rows = list(&scene.report["constraints"]);
    for (heading, kinds) in KINDS {
        let of_kind = |row: &&Value| row["kind"].as_str().is_some_and(|kind| kinds.contains(&kind));
        table(out, heading, &rows.iter().filter(of_kind).collect::<Vec<_>>());
    }
    // Of a kind that this page does not know.
    let known =
        |row: &Value| KINDS.iter().any(|(_, kinds)| row["kind"].as_str().is_some_and(|kind| kinds.contains(&kind)));
    table(out, "Others", &rows.iter().filter(|row| !known(row)).collect::<Vec<_>>());
    let unlisted = &scene.report["unlisted"];
    let count = |key: &str| unlisted[key].as_u64().unwrap_or(0);
    if count("failing") + count("holding") > 0 {
        let _ = writeln!(
            out,
            "<p>Not listed: physical rules for {} pairs or objects that fail, and for {} that hold.</p>",
            count("failing"),
            count("holding")
        );
    }
}

fn table(out: &mut String, heading: &str, rows: &[&Value]) {
    if rows.is_empty() {
        return;
    }
    let _ = writeln!(
        out,
        "<h2>{heading}</h2>\n<table>\n<thead><tr><th scope=\"col\">Verdict</th><th scope=\"col\">Margin</th>\
         <th scope=\"col\">Statement</th><th scope=\"col\">Measured</th></tr></thead>\n<tbody>"
    );
    for row in rows {
        let (class, verdict) = match row["satisfied"].as_bool() {
            Some(true) => ("holds", "holds"),
            Some(false) => ("fails", "fails"),
            None => ("open", "not checked"),
        };
        let text = |key: &str| escaped(row[key].as_str().unwrap_or_default());
        let mut said = String::new();
        for sentence in list(&row["requirements"]) {
            let _ = write!(said, "<q>{}</q><br/>", escaped(sentence.as_str().unwrap_or_default()));
        }
        let _ = writeln!(
            out,
            "<tr class=\"{class}\"><td class=\"short\">{verdict}</td><td class=\"short\">{}</td>\
             <td title=\"{}\">{said}<code>{}</code></td><td>{}</td></tr>",
            margin(row),
            text("id"),
            text("text"),
            text("message"),
        );
    }
    out.push_str("</tbody>\n</table>\n");
}

/// The margin of a row with its unit; a dash where there is none.
fn margin(row: &Value) -> String {
    let Some(margin) = row["margin"].as_f64() else { return "–".to_owned() };
    let unit = match row["unit"].as_str() {
        Some("deg") => "°".to_owned(),
        Some(unit) => format!(" {}", escaped(unit)),
        None => String::new(),
    };
    // Adding 0 turns -0 into 0.
    let rounded = (margin * 1e4).round() / 1e4 + 0.0;
    format!("{rounded}{unit}")
}

/// What was found in the files.
pub(super) fn findings(out: &mut String, scene: &Scene) {
    let findings = list(&scene.report["diagnostics"]);
    if findings.is_empty() {
        return;
    }
    out.push_str("<h2>Findings</h2>\n<ul>\n");
    for finding in findings {
        let text = |key: &str| escaped(finding[key].as_str().unwrap_or_default());
        let code = finding["code"].as_str().map(|code| format!(" {}", escaped(code))).unwrap_or_default();
        let _ = writeln!(out, "<li>{}{code}: {}</li>", text("severity"), text("message"));
    }
    out.push_str("</ul>\n");
}

/// What the objects are.
pub(super) fn objects(out: &mut String, scene: &Scene) {
    if scene.objects.is_empty() {
        return;
    }
    out.push_str(
        "<h2>Objects</h2>\n<table>\n<thead><tr><th scope=\"col\">Object</th><th scope=\"col\">Category</th>\
         <th scope=\"col\">Family</th><th scope=\"col\">Width × height × depth (m)</th><th scope=\"col\">Mass (kg)</th>\
         <th scope=\"col\">Asked for as</th></tr></thead>\n<tbody>\n",
    );
    for object in &scene.objects {
        let [width, height, depth]: [f64; 3] = object.place.scale.into();
        let class = if object.violated { "fails" } else { "holds" };
        let asked: Vec<String> = object.requirements.iter().map(|said| escaped(said)).collect();
        let _ = writeln!(
            out,
            "<tr class=\"{class}\"><td><code>{}</code></td><td>{}</td><td>{}</td>\
             <td>{width:.2} × {height:.2} × {depth:.2}</td><td>{:.1}</td><td>{}</td></tr>",
            escaped(&object.name),
            escaped(&object.category),
            escaped(&object.family.replace('_', " ")),
            object.mass,
            asked.join("<br/>"),
        );
    }
    let all: f64 = scene.objects.iter().map(|object| object.mass).sum();
    let _ = writeln!(
        out,
        "</tbody>\n<tfoot><tr><td colspan=\"4\">{} objects</td><td>{all:.1}</td><td></td></tr></tfoot>\n</table>",
        scene.objects.len()
    );
}

fn list(value: &Value) -> &[Value] {
    value.as_array().map_or(&[], Vec::as_slice)
}
