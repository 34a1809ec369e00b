//! The specification as web pages: an index, and a page an entry.

use super::Entry;
use maud::{DOCTYPE, Markup, html};

const STYLE: &str = "body{font:16px/1.5 system-ui,sans-serif;max-width:60rem;margin:2rem auto;padding:0 1rem}\
    table{border-collapse:collapse;width:100%}th,td{text-align:left;vertical-align:top;padding:.3rem .8rem .3rem 0;\
    border-bottom:1px solid #ddd}th{white-space:nowrap;font-weight:600}td.text{white-space:pre-wrap}\
    .erratum{color:#b00020;font-weight:600}";

/// The pages, by file name: `index.html`, and one such as `CU-7.html` an entry.
pub fn pages(entries: &[Entry]) -> Vec<(String, String)> {
    let index = ("index.html".to_owned(), index(entries).into_string());
    let pages = entries.iter().map(|entry| (file(entry), page(entry).into_string()));
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
            table {
                tr { th { "Id" } th { "Title" } th { "Source" } th { "Verdict" } }
                @for entry in entries {
                    tr {
                        td { a href=(file(entry)) { (entry.id) } }
                        td { (entry.title) }
                        td { (entry.sources.join("; ")) }
                        td class=(entry.verdict) { (entry.verdict) }
                    }
                }
            }
        },
    )
}

fn page(entry: &Entry) -> Markup {
    frame(
        &format!("{} {}", entry.id, entry.title),
        html! {
            p { a href="index.html" { "All entries" } }
            h1 { (entry.id) " " (entry.title) }
            table {
                @for (name, text) in entry.fields() {
                    tr { th { (name) } td.text { (text) } }
                }
            }
            @for paragraph in entry.notes.split("\n\n").filter(|p| !p.trim().is_empty()) {
                p { (paragraph) }
            }
        },
    )
}
