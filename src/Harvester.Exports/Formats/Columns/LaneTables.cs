using System.Text.Json;
using Harvester.Geometry.Lanes;

namespace Harvester.Exports.Formats.Columns;

/// <summary>The tables of lanes: the lanes of a frame, the indicators, vehicles in lanes, and the lines with their points.</summary>
internal static class LaneTables
{
    private const string Metres = "m";

    private static readonly TableField Frame = TableField.Key("frame", row => row.Frame.Frame);

    private static readonly string[] IndicatorNames = [.. IndicatorTable.All.Select(indicator => indicator.Name)];

    /// <summary>A row for each frame with lanes.</summary>
    public static LabelTable Lanes { get; } =
        new(
            "lanes",
            "the lanes around the car in a frame",
            [
                Frame,
                TableField.Of("status", ColumnKind.Word, "status"),
                TableField.Of("source", ColumnKind.Word, "source"),
                TableField.Of("confidence", ColumnKind.Number, "confidence", "0 to 1"),
                TableField.Of("in_junction", ColumnKind.Truth, "inJunction"),
                TableField.Of("lane_count", ColumnKind.Integer, "laneCount"),
                TableField.Of("lane", ColumnKind.Integer, "lane"),
                TableField.Of("lane_id", ColumnKind.Text, "laneId"),
                TableField.Of("lanes_ahead", ColumnKind.Texts, "lanesAhead"),
                TableField.Of("lane_width_metres", ColumnKind.Number, "laneWidthMetres", Metres),
                TableField.Of("lane_widths_metres", ColumnKind.Numbers, "laneWidthsMetres", Metres),
                TableField.Of("lane_width_source", ColumnKind.Word, "laneWidthSource"),
                TableField.Of("offset_from_lane_centre_metres", ColumnKind.Number, "offsetFromLaneCentreMetres", Metres),
                TableField.Of("look_ahead_metres", ColumnKind.Number, "lookAheadMetres", Metres),
                TableField.Of("curvature_per_metre", ColumnKind.Number, "curvaturePerMetre", "1/m"),
                TableField.Of("fast", ColumnKind.Truth, "fast"),
            ],
            (frame, label) => Lane(label) is { ValueKind: JsonValueKind.Object } lanes ? [new TableRow(frame, lanes)] : []
        );

    /// <summary>Three rows for each frame with lanes: at the look-ahead point, at the car, and as a road of TORCS.</summary>
    public static LabelTable Indicators { get; } =
        new(
            "indicators",
            "the thirteen indicators of a frame at one place",
            [
                Frame,
                TableField.Given("at", row => row.Word!),
                .. IndicatorNames.Select(name =>
                    TableField.Of(ColumnNames.Of(name), ColumnKind.Number, name, name == "angle" ? "rad" : Metres)
                ),
                .. IndicatorNames.Select(name =>
                    TableField.Of("valid_" + ColumnNames.Of(name), ColumnKind.Truth, name, part: 1, field: $"valid.{name}")
                ),
            ],
            IndicatorRows
        );

    /// <summary>A row for each vehicle in a lane.</summary>
    public static LabelTable Vehicles { get; } =
        new(
            "lane_vehicles",
            "a vehicle on the road ahead",
            [
                Frame,
                TableField.Of("id", ColumnKind.Integer, "id"),
                TableField.Of("lane", ColumnKind.Integer, "lane"),
                TableField.Of("oncoming", ColumnKind.Truth, "oncoming"),
                TableField.Of("distance_metres", ColumnKind.Number, "distanceMetres", Metres),
                TableField.Of("bumper_distance_metres", ColumnKind.Number, "bumperDistanceMetres", Metres),
            ],
            (frame, label) => FrameTables.Items(frame, label, "lanes", "vehicles")
        );

    /// <summary>A row for each boundary and marking.</summary>
    public static LabelTable Lines { get; } =
        new(
            "lane_lines",
            "a boundary of a lane, or a painted marking",
            [
                Frame,
                TableField.Key("line", row => row.Number),
                TableField.Given("kind", row => row.Word!),
                TableField.Of("index", ColumnKind.Integer, "index"),
                TableField.Of("side", ColumnKind.Word, "side"),
                TableField.Of("style", ColumnKind.Word, "style"),
                TableField.Of("colour", ColumnKind.Word, "colour"),
                TableField.Of("width_metres", ColumnKind.Number, "widthMetres", Metres),
                TableField.Of("source", ColumnKind.Word, "source"),
                TableField.Of("sigma_metres", ColumnKind.Number, "sigmaMetres", Metres),
            ],
            LineRows
        );

    /// <summary>A row for each point of a boundary or marking.</summary>
    public static LabelTable Points { get; } =
        new(
            "lane_points",
            "a point of a boundary or marking",
            [
                Frame,
                TableField.Key("line", row => row.Owner),
                TableField.Key("point", row => row.Number),
                TableField.Vector(["x", "y", "z"], "", "m, world", field: "points[point]"),
                TableField.Vector(["camera_right", "camera_forward", "camera_up"], "", "m, camera", part: 1, field: "inCamera[point]"),
                TableField.Vector(["u", "v"], "", "px, image", part: 2, field: "pixels[point]"),
                TableField.Of("hidden", ColumnKind.Truth, "", part: 3, field: "hidden[point]"),
                TableField.Of("painted", ColumnKind.Truth, "", part: 4, field: "painted[point]"),
            ],
            (frame, label) => LineRows(frame, label).SelectMany(line => PointRows(frame, line))
        );

    private static JsonElement Lane(JsonElement label) => LabelTable.At(label, "lanes");

    private static IEnumerable<TableRow> IndicatorRows(TableFrame frame, JsonElement label)
    {
        JsonElement lanes = Lane(label);
        (string At, JsonElement Values, JsonElement Valid)[] rows =
        [
            ("lookAhead", LabelTable.At(lanes, "indicators"), LabelTable.At(lanes, "valid")),
            ("car", LabelTable.At(lanes, "atCar", "indicators"), LabelTable.At(lanes, "atCar", "valid")),
            ("torcsEquivalent", LabelTable.At(lanes, "torcsEquivalent"), default),
        ];
        return rows.Where(row => row.Values.ValueKind == JsonValueKind.Object)
            .Select(row => new TableRow(frame, row.Values, row.Valid) { Word = row.At });
    }

    private static IEnumerable<TableRow> LineRows(TableFrame frame, JsonElement label)
    {
        int number = 0;
        foreach ((string list, string kind) in ((string, string)[])[("boundaries", "boundary"), ("markings", "marking")])
        {
            foreach (JsonElement line in LabelTable.List(label, "lanes", list))
            {
                yield return new TableRow(frame, line) { Number = number++, Word = kind };
            }
        }
    }

    private static IEnumerable<TableRow> PointRows(TableFrame frame, TableRow line)
    {
        // Each list has an entry per point. Lists are walked side by side, because a look-up by number in a list of lists takes as many
        // steps as the number says.
        IEnumerator<JsonElement>[] lists =
        [
            .. ((string[])["points", "inCamera", "pixels", "hidden", "painted"]).Select(list =>
                LabelTable.List(line.Parts[0], list).GetEnumerator()
            ),
        ];
        for (int number = 0; lists[0].MoveNext(); number++)
        {
            JsonElement[] parts = new JsonElement[lists.Length];
            parts[0] = lists[0].Current;
            for (int i = 1; i < lists.Length; i++)
            {
                parts[i] = lists[i].MoveNext() ? lists[i].Current : default;
            }

            yield return new TableRow(frame, parts) { Owner = line.Number, Number = number };
        }
    }
}
