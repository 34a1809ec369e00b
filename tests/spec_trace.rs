//! Every entry of the specification has its code and its tests, and no other id is named anywhere.
#![cfg(feature = "cli")]

use isoracle::spec::{CHAPTERS, Entry, Verdict, entries};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// The rooms whose ids stand in texts.
const ROOMS: [&str; 8] = ["CX", "CU", "SP", "IS", "ME", "SO", "RE", "NU"];

/// Ids stand there as examples of what an id looks like.
const EXAMPLES: [&str; 2] = ["src/spec", "src/cli/spec.rs"];

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The files below a folder with that extension, by their paths from the root.
fn files(folder: &str, extension: &str) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut pending = vec![root().join(folder)];
    while let Some(folder) = pending.pop() {
        for entry in fs::read_dir(&folder).expect("a folder of the crate") {
            let path = entry.expect("a readable folder").path();
            if path.is_dir() {
                pending.push(path);
            } else if path.extension().is_some_and(|e| e == extension) {
                found.push(path.strip_prefix(root()).expect("below the root").to_owned());
            }
        }
    }
    found.sort();
    found
}

fn text(path: &Path) -> String {
    fs::read_to_string(root().join(path)).expect("a text of the crate")
}

fn specification() -> Vec<Entry> {
    entries().unwrap_or_else(|error| panic!("{error}"))
}

/// The ids of these entries, as they are written.
fn ids(entries: &[Entry]) -> BTreeSet<String> {
    entries.iter().map(|entry| entry.id.to_string()).collect()
}

fn assert_none(what: &str, missing: &[String]) {
    assert!(missing.is_empty(), "{} {what}:\n{}", missing.len(), missing.join("\n"));
}

/// What follows each occurrence of a word that no letter or digit stands before.
fn after<'a>(text: &'a str, word: &'a str) -> impl Iterator<Item = &'a str> {
    let starts = text.match_indices(word).map(|(i, _)| i);
    starts.filter(|&i| !text[..i].ends_with(|c: char| c.is_alphanumeric())).map(move |i| &text[i + word.len()..])
}

fn leading_digits(text: &str) -> &str {
    &text[..text.bytes().take_while(u8::is_ascii_digit).count()]
}

#[test]
fn every_chapter_is_read() {
    let known: BTreeSet<&str> = CHAPTERS.iter().map(|(name, _)| *name).collect();
    let there = files("spec", "md");
    let there: BTreeSet<&str> = there.iter().map(|p| p.file_name().and_then(|n| n.to_str()).expect("a name")).collect();
    // Longer proofs stand beside their chapter.
    let without_proofs: BTreeSet<&str> = there.into_iter().filter(|name| !name.ends_with("-proofs.md")).collect();
    assert_eq!(without_proofs, known);
    let headings: usize = CHAPTERS
        .iter()
        .map(|(_, text)| ROOMS.map(|r| text.matches(&format!("\n## {r}-")).count()))
        .map(|n| n.iter().sum::<usize>())
        .sum();
    assert_eq!(specification().len(), headings, "each heading with an id begins an entry");
}

#[test]
fn every_entry_is_complete() {
    let mut missing = Vec::new();
    for entry in specification() {
        let mut need = |is_there: bool, field: &str| {
            if !is_there {
                missing.push(format!("{}: no {field}", entry.id));
            }
        };
        need(!entry.title.is_empty(), "title");
        need(!entry.sources.is_empty(), "source");
        need(entry.printed.is_some(), "printed");
        need(entry.code.is_some(), "code");
        // An erratum's `correct` and `counterexample` are a condition of reading it.
        let convention = entry.verdict == Verdict::HoldsWithConvention;
        need(!convention || entry.counterexample.is_some(), "counterexample to the reading that is excluded");
        need(ROOMS.iter().any(|room| entry.id.to_string().starts_with(room)), "room of that name");
        need(!entry.id.to_string().ends_with("-0"), "number");
    }
    assert_none("fields are missing", &missing);
}

#[test]
fn numbers_run_from_1_in_each_room() {
    let ids: Vec<String> = specification().iter().map(|entry| entry.id.to_string()).collect();
    for room in ROOMS {
        let numbers = ids.iter().filter_map(|id| id.strip_prefix(room)?.strip_prefix('-')?.parse::<usize>().ok());
        assert!(numbers.enumerate().all(|(i, n)| n == i + 1), "the numbers of {room} are not 1, 2, 3 …");
    }
}

#[test]
fn every_entry_has_its_code() {
    let sources: Vec<String> = files("src", "rs").iter().map(|path| text(path)).collect();
    let carried = |id: &str| sources.iter().any(|source| source.contains(&format!("#[doc(alias = \"{id}\")]")));
    let missing: Vec<String> = ids(&specification()).into_iter().filter(|id| !carried(id)).collect();
    assert_none("entries have no code with their alias", &missing);
}

#[test]
fn every_entry_has_its_tests() {
    let texts: Vec<String> = files("tests", "rs").iter().chain(&files("src", "rs")).map(|path| text(path)).collect();
    let begins = |module: &str| {
        let open = format!("mod {module} {{");
        // A module with a test in it: before the next module at the margin.
        texts.iter().any(|text| {
            after(text, &open).any(|rest| rest.split("\nmod ").next().is_some_and(|body| body.contains("#[test]")))
        })
    };
    let tests =
        specification().into_iter().flat_map(|entry| entry.tests.into_iter().map(move |t| (entry.id.clone(), t)));
    let missing: Vec<String> = tests.filter(|(_, t)| !begins(t)).map(|(id, t)| format!("{id}: mod {t}")).collect();
    assert_none("entries have no tests", &missing);
}

#[test]
fn no_other_id_is_named() {
    let known = ids(&specification());
    let mut unknown = Vec::new();
    for path in [("src", "rs"), ("tests", "rs"), ("spec", "md")].iter().flat_map(|(folder, e)| files(folder, e)) {
        let is_example = EXAMPLES.iter().any(|example| path.starts_with(example)) || path.ends_with("spec_trace.rs");
        if is_example {
            continue;
        }
        for (number, line) in text(&path).lines().enumerate() {
            for room in ROOMS {
                let modules = format!("mod {}_", room.to_lowercase());
                let named = after(line, room).filter_map(|rest| rest.strip_prefix('-'));
                let named = named.filter(|rest| rest.starts_with(|c: char| c.is_ascii_digit() || c == '?'));
                for rest in named.chain(after(line, &modules)) {
                    let id = format!("{room}-{}", leading_digits(rest));
                    if !known.contains(&id) {
                        unknown.push(format!("{}:{}: {}", path.display(), number + 1, line.trim()));
                    }
                }
            }
        }
    }
    unknown.dedup();
    assert_none("ids are named that no entry has", &unknown);
}

/// Whether a text defines an item of that name: a function, a type, a module, or an exported name.
fn defines(text: &str, name: &str) -> bool {
    let ends = |rest: &str| !rest.starts_with(|c: char| c.is_alphanumeric() || c == '_');
    let kinds = ["fn", "struct", "enum", "trait", "type", "const", "static"];
    kinds.iter().any(|kind| after(text, &format!("{kind} {name}")).any(ends))
}

/// Whether `a::b::Type::function` exists: a module file, and in it, or in the files of its folder, the items.
fn exists(path: &str) -> bool {
    let segments: Vec<&str> = path.split("::").collect();
    let module = |n: usize| {
        let base = root().join("src").join(segments[..n].join("/"));
        [base.with_extension("rs"), base.join("mod.rs")].into_iter().find(|file| file.is_file())
    };
    let Some((length, file)) = (1..=segments.len()).rev().find_map(|n| Some((n, module(n)?))) else { return false };
    // A folder exports the items of its files.
    let texts: Vec<String> = if file.ends_with("mod.rs") {
        files(&format!("src/{}", segments[..length].join("/")), "rs").iter().map(|path| text(path)).collect()
    } else {
        vec![text(&file)]
    };
    segments[length..].iter().all(|name| texts.iter().any(|text| defines(text, name)))
}

#[test]
fn the_code_of_every_entry_exists() {
    let paths = specification().into_iter().flat_map(|entry| {
        let code = entry.code.unwrap_or_default();
        let paths: Vec<String> = code.split(',').map(|path| path.trim().to_owned()).collect();
        paths.into_iter().map(move |path| (entry.id.clone(), path))
    });
    let missing: Vec<String> =
        paths.filter(|(_, path)| !exists(path)).map(|(id, path)| format!("{id}: {path}")).collect();
    assert_none("paths lead to no code", &missing);
    assert!(exists("spec::parse") && exists("number::Surd::new"));
    assert!(!exists("spec::pars") && !exists("numbers") && !exists("number::Surd::now"));
}
