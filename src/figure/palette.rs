//! The colours of the roles: Okabe and Ito's, which those with colour blindness tell apart.

use crate::scene::Ink;

/// Colours on white, and on black; each list uses only those that stand out there.
const SERIES: [[&str; 6]; 2] = [
    ["0072B2", "D55E00", "009E73", "CC79A7", "E69F00", "56B4E9"],
    ["56B4E9", "E69F00", "009E73", "CC79A7", "F0E442", "D55E00"],
];

/// How many curves have colours of their own.
pub(super) const COUNT: usize = SERIES[0].len();

/// What is behind the drawing, and text on it.
pub(super) const PAPER: [&str; 2] = ["FFFFFF", "1B1B1F"];
pub(super) const TEXT: [&str; 2] = ["1A1A1A", "E6E6E6"];
pub(super) const GUIDE: [&str; 2] = ["7A7A7A", "9A9A9A"];
pub(super) const ACCENT: [&str; 2] = ["D55E00", "F0E442"];

/// The colour of an ink in hexadecimal.
pub(super) fn colour(ink: Ink, dark: bool) -> &'static str {
    let shade = usize::from(dark);
    match ink {
        Ink::Text => TEXT[shade],
        Ink::Guide => GUIDE[shade],
        Ink::Accent => ACCENT[shade],
        Ink::Series(number) => SERIES[shade][number % COUNT],
    }
}

/// A short name for the ink, unique in a drawing.
pub(super) fn name(ink: Ink) -> String {
    match ink {
        Ink::Text => "text".to_owned(),
        Ink::Guide => "guide".to_owned(),
        Ink::Accent => "accent".to_owned(),
        Ink::Series(number) => format!("c{}", number % COUNT),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Relative luminance, as accessibility guidelines define it.
    fn luminance(hex: &str) -> f64 {
        let channel = |at: usize| {
            let value = f64::from(u8::from_str_radix(&hex[at..at + 2], 16).unwrap()) / 255.0;
            if value <= 0.04045 { value / 12.92 } else { ((value + 0.055) / 1.055).powf(2.4) }
        };
        0.2126 * channel(0) + 0.7152 * channel(2) + 0.0722 * channel(4)
    }

    fn contrast(a: &str, b: &str) -> f64 {
        let (a, b) = (luminance(a), luminance(b));
        (a.max(b) + 0.05) / (a.min(b) + 0.05)
    }

    #[test]
    fn inks_stand_out() {
        for dark in [false, true] {
            let paper = PAPER[usize::from(dark)];
            assert!(contrast(colour(Ink::Text, dark), paper) > 7.0);
            assert!(contrast(colour(Ink::Guide, dark), paper) > 3.0);
            // the first four curves; later ones are still told apart
            for series in 0..COUNT {
                let needed = if series < 3 { 3.0 } else { 2.0 };
                assert!(contrast(colour(Ink::Series(series), dark), paper) > needed);
            }
        }
    }
}
