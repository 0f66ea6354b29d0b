//! The arguments of the command line.

use std::num::NonZeroUsize;
use std::path::PathBuf;
use std::time::Duration;

use clap::{Args, Parser, Subcommand, ValueEnum};

use crate::blossom::Method;
use crate::budget::Limits;
use crate::value::Notation;
use crate::write::Format;

const EXAMPLES: &str = "\
Examples:
  polarform polar \"t^3 + 3t^2 + 5t + 1\"
  polarform polar \"t^2\" --degree 3 --format latex
  polarform product \"t^2 + 2t\" \"t^3 + 1\"
  polarform check \"f(0,1) = 1/2\" --given \"f := polar(t^2 + t)\"
  polarform eval \"f := polar(t^3)\" \"f(0, 1, hat(1))\"

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
    #[arg(long, global = true, value_name = "FORMAT", value_parser = parse_format,
          help = "Output: text, unicode, latex, json or sympy; for figures also svg [default: text]")]
    pub format: Option<FormatArgument>,
    /// How to write polar forms
    #[arg(long, global = true, value_enum, default_value_t = NotationArgument::Grouped)]
    pub notation: NotationArgument,
    /// Color of messages
    #[arg(long, global = true, value_enum, default_value_t = Color::Auto)]
    pub color: Color,
    /// Time allowed for each statement (0: no limit) [default: 60; 5 for a formula of notes]
    #[arg(long, global = true, value_name = "SECONDS")]
    pub timeout: Option<f64>,
    /// Number of terms a value may have
    #[arg(long, global = true, default_value_t = 4_000_000, value_name = "N")]
    pub max_terms: u64,
    /// How deeply functions may call each other
    #[arg(long, global = true, default_value_t = 400, value_name = "N")]
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

fn parse_format(text: &str) -> Result<FormatArgument, String> {
    if text == "svg" {
        return Ok(FormatArgument::Svg);
    }
    text.parse().map(FormatArgument::Words).map_err(|error: crate::write::UnknownFormat| error.to_string())
}

fn parse_method(text: &str) -> Result<Method, String> {
    text.parse()
}

impl Global {
    /// The limits they ask for.
    pub fn limits(&self) -> Limits {
        self.limits_or(60.0)
    }

    /// The limits they ask for, with this many seconds if they say nothing about time.
    pub fn limits_or(&self, seconds: f64) -> Limits {
        let seconds = self.timeout.unwrap_or(seconds);
        let time = (seconds > 0.0 && seconds.is_finite())
            .then(|| Duration::try_from_secs_f64(seconds).ok())
            .flatten();
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
            Color::Auto => terminal && std::env::var_os("NO_COLOR").is_none(),
        }
    }
}

#[derive(Debug, Subcommand)]
pub(super) enum Command {
    /// Evaluate expressions, one after the other
    #[command(after_help = "Example:\n  polarform eval \"F(t) := t^2 + 2t\" \"polar(F)(0, 1)\"")]
    Eval {
        /// Statements; ';' separates several in one argument
        #[arg(required = true, value_name = "EXPR")]
        statements: Vec<String>,
    },
    /// Run a script of statements
    Run {
        /// The file ('-' for standard input)
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
    Polar {
        /// The polynomial, in plain notation or LaTeX
        #[arg(allow_hyphen_values = true)]
        polynomial: String,
        /// The number of arguments (the degree of the polynomial if not given)
        #[arg(long, short = 'n', value_name = "N")]
        degree: Option<usize>,
        /// The variable, if there are several symbols
        #[arg(long, value_name = "NAME")]
        variable: Option<String>,
        /// How to derive it
        #[arg(long, value_parser = parse_method, default_value = "elementary", value_name = "METHOD",
              help = "elementary, probability, taylor, parts, laguerre or bezier")]
        method: Method,
        /// The value at these arguments; hat(v) is a vector
        #[arg(long, value_name = "U1,U2,...", allow_hyphen_values = true)]
        at: Option<String>,
        /// Show the steps
        #[arg(long)]
        steps: bool,
    },
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
    Matrix {
        /// The degree
        #[arg(long, short = 'n', value_name = "N")]
        degree: usize,
        /// The basis of the given coefficients: power, bernstein, or e.g. [lagrange, 0, 1/2, 1]
        #[arg(long, default_value = "bernstein", value_name = "BASIS")]
        from: String,
        /// The basis of the wanted coefficients
        #[arg(long, default_value = "power", value_name = "BASIS")]
        to: String,
        /// The inverse of that matrix
        #[arg(long)]
        inverse: bool,
        /// The interval of Bernstein bases
        #[arg(long, value_name = "A,B", allow_hyphen_values = true)]
        interval: Option<String>,
        /// The matrix from Bézier points of this degree to those of a higher one
        #[arg(long, value_name = "M", conflicts_with_all = ["from", "to", "interval", "inverse"])]
        raise_to: Option<usize>,
    },
    /// Whether a claim such as "a = b" is true
    #[command(after_help = "Example:\n  \
        polarform check \"f(t1, t2) = t1 t2 + t1 + t2\" --given \"f := polar(t^2 + 2t)\"")]
    Check {
        /// The claim, in plain notation or LaTeX
        #[arg(allow_hyphen_values = true)]
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
        polarform weave --check lecture.md         is everything up to date?\n  \
        polarform weave lecture.tex                \\polarform{f(0, 1)}; then pdflatex lecture\n  \
        polarform weave --write-style .            the package polarform.sty\n\n\
        docs/weave.md tells the rest.\n\
        Exit status: 1 if a claim is refuted or, with --check, a result is out of date;\n\
        2 if a query failed: its old result stays; else 0.")]
    Weave(Weave),
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

/// What to do with lecture notes.
#[derive(Debug, Subcommand)]
pub(super) enum Notes {
    /// A verdict for every formula: Markdown, LaTeX or Jupyter notebooks
    #[command(after_help = "Examples:\n  \
        polarform notes check lecture.md\n  \
        polarform notes check lectures/*.tex --context definitions.txt\n  \
        polarform notes check lecture.md -o report.html --watch\n\n\
        Exit status: 1 if a formula is refuted, else 2 if a file could not be read, else 0.")]
    Check(NotesCheck),
    /// The formulas as they are read, printed anew as LaTeX
    List {
        /// Files of notes
        #[arg(required = true, value_name = "FILE")]
        files: Vec<PathBuf>,
        /// Files read at the same time (as many as there are processors if not given)
        #[arg(long, short = 'j', value_name = "N")]
        jobs: Option<NonZeroUsize>,
    },
}

/// How to check lecture notes.
#[derive(Debug, Args)]
pub(super) struct NotesCheck {
    /// Files of notes
    #[arg(required = true, value_name = "FILE")]
    pub files: Vec<PathBuf>,
    /// Declarations for all files: definitions, degrees, ranges, in the query language
    #[arg(long, value_name = "FILE")]
    pub context: Option<PathBuf>,
    /// A line for every formula
    #[arg(long, short)]
    pub verbose: bool,
    /// The kind of report (if not given: by the name of the output file, else text)
    #[arg(long, value_enum, value_name = "KIND")]
    pub report: Option<ReportKind>,
    /// Write the report to a file, and only a summary to standard output
    #[arg(long, short, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// Check again whenever a file changes, until Ctrl-C
    #[arg(long, short)]
    pub watch: bool,
    /// Files checked at the same time (as many as there are processors if not given)
    #[arg(long, short = 'j', value_name = "N")]
    pub jobs: Option<NonZeroUsize>,
}

/// How to report on lecture notes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum ReportKind {
    /// For a terminal
    Text,
    /// For programs
    Json,
    /// SARIF 2.1.0, for code hosts and editors
    Sarif,
    /// A page for a browser
    Html,
}

/// How to weave.
#[derive(Debug, Args)]
pub(super) struct Weave {
    /// Files of notes: .md and the like, .tex, .ipynb
    #[arg(required_unless_present_any = ["mdbook", "write_style"], value_name = "FILE")]
    pub files: Vec<PathBuf>,
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
}

/// A figure.
#[derive(Debug, Args)]
pub(super) struct FigureArguments {
    /// What to draw
    #[arg(value_enum)]
    pub kind: FigureKind,
    /// Curves, points, numbers: formulas of the language
    #[arg(required = true, value_name = "QUERY", allow_hyphen_values = true)]
    pub queries: Vec<String>,
    /// The file to write: .svg, .tex or .tikz, .txt, .json
    #[arg(long, short, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// Definitions the queries use, in order
    #[arg(long, value_name = "DEF")]
    pub given: Vec<String>,
    /// The width in pixels
    #[arg(long, value_name = "PX", value_parser = clap::value_parser!(u16).range(80..=10_000))]
    pub width: Option<u16>,
    /// The colors of SVG: for any page, a white or a dark one
    #[arg(long, value_enum, default_value_t = ThemeArgument::Auto)]
    pub theme: ThemeArgument,
    /// To stand alone: SVG with its own paper, TikZ as a whole document
    #[arg(long)]
    pub standalone: bool,
    /// What the figure shows, for those who cannot see it
    #[arg(long, value_name = "WORDS")]
    pub title: Option<String>,
    /// Words below the figure
    #[arg(long, value_name = "WORDS")]
    pub caption: Option<String>,
    /// What is written at points
    #[arg(long, value_enum, value_name = "LABELS")]
    pub labels: Option<LabelsArgument>,
    /// Parameters whose points are marked (bezier)
    #[arg(long, value_name = "T1,T2,...", allow_hyphen_values = true)]
    pub at: Option<String>,
    /// Shade the convex hull of the control points (bezier)
    #[arg(long)]
    pub hull: bool,
    /// Without control polygon or net (bezier, patch, triangle)
    #[arg(long)]
    pub no_polygon: bool,
    /// Mark the Bézier points of the pieces (bspline)
    #[arg(long)]
    pub bezier_points: bool,
    /// Up to which derivative the construction is shown (continuity)
    #[arg(long, value_name = "K")]
    pub order: Option<usize>,
    /// Where the last level is (pyramid)
    #[arg(long, value_enum, value_name = "SIDE")]
    pub apex: Option<ApexArgument>,
    /// Without factors at the arrows (pyramid)
    #[arg(long)]
    pub no_weights: bool,
}

/// What to draw.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum FigureKind {
    /// Bézier curves: curves, or lists of points
    Bezier,
    /// De Casteljau's algorithm: a curve and a parameter
    Casteljau,
    /// A spline with its knots
    Bspline,
    /// Bernstein polynomials: a degree; B-splines: a degree and knots
    Basis,
    /// Graphs: a list of functions, and an interval
    Functions,
    /// A surface: rows of points, or of heights
    Patch,
    /// A triangular surface: a degree or points, and the names of the corners
    Triangle,
    /// How smoothly two curves join
    Continuity,
    /// A scheme: a curve and a parameter, or nodes and values
    Pyramid,
    /// A curve and its derivative
    Hodograph,
    /// Any formula that gives a figure
    Query,
}

impl FigureKind {
    /// The function of the language that draws it.
    pub fn function(self) -> Option<&'static str> {
        Some(match self {
            FigureKind::Bezier => "figure_bezier",
            FigureKind::Casteljau => "figure_casteljau",
            FigureKind::Bspline => "figure_bspline",
            FigureKind::Basis => "figure_basis",
            FigureKind::Functions => "figure_functions",
            FigureKind::Patch => "figure_patch",
            FigureKind::Triangle => "figure_triangle",
            FigureKind::Continuity => "figure_continuity",
            FigureKind::Pyramid => "figure_pyramid",
            FigureKind::Hodograph => "figure_hodograph",
            FigureKind::Query => return None,
        })
    }

    /// Whether points side by side are one argument, their list.
    pub fn takes_points(self) -> bool {
        matches!(
            self,
            FigureKind::Bezier
                | FigureKind::Casteljau
                | FigureKind::Patch
                | FigureKind::Triangle
                | FigureKind::Continuity
                | FigureKind::Hodograph
        )
    }
}

/// The colors of a figure.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub(super) enum ThemeArgument {
    /// As the reader prefers
    Auto,
    /// For white pages
    Light,
    /// For dark pages
    Dark,
}

/// What is written at points.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub(super) enum LabelsArgument {
    /// Values of the polar form, f(0, 0, 1)
    Polar,
    /// Names, b_1
    Points,
    /// Coordinates
    Values,
    /// Nothing
    None,
}

impl LabelsArgument {
    /// The word of the language.
    pub fn word(self) -> &'static str {
        match self {
            LabelsArgument::Polar => "polar",
            LabelsArgument::Points => "points",
            LabelsArgument::Values => "values",
            LabelsArgument::None => "none",
        }
    }
}

/// Where the last level of a scheme is.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub(super) enum ApexArgument {
    /// On the right
    Right,
    /// At the top
    Top,
    /// At the bottom
    Bottom,
}

impl ApexArgument {
    /// The word of the language.
    pub fn word(self) -> &'static str {
        match self {
            ApexArgument::Right => "right",
            ApexArgument::Top => "top",
            ApexArgument::Bottom => "bottom",
        }
    }
}

/// Two polynomials.
#[derive(Debug, Args)]
pub(super) struct Two {
    /// The first polynomial
    #[arg(allow_hyphen_values = true)]
    pub f: String,
    /// The second polynomial
    #[arg(allow_hyphen_values = true)]
    pub g: String,
    /// Show the steps
    #[arg(long)]
    pub steps: bool,
}
