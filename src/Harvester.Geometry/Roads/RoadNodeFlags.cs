namespace Harvester.Geometry.Roads;

/// <summary>The flags of a road node in the game's path data. Names follow Figure 16 of the thesis and the game's own tools.</summary>
[Flags]
public enum RoadNodeFlags
{
    /// <summary>No flag is set.</summary>
    None = 0,

    /// <summary>Traffic is switched off here.</summary>
    SwitchedOff = 1 << 0,

    /// <summary>On water.</summary>
    Water = 1 << 1,

    /// <summary>Part of a motorway, or of a low bridge over water.</summary>
    Highway = 1 << 2,

    /// <summary>Left out by route guidance.</summary>
    NoGps = 1 << 3,

    /// <summary>In a tunnel.</summary>
    Tunnel = 1 << 4,

    /// <summary>Turning left is forbidden.</summary>
    CannotGoLeft = 1 << 5,

    /// <summary>Only left turns are allowed.</summary>
    LeftTurnsOnly = 1 << 6,

    /// <summary>An unpaved road.</summary>
    OffRoad = 1 << 7,

    /// <summary>Turning right is forbidden.</summary>
    CannotGoRight = 1 << 8,

    /// <summary>No trucks or buses.</summary>
    NoBigVehicles = 1 << 9,

    /// <summary>Indicates keeping left.</summary>
    IndicateKeepLeft = 1 << 10,

    /// <summary>Indicates keeping right.</summary>
    IndicateKeepRight = 1 << 11,

    /// <summary>On a slip lane.</summary>
    SlipLane = 1 << 12,

    /// <summary>A junction of roads.</summary>
    Junction = 1 << 13,

    /// <summary>A stop line before a traffic light.</summary>
    TrafficLight = 1 << 14,

    /// <summary>A stop or give-way line.</summary>
    GiveWay = 1 << 15,

    /// <summary>A crossing for pedestrians.</summary>
    PedestrianCrossing = 1 << 16,

    /// <summary>A crossing where pedestrians do not wait for cars.</summary>
    PedestrianCrossingWithoutWait = 1 << 17,

    /// <summary>A crossing with assistance for pedestrians.</summary>
    PedestrianAssisted = 1 << 18,

    /// <summary>A parking space.</summary>
    Parking = 1 << 19,

    /// <summary>A place that requires caution.</summary>
    Caution = 1 << 20,

    /// <summary>For emergency services only.</summary>
    EmergencyOnly = 1 << 21,

    /// <summary>A junction of unpaved roads.</summary>
    OffRoadJunction = 1 << 22,

    /// <summary>On a road that leads nowhere else.</summary>
    DeadEnd = 1 << 23,
}
