//! Inputs made of others by cutting, splicing, repeating and inserting tokens, the same on each run.

use std::fs;
use std::path::Path;

/// Knuth's 64-bit linear congruential generator.
pub struct Random(pub u64);

impl Random {
    pub fn below(&mut self, bound: usize) -> usize {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 33) as usize % bound.max(1)
    }

    pub fn pick<'a, T>(&mut self, list: &'a [T]) -> &'a T {
        &list[self.below(list.len())]
    }
}

/// The tokens in files of `tests/corpus/fuzz`, which the targets guided by coverage use, too: one a line, as a
/// string of Rust without its quotation marks.
pub fn tokens(names: &[&str]) -> Vec<String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/corpus/fuzz");
    let mut all = Vec::new();
    for name in names {
        let text = fs::read_to_string(folder.join(name)).expect("the tokens are there");
        for line in text.lines().filter(|line| line.starts_with('"')) {
            all.push(serde_json::from_str(line).expect("a token is a string of JSON"));
        }
    }
    all
}

/// A place on a character boundary.
fn place(random: &mut Random, input: &str) -> usize {
    floor(input, random.below(input.len() + 1))
}

/// The nearest character boundary at or before a byte.
fn floor(input: &str, mut at: usize) -> usize {
    while !input.is_char_boundary(at) {
        at -= 1;
    }
    at
}

/// A change of a seed, of `longest` bytes at most or so.
pub fn mutated(random: &mut Random, seeds: &[String], tokens: &[String], longest: usize) -> String {
    let mut input = random.pick(seeds).clone();
    for _ in 0..=random.below(5) {
        let (a, b) = (place(random, &input), place(random, &input));
        let (from, to) = (a.min(b), a.max(b));
        match random.below(7) {
            0 => input.replace_range(from..to, ""),
            1 => input.insert_str(a, random.pick(tokens).as_str()),
            2 => {
                let other = random.pick(seeds);
                let cut = place(random, other);
                input.insert_str(a, &other[cut..]);
            }
            3 => {
                let piece = input[from..to].to_owned();
                input.insert_str(b, &piece);
            }
            4 => input.replace_range(from..to, random.pick(tokens).as_str()),
            5 => {
                let token = random.pick(tokens).repeat(1 + random.below(40));
                input.insert_str(a, &token);
            }
            _ => {
                let odd = char::from_u32(random.below(0x2fff) as u32).unwrap_or('?');
                input.insert(a, odd);
            }
        }
        if input.len() > longest {
            let cut = place(random, &input[..floor(&input, longest / 2)]);
            input.truncate(cut);
        }
    }
    input
}
