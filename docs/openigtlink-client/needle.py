"""Prints where the needle's tip is, RAS mm: python3 needle.py [HOST [PORT [HOW_MANY]]]. Needs nothing but Python 3."""
import socket
import struct
import sys

host = sys.argv[1] if len(sys.argv) > 1 else "localhost"
port = int(sys.argv[2]) if len(sys.argv) > 2 else 18944
wanted = int(sys.argv[3]) if len(sys.argv) > 3 else -1
server = socket.create_connection((host, port)).makefile("rb")
while wanted != 0:
    header = server.read(58)
    if len(header) < 58:
        sys.exit("the server has ended the connection")
    version, kind, device, seconds, fraction, size, crc = struct.unpack(">H12s20sIIQQ", header)
    body = server.read(size)
    if kind.rstrip(b"\0") == b"TRANSFORM" and device.rstrip(b"\0") == b"NeedleTipToReference":
        matrix = struct.unpack(">12f", body)  # three columns of the rotation, then the tip
        print("%.2f %.2f %.2f" % matrix[9:12], flush=True)
        wanted -= 1
