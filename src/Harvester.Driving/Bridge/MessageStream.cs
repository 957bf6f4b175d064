using System.Text;

namespace Harvester.Driving.Bridge;

/// <summary>
/// Messages on a socket: two lengths of four bytes each (big-endian), then the header (UTF-8), then the payload. One thread reads; any may
/// write.
/// </summary>
/// <param name="stream">The connection.</param>
internal sealed class MessageStream(Stream stream)
{
    /// <summary>Maximum length of a header that is read, bytes.</summary>
    public const int MaxHeaderLength = 65_536;

    private const int LengthBytes = 8;
    private readonly object _writing = new();

    /// <summary>Writes a message.</summary>
    /// <returns>Why the other side did not receive it; null if it was written.</returns>
    public string? FaultOfWriting(byte[] header, ArraySegment<byte> payload)
    {
        byte[] lengths = new byte[LengthBytes];
        PutInt(lengths, 0, header.Length);
        PutInt(lengths, 4, payload.Count);
        try
        {
            lock (_writing)
            {
                stream.Write(lengths, 0, lengths.Length);
                stream.Write(header, 0, header.Length);
                if (payload.Count > 0)
                {
                    stream.Write(payload.Array!, payload.Offset, payload.Count);
                }

                stream.Flush();
            }

            return null;
        }
#pragma warning disable CA1031 // An exception that leaves a thread ends the game, whatever its type.
        catch (Exception e) when (e is not ThreadAbortException)
#pragma warning restore CA1031
        {
            return e.Message;
        }
    }

    /// <summary>Reads a client's header; clients send no payload.</summary>
    /// <returns>Null at the end of the stream.</returns>
    /// <exception cref="BridgeException">The header is too long, or there is a payload.</exception>
    /// <exception cref="IOException">The stream ends within the header.</exception>
    public string? ReadHeader()
    {
        byte[] lengths = new byte[LengthBytes];
        int first = stream.Read(lengths, 0, 1);
        if (first == 0)
        {
            return null;
        }

        Fill(lengths, 1);
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
        Fill(header, 0);
        return Encoding.UTF8.GetString(header);
    }

    private void Fill(byte[] buffer, int from)
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
