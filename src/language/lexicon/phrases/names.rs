//! What people call the functions, in six languages: the list `names.txt`, read in any spelling.

use std::collections::{HashMap, HashSet};
use std::sync::LazyLock;

use super::super::letters::is_ideograph;
use super::Phrase;

/// The list: a line for each function, its languages between semicolons.
const LIST: &str = include_str!("names.txt");

/// The names of a function in a language.
pub(super) struct Named {
    pub(super) function: &'static str,
    pub(super) name: &'static str,
}

/// The lines of the list: a function and what stands behind it.
pub(crate) fn lines() -> impl Iterator<Item = (&'static str, &'static str)> {
    let lines = LIST.lines().filter(|line| !line.starts_with('#'));
    lines.filter_map(|line| line.split_once(": "))
}

/// All names of functions.
pub(super) fn all() -> impl Iterator<Item = Named> {
    let called = lines().filter(|(_, names)| !names.starts_with('-'));
    called.flat_map(|(function, names)| {
        names.split(['|', ';']).map(move |name| Named { function, name: name.trim() })
    })
}

/// A word as it is compared: in small letters, without accents, ä as ae or a, and s for z.
pub(super) fn plain(word: &str) -> String {
    const LONG: usize = 6;
    let mut folded = String::with_capacity(word.len());
    for c in word.chars().flat_map(char::to_lowercase) {
        let base = match c {
            'á' | 'à' | 'â' | 'ä' | 'ã' | 'å' => 'a',
            'é' | 'è' | 'ê' | 'ë' => 'e',
            'í' | 'ì' | 'î' | 'ï' => 'i',
            'ó' | 'ò' | 'ô' | 'ö' | 'õ' => 'o',
            'ú' | 'ù' | 'û' | 'ü' => 'u',
            'ç' => 'c',
            'ñ' => 'n',
            '’' => '\'',
            'ß' => {
                folded.push('s');
                's'
            }
            'œ' => 'o',
            // A combining accent belongs to the letter before it.
            '\u{300}'..='\u{36f}' => continue,
            'e' if folded.ends_with(['a', 'o', 'u']) => continue,
            other => other,
        };
        folded.push(base);
    }
    if folded.chars().count() >= LONG { folded.replace('z', "s") } else { folded }
}

/// A word without the endings that it has in the plural or where it is declined.
fn stem(word: &str) -> String {
    const SHORTEST: usize = 5;
    let mut word = plain(word);
    loop {
        let endings = super::ENDINGS.iter().filter(|ending| !ending.is_empty());
        let rest = endings.filter_map(|ending| word.strip_suffix(ending));
        let rest = rest.filter(|rest| rest.chars().count() >= SHORTEST).min_by_key(|rest| rest.len());
        match rest.map(str::to_owned) {
            Some(shorter) => word = shorter,
            None => return word,
        }
    }
}

/// Words side by side, each by `one`.
fn each(words: &str, one: &dyn Fn(&str) -> String) -> String {
    let mut all = String::with_capacity(words.len());
    for word in words.split([' ', '-']).filter(|word| !word.is_empty()) {
        if !all.is_empty() {
            all.push(' ');
        }
        all.push_str(&one(word));
    }
    all
}

type Names = HashMap<String, Phrase>;

/// Maps names as `one` compares their words; the first function of a name has it.
fn by(one: &dyn Fn(&str) -> String) -> Names {
    let mut found = Names::new();
    for Named { function, name } in all().filter(|named| !named.name.starts_with(is_ideograph)) {
        found.entry(each(name, one)).or_insert(Phrase::Function(function));
    }
    found
}

static EXACT: LazyLock<Names> = LazyLock::new(|| by(&plain));

static STEMS: LazyLock<Names> = LazyLock::new(|| by(&stem));

/// Other phrases as they are written without their accents.
static PLAIN: LazyLock<Names> = LazyLock::new(|| {
    const SHORTEST: usize = 4;
    let mut found = Names::new();
    for (phrase, name) in super::all() {
        for form in super::forms_of(name) {
            let folded = each(&form, &plain);
            if folded.chars().count() >= SHORTEST && folded != form {
                found.entry(folded).or_insert(phrase);
            }
        }
    }
    found
});

/// The function that words in small letters are the name of.
pub(super) fn named(words: &str) -> Option<Phrase> {
    EXACT.get(&each(words, &plain)).copied()
}

/// Whether some name begins with a word, so that more of it may follow.
pub(super) fn begins(word: &str) -> bool {
    static STARTS: LazyLock<HashSet<String>> = LazyLock::new(|| {
        let first = |name: &String| name.split(' ').next().unwrap_or_default().to_owned();
        EXACT.keys().map(first).collect()
    });
    STARTS.contains(&plain(word))
}

/// The phrase that words in small letters are, in another spelling than that of the lists.
pub(super) fn spelled(words: &str) -> Option<Phrase> {
    const SHORTEST: usize = 3;
    if words.len() < SHORTEST {
        return None;
    }
    let found = PLAIN.get(&each(words, &plain)).or_else(|| STEMS.get(&each(words, &stem)));
    found.copied().or_else(|| doing(words))
}

/// A command in another form of its verb: splitting, elevated.
fn doing(words: &str) -> Option<Phrase> {
    let (verb, rest) = words.split_once(' ').map_or((words, ""), |(verb, rest)| (verb, rest));
    let stem = verb.strip_suffix("ing").or_else(|| verb.strip_suffix("ed"))?;
    let last = stem.chars().next_back().filter(|last| stem.ends_with(&format!("{last}{last}")));
    let undoubled = last.and_then(|last| stem.strip_suffix(last));
    let forms = [Some(stem.to_owned()), Some(format!("{stem}e")), undoubled.map(str::to_owned)];
    forms.into_iter().flatten().filter(|form| form.len() > 2).find_map(|form| {
        let whole = if rest.is_empty() { form } else { format!("{form} {rest}") };
        match super::listed(&whole)? {
            command @ Phrase::Command(_) => Some(command),
            _ => None,
        }
    })
}

#[cfg(test)]
mod tests {
    use super::{all, each, plain};
    use std::collections::BTreeMap;

    #[test]
    fn no_name_belongs_to_two_functions() {
        let mut seen: BTreeMap<String, &str> = BTreeMap::new();
        for named in all() {
            let name = each(named.name, &plain);
            let first = *seen.entry(name.clone()).or_insert(named.function);
            assert_eq!(first, named.function, "{name}");
        }
    }
}
