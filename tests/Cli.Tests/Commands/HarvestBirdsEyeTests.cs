using Harvester.Cli.Terminals;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Images;

namespace Harvester.Cli.Tests.Commands;

/// <summary>Bird's-eye maps from the command line to the commands that read a session.</summary>
public sealed class HarvestBirdsEyeTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Maps_are_validated_exported_and_kept()
    {
        string session = Harvest("session", "--birds-eye-size", "30", "--birds-eye-cell", "0.5");
        CliRun.Of("validate", "--schema", session).AssertDone();
        CliRun.Of("relabel", session, "--out", _folder.PathOf("same"), "--range", "30", "--no-report").AssertDone();
        CliRun.Of("export", session, "--format", "mcap", "--out", _folder.PathOf("mcap")).AssertDone();
        CliRun.Of("validate", _folder.PathOf("mcap")).AssertDone();

        BirdsEyeLabel map = new SessionReader(_folder.PathOf("same")).ReadLabels().Last().Channels.Get<BirdsEyeLabel>()!;
        Assert.Equal(new BirdsEyeLabel("birds-eye/00000001.png", "birds-eye-visible/00000001.png", 60, 0.5, BirdsEyeSource.Exact), map);
        Assert.Contains("\"birdsEyeGrid\": {", File.ReadAllText(Path.Combine(session, "session.json")), StringComparison.Ordinal);
    }

    /// <summary>A grid of the recording has the cells of both maps in turn, row by row from the rear to the front.</summary>
    [Fact]
    public void Recordings_have_the_cells_of_the_maps()
    {
        string session = Harvest("session", "--birds-eye-size", "30", "--birds-eye-cell", "0.5");
        CliRun.Of("export", session, "--format", "mcap", "--out", _folder.PathOf("mcap")).AssertDone();

        byte[] recording = File.ReadAllBytes(_folder.PathOf("mcap/train/0000.mcap"));
        const int cells = 60;
        for (int frame = 0; frame < 2; frame++)
        {
            ushort[] classes = PngDecoder.ReadLabelMap(Path.Combine(session, "birds-eye", $"{frame:D8}.png")).Ids;
            ushort[] visible = PngDecoder.ReadLabelMap(Path.Combine(session, "birds-eye-visible", $"{frame:D8}.png")).Ids;
            byte[] expected =
            [
                .. Enumerable
                    .Range(0, cells)
                    .SelectMany(row => Enumerable.Range(0, cells).Select(column => ((cells - 1 - row) * cells) + column))
                    .SelectMany(cell => new[] { (byte)classes[cell], (byte)visible[cell] }),
            ];
            Assert.True(expected.Distinct().Count() > 3, "The maps are empty.");
            Assert.True(recording.AsSpan().IndexOf(expected) > 0, $"The cells of frame {frame} are missing.");
        }
    }

    [Fact]
    public void Values_that_are_no_classes_are_a_problem()
    {
        string session = Harvest("stray", "--birds-eye-size", "30", "--birds-eye-cell", "0.5");
        string visible = Path.Combine(session, "birds-eye-visible", "00000000.png");
        File.Copy(visible, Path.Combine(session, "birds-eye", "00000000.png"), overwrite: true);
        File.Copy(Path.Combine(session, "birds-eye", "00000001.png"), visible, overwrite: true);
        File.Delete(Path.Combine(session, "manifest.jsonl"));

        CliRun validated = CliRun.Of("validate", session);

        Assert.Equal(ExitCode.BadData, validated.ExitCode);
        Assert.Contains(
            "bird's-eye map 'birds-eye/00000000.png' has the value 255, which is no class. Classes are 0 to 6.",
            validated.Out,
            StringComparison.Ordinal
        );
        Assert.Contains("bird's-eye map 'birds-eye-visible/00000000.png' has the value", validated.Out, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("--birds-eye-size needs --birds-eye.", "--birds-eye-size", "40")]
    [InlineData("The side of a grid must be 10 to 200 m, not 500 m.", "--birds-eye", "--birds-eye-size", "500")]
    [InlineData("but it must have a whole number of them", "--birds-eye", "--birds-eye-cell", "0.3")]
    [InlineData("The corners of bird's-eye maps are 56.6 m from the vehicle", "--birds-eye", "--range", "20", "--ignore-range", "20")]
    public void Sizes_that_cannot_be_are_refused(string message, params string[] options)
    {
        CliRun run = CliRun.Of([
            "harvest",
            "--out",
            _folder.PathOf("refused"),
            "--frames",
            "1",
            "--size",
            "80x60",
            "--no-report",
            .. options,
        ]);

        Assert.NotEqual(ExitCode.Done, run.ExitCode);
        Assert.Contains(message, run.Error, StringComparison.Ordinal);
    }

    private string Harvest(string name, params string[] options)
    {
        string session = _folder.PathOf(name);
        CliRun
            .Of([
                "harvest",
                "--out",
                session,
                "--frames",
                "2",
                "--size",
                "80x60",
                "--seed",
                "3",
                "--places",
                "1",
                "--no-report",
                "--birds-eye",
                .. options,
            ])
            .AssertDone();
        return session;
    }
}
