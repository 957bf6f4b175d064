using System.Text.Json;
using System.Text.RegularExpressions;
using Harvester.Exports.Formats.Columns;
using Harvester.TestSupport;

namespace Harvester.Exports.Tests.Columns;

[Collection(SimulatedSession.Collection)]
public sealed class ParquetFieldTests(SimulatedSession simulated) : ExportTests
{
    private const int Seed = 44;

    private const int Lines = 40;

    [Fact]
    public void Every_value_of_a_harvest_is_that_of_its_label_line()
    {
        Folder.Export("parquet", simulated.Open());

        JsonElement[] lines = [.. File.ReadLines(Path.Combine(simulated.Folder, "labels.jsonl")).Select(Parse)];
        int compared = DocumentedTable.All.Sum(table => new LabelOracle(lines).Compare(table, Rows(table.Name)));
        Assert.InRange(compared, 5_000, int.MaxValue);
    }

    [Fact]
    public void Every_field_of_the_schema_is_in_its_table()
    {
        var labels = new SchemaLabels(Seed);
        JsonElement[] lines = [.. Enumerable.Range(0, Lines).Select(line => Parse(labels.Line(isWhole: line % 2 == 0).ToJsonString()))];
        Directory.CreateDirectory(Folder.PathOf("out"));
        foreach (LabelTable table in LabelTables.All)
        {
            using FileStream file = File.Create(Folder.PathOf($"out/{table.FileName}"));
            ParquetTable.Write(table, file, lines.Select((line, frame) => table.Encode(FrameOf(frame, line), line).ToPart()));
        }

        foreach (DocumentedTable table in DocumentedTable.All)
        {
            List<Dictionary<string, object?>> rows = Rows(table.Name);
            Assert.InRange(new LabelOracle(lines).Compare(table, rows), Lines / 2, int.MaxValue);
            Assert.All(table.Columns, column => Assert.Contains(rows, row => row[column.Name] is not null));
        }
    }

    [Fact]
    public void Every_field_of_the_schema_is_documented()
    {
        Dictionary<string, string> rows = new()
        {
            ["frames"] = "",
            ["joints"] = "objects[].joints[].",
            ["ignore_regions"] = "ignoreRegions[].",
            ["lanes"] = "lanes.",
            ["controls"] = "drive.",
            ["drive_ticks"] = "drive.ticks[].",
            ["lane_vehicles"] = "lanes.vehicles[].",
            ["imu"] = "imu.",
            ["gnss"] = "gnss.",
        };
        HashSet<string> documented =
        [
            .. DocumentedTable.All.SelectMany(table =>
                table.Columns.SelectMany(column =>
                {
                    string field = Regex.Replace(column.Field, @"\[\w+\]", "[]");
                    return table.Name switch
                    {
                        "indicators" => new[] { $"lanes.{field}", $"lanes.atCar.{field}", $"lanes.torcsEquivalent.{field.Split('.')[^1]}" },
                        "lane_lines" or "lane_points" => [$"lanes.boundaries[].{field}", $"lanes.markings[].{field}"],
                        var name => [Regex.Replace(rows.GetValueOrDefault(name, $"{name}[].") + field, @"\.+\[", "[")],
                    };
                })
            ),
        ];

        Assert.DoesNotContain(
            SchemaLabels.Leaves,
            leaf => !documented.Contains(leaf) && !documented.Contains(Regex.Replace(leaf, @"\[\]$", ""))
        );
    }

    [Fact]
    public void Documented_columns_types_and_units_are_those_of_the_files()
    {
        Dictionary<ColumnKind, string> types = new()
        {
            [ColumnKind.Integer] = "integer",
            [ColumnKind.Long] = "bigint",
            [ColumnKind.Number] = "double",
            [ColumnKind.Truth] = "boolean",
            [ColumnKind.Text] = "varchar",
            [ColumnKind.Word] = "varchar",
            [ColumnKind.Integers] = "integer[]",
            [ColumnKind.Numbers] = "double[]",
            [ColumnKind.Texts] = "varchar[]",
        };

        Assert.Equal(LabelTables.All.Select(table => table.Name), DocumentedTable.All.Select(table => table.Name));
        foreach ((LabelTable table, DocumentedTable documented) in LabelTables.All.Zip(DocumentedTable.All))
        {
            Assert.Equal(
                table.Columns.Select(column => (column.Name, types[column.Kind], column.Unit)),
                documented.Columns.Select(column => (column.Name, column.Type, column.Unit))
            );
        }
    }

    [Fact]
    public void Classes_are_dictionaries_and_units_are_metadata()
    {
        Folder.Export("parquet", simulated.Open());

        string objects = Folder.PathOf("out/objects.parquet");
        object? encodings = DuckTable.Query(
            $"SELECT encodings FROM parquet_metadata('{objects}') WHERE path_in_schema = 'class'",
            Folder.PathOf("out")
        )[0]["encodings"];
        Assert.Contains("DICTIONARY", encodings!.ToString(), StringComparison.Ordinal);
        object? metadata = DuckTable.Query(
            $"SELECT decode(value) AS value FROM parquet_kv_metadata('{objects}') WHERE decode(key) = 'gtaharvest.columns'",
            Folder.PathOf("out")
        )[0]["value"];
        Assert.Equal("m", Parse((string)metadata!).GetProperty("distance_metres").GetProperty("unit").GetString());
    }

    [Fact]
    public void Every_query_of_the_documentation_runs()
    {
        Folder.Export("parquet", simulated.Open());

        Assert.Equal(20, DocumentedTable.Queries.Count);
        Assert.All(DocumentedTable.Queries, query => DuckTable.Query(query, Folder.PathOf("out")));
    }

    private List<Dictionary<string, object?>> Rows(string table) =>
        DuckTable.Query($"SELECT * FROM '{table}.parquet'", Folder.PathOf("out"));

    private static TableFrame FrameOf(int frame, JsonElement line)
    {
        Dictionary<int, string> classes = line.GetProperty("objects")
            .EnumerateArray()
            .ToDictionary(item => item.GetProperty("id").GetInt32(), item => item.GetProperty("class").GetString()!);
        return new TableFrame(frame, 0, "train", $"images/{frame:D8}.png", classes.GetValueOrDefault, name => name);
    }

    private static JsonElement Parse(string text) => JsonDocument.Parse(text).RootElement;
}
