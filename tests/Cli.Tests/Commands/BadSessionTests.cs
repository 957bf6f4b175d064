using Harvester.Cli.Terminals;

namespace Harvester.Cli.Tests.Commands;

/// <summary>A session that cannot be used as it is: one line that names what is wrong.</summary>
public sealed class BadSessionTests : IDisposable
{
    private readonly SmallSession _session = new();

    public void Dispose() => _session.Dispose();

    [Theory]
    [InlineData("validate")]
    [InlineData("stats")]
    [InlineData("report")]
    [InlineData("export", "--format", "coco", "--out", "dataset")]
    public void Session_of_a_newer_version_is_named_in_one_line(string command, params string[] options)
    {
        string file = Path.Combine(_session.Folder, "session.json");
        string header = File.ReadAllText(file);
        string newer = header.Replace("\"formatVersion\": 1", "\"formatVersion\": 2", StringComparison.Ordinal);
        Assert.NotEqual(header, newer);
        File.WriteAllText(file, newer);

        CliRun run = CliRun.Of([command, _session.Folder, .. options]);

        Assert.Equal(ExitCode.BadData, run.ExitCode);
        string[] lines = [.. (run.Error + run.Out).Split('\n').Where(line => line.Contains("formatVersion", StringComparison.Ordinal))];
        Assert.EndsWith(
            "session.json: formatVersion is 2; this program reads version 1. Install a newer one.",
            Assert.Single(lines),
            StringComparison.Ordinal
        );
    }

    [Fact]
    public void Missing_picture_is_a_problem_that_names_the_file()
    {
        File.Delete(Path.Combine(_session.Folder, "frames", "00000001.png"));

        CliRun run = CliRun.Of("validate", _session.Folder);

        Assert.Equal(ExitCode.BadData, run.ExitCode);
        Assert.Contains(
            run.Out.Split('\n'),
            line => line.Contains("line 2", StringComparison.Ordinal) && line.Contains("frames/00000001.png", StringComparison.Ordinal)
        );
    }

    [Fact]
    public void Export_of_a_missing_picture_names_the_file()
    {
        File.Delete(Path.Combine(_session.Folder, "frames", "00000001.png"));

        CliRun run = CliRun.Of("export", _session.Folder, "--format", "yolo", "--out", _session.Folder + "-dataset");

        Assert.NotEqual(ExitCode.Done, run.ExitCode);
        Assert.Contains("00000001.png", Assert.Single(run.Error.TrimEnd().Split('\n')), StringComparison.Ordinal);
    }

    [Fact]
    public void Unfinished_line_of_labels_has_a_note()
    {
        File.AppendAllText(Path.Combine(_session.Folder, "labels.jsonl"), """{"frame":2,"gameF""");

        AssertNote("Note: the unfinished last line of labels.jsonl is ignored");
    }

    [Fact]
    public void Session_that_is_being_written_has_a_note()
    {
        File.WriteAllText(Path.Combine(_session.Folder, ".harvester-unfinished"), "harvest");

        AssertNote("Note: the session has the file .harvester-unfinished");
    }

    private void AssertNote(string beginning)
    {
        CliRun run = CliRun.Of("validate", _session.Folder);

        Assert.Equal(ExitCode.Done, run.ExitCode);
        string note = Assert.Single(run.Out.Split('\n'), line => line.StartsWith("Note", StringComparison.Ordinal));
        Assert.StartsWith(beginning, note, StringComparison.Ordinal);
    }
}
