using System;
using Harvester.Datasets.Files;

namespace Harvester.Datasets.Roads.Sources;

/// <summary>
/// Refuses a text or an attribute of an XML file that is too long to be held whole, and an element that is taken whole and is.
/// </summary>
/// <param name="name">What messages call the file.</param>
internal sealed class XmlPartLimit(string name) : IByteLimit
{
    /// <summary>The longest element that is held whole, bytes; a cell of the game's has about 1.5 million.</summary>
    public const int MaxElementBytes = 8 << 20;

    /// <summary>The longest text or attribute, bytes; the longest name has less than a hundred.</summary>
    private const int MaxTextBytes = 1 << 20;

    private long _text;
    private long _element;

    /// <summary>Whether an element is being taken whole.</summary>
    public bool IsTaking
    {
        get => field;
        set
        {
            field = value;
            _element = 0;
        }
    }

    public void Pass(ReadOnlySpan<byte> bytes)
    {
        int last = bytes.LastIndexOf((byte)'<');
        _text = last < 0 ? _text + bytes.Length : bytes.Length - last;
        _element += bytes.Length;
        if (_text > MaxTextBytes)
        {
            throw new DatasetFormatException(
                FormattableString.Invariant($"{name}: a text or an attribute has more than {MaxTextBytes} bytes; none has."));
        }

        if (IsTaking && _element > MaxElementBytes)
        {
            throw new DatasetFormatException(
                FormattableString.Invariant($"{name}: an element has more than {MaxElementBytes} bytes; none has."));
        }
    }
}
