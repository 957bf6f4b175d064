using System.Text;

namespace Harvester.Driving.Bridge;

/// <summary>A message on the socket: two lengths of four bytes each (big-endian), then the header (UTF-8), then the payload.</summary>
internal static class SocketFraming
{
    /// <summary>Maximum length of a header that is read, bytes.</summary>
    public const int MaxHeaderLength = 65_536;

    private const int LengthBytes = 8;

    /// <summary>Writes a message: lengths, header, payload.</summary>
    /// <exception cref="IOException">The connection is broken.</exception>
    public static void Write(Stream stream, byte[] header, ArraySegment<byte> payload)
    {
        byte[] lengths = new byte[LengthBytes];
        PutInt(lengths, 0, header.Length);
        PutInt(lengths, 4, payload.Count);
        stream.Write(lengths, 0, lengths.Length);
        stream.Write(header, 0, header.Length);
        if (payload.Count > 0)
        {
            stream.Write(payload.Array!, payload.Offset, payload.Count);
        }

        stream.Flush();
    }

    /// <summary>Reads a client's header; clients send no payload.</summary>
    /// <returns>Null at the end of the stream.</returns>
    /// <exception cref="BridgeException">The header is too long, or there is a payload.</exception>
    /// <exception cref="IOException">The stream ends within the header.</exception>
    public static string? ReadHeader(Stream stream)
    {
        byte[] lengths = new byte[LengthBytes];
        int first = stream.Read(lengths, 0, 1);
        if (first == 0)
        {
            return null;
        }

        Fill(stream, lengths, 1);
        int headerLength = GetInt(lengths, 0);
        int payloadLength = GetInt(lengths, 4);
        if (headerLength is < 2 or > MaxHeaderLength || payloadLength != 0)
        {
            throw new BridgeException(
                FormattableString.Invariant(
                    $"a message has a header of {headerLength} and a payload of {payloadLength} bytes; 2 to {MaxHeaderLength}"
                ) + " and 0 are allowed."
            );
        }

        byte[] header = new byte[headerLength];
        Fill(stream, header, 0);
        return Encoding.UTF8.GetString(header);
    }

    private static void Fill(Stream stream, byte[] buffer, int from)
    {
        while (from < buffer.Length)
        {
            int read = stream.Read(buffer, from, buffer.Length - from);
            if (read == 0)
            {
                throw new EndOfStreamException("The client disconnected in the middle of a message.");
            }

            from += read;
        }
    }

    private static void PutInt(byte[] buffer, int at, int value)
    {
        buffer[at] = (byte)(value >> 24);
        buffer[at + 1] = (byte)(value >> 16);
        buffer[at + 2] = (byte)(value >> 8);
        buffer[at + 3] = (byte)value;
    }

    private static int GetInt(byte[] buffer, int at) =>
        (buffer[at] << 24) | (buffer[at + 1] << 16) | (buffer[at + 2] << 8) | buffer[at + 3];
}
