//! The formula tree, exactly as somebody wrote it.
//!
//! Nothing is simplified here: `t + t` stays a sum of two terms, `(t)` keeps its
//! parentheses ([`Kind::Group`]) and `f(t + 1)` is an [`Kind::Apply`] whether it
//! will turn out to be the value of a function or a product. Meaning is given by
//! the evaluator, which knows the declared names. Both readers (plain notation and
//! LaTeX) produce this tree and all writers print it.

mod build;
mod precedence;
pub mod source;
mod visit;

pub(crate) use build::{applied, before_brackets, bracketed, call, interval, named, spread};
pub use precedence::Precedence;

use crate::formula::source::Span;
use crate::math::number::Rational;

/// A formula with the place it was read from.
///
/// Equality compares structure *and* spans; use [`Expr::same_as`] to ignore spans.
#[derive(Clone, Debug, PartialEq)]
pub struct Expr {
    /// What it is.
    pub kind: Kind,
    /// Where it was read; empty for computed expressions.
    pub span: Span,
}

/// Sign of a term in a sum.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sign {
    /// `+`
    Plus,
    /// `-`
    Minus,
}

/// How a quotient was written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quotient {
    /// `a/b`
    Slash,
    /// `\frac{a}{b}`
    Fraction,
}

/// Marks over or styles of a name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Accent {
    /// `\hat v`, `\widehat v`, plain `hat(v)`: a vector argument.
    Hat,
    /// `\bar`, `\overline`
    Bar,
    /// `\vec`, `\overrightarrow`
    Vec,
    /// `\tilde`, `\widetilde`
    Tilde,
    /// `\dot`: derivative
    Dot,
    /// `\ddot`: second derivative
    Ddot,
    /// `\pmb`, `\mathbf`, `\bm`, `\boldsymbol`: same name, set in bold
    Bold,
    /// `\mathcal`, `\mathscr`
    Script,
    /// `\mathbb`
    Blackboard,
}

impl Accent {
    /// Every accent.
    pub const ALL: [Accent; 9] = [
        Accent::Hat,
        Accent::Bar,
        Accent::Vec,
        Accent::Tilde,
        Accent::Dot,
        Accent::Ddot,
        Accent::Bold,
        Accent::Script,
        Accent::Blackboard,
    ];

    /// The function of the plain notation that sets it, as in `hat(v)`.
    pub fn name(self) -> &'static str {
        match self {
            Accent::Hat => "hat",
            Accent::Bar => "bar",
            Accent::Vec => "vec",
            Accent::Tilde => "tilde",
            Accent::Dot => "dot",
            Accent::Ddot => "ddot",
            Accent::Bold => "bold",
            Accent::Script => "script",
            Accent::Blackboard => "blackboard",
        }
    }
}

/// How a binomial coefficient was written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BinomialStyle {
    /// `\binom{n}{k}`, plain `binomial(n, k)`
    Stacked,
    /// `C_n^k`
    Subscripted,
}

/// Paired delimiters around a matrix.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Delimiter {
    /// ( )
    Paren,
    /// [ ]
    Bracket,
    /// | |
    Bar,
    /// none
    None,
}

/// Unary enclosures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Enclosure {
    /// |x|
    Abs,
    /// ‖x‖
    Norm,
    /// ⌊x⌋
    Floor,
    /// ⌈x⌉
    Ceil,
}

/// Operators over a range or a set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BigOp {
    /// Σ
    Sum,
    /// Π
    Product,
    /// max
    Max,
    /// min
    Min,
    /// ∪
    Union,
    /// ∩
    Intersection,
    /// lim
    Limit,
}

/// Relations between two expressions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Rel {
    /// `=`
    Eq,
    /// `:=`, `\triangleq`, `\coloneqq`
    Define,
    /// `≠`
    Ne,
    /// `<`
    Lt,
    /// `≤`
    Le,
    /// `>`
    Gt,
    /// `≥`
    Ge,
    /// `≡`
    Equiv,
    /// `≈`
    Approx,
    /// `∈`
    In,
    /// `∉`
    NotIn,
    /// `⊆`, `⊂`
    Subset,
    /// `→`, as in `F: R → R` or a limit
    To,
    /// `↦`
    MapsTo,
    /// `⇒`
    Implies,
    /// `⇔`
    Iff,
    /// `:` of `F: R → R`
    Colon,
    /// Any other sign: nothing is known of it, so that it is never judged.
    Other(char),
}

/// A signed term of a sum.
#[derive(Clone, Debug, PartialEq)]
pub struct Term {
    /// Its sign.
    pub sign: Sign,
    /// What follows the sign.
    pub expr: Expr,
}

/// One further link of a chain `a = b ≤ c`.
#[derive(Clone, Debug, PartialEq)]
pub struct Link {
    /// The relation.
    pub rel: Rel,
    /// Where its sign stands.
    pub span: Span,
    /// The right-hand side.
    pub expr: Expr,
}

/// The node types.
#[derive(Clone, Debug, PartialEq)]
pub enum Kind {
    /// A numeral; decimals are kept as the exact fraction they denote.
    Number(Rational),
    /// A name: `t`, `alpha` (Greek letters and operators by their LaTeX name, without backslash).
    Name(String),
    /// `t_1`, `p_{i,j}`, `b_{01}` (index 01 is the name "01").
    Subscript(Box<Expr>, Vec<Expr>),
    /// An upper index in parentheses: `p^{(3)}`, `f^{(+1)}`, `F^{(q)}`.
    Upper(Box<Expr>, Vec<Expr>),
    /// `\hat 1`, `\pmb b`.
    Accent(Accent, Box<Expr>),
    /// `F'`, `F''`.
    Prime(Box<Expr>, u32),
    /// `a - b + c`; at least one term, and a single term only if its sign is minus or was written.
    Add(Vec<Term>),
    /// A product of at least two factors, by juxtaposition, `*`, `\cdot` or `\times` of scalars.
    Mul(Vec<Expr>),
    /// `a/b`
    Div(Box<Expr>, Box<Expr>, Quotient),
    /// `a^b` (the evaluator decides whether it is a power, an index or a repetition)
    Pow(Box<Expr>, Box<Expr>),
    /// A name or bracket followed by a bracket: value of a function, or product.
    /// Argument groups are separated by `;` and usually there is one.
    Apply(Box<Expr>, Vec<Vec<Expr>>),
    /// Written parentheses (also square or curly ones used as parentheses).
    Group(Box<Expr>),
    /// `(a, b)`
    Tuple(Vec<Expr>),
    /// `[a, b]`: a list or a point.
    List(Vec<Expr>),
    /// `{a, b}`; the second part is a condition, as in `{x | x > 0}`.
    Set(Vec<Expr>, Option<Box<Expr>>),
    /// A matrix by rows; an empty cell is `None`. Rows may be ragged.
    Matrix(Vec<Vec<Option<Expr>>>, Delimiter),
    /// A binomial coefficient.
    Binomial(Box<Expr>, Box<Expr>, BinomialStyle),
    /// `n!`
    Factorial(Box<Expr>),
    /// |x|, ‖x‖, ⌊x⌋, ⌈x⌉
    Enclosed(Enclosure, Box<Expr>),
    /// Σ, Π, …: bounds below (each usually a relation such as i = 0), bound above, body.
    Big {
        /// Which operator.
        op: BigOp,
        /// What stands below: relations or index names, in order.
        lower: Vec<Expr>,
        /// What stands above.
        upper: Option<Box<Expr>>,
        /// What it applies to.
        body: Box<Expr>,
    },
    /// ∫ body d variable, with bounds if written.
    Integral {
        /// Lower bound.
        lower: Option<Box<Expr>>,
        /// Upper bound.
        upper: Option<Box<Expr>>,
        /// The integrand.
        body: Box<Expr>,
        /// The integration variable.
        variable: Box<Expr>,
    },
    /// d^k/dt^k body, or ∂^{r+s}/∂u^r∂v^s body.
    Derivative {
        /// Written with ∂.
        partial: bool,
        /// The variables with their orders (`None` for 1).
        variables: Vec<(Expr, Option<Expr>)>,
        /// What is differentiated; `None` when the operator stands alone.
        body: Option<Box<Expr>>,
    },
    /// body |_{t=0}, or \[body\]_{a}^{b}
    At {
        /// What is evaluated.
        body: Box<Expr>,
        /// Below the bar, usually relations `t = 0`.
        lower: Vec<Expr>,
        /// Above the bar, for differences of values.
        upper: Option<Box<Expr>>,
    },
    /// Values with conditions; `None` for "otherwise".
    Cases(Vec<(Expr, Option<Expr>)>),
    /// `\ldots` among items of a list, sum or product.
    Ellipsis,
    /// `\underbrace{t, \ldots, t}_{n}`: items and what is written at the brace.
    Brace(Vec<Expr>, Option<Box<Expr>>),
    /// `F \circ G`
    Compose(Vec<Expr>),
    /// `a \times b` written with a cross (of vectors, or of sets)
    Cross(Vec<Expr>),
    /// `M^T`
    Transpose(Box<Expr>),
    /// `0..n`
    Range(Box<Expr>, Box<Expr>),
    /// `t -> t^2`, `(i, n) -> …`
    Lambda(Vec<Expr>, Box<Expr>),
    /// `first rel second rel third …`
    Chain(Box<Expr>, Vec<Link>),
    /// Several formulas side by side, as in `i = 1, …, n` or `a = b, c = d`.
    Sequence(Vec<Expr>),
    /// `∀ x ∈ P: body`
    ForAll(Vec<Expr>, Option<Box<Expr>>),
    /// Words inside a formula.
    Text(String),
    /// A piece that could not be read; the text as written.
    Unread(String),
}
