//! The commands the reader knows, as data.
//!
//! One table drives the reader, the hints for misspelled commands and the page
//! docs/latex.md, so that none of them can say what the others do not.

use std::collections::HashMap;
use std::sync::LazyLock;

use super::token::{Env, Fence};
use crate::formula::{Accent, BigOp, Delimiter, Rel};
use crate::language::diagnostic::nearest;
use crate::language::lexicon::families::FORWARD_DIFFERENCE;
use crate::language::lexicon::{letters, relations};

/// What the reader does with a command.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Role {
    Symbol(&'static str),
    Prime,
    Function,
    Big(BigOp),
    Integral,
    /// An integral over what stands below, by so many variables
    IntegralOver(u8),
    Relation(Rel),
    Dot,
    Star,
    Slash,
    Cross,
    Circ,
    Binary(&'static str),
    Ellipsis,
    Accent(Accent),
    /// `\bf` and the like: holds to the end of the group; without accent an upright font.
    Switch(Option<Accent>),
    Fraction,
    Binomial,
    Root,
    /// `\underbrace`, `\overbrace`
    Brace,
    /// `\stackrel`, `\overset`: a relation with a remark above
    Stacked,
    /// `\xrightarrow{remark}`
    LongArrow,
    /// `\pmod`, behind what is congruent
    Modulus,
    /// `\over`, `\choose` between the two parts of a group
    Infix(Infix),
    ForAll,
    /// `\substack`: several lines
    Lines,
    /// `\cases{…}`, `\pmatrix{…}`
    Plain(Env),
    Open(Fence),
    Close(Fence),
    Bar,
    DoubleBar,
    Mid,
    /// `\big` and the like: the next bracket is an ordinary one
    Sized,
    Left,
    Right,
    Middle,
    Text,
    /// `\mathrm`, `\operatorname`: a word is a name, anything else is read as it stands
    Upright,
    /// The command goes, its argument stays.
    Transparent,
    /// The command goes, with this many arguments.
    Dropped(u8),
    /// The command goes with one argument, the second stays.
    DroppedFirst,
    Space,
    Gap,
    /// A sign that is read as a word.
    Word,
    /// `\%`, a hundredth
    Percent,
    RowBreak,
    Begin,
    End,
    Not,
    Unsupported(&'static str),
}

/// Infix commands of plain TeX.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Infix {
    Over,
    Choose,
}

impl Role {
    /// Number of arguments in braces that belong to the command.
    pub fn arguments(self) -> u32 {
        match self {
            Role::Accent(_) | Role::Root | Role::Brace | Role::Lines | Role::Plain(_) | Role::LongArrow => 1,
            Role::Modulus => 1,
            Role::Fraction | Role::Binomial | Role::Stacked => 2,
            _ => 0,
        }
    }
}

/// A command of LaTeX that the reader knows.
///
/// ```
/// let frac = polarform::latex::commands().iter().find(|c| c.name() == "frac").unwrap();
/// assert_eq!(frac.group(), "fractions and roots");
/// assert!(frac.is_supported());
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Command {
    name: &'static str,
    meaning: &'static str,
    role: Role,
}

impl Command {
    /// The name, without backslash.
    pub fn name(&self) -> &'static str {
        self.name
    }

    /// What it means, in a few words.
    pub fn meaning(&self) -> &'static str {
        self.meaning
    }

    /// Whether formulas with it can be read; otherwise [`Command::meaning`] says what it would be.
    pub fn is_supported(&self) -> bool {
        !matches!(self.role, Role::Unsupported(_))
    }

    /// The heading it belongs under in a list of commands.
    pub fn group(&self) -> &'static str {
        match self.role {
            Role::Symbol(_) | Role::Prime => "letters and symbols",
            Role::Function => "functions",
            Role::Big(_) | Role::Integral | Role::IntegralOver(_) | Role::ForAll => {
                "sums, limits and integrals"
            }
            Role::Relation(_) | Role::Stacked | Role::LongArrow | Role::Not => "relations",
            Role::Dot
            | Role::Star
            | Role::Slash
            | Role::Cross
            | Role::Circ
            | Role::Percent
            | Role::Binary(_)
            | Role::Modulus
            | Role::Ellipsis => "operations and dots",
            Role::Accent(_) | Role::Switch(_) | Role::Upright | Role::Text | Role::Word => {
                "accents, fonts and words"
            }
            Role::Fraction | Role::Binomial | Role::Root | Role::Infix(_) => "fractions and roots",
            Role::Brace | Role::Lines | Role::Plain(_) => "braces, lines and matrices",
            Role::Open(_)
            | Role::Close(_)
            | Role::Bar
            | Role::DoubleBar
            | Role::Mid
            | Role::Sized
            | Role::Left
            | Role::Right
            | Role::Middle => "brackets",
            Role::Transparent
            | Role::Dropped(_)
            | Role::DroppedFirst
            | Role::Space
            | Role::Gap
            | Role::RowBreak
            | Role::Begin
            | Role::End => "layout",
            Role::Unsupported(_) => "not supported",
        }
    }

    pub(super) fn role(&self) -> Role {
        self.role
    }
}

/// All commands the reader knows, in the order of the documentation.
pub fn commands() -> &'static [Command] {
    static COMMANDS: LazyLock<Vec<Command>> = LazyLock::new(|| {
        // Omicron looks like the letter o, which is why TeX has no command for it.
        let greek = letters::GREEK.iter().filter(|(name, _)| *name != "omicron");
        let greek = greek.map(|&(name, sign)| Command {
            name,
            meaning: if name == FORWARD_DIFFERENCE { "Δ; also the forward difference" } else { sign },
            role: Role::Symbol(name),
        });
        let own = |sign: &&relations::Sign| !OTHERS.iter().any(|other| other.name == sign.command);
        let signs = relations::SIGNS.iter().filter(own).map(|sign| Command {
            name: sign.command,
            meaning: sign.unicode.trim(),
            role: Role::Relation(Rel::Other(sign.sign)),
        });
        greek.chain(OTHERS.iter().copied()).chain(signs).collect()
    });
    &COMMANDS
}

pub(super) fn lookup(name: &str) -> Option<&'static Command> {
    static INDEX: LazyLock<HashMap<&str, &Command>> =
        LazyLock::new(|| commands().iter().map(|command| (command.name, command)).collect());
    INDEX.get(name).copied()
}

/// The known command most like `name`, if any is near.
fn nearest_command(name: &str) -> Option<&'static str> {
    nearest(name, commands().iter().filter(|command| command.is_supported()).map(|command| command.name))
}

/// What an unknown command may have been meant to be.
pub(super) fn hint(name: &str) -> String {
    match (nearest_command(name), glued(name)) {
        (None, Some((head, tail))) => format!("did you mean \\{head} {tail}?"),
        (Some(near), Some((head, tail))) if near == head => format!("did you mean \\{head} {tail}?"),
        (Some(near), _) => format!("did you mean \\{near}?"),
        (None, None) => "the commands that can be read are listed in docs/latex.md".to_owned(),
    }
}

/// The longest known command that `name` begins with, and the rest: `cdotb` is `cdot`, `b`.
fn glued(name: &str) -> Option<(&str, &str)> {
    (2..name.len())
        .rev()
        .take(16)
        .filter_map(|at| name.split_at_checked(at))
        .find(|(head, _)| lookup(head).is_some_and(Command::is_supported))
}

/// Words that stand bare in formulas, without `\text`, and are not products of letters.
pub(super) const BARE_WORDS: &[&str] =
    &["angle", "arg", "constant", "cos", "det", "exp", "max", "min", "sin", "span", "tan"];

/// Words that join formulas; never names of functions.
pub(super) const CONNECTIVES: &[&str] = &[
    "and",
    "by",
    "else",
    "for",
    "if",
    "iff",
    "is",
    "let",
    "or",
    "otherwise",
    "then",
    "when",
    "where",
    "with",
];

/// Entries in one line each: name, meaning, role.
macro_rules! table {
    ($($name:literal $meaning:literal $role:expr;)*) => {
        &[$(Command { name: $name, meaning: $meaning, role: $role }),*]
    };
}

#[rustfmt::skip]
const OTHERS: &[Command] = table! {
    "hbar" "ħ" Role::Symbol("hbar");
    "imath" "dotless i" Role::Symbol("imath");
    "jmath" "dotless j" Role::Symbol("jmath");
    "infty" "∞" Role::Symbol("infty");
    "nabla" "∇ (differences with it are read, not evaluated)" Role::Symbol("nabla");
    "partial" "∂" Role::Symbol("partial");
    "part" "∂" Role::Symbol("partial");
    "emptyset" "∅" Role::Symbol("emptyset");
    "varnothing" "∅" Role::Symbol("emptyset");
    "top" "⊤; as an exponent the transpose" Role::Symbol("top");
    "intercal" "as an exponent the transpose" Role::Symbol("top");
    "bot" "⊥" Role::Symbol("bot");
    "dagger" "†" Role::Symbol("dagger");
    "star" "⋆" Role::Symbol("star");
    "angle" "∠" Role::Symbol("angle");
    "triangle" "△" Role::Symbol("Delta");
    "square" "□" Role::Symbol("square");
    "Box" "□" Role::Symbol("square");
    "blacksquare" "■" Role::Symbol("blacksquare");
    "prime" "′" Role::Prime;

    "sin" "sine" Role::Function;
    "cos" "cosine" Role::Function;
    "tan" "tangent" Role::Function;
    "cot" "cotangent" Role::Function;
    "sec" "secant" Role::Function;
    "csc" "cosecant" Role::Function;
    "arcsin" "inverse sine" Role::Function;
    "arccos" "inverse cosine" Role::Function;
    "arctan" "inverse tangent" Role::Function;
    "sinh" "hyperbolic sine" Role::Function;
    "cosh" "hyperbolic cosine" Role::Function;
    "tanh" "hyperbolic tangent" Role::Function;
    "exp" "exponential function" Role::Function;
    "log" "logarithm" Role::Function;
    "ln" "natural logarithm" Role::Function;
    "lg" "logarithm" Role::Function;
    "det" "determinant" Role::Function;
    "dim" "dimension" Role::Function;
    "deg" "degree" Role::Function;
    "gcd" "greatest common divisor" Role::Function;
    "ker" "kernel" Role::Function;
    "arg" "argument" Role::Function;
    "inf" "infimum" Role::Function;
    "sup" "supremum" Role::Function;
    "Pr" "probability" Role::Function;

    "sum" "sum; takes the product that follows" Role::Big(BigOp::Sum);
    "prod" "product" Role::Big(BigOp::Product);
    "max" "maximum" Role::Big(BigOp::Max);
    "min" "minimum" Role::Big(BigOp::Min);
    "bigcup" "union" Role::Big(BigOp::Union);
    "bigcap" "intersection" Role::Big(BigOp::Intersection);
    "lim" "limit" Role::Big(BigOp::Limit);
    "int" "integral, up to the differential" Role::Integral;
    "oint" "integral along the closed curve below it" Role::IntegralOver(1);
    "iint" "integral over the region below it" Role::IntegralOver(2);
    "iiint" "integral over the region below it" Role::IntegralOver(3);
    "forall" "for all" Role::ForAll;

    "ne" "≠" Role::Relation(Rel::Ne);
    "neq" "≠" Role::Relation(Rel::Ne);
    "not" "negates the = that follows" Role::Not;
    "lt" "<" Role::Relation(Rel::Lt);
    "gt" ">" Role::Relation(Rel::Gt);
    "le" "≤" Role::Relation(Rel::Le);
    "leq" "≤" Role::Relation(Rel::Le);
    "leqslant" "≤" Role::Relation(Rel::Le);
    "leqq" "≤" Role::Relation(Rel::Le);
    "ge" "≥" Role::Relation(Rel::Ge);
    "geq" "≥" Role::Relation(Rel::Ge);
    "geqslant" "≥" Role::Relation(Rel::Ge);
    "geqq" "≥" Role::Relation(Rel::Ge);
    "equiv" "≡" Role::Relation(Rel::Equiv);
    "approx" "≈" Role::Relation(Rel::Approx);
    "simeq" "≈" Role::Relation(Rel::Approx);
    "in" "∈" Role::Relation(Rel::In);
    "notin" "∉" Role::Relation(Rel::NotIn);
    "subset" "⊂" Role::Relation(Rel::Subset);
    "subseteq" "⊆" Role::Relation(Rel::Subset);
    "triangleq" "is defined as" Role::Relation(Rel::Define);
    "coloneqq" "is defined as" Role::Relation(Rel::Define);
    "coloneq" "is defined as" Role::Relation(Rel::Define);
    "doteq" "is defined as" Role::Relation(Rel::Define);
    "to" "→" Role::Relation(Rel::To);
    "rightarrow" "→" Role::Relation(Rel::To);
    "longrightarrow" "→" Role::Relation(Rel::To);
    "xrightarrow" "→ with a remark" Role::LongArrow;
    "mapsto" "↦" Role::Relation(Rel::MapsTo);
    "longmapsto" "↦" Role::Relation(Rel::MapsTo);
    "Rightarrow" "⇒" Role::Relation(Rel::Implies);
    "Longrightarrow" "⇒" Role::Relation(Rel::Implies);
    "implies" "⇒" Role::Relation(Rel::Implies);
    "Leftrightarrow" "⇔" Role::Relation(Rel::Iff);
    "Longleftrightarrow" "⇔" Role::Relation(Rel::Iff);
    "iff" "⇔" Role::Relation(Rel::Iff);
    "colon" "the : of a map" Role::Relation(Rel::Colon);
    "stackrel" "a relation with a remark, such as def, above it" Role::Stacked;
    "overset" "a relation with a remark above it" Role::Stacked;
    "underset" "a relation with a remark below it, or an operator with its bounds" Role::Stacked;

    "cdot" "product; alone, an empty place for an argument" Role::Dot;
    "ast" "product; as an exponent a star" Role::Star;
    "div" "quotient" Role::Slash;
    "times" "product of vectors, sets or numbers" Role::Cross;
    "circ" "composition; as an exponent degrees" Role::Circ;
    "cup" "∪" Role::Binary("cup");
    "cap" "∩" Role::Binary("cap");
    "setminus" "∖" Role::Binary("setminus");
    "otimes" "⊗" Role::Binary("otimes");
    "oplus" "⊕" Role::Binary("oplus");
    "wedge" "∧ (read, not judged)" Role::Binary("wedge");
    "pm" "± (read, not judged)" Role::Binary("pm");
    "mp" "∓ (read, not judged)" Role::Binary("mp");
    "bmod" "remainder" Role::Binary("mod");
    "mod" "remainder" Role::Binary("mod");
    "pmod" "congruent by this modulus (read, not judged)" Role::Modulus;
    "ldots" "…" Role::Ellipsis;
    "dots" "…" Role::Ellipsis;
    "cdots" "⋯" Role::Ellipsis;
    "dotsc" "…" Role::Ellipsis;
    "dotsb" "⋯" Role::Ellipsis;
    "dotsm" "⋯" Role::Ellipsis;
    "vdots" "⋮" Role::Ellipsis;
    "ddots" "⋱" Role::Ellipsis;

    "hat" "vector argument" Role::Accent(Accent::Hat);
    "widehat" "vector argument" Role::Accent(Accent::Hat);
    "bar" "bar" Role::Accent(Accent::Bar);
    "overline" "bar" Role::Accent(Accent::Bar);
    "vec" "arrow" Role::Accent(Accent::Vec);
    "overrightarrow" "arrow" Role::Accent(Accent::Vec);
    "tilde" "tilde" Role::Accent(Accent::Tilde);
    "widetilde" "tilde" Role::Accent(Accent::Tilde);
    "dot" "derivative" Role::Accent(Accent::Dot);
    "ddot" "second derivative" Role::Accent(Accent::Ddot);
    "pmb" "bold" Role::Accent(Accent::Bold);
    "mathbf" "bold" Role::Accent(Accent::Bold);
    "bm" "bold" Role::Accent(Accent::Bold);
    "boldsymbol" "bold" Role::Accent(Accent::Bold);
    "mathcal" "script letter" Role::Accent(Accent::Script);
    "mathscr" "script letter" Role::Accent(Accent::Script);
    "mathbb" "blackboard letter" Role::Accent(Accent::Blackboard);
    "mathds" "blackboard letter" Role::Accent(Accent::Blackboard);
    "bf" "bold to the end of the group" Role::Switch(Some(Accent::Bold));
    "cal" "script letters to the end of the group" Role::Switch(Some(Accent::Script));
    "rm" "upright to the end of the group" Role::Switch(None);
    "it" "italic to the end of the group" Role::Switch(None);
    "mathrm" "an upright name; d is a differential, ^T the transpose" Role::Upright;
    "mathsf" "a name" Role::Upright;
    "mathtt" "a name" Role::Upright;
    "mathit" "a name" Role::Upright;
    "operatorname" "a name of several letters" Role::Upright;
    "text" "words" Role::Text;
    "textrm" "words" Role::Text;
    "textit" "words" Role::Text;
    "textbf" "words" Role::Text;
    "textnormal" "words" Role::Text;
    "textsf" "words" Role::Text;
    "texttt" "words" Role::Text;
    "textsc" "words" Role::Text;
    "textsl" "words" Role::Text;
    "textup" "words" Role::Text;
    "mbox" "words" Role::Text;
    "hbox" "words" Role::Text;
    "therefore" "∴, a word" Role::Word;
    "because" "∵, a word" Role::Word;

    "frac" "fraction; d over dt is a derivative" Role::Fraction;
    "dfrac" "fraction" Role::Fraction;
    "tfrac" "fraction" Role::Fraction;
    "cfrac" "fraction" Role::Fraction;
    "over" "fraction of the two parts of a group" Role::Infix(Infix::Over);
    "binom" "binomial coefficient" Role::Binomial;
    "dbinom" "binomial coefficient" Role::Binomial;
    "tbinom" "binomial coefficient" Role::Binomial;
    "choose" "binomial coefficient of the two parts of a group" Role::Infix(Infix::Choose);
    "sqrt" "root (read, not evaluated)" Role::Root;

    "underbrace" "items with a count or remark below" Role::Brace;
    "overbrace" "items with a count or remark above" Role::Brace;
    "substack" "several lines below a sum" Role::Lines;
    "cases" "values with conditions" Role::Plain(Env::Cases);
    "matrix" "matrix without brackets" Role::Plain(Env::Matrix(Delimiter::None));
    "pmatrix" "matrix in ( )" Role::Plain(Env::Matrix(Delimiter::Paren));

    "left" "opening bracket" Role::Left;
    "mleft" "opening bracket" Role::Left;
    "mright" "closing bracket" Role::Right;
    "right" "closing bracket; |_{t=0} evaluates" Role::Right;
    "middle" "the bar of a set" Role::Middle;
    "mid" "the bar of a set" Role::Mid;
    "{" "opening brace" Role::Open(Fence::Curly);
    "}" "closing brace" Role::Close(Fence::Curly);
    "lbrace" "opening brace" Role::Open(Fence::Curly);
    "rbrace" "closing brace" Role::Close(Fence::Curly);
    "lbrack" "[" Role::Open(Fence::Square);
    "rbrack" "]" Role::Close(Fence::Square);
    "lparen" "(" Role::Open(Fence::Paren);
    "rparen" ")" Role::Close(Fence::Paren);
    "lgroup" "(" Role::Open(Fence::Paren);
    "rgroup" ")" Role::Close(Fence::Paren);
    "lfloor" "rounding down" Role::Open(Fence::Floor);
    "rfloor" "rounding down" Role::Close(Fence::Floor);
    "lceil" "rounding up" Role::Open(Fence::Ceil);
    "ulcorner" "rounding up" Role::Open(Fence::Ceil);
    "llcorner" "rounding down" Role::Open(Fence::Floor);
    "urcorner" "rounding up" Role::Close(Fence::Ceil);
    "lrcorner" "rounding down" Role::Close(Fence::Floor);
    "rceil" "rounding up" Role::Close(Fence::Ceil);
    "langle" "left angle bracket of an inner product (read, not evaluated)" Role::Open(Fence::Angle);
    "rangle" "inner product" Role::Close(Fence::Angle);
    "|" "norm" Role::DoubleBar;
    "vert" "absolute value" Role::Bar;
    "Vert" "norm" Role::DoubleBar;
    "lvert" "absolute value" Role::Open(Fence::Bar);
    "rvert" "absolute value" Role::Close(Fence::Bar);
    "lVert" "norm" Role::Open(Fence::Norm);
    "rVert" "norm" Role::Close(Fence::Norm);
    "big" "larger bracket" Role::Sized;
    "Big" "larger bracket" Role::Sized;
    "bigg" "larger bracket" Role::Sized;
    "Bigg" "larger bracket" Role::Sized;
    "bigl" "larger bracket" Role::Sized;
    "Bigl" "larger bracket" Role::Sized;
    "biggl" "larger bracket" Role::Sized;
    "Biggl" "larger bracket" Role::Sized;
    "bigr" "larger bracket" Role::Sized;
    "Bigr" "larger bracket" Role::Sized;
    "biggr" "larger bracket" Role::Sized;
    "Biggr" "larger bracket" Role::Sized;
    "bigm" "larger bar" Role::Sized;
    "Bigm" "larger bar" Role::Sized;
    "biggm" "larger bar" Role::Sized;
    "Biggm" "larger bar" Role::Sized;

    "begin" "begins an environment" Role::Begin;
    "end" "ends an environment" Role::End;
    "\\" "new row" Role::RowBreak;
    "cr" "new row" Role::RowBreak;
    "newline" "new row" Role::RowBreak;
    "%" "a hundredth, behind a number" Role::Percent;
    "quad" "wide space; separates formulas" Role::Gap;
    "qquad" "wide space; separates formulas" Role::Gap;
    "hfill" "wide space; separates formulas" Role::Gap;
    "hspace" "space" Role::Dropped(1);
    "vspace" "space" Role::Dropped(1);
    " " "space; two of them separate formulas" Role::Space;
    "," "space" Role::Transparent;
    ";" "space" Role::Transparent;
    ":" "space" Role::Transparent;
    "!" "space" Role::Transparent;
    ">" "space" Role::Transparent;
    "/" "no space" Role::Transparent;
    "thinspace" "space" Role::Transparent;
    "medspace" "space" Role::Transparent;
    "thickspace" "space" Role::Transparent;
    "enspace" "space" Role::Transparent;
    "enskip" "space" Role::Transparent;
    "negthinspace" "space" Role::Transparent;
    "negmedspace" "space" Role::Transparent;
    "negthickspace" "space" Role::Transparent;
    "displaystyle" "size" Role::Transparent;
    "textstyle" "size" Role::Transparent;
    "scriptstyle" "size" Role::Transparent;
    "scriptscriptstyle" "size" Role::Transparent;
    "tiny" "size" Role::Transparent;
    "small" "size" Role::Transparent;
    "large" "size" Role::Transparent;
    "Large" "size" Role::Transparent;
    "limits" "place of bounds" Role::Transparent;
    "nolimits" "place of bounds" Role::Transparent;
    "nonumber" "no number" Role::Transparent;
    "notag" "no number" Role::Transparent;
    "hline" "line in a table" Role::Transparent;
    "centering" "layout" Role::Transparent;
    "allowbreak" "layout" Role::Transparent;
    "relax" "nothing" Role::Transparent;
    "strut" "height" Role::Transparent;
    "mathstrut" "height" Role::Transparent;
    "boxed" "frame; the content is read" Role::Transparent;
    "checkmark" "✓, a remark" Role::Transparent;
    "qed" "end of a proof" Role::Transparent;
    "mathop" "class; the content is read" Role::Transparent;
    "mathbin" "class; the content is read" Role::Transparent;
    "mathrel" "class; the content is read" Role::Transparent;
    "mathord" "class; the content is read" Role::Transparent;
    "mathopen" "class; the content is read" Role::Transparent;
    "mathclose" "class; the content is read" Role::Transparent;
    "mathnormal" "font; the content is read" Role::Transparent;
    "ensuremath" "the content is read" Role::Transparent;
    "label" "label" Role::Dropped(1);
    "tag" "number of the formula" Role::Dropped(1);
    "phantom" "space" Role::Dropped(1);
    "hphantom" "space" Role::Dropped(1);
    "vphantom" "space" Role::Dropped(1);
    "color" "colour" Role::Dropped(1);
    "textcolor" "colour; the second argument is read" Role::DroppedFirst;

    "exists" "there is" Role::Unsupported("only \\forall is read");
    "land" "and" Role::Unsupported("separate the formulas by a comma");
    "lor" "or" Role::Unsupported("alternatives cannot be read");
    "vee" "or" Role::Unsupported("alternatives cannot be read");
    "mathfrak" "Fraktur letter" Role::Unsupported("the formula tree has no such letters");
    "Re" "real part" Role::Unsupported("there are no complex numbers here");
    "Im" "imaginary part" Role::Unsupported("there are no complex numbers here");
    "atop" "something above" Role::Unsupported("write \\binom{n}{k} for a binomial coefficient");
    "ref" "reference" Role::Unsupported("a reference is not a formula");
    "eqref" "reference" Role::Unsupported("a reference is not a formula");
    "includegraphics" "picture" Role::Unsupported("a picture is not a formula");
};

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_unique_and_explained() {
        for (i, command) in commands().iter().enumerate() {
            assert!(!command.meaning.is_empty(), "\\{} has no meaning", command.name);
            assert!(
                commands()[..i].iter().all(|other| other.name != command.name),
                "\\{} twice",
                command.name
            );
        }
    }

    #[test]
    fn nearest_names() {
        assert_eq!(nearest_command("farc"), Some("frac"));
        assert_eq!(nearest_command("biom"), Some("binom"));
        assert_eq!(nearest_command("aplha"), Some("alpha"));
        assert_eq!(nearest_command("underbarce"), Some("underbrace"));
        assert_eq!(nearest_command("xyzzy"), None);
    }
}
