using System.CommandLine;
using System.IO;
using Harvester.Cli.Arguments;
using Harvester.Cli.Terminals;
using Harvester.Datasets.Roads;
using Harvester.Datasets.Roads.Sources;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Files;

namespace Harvester.Cli.Commands.Roads;

/// <summary>harvester roads nodes: the node database of the thesis's Figure 22.</summary>
internal static class RoadsNodesCommand
{
    public static Command Create(Terminal terminal)
    {
        Argument<string> from = RoadSourceArgument.Create();
        Option<LanesIn> lanesIn = RoadSourceArgument.LanesIn();
        Option<string> output = RoadSourceArgument.Output("CSV file to write");
        Option<double> laneWidth = LaneOptions.LaneWidth();
        Option<double> narrow = LaneOptions.NarrowLaneWidth();
        var command = new Command("nodes", "Write the node database: the position of the road at every node, for each direction.") { from,
            lanesIn, output, laneWidth, narrow };
        command.SetAction(parsed =>
        {
            RoadNetwork network = RoadSourceArgument.Import(parsed, from, lanesIn, terminal).Network;
            var database = new NodeDatabase(
                new RoadCurves(network), new LaneModel(network, parsed.GetValue(laneWidth), parsed.GetValue(narrow)));
            string file = parsed.GetRequiredValue(output);
            int count = 0;
            AtomicFile.Write(file, stream =>
            {
                using var text = new StreamWriter(stream, leaveOpen: true);
                count = NodeDatabaseWriter.Write(database, text);
            });
            terminal.Out.WriteLine($"{file}: {count} entries for {Counted.Of(network.Nodes.Count, "node")}");
            return ExitCode.Done;
        });
        return command;
    }
}
