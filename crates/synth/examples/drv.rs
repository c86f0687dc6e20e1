//! drv [-s SEEDS] [-t SECS] [-o DIR] FILES: solves, prints solved, work, seconds.
use scenelang_lang::compile_file;
use scenelang_solve::{Options, Placed, Problem};
use std::ops::ControlFlow;
use std::time::{Duration, Instant};
fn main() {
    let mut args: Vec<String> = std::env::args().skip(1).collect();
    let mut take = |f: &str| args.iter().position(|a| a == f).map(|i| { args.remove(i); args.remove(i) });
    let seeds: u64 = take("-s").map_or(1, |s| s.parse().unwrap());
    let first: u64 = take("-f").map_or(0, |s| s.parse().unwrap());
    let time: Option<f64> = take("-t").map(|s| s.parse().unwrap());
    let out = take("-o");
    let quiet = take("-q").is_some();
    let (mut runs, mut solved, mut times) = (0, 0, vec![]);
    for file in &args {
        let path = std::path::Path::new(file);
        let compiled = compile_file(file, path, Default::default());
        let Some(program) = &compiled.program else { println!("{file}: does not compile {:?}", compiled.diagnostics.first().map(|d| &d.message)); continue };
        for seed in first..first + seeds {
            let judge = scenelang_verify::Options::default();
            let f = scenelang_synth::furnish(program, scenelang_solve::draws(program, seed), None, &judge);
            let problem = Problem { program, start: f.layout, placed: Placed::None };
            let options = Options { seed, time: time.map(Duration::from_secs_f64), diagnose: false, ..Options::default() };
            let begun = Instant::now();
            let o = scenelang_solve::solve(&problem, &options, &mut |_| ControlFlow::Continue(()));
            let secs = begun.elapsed().as_secs_f64();
            runs += 1; solved += o.converged as usize; times.push(secs);
            let name = path.file_stem().unwrap().to_string_lossy();
            let why: Vec<String> = o.unsatisfied.iter().take(3).map(|u| format!("{:?}", u.what)).collect();
            if !quiet || !o.converged { println!("{name:34} s{seed} {} {:>10} units {:7.3} s  {} {}", if o.converged {"ok "} else {"NOT"}, o.work, secs, why.join("; "), o.warnings.join("; ")); }
            if let Some(out) = &out {
                let mut l = o.layout.clone(); l.scene = Some(std::path::absolute(path).unwrap().to_string_lossy().into_owned());
                std::fs::create_dir_all(out).unwrap();
                std::fs::write(format!("{out}/{name}.s{seed}.layout.json"), scenelang_layout::file::to_json(&l, None)).unwrap();
            }
        }
    }
    times.sort_by(f64::total_cmp);
    let at = |p: f64| times[((times.len() as f64 * p).ceil() as usize).clamp(1, times.len()) - 1];
    if !times.is_empty() { println!("{solved}/{runs} median {:.3} p90 {:.3} p99 {:.3} max {:.3} sum {:.1}", at(0.5), at(0.9), at(0.99), at(1.0), times.iter().sum::<f64>()); }
}
