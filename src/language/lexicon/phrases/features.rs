//! Phrases for what is asked of a curve, a polynomial or a list at a glance: slopes and tangents, extreme places, boxes, whether
//! a point is met, what kind of conic it is.

use super::Label::Multiplicity;
use super::Phrase::{self, Function};

/// Phrases, written as those of the table.
pub(super) const FEATURES: &[(Phrase, &str)] = &[
    (
        Function("critical_points"),
        "critical point~ | critical parameter~ | stationary point~ | extrema | extremum | local extrema | extreme point~ | \
         turning point~ | x extrema | y extrema | extremstelle~ | extrempunkt~ | kritische~ punkt~ | lokale~ extrema | \
         point critique | points critiques | point stationnaire | points stationnaires | extremums | puntos críticos | \
         punto crítico | extremos | punti critici | punto critico | estremi | 极值点 | 临界点 | 驻点",
    ),
    (
        Function("mean_value"),
        "mean value | average value | mean value of | average of | mean of | moyenne de | promedio de | mittelwert von | mittelwert | durchschnittswert | valeur moyenne | valor medio | valor promedio | \
         valore medio | 平均值",
    ),
    (
        Function("sign_changes"),
        "sign change~ | change~ of sign | number of sign changes | vorzeichenwechsel | anzahl der vorzeichenwechsel | \
         changement~ de signe | nombre de changements de signe | cambio~ de signo | número de cambios de signo | \
         cambi di segno | 变号次数 | 符号变化次数",
    ),
    (
        Function("smoothing_spline"),
        "smoothing spline~ | natural smoothing spline~ | glättungsspline~ | glättender spline | spline de lissage | \
         spline suavizante | spline di lisciamento | 平滑样条",
    ),
    (
        Function("quasi_interpolant"),
        "quasi interpolant~ | quasiinterpolant~ | quasi interpolante | cuasi interpolante | cuasiinterpolante | 拟插值",
    ),
    (
        Function("offset"),
        "offset curve~ | parallelkurve~ | courbe parallèle | courbe offset | curva paralela | curva parallela | 等距曲线",
    ),
    (
        Function("vertex_tangents"),
        "vertex tangent~ | tangenten am vertex | tangentes au sommet | tangentes en el vértice | 顶点切向量",
    ),
    (
        Function("tetrahedral_value"),
        "tetrahedral value~ | wert über dem tetraeder | valeur sur le tétraèdre | valor sobre el tetraedro | 四面体上的值",
    ),
    (Function("cross_ratio"), "cross ratio | doppelverhältnis | birapport | razón doble | birapporto | 交比"),
    (
        Function("bounding_box"),
        "bounding box~ | axis aligned bounding box~ | begrenzungsrechteck | umgebende~ rechteck | boîte englobante | \
         caja envolvente | caja contenedora | riquadro di delimitazione | 包围盒",
    ),
    (
        Function("tangent_line"),
        "tangent line~ | tangent line to | tangent to | equation of tangent | equation of tangent to | \
         equation of tangent line | equation of tangent line to | tangent equation | tangente | tangente an | tangente à | \
         tangentengleichung | gleichung der tangente | gleichung der tangente an | équation de la tangente | \
         équation de la tangente à | droite tangente | recta tangente | recta tangente a | ecuación de la tangente | \
         ecuación de la recta tangente | ecuación de la recta tangente a | retta tangente | equazione della tangente | 切线方程",
    ),
    (
        Function("slope"),
        "slope~ | slope of tangent | slope of tangent line | slope of tangent to | steigung~ | steigung der tangente | pente | \
         pente de la tangente | pendiente | pendiente de la tangente | pendiente de la recta tangente | pendenza | 斜率 | \
         切线斜率 | rate of change",
    ),
    (
        Function("from_roots"),
        "polynomial with roots | polynomial with zeros | monic polynomial with roots | monic polynomial with zeros | \
         polynomial having roots | polynom mit nullstellen | polynom mit den nullstellen | normiertes polynom mit nullstellen | \
         polynôme de racines | polynôme ayant pour racines | polynôme avec racines | polinomio con raíces | polinomio de raíces | \
         polinomio con radici",
    ),
    (
        Function("conic_centre"),
        "centre of ellipse | center of ellipse | centre of conic | center of conic | centre of hyperbola | center of hyperbola | \
         mittelpunkt der ellipse | mittelpunkt des kegelschnitts | centre de la conique | centre de l'ellipse | centro de la elipse | \
         centro de la cónica",
    ),
    (Function("midpoint"), "midpoint | mid point | mittelpunkt | point milieu | punto medio | 中点"),
    (
        Function("polygon_length"),
        "length of control polygon | length of polygon | control polygon length | polygon length | \
         länge des kontrollpolygons | länge des polygons | longueur du polygone de contrôle | longueur du polygone | \
         longitud del polígono de control | lunghezza del poligono di controllo | 控制多边形的长度",
    ),
    (
        Function("multiplicity"),
        "multiplicity of knot | knot multiplicity | knot multiplicity of | vielfachheit des knotens | multiplicité du nœud | \
         multiplicidad del nudo | molteplicità del nodo",
    ),
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
    (Function("roots"), "zero"),
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
        "tensor product bezier | tensor product bézier | bilinear surface | biquadratic surface | bicubic surface | \
         tensor patch | bilineare fläche | surface bilinéaire | superficie bilineal | superficie bilineare | 双线性曲面",
    ),
];
