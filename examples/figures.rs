//! One picture of each kind; with a folder as argument, they are written there as SVG and TikZ.
#![allow(clippy::print_stdout)]

#[path = "../tests/common/pictures.rs"]
mod pictures;

use std::error::Error;
use std::path::PathBuf;
use std::{env, fs};

use polarform::figure::{SvgOptions, Theme, TikzOptions, svg, terminal, tikz};

fn main() -> Result<(), Box<dyn Error>> {
    let folder = env::args_os().nth(1).map(PathBuf::from);
    for (name, scene) in pictures::standard()? {
        println!("{name}: {}", scene.description());
        let Some(folder) = &folder else {
            println!("{}", terminal(&scene, 60, 16));
            continue;
        };
        fs::create_dir_all(folder)?;
        for (theme, ending) in [(Theme::Auto, "svg"), (Theme::Light, "light.svg"), (Theme::Dark, "dark.svg")]
        {
            let options = SvgOptions { theme, background: theme != Theme::Auto };
            fs::write(folder.join(format!("{name}.{ending}")), svg(&scene, &options))?;
        }
        let options = TikzOptions { standalone: true };
        fs::write(folder.join(format!("{name}.tex")), tikz(&scene, &options))?;
    }
    Ok(())
}
