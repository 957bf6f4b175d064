using Harvester.Geometry;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Maps;
using Harvester.Geometry.Paint;
using Harvester.Geometry.Roads;

namespace Harvester.Capture.Ports;

/// <summary>Roads that are completely known from the start: those of a file, or of the simulated town.</summary>
public sealed class FixedRoads : IRoads
{
    private readonly KnownRoads _roads;

    /// <summary>Prepares a road network; a large one takes a moment.</summary>
    /// <param name="network">The road network, world frame, metres.</param>
    /// <param name="source">Their source, as a short camelCase word for the labels.</param>
    /// <param name="lookAhead">Where the indicators are measured; null for the thesis's ten metres.</param>
    /// <param name="laneWidth">Width of the lanes of an ordinary road, metres.</param>
    /// <param name="narrowLaneWidth">Width of the lanes of a narrow road, metres.</param>
    /// <param name="paint">The lines measured on these roads; null if none were.</param>
    public FixedRoads(
        RoadNetwork network,
        string source,
        LookAhead? lookAhead = null,
        double laneWidth = RoadGeometry.LaneWidth,
        double narrowLaneWidth = RoadGeometry.NarrowLaneWidth,
        PaintTable? paint = null
    )
    {
        if (network is null)
        {
            throw new ArgumentNullException(nameof(network));
        }

        var curves = new RoadCurves(network);
        var lanes = new LaneModel(network, laneWidth, narrowLaneWidth, paint is null ? null : PaintedSections.Of(paint, curves));
        var observer = new LaneObserver(curves, lanes, lookAhead);
        // Names follow from the roads alone: measured lines would move the ends of junctions.
        LaneModel unpainted = paint is null ? lanes : new LaneModel(network, laneWidth, narrowLaneWidth);
        _roads = new KnownRoads(observer, new Lazy<LaneMaps>(() => new LaneMaps(curves, unpainted)), source);
    }

    /// <inheritdoc/>
    public KnownRoads? Near(Vector3D position) => _roads;
}
