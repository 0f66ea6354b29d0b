//! The `polarform` program.

fn main() -> std::process::ExitCode {
    polarform::cli::main()
}
