//! Words of claims about the sign or the shape of a function on a region: `prove F >= 0 on [0, 1]`, `t^3 is increasing on [0, 2]`.

/// Words before what is to be shown, beside those of sentences.
const TASKS: &[&str] = &[
    "prove that",
    "prove",
    "show that",
    "show",
    "verify that",
    "verify",
    "certify",
    "beweise",
    "zeige",
    "démontrer",
    "is",
];

/// Words between a claim and its region.
const PLACES: &[&str] = &[" on ", " over ", " auf ", " sur "];

/// Words before a region.
const REGIONS: &[&str] = &[
    "the interval ",
    "the box ",
    "the square ",
    "the cube ",
    "the rectangle ",
    "the triangle ",
    "the tetrahedron ",
    "triangle ",
    "tetrahedron ",
    "interval ",
    "box ",
    "dem intervall ",
    "dem dreieck ",
];

/// What is claimed of a function: a sign of a derivative.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Shape {
    /// The order of the derivative.
    pub order: usize,
    /// Whether it is not positive, in place of not negative.
    pub turned: bool,
    /// Whether it is not 0 either.
    pub strict: bool,
}

const fn shape(order: usize, turned: bool) -> Shape {
    Shape { order, turned, strict: false }
}

const SHAPES: &[(&str, Shape)] = &[
    ("positive", Shape { strict: true, ..shape(0, false) }),
    ("positiv", Shape { strict: true, ..shape(0, false) }),
    ("negative", Shape { strict: true, ..shape(0, true) }),
    ("negativ", Shape { strict: true, ..shape(0, true) }),
    ("nonnegative", shape(0, false)),
    ("not negative", shape(0, false)),
    ("nonpositive", shape(0, true)),
    ("not positive", shape(0, true)),
    ("monotonically increasing", shape(1, false)),
    ("monotone increasing", shape(1, false)),
    ("increasing", shape(1, false)),
    ("nondecreasing", shape(1, false)),
    ("monotonically decreasing", shape(1, true)),
    ("monotone decreasing", shape(1, true)),
    ("decreasing", shape(1, true)),
    ("nonincreasing", shape(1, true)),
    ("convex", shape(2, false)),
    ("concave", shape(2, true)),
    ("nicht negativ", shape(0, false)),
    ("monoton wachsend", shape(1, false)),
    ("monoton fallend", shape(1, true)),
    ("konvex", shape(2, false)),
    ("konkav", shape(2, true)),
    ("croissante", shape(1, false)),
    ("décroissante", shape(1, true)),
    ("convexe", shape(2, false)),
];

/// A claim taken apart; places are bytes of the text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct SignClaim {
    /// Whether a word asks for a proof.
    pub asked: bool,
    /// The function or inequality.
    pub claim: (usize, usize),
    /// What is said of the function; `None` for an inequality.
    pub shape: Option<Shape>,
    /// The region.
    pub region: Option<(usize, usize)>,
}

/// A text as a claim about signs; whether its parts are formulas is not asked.
pub(crate) fn sign_claim(text: &str) -> Option<SignClaim> {
    let lower = text.to_ascii_lowercase();
    let end = text.trim_end_matches(|c: char| c.is_whitespace() || matches!(c, '?' | '.')).len();
    let start = text.len() - text.trim_start().len();
    let task = TASKS.iter().filter(|task| {
        let rest = lower.get(start..).and_then(|rest| rest.strip_prefix(**task));
        rest.is_some_and(|rest| rest.starts_with(' '))
    });
    let length = task.map(|task| task.len()).max();
    let begin = start + length.map_or(0, |length| length + 1);
    // The last of the words with a region after it.
    let body = lower.get(begin..end)?;
    let place = PLACES.iter().filter_map(|word| body.rfind(word).map(|at| (at, word.len()))).max();
    let (claim_end, region) = match place {
        Some((at, length)) => {
            let mut from = begin + at + length;
            let named =
                REGIONS.iter().filter(|word| lower.get(from..).is_some_and(|rest| rest.starts_with(**word)));
            from += named.map(|word| word.len()).max().unwrap_or(0);
            lower
                .get(from..)?
                .trim_start()
                .starts_with(['[', '('])
                .then_some((begin + at, Some((from, end))))?
        }
        None => (end, None),
    };
    let claimed = lower.get(begin..claim_end)?.trim_end();
    let shape = SHAPES.iter().filter_map(|(word, shape)| {
        let head = claimed.strip_suffix(word)?;
        let verb = [" is ", " ist ", " est "].into_iter().find_map(|verb| head.strip_suffix(verb));
        // is t^3 convex on [0, 1]?
        let head = verb.or_else(|| head.strip_suffix(' ').filter(|_| length.is_some()))?;
        Some((head.len(), *shape))
    });
    let shape = shape.min_by_key(|(length, _)| *length);
    let claim = (begin, begin + shape.map_or(claimed.len(), |(length, _)| length));
    if shape.is_none() && region.is_none() || claim.0 >= claim.1 {
        return None;
    }
    Some(SignClaim { asked: length.is_some(), claim, shape: shape.map(|(_, shape)| shape), region })
}

/// The parts of a region: `[0, 1] x [0, 2]` has two.
pub(crate) fn factors(region: &str) -> Vec<(usize, usize)> {
    let mut found = Vec::new();
    let mut from = 0;
    for (at, word) in region.char_indices().filter_map(|(at, _)| {
        let rest = region.get(at..)?;
        ["\\times", " x ", "x[", "×", " × "]
            .into_iter()
            .find(|word| rest.starts_with(word))
            .map(|word| (at, word))
    }) {
        if at >= from {
            found.push((from, at));
            from = at + word.trim_end_matches('[').len();
        }
    }
    found.push((from, region.len()));
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn claims_are_taken_apart() {
        let parts = |text: &str| {
            sign_claim(text).map(|found| {
                let of = |(a, b): (usize, usize)| text[a..b].trim().to_owned();
                (found.asked, of(found.claim), found.shape.map(|s| (s.order, s.turned)), found.region.map(of))
            })
        };
        let some = |asked, claim: &str, shape, region: Option<&str>| {
            Some((asked, claim.to_owned(), shape, region.map(str::to_owned)))
        };
        assert_eq!(parts("prove t^2 >= 0 on [0, 1]"), some(true, "t^2 >= 0", None, Some("[0, 1]")));
        assert_eq!(
            parts("t^3 is convex over the interval [0, 1]"),
            some(false, "t^3", Some((2, false)), Some("[0, 1]"))
        );
        assert_eq!(parts("is t^3 concave on [-1, 0]?"), some(true, "t^3", Some((2, true)), Some("[-1, 0]")));
        assert_eq!(
            parts("show that t^4 is nondecreasing on [0, 1]."),
            some(true, "t^4", Some((1, false)), Some("[0, 1]"))
        );
        assert_eq!(
            parts("x + y <= 1 on the triangle (0,0), (1,0), (0,1)"),
            some(false, "x + y <= 1", None, Some("(0,0), (1,0), (0,1)"))
        );
        assert_eq!(parts("t^2 + 1"), None);
        assert_eq!(parts("derivative of t^3 on t"), None);
        assert_eq!(factors("[0, 1] x [0, 2]"), [(0, 6), (9, 15)]);
    }
}
