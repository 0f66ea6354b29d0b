//! LaTeX as authors write it: text to formula tree.
pub fn read(_text: &str) -> Result<crate::expr::Expr, crate::diagnostic::Diagnostic> {
    Err(crate::diagnostic::Diagnostic::error(crate::diagnostic::Code::UnsupportedLatex, "not yet"))
}
