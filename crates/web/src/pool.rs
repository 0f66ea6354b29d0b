//! Memory for small values, by size.
//!
//! Exact arithmetic asks for many small pieces of memory, and the allocator that comes with the target searches for each.
//! Here a freed piece goes to a list of its size, from where the next of that size is taken. Memory of a size stays with that size; larger
//! pieces are left to the allocator of the target.
#![allow(unsafe_code)]

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::UnsafeCell;
use std::ptr;

/// Sizes are rounded up to a multiple of this.
const STEP: usize = 8;

/// Pieces up to `CLASSES * STEP` bytes stand in lists.
const CLASSES: usize = 64;

/// So much is taken from the target at once.
const CHUNK: usize = 1 << 16;

/// A piece that is free.
struct Free {
    next: *mut Free,
}

struct Lists {
    free: [*mut Free; CLASSES],
    /// What is left of the newest chunk.
    rest: *mut u8,
    left: usize,
}

/// The allocator. It must not be shared between threads.
pub(crate) struct Pool(UnsafeCell<Lists>);

impl Pool {
    pub const fn new() -> Self {
        Pool(UnsafeCell::new(Lists { free: [ptr::null_mut(); CLASSES], rest: ptr::null_mut(), left: 0 }))
    }
}

// Safety: WebAssembly without threads is the only target that has it as its allocator.
unsafe impl Sync for Pool {}

/// The list for pieces of this layout, if they stand in one.
fn class(layout: Layout) -> Option<usize> {
    (layout.align() <= STEP && layout.size() <= CLASSES * STEP && layout.size() > 0)
        .then(|| (layout.size() - 1) / STEP)
}

// Safety: a piece is handed out from the chunk, or from the list of its class where `dealloc` put it, never from both; all pieces of
// a class have the same size, a multiple of STEP, and start at multiples of STEP, since chunks do.
unsafe impl GlobalAlloc for Pool {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        let Some(class) = class(layout) else { return unsafe { System.alloc(layout) } };
        let lists = unsafe { &mut *self.0.get() };
        let head = lists.free[class];
        if !head.is_null() {
            lists.free[class] = unsafe { (*head).next };
            return head.cast();
        }
        let size = (class + 1) * STEP;
        if lists.left < size {
            let chunk = unsafe { System.alloc(Layout::from_size_align_unchecked(CHUNK, STEP)) };
            if chunk.is_null() {
                return chunk;
            }
            (lists.rest, lists.left) = (chunk, CHUNK);
        }
        let piece = lists.rest;
        lists.rest = unsafe { piece.add(size) };
        lists.left -= size;
        piece
    }

    unsafe fn dealloc(&self, piece: *mut u8, layout: Layout) {
        let Some(class) = class(layout) else { return unsafe { System.dealloc(piece, layout) } };
        let lists = unsafe { &mut *self.0.get() };
        let piece: *mut Free = piece.cast();
        unsafe { piece.write(Free { next: lists.free[class] }) };
        lists.free[class] = piece;
    }

    unsafe fn realloc(&self, piece: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        let wanted = unsafe { Layout::from_size_align_unchecked(size, layout.align()) };
        match (class(layout), class(wanted)) {
            (None, None) => unsafe { System.realloc(piece, layout, size) },
            (old, new) if old == new => piece,
            _ => {
                let new = unsafe { self.alloc(wanted) };
                if !new.is_null() {
                    unsafe {
                        ptr::copy_nonoverlapping(piece, new, layout.size().min(size));
                        self.dealloc(piece, layout);
                    }
                }
                new
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Pieces of all sizes, grown, shrunk and freed in a wild order, keep what was written into them.
    #[test]
    fn pieces_keep_their_content() {
        let pool = Pool::new();
        let mut held: Vec<(*mut u8, Layout, u8)> = Vec::new();
        let mut seed = 1u64;
        let mut random = |below: usize| {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 33) as usize % below
        };
        let intact =
            |piece: *mut u8, size: usize, mark: u8| (0..size).all(|i| unsafe { piece.add(i).read() } == mark);
        for round in 0..40_000usize {
            let mark = round as u8;
            match random(3) {
                0 if !held.is_empty() => {
                    let (piece, layout, mark) = held.swap_remove(random(held.len()));
                    assert!(intact(piece, layout.size(), mark));
                    unsafe { pool.dealloc(piece, layout) };
                }
                1 if !held.is_empty() => {
                    let at = random(held.len());
                    let (piece, layout, mark) = held[at];
                    let size = 1 + random(900);
                    let piece = unsafe { pool.realloc(piece, layout, size) };
                    assert!(intact(piece, layout.size().min(size), mark));
                    unsafe { piece.write_bytes(mark, size) };
                    held[at] = (piece, Layout::from_size_align(size, layout.align()).unwrap(), mark);
                }
                _ => {
                    let layout = Layout::from_size_align(1 + random(700), 1 << random(5)).unwrap();
                    let piece = unsafe { pool.alloc(layout) };
                    assert_eq!(piece as usize % layout.align(), 0);
                    unsafe { piece.write_bytes(mark, layout.size()) };
                    held.push((piece, layout, mark));
                }
            }
        }
        for (piece, layout, mark) in held {
            assert!(intact(piece, layout.size(), mark));
            unsafe { pool.dealloc(piece, layout) };
        }
    }
}
