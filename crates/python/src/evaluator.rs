//! Margins of a program in many environments at once.

use crate::errors::sentence;
use crate::poses::Convention;
use crate::program::{Held, Program};
use crate::work::away;
use pyo3::buffer::PyBuffer;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyByteArray;
use scenelang_base::FileId;
use scenelang_engine::Batch;
use scenelang_engine::limit::Stop;
use scenelang_lang::program::ObjectId;
use scenelang_layout::{Layout, file as layout_file};
use scenelang_verify::{Options, Truth};
use std::path::Path;
use std::sync::Arc;
use std::thread;

/// Fewer values than this are not worth a thread.
const FEW: usize = 4_096;

/// And no more threads than this are begun.
const MOST: usize = 256;

/// A program and a layout of it whose objects are elsewhere each time. Sizes, parts, rooms and values stay.
#[pyclass(frozen, module = "scenelang._native")]
pub struct Evaluator {
    held: Arc<Held>,
    layout: Layout,
    document: layout_file::Document,
    options: Options,
    /// The objects that poses are given for; the others stay where the layout has them.
    moved: Vec<ObjectId>,
}

/// What is wanted of a constraint.
#[derive(Clone, Copy)]
enum Wanted {
    /// Its margin; NaN where it cannot be judged, infinite for a fact without a measure.
    Margin,
    /// 1 where it holds, else 0.
    Verdict,
}

impl Wanted {
    fn of(self, truth: Option<Truth<f64>>) -> f64 {
        match (self, truth) {
            (Self::Margin, Some(truth)) => truth.margin,
            (Self::Margin, None) => f64::NAN,
            (Self::Verdict, truth) => f64::from(u8::from(truth.is_some_and(|truth| truth.holds))),
        }
    }
}

#[pymethods]
impl Evaluator {
    /// For a layout, given by its name and its text.
    #[new]
    fn new(
        py: Python<'_>,
        program: &Program,
        layout: (String, String),
        objects: Option<Vec<String>>,
    ) -> PyResult<Self> {
        let held = Arc::clone(&program.held);
        let (name, text) = layout;
        let checked = away(py, |_| held.judged((name.as_str(), text.as_str())))??;
        let Some(layout) = checked.layout else { return Err(sentence(format!("{name} cannot be checked"))) };
        let options = held.judging()?.options;
        let named = |name: &String| {
            let found = held.program().objects.iter().position(|object| object.name == *name);
            let no = || PyValueError::new_err(format!("the program has no object `{name}`"));
            found.map(|index| ObjectId(index as u32)).ok_or_else(no)
        };
        let moved = match objects {
            Some(names) => names.iter().map(named).collect::<PyResult<_>>()?,
            None => (0..held.program().objects.len() as u32).map(ObjectId).collect(),
        };
        let document = layout_file::read(&text, FileId(0)).document;
        Ok(Self { held, layout, document, options, moved })
    }

    /// The objects that poses are given for.
    #[getter]
    fn objects(&self) -> Vec<&str> {
        self.moved.iter().map(|id| self.name(*id)).collect()
    }

    /// Where the layout has them: objects times `width` doubles.
    fn poses<'py>(&self, py: Python<'py>, width: usize, order: &str, frame: &str) -> PyResult<Bound<'py, PyByteArray>> {
        let convention = Convention::new(width, order, frame)?;
        let mut out = Vec::new();
        for id in &self.moved {
            if let Some(placed) = self.layout.object(self.name(*id)) {
                convention.write(placed.pos, placed.rot, &mut out);
            }
        }
        bytes(py, &out)
    }

    /// Margins: environments times constraints doubles, for environments times objects times `width`.
    fn margins<'py>(
        &self,
        py: Python<'py>,
        poses: PyBuffer<f64>,
        width: usize,
        order: &str,
        frame: &str,
        threads: usize,
    ) -> PyResult<Bound<'py, PyByteArray>> {
        let poses = poses.to_vec(py)?;
        let out = self.judge(py, &poses, Convention::new(width, order, frame)?, threads, Wanted::Margin)?;
        bytes(py, &out)
    }

    /// Whether constraints hold: environments times constraints bytes, 1 or 0.
    fn holds<'py>(
        &self,
        py: Python<'py>,
        poses: PyBuffer<f64>,
        width: usize,
        order: &str,
        frame: &str,
        threads: usize,
    ) -> PyResult<Bound<'py, PyByteArray>> {
        let poses = poses.to_vec(py)?;
        let out = self.judge(py, &poses, Convention::new(width, order, frame)?, threads, Wanted::Verdict)?;
        Ok(PyByteArray::new(py, &out.into_iter().map(|v| u8::from(v == 1.0)).collect::<Vec<u8>>()))
    }

    /// The layout file of one environment.
    fn layout(&self, py: Python<'_>, poses: PyBuffer<f64>, width: usize, order: &str, frame: &str) -> PyResult<String> {
        let convention = Convention::new(width, order, frame)?;
        let poses = poses.to_vec(py)?;
        if poses.len() != self.moved.len() * width {
            return Err(PyValueError::new_err(format!(
                "expected the poses of one environment, found {} numbers",
                poses.len()
            )));
        }
        let mut layout = self.layout.clone();
        for (id, pose) in self.moved.iter().zip(poses.chunks(width)) {
            let name = self.name(*id);
            let Some((pos, rot)) = convention.read(pose) else {
                return Err(PyValueError::new_err(format!("the pose of `{name}` is not valid: {pose:?}")));
            };
            for (_, placed) in layout.objects.iter_mut().filter(|(other, _)| other == name) {
                (placed.pos, placed.rot) = (pos, rot);
            }
        }
        let text = layout_file::checked(Path::new(&self.held.name), &layout, Some(&self.document));
        text.map_err(|e| sentence(e.to_string()))
    }
}

impl Evaluator {
    fn name(&self, id: ObjectId) -> &str {
        &self.held.program().objects[id.0 as usize].name
    }

    /// A value for each constraint in each environment.
    fn judge(
        &self,
        py: Python<'_>,
        poses: &[f64],
        convention: Convention,
        threads: usize,
        wanted: Wanted,
    ) -> PyResult<Vec<f64>> {
        let each = self.moved.len() * convention.width;
        if each == 0 || !poses.len().is_multiple_of(each) {
            let (objects, width) = (self.moved.len(), convention.width);
            let said =
                format!("{} numbers do not form an array [environments, {objects} objects, {width}]", poses.len());
            return Err(PyValueError::new_err(said));
        }
        let (environments, columns) = (poses.len() / each, self.held.program().constraints.len());
        let mut out = vec![f64::NAN; environments * columns];
        if out.is_empty() {
            return Ok(out);
        }
        if out.len() < FEW {
            py.detach(|| self.run(poses, convention, wanted, &mut out, &Stop::default()));
            return Ok(out);
        }
        let threads =
            if threads == 0 { thread::available_parallelism().map_or(1, usize::from) } else { threads.min(MOST) };
        let share = environments.div_ceil(threads.min(environments));
        let poses = poses.chunks(share * each);
        let shares = poses.zip(out.chunks_mut(share * columns)).collect::<Vec<_>>();
        away(py, |stop| {
            thread::scope(|scope| {
                for (poses, out) in shares {
                    scope.spawn(move || self.run(poses, convention, wanted, out, stop));
                }
            });
        })?;
        Ok(out)
    }

    /// The environments of one thread, one after the other.
    fn run(&self, poses: &[f64], convention: Convention, wanted: Wanted, out: &mut [f64], stop: &Stop) {
        let program = self.held.program();
        let mut batch = Batch::new(program, &self.layout, &self.options);
        let (each, columns) = (self.moved.len() * convention.width, program.constraints.len());
        for (poses, out) in poses.chunks(each).zip(out.chunks_mut(columns)) {
            if stop.is_set() {
                return;
            }
            let placed: Option<Vec<_>> = poses.chunks(convention.width).map(|pose| convention.read(pose)).collect();
            let Some(placed) = placed else {
                // A simulation that has blown up is no layout, and no reason to lose the others.
                out.fill(wanted.of(None));
                continue;
            };
            for (id, (pos, rot)) in self.moved.iter().zip(placed) {
                batch.put(*id, pos, rot);
            }
            for (value, truth) in out.iter_mut().zip(batch.judge()) {
                *value = wanted.of(truth);
            }
        }
    }
}

/// Doubles as Python takes them.
fn bytes<'py>(py: Python<'py>, values: &[f64]) -> PyResult<Bound<'py, PyByteArray>> {
    PyByteArray::new_with(py, size_of_val(values), |out| {
        for (to, value) in out.chunks_exact_mut(size_of::<f64>()).zip(values) {
            to.copy_from_slice(&value.to_ne_bytes());
        }
        Ok(())
    })
}
