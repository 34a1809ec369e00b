//! The specification as web pages: an index, and a page an entry.

use super::rich::rich;
use super::{CHAPTERS, Entry, Verdict};
use maud::{DOCTYPE, Markup, html};
use std::collections::BTreeSet;

const STYLE: &str = "body{font:16px/1.5 system-ui,sans-serif;max-width:60rem;margin:2rem auto;padding:0 1rem;\
    color-scheme:light dark}table{border-collapse:collapse;width:100%}th,td{text-align:left;vertical-align:top;\
    padding:.3rem .8rem .3rem 0;border-bottom:1px solid #8884}th{white-space:nowrap;font-weight:600}\
    td.text{white-space:pre-wrap;overflow-wrap:anywhere}td.id{white-space:nowrap}td.source{font-size:.85em}\
    .erratum{color:#d0343c;font-weight:600}.counts{opacity:.75}math{font-size:1.1em;white-space:normal}";

/// The pages, by file name: `index.html`, and one such as `CU-7.html` an entry.
pub fn pages(entries: &[Entry]) -> Vec<(String, String)> {
    let index = ("index.html".to_owned(), index(entries).into_string());
    let names: BTreeSet<String> = entries.iter().map(|entry| entry.id.to_string()).collect();
    let is_entry = |name: &str| names.contains(name);
    let pages = entries.iter().map(|entry| (file(entry), page(entry, &is_entry).into_string()));
    std::iter::once(index).chain(pages).collect()
}

fn file(entry: &Entry) -> String {
    format!("{}.html", entry.id)
}

fn frame(title: &str, body: Markup) -> Markup {
    html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                title { (title) }
                style { (STYLE) }
            }
            body { (body) }
        }
    }
}

fn index(entries: &[Entry]) -> Markup {
    frame(
        "isoracle: the specification",
        html! {
            h1 { "The specification" }
            p { "Every formula of the four texts that is checked, with the verdict of the tests." }
            @for chapter in entries.chunk_by(|a, b| a.id.room() == b.id.room()) {
                h2 { (title(chapter[0].id.room())) }
                p.counts { (counts(chapter)) }
                table {
                    tr { th { "Id" } th { "Title" } th { "Source" } th { "Verdict" } }
                    @for entry in chapter {
                        tr {
                            td.id { a href=(file(entry)) { (entry.id) } }
                            td { (entry.title) }
                            td.source { (entry.sources.join("; ")) }
                            td class=(entry.verdict) { (entry.verdict) }
                        }
                    }
                }
            }
        },
    )
}

/// The heading of the chapter that has a room's entries.
fn title(room: &str) -> &'static str {
    let of_room = |text: &&str| text.contains(&format!("\n## {room}-1 "));
    let chapter = CHAPTERS.iter().map(|(_, text)| *text).find(of_room).unwrap_or_default();
    chapter.lines().next().unwrap_or_default().trim_start_matches('#').trim()
}

/// "3 entries: 2 holds, 1 erratum".
fn counts(chapter: &[Entry]) -> String {
    let of = |verdict: Verdict| chapter.iter().filter(|entry| entry.verdict == verdict).count();
    let each = Verdict::ALL.into_iter().filter(|verdict| of(*verdict) > 0);
    let each: Vec<String> = each.map(|verdict| format!("{} {verdict}", of(verdict))).collect();
    format!("{} entries: {}", chapter.len(), each.join(", "))
}

fn page(entry: &Entry, is_entry: &dyn Fn(&str) -> bool) -> Markup {
    frame(
        &format!("{} {}", entry.id, entry.title),
        html! {
            p { a href="index.html" { "All entries" } }
            h1 { (entry.id) " " (entry.title) }
            table {
                @for (name, text) in entry.fields() {
                    tr {
                        th { (name) }
                        td.text {
                            @if name == "code" { code { (text) } } @else { (rich(&text, is_entry)) }
                        }
                    }
                }
            }
            @for paragraph in entry.notes.split("\n\n").filter(|p| !p.trim().is_empty()) {
                p { (rich(paragraph, is_entry)) }
            }
        },
    )
}
