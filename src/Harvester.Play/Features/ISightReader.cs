using Harvester.Capture.Ports;
using Harvester.Geometry;

namespace Harvester.Play.Features;

/// <summary>What drawing boxes over a game reads from it: single values, so that each is read only as often as it changes.</summary>
public interface ISightReader
{
    /// <summary>The vehicle that carries the camera; 0 if it is not mounted.</summary>
    int MountedVehicle { get; }

    /// <summary>The pose of the camera of the current picture.</summary>
    Pose CameraPose { get; }

    /// <summary>Its vertical field of view, degrees.</summary>
    double VerticalFovDegrees { get; }

    /// <summary>Distance of its near plane, metres.</summary>
    double NearClip { get; }

    /// <summary>Width divided by height of the window's picture.</summary>
    double WindowAspect { get; }

    /// <summary>
    /// The entities of a kind within a distance of a point that may be labelled: without the vehicle that carries the camera, and only
    /// props with faces.
    /// </summary>
    /// <param name="kind">The kind.</param>
    /// <param name="centre">Metres, world.</param>
    /// <param name="range">Metres.</param>
    IReadOnlyList<int> Near(EntityKind kind, Vector3D centre, double range);

    /// <summary>The facts of an entity's model.</summary>
    /// <param name="kind">Its kind.</param>
    /// <param name="entity">Its handle.</param>
    ModelFacts FactsOf(EntityKind kind, int entity);

    /// <summary>The current pose of an entity; null if it no longer exists, or if no rotation and scale give its matrix.</summary>
    ScaledPose? PlaceOf(int entity);

    /// <summary>Whether a ped is a person other than the player.</summary>
    bool IsPerson(int ped);

    /// <summary>Whether a ped sits in a vehicle.</summary>
    bool IsInVehicle(int ped);
}
