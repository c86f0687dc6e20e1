//! `export --try`: what the physics engine MuJoCo says of the MJCF file, where Python has it.

use serde_json::Value;
use std::ffi::OsString;
use std::path::Path;
use std::process::{Command, Stdio};

/// What Python runs. It reads the file and nothing else of the folder it is called in.
const SCRIPT: &str = include_str!("trial.py");
/// How long time passes in the engine, seconds.
const SECONDS: &str = "2";
/// Bodies that share more than this overlap, metres.
const OVERLAP: f64 = 0.002;
/// What goes farther than this does not stay where it was put, metres.
const DRIFT: f64 = 0.02;
/// So many overlaps and moves are named.
const NAMED: usize = 5;
/// Names another Python than `python3`.
const PYTHON: &str = "SCENELANG_PYTHON";
/// With these codes the script says that the package is missing, or that the file cannot be loaded.
const MISSING: i32 = 3;

/// What came of it.
pub struct TrialOutcome {
    /// What the script printed.
    said: Value,
}

/// Loads an MJCF file and lets time pass.
///
/// # Errors
/// There is no engine, or it does not load the file.
pub fn run(model: &Path) -> Result<TrialOutcome, String> {
    let python = std::env::var_os(PYTHON).unwrap_or_else(|| OsString::from("python3"));
    let shown = python.to_string_lossy().into_owned();
    let command =
        || format!("--try needs Python with the package `mujoco`; set {PYTHON} to use a Python other than {shown}");
    let ended = Command::new(&python)
        .args([OsString::from("-c"), SCRIPT.into(), model.into(), SECONDS.into()])
        .stdin(Stdio::null())
        .output()
        .map_err(|e| format!("cannot run {shown}: {e}; {}", command()))?;
    let error = String::from_utf8_lossy(&ended.stderr);
    let last = error.trim().lines().last().unwrap_or("it said nothing").to_owned();
    match ended.status.code() {
        Some(0) => serde_json::from_slice(&ended.stdout)
            .map(|said| TrialOutcome { said })
            .map_err(|e| format!("{shown} did not answer as expected: {e}")),
        Some(MISSING) => Err(format!("{last}; {}", command())),
        _ => Err(format!("MuJoCo cannot load {}: {last}", model.display())),
    }
}

impl TrialOutcome {
    /// Whether nothing overlapped and everything stayed.
    pub fn holds(&self) -> bool {
        self.overlaps().next().is_none() && self.drifts().next().is_none()
    }

    /// What overlapped at the beginning, the deepest first.
    fn overlaps(&self) -> impl Iterator<Item = (String, f64)> + '_ {
        let found = self.said["overlaps"].as_array().into_iter().flatten().filter_map(|row| {
            let names: Vec<&str> = row["bodies"].as_array()?.iter().filter_map(Value::as_str).collect();
            Some((names.join(" and "), row["depth"].as_f64()?))
        });
        found.filter(|(_, depth)| *depth > OVERLAP)
    }

    /// How far things went, the farthest first.
    fn moves(&self) -> impl Iterator<Item = (String, f64)> + '_ {
        let rows = self.said["moves"].as_array().into_iter().flatten();
        rows.filter_map(|row| Some((row["body"].as_str()?.to_owned(), row["distance"].as_f64()?)))
    }

    fn drifts(&self) -> impl Iterator<Item = (String, f64)> + '_ {
        self.moves().filter(|(_, far)| *far > DRIFT)
    }

    /// The outcome for programs.
    pub fn json(&self) -> Value {
        let mut out = self.said.clone();
        out["ok"] = self.holds().into();
        out
    }

    /// The outcome for people, a line each.
    pub fn human(&self) -> String {
        let engine = self.said["engine"].as_str().unwrap_or("the engine");
        let millimetres = |v: f64| format!("{:.1} mm", v * 1000.0);
        let mut out = format!("{engine}, {SECONDS} s:\n");
        let overlaps: Vec<_> = self.overlaps().collect();
        let drifts: Vec<_> = self.drifts().collect();
        for (names, depth) in overlaps.iter().take(NAMED) {
            out += &format!("  {names} overlap by {}\n", millimetres(*depth));
        }
        for (name, far) in drifts.iter().take(NAMED) {
            out += &format!("  {name} moves by {}\n", millimetres(*far));
        }
        let more = overlaps.len().saturating_sub(NAMED) + drifts.len().saturating_sub(NAMED);
        if more > 0 {
            out += &format!("  and {more} more\n");
        }
        if overlaps.is_empty() {
            out += "  nothing overlaps by more than 2 mm\n";
        }
        if let (true, Some((name, far))) = (drifts.is_empty(), self.moves().next()) {
            out += &format!("  no object moves by more than 2 cm; {name} moves the most, by {}\n", millimetres(far));
        }
        out += &self.reaches();
        out
    }

    /// How far each joint comes of the way to its limit, a line each. What stands before a drawer may rightly stop it, so that
    /// it is told and nothing more.
    fn reaches(&self) -> String {
        let row = |row: &Value| {
            let (joint, [reach, limit]) = (row["joint"].as_str()?, ["reach", "limit"].map(|key| row[key].as_f64()));
            let (reach, limit) = (reach?, limit?);
            Some(match row["motion"].as_str()? {
                "hinge" => format!("  {joint} opens to {reach:.1}° of {limit:.1}°\n"),
                _ => format!("  {joint} opens to {reach:.3} m of {limit:.3} m\n"),
            })
        };
        self.said["joints"].as_array().into_iter().flatten().filter_map(row).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn what_overlaps_and_what_moves_is_told() {
        let rest = json!({ "engine": "MuJoCo 4", "overlaps": [{ "bodies": ["a", "b"], "depth": 0.0001 }],
            "moves": [{ "body": "a", "distance": 0.0004 }] });
        let rest = TrialOutcome { said: rest };
        assert!(rest.holds());
        assert_eq!(
            rest.human(),
            "MuJoCo 4, 2 s:\n  nothing overlaps by more than 2 mm\n  no object moves by more than 2 cm; a moves the most, by 0.4 mm\n"
        );
        let moved = json!({ "engine": "MuJoCo 4", "overlaps": [{ "bodies": ["a", "b"], "depth": 0.01 }],
            "moves": [{ "body": "a", "distance": 0.4 }, { "body": "b", "distance": 0.001 }] });
        let moved = TrialOutcome { said: moved };
        assert!(!moved.holds());
        assert_eq!(moved.human(), "MuJoCo 4, 2 s:\n  a and b overlap by 10.0 mm\n  a moves by 400.0 mm\n");
        assert_eq!(moved.json()["ok"], false);
        let driven = json!({ "joints": [
            { "joint": "door/leaf", "motion": "hinge", "reach": 85.04, "limit": 110.0 },
            { "joint": "desk/drawer", "motion": "slide", "reach": 0.4, "limit": 0.4 } ] });
        let reaches = TrialOutcome { said: driven }.reaches();
        assert_eq!(reaches, "  door/leaf opens to 85.0° of 110.0°\n  desk/drawer opens to 0.400 m of 0.400 m\n");
    }
}
