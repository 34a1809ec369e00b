//! The forms of a report: exact text, well-formed pages, nothing lost, nothing smuggled in.

#[path = "report/sample.rs"]
mod sample;

use isoracle::isosurface::cases::Case;
use isoracle::judge::html::{Block, Section, page};
use isoracle::judge::junit::junit;
use isoracle::judge::report::{Outcome, QuestionRecord, Report, SurfaceRecord, VolumeQuestion, json};
use isoracle::judge::svg::{case_icon, surface_picture, volume_picture};
use isoracle::judge::text::text;

/// Snapshots stand beside the tests' folder.
fn snapshots(check: impl FnOnce()) {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path("../snapshots");
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(check);
}

/// The elements of a page or a picture, in order, after a check that each is closed where it must be.
fn elements(markup: &str) -> Vec<String> {
    const VOID: [&str; 2] = ["meta", "br"];
    let (mut open, mut all) = (Vec::<String>::new(), Vec::new());
    let mut rest = markup;
    while let Some(start) = rest.find('<') {
        let end = start + rest[start..].find('>').expect("a tag ends");
        let tag = &rest[start + 1..end];
        rest = &rest[end + 1..];
        let name: String = tag.chars().take_while(|c| !c.is_whitespace()).collect();
        assert!(tag.matches('"').count().is_multiple_of(2), "a quote or an angle bracket inside an attribute: {tag}");
        if let Some(closed) = name.strip_prefix('/') {
            assert_eq!(open.pop().as_deref(), Some(closed), "tags are nested");
        } else if !tag.starts_with(['!', '?']) {
            all.push(name.trim_end_matches('/').to_owned());
            if !tag.ends_with('/') && !VOID.contains(&name.as_str()) {
                open.push(name);
            }
        }
    }
    assert_eq!(open, Vec::<String>::new(), "every element is closed");
    all
}

fn hostile() -> Report {
    let mut report = sample::report();
    let poison = "<script>alert('\"&]]>')</script>\u{1b}[2J\n<b>";
    report.candidate.name = poison.to_owned();
    report.candidate.version = poison.to_owned();
    report.candidate.command.push(poison.to_owned());
    for failure in &mut report.failures {
        failure.fault += poison;
        failure.messages.push(poison.to_owned());
        failure.command += poison;
        if let QuestionRecord::Volume(question) = &mut failure.question {
            question.values[0] = poison.to_owned();
        }
        for difference in &mut failure.differences {
            difference.found = poison.to_owned();
        }
    }
    report
}

#[test]
fn the_terminal_report_is_this() {
    snapshots(|| insta::assert_snapshot!("report_text", text(&sample::report(), false)));
    snapshots(|| insta::assert_snapshot!("report_text_faultless", text(&sample::faultless(), false)));
}

#[test]
fn the_junit_report_is_this() {
    snapshots(|| {
        let mut report = sample::report();
        report.cases.retain(|row| row.name == "5" || row.name == "13.5.2");
        insta::assert_snapshot!("report_junit", junit(&report));
    });
}

fn volume(failure: &isoracle::judge::report::Failure) -> &VolumeQuestion {
    failure.question.volume().expect("the sample is about volumes")
}

#[test]
fn pictures_are_these() {
    snapshots(|| {
        let tunnel = sample::missed_tunnel();
        insta::assert_snapshot!(
            "picture_true",
            volume_picture(volume(&tunnel), tunnel.expected.as_ref(), "True surface")
        );
        let crack = sample::crack();
        insta::assert_snapshot!("picture_crack", volume_picture(volume(&crack), crack.found.as_ref(), "Candidate"));
        insta::assert_snapshot!("icon_13_5_2", case_icon(Case::C13_5_2));
    });
}

#[test]
fn terminal_lines_fit_80_columns_but_for_commands() {
    let report = sample::report();
    for line in text(&report, false).lines() {
        let is_command = report.failures.iter().any(|failure| line.contains(&failure.command));
        assert!(is_command || line.chars().count() <= 80, "{line}");
    }
}

#[test]
fn colours_add_escapes_and_nothing_else() {
    let coloured = text(&sample::report(), true);
    assert!(coloured.contains("\x1b[1;35mBROKEN"));
    let mut plain = String::new();
    let mut parts = coloured.split('\x1b');
    plain += parts.next().expect("a first part");
    parts.for_each(|part| plain += part.split_once('m').expect("a colour ends in m").1);
    assert_eq!(plain, text(&sample::report(), false));
}

#[test]
fn every_failure_is_in_every_form() {
    let report = sample::report();
    let (page, xml, terminal) = (page(&report, &[]), junit(&report), text(&report, false));
    let elements = elements(&page);
    assert_eq!(elements.iter().filter(|name| *name == "article").count(), report.failures.len());
    for failure in &report.failures {
        for form in [&page, &xml, &terminal] {
            assert!(form.contains(&failure.fault) && form.contains(&failure.formula), "{}", failure.fault);
        }
        let escaped = |text: &str| text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
        assert!(page.contains(&escaped(&failure.command)) && terminal.contains(&failure.command));
        assert!(page.contains(&escaped(&failure.messages[0])));
        assert!(page.contains(&failure.question.json().replace('"', "&quot;")));
        for difference in &failure.differences {
            assert!(page.contains(&escaped(&difference.invariant)));
        }
    }
    let value: serde_json::Value = serde_json::from_str(&json(&report)).expect("JSON");
    assert_eq!(value["failures"].as_array().map(Vec::len), Some(report.failures.len()));
    assert_eq!(value["verdict"], "broken");
}

#[test]
fn the_page_needs_nothing_else() {
    let figure = surface_picture(&[[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], &[[0, 1, 2]], 100);
    let section = Section {
        title: "A real surface".to_owned(),
        blocks: vec![
            Block::Paragraph("a < b".to_owned()),
            Block::Figures(vec![(figure, "A triangle".to_owned())]),
            Block::Table {
                caption: "Counts".to_owned(),
                columns: vec!["what".to_owned(), "found".to_owned()],
                rows: vec![vec!["χ".to_owned(), "2".to_owned()]],
            },
        ],
    };
    for report in [sample::report(), sample::faultless()] {
        // A namespace is a name and is not fetched.
        let page = page(&report, std::slice::from_ref(&section)).replace(" xmlns=\"http://www.w3.org/2000/svg\"", "");
        let elements = elements(&page);
        for foreign in ["script", "link", "iframe", "object", "img", "image", "foreignObject"] {
            assert!(!elements.iter().any(|name| name == foreign), "{foreign}");
        }
        for outside in ["http:", "https:", "//", "url(", "@import", " src=", "data:"] {
            assert!(!page.contains(outside), "{outside}");
        }
        assert!(page.contains("a &lt; b") && page.contains("A real surface"));
        let drawn = elements.iter().filter(|name| *name == "svg").count();
        assert_eq!(drawn, report.cases.len() + 2 * report.failures.len() + 1);
        assert_eq!(drawn, page.matches("role=\"img\"").count(), "every picture has a name");
    }
}

#[test]
fn ids_of_the_page_are_unique_and_its_links_lead_to_them() {
    let page = page(&sample::report(), &[]);
    let ends = |mark: &str| -> Vec<String> {
        page.split(mark).skip(1).map(|rest| rest.split('"').next().expect("a quote ends").to_owned()).collect()
    };
    let mut ids = ends(" id=\"");
    for link in ends("href=\"#").iter().chain(&ends("aria-labelledby=\"")) {
        assert!(ids.contains(link), "{link}");
    }
    let count = ids.len();
    ids.sort();
    ids.dedup();
    assert_eq!(ids.len(), count);
}

#[test]
fn hostile_texts_stay_texts() {
    let report = hostile();
    let page = page(&report, &[]);
    assert!(!elements(&page).iter().any(|name| name == "script" || name == "b"));
    assert!(page.contains("&lt;script&gt;"));
    elements(&junit(&report));
    let terminal = text(&report, false);
    assert!(!terminal.contains('\u{1b}'), "no escape of the candidate reaches the terminal");
}

#[test]
fn hostile_meshes_are_drawn_as_far_as_they_go() {
    let question = sample::question([2, 2, 2], &[1, -1, -1, -1, -1, -1, -1, -1]);
    let vertices = vec![[f64::NAN; 3], [0.5, 0.0, 0.0], [1e300, 0.0, 0.0], [0.0, 0.5, 0.0], [0.0, 0.0, 0.5]];
    let faces = vec![[0, 1, 3], [1, 2, 3], [1, 1, 3], [9, 1, 3], [1, 3, 4]];
    let picture =
        volume_picture(&question, Some(&SurfaceRecord { vertices: vertices.clone(), faces: faces.clone() }), "t");
    elements(picture.as_str());
    assert!(picture.as_str().contains("3 of them lie outside the picture"));
    assert!(!picture.as_str().contains("NaN") && !picture.as_str().contains("inf"));
    elements(surface_picture(&vertices, &faces, 200).as_str());
    elements(surface_picture(&[], &[], 200).as_str());
}

#[test]
fn a_nearer_triangle_is_drawn_later() {
    let question = sample::question([2, 2, 2], &[1, 1, 1, 1, -1, -1, -1, -1]);
    let at = |y: f64| [[0.1, y, 0.1], [0.9, y, 0.1], [0.5, y, 0.9]];
    let vertices: Vec<[f64; 3]> = at(0.2).into_iter().chain(at(0.8)).collect();
    // The same sides of both triangles, so that no two pieces of the pictures differ but by their order.
    let [near_first, far_first] = [vec![[0, 1, 2], [3, 4, 5]], vec![[3, 4, 5], [0, 1, 2]]]
        .map(|faces| volume_picture(&question, Some(&SurfaceRecord { vertices: vertices.clone(), faces }), "t"));
    assert_eq!(near_first, far_first);
    let fills: Vec<&str> = near_first.as_str().split("class=\"front\" d=\"M").skip(1).collect();
    let left = |path: &str| path.split(' ').next().and_then(|x| x.parse::<f64>().ok()).expect("a path starts with x");
    // What is farther along y is farther to the right in the picture.
    assert!(left(fills[0]) > left(fills[1]));
}

#[test]
fn questions_that_are_no_volumes_are_still_drawn() {
    for (shape, values) in [([0, 0, 0], 0), ([2, 2, 2], 3), ([1, 1, 1], 8), ([2, 2, 2], 40), ([50, 50, 50], 125_000)] {
        let values = (0..values).map(|i| if i == 1 { "?".to_owned() } else { i.to_string() }).collect();
        let question = VolumeQuestion { op: "isosurface.mesh".to_owned(), shape, values, isovalue: "1/0".to_owned() };
        elements(volume_picture(&question, None, "t").as_str());
    }
}

#[test]
fn every_case_has_an_icon_of_its_own() {
    let mut icons: Vec<_> = Case::ALL.iter().map(|case| case_icon(*case).to_string()).collect();
    icons.iter().for_each(|icon| drop(elements(icon)));
    icons.sort();
    icons.dedup();
    assert_eq!(icons.len(), 33);
}

#[test]
fn pass_rates_round_down() {
    let mut row = sample::report().cases[0].clone();
    (row.asked, row.passed) = (100_000, 99_999);
    assert_eq!(row.pass_rate(), "99.9");
    row.passed = 100_000;
    assert_eq!(row.pass_rate(), "100");
    row.asked = 0;
    assert_eq!(row.pass_rate(), "–");
}

#[test]
fn the_verdict_is_one_sentence_that_counts() {
    let mut report = sample::report();
    assert_eq!(
        report.verdict_sentence(),
        "It crashed, hung or spoke nonsense on 2 of 42,490 questions, and 1,498 answers are wrong. It declined 40."
    );
    report.verdict = Outcome::Wrong;
    assert_eq!(report.verdict_sentence(), "1,498 answers are wrong, of 42,490 questions. It declined 40.");
    let faultless = sample::faultless();
    assert_eq!(faultless.verdict_sentence(), "Every answer is right: 42,450 of 42,490 questions. It declined 40.");
}

/// A wavy sheet of 2·n² triangles.
fn sheet(n: u32) -> (Vec<[f64; 3]>, Vec<[u32; 3]>) {
    let height = |x: f64, y: f64| (x * 7.0).sin() * (y * 5.0).cos() * 0.2;
    let at = |i: u32| f64::from(i) / f64::from(n);
    let vertices = (0..=n).flat_map(|j| (0..=n).map(move |i| [at(i), at(j), height(at(i), at(j))])).collect();
    let corner = |i: u32, j: u32| j * (n + 1) + i;
    let faces = (0..n).flat_map(|j| (0..n).map(move |i| (i, j))).flat_map(|(i, j)| {
        let (a, b, c, d) = (corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1));
        [[a, b, c], [a, c, d]]
    });
    (vertices, faces.collect())
}

#[test]
fn a_surface_of_sixty_thousand_triangles_takes_less_than_a_megabyte_and_a_half() {
    let (vertices, faces) = sheet(174);
    let picture = surface_picture(&vertices, &faces, 700);
    elements(picture.as_str());
    assert!(faces.len() > 60_000 && picture.as_str().len() < 1_500_000, "{}", picture.as_str().len());
    assert!(picture.as_str().contains("60,552 triangles") && !picture.as_str().contains("coarser"));
}

#[test]
fn a_larger_surface_is_drawn_coarser_and_says_so() {
    let (vertices, faces) = sheet(400);
    let picture = surface_picture(&vertices, &faces, 700);
    assert!(picture.as_str().contains("320,000 triangles") && picture.as_str().contains("Drawn coarser"));
    assert!(picture.as_str().len() < 2_000_000, "{}", picture.as_str().len());
}
