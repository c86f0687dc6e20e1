//! `scenelang eval dataset`: requests with ground truth, programs and layouts, made offline.

use super::fail;
use crate::args::{EvalDataset, SummaryFormat};
use crate::progress::Progress;
use crate::replace::May;
use crate::table::Table;
use crate::{FINDINGS, GOOD, INTERRUPTED, interrupt, parallel, replace};
use scenelang_eval::dataset::{DatasetScene, PUBLISHED, SCHEMA, Statistics, solved};
use scenelang_export::OutFile;
use std::fmt::Write;

/// What is written beside the files of each scene.
const FILES: [&str; 3] = ["dataset.jsonl", "statistics.json", "dataset.schema.json"];

/// Makes a dataset; 0 if everything that must hold does so in each scene.
pub fn run(args: &EvalDataset) -> u8 {
    let names: Vec<OutFile> = FILES.into_iter().map(|name| OutFile::new(name, String::new())).collect();
    let may = May { force: args.force, these: &[] };
    if let Err(message) = replace::permit_folder(&args.output, &names, &[], may) {
        return fail(&message);
    }
    interrupt::gently();
    let stop = interrupt::stop();
    let numbers: Vec<u64> = (0..args.scenes).collect();
    let progress = Progress::new("starting");
    let mut scenes: Vec<DatasetScene> = Vec::new();
    let mut failure = None;
    let each = |scene: Option<Result<DatasetScene, String>>| {
        match scene {
            Some(Ok(scene)) => scenes.push(scene),
            Some(Err(why)) => failure = failure.take().or(Some(why)),
            None => {}
        }
        let good = scenes.iter().filter(|scene| scene.holds()).count();
        progress.say(format!("{} of {} scenes; all hard constraints hold in {good}", scenes.len(), args.scenes));
    };
    let jobs = args.jobs.map_or_else(parallel::usual, usize::from);
    parallel::in_order(&numbers, jobs, |number| (!interrupt::asked()).then(|| solved(args.seed, *number, &stop)), each);
    drop(progress);
    if interrupt::asked() {
        eprintln!("interrupted after {} of {} scenes; nothing was written", scenes.len(), args.scenes);
        return INTERRUPTED;
    }
    if let Some(why) = failure {
        return fail(&why);
    }
    let statistics = Statistics::of(&scenes);
    let written = files(&scenes, &statistics).and_then(|files| replace::folder(&args.output, &files, &[], may));
    if let Err(message) = written {
        return fail(&message);
    }
    match args.format {
        SummaryFormat::Json => println!("{}", statistics.json()),
        SummaryFormat::Human => crate::out::show(&text(&statistics)),
    }
    if scenes.iter().all(DatasetScene::holds) { GOOD } else { FINDINGS }
}

fn files(scenes: &[DatasetScene], statistics: &Statistics) -> Result<Vec<OutFile>, String> {
    let mut lines = String::new();
    let mut out = Vec::new();
    for scene in scenes {
        lines.push_str(&scene.line()?);
        let named = |end: &str| format!("{}.{end}", scene.id);
        out.push(OutFile::new(named("txt"), scene.request.clone()));
        out.push(OutFile::new(named("expect.json"), format!("{:#}\n", scene.expectation())));
        out.push(OutFile::new(named("scene"), scene.program.clone()));
        if let Some(layout) = &scene.layout {
            let mut layout = layout.clone();
            layout["scene"] = named("scene").into();
            out.push(OutFile::new(named("layout.json"), format!("{layout:#}\n")));
        }
    }
    out.push(OutFile::new(FILES[0], lines));
    out.push(OutFile::new(FILES[1], format!("{:#}\n", statistics.json())));
    out.push(OutFile::new(FILES[2], SCHEMA));
    Ok(out)
}

fn text(statistics: &Statistics) -> String {
    let mut table = Table::new(&["", "published", "this one"]);
    for ((name, published), own) in PUBLISHED.iter().zip(statistics.counts) {
        let own = (own * 10.0).round() / 10.0;
        table.row([(*name).to_owned(), published.to_string(), own.to_string()]);
    }
    let mut out = table.render();
    let [[holding, of], [held, all]] = [statistics.holding, statistics.relations];
    let _ = writeln!(out, "\nall hard constraints hold in {holding} of the {of} scenes that can have a layout");
    let _ = writeln!(out, "{held} of {all} relations hold");
    out
}
