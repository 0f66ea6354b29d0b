//! Formula trees as text, Unicode, LaTeX and SymPy syntax.
