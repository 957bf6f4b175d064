using System.Formats.Tar;
using System.Globalization;
using System.Text.Json;

namespace Harvester.Cli.Tests.Driving;

/// <summary>Sessions that drives record, read as JSON: nothing here shares code with their reader.</summary>
public sealed class RecordedDriveTests
{
    /// <summary>Times and numbers are written with six decimals.</summary>
    private const double Rounding = 2e-6;

    [Fact]
    [Trait("Category", "Heavy")]
    public void Recorded_drive_is_a_valid_session_and_repeatable()
    {
        using TemporaryFolder folder = new();
        Drive(folder, "one", "--distance", "60", "--weather", "rain", "--time", "18:30");
        Drive(folder, "two", "--distance", "60", "--weather", "rain", "--time", "18:30");

        CliRun.Of("validate", folder.PathOf("one-session"), "--schema").AssertDone();
        string[] files = [.. Directory.EnumerateFiles(folder.PathOf("one-session"), "*", SearchOption.AllDirectories)];
        Assert.True(files.Length > 20);
        Assert.All(
            files,
            file =>
                Assert.Equal(
                    File.ReadAllBytes(file),
                    File.ReadAllBytes(file.Replace("one-session", "two-session", StringComparison.Ordinal))
                )
        );
        JsonElement line = Lines(folder.PathOf("one-session"))[0];
        Assert.Equal("rain", line.GetProperty("environment").GetProperty("weather").GetString());
        Assert.Equal(13, line.GetProperty("lanes").GetProperty("indicators").EnumerateObject().Count());
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Recording_does_not_change_the_drive()
    {
        using TemporaryFolder folder = new();
        Drive(folder, "recorded", "--distance", "60");
        CliRun.Of("drive", "--out", folder.PathOf("plain"), "--distance", "60", "--seed", "1").AssertDone();

        Assert.Equal(File.ReadAllBytes(folder.PathOf("plain/drive.json")), File.ReadAllBytes(folder.PathOf("recorded/drive.json")));
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Each_frame_has_the_action_that_moved_the_car_after_it()
    {
        using TemporaryFolder folder = new();
        Drive(folder, "drive", "--distance", "150");
        JsonElement[] lines = Lines(folder.PathOf("drive-session"));

        Assert.Contains(lines, line => Driver(line) == "controller");
        Assert.Contains(lines, line => Driver(line) == "builtIn");
        foreach ((JsonElement frame, JsonElement next) in lines.Zip(lines.Skip(1)))
        {
            JsonElement drive = frame.GetProperty("drive");
            JsonElement[] ticks = [.. drive.GetProperty("ticks").EnumerateArray()];
            Assert.Equal(4, ticks.Length);
            Assert.Equal(Number(next, "timeSeconds"), Number(ticks[^1], "timeSeconds"), Rounding);
            Assert.Equal(Number(frame, "timeSeconds") + 0.05, Number(ticks[0], "timeSeconds"), Rounding);
            Assert.Equal(Controls(drive, "controls"), Controls(drive, "applied"));

            // The controls that the car reports at the next frame were those of the last tick.
            Assert.Equal(Number(next.GetProperty("ego"), "steering"), Number(ticks[^1].GetProperty("applied"), "steering"), 1e-4);
        }
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Inertial_sensor_agrees_with_the_speeds_of_the_ticks()
    {
        using TemporaryFolder folder = new();
        Drive(folder, "drive", "--distance", "80");
        JsonElement[] ticks =
        [
            .. Lines(folder.PathOf("drive-session")).SelectMany(line => line.GetProperty("drive").GetProperty("ticks").EnumerateArray()),
        ];

        // The origin is ahead of the axle that moves straight ahead, so the speed also has a part sideways while the car turns.
        const double sideways = 1;
        foreach ((JsonElement before, JsonElement tick) in ticks.Zip(ticks.Skip(1)))
        {
            double seconds = Number(tick, "timeSeconds") - Number(before, "timeSeconds");
            double change = (Number(tick, "speed") - Number(before, "speed")) / seconds;
            Assert.Equal(change, tick.GetProperty("acceleration")[1].GetDouble(), sideways);
        }

        Assert.Contains(ticks, tick => Math.Abs(tick.GetProperty("angularRate")[2].GetDouble()) > 0.05);
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Disturbed_frames_record_the_undisturbed_answer()
    {
        using TemporaryFolder folder = new();
        Drive(folder, "one", "--distance", "120", "--perturb");
        Drive(folder, "two", "--distance", "120", "--perturb");
        JsonElement[] drives = [.. Lines(folder.PathOf("one-session")).Select(line => line.GetProperty("drive"))];
        JsonElement[] disturbed = [.. drives.Where(drive => drive.GetProperty("disturbed").GetBoolean())];

        Assert.InRange(disturbed.Length, 5, drives.Length / 2);
        Assert.All(
            disturbed,
            drive =>
            {
                Assert.NotEqual(Controls(drive, "controls")[0], Controls(drive, "applied")[0]);
                Assert.Equal(Controls(drive, "controls")[1..], Controls(drive, "applied")[1..]);
            }
        );
        Assert.All(drives.Except(disturbed), drive => Assert.Equal(Controls(drive, "controls"), Controls(drive, "applied")));
        Assert.Equal(
            File.ReadAllBytes(folder.PathOf("one-session/labels.jsonl")),
            File.ReadAllBytes(folder.PathOf("two-session/labels.jsonl"))
        );
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Drive_over_a_bridge_is_recorded_from_its_frames()
    {
        using TemporaryFolder folder = new();
        Drive(folder, "drive", "--distance", "30", "--bridge", "socket");
        JsonElement[] drives = [.. Lines(folder.PathOf("drive-session")).Select(line => line.GetProperty("drive"))];

        CliRun.Of("validate", folder.PathOf("drive-session"), "--schema").AssertDone();
        Assert.Contains(drives, drive => drive.GetProperty("driver").GetString() == "client");
        long[] frames = [.. drives.Select(drive => drive.GetProperty("bridgeFrame").GetInt64())];
        Assert.Equal(frames.Order().Distinct(), frames);
        Assert.All(drives[1..^1], drive => Assert.Equal(Controls(drive, "controls"), Controls(drive, "applied")));
    }

    [Theory]
    [InlineData("stanley", 10)]
    [InlineData("deepdriving", 20)]
    [Trait("Category", "Heavy")]
    public void Controller_tells_what_it_aims_at(string controller, double maxSpeed)
    {
        using TemporaryFolder folder = new();
        Drive(folder, "drive", "--distance", "60", "--controller", controller, "--traffic", "0", "--speed", $"{maxSpeed}");
        JsonElement[] lines = Lines(folder.PathOf("drive-session"));

        Assert.All(
            lines,
            line =>
                Assert.Equal(Driver(line) != "controller", line.GetProperty("drive").GetProperty("target").ValueKind == JsonValueKind.Null)
        );
        JsonElement[] driven = [.. lines.Where(line => Driver(line) == "controller")];
        Assert.All(driven, line => Assert.InRange(Number(Target(line), "speed"), 0.1, maxSpeed));
        Assert.Contains(driven, line => Number(Target(line), "speed") > 0.9 * maxSpeed);

        // The car keeps to the middle of its lane within a few decimetres, and the line to steer to is that middle.
        JsonElement[] aimed = [.. driven.Where(line => Target(line).GetProperty("rightMetres").ValueKind == JsonValueKind.Number)];
        Assert.Equal(controller == "stanley" ? driven.Length : 0, aimed.Length);
        Assert.All(aimed, line => Assert.InRange(Number(Target(line), "rightMetres"), -1, 1));
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Several_starts_give_a_session_each()
    {
        using TemporaryFolder folder = new();
        Drive(folder, "drive", "--distance", "10", "--near", "0,0", "--near", "50,50");

        CliRun.Of("validate", folder.PathOf("drive-session/0001")).AssertDone();
        CliRun.Of("validate", folder.PathOf("drive-session/0002")).AssertDone();
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Exports_keep_the_action_of_each_image()
    {
        using TemporaryFolder folder = new();
        Drive(folder, "drive", "--distance", "40");
        string session = folder.PathOf("drive-session");
        CliRun.Of("export", session, "--format", "webdataset", "--out", folder.PathOf("tar")).AssertDone();
        CliRun.Of("export", session, "--format", "csv", "--out", folder.PathOf("csv")).AssertDone();
        CliRun.Of("validate", folder.PathOf("csv")).AssertDone();
        JsonElement[] lines = Lines(session);

        Dictionary<string, byte[]> files = Archived(folder.PathOf("tar/train-000000.tar"));
        Assert.Equal(2 * lines.Length, files.Count);
        string[] rows = File.ReadAllLines(folder.PathOf("csv/drive.csv"));
        Assert.Equal(lines.Length + 1, rows.Length);
        int steering = Array.IndexOf(rows[0].Split(','), "steering");
        for (int i = 0; i < lines.Length; i++)
        {
            JsonElement action = lines[i].GetProperty("drive");
            string picture = lines[i].GetProperty("image").GetString()!;
            Assert.Equal(File.ReadAllBytes(Path.Combine(session, picture)), files[$"{i:D8}.png"]);
            using JsonDocument sample = JsonDocument.Parse(files[$"{i:D8}.json"]);
            Assert.Equal(action.GetRawText(), sample.RootElement.GetProperty("drive").GetRawText());
            Assert.Equal(
                Controls(action, "controls")[0],
                double.Parse(rows[i + 1].Split(',')[steering], CultureInfo.InvariantCulture),
                Rounding
            );
        }
    }

    [Theory]
    [InlineData("--size needs --record.", "--size", "80x60")]
    [InlineData("--record-every needs --record.", "--record-every", "0.2")]
    [InlineData("--record and --out name the same folder", "--record", "same")]
    [InlineData("The folder of --record, 'same/rec', is inside that of --out, 'same'.", "--record", "same/rec")]
    [InlineData("The folder of --out, 'same', is inside that of --record, '.'.", "--record", ".")]
    [InlineData("--record and --folder name the same folder", "--record", "one", "--bridge", "folder", "--folder", "one")]
    [InlineData("The folder of --folder, '", "--bridge", "folder", "--folder", "same/other")]
    [InlineData("a multiple of 0.1", "--record", "other", "--record-every", "0.25")]
    [InlineData("--perturb needs a drive without a bridge.", "--perturb", "--bridge", "socket")]
    public void Contradictory_options_are_refused(string message, params string[] options)
    {
        CliRun.Of(["drive", "--out", "same", .. options]).AssertFailed(2, message);
        Assert.False(Directory.Exists("same"));
    }

    private static void Drive(TemporaryFolder folder, string name, params string[] options) =>
        CliRun
            .Of([
                "drive",
                "--seed",
                "1",
                "--out",
                folder.PathOf(name),
                "--record",
                folder.PathOf(name + "-session"),
                "--size",
                "80x60",
                .. options,
            ])
            .AssertDone();

    private static Dictionary<string, byte[]> Archived(string path)
    {
        Dictionary<string, byte[]> files = [];
        using TarReader tar = new(File.OpenRead(path));
        while (tar.GetNextEntry() is { } entry)
        {
            using MemoryStream content = new();
            entry.DataStream!.CopyTo(content);
            files.Add(entry.Name, content.ToArray());
        }

        return files;
    }

    private static JsonElement[] Lines(string session) =>
        [.. File.ReadLines(Path.Combine(session, "labels.jsonl")).Select(line => JsonDocument.Parse(line).RootElement)];

    private static string? Driver(JsonElement line) => line.GetProperty("drive").GetProperty("driver").GetString();

    private static JsonElement Target(JsonElement line) => line.GetProperty("drive").GetProperty("target");

    private static double Number(JsonElement of, string name) => of.GetProperty(name).GetDouble();

    private static double[] Controls(JsonElement drive, string name) =>
        [.. drive.GetProperty(name).EnumerateObject().Select(control => control.Value.GetDouble())];
}
