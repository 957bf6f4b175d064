using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Paint;

/// <summary>
/// The first metres of a road that leaves a junction, over one or more links. Distances are metres from the junction's node along the road,
/// offsets metres to the right, looking away from the junction.
/// </summary>
internal sealed class JunctionMouth
{
    private readonly PaintRoads _roads;
    private readonly IReadOnlyList<(int Link, bool IsForward, double Start)> _links;

    public JunctionMouth(PaintRoads roads, IReadOnlyList<(int Link, bool IsForward, double Start)> links, double length)
    {
        _roads = roads;
        _links = links;
        Length = length;
        RoadLink first = roads.Curves.Network.Links[links[0].Link];
        Node = roads.Curves.Network.Nodes[links[0].IsForward ? first.From : first.To].Position;
    }

    public double Length { get; }

    /// <summary>Where the junction's node lies.</summary>
    public Vector3D Node { get; }

    /// <summary>A place on the road, at the height of the road network.</summary>
    public Vector3D PlaceAt(double distance, double offset)
    {
        (RoadCurve curve, double station, bool isForward, _) = At(distance);
        return curve.PointBeside(curve.ParameterAt(station), isForward ? offset : -offset);
    }

    /// <summary>A function that gives the places across the road at a distance, which is cheaper than <see cref="PlaceAt"/> for
    /// each.</summary>
    public Func<double, Vector3D> Across(double distance)
    {
        (RoadCurve curve, double station, bool isForward, _) = At(distance);
        double parameter = curve.ParameterAt(station);
        return offset => curve.PointBeside(parameter, isForward ? offset : -offset);
    }

    /// <summary>How far the carriageway may reach at a distance.</summary>
    public (double Left, double Right) ReachAt(double distance)
    {
        (_, double station, bool isForward, int link) = At(distance);
        (float left, float right) = _roads.ReachAt(link, station);
        return isForward ? (left, right) : (-right, -left);
    }

    private (RoadCurve Curve, double Station, bool IsForward, int Link) At(double distance)
    {
        int i = _links.Count - 1;
        while (i > 0 && _links[i].Start > distance)
        {
            i--;
        }

        (int link, bool isForward, double start) = _links[i];
        RoadCurve curve = _roads.Curves.Of(link);
        return (curve, isForward ? distance - start : curve.Length - (distance - start), isForward, link);
    }
}
