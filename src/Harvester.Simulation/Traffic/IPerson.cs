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

    /// <summary>Whether a vehicle has struck this person, who flies, slides or lies.</summary>
    bool IsThrown { get; }

    /// <summary>Lets a vehicle throw this person.</summary>
    /// <param name="clear">The way that clears the body of the vehicle, metres.</param>
    /// <param name="velocity">Velocity after the impact, m/s, world x and y.</param>
    /// <param name="groundAt">Height of the ground at a place, or the given height where it is unknown.</param>
    void Throw(Vector3D clear, Vector2D velocity, Func<Vector3D, double, double> groundAt);
}
