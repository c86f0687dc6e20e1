//! The incremental front end: after any edits it says what a fresh one says, and it asks again only what it must.

use crate::soup;
use proptest::prelude::*;
use scenelang_base::{Diagnostic, SourceFile, SourceMap};
use scenelang_lang::Options;
use scenelang_lang::db::{Analysis, Cancelled};
use scenelang_lang::sources::Loader;
use std::collections::BTreeMap;
use std::io;
use std::path::Path;
use std::sync::{Arc, Mutex};

/// Files of a program that stand nowhere but here.
#[derive(Clone, Default)]
struct Files(BTreeMap<String, String>);

impl Loader for Files {
    fn load(&self, path: &Path) -> io::Result<Vec<u8>> {
        let text = self.0.get(&path.to_string_lossy().into_owned());
        text.map(|t| t.clone().into_bytes()).ok_or_else(|| io::ErrorKind::NotFound.into())
    }
}

const MAIN: &str = "main.scene";

/// An analysis and the files it has seen.
struct Session {
    analysis: Analysis,
    sources: SourceMap,
    log: Arc<Mutex<BTreeMap<String, usize>>>,
}

impl Session {
    fn new() -> Self {
        let log = Arc::new(Mutex::new(BTreeMap::new()));
        let count = log.clone();
        let analysis = Analysis::observed(Options::default(), move |query| {
            let name = query.split('(').next().unwrap().to_owned();
            *count.lock().unwrap().entry(name).or_insert(0) += 1;
        });
        Self { analysis, sources: SourceMap::new(), log }
    }

    fn update(&mut self, files: &Files) {
        let text = files.0.get(MAIN).unwrap().clone();
        let main = self.sources.put(SourceFile::new(MAIN, MAIN, text));
        self.analysis.update(main, &mut self.sources, files);
    }

    /// What is said of the files now, in words that do not depend on the order they were read in.
    fn said(&self) -> String {
        let place = |place: scenelang_base::Span| (self.sources.get(place.file).name().to_owned(), place.range);
        let text = |d: Diagnostic| format!("{:?}", d.map_places(place));
        let checked: Vec<String> = self.analysis.diagnostics().unwrap().into_iter().map(text).collect();
        let (program, all) = self.analysis.program(&self.sources).unwrap();
        let all: Vec<String> = all.into_iter().map(text).collect();
        let rows = program.map(|p| {
            let rows = p.constraints.iter();
            rows.map(|c| (place(c.span), c.text.clone(), format!("{:?}", c.formula))).collect::<Vec<_>>()
        });
        format!("{checked:#?}\n{all:#?}\n{rows:#?}")
    }

    /// The queries that ran since the last time, and how often.
    fn ran(&self) -> BTreeMap<String, usize> {
        std::mem::take(&mut *self.log.lock().unwrap())
    }
}

/// What is said of a program, edited so.
fn edited(log: &mut Session, text: &str) -> BTreeMap<String, usize> {
    log.update(&Files([(MAIN.to_owned(), text.to_owned())].into()));
    assert_eq!(log.analysis.diagnostics().unwrap(), []);
    log.ran()
}

/// A program of 2,000 statements.
fn program() -> String {
    let lines = (0..1000).map(|i| {
        format!(
            "object thing{i};\nassert near(thing{i}, thing{}, {}) or thing{i}.pos.x > 1;\n",
            if i == 0 { 1 } else { i / 2 },
            i + 1
        )
    });
    lines.collect()
}

#[test]
fn an_edit_asks_again_only_what_it_must() {
    let mut log = Session::new();
    let text = program();
    let ran = edited(&mut log, &text);
    assert!(ran["checked"] > 100, "{ran:?}");
    let of = |list: &[(&str, usize)]| list.iter().map(|(n, k)| ((*n).to_owned(), *k)).collect::<BTreeMap<_, _>>();

    // Nothing changed.
    assert_eq!(edited(&mut log, &text), of(&[]));

    // Inside one assertion: its run, and the lists of the file.
    let text = text.replace("near(thing500, thing250, 501)", "near(thing500, thing250, 1.5)");
    let one_run = of(&[("placed_runs", 1), ("outline", 1), ("parsed", 1), ("heads", 1), ("checked", 1)]);
    assert_eq!(edited(&mut log, &text), one_run);

    // A comment above everything moves everything and means nothing.
    let text = format!("// A comment.\n\n{text}");
    assert_eq!(edited(&mut log, &text), of(&[("placed_runs", 1), ("outline", 1)]));

    // A comment between statements belongs to their run.
    let text = text.replace("object thing500;", "/* here */ object thing500;");
    let ran = edited(&mut log, &text);
    assert!(ran.get("checked").copied().unwrap_or(0) <= 1 && !ran.contains_key("facts"), "{ran:?}");

    // A declaration in the middle: nobody names it, so nobody but its run is checked again.
    let text = text.replace("object thing600;", "object fresh; object thing600;");
    let ran = edited(&mut log, &text);
    assert_eq!((ran["parsed"], ran["checked"], ran["names"]), (1, 1, 1), "{ran:?}");

    // Its name in one statement far away.
    let text = text.replace("near(thing900, thing450, 901)", "near(thing900, fresh, 901)");
    assert_eq!(edited(&mut log, &text)["checked"], 1);

    // The declaration moves behind its use: the run it enters is read; the one it leaves is known from before.
    let text = text.replace("object fresh; ", "").replace("object thing950;", "object thing950; object fresh;");
    let ran = edited(&mut log, &text);
    assert_eq!((ran["parsed"], ran["checked"]), (1, 1), "{ran:?}");
}

#[test]
fn a_declaration_is_checked_again_by_who_names_it() {
    let mut log = Session::new();
    let text = program().replace("near(thing900, thing450, 901)", "near(thing900, fresh[2], 901)");
    let with =
        |text: &str, size: usize| text.replace("object thing600;", &format!("object fresh[{size}]; object thing600;"));
    edited(&mut log, &with(&text, 3));
    let ran = edited(&mut log, &with(&text, 4));
    assert_eq!((ran["parsed"], ran["checked"]), (1, 2), "its own run, and the one that uses it: {ran:?}");
}

#[test]
fn a_change_stops_who_reads() {
    let mut log = Session::new();
    let mut text = program();
    edited(&mut log, &text);
    // One thread, or, for the whole of a large program, two.
    for whole in [false, true] {
        let (started, wait) = std::sync::mpsc::channel();
        let (reader, sources) = (log.analysis.reader(), log.sources.clone());
        let read = move || if whole { reader.program(&sources).map(|_| ()) } else { reader.diagnostics().map(|_| ()) };
        let thread = std::thread::spawn(move || {
            started.send(()).unwrap();
            while read() != Err(Cancelled) {}
        });
        wait.recv().unwrap();
        text.push_str(if whole { "object last;\n" } else { "object first;\n" });
        edited(&mut log, &text); // would wait for ever if the reader did not leave
        thread.join().unwrap();
    }
}

/// What is said of a whole program does not depend on how many threads look at it.
#[test]
fn large_programs_are_suspected_as_small_ones_are() {
    let doubtful = "object idle;\nassert thing0.top > 1;\nassert thing0.top > 1;\n";
    let said = |program: &str| {
        let mut log = Session::new();
        log.update(&Files([(MAIN.to_owned(), format!("{doubtful}{program}"))].into()));
        let (program, found) = log.analysis.program(&log.sources).unwrap();
        (program.is_some(), found.into_iter().map(|d| (d.code, d.primary, d.message)).collect::<Vec<_>>())
    };
    let (small, large) = (said("object thing0;\n"), said(&program()));
    assert_eq!(small.1.iter().map(|(code, ..)| code.as_str()).collect::<Vec<_>>(), ["W0201", "W0304"]);
    assert_eq!(small, large);
}

#[test]
fn what_nobody_reads_any_more_is_forgotten() {
    // Without it, an editor's memory would grow with every keystroke. Identities of runs are used again once no text
    // has them; so their number is bounded.
    let mut log = Session::new();
    let newest = Arc::new(Mutex::new(0));
    let seen = newest.clone();
    log.analysis = Analysis::observed(Options::default(), move |query| {
        if let Some(id) = query.strip_prefix("parsed(Id(") {
            let id = u64::from_str_radix(id.split(['g', ')']).next().unwrap(), 16).unwrap();
            let mut newest = seen.lock().unwrap();
            *newest = id.max(*newest);
        }
    });
    for i in 0..500 {
        edited(&mut log, &format!("object a;\nassert a.pos.x > {i};\n"));
    }
    let first = *newest.lock().unwrap();
    for i in 500..5000 {
        edited(&mut log, &format!("object a;\nassert a.pos.x > {i};\n"));
    }
    let newest = *newest.lock().unwrap();
    assert!(newest < first + 100, "{newest} identities after 5,000 edits, {first} after 500");
}

/// A change of a text: cut from one place to another, put words in. Places are fractions of its length.
type Change = (bool, prop::sample::Index, prop::sample::Index, String);

fn change() -> impl Strategy<Value = Change> {
    let words = [
        "",
        ";",
        "object a;",
        "object b; ",
        "a.pos.x",
        "/*",
        "*/",
        "\"",
        "//",
        "\n",
        "///",
        "\u{feff}",
        "assert ",
        "near(a, b, 1)",
        "import \"other.scene\";",
        "import \"third.scene\";",
        "Number n; n <- m;",
        "Number m; m <- n;",
        "predicate p(Object x) := q(x);",
        "predicate q(Object x) := p(x);",
        "chair[2].color <- \"red\";",
        "object chair[3];",
        "@req(\"one\")",
        "é",
        " ",
        "<-",
    ];
    let put = prop_oneof![3 => prop::sample::select(words.to_vec()).prop_map(str::to_owned), 1 => soup::program()];
    (prop::bool::weighted(0.7), any::<prop::sample::Index>(), any::<prop::sample::Index>(), put)
}

fn changed(text: &str, (main, from, to, put): &Change) -> String {
    let mut borders: Vec<usize> = text.char_indices().map(|(i, _)| i).collect();
    borders.push(text.len());
    let from = from.index(borders.len());
    // Mostly short cuts: a program that is cut in half each time soon has nothing to say.
    let to = (from + to.index(borders.len()) % 12).min(borders.len() - 1);
    let _ = main;
    format!("{}{put}{}", &text[..borders[from]], &text[borders[to]..])
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 128, ..ProptestConfig::default() })]

    #[test]
    fn incremental_equals_batch(
        main in soup::program(),
        other in soup::program(),
        changes in prop::collection::vec(change(), 1..8),
    ) {
        let sound = "object a; object b; object chair[3]; import \"other.scene\"; Number n; assert near(a, b, n);\n";
        let mut files = Files::default();
        files.0.insert(MAIN.into(), format!("{sound}{main}"));
        files.0.insert("other.scene".into(), format!("import \"third.scene\"; region room;\n{other}"));
        files.0.insert("third.scene".into(), "object lamp; assert inside(lamp, room);".into());
        let mut session = Session::new();
        session.update(&files);
        session.said();
        for change in &changes {
            let name = if change.0 { MAIN } else { "other.scene" };
            let text = changed(&files.0[name], change);
            files.0.insert(name.into(), text);
            session.update(&files);
            let mut fresh = Session::new();
            fresh.update(&files);
            prop_assert_eq!(session.said(), fresh.said(), "{:?}", files.0);
        }
    }
}
