using System.CommandLine;
using System.IO;
using Harvester.Cli.Arguments;
using Harvester.Datasets.Roads;
using Harvester.Geometry.Roads;

namespace Harvester.Cli.Commands.Roads;

/// <summary>harvester roads nodes: the node database of the thesis's Figure 22.</summary>
internal static class RoadsNodesCommand
{
    public static Command Create(Terminal terminal)
    {
        Argument<string> from = RoadSourceArgument.Create();
        Option<string> output = RoadSourceArgument.Output("Csv to write");
        Option<double> laneWidth = Width("--lane-width", "Width of a lane of an ordinary road", RoadGeometry.LaneWidth);
        Option<double> narrow = Width("--narrow-lane-width", "Width of a lane of a narrow road", RoadGeometry.NarrowLaneWidth);
        var command = new Command("nodes", "Write the node database: where the road lies at every node, for each direction.") { from, output, laneWidth, narrow };
        command.SetAction(parsed =>
        {
            RoadNetwork network = RoadSourceArgument.Import(parsed, from, terminal).Network;
            var database = new NodeDatabase(new RoadCurves(network), new LaneModel(network, parsed.GetValue(laneWidth), parsed.GetValue(narrow)));
            string file = parsed.GetRequiredValue(output);
            int count = 0;
            WholeFile.Write(file, stream =>
            {
                using var text = new StreamWriter(stream, leaveOpen: true);
                count = NodeDatabaseWriter.Write(database, text);
            });
            terminal.Out.WriteLine($"{file}: {count} entries of {network.Nodes.Count} nodes");
            return ExitCode.Done;
        });
        return command;
    }

    private static Option<double> Width(string name, string description, double fallback)
    {
        Option<double> option = ValueParsers.Number(name, "METRES", $"{description}, metres [default: {fallback:0.0}]", value => value is > 0 and < 50, "a width in metres above 0 and below 50");
        option.DefaultValueFactory = _ => fallback;
        return option;
    }
}
