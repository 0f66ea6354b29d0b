//! Formulas as polynomials: their variable and their coefficients.

use super::errors::{division_by_zero, wrong_kind};
use crate::language::diagnostic::{Code, Diagnostic};
use crate::language::lexicon::roles;
use crate::language::value::{Function, Polar, PolarKind, Value};
use crate::math::blossom::PolarForm;
use crate::math::poly::{Fraction, MultiPoly, Symbol};
use crate::math::ring::{Field, Ring};
use num_traits::One;

type Result<T> = std::result::Result<T, Diagnostic>;

/// The symbol a value is, if it is a bare one.
pub(crate) fn symbol_of(value: &Value) -> Option<Symbol> {
    let poly = value.as_scalar()?.as_polynomial()?;
    let [variable] = poly.variables() else { return None };
    (*poly == MultiPoly::symbol(variable.clone())).then(|| variable.clone())
}

/// Whether a symbol usually stands for a parameter: t, u, x and the like.
pub(crate) fn is_parameter(symbol: &Symbol) -> bool {
    symbol.is_plain() && (symbol.base() == "t" || roles::is_variable_of_formulas(symbol.base()))
}

/// The variable of a formula: the one asked for, the only one, t, or the only letter that
/// usually stands for a parameter.
pub(crate) fn variable_of(formula: &Fraction, given: Option<Symbol>) -> Result<Symbol> {
    if let Some(symbol) = given {
        return Ok(symbol);
    }
    let variables = formula.variables();
    let t = Symbol::new("t");
    if variables.contains(&t) {
        return Ok(t);
    }
    let usual: Vec<&Symbol> =
        variables.iter().filter(|s| s.is_plain() && roles::is_variable_of_formulas(s.base())).collect();
    if let [one] = usual.as_slice() {
        return Ok((*one).clone());
    }
    let plain: Vec<&Symbol> = variables.iter().filter(|symbol| symbol.is_plain()).collect();
    match (plain.as_slice(), variables.as_slice()) {
        ([one], _) => Ok((*one).clone()),
        ([], []) => Ok(Symbol::new("t")),
        ([], [one]) if one.base() == "t" || roles::is_variable_of_formulas(one.base()) => Ok(one.clone()),
        ([], _) if variables.iter().all(|symbol| !symbol.is_plain()) => Ok(Symbol::new("t")),
        _ => {
            let names: Vec<String> = variables.iter().map(Symbol::to_string).collect();
            Err(Diagnostic::error(
                Code::AmbiguousVariable,
                format!("which of {} is the parameter?", names.join(", ")),
            )
            .hint(format!("name it with variable={}", names[0])))
        }
    }
}

/// A polynomial in one variable as somebody gave it: the variable and its coefficients.
pub struct Univariate {
    /// The variable.
    pub variable: Symbol,
    /// Coefficients of 1, t, t², …
    pub coefficients: Vec<Fraction>,
}

/// Reads a value as a polynomial in one variable.
pub(crate) fn univariate(value: &Value, given: Option<Symbol>) -> Result<Univariate> {
    let (variable, formula) = match value {
        Value::Scalar(formula) => (variable_of(formula, given)?, formula.clone()),
        Value::Function(function) => formula_of(function)?,
        Value::Polar(polar) => match &polar.kind {
            PolarKind::Univariate(form) => {
                return Ok(Univariate {
                    variable: polar.variables[0].clone(),
                    coefficients: form.coefficients().to_vec(),
                });
            }
            _ => return Err(wrong_kind("a polynomial in one variable", value)),
        },
        other => return Err(wrong_kind("a polynomial", other)),
    };
    let coefficients = coefficients_in(&formula, &variable)?;
    Ok(Univariate { variable, coefficients })
}

/// The polar form that a function of several variables is; `None` unless its formula is symmetric and affine in each.
///
/// It is compared with the polar form of its diagonal. Cost: that of evaluating this form at symbols.
pub(crate) fn form_of(function: &Function) -> Option<Polar> {
    let (names, formula) = function.as_formula_of_many()?;
    let variable = Symbol::new(names.first()?.base());
    if formula.variables().contains(&variable) && !names.contains(&&variable) {
        return None;
    }
    let symbol = |name: &Symbol| Fraction::from(MultiPoly::symbol(name.clone()));
    let all: Vec<(Symbol, Fraction)> =
        names.iter().map(|name| ((*name).clone(), symbol(&variable))).collect();
    let coefficients = coefficients_in(&formula.substitute(&all).ok()?, &variable).ok()?;
    let form = PolarForm::with_degree(coefficients, names.len()).ok()?;
    let arguments: Vec<Fraction> = names.into_iter().map(symbol).collect();
    let same = form.value(&arguments).is_ok_and(|value| value == *formula);
    same.then(|| Polar { kind: PolarKind::Univariate(form), variables: vec![variable] })
}

fn formula_of(function: &Function) -> Result<(Symbol, Fraction)> {
    function.as_formula().map(|(t, formula)| (t.clone(), formula.clone())).ok_or_else(|| {
        Diagnostic::error(Code::Type, "expected a function of one variable given by one formula")
    })
}

/// The coefficients of a formula that is a polynomial in `variable`.
pub(crate) fn coefficients_in(formula: &Fraction, variable: &Symbol) -> Result<Vec<Fraction>> {
    if formula.denominator().variables().contains(variable) {
        return Err(Diagnostic::error(
            Code::NotPolynomial,
            format!("this is not a polynomial in {variable}: the variable stands in the denominator"),
        )
        .hint("only polynomials have a polar form; multiply by the denominator first"));
    }
    let denominator = Fraction::from(formula.denominator().clone());
    let list = formula.numerator().coefficients_in(variable);
    let inverse = denominator.inverse().ok_or_else(division_by_zero)?;
    Ok(list.into_iter().map(|c| Fraction::from(c) * inverse.clone()).collect())
}

/// The variable and the coordinates of a curve that is given by them, [t, t^2], as formulas or as functions; `None` for
/// anything else, such as numbers alone, which are control points.
///
/// # Errors
/// Several letters may be the parameter.
pub(crate) fn curve_of(value: &Value) -> Result<Option<(Symbol, Vec<Fraction>)>> {
    let Value::List(items) = value else { return Ok(None) };
    if items.is_empty() {
        return Ok(None);
    }
    let functions: Option<Vec<(&Symbol, &Fraction)>> = items
        .iter()
        .map(|item| match item {
            Value::Function(function) => function.as_formula(),
            _ => None,
        })
        .collect();
    if let Some(functions) = functions {
        let variable = functions[0].0;
        let own = Fraction::from(MultiPoly::symbol(variable.clone()));
        let renamed = |(t, formula): &(&Symbol, &Fraction)| match *t == variable {
            true => Ok((*formula).clone()),
            false => formula.substitute(&[((*t).clone(), own.clone())]).map_err(|_| division_by_zero()),
        };
        return Ok(Some((variable.clone(), functions.iter().map(renamed).collect::<Result<_>>()?)));
    }
    let formulas: Option<Vec<&Fraction>> = items.iter().map(Value::as_scalar).collect();
    let Some(formulas) = formulas else { return Ok(None) };
    if !formulas.iter().any(|formula| formula.variables().iter().any(is_parameter)) {
        return Ok(None);
    }
    // A sum of all letters has the same ones, and none cancels.
    let letters = formulas.iter().flat_map(|formula| formula.variables()).map(MultiPoly::symbol);
    let all = letters.fold(MultiPoly::zero(), |sum, x| sum + x);
    let variable = variable_of(&Fraction::from(all), None)?;
    Ok(Some((variable, formulas.into_iter().cloned().collect())))
}

/// Formulas over their least common denominator, which comes last, each by powers of a variable.
pub(crate) fn over_one_weight(formulas: &[Fraction], variable: &Symbol) -> Result<Vec<Vec<Fraction>>> {
    let below = formulas.iter().fold(MultiPoly::one(), |product, f| {
        let common = product.gcd(f.denominator());
        let rest = f.denominator().div_exact(&common).unwrap_or_else(|| f.denominator().clone());
        product.times(&rest)
    });
    let weight = Fraction::from(below);
    let scaled = formulas.iter().map(|f| f.times(&weight)).chain([weight.clone()]);
    scaled.map(|f| coefficients_in(&f, variable)).collect()
}
