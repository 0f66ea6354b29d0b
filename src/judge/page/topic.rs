//! What a section speaks of, as far as its words tell.

/// A subject of the field.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Topic {
    /// Bézier curves.
    BezierCurve,
    /// Bernstein polynomials, and what is made of them.
    Bernstein,
    /// Other rings and groups than numbers and polynomials with real coefficients: numbers modulo another, finite
    /// fields, complex numbers, products of vectors.
    Modular,
    /// Polar forms.
    PolarForm,
    /// Control points of Bézier curves.
    ControlPoints,
    /// The same curve with a higher degree.
    Elevation,
    /// Parts of a curve, refinement of its control points.
    Subdivision,
    /// The first, or left, of two parts.
    First,
    /// The second, or right, of two parts.
    Second,
    /// The halves of a curve.
    Half,
    /// B-splines, their knots and algorithms.
    Spline,
    /// Where two curves meet.
    Join,
    /// Rational curves, conics.
    Rational,
    /// Interpolation.
    Interpolation,
    /// Interpolation by the schemes of Neville and Aitken.
    Neville,
    /// De Casteljau's algorithm.
    Casteljau,
    /// Divided differences.
    DividedDifference,
    /// Differences of values at equal distances.
    Difference,
    /// A knot that is inserted.
    Insertion,
    /// Derivatives, tangents.
    Derivative,
    /// Integrals, moments of functions.
    Integral,
    /// Knots or data at equal distances.
    Uniform,
    /// Knots or intervals of different lengths, or of a length that is said.
    Uneven,
    /// Control points of a piece of a spline.
    Conversion,
    /// Second derivatives of a spline at its knots.
    Moments,
    /// Interpolation of values and derivatives.
    Hermite,
    /// Curvature and torsion.
    Curvature,
    /// Abscissae at which control points stand.
    Greville,
    /// Triangular patches, barycentric coordinates.
    Triangle,
    /// Patches over rectangles, surfaces.
    Tensor,
    /// Weights that are given other values, with the same curve.
    StandardForm,
    /// Subdivision of meshes.
    Mesh,
    /// Products of polynomials.
    Product,
    /// Recursions, algorithms.
    Recursion,
    /// Symmetric functions of several variables.
    Symmetric,
    /// Schemes that refine polygons.
    Scheme,
    /// Bilinear patches.
    Bilinear,
    /// Splines with the slopes of Catmull and Rom.
    CatmullRom,
    /// Matrices, operators and permutations, which need not commute.
    Operators,
    /// Vectors, of which there are several products.
    Vectors,
}

/// The topics by the words of the table of theorems.
const WORDS: &[(&str, Topic)] = &[
    ("bezier-curve", Topic::BezierCurve),
    ("bernstein", Topic::Bernstein),
    ("polar-form", Topic::PolarForm),
    ("control-points", Topic::ControlPoints),
    ("elevation", Topic::Elevation),
    ("subdivision", Topic::Subdivision),
    ("first", Topic::First),
    ("second", Topic::Second),
    ("spline", Topic::Spline),
    ("join", Topic::Join),
    ("rational", Topic::Rational),
    ("interpolation", Topic::Interpolation),
    ("neville", Topic::Neville),
    ("casteljau", Topic::Casteljau),
    ("divided-difference", Topic::DividedDifference),
    ("difference", Topic::Difference),
    ("insertion", Topic::Insertion),
    ("derivative", Topic::Derivative),
    ("integral", Topic::Integral),
    ("uniform", Topic::Uniform),
    ("uneven", Topic::Uneven),
    ("conversion", Topic::Conversion),
    ("moments", Topic::Moments),
    ("hermite", Topic::Hermite),
    ("curvature", Topic::Curvature),
    ("greville", Topic::Greville),
    ("triangle", Topic::Triangle),
    ("tensor", Topic::Tensor),
    ("standard-form", Topic::StandardForm),
    ("mesh", Topic::Mesh),
    ("product", Topic::Product),
    ("recursion", Topic::Recursion),
    ("symmetric", Topic::Symmetric),
    ("scheme", Topic::Scheme),
    ("catmull-rom", Topic::CatmullRom),
];

impl Topic {
    /// The topic of a word of the table of theorems.
    pub(in crate::judge) fn of_word(word: &str) -> Option<Topic> {
        WORDS.iter().find(|(known, _)| *known == word).map(|(_, topic)| *topic)
    }
}

/// The topics of a section, and the degrees that it names by words: "cubic".
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Topics {
    topics: u64,
    degrees: u16,
}

impl Topics {
    /// Adds a topic.
    pub fn add(&mut self, topic: Topic) {
        self.topics |= 1u64 << topic as u32;
    }

    /// Adds a degree.
    pub fn add_degree(&mut self, degree: i64) {
        if (0..16).contains(&degree) {
            self.degrees |= 1 << degree;
        }
    }

    /// What a title says of all that stands under it: no degrees, and nothing that excludes something else, since a title
    /// may name several things.
    pub fn of_title(self) -> Self {
        const SUBJECTS: [Topic; 9] = [
            Topic::Spline,
            Topic::Tensor,
            Topic::Triangle,
            Topic::Rational,
            Topic::Uniform,
            Topic::Uneven,
            Topic::First,
            Topic::Second,
            Topic::Half,
        ];
        let subjects = SUBJECTS.into_iter().fold(0, |all, own| all | 1u64 << own as u32);
        Topics { degrees: 0, topics: self.topics & !subjects }
    }

    /// Of two parts only the one spoken of last counts.
    pub fn keep_side(&mut self, side: Option<Topic>) {
        for other in [Topic::First, Topic::Second] {
            if side.is_some_and(|side| side != other) {
                self.topics &= !(1u64 << other as u32);
            }
        }
    }

    /// Whether anything is spoken of.
    pub fn any(self) -> bool {
        self.topics != 0
    }

    /// Whether it is spoken of.
    pub fn has(self, topic: Topic) -> bool {
        self.topics & (1u64 << topic as u32) != 0
    }

    /// The degrees, in increasing order.
    pub fn degrees(self) -> impl Iterator<Item = i64> {
        (0..16).filter(move |degree| self.degrees & (1 << degree) != 0)
    }
}
