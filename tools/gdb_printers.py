"""Shows the twin's values in gdb as GLSL has them.

    gdb -x tools/gdb_printers.py ...        or, in gdb: source tools/gdb_printers.py

A vector is (x, y, z). A packet, which holds a value for each of eight pixels side by side, is [a b c d | e f g h]: two
squares of 2x2 pixels. A mask shows 1 for the pixels that take part.
"""

import re

import gdb

VECTOR = re.compile(r"^glm::vec<(\d)")
PACKET = re.compile(r"^shadertwin::glsl::packet::(Packet<|Bool$)")
LANES = 8


def plain(value):
    while value.type.code in (gdb.TYPE_CODE_REF, gdb.TYPE_CODE_RVALUE_REF):
        value = value.referenced_value()
    return value


class Vector:
    def __init__(self, value, size):
        self.value, self.size = value, size

    def to_string(self):
        return "(" + ", ".join(str(self.value[name]) for name in "xyzw"[: self.size]) + ")"


class Packet:
    def __init__(self, value):
        self.value = value

    def to_string(self):
        lanes = [self.value["v"][i] for i in range(LANES)]
        if self.value.type.strip_typedefs().name.endswith("::Bool"):
            lanes = [int(lane) & 1 for lane in lanes]
        half = LANES // 2
        return "[" + " ".join(map(str, lanes[:half])) + " | " + " ".join(map(str, lanes[half:])) + "]"


def printer(value):
    value = plain(value)
    name = value.type.strip_typedefs().name or ""
    vector = VECTOR.match(name)
    if vector:
        return Vector(value, int(vector.group(1)))
    return Packet(value) if PACKET.match(name) else None


gdb.pretty_printers.append(printer)
