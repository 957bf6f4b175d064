using Harvester.Cli.Terminals;
using Harvester.Sessions.Reading;

namespace Harvester.Cli.Tests.Commands;

/// <summary>What commands make of a session whose files were cut off.</summary>
public sealed class CutOffSessionTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public CutOffSessionTests() =>
        SharedHarvest.CopyTo(Session, "--frames", "2", "--seed", "5", "--size", "80x60", "--masks", "--no-report");

    private string Session => _folder.PathOf("session");

    private string Labels => Path.Combine(Session, SessionReader.LabelsFile);

    public static TheoryData<string[]> Commands =>
        [
            ["stats", "SESSION"],
            ["report", "SESSION"],
            ["export", "SESSION", "--format", "csv", "--out", "OUT"],
            ["relabel", "SESSION", "--out", "OUT"],
        ];

    public void Dispose() => _folder.Dispose();

    [Theory]
    [MemberData(nameof(Commands))]
    public void Command_ignores_an_unfinished_last_line_and_says_so(string[] arguments)
    {
        File.AppendAllText(Labels, File.ReadAllText(Labels)[..500]);

        CliRun run = Run(arguments);

        Assert.Equal(ExitCode.Done, run.ExitCode);
        Assert.Equal(
            $"harvester: {Session}: the unfinished last line of labels.jsonl is ignored; the recording was interrupted.\n",
            run.Error
        );
    }

    [Fact]
    public void Validate_notes_an_unfinished_last_line()
    {
        File.AppendAllText(Labels, File.ReadAllText(Labels)[..500]);

        CliRun run = CliRun.Of("validate", Session);

        Assert.Equal(ExitCode.Done, run.ExitCode);
        Assert.StartsWith("Note: the unfinished last line of labels.jsonl is ignored", run.Out, StringComparison.Ordinal);
        Assert.EndsWith("no problems\n", run.Out, StringComparison.Ordinal);
    }

    [Theory]
    [MemberData(nameof(Commands))]
    public void Command_refuses_a_truncated_session_json(string[] arguments)
    {
        string header = Path.Combine(Session, SessionInfo.FileName);
        File.WriteAllText(header, File.ReadAllText(header)[..300]);

        Run(arguments).AssertFailed(ExitCode.BadData, "session.json: invalid JSON");
        Assert.False(Directory.Exists(_folder.PathOf("out")));
    }

    [Fact]
    public void Validate_of_an_unfinished_export_names_the_next_step()
    {
        string export = _folder.PathOf("out");
        Assert.Equal(ExitCode.Done, Run(["export", "SESSION", "--format", "csv", "--out", "OUT", "--shard", "1/2"]).ExitCode);

        CliRun.Of("validate", export).AssertFailed(ExitCode.BadData, "is an unfinished export. Run the same export command again");
    }

    private CliRun Run(string[] arguments) =>
        CliRun.Of([
            .. arguments.Select(word =>
                word switch
                {
                    "SESSION" => Session,
                    "OUT" => _folder.PathOf("out"),
                    _ => word,
                }
            ),
        ]);
}
