//! `polarform figure`: a figure function of the language, written as a file.

use std::fmt::Write as _;
use std::io::{self, IsTerminal};
use std::path::Path;

use super::Status;
use super::arguments::{FormatArgument, Global};
use super::commands::{Ran, evaluated, formula, give};
use super::figure_arguments::{FigureArguments, FigureKind, ThemeArgument};
use super::output::{Output, PREVIEW, Trouble};
use crate::figure::{SvgOptions, Theme, TikzOptions, figure_json, svg, terminal, tikz};
use crate::formula::Kind;
use crate::formula::source::{SourceFile, Span};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::syntax;
use crate::language::value::Value;
use crate::language::write::{Format, text};
use crate::scene::Scene;
use crate::session::{Failure, Session};
use crate::weave::write_file;

/// What is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Target {
    Svg,
    Tikz,
    Preview,
    Json,
}

/// Draws one figure.
pub(super) fn run(
    arguments: &FigureArguments,
    global: &Global,
    session: &mut Session,
    output: &Output,
) -> Ran {
    // What cannot be written is refused before anything is computed.
    let target = target(arguments, global.format)?;
    give(session, &arguments.given)?;
    let query = SourceFile::new("<figure>", query(arguments)?);
    let mut expr = formula(&query)?;
    expr.span = Span::new(0, query.text().len());
    let value = evaluated(session, &query, expr)?;
    let Value::Figure(scene) = &value else {
        let problem = Diagnostic::error(Code::Type, format!("this is no figure but {}", value.kind()))
            .at(Span::new(0, query.text().len()))
            .hint("polarform functions lists the functions that draw");
        return Err(Box::new(Failure { problem, file: query }).into());
    };
    let scene = changed((**scene).clone(), arguments);
    let drawing = output.limited(|| draw(&scene, target, arguments))?;
    match &arguments.output {
        Some(path) => write_file(path, &drawing).map_err(|problem| Trouble::Problem(Box::new(problem)))?,
        None => output.text(&drawing)?,
    }
    Ok(Status::Fine)
}

fn draw(scene: &Scene, target: Target, arguments: &FigureArguments) -> String {
    match target {
        Target::Svg => {
            let theme = match arguments.theme {
                ThemeArgument::Auto => Theme::Auto,
                ThemeArgument::Light => Theme::Light,
                ThemeArgument::Dark => Theme::Dark,
            };
            svg(scene, &SvgOptions { theme, background: arguments.standalone })
        }
        Target::Tikz => tikz(scene, &TikzOptions { standalone: arguments.standalone }),
        Target::Preview => terminal(scene, PREVIEW.0, PREVIEW.1),
        Target::Json => figure_json(scene).to_string() + "\n",
    }
}

/// Width and words, which need no quotation marks here.
fn changed(mut scene: Scene, arguments: &FigureArguments) -> Scene {
    if let Some(width) = arguments.width {
        scene = scene.with_width(f64::from(width));
    }
    if let Some(title) = &arguments.title {
        scene = scene.with_title(title.as_str());
    }
    if let Some(caption) = &arguments.caption {
        scene = scene.with_caption(caption.as_str());
    }
    scene
}

/// The format asked for, that of the output file, or what suits standard output.
fn target(arguments: &FigureArguments, format: Option<FormatArgument>) -> Result<Target, Trouble> {
    match format {
        Some(FormatArgument::Svg) => return Ok(Target::Svg),
        Some(FormatArgument::Words(Format::Latex)) => return Ok(Target::Tikz),
        Some(FormatArgument::Words(Format::Json)) => return Ok(Target::Json),
        Some(FormatArgument::Words(Format::Text | Format::Unicode)) => return Ok(Target::Preview),
        Some(FormatArgument::Words(Format::Sympy)) => {
            let problem = Diagnostic::error(Code::Usage, "a figure has no form in SymPy");
            let problem = problem.hint("--format svg, latex (for TikZ), text or json");
            return Err(Trouble::Problem(Box::new(problem)));
        }
        None => {}
    }
    match &arguments.output {
        Some(path) => by_extension(path).map_err(|problem| Trouble::Problem(Box::new(problem))),
        None if io::stdout().is_terminal() => Ok(Target::Preview),
        None => Ok(Target::Svg),
    }
}

fn by_extension(path: &Path) -> Result<Target, Diagnostic> {
    let extension = path.extension().map(|e| e.to_string_lossy().to_ascii_lowercase());
    match extension.as_deref() {
        Some("svg") => Ok(Target::Svg),
        Some("tex" | "tikz" | "pgf") => Ok(Target::Tikz),
        Some("txt") => Ok(Target::Preview),
        Some("json") => Ok(Target::Json),
        other => {
            let name = path.display();
            let message = match other {
                Some(other) => format!("{name}: no figures are written as .{other}"),
                None => format!("{name}: the name has no ending that says how to write the figure"),
            };
            Err(Diagnostic::error(Code::Usage, message)
                .hint("use .svg, .tex, .tikz, .txt or .json, or say --format"))
        }
    }
}

/// The query of the language, written out, so that what is wrong is shown in it.
fn query(arguments: &FigureArguments) -> Result<String, Box<Failure>> {
    let mut parts = Vec::with_capacity(arguments.queries.len());
    for (i, query) in arguments.queries.iter().enumerate() {
        let name = match arguments.queries.len() {
            1 => "<query>".to_owned(),
            _ => format!("<query {}>", i + 1),
        };
        parts.push(part(&SourceFile::new(name, query.as_str()), arguments.kind)?);
    }
    let Some(function) = arguments.kind.function() else {
        return Ok(parts.join(", "));
    };
    if let Some(at) = &arguments.at {
        let at = part(&SourceFile::new("<at>", at.as_str()), FigureKind::Query)?;
        parts.push(format!("at=[{at}]"));
    }
    let flags = [
        (arguments.hull, "hull=1"),
        (arguments.no_polygon, "polygon=0"),
        (arguments.bezier_points, "bezier=1"),
        (arguments.no_weights, "weights=0"),
    ];
    parts.extend(flags.iter().filter(|(wanted, _)| *wanted).map(|(_, flag)| (*flag).to_owned()));
    if let Some(labels) = arguments.labels {
        parts.push(format!("labels={}", labels.word()));
    }
    if let Some(apex) = arguments.apex {
        parts.push(format!("apex={}", apex.word()));
    }
    if let Some(order) = arguments.order {
        parts.push(format!("order={order}"));
    }
    let mut query = String::new();
    let _ = write!(query, "{function}({})", parts.join(", "));
    Ok(query)
}

/// One query as it stands in the call: LaTeX becomes plain notation, and points without brackets
/// around them become a list.
fn part(file: &SourceFile, kind: FigureKind) -> Result<String, Box<Failure>> {
    let expr = formula(file)?;
    let plain =
        if syntax::looks_like_latex(file.text()) { text(&expr) } else { file.text().trim().to_owned() };
    let points = match &expr.kind {
        Kind::Sequence(items) => {
            // Calls make curves; anything else is a point or an ordinate.
            items.iter().all(|item| !matches!(item.kind, Kind::Apply(..)))
        }
        _ => false,
    };
    Ok(if points && kind.takes_points() { format!("[{plain}]") } else { plain })
}
