using Harvester.Sessions.Files;
using Harvester.Sessions.Plans;

namespace Harvester.Sessions.Tests.Plans;

public sealed class PlanStatusTests : IDisposable
{
    private readonly string _folder = Directory.CreateTempSubdirectory("plan-status").FullName;

    private string FilePath => Path.Combine(_folder, "plan-status.jsonl");

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    [Fact]
    public void Trial_is_attempted_three_times_and_then_skipped()
    {
        PlanStatus status = Open();
        for (int attempt = 1; attempt <= 3; attempt++)
        {
            Assert.Equal(attempt, Open().NextAttempt("a"));
            status.Add(TrialResult.OfFailure("a", attempt, 5, "stuck"));
        }

        Assert.Null(Open().NextAttempt("a"));
        Assert.Equal(TrialState.Skipped, Open().Last["a"].State);
        Assert.Equal(1, Open().NextAttempt("b"));
    }

    [Fact]
    public void Line_has_the_documented_fields()
    {
        Open().Add(new TrialResult("a", TrialState.Done, 2, 40, null));
        Open().Add(TrialResult.OfFailure("b", 1, 0, "in \"water\""));

        Assert.Equal(
            [
                """{"trial":"a","state":"done","attempt":2,"frames":40}""",
                """{"trial":"b","state":"failed","attempt":1,"frames":0,"reason":"in \"water\""}""",
            ],
            File.ReadAllLines(FilePath)
        );
    }

    [Fact]
    public void Reason_has_no_folders()
    {
        TrialResult result = TrialResult.OfFailure("a", 1, 0, "The session in '/home/someone/out/a' cannot be written: No space.");

        Assert.Equal("The session in 'a' cannot be written: No space.", result.Reason);
    }

    [Fact]
    public void Unfinished_last_line_is_removed()
    {
        Open().Add(new TrialResult("a", TrialState.Done, 1, 40, null));
        File.AppendAllText(FilePath, """{"trial":"b","sta""");

        PlanStatus status = Open();
        Assert.Null(status.NextAttempt("a"));
        Assert.Equal(1, status.NextAttempt("b"));
        status.Add(new TrialResult("b", TrialState.Done, 1, 3, null));
        Assert.Equal(2, File.ReadAllLines(FilePath).Length);
    }

    [Fact]
    public void Damaged_line_is_named()
    {
        File.WriteAllText(FilePath, "{}\n");

        FormatException fault = Assert.Throws<FormatException>(Open);
        Assert.Equal("plan-status.jsonl, line 1: trial is missing.", fault.Message);
    }

    [Fact]
    public void Shards_have_files_of_their_own()
    {
        PlanStatus.Open(_folder, new Shard(2, 3)).Add(new TrialResult("a", TrialState.Done, 1, 1, null));

        Assert.Equal("plan-status-2-of-3.jsonl", Path.GetFileName(Assert.Single(Directory.GetFiles(_folder))));
        Assert.Equal(1, Open().NextAttempt("a"));
    }

    private PlanStatus Open() => PlanStatus.Open(_folder, Shard.Whole);
}
