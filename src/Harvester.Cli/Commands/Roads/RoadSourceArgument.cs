using System.CommandLine;
using Harvester.Cli.Terminals;
using Harvester.Datasets.Roads;
using Harvester.Datasets.Roads.Sources;

namespace Harvester.Cli.Commands.Roads;

/// <summary>The argument that names road data, and the import that goes with it.</summary>
internal static class RoadSourceArgument
{
    public static Argument<string> Create() => new("FROM") { Description = "Road data: a file, a folder or a zip archive" };

    /// <summary>Imports, and writes what was left out to standard error.</summary>
    public static RoadImport Import(ParseResult parsed, Argument<string> from, Option<LanesIn> lanesIn, Terminal terminal)
    {
        RoadImport import = RoadImporter.Import(parsed.GetRequiredValue(from), parsed.GetValue(lanesIn));
        foreach (string note in import.Notes)
        {
            terminal.Error.WriteLine($"Note: {note}");
        }

        return import;
    }

    public static Option<LanesIn> LanesIn() => new("--lanes-in")
    {
        Description = "Direction of the \"lanes in\" of paths.ipl and paths.xml: forward (from a link's first node to its second) or backward",
        HelpName = "forward|backward",
        DefaultValueFactory = static _ => Datasets.Roads.Sources.LanesIn.Forward,
    };

    public static Option<string> Output(string description) =>
        new("--out") { Description = description, HelpName = "FILE", Required = true };
}
