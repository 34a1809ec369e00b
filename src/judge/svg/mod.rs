//! Pictures of small volumes with a surface in them, and of large surfaces, as SVG.
//!
//! Every picture is deterministic: the same input gives the same text, coordinates rounded to two decimals.
//! Colours that carry a meaning carry it twice: the back of a surface is ochre and hatched, a positive
//! corner is filled. Each element that a page may restyle has a class; without a page, the attributes serve.

mod cell;
mod mesh;
mod painter;
mod projection;
mod surface;

pub use cell::{case_icon, volume_picture};
pub use surface::surface_picture;

use ::svg::node::element::{Description, SVG, Title};

/// The text of one `<svg>` element, made here and nowhere else: safe to set into a page.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture(String);

impl Picture {
    /// The element.
    pub fn as_str(&self) -> &str {
        &self.0
    }
}

impl std::fmt::Display for Picture {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.0)
    }
}

/// An empty picture of that size with its name and description for those who do not see it.
fn canvas(width: f64, height: f64, title: &str, description: &str) -> SVG {
    SVG::new()
        .set("viewBox", format!("0 0 {} {}", rounded(width), rounded(height)))
        .set("width", rounded(width))
        .set("height", rounded(height))
        .set("role", "img")
        .set("aria-label", format!("{title}. {description}"))
        .add(Title::new(title))
        .add(Description::new().add(::svg::node::Text::new(description)))
}

/// Two decimals, and never "-0".
fn rounded(x: f64) -> f64 {
    (x * 100.0).round() / 100.0 + 0.0
}
