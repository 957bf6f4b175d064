using Harvester.Cli.Terminals;
using Harvester.Geometry;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Roads;

namespace Harvester.Cli.Tests.Commands;

public sealed class RelabelCommandTests(HarvestedShards harvested) : IClassFixture<HarvestedShards>, IDisposable
{
    private const string Lens = "; of a calibration\nFocalScale = 1.02\nCentreOffsetX = 0.001\nCentreOffsetY = 0\nK1 = -0.03\nK2 = 0\n";

    private readonly TemporaryFolder _folder = new();

    private string Session => harvested.PathOf("whole/session");

    private string Made => _folder.PathOf("made");

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Relabel_without_options_reproduces_the_labels()
    {
        CliRun run = Relabel();

        Assert.Equal((ExitCode.Done, ""), (run.ExitCode, run.Error));
        Assert.EndsWith($"{Made}: 8 frames\n", run.Out, StringComparison.Ordinal);
        Assert.Equal(File.ReadAllBytes(Path.Combine(Session, "labels.jsonl")), File.ReadAllBytes(Path.Combine(Made, "labels.jsonl")));
        Assert.All(
            Directory.GetFiles(Path.Combine(Session, "masks")),
            mask => Assert.Equal(File.ReadAllBytes(mask), File.ReadAllBytes(Path.Combine(Made, "masks", Path.GetFileName(mask))))
        );
        Assert.Equal(
            File.ReadAllText(Path.Combine(Session, "session.json"))
                .Replace("\"scenes\": true", "\"scenes\": false", StringComparison.Ordinal),
            Without("relabelledBy", File.ReadAllText(Path.Combine(Made, "session.json")))
        );
        Assert.True(File.Exists(Path.Combine(Made, "report.html")));
    }

    [Fact]
    public void Relabel_in_shards_merges_to_the_bytes_of_a_single_run()
    {
        string[] options = ["--lane-width", "3.7", "--look-ahead", "1s", "--range", "70"];
        Relabel(options);
        foreach (string number in (string[])["1", "2"])
        {
            string part = _folder.PathOf("part-" + number);
            CliRun run = CliRun.Of(["relabel", Session, "--out", part, .. options, "--shard", number + "/2"]);
            Assert.EndsWith(
                $"{part}: shard {number}/2, 4 frames. When all shards are done, merge them: harvester merge SHARD... --out DIR\n",
                run.Out,
                StringComparison.Ordinal
            );
        }

        CliRun.Of("merge", _folder.PathOf("part-2"), _folder.PathOf("part-1"), "--out", _folder.PathOf("merged/made"));

        foreach (string file in Directory.EnumerateFiles(Made, "*", SearchOption.AllDirectories))
        {
            Assert.Equal(
                File.ReadAllBytes(file),
                File.ReadAllBytes(Path.Combine(_folder.PathOf("merged/made"), Path.GetRelativePath(Made, file)))
            );
        }
    }

    [Theory]
    [InlineData("")]
    [InlineData("[Harvest]\nRate = 5\n[Lens]\n")]
    public void Relabel_by_a_calibration_moves_the_camera_and_drops_masks(string before)
    {
        CliRun run = Relabel("--calibration", _folder.File("lens.ini", before + Lens));

        Assert.Equal("", run.Error);
        Assert.All(
            new SessionReader(Made).ReadLabels(),
            label =>
                Assert.Equal((new DistortionLabel(1.02, -0.03, 0), 80.16, null), (label.Camera.Distortion, label.Camera.Cx, label.Mask))
        );
        Assert.Equal(ExitCode.Done, CliRun.Of("validate", Made).ExitCode);
    }

    [Theory]
    [InlineData("K1 = -0.03\n", "", "K1 is missing")]
    [InlineData("FocalScale = 1.02", "FocalScale = 12", "FocalScale is '12', which is not a valid value for a lens")]
    [InlineData("FocalScale = 1.02", "FocalScale = wide", "FocalScale is 'wide', which is not a valid value for a lens")]
    public void Relabel_by_a_calibration_without_a_lens_is_a_data_error(string good, string bad, string message) =>
        Relabel("--calibration", _folder.File("lens.txt", Lens.Replace(good, bad, StringComparison.Ordinal)))
            .AssertFailed(ExitCode.BadData, message);

    [Fact]
    public void Lanes_of_narrow_roads_have_the_width_given_by_the_option()
    {
        string roads = _folder.File("roads.csv", NarrowStreet());
        string session = _folder.PathOf("session");
        string[] harvest = ["harvest", "--out", session, "--roads", roads, "--frames", "2", "--size", "64x48", "--no-report"];
        Assert.Equal("", CliRun.Of([.. harvest, "--narrow-lane-width", "3.5"]).Error);

        CliRun kept = CliRun.Of("relabel", session, "--out", _folder.PathOf("kept"), "--roads", roads);
        CliRun narrower = CliRun.Of("relabel", session, "--out", _folder.PathOf("narrower"), "--roads", roads, "--narrow-lane-width", "3");

        Assert.Equal(("", ""), (kept.Error, narrower.Error));
        Assert.Equal([3.5], Widths("session"));
        Assert.Equal([3.5], Widths("kept"));
        Assert.Equal([3.0], Widths("narrower"));
        Assert.Contains(
            "\"narrowLaneWidth\": \"3\"",
            File.ReadAllText(Path.Combine(_folder.PathOf("narrower"), "session.json")),
            StringComparison.Ordinal
        );

        IEnumerable<double?> Widths(string name) =>
            new SessionReader(_folder.PathOf(name)).ReadLabels().Select(label => label.Lanes!.LaneWidthMetres).Distinct();
    }

    [Theory]
    [InlineData("metres")]
    [InlineData("0")]
    public void Relabel_reports_a_session_with_an_invalid_lane_width(string width)
    {
        string session = _folder.PathOf("session");
        SharedHarvest.CopyTo(session, "--frames", "1", "--seed", "5", "--size", "64x48", "--masks", "--no-report");
        string header = Path.Combine(session, "session.json");
        File.WriteAllText(
            header,
            File.ReadAllText(header).Replace("\"laneWidth\": \"5.4\"", $"\"laneWidth\": \"{width}\"", StringComparison.Ordinal)
        );

        CliRun
            .Of("relabel", session, "--out", Made)
            .AssertFailed(ExitCode.BadData, $"settings.laneWidth must be metres above 0, not '{width}'");
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Relabel_accepts_a_survey_folder_as_harvest_does()
    {
        string survey = Directory.CreateDirectory(_folder.PathOf("survey")).FullName + Path.DirectorySeparatorChar;
        File.WriteAllText(Path.Combine(survey, "spaces.csv"), "# none\n");
        string session = _folder.PathOf("session");

        CliRun harvest = CliRun.Of("harvest", "--out", session, "--frames", "1", "--size", "64x48", "--no-report", "--spaces", survey);
        CliRun relabel = Relabel("--spaces", survey);

        Assert.Equal(("", ""), (harvest.Error, relabel.Error));
        Assert.All(
            [session, Made],
            folder =>
                Assert.Contains("\"spaces\": \"survey\"", File.ReadAllText(Path.Combine(folder, "session.json")), StringComparison.Ordinal)
        );
    }

    [Fact]
    public void Relabel_onto_the_session_itself_is_refused() =>
        CliRun
            .Of("relabel", Session, "--out", Session + "/.", "--overwrite")
            .AssertFailed(ExitCode.Usage, "is the recorded session itself");

    [Fact]
    public void Relabel_onto_another_session_requires_overwrite()
    {
        Relabel("--classes", "car");

        Relabel("--classes", "bus").AssertFailed(ExitCode.Usage, "--overwrite");
        Assert.Equal(ExitCode.Done, Relabel("--classes", "bus", "--overwrite", "--no-report").ExitCode);
        Assert.False(File.Exists(Path.Combine(Made, "report.html")));
    }

    [Fact]
    public void Relabel_of_a_shard_asks_to_merge_first() =>
        CliRun
            .Of("relabel", harvested.PathOf("part-1"), "--out", Made)
            .AssertFailed(ExitCode.BadData, "is shard 1/3 of a session. Merge the shards first");

    [Theory]
    [InlineData("--range", "0", "--range takes a number greater than 0")]
    [InlineData("--max-occluded", "2", "--max-occluded takes a number from 0 to 1")]
    [InlineData("--lane-width", "1", "--lane-width takes a number from 2 to 10")]
    [InlineData("--look-ahead", "6s", "--look-ahead takes metres from 0 to 70, or seconds from 0 to 5, e.g. 1s")]
    public void Relabel_with_an_impossible_value_names_the_accepted_ones(string option, string value, string message) =>
        Relabel(option, value).AssertFailed(ExitCode.Usage, message);

    private static string NarrowStreet()
    {
        RoadNode[] nodes = [.. Enumerable.Range(0, 31).Select(i => new RoadNode(0, i, new Vector3D(0, 10 * i, 0), "", RoadNodeFlags.None))];
        var street = new RoadNetwork(
            nodes,
            [.. Enumerable.Range(0, 30).Select(i => new RoadLink(i, i + 1, 2, 2, 0, RoadLinkFlags.NarrowRoad))]
        );
        using var text = new StringWriter();
        RoadCsvWriter.Write(street, text);
        return text.ToString();
    }

    private CliRun Relabel(params string[] options) => CliRun.Of(["relabel", Session, "--out", Made, .. options]);

    private static string Without(string setting, string header) =>
        System.Text.RegularExpressions.Regex.Replace(header, $",\n    \"{setting}\": \"[^\"]*\"", "");
}
