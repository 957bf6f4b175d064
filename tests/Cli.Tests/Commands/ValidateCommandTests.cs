using Harvester.Cli.Terminals;

namespace Harvester.Cli.Tests.Commands;

public sealed class ValidateCommandTests
{
    private const string Header =
        """{ "formatVersion": 1, "game": "simulation", "image": { "width": 80, "height": 60 }, "counters": { "captured": 0 } }""";

    [Fact]
    public void Validate_of_a_good_session_succeeds()
    {
        using var folder = new TemporaryFolder();
        folder.File("session.json", Header);

        CliRun run = CliRun.Of("validate", folder.Path);

        Assert.Equal(ExitCode.Done, run.ExitCode);
        Assert.Equal($"{folder.Path}: 0 frames, 0 labels, good\n", run.Out);
    }

    [Fact]
    public void Validate_of_a_damaged_session_lists_problems_and_fails()
    {
        using var folder = new TemporaryFolder();
        folder.File("session.json", Header);
        folder.File("labels.jsonl", "{}\n[]\n");

        CliRun run = CliRun.Of("validate", folder.Path);

        Assert.Equal(ExitCode.BadData, run.ExitCode);
        Assert.Equal(
            [
                "labels.jsonl, line 1: frame is missing.",
                "labels.jsonl, line 2: the text must be an object, not [].",
                $"{folder.Path}: 0 frames, 0 labels, 2 problems",
                "",
            ],
            run.Out.Split('\n'));
    }

    [Fact]
    public void Validate_notes_an_interrupted_session()
    {
        using var folder = new TemporaryFolder();
        folder.File("session.json", Header.Replace(""", "counters": { "captured": 0 }""", "", StringComparison.Ordinal));

        CliRun run = CliRun.Of("validate", folder.Path);

        Assert.Equal(ExitCode.Done, run.ExitCode);
        Assert.StartsWith("Note: the recording was cut off", run.Out, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("""{ "cameraErrorPixels": null }""", "", 2)]
    [InlineData("""{ "cameraErrorPixels": null }""", ""","pictureLag": { "cameraTicks": 1, "entityTicks": 1 }""", 1)]
    [InlineData("""{ "cameraErrorPixels": 0.2 }""", "", 0)]
    public void Validate_notes_what_was_not_checked_while_recording(string start, string lag, int notes)
    {
        using var folder = new TemporaryFolder();
        folder.File(
            "session.json", Header.Replace(""", "counters":""", $""", "start": {start}{lag}, "counters":""", StringComparison.Ordinal));

        CliRun run = CliRun.Of("validate", folder.Path);

        Assert.Equal(ExitCode.Done, run.ExitCode);
        Assert.Equal(notes, run.Out.Split('\n').Count(line => line.StartsWith("Note: ", StringComparison.Ordinal)));
    }

    [Fact]
    public void Validate_of_a_missing_folder_is_an_input_error() =>
        CliRun.Of("validate", "no-such-session").AssertFailed(ExitCode.InputOutput, "no-such-session");

    [Fact]
    public void Validate_of_another_folder_is_an_input_error()
    {
        using var folder = new TemporaryFolder();

        CliRun.Of("validate", folder.Path).AssertFailed(ExitCode.InputOutput, "is not a session");
    }
}
