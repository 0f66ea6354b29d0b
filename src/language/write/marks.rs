//! Which nodes hold something of a kind, found once for the whole tree.

use std::collections::HashSet;

use crate::formula::{Expr, Kind};

/// The nodes that are, or hold, a node with some property.
///
/// To ask each node for its descendants anew would take quadratic time in nested
/// brackets. Nodes are known by their address, so the marks hold for one tree in place.
pub(super) struct Marks(HashSet<*const Expr>);

enum Visit<'a> {
    Enter(&'a Expr),
    Leave,
}

impl Marks {
    /// Marks what holds a node with the property anywhere.
    pub(super) fn everywhere(root: &Expr, wanted: impl Fn(&Expr) -> bool) -> Self {
        Self::find(root, wanted, |_| true)
    }

    /// Marks what holds such a node, but not only in an index or exponent.
    pub(super) fn outside_scripts(root: &Expr, wanted: impl Fn(&Expr) -> bool) -> Self {
        Self::find(root, wanted, |expr| {
            !matches!(expr.kind, Kind::Subscript(..) | Kind::Upper(..) | Kind::Pow(..))
        })
    }

    /// Cost: linear; each node is entered once, and marked at most once.
    fn find(root: &Expr, wanted: impl Fn(&Expr) -> bool, all: impl Fn(&Expr) -> bool) -> Self {
        let mut marks = HashSet::new();
        let mut path: Vec<&Expr> = Vec::new();
        let mut stack = vec![Visit::Enter(root)];
        while let Some(visit) = stack.pop() {
            let Visit::Enter(expr) = visit else {
                path.pop();
                continue;
            };
            path.push(expr);
            stack.push(Visit::Leave);
            if wanted(expr) {
                for holder in path.iter().rev() {
                    if !marks.insert(std::ptr::from_ref(*holder)) {
                        break;
                    }
                }
            }
            let mut first_only = !all(expr);
            let mut done = false;
            expr.for_each_child(&mut |child| {
                if !done {
                    stack.push(Visit::Enter(child));
                    done = std::mem::take(&mut first_only);
                }
            });
        }
        Marks(marks)
    }

    /// Whether the node has the property or holds a node that has.
    pub(super) fn has(&self, expr: &Expr) -> bool {
        self.0.contains(&std::ptr::from_ref(expr))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn holders_are_marked() {
        let inner = Expr::product(vec![Expr::name("a"), Expr::name("x").grouped()]).grouped();
        let tree =
            Expr::product(vec![inner, Expr::name("b").grouped(), Expr::name("c").power(Expr::name("x"))]);
        let is_x = |expr: &Expr| matches!(&expr.kind, Kind::Name(name) if name == "x");
        let Kind::Mul(factors) = &tree.kind else { panic!("a product") };

        let marks = Marks::everywhere(&tree, is_x);
        assert!(
            marks.has(&tree) && marks.has(&factors[0]) && !marks.has(&factors[1]) && marks.has(&factors[2])
        );

        let marks = Marks::outside_scripts(&tree, is_x);
        assert!(
            marks.has(&tree) && marks.has(&factors[0]) && !marks.has(&factors[1]) && !marks.has(&factors[2])
        );
    }
}
