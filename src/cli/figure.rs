//! `polarform figure`: a figure function of the language, written as a file.

use std::io::{self, IsTerminal};
use std::path::Path;

use super::Status;
use super::argument_reader::{ArgumentReader, Failed};
use super::arguments::{FormatArgument, Global};
use super::commands::Ran;
use super::figure_arguments::{FigureArguments, FigureKind, ThemeArgument};
use super::output::{Output, PREVIEW, Trouble};
use super::raster;
use super::script::is_standard;
use crate::figure::{SvgOptions, Theme, TikzOptions, figure_json, svg, terminal, tikz};
use crate::formula::source::Span;
use crate::formula::{Expr, Kind, call, named};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::value::Value;
use crate::language::write::Format;
use crate::scene::Scene;
use crate::session::Session;
use crate::weave::write_file;

/// What is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Target {
    Svg,
    Tikz,
    Preview,
    Json,
    Png,
    Pdf,
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
    session.give(&arguments.given)?;
    let mut reader = ArgumentReader::new(output);
    let query = query(&mut reader, arguments)?;
    let whole = query.span;
    let value = reader.evaluate(session, query)?;
    let Value::Figure(scene) = &value else {
        let problem = Diagnostic::error(Code::Type, format!("this is no figure but {}", value.kind()))
            .at(whole)
            .hint("polarform functions lists the functions that draw");
        return Err(reader.failure(problem).into());
    };
    let scene = changed((**scene).clone().in_language(output.language.code()), arguments);
    let drawing = output.limited(|| draw(&scene, target, arguments))?;
    let drawing = drawing.map_err(|problem| Trouble::Problem(Box::new(problem)))?;
    match arguments.output.as_deref().filter(|path| !is_standard(path)) {
        Some(path) => write_file(path, &drawing).map_err(|problem| Trouble::Problem(Box::new(problem)))?,
        None => output.bytes(&drawing)?,
    }
    Ok(Status::Fine)
}

fn draw(scene: &Scene, target: Target, arguments: &FigureArguments) -> Result<Vec<u8>, Diagnostic> {
    let theme = match arguments.theme {
        ThemeArgument::Auto => Theme::Auto,
        ThemeArgument::Light => Theme::Light,
        ThemeArgument::Dark => Theme::Dark,
    };
    // Paper and pixels do not change their colours.
    let fixed = if theme == Theme::Auto { Theme::Light } else { theme };
    Ok(match target {
        Target::Svg => svg(scene, &SvgOptions { theme, background: arguments.standalone }).into_bytes(),
        Target::Tikz => tikz(scene, &TikzOptions { standalone: arguments.standalone }).into_bytes(),
        Target::Preview => terminal(scene, PREVIEW.0, PREVIEW.1).into_bytes(),
        Target::Json => (figure_json(scene).to_string() + "\n").into_bytes(),
        Target::Png => raster::png(&svg(scene, &SvgOptions { theme: fixed, background: true }))?,
        Target::Pdf => {
            raster::pdf(&svg(scene, &SvgOptions { theme: fixed, background: arguments.standalone }))?
        }
    })
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
        Some("png") => Ok(Target::Png),
        Some("pdf") => Ok(Target::Pdf),
        other => {
            let name = path.display();
            let message = match other {
                Some(other) => format!("{name}: no figures are written as .{other}"),
                None => format!("{name}: the name has no ending that says how to write the figure"),
            };
            Err(Diagnostic::error(Code::Usage, message)
                .hint("use .svg, .pdf, .png, .tex, .tikz, .txt or .json, or say --format"))
        }
    }
}

/// The query of the language.
fn query(reader: &mut ArgumentReader, arguments: &FigureArguments) -> Failed<Expr> {
    let mut parts = Vec::with_capacity(arguments.queries.len());
    let mut whole = Span::default();
    for (i, query) in arguments.queries.iter().enumerate() {
        let name = match arguments.queries.len() {
            1 => "query".to_owned(),
            _ => format!("query {}", i + 1),
        };
        parts.extend(part(reader, &name, query, arguments.kind)?);
        if i == 0 {
            whole = reader.last_span();
        }
    }
    let Some(function) = arguments.kind.function() else {
        return Ok(match parts.len() {
            1 => parts.remove(0),
            _ => Expr::new(Kind::Sequence(parts), whole),
        });
    };
    if let Some(at) = &arguments.at {
        parts.push(named("at", reader.list("at", at)?));
    }
    for (wanted, option, name, value) in [
        (arguments.hull, "hull", "hull", 1),
        (arguments.no_polygon, "no-polygon", "polygon", 0),
        (arguments.bezier_points, "bezier-points", "bezier", 1),
        (arguments.no_weights, "no-weights", "weights", 0),
    ] {
        if wanted {
            parts.push(named(name, reader.flag(option, value)));
        }
    }
    if let Some(labels) = arguments.labels {
        parts.push(named("labels", reader.word("labels", labels.word())));
    }
    if let Some(apex) = arguments.apex {
        parts.push(named("apex", reader.word("apex", apex.word())));
    }
    if let Some(order) = arguments.order {
        parts.push(named("order", reader.number("order", order)));
    }
    Ok(call(function, parts, whole))
}

/// One query as it stands in the call: points without brackets around them become a list.
fn part(reader: &mut ArgumentReader, name: &str, text: &str, kind: FigureKind) -> Failed<Vec<Expr>> {
    if !kind.takes_points() {
        let formula = reader.formula(name, text)?;
        return Ok(match formula.kind {
            Kind::Sequence(items) => items,
            _ => vec![formula],
        });
    }
    let items = reader.items(name, text)?;
    // Calls make curves; anything else is a point or an ordinate.
    Ok(if items.len() > 1 && items.iter().all(|item| !matches!(item.kind, Kind::Apply(..))) {
        vec![Expr::new(Kind::List(items), reader.last_span())]
    } else {
        items
    })
}
