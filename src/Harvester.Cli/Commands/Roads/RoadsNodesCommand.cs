using System.CommandLine;
using Harvester.Cli.Arguments;
using Harvester.Cli.Terminals;
using Harvester.Datasets.Files;
using Harvester.Datasets.Roads;
using Harvester.Datasets.Roads.Sources;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Text;

namespace Harvester.Cli.Commands.Roads;

/// <summary>harvester roads nodes: writes the node database of Figure 22 of the thesis.</summary>
internal static class RoadsNodesCommand
{
    /// <summary>The example in the help.</summary>
    public const string Example = "  harvester roads nodes session/scenes/roads.csv --out nodes.csv";

    public static Command Create(Terminal terminal)
    {
        Argument<string> from = RoadSourceArgument.Create();
        Option<LanesIn> lanesIn = RoadSourceArgument.LanesIn();
        Option<string> output = RoadSourceArgument.Output("CSV file to write");
        Option<double> laneWidth = LaneOptions.LaneWidth();
        Option<double> narrow = LaneOptions.NarrowLaneWidth();
        var command = new Command("nodes", "Write the node database: the position of the road at every node, for each direction.")
        {
            from,
            lanesIn,
            output,
            laneWidth,
            narrow,
        };
        HelpWithNotes.AddTo(command, RoadSourceArgument.NotesWith("FROM is", Example));
        command.SetAction(parsed =>
        {
            RoadNetwork network = RoadSourceArgument.Import(parsed, from, lanesIn, terminal).Network;
            var database = new NodeDatabase(
                new RoadCurves(network),
                new LaneModel(network, parsed.GetValue(laneWidth), parsed.GetValue(narrow))
            );
            string file = parsed.GetRequiredValue(output);
            int count = 0;
            OutputFile.Write(
                file,
                stream =>
                {
                    using var text = new StreamWriter(stream, leaveOpen: true);
                    count = NodeDatabaseWriter.Write(database, text);
                }
            );
            terminal.Out.WriteLine($"{file}: {count} entries for {Counted.Of(network.Nodes.Count, "node")}");
            return ExitCode.Done;
        });
        return command;
    }
}
