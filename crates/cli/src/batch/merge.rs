//! `scenelang batch merge`: one list of results of all shards, in the order of the manifest. It is the same however the work
//! was split.

use super::record::Record;
use super::{SUMMARY, Summary, summary_of};
use crate::args::BatchMerge;
use crate::replace::May;
use crate::{FAILED, replace};
use scenelang_base::door::Door;
use scenelang_export::OutFile;
use std::collections::BTreeMap;
use std::path::Path;

/// What is written.
const RESULTS: &str = "results.jsonl";
const ALL: &str = "summary.json";

/// Writes results and summary; 0 if each line has a scene, 1 if some failed.
pub fn run(args: &BatchMerge) -> u8 {
    match merged(args).map(|summary| summary.show(args.format)) {
        Ok(code) => code,
        Err(message) => {
            eprintln!("error: {message}");
            FAILED
        }
    }
}

fn merged(args: &BatchMerge) -> Result<Summary, String> {
    let folder = args.folder.as_path();
    let shards = complete(folder)?;
    let manifest = shards.first().map(|shard| shard.manifest.clone()).unwrap_or_default();
    let outcomes: Vec<_> = shards.into_iter().flat_map(|shard| shard.results).collect();
    let mut results = String::new();
    for outcome in &outcomes {
        let record = Record::read(folder, &outcome.name).filter(|record| record.ok == outcome.ok);
        let record = match record {
            Some(record) => record,
            // What could not even be recorded.
            None if !outcome.ok => Record::bad(&outcome.name, "", outcome.error.clone()),
            None => {
                let name = &outcome.name;
                return Err(format!(
                    "the result of line {} ({name}) is missing; run the same `scenelang batch` again to make it",
                    outcome.line
                ));
            }
        };
        results += &serde_json::to_string(&record).map_err(|e| e.to_string())?;
        results.push('\n');
    }
    let summary = Summary::new(&manifest, None, outcomes);
    let files = [OutFile::new(RESULTS, results), OutFile::new(ALL, summary.text()?)];
    replace::folder(folder, &files, &[], May { force: args.force, these: &[] })?;
    Ok(summary)
}

/// The summaries of a split that is complete, of one manifest.
fn complete(folder: &Path) -> Result<Vec<Summary>, String> {
    let entries = folder.read_dir().map_err(|e| format!("cannot read {}: {e}", folder.display()))?;
    let mut splits: BTreeMap<u64, BTreeMap<u64, Summary>> = BTreeMap::new();
    for entry in entries.flatten() {
        let name = entry.file_name().to_string_lossy().into_owned();
        if !name.starts_with("summary-") {
            continue;
        }
        let path = entry.path();
        let text = Door::within(folder).read(&path).map_err(|e| format!("cannot read {}: {e}", path.display()))?;
        let summary = serde_json::from_slice::<Summary>(&text).map_err(|e| format!("{}: {e}", path.display()))?;
        if let (SUMMARY, Some([index, of])) = (summary.format.as_str(), summary.shard) {
            splits.entry(of).or_default().insert(index, summary);
        }
    }
    if splits.is_empty() {
        return Err(format!(
            "there is no summary of a shard in {}; `scenelang batch` writes one when it is done",
            folder.display()
        ));
    }
    let is_complete = |(of, shards): &(&u64, &BTreeMap<u64, Summary>)| {
        let mut sums = shards.values().map(|shard| &shard.manifest);
        let first = sums.next();
        shards.len() as u64 == **of && sums.all(|sum| Some(sum) == first)
    };
    match splits.iter().find(is_complete).map(|(of, _)| *of) {
        Some(of) => Ok(splits.remove(&of).unwrap_or_default().into_values().collect()),
        None => Err(missing(&splits)),
    }
}

/// What is missing of the splits that there are.
fn missing(splits: &BTreeMap<u64, BTreeMap<u64, Summary>>) -> String {
    let of_split = |(of, shards): (&u64, &BTreeMap<u64, Summary>)| {
        let missing: Vec<String> = (0..*of)
            .filter(|index| !shards.contains_key(index))
            .take(5)
            .map(|index| summary_of([index, *of]))
            .collect();
        if missing.is_empty() {
            format!("the {of} shards come from different manifests")
        } else {
            format!("{} of {of} shards are done; still missing: {}", shards.len(), missing.join(", "))
        }
    };
    splits.iter().map(of_split).collect::<Vec<_>>().join("; ")
}
