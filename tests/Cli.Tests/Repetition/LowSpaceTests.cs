using Harvester.Cli.Terminals;

namespace Harvester.Cli.Tests.Repetition;

/// <summary>Commands whose disk has less space than is to stay free, or whose files another program holds.</summary>
public sealed class LowSpaceTests : IClassFixture<ResumedDerivationTests.Inputs>, IDisposable
{
    /// <summary>More than any disk has.</summary>
    private const string Everything = "1000000TB";

    private readonly ResumedDerivationTests.Inputs _inputs;
    private readonly TemporaryFolder _folder = new();

    public LowSpaceTests(ResumedDerivationTests.Inputs inputs) => _inputs = inputs;

    private string Out => _folder.PathOf("out");

    private string Whole => _folder.PathOf("whole");

    public void Dispose() => _folder.Dispose();

    [Theory]
    [InlineData("harvest --frames 3 --seed 5 --size 64x48 --no-report --roads ROADS")]
    [InlineData("relabel SESSION --range 60 --no-report")]
    [InlineData("merge SHARDS --no-report")]
    [InlineData("export SESSION --format voc")]
    public void Command_stops_in_good_order_and_continues(string command)
    {
        CliRun stopped = CliRun.Of([.. Words(command), "--out", Out, "--min-free", Everything]);

        Assert.Equal(ExitCode.InputOutput, stopped.ExitCode);
        Assert.Matches(@"^harvester: The disk of '[^']*' has [0-9.]+ GB free; 1000000000 GB must stay free\. .*\n\z", stopped.Error);
        Assert.EndsWith("The same command with --resume continues; --min-free sets the limit.\n", stopped.Error, StringComparison.Ordinal);
        CliRun.Of([.. Words(command), "--out", Out, "--min-free", "0", "--resume"]).AssertDone();
        CliRun.Of([.. Words(command), "--out", Whole]).AssertDone();
        Assert.Equal("", FolderContent.Of(Out).DifferenceFrom(FolderContent.Of(Whole)));
    }

    [Theory]
    [InlineData("1")]
    [InlineData("GB")]
    [InlineData("-1GB")]
    [InlineData("2000000TB")]
    public void Size_without_unit_or_out_of_range_is_refused(string size) =>
        CliRun
            .Of([.. Words("export SESSION --format voc"), "--out", Out, "--min-free", size])
            .AssertFailed(ExitCode.Usage, $"--min-free takes 0, or a number with KB, MB, GB or TB, e.g. 500MB, not '{size}'.");

    [Fact]
    public void Locked_file_ends_a_command_and_changes_nothing()
    {
        string[] words = [.. Words("export SESSION --format voc --shard 1/2"), "--out", Out];
        CliRun.Of(words).AssertDone();
        string journal = Path.Combine(Out, ".export/journal-1-of-2.jsonl");
        FolderContent before = FolderContent.Of(Out);
        using (new FileStream(journal, FileMode.Open, FileAccess.ReadWrite, FileShare.None))
        {
            CliRun.Of(words).AssertFailed(ExitCode.InputOutput, journal);
        }

        Assert.Equal("", FolderContent.Of(Out).DifferenceFrom(before));
        CliRun.Of(words).AssertDone();
    }

    private string[] Words(string command) =>
        [
            .. command
                .Split(' ')
                .SelectMany(word =>
                    word switch
                    {
                        "ROADS" => [_inputs.Roads],
                        "SESSION" => [_inputs.Session],
                        "SHARDS" => _inputs.Shards,
                        _ => (string[])[word],
                    }
                ),
        ];
}
