//! Rewrites a module with exceptions (`try`, `catch`, `throw`) into one without: `lower IN OUT`.
//!
//! Hosts such as Typst have no exceptions, and without them a passed limit would be the end of the instance. After the
//! rewriting a thrown exception is a global that is not 0. Each call that may throw is followed by a look at it and a branch
//! to the nearest handler, or out of the function; a handler sets it to 0 and keeps what was thrown in a local.
//!
//! ```text
//! try T           block T                 throw         global.set thrown  i32.const 1  global.set pending  br handler
//!   a               block                 call f        call f  global.get pending  br_if handler
//! catch             a  br 1               rethrow n     local.get kept_n  (as throw)
//!   b               end
//! end               (pending := 0, kept := thrown)  local.get kept  b
//!                 end
//! ```
//! A function that may throw is itself in a block, the handler of what nothing in it catches; behind it stand zeros as results.
//! It is refused what compilers of Rust do not make: several tags, tags without a single i32, blocks with parameters around a
//! `try`, results other than numbers, and the newer instructions `try_table` and `throw_ref`.
//!
//! Reference: WebAssembly, proposal "exception handling" (legacy), explainer.

use std::error::Error;
use std::{env, fs};

use wasm_encoder::reencode::{Reencode, RoundtripReencoder};
use wasm_encoder::{
    BlockType, CodeSection, ConstExpr, Function, GlobalSection, GlobalType, Instruction, Module, RawSection,
    ValType,
};
use wasmparser::{CompositeInnerType, FuncType, FunctionBody, Operator, Parser, Payload, TypeRef};

type Result<T> = std::result::Result<T, Box<dyn Error>>;

fn main() -> Result<()> {
    let paths: Vec<String> = env::args().skip(1).collect();
    let [input, output] = paths.as_slice() else { return Err("usage: lower IN OUT".into()) };
    let lowered = lowered(&fs::read(input)?)?;
    wasmparser::Validator::new_with_features(wasmparser::WasmFeatures::WASM2).validate_all(&lowered)?;
    fs::write(output, lowered)?;
    Ok(())
}

/// What is known of the module before its code is rewritten.
#[derive(Default)]
struct Known<'a> {
    types: Vec<Option<FuncType>>,
    /// The type of each function, those of the host first.
    functions: Vec<u32>,
    imported: usize,
    globals: u32,
    tags: usize,
    bodies: Vec<FunctionBody<'a>>,
    /// Whether a call of a function may throw.
    throws: Vec<bool>,
}

impl Known<'_> {
    fn function(&self, index: u32) -> Result<&FuncType> {
        let at = self.functions.get(index as usize).ok_or("an unknown function")?;
        self.types.get(*at as usize).and_then(Option::as_ref).ok_or_else(|| "an unknown type".into())
    }

    /// The globals that are added.
    fn pending(&self) -> u32 {
        self.globals
    }

    fn thrown(&self) -> u32 {
        self.globals + 1
    }
}

fn lowered(bytes: &[u8]) -> Result<Vec<u8>> {
    let known = known(bytes)?;
    let mut module = Module::new();
    let mut code = CodeSection::new();
    let mut bodies = 0;
    for payload in Parser::new(0).parse_all(bytes) {
        let payload = payload?;
        match &payload {
            Payload::TagSection(_) | Payload::CustomSection(_) => {}
            Payload::GlobalSection(section) => {
                let mut globals = GlobalSection::new();
                RoundtripReencoder.parse_global_section(&mut globals, section.clone())?;
                let number = GlobalType { val_type: ValType::I32, mutable: true, shared: false };
                globals.global(number, &ConstExpr::i32_const(0));
                globals.global(number, &ConstExpr::i32_const(0));
                module.section(&globals);
            }
            Payload::CodeSectionEntry(body) => {
                code.function(&rewritten(&known, known.imported + bodies, body)?);
                bodies += 1;
                if bodies == known.bodies.len() {
                    module.section(&code);
                }
            }
            Payload::CodeSectionStart { .. } => {}
            _ => {
                if let Some((id, range)) = payload.as_section() {
                    module.section(&RawSection { id, data: &bytes[range] });
                }
            }
        }
    }
    Ok(module.finish())
}

fn known(bytes: &[u8]) -> Result<Known<'_>> {
    let mut known = Known::default();
    for payload in Parser::new(0).parse_all(bytes) {
        match payload? {
            Payload::TypeSection(section) => {
                for group in section {
                    known.types.extend(group?.into_types().map(|one| match one.composite_type.inner {
                        CompositeInnerType::Func(function) => Some(function),
                        _ => None,
                    }));
                }
            }
            Payload::ImportSection(section) => {
                for import in section {
                    match import?.ty {
                        TypeRef::Func(index) => known.functions.push(index),
                        TypeRef::Global(_) => known.globals += 1,
                        TypeRef::Tag(_) => return Err("a tag of the host".into()),
                        _ => {}
                    }
                }
                known.imported = known.functions.len();
            }
            Payload::FunctionSection(section) => {
                for index in section {
                    known.functions.push(index?);
                }
            }
            Payload::GlobalSection(section) => known.globals += section.count(),
            Payload::TagSection(section) => {
                known.tags = section.count() as usize;
                for tag in section {
                    let tag = known.types.get(tag?.func_type_idx as usize).and_then(Option::as_ref);
                    if tag.is_none_or(|tag| tag.params() != [wasmparser::ValType::I32]) {
                        return Err("a tag that does not carry one i32".into());
                    }
                }
            }
            Payload::CodeSectionEntry(body) => known.bodies.push(body),
            _ => {}
        }
    }
    if known.tags > 1 {
        return Err("several tags".into());
    }
    known.throws = throwing(&known)?;
    Ok(known)
}

/// A function may throw if it throws, calls what is not known, or calls one that may.
fn throwing(known: &Known) -> Result<Vec<bool>> {
    let mut throws = vec![false; known.functions.len()];
    let mut callers: Vec<Vec<usize>> = vec![Vec::new(); known.functions.len()];
    let mut new = Vec::new();
    for (i, body) in known.bodies.iter().enumerate() {
        let function = known.imported + i;
        let mut itself = false;
        for operator in body.get_operators_reader()? {
            match operator? {
                Operator::Throw { .. } | Operator::Rethrow { .. } | Operator::CallIndirect { .. } => {
                    itself = true
                }
                Operator::Call { function_index } => callers[function_index as usize].push(function),
                _ => {}
            }
        }
        if itself {
            throws[function] = true;
            new.push(function);
        }
    }
    while let Some(function) = new.pop() {
        for &caller in &callers[function] {
            if !throws[caller] {
                throws[caller] = true;
                new.push(caller);
            }
        }
    }
    Ok(throws)
}

/// Where the writing of a block has come to.
#[derive(Clone, Copy, PartialEq)]
enum Part {
    /// A block, loop or if.
    Plain,
    /// Before `catch`.
    Try,
    /// Behind it; what was thrown is kept in this local.
    Catch { kept: u32 },
}

/// A block of the source. Labels are counted from the outside, in what is written.
struct Frame {
    part: Part,
    /// The label to which branches out of the block go.
    label: usize,
}

fn rewritten(known: &Known, function: usize, body: &FunctionBody) -> Result<Function> {
    let mut locals: Vec<(u32, ValType)> = Vec::new();
    let mut count = known.function(function as u32)?.params().len() as u32;
    for local in body.get_locals_reader()? {
        let (times, kind) = local?;
        locals.push((times, RoundtripReencoder.val_type(kind)?));
        count += times;
    }
    let (mut open, mut deepest) = (Vec::new(), 0);
    for operator in body.get_operators_reader()? {
        match operator? {
            Operator::Block { .. } | Operator::Loop { .. } | Operator::If { .. } => open.push(false),
            Operator::Try { .. } => open.push(true),
            Operator::End | Operator::Delegate { .. } => _ = open.pop(),
            _ => {}
        }
        deepest = deepest.max(open.iter().filter(|is_try| **is_try).count());
    }
    locals.push((deepest as u32, ValType::I32));
    let mut out = Function::new(locals);
    if !known.throws[function] && deepest == 0 {
        for operator in body.get_operators_reader()? {
            out.instruction(&RoundtripReencoder.instruction(operator?)?);
        }
        return Ok(out);
    }
    Writer { known, out, labels: 1, frames: Vec::new(), first_kept: count }.write(function, body)
}

struct Writer<'k, 'a> {
    known: &'k Known<'a>,
    out: Function,
    /// Labels that are open in what is written; 0 is the handler of the function.
    labels: usize,
    frames: Vec<Frame>,
    /// The first of the locals for what is thrown.
    first_kept: u32,
}

impl Writer<'_, '_> {
    fn put(&mut self, instruction: Instruction) {
        self.out.instruction(&instruction);
    }

    /// The depth of a label that is counted from the outside.
    fn depth(&self, label: usize) -> u32 {
        (self.labels - 1 - label) as u32
    }

    /// The depth, in what is written, of a depth in the source. Out of all blocks is out of the function.
    fn branch(&self, depth: u32) -> u32 {
        match self.frames.len().checked_sub(1 + depth as usize) {
            Some(at) => self.depth(self.frames[at].label),
            None => self.labels as u32,
        }
    }

    /// The depth of the handler of what is thrown inside the first so many blocks.
    fn handler(&self, frames: usize) -> u32 {
        let inner = self.frames[..frames].iter().rev().find(|frame| frame.part == Part::Try);
        // The handler of a try is the block inside that of its result.
        inner.map_or(self.depth(0), |frame| self.depth(frame.label + 1))
    }

    fn plain(&mut self) {
        self.frames.push(Frame { part: Part::Plain, label: self.labels });
        self.labels += 1;
    }

    /// What was thrown lies on the stack.
    fn throw(&mut self) {
        self.put(Instruction::GlobalSet(self.known.thrown()));
        self.put(Instruction::I32Const(1));
        self.put(Instruction::GlobalSet(self.known.pending()));
        let handler = self.handler(self.frames.len());
        self.put(Instruction::Br(handler));
    }

    fn look(&mut self) {
        self.put(Instruction::GlobalGet(self.known.pending()));
        let handler = self.handler(self.frames.len());
        self.put(Instruction::BrIf(handler));
    }

    /// The end of what a try guards: past its handler, which begins here.
    fn end_of_guarded(&mut self) {
        self.put(Instruction::Br(1));
        self.put(Instruction::End);
        self.labels -= 1;
    }

    fn catch(&mut self) -> Result<u32> {
        let tries = self.frames.iter().filter(|frame| frame.part != Part::Plain).count() as u32;
        let kept = self.first_kept + tries - 1;
        let frame = self.frames.last_mut().ok_or("a catch outside of a try")?;
        if frame.part != Part::Try {
            return Err("several catches of a try".into());
        }
        frame.part = Part::Catch { kept };
        self.end_of_guarded();
        self.put(Instruction::I32Const(0));
        self.put(Instruction::GlobalSet(self.known.pending()));
        self.put(Instruction::GlobalGet(self.known.thrown()));
        self.put(Instruction::LocalSet(kept));
        Ok(kept)
    }

    fn write(mut self, function: usize, body: &FunctionBody) -> Result<Function> {
        self.put(Instruction::Block(BlockType::Empty));
        for operator in body.get_operators_reader()? {
            self.operator(operator?)?;
        }
        let results = self.known.function(function as u32)?.results().to_vec();
        for result in results {
            self.put(match result {
                wasmparser::ValType::I32 => Instruction::I32Const(0),
                wasmparser::ValType::I64 => Instruction::I64Const(0),
                wasmparser::ValType::F32 => Instruction::F32Const(0.0.into()),
                wasmparser::ValType::F64 => Instruction::F64Const(0.0.into()),
                other => return Err(format!("a function with a result of type {other}").into()),
            });
        }
        self.put(Instruction::End);
        Ok(self.out)
    }

    fn operator(&mut self, operator: Operator) -> Result<()> {
        match operator {
            Operator::Block { .. } | Operator::Loop { .. } | Operator::If { .. } => {
                self.put(RoundtripReencoder.instruction(operator)?);
                self.plain();
            }
            Operator::Try { blockty } => {
                if let wasmparser::BlockType::FuncType(index) = blockty
                    && self.known.types[index as usize].as_ref().is_none_or(|kind| !kind.params().is_empty())
                {
                    return Err("a try with parameters".into());
                }
                self.put(Instruction::Block(RoundtripReencoder.block_type(blockty)?));
                self.put(Instruction::Block(BlockType::Empty));
                self.frames.push(Frame { part: Part::Try, label: self.labels });
                self.labels += 2;
            }
            Operator::Catch { .. } => {
                let kept = self.catch()?;
                self.put(Instruction::LocalGet(kept));
            }
            Operator::CatchAll => _ = self.catch()?,
            Operator::Delegate { relative_depth } => {
                self.end_of_guarded();
                self.frames.pop();
                // What was thrown goes on as if from the block named, counted without the try itself.
                let inside = self.frames.len() - (relative_depth as usize).min(self.frames.len());
                let handler = self.handler(inside);
                self.put(Instruction::Br(handler));
                self.put(Instruction::End);
                self.labels -= 1;
            }
            Operator::Throw { .. } => self.throw(),
            Operator::Rethrow { relative_depth } => {
                let at =
                    self.frames.len().checked_sub(1 + relative_depth as usize).ok_or("a rethrow outside")?;
                let Part::Catch { kept } = self.frames[at].part else {
                    return Err("a rethrow outside of a catch".into());
                };
                self.put(Instruction::LocalGet(kept));
                self.throw();
            }
            Operator::TryTable { .. } | Operator::ThrowRef => return Err("try_table and throw_ref".into()),
            Operator::ReturnCall { .. } | Operator::ReturnCallIndirect { .. } => {
                return Err("tail calls".into());
            }
            Operator::End => {
                match self.frames.pop() {
                    Some(frame) => {
                        if frame.part == Part::Try {
                            // Nothing is caught: as if it were not there, but the block of the handler has to end.
                            return Err("a try without a catch".into());
                        }
                        self.labels -= 1;
                    }
                    // Of the function: its results go out before the handler.
                    None => {
                        self.put(Instruction::Return);
                        self.labels -= 1;
                    }
                }
                self.put(Instruction::End);
            }
            Operator::Br { relative_depth } => {
                let depth = self.branch(relative_depth);
                self.put(Instruction::Br(depth));
            }
            Operator::BrIf { relative_depth } => {
                let depth = self.branch(relative_depth);
                self.put(Instruction::BrIf(depth));
            }
            Operator::BrTable { targets } => {
                let default = self.branch(targets.default());
                let list: std::result::Result<Vec<u32>, _> = targets.targets().collect();
                let list: Vec<u32> = list?.into_iter().map(|depth| self.branch(depth)).collect();
                self.put(Instruction::BrTable(list.into(), default));
            }
            Operator::Call { function_index } => {
                self.put(Instruction::Call(function_index));
                if self.known.throws[function_index as usize] {
                    self.look();
                }
            }
            Operator::CallIndirect { .. } => {
                self.put(RoundtripReencoder.instruction(operator)?);
                self.look();
            }
            other => self.put(RoundtripReencoder.instruction(other)?),
        }
        Ok(())
    }
}
