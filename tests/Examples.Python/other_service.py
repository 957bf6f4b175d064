"""A service that is no bridge: other_service.py ANSWER prints its port, gives the answer to the first who connects, and ends."""
import socket
import sys

with socket.create_server(("127.0.0.1", 0)) as listener:
    listener.settimeout(60)
    print(listener.getsockname()[1], flush=True)
    connection, _ = listener.accept()
    with connection:
        connection.recv(4096)
        connection.sendall(sys.argv[1].encode().decode("unicode_escape").encode("latin-1"))
