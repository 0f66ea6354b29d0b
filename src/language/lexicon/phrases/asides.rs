//! Words of sentences that carry no role: who asks, how politely, in which mood; pronouns, auxiliary verbs, words for "it" and
//! for "formula". They may be left aside, and the answer says so.
//!
//! Words that change what is asked are never here: not, only, most, second, other, same, again, without, except, before, after,
//! unless, each, any. A test reads the list of words that deny against this one.

use super::Phrase::{self, Aside};

/// Phrases, written as those of the table.
pub(super) const ASIDES: &[(Phrase, &str)] = &[
    (
        Aside,
        "into factors | into linear factors | fraction | in faktoren | in linearfaktoren | bruch | en facteurs | en factores | fracción | in fattori | frazione | some | quickly | quick | fast | right away | this | these | those | my | our | your | it | there | here | \
         gives | gets | get | got | obtain | obtained | yields | produces | run | perform | carry out |  \
          know | see | me | us | you | we | so | thus | hence | kindly | ok | okay | hey | dear | \
         formula~ | expression~ |  thing~ | number~ | data | output | directly | still | already | usual | ordinary | nice | \
         certain | particular | specific | called | named | belonging | belongs | belong | belonging to | associated | \
         associated with | respective | mentioned | can | could | should | will | be | being | am | was | were | \
         made | formed | defined | defined by | described | described by | having | as well | too |  namely | want | wanted | required | \
         sought | asked | handy | answers | results |   procedure | method | technique | homework | exercise | \
         question | student~ | class | lecture | i have | i've | i've got | we have | there is | there are | is there | in full | \
         in detail | numerically | by hand | on paper | wondering | help | help me | help me to | hint | somebody | someone | \
         who | anyone | know how | do you know | tell us | stay | stays",
    ),
    (
        Aside,
        "man | sie | er | ich | wir | mir | uns | dir | dieser | diese | dieses | diesen | diesem | mein~ | unser~ | ihr~ | sein~ | kann | können | soll | sollen | auffasst | auffassen | aufgefasst | betrachtet | betrachten | nimm | mache | mach | führe | dazu | dafür | davon | dazugehörig~ | hier | da | dort | eben | einfach | kurz | schnell | zugehörig~ | gehört | gehören | entsprechend~ | ergebend~ | sich | werden | wird | habe | heißt | genannt | formel~ | ausdruck | verfahren | methode | verbunden | rechne | rechne aus | ermittle | ermitteln | berechnen | bestimmen | angeben | gebt | nenne | liefert | ergibt | bekomme | bekommt | erhalte | erhält | hausaufgabe | man bitte | bitte schnell | wenn man | falls man | hilf mir | helft mir | kannst du | können sie | könntest du",
    ),
    (
        Aside,
        "s'il vous plaît | s'il te plaît | stp | vite | rapidement | ce | cet | cette | ces | mon | ma | mes | notre | votre | vos | sa | ses | leur | leurs | il | elle | nous | vous | je | tu | peut | peux | pouvez | pouvez vous | faire | fais | fait | ici | là | juste | simplement | bien | donc | associé~ | correspondant~ | formule~ | obtenu~ | obtient | défini~ | défini~ par | ont | avoir | être | méthode | procédé | exercice | aide moi | aidez moi | peux tu | est ce que tu peux | j'ai | on a | il y a | qui | calculons | exprime | exprimer | effectue | effectuer",
    ),
    (
        Aside,
        "rápido | rápidamente | este | esta | estos | estas | ese | esa | mi | mis | tus |  nuestr~ | se | lo | \
         yo | puede | puedes | podría | hacer | haz | hace | aquí | ahí | así | simplemente | que | correspondiente~ | asociad~ | \
         fórmula~ | expresión |  obtenid~ | obtiene | obtener | definid~ | hay | ser | está | están | método | procedimiento | \
         ejercicio | ayúdame | me ayudas | tengo | expresa | expresar | determina | determinar | realiza | realizar | indica",
    ),
    (
        Aside,
        "veloce | velocemente | questo | questa | questi | queste | quello | quella | mio | mia | suo | sua | suoi | nostr~ | ci | può | puoi | fare | fai | lì | così | semplicemente | che | corrispondent~ | associat~ | espressione |  ottenut~ | ottiene | ottenere | definit~ | essere | c'è | metodo | procedimento | esercizio | aiutami | ho | esprimi | esprimere | determina il | determinare | eseguire | esegui | scrivi | scrivere | calcolare | trovare",
    ),
    (
        Aside,
        "快速 | 一下 | 这个 | 这条 | 该 | 我 | 我们 | 你 | 帮我 | 给我 | 一个 | 一条 | 可以 | 能 | 呢 | 吧 | 得到 | 结果 | 公式 | \
         表达式 | 对应的 | 对应 | 相应的 | 相应 | 并 | 有 | 它 | 其 | 方法 | 利用 | 使用 | 那么 | 时 | 具体 | 分别",
    ),
];

#[cfg(test)]
mod tests {
    use super::ASIDES;
    use crate::language::lexicon::asking::denies;

    #[test]
    fn no_word_that_denies_is_left_aside() {
        for phrase in ASIDES.iter().flat_map(|(_, phrases)| phrases.split('|')) {
            let denied = phrase.split_whitespace().find(|word| denies(word.trim_end_matches('~')));
            assert_eq!(denied, None, "{phrase}");
        }
    }
}
