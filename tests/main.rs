//! All integration tests, in one program, so that they are linked once.
//! `cargo test --test main weave::` runs one file.

mod common;

mod architecture;
mod bad_input;
mod bench_inputs;
mod cli;
mod curves;
mod derivation_words;
mod derivations;
mod differential;
mod docs;
mod figure_commands;
mod figures;
mod fronts;
mod function_names;
mod functions;
mod fuzz;
mod habits;
mod interpolation;
mod katex;
mod language;
mod lecture_notes;
mod lsp;
mod mathematics;
mod notes;
mod notes_commands;
mod notes_corpus;
mod notes_repairs;
mod one_verdict;
mod roundtrip;
mod small_pages;
mod weave;
mod worked_examples;
