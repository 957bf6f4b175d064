using Harvester.Capture.Surveys;
using Harvester.Geometry;
using Harvester.Geometry.Paint;
using Harvester.Geometry.Roads;
using Harvester.Runs.Faults;

namespace Harvester.Runs.Harvesting;

/// <summary>A survey of paint in the simulated game.</summary>
/// <param name="Plan">The stations.</param>
/// <param name="View">The camera.</param>
/// <param name="RangeMetres">Roads farther from the start than this are left out, metres.</param>
public sealed record SimulatedSurvey(StationPlan Plan, SurveyView View, double RangeMetres)
{
    /// <summary>Greatest range, metres: beyond it, the simulated game builds no roads.</summary>
    public const double MaxRangeMetres = 350;

    /// <summary>Plans a survey.</summary>
    /// <param name="network">The roads.</param>
    /// <param name="near">Its middle, metres, world.</param>
    /// <param name="view">The camera.</param>
    /// <param name="rangeMetres">Roads farther from the middle are left out, metres.</param>
    /// <exception cref="UsageException">No road lies there.</exception>
    public static SimulatedSurvey Of(RoadNetwork network, Vector2D near, SurveyView view, double rangeMetres)
    {
        ArgumentNullException.ThrowIfNull(view);
        var plan = StationPlan.Of(new PaintRoads(new RoadCurves(network)), view.Footprint, new SurveyArea([near], rangeMetres));
        return plan.Stations.Count > 0
            ? new SimulatedSurvey(plan, view, rangeMetres)
            : throw new UsageException(
                FormattableString.Invariant($"No road lies within {rangeMetres} m of {near.X}, {near.Y}; choose another --near or --range.")
            );
    }

    /// <summary>The middle of a network: the node that is nearest to the middle of its extent.</summary>
    /// <param name="network">The roads, with a node.</param>
    public static Vector2D MiddleOf(RoadNetwork network)
    {
        ArgumentNullException.ThrowIfNull(network);
        var middle = new Vector2D(
            (network.Nodes.Min(node => node.Position.X) + network.Nodes.Max(node => node.Position.X)) / 2,
            (network.Nodes.Min(node => node.Position.Y) + network.Nodes.Max(node => node.Position.Y)) / 2
        );
        return network.Nodes.Select(node => new Vector2D(node.Position.X, node.Position.Y)).MinBy(place => (place - middle).Length);
    }
}
