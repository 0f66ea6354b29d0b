//! What people call the functions, in six languages: the list `names.txt`, read in any spelling.

use std::collections::HashMap;
use std::sync::{LazyLock, OnceLock};

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

/// A small letter without its accent; `None` for a combining accent, which belongs to the letter before it.
fn bare(c: char) -> Option<char> {
    Some(match c {
        'á' | 'à' | 'â' | 'ä' | 'ã' | 'å' => 'a',
        'é' | 'è' | 'ê' | 'ë' => 'e',
        'í' | 'ì' | 'î' | 'ï' => 'i',
        'ó' | 'ò' | 'ô' | 'ö' | 'õ' | 'œ' => 'o',
        'ú' | 'ù' | 'û' | 'ü' => 'u',
        'ç' => 'c',
        'ñ' => 'n',
        '’' => '\'',
        'ß' => 's',
        '\u{300}'..='\u{36f}' => return None,
        other => other,
    })
}

/// A word as it is compared: in small letters, without accents, ä as ae or a, and s for z.
pub(super) fn plain(word: &str) -> String {
    const LONG: usize = 6;
    let mut folded = String::with_capacity(word.len());
    for c in word.chars().flat_map(char::to_lowercase) {
        if c == 'ß' {
            folded.push('s');
        }
        match bare(c) {
            Some('e') if c == 'e' && folded.ends_with(['a', 'o', 'u']) => {}
            Some(base) => folded.push(base),
            None => {}
        }
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

/// The names with one initial, in each spelling only where a word with that initial asks for it: most lines need few of them.
#[derive(Default)]
struct Initial {
    names: Vec<Named>,
    exact: OnceLock<Names>,
    stems: OnceLock<Names>,
}

static INITIALS: LazyLock<HashMap<char, Initial>> = LazyLock::new(|| {
    let mut found: HashMap<char, Initial> = HashMap::new();
    for named in all().filter(|named| !named.name.starts_with(is_ideograph)) {
        if let Some(initial) = initial(named.name) {
            found.entry(initial).or_default().names.push(named);
        }
    }
    found
});

/// The other phrases with one initial, and these as they are written without their accents.
#[derive(Default)]
struct Others {
    phrases: Vec<(Phrase, &'static str)>,
    plain: OnceLock<Names>,
}

static OTHERS: LazyLock<HashMap<char, Others>> = LazyLock::new(|| {
    let mut found: HashMap<char, Others> = HashMap::new();
    for (phrase, name) in super::all() {
        if let Some(initial) = initial(name) {
            found.entry(initial).or_default().phrases.push((phrase, name));
        }
    }
    found
});

impl Others {
    fn plain(&self) -> &Names {
        const SHORTEST: usize = 4;
        self.plain.get_or_init(|| {
            let mut found = Names::new();
            for (phrase, name) in &self.phrases {
                for form in super::forms_of(name) {
                    let folded = each(&form, &plain);
                    if folded.chars().count() >= SHORTEST && folded != form {
                        found.entry(folded).or_insert(*phrase);
                    }
                }
            }
            found
        })
    }
}

/// The first letter as it is compared.
fn initial(words: &str) -> Option<char> {
    let first = words.trim_start_matches([' ', '-']).chars().next()?;
    first.to_lowercase().find_map(bare).map(|c| if c == 'z' { 's' } else { c })
}

impl Initial {
    fn of(words: &str) -> Option<&'static Initial> {
        INITIALS.get(&initial(words)?)
    }

    /// Maps names as `one` compares their words; the first function of a name has it.
    fn by(&self, one: &dyn Fn(&str) -> String) -> Names {
        let mut found = Names::new();
        for Named { function, name } in &self.names {
            found.entry(each(name, one)).or_insert(Phrase::Function(function));
        }
        found
    }

    fn exact(&self) -> &Names {
        self.exact.get_or_init(|| self.by(&plain))
    }

    fn stems(&self) -> &Names {
        self.stems.get_or_init(|| self.by(&stem))
    }
}

/// The function that words in small letters are the name of.
pub(super) fn named(words: &str) -> Option<Phrase> {
    Initial::of(words)?.exact().get(&each(words, &plain)).copied()
}

/// Whether some name begins with a word, so that more of it may follow.
pub(super) fn begins(word: &str) -> bool {
    let word = plain(word);
    let first = |name: &str| name.split([' ', '-']).next().is_some_and(|first| plain(first) == word);
    Initial::of(&word).is_some_and(|own| own.names.iter().any(|named| first(named.name)))
}

/// The phrase that words in small letters are, in another spelling than that of the lists.
pub(super) fn spelled(words: &str) -> Option<Phrase> {
    const SHORTEST: usize = 3;
    if words.len() < SHORTEST {
        return None;
    }
    let first = initial(words)?;
    let other = OTHERS.get(&first).and_then(|own| own.plain().get(&each(words, &plain)));
    let named = || INITIALS.get(&first)?.stems().get(&each(words, &stem));
    other.or_else(named).copied().or_else(|| doing(words))
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
