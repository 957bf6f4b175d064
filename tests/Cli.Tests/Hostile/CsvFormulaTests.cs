using Harvester.Cli.Terminals;
using Harvester.Cli.Tests.Commands;

namespace Harvester.Cli.Tests.Hostile;

/// <summary>A table opened in a spreadsheet runs no formula from a session.</summary>
public sealed class CsvFormulaTests(SmallSession session) : IClassFixture<SmallSession>, IDisposable
{
    private readonly HostileSession _hostile = new(session);

    public void Dispose() => _hostile.Dispose();

    [Theory]
    [InlineData("=cmd|' /C calc'!A0")]
    [InlineData("+1")]
    [InlineData("-1")]
    [InlineData("@SUM(A1)")]
    [InlineData("\\t=1")]
    [InlineData("\\r=1")]
    public void Text_that_would_be_a_formula_begins_with_an_apostrophe(string text)
    {
        string labels = File.ReadAllText(_hostile.In("labels.jsonl"));
        string model = labels.Split("\"model\":\"", 3)[2].Split('"')[0];
        File.WriteAllText(
            _hostile.In("labels.jsonl"),
            labels
                .Replace($"\"model\":\"{model}\"", $"\"model\":\"{text}\"", StringComparison.Ordinal)
                .Replace("\"weather\":\"", $"\"weather\":\"{text}", StringComparison.Ordinal)
        );
        string tables = _hostile.PathOf("tables");

        Assert.Equal(ExitCode.Done, HostileSession.Run("export", _hostile.Folder, "--format", "csv", "--out", tables).ExitCode);

        string[] written = [.. (string[])["frames.csv", "objects.csv"]];
        string shown = text.Replace("\\t", "\t", StringComparison.Ordinal).Replace("\\r", " ", StringComparison.Ordinal);
        Assert.All(written, name => Assert.Contains("'" + shown, File.ReadAllText(Path.Combine(tables, name)), StringComparison.Ordinal));
        Assert.All(
            written.SelectMany(name => Fields(Path.Combine(tables, name))),
            field =>
                Assert.True(
                    field.Length == 0
                        || !"=+-@\t\r".Contains(field[0], StringComparison.Ordinal)
                        || double.TryParse(field, System.Globalization.CultureInfo.InvariantCulture, out _),
                    field
                )
        );
        Assert.Equal(ExitCode.Done, HostileSession.Run("validate", tables).ExitCode);
    }

    [Fact]
    public void Class_named_with_a_minus_gives_a_valid_dataset()
    {
        string tables = _hostile.PathOf("tables");
        Assert.Equal(
            ExitCode.Done,
            HostileSession.Run("export", _hostile.Folder, "--format", "csv", "--map", "car=-car", "--out", tables).ExitCode
        );

        CliRun check = HostileSession.Run("validate", tables);
        Assert.Equal((ExitCode.Done, ""), (check.ExitCode, check.Error));
    }

    private static IEnumerable<string> Fields(string table)
    {
        using var text = new StreamReader(table);
        using var csv = new CsvHelper.CsvParser(text, System.Globalization.CultureInfo.InvariantCulture);
        while (csv.Read())
        {
            foreach (string field in csv.Record!)
            {
                yield return field;
            }
        }
    }
}
