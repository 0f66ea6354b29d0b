mod problems;
mod properties;
mod rows;
mod sexpr;
mod trees;
