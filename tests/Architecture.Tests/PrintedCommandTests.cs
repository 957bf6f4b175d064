using System.Text.RegularExpressions;

namespace Harvester.Architecture.Tests;

/// <summary>Commands that the docs and the help print can be run as printed in a clone: the files they read are there.</summary>
public sealed partial class PrintedCommandTests
{
    [Fact]
    public void Files_of_the_repository_in_commands_exist()
    {
        string[] sources =
        [
            .. Directory.EnumerateFiles(Repository.Root, "*.md"),
            .. Directory.EnumerateFiles(Path.Combine(Repository.Root, "docs"), "*.md", SearchOption.AllDirectories),
            .. Repository.SourcesOf("Harvester.Cli", "src"),
        ];
        string[] named =
        [
            .. sources.SelectMany(file => RepositoryFile().Matches(File.ReadAllText(file))).Select(match => match.Value).Distinct(),
        ];

        Assert.Contains("data/example-roads.csv", named);
        Assert.All(named, file => Assert.True(File.Exists(Path.Combine(Repository.Root, file)), file));
    }

    // data/NAME.EXTENSION or examples/... as a word of a command line that begins with harvester.
    [GeneratedRegex(@"(?<=^ *(?:\+ "" *)?harvester [^\n]* )(?:data|examples)/[\w/-]+(?:\.\w+)+", RegexOptions.Multiline)]
    private static partial Regex RepositoryFile();
}
