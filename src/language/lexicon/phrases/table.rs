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
    (Function("polar"), "forme~ polaire~ | forma~ polar~"),
    (Command("polar"), "polarize | polarise | polarisiere~ | polariser | polarizar"),
    (Function("derivative"), "erste~ ableitung | tangent"),
    (
        Command("derivative"),
        "differentiate | derive | dérive | dériver | differenziere~ | 求导 | derivar | deriva",
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
        "have zero | touch zero | touches zero | cross zero | crosses zero | cross the axis | touch the axis | have zeros",
    ),
    (
        Function("count_roots"),
        "how many roots has | how many real roots has | how many solutions has | how many real solutions has | how many real zeros has | how many solutions does | how many real solutions does | how many zeros does | how many real zeros does | how many zeros has | how many real roots does | how many roots does | wie viele nullstellen hat | wie viele lösungen hat | combien de racines a",
    ),
    (Degree(1), "line | gerade | droite | recta | retta | 直线"),
    (Function("taylor"), "polynôme~ de taylor"),
    (
        Phrase::TrueDegree,
        "true degree | actual degree | exact degree | real degree | genuine degree | tatsächlicher grad | \
         tatsächlichen grad | wahrer grad | wahren grad | echter grad | exakter grad | degré réel | degré effectif | \
         degré exact | grado real | grado verdadero | grado effettivo | 真正的次数 | 实际次数",
    ),
    (Function("in_bernstein"), "bernstein 系数 | bernstein 基"),
    (Function("expand"), "powers | standard form | polynomial form | normal form"),
    (Function("bernstein"), "polinomio~ de bernstein | polinomio~ di bernstein | bernstein basis functions"),
    (Function("bezier_points"), "point~ de bézier | bézier控制点 | bezier控制点"),
    (Function("control_points"), "point~ de contrôle"),
    (
        Function("bezier"),
        "curva~ de bézier | curva~ de bezier | curva~ di bézier | curva~ di bezier | bernsteinpolynom mit koeffizienten",
    ),
    (
        Command("elevate"),
        "elevate | raise degree | \
         raise | degree elevated | élève le degré de | élever le degré | eleva el grado | eleva il grado | aumenta el grado | grad erhöhen | elevate degree | raise the degree | elevate the degree | degree elevate | \
         degree raise | erhöhe den grad | elevar el grado | 升阶",
    ),
    (
        Command("reduce"),
        "degree reduce | reduce degree | \
         degree lower | reduziere den grad | senke den grad | grad reduzieren | réduire le degré | reduce el grado | written with lower degree | reduce the degree | lower degree | lower the degree | 降阶",
    ),
    (
        Command("subdivide"),
        "split | subdivide | \
         cut | chop | bisect | halve | divide | zerlege~ | zerteile~ | halbiere~ | coupe | couper | divise | diviser | corta | cortar | dividir | 分成 | 拆分 | unterteile~ | teile | subdivise~ | subdiviser | subdividir | suddividi | 细分 | 分割",
    ),
    (
        Function("degree"),
        "what degree has | what degree does | which degree has | which degree does | welchen grad hat | quel degré a | \
         qué grado tiene | che grado ha",
    ),
    (
        Command("subs"),
        "plug | plug in | substitute | put in | setze | setze ein | einsetzen | substituer | substitue | remplace | remplacer | \
         sustituye | sustituir | sustituyendo | sostituisci | sostituire | 代入",
    ),
    (
        Command("figure_bezier"),
        "draw | sketch | zeichne~ | skizziere | plotte | tracer | dessine | dessiner | dibuja | dibujar | grafica | graficar | \
         disegna | disegnare | 画 | 绘制 | 画出",
    ),
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
    (Function("maximum"), "am größten | largest | greatest"),
    (Function("minimum"), "am kleinsten | smallest | least"),
    (Command("min"), "which is smaller | which is less | was ist kleiner | smaller"),
    (
        Command("implicit"),
        "eliminate t | eliminate the parameter | eliminate the parameter t | implicitize | implicitise | eliminiere t",
    ),
    (Function("bspline_basis"), "bspline~"),
    (
        Function("esym"),
        "elementarsymmetrisch~ funktion~ | elementarsymmetrisch~ polynom~ | polynôme~ symétrique~ élémentaire~ | fonction~ symétrique~ élémentaire~",
    ),
    (Function("pieces"), "bézier segments | bezier segments | bézier segmente | bezier segmente"),
    (Function("inflections"), "point~ d'inflexion"),
    (Function("intersections"), "intersections"),
    (Function("double_points"), "point~ double"),
    (
        Command("intersections"),
        "intersect | intersects | meet | meets | schneide | schneidet | trifft | intersecte | rencontre | intersecta | interseca",
    ),
    (
        Function("continuity"),
        "join | joins | joint | meet smoothly | continuous | stetig | glatt | übergang | smooth | smoothly | join smoothly | continues | continuas",
    ),
    (Function("differences"), "vorwärtsdifferenzen"),
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
        Command("insert_knots"),
        "insert knot | insert knots | knot insertion | \
         insert | add knot | füge den knoten | füge knoten | knoten einfügen | insère le nœud | insérer le nœud | insérer | inserta el nudo | inserta | inserisci | boehm | boehm's algorithm | 插入节点",
    ),
    (
        Function("lagrange"),
        "polynomial through | polynom durch | polynôme passant par | polinomio por | polinomio que pasa por",
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
        Command("standard_form"),
        "normalise | normalize | normalised | normalized | normiere | normalisiere | normaliser | normaliza | \
         normalizza",
    ),
    (Command("lagrange"), "interpolate | interpoliere~ | interpole~ | interpoler | interpolar | 插值"),
    (
        Function("divided_differences"),
        "dividierte~ differenz~ | différence~ divisée~ | diferencia~ dividida~",
    ),
    (Command("inverse"), "invert | invertiere | inverser"),
    (Between("binomial"), "choose | parmi"),
    (Function("sqrt"), "wurzel"),
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
        "second order | zweiter ordnung | deuxième ordre | segundo orden | secondo ordine | second~ | zweite~ | deuxième~ | segund~ | twice | two times | zweimal | deux fois | dos veces | due volte | 二阶",
    ),
    (
        Ordinal(3),
        "third order | dritter ordnung | troisième ordre | tercer orden | terzo ordine | third | dritte~ | troisième~ | tercer~ | terz~ | thrice | three times | dreimal | trois fois | tres veces | 三阶",
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
        Function("diagonal"),
        "polynomial whose | polynomial with the blossom | polynomial with blossom | polynomial with the polar form | \
         polynomial with polar form | polynom mit der polarform | polynom mit polarform | polynom dessen | polynôme dont la | polynôme dont | \
         polinomio cuya | polinomio la cui",
    ),
    (Function("conic_kind"), "type of the conic"),
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
        "around | about | autour de | alrededor de | intorno a | at | in the point | parameter | parameter value | parameterwert | paramètre | parámetro | parametro | at the parameter value | at parameter value | 参数 | 参数值 | 在参数 | at barycentric | new knot | new knots | neuer knoten | neuen knoten | nouveau nœud | nuevo nudo | at barycentric coordinates | at the barycentric coordinates | en el punto | nel punto | at parameter | at the parameter | at the point | bei | an der stelle | für t | \
         im punkt | en | au point | 在 | evaluated at | ausgewertet bei | évaluée en | value at | \
         wert bei",
    ),
    (
        Phrase::Label(Over),
        "over | on | su | sull'intervallo | on the interval | \
         on interval | within | auf dem intervall | parameter interval | parameter range | subinterval | teilintervall | sous intervalle | subintervalo | dans l'intervalle | over the interval | über | auf | im intervall | sur | \
         sur l'intervalle | in the interval | interval | intervall | \
         intervalle | 区间 | sobre | en el intervalo | intervalo | nell'intervallo | intervallo",
    ),
    (Phrase::Label(From), "from | desde | 从 | between | zwischen | entre"),
    (
        Phrase::Label(To),
        "in terms of | in form of | in the form of | to | hasta | bis | à | jusqu'à | auf grad | into | nach | in die | 到 | 转换为 | 转化为 | dans la | \
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
        "let | suppose | assume | sei | seien | gegeben | gegeben sei~ | gegeben ist | soit | soient | étant donné~ | on donne | sea | sean | dada~ | sia | siano | 设 | 已知 | 令 | 给定 | for | with | where | when | given | under | unter | sous | bajo | sotto | für | mit | avec | pour | wobei | con | para | par | por | zu | zum | donde",
    ),
    (
        Phrase::Label(Through),
        "through | passing through | that passes through | which passes through | durch | passant par | que pasa por | que pasa por los puntos | passante per | attraverso | 经过 | 通过",
    ),
    (
        Phrase::Label(OfDegree),
        "order | of order | to order | up to order | ordnung | der ordnung | ordre | d'ordre | orden | de orden | ordine | di ordine | degree | deg | grad~ | degré~ | vom grad | of degree | de degré | de grado | di grado | \
         du degré | 次数",
    ),
    (
        Phrase::Label(Knots),
        "uniform knots | knots | nudos | nodos | nodi | vector de nudos | knot vector | knot sequence | knoten | knotenvektor~ | knotenfolge | nœuds | noeuds | \
         vecteur nodal | 节点",
    ),
    (
        Phrase::Label(Nodes),
        "nodes | node | aux nœuds | aux noeuds | at the nodes | at nodes | an den knoten | en los nodos | nei nodi | stützstelle~ | den stellen | an den stellen | den stützstellen | abscissae | abscissas | abscisses",
    ),
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
        "rounds | round | passes | pass | levels | runde~ | tours | rondas | passaggi | times | step~ | schritt~ | étape~ | paso~ | iteration~ | 步 | mal | fois | veces | volte | 次",
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
