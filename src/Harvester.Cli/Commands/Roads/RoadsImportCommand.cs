using System.CommandLine;
using Harvester.Cli.Terminals;
using Harvester.Datasets.Roads;
using Harvester.Datasets.Roads.Sources;

namespace Harvester.Cli.Commands.Roads;

/// <summary>harvester roads import: road data of any known form into the project's own.</summary>
internal static class RoadsImportCommand
{
    public static Command Create(Terminal terminal)
    {
        Argument<string> from = RoadSourceArgument.Create();
        Option<LanesIn> lanesIn = RoadSourceArgument.LanesIn();
        Option<string> output = RoadSourceArgument.Output("File to write; gzip-compressed if it ends in .gz");
        var command = new Command("import", "Convert road data to the CSV format of this project.") { from, lanesIn, output };
        command.SetAction(parsed =>
        {
            RoadImport import = RoadSourceArgument.Import(parsed, from, lanesIn, terminal);
            string file = parsed.GetRequiredValue(output);
            RoadWriter.Write(import.Network, file);
            terminal.Out.WriteLine($"{file}: {Counted.Of(import.Network.Nodes.Count, "node")}, {Counted.Of(import.Network.Links.Count, "link")}, from {import.Format}");
            return ExitCode.Done;
        });
        return command;
    }
}
