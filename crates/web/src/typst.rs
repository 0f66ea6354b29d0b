//! Formulas as Typst writes them.
//!
//! What is written comes from the LaTeX of the library, which is a small part of that language: whatever else is met gives
//! `None`, and the formula is shown as text. Signs that mean something to Typst (`,` `;` `/` between arguments) are
//! written by their names, so that a formula reads the same wherever it stands.

use polarform::language::lexicon::letters;

/// Commands that stand for a sign.
const SIGNS: &[(&str, &str)] = &[
    ("cdot", "⋅"),
    ("cdots", "⋯"),
    ("ldots", "…"),
    ("dots", "…"),
    ("times", "×"),
    ("le", "≤"),
    ("leq", "≤"),
    ("ge", "≥"),
    ("geq", "≥"),
    ("ne", "≠"),
    ("neq", "≠"),
    ("in", "∈"),
    ("notin", "∉"),
    ("sum", "∑"),
    ("prod", "∏"),
    ("int", "∫"),
    ("partial", "∂"),
    ("infty", "∞"),
    ("to", "→"),
    ("mapsto", "↦"),
    ("circ", "∘"),
    ("cup", "∪"),
    ("cap", "∩"),
    ("bigcup", "⋃"),
    ("bigcap", "⋂"),
    ("setminus", "∖"),
    ("subseteq", "⊆"),
    ("equiv", "≡"),
    ("approx", "≈"),
    ("pm", "±"),
    ("Rightarrow", "⇒"),
    ("Leftrightarrow", "⇔"),
    ("forall", "∀"),
    ("otimes", "⊗"),
    ("oplus", "⊕"),
    ("mid", "∣"),
    ("lvert", "|"),
    ("rvert", "|"),
    ("lVert", "‖"),
    ("rVert", "‖"),
    ("lfloor", "⌊"),
    ("rfloor", "⌋"),
    ("lceil", "⌈"),
    ("rceil", "⌉"),
    ("colon", ":"),
    ("quad", "quad"),
    ("qquad", "wide"),
    ("min", "min"),
    ("max", "max"),
    ("lim", "lim"),
    ("{", "\\{"),
    ("}", "\\}"),
    ("|", "‖"),
];

/// Commands with an argument, as functions of Typst.
const FUNCTIONS: &[(&str, &str)] = &[
    ("sqrt", "sqrt"),
    ("hat", "hat"),
    ("widehat", "hat"),
    ("bar", "macron"),
    ("overline", "overline"),
    ("tilde", "tilde"),
    ("widetilde", "tilde"),
    ("vec", "arrow"),
    ("overrightarrow", "arrow"),
    ("dot", "dot"),
    ("ddot", "dot.double"),
    ("mathbb", "bb"),
    ("mathbf", "bold"),
    ("boldsymbol", "bold"),
    ("mathcal", "cal"),
];

/// Commands that change nothing here.
const SILENT: &[&str] = &[
    "left",
    "right",
    "big",
    "bigl",
    "bigr",
    "Big",
    "Bigl",
    "Bigr",
    "limits",
    ",",
    ";",
    ":",
    "!",
    " ",
    "displaystyle",
];

/// A formula of the library's LaTeX for math mode of Typst.
pub(crate) fn typst(latex: &str) -> Option<String> {
    let mut reader = Reader { rest: latex };
    let written = reader.until(None)?;
    reader.rest.is_empty().then(|| written.trim().to_owned())
}

struct Reader<'a> {
    rest: &'a str,
}

impl<'a> Reader<'a> {
    fn next(&mut self) -> Option<char> {
        let c = self.rest.chars().next()?;
        self.rest = self.rest.get(c.len_utf8()..)?;
        Some(c)
    }

    fn take(&mut self, wanted: impl Fn(char) -> bool) -> &'a str {
        let end = self.rest.find(|c| !wanted(c)).unwrap_or(self.rest.len());
        let (taken, rest) = self.rest.split_at(end);
        self.rest = rest;
        taken
    }

    /// All up to the closing brace, or to the end of an environment, whose cells stand apart.
    fn until(&mut self, close: Option<char>) -> Option<String> {
        let mut out = String::new();
        loop {
            match self.rest.chars().next() {
                None => return close.is_none().then_some(out),
                Some('}') if close == Some('}') => {
                    self.next();
                    return Some(out);
                }
                Some('}') => return None,
                Some('&') if close == Some('&') => return Some(out),
                Some('&') => return None,
                _ if close == Some('&')
                    && (self.rest.starts_with("\\\\") || self.rest.starts_with("\\end")) =>
                {
                    return Some(out);
                }
                _ => self.item(&mut out)?,
            }
        }
    }

    fn item(&mut self, out: &mut String) -> Option<()> {
        let mut put = |word: &str| {
            out.push_str(word);
            out.push(' ');
        };
        match self.next()? {
            '{' => {
                let inner = self.until(Some('}'))?;
                put(&inner);
            }
            c @ ('_' | '^') => {
                let inner = self.argument()?;
                out.truncate(out.trim_end().len());
                out.push_str(&format!("{c}({}) ", inner.trim()));
            }
            '\'' => {
                out.truncate(out.trim_end().len());
                out.push_str("' ");
            }
            '\\' => self.command(out)?,
            ',' => put("comma"),
            ';' => put("semi"),
            '/' => put("slash"),
            c if c.is_ascii_digit() => {
                let more = self.take(|c| c.is_ascii_digit() || c == '.');
                put(&format!("{c}{more}"));
            }
            c if c.is_whitespace() => {}
            '#' | '$' | '"' | '~' | '`' | '@' => return None,
            c if c.is_ascii() || c.is_alphabetic() && !letters::is_ideograph(c) => put(&c.to_string()),
            c => put(&format!("\"{c}\"")),
        }
        Some(())
    }

    /// A braced group, a command or a single sign.
    fn argument(&mut self) -> Option<String> {
        self.take(char::is_whitespace);
        if self.rest.starts_with('{') {
            self.next();
            return self.until(Some('}'));
        }
        let mut out = String::new();
        match self.rest.chars().next()? {
            c if c.is_ascii_digit() => out.push(self.next()?),
            _ => self.item(&mut out)?,
        }
        Some(out)
    }

    /// The words of a group, as they stand there.
    fn words(&mut self) -> Option<String> {
        self.rest = self.rest.strip_prefix('{')?;
        let mut words = String::new();
        loop {
            match self.next()? {
                '}' => return Some(words),
                '{' | '$' => return None,
                '\\' => match self.next()? {
                    c @ ('_' | '#' | '%' | '&' | '$' | '{' | '}' | ' ') => words.push(c),
                    _ => return None,
                },
                c => words.push(c),
            }
        }
    }

    fn command(&mut self, out: &mut String) -> Option<()> {
        let letters_of = self.take(|c| c.is_ascii_alphabetic());
        let sign = if letters_of.is_empty() { self.next()?.to_string() } else { String::new() };
        let name = if letters_of.is_empty() { sign.as_str() } else { letters_of };
        let found =
            |table: &[(&str, &'static str)]| table.iter().find(|(own, _)| *own == name).map(|(_, to)| *to);
        let written = match name {
            "frac" | "tfrac" | "dfrac" => {
                let (above, below) = (self.argument()?, self.argument()?);
                format!("({})/({})", above.trim(), below.trim())
            }
            "binom" => {
                let (above, below) = (self.argument()?, self.argument()?);
                format!("binom({}, {})", above.trim(), below.trim())
            }
            "text" | "textrm" => quoted(&self.words()?),
            "operatorname" | "mathrm" => format!("op({})", quoted(&self.words()?)),
            "begin" => self.environment()?,
            // \left. is no sign at all.
            "left" | "right" if self.rest.starts_with('.') => {
                self.next();
                String::new()
            }
            "sqrt" if self.rest.starts_with('[') => return None,
            _ if SILENT.contains(&name) => String::new(),
            _ => match (found(SIGNS), found(FUNCTIONS), letters::sign(name)) {
                (Some(sign), ..) => sign.to_owned(),
                (_, Some(function), _) => format!("{function}({})", self.argument()?.trim()),
                (.., Some(letter)) => letter.to_owned(),
                _ => return None,
            },
        };
        out.push_str(&written);
        out.push(' ');
        Some(())
    }

    fn environment(&mut self) -> Option<String> {
        let name = self.words()?;
        let open = match name.as_str() {
            "pmatrix" => "mat(",
            "bmatrix" => "mat(delim: \"[\", ",
            "vmatrix" => "mat(delim: \"|\", ",
            "matrix" | "smallmatrix" => "mat(delim: #none, ",
            "array" => {
                self.words()?;
                "mat(delim: #none, "
            }
            "cases" => "cases(",
            _ => return None,
        };
        let mut rows = vec![Vec::new()];
        loop {
            let cell = self.until(Some('&'))?;
            rows.last_mut()?.push(cell.trim().to_owned());
            if let Some(rest) = self.rest.strip_prefix('&') {
                self.rest = rest;
            } else if let Some(rest) = self.rest.strip_prefix("\\\\") {
                self.rest = rest;
                rows.push(Vec::new());
            } else {
                self.rest = self.rest.strip_prefix("\\end")?;
                if self.words()? != name {
                    return None;
                }
                break;
            }
        }
        let (cells, lines) = if name == "cases" { (" & ", ", ") } else { (", ", "; ") };
        let rows: Vec<String> = rows
            .iter()
            .filter(|row| row.iter().any(|cell| !cell.is_empty()))
            .map(|row| row.join(cells))
            .collect();
        Some(format!("{open}{})", rows.join(lines)))
    }
}

fn quoted(words: &str) -> String {
    format!("\"{}\"", words.replace('\\', "\\\\").replace('"', "\\\""))
}

#[cfg(test)]
mod tests {
    use super::typst;

    #[test]
    fn formulas_of_the_library() {
        for (latex, written) in [
            (r"f(t_1, t_2) = t_1 t_2 + \frac{5}{3}", "f ( t_(1) comma t_(2) ) = t_(1) t_(2) + (5)/(3)"),
            (r"\binom{n}{i} t^{n-i}", "binom(n, i) t^(n - i)"),
            (r"\begin{pmatrix} 1 & f(0, 1) \\ 3 & 4 \end{pmatrix}", "mat(1, f ( 0 comma 1 ); 3, 4)"),
            (r"F'(t) \le \hat{1}", "F' ( t ) ≤ hat(1)"),
            (r"\sum_{i=0}^n B_i^n", "∑_(i = 0)^(n) B_(i)^(n)"),
            (r#"\text{a "word"}"#, r#""a \"word\"""#),
        ] {
            assert_eq!(typst(latex).as_deref(), Some(written), "{latex}");
        }
        assert_eq!(typst(r"\unknown{1}"), None);
        assert_eq!(typst("{1"), None);
        assert_eq!(typst("1}"), None);
    }
}
