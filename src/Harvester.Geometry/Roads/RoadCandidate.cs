using Harvester.Geometry.Lanes;

namespace Harvester.Geometry.Roads;

/// <summary>One direction of a link as an explanation of where a car is, with what it costs to believe it.</summary>
internal readonly record struct RoadCandidate(
    int Link, bool IsForward, double Parameter, LaneSection Section, double LeftEdge, double Offset, double HeadingError, double Cost);
