//! `isoracle curvature` and `isoracle spline` as a stranger runs them.
#![cfg(feature = "cli")]

use assert_cmd::Command;
use isoracle::answer;
use isoracle::curvature::implicit_surface;
use isoracle::format::{GridRecord, Limits, Samples, VolumeRecord, read_grid, read_mesh, write_grid, write_volume};
use isoracle::number::binary::nearest_f64;
use isoracle::number::{Rational, text::parse};
use isoracle::spline::prefilter::interpolate;
use isoracle::spline::signal::{Boundary, Signal};
use serde_json::{Value, json};
use std::fs;
use std::path::Path;
use tempfile::TempDir;

/// Runs it in a folder with the volume of a ball, ball.npy: the squared distance from the middle of a grid of 9³ points.
fn run(folder: &TempDir, arguments: &[&str], input: &str) -> (Option<i32>, String, String) {
    let binary = assert_cmd::cargo::cargo_bin!("isoracle");
    let output = Command::new(binary).current_dir(folder).args(arguments).write_stdin(input).output().expect("it runs");
    let text = |bytes| String::from_utf8(bytes).expect("text is UTF-8");
    (output.status.code(), text(output.stdout), text(output.stderr))
}

fn ball() -> Vec<i32> {
    let square = |i: i32| (i - 4) * (i - 4);
    (0..729).map(|n| square(n % 9) + square(n / 9 % 9) + square(n / 81)).collect()
}

fn folder() -> TempDir {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let volume = VolumeRecord { shape: [9, 9, 9], samples: Samples::I32(ball()) };
    write_volume(&folder.path().join("ball.npy"), &volume).expect("it can be written");
    folder
}

/// Runs what must end with 2, and gives its stderr.
fn refused(folder: &TempDir, arguments: &[&str], input: &str) -> String {
    let (code, out, err) = run(folder, arguments, input);
    assert_eq!((code, out.as_str()), (Some(2), ""), "{err}");
    err
}

#[test]
fn curvatures_at_points_are_the_nearest_binary64_numbers() {
    let folder = folder();
    let input = "# x y z\n4 4 2\n\n9/2, 4, 1.25 # off the grid\n4 4 4\n";
    let (code, out, err) = run(&folder, &["curvature", "--volume", "ball.npy", "--points", "-"], input);
    assert_eq!((code, err.as_str()), (Some(0), ""));
    let rows: Vec<Vec<&str>> = out.lines().map(|line| line.split('\t').collect()).collect();
    assert_eq!(rows[0], ["x", "y", "z", "f", "fx", "fy", "fz", "K", "H", "k1", "k2"]);
    let values = ball().into_iter().map(Rational::from).collect();
    let spline = interpolate(&Signal::new([9, 9, 9], values, Boundary::Mirror).expect("a signal"));
    for (row, point) in rows[1..3].iter().zip([["4", "4", "2"], ["9/2", "4", "5/4"]]) {
        assert_eq!(row[..3], point);
        let jet = spline.jet(&point.map(|x| parse(x).expect("a number")));
        let surface = implicit_surface::curvature(&jet).expect("regular");
        let number = |i: usize| row[i].parse::<f64>().expect("a number");
        assert_eq!(number(3), nearest_f64(&jet.value));
        assert_eq!(number(6), nearest_f64(&jet.gradient[2]));
        assert_eq!(number(7), nearest_f64(&surface.gaussian));
        let [k1, k2] = surface.principal().enclosure(100);
        for (i, k) in [(9, k1), (10, k2)] {
            let (lo, hi) = k.bounds().expect("finite");
            assert_eq!([number(i); 2], [nearest_f64(&lo), nearest_f64(&hi)]);
        }
        assert!(number(8) < 0.0 && number(10) <= number(9), "f grows outward: {row:?}");
    }
    assert_eq!(rows[3][3..], ["0", "0", "0", "0", "singular", "singular", "singular", "singular"]);
}

#[test]
fn exact_curvatures_are_those_of_the_protocol() {
    let folder = folder();
    fs::write(folder.path().join("points.txt"), "4 4 2\n4 4 4\n1/3 1/7 1/9\n").expect("it can be written");
    let arguments =
        ["curvature", "--volume", "ball.npy", "--points", "points.txt", "--exact", "--boundary", "periodic"];
    let (code, out, err) = run(&folder, &arguments, "");
    assert_eq!((code, err.as_str()), (Some(0), ""));
    let lines: Vec<Value> = out.lines().map(|line| serde_json::from_str(line).expect("JSON")).collect();
    assert_eq!(lines[1]["error"]["kind"], "degenerate");
    let points = [["4", "4", "2"], ["1/3", "1/7", "1/9"]];
    let question = json!({"values": ball(), "shape": [9, 9, 9], "boundary": "periodic", "points": points});
    let truth = answer::out("curvature.spline", question.as_object().expect("an object")).expect("regular").value();
    for (line, (truth, point)) in
        [&lines[0], &lines[2]].iter().zip(truth["points"].as_array().expect("a list").iter().zip(points))
    {
        assert_eq!(line["point"], json!(point));
        for (name, value) in truth.as_object().expect("an object") {
            assert_eq!(&line[name], value, "{name}");
        }
    }
}

#[test]
fn a_mesh_is_painted_by_its_curvature() {
    let folder = folder();
    let isovalue = ["--isovalue", "5/2", "--volume", "ball.npy", "--out", "ball.ply"];
    for map in ["gaussian", "mean", "k1", "k2"] {
        let (code, out, err) = run(&folder, &[&["curvature", "--map", map][..], &isovalue].concat(), "");
        assert_eq!((code, out.as_str()), (Some(0), ""), "{err}");
        assert!(err.starts_with("ball.ply: ") && err.contains("vertices") && err.contains("λ = "), "{err}");
        let bytes = fs::read(folder.path().join("ball.ply")).expect("it was written");
        let header = String::from_utf8_lossy(&bytes[..500]).into_owned();
        assert!(header.contains(&format!("property double {map}\n")), "{header}");
        let start = bytes.windows(11).position(|w| w == b"end_header\n").expect("a header") + 11;
        let mesh = read_mesh(&folder.path().join("ball.ply")).expect("it can be read");
        for row in bytes[start..start + 35 * mesh.vertices.len()].chunks(35) {
            let number = f64::from_le_bytes(row[27..].try_into().expect("eight bytes"));
            let [red, _, blue] = row[24..27] else { unreachable!("three bytes") };
            // On a sphere whose function grows outward K > 0 > H.
            assert_eq!(number > 0.0, map == "gaussian", "{number}");
            assert_eq!(red > blue, number > 0.0, "red is positive, blue negative");
        }
    }
    let (_, _, err) =
        run(&folder, &[&["curvature", "--map", "gaussian", "--lambda", "1/2"][..], &isovalue].concat(), "");
    assert!(err.contains("λ = 0.5000"), "{err}");
}

#[test]
fn the_total_curvature_stands_beside_the_trilinear_one() {
    let folder = folder();
    let arguments = ["curvature", "--volume", "ball.npy", "--isovalue", "19/2", "--total"];
    let (code, out, err) = run(&folder, &arguments, "");
    assert_eq!((code, err.as_str()), (Some(0), ""));
    for line in
        ["χ = 2, edge crossings 0, ∫K dA = 4π\n", "χ = 2, edge crossings 0, 2πχ less corners = 4π\n", "the two agree\n"]
    {
        assert!(out.contains(line), "{out}");
    }
    let err = refused(&folder, &[&arguments[..5], &["--tie", "below"]].concat(), "");
    assert!(err.contains("--points"), "{err}");
    let err = refused(&folder, &["curvature", "--volume", "ball.npy", "--isovalue", "0", "--total"], "");
    assert!(err.contains("--isovalue: "), "{err}");
}

#[test]
fn what_curvature_cannot_use_is_named() {
    let folder = folder();
    let at = ["curvature", "--volume", "ball.npy", "--points", "-"];
    for (input, message) in [
        ("1 2 3\n1 2\n", "line 2: expected 3 coordinates, found 2"),
        ("1 2 x\n", "line 1, coordinate 3: `x` is not a number"),
        ("1 2 nan\n", "line 1, coordinate 3"),
    ] {
        let err = refused(&folder, &at, input);
        assert!(err.contains(message), "{err}");
    }
    let map = ["curvature", "--volume", "ball.npy", "--isovalue", "19/2", "--map", "gaussian"];
    let cases: [(&[&str], &str); 5] = [
        (&["--out", "ball.stl"], "a painted mesh is written as .ply"),
        (&["--out", "ball.ply", "--lambda", "0"], "--lambda: expected a number above 0, found 0"),
        (&[], "--out"),
        (&["--out", "ball.ply", "--points", "-"], "cannot be used with"),
        (&["--out", "ball.ply", "--isovalue", "1"], "--isovalue"),
    ];
    for (more, message) in cases {
        let err = refused(&folder, &[&map[..], more].concat(), "");
        assert!(err.contains(message), "{message}: {err}");
    }
    assert!(
        refused(&folder, &["curvature", "--volume", "none.npy", "--points", "-"], "").contains("--volume: none.npy")
    );
}

#[test]
fn coefficients_are_written_rounded_or_exact() {
    let folder = folder();
    fs::write(folder.path().join("line.txt"), "1 0 0\n0\n").expect("it can be written");
    let (code, out, err) = run(&folder, &["spline", "coefficients", "line.txt", "--exact"], "");
    assert_eq!((code, out.as_str(), err.as_str()), (Some(0), "26/15\n-7/15\n2/15\n-1/15\n", ""));
    let (_, out, _) = run(&folder, &["spline", "coefficients", "line.txt"], "");
    let rounded: Vec<f64> = out.lines().map(|x| x.parse().expect("a number")).collect();
    assert_eq!(rounded, [26.0 / 15.0, -7.0 / 15.0, 2.0 / 15.0, -1.0 / 15.0]);
    let (code, out, err) =
        run(&folder, &["spline", "coefficients", "ball.npy", "--out", "c.npy", "--boundary", "periodic"], "");
    assert_eq!((code, out.as_str(), err.as_str()), (Some(0), "", "c.npy: 729 coefficients\n"));
    let read = read_grid(&folder.path().join("c.npy"), &Limits::default()).expect("it can be read");
    let values = ball().into_iter().map(Rational::from).collect();
    let spline = interpolate(&Signal::new([9, 9, 9], values, Boundary::Periodic).expect("a signal"));
    let exact: Vec<f64> = spline.coefficients().values().iter().map(nearest_f64).collect();
    assert_eq!(read, GridRecord { shape: vec![9, 9, 9], samples: Samples::F64(exact) });
}

#[test]
fn derivatives_at_points_are_rounded_or_exact() {
    let folder = folder();
    let plane = GridRecord { shape: vec![2, 3], samples: Samples::I64(vec![1 << 60, 1, 2, -5, 0, 7]) };
    write_grid(&folder.path().join("plane.npy"), &plane).expect("it can be written");
    let arguments = ["spline", "evaluate", "plane.npy", "--points", "-", "--derivatives", ",x,yx"];
    let input = "0 0\n1/3,-7/2\n";
    let (code, rounded, err) = run(&folder, &arguments, input);
    assert_eq!((code, err.as_str()), (Some(0), ""));
    let (code, exact, err) = run(&folder, &[&arguments[..], &["--exact"]].concat(), input);
    assert_eq!((code, err.as_str()), (Some(0), ""));
    assert!(rounded.starts_with("x\ty\tf\tfx\tfyx\n0\t0\t1152921504606847000\t0\t"), "{rounded}");
    for (rounded, exact) in rounded.lines().zip(exact.lines()).skip(1) {
        for (rounded, exact) in rounded.split('\t').zip(exact.split('\t')).skip(2) {
            let rounded: f64 = rounded.parse().expect("a number");
            assert_eq!(rounded, nearest_f64(&parse(exact).expect("a number")));
        }
    }
}

#[test]
fn what_spline_cannot_use_is_named() {
    let folder = folder();
    let write =
        |name: &str, text: &str| fs::write(Path::new(folder.path()).join(name), text).expect("it can be written");
    write("one.txt", "17\n");
    write("word.txt", "1 two 3\n");
    write("empty.txt", "");
    let nan = GridRecord { shape: vec![3], samples: Samples::F64(vec![0.0, f64::NAN, 1.0]) };
    write_grid(&folder.path().join("nan.npy"), &nan).expect("it can be written");
    for (signal, message) in [
        ("one.txt", "shape[0]: a signal needs at least 2 samples along each axis, found 1"),
        ("empty.txt", "shape[0]: a signal needs at least 2 samples along each axis, found 0"),
        ("word.txt", "word.txt: number 2: `two` is not a number"),
        ("nan.npy", "values[1]: NaN is not a number here"),
        ("none.npy", "none.npy"),
        ("signal.png", "signal.png"),
    ] {
        let err = refused(&folder, &["spline", "coefficients", signal], "");
        assert!(err.contains(message), "{message}: {err}");
    }
    for exact in [&[][..], &["--exact"]] {
        let arguments = ["spline", "evaluate", "ball.npy", "--points", "-", "--derivatives", "x,xyz"];
        let err = refused(&folder, &[&arguments[..], exact].concat(), "1 1 1\n");
        assert!(err.contains("\"xyz\" is no word"), "{err}");
    }
}
