//! The catalogue against folders of models that the tests write themselves.

mod checking;
mod hostile;
mod made;
mod reading;
mod searching;
