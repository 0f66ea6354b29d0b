//! Lines that say more than one formula: what is supposed and defined in them, and what is asked.
//!
//! | file | lines |
//! | --- | --- |
//! | `several` | formulas beside each other |
//! | `data` | a question and its data, in any order |
//! | `clauses` | definitions in words |
//! | `described` | an object in words, and questions about it |
//! | `core` | what a line asks for inside of other words |
//! | `condition`, `unknown`, `sought`, `systems` | a name, a function, a name in its definition, several names that conditions determine |
//! | `certified` | claims about signs |
//! | `members` | members of a family without their argument |
//! | `units` | which lines of a file are read together |

mod certified;
mod clauses;
mod condition;
mod core;
mod data;
mod described;
mod members;
mod several;
mod sought;
mod systems;
mod units;
mod unknown;
