using Harvester.Cli.Terminals;

namespace Harvester.Cli.Tests.Commands;

public sealed class MergeSessionsTests(HarvestedShards harvested) : IClassFixture<HarvestedShards>, IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Merge_of_three_shards_is_byte_identical_to_a_single_run()
    {
        // The report's title is the folder's name.
        CliRun merge = Merge("merged/session", "part-3", "part-1", "part-2");

        Assert.Equal($"{_folder.PathOf("merged/session")}: 8 frames\n", merge.Out);
        string[] files = Files(harvested.PathOf("whole/session"));

        // Of each frame picture, mask and scene; labels, manifest, header and report; roads and faces.
        Assert.Equal((8 * 3) + 4 + 2, files.Length);
        Assert.Equal(files, Files(_folder.PathOf("merged/session")));
        Assert.All(
            files,
            file =>
                Assert.Equal(
                    File.ReadAllBytes(harvested.PathOf($"whole/session/{file}")),
                    File.ReadAllBytes(_folder.PathOf($"merged/session/{file}"))
                )
        );
    }

    [Theory]
    [InlineData("part-1", 3)]
    [InlineData("part-3", 2)]
    public void Shard_is_a_valid_session_of_its_frames_without_a_report(string part, int frames)
    {
        Assert.StartsWith(
            $"{harvested.PathOf(part)}: {frames} frames",
            CliRun.Of("validate", harvested.PathOf(part)).Out,
            StringComparison.Ordinal
        );
        Assert.False(File.Exists(harvested.PathOf($"{part}/report.html")));
    }

    [Theory]
    [InlineData("part-2 part-3", "Shard 1 is missing; run it, and name its folder too.")]
    [InlineData("part-1 part-2 other-3", "are shards of different sessions")]
    [InlineData("part-1 part-2 part-1", "Shard 1/3 occurs twice")]
    [InlineData("part-1 whole/session", "is a complete session, not a shard")]
    public void Merge_of_folders_that_are_not_shards_of_one_session_fails(string parts, string message)
    {
        Merge("merged", parts.Split(' ')).AssertFailed(ExitCode.BadData, message);
        Assert.False(Directory.Exists(_folder.PathOf("merged")));
    }

    [Fact]
    public void Merge_of_a_shard_that_lost_a_frame_names_it()
    {
        string part = Changed(
            "part-2",
            "labels.jsonl",
            text => string.Concat(text.Split('\n').Where((_, line) => line != 1).Select(line => line + "\n")).TrimEnd() + "\n"
        );

        Merge("merged", "part-1", part, "part-3").AssertFailed(ExitCode.BadData, "has no frame 4");
        Assert.False(File.Exists(_folder.PathOf("merged/session.json")));
    }

    [Fact]
    public void Merge_of_a_shard_missing_its_last_frame_fails()
    {
        string part = Changed("part-1", "labels.jsonl", text => string.Concat(text.Split('\n').Take(2).Select(line => line + "\n")));

        Merge("merged", part, "part-2", "part-3").AssertFailed(ExitCode.BadData, "has frames after frame 6");
    }

    [Fact]
    public void Merge_of_an_unfinished_shard_asks_to_run_it_again()
    {
        string part = Changed("part-2", "session.json", text => text.Replace("\"complete\"", "\"recording\"", StringComparison.Ordinal));

        Merge("merged", "part-1", part, "part-3").AssertFailed(ExitCode.BadData, "Shard 2/3 in");
    }

    [Fact]
    public void Merge_reports_a_missing_folder() =>
        CliRun
            .Of("merge", _folder.PathOf("nowhere"), "--out", _folder.PathOf("out"))
            .AssertFailed(ExitCode.InputOutput, "Folder not found: '");

    [Fact]
    public void Merge_into_an_occupied_folder_is_refused()
    {
        _folder.File("thesis.tex", "mine");

        Merge(".", "part-1", "part-2", "part-3").AssertFailed(ExitCode.Usage, "is not empty");
    }

    /// <summary>A copy of a shard with one of its files changed.</summary>
    private string Changed(string part, string file, Func<string, string> change)
    {
        string copy = _folder.PathOf("changed");
        foreach (string name in Files(harvested.PathOf(part)))
        {
            Directory.CreateDirectory(Path.GetDirectoryName(Path.Combine(copy, name))!);
            File.Copy(harvested.PathOf($"{part}/{name}"), Path.Combine(copy, name));
        }

        File.WriteAllText(Path.Combine(copy, file), change(File.ReadAllText(Path.Combine(copy, file))));
        return copy;
    }

    // An absolute path stays as it is when it is joined to another.
    private CliRun Merge(string name, params string[] shards) =>
        CliRun.Of(["merge", .. shards.Select(harvested.PathOf), "--out", _folder.PathOf(name)]);

    private static string[] Files(string folder) =>
        [
            .. Directory
                .EnumerateFiles(folder, "*", SearchOption.AllDirectories)
                .Select(file => Path.GetRelativePath(folder, file))
                .Order(StringComparer.Ordinal),
        ];
}
