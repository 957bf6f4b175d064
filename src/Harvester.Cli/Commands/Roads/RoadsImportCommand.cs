using System.CommandLine;
using Harvester.Cli.Terminals;
using Harvester.Datasets.Roads;
using Harvester.Datasets.Roads.Sources;
using Harvester.Sessions.Text;

namespace Harvester.Cli.Commands.Roads;

/// <summary>harvester roads import: converts road data of any supported format to the project's CSV format.</summary>
internal static class RoadsImportCommand
{
    /// <summary>The example in the help.</summary>
    public const string Example = "  harvester roads import exported-ynd/ --out roads.csv.gz";

    public static Command Create(Terminal terminal)
    {
        Argument<string> from = RoadSourceArgument.Create();
        Option<LanesIn> lanesIn = RoadSourceArgument.LanesIn();
        Option<string> output = RoadSourceArgument.Output("File to write; gzip-compressed if it ends in .gz");
        var command = new Command("import", "Convert road data to the CSV format of this project.") { from, lanesIn, output };
        HelpWithNotes.AddTo(command, RoadSourceArgument.NotesWith("FROM is", Example));
        command.SetAction(parsed =>
        {
            RoadImport import = RoadSourceArgument.Import(parsed, from, lanesIn, terminal);
            string file = parsed.GetRequiredValue(output);
            RoadWriter.Write(import.Network, file);
            string nodes = Counted.Of(import.Network.Nodes.Count, "node");
            string links = Counted.Of(import.Network.Links.Count, "link");
            terminal.Out.WriteLine($"{file}: {nodes}, {links}, from {import.Format}");
            return ExitCode.Done;
        });
        return command;
    }
}
