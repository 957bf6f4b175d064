namespace Harvester.Datasets.Logs;

/// <summary>What a part of a log's map is.</summary>
internal enum LogFeatureKind
{
    /// <summary>The middle of a lane, in the direction of travel.</summary>
    Lane,

    /// <summary>A painted line.</summary>
    RoadLine,

    /// <summary>An edge of the road.</summary>
    RoadEdge,

    /// <summary>A stop sign, one point.</summary>
    StopSign,

    /// <summary>The outline of a pedestrian crossing.</summary>
    Crosswalk,

    /// <summary>The outline of a speed bump.</summary>
    SpeedBump,

    /// <summary>The outline of a driveway.</summary>
    Driveway,
}
