using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Lanes;

/// <summary>One link of a stretch of road, in the direction of travel.</summary>
/// <param name="Link">Index of the link.</param>
/// <param name="IsForward">Whether the car drives it from its start to its end.</param>
/// <param name="Curve">Its centre line, from its start to its end.</param>
/// <param name="StartStation">Station at which the stretch enters it, metres along the road from the car; negative behind the car.</param>
/// <param name="Lanes">The lanes of all links; this one has some in the direction of travel.</param>
/// <param name="Junctions">How far junctions reach into it from its entry and from its exit, metres.</param>
public sealed record StretchPiece(
    int Link,
    bool IsForward,
    RoadCurve Curve,
    double StartStation,
    LaneModel Lanes,
    (double AtEntry, double AtExit) Junctions
)
{
    /// <summary>A median narrower than this is a painted divider, metres.</summary>
    private const double NoMedian = 0.05;

    /// <summary>Station at which the stretch leaves it, metres along the road from the car.</summary>
    public double EndStation => StartStation + Curve.Length;

    /// <summary>Whether a station of the stretch lies in a junction, where there are no lanes.</summary>
    public bool IsInJunction(double station) => station < StartStation + Junctions.AtEntry || station > EndStation - Junctions.AtExit;

    /// <summary>The curve's parameter at a station of the stretch.</summary>
    public double ParameterAt(double station) => Curve.ParameterAt(OnLink(station));

    /// <summary>The station of the stretch at a parameter of the curve.</summary>
    public double StationAt(double parameter)
    {
        double along = Curve.StationAt(parameter);
        return IsForward ? StartStation + along : EndStation - along;
    }

    /// <summary>Unit vector of the direction of travel on the ground.</summary>
    public Vector2D DirectionAt(double parameter)
    {
        Vector2D direction = Curve.DirectionAt(parameter);
        return IsForward ? direction : direction * -1;
    }

    /// <summary>Curvature, 1/metres; positive where the road turns left in the direction of travel.</summary>
    public double CurvatureAt(double parameter) => IsForward ? Curve.CurvatureAt(parameter) : -Curve.CurvatureAt(parameter);

    /// <summary>The point at an offset to the right of the centre line in the direction of travel, metres, world.</summary>
    public Vector3D PointBeside(double parameter, double offset) => Curve.PointBeside(parameter, IsForward ? offset : -offset);

    /// <summary>
    /// The lanes in the direction of travel at a station of the stretch, and the left edge of the leftmost of them, metres to the right of
    /// the centre line in the direction of travel.
    /// </summary>
    public (LaneSection Section, double LeftEdge) LanesAt(double station) => Lanes.LanesOf(Link, IsForward, OnLink(station))!.Value;

    /// <summary>
    /// The lanes of the other direction at a station of the stretch and the left edge of their leftmost lane (nearest the median), as seen
    /// in that direction; null for a one-way road.
    /// </summary>
    public (LaneSection Section, double LeftEdge)? OncomingAt(double station) => Lanes.LanesOf(Link, !IsForward, OnLink(station));

    /// <summary>Where the width of the lanes at a station of the stretch comes from.</summary>
    public LaneWidthSource WidthSourceAt(double station) => Lanes.WidthOf(Link, IsForward, OnLink(station)).Source;

    /// <summary>
    /// The boundaries of its lanes at a station of the stretch by number, with their offsets to the right of the centre line in the
    /// direction of travel.
    /// </summary>
    public IReadOnlyDictionary<int, double> BoundariesAt(double station)
    {
        var boundaries = new Dictionary<int, double>();
        (LaneSection section, double leftEdge) = LanesAt(station);
        for (int i = 0; i <= section.LaneCount; i++)
        {
            boundaries.Add(i, leftEdge + section.Edge(i));
        }

        if (OncomingAt(station) is { } oncoming)
        {
            // Offsets of the other direction have the opposite sign. Without a median its left edge is the boundary 0 already; the others
            // count down from -2, and a median's far edge is -1.
            bool hasMedian = leftEdge + oncoming.LeftEdge > NoMedian;
            for (int i = hasMedian ? 0 : 1; i <= oncoming.Section.LaneCount; i++)
            {
                boundaries.Add(-i - 1, -(oncoming.LeftEdge + oncoming.Section.Edge(i)));
            }
        }

        return boundaries;
    }

    /// <summary>The station on the link, metres from its start.</summary>
    private double OnLink(double station) => IsForward ? station - StartStation : EndStation - station;
}
