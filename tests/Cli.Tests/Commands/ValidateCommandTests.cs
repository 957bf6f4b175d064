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
        Assert.Equal($"{folder.Path}: 0 frames, 0 labels, no problems\n", run.Out);
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
            run.Out.Split('\n')
        );
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
            "session.json",
            Header.Replace(""", "counters":""", $""", "start": {start}{lag}, "counters":""", StringComparison.Ordinal)
        );

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

    [Fact]
    public void Manifest_deleted_from_a_closed_session_is_a_problem()
    {
        using var session = new SmallSession();
        File.Delete(Path.Combine(session.Folder, "manifest.jsonl"));

        CliRun run = CliRun.Of("validate", session.Folder);

        Assert.Equal(ExitCode.BadData, run.ExitCode);
        Assert.StartsWith(
            "manifest.jsonl: it is missing, but session.json says that the session was closed with it.\n",
            run.Out,
            StringComparison.Ordinal
        );
        Assert.DoesNotContain("has no manifest.jsonl", run.Out, StringComparison.Ordinal);
    }

    [Fact]
    public void Session_of_an_earlier_version_has_a_note_instead()
    {
        using var session = new SmallSession();
        File.Delete(Path.Combine(session.Folder, "manifest.jsonl"));
        string header = Path.Combine(session.Folder, "session.json");
        File.WriteAllText(header, File.ReadAllText(header).Replace("\n  \"manifest\": true,", "", StringComparison.Ordinal));

        CliRun run = CliRun.Of("validate", session.Folder);

        Assert.Equal(ExitCode.Done, run.ExitCode);
        Assert.Contains("Note: the session has no manifest.jsonl, so damage", run.Out, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("relabel")]
    [InlineData("repair")]
    public void Session_made_of_an_older_one_says_it_has_a_manifest(string command)
    {
        using var session = new SmallSession();
        using var folder = new TemporaryFolder();
        string header = Path.Combine(session.Folder, "session.json");
        File.Delete(Path.Combine(session.Folder, "manifest.jsonl"));
        File.WriteAllText(header, File.ReadAllText(header).Replace("\n  \"manifest\": true,", "", StringComparison.Ordinal));

        CliRun.Of(command, session.Folder, "--out", folder.PathOf("made"));

        Assert.Contains("\n  \"manifest\": true", File.ReadAllText(folder.PathOf("made/session.json")), StringComparison.Ordinal);
    }

    [Fact]
    public void Dataset_is_compared_with_its_manifest()
    {
        using var session = new SmallSession();
        using var folder = new TemporaryFolder();
        string dataset = folder.PathOf("yolo");
        CliRun.Of("export", session.Folder, "--format", "yolo", "--out", dataset, "--images", "copy");
        File.WriteAllText(Path.Combine(dataset, "labels", "train.cache"), "of a training");

        CliRun noted = CliRun.Of("validate", dataset);
        byte[] image = File.ReadAllBytes(Path.Combine(dataset, "images/train/00000001.png"));
        image[^20] ^= 1;
        File.WriteAllBytes(Path.Combine(dataset, "images/train/00000001.png"), image);
        CliRun damaged = CliRun.Of("validate", dataset);

        Assert.Equal(
            (
                ExitCode.Done,
                "Note: 1 file in the folder not listed in manifest.jsonl, e.g. 'labels/train.cache'; readers of the format ignore "
                    + $"such files.\n{dataset}: yolo, 2 frames, no problems\n"
            ),
            (noted.ExitCode, noted.Out)
        );
        Assert.Equal(ExitCode.BadData, damaged.ExitCode);
        Assert.StartsWith(
            "images/train/00000001.png: it is damaged: its SHA-256 differs from manifest.jsonl.\n",
            damaged.Out,
            StringComparison.Ordinal
        );
    }
}
