//! The protocol: what is asked, what is answered, and that no line ends the process.
#![cfg(feature = "cli")]

mod fuzz;
mod process;

use isoracle::answer::{MAX_LINE, serve};
use serde_json::{Value, json};
use std::io::{self, BufRead, BufReader, Read};

/// The answers to some input.
fn ask(input: &[u8]) -> Vec<Value> {
    let mut output = Vec::new();
    serve(input, &mut output).expect("memory can be read and written");
    let text = String::from_utf8(output).expect("answers are UTF-8");
    assert!(text.is_empty() || text.ends_with('\n'));
    text.lines().map(|line| serde_json::from_str(line).expect("an answer is JSON")).collect()
}

/// The answer to a line, which a sound question follows, to be answered too.
fn ask_one(line: impl AsRef<[u8]>) -> Value {
    let input = [line.as_ref(), b"\n{\"id\":\"after\",\"op\":\"hello\"}\n"].concat();
    let [answer, after] = <[Value; 2]>::try_from(ask(&input)).expect("two lines have two answers");
    assert_eq!((&after["id"], &after["out"]["protocol"]), (&json!("after"), &json!(1)));
    answer
}

fn question(op: &str, input: &str) -> Value {
    ask_one(format!(r#"{{"id":7,"op":"{op}","in":{input}}}"#))
}

#[track_caller]
fn is_refused(answer: &Value, id: Value, kind: &str, message: &str) {
    let error = &answer["error"];
    assert_eq!((&answer["id"], error["kind"].as_str()), (&id, Some(kind)), "{answer}");
    assert!(error["message"].as_str().is_some_and(|text| text.contains(message)), "{answer}");
    assert_eq!(answer.as_object().map(|fields| fields.len()), Some(2), "{answer}");
}

/// Asks about `isosurface.cell` and expects a refusal.
#[track_caller]
fn cell_is_refused(input: &str, kind: &str, message: &str) {
    is_refused(&question("isosurface.cell", input), json!(7), kind, message);
}

/// Asks every operation that takes a volume, and expects a refusal.
#[track_caller]
fn volume_is_refused(volume: &str, kind: &str, message: &str) {
    for op in ["isosurface.topology", "isosurface.mesh", "isosurface.tetrahedra"] {
        let answer = question(op, &format!(r#"{{"volume":{volume},"isovalue":0}}"#));
        is_refused(&answer, json!(7), kind, message);
    }
}

#[test]
fn hello_names_the_oracle_and_its_operations() {
    let out = question("hello", r#"{"protocol":1}"#)["out"].clone();
    assert_eq!(out["name"], "isoracle");
    assert_eq!(out["version"], env!("CARGO_PKG_VERSION"));
    let ops = [
        "isosurface.square",
        "isosurface.cell",
        "isosurface.topology",
        "isosurface.mesh",
        "isosurface.polyline",
        "isosurface.tetrahedra",
        "spline.coefficients",
        "spline.evaluate",
        "spline.impulse",
        "trilinear.evaluate",
        "curvature.implicit_curve",
        "curvature.implicit_surface",
        "curvature.parametric_curve",
        "curvature.parametric_surface",
        "curvature.spline",
        "curvature.normalize",
        "mesh.check",
        "mesh.plane",
        "mesh.angle_deficits",
        "complex.glue",
        "complex.refine",
    ];
    assert_eq!(out["ops"], json!(ops));
    for op in ops {
        is_refused(&question(op, "{}"), json!(7), "invalid-input", "missing");
    }
}

#[test]
fn what_is_not_supported_is_no_error() {
    let unknown = question("solid.evaluate", "{}");
    assert_eq!(unknown, json!({"id": 7, "unsupported": "no operation \"solid.evaluate\"; `hello` lists them"}));
    assert!(question("hello", r#"{"protocol":2}"#)["unsupported"].is_string());
}

#[test]
fn a_spline_is_differentiated_at_most_twice_along_an_axis() {
    let ask = |word: &str| {
        let input =
            json!({"values": [1, 2, 5], "shape": [3], "boundary": "mirror", "points": [[0]], "derivatives": [word]});
        question("spline.evaluate", &input.to_string())
    };
    assert!(ask("xx")["out"].is_object());
    for word in ["xxx", "y", "X", " "] {
        is_refused(&ask(word), json!(7), "invalid-input", "derivatives[0]: ");
    }
}

#[test]
fn ids_of_any_type_come_back() {
    for id in ["null", "true", "-0", "1.50", "18446744073709551616", "1E400", r#""ü\n""#, r#"[{"b":1,"a":[]}]"#] {
        let answer = ask_one(format!(r#"{{"in":{{}},"op":"hello","id":{id}}}"#));
        let sent: Value = serde_json::from_str(id).expect("an id is JSON");
        assert_eq!(answer["id"], sent);
        assert!(answer["out"].is_object());
    }
    assert_eq!(ask_one(r#"{"op":"hello"}"#)["id"], Value::Null);
}

#[test]
fn what_is_no_message_is_malformed() {
    let deep = format!(r#"{{"id":1,"op":"hello","in":{}}}"#, "[".repeat(100_000));
    let closed = format!(r#"{{"id":1,"op":"hello","in":{}{}}}"#, "[".repeat(1000), "]".repeat(1000));
    let lines: &[&[u8]] = &[
        b"hello",
        b"{",
        b"}",
        b"null",
        b"17",
        b"NaN",
        b"\"{}\"",
        b"[]",
        b"[1,\"hello\",{}]",
        b"{}",
        b"{\"id\":1}",
        b"{\"id\":1,\"op\":null}",
        b"{\"id\":1,\"op\":[\"hello\"]}",
        b"{\"id\":1,\"op\":\"hello\"} {\"id\":2,\"op\":\"hello\"}",
        b"{\"id\":1,\"op\":\"hello\",}",
        b"{\"id\":1,\"op\":\"hello\",\"x\":01}",
        b"{\"id\":1,\"op\":\"hello\",\"x\":Nan}",
        b"{'id':1,'op':'hello'}",
        b"{\"id\":1,\"op\":\"hello\",\"id\":2}",
        b"{\"id\":1,\"op\":\"hello\",\"op\":\"hello\"}",
        b"{\"id\":1,\"op\":\"hello\",\"in\":{},\"in\":{}}",
        b"{\"id\":\"\xff\",\"op\":\"hello\"}",
        b"{\"id\":\"\xed\xa0\x80\",\"op\":\"hello\"}",
        b"{\"id\":\"\\ud800\",\"op\":\"hello\"}",
        b"{\"id\":\"\0\",\"op\":\"hello\"}",
        b"\xef\xbb\xbf{\"id\":1,\"op\":\"hello\"}",
        b"\0",
        b"\x0c",
        deep.as_bytes(),
        closed.as_bytes(),
    ];
    for line in lines {
        is_refused(&ask_one(line), Value::Null, "malformed", "not ");
    }
}

#[test]
fn lines_end_with_a_newline_and_perhaps_a_carriage_return() {
    let answers = ask(b"\n\r\n  \t\r\n{\"id\":1,\"op\":\"hello\"}\r\n\n{\"id\":2,\"op\":\"hello\"}");
    assert_eq!(answers.iter().map(|answer| answer["id"].clone()).collect::<Vec<_>>(), [json!(1), json!(2)]);
    assert!(ask(b"").is_empty());
}

#[test]
fn unknown_fields_are_ignored_and_of_twins_the_last_counts() {
    let input = r#"{"values":[1,2,3,4,5,6,7,8],"isovalue":9,"isovalue":"1/2","tie_":"above","digits":[]}"#;
    assert_eq!(question("isosurface.cell", input)["out"]["case"], "0");
}

#[test]
fn numbers_are_exact_in_every_form() {
    let value = |number: &str| {
        let input = format!(r#"{{"values":[{number},0,0,0,0,0,0,0],"points":[[0,0,0]]}}"#);
        question("trilinear.evaluate", &input)["out"]["values"][0].clone()
    };
    assert_eq!(value("-12"), "-12");
    assert_eq!(value("123456789012345678901234567890"), "123456789012345678901234567890");
    assert_eq!(value("0.5"), "1/2");
    assert_eq!(value("5E-1"), "1/2");
    assert_eq!(value("1e2"), "100");
    assert_eq!(value("0.1"), "3602879701896397/36028797018963968");
    assert_eq!(value("-0.0"), "0");
    assert_eq!(value(r#""0.1""#), "1/10");
    assert_eq!(value(r#""-6/4""#), "-3/2");
    assert_eq!(value(r#""0x1.8p-3""#), "3/16");
    assert_eq!(value(r#""1e400""#).as_str().map(str::len), Some(401));
}

#[test]
fn fields_that_are_not_as_they_should_be_are_named() {
    let cell = |values: &str, rest: &str| format!(r#"{{"values":{values}{rest}}}"#);
    let isovalue = r#","isovalue":0"#;
    let number = |n: &str| cell(&format!("[1,1,1,{n},1,1,1,1]"), isovalue);
    let invalid = "invalid-input";
    cell_is_refused("[]", invalid, "in: expected an object, found an array");
    cell_is_refused("null", invalid, "in: expected an object, found null");
    cell_is_refused("{}", invalid, "values: missing");
    cell_is_refused(&cell("[1,2,3,4,5,6,7,8]", ""), invalid, "isovalue: missing");
    cell_is_refused(&cell("[1,2,3,4,5,6,7]", isovalue), invalid, "values: expected 8 items, found 7");
    cell_is_refused(&cell("[1,2,3,4,5,6,7,8,9]", isovalue), invalid, "values: expected 8 items, found 9");
    cell_is_refused(&cell("\"12345678\"", isovalue), invalid, "values: expected an array, found a string");
    cell_is_refused(&number("null"), invalid, "values[3]: expected a number, found null");
    cell_is_refused(&number("true"), invalid, "values[3]: expected a number, found a boolean");
    cell_is_refused(&number("[1]"), invalid, "values[3]: expected a number, found an array");
    cell_is_refused(&number("NaN"), invalid, "values[3]: NaN is not a number here");
    cell_is_refused(&number("-Infinity"), invalid, "values[3]: an infinity is not a number here");
    cell_is_refused(&number("\"nan\""), invalid, "values[3]: NaN is not a number here");
    cell_is_refused(&number("1e400"), invalid, "values[3]: the number is beyond the largest binary64");
    cell_is_refused(&number("\"1/0\""), invalid, "values[3]: the denominator is zero");
    cell_is_refused(&number("\"\""), invalid, "values[3]: an empty text");
    cell_is_refused(&number("\"one\""), invalid, "values[3]: `one` is not a number");
    cell_is_refused(&number("\" 1\""), invalid, "values[3]: ` 1` is not a number");
    cell_is_refused(&number("\"1e10001\""), "limit", "values[3]: the exponent is beyond ±10000");
    cell_is_refused(&number(&"9".repeat(100_001)), "limit", "values[3]: 100001 characters");
    cell_is_refused(&cell("[1,1,1,1,1,1,1,1]", r#","isovalue":NaN"#), invalid, "isovalue: NaN");
    for tie in ["\"above\"", "\"NaN\"", "\"\""] {
        let rest = format!(r#","isovalue":0,"tie":{tie}"#);
        cell_is_refused(&cell("[1,1,1,1,1,1,1,1]", &rest), invalid, "tie: expected \"below\"");
    }
    cell_is_refused(&cell("[1,1,1,1,1,1,1,1]", r#","isovalue":0,"tie":null"#), invalid, "tie: expected a string");
    let polyline = r#"{"shape":[2,2],"values":[1,2,3],"isovalue":0,"method":"squares"}"#;
    is_refused(&question("isosurface.polyline", polyline), json!(7), invalid, "values: the shape asks for 4");
    let polyline = r#"{"shape":[2,2],"values":[1,2,3,4],"isovalue":0,"method":"cubes"}"#;
    is_refused(&question("isosurface.polyline", polyline), json!(7), invalid, "method: expected \"squares\" or");
    let points = r#"{"values":[1,2,3,4,5,6,7,8],"points":[[0,0,0],[0,"x",0]]}"#;
    is_refused(&question("trilinear.evaluate", points), json!(7), invalid, "points[1][1]: `x` is not a number");
}

#[test]
fn words_for_non_numbers_are_recovered_outside_of_strings_alone() {
    let answer = ask_one(r#"{"id":"a NaN, \"Infinity","op":"isosurface.cell","in":{"values":[NaN]}}"#);
    is_refused(&answer, json!("a NaN, \"Infinity"), "invalid-input", "values: expected 8 items");
}

#[test]
fn volumes_that_are_none_are_named() {
    let invalid = "invalid-input";
    let volume = |shape: &str| format!(r#"{{"shape":{shape},"values":[1,2,3,4,5,6,7,8]}}"#);
    volume_is_refused("[]", invalid, "volume: expected an object, found an array");
    volume_is_refused("{}", invalid, "volume.shape: missing");
    volume_is_refused(r#"{"shape":[2,2,2]}"#, invalid, "volume.values: missing");
    volume_is_refused(r#"{"shape":[2,2,2],"values":{}}"#, invalid, "volume.values: expected an array");
    volume_is_refused(&volume("[2,2]"), invalid, "volume.shape: expected 3 items, found 2");
    volume_is_refused(&volume("[2,1,2]"), invalid, "volume.shape[1]: expected an integer, at least 2");
    volume_is_refused(&volume("[2,2,0]"), invalid, "volume.shape[2]: expected an integer, at least 2");
    volume_is_refused(&volume("[-2,2,2]"), invalid, "volume.shape[0]: expected an integer, at least 2");
    volume_is_refused(&volume("[2,2.5,2]"), invalid, "volume.shape[1]: expected an integer, at least 2");
    volume_is_refused(&volume("[2,null,2]"), invalid, "volume.shape[1]: expected a number, found null");
    volume_is_refused(&volume("[2,2,3]"), invalid, "volume.values: the shape asks for 12 of them, and there are 8");
    volume_is_refused(&volume("[16384,16384,2]"), "limit", "volume.shape: more than the limit of 2²⁸ samples");
    volume_is_refused(&volume("[4294967296,4294967296,2]"), "limit", "volume.shape: more than");
    volume_is_refused(&volume("[2,2,1000000000000000000000000]"), "limit", "volume.shape: more than");
    let values = |values: &str| format!(r#"{{"shape":[2,2,2],"values":[{values}]}}"#);
    volume_is_refused(&values("1,2,3,NaN,5,6,7,8"), invalid, "volume.values[3]: NaN is not a number here");
    volume_is_refused(&values("1,2,3,1e999,5,6,7,8"), invalid, "volume.values[3]: the number is beyond");
    volume_is_refused(&values(r#"1,2,3,"x",5,6,7,8"#), invalid, "volume.values[3]: `x` is not a number");
    volume_is_refused(r#"{"file":"no such.npy"}"#, invalid, "volume.file: no such.npy: ");
    volume_is_refused(r#"{"file":"Cargo.toml"}"#, invalid, "volume.file: Cargo.toml: unknown extension");
    volume_is_refused(r#"{"file":7}"#, invalid, "volume.file: expected a string, found a number");
    volume_is_refused(r#"{"file":"v.npy","values":[]}"#, invalid, "volume.values: stands beside `file`");
}

/// A NumPy file of `<f8` samples, x fastest.
fn npy(shape: [usize; 3], samples: &[f64]) -> Vec<u8> {
    let [nx, ny, nz] = shape;
    let dict = format!("{{'descr': '<f8', 'fortran_order': True, 'shape': ({nx}, {ny}, {nz}), }}");
    let header = format!("{dict:117}\n");
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    bytes.extend(u16::try_from(header.len()).expect("a short header").to_le_bytes());
    bytes.extend(header.as_bytes());
    bytes.extend(samples.iter().flat_map(|sample| sample.to_le_bytes()));
    bytes
}

#[test]
fn a_volume_in_a_file_is_the_same_volume() {
    let directory = tempfile::tempdir().expect("a temporary directory");
    let path = directory.path().join("v.npy");
    let mut samples: Vec<f64> = (0..24).map(|i| f64::from(i * 7 % 11) - 5.3).collect();
    std::fs::write(&path, npy([2, 3, 4], &samples)).expect("the file can be written");
    let file = json!({"file": path});
    let in_line = json!({"shape": [2, 3, 4], "values": samples});
    for op in ["isosurface.topology", "isosurface.mesh", "isosurface.tetrahedra"] {
        let about = |volume: &Value| question(op, &json!({"volume": volume, "isovalue": 0}).to_string())["out"].clone();
        assert!(about(&file).is_object());
        assert_eq!(about(&file), about(&in_line));
    }
    samples[5] = f64::NAN;
    std::fs::write(&path, npy([2, 3, 4], &samples)).expect("the file can be written");
    volume_is_refused(&file.to_string(), "invalid-input", "values[5]: not a finite number");
    std::fs::write(&path, npy([2, 3, 4], &samples[1..])).expect("the file can be written");
    volume_is_refused(&file.to_string(), "invalid-input", "volume.file: ");
    std::fs::write(&path, npy([1, 6, 4], &[0.5; 24])).expect("the file can be written");
    volume_is_refused(&file.to_string(), "invalid-input", "shape[0]: a grid needs at least 2 samples");
    std::fs::write(&path, npy([1 << 20, 1 << 20, 2], &[])).expect("the file can be written");
    volume_is_refused(&file.to_string(), "limit", "volume.file: ");
}

#[test]
fn integers_floats_and_rationals_in_line_mean_the_same() {
    let about = |values: &str| {
        let volume = format!(r#"{{"volume":{{"shape":[2,2,2],"values":[{values}]}},"isovalue":"1/3"}}"#);
        question("isosurface.mesh", &volume)["out"].clone()
    };
    let integers = about("1,-2,3,-4,5,6,-7,8");
    assert!(integers.is_object());
    assert_eq!(integers, about("1.0,-2.0,3,-4,5,6,-7,8e0"));
    assert_eq!(integers, about(r#""1",-2,"6/2",-4,"0x5",6.0,-7,8"#));
    let large = about("4294967296,-2,3,-4,5,6,-7,9007199254740993");
    assert_eq!(large, about(r#""4294967296",-2,3,-4,5,6,-7,"9007199254740993""#));
}

#[test]
fn ties_are_degenerate_unless_they_are_broken() {
    let degenerate = |op: &str, input: &str, message: &str| {
        let broken = input.replacen('{', r#"{"tie":"below","#, 1);
        is_refused(&question(op, input), json!(7), "degenerate", message);
        assert!(question(op, &broken)["out"].is_object());
    };
    degenerate("isosurface.cell", r#"{"values":[1,0,1,1,1,1,1,1],"isovalue":0}"#, "the value at corner 1");
    degenerate("isosurface.cell", r#"{"values":[1,-1,-1,1,2,2,2,2],"isovalue":0}"#, "face z=0 at (1/2, 1/2, 0)");
    degenerate("isosurface.square", r#"{"values":[1,-1,-1,1],"isovalue":0}"#, "the saddle (1/2, 1/2)");
    let volume = r#"{"volume":{"shape":[2,2,2],"values":[1,-1,"1/2",1,1,1,1,1]},"isovalue":0.5}"#;
    degenerate("isosurface.topology", volume, "cell [0, 0, 0]: the value at corner 2 equals the isovalue");
    degenerate("isosurface.mesh", volume, "cell [0, 0, 0]: the value at corner 2 equals the isovalue");
    degenerate("isosurface.tetrahedra", volume, "the sample at [0, 1, 0] equals the isovalue");
    let raster = r#"{"shape":[2,2],"values":[1,0,1,1],"isovalue":0,"method":"triangles"}"#;
    degenerate("isosurface.polyline", raster, "the sample at [1, 0] equals the isovalue");
    degenerate("isosurface.polyline", &raster.replace("triangles", "squares"), "square [0, 0]: the value at corner 1");
}

#[test]
fn answers_have_the_form_of_the_protocol() {
    let square = question("isosurface.square", r#"{"values":[1,-2,-3,"4.5"],"isovalue":0}"#);
    assert_eq!(
        square["out"],
        json!({
            "saddle": {"u": "8/21", "v": "2/7", "value": "-1/7"}, "determinant_sign": -1,
            "segments": [[[0, 1], [0, 2]], [[2, 3], [1, 3]]],
            "crossings": [{"edge": [0, 1], "t": "1/3"}, {"edge": [0, 2], "t": "1/4"}, {"edge": [1, 3], "t": "4/13"},
                {"edge": [2, 3], "t": "2/5"}],
        })
    );
    let plane = question("isosurface.square", r#"{"values":[0,1,2,3],"isovalue":10}"#);
    assert_eq!(plane["out"], json!({"saddle": null, "determinant_sign": -1, "segments": [], "crossings": []}));
    // The values are greater on the right, on the left of the way down.
    let polyline = r#"{"shape":[2,2],"values":[-1,1,-3,1],"isovalue":0,"method":"squares"}"#;
    assert_eq!(
        question("isosurface.polyline", polyline)["out"],
        json!({"vertices": [["3/4", "1"], ["1/2", "0"]], "segments": [[0, 1]]})
    );
    let volume = r#"{"volume":{"shape":[2,2,2],"values":[1,1,1,1,-1,-1,-1,-3]},"isovalue":0}"#;
    let mesh = question("isosurface.mesh", volume)["out"].clone();
    assert_eq!(mesh["vertices"].as_array().map(Vec::len), Some(4));
    assert!(mesh["vertices"].as_array().is_some_and(|vertices| vertices.contains(&json!(["1", "1", "1/4"]))));
    assert_eq!(mesh["faces"].as_array().map(Vec::len), Some(2));
    let topology = json!({"chi": 1, "components": 1, "boundary_loops": 1, "b0_neg": 1, "b0_pos": 1, "edge_crossings": 4,
        "component_list": [[1, 1, 0]]});
    assert_eq!(question("isosurface.topology", volume)["out"], topology);
    let evaluate = r#"{"values":[0,1,2,3,4,5,6,"15/2"],"points":[["1/2","1/2","1/2"],[2,0,-1]]}"#;
    assert_eq!(
        question("trilinear.evaluate", evaluate)["out"],
        json!({"values": ["57/16", "-2"], "gradients": [["9/8", "17/8", "33/8"], ["1", "1", "4"]]})
    );
}

/// Bytes that are made as they are read: so many `x`, then a sound question.
fn long_line(length: usize) -> impl BufRead {
    let question = &b"\n{\"id\":1,\"op\":\"hello\"}\n"[..];
    BufReader::new(io::repeat(b'x').take(length as u64).chain(question))
}

#[test]
fn a_line_beyond_the_limit_is_refused_and_the_next_one_answered() {
    for (length, kind) in [(MAX_LINE, "malformed"), (MAX_LINE + 1, "limit"), (3 * MAX_LINE, "limit")] {
        let mut output = Vec::new();
        serve(long_line(length), &mut output).expect("memory can be read and written");
        let answers: Vec<Value> =
            serde_json::Deserializer::from_slice(&output).into_iter().collect::<Result<_, _>>().expect("JSON lines");
        let [refused, answered] = &answers[..] else { panic!("two lines have two answers") };
        is_refused(refused, Value::Null, kind, "");
        assert!(answered["out"].is_object());
    }
}

#[test]
fn answers_keep_the_order_of_the_questions() {
    let large: Vec<i64> = (0..1000).map(|i| i * i * 7919 % 101 - 50).collect();
    let slow = json!({"volume": {"shape": [10, 10, 10], "values": large}, "isovalue": 0, "tie": "below"});
    let line = |id: usize| match id % 7 {
        0 => format!("{}\n", json!({"id": id, "op": "isosurface.mesh", "in": slow})),
        _ => format!("{}\n", json!({"id": id, "op": "hello"})),
    };
    let answers = ask((0..300).map(line).collect::<String>().as_bytes());
    let ids: Vec<_> = answers.iter().map(|answer| answer["id"].as_u64()).collect();
    assert_eq!(ids, (0..300).map(Some).collect::<Vec<_>>());
}
