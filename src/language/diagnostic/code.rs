//! The stable codes of all problems, with their explanations.

use std::fmt;
use std::str::FromStr;

macro_rules! codes {
    ($($(#[doc = $doc:literal])* $variant:ident = $id:literal: $title:literal,)*) => {
        /// What kind of problem; its identifier never changes meaning.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub enum Code {
            $(
                #[doc = concat!($id, ": ", $title)]
                ///
                $(#[doc = $doc])*
                $variant,
            )*
        }

        impl Code {
            /// Every code, in order.
            pub const ALL: &'static [Code] = &[$(Code::$variant),*];

            /// The identifier, such as `E101`.
            pub fn id(self) -> &'static str {
                match self { $(Code::$variant => $id,)* }
            }

            /// A short name of the problem.
            pub fn title(self) -> &'static str {
                match self { $(Code::$variant => $title,)* }
            }

            /// The long explanation, with an example and its cure.
            pub fn explanation(self) -> &'static str {
                match self { $(Code::$variant => concat!($($doc, "\n"),*),)* }
            }
        }
    };
}

codes! {
    /// A character has no meaning in the notation.
    ///
    /// Example: `t ? 2`. Write the operation you mean, for example `t^2`.
    UnexpectedCharacter = "E101": "unexpected character",
    /// A word, number or sign stands where something else was needed.
    ///
    /// Example: `t + * 2`. Remove one of the two operators.
    UnexpectedToken = "E102": "unexpected token",
    /// The formula stops in the middle.
    ///
    /// Example: `t^2 +`. Write what is missing or remove the last sign.
    UnexpectedEnd = "E103": "the formula ends too early",
    /// An opening bracket has no closing partner, or the other way round.
    ///
    /// Example: `(t + 1`. Add the missing bracket.
    Unbalanced = "E104": "unbalanced brackets",
    /// There is nothing to read.
    ///
    /// Example: the empty string. Write a formula such as `t^2 + 1`.
    Empty = "E105": "nothing to read",
    /// A formula is nested more deeply than the reader allows.
    ///
    /// Example: a thousand opening brackets. Define parts under names of their own.
    TooDeep = "E106": "nested too deeply",
    /// A LaTeX command the reader does not know.
    ///
    /// Example: `\foo{t}`. The names it knows are listed in docs/latex.md.
    UnknownCommand = "E107": "unknown LaTeX command",
    /// A LaTeX construct the reader does not support.
    UnsupportedLatex = "E108": "unsupported LaTeX",
    /// A number that cannot be read, such as `1.2.3`.
    BadNumber = "E109": "malformed number",
    /// The text is longer than the limit on input.
    TooLong = "E110": "input too long",

    /// A name that has no value here.
    ///
    /// Example: `f(0, 1)` before `f := polar(t^2)`. Define it first.
    UnknownName = "E201": "unknown name",
    /// A function that does not exist.
    ///
    /// Example: `polra(t^2)`. The hint names the nearest function.
    UnknownFunction = "E202": "unknown function",
    /// `f(t + 1)` may be a value of f or a product, and nothing says which.
    ///
    /// Define `f` first, or write `f*(t + 1)` for the product.
    AmbiguousProduct = "E203": "function or product?",
    /// The left side of `:=` is not a name or a name with arguments.
    BadDefinition = "E204": "not a definition",
    /// A name that has a fixed meaning cannot be defined anew.
    ReservedName = "E205": "reserved name",
    /// A definition that refers to itself without a base case.
    ///
    /// Example: `F(t) := F(t) + 1`.
    Recursion = "E206": "endless recursion",

    /// A name that is not defined was read with the meaning it has in the literature.
    ///
    /// Example: `B_1^3(t)` is a Bernstein polynomial. Define the name to give it another meaning.
    StandardMeaning = "E207": "read with its standard meaning",
    /// A new case was added to a function that has other cases.
    ///
    /// Example: `F(0) := 1` and then `F(n) := n F(n-1)`. `:forget F` starts anew.
    MoreCases = "E208": "a further case of a function",
    /// A word without a value was read as the product of its letters.
    ///
    /// Example: `2ab` is 2 a b. Define `ab` to give the word a meaning of its own.
    Letters = "E209": "read as a product of letters",
    /// A formula that was defined without an argument was called, and its variable took the value.
    ///
    /// Example: `p = t^2 + 2t` and then `p(3)`, which is 15. Write `p * (3)` for the product.
    Called = "E210": "a formula was called",

    /// An equation was asked as if it held for all values of its symbols.
    ///
    /// Example: `x^2 - 5x + 6 = 0` is refuted, since it fails for x = 0. `solve(x^2 - 5x + 6 = 0)` gives the
    /// values for which it holds.
    NoIdentity = "E211": "an equation that is no identity",
    /// A sum over an index with symbols as bounds is a polynomial in them, which holds for integers only, from where
    /// the sum is empty.
    ///
    /// Example: `sum(k=1..n, k)` is 1/2 n^2 + 1/2 n for integers n >= 0.
    SymbolicBounds = "E212": "a sum with symbols as bounds",

    /// Wrong number of arguments.
    ///
    /// Example: a polar form of degree 3 takes exactly 3 arguments.
    Arity = "E301": "wrong number of arguments",
    /// An argument or operand of the wrong kind.
    Type = "E302": "wrong kind of value",
    /// Division by zero.
    DivisionByZero = "E303": "division by zero",
    /// A polynomial was needed, but the variable stands in a denominator.
    ///
    /// Example: `polar(1/t)`. Only polynomials have a polar form.
    NotPolynomial = "E304": "not a polynomial",
    /// The degree asked for is below the polynomial's degree.
    ///
    /// Example: `polar(t^3, degree=2)`. Use 3 or more.
    DegreeTooSmall = "E305": "degree too small",
    /// Which variable is the parameter cannot be told.
    AmbiguousVariable = "E306": "which variable?",
    /// Matrices or points of sizes that do not fit.
    Shape = "E307": "sizes do not fit",
    /// A matrix without inverse.
    Singular = "E308": "singular matrix",
    /// An exponent or index that is not a (small, nonnegative) integer.
    BadExponent = "E309": "bad exponent",
    /// The degree cannot be reduced exactly.
    NotReducible = "E310": "not reducible",
    /// Two nodes, knots or interval ends coincide that must differ.
    Coincident = "E311": "coincident points",
    /// An argument outside the range a function accepts.
    Domain = "E312": "argument out of range",
    /// The question cannot be decided with exact methods here.
    Undecided = "E313": "cannot decide",
    /// Something the program does not support.
    Unsupported = "E314": "not supported",

    /// Control points, weights or nets of sizes that do not fit together.
    ///
    /// Example: `bezier([[0, 0], [1]])`. All points need the same number of coordinates.
    ControlPoints = "E315": "control points do not fit",
    /// Knots that decrease, are repeated too often, or whose number does not fit.
    ///
    /// Example: `bspline(2, [0, 0, 0, 1, 1, 1], [1, 2])`. m control points of degree n need m + n + 1 knots.
    Knots = "E316": "knots do not fit",
    /// A curve has no value at a parameter outside of its interval.
    ///
    /// Example: `bezier([0, 1])(2)`. `extended(c, t)` gives the value of the polynomial there.
    OutsideDomain = "E317": "parameter outside of the domain",
    /// A weight is zero, or the weights add up to zero at the parameter.
    ZeroWeight = "E318": "zero weight",
    /// The corners of a triangle or frame are affinely dependent.
    ///
    /// Example: `barycentric([1, 1], [[0, 0], [1, 1], [2, 2]])`.
    Degenerate = "E319": "degenerate corners",
    /// A number has no rational square root, so an exact answer does not exist.
    Irrational = "E320": "irrational",
    /// Something that has no place on a page: symbols without values, infinite or huge coordinates.
    ///
    /// Example: `figure_bezier(bezier([b_0, b_1]))`. Give the symbols values first.
    Undrawable = "E321": "cannot be drawn",

    /// Some roots of a polynomial are not real, and only real ones are given.
    ///
    /// Example: `roots(t^2 + 1)`, which is an empty list.
    NotReal = "E322": "roots that are not real",
    /// Part of an answer is long and was left out.
    ///
    /// Example: the points where two curves of degree 10 meet, whose parameters are roots of a polynomial of
    /// degree 100. `points=1` gives them.
    LeftOut = "E323": "a part is left out",
    /// Where a largest or smallest value is taken.
    ///
    /// Example: `maximum(3t(1-t)^2, 0, 1)`, which is taken at t = 1/3.
    TakenAt = "E324": "where an extreme value is taken",

    /// The time limit was reached.
    ///
    /// Allow more with `--timeout SECONDS`.
    Timeout = "E401": "time limit reached",
    /// A value would have more terms than allowed.
    ///
    /// Allow more with `--max-terms N`, or print in a compact form with `--notation sigma`.
    TooManyTerms = "E402": "too many terms",
    /// A number would have more digits than allowed.
    TooManyDigits = "E403": "number too large",
    /// The computation was interrupted.
    Interrupted = "E404": "interrupted",

    /// A file could not be read or written.
    File = "E501": "file problem",
    /// The command line does not make sense.
    Usage = "E502": "bad usage",
    /// A defect of polarform itself. Please report it.
    Internal = "E599": "internal error",

    /// A formula of a file of notes begins and never ends.
    ///
    /// Example: `$t^2 is convex`. Write the closing sign; a currency is written `\$`.
    UnclosedFormula = "E601": "unclosed formula",
    /// A block, comment or environment of a file of notes begins and never ends, or the other way round.
    ///
    /// Example: a line of three backquotes without a second one. What follows it is not checked.
    UnclosedBlock = "E602": "unclosed block",
    /// A definition of a macro in a file of notes cannot be read.
    ///
    /// Example: `\newcommand{\x}[1]{a` without the last brace. Its calls stay as they are.
    HalfDefinition = "E603": "unreadable definition of a macro",
    /// What a macro of a file of notes stands for has no end, or is very long.
    ///
    /// Example: `\newcommand{\x}{\x + 1}`. Give one of the two another name.
    MacroTooLarge = "E604": "endless macro",
    /// A file that a LaTeX file includes is missing, or includes itself.
    ///
    /// Example: `\input{chapter2}` without a file chapter2.tex. The rest is checked.
    Include = "E605": "included file",
    /// The file holds no text, or its characters are not in UTF-8.
    ///
    /// Other encodings are guessed. Save the file as UTF-8 to be sure.
    Encoding = "E606": "not UTF-8",
    /// A Jupyter notebook that is not made as notebooks are.
    ///
    /// Example: half of a file. Open and save it with Jupyter.
    BrokenNotebook = "E607": "broken notebook",
    /// Something in a file of notes looks like a formula and was not read.
    ///
    /// Example: `\\frac12` among words, without signs around it. Put it between `$` and `$`.
    UnseenFormula = "E608": "a formula that was not read",
    /// A file of a kind that is not read.
    ///
    /// Example: `notes.typ`. Turn it into Markdown, or say with `--as markdown` how to read it.
    FileKind = "E609": "unknown kind of file",
    /// A renderer of Markdown would not show a formula as it stands.
    ///
    /// Example: mdBook makes `{1, 2}` of `$\{1, 2\}$`. `polarform weave --mdbook --mathml` sets formulas so that none can be broken.
    BrokenFormula = "E610": "a formula that a renderer breaks",

    /// A query, a block of code or a woven result of a file begins and never ends.
    ///
    /// Example: `{{ f(0, 1)` without `}}`. Write the closing sign; braces that are none are written `\{{`.
    UnclosedQuery = "E701": "unclosed query",
    /// An option of a block that does not exist, or a value that it does not take.
    ///
    /// Example: a block that begins with `polarform stile=list`. The options are listed in docs/weave.md.
    BlockOption = "E702": "bad option of a block",
    /// A result in a file is not what its query gives today.
    ///
    /// `polarform weave FILE` puts the new one in its place.
    OutOfDate = "E703": "out of date",
    /// A claim in a file to be woven is false.
    ///
    /// Example: `{{ f(0, 1) = 2 }}` for the polar form of t^2 + 2t, whose value is 1.
    Refuted = "E704": "refuted claim",
    /// A file was written by another program while it was woven.
    ///
    /// Nothing was written. Weave it again.
    Changed = "E705": "changed meanwhile",
}

impl fmt::Display for Code {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.id())
    }
}

impl FromStr for Code {
    type Err = ();
    fn from_str(text: &str) -> Result<Self, ()> {
        Code::ALL.iter().copied().find(|code| code.id().eq_ignore_ascii_case(text)).ok_or(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identifiers_are_unique_and_read_back() {
        for (i, code) in Code::ALL.iter().enumerate() {
            assert_eq!(code.id().parse(), Ok(*code));
            assert!(Code::ALL[..i].iter().all(|other| other.id() != code.id()));
            assert!(!code.explanation().trim().is_empty(), "{code} is not explained");
        }
    }
}
