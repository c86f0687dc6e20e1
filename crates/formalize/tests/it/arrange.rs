//! Rooms stand apart, share walls where doors join them, and leave windows theirs.

use crate::support::{opening, room};
use scenelang_formalize::arrange::{arrange_rooms, is_arranged};
use scenelang_formalize::draft::{
    Draft,
    OpeningKind::{Door, Window},
};

fn draft(sizes: &[[f64; 2]], joins: &[(usize, usize)], windows: &[usize]) -> Draft {
    let mut draft = Draft::default();
    for (at, size) in sizes.iter().enumerate() {
        draft.rooms.push(room(&format!("r{at}"), *size));
    }
    for (at, (a, b)) in joins.iter().enumerate() {
        draft.openings.push(opening(&format!("door{at}"), Door, &[*a, *b]));
    }
    for (at, room) in windows.iter().enumerate() {
        draft.openings.push(opening(&format!("window{at}"), Window, &[*room]));
    }
    draft
}

#[test]
fn joined_rooms_share_walls() {
    type Case = (&'static [[f64; 2]], &'static [(usize, usize)]);
    let cases: &[Case] = &[
        (&[[4.0, 4.0]], &[]),
        (&[[4.0, 4.0], [3.0, 3.0]], &[]),
        (&[[4.0, 4.0], [3.0, 3.0]], &[(0, 1), (0, 1)]),
        (&[[4.0, 4.0], [3.0, 5.0], [2.5, 2.5]], &[(0, 1), (1, 2), (0, 2)]),
        (&[[8.0, 1.5], [3.0, 4.0], [3.0, 4.0], [3.0, 4.0], [3.0, 4.0]], &[(0, 1), (0, 2), (0, 3), (0, 4)]),
        (&[[5.0, 4.0], [4.0, 4.0], [3.5, 4.0], [2.0, 2.0], [6.0, 1.4]], &[(4, 0), (4, 1), (4, 2), (4, 3), (0, 1)]),
        (&[[3.6576, 3.048], [2.7432, 3.3528]], &[(0, 1)]),
    ];
    for (sizes, joins) in cases {
        let all: Vec<usize> = (0..sizes.len()).collect();
        let mut draft = draft(sizes, joins, &all);
        arrange_rooms(&mut draft);
        assert!(is_arranged(&draft), "{sizes:?} {joins:?}: {:?}", draft.rooms.iter().map(|r| r.at).collect::<Vec<_>>());
        assert!(draft.notes.is_empty(), "{:?}", draft.notes);
    }
}

#[test]
fn a_corridor_grows_and_a_sized_one_does_not() {
    let sizes: Vec<[f64; 2]> = [[3.0, 1.5]].into_iter().chain([[3.0, 3.0]; 9]).collect();
    let joins: Vec<(usize, usize)> = (1..10).map(|room| (0, room)).collect();
    let mut grown = draft(&sizes, &joins, &[]);
    grown.rooms[0].sized = false;
    arrange_rooms(&mut grown);
    assert!(is_arranged(&grown) && grown.notes.is_empty(), "{:?}", grown.notes);
    assert!(grown.rooms[0].size[0] > 3.0);

    let mut held = draft(&sizes, &joins, &[]);
    arrange_rooms(&mut held);
    assert_eq!(held.rooms[0].size[0], 3.0);
    assert!(!held.notes.is_empty(), "what cannot be is told");
    assert!(is_arranged(&held), "and every other door is met");
}

#[test]
fn an_outline_moves_along_and_many_rooms_stand_in_a_row() {
    let mut draft = draft(&[[4.0, 4.0], [4.0, 4.0]], &[(0, 1)], &[]);
    draft.rooms[1].outline = Some(vec![[10.0, 10.0], [14.0, 10.0], [14.0, 12.0], [12.0, 14.0], [10.0, 14.0]]);
    arrange_rooms(&mut draft);
    assert!(is_arranged(&draft));
    let xs: Vec<f64> = draft.rooms[1].outline.iter().flatten().map(|p| p[0]).collect();
    assert!(xs.iter().all(|x| x.abs() < 7.0), "{xs:?}");

    let mut row = self::draft(&[[3.0, 3.0]; 200], &[], &[]);
    arrange_rooms(&mut row);
    assert!(is_arranged(&row));
}

/// Many rooms with doors everywhere end in some plan, and what is not met is told.
#[test]
fn a_maze_ends() {
    let sizes: Vec<[f64; 2]> = (0..40).map(|n| [2.0 + f64::from(n % 5), 2.0 + f64::from(n % 3)]).collect();
    let joins: Vec<(usize, usize)> = (0..110).map(|n| (n * 7 % 40, n * 11 % 39)).collect();
    let mut draft = draft(&sizes, &joins, &(0..40).collect::<Vec<_>>());
    draft.rooms.iter_mut().for_each(|room| room.sized = false);
    arrange_rooms(&mut draft);
    assert!(is_arranged(&draft));
    assert!(!draft.notes.is_empty());
}
