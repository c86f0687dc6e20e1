//! Which objects a name of the benchmark means, by the words of their names and categories and by the table.

use super::table::Table;
use std::collections::BTreeSet;

/// What an object is called and looks like, as the program says.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Looks {
    /// As in the layout: `lamp`, `chair[0]`.
    pub name: String,
    /// Its category or, where it has none, its name without an index.
    pub category: String,
    /// Its colours, or nothing.
    pub color: String,
    /// Its materials, or nothing.
    pub material: String,
    /// Its features, or nothing.
    pub features: String,
}

impl Looks {
    /// Whether a name of the benchmark means it, as a model says or else as words do. What stands behind a colon in the name does not count.
    pub fn is_called(&self, name: &str, table: &Table) -> bool {
        if let Some(is) = table.lookups().calls(name, &self.category) {
            return is;
        }
        let name = words(name.split(':').next().unwrap_or_default());
        let category = words(&self.category);
        let (Some(head), Some(noun)) = (name.last(), category.last()) else { return false };
        if name == category {
            return true;
        }
        let own = words(&self.name);
        // An index is no word of the name.
        let last = words(self.name.split('[').next().unwrap_or_default()).pop();
        let more: BTreeSet<&String> = category.iter().chain(&own).collect();
        let features = words(&self.features);
        let known = |word: &String| more.contains(word) || features.contains(word);
        if name.iter().all(known) && (head == noun || last.as_ref() == Some(head)) {
            return true;
        }
        if category.len() < name.len()
            && name.ends_with(&category)
            && !name[..name.len() - category.len()].iter().any(|word| table.has("kinds", word))
        {
            return true;
        }
        if name.len() == 1 && head == noun {
            return true;
        }
        let (name, category) = (name.join("_"), category.join("_"));
        let ends = |word: &String| category.strip_suffix(word.as_str()).is_some_and(|before| before.ends_with('_'));
        table.rows("synonyms").any(|row| row.contains(&name) && row.iter().any(|word| *word == category || ends(word)))
    }

    /// Whether each word of an attribute is part of what is said about it.
    pub fn carries(&self, attribute: &str) -> bool {
        let spelt = |word: String| word.replace("gray", "grey");
        let said = [&self.color, &self.material, &self.features, &self.category, &self.name];
        let said = said.map(String::as_str).join(" ");
        let said = spelt(words(&said).join(" "));
        words(attribute).into_iter().map(spelt).all(|word| said.contains(&word))
    }
}

/// The words of a name or phrase in order: lower case, singular; digits count as letters.
pub fn words(text: &str) -> Vec<String> {
    let mut out = Vec::new();
    let mut word = String::new();
    let mut before = ' ';
    for c in text.chars().chain([' ']) {
        let starts = c.is_ascii_uppercase() && before.is_ascii_lowercase();
        if (starts || !c.is_ascii_alphanumeric()) && !word.is_empty() {
            out.push(singular(&word));
            word.clear();
        }
        if c.is_ascii_alphanumeric() {
            word.push(c.to_ascii_lowercase());
        }
        before = c;
    }
    out
}

fn singular(word: &str) -> String {
    let cut = |n: usize, end: &str| word[..word.len() - n].to_owned() + end;
    if word.ends_with("ies") && word.len() > 4 {
        cut(3, "y")
    } else if ["ches", "shes", "sses", "xes", "zes"].iter().any(|end| word.ends_with(end)) {
        cut(2, "")
    } else if word.ends_with("ves") {
        cut(3, "f")
    } else if word.ends_with('s') && !["ss", "us", "is"].iter().any(|end| word.ends_with(end)) {
        cut(1, "")
    } else {
        word.to_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_of_names() {
        let cases = [
            ("coffeeTable[2]", "coffee table 2"),
            ("wall_shelves", "wall shelf"),
            ("Glasses of benches", "glass of bench"),
            ("TVs", "tv"),
            ("berries", "berry"),
            ("cactus", "cactus"),
        ];
        for (text, want) in cases {
            assert_eq!(words(text).join(" "), want, "{text}");
        }
    }

    #[test]
    fn who_is_called_what() {
        let table = Table::new();
        let looks = |category: &str, name: &str, features: &str| Looks {
            name: name.into(),
            category: category.into(),
            features: features.into(),
            ..Looks::default()
        };
        let yes = [
            ("coffee_table", looks("coffee table", "table1", "")),
            ("table", looks("coffee table", "x", "")),
            ("office_chair", looks("chair", "chair[1]", "")),
            ("couch", looks("sofa", "seat", "")),
            ("light", looks("floor lamp", "x", "")),
            ("bunk_bed", looks("bed", "bed", "bunk")),
            ("reading_lamp", looks("lamp", "readingLamp", "")),
            ("chair:0", looks("chair", "chair[0]", "")),
        ];
        for (name, looks) in yes {
            assert!(looks.is_called(name, &table), "{name} {looks:?}");
        }
        let no = [
            ("floor_lamp", looks("lamp", "lamp", "")),
            ("chair", looks("table", "table", "")),
            ("coffee_table", looks("table", "table", "")),
            ("", looks("table", "table", "")),
            ("table", looks("", "", "")),
        ];
        for (name, looks) in no {
            assert!(!looks.is_called(name, &table), "{name} {looks:?}");
        }
    }

    #[test]
    fn what_is_carried() {
        let desk = Looks { color: "dark gray".into(), material: "walnut".into(), ..Looks::default() };
        assert!(desk.carries("grey") && desk.carries("dark_grey") && desk.carries("walnut"));
        assert!(!desk.carries("light_grey") && !desk.carries("oak"));
    }
}
