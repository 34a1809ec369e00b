"""The loop of candidate.py and the template minimal.py, as a judge meets them: over the pipe of a process."""
import json
import subprocess
import sys
import unittest
from fractions import Fraction
from pathlib import Path

from candidate import Fault, number

HERE = Path(__file__).parent

CELL = {"volume": {"shape": [2, 2, 2], "values": [-1, 1, 1, 1, 1, 1, 1, 1]}, "isovalue": 0}

# A candidate with one operation that fails in every way, and a library that prints.
WILD = """
import os, sys
from fractions import Fraction
from candidate import Fault, Unsupported, serve
def echo(question):
    print("a stray print")
    os.write(1, b"a stray write\\n")
    os.system("echo a stray child")
    match question["do"]:
        case "fraction": return {"x": [Fraction(1, 3), Fraction(2)]}
        case "nan": return {"x": float("nan")}
        case "raise": raise KeyError("lost")
        case "exit": sys.exit(3)
        case "fault": raise Fault("degenerate", "the gradient vanishes")
        case "unsupported": raise Unsupported("no periodic boundary")
        case "memory": raise MemoryError
serve("wild", "1", {"wild.echo": echo})
"""


def ask_lines(command, lines):
    """The answers of a process to raw lines, one each; the process ends with 0 at the end of input."""
    run = subprocess.run([sys.executable, *command], input=b"\n".join(lines) + b"\n", capture_output=True, cwd=HERE, timeout=60)
    assert run.returncode == 0, run.stderr
    answers = [json.loads(line) for line in run.stdout.splitlines()]
    assert len(answers) == len(lines), run.stdout
    return answers


def ask(command, *questions):
    return ask_lines(command, [json.dumps(q).encode() for q in questions])


def mesh(command, volume, isovalue):
    [answer] = ask(command, {"id": 1, "op": "isosurface.mesh", "in": {"volume": volume, "isovalue": isovalue}})
    vertices = [[Fraction(x) for x in vertex] for vertex in answer["out"]["vertices"]]
    return vertices, answer["out"]["faces"]


class Loop(unittest.TestCase):
    def test_hello_names_protocol_and_operations(self):
        [answer] = ask(["minimal.py"], {"id": 1, "op": "hello", "in": {"protocol": 1}})
        self.assertEqual(answer["id"], 1)
        self.assertEqual(answer["out"]["protocol"], 1)
        self.assertIn("isosurface.mesh", answer["out"]["ops"])

    def test_another_protocol_is_unsupported(self):
        [answer] = ask(["minimal.py"], {"id": 1, "op": "hello", "in": {"protocol": 2}})
        self.assertIn("unsupported", answer)

    def test_garbage_is_malformed_and_does_not_end_the_process(self):
        garbage = [b"", b"{", b"\xff\xfe", b"[1]", b"7", b'{"id":1}', b'{"op":"hello"}', b'{"id":1,"op":2}', b"[" * 100000,
                   b'{"id":1,"op":"hello","in":{"protocol":NaN}}', b'{"id":1e999,"op":"hello","in":{}}', b'{"id":%s,"op":"hello"}' % (b"9" * 5000)]
        *bad, good = ask_lines(["minimal.py"], garbage + [b'{"id":"after","op":"hello","in":{}}'])
        for line, answer in zip(garbage, bad):
            with self.subTest(line[:40]):
                self.assertEqual((answer["id"], answer["error"]["kind"]), (None, "malformed"))
        self.assertEqual((good["id"], good["out"]["protocol"]), ("after", 1))

    def test_id_is_echoed_as_sent(self):
        ids = [0, -3, 10**30, "a\"\u00e9\ud800", None, True, [1, {"x": 2}], 0.5]
        answers = ask(["minimal.py"], *({"id": id, "op": "hello", "in": {}} for id in ids))
        self.assertEqual([json.dumps(a["id"]) for a in answers], [json.dumps(id) for id in ids])

    def test_unknown_operation_is_unsupported(self):
        [answer] = ask(["minimal.py"], {"id": 1, "op": "solid.mesh", "in": {}})
        self.assertEqual(answer, {"id": 1, "unsupported": "no operation solid.mesh"})

    def test_unknown_fields_are_ignored(self):
        plain, more = ask(["minimal.py"], {"id": 1, "op": "isosurface.mesh", "in": CELL},
                          {"id": 1, "op": "isosurface.mesh", "in": {**CELL, "colour": "red"}, "note": []})
        self.assertEqual(plain, more)

    def test_a_false_question_is_invalid_input_and_names_the_field(self):
        cases = [
            (None, "in:"),
            ({"isovalue": 0}, "volume:"),
            ({**CELL, "volume": {"shape": [2, 2], "values": [1] * 4}}, "volume.shape:"),
            ({**CELL, "volume": {"shape": [2, 2, 1], "values": [1] * 4}}, "volume.shape:"),
            ({**CELL, "volume": {"shape": [2, 2, True], "values": [1] * 4}}, "volume.shape:"),
            ({**CELL, "volume": {"shape": [2, 2, 2], "values": [1] * 7}}, "volume.values:"),
            ({**CELL, "volume": {"shape": [2, 2, 2], "values": [1, 1, "NaN", 1, 1, 1, 1, 1]}}, "volume.values[2]:"),
            ({**CELL, "isovalue": "1/0"}, "isovalue:"),
            ({"volume": CELL["volume"]}, "isovalue:"),
        ]
        answers = ask(["minimal.py"], *({"id": n, "op": "isosurface.mesh", "in": q} for n, (q, _) in enumerate(cases)))
        for (question, field), answer in zip(cases, answers):
            with self.subTest(question):
                self.assertEqual(answer["error"]["kind"], "invalid-input")
                self.assertTrue(answer["error"]["message"].startswith(field), answer)

    def test_a_sample_on_the_isovalue_is_degenerate(self):
        tie, below = ({"id": 1, "op": "isosurface.mesh", "in": {**CELL, "isovalue": "-1.0", **more}} for more in ({}, {"tie": "below"}))
        answers = ask(["minimal.py"], tie, below)
        self.assertEqual(answers[0]["error"]["kind"], "degenerate")
        self.assertIn("unsupported", answers[1])

    def test_a_file_is_unsupported(self):
        [answer] = ask(["minimal.py"], {"id": 1, "op": "isosurface.mesh", "in": {"volume": {"file": "v.npy"}, "isovalue": 0}})
        self.assertIn("unsupported", answer)

    def test_what_an_operation_raises_becomes_the_answer(self):
        does = ["fraction", "nan", "raise", "exit", "fault", "unsupported", "memory"]
        answers = ask(["-c", WILD], *({"id": do, "op": "wild.echo", "in": {"do": do}} for do in does))
        self.assertEqual([a["id"] for a in answers], does)
        self.assertEqual(answers[0]["out"], {"x": ["1/3", "2"]})
        kinds = [a["error"]["kind"] if "error" in a else "unsupported" for a in answers[1:]]
        self.assertEqual(kinds, ["internal", "internal", "internal", "degenerate", "unsupported", "limit"])

    def test_stray_output_goes_to_stderr(self):
        question = json.dumps({"id": 1, "op": "wild.echo", "in": {"do": "fraction"}})
        run = subprocess.run([sys.executable, "-c", WILD], input=question, capture_output=True, text=True, cwd=HERE, timeout=60)
        self.assertEqual(len(run.stdout.splitlines()), 1)
        for stray in ("a stray print", "a stray write", "a stray child"):
            self.assertIn(stray, run.stderr)

    def test_each_line_is_answered_before_the_next_is_sent(self):
        with subprocess.Popen([sys.executable, "minimal.py"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, cwd=HERE) as process:
            for id in range(3):
                process.stdin.write(b'{"id":%d,"op":"hello","in":{}}\n' % id)
                process.stdin.flush()
                self.assertEqual(json.loads(process.stdout.readline())["id"], id)


class Numbers(unittest.TestCase):
    def test_every_form_is_exact(self):
        tenth = Fraction(0.1)
        forms = [(7, 7), (0.1, tenth), ("0.1", Fraction(1, 10)), ("-12", -12), ("+3/6", Fraction(1, 2)), ("-1/3", Fraction(-1, 3)),
                 ("1e-3", Fraction(1, 1000)), (".5", Fraction(1, 2)), ("5.", 5), ("0x1.8p-3", Fraction(3, 16)), ("-0X.8P1", -1),
                 ("0x10", 16), ("0x1.999999999999ap-4", tenth), ("0x1p-1074", Fraction(5e-324)), (10**40 + 1, 10**40 + 1),
                 ("0x1.00000000000000000001p0", 1 + Fraction(1, 16**20))]
        for form, value in forms:
            with self.subTest(form):
                self.assertEqual(number(form, "x"), value)

    def test_anything_else_is_invalid_input(self):
        for form in ["", " 1", "1_0", "nan", "inf", "-Infinity", "1/0", "1/-2", "1.5/2", "0x", "0x.p1", "0xp1", "\u0661", "1e", None, True,
                     [], {}, float("inf")]:
            with self.subTest(form), self.assertRaises(Fault) as raised:
                number(form, "x")
            self.assertEqual(raised.exception.kind, "invalid-input")

    def test_what_could_fill_the_memory_is_a_limit(self):
        for form in ["9" * 5000, "1e99999999", "0x1p-99999999", "1/" + "9" * 5000]:
            with self.subTest(form[:20]), self.assertRaises(Fault) as raised:
                number(form, "x")
            self.assertEqual(raised.exception.kind, "limit")

    def test_an_integer_too_long_is_a_limit_and_keeps_its_id(self):
        line = b'{"id":5,"op":"isosurface.mesh","in":{"volume":{"shape":[2,2,2],"values":[%s,1,1,1,1,1,1,1]},"isovalue":0}}' % (b"9" * 5000)
        [answer] = ask_lines(["minimal.py"], [line])
        self.assertEqual((answer["id"], answer["error"]["kind"]), (5, "limit"))


class Minimal(unittest.TestCase):
    def test_one_corner_is_cut_off_exactly(self):
        vertices, faces = mesh(["minimal.py"], {"shape": [2, 2, 2], "values": ["-1/2"] + [1] * 7}, 0)
        third = Fraction(1, 3)
        self.assertEqual(sorted(vertices), sorted([x * third, y * third, z * third] for x in (0, 1) for y in (0, 1) for z in (0, 1) if x + y + z))
        self.assertEqual(len(faces), 6)


if __name__ == "__main__":
    unittest.main()
