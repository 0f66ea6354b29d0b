//! From bytes to text: encodings and line ends.

use chardetng::{EncodingDetector, Iso2022JpDetection, Utf8Detection};
use encoding_rs::{Encoding, UTF_8};

use crate::formula::source::Span;
use crate::language::diagnostic::{Code, Diagnostic};

/// The text of a file, and what had to be guessed.
///
/// UTF-8 is taken as it is; a mark of the byte order at the beginning is left out and decides; other
/// encodings are guessed from the bytes. A lone carriage return ends a line as a line feed does
/// and becomes one, so that lines can be counted; no byte is added or lost by that.
///
/// # Errors
/// When there are NUL bytes: the file is no text.
pub(super) fn decode(mut bytes: Vec<u8>) -> Result<(String, Vec<Diagnostic>), Diagnostic> {
    let marked = Encoding::for_bom(&bytes);
    if let Some((encoding, _)) = marked.filter(|&(encoding, _)| encoding != UTF_8) {
        let (text, wrong) = encoding.decode_with_bom_removal(&bytes);
        let mut text = text.into_owned().into_bytes();
        end_lines(&mut text);
        let problem = wrong.then(|| damaged(encoding.name()));
        return Ok((String::from_utf8_lossy(&text).into_owned(), problem.into_iter().collect()));
    }
    if let Some((_, length)) = marked {
        bytes.drain(..length);
    }
    if bytes.contains(&0) {
        return Err(Diagnostic::error(Code::Encoding, "this is not a text file: it holds NUL bytes")
            .hint("if it is text in UTF-16, save it as UTF-8"));
    }
    end_lines(&mut bytes);
    let bytes = match String::from_utf8(bytes) {
        Ok(text) => return Ok((text, Vec::new())),
        Err(error) => error.into_bytes(),
    };
    if let Some(found) = almost_utf8(&bytes) {
        return Ok(found);
    }
    let mut detector = EncodingDetector::new(Iso2022JpDetection::Allow);
    detector.feed(&bytes, true);
    let encoding = detector.guess(None, Utf8Detection::Deny);
    let (text, wrong) = encoding.decode_without_bom_handling(&bytes);
    let text = text.into_owned();
    let problem = if wrong {
        damaged(encoding.name())
    } else {
        let first = text.char_indices().find(|(_, c)| !c.is_ascii());
        let (at, c) = first.unwrap_or((0, ' '));
        Diagnostic::note(
            Code::Encoding,
            format!("the file is not in UTF-8; it was read as {}", encoding.name()),
        )
        .at(Span::new(at, (at + c.len_utf8()).min(text.len())))
        .hint("save it as UTF-8 to be sure that every character is right")
    };
    Ok((text, vec![problem]))
}

fn damaged(encoding: &str) -> Diagnostic {
    Diagnostic::warning(Code::Encoding, format!("read as {encoding}, some characters are damaged"))
        .hint("save the file as UTF-8")
}

/// UTF-8 with a few wrong bytes: no other encoding looks like it by chance.
fn almost_utf8(bytes: &[u8]) -> Option<(String, Vec<Diagnostic>)> {
    let (mut right, mut wrong, mut first) = (0_usize, 0_usize, None);
    let mut at = 0;
    for chunk in bytes.utf8_chunks() {
        right += chunk.valid().chars().filter(|c| !c.is_ascii()).count();
        at += chunk.valid().len();
        if !chunk.invalid().is_empty() {
            wrong += 1;
            first.get_or_insert(at);
            at += char::REPLACEMENT_CHARACTER.len_utf8();
        }
    }
    if right < 10 * wrong {
        return None;
    }
    let first = first.unwrap_or(0);
    let problem =
        Diagnostic::warning(Code::Encoding, format!("{wrong} characters are damaged, the first one here"))
            .at(Span::new(first, first + char::REPLACEMENT_CHARACTER.len_utf8()))
            .hint("write these characters anew and save the file as UTF-8");
    Some((String::from_utf8_lossy(bytes).into_owned(), vec![problem]))
}

/// Lone carriage returns become line feeds.
fn end_lines(bytes: &mut [u8]) {
    for at in 0..bytes.len() {
        if bytes[at] == b'\r' && bytes.get(at + 1) != Some(&b'\n') {
            bytes[at] = b'\n';
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn text(bytes: &[u8]) -> (String, Option<Code>) {
        let (text, problems) = decode(bytes.to_vec()).unwrap();
        (text, problems.first().map(|problem| problem.code))
    }

    #[test]
    fn utf8_is_taken_as_it_is() {
        assert_eq!(text("极 $t$\r\n".as_bytes()), ("极 $t$\r\n".to_owned(), None));
        assert_eq!(text(b"\xef\xbb\xbf$t$"), ("$t$".to_owned(), None));
        assert_eq!(text(b""), (String::new(), None));
        assert_eq!(text(b"a\rb\r\nc\r"), ("a\nb\r\nc\n".to_owned(), None));
    }

    #[test]
    fn other_encodings() {
        let sentence = "多项式的极形式是对称的多重仿射函数，其对角线等于多项式本身。$f(t,t)=F(t)$";
        for encoding in [encoding_rs::GB18030, encoding_rs::BIG5] {
            let traditional = "多項式的極形式是對稱的多重仿射函數，其對角線等於多項式本身。$f(t,t)=F(t)$";
            let wanted = if encoding == encoding_rs::BIG5 { traditional } else { sentence };
            let (bytes, _, _) = encoding.encode(wanted);
            assert_eq!(text(&bytes), (wanted.to_owned(), Some(Code::Encoding)), "{}", encoding.name());
        }
        let (bytes, _, _) =
            encoding_rs::WINDOWS_1252.encode("Das gehört zur Bézier-Fläche über Ω".trim_end_matches('Ω'));
        assert_eq!(text(&bytes), ("Das gehört zur Bézier-Fläche über ".to_owned(), Some(Code::Encoding)));
        for little in [true, false] {
            let words = "\u{feff}é $t$\r".encode_utf16();
            let bytes: Vec<u8> =
                words.flat_map(|word| if little { word.to_le_bytes() } else { word.to_be_bytes() }).collect();
            assert_eq!(text(&bytes), ("é $t$\n".to_owned(), None));
        }
    }

    #[test]
    fn damage() {
        let mut bytes = "多项式的极形式是对称的多重仿射函数".as_bytes().to_vec();
        bytes.splice(6..6, [0xff]);
        let (text, problems) = decode(bytes).unwrap();
        assert!(text.starts_with("多项\u{fffd}式"));
        assert_eq!(problems[0].span, Some(Span::new(6, 9)));
        assert_eq!(decode(b"GIF\0\x01".to_vec()).unwrap_err().code, Code::Encoding);
    }
}
