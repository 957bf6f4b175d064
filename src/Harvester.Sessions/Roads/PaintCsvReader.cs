using System.Globalization;
using Harvester.Geometry;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Paint;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Text;

namespace Harvester.Sessions.Roads;

/// <summary>
/// Reads measured paint in the format of <see cref="PaintCsv"/>, strictly: the first error ends the reading and is reported with its line.
/// Links are found in the network by the positions of their ends; those that it does not have are counted and left out.
/// </summary>
public sealed class PaintCsvReader
{
    /// <summary>Maximum number of links: more than ten times as many as in the game.</summary>
    private const int MaxLinks = 1_000_000;

    /// <summary>Maximum number of lines in a file, which take about 400 MB of memory: forty for each of GTA V's 72,000 links.</summary>
    private const int MaxLines = 3_000_000;

    /// <summary>Maximum number of stop lines and crossings, which take up to 150 MB: more than one for each of GTA V's links.</summary>
    private const int MaxMarks = 100_000;

    /// <summary>Least and greatest number of corners of a mark.</summary>
    private const int MinCorners = 3;
    private const int MaxCorners = 64;

    /// <summary>Maximum coordinate, station and offset, metres: that of the road file.</summary>
    private const double MaxCoordinate = 100_000;

    /// <summary>A station is rounded in the file and may exceed the length of the link by this, metres.</summary>
    private const double Rounding = 0.001;

    private readonly RoadNetwork _network;
    private readonly RoadCurves _curves;
    private readonly Dictionary<LinkEnds, int> _linkByEnds = [];
    private readonly Dictionary<int, LinkPaint> _links = [];
    private readonly List<MarkPaint> _marks = [];
    private List<LinePaint> _lines = [];
    private string _index = "";
    private int? _link;
    private int _linkCount;
    private int _lineCount;
    private int _line;
    private bool _ended;

    private PaintCsvReader(RoadNetwork network)
    {
        _network = network;
        _curves = new RoadCurves(network);
        for (int i = network.Links.Count - 1; i >= 0; i--)
        {
            _linkByEnds[LinkEnds.Of(network, network.Links[i])] = i;
        }
    }

    /// <summary>Reads a file to its end.</summary>
    /// <param name="text">The file.</param>
    /// <param name="network">The roads.</param>
    /// <exception cref="FormatException">
    /// The file is invalid (the message names the line), or none of its links is in the network.
    /// </exception>
    /// <exception cref="IOException">The file cannot be read.</exception>
    public static PaintTable Read(TextReader text, RoadNetwork network)
    {
        if (text is null)
        {
            throw new ArgumentNullException(nameof(text));
        }

        return new PaintCsvReader(network ?? throw new ArgumentNullException(nameof(network))).ReadAll(text);
    }

    private PaintTable ReadAll(TextReader text)
    {
        while (text.ReadLine() is { } line)
        {
            _line++;
            if (_line == 1)
            {
                Require(line.TrimStart('\uFEFF') == PaintCsv.FirstLine, "the first line must be " + PaintCsv.FirstLine + ".");
            }
            else if (line.Length > 0 && line[0] != '#')
            {
                Require(!_ended, "nothing may follow the line that begins with end.");
                ReadRow(CsvFields.Split(line) ?? throw Wrong(CsvFields.Problem));
            }
        }

        Require(_ended, "the file ends before its last line, which begins with end.");
        if (_linkCount > 0 && _links.Count == 0)
        {
            throw new FormatException(
                FormattableString.Invariant(
                    $"none of its {_linkCount} links is in these roads; the table was measured on another road network."
                )
            );
        }

        return new PaintTable(_network, _links.Values, _linkCount - _links.Count) { Marks = _marks };
    }

    private void ReadRow(List<string> fields)
    {
        switch (fields[0])
        {
            case "link":
                Require(fields.Count == 10, "a link has 10 fields.");
                Require(++_linkCount <= MaxLinks, FormattableString.Invariant($"more than {MaxLinks} links."));
                Require(_marks.Count == 0, "a link must come before the marks.");
                ReadLink(fields);
                break;
            case "line":
                Require(fields.Count == 14, "a line has 14 fields.");
                Require(++_lineCount <= MaxLines, FormattableString.Invariant($"more than {MaxLines} lines."));
                Require(_linkCount > 0 && _marks.Count == 0 && fields[1] == _index, "a line must follow its link.");
                ReadLine(fields);
                break;
            case "mark":
                int corners = (fields.Count - PaintCsv.MarkFields) / 3;
                Require(
                    fields.Count == PaintCsv.MarkFields + (3 * corners) && corners is >= MinCorners and <= MaxCorners,
                    FormattableString.Invariant(
                        $"a mark has {PaintCsv.MarkFields} fields and 3 for each of {MinCorners} to {MaxCorners} corners."
                    )
                );
                Require(_marks.Count < MaxMarks, FormattableString.Invariant($"more than {MaxMarks} marks."));
                ReadMark(fields, corners);
                break;
            case "end":
                Require(
                    fields.Count == (_marks.Count > 0 ? 4 : 3),
                    "the last line must have the numbers of links and lines, and of marks if there are any."
                );
                Whole(fields[1], "the count of links", _linkCount, _linkCount);
                Whole(fields[2], "the count of lines", _lineCount, _lineCount);
                if (_marks.Count > 0)
                {
                    Whole(fields[3], "the count of marks", _marks.Count, _marks.Count);
                }

                _ended = true;
                break;
            default:
                throw Wrong("a line must begin with link, line, mark, end or #.");
        }
    }

    private void ReadLink(List<string> fields)
    {
        _index = fields[1];
        int index = Whole(_index, "index", 0, int.MaxValue);
        LinkEnds ends = LinkEnds.Of(Place(fields, 2), Place(fields, 5));
        double from = Metres(fields[8], "seenFrom", 0, MaxCoordinate);
        double to = Metres(fields[9], "seenTo", from, MaxCoordinate);
        Require(to > from, "seenTo must be greater than seenFrom.");

        // Two links can have the same ends; then the number decides.
        _link =
            index < _network.Links.Count && LinkEnds.Of(_network, _network.Links[index]) == ends ? index
            : _linkByEnds.TryGetValue(ends, out int found) ? found
            : null;
        _lines = [];
        if (_link is { } link)
        {
            Require(!_links.ContainsKey(link), "the link is listed twice.");
            Require(to <= _curves.Of(link).Length + Rounding, "seenTo is beyond the end of the link.");
            _links.Add(link, new LinkPaint(link, from, to, _lines));
        }
    }

    private void ReadLine(List<string> fields)
    {
        double end = _link is { } link ? _curves.Of(link).Length + Rounding : MaxCoordinate;
        double from = Metres(fields[2], "fromStation", 0, end);
        double to = Metres(fields[3], "toStation", from, end);
        Require(to > from, "toStation must be greater than fromStation.");
        var paint = new MarkingPaint(
            Named<MarkingStyle>(fields[6], "style", PaintCsv.NameOf),
            Named<MarkingColour>(fields[7], "colour", PaintCsv.NameOf),
            Positive(fields[8], "width")
        );
        bool hasDashes = fields.Skip(9).Take(3).Any(field => field.Length > 0);
        Require(!hasDashes || paint.Style == MarkingStyle.Dashed, "only a dashed line has dashes.");
        _lines.Add(
            new LinePaint(from, to, Metres(fields[4], "fromOffset"), Metres(fields[5], "toOffset"), paint)
            {
                Dashes = hasDashes ? Dashes(fields) : null,
                SigmaMetres = Positive(fields[12], "sigma"),
                Images = Whole(fields[13], "images", 1, int.MaxValue),
            }
        );
    }

    private void ReadMark(List<string> fields, int corners) =>
        _marks.Add(
            new MarkPaint(
                new PaintedMark(
                    Named<MarkKind>(fields[1], "class", PaintCsv.NameOf),
                    [.. Enumerable.Range(0, corners).Select(i => Place(fields, PaintCsv.MarkFields + (3 * i)))]
                )
            )
            {
                SigmaMetres = Positive(fields[2], "sigma"),
                Images = Whole(fields[3], "images", 1, int.MaxValue),
            }
        );

    private DashPattern Dashes(List<string> fields)
    {
        double length = Positive(fields[9], "dashLength");
        double period = Metres(fields[10], "dashPeriod", length, MaxCoordinate);
        Require(period > length, "dashPeriod must be greater than dashLength.");
        return new DashPattern(length, period, Metres(fields[11], "dashPhase", 0, period));
    }

    private T Named<T>(string text, string name, Func<T, string> nameOf)
        where T : struct, Enum
    {
        foreach (T value in (T[])Enum.GetValues(typeof(T)))
        {
            if (string.Equals(nameOf(value), text, StringComparison.Ordinal))
            {
                return value;
            }
        }

        throw Wrong("unknown " + name + ": " + text + ".");
    }

    private int Whole(string text, string name, int minimum, int maximum) =>
        int.TryParse(text, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out int value)
        && value >= minimum
        && value <= maximum
            ? value
            : throw Wrong(FormattableString.Invariant($"{name} must be a whole number from {minimum} to {maximum}, not {text}."));

    private Vector3D Place(List<string> fields, int first) =>
        new(Metres(fields[first], "x"), Metres(fields[first + 1], "y"), Metres(fields[first + 2], "z"));

    private double Positive(string text, string name)
    {
        double value = Metres(text, name, 0, MaxCoordinate);
        Require(value > 0, name + " must be greater than 0.");
        return value;
    }

    private double Metres(string text, string name, double minimum = -MaxCoordinate, double maximum = MaxCoordinate) =>
        double.TryParse(
            text,
            NumberStyles.AllowLeadingSign | NumberStyles.AllowDecimalPoint,
            CultureInfo.InvariantCulture,
            out double value
        )
        && value >= minimum
        && value <= maximum
            ? value
            : throw Wrong(FormattableString.Invariant($"{name} must be a number from {minimum} to {maximum}, not {text}."));

    private void Require(bool condition, string what)
    {
        if (!condition)
        {
            throw Wrong(what);
        }
    }

    private FormatException Wrong(string what) => new(FormattableString.Invariant($"line {_line}: {what}"));
}
