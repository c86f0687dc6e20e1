//! The grammar of the book as railroad pictures, one for each rule. `SPEC_UPDATE=1 cargo test` writes them anew.

use super::book;
use super::ebnf::{Piece, Rules, of_page};
use std::fmt::Write;
use std::fs;

/// Half the height of a word.
const HALF: i32 = 11;
/// Room between rows, and the radius of a bend.
const GAP: i32 = 10;

/// A piece laid out: it enters at its left and leaves at its right, at height 0.
struct Drawn {
    width: i32,
    /// How far it reaches above and below the line.
    above: i32,
    below: i32,
    svg: String,
}

impl Drawn {
    fn shifted(&self, x: i32, y: i32) -> String {
        if self.svg.is_empty() {
            String::new()
        } else {
            format!("<g transform=\"translate({x} {y})\">{}</g>", self.svg)
        }
    }
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

fn word(text: &str, class: &str) -> Drawn {
    let width = text.chars().count() as i32 * 8 + 20;
    let round = if class == "l" { HALF } else { 3 };
    let (top, height, middle) = (-HALF, 2 * HALF, width / 2);
    let text = escaped(text);
    let svg = format!(
        "<rect class=\"{class}\" y=\"{top}\" width=\"{width}\" height=\"{height}\" rx=\"{round}\"/><text x=\"{middle}\" y=\"4\">{text}</text>"
    );
    Drawn { width, above: HALF, below: HALF, svg }
}

fn line(from: i32, to: i32) -> String {
    if from == to { String::new() } else { format!("<path d=\"M{from} 0H{to}\"/>") }
}

fn sequence(all: &[Drawn]) -> Drawn {
    let mut out = Drawn { width: 0, above: 0, below: 0, svg: String::new() };
    for (i, piece) in all.iter().enumerate() {
        if i > 0 {
            out.svg += &line(out.width, out.width + GAP);
            out.width += GAP;
        }
        out.svg += &piece.shifted(out.width, 0);
        out.width += piece.width;
        out.above = out.above.max(piece.above);
        out.below = out.below.max(piece.below);
    }
    out
}

/// The first goes straight on, the others below it.
fn choice(all: &[Drawn]) -> Drawn {
    let widest = all.iter().map(|p| p.width).max().unwrap_or(0);
    let width = widest + 4 * GAP;
    let mut svg = String::new();
    let mut y = 0;
    for (i, piece) in all.iter().enumerate() {
        if i > 0 {
            y += all[i - 1].below + GAP + piece.above;
            let down = y - 2 * GAP;
            let _ = write!(
                svg,
                "<path d=\"M0 0Q{GAP} 0 {GAP} {GAP}v{down}Q{GAP} {y} {} {y}M{width} 0Q{} 0 {} {GAP}v{down}Q{} {y} {} {y}\"/>",
                2 * GAP,
                width - GAP,
                width - GAP,
                width - GAP,
                width - 2 * GAP
            );
        } else {
            svg += &line(0, 2 * GAP);
            svg += &line(width - 2 * GAP, width);
        }
        svg += &piece.shifted(2 * GAP, y);
        let end = 2 * GAP + piece.width;
        if end < width - 2 * GAP {
            let _ = write!(svg, "<path d=\"M{end} {y}H{}\"/>", width - 2 * GAP);
        }
    }
    let below = y + all.last().map_or(0, |p| p.below);
    Drawn { width, above: all.first().map_or(0, |p| p.above), below: below.max(all[0].below), svg }
}

/// Once and again, with `between` on the way back.
fn repeated(piece: &Drawn, between: Option<&Drawn>) -> Drawn {
    let inner = piece.width.max(between.map_or(0, |b| b.width));
    let width = inner + 4 * GAP;
    let back = piece.below + GAP + between.map_or(0, |b| b.above);
    let start = (width - piece.width) / 2;
    let mut svg = line(0, start) + &piece.shifted(start, 0) + &line(start + piece.width, width);
    let up = back - 2 * GAP;
    let _ = write!(
        svg,
        "<path d=\"M{} 0Q{width} 0 {width} {GAP}v{up}Q{width} {back} {} {back}M{GAP} {back}Q0 {back} 0 {}v-{up}Q0 0 {GAP} 0\"/>",
        width - GAP,
        width - GAP,
        back - GAP
    );
    match between {
        Some(b) => {
            let start = (width - b.width) / 2;
            let _ = write!(svg, "<path d=\"M{GAP} {back}H{start}M{} {back}H{}\"/>", start + b.width, width - GAP);
            svg += &b.shifted(start, back);
        }
        None => {
            let middle = width / 2;
            let _ = write!(
                svg,
                "<path d=\"M{GAP} {back}H{}\"/><path class=\"a\" d=\"M{} {back}l6 -4v8z\"/>",
                width - GAP,
                middle - 3
            );
        }
    }
    let below = back + between.map_or(4, |b| b.below);
    Drawn { width, above: piece.above, below, svg }
}

fn empty() -> Drawn {
    Drawn { width: 0, above: 4, below: 4, svg: String::new() }
}

fn draw(piece: &Piece) -> Drawn {
    match piece {
        Piece::Literal(text) => word(text, "l"),
        Piece::Class(class) => {
            let parts: Vec<String> = class.iter().map(|(a, b)| format!("{a}–{b}")).collect();
            word(&parts.join(" "), "c")
        }
        Piece::Rule(name) => word(name, "r"),
        Piece::Sequence(all) => sequence(&joined(all)),
        Piece::Choice(all) => choice(&all.iter().map(draw).collect::<Vec<_>>()),
        Piece::Optional(p) => choice(&[empty(), draw(p)]),
        Piece::Any(p) => choice(&[empty(), repeated(&draw(p), None)]),
        Piece::Some(p) => repeated(&draw(p), None),
    }
}

/// The pieces of a sequence; `x (sep x)*` is one loop.
fn joined(all: &[Piece]) -> Vec<Drawn> {
    let mut out = Vec::new();
    let mut at = 0;
    while at < all.len() {
        if let Some(Piece::Any(rest)) = all.get(at + 1)
            && let Piece::Sequence(pair) = rest.as_ref()
            && let [between, again] = pair.as_slice()
            && *again == all[at]
        {
            out.push(repeated(&draw(&all[at]), Some(&draw(between))));
            at += 2;
        } else {
            out.push(draw(&all[at]));
            at += 1;
        }
    }
    out
}

const STYLE: &str = "rect{stroke:#57606a;fill:#fff}.l{fill:#ddf4ff}.r{fill:#fff8c5}.c{fill:#fff}\
                     path{fill:none;stroke:#57606a;stroke-width:1.5}.a{fill:#57606a}\
                     text{font:13px ui-monospace,Menlo,Consolas,monospace;text-anchor:middle;fill:#1f2328}";

fn picture(piece: &Piece) -> String {
    let drawn = draw(piece);
    let (edge, y) = (16, drawn.above + 8);
    let (width, height) = (drawn.width + 2 * edge + 2 * GAP, y + drawn.below + 8);
    let left = edge + GAP;
    let right = left + drawn.width;
    let ends = format!(
        "<path d=\"M{edge} {y}H{left}M{right} {y}H{}M{edge} {}v10M{} {}v10\"/>",
        right + GAP,
        y - 5,
        right + GAP,
        y - 5
    );
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\">\n\
         <style>{STYLE}</style><path style=\"fill:#fff;stroke:none\" d=\"M0 0H{width}V{height}H0z\"/>\n{ends}{}\n</svg>\n",
        drawn.shifted(left, y)
    )
}

#[test]
fn pictures_show_the_grammar() {
    let folder = book().join("pictures/grammar");
    let update = std::env::var_os("SPEC_UPDATE").is_some();
    let all: Vec<(&str, Rules)> = vec![("", of_page("grammar.md")), ("lexical-", of_page("lexical.md"))];
    let mut wrong = String::new();
    for (prefix, rules) in &all {
        for (name, piece) in rules {
            let path = folder.join(format!("{prefix}{name}.svg"));
            let made = picture(piece);
            if update {
                fs::create_dir_all(&folder).unwrap();
                fs::write(&path, made).unwrap();
            } else if fs::read_to_string(&path).ok().as_deref() != Some(made.as_str()) {
                wrong += &format!("{prefix}{name}.svg is not that of the rule; SPEC_UPDATE=1 writes it\n");
            }
        }
    }
    assert!(wrong.is_empty(), "\n{wrong}");
}
