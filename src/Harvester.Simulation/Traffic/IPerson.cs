using Harvester.Geometry;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Models;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Traffic;

/// <summary>A person on foot.</summary>
internal interface IPerson
{
    int Handle { get; }

    Model Model { get; }

    /// <summary>The mesh of the current posture.</summary>
    Mesh Look { get; }

    /// <summary>The joints of the current posture, metres, world.</summary>
    Skeleton Skeleton { get; }

    Pose Pose { get; }

    Footprint Footprint { get; }

    /// <summary>Metres per second, world.</summary>
    Vector3D Velocity { get; }
}
