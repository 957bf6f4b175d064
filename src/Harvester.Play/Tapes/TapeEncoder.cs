using System.Text;

namespace Harvester.Play.Tapes;

/// <summary>Encodes entries into memory. Names and targets are written once and then referred to by their number.</summary>
public sealed class TapeEncoder
{
    private readonly Dictionary<ulong, int> _targets = [];
    private readonly Dictionary<string, int> _works = new(StringComparer.Ordinal);
    private readonly List<byte> _bytes = [];
    private long _lastClock;

    /// <summary>Bytes encoded and not taken.</summary>
    public int Length => _bytes.Count;

    /// <summary>Takes the bytes encoded so far.</summary>
    public byte[] Take()
    {
        byte[] taken = _bytes.ToArray();
        _bytes.Clear();
        return taken;
    }

    /// <summary>Encodes an entry.</summary>
    public void Add(TapeEntry entry)
    {
        switch (entry)
        {
            case TapeFact fact:
                Tag(TapeTag.Fact);
                Text(fact.Name);
                Text(fact.Text);
                break;
            case TapeTick:
                Tag(TapeTag.Tick);
                break;
            case TapeKey key:
                Tag(key.IsDown ? TapeTag.KeyDown : TapeTag.KeyUp);
                Number((uint)key.Key);
                break;
            case TapeCall call:
                Call(call);
                break;
            case TapeClock clock:
                Tag(TapeTag.Clock);
                Signed(clock.Steps - _lastClock);
                _lastClock = clock.Steps;
                break;
            case TapeGrab grab:
                Grab(grab);
                break;
            case TapeWork work:
                Work(work);
                break;
            case TapeEnd end:
                Tag(TapeTag.End);
                Text(end.Reason);
                break;
            default:
                throw new ArgumentException("A tape has no such entry.", nameof(entry));
        }
    }

    private void Call(TapeCall call)
    {
        Tag(TapeTag.Call);
        if (IsNew(_targets, call.Target))
        {
            Fixed(call.Target, sizeof(ulong));
        }

        Number((uint)call.Asked.Count);
        foreach (TapeValue asked in call.Asked)
        {
            Value(asked);
        }

        Value(call.Answer);
        Number((uint)call.Written.Count);
        foreach (IReadOnlyList<int> slots in call.Written)
        {
            Number((uint)slots.Count);
            foreach (int slot in slots)
            {
                Fixed((uint)slot, sizeof(int));
            }
        }
    }

    private void Grab(TapeGrab grab)
    {
        byte[] pixels = grab.Pixels ?? [];
        Tag(TapeTag.Grab);
        Number((uint)grab.Width);
        Number((uint)grab.Height);
        Value(TapeValue.Of(grab.Refusal));
        Fixed(grab.Fingerprint, sizeof(ulong));
        Number((uint)pixels.Length);
        _bytes.AddRange(pixels);
    }

    private void Work(TapeWork work)
    {
        Tag(TapeTag.Work);
        if (IsNew(_works, work.What))
        {
            Text(work.What);
        }

        Number(work.IsDone ? 1u : 0u);
    }

    private void Tag(TapeTag tag) => _bytes.Add((byte)tag);

    /// <summary>Writes the number of a key; returns whether it is new, so that the key must follow.</summary>
    private bool IsNew<TKey>(Dictionary<TKey, int> known, TKey key)
        where TKey : notnull
    {
        if (known.TryGetValue(key, out int number))
        {
            Number((uint)number);
            return false;
        }

        Number((uint)known.Count);
        known.Add(key, known.Count);
        return true;
    }

    private void Value(TapeValue value)
    {
        _bytes.Add((byte)value.Kind);
        switch (value.Kind)
        {
            case TapeValueKind.Whole:
            case TapeValueKind.Memory:
                Signed(value.Whole);
                break;
            case TapeValueKind.Real:
                Single(value.X);
                break;
            case TapeValueKind.Vector:
                Single(value.X);
                Single(value.Y);
                Single(value.Z);
                break;
            case TapeValueKind.Text:
                Text(value.Text!);
                break;
            default:
                break;
        }
    }

    private void Single(float value)
    {
        byte[] bytes = BitConverter.GetBytes(value);
        _bytes.AddRange(bytes);
    }

    private void Text(string text)
    {
        byte[] bytes = Encoding.UTF8.GetBytes(text);
        Number((uint)bytes.Length);
        _bytes.AddRange(bytes);
    }

    /// <summary>A signed number: 0, -1, 1, -2 and so on become 0, 1, 2, 3, so that small ones stay short.</summary>
    private void Signed(long value) => Number((ulong)((value << 1) ^ (value >> 63)));

    /// <summary>Seven bits per byte, the lowest first; the high bit says that more follow.</summary>
    private void Number(ulong value)
    {
        for (; value > 0x7F; value >>= 7)
        {
            _bytes.Add((byte)(value | 0x80));
        }

        _bytes.Add((byte)value);
    }

    private void Fixed(ulong value, int bytes)
    {
        for (int i = 0; i < bytes; i++, value >>= 8)
        {
            _bytes.Add((byte)value);
        }
    }
}
