//! Values one after the other.

use std::ops::{Deref, DerefMut};

use crate::formula::{Expr, Kind};

/// Things one after the other: a list, or the coordinates of a point.
///
/// A point is calculated with as its list of coordinates is, and equals it; it is only written in round brackets.
#[derive(Clone, Debug)]
pub struct List<T> {
    items: Vec<T>,
    point: bool,
}

impl<T> List<T> {
    /// The coordinates of a point.
    pub(crate) fn point(items: Vec<T>) -> Self {
        List { items, point: true }
    }

    /// Whether these are the coordinates of a point.
    pub(crate) fn is_point(&self) -> bool {
        self.point
    }

    /// Other things instead: coordinates of a point where these are.
    pub(crate) fn with(&self, items: Vec<T>) -> Self {
        List { items, point: self.point }
    }

    /// The formula with these items: [x, y], or (x, y) for a point.
    pub(crate) fn formula(&self, items: Vec<Expr>) -> Expr {
        // (x) is a group.
        match self.point && items.len() > 1 {
            true => Kind::Tuple(items).into(),
            false => Kind::List(items).into(),
        }
    }
}

impl<T> From<Vec<T>> for List<T> {
    fn from(items: Vec<T>) -> Self {
        List { items, point: false }
    }
}

impl<T: PartialEq> PartialEq for List<T> {
    fn eq(&self, other: &Self) -> bool {
        self.items == other.items
    }
}

impl<T> Deref for List<T> {
    type Target = Vec<T>;

    fn deref(&self) -> &Vec<T> {
        &self.items
    }
}

impl<T> DerefMut for List<T> {
    fn deref_mut(&mut self) -> &mut Vec<T> {
        &mut self.items
    }
}

impl<T> FromIterator<T> for List<T> {
    fn from_iter<I: IntoIterator<Item = T>>(items: I) -> Self {
        List::from(Vec::from_iter(items))
    }
}

impl<T> IntoIterator for List<T> {
    type Item = T;
    type IntoIter = std::vec::IntoIter<T>;

    fn into_iter(self) -> Self::IntoIter {
        self.items.into_iter()
    }
}

impl<'a, T> IntoIterator for &'a List<T> {
    type Item = &'a T;
    type IntoIter = std::slice::Iter<'a, T>;

    fn into_iter(self) -> Self::IntoIter {
        self.items.iter()
    }
}
