//! Requests that are conversations: "User: … Assistant: … User: …". What the other side says asks for nothing, unless it
//! proposes something and the answer is "yes".

use super::token::{Kind, Token};
use crate::brief::Note;

/// Who asks.
const ASKS: [&str; 7] = ["user", "human", "customer", "client", "me", "guest", "requester"];
/// Who answers.
const ANSWERS: [&str; 9] = ["assistant", "ai", "bot", "system", "agent", "designer", "chatbot", "architect", "planner"];

/// What an answer begins with that takes up a proposal.
const YES: [&str; 11] =
    ["yes", "yeah", "yep", "yup", "sure", "ok", "okay", "absolutely", "definitely", "certainly", "please"];
/// How a proposal begins, before what is proposed.
const PROPOSES: [&[&str]; 20] = [
    &["would", "you", "like", "me", "to"],
    &["do", "you", "want", "me", "to"],
    &["would", "you", "like", "to"],
    &["do", "you", "want", "to"],
    &["want", "me", "to"],
    &["would", "you", "like"],
    &["would", "you", "want"],
    &["do", "you", "want"],
    &["do", "you", "need"],
    &["shall", "i", "also"],
    &["should", "i", "also"],
    &["shall", "i"],
    &["should", "i"],
    &["shall", "we"],
    &["should", "we"],
    &["may", "i"],
    &["can", "i"],
    &["could", "i"],
    &["how", "about"],
    &["what", "about"],
];

/// What is proposed in the last question of an answer; nothing if it leaves a choice.
fn proposal(said: &[Token]) -> Option<(usize, &[Token])> {
    let end = said.len().checked_sub(1).filter(|k| said[*k].is("?"))?;
    let ends = |t: &Token| matches!(t.kind, Kind::Line | Kind::Sign('.' | '!' | '?' | ';'));
    let from = said[..end].iter().rposition(ends).map_or(0, |k| k + 1);
    let question = &said[from..end];
    // "Great. Then shall I …", "Sure, what about …"
    let lead = (0..question.len().min(4)).find_map(|skip| {
        let rest = &question[skip..];
        let starts = |words: &&&[&str]| rest.len() > words.len() && words.iter().zip(rest).all(|(w, t)| t.is(w));
        PROPOSES.iter().find(starts).map(|words| skip + words.len())
    });
    let lead = lead?;
    let choice = question.iter().any(|t| t.is("or") || t.is("either"));
    (!choice).then_some((from, &question[lead..]))
}

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
        // "Yes, please, and …": the rest of the answer is read.
        let yes =
            if answers { 0 } else { said.iter().take_while(|t| YES.contains(&t.text.as_str()) || t.is(",")).count() };
        let taken = labels.get(n + 1).is_some_and(|(next, answers)| {
            !answers && tokens.get(next + 2).is_some_and(|t| YES.contains(&t.text.as_str()))
        });
        let proposed = proposal(said).filter(|_| answers && taken);
        let (Some(first), Some(last)) = (said.first(), said.last()) else { continue };
        if !answers {
            let begins = if n > 0 && labels[n - 1].1 { yes } else { 0 };
            kept.extend_from_slice(&said[begins..]);
            continue;
        }
        let mut at = first.at.start..last.at.end;
        let mut reason = "this is an answer in a conversation, and asks for nothing";
        if let Some((from, asked)) = proposed {
            kept.extend_from_slice(asked);
            kept.push(Token { kind: Kind::Sign('.'), text: ".".to_owned(), ..last.clone() });
            let Some(before) = from.checked_sub(1) else { continue };
            at = first.at.start..said[before].at.end;
        } else if taken {
            reason = "what is agreed to here is not clear";
        }
        notes.push(Note { at, reason: reason.to_owned() });
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
            ("User: a bed. Assistant: Shall I add a lamp? User: Yes.", "a bed . add a lamp . .", 0),
            ("User: a bed. AI: Nice. How about a rug? User: Sure, a red one.", "a bed . a rug . a red one .", 1),
            ("User: a bed. AI: A rug or a mat? User: Yes.", "a bed . .", 1),
            ("User: a bed. AI: Shall I add a lamp? User: No.", "a bed . no .", 1),
        ] {
            let mut tokens = tokens(text, 100).0;
            assert_eq!(turns(&mut tokens).len(), notes, "{text}");
            let words: Vec<&str> = tokens.iter().filter(|t| t.kind != Kind::Line).map(|t| t.text.as_str()).collect();
            assert_eq!(words.join(" "), left, "{text}");
        }
    }
}
