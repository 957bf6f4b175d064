using System.CommandLine;
using Harvester.Datasets.Roads;

namespace Harvester.Cli.Commands.Roads;

/// <summary>The argument that names road data, and the import that goes with it.</summary>
internal static class RoadSourceArgument
{
    public static Argument<string> Create() => new("FROM") { Description = "Road data: a file, folder or zip archive" };

    /// <summary>Imports, and tells on standard error what was left out.</summary>
    public static RoadImport Import(ParseResult parsed, Argument<string> from, Terminal terminal)
    {
        RoadImport import = RoadImporter.Import(parsed.GetRequiredValue(from));
        foreach (string note in import.Notes)
        {
            terminal.Error.WriteLine($"Note: {note}");
        }

        return import;
    }

    public static Option<string> Output(string description) =>
        new("--out") { Description = description, HelpName = "FILE", Required = true };
}
