namespace Harvester.Geometry.Roads;

/// <summary>
/// One direction of a link as an explanation of where a car is, with what it costs to believe it: by the place and heading of the car
/// alone, and with the road that it came by. The overshoot is how far the car is past the link's end, metres, or before its start,
/// negative; 0 abreast of it.
/// </summary>
internal readonly record struct RoadCandidate(
    int Link, bool IsForward, double Parameter, LaneSection Section, double LeftEdge, double Offset, double HeadingError, double Overshoot,
        double CostOfPlace, double Cost);
