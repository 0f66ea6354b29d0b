//! The arguments of `polarform figure`.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use super::script::formula;

/// A figure.
#[derive(Debug, Args)]
pub(super) struct FigureArguments {
    /// What to draw
    #[arg(value_enum)]
    pub kind: FigureKind,
    /// Curves, points, numbers: formulas of the language
    #[arg(required = true, value_name = "QUERY", allow_negative_numbers = true, value_parser = formula)]
    pub queries: Vec<String>,
    /// The file to write: .svg, .pdf, .png, .tex or .tikz, .txt, .json
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
