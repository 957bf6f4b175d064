namespace Harvester.Geometry.Roads;

/// <summary>
/// One direction of a link as a candidate for a car's road, with its cost: from position and heading of the car alone, and together with
/// the road followed before. The overshoot is how far the car is past the link's end, metres, or before its start (negative); 0 beside it.
/// </summary>
internal readonly record struct RoadCandidate(
    int Link,
    bool IsForward,
    double Parameter,
    LaneSection Section,
    double LeftEdge,
    double Offset,
    double HeadingError,
    double Overshoot,
    double CostOfPlace,
    double Cost
);
