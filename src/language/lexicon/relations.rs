//! Signs of relations that are read and written, and of which nothing more is known.

/// A sign of a relation.
pub struct Sign {
    /// Its command in LaTeX.
    pub command: &'static str,
    /// Its character.
    pub sign: char,
    /// The command with blanks around it.
    pub latex: &'static str,
    /// The character with blanks around it.
    pub unicode: &'static str,
}

macro_rules! signs {
    ($($command:ident $sign:literal;)*) => {
        &[$(Sign {
            command: stringify!($command),
            sign: $sign,
            latex: concat!(" \\", stringify!($command), " "),
            unicode: concat!(" ", $sign, " "),
        }),*]
    };
}

/// All of them.
pub const SIGNS: &[Sign] = signs! {
    sim '∼';
    propto '∝';
    cong '≅';
    asymp '≍';
    perp '⟂';
    parallel '∥';
    mid '∣';
    equiv '≡';
    nmid '∤';
    ll '≪';
    gg '≫';
    lesssim '≲';
    gtrsim '≳';
    prec '≺';
    succ '≻';
    preceq '≼';
    succeq '≽';
    ni '∋';
    supset '⊃';
    supseteq '⊇';
    subsetneq '⊊';
    supsetneq '⊋';
    sqsubset '⊏';
    sqsupset '⊐';
    sqsubseteq '⊑';
    sqsupseteq '⊒';
    leftarrow '←';
    leftrightarrow '↔';
    Leftarrow '⇐';
    hookrightarrow '↪';
    vdash '⊢';
    models '⊨';
};

/// What is known of a sign.
pub fn of(sign: char) -> Option<&'static Sign> {
    SIGNS.iter().find(|own| own.sign == sign)
}
