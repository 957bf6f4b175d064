using System.Globalization;
using Harvester.Geometry;
using Harvester.Geometry.Paint;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Text;

namespace Harvester.Sessions.Roads;

/// <summary>Writes measured paint in the format of <see cref="PaintCsv"/>: the same table gives the same bytes in every runtime.</summary>
public static class PaintCsvWriter
{
    /// <summary>Writes a table: each link, followed by its lines; then the marks.</summary>
    /// <exception cref="IOException">The file cannot be written.</exception>
    public static void Write(PaintTable table, TextWriter text)
    {
        if (table is null)
        {
            throw new ArgumentNullException(nameof(table));
        }

        if (text is null)
        {
            throw new ArgumentNullException(nameof(text));
        }

        Line(text, PaintCsv.FirstLine);
        Line(text, PaintCsv.LinkColumns);
        Line(text, PaintCsv.LineColumns);
        foreach (LinkPaint link in table.Links)
        {
            RoadLink road = table.Network.Links[link.Link];
            Vector3D from = table.Network.Nodes[road.From].Position;
            Vector3D to = table.Network.Nodes[road.To].Position;
            Line(
                text,
                "link",
                Whole(link.Link),
                Exact(from.X),
                Exact(from.Y),
                Exact(from.Z),
                Exact(to.X),
                Exact(to.Y),
                Exact(to.Z),
                Metres(link.SeenFrom),
                Metres(link.SeenTo)
            );
            foreach (LinePaint line in link.Lines)
            {
                Line(
                    text,
                    "line",
                    Whole(link.Link),
                    Metres(line.FromStation),
                    Metres(line.ToStation),
                    Metres(line.FromOffset),
                    Metres(line.ToOffset),
                    PaintCsv.NameOf(line.Paint.Style),
                    PaintCsv.NameOf(line.Paint.Colour),
                    Metres(line.Paint.WidthMetres),
                    Metres(line.Dashes?.Length),
                    Metres(line.Dashes?.Period),
                    Metres(line.Dashes?.Phase),
                    Metres(line.SigmaMetres),
                    Whole(line.Images)
                );
            }
        }

        WriteMarks(table.Marks, text);
        string[] marks = table.Marks.Count > 0 ? [Whole(table.Marks.Count)] : [];
        Line(text, ["end", Whole(table.Links.Count), Whole(table.Links.Sum(link => link.Lines.Count)), .. marks]);
    }

    private static void WriteMarks(IReadOnlyList<MarkPaint> marks, TextWriter text)
    {
        if (marks.Count > 0)
        {
            Line(text, PaintCsv.MarkColumns);
        }

        foreach (MarkPaint mark in marks)
        {
            string[] corners =
            [
                .. mark.Mark.Corners.SelectMany(static corner => new[] { Metres(corner.X), Metres(corner.Y), Metres(corner.Z) }),
            ];
            Line(text, ["mark", PaintCsv.NameOf(mark.Mark.Kind), Metres(mark.SigmaMetres), Whole(mark.Images), .. corners]);
        }
    }

    private static string Exact(double value) => InvariantNumber.Format(value, RoadCsv.Decimals);

    private static string Metres(double? value) => value is { } metres ? InvariantNumber.Format(metres, PaintCsv.Decimals) : "";

    private static string Whole(int number) => number.ToString(CultureInfo.InvariantCulture);

    private static void Line(TextWriter text, params string[] fields) => text.Write(string.Join(",", fields) + "\n");
}
