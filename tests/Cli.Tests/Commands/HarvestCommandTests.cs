using System.Text.Json;
using Harvester.Cli.Terminals;
using Harvester.Runs.Supervising;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Scenes;

namespace Harvester.Cli.Tests.Commands;

public sealed class HarvestCommandTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    private string Session => _folder.PathOf("session");

    public void Dispose() => _folder.Dispose();

    [Fact]
    [Trait("Category", "Heavy")]
    public void Harvest_writes_a_valid_session_and_names_the_next_command()
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
    public void Harvest_labels_visible_objects()
    {
        Harvest(Session, "--frames", "3");

        Assert.Contains(new SessionReader(Session).ReadLabels(), label => label.Objects.Count > 0);
    }

    [Fact]
    public void Harvest_twice_with_the_same_seed_gives_the_same_bytes()
    {
        string other = _folder.PathOf("other");
        Harvest(Session, "--frames", "2", "--masks", "--seed", "5");
        Harvest(other, "--frames", "2", "--masks", "--seed", "5");

        // The report's title is the folder's name, so it is left out here.
        Assert.Equal(Files(Session), Files(other));
        Assert.All(
            Files(Session),
            name => Assert.Equal(File.ReadAllBytes(Path.Combine(Session, name)), File.ReadAllBytes(Path.Combine(other, name)))
        );
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Harvest_with_another_seed_gives_another_drive()
    {
        string other = _folder.PathOf("other");
        Harvest(Session, "--frames", "2", "--seed", "5");
        Harvest(other, "--frames", "2", "--seed", "6");

        Assert.NotEqual(File.ReadAllBytes(Path.Combine(Session, "labels.jsonl")), File.ReadAllBytes(Path.Combine(other, "labels.jsonl")));
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Harvest_records_its_options_in_the_session()
    {
        Harvest(
            Session,
            "--frames",
            "2",
            "--seed",
            "5",
            "--fov",
            "60",
            "--hz",
            "20",
            "--weather",
            "rain",
            "--time",
            "18:30",
            "--range",
            "40",
            "--classes",
            "car,truck"
        );

        FrameLabel[] labels = [.. new SessionReader(Session).ReadLabels()];
        Assert.All(
            labels,
            label => Assert.Equal((160, 120, 60.0), (label.Camera.Width, label.Camera.Height, label.Camera.VerticalFovDegrees))
        );
        Assert.All(labels, label => Assert.Equal("rain", label.Environment.Weather));
        Assert.Equal(18, labels[0].Environment.TimeOfDay.Hours);
        Assert.All(labels.SelectMany(label => label.Objects), item => Assert.True(item.Class is ObjectClass.Car or ObjectClass.Truck));

        using JsonDocument info = JsonDocument.Parse(File.ReadAllText(Path.Combine(Session, "session.json")));
        JsonElement options = info.RootElement.GetProperty("options");
        Assert.Equal(5, info.RootElement.GetProperty("seed").GetInt32());
        Assert.Equal((20.0, 40.0), (options.GetProperty("rateHz").GetDouble(), options.GetProperty("rangeMetres").GetDouble()));
    }

    [Fact]
    public void Harvest_of_a_game_with_quirks_is_valid_and_lists_them()
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
    [Trait("Category", "Heavy")]
    public void Harvest_that_tries_freeze_methods_uses_the_better_one(string quirks, string better)
    {
        CliRun run = Harvest(Session, "--frames", "2", "--freeze", "auto", "--quirks", quirks);

        Assert.Equal((ExitCode.Done, ""), (run.ExitCode, run.Error));
        Assert.Matches($"(?mi)^freeze   Paused: .*; {better} is used[.]", run.Out);
        using JsonDocument info = JsonDocument.Parse(File.ReadAllText(Path.Combine(Session, "session.json")));
        Assert.Equal(better, info.RootElement.GetProperty("start").GetProperty("freezing").GetProperty("used").GetString());
        Assert.Equal(ExitCode.Done, CliRun.Of("validate", Session).ExitCode);
    }

    [Fact]
    public void Harvest_with_picture_lag_proceeds_when_allowed()
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
    [Trait("Category", "Heavy")]
    public void Harvest_of_the_smallest_images_checks_its_camera(string size)
    {
        CliRun run = CliRun.Of("harvest", "--out", Session, "--size", size, "--frames", "1", "--no-report");

        Assert.Equal("", run.Error);
        Assert.DoesNotContain(
            "\"cameraErrorPixels\": null",
            File.ReadAllText(Path.Combine(Session, "session.json")),
            StringComparison.Ordinal
        );
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public async Task Cancelled_harvest_leaves_a_valid_session()
    {
        // A thread of its own cancels once a frame is written: the pool's threads are busy rendering, and no time is right on every
        // machine.
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
            "",
            cancellation.Token,
            "harvest",
            "--out",
            Session,
            "--size",
            "160x120",
            "--frames",
            "1000000"
        );
        canceller.Join();

        run.AssertFailed(ExitCode.Cancelled, "the session is valid");
        Assert.Equal(ExitCode.Done, CliRun.Of("validate", Session).ExitCode);
    }

    [Fact]
    public void Harvest_into_empty_folders_left_by_a_full_disk_proceeds()
    {
        Directory.CreateDirectory(Path.Combine(Session, "frames"));

        Assert.Equal(ExitCode.Done, Harvest(Session, "--frames", "1").ExitCode);
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Harvest_through_a_lens_labels_what_its_pictures_show()
    {
        // A shift by 0.1 of 160 pixels; the check of the camera model compares the labels' camera with the pictures.
        CliRun run = CliRun.Of(
            "harvest",
            "--out",
            Session,
            "--frames",
            "1",
            "--size",
            "160x120",
            "--no-report",
            "--centre-offset",
            "0.1,0",
            "--focal-scale",
            "1.05",
            "--k1",
            "-0.05"
        );

        Assert.Equal((ExitCode.Done, ""), (run.ExitCode, run.Error));
        using var label = System.Text.Json.JsonDocument.Parse(File.ReadLines(Path.Combine(Session, "labels.jsonl")).First());
        System.Text.Json.JsonElement camera = label.RootElement.GetProperty("camera");

        // Half of 160 and a tenth of it.
        Assert.Equal(96, camera.GetProperty("cx").GetDouble(), 1e-6);
        Assert.Equal(-0.05, camera.GetProperty("distortion").GetProperty("k1").GetDouble(), 1e-9);
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Next_command_of_a_folder_with_a_space_can_be_pasted()
    {
        CliRun run = CliRun.Of("harvest", "--out", Session + " 2", "--frames", "1", "--size", "64x48", "--no-report");

        Assert.Contains($"validate {ShellWord.Of(Session + " 2")}\n", run.Out, StringComparison.Ordinal);
    }

    [Fact]
    public void Harvest_with_props_places_them_and_records_their_file()
    {
        string lamps = _folder.File(
            "lamps.json",
            """[{ "Name": "prop_streetlight_01", "Position": { "X": 1, "Y": 2, "Z": 3 }, "Rotation": { "X": 0, "Y": 0, "Z": 90 } }]"""
        );

        Assert.Equal(ExitCode.Done, Harvest(Session, "--frames", "1", "--props", lamps).ExitCode);

        using JsonDocument info = JsonDocument.Parse(File.ReadAllText(Path.Combine(Session, "session.json")));
        Assert.Equal("lamps.json", info.RootElement.GetProperty("settings").GetProperty("props").GetString());
    }

    private static CliRun Harvest(string session, params string[] arguments) =>
        CliRun.Of(["harvest", "--out", session, "--size", "160x120", .. arguments]);

    private static List<string> Files(string session) =>
        [
            .. Directory
                .EnumerateFiles(session, "*", SearchOption.AllDirectories)
                .Select(path => Path.GetRelativePath(session, path))
                .Where(name => name != "report.html")
                .Order(StringComparer.Ordinal),
        ];
}
