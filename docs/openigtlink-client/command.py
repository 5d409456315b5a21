"""Sends a command and prints the answer: python3 command.py HOST PORT '<Command Name="Freeze"/>'. Needs nothing but Python 3."""
import socket
import struct
import sys


def crc64(data):  # ECMA-182
    crc = 0
    for byte in data:
        crc ^= byte << 56
        for _ in range(8):
            crc = (crc << 1) ^ 0x42F0E1EBA9EA3693 if crc >> 63 else crc << 1
            crc &= 0xFFFFFFFFFFFFFFFF
    return crc


host, port, command = sys.argv[1], int(sys.argv[2]), sys.argv[3].encode()
connection = socket.create_connection((host, port))
body = struct.pack(">HH", 3, len(command)) + command  # 3: ASCII
connection.sendall(struct.pack(">H12s20sIIQQ", 1, b"STRING", b"CMD_1", 0, 0, len(body), crc64(body)) + body)
server = connection.makefile("rb")
while True:
    header = server.read(58)
    if len(header) < 58:
        sys.exit("the server has ended the connection")
    version, kind, device, seconds, fraction, size, crc = struct.unpack(">H12s20sIIQQ", header)
    body = server.read(size)
    if device.rstrip(b"\0") in (b"ACK_1", b"ModelParameters"):
        print(body[4:].decode())
    if device.rstrip(b"\0") == b"ACK_1":
        break
