using System.Collections.Generic;
using Harvester.Capture.Ports;
using Harvester.Geometry;

namespace Harvester.Play.Features;

/// <summary>What is asked of a game to draw boxes over it: single facts, so that each is asked for only as often as it changes.</summary>
public interface ISightReader
{
    /// <summary>The vehicle that carries the camera; 0 when it is not mounted.</summary>
    int MountedVehicle { get; }

    /// <summary>The pose of the camera of the picture that is rendered now.</summary>
    Pose CameraPose { get; }

    /// <summary>Its vertical field of view, degrees.</summary>
    double VerticalFovDegrees { get; }

    /// <summary>Distance of its near plane, metres.</summary>
    double NearClip { get; }

    /// <summary>Width divided by height of the window's picture.</summary>
    double WindowAspect { get; }

    /// <summary>
    /// The entities of a kind within a distance of a point that may be labelled: without the vehicle that carries the camera, and of props
    /// those with faces.
    /// </summary>
    /// <param name="kind">The kind.</param>
    /// <param name="centre">Metres, world.</param>
    /// <param name="range">Metres.</param>
    IReadOnlyList<int> Near(EntityKind kind, Vector3D centre, double range);

    /// <summary>What is known of an entity's model.</summary>
    /// <param name="kind">Its kind.</param>
    /// <param name="entity">Its handle.</param>
    ModelFacts FactsOf(EntityKind kind, int entity);

    /// <summary>Where an entity is now; null when it is gone, or when no rotation and scale make its matrix.</summary>
    ScaledPose? PlaceOf(int entity);

    /// <summary>Whether a ped is a person, and not the player.</summary>
    bool IsPerson(int ped);

    /// <summary>Whether a ped sits in a vehicle.</summary>
    bool IsInVehicle(int ped);
}
