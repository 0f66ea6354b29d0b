//! Messages over standard input and output: a header with their length, then JSON.
//!
//! What is no message does not end the server: it is told, and the next message is read. Lengths are bounded before
//! room for them is made.

use std::io::{self, BufRead, Read};
use std::thread::{self, JoinHandle};

use lsp_server::{Connection, Message, Notification};

/// A longer message is passed over.
const LONGEST: u64 = 64 << 20;

/// A longer line of a header is cut.
const LONGEST_LINE: u64 = 1 << 12;

/// The method of the notification that the server gets for something that is no message.
pub(super) const MALFORMED: &str = "polarform/malformed";

/// A connection over standard input and output. The thread ends when everything is written and the connection gone.
pub(super) fn stdio() -> (Connection, JoinHandle<()>) {
    let (server, client) = Connection::memory();
    let Connection { sender, receiver } = client;
    let writer = thread::spawn(move || {
        let mut out = io::stdout().lock();
        // When the client is gone there is nobody left to tell.
        let _ = receiver.into_iter().try_for_each(|message| message.write(&mut out));
    });
    thread::spawn(move || {
        let mut input = io::stdin().lock();
        while let Ok(Some(read)) = next(&mut input, LONGEST) {
            let message = read.unwrap_or_else(|why| Notification::new(MALFORMED.to_owned(), why).into());
            if sender.send(message).is_err() {
                break;
            }
        }
    });
    (server, writer)
}

/// The next message, or why what came is none; nothing at the end of the input.
fn next(input: &mut impl BufRead, longest: u64) -> io::Result<Option<Result<Message, String>>> {
    let mut length: Option<u64> = None;
    let mut line = Vec::new();
    let length = loop {
        line.clear();
        if input.by_ref().take(LONGEST_LINE).read_until(b'\n', &mut line)? == 0 {
            return Ok(None);
        }
        let header = String::from_utf8_lossy(line.trim_ascii()).into_owned();
        match (header.split_once(':'), length) {
            (Some((name, value)), _) if name.trim().eq_ignore_ascii_case("content-length") => {
                length = value.trim().parse().ok();
            }
            (None, Some(length)) if header.is_empty() => break length,
            _ => {}
        }
    };
    if length > longest {
        io::copy(&mut input.by_ref().take(length), &mut io::sink())?;
        return Ok(Some(Err(format!("a message of {length} bytes is longer than {longest}"))));
    }
    let mut body = Vec::new();
    if (input.by_ref().take(length).read_to_end(&mut body)? as u64) < length {
        return Ok(None);
    }
    Ok(Some(serde_json::from_slice(&body).map_err(|error| error.to_string())))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Everything in an input: the method or the mistake.
    fn all(mut input: &[u8]) -> Vec<Result<String, String>> {
        let mut found = Vec::new();
        while let Some(read) = next(&mut input, 100).expect("bytes can be read") {
            found.push(read.map(|message| match message {
                Message::Notification(notification) => notification.method,
                other => panic!("{other:?}"),
            }));
        }
        found
    }

    #[test]
    fn what_is_no_message_is_passed_over() {
        let frame = |body: &str| format!("Content-Length: {}\r\n\r\n{body}", body.len());
        let good = frame(r#"{"jsonrpc": "2.0", "method": "a"}"#);
        let other =
            format!("content-length:33\nContent-Type: x\n\n{}", r#"{"jsonrpc": "2.0", "method": "b"}"#);
        assert_eq!(all((good.clone() + &other).as_bytes()), [Ok("a".to_owned()), Ok("b".to_owned())]);
        let bad = [
            frame("{"),
            frame("\u{7f}"),
            frame("[1, 2]"),
            frame(&"[".repeat(99)),
            frame(&" ".repeat(101)),
            "garbage\r\n\r\nContent-Length: many\r\n\r\nContent-Length: -1\r\n\r\n".to_owned(),
            "x".repeat(10_000) + "\r\n",
        ];
        let count = |input: &str| {
            let found = all(input.as_bytes());
            (found.len(), found.into_iter().filter_map(Result::ok).collect::<Vec<_>>())
        };
        for (at, bad) in bad.iter().enumerate() {
            let mistakes = usize::from(at < 5);
            assert_eq!(count(&format!("{bad}{good}")), (1 + mistakes, vec!["a".to_owned()]), "{bad:?}");
        }
        assert_eq!(all(b""), []);
        assert_eq!(all(b"Content-Length: 20\r\n\r\n{"), []);
        assert_eq!(all(b"Content-Length: 99999999999\r\n\r\n{}").len(), 1);
    }
}
