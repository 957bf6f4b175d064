using Harvester.Sessions.Reading.Files;

namespace Harvester.Sessions.Reading.Json;

/// <summary>Rejects elements of the outermost list of a JSON file that are too long to be held in memory.</summary>
/// <param name="name">Name of the file in messages.</param>
/// <param name="maxBytes">Largest size of an element, bytes.</param>
internal sealed class JsonElementLimit(string name, int maxBytes) : IByteLimit
{
    private bool _isInText;
    private bool _isEscaped;
    private int _depth;
    private long _length;

    public void Pass(ReadOnlySpan<byte> bytes)
    {
        foreach (byte value in bytes)
        {
            Pass(value);
            if (++_length > maxBytes)
            {
                throw new DatasetFormatException(
                    FormattableString.Invariant($"{name}: an element of the list has more than {maxBytes} bytes, the limit.")
                );
            }
        }
    }

    private void Pass(byte value)
    {
        if (_isInText)
        {
            _isInText = _isEscaped || value != '"';
            _isEscaped = !_isEscaped && value == '\\';
            return;
        }

        _isInText = value == '"';
        _depth += value switch
        {
            (byte)'[' or (byte)'{' => 1,
            (byte)']' or (byte)'}' => -1,
            _ => 0,
        };
        _length = value == ',' && _depth <= 1 ? 0 : _length;
    }
}
