//! The commands about curves: each writes out a query of the language.

use super::arguments::{BezierArguments, BsplineArguments, Change};

/// `[…]` around a list that has no brackets of its own around all of it.
fn bracketed(list: &str) -> String {
    let trimmed = list.trim();
    let mut depth = 0;
    let closes_at_end = trimmed.starts_with('[')
        && trimmed.char_indices().find_map(|(i, c)| {
            depth += i32::from(c == '[') - i32::from(c == ']');
            (depth == 0).then_some(i)
        }) == Some(trimmed.len() - 1);
    // `[[0, 0], [1, 2]]` is a list of points, `[0, 0]` a single point.
    if closes_at_end && trimmed[1..].trim_start().starts_with('[') {
        trimmed.to_owned()
    } else {
        format!("[{trimmed}]")
    }
}

/// The curve with the changes made.
fn changed(mut query: String, change: &Change) -> String {
    for (name, order) in
        [("elevate", change.elevate), ("reduce", change.reduce), ("derivative", change.derivative)]
    {
        if let Some(order) = order {
            query = format!("{name}({query}, {order})");
        }
    }
    query
}

/// The query of `polarform bezier`.
pub(super) fn bezier(arguments: &BezierArguments) -> String {
    let interval = arguments.interval.as_ref().map_or(String::new(), |ends| format!(", {ends}"));
    let weights = arguments.weights.as_ref().map_or(String::new(), |list| format!(", weights=[{list}]"));
    let curve = format!("bezier({}{interval}{weights})", bracketed(&arguments.points));
    let curve = changed(curve, &arguments.change);
    if let Some(t) = &arguments.at {
        format!("extended({curve}, {t})")
    } else if let Some(list) = &arguments.scheme {
        format!("casteljau({curve}, {list})")
    } else if let Some(list) = &arguments.subdivide {
        format!("subdivide({curve}, {list})")
    } else {
        curve
    }
}

/// The query of `polarform bspline`.
pub(super) fn bspline(arguments: &BsplineArguments) -> String {
    let start = format!("{}, [{}]", arguments.degree, arguments.knots);
    let Some(points) = &arguments.points else {
        let index = arguments.basis.unwrap_or(0);
        let function = format!("bspline_basis({start}, {index})");
        let function = match arguments.change.derivative {
            Some(order) => format!("derivative({function}, {order})"),
            None => function,
        };
        return match &arguments.at {
            Some(t) => format!("{function}({t})"),
            None => function,
        };
    };
    let weights = arguments.weights.as_ref().map_or(String::new(), |list| format!(", weights=[{list}]"));
    let mut curve = format!("bspline({start}, {}{weights})", bracketed(points));
    if let Some(list) = &arguments.insert {
        curve = format!("insert_knots({curve}, {list})");
    }
    if let Some(t) = &arguments.remove {
        curve = format!("remove_knot({curve}, {t})");
    }
    let curve = changed(curve, &arguments.change);
    if let Some(t) = &arguments.at {
        format!("{curve}({t})")
    } else if let Some(list) = &arguments.scheme {
        let span = arguments.span.map_or(String::new(), |j| format!(", span={j}"));
        format!("deboor({curve}, {list}{span})")
    } else if arguments.pieces {
        format!("pieces({curve})")
    } else if arguments.labels {
        format!("labels({curve})")
    } else {
        curve
    }
}

#[cfg(test)]
mod tests {
    use super::bracketed;

    #[test]
    fn lists_get_one_pair_of_brackets() {
        assert_eq!(bracketed("1, 2"), "[1, 2]");
        assert_eq!(bracketed("[0, 0], [1, 2]"), "[[0, 0], [1, 2]]");
        assert_eq!(bracketed("[[0, 0], [1, 2]]"), "[[0, 0], [1, 2]]");
        assert_eq!(bracketed("[0, 0]"), "[[0, 0]]");
        assert_eq!(bracketed(""), "[]");
    }
}
