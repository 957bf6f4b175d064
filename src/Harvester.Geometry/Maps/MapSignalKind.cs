namespace Harvester.Geometry.Maps;

/// <summary>What tells a lane's traffic to wait.</summary>
public enum MapSignalKind
{
    /// <summary>A traffic light.</summary>
    Light,

    /// <summary>A stop sign.</summary>
    StopSign,

    /// <summary>A sign to give way.</summary>
    GiveWay,
}
