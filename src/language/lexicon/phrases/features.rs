//! Phrases for what is asked of a curve, a polynomial or a list at a glance: slopes and tangents, extreme places, boxes, whether
//! a point is met, what kind of conic it is.

use super::Label::Multiplicity;
use super::Phrase::{self, Function};

/// Phrases, written as those of the table.
pub(super) const FEATURES: &[(Phrase, &str)] = &[
    (Function("critical_points"), "kritische~ punkt~ | lokale~ extrema"),
    (Function("sign_changes"), "change~ of sign | changement~ de signe | cambio~ de signo"),
    (Function("bounding_box"), "umgebende~ rechteck"),
    (
        Function("tangent_line"),
        "equation of tangent line to | gleichung der tangente an | équation de la tangente à | recta tangente a | ecuación de la recta tangente | ecuación de la recta tangente a",
    ),
    (
        Function("slope"),
        "slope of tangent | slope of tangent line | slope of tangent to | steigung der tangente | pente de la tangente | pendiente de la tangente | pendiente de la recta tangente | 切线斜率 | rate of change",
    ),
    (Function("from_roots"), "normiertes polynom mit nullstellen | polynôme avec racines"),
    (
        Function("conic_centre"),
        "centre of ellipse | center of ellipse | centre of hyperbola | center of hyperbola | mittelpunkt der ellipse | centre de l'ellipse | centro de la elipse",
    ),
    (Function("midpoint"), "mid point | mittelpunkt"),
    (Function("multiplicity"), "knot multiplicity of"),
    (Phrase::Label(Multiplicity), "molteplicità"),
    (
        Function("derivative"),
        "acceleration | acceleration vector | beschleunigung | accélération | aceleración | accelerazione | 加速度",
    ),
    (
        Function("inversion"),
        "pass through | passes through | pass through point | go through | goes through | go through point | run through | \
         runs through | hit point | contain point | geht durch | verläuft durch | passe par | passe t elle par | passer par | \
         pasa por punto | passa per",
    ),
    (
        Function("conic_kind"),
        "ellipse | hyperbola | ellipse or hyperbola | hyperbel | hyperbole | elipse | hipérbola | ellisse | iperbole | 椭圆 | 双曲线 | \
         curve type | type of curve | kind of curve | kurventyp | kurvenart | type de courbe | tipo de curva | tipo di curva",
    ),
    (
        Phrase::Vanishes,
        "vanish | vanishes | is zero | be zero | equals zero | equal to zero | is equal to zero | equal zero | verschwindet | \
         verschwinden | ist null | gleich null | null wird | s'annule | s'annulle | est nul | est nulle | égal à zéro | se anula | \
         es cero | igual a cero | si annulla | uguale a zero | 为零 | 等于零",
    ),
    (
        Function("expand"),
        "as polynomial | as polynomial in | as power series in | in powers of | als polynom | als polynom in | nach potenzen von | \
         in potenzen von | comme polynôme | comme polynôme en | en puissances de | como polinomio | como polinomio en | en potencias de | \
         come polinomio | come polinomio in | in potenze di",
    ),
    (
        Phrase::Where,
        "at which t | at what t | at which parameter | at what parameter | at which parameter value | at which parameters | \
         at which points | at which point | an welcher stelle | an welchen stellen | bei welchem t | bei welchem parameter | \
         en quel point | à quel paramètre | en qué punto | en qué puntos | en qué parámetro",
    ),
    (
        Function("pieces"),
        "bezier control points of pieces | bézier segments of | bezier form of pieces | bézierdarstellung der stücke",
    ),
    (
        Function("patch"),
        "tensor product bezier | tensor product bézier | biquadratic surface | bicubic surface | tensor patch",
    ),
];
