//! Subdivision of meshes around a vertex or a face of any valence.

use super::gives::Gives;
use std::sync::Arc;

use nalgebra::DMatrix;

use super::parameter::{Parameter, required, size};
use super::{Builtin, notions};
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::eval::{Arguments, Machine};
use crate::language::ops::errors::{division_by_zero, subdivision_error};
use crate::language::ops::formula::symbol_of;
use crate::language::ops::geometry::scalar_list;
use crate::language::ops::takes::Takes;
use crate::language::value::{Cell, Table, Value};
use crate::language::write::text;
use crate::math::number::rational;
use crate::math::poly::{Fraction, MultiPoly, Poly, Symbol};
use crate::math::ring::{Field, Ring};
use crate::math::subdivision::{
    Cosine, VertexScheme, vertex_eigenvalues, vertex_limit, vertex_matrix, vertex_tangents,
};

type Result<T> = std::result::Result<T, Diagnostic>;

const NEW: Builtin = Builtin::about("Subdivision");

const PARAMETERS: &[Parameter] = &[
    required("scheme", notions::MESH, "the scheme for meshes"),
    size("n", "how many edges the vertex has, for doo_sabin corners of the face"),
];

pub(super) const TABLE: &[Builtin] = &[
    Builtin {
        name: "vertex_matrix",
        parameters: PARAMETERS,
        summary: "the matrix of a step: the vertex, its neighbours, opposite corners; c is cos(2 pi/n)",
        gives: Gives::Matrix,
        example: "vertex_matrix(catmull_clark, 3)",
        call: |machine, args| {
            let (scheme, n) = scheme_and_valence(args)?;
            let matrix = vertex_matrix(scheme, n).map_err(subdivision_error).at(args.span(1))?;
            tell_cosine(machine, args, n, matrix.iter());
            Ok(Value::Matrix(matrix.map(|entry| in_cosine(&entry))))
        },
        ..NEW
    },
    Builtin {
        name: "vertex_limit",
        parameters: &[
            required("scheme", notions::MESH, "the scheme for meshes"),
            required(
                "n",
                Takes::OneOf(&[Takes::Size, Takes::Variable]),
                "how many edges the vertex has, or a symbol",
            ),
        ],
        summary: "the weights of the points around a vertex in its limit, in the order of vertex_matrix",
        gives: Gives::List,
        example: "vertex_limit(catmull_clark, 5)",
        call: |machine, args| {
            if let Some(n) = symbol_of(args.value(1)?) {
                return for_any_valence(machine, args, &n);
            }
            let (scheme, n) = scheme_and_valence(args)?;
            let weights = vertex_limit(scheme, n).map_err(subdivision_error).at(args.span(1))?;
            tell_cosine(machine, args, n, weights.iter());
            Ok(scalar_list(weights.iter().map(in_cosine)))
        },
        ..NEW
    },
    Builtin {
        name: "vertex_tangents",
        parameters: PARAMETERS,
        summary: "two rows of weights of the points around a vertex: tangent vectors of its limit",
        gives: Gives::Matrix,
        example: "vertex_tangents(loop, 4)",
        call: |machine, args| {
            let (scheme, n) = scheme_and_valence(args)?;
            let (rows, lambda) = vertex_tangents(scheme, n).map_err(subdivision_error).at(args.span(1))?;
            tell_cosine(machine, args, n, rows.iter().flatten().flatten());
            let letter = Symbol::new("lambda");
            if rows.iter().flatten().any(|weight| !weight[1].is_zero()) {
                let root = text(&Value::root(lambda, &letter).to_expr());
                let message = format!("lambda is the second largest eigenvalue, {root}");
                machine.note(Diagnostic::note(Code::Irrational, message).at(args.span(1)));
            }
            let lambda = Fraction::from(MultiPoly::symbol(letter));
            let entry = |[rest, slope]: &[Poly; 2]| in_cosine(rest).plus(&in_cosine(slope).times(&lambda));
            Ok(Value::Matrix(DMatrix::from_fn(2, rows[0].len(), |i, j| entry(&rows[i][j]))))
        },
        ..NEW
    },
    Builtin {
        name: "vertex_eigenvalues",
        parameters: PARAMETERS,
        summary: "the eigenvalues of vertex_matrix with multiplicities, the largest first, exactly",
        gives: Gives::Table,
        example: "vertex_eigenvalues(loop, 5)",
        call: |_, args| {
            let (scheme, n) = scheme_and_valence(args)?;
            let found = vertex_eigenvalues(scheme, n).map_err(subdivision_error).at(args.span(1))?;
            let lambda = Symbol::new("lambda");
            let mut table = Table::with_header(["eigenvalue", "multiplicity"]);
            for (root, multiplicity) in found {
                let count = Value::int(multiplicity as i64);
                table.rows.push(vec![Cell::Value(Value::root(root, &lambda)), Cell::Value(count)]);
            }
            Ok(Value::Table(Arc::new(table)))
        },
        ..NEW
    },
];

/// The weights for the vertex, each neighbour and each opposite corner, as formulas in the valence.
fn for_any_valence(machine: &mut Machine, args: &Arguments, n: &Symbol) -> Result<Value> {
    let scheme = notions::mesh(args, 0)?;
    let n = Fraction::from(MultiPoly::symbol(n.clone()));
    let number = |p: i64, q: i64| Fraction::from(rational(p, q));
    let over = |above: Fraction, below: Fraction| {
        below.inverse().map(|inverse| above.times(&inverse)).ok_or_else(division_by_zero).at(args.span(1))
    };
    let of_triangles = |beta_n: Fraction| -> Result<Vec<Fraction>> {
        // 8 β/(3 + 8 n β) for each neighbour, by n β
        let each =
            over(beta_n.times(&number(8, 1)), n.times(&number(3, 1).plus(&beta_n.times(&number(8, 1)))))?;
        Ok(vec![number(1, 1).minus(&n.times(&each)), each])
    };
    let (weights, of) = match scheme {
        VertexScheme::CatmullClark => {
            let below = n.plus(&number(5, 1));
            let each = over(number(1, 1), n.times(&below))?;
            let list = vec![over(n.clone(), below)?, each.times(&number(4, 1)), each];
            (list, "the vertex, each neighbour, each opposite corner")
        }
        VertexScheme::DooSabin => (vec![over(number(1, 1), n.clone())?], "each corner of the face"),
        VertexScheme::Warren => {
            (of_triangles(number(3, 8))?, "the vertex, each neighbour; n = 3 has 3/16 for 3/(8 n)")
        }
        VertexScheme::Loop => {
            let c = Fraction::from(MultiPoly::symbol(Symbol::new("c")));
            let inner = number(3, 8).plus(&c.times(&number(1, 4)));
            let list = of_triangles(number(5, 8).minus(&inner.times(&inner)))?;
            (list, "the vertex, each neighbour, with c = cos(2 pi/n)")
        }
    };
    machine.note(Diagnostic::note(Code::StandardMeaning, format!("the weights of {of}")).at(args.span(0)));
    Ok(scalar_list(weights))
}

fn scheme_and_valence(args: &Arguments) -> Result<(VertexScheme, usize)> {
    Ok((notions::mesh(args, 0)?, args.size(1)?))
}

fn in_cosine(weight: &Poly) -> Fraction {
    Fraction::from(weight.value_in(&MultiPoly::symbol(Symbol::new("c"))))
}

/// Says what c is, if it occurs.
fn tell_cosine<'a>(
    machine: &mut Machine,
    args: &Arguments,
    n: usize,
    mut weights: impl Iterator<Item = &'a Poly>,
) {
    if weights.all(|weight| weight.degree().unwrap_or(0) == 0) {
        return;
    }
    let root = text(&Value::root(Cosine::new(n).value, &Symbol::new("c")).to_expr());
    let message = format!("c = cos(2 pi/{n}), the number {root}");
    let note = Diagnostic::note(Code::Irrational, message).at(args.span(1));
    machine.note(note.hint("warren has rational weights, as has catmull_clark"));
}
