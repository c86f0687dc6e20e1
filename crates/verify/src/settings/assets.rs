//! The section `[assets]`: where furniture comes from. A workspace may name its own folders of models and the order in
//! which providers are asked. What has a program run or a network used stands in the user's own file only, as for language
//! models: a scene from somewhere else must not be able to say so.

use super::{Reader, place_of, unknown};
use toml_edit::Item;

/// What `[assets]` of a workspace may have, in the order of the book.
const KEYS: [&str; 6] = ["order", "folders", "least", "timeout", "max_models", "cache"];
/// What the user's own may have besides.
const OWN: [&str; 3] = ["generator", "command", "url"];
/// Lists are not longer.
const LONGEST: usize = 64;
/// The longest wait for a model (seconds).
const WAIT: f64 = 3600.0;
/// The most models made in one run.
const MODELS: f64 = 100_000.0;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ProviderKind {
    /// Folders of models.
    Local,
    /// A program or a service that makes models.
    Generator,
    /// The furniture library.
    Library,
}

impl ProviderKind {
    /// As in settings, in the usual order.
    pub const NAMES: [(&str, Self); 3] =
        [("local", Self::Local), ("generator", Self::Generator), ("library", Self::Library)];
}

/// `[assets]`, where it is given.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Assets {
    /// Who is asked, in this order; a labelled box comes last in any case.
    pub order: Option<Vec<ProviderKind>>,
    /// Folders of models: below that of the settings, or anywhere in the user's own file.
    pub folders: Vec<String>,
    /// Models of a folder that score less are not used.
    pub least: Option<f64>,
    /// Who makes models; only in the user's own file.
    pub generator: Option<String>,
    /// The program that makes models, with its arguments; only in the user's own file.
    pub command: Vec<String>,
    /// Where the service is; only in the user's own file.
    pub url: Option<String>,
    /// The longest wait for a model (seconds).
    pub timeout: Option<f64>,
    /// How many models are made in one run at most.
    pub max_models: Option<u64>,
    /// Whether models that were made are kept.
    pub cache: Option<bool>,
}

impl Reader {
    pub(super) fn assets(&mut self, item: &Item) {
        let Some(table) = item.as_table_like() else { return self.wrong("assets", item, "a table") };
        for (key, item) in table.iter() {
            match key {
                "order" => self.order(item),
                "folders" => self.settings.assets.folders = self.texts(key, item, "a list of folders"),
                "least" => self.settings.assets.least = self.between(key, item, 0.0..=1e6),
                "timeout" => self.settings.assets.timeout = self.between(key, item, 1.0..=WAIT),
                "max_models" => self.settings.assets.max_models = self.count(key, item, 0.0..=MODELS),
                "cache" => match item.as_bool() {
                    Some(cache) => self.settings.assets.cache = Some(cache),
                    None => self.wrong(key, item, "true or false"),
                },
                "generator" if self.own => {
                    self.settings.assets.generator = self.text(key, item, "the name of a generator")
                }
                "url" if self.own => self.settings.assets.url = self.text(key, item, "a URL"),
                "command" if self.own => {
                    self.settings.assets.command = self.texts(key, item, "a list: a program and its arguments");
                }
                "generator" | "url" | "command" => {
                    let say = format!(
                        "`{key}` is not a workspace setting: choose the program or service that makes models with \
                         --generator or in your own config.toml"
                    );
                    self.error(place_of(table, key), say);
                }
                "key" | "api_key" => {
                    let say = format!("`{key}` is not a setting: keys come from the environment, never from a file");
                    self.error(place_of(table, key), say);
                }
                _ => {
                    let own: &[&str] = if self.own { &OWN } else { &[] };
                    let known: Vec<&str> = KEYS.iter().chain(own).copied().collect();
                    self.error(place_of(table, key), unknown("`[assets]` setting", key, &known));
                }
            }
        }
    }

    fn order(&mut self, item: &Item) {
        let names = self.texts("order", item, "a list of \"local\", \"generator\" and \"library\"");
        let mut order = Vec::new();
        for name in &names {
            match ProviderKind::NAMES.iter().find(|(known, _)| known == name) {
                Some((_, source)) if order.contains(source) => {
                    return self.error(item.span(), format!("`order` names \"{name}\" twice"));
                }
                Some((_, source)) => order.push(*source),
                None => {
                    let known = ProviderKind::NAMES.map(|(name, _)| name);
                    return self.error(item.span(), unknown("provider", name, &known));
                }
            }
        }
        self.settings.assets.order = Some(order);
    }

    fn text(&mut self, key: &str, item: &Item, wanted: &str) -> Option<String> {
        let text = item.as_str().filter(|text| !text.trim().is_empty());
        if text.is_none() {
            self.wrong(key, item, wanted);
        }
        text.map(str::to_owned)
    }

    fn texts(&mut self, key: &str, item: &Item, wanted: &str) -> Vec<String> {
        let list = item.as_array().filter(|list| list.len() <= LONGEST);
        let texts: Option<Vec<String>> =
            list.and_then(|list| list.iter().map(|value| value.as_str().map(str::to_owned)).collect());
        texts.unwrap_or_else(|| {
            self.error(item.span(), format!("`{key}` takes {wanted}, of at most {LONGEST} strings"));
            Vec::new()
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::settings::{read, read_user};
    use scenelang_base::FileId;

    #[test]
    fn a_workspace_names_folders_and_no_program() {
        let read = |text: &str| read(text, FileId(0)).map(|s| s.assets).map_err(|found| found[0].message.clone());
        let text = "[assets]\norder = [\"library\", \"local\"]\nfolders = [\"models\"]\nleast = 0.5\nmax_models = 3\ncache = false";
        let wanted = Assets {
            order: Some(vec![ProviderKind::Library, ProviderKind::Local]),
            folders: vec!["models".to_owned()],
            least: Some(0.5),
            max_models: Some(3),
            cache: Some(false),
            ..Assets::default()
        };
        assert_eq!(read(text), Ok(wanted));
        for (text, wanted) in [
            ("assets = 1", "`assets` takes a table, not a number"),
            ("[assets]\nfolder = 1", "there is no `[assets]` setting `folder`; did you mean `folders`?"),
            ("[assets]\nfolders = \"a\"", "`folders` takes a list of folders, of at most 64 strings"),
            ("[assets]\norder = [\"box\"]", "there is no provider `box`; valid names: local, generator, library"),
            ("[assets]\norder = [\"local\", \"local\"]", "`order` names \"local\" twice"),
            ("[assets]\ncache = 1", "`cache` takes true or false, not a number"),
            ("[assets]\nleast = -1", "`least` takes a number from 0 to 1000000"),
            (
                "[assets]\napi_key = \"sk\"",
                "`api_key` is not a setting: keys come from the environment, never from a file",
            ),
        ] {
            assert_eq!(read(text), Err(wanted.to_owned()), "{text}");
        }
        for key in ["generator = \"meshy\"", "url = \"https://a.example\"", "command = [\"sh\"]"] {
            let said = read(&format!("[assets]\n{key}")).unwrap_err();
            assert!(said.contains("is not a workspace setting"), "{said}");
        }
    }

    #[test]
    fn a_user_names_a_generator() {
        let text = "[assets]\ngenerator = \"command\"\ncommand = [\"python3\", \"/home/me/make.py\"]\ntimeout = 60";
        let assets = read_user(text, FileId(0)).unwrap().assets;
        assert_eq!(assets.command, ["python3", "/home/me/make.py"]);
        assert_eq!((assets.generator.as_deref(), assets.timeout), (Some("command"), Some(60.0)));
        assert!(read_user("[assets]\ncommand = \"sh\"", FileId(0)).is_err());
    }
}
