using System.Globalization;
using CsvHelper;
using CsvHelper.Configuration;
using Harvester.Exports.Formats.Csv;
using Harvester.Geometry;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Text;

namespace Harvester.Exports.Pairs;

/// <summary>The tables index.csv, one row for each picture, and objects.csv, one for each labelled object of a moment.</summary>
internal sealed class PairTables : IDisposable
{
    /// <summary>The table of pictures.</summary>
    public const string Index = "index.csv";

    /// <summary>The table of the runs of a set of counterfactuals.</summary>
    public const string Changes = "changes.csv";

    /// <summary>The table of objects.</summary>
    public const string Objects = "objects.csv";

    private const int Pixels = 3;
    private const int Metres = 4;

    private static readonly string[] Box = ["x_min", "y_min", "x_max", "y_max"];

    private readonly CsvWriter _index;
    private readonly CsvWriter _objects;

    /// <summary>Begins the tables.</summary>
    /// <param name="index">Receives the table of pictures.</param>
    /// <param name="objects">Receives the table of objects.</param>
    public PairTables(TextWriter index, TextWriter objects)
    {
        (_index, _objects) = (Begin(index), Begin(objects));
        Write(_index, ["group", "image", "weather", "time_of_day", "without", .. Box]);
        Write(_objects, ["group", "id", "class", "name", "model", .. Box, "distance_metres"]);
    }

    /// <summary>Adds a moment.</summary>
    /// <param name="group">The moment.</param>
    /// <param name="pathOf">Gives the path of a picture within the export.</param>
    public void Add(PairGroup group, Func<PairImage, string> pathOf)
    {
        foreach (PairImage image in group.Images)
        {
            Write(
                _index,
                [
                    group.Key,
                    pathOf(image),
                    CsvText.Of(image.Pair.Weather),
                    image.Pair.TimeOfDay.ToString(@"hh\:mm\:ss", CultureInfo.InvariantCulture),
                    string.Join(" ", image.Pair.Without.Select(id => id.ToString(CultureInfo.InvariantCulture))),
                    .. Sides(group.BoxOf(image)),
                ]
            );
        }

        foreach (ObjectLabel item in group.Line.Label!.Objects)
        {
            Write(
                _objects,
                [
                    group.Key,
                    item.Id.ToString(CultureInfo.InvariantCulture),
                    JsonName.Of(item.Class),
                    CsvText.Of(item.Name),
                    CsvText.Of(item.Model),
                    .. Sides(item.Box2D),
                    Number(item.DistanceMetres, Metres),
                ]
            );
        }
    }

    /// <inheritdoc/>
    public void Dispose()
    {
        _index.Dispose();
        _objects.Dispose();
    }

    public static CsvWriter Begin(TextWriter table) =>
        new(table, new CsvConfiguration(CultureInfo.InvariantCulture) { NewLine = "\n" }, leaveOpen: true);

    private static string[] Sides(Box2D? box) =>
        box is { } at
            ? [Number(at.XMin, Pixels), Number(at.YMin, Pixels), Number(at.XMax, Pixels), Number(at.YMax, Pixels)]
            : ["", "", "", ""];

    private static string Number(double value, int decimals) => InvariantNumber.Format(value, decimals);

    public static void Write(CsvWriter table, string[] fields)
    {
        foreach (string field in fields)
        {
            table.WriteField(field);
        }

        table.NextRecord();
    }
}
