//! Subdivision of meshes around a vertex or a face of any valence.

use super::gives::Gives;
use std::sync::Arc;

use super::parameter::{Parameter, required, size};
use super::{Builtin, notions};
use crate::language::diagnostic::{At, Code, Diagnostic};
use crate::language::eval::{Arguments, Machine};
use crate::language::ops::errors::subdivision_error;
use crate::language::ops::geometry::scalar_list;
use crate::language::value::{Cell, Table, Value};
use crate::language::write::text;
use crate::math::poly::{Fraction, MultiPoly, Poly, Symbol};
use crate::math::subdivision::{Cosine, VertexScheme, vertex_eigenvalues, vertex_limit, vertex_matrix};

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
        parameters: PARAMETERS,
        summary: "the weights of the points around a vertex in its limit, in the order of vertex_matrix",
        gives: Gives::List,
        example: "vertex_limit(catmull_clark, 5)",
        call: |machine, args| {
            let (scheme, n) = scheme_and_valence(args)?;
            let weights = vertex_limit(scheme, n).map_err(subdivision_error).at(args.span(1))?;
            tell_cosine(machine, args, n, weights.iter());
            Ok(scalar_list(weights.iter().map(in_cosine)))
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
