using System.Diagnostics;
using System.Text.Json;
using Harvester.Cli.Terminals;

namespace Harvester.Cli.Tests.Commands;

/// <summary>Recordings in processes of their own that are killed in the middle, read as JSON.</summary>
[Trait("Category", "Heavy")]
public sealed class KilledRecordingTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    private string[] Record => ["--record", _folder.PathOf("session"), "--size", "80x60", "--traffic", "0"];

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Killed_drive_leaves_whole_actions_and_can_be_given_again()
    {
        string[] drive = ["drive", "--out", _folder.PathOf("out"), "--seed", "1", "--distance", "80", .. Record];
        KillAfter(6, "session", drive);
        JsonElement[] lines = CheckFrames("session");

        CliRun validated = CliRun.Of("validate", _folder.PathOf("session"), "--schema");
        Assert.Contains("Note: the recording was cut off before session.json was complete", validated.Out, StringComparison.Ordinal);
        CliRun.Of(drive).AssertDone();
        Assert.True(CheckFrames("session").Length > lines.Length);
        CliRun whole = CliRun.Of("validate", _folder.PathOf("session"), "--schema");
        whole.AssertDone();
        Assert.DoesNotContain("was cut off", whole.Out, StringComparison.Ordinal);
        Assert.True(File.Exists(_folder.PathOf("out/drive.json")));
    }

    [Fact]
    public void Another_drive_made_after_the_kill_is_not_replaced()
    {
        string[] drive = ["drive", "--out", _folder.PathOf("out"), "--seed", "1", "--distance", "80", .. Record];
        KillAfter(2, "session", drive);
        CliRun.Of("drive", "--out", _folder.PathOf("out"), "--seed", "1", "--distance", "10", "--weather", "rain").AssertDone();
        byte[] other = File.ReadAllBytes(_folder.PathOf("out/drive.json"));

        CliRun.Of(drive).AssertFailed(ExitCode.Usage, "already has a drive");
        Assert.Equal(other, File.ReadAllBytes(_folder.PathOf("out/drive.json")));

        // Nor is one with the same settings: the command had not written it.
        CliRun
            .Of("drive", "--out", _folder.PathOf("out"), "--seed", "1", "--distance", "80", "--traffic", "0", "--overwrite")
            .AssertDone();
        CliRun.Of(drive).AssertFailed(ExitCode.Usage, "already has a drive");
        CliRun.Of([.. drive, "--overwrite"]).AssertDone();
    }

    [Fact]
    public void Killed_drives_are_replaced_with_overwrite_only()
    {
        string[] Drive(string metres) =>
            ["drive", "--out", _folder.PathOf("out"), "--seed", "1", "--near", "0,0", "--near", "50,50", "--distance", metres, .. Record];
        KillAfter(2, "session/0002", Drive("20"));
        CheckFrames("session/0001");
        CheckFrames("session/0002");

        CliRun.Of(Drive("10")).AssertFailed(ExitCode.Usage, "has the unfinished result of 'harvester drive ");
        CliRun.Of([.. Drive("10"), "--overwrite"]).AssertDone();
        Assert.Equal(["0001", "0002"], Directory.EnumerateFileSystemEntries(_folder.PathOf("session")).Select(Path.GetFileName).Order());
        CliRun.Of("validate", _folder.PathOf("session/0002"), "--schema").AssertDone();
        CliRun.Of(Drive("10")).AssertFailed(ExitCode.Usage, "already has sessions");
    }

    [Fact]
    public void Folder_with_other_files_is_no_folder_for_sessions()
    {
        Directory.CreateDirectory(_folder.PathOf("session"));
        string notes = _folder.File("session/notes.txt", "mine");

        CliRun
            .Of(["drive", "--out", _folder.PathOf("out"), "--near", "0,0", "--near", "5,5", "--overwrite", .. Record])
            .AssertFailed(ExitCode.Usage, "has something other than recorded sessions, e.g. 'notes.txt'.");
        Assert.Equal("mine", File.ReadAllText(notes));
    }

    /// <summary>
    /// Each line has its picture and, except for the last of all, each tick up to the next. A kill may cut the line that is being written.
    /// </summary>
    private JsonElement[] CheckFrames(string session)
    {
        string text = File.ReadAllText(_folder.PathOf($"{session}/labels.jsonl"));
        JsonElement[] lines = [.. text.Split('\n')[..^1].Select(line => JsonDocument.Parse(line).RootElement)];
        foreach ((JsonElement line, JsonElement next) in lines.Zip(lines.Skip(1)))
        {
            Assert.True(File.Exists(_folder.PathOf($"{session}/{line.GetProperty("image").GetString()}")));
            JsonElement[] ticks = [.. line.GetProperty("drive").GetProperty("ticks").EnumerateArray()];
            Assert.Equal(4, ticks.Length);
            Assert.Equal(next.GetProperty("timeSeconds").GetDouble(), ticks[^1].GetProperty("timeSeconds").GetDouble());
        }

        return lines;
    }

    /// <summary>Kills a command once a session has this many label lines.</summary>
    private void KillAfter(int lines, string session, string[] arguments)
    {
        var start = new ProcessStartInfo("dotnet") { RedirectStandardOutput = true, RedirectStandardError = true };
        start.ArgumentList.Add(Path.Combine(AppContext.BaseDirectory, "harvester.dll"));
        Array.ForEach(arguments, start.ArgumentList.Add);
        using Process command = Process.Start(start)!;
        while (!command.HasExited && Lines(session) < lines)
        {
            Thread.Sleep(1);
        }

        Assert.False(command.HasExited, "It has ended by itself.");
        command.Kill();
        command.WaitForExit();
    }

    private int Lines(string session)
    {
        string labels = _folder.PathOf($"{session}/labels.jsonl");
        if (!File.Exists(labels))
        {
            return 0;
        }

        using var file = new FileStream(labels, FileMode.Open, FileAccess.Read, FileShare.ReadWrite | FileShare.Delete);
        using var reader = new StreamReader(file);
        return reader.ReadToEnd().Count(character => character == '\n');
    }
}
