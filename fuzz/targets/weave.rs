//! Files that are woven, in each format; the first byte says which.
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
    let Some((format, page)) = input.split_first() else { return };
    let family = Family::WEAVE[usize::from(*format) % Family::WEAVE.len()];
    if let Err(problem) = family.attack(page, &GIVEN) {
        panic!("{family:?}: {problem}");
    }
});
