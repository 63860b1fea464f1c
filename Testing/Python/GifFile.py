# SPDX-FileCopyrightText: Copyright (c) The Relevo developers
# SPDX-License-Identifier: BSD-3-Clause
"""Reads animated GIF files (GIF89a with one palette) by the standard."""

import struct


class GifFile:
    """Contents of a file: size; palette as bytes of red, green and blue; frames as bytes of
    indices, top row first; delays in seconds; repetitions, 0 for endless."""

    def __init__(self, path):
        self.data = path.read_bytes()
        assert self.data[:6] == b"GIF89a" and self.data[-1:] == b"\x3b"
        width, height, flags = struct.unpack("<HHB", self.data[6:11])
        self.size = (width, height)
        self.place = 13
        self.palette = [self.take(3) for _ in range(2 << (flags & 7))]
        self.frames, self.delays, self.repetitions = [], [], None
        while True:
            kind = self.take(1)
            if kind == b"\x3b":
                break
            self.read_extension() if kind == b"\x21" else self.read_image()
        assert self.place == len(self.data)

    def take(self, count):
        self.place += count
        return self.data[self.place - count : self.place]

    def take_blocks(self):
        blocks = []
        while size := self.take(1)[0]:
            blocks.append(self.take(size))
        return blocks

    def read_extension(self):
        label = self.take(1)
        blocks = self.take_blocks()
        if label == b"\xf9":
            self.delays.append(struct.unpack("<H", blocks[0][1:3])[0] / 100)
        if blocks[0] == b"NETSCAPE2.0":
            self.repetitions = struct.unpack("<H", blocks[1][1:3])[0]

    def read_image(self):
        assert self.take(9) == struct.pack("<HHHHB", 0, 0, *self.size, 0)
        bits = self.take(1)[0]
        code = int.from_bytes(b"".join(self.take_blocks()), "little")
        clear, words, length, last, pixels = 1 << bits, [], bits + 1, None, bytearray()
        stream = bin(code)[:1:-1]  # the first bit comes first
        place = 0
        while True:
            number = int(stream[place : place + length][::-1] or "0", 2)
            place += length
            if number == clear:
                words = [bytes([i]) for i in range(clear)] + [None, None]
                length, last = bits + 1, None
                continue
            if number == clear + 1:
                break
            word = words[number] if number < len(words) else last + last[:1]
            pixels += word
            if last is not None and len(words) < 4096:
                words.append(last + word[:1])
            if len(words) == 1 << length and length < 12:
                length += 1
            last = word
        assert len(pixels) == self.size[0] * self.size[1]
        self.frames.append(bytes(pixels))
