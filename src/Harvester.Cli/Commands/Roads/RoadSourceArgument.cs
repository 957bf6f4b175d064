using System.CommandLine;
using Harvester.Cli.Arguments;
using Harvester.Cli.Terminals;
using Harvester.Datasets.Roads;
using Harvester.Datasets.Roads.Sources;

namespace Harvester.Cli.Commands.Roads;

/// <summary>The arguments and options of commands that read road data, and the import itself.</summary>
internal static class RoadSourceArgument
{
    public static Argument<string> Create() => new("FROM") { Description = "Road data: a file, a folder or a zip archive" };

    /// <summary>Imports road data, and writes notes about skipped parts to standard error.</summary>
    public static RoadImport Import(ParseResult parsed, Argument<string> from, Option<LanesIn> lanesIn, Terminal terminal)
    {
        RoadImport import = RoadImporter.Import(parsed.GetRequiredValue(from), parsed.GetValue(lanesIn));
        foreach (string note in import.Notes)
        {
            terminal.Error.WriteLine($"Note: {note}");
        }

        return import;
    }

    public static Option<LanesIn> LanesIn() =>
        ValueParsers.Choice<LanesIn>(
            "--lanes-in",
            "Direction of the \"lanes in\" of paths.ipl and paths.xml: forward (from a link's first node to its second) or backward "
                + "[default: forward]"
        );

    public static Option<string> Output(string description) =>
        new("--out")
        {
            Description = description,
            HelpName = "FILE",
            Required = true,
        };

    /// <summary>The notes in the help of a command that reads road data.</summary>
    /// <param name="argument">The arguments, with a verb, such as "FROM is".</param>
    /// <param name="examples">Lines with commands.</param>
    public static string NotesWith(string argument, params string[] examples) =>
        $"{argument} a file, a folder or a zip archive, plain or gzip-compressed, with one of these: CodeWalker's *.ynd.xml,\n"
        + "paths.ipl, paths.xml, the JSON dump of nodes, or a CSV file from roads import or from the mod's survey. The format is detected\n"
        + "from the content; docs/roads.md describes each.\n\n"
        + $"{(examples.Length > 1 ? "Examples" : "Example")}:\n"
        + string.Join('\n', examples);
}
