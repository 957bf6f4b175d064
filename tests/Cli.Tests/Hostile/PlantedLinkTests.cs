using Harvester.Cli.Arguments;
using Harvester.Cli.Terminals;
using Harvester.Cli.Tests.Commands;
using Harvester.Sessions.Files;
using Harvester.TestSupport;

namespace Harvester.Cli.Tests.Hostile;

/// <summary>Links and names that somebody has planted where a command writes in place.</summary>
public sealed class PlantedLinkTests(SmallSession session) : IClassFixture<SmallSession>, IDisposable
{
    private readonly HostileSession _hostile = new(session);

    public void Dispose() => _hostile.Dispose();

    [PosixFact]
    public void Journal_of_an_export_that_is_a_link_is_not_followed()
    {
        string shard = _hostile.PathOf("shard");
        string[] export = ["export", _hostile.Folder, "--format", "csv", "--shard", "1/2", "--out", shard];
        Assert.Equal(ExitCode.Done, HostileSession.Run(export).ExitCode);
        string journal = Path.Combine(shard, ".export/journal-1-of-2.jsonl");
        string target = Path.Combine(shard, "frames.csv");
        File.Move(journal, target);
        File.CreateSymbolicLink(journal, target);
        byte[] before = File.ReadAllBytes(target);
        File.WriteAllBytes(target, before[..^"end\n".Length]);

        HostileSession.AssertRefused("is a link", export);

        Assert.Equal(before[..^"end\n".Length], File.ReadAllBytes(target));
    }

    [PosixTheory]
    [InlineData("harvest", "--frames", "1")]
    [InlineData("harvest", "--frames", "1", "--overwrite")]
    [InlineData("drive", "--duration", "1")]
    public void Mark_of_a_stopped_command_that_is_a_link_is_not_read(params string[] command)
    {
        const string secret = "secret words";
        string folder = _hostile.PathOf("out");
        Directory.CreateDirectory(folder);
        File.WriteAllText(_hostile.PathOf("secret"), secret);
        File.CreateSymbolicLink(Path.Combine(folder, ".harvester-unfinished"), _hostile.PathOf("secret"));

        CliRun run = HostileSession.Run([.. command, "--out", folder]);

        run.AssertFailed(ExitCode.InputOutput, "is a link");
        Assert.DoesNotContain(secret, run.Error, StringComparison.Ordinal);
        Assert.Equal(secret, File.ReadAllText(_hostile.PathOf("secret")));
    }

    [PosixTheory]
    [InlineData("frames")]
    [InlineData("masks")]
    public void Folder_of_a_stopped_harvest_that_is_a_link_is_not_written(string name)
    {
        string folder = _hostile.PathOf("out");
        string outside = _hostile.PathOf("outside");
        string[] harvest = ["harvest", "--frames", "2", "--size", "64x48", "--masks", "--no-report", "--min-free", "0", "--out", folder];
        Directory.CreateDirectory(folder);
        UnfinishedMark.Write(folder, CommandText.Of(harvest[..^4]));
        Directory.CreateDirectory(outside);
        File.WriteAllText(Path.Combine(outside, "00000000.png.0123456789abcdef.partial"), "kept");
        File.CreateSymbolicLink(Path.Combine(folder, name), outside);

        HostileSession.Run([.. harvest, "--resume"]).AssertFailed(ExitCode.InputOutput, "is a link");

        Assert.Equal(["00000000.png.0123456789abcdef.partial"], Directory.GetFiles(outside).Select(Path.GetFileName));
    }

    [PosixTheory]
    [InlineData("trials")]
    [InlineData("trials/a_clear_1200_camera_001")]
    public void Folder_of_trials_that_is_a_link_is_not_written(string name)
    {
        string folder = _hostile.PathOf("out");
        string outside = _hostile.PathOf("outside");
        string plan = _hostile.PathOf("plan.json");
        File.WriteAllText(plan, """{"name":"p","places":[{"name":"a","x":0,"y":0}],"frames":1}""");
        Directory.CreateDirectory(Path.Combine(folder, Path.GetDirectoryName(name)!));
        File.Copy(plan, Path.Combine(folder, "plan.json"));
        Directory.CreateDirectory(outside);
        File.CreateSymbolicLink(Path.Combine(folder, name), outside);

        HostileSession.Run("plan", "run", plan, "--out", folder, "--resume").AssertFailed(ExitCode.InputOutput, "is a link");

        Assert.Empty(Directory.GetFileSystemEntries(outside));
    }

    [PosixFact]
    public void Stopped_relabelling_is_not_resumed_through_a_link()
    {
        string folder = _hostile.PathOf("out");
        string outside = _hostile.PathOf("outside");
        string[] relabel = ["relabel", _hostile.Folder, "--no-report", "--out", folder];
        Directory.CreateDirectory(folder);
        UnfinishedMark.Write(folder, CommandText.Of(relabel[..^2]));
        Directory.CreateDirectory(outside);
        File.CreateSymbolicLink(Path.Combine(folder, "frames"), outside);

        CliRun run = HostileSession.Run([.. relabel, "--resume"]);

        Assert.Empty(Directory.GetFiles(outside));
        run.AssertDone();
        Assert.Null(new FileInfo(Path.Combine(folder, "frames")).LinkTarget);
    }

    [Fact]
    public void Mark_of_a_stopped_drive_is_printed_in_part()
    {
        string folder = _hostile.PathOf("out");
        Directory.CreateDirectory(folder);
        File.WriteAllText(Path.Combine(folder, ".harvester-unfinished"), new string('x', 100_000));
        File.WriteAllText(Path.Combine(folder, "drive.json"), "{}");

        CliRun run = HostileSession.Run("drive", "--duration", "1", "--out", folder);

        run.AssertFailed(ExitCode.Usage, "has the unfinished result of 'xxx");
        Assert.InRange(run.Error.Length, 1, 2000);
    }

    [Theory]
    [InlineData("image", "labels.jsonl")]
    [InlineData("image", "./labels.jsonl")]
    [InlineData("image", "session.json")]
    [InlineData("mask", "labels.jsonl")]
    [InlineData("mask", "session.json")]
    [InlineData("mask", "scenes/roads.csv")]
    [InlineData("mask", "scenes/00000000.json")]
    public void Label_that_names_a_file_of_the_session_itself_is_refused(string field, string name)
    {
        string folder = field == "image" ? "frames" : "masks";
        _hostile.Replace("labels.jsonl", $"\"{field}\":\"{folder}/00000000.png\"", $"\"{field}\":\"{name}\"");
        string labels = File.ReadAllText(_hostile.In("labels.jsonl"));
        string header = File.ReadAllText(_hostile.In("session.json"));

        HostileSession.AssertRefused("must name a picture", "masks", "import", _hostile.Folder, _hostile.In("masks"));
        HostileSession.AssertRefused("must name a picture", "relabel", _hostile.Folder, "--no-report", "--out", _hostile.PathOf("out"));
        HostileSession.AssertRefused("must name a picture", "export", _hostile.Folder, "--format", "csv", "--out", _hostile.PathOf("csv"));

        Assert.Equal((labels, header), (File.ReadAllText(_hostile.In("labels.jsonl")), File.ReadAllText(_hostile.In("session.json"))));
    }
}
