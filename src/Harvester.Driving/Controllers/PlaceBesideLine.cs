using Harvester.Geometry.Lanes;

namespace Harvester.Driving.Controllers;

/// <summary>
/// Lateral distance of the car and its lane from the road's line, and its effect in bends. Angles are measured at a distance along the
/// line; on the outside of a bend the car drives a longer distance than the line, and on the inside a shorter one.
/// </summary>
internal sealed class PlaceBesideLine
{
    /// <summary>Minimum ratio of the car's distance to that along the line, however sharp the bend.</summary>
    private const double MinOfLine = 0.4;
    private const double MaxOfLine = 2;

    private double _carRightOfLine;
    private double _laneRightOfLine;

    /// <summary>
    /// Adds a frame. The leftmost visible marking of the car's direction is used as the line. On a road with two directions it is the line,
    /// except for half of the median; on a one-way road the line is in the middle of the lanes, but such roads have few sharp bends.
    /// </summary>
    public void Observe(LaneIndicators at)
    {
        if (at.ToMarkingML.IsValid && at.ToMarkingMR.IsValid)
        {
            _carRightOfLine = -(at.ToMarkingLL.IsValid ? at.ToMarkingLL : at.ToMarkingML).Value;
            _laneRightOfLine = _carRightOfLine + ((at.ToMarkingML.Value + at.ToMarkingMR.Value) / 2);
        }
        else if (at.ToMarkingM.IsValid)
        {
            _carRightOfLine = -(at.ToMarkingL.IsValid ? at.ToMarkingL : at.ToMarkingM).Value;
        }
    }

    /// <summary>Distance along the line for a distance driven, metres, where the line has a curvature, 1/m.</summary>
    public double AlongLine(double metres, double curvature) => metres / WayByLine(curvature, _carRightOfLine);

    /// <summary>
    /// Curvature of the middle of the lane where the line has a curvature, 1/m: the same turn over a longer or shorter distance.
    /// </summary>
    public double BendOfLane(double curvature) => curvature / WayByLine(curvature, _laneRightOfLine);

    // A circle of radius 1 / κ about a point to the left, driven on at the distance d to the right of it, is longer by 1 + κ d.
    private static double WayByLine(double curvature, double rightOfLine) =>
        Math.Max(MinOfLine, Math.Min(MaxOfLine, 1 + (curvature * rightOfLine)));
}
