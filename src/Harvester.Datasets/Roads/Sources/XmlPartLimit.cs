using Harvester.Sessions.Reading.Files;

namespace Harvester.Datasets.Roads.Sources;

/// <summary>Rejects texts, attributes and elements of an XML file that are too long to be held in memory.</summary>
/// <param name="name">Name of the file in messages.</param>
internal sealed class XmlPartLimit(string name) : IByteLimit
{
    /// <summary>Largest size of an element that is held in memory, bytes; a cell of the game has about 1.5 million.</summary>
    public const int MaxElementBytes = 8 << 20;

    /// <summary>Largest size of a text or attribute, bytes; the longest name has less than a hundred.</summary>
    private const int MaxTextBytes = 1 << 20;

    private long _text;
    private long _element;

    /// <summary>Whether an element is being held in memory.</summary>
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
                FormattableString.Invariant($"{name}: a text or an attribute has more than {MaxTextBytes} bytes, the limit.")
            );
        }

        if (IsTaking && _element > MaxElementBytes)
        {
            throw new DatasetFormatException(
                FormattableString.Invariant($"{name}: an element has more than {MaxElementBytes} bytes, the limit.")
            );
        }
    }
}
