//! Requests that are conversations: "User: … Assistant: … User: …". What the other side says asks for nothing.

use super::token::{Kind, Token};
use crate::brief::Note;

/// Who asks.
const ASKS: [&str; 7] = ["user", "human", "customer", "client", "me", "guest", "requester"];
/// Who answers.
const ANSWERS: [&str; 9] = ["assistant", "ai", "bot", "system", "agent", "designer", "chatbot", "architect", "planner"];

/// Takes the names of who speaks out of a conversation, and what is said by those who answer; notes on the latter.
pub fn turns(tokens: &mut Vec<Token>) -> Vec<Note> {
    let label = |i: usize| {
        let fresh = match i.checked_sub(1).map(|k| tokens[k].kind) {
            None | Some(Kind::Line | Kind::Bullet | Kind::Sign('.' | '!' | '?' | ';' | '"' | '…')) => true,
            Some(_) => false,
        };
        let colon = tokens.get(i + 1).is_some_and(|t| t.is(":"));
        let name = tokens[i].text.as_str();
        (fresh && colon && tokens[i].word() && (ASKS.contains(&name) || ANSWERS.contains(&name)))
            .then(|| ANSWERS.contains(&name))
    };
    let labels: Vec<(usize, bool)> = (0..tokens.len()).filter_map(|i| label(i).map(|answers| (i, answers))).collect();
    // "Client: a bank" alone is a heading; a conversation begins with a name, and another follows.
    let asked = labels.iter().any(|(_, answers)| !answers);
    if labels.len() < 2 || !asked {
        return Vec::new();
    }
    let mut notes = Vec::new();
    let mut kept = tokens[..labels[0].0].to_vec();
    for (n, &(at, answers)) in labels.iter().enumerate() {
        let end = labels.get(n + 1).map_or(tokens.len(), |next| next.0);
        let mut line = tokens[at].clone();
        (line.kind, line.text) = (Kind::Line, "\n".to_owned());
        kept.push(line);
        let said = &tokens[at + 2..end];
        match (answers, said.first(), said.last()) {
            (true, Some(first), Some(last)) => notes.push(Note {
                at: first.at.start..last.at.end,
                reason: "this is an answer in a conversation, and asks for nothing".to_owned(),
            }),
            _ => kept.extend_from_slice(said),
        }
    }
    *tokens = kept;
    notes
}

#[cfg(test)]
mod tests {
    use super::super::token::tokens;
    use super::*;

    #[test]
    fn only_who_asks_is_read() {
        for (text, left, notes) in [
            ("User: a bed. Assistant: Sure, a lamp? User: No.", "a bed . no .", 1),
            ("Client: a bank\nRoom: a hall", "client : a bank room : a hall", 0),
            ("A desk. Assistant: fine.", "a desk . assistant : fine .", 0),
            ("User: a bed.\nUser: a desk.", "a bed . a desk .", 0),
        ] {
            let mut tokens = tokens(text, 100).0;
            assert_eq!(turns(&mut tokens).len(), notes, "{text}");
            let words: Vec<&str> = tokens.iter().filter(|t| t.kind != Kind::Line).map(|t| t.text.as_str()).collect();
            assert_eq!(words.join(" "), left, "{text}");
        }
    }
}
