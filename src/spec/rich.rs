//! The text of entries as HTML: formulas between `$$` as MathML, `*emphasis*`, `code`, the names of entries as links.

use maud::{Markup, PreEscaped, html};
use pulldown_latex::{Parser, RenderConfig, Storage, push_mathml};

/// A text of the specification; `is_entry` says which names are entries, with a page of their own.
pub fn rich(text: &str, is_entry: &dyn Fn(&str) -> bool) -> Markup {
    html! {
        @for (i, part) in text.split("$$").enumerate() {
            @if i % 2 == 1 { (formula(part.trim())) } @else { (words(part, is_entry)) }
        }
    }
}

/// A formula in TeX; as it is written where it cannot be read.
fn formula(tex: &str) -> Markup {
    let storage = Storage::new();
    // In the line of the text, but with the limits of sums above and below.
    let displayed = format!("\\displaystyle {tex}");
    let events: Result<Vec<_>, _> = Parser::new(&displayed, &storage).collect();
    let mut mathml = String::new();
    let config = RenderConfig::default();
    let drawn = events.is_ok_and(|events| {
        let events = events.into_iter().map(Ok::<_, std::convert::Infallible>);
        push_mathml(&mut mathml, events, config).is_ok()
    });
    if !drawn {
        return html! { code { (tex) } };
    }
    // The library escapes some spaces in texts twice, and the sign < not at all.
    PreEscaped(mathml.replace("&amp;nbsp;", "\u{a0}").replace("&nbsp;", "\u{a0}").replace("><<", ">&lt;<"))
}

/// Text between formulas.
fn words(text: &str, is_entry: &dyn Fn(&str) -> bool) -> Markup {
    let next = |mark: char| {
        let begin = text.match_indices(mark).map(|(at, _)| at).find(|&at| closing(text, at, mark).is_some())?;
        Some((begin, closing(text, begin, mark)?, mark))
    };
    match ['*', '`'].into_iter().filter_map(next).min() {
        None => linked(text, is_entry),
        Some((begin, end, mark)) => {
            let inner = &text[begin + 1..end];
            html! {
                (linked(&text[..begin], is_entry))
                @if mark == '*' { em { (linked(inner, is_entry)) } } @else { code { (inner) } }
                (words(&text[end + 1..], is_entry))
            }
        }
    }
}

/// Where what a mark begins ends. Emphasis begins at a word's beginning and ends at its end, so that a product is none.
fn closing(text: &str, begin: usize, mark: char) -> Option<usize> {
    let before = text[..begin].chars().next_back();
    let inner = &text[begin + 1..];
    let end = inner.find(mark).filter(|&end| end > 0)?;
    let is_word = |c: Option<char>| c.is_some_and(char::is_alphanumeric);
    let first = inner.chars().next();
    let after = inner[end + 1..].chars().next();
    let is_emphasis = first.is_some_and(|c| !c.is_whitespace())
        && !is_word(before)
        && !is_word(after)
        && !inner[..end].ends_with(char::is_whitespace);
    (mark == '`' || is_emphasis).then_some(begin + 1 + end)
}

/// Text with its names of entries, such as CU-7, as links.
fn linked(text: &str, is_entry: &dyn Fn(&str) -> bool) -> Markup {
    let is_of_name = |c: char| c.is_ascii_uppercase() || c.is_ascii_digit() || c == '-';
    let mut parts = Vec::new();
    let mut rest = text;
    while let Some(begin) = rest.find(|c: char| c.is_ascii_uppercase()) {
        let end = rest[begin..].find(|c| !is_of_name(c)).map_or(rest.len(), |n| begin + n);
        parts.push((&rest[..begin], &rest[begin..end]));
        rest = &rest[end..];
    }
    html! {
        @for (before, name) in parts {
            (before)
            @if is_entry(name) { a href={ (name) ".html" } { (name) } } @else { (name) }
        }
        (rest)
    }
}
