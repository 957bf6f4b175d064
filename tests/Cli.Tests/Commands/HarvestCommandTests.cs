using System.Text.Json;
using Harvester.Capture.Labels;
using Harvester.Capture.Scenes;
using Harvester.Datasets.Sessions;

namespace Harvester.Cli.Tests.Commands;

public sealed class HarvestCommandTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    private string Session => _folder.PathOf("session");

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Harvest_gives_a_valid_session_with_a_report_and_says_what_to_run_next()
    {
        CliRun run = Harvest(Session, "--frames", "3", "--masks");

        Assert.Equal("", run.Error);
        Assert.Equal(ExitCode.Done, run.ExitCode);
        Assert.Contains("\n3 frames, ", run.Out, StringComparison.Ordinal);
        Assert.Contains($"\nsession  {Session}\n", run.Out, StringComparison.Ordinal);
        Assert.Contains($"harvester validate {Session}\n", run.Out, StringComparison.Ordinal);
        Assert.True(File.Exists(Path.Combine(Session, "report.html")));
        Assert.Equal(3, Directory.GetFiles(Path.Combine(Session, "frames")).Length);
        Assert.Equal(3, Directory.GetFiles(Path.Combine(Session, "masks")).Length);

        CliRun validation = CliRun.Of("validate", Session);
        Assert.Equal(ExitCode.Done, validation.ExitCode);
        Assert.StartsWith($"{Session}: 3 frames, ", validation.Out, StringComparison.Ordinal);
    }

    [Fact]
    public void Harvest_labels_things_in_sight()
    {
        Harvest(Session, "--frames", "3");

        Assert.Contains(new SessionReader(Session).ReadLabels(), label => label.Objects.Count > 0);
    }

    [Fact]
    public void Harvest_twice_with_the_same_seed_gives_the_same_bytes()
    {
        string other = _folder.PathOf("other");
        Harvest(Session, "--frames", "3", "--masks", "--seed", "5");
        Harvest(other, "--frames", "3", "--masks", "--seed", "5");

        // The report's title is the folder's name, so it is left out here.
        Assert.Equal(Files(Session), Files(other));
        Assert.All(Files(Session), name => Assert.Equal(File.ReadAllBytes(Path.Combine(Session, name)), File.ReadAllBytes(Path.Combine(other, name))));
    }

    [Fact]
    public void Harvest_with_another_seed_gives_another_drive()
    {
        string other = _folder.PathOf("other");
        Harvest(Session, "--frames", "2", "--seed", "5");
        Harvest(other, "--frames", "2", "--seed", "6");

        Assert.NotEqual(File.ReadAllBytes(Path.Combine(Session, "labels.jsonl")), File.ReadAllBytes(Path.Combine(other, "labels.jsonl")));
    }

    [Fact]
    public void Harvest_takes_its_options_into_the_session()
    {
        Harvest(
            Session, "--frames", "2", "--seed", "9", "--fov", "60", "--hz", "20", "--weather", "rain", "--time", "18:30", "--range", "40",
            "--classes", "car,truck");

        FrameLabel[] labels = [.. new SessionReader(Session).ReadLabels()];
        Assert.All(labels, label => Assert.Equal((160, 120, 60.0), (label.Camera.Width, label.Camera.Height, label.Camera.VerticalFovDegrees)));
        Assert.All(labels, label => Assert.Equal("rain", label.Environment.Weather));
        Assert.Equal(18, labels[0].Environment.TimeOfDay.Hours);
        Assert.All(labels.SelectMany(label => label.Objects), item => Assert.True(item.Class is ObjectClass.Car or ObjectClass.Truck));

        using JsonDocument info = JsonDocument.Parse(File.ReadAllText(Path.Combine(Session, "session.json")));
        JsonElement options = info.RootElement.GetProperty("options");
        Assert.Equal(9, info.RootElement.GetProperty("seed").GetInt32());
        Assert.Equal((20.0, 40.0), (options.GetProperty("rateHz").GetDouble(), options.GetProperty("rangeMetres").GetDouble()));
    }

    [Fact]
    public void Harvest_of_a_game_with_quirks_is_valid_and_says_so()
    {
        const string quirks = "lag=2,lateCamera,heldCamera,creep=3,vanish=0.02,boxRays,missedRays=0.3";
        Harvest(Session, "--frames", "2", "--quirks", quirks);

        Assert.Equal(ExitCode.Done, CliRun.Of("validate", Session).ExitCode);
        Assert.Contains(quirks, File.ReadAllText(Path.Combine(Session, "session.json")), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("paused.heldCamera", "timeScale")]
    [InlineData("heldCamera,timeScale.restless", "paused")]
    [InlineData("paused.visibility,timeScale.weather", "timeScale")]
    public void Harvest_that_tries_the_ways_of_freezing_uses_the_better_one(string quirks, string better)
    {
        CliRun run = Harvest(Session, "--frames", "2", "--freeze", "auto", "--quirks", quirks);

        Assert.Equal((ExitCode.Done, ""), (run.ExitCode, run.Error));
        Assert.Matches($"(?mi)^freeze   Paused: .*; {better} is used[.]", run.Out);
        using JsonDocument info = JsonDocument.Parse(File.ReadAllText(Path.Combine(Session, "session.json")));
        Assert.Equal(better, info.RootElement.GetProperty("start").GetProperty("freezing").GetProperty("used").GetString());
        Assert.Equal(ExitCode.Done, CliRun.Of("validate", Session).ExitCode);
    }

    [Theory]
    [InlineData("--freeze", "slow", "--freeze takes paused, timeScale or auto, not 'slow'.")]
    [InlineData("--quirks", "pause.heldCamera", "--quirks takes some of lag=N, ")]
    [InlineData("--quirks", "paused.lag=2", "--quirks takes some of lag=N, ")]
    public void Harvest_refuses_what_is_no_way_of_freezing(string option, string value, string message)
    {
        CliRun run = Harvest(Session, option, value);

        Assert.Equal(ExitCode.Usage, run.ExitCode);
        Assert.Contains(message, run.Error, StringComparison.Ordinal);
        Assert.False(Directory.Exists(Session));
    }

    [Theory]
    [InlineData(7)]
    [InlineData(40)]
    public void Harvest_whose_picture_is_too_late_is_refused_and_leaves_no_folder(int lag)
    {
        Harvest(Session, "--frames", "2", "--seed", "3", "--hz", "2", "--quirks", $"lag={lag}").AssertFailed(
            ExitCode.HarvestFault, $"The picture is {lag} ticks behind the game, and the harvest allows for 4. Raise the limit (--max-picture-lag) and start again.");

        Assert.False(Directory.Exists(Session));
    }

    [Fact]
    public void Harvest_whose_picture_is_late_goes_ahead_where_that_is_allowed()
    {
        CliRun run = Harvest(Session, "--frames", "1", "--quirks", "lag=7", "--max-picture-lag", "7");

        Assert.Equal((ExitCode.Done, ""), (run.ExitCode, run.Error));
        Assert.Contains("\n1 frame, ", run.Out, StringComparison.Ordinal);
        Assert.DoesNotMatch(@"(?<![\d.])1 (frames|labels|objects)\b", run.Out);
    }

    [Theory]
    [InlineData("32x32")]
    [InlineData("300x32")]
    [InlineData("32x300")]
    public void Harvest_of_the_smallest_images_checks_its_camera(string size)
    {
        CliRun run = CliRun.Of("harvest", "--out", Session, "--size", size, "--frames", "1", "--no-report");

        Assert.Equal("", run.Error);
        Assert.DoesNotContain("\"cameraErrorPixels\": null", File.ReadAllText(Path.Combine(Session, "session.json")), StringComparison.Ordinal);
    }

    [Fact]
    public async Task Harvest_that_is_cancelled_leaves_a_valid_session()
    {
        // A thread of its own cancels once a frame is written: the pool's threads are busy rendering, and no time is right on every machine.
        using var cancellation = new CancellationTokenSource();
        var canceller = new Thread(() =>
        {
            var labels = new FileInfo(Path.Combine(Session, SessionReader.LabelsFile));
            while (!labels.Exists || labels.Length == 0)
            {
                Thread.Sleep(20);
                labels.Refresh();
            }

            cancellation.Cancel();
        })
        {
            IsBackground = true,
        };
        canceller.Start();

        CliRun run = await CliRun.StartAsync(
            "", cancellation.Token, "harvest", "--out", Session, "--size", "160x120", "--frames", "1000000");
        canceller.Join();

        run.AssertFailed(ExitCode.Cancelled, "the session is valid");
        Assert.Equal(ExitCode.Done, CliRun.Of("validate", Session).ExitCode);
    }

    [Theory]
    [InlineData("")]
    [InlineData("/below")]
    public void Harvest_into_a_file_is_refused(string below)
    {
        File.WriteAllText(_folder.PathOf("file"), "mine");

        Harvest(_folder.PathOf("file") + below).AssertFailed(ExitCode.InputOutput, "file' is a file. Name a folder with --out.");
    }

    [Fact]
    public void Harvest_into_a_session_asks_for_overwrite_and_then_replaces_it()
    {
        Harvest(Session, "--frames", "2");

        Harvest(Session, "--frames", "1").AssertFailed(ExitCode.Usage, "--overwrite");
        Assert.Equal(2, new SessionReader(Session).ReadLabels().Count());

        Assert.Equal(ExitCode.Done, Harvest(Session, "--frames", "1", "--overwrite").ExitCode);
        Assert.Single(Directory.GetFiles(Path.Combine(Session, "frames")));
    }

    [Fact]
    public void Harvest_that_cannot_begin_leaves_the_session_that_it_was_to_replace()
    {
        Harvest(Session, "--frames", "1");

        CliRun run = Harvest(Session, "--overwrite", "--roads", _folder.PathOf("nowhere.zip"));

        Assert.Equal(ExitCode.InputOutput, run.ExitCode);
        Assert.Single(new SessionReader(Session).ReadLabels());
    }

    [Fact]
    public void Harvest_into_a_session_with_other_files_leaves_both()
    {
        Harvest(Session, "--frames", "1");
        string notes = Path.Combine(Session, "notes.txt");
        File.WriteAllText(notes, "mine");

        Harvest(Session, "--overwrite").AssertFailed(ExitCode.Usage, "'notes.txt'");

        Assert.True(File.Exists(notes));
        Assert.Single(new SessionReader(Session).ReadLabels());
    }

    [Fact]
    public void Harvest_into_empty_folders_as_a_full_disk_leaves_them_goes_ahead()
    {
        Directory.CreateDirectory(Path.Combine(Session, "frames"));

        Assert.Equal(ExitCode.Done, Harvest(Session, "--frames", "1").ExitCode);
    }

    [Fact]
    public void Harvest_never_replaces_what_is_no_session()
    {
        _folder.File("precious.txt", "mine");

        Harvest(_folder.Path, "--overwrite").AssertFailed(ExitCode.Usage, "holds no session");

        Assert.True(File.Exists(_folder.PathOf("precious.txt")));
    }

    [Theory]
    [InlineData("harvest", "800", "32 to 8192 each, as 800x600, not '800'")]
    [InlineData("serve", "8x8", "32 to 8192 each")]
    [InlineData("calibrate", "800", "288x216 to 8192x8192, as 800x600, not '800'")]
    [InlineData("project", "800", "1 to 65535 each")]
    public void Size_that_cannot_be_is_refused_with_the_limits_of_its_command(string command, string size, string limits) =>
        CliRun.Of([command, "--size", size, .. Required(command)]).AssertFailed(ExitCode.Usage, limits);

    [Fact]
    public void Harvest_of_a_view_too_wide_to_check_names_the_options_of_the_command()
    {
        CliRun run = CliRun.Of("harvest", "--out", Session, "--frames", "1", "--size", "320x240", "--seed", "4", "--fov", "170", "--no-report");

        Assert.Equal(ExitCode.HarvestFault, run.ExitCode);
        Assert.Contains("a smaller field of view (--fov). --max-camera-error 0 harvests without this check.", run.Error, StringComparison.Ordinal);
        Assert.DoesNotContain("ini", run.Error, StringComparison.Ordinal);
        Assert.Equal(
            ExitCode.Done,
            CliRun.Of("harvest", "--out", Session, "--frames", "1", "--size", "320x240", "--seed", "4", "--fov", "170", "--no-report", "--max-camera-error", "0").ExitCode);
    }

    [Fact]
    public void Harvest_through_a_lens_labels_what_its_pictures_show()
    {
        // A shift by 0.1 of 160 pixels; the check of the camera model holds the labels' camera against the pictures.
        CliRun run = CliRun.Of(
            "harvest", "--out", Session, "--frames", "1", "--size", "160x120", "--no-report", "--centre-offset", "0.1,0", "--focal-scale", "1.05", "--k1", "-0.05");

        Assert.Equal((ExitCode.Done, ""), (run.ExitCode, run.Error));
        using var label = System.Text.Json.JsonDocument.Parse(File.ReadLines(Path.Combine(Session, "labels.jsonl")).First());
        System.Text.Json.JsonElement camera = label.RootElement.GetProperty("camera");

        // Half of 160 and a tenth of it.
        Assert.Equal(96, camera.GetProperty("cx").GetDouble(), 1e-6);
        Assert.Equal(-0.05, camera.GetProperty("distortion").GetProperty("k1").GetDouble(), 1e-9);
    }

    [Fact]
    public void Next_command_of_a_folder_with_a_space_can_be_pasted()
    {
        CliRun run = CliRun.Of("harvest", "--out", Session + " 2", "--frames", "1", "--size", "64x48", "--no-report");

        Assert.Contains($"validate {ShellWord.Of(Session + " 2")}\n", run.Out, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("--frames", "0")]
    [InlineData("--frames", "many")]
    [InlineData("--seed", "-1")]
    [InlineData("--size", "8x8")]
    [InlineData("--size", "31x300")]
    [InlineData("--size", "300x31")]
    [InlineData("--size", "65535x65535")]
    [InlineData("--size", "0x600")]
    [InlineData("--fov", "180")]
    [InlineData("--k1", "2")]
    [InlineData("--centre-offset", "2,0")]
    [InlineData("--max-camera-error", "-1")]
    [InlineData("--fov", "0.5")]
    [InlineData("--range", "1e300")]
    [InlineData("--hz", "0")]
    [InlineData("--hz", "61")]
    [InlineData("--range", "0")]
    [InlineData("--weather", "sunshine")]
    [InlineData("--quirks", "lag")]
    [InlineData("--max-picture-lag", "61")]
    [InlineData("--quirks", "lag=2,lateCamera=1")]
    [InlineData("--quirks", "vanish=1.5")]
    [InlineData("--time", "25:00")]
    [InlineData("--time", "noon")]
    [InlineData("--near", "1")]
    [InlineData("--classes", "car,plane")]
    public void Harvest_with_an_impossible_value_is_a_usage_error_and_writes_nothing(string option, string value)
    {
        CliRun.Of("harvest", "--out", Session, option, value).AssertFailed(ExitCode.Usage, option);

        Assert.False(Directory.Exists(Session));
    }

    [Fact]
    public void Harvest_without_out_is_a_usage_error() => CliRun.Of("harvest").AssertFailed(ExitCode.Usage, "--out");

    [Fact]
    public void Harvest_on_roads_that_are_not_there_is_an_input_error()
    {
        CliRun run = Harvest(Session, "--roads", "no-such-roads.zip");

        Assert.Equal(ExitCode.InputOutput, run.ExitCode);
        Assert.Contains("no-such-roads.zip", run.Error, StringComparison.Ordinal);
    }

    [Fact]
    public void Harvest_on_roads_that_are_none_is_a_data_error()
    {
        string roads = _folder.File("roads.json", "not roads");

        CliRun run = Harvest(Session, "--roads", roads);

        Assert.Equal(ExitCode.BadData, run.ExitCode);
        Assert.Contains("roads.json", run.Error, StringComparison.Ordinal);
    }

    [Fact]
    public void Harvest_with_props_sets_them_up_and_notes_their_file()
    {
        string lamps = _folder.File("lamps.json", """[{ "Name": "prop_streetlight_01", "Position": { "X": 1, "Y": 2, "Z": 3 }, "Rotation": { "X": 0, "Y": 0, "Z": 90 } }]""");

        Assert.Equal(ExitCode.Done, Harvest(Session, "--frames", "1", "--props", lamps).ExitCode);

        using JsonDocument info = JsonDocument.Parse(File.ReadAllText(Path.Combine(Session, "session.json")));
        Assert.Equal("lamps.json", info.RootElement.GetProperty("settings").GetProperty("props").GetString());
    }

    [Fact]
    public void Harvest_with_props_that_are_none_is_a_data_error() =>
        Harvest(Session, "--props", _folder.File("lamps.json", "{}")).AssertFailed(ExitCode.BadData, "lamps.json");

    private static CliRun Harvest(string session, params string[] arguments) =>
        CliRun.Of(["harvest", "--out", session, "--size", "160x120", .. arguments]);

    private static List<string> Files(string session) =>
        [.. Directory.EnumerateFiles(session, "*", SearchOption.AllDirectories)
            .Select(path => Path.GetRelativePath(session, path))
            .Where(name => name != "report.html")
            .Order(StringComparer.Ordinal)];

    /// <summary>What a command asks for besides the size.</summary>
    private string[] Required(string command) => command switch
    {
        "harvest" => ["--out", Session],
        "project" => ["--position", "0,0,0", "--rotation", "0,0,0", "--fov", "50"],
        _ => [],
    };
}
