//! Statements of the language, in plain notation and LaTeX.
#![no_main]

#[path = "../../tests/common/attack.rs"]
#[allow(dead_code, reason = "a target is one family")]
mod attack;

use std::sync::LazyLock;

use attack::{Family, given};
use libfuzzer_sys::fuzz_target;
use polarform::session::Session;

static GIVEN: LazyLock<Session> = LazyLock::new(given);

fuzz_target!(|input: &[u8]| {
    if let Err(problem) = Family::Language.attack(input, &GIVEN) {
        panic!("{problem}");
    }
});
