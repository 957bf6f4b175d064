using Harvester.Geometry;

namespace Harvester.Datasets.Tests.Roads;

/// <summary>Where a car truly is: its lane, the lanes before and after on its way, and how far the ends of its link are.</summary>
internal sealed record DriveSample(
    Vector3D Position,
    double HeadingDegrees,
    DriveLane Here,
    DriveLane? Before,
    DriveLane? After,
    double FromStart,
    double ToEnd,
    bool IsNearJunction,
    bool IsFirst
);
