//! A page in which the complex turns: one file with its own script, no other file, no network.

use super::scene::{COLOURS, Scene};
use super::still::still;
use maud::{DOCTYPE, PreEscaped, html};
use serde_json::{Value, json};

/// The page. Without script the still stands in it.
pub fn page(scene: &Scene) -> String {
    let data = data(scene).to_string().replace('<', "\\u003c");
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                meta name="color-scheme" content="light dark";
                meta name="generator" content=(concat!("isoracle ", env!("CARGO_PKG_VERSION")));
                title { (scene.title) " · isoracle" }
                style { (PreEscaped(include_str!("page.css"))) }
            }
            body {
                header { p.kicker { "isoracle complex" } h1 { (scene.title) } }
                main {
                    div.stage {
                        canvas tabindex="0" role="img" aria-label={ (scene.title) ", drawn in space; drag or use the arrow keys to turn it" } {}
                        noscript { (PreEscaped(still(scene))) }
                    }
                    aside {
                        div.controls aria-label="View" {}
                        @let legend = scene.legend();
                        @if !legend.is_empty() {
                            ul.legend { @for (group, name) in legend {
                                li { span.swatch style={ "background:" (css(group)) } {} (name) }
                            } }
                        }
                        dl { @for (name, value) in &scene.facts { div { dt { (name) } dd { (value) } } } }
                    }
                }
                script { (PreEscaped(format!("const SCENE = {data};\n{}", include_str!("page.js")))) }
            }
        }
    };
    page.into_string()
}

/// What the script draws. Coordinates are rounded: a pixel is larger.
fn data(scene: &Scene) -> Value {
    let rounded = |x: &f64| (x * 1e5).round() / 1e5;
    let points: Vec<Vec<f64>> = scene.coordinates.iter().map(|p| p.iter().map(rounded).collect()).collect();
    json!({
        "points": points,
        "tetrahedra": scene.tetrahedra,
        "groups": scene.groups,
        "lines": scene.lines,
        "colours": COLOURS,
    })
}

fn css(group: u32) -> String {
    let [r, g, b] = super::scene::colour(group);
    format!("rgb({r},{g},{b})")
}
