//! Phrases by their first letter: most of a table says nothing of the place where a text is read.

use std::collections::HashMap;

/// Entries of a table, by the first letter of their phrases, in the order of the table.
pub(super) struct Starts<T>(HashMap<char, Vec<T>>);

impl<T> Starts<T> {
    /// The entries with their phrases, of which none is empty.
    pub(super) fn of<'a>(entries: impl Iterator<Item = (&'a str, T)>) -> Self {
        let mut found: HashMap<char, Vec<T>> = HashMap::new();
        for (phrase, entry) in entries {
            found.entry(first(phrase)).or_default().push(entry);
        }
        Starts(found)
    }

    /// Those whose phrases may stand at the start of a text in small letters.
    pub(super) fn at(&self, text: &str) -> &[T] {
        self.0.get(&first(text)).map_or(&[], Vec::as_slice)
    }
}

fn first(text: &str) -> char {
    text.chars().next().map_or(' ', without_accent)
}

/// Accents are often left out in French.
pub(super) fn without_accent(c: char) -> char {
    match c {
        'é' | 'è' | 'ê' => 'e',
        'á' | 'à' => 'a',
        c => c,
    }
}
