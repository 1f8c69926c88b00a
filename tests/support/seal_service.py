# SPDX-FileCopyrightText: 2026 The Dyncal authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A seal service for tests: reads the hexadecimal SHA-256 of a document from standard input and
writes a detached CMS over it, put together here by hand (RFC 5652) with openssl for the RSA
signature only.  seal_service.py KEY.pem CERTIFICATE.pem"""
import hashlib
import subprocess
import sys


def der(tag, *parts):
    content = b"".join(parts)
    size = len(content)
    if size < 0x80:
        return bytes([tag, size]) + content
    length = size.to_bytes((size.bit_length() + 7) // 8, "big")
    return bytes([tag, 0x80 | len(length)]) + length + content


def oid(text):
    numbers = [int(part) for part in text.split(".")]
    out = bytearray([numbers[0] * 40 + numbers[1]])
    for number in numbers[2:]:
        digits = [number & 0x7F]
        while number > 0x7F:
            number >>= 7
            digits.append(number & 0x7F | 0x80)
        out += bytes(reversed(digits))
    return der(0x06, bytes(out))


def field(data, place):
    """Begin of content and end of the value at this place."""
    length, begin = data[place + 1], place + 2
    if length & 0x80:
        count = length & 0x7F
        length, begin = int.from_bytes(data[begin:begin + count], "big"), begin + count
    return begin, begin + length


def serial_and_issuer(certificate):
    place = field(certificate, field(certificate, 0)[0])[0]
    fields = []
    while len(fields) < 4:
        end = field(certificate, place)[1]
        fields.append(certificate[place:end])
        place = end
    return fields[1], fields[3]  # version, serial, algorithm, issuer


DATA, SIGNED = oid("1.2.840.113549.1.7.1"), oid("1.2.840.113549.1.7.2")
SHA256 = der(0x30, oid("2.16.840.1.101.3.4.2.1"))
RSA = der(0x30, oid("1.2.840.113549.1.1.1"), der(0x05))
ONE = der(0x02, b"\1")

key, certificate_file = sys.argv[1:3]
digest = bytes.fromhex(sys.stdin.readline().strip())
assert len(digest) == 32
certificate = subprocess.run(["openssl", "x509", "-in", certificate_file, "-outform", "DER"],
                             check=True, capture_output=True).stdout
meant = der(0x30, der(0x30, der(0x30, der(0x04, hashlib.sha256(certificate).digest()))))
attributes = sorted([
    der(0x30, oid("1.2.840.113549.1.9.3"), der(0x31, DATA)),
    der(0x30, oid("1.2.840.113549.1.9.4"), der(0x31, der(0x04, digest))),
    der(0x30, oid("1.2.840.113549.1.9.16.2.47"), der(0x31, meant))])
signature = subprocess.run(["openssl", "dgst", "-sha256", "-sign", key], check=True,
                           capture_output=True, input=der(0x31, *attributes)).stdout
serial, issuer = serial_and_issuer(certificate)
signer = der(0x30, ONE, der(0x30, issuer, serial), SHA256, der(0xA0, *attributes), RSA,
             der(0x04, signature))
sys.stdout.buffer.write(der(0x30, SIGNED, der(0xA0, der(
    0x30, ONE, der(0x31, SHA256), der(0x30, DATA), der(0xA0, certificate), der(0x31, signer)))))
