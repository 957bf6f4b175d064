using System.Text;

namespace Harvester.Play.Tapes;

/// <summary>Decodes the entries of chunks, in order. No count is believed that the bytes of the chunk cannot hold.</summary>
internal sealed class TapeDecoder
{
    private const int MaxReferences = 1 << 16;

    /// <summary>Most arguments, outputs and slots of a call: in memory, one takes more than its smallest encoding.</summary>
    private const int MaxListed = 1 << 16;

    private const int MaxNameBytes = 256;
    private readonly List<ulong> _targets = [];
    private readonly List<string> _works = [];
    private byte[] _bytes = [];
    private int _at;
    private long _lastClock;

    /// <summary>The entries of a chunk.</summary>
    /// <exception cref="InvalidDataException">The chunk is damaged.</exception>
    public IEnumerable<TapeEntry> EntriesOf(byte[] chunk)
    {
        (_bytes, _at) = (chunk, 0);
        while (_at < _bytes.Length)
        {
            yield return Entry();
        }
    }

    private TapeEntry Entry() =>
        (TapeTag)Byte() switch
        {
            TapeTag.Fact => new TapeFact(Text(), Text()),
            TapeTag.Tick => new TapeTick(),
            TapeTag.KeyUp => new TapeKey(Whole(), false),
            TapeTag.KeyDown => new TapeKey(Whole(), true),
            TapeTag.Call => Call(),
            TapeTag.Clock => new TapeClock(_lastClock = unchecked(_lastClock + Signed())),
            TapeTag.Grab => Grab(),
            TapeTag.Work => new TapeWork(Reference(_works, Name), Boolean()),
            TapeTag.End => new TapeEnd(Text()),
            _ => throw Damaged("an unknown entry"),
        };

    private TapeCall Call()
    {
        ulong target = Reference(_targets, () => Fixed(sizeof(ulong)));
        var asked = new TapeValue[Listed(1)];
        for (int i = 0; i < asked.Length; i++)
        {
            asked[i] = Value();
        }

        TapeValue answer = Value();
        var written = new int[Listed(1)][];
        for (int i = 0; i < written.Length; i++)
        {
            written[i] = new int[Listed(sizeof(int))];
            for (int slot = 0; slot < written[i].Length; slot++)
            {
                written[i][slot] = unchecked((int)Fixed(sizeof(int)));
            }
        }

        return new TapeCall(target, asked, answer, written);
    }

    private TapeGrab Grab()
    {
        (int width, int height) = (Whole(), Whole());
        TapeValue refusal = Value();
        ulong fingerprint = Fixed(sizeof(ulong));
        int length = Count(1);
        if (length != 0 && length != 3L * width * height)
        {
            throw Damaged("a picture of another size");
        }

        byte[]? pixels = length == 0 ? null : new byte[length];
        if (pixels is not null)
        {
            Array.Copy(_bytes, _at, pixels, 0, length);
            _at += length;
        }

        return new TapeGrab(width, height, refusal.Text, fingerprint, pixels);
    }

    private TapeValue Value()
    {
        var kind = (TapeValueKind)Byte();
        return kind switch
        {
            TapeValueKind.Whole => TapeValue.Of(Narrow(Signed())),
            TapeValueKind.Memory => TapeValue.Memory(Narrow(Signed())),
            TapeValueKind.Real => TapeValue.Of(Single()),
            TapeValueKind.Vector => TapeValue.Of(Single(), Single(), Single()),
            TapeValueKind.Text => TapeValue.Of(Text()),
            _ when kind > TapeValueKind.Failure => throw Damaged("an unknown value"),
            _ => new TapeValue(kind, 0, 0, 0, 0, null),
        };
    }

    private T Reference<T>(List<T> known, Func<T> read)
    {
        int number = Whole();
        if (number > known.Count || number >= MaxReferences)
        {
            throw Damaged("an unknown reference");
        }

        if (number == known.Count)
        {
            known.Add(read());
        }

        return known[number];
    }

    private float Single()
    {
        Need(sizeof(float));
        float value = BitConverter.ToSingle(_bytes, _at);
        _at += sizeof(float);
        return value;
    }

    private string Text()
    {
        int length = Count(1);
        string text = Encoding.UTF8.GetString(_bytes, _at, length);
        _at += length;
        return text;
    }

    private string Name()
    {
        int start = _at;
        string name = Text();
        return _at - start <= MaxNameBytes ? name : throw Damaged("a name that is too long");
    }

    private int Listed(int bytesOfEach)
    {
        int count = Count(bytesOfEach);
        return count <= MaxListed ? count : throw Damaged("a list that is too long");
    }

    /// <summary>A count of things that take at least some bytes each.</summary>
    private int Count(int bytesOfEach)
    {
        int count = Whole();
        Need((long)count * bytesOfEach);
        return count;
    }

    private bool Boolean() =>
        Whole() switch
        {
            0 => false,
            1 => true,
            _ => throw Damaged("a boolean that is neither 0 nor 1"),
        };

    private int Whole()
    {
        ulong value = Number();
        return value <= int.MaxValue ? (int)value : throw Damaged("a number out of range");
    }

    private static int Narrow(long value) =>
        value is >= int.MinValue and <= int.MaxValue ? (int)value : throw Damaged("a number out of range");

    private long Signed()
    {
        ulong value = Number();
        return (long)(value >> 1) ^ -(long)(value & 1);
    }

    private ulong Number()
    {
        ulong value = 0;
        for (int shift = 0; shift < 64; shift += 7)
        {
            byte next = Byte();
            value |= (ulong)(next & 0x7F) << shift;
            if (next < 0x80)
            {
                return value;
            }
        }

        throw Damaged("a number out of range");
    }

    private ulong Fixed(int bytes)
    {
        Need(bytes);
        ulong value = 0;
        for (int i = bytes - 1; i >= 0; i--)
        {
            value = (value << 8) | _bytes[_at + i];
        }

        _at += bytes;
        return value;
    }

    private byte Byte()
    {
        Need(1);
        return _bytes[_at++];
    }

    private void Need(long bytes)
    {
        if (bytes > _bytes.Length - _at)
        {
            throw Damaged("an entry that is cut off");
        }
    }

    private static InvalidDataException Damaged(string what) => new($"it is damaged: it has {what}.");
}
