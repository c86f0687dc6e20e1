//! The report of a suite: Markdown with plots beside it, or one page of HTML with the plots in it.

use super::figures::{PAPER, PUBLISHED_CORRECTNESS, PUBLISHED_RESEMBLANCE};
use super::plot::{Plot, Series};
use super::{Case, Figures};
use crate::dataset::PUBLISHED;
use crate::resemblance::TAUS;
use std::fmt::Write;

/// A plot: its file, what it shows, its text.
pub struct Picture {
    /// The name of its file.
    pub file: &'static str,
    /// What it shows, in words.
    pub shows: &'static str,
    /// The text.
    pub svg: String,
}

/// What a report consists of.
pub struct Page {
    /// The text in Markdown; pictures are named as `PICTURE:file`.
    markdown: String,
    /// The plots.
    pub pictures: Vec<Picture>,
}

/// What is written in the text where a picture belongs.
const PICTURE: &str = "PICTURE:";

/// The report of a suite.
pub fn page(figures: &Figures, cases: &[Case]) -> Page {
    let mut out = String::new();
    let [scenes, rooms, objects, relations, words] = figures.size;
    let _ = write!(
        out,
        "# Evaluation\n\n\
         Suite *{}*: {scenes} scenes of the dataset that `scenelang eval dataset` makes, read by the English reader without a \
         model and laid out without one. The numbers beside ours are quoted from the paper of the published system \
         ({PAPER}); neither its code nor its dataset is public, so nothing of it was run here. What is comparable is said \
         under each table.\n\n## Dataset\n\n",
        figures.suite
    );
    dataset(&mut out, [scenes, rooms, objects, relations, words]);
    correctness(&mut out, figures);
    resemblance(&mut out, figures);
    time(&mut out, cases);
    let pictures = vec![
        Picture {
            file: "evaluation-iterations.svg",
            shows: "the share of relations that hold after each iteration",
            svg: iterations(figures),
        },
        Picture { file: "evaluation-tau.svg", shows: "F1 over the threshold of similarity", svg: over_tau(figures) },
        Picture { file: "evaluation-time.svg", shows: "seconds over the number of objects", svg: over_size(cases) },
    ];
    Page { markdown: out, pictures }
}

fn dataset(out: &mut String, [scenes, rooms, objects, relations, words]: [usize; 5]) {
    let mean = |x: usize| x as f64 / scenes.max(1) as f64;
    let own = [1.0, mean(rooms), mean(objects), mean(relations), mean(words)];
    out.push_str("| for each scene | published | ours |\n|---|---|---|\n");
    for ((name, published), own) in PUBLISHED.iter().zip(own).skip(1) {
        let published = if *name == "words of a request" { *published } else { published / PUBLISHED[0].1 };
        let _ = writeln!(out, "| {name} | {published:.1} | {own:.1} |");
    }
    out.push_str(
        "\nThe five kinds of buildings, the sizes of the pools, one or two rooms, 5 to 15 attributes, at most five of a kind and \
         the chance of fewer are as published. The words are a grammar's (`crates/eval/data`) and not a language model's, so \
         they are less varied than the published requests; no two of them share a skeleton. Each instance of a relation \
         counts: five chairs at a table are five relations.\n\n",
    );
}

fn correctness(out: &mut String, figures: &Figures) {
    out.push_str("## Solution correctness\n\nThe share of the relations that hold, in percent.\n\n");
    out.push_str("| system | 0 | 1 | 2 | 3 | 4 | 5 | to the end |\n|---|---|---|---|---|---|---|---|\n");
    let cells = |values: &[f64]| values.iter().map(|x| format!(" {x:.1} |")).collect::<String>();
    let _ = writeln!(out, "| ours, no model |{}", cells(&figures.search));
    let [held, placed] = figures.grid;
    let _ = writeln!(out, "| Holodeck's floor solver, rebuilt | | | | | | | {held:.1} |");
    if let Some([held, _]) = figures.direct {
        let _ = writeln!(out, "| direct prompting | | | | | | | {held:.1} |");
    }
    for (name, values) in PUBLISHED_CORRECTNESS {
        let _ = writeln!(out, "| published: {name} |{} |", cells(&values));
    }
    let _ = write!(
        out,
        "\nEverything that must hold (relations, other statements, physical rules) does so in {} of {} scenes at the end.\n\n\
         PICTURE:evaluation-iterations.svg\n\n\
         - **Comparable:** what is counted, and ours with the rebuilt floor solver: the same programs, the same judge.\n\
         - **Not comparable:** the published shares are of constraints that a language model wrote for other requests; some of \
         those sets may have no solution. An iteration of theirs asks a model about three violated constraints; one of ours is \
         {} units of work for each object, about as much as one look at each of them.\n\
         - **Holodeck's floor solver** is rebuilt from its description with its published parameters (a grid of a twentieth of \
         the room, quarter turns, thirty first placements and then the best one each time, its weights; its limit of 30 s is \
         20 million placements judged). It has no words for some relations, and leaves out objects that it finds no place for: it has placed \
         {placed:.1} % of the objects here. Objects that are not on the floor are placed for it. The original was also run, on other \
         problems: see [benchmarks](benchmarks.md).\n\
         - **Direct prompting** needs a model: `scenelang eval run --model …` adds its row.\n\n",
        figures.scenes,
        figures.size[0],
        crate::correctness::WORK
    );
}

fn resemblance(out: &mut String, figures: &Figures) {
    out.push_str("## Constraint resemblance\n\nPrecision, recall and F1 in percent, at three thresholds τ.\n\n");
    out.push_str(
        "| τ | system | objects | | | layout | | | overall | | |\n|---|---|---|---|---|---|---|---|---|---|---|\n",
    );
    let cells = |values: &[f64; 9]| values.iter().map(|x| format!(" {x:.1} |")).collect::<String>();
    for (t, tau) in TAUS.iter().enumerate() {
        let _ = writeln!(out, "| {tau} | ours, no model ({}) |{}", figures.similarity, cells(&figures.resemblance[t]));
        for (name, values) in PUBLISHED_RESEMBLANCE {
            let _ = writeln!(out, "| {tau} | published: {name} |{}", cells(&values[t]));
        }
    }
    out.push_str(
        "\nPICTURE:evaluation-tau.svg\n\n\
         - **Comparable:** the definitions: confidence, pairing, thresholds, harmonic means.\n\
         - **Not comparable:** similarity. The published one is computed from embeddings (Phrase-BERT for names, Sentence-BERT for \
         descriptions and sentences), scaled so that what has nothing in common is at about 0.5. Ours is lexical: the trigrams \
         that two texts share. At the same τ it is stricter, and for constraints it compares the wording of a request with a \
         sentence that is made of a predicate. `--embeddings FILE` takes vectors of any model instead.\n\
         - A sentence in which the reader finds two constraints becomes two, one of which the request may not have in its own \
         words; that costs precision.\n\n",
    );
}

fn time(out: &mut String, cases: &[Case]) {
    let (mut read, mut solve): (Vec<f64>, Vec<f64>) =
        (cases.iter().map(|c| c.milliseconds[0]).collect(), cases.iter().map(|c| c.milliseconds[1]).collect());
    read.sort_by(f64::total_cmp);
    solve.sort_by(f64::total_cmp);
    let middle = |of: &[f64]| of.get(of.len() / 2).copied().unwrap_or(0.0) / 1000.0;
    let last = |of: &[f64]| of.last().copied().unwrap_or(0.0) / 1000.0;
    let _ = write!(
        out,
        "## Time\n\nOn the machine that this page was made on, which may have done other things: reading a request took \
         {:.2} s in the median and {:.2} s at most, laying out a scene to the end {:.2} s and {:.2} s. No test asserts that.\n\n\
         PICTURE:evaluation-time.svg\n\n\
         ## Not measured\n\nThe scores of pictures (BLIP-2, CLIP, questions to a vision model) and the study with people need \
         models and people; nothing here takes their place.\n",
        middle(&read),
        last(&read),
        middle(&solve),
        last(&solve)
    );
}

fn iterations(figures: &Figures) -> String {
    let line = |name: String, values: &[f64]| Series {
        name,
        points: values.iter().take(6).enumerate().map(|(i, y)| [i as f64, *y]).collect(),
        joined: true,
    };
    let mut series = vec![line("ours".to_owned(), &figures.search)];
    series.extend(PUBLISHED_CORRECTNESS.iter().map(|(name, values)| line(format!("published: {name}"), values)));
    series.push(line("Holodeck's, rebuilt".to_owned(), &[figures.grid[0]; 6]));
    Plot {
        title: "Relations that hold",
        axes: ["iteration", "percent"],
        ranges: [[0.0, 5.0], [0.0, 100.0]],
        steps: [5, 5],
        series,
    }
    .svg()
}

fn over_tau(figures: &Figures) -> String {
    let line = |name: String, rows: &[[f64; 9]; 3]| Series {
        name,
        points: TAUS.iter().zip(rows).map(|(tau, row)| [*tau, row[8]]).collect(),
        joined: true,
    };
    let mut series = vec![line(format!("ours ({})", figures.similarity), &figures.resemblance)];
    series.extend(PUBLISHED_RESEMBLANCE.iter().map(|(name, rows)| line(format!("published: {name}"), rows)));
    Plot {
        title: "Overall F1",
        axes: ["τ", "percent"],
        ranges: [[TAUS[0], TAUS[2]], [0.0, 100.0]],
        steps: [2, 5],
        series,
    }
    .svg()
}

fn over_size(cases: &[Case]) -> String {
    let points = |i: usize| cases.iter().map(|c| [c.size[1] as f64, c.milliseconds[i] / 1000.0]).collect::<Vec<_>>();
    let series = vec![
        Series { name: "reading".to_owned(), points: points(0), joined: false },
        Series { name: "laying out".to_owned(), points: points(1), joined: false },
    ];
    let most = |i: usize| series.iter().flat_map(|s| &s.points).map(|p| p[i]).fold(0.0, f64::max);
    let up = |x: f64, step: f64| (x / step).ceil().max(1.0) * step;
    let ranges = [[0.0, up(most(0), 20.0)], [0.0, up(most(1), 0.5)]];
    Plot { title: "Time", axes: ["objects", "seconds"], ranges, steps: [4, 5], series }.svg()
}

impl Page {
    /// The text, with pictures in a folder beside it.
    pub fn markdown(&self, folder: &str) -> String {
        let mut out = self.markdown.clone();
        for picture in &self.pictures {
            let shown = format!("![{}]({folder}/{})", picture.shows, picture.file);
            out = out.replace(&format!("{PICTURE}{}", picture.file), &shown);
        }
        out
    }

    /// One page of HTML. It reads the few forms of Markdown that the text has.
    pub fn html(&self) -> String {
        let mut body = String::new();
        for block in self.markdown.split("\n\n").map(str::trim).filter(|block| !block.is_empty()) {
            if let Some(file) = block.strip_prefix(PICTURE) {
                let picture = self.pictures.iter().find(|picture| picture.file == file);
                let _ = writeln!(body, "<figure>{}</figure>", picture.map_or("", |p| p.svg.as_str()));
            } else if let Some(title) = block.strip_prefix("## ") {
                let _ = writeln!(body, "<h2>{}</h2>", inline(title));
            } else if let Some(title) = block.strip_prefix("# ") {
                let _ = writeln!(body, "<h1>{}</h1>", inline(title));
            } else if block.starts_with('|') {
                table(&mut body, block);
            } else if block.starts_with("- ") {
                let items = block.lines().map(|line| line.strip_prefix("- ").unwrap_or(line));
                let items: String = items.map(|item| format!("<li>{}</li>\n", inline(item))).collect();
                let _ = writeln!(body, "<ul>\n{items}</ul>");
            } else {
                let _ = writeln!(body, "<p>{}</p>", inline(block));
            }
        }
        format!(
            "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>Evaluation</title>\n<style>\
             body{{font:16px/1.5 sans-serif;max-width:60rem;margin:2rem auto;padding:0 1rem}}\
             table{{border-collapse:collapse}}td,th{{border:1px solid #ccc;padding:.2rem .5rem}}\
             figure{{margin:1rem 0;max-width:42rem}}</style></head>\n<body>\n{body}</body></html>\n"
        )
    }
}

fn table(out: &mut String, block: &str) {
    let cells = |line: &str, tag: &str| {
        let inner = line.trim().trim_start_matches('|');
        let inner = inner.strip_suffix('|').unwrap_or(inner);
        inner.split('|').map(|cell| format!("<{tag}>{}</{tag}>", inline(cell.trim()))).collect::<String>()
    };
    let _ = writeln!(out, "<table>");
    for (i, line) in block.lines().enumerate().filter(|(i, _)| *i != 1) {
        let _ = writeln!(out, "<tr>{}</tr>", cells(line, if i == 0 { "th" } else { "td" }));
    }
    let _ = writeln!(out, "</table>");
}

/// Bold, emphasis, code and links; signs of HTML are text.
fn inline(text: &str) -> String {
    let text = text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
    let mut out = String::new();
    for (i, part) in text.split("**").enumerate() {
        out.push_str(if i == 0 {
            ""
        } else if i % 2 == 1 {
            "<b>"
        } else {
            "</b>"
        });
        for (j, part) in part.split('`').enumerate() {
            if j % 2 == 1 {
                let _ = write!(out, "<code>{part}</code>");
                continue;
            }
            for (k, part) in part.split('*').enumerate() {
                out.push_str(if k == 0 {
                    ""
                } else if k % 2 == 1 {
                    "<em>"
                } else {
                    "</em>"
                });
                out.push_str(&linked(part));
            }
        }
    }
    out
}

fn linked(text: &str) -> String {
    let Some((before, rest)) = text.split_once('[') else { return text.to_owned() };
    let Some((name, rest)) = rest.split_once("](") else { return text.to_owned() };
    let Some((to, after)) = rest.split_once(')') else { return text.to_owned() };
    format!("{before}<a href=\"{to}\">{name}</a>{}", linked(after))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn markdown_becomes_html() {
        assert_eq!(
            inline("a **b** *c* `d < e` [f](g.md)"),
            "a <b>b</b> <em>c</em> <code>d &lt; e</code> <a href=\"g.md\">f</a>"
        );
        let mut out = String::new();
        table(&mut out, "| a | b |\n|---|---|\n| 1 | |");
        assert_eq!(out, "<table>\n<tr><th>a</th><th>b</th></tr>\n<tr><td>1</td><td></td></tr>\n</table>\n");
    }

    #[test]
    fn a_report_names_its_pictures_and_quotes_the_paper() {
        let figures = Figures { search: vec![50.0; 7], similarity: "lexical".to_owned(), ..Figures::default() };
        let page = page(&figures, &[]);
        let (markdown, html) = (page.markdown("images"), page.html());
        assert!(!markdown.contains(PICTURE) && !html.contains(PICTURE));
        for picture in &page.pictures {
            assert!(markdown.contains(&format!("(images/{})", picture.file)));
        }
        assert_eq!(html.matches("<svg").count(), 3);
        assert!(
            markdown.contains("| published: DeepSeek R1 | 47.8 | 87.6 | 90.6 | 91.7 | 92.9 | 93.0 | |"),
            "{markdown}"
        );
        assert!(markdown.contains("| objects | 40.6 | 0.0 |") && markdown.contains("| words of a request | 508.4 |"));
    }
}
