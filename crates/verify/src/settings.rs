//! The settings of a workspace, as `scenelang.toml` has them. Finding the file is left to the caller.

mod assets;
mod llm;

pub use assets::{Assets, ProviderKind};
pub use llm::Llm;

use crate::tolerances::{Opens, Options, Tolerances};
use scenelang_base::{Code, Diagnostic, FileId, TextRange, codes, suggest};
use scenelang_layout::Geometry;
use std::ops::Range;
use toml_edit::{Document, Item, Table, TableLike, Value};

/// What the file is called.
pub const FILE: &str = scenelang_base::door::MARK;

/// Tolerances and η beyond this are errors (metres, degrees).
const LARGEST: f64 = 1e6;

/// Settings, where they are given.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Settings {
    /// Whether the physical rules apply.
    pub physics: Option<bool>,
    /// Of what P-OPEN demands that it opens.
    pub opens: Option<Opens>,
    /// What a solid is.
    pub geometry: Option<Geometry>,
    /// Thickness of the walls of a room (metres).
    pub eta: Option<f64>,
    /// Tolerances by name, see [`Tolerances::NAMES`].
    pub tolerances: Vec<(String, f64)>,
    /// Warnings that are not reported.
    pub allow: Vec<Code>,
    /// Which language model is asked, and how.
    pub llm: Llm,
    /// Where furniture comes from.
    pub assets: Assets,
}

impl Settings {
    /// Puts what is given in the place of what `options` has.
    pub fn apply(&self, options: &mut Options) {
        options.physics = self.physics.unwrap_or(options.physics);
        options.opens = self.opens.unwrap_or(options.opens);
        options.geometry = self.geometry.unwrap_or(options.geometry);
        options.eta = self.eta.unwrap_or(options.eta);
        for (name, value) in &self.tolerances {
            if let Some(tolerance) = options.tolerances.named(name) {
                *tolerance = *value;
            }
        }
    }

    /// What they change, in words, of how files are usually judged; what `options` has otherwise is not theirs.
    pub fn changes(&self, options: &Options) -> Vec<String> {
        let usual = Options::default();
        let mut out = Vec::new();
        if self.physics == Some(options.physics) && options.physics != usual.physics {
            out.push(format!("physics {}", if options.physics { "on" } else { "off" }));
        }
        if self.opens == Some(options.opens) && options.opens != usual.opens {
            out.push(format!("opens {}", options.opens.name()));
        }
        if self.geometry == Some(options.geometry) && options.geometry != usual.geometry {
            out.push("geometry box".to_owned());
        }
        let measure = |name: &str, said: f64, now: f64, usual: f64| {
            (said == now && now != usual).then(|| format!("{name} {now}"))
        };
        out.extend(self.eta.and_then(|eta| measure("eta", eta, options.eta, usual.eta)));
        let (mut now, mut before) = (options.tolerances, usual.tolerances);
        for (name, said) in &self.tolerances {
            if let (Some(now), Some(before)) = (now.named(name), before.named(name)) {
                out.extend(measure(name, *said, *now, *before));
            }
        }
        out.extend(self.allow.iter().map(|code| format!("{code} silenced")));
        out
    }
}

/// Reads the text of a settings file.
///
/// # Errors
/// All that is wrong with it, in the order of the text: no TOML, unknown keys, wrong types, values out of range.
pub fn read(text: &str, file: FileId) -> Result<Settings, Vec<Diagnostic>> {
    read_as(text, file, false)
}

/// Reads the text of the user's own file, which holds for all workspaces: what it says of language models.
///
/// # Errors
/// All that is wrong with it, in the order of the text.
pub fn read_own(text: &str, file: FileId) -> Result<Llm, Vec<Diagnostic>> {
    read_user(text, file).map(|settings| settings.llm)
}

/// Reads all of the user's own file: what it says of language models and of furniture.
///
/// # Errors
/// All that is wrong with it, in the order of the text.
pub fn read_user(text: &str, file: FileId) -> Result<Settings, Vec<Diagnostic>> {
    read_as(text, file, true)
}

fn read_as(text: &str, file: FileId, own: bool) -> Result<Settings, Vec<Diagnostic>> {
    let mut reader = Reader { file, own, settings: Settings::default(), found: Vec::new() };
    let start = if text.starts_with('\u{feff}') { 3 } else { 0 };
    match Document::parse(&text[start..]) {
        Ok(document) => reader.top(document.as_table()),
        Err(e) => {
            let message = e.message().lines().next().unwrap_or("it cannot be read");
            let word = e.span().map_or("", |span| text[start..].get(span.start..).unwrap_or_default());
            let word = word.split(|c: char| !c.is_alphanumeric()).next().unwrap_or_default();
            let message = match matches!(word, "yes" | "no" | "on" | "off" | "True" | "False") {
                true => format!("`{word}` is not a value; write true or false"),
                false => format!("invalid TOML: {message}"),
            };
            reader.error(e.span(), message);
        }
    }
    let Reader { settings, mut found, .. } = reader;
    if found.is_empty() {
        return Ok(settings);
    }
    for finding in &mut found {
        if let Some(label) = &mut finding.primary {
            label.place.range = label.place.range.shifted(start as u32);
        }
    }
    found.sort_by_key(|d| d.primary.as_ref().map(|l| l.place.range.start));
    Err(found)
}

/// The value of a tolerance or of η, from a file or an option.
///
/// # Errors
/// What is wrong with it, to follow its name.
pub fn measure(value: f64) -> Result<f64, String> {
    if (0.0..=LARGEST).contains(&value) { Ok(value) } else { Err("takes a number from 0 to a million".to_owned()) }
}

/// That there is no such name, and which one may be meant.
pub fn unknown(what: &str, name: &str, known: &[&str]) -> String {
    match suggest::nearest(name, known.iter().copied()) {
        Some(near) => format!("there is no {what} `{name}`; did you mean `{near}`?"),
        None => format!("there is no {what} `{name}`; valid names: {}", known.join(", ")),
    }
}

struct Reader {
    file: FileId,
    /// It is the user's own file, not that of a workspace.
    own: bool,
    settings: Settings,
    found: Vec<Diagnostic>,
}

impl Reader {
    fn error(&mut self, at: Option<Range<usize>>, message: String) {
        let range = at.map_or(TextRange::empty(0), |r| TextRange::new(r.start, r.end));
        self.found.push(Diagnostic::new(codes::E0007, range.in_file(self.file), message));
    }

    fn wrong(&mut self, key: &str, item: &Item, wanted: &str) {
        self.error(item.span(), format!("`{key}` takes {wanted}, not {}", kind(item)));
    }

    fn top(&mut self, table: &Table) {
        for (key, item) in table {
            match key {
                "llm" => self.llm(item),
                "assets" => self.assets(item),
                _ if self.own => {
                    self.error(place_of(table, key), unknown("user setting", key, &["llm", "assets"]));
                }
                "physics" => match item.as_bool() {
                    Some(physics) => self.settings.physics = Some(physics),
                    None => self.wrong(key, item, "true or false"),
                },
                "opens" => match item.as_str() {
                    Some(said) => match Opens::NAMES.iter().find(|(name, _)| *name == said) {
                        Some((_, opens)) => self.settings.opens = Some(*opens),
                        None => {
                            let say = format!("`opens` takes \"all\", \"doors\" or \"none\", not {said:?}");
                            self.error(item.span(), say);
                        }
                    },
                    None => self.wrong(key, item, "\"all\", \"doors\" or \"none\""),
                },
                "geometry" => match item.as_str() {
                    Some("parts") => self.settings.geometry = Some(Geometry::Parts),
                    Some("box") => self.settings.geometry = Some(Geometry::Box),
                    Some(other) => {
                        self.error(item.span(), format!("`geometry` takes \"parts\" or \"box\", not {other:?}"));
                    }
                    None => self.wrong(key, item, "\"parts\" or \"box\""),
                },
                "eta" => self.settings.eta = self.number(key, item),
                "tolerances" => self.tolerances(item),
                "lints" => self.lints(item),
                _ => {
                    let known = ["physics", "opens", "geometry", "eta", "tolerances", "lints", "llm", "assets"];
                    self.error(place_of(table, key), unknown("setting", key, &known));
                }
            }
        }
    }

    fn tolerances(&mut self, item: &Item) {
        let Some(table) = item.as_table_like() else { return self.wrong("tolerances", item, "a table of numbers") };
        for (name, item) in table.iter() {
            if !Tolerances::NAMES.contains(&name) {
                let place = table.get_key_value(name).and_then(|(key, _)| key.span());
                self.error(place, unknown("tolerance", name, &Tolerances::NAMES));
            } else if let Some(value) = self.number(name, item) {
                self.settings.tolerances.push((name.to_owned(), value));
            }
        }
    }

    fn number(&mut self, key: &str, item: &Item) -> Option<f64> {
        let Some(number) = item.as_float().or(item.as_integer().map(|n| n as f64)) else {
            self.wrong(key, item, "a number");
            return None;
        };
        match measure(number) {
            Ok(number) => Some(number),
            Err(why) => {
                self.error(item.span(), format!("`{key}` {why}"));
                None
            }
        }
    }

    fn lints(&mut self, item: &Item) {
        let Some(table) = item.as_table_like() else { return self.wrong("lints", item, "a table") };
        for (key, item) in table.iter() {
            if key != "allow" {
                let place = table.get_key_value(key).and_then(|(key, _)| key.span());
                self.error(place, unknown("`[lints]` setting", key, &["allow"]));
                continue;
            }
            let Some(list) = item.as_array() else { return self.wrong("allow", item, "a list of codes") };
            for value in list {
                self.allow(value);
            }
        }
    }

    fn allow(&mut self, value: &Value) {
        let Some(written) = value.as_str() else {
            return self.error(value.span(), "`allow` takes codes as strings, such as \"W0203\"".to_owned());
        };
        match Code::find(written) {
            Some(code) if code.as_str().starts_with('W') => self.settings.allow.push(code),
            Some(code) => {
                self.error(value.span(), format!("{code} is not a warning; only warnings can be silenced"));
            }
            None => {
                let known = codes::ALL.iter().map(|(code, _)| code.as_str()).filter(|c| c.starts_with('W'));
                let hint = suggest::nearest(written, known).map(|near| format!("; did you mean `{near}`?"));
                self.error(value.span(), format!("there is no code `{written}`{}", hint.unwrap_or_default()));
            }
        }
    }
}

fn place_of(table: &dyn TableLike, key: &str) -> Option<Range<usize>> {
    table.get_key_value(key).and_then(|(key, _)| key.span())
}

fn kind(item: &Item) -> &'static str {
    match item {
        Item::Table(_) | Item::Value(Value::InlineTable(_)) => "a table",
        Item::ArrayOfTables(_) => "a list of tables",
        Item::Value(Value::String(_)) => "a string",
        Item::Value(Value::Integer(_)) => "a number",
        Item::Value(Value::Float(_)) => "a decimal number",
        Item::Value(Value::Boolean(_)) => "a truth value",
        Item::Value(Value::Datetime(_)) => "a date",
        Item::Value(Value::Array(_)) => "a list",
        Item::None => "nothing",
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use scenelang_base::{SourceFile, SourceMap};

    fn said(text: &str) -> String {
        let mut sources = SourceMap::new();
        let file = sources.add(SourceFile::new(FILE, FILE, text));
        match read(text, file) {
            Ok(settings) => format!("{settings:?}"),
            Err(found) => {
                let line = |d: &Diagnostic| {
                    let (start, end) = sources.lines(d.primary.as_ref().unwrap().place);
                    format!("{}:{}-{} {}", start.line, start.column, end.column, d.message)
                };
                found.iter().map(line).collect::<Vec<_>>().join("\n")
            }
        }
    }

    #[test]
    fn all_settings_are_read() {
        let text = "physics = false\nopens = \"all\"\ngeometry = \"box\"\neta = 1\n[tolerances]\nequal = 0.002\nangle = 1e-2\n[lints]\nallow = [\"W0203\", \"w0101\"]";
        let mut options = Options::default();
        let settings = read(text, FileId(0)).unwrap();
        settings.apply(&mut options);
        let wanted = Options {
            physics: false,
            opens: Opens::All,
            geometry: Geometry::Box,
            eta: 1.0,
            tolerances: Tolerances { equal: 0.002, angle: 0.01, ..Tolerances::default() },
            ..Options::default()
        };
        assert_eq!(options, wanted);
        assert_eq!(settings.allow, [codes::W0203, codes::W0101]);
        assert_eq!(read("", FileId(0)), Ok(Settings::default()));
        assert_eq!(read("tolerances = { equal = 1 }", FileId(0)).unwrap().tolerances, [("equal".to_owned(), 1.0)]);
        assert_eq!(read("tolerances.equal = 1", FileId(0)).unwrap().tolerances, [("equal".to_owned(), 1.0)]);
    }

    #[test]
    fn a_model_and_its_prices_are_read() {
        let text = "[llm]\nmodel = \"openai:m\"\nbatch = 3\ntemperature = 0\nmax_tokens = 1_000_000\ncache = false\n[llm.prices.\"openai:m\"]\ninput = 2.5\noutput = 10";
        let wanted = Llm {
            model: Some("openai:m".to_owned()),
            batch: Some(3),
            temperature: Some(0.0),
            max_tokens: Some(1_000_000),
            cache: Some(false),
            prices: vec![("openai:m".to_owned(), [2.5, 10.0])],
            ..Llm::default()
        };
        assert_eq!(read(text, FileId(0)).unwrap().llm, wanted);
    }

    #[test]
    fn a_user_may_say_more_of_models_and_nothing_else() {
        let own = |text: &str| read_own(text, FileId(0)).map_err(|found| found[0].message.clone());
        let text = "[llm]\nmodel = \"compatible:m\"\nbase_url = \"https://a.example\"\nmax_calls = 7";
        let wanted = Llm {
            model: Some("compatible:m".to_owned()),
            base_url: Some("https://a.example".to_owned()),
            max_calls: Some(7),
            ..Llm::default()
        };
        assert_eq!(own(text), Ok(wanted));
        for (text, wanted) in [
            ("eta = 0.1", "there is no user setting `eta`; valid names: llm, assets"),
            ("[llm]\nbase_url = 3", "`base_url` takes a URL, not a number"),
            ("[llm]\nkey = \"sk\"", "`key` is not a setting: keys come from the environment, never from a file"),
        ] {
            assert_eq!(own(text), Err(wanted.to_owned()), "{text}");
        }
    }

    #[test]
    fn every_slip_is_told_at_its_place() {
        for (text, wanted) in [
            ("phisics = true", "1:1-8 there is no setting `phisics`; did you mean `physics`?"),
            (
                "sofa = 1",
                "1:1-5 there is no setting `sofa`; valid names: physics, opens, geometry, eta, tolerances, lints, llm, assets",
            ),
            ("physics = \"off\"", "1:11-16 `physics` takes true or false, not a string"),
            ("opens = \"door\"", "1:9-15 `opens` takes \"all\", \"doors\" or \"none\", not \"door\""),
            ("opens = true", "1:9-13 `opens` takes \"all\", \"doors\" or \"none\", not a truth value"),
            ("geometry = \"mesh\"", "1:12-18 `geometry` takes \"parts\" or \"box\", not \"mesh\""),
            ("geometry = true", "1:12-16 `geometry` takes \"parts\" or \"box\", not a truth value"),
            ("eta = -1", "1:7-9 `eta` takes a number from 0 to a million"),
            ("eta = nan", "1:7-10 `eta` takes a number from 0 to a million"),
            ("eta = []", "1:7-9 `eta` takes a number, not a list"),
            ("[tolerances]\nequals = 1", "2:1-7 there is no tolerance `equals`; did you mean `equal`?"),
            ("[tolerances]\nequal = 1979-05-27", "2:9-19 `equal` takes a number, not a date"),
            ("tolerances = 1", "1:14-15 `tolerances` takes a table of numbers, not a number"),
            ("[[tolerances]]", "1:1-15 `tolerances` takes a table of numbers, not a list of tables"),
            ("[lints]\ndeny = []", "2:1-5 there is no `[lints]` setting `deny`; valid names: allow"),
            ("[lints]\nallow = \"W0203\"", "2:9-16 `allow` takes a list of codes, not a string"),
            ("[lints]\nallow = [3]", "2:10-11 `allow` takes codes as strings, such as \"W0203\""),
            ("[lints]\nallow = [\"W0230\"]", "2:10-17 there is no code `W0230`; did you mean `W0203`?"),
            ("[lints]\nallow = [\"E0201\"]", "2:10-17 E0201 is not a warning; only warnings can be silenced"),
            ("llm = \"openai:m\"", "1:7-17 `llm` takes a table, not a string"),
            ("[llm]\nmodel = 4", "2:9-10 `model` takes a model as PROVIDER:NAME, not a number"),
            ("[llm]\nround = 4", "2:1-6 there is no `[llm]` setting `round`; did you mean `rounds`?"),
            ("[llm]\nrounds = 4.5", "2:10-13 `rounds` takes a whole number, not a decimal number"),
            ("[llm]\nrounds = 1000", "2:10-14 `rounds` takes a number from 0 to 100"),
            ("[llm]\ntries = 100", "2:9-12 `tries` takes a number from 1 to 10"),
            ("[llm]\nmax_output = 9000000000000", "2:14-27 `max_output` takes a number from 1 to 100000"),
            ("[llm]\ntimeout = 86400", "2:11-16 `timeout` takes a number from 1 to 3600"),
            ("[llm]\nbatch = 0", "2:9-10 `batch` takes a number from 1 to 1000"),
            ("[llm]\ntemperature = nan", "2:15-18 `temperature` takes a number from 0 to 2"),
            ("[llm]\ncache = \"on\"", "2:9-13 `cache` takes true or false, not a string"),
            (
                "[llm]\nbase_url = \"https://a.example\"",
                "2:1-9 `base_url` is not a workspace setting: set it with --base-url or in your own config.toml",
            ),
            (
                "[llm]\napi_key = \"sk-1\"",
                "2:1-8 `api_key` is not a setting: keys come from the environment, never from a file",
            ),
            (
                "[llm]\nprices = 3",
                "2:10-11 `prices` takes a table of models, each with `input` and `output`, not a number",
            ),
            ("[llm]\nprices.m.input = 3", "2:8-9 the price of `m` needs `input` and `output`, each per million tokens"),
            ("[llm]\nprices.m = { in = 3 }", "2:14-16 there is no price field `in`; valid names: input, output"),
            ("[llm]\nprices.m = { input = -3, output = 1 }", "2:22-24 `input` takes a number from 0 to 1000000000"),
            ("physics = no", "1:11-13 `no` is not a value; write true or false"),
            ("\u{feff}phisics = true", "1:1-8 there is no setting `phisics`; did you mean `physics`?"),
        ] {
            assert_eq!(said(text), wanted, "{text}");
        }
        assert!(said("eta = ").starts_with("1:") && said("eta = ").contains("invalid TOML"), "{}", said("eta = "));
        assert!(said("eta = 1\neta = 2").starts_with("2:1"), "{}", said("eta = 1\neta = 2"));
        assert_eq!(said("phisics = true\neta = true").lines().count(), 2);
    }
}
