using Harvester.Geometry;

namespace Harvester.Play.Features;

/// <summary>The game's scripted cameras. Those of other mods are never touched.</summary>
public interface ICameras
{
    /// <summary>Why this game cannot attach a camera to a vehicle, in words for the player; null when it can.</summary>
    string? AttachingProblem { get; }

    /// <summary>Makes a camera that stands in the world.</summary>
    /// <param name="pose">Position (metres, world) and orientation.</param>
    /// <param name="verticalFovDegrees">Vertical field of view, degrees.</param>
    /// <returns>Its handle; 0 when the game makes none.</returns>
    int Make(Pose pose, double verticalFovDegrees);

    /// <summary>Lets a camera ride on a vehicle with its whole matrix.</summary>
    /// <param name="camera">The camera.</param>
    /// <param name="vehicle">The vehicle.</param>
    /// <param name="offset">From the vehicle's origin, in its frame, metres.</param>
    void Attach(int camera, int vehicle, Vector3D offset);

    /// <summary>Makes a camera's picture the one on the screen.</summary>
    void Show(int camera);

    /// <summary>Takes a camera out of the game, and gives the view back where the camera had it. One that is gone is no harm.</summary>
    void Remove(int camera);
}
