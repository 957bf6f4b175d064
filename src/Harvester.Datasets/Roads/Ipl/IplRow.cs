using System;
using System.Globalization;
using Harvester.Datasets.Files;

namespace Harvester.Datasets.Roads.Ipl;

/// <summary>A line of values between commas. Whole numbers may be written with decimals, as the game's exporter does for some.</summary>
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
            throw Wrong($"{count} values between commas were expected.");
        }
    }

    public double Number(int column) =>
        double.TryParse(_values[column], NumberStyles.Float, CultureInfo.InvariantCulture, out double value) && double.IsFinite(value)
            ? value
            : throw Wrong($"value {column} must be a finite number.");

    public int Whole(int column, int least, int most) => (int)Large(column, least, most);

    public long Large(int column, long least, long most)
    {
        double value = Number(column);
        return value >= least && value <= most && value == Math.Floor(value)
            ? (long)value
            : throw Wrong($"value {column} must be a whole number from {least} to {most}.");
    }

    private DatasetFormatException Wrong(string what) => new($"{_file}, line {_line}: {what}");
}
