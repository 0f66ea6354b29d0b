//! The phrases of requests in words, of all languages.

use super::Label::{
    At, From, In, Knots, Multiplicity, Nodes, Number, OfDegree, Over, Points, Through, Times, To, Values,
    Weights, With,
};
use super::Phrase::{self, And, Between, Command, Degree, Filler, Flag, Function, Of, Ordinal};
use super::Place::{Centre, End, Middle, Start};
use crate::formula::BigOp;

/// Phrases, in small letters and between bars; a hyphen or more blanks stand for one blank, `~` for any of the endings.
pub(super) const PHRASES: &[(Phrase, &str)] = &[
    (
        Function("polar"),
        "polar form~ | polarform~ | blossom~ | polar value~ | forme~ polaire~ | blüte | 极形式 | 开花 | \
         polarization | forma~ polar~",
    ),
    (Command("polar"), "polarize | polarise | polarisiere~ | polariser | polarizar"),
    (Function("diagonal"), "diagonal | diagonale | diagonal value"),
    (
        Function("derivative"),
        "derivative~ | first derivative | ableitung~ | erste~ ableitung | dérivée~ | derivee | 导数 | \
         derivada~ | derivata | tangent | tangent vector | tangentenvektor | vecteur tangent | 切向量 | velocity | \
         velocity vector | tangent direction | direction of tangent | tangentenrichtung | direction tangente",
    ),
    (
        Command("derivative"),
        "differentiate | derive | dérive | dériver | differenziere~ | 求导 | derivar | deriva",
    ),
    (
        Function("integrate"),
        "integral~ | antiderivada | antiderivative | indefinite integral | definite integral | stammfunktion | \
         intégrale | primitive | 积分 | 不定积分 | 定积分",
    ),
    (
        Function("integrate"),
        "area under | area below | fläche unter | flächeninhalt unter | aire sous | área bajo | area sotto",
    ),
    (Command("integrate"), "integrate | integriere~ | intègre | intégrer | 求积分 | integrar | integra"),
    (
        Command("expand"),
        "which polynomial has | what polynomial has | welches polynom hat | quel polynôme a | expand | multiply out | multipliziere | développe~ | développer | 展开 | desarrolla | \
         desarrollar | espandi",
    ),
    (
        Command("factor"),
        "factor | factorise | factorize | faktorisiere~ | factoriser | 因式分解 | factoriza | \
         factorizar | fattorizza",
    ),
    (Function("factor"), "factorization | factorisation | prime factorization | faktorisierung"),
    (
        Command("simplify"),
        "simplify | vereinfache~ | simplifie~ | simplifier | 化简 | simplifica~ | simplificar",
    ),
    (
        Command("solve"),
        "solve | löse~ | résous | résoudre | resuelve | resolver | risolvi | 解 | 求解 | solution | solutions | lösungen | lösung",
    ),
    (
        Function("roots"),
        "root~ | a zero | have zero | touch zero | touches zero | cross zero | crosses zero | cross the axis | touch the axis | have zeros | real roots | zeros | zeroes | nullstelle~ | racine~ | zéro~ | 零点 | 根 | raíz | raíces | \
         radici | ceros",
    ),
    (
        Function("count_roots"),
        "how many roots has | how many real roots has | how many solutions has | how many real solutions has | \
         how many real zeros has | how many solutions does | how many real solutions does | how many zeros does | how many real zeros does | how many zeros has | how many real roots does | how many roots does | \
         number of roots | number of real roots | number of solutions | number of real solutions | \
         number of real zeros | wie viele nullstellen hat | wie viele lösungen hat | anzahl der nullstellen | \
         combien de racines a | nombre de racines | nombre de racines réelles",
    ),
    (
        Function("least_squares"),
        "least squares | least squares fit | least squares approximation | least squares polynomial | regression | \
         kleinste quadrate | moindres carrés | best fit",
    ),
    (Degree(1), "line | gerade | droite"),
    (
        Function("taylor"),
        "taylor polynomial~ | taylor expansion | taylor series | taylorpolynom~ | polynôme~ de taylor | \
         polinomio de taylor | 泰勒多项式",
    ),
    (Function("discriminant"), "diskriminante | 判别式"),
    (Function("degree"), "polynomial degree"),
    (
        Phrase::TrueDegree,
        "true degree | actual degree | exact degree | real degree | genuine degree | tatsächlicher grad | \
         tatsächlichen grad | wahrer grad | wahren grad | echter grad | exakter grad | degré réel | degré effectif | \
         degré exact | grado real | grado verdadero | grado effettivo | 真正的次数 | 实际次数",
    ),
    (Function("coefficients"), "power coefficients | koeffizienten der potenzbasis"),
    (Function("coefficient"), "coefficient | koeffizient | coeff | 系数"),
    (
        Function("in_bernstein"),
        "bernstein form~ | bernstein 系数 | bernstein基 | bernstein 基 | 伯恩斯坦系数 | bernstein | bernstein basis | bernstein coefficients | bernstein coeffs | \
         coeficientes de bernstein | coefficienti di bernstein | \
         b form | bézier form | bezier form | bernsteinbasis | bernsteinform | \
         bernstein darstellung | bernstein koeffizienten | bernsteinkoeffizienten | \
         base de bernstein | forme de bernstein | coefficients de bernstein | 伯恩斯坦基 | 伯恩斯坦形式 | \
         bernstein representation | bernstein bézier form | bernstein bezier form",
    ),
    (
        Function("expand"),
        "monomial~ | monomial form | monomial basis | power form | power basis | \
         powers | standard form | monombasis | potenzbasis | potenzform | base canonique | \
         base monomiale | 幂基 | 幂形式 | polynomial form | normal form",
    ),
    (
        Function("bernstein"),
        "bernstein polynomial~ | bernsteinpolynom~ | bernstein polynom~ | polinomio~ de bernstein | \
         polinomio~ di bernstein | bernstein basis polynomials | bernstein basis functions | \
         polynômes de bernstein | polynôme de bernstein | 伯恩斯坦多项式",
    ),
    (
        Function("bezier_points"),
        "bézier point~ | bezier point~ | bézierpunkt~ | bezierpunkt~ | point~ de bézier | puntos de bézier | \
         puntos de bezier | punti di bézier | points de bezier | bezier ordinates | bézierordinaten | \
         bezierordinaten | bézier koeffizient~ | \
         bézier control points | bezier control points | 贝塞尔控制点 | bézier控制点 | bezier控制点 | bézier coefficients | \
         bezier coefficients | bézier ordinates | 贝塞尔点",
    ),
    (
        Function("control_points"),
        "control point~ | control polygon~ | kontrollpunkt~ | kontrollpolygon~ | polygone de contrôle | polígono de control | point~ de contrôle | 控制点 | steuerpunkt~ | \
         puntos de control | punti di controllo",
    ),
    (
        Function("bezier"),
        "conic | conic section | kegelschnitt | conique | cónica | 二次曲线 | bezier | bézier | bezier curve~ | bézier curve~ | bezierkurve~ | bézierkurve~ | \
         curva~ de bézier | curva~ de bezier | curva~ di bézier | curva~ di bezier | \
         bezier function~ | bézier function~ | bézierfunktion~ | bezierfunktion~ | fonction de bézier | función de bézier | \
         bézierpolynom~ | bezierpolynom~ | bernsteinpolynom mit koeffizienten | courbe de bézier | courbe de bezier | 贝塞尔曲线 | point on bezier | point on bezier curve | \
         bezier polynomial | bézier polynomial | bezier polygon | bezier segment | bézier segment",
    ),
    (Function("casteljau"), "de casteljau | casteljau | 德卡斯特里奥"),
    (
        Command("elevate"),
        "elevate | raise degree | \
         raise | degree elevated | élève le degré de | élever le degré | eleva el grado | eleva il grado | aumenta el grado | grad erhöhen | elevate degree | raise the degree | elevate the degree | degree elevate | \
         degree raise | erhöhe den grad | elevar el grado | 升阶",
    ),
    (
        Function("elevate"),
        "degree elevation | graderhöhung | élévation du degré | élévation de degré | \
         elevación de grado | elevación del grado",
    ),
    (
        Command("reduce"),
        "degree reduce | reduce degree | \
         degree lower | reduziere den grad | senke den grad | grad reduzieren | réduire le degré | reduce el grado | written with lower degree | reduce the degree | lower degree | lower the degree | 降阶",
    ),
    (Function("reduce"), "degree reduction | gradreduktion | réduction du degré | reducción de grado"),
    (
        Command("subdivide"),
        "split | subdivide | \
         cut | chop | bisect | halve | divide | zerlege~ | zerteile~ | halbiere~ | coupe | couper | divise | diviser | corta | cortar | dividir | 分成 | 拆分 | unterteile~ | teile | subdivise~ | subdiviser | subdividir | suddividi | 细分 | 分割",
    ),
    (Function("subdivide"), "subdivision | unterteilung | subdivisión"),
    (Function("part"), "restriction | einschränkung | restricción"),
    (Command("reverse"), "reverse"),
    (
        Command("part"),
        "extend | extrapolate | \
         restricted | beschränkt | verlängere | prolonger | restrict | beschränke | einschränken | restreindre",
    ),
    (
        Phrase::Part("subdivide", 0),
        "left part | left half | first half | linker teil | linke hälfte | partie gauche",
    ),
    (
        Phrase::Part("subdivide", 1),
        "right part | right half | second half | rechter teil | rechte hälfte | partie droite",
    ),
    (Phrase::Total(BigOp::Sum), "sum | summe | somme | suma | somma"),
    (
        Phrase::Total(BigOp::Product),
        "multiply | multipliziere mit | multiplie | multiplier | multiplica | multiplicar | moltiplica | product | produkt | produit",
    ),
    (
        Command("max"),
        "which is bigger | which is larger | which is greater | was ist größer | lequel est plus grand | \
         larger | bigger | greater",
    ),
    (
        Function("maximum"),
        "maximal | maximale~ | am größten | largest | greatest | largest value | maximum value | maximal value | max value | größter wert | maximalwert | \
         plus grande valeur | valeur maximale | 最大值",
    ),
    (
        Function("minimum"),
        "minimal | minimale~ | am kleinsten | smallest | least | smallest value | least value | minimum value | minimal value | min value | kleinster wert | \
         minimalwert | plus petite valeur | valeur minimale | 最小值",
    ),
    (Command("min"), "which is smaller | which is less | was ist kleiner | smaller"),
    (
        Function("raising"),
        "matrix of degree elevation | degree elevation matrix | elevation matrix | degree raising matrix | \
         matrix for degree elevation | graderhöhungsmatrix | matrix der graderhöhung | matrice d'élévation",
    ),
    (
        Function("change_of_basis"),
        "conversion matrix | basis conversion matrix | change of basis matrix | matrix of change of basis | \
         basis change | basis change matrix | transformation matrix | matrix for conversion | basiswechsel | \
         basiswechselmatrix | transformationsmatrix | matrice de passage",
    ),
    (
        Function("polar_tensor"),
        "tensor polar form~ | tensor product polar form~ | tensor product blossom | tensor blossom | \
         tensorprodukt polarform",
    ),
    (
        Command("implicit"),
        "eliminate t | eliminate the parameter | eliminate the parameter t | implicitize | implicitise | eliminiere t",
    ),
    (Function("hodograph"), "hodograph | hodographe"),
    (Function("curvature"), "krümmung | courbure | 曲率"),
    (
        Function("bspline_basis"),
        "cox de boor | b spline~ | bspline~ | b spline basis function~ | b spline basis | basis function~ | \
         basisfunktion~ | bspline basis function~ | b spline funktion~ | 样条基函数 | b样条 | b样条基函数 | b样条函数",
    ),
    (
        Function("bspline"),
        "nurbs | nurbs curve~ | rational b spline | spline~ | b spline curve~ | spline curve~ | b spline kurve~ | splinekurve~ | courbe b spline | \
         b样条曲线 | 样条 | 样条曲线",
    ),
    (
        Function("patch"),
        "tensor product patch | tensor product surface | tensor product bézier patch | bézier patch | \
         bezier patch | bézier surface | bezier surface | bézierfläche | bezierfläche | surface de bézier | \
         tensorproduktfläche | tensor product bezier patch | tensor product bezier surface | bilinear patch",
    ),
    (
        Function("triangle_patch"),
        "triangle patch | triangle bezier patch | dreieckspatch | triangular bezier patch | triangular bézier patch | bezier triangle | bézier triangle | \
         triangular patch | bézierdreieck | bezierdreieck | triangle de bézier",
    ),
    (
        Function("esym"),
        "elementary symmetric polynomial~ | elementary symmetric function~ | elementarsymmetrisch~ funktion~ | \
         elementarsymmetrisch~ polynom~ | polynôme~ symétrique~ élémentaire~ | \
         fonction~ symétrique~ élémentaire~",
    ),
    (Function("deboor"), "de boor | deboor | de boor's algorithm | de boor scheme"),
    (
        Function("pieces"),
        "bézier segments | bezier segments | bézier pieces | bezier pieces | bézier extraction | bezier extraction | \
         bézierstücke | bezierstücke | bézier segmente | bezier segmente | segments de bézier | segments de bezier | \
         segmentos de bézier | tramos de bézier",
    ),
    (
        Function("gram"),
        "mass matrix | gram matrix | massenmatrix | gramsche matrix | matrice de masse | matriz de masa",
    ),
    (Function("spline_of"), "marsden coefficients | marsden identity | marsden's identity | marsden"),
    (
        Function("subdivide_polygon"),
        "four point subdivision | four point scheme | 4 point scheme | four point | vierpunktschema | vier punkt schema | schéma à quatre points | \
         esquema de cuatro puntos | schema a quattro punti | 四点格式 | 四点法 | 四点细分",
    ),
    (Function("subdivide_polygon"), "chaikin | chaikin's algorithm | chaikin's scheme"),
    (
        Function("barycentric"),
        "barycentric coordinates | baryzentrische koordinaten | baryzentrischen koordinaten | \
         coordonnées barycentriques | coordenadas baricéntricas | 重心坐标",
    ),
    (
        Function("inflections"),
        "inflection point~ | point of inflection | points of inflection | wendepunkt~ | point~ d'inflexion | \
         puntos de inflexión | 拐点",
    ),
    (
        Function("intersections"),
        "intersection | intersections | intersection point~ | schnittpunkt~ | points d'intersection | \
         puntos de intersección | punti di intersezione | 交点",
    ),
    (
        Function("double_points"),
        "loop~ | self intersection~ | selbstüberschneidung~ | point~ double | punto doble | puntos dobles | cusp~ | spitze~",
    ),
    (Command("intersections"), "intersect | schneide | intersecte | intersecta | interseca"),
    (
        Function("continuity"),
        "join | joins | joint | meet smoothly | continuous | stetig | glatt | übergang | smooth join | smooth | smoothly | join smoothly | \
         raccord | raccordement | continues | continuité | continuidad | continuas | 连续 | 拼接",
    ),
    (
        Function("differences"),
        "forward differences | vorwärtsdifferenzen | différences progressives | diferencias progresivas",
    ),
    (
        Function("arc_length"),
        "length | arc length | länge | bogenlänge | longueur | longueur d'arc | longitud | longitud de arco | lunghezza | 弧长",
    ),
    (
        Function("length"),
        "number of | anzahl der | anzahl | nombre de | número de | numero di | how many | wie viele | combien de | cuántos | cuántas",
    ),
    (
        Phrase::Place(Start),
        "at the start | at the beginning | at its start | am anfang | au début | al principio | al inicio | at the left end",
    ),
    (
        Phrase::Place(End),
        "at the end | at its end | am ende | à la fin | al final | alla fine | at the right end",
    ),
    (
        Phrase::Place(Middle),
        "its middle knot | the middle knot | middle knot | at its middle knot | at the middle knot | am mittleren knoten | au nœud central | en el nudo central | at its middle | in the middle | at the middle | at the midpoint | at its midpoint | at the parameter midpoint | in der mitte | au milieu | \
         en el medio | por la mitad | nel mezzo | in half | in two halves | in zwei hälften | en deux moitiés",
    ),
    (
        Phrase::Place(Centre),
        "at barycentre | at barycenter | at centroid | at its barycentre | at its barycenter | at its centroid | at the centroid | at the barycenter | at the barycentre | im schwerpunkt | au centre de gravité | au barycentre | \
         en el baricentro | nel baricentro | at the center | at the centre",
    ),
    (
        Flag("closed", 1),
        "closed | closed polygon | geschlossen~ | geschlossenes polygon | fermé~ | polygone fermé | cerrad~ | 封闭 | 闭",
    ),
    (
        Flag("closed", 0),
        "open | open polygon | offen~ | offenes polygon | ouvert~ | polygone ouvert | abiert~",
    ),
    (
        Phrase::Where,
        "and where it is attained | where it is attained | and where is it attained | wo es angenommen wird | and where | where does | where is | where has | attain | attains | attained | reach | reaches | taken | how large is it | how big is it | how big is it there | how large is it there | wie groß ist es | wie groß | \
         and how large is it | what is it there | wo | und wo | et où | y dónde | dónde | e dove | 在哪里",
    ),
    (
        Phrase::Multiaffine,
        "multi affine | affine in each argument | affine in each variable | symmetric and affine | symmetric and affine in each argument | symmetric and affine in each variable | symmetric and multiaffine | symmetric and multi affine | symmetric multiaffine | symmetrisch und multiaffin | symmetrisch und affin in jedem argument | symétrique et affine en chaque argument | symétrique et multiaffine | triaffine | symmetric | symmetric biaffine | symmetrisch~ | multiaffin~ | biaffin~ | \
         symétrique | multi affine symétrique | simétric~ | 对称",
    ),
    (
        Function("greville"),
        "greville abscissae | greville points | greville | greville abszissen | \
         abscisses de greville | abscisas de greville",
    ),
    (
        Command("insert_knots"),
        "insert knot | insert knots | knot insertion | \
         insert | add knot | füge den knoten | füge knoten | knoten einfügen | insère le nœud | insérer le nœud | insérer | inserta el nudo | inserta | inserisci | boehm | boehm's algorithm | 插入节点",
    ),
    (
        Function("lagrange"),
        "interpolation polynomial | interpolating polynomial | lagrange polynomial~ | interpolant~ | \
         polinomio interpolador | polinomio de lagrange | polinomio interpolante | \
         polinomio di lagrange | polynôme de lagrange | lagrange polynom~ | lagrangepolynom~ | \
         polinomio de interpolación | lagrange | \
         interpolationspolynom | polynôme d'interpolation | polynôme interpolateur | 插值多项式 | \
         polynomial through | polynom durch | polynôme passant par | polinomio por | \
         polinomio que pasa por | lagrange interpolation | polynomial interpolation | lagrange interpolation polynomial",
    ),
    (
        Function("cubic_spline"),
        "natural cubic spline | natural spline | natürlicher kubischer spline | natürlicher spline | spline cubique naturelle | \
         spline cúbico natural",
    ),
    (
        Command("over"),
        "reparametrise | reparametrize | reparameterise | reparameterize | umparametrisieren | reparamétrer",
    ),
    (
        Command("continuation"),
        "continue | continue it | continue smoothly | next | next curve | next segment | next piece | following segment | setze fort | \
         fortsetzen | nächstes segment | prolonge par | continúa | siguiente segmento | 延拓",
    ),
    (
        Function("continuation"),
        "continuation | smooth continuation | fortsetzung | prolongement | continuación | continuazione",
    ),
    (
        Command("standard_form"),
        "normalise | normalize | normalised | normalized | normiere | normalisiere | normaliser | normaliza | \
         normalizza",
    ),
    (
        Function("hermite"),
        "hermite interpolation | hermite interpolant | hermite polynomial | hermite interpolationspolynom | \
         interpolation d'hermite | polynôme d'hermite | interpolación de hermite",
    ),
    (Command("lagrange"), "interpolate | interpoliere~ | interpole~ | interpoler | interpolar | 插值"),
    (
        Function("newton"),
        "newton polynomial~ | newton form | newton interpolation | newton interpolation polynomial | \
         newton interpolation form | newtonform | polynôme de newton | polinomio de newton | 牛顿插值",
    ),
    (
        Function("divided_differences"),
        "divided differences | newton divided differences | divided difference table | newton divided difference table | \
         newton divided difference | \
         dividierte~ differenz~ | différence~ divisée~ | 差商 | \
         divided difference | diferencia~ dividida~ | differenze divise",
    ),
    (Function("lagrange_basis"), "lagrange basis | lagrange basis polynomial~ | lagrangebasis"),
    (Function("det"), "determinant~ | déterminant | 行列式"),
    (Function("inverse"), "inverse matrix | inverse of matrix | inverse"),
    (Command("inverse"), "invert | invertiere | inverser"),
    (Function("gcd"), "greatest common divisor | ggt | pgcd | 最大公约数 | 最大公因式"),
    (Function("lcm"), "least common multiple | kgv | ppcm | 最小公倍数"),
    (Function("binomial"), "binomial coefficient | binomialkoeffizient"),
    (Between("binomial"), "choose | parmi"),
    (Function("factorial"), "fakultät | factorielle | 阶乘"),
    (Function("sqrt"), "square root | wurzel | quadratwurzel | racine carrée"),
    (Function("resultant"), "resultante"),
    (Function("symmetrize"), "symmetrization"),
    (Command("symmetrize"), "symmetrise | symmetrize | symmetrisiere | symétriser | 对称化"),
    (Degree(1), "linear~ | linéaire~ | 线性"),
    (
        Degree(2),
        "biquadratic~ | biquadratisch~ | biquadratique~ | bilinear~ | bilinéaire~ | parabola | parabel | parabole | quadratic~ | quadratisch~ | quadratique~ | cuadrátic~ | cuadratic~ | 二次",
    ),
    (
        Degree(3),
        "bicubic~ | bikubisch~ | bicubique~ | trilinear~ | trilinéaire~ | cubic~ | kubisch~ | cubique~ | cúbic~ | 三次",
    ),
    (Degree(4), "quartic~ | quartique~ | cuártic~ | 四次"),
    (
        Ordinal(2),
        "second~ | zweite~ | deuxième~ | segund~ | twice | two times | zweimal | deux fois | dos veces | due volte | 二阶",
    ),
    (
        Ordinal(3),
        "third | dritte~ | troisième~ | tercer~ | terz~ | thrice | three times | dreimal | trois fois | tres veces | 三阶",
    ),
    (
        Ordinal(1),
        "um eins | by one | d'un degré | en uno | di uno | once | one | one time | einmal | une fois",
    ),
    (Degree(5), "quintic~ | quintique~ | 五次"),
    (
        Of,
        "of | von | vom | des | der | de | du | d' | de la | de l' | del | de los | de las | di | della | \
         dei | 的",
    ),
    (Phrase::Rational, "rational~ | rationnel~ | rationnelle~ | racional~ | razional~"),
    (
        Phrase::Multiplicity(1),
        "simple knot | single knot | einfachen knoten | einfacher knoten | nœud simple | nudo simple",
    ),
    (
        Phrase::Multiplicity(2),
        "double knot | doppelten knoten | doppelter knoten | doppelknoten | nœud double | nudo doble | 二重节点",
    ),
    (
        Phrase::Multiplicity(3),
        "triple knot | dreifachen knoten | dreifacher knoten | nœud triple | nudo triple | 三重节点",
    ),
    (
        Phrase::Label(Multiplicity),
        "knot of multiplicity | knot with multiplicity | multiplicity | knoten der vielfachheit | vielfachheit | \
         nœud de multiplicité | multiplicité | nudo de multiplicidad | multiplicidad | 重数",
    ),
    (
        Phrase::Using,
        "use | using | by means of | with the help of | mithilfe | mit hilfe | à l'aide | au moyen | usando | mediante | con ayuda",
    ),
    (Phrase::Has, "has | have a | hat | haben | tiene | possède | besitzt"),
    (
        Phrase::First(2),
        "first two | ersten beiden | ersten zwei | deux premiers | primeros dos | dos primeros | 前两个",
    ),
    (Phrase::First(3), "first three | ersten drei | trois premiers | tres primeros | 前三个"),
    (Phrase::First(4), "first four | ersten vier | quatre premiers | cuatro primeros | 前四个"),
    (Phrase::Uniform, "uniform~ | gleichmäßig~ | equidistant~ | äquidistant~ | équidistant~ | 均匀"),
    (Phrase::Curve, "curve | curve with | kurve | courbe | curva~ | 曲线"),
    (Phrase::Apply, "apply | wende | appliquer | applique | aplicar | aplica | applica"),
    (
        Phrase::AppliedTo,
        "applied to | angewandt auf | angewendet auf | appliqué à | appliqué sur | aplicado a | applicato a | 作用于",
    ),
    (
        Function("support"),
        "nonzero | non zero | not zero | ungleich null | träger | soporte | supporto | 支集 | 支撑 | support interval | trägerintervall",
    ),
    (
        Function("bernstein_approximation"),
        "bernstein operator | bernsteinoperator | bernstein approximant | bernsteinapproximation | opérateur de bernstein | \
         operador de bernstein | operatore di bernstein | 伯恩斯坦算子",
    ),
    (
        Function("smoothness"),
        "how smooth | glattheit | wie glatt | régularité | suavidad | differentiability | differenzierbarkeit | 光滑性",
    ),
    (
        Function("diagonal"),
        "polynomial whose | polynom dessen | polynôme dont la | polynôme dont | \
         polinomio cuya | polinomio la cui",
    ),
    (
        Function("conic_kind"),
        "type of conic | kind of conic | conic type | type of the conic | art des kegelschnitts | kegelschnittart | \
         type de conique | tipo de cónica | what conic | which conic | what kind of conic | what type of conic | welcher kegelschnitt | \
         quelle conique | qué cónica",
    ),
    (
        Phrase::Is,
        "est elle | est il | is | are | ist | sind | est | sont | es | son | sono | gilt | does | do | stimmt",
    ),
    (
        Phrase::Equals,
        "equals | equal | be equal to | vaut | vaut elle | vaut il | vale | 的值为 | 等于 | equal to | igual a | uguale a | is equal to | gleich | ist gleich | égal à | est égal à | es igual a",
    ),
    (
        Phrase::Takes,
        "has value | has the value | have value | have the value | takes value | takes the value | take the value | \
         hat den wert | hat wert | a la valeur | a pour valeur | prend la valeur | tiene el valor | tiene valor | toma el valor | \
         ha il valore",
    ),
    (Phrase::Which, "for which | for what | für welche~ | pour quel~ | para qué"),
    (
        And,
        "and | und | et | 和 | 与 | on division by | upon division by | when divided by | after division by | by division by | bei division durch | in the division by | dans la division par | al dividir por | al dividir entre | divided by | geteilt durch | divisé par | dividido por",
    ),
    (Phrase::Or, "or | oder | ou"),
    (
        Phrase::Label(At),
        "at | at barycentric | new knot | new knots | neuer knoten | neuen knoten | nouveau nœud | nuevo nudo | at barycentric coordinates | at the barycentric coordinates | en el punto | nel punto | at parameter | at the parameter | at the point | bei | an der stelle | für t | \
         im punkt | en | au point | 在 | evaluated at | ausgewertet bei | évaluée en | value at | \
         wert bei",
    ),
    (
        Phrase::Label(Over),
        "over | on | on the interval | \
         on interval | within | auf dem intervall | parameter interval | parameter range | subinterval | teilintervall | sous intervalle | subintervalo | dans l'intervalle | over the interval | über | auf | im intervall | sur | \
         sur l'intervalle | in the interval | interval | intervall | \
         intervalle | 区间 | sobre | en el intervalo | intervalo | nell'intervallo | intervallo",
    ),
    (Phrase::Label(From), "from | desde | 从 | between | zwischen | entre"),
    (
        Phrase::Label(To),
        "to | hasta | bis | à | jusqu'à | auf grad | into | nach | in die | 到 | 转换为 | 转化为 | dans la | \
         as | as a | regarded as | regarded as a | seen as | seen as a | considered as a | als | comme | \
         写成 | 表示为",
    ),
    (
        Phrase::Label(In),
        "in | dans | dentro de | nel | nella | with respect to | wrt | w r t | nach der variablen | bezüglich | par rapport à | by | \
         关于",
    ),
    (
        Phrase::Label(With),
        "let | suppose | assume | sei | seien | gegeben | gegeben sei~ | gegeben ist | soit | soient | étant donné~ | on donne | sea | sean | dada~ | sia | siano | 设 | 已知 | 令 | 给定 | for | with | where | when | given | für | mit | avec | pour | wobei | con | para | par | por | zu | zum | donde",
    ),
    (
        Phrase::Label(Through),
        "through | passing through | that passes through | which passes through | durch | passant par | que pasa por | que pasa por los puntos | passante per | attraverso | 经过 | 通过",
    ),
    (
        Phrase::Label(OfDegree),
        "degree | deg | grad~ | degré~ | vom grad | of degree | de degré | de grado | di grado | \
         du degré | 次数",
    ),
    (
        Phrase::Label(Knots),
        "uniform knots | knots | nudos | nodos | nodi | vector de nudos | knot vector | knot sequence | knoten | knotenvektor~ | knotenfolge | nœuds | noeuds | \
         vecteur nodal | 节点",
    ),
    (Phrase::Label(Nodes), "nodes | node | stützstellen | abscissae | abscissas | abscisses"),
    (Phrase::Label(Values), "values | ordinates | werte | werten | valeurs | valores | valori"),
    (Phrase::Label(Weights), "weights | gewicht~ | poids | pesos | pesi | 权"),
    (
        Phrase::Label(Points),
        "points | pts | ctrl | ctrl points | ctrl pts | control | cps | vertices | ecken | sommets | vértices | control vertices | control sequence | control value~ | control coefficient~ | control ordinate~ | coefficients | coeffs | coefs | coef | koeffizienten | coeficientes | coefficienti | \
         de boor point~ | punkt~ | puntos | punti | control net | kontrollnetz | net | \
         corners | corner points",
    ),
    (
        Phrase::Label(Times),
        "times | step~ | schritt~ | étape~ | paso~ | iteration~ | 步 | mal | fois | veces | volte | 次",
    ),
    (Phrase::Label(Number), "index"),
    (
        Filler,
        "what | representation | darstellung | représentation | representación | eine | einem | einen | einer | eines | forma | forme | intermediate points | all intermediate points of | zwischenpunkte | points intermédiaires | new | neue~ | nouveau~ | nouvelle~ | nuev~ | if so | wenn ja | si oui | if yes | need | needs | needed | braucht | brauchen | benötigt | necesita | \
         all the | alle | aller | tous les | toutes les | todos los | todas las | really | actually | halves | to a fraction | into a fraction | in einen bruch | by induction | per induktion | durch vollständige induktion | par récurrence | how do i compute | how do i find | how to compute | how to find | how can i compute | how does one compute | could you | can you | would you | i want | i need | hi | hello | hallo | bonjour | for me | thanks | thank you | danke | merci | wie berechne ich | wie berechnet man | comment calculer | as a fraction | as fraction | as an exact fraction | als bruch | en fraction | comme fraction | 化为分数 | have | their | constant | konstante | constante | horner | horner scheme | hornerschema | évalue | évaluer | 值 | 用 | 算法 | \
         the | a | an | its | what is | what's | whats | what are | compute | calculate | find | \
         give | give me | show | show me | list | list all | all | tell me | please | pls | \
         determine | write | express | convert | transform | rewrite | evaluate | value | \
         value of | point | point on | exactly | exact | polynomial | function | funktion | \
         polynom | was ist | berechne | bestimme | finde | gib | wandle | schreibe | um | die | \
         das | den | dem | calcule | calculer | calculez | donne | donner | donnez | trouvez | déterminez | détermine | \
         déterminer | trouve | trouver | la | le | les | l' | un | une | convertir | convertis | \
         écrire | quelle est | quel est | polynôme | svp | bitte | matrix | \
         求 | 计算 | 将 | 把 | 处 | 上 | 处的点 | 处的值 | 点 | 请 | 矩阵 | 多项式 | 函数 | 过点 | poly | \
         scheme | schema | schemas | schéma | algorithm | algorithmus | algorithme | algoritmo | \
         wie lautet | how much is | que vaut | combien vaut | cuánto vale | quanto vale | symbolic~ | calcula | calcular | halla | hallar | encuentra | el | los | las | \
         wert | función | polinomio~ | valor | valeur | calcola | trova | qué es | cuál es | \
         form | basis | equation | gleichung | l'équation | 方程 | aus | arguments | \
         possible | möglich | posible | possibile | wie | wie lauten | welche~ | which | which are | cuáles son | cuáles | cuál | quels sont | quelles sont | quelles | quels | quali sono | \
         can you tell me | i would like | i'd like | i want to know | let me | let us | let's | now | then | also | just | simply | explicitly | resulting | \
         corresponding | consider | take | turn | bring | put | make | draw up | work out | derive for me | \
         in closed form | step by step | schritt für schritt | étape par étape | paso a paso | hallo bitte | can you please | bitte gib | bitte berechne | \
         qual è | evalúa | evaluar | valuta | triangle | dreieck~ | triángulo | triangolo | 三角形 | curves | kurven | courbes | curve bezier | segments | segmente | polynome | polynomials | functions | funktionen | 两条 | je voudrais | je veux | ich möchte | ich brauche | ich hätte gern | quiero | necesito | vorrei | \
         calcúlame | dame | dime | dammi | dimmi | gib mir | zeig mir | zeige mir | donne moi | montre moi | muéstrame | mostra | \
         the following | folgende~ | suivant~ | siguiente~ | seguente | given by | gegeben durch | donné par | donnée par | dado por | dada por | dato da | \
         whose | deren | dessen | dont | both | both halves | both parts | both polygons | beide | beide teile | les deux | ambos | ambas | \
         polygon | polygone | polígono | poligono | result | ergebnis | résultat | resultado | risultato | answer | segment | stück | straight | \
         in exact form | genau | exakt | exactement | exactamente | esattamente | 精确 | 给出 | 写出 | 求出 | 请问 | 什么是 | 是多少 | 等于多少 | 怎么算 | 的值 | 进行 | ein",
    ),
];
