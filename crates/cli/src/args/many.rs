//! Options of the commands that make many scenes: `scenelang sample` and `scenelang batch`.

use super::seconds;
use super::{Judging, SummaryFormat};
use clap::{Args as ClapArgs, Subcommand};
use std::path::PathBuf;

/// `scenelang sample`
#[derive(ClapArgs, Debug)]
pub struct Sample {
    /// The program
    #[arg(value_name = "FILE.scene")]
    pub scene: PathBuf,
    /// The number of layouts
    #[arg(short = 'n', long = "number", value_name = "N", value_parser = clap::value_parser!(u64).range(1..=1_000_000_000))]
    pub number: u64,
    /// The random seed; each layout has its own draws of `rand` and `oneOf`
    #[arg(long, value_name = "N", default_value_t = 0, value_parser = clap::value_parser!(u64).range(..1 << 53))]
    pub seed: u64,
    /// Draw only part I of N, counted from 0; all parts together give the same result as a single run
    #[arg(long, value_name = "I/N", default_value = "0/1", value_parser = shard)]
    pub shard: Shard,
    /// How many layouts to work on in parallel; the result does not depend on it [default: the number of cores]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    pub jobs: Option<u16>,
    /// The output folder: samples-*.jsonl, with one layout per line, and report.json; samples that are there are not drawn again
    #[arg(short, long, value_name = "FOLDER")]
    pub output: PathBuf,
    /// Also export each sample in these formats, separated by commas, to sample-NUMBER
    #[arg(long, value_name = "FORMATS", value_delimiter = ',', value_parser = crate::formats::name)]
    pub export: Vec<String>,
    /// Search N times as long as usual for the initial layouts
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u64).range(1..=1000))]
    pub effort: u64,
    /// Overwrite files that scenelang did not write or that were edited, and replace samples of another run
    #[arg(long)]
    pub force: bool,
    /// The output format
    #[arg(long, value_enum, default_value_t = SummaryFormat::Human)]
    pub format: SummaryFormat,
    /// How to judge
    #[command(flatten)]
    pub judging: Judging,
}

/// `scenelang batch`
#[derive(ClapArgs, Debug)]
#[command(args_conflicts_with_subcommands = true, subcommand_negates_reqs = true)]
pub struct Batch {
    /// What to do other than to work on a manifest.
    #[command(subcommand)]
    pub command: Option<BatchCommand>,
    /// The manifest, and how it is worked on.
    #[command(flatten)]
    pub run: Option<BatchRun>,
}

/// `scenelang batch merge`
#[derive(Subcommand, Debug)]
pub enum BatchCommand {
    /// Merge the results of all shards into one list, in the order of the manifest
    Merge(BatchMerge),
}

/// `scenelang batch MANIFEST`
#[derive(ClapArgs, Debug)]
pub struct BatchRun {
    /// Jobs, one JSON object per line: {"name": "study", "request": "a study with a desk"}; instead of "request", use
    /// "program" for the path of a file, or "source" for the text of a program
    #[arg(value_name = "MANIFEST.jsonl")]
    pub manifest: PathBuf,
    /// The output folder: NAME.scene, NAME.layout.json and NAME.result.json for each line, and a summary
    #[arg(short, long, value_name = "FOLDER")]
    pub output: PathBuf,
    /// How many lines to work on in parallel; the result does not depend on it [default: the number of cores]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    pub jobs: Option<u16>,
    /// Work only on part I of N of the lines, counted from 0
    #[arg(long, value_name = "I/N", default_value = "0/1", value_parser = shard)]
    pub shard: Shard,
    /// Stop working on a line after this time and continue with the next
    #[arg(long, value_name = "SECONDS", default_value = "120", value_parser = seconds, allow_negative_numbers = true)]
    pub time: f64,
    /// The maximum memory for a line (MiB), if the system can enforce it
    #[arg(long, value_name = "MIB", default_value_t = 4096, value_parser = clap::value_parser!(u64).range(256..=1 << 20))]
    pub memory: u64,
    /// Retry lines that failed before
    #[arg(long)]
    pub retry: bool,
    /// Overwrite files that scenelang did not write or that were edited
    #[arg(long)]
    pub force: bool,
    /// The output format
    #[arg(long, value_enum, default_value_t = SummaryFormat::Human)]
    pub format: SummaryFormat,
}

/// `scenelang batch merge`
#[derive(ClapArgs, Debug)]
pub struct BatchMerge {
    /// The output folder of the shards
    #[arg(value_name = "FOLDER")]
    pub folder: PathBuf,
    /// Overwrite files that scenelang did not write or that were edited
    #[arg(long)]
    pub force: bool,
    /// The output format
    #[arg(long, value_enum, default_value_t = SummaryFormat::Human)]
    pub format: SummaryFormat,
}

/// One of the parts that work is split into.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard {
    /// Which, from 0.
    pub index: u64,
    /// Of how many.
    pub of: u64,
}

impl Shard {
    /// Which of so many things are its own: parts differ by one at most, and follow each other.
    pub fn range(self, count: u64) -> std::ops::Range<u64> {
        let cut = |i: u64| (u128::from(count) * u128::from(i) / u128::from(self.of)) as u64;
        cut(self.index)..cut(self.index + 1)
    }

    /// Its folder in that of all; where there is only one part, that of all.
    pub fn folder(self, of_all: &std::path::Path) -> PathBuf {
        match self.of {
            1 => of_all.to_path_buf(),
            of => of_all.join(format!("shard-{:05}-of-{of:05}", self.index)),
        }
    }
}

/// `--shard`
fn shard(text: &str) -> Result<Shard, String> {
    let say = || "a shard is written I/N, counted from 0: 0/4, 1/4, 2/4, 3/4".to_owned();
    let (index, of) = text.split_once('/').ok_or_else(say)?;
    let [index, of] = [index, of].map(|n| n.parse::<u64>().ok());
    match (index, of) {
        (Some(index), Some(of)) if index < of && of <= 100_000 => Ok(Shard { index, of }),
        (Some(index), Some(of)) if index == of && of > 0 => {
            Err(format!("shards are counted from 0: the last of {of} is {}/{of}", of - 1))
        }
        _ => Err(say()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shards_follow_each_other_and_leave_nothing_out() {
        for (count, of) in [(10, 3), (2, 5), (1000, 16), (7, 1), (0, 4)] {
            let parts: Vec<u64> = (0..of).flat_map(|index| Shard { index, of }.range(count)).collect();
            assert_eq!(parts, (0..count).collect::<Vec<_>>());
        }
        assert_eq!(shard("3/4"), Ok(Shard { index: 3, of: 4 }));
        assert!(shard("4/4").is_err_and(|e| e.contains("3/4")));
        for text in ["", "1", "-1/3", "0/0", "5/4", "1/x", "0/999999999"] {
            assert!(shard(text).is_err(), "{text}");
        }
    }
}
