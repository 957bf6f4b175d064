using System.Globalization;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Datasets.Roads.Ipl;

/// <summary>A line of comma-separated values. Integers may be written with decimals, as the game's exporter writes some.</summary>
internal readonly struct IplRow
{
    private readonly string _file;
    private readonly int _line;
    private readonly string[] _values;

    public IplRow(string file, int line, string text, int count)
    {
        _file = file;
        _line = line;
        _values = text.Split(',', count + 1, StringSplitOptions.TrimEntries);
        if (_values.Length != count)
        {
            throw Wrong($"expected {count} values between commas.");
        }
    }

    public double Number(int column) =>
        double.TryParse(_values[column], NumberStyles.Float, CultureInfo.InvariantCulture, out double value) && double.IsFinite(value)
            ? value
            : throw Wrong($"value {column} must be a finite number.");

    public int Whole(int column, int min, int max) => (int)Large(column, min, max);

    public long Large(int column, long min, long max)
    {
        double value = Number(column);
        return value >= min && value <= max && value == Math.Floor(value)
            ? (long)value
            : throw Wrong($"value {column} must be a whole number from {min} to {max}.");
    }

    private DatasetFormatException Wrong(string what) => new($"{_file}, line {_line}: {what}");
}
