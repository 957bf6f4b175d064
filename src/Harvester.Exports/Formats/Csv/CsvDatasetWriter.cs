using System.Globalization;
using System.Text.Json;
using CsvHelper;
using CsvHelper.Configuration;
using Harvester.Geometry;
using Harvester.Sessions.Events;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading.Json;
using Harvester.Sessions.Text;

namespace Harvester.Exports.Formats.Csv;

/// <summary>
/// Writes the CSV tables frames.csv, objects.csv and ignore_regions.csv (RFC 4180 with LF), for recorded drives drive.csv, with events
/// events.csv, and the images. See docs/exports/csv.md.
/// </summary>
internal sealed class CsvDatasetWriter(ExportOptions options) : IDatasetWriter
{
    private const int Metres = 4;
    private const int Pixels = 3;
    private const int Fraction = 4;
    private const int Axis = 9;
    private const int Intrinsics = 6;
    private const int Seconds = 6;

    private readonly ClassCatalogue _classes = new(options);

    /// <summary>Columns of frames.csv.</summary>
    public static string[] FrameColumns { get; } =
    [
        "frame",
        "split",
        "session",
        "session_frame",
        "image",
        "time_seconds",
        "weather",
        "time_of_day",
        "width",
        "height",
        "fx",
        "fy",
        "cx",
        "cy",
        "k1",
        "k2",
        .. VectorColumns("camera"),
        .. VectorColumns("camera_right"),
        .. VectorColumns("camera_forward"),
        .. VectorColumns("camera_up"),
        .. VectorColumns("ego"),
        "ego_heading_degrees",
        .. VectorColumns("ego_velocity"),
    ];

    /// <summary>Columns of objects.csv.</summary>
    public static string[] ObjectColumns { get; } =
    [
        "frame",
        "id",
        "class",
        "model",
        "name",
        .. BoxColumns("box2d"),
        .. BoxColumns("box2d_amodal"),
        .. BoxColumns("box2d_visible"),
        "truncated_fraction",
        "occluded_fraction",
        "visible_fraction",
        .. VectorColumns("centre"),
        .. VectorColumns("half_extents"),
        .. VectorColumns("right"),
        .. VectorColumns("forward"),
        .. VectorColumns("up"),
        "distance_metres",
        .. VectorColumns("velocity"),
        "parent",
        "mutcd",
        "light_state",
        "has_rider",
        "vehicle",
    ];

    /// <summary>Columns of ignore_regions.csv.</summary>
    public static string[] RegionColumns { get; } = ["frame", "reason", "class", .. BoxColumns("box2d"), "distance_metres"];

    public WrittenObjects Write(ExportFrame frame, FrameOutput output)
    {
        string image = $"images/{frame.Name}{frame.ImageExtension}";
        output.Image(image, frame);
        output.Part("frames", Line(FrameFields(frame, image)));
        if (frame.Label.Drive is { } drive)
        {
            output.Part(CsvDriveTable.Part, Line(CsvDriveTable.Fields(frame, drive, image)));
        }

        foreach (EventMark mark in frame.Label.Events ?? [])
        {
            output.Part(CsvEventTable.Part, Line(CsvEventTable.Fields(frame, mark)));
        }

        Dictionary<int, double?> visible = VisibleFractions(frame.LabelText);
        foreach (ExportObject item in frame.Objects)
        {
            output.Part("objects", Line([Numbers.Text(frame.Index), .. ObjectFields(item, visible[item.Label.Id])]));
        }

        IgnoreRegion[] regions = [.. frame.Label.IgnoreRegions.Where(region => _classes.Of(region.Class) is not null)];
        foreach (IgnoreRegion region in regions)
        {
            output.Part(
                "regions",
                Line([
                    Numbers.Text(frame.Index),
                    JsonName.Of(region.Reason),
                    CsvText.Of(_classes.Of(region.Class)!.Name),
                    .. Of(region.Box2D),
                    .. Of(Metres, region.DistanceMetres),
                ])
            );
        }

        return new WrittenObjects(frame.Objects.Count, regions.Length);
    }

    public IEnumerable<AggregateFile> Aggregates(IReadOnlyDictionary<string, int> parts) =>
        [
            .. parts.ContainsKey(CsvDriveTable.Part)
                ?
                [
                    new AggregateFile(
                        CsvDriveTable.FileName,
                        [AggregateSection.Literal(Line(CsvDriveTable.Columns) + "\n"), AggregateSection.Lines(CsvDriveTable.Part)]
                    ),
                ]
                : Array.Empty<AggregateFile>(),
            .. parts.ContainsKey(CsvEventTable.Part)
                ?
                [
                    new AggregateFile(
                        CsvEventTable.FileName,
                        [AggregateSection.Literal(Line(CsvEventTable.Columns) + "\n"), AggregateSection.Lines(CsvEventTable.Part)]
                    ),
                ]
                : Array.Empty<AggregateFile>(),
            new("frames.csv", [AggregateSection.Literal(Line(FrameColumns) + "\n"), AggregateSection.Lines("frames")]),
            new("ignore_regions.csv", [AggregateSection.Literal(Line(RegionColumns) + "\n"), AggregateSection.Lines("regions")]),
            new("objects.csv", [AggregateSection.Literal(Line(ObjectColumns) + "\n"), AggregateSection.Lines("objects")]),
        ];

    private static string[] VectorColumns(string name) => [$"{name}_x", $"{name}_y", $"{name}_z"];

    private static string[] BoxColumns(string name) => [$"{name}_xmin", $"{name}_ymin", $"{name}_xmax", $"{name}_ymax"];

    private static IEnumerable<string> FrameFields(ExportFrame frame, string image)
    {
        FrameLabel label = frame.Label;
        CameraLabel camera = label.Camera;
        return
        [
            Numbers.Text(frame.Index),
            CsvText.Of(frame.Split),
            Numbers.Text(frame.RecordingIndex),
            Numbers.Text(label.Frame),
            image,
            .. Of(Seconds, label.TimeSeconds),
            CsvText.Of(label.Environment.Weather),
            label.Environment.TimeOfDay.ToString(@"hh\:mm\:ss", CultureInfo.InvariantCulture),
            Numbers.Text(camera.Width),
            Numbers.Text(camera.Height),
            .. Of(Intrinsics, camera.Fx, camera.Fy, camera.Cx, camera.Cy),
            .. Of(Axis, camera.Distortion.K1, camera.Distortion.K2),
            .. Of(camera.Pose.Position, Metres),
            .. Of(camera.Pose.Axes),
            .. Of(label.Ego.Position, Metres),
            .. Of(Metres, label.Ego.HeadingDegrees),
            .. Of(label.Ego.Velocity, Metres),
        ];
    }

    private static IEnumerable<string> ObjectFields(ExportObject item, double? visibleFraction)
    {
        ObjectLabel label = item.Label;
        return
        [
            Numbers.Text(label.Id),
            CsvText.Of(item.Class.Name),
            CsvText.Of(label.Model),
            CsvText.Of(label.Name),
            .. Of(label.Box2D),
            .. Of(label.Box2DAmodal),
            .. Of(label.Box2DVisible),
            .. Of(Fraction, label.TruncatedFraction, label.OccludedFraction, visibleFraction),
            .. Of(label.Box3D.Centre, Metres),
            .. Of(label.Box3D.HalfExtents, Metres),
            .. Of(label.Box3D.Axes),
            .. Of(Metres, label.DistanceMetres),
            .. Of(label.Velocity, Metres),
            .. Of(0, label.Parent),
            CsvText.Of(label.Face?.MutcdCode),
            label.Face?.Light is { } light ? JsonName.Of(light.State) : "",
            Of(label.HasRider),
            .. Of(0, label.Vehicle),
        ];
    }

    /// <summary>
    /// The fractions as the session has them. Computed from the other, rounded fractions, they could differ in the last decimal.
    /// </summary>
    private static Dictionary<int, double?> VisibleFractions(string line)
    {
        using JsonDocument label = JsonDocument.Parse(line);
        return new JsonFields(label.RootElement)
            .List("objects")
            .ToDictionary(item => item.Integer("id"), item => item.OptionalNumber("visibleFraction"));
    }

    private static string Of(bool? truth) =>
        truth switch
        {
            true => "1",
            false => "0",
            null => "",
        };

    /// <summary>Unknown values are empty fields.</summary>
    private static IEnumerable<string> Of(int decimals, params double?[] values) =>
        values.Select(value => value is { } known ? InvariantNumber.Format(known, decimals) : "");

    private static IEnumerable<string> Of(Vector3D vector, int decimals) => Of(decimals, vector.X, vector.Y, vector.Z);

    private static IEnumerable<string> Of(Axes axes) => [.. Of(axes.Right, Axis), .. Of(axes.Forward, Axis), .. Of(axes.Up, Axis)];

    private static IEnumerable<string> Of(Box2D? box) => Of(Pixels, box?.XMin, box?.YMin, box?.XMax, box?.YMax);

    private static string Line(IEnumerable<string> fields)
    {
        using var text = new StringWriter(CultureInfo.InvariantCulture);
        using (var csv = new CsvWriter(text, new CsvConfiguration(CultureInfo.InvariantCulture) { NewLine = "\n" }))
        {
            foreach (string field in fields)
            {
                // Readers that split by lines would take a line break in a field for the end of the row.
                csv.WriteField(field.ReplaceLineEndings(" "));
            }

            csv.Flush();
        }

        return text.ToString();
    }
}
