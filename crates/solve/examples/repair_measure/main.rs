//! Measures repairing: solved scenes are damaged, by turns an object displaced and a bound tightened, and repaired.
//!
//! `repair_measure FOLDER [N]` takes N scenes (200) of those that `tests/problems/generate.py -o FOLDER` wrote. Beside each
//! that is not repaired it says whether the solver finds a layout at all. At the end a table compares the moves that
//! `check` offers with those of `repair`.

mod compare;
mod damage;

use compare::{Agreement, Compared, compare, table};

use damage::{Damage, damaged, scenes};
use scenelang_solve::repair::{Damaged, How, RepairOptions, Which, repair};
use scenelang_solve::{Options, Placed, Problem, solve};
use std::ops::ControlFlow;
use std::path::Path;
use std::time::Instant;

fn main() {
    let mut args = std::env::args().skip(1);
    let Some(folder) = args.next() else { return eprintln!("repair_measure FOLDER [N]") };
    let most: usize = args.next().and_then(|n| n.parse().ok()).unwrap_or(200);
    let files = scenes(Path::new(&folder));
    let step = (files.len() / most.max(1)).max(1);
    let (mut times, mut moved, mut unsolvable) = (Vec::new(), Vec::new(), 0);
    let (mut layouts, mut rows): (Vec<Compared>, Vec<Compared>) = (Vec::new(), Vec::new());
    for (i, scene) in files.iter().step_by(step).take(most).enumerate() {
        let name = scene.file_stem().map(|s| s.to_string_lossy().into_owned()).unwrap_or_default();
        let damage = if i % 2 == 0 { Damage::Displaced } else { Damage::Tightened };
        let Some(damaged) = damaged(scene, damage, i as u64) else {
            println!("{name:36} cannot be damaged so");
            continue;
        };
        let (program, layout) = (&damaged.program, &damaged.layout);
        let since = Instant::now();
        let found = repair(&Damaged { program, layout, text: None }, &Which::All, &RepairOptions::default());
        let took = since.elapsed().as_secs_f64() * 1e3;
        let Ok(found) = found else { continue };
        let best = found.alternatives.iter().find(|a| a.how == How::Moves);
        let (n, cost) = (best.map(|b| b.moves.len()), best.map_or(0.0, |b| b.cost));
        println!("{name:36} {:32} moved {n:?} cost {cost:5.2} {took:8.1} ms", damaged.what);
        if let Some(compared) = compare(program, layout) {
            let differs = |c: &Compared| c.breaks > 0 || !matches!(c.agreement, Agreement::Same | Agreement::Neither);
            for c in std::iter::once(&compared.layout).chain(&compared.rows).filter(|c| differs(c)) {
                println!("{:36} {:?}, check breaks {}, repair {}", "", c.agreement, c.breaks, c.repair_breaks);
            }
            layouts.push(compared.layout);
            rows.extend(compared.rows);
        }
        match n {
            Some(n) => {
                moved.push(n);
                times.push(took);
            }
            None => {
                let problem = Problem { program, start: layout.clone(), placed: Placed::None };
                let outcome = solve(&problem, &Options::default(), &mut |_| ControlFlow::Continue(()));
                println!("{:36} a full solve: {}", "", outcome.converged);
                if outcome.converged {
                    times.push(took);
                } else {
                    unsolvable += 1;
                }
            }
        }
    }
    times.sort_by(f64::total_cmp);
    moved.sort_unstable();
    println!("repaired {} of {} ({unsolvable} more cannot be solved)", moved.len(), times.len());
    let at = |n: usize, p: usize| (n * p / 100).min(n.saturating_sub(1));
    for p in [50, 90, 99, 100] {
        let (objects, ms) = (moved.get(at(moved.len(), p)), times.get(at(times.len(), p)));
        println!("{p:3} %: {} objects, {:.1} ms", objects.unwrap_or(&0), ms.unwrap_or(&0.0));
    }
    print!("{}", table(&layouts, &rows));
}
