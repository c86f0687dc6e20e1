//! The grammar in the book, executed: it recognises every program of the book, and every sentence that it makes parses.

use super::ebnf::{Piece, of_page};
use super::make::Maker;
use super::recognise::{Characters, Recogniser, Tokens};
use super::{Page, pages};
use crate::blocks::expected;
use scenelang_base::codes;
use scenelang_lang::parse::{core::check_core, parse_file};
use scenelang_lang::token::{Kind, lex};
use std::collections::BTreeSet;

/// Whether what the block says of itself is that its text does not parse.
fn is_broken(text: &str) -> bool {
    expected(text).iter().any(|(_, code, _)| code.starts_with("E01"))
}

#[test]
fn the_grammar_recognises_the_programs_of_the_book() {
    let rules = of_page("grammar.md");
    let mut wrong = String::new();
    let mut programs = 0;
    for Page { path, blocks, .. } in &pages() {
        for block in blocks.iter().filter(|b| b.is_scene()) {
            // `x <-1` is read as if there were a blank, which the grammar does not say.
            if block.text.contains("W0102") || is_broken(&block.text) {
                continue;
            }
            programs += 1;
            if !Recogniser::new(&rules, Tokens::of(&block.text)).accepts("program") {
                wrong += &format!("{}:{}: not of the grammar\n", path.display(), block.line);
            }
        }
    }
    assert!(wrong.is_empty(), "\n{wrong}");
    assert!(programs > 100, "only {programs}");
}

#[test]
fn the_grammar_refuses_what_does_not_parse() {
    let rules = of_page("grammar.md");
    let mut wrong = String::new();
    let mut broken = 0;
    for Page { path, blocks, .. } in &pages() {
        for block in blocks.iter().filter(|b| b.is_scene()) {
            // What is wrong inside one token (a number too large, an escape) is no matter of the grammar.
            let structural = |(_, code, _): &(u32, String, Option<u32>)| code.starts_with("E011");
            if !expected(&block.text).iter().any(structural) {
                continue;
            }
            broken += 1;
            if Recogniser::new(&rules, Tokens::of(&block.text)).accepts("program") {
                wrong += &format!("{}:{}: of the grammar all the same\n", path.display(), block.line);
            }
        }
    }
    assert!(wrong.is_empty(), "\n{wrong}");
    assert!(broken > 8, "only {broken}");
}

#[test]
fn what_the_grammars_make_parses() {
    let words = of_page("lexical.md");
    for (page, is_core) in [("grammar.md", false), ("core-grammar.md", true)] {
        let rules = of_page(page);
        let statement = rules.iter().find(|(n, _)| n == "statement").expect("a rule `statement`").1.clone();
        let mut maker = Maker::new(&rules, &words, 7);
        for _ in 0..500 {
            let mut tokens = Vec::new();
            maker.make(&statement, 14, &mut tokens);
            let text = tokens.join(" ");
            // Before a point `prefer` is a name.
            if text.len() > 2000 || text == ";" || text.contains("prefer .") {
                continue;
            }
            let parsed = parse_file(&text);
            // A number may be too large and an escape half a character: no matter of the grammar.
            let errors =
                parsed.diagnostics.iter().filter(|d| d.is_error() && ![codes::E0103, codes::E0106].contains(&d.code));
            let errors: Vec<_> = errors.map(|d| &d.message).collect();
            assert!(errors.is_empty(), "{page} makes {text}\n{errors:?}");
            for (_, stmt) in parsed.statements.iter().filter(|_| is_core) {
                let beyond: Vec<_> = check_core(stmt).into_iter().map(|d| d.message).collect();
                assert!(beyond.is_empty(), "{page} makes {text}\n{beyond:?}");
            }
        }
    }
}

#[test]
fn the_lexical_grammar_makes_and_reads_tokens() {
    let words = of_page("lexical.md");
    let tokens = [("NUMBER", Kind::Number), ("STRING", Kind::Str), ("NAME", Kind::Ident)];
    for (name, kind) in tokens {
        let piece = words.iter().find(|(n, _)| n == name).unwrap_or_else(|| panic!("no rule {name}")).1.clone();
        let mut maker = Maker::new(&words, &words, 11);
        for _ in 0..1000 {
            let mut characters = Vec::new();
            maker.make(&piece, 5, &mut characters);
            let text = characters.concat();
            let made: Vec<Kind> = lex(&text).iter().map(|t| t.kind).collect();
            assert!(made == [kind], "{name} makes {text}, which is {made:?}");
        }
    }
    for Page { path, blocks, .. } in &pages() {
        for block in blocks.iter().filter(|b| b.is_scene()) {
            for token in lex(&block.text) {
                let Some((name, _)) = tokens.iter().find(|(_, kind)| *kind == token.kind) else { continue };
                let text = &block.text[token.range.bytes()];
                let characters = Characters(text.chars().collect());
                let fits = Recogniser::new(&words, characters).accepts(name);
                let escape = *name == "STRING" && is_broken(&block.text);
                assert!(fits || escape, "{}:{}: {text} is no {name}", path.display(), block.line);
            }
        }
    }
}

#[test]
fn every_rule_of_the_grammar_is_used() {
    for page in ["grammar.md", "core-grammar.md", "lexical.md"] {
        let rules = of_page(page);
        let mut used: BTreeSet<&str> = BTreeSet::from(["program", "NUMBER", "STRING", "NAME", "COMMENT"]);
        fn names<'p>(piece: &'p Piece, out: &mut BTreeSet<&'p str>) {
            match piece {
                Piece::Rule(name) => {
                    out.insert(name);
                }
                Piece::Sequence(all) | Piece::Choice(all) => all.iter().for_each(|p| names(p, out)),
                Piece::Optional(p) | Piece::Any(p) | Piece::Some(p) => names(p, out),
                Piece::Literal(_) | Piece::Class(_) => {}
            }
        }
        rules.iter().for_each(|(_, piece)| names(piece, &mut used));
        for (name, _) in &rules {
            assert!(used.contains(name.as_str()), "{page}: nothing uses {name}");
        }
    }
}
