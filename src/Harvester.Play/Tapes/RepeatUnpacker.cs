namespace Harvester.Play.Tapes;

/// <summary>Restores chunks of a <see cref="RepeatPacker"/>, in order.</summary>
internal sealed class RepeatUnpacker
{
    private readonly RepeatWindow _window = new();

    /// <summary>Reads a chunk.</summary>
    /// <param name="source">What was written.</param>
    /// <param name="length">Length of the chunk, bytes.</param>
    /// <exception cref="InvalidDataException">The data is damaged.</exception>
    public byte[] Unpack(Stream source, int length)
    {
        _window.MakeRoom(length);
        int start = _window.End;
        int end = start + length;
        while (_window.End < end)
        {
            Copy(source, Number(source, end - _window.End));
            if (_window.End < end)
            {
                int repeated = Number(source, end - _window.End - RepeatWindow.MinLength) + RepeatWindow.MinLength;
                Repeat(Number(source, _window.End), repeated);
            }
        }

        byte[] chunk = new byte[length];
        Buffer.BlockCopy(_window.Bytes, start, chunk, 0, length);
        return chunk;
    }

    private void Copy(Stream source, int length)
    {
        for (int end = _window.End + length; _window.End < end; )
        {
            int read = source.Read(_window.Bytes, _window.End, end - _window.End);
            _window.End += read > 0 ? read : throw new InvalidDataException();
        }
    }

    /// <summary>The part may overlap the place it is copied to: it then repeats itself.</summary>
    private void Repeat(int distance, int length)
    {
        if (distance == 0)
        {
            throw new InvalidDataException();
        }

        byte[] bytes = _window.Bytes;
        for (int end = _window.End + length; _window.End < end; _window.End++)
        {
            bytes[_window.End] = bytes[_window.End - distance];
        }
    }

    private static int Number(Stream source, int most)
    {
        long value = 0;
        for (int shift = 0; shift < 35; shift += 7)
        {
            int next = source.ReadByte();
            if (next < 0)
            {
                break;
            }

            value |= (long)(next & 0x7F) << shift;
            if (next < 0x80)
            {
                return value <= most ? (int)value : throw new InvalidDataException();
            }
        }

        throw new InvalidDataException();
    }
}
