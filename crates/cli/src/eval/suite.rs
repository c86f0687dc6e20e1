//! `scenelang eval run` measures a suite, a scene at a time; `scenelang eval report` makes a page of what came of it.

use super::fail;
use crate::args::{EvalReport, EvalRun, SummaryFormat};
use crate::model::ModelSession;
use crate::progress::Progress;
use crate::{GOOD, INTERRUPTED, interrupt, parallel, replace};
use base64::Engine;
use scenelang_base::door::Door;
use scenelang_eval::dataset::DatasetScene;
use scenelang_eval::resemblance::{Embedded, Lexical, Similarity, of_program, of_scene};
use scenelang_eval::suite::{Case, Draw, Figures, Means, Suite, page, parse};
use scenelang_export::picture::{Picture, PictureView, png};
use scenelang_export::{Scene, SceneInput};
use scenelang_formalize::Options;
use scenelang_lang::compile_text;
use scenelang_layout::Layout;
use scenelang_llm::{Image, Model, Session};
use std::path::{Path, PathBuf};

/// The suite as it was measured, and its figures.
const SUITE: &str = "suite.json";
const FIGURES: &str = "figures.json";

/// Measures a suite.
pub fn run(args: &EvalRun) -> u8 {
    match all(args) {
        Ok(code) => code,
        Err(message) => fail(&message),
    }
}

fn text_of(path: &Path) -> Result<String, String> {
    let bytes = Door::of(path).read(path).map_err(|e| format!("cannot read {}: {e}", path.display()))?;
    let text = String::from_utf8(bytes).map_err(|_| format!("{} is not valid UTF-8", path.display()))?;
    // A byte order mark, as some editors write it.
    Ok(text.trim_start_matches('\u{feff}').to_owned())
}

/// A suite while it is measured.
struct Run<'a> {
    args: &'a EvalRun,
    suite: &'a Suite,
    means: Means<'a>,
    /// Whom is asked directly.
    model: Option<String>,
}

fn all(args: &EvalRun) -> Result<u8, String> {
    if let Some(path) = &args.texts {
        return texts_of(args, path).map(|()| GOOD);
    }
    let suite = parse(&text_of(&args.suite)?).map_err(|why| format!("{}: {why}", args.suite.display()))?;
    let numbers: Vec<u64> = (0..suite.scenes).collect();
    let [own, figures] = [SUITE, FIGURES].map(|name| args.output.join(name));
    for path in numbers.iter().map(|n| case_of(args, &suite, *n)).chain([own.clone(), figures.clone()]) {
        replace::permit(&path, &[&args.suite], args.force)?;
    }
    let similarity = similarity(args, &suite)?;
    let workspace = scenelang_verify::settings::Llm::default();
    let asked = ModelSession::new(&args.model, &workspace, suite.seed).map_err(|e| e.to_string())?;
    let mut model = asked.map(|asked| asked.into_parts().0);
    let name = model.as_ref().map(|model| model.name().to_owned());
    if args.pictures && model.is_none() {
        return Err(
            "--pictures needs a model that is shown the pictures: name one with --model PROVIDER:NAME".to_owned()
        );
    }
    interrupt::gently();
    let stop = interrupt::stop();
    let draw = args.pictures.then_some(&drawn as &Draw<'_>);
    let means = Means { reader: &read, similarity: similarity.as_ref(), draw, stop: &stop };
    let run = Run { args, suite: &suite, means, model: name };
    let progress = Progress::new("starting");
    let (mut cases, mut failure, mut again) = (Vec::new(), None, 0);
    let mut each = |done: Option<Result<(Case, bool), String>>| {
        match done {
            Some(Ok((case, is_old))) => {
                again += usize::from(is_old);
                cases.push(case);
            }
            Some(Err(why)) => failure = failure.take().or(Some(why)),
            None => {}
        }
        progress.say(format!("{} of {} scenes", cases.len(), suite.scenes));
    };
    match &mut model {
        // A conversation goes one question after the other.
        Some(model) => numbers.iter().for_each(|number| each(run.case(*number, Some(model)))),
        None => {
            let jobs = args.jobs.map_or_else(parallel::usual, usize::from);
            parallel::in_order(&numbers, jobs, |number| run.case(*number, None), each);
        }
    }
    drop(progress);
    let done = format!(
        "{} of {} scenes have been measured; run the same command again to continue",
        cases.len(),
        suite.scenes
    );
    if interrupt::asked() {
        eprintln!("interrupted: {done}");
        return Ok(INTERRUPTED);
    }
    if let Some(why) = failure {
        return Err(format!("{why}\n{done}"));
    }
    let found = Figures::of(&suite.name, &cases);
    let [suite, text] = [serde_json::to_string_pretty(&suite), serde_json::to_string_pretty(&found)]
        .map(|text| text.map(|text| text + "\n").map_err(|e| e.to_string()));
    replace::layouts(&[(own.as_path(), suite?.as_str()), (figures.as_path(), text?.as_str())], |_| false)?;
    match args.format {
        SummaryFormat::Json => println!("{}", serde_json::to_string(&found).map_err(|e| e.to_string())?),
        SummaryFormat::Human if again > 0 => {
            crate::out::show(&format!("{again} scenes were measured before\n{}", shown(&found)));
        }
        SummaryFormat::Human => crate::out::show(&shown(&found)),
    }
    Ok(GOOD)
}

/// The file of a scene.
fn case_of(args: &EvalRun, suite: &Suite, number: u64) -> PathBuf {
    args.output.join("cases").join(format!("{}.json", suite.id(number)))
}

impl Run<'_> {
    /// What is known of a scene, or what comes of it now, and whether it was known. `None`: the end was asked for.
    fn case(&self, number: u64, model: Option<&mut Session>) -> Option<Result<(Case, bool), String>> {
        let path = case_of(self.args, self.suite, number);
        if interrupt::asked() {
            return None;
        }
        if let Some(case) = known(&path, &self.suite.key(number, &self.means, self.model.as_deref())) {
            return Some(Ok((case, true)));
        }
        let made = self.suite.case(number, &self.means, model.map(|model| model as &mut dyn Model))?;
        Some(made.and_then(|case| {
            let text = serde_json::to_string_pretty(&case).map_err(|e| e.to_string())? + "\n";
            replace::json(&path, &text).map(|()| (case, false))
        }))
    }
}

/// What our English reader makes of a request, without adding anything.
fn read(request: &str) -> String {
    scenelang_formalize::write::write(&scenelang_formalize::read(request, &Options { literal: true }).draft)
}

/// The picture of a layout of a scene from above.
fn drawn(scene: &DatasetScene, layout: &Layout) -> Result<Image, String> {
    let name = format!("{}.scene", scene.id);
    let compiled = compile_text(&name, Path::new(&name), &scene.program, scenelang_lang::Options::default());
    let program = compiled.program.as_ref().ok_or("its program does not compile")?;
    let text = scenelang_layout::file::to_json(layout, None);
    let input = SceneInput {
        name: &scene.id,
        program,
        sources: &compiled.sources,
        files: &[compiled.main],
        layout,
        layout_text: &text,
        report: &serde_json::Value::Null,
    };
    let scene = Scene::build(&input).map_err(|e| e.to_string())?;
    let png = png(&scene, Picture { view: PictureView::Top, ..Picture::default() }).map_err(|e| e.to_string())?;
    Ok(Image { media: "image/png".to_owned(), base64: base64::engine::general_purpose::STANDARD.encode(png) })
}

/// A case that was measured before, of the same suite with the same means.
fn known(path: &Path, key: &str) -> Option<Case> {
    let case: Case = stored(path).ok()?;
    (case.key == key).then_some(case)
}

/// What a file of ours holds, without the sum that it is known again by.
fn stored<T: serde::de::DeserializeOwned>(path: &Path) -> Result<T, String> {
    let bad = |e: serde_json::Error| format!("{}: {e}", path.display());
    let mut value: serde_json::Value = serde_json::from_str(&text_of(path)?).map_err(bad)?;
    if let Some(members) = value.as_object_mut() {
        members.remove("written");
    }
    serde_json::from_value(value).map_err(bad)
}

/// How likeness is judged. Vectors of texts that are compared must all be there.
fn similarity(args: &EvalRun, suite: &Suite) -> Result<Box<dyn Similarity>, String> {
    let Some(path) = &args.embeddings else { return Ok(Box::new(Lexical)) };
    let name = path.file_stem().map_or_else(|| "embeddings".to_owned(), |name| name.to_string_lossy().into_owned());
    let said = |why: String| format!("{}: {why}", path.display());
    let vectors = Embedded::read(&name, &text_of(path)?).map_err(said)?;
    let texts = texts(suite);
    if let Some(text) = vectors.missing(texts.iter().map(String::as_str)) {
        return Err(said(format!("there is no vector for {text:?}; --texts writes all texts that need one")));
    }
    Ok(Box::new(vectors))
}

/// All texts that a suite compares, each once, sorted.
fn texts(suite: &Suite) -> Vec<String> {
    let mut all = std::collections::BTreeSet::new();
    for number in 0..suite.scenes {
        let scene = scenelang_eval::dataset::scene(suite.seed, number);
        let (objects, clauses) = of_scene(&scene);
        let made = of_program(&read(&scene.request));
        for object in objects.into_iter().chain(made.objects) {
            all.extend([object.name, object.description]);
        }
        all.extend(clauses.into_iter().map(|clause| clause.sentence).chain(made.sentences));
    }
    all.into_iter().collect()
}

/// Writes the texts that need vectors.
fn texts_of(args: &EvalRun, to: &Path) -> Result<(), String> {
    let suite = parse(&text_of(&args.suite)?).map_err(|why| format!("{}: {why}", args.suite.display()))?;
    replace::permit(to, &[&args.suite], args.force)?;
    let line = |text: &String| serde_json::json!({ "text": text }).to_string() + "\n";
    let lines: String = texts(&suite).iter().map(line).collect();
    scenelang_base::fs::write_set(&[(to.to_path_buf(), lines.as_bytes())]).map_err(|e| e.to_string())
}

fn shown(figures: &Figures) -> String {
    let list = |values: &[f64]| values.iter().map(|x| format!("{x:.1}")).collect::<Vec<_>>().join(", ");
    let mut out = format!("relations that hold after each iteration, %: {}\n", list(&figures.search));
    out += &format!("all hard constraints hold in {} of {} scenes\n", figures.scenes, figures.size[0]);
    out += &format!(
        "Holodeck's floor solver (reimplemented): {} % of the relations hold, {} % of the objects are placed\n",
        figures.grid[0], figures.grid[1]
    );
    if let Some([held, placed]) = figures.direct {
        out += &format!("direct prompting: {held} % of the relations hold, {placed} % of the objects are placed\n");
    }
    if let Some([request, sentence]) = figures.coherence {
        out += &format!(
            "pictures show {request} % of the requests and {sentence} % of their sentences, as the model rates them\n"
        );
    }
    for (row, tau) in figures.resemblance.iter().zip(scenelang_eval::resemblance::TAUS) {
        let similarity = &figures.similarity;
        out += &format!("F1 at {tau} ({similarity}), %: objects {}, layout {}, overall {}\n", row[2], row[5], row[8]);
    }
    out
}

/// Makes a page of the results of a suite.
pub fn report(args: &EvalReport) -> u8 {
    match written(args) {
        Ok(()) => GOOD,
        Err(message) => fail(&message),
    }
}

fn written(args: &EvalReport) -> Result<(), String> {
    let (suite, cases) = results(&args.results)?;
    let found = Figures::of(&suite.name, &cases);
    let made = page(&found, &cases);
    let mut files: Vec<(PathBuf, String)> = Vec::new();
    if let Some(path) = &args.html {
        files.push((path.clone(), made.html()));
    }
    if let Some(path) = &args.output {
        let folder = path.parent().map_or_else(PathBuf::new, Path::to_path_buf).join("images");
        files.push((path.clone(), made.markdown("images")));
        files.extend(made.pictures.iter().map(|picture| (folder.join(picture.file), picture.svg.clone())));
    }
    if files.is_empty() {
        crate::out::show(&made.markdown("."));
        return Ok(());
    }
    files.iter().try_for_each(|(path, _)| replace::permit(path, &[], args.force))?;
    let set: Vec<(PathBuf, &[u8])> = files.iter().map(|(path, text)| (path.clone(), text.as_bytes())).collect();
    scenelang_base::fs::write_set(&set).map_err(|e| e.to_string())
}

/// The suite and the cases of a folder of results, in their order.
fn results(folder: &Path) -> Result<(Suite, Vec<Case>), String> {
    let suite: Suite = stored(&folder.join(SUITE))?;
    let case = |number| {
        let path = folder.join("cases").join(format!("{}.json", suite.id(number)));
        stored(&path).map_err(|why| format!("{why}; `scenelang eval run` measures what is missing"))
    };
    let cases = (0..suite.scenes).map(case).collect::<Result<_, String>>()?;
    Ok((suite, cases))
}
