//! The section `[llm]`: which language model proposes, how it is asked, what may be spent. Keys are never in a file. Where
//! they are sent is said in the user's own file at most: a scene from somewhere else must not be able to say so. Nor does a
//! workspace that names a model have it asked, or allow more than the user does: that is for whoever uses these settings.

use super::{Reader, place_of, unknown};
use std::ops::RangeInclusive;
use toml_edit::{Item, TableLike};

/// What `[llm]` may have, in the order of the book.
const KEYS: [&str; 12] = [
    "model",
    "batch",
    "rounds",
    "temperature",
    "max_output",
    "timeout",
    "tries",
    "per_minute",
    "max_calls",
    "max_tokens",
    "max_money",
    "cache",
];
/// Counts beyond this are errors; it is exact as a float.
const MANY: f64 = 1e12;
/// The most rounds: each is a question or two.
const ROUNDS: f64 = 100.0;
/// The most tries: who fails ten times fails the eleventh.
const TRIES: f64 = 10.0;
/// The longest answer (tokens): some twenty times of what the longest one needs.
const OUTPUT: f64 = 100_000.0;
/// The longest wait for an answer (seconds).
const WAIT: f64 = 3600.0;

/// `[llm]`, where it is given.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Llm {
    /// `PROVIDER:NAME`.
    pub model: Option<String>,
    /// Where the model is, in place of the provider's own address; only in the user's own file.
    pub base_url: Option<String>,
    /// k: how many violated constraints are taken up at a time.
    pub batch: Option<u64>,
    /// T: how many rounds the model has.
    pub rounds: Option<u64>,
    /// How freely it chooses.
    pub temperature: Option<f64>,
    /// The longest answer (tokens).
    pub max_output: Option<u64>,
    /// The longest wait for an answer (seconds).
    pub timeout: Option<f64>,
    /// How often a request is made at most.
    pub tries: Option<u64>,
    /// How many requests are begun in a minute at most.
    pub per_minute: Option<f64>,
    /// Budget of requests.
    pub max_calls: Option<u64>,
    /// Budget of tokens.
    pub max_tokens: Option<u64>,
    /// Budget of money, in the currency of the prices.
    pub max_money: Option<f64>,
    /// Whether answers are kept.
    pub cache: Option<bool>,
    /// What a million tokens cost, read and written, by `PROVIDER:NAME`.
    pub prices: Vec<(String, [f64; 2])>,
}

impl Reader {
    pub(super) fn llm(&mut self, item: &Item) {
        let Some(table) = item.as_table_like() else { return self.wrong("llm", item, "a table") };
        for (key, item) in table.iter() {
            match key {
                "model" => match item.as_str() {
                    Some(model) => self.settings.llm.model = Some(model.to_owned()),
                    None => self.wrong(key, item, "a model as PROVIDER:NAME"),
                },
                "batch" => self.settings.llm.batch = self.count(key, item, 1.0..=1000.0),
                "rounds" => self.settings.llm.rounds = self.count(key, item, 0.0..=ROUNDS),
                "temperature" => self.settings.llm.temperature = self.between(key, item, 0.0..=2.0),
                "max_output" => self.settings.llm.max_output = self.count(key, item, 1.0..=OUTPUT),
                "timeout" => self.settings.llm.timeout = self.between(key, item, 1.0..=WAIT),
                "tries" => self.settings.llm.tries = self.count(key, item, 1.0..=TRIES),
                "per_minute" => self.settings.llm.per_minute = self.between(key, item, 0.01..=1e6),
                "max_calls" => self.settings.llm.max_calls = self.count(key, item, 0.0..=MANY),
                "max_tokens" => self.settings.llm.max_tokens = self.count(key, item, 0.0..=MANY),
                "max_money" => self.settings.llm.max_money = self.between(key, item, 0.0..=MANY),
                "cache" => match item.as_bool() {
                    Some(cache) => self.settings.llm.cache = Some(cache),
                    None => self.wrong(key, item, "true or false"),
                },
                "prices" => self.prices(item),
                "base_url" if self.own => match item.as_str() {
                    Some(url) => self.settings.llm.base_url = Some(url.to_owned()),
                    None => self.wrong(key, item, "a URL"),
                },
                "base_url" => {
                    let say = "`base_url` is not a workspace setting: set it with --base-url or \
                               in your own config.toml";
                    self.error(place_of(table, key), say.to_owned());
                }
                "key" | "api_key" => {
                    let say = format!("`{key}` is not a setting: keys come from the environment, never from a file");
                    self.error(place_of(table, key), say);
                }
                _ => {
                    let known: Vec<&str> = KEYS.into_iter().chain(["prices"]).collect();
                    self.error(place_of(table, key), unknown("`[llm]` setting", key, &known));
                }
            }
        }
    }

    fn prices(&mut self, item: &Item) {
        let wanted = "a table of models, each with `input` and `output`";
        let Some(models) = item.as_table_like() else { return self.wrong("prices", item, wanted) };
        for (model, item) in models.iter() {
            let Some(price) = item.as_table_like() else { return self.wrong(model, item, "`input` and `output`") };
            if let Some(price) = self.price(price, model, item) {
                self.settings.llm.prices.push((model.to_owned(), price));
            }
        }
    }

    fn price(&mut self, table: &dyn TableLike, model: &str, whole: &Item) -> Option<[f64; 2]> {
        for (key, _) in table.iter() {
            if !["input", "output"].contains(&key) {
                self.error(place_of(table, key), unknown("price field", key, &["input", "output"]));
                return None;
            }
        }
        let (Some(input), Some(output)) = (table.get("input"), table.get("output")) else {
            self.error(
                whole.span(),
                format!("the price of `{model}` needs `input` and `output`, each per million tokens"),
            );
            return None;
        };
        Some([self.between("input", input, 0.0..=1e9)?, self.between("output", output, 0.0..=1e9)?])
    }

    /// A number of a range.
    pub(super) fn between(&mut self, key: &str, item: &Item, range: RangeInclusive<f64>) -> Option<f64> {
        let number = item.as_float().or(item.as_integer().map(|n| n as f64));
        match number {
            Some(number) if range.contains(&number) => return Some(number),
            Some(_) => {
                let say = format!("`{key}` takes a number from {} to {}", range.start(), range.end());
                self.error(item.span(), say);
            }
            None => self.wrong(key, item, "a number"),
        }
        None
    }

    /// A whole number of a range.
    pub(super) fn count(&mut self, key: &str, item: &Item, range: RangeInclusive<f64>) -> Option<u64> {
        if item.as_integer().is_none() {
            self.wrong(key, item, "a whole number");
            return None;
        }
        self.between(key, item, range).map(|n| n as u64)
    }
}
