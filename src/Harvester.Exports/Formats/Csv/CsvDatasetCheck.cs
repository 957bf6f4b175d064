using System.Globalization;
using CsvHelper;
using CsvHelper.Configuration;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Events;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Images;
using Harvester.Sessions.Text;

namespace Harvester.Exports.Formats.Csv;

/// <summary>
/// Checks the CSV tables: their columns, frames with their images, and objects that belong to a frame and lie in its image.
/// </summary>
internal sealed class CsvDatasetCheck
{
    private const string Frames = "frames.csv";
    private const string Objects = "objects.csv";
    private const string Regions = "ignore_regions.csv";

    /// <summary>Pixels have three decimals.</summary>
    private const double RoundingPixels = 0.002;

    /// <summary>Limit of a field, more than a hundred times the length of names and paths.</summary>
    private const int MaxFieldCharacters = 1 << 16;

    private static readonly string[] EventKinds = [.. Enum.GetValues<EventKind>().Select(JsonName.Of)];

    private static readonly string[] Texts =
    [
        "split",
        "image",
        "weather",
        "time_of_day",
        "class",
        "model",
        "name",
        "mutcd",
        "light_state",
        "has_rider",
        "reason",
        "driver",
        "route",
        "kind",
    ];

    private readonly DatasetContent _dataset;
    private readonly HashSet<string> _classes;
    private readonly Dictionary<string, ImageSize> _sizes = new(StringComparer.Ordinal);
    private readonly HashSet<(string Frame, string Id)> _objects = [];

    private CsvDatasetCheck(DatasetContent dataset)
    {
        _dataset = dataset;
        _classes = [.. new ClassCatalogue(dataset.Options).All.Select(kind => CsvText.Of(kind.Name))];
    }

    public static IEnumerable<SessionProblem> Problems(DatasetContent dataset)
    {
        var check = new CsvDatasetCheck(dataset);
        return check
            .TableProblems(Frames, CsvDatasetWriter.FrameColumns, check.FrameProblem)
            .Concat(check.TableProblems(Objects, CsvDatasetWriter.ObjectColumns, check.ObjectProblem))
            .Concat(check.TableProblems(Regions, CsvDatasetWriter.RegionColumns, check.RegionProblem))
            .Concat(
                dataset.Has(CsvDriveTable.FileName)
                    ? check.TableProblems(CsvDriveTable.FileName, CsvDriveTable.Columns, check.DriveProblem)
                    : []
            )
            .Concat(
                dataset.Has(CsvEventTable.FileName)
                    ? check.TableProblems(CsvEventTable.FileName, CsvEventTable.Columns, check.EventProblem)
                    : []
            );
    }

    private IEnumerable<SessionProblem> TableProblems(string name, string[] columns, Func<Dictionary<string, string>, string?> problemOf)
    {
        if (!_dataset.Has(name))
        {
            yield return new SessionProblem(name, null, "it is missing.");
            yield break;
        }

        using TextReader file = InputFile.OpenText(_dataset.PathOf(name));
        using var csv = new CsvParser(
            file,
            new CsvConfiguration(CultureInfo.InvariantCulture) { MaxFieldSize = MaxFieldCharacters, BadDataFound = null }
        );
        string? damage;
        while (TryRead(csv, out damage))
        {
            string[] fields = csv.Record!;
            string? problem =
                csv.Row == 1
                    ? fields.SequenceEqual(columns)
                        ? null
                        : "its columns are not those of the format."
                    : fields.Length != columns.Length
                        ? $"it has {fields.Length} fields instead of {columns.Length}."
                        : columns.Zip(fields).FirstOrDefault(pair => !Texts.Contains(pair.First) && !IsNumber(pair.Second))
                            is { First: { } column }
                            ? $"{column} is not a number."
                            : problemOf(columns.Zip(fields).ToDictionary(pair => pair.First, pair => pair.Second));
            if (problem is not null)
            {
                yield return new SessionProblem(name, csv.RawRow, problem);
            }
        }

        if (damage is not null)
        {
            yield return new SessionProblem(name, csv.RawRow, damage);
        }
    }

    private static bool TryRead(CsvParser csv, out string? damage)
    {
        damage = null;
        try
        {
            return csv.Read();
        }
        catch (CsvHelperException e)
        {
            damage =
                e is MaxFieldSizeException ? $"a field has more than {MaxFieldCharacters} characters." : "it cannot be read from here on.";
            return false;
        }
    }

    private string? FrameProblem(Dictionary<string, string> row)
    {
        if (!(Number(row["width"]) is >= 1 and <= ushort.MaxValue) || !(Number(row["height"]) is >= 1 and <= ushort.MaxValue))
        {
            return "width and height must be 1 to 65535.";
        }

        var size = new ImageSize((int)Number(row["width"]), (int)Number(row["height"]));
        if (!_sizes.TryAdd(row["frame"], size))
        {
            return $"frame {row["frame"]} occurs twice.";
        }

        if (!_dataset.Splits.Select(CsvText.Of).Contains(row["split"]))
        {
            return $"'{row["split"]}' is not a split of the export.";
        }

        _dataset.Found(CsvText.Read(row["split"]));
        ImageHeader? header = _dataset.Header(row["image"]);
        return !_dataset.Has(row["image"]) ? $"its image '{row["image"]}' is missing."
            : header is not null && header.Size != size
                ? $"its image is {header.Size.Width} x {header.Size.Height}, not {size.Width} x {size.Height}."
            : TimeSpan.TryParseExact(row["time_of_day"], @"hh\:mm\:ss", CultureInfo.InvariantCulture, out _) ? null
            : "time_of_day is not a time such as 13:05:00.";
    }

    private string? ObjectProblem(Dictionary<string, string> row)
    {
        return RegionProblem(row) is { } problem ? problem
            : !_objects.Add((row["frame"], row["id"])) ? $"object {row["id"]} occurs twice in frame {row["frame"]}."
            : row.Where(pair => pair.Key.EndsWith("_fraction", StringComparison.Ordinal) && pair.Value.Length > 0)
                .FirstOrDefault(pair => Number(pair.Value) is < 0 or > 1)
                is { Key: { } fraction }
                ? $"{fraction} is not 0 to 1."
            : null;
    }

    /// <summary>Checks that objects and ignore regions have in common.</summary>
    private string? RegionProblem(Dictionary<string, string> row)
    {
        if (!_sizes.TryGetValue(row["frame"], out ImageSize size))
        {
            return $"frame {row["frame"]} is not in {Frames}.";
        }

        var box = new Box2D(Number(row["box2d_xmin"]), Number(row["box2d_ymin"]), Number(row["box2d_xmax"]), Number(row["box2d_ymax"]));
        return !_classes.Contains(row["class"]) ? $"'{row["class"]}' is not a class of the export."
            : !(box.Width > 0 && box.Height > 0 && new Box2D(0, 0, size.Width, size.Height).Contains(box, RoundingPixels))
                ? $"its box2d does not lie in the image of {size.Width} x {size.Height}, or has no area."
            : Number(row["distance_metres"]) < 0 ? "distance_metres is below 0."
            : null;
    }

    private string? DriveProblem(Dictionary<string, string> row) =>
        !_sizes.ContainsKey(row["frame"]) ? $"frame {row["frame"]} is not in {Frames}."
        : !_dataset.Has(row["image"]) ? $"its image '{row["image"]}' is missing."
        : Array.Exists(["steering", "applied_steering"], name => Math.Abs(Number(row[name])) > 1) ? "steering is not -1 to 1."
        : Array.Exists(
            ["throttle", "brake", "applied_throttle", "applied_brake", "disturbed", "lanes_known"],
            name => Number(row[name]) is < 0 or > 1
        )
            ? "a pedal or flag is not 0 to 1."
        : null;

    private string? EventProblem(Dictionary<string, string> row) =>
        !_sizes.ContainsKey(row["frame"]) ? $"frame {row["frame"]} is not in {Frames}."
        : !(Number(row["event"]) >= 1) ? $"'{row["event"]}' is not the number of an event."
        : !EventKinds.Contains(row["kind"]) ? $"'{row["kind"]}' is not a kind of event."
        : null;

    /// <summary>Unknown values are empty fields.</summary>
    private static bool IsNumber(string text) => text.Length == 0 || Numbers.Parse([text]) is not null;

    private static double Number(string text) => Numbers.Parse([text])?[0] ?? double.NaN;
}
