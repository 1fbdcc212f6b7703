# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Images, printed IR, disassembly and places in a source."""

import struct
import unittest
import zlib

from tp_bisect.image import ImageError, describe_difference, read_image
from tp_bisect.ir import Module, read_dumps, changes, trimmed_diff
from tp_bisect.mending import body_begin, insert_pragmas
from tp_bisect.oracle import _compare_bytes


def png(width, rows, filters):
    """A PNG of 8-bit RGB whose rows are filtered already."""

    def chunk(kind, body):
        data = kind + body
        return (
            struct.pack(">I", len(body)) + data + struct.pack(">I", zlib.crc32(data))
        )

    header = struct.pack(">IIBBBBB", width, len(rows), 8, 2, 0, 0, 0)
    packed = zlib.compress(
        b"".join(bytes([kind]) + row for kind, row in zip(filters, rows))
    )
    return (
        b"\x89PNG\r\n\x1a\n"
        + chunk(b"IHDR", header)
        + chunk(b"IDAT", packed)
        + chunk(b"IEND", b"")
    )


class Images(unittest.TestCase):
    def test_filters(self):
        # The same two pixels a row, by each filter.
        rows = [
            bytes([1, 2, 3, 4, 5, 6]),
            bytes([1, 2, 3, 3, 3, 3]),
            bytes([0] * 6),
            bytes([1, 1, 2, 2, 2, 2]),
            bytes([0, 0, 0, 0, 0, 0]),
        ]
        image = read_image(png(2, rows, [0, 1, 2, 3, 4]))
        self.assertEqual(image.samples, bytes([1, 2, 3, 4, 5, 6]) * 5)

    def test_netpbm(self):
        image = read_image(b"P6 # words\n2 1\n255\n" + bytes(range(6)))
        self.assertEqual((image.width, image.samples), (2, bytes(range(6))))

    def test_difference(self):
        a = read_image(b"P5\n3 1\n255\n" + bytes([10, 20, 30]))
        b = read_image(b"P5\n3 1\n255\n" + bytes([11, 25, 30]))
        self.assertEqual(
            describe_difference(a, b, 1), "1 samples differ, by 5 at pixel (1, 0)"
        )
        self.assertIsNone(describe_difference(a, b, 5))

    def test_damage(self):
        with self.assertRaises(ImageError):
            read_image(png(2, [b"123456"], [0])[:40])
        self.assertIsNone(read_image(b"text"))

    def test_bytes(self):
        text = _compare_bytes(struct.pack("<2f", 1, 2), struct.pack("<2f", 1, 3))
        self.assertEqual(
            text, "the word at byte 4 is 0x40400000 (3) instead of 0x40000000 (2)"
        )


DUMPS = """\
; *** IR Dump Before 7-LICMPass on loop %l in function f ***
source_filename = "dir/a.cpp"
define float @f(float %x) !dbg !3 {
  %0 = load ptr, ptr %p, align 8, !tbaa !9
  %q = fdiv arcp float %x, %y, !dbg !5
}
!1 = !DIFile(filename: "dir/a.cpp", directory: "/d")
!3 = distinct !DISubprogram(name: "f", file: !1, line: 2)
!4 = distinct !DILocation(line: 30, column: 4, scope: !3)
!5 = !DILocation(line: 3, column: 7, scope: !6, inlinedAt: !4)
!6 = distinct !DILexicalBlock(scope: !3, file: !1, line: 3)
; *** IR Dump After 7-LICMPass on loop %l in function f ***
source_filename = "dir/a.cpp"
define float @f(float %x) !dbg !3 {
  %1 = load ptr, ptr %p, align 8, !tbaa !9
  %q = fmul arcp float %x, %r
}
; *** IR Dump Before 7-GonePass on f ***
define float @g() {
}
; *** IR Dump After 7-GonePass on f invalidated: ***
"""


class Ir(unittest.TestCase):
    def test_change_with_its_place(self):
        first, second = read_dumps(DUMPS)
        (change,) = changes(first, 2, 10)
        self.assertEqual(first.before.source, "dir/a.cpp")
        self.assertEqual(
            list(change.diff),
            [
                "   %0 = load ptr, ptr %p, align 8",
                "-  %q = fdiv arcp float %x, %y  ; a.cpp:3:7 <- a.cpp:30:4",
                "+  %q = fmul arcp float %x, %r",
            ],
        )
        self.assertEqual(changes(second, 2, 10), [])

    def test_long_diff_is_cut(self):
        diff = trimmed_diff([], [f"line{c}" for c in "abcdef"], 2, 4)
        self.assertEqual(len(diff), 5)
        self.assertEqual(diff[-1], "... 2 more lines")

    def test_quoted_name(self):
        module = Module.parse('define void @"a b"() {\n  ret void\n}\n')
        self.assertEqual(module.functions, {"a b": ["  ret void"]})


SOURCE = """\
float g(float);
// {
float f(float a, // (
        float b = g({1})) {
  return a / b;
}
struct S { int i; };
"""


class Mending(unittest.TestCase):
    def test_body(self):
        place = body_begin(SOURCE, 3)
        self.assertEqual(SOURCE[place:].strip().splitlines()[0], "return a / b;")

    def test_declaration_has_none(self):
        self.assertIsNone(body_begin(SOURCE, 1))
        self.assertIsNone(body_begin(SOURCE, 99))

    def test_pragma(self):
        mended = insert_pragmas(SOURCE, [3], ["#pragma x"]).splitlines()
        self.assertEqual(mended[3:6], [SOURCE.splitlines()[3], "#pragma x", ""])


if __name__ == "__main__":
    unittest.main()
