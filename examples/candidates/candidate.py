"""The candidate's side of the protocol (version 1), in stdlib Python: one loop that adapters share.

    from candidate import serve
    serve("mine", "1.0", {"isosurface.mesh": mesh})

`serve` reads a question a line from stdin, hands it to the function of its operation and writes the answer
a line to stdout until the input ends. For the operations on a volume the function takes a `Volume`, for any
other the question's `in` as it came. It returns the answer's `out`: Fractions and numpy arrays may stand in
it. To decline it raises `Unsupported`, to find fault with the question `Fault`; any other exception is
answered as `internal`, with the traceback on stderr.
"""
import json
import os
import re
import sys
import traceback
from dataclasses import dataclass
from fractions import Fraction

PROTOCOL = 1
DIGITS = 4000  # of a number's text and of its exponent; every binary64 written out in full stays far below


class Fault(Exception):
    """An `error` answer. kind: malformed, invalid-input, degenerate, limit or internal."""

    def __init__(self, kind, message):
        super().__init__(message)
        self.kind = kind


class Unsupported(Exception):
    """An `unsupported` answer."""


@dataclass(frozen=True)
class Volume:
    """Grid point (i,j,k) has the value values[i + nx·(j + ny·k)]; the surface is where the value is isovalue."""

    shape: tuple
    values: list
    isovalue: Fraction

    def floats(self):
        """The values as their nearest doubles, x fastest."""
        return [nearest_double(v, "volume.values") for v in self.values]

    def level(self):
        """The isovalue as its nearest double."""
        return nearest_double(self.isovalue, "isovalue")


def serve(name, version, operations):
    """Answers questions until the input ends. What anything else prints to stdout goes to stderr."""
    sys.set_int_max_str_digits(0)
    sys.stdout.flush()
    with os.fdopen(os.dup(1), "w", encoding="utf-8", newline="\n") as out:
        os.dup2(2, 1)
        sys.stdout = sys.stderr
        hello = {"protocol": PROTOCOL, "name": name, "version": version, "ops": sorted(operations)}
        for line in sys.stdin.buffer:
            out.write(answer(line, hello, operations) + "\n")
            out.flush()


def answer(line, hello, operations):
    """The answer to one line, as a line."""
    id = None
    try:
        message = parse(line)
        id = message["id"]
        return dump({"id": id, "out": reply(message["op"], message.get("in"), hello, operations)})
    except Unsupported as why:
        return dump({"id": id, "unsupported": str(why)})
    except Fault as fault:
        return dump({"id": id, "error": {"kind": fault.kind, "message": str(fault)}})
    except MemoryError:
        return dump({"id": id, "error": {"kind": "limit", "message": "out of memory"}})
    except (Exception, SystemExit) as bug:
        traceback.print_exc()
        return dump({"id": id, "error": {"kind": "internal", "message": f"{type(bug).__name__}: {bug}"}})


def parse(line):
    """The message of a line: an object with an `id` that can be echoed and an `op`."""
    try:
        # NaN and Infinity are Python's, not JSON's.
        message = json.loads(line.decode("utf-8"), parse_constant=not_json, parse_int=integer)
    except RecursionError:
        raise Fault("malformed", "nested too deeply")
    except ValueError as why:
        raise Fault("malformed", f"not JSON: {why}")
    if not isinstance(message, dict) or "id" not in message or not isinstance(message.get("op"), str):
        raise Fault("malformed", "a message is an object with an id and an op")
    try:
        dump(message["id"])
    except (TypeError, ValueError):
        raise Fault("malformed", "id: too large a number to echo")
    return message


def not_json(word):
    raise ValueError(f"{word} is not JSON")


def integer(text):
    """A JSON integer; for one that is too long to read a LongInteger, which `number` refuses."""
    return int(text) if len(text) <= DIGITS else LongInteger()


class LongInteger:
    """Stands for an integer of more than DIGITS digits."""


def dump(message):
    return json.dumps(message, default=plain, allow_nan=False)


def plain(value):
    """A Fraction as "p/q"; a numpy array or scalar as lists and numbers."""
    if isinstance(value, Fraction):
        return str(value)
    if hasattr(value, "tolist"):
        return value.tolist()
    raise TypeError(f"{type(value).__name__} in an answer")


def reply(op, question, hello, operations):
    if op != "hello" and op not in operations:
        raise Unsupported(f"no operation {op}")
    if not isinstance(question, dict):
        raise Fault("invalid-input", "in: an object is wanted")
    if op == "hello":
        if question.get("protocol", PROTOCOL) != PROTOCOL:
            raise Unsupported(f"protocol: version {PROTOCOL} alone is spoken here")
        return hello
    return operations[op](volume(question) if op in ON_VOLUMES else question)


ON_VOLUMES = {"isosurface.mesh", "isosurface.tetrahedra", "isosurface.topology"}


def volume(question):
    """The volume of {volume, isovalue}; a sample on the isovalue is `degenerate` but with "tie":"below"."""
    record = question.get("volume")
    if not isinstance(record, dict):
        raise Fault("invalid-input", "volume: an object is wanted")
    if "file" in record:
        raise Unsupported("volume.file: only volumes with values are read here")
    shape, values = record.get("shape"), record.get("values")
    if not (isinstance(shape, list) and len(shape) == 3 and all(type(n) is int and n >= 2 for n in shape)):
        raise Fault("invalid-input", "volume.shape: three integers of at least 2 are wanted")
    points = shape[0] * shape[1] * shape[2]
    if not isinstance(values, list) or len(values) != points:
        raise Fault("invalid-input", f"volume.values: a list of {points} numbers is wanted")
    values = [number(v, f"volume.values[{n}]") for n, v in enumerate(values)]
    isovalue = number(question.get("isovalue"), "isovalue")
    # With "tie":"below" the library answers as it will: whichever side it takes, it has to take one throughout.
    if isovalue in values and question.get("tie") != "below":
        raise Fault("degenerate", f"volume.values[{values.index(isovalue)}] equals the isovalue")
    return Volume(tuple(shape), values, isovalue)


RATIO = re.compile(r"[+-]?[0-9]+/[0-9]+")
DECIMAL = re.compile(r"[+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE]([+-]?[0-9]+))?")
HEX = re.compile(r"([+-]?)0[xX]([0-9a-fA-F]*)\.?([0-9a-fA-F]*)(?:[pP]([+-]?[0-9]+))?")


def number(value, field):
    """The exact value of a number: 12, 0.1 (its double), "p/q", "0.1" (itself), "0x1.8p-3"."""
    if isinstance(value, LongInteger):
        raise Fault("limit", f"{field}: more than {DIGITS} digits")
    if type(value) is int:
        return Fraction(value)
    if type(value) is float:
        if abs(value) == float("inf"):
            raise Fault("invalid-input", f"{field}: beyond the range of binary64")
        return Fraction(value)
    if not isinstance(value, str):
        raise Fault("invalid-input", f"{field}: a number is wanted")
    if len(value) > DIGITS:
        raise Fault("limit", f"{field}: more than {DIGITS} digits")
    if RATIO.fullmatch(value):
        if int(value.split("/")[1]) == 0:
            raise Fault("invalid-input", f"{field}: the denominator is 0")
        return Fraction(value)
    if match := DECIMAL.fullmatch(value):
        within(match[1], field)
        return Fraction(value)
    match = HEX.fullmatch(value)
    if match and (match[2] or match[3]):
        sign, whole, part, _ = match.groups()
        magnitude = int(whole + part, 16) * Fraction(2) ** (within(match[4], field) - 4 * len(part))
        return -magnitude if sign == "-" else magnitude
    raise Fault("invalid-input", f"{field}: {value[:40]} is not a number here")


def within(exponent, field):
    """An exponent's text as an integer; none is 0."""
    exponent = int(exponent or 0)
    if abs(exponent) > DIGITS:
        raise Fault("limit", f"{field}: the exponent is beyond {DIGITS}")
    return exponent


def nearest_double(value, field):
    try:
        return float(value)
    except OverflowError:
        raise Fault("limit", f"{field}: beyond the range of binary64")
