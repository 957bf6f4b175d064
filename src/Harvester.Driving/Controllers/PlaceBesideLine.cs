using System;
using Harvester.Geometry.Lanes;

namespace Harvester.Driving.Controllers;

/// <summary>
/// How far beside the road's line the car and its lane are, and what that makes of a bend. Angles are seen so many metres ahead along the
/// line; on the outside of a bend the car drives more metres than the line has, and less on the inside.
/// </summary>
internal sealed class PlaceBesideLine
{
    /// <summary>However sharp the bend, the way is not taken for shorter or longer than by these factors on the line.</summary>
    private const double MinOfLine = 0.4;
    private const double MaxOfLine = 2;

    private double _carRightOfLine;
    private double _laneRightOfLine;

    /// <summary>
    /// Takes a frame. The leftmost marking of the car's direction that is seen is taken for the line. On a road of two directions that is
    /// what it is, but for half of the median; on a one-way road the line is in the middle of the lanes, but those have few sharp bends.
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

    /// <summary>Metres along the line while the car drives so many, where the line bends so, 1/m.</summary>
    public double AlongLine(double metres, double curvature) => metres / WayByLine(curvature, _carRightOfLine);

    /// <summary>How the middle of the lane bends where the line bends so, 1/m: the same turn on a longer or shorter way.</summary>
    public double BendOfLane(double curvature) => curvature / WayByLine(curvature, _laneRightOfLine);

    private static double WayByLine(double curvature, double rightOfLine) =>
        Math.Max(MinOfLine, Math.Min(MaxOfLine, 1 + (curvature * rightOfLine)));
}
