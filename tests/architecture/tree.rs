//! The modules of a crate, with every path that is written in them.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use syn::buffer::{Cursor, TokenBuffer};
use syn::visit::{self, Visit};
use syn::{ImplItem, Item, ItemImpl, ItemMod, ItemUse, Macro, Meta, UseTree, VisRestricted, Visibility};

/// The sources below a folder, by their path in it.
pub type Sources = BTreeMap<String, String>;

/// Names from the root of the crate to a module or an item.
pub type Names = Vec<String>;

/// What is written in a module; a module inside a file has its file's name.
#[derive(Clone, Debug, Default)]
pub struct Module {
    pub file: String,
    /// Functions, types and other items; no modules.
    pub items: BTreeSet<String>,
    /// What `use` brings under a name: paths as written.
    pub imported: BTreeMap<String, Vec<Names>>,
    /// What `use …::*` brings.
    pub globs: Vec<Names>,
    /// Every path, in code, in `use`, in macros and attributes; links of the documentation import nothing.
    pub references: BTreeSet<Reference>,
    /// The methods that stand here, each with the path of its type as written.
    pub methods: BTreeSet<Method>,
    /// Methods of their own type that these call, by `self.name()` or `Self::name()`.
    pub calls: BTreeSet<Method>,
}

/// A path as it is written.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Reference {
    pub names: Names,
    /// By `pub use`: a name for others, not for the module's own code.
    pub passed_on: bool,
}

/// A type as written, and the name of a method.
pub type Method = (Names, String);

/// All modules of a crate by their names from the root.
pub type Tree = BTreeMap<Names, Module>;

/// The sources of a folder.
pub fn sources(folder: &Path) -> Sources {
    let mut found = Sources::new();
    let mut folders = vec![folder.to_owned()];
    while let Some(next) = folders.pop() {
        for entry in fs::read_dir(next).expect("the sources can be listed") {
            let path = entry.expect("the sources can be listed").path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|e| e == "rs") {
                let name = path.strip_prefix(folder).expect("it lies in the folder");
                let name = name.to_str().expect("sources have plain names").replace('\\', "/");
                found.insert(name, fs::read_to_string(&path).expect("sources are UTF-8"));
            }
        }
    }
    found
}

/// Reads the library from `lib.rs` on, module by module, tests included.
pub fn tree(sources: &Sources) -> Tree {
    let mut tree = Tree::new();
    let mut waiting = vec![("lib.rs".to_owned(), Names::new(), String::new())];
    while let Some((file, module, folder)) = waiting.pop() {
        let text = sources.get(&file).unwrap_or_else(|| panic!("{file} is declared and missing"));
        let elsewhere = add(&mut tree, &file, text, module, folder);
        waiting.extend(elsewhere.into_iter().map(|declared| declared.found(sources)));
    }
    tree
}

/// Reads a file, the text of a module; gives the modules it declares.
pub fn add(tree: &mut Tree, file: &str, text: &str, module: Names, folder: String) -> Vec<Declared> {
    let parsed = syn::parse_file(text).unwrap_or_else(|error| panic!("{file}: {error}"));
    let mut reader = Reader { tree, file: file.to_owned(), module, folder, own: None, elsewhere: Vec::new() };
    reader.here();
    reader.visit_file(&parsed);
    reader.elsewhere
}

/// `mod name;`
pub struct Declared {
    module: Names,
    /// Where the file lies if no attribute tells another place.
    folder: String,
    path: Option<String>,
}

impl Declared {
    fn found(self, sources: &Sources) -> (String, Names, String) {
        let name = self.module.last().cloned().unwrap_or_default();
        let below = format!("{}{name}/", self.folder);
        let beside = format!("{}{name}.rs", self.folder);
        let file = match self.path {
            Some(path) => path,
            None if sources.contains_key(&beside) => beside,
            None => format!("{below}mod.rs"),
        };
        (file, self.module, below)
    }
}

struct Reader<'a> {
    tree: &'a mut Tree,
    file: String,
    module: Names,
    /// Where the files of the modules declared here lie.
    folder: String,
    /// The type of the `impl` that is read.
    own: Option<Names>,
    elsewhere: Vec<Declared>,
}

impl Reader<'_> {
    fn here(&mut self) -> &mut Module {
        let module = self.tree.entry(self.module.clone()).or_default();
        module.file.clone_from(&self.file);
        module
    }

    fn refers(&mut self, names: Names, passed_on: bool) {
        self.here().references.insert(Reference { names, passed_on });
    }

    fn calls(&mut self, method: &syn::Ident) {
        if let Some(own) = self.own.clone() {
            self.here().calls.insert((own, method.to_string()));
        }
    }

    fn uses(&mut self, before: &[String], tree: &UseTree, passed_on: bool) {
        let with = |name: &syn::Ident| [before, &[name.to_string()]].concat();
        let mut named = |name: &syn::Ident, names: Names| {
            // `use a::{self}` is `use a`
            let own = names.last().is_some_and(|last| last == "self");
            let names = if own { before.to_vec() } else { names };
            let known =
                if name == "self" { names.last().cloned().unwrap_or_default() } else { name.to_string() };
            self.here().imported.entry(known).or_default().push(names.clone());
            self.refers(names, passed_on);
        };
        match tree {
            UseTree::Path(path) => self.uses(&with(&path.ident), &path.tree, passed_on),
            UseTree::Name(name) => named(&name.ident, with(&name.ident)),
            UseTree::Rename(rename) => named(&rename.rename, with(&rename.ident)),
            UseTree::Glob(_) => {
                self.here().globs.push(before.to_vec());
                self.refers(before.to_vec(), passed_on);
            }
            UseTree::Group(group) => group.items.iter().for_each(|item| self.uses(before, item, passed_on)),
        }
    }

    /// The paths among the tokens of a macro, each with what stands before a group of them.
    fn tokens(&mut self, before: &[String], mut at: Cursor) {
        let mut names = before.to_vec();
        // 2 after `::`, 1 after `:`
        let mut colons = 0;
        let mut of_self = false;
        while !at.eof() {
            let ident = at.ident();
            let colon = at.punct().filter(|(punct, _)| punct.as_char() == ':' && colons < 2);
            if names.len() > before.len() && colons != 2 && colon.is_none() {
                self.refers(std::mem::replace(&mut names, before.to_vec()), false);
            }
            let dot = at.punct().filter(|(punct, _)| punct.as_char() == '.').map(|(_, rest)| rest);
            if let Some((method, _)) = dot.filter(|_| of_self).and_then(Cursor::ident) {
                self.calls(&method);
            }
            of_self = ident.as_ref().is_some_and(|(ident, _)| ident == "self");
            if let Some((ident, rest)) = ident {
                names.push(ident.to_string());
                (at, colons) = (rest, 0);
            } else if let Some((_, rest)) = colon {
                (at, colons) = (rest, colons + 1);
            } else if let Some((inside, _, _, rest)) = at.any_group() {
                // `use a::{b, c}`
                let prefix =
                    if colons == 2 { std::mem::replace(&mut names, before.to_vec()) } else { Names::new() };
                self.tokens(&prefix, inside);
                (at, colons) = (rest, 0);
            } else if let Some((_, rest)) = at.token_tree() {
                (at, colons) = (rest, 0);
            }
        }
        if names.len() > before.len() {
            self.refers(names, false);
        }
    }
}

impl<'ast> Visit<'ast> for Reader<'_> {
    fn visit_item(&mut self, item: &'ast Item) {
        let name = match item {
            Item::Const(item) => Some(&item.ident),
            Item::Enum(item) => Some(&item.ident),
            Item::Fn(item) => Some(&item.sig.ident),
            Item::Static(item) => Some(&item.ident),
            Item::Struct(item) => Some(&item.ident),
            Item::Trait(item) => Some(&item.ident),
            Item::Type(item) => Some(&item.ident),
            Item::Macro(item) => item.ident.as_ref(),
            _ => None,
        };
        if let Some(name) = name {
            self.here().items.insert(name.to_string());
        }
        visit::visit_item(self, item);
    }

    fn visit_item_mod(&mut self, item: &'ast ItemMod) {
        let name = item.ident.to_string();
        self.module.push(name.clone());
        if let Some((_, items)) = &item.content {
            let folder = format!("{}{name}/", self.folder);
            let outer = std::mem::replace(&mut self.folder, folder);
            self.here();
            items.iter().for_each(|item| self.visit_item(item));
            self.folder = outer;
        } else {
            let told = item.attrs.iter().find_map(|attribute| match &attribute.meta {
                Meta::NameValue(pair) if pair.path.is_ident("path") => match &pair.value {
                    syn::Expr::Lit(syn::ExprLit { lit: syn::Lit::Str(text), .. }) => Some(text.value()),
                    _ => None,
                },
                _ => None,
            });
            let beside = self.file.rfind('/').map_or("", |end| &self.file[..=end]);
            self.elsewhere.push(Declared {
                module: self.module.clone(),
                folder: self.folder.clone(),
                path: told.map(|told| format!("{beside}{told}")),
            });
        }
        self.module.pop();
    }

    fn visit_item_use(&mut self, item: &'ast ItemUse) {
        if item.leading_colon.is_none() {
            self.uses(&[], &item.tree, !matches!(item.vis, Visibility::Inherited));
        }
    }

    fn visit_path(&mut self, path: &'ast syn::Path) {
        let names: Vec<&syn::Ident> = path.segments.iter().map(|segment| &segment.ident).collect();
        if let [own, method] = names.as_slice()
            && *own == "Self"
        {
            self.calls(method);
        }
        if path.leading_colon.is_none() {
            self.refers(path.segments.iter().map(|segment| segment.ident.to_string()).collect(), false);
        }
        visit::visit_path(self, path);
    }

    fn visit_macro(&mut self, item: &'ast Macro) {
        self.visit_path(&item.path);
        self.tokens(&[], TokenBuffer::new2(item.tokens.clone()).begin());
    }

    fn visit_item_impl(&mut self, item: &'ast ItemImpl) {
        let own = match &*item.self_ty {
            syn::Type::Path(path) => path.path.segments.iter().map(|part| part.ident.to_string()).collect(),
            _ => Names::new(),
        };
        let outer = self.own.replace(own.clone());
        for part in &item.items {
            if let ImplItem::Fn(function) = part {
                self.here().methods.insert((own.clone(), function.sig.ident.to_string()));
            }
        }
        visit::visit_item_impl(self, item);
        self.own = outer;
    }

    fn visit_expr_method_call(&mut self, call: &'ast syn::ExprMethodCall) {
        if matches!(&*call.receiver, syn::Expr::Path(path) if path.path.is_ident("self")) {
            self.calls(&call.method);
        }
        visit::visit_expr_method_call(self, call);
    }

    /// `pub(crate)` imports nothing.
    fn visit_vis_restricted(&mut self, _: &'ast VisRestricted) {}

    /// Paths in attributes; a single name, as in `derive(Clone)` or `cfg(test)`, is none.
    fn visit_attribute(&mut self, attribute: &'ast syn::Attribute) {
        match &attribute.meta {
            Meta::NameValue(pair) => self.visit_expr(&pair.value),
            Meta::List(list) => {
                let before = self.here().references.clone();
                self.tokens(&[], TokenBuffer::new2(list.tokens.clone()).begin());
                self.here().references.retain(|one| one.names.len() > 1 || before.contains(one));
            }
            Meta::Path(_) => {}
        }
    }
}
