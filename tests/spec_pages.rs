//! The pages of the specification.
#![cfg(feature = "cli")]
#![allow(missing_docs)]

use isoracle::spec::html::pages;
use isoracle::spec::rich::rich;
use isoracle::spec::{CHAPTERS, entries};

fn shown(text: &str) -> String {
    rich(text, &|name| name == "NU-7").into_string()
}

#[test]
fn every_formula_of_the_specification_is_drawn() {
    let mut drawn = 0;
    for (name, text) in CHAPTERS {
        for formula in text.split("$$").skip(1).step_by(2) {
            let page = shown(&format!("$${formula}$$"));
            assert!(page.starts_with("<math"), "{name}: {formula}");
            assert!(
                !page.contains("merror") && !page.contains("nbsp") && !page.contains("rgb(178"),
                "{name}: {formula}: {page}"
            );
            drawn += 1;
        }
    }
    assert!(drawn > 50);
}

#[test]
fn what_is_no_formula_stays_text() {
    assert_eq!(shown("a < b & c"), "a &lt; b &amp; c");
    assert_eq!(shown("$$\\no{such$$"), "<code>\\no{such</code>");
    assert_eq!(shown("see NU-7 and NU-8"), "see <a href=\"NU-7.html\">NU-7</a> and NU-8");
    assert_eq!(shown("a *use* of `x*y*z`"), "a <em>use</em> of <code>x*y*z</code>");
    assert_eq!(shown("2*3*4, a * b * c, **"), "2*3*4, a * b * c, **");
    assert_eq!(shown("an * alone, *open"), "an * alone, *open");
    assert_eq!(shown(""), "");
    assert_eq!(shown("É-7, Z"), "É-7, Z");
}

#[test]
fn there_is_a_page_for_each_entry_and_its_links_lead_somewhere() {
    let pages = pages(&entries().unwrap());
    let names: std::collections::BTreeSet<&str> = pages.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(pages.len(), entries().unwrap().len() + 1);
    for (name, page) in &pages {
        for link in page.split("href=\"").skip(1).map(|rest| rest.split('"').next().unwrap()) {
            assert!(names.contains(link), "{name}: {link}");
        }
    }
    let (_, index) = &pages[0];
    assert!(index.contains("<h2>Polygon meshes: representations"));
}
