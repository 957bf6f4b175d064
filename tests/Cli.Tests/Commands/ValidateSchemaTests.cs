using System.Text.Json.Nodes;
using Harvester.Cli.Terminals;

namespace Harvester.Cli.Tests.Commands;

/// <summary>What commands write has the fields of docs/schema and no others.</summary>
public sealed class ValidateSchemaTests(SmallSession small) : IClassFixture<SmallSession>
{
    [Fact]
    public void Validate_schema_accepts_a_harvest() => AssertConforms(small.Folder);

    [Fact]
    [Trait("Category", "Heavy")]
    public void Validate_schema_accepts_other_options_of_a_harvest()
    {
        using var folder = new TemporaryFolder();
        string session = folder.PathOf("session");
        Assert.Equal(
            ExitCode.Done,
            CliRun
                .Of(
                    "harvest",
                    "--out",
                    session,
                    "--frames",
                    "2",
                    "--seed",
                    "3",
                    "--size",
                    "80x60",
                    "--no-report",
                    "--no-scenes",
                    "--image-format",
                    "jpg",
                    "--freeze",
                    "auto",
                    "--k1",
                    "-0.05",
                    "--near",
                    "0,0",
                    "--quirks",
                    "lag=2"
                )
                .ExitCode
        );

        AssertConforms(session);
    }

    [Fact]
    public void Validate_schema_accepts_what_other_commands_write()
    {
        using var folder = new TemporaryFolder();
        string relabelled = folder.PathOf("relabelled");
        string repaired = folder.PathOf("repaired");
        Assert.Equal(ExitCode.Done, CliRun.Of("relabel", small.Folder, "--out", relabelled, "--range", "60").ExitCode);
        Assert.Equal(ExitCode.Done, CliRun.Of("repair", small.Folder, "--out", repaired).ExitCode);

        AssertConforms(relabelled);
        AssertConforms(repaired);
    }

    [Theory]
    [InlineData("objects/0", "extra", "1", "schema: objects/0/extra: the field is unknown.")]
    [InlineData("", "extra", "{}", "schema: extra: the field is unknown.")]
    [InlineData("camera/distortion", "k3", "0", "schema: camera/distortion/k3: the field is unknown.")]
    public void Validate_schema_names_an_unknown_field(string place, string field, string value, string problem)
    {
        using var folder = new TemporaryFolder();
        string session = folder.PathOf("session");
        Assert.Equal(ExitCode.Done, CliRun.Of("relabel", small.Folder, "--out", session).ExitCode);
        string labels = Path.Combine(session, "labels.jsonl");
        string[] lines = File.ReadAllLines(labels);
        JsonNode line = JsonNode.Parse(lines[1])!;
        JsonNode inner = place
            .Split('/', StringSplitOptions.RemoveEmptyEntries)
            .Aggregate(line, (node, name) => int.TryParse(name, out int index) ? node[index]! : node[name]!);
        inner[field] = JsonNode.Parse(value);
        File.WriteAllText(labels, lines[0] + "\n" + line.ToJsonString() + "\n");

        CliRun run = CliRun.Of("validate", session, "--schema", "--quick");

        Assert.Equal(ExitCode.BadData, run.ExitCode);
        Assert.Contains($"labels.jsonl, line 2: {problem}\n", run.Out, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("\"frame\":1", "\"frame\":1e30", "schema: 1e30 is too large.")]
    [InlineData("\"frame\":1", "\"frame\":-1e999", "schema: -1e999 is too large.")]
    [InlineData("\"frame\":1", "\"frame\":1,\"frame\":1", "an object in it has a duplicate field.")]
    [InlineData("\"frame\":1", "\"frame\":\"\\ud800\"", "a string in it has an unpaired surrogate, which is not valid Unicode.")]
    public void Validate_schema_reports_what_it_cannot_evaluate(string from, string to, string problem)
    {
        using var folder = new TemporaryFolder();
        string session = folder.PathOf("session");
        Assert.Equal(ExitCode.Done, CliRun.Of("relabel", small.Folder, "--out", session).ExitCode);
        string labels = Path.Combine(session, "labels.jsonl");
        string text = File.ReadAllText(labels);
        Assert.Contains(from, text, StringComparison.Ordinal);
        File.WriteAllText(labels, text.Replace(from, to, StringComparison.Ordinal));

        CliRun run = CliRun.Of("validate", session, "--schema", "--quick");

        Assert.Equal(ExitCode.BadData, run.ExitCode);
        Assert.Contains($"labels.jsonl, line 2: {problem}\n", run.Out, StringComparison.Ordinal);
    }

    private static void AssertConforms(string session)
    {
        CliRun run = CliRun.Of("validate", session, "--schema");

        Assert.Equal(ExitCode.Done, run.ExitCode);
        Assert.EndsWith(", no problems\n", run.Out, StringComparison.Ordinal);
    }
}
