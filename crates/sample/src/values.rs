//! What draws gave to samples: how often each argument of `oneOf` was chosen, and how the numbers of each `rand` are spread.

use crate::coverage::rounded;
use scenelang_lang::Program;
use scenelang_lang::program::{Draw, Node};
use serde_json::{Value, json};

/// What a draw gave the samples that are stored.
#[derive(Clone, Debug)]
pub(crate) enum Values {
    /// By argument of `oneOf`: what it is, and how many samples have it, and for how many with it there is no layout.
    Choice(Vec<(String, [u64; 2])>),
    /// Of `rand`: how many, their mean, the sum of squared differences from it, the least and the greatest.
    Numbers { count: u64, mean: f64, squares: f64, range: [f64; 2] },
}

impl Values {
    /// Of each draw of a program, by its key: nothing yet.
    pub fn all(program: &Program) -> Vec<(String, Self)> {
        let of = |(index, draw): (usize, &Draw)| {
            let values = match draw.is_choice {
                true => Self::Choice(arguments(program, index).into_iter().map(|name| (name, [0; 2])).collect()),
                false => Self::Numbers { count: 0, mean: 0.0, squares: 0.0, range: [f64::INFINITY, f64::NEG_INFINITY] },
            };
            (draw.key.clone(), values)
        };
        program.draws.iter().enumerate().map(of).collect()
    }

    /// Counts a value. `stored`: the sample has a layout.
    pub fn add(&mut self, value: f64, stored: bool) {
        match self {
            Self::Choice(names) => {
                if let Some((_, counts)) = names.get_mut(value as usize) {
                    counts[usize::from(!stored)] += 1;
                }
            }
            Self::Numbers { count, mean, squares, range } if stored => {
                *count += 1;
                let off = value - *mean;
                *mean += off / *count as f64;
                *squares += off * (value - *mean);
                *range = [range[0].min(value), range[1].max(value)];
            }
            Self::Numbers { .. } => {}
        }
    }

    pub fn json(&self, key: &str) -> Value {
        match self {
            Self::Choice(names) => json!({
                "key": key,
                "choices": names
                    .iter()
                    .map(|(name, [stored, none])| json!({ "value": name, "stored": stored, "noLayout": none }))
                    .collect::<Vec<_>>(),
            }),
            Self::Numbers { count: 0, .. } => json!({ "key": key }),
            Self::Numbers { count, mean, squares, range } => json!({
                "key": key,
                "mean": rounded(*mean),
                "deviation": rounded((squares / (count.max(&2) - 1) as f64).sqrt()),
                "least": rounded(range[0]),
                "greatest": rounded(range[1]),
            }),
        }
    }

    /// For people.
    pub fn text(&self) -> String {
        match self {
            Self::Choice(names) => {
                let each = names.iter().map(|(name, [stored, none])| match none {
                    0 => format!("{name} {stored}"),
                    _ => format!("{name} {stored} (without a layout: {none})"),
                });
                each.collect::<Vec<_>>().join(", ")
            }
            Self::Numbers { count: 0, .. } => "none stored".to_owned(),
            Self::Numbers { mean, range, .. } => {
                format!("{:.3} to {:.3}, {mean:.3} on average", range[0], range[1])
            }
        }
    }
}

/// What a `oneOf` chooses from: the texts, or else the numbers of its arguments.
fn arguments(program: &Program, draw: usize) -> Vec<String> {
    if let Some(drawn) = program.drawn_texts.iter().find(|drawn| drawn.draw.0 as usize == draw) {
        return drawn.texts.clone();
    }
    let last = match program.draws[draw].hi.root_node() {
        Node::Number(last) => *last as usize,
        _ => 0,
    };
    (0..=last).map(|argument| format!("argument {}", argument + 1)).collect()
}
