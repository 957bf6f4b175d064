using System.Text.Json.Nodes;
using Harvester.Cli.Terminals;
using Harvester.Cli.Tests.Repetition;
using Harvester.Datasets.Validation;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Scenes;
using Json.Schema;

namespace Harvester.Cli.Tests.Commands;

public sealed class ScenarioCommandTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    private string File1 => _folder.PathOf("s.json");

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Run_stages_a_labelled_session_that_is_valid()
    {
        File.WriteAllText(File1, WritingCommand.Scenario);
        string session = _folder.PathOf("out");

        CliRun.Of("scenario", "run", File1, "--out", session, "--hz", "2", "--size", "160x120", "--no-report").AssertDone();

        JsonNode record = JsonNode.Parse(File.ReadAllText(Path.Combine(session, "scenario.json")))!;
        Assert.Equal("b", (string?)record["events"]![0]!["event"]);
        int handle = (int)record["actors"]![0]!["handle"]!;
        JsonNode scene = JsonNode.Parse(File.ReadAllText(Path.Combine(session, "scenes", "00000001.json")))!;
        int id = (int)scene["entities"]!.AsArray().Single(entity => (int)entity!["handle"]! == handle)!["id"]!;
        Assert.Equal(ObjectClass.Car, new SessionReader(session).ReadLabels().First().Objects.Single(label => label.Id == id).Class);
        CliRun.Of("validate", session, "--schema").AssertDone();
        Assert.True(Schema().Evaluate(record["scenario"]).IsValid);
    }

    [Fact]
    public void Derived_sessions_keep_the_scenario_and_validate_guards_it()
    {
        File.WriteAllText(File1, WritingCommand.Scenario);
        string session = _folder.PathOf("out");
        CliRun.Of("scenario", "run", File1, "--out", session, "--hz", "2", "--size", "160x120", "--no-report").AssertDone();
        string[] parts = [_folder.PathOf("1"), _folder.PathOf("2")];

        CliRun.Of("relabel", session, "--out", parts[0], "--shard", "1/2").AssertDone();
        CliRun.Of("relabel", session, "--out", parts[1], "--shard", "2/2").AssertDone();
        CliRun.Of("merge", parts[0], parts[1], "--out", _folder.PathOf("merged")).AssertDone();
        CliRun.Of("repair", session, "--out", _folder.PathOf("repaired")).AssertDone();

        string record = Path.Combine(session, "scenario.json");
        Assert.All(
            (string[])[.. parts, _folder.PathOf("merged"), _folder.PathOf("repaired")],
            made => Assert.Equal(File.ReadAllBytes(record), File.ReadAllBytes(Path.Combine(made, "scenario.json")))
        );
        CliRun.Of("validate", _folder.PathOf("merged")).AssertDone();
        File.AppendAllText(record, " ");
        CliRun damaged = CliRun.Of("validate", session);
        Assert.Equal(ExitCode.BadData, damaged.ExitCode);
        Assert.Contains("scenario.json: it ", damaged.Out, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("""{"name":"p","kind":"k","actors":[]}""")]
    [InlineData("""{"name":"p","kind":"k","actors":[{"id":"a","type":"plane","start":{"metresAhead":1}}]}""")]
    [InlineData("""{"name":"p","kind":"k","actors":[{"id":"a","type":"vehicle","start":{"approach":"left"}}]}""")]
    [InlineData("""{"name":"p","kind":"k","actors":[{"id":"a","type":"vehicle","start":{"metresAhead":1}}],"end":{"seconds":0}}""")]
    public void Check_and_schema_refuse_the_same_scenarios(string text)
    {
        File.WriteAllText(File1, text);

        Assert.Equal(ExitCode.BadData, CliRun.Of("scenario", "check", File1).ExitCode);
        Assert.False(Schema().Evaluate(JsonNode.Parse(text)).IsValid);
    }

    [Fact]
    public void Place_without_what_is_needed_is_named()
    {
        File.WriteAllText(
            File1,
            WritingCommand.Scenario.Replace("\"metres\":30", "\"metres\":30,\"lanesLeft\":9", StringComparison.Ordinal)
        );

        CliRun
            .Of("scenario", "run", File1, "--out", _folder.PathOf("out"))
            .AssertFailed(ExitCode.Usage, "lanes are to the left of the ego's; 9 are needed");
    }

    [Fact]
    public void Show_prints_the_values_of_the_seed()
    {
        File.WriteAllText(File1, WritingCommand.Scenario);

        CliRun run = CliRun.Of("scenario", "show", File1, "--seed", "4");

        run.AssertDone();
        Assert.Contains("event b  a: brake at once", run.Out, StringComparison.Ordinal);
    }

    private static JsonSchema Schema()
    {
        using Stream stream = typeof(SchemaValidator).Assembly.GetManifestResourceStream("Harvester.Datasets.scenario.schema.json")!;
        using var reader = new StreamReader(stream);
        return JsonSchema.FromText(reader.ReadToEnd());
    }
}
