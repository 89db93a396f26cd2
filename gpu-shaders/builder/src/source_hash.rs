//! A hash of the code that shaders are made from and by. It stays where only comments, layout, tests or code for the CPU change:
//! items, methods and fields under `#[cfg(not(target_arch = "spirv"))]`, a whole module among them.

use anyhow::{Context, Result};
use proc_macro2::{TokenStream, TokenTree};
use quote::ToTokens;
use std::path::Path;
use syn::visit_mut::{
    VisitMut, visit_expr_struct_mut, visit_fields_named_mut, visit_file_mut, visit_item_impl_mut,
    visit_item_mod_mut, visit_item_trait_mut,
};
use syn::{
    Attribute, ExprStruct, FieldsNamed, File, ImplItem, Item, ItemImpl, ItemMod, ItemTrait, Meta,
    TraitItem,
};

/// Packages whose versions count, and the lock file that names them.
const PINNED: [(&str, &str); 7] = [
    ("Cargo.lock", "bytemuck"),
    ("Cargo.lock", "glam"),
    ("Cargo.lock", "libm"),
    ("Cargo.lock", "spirv-std"),
    ("Cargo.lock", "spirv-std-macros"),
    ("gpu-shaders/builder/Cargo.lock", "naga"),
    ("gpu-shaders/builder/Cargo.lock", "spirv-builder"),
];

/// The builder's source.
const BUILDER: &str = "gpu-shaders/builder/src";

/// The texts there that it copies into those for users' shaders.
const TEMPLATES: [&str; 2] = ["callable.wgsl", "callable_compute.wgsl"];

/// The hash of core, of the shader crates in these folders and of the builder itself, in hexadecimal.
///
/// # Errors
/// Where a file cannot be read or is no Rust.
pub fn source_hash(root: &Path, shader_crates: &[&str]) -> Result<String> {
    let mut hash = Fnv(0xcbf2_9ce4_8422_2325);
    for folder in ["core"].iter().chain(shader_crates) {
        let source = root.join(folder).join("src");
        each_file(&source, "lib", &source, &mut |file| {
            hash.tokens(file.to_token_stream());
        })?;
    }
    let builder = root.join(BUILDER);
    each_file(&builder, "main", &builder, &mut |file| {
        hash.tokens(file.to_token_stream());
    })?;
    // Line by line, so that their ends do not count.
    for template in TEMPLATES {
        for line in read(&builder.join(template))?.lines() {
            hash.text(line);
        }
    }
    for (package, version) in pinned_versions(root)? {
        hash.text(&package);
        hash.text(&version);
    }
    Ok(format!("{:016x}", hash.0))
}

/// The pinned packages and their versions.
///
/// # Errors
/// Where a lock file cannot be read or lacks one.
pub fn pinned_versions(root: &Path) -> Result<Vec<(String, String)>> {
    let mut versions = Vec::new();
    for (lock, package) in PINNED {
        let path = root.join(lock);
        let text = read(&path)?;
        // The backend has an older naga of its own, which comes first.
        let head = format!("name = \"{package}\"\nversion = \"");
        let (_, rest) = text
            .rsplit_once(&head)
            .with_context(|| format!("{lock} has no {package}"))?;
        let (version, _) = rest.split_once('"').unwrap_or((rest, ""));
        versions.push((package.to_owned(), version.to_owned()));
    }
    Ok(versions)
}

/// Calls `visit` with a file, then with the files of its modules: code that shaders may have, without docs. `children` is the folder where
/// the modules' files are.
///
/// # Errors
/// Where a file cannot be read or is no Rust.
pub fn each_file(
    folder: &Path,
    name: &str,
    children: &Path,
    visit: &mut impl FnMut(&File),
) -> Result<()> {
    let flat = folder.join(format!("{name}.rs"));
    let path = if flat.exists() {
        flat
    } else {
        folder.join(name).join("mod.rs")
    };
    let text = read(&path)?;
    let mut file = syn::parse_file(&text).with_context(|| path.display().to_string())?;
    OnlyCode.visit_file_mut(&mut file);
    visit(&file);
    for item in &file.items {
        if let Item::Mod(module) = item
            && module.content.is_none()
        {
            let name = module.ident.to_string();
            each_file(children, &name, &children.join(&name), visit)?;
        }
    }
    Ok(())
}

fn read(path: &Path) -> Result<String> {
    std::fs::read_to_string(path).with_context(|| path.display().to_string())
}

/// Takes out docs, and what no shader has. A statement or an arm that no shader has stays, and counts.
struct OnlyCode;

impl VisitMut for OnlyCode {
    fn visit_file_mut(&mut self, file: &mut File) {
        file.items.retain(|item| is_in_shaders(of_item(item)));
        visit_file_mut(self, file);
    }

    fn visit_item_mod_mut(&mut self, module: &mut ItemMod) {
        if let Some((_, items)) = &mut module.content {
            items.retain(|item| is_in_shaders(of_item(item)));
        }
        visit_item_mod_mut(self, module);
    }

    fn visit_item_impl_mut(&mut self, item: &mut ItemImpl) {
        item.items.retain(|item| {
            is_in_shaders(match item {
                ImplItem::Const(item) => &item.attrs,
                ImplItem::Fn(item) => &item.attrs,
                ImplItem::Macro(item) => &item.attrs,
                ImplItem::Type(item) => &item.attrs,
                _ => &[],
            })
        });
        visit_item_impl_mut(self, item);
    }

    fn visit_item_trait_mut(&mut self, item: &mut ItemTrait) {
        item.items.retain(|item| {
            is_in_shaders(match item {
                TraitItem::Const(item) => &item.attrs,
                TraitItem::Fn(item) => &item.attrs,
                TraitItem::Macro(item) => &item.attrs,
                TraitItem::Type(item) => &item.attrs,
                _ => &[],
            })
        });
        visit_item_trait_mut(self, item);
    }

    fn visit_fields_named_mut(&mut self, fields: &mut FieldsNamed) {
        let named = std::mem::take(&mut fields.named).into_iter();
        fields.named = named.filter(|it| is_in_shaders(&it.attrs)).collect();
        visit_fields_named_mut(self, fields);
    }

    fn visit_expr_struct_mut(&mut self, value: &mut ExprStruct) {
        let fields = std::mem::take(&mut value.fields).into_iter();
        value.fields = fields.filter(|it| is_in_shaders(&it.attrs)).collect();
        visit_expr_struct_mut(self, value);
    }

    fn visit_attributes_mut(&mut self, attributes: &mut Vec<Attribute>) {
        attributes.retain(|attribute| !attribute.path().is_ident("doc"));
    }
}

/// The attributes of an item.
fn of_item(item: &Item) -> &[Attribute] {
    match item {
        Item::Const(item) => &item.attrs,
        Item::Enum(item) => &item.attrs,
        Item::ExternCrate(item) => &item.attrs,
        Item::Fn(item) => &item.attrs,
        Item::Impl(item) => &item.attrs,
        Item::Macro(item) => &item.attrs,
        Item::Mod(item) => &item.attrs,
        Item::Static(item) => &item.attrs,
        Item::Struct(item) => &item.attrs,
        Item::Trait(item) => &item.attrs,
        Item::Type(item) => &item.attrs,
        Item::Use(item) => &item.attrs,
        _ => &[],
    }
}

/// Whether code with these attributes may be in a shader: it is neither a test nor left out of SPIR-V.
fn is_in_shaders(attributes: &[Attribute]) -> bool {
    !attributes.iter().any(|attribute| match &attribute.meta {
        Meta::List(list) if list.path.is_ident("cfg") => {
            // Spaces between tokens are a printer's choice.
            let condition = list.tokens.to_string().replace(' ', "");
            ["test", "not(target_arch=\"spirv\")"].contains(&condition.as_str())
        }
        _ => false,
    })
}

/// Fowler, Noll and Vo's hash 1a, 64 bits.
struct Fnv(u64);

impl Fnv {
    fn text(&mut self, text: &str) {
        // A byte that no text holds ends it.
        for byte in text.bytes().chain([0xff]) {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
        }
    }

    /// Token by token, so that no printer's spaces count.
    fn tokens(&mut self, tokens: TokenStream) {
        for token in tokens {
            match token {
                TokenTree::Group(group) => {
                    self.text(&format!("{:?}", group.delimiter()));
                    self.tokens(group.stream());
                    self.text("end");
                }
                TokenTree::Ident(ident) => self.text(&ident.to_string()),
                TokenTree::Punct(punct) => self.text(&punct.as_char().to_string()),
                TokenTree::Literal(literal) => self.text(&literal.to_string()),
            }
        }
    }
}
