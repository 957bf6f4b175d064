using System.Globalization;
using System.Text.Json;
using System.Text.RegularExpressions;

namespace Harvester.Exports.Tests.Columns;

/// <summary>
/// What the tables must have, taken from the label lines by the fields that the documentation names, and not by what writes the tables.
/// </summary>
/// <param name="lines">The label lines.</param>
internal sealed class LabelOracle(IReadOnlyList<JsonElement> lines)
{
    /// <summary>Compares a table with the labels, value by value.</summary>
    /// <param name="table">Its documentation.</param>
    /// <param name="rows">Its rows.</param>
    /// <returns>The number of values that were compared.</returns>
    public int Compare(DocumentedTable table, IReadOnlyList<Dictionary<string, object?>> rows)
    {
        Source[] sources =
        [
            .. lines.SelectMany((line, frame) => Sources(table.Name, line).Select(source => source with { Frame = frame })),
        ];
        Assert.Equal(sources.Length, rows.Count);
        int compared = 0;
        for (int i = 0; i < rows.Count; i++)
        {
            Assert.Equal(sources[i].Frame, rows[i]["frame"]);
            Assert.Equal(table.Columns.Select(column => column.Name), rows[i].Keys);
            foreach ((string name, string _, string _, string field) in table.Columns.Where(column => column.Field.Length > 0))
            {
                string at = field.Replace("[point]", $"[{sources[i].Point}]", StringComparison.Ordinal);
                Assert.True(
                    IsEqual(At(sources[i].Element, at), rows[i][name]),
                    $"{table.Name}, row {i}, {name}: {rows[i][name] ?? "null"}"
                );
                compared++;
            }
        }

        return compared;
    }

    /// <summary>The elements of the label that a table has rows of.</summary>
    private static IEnumerable<Source> Sources(string table, JsonElement line)
    {
        Source[] Items(JsonElement from, string path) =>
            At(from, path) is { ValueKind: JsonValueKind.Array } list ? [.. list.EnumerateArray().Select(item => new Source(item))] : [];
        Source[] Whole(string path) => At(line, path) is { ValueKind: JsonValueKind.Object } whole ? [new Source(whole)] : [];
        Source[] Lines() => [.. Items(line, "lanes.boundaries"), .. Items(line, "lanes.markings")];
        return table switch
        {
            "frames" => [new Source(line)],
            "joints" => Items(line, "objects").SelectMany(item => Items(item.Element, "joints")),
            "ignore_regions" => Items(line, "ignoreRegions"),
            "lanes" => Whole("lanes"),
            "controls" => Whole("drive"),
            "drive_ticks" => Items(line, "drive.ticks"),
            "imu" => Whole("imu"),
            "gnss" => Whole("gnss"),
            "lane_vehicles" => Items(line, "lanes.vehicles"),
            "lane_lines" => Lines(),
            "lane_points" => Lines().SelectMany(item => Items(item.Element, "points").Select((_, point) => item with { Point = point })),
            "indicators" => [.. Whole("lanes"), .. Whole("lanes.atCar"), .. Whole("lanes.torcsEquivalent").Select(AsIndicators)],
            _ => Items(line, table),
        };
    }

    /// <summary>The indicators of TORCS stand in no object of their own.</summary>
    private static Source AsIndicators(Source torcs) =>
        new(JsonDocument.Parse($"{{\"indicators\":{torcs.Element.GetRawText()}}}").RootElement);

    private static JsonElement At(JsonElement element, string path)
    {
        foreach (Match step in Regex.Matches(path, @"[^.\[\]]+"))
        {
            if (int.TryParse(step.Value, CultureInfo.InvariantCulture, out int index))
            {
                if (element.ValueKind != JsonValueKind.Array || index >= element.GetArrayLength())
                {
                    return default;
                }

                element = element[index];
            }
            else if (element.ValueKind != JsonValueKind.Object || !element.TryGetProperty(step.Value, out element))
            {
                return default;
            }
        }

        return element;
    }

    private static bool IsEqual(JsonElement expected, object? actual) =>
        expected.ValueKind switch
        {
            JsonValueKind.Undefined or JsonValueKind.Null => actual is null,
            JsonValueKind.Number => actual switch
            {
                double number => number.Equals(double.Parse(expected.GetRawText(), CultureInfo.InvariantCulture)),
                int whole => expected.GetRawText() == whole.ToString(CultureInfo.InvariantCulture),
                long whole => expected.GetRawText() == whole.ToString(CultureInfo.InvariantCulture),
                _ => false,
            },
            JsonValueKind.String => expected.GetString() == actual as string,
            JsonValueKind.True => actual is true,
            JsonValueKind.False => actual is false,
            JsonValueKind.Array => actual is System.Collections.IList list
                && list.Count == expected.GetArrayLength()
                && expected.EnumerateArray().Zip(list.Cast<object?>()).All(pair => IsEqual(pair.First, pair.Second)),
            _ => false,
        };

    private readonly record struct Source(JsonElement Element)
    {
        public int Frame { get; init; }

        public int Point { get; init; }
    }
}
