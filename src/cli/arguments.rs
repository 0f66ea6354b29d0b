//! The arguments of the command line.

use std::path::PathBuf;
use std::time::Duration;

use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Args, Parser, Subcommand, ValueEnum};
use clap_complete::Shell;

use super::figure_arguments::FigureArguments;
use super::notes_arguments::{Notes, PageKind};
use super::script::formula;
use crate::budget::{Limits, MOST_DEPTH};
use crate::language::functions::Arrangement;
use crate::language::value::{Language, Notation};
use crate::language::write::{Breaks, Format};
use crate::math::blossom::Method;

const EXAMPLES: &str = "\
Examples:
  polarform polar \"t^3 + 3t^2 + 5t + 1\"
  polarform polar \"t^2\" --degree 3 --format latex
  polarform product \"t^2 + 2t\" \"t^3 + 1\"
  polarform check \"f(0,1) = 1/2\" --given \"f := polar(t^2 + t)\"
  polarform \"f := polar(t^3)\" \"f(0, 1, hat(1))\"
  polarform \"t^2 <= t for t in [0, 1]\"

A formula in the place of a command is evaluated.
In the place of a formula, '-' stands for the text on standard input.
Exit status: 0 done, all claims true; 1 a claim is refuted; 2 not read or not decided.";

/// Exact polynomials and their polar forms (blossoms): ask, write, check.
#[derive(Debug, Parser)]
#[command(name = "polarform", version, about, after_help = EXAMPLES, propagate_version = true)]
pub(super) struct Arguments {
    #[command(flatten)]
    pub global: Global,
    #[command(subcommand)]
    pub command: Option<Command>,
}

/// Options of every command.
#[derive(Debug, Args)]
pub(super) struct Global {
    /// How to print results
    #[arg(long, global = true, value_name = "FORMAT", ignore_case = true, value_parser = format_names(),
          help = "How to print results; svg is for figures [default: text]")]
    pub format: Option<FormatArgument>,
    /// How to write polar forms
    #[arg(long, global = true, value_enum, default_value_t = NotationArgument::Grouped)]
    pub notation: NotationArgument,
    /// How to arrange formulas
    #[arg(long, global = true, default_value = "usual", value_name = "NAME",
          value_parser = one_of(Arrangement::ALL, Arrangement::name))]
    pub arrange: Arrangement,
    /// With the verdict of a claim, tell also which notations were read with their standard meaning
    #[arg(long, short = 'v', global = true)]
    pub verbose: bool,
    /// Only what is wrong: no verdicts of what is true, no notes, no numbers at the end
    #[arg(long, short = 'q', global = true, conflicts_with = "verbose")]
    pub quiet: bool,
    /// Break LaTeX that is wider, in points, or 0: never (345 if not given, the width of an article)
    #[arg(long, global = true, value_name = "POINTS")]
    pub width: Option<u16>,
    /// How wider LaTeX is broken: aligned (amsmath), multlined (mathtools), dmath (breqn)
    #[arg(long, global = true, default_value = "aligned", value_name = "NAME", hide_possible_values = true,
          value_parser = one_of(Breaks::ALL, Breaks::name))]
    pub breaks: Breaks,
    /// The language of derivations and of the titles of figures
    #[arg(long, global = true, default_value = "en", value_name = "LANG",
          value_parser = one_of(Language::ALL, Language::code))]
    pub lang: Language,
    /// Color of messages
    #[arg(long, global = true, value_enum, default_value_t = Color::Auto)]
    pub color: Color,
    /// Time allowed for each statement or formula of notes (0: no limit) [default: 60]
    #[arg(long, global = true, value_name = "SECONDS", allow_negative_numbers = true,
          value_parser = parse_seconds)]
    pub timeout: Option<f64>,
    /// Number of terms a value may have
    #[arg(long, global = true, default_value_t = 4_000_000, value_name = "N")]
    pub max_terms: u64,
    /// How deeply functions may call each other, at most 20000 (each call takes memory)
    #[arg(long, global = true, default_value_t = 400, value_name = "N",
        value_parser = clap::builder::RangedU64ValueParser::<usize>::new().range(..=MOST_DEPTH as u64))]
    pub max_depth: usize,
}

/// A format as it is asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum FormatArgument {
    /// One that all values have.
    Words(Format),
    /// A drawing.
    Svg,
}

/// One of some values by its name; help, errors and shells list the names.
fn one_of<T, const N: usize>(all: [T; N], name: fn(T) -> &'static str) -> impl TypedValueParser<Value = T>
where
    T: Copy + Send + Sync + 'static,
{
    let known =
        move |text: String| all.into_iter().find(|one| name(*one) == text).expect("it is one of them");
    PossibleValuesParser::new(all.map(name)).map(known)
}

fn format_names() -> impl TypedValueParser<Value = FormatArgument> {
    let names = Format::ALL.map(Format::name).into_iter().chain(["svg"]);
    // What is no name of a format is the one left.
    PossibleValuesParser::new(names)
        .map(|name| name.parse().map_or(FormatArgument::Svg, FormatArgument::Words))
}

fn parse_seconds(text: &str) -> Result<f64, String> {
    let seconds: Option<f64> = text.parse().ok();
    seconds
        .filter(|seconds| seconds.is_finite() && *seconds >= 0.0)
        .ok_or_else(|| "expected a number of seconds such as 2.5, or 0 for no limit".to_owned())
}

impl Global {
    /// The limits they ask for.
    pub fn limits(&self) -> Limits {
        self.limits_or(60.0)
    }

    /// The limits they ask for, with this many seconds if they say nothing about time.
    pub fn limits_or(&self, seconds: f64) -> Limits {
        let seconds = self.timeout.unwrap_or(seconds);
        let time = (seconds > 0.0).then(|| Duration::try_from_secs_f64(seconds).ok()).flatten();
        Limits { time, terms: self.max_terms, depth: self.max_depth, ..Limits::default() }
    }

    /// The format of formulas and values.
    pub fn format(&self) -> Format {
        match self.format {
            Some(FormatArgument::Words(format)) => format,
            Some(FormatArgument::Svg) | None => Format::Text,
        }
    }

    /// The notation for polar forms.
    pub fn notation(&self) -> Notation {
        match self.notation {
            NotationArgument::Grouped => Notation::Grouped,
            NotationArgument::Expanded => Notation::Expanded,
            NotationArgument::Sigma => Notation::Sigma,
            NotationArgument::Ellipsis => Notation::Ellipsis,
        }
    }
}

#[derive(Clone, Copy, Debug, ValueEnum)]
pub(super) enum NotationArgument {
    /// 5/3 (t1 + t2 + t3)
    Grouped,
    /// 5/3 t1 + 5/3 t2 + 5/3 t3
    Expanded,
    /// 5 sigma_{1,3}(t1, t2, t3)
    Sigma,
    /// 1/10 (t1 t2 + ... + t4 t5)
    Ellipsis,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
pub(super) enum Color {
    /// On a terminal
    Auto,
    /// Always
    Always,
    /// Never
    Never,
}

impl Color {
    /// Whether to color what goes to a terminal, or elsewhere.
    pub fn wanted(self, terminal: bool) -> bool {
        match self {
            Color::Always => true,
            Color::Never => false,
            Color::Auto => {
                let set = |name: &str| {
                    std::env::var_os(name).is_some_and(|value| !value.is_empty() && value != "0")
                };
                let is = |name: &str, value: &str| std::env::var_os(name).is_some_and(|own| own == value);
                if std::env::var_os("NO_COLOR").is_some() || is("CLICOLOR", "0") {
                    return false;
                }
                set("FORCE_COLOR") || set("CLICOLOR_FORCE") || (terminal && !is("TERM", "dumb"))
            }
        }
    }
}

#[derive(Debug, Subcommand)]
pub(super) enum Command {
    /// Evaluate expressions, one after the other
    #[command(after_help = "Example:\n  polarform eval \"F(t) := t^2 + 2t\" \"polar(F)(0, 1)\"")]
    Eval {
        /// Statements; ';' separates several in one argument
        #[arg(required = true, value_name = "EXPR", value_parser = formula)]
        statements: Vec<String>,
    },
    /// Run a script of statements
    Run {
        /// The file ('-' for standard input), or a folder: its files that end with .polar, each in a session of its own
        file: PathBuf,
        /// Stop at the first error
        #[arg(long)]
        stop: bool,
    },
    /// The polar form of a polynomial
    #[command(after_help = "Examples:\n  \
        polarform polar \"t^3 + 3t^2 + 5t + 1\"\n  \
        polarform polar \"t^2 + 2t\" --degree 3 --at \"0, 1/2, hat(1)\"\n  \
        polarform polar \"c_0 + c_1 t + c_2 t^2\" --method taylor --steps")]
    Polar(PolarArguments),
    /// The polar form of a sum F + G
    Sum(Two),
    /// The polar form of a product F G
    Product(Two),
    /// The polar form of a composition F(G(t))
    Compose(Two),
    /// The matrix between two polynomial bases
    #[command(after_help = "Examples:\n  \
        polarform matrix --degree 3                       A_3, Bézier points to powers\n  \
        polarform matrix --degree 3 --inverse\n  \
        polarform matrix --degree 2 --raise-to 3\n  \
        polarform matrix --degree 2 --interval r,s --format latex")]
    Matrix(MatrixArguments),
    /// A Bézier curve: values, de Casteljau's scheme, subdivision, degree, derivatives
    #[command(after_help = "Examples:\n  \
        polarform bezier \"[0, 0], [1, 2], [2, 0]\" --at 1/2\n  \
        polarform bezier \"b_0, b_1, b_2, b_3\" --scheme t --format latex\n  \
        polarform bezier \"[1, 0], [1, 1], [0, 1]\" --weights 1,1,2 --derivative 1")]
    Bezier(BezierArguments),
    /// A B-spline: basis functions, values, de Boor's scheme, knots in and out, Bézier pieces
    #[command(after_help = "Examples:\n  \
        polarform bspline --degree 2 --knots 0,1,2,3 --basis 0\n  \
        polarform bspline --degree 2 --knots 0,0,0,1,2,2,2 --points 1,3,2,4 --scheme 1/2\n  \
        polarform bspline --degree 3 --knots t_0,t_1,t_2,t_3,t_4,t_5,t_6,t_7 --points d_0,d_1,d_2,d_3 --scheme t --span 3")]
    Bspline(BsplineArguments),
    /// A polynomial or spline through points, or close to them
    #[command(after_help = "Examples:\n  \
        polarform interpolate --nodes 0,1,3 --values 1,3,2\n  \
        polarform interpolate --nodes 0,1,3 --values 1,3,2 --method newton --steps\n  \
        polarform interpolate --nodes 0,1 --values \"[0, 0], [1, 0]\" --method hermite\n  \
        polarform interpolate --nodes 0,1,2 --values 0,1,0 --method spline --ends not_a_knot\n  \
        polarform interpolate --nodes 0..3 --values 0,1,1,2 --method least-squares --degree 1")]
    Interpolate(Interpolate),
    /// Whether a claim such as "a = b" is true
    #[command(after_help = "Example:\n  \
        polarform check \"f(t1, t2) = t1 t2 + t1 + t2\" --given \"f := polar(t^2 + 2t)\"")]
    Check {
        /// The claim, in plain notation or LaTeX
        #[arg(allow_hyphen_values = true, value_parser = formula)]
        claim: String,
        /// Definitions the claim uses, in order
        #[arg(long, value_name = "DEF")]
        given: Vec<String>,
    },
    /// Draw a figure as SVG, TikZ, or in characters
    #[command(after_help = "Examples:\n  \
        polarform figure bezier \"[0,0], [1,2], [3,2]\" --at 1/2 -o curve.svg\n  \
        polarform figure bspline \"bspline(2, [0,0,0,1,2,2,2], [[0,0],[1,3],[4,3],[5,0]])\" -o spline.tex\n  \
        polarform figure basis 3\n  \
        polarform figure query \"beside(figure_basis(2), figure_basis(3))\" -o both.svg\n\n\
        Without -o, a terminal gets a preview and everything else SVG.\n\
        The queries are the arguments of the function figure_KIND; see polarform functions.")]
    Figure(FigureArguments),
    /// Check the formulas of lecture notes, or list them
    #[command(subcommand)]
    Notes(Notes),
    /// Fill results into lecture notes: Markdown, LaTeX, notebooks, books of mdBook
    #[command(after_help = "Examples:\n  \
        polarform weave lecture.md                 in place: {{ f(0, 1) }}, ```polarform blocks\n  \
        polarform weave lecture.md -o out.md       a copy with results only (- for standard output)\n  \
        polarform weave --check lectures           is everything up to date, also in folders?\n  \
        polarform weave lecture.tex                \\polarform{f(0, 1)}; then pdflatex lecture\n  \
        polarform weave --write-style .            the package polarform.sty\n\n\
        docs/weave.md tells the rest.\n\
        Exit status: 1 if a claim is refuted or, with --check, a result is out of date;\n\
        2 if a query failed: its old result stays; else 0.")]
    Weave(Weave),
    /// Serve an editor: verdicts on notes while they are written (Language Server Protocol)
    #[command(
        after_help = "An editor starts this command and speaks with it on standard input and output;\n\
        docs/tools.md tells how Neovim, Helix, Emacs and others are set up."
    )]
    Lsp {
        /// The only way there is; some editors ask for it
        #[arg(long)]
        stdio: bool,
    },
    /// Write completions for a shell
    #[command(after_help = "Examples:\n  \
        polarform completions bash > ~/.local/share/bash-completion/completions/polarform\n  \
        polarform completions zsh > ~/.zfunc/_polarform       (a folder of fpath)\n  \
        polarform completions fish > ~/.config/fish/completions/polarform.fish")]
    Completions {
        /// The shell
        shell: Shell,
    },
    /// Write the manual page of a command, or all of them into a folder
    #[command(after_help = "Examples:\n  \
        polarform man notes check | man -l -\n  \
        polarform man -o ~/.local/share/man/man1")]
    Man {
        /// The command (if not given: the program)
        #[arg(conflicts_with = "output")]
        command: Vec<String>,
        /// Write the pages of all commands into this folder
        #[arg(long, short, value_name = "FOLDER")]
        output: Option<PathBuf>,
    },
    /// Explain an error code such as E304
    Explain {
        /// The code; without one, all codes are listed
        code: Option<String>,
    },
    /// List the functions of the language, or tell about one
    Functions {
        /// A name
        name: Option<String>,
    },
}

/// Which polar form, and what of it.
#[derive(Debug, Args)]
pub(super) struct PolarArguments {
    /// The polynomial, in plain notation or LaTeX
    #[arg(allow_hyphen_values = true, value_parser = formula)]
    pub polynomial: String,
    /// The number of arguments (the degree of the polynomial if not given)
    #[arg(long, short = 'n', value_name = "N")]
    pub degree: Option<usize>,
    /// The variable, if there are several symbols
    #[arg(long, value_name = "NAME")]
    pub variable: Option<String>,
    /// How to derive it
    #[arg(long, value_parser = one_of(Method::ALL, Method::name), default_value = "elementary", value_name = "METHOD")]
    pub method: Method,
    /// The value at these arguments; hat(v) is a vector
    #[arg(long, value_name = "U1,U2,...", allow_hyphen_values = true, value_parser = formula)]
    pub at: Option<String>,
    /// Show the steps
    #[arg(long)]
    pub steps: bool,
}

/// Which matrix.
#[derive(Debug, Args)]
pub(super) struct MatrixArguments {
    /// The degree
    #[arg(long, short = 'n', value_name = "N")]
    pub degree: usize,
    /// The basis of the given coefficients: power, bernstein, or e.g. [lagrange, 0, 1/2, 1]
    #[arg(long, default_value = "bernstein", value_name = "BASIS")]
    pub from: String,
    /// The basis of the wanted coefficients
    #[arg(long, default_value = "power", value_name = "BASIS")]
    pub to: String,
    /// The inverse of that matrix
    #[arg(long)]
    pub inverse: bool,
    /// The interval of Bernstein bases
    #[arg(long, value_name = "A,B", allow_hyphen_values = true, value_parser = formula)]
    pub interval: Option<String>,
    /// The matrix from Bézier points of this degree to those of a higher one
    #[arg(long, value_name = "M", conflicts_with_all = ["from", "to", "interval", "inverse"])]
    pub raise_to: Option<usize>,
    /// Show the steps, from Bézier points to powers or back
    #[arg(long, conflicts_with_all = ["interval", "raise_to"])]
    pub steps: bool,
}

/// What to ask about a Bézier curve.
#[derive(Debug, Args)]
pub(super) struct BezierArguments {
    /// Control points: points such as [0, 1], numbers or symbols, separated by commas
    #[arg(allow_hyphen_values = true, value_parser = formula)]
    pub points: String,
    /// The interval (0 and 1 if not given)
    #[arg(long, value_name = "A,B", allow_hyphen_values = true, value_parser = formula)]
    pub interval: Option<String>,
    /// Weights, for a rational curve
    #[arg(long, value_name = "W,...", allow_hyphen_values = true, value_parser = formula)]
    pub weights: Option<String>,
    #[command(flatten)]
    pub change: Change,
    /// The value at a parameter
    #[arg(long, value_name = "T", allow_hyphen_values = true, value_parser = formula)]
    pub at: Option<String>,
    /// De Casteljau's scheme for a parameter, or for as many as the degree
    #[arg(long, value_name = "T,...", allow_hyphen_values = true, value_parser = formula, conflicts_with = "at")]
    pub scheme: Option<String>,
    /// The parts between these parameters
    #[arg(long, visible_alias = "split", value_name = "T,...", allow_hyphen_values = true, value_parser = formula,
          conflicts_with_all = ["at", "scheme"])]
    pub subdivide: Option<String>,
}

/// Changes to a curve, made in this order.
#[derive(Debug, Args)]
pub(super) struct Change {
    /// Raise the degree by K
    #[arg(long, value_name = "K")]
    pub elevate: Option<usize>,
    /// Lower the degree by K, where that is exact
    #[arg(long, value_name = "K")]
    pub reduce: Option<usize>,
    /// The derivative of order K
    #[arg(long, value_name = "K")]
    pub derivative: Option<usize>,
}

/// What to ask about a B-spline.
#[derive(Debug, Args)]
pub(super) struct BsplineArguments {
    /// Control points, also as --points
    #[arg(value_name = "POINTS", allow_hyphen_values = true, value_parser = formula, group = "control")]
    pub listed: Option<String>,
    /// The degree
    #[arg(long, short = 'n', value_name = "N")]
    pub degree: usize,
    /// The knots t_0, t_1, ..., all of them
    #[arg(long, value_name = "T,...", allow_hyphen_values = true, value_parser = formula)]
    pub knots: String,
    /// Control points: one less than the knots minus the degree
    #[arg(long, value_name = "D,...", allow_hyphen_values = true, value_parser = formula, group = "control",
          required_unless_present_any = ["basis", "listed"])]
    pub points: Option<String>,
    /// Weights, for a rational curve
    #[arg(long, value_name = "W,...", allow_hyphen_values = true, value_parser = formula, requires = "control")]
    pub weights: Option<String>,
    /// The basis function with this number, as a piecewise polynomial
    #[arg(long, value_name = "I", conflicts_with = "control")]
    pub basis: Option<usize>,
    /// Insert knots
    #[arg(long, value_name = "T,...", allow_hyphen_values = true, value_parser = formula)]
    pub insert: Option<String>,
    /// Remove a knot, where that is exact
    #[arg(long, value_name = "T", allow_hyphen_values = true, value_parser = formula)]
    pub remove: Option<String>,
    #[command(flatten)]
    pub change: Change,
    /// The value at a parameter
    #[arg(long, value_name = "T", allow_hyphen_values = true, value_parser = formula)]
    pub at: Option<String>,
    /// De Boor's scheme for a parameter, or for as many as the degree
    #[arg(long, value_name = "T,...", allow_hyphen_values = true, value_parser = formula, conflicts_with = "at")]
    pub scheme: Option<String>,
    /// The knot interval of --at, --scheme or --insert, if symbols hide it
    #[arg(long, value_name = "J")]
    pub span: Option<usize>,
    /// The Bézier curves of all knot intervals
    #[arg(long, conflicts_with_all = ["at", "scheme"])]
    pub pieces: bool,
    /// Each control point with its polar label
    #[arg(long, conflicts_with_all = ["at", "scheme", "pieces"])]
    pub labels: bool,
}

/// What to interpolate, and how.
#[derive(Debug, Args)]
pub(super) struct Interpolate {
    /// The nodes
    #[arg(long, value_name = "X0,X1,...", allow_hyphen_values = true, value_parser = formula)]
    pub nodes: String,
    /// Values at the nodes, points, or for hermite lists [f, f', ...]
    #[arg(long, value_name = "Y0,Y1,...", allow_hyphen_values = true, value_parser = formula)]
    pub values: String,
    /// How to interpolate
    #[arg(long, value_enum, default_value_t = Interpolation::Lagrange, value_name = "METHOD")]
    pub method: Interpolation,
    /// The value at this parameter
    #[arg(long, value_name = "T", allow_hyphen_values = true, value_parser = formula)]
    pub at: Option<String>,
    /// Ends of a spline: natural, clamped, periodic or not_a_knot
    #[arg(long, value_name = "ENDS")]
    pub ends: Option<String>,
    /// Slopes of a spline with clamped ends
    #[arg(long, value_name = "A,B", allow_hyphen_values = true, value_parser = formula)]
    pub slopes: Option<String>,
    /// Unknowns of the system of a spline: moments or slopes
    #[arg(long, value_name = "UNKNOWNS")]
    pub by: Option<String>,
    /// The degree for least squares
    #[arg(long, short = 'n', value_name = "N")]
    pub degree: Option<usize>,
    /// Weights for least squares
    #[arg(long, value_name = "W0,W1,...")]
    pub weights: Option<String>,
    /// The variable of the result
    #[arg(long, default_value = "t", value_name = "NAME")]
    pub variable: String,
    /// Show the table or system it is found by
    #[arg(long)]
    pub steps: bool,
}

/// Ways to interpolate.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Interpolation {
    /// The polynomial; its steps are the basis polynomials
    Lagrange,
    /// In Newton's form; its steps are the divided differences
    Newton,
    /// With derivatives; its steps are the divided differences
    Hermite,
    /// The polynomial; its steps are Neville's tableau
    Neville,
    /// The polynomial; its steps are Aitken's tableau
    Aitken,
    /// The cubic spline; its steps are the system of equations
    Spline,
    /// The closest polynomial of a degree; its steps are the normal equations
    LeastSquares,
}

/// How to weave.
#[derive(Debug, Args)]
pub(super) struct Weave {
    /// Files of notes (.md and the like, .tex, .ipynb), folders of them, '-' for standard input
    #[arg(required_unless_present_any = ["mdbook", "write_style"], value_name = "FILE")]
    pub files: Vec<PathBuf>,
    /// How standard input is written (if not given: as it looks)
    #[arg(long = "as", value_enum, value_name = "KIND")]
    pub kind: Option<PageKind>,
    /// Write a copy that holds results in place of queries ('-' for standard output)
    #[arg(long, short, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// Write nothing; tell what is out of date
    #[arg(long)]
    pub check: bool,
    /// Run all queries, even if nothing seems to have changed
    #[arg(long)]
    pub fresh: bool,
    /// Write the LaTeX package polarform.sty into a folder
    #[arg(long, value_name = "FOLDER", conflicts_with = "check")]
    pub write_style: Option<PathBuf>,
    /// Be a preprocessor of mdBook: read a book from standard input and write it woven
    #[arg(long, conflicts_with_all = ["output", "check", "write_style"])]
    pub mdbook: bool,
    /// With --mdbook: set formulas as MathML, which mdBook cannot break, and which needs no script
    #[arg(long, requires = "mdbook")]
    pub mathml: bool,
}

/// Two polynomials.
#[derive(Debug, Args)]
pub(super) struct Two {
    /// The first polynomial
    #[arg(allow_hyphen_values = true, value_parser = formula)]
    pub f: String,
    /// The second polynomial
    #[arg(allow_hyphen_values = true, value_parser = formula)]
    pub g: String,
    /// Show the steps
    #[arg(long)]
    pub steps: bool,
}
