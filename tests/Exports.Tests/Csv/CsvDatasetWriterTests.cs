namespace Harvester.Exports.Tests.Csv;

public sealed class CsvDatasetWriterTests : ExportTests
{
    [Fact]
    public void Objects_have_their_label_values_and_empty_unknown_fields()
    {
        Folder.Export("csv", Session.Open());

        IReadOnlyList<Dictionary<string, string>> rows = Read("out/objects.csv");
        Assert.Equal(6, rows.Count);
        Dictionary<string, string> pedestrian = rows[3];
        Assert.Equal(("1", "2", "pedestrian"), (pedestrian["frame"], pedestrian["id"], pedestrian["class"]));
        Assert.Equal("82", pedestrian["box2d_amodal_xmax"]);
        Assert.Equal(("0.2", "", ""), (pedestrian["truncated_fraction"], pedestrian["occluded_fraction"], pedestrian["visible_fraction"]));
        Assert.Equal(("", "6", "7.8102"), (pedestrian["box2d_visible_xmin"], pedestrian["centre_x"], pedestrian["distance_metres"]));
        Assert.Equal("0.75", rows[2]["visible_fraction"]);
    }

    [Fact]
    public void Visible_fraction_is_that_of_the_session()
    {
        // (1 - 0)(1 - 0.25) would be 0.75.
        Session.Car(0)["visibleFraction"] = 0.7501;
        Folder.Export("csv", Session.Open());

        Assert.Equal("0.7501", Read("out/objects.csv")[0]["visible_fraction"]);
    }

    [Fact]
    public void Frames_name_existing_images()
    {
        Folder.Export("csv", Session.Open());

        IReadOnlyList<Dictionary<string, string>> rows = Read("out/frames.csv");
        Assert.Equal(["0", "1", "2"], rows.Select(row => row["frame"]));
        Assert.All(rows, row => Assert.True(File.Exists(Folder.PathOf("out/" + row["image"]))));
        Assert.Equal(("30", "40", "train", "13:05:00"), (rows[0]["fx"], rows[0]["cx"], rows[0]["split"], rows[0]["time_of_day"]));
    }

    [Fact]
    public void Names_with_commas_and_quotes_survive_a_round_trip()
    {
        Session.Car(0)["name"] = "Stop, \"all way\"";
        Folder.Export("csv", Session.Open());

        Assert.Equal("Stop, \"all way\"", Read("out/objects.csv")[0]["name"]);
    }

    /// <summary>RFC 4180: fields between commas, quoted ones may hold commas, and a doubled quote stands for one.</summary>
    private IReadOnlyList<Dictionary<string, string>> Read(string name)
    {
        List<List<string>> records = [.. Folder.Lines(name).Select(Fields)];
        Assert.All(records, record => Assert.Equal(records[0].Count, record.Count));
        return [.. records.Skip(1).Select(record => records[0].Zip(record).ToDictionary(pair => pair.First, pair => pair.Second))];
    }

    private static List<string> Fields(string line)
    {
        var fields = new List<string> { "" };
        bool quoted = false;
        for (int i = 0; i < line.Length; i++)
        {
            if (line[i] == '"' && quoted && i + 1 < line.Length && line[i + 1] == '"')
            {
                fields[^1] += '"';
                i++;
            }
            else if (line[i] == '"')
            {
                quoted = !quoted;
            }
            else if (line[i] == ',' && !quoted)
            {
                fields.Add("");
            }
            else
            {
                fields[^1] += line[i];
            }
        }

        return fields;
    }
}
